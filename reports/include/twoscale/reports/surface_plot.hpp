// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of surfaces as plain data: quads of grids, lit and sorted by depth, drawn by gnuplot (plot.hpp).
#pragma once

#include <string>
#include <vector>

#include "twoscale/kernels/grid_io.hpp"
#include "twoscale/reports/plot.hpp"

namespace twoscale::reports {

// A grid of points in space: point (i, j) is values[3*(i*columns + j)], ...
struct Sheet {
  std::vector<double> values;
  kernels::GridSize size;
  kernels::Closings closings;
};

// The first three columns (z = 0 where there are two), thinned to at most `quads_each_way` quads in each direction; the
// last row and column are kept. Throws Error(bad_input) for fewer than two columns.
Sheet sheet(const kernels::PointGrid& grid, kernels::Closings closings, std::size_t quads_each_way = 72);

struct SurfacePicture {
  Sheet sheet;
  std::string title;
  bool net = false;   // a control net: pale faces, strong edges
  double tilt = 62;   // degrees from looking down
  double turn = 125;  // degrees about the z axis
  int width = 460;
  int height = 380;
};

// Errors as gnuplot_script and render of plot.hpp; also a sheet without quads.
std::string gnuplot_script(const SurfacePicture& picture, ImageFormat format);
std::string render(const SurfacePicture& picture, ImageFormat format);

}  // namespace twoscale::reports
