// SPDX-License-Identifier: GPL-3.0-or-later
// The paper romani2009 run again: its three 6-point schemes (section 4) derived and proved, its figures 1-12 computed.
#pragma once

#include <string>
#include <vector>

#include "twoscale/reports/figures.hpp"
#include "twoscale/reports/papers.hpp"

namespace twoscale::reports::romani2009 {

const std::vector<Figure>& figures();

PaperSummary write_report(const std::string& directory, const PaperOptions& options);

}  // namespace twoscale::reports::romani2009
