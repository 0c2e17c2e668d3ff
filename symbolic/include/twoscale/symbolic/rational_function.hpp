// SPDX-License-Identifier: GPL-3.0-or-later
// Rational functions over Q in named variables, in canonical form with a factored denominator.
//
// numerator / (denominator_content * prod factor^exponent): the factors are irreducible, primitive, with positive
// leading coefficient, sorted, and none divides the numerator; denominator_content > 0 is prime to the numerator's
// content. The form is unique, so equality is equality of representations. Denominators stay factored because those of
// subdivision symbols are products of few small factors (w_i + w_j, 1 + w_i): sums never need a polynomial gcd.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "twoscale/symbolic/polynomial.hpp"

namespace twoscale {

class RationalFunction {
 public:
  using Factors = std::vector<std::pair<Polynomial, unsigned>>;

  RationalFunction() = default;                                 // 0
  RationalFunction(long n) : numerator_(n) {}                   // NOLINT: numbers convert
  RationalFunction(int n) : numerator_(n) {}                    // NOLINT
  RationalFunction(const Rational& r);                          // NOLINT
  RationalFunction(Polynomial p) : numerator_(std::move(p)) {}  // NOLINT
  static RationalFunction variable(const std::string& name) { return Polynomial::variable(name); }
  // numerator / denominator; factors the denominator. Throws Error(bad_input) if it is 0.
  static RationalFunction fraction(const Polynomial& numerator, const Polynomial& denominator);
  // numerator / (content * prod factors) where the caller knows the irreducible factors (any order, no duplicates);
  // content != 0. Cancels what can be cancelled.
  static RationalFunction over_factors(Polynomial numerator, const Rational& content, Factors factors);

  const Polynomial& numerator() const { return numerator_; }
  const Rational& denominator_content() const { return content_; }
  const Factors& denominator_factors() const { return factors_; }
  Polynomial denominator() const;  // expanded, content included

  bool is_zero() const { return numerator_.is_zero(); }
  bool is_one() const { return numerator_.is_one() && content_ == Rational(1) && factors_.empty(); }
  bool is_polynomial() const { return factors_.empty(); }
  // The value if it does not depend on any variable.
  std::optional<Rational> constant() const;
  std::vector<std::string> variables() const;
  bool is_canonical() const;  // the invariant above, re-examined; for tests

  friend RationalFunction operator+(const RationalFunction& a, const RationalFunction& b);
  friend RationalFunction operator-(const RationalFunction& a, const RationalFunction& b);
  friend RationalFunction operator*(const RationalFunction& a, const RationalFunction& b);
  friend RationalFunction operator/(const RationalFunction& a, const RationalFunction& b);  // Error if b = 0
  RationalFunction operator-() const;
  RationalFunction& operator+=(const RationalFunction& o) { return *this = *this + o; }
  RationalFunction& operator-=(const RationalFunction& o) { return *this = *this - o; }
  RationalFunction& operator*=(const RationalFunction& o) { return *this = *this * o; }
  friend bool operator==(const RationalFunction& a, const RationalFunction& b);

  RationalFunction pow(long exponent) const;
  RationalFunction inverse() const;
  RationalFunction substitute(const std::string& variable, const RationalFunction& by) const;
  // Value at rationals; nullopt at a pole.
  std::optional<Rational> evaluate(const std::vector<std::pair<std::string, Rational>>& at) const;

  // "-(4*v + 1)*(4*v^2 + 2*v - 1)/(64*v^3*(v + 1)^2)"; parses back unchanged (contract §2). The numerator is factored
  // when that is cheap (small degree) and useful.
  std::string to_string(Polynomial::Style style = Polynomial::Style::plain) const;

 private:
  Polynomial numerator_;
  Rational content_ = 1;
  Factors factors_;
};

// Least common multiple of the denominators, expanded; content included. Positive leading coefficient.
struct CommonDenominator {
  Rational content = 1;
  RationalFunction::Factors factors;
  Polynomial expanded() const;
};
CommonDenominator common_denominator(std::span<const RationalFunction> values);
// value * denominator as a polynomial; required: the denominator is a multiple of value's.
Polynomial numerator_over(const RationalFunction& value, const CommonDenominator& denominator);

}  // namespace twoscale
