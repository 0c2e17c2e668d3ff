// SPDX-License-Identifier: 0BSD
// Points as an SVG polyline.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "points_text.hpp"

namespace twoscale::kernels {
namespace {

constexpr double box = 1000;   // length of the longer side of the curve, in user units
constexpr double margin = 20;  // around it

std::string fixed(double value) {
  char buffer[64];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, 4);
  std::string out = error == std::errc() ? std::string(buffer, end) : std::string("0");
  out.erase(out.find_last_not_of('0') + 1);
  if (out.back() == '.') out.pop_back();
  return out == "-0" ? "0" : out;
}

struct Range {
  double low = 0, high = 0;
  double half_length() const { return high / 2 - low / 2; }  // does not overflow
};

Range range_of(const PointSet& points, std::size_t column) {
  Range range{points.values[column], points.values[column]};
  for (std::size_t j = 0; j < points.size(); ++j) {
    range.low = std::min(range.low, points.values[j * points.dim + column]);
    range.high = std::max(range.high, points.values[j * points.dim + column]);
  }
  return range;
}

}  // namespace

std::string to_svg(const PointSet& points, bool closed) {
  text::check_points(points, "svg");
  const std::vector<std::size_t> columns = text::position_columns(points, 2);
  if (columns.size() < 2) {
    throw Error(Error::Kind::bad_input, "points cannot be written as svg: a picture needs two columns");
  }
  const Range x = range_of(points, columns[0]);
  const Range y = range_of(points, columns[1]);
  double half = std::max(x.half_length(), y.half_length());
  if (!(half > 0)) half = 1;
  const auto place = [&](double value, double from) { return (value / 2 - from / 2) / half * box; };
  const double width = place(x.high, x.low) + 2 * margin;
  const double height = place(y.high, y.low) + 2 * margin;
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ";
  out += fixed(width) + ' ' + fixed(height) + "\">\n<!-- curve of twoscale -->\n<";
  out += closed ? "polygon" : "polyline";
  out += " fill=\"none\" stroke=\"black\" stroke-width=\"2\" stroke-linejoin=\"round\" points=\"";
  for (std::size_t j = 0; j < points.size(); ++j) {
    if (j != 0) out += ' ';
    out += fixed(margin + place(points.values[j * points.dim + columns[0]], x.low)) + ',' +
           fixed(height - margin - place(points.values[j * points.dim + columns[1]], y.low));
  }
  return out + "\"/>\n</svg>\n";
}

}  // namespace twoscale::kernels
