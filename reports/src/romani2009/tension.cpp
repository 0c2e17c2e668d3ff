// SPDX-License-Identifier: GPL-3.0-or-later
// Corollary 13, measured: does a greater v^0 always bring the limit curve closer to the polygon?
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sections.hpp"
#include "twoscale/reports/curves.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::reports::romani2009 {

namespace {

struct Point {
  double v0;
  double distance;  // NaN: impossible
};

double distance(const Scheme& scheme, const std::string& v0, const std::vector<double>& polygon) {
  try {
    const auto given = v0.empty() ? std::optional<std::string>() : v0;
    const auto binding = lowering::bind(scheme, given, std::nullopt, {});
    return distance_to_polygon(refine_points(scheme, binding, polygon, 2, drawn_levels, kernels::Boundary::closed),
                               polygon, true);
  } catch (const Error& e) {
    if (e.kind != Error::Kind::bad_input) throw;
    return NAN;
  }
}

// 1 + v^0 from 1/20 to 10^4, equally spaced in the logarithm, rounded to millionths.
std::vector<Point> sweep(const Scheme& scheme, const std::vector<double>& polygon) {
  std::vector<Point> list;
  for (int i = -26; i <= 80; ++i) {
    const long millionths = std::lround(1e6 * (std::pow(10.0, i / 20.0) - 1));
    list.push_back(
        {static_cast<double>(millionths) / 1e6, distance(scheme, fmt::format("{}/1000000", millionths), polygon)});
  }
  return list;
}

// The ends of the grid keep few digits.
std::string short_text(double v0) {
  return fmt::format("{}{:.{}f}", v0 < 0 ? "−" : "", std::abs(v0), std::abs(v0) < 100 ? 2 : 0);
}

// "falls from −0.90 to 0.20, rises from 0.20 to 3.00"; last_rise: where it rises for the last time.
struct Course {
  std::string words;
  bool monotone = true;
  double last_rise = -1;
};

Course course(const std::vector<Point>& list) {
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
  Course c;
  for (const Run& r : runs) {
    c.words += fmt::format("{}{} from {} to {}", c.words.empty() ? "" : ", ", r.down ? "falls" : "rises",
                           short_text(r.from), short_text(r.to));
    if (r.down) continue;
    c.monotone = false;
    c.last_rise = r.to;
  }
  return c;
}

}  // namespace

Section tension_section() {
  Section section{"tension", "Tension", "Figures 8–10: is a greater v⁰ always closer to the polygon?", {}};
  Part& part = section.part;
  const std::vector<double> polygon = std::get<Polygon>(panel(figures(), "8").start).vertices;
  Picture p;
  p.equal_axes = false;
  p.logarithmic_x = p.logarithmic_y = true;
  p.width = 700;
  p.height = 400;
  p.x_label = "1 + v⁰";
  p.y_label = "distance to the polygon / size";
  std::string rows;
  bool all_monotone = true;
  double last_rise = -1;
  std::string mixed_end;
  int colour = 0;
  for (const SixPoint& which : six_point_schemes()) {
    const Scheme scheme = make_scheme(which.scheme);
    const std::vector<Point> list = sweep(scheme, polygon);
    const Course how = course(list);
    all_monotone = all_monotone && how.monotone;
    last_rise = std::max(last_rise, how.last_rise);
    // Poles cut the graph into pieces; what is farther than ten times the polygon's size is left out.
    Line piece;
    bool titled = false;
    const auto flush = [&] {
      if (piece.values.size() >= 4) {
        piece.colour = colour;
        piece.title = titled ? "" : std::string("section ") + which.section + ", " + which.name;
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
    const double last = list.back().distance;
    if (std::string(which.name) == "mixed") mixed_end = number_text(last);
    rows += fmt::format("<tr><td>section {}, {}</td><td class=\"{}\">{}</td><td>{}</td><td>{}</td></tr>\n",
                        which.section, which.name, how.monotone ? "proved" : "refuted",
                        how.monotone ? "falls" : "not monotone", how.words, number_text(last));
  }
  const double four_point = distance(make_scheme("dd:l=2"), "", polygon);
  part.html =
      "<p>Corollary 13 says so. Measured on the polygon above, for 107 values of v⁰ from −0.95 to 9999: the largest "
      "distance of a point of the limit "
      "curve to the polygon, over the diagonal of the polygon’s box. The gaps are singular values of the harmonic "
      "scheme and their surroundings.</p>\n" +
      figure(part, {"tension", "Distance of the limit curve to the polygon over 1 + v⁰", "", {}, false}, p) +
      "<div class=\"wide\"><table><thead><tr><th>scheme</th><th>distance</th><th>its course as v⁰ "
      "grows</th><th>at v⁰ = 9999</th></tr></thead><tbody>\n" +
      rows +
      fmt::format(
          "</tbody></table></div>\n<p>As v⁰ → ∞ the harmonic and resonant rules tend to the midpoint of the edge (ζ₀, "
          "ζ₂ → 0, ζ₄ → 1/2), the mixed rule "
          "tends to the 4-point Dubuc–Deslauriers rule (−1/16, 9/16), whose limit curve has the distance {}: the "
          "scheme of section 4.1 never "
          "reaches the polygon.</p>\n",
          number_text(four_point));
  const std::string verdict =
      all_monotone ? std::string("the measured distances agree.")
                   : fmt::format(
                         "<a href=\"#tension\">measured</a> on one polygon, this is not so on (−1, ∞); from "
                         "v⁰ ≈ {} on all three distances fall.",
                         short_text(last_rise));
  part.findings.push_back(
      fmt::format("Corollary 13 (the greater v⁰, the closer to the polygon): {} The scheme of section 4.1 does not "
                  "come to the polygon but to the "
                  "4-point Dubuc–Deslauriers curve (distance {} at v⁰ = 9999, {} in the limit).",
                  verdict, mixed_end, number_text(four_point)));
  return section;
}

}  // namespace twoscale::reports::romani2009
