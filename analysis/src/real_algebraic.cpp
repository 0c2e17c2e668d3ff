// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/analysis/real_algebraic.hpp"

#include <acb.h>
#include <arb.h>
#include <arb_fmpz_poly.h>

#include <algorithm>
#include <array>

#include "twoscale/symbolic/integer.hpp"

namespace twoscale::analysis {

namespace {

Rational from_arf(const arf_t x) {
  Rational r;
  arf_get_fmpq(r.raw(), x);
  return r;
}

// The next multiple of 2^-44 in that direction.
Rational rounded_out(const Rational& x, int direction) {
  const Rational unit(1, 1L << 44);
  const Rational steps = x / unit;
  Rational whole;
  if (direction < 0)
    fmpz_fdiv_q(fmpq_numref(whole.raw()), steps.numerator(), steps.denominator());
  else
    fmpz_cdiv_q(fmpq_numref(whole.raw()), steps.numerator(), steps.denominator());
  return whole * unit;
}

Polynomial integer_constant(const fmpz* n) {
  fmpz_t copy;
  fmpz_init_set(copy, n);
  Polynomial p = Polynomial::constant(copy);
  fmpz_clear(copy);
  return p;
}

// d x - n for the rational n/d.
Polynomial linear(const Rational& value) {
  return integer_constant(value.denominator()) * Polynomial::variable("x") - integer_constant(value.numerator());
}

// r^2 for the largest r with r^2 | n by small primes, n > 0: sqrt(n) = r sqrt(n/r^2).
std::pair<Rational, Rational> square_part(Rational n) {
  Rational outside = 1;
  for (long p = 2; p < 1000; ++p) {
    const Rational square(p * p);
    while ((n / square).is_integer()) {
      n /= square;
      outside *= Rational(p);
    }
  }
  return {outside, n};
}

// Text of s sqrt(d) added to a: "a + s*sqrt(d)" over one denominator.
std::string quadratic_text(const Rational& a, const Rational& s, const Rational& d) {
  const Rational size = abs(s);
  const std::string numerator = Rational(size.numerator()).to_string();
  const std::string denominator = Rational(size.denominator()).to_string();
  std::string root = (numerator == "1" ? "" : numerator + "*") + "sqrt(" + d.to_string() + ")";
  if (denominator != "1") root += "/" + denominator;
  if (a.is_zero()) return (s.sign() < 0 ? "-" : "") + root;
  return a.to_string() + (s.sign() < 0 ? " - " : " + ") + root;
}

}  // namespace

int sign_at(const Polynomial& p, const Rational& at) {
  const fmpz_poly_struct* view = p.univariate_view();
  Rational value;
  fmpz_poly_evaluate_fmpq(value.raw(), view, at.raw());
  return value.sign();
}

RealAlgebraic::RealAlgebraic(const Rational& value) : p_(linear(value)), lower_(value), upper_(value) {}

std::vector<RealAlgebraic> RealAlgebraic::zeros(const Polynomial& p) {
  std::vector<RealAlgebraic> list;
  if (p.is_constant()) return list;
  for (const auto& [factor, exponent] : p.factor().factors) {
    const fmpz_poly_struct* view = factor.univariate_view();
    const long degree = fmpz_poly_degree(view);
    if (degree == 1) {
      Rational value;
      fmpq_set_fmpz_frac(value.raw(), fmpz_poly_get_coeff_ptr(view, 0), fmpz_poly_get_coeff_ptr(view, 1));
      list.emplace_back(-value);
      continue;
    }
    std::vector<RealAlgebraic> found;
    acb_ptr roots = _acb_vec_init(degree);
    arb_fmpz_poly_complex_roots(roots, view, 0, 64);
    for (long i = 0; i < degree; ++i) {
      if (arb_is_zero(acb_imagref(roots + i)) == 0) continue;
      arf_t low;
      arf_t high;
      arf_init(low);
      arf_init(high);
      arb_get_lbound_arf(low, acb_realref(roots + i), 128);
      arb_get_ubound_arf(high, acb_realref(roots + i), 128);
      found.push_back(RealAlgebraic(Polynomial::univariate("x", view), from_arf(low), from_arf(high)));
      arf_clear(low);
      arf_clear(high);
    }
    for (size_t i = 0; i < found.size(); ++i) {
      // Short ends, where the neighbours leave room for them.
      const Rational low = rounded_out(found[i].lower_, -1);
      const Rational high = rounded_out(found[i].upper_, 1);
      const bool room = std::none_of(found.begin(), found.end(), [&](const RealAlgebraic& o) {
        return &o != &found[i] && o.lower_ <= high && low <= o.upper_;
      });
      list.push_back(room ? RealAlgebraic(found[i].p_, low, high) : found[i]);
    }
    _acb_vec_clear(roots, degree);
  }
  std::sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return compare(a, b) < 0; });
  return list;
}

