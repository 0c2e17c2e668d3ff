// SPDX-License-Identifier: GPL-3.0-or-later
// How a refinement is executed does not show in its bits: tiles, chunks, threads, instruction sets, streams, pieces.
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <bit>
#include <cstdint>
#include <random>

#include "allocations.hpp"
#include "tables.hpp"
#include "twoscale/kernels/refine.hpp"

namespace twoscale::kernels {
namespace {

using testing::allocations;
using testing::four_point;
using testing::row;
using testing::stationary;
using testing::tension;

constexpr Boundary boundaries[] = {Boundary::closed, Boundary::given, Boundary::linear, Boundary::space};

// A number that takes the plain path: one product and one sum at a time, in the order of rounded numbers.
template <class Real>
struct Plain {
  Real x = 0;
  friend bool operator==(Plain, Plain) = default;
  friend Plain operator+(Plain a, Plain b) { return {a.x + b.x}; }
  friend Plain operator*(Plain a, Plain b) {
    volatile Real product = a.x * b.x;
    return {product};
  }
};

}  // namespace

template <class Real>
inline constexpr bool detail::is_rounded<Plain<Real>> = true;

namespace {

template <class Real>
using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;

template <class Real>
void expect_same_bits(std::span<const Real> a, std::span<const Real> b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    ASSERT_EQ(std::bit_cast<Bits<Real>>(a[i]), std::bit_cast<Bits<Real>>(b[i])) << "at " << i;
}

template <class Real>
std::vector<Real> random_points(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<Real> number(-1, 1);
  std::vector<Real> points(count);
  for (Real& x : points) x = number(random);
  return points;
}

// A table whose masks differ in support and have zeros; `extension` weights for Boundary::space.
MaskTable random_table(int arity, int levels, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-0.5, 0.5);
  MaskTable table = stationary(arity, 0, {1, 1, 1, 1, 1}, seed % 2 == 0 ? "0" : "1/2");
  for (int k = 0; k < levels; ++k) {
    std::vector<double> mask(static_cast<std::size_t>(arity) + random() % 14), weights(1 + random() % 4);
    for (double& a : mask) a = random() % 5 == 0 ? 0 : number(random);
    if (random() % 2 == 0) {  // a phase that copies
      for (std::size_t s = 0; s < mask.size(); s += static_cast<std::size_t>(arity)) mask[s] = 0;
      mask[mask.size() / 2 / static_cast<std::size_t>(arity) * static_cast<std::size_t>(arity)] = 1;
    }
    for (double& a : weights) a = number(random);
    table.levels.push_back(row(-static_cast<long>(random() % 9), mask, weights));
  }
  table.limit = table.levels.back();
  return table;
}

// Interpolating masks, mostly of as many symmetric pairs at every level: those whose last steps are taken as one.
MaskTable interpolating_table(int levels, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-0.5, 0.5);
  MaskTable table = stationary(2, 0, {1, 1, 1}, "0");
  const std::size_t pairs = 1 + random() % 5;
  for (int k = 0; k < levels; ++k) {
    const std::size_t here = random() % 9 == 0 ? 1 + random() % 5 : pairs;
    std::vector<double> mask(4 * here - 1, 0.0), weights(1 + random() % 4);
    mask[2 * here - 1] = 1;
    for (std::size_t s = 0; s < here; ++s) mask[2 * s] = mask[mask.size() - 1 - 2 * s] = number(random);
    for (double& a : weights) a = number(random);
    table.levels.push_back(row(1 - 2 * static_cast<long>(here), mask, weights));
  }
  table.limit = table.levels.back();
  return table;
}

template <class Real>
std::vector<Real> plainly(std::span<const Real> points, std::size_t dim, const MaskTable& table, int levels,
                          Boundary boundary) {
  std::vector<Plain<Real>> in;
  for (const Real x : points) in.push_back({x});
  std::vector<Real> out;
  for (const Plain<Real> y :
       refine<Plain<Real>>(in, dim, table, levels, boundary,
                           [](const std::string&, double value) { return Plain<Real>{static_cast<Real>(value)}; }))
    out.push_back(y.x);
  return out;
}

