// SPDX-License-Identifier: 0BSD
// How far the limit curve can be from the polygon of a level.
//
// P_k is the polygon through f^k_j at the parameters (j+p)/m^k. Where every step reproduces 1 and x (with this p),
// P_{k+1} - P_k at a breakpoint of either is a combination of second differences of f^k, and so is a second difference
// of f^{k+1}. With c_k and mu_k the largest sums of absolute weights of these combinations,
//   |F - P_k| <= sum_{j >= k} |P_{j+1} - P_j| <= (c_k + mu_k (c_{k+1} + mu_{k+1} (...))) max_i |D^2 f^k_i|
// in the Euclidean norm. Closed polygons, and linear ends (there the second differences continue mirrored).
#pragma once

#include <cstddef>
#include <span>

#include "twoscale/kernels/mask_table.hpp"
#include "twoscale/kernels/refine.hpp"

namespace twoscale::kernels {

/// The factor of max |D^2 f^k|, k = level; in double arithmetic, rounded up by 1e-9 of itself. After the rows of the
/// table it goes on with the limit mask: a table of a level-dependent scheme should have some 20 rows after `level`.
/// Throws Error (bad_input) if a step does not reproduce 1 and x, or if mu of the limit mask is not below 1 (no bound
/// is found).
double chord_factor(const MaskTable& table, int level);

/// max |D^2 f_i| over a closed polygon, or over the inner points of an open one.
double largest_second_difference(std::span<const double> points, std::size_t dim, bool closed);

/// The first level k <= most_levels at which the limit curve is within `tolerance` of the polygon by this bound, else
/// most_levels. `refiner` is that of `table`. Boundary::given and Boundary::space throw Error (bad_input).
int levels_for_chord(Refiner<double>& refiner, const MaskTable& table, std::span<const double> points, std::size_t dim,
                     int most_levels, Boundary boundary, double tolerance);

}  // namespace twoscale::kernels
