// SPDX-License-Identifier: GPL-3.0-or-later
// Smoothness along a parameter: the 4-point scheme with tension, the cubic quasi-splines, and each statement against
// the exponents at single parameters.
#include "twoscale/analysis/parameter_range.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::analysis {
namespace {

const char* const four_points = "mask:coefficients=\"-w,0,1/2+w,1,1/2+w,0,-w\",lowest=-3";
const char* const quasi_splines =
    "mask:coefficients=\"w/8,(1+2*w)/8,(4-w)/8,(3-2*w)/4,(4-w)/8,(1+2*w)/8,w/8\",lowest=-3";

ParameterOptions quick(int samples = 5) {
  ParameterOptions options;
  options.samples = samples;
  options.resolution = Rational(1, 256);
  return options;
}

bool contains(const ParameterInterval& i, const Rational& w) {
  const int low = RealAlgebraic::compare(i.from, w), high = RealAlgebraic::compare(w, i.to);
  return (low < 0 || (low == 0 && i.from_included)) && (high < 0 || (high == 0 && i.to_included));
}
bool contains(const std::vector<ParameterInterval>& list, const Rational& w) {
  return std::any_of(list.begin(), list.end(), [&](const ParameterInterval& i) { return contains(i, w); });
}

const ContinuityRange& of(const ParameterRange& r, long l) {
  for (const auto& c : r.continuity)
    if (c.l == l) return c;
  throw std::logic_error("no range for C^" + std::to_string(l));
}

Regularity at(const std::string& name, const Rational& w) {
  return regularity(with_values(make_scheme(name), {{"w", w}}), {});
}

// Every statement of the ranges holds at each of the parameters.
void expect_consistent(const std::string& name, const ParameterRange& range, const std::vector<Rational>& parameters) {
  for (const auto& w : parameters) {
    SCOPED_TRACE("w = " + w.to_string());
    const Regularity r = at(name, w);
    for (const auto& c : range.continuity) {
      const bool proved = contains(c.proved, w), refuted = contains(c.refuted, w);
      EXPECT_FALSE(proved && refuted) << c.l;
      if (proved && r.jsr.exact) {
        EXPECT_GE(r.continuity, c.l);
      }
      if (c.joint && contains(*c.joint, w) && r.jsr.exact) {
        EXPECT_GE(r.continuity, c.l);
      }
      if (refuted && r.jsr.exact) {
        // The order of the mask may be higher at single parameters: compare exponents.
        EXPECT_TRUE(r.hoelder.lower);
        EXPECT_LE(*r.hoelder.lower, Rational(c.l)) << c.l;
      }
    }
    if (!r.jsr.exact || r.order != range.order) continue;
    for (const auto& x : range.radius) {
      if (!contains(x.interval, w)) continue;
      const Polynomial p =
          parse_rational_function(x.polynomial.to_string()).substitute("w", RationalFunction(w)).numerator();
      ASSERT_FALSE(p.is_zero());
      EXPECT_TRUE(Polynomial::quotient(p.scaled(p.content().inverse()), r.jsr.exact->polynomial()))
          << p.to_string() << " and " << r.jsr.exact->polynomial().to_string();
    }
  }
}

std::vector<Rational> equidistant(const Rational& from, const Rational& to, long n) {
  std::vector<Rational> list;
  for (long i = 0; i <= n; ++i) list.push_back(from + (to - from) * Rational(i, n));
  return list;
}

TEST(ParameterRange, FourPoints) {
  const Rational half(1, 2);
  const ParameterRange r = parameter_range(make_scheme(four_points), "w", -half, half, quick(9));
  EXPECT_EQ(r.name, "w");
  EXPECT_EQ(r.order, 2);
  EXPECT_EQ(r.samples.size(), 9U);
  EXPECT_EQ(r.samples.front().first, -half);
  EXPECT_EQ(r.samples.back().first, half);
  // C^1: on (0, 6/32] at least; from the zero of 32 w^3 + 4 w - 1 on not (Hechler, Moessner, Reif 2009).
  const ContinuityRange& smooth = of(r, 1);
  for (const Rational& w : {Rational(1, 1000000), Rational(1, 1000), Rational(1, 16), Rational(1, 8), Rational(6, 32)})
    EXPECT_TRUE(contains(smooth.proved, w)) << w.to_string();
  const RealAlgebraic end = RealAlgebraic::zeros(parse_rational_function("32*x^3+4*x-1").numerator()).at(0);
  for (const Rational& w : {Rational(-1, 2), Rational(-1, 10), Rational(0), Rational(193, 1000), Rational(1, 5),
                            Rational(1, 4), Rational(1, 2)})
    EXPECT_TRUE(contains(smooth.refuted, w)) << w.to_string();
  for (const auto& i : smooth.proved) EXPECT_LT(RealAlgebraic::compare(i.to, end), 0);
  bool starts = false;
  for (const auto& i : smooth.refuted) {
    EXPECT_TRUE(RealAlgebraic::compare(i.from, end) >= 0 || RealAlgebraic::compare(i.to, Rational(0)) <= 0);
    starts = starts || (i.from == end && i.from_included);
  }
  EXPECT_TRUE(starts);
  // C^0: |w| < 1/2.
  for (const Rational& w : {Rational(-49, 100), Rational(-1, 4), Rational(0), Rational(1, 4), Rational(49, 100)})
    EXPECT_TRUE(contains(of(r, 0).proved, w)) << w.to_string();
  EXPECT_FALSE(contains(of(r, 0).proved, -half));
  EXPECT_FALSE(contains(of(r, 0).proved, half));
  // One polytope for any sequence of parameters.
  ASSERT_TRUE(smooth.joint);
  EXPECT_TRUE(contains(*smooth.joint, Rational(1, 16)));
  EXPECT_GT(RealAlgebraic::compare(smooth.joint->from, Rational(0)), 0);
  EXPECT_LT(RealAlgebraic::compare(smooth.joint->to, end), 0);
  // rho = 1 + sqrt(1 - 16 w) up to 1/16.
  ASSERT_FALSE(r.radius.empty());
  EXPECT_TRUE(contains(r.radius.front().interval, -half));
  EXPECT_TRUE(contains(r.radius.front().interval, Rational(1, 16)));
  EXPECT_EQ(parse_rational_function(r.radius.front().polynomial.to_string()), parse_rational_function("x^2-2*x+16*w"));
  expect_consistent(four_points, r, equidistant(-half, half, 40));
}

TEST(ParameterRange, QuasiSplines) {
  // Jeong, Lee, Yoon 2013, Theorem 3.1.
  const ParameterRange r = parameter_range(make_scheme(quasi_splines), "w", Rational(-1, 2), Rational(2), quick());
  EXPECT_EQ(r.order, 4);
  struct Range {
    Rational from, to;
    const char* polynomial;
  };
  for (const Range& known : {Range{Rational(-1, 2), Rational(1, 4), "x-2+4*w"},
                             Range{Rational(26, 100), Rational(1, 2), "x^2-2*w*x+8*w^2-4*w"},
                             Range{Rational(1, 2), Rational(1), "x-2*w"}, Range{Rational(1), Rational(2), "x-4*w+2"}}) {
    SCOPED_TRACE(known.polynomial);
    const RationalFunction expected = parse_rational_function(known.polynomial);
    for (const auto& w : equidistant(known.from, known.to, 10)) {
      bool seen = false;
      for (const auto& x : r.radius)
        if (contains(x.interval, w)) {
          const RationalFunction p = parse_rational_function(x.polynomial.to_string());
          seen = seen || p == expected || p == -expected;
        }
      EXPECT_TRUE(seen) << w.to_string();
    }
  }
  // Hence C^3 on (0, 1), C^2 on (-1/2, 3/2), C^1 on all of it.
  for (const auto& [l, from, to] :
       {std::tuple<long, Rational, Rational>{3, 0, 1}, {2, Rational(-1, 2), Rational(3, 2)}}) {
    const ContinuityRange& c = of(r, l);
    for (const auto& w : equidistant(from, to, 20)) {
      const bool end = w == from || w == to;
      EXPECT_EQ(contains(c.proved, w), !end) << l << " " << w.to_string();
      if (w > Rational(-1, 2)) {  // no interval is that one point
        EXPECT_EQ(contains(c.refuted, w), end) << l << " " << w.to_string();
      }
    }
    EXPECT_TRUE(contains(c.refuted, Rational(2))) << l;
  }
  EXPECT_TRUE(contains(of(r, 1).proved, Rational(2)));
  EXPECT_TRUE(contains(of(r, 1).proved, Rational(-1, 2)));
  expect_consistent(quasi_splines, r, equidistant(Rational(-1, 2), Rational(2), 40));
}

TEST(ParameterRange, ThreadsChangeNothing) {
  ParameterOptions options = quick(3);
  const ParameterRange one = parameter_range(make_scheme(quasi_splines), "w", Rational(0), Rational(1, 4), options);
  options.threads = 2;
  const ParameterRange two = parameter_range(make_scheme(quasi_splines), "w", Rational(0), Rational(1, 4), options);
  EXPECT_EQ(one.certificate, two.certificate);
}

TEST(ParameterRange, Refusals) {
  const Scheme s = make_scheme(four_points);
  const auto refuses = [](const Scheme& scheme, const std::string& name, const Rational& a, const Rational& b) {
    try {
      parameter_range(scheme, name, a, b, quick(2));
      return false;
    } catch (const Error& e) {
      return e.kind == Error::Kind::bad_input;
    }
  };
  EXPECT_TRUE(refuses(s, "u", 0, 1));
  EXPECT_TRUE(refuses(s, "w", 1, 0));
  EXPECT_TRUE(refuses(make_scheme("tension4"), "v", 0, 1));
  EXPECT_TRUE(refuses(make_scheme("dd:l=2"), "w", 0, 1));
  EXPECT_TRUE(refuses(make_scheme("mask:coefficients=\"-w,u,1/2+w,1-2*u,1/2+w,u,-w\""), "w", 0, 1));
}

}  // namespace
}  // namespace twoscale::analysis
