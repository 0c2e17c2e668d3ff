// SPDX-License-Identifier: GPL-3.0-or-later
// Ratios of integer polynomials at one number |u| < 1 in fixed-point arithmetic with error bounds: what a mask table
// with one level variable spends its time on. Balls do the same for any numbers; below a few hundred digits their
// bookkeeping costs more than the arithmetic.
//
// n limbs of fraction under one limb of integer part, sign apart; ulp = 2^{-64n}. Bounds are integers:
//   U_j = |u|^j, truncated at every product: error < 3j ulp (2 for u itself, and e_{a+b} <= e_a + e_b + 1)
//   p(u) = sum_j c_j u^j, the sums exact:    error < sum_j 3j |c_j| ulp
//   N/D:  |N/D - N~/D~| <= E_N/|D| + |N~| E_D/|D D~|, |D| >= D~/2; the truncated inverse adds |N~| ulp, the product 1.
#pragma once

#include <flint/fmpz_poly.h>

#include <optional>
#include <vector>

#include "twoscale/symbolic/ball.hpp"

namespace twoscale::lowering {

// |value - limbs 2^{-64n}| < 2^error ulp, limbs[n] the integer part.
struct Fixed {
  std::vector<mp_limb_t> limbs;
  bool negative = false;
  long error = 0;

  std::size_t fraction() const { return limbs.size() - 1; }
  // Length of the number in bits of ulp; 0 for 0.
  long bits() const;
};

// Correct rounding to double (nearest); false if the error bound does not decide it or the exponent is extreme.
bool rounded_double(const Fixed& x, double& result);

// A polynomial prepared for evaluation.
class FixedForm {
 public:
  // nullopt if sum_j (3j+1) |c_j| >= 2^60.
  static std::optional<FixedForm> of(const fmpz_poly_struct* p);

 private:
  friend class FixedPoint;
  struct Term {
    mp_limb_t size;
    bool negative;
  };
  std::vector<Term> terms_;  // by power
  long error_ = 0;           // the bound's length in bits
};

class FixedPoint {
 public:
  FixedPoint(std::size_t limbs, std::size_t degree);
  // False unless |u| < 0.99 and its radius is at most one ulp.
  bool set(const Ball& u);
  void evaluate(Fixed& result, const FixedForm& form);
  // Keeps 1/d for quotient(). False if d may be smaller than 2^-60.
  bool invert(const Fixed& d);
  // n/d. False if it does not fit.
  bool quotient(Fixed& result, const Fixed& n);

 private:
  std::size_t limbs_;
  bool negative_ = false;
  std::vector<std::vector<mp_limb_t>> powers_;  // [j], j >= 1
  std::vector<mp_limb_t> product_, other_, inverse_, divided_, remainder_;
  bool negative_inverse_ = false;
  long inverse_size_ = 0;   // |1/d| <= 2^s, n bits of fraction over those of d, and 2
  long inverse_error_ = 0;  // of d, in bits
};

}  // namespace twoscale::lowering
