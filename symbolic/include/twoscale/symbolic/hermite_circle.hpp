// SPDX-License-Identifier: GPL-3.0-or-later
// The rational quintic Hermite interpolant of hermite2010 and the 2-point Hermite rules that follow from it, exactly.
//
// Notation of the paper and of this file
//
//   sigma_i             angular parameter of vertex i, radians
//   a, b                alpha_i = tan(sigma_i/4), alpha_{i+1} (1); the segment lives on t in [(1+a)/2, (1+b)/2]
//   v, u                s_i = tan(sigma_i/8), s_{i+1} (13): a = 2v/(1-v^2), b = 2u/(1-u^2)
//   f, p, r             value, first and second derivative in t, never rescaled between levels
//   mu_k, Q_k           weights (3), control points (5); the segment is sum mu_k Q_k B_k / sum mu_k B_k (4)-(7)
//   columns             f_i, f_{i+1}, p_i, p_{i+1}, r_i, r_{i+1}, as in (9)
//
// The denominator sum_k mu_k B_k(t) is (1 + (2t-1)^2)^2/4 on every segment, so mu_k Q_k is all that is needed: weights
// that are not positive (they exist outside sigma in [-pi, pi]) do no harm. In sigma the segments span
// {1, cos(sigma/2), sin(sigma/2), cos(sigma), sin(sigma), tan(sigma/4)}: circles about a centre, and t itself.
#pragma once

#include <array>

#include "twoscale/symbolic/rational_function.hpp"
#include "twoscale/symbolic/scheme.hpp"

namespace twoscale {

// A linear form in the six data of a segment, in the order of the columns above.
using HermiteForm = std::array<RationalFunction, 6>;
// Rows f, p, r of a new vertex: the matrix Lambda of (8).
using HermiteRule = std::array<HermiteForm, 3>;

// mu_0 .. mu_5 of (3).
std::array<RationalFunction, 6> hermite_circle_weights(const RationalFunction& a, const RationalFunction& b);
// mu_k Q_k of (5), k = 0..5: polynomial in a and b.
std::array<HermiteForm, 6> hermite_circle_weighted_points(const RationalFunction& a, const RationalFunction& b);
// c, c', c'' of Definition 4 at t = (1+x)/2; required: a != b, 1 + x^2 not identically 0.
HermiteRule hermite_circle_segment(const RationalFunction& a, const RationalFunction& b, const RationalFunction& x);

// The rule of one step without tension: the segment at the middle of its sigma-interval, x = (u+v)/(1-uv). Derived from
// Definition 4, not copied from (11), (12); the two agree. Poles: u = v; u or v = 1 or -1; uv = 1; uv = -1.
HermiteRule hermite_circle_rule(const RationalFunction& v, const RationalFunction& u);

// The two tension controls with parameter w > 0.
enum class HermiteTension {
  // As printed in hermite2010 §4: u is replaced by w u + (1-w) v. The limit is G^2 and for w != 1 not C^2: r does not
  // converge (reports/hermite2010/tension.md). Poles at u = (w-1)/w v + 1/w and beyond. Not symmetric under reversal.
  printed,
  // diag(1, 1/w, 1/w^2) times the rule without tension times diag(1, w, w^2): the limit is the interpolant of
  // f, w p, w^2 r, hence C^2 in t with c' = w p, c'' = w^2 r, the same curvature at the vertices for every w, no
  // further
  // pole, symmetric under reversal.
  c2,
};
HermiteRule hermite_circle_rule(const RationalFunction& v, const RationalFunction& u, const RationalFunction& w,
                                HermiteTension tension);

// The scheme of block size 3, with a local parameter s (its values s_0, s_1 at the two ends of an edge) and a constant
// parameter w. Phase 0 keeps a vertex, phase 1 is the rule on the edge [0, 1].
Scheme hermite_circle(const Rational& w, HermiteTension tension);
// Which of the two a scheme is, told by its stencils; nullopt if neither.
std::optional<HermiteTension> hermite_tension(const Scheme& scheme);

}  // namespace twoscale
