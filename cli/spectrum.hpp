// SPDX-License-Identifier: GPL-3.0-or-later
// The mask whose local matrix is looked at: the limit mask, or the mask with values of its variables.
#pragma once

#include "session.hpp"
#include "twoscale/symbolic/scheme.hpp"

namespace twoscale::cli {

struct ChosenMask {
  Laurent mask;
  bool limit = true;  // level variables set to 1
  std::vector<std::pair<std::string, Rational>> values;
};
// Without --at: the limit mask. With it (an empty list too): rational values of variables of the mask, the others stay.
// Throws Error(bad_input) naming an unknown name, a value that is not rational, a pole.
ChosenMask chosen_mask(const Scheme& scheme, const Values& at);

}  // namespace twoscale::cli
