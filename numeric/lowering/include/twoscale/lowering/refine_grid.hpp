// SPDX-License-Identifier: GPL-3.0-or-later
// Refinement of grids by tensor-product schemes, and sums of them, in doubles or with any number of proved digits.
//
// A pair of schemes that reproduce U and V reproduces, along u and v, every product f(u) g(v) with f in U and g in V,
// and so the span of these products. A function sum_l f_l(u) g_l(v) whose f_l do not lie in one such space can be put
// together from several pairs: refine the samples of each f_l(u) g_l(v) by its own pair, and add (jeong2013,
// Example 6.2). One pair does it alone if U holds all f_l and V all g_l.
#pragma once

#include <vector>

#include "twoscale/kernels/grid_io.hpp"
#include "twoscale/kernels/surface.hpp"
#include "twoscale/lowering/lower.hpp"

namespace twoscale::lowering {

// What happens along one direction (kernels/surface.hpp: u from row to row, v along a row).
struct Direction {
  Scheme scheme;
  Binding binding;
  unsigned levels = 1;
  kernels::Boundary boundary = kernels::Boundary::closed;
};

struct Summand {
  kernels::PointGrid grid;
  Direction u, v;
  // 0: the numbers of the grid are exact. Else texts with at least that many significant digits are correctly rounded
  // values, shorter ones exact; with `digits` the digits that come out are then those of the unrounded data.
  long rounded_digits = 0;
};

// Which parameters the points of a refined grid belong to: point (i, j) to (u + i*u_step, v + j*v_step), in units of
// the spacing of level 0; point (0, 0) of the input (the first that is not beyond an end) has u = p_u, v = p_v.
struct GridParameters {
  Rational u, v;
  Rational u_step, v_step;
  friend bool operator==(const GridParameters&, const GridParameters&) = default;
};

struct RefinedGrid {
  kernels::PointGrid grid;  // `closings` as the boundaries say
  GridParameters parameters;
};

// The refined grids of the summands, added. All must give points at the same parameters, with the same columns.
// digits, threads: as RefineOptions says; with doubles the sum runs over the summands in their order.
// Throws Error or kernels::Error (bad_input): no summand, summands that do not fit together (naming the number of the
// summand, from 1), too few points in a direction, more than 2^31 points out, a singular step; Error(undecided) if a
// digit could not be decided.
RefinedGrid refine_sum(const std::vector<Summand>& summands, long digits, int threads = 0);

// How many points beyond each end the scheme needs (Boundary::given).
kernels::EndPoints points_beyond_ends(const Scheme& scheme);

// The sum of one.
RefinedGrid refine_grid(const kernels::PointGrid& grid, const Direction& u, const Direction& v, long digits,
                        int threads = 0);

}  // namespace twoscale::lowering
