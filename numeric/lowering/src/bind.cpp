// SPDX-License-Identifier: GPL-3.0-or-later
// Values of parameters: what --v0, --t and --at say (contract §3).
#include <algorithm>

#include "twoscale/lowering/lower.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::lowering {

namespace {

// A frequency: real, or I times a real number.
struct Frequency {
  ExactReal value;
  bool imaginary = false;
};

ExactReal real_number(const GiNaC::ex& e, const std::string& text) {
  try {
    return to_exact_real(e);
  } catch (const Error& error) {
    if (error.kind != Error::Kind::bad_input) throw;
    bad_input("not a real or imaginary number", text);
  }
}

Frequency parse_frequency(const std::string& text) {
  Symbols symbols;
  const GiNaC::ex e = parse_expression(text, symbols);
  if (const auto names = names_in(e); !names.empty()) bad_input("a value must be a number, not " + text, names[0]);
  if (!e.has(GiNaC::I)) return {real_number(e, text), false};
  const GiNaC::ex turned = (-GiNaC::I * e).expand();
  if (turned.has(GiNaC::I)) bad_input("a frequency must be real or imaginary", text);
  return {real_number(turned, text), true};
}

// "v0" of a level variable v, "v0_s" of v_s.
std::string start_name(const Parameter& p) {
  return p.name[0] == 'v' && (p.name.size() == 1 || p.name[1] == '_') ? "v0" + p.name.substr(1) : "v0_" + p.name;
}

class Binder {
 public:
  explicit Binder(const Scheme& scheme) : scheme_(scheme) {
    for (const Parameter& p : scheme.parameters)
      if (p.scope == Parameter::Scope::level) levels_.push_back(&p);
    for (const Parameter* p : levels_)
      if (p->frequency)
        if (const auto value = p->frequency->value()) set_frequency(*p, {*value, false}, p->frequency->frequency());
  }

  void single(const std::string& name, const std::string& text) {
    const std::string option = "--" + name;
    if (levels_.empty() || (name == "t" && level_variables(scheme_).empty()))
      bad_input(scheme_.id + " has no frequency that " + option + " could set", text);
    if (levels_.size() > 1)
      bad_input(option + " needs a single frequency; " + scheme_.id + " has several, name them with --at", text);
    if (name == "v0")
      set_v0(*levels_[0], text);
    else
      set_frequency(*levels_[0], parse_frequency(text), text);
    // --t is the frequency of the level variable, which may be a multiple of the one that was named.
    const auto& frequency = levels_[0]->frequency;
    const bool scaled = name == "t" && frequency && frequency->factor != Rational(1);
    result_.description.emplace_back(scaled ? frequency->frequency() : name, text);
  }

  void named(const std::string& name, const std::string& text) {
    if (!set_level(name, text) && !set_constant(name, text))
      bad_input("unknown parameter of " + scheme_.id + known_names(), name);
    result_.description.emplace_back(name, text);
  }

  Binding take() { return std::move(result_); }

  Binding finish() {
    for (const Parameter& p : scheme_.parameters) {
      const bool level = p.scope == Parameter::Scope::level;
      if (p.scope == Parameter::Scope::local || result_.levels.contains(p.name) || result_.constants.contains(p.name))
        continue;
      if (!p.default_value.empty()) {
        named(p.spelling ? p.spelling->name : p.name, p.default_value);
      } else if (level) {
        bad_input(levels_.size() == 1 ? "a value of v^0 is missing: give --v0 or --t for the frequency"
                                      : "a value is missing: give it with --at " +
                                            (p.spelling    ? p.spelling->name
                                             : p.frequency ? p.frequency->symbol
                                                           : p.name) +
                                            "=... for the frequency",
                  p.frequency ? p.frequency->frequency() : p.spelling->name);
      } else {
        bad_input("a value is missing, give it with --at", p.name);
      }
    }
    return take();
  }

 private:
  bool set_level(const std::string& name, const std::string& text) {
    for (const Parameter* p : levels_)
      if (name == start_name(*p)) return set_v0(*p, text);
    for (const Parameter* p : levels_)
      if (p->spelling && p->spelling->name == name) return set_spelled(*p, text);
    bool found = false;
    for (const Parameter* p : levels_)
      if (p->frequency && !p->frequency->symbol.empty() && p->frequency->symbol == name) {
        Frequency f = parse_frequency(text);
        f.value = ExactReal(p->frequency->factor) * f.value;
        set_frequency(*p, f, text);
        found = true;
      }
    if (found) return true;
    for (const Parameter* p : levels_)
      if (p->frequency && !p->frequency->symbol.empty() && "v0_" + p->frequency->symbol == name)
        return set_v0(*p, text);
    return false;
  }

