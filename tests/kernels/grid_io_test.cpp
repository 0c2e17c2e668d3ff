// SPDX-License-Identifier: GPL-3.0-or-later
// Grid files: what is written is read back, with its size; other meshes are refused; any bytes are read or refused.
#include "twoscale/kernels/grid_io.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "support/mutate.hpp"
#include "twoscale/kernels/error.hpp"

namespace twoscale::kernels {
namespace {

PointGrid grid(GridSize size, std::size_t dim) {
  PointGrid g;
  g.size = size;
  g.points.dim = dim;
  g.points.columns = default_columns(dim);
  for (std::size_t i = 0; i < size.rows * size.columns * dim; ++i) g.points.values.push_back(0.25 * double(i) - 3);
  return g;
}

std::string message_of(const std::function<void()>& f) {
  try {
    f();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind, Error::Kind::bad_input);
    return error.what();
  }
  return "";
}

PointGrid read(const std::string& bytes, PointFormat format) {
  PointFile file = parse_point_file(bytes, format, "g");
  EXPECT_TRUE(std::holds_alternative<PointGrid>(file));
  return std::get<PointGrid>(std::move(file));
}

TEST(Grids, WhatIsWrittenIsReadBack) {
  for (const GridSize size : {GridSize{2, 2}, {3, 3}, {4, 3}, {3, 4}, {2, 9}, {6, 8}, {12, 4}}) {
    for (const Closings closings : {Closings{}, {true, false}, {false, true}, {true, true}}) {
      if ((closings.u && size.rows < 3) || (closings.v && size.columns < 3)) continue;
      const PointGrid g = grid(size, 3);
      const PointGrid obj = read(grid_to_bytes(g, PointFormat::obj, closings), PointFormat::obj);
      EXPECT_EQ(obj.size, size);
      EXPECT_EQ(obj.closings, closings);
      EXPECT_EQ(obj.points.values, g.points.values);
    }
    for (const std::size_t dim : {1U, 2U, 3U, 5U}) {
      const PointGrid g = grid(size, dim);
      for (const PointFormat format : {PointFormat::csv, PointFormat::npy}) {
        const PointGrid back = read(grid_to_bytes(g, format, {}), format);
        EXPECT_EQ(back.size, size);
        EXPECT_EQ(back.points.values, g.points.values);
        EXPECT_EQ(back.points.dim, dim);
        EXPECT_FALSE(back.closings);
      }
    }
  }
}

TEST(Grids, MeshesOfOtherPrograms) {
  // Faces in another order, turned, mirrored, with normals and negative numbers.
  const std::string vertices = "o sheet\nv 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nvn 0 0 1\n";
  const PointGrid g = read(vertices + "f -1//1 -4//1 -5//1 -2//1\nf 2/1/1 1/1/1 4/1/1 5/1/1\n", PointFormat::obj);
  EXPECT_EQ(g.size, (GridSize{2, 3}));
  EXPECT_EQ(g.closings, Closings{});
  const auto refused = [](const std::string& text) {
    return message_of([&] { parse_point_file(text, PointFormat::obj, "m.obj"); });
  };
  EXPECT_NE(refused(vertices + "f 1 2 5\n").find("m.obj:9: a face with 3 corners"), std::string::npos);
  EXPECT_NE(refused(vertices + "f 1 2 5 4\nf 1 2 5 4\n").find("m.obj:10"), std::string::npos);  // twice
  EXPECT_NE(refused(vertices + "f 1 2 5 4\nf 1 3 6 4\n").find("not the quads of a grid"), std::string::npos);
  EXPECT_NE(refused(vertices + "f 1 2 5 4\n").find("not the quads of a grid"), std::string::npos);  // a hole
  EXPECT_NE(refused(vertices + "f 1 2 5 4\nf 2 3 6 7\n").find("'7'"), std::string::npos);
  EXPECT_NE(refused(vertices + "f 1 5 2 4\nf 2 3 6 5\n"), "");  // a crossed quad
  EXPECT_NE(refused(vertices + "l 1 2\nf 1 2 5 4\nf 2 3 6 5\n").find("polyline"), std::string::npos);
  // The same file is no polygon.
  EXPECT_NE(message_of([&] { parse_obj(vertices + "f 1 2 5 4\nf 2 3 6 5\n", "m.obj"); }).find("m.obj:9"),
            std::string::npos);
}

TEST(Grids, CsvSaysItsSize) {
  const auto file = [](const std::string& text) { return parse_point_file(text, PointFormat::csv, "g.csv"); };
  EXPECT_TRUE(std::holds_alternative<PointSet>(file("x,y\n1,2\n3,4\n")));
  EXPECT_TRUE(std::holds_alternative<PointSet>(file("# grid of points, in metres\n1,2\n3,4\n")));
  EXPECT_TRUE(std::holds_alternative<PointSet>(file("1,2\n# grid 2x1\n3,4\n")));
  const auto g = std::get<PointGrid>(file("# made by hand\n #\tgrid  2 x 3 \nx,y\n1,2\n3,4\n5,6\n7,8\n9,1.50\n2,2\n"));
  EXPECT_EQ(g.size, (GridSize{2, 3}));
  EXPECT_EQ(g.points.tokens[9], "1.50");
  EXPECT_NE(message_of([&] { file("# grid 2x3\n1,2\n3,4\n"); }).find("2x3 points is announced, but 2"),
            std::string::npos);
  EXPECT_NE(message_of([&] { file("# grid 2*3\n1,2\n"); }).find("g.csv:1"), std::string::npos);
  EXPECT_NE(message_of([&] { file("# grid 0x3\n1,2\n"); }).find("'0x3'"), std::string::npos);
  EXPECT_NE(message_of([&] { file("# grid 99999999999999999999x1\n1,2\n"); }), "");
  EXPECT_NE(message_of([&] { file("# grid 4611686018427387904x4\n1,2\n"); }), "");
}

TEST(Grids, NpyOrders) {
  // Fortran order: the first axis runs fastest.
  std::string npy = grid_to_bytes(grid({2, 3}, 2), PointFormat::npy, {});
  const std::size_t at = npy.find("False");
  npy.replace(at, 5, "True ");
  const PointGrid g = read(npy, PointFormat::npy);
  // Element (i, j, c) of the Fortran array is number i + 2*j + 6*c of the file.
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t c = 0; c < 2; ++c) {
        EXPECT_EQ(g.points.values[(i * 3 + j) * 2 + c], 0.25 * double(i + 2 * j + 6 * c) - 3);
      }
    }
  }
  EXPECT_NE(message_of([&] { parse_npy(grid_to_bytes(grid({2, 2}, 2), PointFormat::npy, {}), "a.npy"); }), "");
}

