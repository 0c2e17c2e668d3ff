// SPDX-License-Identifier: 0BSD
// Files of grids of points: CSV, NPY and OBJ in; CSV, NPY, OBJ and PLY out. A file says by itself whether it is a
// polygon (points_io.hpp) or a grid:
//
//   CSV   a comment line `# grid ROWSxCOLUMNS` before the points, which follow row by row, one a line;
//   NPY   an array with three axes, (rows, columns, dim);
//   OBJ   quads (`f` lines) between vertices in row-major order. The size is recovered from the quads, and which
//         directions are closed: there the quads of the last row (column) lead back to the first one.
//
// Point (i, j) is number i*columns + j; u runs from row to row, v along a row (surface.hpp). Parsers accept any bytes
// and throw as those of points_io.hpp do.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "twoscale/kernels/points_io.hpp"
#include "twoscale/kernels/surface.hpp"

namespace twoscale::kernels {

/// In which directions a grid is joined to itself.
struct Closings {
  bool u = false;  ///< the last row to the first one
  bool v = false;  ///< the last column to the first one
  friend bool operator==(const Closings&, const Closings&) = default;
};

struct PointGrid {
  PointSet points;  ///< size.rows * size.columns points, row-major
  GridSize size;
  std::optional<Closings> closings;  ///< where the file says so (OBJ)
};

using PointFile = std::variant<PointSet, PointGrid>;

/// The polygon or grid that `bytes` hold. PLY and SVG cannot be read. Errors as the parsers of points_io.hpp; also a
/// size that does not fit the points, quads that are not those of a grid, several meshes, faces that are no quads.
PointFile parse_point_file(std::string_view bytes, PointFormat format, const std::string& name);

/// The same by the suffix of `path`; "-" is CSV from the standard input.
PointFile read_point_file(const std::string& path);

/// CSV, NPY (shape (rows, columns, dim)), OBJ or PLY; the latter two with the quads (i, j), (i+1, j), (i+1, j+1),
/// (i, j+1), those that close the grid included, so that normals point to the side of f_u x f_v. Throws Error
/// (bad_input) when the grid does not fit the format: SVG, more than 3 columns for OBJ, an empty or inconsistent grid.
std::string grid_to_bytes(const PointGrid& grid, PointFormat format, Closings closings);

}  // namespace twoscale::kernels
