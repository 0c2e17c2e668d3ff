// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed_point.hpp"

#include <arb.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace twoscale::lowering {

namespace {

constexpr long limb_bits = 64;
static_assert(GMP_LIMB_BITS == limb_bits);

long length(const std::vector<mp_limb_t>& x) {
  for (std::size_t i = x.size(); i-- > 0;)
    if (x[i] != 0) return limb_bits * static_cast<long>(i + 1) - std::countl_zero(x[i]);
  return 0;
}

mp_size_t signed_size(std::size_t n) { return static_cast<mp_size_t>(n); }

}  // namespace

long Fixed::bits() const { return length(limbs); }

bool rounded_double(const Fixed& x, double& result) {
  const long bits = x.bits();
  // The 64 leading bits m; the value lies strictly between m - 1 and m + 2.
  if (bits < limb_bits || x.error > bits - limb_bits) return false;
  const auto low = static_cast<std::size_t>(bits - limb_bits) / limb_bits;
  const int shift = static_cast<int>((bits - limb_bits) % limb_bits);
  mp_limb_t m = x.limbs[low] >> shift;
  if (shift > 0) m |= x.limbs[low + 1] << (limb_bits - shift);
  const mp_limb_t cut = m & 2047U;  // of the 11 bits below a double's last
  if (cut == 1023U || cut == 1024U) return false;
  const long exponent = bits - limb_bits - limb_bits * static_cast<long>(x.fraction());
  if (exponent < -1021 + 53 || exponent > 900) return false;
  const double rounded =
      std::ldexp(static_cast<double>((m >> 11U) + (cut > 1024U ? 1U : 0U)), static_cast<int>(exponent) + 11);
  result = x.negative ? -rounded : rounded;
  return true;
}

std::optional<FixedForm> FixedForm::of(const fmpz_poly_struct* p) {
  FixedForm f;
  double total = 0;
  mp_limb_t error = 1;
  for (slong j = 0; j < fmpz_poly_length(p); ++j) {
    const fmpz* c = p->coeffs + j;
    if (fmpz_bits(c) > 60) return std::nullopt;
    const slong value = fmpz_get_si(c);
    const mp_limb_t size = value < 0 ? -static_cast<mp_limb_t>(value) : static_cast<mp_limb_t>(value);
    total += static_cast<double>(size) * static_cast<double>(3 * j + 1);
    if (total > 0x1p59) return std::nullopt;  // far enough from 2^60 for a sum of rounded terms
    error += size * static_cast<mp_limb_t>(3 * j);
    f.terms_.push_back({size, value < 0});
  }
  f.error_ = limb_bits - std::countl_zero(error);
  return f;
}

FixedPoint::FixedPoint(std::size_t limbs, std::size_t degree)
    : limbs_(limbs),
      powers_(degree + 1, std::vector<mp_limb_t>(limbs)),
      product_(2 * limbs + 2),
      other_(limbs + 1),
      inverse_(limbs + 1),
      divided_(2 * limbs + 1),
      remainder_(limbs + 1) {}

bool FixedPoint::set(const Ball& u) {
  const arf_struct* mid = arb_midref(u.raw());
  const long ulp = -limb_bits * static_cast<long>(limbs_);
  if (!u.is_finite() || arf_cmpabs_d(mid, 0.99) >= 0 || mag_cmp_2exp_si(arb_radref(u.raw()), ulp) > 0) return false;
  negative_ = arf_sgn(mid) < 0;
  if (powers_.size() < 2) return true;
  std::vector<mp_limb_t>& first = powers_[1];
  std::fill(first.begin(), first.end(), 0);
  if (!arf_is_special(mid)) {
    if (COEFF_IS_MPZ(ARF_EXP(mid))) return false;
    mp_srcptr source;
    mp_size_t size;
    ARF_GET_MPN_READONLY(source, size, mid);
    // The limbs end at bit ARF_EXP - 64 size; shift down to bit `ulp`, truncating.
    const long up = ARF_EXP(mid) - limb_bits * size - ulp;
    for (mp_size_t i = 0; i < size; ++i) {
      const long at = up + limb_bits * i;  // of the limb's lowest bit, in bits above one ulp
      const long whole = at >= 0 ? at / limb_bits : -((-at + limb_bits - 1) / limb_bits);
      const int rest = static_cast<int>(at - whole * limb_bits);
      if (whole >= 0) first[static_cast<std::size_t>(whole)] |= source[i] << rest;
      if (rest > 0 && whole + 1 >= 0 && whole + 1 < static_cast<long>(limbs_))
        first[static_cast<std::size_t>(whole + 1)] |= source[i] >> (limb_bits - rest);
    }
  }
  for (std::size_t j = 2; j < powers_.size(); ++j) {
    const std::vector<mp_limb_t>& half = powers_[j / 2];
    if (j % 2 == 0)
      mpn_sqr(product_.data(), half.data(), signed_size(limbs_));
    else
      mpn_mul_n(product_.data(), half.data(), powers_[j - j / 2].data(), signed_size(limbs_));
    std::copy_n(product_.begin() + static_cast<long>(limbs_), limbs_, powers_[j].begin());
  }
  return true;
}

