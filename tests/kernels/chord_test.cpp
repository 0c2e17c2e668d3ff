// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/kernels/chord.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tables.hpp"

namespace twoscale::kernels {
namespace {

using testing::chaikin;
using testing::cubic_spline;
using testing::four_point;
using testing::stationary;
using testing::tension;

std::vector<double> star() {
  std::vector<double> points;
  for (int j = 0; j < 9; ++j) {
    const double r = j % 2 == 0 ? 3 : 1;
    points.push_back(r * std::cos(0.7 * j));
    points.push_back(r * std::sin(0.7 * j));
  }
  return points;
}

// The distance between the polygon of level k and a much finer one at equal parameters, both with the shift p.
double distance(const MaskTable& table, int k, int fine, double p) {
  const std::vector<double> coarse = refine(star(), 2, table, k, Boundary::closed);
  const std::vector<double> dense = refine(star(), 2, table, fine, Boundary::closed);
  const std::size_t n = coarse.size() / 2;
  double most = 0;
  for (std::size_t i = 0; i < dense.size() / 2; ++i) {
    const double at = (static_cast<double>(i) + p) / std::pow(table.arity, fine - k) - p + static_cast<double>(n);
    const std::size_t j = static_cast<std::size_t>(std::floor(at));
    const double part = at - std::floor(at);
    double square = 0;
    for (std::size_t c = 0; c < 2; ++c) {
      const double chord = (1 - part) * coarse[j % n * 2 + c] + part * coarse[(j + 1) % n * 2 + c];
      square += std::pow(dense[2 * i + c] - chord, 2);
    }
    most = std::max(most, std::sqrt(square));
  }
  return most;
}

TEST(Chord, TheFactorOfTheCubicSpline) {
  // f^{k+1} - P_k is D^2 f/8 at old points, 0 at new ones; D^2 is quartered: 1/8/(1 - 1/4).
  EXPECT_NEAR(chord_factor(cubic_spline(), 0), 1. / 6, 1e-8);
  EXPECT_NEAR(chord_factor(cubic_spline(), 7), 1. / 6, 1e-8);
}

TEST(Chord, TheBoundHoldsAndIsNotFarOff) {
  const std::pair<MaskTable, double> cases[] = {
      {cubic_spline(), 0.0}, {chaikin(), 0.5}, {four_point(), 0.0}, {tension(0.5, 30), 0.0}};
  for (const auto& [table, p] : cases) {
    for (int k = 0; k < 5; ++k) {
      const std::vector<double> level = refine(star(), 2, table, k, Boundary::closed);
      const double bound = chord_factor(table, k) * largest_second_difference(level, 2, true);
      const double true_one = distance(table, k, k + 6, p);
      EXPECT_LE(true_one, bound) << k;
      EXPECT_LE(bound, 12 * true_one) << k;
    }
  }
}

TEST(Chord, LevelsAreTheFirstThatAreGoodEnough) {
  const MaskTable table = four_point();
  Refiner<double> refiner(table);
  for (const double tolerance : {0.3, 0.01, 1e-4, 1e-9}) {
    const int k = levels_for_chord(refiner, table, star(), 2, 20, Boundary::closed, tolerance);
    const auto bound = [&](int level) {
      return chord_factor(table, level) *
             largest_second_difference(refine(star(), 2, table, level, Boundary::closed), 2, true);
    };
    EXPECT_LT(bound(k), tolerance);
    if (k > 0) {
      EXPECT_GE(bound(k - 1), tolerance);
    }
  }
  EXPECT_EQ(levels_for_chord(refiner, table, star(), 2, 3, Boundary::closed, 1e-12), 3);
}

TEST(Chord, SecondDifferencesWrapWhenClosed) {
  const std::vector<double> points = {0, 1, 2, 3};
  EXPECT_EQ(largest_second_difference(points, 1, false), 0.0);
  EXPECT_EQ(largest_second_difference(points, 1, true), 4.0);
}

TEST(Chord, RefusalsNameWhatIsMissing) {
  // Constants but not x; x but second differences that do not contract.
  EXPECT_THROW(chord_factor(stationary(2, 0, {1, 0.75, 0, 0.25}), 0), Error);
  EXPECT_THROW(chord_factor(stationary(2, -3, {-0.4, 0, 0.9, 1, 0.9, 0, -0.4}), 0), Error);
  Refiner<double> refiner(four_point());
  EXPECT_THROW(levels_for_chord(refiner, four_point(), star(), 2, 3, Boundary::given, 0.1), Error);
  EXPECT_THROW(levels_for_chord(refiner, four_point(), star(), 2, 3, Boundary::closed, 0), Error);
}

}  // namespace
}  // namespace twoscale::kernels
