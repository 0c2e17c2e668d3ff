// SPDX-License-Identifier: GPL-3.0-or-later
// Interpolating schemes of any arity m: phase 0 keeps the points, phase s = 1..m-1 evaluates at s/m the one function of
// V (at level k: frequencies theta/m^k) through the N = dim V nearest points.
//
// Notation (pairs +-theta_i, i = 0..n-1; N = 2n or 2n + 1, then one zero frequency is left over):
//   w_i = cosh(theta_i/m^{k+1})                   the nodes (space.hpp), rational in the level variables
//   w = (z + 1/z)/2, U = T_m(w), U_i = T_m(w_i)
//   t_ij = T_m[w_i, w_j]                          divided difference, T_m'(w_i) for equal nodes (symbol.hpp)
//   S(w) = sigma(z), centred, S(1) = m            S = const prod_i T_m[w, w_i], times D(w) for odd N,
//   D(w) = z^{-(m-1)/2} (1 + z + .. + z^{m-1})    m odd; D^2 = T_m[w, 1]
//
//   N = 2l, any m      points j-l+1..j+l for the parameters between j and j+1; zeta of support [-(ml-1), ml-1]
//   N = 2l+1, m odd    points j-l..j+l for the parameters j + s/m, |s| <= (m-1)/2; support +-(ml + (m-1)/2); the
//                      nodes are the w_i and one more 1, because a symmetric symbol has only even contacts at z = 1
//   N odd, m even      sigma is dual (p = 1/(2m-2)): there is no interpolating scheme with it as a factor
//
// The points of a closed polygon come from V on the grid of the integers, so a step fails exactly where two functions
// e^{theta_i x}, e^{theta_j x} of V (signs included) agree on the coarse grid but not on the fine one, that is where
// some t_ij = 0: no linear rule can continue both. Elsewhere the generalised Vandermonde system is regular.
//
// Two routes to the same symbol:
//   1. mary_interpolating_symbol: with tau = m theta/m^{k+1}, U = cosh(tau), symmetry halves the conditions into two
//   Hermite
//      problems in U with values
//        even half  cosh((s/m - 1/2) tau)/cosh(tau/2) = sum_h (c_{h+1} + c_{-h}) V_h(U)
//        odd half   sinh((s/m - 1/2) tau)/sinh(tau/2) = sum_h (c_{h+1} - c_{-h}) W_h(U)                     (N even)
//        even half  cosh(s/m tau)           = c_0 + sum_h (c_h + c_{-h}) T_h(U)
//        odd half   sinh(s/m tau)/sinh(tau) =       sum_h (c_h - c_{-h}) U_{h-1}(U)                         (N odd)
//      at U = U_i, T, U, V, W the four kinds of Chebyshev polynomials. The values are quotients of Chebyshev
//      polynomials in w_i; the derivatives at a repeated node follow from the hypergeometric equation
//        (1 - U^2) g'' - (beta U + delta) g' + lambda g = 0
//      (Abramowitz and Stegun 15.1.11-15.1.18), so no series and no quotient of differences is needed.
//   2. hessenberg_system (interpolatory.hpp): zeta = sigma omega is interpolatory iff W(w) = omega(z), of degree l-1
//   (l), is the Hermite
//      interpolant of m/S at the nodes. Proof: sum over eps^m = 1 of zeta(eps z) is a polynomial in U of that degree,
//      and equals m at every U_i with multiplicity, because zeta vanishes at eps/z_i, eps != 1.
// At v = 1 both give the m-ary Deslauriers-Dubuc weights prod_{j != h} (s/m - j)/(h - j).
#pragma once

#include "twoscale/symbolic/interpolatory.hpp"

namespace twoscale {

// True if the space has an interpolating scheme of that arity: N even, or m odd.
bool has_interpolating_scheme(const Space& space, int arity);

// Route 1 for every arity, the binary ones too, where interpolating_symbol knows closed forms; for tests and
// benchmarks. Throws Error(bad_input) if there is no such scheme or the arity is not in 2..64. Cost: O(m l^2) products
// of polynomials.
Laurent mary_interpolating_symbol(const Space& space, int arity);

}  // namespace twoscale
