// SPDX-License-Identifier: GPL-3.0-or-later
// What the parts of the page share, beside document.hpp.
#pragma once

#include <string>

#include "document.hpp"
#include "twoscale/reports/jeong2013.hpp"
#include "twoscale/reports/surface_plot.hpp"

namespace twoscale::reports::jeong2013 {

Part curve_part(const Options& options, Summary& summary);
Part surface_part(const Options& options, Summary& summary);

std::string embedded(Part& part, const std::string& name, const std::string& alternative,
                     const SurfacePicture& picture);

}  // namespace twoscale::reports::jeong2013
