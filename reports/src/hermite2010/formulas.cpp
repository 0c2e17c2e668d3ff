// SPDX-License-Identifier: GPL-3.0-or-later
// Sections: the interpolant, the rules, the verdicts.
#include <fmt/format.h>

#include "hermite2010/sections.hpp"
#include "twoscale/analysis/prove.hpp"
#include "twoscale/reports/html.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/hermite_circle.hpp"

namespace twoscale::reports::hermite2010 {

namespace {

using R = RationalFunction;

std::string name_with(const char* letter, const std::string& index) {
  return fmt::format("<msub><mi>{}</mi><mn>{}</mn></msub>", letter, index);
}

}  // namespace

Section interpolant_section() {
  const R a = R::variable("a"), b = R::variable("b");
  const auto mu = hermite_circle_weights(a, b);
  Section s{"interpolant", "The interpolant", "", {}};
  s.part.html =
      "<p>Every vertex carries f, p, r (value, first and "
      "second "
      "derivative in <em>t</em> = (1 + tan(σ/4))/2) and its angular parameter σ. Between two vertices, with a = "
      "tan(σ<sub>i</sub>/4), b = tan(σ<sub>i+1</sub>/4), runs the rational quintic with these data. Its weights (3), "
      "the "
      "Bernstein coefficients of the one denominator (1 + (2t − 1)²)²/4 of all segments:</p>\n";
  for (std::size_t k = 0; k < mu.size(); ++k)
    s.part.html += "<p>" + formula(name_with("μ", std::to_string(k)), mu[k].to_string()) + "</p>\n";
  s.part.html +=
      "<p>In σ a segment is a combination of 1, cos(σ/2), sin(σ/2), cos σ, sin σ and tan(σ/4): circles about the "
      "origin of the angles, and t itself.</p>\n";
  return s;
}

Section rules_section() {
  const HermiteRule rule = hermite_circle_rule(R::variable("v"), R::variable("u"));
  Section s{"rules", "The rules", "", {}};
  s.part.html =
      "<p>One step is the segment at the middle in σ, with v = "
      "tan(σ<sub>i</sub>/8), u = tan(σ<sub>i+1</sub>/8). All 18 coefficients of (9), derived from Definition 4 by "
      "exact "
      "algebra (they are the printed ones of (11), (12)):</p>\n<div class=\"wide\">\n";
  for (std::size_t h = 0; h < rule.size(); ++h)
    for (std::size_t l = 0; l < rule[h].size(); ++l)
      s.part.html +=
          "<p>" + formula(name_with("λ", std::to_string(h) + std::to_string(l)), rule[h][l].to_string()) + "</p>\n";
  s.part.html +=
      "</div>\n<p>Tension as printed: u is replaced by w u + (1 − w) v in every step. Tension "
      "<code>variant=c2</code>: diag(1, 1/w, 1/w²) Λ diag(1, w, w²).</p>\n";
  return s;
}

Section verdict_section(const PaperOptions& options) {
  Section s{"verdicts", "Proofs", "What is proved", {}};
  Part& part = s.part;
  part.numbers = nlohmann::ordered_json::array();
  part.html =
      "<p>Each table comes with a certificate, which <code>twoscale-check</code> verifies without computer "
      "algebra.</p>\n";
  const std::pair<const char*, const char*> schemes[] = {{"hermite-circle", "without-tension"},
                                                         {"hermite-circle:w=7/5", "printed-tension"},
                                                         {"hermite-circle:variant=c2,w=7/5", "tension-c2"}};
  for (const auto& [name, file] : schemes) {
    const Scheme scheme = make_scheme(name);
    const analysis::Proof proof = analysis::prove(scheme, analysis::default_claims(scheme));
    part.html += fmt::format("<article><h3>{}</h3>\n<p>{}.</p>\n{}", escaped(name), escaped(scheme.title),
                             verdict_table(proof.decisions));
    nlohmann::ordered_json numbers{{"scheme", name}};
    for (const auto& d : proof.decisions)
      numbers["verdicts"].push_back(
          nlohmann::ordered_json{{"claim", d.claim}, {"subject", d.subject}, {"verdict", to_string(d.verdict)}});
    part.html += certificate_html(part, file, proof.certificate, options.checker) +
                 commands_html({"twoscale prove " + shell_quoted(name) + " --certificate tension.json"}) +
                 "</article>\n";
    part.numbers.push_back(std::move(numbers));
  }
  part.html += "<p>The formulas of the paper one by one, with what is wrong and why:</p>\n" +
               commands_html({"twoscale audit hermite2010"});
  return s;
}

}  // namespace twoscale::reports::hermite2010
