// SPDX-License-Identifier: 0BSD
// The refinement of a closed polygon as a sparse matrix: the four arrays of a stencil table as OpenSubdiv takes it (C
// and C++), and the Matrix Market coordinate format.
#include "source.hpp"
#include "twoscale/kernels/export/refinement_matrix.hpp"
#include "twoscale/kernels/number_text.hpp"

namespace twoscale::kernels {
namespace {

std::vector<std::string> facts(const MaskTable& table, const RefinementMatrix& matrix) {
  return {"Matrix: the new points are the matrix times the " + std::to_string(matrix.points) +
              " points of a closed polygon, after all " + std::to_string(table.levels.size()) +
              " steps of the table; " + std::to_string(matrix.sizes.size()) +
              " rows, new point i belongs to the parameter (i + p)/" + std::to_string(table.arity) + "^" +
              std::to_string(table.levels.size()),
          "Weights: doubles; the errors of a row add up to at most " + matrix.error};
}

template <class Item>
std::string list(std::size_t count, const Item& item) {
  constexpr std::size_t width = 100;
  std::string out, line = "   ";
  for (std::size_t i = 0; i < count; ++i) {
    const std::string text = item(i) + (i + 1 < count ? "," : "");
    if (line.size() + 1 + text.size() > width) {
      out += line + "\n";
      line = "   ";
    }
    line += " " + text;
  }
  return out + line + "\n";
}

constexpr std::string_view apply = R"(
/* out = matrix * in; points of dim components, one after the other. */
static inline void @_apply(const double *in, size_t dim, double *out)
{
    size_t i, c;
    int e;
    for (i = 0; i < $_ROWS; ++i) {
        for (c = 0; c < dim; ++c) {
            double sum = 0.0;
            for (e = @_offsets[i]; e < @_offsets[i] + @_sizes[i]; ++e)
                sum += @_weights[e] * in[(size_t)@_indices[e] * dim + c];
            out[i * dim + c] = sum;
        }
    }
}
)";

class StencilWriter final : public TableWriter {
 public:
  std::string_view name() const override { return "stencil"; }
  std::string_view suffix() const override { return "h"; }

  std::string write(const MaskTable& table, const TableOptions& options) const override {
    validate(table);
    const RefinementMatrix matrix = refinement_matrix(table, options.points);
    const std::string lower = identifier(options.prefix, table.scheme);
    const std::string upper = source::upper_case(lower);
    const auto replaced = [&](std::string_view text) { return source::substituted(text, lower, upper); };
    std::string out = "/*\n" + source::comment_lines(table, " * ", facts(table, matrix)) + " *\n";
    out += replaced(
        " * OpenSubdiv: Osd::CpuEvaluator::EvalStencils(..., @_sizes, @_offsets, @_indices, weights, 0, $_ROWS), "
        "weights: the\n"
        " * numbers of @_weights as floats; the same arrays make a Far::StencilTable.\n */\n");
    out += replaced("#ifndef $_STENCIL\n#define $_STENCIL\n\n#include <stddef.h>\n\n");
    const std::size_t rows = matrix.sizes.size(), entries = matrix.indices.size();
    out += replaced("#define $_POINTS ") + std::to_string(matrix.points) + "\n";
    out += replaced("#define $_ROWS ") + std::to_string(rows) + "\n";
    out += replaced("#define $_ENTRIES ") + std::to_string(entries) + "\n";
    const auto integers = [&](std::string_view head, const std::vector<int>& values) {
      out += replaced(head) + list(values.size(), [&](std::size_t i) { return std::to_string(values[i]); }) + "};\n";
    };
    integers("\n/* Number of weights of each row. */\nstatic const int @_sizes[$_ROWS] = {\n", matrix.sizes);
    integers("\n/* Where they begin. */\nstatic const int @_offsets[$_ROWS] = {\n", matrix.offsets);
    integers("\n/* Points of the polygon, from 0. */\nstatic const int @_indices[$_ENTRIES] = {\n", matrix.indices);
    out += replaced("\nstatic const double @_weights[$_ENTRIES] = {\n") +
           list(entries,
                [&](std::size_t i) {
                  return options.hex_float ? hex_float(matrix.weights[i]) : source::decimal(matrix.weights[i]);
                }) +
           "};\n";
    return out + replaced(apply) + "\n#endif\n";
  }
};

class MatrixMarketWriter final : public TableWriter {
 public:
  std::string_view name() const override { return "matrixmarket"; }
  std::string_view suffix() const override { return "mtx"; }

  std::string write(const MaskTable& table, const TableOptions& options) const override {
    validate(table);
    const RefinementMatrix matrix = refinement_matrix(table, options.points);
    std::string out = "%%MatrixMarket matrix coordinate real general\n";
    out += source::comment_lines(table, "% ", facts(table, matrix));
    out += "% Entries: row, column, weight; both are counted from 1\n";
    out += std::to_string(matrix.sizes.size()) + " " + std::to_string(matrix.points) + " " +
           std::to_string(matrix.indices.size()) + "\n";
    for (std::size_t i = 0; i < matrix.sizes.size(); ++i)
      for (int e = matrix.offsets[i]; e < matrix.offsets[i] + matrix.sizes[i]; ++e) {
        const std::size_t at = static_cast<std::size_t>(e);
        out += std::to_string(i + 1) + " " + std::to_string(matrix.indices[at] + 1) + " " +
               shortest(matrix.weights[at]) + "\n";
      }
    return out;
  }
};

}  // namespace

const TableWriter& stencil_table_writer() {
  static const StencilWriter writer;
  return writer;
}

const TableWriter& matrixmarket_table_writer() {
  static const MatrixMarketWriter writer;
  return writer;
}

}  // namespace twoscale::kernels
