// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Sparse polynomials: the canonical spelling and a little arithmetic.
#include "twoscale/check/polynomial.hpp"

#include "twoscale/check/number.hpp"

#include <algorithm>

namespace twoscale::check {
namespace {

constexpr std::uint64_t term_bytes = 128;  // a map node with its monomial and a small coefficient
constexpr std::uint64_t term_work = 150;   // one look-up in the map
constexpr std::uint64_t polynomial_bytes = std::uint64_t{1} << 27;  // a polynomial that is being computed

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

class Reader {
 public:
  Reader(std::string_view text, std::span<const std::string> names, const std::string& where, Meter& meter)
      : text_(text), names_(names), where_(where), meter_(meter) {}

  Polynomial read() {
    Polynomial result;
    if (text_ == "0") return result;
    do {
      const bool first = result.empty();
      const bool negative = peek() == '-';
      if (negative || (!first && peek() == '+'))
        ++at_;
      else if (!first)
        fail("'+' or '-' is expected");
      auto [monomial, coefficient] = term();
      if (!first && !(monomial < result.rbegin()->first)) fail("monomials must descend");
      if (negative) coefficient = -coefficient;
      meter_.hold(term_bytes + 8 * words(coefficient));
      meter_.spend(term_work);
      result.emplace_hint(result.end(), monomial, std::move(coefficient));
    } while (at_ < text_.size());
    return result;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw Malformed(where_ + ": polynomial, character " + std::to_string(at_) + ": " + what);
  }
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  std::string_view digits() {
    const std::size_t start = at_;
    while (is_digit(peek())) ++at_;
    const std::string_view run = text_.substr(start, at_ - start);
    if (run.empty() || run.front() == '0') fail("a positive integer without leading zeros is expected");
    return run;
  }

  std::pair<Monomial, Integer> term() {
    Monomial monomial{};
    Integer coefficient = 1;
    if (is_digit(peek())) {
      const std::string_view run = digits();
      coefficient = parse_digits(run, where_, meter_);
      if (peek() != '*') return {monomial, coefficient};
      if (run == "1") fail("the coefficient 1 is not written");
      ++at_;
    }
    std::size_t next = 0;  // variables before this one may not follow
    while (true) {
      const std::size_t index = variable();
      if (index < next) fail("variables out of order");
      next = index + 1;
      int exponent = 1;
      if (peek() == '^') {
        ++at_;
        const std::string_view run = digits();
        if (run.size() > 4 || run == "1") fail("exponents are 2.." + std::to_string(limits::degree));
        exponent = std::stoi(std::string(run));
        if (exponent > limits::degree) fail("exponents are 2.." + std::to_string(limits::degree));
      }
      monomial[index] = exponent;
      if (peek() != '*') return {monomial, coefficient};
      ++at_;
    }
  }

  std::size_t variable() {
    const std::size_t start = at_;
    while (is_letter(peek()) || is_digit(peek()) || peek() == '_') ++at_;
    const std::string_view name = text_.substr(start, at_ - start);
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end()) fail("one of the variables is expected");
    return static_cast<std::size_t>(found - names_.begin());
  }

  std::string_view text_;
  std::span<const std::string> names_;
  const std::string& where_;
  Meter& meter_;
  std::size_t at_ = 0;
};

}  // namespace

Polynomial parse_polynomial(std::string_view text, std::span<const std::string> names, const std::string& where,
                            Meter& meter) {
  return Reader(text, names, where, meter).read();
}

void add_term(Polynomial& target, const Monomial& monomial, const Integer& amount, Meter& meter) {
  if (amount == 0) return;
  const auto [place, fresh] = target.try_emplace(monomial);
  meter.spend((fresh ? 2 : 1) * term_work + words(amount));
  place->second += amount;
  if (target.size() * (term_bytes + 8 * words(place->second)) > polynomial_bytes) {
    throw Malformed("the certificate leads to polynomials beyond the memory limit of the checker");
  }
  if (place->second == 0) target.erase(place);
}

void add_scaled(Polynomial& target, const Polynomial& p, const Integer& factor, const Monomial& shift, Meter& meter) {
  if (factor == 0) return;
  for (const auto& [monomial, coefficient] : p) {
    Monomial key = monomial;
    for (std::size_t i = 0; i < key.size(); ++i) key[i] += shift[i];
    add_term(target, key, meter.multiply(coefficient, factor), meter);
  }
}

Polynomial product(const Polynomial& a, const Polynomial& b, Meter& meter) {
  Polynomial result;
  for (const auto& [monomial, coefficient] : a) add_scaled(result, b, coefficient, monomial, meter);
  return result;
}

std::optional<Polynomial> quotient(const Polynomial& p, const Polynomial& g, Meter& meter) {
  if (p.empty()) return Polynomial{};
  for (const auto& [monomial, coefficient] : p) meter.spend(term_work + words(coefficient));
  const Monomial top = degrees(p);
  const Monomial divisor_top = degrees(g);
  const auto& [lead, lead_coefficient] = *g.begin();
  Polynomial rest = p;
  Polynomial result;
  while (!rest.empty()) {
    Monomial shift = rest.begin()->first;
    for (std::size_t i = 0; i < shift.size(); ++i) {
      shift[i] -= lead[i];
      if (shift[i] < 0 || shift[i] > top[i] - divisor_top[i]) return std::nullopt;
    }
    meter.spend(3 * words(rest.begin()->second) * words(lead_coefficient) + term_work);
    Integer factor, remainder;
    divide_qr(rest.begin()->second, lead_coefficient, factor, remainder);
    if (remainder != 0) return std::nullopt;
    add_scaled(rest, g, -factor, shift, meter);
    result.emplace_hint(result.end(), shift, std::move(factor));
  }
  return result;
}

Monomial degrees(const Polynomial& p) {
  Monomial top{};
  for (const auto& [monomial, coefficient] : p) {
    for (std::size_t i = 0; i < top.size(); ++i) top[i] = std::max(top[i], monomial[i]);
  }
  return top;
}

Polynomial at_one(const Polynomial& p, std::span<const std::size_t> variables, Meter& meter) {
  Polynomial result;
  for (const auto& [monomial, coefficient] : p) {
    Monomial rest = monomial;
    for (const std::size_t i : variables) rest[i] = 0;
    add_term(result, rest, coefficient, meter);
  }
  return result;
}

Integer content(const Polynomial& p, Meter& meter) {
  Integer result = 0;
  for (const auto& [monomial, coefficient] : p) {
    if (result == 1) break;
    result = meter.gcd(result, coefficient);
  }
  return result;
}

}  // namespace twoscale::check
