// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session.hpp"

namespace twoscale::cli {

// `report jeong2013 -o DIR`: writes the page, says what it holds. The exit status.
int report_jeong2013(const Common& common);

}  // namespace twoscale::cli
