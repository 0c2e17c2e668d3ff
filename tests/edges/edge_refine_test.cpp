// SPDX-License-Identifier: GPL-3.0-or-later
// Edges with their own masks: the kernel, and what a mixture of tensions still reproduces.
#include "twoscale/kernels/edge_refine.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "twoscale/kernels/number_text.hpp"
#include "twoscale/lowering/lower.hpp"
#include "twoscale/lowering/refine_points.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale {
namespace {

using kernels::Boundary;
using kernels::EdgeRefiner;
using kernels::MaskTable;
using kernels::PointSet;

MaskTable table(const std::string& scheme, const std::string& v0, unsigned levels, bool extension = false) {
  const Scheme s = make_scheme(scheme);
  return lowering::lower(s, lowering::bind(s, v0, std::nullopt, {}), {levels, 0, extension, false});
}

std::vector<double> random_points(std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<double> p(2 * n);
  for (double& x : p) x = std::uniform_real_distribution<double>(-1, 1)(random);
  return p;
}

PointSet with_tensions(const std::vector<double>& p, const std::vector<std::string>& v0) {
  PointSet s;
  s.columns = {"x", "y", "v0"};
  s.dim = 3;
  for (std::size_t j = 0; j < v0.size(); ++j) {
    for (int c = 0; c < 2; ++c) {
      s.values.push_back(p[2 * j + static_cast<std::size_t>(c)]);
      s.tokens.push_back(kernels::shortest(s.values.back()));
    }
    s.values.push_back(*kernels::parse_double(v0[j]));
    s.tokens.push_back(v0[j]);
  }
  return s;
}

TEST(EdgeRefine, OneKindHasTheBitsOfTheUniformRule) {
  const auto points = random_points(9, 1);
  for (const auto boundary : {Boundary::closed, Boundary::given, Boundary::linear, Boundary::space})
    for (const char* scheme : {"tension4", "interpolating:family=mixed,l=3"}) {
      const std::string name = scheme;
      if (boundary == Boundary::given && name != "tension4") continue;  // 9 points are too few
      const MaskTable t = table(name, "3/2", 4, true);
      const std::vector<MaskTable> tables{table(name, "-1/3", 4, true), t};
      const std::vector<std::size_t> edges(9, 1);
      EXPECT_EQ(EdgeRefiner<double>(tables).refine(points, 2, edges, 4, boundary),
                kernels::refine(points, 2, t, 4, boundary));
      EXPECT_EQ(EdgeRefiner<double>(tables).refine(points, 2, edges, 0, boundary),
                kernels::refine(points, 2, t, 0, boundary));
    }
}

// Against a plain loop: level by level, each edge hands its kind to its m children.
void expect_definition(const std::vector<MaskTable>& tables, std::vector<std::size_t> edges, std::size_t levels) {
  auto p = random_points(edges.size(), 2);
  const long m = tables[0].arity;
  const auto fast = EdgeRefiner<double>(tables).refine(p, 2, edges, static_cast<int>(levels), Boundary::closed);
  for (std::size_t k = 0; k < levels; ++k) {
    const long count = static_cast<long>(edges.size());
    std::vector<double> q;
    std::vector<std::size_t> children;
    for (long j = 0; j < count; ++j)
      for (long r = 0; r < m; ++r) {
        const auto& row = tables[edges[static_cast<std::size_t>(j)]].levels[k];
        for (std::size_t c = 0; c < 2; ++c) {
          double sum = 0;
          for (long from = j - 5; from <= j + 5; ++from)
            if (const long s = m * (j - from) + r - row.lowest; s >= 0 && s < static_cast<long>(row.value.size()))
              sum +=
                  row.value[static_cast<std::size_t>(s)] * p[2 * static_cast<std::size_t>((from + count) % count) + c];
          q.push_back(sum);
        }
        children.push_back(edges[static_cast<std::size_t>(j)]);
      }
    p = q;
    edges = children;
  }
  ASSERT_EQ(fast.size(), p.size());
  for (std::size_t i = 0; i < p.size(); ++i) EXPECT_NEAR(fast[i], p[i], 1e-13);
}

TEST(EdgeRefine, AgreesWithTheDefinition) {
  expect_definition({table("tension4", "1/5", 5), table("tension4", "4", 5), table("tension4", "1", 5)},
                    {0, 1, 1, 2, 0, 2, 1}, 5);
  std::vector<MaskTable> ternary;
  for (const char* mask : {"mask:arity=3,coefficients=\"1/3,2/3,1,2/3,1/3\"",
                           "mask:arity=3,coefficients=\"-1/9,-1/9,0,4/9,7/9,1,7/9,4/9,0,-1/9,-1/9\""}) {
    const Scheme s = make_scheme(mask);
    ternary.push_back(lowering::lower(s, lowering::bind(s, std::nullopt, std::nullopt, {}), {3, 0, false, false}));
  }
  expect_definition(ternary, {0, 1, 1, 0, 1, 0, 0, 1}, 3);
}

TEST(EdgeRefine, BadRequestsAreRefused) {
  const std::vector<MaskTable> tables{table("tension4", "2", 2), table("tension4", "2", 3)};
  EXPECT_THROW(EdgeRefiner<double>{tables}, kernels::Error);
  const std::vector<MaskTable> one{tables[0]};
  const auto p = random_points(4, 3);
  const std::vector<std::size_t> missing{0, 0, 1, 0}, few{0, 0};
  EXPECT_THROW(EdgeRefiner<double>(one).refine(p, 2, missing, 1, Boundary::closed), kernels::Error);
  EXPECT_THROW(EdgeRefiner<double>(one).refine(p, 2, few, 1, Boundary::closed), kernels::Error);
  const std::vector<std::size_t> edges(4, 0);
  EXPECT_THROW(EdgeRefiner<double>(one).refine(p, 2, edges, 3, Boundary::closed), kernels::Error);
  EXPECT_THROW(EdgeRefiner<double>(std::span<const MaskTable>{}), kernels::Error);
}

// Every rule reproduces 1 and x, whatever its v^0: so does every mixture, up to the last digit asked for.
TEST(EdgeTension, StraightLinesStayStraight) {
  for (const char* scheme : {"tension4", "interpolating:family=harmonic,l=3"}) {
    std::vector<double> p;
    std::vector<std::string> v0;
    const char* const values[] = {"0.3", "7", "1", "-0.2", "2.5"};
    for (int j = 0; j < 14; ++j) {
      p.insert(p.end(), {static_cast<double>(j), 3.0 - 2.0 * j});
      v0.emplace_back(values[j % 5]);
    }
    const PointSet out = lowering::refine_edges(make_scheme(scheme), with_tensions(p, v0), {4, Boundary::linear, 30});
    ASSERT_EQ(out.size(), 13U * 16 + 1);
    for (std::size_t i = 0; i < out.size(); ++i) {
      EXPECT_EQ(out.values[3 * i], static_cast<double>(i) / 16);
      EXPECT_EQ(out.values[3 * i + 1], 3 - static_cast<double>(i) / 8);
    }
  }
}

// The region of docs/per-edge-tension.md is exact and sharp: a_1 = m A, a_{k+1} = m (a_k + l - 1), mirrored at the end.
TEST(EdgeTension, UniformCurvesAppearWhereTheirStencilsDo) {
  struct Case {
    std::string scheme;
    long l;
    unsigned levels;
  };
  for (const Case& c : {Case{"tension4", 2, 5}, Case{"interpolating:family=mixed,l=3", 3, 5},
                        Case{"interpolating:arity=3,space=\"1,x,exp(t*x),exp(-t*x)\"", 2, 3}}) {
    const Scheme s = make_scheme(c.scheme);
    const long n = 16, begin = 3, end = 12, m = s.arity;  // edges begin..end-1 have v^0 = 2
    const auto p = random_points(static_cast<std::size_t>(n), 4);
    std::vector<std::string> mixed(static_cast<std::size_t>(n), "0.25"), uniform(static_cast<std::size_t>(n), "2");
    for (long j = begin; j < end; ++j) mixed[static_cast<std::size_t>(j)] = "2";
    const lowering::RefineOptions options{c.levels, Boundary::closed, 25};
    const PointSet a = lowering::refine_edges(s, with_tensions(p, mixed), options);
    const PointSet b = lowering::refine_edges(s, with_tensions(p, uniform), options);
    long first = m * begin, last = m * end;
    for (unsigned k = 1; k < c.levels; ++k) {
      first = m * (first + c.l - 1);
      last = m * (last - c.l + 1);
    }
    const auto same = [&](long i) {
      const auto at = static_cast<std::size_t>(3 * i);
      return a.tokens[at] == b.tokens[at] && a.tokens[at + 1] == b.tokens[at + 1];
    };
    for (long i = first; i <= last; ++i) EXPECT_TRUE(same(i)) << c.scheme << " " << i;
    EXPECT_FALSE(same(first - 1)) << c.scheme;
    EXPECT_FALSE(same(last + 1)) << c.scheme;
  }
}

TEST(EdgeTension, RefiningAgainGoesOn) {
  const auto p = random_points(6, 5);
  const PointSet in = with_tensions(p, {"0.5", "2", "1", "-0.5", "2", "0"});
  const Scheme s = make_scheme("tension4");
  const PointSet whole = lowering::refine_edges(s, in, {5, Boundary::closed, 0});
  const PointSet half =
      lowering::refine_edges(s, lowering::refine_edges(s, in, {2, Boundary::closed, 0}), {3, Boundary::closed, 0});
  ASSERT_EQ(whole.values.size(), half.values.size());
  for (std::size_t i = 0; i < whole.values.size(); ++i) EXPECT_NEAR(whole.values[i], half.values[i], 1e-14);
  // v^{k+1} = sqrt((1 + v^k)/2); 1 stays 1; -1/2 becomes 1/2 exactly.
  const PointSet once = lowering::refine_edges(s, in, {1, Boundary::closed, 30});
  EXPECT_EQ(once.tokens[3 * 6 + 2], "0.500000000000000000000000000000");
  EXPECT_EQ(once.tokens[3 * 4 + 2], "1");
  EXPECT_EQ(once.values[3 * 10 + 2], std::sqrt(0.5));
}

// C^1 for tension4: where two tensions meet, second differences times 2^k must tend to 0 (the slopes meet).
TEST(EdgeTension, SlopesMeetAtAChange) {
  const std::vector<double> p{0, 0, 1, 2, 2, 0, 3, 1, 4, 3, 5, 0, 6, 2, 3, -4};
  const Scheme s = make_scheme("tension4");
  double before = 1e9;
  for (unsigned levels = 4; levels <= 12; levels += 4) {
    const PointSet out = lowering::refine_edges(
        s, with_tensions(p, {"20", "0.1", "20", "0.1", "20", "0.1", "20", "0.1"}), {levels, Boundary::closed, 0});
    const std::size_t n = out.size();
    double worst = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const auto y = [&](std::size_t j) { return out.values[3 * (j % n) + 1]; };
      worst = std::max(worst, std::fabs(y(i) - 2 * y(i + 1) + y(i + 2)) * std::ldexp(1.0, static_cast<int>(levels)));
    }
    EXPECT_LT(worst, before / 3);
    before = worst;
  }
  EXPECT_LT(before, 0.2);
}

TEST(EdgeTension, RefusalsNameWhatIsWrong) {
  const auto message = [](const std::string& scheme, const PointSet& in) -> std::string {
    try {
      lowering::refine_edges(make_scheme(scheme), in, {1, Boundary::closed, 0});
    } catch (const Error& e) {
      return e.what();
    }
    return "";
  };
  const auto p = random_points(4, 6);
  const PointSet good = with_tensions(p, {"1", "2", "3", "4"});
  EXPECT_NE(message("dd:l=2", good).find("dd:l=2"), std::string::npos);
  EXPECT_NE(message("mixed:n=1", good).find("interpolating scheme"), std::string::npos);
  EXPECT_NE(message("tension4", with_tensions(p, {"1", "-2", "3", "4"})).find("-2"), std::string::npos);
  PointSet none = good;
  none.columns = {"x", "y", "z"};
  EXPECT_NE(message("tension4", none).find("v0"), std::string::npos);
}

}  // namespace
}  // namespace twoscale
