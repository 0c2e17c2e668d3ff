// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker of certificates. The door: text in, report out. Format: docs/certificates.md.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace twoscale::check {

struct Report {
  enum Status { valid, invalid, malformed };
  Status status = malformed;
  std::vector<std::string> lines;  ///< for people: the label, one line a claim, the theorems trusted, the verdict
  std::string message;     ///< valid: empty; invalid: the first claim refused and why; malformed: the offending piece
  std::uint64_t work = 0;  ///< units of work spent, the same on every machine
};

/// About half a minute.
inline constexpr std::uint64_t default_work = 30'000'000'000;

/// Checks a certificate from its bytes alone. Never throws; ends for any input: what needs more than `work` units
/// (about one word operation, at most a nanosecond, each) is malformed.
Report check_text(std::string_view text, std::uint64_t work = default_work);

/// FNV-1a, 64 bits, as `fnv1a64:` and 16 lower-case hexadecimal digits.
std::string digest(std::string_view text);

/// The canonical text of a certificate whose digest is the empty string, with the digest filled in.
std::string sealed(std::string_view canonical_text_with_empty_digest);

}  // namespace twoscale::check
