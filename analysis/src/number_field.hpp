// SPDX-License-Identifier: GPL-3.0-or-later
// Q[x]/(p) for a fixed integer polynomial p: what exact eigenvectors are made of.
#pragma once

#include <arb_fmpz_poly.h>
#include <flint/fmpq_poly.h>

#include <utility>
#include <vector>

#include "twoscale/analysis/rational_matrix.hpp"
#include "twoscale/analysis/real_algebraic.hpp"

namespace twoscale::analysis {

// A polynomial over Q in one variable; the reductions modulo p are explicit.
class FieldElement {
 public:
  FieldElement() { fmpq_poly_init(v_); }
  FieldElement(const FieldElement& o) : FieldElement() { fmpq_poly_set(v_, o.v_); }
  FieldElement(FieldElement&& o) noexcept : FieldElement() { fmpq_poly_swap(v_, o.v_); }
  FieldElement& operator=(FieldElement o) noexcept {
    fmpq_poly_swap(v_, o.v_);
    return *this;
  }
  ~FieldElement() { fmpq_poly_clear(v_); }

  fmpq_poly_struct* raw() { return v_; }
  const fmpq_poly_struct* raw() const { return v_; }
  bool is_zero() const { return fmpq_poly_is_zero(v_) != 0; }
  friend bool operator==(const FieldElement& a, const FieldElement& b) { return fmpq_poly_equal(a.v_, b.v_) != 0; }

  void add_multiple(const Rational& c, const FieldElement& o) {
    FieldElement t;
    fmpq_poly_scalar_mul_fmpq(t.v_, o.v_, c.raw());
    fmpq_poly_add(v_, v_, t.v_);
  }

 private:
  fmpq_poly_t v_;
};

using FieldVector = std::vector<FieldElement>;

class NumberField {
 public:
  // Required: p = generator.polynomial(); the elements are values at the generator.
  explicit NumberField(const RealAlgebraic& generator) : generator_(generator) {
    fmpq_poly_set_fmpz_poly(modulus_.raw(), generator.polynomial().univariate_view());
  }

  const RealAlgebraic& generator() const { return generator_; }

  // sign * x^n mod p times a.
  FieldElement times_power(const FieldElement& a, unsigned n, int sign = 1) const {
    FieldElement r;
    fmpq_poly_shift_left(r.raw(), a.raw(), static_cast<slong>(n));
    fmpq_poly_rem(r.raw(), r.raw(), modulus_.raw());
    if (sign < 0) fmpq_poly_neg(r.raw(), r.raw());
    return r;
  }

  // The value at the generator, in balls.
  Ball enclose(const FieldElement& a, const Ball& at, long bits) const {
    Ball r;
    const slong degree = fmpq_poly_degree(a.raw());
    for (slong i = degree; i >= 0; --i) {
      Rational c;
      fmpq_poly_get_coeff_fmpq(c.raw(), a.raw(), i);
      const Ball cb(c, bits);
      arb_mul(r.raw(), r.raw(), at.raw(), bits);
      arb_add(r.raw(), r.raw(), cb.raw(), bits);
    }
    return r;
  }

 private:
  RealAlgebraic generator_;
  FieldElement modulus_;
};

inline FieldVector operator*(const RationalMatrix& a, const FieldVector& x) {
  FieldVector y(static_cast<size_t>(a.rows()));
  for (long i = 0; i < a.rows(); ++i)
    for (long j = 0; j < a.columns(); ++j)
      if (!fmpq_is_zero(a.entry(i, j))) y[static_cast<size_t>(i)].add_multiple(a(i, j), x[static_cast<size_t>(j)]);
  return y;
}

}  // namespace twoscale::analysis
