// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials in level variables that have one sign on their domain, by the one criterion that the checker knows.
#pragma once

#include <utility>
#include <vector>

#include "twoscale/symbolic/polynomial.hpp"

namespace twoscale::analysis {

// True if p, written in u = v - cos(pi/m) for all its variables v, has no coefficient < 0, or none > 0: then it has no
// zero where all v > cos(pi/m), which is the domain at every level of arity m.
bool has_one_sign_beyond_cosine(const Polynomial& p, int m);

// Those factors (with their exponents, in level variables only) that have to be listed as conditions: the product of
// the others has one sign on the domain. What changes sign at sample points is kept first; the samples decide nothing.
std::vector<Polynomial> factors_to_list(const std::vector<std::pair<Polynomial, unsigned>>& factors, int m);

}  // namespace twoscale::analysis