RealAlgebraic RealAlgebraic::root_of_modulus(unsigned n) const {
  const bool negative = sign() < 0;
  if (n == 1 && !negative) return *this;
  // p(+-x^n), of which |*this|^(1/n) is the only zero whose n-th power is |*this|.
  const Polynomial power = Polynomial::variable("x").pow(n);
  Polynomial q = p_.substitute("x", negative ? -power : power);
  RealAlgebraic base = *this;
  const std::vector<RealAlgebraic> candidates = zeros(q);
  while (true) {
    const RealAlgebraic* found = nullptr;
    bool unique = true;
    Rational low = negative ? -base.upper_ : base.lower_;
    Rational high = negative ? -base.lower_ : base.upper_;
    for (const auto& c : candidates) {
      if (c.upper_.sign() <= 0) continue;
      RealAlgebraic fine = c;
      fine.refine(abs(high) / Rational(1L << 40));
      if (fine.upper_.pow(n) < low || fine.lower_.sign() <= 0 || fine.lower_.pow(n) > high) continue;
      unique = unique && found == nullptr;
      found = &c;
    }
    if (found != nullptr && unique) return *found;
    base.refine((base.upper_ - base.lower_) / Rational(1L << 20));
  }
}

std::optional<Rational> RealAlgebraic::rational() const {
  if (degree() == 1) return lower_;
  return std::nullopt;
}

long RealAlgebraic::degree() const { return p_.degree("x"); }

void RealAlgebraic::refine(const Rational& width) {
  if (degree() == 1) return;
  const int left = sign_at(p_, lower_);
  while (upper_ - lower_ > width) {
    const Rational middle = (lower_ + upper_) / Rational(2);
    (sign_at(p_, middle) == left ? lower_ : upper_) = middle;  // irreducible, degree > 1: no rational zero
  }
}

Ball RealAlgebraic::enclose(long bits) const {
  RealAlgebraic fine = *this;
  fine.refine(Rational(2).pow(-bits));
  Ball low(fine.lower_, bits + 8);
  const Ball high(fine.upper_, bits + 8);
  arb_union(low.raw(), low.raw(), high.raw(), bits + 8);
  return low;
}

double RealAlgebraic::estimate() const {
  const Ball b = enclose(80);
  return arf_get_d(arb_midref(b.raw()), ARF_RND_NEAR);
}

int RealAlgebraic::sign() const {
  if (degree() == 1) return lower_.sign();
  RealAlgebraic fine = *this;
  while (fine.lower_.sign() < 0 && fine.upper_.sign() > 0) fine.refine((fine.upper_ - fine.lower_) / Rational(4));
  return fine.lower_.sign() >= 0 ? 1 : -1;
}

int RealAlgebraic::compare(const RealAlgebraic& a, const RealAlgebraic& b) {
  if (a.p_ == b.p_ && a.degree() == 1) return 0;
  RealAlgebraic x = a;
  RealAlgebraic y = b;
  while (true) {
    if (x.upper_ < y.lower_) return -1;
    if (y.upper_ < x.lower_) return 1;
    if (x.p_ == y.p_) {
      // One zero in each interval; they are the same exactly if the intersection has it (its ends are no zeros).
      const Rational low = std::max(x.lower_, y.lower_);
      const Rational high = std::min(x.upper_, y.upper_);
      if (sign_at(x.p_, low) != sign_at(x.p_, high)) return 0;
    }
    x.refine((x.upper_ - x.lower_) / Rational(16));
    y.refine((y.upper_ - y.lower_) / Rational(16));
    if (x.degree() == 1 && y.degree() == 1) return x.lower_ < y.lower_ ? -1 : 1;
  }
}

