// SPDX-License-Identifier: 0BSD
// The one error type of the kernels: a line of text that names the offending piece.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace twoscale::kernels {

/// What the kernels throw. `what()` is one line, without a final newline or full stop, and names the offending piece
/// (file, line, text). Callers branch on `kind`, never on the message.
struct Error : std::runtime_error {
  enum class Kind {
    bad_input,  ///< the data or arguments cannot be used
    io          ///< a file could not be read or written
  };

  Error(Kind error_kind, const std::string& message) : std::runtime_error(message), kind(error_kind) {}

  Kind kind;
};

/// `text` in single quotes, fit for a one-line message: bytes outside printable ASCII become \xNN, and at most
/// `max_length` bytes are shown (then "...").
std::string quoted(std::string_view text, std::size_t max_length = 60);

}  // namespace twoscale::kernels
