// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/symbolic/interpolatory.hpp"

#include <algorithm>
#include <bit>
#include <map>

#include "newton_quotient.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/mary_interpolatory.hpp"

namespace twoscale {

namespace {

using Factors = RationalFunction::Factors;

Polynomial integer_polynomial(const Rational& n) { return Polynomial::constant(n.numerator()); }

size_t half_dimension(const Space& space) {
  const unsigned n = space.dimension();
  if (n == 0 || n % 2 == 1)
    bad_input(
        "an interpolating 2l-point scheme needs a space of even dimension, this one has dimension " + std::to_string(n),
        space.to_string());
  return n / 2;
}

// sum_i c_i w^i of an odd or even Laurent polynomial in z given by its values a_i at z^i + z^{-i}: from powers of w to
// coefficients of z. Returns a_m, m = 1, 3, .., of w Q(w^2) times 4^{deg Q} * 2.
std::vector<Polynomial> cosine_coefficients(const std::vector<Polynomial>& q) {
  // w^{2j+1} = 2^{-2j} sum_i C(2j+1, j-i) T_{2i+1}(w), and T_m(w) = (z^m + z^-m)/2.
  const size_t n = q.size();
  std::vector<Polynomial> a(n);
  for (size_t j = 0; j < n; ++j)
    for (size_t i = 0; i <= j; ++i) {
      const Rational c = Rational::binomial(Rational(static_cast<long>(2 * j + 1)), static_cast<unsigned>(j - i)) *
                         Rational(4).pow(static_cast<long>(n - 1 - j));
      a[i] += integer_polynomial(c) * q[j];
    }
  return a;
}

Laurent symmetric_interpolatory(std::vector<RationalFunction> odd) {
  const size_t l = odd.size();
  std::vector<RationalFunction> c(4 * l - 1);
  c[2 * l - 1] = 1;
  for (size_t i = 0; i < l; ++i) {
    c[2 * l - 1 - (2 * i + 1)] = odd[i];
    c[2 * l - 1 + (2 * i + 1)] = std::move(odd[i]);
  }
  return {-(2 * static_cast<long>(l) - 1), std::move(c)};
}

}  // namespace

Laurent interpolating_symbol(const Space& space, int arity) {
  if (arity != 2) return mary_interpolating_symbol(space, arity);
  if (auto a = interpolating_symbol_harmonic(space)) return *std::move(a);
  if (auto a = interpolating_symbol_two_nodes(space)) return *std::move(a);
  return interpolating_symbol_by_divided_differences(space);
}

Laurent interpolating_symbol_by_divided_differences(const Space& space) {
  const size_t l = half_dimension(space);
  const std::vector<Node> node = nodes(space);
  const std::vector<Polynomial> w = cosh_nodes(space);
  const NewtonData data = inverse_root_data(node, w);  // in x = 4u - 2
  // Q(u) = sum_n 4^n [x_0..x_n] prod_{i<n} (u - w_i^2), [x_0..x_n] = numerator_n/(scale D_n), D_n = prod_{i<=n}
  // ratio_i: Horner over D_{l-1}.
  NodeSums sums(space);
  FactoredPolynomial denominator;
  for (size_t n = 0; n < l; ++n) {
    FactoredPolynomial r = sums(node[n], node[n]);  // 2 w_n
    r.content /= Rational(2);
    for (size_t i = 0; i < n; ++i) r.multiply(sums(node[i], node[n]));
    denominator.multiply(r);
  }
  std::vector<Polynomial> q(l);
  Polynomial tail = 1;  // D_{l-1} / D_n
  size_t length = 0;
  for (size_t n = l; n-- > 0;) {
    if (length > 0) {  // q *= u - w_n^2
      const Polynomial square = w[n] * w[n];
      for (size_t i = length; i > 0; --i)
        q[i] = (i < length ? q[i] : Polynomial(0)) * Polynomial(-1) * square + q[i - 1];
      q[0] = Polynomial(0) - q[0] * square;
    }
    ++length;
    q[0] += data.numerator[n] * integer_polynomial(Rational(4).pow(static_cast<long>(n))) * tail;
    tail *= data.ratio[n];
  }
  const Rational scale = Rational(2) * Rational(4).pow(static_cast<long>(l) - 1) * data.scale * denominator.content;
  std::vector<RationalFunction> odd;
  for (auto& a : cosine_coefficients(q)) {
    // scale may be a fraction: multiply both sides by its denominator.
    odd.push_back(RationalFunction::over_factors(a * integer_polynomial(Rational(scale.denominator())),
                                                 Rational(scale.numerator()), denominator.factors));
  }
  return symmetric_interpolatory(std::move(odd));
}

namespace {

// sum_j c[j] x^{2j}, x not constant.
Polynomial even_polynomial(const std::vector<Rational>& c, const Polynomial& x) {
  if (x == Polynomial::variable(x.variables()[0])) {
    std::vector<Rational> spread(2 * c.size() - 1);
    for (size_t j = 0; j < c.size(); ++j) spread[2 * j] = c[j];
    return Polynomial::univariate(x.variables()[0], spread);
  }
  const Polynomial square = x * x;
  Polynomial value;
  for (size_t j = c.size(); j-- > 0;) value = value * square + integer_polynomial(c[j]);
  return value;
}

// The coefficients of z^{2i+1}, i = 0..n, in F(w/p), times 2^{4n-3} p^{2n-1}, and in w (w^2 - p^2)^n, times 2^{2n+1}; F
// as in interpolating_symbol_two_nodes.
std::vector<std::pair<Polynomial, Polynomial>> two_node_parts(long n, const Polynomial& p) {
  const auto choose = [](long a, long b) { return Rational::binomial(Rational(a), static_cast<unsigned>(b)); };
  const auto signed_by = [](long k, const Rational& r) { return k % 2 == 0 ? r : -r; };
  const Rational lead = Rational(2 * n - 1) * choose(2 * n - 2, n - 1);
  std::vector<std::pair<Polynomial, Polynomial>> parts;
  if (p.is_one()) {
    // With w = cosh(theta), z = e^theta: dF/dtheta = c (-1)^{n-1} sinh^{2n-1}, w (w^2 - 1)^n = cosh sinh^{2n}:
    // binomials.
    std::vector<Rational> odd_row(static_cast<size_t>(n) + 1),
        even_row(static_cast<size_t>(n) + 1);  // C(2n-1,k), C(2n,k)
    odd_row[0] = even_row[0] = 1;
    for (long k = 1; k <= n; ++k) {
      odd_row[static_cast<size_t>(k)] = odd_row[static_cast<size_t>(k) - 1] * Rational(2 * n - k) / Rational(k);
      even_row[static_cast<size_t>(k)] = even_row[static_cast<size_t>(k) - 1] * Rational(2 * n - k + 1) / Rational(k);
    }
    for (long i = 0; i <= n; ++i) {
      const auto k = static_cast<size_t>(n - i);
      const Rational f = i == n ? Rational(0) : signed_by(i, lead * odd_row[k - 1] / Rational(2 * i + 1));
      const Rational h = signed_by(n - i, i == n ? even_row[0] : even_row[k] - even_row[k - 1]);
      parts.emplace_back(integer_polynomial(f), integer_polynomial(h));
    }
    return parts;
  }
  const auto l = static_cast<size_t>(n) + 1;
  std::vector<Rational> t(l), s(l);  // in powers of p^2
  for (long j = 0; j <= n; ++j) {
    const size_t at = static_cast<size_t>(n - j);
    if (j < n)
      t[at] = lead * choose(n - 1, j) * Rational(4).pow(n - 1 - j) / Rational(j % 2 == 0 ? 2 * j + 1 : -2 * j - 1);
    s[at] = choose(n, j) * Rational(4).pow(n - j) * Rational((n - j) % 2 == 0 ? 1 : -1);
  }
  // cosine[j][i] = C(2j+1, j-i), the coefficient of z^{2i+1} in 2^{2j+1} w^{2j+1}.
  std::vector<std::vector<Rational>> cosine{{1}};
  for (size_t j = 1; j < l; ++j) {
    const std::vector<Rational>& before = cosine.back();
    std::vector<Rational> row(j + 1);
    for (size_t i = 0; i < j; ++i) {
      row[i] += before[i] + before[i] + before[i == 0 ? 0 : i - 1];
      if (i + 1 < j) row[i] += before[i + 1];
    }
    row[j] = 1;
    cosine.push_back(std::move(row));
  }
  for (long i = 0; i <= n; ++i) {
    std::vector<Rational> a(static_cast<size_t>(n - i + 1)), b(a.size());
    for (long j = i; j <= n; ++j) {
      const size_t at = static_cast<size_t>(n - j);
      const Rational& c = cosine[static_cast<size_t>(j)][static_cast<size_t>(i)];
      if (at > 0) a[at - 1] = t[at] * c;
      b[at] = s[at] * c;
    }
    parts.emplace_back(even_polynomial(a, p), even_polynomial(b, p));
  }
  return parts;
}

}  // namespace

namespace {

// The nodes of a space with two different ones, one of them simple: which is which, and n = l - 1.
struct TwoNodes {
  Node simple, multiple;
  Polynomial q, p;
  long n;
};
std::optional<TwoNodes> two_nodes(const Space& space) {
  const size_t l = half_dimension(space);
  const std::vector<Node> node = nodes(space);
  if (l < 2) return std::nullopt;
  const bool last = std::equal(node.begin() + 1, node.end() - 1, node.begin());  // the simple node comes last
  if (!last && !std::equal(node.begin() + 2, node.end(), node.begin() + 1)) return std::nullopt;
  const size_t simple = last ? l - 1 : 0;
  const size_t multiple = last ? 0 : l - 1;
  if (node[simple] == node[multiple]) return std::nullopt;
  std::vector<Polynomial> w = cosh_nodes(space);
  return TwoNodes{node[simple], node[multiple], std::move(w[simple]), std::move(w[multiple]), static_cast<long>(l) - 1};
}

}  // namespace

std::optional<TwoNodeSymbol> interpolating_two_nodes_factored(const Space& space) {
  auto nodes = two_nodes(space);
  if (!nodes) return std::nullopt;
  const long n = nodes->n;
  TwoNodeSymbol s{std::move(nodes->p), std::move(nodes->q), {}, {}};
  // c = 1/int_0^1 (1-y^2)^{n-1} dy = (2n-1) C(2n-2,n-1)/4^{n-1} = prod_{k<n} (2k+1)/(2k) for k > 0.
  Rational f = 1, g = Rational(n % 2 == 0 ? 1 : -1) * Rational(2).pow(1 - n);
  for (long k = 1; k < n; ++k) f = f * Rational(2 * k + 1, 2 * k);
  s.f.reserve(static_cast<size_t>(n));
  s.g.reserve(static_cast<size_t>(n));
  for (long k = 0; k < n; ++k) {
    s.f.push_back(f / Rational(2 * k + 1));
    f = f * Rational(-(n - 1 - k), k + 1);
    s.g.push_back(g);
    g = g * Rational(n + k, 2 * (k + 1));
  }
  return s;
}

std::optional<Laurent> interpolating_symbol_two_nodes(const Space& space) {
  const auto found = two_nodes(space);
  if (!found) return std::nullopt;
  const auto& [simple, multiple, q, p, n] = *found;
  // G by Horner in p + q; at the end `power` is (p + q)^n.
  Polynomial g, power = 1;
  const Polynomial sum = p + q;
  const Polynomial twice = Polynomial(2) * p;
  Rational weight = 1;  // C(n-1+k, k)
  for (long k = 0; k < n; ++k) {
    if (k > 0) weight = weight * Rational(n - 1 + k) / Rational(k);
    g = p.is_one() ? Polynomial::combination(2, g, weight, power) : g * twice + power.scaled(weight);
    power *= sum;
  }
  const Polynomial denominator_part = (q * power).scaled(4);
  if (n % 2 == 1) g = -g;
  NodeSums sums(space);
  const auto to_the = [](FactoredPolynomial f, long e) {
    f.content = f.content.pow(e);
    for (auto& [factor, exponent] : f.factors) exponent *= static_cast<unsigned>(e);
    return f;
  };
  FactoredPolynomial denominator = sums(simple, simple);  // 2 q (p + q)^n (2 p)^{2n-1}
  denominator.multiply(to_the(sums(simple, multiple), n));
  denominator.multiply(to_the(sums(multiple, multiple), 2 * n - 1));
  const Rational content = denominator.content / Rational(2).pow(2 * n) * Rational(2).pow(4 * n - 1);
  const std::vector<std::pair<Polynomial, Polynomial>> parts = two_node_parts(n, p);
  std::vector<RationalFunction> odd;
  const Rational scale(content.denominator());
  for (const auto& [f, h] : parts) {
    const bool constants = f.is_constant() && h.is_constant();
    Polynomial numerator =
        constants ? Polynomial::combination(f.constant_value() * scale, denominator_part, h.constant_value() * scale, g)
                  : (denominator_part * f + g * h).scaled(scale);
    odd.push_back(
        RationalFunction::over_factors(std::move(numerator), Rational(content.numerator()), denominator.factors));
  }
  return symmetric_interpolatory(std::move(odd));
}

std::optional<std::vector<CosineProduct>> interpolating_coefficients_harmonic(const Space& space) {
  if (space.polynomial_order() != 2 || space.variables().size() != 1) return std::nullopt;
  for (size_t i = 0; i < space.exponentials().size(); ++i)
    if (space.exponentials()[i].multiple != i + 1 || space.exponentials()[i].order != 1) return std::nullopt;
  // Per factor (1 - T_i)/(T_m - T_i) = -(E^i - 1)^2 E^{m-i} / ((E^{m+i} - 1)(E^{m-i} - 1)); E^n - 1 = prod_{d|n} Phi_d.
  // Over all odd i <= last, i != m, the m + i and |m - i| are the even numbers up to last + m and up to last - m
  // without 2m, so the exponent of Phi_d is
  //   2 #{odd i <= last, i != m: d | i} - #{even n <= last + m: d | n} - #{even n <= last - m: d | n} + [d | 2m].
  // Phi_d(E) E^{-phi(d)/2} is the minimal polynomial of 2 cos(2 pi/d) at 2v, that is Psi_d times its content; (E+1)^2/E
  // = 2 (v+1). The content is 2 for d = 2, 4, 8, .. and 1 otherwise: the coefficient of v^j has a factor 2^j, and the
  // constant term, the norm of 2 cos(2 pi/d), is 0 for d = 4, +-p for d = 4 p^k and +-1 for all other d > 2.
  const unsigned l = static_cast<unsigned>(half_dimension(space));
  const unsigned last = 2 * l - 1;
  std::vector<CosineProduct> list(l);
  for (unsigned m = 1; m <= last; m += 2) {
    CosineProduct& a = list[(m - 1) / 2];
    long two = -1;
    for (unsigned d = 2; d <= last + m; ++d) {
      const unsigned even = d % 2 == 0 ? d : 2 * d;
      long exponent = -static_cast<long>((last + m) / even) - static_cast<long>((last - m) / even);
      if (d % 2 == 1) exponent += 2 * static_cast<long>((last / d + 1) / 2 - (m % d == 0 ? 1 : 0));
      if (2 * m % d == 0) ++exponent;
      if (d == 2) exponent /= 2;
      if (exponent == 0) continue;
      if (std::has_single_bit(d)) two += exponent;
      a.factors.emplace_back(d, exponent);
    }
    a.content = Rational(2).pow(two);
    if (m % 4 == 3) a.content = -a.content;
  }
  return list;
}

std::optional<Laurent> interpolating_symbol_harmonic(const Space& space) {
  const auto products = interpolating_coefficients_harmonic(space);
  if (!products) return std::nullopt;
  // The minimal polynomials that occur, in the order of canonical denominators.
  std::map<unsigned, Polynomial> minimal;
  for (const CosineProduct& a : *products)
    for (const auto& [d, exponent] : a.factors)
      if (!minimal.contains(d)) minimal.emplace(d, Polynomial::cosine_minimal(space.variables()[0].name, d));
  std::vector<unsigned> order;
  for (const auto& [d, p] : minimal) order.push_back(d);
  std::sort(order.begin(), order.end(),
            [&](unsigned a, unsigned b) { return Polynomial::compare(minimal.at(a), minimal.at(b)) < 0; });
  std::vector<std::pair<unsigned, const Polynomial*>> ordered;
  for (const unsigned d : order) ordered.emplace_back(d, &minimal.at(d));
  std::vector<RationalFunction> odd;
  std::vector<long> exponents(order.empty() ? 0 : *std::max_element(order.begin(), order.end()) + 1);
  for (const CosineProduct& a : *products) {
    std::fill(exponents.begin(), exponents.end(), 0);
    for (const auto& [d, exponent] : a.factors) exponents[d] = exponent;
    Polynomial top = 1;
    Factors bottom;
    for (const auto& [d, p] : ordered) {
      if (exponents[d] > 0) top *= p->pow(static_cast<unsigned>(exponents[d]));
      if (exponents[d] < 0) bottom.emplace_back(*p, static_cast<unsigned>(-exponents[d]));
    }
    odd.push_back(RationalFunction::over_factors(top.scaled(Rational(a.content.numerator())),
                                                 Rational(a.content.denominator()), std::move(bottom)));
  }
  return symmetric_interpolatory(std::move(odd));
}

namespace {

// det by fraction-free elimination (Bareiss) of a matrix of polynomials, rows reduced in place; also the solution of
// matrix * x = rhs when rhs is the last column.
Polynomial bareiss(std::vector<std::vector<Polynomial>>& a) {
  const size_t n = a.size();
  Polynomial previous = 1;
  bool negative = false;
  for (size_t k = 0; k < n; ++k) {
    size_t pivot = k;
    while (pivot < n && a[pivot][k].is_zero()) ++pivot;
    if (pivot == n) return 0;
    if (pivot != k) {
      std::swap(a[pivot], a[k]);
      negative = !negative;
    }
    for (size_t i = k + 1; i < n; ++i)
      for (size_t j = k + 1; j < a[i].size(); ++j)
        a[i][j] = Polynomial::exact_quotient(a[i][j] * a[k][k] - a[i][k] * a[k][j], previous);
    previous = a[k][k];
  }
  return negative ? -previous : previous;
}

}  // namespace

Laurent omega_from_folded(const FoldedSystem& system) {
  const size_t l = system.matrix.size();
  std::vector<std::vector<Polynomial>> a(l);
  for (size_t i = 0; i < l; ++i) {
    std::vector<RationalFunction> row = system.matrix[i];
    row.push_back(system.rhs[i]);
    const CommonDenominator d = common_denominator(row);
    for (const auto& x : row) a[i].push_back(numerator_over(x, d));
  }
  if (bareiss(a).is_zero()) bad_input("the linear system for omega is singular");
  std::vector<RationalFunction> x(l);
  for (size_t i = l; i-- > 0;) {
    RationalFunction s = a[i][l];
    for (size_t j = i + 1; j < l; ++j) s -= RationalFunction(a[i][j]) * x[j];
    x[i] = s / RationalFunction(a[i][i]);
  }
  std::vector<RationalFunction> c(2 * l - 1);
  for (size_t i = 0; i < l; ++i) c[i] = c[2 * l - 2 - i] = x[i];
  return {-(static_cast<long>(l) - 1), std::move(c)};
}

std::string cosine_text(const Rational& angle) {
  if (angle == Rational(1, 2)) return "0";
  if (angle == Rational(1, 3)) return "1/2";
  if (angle == Rational(2, 3)) return "-1/2";
  const Rational p(angle.numerator());
  return "cos(" + (p == Rational(1) ? "" : p.to_string() + "*") + "pi/" + Rational(angle.denominator()).to_string() +
         ")";
}

std::string SingularSet::Value::exact() const { return cosine_text(angle); }

std::vector<Polynomial> extension_weights(const Space& space, int arity) {
  // prod (y^2 - 2 cosh(theta/m^k) y + 1), cosh(n theta/m^k) = T_{m n}(v); an odd order leaves one factor (y - 1).
  std::vector<Polynomial> f{Polynomial(1)};
  const auto multiply = [&](const std::vector<Polynomial>& g) {
    std::vector<Polynomial> r(f.size() + g.size() - 1);
    for (size_t i = 0; i < f.size(); ++i)
      for (size_t j = 0; j < g.size(); ++j) r[i + j] += f[i] * g[j];
    f = std::move(r);
  };
  for (const Node& n : nodes(space)) {
    const Polynomial t = n.multiple == 0 ? Polynomial(1)
                                         : Polynomial::chebyshev(space.variables()[n.variable].name,
                                                                 static_cast<unsigned>(arity) * n.multiple);
    multiply({Polynomial(1), Polynomial(-2) * t, Polynomial(1)});
  }
  if (space.polynomial_order() % 2 == 1) multiply({Polynomial(-1), Polynomial(1)});
  // sum_j f_j p_{j-1} = 0 with f_0 = +-1.
  std::vector<Polynomial> e;
  const bool flip = f[0] == Polynomial(1);
  for (size_t j = 1; j < f.size(); ++j) e.push_back(flip ? -f[j] : f[j]);
  return e;
}

}  // namespace twoscale