TEST(Grids, QuadsCloseAndTurnOneWay) {
  const std::string ply = grid_to_bytes(grid({3, 4}, 2), PointFormat::ply, {true, true});
  EXPECT_NE(ply.find("element vertex 12\nproperty double x\nproperty double y\nproperty double z\nelement face 12\n"),
            std::string::npos);
  EXPECT_NE(ply.find("\n4 0 4 5 1\n"), std::string::npos);
  EXPECT_NE(ply.find("\n4 11 3 0 8\n"), std::string::npos);  // the corner that closes both ways
  // Every edge of the closed mesh belongs to two quads, once in each sense.
  std::vector<std::pair<int, int>> edges;
  const std::string obj = grid_to_bytes(grid({3, 4}, 3), PointFormat::obj, {true, true});
  for (std::size_t p = obj.find("\nf "); p != std::string::npos; p = obj.find("\nf ", p + 1)) {
    int c[4];
    ASSERT_EQ(std::sscanf(obj.c_str() + p, "\nf %d %d %d %d", c, c + 1, c + 2, c + 3), 4);
    for (int i = 0; i < 4; ++i) edges.emplace_back(c[i], c[(i + 1) % 4]);
  }
  EXPECT_EQ(edges.size(), 48U);
  for (const auto& [a, b] : edges) {
    EXPECT_EQ(std::count(edges.begin(), edges.end(), std::pair(a, b)), 1);
    EXPECT_EQ(std::count(edges.begin(), edges.end(), std::pair(b, a)), 1);
  }
  EXPECT_NE(message_of([] { grid_to_bytes(grid({2, 4}, 3), PointFormat::obj, {true, false}); }), "");
  EXPECT_NE(message_of([] { grid_to_bytes(grid({2, 4}, 3), PointFormat::svg, {}); }).find("svg"), std::string::npos);
  EXPECT_NE(message_of([] { grid_to_bytes(grid({2, 4}, 4), PointFormat::obj, {}); }), "");
}

TEST(Grids, AnyBytesAreReadOrRefused) {
  std::mt19937_64 random(17);
  const std::vector<std::pair<PointFormat, std::string>> seeds = {
      {PointFormat::csv, grid_to_bytes(grid({3, 2}, 2), PointFormat::csv, {})},
      {PointFormat::npy, grid_to_bytes(grid({3, 2}, 2), PointFormat::npy, {})},
      {PointFormat::obj, grid_to_bytes(grid({3, 3}, 2), PointFormat::obj, {true, false})}};
  std::size_t grids = 0;
  for (std::size_t round = 0; round < tests::rounds(6000); ++round) {
    const auto& [format, seed] = seeds[round % seeds.size()];
    try {
      const PointFile file = parse_point_file(tests::mutate(seed, random), format, "fuzz");
      const auto* g = std::get_if<PointGrid>(&file);
      const PointSet& points = g != nullptr ? g->points : std::get<PointSet>(file);
      ASSERT_GT(points.size(), 0U);
      if (g == nullptr) continue;
      ++grids;
      ASSERT_EQ(g->size.rows * g->size.columns, points.size());
      for (const double x : points.values) ASSERT_TRUE(std::isfinite(x));
      ASSERT_FALSE(grid_to_bytes(*g, format, g->closings.value_or(Closings{})).empty());
    } catch (const Error& error) {
      ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
  EXPECT_GT(grids, 100U);
}

}  // namespace
}  // namespace twoscale::kernels
