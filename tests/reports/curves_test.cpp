// SPDX-License-Identifier: GPL-3.0-or-later
// Measurements on curves whose answers are known.
#include "twoscale/reports/curves.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"

namespace {

using namespace twoscale;
using namespace twoscale::reports;

const double pi = std::acos(-1.0);

lowering::Binding binding_of(const Scheme& s, const char* v0) {
  return lowering::bind(s, v0 == nullptr ? std::nullopt : std::optional<std::string>(v0), std::nullopt, {});
}

TEST(Curves, BasicLimitFunctionOfTheHatAndTheQuadraticSpline) {
  const Scheme hat = make_scheme("bspline:n=1");
  const Refined h = basic_limit_function(hat, binding_of(hat, nullptr), 4);
  for (std::size_t j = 0; j < h.size(); ++j)
    EXPECT_DOUBLE_EQ(h.values[2 * j + 1], std::max(0.0, 1 - std::abs(h.values[2 * j]))) << h.values[2 * j];
  // Dual: the limit is symmetric about 1/2 when f^0_0 belongs to 1/2.
  const Scheme quadratic = make_scheme("bspline:n=2");
  const Refined q = basic_limit_function(quadratic, binding_of(quadratic, nullptr), 8);
  double sum = 0, moment = 0;
  for (std::size_t j = 0; j < q.size(); ++j) {
    sum += q.values[2 * j + 1];
    moment += q.values[2 * j] * q.values[2 * j + 1];
  }
  EXPECT_NEAR(sum * q.step, 1, 1e-12);
  EXPECT_NEAR(moment / sum, 0.5, 1e-12);
}

TEST(Curves, BasicLimitFunctionInterpolatesAndEndsAtItsSupport) {
  const Scheme s = make_scheme("interpolating:family=resonant,l=3");
  const Refined f = basic_limit_function(s, binding_of(s, "-2/5"), 5);
  EXPECT_LE(f.values.front(), -5);
  EXPECT_GE(f.values[f.values.size() - 2], 5);
  for (std::size_t j = 0; j < f.size(); ++j) {
    const double t = f.values[2 * j], v = f.values[2 * j + 1];
    if (t == std::round(t) || std::abs(t) >= 5) {
      EXPECT_EQ(v, t == 0 ? 1 : 0) << t;
    }
  }
}

TEST(Curves, DeviationAndDistance) {
  const Refined square{{0, 0, 1, 0, 1, 1, 0, 1, 0.5, -0.25}, 2, 0, 1};
  EXPECT_DOUBLE_EQ(distance_to_polygon(square, std::vector<double>{0, 0, 1, 0, 1, 1, 0, 1}, true),
                   0.25 / std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(distance_to_polygon(square, std::vector<double>{0, 0, 1, 0, 1, 1}, false), 1 / std::sqrt(2.0));
  const Refined line{{0, 0, 1, 1.5, 2, 2}, 2, 0, 1};
  EXPECT_DOUBLE_EQ(largest_deviation(line, [](double t, double* p) { p[0] = p[1] = t; }), 0.5 / std::sqrt(8.0));
}

TEST(Curves, TurningAndCurvatureOfACircle) {
  std::vector<double> circle;
  for (int j = 0; j < 100; ++j)
    circle.insert(circle.end(), {2 * std::cos(2 * pi * j / 100), 2 * std::sin(2 * pi * j / 100)});
  EXPECT_NEAR(total_turning(circle, true), 1, 1e-12);
  EXPECT_NEAR(total_turning(circle, false), 0.98, 1e-12);
  for (double k : curvature(circle, true)) EXPECT_NEAR(k, 0.5, 1e-12);
  EXPECT_TRUE(std::isnan(curvature(circle, false).front()));
  EXPECT_TRUE(std::isnan(curvature(std::vector<double>{0, 0, 0, 0, 1, 0}, true)[0]));
}

TEST(Curves, SingularValuesAndLevelsAreRefused) {
  const Scheme s = make_scheme("interpolating:family=harmonic,l=3");
  const std::vector<double> points = {0, 0, 1, 0, 1, 1, 0, 1};
  EXPECT_THROW(refine_points(s, binding_of(s, "-1/2"), points, 2, 3, kernels::Boundary::closed), Error);
  EXPECT_THROW(refine_points(s, binding_of(s, "1/2"), points, 2, 25, kernels::Boundary::closed), Error);
}

}  // namespace
