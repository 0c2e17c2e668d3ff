// SPDX-License-Identifier: GPL-3.0-or-later
#include "audit/calculus.hpp"

#include <utility>
#include <vector>

#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::reports::audit {

namespace {

using Values = std::vector<std::pair<std::string, RationalFunction>>;
using Evaluate = std::function<RationalFunction(const std::string&)>;

Values values_of(const std::string& text, const Evaluate& value) {
  Values values;
  for (const std::string& piece : split_list(text)) {
    const std::size_t equals = piece.find('=');
    if (equals == std::string::npos) bad_input("a value name=formula is expected, not", piece);
    values.emplace_back(trimmed(piece.substr(0, equals)), value(piece.substr(equals + 1)));
  }
  return values;
}

RationalFunction at(RationalFunction f, const Values& values) {
  // Through names that no formula has, so that u=v, v=u exchanges the two.
  for (const auto& [name, by] : values) f = f.substitute(name, RationalFunction::variable(name + "_before"));
  for (const auto& [name, by] : values) f = f.substitute(name + "_before", by);
  return f;
}

RationalFunction derivative(const RationalFunction& f, const std::string& name) {
  const Polynomial n = f.numerator(), d = f.denominator();
  return RationalFunction::fraction(n.derivative(name) * d - n * d.derivative(name), d * d);
}

std::map<std::string, RationalFunction> rules(const std::string& name, const std::string& scheme_name,
                                              const Values& values) {
  const Scheme scheme = make_scheme(scheme_name);
  if (scheme.arity != 2 || scheme.phases.size() != 2 || scheme.block < 2)
    bad_input("a scheme of blocks with one new vertex an edge is expected, not", scheme_name);
  const auto block = static_cast<std::size_t>(scheme.block);
  const auto& blocks = scheme.phases[1].blocks;
  if (block * blocks.size() > 10) bad_input("the rule has more than 10 columns:", scheme_name);
  std::map<std::string, RationalFunction> result;
  for (std::size_t vertex = 0; vertex < blocks.size(); ++vertex)
    for (std::size_t i = 0; i < blocks[vertex].size(); ++i)
      result[name + "_" + std::to_string(i / block) + std::to_string((i % block) * blocks.size() + vertex)] =
          at(blocks[vertex][i], values);
  return result;
}

// "A KEYWORD B" -> A, B; the last keyword counts.
std::pair<std::string, std::string> halves(const std::string& text, const std::string& keyword) {
  const std::size_t found = text.rfind(keyword);
  if (found == std::string::npos) return {trimmed(text), ""};
  return {trimmed(text.substr(0, found)), trimmed(text.substr(found + keyword.size()))};
}

}  // namespace

std::optional<std::map<std::string, RationalFunction>> defined_by_operation(const std::string& name,
                                                                            const std::string& body,
                                                                            const Evaluate& value) {
  const std::size_t blank = body.find(' ');
  const std::string operation = body.substr(0, blank);
  if (blank == std::string::npos) return std::nullopt;
  const std::string rest = body.substr(blank + 1);
  std::map<std::string, RationalFunction> result;
  if (operation == "substitute") {
    const auto [formula, list] = halves(rest, " at ");
    if (list.empty()) bad_input("substitute FORMULA at x=F is expected, not", body);
    result[name] = at(value(formula), values_of(list, value));
  } else if (operation == "derivative") {
    const auto [formula, variable] = halves(rest, " by ");
    if (variable.empty()) bad_input("derivative FORMULA by x is expected, not", body);
    result[name] = derivative(value(formula), variable);
  } else if (operation == "rules") {
    const auto [scheme, list] = halves(rest, " at ");
    const Values values = list.empty() ? Values{} : values_of(list, value);
    // The same rules are asked for by many items: computed once.
    thread_local std::map<std::string, std::map<std::string, RationalFunction>> known;
    std::string key = name + "," + scheme;
    for (const auto& [x, f] : values) key += "," + x + "=" + f.to_string();
    const auto found = known.find(key);
    result = found != known.end() ? found->second : known.emplace(key, rules(name, scheme, values)).first->second;
  } else {
    return std::nullopt;
  }
  return result;
}

}  // namespace twoscale::reports::audit
