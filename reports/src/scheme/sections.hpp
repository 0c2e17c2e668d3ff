// SPDX-License-Identifier: GPL-3.0-or-later
// The page about a scheme, section by section: each takes the subject and returns its part of the page.
#pragma once

#include "page.hpp"
#include "twoscale/analysis/spectrum.hpp"
#include "twoscale/lowering/lower.hpp"
#include "twoscale/reports/scheme_report.hpp"

namespace twoscale::reports::scheme_page {

// The scheme and the values it is drawn with.
struct Subject {
  const Scheme& scheme;  // with its parameters
  Scheme fixed;          // with the values of its constants, if all are rational
  bool all_fixed = true;
  lowering::Binding binding;
  const SchemeReportOptions& options;
  std::string name;    // for commands, quoted for a shell
  std::string values;  // for commands: " --at w=1/16", or nothing
  std::string prefix;  // of the names of its files, where a page is about several schemes
};

// Refuses a scalar scheme without a symbol, and a constant of such a one without a value; values for a scheme of
// blocks.
Subject subject_of(const Scheme& scheme, const SchemeReportOptions& options);

Part definition(const Subject& s);
Part parameters(const Subject& s);  // and the space
Part derivation(const Subject& s);  // empty without a space
Part claims(const Subject& s, SchemeReportSummary& summary);
Part smoothness(const Subject& s);
Part spectrum(const Subject& s);
std::string eigenvalue_table(Part& part, const analysis::Spectrum& found);  // its numbers go into the part
Part masks(const Subject& s);
Part play(const Subject& s);
Part pictures(const Subject& s);

// The same of a scheme whose vertices carry derivatives.
Part definition_on_vertices(const Subject& s);
Part smoothness_on_vertices(const Subject& s);
Part spectrum_on_vertices(const Subject& s);
Part pictures_on_vertices(const Subject& s);  // empty for rules that no kernel refines by

Part pictures_on_knots(const Subject& s);  // empty for rules that no kernel refines by

}  // namespace twoscale::reports::scheme_page
