// SPDX-License-Identifier: GPL-3.0-or-later
// The audit of a paper as a section of its page.
#pragma once

#include <string>

#include "page.hpp"

namespace twoscale::reports {

// What is wrong in the paper as printed, with the reason and what is right; counts of the rest. A finding says how
// many.
Section audit_section(const std::string& paper);

}  // namespace twoscale::reports
