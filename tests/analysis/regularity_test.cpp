// SPDX-License-Identifier: GPL-3.0-or-later
// Hölder and Sobolev exponents: known ones, how they change with the mask, one route against the other, level-dependent
// schemes, and the checker's opinion of every certificate on the way.
#include "twoscale/analysis/regularity.hpp"

#include <cmath>

#include "masks.hpp"
#include "support/laws.hpp"
#include "twoscale/check/check.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::analysis {
namespace {

using masks::convolved;
using masks::dilated;
using masks::mean;
using masks::power;
using masks::Rationals;
using masks::scheme;
using masks::times;

bool accepted(const Regularity& r) {
  return r.certificate.empty() || check::check_text(r.certificate).status == check::Report::valid;
}

Regularity found(const Scheme& s, const RegularityOptions& options = {}) {
  Regularity r = regularity(s, options);
  EXPECT_TRUE(accepted(r)) << check::check_text(r.certificate).message;
  return r;
}
Regularity found(const std::string& name) { return found(make_scheme(name)); }

double number(const std::optional<Rational>& r) { return r ? fmpq_get_d(r->raw()) : std::nan(""); }

// 4-point with tension.
Rationals four_points(const Rational& w) {
  const Rational side = Rational(1, 2) + w;
  return {-w, 0, side, 1, side, 0, -w};
}
// Jeong et al. 2013, the cubic quasi-spline.
Rationals quasi_spline(const Rational& w) {
  return times(Rational(1, 8),
               {w, Rational(1) + 2 * w, Rational(4) - w, Rational(6) - 4 * w, Rational(4) - w, Rational(1) + 2 * w, w});
}

// ---- known exponents

TEST(Regularity, Splines) {
  for (int m = 2; m <= 5; ++m)
    for (int n = 0; n <= 6; ++n) {
      const Regularity r = found("bspline:n=" + std::to_string(n) + ",arity=" + std::to_string(m));
      SCOPED_TRACE(std::to_string(m) + " " + std::to_string(n));
      EXPECT_EQ(r.order, n + 1);
      EXPECT_EQ(r.hoelder.rational, Rational(n));
      EXPECT_EQ(r.hoelder.expression, std::to_string(n));
      EXPECT_EQ(r.sobolev.rational, Rational(n) + Rational(1, 2));
      EXPECT_EQ(r.continuity, n - 1);
      EXPECT_TRUE(r.stability.stable);
      EXPECT_EQ(r.jsr.exact->rational(), Rational(m));
      if (n > 0) {
        EXPECT_EQ(r.attained, true);
      }
    }
}

TEST(Regularity, DeslauriersDubuc) {
  // 8 points on: Rioul 1992, Daubechies 1992.
  const std::vector<double> known{1, 2, 2.830074998557688, 3.551130531564, 4.193573434501, 4.776748176860};
  for (size_t l = 1; l <= known.size(); ++l) {
    const Regularity r = found("dd:l=" + std::to_string(l));
    EXPECT_EQ(r.order, static_cast<long>(2 * l));
    EXPECT_EQ(r.method, "nonnegative symbol");
    EXPECT_NEAR(number(r.hoelder.lower), known[l - 1], 2e-12);
    EXPECT_NEAR(number(r.hoelder.upper), known[l - 1], 2e-12);
    EXPECT_EQ(r.continuity, static_cast<long>(std::ceil(known[l - 1])) - 1);
  }
  EXPECT_EQ(found("dd:l=3").hoelder.expression, "6 - log(9)/log(2)");
  EXPECT_EQ(found("dd:l=1").attained, true);
  EXPECT_EQ(found("dd:l=2").attained, false);  // f' has the modulus t log(1/t)
  EXPECT_EQ(found("dd:l=3").attained, true);
}

TEST(Regularity, TernaryInterpolation) {
  // Hassan, Ivrissimtzis, Dodgson, Sabin 2002: C^2 for 1/15 < mu < 1/9.
  const auto four = [](const Rational& mu) {
    const Rational a0 = Rational(-1, 18) - mu * Rational(1, 6), a1 = Rational(13, 18) + mu * Rational(1, 2);
    const Rational a2 = Rational(7, 18) - mu * Rational(1, 2), a3 = Rational(-1, 18) + mu * Rational(1, 6);
    return Rationals{a3, a0, 0, a2, a1, 1, a1, a2, 0, a0, a3};
  };
  EXPECT_EQ(found(scheme(four(Rational(1, 11)), 3)).continuity, 2);
  EXPECT_EQ(found(scheme(four(Rational(2, 27)), 3)).continuity, 2);
  EXPECT_EQ(found(scheme(four(Rational(1, 10)), 3)).continuity, 2);
  EXPECT_EQ(found(scheme(four(Rational(1, 15)), 3)).continuity, 1);
  EXPECT_EQ(found(scheme(four(Rational(1, 9)), 3)).continuity, 1);
  EXPECT_EQ(found(scheme(four(Rational(1, 15)), 3)).hoelder.rational, Rational(2));
}

TEST(Regularity, QuasiSplines) {
  EXPECT_EQ(found(scheme(quasi_spline(Rational(1, 4)), 2)).hoelder.rational,
            Rational(5));  // w = 1/4: the quintic spline
  EXPECT_EQ(found(scheme(quasi_spline(0), 2)).hoelder.rational, Rational(3));
  EXPECT_EQ(found(scheme(quasi_spline(Rational(1, 8)), 2)).hoelder.expression, "4 - log(3/2)/log(2)");
  EXPECT_EQ(found(scheme(quasi_spline(2), 2)).hoelder.expression, "4 - log(6)/log(2)");
}

TEST(Regularity, WithoutConvergence) {
  const Regularity sum = found(scheme({1, 1, 1}, 2));
  EXPECT_NE(sum.obstacle.find('3'), std::string::npos);
  EXPECT_EQ(sum.continuity, -1);
  EXPECT_TRUE(sum.certificate.empty());
  const Regularity constants = found(scheme({Rational(1, 4), Rational(3, 2), Rational(1, 4)}, 2));
  EXPECT_EQ(constants.order, 0);
  EXPECT_FALSE(constants.obstacle.empty());
  // Sum rules, and yet too rough: w = 1 of the 4-point scheme.
  const Regularity rough = found(scheme(four_points(1), 2));
  EXPECT_EQ(rough.continuity, -1);
  EXPECT_LT(number(rough.hoelder.upper), 0);
  EXPECT_FALSE(rough.attained);
}

TEST(Regularity, AFreeConstantIsNamed) {
  try {
    regularity(make_scheme("mask:coefficients=\"-w,0,1/2+w,1,1/2+w,0,-w\",lowest=-3"), {});
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind, Error::Kind::bad_input);
    EXPECT_NE(std::string(e.what()).find('w'), std::string::npos);
  }
}

