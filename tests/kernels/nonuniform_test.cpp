// SPDX-License-Identifier: GPL-3.0-or-later
/// Refinement on arbitrary knots: exact in rational arithmetic, robust in doubles.
#include "twoscale/kernels/nonuniform.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <random>

namespace twoscale::kernels {
namespace {

using Exact = boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;

constexpr KnotRule rules[] = {KnotRule::lagrange4, KnotRule::nuli4, KnotRule::nuli6};

Exact power(const Exact& x, int e) {
  Exact r = 1;
  for (int i = 0; i < e; ++i) r *= x;
  return r;
}

// The polynomials x, x^2, .., x^degree on random knots; point and interval lengths of very different sizes.
KnotPolygon<Exact> polynomial_samples(std::mt19937& random, std::size_t points, int degree) {
  KnotPolygon<Exact> p;
  p.closed = false;
  p.dim = static_cast<std::size_t>(degree);
  Exact x = Exact(static_cast<int>(random() % 21)) - 10;
  for (std::size_t j = 0; j < points; ++j) {
    for (int e = 1; e <= degree; ++e) p.points.push_back(power(x, e));
    const Exact d = power(Exact(10), static_cast<int>(random() % 4)) * Exact(static_cast<int>(1 + random() % 9)) /
                    Exact(static_cast<int>(1 + random() % 9));
    if (j + 1 < points) {
      p.d.push_back(d);
      p.lambda.push_back(Exact(static_cast<int>(random() % 9)) / 8);
    }
    x += d;
  }
  p.tagged = default_tags(p);
  return p;
}

/// Quadratics (nuli4) and cubics (nuli6, lagrange4) on 1000 random knot sequences, all edge parameters, exactly; with
/// points given beyond the ends and with the end rule `space`. One degree more is not kept.
TEST(Nonuniform, PolynomialPrecision) {
  std::mt19937 random(7);
  for (const KnotRule rule : rules)
    for (int round = 0; round < 1000; ++round) {
      const int degree = precision(rule);
      const bool given = round % 2 == 0;
      const KnotPolygon<Exact> p =
          polynomial_samples(random, given ? 2 * points_beyond_ends(rule) + 2 : 4 + random() % 3, degree);
      const KnotPolygon<Exact> fine = refine_knots(p, rule, 2, given ? Boundary::given : Boundary::space);
      for (std::size_t j = 0; j < fine.size(); ++j)
        for (int e = 2; e <= degree; ++e)
          ASSERT_EQ(fine.points[j * fine.dim + static_cast<std::size_t>(e - 1)], power(fine.points[j * fine.dim], e))
              << "round " << round;
    }
  const KnotPolygon<Exact> p = polynomial_samples(random, 8, 4);
  for (const KnotRule rule : rules) {
    const KnotPolygon<Exact> fine = refine_knots(p, rule, 1, Boundary::space);
    const auto e = static_cast<std::size_t>(precision(rule));
    bool kept = true;
    for (std::size_t j = 0; j < fine.size(); ++j)
      kept = kept && fine.points[j * 4 + e] == power(fine.points[j * 4], precision(rule) + 1);
    EXPECT_FALSE(kept);
  }
}

/// The parameters x_j themselves: every new one is the middle of its interval.
TEST(Nonuniform, EndRules) {
  std::mt19937 random(11);
  for (const KnotRule rule : rules)
    for (const Boundary boundary : {Boundary::space, Boundary::linear}) {
      const KnotPolygon<Exact> p = polynomial_samples(random, 5, 1);
      const KnotPolygon<Exact> fine = refine_knots(p, rule, 3, boundary);
      ASSERT_EQ(fine.size(), 33U);
      for (std::size_t j = 0; j + 1 < fine.size(); ++j) EXPECT_EQ(fine.points[j + 1] - fine.points[j], fine.d[j]);
    }
}

KnotPolygon<double> polygon(std::vector<double> points, std::vector<double> lambda = {}) {
  KnotPolygon<double> p;
  p.dim = 2;
  p.points = std::move(points);
  p.lambda = lambda.empty() ? std::vector<double>(p.size(), 0.5) : std::move(lambda);
  p.d = knot_intervals(p.points, 2, true, Parametrization::centripetal);
  p.tagged = default_tags(p);
  return p;
}

TEST(Nonuniform, InheritanceOfEdgeParameters) {
  KnotPolygon<double> p = polygon({0, 0, 1, 0, 1, 1, 0, 1}, {0.5, 0.25, 0.75, 0.5});
  EXPECT_EQ(p.tagged, (std::vector<unsigned char>{0, 1, 1, 1}));
  p.tagged = {0, 1, 1, 0};  // the end of edge 2 is not tagged
  p = refine_knots(p, KnotRule::nuli4, 1, Boundary::closed);
  EXPECT_EQ(p.tagged, (std::vector<unsigned char>{0, 0, 1, 0, 1, 0, 0, 0}));
  EXPECT_EQ(p.lambda, (std::vector<double>{0.5, 0.5, 0.25, 0.25, 0.75, 0.5, 0.5, 0.5}));
  p = refine_knots(p, KnotRule::nuli4, 1, Boundary::closed);
  EXPECT_EQ(p.lambda,
            (std::vector<double>{0.5, 0.5, 0.5, 0.5, 0.25, 0.5, 0.5, 0.25, 0.75, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5}));
}

/// Uniform knots and edge parameters 1/2: the masks -1/16, 9/16 and 1/288, -7/96, 41/72.
TEST(Nonuniform, UniformMembers) {
  KnotPolygon<Exact> p;
  p.dim = 1;
  p.points = {0, 0, 0, 0, 1, 0, 0, 0, 0};
  p.d.assign(9, Exact(3));
  p.lambda.assign(9, Exact(1) / 2);
  p.tagged.assign(9, 0);
  const auto odd = [&](KnotRule rule) {
    const KnotPolygon<Exact> fine = refine_knots(p, rule, 1, Boundary::closed);
    std::vector<Exact> values;
    for (std::size_t j = 3; j < 14; j += 2) values.push_back(fine.points[j]);
    return values;
  };
  const Exact a = Exact(-1) / 16, b = Exact(9) / 16;
  EXPECT_EQ(odd(KnotRule::nuli4), (std::vector<Exact>{0, a, b, b, a, 0}));
  EXPECT_EQ(odd(KnotRule::lagrange4), (std::vector<Exact>{0, a, b, b, a, 0}));
  const Exact c = Exact(1) / 288, d = Exact(-7) / 96, e = Exact(41) / 72;
  EXPECT_EQ(odd(KnotRule::nuli6), (std::vector<Exact>{c, d, e, e, d, c}));
}

/// A crease vertex of the 4-point scheme: neither side reads the other (Proposition 3.3).
TEST(Nonuniform, CreaseSeparatesTheSides) {
  const std::vector<double> lambda = {0.5, 0.5, 1, 0, 0.5, 0.5, 0.5, 0.5};
  const std::vector<double> points = {0, 0, 2, 1, 3, 0, 5, 4, 6, 1, 7, 0, 8, 4, 1, 5};
  std::vector<double> moved = points;
  moved[4] += 0.25;
  moved[5] -= 0.5;
  KnotPolygon<double> a = polygon(points, lambda);
  KnotPolygon<double> b = a;
  b.points = moved;
  a = refine_knots(a, KnotRule::nuli4, 6, Boundary::closed);
  b = refine_knots(b, KnotRule::nuli4, 6, Boundary::closed);
  EXPECT_NE(a.points[2 * (2 * 64 + 32)], b.points[2 * (2 * 64 + 32)]);
  for (std::size_t j = 3 * 64; j <= 4 * 64; ++j) EXPECT_EQ(a.points[2 * j], b.points[2 * j]) << j;
}

bool finite(const KnotPolygon<double>& p) {
  for (const double x : p.points)
    if (!std::isfinite(x)) return false;
  return true;
}

/// Ten thousand strongly non-uniform points with duplicates, three nearly equal ones, edge parameters 0 and 1.
TEST(Nonuniform, HarshData) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const KnotRule rule : rules)
    for (const Parametrization kind :
         {Parametrization::centripetal, Parametrization::chordal, Parametrization::uniform}) {
      KnotPolygon<double> p;
      p.dim = 3;
      double x[3] = {0, 0, 0};
      for (int j = 0; j < 10000; ++j) {
        const double size = std::pow(10.0, -8 + 12 * unit(random));
        const bool repeated = j % 17 == 3 || j % 101 < 3;
        for (double& c : x) {
          if (!repeated) c += size * (unit(random) - 0.5);
          p.points.push_back(c);
        }
        if (j % 50 == 7)
          for (int copy = 0; copy < 2; ++copy)
            for (double& c : x) p.points.push_back(c = std::nextafter(c, 1e9));
      }
      for (std::size_t j = 0; j < p.size(); ++j)
        p.lambda.push_back(random() % 3 == 0 ? 1 : random() % 2 == 0 ? 0 : unit(random));
      p.d = knot_intervals(p.points, p.dim, true, kind);
      p.tagged = default_tags(p);
      const double largest = std::abs(*std::max_element(p.points.begin(), p.points.end(),
                                                        [](double a, double b) { return std::abs(a) < std::abs(b); }));
      p = refine_knots(std::move(p), rule, 4, Boundary::closed);
      EXPECT_TRUE(finite(p));
      if (kind != Parametrization::centripetal) continue;
      for (const double c : p.points) ASSERT_LT(std::abs(c), 1.5 * largest);
    }
}

