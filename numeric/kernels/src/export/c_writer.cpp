// SPDX-License-Identifier: 0BSD
// Mask tables as one C99 file that can be included or compiled, with no dependency but <stddef.h>.
#include "source.hpp"

namespace twoscale::kernels {
namespace {

// @ is the prefix, $ the prefix in capitals.
constexpr std::string_view prototypes = R"(
/* a^{[level]}_index, 0 outside the support; levels from $_LEVELS on are the limit. */
static inline double @_coefficient(int level, long index);

/* One step of a closed polygon: `in` holds n >= 1 points of dim components, one after the other; `out` gets
   $_ARITY*n points, the first of index 0. The two do not overlap. */
static inline void @_apply(int level, const double *in, size_t n, size_t dim, double *out);

/* One step of an open polygon without any rule for its ends: `in` holds the points of index 0..n-1, `out` gets the
   points that they determine, the first of index $_HIGHEST + 1 - $_ARITY. Returns their number; `out` may be NULL. */
static inline size_t @_apply_open(int level, const double *in, size_t n, size_t dim, double *out);
)";

constexpr std::string_view functions = R"(
static inline double @_coefficient(int level, long index)
{
    const int row = level < 0 ? 0 : level < $_LEVELS ? level : $_LEVELS;
    return index < $_LOWEST || index > $_HIGHEST ? 0.0 : @_mask[row][index - ($_LOWEST)];
}

static inline long @_floor_div(long a, long b)
{
    return a / b - (a % b != 0 && a < 0);
}

static inline void @_point(const double *mask, const double *in, long n, size_t dim, long i, double *out)
{
    const long first = -@_floor_div($_HIGHEST - i, $_ARITY);
    const long last = @_floor_div(i - ($_LOWEST), $_ARITY);
    long j;
    size_t c;
    for (c = 0; c < dim; ++c) out[c] = 0.0;
    for (j = first; j <= last; ++j) {
        const double weight = mask[i - $_ARITY * j - ($_LOWEST)];
        const double *from = in + (size_t)(j - n * @_floor_div(j, n)) * dim;
        if (weight == 0.0) continue;
        for (c = 0; c < dim; ++c) out[c] += weight * from[c];
    }
}

static inline void @_apply(int level, const double *in, size_t n, size_t dim, double *out)
{
    const double *mask = @_mask[level < 0 ? 0 : level < $_LEVELS ? level : $_LEVELS];
    long i;
    for (i = 0; i < $_ARITY * (long)n; ++i) {
        @_point(mask, in, (long)n, dim, i, out + (size_t)i * dim);
    }
}

static inline size_t @_apply_open(int level, const double *in, size_t n, size_t dim, double *out)
{
    const double *mask = @_mask[level < 0 ? 0 : level < $_LEVELS ? level : $_LEVELS];
    const long first = $_HIGHEST + 1 - $_ARITY;
    const long end = $_ARITY * (long)n + ($_LOWEST);
    long i;
    if (end <= first) return 0;
    if (out != NULL) {
        for (i = first; i < end; ++i) @_point(mask, in, (long)n, dim, i, out + (size_t)(i - first) * dim);
    }
    return (size_t)(end - first);
}
)";

constexpr std::string_view long_coefficient = R"(
/* The same with all digits of the table. */
static inline long double @_coefficient_long(int level, long index)
{
    const int row = level < 0 ? 0 : level < $_LEVELS ? level : $_LEVELS;
    return index < $_LOWEST || index > $_HIGHEST ? 0.0L : @_mask_long[row][index - ($_LOWEST)];
}
)";

std::string number(long value) {
  const std::string text = std::to_string(value);
  return value < 0 ? std::string("(") + text + ")" : text;
}

constexpr source::RowStyle row_style{"{", "}", ",", "/* ", " */"};

class CWriter final : public TableWriter {
 public:
  std::string_view name() const override { return "c"; }
  std::string_view suffix() const override { return "c"; }

  std::string write(const MaskTable& table, const TableOptions& options) const override {
    validate(table);
    const std::string lower = identifier(options.prefix, table.scheme);
    const std::string upper = source::upper_case(lower);
    const TableGrid grid = common_grid(table);
    const auto replaced = [&](std::string_view text) { return source::substituted(text, lower, upper); };
    std::string out = source::comment_block(table);
    out += replaced("#ifndef $_TABLE\n#define $_TABLE\n\n#include <stddef.h>\n\n");
    out += replaced("#define $_ARITY ") + std::to_string(table.arity) + "\n";
    out += replaced("#define $_LEVELS ") + std::to_string(table.levels.size()) + "\n";
    out += replaced("#define $_LOWEST ") + number(grid.lowest) + "\n";
    out += replaced("#define $_HIGHEST ") + number(grid.highest) + "\n";
    out += replaced("#define $_COUNT ") + std::to_string(grid.highest - grid.lowest + 1) + "\n";
    out += replaced("#define $_P ") + source::shift_expression(table) + "\n";
    out += replaced(prototypes);
    out += "\n/* Row k is the step k -> k+1, the last row the limit; the first entry of a row is a_{lowest}.\n   " +
           source::operation_count(table) + " */\n";
    out += replaced("static const double @_mask[$_LEVELS + 1][$_COUNT] = {\n") +
           source::rows(table, options, false, row_style) + "};\n";
    if (source::has_long_digits(table)) {
      out += replaced("\nstatic const long double @_mask_long[$_LEVELS + 1][$_COUNT] = {\n") +
             source::rows(table, options, true, row_style) + "};\n" + replaced(long_coefficient);
    }
    return out + replaced(functions) + "\n#endif\n";
  }
};

}  // namespace

const TableWriter& c_table_writer() {
  static const CWriter writer;
  return writer;
}

}  // namespace twoscale::kernels
