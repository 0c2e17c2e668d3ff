// SPDX-License-Identifier: GPL-3.0-or-later
#include "interactive.hpp"

#include <cmath>
#include <cstdlib>

#include "twoscale/kernels/points_io.hpp"
#include "twoscale/lowering/emit.hpp"
#include "twoscale/lowering/refine_hermite.hpp"
#include "twoscale/reports/curves.hpp"
#include "twoscale/reports/html.hpp"

namespace twoscale::reports {

namespace {

using Json = nlohmann::ordered_json;

constexpr int shown_points = 300;  // at the start
constexpr int most_points = 2000;

double number(const ExactReal& x) { return std::strtod(x.decimal(17).c_str(), nullptr); }

// How --at names v^{[0]} of a level parameter.
std::string start_name(const Parameter& p) { return p.name[0] == 'v' ? "v0" + p.name.substr(1) : "v0_" + p.name; }

// Where a slider runs: the domain where it is bounded, otherwise around the value.
void set_range(Json& j, const std::optional<Domain>& domain, double value) {
  const double width = std::max(1.0, std::abs(value));
  j["low"] = domain && domain->low ? number(*domain->low) : value - width;
  j["high"] = domain && domain->high ? number(*domain->high) : value + width;
}

// Values are in the user's spelling, scale*v^{[0]} + offset.
Json level(const Parameter& p, double v0) {
  const bool spelled = p.spelling && !p.spelling->is_identity();
  const double scale = spelled ? number(p.spelling->scale) : 1, offset = spelled ? number(p.spelling->offset) : 0;
  const double value = scale * v0 + offset;
  const std::string name = spelled ? p.spelling->name : start_name(p);
  Json j{{"name", name}, {"label", name}, {"value", value}, {"scale", scale}, {"offset", offset}};
  if (p.frequency && p.frequency->value()) {
    j["fixed"] = true;
    return j;
  }
  if (p.frequency && p.frequency->trigonometric) {
    j["low"] = -0.99 * scale + offset;
    j["high"] = scale + offset;
  } else if (p.domain && (!p.frequency || (p.domain->low && p.domain->high))) {
    set_range(j, p.domain, value);
  }
  return j;
}

Json constant(const Parameter& p, double value) {
  Json j{{"name", p.name}, {"label", p.name}, {"value", value}};
  set_range(j, p.domain, value);
  return j;
}

// Points beyond each end of an open polygon, as refine takes them for this scheme.
kernels::EndPoints beyond_ends(const Scheme& scheme) {
  if (scheme.block > 1) return {};
  if (is_uniform(scheme)) return points_beyond_ends(scheme);
  const Stencil& made = scheme.phases[1];
  const long highest = made.lowest + static_cast<long>(made.blocks.size()) - 1;
  const long reach = std::max(-made.lowest, highest - 1);  // edges on either side of the one that is halved
  return {2 * reach, 2 * reach};
}

Json local(const Parameter& p) {
  Json j{{"name", p.name}, {"label", p.name}, {"offsets", p.offsets}};
  if (p.rest) {
    j["rest"] = number(*p.rest);
    set_range(j, p.domain, number(*p.rest));
  }
  return j;
}

// JSON that may stand in a script of a page.
std::string in_script(const Json& j) {
  std::string s;
  for (const char c : j.dump()) s += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return s;
}

}  // namespace

const std::vector<double>& sample_polygon() {
  static const std::vector<double> polygon = {0, 0, 2, 0.2, 3.2, 1.4, 2.4, 2.8, 1.6, 1.7, 0.6, 3.0, -0.6, 1.6};
  return polygon;
}

bool can_be_interactive(const Scheme& scheme) {
  return scheme.block == 1 && (is_uniform(scheme) || !scheme.kernel.empty());
}

namespace {

std::string drawn(Part& part, const Scheme& scheme, const lowering::Binding& binding, const Interactive& what,
                  const Json& vertices) {
  Json config{{"command", "twoscale refine " + what.name}};
  config["points"] = Json::array();
  for (std::size_t i = 0; i + 1 < what.points.size(); i += 2)
    config["points"].push_back({what.points[i], what.points[i + 1]});
  if (!vertices.empty()) config["vertices"] = vertices;
  const kernels::EndPoints beyond = beyond_ends(scheme);
  config["beyond"] = {beyond.left, beyond.right};
  config["levels"] = config["constants"] = config["locals"] = Json::array();
  for (const Parameter& p : scheme.parameters) switch (p.scope) {
      case Parameter::Scope::level:
        config["levels"].push_back(level(p, number(binding.levels.at(p.name).exact(0))));
        break;
      case Parameter::Scope::constant:
        config["constants"].push_back(constant(p, number(binding.constants.at(p.name))));
        break;
      case Parameter::Scope::local:
        if (vertices.empty()) config["locals"].push_back(local(p));
        break;
    }
  const auto levels_for = [&](int count) {
    return std::max(
        1, static_cast<int>(std::log(2.0 * count / static_cast<double>(what.points.size())) / std::log(scheme.arity)));
  };
  config["refinements"] = levels_for(shown_points);
  config["mostRefinements"] = levels_for(most_points);
  part.interactive = true;
  const std::string& id = what.id;
  std::string object;
  for (const char* member : {"arity", "lowest", "size", "start", "next", "mask"})
    object += std::string(member) + ": " + id + "_" + member + ", ";
  const kernels::Shift shift = kernels::parse_shift(scheme.shift.to_string());
  object += "shift: [" + std::to_string(shift.num) + ", " + std::to_string(shift.den) + "]";
  return "<div class=\"interactive\" id=\"" + id +
         "\"><p>Here a curve can be drawn and changed when scripts may run.</p></div>\n" +
         script(lowering::emit_evaluator(scheme, lowering::Language::javascript, {id, {}})) +
         script("document.addEventListener(\"DOMContentLoaded\", () => interactiveCurve(document.getElementById(\"" +
                id + "\"),\n  {" + object + "},\n  " + in_script(config) + "));\n") +
         "<p class=\"small\">Drag the points, or move them with the arrow keys; " +
         (vertices.empty() ? "a double click on an edge (or beyond an open end) adds a point, on a point removes it"
                           : "the derivatives at the points and their σ stay") +
         ". The curve is computed in this page, in double precision, by the evaluator that <code>twoscale table " +
         escaped(what.name) + " --evaluator --format javascript</code> prints.</p>\n";
}

}  // namespace

std::string interactive_html(Part& part, const Scheme& scheme, const lowering::Binding& binding,
                             const Interactive& what) {
  return drawn(part, scheme, binding, what, Json::array());
}

std::string interactive_vertices_html(Part& part, const Scheme& scheme, const Interactive& what) {
  kernels::PointSet points;
  points.columns = kernels::default_columns(2);
  points.dim = 2;
  points.values = what.points;
  const kernels::PointSet found =
      lowering::refine_hermite(scheme, std::nullopt, points, {0, true, 0, true}).points;  // f, p, r, sigma
  Json vertices = Json::array();
  for (std::size_t j = 0; j < found.size(); ++j) {
    const double* v = &found.values[j * found.dim];
    vertices.push_back({{"p", {v[2], v[3]}}, {"r", {v[4], v[5]}}, {"sigma", v[6]}});
  }
  return drawn(part, scheme, lowering::bind(scheme, std::nullopt, std::nullopt, {}), what, vertices);
}

}  // namespace twoscale::reports
