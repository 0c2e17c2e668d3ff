// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/symbolic/scheme.hpp"

#include <algorithm>
#include <cstdlib>

#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale {

std::string local_name(const std::string& name, long offset) {
  return name + (offset < 0 ? "_m" : "_") + std::to_string(std::abs(offset));
}

Scheme Scheme::from_symbol(std::string id, const Laurent& symbol, int arity, std::vector<Parameter> parameters,
                           const std::optional<Rational>& shift) {
  if (symbol.is_zero()) bad_input("the mask is zero", id);
  if (symbol.at_one().is_zero()) bad_input("the mask has sum 0, no parametrisation exists", id);
  std::optional<Rational> centre = symbol.centre_of_symmetry();  // then a'(1)/a(1), whatever the coefficients
  if (shift) {
    centre = *shift * Rational(static_cast<long>(arity) - 1);
  } else if (!centre) {
    std::vector<RationalFunction> weighted;
    for (long i = symbol.lowest(); i <= symbol.highest(); ++i)
      weighted.push_back(RationalFunction(i) * symbol.coefficient(i));
    centre = (Laurent(0, std::move(weighted)).at_one() / symbol.at_one()).constant();
  }
  if (!centre) bad_input("the centre of the mask depends on a parameter", id);
  Scheme s;
  s.id = std::move(id);
  s.arity = arity;
  s.parameters = std::move(parameters);
  s.shift = *centre / Rational(static_cast<long>(arity) - 1);
  for (long r = 0; r < arity; ++r) {
    const Laurent sub = symbol.subsymbol(arity, r);  // sum_j a_{mj+r} z^j, offset h = -j
    Stencil stencil;
    stencil.lowest = sub.is_zero() ? 0 : -sub.highest();
    for (size_t i = sub.coefficients().size(); i-- > 0;) stencil.blocks.push_back({sub.coefficients()[i]});
    s.phases.push_back(std::move(stencil));
  }
  return s;
}

Laurent symbol(const Scheme& scheme) {
  if (scheme.block != 1)
    bad_input("a scheme with blocks has no scalar symbol: not decided or computed here", scheme.id);
  if (!is_uniform(scheme))
    bad_input("a scheme with local parameters has no symbol: not decided or computed here", scheme.id);
  Laurent a;
  for (long r = 0; r < scheme.arity; ++r) {
    const Stencil& s = scheme.phases[static_cast<size_t>(r)];
    if (s.blocks.empty()) continue;
    std::vector<RationalFunction> c;
    for (size_t i = s.blocks.size(); i-- > 0;) c.push_back(s.blocks[i][0]);
    const long highest_offset = s.lowest + static_cast<long>(s.blocks.size()) - 1;
    a = a + Laurent(-highest_offset, std::move(c)).dilated(scheme.arity).shifted(r);
  }
  return a;
}

namespace {

bool has_scope(const Scheme& scheme, Parameter::Scope scope) {
  return std::any_of(scheme.parameters.begin(), scheme.parameters.end(),
                     [&](const auto& p) { return p.scope == scope; });
}

}  // namespace

bool is_uniform(const Scheme& scheme) { return !has_scope(scheme, Parameter::Scope::local); }

bool is_stationary(const Scheme& scheme) { return is_uniform(scheme) && !has_scope(scheme, Parameter::Scope::level); }

bool is_interpolatory(const Scheme& scheme) {
  const Laurent even = symbol(scheme).subsymbol(scheme.arity, 0);
  return even == Laurent::monomial(0);
}

std::vector<LevelVariable> level_variables(const Scheme& scheme) {
  std::vector<LevelVariable> v;
  for (const auto& p : scheme.parameters)
    if (p.frequency) v.push_back(*p.frequency);
  return v;
}

std::vector<std::string> free_parameters(const Scheme& scheme) {
  std::vector<std::string> names;
  for (const auto& p : scheme.parameters)
    if (p.scope == Parameter::Scope::constant || p.relation) names.push_back(p.name);
  return names;
}

std::optional<Laurent> limit_symbol(const Scheme& scheme) {
  Laurent a = symbol(scheme);
  for (const auto& v : scheme.parameters) {
    if (v.scope != Parameter::Scope::level) continue;
    for (const auto& c : a.coefficients())
      for (const auto& [f, e] : c.denominator_factors())
        if (f.substitute(v.name, 1).is_zero()) return std::nullopt;
    a = a.substitute(v.name, 1);
  }
  return a;
}

