// SPDX-License-Identifier: GPL-3.0-or-later
// Laurent polynomials in z over Q(parameters): the symbols a(z) = sum_i a_i z^i of subdivision schemes.
#pragma once

#include <optional>
#include <vector>

#include "twoscale/symbolic/rational_function.hpp"

namespace twoscale {

// Immutable and canonical: first and last coefficient are not zero; the zero polynomial has lowest() 0 and no
// coefficients. Index origin: coefficient(i) is a_i, the factor of z^i.
class Laurent {
 public:
  Laurent() = default;
  // sum_i coefficients[i] z^{lowest+i}; zero ends are trimmed.
  Laurent(long lowest, std::vector<RationalFunction> coefficients);
  static Laurent monomial(long exponent, RationalFunction coefficient = 1);

  long lowest() const { return lowest_; }
  long highest() const { return lowest_ + static_cast<long>(coefficients_.size()) - 1; }
  const std::vector<RationalFunction>& coefficients() const { return coefficients_; }
  RationalFunction coefficient(long index) const;  // 0 outside the support
  bool is_zero() const { return coefficients_.empty(); }
  bool is_canonical() const;
  std::vector<std::string> variables() const;

  friend Laurent operator+(const Laurent& a, const Laurent& b);
  friend Laurent operator-(const Laurent& a, const Laurent& b);
  friend Laurent operator*(const Laurent& a, const Laurent& b);
  friend Laurent operator*(const RationalFunction& c, const Laurent& a);
  friend bool operator==(const Laurent& a, const Laurent& b);

  Laurent shifted(long by) const;                 // z^by a(z)
  Laurent dilated(long m) const;                  // a(z^m), m >= 1
  Laurent subsymbol(long m, long residue) const;  // sum_j a_{mj+residue} z^j
  RationalFunction at_one() const;                // a(1)
  RationalFunction evaluate(const RationalFunction& z) const;
  // a / b if b divides a in Q(parameters)[z, 1/z]; required: b != 0.
  static std::optional<Laurent> quotient(const Laurent& a, const Laurent& b);
  Laurent substitute(const std::string& variable, const RationalFunction& by) const;
  // Middle of the support, (lowest + highest)/2, if a_{2c-i} = a_i for all i.
  std::optional<Rational> centre_of_symmetry() const;

 private:
  long lowest_ = 0;
  std::vector<RationalFunction> coefficients_;
};

}  // namespace twoscale
