// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace twoscale::reports {

namespace {

// Turned about z by 35 degrees, seen from 28 degrees above the horizon.
const double turn_c = std::cos(0.61), turn_s = std::sin(0.61);
const double rise_c = std::cos(0.49), rise_s = std::sin(0.49);

std::array<double, 2> image(double x, double y, double z) {
  return {turn_c * x + turn_s * y, rise_c * z + rise_s * (turn_c * y - turn_s * x)};
}

}  // namespace

Frame project(std::vector<Line>& lines) {
  double low[3], high[3];
  for (std::size_t c = 0; c < 3; ++c) {
    low[c] = high[c] = lines[0].values[c];
    for (const Line& l : lines)
      for (std::size_t i = c; i < l.values.size(); i += 3) {
        low[c] = std::min(low[c], l.values[i]);
        high[c] = std::max(high[c], l.values[i]);
      }
  }
  for (Line& l : lines) {
    std::vector<double> plane;
    for (std::size_t i = 0; i + 2 < l.values.size(); i += 3) {
      const auto p = image(l.values[i], l.values[i + 1], l.values[i + 2]);
      plane.insert(plane.end(), p.begin(), p.end());
    }
    l.values = std::move(plane);
    l.dim = 2;
  }
  Frame f;
  const auto edge = [&](double x1, double y1, double z1, double x2, double y2, double z2) {
    const auto a = image(x1, y1, z1), b = image(x2, y2, z2);
    f.edges.insert(f.edges.end(), {a[0], a[1], b[0], b[1]});
  };
  const auto label = [&](double x, double y, double z, const char* side, const char* name, std::size_t c) {
    const auto p = image(x, y, z);
    const auto end = [&](double v) { return std::abs(v) < 1e-9 * (high[c] - low[c]) ? 0.0 : v; };  // no rounding errors
    f.labels.push_back({p[0], p[1], side, fmt::format("{} = {:.3g} … {:.3g}", name, end(low[c]), end(high[c]))});
  };
  // The floor, and the two walls behind the curve; the corner (low x, high y) is the farthest.
  for (double z : {low[2], high[2]}) {
    edge(low[0], low[1], z, low[0], high[1], z);
    edge(low[0], high[1], z, high[0], high[1], z);
  }
  edge(low[0], low[1], low[2], high[0], low[1], low[2]);
  edge(high[0], low[1], low[2], high[0], high[1], low[2]);
  edge(low[0], low[1], low[2], low[0], low[1], high[2]);
  edge(low[0], high[1], low[2], low[0], high[1], high[2]);
  edge(high[0], high[1], low[2], high[0], high[1], high[2]);
  label((low[0] + high[0]) / 2, low[1], low[2], "right", "x", 0);
  label(high[0], (low[1] + high[1]) / 2, low[2], "left", "y", 1);
  label(low[0], high[1], high[2], "center", "z", 2);
  return f;
}

}  // namespace twoscale::reports
