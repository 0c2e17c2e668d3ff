// SPDX-License-Identifier: GPL-3.0-or-later
// The section of figures: every panel measured, drawn, and with the commands that repeat it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "page.hpp"
#include "twoscale/kernels/points_io.hpp"
#include "twoscale/lowering/fit.hpp"
#include "twoscale/reports/curves.hpp"
#include "twoscale/reports/html.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::reports::romani2009 {

namespace {

const char* word(Expect e) {
  switch (e) {
    case Expect::exact: return "exact";
    case Expect::different: return "different";
    case Expect::impossible: return "impossible";
    case Expect::shape: return "shape";
  }
  return "";
}

// The vertices that the curve runs through, without those beyond the ends.
Line polygon_line(const StartPoints& start) {
  Line l;
  l.dim = start.dim;
  l.style = Line::Style::polygon;
  l.closed = start.closed;
  const auto skip = static_cast<std::ptrdiff_t>(start.beyond * start.dim);
  l.values.assign(start.values.begin() + skip, start.values.end() - skip);
  l.title = "polygon";
  return l;
}

Line true_curve(const Samples& s) {
  Line l;
  l.dim = s.curve.dim;
  l.style = Line::Style::reference;
  l.title = "true curve";
  const double first = std::strtod(parse_real(s.first).decimal(17).c_str(), nullptr);
  const double spacing = std::strtod(parse_real(s.spacing).decimal(17).c_str(), nullptr);
  const double length = spacing * (s.closed ? s.count : s.count - 1);
  constexpr int pieces = 500;
  for (int i = 0; i <= pieces; ++i) {
    double p[3];
    s.curve.at(first + length * i / pieces, p);
    l.values.insert(l.values.end(), p, p + s.curve.dim);
  }
  return l;
}

// "cos(4*pi/5)" as it is written by hand.
std::string legend_text(std::string v0) {
  for (std::size_t at = v0.find("*pi"); at != std::string::npos; at = v0.find("*pi")) v0.replace(at, 3, "π");
  for (std::size_t at = v0.find("pi"); at != std::string::npos; at = v0.find("pi")) v0.replace(at, 2, "π");
  if (v0.starts_with('-')) v0.replace(0, 1, "−");
  return "v⁰ = " + v0;
}

Picture picture(const Panel& panel, const std::vector<Measured>& results) {
  const StartPoints start = start_points(panel, panel.trials[0]);
  Picture p;
  p.lines.push_back(polygon_line(start));
  const bool sweep = panel.trials.size() > 1 && panel.trials[0].expect == Expect::shape;
  if (start.dim == 3 || sweep) p.height = 440;
  bool exact_drawn = false;
  int colour = 0;
  for (std::size_t i = 0; i < panel.trials.size(); ++i) {
    const Trial& t = panel.trials[i];
    // Curves that coincide are drawn once.
    if (!results[i].ran || (t.expect == Expect::exact && exact_drawn)) continue;
    exact_drawn = exact_drawn || t.expect == Expect::exact;
    Line l;
    l.dim = start.dim;
    l.closed = start.closed;
    l.values = results[i].curve;
    l.colour = colour++;
    if (sweep || (t.expect == Expect::different && panel.trials[0].expect == Expect::exact))
      l.title = legend_text(t.v0);
    else
      l.title = "limit curve";
    p.lines.push_back(std::move(l));
  }
  if (panel.show_curve) p.lines.push_back(true_curve(std::get<Samples>(panel.start)));
  return p;
}

std::string trial_row(const Panel& panel, const Trial& t, const Measured& m) {
  const bool samples = std::holds_alternative<Samples>(panel.start);
  std::string s = fmt::format("<tr><td>{}</td><td>{}</td>", escaped(scheme_label(t.scheme)), v0_html(t.v0));
  if (!m.ran)
    return s + "<td class=\"refuted\" colspan=\"2\" title=\"" + escaped(m.refusal) +
           "\">impossible: a step is singular</td></tr>\n";
  if (!samples) return s + fmt::format("<td>{}</td><td>{:.2f}</td></tr>\n", number_text(m.polygon_distance), m.turning);
  const bool exact = m.deviation < 1e-12;
  return s + fmt::format("<td>{}</td><td class=\"{}\">{}</td></tr>\n", m.points, exact ? "proved" : "refuted",
                         number_text(m.deviation));
}

std::string csv(const StartPoints& start) {
  kernels::PointSet set;
  set.columns = kernels::default_columns(start.dim);
  set.dim = start.dim;
  set.values = start.values;
  return kernels::to_csv(set);
}

std::string commands(const Panel& panel, const StartPoints& start) {
  std::string lines;
  for (const Trial& t : panel.trials) {
    const std::string v0 = t.v0.empty() ? "" : " --v0=" + shell_quoted(t.v0);
    lines += command("twoscale refine " + shell_quoted(t.scheme) + v0 + fmt::format(" --levels {}", measured_levels) +
                     (start.closed ? " --closed" : " --open=given") + " data/" + panel.id + ".csv -o curve.csv" +
                     (t.expect == Expect::impossible ? "   # refused, exit status 2" : ""));
  }
  return "<details><summary>Commands</summary><pre class=\"shell\">" + lines + "</pre></details>";
}

std::string panel_html(const Panel& panel, Part& part, Summary& summary) {
  std::vector<Measured> results;
  const StartPoints start = start_points(panel, panel.trials[0]);
  const auto* samples = std::get_if<Samples>(&panel.start);
  std::string rows;
  for (const Trial& t : panel.trials) {
    const Measured m = measure(panel, t);
    rows += trial_row(panel, t, m);
    if (t.expect == Expect::exact) {
      ++summary.exact_runs;
      summary.largest_exact_deviation = std::max(summary.largest_exact_deviation, m.ran ? m.deviation : INFINITY);
    }
    nlohmann::ordered_json j;
    j["panel"] = panel.id;
    j["scheme"] = t.scheme;
    j["v0"] = t.v0.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(t.v0);
    j["expected"] = word(t.expect);
    if (!m.ran)
      j["refusal"] = m.refusal;
    else if (samples != nullptr)
      j.update({{"points", m.points}, {"deviation", m.deviation}});
    else
      j.update({{"polygon_distance", m.polygon_distance}, {"turning", m.turning}});
    part.numbers.push_back(j);
    results.push_back(m);
  }
  part.files.emplace_back("data/" + panel.id + ".csv", csv(start));
  ++summary.pictures;
  std::string s =
      fmt::format("<figure id=\"panel-{}\">\n{}\n<figcaption><strong>{}</strong> {}", panel.id,
                  embedded(part, panel.id, panel.title, picture(panel, results)), panel.id, escaped(panel.title));
  if (samples != nullptr)
    s += fmt::format(
        "<br/>{}; {} points from s = {} on, spacing {}{}", escaped(samples->curve.formula), samples->count,
        v0_html(samples->first), v0_html(samples->spacing),
        samples->closed ? ", closed" : fmt::format(", open, {} more samples beyond each end", start.beyond));
  if (!panel.note.empty()) s += "<br/><em>" + escaped(panel.note) + "</em>";
  s += "\n<table><thead><tr><th>scheme</th><th>v⁰</th>";
  s += samples != nullptr ? "<th>points compared</th><th>largest deviation</th>"
                          : "<th>distance to polygon</th><th>turning</th>";
  s += "</tr></thead><tbody>\n" + rows + "</tbody></table>\n";
  if (samples == nullptr)
    s += fmt::format("<p class=\"small\">The polygon itself turns by {:.2f}.</p>\n", total_turning(start.values, true));
  return s + commands(panel, start) + "</figcaption>\n</figure>\n";
}

// What the 4-point scheme and a wrong v^0 give away.
std::vector<std::string> findings() {
  std::vector<std::string> list;
  const auto panel = [](const char* id) -> const Panel& {
    for (const Figure& f : figures())
      for (const Panel& p : f.panels)
        if (p.id == id) return p;
    throw std::logic_error("no such panel");
  };
  const Panel& cardioid = panel("1a");
  const Panel& astroid = panel("1c");
  list.push_back(
      fmt::format("Figure 1: the 4-point scheme misses the cardioid by {} and the astroid by {} of the curve’s size. "
                  "From the paper’s 6 points "
                  "no scheme can return the astroid, because sin 3s vanishes at all of them; 5 or 7 points suffice (<a "
                  "href=\"#counts\">table</a>).",
                  number_text(measure(cardioid, cardioid.trials[0]).deviation),
                  number_text(measure(astroid, astroid.trials[0]).deviation)));
  const Panel& viviani = panel("7b2");
  const StartPoints start = start_points(viviani, viviani.trials[0]);
  kernels::PointSet samples;
  samples.columns = kernels::default_columns(start.dim);
  samples.dim = start.dim;
  samples.values = start.values;
  const lowering::Fit fit = lowering::fit(*make_scheme(viviani.trials[0].scheme).space, samples, start.closed);
  list.push_back(
      fmt::format("Figure 7b: Viviani’s curve has the base frequency 1/2. The fit to 10 samples at spacing 2π/5 finds "
                  "v⁰ = {}, which is cos(π/5): "
                  "deviation {}. With v⁰ = cos(2π/5) it is {}; that value belongs to 5 samples at spacing 4π/5.",
                  fit.v0.empty() ? "nothing" : fit.v0, number_text(measure(viviani, viviani.trials[0]).deviation),
                  number_text(measure(viviani, viviani.trials[1]).deviation)));
  return list;
}

}  // namespace

Part figure_part(const Options& options, Summary& summary) {
  Part part;
  part.numbers = nlohmann::ordered_json::array();
  part.html = "<section id=\"figures\">\n<h2>Figures 1–12</h2>\n";
  const Part tension = tension_part();
  for (const Figure& f : figures()) {
    if (options.progress) options.progress("figure " + std::to_string(f.number));
    part.html += fmt::format("<section class=\"figure\" id=\"figure-{0}\">\n<h3>Figure {0}: {1}</h3>\n", f.number,
                             escaped(f.title));
    if (!f.text.empty()) part.html += "<p>" + escaped(f.text) + "</p>\n";
    part.html += "<div class=\"panels\">\n";
    for (const Panel& p : f.panels) part.html += panel_html(p, part, summary);
    part.html += "</div>\n</section>\n";
    if (f.number == 10) part.html += tension.html;
  }
  part.html += "</section>\n";
  part.findings = findings();
  part.files.insert(part.files.end(), tension.files.begin(), tension.files.end());
  part.findings.insert(part.findings.end(), tension.findings.begin(), tension.findings.end());
  summary.pictures += static_cast<int>(tension.files.size());
  return part;
}

}  // namespace twoscale::reports::romani2009