bool operator==(const RealAlgebraic& a, const RealAlgebraic& b) {
  return a.p_ == b.p_ && RealAlgebraic::compare(a, b) == 0;
}

Rational rational_between(const RealAlgebraic& a, const RealAlgebraic& b) {
  RealAlgebraic low = a;
  RealAlgebraic high = b;
  while (!(low.upper() < high.lower())) {
    low.refine((low.upper() - low.lower()) / Rational(16));
    high.refine((high.upper() - high.lower()) / Rational(16));
  }
  // The dyadic number with the smallest denominator.
  for (Rational unit = 1;; unit /= Rational(2)) {
    const Rational steps = low.upper() / unit;
    Rational floor;
    fmpz_fdiv_q(fmpq_numref(floor.raw()), steps.numerator(), steps.denominator());
    const Rational candidate = (floor + Rational(1)) * unit;
    if (candidate < high.lower()) return candidate;
  }
}

std::optional<std::string> RealAlgebraic::expression() const {
  constexpr slong readable = 200;  // bits of a coefficient
  if (degree() > 1 && std::abs(fmpz_poly_max_bits(p_.univariate_view())) > readable) return std::nullopt;
  if (const auto q = rational()) return q->to_string();
  const fmpz_poly_struct* view = p_.univariate_view();
  const auto coefficient = [&](long i) { return Rational(fmpz_poly_get_coeff_ptr(view, i)); };
  // p(x) = q(x^n) with the largest n: then |x| is the n-th root of a zero of q.
  const long d = degree();
  unsigned long n = 0;
  for (long i = 0; i <= d; ++i) {
    if (coefficient(i).is_zero()) continue;
    unsigned long a = n;
    auto b = static_cast<unsigned long>(i);
    while (b != 0) a = std::exchange(b, a % b);
    n = a;
  }
  const long inner = d / static_cast<long>(n);
  if (inner > 2) return std::nullopt;
  const Rational a = coefficient(d);
  if (inner == 1) {
    const Rational value = -coefficient(0) / a;  // x^n = value
    if (n == 2) {
      const Rational radicand = value * Rational(a.numerator()) * Rational(a.numerator());  // (a x)^2
      const auto [outside, inside] = square_part(radicand);
      return quadratic_text(0, Rational(sign()) * outside / a, inside);
    }
    if (value.sign() < 0) return std::nullopt;
    return (sign() < 0 ? "-(" : "(") + value.to_string() + ")^(1/" + std::to_string(n) + ")";
  }
  const Rational b = coefficient(static_cast<long>(n));
  const Rational discriminant = b * b - Rational(4) * a * coefficient(0);
  const auto [outside, inside] = square_part(discriminant);
  const Rational centre = -b / (Rational(2) * a);
  const Rational half = outside / (Rational(2) * a);
  // Which of the two zeros y = x^n is.
  RealAlgebraic fine = *this;
  fine.refine(Rational(1, 1L << 30));
  for (long bits = 64;; bits *= 2) {
    Ball power = fine.enclose(bits);
    arb_pow_ui(power.raw(), power.raw(), n, bits);
    Ball c(centre, bits);
    arb_sub(c.raw(), power.raw(), c.raw(), bits);
    if (c.contains_zero()) continue;
    const int side = c.is_positive() == (half.sign() > 0) ? 1 : -1;
    std::string text = quadratic_text(centre, Rational(side) * half, inside);
    if (n == 1) return text;
    if (sign() < 0) return std::nullopt;
    return n == 2 ? "sqrt(" + text + ")" : "(" + text + ")^(1/" + std::to_string(n) + ")";
  }
}

}  // namespace twoscale::analysis
