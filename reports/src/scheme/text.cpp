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

// Of a scheme whose vertices carry derivatives: the entries that are not 0.
std::string rule_table(const Scheme& scheme) {
  const auto block = static_cast<std::size_t>(scheme.block);
  std::string s = "# " + scheme.id + "\n\n" + scheme.title +
                  ".\n\n| new vertex | derivative | old vertex | derivative | factor |\n|---|---|---|---|---|\n";
  for (std::size_t phase = 0; phase < scheme.phases.size(); ++phase) {
    const Stencil& stencil = scheme.phases[phase];
    for (std::size_t i = 0; i < stencil.blocks.size(); ++i)
      for (std::size_t e = 0; e < stencil.blocks[i].size(); ++e)
        if (const RationalFunction& c = stencil.blocks[i][e]; !c.is_zero())
          s += fmt::format("| {}j+{} | {} | j{:+} | {} | `{}` |\n", scheme.arity, phase, e / block,
                           stencil.lowest + static_cast<long>(i), e % block, c.to_string());
  }
  return s;
}

}  // namespace

std::string scheme_markdown(const Scheme& scheme) {
  if (scheme.block == 1) symbol(scheme);  // refuses what has none
  std::string s = scheme.space       ? to_markdown(derive(scheme))
                  : scheme.block > 1 ? rule_table(scheme)
                                     : mask_table(scheme);
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
