// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/kernels/refine.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>

#include "tables.hpp"

namespace twoscale::kernels {
namespace {

using testing::chaikin;
using testing::cubic_spline;
using testing::four_point;
using testing::row;
using testing::stationary;
using testing::tension;
using Values = std::vector<double>;

Values sampled(long first, long count, double step, double (*f)(double)) {
  Values out;
  for (long j = first; j < first + count; ++j) out.push_back(f(static_cast<double>(j) * step));
  return out;
}

std::string message_of(const auto& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind, Error::Kind::bad_input);
    return error.what();
  }
  return "no error";
}

// The rule itself: closed, one step, one product and one sum at a time, in the order of refine.hpp.
template <class Real>
std::vector<Real> reference_closed(const Mask<Real>& mask, const std::vector<Real>& in, std::size_t dim) {
  const long m = mask.arity;
  const long n = static_cast<long>(in.size() / dim);
  std::vector<Real> out;
  for (long i = 0; i < m * n; ++i) {
    std::vector<std::pair<Real, std::size_t>> terms;  // coefficient, row
    const long last = i / m + 100;                    // more than any mask here reaches
    for (long j = i / m - 100; j <= last; ++j) {
      const long s = i - m * j - mask.lowest;
      if (s < 0 || s >= static_cast<long>(mask.a.size()) || mask.a[static_cast<std::size_t>(s)] == 0) continue;
      terms.emplace_back(mask.a[static_cast<std::size_t>(s)], static_cast<std::size_t>(((j % n) + n) % n));
    }
    bool symmetric = true;
    for (std::size_t s = 0; s < terms.size(); ++s) symmetric &= terms[s].first == terms[terms.size() - 1 - s].first;
    for (std::size_t c = 0; c < dim; ++c) {
      volatile Real sum = 0;
      for (std::size_t s = 0; s < (symmetric ? (terms.size() + 1) / 2 : terms.size()); ++s) {
        const std::size_t mirror = terms.size() - 1 - s;
        volatile Real point = in[terms[s].second * dim + c];
        if (symmetric && mirror != s) point = point + in[terms[mirror].second * dim + c];
        volatile Real term = terms[s].first * point;
        if (s == 0)
          sum = term;
        else
          sum = sum + term;
      }
      out.push_back(Real(sum));
    }
  }
  return out;
}

template <class Real>
void expect_same_bits(const std::vector<Real>& a, const std::vector<Real>& b) {
  using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(std::bit_cast<Bits>(a[i]), std::bit_cast<Bits>(b[i])) << "at " << i << ": " << a[i] << " and " << b[i];
  }
}

TEST(FloorDiv, RoundsDownAndUpForEverySign) {
  EXPECT_EQ(floor_div(7, 2), 3);
  EXPECT_EQ(floor_div(-7, 2), -4);
  EXPECT_EQ(floor_div(-6, 2), -3);
  EXPECT_EQ(ceil_div(7, 2), 4);
  EXPECT_EQ(ceil_div(-7, 2), -3);
  EXPECT_EQ(ceil_div(6, 3), 2);
}

TEST(Shift, ReadsFractionsAndDecimals) {
  const auto same = [](std::string_view text, long num, long den) {
    const Shift p = parse_shift(text);
    return p.num * den == num * p.den;
  };
  EXPECT_TRUE(same("0", 0, 1));
  EXPECT_TRUE(same("1/2", 1, 2));
  EXPECT_TRUE(same("-3/4", -3, 4));
  EXPECT_TRUE(same("0.25", 1, 4));
  EXPECT_TRUE(same("-1.5", -3, 2));
  for (const char* bad : {"", "-", "1/0", "1/", "/2", "x", "1 /2", ".5", "1.", "--1", "1/-2", "9999999", "+1", "1e3"}) {
    EXPECT_NE(message_of([&] { parse_shift(bad); }).find(quoted(bad)), std::string::npos) << bad;
  }
}

TEST(Refine, CubicSplineOfASquareIsTheKnownAnswer) {
  const Values square = {0, 0, 8, 0, 8, 8, 0, 8};
  const Values expected = {1, 1, 4, 0, 7, 1, 8, 4, 7, 7, 4, 8, 1, 7, 0, 4};
  EXPECT_EQ(refine(square, 2, cubic_spline(), 1, Boundary::closed), expected);
}

