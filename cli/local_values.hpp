// SPDX-License-Identifier: GPL-3.0-or-later
// Values of all parameters from the command line: d=[1,1/2,3],lambda=1/3.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "twoscale/symbolic/scheme.hpp"

namespace twoscale::cli {

// "[a,b,c]" or "a" as expressions in + - * / and integer powers. Throws Error(bad_input) naming the piece.
std::vector<RationalFunction> expression_list(const std::string& name, const std::string& text);

struct LocalValues {
  std::vector<std::pair<std::string, std::vector<RationalFunction>>> given;  // in the order of the parameters
  std::vector<std::pair<std::string, RationalFunction>> values;              // by the names of the stencils
};
// What is not given has its rest value (edge parameters) or its default. Throws Error(bad_input) naming an unknown
// name, a missing value, a list of the wrong length, a value outside the domain, a knot interval that is not positive,
// an edge parameter outside [0, 1].
LocalValues local_values(const Scheme& scheme, const std::vector<std::pair<std::string, std::string>>& at);

// Throws Error(bad_input) if a constant value is not what this parameter of the scheme may be.
void check_local_value(const Scheme& scheme, const Parameter& parameter, const RationalFunction& value);

}  // namespace twoscale::cli
