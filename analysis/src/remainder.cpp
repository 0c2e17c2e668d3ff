// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/analysis/remainder.hpp"

#include <flint/fmpz_poly.h>

#include <algorithm>
#include <numeric>

#include "twoscale/analysis/positivity.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::analysis {

namespace {

using Coefficients = std::vector<Rational>;

// a/S_m, or nothing if that leaves a remainder. (1 - z) a = (1 - z^m) q.
std::optional<Coefficients> divided(const Coefficients& a, long m) {
  const auto n = static_cast<long>(a.size());
  if (n < m) return std::nullopt;
  Coefficients q(static_cast<size_t>(n));
  for (long i = 0; i < n; ++i) {
    Rational v = a[static_cast<size_t>(i)];
    if (i >= 1) v -= a[static_cast<size_t>(i - 1)];
    if (i >= m) v += q[static_cast<size_t>(i - m)];
    q[static_cast<size_t>(i)] = v;
  }
  for (long i = n - m + 1; i < n; ++i)
    if (!q[static_cast<size_t>(i)].is_zero()) return std::nullopt;
  q.resize(static_cast<size_t>(n - m + 1));
  return q;
}

Coefficients rational_coefficients(const Laurent& a) {
  Coefficients list;
  for (const auto& c : a.coefficients()) {
    const auto value = c.constant();
    if (!value) bad_input("a value is needed for the parameter", c.variables().front());
    list.push_back(*value);
  }
  return list;
}

Rational common_denominator_of(const Coefficients& list) {
  Rational d = 1;
  for (const auto& c : list) {
    const Rational den(c.denominator());
    d = d * den / gcd(d, den);
  }
  return d;
}

Polynomial integer_polynomial(Coefficients list, const char* name) {
  const Rational d = common_denominator_of(list);
  for (auto& c : list) c *= d;
  return Polynomial::univariate(name, list);
}

long euler_phi(long n) {
  long phi = n;
  long rest = n;
  for (long p = 2; p * p <= rest; ++p) {
    if (rest % p != 0) continue;
    while (rest % p == 0) rest /= p;
    phi -= phi / p;
  }
  return rest > 1 ? phi - phi / rest : phi;
}

Polynomial cyclotomic(long n) {
  fmpz_poly_t p;
  fmpz_poly_init(p);
  fmpz_poly_cyclotomic(p, static_cast<ulong>(n));
  Polynomial result = Polynomial::univariate("z", p);
  fmpz_poly_clear(p);
  return result;
}

}  // namespace

std::optional<Remainder> remainder(const Laurent& a, long arity, std::optional<long> order) {
  if (a.is_zero()) bad_input("the mask is zero");
  Remainder r;
  r.arity = arity;
  r.c = rational_coefficients(a);
  while (!order || r.order < *order) {
    auto q = divided(r.c, arity);
    if (!q) break;
    for (auto& c : *q) c *= Rational(arity);
    r.c = std::move(*q);
    ++r.order;
  }
  if (order && r.order < *order) return std::nullopt;
  return r;
}

Family transition_matrices(const Remainder& r) {
  const long m = r.arity;
  const long n0 = static_cast<long>(r.c.size()) - 1;
  const long size = std::max(1L, (n0 + m - 2) / (m - 1));
  Family family;
  for (long s = 0; s < m; ++s) {
    RationalMatrix b(size, size);
    for (long p = 0; p < size; ++p)
      for (long q = 0; q < size; ++q) {
        const long i = n0 + 1 - m + s + p - m * q;
        if (i >= 0 && i <= n0) b.set(p, q, r.c[static_cast<size_t>(i)]);
      }
    family.push_back(std::move(b));
  }
  return family;
}

