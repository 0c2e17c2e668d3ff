// SPDX-License-Identifier: GPL-3.0-or-later
// The local subdivision matrix of a scheme on knots, at a vertex of the data.
//
// After some steps the knot intervals left of the vertex x_0 = 0 are all equal, those right of it too (their ratio is
// alpha = right/left), and only the two edges at the vertex have edge parameters of their own, lambda_{-1} and
// lambda_0; all others have their rest value. The same matrix acts at all later levels (nuli (3.8), Warren 1995).
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "twoscale/analysis/spectrum.hpp"
#include "twoscale/symbolic/sampled_scheme.hpp"
#include "twoscale/symbolic/scheme.hpp"

namespace twoscale::analysis {

struct Junction {
  LocalMatrix matrix;                   // rows and columns -h..h, where the rule maps the points to themselves
  std::vector<RationalFunction> knots;  // x_j = j left of the vertex, alpha j right of it
  long order = 0;                       // x^n is an eigenvector to 2^{-n} for n < order
};

// left, right: the edge parameters lambda_{-1}, lambda_0 (of every parameter that has a rest value). Where they or
// alpha contain variables, `sample` says at which values of these the piece of the rule is chosen; the result holds
// where the same pieces do. Throws Error(bad_input) for a scheme that is not binary, scalar and local, and for a pole
// of the rule.
Junction junction(const Scheme& scheme, const RationalFunction& alpha, const RationalFunction& left,
                  const RationalFunction& right, const std::map<std::string, Rational>& sample = {});

// The same for a rule that is known at numbers only. Throws Error(bad_input) unless alpha > 0, edge parameters in [0,
// 1].
Junction junction(const SampledScheme& scheme, const Rational& alpha, const Rational& left, const Rational& right);

// The spectrum of the junction's matrix.
Spectrum spectrum(const Junction& junction);

}  // namespace twoscale::analysis
