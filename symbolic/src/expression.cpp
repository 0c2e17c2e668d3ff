// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/symbolic/expression.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <set>
#include <sstream>

#include "twoscale/symbolic/error.hpp"

namespace twoscale {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

const GiNaC::symbol& Symbols::operator[](const std::string& name) {
  return table_.try_emplace(name, GiNaC::symbol(name)).first->second;
}

namespace {

constexpr size_t longest_text = 1 << 20;
constexpr int deepest_nesting = 200;
constexpr long largest_power_bits = 1 << 20;  // size of an evaluated power of numbers
constexpr long largest_exponent = 4096;       // of a power of something else; also of a degree
constexpr long largest_numbers = 1 << 23;     // bits of all numbers of one text together, powers evaluated
constexpr size_t most_names = 64;             // of a rational function
constexpr double most_terms = 1 << 14;        // of an expanded numerator
constexpr long largest_factored = 1024;       // degree of a sum in a denominator

std::string text_of(const ex& e) {
  std::ostringstream s;
  s << e;
  return s.str();
}

const std::map<std::string, std::function<ex(const ex&)>>& functions() {
  static const std::map<std::string, std::function<ex(const ex&)>> table = {
      {"sqrt", [](const ex& x) { return GiNaC::sqrt(x); }},   {"exp", [](const ex& x) { return GiNaC::exp(x); }},
      {"log", [](const ex& x) { return GiNaC::log(x); }},     {"cos", [](const ex& x) { return GiNaC::cos(x); }},
      {"sin", [](const ex& x) { return GiNaC::sin(x); }},     {"tan", [](const ex& x) { return GiNaC::tan(x); }},
      {"cosh", [](const ex& x) { return GiNaC::cosh(x); }},   {"sinh", [](const ex& x) { return GiNaC::sinh(x); }},
      {"tanh", [](const ex& x) { return GiNaC::tanh(x); }},   {"acos", [](const ex& x) { return GiNaC::acos(x); }},
      {"asin", [](const ex& x) { return GiNaC::asin(x); }},   {"atan", [](const ex& x) { return GiNaC::atan(x); }},
      {"acosh", [](const ex& x) { return GiNaC::acosh(x); }},
  };
  return table;
}

class Reader {
 public:
  Reader(std::string_view text, Symbols& symbols) : text_(text), symbols_(symbols) {}

  ex whole() {
    if (text_.size() > longest_text) bad_input("expression is too long", std::string(text_.substr(0, 40)));
    skip();
    if (at_ == text_.size()) bad_input("empty expression");
    ex e = sum();
    if (at_ != text_.size()) fail("unexpected text in expression");
    return e;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    const std::string rest(text_.substr(at_, 24));
    bad_input(message + " '" + std::string(text_.substr(0, 80)) + "'",
              rest.empty() ? "at its end" : "at '" + rest + "'");
  }
  void skip() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }
  bool take(char c) {
    skip();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    skip();
    return true;
  }

  // Sums and products are put together once, at their end: long ones one by one take quadratic time.
  ex sum() {
    if (++depth_ > deepest_nesting) fail("expression is nested too deeply");
    GiNaC::exvector terms{product()};
    for (;;) {
      if (take('+'))
        terms.push_back(product());
      else if (take('-'))
        terms.push_back(-product());
      else
        break;
    }
    --depth_;
    return terms.size() == 1 ? terms[0] : ex(GiNaC::add(terms));
  }

  ex product() {
    GiNaC::exvector factors{signed_power()};
    for (;;) {
      skip();
      const bool star = at_ < text_.size() && text_[at_] == '*' && !(at_ + 1 < text_.size() && text_[at_ + 1] == '*');
      if (star) {
        take('*');
        factors.push_back(signed_power());
      } else if (take('/')) {
        const ex d = signed_power();
        if (d.is_zero()) fail("division by zero in");
        factors.push_back(GiNaC::pow(d, -1));
      } else {
        return factors.size() == 1 ? factors[0] : ex(GiNaC::mul(factors));
      }
    }
  }

  ex signed_power() {
    if (++depth_ > deepest_nesting) fail("expression is nested too deeply");
    bool negative = false;
    for (;;) {
      if (take('-'))
        negative = !negative;
      else if (!take('+'))
        break;
    }
    const ex e = power();
    --depth_;
    return negative ? ex(-e) : e;
  }

  ex power() {
    const ex base = atom();
    skip();
    if (text_.substr(at_, 2) == "**")
      at_ += 2, skip();
    else if (!take('^'))
      return base;
    const ex exponent = signed_power();  // right associative, a sign is allowed: 2^-1
    return checked_power(base, exponent);
  }

