// SPDX-License-Identifier: 0BSD
// Lines, fields and numbers of points files.
#include "points_text.hpp"

#include <cmath>

#include "twoscale/kernels/number_text.hpp"

namespace twoscale::kernels::text {

bool Lines::next(std::string_view& line) {
  if (rest_.empty()) return false;
  const std::size_t end = rest_.find('\n');
  line = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  ++number_;
  return true;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::vector<std::string_view> split_commas(std::string_view text) {
  std::vector<std::string_view> pieces;
  for (;;) {
    const std::size_t comma = text.find(',');
    pieces.push_back(trimmed(text.substr(0, comma)));
    if (comma == std::string_view::npos) return pieces;
    text.remove_prefix(comma + 1);
  }
}

std::vector<std::string_view> split_blanks(std::string_view text) {
  std::vector<std::string_view> pieces;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
    pieces.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return pieces;
}

void fail_at(const std::string& name, std::size_t line, const std::string& message) {
  throw Error(Error::Kind::bad_input, name + ":" + std::to_string(line) + ": " + message);
}

void append_number(PointSet& points, std::string_view text, const std::string& name, std::size_t line) {
  const auto value = parse_double(text);
  if (!value) {
    fail_at(name, line, (is_decimal(text) ? "number too large for a double: " : "not a number: ") + quoted(text));
  }
  points.values.push_back(*value);
  points.tokens.emplace_back(text.front() == '+' ? text.substr(1) : text);
}

std::string printed(const PointSet& points, std::size_t index) {
  return points.tokens.empty() ? shortest(points.values[index]) : points.tokens[index];
}

void check_points(const PointSet& points, const char* format) {
  const auto fail = [&](const std::string& what) {
    throw Error(Error::Kind::bad_input, std::string("points cannot be written as ") + format + ": " + what);
  };
  if (points.dim == 0 || points.values.empty()) fail("there are none");
  if (points.values.size() % points.dim != 0) fail("the last row is not complete");
  if (!points.columns.empty() && points.columns.size() != points.dim) fail("names and columns differ in number");
  if (!points.tokens.empty() && points.tokens.size() != points.values.size()) fail("texts and values differ in number");
  for (const std::string& token : points.tokens) {
    if (!is_decimal(token)) fail("not a decimal: " + quoted(token));
  }
  for (std::size_t i = 0; i < points.values.size(); ++i) {
    if (!std::isfinite(points.values[i])) fail("point " + std::to_string(i / points.dim) + " is not finite");
  }
}

void append_vertices(std::string& out, const PointSet& points) {
  for (std::size_t j = 0; j < points.size(); ++j) {
    out += 'v';
    for (std::size_t c = 0; c < 3; ++c) {
      out += ' ';
      out += c < points.dim ? printed(points, j * points.dim + c) : "0";
    }
    out += '\n';
  }
}

std::vector<std::size_t> position_columns(const PointSet& points, std::size_t most) {
  std::vector<std::size_t> found;
  for (const char* name : {"x", "y", "z"}) {
    if (found.size() == most) break;
    for (std::size_t c = 0; c < points.columns.size(); ++c) {
      if (points.columns[c] == name) {
        found.push_back(c);
        break;
      }
    }
  }
  if (found.size() >= 2 || points.dim == 1) return found.empty() ? std::vector<std::size_t>{0} : found;
  found.clear();
  for (std::size_t c = 0; c < std::min(most, points.dim); ++c) found.push_back(c);
  return found;
}

}  // namespace twoscale::kernels::text
