// SPDX-License-Identifier: 0BSD
// Wavefront OBJ files: their elements, and points as polylines.
#include <algorithm>
#include <charconv>

#include "obj.hpp"
#include "points_text.hpp"

namespace twoscale::kernels {
namespace obj {
namespace {

// The vertex an element names ("3", "-1", "3/7/2"), from 0; negative numbers count back from the vertices read so far.
std::size_t vertex(std::string_view token, std::size_t so_far, std::size_t all, const std::string& name,
                   std::size_t line) {
  const std::string_view digits = token.substr(0, token.find('/'));
  long long index = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
  const long long count = static_cast<long long>(index < 0 ? so_far : all);
  if (error != std::errc() || end != digits.data() + digits.size() || index == 0 || index > count || index < -count) {
    text::fail_at(name, line, "not a point of the file: " + quoted(token));
  }
  return static_cast<std::size_t>(index > 0 ? index - 1 : count + index);
}

// An `l` or `f` line; its vertices may follow later in the file.
struct Element {
  std::vector<std::string> tokens;
  std::size_t line = 0;
  std::size_t so_far = 0;
};

}  // namespace

File parse(std::string_view bytes, const std::string& name, bool with_faces) {
  File file;
  PointSet& points = file.vertices;
  std::vector<Element> faces;
  Element polyline;
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
      if (polyline.line != 0) text::fail_at(name, at, "a second polyline: " + quoted(line));
      polyline = {{fields.begin() + 1, fields.end()}, at, points.size()};
      if (polyline.tokens.empty()) text::fail_at(name, at, "a polyline without points");
    } else if (key == "f") {
      if (!with_faces) text::fail_at(name, at, "faces are not a polygon to refine: " + quoted(line));
      if (fields.size() != 5) {
        text::fail_at(
            name, at,
            "a face with " + std::to_string(fields.size() - 1) + " corners, a grid has quads: " + quoted(line));
      }
      faces.push_back({{fields.begin() + 1, fields.end()}, at, points.size()});
    } else if (key != "o" && key != "g" && key != "s" && key != "p" && key != "vt" && key != "vn" && key != "vp" &&
               key != "mtllib" && key != "usemtl") {
      text::fail_at(name, at, "not understood: " + quoted(line));
    }
  }
  if (points.values.empty()) text::fail_at(name, std::max<std::size_t>(1, lines.number()), "the file has no points");
  points.columns = default_columns(points.dim);
  file.polyline_line = polyline.line;
  for (const std::string& token : polyline.tokens) {
    file.polyline.push_back(vertex(token, polyline.so_far, points.size(), name, polyline.line));
  }
  file.quads.reserve(faces.size());
  for (const Element& face : faces) {
    Quad quad{{}, face.line};
    for (std::size_t c = 0; c < 4; ++c) {
      quad.corners[c] = vertex(face.tokens[c], face.so_far, points.size(), name, face.line);
    }
    file.quads.push_back(quad);
  }
  return file;
}

}  // namespace obj

PointSet parse_obj(std::string_view bytes, const std::string& name) {
  obj::File file = obj::parse(bytes, name, false);
  if (file.polyline_line == 0) return std::move(file.vertices);
  const PointSet& all = file.vertices;
  std::vector<std::size_t>& order = file.polyline;
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

std::string to_obj(const PointSet& points, bool closed) {
  text::check_points(points, "obj");
  if (points.dim > 3) {
    throw Error(Error::Kind::bad_input,
                "points cannot be written as obj: it has 3 columns, not " + std::to_string(points.dim));
  }
  std::string out = "# polyline of twoscale\n";
  text::append_vertices(out, points);
  out += 'l';
  for (std::size_t j = 1; j <= points.size(); ++j) out += ' ' + std::to_string(j);
  if (closed && points.size() > 1) out += " 1";
  return out + '\n';
}

}  // namespace twoscale::kernels