TEST(Refine, FourPointOfAClosedImpulse) {
  const Values impulse = {16, 0, 0, 0, 0, 0, 0, 0};
  const Values expected = {16, 9, 0, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 9};
  EXPECT_EQ(refine(impulse, 1, four_point(), 1, Boundary::closed), expected);
}

TEST(Refine, TernaryLinearInterpolation) {
  const MaskTable table = stationary(3, -2, {1. / 3, 2. / 3, 1, 2. / 3, 1. / 3});
  const Values closed = refine(Values{0, 3, 9}, 1, table, 1, Boundary::closed);
  const Values expected = {0, 1, 2, 3, 5, 7, 9, 6, 3};
  ASSERT_EQ(closed.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_DOUBLE_EQ(closed[i], expected[i]);
  EXPECT_EQ(refine(Values{0, 3, 9}, 1, table, 2, Boundary::given).size(), 19u);
}

TEST(Refine, ChaikinCutsCorners) {
  const Values expected = {2, 0, 6, 0, 8, 2, 8, 6, 6, 8, 2, 8, 0, 6, 0, 2};
  // Index 0 of level 1 lies before p_0 (t = 1/4 < 1/2).
  const Values got = refine(Values{0, 0, 8, 0, 8, 8, 0, 8}, 2, chaikin(), 1, Boundary::closed);
  const Values rotated = {got.begin() + 2, got.end()};
  EXPECT_EQ(rotated, Values(expected.begin(), expected.end() - 2));
  EXPECT_EQ(got[0], 0);
  EXPECT_EQ(got[1], 2);
}

TEST(Refine, PolygonsSmallerThanTheStencilWrapSeveralTimes) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const std::size_t n : {3u, 4u, 5u}) {
    Mask<double> mask{2, -9, {}};
    for (int s = 0; s < 19; ++s) mask.a.push_back(number(random));
    Values points;
    for (std::size_t i = 0; i < 2 * n; ++i) points.push_back(number(random));
    expect_same_bits(refine(points, 2, stationary(2, -9, mask.a), 1, Boundary::closed),
                     reference_closed(mask, points, 2));
  }
}

TEST(Refine, ZeroLevelsGiveTheInputWithoutTheGivenEnds) {
  const Values points = {0, 1, 2, 3, 4, 5, 6, 7};
  EXPECT_EQ(refine(points, 1, four_point(), 0, Boundary::closed), points);
  EXPECT_EQ(refine(points, 1, four_point(), 0, Boundary::linear), points);
  EXPECT_EQ(refine(points, 1, four_point(), 0, Boundary::given), (Values{2, 3, 4, 5}));
}

template <class Real>
void compare_with_the_reference(unsigned seed) {
  std::mt19937 random(seed);
  SCOPED_TRACE("seed " + std::to_string(seed));
  const auto integer = [&](long low, long high) { return std::uniform_int_distribution<long>(low, high)(random); };
  std::uniform_real_distribution<Real> number(-1, 1);
  Mask<Real> mask{static_cast<int>(integer(2, 5)), integer(-12, 6), {}};
  const long count = integer(mask.arity, 24);
  for (long s = 0; s < count; ++s) mask.a.push_back(integer(0, 3) == 0 ? Real(integer(0, 1)) : number(random));
  const std::size_t dim = static_cast<std::size_t>(integer(1, 6));
  const std::size_t n = static_cast<std::size_t>(integer(1, 3) == 1 ? integer(1, 8) : integer(1, 1400));
  std::vector<Real> points(n * dim);
  for (Real& x : points) x = integer(0, 9) == 0 ? Real(-0.0) : number(random);
  SCOPED_TRACE("arity " + std::to_string(mask.arity) + " dim " + std::to_string(dim) + " n " + std::to_string(n));
  std::vector<Real> got(points.size() * static_cast<std::size_t>(mask.arity));
  step_closed<Real>(mask, points, dim, got);
  const std::vector<Real> expected = reference_closed(mask, points, dim);
  expect_same_bits(got, expected);
  // Any part of an open step has the same bits as the same part of the whole.
  const IndexRange all = computable(mask.arity, mask.lowest, mask.highest(), {0, n});
  if (all.count == 0) return;
  const long begin = all.first + integer(0, static_cast<long>(all.count) - 1);
  const long end = integer(begin, all.first + static_cast<long>(all.count) - 1) + 1;
  std::vector<Real> part(static_cast<std::size_t>(end - begin) * dim);
  step_open<Real>(mask, points, 0, dim, begin, part);
  const long period = static_cast<long>(n) * mask.arity;
  for (long i = begin; i < end; ++i) {
    for (std::size_t c = 0; c < dim; ++c) {
      const Real want = expected[static_cast<std::size_t>(((i % period) + period) % period) * dim + c];
      ASSERT_EQ(part[static_cast<std::size_t>(i - begin) * dim + c], want);
    }
  }
}

