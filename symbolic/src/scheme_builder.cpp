// SPDX-License-Identifier: GPL-3.0-or-later
// What a scheme file means: its expressions read, its parameters declared and used, its level parameters rewritten.
#include <algorithm>
#include <set>

#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"
#include "twoscale/symbolic/scheme_file.hpp"

namespace twoscale {

namespace {

using Entry = SchemeFile::Entry;
using ParameterEntry = SchemeFile::ParameterEntry;
using Scope = Parameter::Scope;

constexpr size_t longest_quote = 80;
constexpr long longest_mask = 4096;

// f as a Laurent polynomial in z. Throws Error(bad_input) if a denominator has z beyond a power.
Laurent laurent_in_z(const RationalFunction& f) {
  long lowest = 0;
  RationalFunction::Factors factors;  // without z
  for (const auto& [p, e] : f.denominator_factors()) {
    if (p == Polynomial::variable("z"))
      lowest = -static_cast<long>(e);
    else if (p.degree("z") > 0)
      bad_input("the symbol is not a Laurent polynomial in z, its denominator has the factor", p.pretty());
    else
      factors.emplace_back(p, e);
  }
  const std::vector<std::string> names = f.numerator().variables();
  const auto z = std::find(names.begin(), names.end(), "z");
  std::vector<Polynomial> parts(static_cast<size_t>(std::max(0L, f.numerator().degree("z"))) + 1);
  f.numerator().for_each_term([&](const Rational& c, std::span<const unsigned long> e) {
    Polynomial term = Polynomial::constant(c.numerator());
    size_t power = 0;
    for (size_t i = 0; i < e.size(); ++i) {
      if (names.begin() + static_cast<std::ptrdiff_t>(i) == z)
        power = e[i];
      else
        term *= Polynomial::variable(names[i]).pow(static_cast<unsigned>(e[i]));
    }
    parts[power] += term;
  });
  std::vector<RationalFunction> coefficients;
  for (const auto& p : parts)
    coefficients.push_back(RationalFunction::over_factors(p, f.denominator_content(), factors));
  return {lowest, std::move(coefficients)};
}

}  // namespace

class SchemeBuilder {
 public:
  explicit SchemeBuilder(const SchemeFile& file) : file_(file) {
    if (file.arity_.present()) arity_ = std::stoi(file.arity_.text);
    if (file.block_.present()) block_ = std::stoi(file.block_.text);
  }

  Scheme build() {
    declare_space();
    for (const auto& p : file_.parameters_) declare(p);
    name_level_variables();
    Scheme s = block_ == 1 ? scalar_scheme() : block_scheme();
    require_used();
    s.title = file_.title_.present() ? file_.title_.text : "scheme " + file_.name_.text;
    s.source = file_.source_.text;
    s.space = space_;
    for (const auto& c : file_.claims_) add_claim(c, s);
    return s;
  }

 private:
  [[noreturn]] void fail(const Entry& at, const std::string& message, std::string piece = {}) const {
    if (piece.size() > longest_quote) piece = piece.substr(0, longest_quote) + "...";
    bad_input(place(at.line, at.column) + message, std::move(piece));
  }

  std::string place(size_t line, size_t column) const {
    return file_.path_ + ":" + std::to_string(line) + ":" + std::to_string(column) + ": ";
  }

  // f(), an Error of which is said of the entry; the column is that of the piece at fault where it can be found.
  template <typename F>
  auto reading(const Entry& at, const std::string& what, F f) const {
    try {
      return f();
    } catch (const Error& e) {
      if (e.kind != Error::Kind::bad_input) throw;
      std::string piece = e.offending;
      if (piece.starts_with("at '")) piece = piece.substr(4, piece.size() - 5);
      size_t column = at.column;
      if (at.one_line && !piece.empty() && piece != at.text) {
        const auto found = e.offending == "at its end" ? at.text.size() : at.text.find(piece);
        if (found != std::string::npos) column += 1 + found;
      }
      Error error(e.kind, place(at.line, column) + what + ": " + e.what());
      error.offending = e.offending;
      throw error;
    }
  }

  RationalFunction expression(const Entry& at, const std::string& what) const {
    return reading(at, what, [&] { return parse_rational_function(at.text); });
  }

