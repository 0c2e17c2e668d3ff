// SPDX-License-Identifier: GPL-3.0-or-later
// Pages about papers: schemes and figures computed again. One line a paper in src/papers.cpp says which there are.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "twoscale/reports/checker.hpp"

namespace twoscale::reports {

struct PaperOptions {
  Checker checker;                                   // empty: certificates are written, not checked
  std::function<void(const std::string&)> progress;  // empty: silent
};

// A picture of the page.
struct PaperFigure {
  std::string id;       // "5a"
  std::string title;    // plain text
  std::string file;     // figures/5a.svg, below the directory of the page
  std::string command;  // for a shell in that directory: draws or computes it; empty: the command of the page does
  bool numbered = true;  // the id is a number that readers see
};

struct PaperSummary {
  std::string index;                 // path of the page
  std::vector<PaperFigure> figures;  // in the order of the page
  int exact_runs = 0;                // runs that should return a known curve or surface
  double largest_exact_deviation = 0;
  bool all_certificates_valid = true;
};

struct Paper {
  std::string name;       // "romani2009"
  std::string reference;  // plain text: authors, title
  std::string exact;      // what its exact runs return: "curve", "surface"
  // Writes directory/index.html (self-contained: pictures are embedded), and beside it figures/ (SVG), data/ (what the
  // commands of the page read), certificates/ if there are any, and report.json. Makes the directory. Throws Error(io).
  PaperSummary (*write)(const std::string& directory, const PaperOptions& options);
};

// In alphabetical order of their names.
const std::vector<Paper>& papers();
// nullptr: no such paper.
const Paper* find_paper(const std::string& name);

}  // namespace twoscale::reports