TEST(Refine, DoubleLoopHasTheBitsOfTheReference) {
  for (unsigned seed = 0; seed < 300 && !HasFatalFailure(); ++seed) compare_with_the_reference<double>(seed);
}

TEST(Refine, FloatLoopHasTheBitsOfTheReference) {
  for (unsigned seed = 1000; seed < 1100 && !HasFatalFailure(); ++seed) compare_with_the_reference<float>(seed);
}

TEST(Refine, SeveralLevelsAreSeveralSteps) {
  const MaskTable table = tension(-0.3, 5);
  Values points = {0, 0, 1, 0, 2, 1, 1, 3, 0, 2};
  const Values got = refine(points, 2, table, 5, Boundary::closed);
  for (const MaskRow& level : table.levels)
    points = reference_closed(Mask<double>{2, level.lowest, level.value}, points, 2);
  expect_same_bits(got, points);
}

TEST(EndPoints, AreThoseOfTheContract) {
  for (long h = 1; h <= 21; ++h) {
    const EndPoints ends = points_beyond_ends(2, -h, h, {});
    EXPECT_EQ(ends.left, h - 1);
    EXPECT_EQ(ends.right, h - 1);
  }
  // Dual rules: the same on both sides, |offset| < r/(m-1) with r the half-length.
  for (long half = 1; half <= 8; ++half) {
    const EndPoints ends = points_beyond_ends(2, 1 - half, half, {1, 2});
    EXPECT_EQ(ends.left, half - 1);
    EXPECT_EQ(ends.right, half - 1);
  }
  const EndPoints ternary = points_beyond_ends(3, -5, 5, {});
  EXPECT_EQ(ternary.left, 2);
  EXPECT_EQ(ternary.right, 2);
}

TEST(Open, GivenPointsReproduceCubics) {
  const auto cube = [](double x) { return x * x * x - 2 * x; };
  const Values fine = refine(sampled(-2, 9, 1, cube), 1, four_point(), 4, Boundary::given);
  const Values expected = sampled(0, 4 * 16 + 1, 1. / 16, cube);
  ASSERT_EQ(fine.size(), expected.size());
  for (std::size_t i = 0; i < fine.size(); ++i) EXPECT_NEAR(fine[i], expected[i], 1e-12) << i;
}