TEST(Regularity, NoUpperBoundWithoutStability) {
  // Boxes of length 3 and 2, and their powers.
  for (const Rationals& a : {Rationals{1, 0, 0, 1}, times(Rational(1, 2), {1, 1, 1, 1}),
                             times(Rational(1, 2), convolved({1, 0, 0, 1}, {1, 0, 0, 1}))}) {
    const Regularity r = found(scheme(a, 2));
    EXPECT_FALSE(r.stability.stable);
    EXPECT_FALSE(r.hoelder.upper);
    EXPECT_FALSE(r.hoelder.rational);
    EXPECT_FALSE(r.hoelder.expression);
    EXPECT_FALSE(r.sobolev.upper);
    EXPECT_FALSE(r.attained);
    EXPECT_TRUE(r.hoelder.lower);
  }
}

// ---- two routes

TEST(Regularity, PolytopesAgreeWithNonNegativeSymbols) {
  std::vector<std::pair<Rationals, long>> list;
  for (int l = 1; l <= 5; ++l) {
    Rationals a;
    const Laurent symbol = *limit_symbol(make_scheme("dd:l=" + std::to_string(l)));
    for (const auto& c : symbol.coefficients()) a.push_back(*c.constant());
    list.emplace_back(a, 2);
  }
  for (long m = 2; m <= 4; ++m)
    for (long n = 1; n <= 4; ++n) list.emplace_back(times(Rational(m), power(mean(m), n)), m);
  for (const Rational& w : {Rational(-1, 2), Rational(-1, 7), Rational(0), Rational(1, 40), Rational(1, 17)})
    list.emplace_back(four_points(w), 2);
  for (const Rational& w : {Rational(-1, 2), Rational(-1, 4), Rational(1, 8), Rational(1, 5)})
    list.emplace_back(quasi_spline(w), 2);
  for (long k = 2; k <= 8; ++k)  // Hormann, Sabin 2008
    list.emplace_back(times(2, convolved(power(mean(2), k), {Rational(-k, 8), Rational(4 + k, 4), Rational(-k, 8)})),
                      2);
  RegularityOptions polytope;
  polytope.polytope_only = true;
  polytope.jsr.seconds = 5;
  for (const auto& [a, m] : list) {
    std::string text;
    for (const auto& x : a) text += x.to_string() + " ";
    SCOPED_TRACE(text);
    const Regularity x = found(scheme(a, m)), y = found(scheme(a, m), polytope);
    EXPECT_EQ(x.method, "nonnegative symbol");
    EXPECT_NE(y.method, "nonnegative symbol");
    ASSERT_TRUE(x.jsr.exact);
    if (y.jsr.exact) {
      EXPECT_EQ(*x.jsr.exact, *y.jsr.exact);
      EXPECT_EQ(x.hoelder.expression, y.hoelder.expression);
    } else {
      EXPECT_LE(RealAlgebraic::compare(y.jsr.lower, *x.jsr.exact), 0);
      EXPECT_LE(RealAlgebraic::compare(*x.jsr.exact, y.jsr.upper), 0);
    }
    EXPECT_EQ(x.continuity, y.continuity);
  }
}

