// SPDX-License-Identifier: GPL-3.0-or-later
#include "rounding.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "twoscale/kernels/number_text.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/integer.hpp"

namespace twoscale::lowering {

namespace {

constexpr double log2_of_10 = 3.3219280948873624;
constexpr double log10_of_2 = 0.30102999566398119;
constexpr mp_limb_t ten_19 = 10000000000000000000UL;

// The eight digits of value < 10^8: two halves of 4 digits, then four of 2, then eight of 1 side by side in one word.
void write_eight(char* to, unsigned long value) {
  static_assert(std::endian::native == std::endian::little);
  const unsigned long high = value / 10000;
  unsigned long x = high | (value - high * 10000) << 32U;
  unsigned long tens = (x * 10486) >> 20U & 0x0000007f0000007fUL;  // floor(y/100), y < 10^4
  x = tens | (x - 100 * tens) << 16U;
  tens = (x * 103) >> 10U & 0x000f000f000f000fUL;  // floor(y/10), y < 100
  x = (tens | (x - 10 * tens) << 8U) + 0x3030303030303030UL;
  std::memcpy(to, &x, 8);
}

// The last `count` digits of value, leading zeros kept.
void write_digits(char* to, unsigned long value, int count) {
  while (count >= 8) {
    const unsigned long rest = value / 100000000;
    count -= 8;
    write_eight(to + count, value - rest * 100000000);
    value = rest;
  }
  for (int i = count; i-- > 0; value /= 10) to[i] = static_cast<char>('0' + value % 10);
}

// floor(log10 |x|), possibly one off.
long decimal_exponent(const Rational& x) {
  const auto log2_of = [](const fmpz* n) {
    slong e = 0;
    const double d = std::fabs(fmpz_get_d_2exp(&e, n));
    return std::log2(d) + static_cast<double>(e);
  };
  return static_cast<long>(std::floor((log2_of(x.numerator()) - log2_of(x.denominator())) * log10_of_2));
}

// |x| 10^shift as integer quotient and remainder over `divisor`.
void scale(const Rational& x, long shift, Integer& quotient, Integer& remainder, Integer& divisor) {
  Integer n, ten;
  fmpz_abs(n.v, x.numerator());
  fmpz_set(divisor.v, x.denominator());
  fmpz_set_ui(ten.v, 10);
  fmpz_pow_ui(ten.v, ten.v, static_cast<ulong>(std::labs(shift)));
  if (shift >= 0)
    fmpz_mul(n.v, n.v, ten.v);
  else
    fmpz_mul(divisor.v, divisor.v, ten.v);
  fmpz_fdiv_qr(quotient.v, remainder.v, n.v, divisor.v);
}

}  // namespace

// Digits of |x| down to 10^{e - digits + 1}. wrong: +1 if e is too small, -1 if too large. load(n) puts n limbs of
// fraction under one limb of integer part into fraction_, rounded down, and returns q with an error below 2^q, or
// `exactly` or `useless`.
constexpr long exactly = -(1L << 40);
constexpr long useless = 1L << 40;

template <class Load>
bool DecimalRounder::try_exponent(const Load& load, long e, int& wrong) {
  wrong = 0;
  const long decimals = digits_ - 1 - e;
  // One limb goes with every 19 digits, two stay for the remainder; cutting errors add up to less than 2^-100.
  const size_t limbs = static_cast<size_t>((decimals + 18) / 19) + 2;
  fraction_.assign(limbs + 1, 0);
  long q = load(limbs);
  // |value - fixed| < 2^q in units of the last digit.
  if (q > exactly) q += static_cast<long>(std::ceil(static_cast<double>(decimals) * log2_of_10)) + 1;
  if (q > -3) return false;

  buffer_.resize(20 + static_cast<size_t>(decimals));
  write_digits(buffer_.data(), fraction_[limbs], 20);
  char* to = buffer_.data() + 20;
  size_t low = 0;  // limbs cut off
  bool cut = false;
  for (long left = decimals; left > 0;) {
    const int chunk = static_cast<int>(std::min(19L, left));
    mp_limb_t power = ten_19;
    for (int i = chunk; i < 19; ++i) power /= 10;
    write_digits(to, mpn_mul_1(&fraction_[low], &fraction_[low], static_cast<mp_size_t>(limbs - low), power), chunk);
    to += chunk;
    left -= chunk;
    cut = cut || fraction_[low] != 0;
    ++low;
  }
  // What is left is compared with 1/2; a difference of at least 2^-62 + 2^q decides.
  const mp_limb_t rest = fraction_[limbs - 1];
  const mp_limb_t half = mp_limb_t(1) << 63;
  const mp_limb_t distance = rest >= half ? rest - half : half - rest;
  const bool exact_value = q <= -(1L << 39) && !cut;
  if (!exact_value && distance < (mp_limb_t(1) << std::max(0L, 64 + std::max(q, -63L))) + 4) return false;
  if (rest >= half) {  // the remainder of an exact value is exact: half goes up
    size_t i = buffer_.size();
    while (buffer_[--i] == '9') buffer_[i] = '0';
    ++buffer_[i];
  }
  const size_t first = buffer_.find_first_not_of('0');
  if (first == std::string::npos) {
    wrong = -1;
    return false;
  }
  const long count = static_cast<long>(buffer_.size() - first);
  if (count < digits_) {
    wrong = -1;
    return false;
  }
  if (count > digits_) {
    const bool carried =
        buffer_[first] == '1' && buffer_.find_first_not_of('0', first + 1) == std::string::npos && count == digits_ + 1;
    if (!carried) {
      wrong = 1;
      return false;
    }
  }
  buffer_.erase(0, first);
  return true;
}

template <class Load>
bool DecimalRounder::try_exponents(const Load& load, double log2_of_x, bool negative, Decimal& result) {
  long e = static_cast<long>(std::floor(log2_of_x * log10_of_2));
  for (int attempt = 0; attempt < 3; ++attempt) {
    int wrong = 0;
    if (try_exponent(load, e, wrong)) {
      result.last = e - digits_ + 1;
      if (static_cast<long>(buffer_.size()) > digits_) {  // 99..9 became 100..0
        buffer_.pop_back();
        ++result.last;
      }
      result.text = decimal_layout(buffer_, result.last, negative, digits_);
      result.exact = false;
      return true;
    }
    if (wrong == 0) return false;
    e += wrong;
  }
  return false;
}

bool DecimalRounder::round(const Fixed& x, Decimal& result) {
  const long bits = x.bits();
  const long n = static_cast<long>(x.fraction());
  const long size = bits - 64 * n;  // 2^{size-1} <= |x| < 2^size
  if (x.error >= bits || digits_ <= size / 3 + 1) return false;
  const auto load = [&](size_t limbs) {
    const size_t kept = std::min(limbs + 1, x.limbs.size());
    std::copy_n(x.limbs.end() - static_cast<long>(kept), kept, fraction_.end() - static_cast<long>(kept));
    return std::max(x.error - 64 * n, -64 * static_cast<long>(limbs)) + 1;
  };
  const auto top = static_cast<size_t>((bits - 1) / 64);
  double lead = static_cast<double>(x.limbs[top]);
  if (top > 0) lead += static_cast<double>(x.limbs[top - 1]) * 0x1p-64;
  return try_exponents(load, std::log2(lead) + static_cast<double>(64 * (static_cast<long>(top) - n)), x.negative,
                       result);
}

bool DecimalRounder::round(const Ball& x, Decimal& result) {
  if (!x.is_finite() || x.contains_zero()) return false;
  const arf_struct* mid = arb_midref(x.raw());
  if (COEFF_IS_MPZ(ARF_EXP(mid))) return false;
  const long size = ARF_EXP(mid);
  // The lead: 2^{size-1} <= |mid| < 2^size.
  const bool negative = arf_sgn(mid) < 0;
  const bool moderate = size <= 60 && size > -4096 && digits_ > size / 3 + 1;
  if (!moderate) return round_slowly(x, result);
  arf_t lead;
  arf_init(lead);
  arf_abs(lead, mid);
  arf_mul_2exp_si(lead, lead, -size);
  const double log2_of_x = std::log2(arf_get_d(lead, ARF_RND_NEAR)) + static_cast<double>(size);
  arf_clear(lead);
  const auto load = [&](size_t limbs) {
    arf_t scaled;
    arf_init(scaled);
    arf_abs(scaled, mid);
    arf_mul_2exp_si(scaled, scaled, static_cast<slong>(64 * limbs));
    Integer fixed;
    const bool inexact = arf_get_fmpz(fixed.v, scaled, ARF_RND_DOWN) != 0;
    arf_clear(scaled);
    if (COEFF_IS_MPZ(*fixed.v)) {
      const mpz_srcptr big = COEFF_TO_PTR(*fixed.v);
      std::copy_n(big->_mp_d, static_cast<size_t>(std::abs(big->_mp_size)), fraction_.begin());
    } else {
      fraction_[0] = static_cast<mp_limb_t>(*fixed.v);
    }
    long q = exactly;
    if (!mag_is_zero(arb_radref(x.raw()))) {
      if (COEFF_IS_MPZ(MAG_EXP(arb_radref(x.raw())))) return useless;
      q = MAG_EXP(arb_radref(x.raw()));
    }
    return inexact ? std::max(q, -static_cast<long>(64 * limbs)) + 1 : q;
  };
  if (try_exponents(load, log2_of_x, negative, result)) return true;
  // Two limbs below the last digit do not decide; where the ball knows more, all of it is asked.
  const double needed = static_cast<double>(digits_) * log2_of_10 + 56;
  return static_cast<double>(arb_rel_accuracy_bits(x.raw())) > needed && round_slowly(x, result);
}

// Through an integer of the right number of digits, whatever the size.
bool DecimalRounder::round_slowly(const Ball& x, Decimal& result) const {
  result.text = rounded_decimal(x, digits_);
  if (result.text.empty()) return false;
  const bool negative = result.text[0] == '-';
  const auto mark = result.text.find('e');
  long e = mark == std::string::npos ? 0 : std::stol(result.text.substr(mark + 1));
  if (mark == std::string::npos) {
    const std::string plain = negative ? result.text.substr(1) : result.text;
    const auto point = plain.find('.');
    const auto first = plain.find_first_not_of("0.");
    e = first < std::min(point, plain.size())
            ? static_cast<long>(std::min(point, plain.size())) - 1 - static_cast<long>(first)
            : static_cast<long>(point) - static_cast<long>(first);
  }
  result.last = e - digits_ + 1;
  result.exact = false;
  return true;
}

Decimal rounded(const Rational& x, long digits) {
  if (x.is_zero()) return {"0", 0, true};
  Integer quotient, remainder, divisor;
  long e = decimal_exponent(x);
  for (;;) {
    const long last = e - digits + 1;
    scale(x, -last, quotient, remainder, divisor);
    const bool exact = fmpz_is_zero(remainder.v) != 0;
    const std::string before = quotient.to_string();  // decides whether e is right
    const long count = static_cast<long>(before.size());
    if (fmpz_is_zero(quotient.v) || count != digits) {
      e += count > digits ? 1 : -1;
      continue;
    }
    fmpz_mul_ui(remainder.v, remainder.v, 2);
    std::string text = before;
    long weight = last;
    if (fmpz_cmp(remainder.v, divisor.v) >= 0) {
      fmpz_add_ui(quotient.v, quotient.v, 1);
      text = quotient.to_string();
      if (static_cast<long>(text.size()) > digits) {
        text.pop_back();
        ++weight;
      }
    }
    if (exact) {
      const size_t kept = text.find_last_not_of('0') + 1;
      weight += static_cast<long>(text.size() - kept);
      text.resize(kept);
    }
    return {decimal_layout(text, weight, x.sign() < 0, digits), weight, exact};
  }
}

double rounded_double(const Rational& x) {
  if (x.is_zero()) return 0;
  // Round to odd at 1200 bits, far below the last bit of any double, then once to nearest.
  arf_t n, d, q;
  arf_init(n);
  arf_init(d);
  arf_init(q);
  arf_set_fmpz(n, x.numerator());
  arf_set_fmpz(d, x.denominator());
  const bool inexact = arf_div(q, n, d, 1200, ARF_RND_DOWN) != 0;
  if (inexact) {
    arf_t tiny;
    arf_init(tiny);
    arf_set_si_2exp_si(tiny, x.sign(), 0);
    arf_mul_2exp_fmpz(tiny, tiny, ARF_EXPREF(q));
    arf_mul_2exp_si(tiny, tiny, -1250);
    arf_add(q, q, tiny, ARF_PREC_EXACT, ARF_RND_DOWN);
    arf_clear(tiny);
  }
  const double r = arf_get_d(q, ARF_RND_NEAR);
  arf_clear(n);
  arf_clear(d);
  arf_clear(q);
  return r;
}

bool is_double(const Rational& x) {
  const double d = rounded_double(x);
  if (!std::isfinite(d)) return false;
  arf_t a;
  arf_init(a);
  arf_set_d(a, d);
  const bool same = to_rational(a) == x;
  arf_clear(a);
  return same;
}

std::string rounded_up(const Rational& x) {
  if (x.sign() <= 0) return "0";
  Integer quotient, remainder, divisor;
  long e = decimal_exponent(x);
  for (;;) {
    scale(x, 2 - e, quotient, remainder, divisor);
    if (!fmpz_is_zero(remainder.v)) fmpz_add_ui(quotient.v, quotient.v, 1);
    if (fmpz_cmp_ui(quotient.v, 1000) > 0) {
      ++e;
      continue;
    }
    if (fmpz_cmp_ui(quotient.v, 100) < 0) {
      --e;
      continue;
    }
    std::string text = quotient.to_string();
    e += static_cast<long>(text.size()) - 3;
    text.resize(text.find_last_not_of('0') + 1);
    if (e == 0 || e == 1) return decimal_layout(text, e - static_cast<long>(text.size()) + 1, false, 3);
    return text.substr(0, 1) + (text.size() > 1 ? "." + text.substr(1) : "") + "e" + std::to_string(e);
  }
}

std::string rounded_up(const arf_t x) { return rounded_up(to_rational(x)); }

Rational to_rational(const arf_t x) {
  Integer man, exp, power;
  arf_get_fmpz_2exp(man.v, exp.v, x);
  const long e = fmpz_get_si(exp.v);
  fmpz_one(power.v);
  fmpz_mul_2exp(power.v, power.v, static_cast<ulong>(std::labs(e)));
  return e >= 0 ? Rational(man.v) * Rational(power.v) : Rational(man.v) / Rational(power.v);
}

Rational exact_decimal(const std::string& text) {
  const auto mark = text.find_first_of("eE");
  std::string digits = text.substr(0, mark);
  long exponent = mark == std::string::npos ? 0 : std::stol(text.substr(mark + 1));
  const bool negative = digits[0] == '-';
  if (digits[0] == '-' || digits[0] == '+') digits.erase(0, 1);
  if (const auto point = digits.find('.'); point != std::string::npos) {
    exponent -= static_cast<long>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  Integer n;
  fmpz_set_str(n.v, digits.c_str(), 10);
  Rational r(n.v);
  r *= Rational(10).pow(exponent);
  return negative ? -r : r;
}

bool round_all(const std::vector<const Ball*>& numbers, const Rational& scale, long bits, long digits,
               kernels::PointSet& out) {
  const auto size = [](const Ball& x) {
    Ball bound;
    arb_get_abs_ubound_arf(arb_midref(bound.raw()), x.raw(), 30);
    return bound;
  };
  // Below this size a number that cannot be told from 0 is taken for it.
  Ball least;
  for (const Ball* x : numbers)
    if (const Ball s = size(*x); arf_cmp(arb_midref(s.raw()), arb_midref(least.raw())) > 0) least = s;
  arb_div(least.raw(), least.raw(), Ball(Rational(10).pow(2 * digits), 64).raw(), 64);

  out.tokens.clear();
  out.values.clear();
  DecimalRounder rounder(digits);
  Decimal decimal;
  for (const Ball* x : numbers) {
    if (!x->is_finite()) return false;
    if (arb_is_exact(x->raw())) {
      decimal = rounded(to_rational(arb_midref(x->raw())) / scale, digits);
    } else if (x->contains_zero()) {
      if (arf_cmp(arb_midref(size(*x).raw()), arb_midref(least.raw())) >= 0) return false;
      decimal.text = "0";
    } else {
      Ball y;
      arb_div_fmpz(y.raw(), x->raw(), scale.numerator(), bits);
      if (!rounder.round(y, decimal)) return false;
    }
    const auto value = kernels::parse_double(decimal.text);
    if (!value) bad_input("a refined number does not fit a double", decimal.text.substr(0, 40));
    out.tokens.push_back(decimal.text);
    out.values.push_back(*value);
  }
  return true;
}

}  // namespace twoscale::lowering
