// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the checker: do regions of edge parameters cover the square? Against membership of points, over random
// regions, and against regions left out and made smaller.
#include "twoscale/check/covering.hpp"

#include <gtest/gtest.h>
#include <random>

#include "twoscale/check/positivity.hpp"

namespace twoscale::check {
namespace {

using Shape = Region::Shape;

Region rectangle(Fraction a, Fraction b, Fraction c, Fraction d) { return {Shape::rectangle, a, b, c, d}; }
Region triangle(Shape shape, Fraction size) { return {shape, {0, 1}, size, {0, 1}, size}; }

Covering covering(const std::vector<Region>& regions, std::string& hole) {
  Meter meter;
  return covering_of(regions, hole, meter);
}

bool at_most(const Fraction& a, const Fraction& b) {
  return a.numerator * b.denominator <= b.numerator * a.denominator;
}
bool within(const Region& r, const Fraction& k, const Fraction& q) {
  if (!at_most(r.k_low, k) || !at_most(k, r.k_high) || !at_most(r.q_low, q) || !at_most(q, r.q_high)) return false;
  if (r.shape == Shape::rectangle) return true;
  const bool tip = k.numerator == 0 && q.numerator == 0;
  return !tip && (r.shape == Shape::below ? at_most(q, k) : at_most(k, q));
}
bool within(const std::vector<Region>& regions, const Fraction& k, const Fraction& q) {
  return std::any_of(regions.begin(), regions.end(), [&](const Region& r) { return within(r, k, q); });
}

// The regions of a proof: three squares and two triangles.
std::vector<Region> proof() {
  const Fraction o{0, 1}, h{1, 2}, e{1, 1};
  return {rectangle(h, e, o, h), rectangle(h, e, h, e), rectangle(o, h, h, e), triangle(Shape::below, h),
          triangle(Shape::above, h)};
}

TEST(Covering, OfAProofNeedsAllItsRegions) {
  std::string hole;
  EXPECT_EQ(covering(proof(), hole), Covering::all_but_crease);
  std::vector<Region> with_crease = proof();
  with_crease.push_back(rectangle({0, 1}, {0, 1}, {0, 1}, {0, 1}));
  EXPECT_EQ(covering(with_crease, hole), Covering::all);
  EXPECT_EQ(covering({}, hole), Covering::none);
  EXPECT_EQ(covering({rectangle({0, 1}, {1, 1}, {0, 1}, {1, 1})}, hole), Covering::all);
  for (std::size_t i = 0; i < proof().size(); ++i) {
    std::vector<Region> fewer = proof();
    fewer.erase(fewer.begin() + static_cast<long>(i));
    EXPECT_EQ(covering(fewer, hole), Covering::none) << i;
    for (Fraction Region::*end : {&Region::k_low, &Region::k_high, &Region::q_low, &Region::q_high}) {
      std::vector<Region> smaller = proof();
      Region& r = smaller[i];
      const bool low = end == &Region::k_low || end == &Region::q_low;
      if (r.shape != Shape::rectangle && low) continue;
      Fraction& x = r.*end;
      x = low ? Fraction{x.numerator * 100 + x.denominator, x.denominator * 100}
              : Fraction{x.numerator * 100 - x.denominator, x.denominator * 100};
      if (r.shape != Shape::rectangle) r.k_high = r.q_high = x;
      EXPECT_EQ(covering(smaller, hole), Covering::none) << i;
    }
  }
}

TEST(Covering, AgreesWithPoints) {
  std::mt19937 source(5);
  const auto number = [&](int most) { return static_cast<long>(source() % static_cast<unsigned>(most + 1)); };
  int covered = 0, holes = 0;
  for (int round = 0; round < 3000; ++round) {
    std::vector<Region> regions;
    for (long i = number(7); i >= 0; --i) {
      if (number(3) == 0) {
        regions.push_back(triangle(number(1) == 0 ? Shape::below : Shape::above, {number(3) + 1, 4}));
        continue;
      }
      const long a = number(2), c = number(2);
      regions.push_back(rectangle({a, 4}, {a + 2 + number(2), 4}, {c, 4}, {c + 2 + number(2), 4}));
    }
    std::string hole;
    const Covering answer = covering(regions, hole);
    bool all = true;
    for (long k = 0; k <= 12; ++k)
      for (long q = 0; q <= 12; ++q)
        if (k + q > 0) all = all && within(regions, {k, 12}, {q, 12});
    ASSERT_EQ(answer != Covering::none, all) << round;
    ASSERT_EQ(answer == Covering::all, all && within(regions, {0, 1}, {0, 1})) << round;
    if (answer != Covering::none) {
      ++covered;
      continue;
    }
    // The hole is one.
    ++holes;
    Meter meter;
    const std::size_t comma = hole.find(',');
    const Fraction k = parse_fraction(hole.substr(11, comma - 11), "k", meter);
    const Fraction q = parse_fraction(hole.substr(comma + 10), "q", meter);
    ASSERT_FALSE(within(regions, k, q)) << hole;
  }
  EXPECT_GT(covered, 50);
  EXPECT_GT(holes, 50);
}

TEST(Covering, WhichBoxesCount) {
  Meter meter;
  const std::vector<std::string> names{"a", "k", "s"};  // a: the ratio
  Box box{names,
          {{{0, 1}, std::nullopt, true, false}, {{0, 1}, Fraction{1, 2}, false, false}, {{0, 1}, Fraction{1, 1}}}};
  const auto region = [&](const char* left, const char* right) {
    return region_of(parse_polynomial(left, names, "left", meter), parse_polynomial(right, names, "right", meter), 0,
                     box.sides, meter);
  };
  ASSERT_TRUE(region("-k+1", "s"));
  EXPECT_EQ(region("-k+1", "s")->shape, Shape::rectangle);
  ASSERT_TRUE(region("-k+1", "k*s"));
  EXPECT_EQ(region("-k+1", "k*s")->shape, Shape::below);
  ASSERT_TRUE(region("-k*s+1", "k"));
  EXPECT_EQ(region("-k*s+1", "k")->shape, Shape::above);
  ASSERT_TRUE(region("k", "1"));  // from 0 to 1/2: k of the region from 1/2 to 1
  EXPECT_EQ(region("k", "1")->k_low.denominator, 2);
  for (const auto& [left, right] : {std::pair("k", "k"), std::pair("a", "k"), std::pair("-k+1", "a*k"),
                                    std::pair("-k+1", "k*s+k"), std::pair("-k+1", "k^2"), std::pair("-2*k+1", "k*s")})
    EXPECT_FALSE(region(left, right)) << left << " " << right;
  // Faces that are left out, s not up to 1, k not from 0.
  box.sides[1].zero_low = true;
  EXPECT_FALSE(region("-k+1", "s"));
  EXPECT_TRUE(region("-k+1", "k*s"));
  box.sides[1].zero_high = true;
  EXPECT_FALSE(region("-k+1", "k*s"));
  box.sides[1] = {{1, 4}, Fraction{1, 2}, false, false};
  EXPECT_FALSE(region("-k+1", "k*s"));
  box.sides[1] = {{0, 1}, Fraction{1, 2}, true, false};
  box.sides[2].high = Fraction{3, 4};
  EXPECT_FALSE(region("-k+1", "k*s"));
  EXPECT_TRUE(all_ratios(box.sides[0]));
  EXPECT_FALSE(all_ratios(box.sides[1]));
}

}  // namespace
}  // namespace twoscale::check
