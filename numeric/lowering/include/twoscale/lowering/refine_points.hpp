// SPDX-License-Identifier: GPL-3.0-or-later
// Refinement of points files: in doubles through the vectorised kernels, or with any number of proved digits.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "twoscale/kernels/points_io.hpp"
#include "twoscale/kernels/refine.hpp"
#include "twoscale/lowering/lower.hpp"

namespace twoscale::lowering {

struct RefineOptions {
  unsigned levels = 1;
  kernels::Boundary boundary = kernels::Boundary::closed;
  // 0: double arithmetic with correctly rounded masks. Else 17..10000: the numbers of `points` are read exactly from
  // their texts, everything is enclosed in balls, and every number of the output has that many correct significant
  // digits (tokens). A number that cannot be told from 0 with twice the digits (smaller than 10^(-2 digits) times the
  // largest of the output) is printed as 0.
  long digits = 0;
  int threads = 0;  // at most so many for doubles, 0: one for each core
  // For refined_rows.
  bool limit = false;           // points of the limit curve, at the parameters of the refined points
  bool derivative = false;      // with limit: columns d<name>, the derivative with respect to the parameter (spacing 1)
  bool curvature = false;       // with limit: a column, signed in the plane (2 columns), not negative in space (3)
  std::optional<double> chord = {};  // stop before `levels` when the limit curve is as near to the polygon (chord.hpp)
};

// Points out: the same columns, point 0 first (kernels/refine.hpp says which parameters they belong to).
// Throws Error or kernels::Error (bad_input): unusable options, too few points, more than 2^31 points out, no space for
// Boundary::space, a singular step; Error(undecided) if a digit could not be decided.
kernels::PointSet refine_points(const Scheme& scheme, const Binding& binding, const kernels::PointSet& points,
                                const RefineOptions& options);

// The same in doubles (options.digits == 0), in consecutive pieces, for outputs that do not fit into memory.
struct RefinedRows {
  unsigned levels = 0;  // with options.chord perhaps fewer than asked for
  std::vector<std::string> columns;
  std::size_t count = 0;  // of all points that come out
  // Calls with the values of some rows. Throws Error(bad_input) for a number that does not fit a double, for a
  // curvature where the derivative is 0.
  std::function<void(const std::function<void(std::span<const double>)>&)> for_each;
};
// Throws as refine_points; also as limit_stencils, levels_for_chord, for ends whose limit is not that of the scheme
// (linear, space), for two columns of one name.
RefinedRows refined_rows(const Scheme& scheme, const Binding& binding, const kernels::PointSet& points,
                         const RefineOptions& options);

// Each edge its own tension (beccari2007, section 6): the column `v0` of `points` is the v^0 of the edge that starts at
// the point, and the new points of an edge follow the mask of its own v^{k+1}. Out come the same columns; v0 is then
// that of the refined edge as level-0 data, v^{[K]} of the edge it comes from, so that refining the result goes on
// where this stopped (up to the rounding of v0). One table is lowered for each distinct value. See
// docs/per-edge-tension.md. Throws as refine_points; also if the scheme is not interpolating with one level variable of
// free frequency, for a column v0 that is missing, and for a value that is not > -1.
kernels::PointSet refine_edges(const Scheme& scheme, const kernels::PointSet& points, const RefineOptions& options);
// Do the points bring a v^0 for each edge? The points without that column.
bool has_edge_tension(const kernels::PointSet& points);
kernels::PointSet without_edge_tension(const kernels::PointSet& points);

}  // namespace twoscale::lowering
