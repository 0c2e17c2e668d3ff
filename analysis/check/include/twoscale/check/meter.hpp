// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Exact integers, the two ways a check can fail, and the limits on its work.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace twoscale::check {

using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

/// The document is not a certificate of the format, or asks for more work than the limits allow.
struct Malformed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A claim of a well-formed certificate does not hold, or is not established by the means of the format.
struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Limits of the format (docs/certificates.md).
namespace limits {
inline constexpr std::size_t file_bytes = std::size_t{64} << 20;
inline constexpr std::size_t json_values = 1'000'000;
inline constexpr int depth = 16;
inline constexpr std::size_t number_chars = 200'000;
inline constexpr long index = 1'000'000;
inline constexpr std::size_t variables = 8;
inline constexpr int degree = 4096;
inline constexpr std::size_t mask_length = 4096;
inline constexpr long order = 512;
inline constexpr std::size_t list_items = 4096;
inline constexpr std::size_t matrix = 256;                       // rows
inline constexpr std::uint64_t work = 30'000'000'000;            // word operations
inline constexpr std::uint64_t memory = std::uint64_t{1} << 30;  // bytes
}  // namespace limits

/// Counts work and memory instead of time, so that the answer for a file is the same on every machine.
class Meter {
 public:
  explicit Meter(std::uint64_t work = limits::work, std::uint64_t memory = limits::memory)
      : work_(work), memory_(memory) {}

  /// Accounts for `units` of work (about one word operation each); throws Malformed when the limit is passed.
  void spend(std::uint64_t units);
  /// Accounts for `bytes` kept in memory until the end; throws Malformed when the limit is passed.
  void hold(std::uint64_t bytes);
  /// Work left.
  std::uint64_t left() const { return work_; }

  /// a*b, accounted for.
  Integer multiply(const Integer& a, const Integer& b);
  /// base^exponent, accounted for before it is computed.
  Integer power(const Integer& base, std::uint64_t exponent);
  /// gcd(a, b) >= 0, accounted for.
  Integer gcd(const Integer& a, const Integer& b);

 private:
  std::uint64_t work_;
  std::uint64_t memory_;
};

/// Number of machine words of |a|, at least 1.
inline std::uint64_t words(const Integer& a) { return a.backend().size(); }

}  // namespace twoscale::check
