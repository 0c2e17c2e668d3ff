// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. What a certificate is about: a mask with its variables, or matrices; spaces.
#pragma once

#include "twoscale/check/hermite.hpp"
#include "twoscale/check/json.hpp"
#include "twoscale/check/knot_rule.hpp"
#include "twoscale/check/matrix.hpp"
#include "twoscale/check/number.hpp"
#include "twoscale/check/polynomial.hpp"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace twoscale::check {

/// a_i = numerators[i - lowest]/denominator for lowest <= i <= highest(), 0 elsewhere; first and last numerator not 0.
struct Mask {
  long lowest = 0;
  std::vector<Polynomial> numerators;
  Polynomial denominator;
  Monomial top{};  ///< largest exponent of each variable in numerators and denominator

  long highest() const { return lowest + static_cast<long>(numerators.size()) - 1; }
};

/// A mask, and what it takes to read one.
struct Certificate {
  int arity = 2;                       ///< m
  std::vector<std::string> names;      ///< of the variables, sorted
  std::vector<std::size_t> level;      ///< indices of the level variables
  std::vector<std::size_t> constants;  ///< of the others: identities hold for all their values
  std::vector<std::size_t> limits;     ///< of those that tend to 1: scopes level and sequence
  SmallFraction shift;                 ///< p: f^k_j belongs to (j + p)/m^k
  SmallFraction e;                     ///< (m-1)p in lowest terms
  Mask mask;
  std::optional<KnotRule> knots;  ///< the rule on arbitrary knots whose mask on equal ones this is
  bool symmetric = false;         ///< a_{lowest+highest-i} = a_i (found, not read)

  /// Exactly one variable, and it belongs to the level: exceptions are angles, otherwise polynomial conditions.
  bool single_level() const { return names.size() == 1 && level.size() == 1; }
};

/// Square matrices of one size; at least one.
struct Family {
  std::vector<Matrix> matrices;
};

/// Nothing: the claims state themselves what they are about.
struct Standalone {};

/// Everything before "claims".
struct Head {
  std::string scheme;  ///< a label, not checked
  std::variant<Certificate, Family, HermiteRules, Standalone> subject;
};

/// x^j exp(theta x), j < order, exp(theta/m^{k+1}) = product of E_i^frequency[i] over the level variables.
struct Exponential {
  std::vector<long> frequency;
  long order = 1;
};
using Space = std::vector<Exponential>;

/// Reads everything before "claims".
Head read_head(Fields& fields, Meter& meter);

/// Reads a space: sorted by frequency, distinct, orders 1..512; empty only where allowed.
Space read_space(const Value& value, const Certificate& certificate, const std::string& where, bool may_be_empty);
std::vector<long> read_frequency(const Value& value, const Certificate& certificate, const std::string& where);

long dimension(const Space& space);
/// Order of the frequency in the space, 0 if it does not occur.
long order_in(const Space& space, const std::vector<long>& frequency);

/// `{1, x, exp(t*x), exp(-t*x)}`, made from the data alone; frequencies are named after the variables: v -> t, v_s ->
/// s.
std::string text_of(const Space& space, const Certificate& certificate);
std::string frequency_name(const Certificate& certificate, std::size_t level_index);

}  // namespace twoscale::check