// Small tiles, so that there are many.
detail::Cutting cutting(unsigned seed, bool stream) {
  std::mt19937 random(seed);
  detail::Cutting c;
  c.tile_values = std::size_t{1} << random() % 12;
  c.chunk_values = std::size_t{1} << random() % 11;
  c.together = random() % 6;
  c.columns = 1 + random() % 70;
  c.grain_rows = 1 + random() % 500;
  c.stream = stream;
  return c;
}

class Targets {  // back to all of them at the end of a test
 public:
  explicit Targets(std::int64_t only) { hwy::SetSupportedTargetsForTest(only); }
  ~Targets() { hwy::SetSupportedTargetsForTest(0); }
};

template <class Real>
void compare(unsigned seed, bool interpolating = false) {
  std::mt19937 random(seed);
  const int arity = 2 + static_cast<int>(seed % 3 == 0 && !interpolating ? random() % 4 : 0);
  const int levels = 1 + static_cast<int>(random() % (arity == 2 ? 7U : 4U));
  const MaskTable table = interpolating ? interpolating_table(levels, seed) : random_table(arity, levels, seed);
  const std::size_t dim = seed % 7 == 0 ? 5 + random() % 90 : 1 + random() % 4;
  const std::vector<Real> points = random_points<Real>((30 + random() % 40) * dim, seed);
  for (const Boundary boundary : boundaries) {
    SCOPED_TRACE("seed " + std::to_string(seed) + " boundary " + std::to_string(static_cast<int>(boundary)));
    Refiner<Real> refiner(table);
    const std::size_t count = refiner.output(points.size() / dim, levels, boundary).count * dim;
    if (count > 60000) continue;
    const std::vector<Real> expected = plainly<Real>(points, dim, table, levels, boundary);
    const std::vector<Real> first = refiner.refine(points, dim, levels, boundary);
    expect_same_bits<Real>(first, expected);
    std::vector<Real> room(count + 9);
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
      const Targets only(target);
      for (const bool stream : {false, true}) {
        refiner.set_cutting(cutting(seed + static_cast<unsigned>(target), stream));
        refiner.set_threads(static_cast<int>(1 + random() % 3));
        const std::span<Real> out = std::span<Real>(room).subspan(random() % 9, count);
        refiner.refine(points, dim, levels, boundary, out);
        expect_same_bits<Real>(out, first);
        if (::testing::Test::HasFatalFailure()) return;
      }
    }
  }
}

TEST(Fused, DoublesHaveTheBitsOfThePlainLoop) {
  for (unsigned seed = 0; seed < 60 && !HasFatalFailure(); ++seed) compare<double>(seed);
}

TEST(Fused, InterpolatingStepsHaveTheBitsOfThePlainLoop) {
  for (unsigned seed = 200; seed < 260 && !HasFatalFailure(); ++seed) compare<double>(seed, true);
  for (unsigned seed = 300; seed < 360 && !HasFatalFailure(); ++seed) compare<float>(seed, true);
}

TEST(Fused, FloatsHaveTheBitsOfThePlainLoop) {
  for (unsigned seed = 100; seed < 130 && !HasFatalFailure(); ++seed) compare<float>(seed);
}

TEST(Fused, InterpolatingMasksOfEveryLengthAndDimension) {
  for (long l = 1; l <= 9; ++l) {
    std::vector<double> mask(static_cast<std::size_t>(4 * l - 1), 0.0);
    for (std::size_t s = 0; s < mask.size(); s += 2) mask[s] = 1.0 / static_cast<double>(s + 3);
    mask[static_cast<std::size_t>(2 * l - 1)] = 1;
    const MaskTable table = stationary(2, 1 - 2 * l, mask);
    for (std::size_t dim = 1; dim <= 4; ++dim) {
      const std::vector<double> points = random_points<double>(40 * dim, static_cast<unsigned>(l));
      const std::vector<double> expected = refine(points, dim, table, 5, Boundary::closed);
      expect_same_bits<double>(expected, plainly<double>(points, dim, table, 5, Boundary::closed));
      for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        const Targets only(target);
        Refiner<double> refiner(table);
        refiner.set_cutting(cutting(static_cast<unsigned>(l), dim % 2 == 0));
        expect_same_bits<double>(refiner.refine(points, dim, 5, Boundary::closed), expected);
      }
    }
  }
}