  Rational rational(const Entry& at, const std::string& what) const {
    const auto value = expression(at, what).constant();
    if (!value) fail(at, what + " must be a rational number", at.text);
    return *value;
  }

  // ---- Parameters

  void declare_space() {
    if (!file_.space_.present()) return;
    space_ = reading(file_.space_, "space", [&] { return Space::parse(file_.space_.text); });
    parameters_ = level_parameters(*space_);
    for (const auto& p : parameters_) {
      spelled_.push_back(p.name);
      declared_.push_back(nullptr);
    }
  }

  void declare(const ParameterEntry& e) {
    static const std::set<std::string> reserved = {"z",   "x",    "pi",   "I",    "sqrt", "exp",  "log",  "cos",  "sin",
                                                   "tan", "cosh", "sinh", "tanh", "acos", "asin", "atan", "acosh"};
    const std::string& name = e.name.text;
    if (reserved.contains(name)) fail(e.name, "this name has another meaning in expressions", name);
    std::optional<Domain> domain;
    if (e.domain.present()) domain = reading(e.domain, "domain", [&] { return Domain::parse(e.domain.text); });
    Parameter p;
    p.name = name;
    p.help = e.help.text;
    const auto of_space = std::find(spelled_.begin(), spelled_.end(), name);
    if (e.scope.text == "constant") {
      if (of_space != spelled_.end()) fail(e.name, "the space has a level variable of this name", name);
      p.domain = domain;
    } else if (e.scope.text == "local") {
      p.scope = Scope::local;
      p.offsets = e.offsets;
      p.domain = domain;
    } else if (of_space != spelled_.end()) {
      if (e.relation.present()) fail(e.relation, "the relation of this level variable comes from the space", name);
      const auto i = static_cast<size_t>(of_space - spelled_.begin());
      p = parameters_[i];
      p.help = e.help.text;
      p.spelling = Spelling{name, 1, 0};
      p.domain = domain;
      if (domain &&
          (!domain->low || *domain->low < Rational(-1) || (*domain->low == Rational(-1) && domain->low_included)))
        fail(e.domain, "the start value of a frequency is greater than -1", e.domain.text);
      read_default(e, p);
      parameters_[i] = std::move(p);
      declared_[i] = &e;
      return;
    } else {
      p.scope = Scope::level;
      if (!e.relation.present())
        fail(e.scope, "a level parameter needs the key relation, or a space that has it", name);
      const RationalFunction coarse = expression(e.relation, "relation");
      const LevelRelation r =
          reading(e.relation, "relation", [&] { return level_relation(name, coarse, arity_, domain); });
      p.spelling = r.spelling;
      p.domain = r.domain;
      if (r.frequency)
        p.frequency = LevelVariable{};  // named below
      else
        p.relation = r.polynomial;
    }
    read_default(e, p);
    parameters_.push_back(std::move(p));
    spelled_.push_back(name);
    declared_.push_back(&e);
  }

  void read_default(const ParameterEntry& e, Parameter& p) const {
    if (!e.default_value.present()) return;
    const ExactReal value = reading(e.default_value, "default", [&] { return parse_real(e.default_value.text); });
    const Domain domain = p.domain.value_or(p.frequency ? Domain{Rational(-1), std::nullopt, false, false} : Domain{});
    if (!domain.contains(value))
      fail(e.default_value, "the default lies outside " + domain.to_string(), e.default_value.text);
    p.default_value = e.default_value.text;
  }

  bool taken(const std::string& name) const {
    return std::find(spelled_.begin(), spelled_.end(), name) != spelled_.end() ||
           std::any_of(parameters_.begin(), parameters_.end(), [&](const auto& p) { return p.name == name; });
  }

