// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain_sign.hpp"

#include <cmath>
#include <map>

#include "twoscale/symbolic/exact_real.hpp"

namespace twoscale::analysis {

namespace {

// Does p take both signs on a grid of the domain? Floating point chooses the points only.
bool estimate_sign_change(const Polynomial& p, int m) {
  constexpr int steps = 6;
  const auto& names = p.variables();
  std::vector<Rational> values{3, 1};
  for (int i = 0; i < steps; ++i)
    values.emplace_back(static_cast<long>(1e6 * std::cos(std::acos(-1.0) * (i + 0.9) / steps / m)), 1000000L);
  bool negative = false, positive = false;
  std::vector<size_t> index(names.size());
  while (!(negative && positive)) {
    std::vector<std::pair<std::string, Rational>> at;
    for (size_t i = 0; i < names.size(); ++i) at.emplace_back(names[i], values[index[i]]);
    const int sign = p.evaluate(at).sign();
    negative = negative || sign < 0;
    positive = positive || sign > 0;
    size_t i = 0;
    while (i < index.size() && ++index[i] == values.size()) index[i++] = 0;
    if (i == index.size()) break;
  }
  return negative && positive;
}

}  // namespace

bool has_one_sign_beyond_cosine(const Polynomial& p, int m) {
  if (p.all_coefficients_nonnegative() || (-p).all_coefficients_nonnegative()) return true;
  if (m == 2) return false;
  const std::string cosine = "!";  // no name of a variable
  Polynomial shifted = p;
  for (const auto& v : p.variables())
    shifted = shifted.substitute(v, Polynomial::variable(v) + Polynomial::variable(cosine));
  const ExactReal value = ExactReal::apply(ExactReal::Function::cos, ExactReal(Rational(1, m)) * ExactReal::pi());
  std::map<std::vector<unsigned long>, ExactReal> coefficients;
  shifted.for_each_term([&](const Rational& c, std::span<const unsigned long> e) {
    std::vector<unsigned long> monomial;
    ExactReal term = c;
    for (size_t i = 0; i < e.size(); ++i)
      if (shifted.variables()[i] == cosine)
        term = term * value.pow(Rational(static_cast<long>(e[i])));
      else
        monomial.push_back(e[i]);
    auto& sum = coefficients.try_emplace(monomial, 0).first->second;
    sum = sum + term;
  });
  bool negative = false, positive = false;
  for (const auto& [monomial, c] : coefficients) {
    const Sign sign = c.sign();
    negative = negative || sign == Sign::negative || sign == Sign::unknown;
    positive = positive || sign == Sign::positive || sign == Sign::unknown;
  }
  return !(negative && positive);
}

std::vector<Polynomial> factors_to_list(const std::vector<std::pair<Polynomial, unsigned>>& factors, int m) {
  std::vector<Polynomial> listed, open;
  Polynomial rest = 1;
  for (const auto& [f, e] : factors) {
    if (has_one_sign_beyond_cosine(f, m)) continue;
    if (m == 2 || estimate_sign_change(f, m)) {
      listed.push_back(f);
    } else {
      open.push_back(f);
      rest *= f.pow(e);
    }
  }
  if (!has_one_sign_beyond_cosine(rest, m)) listed.insert(listed.end(), open.begin(), open.end());
  return listed;
}

}  // namespace twoscale::analysis
