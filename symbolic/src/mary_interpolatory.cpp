// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/symbolic/mary_interpolatory.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "newton_quotient.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/exact_real.hpp"

namespace twoscale {

namespace {

const Node zero_node{0, 0};

Polynomial integer_polynomial(const Rational& n) { return Polynomial::constant(n.numerator()); }

Rational lcm(const Rational& a, const Rational& b) { return a * b / gcd(a, b); }

void require(const Space& space, int arity) {
  if (arity < 2 || arity > 64) bad_input("arity must be between 2 and 64", std::to_string(arity));
  if (space.dimension() == 0) bad_input("an interpolating scheme needs a function space, this one is empty");
  if (!has_interpolating_scheme(space, arity))
    bad_input("an interpolating scheme of even arity needs a space of even dimension, this one has dimension " +
                  std::to_string(space.dimension()),
              space.to_string());
}

bool odd_dimension(const Space& space) { return space.dimension() % 2 == 1; }

// The nodes of W: those of the space, and one more 1 for an odd dimension.
std::vector<Node> contact_nodes(const Space& space) {
  std::vector<Node> list = nodes(space);
  if (odd_dimension(space)) list.insert(list.begin(), zero_node);
  return list;
}

Polynomial node_value(const Space& space, const Node& n) {
  return n.multiple == 0 ? Polynomial(1) : Polynomial::chebyshev(space.variables()[n.variable].name, n.multiple);
}

// The factors that `part` has in common with `whole`, a multiple of it.
FactoredPolynomial factored_by(const Polynomial& part, const FactoredPolynomial& whole) {
  FactoredPolynomial r;
  Polynomial rest = part;
  for (const auto& [f, e] : whole.factors) {
    auto [quotient, exponent] = rest.remove(f);
    if (exponent > 0) r.factors.emplace_back(f, exponent);
    rest = std::move(quotient);
  }
  r.content = rest.constant_value();
  return r;
}

// ---- Chebyshev polynomials of the four kinds, in x

enum class Kind { first, second, third, fourth };

// T_n, U_n, and V_n = cosh((n + 1/2) tau)/cosh(tau/2), W_n = sinh((n + 1/2) tau)/sinh(tau/2); x = cosh(tau).
Polynomial chebyshev(Kind kind, unsigned n) {
  const Polynomial x = Polynomial::variable("x");
  Polynomial before = 1, now;
  switch (kind) {
    case Kind::first: return Polynomial::chebyshev("x", n);
    case Kind::second: now = Polynomial(2) * x; break;
    case Kind::third: now = Polynomial(2) * x - 1; break;
    case Kind::fourth: now = Polynomial(2) * x + 1; break;
  }
  if (n == 0) return before;
  for (unsigned i = 1; i < n; ++i) before = std::exchange(now, Polynomial(2) * x * now - before);
  return now;
}

// 2 (U - c) sum_h q[h] B_h(U), in the same basis: 2 U B_h = B_{h+1} + B_{h-1} with B_{-1} = B_1, 0, B_0, -B_0.
std::vector<Polynomial> times_twice_difference(const std::vector<Polynomial>& q, Kind kind, const Polynomial& c) {
  std::vector<Polynomial> r(q.size() + 1);
  for (size_t h = 0; h < q.size(); ++h) {
    r[h + 1] += q[h];
    if (h > 0)
      r[h - 1] += q[h];
    else if (kind == Kind::first)
      r[1] += q[0];
    else if (kind != Kind::second)
      r[0] += kind == Kind::third ? q[0] : -q[0];
    r[h] -= (c * q[h]).scaled(2);
  }
  return r;
}

// ---- One half of the conditions

// A polynomial over an integer.
struct Scaled {
  Polynomial numerator = 0;
  Rational denominator = 1;
};

// x a + y b for rational x, y, over one denominator.
Scaled combination(const Rational& x, const Polynomial& a, const Rational& y, const Polynomial& b) {
  const Rational common = lcm(Rational(x.denominator()), Rational(y.denominator()));
  return {Polynomial::combination(x * common, a, y * common, b), common};
}

// a / b where b divides a over the rationals.
Scaled quotient(Scaled a, const Polynomial& b) {
  if (a.numerator.is_zero()) return a;
  const Rational content = b.content();
  a.numerator = Polynomial::exact_quotient(a.numerator, b.scaled(content.inverse()));
  a.denominator *= content;
  const Rational common = gcd(a.numerator.content(), a.denominator);
  return {a.numerator.scaled(common.inverse()), a.denominator / common};
}

// g(U) = numerator/denominator as functions of x = w, with (1 - U^2) g'' - (beta U + delta) g' + lambda g = 0.
struct Half {
  Kind basis;
  Polynomial numerator, denominator;
  Rational at_one;  // g at U = 1
  long beta, delta;
  Rational lambda;
};

// Phase s of m: the even and the odd half.
Half even_half(bool odd_dimension, long m, long s) {
  const Rational a = odd_dimension ? Rational(s, m) : Rational(2 * s - m, 2 * m);
  if (odd_dimension) return {Kind::first, chebyshev(Kind::first, static_cast<unsigned>(s)), 1, 1, 1, 0, a * a};
  const auto d = static_cast<unsigned>(std::abs(2 * s - m));
  const auto of = [&](unsigned n) { return chebyshev(m % 2 == 1 ? Kind::third : Kind::first, n / 2); };
  return {Kind::third, of(d), of(static_cast<unsigned>(m)), 1, 2, -1, a * a - Rational(1, 4)};
}

Half odd_half(bool odd_dimension, long m, long s) {
  const Rational a = odd_dimension ? Rational(s, m) : Rational(2 * s - m, 2 * m);
  if (odd_dimension)
    return {Kind::second,
            chebyshev(Kind::second, static_cast<unsigned>(s) - 1),
            chebyshev(Kind::second, static_cast<unsigned>(m) - 1),
            a,
            3,
            0,
            a * a - Rational(1)};
  const auto d = static_cast<unsigned>(std::abs(2 * s - m));
  const auto of = [&](unsigned n) {
    return m % 2 == 1 ? chebyshev(Kind::fourth, n / 2) : chebyshev(Kind::second, n / 2 - 1);
  };
  const Polynomial top = d == 0 ? Polynomial(0) : 2 * s > m ? of(d) : -of(d);
  return {Kind::fourth, top, of(static_cast<unsigned>(m)), a * Rational(2), 2, 1, a * a - Rational(1, 4)};
}

// The nodes of one arity with their divided differences t_ij, each factored and expanded once. Route 1 leaves the
// constant t_ij = m^2 for w_i = w_j = 1 out of all denominators.
enum class Ones { counted, left_out };
class Differences {
 public:
  Differences(const Space& space, int arity, std::vector<Node> nodes, Ones ones)
      : space_(space), arity_(arity), nodes_(std::move(nodes)), ones_(ones) {
    for (const Node& n : nodes_) {
      w.push_back(node_value(space, n));
      u.push_back(n.multiple == 0 ? Polynomial(1)
                                  : Polynomial::chebyshev(space.variables()[n.variable].name,
                                                          static_cast<unsigned>(arity) * n.multiple));
    }
  }
  size_t size() const { return nodes_.size(); }
  int arity() const { return arity_; }
  bool same(size_t i, size_t j) const { return nodes_[i] == nodes_[j]; }
  bool is_one(size_t i) const { return nodes_[i].multiple == 0; }
  const FactoredPolynomial& factored(size_t i, size_t j) { return entry(i, j).first; }
  const Polynomial& expanded(size_t i, size_t j) { return entry(i, j).second; }
  std::vector<Polynomial> w, u;

