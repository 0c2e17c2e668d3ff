// SPDX-License-Identifier: GPL-3.0-or-later
// Curves from schemes in double precision, and what can be measured on them.
//
// Points are row-major: coordinate c of point j is values[j*dim + c].
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "twoscale/kernels/refine.hpp"
#include "twoscale/lowering/lower.hpp"
#include "twoscale/reports/plot.hpp"
#include "twoscale/symbolic/scheme.hpp"

namespace twoscale::reports {

// Refined points; point j belongs to the parameter first + j*step, in units of the spacing of level 0, where point 0 of
// the input (the first that is not beyond an end) has index 0.
struct Refined {
  std::vector<double> values;
  std::size_t dim = 0;
  double first = 0;
  double step = 1;
  std::size_t size() const { return values.size() / dim; }
  double parameter(std::size_t j) const { return first + static_cast<double>(j) * step; }
};

// `levels` steps from `points`. Masks are correctly rounded doubles. Throws Error(bad_input) for a singular value of a
// parameter (naming it and the level) and for points that do not suffice.
Refined refine_points(const Scheme& scheme, const lowering::Binding& binding, std::span<const double> points,
                      std::size_t dim, int levels, kernels::Boundary boundary);

// The basic limit function: data 1 at index 0, 0 elsewhere; dim = 2, (parameter, value), over its support.
Refined basic_limit_function(const Scheme& scheme, const lowering::Binding& binding, int levels);

// How many points beyond each end the scheme needs (Boundary::given).
kernels::EndPoints points_beyond_ends(const Scheme& scheme);

// max_j |point_j - curve(parameter_j)|, Euclidean, over the diagonal of the curve's bounding box.
double largest_deviation(const Refined& points, const std::function<void(double, double*)>& curve);

// The largest distance of a point to the polygon (to its nearest edge), over the diagonal of the polygon's box.
double distance_to_polygon(const Refined& points, std::span<const double> polygon, bool closed);

// Sum of the absolute turning angles of a plane polygon, in full turns; a convex closed curve has 1.
double total_turning(std::span<const double> plane_points, bool closed);

// A curve in the plane as a line of a picture; and a polygon.
Line curve_line(std::vector<double> plane_points, bool closed, std::string title, int colour);
Line polygon_line(std::vector<double> plane_points, bool closed, std::string title = "polygon");

// Signed curvature 1/R of the circle through points j-1, j, j+1 of a plane curve, positive for a left turn; NaN at the
// ends of an open curve and where points coincide.
std::vector<double> curvature(std::span<const double> plane_points, bool closed);

// Teeth across the curve, as long as its curvature (the longest is a quarter of its size), and the line through their
// tips; empty if all points coincide.
std::vector<Line> curvature_comb(std::span<const double> plane_points, bool closed);

}  // namespace twoscale::reports
