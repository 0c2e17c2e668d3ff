// SPDX-License-Identifier: GPL-3.0-or-later
// The paper beccari2007 run again: the 4-point scheme with tension derived and proved, its figures 1-6, its algorithm
// for the tension of given points beside one that is right.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "twoscale/reports/figures.hpp"
#include "twoscale/reports/papers.hpp"

namespace twoscale::reports::beccari2007 {

const std::vector<Figure>& figures();

// The algorithm of section 3.2 for plane points p_0..p_{2n}, x and y in turn, n >= 4: the common w of (8), then step
// [3.1] as it is printed, and as it should be (the inverse of w = 1/(4v(1+v)), v >= -1/2). Values that agree to 1e-6
// relatively count as equal. The reason is empty when the algorithm ends well.
struct PrintedTension {
  std::string obstacle;  // "(8) has no solution", "the weights differ"
  double w = 0;
  double as_printed = 0;
  double corrected = 0;
};
PrintedTension printed_tension(const std::vector<double>& points);

PaperSummary write_report(const std::string& directory, const PaperOptions& options);

}  // namespace twoscale::reports::beccari2007
