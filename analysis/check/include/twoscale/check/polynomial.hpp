// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Sparse (Laurent) polynomials with integer coefficients in up to 8 variables.
#pragma once

#include "twoscale/check/meter.hpp"

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace twoscale::check {

/// Exponents of the variables, in their order; unused places are 0.
using Monomial = std::array<int, limits::variables>;

/// Terms by monomial, lexicographically descending (the canonical order); no zero coefficients. Exponents may be
/// negative.
using Polynomial = std::map<Monomial, Integer, std::greater<>>;

/// Reads exactly the canonical spelling: `3*v_s^2*v_t-v_t+1`, monomials descending, no blanks, 1 and ^1 not written.
Polynomial parse_polynomial(std::string_view text, std::span<const std::string> names, const std::string& where,
                            Meter& meter);

/// target += amount * x^monomial.
void add_term(Polynomial& target, const Monomial& monomial, const Integer& amount, Meter& meter);

/// target += factor * x^shift * p.
void add_scaled(Polynomial& target, const Polynomial& p, const Integer& factor, const Monomial& shift, Meter& meter);

/// a*b.
Polynomial product(const Polynomial& a, const Polynomial& b, Meter& meter);

/// p/g over Z if the polynomial g (not zero, exponents >= 0) divides p.
std::optional<Polynomial> quotient(const Polynomial& p, const Polynomial& g, Meter& meter);

/// Largest exponent of each variable (0 for the zero polynomial).
Monomial degrees(const Polynomial& p);

/// p with the listed variables set to 1.
Polynomial at_one(const Polynomial& p, std::span<const std::size_t> variables, Meter& meter);

/// Greatest common divisor of the coefficients.
Integer content(const Polynomial& p, Meter& meter);

}  // namespace twoscale::check
