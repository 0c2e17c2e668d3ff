// SPDX-License-Identifier: GPL-3.0-or-later
// The three schemes of section 4: formulas, verdicts with certificates, singular v^0, basic limit functions; and the
// table of numbers of points a closed curve can start from.
#include <fmt/format.h>

#include "page.hpp"
#include "twoscale/analysis/prove.hpp"
#include "twoscale/reports/curves.hpp"
#include "twoscale/reports/html.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/expression.hpp"
#include "twoscale/symbolic/interpolatory.hpp"

namespace twoscale::reports::romani2009 {

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
  std::string s =
      "<table class=\"narrow\"><thead><tr><th>singular v⁰</th><th>decimal</th><th>the step that "
      "fails</th></tr></thead><tbody>\n";
  for (const auto& v : set.values) {
    const std::string decimal = parse_real(v.exact()).decimal(6);
    s += fmt::format("<tr><td>{}</td><td>{}</td><td>k = {}</td></tr>\n", v0_html(v.exact()), decimal, v.level);
    numbers.push_back({{"exact", v.exact()}, {"decimal", decimal}, {"level", v.level}});
  }
  return s + "</tbody></table>\n";
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

std::string article(const SixPoint& which, const Options& options, Part& part, Summary& summary) {
  const Scheme scheme = make_scheme(which.scheme);
  const analysis::Proof proof = analysis::prove(scheme, analysis::default_claims(scheme));
  const std::string file = std::string("certificates/") + which.name + ".json";
  std::string checked = "No certificate: nothing was decided.";
  if (!proof.certificate.empty()) {
    part.files.emplace_back(file, proof.certificate);
    checked = fmt::format("<a href=\"{}\">Certificate</a>", file);
    if (options.checker) {
      const CheckerVerdict v = options.checker(proof.certificate);
      summary.all_certificates_valid = summary.all_certificates_valid && v.valid;
      std::string lines;
      for (const auto& line : v.lines) lines += escaped(line) + "\n";
      checked += fmt::format(
          ": the independent checker says <strong class=\"{0}\">{1}</strong>.</p><details><summary>What the checker "
          "verified, and what it trusts</summary><pre>{2}</pre></details><p>",
          v.valid ? "proved" : "refuted", v.valid ? "valid" : "refused", lines);
    }
  }
  nlohmann::ordered_json singular_json;
  const std::string singular_html = singular(scheme, singular_json);
  const std::string picture =
      embedded(part, std::string("basic-") + which.name, std::string("Basic limit functions, ") + which.name,
               basic_picture(scheme, which));
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
  s += "<figure>" + picture + "<figcaption>Basic limit functions</figcaption></figure></div>\n";
  s += verdict_table(proof.decisions) + "<p>" + checked + "</p>\n" + singular_html;
  s += "<pre class=\"shell\">" + command("twoscale derive " + name) +
       command("twoscale prove " + name + " --certificate " + file) + command("twoscale-check " + file) +
       command("twoscale table " + name + " --v0 " + which.basic_v0[1] + " --levels 10 --digits 30") +
       "</pre>\n</article>\n";
  return s;
}

}  // namespace

Part scheme_part(const Options& options, Summary& summary) {
  Part part;
  part.numbers = nlohmann::ordered_json::array();
  part.html =
      "<section id=\"schemes\">\n<h2>The three 6-point schemes</h2>\n<p>All three are "
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
    part.html += article(s, options, part, summary);
  }
  part.html += "</section>\n";
  return part;
}

Part count_part() {
  constexpr long least = 3, greatest = 12;
  const char* const schemes[] = {"tension4",
                                 "interpolating:family=mixed,l=3",
                                 "interpolating:family=resonant,l=3",
                                 "interpolating:family=harmonic,l=3",
                                 "interpolating:space=\"1,x,cos(t*x),sin(t*x),cos(3*t*x),sin(3*t*x)\"",
                                 "interpolating:family=harmonic,l=4"};
  Part part;
  part.numbers = nlohmann::ordered_json::array();
  part.html =
      "<section id=\"counts\">\n<h2>From how many points can a closed curve start?</h2>\n<p>A closed curve of period "
      "2π sampled at N points has v⁰ = "
      "cos(2π/N). Where that value is singular, the step named does not exist and N is impossible; this is decided "
      "exactly, from the "
      "denominators of the scheme at all levels.</p>\n<div class=\"wide\"><table "
      "class=\"grid\"><thead><tr><th>scheme</th>";
  for (long n = least; n <= greatest; ++n) part.html += fmt::format("<th>N = {}</th>", n);
  part.html += "</tr></thead><tbody>\n";
  for (const char* name : schemes) {
    const Scheme scheme = make_scheme(name);
    const SingularSet set = singular_set(*scheme.space);
    nlohmann::ordered_json j;
    j["scheme"] = name;
    j["impossible"] = nlohmann::ordered_json::array();
    part.html += "<tr><td>" + escaped(scheme_label(name)) + "<br/><span class=\"subject\">" +
                 space_html(*scheme.space) + "</span></td>";
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
  part.html += "</tbody></table></div>\n</section>\n";
  return part;
}

}  // namespace twoscale::reports::romani2009
