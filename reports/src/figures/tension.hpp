// SPDX-License-Identifier: GPL-3.0-or-later
// Does a greater v^0 always bring the limit curve closer to the polygon? Measured over a fine grid of v^0.
#pragma once

#include <string>
#include <vector>

#include "figures/figures.hpp"
#include "twoscale/symbolic/scheme.hpp"

namespace twoscale::reports {

struct TensionCourse {
  std::string label;
  std::string words;      // "falls from −0.90 to 0.20, rises from 0.20 to 3.00"
  bool monotone = true;   // it falls wherever the scheme exists
  double last_rise = -1;  // v^0 at the end of the last rise
  double at_end = 0;      // the distance at v^0 = 9999
};

struct TensionSweep {
  std::string html;  // picture and table
  std::vector<TensionCourse> courses;
};
// For 107 values of v^0 from -0.95 to 9999, 1 + v^0 equally spaced in the logarithm.
TensionSweep tension_sweep(Part& part, const std::vector<NamedScheme>& schemes, const Polygon& polygon);

// The largest distance of a point of the limit curve to the polygon, over the diagonal of the polygon's box. NaN where
// the scheme does not exist.
double distance_to_polygon(const Scheme& scheme, const std::string& v0, const Polygon& polygon);

std::string v0_text(double v0);  // with two digits after the point below 100

}  // namespace twoscale::reports
