// SPDX-License-Identifier: GPL-3.0-or-later
// Two-channel filter banks with perfect reconstruction and their lifting factorisation, over the field Q(v) of the
// masks.
//
// Signals: x(z) = sum_i x_i z^i; channels x_e(y) = sum_j x_{2j} y^j, x_o(y) = sum_j x_{2j+1} y^j, y = z^2.
// Synthesis: x(z) = a(z) s(z^2) + b(z) d(z^2), the mask a (low-pass) and the wavelet's mask b (high-pass).
// Analysis: s_j = sum_i L_{i-2j} x_i, d_j = sum_i H_{i-2j} x_i. The dual mask is 2 L (sum 2 when a has sum 2).
// With the polyphase matrix P = [a_e b_e; a_o b_o] (sub-symbols of symbol.hpp) of determinant 1,
//   L(z) = b_o(z^{-2}) - z b_e(z^{-2}),   H(z) = z a_e(z^{-2}) - a_o(z^{-2}),   b(z) = z L(-1/z).
//
// A level-dependent scheme has one bank for each level; v is v^{[k+1]} in all of its filters.
// Factoring: Daubechies and Sweldens 1998. The update of interpolatory masks: Sweldens 1996, for polynomials.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "twoscale/symbolic/laurent.hpp"
#include "twoscale/symbolic/space.hpp"

namespace twoscale {

struct FilterBank {
  Laurent synthesis_low;   // a
  Laurent synthesis_high;  // b
  Laurent analysis_low;    // L
  Laurent analysis_high;   // H
};

// The bank of a and b; required: determinant 1 (see reconstructs).
FilterBank filter_bank(const Laurent& a, const Laurent& b);
// P times the analysis matrix is the identity, exactly.
bool reconstructs(const FilterBank& bank);
// a(1/z).
Laurent reversed(const Laurent& a);

// One step of the analysis, in place: predict adds filter(y) x_e to x_o, update adds filter(y) x_o to x_e; in
// coordinates target_j += sum_i filter_i source_{j-i}.
struct LiftingStep {
  bool predict = true;
  Laurent filter;
};

// Analysis: the steps in order, then s = x_e y^{-delay}/norm, d = x_o y^{delay} norm. Synthesis: the same backwards
// with opposite signs.
struct LiftingFactorization {
  std::vector<LiftingStep> steps;
  RationalFunction norm = 1;  // K
  long delay = 0;
};

// The bank that the steps compute.
FilterBank expand(const LiftingFactorization& lifting);

// What is wrong with a mask or a pair, in terms of the parameters of the scheme.
struct LiftingDomain {
  std::vector<Polynomial> poles;  // irreducible factors in denominators of steps and norm: these steps do not exist
  // Factors of the resultant of a_e and a_o: there these have a common zero and no dual filter exists (or both lose the
  // coefficient at the same end).
  std::vector<Polynomial> common_zero;
};

struct Lifting {
  LiftingFactorization factorization;
  FilterBank bank;
  LiftingDomain domain;
};

// The dual whose synthesis wavelet annihilates `moments` (b vanishes at z = e^{-theta/2^{k+1}} to the multiplicities of
// the space, which is to say that the dual mask generates it); its update has as many taps as `moments` has dimensions,
// placed so that b is symmetric where that is possible. An empty space asks for nothing: the shortest completion.
// `moments` is written in the level variables of the mask. Interpolatory a: one predict, one update; the update is
// reversed(p)/2 with the predictor p of the interpolatory scheme of `moments`, if `moments` lies in the scheme's space.
// Throws Error(bad_input): a_e and a_o have a common factor (named), or no update with the moments exists.
Lifting complete(const Laurent& a, const Space& moments);

// The pair of a and a dual mask (sum 2): sum_i a_i dual_{i-2j} = 2 delta_{j0}, up to an even translation of the dual.
// Throws Error(bad_input) naming the first sum that is wrong.
Lifting factor_pair(const Laurent& a, const Laurent& dual);

// How the steps are found: Euclid's algorithm on (a_e, a_o), where each division may leave its remainder anywhere
// within the dividend. The fewest steps are searched for at a rational point of the parameters (every placement, up to
// a budget of divisions; symmetric quotients first, then no delay), and repeated exactly; the product of the steps is
// compared with the bank before anything is returned.

// Multiplicity of the zero z = 1 of a symbol: its vanishing moments.
unsigned vanishing_moments(const Laurent& a);

// dec_lo, dec_hi, rec_lo, rec_hi of equal length n = 2 mod 4, times or over sqrt(2) as said: index origin 0, so that
// rec_lo(z) dec_lo(z) + rec_hi(z) dec_hi(z) = 2 z^{n-1} and rec_lo(z) dec_lo(-z) + rec_hi(z) dec_hi(-z) = 0. Of the
// signal filtered with dec_lo, dec_hi the samples of odd index are sqrt(2) s and d/sqrt(2), up to a translation
// (PyWavelets keeps these).
struct OrthonormalLayout {
  long length = 0;
  Laurent dec_lo;  // times sqrt(2)
  Laurent dec_hi;  // over sqrt(2)
  Laurent rec_lo;  // over sqrt(2)
  Laurent rec_hi;  // times sqrt(2)
};
OrthonormalLayout orthonormal_layout(const FilterBank& bank);

}  // namespace twoscale
