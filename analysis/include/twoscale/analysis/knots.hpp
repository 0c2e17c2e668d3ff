// SPDX-License-Identifier: GPL-3.0-or-later
// Claims about interpolatory schemes on arbitrary knots with edge parameters, for all knots and edge parameters.
//
// Smoothness. Between the vertices of the data the rule becomes that of the uniform member; at a vertex one matrix acts
// at all levels (junction.hpp). Let the uniform member be C^l with uniform convergence, the scheme reproduce
// polynomials of degree <= l on all knots, and all eigenvalues of the junction's matrix but 1, 1/2, .., 2^{-l} be
// smaller than 2^{-l} in modulus. Then the limits are C^l at the vertex: after the polynomial of the leading
// eigenvectors is subtracted, the data on the window of the vertex are o(2^{-lk}) at level k, the limit between the
// distances 2^{-k-1} and 2^{-k} from it depends on a fixed finite number of them by the uniform rule, and so its
// derivatives of order r <= l are o(2^{(r-l)k}) (as Warren 1995, Dyn, Gregory and Levin 1995; the argument in full:
// docs/nonuniform.md). Conversely an eigenvalue of modulus >= 2^{-l} beside them forbids C^l for some data.
//
// The eigenvalues are those of the l-independent quotient by the polynomials reproduced: the matrix of divided
// differences. Parameters: alpha > 0, k = 1 - lambda_{-1}, q = lambda_0; k = q = 0 is the crease.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "twoscale/analysis/junction.hpp"
#include "twoscale/analysis/prove.hpp"
#include "twoscale/analysis/root_bound.hpp"
#include "twoscale/analysis/verdict.hpp"

namespace twoscale::analysis {

// The action on divided differences of order junction.order: the eigenvalues that are not 2^{-n}, n < order.
SymbolicMatrix divided_difference_matrix(const Junction& junction);

// One part of the parameter domain on which the rules are rational.
struct JunctionCase {
  std::string domain;                // "1/2 <= k <= 1, 0 <= q <= 1/2"
  std::optional<std::string> chart;  // "q = k*s" or "k = q*s": near the crease, s in [0, 1]
  Box box;
  std::vector<std::string> zeros;        // faces of the box that do not belong to the case
  Polynomial left, right;                // lambda_{-1}, lambda_0 in the variables of the box
  long kept = 0;                         // eigenvalues 2^{-n}, n < kept, are not among the roots of the factors
  std::vector<Polynomial> factors;       // in "z": their roots are the other eigenvalues
  std::vector<unsigned> multiplicities;  // one for each
  std::vector<RootBound> bounds;         // one for each: are all roots smaller than 2^{-l}?
  std::vector<Polynomial> plain;         // the factors in alpha, k, q; the same where there is no chart
  // Where a bound is refuted: its conditions in their order, decided one by one. If exactly one, the value of the
  // polynomial at 2^{-l}, is not proved, the eigenvalues are inside exactly where that is positive.
  std::vector<std::pair<Polynomial, Positivity>> conditions;
  std::optional<Polynomial> boundary;  // that value, in alpha, k, q
};

struct JunctionVerdict {
  std::vector<JunctionCase> cases;
  Decision decision;
};

// Are all eigenvalues at a junction but 1, .., 2^{-l} smaller than 2^{-l}, for all alpha > 0 and edge parameters?
JunctionVerdict decide_junction(const Scheme& scheme, long l);

// Claims of schemes on knots, with certificate: interpolatory; reproduces=1,x,..; support=a..b; continuity=l. Throws
// Error(bad_input) for other claims.
Proof prove_on_knots(const Scheme& scheme, const std::vector<Claim>& claims);

// The stationary scheme on equal knots with all edge parameters at rest. Throws Error(bad_input) for uniform schemes.
Scheme uniform_member(const Scheme& scheme);

}  // namespace twoscale::analysis
