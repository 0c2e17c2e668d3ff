// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Matrices of polynomials in one variable, vectors of rational functions.
#pragma once

#include "twoscale/check/univariate.hpp"

#include <span>
#include <vector>

namespace twoscale::check {

struct PolynomialMatrix {
  std::size_t rows = 0, columns = 0;
  std::vector<Dense> entries;  ///< row by row

  Dense& at(std::size_t i, std::size_t j) { return entries[i * columns + j]; }
  const Dense& at(std::size_t i, std::size_t j) const { return entries[i * columns + j]; }
};

PolynomialMatrix multiply(const PolynomialMatrix& a, const PolynomialMatrix& b, Meter& meter);

/// matrices[word.back()] * ... * matrices[word.front()]; the word is not empty.
PolynomialMatrix product(std::span<const PolynomialMatrix> matrices, std::span<const std::size_t> word, Meter& meter);

/// Solves (first `count` columns) b = p*(column) for each later column, by elimination without fractions. Returns p,
/// not zero, and leaves in the later columns b_0, ..., b_{count-1}, then what must be zero for a solution to exist.
/// Returns zero if the first columns are linearly dependent over the rational functions. Of a square matrix, with
/// count = columns, p is the determinant.
Dense eliminate(PolynomialMatrix& a, std::size_t count, Meter& meter);

/// v_i = list[i]/denominator.
struct FunctionVector {
  std::vector<Dense> list;
  Dense denominator{Integer(1)};

  bool is_zero() const;
};

/// The same in lowest terms, positive leading coefficient of the denominator: the one spelling of this vector.
FunctionVector reduced(FunctionVector v, Meter& meter);

/// (a v) numerator/denominator, in lowest terms.
FunctionVector image(const PolynomialMatrix& a, const FunctionVector& v, const Dense& numerator,
                     const Dense& denominator, Meter& meter);

}  // namespace twoscale::check
