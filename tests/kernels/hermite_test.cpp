// SPDX-License-Identifier: GPL-3.0-or-later
/// The Hermite kernels in double precision: circles, frames, charts, poles, refusals.
#include "twoscale/kernels/hermite.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace twoscale::kernels {
namespace {

constexpr double pi = std::numbers::pi;
using Tension = HermiteRuleTension;

HermiteData<double> points(std::size_t dim, std::vector<double> f, bool closed = true) {
  HermiteData<double> d;
  d.dim = dim;
  d.f = std::move(f);
  d.closed = closed;
  return d;
}

std::vector<double> on_circle(const std::vector<double>& angles, double radius = 3, double x = 1, double y = -2) {
  std::vector<double> f;
  for (const double a : angles) f.insert(f.end(), {x + radius * std::cos(a), y + radius * std::sin(a)});
  return f;
}

double radial_error(const std::vector<double>& f, double radius = 3, double x = 1, double y = -2) {
  double worst = 0;
  for (std::size_t i = 0; i < f.size(); i += 2)
    worst = std::max(worst, std::abs(std::hypot(f[i] - x, f[i + 1] - y) - radius));
  return worst;
}

HermiteData<double> refined(HermiteData<double> d, unsigned levels, double w = 1, Tension tension = Tension::printed) {
  return HermiteCurve<double>(std::move(d), w, tension).refined(levels);
}

/// Integers are exact: ties go to the first vertex.
TEST(Hermite, MeasureOfExactPoints) {
  const std::vector<int> square = {1, 1, 3, 1, 3, 3, 1, 3, -1, 3};
  const HermiteMeasure m = hermite_measure<int>(square, 2);
  EXPECT_EQ(m.farthest, 2U);
  EXPECT_EQ(m.outermost, 2U);
  EXPECT_EQ(m.apex, 4U);
  EXPECT_FALSE(m.one_point);
  EXPECT_TRUE(hermite_measure<int>(std::vector<int>{2, 2, 2, 2, 2, 2}, 3).one_point);
  const std::vector<int> line = {0, 0, 0, 1, 1, 1, 2, 2, 2};
  EXPECT_EQ(hermite_measure<int>(line, 3).farthest, 2U);
  EXPECT_FALSE(hermite_measure<int>(line, 3).one_point);
  // A curve measured by others is the same where it is not on a circle.
  auto given = points(2, {0, 0, 4, -1, 5, 2, 2, 5, -1, 3});
  const auto found = refined(given, 3);
  given.measure = hermite_measure<double>(given.f, 2);
  EXPECT_EQ(refined(given, 3).f, found.f);
  given.measure->one_point = true;
  EXPECT_THROW(refined(given, 3), Error);
}

TEST(Hermite, CirclesFromArbitrarySpacingBothDirectionsAndSeveralTurns) {
  const std::vector<std::vector<double>> cases = {
      {0.3, 0.5, 2.0, 3.9, 5.1},             // counterclockwise
      {-0.3, -0.5, -2.0, -3.9, -5.1},        // clockwise
      {0, pi / 2, pi, 3 * pi / 2},           // vertices on the axes
      {pi, 3 * pi / 2, 2 * pi, 5 * pi / 2},  // the first one on the negative axis
      {0.1, 0.1 + 4 * pi / 5, 0.1 + 8 * pi / 5, 0.1 + 12 * pi / 5, 0.1 + 16 * pi / 5},  // pentagram: two turns
      {0, 0.1, 0.2, 0.3}};  // a closing edge of almost a turn
  for (const auto& angles : cases) {
    const auto out = refined(points(2, on_circle(angles)), 10);
    EXPECT_EQ(out.size(), angles.size() << 10);
    EXPECT_LT(radial_error(out.f), 1e-12) << angles[1];
  }
  const auto arc = refined(points(2, on_circle({0.4, 0.5, 1.7, 5.9}), false), 10);
  EXPECT_EQ(arc.size(), (3U << 10) + 1);
  EXPECT_LT(radial_error(arc.f), 1e-12);
  // More than 2 pi from end to end, and beyond the pole of t at sigma = 2 pi.
  EXPECT_LT(radial_error(refined(points(2, on_circle({3.0, 4.0, 5.5, 7.0, 9.0, 11.0, 12.9}), false), 10).f), 1e-12);
}

/// The data of §3.1 in the file: p and r as the paper prints them, from the x-axis, sigma found by Algorithm 1.
TEST(Hermite, CirclesFromPrintedDerivatives) {
  for (const double start : {-3.0, 0.0, 1.0, 3.1}) {
    HermiteData<double> d = points(2, {});
    for (const double step : {0.0, 0.7, 2.0, 4.4}) {
      double sigma = start + step;
      if (sigma > 2 * pi) sigma -= 2 * pi;
      // (S.5) shifts all back by 2 pi when the last one reaches 2 pi.
      if (start + 4.4 >= 2 * pi) sigma = start + step - 2 * pi;
      const double a = std::tan(sigma / 4), b = a * a + 1;
      const double x = 3 * (a * a + 2 * a - 1) * (a * a - 2 * a - 1) / (b * b);
      const double y = -12 * a * (a * a - 1) / (b * b);
      d.f.insert(d.f.end(), {x, y});
      d.p.insert(d.p.end(), {-8 * y / b, 8 * x / b});
      d.r.insert(d.r.end(), {-192 * (3 * a * a * a * a - 8 * a * a + 1) / (b * b * b * b),
                             -96 * a * (a * a * a * a - 14 * a * a + 9) / (b * b * b * b)});
    }
    EXPECT_LT(radial_error(refined(d, 10).f, 3, 0, 0), 1e-12) << start;
  }
}

TEST(Hermite, CirclesInSpaceInAnyPlane) {
  const std::vector<std::array<std::array<double, 3>, 2>> planes = {
      {{{1, 0, 0}, {0, 0, 1}}},  // y = const: the normal is parallel to e_y
      {{{1, 0, 0}, {0, 0, -1}}},
      {{{0, 1, 0}, {0, 0, 1}}},
      {{{0.6, 0.8, 0}, {-0.48, 0.36, 0.8}}},
      {{{0, 0.6, -0.8}, {1, 0, 0}}}};
  for (const auto& [u, v] : planes) {
    std::vector<double> f;
    const std::array<double, 3> centre = {0.5, -1, 2};
    for (const double a : {0.2, 1.0, 1.3, 3.0, 5.5})
      for (std::size_t c = 0; c < 3; ++c) f.push_back(centre[c] + 2 * (std::cos(a) * u[c] + std::sin(a) * v[c]));
    const auto out = refined(points(3, f), 8);
    double worst = 0;
    for (std::size_t i = 0; i < out.f.size(); i += 3) {
      double square = 0;
      for (std::size_t c = 0; c < 3; ++c) square += (out.f[i + c] - centre[c]) * (out.f[i + c] - centre[c]);
      worst = std::max(worst, std::abs(std::sqrt(square) - 2));
    }
    EXPECT_LT(worst, 1e-13);
  }
}

/// Points alone: a rigid motion of the points moves the curve, in the plane and in space.
TEST(Hermite, RigidMotionsMoveTheCurve) {
  const std::vector<double> f = {0, 0, 4, -1, 5, 2, 2, 5, -1, 3};
  for (const bool closed : {true, false})
    for (const auto tension : {Tension::printed, Tension::c2}) {
      const auto plain = refined(points(2, f, closed), 5, 1.3, tension);
      const double angle = 2.2, x = 7, y = -3;
      std::vector<double> moved, mirrored, space;
      for (std::size_t i = 0; i < f.size(); i += 2) {
        moved.push_back(x + std::cos(angle) * f[i] - std::sin(angle) * f[i + 1]);
        moved.push_back(y + std::sin(angle) * f[i] + std::cos(angle) * f[i + 1]);
        mirrored.insert(mirrored.end(), {f[i], -f[i + 1]});
        // In a tilted plane with orthonormal directions (0.6, 0, 0.8), (0.64, 0.6, -0.48).
        space.insert(space.end(), {0.6 * f[i] + 0.64 * f[i + 1], 0.6 * f[i + 1] + 1, 0.8 * f[i] - 0.48 * f[i + 1]});
      }
      const auto turned = refined(points(2, moved, closed), 5, 1.3, tension);
      const auto mirror = refined(points(2, mirrored, closed), 5, 1.3, tension);
      const auto tilted = refined(points(3, space, closed), 5, 1.3, tension);
      ASSERT_EQ(turned.f.size(), plain.f.size());
      for (std::size_t i = 0; i < plain.size(); ++i) {
        const double px = plain.f[2 * i], py = plain.f[2 * i + 1];
        EXPECT_NEAR(turned.f[2 * i], x + std::cos(angle) * px - std::sin(angle) * py, 1e-12);
        EXPECT_NEAR(turned.f[2 * i + 1], y + std::sin(angle) * px + std::cos(angle) * py, 1e-12);
        EXPECT_NEAR(mirror.f[2 * i + 1], -py, 1e-12);
        EXPECT_NEAR(tilted.f[3 * i], 0.6 * px + 0.64 * py, 1e-12);
        EXPECT_NEAR(tilted.f[3 * i + 1], 0.6 * py + 1, 1e-12);
        EXPECT_NEAR(tilted.f[3 * i + 2], 0.8 * px - 0.48 * py, 1e-12);
      }
    }
}

/// Data that Algorithm 1 as printed has no usable angles for.
TEST(Hermite, AnglesAscendForAwkwardData) {
  const std::vector<std::pair<std::vector<double>, bool>> cases = {
      {{0, 0, 1, 0, 2, 1e-9, 3, 0, 3, 2, 0, 2}, true},  // nearly collinear
      {{0, 0, 1, 0, 2, 1e-3, 3, 0}, false},
      {{0, 0, 1, 0, 2, 0, 3, 1}, false},                   // exactly collinear in part
      {{1, 0, 0, 0, 0, 1, -1, 0, 0, -1}, true},            // a vertex near the centre
      {{0, 0, 4, 0, 4, 4, 2, 1, 0, 4}, true},              // not star-shaped
      {{0, 3, 2, -3, -3, 1, 3, 1, -2, -3.2}, true},        // pentagram that is not on a circle
      {{-2, 0, -1, 1, 1, -1, 2, 0, 1, 1, -1, -1}, true}};  // figure eight
  for (const auto& [f, closed] : cases) {
    const auto angles = hermite_angles<double>(f, 2, closed, false);
    for (std::size_t i = 0; i + 1 < angles.sigma.size(); ++i) EXPECT_LT(angles.sigma[i], angles.sigma[i + 1]) << f[2];
    if (closed) {
      EXPECT_LT(angles.sigma.back(), angles.sigma[0] + angles.period);
    }
    for (const double x : refined(points(2, f, closed), 6).f) EXPECT_LT(std::abs(x), 100) << f[2];
  }
}

/// In the plane sigma is the angle from the x-axis about the mean of the circumcentres, as printed.
TEST(Hermite, AnglesAreThePaperSValues) {
  const std::vector<double> f = {3, 0.2, 1, 2, -2, 1.5, -1.5, -2, 2, -1.7};
  const auto angles = hermite_angles<double>(f, 2, true, false);
  double bx = 0, by = 0;
  for (std::size_t i = 0; i < 5; ++i) {
    const double* a = &f[2 * ((i + 4) % 5)];
    const double* b = &f[2 * i];
    const double* c = &f[2 * ((i + 1) % 5)];
    const double d = 2 * (a[0] * (b[1] - c[1]) + b[0] * (c[1] - a[1]) + c[0] * (a[1] - b[1]));
    const auto square = [](const double* q) { return q[0] * q[0] + q[1] * q[1]; };
    bx += (square(a) * (b[1] - c[1]) + square(b) * (c[1] - a[1]) + square(c) * (a[1] - b[1])) / d / 5;
    by += (square(a) * (c[0] - b[0]) + square(b) * (a[0] - c[0]) + square(c) * (b[0] - a[0])) / d / 5;
  }
  for (std::size_t i = 0; i < 5; ++i) {
    const double expected = std::atan2(f[2 * i + 1] - by, f[2 * i] - bx);
    EXPECT_NEAR(std::remainder(angles.sigma[i] - expected, 2 * pi), 0, 1e-13);
    if (i > 0) {
      EXPECT_GT(angles.sigma[i], angles.sigma[i - 1]);
    }
  }
  EXPECT_NEAR(angles.period, 2 * pi, 1e-14);
}

/// w = 1: the refined vertices lie on the rational quintic, with its derivatives.
TEST(Hermite, RefinementSamplesTheInterpolant) {
  HermiteData<double> d = points(2, {3, 0.2, 1, 2, -2, 1.5, -1.5, -2}, false);
  const HermiteCurve<double> curve(d, 1, Tension::printed);
  const auto& data = curve.data();
  const auto out = curve.refined(5);
  for (std::size_t k = 0; k < out.size(); ++k) {
    const std::size_t i = std::min<std::size_t>(k / 32, 2);
    const auto rows = hermite_segment(std::tan(data.sigma[i] / 8), std::tan(data.sigma[i + 1] / 8), out.sigma[k]);
    for (std::size_t c = 0; c < 2; ++c) {
      const auto at = [&](const std::vector<double>& list, std::size_t j) { return list[2 * j + c]; };
      double value[3];
      for (std::size_t row = 0; row < 3; ++row)
        value[row] = rows[row][0] * (at(data.f, i + 1) - at(data.f, i)) + rows[row][1] * at(data.p, i) +
                     rows[row][2] * at(data.p, i + 1) + rows[row][3] * at(data.r, i) + rows[row][4] * at(data.r, i + 1);
      EXPECT_NEAR(at(out.f, k), at(data.f, i) + value[0], 1e-13);
      EXPECT_NEAR(at(out.p, k), value[1], 1e-11);
      EXPECT_NEAR(at(out.r, k), value[2], 1e-8);
    }
  }
}

/// Printed tension: the step is finite below w* and refused from there on. The variant has no pole.
TEST(Hermite, FirstPole) {
  const auto d = points(2, {0, 0, 4, -1, 5, 2, 2, 5, -1, 3});
  const double pole = HermiteCurve<double>(d, 1, Tension::printed).first_pole();
  EXPECT_GT(pole, 1);
  for (const double x : refined(d, 8, pole * (1 - 1e-6)).f) EXPECT_TRUE(std::isfinite(x));
  EXPECT_THROW(HermiteCurve<double>(d, pole, Tension::printed), Error);
  EXPECT_THROW(HermiteCurve<double>(d, 2 * pole, Tension::printed), Error);
  EXPECT_THROW(HermiteCurve<double>(d, 0, Tension::c2), Error);
  EXPECT_THROW(HermiteCurve<double>(d, -1, Tension::c2), Error);
  EXPECT_NO_THROW(HermiteCurve<double>(d, 10 * pole, Tension::c2));
}

/// Small w: both tensions tend to the polygon.
TEST(Hermite, SmallTensionTendsToThePolygon) {
  const auto d = points(2, {0, 0, 4, -1, 5, 2, 2, 5, -1, 3});
  for (const auto tension : {Tension::printed, Tension::c2}) {
    const auto out = refined(d, 6, 1e-4, tension);
    for (std::size_t i = 0; i < out.size(); ++i) {
      const std::size_t edge = i / 64;
      const double* a = &d.f[2 * edge];
      const double* b = &d.f[2 * ((edge + 1) % 5)];
      const double ex = b[0] - a[0], ey = b[1] - a[1];
      const double distance =
          std::abs(ex * (out.f[2 * i + 1] - a[1]) - ey * (out.f[2 * i] - a[0])) / std::hypot(ex, ey);
      EXPECT_LT(distance, 1e-3);
    }
  }
}

/// Curvature of the refined points at the vertices is |p x r|/|p|^3 from both sides, whatever the tension (the theorem
/// of reports/hermite2010/tension.md, seen in doubles; the closing vertex too).
TEST(Hermite, CurvatureAtVerticesDoesNotDependOnTension) {
  const auto d = points(2, {0, 0, 4, -1, 5, 2, 2, 5, -1, 3});
  for (const auto tension : {Tension::printed, Tension::c2})
    for (const double w : {0.6, 1.0, 1.7}) {
      const HermiteCurve<double> curve(d, w, tension);
      const auto& given = curve.data();
      const unsigned levels = 9;
      const auto out = curve.refined(levels);
      const std::size_t n = out.size();
      for (std::size_t i = 0; i < 5; ++i) {
        const double expected = (given.p[2 * i] * given.r[2 * i + 1] - given.p[2 * i + 1] * given.r[2 * i]) /
                                std::pow(std::hypot(given.p[2 * i], given.p[2 * i + 1]), 3);
        for (const std::size_t side : {std::size_t{1}, n - 1}) {
          // 2 sin(angle to the tangent)/chord.
          const std::size_t j = ((i << levels) + side) % n;
          const double cx = out.f[2 * j] - given.f[2 * i], cy = out.f[2 * j + 1] - given.f[2 * i + 1];
          const double speed = std::hypot(given.p[2 * i], given.p[2 * i + 1]);
          const double sign = side == 1 ? 1 : -1;
          const double k =
              sign * 2 * (given.p[2 * i] * cy - given.p[2 * i + 1] * cx) * sign / speed / (cx * cx + cy * cy);
          EXPECT_NEAR(k, expected, 0.02 * (1 + std::abs(expected))) << w << " vertex " << i << " side " << side;
        }
      }
    }
}

/// Random data, many of them degenerate (small integers, nearly on a line): refused or finite, sigma ascends, the first
/// pole is beyond 1, and a rigid motion of generic points moves the curve.
TEST(Hermite, RandomData) {
  std::mt19937_64 random(2010);
  const auto uniform = [&] { return std::uniform_real_distribution<double>(-1, 1)(random); };
  int refused = 0;
  for (int round = 0; round < 3000; ++round) {
    const std::size_t n = 3 + random() % 7;
    const std::size_t dim = 2 + random() % 2;
    const auto kind = random() % 3;  // integers, nearly on a line, generic
    std::vector<double> f;
    for (std::size_t i = 0; i < n * dim; ++i)
      f.push_back(kind == 0 ? static_cast<double>(random() % 4) : uniform() * (kind == 1 && i % dim == 1 ? 1e-7 : 1));
    HermiteData<double> d = points(dim, f, random() % 2 == 0);
    const bool given = random() % 3 == 0;
    for (std::size_t i = 0; given && i < n * dim; ++i) {
      d.p.push_back(5 * uniform());
      d.r.push_back(5 * uniform());
    }
    const auto tension = random() % 2 == 0 ? Tension::printed : Tension::c2;
    try {
      const HermiteCurve<double> curve(d, 1, tension);
      EXPECT_GT(curve.first_pole(), 1);
      const auto angles = hermite_angles<double>(f, dim, d.closed, false);
      for (std::size_t i = 0; i + 1 < n; ++i) EXPECT_LT(angles.sigma[i], angles.sigma[i + 1]) << round;
      const auto out = curve.refined(3);
      for (const double x : out.f) EXPECT_TRUE(std::isfinite(x)) << round;
      if (given || kind != 2) continue;
      const double turn[3][3] = {{0.36, 0.48, -0.8}, {-0.8, 0.6, 0}, {0.48, 0.64, 0.6}};
      const auto moved = [&](const std::vector<double>& list) {
        std::vector<double> to;
        for (std::size_t i = 0; i < list.size(); i += dim)
          for (const auto& row : turn) {
            double x = 1;
            for (std::size_t c = 0; c < dim; ++c) x += row[c] * list[i + c];
            to.push_back(x);
          }
        return to;
      };
      const auto expected = moved(out.f);
      const auto turned = refined(points(3, moved(f), d.closed), 3, 1, tension).f;
      const double size = std::abs(*std::max_element(expected.begin(), expected.end(),
                                                     [](double a, double b) { return std::abs(a) < std::abs(b); }));
      for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(turned[i], expected[i], 1e-6 * size) << round;
    } catch (const Error&) {
      ++refused;
      EXPECT_EQ(kind, 0U) << round;  // equal neighbours, points on a line
    }
  }
  EXPECT_GT(refused, 100);
}

/// Derivatives found from points that are on no circle: those of the circle through three neighbours, so that points
/// near a circle give a curve near it, with any spacing.
TEST(Hermite, PointsNearACircleGiveACurveNearIt) {
  for (const bool closed : {true, false})
    for (const double error : {1e-3, 1e-6, 1e-9}) {
      auto f = on_circle({0.3, 0.5, 2.0, 3.9, 5.1});
      f[4] += 3 * error;
      const auto out = refined(points(2, f, closed), 6);
      EXPECT_LT(radial_error(out.f), 60 * error) << closed;
      EXPECT_GT(radial_error(out.f), error / 10) << closed;
    }
  // A vertex whose neighbours are one point is a cusp.
  const HermiteCurve<double> cusp(points(2, {0, 0, 1, 0.2, 3, 0, 1, 0.2, 0.5, 2}), 1, Tension::printed);
  EXPECT_EQ(cusp.data().p[4], 0);
  EXPECT_EQ(cusp.data().r[5], 0);
  EXPECT_NE(cusp.data().p[0], 0);
}

/// A number that knows its rounding errors no better than 1e-12: what it cannot decide is said.
struct Coarse {
  double x = 0;
  Coarse() = default;
  explicit Coarse(int n) : x(n) {}
  explicit Coarse(double y) : x(y) {}
  friend Coarse operator+(Coarse a, Coarse b) { return Coarse(a.x + b.x); }
  friend Coarse operator-(Coarse a, Coarse b) { return Coarse(a.x - b.x); }
  friend Coarse operator*(Coarse a, Coarse b) { return Coarse(a.x * b.x); }
  friend Coarse operator/(Coarse a, Coarse b) { return Coarse(a.x / b.x); }
  friend Coarse operator-(Coarse a) { return Coarse(-a.x); }
  friend Coarse sqrt(Coarse a) { return Coarse(std::sqrt(a.x)); }
  friend Coarse sin(Coarse a) { return Coarse(std::sin(a.x)); }
  friend Coarse tan(Coarse a) { return Coarse(std::tan(a.x)); }
  friend Coarse atan2(Coarse y, Coarse x) { return Coarse(std::atan2(y.x, x.x)); }
  friend double estimate(Coarse a) { return a.x; }
  friend bool negligible(Coarse a, Coarse b) { return negligible(a.x, b.x); }
  friend Coarse widened(Coarse a, Coarse) { return a; }
  friend bool is_less(Coarse a, Coarse b, const char* what) {
    if (std::abs(a.x - b.x) <= 1e-12 * (std::abs(a.x) + std::abs(b.x))) throw HermiteUndecided(what);
    return a.x < b.x;
  }
};

HermiteData<Coarse> coarse(const HermiteData<double>& d) {
  HermiteData<Coarse> c;
  c.dim = d.dim;
  c.closed = d.closed;
  const auto copy = [](const std::vector<double>& from, std::vector<Coarse>& to) {
    for (const double x : from) to.emplace_back(x);
  };
  copy(d.f, c.f);
  copy(d.p, c.p);
  copy(d.r, c.r);
  copy(d.sigma, c.sigma);
  return c;
}

TEST(Hermite, CasesThatANumberTypeCannotDecideAreSaid) {
  const auto said = [](const HermiteData<double>& d, double w) -> std::string {
    try {
      HermiteCurve<Coarse>(coarse(d), Coarse(w), Tension::printed);
    } catch (const HermiteUndecided& e) {
      return e.what();
    }
    return "";
  };
  // Equal numbers where the rules have a margin are no tie.
  const auto plain = points(2, {0, 0, 4, -1, 5, 2, 2, 5, -1, 3});
  EXPECT_EQ(said(plain, 1), "");
  EXPECT_EQ(said(points(3, {0, 0, 1, 4, 0, 1, 4, 3, 1, 0, 3, 1}), 1), "");
  EXPECT_EQ(said(points(2, on_circle({0, pi / 2, pi, 3 * pi / 2})), 1), "");
  EXPECT_EQ(said(points(3, {3, 0, 0.5, 1, 2.5, -0.25, -2, 1, 1, -2.5, -1.5, 0, 0.5, -2, 0.75}), 1), "");
  // A tie, and beside it.
  const double pole = HermiteCurve<double>(plain, 1, Tension::printed).first_pole();
  EXPECT_EQ(said(plain, pole), "w is below the first pole");
  EXPECT_EQ(said(plain, pole * (1 - 1e-9)), "");
  EXPECT_THROW(said(plain, pole * (1 + 1e-9)), Error);
  // A vertex that is as far from the line of the others as counts as being on it.
  EXPECT_EQ(said(points(2, {0, 0, 1, 0, 0.5, 1e-12}), 1), "all points lie on a line");
}

TEST(Hermite, UnusableDataAreRefused) {
  const auto refused = [](HermiteData<double> d) {
    EXPECT_THROW(HermiteCurve<double>(std::move(d), 1, Tension::printed), Error);
  };
  refused(points(2, {0, 0, 1, 1}));
  refused(points(2, {0, 0, 1, 1, 2, 2}));
  refused(points(2, {1, 1, 1, 1, 1, 1}));
  refused(points(2, {0, 0, 1, 0, 1, 0, 0, 1}));
  auto d = points(2, {1, 0, 0, 1, -1, 0});
  d.sigma = {0, 2, 1};
  refused(d);
  d = points(2, {1, 0, 0, 1, -1, 0}, false);
  d.p = d.r = d.f;
  d.sigma = {0, 1, 2 * pi};
  refused(d);
}

}  // namespace
}  // namespace twoscale::kernels
