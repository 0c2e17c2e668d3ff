// SPDX-License-Identifier: GPL-3.0-or-later
// Are all roots of a polynomial inside |x| < r, for all parameters of a box?
//
// With x = r y and a(y) = sum a_k y^k, a_n > 0, all roots y in |y| < 1 exactly if
//   n = 1   a_1 > |a_0|
//   n = 2   a_2 > a_0,  a_2 + a_0 > |a_1|                                                             (Jury)
//   n = 3   a(1) > 0,  a(-1) < 0,  a_3 > |a_0|,  a_3^2 - a_0^2 > |a_3 a_1 - a_2 a_0|                    (Jury)
//   n >= 4  sum h_j u^j = (u-1)^n a((u+1)/(u-1)) has h_j > 0 and Hurwitz determinants D_{n-1}, D_{n-3}, ... > 0
//           (Lienard and Chipart; Gantmacher, The Theory of Matrices, ch. XV)
// These are signs of polynomials in the parameters (positivity.hpp). Without parameters the Schur-Cohn reduction
// decides: all roots inside iff |a_0| < |a_n| and those of (a_n a(y) - a_0 y^n a(1/y))/y are.
#pragma once

#include <string>
#include <vector>

#include "twoscale/analysis/positivity.hpp"

namespace twoscale::analysis {

// The coefficients of p in `root`, from the constant term up. Required: p != 0.
std::vector<Polynomial> coefficients_in(const Polynomial& p, const std::string& root);

// Exact: are all roots of p in |x| < radius? Required: p != 0, at most one variable, radius > 0. A constant has no
// roots.
bool roots_inside(const Polynomial& p, const Rational& radius);

// The conditions above for a_0, ..., a_n: all positive exactly if a_n > 0 and all roots are in |y| < 1. Required: a not
// empty; jury_conditions: n <= 3.
std::vector<Polynomial> jury_conditions(const std::vector<Polynomial>& a);
std::vector<Polynomial> lienard_chipart_conditions(const std::vector<Polynomial>& a);

struct RootBound {
  Verdict verdict = Verdict::undecided;
  Polynomial polynomial;                // p, or -p where that makes the leading coefficient positive
  std::vector<Polynomial> conditions;   // the conditions for x = r y; none without parameters
  std::vector<PositivityProof> proofs;  // proved: one for each condition
  std::optional<BoxPoint> point;        // refuted: here a root is not inside, or the degree is less
  std::string reason;                   // undecided
  nlohmann::ordered_json evidence;      // the entry of a certificate (claim `root-bound`); null when undecided
};

// The degree of p in `root` is n at all parameters of the box, and all n roots are in |root| < radius; nothing is
// claimed on the faces options.zeros. Required: p != 0, its other variables are among those of the box, radius > 0.
RootBound all_roots_inside(const Polynomial& p, const std::string& root, const Rational& radius, const Box& box = {},
                           const SignOptions& options = {});

}  // namespace twoscale::analysis