  bool set_constant(const std::string& name, const std::string& text) {
    for (const Parameter& p : scheme_.parameters)
      if (p.scope == Parameter::Scope::constant && p.name == name) {
        const ExactReal value = parse_real(text);
        require_domain(p, value, name, text);
        if (!result_.constants.emplace(name, value).second) bad_input("parameter is bound twice", name);
        return true;
      }
    return false;
  }

  static void require_domain(const Parameter& p, const ExactReal& value, const std::string& name,
                             const std::string& text) {
    if (p.domain && !p.domain->contains(value))
      bad_input("the value lies outside the domain " + p.domain->to_string() + " of " + name, text);
  }

  std::string known_names() const {
    std::string names;
    const auto add = [&](const std::string& n) { names += (names.empty() ? "" : ", ") + n; };
    for (const Parameter* p : levels_) {
      if (p->frequency && p->frequency->symbol.empty()) continue;
      if (p->frequency) add(p->frequency->symbol);
      add(start_name(*p));
      if (p->spelling && p->spelling->name != start_name(*p)) add(p->spelling->name);
    }
    for (const Parameter& p : scheme_.parameters)
      if (p.scope == Parameter::Scope::constant) add(p.name);
    return names.empty() ? " (it has none)" : " (it has " + names + ")";
  }

  void insert(const Parameter& p, LevelValue value) {
    const std::string shown = p.frequency ? p.frequency->frequency() : p.spelling->name;
    if (p.frequency && p.frequency->symbol.empty() && result_.levels.contains(p.name))
      bad_input("the frequency is fixed by the scheme", shown);
    if (!result_.levels.emplace(p.name, std::move(value)).second) bad_input("parameter is bound twice", shown);
  }

  ExactReal start_value(const std::string& text) {
    const GiNaC::ex e = parse_expression(text, symbols_);
    if (const auto names = names_in(e); !names.empty()) bad_input("a value must be a number, not " + text, names[0]);
    return real_number(e, text);
  }

  // The start value of our variable.
  bool set_v0(const Parameter& p, const std::string& text) {
    const ExactReal v0 = start_value(text);
    if (p.spelling && p.domain)
      require_domain(p, ExactReal(p.spelling->scale) * v0 + ExactReal(p.spelling->offset), p.spelling->name, text);
    insert(p, p.relation ? LevelValue::related(v0, text, *p.relation) : LevelValue::from_v0(v0, text, scheme_.arity));
    return true;
  }

  // The start value as the scheme's author spells it.
  bool set_spelled(const Parameter& p, const std::string& text) {
    const ExactReal value = start_value(text);
    require_domain(p, value, p.spelling->name, text);
    const ExactReal v0 =
        p.spelling->is_identity() ? value : (value - ExactReal(p.spelling->offset)) / ExactReal(p.spelling->scale);
    insert(p, p.relation ? LevelValue::related(v0, text, *p.relation) : LevelValue::from_v0(v0, text, scheme_.arity));
    return true;
  }

  void set_frequency(const Parameter& p, const Frequency& f, const std::string& text) {
    const bool circular = p.frequency->trigonometric != f.imaginary;
    LevelValue value = circular ? LevelValue::trigonometric(f.value, text, scheme_.arity)
                                : LevelValue::hyperbolic(f.value, text, scheme_.arity);
    if (p.spelling && p.domain)
      require_domain(p, ExactReal(p.spelling->scale) * value.exact(0) + ExactReal(p.spelling->offset), p.spelling->name,
                     text);
    insert(p, std::move(value));
  }

  const Scheme& scheme_;
  std::vector<const Parameter*> levels_;
  Symbols symbols_;
  Binding result_;
};

}  // namespace

namespace {

Binder with_given(const Scheme& scheme, const std::optional<std::string>& v0, const std::optional<std::string>& t,
                  const std::vector<std::pair<std::string, std::string>>& at) {
  if (v0 && t) bad_input("--v0 and --t both set the frequency", *t);
  Binder binder(scheme);
  if (v0) binder.single("v0", trimmed(*v0));
  if (t) binder.single("t", trimmed(*t));
  for (const auto& [name, text] : at) binder.named(trimmed(name), trimmed(text));
  return binder;
}

}  // namespace

Binding bind(const Scheme& scheme, const std::optional<std::string>& v0, const std::optional<std::string>& t,
             const std::vector<std::pair<std::string, std::string>>& at) {
  return with_given(scheme, v0, t, at).finish();
}

Binding bind_some(const Scheme& scheme, const std::optional<std::string>& v0, const std::optional<std::string>& t,
                  const std::vector<std::pair<std::string, std::string>>& at) {
  return with_given(scheme, v0, t, at).take();
}

}  // namespace twoscale::lowering
