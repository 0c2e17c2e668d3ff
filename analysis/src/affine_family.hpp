// SPDX-License-Identifier: GPL-3.0-or-later
// A mask whose remainder c(w) = c_0 + w c_1 is affine in one parameter, with everything that is polynomial in w.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "twoscale/analysis/parameter_range.hpp"

namespace twoscale::analysis {

using PolynomialMatrix = std::vector<std::vector<Polynomial>>;
Polynomial determinant_of(const PolynomialMatrix& a);
// The product in the order of the word, its first letter acting first.
PolynomialMatrix product_of(const std::vector<PolynomialMatrix>& b, const Word& word);

class AffineFamily {
 public:
  // Throws Error(bad_input) if `name` is not the only parameter, or c(w) is not affine in it, or the mask has sum other
  // than the arity, or no sum rule holds for all w.
  AffineFamily(const Scheme& scheme, std::string name);

  const std::string& name() const { return name_; }
  long arity() const { return arity_; }
  long order() const { return order_; }  // N for all w at once
  bool symmetric() const;
  // The only w, if there is one, where another sum rule holds.
  std::optional<Rational> exceptional() const;
  // c(w), the ends kept even if they vanish there.
  Remainder remainder_at(const Rational& w) const;
  Family matrices_at(const Rational& w) const { return transition_matrices(remainder_at(w)); }

  // Polynomials in x and w, up to a positive factor. The first two need symmetric().
  Polynomial cosine_polynomial() const;
  Polynomial central_characteristic_polynomial() const;
  // det(tau^n I - sign B_word(w)), a polynomial in w up to a positive factor: negative where sign B_word has a real
  // eigenvalue beyond tau^n.
  Polynomial determinant_beyond(const Word& word, long sign, const Rational& tau) const;

  // denominator() c(w) and the transition matrices times denominator(): integer polynomials in w.
  const Rational& denominator() const { return denominator_; }
  const std::vector<Polynomial>& coefficients() const { return c_; }
  std::vector<PolynomialMatrix> matrices() const;

 private:
  std::string name_;
  long arity_ = 2;
  long order_ = 0;
  Rational denominator_ = 1;
  std::vector<Polynomial> c_;
};

// The zero rho of F(w, x) at the sample w as an expression in w: linear and quadratic F; else empty.
std::string branch_expression(const Polynomial& f, const std::string& name, const Rational& sample,
                              const RealAlgebraic& rho);

// Closed forms outside the non-negative range, by polytopes whose vertices are rational functions of the parameter.
std::vector<RadiusRange> polytope_ranges(const AffineFamily& family, const Rational& from, const Rational& to,
                                         const std::optional<std::pair<RealAlgebraic, RealAlgebraic>>& without,
                                         const JsrOptions& options, std::vector<nlohmann::ordered_json>& claims);

}  // namespace twoscale::analysis