// ---- laws

// A mask with `order` sum rules at least and a random rest of up to four coefficients.
struct Sample {
  long m;
  long order;
  Rationals rest;  // sums to m
  Rationals mask() const { return convolved(rest, power(mean(m), order)); }
};
Sample random_sample(long most_arity = 4) {
  Sample s{uniform(2L, most_arity + 1), uniform(1L, 4L), {}};
  Rationals c;
  Rational sum;
  do {
    c = several(uniform<size_t>(1, 5), [] { return Rational(uniform(-5L, 9L)); });
    sum = 0;
    for (const auto& x : c) sum += x;
  } while (sum.sign() <= 0 || c.front().is_zero() || c.back().is_zero());
  if (uniform(0, 2) == 0) {  // non-negative
    c = convolved(c, Rationals(c.rbegin(), c.rend()));
    sum *= sum;
  }
  s.rest = times(Rational(s.m) / sum, c);
  return s;
}

std::optional<Regularity> quick(const Rationals& a, long m) {
  RegularityOptions options;
  options.jsr.width = Rational(1, 50);
  options.jsr.vertices = 150;
  options.jsr.seconds = 1.5;
  try {
    Regularity r = regularity(scheme(a, m), options);
    LAW_ASSERT(accepted(r));
    return r;
  } catch (const Error& e) {
    if (e.kind != Error::Kind::undecided) throw;
    return std::nullopt;
  }
}

// The exponents differ by `shift`, as far as both are known; the radius is what is compared, so stability is not
// needed.
void expect_shifted(const Regularity& a, const Regularity& b, long shift, const Rational& factor = 1) {
  LAW_ASSERT(a.obstacle.empty() == b.obstacle.empty());
  if (!a.obstacle.empty()) return;
  if (a.jsr.exact && b.jsr.exact) {
    LAW_ASSERT(a.hoelder.lower.has_value() == b.hoelder.lower.has_value());
    if (a.hoelder.lower)
      LAW_ASSERT(abs(*a.hoelder.lower + Rational(shift) - *b.hoelder.lower * factor) <= Rational(1, 1000000000));
  } else {
    if (a.hoelder.lower && b.hoelder.upper) LAW_ASSERT(*a.hoelder.lower + Rational(shift) <= *b.hoelder.upper * factor);
    if (b.hoelder.lower && a.hoelder.upper) LAW_ASSERT(*b.hoelder.lower * factor <= *a.hoelder.upper + Rational(shift));
  }
}

LAW(RegularityLaws, AnotherMeanAddsOne, ()) {
  const Sample s = random_sample();
  const auto x = quick(s.mask(), s.m), y = quick(convolved(s.mask(), mean(s.m)), s.m);
  LAW_GIVEN(x && y);
  laws::tag(x->jsr.exact.has_value() ? "exact" : "enclosed");
  LAW_ASSERT(y->order == x->order + 1);
  LAW_ASSERT(x->c == y->c);
  expect_shifted(*x, *y, 1);
  if (x->stability.stable && x->jsr.exact && x->hoelder.expression && y->stability.stable)
    LAW_ASSERT(x->jsr.exact == y->jsr.exact);
}

