// SPDX-License-Identifier: GPL-3.0-or-later
// The page about nuli: interpolants from the splines, the region of C^2 limits, the page itself.
#include "twoscale/reports/nuli.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "twoscale/analysis/knots.hpp"
#include "twoscale/kernels/write_file.hpp"
#include "twoscale/symbolic/catalog.hpp"

namespace twoscale::reports::nuli {
namespace {

using kernels::Boundary;
using kernels::KnotRule;

double distance(const std::vector<double>& a, std::size_t i, const std::vector<double>& b, std::size_t j) {
  return std::hypot(a[2 * i] - b[2 * j], a[2 * i + 1] - b[2 * j + 1]);
}

/// At the vertices it is the data, in the middle of an edge what the scheme inserts; with other orders it is not.
TEST(NuliPage, TheInterpolantIsTheOneTheSchemeSamples) {
  const auto polygon = with_edge_parameters(hand(), {{2, 0.75}, {3, 0.25}, {6, 0.125}});
  for (const auto& [family, rule] : {std::pair(FundamentalFamily{3, 3, 2}, KnotRule::nuli4),
                                     std::pair(FundamentalFamily{4, 4, 3}, KnotRule::nuli6)}) {
    constexpr int samples = 6;
    const auto curve = interpolant(polygon, family, samples);
    const auto fine = kernels::refine_knots(polygon, rule, 1, Boundary::closed).points;
    ASSERT_EQ(curve.size(), polygon.size() * 2 * samples * 2);
    for (std::size_t e = 0; e < polygon.size(); ++e) {
      EXPECT_LT(distance(curve, e * 2 * samples, polygon.points, e), 1e-14);
      // The middle in units of the half that it lies in.
      const double l = polygon.lambda[e];
      const double at = l >= 0.5 ? 0.5 / l * samples : samples + (0.5 - l) / (1 - l) * samples;
      if (std::abs(at - std::round(at)) > 1e-9) continue;
      EXPECT_LT(distance(curve, e * 2 * samples + static_cast<std::size_t>(std::lround(at)), fine, 2 * e + 1), 1e-13)
          << e;
    }
  }
  const auto right = interpolant(polygon, {4, 4, 3}, 2), other = interpolant(polygon, {4, 3, 3}, 2);
  double difference = 0;
  for (std::size_t j = 0; j < right.size() / 2; ++j) difference = std::max(difference, distance(right, j, other, j));
  EXPECT_GT(difference, 0.01);
}

TEST(NuliPage, AnEmptyHalfHasNoPoints) {
  const auto polygon = with_edge_parameters(hand(), {{2, 1}});
  EXPECT_EQ(interpolant(polygon, {3, 3, 2}, 4).size(), (2 * polygon.size() - 1) * 4 * 2);
}

/// The polynomial of the picture is the exact condition: the eigenvalues at points on both sides of its zero set.
TEST(NuliPageSlow, TheRegionIsThatOfTheEigenvalues) {
  const Polynomial f = smoothness_boundary();
  const Scheme s = make_scheme("nuli6");
  int inside = 0, outside = 0;
  for (const long k : {0L, 1L, 3L, 7L})
    for (const long q : {0L, 2L, 5L})
      for (const Rational& alpha : {Rational(1, 7), Rational(1), Rational(20)}) {
        const Rational left(k, 16), right(q, 16);
        if (k == 0 && q == 0) continue;
        const auto m = analysis::constant(
            analysis::divided_difference_matrix(analysis::junction(s, alpha, Rational(1) - left, right)));
        std::vector<Rational> c = analysis::characteristic_polynomial(*m);
        Rational g;
        for (const auto& x : c) g = gcd(g, x);
        for (auto& x : c) x /= g;
        const bool smooth = analysis::roots_inside(Polynomial::univariate("z", c), Rational(1, 4));
        EXPECT_EQ(smooth, f.evaluate({{"alpha", alpha}, {"k", left}, {"q", right}}).sign() > 0);
        ++(smooth ? inside : outside);
      }
  EXPECT_GT(inside, 3);
  EXPECT_GT(outside, 3);
}

TEST(NuliPageSlow, ThePageIsWhole) {
  const std::filesystem::path directory =
      std::filesystem::temp_directory_path() / ("twoscale-nuli-" + std::to_string(std::random_device{}()));
  const PaperSummary s = write_report(directory.string(), {});
  EXPECT_GE(s.figures.size(), 30U);
  EXPECT_LT(s.largest_exact_deviation, 1e-13);
  EXPECT_EQ(s.exact_runs, 3);
  const std::string html = kernels::read_file(s.index);
  for (const char* number :
       {"2.1", "2.2", "2.3", "2.4", "3.1", "3.3", "3.4", "5.1", "5.2", "5.3", "5.4", "5.5", "5.6", "5.7"})
    EXPECT_NE(html.find("id=\"figure-" + std::string(number) + "\""), std::string::npos) << number;
  for (const PaperFigure& f : s.figures) EXPECT_TRUE(std::filesystem::exists(directory / f.file)) << f.file;
  std::filesystem::remove_all(directory);
}

}  // namespace
}  // namespace twoscale::reports::nuli
