// SPDX-License-Identifier: 0BSD
// Points files: CSV, NPY and OBJ in; CSV, NPY, OBJ, PLY and SVG out.
//
// Every parser takes bytes and a name for messages, accepts any bytes, and throws Error (bad_input) that names the
// file, the line (CSV, OBJ) or the row (NPY) and the text. Nothing depends on the locale.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace twoscale::kernels {

/// n points with `dim` numbers each, row-major: number c of point j is `values[j*dim + c]`.
struct PointSet {
  std::vector<std::string> columns;  ///< dim names: "x", "y", "z", or what the CSV header says
  std::size_t dim = 0;
  std::vector<double> values;       ///< n*dim, finite
  std::vector<std::string> tokens;  ///< empty, or n*dim: the numbers as written (see below)
  bool closed = false;              ///< OBJ: the polyline ends where it begins (the repeated point is dropped)

  std::size_t size() const { return dim == 0 ? 0 : values.size() / dim; }
};

// `tokens` of a set that was read are decimals for exact arithmetic: as written in CSV and OBJ (without a leading
// '+'); for NPY the integer itself, or the shortest decimal that reads back as the same double. A set that is written
// prints its tokens when it has them (CSV, OBJ, PLY), else the shortest round trip of `values`; NPY and SVG always use
// `values`.

enum class PointFormat { csv, npy, obj, ply, svg };

/// The format a path names by its suffix (any case); "-" is CSV. Throws Error (bad_input) naming the path and the
/// suffixes known.
PointFormat point_format(const std::string& path);

/// "x", "y", "z", "w", then "c4", "c5", ...
std::vector<std::string> default_columns(std::size_t dim);

/// One point per line, numbers separated by commas, blanks around them allowed. The first line that is neither blank
/// nor a comment (#) may name the columns: identifiers, all different. LF or CRLF, an UTF-8 byte order mark is skipped.
/// Errors: anything that is not a decimal, numbers too large for a double, rows of different lengths, no point at all.
PointSet parse_csv(std::string_view bytes, const std::string& name);

/// NumPy format 1.0 to 3.0: one array with one (n,) or two (n, dim) axes, C or Fortran order, either byte order, of
/// float32, float64, or integers of 8 to 64 bits. Errors: anything else, NaN and infinities, bytes missing or left
/// over.
PointSet parse_npy(std::string_view bytes, const std::string& name);

/// `v x y [z]` lines in order; or, when there is one `l` line, the points it lists (1-based, negative from the end).
/// `l` that returns to its first point sets `closed`. Names, groups, materials, normals and texture coordinates are
/// skipped. Errors: faces, several `l` lines, anything else.
PointSet parse_obj(std::string_view bytes, const std::string& name);

/// Reads `path` by its suffix; "-" is CSV from the standard input. PLY and SVG cannot be read (bad_input).
PointSet read_points(const std::string& path);

/// With a header line of column names exactly when `header`; one point per line.
std::string to_csv(const PointSet& points, bool header = true);
/// Version 1.0, '<f8', C order, shape (n, dim).
std::string to_npy(const PointSet& points);
/// At most 3 columns (z, y are 0 when missing); one `l` line, back to point 1 when closed.
std::string to_obj(const PointSet& points, bool closed);
/// ASCII PLY: the columns as double properties of `vertex` (x, y, z are always there), edges between neighbours.
std::string to_ply(const PointSet& points, bool closed);
/// The curve of the columns x and y (the first two when none has these names), fitted into a viewBox with y up.
std::string to_svg(const PointSet& points, bool closed);

/// One of the five above. Throws Error (bad_input) when the points do not fit the format (columns, empty set).
std::string points_to_bytes(const PointSet& points, PointFormat format, bool closed);

/// CSV and NPY in pieces: points_head, then append_points for consecutive rows gives the bytes of points_to_bytes for a
/// set of `count` points without tokens.
constexpr bool in_pieces(PointFormat format) { return format == PointFormat::csv || format == PointFormat::npy; }
std::string points_head(PointFormat format, const std::vector<std::string>& columns, std::size_t dim,
                        std::size_t count);
/// Throws Error (bad_input) for a number that is not finite.
void append_points(std::string& out, PointFormat format, std::span<const double> values, std::size_t dim);

/// points_to_bytes by the suffix of `path`, then write_file.
void write_points(const std::string& path, const PointSet& points, bool closed);

}  // namespace twoscale::kernels
