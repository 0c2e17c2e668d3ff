// SPDX-License-Identifier: 0BSD
// Points as ASCII PLY: vertices, and edges between neighbours.
#include <algorithm>

#include "points_text.hpp"

namespace twoscale::kernels {

void text::append_ply_vertices(std::string& out, const PointSet& points, const std::string& other_elements) {
  const std::vector<std::string> columns = points.columns.empty() ? default_columns(points.dim) : points.columns;
  std::vector<std::string> missing;
  for (const char* name : {"x", "y", "z"}) {
    if (std::find(columns.begin(), columns.end(), name) == columns.end()) missing.emplace_back(name);
  }
  const std::size_t n = points.size();
  out += "element vertex " + std::to_string(n) + '\n';
  for (const std::string& name : columns) out += "property double " + name + '\n';
  for (const std::string& name : missing) out += "property double " + name + '\n';
  out += other_elements + "end_header\n";
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t c = 0; c < points.dim; ++c) {
      if (c != 0) out += ' ';
      out += printed(points, j * points.dim + c);
    }
    for (std::size_t c = 0; c < missing.size(); ++c) out += " 0";
    out += '\n';
  }
}

std::string to_ply(const PointSet& points, bool closed) {
  text::check_points(points, "ply");
  const std::size_t n = points.size();
  const std::size_t edges = n < 2 ? 0 : (closed && n > 2 ? n : n - 1);
  std::string out = "ply\nformat ascii 1.0\ncomment polyline of twoscale\n";
  text::append_ply_vertices(out, points,
                            "element edge " + std::to_string(edges) + "\nproperty int vertex1\nproperty int vertex2\n");
  for (std::size_t j = 0; j < edges; ++j) out += std::to_string(j) + ' ' + std::to_string((j + 1) % n) + '\n';
  return out;
}

}  // namespace twoscale::kernels
