// SPDX-License-Identifier: 0BSD
#include "twoscale/kernels/export/refinement_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "twoscale/kernels/error.hpp"
#include "twoscale/kernels/number_text.hpp"
#include "twoscale/kernels/refine.hpp"

namespace twoscale::kernels {

RefinementMatrix refinement_matrix(const MaskTable& table, long points) {
  constexpr double most_entries = 1 << 24;
  validate(table);
  if (table.levels.empty())
    throw Error(Error::Kind::bad_input, "a refinement matrix needs at least one level of the table");
  if (points < 3)
    throw Error(Error::Kind::bad_input, "a closed polygon has at least 3 points, not " + std::to_string(points));
  const long m = table.arity;
  const auto floor_div = [](long a, long b) { return a / b - (a % b != 0 && a < 0 ? 1 : 0); };
  // Rows 0..period-1 on the line; row i + period*q is row i moved by q.
  std::vector<std::map<long, double>> rows = {{{0, 1.0}}};
  double norm = 1, error = 0;  // of rows: sum of sizes, sum of errors
  constexpr double u = 0x1p-53;
  for (const MaskRow& mask : table.levels) {
    const long period = static_cast<long>(rows.size());
    if (static_cast<double>(period) * static_cast<double>(m) * static_cast<double>(points) > most_entries)
      throw Error(Error::Kind::bad_input, "the refinement matrix would be too large");
    std::vector<std::map<long, double>> next(static_cast<std::size_t>(period * m));
    std::vector<double> sums(static_cast<std::size_t>(m));
    for (std::size_t s = 0; s < mask.value.size(); ++s) {
      const long i = mask.lowest + static_cast<long>(s);
      sums[static_cast<std::size_t>(i - m * floor_div(i, m))] += std::abs(mask.value[s]);
    }
    for (long i = 0; i < period * m; ++i) {
      auto& row = next[static_cast<std::size_t>(i)];
      for (long j = -floor_div(mask.highest() - i, m); j <= floor_div(i - mask.lowest, m); ++j) {
        const double weight = mask.value[static_cast<std::size_t>(i - m * j - mask.lowest)];
        if (weight == 0) continue;
        const long q = floor_div(j, period);
        for (const auto& [column, value] : rows[static_cast<std::size_t>(j - period * q)])
          row[column + q] += weight * value;
      }
    }
    rows = std::move(next);
    // Each weight is off by u, and so are the products and the sums of at most this many terms.
    const double terms = static_cast<double>(mask.value.size()) / static_cast<double>(m) + 1;
    const double largest = *std::max_element(sums.begin(), sums.end());
    error = largest * (error + (terms + 2) * u * norm * 1.01);
    norm *= largest;
  }
  RefinementMatrix result;
  result.points = points;
  result.error = shortest(table.levels.size() == 1 ? norm * u : error);
  const long period = static_cast<long>(rows.size());
  std::map<long, double> wrapped;
  for (long i = 0; i < period * points; ++i) {
    wrapped.clear();
    for (const auto& [column, value] : rows[static_cast<std::size_t>(i % period)]) {
      const long at = column + i / period;
      wrapped[at - points * floor_div(at, points)] += value;
    }
    if (static_cast<double>(result.indices.size() + wrapped.size()) > most_entries)
      throw Error(Error::Kind::bad_input, "the refinement matrix would be too large");
    result.offsets.push_back(static_cast<int>(result.indices.size()));
    for (const auto& [column, value] : wrapped) {
      result.indices.push_back(static_cast<int>(column));
      result.weights.push_back(value);
    }
    result.sizes.push_back(static_cast<int>(result.indices.size()) - result.offsets.back());
  }
  return result;
}

}  // namespace twoscale::kernels
