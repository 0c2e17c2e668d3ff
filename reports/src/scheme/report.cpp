// SPDX-License-Identifier: GPL-3.0-or-later
// The page about a scheme: its values, its sections in order, and all files written.
#include <fmt/format.h>

#include "sections.hpp"
#include "twoscale/reports/html.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::reports {

namespace {

using scheme_page::Subject;

constexpr const char* drawn_start = "2";  // v^0 of a level parameter without a value

// The values as --at spells them: those given, then what is missing of level parameters.
lowering::Binding binding_of(const Scheme& scheme, const SchemeReportOptions& o) {
  auto at = o.at;
  if (!o.v0 && !o.t)
    for (const auto& p : scheme.parameters) {
      if (p.scope != Parameter::Scope::level || !p.default_value.empty()) continue;
      if (p.frequency && p.frequency->value()) continue;
      const std::string start = "v0" + (p.name[0] == 'v' ? p.name.substr(1) : "_" + p.name);
      bool given = false;
      for (const auto& [name, text] : at)
        given = given || name == start || (p.spelling && name == p.spelling->name) ||
                (p.frequency && (name == p.frequency->symbol || name == "v0_" + p.frequency->symbol));
      if (!given && p.frequency) at.emplace_back(start, drawn_start);
    }
  return lowering::bind(scheme, o.v0, o.t, at);
}

std::string command_values(const lowering::Binding& b, const Scheme& scheme) {
  std::string v0, at;
  for (const auto& [name, value] : b.description) {
    bool by_default = false;
    for (const auto& p : scheme.parameters)
      by_default =
          by_default || ((p.name == name || (p.spelling && p.spelling->name == name)) && p.default_value == value);
    if (by_default) continue;
    if (name == "v0" || name == "t")
      v0 = " --" + name + "=" + shell_quoted(value);
    else
      at += (at.empty() ? "" : ",") + name + "=" + value;
  }
  return v0 + (at.empty() ? "" : " --at " + shell_quoted(at));
}

}  // namespace

Subject scheme_page::subject_of(const Scheme& scheme, const SchemeReportOptions& o) {
  if (scheme.block > 1) {
    if (o.v0 || o.t || !o.at.empty())
      bad_input("report: what is said of a scheme of blocks is said for the values in its name, not for",
                o.v0  ? *o.v0
                : o.t ? *o.t
                      : o.at[0].first + "=" + o.at[0].second);
    return {scheme, scheme, true, {}, o, shell_quoted(o.name), "", ""};
  }
  if (scheme.kernel.empty()) symbol(scheme);  // refuses what has none
  lowering::Binding binding = binding_of(scheme, o);
  std::vector<std::pair<std::string, RationalFunction>> values;
  bool all = true;
  for (const auto& p : scheme.parameters) {
    if (p.scope != Parameter::Scope::constant) continue;
    const auto value = binding.constants.at(p.name).rational();
    all = all && value.has_value();
    if (value) values.emplace_back(p.name, *value);
  }
  std::string text = command_values(binding, scheme);
  return {scheme, with_values(scheme, values), all, std::move(binding), o, shell_quoted(o.name), std::move(text), ""};
}

SchemeReportSummary write_scheme_report(const Scheme& scheme, const std::string& directory,
                                        const SchemeReportOptions& options) {
  const Subject s = scheme_page::subject_of(scheme, options);
  SchemeReportSummary summary;
  const auto tell = [&](const char* step) {
    if (options.progress) options.progress(step);
  };
  // Everything is computed before anything is written.
  Page page;
  const auto add = [&](const char* id, const char* label, Part part, const char* heading = "") {
    summary.pictures += static_cast<int>(part.figures.size());
    summary.all_certificates_valid = summary.all_certificates_valid && part.certificates_valid;
    page.sections.push_back({id, label, heading, std::move(part)});
  };
  add("definition", "Definition", scheme_page::definition(s));
  add("play", "Try it", scheme_page::play(s), "Drag the points, move the sliders");
  add("parameters", "Parameters", scheme_page::parameters(s));
  add("derivation", "Derivation", scheme_page::derivation(s));
  tell("claims");
  add("claims", "What is proved", scheme_page::claims(s, summary));
  if (scheme.block > 1) {
    tell("smoothness");
    add("smoothness", "Smoothness", scheme_page::smoothness_on_vertices(s));
    tell("spectrum");
    add("spectrum", "Spectrum", scheme_page::spectrum_on_vertices(s), "Spectrum for small steps");
    tell("pictures");
    add("pictures", "Pictures", scheme_page::pictures_on_vertices(s));
  } else if (is_uniform(scheme)) {
    tell("smoothness");
    add("smoothness", "Smoothness", scheme_page::smoothness(s));
    tell("spectrum");
    add("spectrum", "Spectrum", scheme_page::spectrum(s), "Spectrum of the local matrix");
    add("masks", "Masks", scheme_page::masks(s));
    tell("pictures");
    add("pictures", "Pictures", scheme_page::pictures(s));
  } else {
    tell("pictures");
    add("pictures", "Pictures", scheme_page::pictures_on_knots(s));
  }

  page.title = scheme.title;
  page.lead = "<p><code>" + escaped(scheme.id) + "</code>" +
              (scheme.source.empty() ? "" : ", " + escaped(scheme.source)) + "</p>\n";
  page.numbers = {{"scheme", scheme.id}};
  page.footer = fmt::format(
      "twoscale {}. The page is self-contained. Formulas, verdicts and masks are exact or come with a proved bound; "
      "pictures are drawn in double precision. The commands are meant to be run in the directory of this page{}.",
      TWOSCALE_VERSION, options.name.find(".toml") == std::string::npos ? "" : ", with the scheme file there");
  summary.index = write_page(directory, page);
  return summary;
}

}  // namespace twoscale::reports
