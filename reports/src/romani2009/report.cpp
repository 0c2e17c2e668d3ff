// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "audit/section.hpp"
#include "sections.hpp"
#include "twoscale/kernels/points_io.hpp"
#include "twoscale/lowering/fit.hpp"
#include "twoscale/symbolic/catalog.hpp"

namespace twoscale::reports::romani2009 {

namespace {

// What the 4-point scheme and a wrong v^0 give away.
std::vector<std::string> findings() {
  std::vector<std::string> list;
  const Panel& cardioid = panel(figures(), "1a");
  const Panel& astroid = panel(figures(), "1c");
  list.push_back(
      fmt::format("Figure 1: the 4-point scheme misses the cardioid by {} and the astroid by {} of the curve’s size. "
                  "From the paper’s 6 points "
                  "no scheme can return the astroid, because sin 3s vanishes at all of them; 5 or 7 points suffice (<a "
                  "href=\"#counts\">table</a>).",
                  number_text(measure(cardioid, cardioid.trials[0]).deviation),
                  number_text(measure(astroid, astroid.trials[0]).deviation)));
  const Panel& viviani = panel(figures(), "7b2");
  const StartPoints start = start_points(viviani, viviani.trials[0]);
  kernels::PointSet samples;
  samples.columns = kernels::default_columns(start.dim);
  samples.dim = start.dim;
  samples.values = start.values;
  const lowering::Fit fit = lowering::fit(*make_scheme(viviani.trials[0].scheme.name).space, samples, start.closed);
  list.push_back(
      fmt::format("Figure 7b: Viviani’s curve has the base frequency 1/2. The fit to 10 samples at spacing 2π/5 finds "
                  "v⁰ = {}, which is cos(π/5): "
                  "deviation {}. With v⁰ = cos(2π/5) it is {}; that value belongs to 5 samples at spacing 4π/5.",
                  fit.v0.empty() ? "nothing" : fit.v0, number_text(measure(viviani, viviani.trials[0]).deviation),
                  number_text(measure(viviani, viviani.trials[1]).deviation)));
  return list;
}

}  // namespace

PaperSummary write_report(const std::string& directory, const PaperOptions& options) {
  make_directory(directory);  // refused before anything is computed
  PaperPage page;
  page.paper = "romani2009";
  page.about =
      "the three 6-point schemes derived from their spaces, proved, and run on the paper’s twelve figures. Each "
      "picture "
      "comes with what was measured on it.";
  page.method = {
      "Formulas and verdicts are exact, for all levels at once. A verdict comes with a certificate; the checker that "
      "re-verifies it shares no code and no computer algebra with the prover."};
  for (const auto& item : figure_method()) page.method.push_back(item);
  std::vector<Section> sections;
  sections.push_back(scheme_section(options));
  sections.push_back(audit_section(page.paper));
  sections.push_back(count_section());
  for (const Figure& f : figures()) {
    sections.push_back(figure_section(f, options));
    if (f.number == 1) sections.back().part.findings = findings();
    if (f.number == 10) sections.push_back(tension_section());
  }
  return write_paper_page(directory, page, std::move(sections));
}

}  // namespace twoscale::reports::romani2009
