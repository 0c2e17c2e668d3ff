// SPDX-License-Identifier: GPL-3.0-or-later
// What `regularity` and `plot regularity` share.
#pragma once

#include <string>
#include <vector>

#include "twoscale/symbolic/scheme.hpp"

namespace twoscale::cli {

// NAME=[A,B], rational ends.
struct Over {
  std::string name;
  Rational from;
  Rational to;
};
// Throws Error(bad_input) naming the text.
Over parse_over(const std::string& text);

// The scheme with that parameter's domain lifted: a range may reach beyond it, for what holds there is the question.
Scheme along(Scheme scheme, const Over& over);

// The scheme with the constants of --at replaced by rational numbers. Throws Error(bad_input), also for a level
// variable: what is computed holds for all levels.
Scheme with_constants(Scheme scheme, const std::vector<std::string>& at);

}  // namespace twoscale::cli
