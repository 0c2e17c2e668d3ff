// SPDX-License-Identifier: GPL-3.0-or-later
// How the values of a level parameter are tied: g^{[k]} = P(g^{[k+1]}), a polynomial P with rational coefficients.
//
// Every such parameter is rewritten as g = scale*v + offset with a variable v that tends to 1, so that the limit of a
// mask is its value at v = 1 whatever the relation is:
//   P affinely conjugate to T_m (m the arity):  v^{[k]} = T_m(v^{[k+1]}), v = cosh(theta/m^{k+1}): a frequency
//   else:                                       v^{[k]} = R(v^{[k+1]}), R(1) = 1, R'(1) > 1
// In the second case v^{[k+1]} = G(v^{[k]}) with the branch G of the inverse of R that fixes 1. What is proved of it
// (exactly, by Sturm): on the branch R is strictly increasing, the domain of v^{[0]} lies in its image, and 1 is the
// only fixed point there. Then G moves every value of the domain towards 1, monotonically, and |v^{[k]} - 1| decreases
// like R'(1)^{-k}: the sum over k is finite.
#pragma once

#include <optional>
#include <string>

#include "twoscale/symbolic/domain.hpp"
#include "twoscale/symbolic/rational_function.hpp"

namespace twoscale {

// g = scale*v + offset: how a user spells a variable of ours.
struct Spelling {
  std::string name;
  Rational scale = 1;
  Rational offset = 0;
  bool is_identity() const { return scale == Rational(1) && offset.is_zero(); }
};

struct LevelRelation {
  Spelling spelling;
  bool frequency = false;       // R = T_m: v is the cosh of a frequency
  RationalFunction polynomial;  // R, in the variable "x"
  Domain domain;                // of g^{[0]}, in the user's spelling
};

// From g^{[k]} = coarse(g^{[k+1]}), `name` spelling g. Without a domain: that of a frequency, v^{[0]} > -1.
// Throws Error(bad_input) saying what is missing: coarse is no polynomial in `name` alone, or of degree 0 or more than
// 64; no domain for a relation of the second kind; no fixed point that attracts, only an irrational one, or several; R
// decreases there; the branch does not reach the whole domain.
LevelRelation level_relation(const std::string& name, const RationalFunction& coarse, int arity,
                             const std::optional<Domain>& domain);

// Number of distinct zeros of p in the open interval, an absent end being infinite. Required: p != 0, at most one
// variable.
long zeros_between(const Polynomial& p, const std::optional<Rational>& low, const std::optional<Rational>& high);

}  // namespace twoscale
