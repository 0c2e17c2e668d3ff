// SPDX-License-Identifier: GPL-3.0-or-later
#include "local_values.hpp"

#include <algorithm>

#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::cli {

std::vector<RationalFunction> expression_list(const std::string& name, const std::string& text) {
  std::string inner = trimmed(text);
  if (inner.size() >= 2 && inner.front() == '[' && inner.back() == ']') inner = inner.substr(1, inner.size() - 2);
  std::vector<RationalFunction> list;
  for (const auto& piece : split_list(inner)) {
    if (piece.empty()) bad_input("--at: a value is missing", name + "=" + text);
    list.push_back(parse_rational_function(piece));
  }
  if (list.empty()) bad_input("--at: a value is missing", name + "=" + text);
  return list;
}

void check_local_value(const Scheme& scheme, const Parameter& parameter, const RationalFunction& value) {
  const auto constant = value.constant();
  if (!constant) return;
  const std::string text = parameter.name + "=" + value.to_string();
  if (parameter.domain && !parameter.domain->contains(*constant))
    bad_input("--at: the value lies outside the domain " + parameter.domain->to_string(), text);
  if (parameter.rest) {
    if (constant->sign() < 0 || *constant > Rational(1)) bad_input("--at: an edge parameter must be in [0, 1]", text);
  } else if (!scheme.kernel.empty() && parameter.scope == Parameter::Scope::local && constant->sign() <= 0) {
    bad_input("--at: a knot interval must be positive", text);
  }
}

LocalValues local_values(const Scheme& scheme, const std::vector<std::pair<std::string, std::string>>& at) {
  LocalValues r;
  for (auto one = at.begin(); one != at.end(); ++one) {
    if (std::none_of(scheme.parameters.begin(), scheme.parameters.end(),
                     [&](const auto& p) { return p.name == one->first; })) {
      std::string known;
      for (const auto& p : scheme.parameters) known += (known.empty() ? "" : ", ") + p.name;
      bad_input(
          "--at: " + scheme.id + " has no parameter of this name (it has " + (known.empty() ? "none" : known) + ")",
          one->first);
    }
    if (std::any_of(at.begin(), one, [&](const auto& o) { return o.first == one->first; }))
      bad_input("--at: a value is given twice", one->first);
  }
  for (const auto& p : scheme.parameters) {
    const auto found = std::find_if(at.begin(), at.end(), [&](const auto& a) { return a.first == p.name; });
    std::vector<RationalFunction> list;
    const size_t count = p.scope == Parameter::Scope::local ? p.offsets.size() : 1;
    if (found != at.end()) {
      list = expression_list(p.name, found->second);
      if (list.size() != count)
        bad_input("--at: " + p.name + " takes " + std::to_string(count) + " value" + (count == 1 ? "" : "s") +
                      ", not " + std::to_string(list.size()),
                  found->second);
    } else if (p.rest) {
      list.assign(count, RationalFunction(*p.rest));
    } else if (!p.default_value.empty()) {
      list.assign(count, parse_rational_function(p.default_value));
    } else {
      bad_input("--at: a value is missing", p.name);
    }
    for (size_t i = 0; i < count; ++i) {
      check_local_value(scheme, p, list[i]);
      r.values.emplace_back(p.scope == Parameter::Scope::local ? local_name(p.name, p.offsets[i]) : p.name, list[i]);
    }
    r.given.emplace_back(p.name, std::move(list));
  }
  return r;
}

}  // namespace twoscale::cli
