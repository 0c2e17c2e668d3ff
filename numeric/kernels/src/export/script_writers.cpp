// SPDX-License-Identifier: 0BSD
// Mask tables as a Julia module, a MATLAB and Octave script, and a TypeScript module.
#include "source.hpp"

namespace twoscale::kernels {
namespace {

constexpr source::RowStyle julia_style{"[", "]", ",", "# ", ""};

constexpr std::string_view julia_functions = R"(
"a^{[level]}_index, 0 outside the support; levels from `levels` on are the limit."
coefficient(level, index) =
    lowest <= index <= highest ? mask[clamp(level, 0, levels) + 1][index - lowest + 1] : 0.0

"""
One step of a closed polygon: a vector of numbers or of vectors. Points have indices from 0 in the rule; element 1 of
both vectors is the point 0.
"""
function apply(level, points)
    n = length(points)
    return map(0:(arity * n - 1)) do i
        sum(coefficient(level, i - arity * j) * points[mod(j, n) + 1]
            for j in cld(i - highest, arity):fld(i - lowest, arity))
    end
end
)";

class JuliaWriter final : public TableWriter {
 public:
  std::string_view name() const override { return "julia"; }
  std::string_view suffix() const override { return "jl"; }

  std::string write(const MaskTable& table, const TableOptions& options) const override {
    validate(table);
    const TableGrid grid = common_grid(table);
    const std::size_t levels = table.levels.size();
    std::string out = source::comment_lines(table, "# ");
    out += "module " + identifier(options.prefix, table.scheme) + "\n\n";
    out += "const arity = " + std::to_string(table.arity) + "\nconst p = " + source::shift_ratio(table) + "\n";
    out += "const levels = " + std::to_string(levels) + "\n";
    out += "const lowest = " + std::to_string(grid.lowest) + "\nconst highest = " + std::to_string(grid.highest) + "\n";
    out += "# Row k + 1 is the step k -> k+1, the last row the limit; a row begins with a_{lowest}.\n# " +
           source::operation_count(table) + "\nconst mask = [\n" +
           source::rows(levels, grid.value[0].size(), julia_style,
                        [&](std::size_t k, std::size_t s) {
                          return source::literal(table, {}, grid.value[k][s], grid.text[k][s]);
                        }) +
           "]\n";
    if (source::has_long_digits(table))
      out += "# The same with all digits: parse.(BigFloat, mask_text[1]).\nconst mask_text = [\n" +
             source::rows(levels, grid.value[0].size(), julia_style,
                          [&](std::size_t k, std::size_t s) { return "\"" + grid.text[k][s] + "\""; }) +
             "]\n";
    return out + std::string(julia_functions) + "\nend\n";
  }
};

class MatlabWriter final : public TableWriter {
 public:
  std::string_view name() const override { return "matlab"; }
  std::string_view suffix() const override { return "m"; }

