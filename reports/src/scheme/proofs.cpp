// SPDX-License-Identifier: GPL-3.0-or-later
// What is proved: the claims of the scheme, its exponents, the spectrum of its local matrix.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "sections.hpp"
#include "twoscale/analysis/prove.hpp"
#include "twoscale/analysis/regularity.hpp"
#include "twoscale/analysis/spectrum.hpp"
#include "twoscale/reports/html.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/hermite_circle.hpp"

namespace twoscale::reports::scheme_page {

using analysis::Decision;
using analysis::Exponent;
using analysis::Regularity;
using analysis::Verdict;

namespace {

std::string decimal(const Rational& r) { return rounded_decimal(r, 10); }

std::string exponent_html(const Exponent& e) {
  if (e.rational) return formula("", e.rational->to_string()) + " exactly";
  if (e.expression && !e.rho) return formula("", *e.expression) + " = " + escaped(decimal(*e.lower)) + "… exactly";
  if (e.lower && e.upper) return "between " + decimal(*e.lower) + " and " + decimal(*e.upper);
  if (e.lower) return "at least " + decimal(*e.lower);
  return "not bounded";
}

std::string row(const std::string& head, const std::string& cell) {
  return "<tr><th>" + head + "</th><td>" + cell + "</td></tr>\n";
}

std::string theorems(const std::vector<Decision>& decisions) {
  std::set<std::string> names;
  for (const auto& d : decisions) {
    if (d.evidence.is_object() && d.evidence.contains("theorem"))
      names.insert(d.evidence["theorem"].get<std::string>());
    for (const auto& e : d.supporting)
      if (e.contains("theorem")) names.insert(e["theorem"].get<std::string>());
  }
  std::string text;
  for (const auto& n : names) text += (text.empty() ? "" : ", ") + escaped(n);
  return text;
}

}  // namespace

Part claims(const Subject& s, SchemeReportSummary& summary) {
  Part part;
  std::vector<Claim> asked = analysis::default_claims(s.scheme);
  std::string claims;  // for the command, if they are not the default
  if (s.scheme.block > 1) {
    bool more = false;
    for (const char* name : {"symmetric", "circle"}) {
      const bool known = std::string(name) == "symmetric" || hermite_tension(s.scheme);
      if (!known || std::any_of(asked.begin(), asked.end(), [&](const Claim& c) { return c.name == name; })) continue;
      asked.push_back({name, "", ""});
      more = true;
    }
    if (more) {
      for (const Claim& c : asked) claims += " --claim " + c.name + (c.subject.empty() ? "" : "=" + c.subject);
    }
  }
  const analysis::Proof proof = analysis::prove(s.scheme, asked);
  part.numbers = nlohmann::ordered_json::array();
  for (const auto& d : proof.decisions) {
    ++(d.verdict == Verdict::proved    ? summary.proved
       : d.verdict == Verdict::refuted ? summary.refuted
                                       : summary.undecided);
    part.numbers.push_back({{"claim", d.claim}, {"subject", d.subject}, {"verdict", to_string(d.verdict)}});
  }
  part.html = s.scheme.block > 1 ? "<p>Decided is what can be asked of rules for vertices with derivatives.</p>\n"
              : s.scheme.claims.empty()
                  ? "<p>No source claims anything; decided is what can be asked of any mask.</p>\n"
                  : "<p>The claims of the scheme’s source, for all values of its parameters at once.</p>\n";
  part.html += verdict_table(proof.decisions);
  if (const std::string names = theorems(proof.decisions); !names.empty())
    part.html += "<p class=\"small\">Theorems named in the certificate: " + names + ".</p>\n";
  if (proof.certificate.empty()) {
    part.html += commands_html({"twoscale prove " + s.name + claims});
    return part;
  }
  part.html += certificate_html(part, s.prefix + "claims", proof.certificate, s.options.checker);
  part.html +=
      commands_html({"twoscale prove " + s.name + claims + " --certificate certificates/" + s.prefix + "claims.json",
                     "twoscale-check certificates/" + s.prefix + "claims.json"});
  return part;
}

Part smoothness(const Subject& s) {
  Part part;
  if (!s.all_fixed) {
    part.html += "<p>Exponents are computed for rational values of the parameters only.</p>\n";
    part.numbers = nullptr;
    return part;
  }
  analysis::RegularityOptions options;
  options.jsr.seconds = s.options.seconds;
  options.jsr.threads = s.options.threads;
  std::optional<Regularity> found;
  std::string obstacle;
  try {
    found = analysis::regularity(s.fixed, options);
    obstacle = found->obstacle;
  } catch (const Error& e) {
    if (e.kind == Error::Kind::io) throw;
    obstacle = e.what();
  }
  if (!obstacle.empty()) {
    part.html += "<p>No exponent: " + prose(obstacle) + ".</p>\n";
    part.numbers = {{"obstacle", obstacle}};
    return part;
  }
  const Regularity& r = *found;
  part.numbers = {{"continuity", r.continuity},
                  {"hoelder_lower", r.hoelder.lower ? nlohmann::ordered_json(r.hoelder.lower->to_string()) : nullptr},
                  {"sum_rules", r.order},
                  {"method", r.method}};
  if (s.fixed.id != s.scheme.id) part.html += "<p>For <code>" + escaped(s.fixed.id) + "</code>.</p>\n";
  part.html += "<table class=\"narrow\"><tbody>\n";
  part.html +=
      row("continuity", r.continuity < 0
                            ? "not proved to be continuous"
                            : fmt::format("<math><msup><mi>C</mi><mn>{}</mn></msup></math>, proved", r.continuity));
  part.html +=
      row("Hölder exponent",
          exponent_html(r.hoelder) + (r.stability.stable ? "" : " (the integer shifts are not stable: a lower bound)"));
  part.html += row("Sobolev exponent", exponent_html(r.sobolev));
  part.html +=
      row("joint spectral radius",
          (r.jsr.exact ? (r.jsr.exact->expression() ? formula("", *r.jsr.exact->expression())
                                                    : "a zero of " + escaped(r.jsr.exact->polynomial().pretty())) +
                             " exactly"
                       : "between " + decimal(r.jsr.lower) + " and " + decimal(r.jsr.upper)) +
              ", by " + escaped(r.method));
  part.html += row("sum rules", "order " + std::to_string(r.order));
  part.html += "</tbody></table>\n";
  if (r.level_dependent)
    part.html +=
        r.transferred
            ? "<p>These are the exponents of the limit of the masks. The scheme generates {" + escaped(r.generated) +
                  "} at all levels, as many functions as the limit has sum rules, so they hold for the scheme "
                  "itself: for " +
                  prose(analysis::start_values(s.scheme)) + " without a singular step.</p>\n"
            : "<p>These are the exponents of the limit of the masks; for the scheme itself they are undecided.</p>\n";
  part.html += certificate_html(part, s.prefix + "smoothness", r.certificate, s.options.checker);
  std::string at;
  for (const auto& p : s.scheme.parameters)
    if (p.scope == Parameter::Scope::constant && p.default_value.empty()) at = s.values;
  part.html += commands_html(
      {"twoscale regularity " + s.name + at + " --certificate certificates/" + s.prefix + "smoothness.json",
       "twoscale-check certificates/" + s.prefix + "smoothness.json"});
  return part;
}

std::string eigenvalue_table(Part& part, const analysis::Spectrum& found) {
  std::string html =
      "<div class=\"wide\"><table class=\"narrow\"><thead><tr><th>eigenvalue</th><th>decimal</th><th>multiplicity</th>"
      "<th>geometric</th></tr></thead><tbody>\n";
  part.numbers = nlohmann::ordered_json::array();
  for (const auto& e : found.eigenvalues) {
    const auto& f = found.factors[e.factor];
    const std::string exact = e.exact.empty()
                                  ? "a root of " + escaped(analysis::polynomial_text(f.polynomial, found.variable))
                                  : formula("", e.exact);
    html += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", exact, escaped(e.decimal),
                        f.multiplicity, f.geometric);
    part.numbers.push_back(e.exact.empty() ? e.decimal : e.exact);
  }
  return html + "</tbody></table></div>\n";
}

