// SPDX-License-Identifier: GPL-3.0-or-later
// The exponential B-spline as a function: its two-scale relation is an identity of Laurent polynomials.
//
// A space V of order N has the frequencies theta_1..theta_N (0, and both signs of +-theta, counted with multiplicity).
// At level k the abscissa is measured in units of the spacing m^{-k}, so the frequencies are alpha_j = theta_j/m^k:
//
//   B^{[k]}   = convolution of the N functions e^{alpha_j x} on [0, 1), support [0, N]
//             = sum_i d_i G(x - i)_+,   sum_i d_i z^i = prod_j (1 - e^{alpha_j} z),
//   G(x)      = [alpha_1, .., alpha_N] e^{x .}, the divided difference in the exponent (confluent where frequencies
//               coincide): Green's function of prod (D - alpha_j), a piece of V,
//   phi^{[k]} = c_k B^{[k]},  c_k = prod_j alpha_j/(e^{alpha_j} - 1):  integral 1; if 1 is in V, its translates sum
//   to 1.
//
// Since G^{[k]}(x) = m^{1-N} G^{[k+1]}(m x) and c_k/c_{k+1} = prod_j m/S_m(e^{alpha_j/m}), and since the functions
// G(m x - n)_+ are linearly independent,
//
//   phi^{[k]}(x) = sum_i a_i phi^{[k+1]}(m x - i)   <=>   a(z) d^{[k+1]}(z) prod_j S_m(E_j)/m = d^{[k]}(z^m),
//
// E_j = e^{alpha_j/m}: an identity in the level variables, for all frequencies at once. It holds for sigma
// (symbol.hpp).
#pragma once

#include "twoscale/symbolic/laurent.hpp"
#include "twoscale/symbolic/space.hpp"

namespace twoscale {

// prod_j (1 - e^{n theta_j/m^{k+1}} z) in the level variables v = v^{[k+1]}: n = 1 belongs to level k+1, n = m to level
// k.
Laurent knot_polynomial(const Space& space, unsigned n);

// s(v) = m^{-N} prod_j S_m(e^{theta_j/m^{k+1}}): s sigma = m^{1-N} prod_j S_m(E_j z) is the mask of the convolutions
// B^{[k]} themselves, without any normalisation. s -> 1 as k -> infinity.
RationalFunction convolution_factor(const Space& space, int arity);

// a(z) d^{[k+1]}(z) prod_j S_m(E_j)/m - d^{[k]}(z^m), the mask moved to lowest index 0 (an integer translation of phi):
// zero if and only if `mask` is the mask of the two-scale relation of phi, for every value of the level variables.
Laurent two_scale_residual(const Space& space, int arity, const Laurent& mask);

}  // namespace twoscale
