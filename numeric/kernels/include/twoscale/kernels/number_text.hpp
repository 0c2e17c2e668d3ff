// SPDX-License-Identifier: 0BSD
// Numbers in and out of text, independent of the locale.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace twoscale::kernels {

/// Longest number (in characters) and largest |exponent| that are read; longer ones are refused.
inline constexpr std::size_t max_number_length = 32768;
inline constexpr int max_number_exponent = 9999;

/// True for a decimal: [+-] digits [. digits] [e [+-] digits], with at least one digit before or after the point,
/// within the two limits above. No blanks, no "nan", "inf", hexadecimal or fractions.
bool is_decimal(std::string_view text);

/// The double nearest to the decimal `text` (correctly rounded, also to zero); nothing when `text` is not a decimal or
/// does not fit (overflow).
std::optional<double> parse_double(std::string_view text);

/// The shortest decimal that reads back as `value` (finite or not).
std::string shortest(double value);

/// `value` as a hexadecimal floating literal of C99 and C++17: "0x1.8p-1", "-0x1p+0", "0x0p+0".
std::string hex_float(double value);

}  // namespace twoscale::kernels