  ex checked_power(const ex& base, const ex& exponent) {
    if (is_a<numeric>(exponent)) {
      const numeric& n = ex_to<numeric>(exponent);
      if (!n.is_rational()) fail("exponent is not rational in");
      if (GiNaC::abs(n) > largest_power_bits) fail("power is too large in");
      if (is_a<numeric>(base)) {
        const numeric& b = ex_to<numeric>(base);
        if (b.is_zero() && n.is_negative()) fail("division by zero in");
        const numeric size = GiNaC::abs(n) * numeric(length(b));
        if (size > largest_power_bits) fail("power is too large in");
        if (n.is_integer()) charge(size.to_long());
      } else {
        if (GiNaC::abs(n) > largest_exponent) fail("power is too large in");
        if (n.is_integer()) charge(std::labs(n.to_long()) * numbers_in(base));  // (2*x)^n becomes 2^n*x^n
      }
    }
    return GiNaC::pow(base, exponent);
  }

  static long length(const numeric& n) {
    const auto part = [](const numeric& q) {
      return q.is_zero() ? 1L : static_cast<long>(q.numer().int_length() + q.denom().int_length()) + 1;
    };
    return n.is_real() ? part(n) : part(n.real()) + part(n.imag());
  }

  // Bits of the numbers in e, numerical exponents left out.
  static long numbers_in(const ex& e) {
    if (is_a<numeric>(e)) return length(ex_to<numeric>(e));
    if (is_a<GiNaC::power>(e)) return numbers_in(e.op(0));
    long bits = 0;
    for (size_t i = 0; i < e.nops(); ++i) bits += numbers_in(e.op(i));
    return bits;
  }

  void charge(long bits) {
    spent_ += bits;
    if (spent_ > largest_numbers) fail("numbers are too large in");
  }

  ex atom() {
    skip();
    if (at_ >= text_.size()) fail("expression ends too early:");
    const char c = text_[at_];
    if (take('(')) {
      ex e = sum();
      if (!take(')')) fail("')' is missing in");
      return e;
    }
    if (std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.') return number();
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) return name();
    fail("unexpected character in");
  }

  // Integers and decimals, exactly: 12, 0.4 = 2/5, 1.5e-3 = 3/2000.
  ex number() {
    std::string digits;
    long scale = 0;
    bool point = false;
    const size_t start = at_;
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '.' && !point) {
        point = true;
      } else if (std::isdigit(static_cast<unsigned char>(c)) != 0) {
        digits += c;
        if (point) --scale;
      } else {
        break;
      }
    }
    if (digits.empty()) {
      at_ = start;
      fail("unexpected character in");
    }
    if (at_ < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
      size_t p = at_ + 1;
      std::string exponent;
      if (p < text_.size() && (text_[p] == '+' || text_[p] == '-')) exponent += text_[p++];
      const size_t first = p;
      while (p < text_.size() && std::isdigit(static_cast<unsigned char>(text_[p])) != 0) exponent += text_[p++];
      if (p == first || exponent.size() > 6) {
        at_ = start;
        fail("number cannot be read in");
      }
      scale += std::stol(exponent);
      at_ = p;
    }
    if (std::labs(scale) > 100000) {
      at_ = start;
      fail("number is too large in");
    }
    if (at_ < text_.size() &&
        (std::isalpha(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '.' || text_[at_] == '_')) {
      fail("'*' is missing in");
    }
    charge(4 * (static_cast<long>(digits.size()) + std::labs(scale)));
    const ex mantissa = numeric(digits.c_str());
    return mantissa * GiNaC::pow(numeric(10), numeric(scale));
  }

  ex name() {
    const size_t start = at_;
    while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '_'))
      ++at_;
    const std::string word(text_.substr(start, at_ - start));
    if (const auto f = functions().find(word); f != functions().end()) {
      if (!take('(')) {
        at_ = start;
        fail("function without argument in");
      }
      const ex argument = sum();
      if (!take(')')) fail("')' is missing in");
      return f->second(argument);
    }
    skip();
    if (at_ < text_.size() && text_[at_] == '(') {
      at_ = start;
      fail("unknown function in");
    }
    if (word == "pi") return GiNaC::Pi;
    if (word == "I") return GiNaC::I;
    return symbols_[word];
  }

  std::string_view text_;
  Symbols& symbols_;
  size_t at_ = 0;
  int depth_ = 0;
  long spent_ = 0;
};

