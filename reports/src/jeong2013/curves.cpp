// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 1, 2, 4, 5, 8, 9: basic limit functions and limit curves of the fourth-order forms.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "page.hpp"
#include "twoscale/kernels/points_io.hpp"
#include "twoscale/reports/curves.hpp"
#include "twoscale/reports/html.hpp"
#include "twoscale/symbolic/catalog.hpp"

namespace twoscale::reports::jeong2013 {

namespace {

using kernels::Boundary;

constexpr int levels = 7;

// Vertices x, y; all of them are ours.
const std::vector<double> star = {0, 0, 2, -1, 4, 0, 3.3, 1.6, 4, 3.4, 2, 2.7, 0, 3.4, 0.7, 1.6};
const std::vector<double> irregular = {0,   0,   3,    -0.4, 6,   0, 6.35, 0.3, 6.4, 2.6,
                                       4.3, 2.9, 4.05, 3.2,  4.1, 5, 3.8,  5.2, 0.2, 4.8};
constexpr std::size_t region_first = 4, region_last = 8;  // vertices of the region of figure 9

struct Run {
  std::string label;
  Scheme scheme;
  std::string v0;  // empty: stationary
};

std::vector<double> refined(const Run& run, const std::vector<double>& polygon) {
  const auto v0 = run.v0.empty() ? std::optional<std::string>() : run.v0;
  return refine_points(run.scheme, lowering::bind(run.scheme, v0, std::nullopt, {}), polygon, 2, levels,
                       Boundary::closed)
      .values;
}

double area(const std::vector<double>& p) {
  double sum = 0;
  const std::size_t n = p.size() / 2;
  for (std::size_t j = 0; j < n; ++j) {
    const std::size_t k = (j + 1) % n;
    sum += p[2 * j] * p[2 * k + 1] - p[2 * k] * p[2 * j + 1];
  }
  return std::abs(sum) / 2;
}

Line polygon_line(const std::vector<double>& polygon) {
  Line l;
  l.values = polygon;
  l.style = Line::Style::polygon;
  l.closed = true;
  l.title = "polygon";
  return l;
}

struct Measures {
  double area, distance, turning;
};

Measures measured(const std::vector<double>& curve, const std::vector<double>& polygon) {
  return {area(curve), distance_to_polygon({curve, 2, 0, 1}, polygon, true), total_turning(curve, true)};
}

// A figure with one picture, several runs from the same polygon, and what was measured.
std::string panel(const std::string& id, const std::string& title, const std::vector<Run>& runs,
                  const std::vector<double>& polygon, Part& part, Summary& summary, bool region = false) {
  Picture p;
  std::string rows;
  int colour = 0;
  if (!region) p.lines.push_back(polygon_line(polygon));
  for (const Run& run : runs) {
    std::vector<double> curve = refined(run, polygon);
    const Measures m = measured(curve, polygon);
    rows += fmt::format("<tr><td>{}</td><td>{:.3f}</td><td>{}</td><td>{:.3f}</td></tr>\n", escaped(run.label), m.area,
                        number_text(m.distance), m.turning);
    part.numbers.push_back(nlohmann::ordered_json{{"panel", id},
                                                  {"scheme", run.scheme.id},
                                                  {"v0", run.v0},
                                                  {"area", m.area},
                                                  {"polygon_distance", m.distance},
                                                  {"turning", m.turning}});
    Line l;
    l.closed = !region;
    l.title = run.label;
    l.colour = colour++;
    if (region) {
      const auto at = [](std::size_t vertex) { return static_cast<std::ptrdiff_t>((2 * vertex) << levels); };
      curve = std::vector<double>(curve.begin() + at(region_first), curve.begin() + at(region_last) + 2);
    }
    l.values = std::move(curve);
    p.lines.push_back(std::move(l));
  }
  if (region) {
    Line l =
        polygon_line(std::vector<double>(polygon.begin() + 2 * region_first, polygon.begin() + 2 * region_last + 2));
    l.closed = false;
    p.lines.insert(p.lines.begin(), l);
  }
  p.height = 430;
  ++summary.pictures;
  return fmt::format(
      "<figure id=\"panel-{0}\">\n{1}\n<figcaption><strong>{0}</strong> {2}\n<table><thead><tr><th>run</th>"
      "<th>area</th><th>distance to polygon</th><th>turning</th></tr></thead><tbody>\n{3}</tbody></table>"
      "</figcaption>\n</figure>\n",
      id, embedded(part, id, title, p), escaped(title), rows);
}

std::string section(int number, const std::string& title, const std::string& text, const std::string& panels,
                    const std::string& commands) {
  return fmt::format(
      "<section class=\"figure\" id=\"figure-{0}\">\n<h3>Figure {0}: {1}</h3>\n<p>{2}</p>\n<div "
      "class=\"panels\">\n{3}</div>\n{4}</section>\n",
      number, escaped(title), text, panels,
      commands.empty() ? ""
                       : "<details><summary>Commands</summary><pre class=\"shell\">" + commands + "</pre></details>\n");
}

std::string csv(const std::vector<double>& polygon) {
  kernels::PointSet set;
  set.columns = kernels::default_columns(2);
  set.dim = 2;
  set.values = polygon;
  return kernels::to_csv(set);
}

// ---- The stationary cubic quasi-spline of Example 2.2

const std::vector<std::string> omegas = {"-5/8", "-1/2", "-3/8", "-1/4", "-1/8", "0", "1/8", "1/4"};

std::string cubic_name(const std::string& omega) {
  const std::string w = "(" + omega + ")";
  return "mask:coefficients=\"" + w + "/8,(1+2*" + w + ")/8,(4-" + w + ")/8,(3-2*" + w + ")/4,(4-" + w + ")/8,(1+2*" +
         w + ")/8," + w + "/8\",lowest=-3";
}

std::vector<Run> cubic_runs() {
  std::vector<Run> runs;
  for (const std::string& omega : omegas) runs.push_back({"ω = " + omega, make_scheme(cubic_name(omega)), ""});
  return runs;
}

std::string figure1(Part& part, Summary& summary, bool& ordered) {
  Picture p;
  p.equal_axes = false;
  p.x_label = "parameter";
  std::string rows;
  int colour = 0;
  double last = INFINITY;
  for (const Run& run : cubic_runs()) {
    const Refined f =
        basic_limit_function(run.scheme, lowering::bind(run.scheme, std::nullopt, std::nullopt, {}), levels);
    Line l;
    l.values = f.values;
    l.title = run.label;
    l.colour = colour++;
    double centre = 0;
    for (std::size_t j = 0; j < f.size(); ++j)
      if (f.values[2 * j] == 0) centre = f.values[2 * j + 1];
    ordered = ordered && centre < last;
    last = centre;
    rows += fmt::format("<tr><td>{}</td><td>{:.6f}</td></tr>\n", escaped(run.label), centre);
    part.numbers.push_back(nlohmann::ordered_json{{"panel", "1"}, {"scheme", run.scheme.id}, {"centre", centre}});
    p.lines.push_back(std::move(l));
  }
  p.height = 430;
  ++summary.pictures;
  const std::string html = fmt::format(
      "<figure id=\"panel-1\">\n{}\n<figcaption><strong>1</strong> Basic limit functions\n<table "
      "class=\"narrow\"><thead><tr>"
      "<th>ω</th><th>value at the origin after {} steps</th></tr></thead><tbody>\n{}</tbody></table></figcaption>\n"
      "</figure>\n",
      embedded(part, "1", "Basic limit functions", p), levels, rows);
  return section(1, "Basic limit functions of the cubic quasi-spline",
                 "The masks of Example 2.2. At the origin they lie below one another in the order of the caption.",
                 html, command("twoscale plot basic '" + cubic_name("-3/8") + "' -o basic.svg"));
}

std::string tension_command(TensionForm form, const std::string& t, const std::string& v0, const std::string& data) {
  return command("twoscale refine " + shell_quoted(tension_name(form, t)) + " --v0 " + shell_quoted(v0) +
                 " --levels 7 data/" + data + ".csv -o curve.csv");
}

std::vector<Run> tension_runs(TensionForm form, const std::vector<std::string>& ts, const std::string& v0) {
  std::vector<Run> runs;
  for (const auto& t : ts) runs.push_back({"t = " + t, make_scheme(tension_name(form, t)), v0});
  return runs;
}

bool areas_grow(const std::vector<Run>& runs, const std::vector<double>& polygon, double sign) {
  double last = -INFINITY;
  for (const Run& run : runs) {
    const double a = sign * area(refined(run, polygon));
    if (!(a > last)) return false;
    last = a;
  }
  return true;
}

}  // namespace

std::string tension_name(TensionForm form, const std::string& t) {
  return "quasi-spline:space=\"1, x, exp(t*x), exp(-t*x)\",tension=" + t +
         (form == TensionForm::spline ? ",keep=\"1, x\"" : ",keep=\"1, x\",keep_space=\"1, x\"");
}

Part curve_part(const Options& options, Summary& summary) {
  Part part;
  part.numbers = nlohmann::ordered_json::array();
  const auto progress = [&](const char* step) {
    if (options.progress) options.progress(step);
  };
  progress("figures 1 and 2");
  part.files.emplace_back("data/star.csv", csv(star));
  part.files.emplace_back("data/irregular.csv", csv(irregular));
  bool ordered = true;
  part.html += figure1(part, summary, ordered);
  ordered = ordered && areas_grow(cubic_runs(), star, -1);
  part.html += section(2, "Limit curves of the cubic quasi-spline",
                       "The same schemes on a closed polygon (ours). The areas say which curve is the outermost.",
                       panel("2", "Limit curves", cubic_runs(), star, part, summary),
                       command("twoscale refine '" + cubic_name("-3/8") + "' --levels 7 data/star.csv -o curve.csv"));

  progress("figures 4 and 5");
  std::string panels;
  const std::vector<std::string> quarters = {"0", "1/4", "1/2", "3/4", "1"};
  const std::tuple<const char*, const char*, const char*> lambdas[] = {
      {"4a", "3", "cosh(3)"}, {"4b", "1", "cosh(1)"}, {"4c", "iπ/2", "0"}, {"4d", "2.7i", "cos(27/10)"}};
  for (const auto& [id, lambda, v0] : lambdas) {
    const auto runs = tension_runs(TensionForm::spline, quarters, v0);
    ordered = ordered && areas_grow(runs, star, 1);
    panels += panel(id, std::string("λ₂ = ") + lambda, runs, star, part, summary);
  }
  part.html +=
      section(4, "Tension forms (26)",
              "From the exponential B-spline, t = 0, to the 4-point interpolating scheme, t = 1; λ₁ = 0. The polygon "
              "is ours.",
              panels, tension_command(TensionForm::spline, "1/4", "cosh(3)", "star"));
  panels.clear();
  const std::tuple<const char*, const char*, const char*> real[] = {
      {"5a", "1", "cosh(1)"}, {"5b", "4", "cosh(4)"}, {"5c", "8", "cosh(8)"}, {"5d", "16", "cosh(16)"}};
  for (const auto& [id, lambda, v0] : real)
    panels += panel(id, std::string("λ₂ = ") + lambda, tension_runs(TensionForm::spline, {"1/2", "1/4"}, v0), star,
                    part, summary);
  part.html +=
      section(5, "Large real frequencies",
              "The caption says t = 1/2, the text of Example 6.1 t = 1/4: both are drawn. With growing λ₂ the curves "
              "tend to the polygon for either.",
              panels, tension_command(TensionForm::spline, "1/2", "cosh(4)", "star"));

  progress("figures 8 and 9");
  panels.clear();
  const std::tuple<const char*, const char*, const char*, const char*> eight[] = {{"8b", "1", "0", "1"},
                                                                                  {"8c", "1", "4", "cosh(4)"},
                                                                                  {"8d", "1", "8", "cosh(8)"},
                                                                                  {"8e", "1/4", "3/2", "cosh(3/2)"}};
  for (const auto& [id, t, lambda, v0] : eight)
    panels += panel(id, fmt::format("t = {}, λ₂ = {}", t, lambda), tension_runs(TensionForm::polygon, {t}, v0),
                    irregular, part, summary);
  part.html += section(8, "An irregular polygon",
                       "Interpolating schemes (27) with (28). The polygon is ours; it turns by " +
                           fmt::format("{:.3f}", total_turning(irregular, true)) + ".",
                       panels, tension_command(TensionForm::polygon, "1/4", "cosh(3/2)", "irregular"));
  panels.clear();
  const std::pair<const char*, const char*> nine[] = {{"9a", "1/2"}, {"9b", "1/4"}, {"9c", "1/6"}, {"9d", "1/8"}};
  double gain = 0;
  for (const auto& [id, t] : nine) {
    const Scheme s = make_scheme(tension_name(TensionForm::polygon, t));
    const std::vector<Run> runs = {{"quasi-spline, λ₂ = 3/2", s, "cosh(3/2)"}, {"4-point, w = t/16", s, "1"}};
    const double a = measured(refined(runs[0], irregular), irregular).distance;
    const double b = measured(refined(runs[1], irregular), irregular).distance;
    gain = std::max(gain, a / b);
    panels += panel(id, std::string("t = ") + t, runs, irregular, part, summary, true);
  }
  part.html +=
      section(9, "Beside the 4-point scheme of Dyn, Gregory and Levin",
              "A part of the same polygon. The paper does not say how t enters the scheme it compares with; w = t/16 "
              "is (27)-(28) with λ₂ = 0. Its weight is then larger at every step, since γ₂(2 + γ₂) ≥ 8: the curves of "
              "λ₂ = 3/2 stay closer to the polygon at the same t.",
              panels, tension_command(TensionForm::polygon, "1/2", "1", "irregular"));
  part.findings = {
      std::string("Figures 1, 2, 4: the orders stated in the captions ") + (ordered ? "hold" : "do not all hold") +
          " on our polygon, measured by the values at the origin and by the enclosed areas.",
      fmt::format(
          "Figure 9: at equal t the quasi-spline with λ₂ = 3/2 stays within {:.2f} of the distance that the 4-point "
          "scheme with w = t/16 keeps from the polygon; a part of its advantage is that its weights are smaller at "
          "the first steps (t/(8v(1+v)) with v = cosh(3/4) at the first).",
          gain)};
  return part;
}

}  // namespace twoscale::reports::jeong2013
