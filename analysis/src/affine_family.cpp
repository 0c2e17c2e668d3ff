// SPDX-License-Identifier: GPL-3.0-or-later
#include "affine_family.hpp"

#include <arb.h>

#include "twoscale/analysis/matrix.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::analysis {

Polynomial determinant_of(const PolynomialMatrix& a) {
  const size_t n = a.size();
  SymbolicMatrix m(n, n);
  for (size_t i = 0; i < n; ++i)
    for (size_t j = 0; j < n; ++j) m(i, j) = RationalFunction(a[i][j]);
  return determinant(m).numerator();
}

PolynomialMatrix product_of(const std::vector<PolynomialMatrix>& b, const Word& word) {
  const size_t size = b[0].size();
  PolynomialMatrix p(size, std::vector<Polynomial>(size));
  for (size_t i = 0; i < size; ++i) p[i][i] = 1;
  for (const int s : word) {
    PolynomialMatrix next(size, std::vector<Polynomial>(size));
    for (size_t i = 0; i < size; ++i)
      for (size_t j = 0; j < size; ++j)
        for (size_t k = 0; k < size; ++k)
          if (!b[static_cast<size_t>(s)][i][k].is_zero() && !p[k][j].is_zero())
            next[i][j] += b[static_cast<size_t>(s)][i][k] * p[k][j];
    p = std::move(next);
  }
  return p;
}

AffineFamily::AffineFamily(const Scheme& scheme, std::string name) : name_(std::move(name)), arity_(scheme.arity) {
  bool found = false;
  for (const auto& p : scheme.parameters) {
    if (p.name == name_)
      found = true;
    else
      bad_input("--over: a value is needed for the other parameter (--at " + p.name + "=...)", p.name);
  }
  if (!found) bad_input("--over: the scheme has no parameter of this name", name_);
  Laurent a = symbol(scheme);
  if (!(a.at_one() == RationalFunction(arity_)))
    bad_input("--over: the coefficients do not sum to the arity for every value of", name_);
  const Laurent s(0, std::vector<RationalFunction>(static_cast<size_t>(arity_), RationalFunction(1)));
  while (auto q = Laurent::quotient(a, s)) {
    a = RationalFunction(arity_) * *q;
    ++order_;
  }
  if (order_ == 0) bad_input("--over: no sum rule holds for every value of", name_);
  const CommonDenominator d = common_denominator(a.coefficients());
  if (!d.factors.empty()) bad_input("--over: the remainder has the parameter in a denominator", name_);
  denominator_ = d.content;
  for (const auto& c : a.coefficients()) {
    c_.push_back(numerator_over(c, d));
    if (c_.back().degree(name_) > 1) bad_input("--over: the remainder is not affine in the parameter", name_);
  }
}

bool AffineFamily::symmetric() const { return c_.size() % 2 == 1 && std::equal(c_.begin(), c_.end(), c_.rbegin()); }

std::optional<Rational> AffineFamily::exceptional() const {
  std::vector<Polynomial> sums(static_cast<size_t>(arity_));
  for (size_t i = 0; i < c_.size(); ++i) sums[i % sums.size()] += c_[i];
  Polynomial common = 0;
  for (const auto& s : sums) common = Polynomial::gcd(common, s - sums[0]);
  if (common.degree(name_) != 1) return std::nullopt;
  return RealAlgebraic::zeros(common).front().rational();
}

Remainder AffineFamily::remainder_at(const Rational& w) const {
  Remainder r{arity_, order_, {}};
  for (const auto& c : c_) r.c.push_back(c.evaluate({{name_, w}}) / denominator_);
  return r;
}

std::vector<PolynomialMatrix> AffineFamily::matrices() const {
  const auto n0 = static_cast<long>(c_.size()) - 1;
  const auto size = static_cast<size_t>(std::max(1L, (n0 + arity_ - 2) / (arity_ - 1)));
  std::vector<PolynomialMatrix> list;
  for (long s = 0; s < arity_; ++s) {
    PolynomialMatrix b(size, std::vector<Polynomial>(size));
    for (size_t p = 0; p < size; ++p)
      for (size_t q = 0; q < size; ++q) {
        const long i = n0 + 1 - arity_ + s + static_cast<long>(p) - arity_ * static_cast<long>(q);
        if (i >= 0 && i <= n0) b[p][q] = c_[static_cast<size_t>(i)];
      }
    list.push_back(std::move(b));
  }
  return list;
}

