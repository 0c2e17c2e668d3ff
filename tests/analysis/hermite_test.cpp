// SPDX-License-Identifier: GPL-3.0-or-later
/// Hermite masks: spectral condition, consistency, eigenvalues, and what breaks them.
#include "twoscale/analysis/hermite.hpp"

#include <gtest/gtest.h>

#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::analysis {
namespace {

using R = RationalFunction;

/// Merrien 1992: f_mid = (f0+f1)/2 + lambda (p1-p0), p_mid = (1-mu)(f1-f0) + mu (p0+p1)/2 on intervals of length 1.
Scheme merrien(const R& lambda, const R& mu) {
  Scheme s;
  s.id = "merrien";
  s.block = 2;
  Stencil keep{0, {{R(1), R(0), R(0), R(1)}}};
  const R half(Rational(1, 2));
  Stencil insert{0, {{half, -lambda, mu - R(1), half * mu}, {half, lambda, R(1) - mu, half * mu}}};
  s.phases = {keep, insert};
  return s;
}

TEST(HermiteAnalysis, MerrienSchemesAreC1AndCubicOnlyForTheHermiteCubic) {
  const auto cubic = spectral_condition(hermite_mask(merrien(R(Rational(-1, 8)), R(Rational(-1, 2)))));
  EXPECT_EQ(cubic.order, 3);
  EXPECT_TRUE(cubic.consistent);
  EXPECT_TRUE(cubic.reproduces);
  EXPECT_EQ(cubic.scales[1], R(1));
  // Reproduction of x^2 needs lambda = -1/8 only, of x^3 mu = -1/2 too.
  const auto quadratic = spectral_condition(hermite_mask(merrien(R(Rational(-1, 8)), R::variable("mu"))));
  EXPECT_EQ(quadratic.order, 2);
  const auto linear = spectral_condition(hermite_mask(merrien(R::variable("lambda"), R::variable("mu"))));
  EXPECT_EQ(linear.order, 1);
  EXPECT_TRUE(linear.consistent);
  // Mutation: a rule whose derivatives are not those of the limit.
  const auto wrong = spectral_condition(hermite_mask([] {
    Scheme s = merrien(R(Rational(-1, 8)), R(Rational(-1, 2)));
    s.phases[1].blocks[0][3] = s.phases[1].blocks[1][3] = R(Rational(-1, 8));
    return s;
  }()));
  EXPECT_LT(wrong.order, 2);
}

TEST(HermiteAnalysis, CircleSchemesTendToTheQuinticWithDerivativesInAnotherScale) {
  for (const char* name : {"hermite-circle", "hermite-circle:variant=c2"}) {
    const HermiteMask mask = hermite_mask(make_scheme(name));
    const SpectralCondition c = spectral_condition(mask);
    EXPECT_EQ(c.order, 5) << name;
    EXPECT_TRUE(c.consistent);
    EXPECT_TRUE(c.reproduces);
    // p is 1/w times the derivative in t; t' = (1+s^2)/(1-s^2)^2.
    ASSERT_EQ(c.scales.size(), 3U);
    EXPECT_EQ(c.scales[1], parse_rational_function("(1-s^2)^2/(w*(1+s^2))"));
    EXPECT_EQ(c.scales[2], c.scales[1].pow(2));
    const auto s = spectrum(local_matrix(rescaled(mask, c.scales)), 2);
    // 1, 1/2, 1/4 once, 1/8, 1/16, 1/32 twice: x^n and its copy with a kink.
    std::vector<std::pair<std::string, unsigned>> found;
    for (const auto& e : s.eigenvalues) found.emplace_back(e.exact, s.factors[e.factor].multiplicity);
    const std::vector<std::pair<std::string, unsigned>> expected = {{"1", 1},   {"1/2", 1},  {"1/4", 1},
                                                                    {"1/8", 2}, {"1/16", 2}, {"1/32", 2}};
    EXPECT_EQ(found, expected);
    for (const auto& f : s.factors) EXPECT_EQ(f.geometric, f.multiplicity);
  }
}

TEST(HermiteAnalysis, Refusals) {
  EXPECT_THROW(hermite_mask(make_scheme("dd:l=2")), Error);
  Scheme s = make_scheme("hermite-circle");
  s.parameters[0].offsets = {0};
  EXPECT_THROW(hermite_mask(s), Error);
}

}  // namespace
}  // namespace twoscale::analysis