/// A duplicate point: the limit of two that move together.
TEST(Nonuniform, ZeroLengthEdgesAreLimits) {
  for (const KnotRule rule : rules) {
    const auto refined = [&](double gap) {
      return refine_knots(polygon({0, 0, 4, 1, 4 + gap, 1, 5, 3, 1, 4, -1, 2}), rule, 3, Boundary::closed);
    };
    const KnotPolygon<double> limit = refined(0);
    EXPECT_TRUE(finite(limit));
    double last = 1e9;
    for (const double gap : {1e-4, 1e-8, 1e-12}) {
      const KnotPolygon<double> near = refined(gap);
      double difference = 0;
      for (std::size_t i = 0; i < near.points.size(); ++i)
        difference = std::max(difference, std::abs(near.points[i] - limit.points[i]));
      EXPECT_LT(difference, last / 50);  // like the square root of the gap
      last = difference;
    }
    EXPECT_LT(last, 1e-5);
  }
}

/// Three points in one: the limit of three that move together, however they do.
TEST(Nonuniform, ThreeCoincidingPoints) {
  for (const KnotRule rule : rules) {
    const auto refined = [&](double x, double y, double bend) {
      return refine_knots(polygon({0, 0, 4 - x, 1 - y, 4 + bend * y, 1 - bend * x, 4 + x, 1 + y, 5, 3, 1, 4, -1, 2}),
                          rule, 3, Boundary::closed);
    };
    const auto difference = [](const KnotPolygon<double>& a, const KnotPolygon<double>& b) {
      double largest = 0;
      for (std::size_t i = 0; i < a.points.size(); ++i)
        largest = std::max(largest, std::abs(a.points[i] - b.points[i]));
      return largest;
    };
    const KnotPolygon<double> limit = refined(0, 0, 0);
    EXPECT_TRUE(finite(limit));
    for (const auto& [x, y] : {std::pair(1.0, 0.0), std::pair(0.3, -0.8)}) {
      EXPECT_LT(difference(refined(1e-12 * x, 1e-12 * y, 0), limit), 1e-5);
      EXPECT_LT(difference(refined(1e-12 * x, 1e-12 * y, 2), limit), 1e-5);
      EXPECT_GT(difference(refined(0.1 * x, 0.1 * y, 2), limit), 0.01);
    }
    // Five, and a polygon that is one point.
    EXPECT_TRUE(finite(refine_knots(polygon({0, 0, 4, 1, 4, 1, 4, 1, 4, 1, 4, 1, 1, 4}), rule, 4, Boundary::closed)));
    for (const double x : refine_knots(polygon({2, 2, 2, 2, 2, 2, 2, 2}), rule, 3, Boundary::closed).points)
      EXPECT_EQ(x, 2);
  }
}

