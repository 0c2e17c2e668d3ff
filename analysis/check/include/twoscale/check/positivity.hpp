// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Signs of polynomials on boxes, some sides of which may be half-lines.
#pragma once

#include "twoscale/check/json.hpp"
#include "twoscale/check/number.hpp"
#include "twoscale/check/polynomial.hpp"
#include "twoscale/check/univariate.hpp"

#include <optional>
#include <string>
#include <vector>

namespace twoscale::check {

/// low <= x <= high, low < high; without `high` the half-line x >= low.
struct Side {
  Fraction low;
  std::optional<Fraction> high;
  bool zero_low = false;   ///< nothing strict is claimed on the face x = low
  bool zero_high = false;  ///< the same for x = high
};

struct Box {
  std::vector<std::string> names;  ///< distinct, ascending
  std::vector<Side> sides;
};

/// [A-Za-z][A-Za-z0-9_]*, at most 64 characters.
bool is_variable_name(const std::string& name);

/// Reads `variables`, `box`; sorted names, sides with low < high.
Box read_box(Fields& fields, Meter& meter);
/// Reads `zeros`: faces "x=lo", "x=hi" of the box, distinct, ascending; marks them.
void read_zeros(Fields& fields, Box& box);
/// Reads a point, one number for each variable, which must lie in the box.
std::vector<Fraction> read_point(const Value& at, const Box& box, const std::string& where, Meter& meter);
/// Does the point lie on a face where nothing strict is claimed?
bool on_excluded_face(const std::vector<Fraction>& point, const Box& box);

/// Verifies p >= 0 on the box and, if strict, p > 0 off the excluded faces; throws Refused. The variables of p are
/// those of the box, in their order.
void require_positive(const Polynomial& p, const Box& box, bool strict, const std::string& method,
                      const std::string& tree, const std::string& where, Meter& meter);

/// p(point) times a positive number.
Integer scaled_value(const Polynomial& p, const std::vector<Fraction>& point, Meter& meter);
/// Is p(point) = value?
bool value_is(const Polynomial& p, const std::vector<Fraction>& point, const Fraction& value, Meter& meter);

/// The only variable that occurs in p, if there is exactly one.
std::optional<std::size_t> only_variable(const Polynomial& p);
/// p as a polynomial in this variable.
Dense dense_in(const Polynomial& p, std::size_t variable);
/// Number of distinct zeros of p (not zero) in the open interval from low to high, or to infinity.
int zeros_between(const Dense& p, const Fraction& low, const std::optional<Fraction>& high, Meter& meter);

/// For messages: "0 <= x <= 1, y >= 2"; long numbers abridged.
std::string text_of(const Box& box);
std::string text_of(const Fraction& value);

/// Is a < b?
bool less(const Fraction& a, const Fraction& b, Meter& meter);

}  // namespace twoscale::check
