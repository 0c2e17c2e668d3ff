// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Rational numbers as text.
#include "twoscale/check/number.hpp"

#include <algorithm>
#include <utility>

namespace twoscale::check {

Integer parse_digits(std::string_view digits, const std::string& where, Meter& meter) {
  const bool all_digits = std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (digits.empty() || !all_digits) throw Malformed(where + ": an integer is expected");
  if (digits.size() > limits::number_chars) throw Malformed(where + ": a number of more than 200000 digits");
  if (digits.front() == '0' && digits.size() > 1) throw Malformed(where + ": a number with a leading zero");
  const std::uint64_t chunks = digits.size() / 19 + 1;
  meter.spend(chunks * chunks + digits.size());
  return Integer(std::string(digits));
}

Fraction parse_fraction(std::string_view text, const std::string& where, Meter& meter) {
  if (text.size() > limits::number_chars) throw Malformed(where + ": a number of more than 200000 characters");
  const bool negative = !text.empty() && text.front() == '-';
  if (negative) text.remove_prefix(1);
  const std::size_t slash = text.find('/');
  Fraction result;
  result.numerator = parse_digits(text.substr(0, slash), where, meter);
  if (slash != std::string_view::npos) {
    result.denominator = parse_digits(text.substr(slash + 1), where, meter);
    if (result.denominator <= 1 || meter.gcd(result.numerator, result.denominator) != 1) {
      throw Malformed(where + ": a fraction that is not in lowest terms");
    }
  }
  if (negative) {
    if (result.numerator == 0) throw Malformed(where + ": \"-0\"");
    result.numerator = -result.numerator;
  }
  return result;
}

Fraction reduced(Integer numerator, Integer denominator, Meter& meter) {
  const Integer divisor = meter.gcd(numerator, denominator);
  if (divisor > 1) {
    meter.spend((words(numerator) + words(denominator)) * words(divisor) + 20);
    numerator /= divisor;
    denominator /= divisor;
  }
  if (denominator < 0) {
    numerator = -numerator;
    denominator = -denominator;
  }
  return {std::move(numerator), std::move(denominator)};
}

int compare(const Fraction& a, const Fraction& b, Meter& meter) {
  return meter.multiply(a.numerator, b.denominator).compare(meter.multiply(b.numerator, a.denominator));
}

Integer floor_quotient(const Integer& a, const Integer& b, Meter& meter) {
  meter.spend(3 * words(a) * words(b) + 20);
  Integer quotient, rest;
  divide_qr(a, b, quotient, rest);
  if (rest < 0) --quotient;
  return quotient;
}

Integer ceil_quotient(const Integer& a, const Integer& b, Meter& meter) {
  meter.spend(3 * words(a) * words(b) + 20);
  Integer quotient, rest;
  divide_qr(a, b, quotient, rest);
  if (rest > 0) ++quotient;
  return quotient;
}

std::string shortened(const std::string& text) { return text.size() <= 200 ? text : text.substr(0, 200) + "..."; }

SmallFraction parse_small_fraction(std::string_view text, const std::string& where, Meter& meter) {
  const Fraction value = parse_fraction(text, where, meter);
  if (abs(value.numerator) > limits::index || value.denominator > limits::index) {
    throw Malformed(where + ": numerator or denominator beyond 1000000");
  }
  return {static_cast<long>(value.numerator), static_cast<long>(value.denominator)};
}

std::string text_of(const SmallFraction& value) {
  std::string text = std::to_string(value.numerator);
  if (value.denominator != 1) text += "/" + std::to_string(value.denominator);
  return text;
}

}  // namespace twoscale::check
