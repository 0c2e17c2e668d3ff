// SPDX-License-Identifier: GPL-3.0-or-later
// Runs panels and measures.
#include <cstdlib>

#include "twoscale/reports/curves.hpp"
#include "twoscale/reports/figures.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::reports {

namespace {

// The exact expression rounded to double (20 correct digits read back).
double number(const std::string& expression) {
  return std::strtod(parse_real(expression).decimal(20).c_str(), nullptr);
}

kernels::Boundary boundary_of(const Panel& panel) {
  if (const auto* polygon = std::get_if<Polygon>(&panel.start))
    return polygon->closed ? kernels::Boundary::closed : kernels::Boundary::linear;
  return std::get<Samples>(panel.start).closed ? kernels::Boundary::closed : kernels::Boundary::given;
}

}  // namespace

StartPoints start_points(const Panel& panel, const Trial& trial) {
  if (const auto* polygon = std::get_if<Polygon>(&panel.start)) return {polygon->vertices, 2, polygon->closed, 0};
  const auto& s = std::get<Samples>(panel.start);
  StartPoints r{{}, s.curve.dim, s.closed, 0};
  if (!s.closed) r.beyond = static_cast<std::size_t>(points_beyond_ends(make_scheme(trial.scheme.name)).left);
  const double first = number(s.first);
  const double spacing = number(s.spacing);
  const auto beyond = static_cast<int>(r.beyond);
  for (int j = -beyond; j < s.count + beyond; ++j) {
    double p[3];
    s.curve.at(first + j * spacing, p);
    r.values.insert(r.values.end(), p, p + s.curve.dim);
  }
  return r;
}

Measured measure(const Panel& panel, const Trial& trial, int levels) {
  Measured m;
  const Scheme scheme = make_scheme(trial.scheme.name);
  const StartPoints start = start_points(panel, trial);
  const kernels::Boundary boundary = boundary_of(panel);
  Refined fine;
  try {
    const auto v0 = trial.v0.empty() ? std::optional<std::string>() : trial.v0;
    const lowering::Binding binding = lowering::bind(scheme, v0, std::nullopt, {});
    fine = refine_points(scheme, binding, start.values, start.dim, levels, boundary);
    m.curve = refine_points(scheme, binding, start.values, start.dim, drawn_levels, boundary).values;
  } catch (const Error& e) {
    if (e.kind != Error::Kind::bad_input) throw;
    m.refusal = e.what();
    return m;
  }
  m.ran = true;
  m.points = fine.size();
  if (const auto* s = std::get_if<Samples>(&panel.start)) {
    const double first = number(s->first);
    const double spacing = number(s->spacing);
    m.deviation = largest_deviation(fine, [&](double t, double* p) { s->curve.at(first + t * spacing, p); });
  } else {
    m.polygon_distance = distance_to_polygon(fine, start.values, start.closed);
    m.turning = total_turning(fine.values, start.closed);
  }
  return m;
}

}  // namespace twoscale::reports
