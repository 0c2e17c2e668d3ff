// SPDX-License-Identifier: GPL-3.0-or-later
// Refinement reproduces the functions of the space: circles, exponentials, in doubles and with digits.
#include "twoscale/lowering/refine_points.hpp"

#include <cmath>

#include "support.hpp"
#include "twoscale/kernels/number_text.hpp"

namespace twoscale::lowering {
namespace {

using kernels::Boundary;
using kernels::PointSet;

// f(x_j) in decimals with `digits` digits, and as doubles.
template <class F>
PointSet samples(long first, long count, F f, long digits) {
  PointSet p;
  p.columns = {"x", "y"};
  p.dim = 2;
  for (long j = first; j < first + count; ++j) {
    const auto [x, y] = f(Rational(j));
    for (const ExactReal& c : {x, y}) {
      const std::string text = c.decimal(digits);
      p.tokens.push_back(text);
      p.values.push_back(*kernels::parse_double(text));
    }
  }
  return p;
}

auto circle(long n) {
  return [n](const Rational& j) {
    using F = ExactReal::Function;
    const ExactReal angle = ExactReal(Rational(2) * j / Rational(n)) * ExactReal::pi();
    return std::pair(ExactReal::apply(F::cos, angle), ExactReal::apply(F::sin, angle));
  };
}

auto exponential(const Rational& t) {
  return [t](const Rational& j) {
    return std::pair(ExactReal(j), ExactReal::apply(ExactReal::Function::exp, ExactReal(t * j)));
  };
}

Rational distance(const std::string& text, const ExactReal& x) {
  return abs(test::exact_text(text) - test::exact_text(x.decimal(80)));
}

TEST(RefinePoints, CirclesFromFiveSixSevenPoints) {
  const Scheme s = make_scheme("tension4");
  for (const long n : {5L, 6L, 7L}) {
    const Binding b = lowering::bind(s, std::nullopt, "2*pi*I/" + std::to_string(n), {});
    const PointSet in = samples(0, n, circle(n), 60);
    const unsigned levels = 6;
    const PointSet out = refine_points(s, b, in, {levels, Boundary::closed, 0});
    ASSERT_EQ(out.size(), static_cast<size_t>(n) << levels);
    EXPECT_TRUE(out.tokens.empty());
    const PointSet exact = refine_points(s, b, in, {levels, Boundary::closed, 50});
    ASSERT_EQ(exact.tokens.size(), out.values.size());
    for (size_t j = 0; j < out.size(); ++j) {
      const auto [x, y] = circle(n)(Rational(static_cast<long>(j)) / Rational(1L << levels));
      EXPECT_NEAR(out.values[2 * j], std::stod(x.decimal(20)), 1e-14);
      EXPECT_NEAR(out.values[2 * j + 1], std::stod(y.decimal(20)), 1e-14);
      EXPECT_LT(distance(exact.tokens[2 * j], x), Rational(10).pow(-40));
      EXPECT_LT(distance(exact.tokens[2 * j + 1], y), Rational(10).pow(-40));
    }
  }
}

TEST(RefinePoints, OpenRulesReproduceExponentials) {
  const Scheme s = make_scheme("interpolating:family=mixed,l=3");
  const Binding b = lowering::bind(s, std::nullopt, "2/5", {});
  const unsigned levels = 5;
  for (const Boundary boundary : {Boundary::space, Boundary::given}) {
    const long beyond = boundary == Boundary::given ? 4 : 0;
    const PointSet in = samples(-beyond, 9 + 2 * beyond, exponential(Rational(2, 5)), 60);
    const PointSet out = refine_points(s, b, in, {levels, boundary, 0});
    const PointSet exact = refine_points(s, b, in, {levels, boundary, 45});
    ASSERT_EQ(out.size(), (8U << levels) + 1);
    ASSERT_EQ(exact.size(), out.size());
    for (size_t j = 0; j < out.size(); ++j) {
      const Rational x = Rational(static_cast<long>(j)) / Rational(1L << levels);
      const auto [px, py] = exponential(Rational(2, 5))(x);
      EXPECT_NEAR(out.values[2 * j], static_cast<double>(j) / (1 << levels), 1e-12);
      EXPECT_NEAR(out.values[2 * j + 1], std::stod(py.decimal(20)), 1e-9);
      EXPECT_LT(distance(exact.tokens[2 * j], px), Rational(10).pow(-40));
      EXPECT_LT(distance(exact.tokens[2 * j + 1], py), Rational(10).pow(-40));
    }
  }
}

TEST(RefinePoints, DyadicMasksAreExact) {
  // Deslauriers-Dubuc: 1/16 a step; ties at the last digit go away from zero.
  const Scheme s = make_scheme("dd:l=2");
  const Binding b = lowering::bind(s, std::nullopt, std::nullopt, {});
  PointSet in;
  in.columns = {"x"};
  in.dim = 1;
  in.tokens = {"0.1", "0", "-3", "7.25", "1e-3", "12"};
  for (const auto& t : in.tokens) in.values.push_back(*kernels::parse_double(t));
  const PointSet out = refine_points(s, b, in, {4, Boundary::closed, 17});
  const PointSet fine = refine_points(s, b, in, {4, Boundary::closed, 60});
  for (size_t i = 0; i < out.tokens.size(); ++i) {
    const Rational error = abs(test::exact_text(out.tokens[i]) - test::exact_text(fine.tokens[i]));
    EXPECT_LE(error * Rational(2) * Rational(10).pow(16), Rational(10)) << out.tokens[i];
    EXPECT_LT(fine.tokens[i].size(), 40U) << "exact, so short";
  }
  EXPECT_EQ(out.tokens[0], "0.1");
  EXPECT_EQ(out.tokens[16], "0");
}

TEST(RefinePoints, DigitsAreThoseOfMoreDigits) {
  const Scheme s = make_scheme("mixed:n=2,arity=3");
  const Binding b = lowering::bind(s, "-1/3", std::nullopt, {});
  PointSet in;
  in.columns = {"x", "y"};
  in.dim = 2;
  in.tokens = {"0", "0", "1", "0.3", "1.5", "-2", "0.25", "1e2"};
  for (const auto& t : in.tokens) in.values.push_back(*kernels::parse_double(t));
  const PointSet few = refine_points(s, b, in, {4, Boundary::closed, 20});
  const PointSet many = refine_points(s, b, in, {4, Boundary::closed, 70});
  const PointSet doubles = refine_points(s, b, in, {4, Boundary::closed, 0});
  ASSERT_EQ(few.size(), 4U * 81);
  for (size_t i = 0; i < few.tokens.size(); ++i) {
    const Rational x = test::exact_text(many.tokens[i]);
    EXPECT_LE(abs(test::exact_text(few.tokens[i]) - x) * Rational(10).pow(19) * Rational(2), abs(x) * Rational(11))
        << few.tokens[i];
    EXPECT_NEAR(doubles.values[i], many.values[i], 1e-12);
  }
}

TEST(RefinePoints, Refusals) {
  const Scheme s = make_scheme("dd:l=2");
  const Binding b = lowering::bind(s, std::nullopt, std::nullopt, {});
  PointSet two;
  two.columns = {"x"};
  two.dim = 1;
  two.values = {0, 1};
  EXPECT_EQ(test::refusal([&] {
              refine_points(s, b, two, {1, Boundary::closed, 0});
            }),
            "a closed polygon needs at least 3 points, not 2");
  two.values = {0, 1, 2};
  EXPECT_NE(test::refusal([&] { refine_points(s, b, two, {40, Boundary::closed, 0}); }), "");
  EXPECT_NE(test::refusal([&] { refine_points(s, b, two, {1, Boundary::closed, 5}); }), "");
  const Scheme m = make_scheme("mask:coefficients=\"1/8,1/2,3/4,1/2,1/8\"");
  EXPECT_NE(test::refusal([&] {
              refine_points(m, lowering::bind(m, std::nullopt, std::nullopt, {}), two, {1, Boundary::space, 0});
            }),
            "");
  EXPECT_THROW(refine_points(s, b, two, {1, Boundary::given, 0}), kernels::Error);
}

}  // namespace
}  // namespace twoscale::lowering
