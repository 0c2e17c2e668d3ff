// SPDX-License-Identifier: GPL-3.0-or-later
// Any stationary mask.
#include <algorithm>

#include "recipes.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::families {

namespace {

Scheme stationary_mask(const SchemeName& name) {
  const int arity = arity_key(name);
  std::string text = trimmed(name.keys.at("coefficients"));
  if (text.size() >= 2 && text.front() == '[' && text.back() == ']') text = text.substr(1, text.size() - 2);
  const auto pieces = split_list(text);
  if (pieces.empty()) bad_input("mask: no coefficients", name.keys.at("coefficients"));
  if (pieces.size() > 4096) bad_input("mask: too many coefficients", std::to_string(pieces.size()));
  std::vector<RationalFunction> c;
  for (const auto& p : pieces) c.push_back(parse_rational_function(p));
  const long length = static_cast<long>(c.size());
  const bool given = name.keys.contains("lowest");
  const Laurent a(given ? integer_key(name, "lowest", -1000000, 1000000) : -((length - 1) / 2), std::move(c));
  std::vector<Parameter> parameters;
  for (const auto& v : a.variables()) parameters.push_back({v, Parameter::Scope::constant, std::nullopt});
  Scheme s = Scheme::from_symbol(name.to_string(), a, arity, std::move(parameters));
  s.title = "stationary mask";
  return s;
}

}  // namespace

void add_mask(std::vector<CatalogEntry>& list) {
  list.push_back({"mask",
                  "any stationary mask; names in the coefficients are constant parameters",
                  "",
                  {{"coefficients", "comma list of expressions", true},
                   {"lowest", "index of the first; centred if absent", false},
                   {"arity", "arity m, 2 if absent", false}},
                  {"mask:coefficients=\"1/8,1/2,3/4,1/2,1/8\",lowest=-2", "mask:coefficients=\"1/4,3/4,3/4,1/4\"",
                   "mask:coefficients=\"-w,0,1/2+w,1,1/2+w,0,-w\",lowest=-3"},
                  stationary_mask});
}

}  // namespace twoscale::families
