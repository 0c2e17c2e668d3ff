// SPDX-License-Identifier: GPL-3.0-or-later
// Limit values and derivatives at the points of a level, as stencils for the points around.
//
// The data f^K of level K have the limit F(x) = sum_j f^K_j phi^K(x - j), x in units of their spacing, and
//   phi^K(x) = sum_i a^{[K]}_i phi^{K+1}(m x - i).
// The point j belongs to x = j + p, so the derivative of order d there is sum_u w_u f^K_{j+u}, w_u = (d/dx)^d phi^K(p -
// u) (times m^{dK} per unit spacing of the level-0 data). The values of phi^K at p + Z come from those of phi^{K+1} at
// m p + Z, and so on through the orbit of p under x -> m x mod 1, which ends in a cycle. In the limit of large K the
// values on the cycle are the eigenvector of a product of finite matrices for the eigenvalue m^{-d} of each step;
// moments
//   sum_n (-n)^d phi^{(d)}(x + n) = d!
// fix its length. A stationary scheme needs no more. Else M further levels lead from the limit back to level K; M grows
// until the stencil no longer changes.
#pragma once

#include <vector>

#include "twoscale/kernels/refine.hpp"
#include "twoscale/lowering/lower.hpp"

namespace twoscale::lowering {

// Element d: the stencil of order d = 0..orders-1 for the points of level K, derivatives with respect to the parameter
// t of the level-0 data (spacing 1). Doubles, rounded from values with many more digits; for a level-dependent scheme
// two numbers of further levels, 8 apart, agree to 2^-52 of the largest weight. Throws Error(bad_input) unless
// constants are reproduced in the limit and the eigenvalue is simple (the limit has that derivative; a simple
// eigenvalue alone does not prove that: see `regularity`); Error(undecided) if the levels do not settle, as for second
// derivatives of a scheme that does not generate 1, x.
std::vector<kernels::PointStencil<double>> limit_stencils(const Scheme& scheme, const Binding& binding, unsigned level,
                                                          unsigned orders);

}  // namespace twoscale::lowering
