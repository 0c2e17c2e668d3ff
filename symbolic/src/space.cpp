// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/symbolic/space.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

namespace {

// "t", "2*t", "t/6", "2*t/3"; unit "1": "2/3".
std::string scaled(const Rational& q, const std::string& unit) {
  if (unit == "1") return q.to_string();
  const Rational n(q.numerator());
  const Rational d(q.denominator());
  return (n == Rational(1) ? "" : n.to_string() + "*") + unit + (d == Rational(1) ? "" : "/" + d.to_string());
}

std::string power_of_x(unsigned r) { return r == 0 ? "1" : r == 1 ? "x" : "x^" + std::to_string(r); }

std::string times_power(unsigned r, const std::string& f) { return r == 0 ? f : power_of_x(r) + "*" + f; }

std::string argument(const std::string& frequency, const char* sign = "") {
  return std::string(sign) + (frequency == "1" ? "x" : frequency + "*x");
}

enum class Form { exp_plus, exp_minus, cosh, sinh };  // of a trigonometric group: exp(I..), exp(-I..), cos, sin

std::string write(Form form, const std::string& frequency, bool trigonometric, unsigned r) {
  const std::string i = trigonometric ? "I*" : "";
  switch (form) {
    case Form::exp_plus: return times_power(r, "exp(" + i + argument(frequency) + ")");
    case Form::exp_minus: return times_power(r, "exp(-" + i + argument(frequency) + ")");
    case Form::cosh: return times_power(r, (trigonometric ? "cos(" : "cosh(") + argument(frequency) + ")");
    case Form::sinh: return times_power(r, (trigonometric ? "sin(" : "sinh(") + argument(frequency) + ")");
  }
  return {};
}

struct Item {
  unsigned power = 0;
  bool exponential = false;
  LevelVariable group;  // factor holds the frequency's own factor
  Form form = Form::exp_plus;
};

// A constant as text that does not depend on GiNaC's order of terms, which differs from run to run: "sqrt(2)*sqrt(3)",
// "(1+sqrt(2))". Sums stand in parentheses, so that a factor may be put before them.
std::string constant_text(const ex& e) {
  if (!is_a<GiNaC::add>(e) && !is_a<GiNaC::mul>(e)) {
    std::ostringstream text;
    if (is_a<GiNaC::power>(e) && e.op(0).is_equal(GiNaC::Pi) && e.op(1).info(GiNaC::info_flags::posint))
      text << "pi^" << e.op(1);
    else if (is_a<GiNaC::power>(e) && !e.op(1).is_equal(ex(1) / 2))
      text << "(" << constant_text(e.op(0)) << ")^(" << constant_text(e.op(1)) << ")";
    else if (is_a<GiNaC::power>(e))
      text << "sqrt(" << constant_text(e.op(0)) << ")";
    else if (is_a<GiNaC::function>(e))
      text << ex_to<GiNaC::function>(e).get_name() << "(" << constant_text(e.op(0)) << ")";
    else if (e.is_equal(GiNaC::Pi))
      text << "pi";
    else
      text << e;
    return text.str();
  }
  const bool sum = is_a<GiNaC::add>(e);
  std::vector<std::string> parts;
  std::string text;
  for (size_t i = 0; i < e.nops(); ++i)
    if (!sum && is_a<numeric>(e.op(i)))
      text = ex_to<numeric>(e.op(i)).is_equal(-1) ? "-" : "(" + constant_text(e.op(i)) + ")*";
    else
      parts.push_back(constant_text(e.op(i)));
  std::sort(parts.begin(), parts.end());
  for (size_t i = 0; i < parts.size(); ++i)
    text += (i == 0 ? "" : sum ? parts[i][0] == '-' ? "" : "+" : "*") + parts[i];
  return sum ? "(" + text + ")" : text;
}

// Two groups of numeric frequencies must not be rational multiples of each other, or their level variables would not be
// independent: sqrt(6) and sqrt(2)*sqrt(3), log(4) and log(2).
void refuse_hidden_multiples(const LevelVariable& a, const LevelVariable& b) {
  if (!a.symbol.empty() || !b.symbol.empty() || a.trigonometric != b.trigonometric) return;
  const ExactReal x = parse_real(a.unit);
  const ExactReal y = parse_real(b.unit);
  // The simplest fraction near x/y, by continued fractions of a good approximation.
  const Ball ratio = (x / y).enclose(192);
  Rational r;
  arf_get_fmpq(r.raw(), arb_midref(ratio.raw()));
  Rational p0 = 0, q0 = 1, p1 = 1, q1 = 0;
  for (int step = 0; step < 40; ++step) {
    Rational whole;
    fmpz_fdiv_q(fmpq_numref(whole.raw()), r.numerator(), r.denominator());
    std::tie(p0, q0, p1, q1) = std::tuple(p1, q1, whole * p1 + p0, whole * q1 + q0);
    if (q1 > Rational(1000000)) return;
    const Sign s = (x - ExactReal(p1 / q1) * y).sign(2048);
    if (s == Sign::zero || s == Sign::unknown)
      bad_input("these frequencies are multiples of each other, write them with the same number",
                a.unit + ", " + b.unit);
    r -= whole;
    if (r.is_zero()) return;
    r = r.inverse();
  }
}

// Splits the frequency c into factor (positive), sign, group.
void read_frequency(const ex& c, Item& item, bool circular, int& sign, const std::string& text) {
  ex number = 1;
  ex rest = 1;
  if (is_a<numeric>(c)) {
    number = c;
  } else if (is_a<GiNaC::mul>(c)) {
    for (size_t i = 0; i < c.nops(); ++i) (is_a<numeric>(c.op(i)) ? number : rest) *= c.op(i);
  } else {
    rest = c;
  }
  numeric q = ex_to<numeric>(number);
  item.group.trigonometric = circular;
  if (!q.is_real()) {
    q = q / ex_to<numeric>(GiNaC::I);
    if (!q.is_real()) bad_input("frequency is neither real nor imaginary", text);
    if (circular) q = -q;  // cos(I t x): I * I t = -t, the sign being irrelevant or counted
    item.group.trigonometric = !circular;
  }
  if (!q.is_rational()) bad_input("frequency has no exact value", text);
  const auto names = names_in(rest);
  if (names.empty()) {
    if (is_a<GiNaC::add>(rest)) {  // 2+2*sqrt(2) = 2*(1+sqrt(2)): GiNaC multiplies numbers into sums
      numeric content = 0;
      for (size_t i = 0; i < rest.nops(); ++i) {
        const ex t = rest.op(i);
        const ex c0 = is_a<numeric>(t)                                           ? t
                      : is_a<GiNaC::mul>(t) && is_a<numeric>(t.op(t.nops() - 1)) ? t.op(t.nops() - 1)
                                                                                 : ex(1);
        const numeric n = ex_to<numeric>(c0);
        if (!n.is_rational()) bad_input("frequency has no exact value", text);
        content = content.is_zero() ? GiNaC::abs(n)
                                    : GiNaC::gcd(content.numer() * n.denom(), GiNaC::abs(n.numer()) * content.denom()) /
                                          (content.denom() * n.denom());
      }
      q = q * content;
      rest = (rest / content).expand();
    }
    const ExactReal value = to_exact_real(rest);
    const Sign s = value.enclose(64).is_finite() || value.enclose(1024).is_finite() ? value.sign() : Sign::unknown;
    if (s == Sign::zero || s == Sign::unknown) bad_input("frequency has no usable value", text);
    if (s == Sign::negative) {
      q = -q;
      rest = (-rest).expand();
    }
    item.group.unit = constant_text(rest);
  } else if (is_a<GiNaC::symbol>(rest) && names[0] != "x") {
    item.group.symbol = names[0];
  } else {
    bad_input("a frequency must be a rational multiple of one name or of one number", text);
  }
  item.group.factor = to_rational(q);
  sign = item.group.factor.sign();
  item.group.factor = abs(item.group.factor);
}

Item read_item(const std::string& text, Symbols& symbols) {
  if (text.empty()) bad_input("empty item in space");
  const ex whole = parse_expression(text, symbols);
  const ex x = symbols["x"];
  std::vector<ex> factors;
  if (is_a<GiNaC::mul>(whole))
    for (size_t i = 0; i < whole.nops(); ++i) factors.push_back(whole.op(i));
  else
    factors.push_back(whole);
  Item item;
  for (const ex& f : factors) {
    if (is_a<numeric>(f) && !f.is_zero()) continue;  // a constant multiple spans the same line
    if (f.is_equal(x)) {
      ++item.power;
      continue;
    }
    if (is_a<GiNaC::power>(f) && f.op(0).is_equal(x) && f.op(1).info(GiNaC::info_flags::posint)) {
      if (ex_to<numeric>(f.op(1)) > 512) bad_input("power of x is too large", text);
      item.power += static_cast<unsigned>(ex_to<numeric>(f.op(1)).to_int());
      continue;
    }
    static const std::map<std::string, std::pair<Form, bool>> forms = {{"exp", {Form::exp_plus, false}},
                                                                       {"cosh", {Form::cosh, false}},
                                                                       {"sinh", {Form::sinh, false}},
                                                                       {"cos", {Form::cosh, true}},
                                                                       {"sin", {Form::sinh, true}}};
    const bool known = is_a<GiNaC::function>(f) && forms.contains(ex_to<GiNaC::function>(f).get_name());
    if (!known || item.exponential)
      bad_input("not an item x^r, x^r*exp(t*x), x^r*cosh, sinh, cos, sin of a space", text);
    const auto [form, circular] = forms.at(ex_to<GiNaC::function>(f).get_name());
    const ex argument = f.op(0).expand();
    const ex c = argument.coeff(x, 1);
    if (!(argument - c * x).expand().is_zero() || c.has(x)) bad_input("the argument must be a frequency times x", text);
    item.exponential = true;
    int sign = 1;
    read_frequency(c, item, circular, sign, text);
    item.form = form == Form::exp_plus && sign < 0 ? Form::exp_minus : form;
  }
  return item;
}

}  // namespace

