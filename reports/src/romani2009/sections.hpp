// SPDX-License-Identifier: GPL-3.0-or-later
// What the sections of the page share.
#pragma once

#include <string>
#include <vector>

#include "figures/figures.hpp"
#include "twoscale/reports/romani2009.hpp"

namespace twoscale::reports::romani2009 {

struct SixPoint {
  const char* name;     // "mixed"
  const char* section;  // "4.1"
  const char* what;
  const char* scheme;
  std::vector<std::string> basic_v0;  // for its basic limit functions
};
const std::vector<SixPoint>& six_point_schemes();

// The schemes of which it is asked from how many points a closed curve can start.
const std::vector<NamedScheme>& closed_curve_schemes();

Section scheme_section(const PaperOptions& options);
Section count_section();
// Distance of the limit curve to the polygon of figure 8 over a fine grid of v^0.
Section tension_section();

}  // namespace twoscale::reports::romani2009
