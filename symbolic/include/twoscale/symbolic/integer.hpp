// SPDX-License-Identifier: GPL-3.0-or-later
// A FLINT integer that clears itself; for code that calls fmpz functions directly.
#pragma once

#include <flint/fmpz.h>

#include <string>

namespace twoscale {

struct Integer {
  fmpz_t v;
  Integer() { fmpz_init(v); }
  Integer(const Integer&) = delete;
  Integer& operator=(const Integer&) = delete;
  ~Integer() { fmpz_clear(v); }

  std::string to_string() const {
    char* text = fmpz_get_str(nullptr, 10, v);
    std::string s(text);
    flint_free(text);
    return s;
  }
};

}  // namespace twoscale
