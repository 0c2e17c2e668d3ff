// SPDX-License-Identifier: GPL-3.0-or-later
#include "program.hpp"

#include <algorithm>
#include <set>

namespace twoscale::lowering::emit {

namespace {

using Kind = Operation::Kind;

// The errors of a sum and a product of twice the precision are below 8 u^2 a step and relative to the sum of the
// terms' sizes; rounding gives one u, and as much is allowed for what the steps leave.
constexpr unsigned rounded_pair = 2;

}  // namespace

bool is_power_of_two(const Rational& integer) {
  if (!integer.is_integer() || integer.is_zero()) return false;
  Rational size = abs(integer);
  return fmpz_popcnt(size.numerator()) == 1;
}

bool Program::exact_integer(const Rational& integer) const {
  if (integer.is_zero()) return true;
  fmpz_t odd;
  fmpz_init(odd);
  fmpz_abs(odd, integer.numerator());
  fmpz_tdiv_q_2exp(odd, odd, fmpz_val2(odd));
  const bool fits = fmpz_bits(odd) <= bits_;
  fmpz_clear(odd);
  return fits;
}

int Program::insert(Operation o) {
  const auto key = std::make_tuple(static_cast<int>(o.kind), o.a, o.b, o.c,
                                   o.kind == Kind::variable ? o.name : o.number.to_string());
  const auto found = known_.find(key);
  if (found != known_.end()) return found->second;
  for (const int operand : {o.a, o.b, o.c})
    if (operand >= 0) ++operations_[static_cast<size_t>(operand)].uses;
  operations_.push_back(std::move(o));
  const int value = static_cast<int>(operations_.size()) - 1;
  known_.emplace(key, value);
  return value;
}

int Program::variable(const std::string& name) {
  Operation o{Kind::variable};
  o.name = name;
  return insert(std::move(o));
}

int Program::number(const Rational& integer) {
  Operation o{Kind::number};
  o.number = integer;
  o.error = exact_integer(integer) ? 0 : 1;
  return insert(std::move(o));
}

int Program::pair_number(const Rational& integer) {
  Operation o{Kind::pair_number};
  o.number = integer;
  return insert(std::move(o));
}

int Program::binary(Kind kind, int a, int b) {
  const Operation& x = (*this)[a];
  const Operation& y = (*this)[b];
  const auto scale = [&](const Operation& p) { return p.kind == Kind::number && is_power_of_two(p.number); };
  const auto one = [&](const Operation& p) { return p.kind == Kind::number && p.number == Rational(1); };
  Operation o{kind};
  o.a = a;
  o.b = b;
  switch (kind) {
    case Kind::multiply:
      if (one(x)) return b;
      if (one(y)) return a;
      if (scale(y)) std::swap(o.a, o.b);  // numbers first
      o.error = x.error + y.error + (scale(x) || scale(y) ? 0 : 1);
      break;
    case Kind::divide:
      if (one(y)) return a;
      o.error = x.error + y.error + (scale(y) ? 0 : 1);
      break;
    default: o.error = std::max(x.error, y.error) + 1;
  }
  return insert(std::move(o));
}

int Program::negate(int a) {
  if ((*this)[a].kind == Kind::number) return number(-(*this)[a].number);
  Operation o{Kind::negate};
  o.a = a;
  o.error = (*this)[a].error;
  return insert(std::move(o));
}

int Program::power(int base, unsigned exponent) {
  if (exponent == 1) return base;
  const int half = power(base, exponent / 2);
  const int square = binary(Kind::multiply, half, half);
  return exponent % 2 == 0 ? square : binary(Kind::multiply, square, base);
}

// ---- Polynomials

bool Program::one_sign(const Terms& terms, const std::vector<std::string>& names) const {
  int sign = 0;
  for (const Term& t : terms) {
    if (sign != 0 && t.coefficient.sign() != sign) return false;
    sign = t.coefficient.sign();
    for (size_t i = 0; i < names.size(); ++i) {
      const auto range = ranges_.find(names[i]);
      if (t.exponents[i] % 2 != 0 && (range == ranges_.end() || range->second == Range::any)) return terms.size() == 1;
    }
  }
  return true;
}

bool Program::exact_term(const Term& t) const {
  unsigned degree = 0;
  for (const unsigned e : t.exponents) degree += e;
  return degree == 0 ? exact_integer(t.coefficient) : degree == 1 && is_power_of_two(t.coefficient);
}

int Program::exact_value(const Term& t, const std::vector<std::string>& names) {
  const int c = number(abs(t.coefficient));
  for (size_t i = 0; i < names.size(); ++i)
    if (t.exponents[i] == 1) return binary(Kind::multiply, c, variable(names[i]));
  return c;
}

namespace {

// The terms by powers of the variable that occurs in most of them, highest first.
template <class Terms>
std::pair<size_t, std::map<unsigned, Terms, std::greater<>>> by_powers(const Terms& terms, size_t variables) {
  size_t best = 0, most = 0;
  for (size_t i = 0; i < variables; ++i) {
    size_t occurs = 0;
    for (const auto& t : terms) occurs += t.exponents[i] > 0 ? 1 : 0;
    if (occurs > most) {
      most = occurs;
      best = i;
    }
  }
  std::map<unsigned, Terms, std::greater<>> groups;
  for (auto t : terms) {
    const unsigned e = t.exponents[best];
    t.exponents[best] = 0;
    groups[e].push_back(std::move(t));
  }
  return {best, std::move(groups)};
}

template <class Terms>
bool is_constant(const Terms& terms) {
  return terms.size() == 1 &&
         std::all_of(terms[0].exponents.begin(), terms[0].exponents.end(), [](unsigned e) { return e == 0; });
}

}  // namespace

int Program::same_sign(const Terms& terms, const std::vector<std::string>& names) {
  if (is_constant(terms)) return number(terms[0].coefficient);
  const auto [place, groups] = by_powers(terms, names.size());
  const int x = variable(names[place]);
  int value = -1;
  unsigned before = 0;
  for (const auto& [exponent, part] : groups) {
    const int c = same_sign(part, names);
    value = value < 0 ? c : binary(Kind::add, binary(Kind::multiply, value, power(x, before - exponent)), c);
    before = exponent;
  }
  return before == 0 ? value : binary(Kind::multiply, value, power(x, before));
}

int Program::in_pairs(const Terms& terms, const std::vector<std::string>& names) {
  if (is_constant(terms)) return pair_number(terms[0].coefficient);
  const auto [place, groups] = by_powers(terms, names.size());
  const int x = variable(names[place]);
  const auto times = [&](int pair, unsigned exponent) {
    for (; exponent > 0; --exponent) {
      Operation o{Kind::pair_times};
      o.a = pair;
      o.b = x;
      pair = insert(std::move(o));
    }
    return pair;
  };
  int value = -1;
  unsigned before = 0;
  for (const auto& [exponent, part] : groups) {
    const int c = in_pairs(part, names);
    if (value < 0) {
      value = c;
    } else {
      Operation o{Kind::pair_step};
      o.a = times(value, before - exponent - 1);
      o.b = x;
      o.c = c;
      value = insert(std::move(o));
    }
    before = exponent;
  }
  return times(value, before);
}

int Program::polynomial(const Polynomial& p) {
  const std::vector<std::string>& names = p.variables();
  Terms terms;
  p.for_each_term([&](const Rational& c, std::span<const unsigned long> e) {
    Term t{{}, c};
    for (size_t i = 0; i < names.size(); ++i) t.exponents.push_back(static_cast<unsigned>(e[i]));
    terms.push_back(std::move(t));
  });
  if (one_sign(terms, names)) return same_sign(terms, names);
  if (terms.size() == 2 && exact_term(terms[0]) && exact_term(terms[1])) {
    const int a = exact_value(terms[0], names), b = exact_value(terms[1], names);
    const int first = terms[0].coefficient.sign(), second = terms[1].coefficient.sign();
    if (first > 0) return binary(second > 0 ? Kind::add : Kind::subtract, a, b);
    return second > 0 ? binary(Kind::subtract, b, a) : negate(binary(Kind::add, a, b));
  }
  Operation o{Kind::round};
  o.a = in_pairs(terms, names);
  o.error = rounded_pair;
  return insert(std::move(o));
}

// ---- Products

int Program::product(const Product& factors) {
  if (factors.empty()) return number(1);
  int value = factors[0];
  for (size_t i = 1; i < factors.size(); ++i) value = binary(Kind::multiply, value, factors[i]);
  return value;
}

// As long as two factors (or the square of one) stand together in several products, they become one factor.
void Program::share(std::vector<Product*>& products) {
  for (;;) {
    std::map<std::pair<int, int>, unsigned> together;
    for (const Product* p : products) {
      std::set<std::pair<int, int>> pairs;
      for (size_t i = 0; i < p->size(); ++i)
        for (size_t j = i + 1; j < p->size(); ++j) pairs.emplace((*p)[i], (*p)[j]);
      for (const auto& pair : pairs) ++together[pair];
    }
    std::pair<int, int> best;
    unsigned most = 1;
    for (const auto& [pair, times] : together)
      if (times > most) {
        most = times;
        best = pair;
      }
    if (most == 1) return;
    const int value = binary(Kind::multiply, best.first, best.second);
    for (Product* p : products)
      for (;;) {
        const auto first = std::find(p->begin(), p->end(), best.first);
        if (first == p->end()) break;
        const auto second = std::find(first + 1, p->end(), best.second);
        if (second == p->end()) break;
        p->erase(second);
        p->erase(first);
        p->insert(std::upper_bound(p->begin(), p->end(), value), value);
      }
  }
}

std::vector<int> Program::add(const std::vector<RationalFunction>& functions) {
  struct Quotient {
    bool negative = false;
    Product above, below;
  };
  std::vector<RationalFunction> distinct;
  std::vector<size_t> place;
  std::vector<Quotient> quotients;
  for (const RationalFunction& f : functions) {
    const auto same = std::find(distinct.begin(), distinct.end(), f);
    place.push_back(static_cast<size_t>(same - distinct.begin()));
    if (same != distinct.end()) continue;
    distinct.push_back(f);
    Quotient q;
    if (f.is_zero()) {
      q.above.push_back(number(0));
    } else {
      const auto factored = f.numerator().factor();
      q.negative = factored.content.sign() < 0;
      const Rational content = abs(factored.content);
      if (content != Rational(1)) q.above.push_back(number(content));
      if (f.denominator_content() != Rational(1)) q.below.push_back(number(f.denominator_content()));
      const auto put = [&](Product& product, const RationalFunction::Factors& factors) {
        for (const auto& [factor, exponent] : factors) product.insert(product.end(), exponent, polynomial(factor));
        std::sort(product.begin(), product.end());
      };
      put(q.above, factored.factors);
      put(q.below, f.denominator_factors());
    }
    quotients.push_back(std::move(q));
  }
  // Equal products are one product; sharing goes on among the others.
  std::set<Product> seen;
  std::vector<Product*> products;
  for (Quotient& q : quotients)
    for (Product* p : {&q.above, &q.below})
      if (seen.insert(*p).second) products.push_back(p);
  std::vector<Product> originals;
  for (const Product* p : products) originals.push_back(*p);
  share(products);
  std::map<Product, Product> shared;
  for (size_t i = 0; i < products.size(); ++i) shared.emplace(originals[i], *products[i]);
  const auto value_of = [&](const Product& p) {
    const auto found = shared.find(p);
    return product(found == shared.end() ? p : found->second);
  };
  std::vector<int> values;
  for (const Quotient& q : quotients) {
    const int above = value_of(q.above);
    const int quotient = binary(Kind::divide, q.negative ? negate(above) : above, value_of(q.below));
    values.push_back(quotient);
  }
  std::vector<int> result;
  for (const size_t i : place) {
    result.push_back(values[i]);
    ++operations_[static_cast<size_t>(values[i])].uses;
  }
  return result;
}

bool Program::has_pairs() const {
  return std::any_of(operations_.begin(), operations_.end(), [](const Operation& o) { return o.is_pair(); });
}

bool Program::uses(const std::string& name) const {
  return std::any_of(operations_.begin(), operations_.end(),
                     [&](const Operation& o) { return o.kind == Kind::variable && o.name == name; });
}

unsigned Program::count(Kind kind) const {
  return static_cast<unsigned>(
      std::count_if(operations_.begin(), operations_.end(), [&](const Operation& o) { return o.kind == kind; }));
}

}  // namespace twoscale::lowering::emit
