// SPDX-License-Identifier: GPL-3.0-or-later
// Spaces of exponential polynomials, closed under x -> -x and under translation:
//   span { x^r : r < polynomial_order } + span { x^r exp(+-theta x) : r < order, theta in the frequencies }.
//
// Frequencies are grouped by what they are rational multiples of; each group has one level variable
//   v = v^{[k+1]} = cosh(theta/m^{k+1})  (cos(s/m^{k+1}) when given as cosines),
// theta the greatest common frequency of the group, so that the others are cosh(n theta/m^{k+1}) = T_n(v).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "twoscale/symbolic/exact_real.hpp"
#include "twoscale/symbolic/polynomial.hpp"

namespace twoscale {

// The greatest common frequency of a group: factor * symbol (symbol empty: the number itself).
struct LevelVariable {
  std::string name;            // "v", or "v_s", "v_t", ... when there are several
  std::string symbol;          // "t"; empty for a numeric frequency
  Rational factor = 1;         // the frequency is factor * symbol, or factor * unit for a numeric one
  std::string unit;            // numeric: "1", "pi", "sqrt(2)", ...; empty otherwise
  bool trigonometric = false;  // the frequency multiplies I: v = cos(...)

  std::string frequency() const;           // "t", "2*t", "t/6", "pi/3"
  std::string meaning(int arity) const;    // "cosh(t/2^(k+1))"
  std::optional<ExactReal> value() const;  // of the frequency, if numeric
  bool same_group(const LevelVariable& o) const {
    return symbol == o.symbol && unit == o.unit && trigonometric == o.trigonometric;
  }
};

class Space {
 public:
  // x^r exp(+-multiple * frequency(variable) x), r < order; multiple >= 1.
  struct Exponential {
    size_t variable;
    unsigned multiple;
    unsigned order;
    friend bool operator==(const Exponential&, const Exponential&) = default;
  };

  Space() = default;
  // A comma list "1, x, exp(t*x), exp(-t*x)", order free. Throws Error(bad_input) naming an item that cannot be read,
  // one that stands twice, or what is missing for closedness (a partner of +-theta, a lower power of x).
  static Space parse(std::string_view text);
  // {1, ..., x^{polynomial_order-1}} and exponentials of one symbolic frequency t: multiple -> order.
  static Space one_frequency(unsigned polynomial_order, const std::vector<std::pair<unsigned, unsigned>>& multiples);

  unsigned polynomial_order() const { return polynomial_order_; }
  const std::vector<LevelVariable>& variables() const { return variables_; }
  const std::vector<Exponential>& exponentials() const { return exponentials_; }
  unsigned dimension() const;
  // The items in canonical order: powers of x, then by frequency; cos/sin for trigonometric groups.
  std::vector<std::string> items() const;
  std::string to_string() const;  // items joined by ", "
  std::string to_latex() const;

  // The same space with its groups expressed in the level variables of `reference` (plus what it has of its own): both
  // then share names and base frequencies. `scale[i]`: variable i of `reference` is cosh of scale[i] times the new
  // base.
  struct Rebased;
  static Rebased rebase(const Space& space, const std::vector<LevelVariable>& reference);

 private:
  void name_variables();

  unsigned polynomial_order_ = 0;
  std::vector<LevelVariable> variables_;
  std::vector<Exponential> exponentials_;  // sorted by variable, multiple
};

struct Space::Rebased {
  Space space;
  std::vector<unsigned> scale;
};

// One entry w = cosh(theta/m^{k+1}) for each pair +-theta counted with multiplicity, and one for each pair of zeros
// (w = 1); equal ones adjacent, ones first. Length floor(dimension/2): an odd order leaves one zero over.
std::vector<Polynomial> cosh_nodes(const Space& space);

// The same as (variable, multiple): multiple 0 stands for w = 1.
struct Node {
  size_t variable;
  unsigned multiple;
  friend bool operator==(const Node&, const Node&) = default;
};
std::vector<Node> nodes(const Space& space);

}  // namespace twoscale
