// SPDX-License-Identifier: GPL-3.0-or-later
#include "scheme/article.hpp"

#include <fmt/format.h>

#include "interactive.hpp"
#include "scheme/sections.hpp"
#include "twoscale/reports/curves.hpp"
#include "twoscale/reports/html.hpp"
#include "twoscale/symbolic/catalog.hpp"

namespace twoscale::reports {

namespace {

constexpr int drawn_levels = 6;

Picture basic_picture(const Scheme& scheme, const std::vector<std::string>& values) {
  Picture p;
  p.equal_axes = false;
  p.height = 300;
  int colour = 0;
  for (const auto& v0 : values) {
    Line l;
    l.values = basic_limit_function(scheme, lowering::bind(scheme, v0, std::nullopt, {}), drawn_levels).values;
    l.title = "v⁰ = " + v0;
    l.colour = colour++;
    p.lines.push_back(std::move(l));
  }
  return p;
}

}  // namespace

std::string scheme_article(Part& part, const Article& a, const PaperOptions& options) {
  if (options.progress) options.progress("prove " + a.scheme);
  const Scheme scheme = make_scheme(a.scheme);
  SchemeReportOptions own;
  own.name = a.scheme;
  own.v0 = a.basic_v0.at(0);
  own.checker = options.checker;
  scheme_page::Subject subject = scheme_page::subject_of(scheme, own);
  subject.prefix = a.id + "-";
  SchemeReportSummary counted;
  Part claims = scheme_page::claims(subject, counted);
  Part smoothness = scheme_page::smoothness(subject);
  nlohmann::ordered_json j{{"scheme", a.scheme}, {"verdicts", claims.numbers}, {"smoothness", smoothness.numbers}};
  j["singular_v0"] = nlohmann::ordered_json::array();
  for (const auto& v : singular_set(*scheme.space).values)
    j["singular_v0"].push_back({{"exact", v.exact()}, {"level", v.level}});
  part.numbers.push_back(std::move(j));

  const std::string name = shell_quoted(a.scheme);
  const std::string v0 = " --v0=" + shell_quoted(own.v0.value());
  std::string html = fmt::format(
      "<article id=\"{}\">\n<h3>{}</h3>\n<p><code>{}</code>, the space {}</p>\n<div class=\"split\"><div>{}</div>\n",
      a.id, escaped(a.heading), escaped(a.scheme), space_html(*scheme.space), a.formulas);
  html +=
      figure(
          part,
          {"basic-" + a.id, "Basic limit functions", "", {"twoscale plot basic " + name + v0 + " -o basic.svg"}, false},
          basic_picture(scheme, a.basic_v0)) +
      "</div>\n" + interactive_html(part, scheme, subject.binding, {a.id + "_curve", name, sample_polygon()}) +
      "<details><summary>Derivation, step by step</summary>\n" + part.absorb(scheme_page::derivation(subject)) +
      "</details>\n<h4>What is proved</h4>\n" + part.absorb(std::move(claims)) + "<h4>Smoothness</h4>\n" +
      part.absorb(std::move(smoothness));
  return html + commands_html({"twoscale table " + name + v0 + " --levels 10 --digits 30"}) + "</article>\n";
}

}  // namespace twoscale::reports
