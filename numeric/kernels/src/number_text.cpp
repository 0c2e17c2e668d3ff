// SPDX-License-Identifier: 0BSD
// Decimal and hexadecimal text of doubles.
#include "twoscale/kernels/number_text.hpp"

#include <bit>
#include <charconv>
#include <cstdint>

namespace twoscale::kernels {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Splits off what is_decimal accepts: the significand is text[0, exponent_at).
struct Shape {
  bool valid = false;
  bool zero = true;  // the significand has no digit but 0
  int exponent = 0;
};

Shape shape_of(std::string_view text) {
  Shape shape;
  if (text.empty() || text.size() > max_number_length) return shape;
  std::size_t i = text[0] == '+' || text[0] == '-' ? 1 : 0;
  std::size_t digits = 0;
  bool point = false;
  for (; i < text.size(); ++i) {
    if (is_digit(text[i])) {
      ++digits;
      if (text[i] != '0') shape.zero = false;
    } else if (text[i] == '.' && !point) {
      point = true;
    } else {
      break;
    }
  }
  if (digits == 0) return shape;
  if (i < text.size()) {
    if (text[i] != 'e' && text[i] != 'E') return shape;
    ++i;
    const bool negative = i < text.size() && text[i] == '-';
    if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
    if (i == text.size()) return shape;
    for (; i < text.size(); ++i) {
      if (!is_digit(text[i])) return shape;
      shape.exponent = shape.exponent * 10 + (text[i] - '0');
      if (shape.exponent > max_number_exponent) return shape;
    }
    if (negative) shape.exponent = -shape.exponent;
  }
  shape.valid = true;
  return shape;
}

}  // namespace

bool is_decimal(std::string_view text) { return shape_of(text).valid; }

std::optional<double> parse_double(std::string_view text) {
  const Shape shape = shape_of(text);
  if (!shape.valid) return std::nullopt;
  if (shape.zero) return text[0] == '-' ? -0.0 : 0.0;
  std::string_view number = text;
  if (number[0] == '+') number.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (error == std::errc() && end == number.data() + number.size()) return value;
  if (error != std::errc::result_out_of_range) return std::nullopt;
  // Out of range on one of two sides: find the decimal exponent of the first nonzero digit.
  const bool negative = number[0] == '-';
  if (negative) number.remove_prefix(1);
  long before_point = 0, leading_zeros = 0;
  bool point = false, nonzero = false;
  for (const char c : number) {
    if (c == '.') {
      point = true;
    } else if (!is_digit(c)) {
      break;
    } else {
      nonzero = nonzero || c != '0';
      if (!point && nonzero) ++before_point;
      if (point && !nonzero) ++leading_zeros;
    }
  }
  const long magnitude = (before_point > 0 ? before_point : -leading_zeros) + shape.exponent;
  if (magnitude > 0) return std::nullopt;
  return negative ? -0.0 : 0.0;
}

std::string shortest(double value) {
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  return error == std::errc() ? std::string(buffer, end) : std::string();
}

std::string hex_float(double value) {
  char buffer[64];
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const bool negative = (bits >> 63) != 0;
  const double magnitude = std::bit_cast<double>(bits & ~(std::uint64_t{1} << 63));
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, magnitude, std::chars_format::hex);
  const std::string digits = error == std::errc() ? std::string(buffer, end) : std::string();
  return (negative ? "-0x" : "0x") + digits;
}

}  // namespace twoscale::kernels
