// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Are the roots of a polynomial in an open disc? Without parameters by Schur-Cohn
// reduction, else by conditions of Jury (degree up to 3) or of Lienard and Chipart after s = (u+1)/(u-1).
#pragma once

#include "twoscale/check/number.hpp"
#include "twoscale/check/polynomial.hpp"
#include "twoscale/check/univariate.hpp"

#include <vector>

namespace twoscale::check {

/// a_0, ..., a_n of p = sum c_k x^k, x the variable with index `root`, for x = bound*y: a_k = c_k p^k q^(n-k), bound =
/// p/q. They are polynomials in the other variables, in their order. Required: p is not 0.
std::vector<Polynomial> root_coefficients(const Polynomial& p, std::size_t root, std::size_t variables,
                                          const Fraction& bound, Meter& meter);

/// All positive exactly if a_n > 0 and the roots of sum a_k x^k, n = a.size() - 1, lie in |x| < 1.
std::vector<Polynomial> root_conditions(const std::vector<Polynomial>& a, Meter& meter);

/// Do all roots lie in |x| < 1, and is a_n not 0? `a` from the constant term up, not trimmed.
bool schur_cohn(Dense a, Meter& meter);

}  // namespace twoscale::check
