// SPDX-License-Identifier: GPL-3.0-or-later
// Tensor products: rows then columns, order, exact surfaces, every boundary and arity.
#include "twoscale/kernels/surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tables.hpp"

namespace twoscale::kernels {
namespace {

using testing::chaikin;
using testing::cubic_spline;
using testing::four_point;
using testing::tension;

MaskTable ternary() {
  return testing::stationary(3, -2, {1. / 3, 2. / 3, 1, 2. / 3, 1. / 3});  // degree 1
}

std::vector<double> random_grid(GridSize size, std::size_t dim, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<double> grid;
  for (std::size_t i = 0; i < size.rows * size.columns * dim; ++i) {
    grid.push_back(static_cast<double>(static_cast<int>(random() % 2001) - 1000) / 1024);
  }
  return grid;
}

std::vector<double> transposed(const std::vector<double>& grid, GridSize size, std::size_t dim) {
  std::vector<double> out(grid.size());
  for (std::size_t i = 0; i < size.rows; ++i) {
    for (std::size_t j = 0; j < size.columns; ++j) {
      for (std::size_t c = 0; c < dim; ++c) out[(j * size.rows + i) * dim + c] = grid[(i * size.columns + j) * dim + c];
    }
  }
  return out;
}

// Every row alone, then every column alone.
std::vector<double> one_by_one(const std::vector<double>& grid, GridSize size, std::size_t dim, const MaskTable& u,
                               DirectionRun u_run, const MaskTable& v, DirectionRun v_run) {
  const auto rows = [&](const std::vector<double>& in, std::size_t count, const MaskTable& table, DirectionRun run) {
    std::vector<double> out;
    const std::size_t length = in.size() / count;
    for (std::size_t i = 0; i < count; ++i) {
      const auto fine = refine(std::span(in).subspan(i * length, length), dim, table, run.levels, run.boundary);
      out.insert(out.end(), fine.begin(), fine.end());
    }
    return out;
  };
  const auto along_v = rows(grid, size.rows, v, v_run);
  const std::size_t columns = along_v.size() / size.rows / dim;
  const auto along_u = rows(transposed(along_v, {size.rows, columns}, dim), columns, u, u_run);
  return transposed(along_u, {columns, along_u.size() / columns / dim}, dim);
}

TEST(Surface, IsRowsThenColumnsBitForBit) {
  struct Case {
    MaskTable u, v;
    DirectionRun u_run, v_run;
    GridSize size;
    std::size_t dim;
  };
  const std::vector<Case> cases = {
      {four_point(), cubic_spline(), {3, Boundary::closed}, {2, Boundary::closed}, {5, 4}, 3},
      {four_point(), chaikin(), {2, Boundary::given}, {3, Boundary::given}, {9, 7}, 3},
      {tension(.5, 4), four_point(), {4, Boundary::linear}, {1, Boundary::space}, {6, 8}, 2},
      {ternary(), four_point(), {2, Boundary::closed}, {3, Boundary::closed}, {3, 5}, 1},
      {chaikin(), ternary(), {0, Boundary::closed}, {1, Boundary::linear}, {3, 2}, 4},
      {four_point(), tension(2, 5), {5, Boundary::closed}, {5, Boundary::closed}, {16, 12}, 3},  // in tiles
  };
  for (const Case& c : cases) {
    const auto grid = random_grid(c.size, c.dim, 3);
    const auto expected = one_by_one(grid, c.size, c.dim, c.u, c.u_run, c.v, c.v_run);
    EXPECT_EQ(refine_grid(grid, c.size, c.dim, c.u, c.u_run, c.v, c.v_run), expected);
    SurfaceRefiner<double> refiner{Refiner<double>(c.u), Refiner<double>(c.v)};
    const GridRange range = refiner.output(c.size, c.u_run, c.v_run);
    EXPECT_EQ(range.rows.count * range.columns.count * c.dim, expected.size());
    std::vector<double> out(expected.size(), -1);
    for (int twice = 0; twice < 2; ++twice) refiner.refine(grid, c.size, c.dim, c.u_run, c.v_run, out);
    EXPECT_EQ(out, expected);
  }
}

// Integers that are large enough: masks times powers of two.
struct Whole {
  long long x = 0;
  friend Whole operator+(Whole a, Whole b) { return {a.x + b.x}; }
  friend Whole operator*(Whole a, Whole b) { return {a.x * b.x}; }
  friend bool operator==(const Whole&, const Whole&) = default;
};

TEST(Surface, TheOtherOrderIsTheSameInExactArithmetic) {
  const MaskTable u = four_point(), v = cubic_spline();
  const auto whole = [](const std::string&, double value) { return Whole{std::llround(16 * value)}; };
  const GridSize size{5, 4};
  std::mt19937 random(8);
  std::vector<Whole> grid(size.rows * size.columns), turned(grid.size());
  for (std::size_t i = 0; i < size.rows; ++i) {
    for (std::size_t j = 0; j < size.columns; ++j) {
      grid[i * size.columns + j].x = static_cast<long long>(random() % 2001) - 1000;
      turned[j * size.rows + i] = grid[i * size.columns + j];
    }
  }
  const DirectionRun run{3, Boundary::closed};
  const auto a =
      SurfaceRefiner<Whole>(Refiner<Whole>(u, whole), Refiner<Whole>(v, whole)).refine(grid, size, 1, run, run);
  const auto b =
      SurfaceRefiner<Whole>(Refiner<Whole>(v, whole), Refiner<Whole>(u, whole)).refine(turned, {4, 5}, 1, run, run);
  for (std::size_t i = 0; i < 40; ++i) {
    for (std::size_t j = 0; j < 32; ++j) ASSERT_EQ(a[i * 32 + j], b[j * 40 + i]);
  }
}

TEST(Surface, TorusAtRounding) {
  const std::size_t rows = 8, columns = 6;
  const int levels = 4;
  const auto point = [&](double i, double j, double* p) {
    const double u = 2 * std::numbers::pi * i / rows, v = 2 * std::numbers::pi * j / columns;
    p[0] = (3 + std::cos(v)) * std::cos(u);
    p[1] = (3 + std::cos(v)) * std::sin(u);
    p[2] = std::sin(v);
  };
  std::vector<double> grid(rows * columns * 3);
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) point(double(i), double(j), &grid[(i * columns + j) * 3]);
  }
  const DirectionRun run{levels, Boundary::closed};
  const auto fine =
      refine_grid(grid, {rows, columns}, 3, tension(std::sqrt(.5), levels), run, tension(.5, levels), run);
  const std::size_t fine_columns = columns << levels;
  double worst = 0;
  for (std::size_t i = 0; i < rows << levels; ++i) {
    for (std::size_t j = 0; j < fine_columns; ++j) {
      double p[3];
      point(double(i) / (1 << levels), double(j) / (1 << levels), p);
      for (std::size_t c = 0; c < 3; ++c)
        worst = std::max(worst, std::abs(p[c] - fine[(i * fine_columns + j) * 3 + c]));
    }
  }
  EXPECT_LT(worst, 1e-13);
  // The schemes exchanged do not return it.
  const auto other =
      refine_grid(grid, {rows, columns}, 3, tension(.5, levels), run, tension(std::sqrt(.5), levels), run);
  double p[3];
  point(.5, .5, p);
  const std::size_t half = std::size_t{1} << (levels - 1);
  EXPECT_GT(std::abs(other[(half * fine_columns + half) * 3] - p[0]), 1e-2);
}

