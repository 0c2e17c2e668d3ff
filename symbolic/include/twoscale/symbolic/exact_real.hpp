// SPDX-License-Identifier: GPL-3.0-or-later
// Exact real constants: -2/5, (sqrt(5)-1)/4, cos(2*pi/7), cosh(3/5), kept as expressions.
//
// A constant can be enclosed to any precision, and its sign is decided: by balls when it is not zero; when it is built
// from rationals, roots and cosines of rational multiples of pi, a zero is *proved* by a separation bound (Burnikel,
// Funke, Mehlhorn, Schirra and Schmitt 2001: a non-zero value U/L with U, L algebraic integers of degree at most D
// whose conjugates are bounded by u and l is at least 1/(l u^{D-1}) in size).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "twoscale/symbolic/ball.hpp"
#include "twoscale/symbolic/rational.hpp"

namespace twoscale {

enum class Sign { negative, zero, positive, unknown };

class ExactReal {
 public:
  enum class Function { exp, log, cos, sin, tan, cosh, sinh, tanh, acos, asin, atan, acosh };

  ExactReal() : ExactReal(Rational(0)) {}
  ExactReal(const Rational& q);                  // NOLINT: numbers convert
  ExactReal(long n) : ExactReal(Rational(n)) {}  // NOLINT
  ExactReal(int n) : ExactReal(Rational(n)) {}   // NOLINT
  static ExactReal pi();
  // f(x). cos and sin of a rational multiple of pi stay algebraic.
  static ExactReal apply(Function f, const ExactReal& x);

  friend ExactReal operator+(const ExactReal& a, const ExactReal& b);
  friend ExactReal operator-(const ExactReal& a, const ExactReal& b);
  friend ExactReal operator*(const ExactReal& a, const ExactReal& b);
  friend ExactReal operator/(const ExactReal& a, const ExactReal& b);  // a zero b shows up as an infinite enclosure
  ExactReal pow(const Rational& exponent) const;

  std::optional<Rational> rational() const;        // if it is written as one
  std::optional<Rational> multiple_of_pi() const;  // r if it is written as r*pi
  // x if it is written as f(x).
  std::optional<ExactReal> argument_of(Function f) const;

  // A ball that contains the value, computed with `bits` of working precision (its radius is not promised).
  Ball enclose(long bits) const;
  // Decides the sign with at most max_bits of precision.
  Sign sign(long max_bits = 1 << 16) const;
  // A decimal with that many correctly rounded significant digits.
  std::string decimal(long digits) const;

  struct Node;

 private:
  explicit ExactReal(std::shared_ptr<const Node> n) : node_(std::move(n)) {}
  friend struct ExactRealAccess;
  std::shared_ptr<const Node> node_;
};

}  // namespace twoscale
