// SPDX-License-Identifier: GPL-3.0-or-later
// Dense matrices over Q: a value type over FLINT's fmpq_mat. Index origin 0.
#pragma once

#include <flint/fmpq_mat.h>

#include <optional>
#include <vector>

#include "twoscale/symbolic/polynomial.hpp"
#include "twoscale/symbolic/rational.hpp"

namespace twoscale::analysis {

class RationalMatrix {
 public:
  RationalMatrix() : RationalMatrix(0, 0) {}
  RationalMatrix(long rows, long columns) { fmpq_mat_init(m_, rows, columns); }  // zero
  RationalMatrix(const RationalMatrix& o) { fmpq_mat_init_set(m_, o.m_); }
  RationalMatrix(RationalMatrix&& o) noexcept : RationalMatrix() { fmpq_mat_swap(m_, o.m_); }
  RationalMatrix& operator=(RationalMatrix o) noexcept {
    fmpq_mat_swap(m_, o.m_);
    return *this;
  }
  ~RationalMatrix() { fmpq_mat_clear(m_); }
  static RationalMatrix identity(long n);
  // The columns side by side; all of the length `rows`.
  static RationalMatrix from_columns(long rows, const std::vector<std::vector<Rational>>& columns);

  long rows() const { return fmpq_mat_nrows(m_); }
  long columns() const { return fmpq_mat_ncols(m_); }
  Rational operator()(long i, long j) const { return Rational(fmpq_mat_entry(m_, i, j)); }
  void set(long i, long j, const Rational& value) { fmpq_set(fmpq_mat_entry(m_, i, j), value.raw()); }
  const fmpq* entry(long i, long j) const { return fmpq_mat_entry(m_, i, j); }
  bool is_zero() const { return fmpq_mat_is_zero(m_) != 0; }

  friend RationalMatrix operator*(const RationalMatrix& a, const RationalMatrix& b);
  friend RationalMatrix operator+(const RationalMatrix& a, const RationalMatrix& b);
  friend RationalMatrix operator*(const Rational& c, const RationalMatrix& a);
  friend bool operator==(const RationalMatrix& a, const RationalMatrix& b) {
    return a.rows() == b.rows() && a.columns() == b.columns() && fmpq_mat_equal(a.m_, b.m_) != 0;
  }
  std::vector<Rational> operator*(const std::vector<Rational>& x) const;

  RationalMatrix transposed() const;
  RationalMatrix block(long row, long column, long rows, long columns) const;
  std::optional<RationalMatrix> inverse() const;  // nullopt if singular; required: square
  Rational determinant() const;                   // required: square
  long rank() const;
  // A basis of {x : A x = 0}, one vector a column.
  RationalMatrix kernel() const;
  // det(x I - A) as a primitive integer polynomial in x; its monic form is it divided by its leading coefficient.
  Polynomial characteristic_polynomial() const;

 private:
  fmpq_mat_t m_;
};

// p(A) for an integer polynomial p in one variable.
RationalMatrix evaluate(const Polynomial& p, const RationalMatrix& a);

}  // namespace twoscale::analysis
