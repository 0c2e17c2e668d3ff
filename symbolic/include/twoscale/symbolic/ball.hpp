// SPDX-License-Identifier: GPL-3.0-or-later
// Real balls (midpoint +- radius) with rigorous arithmetic: a value type over Arb. A ball always contains the exact
// value.
#pragma once

#include <arb.h>

#include <string>

#include "twoscale/symbolic/rational.hpp"

namespace twoscale {

class Ball {
 public:
  Ball() { arb_init(value_); }
  Ball(const Ball& o) : Ball() { arb_set(value_, o.value_); }
  Ball(Ball&& o) noexcept : Ball() { arb_swap(value_, o.value_); }
  Ball& operator=(Ball o) noexcept {
    arb_swap(value_, o.value_);
    return *this;
  }
  ~Ball() { arb_clear(value_); }
  Ball(const Rational& q, long bits) : Ball() { arb_set_fmpq(value_, q.raw(), bits); }

  arb_struct* raw() { return value_; }
  const arb_struct* raw() const { return value_; }

  bool contains_zero() const { return arb_contains_zero(value_) != 0; }
  bool is_exact_zero() const { return arb_is_zero(value_) != 0; }
  bool is_positive() const { return arb_is_positive(value_) != 0; }
  bool is_negative() const { return arb_is_negative(value_) != 0; }
  bool is_finite() const { return arb_is_finite(value_) != 0; }

 private:
  arb_t value_;
};

// The decimal with `digits` significant digits, correctly rounded (half away from zero), or "" if the ball is too wide
// to decide every digit. Plain notation, "0" for an exact zero; scientific notation beyond 10^21 and below
// 10^-(digits+6).
std::string rounded_decimal(const Ball& x, long digits);
// The same for a rational: a ball around 3/20 never decides its first digit.
std::string rounded_decimal(const Rational& x, long digits);

// The number whose significant digits are `digits` (no point) and whose last one has weight 10^last. Plain notation;
// scientific beyond 10^21 and below 10^-(precision+6).
std::string decimal_layout(const std::string& digits, long last, bool negative, long precision);

// Correct rounding to double (nearest, ties to even); false if the ball does not decide it.
bool rounded_double(const Ball& x, double& result);

}  // namespace twoscale
