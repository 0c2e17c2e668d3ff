// SPDX-License-Identifier: GPL-3.0-or-later
// The paper hermite2010 on one page: interpolant, rules, verdicts with their certificates, the answer to its open
// question with numbers, and its figures in spirit (it prints no coordinates: the points are ours).
#pragma once

#include "twoscale/reports/papers.hpp"

namespace twoscale::reports::hermite2010 {

// See Paper::write.
PaperSummary write_report(const std::string& directory, const PaperOptions& options);

}  // namespace twoscale::reports::hermite2010
