// SPDX-License-Identifier: GPL-3.0-or-later
// Smoothness along a parameter: for a mask whose remainder is affine in w, where in [a, b] the scheme is C^l.
//
//   what is proved                               how
//   rho(w) = a zero of F(w, x) on a range        the symbol is non-negative at both ends, so in between; F is a factor
//   of
//                                                the central matrix' characteristic polynomial that no other one meets
//   rho(w) = a closed form on a range            an invariant polytope with vertices in Q(w)
//   C^l on [lo, hi], for w constant or not       one polytope for the matrices of both ends
//   not C^l on [lo, hi]                          a product has a real eigenvalue beyond m^{(N-l)n} throughout
// Non-negativity of an affine family holds on an interval, a polytope for both ends serves all of conv{B(lo), B(hi)}.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "twoscale/analysis/regularity.hpp"

namespace twoscale::analysis {

// An interval whose ends are exact.
struct ParameterInterval {
  RealAlgebraic from;
  RealAlgebraic to;
  bool from_included = true;
  bool to_included = true;
};

// On the interval rho(w) is the zero of `polynomial` (in w and x) that `expression` gives, if it is not empty.
struct RadiusRange {
  ParameterInterval interval;
  Polynomial polynomial;
  std::string expression;
  std::string method;
  std::vector<Word> cycles;
};

struct ContinuityRange {
  long l = 0;
  std::vector<ParameterInterval> proved;   // C^l for every constant w
  std::vector<ParameterInterval> refuted;  // rho(w) >= m^{N-l}: not C^l where the integer shifts are stable
  std::optional<ParameterInterval> joint;  // C^l for any sequence of w, one for each level, from this interval
};

struct ParameterRange {
  std::string name;
  Rational from;
  Rational to;
  long order = 0;  // N, for all w at once
  std::vector<RadiusRange> radius;
  std::vector<ContinuityRange> continuity;
  std::vector<std::pair<Rational, Regularity>> samples;        // at equidistant w, ends included
  std::optional<std::pair<Rational, Regularity>> exceptional;  // the w in [from, to] with more than N sum rules
  std::string certificate;
};

struct ParameterOptions {
  RegularityOptions regularity;
  int samples = 17;
  Rational resolution = Rational(1, 65536);  // undecided gaps are at most this part of [a, b] wide
  int threads = 1;
};

// Required: `name` is the only free parameter of the scheme and the scheme is stationary (Error bad_input otherwise).
ParameterRange parameter_range(const Scheme& scheme, const std::string& name, const Rational& from, const Rational& to,
                               const ParameterOptions& options);

}  // namespace twoscale::analysis
