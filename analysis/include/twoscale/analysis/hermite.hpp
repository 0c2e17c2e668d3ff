// SPDX-License-Identifier: GPL-3.0-or-later
// Stationary Hermite masks, exactly: spectral condition, consistency of the derivatives, polynomials, spectrum.
//
// Vertices carry a value and d derivatives, v = (f, f', .., f^(d)), block size d+1. With the scale D = diag(1, 1/m, ..,
// m^-d) the scheme is D^{k+1} v^{k+1}_i = sum_j A_{i-mj} D^k v^k_j, A_i matrices of size d+1: D times the rule on
// intervals of length 1 (Dubuc and Merrien 2009; Merrien and Sauer 2012).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "twoscale/analysis/spectrum.hpp"
#include "twoscale/symbolic/scheme.hpp"

namespace twoscale::analysis {

struct HermiteMask {
  int arity = 2;
  std::size_t block = 1;        // d + 1
  std::vector<Stencil> phases;  // of A, scaled as above: phases[r] has A_{r - m h}
  std::string parameter;        // in which the derivatives are meant, if it comes from a local parameter
};

// The mask of a scheme without local parameters; of one whose only local parameter s is read at the two ends of an
// edge, the limit for small steps: with s_0 = s, s_1 = s + h the entry of row a, column b (derivatives a and b) behaves
// like h^{b-a}, and its coefficient is the rule on intervals of length 1 in s. Throws Error(bad_input) for a scheme of
// block size 1, with level parameters, with other local parameters, or without such a limit.
HermiteMask hermite_mask(const Scheme& scheme);

// Polynomials p_0, p_1, .. with p_n = x^n/n! + lower powers, and constants c_0 = 1, c_1, .., c_d with
//   sum_j A_{i-mj} V_n(j) = m^{-n} V_n(i) for all i,   V_n = (p_n, c_1 p_n', .., c_d p_n^(d)):
// the spectral condition, for derivatives that the scheme may carry in another scale. `order` is the largest n to which
// it holds (-1: not even constants), looked for up to `searched`.
struct SpectralCondition {
  long order = -1;
  long searched = 0;
  std::vector<RationalFunction> scales;                    // c_0 .. c_min(d, order)
  std::vector<std::vector<RationalFunction>> polynomials;  // p_n, coefficients ascending
  // The derivatives that a vertex carries are those of the limit in one common parameter: c_k = c_1^k. With c_1 = 1
  // they are the derivatives themselves (p = f', r = f'').
  bool consistent = false;
  // p_n = x^n/n! for all n <= order (no lower powers are needed): sampled polynomials of degree <= order are
  // reproduced, with derivatives scaled by c.
  bool reproduces = false;
};
SpectralCondition spectral_condition(const HermiteMask& mask, long most = 16);

// The mask for the derivatives c_k^{-1} f^(k), which are the true ones if `scales` are those of the spectral condition.
HermiteMask rescaled(const HermiteMask& mask, const std::vector<RationalFunction>& scales);

// The matrix of the vertices around 0 that are refined from themselves, vertex by vertex, derivatives within.
LocalMatrix local_matrix(const HermiteMask& mask);

}  // namespace twoscale::analysis
