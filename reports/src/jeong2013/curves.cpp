// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 1, 2, 4, 5, 8, 9: basic limit functions and limit curves of the fourth-order forms.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sections.hpp"
#include "twoscale/kernels/points_io.hpp"
#include "twoscale/reports/curves.hpp"
#include "twoscale/reports/html.hpp"
#include "twoscale/symbolic/catalog.hpp"

namespace twoscale::reports::jeong2013 {

namespace {

using kernels::Boundary;

constexpr int levels = 7;

// Vertices x, y of a closed polygon, and the file in data/ that holds them; all of them are ours.
struct Polygon {
  const char* file;
  std::vector<double> vertices;
};
const Polygon star = {"data/star.csv", {0, 0, 2, -1, 4, 0, 3.3, 1.6, 4, 3.4, 2, 2.7, 0, 3.4, 0.7, 1.6}};
const Polygon irregular = {"data/irregular.csv",
                           {0, 0, 3, -0.4, 6, 0, 6.35, 0.3, 6.4, 2.6, 4.3, 2.9, 4.05, 3.2, 4.1, 5, 3.8, 5.2, 0.2, 4.8}};
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

struct Measures {
  double area, distance, turning;
};

Measures measured(const std::vector<double>& curve, const std::vector<double>& polygon) {
  return {area(curve), distance_to_polygon({curve, 2, 0, 1}, polygon, true), total_turning(curve, true)};
}

std::vector<std::string> plot_commands(const std::string& id, const std::vector<Run>& runs, const Polygon& polygon) {
  std::vector<std::string> lines;
  for (const Run& run : runs)
    lines.push_back("twoscale plot curve " + shell_quoted(run.scheme.id) +
                    (run.v0.empty() ? "" : " --v0=" + shell_quoted(run.v0)) + fmt::format(" --levels {} ", levels) +
                    polygon.file + " -o " + id + ".svg");
  return lines;
}

// A figure with one picture, several runs from the same polygon, and what was measured.
std::string panel(const std::string& id, const std::string& title, const std::vector<Run>& runs, const Polygon& start,
                  Part& part, bool region = false) {
  const std::vector<double>& polygon = start.vertices;
  Picture p;
  std::string rows;
  int colour = 0;
  if (!region) p.lines.push_back(polygon_line(polygon, true));
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
    const std::vector<double> shown(polygon.begin() + 2 * region_first, polygon.begin() + 2 * region_last + 2);
    p.lines.insert(p.lines.begin(), polygon_line(shown, false));
  }
  p.height = 430;
  return figure(
      part,
      {id, title,
       "\n<table><thead><tr><th>run</th><th>area</th><th>distance to polygon</th><th>turning</th></tr></thead>"
       "<tbody>\n" +
           rows + "</tbody></table>",
       plot_commands(id, runs, start)},
      p);
}

Section empty_section(int number, const std::string& title) {
  const std::string n = std::to_string(number);
  Section s{"figure-" + n, "Figure " + n, "Figure " + n + ": " + title, {}};
  s.part.numbers = nlohmann::ordered_json::array();
  return s;
}

void fill(Section& s, const std::string& text, const std::string& panels) {
  s.part.html += "<p>" + text + "</p>\n<div class=\"panels\">\n" + panels + "</div>\n";
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

Section figure1(bool& ordered) {
  Section section = empty_section(1, "Basic limit functions of the cubic quasi-spline");
  Picture p;
  p.equal_axes = false;
  p.x_label = "parameter";
  std::string rows;
  std::vector<std::string> commands;
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
    section.part.numbers.push_back(
        nlohmann::ordered_json{{"panel", "1"}, {"scheme", run.scheme.id}, {"centre", centre}});
    commands.push_back("twoscale plot basic " + shell_quoted(run.scheme.id) + " -o basic.svg");
    p.lines.push_back(std::move(l));
  }
  p.height = 430;
  fill(section, "The masks of Example 2.2. At the origin they lie below one another in the order of the caption.",
       figure(section.part,
              {"1", "Basic limit functions",
               fmt::format("\n<table class=\"narrow\"><thead><tr><th>ω</th><th>value at the origin after {} steps</th>"
                           "</tr></thead><tbody>\n{}</tbody></table>",
                           levels, rows),
               commands},
              p));
  return section;
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

std::vector<Section> first_curves(const PaperOptions& options) {
  if (options.progress) options.progress("figures 1 to 5");
  bool ordered = true;
  std::vector<Section> sections;
  sections.push_back(figure1(ordered));
  sections[0].part.files.emplace_back(star.file, csv(star.vertices));
  Section two = empty_section(2, "Limit curves of the cubic quasi-spline");
  ordered = ordered && areas_grow(cubic_runs(), star.vertices, -1);
  fill(two, "The same schemes on a closed polygon (ours). The areas say which curve is the outermost.",
       panel("2", "Limit curves", cubic_runs(), star, two.part));
  sections.push_back(std::move(two));

  Section four = empty_section(4, "Tension forms (26)");
  std::string panels;
  const std::vector<std::string> quarters = {"0", "1/4", "1/2", "3/4", "1"};
  const std::tuple<const char*, const char*, const char*> lambdas[] = {
      {"4a", "3", "cosh(3)"}, {"4b", "1", "cosh(1)"}, {"4c", "iπ/2", "0"}, {"4d", "2.7i", "cos(27/10)"}};
  for (const auto& [id, lambda, v0] : lambdas) {
    const auto runs = tension_runs(TensionForm::spline, quarters, v0);
    ordered = ordered && areas_grow(runs, star.vertices, 1);
    panels += panel(id, std::string("λ₂ = ") + lambda, runs, star, four.part);
  }
  fill(four,
       "From the exponential B-spline, t = 0, to the 4-point interpolating scheme, t = 1; λ₁ = 0. The polygon is ours.",
       panels);
  four.part.findings.push_back(std::string("Figures 1, 2, 4: the orders stated in the captions ") +
                               (ordered ? "hold" : "do not all hold") +
                               " on our polygon, measured by the values at the origin and by the enclosed areas.");
  sections.push_back(std::move(four));

  Section five = empty_section(5, "Large real frequencies");
  panels.clear();
  const std::tuple<const char*, const char*, const char*> real[] = {
      {"5a", "1", "cosh(1)"}, {"5b", "4", "cosh(4)"}, {"5c", "8", "cosh(8)"}, {"5d", "16", "cosh(16)"}};
  for (const auto& [id, lambda, v0] : real)
    panels += panel(id, std::string("λ₂ = ") + lambda, tension_runs(TensionForm::spline, {"1/2", "1/4"}, v0), star,
                    five.part);
  fill(five,
       "The caption says t = 1/2, the text of Example 6.1 t = 1/4: both are drawn. With growing λ₂ the curves tend to "
       "the polygon for either.",
       panels);
  sections.push_back(std::move(five));
  return sections;
}

std::vector<Section> last_curves(const PaperOptions& options) {
  if (options.progress) options.progress("figures 8 and 9");
  Section eight = empty_section(8, "An irregular polygon");
  eight.part.files.emplace_back(irregular.file, csv(irregular.vertices));
  std::string panels;
  const std::tuple<const char*, const char*, const char*, const char*> runs8[] = {{"8b", "1", "0", "1"},
                                                                                  {"8c", "1", "4", "cosh(4)"},
                                                                                  {"8d", "1", "8", "cosh(8)"},
                                                                                  {"8e", "1/4", "3/2", "cosh(3/2)"}};
  for (const auto& [id, t, lambda, v0] : runs8)
    panels += panel(id, fmt::format("t = {}, λ₂ = {}", t, lambda), tension_runs(TensionForm::polygon, {t}, v0),
                    irregular, eight.part);
  fill(eight,
       "Interpolating schemes (27) with (28). The polygon is ours; it turns by " +
           fmt::format("{:.3f}", total_turning(irregular.vertices, true)) + ".",
       panels);

  Section nine = empty_section(9, "Beside the 4-point scheme of Dyn, Gregory and Levin");
  panels.clear();
  const std::pair<const char*, const char*> runs9[] = {{"9a", "1/2"}, {"9b", "1/4"}, {"9c", "1/6"}, {"9d", "1/8"}};
  double gain = 0;
  for (const auto& [id, t] : runs9) {
    const Scheme s = make_scheme(tension_name(TensionForm::polygon, t));
    const std::vector<Run> runs = {{"quasi-spline, λ₂ = 3/2", s, "cosh(3/2)"}, {"4-point, w = t/16", s, "1"}};
    const double a = measured(refined(runs[0], irregular.vertices), irregular.vertices).distance;
    const double b = measured(refined(runs[1], irregular.vertices), irregular.vertices).distance;
    gain = std::max(gain, a / b);
    panels += panel(id, std::string("t = ") + t, runs, irregular, nine.part, true);
  }
  fill(nine,
       "A part of the same polygon. The paper does not say how t enters the scheme it compares with; w = t/16 is "
       "(27)-(28) with λ₂ = 0. Its weight is then larger at every step, since γ₂(2 + γ₂) ≥ 8: the curves of λ₂ = 3/2 "
       "stay closer to the polygon at the same t.",
       panels);
  nine.part.findings.push_back(fmt::format(
      "Figure 9: at equal t the quasi-spline with λ₂ = 3/2 stays within {:.2f} of the distance that the 4-point scheme "
      "with w = t/16 keeps from the polygon; a part of its advantage is that its weights are smaller at the first "
      "steps (t/(8v(1+v)) with v = cosh(3/4) at the first).",
      gain));
  std::vector<Section> sections;
  sections.push_back(std::move(eight));
  sections.push_back(std::move(nine));
  return sections;
}

}  // namespace twoscale::reports::jeong2013
