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

void check_local_value(const Parameter& parameter, const RationalFunction& value) {
  const auto constant = value.constant();
  if (!constant) return;
  if (parameter.rest) {
    if (constant->sign() < 0 || *constant > Rational(1))
      bad_input("--at: an edge parameter must be in [0, 1]", parameter.name + "=" + value.to_string());
  } else if (constant->sign() <= 0) {
    bad_input("--at: a knot interval must be positive", parameter.name + "=" + value.to_string());
  }
}

LocalValues local_values(const Scheme& scheme, const std::vector<std::pair<std::string, std::string>>& at) {
  LocalValues r;
  for (auto one = at.begin(); one != at.end(); ++one) {
    if (std::none_of(scheme.parameters.begin(), scheme.parameters.end(),
                     [&](const auto& p) { return p.name == one->first; })) {
      std::string known;
      for (const auto& p : scheme.parameters) known += (known.empty() ? "" : ", ") + p.name;
      bad_input("--at: " + scheme.id + " has no parameter of this name (it has " + known + ")", one->first);
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
    } else {
      bad_input("--at: a value is missing", p.name);
    }
    for (size_t i = 0; i < count; ++i) {
      if (p.scope == Parameter::Scope::local) check_local_value(p, list[i]);
      r.values.emplace_back(p.scope == Parameter::Scope::local ? local_name(p.name, p.offsets[i]) : p.name, list[i]);
    }
    r.given.emplace_back(p.name, std::move(list));
  }
  return r;
}

}  // namespace twoscale::cli
