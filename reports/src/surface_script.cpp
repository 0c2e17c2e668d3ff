// SPDX-License-Identifier: GPL-3.0-or-later
// A surface as a gnuplot script: pm3d quads in depth order, coloured by height, lit; no axes, one unit in all
// directions.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gnuplot.hpp"
#include "twoscale/reports/surface_plot.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::reports {

namespace {

// Indices 0..n-1, every `step`-th and the last one; the closing index n (for 0) too.
std::vector<std::size_t> kept(std::size_t n, bool closed, std::size_t most) {
  const std::size_t quads = closed ? n : n - 1;
  const std::size_t step = std::max<std::size_t>(1, (quads + most - 1) / most);
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < n; i += step) list.push_back(i);
  if (!closed && list.back() != n - 1) list.push_back(n - 1);
  return list;
}

}  // namespace

Sheet sheet(const kernels::PointGrid& grid, kernels::Closings closings, std::size_t quads_each_way) {
  const std::size_t dim = grid.points.dim;
  if (dim < 2) bad_input("a surface needs two or three columns, not", std::to_string(dim));
  const auto rows = kept(grid.size.rows, closings.u, quads_each_way);
  const auto columns = kept(grid.size.columns, closings.v, quads_each_way);
  Sheet s{{}, {rows.size(), columns.size()}, closings};
  for (const std::size_t i : rows)
    for (const std::size_t j : columns)
      for (std::size_t c = 0; c < 3; ++c)
        s.values.push_back(c < dim ? grid.points.values[(i * grid.size.columns + j) * dim + c] : 0.0);
  return s;
}

std::string gnuplot_script(const SurfacePicture& picture, ImageFormat format) {
  const Sheet& s = picture.sheet;
  const std::size_t rows = s.size.rows + (s.closings.u ? 1 : 0), columns = s.size.columns + (s.closings.v ? 1 : 0);
  if (rows < 2 || columns < 2 || s.values.size() != 3 * s.size.rows * s.size.columns)
    bad_input("picture: a surface needs at least two rows and two columns of points");
  double low[3], high[3];
  for (std::size_t i = 0; i < s.values.size(); ++i) {
    const double x = s.values[i];
    if (!std::isfinite(x) || std::abs(x) > 1e100)
      bad_input("picture: a point is too far away to be drawn", fmt::format("{}", x));
    low[i % 3] = i < 3 ? x : std::min(low[i % 3], x);
    high[i % 3] = i < 3 ? x : std::max(high[i % 3], x);
  }
  std::string out = "set terminal " + terminal(format, picture.width, picture.height) + "\nset encoding utf8\n";
  out += "unset border\nunset tics\nunset key\nunset colorbox\n";
  out += fmt::format(
      "set lmargin at screen 0.02\nset rmargin at screen 0.98\nset bmargin at screen 0.02\n"
      "set tmargin at screen {}\n",
      picture.title.empty() ? "0.98" : "0.90");
  out += fmt::format("set view {:.6g},{:.6g},1.4\nset view equal xyz\nset xyplane at {:.9g}\n", picture.tilt,
                     picture.turn, low[2]);
  for (const int c : {0, 1, 2}) {
    const double half = high[c] > low[c] ? (high[c] - low[c]) / 2 : 0.5;
    const double middle = low[c] + (high[c] - low[c]) / 2;
    out += fmt::format("set {}range [{:.9g}:{:.9g}]\n", "xyz"[c], middle - half, middle + half);
  }
  out += "set cbrange [0:1]\n";
  out += picture.net ? "set palette defined (0 '#e8eef6', 1 '#e8eef6')\n"
                       "set pm3d depthorder border lc rgb '#334155' lw 1.2\n"
                     : "set palette defined (0 '#2f5fa8', 0.35 '#3f9fc0', 0.65 '#7cc4a4', 1 '#f0d58a')\n"
                       "set pm3d depthorder border lc rgb '#1f2937' lw 0.25\n"
                       "set pm3d lighting primary 0.45 specular 0.15\n";
  if (!picture.title.empty()) out += "set title " + quoted(picture.title) + "\n";
  out += "$surface << END\n";
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      const double* p = &s.values[3 * (i % s.size.rows * s.size.columns + j % s.size.columns)];
      out += fmt::format("{:.7g} {:.7g} {:.7g} {:.4g}\n", p[0], p[1], p[2],
                         high[2] > low[2] ? (p[2] - low[2]) / (high[2] - low[2]) : 0.5);
    }
    out += '\n';
  }
  return out + "END\nsplot $surface using 1:2:3:4 with pm3d\n";
}

std::string render(const SurfacePicture& picture, ImageFormat format) {
  return image_of(gnuplot_script(picture, format));
}

}  // namespace twoscale::reports
