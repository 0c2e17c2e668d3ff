// SPDX-License-Identifier: GPL-3.0-or-later
#include "audit/section.hpp"
#include "interactive.hpp"
#include "sections.hpp"
#include "twoscale/symbolic/catalog.hpp"

namespace twoscale::reports::jeong2013 {

namespace {

Section play_section() {
  Section s{"play", "Try it", "Tension form (26): drag the points, move λ₂ and t", {}};
  const Scheme scheme = make_scheme(tension_name(TensionForm::spline, "w"));
  s.part.html =
      "<p>w is the t of the paper: 0 the exponential B-spline, 1 the 4-point interpolating scheme; v0 = cosh "
      "λ₂.</p>\n" +
      interactive_html(s.part, scheme, lowering::bind(scheme, "cosh(1)", std::nullopt, {{"w", "1/4"}}),
                       {"tension", shell_quoted(scheme.id), sample_polygon()});
  return s;
}

}  // namespace

PaperSummary write_report(const std::string& directory, const PaperOptions& options) {
  make_directory(directory);  // refused before anything is computed
  PaperPage page;
  page.paper = "jeong2013";
  page.about = "the curves and surfaces of its figures, with what was measured on them.";
  page.method = {
      "Masks are exact expressions, lowered to correctly rounded doubles; points are refined in double precision.",
      "<em>Largest deviation</em>: every refined point of a surface is compared with the surface at the same "
      "parameters; the largest distance, over the diagonal of the surface’s bounding box.",
      "<em>Samples determine</em>: n samples of a closed direction suffice for the interpolating scheme exactly when "
      "no "
      "sum and no difference of two of its numbers of turns (0 among them) is a multiple of n other than 0.",
      "<em>Distance to polygon</em>: the largest distance of a refined point to the nearest edge, over the diagonal of "
      "the polygon’s bounding box. <em>Turning</em>: the sum of the absolute turning angles in full turns.",
      "Control points are the paper’s for figure 6 only; it prints no others."};
  std::vector<Section> sections{audit_section(page.paper), play_section()};
  for (const auto make : {first_curves, surface_sections, last_curves})
    for (Section& s : make(options)) sections.push_back(std::move(s));
  return write_paper_page(directory, page, std::move(sections));
}

}  // namespace twoscale::reports::jeong2013
