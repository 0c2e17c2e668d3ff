// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials in the level variables and constants, rewritten in the offsets u = v - 1 and evaluated in balls.
//
// Powers of u shrink (u = O(m^{-2k})), so they are kept with fewer and fewer bits, and a dot product with the integer
// coefficients follows. A polynomial that vanishes at the limit keeps its relative accuracy.
#pragma once

#include <flint/fmpz_poly.h>

#include <vector>

#include "algebraic.hpp"

namespace twoscale::lowering {

// A polynomial prepared for evaluation.
class Form {
 public:
  // p in the variables of the list; level variables are shifted: the form is a polynomial in v - 1.
  Form(const Polynomial& p, const std::vector<Variable>& variables);
  // `shifted` is already a polynomial in v - 1.
  static Form of_shifted(const Polynomial& shifted, const std::vector<Variable>& variables);
  Form(const Form& o);
  Form(Form&& o) noexcept;
  Form& operator=(Form o) noexcept;
  ~Form();

  const Polynomial& shifted() const { return shifted_; }
  long degree(size_t variable) const;
  long valuation() const { return valuation_; }  // least exponent; one variable only, else 0

 private:
  friend class Point;
  Form() = default;
  void prepare(const std::vector<Variable>& variables);

  struct Term {
    Rational coefficient;
    std::vector<unsigned> exponents;  // by variable index
  };
  Polynomial shifted_;
  int variable_ = -1;  // of a dense form; -1: constant or several variables
  long valuation_ = 0;
  std::vector<long> degrees_;
  std::vector<Term> terms_;  // several variables
};

// The values of all variables with the tables of their powers.
class Point {
 public:
  // degrees[i]: highest power of variable i that will be asked for; valuation: the largest among the forms.
  Point(std::vector<long> degrees, long valuation, bool several);
  // values[i]: offset u or constant.
  void set(const std::vector<const arb_struct*>& values, long bits);
  void evaluate(arb_t result, const Form& form) const;

 private:
  std::vector<long> degrees_;
  long valuation_;
  bool several_;
  long bits_ = 0;
  std::vector<std::vector<Ball>> powers_;
};

// p with v replaced by 1 + v for every level variable.
Polynomial shifted_by_one(const Polynomial& p, const std::vector<Variable>& variables);

}  // namespace twoscale::lowering
