// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials with integer coefficients in named variables: immutable, canonical, cheap to copy.
//
// The door behind which FLINT works. Storage: fmpz_poly for at most one variable, fmpz_mpoly (lexicographic) for
// several. Canonical form: the variables are exactly those that occur, sorted by name; so two polynomials are equal iff
// their representations are, and no simplification step exists that a caller could forget.
#pragma once

#include <flint/fmpz_mpoly.h>
#include <flint/fmpz_poly.h>

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "twoscale/symbolic/rational.hpp"

namespace twoscale {

class Polynomial {
 public:
  Polynomial() : Polynomial(0L) {}
  Polynomial(long constant);                                             // NOLINT: numbers convert
  Polynomial(int constant) : Polynomial(static_cast<long>(constant)) {}  // NOLINT
  static Polynomial constant(const fmpz_t value);
  static Polynomial variable(const std::string& name);
  // sum_i coefficients[i] name^i.
  static Polynomial univariate(const std::string& name, std::span<const Rational> coefficients);
  static Polynomial univariate(const std::string& name, const fmpz_poly_t coefficients);
  // Chebyshev polynomial T_n(name), n >= 0.
  static Polynomial chebyshev(const std::string& name, unsigned n);
  // Primitive minimal polynomial of cos(2 pi/d) in `name`, positive leading coefficient, d >= 1.
  static Polynomial cosine_minimal(const std::string& name, unsigned d);

  const std::vector<std::string>& variables() const;
  bool is_zero() const;
  bool is_one() const;
  bool is_constant() const { return variables().empty(); }
  // The value of a constant polynomial; required: is_constant().
  Rational constant_value() const;
  long degree(const std::string& variable) const;  // -1 for the zero polynomial
  long total_degree() const;
  long terms() const;
  int leading_sign() const;  // sign of the leading coefficient in lexicographic order; 0 for 0
  Rational content() const;  // positive gcd of the coefficients; 0 for 0
  bool all_coefficients_nonnegative() const;

  friend Polynomial operator+(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator-(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b);
  Polynomial operator-() const;
  Polynomial& operator+=(const Polynomial& o) { return *this = *this + o; }
  Polynomial& operator-=(const Polynomial& o) { return *this = *this - o; }
  Polynomial& operator*=(const Polynomial& o) { return *this = *this * o; }
  friend bool operator==(const Polynomial& a, const Polynomial& b);
  // A total order that depends on nothing but the polynomials (degree, then coefficients); for sorting and printing.
  static int compare(const Polynomial& a, const Polynomial& b);

  Polynomial pow(unsigned exponent) const;
  // factor * *this; required: the result has integer coefficients (checked only in so far as the division is exact).
  Polynomial scaled(const Rational& factor) const;
  // x a + y b; required: x and y integers.
  static Polynomial combination(const Rational& x, const Polynomial& a, const Rational& y, const Polynomial& b);
  // a / b if b divides a over the integers.
  static std::optional<Polynomial> quotient(const Polynomial& a, const Polynomial& b);
  // a / b where the caller knows that b divides a; throws std::logic_error if it does not.
  static Polynomial exact_quotient(const Polynomial& a, const Polynomial& b);
  // Largest e with factor^e | *this, and the cofactor. Required: *this != 0, factor not a unit.
  std::pair<Polynomial, unsigned> remove(const Polynomial& factor) const;

  // Greatest common divisor, content included, positive leading coefficient; gcd(0, b) = +-b.
  static Polynomial gcd(const Polynomial& a, const Polynomial& b);

  // Resultant of a and b as polynomials in `variable`.
  static Polynomial resultant(const Polynomial& a, const Polynomial& b, const std::string& variable);

  Polynomial derivative(const std::string& variable) const;
  // Replace one variable by a polynomial.
  Polynomial substitute(const std::string& variable, const Polynomial& by) const;
  // Value at rationals, one per variable of the list; variables that do not occur are ignored.
  Rational evaluate(const std::vector<std::pair<std::string, Rational>>& at) const;

  // content * prod factor^exponent; factors primitive, irreducible over Q, positive leading coefficient, sorted by
  // compare(); content carries the sign. Required: not 0.
  struct Factorization {
    Rational content;
    std::vector<std::pair<Polynomial, unsigned>> factors;
  };
  Factorization factor() const;

  // Number of distinct real zeros > 0. Required: not 0, at most one variable. Exact (Sturm, on p(x^2) without its zero
  // at 0).
  long positive_zeros() const;

  // Terms in canonical order (exponents compared lexicographically, descending), exponents in the order of variables().
  void for_each_term(const std::function<void(const Rational&, std::span<const unsigned long>)>& f) const;

  // Canonical text, e.g. "64*v^3+128*v^2+64*v", "3*v_s^2*v_t-1", "0": no blanks, terms descending. The form that the
  // certificate format fixes.
  std::string to_string() const;
  // The same for readers: blanks around + and -; `latex`: powers and products as TeX.
  enum class Style { plain, latex };
  std::string pretty(Style style = Style::plain) const;

  // The univariate coefficients; required: at most one variable. For rooms that compute in FLINT or Arb directly.
  const fmpz_poly_struct* univariate_view() const;

  struct Rep;

 private:
  explicit Polynomial(std::shared_ptr<const Rep> rep) : rep_(std::move(rep)) {}
  friend struct PolynomialAccess;
  std::shared_ptr<const Rep> rep_;
};

// How a variable name is typeset: "v_s" -> "v_{s}", greek names as they are known to TeX.
std::string latex_name(const std::string& variable);

}  // namespace twoscale
