// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "audit/section.hpp"
#include "figures/tension.hpp"
#include "scheme/article.hpp"
#include "twoscale/kernels/points_io.hpp"
#include "twoscale/lowering/fit.hpp"
#include "twoscale/reports/beccari2007.hpp"
#include "twoscale/reports/html.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::reports::beccari2007 {

namespace {

const char* const rule =
    "<p>Derived from the space: <math><mrow><msubsup><mi>p</mi><mrow><mn>2</mn><mi>j</mi><mo>+</mo><mn>1</mn></mrow>"
    "<mrow><mi>k</mi><mo>+</mo><mn>1</mn></mrow></msubsup><mo>=</mo><mo stretchy=\"false\">(</mo><mfrac><mn>1</mn>"
    "<mn>2</mn></mfrac><mo>+</mo><mi>w</mi><mo stretchy=\"false\">)</mo><mo stretchy=\"false\">(</mo><msubsup>"
    "<mi>p</mi><mi>j</mi><mi>k</mi></msubsup><mo>+</mo><msubsup><mi>p</mi><mrow><mi>j</mi><mo>+</mo><mn>1</mn></mrow>"
    "<mi>k</mi></msubsup><mo stretchy=\"false\">)</mo><mo>−</mo><mi>w</mi><mo stretchy=\"false\">(</mo><msubsup>"
    "<mi>p</mi><mrow><mi>j</mi><mo>−</mo><mn>1</mn></mrow><mi>k</mi></msubsup><mo>+</mo><msubsup><mi>p</mi><mrow>"
    "<mi>j</mi><mo>+</mo><mn>2</mn></mrow><mi>k</mi></msubsup><mo stretchy=\"false\">)</mo></mrow></math> with</p>\n";

Section scheme_section(const PaperOptions& options) {
  Section section{"scheme", "The scheme", "The 4-point scheme with tension", {}};
  section.part.numbers = nlohmann::ordered_json::array();
  const Laurent a = symbol(make_scheme("tension4"));
  Article article{"tension4",
                  "Section 2: the insertion rule",
                  rule + std::string("<p>") +
                      formula("<mi>w</mi><mo>=</mo><mo>−</mo><msub><mi>a</mi><mrow><mo>±</mo><mn>3</mn></mrow></msub>",
                              (-a.coefficient(3)).to_string()) +
                      ", <math><mrow><mi>v</mi><mo>=</mo><msup><mi>v</mi><mrow><mi>k</mi><mo>+</mo><mn>1</mn></mrow>"
                      "</msup></mrow></math>, equation (7).</p>\n",
                  "tension4",
                  {"2", "-1/2", "0", "1", "10"}};
  section.part.html = scheme_article(section.part, article, options);
  return section;
}

// ---- Section 3.2

struct Sampled {
  const char* title;
  Curve curve;
  const char* spacing;
  const char* v0;  // the right one
};

const std::vector<Sampled>& sampled() {
  static const Curve circle = std::get<Samples>(panel(figures(), "5").start).curve;
  static const Curve hyperbola = std::get<Samples>(panel(figures(), "2a").start).curve;
  static const Curve parabola = std::get<Samples>(panel(figures(), "2c").start).curve;
  static const std::vector<Sampled> list = {
      {"Hyperbola", hyperbola, "1/2", "cosh(1/2)"}, {"Parabola", parabola, "1/2", "1"},
      {"Circle", circle, "pi/5", "cos(pi/5)"},      {"Circle, quarter turns", circle, "pi/2", "0"},
      {"Circle", circle, "2*pi/3", "-1/2"},         {"Circle", circle, "3*pi/4", "cos(3*pi/4)"}};
  return list;
}

std::vector<double> nine_points(const Sampled& s) {
  const double step = std::strtod(parse_real(s.spacing).decimal(20).c_str(), nullptr);
  std::vector<double> points;
  for (int j = 0; j < 9; ++j) {
    double p[2];
    s.curve.at(j * step, p);
    points.insert(points.end(), p, p + 2);
  }
  return points;
}

Section algorithm_section() {
  Section section{"algorithm", "The tension of given points", "Section 3.2: the tension of given points", {}};
  Part& part = section.part;
  part.numbers = nlohmann::ordered_json::array();
  part.html =
      "<p>The algorithm of the paper, run on nine samples: the common weight w of (8), then step [3.1] as it is "
      "printed. Because (8) takes half of each sum, its w is twice the weight of (7), w = 1/(4v(1+v)); the inverse is "
      "(√(1 + 1/w) − 1)/2, which is right for v ≥ −1/2 only, since v and −1 − v have one weight, and at v = 0 equation "
      "(8) has no solution. The last column is <code>twoscale fit</code>, which uses second differences of "
      "neighbouring points instead.</p>\n"
      "<table><thead><tr><th>samples</th><th>spacing</th><th>v⁰</th><th>as printed</th><th>with the right inverse</th>"
      "<th>twoscale fit</th></tr></thead><tbody>\n";
  int wrong = 0;
  const auto cell = [&](double value, double right) {
    return fmt::format("<td class=\"{}\">{:.6g}</td>", std::abs(value - right) < 1e-6 ? "proved" : "refuted", value);
  };
  std::vector<std::string> commands;
  for (const Sampled& s : sampled()) {
    const std::vector<double> points = nine_points(s);
    const PrintedTension t = printed_tension(points);
    const double right = std::strtod(parse_real(s.v0).decimal(20).c_str(), nullptr);
    kernels::PointSet set;
    set.columns = kernels::default_columns(2);
    set.dim = 2;
    set.values = points;
    const lowering::Fit fit = lowering::fit(*make_scheme("tension4").space, set, false);
    const double fitted = fit.v0.empty() ? NAN : std::strtod(fit.v0.c_str(), nullptr);
    part.html += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td>", s.title, v0_html(s.spacing), v0_html(s.v0));
    nlohmann::ordered_json j{{"samples", s.title}, {"spacing", s.spacing}, {"v0", s.v0}, {"fit", fit.v0}};
    if (!t.obstacle.empty()) {
      part.html += "<td class=\"refuted\" colspan=\"2\">" + escaped(t.obstacle) + "</td>";
      j["obstacle"] = t.obstacle;
    } else {
      part.html += cell(t.as_printed, right) + cell(t.corrected, right);
      j.update({{"as_printed", t.as_printed}, {"corrected", t.corrected}});
    }
    if (!t.obstacle.empty() || std::abs(t.as_printed - right) >= 1e-6) ++wrong;
    part.html += cell(fitted, right) + "</tr>\n";
    part.numbers.push_back(std::move(j));
    const std::string file = fmt::format("data/samples-{}.csv", commands.size() + 1);
    part.files.emplace_back(file, kernels::to_csv(set));
    commands.push_back("twoscale fit tension4 " + file);
  }
  part.html += "</tbody></table>\n" + commands_html(commands);
  part.findings.push_back(fmt::format(
      "Section 3.2: step [3.1] inverts (7), not (8). On nine samples each of {} curves the algorithm as "
      "printed returns a wrong v⁰ or stops {} times (<a href=\"#algorithm\">table</a>); a circle sampled at "
      "quarter turns, figure 5, is rejected.",
      sampled().size(), wrong));
  return section;
}

Section tension_section() {
  Section section{"tension", "Tension", "Figures 3 and 4: does the curve tighten as v⁰ grows?", {}};
  Part& part = section.part;
  const Panel& closed = panel(figures(), "4");
  const TensionSweep sweep = tension_sweep(part, {closed.trials[0].scheme}, std::get<Polygon>(closed.start));
  const TensionCourse& course = sweep.courses[0];
  part.html = "<p>Measured on the polygon of figure 4.</p>\n" + sweep.html;
  part.findings.push_back(fmt::format(
      "Figures 3 and 4: on the polygon of figure 4 the distance of the curve to the polygon {}; at v⁰ = 9999 "
      "it is {} of the polygon’s size.",
      course.monotone ? "falls for all v⁰, as the paper says" : course.words, number_text(course.at_end)));
  return section;
}

}  // namespace

PaperSummary write_report(const std::string& directory, const PaperOptions& options) {
  make_directory(directory);  // refused before anything is computed
  PaperPage page;
  page.paper = "beccari2007";
  page.about =
      "the scheme derived from its space and proved, the six figures, and the algorithm for the tension of given "
      "points.";
  page.method = figure_method();
  std::vector<Section> sections;
  sections.push_back(scheme_section(options));
  sections.push_back(audit_section(page.paper));
  sections.push_back(algorithm_section());
  for (const Figure& f : figures()) {
    sections.push_back(figure_section(f, options));
    if (f.number == 4) sections.push_back(tension_section());
  }
  return write_paper_page(directory, page, std::move(sections));
}

}  // namespace twoscale::reports::beccari2007
