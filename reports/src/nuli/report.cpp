// SPDX-License-Identifier: GPL-3.0-or-later
// The page: derivation, verdicts on the formulas, junctions and their certificates, the region of C^2, figures.
#include <fmt/format.h>

#include <cmath>

#include "audit/section.hpp"
#include "interactive.hpp"
#include "nuli/sections.hpp"
#include "twoscale/analysis/knots.hpp"
#include "twoscale/reports/html.hpp"
#include "twoscale/symbolic/catalog.hpp"

namespace twoscale::reports::nuli {

Section rule_section() {
  Section s{"rules", "The rules", "The rules, derived from the splines", {}};
  s.part.html =
      "<p>Knots t<sub>2i</sub> = x<sub>i</sub>, t<sub>2i+1</sub> = x<sub>i</sub> + λ<sub>i</sub>d<sub>i</sub>. The "
      "fundamental splines v<sub>ρ,μ,i</sub> of order n on them, evaluated in the middle of the edge i, are the "
      "weights "
      "of the new point: for n = 3 four of them, for n = 4 six. They simplify to blends of polynomial interpolants "
      "P[a..b] through x<sub>a</sub> .. x<sub>b</sub>, taken in the middle, with weights that have no pole for λ in "
      "[0, 1]; the equality with the splines is proved for all intervals and edge parameters.</p>\n"
      "<p><strong>4 points</strong>: w P[i−1..i+1] + (1 − w) P[i..i+2], " +
      formula("<mi>w</mi>", "l/(2*(1-l))") + " for λ<sub>i</sub> = l ≤ 1/2, else " +
      formula("<mi>w</mi>", "1-(1-l)/(2*l)") +
      ".</p>\n<p><strong>6 points</strong>: w<sub>L</sub> P[i−2..i+1] + (1 − w<sub>L</sub> − w<sub>R</sub>) "
      "P[i−1..i+2] "
      "+ w<sub>R</sub> P[i..i+3], w<sub>L</sub> = W(d<sub>i−1</sub>, d<sub>i</sub>, 1 − λ<sub>i−1</sub>, "
      "λ<sub>i</sub>), "
      "w<sub>R</sub> = W(d<sub>i+1</sub>, d<sub>i</sub>, λ<sub>i+1</sub>, 1 − λ<sub>i</sub>), " +
      formula(
          "<mi>W</mi><mo stretchy=\"false\">(</mo><mi>a</mi><mo>,</mo><mi>b</mi><mo>,</mo><mi>k</mi><mo>,</mo><mi>m"
          "</mi><mo stretchy=\"false\">)</mo>",
          "a*(a*k+b)*f/(3*(2*a+b)*(k*m*(a+b)+k*a+m*b))") +
      ", " + formula("<mi>f</mi>", "m^2/(1-m)") + " for m ≤ 1/2, else " + formula("<mi>f</mi>", "(7*m^2-5*m+1)/m") +
      "; W = 0 for m = 0.</p>\n" +
      commands_html({"twoscale stencil nuli4 --at 'd=[1,1/2,3],lambda=1/3'", "twoscale show nuli6"});
  return s;
}

Section play_section() {
  Section s{"play", "Try it", "Drag the points, mark an edge and move its λ", {}};
  for (const char* name : {"nuli4", "nuli6"}) {
    const Scheme scheme = make_scheme(name);
    s.part.html += "<h3>" + escaped(scheme.title) + "</h3>\n" +
                   interactive_html(s.part, scheme, lowering::bind(scheme, std::nullopt, std::nullopt, {}),
                                    {name, name, sample_polygon()});
  }
  return s;
}

Section junction_section(const PaperOptions& options) {
  Section s{"junctions", "Smoothness", "Smoothness at the vertices of the data", {}};
  Part& part = s.part;
  part.numbers = nlohmann::ordered_json::array();
  part.html =
      "<p>Between the vertices of the data the rule becomes that of equal knots; at a vertex one matrix acts at all "
      "levels. It depends on the ratio α of the intervals right and left of the vertex and on λ<sub>i−1</sub>, "
      "λ<sub>i</sub>; below k = 1 − λ<sub>i−1</sub>, q = λ<sub>i</sub>. The limits are C<sup>l</sup> there if the rule "
      "on "
      "equal knots is C<sup>l</sup>, polynomials of degree l are reproduced, and all eigenvalues but 1, 1/2, .., "
      "2<sup>−l</sup> are smaller than 2<sup>−l</sup> in modulus; if one is not, they are not.</p>\n";
  const std::pair<const char*, const char*> claims[] = {
      {"nuli4", "1"}, {"nuli4", "2"}, {"nuli6", "1"}, {"nuli6", "2"}, {"lagrange4", "1"}};
  for (const char* name : {"nuli4", "nuli6", "lagrange4"}) {
    if (options.progress) options.progress(std::string("smoothness of ") + name);
    const Scheme scheme = make_scheme(name);
    std::vector<Claim> list = scheme.claims;
    for (const auto& [of, l] : claims)
      if (of == scheme.id && std::none_of(list.begin(), list.end(), [&, order = l](const Claim& c) {
            return c.name == "continuity" && c.subject == order;
          }))
        list.push_back({"continuity", l, ""});
    const analysis::Proof proof = analysis::prove_on_knots(scheme, list);
    std::vector<analysis::Decision> shown = proof.decisions;
    for (auto& d : shown)
      for (auto& e : d.exceptions)
        if (e.size() > 200) e = e.substr(0, e.find(" not ")) + " F is not positive (below)";
    part.html += "<h3>" + escaped(scheme.title) + "</h3>\n" + verdict_table(shown);
    if (!proof.certificate.empty()) part.html += certificate_html(part, name, proof.certificate, options.checker);
    std::string command = std::string("twoscale prove ") + name;
    for (const Claim& c : list)
      command += " --claim " + shell_quoted(c.name + (c.subject.empty() ? "" : "=" + c.subject));
    part.html += commands_html({command});
    for (const auto& d : proof.decisions)
      part.numbers.push_back(
          {{"scheme", name}, {"claim", d.claim}, {"subject", d.subject}, {"verdict", to_string(d.verdict)}});
  }
  part.findings.push_back(
      "The 4-point scheme is C<sup>1</sup> for all knots and edge parameters but the crease (1, 0), as the paper says. "
      "The 6-point scheme is C<sup>1</sup> for all of them and <strong>not C<sup>2</sup> for all</strong>, against "
      "section 4: at α = 1, λ = (3/4, 1/8) an eigenvalue 0.2596 is left (<a href=\"#region\">region</a>).");
  return s;
}

PaperSummary write_report(const std::string& directory, const PaperOptions& options) {
  make_directory(directory);  // refused before anything is computed
  PaperPage page;
  page.paper = "nuli";
  page.about =
      "the rules derived from the fundamental splines, every formula decided, smoothness proved or refuted for all "
      "knots "
      "and edge parameters, and the figures. The paper prints no points: ours have strongly different distances.";
  page.method = {
      "Formulas and verdicts are exact, for all knot intervals and edge parameters at once.",
      "Curves of the schemes are refined in double precision, with divided differences. The fundamental splines are "
      "evaluated in rational arithmetic at the double values of the knots and rounded at the end.",
      "<em>Distance to polygon</em>: the largest distance of a point of the curve to the nearest edge, over the "
      "diagonal "
      "of the polygon’s bounding box. <em>Turning</em>: the sum of the absolute turning angles in full turns."};
  if (options.progress) options.progress("formulas of the paper");
  std::vector<Section> sections{rule_section(), play_section(), audit_section(page.paper)};
  sections.push_back(junction_section(options));
  sections.push_back(region_section());
  sections.push_back(precision_section());
  for (Section& s : figure_sections(options)) sections.push_back(std::move(s));
  return write_paper_page(directory, page, std::move(sections));
}

}  // namespace twoscale::reports::nuli