  std::string write(const MaskTable& table, const TableOptions& options) const override {
    validate(table);
    const TableGrid grid = common_grid(table);
    const std::size_t levels = table.levels.size(), count = grid.value[0].size();
    const std::string name = identifier(options.prefix, table.scheme);
    const std::string size = std::to_string(count) + ", " + std::to_string(levels + 1) + ")";
    std::string out = source::comment_lines(table, "% ");
    out += name + " = struct();\n";
    const auto field = [&](const std::string& key, const std::string& value) {
      out += name + "." + key + " = " + value + ";\n";
    };
    field("arity", std::to_string(table.arity));
    field("p", source::shift_ratio(table));
    field("levels", std::to_string(levels));
    field("lowest", std::to_string(grid.lowest));
    field("highest", std::to_string(grid.highest));
    out += "% Column k + 1 is the step k -> k+1, the last column the limit; a column begins with a_{lowest}.\n";
    out += "% ttoolboxes: getS('a', " + name + ".mask(:, end), 'M', " + name + ".arity).\n";
    field("mask", "zeros(" + size);
    const auto columns = [&](const std::string& key, const std::string& open, const std::string& close,
                             const auto& item) {
      for (std::size_t k = 0; k <= levels; ++k) {
        out += k == levels ? "% limit\n" : "% k = " + std::to_string(k) + "\n";
        out += name + "." + key + "(:, " + std::to_string(k + 1) + ") = " + open + "\n";
        for (std::size_t s = 0; s < count; ++s) out += "  " + item(k, s) + "\n";
        out += close + ";\n";
      }
    };
    columns("mask", "[", "]", [&](std::size_t k, std::size_t s) {
      return source::literal(table, {}, grid.value[k][s], grid.text[k][s]);
    });
    if (source::has_long_digits(table)) {
      out += "% The same with all digits, for vpa.\n";
      field("text", "cell(" + size);
      columns("text", "{", "}", [&](std::size_t k, std::size_t s) { return "'" + grid.text[k][s] + "'"; });
    }
    return out;
  }
};

constexpr source::RowStyle typescript_style{"[", "]", ",", "// ", ""};

constexpr std::string_view typescript_functions = R"(
/** a^{[level]}_index, 0 outside the support; levels from `levels` on are the limit. */
export function coefficient(level: number, index: number): number {
  if (index < lowest || index > highest) return 0;
  return mask[Math.min(Math.max(level, 0), levels)][index - lowest];
}

/** The new points of j are weights of the old ones j - radius, ..., j + radius. */
export const radius: number = Math.max(-Math.ceil((0 - highest) / arity), Math.floor((arity - 1 - lowest) / arity), 0);

/**
 * Weights of the new points arity*j, arity*j + 1, ... (for arity 2: the even and the odd one), arrays of 2*radius + 1
 * numbers each, as the kernels of thi.ng/geom-subdiv take them.
 */
export function stencils(level: number): number[][] {
  const list: number[][] = [];
  for (let s = 0; s < arity; ++s) {
    const weights: number[] = [];
    for (let h = -radius; h <= radius; ++h) weights.push(coefficient(level, s - arity * h));
    list.push(weights);
  }
  return list;
}

/** One step of a closed polygon of points with any number of components; the first new point has index 0. */
export function apply(level: number, points: readonly (readonly number[])[]): number[][] {
  const rules = stencils(level);
  const n = points.length;
  const out: number[][] = [];
  for (let j = 0; j < n; ++j) {
    for (const weights of rules) {
      const point = points[j].map(() => 0);
      for (let h = -radius; h <= radius; ++h) {
        const from = points[(((j + h) % n) + n) % n];
        for (let c = 0; c < point.length; ++c) point[c] += weights[h + radius] * from[c];
      }
      out.push(point);
    }
  }
  return out;
}
)";

class TypeScriptWriter final : public TableWriter {
 public:
  std::string_view name() const override { return "typescript"; }
  std::string_view suffix() const override { return "ts"; }

  std::string write(const MaskTable& table, const TableOptions&) const override {
    validate(table);
    const TableGrid grid = common_grid(table);
    const std::size_t levels = table.levels.size();
    std::string out = source::comment_lines(table, "// ") + "\n";
    const auto constant = [&](const std::string& key, const std::string& value) {
      out += "export const " + key + ": number = " + value + ";\n";
    };
    constant("arity", std::to_string(table.arity));
    constant("p", source::shift_ratio(table));
    constant("levels", std::to_string(levels));
    constant("lowest", std::to_string(grid.lowest));
    constant("highest", std::to_string(grid.highest));
    out += "\n/**\n * Row k is the step k -> k+1, the last row the limit; a row begins with a_{lowest}.\n * " +
           source::operation_count(table) + "\n */\nexport const mask: readonly (readonly number[])[] = [\n" +
           source::rows(levels, grid.value[0].size(), typescript_style,
                        [&](std::size_t k, std::size_t s) {
                          return source::literal(table, {}, grid.value[k][s], grid.text[k][s]);
                        }) +
           "];\n";
    return out + std::string(typescript_functions);
  }
};

}  // namespace

const TableWriter& julia_table_writer() {
  static const JuliaWriter writer;
  return writer;
}

const TableWriter& matlab_table_writer() {
  static const MatlabWriter writer;
  return writer;
}

const TableWriter& typescript_table_writer() {
  static const TypeScriptWriter writer;
  return writer;
}

}  // namespace twoscale::kernels