std::string LevelVariable::frequency() const { return scaled(factor, symbol.empty() ? unit : symbol); }

std::string LevelVariable::meaning(int arity) const {
  return std::string(trigonometric ? "cos(" : "cosh(") + frequency() + "/" + std::to_string(arity) + "^(k+1))";
}

std::optional<ExactReal> LevelVariable::value() const {
  if (!symbol.empty()) return std::nullopt;
  return ExactReal(factor) * parse_real(unit);
}

Space Space::parse(std::string_view text) {
  Symbols symbols;
  std::vector<bool> polynomial;
  // group -> factor -> power -> forms listed
  struct Group {
    LevelVariable variable;
    std::map<Rational, std::map<unsigned, std::set<Form>>> listed;
  };
  std::vector<Group> groups;
  const auto list = split_list(text);
  if (list.empty()) bad_input("the space is empty");
  for (const auto& piece : list) {
    const Item item = read_item(piece, symbols);
    if (item.power > 512) bad_input("power of x is too large", piece);
    if (!item.exponential) {
      if (polynomial.size() <= item.power) polynomial.resize(item.power + 1);
      if (polynomial[item.power]) bad_input("item stands twice in the space", piece);
      polynomial[item.power] = true;
      continue;
    }
    auto g =
        std::find_if(groups.begin(), groups.end(), [&](const Group& o) { return o.variable.same_group(item.group); });
    if (g == groups.end()) g = groups.insert(groups.end(), Group{item.group, {}});
    auto& forms = g->listed[item.group.factor][item.power];
    if (!forms.insert(item.form).second) bad_input("item stands twice in the space", piece);
    if (forms.size() > 2) bad_input("item is a combination of others in the space", piece);
  }
  std::vector<std::string> missing;
  for (unsigned r = 0; r < polynomial.size(); ++r)
    if (!polynomial[r]) missing.push_back(power_of_x(r));
  Space space;
  space.polynomial_order_ = static_cast<unsigned>(polynomial.size());
  for (size_t i = 0; i < groups.size(); ++i)
    for (size_t j = 0; j < i; ++j) refuse_hidden_multiples(groups[j].variable, groups[i].variable);
  // Groups in the order of their names, so that the order of the items does not matter.
  std::sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) {
    return std::tie(a.variable.symbol, a.variable.unit, a.variable.trigonometric) <
           std::tie(b.variable.symbol, b.variable.unit, b.variable.trigonometric);
  });
  for (auto& g : groups) {
    Rational base = 0;
    for (const auto& [factor, powers] : g.listed) base = gcd(base, factor);
    for (const auto& [factor, powers] : g.listed) {
      const std::string frequency = scaled(factor, g.variable.symbol.empty() ? g.variable.unit : g.variable.symbol);
      const unsigned order = powers.rbegin()->first + 1;
      const auto& top = powers.rbegin()->second;
      const bool exponentials = top.contains(Form::exp_plus) || top.contains(Form::exp_minus);
      for (unsigned r = 0; r < order; ++r) {
        const auto at = powers.find(r);
        const std::set<Form> have = at == powers.end() ? std::set<Form>{} : at->second;
        if (have.size() == 2) continue;
        const bool by_exp =
            have.empty() ? exponentials : have.contains(Form::exp_plus) || have.contains(Form::exp_minus);
        for (const Form f : by_exp ? std::vector{Form::exp_plus, Form::exp_minus} : std::vector{Form::cosh, Form::sinh})
          if (!have.contains(f)) missing.push_back(write(f, frequency, g.variable.trigonometric, r));
      }
      const Rational multiple = factor / base;
      if (multiple > Rational(4096)) bad_input("frequencies are too far apart", frequency);
      space.exponentials_.push_back({space.variables_.size(), static_cast<unsigned>(multiple.to_long()), order});
    }
    LevelVariable v = g.variable;
    v.factor = base;
    // v = cos(s/m^{k+1}) follows from v^0 = cos(s) by the recurrence only for |s| < pi (contract of the level
    // variable).
    if (const auto s = v.value(); s && v.trigonometric && (ExactReal::pi() - *s).sign() != Sign::positive)
      bad_input("a frequency of cosines must be less than pi", v.frequency());
    space.variables_.push_back(std::move(v));
  }
  if (!missing.empty()) {
    std::string names;
    for (const auto& m : missing) names += (names.empty() ? "" : ", ") + m;
    bad_input("the space is incomplete, missing", names);
  }
  if (space.dimension() > 512) bad_input("the space is too large", std::to_string(space.dimension()) + " dimensions");
  space.name_variables();
  return space;
}

