// SPDX-License-Identifier: GPL-3.0-or-later
/// What the tests of the symbolic room share: the exact meaning of masks at rational points, by definitions only.
///
/// At a point every level variable v has a rational E = e^{theta/m^{k+1}} with v = (E + 1/E)/2, so that x^r e^{n theta
/// x} has rational values at all multiples of the fine spacing: i^r E^{ni} at the index i.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "twoscale/symbolic/laurent.hpp"
#include "twoscale/symbolic/space.hpp"

namespace twoscale::tests {

using Values = std::vector<std::pair<std::string, Rational>>;
using Matrix = std::vector<std::vector<Rational>>;

/// E for each level variable of a space: distinct, not 1, multiplicatively independent for small exponents.
inline std::vector<Rational> exponential_points(const Space& space, size_t variant = 0) {
  static const std::vector<Rational> choices = {Rational(2), Rational(3, 5), Rational(7, 3), Rational(5, 11),
                                                Rational(13, 4)};
  std::vector<Rational> e;
  for (size_t i = 0; i < space.variables().size(); ++i) e.push_back(choices[(i + variant) % choices.size()]);
  return e;
}

inline Values level_values(const Space& space, const std::vector<Rational>& e) {
  Values at;
  for (size_t i = 0; i < e.size(); ++i)
    at.emplace_back(space.variables()[i].name, (e[i] + e[i].inverse()) / Rational(2));
  return at;
}

/// One function x^r e^{theta x}: base = e^{theta/m^{k+1}}, power = r.
struct Function {
  Rational base;
  long power;
  /// Its value at x = i/m^{k+1}, in units in which that spacing is 1.
  Rational operator()(long i) const { return Rational(i).pow(power) * base.pow(i); }
};

inline std::vector<Function> basis(const Space& space, const std::vector<Rational>& e) {
  std::vector<Function> list;
  for (unsigned r = 0; r < space.polynomial_order(); ++r) list.push_back({Rational(1), static_cast<long>(r)});
  for (const auto& x : space.exponentials())
    for (unsigned r = 0; r < x.order; ++r)
      for (const long sign : {1L, -1L})
        list.push_back({e[x.variable].pow(sign * static_cast<long>(x.multiple)), static_cast<long>(r)});
  return list;
}

/// The mask at a point: index -> value. nullopt at a pole.
inline std::optional<std::map<long, Rational>> mask_at(const Laurent& a, const Values& at) {
  std::map<long, Rational> mask;
  for (long i = a.lowest(); i <= a.highest(); ++i) {
    const auto value = a.coefficient(i).evaluate(at);
    if (!value) return std::nullopt;
    mask[i] = *value;
  }
  return mask;
}

/// f^{k+1}_i from f^k_j = f at x = m j: sum_j a_{i-mj} f(m j).
inline Rational refined(const std::map<long, Rational>& mask, long m, const Function& f, long i) {
  Rational sum;
  for (const auto& [index, value] : mask)
    if ((i - index) % m == 0) sum += value * f(i - index);
  return sum;
}

/// Determinant by Gaussian elimination; with right sides in further columns, these become the solution if it is not 0.
inline Rational eliminate(Matrix& a) {
  const size_t n = a.size();
  Rational determinant = 1;
  for (size_t k = 0; k < n; ++k) {
    size_t pivot = k;
    while (pivot < n && a[pivot][k].is_zero()) ++pivot;
    if (pivot == n) return 0;
    if (pivot != k) {
      std::swap(a[pivot], a[k]);
      determinant = -determinant;
    }
    const Rational p = a[k][k];
    determinant *= p;
    for (auto& x : a[k]) x /= p;
    for (size_t i = 0; i < n; ++i) {
      if (i == k || a[i][k].is_zero()) continue;
      const Rational factor = a[i][k];
      for (size_t j = k; j < a[i].size(); ++j) a[i][j] -= factor * a[k][j];
    }
  }
  return determinant;
}

inline Matrix values(const std::vector<std::vector<RationalFunction>>& matrix, const Values& at) {
  Matrix m;
  for (const auto& row : matrix) {
    m.emplace_back();
    for (const auto& x : row) m.back().push_back(x.evaluate(at).value());
  }
  return m;
}

/// The definition of the 2l-point interpolating scheme: the weights c_j, j = 1-l..l, with sum_j c_j f(j) = f(1/2) for
/// every f in the space. No symbol, no sigma. nullopt if they are not unique.
inline std::optional<std::vector<Rational>> interpolation_weights(const Space& space, const std::vector<Rational>& e) {
  const std::vector<Function> functions = basis(space, e);
  const long l = static_cast<long>(functions.size()) / 2;
  Matrix a;
  for (const Function& f : functions) {
    a.emplace_back();
    for (long j = 1 - l; j <= l; ++j) a.back().push_back(f(2 * j));
    a.back().push_back(f(1));
  }
  if (eliminate(a).is_zero()) return std::nullopt;
  std::vector<Rational> c;
  for (const auto& row : a) c.push_back(row.back());
  return c;
}

}  // namespace twoscale::tests
