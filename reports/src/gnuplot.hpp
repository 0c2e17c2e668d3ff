// SPDX-License-Identifier: GPL-3.0-or-later
// What the scripts of curves and of surfaces share.
#pragma once

#include <string>

#include "twoscale/reports/plot.hpp"

namespace twoscale::reports {

// What gnuplot draws from a script that ends with its plot, as the bytes of an image. Throws as render does.
std::string image_of(const std::string& script);

// The arguments of `set terminal`; sizes as Picture has them.
std::string terminal(ImageFormat format, int width, int height);

// A text in single quotes, without control characters.
std::string gnuplot_string(const std::string& text);

}  // namespace twoscale::reports