  // Variables of level parameters that are rewritten, and the symbols of frequencies.
  void name_level_variables() {
    const auto count =
        std::count_if(parameters_.begin(), parameters_.end(), [](const auto& p) { return p.scope == Scope::level; });
    for (size_t i = 0; i < parameters_.size(); ++i) {
      Parameter& p = parameters_[i];
      if (p.scope != Scope::level || !declared_[i] || !declared_[i]->relation.present()) continue;
      const std::string own = p.name;
      if (!p.spelling->is_identity()) {
        p.name = count == 1 && !taken("v") ? "v" : "v_" + own;
        if (taken(p.name) && p.name != own) {
          const auto same =
              std::count_if(parameters_.begin(), parameters_.end(), [&](const auto& q) { return q.name == p.name; });
          if (same > 1 || std::find(spelled_.begin(), spelled_.end(), p.name) != spelled_.end())
            fail(declared_[i]->name, "the name " + p.name + " must be left for the variable that replaces", own);
        }
      }
      if (!p.frequency) continue;
      LevelVariable& v = *p.frequency;
      v.name = p.name;
      v.symbol = own.starts_with("v_") && own.size() > 2 ? own.substr(2) : count == 1 ? "t" : own;
    }
    // --at tells values by these names: each must have one meaning.
    std::set<std::string> meanings(spelled_.begin(), spelled_.end());
    for (size_t i = 0; i < parameters_.size(); ++i) {
      if (!parameters_[i].frequency || parameters_[i].frequency->symbol.empty()) continue;
      const std::string& symbol = parameters_[i].frequency->symbol;
      for (const std::string& name : {symbol, "v0_" + symbol})
        if (name != spelled_[i] && !meanings.insert(name).second)
          fail(declared_[i] ? declared_[i]->name : file_.space_, "the name is that of a frequency, use another", name);
    }
    if (count > 0 && meanings.contains("v0"))
      for (size_t i = 0; i < spelled_.size(); ++i)
        if (spelled_[i] == "v0") fail(declared_[i]->name, "the name is that of a start value, use another", "v0");
  }

  // ---- Expressions in parameters

  // The expression in our variables. Every name in it is declared.
  RationalFunction weight(const Entry& at, const std::string& what, bool with_z) {
    RationalFunction f = expression(at, what);
    for (const auto& name : f.variables()) {
      if (with_z && name == "z") continue;
      if (!use(name)) undeclared(at, what, name);
    }
    for (size_t i = 0; i < parameters_.size(); ++i) {
      const Parameter& p = parameters_[i];
      if (p.spelling && !p.spelling->is_identity())
        f = f.substitute(spelled_[i], RationalFunction(p.spelling->scale) * RationalFunction::variable(p.name) +
                                          RationalFunction(p.spelling->offset));
    }
    return f;
  }

  bool use(const std::string& name) {
    for (size_t i = 0; i < parameters_.size(); ++i) {
      if (parameters_[i].scope == Scope::local) {
        for (const long h : parameters_[i].offsets)
          if (local_name(spelled_[i], h) == name) {
            used_.insert(name);
            return true;
          }
      } else if (spelled_[i] == name) {
        used_.insert(name);
        return true;
      }
    }
    return false;
  }

  [[noreturn]] void undeclared(const Entry& at, const std::string& what, const std::string& name) const {
    const auto found = at.one_line ? at.text.find(name) : std::string::npos;
    const size_t column = at.column + (found == std::string::npos ? 0 : 1 + found);
    std::string hint;
    for (size_t i = 0; i < parameters_.size(); ++i)
      if (parameters_[i].scope == Scope::local && name.starts_with(spelled_[i]))
        hint = " (a local parameter is spelled NAME_0, NAME_1, NAME_m1, with its offset)";
    bad_input(place(at.line, column) + what + ": a parameter is used that is not declared" + hint, name);
  }

  void require_used() const {
    for (size_t i = 0; i < parameters_.size(); ++i) {
      const Entry& at = declared_[i] ? declared_[i]->name : file_.space_;
      if (parameters_[i].scope == Scope::local) {
        for (const long h : parameters_[i].offsets)
          if (!used_.contains(local_name(spelled_[i], h)))
            fail(declared_[i]->offsets_at, "an offset is declared and not used", local_name(spelled_[i], h));
      } else if (!used_.contains(spelled_[i])) {
        fail(at,
             declared_[i] ? "a parameter is declared and not used" : "the space has a level variable that is not used",
             spelled_[i]);
      }
    }
  }

  // ---- The rules

  std::optional<Rational> given_shift() const {
    if (!file_.shift_.present()) return std::nullopt;
    return rational(file_.shift_, "shift");
  }

