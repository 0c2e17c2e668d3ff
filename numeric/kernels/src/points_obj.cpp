// SPDX-License-Identifier: 0BSD
// Points as Wavefront OBJ polylines.
#include <charconv>

#include "points_text.hpp"

namespace twoscale::kernels {
namespace {

// The point an `l` element names ("3", "-1", "3/7"), from 0.
std::size_t element(std::string_view token, std::size_t points, const std::string& name, std::size_t line) {
  const std::string_view digits = token.substr(0, token.find('/'));
  long long index = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
  const long long count = static_cast<long long>(points);
  if (error != std::errc() || end != digits.data() + digits.size() || index == 0 || index > count || index < -count) {
    text::fail_at(name, line, "not a point of the file: " + quoted(token));
  }
  return static_cast<std::size_t>(index > 0 ? index - 1 : count + index);
}

// The points of `all` in the order of the polyline.
PointSet along(const PointSet& all, std::vector<std::size_t> order) {
  PointSet points;
  points.columns = all.columns;
  points.dim = all.dim;
  if (order.size() > 2 && order.front() == order.back()) {
    points.closed = true;
    order.pop_back();
  }
  for (const std::size_t j : order) {
    for (std::size_t c = 0; c < all.dim; ++c) {
      points.values.push_back(all.values[j * all.dim + c]);
      points.tokens.push_back(all.tokens[j * all.dim + c]);
    }
  }
  return points;
}

}  // namespace

PointSet parse_obj(std::string_view bytes, const std::string& name) {
  PointSet points;
  std::vector<std::string> polyline;
  std::size_t polyline_line = 0, points_before = 0;
  text::Lines lines(bytes);
  std::string_view line;
  while (lines.next(line)) {
    const std::vector<std::string_view> fields = text::split_blanks(line.substr(0, line.find('#')));
    if (fields.empty()) continue;
    const std::string_view key = fields[0];
    const std::size_t at = lines.number();
    if (key == "v") {
      const std::size_t dim = fields.size() - 1;
      if (dim != 2 && dim != 3) text::fail_at(name, at, "a point needs 2 or 3 coordinates: " + quoted(line));
      if (points.dim == 0) points.dim = dim;
      if (points.dim != dim) {
        text::fail_at(
            name, at,
            std::to_string(dim) + " coordinates instead of " + std::to_string(points.dim) + " in " + quoted(line));
      }
      for (std::size_t c = 1; c <= dim; ++c) text::append_number(points, fields[c], name, at);
    } else if (key == "l") {
      if (polyline_line != 0) text::fail_at(name, at, "a second polyline: " + quoted(line));
      polyline_line = at;
      points_before = points.size();
      polyline.assign(fields.begin() + 1, fields.end());
    } else if (key == "f") {
      text::fail_at(name, at, "faces are not a polygon to refine: " + quoted(line));
    } else if (key != "o" && key != "g" && key != "s" && key != "p" && key != "vt" && key != "vn" && key != "vp" &&
               key != "mtllib" && key != "usemtl") {
      text::fail_at(name, at, "not understood: " + quoted(line));
    }
  }
  if (points.values.empty()) text::fail_at(name, std::max<std::size_t>(1, lines.number()), "the file has no points");
  points.columns = default_columns(points.dim);
  if (polyline_line == 0) return points;
  std::vector<std::size_t> order;
  for (const std::string& token : polyline) {
    // Negative indices count back from the points read so far.
    order.push_back(element(token, token.front() == '-' ? points_before : points.size(), name, polyline_line));
  }
  if (order.empty()) text::fail_at(name, polyline_line, "a polyline without points");
  return along(points, std::move(order));
}

std::string to_obj(const PointSet& points, bool closed) {
  text::check_points(points, "obj");
  if (points.dim > 3) {
    throw Error(Error::Kind::bad_input,
                "points cannot be written as obj: it has 3 columns, not " + std::to_string(points.dim));
  }
  std::string out = "# polyline of twoscale\n";
  for (std::size_t j = 0; j < points.size(); ++j) {
    out += 'v';
    for (std::size_t c = 0; c < 3; ++c) {
      out += ' ';
      out += c < points.dim ? text::printed(points, j * points.dim + c) : "0";
    }
    out += '\n';
  }
  out += 'l';
  for (std::size_t j = 1; j <= points.size(); ++j) out += ' ' + std::to_string(j);
  if (closed && points.size() > 1) out += " 1";
  return out + '\n';
}

}  // namespace twoscale::kernels
