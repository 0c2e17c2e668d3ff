// SPDX-License-Identifier: GPL-3.0-or-later
// Refinement on arbitrary knots (kernels/nonuniform.hpp) with any number of proved digits.
#pragma once

#include "twoscale/kernels/nonuniform.hpp"
#include "twoscale/symbolic/sampled_scheme.hpp"

namespace twoscale::lowering {

// As kernels::refine_on_knots, but the numbers of `points` are read exactly from their texts, and every number of the
// output has `digits` correct significant digits (tokens). Where the ratios of the knot intervals are rational (given,
// uniform; equal lengths) everything is rational arithmetic; otherwise knots and points are enclosed in balls, and a
// number that cannot be told from 0 with twice the digits becomes 0. Throws Error or kernels::Error (bad_input), also
// for digits outside 17..10000; Error(undecided) if a digit could not be decided.
kernels::PointSet refine_on_knots(const kernels::PointSet& points, kernels::KnotRule rule,
                                  const kernels::KnotOptions& options, long digits);

// A sampled rule of any order by its weights: they are evaluated exactly at the doubles of the interval ratios and edge
// parameters and rounded, once for every pattern of them; points are doubles. Without a column `lambda` all edge
// parameters are at rest; without `tag` both ends of every edge that is not at rest are tagged. Linear in the output;
// slower than a kernel, and without its care for neighbouring points that nearly coincide. Throws Error or
// kernels::Error (bad_input): Boundary::space, intervals that are not positive, edge parameters outside [0, 1], too few
// points.
kernels::PointSet refine_by_weights(const SampledScheme& scheme, const kernels::PointSet& points,
                                    const kernels::KnotOptions& options);

// The same in rational arithmetic, every number of the output with `digits` correct significant digits (tokens). Throws
// Error(bad_input) also where the ratios of the intervals are not rational: they are for given and uniform intervals,
// and for edges of equal length.
kernels::PointSet refine_by_weights(const SampledScheme& scheme, const kernels::PointSet& points,
                                    const kernels::KnotOptions& options, long digits);

}  // namespace twoscale::lowering
