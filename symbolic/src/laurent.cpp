// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/symbolic/laurent.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "twoscale/symbolic/error.hpp"

namespace twoscale {

Laurent::Laurent(long lowest, std::vector<RationalFunction> coefficients)
    : lowest_(lowest), coefficients_(std::move(coefficients)) {
  while (!coefficients_.empty() && coefficients_.back().is_zero()) coefficients_.pop_back();
  const auto first =
      std::find_if(coefficients_.begin(), coefficients_.end(), [](const auto& c) { return !c.is_zero(); });
  lowest_ += first - coefficients_.begin();
  coefficients_.erase(coefficients_.begin(), first);
  if (coefficients_.empty()) lowest_ = 0;
}

Laurent Laurent::monomial(long exponent, RationalFunction coefficient) { return {exponent, {std::move(coefficient)}}; }

RationalFunction Laurent::coefficient(long index) const {
  if (index < lowest_ || index > highest()) return 0;
  return coefficients_[static_cast<size_t>(index - lowest_)];
}

bool Laurent::is_canonical() const {
  if (coefficients_.empty()) return lowest_ == 0;
  return !coefficients_.front().is_zero() && !coefficients_.back().is_zero() &&
         std::all_of(coefficients_.begin(), coefficients_.end(), [](const auto& c) { return c.is_canonical(); });
}

std::vector<std::string> Laurent::variables() const {
  std::set<std::string> names;
  for (const auto& c : coefficients_)
    for (const auto& n : c.variables()) names.insert(n);
  return {names.begin(), names.end()};
}

namespace {

template <class Operation>
Laurent termwise(const Laurent& a, const Laurent& b, Operation operation) {
  if (a.is_zero() && b.is_zero()) return {};
  const long low = a.is_zero() ? b.lowest() : b.is_zero() ? a.lowest() : std::min(a.lowest(), b.lowest());
  const long high = a.is_zero() ? b.highest() : b.is_zero() ? a.highest() : std::max(a.highest(), b.highest());
  std::vector<RationalFunction> c;
  for (long i = low; i <= high; ++i) c.push_back(operation(a.coefficient(i), b.coefficient(i)));
  return {low, std::move(c)};
}

}  // namespace

Laurent operator+(const Laurent& a, const Laurent& b) {
  return termwise(a, b, [](const auto& x, const auto& y) { return x + y; });
}

Laurent operator-(const Laurent& a, const Laurent& b) {
  return termwise(a, b, [](const auto& x, const auto& y) { return x - y; });
}

Laurent operator*(const Laurent& a, const Laurent& b) {
  if (a.is_zero() || b.is_zero()) return {};
  // Over the two common denominators the convolution is one of polynomials.
  const CommonDenominator da = common_denominator(a.coefficients_);
  const CommonDenominator db = common_denominator(b.coefficients_);
  std::vector<Polynomial> x, y;
  for (const auto& c : a.coefficients_) x.push_back(numerator_over(c, da));
  for (const auto& c : b.coefficients_) y.push_back(numerator_over(c, db));
  std::vector<Polynomial> z(x.size() + y.size() - 1);
  for (size_t i = 0; i < x.size(); ++i)
    for (size_t j = 0; j < y.size(); ++j)
      if (!x[i].is_zero() && !y[j].is_zero()) z[i + j] += x[i] * y[j];
  RationalFunction::Factors factors = da.factors;
  for (const auto& [f, e] : db.factors) {
    const auto it = std::find_if(factors.begin(), factors.end(), [&f = f](const auto& g) { return g.first == f; });
    if (it == factors.end())
      factors.emplace_back(f, e);
    else
      it->second += e;
  }
  std::vector<RationalFunction> c;
  for (auto& p : z) c.push_back(RationalFunction::over_factors(std::move(p), da.content * db.content, factors));
  return {a.lowest_ + b.lowest_, std::move(c)};
}

Laurent operator*(const RationalFunction& c, const Laurent& a) {
  std::vector<RationalFunction> r;
  for (const auto& x : a.coefficients_) r.push_back(c * x);
  return {a.lowest_, std::move(r)};
}

bool operator==(const Laurent& a, const Laurent& b) {
  return a.lowest_ == b.lowest_ && a.coefficients_ == b.coefficients_;
}

Laurent Laurent::shifted(long by) const { return is_zero() ? *this : Laurent(lowest_ + by, coefficients_); }

Laurent Laurent::dilated(long m) const {
  if (is_zero()) return {};
  std::vector<RationalFunction> c((coefficients_.size() - 1) * static_cast<size_t>(m) + 1);
  for (size_t i = 0; i < coefficients_.size(); ++i) c[i * static_cast<size_t>(m)] = coefficients_[i];
  return {lowest_ * m, std::move(c)};
}

Laurent Laurent::subsymbol(long m, long residue) const {
  std::vector<RationalFunction> c;
  long low = 0;
  for (long i = lowest_; i <= highest(); ++i) {
    if (((i - residue) % m) != 0) continue;
    if (c.empty()) low = (i - residue) / m;
    c.push_back(coefficient(i));
  }
  return {low, std::move(c)};
}

RationalFunction Laurent::at_one() const {
  const CommonDenominator d = common_denominator(coefficients_);
  Polynomial sum;
  for (const auto& c : coefficients_) sum += numerator_over(c, d);
  return RationalFunction::over_factors(std::move(sum), d.content, d.factors);
}

RationalFunction Laurent::evaluate(const RationalFunction& z) const {
  RationalFunction value;
  for (size_t i = coefficients_.size(); i-- > 0;) value = value * z + coefficients_[i];
  return value * z.pow(lowest_);
}

std::optional<Laurent> Laurent::quotient(const Laurent& a, const Laurent& b) {
  if (b.is_zero()) throw std::logic_error("quotient by the zero Laurent polynomial");
  if (a.is_zero()) return Laurent();
  if (a.coefficients_.size() < b.coefficients_.size()) return std::nullopt;
  const size_t n = b.coefficients_.size();
  const size_t length = a.coefficients_.size() - n + 1;
  // A divisor with integer coefficients and leading coefficient 1 divides the numerators over one denominator.
  const bool monic =
      b.coefficients_.back().is_one() && std::all_of(b.coefficients_.begin(), b.coefficients_.end(), [](const auto& c) {
        return c.is_polynomial() && c.denominator_content() == Rational(1);
      });
  std::vector<RationalFunction> q(length);
  if (monic) {
    const CommonDenominator d = common_denominator(a.coefficients_);
    std::vector<Polynomial> rest;
    for (const auto& c : a.coefficients_) rest.push_back(numerator_over(c, d));
    for (size_t i = length; i-- > 0;) {
      const Polynomial top = rest[i + n - 1];
      for (size_t j = 0; j < n; ++j) rest[i + j] -= top * b.coefficients_[j].numerator();
      q[i] = RationalFunction::over_factors(top, d.content, d.factors);
    }
    if (!std::all_of(rest.begin(), rest.end(), [](const auto& c) { return c.is_zero(); })) return std::nullopt;
    return Laurent(a.lowest_ - b.lowest_, std::move(q));
  }
  std::vector<RationalFunction> rest = a.coefficients_;
  const RationalFunction lead = b.coefficients_.back().inverse();
  for (size_t i = length; i-- > 0;) {
    q[i] = rest[i + n - 1] * lead;
    for (size_t j = 0; j < n; ++j) rest[i + j] -= q[i] * b.coefficients_[j];
  }
  if (!std::all_of(rest.begin(), rest.end(), [](const auto& c) { return c.is_zero(); })) return std::nullopt;
  return Laurent(a.lowest_ - b.lowest_, std::move(q));
}

Laurent Laurent::substitute(const std::string& variable, const RationalFunction& by) const {
  std::vector<RationalFunction> c;
  for (const auto& x : coefficients_) c.push_back(x.substitute(variable, by));
  return {lowest_, std::move(c)};
}

std::optional<Rational> Laurent::centre_of_symmetry() const {
  for (size_t i = 0, j = coefficients_.size(); i < j; ++i)
    if (!(coefficients_[i] == coefficients_[--j])) return std::nullopt;
  return Rational(lowest_ + (is_zero() ? 0 : highest()), 2);
}

}  // namespace twoscale
