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

class Binder {
 public:
  explicit Binder(const Scheme& scheme) : scheme_(scheme), variables_(level_variables(scheme)) {
    for (const LevelVariable& v : variables_)
      if (const auto value = v.value()) set_frequency(v, {*value, false}, v.frequency());
  }

  void single(const std::string& name, const std::string& text) {
    const std::string option = "--" + name;
    if (variables_.empty()) bad_input(scheme_.id + " has no frequency that " + option + " could set", text);
    if (variables_.size() > 1)
      bad_input(option + " needs a single frequency; " + scheme_.id + " has several, name them with --at", text);
    if (name == "v0")
      set_v0(variables_[0], text);
    else
      set_frequency(variables_[0], parse_frequency(text), text);
    // --t is the frequency of the level variable, which may be a multiple of the one that was named.
    const bool scaled = name == "t" && variables_[0].factor != Rational(1);
    result_.description.emplace_back(scaled ? variables_[0].frequency() : name, text);
  }

  void named(const std::string& name, const std::string& text) {
    bool found = false;
    for (const LevelVariable& v : variables_) {
      if (name == "v0" + v.name.substr(1)) {
        set_v0(v, text);
        found = true;
        break;
      }
    }
    if (!found)
      for (const LevelVariable& v : variables_)
        if (!v.symbol.empty() && v.symbol == name) {
          Frequency f = parse_frequency(text);
          f.value = ExactReal(v.factor) * f.value;
          set_frequency(v, f, text);
          found = true;
        }
    if (!found)
      for (const LevelVariable& v : variables_)
        if (!v.symbol.empty() && "v0_" + v.symbol == name) {
          set_v0(v, text);
          found = true;
          break;
        }
    for (const Parameter& p : scheme_.parameters)
      if (!found && p.scope == Parameter::Scope::constant && p.name == name) {
        if (!result_.constants.emplace(name, parse_real(text)).second) bad_input("parameter is bound twice", name);
        found = true;
      }
    if (!found) bad_input("unknown parameter of " + scheme_.id + known_names(), name);
    result_.description.emplace_back(name, text);
  }

  Binding finish() {
    for (const LevelVariable& v : variables_)
      if (!result_.levels.contains(v.name))
        bad_input(variables_.size() == 1
                      ? "a value of v^0 is missing: give --v0 or --t for the frequency"
                      : "a value is missing: give it with --at " + v.symbol + "=... for the frequency",
                  v.frequency());
    for (const Parameter& p : scheme_.parameters)
      if (p.scope == Parameter::Scope::constant && !result_.constants.contains(p.name))
        bad_input("a value is missing, give it with --at", p.name);
    return std::move(result_);
  }

 private:
  std::string known_names() const {
    std::string names;
    const auto add = [&](const std::string& n) { names += (names.empty() ? "" : ", ") + n; };
    for (const LevelVariable& v : variables_) {
      if (v.symbol.empty()) continue;
      add(v.symbol);
      add("v0" + v.name.substr(1));
    }
    for (const Parameter& p : scheme_.parameters)
      if (p.scope == Parameter::Scope::constant) add(p.name);
    return names.empty() ? " (it has none)" : " (it has " + names + ")";
  }

  void insert(const LevelVariable& v, LevelValue value) {
    if (!v.symbol.empty() || !result_.levels.contains(v.name)) {
      if (!result_.levels.emplace(v.name, std::move(value)).second)
        bad_input("parameter is bound twice", v.frequency());
      return;
    }
    bad_input("the frequency is fixed by the scheme", v.frequency());
  }

  void set_v0(const LevelVariable& v, const std::string& text) {
    const GiNaC::ex e = parse_expression(text, symbols_);
    if (const auto names = names_in(e); !names.empty()) bad_input("a value must be a number, not " + text, names[0]);
    insert(v, LevelValue::from_v0(real_number(e, text), text, scheme_.arity));
  }

  void set_frequency(const LevelVariable& v, const Frequency& f, const std::string& text) {
    const bool circular = v.trigonometric != f.imaginary;
    insert(v, circular ? LevelValue::trigonometric(f.value, text, scheme_.arity)
                       : LevelValue::hyperbolic(f.value, text, scheme_.arity));
  }

  const Scheme& scheme_;
  std::vector<LevelVariable> variables_;
  Symbols symbols_;
  Binding result_;
};

}  // namespace

Binding bind(const Scheme& scheme, const std::optional<std::string>& v0, const std::optional<std::string>& t,
             const std::vector<std::pair<std::string, std::string>>& at) {
  if (v0 && t) bad_input("--v0 and --t both set the frequency", *t);
  Binder binder(scheme);
  if (v0) binder.single("v0", trimmed(*v0));
  if (t) binder.single("t", trimmed(*t));
  for (const auto& [name, text] : at) binder.named(trimmed(name), trimmed(text));
  return binder.finish();
}

}  // namespace twoscale::lowering