TEST(Nonuniform, WhatCannotBeUsedIsNamed) {
  const auto refusal = [](KnotPolygon<double> p, Boundary boundary) -> std::string {
    try {
      refine_knots(std::move(p), KnotRule::nuli6, 1, boundary);
    } catch (const Error& e) {
      return e.what();
    }
    return "";
  };
  KnotPolygon<double> p = polygon({0, 0, 1, 0, 1, 1});
  EXPECT_EQ(refusal(p, Boundary::closed), "");
  p.lambda[1] = 1.5;
  EXPECT_NE(refusal(p, Boundary::closed).find("row 2"), std::string::npos);
  p.lambda[1] = 0.5;
  p.d[2] = 0;
  EXPECT_NE(refusal(p, Boundary::closed).find("row 3"), std::string::npos);
  p.d[2] = std::nan("");
  EXPECT_NE(refusal(p, Boundary::closed).find("row 3"), std::string::npos);
  p.closed = false;
  p.d.pop_back();
  p.lambda.pop_back();
  EXPECT_NE(refusal(p, Boundary::space).find("at least 4"), std::string::npos);
  EXPECT_NE(refusal(p, Boundary::given).find("at least 10"), std::string::npos);
}

// The edges are worked on in strips; where they begin must not show.
TEST(Nonuniform, StripsDoNotShow) {
  for (const KnotRule rule : {KnotRule::lagrange4, KnotRule::nuli4, KnotRule::nuli6}) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(0.1, 0.9);
    KnotPolygon<double> p, turned;
    p.dim = turned.dim = 3;
    constexpr std::size_t n = 700, turn = 123;
    for (std::size_t i = 0; i < 3 * n; ++i) p.points.push_back(number(random));
    for (std::size_t i = 0; i < n; ++i) {
      p.d.push_back(number(random));
      p.lambda.push_back(i % 3 == 0 ? number(random) : 0.5);
      p.tagged.push_back(static_cast<unsigned char>(random() % 2));
    }
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t from = (i + turn) % n;
      for (std::size_t c = 0; c < 3; ++c) turned.points.push_back(p.points[3 * from + c]);
      turned.d.push_back(p.d[from]);
      turned.lambda.push_back(p.lambda[from]);
      turned.tagged.push_back(p.tagged[from]);
    }
    KnotRefiner<double> refiner;
    const KnotPolygon<double> a = refine_knots(p, rule, 2, Boundary::closed);
    const KnotPolygon<double>& b = refiner.refine(turned, rule, 2, Boundary::closed);
    ASSERT_EQ(a.size(), 4 * n);
    ASSERT_EQ(b.size(), 4 * n);
    for (std::size_t i = 0; i < 4 * n; ++i) {
      const std::size_t at = (i + 4 * turn) % (4 * n);
      for (std::size_t c = 0; c < 3; ++c) ASSERT_EQ(b.points[3 * i + c], a.points[3 * at + c]);
      ASSERT_EQ(b.d[i], a.d[at]);
      ASSERT_EQ(b.lambda[i], a.lambda[at]);
      ASSERT_EQ(b.tagged[i], a.tagged[at]);
    }
    EXPECT_EQ(refiner.refine(p, rule, 0, Boundary::closed).points, p.points);
    EXPECT_EQ(refiner.refine(p, rule, 2, Boundary::closed).points, a.points);
  }
}

