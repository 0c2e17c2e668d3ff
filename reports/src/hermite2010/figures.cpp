// SPDX-License-Identifier: GPL-3.0-or-later
// Section: the figures in spirit. The paper prints no coordinates; the points are ours.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "hermite2010/sections.hpp"
#include "twoscale/kernels/hermite.hpp"
#include "twoscale/lowering/refine_hermite.hpp"
#include "twoscale/reports/curves.hpp"
#include "twoscale/reports/html.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::reports::hermite2010 {

kernels::PointSet Polygon::points() const {
  kernels::PointSet set;
  set.columns = kernels::default_columns(2);
  set.dim = 2;
  set.values = values;
  set.closed = closed;
  return set;
}

namespace {

kernels::PointSet refine(const std::string& scheme, const Polygon& polygon, unsigned levels, bool jets) {
  return lowering::refine_hermite(make_scheme(scheme), std::nullopt, polygon.points(),
                                  {levels, polygon.closed, 0, jets})
      .points;
}

}  // namespace

std::vector<double> refined(const std::string& scheme, const Polygon& polygon, unsigned levels) {
  return refine(scheme, polygon, levels, false).values;
}

kernels::PointSet refined_jets(const std::string& scheme, const Polygon& polygon, unsigned levels) {
  return refine(scheme, polygon, levels, true);
}

namespace {

constexpr unsigned limit_levels = 10;

// On circles about (0, 0) of radius 1; arcs of less and of more than a turn.
std::vector<double> on_circle(const std::vector<double>& degrees) {
  std::vector<double> values;
  for (const double a : degrees) {
    const double angle = a * std::acos(-1.0) / 180;
    values.insert(values.end(), {std::cos(angle), std::sin(angle)});
  }
  return values;
}

const Polygon irregular{"irregular", true, {0, 0, 2.2, -0.8, 5, 0.3, 5.4, 1.2, 4.2, 3.4, 3.6, 3.5, 0.6, 2.9}};
const Polygon arc{"arc", false, {0, 0, 0.6, 1.3, 2.1, 1.9, 3.9, 1.2, 4.3, 0.4}};
const Polygon circle_points{"circle", true, on_circle({-170, -140, -20, 10, 30, 120})};
const Polygon half_circle{"half-circle", false, on_circle({-60, -35, 20, 110, 125})};
const Polygon pentagram{"pentagram", true, on_circle({90, 234, 378, 522, 666})};
const Polygon eight{"eight", true, {-2, 1, 0, 0, 2, -1, 2.8, 0.1, 2, 1.1, 0.1, 0.1, -2, -1, -2.9, -0.2}};
const Polygon wave{"wave", false, {0, 0, 1, 1.4, 2.6, 1.5, 3.4, 0.2, 5.2, -0.6, 6, 0.6}};
const Polygon bean{"bean", true, {0, 0, 3, -0.6, 5.6, 0.4, 5.2, 2.4, 3.9, 2.2, 2.6, 1.7, 1.2, 2.3, -0.3, 1.8}};
const Polygon flat{"nearly-collinear", true, {0, 0, 2, 0.001, 4, 0, 6, 0.3, 6, 3, 3, 3.002, 0, 3}};
const Polygon loop{"loop", false, {0, 0, 3, 0.2, 4, 2, 2.6, 3, 1.6, 1.9, 2.6, 0.4, 5.6, 0}};

Line dots(std::vector<double> values, const char* title, int colour) {
  Line l = curve_line(std::move(values), false, title, colour);
  l.style = Line::Style::points;
  return l;
}

// The sections of the figures, one after the other; panels go into the last one.
class Figures {
 public:
  void open(const std::string& number, const std::string& title, const std::string& text) {
    sections_.push_back({"figure-" + number, "Figure " + number, "Figure " + number + ": " + title, {}});
    part().html = text.empty() ? "" : "<p>" + text + "</p>\n";
    part().numbers = nlohmann::ordered_json::array();
  }
  void panels(const std::string& html) { part().html += "<div class=\"panels\">\n" + html + "</div>\n"; }
  Part& part() { return sections_.back().part; }
  std::vector<Section> sections() { return std::move(sections_); }

  std::string panel(const std::string& id, const std::string& caption, Picture p,
                    const std::vector<std::string>& commands = {}) {
    p.height = 400;
    return figure(part(), {id, caption, "", commands}, p);
  }

