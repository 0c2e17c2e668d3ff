// SPDX-License-Identifier: GPL-3.0-or-later
// One page about one scheme: what it is, what is proved of it, its smoothness, spectrum, masks and pictures, each with
// the command that repeats it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "twoscale/reports/checker.hpp"
#include "twoscale/symbolic/scheme.hpp"

namespace twoscale::reports {

struct SchemeReportOptions {
  std::string name;  // what the user calls the scheme: its id, or the path of its file; for the commands
  // Values as lowering::bind takes them. A level parameter without a value is drawn for v^0 = 2; a constant one needs a
  // value here or a default.
  std::optional<std::string> v0;
  std::optional<std::string> t;
  std::vector<std::pair<std::string, std::string>> at;
  double seconds = 20;  // for the search of exponents
  int threads = 1;
  Checker checker;                                   // empty: certificates are written, not checked
  std::function<void(const std::string&)> progress;  // empty: silent
};

struct SchemeReportSummary {
  std::string index;  // path of the page
  int pictures = 0;
  int proved = 0;
  int refuted = 0;
  int undecided = 0;
  bool all_certificates_valid = true;
};

// Writes directory/index.html (self-contained: pictures and certificates are embedded), and beside it certificates/,
// figures/ (SVG), data/ and report.json. Makes the directory. Throws Error(bad_input) for a scalar scheme without a symbol
// (local parameters) that is none of those on knots, for a constant of such a one without a value, and for values given
// for a scheme of blocks; Error(io).
SchemeReportSummary write_scheme_report(const Scheme& scheme, const std::string& directory,
                                        const SchemeReportOptions& options);

// Its derivation (its mask, without a space) and what is proved, as Markdown; its derivation as LaTeX. Throw
// Error(bad_input) for a scheme without a symbol, LaTeX also for one without a space.
std::string scheme_markdown(const Scheme& scheme);
std::string scheme_latex(const Scheme& scheme);

}  // namespace twoscale::reports
