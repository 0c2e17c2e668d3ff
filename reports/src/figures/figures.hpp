// SPDX-License-Identifier: GPL-3.0-or-later
// Sections of a page made from the table of a paper's figures.
#pragma once

#include <string>
#include <vector>

#include "page.hpp"
#include "twoscale/reports/figures.hpp"

namespace twoscale::reports {

Section figure_section(const Figure& figure, const PaperOptions& options);
// How the numbers beside the figures are measured, HTML.
std::vector<std::string> figure_method();
// Required: the id is there.
const Panel& panel(const std::vector<Figure>& figures, const std::string& id);
std::string v0_html(const std::string& v0);  // inline MathML, "–" for none

}  // namespace twoscale::reports
