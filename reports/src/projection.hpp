// SPDX-License-Identifier: GPL-3.0-or-later
// Space curves seen from afar: a parallel projection to the plane, with the box around them.
#pragma once

#include <string>
#include <vector>

#include "twoscale/reports/plot.hpp"

namespace twoscale::reports {

struct Frame {
  std::vector<double> edges;  // x1, y1, x2, y2 of one edge after the other
  struct Label {
    double x, y;
    const char* side;  // gnuplot's alignment: left, center, right
    std::string text;
  };
  std::vector<Label> labels;
};

// Replaces the lines (dim 3) by their projections (dim 2): one unit is equally long in all directions parallel to the
// image plane, the z axis points up, the viewer stands above.
Frame project(std::vector<Line>& lines);

}  // namespace twoscale::reports