Space Space::one_frequency(unsigned polynomial_order, const std::vector<std::pair<unsigned, unsigned>>& multiples) {
  Space space;
  space.polynomial_order_ = polynomial_order;
  if (!multiples.empty()) {
    LevelVariable t;
    t.symbol = "t";
    space.variables_.push_back(t);
    for (const auto& [multiple, order] : multiples) space.exponentials_.push_back({0, multiple, order});
  }
  space.name_variables();
  return space;
}

// "v" for one group; "v_t", "v_2_pi"-like names otherwise; made distinct by the trigonometric mark.
void Space::name_variables() {
  if (variables_.size() == 1) {
    variables_[0].name = "v";
    return;
  }
  std::set<std::string> taken;
  for (auto& v : variables_) {
    std::string tail = v.symbol.empty() ? v.unit : v.symbol;
    for (auto& c : tail)
      if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    std::string name = "v_" + tail;
    if (taken.contains(name)) name = "v_I" + tail;
    while (taken.contains(name)) name += "_";
    taken.insert(name);
    v.name = name;
  }
}

unsigned Space::dimension() const {
  unsigned n = polynomial_order_;
  for (const auto& e : exponentials_) n += 2 * e.order;
  return n;
}

std::vector<std::string> Space::items() const {
  std::vector<std::string> list;
  for (unsigned r = 0; r < polynomial_order_; ++r) list.push_back(power_of_x(r));
  for (const auto& e : exponentials_) {
    const LevelVariable& v = variables_[e.variable];
    const std::string frequency =
        scaled(v.factor * Rational(static_cast<long>(e.multiple)), v.symbol.empty() ? v.unit : v.symbol);
    for (unsigned r = 0; r < e.order; ++r) {
      list.push_back(write(v.trigonometric ? Form::cosh : Form::exp_plus, frequency, v.trigonometric, r));
      list.push_back(write(v.trigonometric ? Form::sinh : Form::exp_minus, frequency, v.trigonometric, r));
    }
  }
  return list;
}

