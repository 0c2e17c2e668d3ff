// SPDX-License-Identifier: GPL-3.0-or-later
// Refinement of Hermite data files by the scheme of hermite2010, in doubles or with any number of digits.
//
// Columns: fx,fy[,fz],px,..,rx,..[,sigma]; or points alone, x,y[,z] or fx,fy[,fz][,sigma]. Without a header 2 or 3
// numbers are points, 6 and 9 have p and r, 7 and 10 also sigma. What is not there is found (kernels/hermite.hpp).
#pragma once

#include "twoscale/lowering/refine_points.hpp"
#include "twoscale/symbolic/exact_real.hpp"

namespace twoscale::lowering {

struct HermiteOptions {
  unsigned levels = 1;
  bool closed = true;
  long digits = 0;           // as in RefineOptions; the numbers that come out are correct for the file's numbers
  bool all_columns = false;  // p, r and sigma come out even if they did not go in
};

struct HermiteResult {
  kernels::PointSet points;          // the columns of the input (all_columns: all), vertex 0 first
  std::optional<double> first_pole;  // w* of the data, where it matters: printed tension, w != 1 or all_columns
};

// Required: hermite_tension(scheme). `w` replaces the scheme's own tension. A last vertex of a closed polygon that
// repeats the first one, p and r included, is left out.
// Errors (bad_input): columns that are no Hermite data, and what kernels::HermiteCurve refuses; too many points;
// Error(undecided) if a digit could not be decided.
HermiteResult refine_hermite(const Scheme& scheme, const std::optional<ExactReal>& w, const kernels::PointSet& points,
                             const HermiteOptions& options);

// The curve alone, for formats that know nothing else: columns x, y[, z].
kernels::PointSet points_alone(const kernels::PointSet& points);

}  // namespace twoscale::lowering
