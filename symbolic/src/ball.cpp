// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/symbolic/ball.hpp"

#include <cmath>
#include <stdexcept>

namespace twoscale {

namespace {

struct Integer {
  fmpz_t v;
  Integer() { fmpz_init(v); }
  Integer(const Integer&) = delete;
  Integer& operator=(const Integer&) = delete;
  ~Integer() { fmpz_clear(v); }
  std::string text() const {
    char* s = fmpz_get_str(nullptr, 10, v);
    std::string r(s);
    flint_free(s);
    return r;
  }
};

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

}  // namespace

namespace {

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
    s = n.text();
    const bool negative = s[0] == '-';
    const long length = static_cast<long>(s.size()) - (negative ? 1 : 0);
    if (length == digits) break;
    e += length > digits ? 1 : -1;
    s.clear();
  }
  if (s.empty()) return "";
  std::string sign;
  if (s[0] == '-') {
    sign = "-";
    s.erase(0, 1);
  }
  // An exact short decimal (1, 0.5) is printed without trailing zeros; anything else keeps all its digits.
  const auto trim = [&](std::string t) {
    if (exact(digits - 1 - e) && t.find('.') != std::string::npos) {
      t.erase(t.find_last_not_of('0') + 1);
      if (t.back() == '.') t.pop_back();
    }
    return t;
  };
  if (e > 20 || e < -(digits + 6)) {
    std::string t = s.substr(0, 1) + (digits > 1 ? "." + s.substr(1) : "");
    return sign + trim(t) + "e" + std::to_string(e);
  }
  if (e < 0) return sign + trim("0." + std::string(static_cast<size_t>(-e - 1), '0') + s);
  if (e + 1 >= digits) return sign + s + std::string(static_cast<size_t>(e + 1 - digits), '0');
  return sign + trim(s.substr(0, static_cast<size_t>(e) + 1) + "." + s.substr(static_cast<size_t>(e) + 1));
}

}  // namespace

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