 private:
  using Label = std::pair<size_t, unsigned>;
  const std::pair<FactoredPolynomial, Polynomial>& entry(size_t i, size_t j) {
    const Label a{nodes_[i].variable, nodes_[i].multiple}, b{nodes_[j].variable, nodes_[j].multiple};
    const auto key = std::minmax(a, b);
    auto at = known_.find(key);
    if (at == known_.end()) {
      FactoredPolynomial f = is_one(i) && is_one(j) && ones_ == Ones::left_out
                                 ? FactoredPolynomial{}
                                 : chebyshev_difference(space_, nodes_[i], nodes_[j], arity_);
      Polynomial p = f.expanded();
      at = known_.emplace(key, std::pair(std::move(f), std::move(p))).first;
    }
    return at->second;
  }

  const Space& space_;
  int arity_;
  std::vector<Node> nodes_;
  Ones ones_;
  std::map<std::pair<Label, Label>, std::pair<FactoredPolynomial, Polynomial>> known_;
};

// The divided differences [U_i, .., U_i] g of n + 1 equal nodes, n = 0..count-1, times d^{n+1} t_ii^{n(n+1)/2}, d =
// denominator(w_i); at w_i = 1 without factors.
std::vector<Scaled> confluent(const Half& g, Differences& t, size_t i, size_t count) {
  std::vector<Scaled> list;
  const auto factor = [&](long n) {  // n (n-1) + beta n - lambda
    return Rational(n * (n - 1) + g.beta * n) - g.lambda;
  };
  if (t.is_one(i)) {
    Rational value = g.at_one;
    for (long n = 0; n < static_cast<long>(count); ++n) {
      list.push_back({integer_polynomial(Rational(value.numerator())), Rational(value.denominator())});
      value *= -factor(n) / Rational((n + 1) * (2 * n + g.beta + g.delta));
    }
    return list;
  }
  const Polynomial& w = t.w[i];
  const auto at = [&](const Polynomial& p) { return p.substitute("x", w); };
  const Polynomial top = at(g.numerator), d = at(g.denominator);
  list.push_back({top, 1});
  if (count == 1) return list;
  // M_n = g_n d^2 t^{2n-1}, n >= 1:
  //   (n+2) (n+1) (1-w^2)/m^2 M_{n+2} = factor(n) t^2 M_n + (n+1) ((2n + beta) U + delta) M_{n+1};
  // for n = 0 with top d t for t^2 M_0.
  const Polynomial& slope = t.expanded(i, i);
  const Polynomial square = slope * slope;
  const Polynomial ends = Polynomial(1) - w * w;
  std::vector<Scaled> m{
      {top * d * slope, 1},
      {at(g.numerator.derivative("x") * g.denominator - g.numerator * g.denominator.derivative("x")), 1}};
  for (long n = 0; n + 2 < static_cast<long>(count); ++n) {
    const Scaled &low = m[static_cast<size_t>(n)], &high = m[static_cast<size_t>(n) + 1];
    const Rational scale = Rational(static_cast<long>(t.arity()) * t.arity(), (n + 2) * (n + 1));
    m.push_back(
        quotient(combination(scale * factor(n) / low.denominator, n == 0 ? low.numerator : low.numerator * square,
                             scale * Rational(n + 1) / high.denominator,
                             high.numerator * (t.u[i].scaled(Rational(2 * n + g.beta)) + Polynomial(g.delta))),
                 ends));
  }
  for (long n = 1; n < static_cast<long>(count); ++n) {
    const Scaled& x = m[static_cast<size_t>(n)];
    list.push_back({x.numerator * d.pow(static_cast<unsigned>(n - 1)) *
                        slope.pow(static_cast<unsigned>(n * (n + 1) / 2 - (2 * n - 1))),
                    x.denominator});
  }
  return list;
}

// The coefficients in the basis B_h(U), h = 0..size-1, of the Hermite interpolant of g at the U_i.
std::vector<RationalFunction> interpolant(const Half& g, Differences& t) {
  const size_t l = t.size();
  if (l == 0) return {};
  std::vector<Polynomial> d;
  for (size_t i = 0; i < l; ++i) d.push_back(t.is_one(i) ? Polynomial(1) : g.denominator.substitute("x", t.w[i]));
  // [U_i..U_j] g = N_ij / (prod d_a prod_{a<b} t_ab), all over i..j; N_ij (w_j - w_i) = N_{i+1,j} d_i prod_{i<b<j} t_ib
  // - N_{i,j-1} d_j prod_{i<a<j} t_aj.
  std::vector<std::vector<Scaled>> blocks(l);
  for (size_t i = 0; i < l; ++i) {
    if (i > 0 && t.same(i, i - 1)) {
      blocks[i] = blocks[i - 1];
      continue;
    }
    size_t count = 1;
    while (i + count < l && t.same(i, i + count)) ++count;
    blocks[i] = confluent(g, t, i, count);
  }
  std::vector<Scaled> row, newton;  // row[i] = N_{i,i+n}
  for (size_t i = 0; i < l; ++i) row.push_back(blocks[i][0]);
  newton.push_back(row[0]);
  std::vector<Polynomial> left(l, Polynomial(1));
  for (size_t n = 1; n < l; ++n) {
    std::vector<Scaled> next(l - n);
    for (size_t i = 0; i + n < l; ++i) {
      const size_t j = i + n;
      if (n >= 2) left[i] *= t.expanded(i, j - 1);
      if (t.same(i, j)) {
        next[i] = blocks[i][n];
      } else {
        Polynomial right = 1;
        for (size_t a = i + 1; a < j; ++a) right *= t.expanded(a, j);
        next[i] = quotient(combination(row[i + 1].denominator.inverse(), row[i + 1].numerator * d[i] * left[i],
                                       -row[i].denominator.inverse(), row[i].numerator * d[j] * right),
                           t.w[j] - t.w[i]);
      }
    }
    row = std::move(next);
    newton.push_back(row[0]);
  }
  // Horner in the Newton basis over the last denominator.
  FactoredPolynomial denominator;
  std::vector<Polynomial> ratio = d;  // d_n prod_{i<n} t_in
  Rational content = 1;
  for (size_t n = 0; n < l; ++n) {
    if (!t.is_one(n)) denominator.multiply(factored_by(d[n], t.factored(n, n)));
    for (size_t i = 0; i < n; ++i) {
      ratio[n] *= t.expanded(i, n);
      denominator.multiply(t.factored(i, n));
    }
    content = lcm(content, newton[n].denominator);
  }
  std::vector<Polynomial> q;
  Polynomial tail = 1;
  for (size_t n = l; n-- > 0;) {
    q = q.empty() ? std::vector<Polynomial>(1) : times_twice_difference(q, g.basis, t.u[n]);
    const Rational twos = Rational(2).pow(static_cast<long>(l - 1 - n));
    q[0] += newton[n].numerator.scaled(twos * content / newton[n].denominator) * tail;
    tail *= ratio[n];
  }
  const Rational scale = content * denominator.content * Rational(2).pow(static_cast<long>(l) - 1);
  std::vector<RationalFunction> result;
  for (auto& c : q)
    result.push_back(RationalFunction::over_factors(c * integer_polynomial(Rational(scale.denominator())),
                                                    Rational(scale.numerator()), denominator.factors));
  return result;
}

// S up to its constant, as a polynomial in x = 2 w: prod_i T_m[w, w_i], times D for an odd dimension.
std::vector<Polynomial> smoothing_product(const Space& space, long m) {
  // 2 T_m(x/2), monic with integer coefficients: t_0 = 2, t_1 = x, t_{n+1} = x t_n - t_{n-1}.
  std::vector<std::vector<long>> twice{{2}, {0, 1}};
  for (long n = 1; n < m; ++n) {
    const auto &b = twice[static_cast<size_t>(n) - 1], &a = twice[static_cast<size_t>(n)];
    std::vector<long> c(a.size() + 1);
    for (size_t i = 0; i < a.size(); ++i) c[i + 1] += a[i];
    for (size_t i = 0; i < b.size(); ++i) c[i] -= b[i];
    twice.push_back(std::move(c));
  }
  std::vector<Polynomial> product{Polynomial(1)};
  const auto multiply = [&](const std::vector<Polynomial>& f) {
    std::vector<Polynomial> r(product.size() + f.size() - 1);
    for (size_t i = 0; i < product.size(); ++i)
      for (size_t j = 0; j < f.size(); ++j) r[i + j] += product[i] * f[j];
    product = std::move(r);
  };
  for (const Polynomial& w : cosh_nodes(space)) {
    std::vector<Polynomial> f;  // synthetic division by x - 2 w
    for (const long c : twice[static_cast<size_t>(m)]) f.emplace_back(c);
    for (size_t i = f.size() - 1; i-- > 0;) f[i] += (f[i + 1] * w).scaled(2);
    f.erase(f.begin());
    multiply(f);
  }
  if (odd_dimension(space)) {
    std::vector<Polynomial> f(static_cast<size_t>((m + 1) / 2));
    f[0] = 1;
    for (size_t n = 1; 2 * n < static_cast<size_t>(m); ++n)
      for (size_t i = 0; i <= n; ++i) f[i] += Polynomial(twice[n][i]);
    multiply(f);
  }
  return product;
}

// prod_i t_i1, times m for an odd dimension: smoothing_product at x = 2.
FactoredPolynomial normalisation(const Space& space, int arity) {
  FactoredPolynomial f, factor;
  const std::vector<Node> node = nodes(space);
  for (size_t i = 0; i < node.size(); ++i) {
    if (i == 0 || !(node[i] == node[i - 1])) factor = chebyshev_difference(space, node[i], zero_node, arity);
    f.multiply(factor);
  }
  if (odd_dimension(space)) f.content *= Rational(arity);
  return f;
}

// D(w) = 1 + 2 T_1 + .. + 2 T_{(m-1)/2} = W_{(m-1)/2}(w).
Polynomial odd_factor(long m, const Polynomial& w) {
  return chebyshev(Kind::fourth, static_cast<unsigned>((m - 1) / 2)).substitute("x", w);
}

}  // namespace

bool has_interpolating_scheme(const Space& space, int arity) {
  return space.dimension() > 0 && (space.dimension() % 2 == 0 || arity % 2 == 1);
}

Laurent mary_interpolating_symbol(const Space& space, int arity) {
  require(space, arity);
  const bool odd = odd_dimension(space);
  const long m = arity;
  const long l = static_cast<long>(space.dimension()) / 2;
  Differences even_nodes(space, arity, contact_nodes(space), Ones::left_out);
  Differences odd_nodes(space, arity, nodes(space), Ones::left_out);
  const long reach = odd ? m * l + (m - 1) / 2 : m * l - 1;
  std::vector<RationalFunction> a(static_cast<size_t>(2 * reach + 1));
  a[static_cast<size_t>(reach)] = 1;
  const RationalFunction half = Rational(1, 2);
  // Phases s <= m/2; a symmetric symbol gives the others.
  for (long s = 1; 2 * s <= m; ++s) {
    const Half g = even_half(odd, m, s), k = odd_half(odd, m, s);
    const std::vector<RationalFunction> e = interpolant(g, even_nodes);
    const std::vector<RationalFunction> o =
        k.numerator.is_zero() ? std::vector<RationalFunction>(e.size()) : interpolant(k, odd_nodes);
    const auto set = [&](long offset, RationalFunction value) {
      const long i = s - m * offset;
      a[static_cast<size_t>(reach - i)] = value;
      a[static_cast<size_t>(reach + i)] = std::move(value);
    };
    for (size_t h = 0; h < e.size(); ++h) {
      const long j = static_cast<long>(h);
      if (odd && h == 0) {
        set(0, e[0]);
        continue;
      }
      const RationalFunction& difference = o[odd ? h - 1 : h];
      set(odd ? j : j + 1, half * (e[h] + difference));
      set(-j, half * (e[h] - difference));
    }
  }
  return {-reach, std::move(a)};
}

HessenbergSystem hessenberg_system(const Space& space, int arity) {
  require(space, arity);
  const bool odd = odd_dimension(space);
  const long m = arity;
  HessenbergSystem h;
  const std::vector<Node> node = contact_nodes(space);
  const size_t l = node.size();
  const size_t first = odd ? 1 : 0;  // of the nodes of the space
  for (const Node& n : node) h.nodes.push_back(node_value(space, n).scaled(2));
  const auto& g = h.nodes;
  const FactoredPolynomial norm = normalisation(space, arity);  // S = m p / norm
  // The factors of p at the nodes, and which of them stands for which node: t_ij for node j, and for an odd dimension D
  // for the additional node 1, whose D(1) = m takes the place of t_00.
  Differences t(space, arity, node, Ones::counted);
  Product product{smoothing_product(space, m), std::vector<std::vector<Polynomial>>(l)};
  std::vector<std::optional<size_t>> partner;
  for (size_t i = 0; i < l; ++i) {
    partner.emplace_back(i);
    if (odd) product.at[i].push_back(odd_factor(m, t.w[i]));
    for (size_t j = first; j < l; ++j) product.at[i].push_back(t.expanded(i, j));
  }
  const NewtonQuotient newton = newton_quotient(g, product, partner, constant_data(l));
  const auto scaled = [&](const Polynomial& x) {
    return RationalFunction::over_factors(x.scaled(m), norm.content, norm.factors);
  };
  h.matrix.assign(l, std::vector<RationalFunction>(l));
  for (size_t r = 1; r < l; ++r)
    for (size_t a = 0; a <= r; ++a) h.matrix[r - 1][a] = scaled(newton.difference[a][r]);
  h.matrix[l - 1][0] = 1;
  // w_a = norm numerator_a / D_a, D_a = prod over the pairs i <= j, i <= a.
  FactoredPolynomial denominator;
  const Polynomial scale = norm.expanded();
  for (size_t a = 0; a < l; ++a) {
    if (odd && a == 0) denominator.content *= Rational(m);
    for (size_t j = odd ? std::max<size_t>(a, 1) : a; j < l; ++j) denominator.multiply(t.factored(a, j));
    h.solution.push_back(
        RationalFunction::over_factors(newton.numerator[a] * scale, denominator.content, denominator.factors));
  }
  h.rhs.assign(l, 0);
  h.rhs[l - 1] = h.solution[0];
  h.determinant = l % 2 == 1 ? 1 : -1;
  for (size_t r = 1; r < l; ++r) h.determinant *= scaled(newton.difference[r][r]);
  // omega has symmetric coefficients: reduce one half only.
  const std::vector<Polynomial> omega = newton_expansion(g, newton.numerator, newton.tail);
  const size_t half = omega.size() / 2;
  std::vector<RationalFunction> c(omega.size());
  for (size_t i = 0; i <= half; ++i)
    c[i] = c[omega.size() - 1 - i] =
        RationalFunction::over_factors(omega[i] * scale, denominator.content, denominator.factors);
  h.omega = Laurent(-static_cast<long>(half), std::move(c));
  return h;
}

FoldedSystem folded_system(const Space& space, int arity) {
  require(space, arity);
  const long m = arity;
  const long l = static_cast<long>(contact_nodes(space).size());
  const Laurent sigma = bspline_symbol(space, arity);
  FoldedSystem f;
  f.matrix.assign(static_cast<size_t>(l), std::vector<RationalFunction>(static_cast<size_t>(l)));
  f.rhs.assign(static_cast<size_t>(l), 0);
  f.rhs.back() = 1;
  for (long j = 1; j <= l; ++j)
    for (long i = 0; i < l; ++i) {
      auto& entry = f.matrix[static_cast<size_t>(j - 1)][static_cast<size_t>(i)];
      const long row = m * (l - j), from = l - 1 - i;
      if (j == l && space.polynomial_order() > 0)
        entry = from > 0 ? 2 : 1;
      else if (from > 0)
        entry = sigma.coefficient(row - from) + sigma.coefficient(row + from);
      else
        entry = sigma.coefficient(row);
    }
  f.hessenberg = true;
  for (size_t r = 0; r < f.matrix.size(); ++r)
    for (size_t c = r + 2; c < f.matrix.size(); ++c) f.hessenberg = f.hessenberg && f.matrix[r][c].is_zero();
  return f;
}

RationalFunction folded_determinant(const Space& space, const FoldedSystem& system, int arity) {
  const std::vector<Node> node = nodes(space);
  Differences t(space, arity, node, Ones::counted);
  Polynomial zeros = 1;
  for (size_t i = 0; i < node.size(); ++i) {
    for (size_t j = i; j < node.size(); ++j) zeros *= t.expanded(i, j);
    if (odd_dimension(space)) zeros *= odd_factor(arity, t.w[i]);
  }
  const FactoredPolynomial norm = normalisation(space, arity);
  RationalFunction shape = zeros;
  const size_t l = system.matrix.size();
  for (size_t r = 0; r < l; ++r) shape *= RationalFunction::over_factors(1, 1, norm.factors);
  std::vector<std::pair<std::string, Rational>> at;
  for (const auto& v : space.variables()) at.emplace_back(v.name, Rational(static_cast<long>(at.size()) + 2));
  std::vector<std::vector<Rational>> a(l, std::vector<Rational>(l));
  for (size_t i = 0; i < l; ++i)
    for (size_t j = 0; j < l; ++j) a[i][j] = *system.matrix[i][j].evaluate(at);
  Rational det = 1;
  for (size_t k = 0; k < l; ++k) {
    size_t pivot = k;
    while (pivot < l && a[pivot][k].is_zero()) ++pivot;
    if (pivot == l) throw std::logic_error("folded_determinant: singular at v = 2");
    if (pivot != k) {
      std::swap(a[pivot], a[k]);
      det = -det;
    }
    det *= a[k][k];
    for (size_t i = k + 1; i < l; ++i) {
      const Rational factor = a[i][k] / a[k][k];
      for (size_t j = k; j < l; ++j) a[i][j] -= factor * a[k][j];
    }
  }
  return RationalFunction(det / *shape.evaluate(at)) * shape;
}

namespace {

// The factors of T_m[cosh(a phi_s), cosh(b phi_t)] that vanish somewhere with |phi_s|, |phi_t| < pi/m (level 0 holds
// all the others). In hyperbolic variables T_m[..] > 0. In trigonometric ones its zeros are the lines a phi_s + b phi_t
// = 2 pi r/m, m not dividing r, signs of phi free; a factor vanishes on all of a line or at single points of it, so one
// generic point of each line tells which factor has it: the one whose ball still contains 0.
std::vector<Polynomial> vanishing_factors(const Space& space, const Node& x, const Node& y, long m) {
  const FactoredPolynomial f = chebyshev_difference(space, x, y, static_cast<int>(m));
  const std::string& s = space.variables()[x.variable].name;
  std::vector<Polynomial> found;
  const auto at = [&](const Polynomial& p, const Rational& a, const Rational& b) {
    const ExactReal vs = ExactReal::apply(ExactReal::Function::cos, ExactReal(a / Rational(m)) * ExactReal::pi());
    const ExactReal vt = ExactReal::apply(ExactReal::Function::cos, ExactReal(b / Rational(m)) * ExactReal::pi());
    ExactReal sum;
    p.for_each_term([&](const Rational& c, std::span<const unsigned long> e) {
      ExactReal term = c;
      for (size_t i = 0; i < e.size(); ++i)
        term = term * (p.variables()[i] == s ? vs : vt).pow(Rational(static_cast<long>(e[i])));
      sum = sum + term;
    });
    return sum;
  };
  const Rational a(static_cast<long>(x.multiple)), b(static_cast<long>(y.multiple));
  for (const long sign : {1L, -1L})  // a A + sign b B = 2 r, 0 < A, B < 1; A = phi_s m/pi
    for (long r = 1 - static_cast<long>(y.multiple); 2 * r < static_cast<long>(x.multiple + y.multiple); ++r) {
      if (r % m == 0) continue;
      const Rational end = (Rational(2 * r) - (sign > 0 ? b : Rational(0))) / a;
      const Rational low = std::max(Rational(0), end);
      const Rational high = std::min(Rational(1), (Rational(2 * r) + (sign > 0 ? Rational(0) : b)) / a);
      if (!(low < high)) continue;
      for (long denominator = 3;; ++denominator) {
        const Rational first = low + (high - low) / Rational(denominator);
        const Rational second = Rational(sign) * (Rational(2 * r) - a * first) / b;
        std::vector<Polynomial> candidates;
        for (const auto& [p, e] : f.factors)
          if (at(p, first, second).enclose(256).contains_zero()) candidates.push_back(p);
        if (candidates.size() != 1) continue;
        if (std::find(found.begin(), found.end(), candidates[0]) == found.end()) found.push_back(candidates[0]);
        break;
      }
    }
  return found;
}

}  // namespace

SingularSet singular_set(const Space& space, int arity) {
  std::vector<std::pair<Node, Node>> pairs;
  const bool interpolating = has_interpolating_scheme(space, arity);
  const std::vector<Node> node = interpolating ? contact_nodes(space) : nodes(space);
  for (size_t i = 0; i < node.size(); ++i) {
    if (!interpolating) pairs.emplace_back(node[i], zero_node);
    for (size_t j = i; interpolating && j < node.size(); ++j) pairs.emplace_back(node[i], node[j]);
  }
  return zeros_of_pairs(space, pairs, arity);
}

SingularSet zeros_of_pairs(const Space& space, const std::vector<std::pair<Node, Node>>& pairs, int arity) {
  const auto m = static_cast<unsigned long>(arity);
  SingularSet s;
  if (space.variables().size() == 1) {
    std::set<std::pair<Rational, unsigned>> found;
    for (const auto& [x, y] : pairs)
      for (const unsigned n :
           {x.multiple + y.multiple, std::max(x.multiple, y.multiple) - std::min(x.multiple, y.multiple)}) {
        unsigned level = 0;
        for (unsigned long step = 2; step < n; step *= m, ++level)
          for (unsigned long r = 1; step * r < n; ++r)
            if (r % m != 0) found.emplace(Rational(static_cast<long>(step * r), static_cast<long>(n)), level);
      }
    for (const auto& [angle, level] : found) s.values.push_back({angle, level});
    std::sort(s.values.begin(), s.values.end(),
              [](const auto& a, const auto& b) { return a.angle != b.angle ? b.angle < a.angle : a.level < b.level; });
    return s;
  }
  const auto add = [&](const Polynomial& f) {
    if (std::find(s.conditions.begin(), s.conditions.end(), f) == s.conditions.end()) s.conditions.push_back(f);
  };
  for (const auto& [x, y] : pairs) {
    if (x.multiple == 0 && y.multiple == 0) continue;
    if (x.multiple != 0 && y.multiple != 0 && x.variable != y.variable) {
      for (const Polynomial& f : vanishing_factors(space, x, y, arity)) add(f);
      continue;
    }
    // One variable: the minimal polynomials of cos(2 pi/d); the largest zero has to exceed cos(pi/m).
    const std::string& name = space.variables()[x.multiple == 0 ? y.variable : x.variable].name;
    for (const unsigned long n :
         {static_cast<unsigned long>(x.multiple + y.multiple),
          static_cast<unsigned long>(std::max(x.multiple, y.multiple) - std::min(x.multiple, y.multiple))})
      for (unsigned long d = 2 * m + 1; n > 0 && d <= m * n; ++d)
        if ((m * n) % d == 0 && n % d != 0) add(Polynomial::cosine_minimal(name, static_cast<unsigned>(d)));
  }
  std::sort(s.conditions.begin(), s.conditions.end(),
            [](const auto& a, const auto& b) { return a.to_string() < b.to_string(); });
  return s;
}

}  // namespace twoscale