TEST(Open, GivenAgreesWithTheClosedPolygon) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const MaskTable& table : {four_point(), cubic_spline(), chaikin(), stationary(3, -2, {.2, .3, 1, .4, .1}),
                                 stationary(2, 0, {.5, 1, .5}, "0"), stationary(2, 1, {.5, 1, .5}, "-1/3")}) {
    Refiner<double> refiner(table);
    Values points(60);
    for (double& x : points) x = number(random);
    const std::size_t left = static_cast<std::size_t>(refiner.ends().left);
    const std::size_t right = static_cast<std::size_t>(refiner.ends().right);
    for (int levels = 1; levels <= 4; ++levels) {
      const long factor = std::lround(std::pow(table.arity, levels));
      const Values closed = refiner.refine(points, 1, levels, Boundary::closed);
      const Values open = refiner.refine(points, 1, levels, Boundary::given);
      const IndexRange range = refiner.output(points.size(), levels, Boundary::given);
      ASSERT_EQ(open.size(), range.count);
      for (std::size_t i = 0; i < open.size(); ++i) {
        const long index = range.first + static_cast<long>(i) + static_cast<long>(left) * factor;
        ASSERT_EQ(open[i], closed[static_cast<std::size_t>(index)]) << "levels " << levels << " at " << i;
      }
      // The interval: p <= (i + p)/m^K <= N - 1 + p, and no point of it is missing.
      const Shift p = parse_shift(table.shift);
      const long last = range.first + static_cast<long>(range.count) - 1;
      const long n = 60 - static_cast<long>(left + right);
      EXPECT_GE(range.first * p.den + p.num, p.num * factor);
      EXPECT_LT((range.first - 1) * p.den + p.num, p.num * factor);
      EXPECT_LE(last * p.den + p.num, ((n - 1) * p.den + p.num) * factor);
      EXPECT_GT((last + 1) * p.den + p.num, ((n - 1) * p.den + p.num) * factor);
    }
  }
}

TEST(Open, LinearEndIsRule10OfBeccari2007) {
  const MaskTable table = tension(2.5, 3);
  const Values points = {1, 0, 3, 2, 4, 7, 2, 9, 0, 5};
  Values level = points;
  for (int k = 0; k < 3; ++k) {
    const double w = -table.levels[static_cast<std::size_t>(k)].value[0];
    const Values next = refine(points, 2, table, k + 1, Boundary::linear);
    const std::size_t n = level.size() / 2;
    ASSERT_EQ(next.size() / 2, 2 * n - 1);
    for (std::size_t c = 0; c < 2; ++c) {
      const auto p = [&](std::size_t j) { return level[2 * j + c]; };
      EXPECT_NEAR(next[2 + c], (.5 - w) * p(0) + (.5 + 2 * w) * p(1) - w * p(2), 1e-14);
      const std::size_t last = next.size() / 2 - 2;
      EXPECT_NEAR(next[2 * last + c], (.5 - w) * p(n - 1) + (.5 + 2 * w) * p(n - 2) - w * p(n - 3), 1e-14);
      EXPECT_EQ(next[c], points[c]);
    }
    level = next;
  }
}

TEST(Open, SpaceReproducesCubics) {
  const auto cube = [](double x) { return x * x * x - x * x + 3; };
  const Values fine = refine(sampled(0, 5, 1, cube), 1, four_point(), 4, Boundary::space);
  const Values expected = sampled(0, 4 * 16 + 1, 1. / 16, cube);
  ASSERT_EQ(fine.size(), expected.size());
  for (std::size_t i = 0; i < fine.size(); ++i) EXPECT_NEAR(fine[i], expected[i], 1e-11) << i;
}

TEST(Open, TensionReproducesItsSpaceByGivenAndBySpace) {
  const double s = 0.7;
  Values points;
  for (int j = -2; j < 8; ++j) {
    points.push_back(std::cos(s * j) + 0.25 * j);
    points.push_back(std::sin(s * j) - 1);
  }
  const MaskTable table = tension(std::cos(s), 5);
  const Values inner(points.begin() + 4, points.end() - 4);
  for (const Boundary boundary : {Boundary::given, Boundary::space}) {
    const Values fine = refine(boundary == Boundary::given ? points : inner, 2, table, 5, boundary);
    ASSERT_EQ(fine.size(), 2u * (5 * 32 + 1));
    for (int i = 0; i <= 5 * 32; ++i) {
      const double x = i / 32.;
      EXPECT_NEAR(fine[static_cast<std::size_t>(2 * i)], std::cos(s * x) + 0.25 * x, 1e-12);
      EXPECT_NEAR(fine[static_cast<std::size_t>(2 * i + 1)], std::sin(s * x) - 1, 1e-12);
    }
  }
}

