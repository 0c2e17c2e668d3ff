// SPDX-License-Identifier: GPL-3.0-or-later
// The three schemes of section 4: formulas, verdicts with certificates, singular v^0, basic limit functions; and the
// table of numbers of points a closed curve can start from.
#include <fmt/format.h>

#include "sections.hpp"
#include "twoscale/analysis/prove.hpp"
#include "twoscale/reports/curves.hpp"
#include "twoscale/reports/html.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/expression.hpp"
#include "twoscale/symbolic/interpolatory.hpp"

namespace twoscale::reports::romani2009 {

const std::vector<SixPoint>& six_point_schemes() {
  static const std::vector<SixPoint> list = {
      {"mixed", "4.1", "conics and cubics", "interpolating:family=mixed,l=3", {"-1/2", "1/2", "1", "10"}},
      {"harmonic", "4.2", "second-order curves", "interpolating:family=harmonic,l=3", {"-1/4", "1/2", "1", "10"}},
      {"resonant", "4.3", "spirals", "interpolating:family=resonant,l=3", {"-1/2", "1/2", "1", "10"}}};
  return list;
}

namespace {

// zeta_{2j} of the paper stands at z^{2j - (2l-1)}.
std::string formulas(const Scheme& scheme) {
  const Laurent a = symbol(scheme);
  std::string s;
  for (long i = a.lowest(); i < 0; i += 2)
    s +=
        "<p>" +
        formula(
            fmt::format(
                "<msub><mi>ζ</mi><mn>{}</mn></msub><mo>=</mo><msub><mi>a</mi><mrow><mo>±</mo><mn>{}</mn></mrow></msub>",
                i - a.lowest(), -i),
            a.coefficient(i).to_string()) +
        "</p>\n";
  return s;
}

std::string plain_formulas(const Scheme& scheme) {
  const Laurent a = symbol(scheme);
  std::string s;
  for (long i = a.lowest(); i < 0; i += 2) s += fmt::format("a_{} = a_{} = {}\n", i, -i, a.coefficient(i).to_string());
  return s;
}

std::string limits(const Scheme& scheme) {
  const auto limit = limit_symbol(scheme);
  std::string s;
  for (long i = limit->lowest(); i < 0; i += 2)
    s += fmt::format("{}<msub><mi>ζ</mi><mn>{}</mn></msub><mo>→</mo>{}",
                     s.empty() ? "" : "<mo>,</mo><mspace width=\"1em\"/>", i - limit->lowest(),
                     mathml(limit->coefficient(i).to_string()));
  return "<math><mrow>" + s + "</mrow></math>";
}

std::string singular(const Scheme& scheme, nlohmann::ordered_json& numbers) {
  numbers = nlohmann::ordered_json::array();
  const SingularSet set = singular_set(*scheme.space);
  if (set.values.empty()) return "<p>No singular v⁰: every step exists for every v⁰ &gt; −1.</p>\n";
  for (const auto& v : set.values)
    numbers.push_back({{"exact", v.exact()}, {"decimal", parse_real(v.exact()).decimal(6)}, {"level", v.level}});
  return singular_table(set);
}

Picture basic_picture(const Scheme& scheme, const SixPoint& which) {
  Picture p;
  p.equal_axes = false;
  p.height = 300;
  int colour = 0;
  for (const char* v0 : which.basic_v0) {
    Line l;
    l.values = basic_limit_function(scheme, lowering::bind(scheme, v0, std::nullopt, {}), drawn_levels).values;
    l.title = std::string("v⁰ = ") + v0;
    l.colour = colour++;
    p.lines.push_back(std::move(l));
  }
  return p;
}

std::string article(const SixPoint& which, const PaperOptions& options, Part& part) {
  const Scheme scheme = make_scheme(which.scheme);
  const analysis::Proof proof = analysis::prove(scheme, analysis::default_claims(scheme));
  const std::string checked = proof.certificate.empty()
                                  ? "<p>No certificate: nothing was decided.</p>\n"
                                  : certificate_html(part, which.name, proof.certificate, options.checker);
  nlohmann::ordered_json singular_json;
  const std::string singular_html = singular(scheme, singular_json);
  nlohmann::ordered_json j;
  j["scheme"] = which.scheme;
  for (const auto& d : proof.decisions)
    j["verdicts"].push_back({{"claim", d.claim}, {"subject", d.subject}, {"verdict", to_string(d.verdict)}});
  j["singular_v0"] = singular_json;
  part.numbers.push_back(j);
  const std::string name = shell_quoted(which.scheme);
  std::string s =
      fmt::format("<article id=\"{0}\">\n<h3>Section {1}: {2}</h3>\n<p><code>{3}</code>, the space {4}</p>\n",
                  which.name, which.section, which.what, escaped(which.scheme), space_html(*scheme.space));
  s += "<div class=\"split\"><div>" + formulas(scheme);
  s += "<p class=\"limit\">" + limits(scheme) + "</p>\n<details><summary>The same as text</summary><pre>" +
       escaped(plain_formulas(scheme)) + "</pre></details></div>\n";
  const std::string basic = std::string(" --v0=") + which.basic_v0[1];
  s += figure(part,
              {std::string("basic-") + which.name,
               std::string("Basic limit functions, section ") + which.section,
               "",
               {"twoscale plot basic " + name + basic + " -o basic.svg"},
               false},
              basic_picture(scheme, which)) +
       "</div>\n";
  s += verdict_table(proof.decisions) + checked + singular_html;
  const std::string file = std::string("certificates/") + which.name + ".json";
  s += commands_html({"twoscale derive " + name, "twoscale prove " + name + " --certificate " + file,
                      "twoscale-check " + file, "twoscale table " + name + basic + " --levels 10 --digits 30"}) +
       "</article>\n";
  return s;
}

}  // namespace

Section scheme_section(const PaperOptions& options) {
  Section section{"schemes", "Schemes", "The three 6-point schemes", {}};
  Part& part = section.part;
  part.numbers = nlohmann::ordered_json::array();
  part.html =
      "<p>All three are "
      "<math><mrow><msubsup><mi>p</mi><mrow><mn>2</mn><mi>j</mi></mrow><mrow><mi>k</mi><mo>+</mo><mn>1</mn></mrow></"
      "msubsup><mo>=</mo>"
      "<msubsup><mi>p</mi><mi>j</mi><mi>k</mi></msubsup></mrow></math>, "
      "<math><mrow><msubsup><mi>p</mi><mrow><mn>2</mn><mi>j</mi><mo>+</mo><mn>1</mn></mrow><mrow><mi>k</mi><mo>+</"
      "mo><mn>1</mn></mrow></msubsup><mo>=</mo>"
      "<msub><mi>ζ</mi><mn>0</mn></msub><mo "
      "stretchy=\"false\">(</mo><msub><mi>p</mi><mrow><mi>j</mi><mo>−</mo><mn>2</mn></mrow></msub><mo>+</"
      "mo><msub><mi>p</mi><mrow><mi>j</mi><mo>+</mo><mn>3</mn></mrow></msub><mo stretchy=\"false\">)</mo><mo>+</mo>"
      "<msub><mi>ζ</mi><mn>2</mn></msub><mo "
      "stretchy=\"false\">(</mo><msub><mi>p</mi><mrow><mi>j</mi><mo>−</mo><mn>1</mn></mrow></msub><mo>+</"
      "mo><msub><mi>p</mi><mrow><mi>j</mi><mo>+</mo><mn>2</mn></mrow></msub><mo stretchy=\"false\">)</mo><mo>+</mo>"
      "<msub><mi>ζ</mi><mn>4</mn></msub><mo "
      "stretchy=\"false\">(</mo><msub><mi>p</mi><mi>j</mi></msub><mo>+</mo><msub><mi>p</mi><mrow><mi>j</mi><mo>+</"
      "mo><mn>1</mn></mrow></msub><mo stretchy=\"false\">)</mo></mrow></math> "
      "at level k (equation (29)), with "
      "<math><mrow><mi>v</mi><mo>=</mo><msup><mi>v</mi><mrow><mi>k</mi><mo>+</mo><mn>1</mn></mrow></msup><mo>=</mo>"
      "<msqrt><mrow><mo stretchy=\"false\">(</mo><mn>1</mn><mo>+</mo><msup><mi>v</mi><mi>k</mi></msup><mo "
      "stretchy=\"false\">)</mo><mo>/</mo><mn>2</mn></mrow></msqrt></mrow></math> and "
      "<math><mrow><msup><mi>v</mi><mn>0</mn></msup><mo>=</mo><mi>cosh</mi><mi>t</mi></mrow></math>. The formulas "
      "below were derived from the "
      "spaces, not copied; verdicts hold for all levels and all v⁰ named at once. The paper’s smoothness claims are "
      "not examined on this page.</p>\n";
  for (const SixPoint& s : six_point_schemes()) {
    if (options.progress) options.progress(std::string("prove ") + s.scheme);
    part.html += article(s, options, part);
  }
  return section;
}

Section count_section() {
  constexpr long least = 3, greatest = 12;
  Section section{"counts", "Numbers of points", "From how many points can a closed curve start?", {}};
  Part& part = section.part;
  part.numbers = nlohmann::ordered_json::array();
  part.html =
      "<p>A closed curve of period "
      "2π sampled at N points has v⁰ = "
      "cos(2π/N). Where that value is singular, the step named does not exist and N is impossible; this is decided "
      "exactly, from the "
      "denominators of the scheme at all levels.</p>\n<div class=\"wide\"><table "
      "class=\"grid\"><thead><tr><th>scheme</th>";
  for (long n = least; n <= greatest; ++n) part.html += fmt::format("<th>N = {}</th>", n);
  part.html += "</tr></thead><tbody>\n";
  for (const auto& [name, label] : closed_curve_schemes()) {
    const Scheme scheme = make_scheme(name);
    const SingularSet set = singular_set(*scheme.space);
    nlohmann::ordered_json j;
    j["scheme"] = name;
    j["impossible"] = nlohmann::ordered_json::array();
    part.html +=
        "<tr><td>" + escaped(label) + "<br/><span class=\"subject\">" + space_html(*scheme.space) + "</span></td>";
    for (long n = least; n <= greatest; ++n) {
      std::string levels;
      for (const auto& v : set.values)
        if (v.angle == Rational(2) / Rational(n)) levels += (levels.empty() ? "k = " : ", ") + std::to_string(v.level);
      part.html +=
          levels.empty() ? "<td class=\"proved\">yes</td>" : "<td class=\"refuted\">no<br/>" + levels + "</td>";
      if (!levels.empty()) j["impossible"].push_back(n);
    }
    part.html += "</tr>\n";
    part.numbers.push_back(j);
  }
  part.html += "</tbody></table></div>\n";
  return section;
}

}  // namespace twoscale::reports::romani2009