// Rows of many numbers: a grid whose rows are points.
template <class Real>
void compare_wide(long l, std::size_t dim, Boundary boundary) {
  std::vector<double> mask(static_cast<std::size_t>(4 * l - 1), 0.0);
  for (std::size_t s = 0; 2 * s < mask.size(); ++s)
    mask[2 * s] = 1.0 / static_cast<double>(3 + std::min(2 * s, mask.size() - 1 - 2 * s));
  mask[static_cast<std::size_t>(2 * l - 1)] = 1;
  const MaskTable table = stationary(2, 1 - 2 * l, mask, "0", {2.5, -2, 0.5});
  const std::vector<Real> points = random_points<Real>(41 * dim, static_cast<unsigned>(l));
  for (const int levels : {2, 3, 5}) {
    SCOPED_TRACE(std::to_string(l) + " pairs, " + std::to_string(dim) + " numbers, " + std::to_string(levels) +
                 " levels, boundary " + std::to_string(static_cast<int>(boundary)));
    const std::vector<Real> expected = plainly<Real>(points, dim, table, levels, boundary);
    BufferPool pool;
    const Buffer<Real> room = pool.take<Real>(expected.size() + 3);
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
      const Targets only(target);
      for (const std::size_t offset : {std::size_t{0}, std::size_t{3}}) {
        Refiner<Real> refiner(table);
        detail::Cutting c;
        c.tile_values = std::size_t{1} << 14;
        c.grain_rows = 64;
        c.stream = levels != 3;
        refiner.set_cutting(c);
        const std::span<Real> out = room.span().subspan(offset, expected.size());
        std::fill(out.begin(), out.end(), Real(0));
        refiner.refine(points, dim, levels, boundary, out);
        expect_same_bits<Real>(out, expected);
        if (::testing::Test::HasFatalFailure()) return;
      }
    }
  }
}

TEST(Fused, WideRowsHaveTheBitsOfThePlainLoop) {
  for (const Boundary boundary : boundaries)
    for (const std::size_t dim : {std::size_t{32}, std::size_t{71}, std::size_t{128}})
      for (long l = 1; l <= 5 && !HasFatalFailure(); ++l) {
        compare_wide<double>(l, dim, boundary);
        compare_wide<float>(l, dim, boundary);
      }
}

// The order of refine.hpp, written out: of a symmetric phase the points of equal weights are added first.
TEST(Fused, SumsOfSymmetricPhasesRunFromBothEnds) {
  const double a = 0.1, b = -0.3, c = 0.7, d = 0.2, e = 0.45;
  const std::vector<double> x = random_points<double>(41, 3);
  const auto at = [&](long j) { return x[static_cast<std::size_t>((j + 41) % 41)]; };
  std::vector<double> out(82);
  step_closed<double>(Mask<double>{2, -5, {a, d, b, e, c, 0.9, c, e, b, d, a}}, x, 1, out);
  for (long q = 0; q < 41; ++q) {
    const double even = (d * (at(q - 2) + at(q + 2)) + e * (at(q - 1) + at(q + 1))) + 0.9 * at(q);
    const double odd = (a * (at(q - 2) + at(q + 3)) + b * (at(q - 1) + at(q + 2))) + c * (at(q) + at(q + 1));
    EXPECT_EQ(out[static_cast<std::size_t>(2 * q)], even);
    EXPECT_EQ(out[static_cast<std::size_t>(2 * q + 1)], odd);
  }
  step_closed<double>(Mask<double>{2, -1, {a, b, c, d}}, x, 1, out);  // phases without symmetry: points upwards
  for (long q = 0; q < 41; ++q) {
    EXPECT_EQ(out[static_cast<std::size_t>(2 * q)], d * at(q - 1) + b * at(q));
    EXPECT_EQ(out[static_cast<std::size_t>(2 * q + 1)], c * at(q) + a * at(q + 1));
  }
}

