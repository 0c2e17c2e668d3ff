// SPDX-License-Identifier: GPL-3.0-or-later
// The tension forms of section 6: affine combinations of two symbols that agree on {1, x}.
//
// (26) with gamma_2 = 2v, v = v^{[k+1]}: (1-t) sigma + t zeta, sigma the exponential B-spline of {1, x, exp(+-lambda_2
// x)} normalised to sigma(1) = 2, zeta the 4-point interpolating symbol of that space. (27)-(28): (1-t) (z^{-1} + 2 +
// z)/2 + t zeta; the symbol there is (x + 2)(1 - 2 w x + w x^2)/2 = 1 + (1 - w)(z + 1/z)/2 + w (z^3 + z^{-3})/2, x = z
// + 1/z, w = -t/(gamma_2 (2 + gamma_2)).
#include "twoscale/reports/jeong2013.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::reports::jeong2013 {

Scheme tension_scheme(TensionForm form, const std::string& t) {
  const std::string space = "1, x, exp(t*x), exp(-t*x)";
  const Scheme interpolating = make_scheme("interpolating:space=\"" + space + "\"");
  const Scheme other =
      make_scheme(form == TensionForm::spline ? "exponential-bspline:space=\"" + space + "\"" : "bspline:n=1");
  const RationalFunction at = parse_rational_function(t);
  const Laurent mask = symbol(other) + at * (symbol(interpolating) - symbol(other));
  Scheme s = Scheme::from_symbol((form == TensionForm::spline ? "(26), t = " : "(27)-(28), t = ") + t, mask, 2,
                                 level_parameters(*interpolating.space));
  s.source = form == TensionForm::spline ? "jeong2013 (26)" : "jeong2013 (27)-(28)";
  return s;
}

}  // namespace twoscale::reports::jeong2013
