// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/symbolic/nulifs.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>

#include "twoscale/symbolic/error.hpp"

namespace twoscale {

namespace {

long floor_half(long m) { return m >= 0 ? m / 2 : -((1 - m) / 2); }

template <class T>
T quotient_or_zero(const T& a, const T& b) {
  return b.is_zero() ? T(0) : a / b;
}

// The splines of the data sets f(x_i) = delta_{i,centre}, through the coefficients of their B-splines. One object is
// for one point x (piece, values): what does not depend on the centre is computed once.
template <class T>
class Splines {
 public:
  Splines(const Knots<T>& t, const FundamentalFamily& family) : t_(t), f_(family) {
    const long n = family.order;
    tau_ = n == 3 ? 0 : std::min<long>(family.mu, n - 3);
    sigma_ = n == 3 ? static_cast<long>(family.mu) : static_cast<long>(family.mu) - tau_ + 1;
  }

  // u_{rho,2 sigma,i}(x) = sum_m a_{i,m-2i} N_m(x), values[r] = N_{piece-n+1+r}(x).
  T quasi_interpolant(long i, long piece, const std::vector<T>& values) const {
    T sum(0);
    for (long r = 0; r < static_cast<long>(f_.order); ++r) {
      const long m = piece - static_cast<long>(f_.order) + 1 + r;
      if (values[static_cast<std::size_t>(r)].is_zero() || !sees(m, i)) continue;
      sum += coefficient(i, m) * values[static_cast<std::size_t>(r)];
    }
    return sum;
  }

  // v_{rho,mu,i}(x).
  T fundamental(long i, long piece, const std::vector<T>& values) const {
    if (f_.order == 3) return quasi_interpolant(i, piece, values);
    T sum = quasi_interpolant(i, piece, values);
    if (const T& own = local(i, piece, values); !own.is_zero()) sum += own;
    for (long k = 1; k <= static_cast<long>(f_.order / 2 + f_.reproduction) - 1; ++k) {
      const long q = i - sigma_ + k;
      const T& l = local(q, piece, values);
      if (!l.is_zero()) sum -= quasi_interpolant(i, vertex_piece(q), vertex_values(q)) * l;
    }
    return sum;
  }

  // The coefficients of v_{rho,mu,i} in B-splines, (2.4), (2.6), (2.7).
  SplineCoefficients<T> coefficients(long i) const {
    const auto rho = static_cast<long>(f_.reproduction);
    const long width = static_cast<long>(f_.order / 2) + rho;  // of the sum in (2.6)
    SplineCoefficients<T> c;
    c.lowest = 2 * (i - sigma_ - tau_);
    c.values.assign(static_cast<std::size_t>(2 * (sigma_ + tau_ + width + rho) + static_cast<long>(f_.order)), T(0));
    const auto at = [&](long m) -> T& { return c.values.at(static_cast<std::size_t>(m - c.lowest)); };
    for (long m = 2 * (i - sigma_); m <= 2 * (i - sigma_ + rho) - 1; ++m) at(m) += coefficient(i, m);
    if (f_.order == 3) return c;
    const auto add_local = [&](long q, const T& factor) {
      const std::vector<T> b = local_coefficients(q);
      for (std::size_t k = 0; k < b.size(); ++k) at(2 * (q - tau_) + static_cast<long>(k)) += factor * b[k];
    };
    add_local(i, T(1));
    for (long q = i - sigma_ + 1; q < i - sigma_ + width; ++q) {
      const T u = quasi_interpolant(i, vertex_piece(q), vertex_values(q));
      if (!u.is_zero()) add_local(q, -u);
    }
    return c;
  }

 private:
  // The coefficient functional of N_m reads x_{r+sigma-rho+1} .. x_{r+sigma}, r = floor(m/2).
  bool sees(long m, long i) const {
    const long last = floor_half(m) + sigma_;
    return i <= last && i > last - static_cast<long>(f_.reproduction);
  }

