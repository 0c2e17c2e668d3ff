// SPDX-License-Identifier: GPL-3.0-or-later
// A polynomial as one in a variable of its own, in time linear in its terms.
#pragma once

#include "twoscale/symbolic/polynomial.hpp"

namespace twoscale {

// c_0 .. c_d with p = sum c_e variable^e; {0} for 0.
std::vector<Polynomial> coefficients_of(const Polynomial& p, const std::string& variable);

}  // namespace twoscale
