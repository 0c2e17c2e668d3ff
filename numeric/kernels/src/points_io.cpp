// SPDX-License-Identifier: 0BSD
// Formats of points files: which there are, and reading and writing by suffix.
#include "twoscale/kernels/points_io.hpp"

#include <algorithm>
#include <cmath>

#include "csv.hpp"
#include "npy.hpp"
#include "twoscale/kernels/error.hpp"
#include "twoscale/kernels/number_text.hpp"
#include "twoscale/kernels/write_file.hpp"

namespace twoscale::kernels {

PointFormat point_format(const std::string& path) {
  if (path == "-") return PointFormat::csv;
  const std::size_t slash = path.rfind('/');
  const std::string file = slash == std::string::npos ? path : path.substr(slash + 1);
  const std::size_t dot = file.rfind('.');
  std::string suffix = dot == std::string::npos ? std::string() : file.substr(dot + 1);
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (suffix == "csv") return PointFormat::csv;
  if (suffix == "npy") return PointFormat::npy;
  if (suffix == "obj") return PointFormat::obj;
  if (suffix == "ply") return PointFormat::ply;
  if (suffix == "svg") return PointFormat::svg;
  throw Error(Error::Kind::bad_input,
              "no points format has the suffix of " + quoted(path, 200) + " (.csv, .npy, .obj, .ply, .svg)");
}

std::vector<std::string> default_columns(std::size_t dim) {
  std::vector<std::string> columns = {"x", "y", "z", "w"};
  columns.resize(std::min<std::size_t>(dim, 4));
  while (columns.size() < dim) {
    std::string name = "c";
    name += std::to_string(columns.size());
    columns.push_back(std::move(name));
  }
  return columns;
}

PointSet read_points(const std::string& path) {
  const PointFormat format = point_format(path);
  if (format == PointFormat::ply || format == PointFormat::svg) {
    throw Error(Error::Kind::bad_input, "points are read from .csv, .npy and .obj, not from " + quoted(path, 200));
  }
  const std::string bytes = read_file(path);
  const std::string name = path == "-" ? "standard input" : path;
  if (format == PointFormat::npy) return parse_npy(bytes, name);
  if (format == PointFormat::obj) return parse_obj(bytes, name);
  return parse_csv(bytes, name);
}

std::string points_to_bytes(const PointSet& points, PointFormat format, bool closed) {
  switch (format) {
    case PointFormat::csv: return to_csv(points);
    case PointFormat::npy: return to_npy(points);
    case PointFormat::obj: return to_obj(points, closed);
    case PointFormat::ply: return to_ply(points, closed);
    case PointFormat::svg: return to_svg(points, closed);
  }
  throw Error(Error::Kind::bad_input, "unknown points format");
}

std::string points_head(PointFormat format, const std::vector<std::string>& columns, std::size_t dim,
                        std::size_t count) {
  if (!in_pieces(format)) throw Error(Error::Kind::bad_input, "only csv and npy are written in pieces");
  return format == PointFormat::csv ? csv::head(columns, dim) : npy::head(count, dim);
}

void append_points(std::string& out, PointFormat format, std::span<const double> values, std::size_t dim) {
  if (!in_pieces(format)) throw Error(Error::Kind::bad_input, "only csv and npy are written in pieces");
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) {
      throw Error(Error::Kind::bad_input, "a number is not finite: " + quoted(shortest(values[i])));
    }
    if (format == PointFormat::npy) {
      npy::append(out, values[i]);
    } else {
      out += shortest(values[i]);
      out += (i + 1) % dim == 0 ? '\n' : ',';
    }
  }
}

void write_points(const std::string& path, const PointSet& points, bool closed) {
  write_file(path, points_to_bytes(points, point_format(path), closed));
}

}  // namespace twoscale::kernels