  // a_{i,m-2i}: the coefficient of N_m in the Lagrange polynomial of x_i among the points that N_m sees, that is its
  // blossom at t_{m+1} .. t_{m+n-1}, which is what (2.5) says after the derivatives are carried out.
  T coefficient(long i, long m) const {
    const long last = floor_half(m) + sigma_;
    const auto rho = static_cast<long>(f_.reproduction);
    // Elementary symmetric functions of the knots (relative to x_i), over binomials: the blossoms of the powers.
    const long n = f_.order;
    std::vector<T> symmetric(static_cast<std::size_t>(n), T(0));
    symmetric[0] = T(1);
    for (long q = 1; q < n; ++q) {
      const T t = t_(m + q) - t_.x(i);
      for (long k = q; k >= 1; --k)
        symmetric[static_cast<std::size_t>(k)] += t * symmetric[static_cast<std::size_t>(k - 1)];
    }
    // The numerator prod (y - x_l), ascending in y (relative to x_i).
    std::vector<T> p{T(1)};
    T denominator(1);
    for (long l = last - rho + 1; l <= last; ++l) {
      if (l == i) continue;
      const T root = t_.x(l) - t_.x(i);
      denominator *= -root;
      p.emplace_back(0);
      for (std::size_t k = p.size() - 1; k > 0; --k) p[k] = p[k - 1] - root * p[k];
      p[0] = -root * p[0];
    }
    T sum(0);
    Rational binomial(1);  // C(n-1, k)
    for (long k = 0; k < std::min<long>(n, static_cast<long>(p.size())); ++k) {
      sum += p[static_cast<std::size_t>(k)] * symmetric[static_cast<std::size_t>(k)] * T(binomial.inverse());
      binomial = binomial * Rational(n - 1 - k, k + 1);
    }
    return sum / denominator;
  }

  // The piece [t_piece, t_{piece+1}] that is used at x_q: not empty, its right end not before x_q.
  long vertex_piece(long q) const {
    long piece = 2 * q;
    while ((t_(piece + 1) - t_(piece)).is_zero()) ++piece;
    return piece;
  }
  const std::vector<T>& vertex_values(long q) const {
    const auto known = vertex_values_.find(q);
    if (known != vertex_values_.end()) return known->second;
    return vertex_values_.emplace(q, bspline_values(t_, f_.order, t_.x(q), vertex_piece(q))).first->second;
  }
  static T value_of(long m, long piece, const std::vector<T>& values) {
    const long r = m - piece + static_cast<long>(values.size()) - 1;
    return r < 0 || r >= static_cast<long>(values.size()) ? T(0) : values[static_cast<std::size_t>(r)];
  }

  // l_{n,tau,i}(x), (2.7): from N_{2i-2tau} .. N_{2i-2tau+n-4}, 1 at x_i, 0 at the others of x_{i-tau+1} ..
  // x_{i-tau+n-3}.
  const T& local(long i, long piece, const std::vector<T>& values) const {
    const auto known = locals_.find(i);
    if (known != locals_.end()) return known->second;
    return locals_.emplace(i, compute_local(i, piece, values)).first->second;
  }
  T compute_local(long i, long piece, const std::vector<T>& values) const {
    const long size = static_cast<long>(f_.order) - 3;
    std::vector<T> row;
    bool within = false;
    for (long c = 0; c < size; ++c) {
      row.push_back(value_of(2 * (i - tau_) + c, piece, values));
      within = within || !row.back().is_zero();
    }
    if (!within) return T(0);
    const std::vector<std::vector<T>> a = local_matrix(i);
    return with_row(a, std::move(row)) / determinant(a);
  }

  // Its B-spline coefficients: the same quotients for each N alone.
  std::vector<T> local_coefficients(long i) const {
    const std::size_t size = f_.order - 3;
    const std::vector<std::vector<T>> a = local_matrix(i);
    const T whole = determinant(a);
    std::vector<T> result;
    for (std::size_t c = 0; c < size; ++c) {
      std::vector<T> unit(size, T(0));
      unit[c] = T(1);
      result.push_back(with_row(a, std::move(unit)) / whole);
    }
    return result;
  }

  // A_{n,tau,i}: the values of these B-splines, a row for each of the vertices.
  std::vector<std::vector<T>> local_matrix(long i) const {
    const long size = static_cast<long>(f_.order) - 3;
    std::vector<std::vector<T>> a;
    for (long q = i - tau_ + 1; q <= i - tau_ + size; ++q) {
      const std::vector<T>& values = vertex_values(q);
      std::vector<T> row;
      for (long c = 0; c < size; ++c) row.push_back(value_of(2 * (i - tau_) + c, vertex_piece(q), values));
      a.push_back(std::move(row));
    }
    return a;
  }