void collect_names(const ex& e, std::set<std::string>& names) {
  if (is_a<GiNaC::symbol>(e)) names.insert(ex_to<GiNaC::symbol>(e).get_name());
  for (size_t i = 0; i < e.nops(); ++i) collect_names(e.op(i), names);
}

}  // namespace

ex parse_expression(std::string_view text, Symbols& symbols) {
  try {
    return Reader(text, symbols).whole();
  } catch (const Error&) {
    throw;
  } catch (const std::exception& e) {  // GiNaC: poles, overflow
    bad_input("expression has no value (" + std::string(e.what()) + ")", std::string(text.substr(0, 80)));
  }
}

std::vector<std::string> names_in(const ex& e) {
  std::set<std::string> names;
  collect_names(e, names);
  return {names.begin(), names.end()};
}

Rational to_rational(const numeric& n) {
  if (!n.imag().is_zero() || !n.real().is_rational()) bad_input("not a rational number", text_of(n).substr(0, 80));
  const std::string text = text_of(n.real());
  if (text.size() > 200000) bad_input("number is too large", text.substr(0, 40) + "...");
  return Rational::parse(text);
}

namespace {

// Bounds before anything is expanded: the terms of a polynomial are at most prod (degree + 1) and at most what its
// factors give.
struct Size {
  double terms = 1;
  std::map<std::string, long> degrees;

  double bound() const {
    double dense = 1;
    for (const auto& [name, d] : degrees) dense *= static_cast<double>(d) + 1;
    return std::min(terms, dense);
  }
  long degree() const {
    long sum = 0;
    for (const auto& [name, d] : degrees) sum += d;
    return sum;
  }
};

Size size_of(const Polynomial& p) {
  Size s{static_cast<double>(p.terms()), {}};
  for (const auto& v : p.variables()) s.degrees[v] = p.degree(v);
  return s;
}

Size operator*(const Size& a, const Size& b) {
  Size r{a.bound() * b.bound(), a.degrees};
  for (const auto& [name, d] : b.degrees) r.degrees[name] += d;
  return r;
}

Size power(const Size& a, long n) {
  Size r{std::pow(a.bound(), static_cast<double>(n)), a.degrees};
  for (auto& [name, d] : r.degrees) d *= n;
  return r;
}

Size denominator_size(const RationalFunction& f) {
  Size s;
  for (const auto& [g, e] : f.denominator_factors()) s = s * power(size_of(g), static_cast<long>(e));
  return s;
}

void check(const Size& s, const ex& e) {
  if (s.degree() > 2 * largest_exponent || s.bound() > most_terms)
    bad_input("expression is too large to be expanded", text_of(e).substr(0, 80));
}

RationalFunction expanded_function(const ex& e) {
  if (is_a<numeric>(e)) return to_rational(ex_to<numeric>(e));
  if (is_a<GiNaC::symbol>(e)) return RationalFunction::variable(ex_to<GiNaC::symbol>(e).get_name());
  if (is_a<GiNaC::add>(e) || is_a<GiNaC::mul>(e)) {
    const bool add = is_a<GiNaC::add>(e);
    RationalFunction r = add ? 0 : 1;
    for (size_t i = 0; i < e.nops(); ++i) {
      const RationalFunction x = expanded_function(e.op(i));
      if (add) {
        const Size dr = denominator_size(r);
        const Size dx = denominator_size(x);
        check(size_of(r.numerator()) * dx, e);
        check(size_of(x.numerator()) * dr, e);
        check(dr * dx, e);
      } else {
        check(size_of(r.numerator()) * size_of(x.numerator()), e);
      }
      r = add ? r + x : r * x;
      if (r.numerator().total_degree() > largest_exponent) bad_input("degree is too large", text_of(e).substr(0, 80));
    }
    return r;
  }
  if (is_a<GiNaC::power>(e) && is_a<numeric>(e.op(1)) && ex_to<numeric>(e.op(1)).is_integer()) {
    const RationalFunction base = expanded_function(e.op(0));
    const numeric& n = ex_to<numeric>(e.op(1));
    if (GiNaC::abs(n) > largest_power_bits) bad_input("degree is too large", text_of(e).substr(0, 80));
    const long exponent = std::labs(n.to_long());
    const long degree = std::max(base.numerator().total_degree(), denominator_size(base).degree());
    if (degree * exponent > largest_exponent) bad_input("degree is too large", text_of(e).substr(0, 80));
    if (n.is_negative() && base.numerator().total_degree() > largest_factored && base.numerator().terms() > 1)
      bad_input("degree of the denominator is too large", text_of(e).substr(0, 80));
    check(power(size_of(base.numerator()), exponent), e);
    check(power(denominator_size(base), exponent), e);
    return base.pow(n.to_long());
  }
  bad_input("not a rational expression", text_of(e).substr(0, 80));
}

}  // namespace

