// SPDX-License-Identifier: GPL-3.0-or-later
// Symbols of exponential B-splines and sums of level cosines in factored form.
//
//   paper (romani2009)                        here
//   sigma^k(z) of (2)                         bspline_symbol(space)
//   z^2 + 2 v z + 1 over 2 (v + 1)            pair_factor
#pragma once

#include "twoscale/symbolic/laurent.hpp"
#include "twoscale/symbolic/space.hpp"

namespace twoscale {

// romani2009 (2), for any arity m >= 2:  sigma(z) = m prod_theta S_m(e^{theta/m^{k+1}} z)/S_m(e^{theta/m^{k+1}}),
// S_m(z) = 1 + z + ... + z^{m-1}, written in the level variables of the space, sigma(1) = m.
// Centred on 0 (odd length) or 1/2 (even length: binary spaces of odd order, the dual case).
Laurent bspline_symbol(const Space& space, int arity = 2);

// Moves a symbol so that its support is centred on 0 or 1/2.
Laurent centred(const Laurent& a);

// content * prod factors, the factors irreducible; what w_i + w_j and 1 + w_i become.
struct FactoredPolynomial {
  Rational content = 1;
  RationalFunction::Factors factors;  // sorted
  Polynomial expanded() const;
  void multiply(const FactoredPolynomial& o);
};
// T_a(x) + T_b(y) for the variables of the two nodes. Same variable: products of minimal polynomials of cosines, read
// off from (E^{a+b} + 1)(E^{a-b} + 1)/(2 E^a) without any factoring algorithm.
FactoredPolynomial sum_of_nodes(const Space& space, const Node& a, const Node& b);
// The divided difference T_m[w_a, w_b] = (T_m(w_a) - T_m(w_b))/(w_a - w_b), and T_m'(w_a) for equal nodes: the factor
// of e^{+-theta_b} in an m-ary sigma at the node w_a; 2 (w_a + w_b) for m = 2. It is
//   sinh(m (alpha + beta)/2) sinh(m (alpha - beta)/2) / (sinh((alpha + beta)/2) sinh((alpha - beta)/2)),
// w_a = cosh(alpha), w_b = cosh(beta), so that in one variable its factors are those Phi_d(E) with d | m n and not d |
// n, n = a + b and |a - b|.
FactoredPolynomial chebyshev_difference(const Space& space, const Node& a, const Node& b, int arity);

}  // namespace twoscale
