// SPDX-License-Identifier: GPL-3.0-or-later
// Claims about schemes whose vertices carry derivatives, decided with certificates.
//
//   claim             subject   what is decided
//   interpolatory     -         old vertices stay, with their derivatives or constant multiples of them
//   symmetric         -         the reversed data (vertex j at -j, s -> -s, odd derivatives negated) have the reversed
//                               refinement, identically
//   spectral          N (the largest if empty)   the mask for small steps has the spectral condition of order N at
//                               least
//   interpolant       -         a step is the value with derivatives, at the middle in sigma, of the rational quintic of
//                               hermite2010, Definition 4, through the data of the ends (with the printed tension: on
//                               the interval up to s_0 + w (s_1 - s_0)); with its Bezier form (3)-(7), Hermite
//                               conditions (2) and denominator
//   positive-weights  -         Lemma 3: the weights (3) on alpha in [-1,1]^2, with their minima
//   circle            -         data of a circle are refined to points of this circle (Proposition 5, §3.1)
//   continuity        l (0 if empty)   the limits are C^l in t
//   curvature         -         the limits have continuous curvature where p != 0 (G^2)
// The last five are known for the rules of hermite2010; the argument is reports/hermite2010/tension.md.
#pragma once

#include "twoscale/analysis/prove.hpp"
#include "twoscale/symbolic/rational_function.hpp"

namespace twoscale::analysis {

// Required: scheme.block > 1.
std::vector<Claim> default_claims_on_vertices(const Scheme& scheme);
// Throws Error(bad_input) for an unknown claim.
Proof prove_on_vertices(const Scheme& scheme, const std::vector<Claim>& claims);

// What happens at the vertices and inside for the printed tension, as functions of s = tan(sigma/8) and w: the lengths
// of the intervals of the halves are l (1 + e l + ..) with e = left, right; r jumps at a vertex by jump*p from left to
// right, and along alternating halves changes by drift*p in two steps. All four vanish for w = 1.
struct TensionRates {
  RationalFunction left, right, jump, drift;
};
const TensionRates& tension_rates();

}  // namespace twoscale::analysis
