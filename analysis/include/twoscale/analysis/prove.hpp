// SPDX-License-Identifier: GPL-3.0-or-later
// Deciding what is claimed of a scheme, for all levels and all parameter values at once, with a certificate.
//
//   claim           subject                       what is decided
//   interpolatory   -                             a_{mj} = delta_{j0}
//   symmetric       -                             a_{2c-i} = a_i, c the middle of the support
//   sum-rules       N (largest if empty)          sum_{i = s mod m} i^r a_i independent of s, r < N
//   generates       space                         zeros at eps z_n, eps^m = 1, eps != 1, with multiplicity; a(z_n) != 0
//   reproduces      space                         further a(z) - m z^{(m-1)p} vanishes at z_n with multiplicity
//   maximal         space (its own if empty)      nothing outside the space is generated
//   well-defined    -                             the exact set of v^0 for which some step has a pole
//   continuity      l (0 if empty)                the limits are C^l (regularity.hpp)
//   contractive     -                             some power of the difference scheme has norm < 1: C^0
//   (regularity.hpp)
// Vertices with derivatives have claims of their own (hermite_claims.hpp).
// z_n = exp(-theta_n/m^{k+1}). Conditions: Dyn, Levin and Luzzatto 2003; Conti and Romani 2011; the stepwise conditions
// at every level are what is decided. See docs/certificates.md for the exact statements.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "twoscale/analysis/verdict.hpp"
#include "twoscale/symbolic/scheme.hpp"

namespace twoscale::analysis {

struct Proof {
  std::vector<Decision> decisions;
  std::string certificate;  // canonical text of the decided claims; empty if none was decided
};

// The names that prove() knows.
const std::vector<std::string>& claim_names();

// What prove() decides when nothing is asked for: the claims of the scheme's source, or, for a scheme without any
// (a mask), its symmetry, largest sum-rule order and the polynomials it generates and reproduces.
std::vector<Claim> default_claims(const Scheme& scheme);

// Throws Error(bad_input) for an unknown claim or a subject that cannot be read.
Proof prove(const Scheme& scheme, const std::vector<Claim>& claims);

// The largest spaces of exponential polynomials found generated and reproduced (stepwise, identically in the
// parameters) among the functions of `within`.
Space reproduced_part(const Scheme& scheme, const Space& within);

}  // namespace twoscale::analysis
