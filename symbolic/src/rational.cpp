// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/symbolic/rational.hpp"

#include <algorithm>

#include "twoscale/symbolic/error.hpp"

namespace twoscale {

namespace {

std::string take(char* text) {
  std::string s(text);
  flint_free(text);
  return s;
}

}  // namespace

Rational::Rational(long numerator, long denominator) : Rational() {
  if (denominator == 0) bad_input("division by zero");
  fmpz_set_si(fmpq_numref(value_), numerator);
  fmpz_set_si(fmpq_denref(value_), denominator);
  fmpq_canonicalise(value_);
}

Rational Rational::parse(std::string_view text) {
  const std::string s(text);
  const auto slash = s.find('/');
  const auto digits = [](std::string_view d) {
    return !d.empty() && d.size() <= 200000 &&
           std::all_of(d.begin(), d.end(), [](char c) { return c >= '0' && c <= '9'; });
  };
  const std::string head = s.substr(0, slash);
  const bool good = digits(head.starts_with('-') ? std::string_view(head).substr(1) : std::string_view(head)) &&
                    (slash == std::string::npos || digits(std::string_view(s).substr(slash + 1)));
  if (!good) bad_input("not a rational number", s);
  Rational r;
  fmpz_set_str(fmpq_numref(r.value_), head.c_str(), 10);
  if (slash != std::string::npos) fmpz_set_str(fmpq_denref(r.value_), s.c_str() + slash + 1, 10);
  if (fmpz_is_zero(fmpq_denref(r.value_))) {
    fmpz_one(fmpq_denref(r.value_));
    bad_input("division by zero", s);
  }
  fmpq_canonicalise(r.value_);
  return r;
}

Rational Rational::binomial(const Rational& n, unsigned k) {
  Rational r(1);
  if (n.is_integer() && n.sign() >= 0 && fmpz_abs_fits_ui(n.numerator())) {
    fmpz_bin_uiui(fmpq_numref(r.value_), fmpz_get_ui(n.numerator()), k);
    return r;
  }
  for (unsigned i = 0; i < k; ++i) r = r * (n - Rational(static_cast<long>(i))) / Rational(static_cast<long>(i) + 1);
  return r;
}

long Rational::to_long() const {
  if (!is_integer() || !fmpz_fits_si(numerator())) bad_input("not a small integer", to_string());
  return fmpz_get_si(numerator());
}

std::string Rational::to_string() const { return take(fmpq_get_str(nullptr, 10, value_)); }

Rational Rational::inverse() const { return Rational(1) / *this; }

Rational Rational::pow(long exponent) const {
  if (exponent < 0 && is_zero()) bad_input("division by zero");
  Rational r;
  fmpq_pow_si(r.value_, value_, exponent);
  return r;
}

Rational operator+(const Rational& a, const Rational& b) {
  Rational r;
  if (a.is_integer() && b.is_integer())
    fmpz_add(fmpq_numref(r.value_), a.numerator(), b.numerator());
  else
    fmpq_add(r.value_, a.value_, b.value_);
  return r;
}

Rational operator-(const Rational& a, const Rational& b) {
  Rational r;
  if (a.is_integer() && b.is_integer())
    fmpz_sub(fmpq_numref(r.value_), a.numerator(), b.numerator());
  else
    fmpq_sub(r.value_, a.value_, b.value_);
  return r;
}

Rational operator*(const Rational& a, const Rational& b) {
  Rational r;
  if (a.is_integer() && b.is_integer())
    fmpz_mul(fmpq_numref(r.value_), a.numerator(), b.numerator());
  else
    fmpq_mul(r.value_, a.value_, b.value_);
  return r;
}

Rational operator/(const Rational& a, const Rational& b) {
  if (b.is_zero()) bad_input("division by zero");
  Rational r;
  fmpq_div(r.value_, a.value_, b.value_);
  return r;
}

Rational Rational::operator-() const {
  Rational r;
  fmpq_neg(r.value_, value_);
  return r;
}

Rational gcd(const Rational& a, const Rational& b) {
  Rational r;
  fmpq_gcd(r.raw(), a.raw(), b.raw());
  return r;
}

Rational abs(const Rational& a) { return a.sign() < 0 ? -a : a; }

}  // namespace twoscale
