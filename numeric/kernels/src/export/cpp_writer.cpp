// SPDX-License-Identifier: 0BSD
// Mask tables as one C++20 header: constexpr arrays in a namespace, and a step templated on the real type.
#include "source.hpp"

namespace twoscale::kernels {
namespace {

constexpr std::string_view coefficient_double = R"(
/// a^{[level]}_index as a Real, 0 outside the support; levels from `levels` on are the limit.
template <class Real>
constexpr Real coefficient(int level, long index) {
  if (index < lowest || index > highest) return Real(0);
  const std::size_t row = static_cast<std::size_t>(level < 0 ? 0 : level < levels ? level : levels);
  return static_cast<Real>(mask[row][static_cast<std::size_t>(index - lowest)]);
}
)";

constexpr std::string_view coefficient_long = R"(
/// a^{[level]}_index as a Real, 0 outside the support; levels from `levels` on are the limit. A long double has all the
/// digits it can hold, any other Real is converted from double.
template <class Real>
constexpr Real coefficient(int level, long index) {
  if (index < lowest || index > highest) return Real(0);
  const std::size_t row = static_cast<std::size_t>(level < 0 ? 0 : level < levels ? level : levels);
  const std::size_t column = static_cast<std::size_t>(index - lowest);
  if constexpr (std::is_same_v<Real, long double>) return mask_long[row][column];
  else return static_cast<Real>(mask[row][column]);
}
)";

constexpr std::string_view functions = R"(
namespace detail {

constexpr long floor_div(long a, long b) { return a / b - (a % b != 0 && a < 0 ? 1 : 0); }

template <class Real>
constexpr void point(int level, const Real* in, long n, std::size_t dim, long i, Real* out) {
  for (std::size_t c = 0; c < dim; ++c) out[c] = Real(0);
  for (long j = -floor_div(highest - i, arity); j <= floor_div(i - lowest, arity); ++j) {
    const Real weight = coefficient<Real>(level, i - arity * j);
    const Real* from = in + static_cast<std::size_t>(j - n * floor_div(j, n)) * dim;
    for (std::size_t c = 0; c < dim; ++c) out[c] = out[c] + weight * from[c];
  }
}

}  // namespace detail

/// One step of a closed polygon: `in` holds n >= 1 points of dim components, one after the other; `out` gets arity*n
/// points, the first of index 0. The two do not overlap. Real needs +, * and a conversion from double.
template <class Real>
constexpr void apply(int level, const Real* in, std::size_t n, std::size_t dim, Real* out) {
  for (long i = 0; i < arity * static_cast<long>(n); ++i) {
    detail::point(level, in, static_cast<long>(n), dim, i, out + static_cast<std::size_t>(i) * dim);
  }
}

/// How many points an open polygon of n points determines; the first has index highest + 1 - arity.
constexpr std::size_t open_count(std::size_t n) {
  const long count = arity * static_cast<long>(n) + lowest - (highest + 1 - arity);
  return count > 0 ? static_cast<std::size_t>(count) : 0;
}

/// One step of an open polygon without any rule for its ends: `in` holds the points of index 0..n-1, `out` gets
/// open_count(n) points.
template <class Real>
constexpr void apply_open(int level, const Real* in, std::size_t n, std::size_t dim, Real* out) {
  for (std::size_t row = 0; row < open_count(n); ++row) {
    detail::point(level, in, static_cast<long>(n), dim, highest + 1 - arity + static_cast<long>(row), out + row * dim);
  }
}
)";

constexpr source::RowStyle row_style{"{{", "}}", ",", "/* ", " */"};

class CppWriter final : public TableWriter {
 public:
  std::string_view name() const override { return "cpp"; }
  std::string_view suffix() const override { return "hpp"; }

  std::string write(const MaskTable& table, const TableOptions& options) const override {
    validate(table);
    const std::string space = identifier(options.prefix, table.scheme);
    const std::string guard = source::upper_case(space) + "_HPP";
    const TableGrid grid = common_grid(table);
    const bool long_digits = source::has_long_digits(table);
    const std::string rows = std::to_string(grid.value.size());
    const std::string count = std::to_string(grid.highest - grid.lowest + 1);
    std::string out = source::comment_block(table);
    out += "#ifndef " + guard + "\n#define " + guard + "\n\n#include <array>\n#include <cstddef>\n";
    if (long_digits) out += "#include <type_traits>\n";
    out += "\nnamespace " + space + " {\n\n";
    out += "inline constexpr long arity = " + std::to_string(table.arity) + ";\n";
    out += "inline constexpr int levels = " + std::to_string(table.levels.size()) + ";\n";
    out += "inline constexpr long lowest = " + std::to_string(grid.lowest) + ";\n";
    out += "inline constexpr long highest = " + std::to_string(grid.highest) + ";\n";
    out += "inline constexpr double shift = " + source::shift_expression(table) + ";  // p\n\n";
    out += "/// Row k is the step k -> k+1, the last row the limit; the first entry of a row is a_{lowest}.\n/// " +
           source::operation_count(table) + "\n";
    out += "inline constexpr std::array<std::array<double, " + count + ">, " + rows + "> mask = {{\n" +
           source::rows(table, options, false, row_style) + "}};\n";
    if (long_digits) {
      out += "\ninline constexpr std::array<std::array<long double, " + count + ">, " + rows + "> mask_long = {{\n" +
             source::rows(table, options, true, row_style) + "}};\n";
    }
    out += long_digits ? coefficient_long : coefficient_double;
    out += functions;
    return out + "\n}  // namespace " + space + "\n\n#endif\n";
  }
};

}  // namespace

const TableWriter& cpp_table_writer() {
  static const CppWriter writer;
  return writer;
}

}  // namespace twoscale::kernels
