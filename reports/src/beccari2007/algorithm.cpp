// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "twoscale/reports/beccari2007.hpp"

namespace twoscale::reports::beccari2007 {

namespace {

constexpr double tolerance = 1e-6;

bool same(double a, double b) { return std::abs(a - b) <= tolerance * (1 + std::abs(a) + std::abs(b)); }

}  // namespace

PrintedTension printed_tension(const std::vector<double>& points) {
  PrintedTension r;
  const long n = (static_cast<long>(points.size()) / 2 - 1) / 2;
  std::vector<double> weights;
  for (long j = 1; j <= n - 2; ++j) {
    // Componentwise: one equation for x, one for y; 0 = 0 says nothing.
    std::vector<double> solutions;
    for (int c = 0; c < 2; ++c) {
      const auto p = [&](long i) { return points[static_cast<std::size_t>(2 * i + c)]; };
      const double inner = (p(2 * j) + p(2 * j + 2)) / 2;
      const double bracket = inner - (p(2 * j - 2) + p(2 * j + 4)) / 2;
      const double left = p(2 * j + 1) - inner;
      if (std::abs(bracket) > tolerance)
        solutions.push_back(left / bracket);
      else if (std::abs(left) > tolerance)
        return {"(8) has no solution", 0, 0, 0};
    }
    if (solutions.empty()) continue;
    if (!same(solutions.front(), solutions.back())) return {"(8) has no solution", 0, 0, 0};
    weights.push_back(solutions[0]);
  }
  if (weights.empty()) return {"every w solves (8)", 0, 0, 0};
  for (const double w : weights)
    if (!same(w, weights[0])) return {"the weights differ", 0, 0, 0};
  r.w = weights[0];
  r.as_printed = std::sqrt(2 * r.w * (2 * r.w + 1)) / (4 * r.w) - 0.5;
  r.corrected = (std::sqrt(1 + 1 / r.w) - 1) / 2;
  return r;
}

}  // namespace twoscale::reports::beccari2007
