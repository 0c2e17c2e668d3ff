// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Square matrices of rational numbers.
#pragma once

#include "twoscale/check/json.hpp"
#include "twoscale/check/number.hpp"
#include "twoscale/check/univariate.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace twoscale::check {

/// The entry in row i, column j is entries[i*size + j]/scale; scale > 0.
struct Matrix {
  std::size_t size = 0;
  std::vector<Integer> entries;
  Integer scale = 1;

  const Integer& at(std::size_t i, std::size_t j) const { return entries[i * size + j]; }
};

/// Reads an array of rows, each an array of rationals; `size` rows and columns, any number up to limits::matrix if 0.
Matrix read_matrix(const Value& value, std::size_t size, const std::string& where, Meter& meter);

/// Divides entries and scale by their common divisor.
void reduce(std::vector<Integer>& entries, Integer& scale, Meter& meter);

Matrix multiply(const Matrix& a, const Matrix& b, Meter& meter);

/// matrices[word.back()] * ... * matrices[word.front()]; the word is not empty.
Matrix product(std::span<const Matrix> matrices, std::span<const std::size_t> word, Meter& meter);

/// The inverse, if there is one.
std::optional<Matrix> inverse(const Matrix& a, Meter& meter);

/// Rows and columns first, ..., first + size - 1.
Matrix diagonal_block(const Matrix& a, std::size_t first, std::size_t size, Meter& meter);

/// det(x - scale*a): the characteristic polynomial of the integer matrix `entries`, by Faddeev and LeVerrier.
Dense characteristic_polynomial(const Matrix& a, Meter& meter);

/// The primitive polynomial mu of least degree with mu(a) v = 0, v a vector of integers, not 0.
Dense minimal_polynomial(const Matrix& a, std::vector<Integer> v, Meter& meter);

/// Are all eigenvalues of a less than `bound` > 0 in absolute value?
bool spectral_radius_below(const Matrix& a, const Fraction& bound, Meter& meter);

}  // namespace twoscale::check
