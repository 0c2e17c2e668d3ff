// SPDX-License-Identifier: 0BSD
// What every reader of a MaskTable relies on.
#include "twoscale/kernels/mask_table.hpp"

#include <cmath>

#include "twoscale/kernels/error.hpp"
#include "twoscale/kernels/number_text.hpp"
#include "twoscale/kernels/refine.hpp"

namespace twoscale::kernels {
namespace {

constexpr long max_index = 1'000'000;

[[noreturn]] void reject(const MaskTable& table, const std::string& what) {
  throw Error(Error::Kind::bad_input, "mask table of " + quoted(table.scheme) + ": " + what);
}

void check_numbers(const MaskTable& table, const std::string& where, const std::vector<std::string>& text,
                   const std::vector<double>& value) {
  for (const std::string& t : text) {
    if (!is_decimal(t)) reject(table, where + ": not a decimal: " + quoted(t));
  }
  for (const double v : value) {
    if (!std::isfinite(v)) reject(table, where + ": a coefficient is not finite");
  }
}

void check_row(const MaskTable& table, const std::string& where, const MaskRow& row) {
  if (row.value.empty()) reject(table, where + " has no coefficients");
  if (row.text.size() != row.value.size()) reject(table, where + ": texts and values differ in number");
  if (!row.extension_text.empty() && row.extension_text.size() != row.extension.size()) {
    reject(table, where + ": extension texts and values differ in number");
  }
  if (row.lowest < -max_index || row.lowest > max_index || row.value.size() > static_cast<std::size_t>(max_index)) {
    reject(table, where + ": indices beyond " + std::to_string(max_index));
  }
  check_numbers(table, where, row.text, row.value);
  check_numbers(table, where + " (extension)", row.extension_text, row.extension);
}

void check_filters(const MaskTable& table, const FilterRow& row) {
  const std::size_t length = table.filters[0].text[0].size();
  for (std::size_t f = 0; f < 4; ++f) {
    if (length == 0 || row.text[f].size() != length || row.value[f].size() != length)
      reject(table, "filters must not be empty and must have one length");
    check_numbers(table, "filters", row.text[f], row.value[f]);
  }
}

}  // namespace

void validate(const MaskTable& table) {
  if (table.arity < 2 || table.arity > 1000)
    reject(table, "arity " + std::to_string(table.arity) + " is not in 2..1000");
  if (table.digits < 0) reject(table, "digits " + std::to_string(table.digits) + " is negative");
  parse_shift(table.shift);
  for (std::size_t k = 0; k < table.levels.size(); ++k) check_row(table, "level " + std::to_string(k), table.levels[k]);
  check_row(table, "limit", table.limit);
  if (!table.filters.empty() && table.filters.size() != table.levels.size() + 1)
    reject(table, "filter banks must be those of all levels and of the limit");
  for (const FilterRow& row : table.filters) check_filters(table, row);
}

}  // namespace twoscale::kernels
