// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. What a certificate about a 2-point Hermite scheme speaks of, and what is known of it.
#pragma once

#include "twoscale/check/json.hpp"
#include "twoscale/check/number.hpp"
#include "twoscale/check/polynomial.hpp"
#include "twoscale/check/univariate.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace twoscale::check {

/// numerator/denominator, the denominator not the zero polynomial; nothing is cancelled.
struct Ratio {
  Polynomial numerator;
  Polynomial denominator;
};

/// Names of the variables of the rules, of the rates, of the Bezier forms and of polynomials in x, in their order.
inline const std::array<std::string, 4> rule_names{"s_0", "s_1", "w", "z"};
inline const std::array<std::string, 3> rate_names{"d", "s", "w"};
inline const std::array<std::string, 3> bezier_names{"a", "b", "x"};

/// A vertex carries f, p_1, .., p_order; the new vertex of an edge whose ends have the parameters s_0, s_1 has row h of
/// rule(s_0, z, w) applied to f_0, f_1, p_0, p_1, .. of the ends, z = end(s_0, s_1, w); its parameter is the middle:
/// (s_0 + s_1)(1 - s^2) = 2 s (1 - s_0 s_1). An old vertex gets the matrix `old` times itself.
struct HermiteRules {
  std::size_t order = 2;
  Ratio end;
  struct Row {
    std::vector<Polynomial> numerators;  ///< 2 (order + 1): both ends for each derivative
    Polynomial denominator;
  };
  std::vector<Row> rows;  ///< order + 1
  bool kept = false;      ///< `old` is the identity
};

/// What claims so far have established.
struct HermiteFacts {
  struct Interpolant {
    Ratio left, right, middle;  ///< in s_0, w, z
    Dense base;                 ///< the functions are x^j/base^power, j <= degree
    int power = 0;
    long degree = 0;
    Ratio scale;  ///< p_i is scale^i times the i-th derivative in x
  };
  std::optional<Interpolant> interpolant;
  bool fit = false;                           ///< the interpolants of the two halves are those of the edge
  std::optional<std::array<Ratio, 2>> rates;  ///< of the halves, left and right, if they do not fit
};

/// Reads the member `hermite`.
HermiteRules read_hermite(const Value& value, Meter& meter);

}  // namespace twoscale::check
