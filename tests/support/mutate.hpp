// SPDX-License-Identifier: GPL-3.0-or-later
/// Random mutations of a text, for the fuzz tests: the same seed gives the same mutations on every machine.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <random>
#include <string>
#include <string_view>

namespace twoscale::tests {

/// Uniform number in [0, bound), bound > 0. std::uniform_int_distribution differs between standard libraries; this does not.
inline std::size_t below(std::mt19937_64& random, std::size_t bound) {
  return static_cast<std::size_t>(random() % bound);
}

/// One to four random edits of `text`: a character changed, removed, inserted or doubled; a stretch removed or
/// repeated; the end cut off. Characters that are put in come from `alphabet`, which is not empty.
inline std::string mutate(std::string text, std::mt19937_64& random,
                          std::string_view alphabet = "0123456789-+*/^()[]{}\",:. veEt_\n\xff") {
  const std::size_t edits = 1 + below(random, 4);
  for (std::size_t edit = 0; edit < edits; ++edit) {
    const char letter = alphabet[below(random, alphabet.size())];
    if (text.empty()) {
      text.push_back(letter);
      continue;
    }
    const std::size_t at = below(random, text.size());
    const std::size_t length = 1 + below(random, text.size() - at < 32 ? text.size() - at : 32);
    switch (below(random, 7)) {
      case 0: text[at] = letter; break;
      case 1: text.erase(at, 1); break;
      case 2: text.insert(at, 1, letter); break;
      case 3: text.insert(at, 1, text[at]); break;
      case 4: text.erase(at, length); break;
      case 5: text.insert(at, text.substr(at, length)); break;
      default: text.resize(at); break;
    }
  }
  return text;
}

/// Number of mutations of a fuzz test: `base` times the environment variable TWOSCALE_ROUNDS (a positive integer, else 1).
inline std::size_t rounds(std::size_t base) {
  const char* value = std::getenv("TWOSCALE_ROUNDS");
  const unsigned long scale = value == nullptr ? 1 : std::strtoul(value, nullptr, 10);
  return base * (scale == 0 ? 1 : scale);
}

}  // namespace twoscale::tests
