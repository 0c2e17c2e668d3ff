// SPDX-License-Identifier: 0BSD
// Mask tables as constant arrays of GLSL, rounded to floats.
#include <charconv>
#include <limits>

#include "source.hpp"
#include "twoscale/kernels/error.hpp"
#include "twoscale/kernels/number_text.hpp"

namespace twoscale::kernels {
namespace {

constexpr std::string_view functions = R"(
// a^{[level]}_index, 0 outside the support; levels from @_levels on are the limit.
float @_coefficient(int level, int index)
{
    if (index < @_lowest || index > @_highest) return 0.0;
    return @_mask[clamp(level, 0, @_levels) * @_count + index - @_lowest];
}
)";

// The shortest decimal that reads back as the float nearest to `value`.
std::string float_text(double value) {
  const float rounded = static_cast<float>(value);
  if (!(rounded <= std::numeric_limits<float>::max() && rounded >= std::numeric_limits<float>::lowest()))
    throw Error(Error::Kind::bad_input, "a coefficient is beyond the floats of GLSL: " + shortest(value));
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, rounded);
  std::string text(buffer, error == std::errc() ? end : buffer);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

class GlslWriter final : public TableWriter {
 public:
  std::string_view name() const override { return "glsl"; }
  std::string_view suffix() const override { return "glsl"; }

  std::string write(const MaskTable& table, const TableOptions& options) const override {
    validate(table);
    const TableGrid grid = common_grid(table);
    const std::size_t levels = table.levels.size(), count = grid.value[0].size();
    const std::string name = identifier(options.prefix, table.scheme);
    std::string out =
        source::comment_lines(table, "// ",
                              {"Floats: the doubles of the table rounded to nearest, relative error 2^-24",
                               "GLSL 1.30, GLSL ES 3.00 or later; to be pasted after #version and precision"});
    out += "#ifndef " + name + "_table\n#define " + name + "_table\n\n";
    const auto constant = [&](const std::string& key, const std::string& value) {
      out += "const int " + name + "_" + key + " = " + value + ";\n";
    };
    constant("arity", std::to_string(table.arity));
    constant("levels", std::to_string(levels));
    constant("lowest", std::to_string(grid.lowest));
    constant("highest", std::to_string(grid.highest));
    constant("count", std::to_string(count));
    out += "const float " + name + "_p = " + source::shift_expression(table) + ";\n\n";
    out += "// Row k is the step k -> k+1, the last row the limit; a row of " + std::to_string(count) +
           " numbers begins with a_{lowest}.\n// " + source::operation_count(table) + "\n";
    const std::string type = "float[" + std::to_string(count * (levels + 1)) + "]";
    out += "const " + type + " " + name + "_mask = " + type + "(\n" +
           source::rows(levels, count, {"", "", ",", "// ", ""},
                        [&](std::size_t k, std::size_t s) { return float_text(grid.value[k][s]); }) +
           ");\n";
    return out + source::substituted(functions, name, name) + "\n#endif\n";
  }
};

}  // namespace

const TableWriter& glsl_table_writer() {
  static const GlslWriter writer;
  return writer;
}

}  // namespace twoscale::kernels
