// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Rational numbers as text.
#pragma once

#include "twoscale/check/meter.hpp"

#include <string>
#include <string_view>

namespace twoscale::check {

/// numerator/denominator in lowest terms, denominator > 0.
struct Fraction {
  Integer numerator = 0;
  Integer denominator = 1;
};

/// A run of decimal digits without leading zero (or "0"), at most 200000 of them.
Integer parse_digits(std::string_view digits, const std::string& where, Meter& meter);

/// -?[0-9]+(/[1-9][0-9]*)? in lowest terms, no leading zeros, no "-0", no denominator 1.
Fraction parse_fraction(std::string_view text, const std::string& where, Meter& meter);

/// numerator/denominator in lowest terms; denominator not 0.
Fraction reduced(Integer numerator, Integer denominator, Meter& meter);

/// Sign of a - b.
int compare(const Fraction& a, const Fraction& b, Meter& meter);

/// Floor and ceiling of a/b, b > 0.
Integer floor_quotient(const Integer& a, const Integer& b, Meter& meter);
Integer ceil_quotient(const Integer& a, const Integer& b, Meter& meter);

/// Text from a document for a message: at most 200 characters of it.
std::string shortened(const std::string& text);

/// A fraction whose numerator and denominator are at most 10^6 in absolute value.
struct SmallFraction {
  long numerator = 0;
  long denominator = 1;
};
SmallFraction parse_small_fraction(std::string_view text, const std::string& where, Meter& meter);

/// "3", "-1/2".
std::string text_of(const SmallFraction& value);

}  // namespace twoscale::check