// Some stretches of equal intervals at rest, some vertices with edge parameters.
template <class T>
KnotPolygon<T> mixed_polygon(std::size_t n, std::size_t dim, bool closed) {
  std::mt19937 random(17);
  const auto number = [&] { return T(static_cast<int>(1 + random() % 63)) / T(64); };
  KnotPolygon<T> p;
  p.dim = dim;
  p.closed = closed;
  for (std::size_t i = 0; i < n * dim; ++i) p.points.push_back(number());
  for (std::size_t e = 0; e < (closed ? n : n - 1); ++e) {
    p.d.push_back(e % 11 < 6 && e > 0 ? p.d.back() : number());
    p.lambda.push_back(e % 7 == 0 ? number() : T(1) / T(2));
  }
  for (std::size_t j = 0; j < n; ++j) p.tagged.push_back(static_cast<unsigned char>(random() % 4 == 0));
  return p;
}

template <class T>
void expect_same(const KnotPolygon<T>& a, const KnotPolygon<T>& b) {
  EXPECT_TRUE(a.dim == b.dim && a.closed == b.closed);
  EXPECT_TRUE(a.points == b.points);
  EXPECT_TRUE(a.d == b.d);
  EXPECT_TRUE(a.lambda == b.lambda);
  EXPECT_TRUE(a.tagged == b.tagged);
}

