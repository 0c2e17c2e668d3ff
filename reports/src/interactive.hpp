// SPDX-License-Identifier: GPL-3.0-or-later
// A scheme that a reader plays with: control points to drag, a slider for every parameter, the limit curve with its
// comb. The page computes it by assets/curve.js from the emitted JavaScript evaluator of the scheme.
#pragma once

#include <string>
#include <vector>

#include "document.hpp"
#include "twoscale/lowering/lower.hpp"

namespace twoscale::reports {

struct Interactive {
  std::string id;              // an identifier, unique on the page: of the element, and before the evaluator's names
  std::string name;            // of the scheme, quoted for a shell
  std::vector<double> points;  // x, y of a polygon, closed at first
};

// A closed polygon with short and long edges, a reflex vertex and an acute one.
const std::vector<double>& sample_polygon();

// Can be drawn so: scalar, with or without knots.
bool can_be_interactive(const Scheme& scheme);
// Required: can_be_interactive. The sliders start at the values of the binding.
std::string interactive_html(Part& part, const Scheme& scheme, const lowering::Binding& binding,
                             const Interactive& what);

// The same for a scheme on vertices with derivatives (hermite2010): p, r and sigma are found from the points, and stay.
std::string interactive_vertices_html(Part& part, const Scheme& scheme, const Interactive& what);

}  // namespace twoscale::reports