TEST(Open, TooFewPointsNameHowManyAreNeeded) {
  const MaskTable table = four_point();
  const auto refined = [&](std::size_t n, Boundary boundary) {
    return [&table, n, boundary] { refine(Values(n), 1, table, 2, boundary); };
  };
  EXPECT_EQ(message_of(refined(2, Boundary::closed)), "a closed polygon needs at least 3 points here, not 2");
  EXPECT_EQ(
      message_of(refined(5, Boundary::given)),
      "an open polygon with given points beyond its ends needs at least 6 points here, not 5 (2 before and 2 after "
      "the curve)");
  EXPECT_NE(message_of(refined(1, Boundary::linear)).find("at least 2 points"), std::string::npos);
  EXPECT_NE(message_of(refined(3, Boundary::space)).find("at least 4 points"), std::string::npos);
  EXPECT_NE(message_of(refined(0, Boundary::closed)).find("at least 3 points"), std::string::npos);
  EXPECT_NE(message_of([] { refine(Values(9), 1, cubic_spline(), 1, Boundary::space); }).find("extension weights"),
            std::string::npos);
}

TEST(Refiner, RefusesWhatItCannotDo) {
  const Values points(12);
  EXPECT_NE(message_of([&] { refine(points, 0, four_point(), 1, Boundary::closed); }).find("components"),
            std::string::npos);
  EXPECT_NE(message_of([&] { refine(points, 5, four_point(), 1, Boundary::closed); }).find("components"),
            std::string::npos);
  EXPECT_NE(message_of([&] { refine(points, 1, four_point(), -1, Boundary::closed); }).find("-1"), std::string::npos);
  EXPECT_NE(message_of([&] { refine(points, 1, four_point(), 60, Boundary::closed); }).find("60 times"),
            std::string::npos);
  EXPECT_NE(message_of([&] { refine(points, 1, tension(0.5, 3), 4, Boundary::closed); }).find("the mask table has 3"),
            std::string::npos);
  Values out(7);
  Refiner<double> refiner(four_point());
  EXPECT_NE(message_of([&] { refiner.refine(points, 1, 1, Boundary::closed, out); }).find("instead of 24"),
            std::string::npos);
  MaskTable broken = four_point();
  broken.arity = 1;
  EXPECT_NE(message_of([&] { Refiner<double>{broken}; }).find("arity 1"), std::string::npos);
  broken = four_point();
  broken.limit.value[2] = NAN;
  EXPECT_NE(message_of([&] { Refiner<double>{broken}; }).find("not finite"), std::string::npos);
  broken = four_point();
  broken.limit.text[2] = "1/2";
  EXPECT_NE(message_of([&] { Refiner<double>{broken}; }).find("'1/2'"), std::string::npos);
  EXPECT_NE(message_of([&] { parse_boundary("free"); }).find("'free'"), std::string::npos);
  EXPECT_EQ(parse_boundary("space"), Boundary::space);
}

TEST(Refiner, ItsBuffersCarryNothingOver) {
  Refiner<double> refiner(four_point());
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int round = 0; round < 40; ++round) {
    const std::size_t dim = 1 + random() % 4;
    Values points((8 + random() % 30) * dim);
    for (double& x : points) x = number(random);
    const int levels = static_cast<int>(random() % 5);
    const Boundary boundary = static_cast<Boundary>(random() % 4);
    expect_same_bits(refiner.refine(points, dim, levels, boundary),
                     refine(points, dim, four_point(), levels, boundary));
  }
}

// A double that takes the plain path.
struct Plain {
  double x = 0;
  friend Plain operator+(Plain a, Plain b) { return {a.x + b.x}; }
  friend Plain operator*(Plain a, Plain b) {
    volatile double product = a.x * b.x;
    return {product};
  }
};

