// SPDX-License-Identifier: GPL-3.0-or-later
// The page: its sections in their order.
#include "audit/section.hpp"
#include "hermite2010/sections.hpp"
#include "interactive.hpp"
#include "twoscale/symbolic/catalog.hpp"

namespace twoscale::reports::hermite2010 {

namespace {

Section play_section() {
  Section s{"play", "Try it", "Drag the points, move the tension w", {}};
  s.part.html = interactive_vertices_html(s.part, make_scheme("hermite-circle"),
                                          {"hermite", "hermite-circle", {0, 0, 4, -1, 5, 2, 2, 5, -1, 3}});
  return s;
}

}  // namespace

PaperSummary write_report(const std::string& directory, const PaperOptions& options) {
  make_directory(directory);  // refused before anything is computed
  PaperPage page;
  page.paper = "hermite2010";
  page.about =
      "its interpolant and rules, what is proved of them, the answer to its open question, and its figures. The paper "
      "prints no coordinates: the points are ours.";
  page.method = {
      "Points alone are given; σ is found by Algorithm 1 as docs/hermite.md mends it, p and r are those of the circle "
      "through the points, if there is one, else of the circle through a vertex and its two neighbours.",
      "<em>Distance to polygon</em>: the largest distance of a refined point to the nearest edge, over the diagonal of "
      "the polygon’s bounding box. <em>Curvature</em>: of the circle through three neighbouring points."};
  if (options.progress) options.progress("proofs");
  std::vector<Section> sections{interpolant_section(),    rules_section(),    play_section(),
                                verdict_section(options), question_section(), audit_section(page.paper)};
  for (Section& s : figure_sections(options)) sections.push_back(std::move(s));
  return write_paper_page(directory, page, std::move(sections));
}

}  // namespace twoscale::reports::hermite2010
