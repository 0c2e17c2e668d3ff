// SPDX-License-Identifier: GPL-3.0-or-later
// reports/*/audit.toml, compiled in by the build.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace twoscale::reports::audit {

// Name of the paper, which is that of the folder, and the text.
const std::vector<std::pair<std::string, std::string>>& embedded_items();

}  // namespace twoscale::reports::audit
