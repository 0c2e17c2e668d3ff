// SPDX-License-Identifier: GPL-3.0-or-later
// The page about a scheme whose vertices carry derivatives: its rules entry by entry, smoothness, the spectrum of the
// mask for small steps, curves.
#include <fmt/format.h>

#include <algorithm>

#include "interactive.hpp"
#include "sections.hpp"
#include "twoscale/analysis/hermite.hpp"
#include "twoscale/analysis/prove.hpp"
#include "twoscale/kernels/error.hpp"
#include "twoscale/kernels/points_io.hpp"
#include "twoscale/lowering/refine_hermite.hpp"
#include "twoscale/reports/curves.hpp"
#include "twoscale/reports/html.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"
#include "twoscale/symbolic/hermite_circle.hpp"

namespace twoscale::reports::scheme_page {

using analysis::Verdict;

namespace {

constexpr unsigned drawn_levels = 6;
constexpr std::size_t longest_shown = 30000;  // bytes of a formula that is not folded

// f, f', f'', f^(3), ..
std::string derivative(std::size_t order) {
  if (order == 0) return "<mi>f</mi>";
  if (order <= 2) return std::string("<mrow><mi>f</mi><mo>") + (order == 1 ? "′" : "″") + "</mo></mrow>";
  return fmt::format("<msup><mi>f</mi><mrow><mo>(</mo><mn>{}</mn><mo>)</mo></mrow></msup>", order);
}

std::string at_vertex(std::size_t order, const std::string& index, const char* level) {
  return "<msubsup>" + derivative(order) + "<mrow>" + index + "</mrow>" + level + "</msubsup>";
}

std::string coarse_index(long offset) {
  if (offset == 0) return "<mi>j</mi>";
  return fmt::format("<mi>j</mi><mo>{}</mo><mn>{}</mn>", offset > 0 ? "+" : "−", std::abs(offset));
}

std::string new_value(const Scheme& s, std::size_t phase, std::size_t row) {
  std::string index = fmt::format("<mn>{}</mn><mi>j</mi>", s.arity);
  if (phase > 0) index += fmt::format("<mo>+</mo><mn>{}</mn>", phase);
  return at_vertex(row, index, "<mrow><mi>k</mi><mo>+</mo><mn>1</mn></mrow>");
}

std::string row_name(const Scheme& s, std::size_t phase, std::size_t row) {
  return "<math>" + new_value(s, phase, row) + "</math>, a long formula";
}

std::string row_formula(const Scheme& s, std::size_t phase, std::size_t row) {
  const auto block = static_cast<std::size_t>(s.block);
  const Stencil& stencil = s.phases[phase];
  std::string sum;
  for (std::size_t column = 0; column < block; ++column)
    for (std::size_t i = 0; i < stencil.blocks.size(); ++i) {
      const RationalFunction& c = stencil.blocks[i][row * block + column];
      if (c.is_zero()) continue;
      const std::string weight = c.is_one() ? ""
                                            : "<mrow><mo stretchy=\"false\">(</mo>" + mathml(c.to_string()) +
                                                  "<mo stretchy=\"false\">)</mo></mrow>";
      sum += (sum.empty() ? "" : "<mo>+</mo>") + weight +
             at_vertex(column, coarse_index(stencil.lowest + static_cast<long>(i)), "<mi>k</mi>");
    }
  std::string index = fmt::format("<mn>{}</mn><mi>j</mi>", s.arity);
  if (phase > 0) index += fmt::format("<mo>+</mo><mn>{}</mn>", phase);
  return "<div class=\"wide\"><p><math><mrow>" + at_vertex(row, index, "<mrow><mi>k</mi><mo>+</mo><mn>1</mn></mrow>") +
         "<mo>=</mo>" + (sum.empty() ? "<mn>0</mn>" : sum) + "</mrow></math></p></div>\n";
}

std::string row_of_table(const std::string& head, const std::string& cell) {
  return "<tr><th>" + head + "</th><td>" + cell + "</td></tr>\n";
}

}  // namespace

Part definition_on_vertices(const Subject& s) {
  Part part;
  const auto block = static_cast<std::size_t>(s.scheme.block);
  part.html = fmt::format("<p>Arity {}; every vertex carries a value and {} derivative{}.</p>\n", s.scheme.arity,
                          block - 1, block == 2 ? "" : "s");
  std::string values;
  for (const auto& p : s.scheme.parameters)
    if (p.scope == Parameter::Scope::constant && !p.default_value.empty())
      values += (values.empty() ? "" : ", ") + p.name + " = " + p.default_value;
  if (!values.empty()) part.html += "<p>For " + prose(values) + ":</p>\n";
  const Scheme shown = with_default_values(s.scheme);
  for (std::size_t phase = 0; phase < shown.phases.size(); ++phase)
    for (std::size_t row = 0; row < block; ++row) {
      const std::string formula = row_formula(shown, phase, row);
      part.html += formula.size() <= longest_shown
                       ? formula
                       : "<details><summary>" + row_name(shown, phase, row) + "</summary>\n" + formula + "</details>\n";
    }
  part.html += commands_html({"twoscale show " + s.name});
  part.numbers = {{"arity", s.scheme.arity}, {"block", block}};
  return part;
}

Part smoothness_on_vertices(const Subject& s) {
  Part part;
  const analysis::Proof proof =
      analysis::prove(s.scheme, {{"continuity", "2", ""}, {"continuity", "1", ""}, {"curvature", "", ""}});
  const auto proved = [&](std::size_t i) { return proof.decisions[i].verdict == Verdict::proved; };
  if (!proved(0) && !proved(1)) {
    part.html = "<p>Smoothness is not decided: " + prose(proof.decisions[0].witness) + ".</p>\n";
    part.numbers = nullptr;
    return part;
  }
  const int continuity = proved(0) ? 2 : 1;
  part.numbers = {{"continuity", continuity}, {"geometric", proved(2) ? nlohmann::ordered_json(2) : nullptr}};
  part.html = "<table class=\"narrow\"><tbody>\n" +
              row_of_table("continuity", fmt::format("<math><msup><mi>C</mi><mn>{}</mn></msup></math> {}", continuity,
                                                     prose(proof.decisions[proved(0) ? 0 : 1].domain)));
  if (!proved(0)) {
    const auto& d = proof.decisions[0];
    part.html +=
        row_of_table(d.verdict == Verdict::refuted ? "not C<sup>2</sup>" : "C<sup>2</sup> undecided", prose(d.witness));
  }
  if (proved(2))
    part.html += row_of_table(
        "curvature", "continuous (<math><msup><mi>G</mi><mn>2</mn></msup></math>) " + prose(proof.decisions[2].domain));
  part.html += "</tbody></table>\n";
  std::vector<std::string> lines = {"twoscale regularity " + s.name};
  if (!proof.certificate.empty()) {
    part.html += certificate_html(part, s.prefix + "smoothness", proof.certificate, s.options.checker);
    lines[0] += " --certificate certificates/" + s.prefix + "smoothness.json";
    lines.push_back("twoscale-check certificates/" + s.prefix + "smoothness.json");
  }
  part.html += commands_html(lines);
  return part;
}

Part spectrum_on_vertices(const Subject& s) {
  Part part;
  try {
    const analysis::HermiteMask mask = analysis::hermite_mask(s.scheme);
    const analysis::SpectralCondition condition = analysis::spectral_condition(mask);
    const bool scaled = condition.scales.size() == mask.block;
    const analysis::Spectrum found = analysis::spectrum(
        analysis::local_matrix(scaled ? analysis::rescaled(mask, condition.scales) : mask), mask.arity);
    part.html =
        "<p>The rules " +
        std::string(mask.parameter.empty() ? "" : "for small steps, what they tend to at one place, ") +
        (condition.order < 0 ? "do not keep constants.</p>\n"
                             : fmt::format("satisfy the spectral condition of order {}{}{}.</p>\n", condition.order,
                                           condition.order == condition.searched ? " at least" : "",
                                           condition.reproduces ? ": polynomials of this degree are reproduced" : ""));
    if (scaled) {
      std::string rows;
      for (std::size_t k = 1; k < condition.scales.size(); ++k)
        rows += row_of_table(fmt::format("derivative {}", k), formula("", condition.scales[k].to_string()));
      part.html += "<p>The derivatives that a vertex carries are those of the limit" +
                   (mask.parameter.empty() ? "" : " in " + mask.parameter) +
                   ", times</p>\n<table class=\"narrow\"><tbody>\n" + rows + "</tbody></table>\n";
    }
    part.html += eigenvalue_table(part, found) + commands_html({"twoscale spectrum " + s.name});
  } catch (const Error& e) {
    if (e.kind == Error::Kind::io) throw;
    part.html = "<p>" + prose(e.what()) + "</p>\n";
    part.numbers = nullptr;
  }
  return part;
}

Part pictures_on_vertices(const Subject& s) {
  Part part;
  if (!hermite_tension(s.scheme)) return part;
  kernels::PointSet points;
  points.columns = kernels::default_columns(2);
  points.dim = 2;
  points.values = sample_polygon();
  points.closed = true;
  const auto refined = [&](const std::optional<ExactReal>& w) -> std::optional<std::vector<double>> {
    try {
      return lowering::refine_hermite(s.scheme, w, points, {drawn_levels, true, 0, false}).points.values;
    } catch (const kernels::Error& e) {  // w beyond the first pole of these points
      if (e.kind != kernels::Error::Kind::bad_input) throw;
      return std::nullopt;
    }
  };
  const Line polygon = polygon_line(points.values, true);
  part.files.emplace_back("data/polygon.csv", kernels::to_csv(points));
  part.html = "<div class=\"panels\">\n";
  const auto add = [&](const char* name, const char* title, std::vector<Line> lines, const std::string& line) {
    Picture picture;
    picture.lines = std::move(lines);
    part.html += figure(part, {name, title, "", {line}, false}, picture);
  };
  if (const auto curve = refined(std::nullopt)) {
    add("curve", "A closed curve", {polygon, curve_line(*curve, true, "limit curve", 0)},
        "twoscale plot curve " + s.name + " data/polygon.csv -o curve.svg");
    std::vector<Line> comb = curvature_comb(*curve, true);
    comb.push_back(curve_line(*curve, true, "limit curve", 0));
    add("comb", "Its curvature", std::move(comb), "twoscale plot comb " + s.name + " data/polygon.csv -o comb.svg");
  } else {
    part.html += "<p>Its tension is beyond the first pole of the sample points.</p>\n";
  }
  std::vector<Line> sweep = {polygon};
  std::string values;
  for (const char* w : {"1/2", "1", "3/2"})
    if (auto curve = refined(parse_real(w))) {
      values += (values.empty() ? "" : ",") + std::string(w);
      sweep.push_back(curve_line(*std::move(curve), true, "w = " + std::string(w), static_cast<int>(sweep.size()) - 1));
    }
  add("sweep", "Curves along w", std::move(sweep),
      "twoscale plot sweep " + s.name + " --values " + values + " data/polygon.csv -o sweep.svg");
  part.html += "</div>\n";
  part.numbers = {{"sweep", {{"name", "w"}, {"values", values}}}};
  return part;
}

}  // namespace twoscale::reports::scheme_page
