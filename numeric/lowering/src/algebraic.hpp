// SPDX-License-Identifier: GPL-3.0-or-later
// Exact zero tests at the values of level variables and constants.
//
// The minimal polynomial of v^{[k+1]} is the irreducible factor of M_k(R(x)) that vanishes there (R = T_m, or another
// relation), M_k that of v^{[k]}. Degrees never decrease with k (Q(v^{[k]}) lies in Q(v^{[k+1]})), so a polynomial of smaller degree than some
// M_j, j <= k, cannot vanish at v^{[k]}; otherwise P(v^{[k]}) = 0 iff M_k divides P. In several variables a zero is
// proved by Liouville's bound: if c_i is the leading coefficient and d_i the degree of the i-th minimal polynomial, A =
// prod c_i^{deg_i P} and |P| <= B at all conjugates, then P = 0 or |P| >= A^{-1} (A B)^{1 - prod d_i}.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "twoscale/lowering/lower.hpp"

namespace twoscale::lowering {

// Of a number written as a rational, cos or sin of a rational multiple of pi, or of degree up to 6 with a provable
// zero; in the variable "x", primitive, irreducible. nullopt if it is not found.
std::optional<Polynomial> minimal_polynomial_of(const ExactReal& x);
// exp, cosh, cos, ... of a rational other than 0 (Lindemann). False if it is not known.
bool known_transcendental(const ExactReal& x);

// One variable of a mask: a level variable or a constant.
struct Variable {
  std::string name;
  const LevelValue* level = nullptr;  // one of the two
  const ExactReal* constant = nullptr;
};

enum class Zero { yes, no, unknown };

class ZeroTest {
 public:
  explicit ZeroTest(std::vector<Variable> variables);

  const std::vector<Variable>& variables() const { return variables_; }
  // Is p = 0 at the level variables v^{[k]} and the constants?
  Zero at_level(const Polynomial& p, unsigned k);
  // At level variables 1.
  Zero at_limit(const Polynomial& p);
  // The value of the variable at level k, if it is a rational number.
  std::optional<Rational> rational(size_t variable, unsigned k);
  // p at the variables of level k (level variables 1 if none), enclosed with `bits` of working precision.
  Ball value(const Polynomial& p, std::optional<unsigned> k, long bits) const;

 private:
  struct Tower {
    std::vector<Polynomial> minimal;  // of v^{[0]}, v^{[1]}, ...
    bool started = false;
    bool known = false;
    bool transcendental = false;
  };
  enum class Found { polynomial, degree_exceeded, transcendental, unknown };
  Found minimal(size_t variable, unsigned k, long cap, Polynomial& result);
  Zero decide(const Polynomial& p, std::optional<unsigned> k);
  size_t index_of(const std::string& name) const;

  std::vector<Variable> variables_;
  std::vector<Tower> towers_;
};

}  // namespace twoscale::lowering