  // Polygon, q_i of (S.1) and b.
  std::string centres(const std::string& id, const std::string& caption, const Polygon& polygon) {
    const auto angles = kernels::hermite_angles<double>(polygon.values, 2, polygon.closed, false);
    const std::size_t n = polygon.values.size() / 2;
    const auto vertex = [&](std::size_t i) {
      return kernels::hermite_detail::Vector<double>{{polygon.values[2 * i], polygon.values[2 * i + 1], 0}};
    };
    std::vector<double> q;
    for (std::size_t i = 0; i < n; ++i) {
      const auto c = kernels::hermite_detail::circumcentre(vertex((i + n - 1) % n), vertex(i), vertex((i + 1) % n));
      q.insert(q.end(), {c.c[0], c.c[1]});
    }
    Picture p;
    p.lines = {polygon_line(polygon.values, polygon.closed), dots(q, "q_i", 1),
               dots({angles.centre.c[0], angles.centre.c[1]}, "b", 2)};
    return panel(id, caption, p);
  }

  // Polygon with the points of the steps 1 and 2, and the limit.
  std::string steps(const std::string& id, const std::string& caption, const Polygon& polygon,
                    const std::vector<std::string>& commands = {}, const std::string& scheme = "hermite-circle") {
    Picture first, last;
    first.lines = {polygon_line(polygon.values, polygon.closed), dots(refined(scheme, polygon, 1), "step 1", 1)};
    if (polygon.values.size() < 14) first.lines.push_back(dots(refined(scheme, polygon, 2), "step 2", 2));
    std::reverse(first.lines.begin() + 1, first.lines.end());
    last.lines = {polygon_line(polygon.values, polygon.closed),
                  curve_line(refined(scheme, polygon, limit_levels), polygon.closed, "step 10", 0)};
    return panel(id + "-steps", caption + ", first steps", first) + panel(id, caption, last, commands);
  }

  // The largest | |f - centre| - radius |/radius at step 10.
  double deviation(const std::vector<double>& points) {
    double worst = 0;
    for (std::size_t i = 0; i < points.size(); i += 2)
      worst = std::max(worst, std::abs(std::hypot(points[i], points[i + 1]) - 1));
    return worst;
  }

  std::string circle_row(const std::string& what, const Polygon& polygon) {
    const double worst = deviation(refined("hermite-circle", polygon, limit_levels));
    part().exact_run(worst);
    part().numbers.push_back(nlohmann::ordered_json{{"circle", what}, {"deviation", worst}});
    return fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", escaped(what), number_text(worst));
  }

