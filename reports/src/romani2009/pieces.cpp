// SPDX-License-Identifier: GPL-3.0-or-later
#include "page.hpp"
#include "twoscale/reports/html.hpp"

namespace twoscale::reports::romani2009 {

const std::vector<SixPoint>& six_point_schemes() {
  static const std::vector<SixPoint> list = {
      {"mixed", "4.1", "conics and cubics", "interpolating:family=mixed,l=3", {"-1/2", "1/2", "1", "10"}},
      {"harmonic", "4.2", "second-order curves", "interpolating:family=harmonic,l=3", {"-1/4", "1/2", "1", "10"}},
      {"resonant", "4.3", "spirals", "interpolating:family=resonant,l=3", {"-1/2", "1/2", "1", "10"}}};
  return list;
}

std::string scheme_label(const std::string& scheme) {
  if (scheme == "tension4") return "4-point, tension";
  if (scheme == "dd:l=2") return "Dubuc–Deslauriers 4-point";
  if (scheme == "dd:l=3") return "Weissmann 6-point";
  for (const SixPoint& s : six_point_schemes())
    if (scheme == s.scheme) return std::string("6-point ") + s.name;
  if (scheme == "interpolating:family=harmonic,l=4") return "8-point harmonic";
  return "6-point lacunary";
}

std::string v0_html(const std::string& v0) { return v0.empty() ? "–" : "<math>" + mathml(v0) + "</math>"; }

}  // namespace twoscale::reports::romani2009
