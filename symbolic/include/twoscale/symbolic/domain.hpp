// SPDX-License-Identifier: GPL-3.0-or-later
// Intervals of real numbers: the values that a parameter may have.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "twoscale/symbolic/exact_real.hpp"
#include "twoscale/symbolic/rational.hpp"

namespace twoscale {

// low < high; a missing end is infinite, and an infinite end is open.
struct Domain {
  std::optional<Rational> low;
  std::optional<Rational> high;
  bool low_included = false;
  bool high_included = false;

  // "[0, 1/8]", "(-1, inf)", "(-inf, inf)": rational expressions between brackets. Throws Error(bad_input) naming what
  // is no interval.
  static Domain parse(std::string_view text);
  std::string to_string() const;

  bool contains(const Rational& x) const;
  // Throws Error(undecided) if x cannot be told from an end.
  bool contains(const ExactReal& x) const;

  // { scale*x + offset : x in the interval }; required: scale != 0.
  Domain image(const Rational& scale, const Rational& offset) const;

  friend bool operator==(const Domain&, const Domain&) = default;
};

}  // namespace twoscale
