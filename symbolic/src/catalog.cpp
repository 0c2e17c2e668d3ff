// SPDX-License-Identifier: GPL-3.0-or-later
// Names to schemes. The recipes are in families/, one family a file. To add a scheme: one entry in a file there, with
// its keys, examples, source and claims; the contract suite (tests/catalog) then runs over it by construction.
#include "twoscale/symbolic/catalog.hpp"

#include <algorithm>
#include <cctype>

#include "families/recipes.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale {

namespace {

bool starts_with_key(const std::string& piece) {
  size_t i = 0;
  while (i < piece.size() && (std::isalnum(static_cast<unsigned char>(piece[i])) != 0 || piece[i] == '_')) ++i;
  return i > 0 && i < piece.size() && piece[i] == '=' && std::isalpha(static_cast<unsigned char>(piece[0])) != 0;
}

std::string unquoted(std::string s) {
  s = trimmed(s);
  if (s.size() >= 2 && s.front() == '"' && s.back() == '"') s = s.substr(1, s.size() - 2);
  return s;
}

// The path of a scheme file and what follows it (":key=value,..." or nothing), if that is what `text` names: it has
// .toml at its end or before a colon, or a slash before its first colon.
std::optional<std::pair<std::string, std::string>> scheme_path(std::string_view text) {
  const std::string whole = trimmed(text);
  if (whole.ends_with(".toml")) return std::pair(whole, std::string());
  auto colon = whole.find(".toml:");
  if (colon != std::string::npos)
    colon += 5;
  else if (colon = whole.find(':'); whole.substr(0, colon).find('/') == std::string::npos)
    return std::nullopt;
  return std::pair(whole.substr(0, colon), colon == std::string::npos ? "" : whole.substr(colon));
}

// No quote is left and every bracket has its partner; otherwise the canonical spelling would be split elsewhere.
bool balanced(const std::string& s) {
  long depth = 0;
  for (const char c : s) {
    if (c == '(' || c == '[') ++depth;
    if (c == ')' || c == ']') --depth;
    if (depth < 0 || c == '"') return false;
  }
  return depth == 0;
}

std::vector<CatalogEntry> build_catalog() {
  std::vector<CatalogEntry> list;
  families::add_bsplines(list);
  families::add_interpolating(list);
  families::add_quasi_splines(list);
  families::add_mask(list);
  families::add_files(list);
  families::add_hermite(list);
  families::add_nuli(list);
  return list;
}

}  // namespace

std::string SchemeName::to_string() const {
  std::string s = id;
  char join = ':';
  for (const auto& [key, value] : keys) {
    const bool quote = value.find(',') != std::string::npos;
    s += join + key + "=" + (quote ? "\"" + value + "\"" : value);
    join = ',';
  }
  return s;
}

SchemeName parse_scheme_name(std::string_view text) {
  SchemeName name;
  const std::string whole = trimmed(text);
  const auto colon = whole.find(':');
  name.id = trimmed(whole.substr(0, colon));
  if (name.id.empty()) bad_input("scheme name is empty", whole);
  if (colon == std::string::npos) return name;
  std::string key;
  for (const auto& piece : split_list(std::string_view(whole).substr(colon + 1))) {
    if (starts_with_key(piece)) {
      const auto equals = piece.find('=');
      key = piece.substr(0, equals);
      if (!name.keys.emplace(key, piece.substr(equals + 1)).second) bad_input("key is given twice in scheme name", key);
    } else {
      if (key.empty()) bad_input("scheme name: expected key=value", piece);
      name.keys[key] += "," + piece;
    }
  }
  for (auto& [k, value] : name.keys) {
    value = unquoted(value);
    if (!balanced(value)) bad_input("quotes or brackets do not match in scheme name", value);
  }
  return name;
}

const std::vector<CatalogEntry>& catalog() {
  static const std::vector<CatalogEntry> list = build_catalog();
  return list;
}

const CatalogEntry& families::entry_of(const SchemeName& name) {
  const auto& list = catalog();
  const auto entry = std::find_if(list.begin(), list.end(), [&](const auto& e) { return e.id == name.id; });
  if (entry == list.end())
    bad_input("unknown scheme (twoscale list prints them; a scheme file has a name that ends in .toml)", name.id);
  for (const auto& [key, value] : name.keys)
    if (std::none_of(entry->keys.begin(), entry->keys.end(), [&, &k = key](const auto& e) { return e.name == k; }))
      bad_input(name.id + ": unknown key", key);
  for (const auto& k : entry->keys)
    if (k.required && !name.keys.contains(k.name)) bad_input(name.id + ": key is missing", k.name);
  return *entry;
}

Scheme make_scheme(std::string_view text) {
  if (const auto file = scheme_path(text))
    return families::scheme_of_file(SchemeFile::load(file->first), parse_scheme_name("file" + file->second));
  const SchemeName name = parse_scheme_name(text);
  return families::entry_of(name).recipe(name);
}

Space family_space(const std::string& family, unsigned n) {
  if (family == "mixed") return Space::one_frequency(n + 1, {{1, 1}});
  if (family == "resonant") return Space::one_frequency(2, {{1, n}});
  if (family == "harmonic") {
    std::vector<std::pair<unsigned, unsigned>> multiples;
    for (unsigned j = 1; j <= n; ++j) multiples.emplace_back(j, 1);
    return Space::one_frequency(2, multiples);
  }
  bad_input("unknown family (mixed, harmonic, resonant)", family);
}

unsigned family_member(const std::string& family, unsigned l) { return family == "mixed" ? 2 * l - 3 : l - 1; }

}  // namespace twoscale
