// SPDX-License-Identifier: GPL-3.0-or-later
// The one error type of the exact rooms: what went wrong, and the piece of input that is to blame.
#pragma once

#include <stdexcept>
#include <string>

namespace twoscale {

struct Error : std::runtime_error {
  enum class Kind {
    bad_input,  // the request cannot be understood or has no meaning (exit status 2)
    undecided,  // a limit was reached before the answer (exit status 3)
    io,         // a file could not be read or written (exit status 4)
  };

  Error(Kind k, const std::string& message, std::string piece = {})
      : std::runtime_error(piece.empty() ? message : message + ": " + piece), kind(k), offending(std::move(piece)) {}

  Kind kind;
  std::string offending;  // the offending text, as the user wrote it; may be empty
};

[[noreturn]] inline void bad_input(const std::string& message, std::string piece = {}) {
  throw Error(Error::Kind::bad_input, message, std::move(piece));
}

}  // namespace twoscale