RationalFunction to_rational_function(const ex& e) {
  if (const auto names = names_in(e); names.size() > most_names)
    bad_input("too many names in a rational expression", std::to_string(names.size()));
  return expanded_function(e);
}

ExactReal to_exact_real(const ex& e) {
  if (is_a<numeric>(e)) {
    if (!ex_to<numeric>(e).imag().is_zero()) bad_input("not a real number", text_of(e).substr(0, 80));
    return to_rational(ex_to<numeric>(e));
  }
  if (e.is_equal(GiNaC::Pi)) return ExactReal::pi();
  if (is_a<GiNaC::add>(e) || is_a<GiNaC::mul>(e)) {
    const bool add = is_a<GiNaC::add>(e);
    // Rational parts first: a product then starts with its rational factor, which keeps r*pi recognisable.
    ExactReal r = add ? 0 : 1;
    for (size_t i = 0; i < e.nops(); ++i) {
      const ExactReal x = to_exact_real(e.op(i));
      r = add ? r + x : r * x;
    }
    return r;
  }
  if (is_a<GiNaC::power>(e)) {
    if (is_a<numeric>(e.op(1)) && ex_to<numeric>(e.op(1)).is_rational())
      return to_exact_real(e.op(0)).pow(to_rational(ex_to<numeric>(e.op(1))));
    return ExactReal::apply(
        ExactReal::Function::exp,
        to_exact_real(e.op(1)) * ExactReal::apply(ExactReal::Function::log, to_exact_real(e.op(0))));
  }
  if (is_a<GiNaC::function>(e)) {
    using F = ExactReal::Function;
    static const std::map<std::string, F> table = {{"exp", F::exp},   {"log", F::log},   {"cos", F::cos},
                                                   {"sin", F::sin},   {"tan", F::tan},   {"cosh", F::cosh},
                                                   {"sinh", F::sinh}, {"tanh", F::tanh}, {"acos", F::acos},
                                                   {"asin", F::asin}, {"atan", F::atan}, {"acosh", F::acosh}};
    const auto it = table.find(ex_to<GiNaC::function>(e).get_name());
    if (it != table.end()) return ExactReal::apply(it->second, to_exact_real(e.op(0)));
  }
  if (is_a<GiNaC::symbol>(e)) bad_input("unknown name", text_of(e).substr(0, 80));
  bad_input("not a real constant", text_of(e).substr(0, 80));
}

ex to_ginac(const RationalFunction& f, Symbols& symbols) {
  const auto polynomial = [&](const Polynomial& p) {
    ex r = 0;
    p.for_each_term([&](const Rational& c, std::span<const unsigned long> e) {
      ex term = numeric(c.to_string().c_str());
      for (size_t i = 0; i < e.size(); ++i)
        term *= GiNaC::pow(symbols[p.variables()[i]], numeric(static_cast<long>(e[i])));
      r += term;
    });
    return r;
  };
  ex r = polynomial(f.numerator()) / polynomial(Polynomial::constant(f.denominator_content().numerator()));
  for (const auto& [factor, e] : f.denominator_factors()) r *= GiNaC::pow(polynomial(factor), -static_cast<int>(e));
  return r;
}

RationalFunction parse_rational_function(std::string_view text) {
  Symbols symbols;
  return to_rational_function(parse_expression(text, symbols));
}

ExactReal parse_real(std::string_view text) {
  Symbols symbols;
  const ex e = parse_expression(text, symbols);
  const ExactReal r = to_exact_real(e);
  if (!r.enclose(128).is_finite() && !r.enclose(4096).is_finite())
    bad_input("expression has no finite real value", std::string(text.substr(0, 80)));
  return r;
}

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1));
}

std::vector<std::string> split_list(std::string_view text) {
  std::vector<std::string> items;
  if (trimmed(text).empty()) return items;
  std::string item;
  int depth = 0;
  bool quoted = false;
  for (const char c : text) {
    if (c == '"') quoted = !quoted;
    if (!quoted && (c == '(' || c == '[')) ++depth;
    if (!quoted && (c == ')' || c == ']')) --depth;
    if (c == ',' && depth == 0 && !quoted) {
      items.push_back(trimmed(item));
      item.clear();
    } else {
      item += c;
    }
  }
  items.push_back(trimmed(item));
  return items;
}

}  // namespace twoscale
