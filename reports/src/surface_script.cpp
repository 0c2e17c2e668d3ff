// SPDX-License-Identifier: GPL-3.0-or-later
// A surface as a gnuplot script: pm3d quads in depth order, coloured by height, lit; no axes, one unit in all
// directions.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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

struct Box {
  double low[3], high[3];
  double length(std::size_t c) const { return high[c] - low[c]; }
  double middle(std::size_t c) const { return low[c] + (high[c] - low[c]) / 2; }
};

Box box_of(const std::vector<double>& points) {
  Box b{{points[0], points[1], points[2]}, {points[0], points[1], points[2]}};
  for (std::size_t i = 0; i < points.size(); ++i) {
    b.low[i % 3] = std::min(b.low[i % 3], points[i]);
    b.high[i % 3] = std::max(b.high[i % 3], points[i]);
  }
  return b;
}

// Turned about z, then tilted: right, up, away from the viewer (a map in gnuplot is seen from below).
std::vector<double> seen_from(const std::vector<double>& points, double tilt, double turn) {
  const double degree = std::numbers::pi / 180;
  const double tc = std::cos(turn * degree), ts = std::sin(turn * degree);
  const double rc = std::cos(tilt * degree), rs = std::sin(tilt * degree);
  std::vector<double> seen;
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
    const double x = tc * points[i] + ts * points[i + 1];
    const double y = tc * points[i + 1] - ts * points[i];
    const double z = points[i + 2];
    seen.insert(seen.end(), {x, rc * y + rs * z, rs * y - rc * z});
  }
  return seen;
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
  for (const double x : s.values)
    if (!std::isfinite(x) || std::abs(x) > 1e100)
      bad_input("picture: a point is too far away to be drawn", fmt::format("{}", x));
  const std::vector<double> seen = seen_from(s.values, picture.tilt, picture.turn);
  const Box box = box_of(seen), body = box_of(s.values);
  std::string out = "set terminal " + terminal(format, picture.width, picture.height) + "\nset encoding utf8\n";
  out += "unset border\nunset tics\nunset key\nunset colorbox\nset view map\n";
  const int top = picture.title.empty() ? 0 : 34;
  out += fmt::format(
      "set lmargin at screen 0\nset rmargin at screen 1\nset bmargin at screen 0\nset tmargin at screen {:.6f}\n",
      1 - static_cast<double>(top) / picture.height);
  // One unit is equally long in all directions, and the surface fills the picture but for a rim.
  const double width = picture.width, height = picture.height - top;
  const double unit = 1.06 * std::max({box.length(0) / width, box.length(1) / height, 1e-300});
  for (const std::size_t c : {0U, 1U}) {
    const double half = unit * (c == 0 ? width : height) / 2;
    out += fmt::format("set {}range [{:.9g}:{:.9g}]\n", c == 0 ? 'x' : 'y', box.middle(c) - half, box.middle(c) + half);
  }
  const double depth = box.length(2) > 0 ? box.length(2) : 1;
  out += fmt::format("set zrange [{:.9g}:{:.9g}]\n", box.middle(2) - depth, box.middle(2) + depth);
  out += "set cbrange [0:1]\n";
  out += picture.net ? "set palette defined (0 '#e8eef6', 1 '#e8eef6')\n"
                       "set pm3d depthorder border lc rgb '#334155' lw 1.2\n"
                     : "set palette defined (0 '#2f5fa8', 0.35 '#3f9fc0', 0.65 '#7cc4a4', 1 '#f0d58a')\n"
                       "set pm3d depthorder border lc rgb '#1f2937' lw 0.25\n"
                       "set pm3d lighting primary 0.45 specular 0.15\n";
  if (!picture.title.empty()) out += "set title " + gnuplot_string(picture.title) + "\n";
  out += "$surface << END\n";
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      const std::size_t at = 3 * (i % s.size.rows * s.size.columns + j % s.size.columns);
      const double colour = body.length(2) > 0 ? (s.values[at + 2] - body.low[2]) / body.length(2) : 0.5;
      out += fmt::format("{:.7g} {:.7g} {:.7g} {:.4g}\n", seen[at], seen[at + 1], seen[at + 2], colour);
    }
    out += '\n';
  }
  return out + "END\nsplot $surface using 1:2:3:4 with pm3d\n";
}

std::string render(const SurfacePicture& picture, ImageFormat format) {
  return image_of(gnuplot_script(picture, format));
}

}  // namespace twoscale::reports