 private:
  std::vector<Section> sections_;
};

std::string circle_table(Figures& f) {
  std::string rows;
  rows += f.circle_row("closed, six points, uneven", circle_points);
  rows += f.circle_row("closed, clockwise", {"", true, on_circle({100, 30, -15, -100, -200})});
  rows += f.circle_row("closed, the first vertex repeated at the end", {"", true, on_circle({0, 70, 110, 250, 360})});
  rows += f.circle_row("closed, spacing from 1° to 200°", {"", true, on_circle({0, 1, 3, 60, 160})});
  rows += f.circle_row("open, an arc of 185°", half_circle);
  rows += f.circle_row("open, an arc of 500°", {"", false, on_circle({0, 100, 210, 300, 420, 500})});
  rows += f.circle_row("closed, two turns (720°)", {"", true, on_circle({0, 150, 290, 430, 580})});
  return "<table class=\"narrow\"><thead><tr><th>points of the unit circle</th><th>largest deviation from it after 10 "
         "steps, "
         "double precision</th></tr></thead><tbody>\n" +
         rows + "</tbody></table>\n";
}

// Points of the unit circle with exact decimals: 60 digits come out.
std::string exact_circle(Figures& f) {
  kernels::PointSet set;
  set.columns = kernels::default_columns(2);
  set.dim = 2;
  set.tokens = {"1", "0", "0.8", "0.6", "-0.28", "0.96", "-0.6", "-0.8", "0.28", "-0.96"};
  for (const auto& t : set.tokens) set.values.push_back(std::strtod(t.c_str(), nullptr));
  const auto out =
      lowering::refine_hermite(make_scheme("hermite-circle"), std::nullopt, set, {4, true, 60, false}).points;
  Rational worst;
  for (std::size_t i = 0; i < out.size(); ++i) {
    Rational square(-1);
    for (std::size_t c = 0; c < 2; ++c) {
      const Rational x = *parse_real(out.tokens[2 * i + c]).rational();
      square += x * x;
    }
    worst = std::max(worst, square.sign() < 0 ? -square : square);
  }
  const bool exact = worst < Rational(10).pow(-59);
  f.part().numbers.push_back(nlohmann::ordered_json{{"circle_in_60_digits", exact}});
  return fmt::format(
      "<p>From the exact points (1, 0), (4/5, 3/5), (−7/25, 24/25), (−3/5, −4/5), (7/25, −24/25), with "
      "<code>--digits 60</code>: |x² + y² − 1| {} 10<sup>−59</sup> for all {} points after 4 steps.</p>\n",
      exact ? "&lt;" : "is not below", out.size());
}

struct Tension {
  const char* w;
  const char* printed;
  const char* c2;
};
const Tension tensions[] = {{"1/4", "hermite-circle:w=1/4", "hermite-circle:variant=c2,w=1/4"},
                            {"1/2", "hermite-circle:w=1/2", "hermite-circle:variant=c2,w=1/2"},
                            {"3/4", "hermite-circle:w=3/4", "hermite-circle:variant=c2,w=3/4"},
                            {"1", "hermite-circle", "hermite-circle:variant=c2"},
                            {"5/4", "hermite-circle:w=5/4", "hermite-circle:variant=c2,w=5/4"},
                            {"3/2", "hermite-circle:w=3/2", "hermite-circle:variant=c2,w=3/2"}};

std::string tension_figures(Figures& f) {
  Picture printed, other;
  std::string rows;
  double last = -1;
  bool ordered = true;
  int colour = 0;
  printed.lines = other.lines = {polygon_line(bean.values, true)};
  for (const Tension& t : tensions) {
    const auto a = refined(t.printed, bean, limit_levels), b = refined(t.c2, bean, limit_levels);
    const double da = distance_to_polygon({a, 2, 0, 1}, bean.values, true);
    const double db = distance_to_polygon({b, 2, 0, 1}, bean.values, true);
    ordered = ordered && da > last;
    last = da;
    rows += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", t.w, number_text(da), number_text(db));
    f.part().numbers.push_back(nlohmann::ordered_json{{"w", t.w}, {"distance_printed", da}, {"distance_c2", db}});
    printed.lines.push_back(curve_line(a, true, std::string("w = ") + t.w, colour));
    other.lines.push_back(curve_line(b, true, std::string("w = ") + t.w, colour++));
  }
  f.part().findings.push_back(std::string("Figure 9: on our polygon larger w ") +
                              (ordered ? "gives" : "does not always give") +
                              " curves that go farther from it, measured by the largest distance.");
  return f.panel("9-printed", "tension as printed", printed) + f.panel("9-c2", "variant c2", other) +
         "<figure>\n<table class=\"narrow\"><thead><tr><th>w</th><th>distance to polygon, printed</th><th>variant "
         "c2</th></tr></thead><tbody>\n" +
         rows + "</tbody></table>\n</figure>\n";
}

Picture curvature_picture(const std::vector<double>& points, std::size_t vertices, std::string title, int colour) {
  const std::vector<double> k = curvature(points, true);
  Line l;
  for (std::size_t j = 0; j < k.size(); ++j)
    if (std::isfinite(k[j]))
      l.values.insert(l.values.end(),
                      {static_cast<double>(j) * static_cast<double>(vertices) / static_cast<double>(k.size()), k[j]});
  l.colour = colour;
  Picture p;
  p.equal_axes = false;
  p.x_label = "vertex";
  p.y_label = "curvature";
  p.title = std::move(title);
  p.lines = {l};
  return p;
}

std::string curvature_figures(Figures& f) {
  std::string panels;
  int colour = 0;
  for (const Tension& t : tensions) {
    if (std::string(t.w) == "1/4") continue;
    const auto points = refined(t.printed, bean, limit_levels);
    panels += f.panel(fmt::format("10-{}", colour + 1), std::string("printed, w = ") + t.w,
                      curvature_picture(points, bean.values.size() / 2, "", colour));
    ++colour;
  }
  for (const auto& [id, scheme, what] :
       {std::tuple("10-comb-1", "hermite-circle:w=1/2", "comb, printed, w = 1/2"),
        std::tuple("10-comb-2", "hermite-circle", "comb, w = 1"),
        std::tuple("10-comb-3", "hermite-circle:w=5/4", "comb, printed, w = 5/4"),
        std::tuple("10-comb-4", "hermite-circle:variant=c2,w=5/4", "comb, variant c2, w = 5/4")}) {
    const auto points = refined(scheme, bean, limit_levels);
    Picture p;
    p.lines = curvature_comb(points, true);
    p.lines.push_back(polygon_line(bean.values, true));
    p.lines.push_back(curve_line(points, true, "step 10", 0));
    panels += f.panel(id, what, p);
  }
  return panels;
}

}  // namespace

