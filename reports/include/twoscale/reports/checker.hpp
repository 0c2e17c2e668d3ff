// SPDX-License-Identifier: GPL-3.0-or-later
// How reports ask an independent checker of certificates, which they do not know themselves.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace twoscale::reports {

// Its lines for people, and whether it accepts.
struct CheckerVerdict {
  bool valid = false;
  std::vector<std::string> lines;
};

using Checker = std::function<CheckerVerdict(std::string_view certificate)>;

}  // namespace twoscale::reports
