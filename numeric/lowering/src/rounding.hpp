// SPDX-License-Identifier: GPL-3.0-or-later
// Correct rounding of balls and rationals to decimals (half away from zero) and doubles (half to even).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fixed_point.hpp"
#include "twoscale/kernels/points_io.hpp"
#include "twoscale/symbolic/ball.hpp"
#include "twoscale/symbolic/rational.hpp"

namespace twoscale::lowering {

// A decimal and the power of ten of its last digit; exact: the text is the value itself, without trailing zeros.
struct Decimal {
  std::string text;
  long last = 0;
  bool exact = false;
};

// Significant digits of balls. The fraction is multiplied by 10^19 limb by limb, so that no division is needed; buffers
// are kept from call to call.
class DecimalRounder {
 public:
  explicit DecimalRounder(long digits) : digits_(digits) {}
  // False if the ball does not decide every digit.
  bool round(const Ball& x, Decimal& result);
  bool round(const Fixed& x, Decimal& result);

 private:
  bool round_slowly(const Ball& x, Decimal& result) const;
  template <class Load>
  bool try_exponents(const Load& load, double log2_of_x, bool negative, Decimal& result);
  template <class Load>
  bool try_exponent(const Load& load, long e, int& wrong);

  long digits_;
  std::vector<mp_limb_t> fraction_;
  std::string buffer_;  // digits: integer part, then the fraction
};

Decimal rounded(const Rational& x, long digits);
// Nearest double, ties to even; huge values become infinite.
double rounded_double(const Rational& x);
// True if x is a double.
bool is_double(const Rational& x);

// A decimal >= x with at most 3 significant digits, "1.23e-7"; x >= 0.
std::string rounded_up(const Rational& x);
std::string rounded_up(const arf_t x);

// The exact value of an accepted decimal (kernels::is_decimal).
Rational exact_decimal(const std::string& text);

// The rational number of a finite arf.
Rational to_rational(const arf_t x);

// numbers/scale (scale a positive integer) with `digits` correct significant digits as `values` and `tokens` of `out`;
// false if a digit is not decided at this precision. A number that
// cannot be told from 0 with twice the digits (smaller than 10^(-2 digits) times the largest one) becomes 0.
bool round_all(const std::vector<const Ball*>& numbers, const Rational& scale, long bits, long digits,
               kernels::PointSet& out);

}  // namespace twoscale::lowering
