// SPDX-License-Identifier: GPL-3.0-or-later
// Exponential quasi-splines (jeong2013): exponential B-splines times a short factor, so that they reproduce more.
//
//   paper (jeong2013)                     here
//   Lambda, N                             space, its dimension (closed under sign, so N odd has a 0)
//   Lambda°, 2M                           reproduced
//   beta_N of (3), centred on 0 or -1/2   beta, centred on 0 (N even: primal) or 1/2 (N odd: dual)
//   gamma_n = 2 cosh(lambda_n/2^{k+1})    nodes; x = z + 1/z
//   q_M of (24)                           q
//   beta_{j,k} of (19)                    value of z^{-p} beta(z) at z_j = e^{-lambda_j/2^{k+1}}, p = 0 or 1/2
//
// With S(x) = 2^{1-N} prod_{n <= N/2} (x + gamma_n): beta = S(x) for N even, z^{1/2} (z^{1/2} + z^{-1/2}) S(x) for N
// odd. The scheme reproduces Lambda° iff a(z) - 2 z^p vanishes at the z_j as often as lambda_j stands in Lambda° (the
// zeros at -z_j are beta's), that is iff q is a Hermite interpolant:
//   S(x) q(x) = F(x)  modulo  prod_i (x - gamma_i),   F = 2 (N even),   F = 2/(z^{1/2} + z^{-1/2}) (N odd).
// A pair of zeros of Lambda° is one condition, for x = 2 is a critical point of z -> x: order r in x is order 2r in z.
// So
//   - what reproduces 1..x^{2r} and generates x^{2r+1} reproduces that too: an odd power is completed;
//   - for N odd, Lambda° may contain the last zero of Lambda, which has no partner (2M = N + 1 at most).
// For N odd F takes the values 1/h, h = cosh(lambda/2^{k+2}), which are rational in the level variable of half the
// frequency only: if an odd multiple of a greatest common frequency t stands in Lambda°, v belongs to t/2.
//
// Solvable at a step iff gamma_i + gamma_j != 0 for all lambda_i in Lambda°, lambda_j in Lambda and, for N odd, no h_i
// and no sum h_i + h_j of Lambda° vanishes (Theorem 5.1 says "unique" without that). All these are positive if all
// frequencies are real, or below pi in size.
#pragma once

#include "twoscale/symbolic/interpolatory.hpp"

namespace twoscale {

struct QuasiSpline {
  Space space;                                        // Lambda, in the level variables of the mask
  Space reproduced;                                   // Lambda°, completed, in the same
  Laurent beta;                                       // (3)
  std::vector<Polynomial> nodes;                      // gamma_0..gamma_{M-1} of Lambda°
  std::vector<std::vector<RationalFunction>> matrix;  // row r: [gamma_m..gamma_r]S, m <= r; lower triangular
  std::vector<RationalFunction> rhs;                  // [gamma_0..gamma_r]F
  std::vector<RationalFunction> solution;             // q = sum_m solution[m] prod_{i<m} (x - gamma_i)
  RationalFunction determinant;                       // prod_r S(gamma_r)
  Laurent q;                                          // centred on 0
  Laurent mask;                                       // beta q
  SingularSet singular;                               // where a step fails

  size_t order() const { return space.dimension(); }  // N
  size_t terms() const { return nodes.size(); }       // M
};

// Throws Error(bad_input) if `reproduced` is empty or not contained in `space`, naming what is not. Spaces may stand in
// the level variables of another scheme (Space::rebase); they are refined where halves are needed.
// Cost: O(M^2 + N M) polynomial products.
QuasiSpline quasi_spline(const Space& space, const Space& reproduced);

// prod_{i<M} (x - gamma_i), the direction that Lambda° leaves free: the symmetric masks beta q with q of degree M in x
// that reproduce Lambda° are beta (q_M + omega prod (x - gamma_i)). For Lambda° = {1, x} and Lambda = {1, .., x^{N-1}}
// this is (6)-(7), 1 - 2 omega + omega (z + 1/z); for a pair +-lambda_j it is (20), nu = 2/beta_j - omega gamma_j.
Laurent free_factor(const QuasiSpline& s);

// a(z) of what the scheme would do in two steps, read off at the points half way between: d_i = c_{2i+1}, c(z) =
// a^{[k+1]}(z) a^{[k]}(z^2), a dual binary mask in the level variables of half the frequencies (de Rham; Conti and
// Romani 2013 for any arity). `space` and `mask` are refined accordingly. Required: `mask` centred on 0.
struct DeRham {
  Space space;
  Laurent mask;
};
DeRham de_rham_transform(const Space& space, const Laurent& mask);

}  // namespace twoscale