  // The determinant with another row for x_i.
  T with_row(std::vector<std::vector<T>> a, std::vector<T> row) const {
    a[static_cast<std::size_t>(tau_ - 1)] = std::move(row);
    return determinant(std::move(a));
  }

  static T determinant(std::vector<std::vector<T>> a) {
    T result(1);
    for (std::size_t k = 0; k < a.size(); ++k) {
      std::size_t pivot = k;
      while (pivot < a.size() && a[pivot][k].is_zero()) ++pivot;
      if (pivot == a.size()) return T(0);
      if (pivot != k) {
        std::swap(a[pivot], a[k]);
        result = -result;
      }
      result *= a[k][k];
      for (std::size_t r = k + 1; r < a.size(); ++r) {
        if (a[r][k].is_zero()) continue;
        const T factor = a[r][k] / a[k][k];
        for (std::size_t c = k; c < a.size(); ++c) a[r][c] -= factor * a[k][c];
      }
    }
    return result;
  }

  const Knots<T>& t_;
  FundamentalFamily f_;
  long tau_ = 0;
  long sigma_ = 0;
  mutable std::map<long, std::vector<T>> vertex_values_;  // N(x_q)
  mutable std::map<long, T> locals_;                      // l_q(x)
};

}  // namespace

FundamentalFamily FundamentalFamily::symmetric(unsigned order) {
  FundamentalFamily f{order, order, 2};
  if (order == 3) return f;
  if ((3 * order / 2 + f.reproduction) % 2 != 0) --f.reproduction;
  f.mu = (3 * order / 2 + f.reproduction - 4) / 2;
  return f;
}

void FundamentalFamily::validate() const {
  const auto refuse = [](const char* what, unsigned value) { bad_input(what, std::to_string(value)); };
  if (order < 3 || order > 64) refuse("fundamental splines: the order n must be from 3 to 64", order);
  if (reproduction < 1 || reproduction > order)
    refuse("fundamental splines: rho must be from 1 to the order", reproduction);
  const long n = order;
  const long rho = reproduction;
  const long most = std::max(n + rho - 3, 3 * n / 2 + rho - 5);
  if (mu < 1 || mu > most)
    bad_input("fundamental splines: mu must be from 1 to " + std::to_string(most), std::to_string(mu));
}

long FundamentalFamily::right() const {
  const long width = order == 3 ? static_cast<long>(reproduction) + 1
                                : static_cast<long>(3 * order / 2) + static_cast<long>(reproduction) - 4;
  return width - static_cast<long>(mu);
}

template <class T>
Knots<T>::Knots(long first_edge, std::vector<T> d, std::vector<T> lambda) : first_(first_edge) {
  const long edges = static_cast<long>(d.size());
  if (lambda.size() != d.size() || first_edge > 0 || first_edge + edges < 0)
    throw std::logic_error("Knots: sizes do not fit");
  T x(0);
  for (long i = first_edge; i < 0; ++i) x -= d[static_cast<std::size_t>(i - first_edge)];
  for (std::size_t e = 0; e < d.size(); ++e) {
    t_.push_back(x);
    t_.push_back(x + lambda[e] * d[e]);
    x += d[e];
  }
  t_.push_back(x);
}

template <class T>
const T& Knots<T>::operator()(long m) const {
  return t_.at(static_cast<std::size_t>(m - 2 * first_));
}

template <class T>
T Knots<T>::middle(long edge) const {
  return (x(edge) + x(edge + 1)) * T(Rational(1, 2));
}

template <class T>
std::vector<T> bspline_values(const Knots<T>& t, unsigned order, const T& x, long piece) {
  // Order k from order k-1: N_{k,m} = (x - t_m)/(t_{m+k-1} - t_m) N_{k-1,m} + (t_{m+k} - x)/(t_{m+k} - t_{m+1})
  // N_{k-1,m+1}; v[r] = N_{k,piece-k+1+r}.
  std::vector<T> v{T(1)};
  for (long k = 2; k <= static_cast<long>(order); ++k) {
    std::vector<T> next(static_cast<std::size_t>(k), T(0));
    for (long r = 0; r + 1 < k; ++r) {
      const long m = piece - (k - 1) + 1 + r;  // N_{k-1,m}
      const T share = quotient_or_zero(v[static_cast<std::size_t>(r)], t(m + k - 1) - t(m));
      next[static_cast<std::size_t>(r)] += share * (t(m + k - 1) - x);
      next[static_cast<std::size_t>(r + 1)] += share * (x - t(m));
    }
    v = std::move(next);
  }
  return v;
}

template <class T>
std::vector<T> fundamental_values(const Knots<T>& t, const FundamentalFamily& family, const T& x, long piece) {
  family.validate();
  const Splines<T> splines(t, family);
  const std::vector<T> values = bspline_values(t, family.order, x, piece);
  std::vector<T> result;
  for (long i = t.first_vertex(); i <= t.last_vertex(); ++i) {
    // Outside the support nothing is looked at, so the knots there need not exist.
    const bool outside =
        floor_half(piece) < i - static_cast<long>(family.mu) || floor_half(piece) >= i + family.right();
    result.push_back(outside ? T(0) : splines.fundamental(i, piece, values));
  }
  return result;
}

template <class T>
SplineCoefficients<T> spline_coefficients(const Knots<T>& t, const FundamentalFamily& family, long i) {
  family.validate();
  return Splines<T>(t, family).coefficients(i);
}

template <class T>
std::vector<T> sampled_rule(const FundamentalFamily& family, long first_edge, const std::vector<T>& d,
                            const std::vector<T>& lambda, bool upper) {
  family.validate();
  const long reach = static_cast<long>(family.order) + static_cast<long>(family.mu) + std::max(family.right(), 2L) + 2;
  std::vector<T> all_d, all_lambda;
  for (long e = -reach; e <= reach; ++e) {
    const long at = e - first_edge;
    all_d.push_back(at >= 0 && at < static_cast<long>(d.size()) ? d[static_cast<std::size_t>(at)] : T(1));
    all_lambda.push_back(at >= 0 && at < static_cast<long>(lambda.size()) ? lambda[static_cast<std::size_t>(at)]
                                                                          : T(Rational(1, 2)));
  }
  const Knots<T> t(-reach, all_d, all_lambda);
  const std::vector<T> all = fundamental_values(t, family, t.middle(0), upper ? 0L : 1L);
  std::vector<T> rule;
  for (long i = 1 - family.right(); i <= static_cast<long>(family.mu); ++i)
    rule.push_back(all[static_cast<std::size_t>(i - t.first_vertex())]);
  return rule;
}

template class Knots<Rational>;
template class Knots<RationalFunction>;
template std::vector<Rational> bspline_values(const Knots<Rational>&, unsigned, const Rational&, long);
template std::vector<RationalFunction> bspline_values(const Knots<RationalFunction>&, unsigned, const RationalFunction&,
                                                      long);
template std::vector<Rational> fundamental_values(const Knots<Rational>&, const FundamentalFamily&, const Rational&,
                                                  long);
template std::vector<RationalFunction> fundamental_values(const Knots<RationalFunction>&, const FundamentalFamily&,
                                                          const RationalFunction&, long);
template SplineCoefficients<Rational> spline_coefficients(const Knots<Rational>&, const FundamentalFamily&, long);
template SplineCoefficients<RationalFunction> spline_coefficients(const Knots<RationalFunction>&,
                                                                  const FundamentalFamily&, long);
template std::vector<Rational> sampled_rule(const FundamentalFamily&, long, const std::vector<Rational>&,
                                            const std::vector<Rational>&, bool);
template std::vector<RationalFunction> sampled_rule(const FundamentalFamily&, long,
                                                    const std::vector<RationalFunction>&,
                                                    const std::vector<RationalFunction>&, bool);

RationalFunction quadratic_blend(const RationalFunction& lambda, bool upper) {
  const RationalFunction one(1);
  return upper ? one - (one - lambda) / (RationalFunction(2) * lambda)
               : lambda / (RationalFunction(2) * (one - lambda));
}

RationalFunction auxiliary_factor(const RationalFunction& m, bool upper) {
  return upper ? (RationalFunction(7) * m * m - RationalFunction(5) * m + RationalFunction(1)) / m
               : m * m / (RationalFunction(1) - m);
}

RationalFunction cubic_blend(const RationalFunction& a, const RationalFunction& b, const RationalFunction& k,
                             const RationalFunction& m, bool upper) {
  if (m.is_zero()) return 0;  // the limit, also where the denominator vanishes (k = 0)
  return a * (a * k + b) * auxiliary_factor(m, upper) /
         (RationalFunction(3) * (RationalFunction(2) * a + b) * (k * m * (a + b) + k * a + m * b));
}

}  // namespace twoscale
