// SPDX-License-Identifier: GPL-3.0-or-later
// Sections of figures: every panel measured, drawn, and with the commands that repeat it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "figures/figures.hpp"

#include "twoscale/kernels/points_io.hpp"
#include "twoscale/reports/curves.hpp"
#include "twoscale/reports/html.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::reports {

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
  std::string s = fmt::format("<tr><td>{}</td><td>{}</td>", escaped(t.scheme.label), v0_html(t.v0));
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

// The picture first, then the runs that were measured.
std::vector<std::string> commands(const Panel& panel, const StartPoints& start) {
  const std::string ends = start.closed                                   ? ""
                           : std::holds_alternative<Samples>(panel.start) ? " --open=given"
                                                                          : " --open=linear";
  const std::string data = " data/" + panel.id + ".csv";
  const auto scheme = [](const Trial& t) {
    return shell_quoted(t.scheme.name) + (t.v0.empty() ? "" : " --v0=" + shell_quoted(t.v0));
  };
  std::string values;  // of one scheme
  for (const Trial& t : panel.trials) {
    if (t.scheme.name != panel.trials[0].scheme.name || t.v0.empty() || t.expect == Expect::impossible) {
      values.clear();
      break;
    }
    values += (values.empty() ? "" : ",") + t.v0;
  }
  const bool sweep = panel.trials.size() > 1 && !values.empty();
  std::vector<std::string> lines;
  lines.push_back(
      (sweep ? "twoscale plot sweep " + shell_quoted(panel.trials[0].scheme.name) + " --values=" + shell_quoted(values)
             : "twoscale plot curve " + scheme(panel.trials[0])) +
      ends + data + " -o " + panel.id + ".svg");
  for (const Trial& t : panel.trials)
    lines.push_back("twoscale refine " + scheme(t) + fmt::format(" --levels {}", measured_levels) + ends + data +
                    " -o curve.csv" + (t.expect == Expect::impossible ? "   # refused, exit status 2" : ""));
  return lines;
}

std::string panel_html(const Panel& panel, Part& part) {
  std::vector<Measured> results;
  const StartPoints start = start_points(panel, panel.trials[0]);
  const auto* samples = std::get_if<Samples>(&panel.start);
  std::string rows;
  for (const Trial& t : panel.trials) {
    const Measured m = measure(panel, t);
    rows += trial_row(panel, t, m);
    if (t.expect == Expect::exact) part.exact_run(m.ran ? m.deviation : INFINITY);
    nlohmann::ordered_json j;
    j["panel"] = panel.id;
    j["scheme"] = t.scheme.name;
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
  std::string detail;
  if (samples != nullptr)
    detail += fmt::format(
        "<br/>{}; {} points from s = {} on, spacing {}{}", escaped(samples->curve.formula), samples->count,
        v0_html(samples->first), v0_html(samples->spacing),
        samples->closed ? ", closed" : fmt::format(", open, {} more samples beyond each end", start.beyond));
  if (!panel.note.empty()) detail += "<br/><em>" + escaped(panel.note) + "</em>";
  detail += "\n<table><thead><tr><th>scheme</th><th>v⁰</th>";
  detail += samples != nullptr ? "<th>points compared</th><th>largest deviation</th>"
                               : "<th>distance to polygon</th><th>turning</th>";
  detail += "</tr></thead><tbody>\n" + rows + "</tbody></table>\n";
  if (samples == nullptr)
    detail += fmt::format("<p class=\"small\">The polygon itself turns by {:.2f}.</p>\n",
                          total_turning(start.values, start.closed));
  return figure(part, {panel.id, panel.title, detail, commands(panel, start)}, picture(panel, results));
}

}  // namespace

std::string v0_html(const std::string& v0) { return v0.empty() ? "–" : "<math>" + mathml(v0) + "</math>"; }

const Panel& panel(const std::vector<Figure>& figures, const std::string& id) {
  for (const Figure& f : figures)
    for (const Panel& p : f.panels)
      if (p.id == id) return p;
  throw std::logic_error("no such panel: " + id);
}

Section figure_section(const Figure& f, const PaperOptions& options) {
  const std::string number = std::to_string(f.number);
  if (options.progress) options.progress("figure " + number);
  Section section{"figure-" + number, "Figure " + number, "Figure " + number + ": " + f.title, {}};
  Part& part = section.part;
  part.numbers = nlohmann::ordered_json::array();
  if (!f.text.empty()) part.html += "<p>" + escaped(f.text) + "</p>\n";
  part.html += "<div class=\"panels\">\n";
  for (const Panel& p : f.panels) part.html += panel_html(p, part);
  part.html += "</div>\n";
  return section;
}

std::vector<std::string> figure_method() {
  return {
      fmt::format("Masks are lowered to correctly rounded doubles; curves are refined in double precision: {} levels "
                  "for the numbers, {} for the pictures.",
                  measured_levels, drawn_levels),
      "<em>Largest deviation</em>: every refined point is compared with the true curve at the same parameter (not "
      "with its nearest point); the largest distance, over the diagonal of the curve’s bounding box.",
      "<em>Distance to polygon</em>: the largest distance of a refined point to the nearest edge, over the diagonal "
      "of the polygon’s bounding box. <em>Turning</em>: the sum of the absolute turning angles in full turns; what "
      "a curve turns more than its polygon is oscillation.",
      "Open curves with a formula: 2l − 2 samples of it beyond each end, so that no end rule is involved."};
}

}  // namespace twoscale::reports
