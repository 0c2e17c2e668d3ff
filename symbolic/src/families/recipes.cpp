// SPDX-License-Identifier: GPL-3.0-or-later
#include "recipes.hpp"

#include <algorithm>

#include "twoscale/symbolic/error.hpp"

namespace twoscale::families {

long integer_key(const SchemeName& name, const std::string& key, long least, long greatest) {
  const std::string& text = name.keys.at(key);
  const auto bad = [&] {
    bad_input(
        name.id + ": " + key + " must be an integer from " + std::to_string(least) + " to " + std::to_string(greatest),
        text);
  };
  const bool digits =
      !text.empty() && text.size() < 8 &&
      std::all_of(text.begin() + (text[0] == '-' ? 1 : 0), text.end(), [](char c) { return c >= '0' && c <= '9'; }) &&
      text != "-";
  if (!digits) bad();
  const long value = std::stol(text);
  if (value < least || value > greatest) bad();
  return value;
}

int arity_key(const SchemeName& name) {
  return name.keys.contains("arity") ? static_cast<int>(integer_key(name, "arity", 2, 64)) : 2;
}

// The same scheme has one name: the space in its canonical order, arity 2 not said.
std::string canonical_id(SchemeName name, const Space& space) {
  if (name.keys.contains("space")) name.keys["space"] = space.to_string();
  if (name.keys.contains("arity") && arity_key(name) == 2) name.keys.erase("arity");
  return name.to_string();
}

Space polynomials(unsigned order) { return Space::one_frequency(order, {}); }

}  // namespace twoscale::families
