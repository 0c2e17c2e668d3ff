// SPDX-License-Identifier: GPL-3.0-or-later
// Values of exponential B-splines in balls, for any space and any values of its frequencies.
#pragma once

#include <vector>

#include "twoscale/lowering/lower.hpp"
#include "twoscale/symbolic/ball.hpp"
#include "twoscale/symbolic/space.hpp"

namespace twoscale::lowering {

// phi^{[k]} of symbolic/bspline_function.hpp: integral 1, the abscissa in units of the spacing m^{-k}, moved so that
// its support is [p - N/2, p + N/2] with the shift p of sigma (p = 1/2 for binary schemes of odd order, else 0). Then
// phi^{[k]}(x) = sum_i sigma_i phi^{[k+1]}(m x - i) with sigma as the tables print it.
//
// Green's function is summed as a power series, which knows no confluent case and no complex number:
//   G(x) = sum_r h_r x^{2r+N-1}/(2r+N-1)!,  sum_r h_r y^{2r} = prod over pairs 1/(1 - alpha^2 y^2),
// alpha^2 = (t/m^k)^2 or -(s/m^k)^2. With A = max |alpha| what follows the terms r < R is at most
//   x^{N-1}/(N-1)! (A x)^{2R}/(2R)! / (1 - A x/(2R+1)).
class BsplineFunction {
 public:
  // `binding` has a value for every level variable of the space. Throws Error(bad_input) naming one that is missing.
  BsplineFunction(const Space& space, int arity, const Binding& binding);

  unsigned order() const { return order_; }
  const Rational& shift() const { return shift_; }
  Rational first() const { return shift_ - Rational(static_cast<long>(order_), 2); }  // the ends of the support
  Rational last() const { return shift_ + Rational(static_cast<long>(order_), 2); }

  // Encloses phi^{[k]}(x); exactly 0 outside the support (and at its ends, if the order is at least 2). About `bits`
  // bits after the point are right.
  Ball value(unsigned k, const Rational& x, long bits) const;
  // The correctly rounded double. Throws Error(undecided) if that could not be decided.
  double rounded(unsigned k, const Rational& x) const;

 private:
  struct Pair {
    LevelValue value;
    unsigned multiple;
    unsigned order;
  };
  unsigned order_ = 0;
  unsigned zeros_ = 0;
  int arity_ = 2;
  Rational shift_;
  std::vector<Pair> pairs_;
};

}  // namespace twoscale::lowering