Polynomial AffineFamily::cosine_polynomial() const {
  const size_t h = c_.size() / 2;
  Polynomial p = c_[h];
  for (size_t k = 1; k <= h; ++k) p += Polynomial(2) * c_[h + k] * Polynomial::chebyshev("x", static_cast<unsigned>(k));
  return p;
}

Polynomial AffineFamily::central_characteristic_polynomial() const {
  const auto h = static_cast<long>(c_.size() / 2);
  const long size = std::max(0L, h - 1) / (arity_ - 1) + 1;
  const auto at = [&](long k) { return std::abs(k) <= h ? c_[static_cast<size_t>(h + k)] : Polynomial(0); };
  const Polynomial x = Polynomial::constant(denominator_.numerator()) * Polynomial::variable("x");
  PolynomialMatrix m(static_cast<size_t>(size), std::vector<Polynomial>(static_cast<size_t>(size)));
  for (long i = 0; i < size; ++i)
    for (long j = 0; j < size; ++j) {
      Polynomial& entry = m[static_cast<size_t>(i)][static_cast<size_t>(j)];
      entry = j == 0 ? -at(i) : -(at(i - arity_ * j) + at(i + arity_ * j));
      if (i == j) entry += x;
    }
  return determinant_of(m);
}

Polynomial AffineFamily::determinant_beyond(const Word& word, long sign, const Rational& tau) const {
  PolynomialMatrix p = product_of(matrices(), word);
  const size_t size = p.size();
  // (tau denominator)^n = numerator/divisor: divisor P is compared with the numerator.
  const Rational level = (tau * denominator_).pow(static_cast<long>(word.size()));
  const Polynomial numerator = Polynomial::constant(level.numerator());
  const Polynomial divisor = Polynomial::constant(level.denominator()) * Polynomial(-sign);
  for (size_t i = 0; i < size; ++i)
    for (size_t j = 0; j < size; ++j) {
      p[i][j] *= divisor;
      if (i == j) p[i][j] += numerator;
    }
  return determinant_of(p);
}

std::string branch_expression(const Polynomial& f, const std::string& name, const Rational& sample,
                              const RealAlgebraic& rho) {
  std::vector<Polynomial> coefficient(3);
  const long degree = f.degree("x");
  if (degree < 1 || degree > 2) return "";
  // f as a polynomial in x.
  Polynomial rest = f;
  for (long i = 0; i <= degree; ++i) {
    coefficient[static_cast<size_t>(i)] = rest.substitute("x", 0);
    rest = Polynomial::exact_quotient(rest - coefficient[static_cast<size_t>(i)], Polynomial::variable("x"));
  }
  if (degree == 1) return (-RationalFunction(coefficient[0]) / RationalFunction(coefficient[1])).to_string();
  const Polynomial& a = coefficient[2];
  const Polynomial& b = coefficient[1];
  const Polynomial discriminant = b * b - Polynomial(4) * a * coefficient[0];
  // D = s^2 d, d without square factors.
  Polynomial square = 1;
  Polynomial inside = 1;
  const auto [content, factors] = discriminant.factor();
  Rational number = content;
  for (long p = 2; p < 1000; ++p)
    while ((number / Rational(p * p)).is_integer()) {
      number /= Rational(p * p);
      square *= Polynomial(p);
    }
  for (const auto& [factor, exponent] : factors) {
    square *= factor.pow(exponent / 2);
    if (exponent % 2 == 1) inside *= factor;
  }
  inside = inside.scaled(number);
  const RationalFunction centre = -RationalFunction(b) / (RationalFunction(2) * RationalFunction(a));
  RationalFunction half = RationalFunction(square) / (RationalFunction(2) * RationalFunction(a));
  // The sign of the root: rho against the centre, at the sample.
  const int side = RealAlgebraic::compare(rho, *centre.evaluate({{name, sample}}));
  const int sign = half.evaluate({{name, sample}})->sign();
  if (side * sign < 0) half = -half;
  const std::string root = "sqrt(" + RationalFunction(inside).to_string() + ")";
  std::string text = centre.is_zero() ? "" : centre.to_string();
  const std::string factor = half.to_string();
  if (factor == "1") return text.empty() ? root : text + " + " + root;
  if (factor.front() == '-') {
    const std::string positive = (-half).to_string();
    return text + (text.empty() ? "-" : " - ") + (positive == "1" ? "" : "(" + positive + ")*") + root;
  }
  return (text.empty() ? "" : text + " + ") + "(" + factor + ")*" + root;
}

}  // namespace twoscale::analysis
