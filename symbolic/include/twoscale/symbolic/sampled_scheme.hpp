// SPDX-License-Identifier: GPL-3.0-or-later
// The 2mu-point rules sampled from fundamental splines of any order n, at numbers (nuli (2.14), (2.17)).
//
// The weights of order n are rational functions of the knot intervals and edge parameters around. Written out they grow
// quickly with n, so a Scheme holds them for small n and equal edge parameters only; at numbers they cost
// O(n^2) B-splines and determinants of size n - 3, whatever n is.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "twoscale/symbolic/nulifs.hpp"
#include "twoscale/symbolic/scheme.hpp"

namespace twoscale {

struct SampledScheme {
  std::string id;
  FundamentalFamily family;  // symmetric(n)
  Rational rest{1, 2};       // place of the auxiliary knot where none is given, in (0, 1)

  // The new point of the edge 0 reads the points lowest() .. highest(),
  long lowest() const { return 1 - static_cast<long>(family.mu); }
  long highest() const { return static_cast<long>(family.mu); }
  // the intervals of the edges lowest() .. last_interval(), and the edge parameters of the edges first_parameter() ..
  // last_parameter() = floor((3n - 10)/2). Why: tau = n - 3 for these families, so the l_{n,tau,q} of (2.7) that are
  // not 0 on the edge 0 have 0 <= q <= n - 3 and their knots are t_{2q-2n+6} .. t_{2q+2}; of u_{i}(x_q) in (2.6) the
  // B-splines from N_{2q-2} on see the same points, so their knots beyond t_{2q+n-3} cancel. For n >= 6 this is not
  // symmetric, and more than (2.17) says.
  long last_interval() const { return std::max(highest() - 1, last_parameter()); }
  long first_parameter() const { return 3 - static_cast<long>(family.order); }
  long last_parameter() const { return family.order == 3 ? 0 : (3 * static_cast<long>(family.order) - 10) / 2; }
  // Are the weights there as functions of the intervals (make_scheme), all edge parameters being `rest`?
  bool symbolic() const;
  // Title, source, parameters and claims; it has no rules (`phases` is empty).
  Scheme outline() const;
  // The weights of the points lowest() .. highest(). d and lambda: the values at the edges they read, d > 0, 0 <=
  // lambda <= 1. At lambda = 0 and 1 (double knots) and 1, 0 side by side (a triple one) they are the limits. Throws
  // Error(bad_input) for other values and sizes.
  std::vector<Rational> weights(const std::vector<Rational>& d, const std::vector<Rational>& lambda) const;
};

// The scheme of this name ("nuli:n=7", "nuli:lambda=1/3,n=6") if it is of this kind. Throws Error(bad_input) as
// make_scheme does for its keys.
std::optional<SampledScheme> sampled_scheme(std::string_view name);

}  // namespace twoscale
