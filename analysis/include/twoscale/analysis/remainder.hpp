// SPDX-License-Identifier: GPL-3.0-or-later
// From a stationary mask to the matrices whose joint spectral radius is its smoothness.
//
//   a(z) = m (S_m(z)/m)^N b(z), S_m = 1 + ... + z^{m-1}, N maximal, a(1) = m;  c = m b = m^N a/S_m^N.
//   (B_s)_{pq} = c_{n0+1-m+s+p-mq}, s = 0..m-1, 0 <= p, q < max(1, ceil(n0/(m-1)));  rho = JSR(B_0..B_{m-1}).
//   Exponent N - log_m rho (Dyn, Levin 2002; Rioul 1992; Jia 1995).
#pragma once

#include <optional>
#include <vector>

#include "twoscale/analysis/jsr.hpp"
#include "twoscale/symbolic/laurent.hpp"

namespace twoscale::analysis {

struct Remainder {
  long arity = 2;
  long order = 0;           // N: the order of sum rules
  std::vector<Rational> c;  // c_0..c_{n0}, ends not zero
};

// Divides S_m out as often as possible, or exactly `order` times if it is given. Throws Error(bad_input) if a
// coefficient depends on a parameter or a is 0; nullopt if `order` is given and S_m^order does not divide a.
std::optional<Remainder> remainder(const Laurent& a, long arity, std::optional<long> order = std::nullopt);

Family transition_matrices(const Remainder& r);

// The largest value, over the unit circle, of a non-negative trigonometric polynomial grows under z -> z^m like its
// central coefficient (Rioul 1992; Floater, Muntingh 2013): for g_k = g_{-k}, |k| <= h, with sum g_k e^{ikt} >= 0,
//   rho = largest real zero of the minimal polynomial of e_0 under M_{ij} = g_{i-mj} + (j > 0) g_{i+mj}.
struct CentralRadius {
  RealAlgebraic radius;
  bool simple = false;  // a simple zero of the minimal polynomial: the products are bounded after scaling
};
CentralRadius central_radius(const std::vector<Rational>& g, long arity);  // g_0..g_h

// g_0..g_h of the symmetric c of even degree 2h; nullopt if it is not symmetric or of odd degree.
std::optional<std::vector<Rational>> symmetric_half(const std::vector<Rational>& c);
// g_k = sum_i c_i c_{i+k}, k = 0..n0: the coefficients of c(z) c(1/z).
std::vector<Rational> autocorrelation(const std::vector<Rational>& c);
// g_0 + 2 sum g_k T_k(x), times the common denominator, as an integer polynomial in x = cos t.
Polynomial cosine_polynomial(const std::vector<Rational>& g);
// Is p >= 0 on [-1, 1]? Exact. Required: p not 0.
bool nonnegative_on_circle(const Polynomial& p);

// Stability of the integer shifts of the basic limit function (Jia, Wang 1993), a(1) = m and N >= 1 required.
struct Stability {
  bool stable = false;
  bool common_zero = false;  // the sub-symbols share a zero on the unit circle
  long cycle = 0;            // the order n of a cycle of roots of unity, 0 if there is none
};
Stability shift_stability(const Laurent& a, long arity);

}  // namespace twoscale::analysis