void FixedPoint::evaluate(Fixed& result, const FixedForm& form) {
  result.limbs.assign(limbs_ + 1, 0);
  std::fill(other_.begin(), other_.end(), 0);
  for (std::size_t j = 0; j < form.terms_.size(); ++j) {
    const FixedForm::Term& t = form.terms_[j];
    if (t.size == 0) continue;
    std::vector<mp_limb_t>& to = (t.negative != (negative_ && j % 2 == 1)) ? other_ : result.limbs;
    if (j == 0)
      to[limbs_] += t.size;
    else
      to[limbs_] += mpn_addmul_1(to.data(), powers_[j].data(), signed_size(limbs_), t.size);
  }
  result.negative = mpn_cmp(result.limbs.data(), other_.data(), signed_size(limbs_ + 1)) < 0;
  if (result.negative)
    mpn_sub_n(result.limbs.data(), other_.data(), result.limbs.data(), signed_size(limbs_ + 1));
  else
    mpn_sub_n(result.limbs.data(), result.limbs.data(), other_.data(), signed_size(limbs_ + 1));
  result.error = form.error_;
}

bool FixedPoint::invert(const Fixed& d) {
  const long n = limb_bits * static_cast<long>(limbs_);
  const long t = d.bits();
  if (t < n - 58 || d.error > t - 3) return false;
  inverse_size_ = n - t + 2;
  inverse_error_ = d.error;
  // floor(2^{128 limbs}/d)
  std::size_t size = limbs_ + 1;
  while (d.limbs[size - 1] == 0) --size;
  std::fill(divided_.begin(), divided_.end(), 0);
  divided_[2 * limbs_] = 1;
  const std::size_t length_of_quotient = 2 * limbs_ + 1 - size + 1;
  mpn_tdiv_qr(product_.data(), remainder_.data(), 0, divided_.data(), signed_size(2 * limbs_ + 1), d.limbs.data(),
              signed_size(size));
  for (std::size_t i = limbs_ + 1; i < length_of_quotient; ++i)
    if (product_[i] != 0) return false;
  std::fill(inverse_.begin(), inverse_.end(), 0);
  std::copy_n(product_.begin(), std::min(length_of_quotient, limbs_ + 1), inverse_.begin());
  negative_inverse_ = d.negative;
  return true;
}

bool FixedPoint::quotient(Fixed& result, const Fixed& n) {
  const long size = n.bits() - limb_bits * static_cast<long>(limbs_);  // |n~| < 2^size
  mpn_mul_n(product_.data(), n.limbs.data(), inverse_.data(), signed_size(limbs_ + 1));
  if (product_[2 * limbs_ + 1] != 0) return false;
  const long s = inverse_size_;
  const long bound =
      2 + std::max(std::max(n.error + s, inverse_error_ + size + 2 * s - 1), std::max(size, 0L));  // four terms
  const bool negative = n.negative != negative_inverse_;
  result.limbs.assign(product_.begin() + static_cast<long>(limbs_),
                      product_.begin() + static_cast<long>(2 * limbs_ + 1));
  result.negative = negative;
  result.error = bound;
  return true;
}

}  // namespace twoscale::lowering
