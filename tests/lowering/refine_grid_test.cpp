// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces come back from their samples: sums of tensor products, in doubles and with digits.
#include "twoscale/lowering/refine_grid.hpp"

#include "support.hpp"
#include "twoscale/kernels/number_text.hpp"
#include "twoscale/lowering/parametric_surface.hpp"

namespace twoscale::lowering {
namespace {

using kernels::Boundary;

ParametricSurface surface(std::vector<const char*> formulas, SampledAxis u, SampledAxis v) {
  ParametricSurface s;
  for (const char* f : formulas) s.coordinates.push_back(ExponentialSum::parse(f));
  s.columns = kernels::default_columns(formulas.size());
  s.u = std::move(u);
  s.v = std::move(v);
  return s;
}

SampledAxis axis(const char* first, const char* step, long count, Boundary ends = Boundary::closed) {
  return {SampleLine::parse(first, step), count, ends};
}

ParametricSurface klein(long u, const char* u_step, long v, const char* v_step) {
  return surface({"(3+cos(pi*u/4)*sin(pi*v/2)-sin(pi*u/4)*sin(pi*v))*cos(pi*u/2)",
                  "(3+cos(pi*u/4)*sin(pi*v/2)-sin(pi*u/4)*sin(pi*v))*sin(pi*u/2)",
                  "sin(pi*u/4)*sin(pi*v/2)+cos(pi*u/4)*sin(pi*v)"},
                 axis("0", u_step, u), axis("0", v_step, v));
}

TEST(RefineGrid, SurfacesComeBackFromTheirSamples) {
  const ParametricSurface cases[] = {
      klein(16, "1/2", 8, "1/2"),
      surface({"cos(pi*u/4)*(1-cos(pi*v/4))*sin(pi*v/4)", "sin(pi*u/4)*(1-cos(pi*v/4))*sin(pi*v/4)", "cos(pi*v/4)"},
              axis("0", "1", 8), axis("0", "1", 5, Boundary::given)),
      surface({"u*cosh(v)+v^2*exp(-u/2)", "cosh(u/2)*v"}, axis("-1", "1/2", 5, Boundary::given),
              axis("0", "1/3", 7, Boundary::space)),
  };
  for (const ParametricSurface& s : cases) {
    for (const SurfaceMethod method : {SurfaceMethod::space, SurfaceMethod::sum}) {
      const RefinedGrid out = refine_sum(summands(s, method, 3, 2, 0), 0);
      EXPECT_LT(estimate_largest_deviation(out, s), 1e-13);
    }
  }
}

TEST(RefineGrid, AsFewSamplesAsDetermineTheSurface) {
  const ParametricSurface few = klein(7, "8/7", 5, "4/5");
  EXPECT_LT(estimate_largest_deviation(refine_sum(summands(few, SurfaceMethod::space, 3, 3, 0), 0), few), 1e-13);
  // One sample less along u: a step is singular.
  EXPECT_NE(test::refusal([] { refine_sum(summands(klein(6, "4/3", 5, "4/5"), SurfaceMethod::space, 3, 3, 0), 0); }),
            "");
  EXPECT_NE(test::refusal([] { refine_sum(summands(klein(7, "8/7", 4, "1"), SurfaceMethod::space, 3, 3, 0), 0); }), "");
}

TEST(RefineGrid, EveryDigitIsThatOfTheSurface) {
  const ParametricSurface s = klein(16, "1/2", 8, "1/2");
  const long digits = 40;
  const unsigned levels = 1;
  for (const SurfaceMethod method : {SurfaceMethod::space, SurfaceMethod::sum}) {
    const RefinedGrid out = refine_sum(summands(s, method, levels, levels, digits), digits);
    ASSERT_EQ(out.grid.size, (kernels::GridSize{32, 16}));
    ASSERT_EQ(out.grid.points.tokens.size(), 32U * 16U * 3U);
    for (const long i : {0L, 3L, 9L, 31L}) {
      for (const long j : {0L, 1L, 7L}) {
        for (std::size_t c = 0; c < 3; ++c) {
          const ExactReal exact =
              s.coordinates[c].at(s.u.line.first + GiNaC::numeric(i, 4), s.v.line.first + GiNaC::numeric(j, 4));
          const std::string& token = out.grid.points.tokens[static_cast<std::size_t>(i * 16 + j) * 3 + c];
          const std::string expected = exact.sign() == Sign::zero ? "0" : exact.decimal(digits);
          EXPECT_EQ(test::exact_text(token), test::exact_text(expected)) << i << " " << j << " " << c;
        }
      }
    }
  }
}

TEST(RefineGrid, DigitsAndDoublesAgree) {
  kernels::PointGrid grid;
  grid.size = {5, 4};
  grid.points.dim = 2;
  for (int i = 0; i < 40; ++i) grid.points.values.push_back((i * 37 % 19) / 4. - 2);
  const Scheme u = make_scheme("tension4"), v = make_scheme("bspline:n=2");
  const Direction along_u{u, bind(u, "cosh(1)", std::nullopt, {}), 2, Boundary::linear};
  const Direction along_v{v, bind(v, std::nullopt, std::nullopt, {}), 3, Boundary::closed};
  const RefinedGrid fast = refine_grid(grid, along_u, along_v, 0), exact = refine_grid(grid, along_u, along_v, 30);
  ASSERT_EQ(fast.grid.size, (kernels::GridSize{17, 32}));
  EXPECT_EQ(fast.parameters, exact.parameters);
  EXPECT_EQ(fast.parameters.v, Rational(1, 16));
  EXPECT_EQ(*fast.grid.closings, (kernels::Closings{false, true}));
  for (std::size_t i = 0; i < fast.grid.points.values.size(); ++i)
    EXPECT_NEAR(fast.grid.points.values[i], exact.grid.points.values[i], 1e-14);
}

TEST(RefineGrid, SummandsMustFitTogether) {
  const auto summand = [](const char* u, const char* v, std::size_t rows, std::size_t columns, std::size_t dim) {
    Summand s;
    s.grid.size = {rows, columns};
    s.grid.points.dim = dim;
    s.grid.points.values.assign(rows * columns * dim, 1.0);
    for (auto [direction, name] : {std::pair(&s.u, u), std::pair(&s.v, v)}) {
      direction->scheme = make_scheme(name);
      direction->binding = bind(direction->scheme, std::nullopt, std::nullopt, {});
      direction->levels = 2;
    }
    return s;
  };
  const Summand first = summand("dd:l=2", "dd:l=2", 4, 5, 3);
  EXPECT_EQ(refine_sum({first, summand("dd:l=3", "bspline:n=3", 4, 5, 3)}, 0).grid.points.values.front(), 2.0);
  for (const Summand& other : {summand("dd:l=2", "dd:l=2", 5, 4, 3), summand("dd:l=2", "bspline:n=2", 4, 5, 3),
                               summand("dd:l=2", "dd:l=2", 4, 5, 2)})
    EXPECT_NE(test::refusal([&] { refine_sum({first, other}, 0); }).find("summand 2"), std::string::npos);
  EXPECT_NE(test::refusal([] { refine_sum({}, 0); }), "");
  EXPECT_NE(test::refusal([&] { refine_sum({summand("dd:l=2", "dd:l=2", 2, 5, 3)}, 0); }).find("direction u"),
            std::string::npos);
}

}  // namespace
}  // namespace twoscale::lowering
