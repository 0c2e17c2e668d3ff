// SPDX-License-Identifier: GPL-3.0-or-later
// Names to schemes: ID[:key=value[,key=value...]] (contract §3).
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "twoscale/symbolic/scheme.hpp"

namespace twoscale {

// A parsed scheme name. Values keep the user's text without its quotes.
struct SchemeName {
  std::string id;
  std::map<std::string, std::string> keys;
  // Canonical spelling: keys in alphabetical order, values that contain commas quoted.
  std::string to_string() const;
};
// A piece between commas that does not begin with name= belongs to the value before it; commas inside ( ), [ ] or
// quotes never split. Throws Error(bad_input) naming a piece that cannot be read or a key given twice.
SchemeName parse_scheme_name(std::string_view text);

struct CatalogEntry {
  struct Key {
    std::string name;
    std::string help;
    bool required;
  };
  std::string id;
  std::string summary;
  std::string source;
  std::vector<Key> keys;
  std::vector<std::string> examples;  // instances the contract suite runs over
  std::function<Scheme(const SchemeName&)> recipe;
};

const std::vector<CatalogEntry>& catalog();

// `text` is a name of the catalogue, or the path of a scheme file (it ends in .toml, or has a slash), which may be
// followed by :NAME=VALUE,... for its constant parameters. Throws Error(bad_input) naming an unknown id, key or
// unusable value, or file, line and text; Error(io) for a file that cannot be read.
Scheme make_scheme(std::string_view text);

// The spaces of the families of romani2009: {1..x^n, e^{+-tx}} (3), {1, x, e^{+-jtx}, j <= n} (9),
// {1, x, x^r e^{+-tx}, r < n} (13). family: mixed, harmonic, resonant.
Space family_space(const std::string& family, unsigned n);
// n of the member whose space has dimension 2l: 2l-3, l-1, l-1.
unsigned family_member(const std::string& family, unsigned l);

}  // namespace twoscale