std::string Space::to_string() const {
  std::string s;
  for (const auto& i : items()) s += (s.empty() ? "" : ", ") + i;
  return s;
}

std::string Space::to_latex() const {
  std::string s;
  for (unsigned r = 0; r < polynomial_order_; ++r)
    s += (s.empty() ? "" : ", ") + (r < 2 ? power_of_x(r) : "x^{" + std::to_string(r) + "}");
  for (const auto& e : exponentials_) {
    const LevelVariable& v = variables_[e.variable];
    const Rational q = v.factor * Rational(static_cast<long>(e.multiple));
    const std::string unit = v.symbol.empty() ? (v.unit == "1"    ? ""
                                                 : v.unit == "pi" ? "\\pi "
                                                                  : v.unit)
                                              : latex_name(v.symbol) + " ";
    const std::string number = q == Rational(1) ? ""
                               : q.is_integer() ? q.to_string()
                                                : "\\tfrac{" + Rational(q.numerator()).to_string() + "}{" +
                                                      Rational(q.denominator()).to_string() + "}";
    const std::string f = number + unit + "x";
    for (unsigned r = 0; r < e.order; ++r) {
      const std::string x = r == 0 ? "" : r == 1 ? "x\\," : "x^{" + std::to_string(r) + "}";
      s += s.empty() ? "" : ", ";
      s += v.trigonometric ? x + "\\cos(" + f + "), " + x + "\\sin(" + f + ")"
                           : x + "e^{" + f + "}, " + x + "e^{-" + f + "}";
    }
  }
  return s;
}

