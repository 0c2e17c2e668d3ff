// SPDX-License-Identifier: 0BSD
// The elements of a Wavefront OBJ file that points files use; not installed.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "twoscale/kernels/points_io.hpp"

namespace twoscale::kernels::obj {

struct Quad {
  std::array<std::size_t, 4> corners;  // vertices from 0, in the order of the file
  std::size_t line;
};

struct File {
  PointSet vertices;
  std::vector<std::size_t> polyline;  // vertices from 0
  std::size_t polyline_line = 0;      // 0: there is none
  std::vector<Quad> quads;
};

/// Names, groups, materials, normals and texture coordinates are skipped. Throws Error (bad_input) at name:line for
/// vertices without 2 or 3 coordinates, a second polyline, faces that are no quads (any face unless
/// `with_faces`), anything else, no vertex at all.
File parse(std::string_view bytes, const std::string& name, bool with_faces);

}  // namespace twoscale::kernels::obj
