// SPDX-License-Identifier: GPL-3.0-or-later
// The branch G of the inverse of R with G(1) = 1, R(1) = 1, R'(1) > 1 (symbolic/level_relation.hpp), in balls.
//
// With y = |v - 1| on the side of the start value, R becomes Q(y) = sum_{j >= 1} c_j y^j, increasing on an interval
// [0, reach] with Q(reach) > |v^0 - 1|, where Sturm's theorem finds no critical point. G is then the only zero of Q(y)
// - t in [0, reach]: Newton's method in intervals, with bisection while the derivative may vanish. Since Q(0) = 0
// exactly, small values keep their relative accuracy.
#pragma once

#include <vector>

#include "twoscale/symbolic/ball.hpp"
#include "twoscale/symbolic/exact_real.hpp"
#include "twoscale/symbolic/rational_function.hpp"

namespace twoscale::lowering {

class InverseBranch {
 public:
  // side: the sign of v0 - 1. Throws Error(undecided) if no interval is found.
  InverseBranch(const RationalFunction& relation, int side, const ExactReal& v0);

  const RationalFunction& relation() const { return relation_; }
  // v^{[k]} - 1 for k = 0..count.
  std::vector<Ball> offsets(const ExactReal& v0, unsigned count, long bits) const;

 private:
  Ball inverse(const Ball& t, long bits) const;

  RationalFunction relation_;
  int side_;
  std::vector<Rational> c_;  // of Q
  Rational reach_;
};

}  // namespace twoscale::lowering
