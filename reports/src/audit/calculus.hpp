// SPDX-License-Identifier: GPL-3.0-or-later
// Definitions of items that are made by an operation: substitution, derivative, the rules of a scheme of blocks.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "twoscale/symbolic/rational_function.hpp"

namespace twoscale::reports::audit {

// What a definition `name = BODY` makes, by name, for BODY one of
//   substitute FORMULA at x=F, y=G   all at once
//   derivative FORMULA by x
//   rules SCHEME [at x=F, y=G]       name_hl: row h, column l of the rule of a new vertex in the middle of an edge, the
//                                    columns ordered by derivative, then by vertex (block size and vertices: at most 10
//                                    columns); what is not given a value stays a variable
// nullopt for any other body. `value` evaluates a formula. Throws Error(bad_input).
std::optional<std::map<std::string, RationalFunction>> defined_by_operation(
    const std::string& name, const std::string& body, const std::function<RationalFunction(const std::string&)>& value);

}  // namespace twoscale::reports::audit
