// SPDX-License-Identifier: GPL-3.0-or-later
// What the sections of the page share, beside page.hpp.
#pragma once

#include <string>
#include <vector>

#include "page.hpp"
#include "twoscale/reports/nuli.hpp"

namespace twoscale::reports::nuli {

Section rule_section();
Section junction_section(const PaperOptions& options);
Section region_section();
Section precision_section();
std::vector<Section> figure_sections(const PaperOptions& options);

}  // namespace twoscale::reports::nuli