CentralRadius central_radius(const std::vector<Rational>& g, long m) {
  const long h = static_cast<long>(g.size()) - 1;
  const long size = std::max(0L, h - 1) / (m - 1) + 1;
  const auto at = [&](long k) { return std::abs(k) <= h ? g[static_cast<size_t>(std::abs(k))] : Rational(0); };
  RationalMatrix central(size, size);
  for (long i = 0; i < size; ++i)
    for (long j = 0; j < size; ++j) central.set(i, j, j == 0 ? at(i) : at(i - m * j) + at(i + m * j));
  // The first linear relation between e_0, M e_0, M^2 e_0, ...
  std::vector<Rational> x(static_cast<size_t>(size));
  x[0] = 1;
  std::vector<std::vector<Rational>> krylov;
  while (true) {
    krylov.push_back(x);
    const RationalMatrix kernel = RationalMatrix::from_columns(size, krylov).kernel();
    if (kernel.columns() > 0) {
      Coefficients relation;
      for (long i = 0; i < kernel.rows(); ++i) relation.push_back(kernel(i, 0));
      const Polynomial minimal = integer_polynomial(relation, "x");
      const std::vector<RealAlgebraic> zeros = RealAlgebraic::zeros(minimal);
      if (zeros.empty()) throw Error(Error::Kind::undecided, "the central matrix has no real eigenvalue");
      CentralRadius result{zeros.back(), false};
      for (const auto& [factor, exponent] : minimal.factor().factors)
        if (factor == result.radius.polynomial()) result.simple = exponent == 1;
      return result;
    }
    x = central * x;
  }
}

std::optional<std::vector<Rational>> symmetric_half(const std::vector<Rational>& c) {
  if (c.size() % 2 == 0 || !std::equal(c.begin(), c.end(), c.rbegin())) return std::nullopt;
  return std::vector<Rational>(c.begin() + static_cast<long>(c.size() / 2), c.end());
}

std::vector<Rational> autocorrelation(const std::vector<Rational>& c) {
  std::vector<Rational> g(c.size());
  for (size_t k = 0; k < c.size(); ++k)
    for (size_t i = 0; i + k < c.size(); ++i) g[k] += c[i] * c[i + k];
  return g;
}

Polynomial cosine_polynomial(const std::vector<Rational>& g) {
  const Rational d = common_denominator_of(g);
  Polynomial p = 0;
  for (size_t k = 0; k < g.size(); ++k)
    p += Polynomial::chebyshev("x", static_cast<unsigned>(k)).scaled(g[k] * d * Rational(k == 0 ? 1 : 2));
  return p;
}

bool nonnegative_on_circle(const Polynomial& p) {
  if (p.is_constant()) return p.constant_value().sign() >= 0;
  SignOptions options;
  options.strict = false;
  return decide_sign(p, {{"x", Rational(-1), Rational(1)}}, options).verdict == Verdict::proved;
}

Stability shift_stability(const Laurent& a, long m) {
  const Coefficients c = rational_coefficients(a);
  const auto n = static_cast<long>(c.size());
  const auto residue = [&](long i) { return ((i + a.lowest()) % m + m) % m; };
  Stability result;
  // (i) sub-symbols; powers of z are units.
  Polynomial g = 0;
  for (long s = 0; s < m; ++s) {
    Coefficients sub;
    for (long i = 0; i < n; ++i)
      if (residue(i) == s) sub.push_back(c[static_cast<size_t>(i)]);
    // A sum over the coset in steps of m; leading zeros are units as well.
    const auto first = std::find_if(sub.begin(), sub.end(), [](const Rational& r) { return !r.is_zero(); });
    sub.erase(sub.begin(), first);
    if (!sub.empty()) g = Polynomial::gcd(g, integer_polynomial(sub, "z"));
  }
  if (!g.is_constant()) {
    Coefficients list;
    for (long i = 0; i <= g.degree("z"); ++i) list.emplace_back(fmpz_poly_get_coeff_ptr(g.univariate_view(), i));
    const Polynomial modulus = cosine_polynomial(autocorrelation(list));
    result.common_zero = !modulus.is_constant() && count_zeros(modulus, Rational(-1), Rational(1), Ends::closed) > 0;
  }
  // (ii) differences of the coset parts.
  Polynomial differences = 0;
  for (long s = 1; s < m; ++s) {
    Coefficients difference(static_cast<size_t>(n));
    for (long i = 0; i < n; ++i) {
      if (residue(i) == s) difference[static_cast<size_t>(i)] = c[static_cast<size_t>(i)];
      if (residue(i) == 0) difference[static_cast<size_t>(i)] = -c[static_cast<size_t>(i)];
    }
    differences = Polynomial::gcd(differences, integer_polynomial(difference, "z"));
  }
  const long degree = differences.is_zero() ? 0 : differences.degree("z");
  for (long order = 2; order <= 2 * degree * degree && result.cycle == 0; ++order) {
    if (std::gcd(order, m) != 1 || euler_phi(order) > degree) continue;
    if (Polynomial::quotient(differences, cyclotomic(order))) result.cycle = order;
  }
  result.stable = !result.common_zero && result.cycle == 0;
  return result;
}

}  // namespace twoscale::analysis
