// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/analysis/roots.hpp"

#include <arb_fmpz_poly.h>
#include <flint/fmpq_poly.h>
#include <flint/fmpz_poly.h>

#include <algorithm>

#include "twoscale/symbolic/ball.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/integer.hpp"

namespace twoscale::analysis {

namespace {

constexpr long first_bits = 64;
constexpr long most_bits = 1L << 16;
constexpr slong largest_degree = 240;  // of a polynomial whose roots decide an equality

struct IntegerPolynomial {
  fmpz_poly_t p;
  IntegerPolynomial() { fmpz_poly_init(p); }
  // The primitive multiple of a polynomial over Q.
  explicit IntegerPolynomial(const std::vector<Rational>& c) : IntegerPolynomial() {
    fmpq_poly_t q;
    fmpq_poly_init(q);
    for (std::size_t i = 0; i < c.size(); ++i) fmpq_poly_set_coeff_fmpq(q, static_cast<slong>(i), c[i].raw());
    fmpq_poly_get_numerator(p, q);
    fmpz_poly_primitive_part(p, p);
    fmpq_poly_clear(q);
  }
  IntegerPolynomial(const IntegerPolynomial&) = delete;
  IntegerPolynomial& operator=(const IntegerPolynomial&) = delete;
  ~IntegerPolynomial() { fmpz_poly_clear(p); }
};

void make_squarefree(fmpz_poly_t p) {
  IntegerPolynomial d;
  fmpz_poly_derivative(d.p, p);
  fmpz_poly_gcd(d.p, d.p, p);
  fmpz_poly_div(p, p, d.p);
}

Balls roots_of(const fmpz_poly_t p, long bits) {
  Balls b(static_cast<std::size_t>(fmpz_poly_degree(p)));
  if (b.size() > 0) arb_fmpz_poly_complex_roots(b[0], p, 0, bits);
  return b;
}

// Power sums s_1..s_count of the roots of a monic polynomial (Newton).
std::vector<Rational> power_sums(const std::vector<Rational>& p, std::size_t count) {
  const std::size_t n = p.size() - 1;
  std::vector<Rational> s(count + 1);
  for (std::size_t k = 1; k <= count; ++k) {
    Rational t = k <= n ? p[n - k] * Rational(static_cast<long>(k)) : Rational(0);
    for (std::size_t j = 1; j < k && j <= n; ++j) t += p[n - j] * s[k - j];
    s[k] = -t;
  }
  return s;
}

// The monic polynomial of degree n with these power sums (s[0] is not used).
std::vector<Rational> from_power_sums(const std::vector<Rational>& s, std::size_t n) {
  std::vector<Rational> p(n + 1);
  p[n] = 1;
  for (std::size_t k = 1; k <= n; ++k) {
    Rational t = s[k];
    for (std::size_t j = 1; j < k; ++j) t += p[n - j] * s[k - j];
    p[n - k] = -t / Rational(static_cast<long>(k));
  }
  return p;
}

Ball squared_modulus(const RootOf& a, long bits) {
  if (const auto r = a.roots->rational_modulus(a.index)) return Ball(*r, bits);
  const Balls& balls = a.roots->enclose(bits);
  Ball x, y;
  arb_sqr(x.raw(), acb_realref(balls[a.index]), bits);
  arb_sqr(y.raw(), acb_imagref(balls[a.index]), bits);
  arb_add(x.raw(), x.raw(), y.raw(), bits);
  return x;
}

// The one root ball that x meets, or size() if there are several.
std::size_t only_meeting(const Balls& balls, const Ball& x) {
  std::size_t found = balls.size();
  for (std::size_t i = 0; i < balls.size(); ++i) {
    if (!arb_contains_zero(acb_imagref(balls[i])) || !arb_overlaps(acb_realref(balls[i]), x.raw())) continue;
    if (found != balls.size()) return balls.size();
    found = i;
  }
  return found;
}

Rational bound(const arb_t x, bool upper, long bits) {
  arf_t a;
  arf_init(a);
  if (upper)
    arb_get_ubound_arf(a, x, bits);
  else
    arb_get_lbound_arf(a, x, bits);
  Rational r;
  arf_get_fmpq(r.raw(), a);
  arf_clear(a);
  return r;
}

std::array<Rational, 2> decimals_around(const arb_t x, long places, long bits) {
  if (arb_is_zero(x)) return {Rational(0), Rational(0)};
  const Rational scale = Rational(10).pow(places);
  const Rational low = bound(x, false, bits) * scale;
  const Rational high = bound(x, true, bits) * scale;
  Integer a, b;
  fmpz_fdiv_q(a.v, low.numerator(), low.denominator());
  fmpz_cdiv_q(b.v, high.numerator(), high.denominator());
  return {Rational(a.v) / scale, Rational(b.v) / scale};
}

bool disjoint(const std::array<Rational, 2>& a, const std::array<Rational, 2>& b) { return a[1] < b[0] || b[1] < a[0]; }

}  // namespace

Roots::Roots(std::vector<Rational> polynomial) : polynomial_(std::move(polynomial)) {
  const IntegerPolynomial p(polynomial_);
  Balls& balls = known_.emplace(first_bits, roots_of(p.p, first_bits)).first->second;
  imaginary_.assign(size(), false);
  // Roots of a polynomial in x^2 come in pairs a, -a; where -conj(a) meets no other ball than that of a, both are one.
  bool even = size() > 1;
  for (std::size_t i = 1; i < polynomial_.size(); i += 2) even = even && polynomial_[i].is_zero();
  if (!even) return;
  Balls mirror(1);
  for (std::size_t i = 0; i < size(); ++i) {
    if (is_real(i)) continue;
    acb_set(mirror[0], balls[i]);
    arb_neg(acb_realref(mirror[0]), acb_realref(mirror[0]));
    bool alone = true;
    for (std::size_t j = 0; j < size(); ++j) alone = alone && (j == i || acb_overlaps(mirror[0], balls[j]) == 0);
    if (!alone) continue;
    imaginary_[i] = true;
    arb_zero(acb_realref(balls[i]));
  }
}

bool Roots::is_real(std::size_t i) const { return arb_is_zero(acb_imagref(known_.begin()->second[i])) != 0; }

const Balls& Roots::enclose(long bits) const {
  if (const auto at = known_.lower_bound(bits); at != known_.end()) return at->second;
  const IntegerPolynomial p(polynomial_);
  const Balls& first = known_.begin()->second;
  Balls sorted(size());
  for (long target = bits;; target *= 2) {
    Balls fresh = roots_of(p.p, target);
    bool unique = true;
    std::vector<bool> filled(size(), false);
    for (std::size_t i = 0; i < size() && unique; ++i) {
      std::size_t at = size();
      for (std::size_t j = 0; j < size(); ++j) {
        if (acb_overlaps(fresh[i], first[j]) == 0) continue;
        unique = unique && at == size() && !filled[j];
        at = j;
      }
      if (!unique || at == size()) break;
      filled[at] = true;
      acb_swap(sorted[at], fresh[i]);
      if (imaginary_[at]) arb_zero(acb_realref(sorted[at]));
    }
    if (unique && std::find(filled.begin(), filled.end(), false) == filled.end()) break;
    if (target > most_bits) throw Error(Error::Kind::undecided, "roots of the characteristic polynomial are too close");
  }
  return known_.emplace(bits, std::move(sorted)).first->second;
}

std::string Roots::decimal(std::size_t i, long digits) const {
  if (size() == 1) return rounded_decimal(-polynomial_[0], digits);
  const auto part = [&](bool imaginary) {
    // A tie of the last digit (the real part can be a rational number) is never decided: then a digit less.
    for (long d = digits; d > 0; --d)
      for (long bits = 4 * d + first_bits; bits <= 4096; bits *= 4) {
        const Balls& balls = enclose(bits);
        Ball x;
        arb_set(x.raw(), imaginary ? acb_imagref(balls[i]) : acb_realref(balls[i]));
        if (const std::string text = rounded_decimal(x, d); !text.empty()) return text;
      }
    throw Error(Error::Kind::undecided, "an eigenvalue could not be evaluated to the precision asked for");
  };
  if (is_real(i)) return part(false);
  std::string im = part(true);
  const bool negative = im[0] == '-';
  if (negative) im.erase(0, 1);
  if (imaginary_[i]) return (negative ? "-" : "") + im + "*I";
  return part(false) + (negative ? " - " : " + ") + im + "*I";
}

Roots::Box Roots::isolate(std::size_t i) const {
  for (long places = 20;; places += 20) {
    const long bits = 4 * places + first_bits;
    const Balls& balls = enclose(bits);
    const auto box = [&](std::size_t j) {
      return Box{decimals_around(acb_realref(balls[j]), places, bits),
                 decimals_around(acb_imagref(balls[j]), places, bits)};
    };
    const Box mine = box(i);
    bool alone = true;
    for (std::size_t j = 0; j < size(); ++j)
      alone = alone && (j == i || disjoint(mine.real, box(j).real) || disjoint(mine.imaginary, box(j).imaginary));
    if (alone) return mine;
    if (places > most_bits / 4) throw Error(Error::Kind::undecided, "roots are too close to be isolated");
  }
}

std::optional<Rational> Roots::rational_modulus(std::size_t i) const {
  if (size() == 1) return polynomial_[0] * polynomial_[0];
  if (size() == 2 && !is_real(i)) return polynomial_[0];
  return std::nullopt;
}

const std::vector<Rational>& Roots::modulus_polynomial(std::size_t i) const {
  const std::size_t n = size();
  if (is_real(i)) {
    if (squares_.empty()) {
      const auto s = power_sums(polynomial_, 2 * n);
      std::vector<Rational> t(n + 1);
      for (std::size_t k = 1; k <= n; ++k) t[k] = s[2 * k];
      squares_ = from_power_sums(t, n);
    }
    return squares_;
  }
  if (products_.empty()) {
    const std::size_t pairs = n * (n - 1) / 2;
    const auto s = power_sums(polynomial_, 2 * pairs);
    std::vector<Rational> t(pairs + 1);
    for (std::size_t k = 1; k <= pairs; ++k) t[k] = (s[k] * s[k] - s[2 * k]) / Rational(2);
    products_ = from_power_sums(t, pairs);
  }
  return products_;
}

namespace {

std::size_t modulus_degree(const RootOf& a) {
  const std::size_t n = a.roots->size();
  return a.roots->is_real(a.index) ? n : n * (n - 1) / 2;
}

// The balls decide, or the precision is exhausted.
std::optional<std::strong_ordering> by_balls(const RootOf& a, const RootOf& b, long bits) {
  const Ball x = squared_modulus(a, bits);
  const Ball y = squared_modulus(b, bits);
  if (arb_lt(x.raw(), y.raw())) return std::strong_ordering::less;
  if (arb_gt(x.raw(), y.raw())) return std::strong_ordering::greater;
  return std::nullopt;
}

}  // namespace

std::optional<std::strong_ordering> compare_moduli(const RootOf& a, const RootOf& b) {
  const auto r = a.roots->rational_modulus(a.index);
  const auto q = b.roots->rational_modulus(b.index);
  if (r && q) return *r <=> *q;
  if (const auto order = by_balls(a, b, first_bits)) return order;
  if (const auto order = by_balls(a, b, 4 * first_bits)) return order;
  if (a.roots == b.roots) {
    if (a.index == b.index) return std::strong_ordering::equal;
    const Balls& balls = a.roots->enclose(first_bits);
    acb_t conjugate;
    acb_init(conjugate);
    acb_conj(conjugate, balls[a.index]);
    bool only = acb_overlaps(conjugate, balls[b.index]) != 0;
    for (std::size_t j = 0; j < balls.size(); ++j) only = only && (j == b.index || !acb_overlaps(conjugate, balls[j]));
    acb_clear(conjugate);
    if (only) return std::strong_ordering::equal;
  }
  if (modulus_degree(a) + modulus_degree(b) > static_cast<std::size_t>(largest_degree)) return std::nullopt;
  const auto polynomial = [](const RootOf& x, const std::optional<Rational>& rational) {
    return rational ? std::vector<Rational>{-*rational, Rational(1)} : x.roots->modulus_polynomial(x.index);
  };
  IntegerPolynomial p(polynomial(a, r));
  const IntegerPolynomial p2(polynomial(b, q));
  IntegerPolynomial common;
  fmpz_poly_gcd(common.p, p.p, p2.p);
  if (fmpz_poly_degree(common.p) == 0) {  // they are different: precision decides in the end
    for (long bits = 16 * first_bits; bits <= most_bits; bits *= 2)
      if (const auto order = by_balls(a, b, bits)) return order;
    return std::nullopt;
  }
  fmpz_poly_mul(p.p, p.p, p2.p);
  make_squarefree(p.p);
  const Balls roots = roots_of(p.p, 4 * first_bits);
  for (long bits = 4 * first_bits; bits <= most_bits; bits *= 2) {
    const std::size_t i = only_meeting(roots, squared_modulus(a, bits));
    const std::size_t j = only_meeting(roots, squared_modulus(b, bits));
    if (i < roots.size() && i == j) return std::strong_ordering::equal;
    if (const auto order = by_balls(a, b, bits)) return order;
  }
  return std::nullopt;
}

std::optional<std::strong_ordering> compare_modulus(const RootOf& a, const Rational& r) {
  const Roots linear({-r, Rational(1)});
  return compare_moduli(a, {&linear, 0});
}

}  // namespace twoscale::analysis