Scheme with_values(const Scheme& scheme, const std::vector<std::pair<std::string, RationalFunction>>& values) {
  Scheme s = scheme;
  // What is maximal generically need not be so at a chosen value.
  if (!values.empty()) std::erase_if(s.claims, [](const Claim& c) { return c.name == "maximal"; });
  for (const auto& [name, value] : values) {
    const auto found =
        std::find_if(s.parameters.begin(), s.parameters.end(), [&](const auto& p) { return p.name == name; });
    if (found == s.parameters.end()) bad_input("the scheme has no parameter of this name", name);
    if (found->scope == Parameter::Scope::local)
      bad_input("a local parameter has a value for each edge, not one for the scheme", name);
    if (const auto number = value.constant(); number && found->domain && !found->domain->contains(*number))
      bad_input("the value lies outside the domain " + found->domain->to_string(), name + "=" + number->to_string());
    s.parameters.erase(found);
    for (auto& phase : s.phases)
      for (auto& block : phase.blocks)
        for (auto& c : block) {
          for (const auto& [factor, exponent] : c.denominator_factors())
            if (RationalFunction(factor).substitute(name, value).is_zero())
              bad_input("the masks have a pole at this value", name + "=" + value.to_string());
          c = c.substitute(name, value);
        }
    s.id += " at " + name + "=" + value.to_string();
  }
  return s;
}

Scheme with_default_values(const Scheme& scheme) {
  std::vector<std::pair<std::string, RationalFunction>> values;
  for (const auto& p : scheme.parameters) {
    if (p.scope != Parameter::Scope::constant || p.default_value.empty()) continue;
    if (const auto value = parse_real(p.default_value).rational()) values.emplace_back(p.name, *value);
  }
  return with_values(scheme, values);
}

std::vector<Stencil> phases_at(const Scheme& scheme,
                               const std::vector<std::pair<std::string, RationalFunction>>& values) {
  // All at once: a value may contain the name of another parameter.
  std::vector<std::string> names;
  for (const auto& p : scheme.parameters) {
    if (p.scope != Parameter::Scope::local) names.push_back(p.name);
    for (const long offset : p.offsets) names.push_back(local_name(p.name, offset));
  }
  for (const auto& n : names)
    if (std::none_of(values.begin(), values.end(), [&](const auto& v) { return v.first == n; }))
      bad_input("no value is given for this parameter", n);
  const auto renamed = [](const std::string& name) { return "at_" + name; };
  std::vector<std::pair<std::string, Rational>> numbers;
  for (const auto& [n, value] : values)
    if (const auto c = value.constant()) numbers.emplace_back(n, *c);
  const auto put = [&](RationalFunction f) {
    if (numbers.size() == values.size()) {
      const auto c = f.evaluate(numbers);
      if (!c) bad_input("the rule has a pole at these values", scheme.id);
      return RationalFunction(*c);
    }
    for (const auto& n : names) f = f.substitute(n, RationalFunction::variable(renamed(n)));
    for (const auto& [n, value] : values) {
      const std::string name = renamed(n);
      for (const auto& [factor, exponent] : f.denominator_factors())
        if (RationalFunction(factor).substitute(name, value).is_zero())
          bad_input("the rule has a pole at this value", n + "=" + value.to_string());
      f = f.substitute(name, value);
    }
    return f;
  };
  const std::vector<Stencil>* chosen = &scheme.phases;
  for (const auto& piece : scheme.pieces) {
    const RationalFunction where = put(piece.where);
    const auto value = where.constant();
    if (!value) bad_input("which piece of the rule holds depends on the sign of this", where.to_string());
    if (value->sign() < 0) continue;
    chosen = &piece.phases;
    break;
  }
  std::vector<Stencil> result = *chosen;
  for (auto& stencil : result)
    for (auto& block : stencil.blocks)
      for (auto& c : block) c = put(c);
  return result;
}

std::vector<Parameter> level_parameters(const Space& space) {
  std::vector<Parameter> list;
  for (const auto& v : space.variables()) list.push_back({v.name, Parameter::Scope::level, v});
  return list;
}

std::string recurrence(const std::string& variable, int arity) {
  if (arity == 2) return variable + "^{k+1} = sqrt((1 + " + variable + "^k)/2)";
  return variable + "^k = " + Polynomial::chebyshev(variable + "^{k+1}", static_cast<unsigned>(arity)).pretty();
}

std::string recurrence(const Parameter& parameter, int arity) {
  std::string text = parameter.frequency ? recurrence(parameter.name, arity)
                                         : parameter.name + "^k = r(" + parameter.name +
                                               "^{k+1}), r(x) = " + parameter.relation->to_string();
  if (const auto& s = parameter.spelling; s && !(s->is_identity() && s->name == parameter.name))
    text += "; " + s->name + " = " +
            (RationalFunction(s->scale) * RationalFunction::variable(parameter.name) + RationalFunction(s->offset))
                .to_string();
  return text;
}

std::string meaning(const Parameter& parameter, int arity) {
  return parameter.frequency ? parameter.frequency->meaning(arity) : "the value of level k+1";
}

}  // namespace twoscale
