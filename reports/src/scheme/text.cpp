// SPDX-License-Identifier: GPL-3.0-or-later
// The page about a scheme as text: its mask or derivation, and what is proved.
#include <fmt/format.h>

#include "twoscale/analysis/prove.hpp"
#include "twoscale/reports/derivation.hpp"
#include "twoscale/reports/scheme_report.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::reports {

namespace {

// In a cell of a table.
std::string cell(std::string text) {
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2)) text.insert(at, "\\");
  for (char& c : text)
    if (c == '\n') c = ' ';
  return text;
}

std::string mask_table(const Scheme& scheme) {
  const Laurent a = symbol(scheme);
  std::string s = "# " + scheme.id + "\n\n" + scheme.title + ".\n\n| i | a_i |\n|---|---|\n";
  for (long i = a.lowest(); i <= a.highest(); ++i) s += fmt::format("| {} | `{}` |\n", i, a.coefficient(i).to_string());
  return s;
}

}  // namespace

std::string scheme_markdown(const Scheme& scheme) {
  symbol(scheme);  // refuses what has none
  std::string s = scheme.space ? to_markdown(derive(scheme)) : mask_table(scheme);
  s += "\n## What is proved\n\n| claim | subject | verdict | for | except |\n|---|---|---|---|---|\n";
  for (const auto& d : analysis::prove(scheme, analysis::default_claims(scheme)).decisions) {
    std::string exceptions;
    for (const auto& e : d.exceptions) exceptions += (exceptions.empty() ? "" : "; ") + e;
    s += fmt::format("| {} | {} | {} | {} | {} |\n", d.claim, cell(d.subject), to_string(d.verdict),
                     cell(d.verdict == analysis::Verdict::proved ? d.domain : d.witness), cell(exceptions));
  }
  return s;
}

std::string scheme_latex(const Scheme& scheme) {
  if (!scheme.space) bad_input("report --format latex: the scheme is not made from a space", scheme.id);
  return to_latex(derive(scheme));
}

}  // namespace twoscale::reports
