// SPDX-License-Identifier: GPL-3.0-or-later
// Values of local parameters from the command line: d=[1,1/2,3],lambda=1/3.
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
// Knot intervals must be given, edge parameters not given have their rest value. Throws Error(bad_input) naming an
// unknown name, a list of the wrong length, a knot interval that is negative, an edge parameter outside [0, 1].
LocalValues local_values(const Scheme& scheme, const std::vector<std::pair<std::string, std::string>>& at);

// Throws Error(bad_input) unless the constants among the values are what this parameter may be.
void check_local_value(const Parameter& parameter, const RationalFunction& value);

}  // namespace twoscale::cli