Space::Rebased Space::rebase(const Space& space, const std::vector<LevelVariable>& reference) {
  Rebased r;
  r.space.polynomial_order_ = space.polynomial_order_;
  r.space.variables_ = reference;
  r.scale.assign(reference.size(), 1);
  for (const auto& v : space.variables_) {
    auto at = std::find_if(r.space.variables_.begin(), r.space.variables_.end(),
                           [&](const auto& o) { return o.same_group(v); });
    if (at == r.space.variables_.end()) {
      LevelVariable own = v;
      // A name of its own beside the reference's.
      while (std::any_of(r.space.variables_.begin(), r.space.variables_.end(),
                         [&](const auto& o) { return o.name == own.name; }))
        own.name += "_" + (own.symbol.empty() ? std::string("c") : own.symbol);
      at = r.space.variables_.insert(r.space.variables_.end(), own);
    }
    const size_t index = static_cast<size_t>(at - r.space.variables_.begin());
    const Rational base = gcd(at->factor, v.factor);
    const auto stretch = [](const Rational& q) {
      if (q > Rational(64)) bad_input("frequencies are too far apart", q.to_string());
      return static_cast<unsigned>(q.to_long());
    };
    if (index < r.scale.size()) r.scale[index] = stretch(at->factor / base);
    at->factor = base;
    const unsigned own_scale = stretch(v.factor / base);
    for (const auto& e : space.exponentials_)
      if (space.variables_[e.variable].same_group(v))
        r.space.exponentials_.push_back({index, e.multiple * own_scale, e.order});
  }
  std::sort(r.space.exponentials_.begin(), r.space.exponentials_.end(), [](const Exponential& a, const Exponential& b) {
    return std::tie(a.variable, a.multiple) < std::tie(b.variable, b.multiple);
  });
  return r;
}

std::vector<Node> nodes(const Space& space) {
  std::vector<Node> list(space.polynomial_order() / 2, Node{0, 0});
  for (const auto& e : space.exponentials()) list.insert(list.end(), e.order, Node{e.variable, e.multiple});
  return list;
}

std::vector<Polynomial> cosh_nodes(const Space& space) {
  std::vector<Polynomial> w;
  for (const Node& n : nodes(space))
    w.push_back(n.multiple == 0 ? Polynomial(1)
                                : Polynomial::chebyshev(space.variables()[n.variable].name, n.multiple));
  return w;
}

}  // namespace twoscale
