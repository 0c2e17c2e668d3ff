// SPDX-License-Identifier: 0BSD
// The sparse matrix of the refinement of a closed polygon: new points = matrix * old points.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "twoscale/kernels/mask_table.hpp"

namespace twoscale::kernels {

/// Rows one after the other (CSR): row i has sizes[i] entries from offsets[i] on, columns (indices) ascending.
struct RefinementMatrix {
  long points = 0;  ///< columns: points of the polygon
  std::vector<int> sizes;
  std::vector<int> offsets;
  std::vector<int> indices;  ///< of old points, from 0
  std::vector<double> weights;
  std::string error;  ///< bound for the sum of the errors of the weights of any row
};

/// All steps of the table, K = table.levels.size(), as one matrix with points * arity^K rows; new point i belongs to
/// the parameter (i + p)/arity^K. K = 1: the weights are the doubles of the table (added up where the polygon is
/// shorter than the mask); more levels: products and sums in double precision, in a fixed order. Throws Error
/// (bad_input) for K = 0, points < 3, or more than 2^24 entries.
RefinementMatrix refinement_matrix(const MaskTable& table, long points);

}  // namespace twoscale::kernels
