// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/analysis/rational_matrix.hpp"

#include <flint/fmpq_poly.h>

namespace twoscale::analysis {

RationalMatrix RationalMatrix::identity(long n) {
  RationalMatrix r(n, n);
  fmpq_mat_one(r.m_);
  return r;
}

RationalMatrix RationalMatrix::from_columns(long rows, const std::vector<std::vector<Rational>>& columns) {
  RationalMatrix r(rows, static_cast<long>(columns.size()));
  for (long j = 0; j < r.columns(); ++j)
    for (long i = 0; i < rows; ++i) r.set(i, j, columns[static_cast<size_t>(j)][static_cast<size_t>(i)]);
  return r;
}

RationalMatrix operator*(const RationalMatrix& a, const RationalMatrix& b) {
  RationalMatrix r(a.rows(), b.columns());
  fmpq_mat_mul(r.m_, a.m_, b.m_);
  return r;
}

RationalMatrix operator+(const RationalMatrix& a, const RationalMatrix& b) {
  RationalMatrix r(a.rows(), a.columns());
  fmpq_mat_add(r.m_, a.m_, b.m_);
  return r;
}

RationalMatrix operator*(const Rational& c, const RationalMatrix& a) {
  RationalMatrix r(a.rows(), a.columns());
  fmpq_mat_scalar_mul_fmpq(r.m_, a.m_, const_cast<fmpq*>(c.raw()));
  return r;
}

std::vector<Rational> RationalMatrix::operator*(const std::vector<Rational>& x) const {
  std::vector<Rational> y(static_cast<size_t>(rows()));
  for (long i = 0; i < rows(); ++i)
    for (long j = 0; j < columns(); ++j)
      fmpq_addmul(y[static_cast<size_t>(i)].raw(), fmpq_mat_entry(m_, i, j), x[static_cast<size_t>(j)].raw());
  return y;
}

RationalMatrix RationalMatrix::transposed() const {
  RationalMatrix r(columns(), rows());
  fmpq_mat_transpose(r.m_, m_);
  return r;
}

RationalMatrix RationalMatrix::block(long row, long column, long n, long k) const {
  RationalMatrix r(n, k);
  for (long i = 0; i < n; ++i)
    for (long j = 0; j < k; ++j) fmpq_set(fmpq_mat_entry(r.m_, i, j), fmpq_mat_entry(m_, row + i, column + j));
  return r;
}

std::optional<RationalMatrix> RationalMatrix::inverse() const {
  RationalMatrix r(rows(), rows());
  if (fmpq_mat_inv(r.m_, m_) == 0) return std::nullopt;
  return r;
}

Rational RationalMatrix::determinant() const {
  Rational r;
  fmpq_mat_det(r.raw(), m_);
  return r;
}

long RationalMatrix::rank() const {
  RationalMatrix r(rows(), columns());
  return fmpq_mat_rref(r.m_, m_);
}

RationalMatrix RationalMatrix::kernel() const {
  RationalMatrix echelon(rows(), columns());
  const long rank = fmpq_mat_rref(echelon.m_, m_);
  std::vector<long> pivots;
  std::vector<long> free;
  for (long j = 0; j < columns(); ++j) {
    const auto row = static_cast<long>(pivots.size());
    if (row < rank && !fmpq_is_zero(fmpq_mat_entry(echelon.m_, row, j)))
      pivots.push_back(j);
    else
      free.push_back(j);
  }
  RationalMatrix r(columns(), static_cast<long>(free.size()));
  for (size_t k = 0; k < free.size(); ++k) {
    fmpq_one(fmpq_mat_entry(r.m_, free[k], static_cast<long>(k)));
    for (size_t i = 0; i < pivots.size(); ++i)
      fmpq_neg(fmpq_mat_entry(r.m_, pivots[i], static_cast<long>(k)),
               fmpq_mat_entry(echelon.m_, static_cast<long>(i), free[k]));
  }
  return r;
}

Polynomial RationalMatrix::characteristic_polynomial() const {
  fmpq_poly_t p;
  fmpq_poly_init(p);
  fmpq_mat_charpoly(p, m_);
  fmpz_poly_t numerator;
  fmpz_poly_init(numerator);
  fmpq_poly_get_numerator(numerator, p);
  Polynomial result = Polynomial::univariate("x", numerator);
  fmpz_poly_clear(numerator);
  fmpq_poly_clear(p);
  return result;
}

RationalMatrix evaluate(const Polynomial& p, const RationalMatrix& a) {
  RationalMatrix r(a.rows(), a.rows());
  const RationalMatrix one = RationalMatrix::identity(a.rows());
  const fmpz_poly_struct* view = p.univariate_view();
  for (long i = fmpz_poly_degree(view); i >= 0; --i) r = r * a + Rational(fmpz_poly_get_coeff_ptr(view, i)) * one;
  return r;
}

}  // namespace twoscale::analysis