std::vector<Section> figure_sections(const PaperOptions& options) {
  Figures f;
  const auto progress = [&](const char* step) {
    if (options.progress) options.progress(step);
  };
  const auto plot = [](const std::string& kind, const std::string& scheme, const Polygon& polygon) {
    return std::vector<std::string>{"twoscale plot " + kind + " " + shell_quoted(scheme) + " --levels 10 " +
                                    (polygon.closed ? "" : "--open given ") + "data/" + polygon.name + ".csv -o " +
                                    kind + ".svg"};
  };
  const auto curve = [&](const Polygon& polygon) { return plot("curve", "hermite-circle", polygon); };
  progress("figures 1 to 3");
  f.open("1", "q_i and their barycenter b",
         "(S.1), (S.2) on a closed and on an open polygon: b moves from inside to outside.");
  f.panels(f.centres("1a", "closed", irregular) + f.centres("1b", "open", arc));
  f.open("2", "self-intersecting polylines", "Several turns about b are mapped to [−π, π].");
  f.panels(f.centres("2a", "pentagram, stretched", {"", true, {0, 2, -1.3, -1.9, 2.2, 0.7, -2, 0.6, 1.2, -1.7}}) +
           f.centres("2b", "a loop", loop));
  f.open("3", "points on a circle", "All q_i coincide with b, the centre.");
  f.panels(f.centres("3a", "closed", circle_points) + f.centres("3b", "open", half_circle));
  progress("figures 4 and 5");
  f.open("4", "exact full circles", "From points with any spacing.");
  f.panels(f.steps("4", "full circle", circle_points, curve(circle_points)));
  f.part().html += circle_table(f) + exact_circle(f);
  f.open("5", "exact arcs", "From an open polygon.");
  f.panels(f.steps("5", "arc of 185°", half_circle, curve(half_circle)));
  progress("figures 6 to 8");
  f.open("6", "non-regular closed polylines",
         "Also one with nearly collinear triples, which Algorithm 1 as printed sends far away.");
  f.panels(f.steps("6a", "closed", irregular, curve(irregular)) +
           f.steps("6b", "nearly collinear triples", flat, curve(flat)));
  f.open("7", "non-regular open polylines", "");
  f.panels(f.steps("7a", "arc", arc, curve(arc)) + f.steps("7b", "wave", wave, curve(wave)));
  f.open("8", "self-intersecting polylines",
         "The pentagram has two turns: its points lie on a circle, and the curve runs through it twice. The other "
         "polygons are not round.");
  f.panels(f.steps("8a", "pentagram", pentagram, curve(pentagram)) +
           f.steps("8b", "figure eight", eight, curve(eight)) + f.steps("8c", "a loop", loop, curve(loop)));
  progress("figures 9 and 10");
  f.open("9", "the tension parameter", "The same points and derivatives, w from 1/4 to 3/2.");
  f.panels(tension_figures(f));
  f.part().html +=
      hidden_commands({"twoscale plot sweep hermite-circle --values 1/2,1,3/2 data/bean.csv -o sweep.svg"});
  f.open("10", "discrete curvature after 10 steps",
         "The circle through three neighbouring points. Curvature is continuous for every w (proved above), though the "
         "printed tension is not C² for w ≠ 1.");
  f.panels(curvature_figures(f));
  std::vector<std::string> commands = plot("curvature", "hermite-circle:w=1/2", bean);
  commands.push_back(plot("comb", "hermite-circle:w=1/2", bean).front());
  f.part().html += hidden_commands(commands);
  for (const Polygon* p :
       {&irregular, &arc, &circle_points, &half_circle, &pentagram, &eight, &wave, &bean, &flat, &loop})
    f.part().files.emplace_back(std::string("data/") + p->name + ".csv", kernels::to_csv(p->points()));
  return f.sections();
}

}  // namespace twoscale::reports::hermite2010
