// SPDX-License-Identifier: GPL-3.0-or-later
// What the parts of the page share, beside document.hpp.
#pragma once

#include <string>
#include <vector>

#include "document.hpp"
#include "twoscale/reports/plot.hpp"
#include "twoscale/reports/romani2009.hpp"
#include "twoscale/symbolic/scheme.hpp"

namespace twoscale::reports::romani2009 {

struct SixPoint {
  const char* name;     // "mixed"
  const char* section;  // "4.1"
  const char* what;
  const char* scheme;
  std::vector<const char*> basic_v0;  // for its basic limit functions
};
const std::vector<SixPoint>& six_point_schemes();

Part scheme_part(const Options& options, Summary& summary);
Part count_part();
Part figure_part(const Options& options, Summary& summary);
// Distance of the limit curve to the polygon of figure 8 over a fine grid of v^0.
Part tension_part();

// ---- Pieces

std::string scheme_label(const std::string& scheme);  // "6-point harmonic"
std::string v0_html(const std::string& v0);           // inline MathML, "-" for none

}  // namespace twoscale::reports::romani2009
