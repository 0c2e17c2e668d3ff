// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/symbolic/symbol.hpp"

#include <algorithm>
#include <map>

#include "twoscale/symbolic/error.hpp"

namespace twoscale {

namespace {

const Rational one = 1;

Polynomial node_polynomial(const Space& space, const Node& n) {
  return n.multiple == 0 ? Polynomial(1) : Polynomial::chebyshev(space.variables()[n.variable].name, n.multiple);
}

// Completes a factored form by the rational content that makes it equal to `value` (both have the same zeros).
FactoredPolynomial with_content_of(const Polynomial& value, RationalFunction::Factors factors) {
  FactoredPolynomial r{one, std::move(factors)};
  std::vector<std::pair<std::string, Rational>> at;  // v = 2, 3, ...: larger than every zero cos(..)
  for (const auto& name : value.variables()) at.emplace_back(name, Rational(static_cast<long>(at.size()) + 2));
  Rational product = 1;
  for (const auto& [f, e] : r.factors) product *= f.evaluate(at).pow(static_cast<long>(e));
  r.content = value.evaluate(at) / product;
  return r;
}

// The divisors d of E^n + 1: d | 2n, d not dividing n.
void divisors_of_plus_one(unsigned n, std::map<unsigned, unsigned>& count) {
  for (unsigned d = 1; d <= 2 * n; ++d)
    if ((2 * n) % d == 0 && n % d != 0) ++count[d];
}

}  // namespace

Polynomial FactoredPolynomial::expanded() const {
  Polynomial p = Polynomial::constant(content.numerator());
  for (const auto& [f, e] : factors) p *= f.pow(e);
  return p;
}

void FactoredPolynomial::multiply(const FactoredPolynomial& o) {
  content *= o.content;
  for (const auto& [f, e] : o.factors) {
    const auto at = std::lower_bound(factors.begin(), factors.end(), f, [](const auto& a, const Polynomial& b) {
      return Polynomial::compare(a.first, b) < 0;
    });
    if (at != factors.end() && at->first == f)
      at->second += e;
    else
      factors.insert(at, {f, e});
  }
}

FactoredPolynomial sum_of_nodes(const Space& space, const Node& a, const Node& b) {
  const Polynomial value = node_polynomial(space, a) + node_polynomial(space, b);
  if (value.is_constant()) return {value.constant_value(), {}};
  if (value.total_degree() == 1) {  // a positive multiple of v, 1 + v or v_s + v_t
    const Rational content = value.content();
    return {content, {{Polynomial::exact_quotient(value, Polynomial::constant(content.numerator())), 1}}};
  }
  const bool same = a.multiple == 0 || b.multiple == 0 || a.variable == b.variable;
  if (!same) {
    auto f = value.factor();
    return {f.content, std::move(f.factors)};
  }
  const std::string& name = space.variables()[a.multiple == 0 ? b.variable : a.variable].name;
  const unsigned sum = a.multiple + b.multiple;
  const unsigned difference = a.multiple > b.multiple ? a.multiple - b.multiple : b.multiple - a.multiple;
  std::map<unsigned, unsigned> count;
  divisors_of_plus_one(sum, count);
  if (difference > 0) divisors_of_plus_one(difference, count);
  RationalFunction::Factors factors;
  for (const auto& [d, e] : count) {
    // (E + 1)^2 = 2 E (1 + v): two factors Phi_2 make one v + 1; every other Phi_d is one minimal polynomial.
    const unsigned exponent = d == 2 ? e / 2 : e;
    if (exponent > 0) factors.emplace_back(Polynomial::cosine_minimal(name, d), exponent);
  }
  std::sort(factors.begin(), factors.end(),
            [](const auto& x, const auto& y) { return Polynomial::compare(x.first, y.first) < 0; });
  return with_content_of(value, std::move(factors));
}

FactoredPolynomial chebyshev_difference(const Space& space, const Node& a, const Node& b, int arity) {
  const auto m = static_cast<unsigned>(arity);
  const Polynomial x = node_polynomial(space, a);
  const Polynomial y = node_polynomial(space, b);
  const auto chebyshev_at = [&](const Node& n, const Polynomial& w) {
    return n.multiple == 0 ? w : Polynomial::chebyshev(space.variables()[n.variable].name, m * n.multiple);
  };
  const Polynomial value = x == y ? Polynomial::chebyshev("x", m).derivative("x").substitute("x", x)
                                  : Polynomial::exact_quotient(chebyshev_at(a, x) - chebyshev_at(b, y), x - y);
  if (value.is_constant()) return {value.constant_value(), {}};
  if (a.multiple != 0 && b.multiple != 0 && a.variable != b.variable) {
    auto f = value.factor();
    return {f.content, std::move(f.factors)};
  }
  const std::string& name = space.variables()[a.multiple == 0 ? b.variable : a.variable].name;
  std::map<unsigned, unsigned> count;
  for (const unsigned n :
       {a.multiple + b.multiple, std::max(a.multiple, b.multiple) - std::min(a.multiple, b.multiple)})
    for (unsigned d = 1; n > 0 && d <= m * n; ++d)
      if ((m * n) % d == 0 && n % d != 0) ++count[d];
  RationalFunction::Factors factors;
  for (const auto& [d, e] : count)  // two factors Phi_2 make one v + 1
    if (const unsigned exponent = d == 2 ? e / 2 : e; exponent > 0)
      factors.emplace_back(Polynomial::cosine_minimal(name, d), exponent);
  std::sort(factors.begin(), factors.end(),
            [](const auto& p, const auto& q) { return Polynomial::compare(p.first, q.first) < 0; });
  return with_content_of(value, std::move(factors));
}

Laurent centred(const Laurent& a) {
  if (a.is_zero()) return a;
  const long length = a.highest() - a.lowest();
  return a.shifted(-(length / 2) - a.lowest());
}

Laurent bspline_symbol(const Space& space, int arity) {
  if (arity < 2 || arity > 64) bad_input("arity must be between 2 and 64", std::to_string(arity));
  const long m = arity;
  // S_m(E z) S_m(z/E) for E + 1/E = 2 w, w = T_n(v): coefficient of z^j is sum_{a+b=j} E^{a-b} = sum of T_{|a-b|}(w).
  const auto pair_factor = [&](const Node& n) {
    std::vector<Polynomial> c(static_cast<size_t>(2 * m - 1));
    for (long j = 0; j <= 2 * m - 2; ++j)
      for (long b = std::max(0L, j - m + 1); b <= std::min(j, m - 1); ++b)
        c[static_cast<size_t>(j)] +=
            n.multiple == 0 ? Polynomial(1)
                            : Polynomial::chebyshev(space.variables()[n.variable].name,
                                                    static_cast<unsigned>(std::abs(j - 2 * b)) * n.multiple);
    return c;
  };
  std::vector<Polynomial> product{Polynomial(1)};
  const auto multiply = [&](const std::vector<Polynomial>& f) {
    std::vector<Polynomial> r(product.size() + f.size() - 1);
    for (size_t i = 0; i < product.size(); ++i)
      for (size_t j = 0; j < f.size(); ++j) r[i + j] += product[i] * f[j];
    product = std::move(r);
  };
  FactoredPolynomial normalisation;  // prod of the factors at z = 1
  for (const Node& n : nodes(space)) {
    const auto f = pair_factor(n);
    multiply(f);
    normalisation.multiply(chebyshev_difference(space, n, Node{0, 0}, arity));
  }
  if (space.polynomial_order() % 2 == 1) {
    multiply(std::vector<Polynomial>(static_cast<size_t>(m), Polynomial(1)));
    normalisation.content *= Rational(m);
  }
  std::vector<RationalFunction> a;
  for (auto& c : product)
    a.push_back(RationalFunction::over_factors(c * Polynomial(m), normalisation.content, normalisation.factors));
  return centred(Laurent(0, std::move(a)));
}

}  // namespace twoscale
