// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/check/root_bound.hpp"

#include <algorithm>

namespace twoscale::check {
namespace {

constexpr std::size_t most_parametric_degree = 16;

Polynomial sum(const Polynomial& a, const Polynomial& b, int factor, Meter& meter) {
  Polynomial result = a;
  add_scaled(result, b, factor, Monomial{}, meter);
  return result;
}

/// (sum a_k x^k at x = (u+1)/(u-1)) * (u-1)^n, from the constant term up.
std::vector<Polynomial> half_plane_form(const std::vector<Polynomial>& a, Meter& meter) {
  const std::size_t n = a.size() - 1;
  std::vector<Polynomial> result(n + 1);
  for (std::size_t k = 0; k <= n; ++k) {
    std::vector<Integer> weight{1};  // (u+1)^k (u-1)^{n-k}
    for (std::size_t i = 0; i < n; ++i) {
      std::vector<Integer> next(weight.size() + 1);
      for (std::size_t j = 0; j < weight.size(); ++j) {
        next[j + 1] += weight[j];
        next[j] += i < k ? weight[j] : Integer(-weight[j]);
      }
      weight = std::move(next);
    }
    meter.spend(20 * n * n);
    for (std::size_t j = 0; j <= n; ++j) add_scaled(result[j], a[k], weight[j], Monomial{}, meter);
  }
  return result;
}

/// The k-th Hurwitz determinant of sum h_j u^j: rows i, columns j = 0..k-1, entry h_{n-1-2j+i}. By minors of the first
/// rows: one for each set of columns.
Polynomial hurwitz(const std::vector<Polynomial>& h, std::size_t k, Meter& meter) {
  const long n = static_cast<long>(h.size()) - 1;
  std::vector<Polynomial> minors(std::size_t{1} << k);
  minors[0] = {{Monomial{}, Integer(1)}};
  for (std::size_t set = 1; set < minors.size(); ++set) {
    long row = -1;
    for (std::size_t j = 0; j < k; ++j) row += (set >> j & 1U) != 0 ? 1 : 0;
    int sign = 1;
    for (std::size_t j = k; j-- > 0;) {  // expansion along the last row, from its last column
      if ((set >> j & 1U) == 0) continue;
      const long index = n - 1 - 2 * static_cast<long>(j) + row;
      meter.spend(20);
      if (index >= 0 && index <= n) {
        const Polynomial part = product(h[static_cast<std::size_t>(index)], minors[set ^ (std::size_t{1} << j)], meter);
        add_scaled(minors[set], part, sign, Monomial{}, meter);
      }
      sign = -sign;
    }
    for (const auto& [monomial, coefficient] : minors[set]) meter.hold(128 + 8 * words(coefficient));
  }
  return minors.back();
}

}  // namespace

std::vector<Polynomial> root_coefficients(const Polynomial& p, std::size_t root, std::size_t variables,
                                          const Fraction& bound, Meter& meter) {
  const auto n = static_cast<std::size_t>(degrees(p)[root]);
  std::vector<Polynomial> a(n + 1);
  for (const auto& [monomial, coefficient] : p) {
    const auto k = static_cast<std::size_t>(monomial[root]);
    Monomial rest{};
    for (std::size_t j = 0, to = 0; j < variables; ++j) {
      if (j != root) rest[to++] = monomial[j];
    }
    const Integer scale = meter.multiply(meter.power(bound.numerator, k), meter.power(bound.denominator, n - k));
    add_term(a[k], rest, meter.multiply(coefficient, scale), meter);
  }
  return a;
}

std::vector<Polynomial> root_conditions(const std::vector<Polynomial>& a, Meter& meter) {
  const auto plus = [&](const Polynomial& p, const Polynomial& q) { return sum(p, q, 1, meter); };
  const auto minus = [&](const Polynomial& p, const Polynomial& q) { return sum(p, q, -1, meter); };
  const auto times = [&](const Polynomial& p, const Polynomial& q) { return product(p, q, meter); };
  switch (a.size()) {
    case 1: return {a[0]};
    case 2: return {minus(a[1], a[0]), plus(a[1], a[0])};
    case 3: return {minus(a[2], a[0]), plus(plus(a[2], a[0]), a[1]), minus(plus(a[2], a[0]), a[1])};
    case 4: {
      const Polynomial even = plus(a[2], a[0]), odd = plus(a[3], a[1]);
      const Polynomial first = minus(times(a[3], a[3]), times(a[0], a[0]));
      const Polynomial second = minus(times(a[3], a[1]), times(a[2], a[0]));
      return {plus(odd, even),  minus(odd, even),    minus(a[3], a[0]),
              plus(a[3], a[0]), plus(first, second), minus(first, second)};
    }
    default: break;
  }
  const std::size_t n = a.size() - 1;
  if (n > most_parametric_degree) throw Malformed("root-bound: degrees with parameters are at most 16");
  const std::vector<Polynomial> h = half_plane_form(a, meter);
  std::vector<Polynomial> result = h;
  for (std::size_t k = n - 1; k > 1; k -= 2) result.push_back(hurwitz(h, k, meter));
  return result;
}

bool schur_cohn(Dense a, Meter& meter) {
  if (a.empty() || a.back() == 0) return false;
  while (a.size() > 1) {
    const Integer low = a.front(), lead = a.back();
    if (abs(low) >= abs(lead)) return false;
    Dense next(a.size() - 1);  // (lead a(x) - low x^n a(1/x))/x
    for (std::size_t i = 0; i < next.size(); ++i) {
      next[i] = meter.multiply(lead, a[i + 1]) - meter.multiply(low, a[a.size() - 2 - i]);
    }
    a = primitive(std::move(next), meter);
  }
  return true;
}

}  // namespace twoscale::check
