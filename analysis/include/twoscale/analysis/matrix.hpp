// SPDX-License-Identifier: GPL-3.0-or-later
// Dense exact matrices over Q and over Q(parameters).
//
// For code that is written once for both scalars. Matrix<Rational> hands its work to RationalMatrix (FLINT), which code
// that has rational matrices only uses itself. Matrix<RationalFunction> clears denominators and eliminates without
// fractions over Z[parameters] (Bareiss 1968), so that nothing is inverted and no denominator is factored on the way;
// the characteristic polynomial is taken block by block of the block triangular form and, for blocks that commute with
// the reversal of indices, of the even and the odd part apart.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "twoscale/symbolic/rational_function.hpp"

namespace twoscale::analysis {

// Row-major; rows and columns counted from 0. T is Rational or RationalFunction.
template <class T>
class Matrix {
 public:
  Matrix() = default;
  Matrix(std::size_t rows, std::size_t columns) : rows_(rows), columns_(columns), entries_(rows * columns) {}
  static Matrix identity(std::size_t n) {
    Matrix r(n, n);
    for (std::size_t i = 0; i < n; ++i) r(i, i) = T(1);
    return r;
  }

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  T& operator()(std::size_t i, std::size_t j) { return entries_[i * columns_ + j]; }
  const T& operator()(std::size_t i, std::size_t j) const { return entries_[i * columns_ + j]; }
  friend bool operator==(const Matrix&, const Matrix&) = default;

 private:
  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  std::vector<T> entries_;
};

using SymbolicMatrix = Matrix<RationalFunction>;

template <class T>
Matrix<T> transposed(const Matrix<T>& a) {
  Matrix<T> r(a.columns(), a.rows());
  for (std::size_t i = 0; i < a.rows(); ++i)
    for (std::size_t j = 0; j < a.columns(); ++j) r(j, i) = a(i, j);
  return r;
}

// a x; required: x.size() = a.columns().
template <class T>
std::vector<T> product(const Matrix<T>& a, const std::vector<T>& x) {
  std::vector<T> r(a.rows());
  for (std::size_t i = 0; i < a.rows(); ++i)
    for (std::size_t j = 0; j < a.columns(); ++j)
      if (!a(i, j).is_zero() && !x[j].is_zero()) r[i] += a(i, j) * x[j];
  return r;
}

// Required: a.columns() = b.rows().
Matrix<Rational> product(const Matrix<Rational>& a, const Matrix<Rational>& b);
SymbolicMatrix product(const SymbolicMatrix& a, const SymbolicMatrix& b);

// sum_k p[k] a^k for a square a, by Horner; p ascending, not empty.
template <class T>
Matrix<T> polynomial_of(const Matrix<T>& a, const std::vector<T>& p) {
  const std::size_t n = a.rows();
  Matrix<T> r(n, n);
  for (std::size_t i = 0; i < n; ++i) r(i, i) = p.back();
  for (std::size_t k = p.size() - 1; k-- > 0;) {
    r = product(r, a);
    for (std::size_t i = 0; i < n; ++i) r(i, i) += p[k];
  }
  return r;
}

// a(n-1-i, n-1-j) = a(i, j): the matrix leaves the vectors with x_{n-1-j} = x_j, and those with x_{n-1-j} = -x_j, among
// themselves.
template <class T>
bool commutes_with_reversal(const Matrix<T>& a) {
  const std::size_t n = a.rows();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      if (!(a(i, j) == a(n - 1 - i, n - 1 - j))) return false;
  return true;
}

// Its action on the first (odd: the second) of these spaces, in the coordinates x_0, x_1, ... of the first half.
template <class T>
Matrix<T> symmetric_part(const Matrix<T>& a, bool odd) {
  const std::size_t n = a.rows();
  const std::size_t h = odd ? n / 2 : (n + 1) / 2;
  Matrix<T> r(h, h);
  for (std::size_t i = 0; i < h; ++i)
    for (std::size_t j = 0; j < h; ++j) {
      const std::size_t mirror = n - 1 - j;
      r(i, j) = mirror == j ? a(i, j) : odd ? a(i, j) - a(i, mirror) : a(i, j) + a(i, mirror);
    }
  return r;
}

// Of a square matrix.
Rational determinant(const Matrix<Rational>& a);
RationalFunction determinant(const SymbolicMatrix& a);

// Over Q(parameters): the generic rank.
std::size_t rank(const Matrix<Rational>& a);
std::size_t rank(const SymbolicMatrix& a);

// A basis of { x : a x = 0 }, one vector for each column without a pivot, in their order; entries are integers or
// polynomials without a common factor, the first that is not 0 has a positive leading coefficient.
std::vector<std::vector<Rational>> kernel(const Matrix<Rational>& a);
std::vector<std::vector<RationalFunction>> kernel(const SymbolicMatrix& a);

// nullopt for a singular matrix.
std::optional<Matrix<Rational>> inverse(const Matrix<Rational>& a);
std::optional<SymbolicMatrix> inverse(const SymbolicMatrix& a);

// det(x I - a), ascending, monic.
std::vector<Rational> characteristic_polynomial(const Matrix<Rational>& a);
std::vector<RationalFunction> characteristic_polynomial(const SymbolicMatrix& a);
// The same as a product: those of the diagonal blocks (above), in the order in which they are found.
std::vector<std::vector<RationalFunction>> characteristic_blocks(const SymbolicMatrix& a);

// The matrix over Q if no entry has a variable.
std::optional<Matrix<Rational>> constant(const SymbolicMatrix& a);
SymbolicMatrix symbolic(const Matrix<Rational>& a);

// Multiplies by a scalar so that the entries are integers (polynomials) without a common factor, the first that is not
// 0 with a positive leading coefficient. The zero vector stays.
std::vector<Rational> primitive(const std::vector<Rational>& x);
std::vector<RationalFunction> primitive(const std::vector<RationalFunction>& x);

}  // namespace twoscale::analysis