/// A large result is made in pieces, by threads, and written past the caches: the bits are those of step after step.
TEST(Nonuniform, PiecesDoNotShow) {
  struct Case {
    std::size_t n, dim;
    int levels;
  };
  for (const KnotRule rule : rules)
    for (const Boundary boundary : {Boundary::closed, Boundary::given, Boundary::linear, Boundary::space})
      for (const Case& c : {Case{300, 2, 6}, Case{12, 1, 11}, Case{8200, 3, 1}, Case{4000, 2, 8}}) {
        const auto p = mixed_polygon<double>(c.n, c.dim, boundary == Boundary::closed);
        SCOPED_TRACE(testing::Message() << static_cast<int>(rule) << ' ' << static_cast<int>(boundary) << ' ' << c.n);
        KnotPolygon<double> plain = p;
        for (int k = 0; k < c.levels; ++k) plain = refine_knots(plain, rule, boundary);
        KnotRefiner<double> refiner;
        for (const int threads : {1, 0, 2}) {
          refiner.set_threads(threads);
          expect_same(refiner.refine(p, rule, c.levels, boundary), plain);
        }
      }
  EXPECT_THROW(KnotRefiner<double>().set_threads(-1), Error);
}

// Exact numbers that never know that two of them are equal: their rule is never that of equal edges.
struct Unsure {
  Exact value;
  Unsure(int n = 0) : value(n) {}  // NOLINT: numbers convert
  explicit Unsure(Exact x) : value(std::move(x)) {}
  friend Unsure operator+(const Unsure& a, const Unsure& b) { return Unsure(Exact(a.value + b.value)); }
  friend Unsure operator-(const Unsure& a, const Unsure& b) { return Unsure(Exact(a.value - b.value)); }
  friend Unsure operator*(const Unsure& a, const Unsure& b) { return Unsure(Exact(a.value * b.value)); }
  friend Unsure operator/(const Unsure& a, const Unsure& b) { return Unsure(Exact(a.value / b.value)); }
  friend bool operator==(const Unsure& a, const Unsure& b) { return a.value == b.value; }
  friend bool operator<=(const Unsure& a, const Unsure& b) { return a.value <= b.value; }
  friend bool operator>=(const Unsure& a, const Unsure& b) { return a.value >= b.value; }
  friend bool surely_equal(const Unsure&, const Unsure&) { return false; }
};

/// The rule of equal edges is the one that the divided differences give, exactly.
TEST(Nonuniform, EqualEdgesAreNoSpecialCase) {
  for (const KnotRule rule : rules)
    for (const Boundary boundary : {Boundary::closed, Boundary::given, Boundary::linear, Boundary::space}) {
      const KnotPolygon<Exact> a =
          refine_knots(mixed_polygon<Exact>(25, 1, boundary == Boundary::closed), rule, 3, boundary);
      const KnotPolygon<Unsure> b =
          refine_knots(mixed_polygon<Unsure>(25, 1, boundary == Boundary::closed), rule, 3, boundary);
      ASSERT_EQ(a.points.size(), b.points.size());
      for (std::size_t i = 0; i < a.points.size(); ++i) EXPECT_EQ(a.points[i], b.points[i].value) << i;
      for (std::size_t i = 0; i < a.d.size(); ++i) {
        EXPECT_EQ(a.d[i], b.d[i].value);
        EXPECT_EQ(a.lambda[i], b.lambda[i].value);
      }
      EXPECT_EQ(a.tagged, b.tagged);
    }
}

}  // namespace
}  // namespace twoscale::kernels