Part spectrum(const Subject& s) {
  Part part;
  const auto limit = limit_symbol(s.fixed);
  if (!limit) {
    part.html += "<p>The masks have no limit.</p>\n";
    part.numbers = nullptr;
    return part;
  }
  analysis::Spectrum found;
  try {
    found = analysis::spectrum(*limit, s.scheme.arity);
  } catch (const Error& e) {
    part.html += "<p>" + prose(e.what()) + "</p>\n";
    part.numbers = nullptr;
    return part;
  }
  const auto size = static_cast<long>(found.matrix.entries.rows());
  part.html += fmt::format("<p>{} rows, indices {} to {}, of the {}.</p>\n", size, found.matrix.lowest,
                           found.matrix.lowest + size - 1, is_stationary(s.scheme) ? "mask" : "limit mask") +
               eigenvalue_table(part, found);
  const auto& n = found.necessary;
  part.html += n.order < 0
                   ? "<p>The necessary conditions for continuity fail: " + prose(n.obstruction) + ".</p>\n"
                   : fmt::format(
                         "<p>The necessary conditions for <math><msup><mi>C</mi><mn>{}</mn></msup></math> hold{}; not "
                         "more: {}.</p>\n",
                         n.order, n.conditions.empty() ? "" : " under conditions", prose(n.obstruction));
  part.html += commands_html({"twoscale spectrum " + s.name});
  return part;
}

}  // namespace twoscale::reports::scheme_page
