// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of jeong2013 computed again: curves of the quasi-splines with tension (figures 1, 2, 4, 5, 8, 9),
// surfaces from two independently parametrised schemes (figures 6 and 7).
//
// Where the paper prints no control points (all figures but 6) they are ours, and the page says so; parameters and
// parametrisations are the paper's.
#pragma once

#include <string>
#include <vector>

#include "twoscale/lowering/parametric_surface.hpp"
#include "twoscale/reports/papers.hpp"

namespace twoscale::reports::jeong2013 {

// The fourth-order forms of section 6 for a frequency lambda_2 given by v^0 = cosh(lambda_2): affine in t.
enum class TensionForm {
  spline,   // (26): t = 0 the cubic exponential B-spline of {1, x, exp(+-lambda_2 x)}, t = 1 the 4-point scheme
  polygon,  // (27)-(28): t = 0 the polygon itself, t = 1 the same 4-point scheme
};
// Its name in the catalogue; t is an exact number as text.
std::string tension_name(TensionForm form, const std::string& t);

// A surface of figure 6 with the samples of the paper.
struct Surface {
  std::string id;     // "6c"
  std::string title;  // "Figure-8 Klein bottle"
  std::vector<std::string> formulas;
  std::string u_step, v_first, v_step;
  long u_count, v_count;
  bool v_closed;
  std::string note;
  long drawn_rows;  // rows of the refined grid that are drawn, in samples: one-sided surfaces are covered twice
  std::string u_least_step, v_least_step;  // for the least numbers of samples; v empty when open
};
const std::vector<Surface>& surfaces();
lowering::ParametricSurface parametric(const Surface& surface);

PaperSummary write_report(const std::string& directory, const PaperOptions& options);

}  // namespace twoscale::reports::jeong2013
