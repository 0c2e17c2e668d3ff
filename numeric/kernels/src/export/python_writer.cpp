// SPDX-License-Identifier: 0BSD
// Mask tables as a Python module without dependencies, and filter banks as a module for PyWavelets.
#include "source.hpp"
#include "twoscale/kernels/error.hpp"

namespace twoscale::kernels {
namespace {

constexpr source::RowStyle row_style{"[", "]", ",", "# ", ""};

constexpr std::string_view functions = R"(

def coefficient(level, index):
    """a^{[level]}_index, 0 outside the support; levels from `levels` on are the limit."""
    if not lowest <= index <= highest:
        return 0.0
    return mask[min(max(level, 0), levels)][index - lowest]


def _point(level, points, i, wrap):
    terms = []
    for j in range(-((highest - i) // arity), (i - lowest) // arity + 1):
        weight = coefficient(level, i - arity * j)
        if weight != 0:
            terms.append(weight * points[j % len(points) if wrap else j])
    return sum(terms[1:], terms[0]) if terms else 0 * points[0]


def apply(level, points):
    """One step of a closed polygon: numbers, complex numbers or rows of a NumPy array; the first new point has index 0."""
    return [_point(level, points, i, True) for i in range(arity * len(points))]


def apply_open(level, points):
    """One step of an open polygon without any rule for its ends; the first new point has index highest + 1 - arity."""
    return [_point(level, points, i, False) for i in range(highest + 1 - arity, arity * len(points) + lowest)]
)";

class PythonWriter final : public TableWriter {
 public:
  std::string_view name() const override { return "python"; }
  std::string_view suffix() const override { return "py"; }

  std::string write(const MaskTable& table, const TableOptions&) const override {
    validate(table);
    const TableGrid grid = common_grid(table);
    const std::size_t levels = table.levels.size();
    std::string out = source::comment_lines(table, "# ");
    out +=
        "\"\"\"Masks of a subdivision scheme: mask[k][i - lowest] = a^{[k]}_i, apply(k, points) is the step "
        "k.\"\"\"\n\n";
    out += "arity = " + std::to_string(table.arity) + "\np = " + source::shift_ratio(table) + "\n";
    out += "levels = " + std::to_string(levels) + "\n";
    out += "lowest = " + std::to_string(grid.lowest) + "\nhighest = " + std::to_string(grid.highest) + "\n";
    out += "# Row k is the step k -> k+1, the last row the limit; a row begins with a_{lowest}.\n# " +
           source::operation_count(table) + "\nmask = [\n" +
           source::rows(levels, grid.value[0].size(), row_style,
                        [&](std::size_t k, std::size_t s) {
                          return source::literal(table, {}, grid.value[k][s], grid.text[k][s]);
                        }) +
           "]\n";
    if (source::has_long_digits(table))
      out += "# The same with all digits, for decimal.Decimal or mpmath.mpf.\nmask_text = [\n" +
             source::rows(levels, grid.value[0].size(), row_style,
                          [&](std::size_t k, std::size_t s) { return "\"" + grid.text[k][s] + "\""; }) +
             "]\n";
    return out + std::string(functions);
  }
};

constexpr std::string_view bank_functions = R"(

def filter_bank(k):
    """[dec_lo, dec_hi, rec_lo, rec_hi] of the step between level k and level k+1, as pywt.Wavelet takes it."""
    return filters[min(max(k, 0), levels)]


def wavelet(k, name="twoscale"):
    """The same as a pywt.Wavelet."""
    import pywt
    return pywt.Wavelet(name, filter_bank=filter_bank(k))
)";

class PyWaveletsWriter final : public TableWriter {
 public:
  std::string_view name() const override { return "pywavelets"; }
  std::string_view suffix() const override { return "py"; }

  std::string write(const MaskTable& table, const TableOptions&) const override {
    validate(table);
    if (table.filters.size() != table.levels.size() + 1)
      throw Error(Error::Kind::bad_input, "this table has no filter banks");
    const auto& first = table.filters[0].text;
    std::string out = source::comment_lines(
        table, "# ",
        {"Filters: dec_lo, dec_hi, rec_lo, rec_hi, as doubles; index origin 0, padded with zeros to "
         "one length n, so that the delay is n - 1",
         "rec_lo = a/sqrt(2), of sum sqrt(2) where a has sum 2; dec_lo = sqrt(2) times the dual "
         "low-pass filter, reversed; the dual is the shortest one; dec_hi and rec_hi belong to the "
         "wavelets"});
    out += "\"\"\"Filter banks of a subdivision scheme for PyWavelets: wavelet(k), level by level.\"\"\"\n\n";
    out += "levels = " + std::to_string(table.levels.size()) + "\n";
    out += "length = " + std::to_string(first[0].size()) + "\n";
    out += "# Entry k belongs to the step between level k and level k+1, the last one is the limit.\nfilters = [\n";
    for (std::size_t k = 0; k < table.filters.size(); ++k) {
      const bool limit = k == table.levels.size();
      out += std::string("    # ") + (limit ? "limit" : "k = " + std::to_string(k)) + "\n";
      for (std::size_t f = 0; f < 4; ++f) {
        std::string line;
        for (std::size_t s = 0; s < table.filters[k].text[f].size(); ++s)
          line += (s == 0 ? "" : ", ") +
                  source::literal(table, {}, table.filters[k].value[f][s], table.filters[k].text[f][s]);
        out += std::string(f == 0 ? "    [[" : "     [") + line + (f == 3 ? "]],\n" : "],\n");
      }
    }
    return out + "]\n" + std::string(bank_functions);
  }
};

}  // namespace

const TableWriter& python_table_writer() {
  static const PythonWriter writer;
  return writer;
}

const TableWriter& pywavelets_table_writer() {
  static const PyWaveletsWriter writer;
  return writer;
}

}  // namespace twoscale::kernels