TEST(Fused, AWeightThatChangesByOneBitIsSeen) {  // so that the comparisons above can fail
  MaskTable table = tension(0.3, 6);
  const std::vector<double> points = random_points<double>(60, 1);
  const std::vector<double> expected = plainly<double>(points, 2, table, 6, Boundary::closed);
  table.levels[5].value[0] = std::nextafter(table.levels[5].value[0], 1.0);
  EXPECT_NE(refine(points, 2, table, 6, Boundary::closed), expected);
  table = tension(0.3, 6);
  EXPECT_EQ(refine(points, 2, table, 6, Boundary::closed), expected);
}

TEST(Fused, RowsArePartsOfTheWhole) {
  std::mt19937 random(5);
  for (const MaskTable& table : {tension(0.3, 6), random_table(3, 4, 8), random_table(2, 6, 9)}) {
    const int levels = static_cast<int>(table.levels.size());
    const std::vector<double> points = random_points<double>(40 * 3, 3);
    for (const Boundary boundary : boundaries) {
      Refiner<double> refiner(table);
      const std::vector<double> whole = refiner.refine(points, 3, levels, boundary);
      for (int round = 0; round < 20; ++round) {
        const std::size_t first = random() % (whole.size() / 3);
        std::vector<double> part((1 + random() % (whole.size() / 3 - first)) * 3);
        refiner.refine_rows(points, 3, levels, boundary, first, part);
        expect_same_bits<double>(part, std::span<const double>(whole).subspan(first * 3, part.size()));
      }
      std::vector<double> joined;
      refiner.for_each_piece(points, 3, levels, boundary, 1 + random() % 900,
                             [&](std::size_t first_row, std::span<const double> piece) {
                               EXPECT_EQ(first_row * 3, joined.size());
                               joined.insert(joined.end(), piece.begin(), piece.end());
                             });
      expect_same_bits<double>(joined, whole);
      std::vector<double> beyond(6);
      EXPECT_THROW(refiner.refine_rows(points, 3, levels, boundary, whole.size() / 3 - 1, beyond), Error);
    }
  }
}

TEST(Fused, ManyLevelsOfFewPoints) {
  const std::vector<double> triangle = {0, 0, 4, 0, 0, 3};
  Refiner<double> refiner(four_point());
  std::vector<double> some(20);
  refiner.refine_rows(triangle, 2, 30, Boundary::closed, std::size_t{1} << 30, some);
  EXPECT_EQ(some[0], 4.0);  // the vertex 1, kept by an interpolating rule
  EXPECT_EQ(some[1], 0.0);
}

TEST(Fused, ARepeatedCallAllocatesNothing) {
  for (const Boundary boundary : boundaries) {
    const MaskTable table = tension(0.3, 9);
    const std::vector<double> points = random_points<double>(200, 1);
    Refiner<double> refiner(table);
    refiner.set_threads(1);
    std::vector<double> out(refiner.output(100, 9, boundary).count * 2);
    refiner.refine(points, 2, 9, boundary, out);
    const std::size_t before = allocations();
    for (int i = 0; i < 3; ++i) refiner.refine(points, 2, 9, boundary, out);
    EXPECT_EQ(allocations(), before);
    std::vector<double> other(refiner.output(100, 8, boundary).count * 2);
    const std::size_t again = allocations();
    refiner.refine(points, 2, 8, boundary, other);
    EXPECT_GT(allocations(), again);  // the counter counts
  }
}

TEST(Fused, NegativeThreadsAreRefused) {
  Refiner<double> refiner(four_point());
  EXPECT_THROW(refiner.set_threads(-1), Error);
}

}  // namespace
}  // namespace twoscale::kernels