LAW(RegularityLaws, Reflection, ()) {
  const Sample s = random_sample();
  const Rationals a = s.mask();
  const auto x = quick(a, s.m), y = quick(Rationals(a.rbegin(), a.rend()), s.m);
  LAW_GIVEN(x && y);
  expect_shifted(*x, *y, 0);
  LAW_ASSERT(x->stability.stable == y->stability.stable);
  LAW_ASSERT(x->sobolev.lower == y->sobolev.lower);
}

LAW(RegularityLaws, TwoStepsAtOnce, ()) {
  const Sample s = random_sample(3);
  const Rationals a = s.mask();
  const auto x = quick(a, s.m), y = quick(convolved(a, dilated(a, s.m)), s.m * s.m);
  LAW_GIVEN(x && y);
  LAW_ASSERT(y->order >= x->order);
  if (x->stability.stable) {
    LAW_ASSERT(y->order == x->order);
    LAW_ASSERT(y->stability.stable);
    expect_shifted(*x, *y, 0);
    if (x->hoelder.rational && y->jsr.exact) LAW_ASSERT(x->hoelder.rational == y->hoelder.rational);
  }
}

LAW(RegularityLaws, SobolevAndHoelder, ()) {
  const Sample s = random_sample();
  const auto x = quick(s.mask(), s.m);
  LAW_GIVEN(x.has_value());
  LAW_GIVEN(x->obstacle.empty());
  LAW_ASSERT(x->sobolev.lower.has_value());
  // The square of the radius is at most that of the autocorrelation, and that at most m times the square.
  if (x->stability.stable) {
    LAW_ASSERT(x->sobolev.upper.has_value());
    if (x->hoelder.lower) LAW_ASSERT(*x->hoelder.lower <= *x->sobolev.upper);
    if (x->hoelder.upper) LAW_ASSERT(*x->sobolev.lower <= *x->hoelder.upper + Rational(1, 2));
    // A stable exponent of N or more would make the basic function a polynomial.
    if (x->hoelder.lower) LAW_ASSERT(*x->hoelder.lower <= Rational(x->order));
  } else {
    LAW_ASSERT(!x->hoelder.upper && !x->sobolev.upper);
  }
  if (x->hoelder.lower && x->hoelder.lower->sign() > 0)
    LAW_ASSERT(Rational(x->continuity) <= *x->hoelder.lower && *x->hoelder.lower <= Rational(x->continuity + 1));
}

// ---- level-dependent schemes

TEST(Regularity, FamiliesInheritTheExponentOfTheirLimit) {
  for (const char* family : {"mixed", "harmonic", "resonant"})
    for (int l = 2; l <= 8; ++l) {
      const Regularity limit = regularity(make_scheme("dd:l=" + std::to_string(l)), {});
      const Regularity r = found("interpolating:family=" + std::string(family) + ",l=" + std::to_string(l));
      SCOPED_TRACE(family + std::to_string(l));
      EXPECT_TRUE(r.level_dependent);
      EXPECT_TRUE(r.transferred);
      EXPECT_EQ(r.order, 2 * l);
      EXPECT_EQ(r.hoelder.expression, limit.hoelder.expression);
      EXPECT_EQ(r.hoelder.lower, limit.hoelder.lower);
      EXPECT_EQ(r.continuity, limit.continuity);
      EXPECT_FALSE(r.attained);
      EXPECT_NE(r.certificate.find("\"nonstationary\""), std::string::npos);
    }
}

TEST(Regularity, ExponentialSplines) {
  for (const char* space : {"exp(t*x),exp(-t*x)", "1,x,exp(t*x),exp(-t*x)", "exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)"}) {
    const Regularity r = found("exponential-bspline:space=\"" + std::string(space) + "\"");
    EXPECT_TRUE(r.transferred) << space;
    EXPECT_EQ(r.hoelder.rational, Rational(r.order - 1));
    EXPECT_EQ(r.continuity, r.order - 2);
  }
}

}  // namespace
}  // namespace twoscale::analysis
