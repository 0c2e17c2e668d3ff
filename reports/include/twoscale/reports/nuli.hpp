// SPDX-License-Identifier: GPL-3.0-or-later
// The paper nuli run again: fundamental splines, the rules derived from them, junctions with the exact region of C^2
// limits of the 6-point scheme, and its figures.
//
// The paper prints no points. Those of the figures are ours, chosen with strongly different distances; knots, edge
// parameters and the orders of the splines are the paper's where it gives them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "twoscale/kernels/nonuniform.hpp"
#include "twoscale/reports/papers.hpp"
#include "twoscale/symbolic/nulifs.hpp"
#include "twoscale/symbolic/polynomial.hpp"

namespace twoscale::reports::nuli {

// The closed NULIFS interpolant of the points of a closed polygon with its knots: `samples` points on each half of an
// edge (between the vertex and the auxiliary knot), from point 0 on, row-major. Everything is computed in rational
// arithmetic from the given doubles and rounded at the end. Required: a closed polygon, intervals > 0; an empty half
// (lambda 0 or 1) has no points.
std::vector<double> interpolant(const kernels::KnotPolygon<double>& polygon, const FundamentalFamily& family,
                                int samples);

// A closed polygon of the figures with centripetal knots; edge parameters 1/2 but for those given as (edge, lambda).
kernels::KnotPolygon<double> hand();
kernels::KnotPolygon<double> with_edge_parameters(kernels::KnotPolygon<double> polygon,
                                                  const std::vector<std::pair<std::size_t, double>>& lambda);
// Knots from the points by another rule.
kernels::KnotPolygon<double> with_knots(kernels::KnotPolygon<double> polygon, kernels::Parametrization kind);

// The condition of nuli6 on C^2 limits at a vertex, F(alpha, k, q) > 0 for k = 1 - lambda_{i-1} <= 1/2, q = lambda_i <=
// 1/2; outside of this corner they are always C^2.
Polynomial smoothness_boundary();

PaperSummary write_report(const std::string& directory, const PaperOptions& options);

}  // namespace twoscale::reports::nuli
