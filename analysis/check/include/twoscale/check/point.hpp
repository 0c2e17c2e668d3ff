// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Values of the mask and of its coset sums at a rational point (witnesses).
#pragma once

#include "twoscale/check/certificate.hpp"

#include <optional>
#include <string>
#include <vector>

namespace twoscale::check {

/// A point: for a level variable a rational Y != 0 with E = Y^q, v = (E + 1/E)/2; for a constant its value.
class Point {
 public:
  /// Reads "at"; the denominator must not vanish there (Refused).
  Point(const Value& at, const Certificate& certificate, const std::string& where, Meter& meter);

  /// Is a_i at the point equal to `value`?
  bool coefficient_is(long index, const Fraction& value);
  /// Is the sum over i = residue (mod m) of w^power a_i z^w equal to `value`, w = i - e if centred, else i?
  bool sum_is(const std::vector<long>& frequency, long power, long residue, bool centred, const Fraction& value);
  /// `v = 5/4, c = 1` made from the data.
  std::string text() const;

 private:
  Integer evaluate(const Polynomial& p);

  const Certificate& certificate_;
  Meter& meter_;
  std::vector<Fraction> at_;                       // as read
  std::vector<std::vector<Integer>> numerator_;    // powers of the numerator of each variable, up to its degree
  std::vector<std::vector<Integer>> denominator_;  // the same for the denominator
  std::vector<std::optional<Integer>> value_;      // numerators of the mask, over a common factor
  Integer mask_denominator_;                       // the denominator of the mask, over the same factor
};

}  // namespace twoscale::check
