// SPDX-License-Identifier: GPL-3.0-or-later
/// Scheme: stencils and symbols are the same thing; the shift; derived predicates; limits.
#include "twoscale/symbolic/scheme.hpp"

#include "support/laws.hpp"
#include "symbolic/exact_points.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"
#include "twoscale/symbolic/interpolatory.hpp"

namespace twoscale::tests {
namespace {

/// f^{k+1}_{mj+s} by the stencils of a scalar scheme without parameters.
Rational refined_by_stencils(const Scheme& s, const std::vector<Rational>& data, long origin, long i) {
  const long m = s.arity;
  const long phase = ((i % m) + m) % m;
  const long j = (i - phase) / m;
  const Stencil& stencil = s.phases[static_cast<size_t>(phase)];
  Rational sum;
  for (size_t h = 0; h < stencil.blocks.size(); ++h) {
    const long at = j + stencil.lowest + static_cast<long>(h) + origin;
    if (at >= 0 && at < static_cast<long>(data.size()))
      sum += stencil.blocks[h][0].constant().value() * data[static_cast<size_t>(at)];
  }
  return sum;
}

LAW(Scheme, StencilsAndSymbolAreTheSame, (const Laurent& a)) {
  LAW_GIVEN(!a.at_one().is_zero());
  const int m = uniform(2, 5);
  Scheme s;
  try {
    s = Scheme::from_symbol("test", a, m, {{"v", Parameter::Scope::constant, std::nullopt}});
  } catch (const Error&) {
    LAW_GIVEN(!"the centre depends on v");
  }
  LAW_ASSERT(s.phases.size() == static_cast<size_t>(m));
  LAW_ASSERT(symbol(s) == a);
  for (long r = 0; r < m; ++r) {
    const Stencil& t = s.phases[static_cast<size_t>(r)];
    for (long h = -12; h <= 12; ++h) {
      const long at = h - t.lowest;
      const RationalFunction value = at >= 0 && at < static_cast<long>(t.blocks.size())
                                         ? t.blocks[static_cast<size_t>(at)][0]
                                         : RationalFunction(0);
      LAW_ASSERT(value == a.coefficient(r - m * h));
    }
  }
}

TEST(Scheme, RefinementIsConvolutionOfTheUpsampledData) {
  for (const int m : {2, 3, 4}) {
    const Laurent a = bspline_symbol(Space::one_frequency(4, {}), m);
    const Scheme s = Scheme::from_symbol("test", a, m, {});
    const std::vector<Rational> data = {3, Rational(-1, 2), 7, 0, Rational(5, 3)};
    const Laurent coarse(-2, std::vector<RationalFunction>(data.begin(), data.end()));
    const Laurent fine = a * coarse.dilated(m);
    for (long i = -30; i <= 30; ++i)
      EXPECT_EQ(refined_by_stencils(s, data, 2, i), fine.coefficient(i).constant()) << m << " " << i;
  }
}

TEST(Scheme, ShiftReproducesTheLine) {
  // With t^k_j = (j + p)/m^k samples of x stay samples of x: the definition of p.
  for (const int m : {2, 3, 4})
    for (unsigned order = 2; order <= 5; ++order) {
      const Laurent a = bspline_symbol(Space::one_frequency(order, {}), m);
      for (const long by : {0L, 1L, -3L}) {
        const Scheme s = Scheme::from_symbol("test", a.shifted(by), m, {});
        EXPECT_EQ(s.shift, *a.shifted(by).centre_of_symmetry() / Rational(m - 1));
        std::vector<Rational> line;
        for (long j = -20; j <= 20; ++j) line.push_back(Rational(j) + s.shift);
        for (long i = -5; i <= 5; ++i)
          EXPECT_EQ(refined_by_stencils(s, line, 20, i), (Rational(i) + s.shift) / Rational(m))
              << m << " " << order << " " << by;
      }
    }
}

TEST(Scheme, WhatHasNoParametrisationIsRefused) {
  const auto rf = [](const char* t) { return parse_rational_function(t); };
  EXPECT_THROW(Scheme::from_symbol("test", Laurent(), 2, {}), Error);
  EXPECT_THROW(Scheme::from_symbol("test", Laurent(0, {1, -1}), 2, {}), Error);
  EXPECT_THROW(Scheme::from_symbol("test", Laurent(0, {rf("1-w"), 1, rf("w")}), 2, {}), Error);
  EXPECT_EQ(Scheme::from_symbol("test", Laurent(0, {rf("w"), rf("2-2*w"), rf("w")}), 2, {}).shift, Rational(1));
}

TEST(Scheme, Predicates) {
  const Space space = Space::parse("1,x,exp(t*x),exp(-t*x)");
  const Scheme zeta = Scheme::from_symbol("test", interpolating_symbol(space), 2, level_parameters(space));
  EXPECT_TRUE(is_interpolatory(zeta));
  EXPECT_TRUE(is_uniform(zeta));
  EXPECT_FALSE(is_stationary(zeta));
  ASSERT_EQ(level_variables(zeta).size(), 1U);
  EXPECT_EQ(level_variables(zeta)[0].meaning(2), "cosh(t/2^(k+1))");
  const Scheme sigma = Scheme::from_symbol("test", bspline_symbol(space), 2, level_parameters(space));
  EXPECT_FALSE(is_interpolatory(sigma));
  EXPECT_TRUE(is_stationary(Scheme::from_symbol("test", Laurent(-1, {1, 2, 1}), 2, {})));
  // A shifted interpolatory mask is not interpolatory in this sense.
  EXPECT_FALSE(is_interpolatory(
      Scheme::from_symbol("test", interpolating_symbol(space).shifted(2), 2, level_parameters(space))));
}

TEST(Scheme, LimitSymbol) {
  const auto rf = [](const char* t) { return parse_rational_function(t); };
  LevelVariable v;
  v.name = "v";
  v.symbol = "t";
  const std::vector<Parameter> level = {{"v", Parameter::Scope::level, v}};
  const Scheme good = Scheme::from_symbol("test", Laurent(-1, {rf("1/(v+1)"), rf("2*v"), rf("1/(v+1)")}), 2, level);
  EXPECT_EQ(limit_symbol(good).value(), Laurent(-1, {rf("1/2"), 2, rf("1/2")}));
  const Scheme pole = Scheme::from_symbol("test", Laurent(-1, {rf("1/(v-1)"), rf("2*v"), rf("1/(v-1)")}), 2, level);
  EXPECT_FALSE(limit_symbol(pole).has_value());
}

TEST(Scheme, Recurrence) {
  EXPECT_EQ(recurrence("v", 2), "v^{k+1} = sqrt((1 + v^k)/2)");
  EXPECT_NE(recurrence("v", 3).find("4*v^{k+1}^3 - 3*v^{k+1}"), std::string::npos) << recurrence("v", 3);
}

}  // namespace
}  // namespace twoscale::tests
