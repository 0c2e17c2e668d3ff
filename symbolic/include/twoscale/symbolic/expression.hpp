// SPDX-License-Identifier: GPL-3.0-or-later
// Text in: the expressions of the contract (§2) become GiNaC expressions, and these become exact values.
//
// GiNaC is the symbolic face (user formulas, automatic exact values such as cos(pi/3) = 1/2, LaTeX of arbitrary
// expressions). The reader in front of it is ours because GiNaC's reads 0.4 as a floating-point number and would try to
// evaluate 9^9^9; this one keeps decimals exact, bounds sizes and depth, and names the offending piece.
#pragma once

#include <ginac/ginac.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "twoscale/symbolic/exact_real.hpp"
#include "twoscale/symbolic/rational_function.hpp"

namespace twoscale {

// One table for each place where names must mean the same thing: two GiNaC symbols of one name are different objects.
class Symbols {
 public:
  const GiNaC::symbol& operator[](const std::string& name);

 private:
  std::map<std::string, GiNaC::symbol> table_;
};

// Throws Error(bad_input) naming the piece that cannot be read.
GiNaC::ex parse_expression(std::string_view text, Symbols& symbols);

// The names of the symbols that occur, sorted.
std::vector<std::string> names_in(const GiNaC::ex& e);

// Exact conversions; each throws Error(bad_input) naming a sub-expression of another kind.
Rational to_rational(const GiNaC::numeric& n);              // a real rational number
RationalFunction to_rational_function(const GiNaC::ex& e);  // + - * / and integer powers of names and rationals
ExactReal to_exact_real(const GiNaC::ex& e);                // no names, no I
GiNaC::ex to_ginac(const RationalFunction& f, Symbols& symbols);

RationalFunction parse_rational_function(std::string_view text);
ExactReal parse_real(std::string_view text);

// Splits at commas outside ( ), [ ] and quotes; trims blanks. "a, f(b,c)" -> {"a", "f(b,c)"}; "" -> {}.
std::vector<std::string> split_list(std::string_view text);
std::string trimmed(std::string_view text);

}  // namespace twoscale
