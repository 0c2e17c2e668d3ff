// SPDX-License-Identifier: GPL-3.0-or-later
// What the sections of the page share, beside page.hpp.
#pragma once

#include <string>
#include <vector>

#include "page.hpp"
#include "twoscale/kernels/points_io.hpp"
#include "twoscale/reports/hermite2010.hpp"

namespace twoscale::reports::hermite2010 {

// A polygon in the plane.
struct Polygon {
  const char* name;  // data/NAME.csv
  bool closed;
  std::vector<double> values;
  kernels::PointSet points() const;
};

// x, y of the vertices after `levels` steps; `scheme` is a name of the catalogue.
std::vector<double> refined(const std::string& scheme, const Polygon& polygon, unsigned levels);
// x, y, p, r and sigma of the vertices.
kernels::PointSet refined_jets(const std::string& scheme, const Polygon& polygon, unsigned levels);

Section interpolant_section();
Section rules_section();
Section verdict_section(const PaperOptions& options);
Section question_section();
std::vector<Section> figure_sections(const PaperOptions& options);

}  // namespace twoscale::reports::hermite2010