// Tiles, streams and all: outputs of every size, every boundary, level-dependent masks of different supports.
TEST(Refiner, TilesHaveTheValuesOfThePlainPath) {
  for (unsigned seed = 0; seed < 120; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const auto integer = [&](long low, long high) { return std::uniform_int_distribution<long>(low, high)(random); };
    std::uniform_real_distribution<double> number(-1, 1);
    const int arity = static_cast<int>(integer(2, 4));
    MaskTable table = stationary(arity, 0, {1, 1, 1, 1}, std::vector<std::string>{"0", "1/2", "-1/3"}[seed % 3]);
    const int levels = static_cast<int>(integer(1, arity == 2 ? 10 : 6));
    for (int k = 0; k < levels; ++k) {
      Values mask(static_cast<std::size_t>(integer(arity, 13)));
      for (double& a : mask) a = number(random) / 2;
      Values weights(static_cast<std::size_t>(integer(1, 4)));
      for (double& a : weights) a = number(random);
      table.levels.push_back(row(integer(-8, 2), mask, weights));
    }
    table.limit = table.levels.back();
    const std::size_t dim = static_cast<std::size_t>(integer(1, 5));
    Values points(static_cast<std::size_t>(integer(24, 60)) * dim);
    std::vector<Plain> plain;
    for (double& x : points) plain.push_back({x = number(random)});
    Refiner<double> refiner(table);
    for (const Boundary boundary : {Boundary::closed, Boundary::given, Boundary::linear, Boundary::space}) {
      const std::size_t count = refiner.output(points.size() / dim, levels, boundary).count;
      if (count * dim > 150000) continue;
      const Values fast = refiner.refine(points, dim, levels, boundary);
      const std::vector<Plain> slow = refine<Plain>(plain, dim, table, levels, boundary,
                                                    [](const std::string&, double value) { return Plain{value}; });
      ASSERT_EQ(fast.size(), slow.size());
      for (std::size_t i = 0; i < fast.size(); ++i) {
        ASSERT_EQ(fast[i], slow[i].x) << "boundary " << static_cast<int>(boundary) << " at " << i;
      }
    }
  }
}

TEST(Refiner, StreamedOutputHasTheSameBits) {
  Values points(3 * 700);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-1, 1);
  for (double& x : points) x = number(random);
  const MaskTable table = tension(0.25, 9);
  Values expected = refine(points, 3, table, 8, Boundary::closed);
  expected = reference_closed(Mask<double>{2, -3, table.levels[8].value}, expected, 3);
  Values room(expected.size() + 8);
  detail::Cutting streamed;
  streamed.stream = true;
  for (std::size_t shift = 0; shift < 8; ++shift) {  // aligned to lines and to pairs, and not
    const std::span<double> out(room.data() + shift, expected.size());
    Refiner<double> refiner(table);
    refiner.set_cutting(streamed);
    refiner.refine(points, 3, 9, Boundary::closed, out);
    expect_same_bits(Values(out.begin(), out.end()), expected);
  }
}

// A number type with + and * alone, no default constructor, no comparison.
class Fraction {
 public:
  Fraction(long long num, long long den) : num_(num / std::gcd(num, den)), den_(den / std::gcd(num, den)) {}
  friend Fraction operator+(const Fraction& a, const Fraction& b) {
    return {a.num_ * b.den_ + b.num_ * a.den_, a.den_ * b.den_};
  }
  friend Fraction operator*(const Fraction& a, const Fraction& b) { return {a.num_ * b.num_, a.den_ * b.den_}; }
  long long num() const { return num_; }
  long long den() const { return den_; }

 private:
  long long num_, den_;
};

TEST(Refine, WorksOverAnyNumberType) {
  const auto exact = [](const std::string&, double value) {
    return Fraction(static_cast<long long>(value * 1024), 1024);
  };
  const MaskTable table = four_point();
  std::vector<Fraction> points;
  Values doubles;
  for (int j = 0; j < 20; ++j) {
    points.emplace_back(j * j % 7, 1);
    doubles.push_back(j * j % 7);
  }
  for (const Boundary boundary : {Boundary::closed, Boundary::given, Boundary::linear, Boundary::space}) {
    const std::vector<Fraction> fine = refine<Fraction>(points, 2, table, 3, boundary, exact);
    const Values expected = refine(doubles, 2, table, 3, boundary);  // exact too: few bits
    ASSERT_EQ(fine.size(), expected.size());
    for (std::size_t i = 0; i < fine.size(); ++i) {
      EXPECT_EQ(static_cast<double>(fine[i].num()) / static_cast<double>(fine[i].den()), expected[i]);
    }
  }
  Refiner<long double> extended(table);
  EXPECT_EQ(extended.refine(std::vector<long double>{0, 0, 16, 0}, 1, 1, Boundary::closed)[3], 9.0L);
}

}  // namespace
}  // namespace twoscale::kernels
