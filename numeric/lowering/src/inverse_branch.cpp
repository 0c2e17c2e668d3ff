// SPDX-License-Identifier: GPL-3.0-or-later
#include "inverse_branch.hpp"

#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/level_relation.hpp"

namespace twoscale::lowering {

namespace {

constexpr int most_halvings = 400;
constexpr int most_steps = 4000;

// sum_j c_j y^j and its derivative.
void evaluate(const std::vector<Rational>& c, const arb_t y, long bits, arb_t value, arb_t slope) {
  arb_zero(value);
  arb_zero(slope);
  Ball term;
  for (size_t j = c.size(); j-- > 0;) {
    arb_mul(slope, slope, y, bits);
    arb_add(slope, slope, value, bits);
    arb_mul(value, value, y, bits);
    arb_set_fmpq(term.raw(), c[j].raw(), bits);
    arb_add(value, value, term.raw(), bits);
  }
}

}  // namespace

InverseBranch::InverseBranch(const RationalFunction& relation, int side, const ExactReal& v0)
    : relation_(relation), side_(side) {
  if (side == 0) return;
  const RationalFunction y = RationalFunction::variable("x");
  const RationalFunction sign(side);
  const RationalFunction q = sign * (relation.substitute("x", RationalFunction(1) + sign * y) - RationalFunction(1));
  c_.resize(static_cast<size_t>(q.numerator().degree("x")) + 1);
  q.numerator().for_each_term([&](const Rational& a, std::span<const unsigned long> e) {
    c_[e.empty() ? 0 : e[0]] = a / q.denominator_content();
  });
  const Polynomial critical = q.numerator().derivative("x");
  const auto beyond = [&](const Rational& at) {
    return zeros_between(critical, Rational(0), at) > 0 || RationalFunction(critical).evaluate({{"x", at}})->is_zero();
  };
  const ExactReal start = ExactReal(side) * (v0 - ExactReal(1));
  const auto enough = [&](const Rational& at) {
    return (ExactReal(*q.evaluate({{"x", at}})) - start).sign() == Sign::positive;
  };
  Rational low;
  Rational high = 1;
  for (int i = 0; i < most_halvings && !beyond(high); ++i) {
    if (enough(high)) {
      reach_ = high;
      return;
    }
    low = high;
    high = Rational(2) * high;
  }
  for (int i = 0; i < most_halvings; ++i) {
    const Rational middle = (low + high) / Rational(2);
    if (beyond(middle)) {
      high = middle;
    } else if (enough(middle)) {
      reach_ = middle;
      return;
    } else {
      low = middle;
    }
  }
  throw Error(Error::Kind::undecided, "cannot tell the start value from the end of the relation's branch",
              v0.decimal(17));
}

Ball InverseBranch::inverse(const Ball& t, long bits) const {
  // x runs through intervals that contain the zero, from [0, min(t, reach)]: G moves towards the fixed point.
  Ball x, middle, value, slope, step, half;
  arf_t top, bottom, least;
  arf_init(top);
  arf_init(bottom);
  arf_init(least);
  arb_get_ubound_arf(top, t.raw(), bits);
  const Ball reach(reach_, 2 * most_halvings);  // exact: it came from 1 by doubling and halving
  arf_set(bottom, arb_midref(reach.raw()));
  if (arf_cmp(bottom, top) < 0) arf_swap(bottom, top);
  arf_zero(bottom);
  for (int i = 0; i < most_steps; ++i) {
    arb_set_interval_arf(x.raw(), bottom, top, bits);
    evaluate(c_, x.raw(), bits, value.raw(), slope.raw());
    arf_add(arb_midref(middle.raw()), bottom, top, ARF_PREC_EXACT, ARF_RND_DOWN);
    arf_mul_2exp_si(arb_midref(middle.raw()), arb_midref(middle.raw()), -1);
    arf_set_round(arb_midref(middle.raw()), arb_midref(middle.raw()), bits, ARF_RND_DOWN);
    const bool newton = arb_is_positive(slope.raw()) != 0;
    evaluate(c_, middle.raw(), bits, value.raw(), half.raw());
    arb_sub(value.raw(), value.raw(), t.raw(), bits);
    arf_sub(least, top, bottom, 30, ARF_RND_UP);
    if (newton) {
      arb_div(step.raw(), value.raw(), slope.raw(), bits);
      arb_sub(step.raw(), middle.raw(), step.raw(), bits);
      Ball cut;
      if (arb_intersection(cut.raw(), step.raw(), x.raw(), bits) == 0)
        throw std::logic_error("InverseBranch: the zero was lost");
      arb_swap(x.raw(), cut.raw());
      arf_t l, u;
      arf_init(l);
      arf_init(u);
      arb_get_lbound_arf(l, x.raw(), bits);
      arb_get_ubound_arf(u, x.raw(), bits);
      if (arf_cmp(l, bottom) > 0) arf_swap(l, bottom);
      if (arf_cmp(u, top) < 0) arf_swap(u, top);
      arf_sub(l, top, bottom, 30, ARF_RND_UP);
      arf_mul_2exp_si(u, least, -1);
      const bool shrinking = arf_cmp(l, u) < 0;
      arf_clear(l);
      arf_clear(u);
      if (shrinking) continue;
      // Newton's method gains no more: as small as the ball of t and the precision allow.
      if (arf_sgn(bottom) > 0) break;
    }
    if (arb_is_positive(value.raw()) != 0)
      arf_set(top, arb_midref(middle.raw()));
    else if (arb_is_negative(value.raw()) != 0)
      arf_set(bottom, arb_midref(middle.raw()));
    else
      break;
  }
  arb_set_interval_arf(x.raw(), bottom, top, bits);
  arf_clear(top);
  arf_clear(bottom);
  arf_clear(least);
  return x;
}

std::vector<Ball> InverseBranch::offsets(const ExactReal& v0, unsigned count, long bits) const {
  std::vector<Ball> list;
  if (side_ == 0) {
    list.resize(count + 1);
    return list;
  }
  Ball y;
  if (const auto q = v0.rational()) {
    y = Ball(*q - Rational(1), bits);
  } else {
    for (long more = bits; more < 64 * bits && (y.contains_zero() || !y.is_finite()); more *= 2) {
      y = v0.enclose(more);
      arb_sub_ui(y.raw(), y.raw(), 1, more);
    }
  }
  if (side_ < 0) arb_neg(y.raw(), y.raw());
  for (unsigned k = 0;; ++k) {
    list.push_back(y);
    if (side_ < 0) arb_neg(list.back().raw(), list.back().raw());
    if (k == count) return list;
    y = inverse(y, bits);
  }
}

}  // namespace twoscale::lowering
