// SPDX-License-Identifier: GPL-3.0-or-later
// The three schemes of section 4: formulas, verdicts with certificates, singular v^0, basic limit functions; and the
// table of numbers of points a closed curve can start from.
#include <fmt/format.h>

#include "scheme/article.hpp"
#include "sections.hpp"
#include "twoscale/reports/html.hpp"
#include "twoscale/symbolic/catalog.hpp"
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

Article article(const SixPoint& which) {
  const Scheme scheme = make_scheme(which.scheme);
  return {which.name, std::string("Section ") + which.section + ": " + which.what,
          formulas(scheme) + "<p class=\"limit\">" + limits(scheme) +
              "</p>\n<details><summary>The same as text</summary><pre>" + escaped(plain_formulas(scheme)) +
              "</pre></details>",
          which.scheme, which.basic_v0};
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
      "spaces, not copied; verdicts hold for all levels and all v⁰ named at once.</p>\n";
  for (const SixPoint& s : six_point_schemes()) {
    part.html += scheme_article(part, article(s), options);
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
