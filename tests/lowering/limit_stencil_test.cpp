// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/lowering/limit_stencil.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "twoscale/lowering/refine_points.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::lowering {
namespace {

using Stencil = kernels::PointStencil<double>;

std::vector<Stencil> stencils(const std::string& id, unsigned orders, unsigned level = 0,
                              const std::optional<std::string>& v0 = std::nullopt) {
  const Scheme scheme = make_scheme(id);
  return limit_stencils(scheme, bind(scheme, v0, std::nullopt, {}), level, orders);
}

// The weights that are not 0.
void expect(const Stencil& s, long lowest, const std::vector<double>& weights) {
  for (long u = s.lowest; u < s.lowest + static_cast<long>(s.weight.size()); ++u) {
    const bool inside = u >= lowest && u < lowest + static_cast<long>(weights.size());
    EXPECT_DOUBLE_EQ(s.weight[static_cast<std::size_t>(u - s.lowest)],
                     inside ? weights[static_cast<std::size_t>(u - lowest)] : 0.0)
        << "at " << u;
  }
  EXPECT_LE(s.lowest, lowest);
  EXPECT_GE(s.lowest + static_cast<long>(s.weight.size()), lowest + static_cast<long>(weights.size()));
}

TEST(LimitStencil, SplinesHaveTheirValuesAtTheKnots) {
  const auto cubic = stencils("bspline:n=3", 3);
  expect(cubic[0], -1, {1. / 6, 4. / 6, 1. / 6});
  expect(cubic[1], -1, {-1. / 2, 0, 1. / 2});
  expect(cubic[2], -1, {1, -2, 1});
  // Degree 2: the points belong to the middles of the knot intervals.
  const auto quadratic = stencils("bspline:n=2", 2);
  expect(quadratic[0], -1, {1. / 8, 6. / 8, 1. / 8});
  expect(quadratic[1], -1, {-1. / 2, 0, 1. / 2});
  const auto quintic = stencils("bspline:n=5", 3);
  expect(quintic[0], -2, {1. / 120, 26. / 120, 66. / 120, 26. / 120, 1. / 120});
  expect(quintic[2], -2, {1. / 6, 2. / 6, -1, 2. / 6, 1. / 6});
  const auto ternary = stencils("bspline:n=3,arity=3", 3);
  expect(ternary[0], -1, {1. / 6, 4. / 6, 1. / 6});
  expect(ternary[2], -1, {1, -2, 1});
}

TEST(LimitStencil, InterpolatingRulesKeepTheirPoints) {
  // Dubuc 1986: the derivative of the 4-point scheme is (-f_2 + 8 f_1 - 8 f_-1 + f_-2)/12.
  const auto dd = stencils("dd:l=2", 2);
  expect(dd[0], 0, {1});
  expect(dd[1], -2, {1. / 12, -8. / 12, 0, 8. / 12, -1. / 12});
  EXPECT_THROW(stencils("dd:l=2", 3), Error);  // a Jordan block: no second derivative
  EXPECT_THROW(stencils("bspline:n=1", 2), Error);
  EXPECT_THROW(stencils("mask:coefficients=\"[1,1]\",lowest=0", 1), Error);  // not continuous
  EXPECT_THROW(stencils("mask:coefficients=\"[1/2,1,1/3]\",lowest=-1", 1), Error);
}

TEST(LimitStencil, ALevelGivesItsPowers) {
  const auto cubic = stencils("bspline:n=3", 3, 4);
  expect(cubic[1], -1, {-8, 0, 8});
  expect(cubic[2], -1, {256, -512, 256});
}

// Level-dependent: functions of the space, sampled or generated, and their derivatives.
TEST(LimitStencil, SpacesAreDifferentiatedExactly) {
  const double s = std::acos(0.3);
  for (const unsigned level : {0U, 2U}) {
    const auto zeta = stencils("interpolating:family=mixed,l=4", 3, level, "3/10");
    const double h = std::ldexp(1.0, -static_cast<int>(level));
    for (unsigned d = 0; d < 3; ++d) {
      double wave = 0, line = 0, size = 0;
      for (std::size_t i = 0; i < zeta[d].weight.size(); ++i) {
        const double x = h * static_cast<double>(zeta[d].lowest + static_cast<long>(i));
        wave += zeta[d].weight[i] * std::sin(s * x + 0.4);
        line += zeta[d].weight[i] * (2 * x + 1);
        size += std::abs(zeta[d].weight[i]);
      }
      const double expected[] = {std::sin(0.4), s * std::cos(0.4), -s * s * std::sin(0.4)};
      const double slope[] = {1, 2, 0};
      EXPECT_NEAR(wave, expected[d], 1e-15 * size * 4) << d << " at level " << level;
      EXPECT_NEAR(line, slope[d], 1e-15 * size * 4) << d << " at level " << level;
    }
  }
}

TEST(LimitStencil, RefinedFurtherTheLimitStays) {
  const Scheme scheme = make_scheme("harmonic:n=3");
  const Binding binding = bind(scheme, "cosh(1/2)", std::nullopt, {});
  kernels::PointSet points;
  points.columns = {"x", "y"};
  points.dim = 2;
  for (int i = 0; i < 16; ++i) points.values.push_back(i * i % 7);
  const auto limits = [&](unsigned levels) {
    RefineOptions options;
    options.levels = levels;
    options.limit = options.derivative = options.curvature = true;
    std::vector<double> all;
    refined_rows(scheme, binding, points, options).for_each([&](std::span<const double> piece) {
      all.insert(all.end(), piece.begin(), piece.end());
    });
    return all;
  };
  const std::vector<double> coarse = limits(2), fine = limits(5);
  ASSERT_EQ(coarse.size(), 8U * 4 * 5);
  const double p = scheme.shift.to_string() == "0" ? 0 : 0.5;
  ASSERT_EQ(p, 0);
  for (std::size_t j = 0; j < coarse.size(); ++j)
    EXPECT_NEAR(coarse[j], fine[j / 5 * 8 * 5 + j % 5], 1e-10) << j;  // curvatures lose some digits to cancellation
}

TEST(RefinedRows, RefusalsNameWhatIsWrong) {
  const Scheme scheme = make_scheme("bspline:n=3");
  const Binding binding = bind(scheme, std::nullopt, std::nullopt, {});
  kernels::PointSet points;
  points.columns = {"x"};
  points.dim = 1;
  points.values = {1, 2, 3, 4, 6};
  RefineOptions options;
  options.derivative = true;
  EXPECT_THROW(refined_rows(scheme, binding, points, options), Error);  // of which curve?
  options.limit = options.curvature = true;
  EXPECT_THROW(refined_rows(scheme, binding, points, options), Error);  // one column
  options.curvature = false;
  EXPECT_EQ(refined_rows(scheme, binding, points, options).columns, (std::vector<std::string>{"x", "dx"}));
  options.boundary = kernels::Boundary::linear;
  EXPECT_THROW(refined_rows(scheme, binding, points, options), kernels::Error);
}

}  // namespace
}  // namespace twoscale::lowering
