// SPDX-License-Identifier: GPL-3.0-or-later
// Exact rational numbers: a value type over FLINT's fmpq.
#pragma once

#include <flint/fmpq.h>
#include <flint/fmpz.h>

#include <compare>
#include <string>
#include <string_view>

namespace twoscale {

// A rational number in lowest terms.
class Rational {
 public:
  Rational() { fmpq_init(value_); }
  Rational(long n) : Rational() { fmpq_set_si(value_, n, 1); }  // NOLINT: numbers convert
  Rational(int n) : Rational(static_cast<long>(n)) {}           // NOLINT
  // numerator / denominator; denominator must not be 0.
  Rational(long numerator, long denominator);
  explicit Rational(const fmpz_t n) : Rational() { fmpz_set(fmpq_numref(value_), n); }
  explicit Rational(const fmpq_t q) : Rational() { fmpq_set(value_, q); }
  Rational(const Rational& o) : Rational() { fmpq_set(value_, o.value_); }
  Rational(Rational&& o) noexcept : Rational() { fmpq_swap(value_, o.value_); }
  Rational& operator=(Rational o) noexcept {
    fmpq_swap(value_, o.value_);
    return *this;
  }
  ~Rational() { fmpq_clear(value_); }

  // "-3", "2/5"; throws Error(bad_input) on anything else.
  static Rational parse(std::string_view text);
  // n! / (k! (n-k)!) for rational n: the generalised binomial coefficient.
  static Rational binomial(const Rational& n, unsigned k);

  const fmpq* raw() const { return value_; }
  fmpq* raw() { return value_; }
  const fmpz* numerator() const { return fmpq_numref(value_); }
  const fmpz* denominator() const { return fmpq_denref(value_); }

  bool is_zero() const { return fmpq_is_zero(value_) != 0; }
  bool is_integer() const { return fmpz_is_one(fmpq_denref(value_)) != 0; }
  int sign() const { return fmpq_sgn(value_); }
  // The value as a long; throws Error(bad_input) if it is not an integer that fits.
  long to_long() const;
  std::string to_string() const;
  Rational inverse() const;
  Rational pow(long exponent) const;

  friend Rational operator+(const Rational& a, const Rational& b);
  friend Rational operator-(const Rational& a, const Rational& b);
  friend Rational operator*(const Rational& a, const Rational& b);
  friend Rational operator/(const Rational& a, const Rational& b);
  Rational operator-() const;
  Rational& operator+=(const Rational& o) { return *this = *this + o; }
  Rational& operator-=(const Rational& o) { return *this = *this - o; }
  Rational& operator*=(const Rational& o) { return *this = *this * o; }
  Rational& operator/=(const Rational& o) { return *this = *this / o; }
  friend bool operator==(const Rational& a, const Rational& b) { return fmpq_equal(a.value_, b.value_) != 0; }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
    return fmpq_cmp(a.value_, b.value_) <=> 0;
  }

 private:
  fmpq_t value_;
};

// Greatest common divisor of rationals: the largest g > 0 with a/g and b/g integers (gcd(0,b) = |b|).
Rational gcd(const Rational& a, const Rational& b);
Rational abs(const Rational& a);

}  // namespace twoscale
