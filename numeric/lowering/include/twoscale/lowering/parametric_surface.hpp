// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces given by formulas: sampled exactly, taken apart into what schemes reproduce, compared with what comes out.
//
// For x(u, v) = sum_l f_l(u) g_l(v) there are two ways (symbolic/exponential_sum.hpp):
//   space   one pair of interpolating schemes, of the least spaces that hold all f_l and all g_l;
//   sum     one pair for every two frequencies that occur together, of the least spaces for these: 4-point schemes for
//           trigonometric and hyperbolic functions (jeong2013, Example 6.2); the refined parts are added.
#pragma once

#include <string>
#include <vector>

#include "twoscale/lowering/refine_grid.hpp"
#include "twoscale/symbolic/exponential_sum.hpp"

namespace twoscale::lowering {

// Samples along one direction: `count` points, and with Boundary::given those beyond the ends that a scheme needs.
struct SampledAxis {
  SampleLine line;
  long count = 0;
  kernels::Boundary boundary = kernels::Boundary::closed;
};

struct ParametricSurface {
  std::vector<std::string> columns;         // names of the coordinates
  std::vector<ExponentialSum> coordinates;  // as many
  SampledAxis u, v;
};

enum class SurfaceMethod { space, sum };

// The samples of the surface for a pair of schemes, with `digits` significant digits (correctly rounded; shorter texts
// are exact). Throws Error(bad_input) for more than 10^6 of them.
kernels::PointGrid sampled(const ParametricSurface& surface, const Scheme& u, const Scheme& v, long digits);

// What to refine so that the surface comes out. Throws Error(bad_input) where a closed direction does not close, for a
// boundary that does not keep the functions (linear), and for frequencies of pi and more per step.
std::vector<Summand> summands(const ParametricSurface& surface, SurfaceMethod method, unsigned u_levels,
                              unsigned v_levels, long digits);

// The largest distance of a refined point to the surface at its parameters, over the diagonal of the box around the
// surface at all of them. Double arithmetic.
double estimate_largest_deviation(const RefinedGrid& grid, const ParametricSurface& surface);

}  // namespace twoscale::lowering
