// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/symbolic/ball.hpp"

#include <cmath>
#include <stdexcept>

#include "twoscale/symbolic/integer.hpp"

namespace twoscale {

namespace {

// round(x 10^shift), half away from zero, if the whole ball rounds to the same integer.
bool scaled_integer(fmpz_t result, const arb_t x, long shift) {
  const long bits = arb_bits(x) + static_cast<long>(std::ceil(std::fabs(static_cast<double>(shift)) * 3.33)) + 64;
  Ball scaled;
  Integer ten;
  fmpz_ui_pow_ui(ten.v, 10, static_cast<ulong>(shift < 0 ? -shift : shift));
  if (shift < 0)
    arb_div_fmpz(scaled.raw(), x, ten.v, bits);
  else
    arb_mul_fmpz(scaled.raw(), x, ten.v, bits);
  const bool negative = arf_sgn(arb_midref(scaled.raw())) < 0;
  if (negative) arb_neg(scaled.raw(), scaled.raw());
  Ball half;
  arb_set_d(half.raw(), 0.5);  // exact
  arb_add(scaled.raw(), scaled.raw(), half.raw(), bits);
  Ball floor;
  arb_floor(floor.raw(), scaled.raw(), bits);
  if (!arb_get_unique_fmpz(result, floor.raw())) return false;
  if (negative) fmpz_neg(result, result);
  return true;
}

// Writes x from `scaled`, which gives round(x 10^shift), half away from zero, or says that it cannot;
// 2^{log2_size-1} <= |x| < 2^{log2_size+1}. `exact` says for the final shift whether x 10^shift is an integer.
template <class Scaled, class Exact>
std::string written(double log2_size, long digits, Scaled scaled, Exact exact) {
  // Exponent e with 10^e <= |x| < 10^{e+1}; corrected below if the rounding carries or e is off by one.
  long e = static_cast<long>(std::floor((log2_size - 1) * 0.30102999566398119521));
  Integer n;
  std::string s;
  for (int attempt = 0; attempt < 4; ++attempt) {
    if (!scaled(n.v, digits - 1 - e)) return "";
    s = n.to_string();
    const bool negative = s[0] == '-';
    const long length = static_cast<long>(s.size()) - (negative ? 1 : 0);
    if (length == digits) break;
    e += length > digits ? 1 : -1;
    s.clear();
  }
  if (s.empty()) return "";
  const bool negative = s[0] == '-';
  if (negative) s.erase(0, 1);
  long last = e - digits + 1;
  // An exact short decimal (1, 0.5) is printed without trailing zeros; anything else keeps all its digits.
  if (exact(-last)) {
    const size_t kept = s.find_last_not_of('0') + 1;
    last += static_cast<long>(s.size() - kept);
    s.resize(kept);
  }
  return decimal_layout(s, last, negative, digits);
}

}  // namespace

std::string decimal_layout(const std::string& digits, long last, bool negative, long precision) {
  const long count = static_cast<long>(digits.size());
  const long e = last + count - 1;  // of the first digit
  std::string text = negative ? "-" : "";
  if (e > 20 || e < -(precision + 6)) {
    text += digits[0];
    if (count > 1) text.append(1, '.').append(digits, 1);
    return text + "e" + std::to_string(e);
  }
  if (last >= 0) return text.append(digits).append(static_cast<size_t>(last), '0');
  if (e < 0) return text.append("0.").append(static_cast<size_t>(-e - 1), '0').append(digits);
  return text.append(digits, 0, static_cast<size_t>(e) + 1).append(1, '.').append(digits, static_cast<size_t>(e) + 1);
}

std::string rounded_decimal(const Ball& x, long digits) {
  if (!x.is_finite()) return "";
  if (x.is_exact_zero()) return "0";
  if (x.contains_zero()) return "";
  return written(
      static_cast<double>(arf_abs_bound_lt_2exp_si(arb_midref(x.raw()))), digits,
      [&](fmpz_t n, long shift) { return scaled_integer(n, x.raw(), shift); },
      [&](long) { return arb_is_exact(x.raw()) != 0; });
}

std::string rounded_decimal(const Rational& x, long digits) {
  if (x.is_zero()) return "0";
  const Rational size = abs(x);
  return written(
      static_cast<double>(fmpz_bits(x.numerator())) - static_cast<double>(fmpz_bits(x.denominator())), digits,
      [&](fmpz_t n, long shift) {
        const Rational y = size * Rational(10).pow(shift) + Rational(1, 2);
        fmpz_fdiv_q(n, y.numerator(), y.denominator());
        if (x.sign() < 0) fmpz_neg(n, n);
        return true;
      },
      [&](long shift) { return (size * Rational(10).pow(shift)).is_integer(); });
}

bool rounded_double(const Ball& x, double& result) {
  if (!x.is_finite()) return false;
  arf_t low, high;
  arf_init(low);
  arf_init(high);
  arb_get_lbound_arf(low, x.raw(), arb_bits(x.raw()) + 64);
  arb_get_ubound_arf(high, x.raw(), arb_bits(x.raw()) + 64);
  const double a = arf_get_d(low, ARF_RND_NEAR);
  const double b = arf_get_d(high, ARF_RND_NEAR);
  arf_clear(low);
  arf_clear(high);
  result = a;
  return a == b;
}

}  // namespace twoscale
