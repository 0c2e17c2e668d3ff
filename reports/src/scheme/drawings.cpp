// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures: basic limit function, its derivatives as difference quotients, a curve, and both along a parameter.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "interactive.hpp"
#include "sections.hpp"
#include "twoscale/analysis/regularity.hpp"
#include "twoscale/kernels/points_io.hpp"
#include "twoscale/reports/curves.hpp"
#include "twoscale/reports/html.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::reports::scheme_page {

namespace {

// As many levels as give a smooth picture.
int levels_for(int arity, double points) {
  int k = 1;
  while (std::pow(arity, k) < points) ++k;
  return k;
}

Line limit_line(const Subject& s, const lowering::Binding& binding, const std::string& title, int colour) {
  const int levels = levels_for(s.scheme.arity, 48);
  return curve_line(refine_points(s.scheme, binding, sample_polygon(), 2, levels, kernels::Boundary::closed).values,
                    true, title, colour);
}

// The difference quotient of a function given by points at equal distances, at the middles between them.
std::vector<double> differentiated(const std::vector<double>& points) {
  std::vector<double> d;
  for (size_t j = 0; j + 3 < points.size(); j += 2)
    d.insert(d.end(), {(points[j] + points[j + 2]) / 2, (points[j + 3] - points[j + 1]) / (points[j + 2] - points[j])});
  return d;
}

// Values of one parameter to compare: spread over a bounded domain, or around the default.
struct Sweep {
  std::string name;
  std::vector<std::string> values;
};

std::optional<Sweep> sweep_of(const Scheme& scheme) {
  for (const auto& p : scheme.parameters) {
    if (p.frequency && p.frequency->value()) continue;  // a fixed frequency
    Sweep s;
    s.name = p.spelling ? p.spelling->name : p.name;
    const auto default_value = p.default_value.empty() ? std::nullopt : parse_real(p.default_value).rational();
    if (p.domain && p.domain->low && p.domain->high) {
      for (long i = 1; i <= 5; ++i)
        s.values.push_back((*p.domain->low + (*p.domain->high - *p.domain->low) * Rational(i, 6)).to_string());
    } else if (p.frequency && (!p.spelling || p.spelling->is_identity())) {
      if (!p.spelling) s.name = "v0" + p.name.substr(1);
      s.values = {"-1/2", "1/2", "1", "2", "10"};
    } else if (default_value && !default_value->is_zero()) {
      for (const Rational& factor : {Rational(0), Rational(1, 2), Rational(1), Rational(3, 2), Rational(2)})
        s.values.push_back((*default_value * factor).to_string());
    } else {
      continue;
    }
    return s;
  }
  return std::nullopt;
}

// The binding of the subject with another value of one parameter; nothing where the scheme does not exist there.
std::optional<lowering::Binding> binding_at(const Subject& s, const std::string& name, const std::string& value) {
  std::vector<std::pair<std::string, std::string>> at;
  for (const auto& [other, text] : s.binding.description)
    if (other != name && !(name.starts_with("v0") && (other == "v0" || other == "t"))) at.emplace_back(other, text);
  at.emplace_back(name, value);
  try {
    lowering::Binding b = lowering::bind(s.scheme, std::nullopt, std::nullopt, at);
    lowering::lower(s.scheme, b, {1, 0, false, false});
    return b;
  } catch (const Error& e) {
    if (e.kind == Error::Kind::io) throw;
    return std::nullopt;
  }
}

std::string picture_html(Part& part, const std::string& name, const std::string& title, const Picture& picture,
                         const std::string& line) {
  return figure(part, {name, title, "", line.empty() ? std::vector<std::string>{} : std::vector{line}, false}, picture);
}

Picture graph(std::vector<Line> lines) {
  Picture p;
  p.equal_axes = false;
  p.height = 320;
  p.x_label = "parameter";
  p.lines = std::move(lines);
  return p;
}

}  // namespace

Part play(const Subject& s) {
  Part part;
  if (can_be_interactive(s.scheme))
    part.html = interactive_html(part, s.scheme, s.binding, {"curve", s.name, sample_polygon()});
  return part;
}

Part pictures(const Subject& s) {
  Part part;
  part.html = "<div class=\"panels\">\n";
  const int levels = levels_for(s.scheme.arity, 96);
  Line basic;
  basic.values = basic_limit_function(s.scheme, s.binding, levels).values;
  part.html +=
      picture_html(part, "basic", "Basic limit function", graph({basic}),
                   "twoscale plot basic " + s.name + s.values + fmt::format(" --levels {} -o basic.svg", levels));

  long continuity = 0;
  if (s.all_fixed) {
    analysis::RegularityOptions options;
    options.jsr.seconds = 2;
    options.jsr.width = Rational(1, 100);
    try {
      continuity = analysis::regularity(s.fixed, options).continuity;
    } catch (const Error& e) {
      if (e.kind == Error::Kind::io) throw;
    }
  }
  std::vector<double> derivative = basic.values;
  for (long order = 1; order <= std::min(continuity, 2L); ++order) {
    derivative = differentiated(derivative);
    Line l;
    l.values = derivative;
    l.colour = static_cast<int>(order);
    part.html += picture_html(part, "derivative-" + std::to_string(order),
                              order == 1 ? "Its first derivative" : "Its second derivative", graph({l}), "");
  }

  kernels::PointSet points;
  points.columns = kernels::default_columns(2);
  points.dim = 2;
  points.values = sample_polygon();
  part.files.emplace_back("data/polygon.csv", kernels::to_csv(points));
  Picture curve;
  curve.lines = {polygon_line(sample_polygon(), true), limit_line(s, s.binding, "limit curve", 0)};
  part.html += picture_html(part, "curve", "A closed curve", curve,
                            "twoscale plot curve " + s.name + s.values + " data/polygon.csv -o curve.svg");
  part.numbers = {{"continuity_drawn", continuity}};
  if (const auto sweep = sweep_of(s.scheme)) {
    Picture basics = graph({});
    Picture curves;
    curves.lines.push_back(polygon_line(sample_polygon(), true));
    int colour = 0;
    nlohmann::ordered_json drawn = nlohmann::ordered_json::array();
    for (const auto& value : sweep->values) {
      const auto binding = binding_at(s, sweep->name, value);
      if (!binding) continue;
      Line l;
      l.values = basic_limit_function(s.scheme, *binding, levels).values;
      l.title = sweep->name + " = " + value;
      l.colour = colour;
      basics.lines.push_back(std::move(l));
      curves.lines.push_back(limit_line(s, *binding, sweep->name + " = " + value, colour++));
      drawn.push_back(value);
    }
    if (!basics.lines.empty()) {
      part.html += picture_html(part, "sweep-basic", "Basic limit functions along " + sweep->name, basics, "");
      const bool v0 = sweep->name == "v0";
      std::string list;
      for (const auto& v : drawn) list += (list.empty() ? "" : ",") + v.get<std::string>();
      part.html += picture_html(
          part, "sweep-curve", "Curves along " + sweep->name, curves,
          v0 ? "twoscale plot sweep " + s.name + " --values=" + list + " data/polygon.csv -o sweep.svg" : "");
      part.numbers["sweep"] = {{"name", sweep->name}, {"values", drawn}};
    }
  }
  part.html += "</div>\n";
  return part;
}

}  // namespace twoscale::reports::scheme_page
