// SPDX-License-Identifier: GPL-3.0-or-later
// Rational functions as a straight-line program: values numbered so that equal parts are computed once. Not installed.
//
// Two sorts of values: reals, and pairs hi + lo that hold twice the precision.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "twoscale/symbolic/rational_function.hpp"

namespace twoscale::lowering::emit {

struct Operation {
  enum class Kind {
    variable,  // name
    number,    // an integer
    add,
    subtract,
    multiply,
    divide,
    negate,
    pair_number,  // an integer as a pair
    pair_times,   // pair a times real b
    pair_step,    // pair a times real b, plus pair c
    round,        // pair a as a real
  };
  Kind kind;
  int a = -1, b = -1, c = -1;
  std::string name = {};  // of a variable
  Rational number = {};   // an integer
  // Bound of the relative error in units of u, half of the last place of a number in [1, 2); to first order in u.
  unsigned error = 0;
  unsigned uses = 0;

  bool is_pair() const { return kind == Kind::pair_number || kind == Kind::pair_times || kind == Kind::pair_step; }
};

// What the values of a variable are known to be.
enum class Range { any, nonnegative };

class Program {
 public:
  // bits: of the significand of the target's real type. Variables that are not named are Range::any.
  Program(std::map<std::string, Range> ranges, unsigned bits) : ranges_(std::move(ranges)), bits_(bits) {}

  // Values in the order given; each may be used by any later one.
  std::vector<int> add(const std::vector<RationalFunction>& functions);

  const std::vector<Operation>& operations() const { return operations_; }
  const Operation& operator[](int value) const { return operations_[static_cast<size_t>(value)]; }
  unsigned bits() const { return bits_; }
  // True if some value is a pair.
  bool has_pairs() const;
  // True if the variable is used.
  bool uses(const std::string& variable) const;
  // Number of operations of a kind.
  unsigned count(Operation::Kind kind) const;

 private:
  struct Term {
    std::vector<unsigned> exponents;
    Rational coefficient;
  };
  using Terms = std::vector<Term>;
  // A product as a sorted list of values with repetitions.
  using Product = std::vector<int>;

  int insert(Operation operation);
  int variable(const std::string& name);
  int number(const Rational& integer);
  int pair_number(const Rational& integer);
  int binary(Operation::Kind kind, int a, int b);
  int negate(int a);
  int power(int base, unsigned exponent);
  int polynomial(const Polynomial& p);
  int same_sign(const Terms& terms, const std::vector<std::string>& names);
  int in_pairs(const Terms& terms, const std::vector<std::string>& names);
  bool one_sign(const Terms& terms, const std::vector<std::string>& names) const;
  bool exact_term(const Term& term) const;
  bool exact_integer(const Rational& integer) const;
  int exact_value(const Term& term, const std::vector<std::string>& names);
  int product(const Product& factors);
  void share(std::vector<Product*>& products);

  std::map<std::string, Range> ranges_;
  unsigned bits_;
  std::vector<Operation> operations_;
  std::map<std::tuple<int, int, int, int, std::string>, int> known_;
};

// True for an integer +-2^k.
bool is_power_of_two(const Rational& integer);

}  // namespace twoscale::lowering::emit
