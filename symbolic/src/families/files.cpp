// SPDX-License-Identifier: GPL-3.0-or-later
// Schemes that are data: the files of symbolic/schemes, and those of users. A constant parameter is a key.
#include "recipes.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"
#include "twoscale/symbolic/scheme_file.hpp"

namespace twoscale::families {

namespace {

std::vector<CatalogEntry::Key> keys_of(const SchemeFile& file) {
  std::vector<CatalogEntry::Key> keys;
  for (const auto& p : file.parameters()) {
    if (p.scope.text != "constant") continue;
    std::string help = p.help.present() ? p.help.text : "parameter";
    if (p.domain.present()) help += "; in " + p.domain.text;
    if (p.default_value.present()) help += "; " + p.default_value.text + " by default";
    keys.push_back({p.name.text, help, false});
  }
  return keys;
}

}  // namespace

Scheme scheme_of_file(const SchemeFile& file, SchemeName name) {
  name.id = file.name();
  const auto known = keys_of(file);
  std::vector<std::pair<std::string, RationalFunction>> values;
  for (auto& [key, text] : name.keys) {
    if (std::none_of(known.begin(), known.end(), [&, &k = key](const auto& e) { return e.name == k; }))
      bad_input(name.id + ": no constant parameter is called so", key);
    const auto value = parse_rational_function(text).constant();
    if (!value) bad_input(name.id + ": " + key + " must be a rational number (others by --at)", text);
    values.emplace_back(key, *value);
    text = value->to_string();
  }
  Scheme s = with_values(file.scheme(), values);
  s.id = name.to_string();
  return s;
}

void add_files(std::vector<CatalogEntry>& list) {
  for (const auto& [name, text] : embedded_scheme_files()) {
    const SchemeFile file = SchemeFile::parse(text, name + ".toml");
    CatalogEntry e;
    e.id = file.name();
    e.summary = file.title();
    e.source = file.source();
    e.keys = keys_of(file);
    e.examples.push_back(e.id);
    for (const auto& p : file.parameters())
      if (p.scope.text == "constant" && p.default_value.present())
        e.examples.push_back(SchemeName{e.id, {{p.name.text, p.default_value.text}}}.to_string());
    e.recipe = [&text = text, path = name + ".toml"](const SchemeName& given) {
      return scheme_of_file(SchemeFile::parse(text, path), given);
    };
    list.push_back(std::move(e));
  }
}

}  // namespace twoscale::families
