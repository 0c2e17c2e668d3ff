// SPDX-License-Identifier: GPL-3.0-or-later
// Corollary 13, measured.
#include <fmt/format.h>

#include <algorithm>

#include "figures/tension.hpp"
#include "sections.hpp"
#include "twoscale/symbolic/catalog.hpp"

namespace twoscale::reports::romani2009 {

Section tension_section() {
  Section section{"tension", "Tension", "Figures 8–10: is a greater v⁰ always closer to the polygon?", {}};
  Part& part = section.part;
  const Polygon& polygon = std::get<Polygon>(panel(figures(), "8").start);
  std::vector<NamedScheme> schemes;
  for (const SixPoint& s : six_point_schemes())
    schemes.push_back({s.scheme, std::string("section ") + s.section + ", " + s.name});
  const TensionSweep sweep = tension_sweep(part, schemes, polygon);
  bool monotone = true;
  double last_rise = -1;
  for (const TensionCourse& c : sweep.courses) {
    monotone = monotone && c.monotone;
    last_rise = std::max(last_rise, c.last_rise);
  }
  const double mixed_end = sweep.courses[0].at_end;
  const double four_point = distance_to_polygon(make_scheme("dd:l=2"), "", polygon);
  part.html =
      "<p>Corollary 13 says so. Measured on the polygon above, for 107 values of v⁰ from −0.95 to 9999: the largest "
      "distance of a point of the limit curve to the polygon, over the diagonal of the polygon’s box. The gaps are "
      "singular values of the harmonic scheme and their surroundings.</p>\n" +
      sweep.html +
      fmt::format(
          "<p>As v⁰ → ∞ the harmonic and resonant rules tend to the midpoint of the edge (ζ₀, ζ₂ → 0, ζ₄ → 1/2), the "
          "mixed rule tends to the 4-point Dubuc–Deslauriers rule (−1/16, 9/16), whose limit curve has the distance "
          "{}: the scheme of section 4.1 never reaches the polygon.</p>\n",
          number_text(four_point));
  const std::string verdict =
      monotone ? std::string("the measured distances agree.")
               : fmt::format(
                     "<a href=\"#tension\">measured</a> on one polygon, this is not so on (−1, ∞); from v⁰ ≈ {} "
                     "on all three distances fall.",
                     v0_text(last_rise));
  part.findings.push_back(fmt::format(
      "Corollary 13 (the greater v⁰, the closer to the polygon): {} The scheme of section 4.1 does not come "
      "to the polygon but to the 4-point Dubuc–Deslauriers curve (distance {} at v⁰ = 9999, {} in the "
      "limit).",
      verdict, number_text(mixed_end), number_text(four_point)));
  return section;
}

}  // namespace twoscale::reports::romani2009
