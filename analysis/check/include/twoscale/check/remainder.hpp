// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. What is left of the limit mask without its sum rules.
//   S_m(z) = 1 + z + ... + z^{m-1},  a(z) = m^{-N} S_m(z)^N c(z),  a(1) = c(1) = m
//   (B_s)_{pq} = c_{n0+1-m+s+p-mq}, s < m, p, q < L = max(1, ceil(n0/(m-1))), c_0, ..., c_{n0} the coefficients of c
// A window of L successive N-th divided differences at level k determines m such windows at level k+1 by the B_s.
#pragma once

#include "twoscale/check/claims.hpp"
#include "twoscale/check/matrix.hpp"
#include "twoscale/check/polynomial_matrix.hpp"

#include <optional>
#include <vector>

namespace twoscale::check {

/// a_i = coefficients[i]/scale, from the first that is not 0 to the last; scale > 0.
struct Coefficients {
  std::vector<Integer> list;
  Integer scale = 1;
};

/// The limit mask (all level variables 1), its lowest index moved to 0; a(1) = m. Refused if it contains constants, if
/// its denominator vanishes, if a(1) is not m.
Coefficients limit_coefficients(const Context& context);

/// Refused unless S_m divides a.
void require_sum_rule(const Coefficients& a, long arity, Meter& meter);

/// c for the order N exactly: N >= 1, S_m^N divides a and S_m^{N+1} does not. Refused otherwise.
Coefficients exact_remainder(const Context& context, long order);

/// B_0, ..., B_{m-1} for the remainder of order N exactly.
std::vector<Matrix> remainder_matrices(const Context& context, long order);

/// c_i = (constant[i] + w*linear[i])/scale, from the first that is not 0 identically to the last; scale > 0.
struct AffineCoefficients {
  std::vector<Integer> constant, linear;
  Integer scale = 1;
};

/// c for the order N >= 1, not necessarily the exact one, of a mask with exactly one variable w, a constant, in which c
/// is affine; S_m^N divides a and a(1) = m identically. Refused otherwise.
AffineCoefficients affine_remainder(const Context& context, long order);

/// c at w.
Coefficients at(const AffineCoefficients& c, const Fraction& w, Meter& meter);

/// scale*q*B_0, ..., scale*q*B_{m-1} for w = p/q, p and q polynomials.
std::vector<PolynomialMatrix> remainder_matrices(const AffineCoefficients& c, long arity, const Dense& p,
                                                 const Dense& q, Meter& meter);

/// The mask has exactly one variable w, a constant, in which c is affine. B_0, ..., B_{m-1} for w = low and, if high is
/// another number, for w = high; all other B_s(w), low <= w <= high, are convex combinations of these two. N >= 1.
std::vector<Matrix> remainder_matrices(const Context& context, long order, const Fraction& low, const Fraction& high);

}  // namespace twoscale::check
