// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/symbolic/rational_function.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "polynomial_coefficients.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/integer.hpp"

namespace twoscale {

namespace {

using Factors = RationalFunction::Factors;

Polynomial integer_polynomial(const Rational& integer) { return Polynomial::constant(integer.numerator()); }

Polynomial expand(const Factors& factors) {
  Polynomial p = 1;
  for (const auto& [f, e] : factors) p *= f.pow(e);
  return p;
}

// Merges two sorted factor lists; exponent = combine(e_a, e_b), entries with 0 are dropped.
template <class Combine>
Factors merge(const Factors& a, const Factors& b, Combine combine) {
  Factors r;
  const auto add = [&](const Polynomial& f, unsigned e) {
    if (e != 0) r.emplace_back(f, e);
  };
  auto i = a.begin();
  auto j = b.begin();
  while (i != a.end() || j != b.end()) {
    const int order = i == a.end() ? 1 : j == b.end() ? -1 : Polynomial::compare(i->first, j->first);
    if (order < 0) {
      add(i->first, combine(i->second, 0U));
      ++i;
    } else if (order > 0) {
      add(j->first, combine(0U, j->second));
      ++j;
    } else {
      add(i->first, combine(i->second, j->second));
      ++i, ++j;
    }
  }
  return r;
}

// An integer at which no factor of a subdivision symbol is small or zero (their zeros are cosines).
constexpr long probe_point = 1009;
constexpr long probe_from_degree = 8;

unsigned larger(unsigned a, unsigned b) { return std::max(a, b); }
unsigned missing(unsigned a, unsigned b) { return a > b ? a - b : 0; }

}  // namespace

RationalFunction::RationalFunction(const Rational& r)
    : numerator_(Polynomial::constant(r.numerator())), content_(Rational(r.denominator())) {}

RationalFunction RationalFunction::over_factors(Polynomial numerator, const Rational& content, Factors factors) {
  RationalFunction r;
  if (content.is_zero()) bad_input("division by zero");
  if (numerator.is_zero()) return r;
  // f | numerator in Z[v] implies f(x) | numerator(x) at an integer x: one evaluation spares nearly all trial divisions
  // that would fail. For one variable and degrees that are not small only, where it is cheap.
  const bool univariate = numerator.variables().size() == 1 && numerator.total_degree() >= probe_from_degree;
  Integer at, value, divisor;
  fmpz_set_si(at.v, probe_point);
  const auto probe = [&](const Polynomial& p, Integer& into) {
    fmpz_poly_evaluate_fmpz(into.v, p.univariate_view(), at.v);
  };
  if (univariate) probe(numerator, value);
  for (auto& [f, e] : factors) {
    const bool probed = univariate && f.variables() == numerator.variables();
    if (probed) probe(f, divisor);
    while (e > 0) {
      if (probed && !fmpz_is_zero(divisor.v) && fmpz_divisible(value.v, divisor.v) == 0) break;
      auto q = Polynomial::quotient(numerator, f);
      if (!q) break;
      numerator = *std::move(q);
      if (univariate) probe(numerator, value);
      --e;
    }
    if (numerator.is_constant()) break;
  }
  std::erase_if(factors, [](const auto& fe) { return fe.second == 0; });
  std::sort(factors.begin(), factors.end(),
            [](const auto& a, const auto& b) { return Polynomial::compare(a.first, b.first) < 0; });
  // Both contents are divided by their greatest common divisor, which carries the denominator of a fractional one.
  Rational common = gcd(numerator.content(), content);
  if (content.sign() < 0) common = -common;
  const Rational times = common.inverse();
  r.numerator_ = numerator.scaled(times);
  r.content_ = content * times;
  r.factors_ = std::move(factors);
  return r;
}

RationalFunction RationalFunction::fraction(const Polynomial& numerator, const Polynomial& denominator) {
  if (denominator.is_zero()) bad_input("division by zero");
  auto f = denominator.factor();
  return over_factors(numerator, f.content, std::move(f.factors));
}

Polynomial RationalFunction::denominator() const { return integer_polynomial(content_) * expand(factors_); }

std::optional<Rational> RationalFunction::constant() const {
  if (!factors_.empty() || !numerator_.is_constant()) return std::nullopt;
  return numerator_.constant_value() / content_;
}

std::vector<std::string> RationalFunction::variables() const {
  std::set<std::string> names(numerator_.variables().begin(), numerator_.variables().end());
  for (const auto& [f, e] : factors_) names.insert(f.variables().begin(), f.variables().end());
  return {names.begin(), names.end()};
}

bool RationalFunction::is_canonical() const {
  if (numerator_.is_zero()) return content_ == Rational(1) && factors_.empty();
  if (content_.sign() <= 0 || !content_.is_integer() || gcd(content_, numerator_.content()) != Rational(1))
    return false;
  for (size_t i = 0; i < factors_.size(); ++i) {
    const auto& [f, e] = factors_[i];
    const auto g = f.factor();
    if (e == 0 || f.leading_sign() <= 0 || g.content != Rational(1) || g.factors.size() != 1 ||
        g.factors[0].second != 1)
      return false;
    if (Polynomial::quotient(numerator_, f)) return false;
    if (i > 0 && Polynomial::compare(factors_[i - 1].first, f) >= 0) return false;
  }
  return true;
}

RationalFunction operator+(const RationalFunction& a, const RationalFunction& b) {
  if (a.is_zero()) return b;
  if (b.is_zero()) return a;
  const Factors all = merge(a.factors_, b.factors_, larger);
  const Rational content = a.content_ * b.content_ / gcd(a.content_, b.content_);
  const Polynomial x = (a.numerator_ * expand(merge(all, a.factors_, missing))).scaled(content / a.content_);
  const Polynomial y = (b.numerator_ * expand(merge(all, b.factors_, missing))).scaled(content / b.content_);
  return RationalFunction::over_factors(x + y, content, all);
}

RationalFunction operator-(const RationalFunction& a, const RationalFunction& b) { return a + (-b); }

RationalFunction operator*(const RationalFunction& a, const RationalFunction& b) {
  if (a.is_one()) return b;
  if (b.is_one()) return a;
  return RationalFunction::over_factors(a.numerator_ * b.numerator_, a.content_ * b.content_,
                                        merge(a.factors_, b.factors_, [](unsigned x, unsigned y) { return x + y; }));
}

RationalFunction operator/(const RationalFunction& a, const RationalFunction& b) { return a * b.inverse(); }

RationalFunction RationalFunction::operator-() const {
  RationalFunction r = *this;
  r.numerator_ = -r.numerator_;
  return r;
}

bool operator==(const RationalFunction& a, const RationalFunction& b) {
  return a.content_ == b.content_ && a.factors_ == b.factors_ && a.numerator_ == b.numerator_;
}

RationalFunction RationalFunction::inverse() const {
  if (is_zero()) bad_input("division by zero");
  return fraction(denominator(), numerator_);
}

RationalFunction RationalFunction::pow(long exponent) const {
  if (exponent < 0) return inverse().pow(-exponent);
  RationalFunction r = *this;
  r.numerator_ = numerator_.pow(static_cast<unsigned>(exponent));
  r.content_ = content_.pow(exponent);
  for (auto& [f, e] : r.factors_) e *= static_cast<unsigned>(exponent);
  if (exponent == 0) r.factors_.clear();
  return r;
}

RationalFunction RationalFunction::substitute(const std::string& variable, const RationalFunction& by) const {
  // p(n/d) = (sum_e c_e n^e d^(D-e))/d^D, D the degree.
  const Polynomial d = by.denominator();
  const auto into = [&](const Polynomial& p) {
    const std::vector<Polynomial> c = coefficients_of(p, variable);
    Polynomial sum, power = 1;
    for (size_t e = c.size(); e-- > 0;) {
      sum = sum * by.numerator() + c[e] * power;
      if (e > 0) power *= d;
    }
    const auto degree = static_cast<unsigned>(c.size() - 1);
    Factors factors = by.factors_;
    for (auto& [f, e] : factors) e *= degree;
    return over_factors(std::move(sum), by.content_.pow(static_cast<long>(degree)), std::move(factors));
  };
  RationalFunction denominator = RationalFunction(content_);
  for (const auto& [f, e] : factors_) denominator *= into(f).pow(static_cast<long>(e));
  return into(numerator_) / denominator;
}

std::optional<Rational> RationalFunction::evaluate(const std::vector<std::pair<std::string, Rational>>& at) const {
  Rational d = content_;
  for (const auto& [f, e] : factors_) d *= f.evaluate(at).pow(static_cast<long>(e));
  if (d.is_zero()) return std::nullopt;
  return numerator_.evaluate(at) / d;
}

namespace {

std::string power(const Polynomial& f, unsigned e, Polynomial::Style style) {
  std::string s = f.pretty(style);
  if (f.terms() > 1 || (e > 1 && f.total_degree() > 1))
    s = (style == Polynomial::Style::latex ? "\\left(" + s + "\\right)" : "(" + s + ")");
  if (e > 1) s += style == Polynomial::Style::latex ? "^{" + std::to_string(e) + "}" : "^" + std::to_string(e);
  return s;
}

struct Product {
  std::string text;
  size_t members = 0;
};

// content (a positive integer) times the factors; content 1 is not written unless it stands alone.
Product product(const Rational& content, const Factors& factors, Polynomial::Style style) {
  Product r;
  const std::string times = style == Polynomial::Style::latex ? " " : "*";
  if (content != Rational(1) || factors.empty()) {
    r.text = content.to_string();
    r.members = 1;
  }
  for (const auto& [f, e] : factors) {
    r.text += (r.text.empty() ? "" : times) + power(f, e, style);
    ++r.members;
  }
  return r;
}

constexpr long factor_numerator_up_to = 16;  // total degree; beyond it factoring costs more than reading gains

}  // namespace

std::string RationalFunction::to_string(Polynomial::Style style) const {
  const bool latex = style == Polynomial::Style::latex;
  if (is_zero()) return "0";
  if (numerator_.is_constant() && factors_.empty()) {
    const Rational value = *constant();
    if (!latex || value.is_integer()) return value.to_string();
  }
  std::string sign;
  std::string top;
  bool sum = false;
  if (numerator_.total_degree() <= factor_numerator_up_to) {
    const auto f = numerator_.factor();
    sign = f.content.sign() < 0 ? "-" : "";
    if (abs(f.content) == Rational(1) && f.factors.size() == 1 && f.factors[0].second == 1) {
      top = f.factors[0].first.pretty(style);
      sum = f.factors[0].first.terms() > 1;
    } else {
      top = product(abs(f.content), f.factors, style).text;
    }
  } else {
    const bool negative = numerator_.leading_sign() < 0;
    sign = negative ? "-" : "";
    top = (negative ? -numerator_ : numerator_).pretty(style);
    sum = true;
  }
  if (content_ == Rational(1) && factors_.empty()) {
    if (sum && !sign.empty()) return latex ? "-\\left(" + top + "\\right)" : "-(" + top + ")";
    return sign + top;
  }
  const Product bottom = product(content_, factors_, style);
  if (latex) return sign + "\\frac{" + top + "}{" + bottom.text + "}";
  const bool plain_bottom = bottom.members == 1 && (content_ != Rational(1) || factors_[0].first.total_degree() == 1 ||
                                                    factors_[0].first.terms() > 1);
  // A single factor with several terms is already parenthesised by power().
  return sign + (sum ? "(" + top + ")" : top) + "/" + (plain_bottom ? bottom.text : "(" + bottom.text + ")");
}

Polynomial CommonDenominator::expanded() const { return integer_polynomial(content) * expand(factors); }

CommonDenominator common_denominator(std::span<const RationalFunction> values) {
  CommonDenominator r;
  for (const auto& v : values) {
    r.content = r.content * v.denominator_content() / gcd(r.content, v.denominator_content());
    r.factors = merge(r.factors, v.denominator_factors(), larger);
  }
  return r;
}

Polynomial numerator_over(const RationalFunction& value, const CommonDenominator& denominator) {
  return value.numerator() * expand(merge(denominator.factors, value.denominator_factors(), missing)) *
         integer_polynomial(denominator.content / value.denominator_content());
}

}  // namespace twoscale
