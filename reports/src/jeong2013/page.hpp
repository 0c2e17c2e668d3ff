// SPDX-License-Identifier: GPL-3.0-or-later
// What the parts of the page share.
#pragma once

#include <string>

#include "romani2009/page.hpp"
#include "twoscale/reports/jeong2013.hpp"
#include "twoscale/reports/surface_plot.hpp"

namespace twoscale::reports::jeong2013 {

// The pieces that all pages share.
using romani2009::command;
using romani2009::embedded;
using romani2009::make_directory;
using romani2009::number_text;
using romani2009::page_style;
using romani2009::Part;
using romani2009::shell_quoted;

Part curve_part(const Options& options, Summary& summary);
Part surface_part(const Options& options, Summary& summary);

std::string embedded(Part& part, const std::string& name, const std::string& alternative,
                     const SurfacePicture& picture);

}  // namespace twoscale::reports::jeong2013
