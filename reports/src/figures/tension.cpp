// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/tension.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "twoscale/reports/curves.hpp"
#include "twoscale/reports/html.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::reports {

namespace {

struct Point {
  double v0;
  double distance;  // NaN: impossible
};

// 1 + v^0 from 1/20 to 10^4, equally spaced in the logarithm, rounded to millionths.
std::vector<Point> sweep(const Scheme& scheme, const Polygon& polygon) {
  std::vector<Point> list;
  for (int i = -26; i <= 80; ++i) {
    const long millionths = std::lround(1e6 * (std::pow(10.0, i / 20.0) - 1));
    list.push_back({static_cast<double>(millionths) / 1e6,
                    distance_to_polygon(scheme, fmt::format("{}/1000000", millionths), polygon)});
  }
  return list;
}

TensionCourse course(const std::string& label, const std::vector<Point>& list) {
  struct Run {
    bool down;
    double from, to;
  };
  std::vector<Run> runs;
  for (std::size_t i = 1; i < list.size(); ++i) {
    const bool down = list[i].distance < list[i - 1].distance;
    if (std::isnan(list[i].distance) || std::isnan(list[i - 1].distance)) continue;
    if (!runs.empty() && runs.back().down == down)
      runs.back().to = list[i].v0;
    else
      runs.push_back({down, list[i - 1].v0, list[i].v0});
  }
  TensionCourse c;
  c.label = label;
  c.at_end = list.back().distance;
  for (const Run& r : runs) {
    c.words += fmt::format("{}{} from {} to {}", c.words.empty() ? "" : ", ", r.down ? "falls" : "rises",
                           v0_text(r.from), v0_text(r.to));
    if (r.down) continue;
    c.monotone = false;
    c.last_rise = r.to;
  }
  return c;
}

}  // namespace

std::string v0_text(double v0) {
  return fmt::format("{}{:.{}f}", v0 < 0 ? "−" : "", std::abs(v0), std::abs(v0) < 100 ? 2 : 0);
}

double distance_to_polygon(const Scheme& scheme, const std::string& v0, const Polygon& polygon) {
  try {
    const auto given = v0.empty() ? std::optional<std::string>() : v0;
    const auto binding = lowering::bind(scheme, given, std::nullopt, {});
    const auto boundary = polygon.closed ? kernels::Boundary::closed : kernels::Boundary::linear;
    return distance_to_polygon(refine_points(scheme, binding, polygon.vertices, 2, drawn_levels, boundary),
                               polygon.vertices, polygon.closed);
  } catch (const Error& e) {
    if (e.kind != Error::Kind::bad_input) throw;
    return NAN;
  }
}

TensionSweep tension_sweep(Part& part, const std::vector<NamedScheme>& schemes, const Polygon& polygon) {
  TensionSweep result;
  Picture p;
  p.equal_axes = false;
  p.logarithmic_x = p.logarithmic_y = true;
  p.width = 700;
  p.height = 400;
  p.x_label = "1 + v⁰";
  p.y_label = "distance to the polygon / size";
  std::string rows;
  int colour = 0;
  for (const auto& [name, label] : schemes) {
    const std::vector<Point> list = sweep(make_scheme(name), polygon);
    // Poles cut the graph into pieces; what is farther than three times the polygon's size is left out.
    Line piece;
    bool titled = false;
    const auto flush = [&] {
      if (piece.values.size() >= 4) {
        piece.colour = colour;
        piece.title = titled ? "" : label;
        titled = true;
        p.lines.push_back(piece);
      }
      piece = Line();
    };
    for (const Point& q : list) {
      if (std::isnan(q.distance) || q.distance > 3) {
        flush();
        continue;
      }
      piece.values.push_back(1 + q.v0);
      piece.values.push_back(q.distance);
    }
    flush();
    ++colour;
    const TensionCourse& how = result.courses.emplace_back(course(label, list));
    rows += fmt::format("<tr><td>{}</td><td class=\"{}\">{}</td><td>{}</td><td>{}</td></tr>\n", escaped(label),
                        how.monotone ? "proved" : "refuted", how.monotone ? "falls" : "not monotone", how.words,
                        number_text(how.at_end));
  }
  result.html = figure(part, {"tension", "Distance of the limit curve to the polygon over 1 + v⁰", "", {}, false}, p) +
                "<div class=\"wide\"><table><thead><tr><th>scheme</th><th>distance</th><th>its course as v⁰ grows</th>"
                "<th>at v⁰ = 9999</th></tr></thead><tbody>\n" +
                rows + "</tbody></table></div>\n";
  return result;
}

}  // namespace twoscale::reports
