// SPDX-License-Identifier: GPL-3.0-or-later
// The sections of the page, in its order.
#pragma once

#include <vector>

#include "page.hpp"
#include "twoscale/reports/jeong2013.hpp"

namespace twoscale::reports::jeong2013 {

// Figures 1 to 5, 6 and 7, 8 and 9.
std::vector<Section> first_curves(const PaperOptions& options);
std::vector<Section> surface_sections(const PaperOptions& options);
std::vector<Section> last_curves(const PaperOptions& options);

}  // namespace twoscale::reports::jeong2013
