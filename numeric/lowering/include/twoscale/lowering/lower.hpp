// SPDX-License-Identifier: GPL-3.0-or-later
// Lowering: a scheme and exact values of its parameters become mask tables in which every printed digit is proved.
//
// Step k -> k+1 uses the level variables of level k+1, v = v^{[k+1]}. With u = v - 1 the recurrence v^k = T_m(v^{k+1})
// loses no relative accuracy (m = 2: u^k = 2 u^{k+1} (2 + u^{k+1})), so the last level is enclosed from the angle,
//   u^{[k]} = 2 sinh^2(t/(2 m^k)) or -2 sin^2(s/(2 m^k)),
// and the coarser ones follow by multiplications. Masks are evaluated as polynomials in u over one common denominator.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "twoscale/kernels/mask_table.hpp"
#include "twoscale/symbolic/exact_real.hpp"
#include "twoscale/symbolic/scheme.hpp"

namespace twoscale::lowering {

class InverseBranch;

// The values v^{[k]} of one level variable: v^{[0]} is given exactly, v^{[k]} = T_m(v^{[k+1]}), v^{[k]} > -1, or
// v^{[k]} = R(v^{[k+1]}) on the branch of level_relation.hpp.
class LevelValue {
 public:
  // Throw Error(bad_input) unless v0 > -1 (naming it), Error(undecided) if that could not be decided.
  static LevelValue from_v0(const ExactReal& v0, std::string text, int arity);
  static LevelValue hyperbolic(const ExactReal& t, std::string text, int arity);     // v^{[k]} = cosh(t/m^k)
  static LevelValue trigonometric(const ExactReal& s, std::string text, int arity);  // v^{[k]} = cos(s/m^k), |s| < pi
  // The domain is not checked. Throws Error(undecided) if v0 cannot be told from 1.
  static LevelValue related(const ExactReal& v0, std::string text, const RationalFunction& relation);

  // v^{[k]} exactly, for decisions (zero or not); an expression that grows with k only when it must. Of a value of
  // related(), k = 0 only.
  ExactReal exact(unsigned k) const;
  const std::string& text() const { return text_; }  // what the user wrote
  RationalFunction relation() const;                 // R in "x", T_m for a frequency
  bool is_one() const { return side_ == 0; }         // v^{[k]} = 1 at all levels

  // Encloses v^{[k]} - 1, with a relative error near 2^-bits.
  Ball offset(unsigned k, long bits) const;
  // The same for the fine levels of the steps 0..count-1: element k encloses v^{[k+1]} - 1. One multiplication a level.
  std::vector<Ball> offsets(unsigned count, long bits) const;

  // The minimal polynomial of v^{[0]} in "x", where it is known: v^0 rational, the cosine of a rational multiple of pi,
  // or of small degree. `transcendental`: v^{[k]} is known to be a zero of no polynomial.
  std::optional<Polynomial> minimal_polynomial() const;
  bool transcendental() const;

  // t > 0 with v^{[0]} = cosh t, or s in (0, pi) with v^{[0]} = cos s (trigonometric()); 0 if v^{[0]} = 1.
  Ball angle(long bits) const;
  bool trigonometric() const { return side_ < 0; }

 private:
  ExactReal v0_;
  std::optional<ExactReal> angle_;  // t or s
  bool circular_ = false;
  int side_ = 0;  // sign of v0 - 1
  int arity_ = 2;
  std::shared_ptr<const InverseBranch> branch_;  // of related(), unless v0 = 1
  std::string text_;
};

// Values for all parameters of a scheme.
struct Binding {
  std::map<std::string, LevelValue> levels;                      // by variable name: "v", "v_s"
  std::map<std::string, ExactReal> constants;                    // by parameter name
  std::vector<std::pair<std::string, std::string>> description;  // as given: {"v0", "-2/5"}
};

// What --v0, --t and --at say (contract §3): v0 and t belong to the single frequency (t: v0 = cosh t, cos t for a
// frequency given by cosines; an imaginary t = I*s is trigonometric). `at`: NAME=VALUE with NAME a frequency symbol (s,
// t), v0_s, v0, or a constant parameter. Numeric frequencies bind themselves. Throws Error(bad_input) naming an unknown
// name, a value that cannot be used, a parameter that is bound twice or not at all.
Binding bind(const Scheme& scheme, const std::optional<std::string>& v0, const std::optional<std::string>& t,
             const std::vector<std::pair<std::string, std::string>>& at);
// The same where parameters may stay without a value; defaults are not used.
Binding bind_some(const Scheme& scheme, const std::optional<std::string>& v0, const std::optional<std::string>& t,
                  const std::vector<std::pair<std::string, std::string>>& at);

struct LowerOptions {
  unsigned levels = 10;    // rows k = 0..levels-1, and the limit row
  long digits = 17;        // significant digits, 17..10000; 0: correctly rounded doubles with shortest round-trip text
  bool extension = false;  // also the extension weights of the scheme's own space at every level (open curves)
  // Without it tail_bound stays empty, and singular steps after the last row are not looked for.
  bool tail = true;
};

// Throws Error(bad_input) naming v^0 and k if a step is singular: a denominator of the mask vanishes there (decided
// exactly), or the limit mask has a pole; Error(undecided) if a digit or a zero could not be decided.
// Cost: a few microseconds a level at 50 digits (l = 3), most of it the printing.
kernels::MaskTable lower(const Scheme& scheme, const Binding& binding, const LowerOptions& options);

// The same for another Laurent polynomial (not 0) in the parameters of the scheme: a filter, a lifting step.
kernels::MaskTable lower(const Scheme& scheme, const Laurent& values, const Binding& binding,
                         const LowerOptions& options);

}  // namespace twoscale::lowering