  Scheme scalar_scheme() {
    Laurent a;
    if (file_.symbol_.present()) {
      const RationalFunction f = weight(file_.symbol_, "symbol", true);
      a = reading(file_.symbol_, "symbol", [&] { return laurent_in_z(f); });
    } else {
      for (const auto& p : file_.phases_)
        for (const auto& [h, entries] : p.stencil)
          a = a + Laurent::monomial(std::stol(p.residue.text) - arity_ * h, weight(entries[0], "stencil", false));
    }
    const Entry& at = file_.symbol_.present() ? file_.symbol_ : file_.phases_.front().residue;
    if (!a.is_zero() && a.highest() - a.lowest() >= longest_mask)
      fail(at, "the mask has more than 4096 coefficients", std::to_string(a.highest() - a.lowest() + 1));
    const auto shift = given_shift();
    return reading(at, file_.symbol_.present() ? "symbol" : "phases", [&] {
      try {
        return Scheme::from_symbol(file_.name_.text, a, arity_, parameters_, shift);
      } catch (const Error& e) {
        if (std::string(e.what()).starts_with("the centre"))
          bad_input("the centre of the mask depends on a parameter: the key shift is needed", file_.name_.text);
        throw;
      }
    });
  }

  Scheme block_scheme() {
    Scheme s;
    s.id = file_.name_.text;
    s.arity = arity_;
    s.block = block_;
    s.shift = given_shift().value_or(Rational(0));
    s.phases.resize(static_cast<size_t>(arity_));
    for (const auto& p : file_.phases_) {
      Stencil& stencil = s.phases[std::stoul(p.residue.text)];
      stencil.lowest = p.stencil.begin()->first;
      const long highest = p.stencil.rbegin()->first;
      stencil.blocks.assign(static_cast<size_t>(highest - stencil.lowest + 1),
                            std::vector<RationalFunction>(static_cast<size_t>(block_ * block_)));
      for (const auto& [h, entries] : p.stencil)
        for (size_t i = 0; i < entries.size(); ++i)
          stencil.blocks[static_cast<size_t>(h - stencil.lowest)][i] = weight(entries[i], "stencil", false);
    }
    s.parameters = parameters_;
    return s;
  }

  // ---- Claims

  void add_claim(const SchemeFile::ClaimEntry& c, Scheme& s) const {
    Claim claim{c.claim.text, c.subject.text, c.source.text};
    const Entry& at = c.subject.present() ? c.subject : c.claim;
    const bool of_space = claim.name == "generates" || claim.name == "reproduces" || claim.name == "maximal";
    if (of_space) {
      if (!c.subject.present() && !s.space) fail(at, claim.name + " needs a space as its subject");
      claim.subject = c.subject.present()
                          ? reading(at, claim.name, [&] { return Space::parse(claim.subject).to_string(); })
                          : s.space->to_string();
    } else if (claim.name == "sum-rules" || claim.name == "continuity") {
      const bool digits =
          !claim.subject.empty() && claim.subject.size() < 4 &&
          std::all_of(claim.subject.begin(), claim.subject.end(), [](char d) { return d >= '0' && d <= '9'; });
      if (!digits || (claim.name == "sum-rules" && std::stol(claim.subject) == 0))
        fail(at, claim.name + " needs an order as its subject", claim.subject);
    } else if (c.subject.present() && claim.name != "spectrum") {
      fail(at, claim.name + " takes no subject", claim.subject);
    }
    for (const auto& other : s.claims)
      if (other.name == claim.name && other.subject == claim.subject)
        fail(at, "the claim is made twice", claim.name + (claim.subject.empty() ? "" : "=" + claim.subject));
    s.claims.push_back(std::move(claim));
  }

  const SchemeFile& file_;
  int arity_ = 2;
  int block_ = 1;
  std::optional<Space> space_;
  // Side by side: our parameter, how it is spelled, where it is declared (nowhere: by the space).
  std::vector<Parameter> parameters_;
  std::vector<std::string> spelled_;
  std::vector<const ParameterEntry*> declared_;
  std::set<std::string> used_;
};

Scheme SchemeFile::scheme() const { return SchemeBuilder(*this).build(); }

}  // namespace twoscale