TEST(Surface, OfAProductIsTheProductOfCurves) {
  // f(i) g(j) with dyadic numbers: bit-identical even, because every product is exact.
  const std::vector<double> f = {1, -2, 3, .5, 2}, g = {2, 1, -1, 4};
  std::vector<double> grid;
  for (const double x : f) {
    for (const double y : g) grid.push_back(x * y);
  }
  const auto fine =
      refine_grid(grid, {5, 4}, 1, cubic_spline(), {3, Boundary::closed}, chaikin(), {2, Boundary::closed});
  const auto fu = refine(f, 1, cubic_spline(), 3, Boundary::closed), gv = refine(g, 1, chaikin(), 2, Boundary::closed);
  for (std::size_t i = 0; i < fu.size(); ++i) {
    for (std::size_t j = 0; j < gv.size(); ++j) EXPECT_EQ(fine[i * gv.size() + j], fu[i] * gv[j]);
  }
}

TEST(Surface, RefusesWhatIsNoGrid) {
  const std::vector<double> grid(24, 1.0);
  const DirectionRun run{1, Boundary::closed};
  const auto message = [&](GridSize size, std::size_t dim, DirectionRun u) -> std::string {
    try {
      refine_grid(grid, size, dim, four_point(), u, four_point(), run);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message({3, 8}, 1, run), "");
  EXPECT_NE(message({3, 7}, 1, run).find("3 x 7"), std::string::npos);
  EXPECT_NE(message({0, 8}, 1, run), "");
  EXPECT_NE(message({3, 8}, 0, run), "");
  EXPECT_NE(message({2, 12}, 1, run), "");                     // two rows do not close
  EXPECT_NE(message({3, 8}, 1, {1, Boundary::given}), "");     // too few for the ends
  EXPECT_NE(message({3, std::size_t{1} << 63}, 16, run), "");  // sizes that overflow
}

}  // namespace
}  // namespace twoscale::kernels
