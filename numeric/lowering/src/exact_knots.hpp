// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons on knots read exactly from their texts, and written with a number of digits.
#pragma once

#include <optional>
#include <vector>

#include "twoscale/kernels/nonuniform.hpp"
#include "twoscale/symbolic/rational.hpp"

namespace twoscale::lowering {

// The polygon as it is read, edge parameters being `rest` where there is no column; d: what is given, 1, or, for
// intervals from the points, the squared lengths.
kernels::KnotPolygon<Rational> exact_polygon(const kernels::PointSet& points, const kernels::KnotColumns& columns,
                                             const kernels::KnotOptions& options, const Rational& rest);

// Intervals up to a common factor, which rules do not see, if all their ratios are rational. From squared lengths for
// chordal and centripetal knots: over that of the first edge that is not 0.
std::optional<std::vector<Rational>> rational_intervals(const kernels::KnotPolygon<Rational>& p,
                                                        kernels::Parametrization kind);

// The columns of `points` for another polygon, every number rounded to so many significant digits.
kernels::PointSet rounded_points(const kernels::PointSet& points, const kernels::KnotColumns& columns,
                                 const kernels::KnotPolygon<Rational>& p, long digits);

}  // namespace twoscale::lowering
