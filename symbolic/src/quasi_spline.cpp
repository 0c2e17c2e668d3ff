// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/symbolic/quasi_spline.hpp"

#include <algorithm>

#include "newton_quotient.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale {

namespace {

// numerator / (content * prod factors), content any rational but 0.
RationalFunction fraction(const Polynomial& numerator, const Rational& content,
                          const RationalFunction::Factors& factors) {
  return RationalFunction::over_factors(numerator * Polynomial::constant(content.denominator()),
                                        Rational(content.numerator()), factors);
}

std::vector<Polynomial> product(const std::vector<Polynomial>& a, const std::vector<Polynomial>& b) {
  std::vector<Polynomial> c(a.size() + b.size() - 1);
  for (size_t i = 0; i < a.size(); ++i)
    for (size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  return c;
}

// Coefficients that read the same from both ends, over one denominator: each value is reduced once.
Laurent symmetric(long lowest, const std::vector<Polynomial>& numerators, const Rational& content,
                  const RationalFunction::Factors& factors) {
  std::vector<RationalFunction> c(numerators.size());
  for (size_t i = 0; 2 * i < c.size(); ++i) c[i] = c[c.size() - 1 - i] = fraction(numerators[i], content, factors);
  return {lowest, std::move(c)};
}

// Lambda° as it is reproduced: contained in the space, an odd power completed where the space has its partner.
Space completed(const Space& space, const Space& part) {
  if (part.dimension() == 0) bad_input("nothing is to be reproduced", part.to_string());
  const std::vector<std::string> have = space.items();
  for (const auto& item : part.items())
    if (std::find(have.begin(), have.end(), item) == have.end())
      bad_input("what is to be reproduced is not in the space {" + space.to_string() + "}", item);
  const unsigned order = part.polynomial_order();
  if (order % 2 == 0 || order == space.polynomial_order()) return part;
  return Space::parse(part.to_string() + (order == 1 ? ", x" : ", x^" + std::to_string(order)));
}

std::vector<LevelVariable> halved(std::vector<LevelVariable> variables, const std::vector<bool>& which) {
  for (size_t i = 0; i < variables.size(); ++i)
    if (which[i]) variables[i].factor /= Rational(2);
  return variables;
}

}  // namespace

QuasiSpline quasi_spline(const Space& space, const Space& reproduced) {
  QuasiSpline s;
  s.space = space;
  const Space part = completed(space, reproduced);
  s.reproduced = Space::rebase(part, s.space.variables()).space;
  const bool odd = space.dimension() % 2 == 1;
  if (odd) {
    std::vector<bool> half(s.space.variables().size());
    for (const auto& e : s.reproduced.exponentials())
      if (e.multiple % 2 == 1) half[e.variable] = true;
    s.space = Space::rebase(s.space, halved(s.space.variables(), half)).space;
    s.reproduced = Space::rebase(part, s.space.variables()).space;
  }
  // gamma_j of Lambda and of Lambda°; each node of the latter but the last zero of an odd order is one of the former.
  const std::vector<Node> all = nodes(s.space);
  std::vector<Node> own = nodes(s.reproduced);
  if (s.reproduced.polynomial_order() % 2 == 1) own.insert(own.begin(), Node{0, 0});
  const auto cosh = [&](const Node& n) {
    return n.multiple == 0 ? Polynomial(1) : Polynomial::chebyshev(s.space.variables()[n.variable].name, n.multiple);
  };
  std::vector<Polynomial> gamma;
  for (const Node& n : all) gamma.push_back(Polynomial(2) * cosh(n));
  std::vector<bool> taken(all.size());
  std::vector<std::optional<size_t>> partner(own.size());
  std::vector<Node> half_nodes;
  std::vector<Polynomial> h;
  for (size_t i = 0; i < own.size(); ++i) {
    s.nodes.push_back(Polynomial(2) * cosh(own[i]));
    for (size_t j = 0; j < all.size() && !partner[i]; ++j)
      if (!taken[j] && all[j] == own[i]) partner[i] = j;
    if (partner[i]) taken[*partner[i]] = true;
    half_nodes.push_back({own[i].variable, own[i].multiple / 2});
    h.push_back(cosh(half_nodes.back()));
  }
  const size_t count = own.size();
  const NewtonData data = odd ? inverse_root_data(half_nodes, h) : constant_data(count);
  const NewtonQuotient newton = newton_quotient(s.nodes, linear_product(s.nodes, gamma), partner, data);

  // S = 2^{1-N} P, F = f/scale times what `data` says; w_m = factor n_m / (D_m E_m).
  const Rational to_s = Rational(2).pow(1 - static_cast<long>(space.dimension()));
  const Rational f = (odd ? Rational(1) : Rational(2)) / data.scale;
  NodeSums sums(s.space);
  FactoredPolynomial denominator;  // D_m E_m
  FactoredPolynomial data_denominator;
  std::vector<Polynomial> ratio;
  taken.assign(all.size(), false);
  s.matrix.assign(count, std::vector<RationalFunction>(count));
  s.determinant = 1;
  for (size_t m = 0; m < count; ++m) {
    FactoredPolynomial whole;  // P(gamma_m)
    for (size_t j = 0; j < all.size(); ++j) {
      FactoredPolynomial sum = sums(own[m], all[j]);
      sum.content *= Rational(2);
      whole.multiply(sum);
      if (!taken[j]) denominator.multiply(sum);
    }
    if (partner[m]) taken[*partner[m]] = true;
    if (odd) {
      FactoredPolynomial e = sums(half_nodes[m], half_nodes[m]);  // 2 h_m
      e.content /= Rational(2);
      for (size_t i = 0; i < m; ++i) e.multiply(sums(half_nodes[i], half_nodes[m]));
      denominator.multiply(e);
      data_denominator.multiply(e);
    }
    ratio.push_back(newton.tail[m] * data.ratio[m]);
    s.solution.push_back(fraction(newton.numerator[m], to_s * denominator.content / f, denominator.factors));
    s.rhs.push_back(fraction(data.numerator[m], data_denominator.content / f, data_denominator.factors));
    for (size_t i = 0; i <= m; ++i) s.matrix[m][i] = RationalFunction(to_s) * RationalFunction(newton.difference[i][m]);
    s.determinant *= RationalFunction(to_s) * RationalFunction(whole.expanded());
  }

  std::vector<Polynomial> beta{Polynomial(1)};
  for (const auto& c : gamma) beta = product(beta, {Polynomial(1), c, Polynomial(1)});
  if (odd) beta = product(beta, {Polynomial(1), Polynomial(1)});
  const std::vector<Polynomial> q = newton_expansion(s.nodes, newton.numerator, ratio);
  const long n = static_cast<long>(all.size());
  const long d = static_cast<long>(count) - 1;
  s.beta = symmetric(-n, beta, to_s.inverse(), {});
  s.q = symmetric(-d, q, to_s * denominator.content / f, denominator.factors);
  s.mask = symmetric(-n - d, product(beta, q), denominator.content / f, denominator.factors);

  std::vector<std::pair<Node, Node>> conditions;
  for (size_t i = 0; i < count; ++i) {
    for (const Node& x : all) conditions.emplace_back(own[i], x);
    for (size_t j = 0; odd && j <= i; ++j) conditions.emplace_back(half_nodes[i], half_nodes[j]);
  }
  s.singular = zeros_of_pairs(s.space, conditions);
  return s;
}

Laurent free_factor(const QuasiSpline& s) {
  Laurent f = Laurent::monomial(0);
  for (const auto& g : s.nodes) f = f * Laurent(-1, {1, RationalFunction(-g), 1});
  return f;
}

DeRham de_rham_transform(const Space& space, const Laurent& mask) {
  // a^{[k]} in v^{[k+1]} = T_2(v^{[k+2]}), a^{[k+1]} in v^{[k+2]} = cosh((t/2)/2^{k+1}).
  Laurent coarse = mask;
  for (const auto& v : space.variables()) coarse = coarse.substitute(v.name, Polynomial::chebyshev(v.name, 2));
  DeRham d;
  d.space = Space::rebase(space, halved(space.variables(), std::vector<bool>(space.variables().size(), true))).space;
  d.mask = (mask * coarse.dilated(2)).subsymbol(2, 1).shifted(1);
  return d;
}

}  // namespace twoscale
