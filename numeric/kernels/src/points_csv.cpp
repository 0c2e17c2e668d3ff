// SPDX-License-Identifier: 0BSD
// Points as CSV.
#include <algorithm>

#include "csv.hpp"
#include "points_text.hpp"

namespace twoscale::kernels {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// A column name: an identifier that cannot be meant as a number.
bool is_name(std::string_view text) {
  if (text.empty() || text.size() > 100) return false;
  std::string small;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = lower(text[i]);
    if (!(c == '_' || (c >= 'a' && c <= 'z') || (i > 0 && c >= '0' && c <= '9'))) return false;
    small += c;
  }
  return small != "nan" && small != "inf" && small != "infinity";
}

}  // namespace

PointSet parse_csv(std::string_view bytes, const std::string& name) {
  PointSet points;
  text::Lines lines(bytes);
  std::string_view line;
  bool first = true;
  while (lines.next(line)) {
    line = text::trimmed(line);
    if (line.empty() || line.front() == '#') continue;
    const std::vector<std::string_view> fields = text::split_commas(line);
    if (first) {
      first = false;
      points.dim = fields.size();
      if (std::all_of(fields.begin(), fields.end(), is_name)) {
        for (const std::string_view field : fields) {
          if (std::find(points.columns.begin(), points.columns.end(), field) != points.columns.end()) {
            text::fail_at(name, lines.number(), "two columns have the name " + quoted(field));
          }
          points.columns.emplace_back(field);
        }
        continue;
      }
      points.columns = default_columns(points.dim);
    }
    if (fields.size() != points.dim) {
      text::fail_at(
          name, lines.number(),
          std::to_string(fields.size()) + " numbers instead of " + std::to_string(points.dim) + " in " + quoted(line));
    }
    for (const std::string_view field : fields) text::append_number(points, field, name, lines.number());
  }
  if (points.values.empty()) {
    text::fail_at(name, std::max<std::size_t>(1, lines.number()), "the file has no points");
  }
  return points;
}

namespace csv {

std::string head(const std::vector<std::string>& columns, std::size_t dim) {
  std::string out;
  const std::vector<std::string> names = columns.empty() ? default_columns(dim) : columns;
  for (std::size_t c = 0; c < dim; ++c) out += (c == 0 ? "" : ",") + names[c];
  return out + '\n';
}

}  // namespace csv

std::string to_csv(const PointSet& points, bool header) {
  text::check_points(points, "csv");
  std::string out;
  if (header) out = csv::head(points.columns, points.dim);
  for (std::size_t i = 0; i < points.values.size(); ++i) {
    out += text::printed(points, i);
    out += (i + 1) % points.dim == 0 ? '\n' : ',';
  }
  return out;
}

}  // namespace twoscale::kernels
