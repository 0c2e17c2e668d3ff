// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. The short list of theorems that it trusts.
#pragma once

#include <span>
#include <string_view>

namespace twoscale::check {

struct Theorem {
  std::string_view key;
  std::string_view source;     ///< where it comes from, for the reader
  std::string_view statement;  ///< in full, in the conventions of the certificate
};

std::span<const Theorem> theorems();
/// The theorem with this key; the key exists.
const Theorem& theorem(std::string_view key);

}  // namespace twoscale::check
