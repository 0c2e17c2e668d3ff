// SPDX-License-Identifier: GPL-3.0-or-later
/// Refinement on knots with digits: the doubles to rounding, more digits of the same numbers, exact where it can be.
#include "twoscale/lowering/refine_knots.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "twoscale/symbolic/error.hpp"

namespace twoscale::lowering {
namespace {

using kernels::Boundary;
using kernels::KnotOptions;
using kernels::KnotRule;
using kernels::Parametrization;

kernels::PointSet read(const std::string& text) { return kernels::parse_csv(text, "test"); }

const char* const uneven =
    "x,y,lambda,d,tag\n0,0,0.5,1,0\n4,1,1,0.5,1\n4.2,3,0,0,1\n4.2,3,0.5,2,0\n1,4,0.3,1.5,1\n0.3,4.1,0.5,0.25,0\n-1,2,0."
    "7,"
    "3,0\n-1.1,1.9,0.5,0.1,1\n-1,1.8,0.5,0.1,0\n-0.5,0.5,0.5,1,0\n";

/// The first digits of a decimal as a number.
double value(const std::string& token) { return std::stod(token); }

TEST(RefineKnots, AgreesWithDoubles) {
  const kernels::PointSet points = read(uneven);
  for (const KnotRule rule : {KnotRule::lagrange4, KnotRule::nuli4, KnotRule::nuli6})
    for (const Parametrization kind :
         {Parametrization::centripetal, Parametrization::chordal, Parametrization::uniform, Parametrization::given})
      for (const Boundary boundary : {Boundary::closed, Boundary::space, Boundary::linear, Boundary::given})
        for (const bool again : {false, true}) {
          if (again && kind == Parametrization::given) continue;
          const KnotOptions options{2, boundary, kind, again};
          const auto fine = refine_on_knots(points, rule, options, 25);
          const auto doubles = kernels::refine_on_knots(points, rule, options);
          ASSERT_EQ(fine.values.size(), doubles.values.size());
          ASSERT_EQ(fine.tokens.size(), fine.values.size());
          for (size_t i = 0; i < fine.values.size(); ++i) {
            EXPECT_NEAR(fine.values[i], doubles.values[i], 1e-12 * (1 + std::abs(doubles.values[i])));
            EXPECT_EQ(fine.values[i], value(fine.tokens[i]));
          }
        }
}

/// 40 digits, rounded to 20, are the 20 digits.
TEST(RefineKnots, MoreDigitsOfTheSameNumbers) {
  const kernels::PointSet points = read(uneven);
  for (const bool again : {false, true}) {
    const KnotOptions options{3, Boundary::closed, Parametrization::centripetal, again};
    const auto few = refine_on_knots(points, KnotRule::nuli6, options, 20);
    const auto many = refine_on_knots(points, KnotRule::nuli6, options, 40);
    size_t longer = 0;
    for (size_t i = 0; i < few.tokens.size(); ++i) {
      const std::string &a = few.tokens[i], &b = many.tokens[i];
      longer += b.size() > a.size() ? 1 : 0;
      // All digits but the last, which is rounded.
      EXPECT_EQ(a.substr(0, a.size() - 3), b.substr(0, a.size() - 3)) << a << " " << b;
    }
    EXPECT_GT(longer, few.tokens.size() / 2);
  }
}

/// Equal lengths: everything is rational, and digits that end in 5 are decided.
TEST(RefineKnots, EqualLengthsAreExact) {
  const kernels::PointSet square = read("x,y\n0,0\n0.1,0\n0.1,0.1\n0,0.1\n");
  for (const Parametrization kind : {Parametrization::centripetal, Parametrization::chordal}) {
    const auto fine = refine_on_knots(square, KnotRule::nuli4, {8, Boundary::closed, kind, false}, 17);
    const auto uniform =
        refine_on_knots(square, KnotRule::nuli4, {8, Boundary::closed, Parametrization::uniform, false}, 17);
    EXPECT_EQ(fine.tokens, uniform.tokens);
  }
  EXPECT_EQ(refine_on_knots(square, KnotRule::nuli4, {1, Boundary::closed, Parametrization::centripetal, false}, 17)
                .tokens[2],
            "0.05");
}

/// Weights evaluated one by one give what the kernels give, and the 8-point rule keeps quartics.
TEST(RefineByWeights, AgreesWithKernels) {
  const kernels::PointSet points = read("x,y\n0,0\n4,1\n4.2,3\n1,4\n0.3,4.1\n-1,2\n-1.1,1.9\n-0.5,0.5\n-0.4,0.2\n");
  for (const auto& [scheme, rule] : {std::pair("nuli:n=3", KnotRule::nuli4), std::pair("nuli:n=4", KnotRule::nuli6)})
    for (const Boundary boundary : {Boundary::closed, Boundary::linear, Boundary::given})
      for (const bool again : {false, true}) {
        const KnotOptions options{1, boundary, Parametrization::centripetal, again};
        if (boundary == Boundary::given && rule == KnotRule::nuli6) continue;  // too few points
        const auto fine = refine_by_weights(*sampled_scheme(scheme), points, options);
        const auto expected = kernels::refine_on_knots(points, rule, options);
        ASSERT_EQ(fine.values.size(), expected.values.size());
        for (size_t i = 0; i < fine.values.size(); ++i) EXPECT_NEAR(fine.values[i], expected.values[i], 1e-12);
      }
  // Edge parameters, 0 and 1 too, and how they are inherited.
  const kernels::PointSet edges = read(
      "x,y,lambda,d,tag\n0,0,0.5,1,0\n4,1,1,0.5,1\n4.2,3,0,0.75,1\n1,4,0.25,1.5,1\n0.3,4.1,0.5,0.25,0\n"
      "-1,2,0.75,3,0\n-1.1,1.9,0.5,0.125,1\n-1,1.8,0.5,0.125,0\n-0.5,0.5,0.5,1,0\n");
  for (const auto& [scheme, rule] : {std::pair("nuli:n=3", KnotRule::nuli4), std::pair("nuli:n=4", KnotRule::nuli6)})
    for (const Boundary boundary : {Boundary::closed, Boundary::linear}) {
      const KnotOptions options{3, boundary, Parametrization::given, false};
      const auto fine = refine_by_weights(*sampled_scheme(scheme), edges, options);
      const auto expected = kernels::refine_on_knots(edges, rule, options);
      ASSERT_EQ(fine.values.size(), expected.values.size());
      for (size_t i = 0; i < fine.values.size(); ++i) EXPECT_NEAR(fine.values[i], expected.values[i], 1e-12);
    }
  // With digits: the same tokens as the kernels' rules in rational arithmetic, and the doubles of order 6.
  for (const auto& [scheme, rule] : {std::pair("nuli:n=3", KnotRule::nuli4), std::pair("nuli:n=4", KnotRule::nuli6)})
    for (const Boundary boundary : {Boundary::closed, Boundary::linear})
      for (const KnotOptions& options : {KnotOptions{2, boundary, Parametrization::given, false},
                                         KnotOptions{3, boundary, Parametrization::uniform, true}})
        EXPECT_EQ(refine_by_weights(*sampled_scheme(scheme), edges, options, 30).tokens,
                  refine_on_knots(edges, rule, options, 30).tokens);
  const KnotOptions two{2, Boundary::closed, Parametrization::given, false};
  const auto many = refine_by_weights(*sampled_scheme("nuli:n=6"), edges, two, 40);
  const auto few = refine_by_weights(*sampled_scheme("nuli:n=6"), edges, two);
  ASSERT_EQ(many.tokens.size(), few.values.size());
  for (size_t i = 0; i < few.values.size(); ++i)
    EXPECT_NEAR(value(many.tokens[i]), few.values[i], 1e-10 * (1 + std::abs(few.values[i])));
  EXPECT_THROW(refine_by_weights(*sampled_scheme("nuli:n=6"), points, {}, 40), Error);  // irrational ratios
  EXPECT_THROW(refine_by_weights(*sampled_scheme("nuli:n=6"), edges, two, 16), Error);
  std::string text = "x,y,d\n";
  double x = -2;
  for (int j = 0; j < 20; ++j) {
    const double d = j % 3 == 0 ? 0.25 : j % 3 == 1 ? 0.125 : 0.5;
    text += std::to_string(x) + "," + std::to_string(x * x * x * x) + "," + std::to_string(d) + "\n";
    x += d;
  }
  const auto eight =
      refine_by_weights(*sampled_scheme("nuli:n=5"), read(text), {2, Boundary::given, Parametrization::given, false});
  ASSERT_GT(eight.size(), 20U);
  for (size_t j = 0; j < eight.size(); ++j)
    EXPECT_NEAR(eight.values[3 * j + 1], std::pow(eight.values[3 * j], 4), 1e-4 * (1 + eight.values[3 * j + 1]));
  const SampledScheme four = *sampled_scheme("nuli:n=3");
  EXPECT_THROW(refine_by_weights(four, read("x,y,lambda\n0,0,2\n1,0,0\n1,1,0\n"), {}), Error);
  EXPECT_THROW(refine_by_weights(four, read("x,y\n0,0\n0,0\n1,1\n"), {}), Error);
  EXPECT_THROW(refine_by_weights(four, points, {1, Boundary::space, Parametrization::uniform, false}), Error);
  EXPECT_FALSE(sampled_scheme("nuli4"));
}

TEST(RefineKnots, WhatCannotBeUsedIsNamed) {
  const kernels::PointSet points = read(uneven);
  EXPECT_THROW(refine_on_knots(points, KnotRule::nuli4, {}, 16), Error);
  EXPECT_THROW(refine_on_knots(read("x,y,lambda\n0,0,2\n1,0,0\n1,1,0\n"), KnotRule::nuli4, {}, 20), kernels::Error);
  EXPECT_THROW(refine_on_knots(read("x,y\n0,0\n1,0\n1,1\n"), KnotRule::nuli4,
                               {1, Boundary::closed, Parametrization::given, false}, 20),
               kernels::Error);
  EXPECT_THROW(refine_on_knots(read("x,y,d\n0,0,1\n1,0,0\n1,1,1\n"), KnotRule::nuli4,
                               {1, Boundary::closed, Parametrization::given, false}, 20),
               kernels::Error);
  EXPECT_THROW(refine_on_knots(read("x,y,tag\n0,0,1\n1,0,0.5\n1,1,1\n"), KnotRule::nuli4, {}, 20), kernels::Error);
}

}  // namespace
}  // namespace twoscale::lowering
