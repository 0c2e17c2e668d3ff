// SPDX-License-Identifier: GPL-3.0-or-later
// Real algebraic numbers: an irreducible integer polynomial in x and a rational interval that holds one of its zeros.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "twoscale/symbolic/ball.hpp"
#include "twoscale/symbolic/polynomial.hpp"

namespace twoscale::analysis {

class RealAlgebraic {
 public:
  RealAlgebraic() : RealAlgebraic(Rational(0)) {}
  RealAlgebraic(const Rational& value);  // NOLINT: numbers convert
  // All real zeros of p (not 0, in one variable), ascending, without multiplicity.
  static std::vector<RealAlgebraic> zeros(const Polynomial& p);
  // The positive n-th root of |*this|; required: not 0, n >= 1.
  RealAlgebraic root_of_modulus(unsigned n) const;

  const Polynomial& polynomial() const { return p_; }  // primitive, irreducible, positive leading coefficient
  const Rational& lower() const { return lower_; }     // lower() <= the number <= upper(), equal if it is rational
  const Rational& upper() const { return upper_; }
  std::optional<Rational> rational() const;
  long degree() const;

  // Halves the interval until it is at most `width` wide.
  void refine(const Rational& width);
  Ball enclose(long bits) const;
  double estimate() const;  // a nearby double
  int sign() const;
  friend bool operator==(const RealAlgebraic& a, const RealAlgebraic& b);
  // Sign of a - b, exactly.
  static int compare(const RealAlgebraic& a, const RealAlgebraic& b);

  // An expression of the contract (§2) for rationals, quadratic numbers and roots r^(1/n) of these; nullopt otherwise.
  std::optional<std::string> expression() const;

 private:
  RealAlgebraic(Polynomial p, Rational lower, Rational upper)
      : p_(std::move(p)), lower_(std::move(lower)), upper_(std::move(upper)) {}
  Polynomial p_;
  Rational lower_;
  Rational upper_;
};

// The dyadic number of smallest denominator strictly between a and b; required: a < b.
Rational rational_between(const RealAlgebraic& a, const RealAlgebraic& b);

// Sign of p at a rational; p in at most one variable.
int sign_at(const Polynomial& p, const Rational& at);

}  // namespace twoscale::analysis
