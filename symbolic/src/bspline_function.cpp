// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/symbolic/bspline_function.hpp"

#include <cstdlib>

#include "twoscale/symbolic/error.hpp"

namespace twoscale {

namespace {

// cosh(n theta/m^{k+1}) for the frequency theta of the node.
Polynomial cosh_of(const Space& space, const Node& node, unsigned n) {
  return node.multiple == 0 ? Polynomial(1)
                            : Polynomial::chebyshev(space.variables()[node.variable].name, n * node.multiple);
}

// prod_j S_m(E_j): S_m(E) S_m(1/E) = m + 2 sum_{0 < i < m} (m - i) cosh(i alpha) for a pair, m for a frequency 0.
Polynomial mass(const Space& space, int arity) {
  Polynomial p(1);
  for (const Node& node : nodes(space)) {
    Polynomial pair(arity);
    for (int i = 1; i < arity; ++i)
      pair += Polynomial(2L * (arity - i)) * cosh_of(space, node, static_cast<unsigned>(i));
    p *= pair;
  }
  return space.polynomial_order() % 2 == 1 ? p * Polynomial(arity) : p;
}

}  // namespace

Laurent knot_polynomial(const Space& space, unsigned n) {
  Laurent d = Laurent::monomial(0);
  for (const Node& node : nodes(space))
    d = d * Laurent(0, {1, RationalFunction(Polynomial(-2) * cosh_of(space, node, n)), 1});
  return space.polynomial_order() % 2 == 1 ? d * Laurent(0, {1, -1}) : d;
}

RationalFunction convolution_factor(const Space& space, int arity) {
  return RationalFunction(Rational(static_cast<long>(arity)).pow(-static_cast<long>(space.dimension()))) *
         RationalFunction(mass(space, arity));
}

Laurent two_scale_residual(const Space& space, int arity, const Laurent& mask) {
  if (arity < 2 || arity > 64) bad_input("arity must be between 2 and 64", std::to_string(arity));
  const RationalFunction scale = RationalFunction(mass(space, arity)) * RationalFunction(Rational(1, arity));
  return scale * (mask.shifted(-mask.lowest()) * knot_polynomial(space, 1)) -
         knot_polynomial(space, static_cast<unsigned>(arity)).dilated(arity);
}

}  // namespace twoscale
