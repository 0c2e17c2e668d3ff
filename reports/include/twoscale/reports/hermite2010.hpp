// SPDX-License-Identifier: GPL-3.0-or-later
// The paper hermite2010 on one page: interpolant, rules, verdicts with their certificates, the answer to its open
// question with numbers, and its figures in spirit (it prints no coordinates: the points are ours).
#pragma once

#include <functional>
#include <string>

#include "twoscale/reports/checker.hpp"

namespace twoscale::reports::hermite2010 {

struct Options {
  Checker checker;                                   // of certificates; empty: they are not checked
  std::function<void(const std::string&)> progress;  // empty: silent
};

struct Summary {
  int pictures = 0;
  int circles = 0;               // runs from points of a circle, in double, to level 10
  double largest_deviation = 0;  // of their points from the circle, over its radius
  bool all_certificates_valid = true;
  std::string index;  // path of the page
};

// Writes directory/index.html (self-contained: pictures are embedded), and beside it figures/ (SVG), data/ (points),
// certificates/ and measurements.json. Makes the directory. Throws Error(io).
Summary write_report(const std::string& directory, const Options& options);

}  // namespace twoscale::reports::hermite2010
