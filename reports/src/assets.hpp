// SPDX-License-Identifier: GPL-3.0-or-later
// reports/assets/*: style sheet and scripts of the pages, compiled in by the build.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace twoscale::reports {

// Name of the file without its ending, and its text.
const std::vector<std::pair<std::string, std::string>>& embedded_assets();

}  // namespace twoscale::reports
