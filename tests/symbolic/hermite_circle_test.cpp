// SPDX-License-Identifier: GPL-3.0-or-later
/// The rational quintic of hermite2010 and its rules, against the printed formulas and against what they have to do.
#include "twoscale/symbolic/hermite_circle.hpp"

#include <gtest/gtest.h>

#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::tests {
namespace {

using R = RationalFunction;

R read(const char* text) { return parse_rational_function(text); }

/// phi_1 .. phi_9 of (11), as printed.
const char* const phi[] = {
    "",
    "((3-5*v^2+8*v^4)*u^6-16*v*(1-2*v^2)*u^5-(2-43*v^2+3*v^4)*u^4+16*v*(1-v^2)*u^3+(3-43*v^2+2*v^4)*u^2-16*v*(2-v^2)*u"
    "-8+5*v^2-3*v^4)*(v^2+1)/(16*(u*v+1)^5*(u*v-1))",
    "(u^2+1)*(u-v)*((5*v^2-3)*u^2+16*u*v-3*v^2+5)*(v^2+1)^2/(32*(u*v+1)^4*(v-1)*(v+1)*(u*v-1))",
    "(v^2+1)^4*(v-u)^2*(u^2+1)/(64*(u*v+1)^3*(v-1)^3*(v+1)^3*(u*v-1))",
    "((-5*v^2+3)*(3*v^4+1)*u^6-16*v*(3*v^4-2*v^2+1)*u^5+(9*v^6-39*v^4+43*v^2-5)*u^4+32*v*(v^4+1)*u^3"
    "-(5*v^6-43*v^4+39*v^2-9)*u^2-16*v*(v^4-2*v^2+3)*u+(3*v^2-5)*(v^4+3))/(8*(u*v+1)^5*(v-u))",
    "((-7*u^4+6*u^2-3)*v^2-16*u*(u^2-1)*v-6*u^2+3*u^4+7)*(v^2+1)^2/(16*(u*v+1)^4*(v-1)*(v+1))",
    "(u-1)*(u+1)*(v^2+1)^4*(v-u)/(32*(u*v+1)^3*(v-1)^3*(v+1)^3)",
    "3*(u*v-1)^3*(u+v)*(u*v-v+u+1)*(u*v+v-u+1)/((u*v+1)^5*(u-v))",
    "3*(u*v-1)^3*(u*v-v+u+1)*(u*v+v-u+1)*(v^2+1)/(2*(u*v+1)^4*(v-u)*(v-1)*(v+1))",
    "(1-u*v)^3*(v^2+1)^3/(4*(u*v+1)^3*(v-1)^3*(v+1)^3)"};

TEST(HermiteCircle, AllEighteenPrintedCoefficientsFollowFromDefinition4) {
  const R u = R::variable("u");
  const R v = R::variable("v");
  const HermiteRule rule = hermite_circle_rule(v, u);
  for (size_t row = 0; row < 3; ++row)
    for (size_t order = 0; order < 3; ++order) {
      const R printed = read(phi[3 * row + order + 1]);
      const R swapped = printed.substitute("u", R::variable("z")).substitute("v", u).substitute("z", v);
      EXPECT_EQ(rule[row][2 * order], order > 0 ? printed : (row == 0 ? R(1) - printed : -printed)) << row << order;
      EXPECT_EQ(rule[row][2 * order + 1], order > 0 ? swapped : printed) << row << order;
    }
}

TEST(HermiteCircle, TheDenominatorIsGlobal) {
  const R a = R::variable("a");
  const R b = R::variable("b");
  const R x = R::variable("x");
  const auto mu = hermite_circle_weights(a, b);
  R sum;
  for (long k = 0; k <= 5; ++k)
    sum += R(Rational::binomial(5, static_cast<unsigned>(k))) * mu[static_cast<size_t>(k)] * (b - x).pow(5 - k) *
           (x - a).pow(k) / (b - a).pow(5);
  EXPECT_EQ(sum, (R(1) + x * x).pow(2) / R(4));
}

TEST(HermiteCircle, InterpolatesValueAndDerivativesAtBothEnds) {
  const R a = R::variable("a");
  const R b = R::variable("b");
  for (size_t end = 0; end < 2; ++end) {
    const HermiteRule c = hermite_circle_segment(a, b, end == 0 ? a : b);
    for (size_t row = 0; row < 3; ++row)
      for (size_t j = 0; j < 6; ++j) EXPECT_EQ(c[row][j], R(j == 2 * row + end ? 1 : 0)) << end << row << j;
  }
}

/// The rows c, c', c'' are derivatives of one another in t = (1+x)/2, hence in every t between the ends too.
TEST(HermiteCircle, TheRowsAreDerivatives) {
  const HermiteRule c = hermite_circle_segment(R(Rational(-1, 3)), R(Rational(1, 2)), R::variable("x"));
  const auto derivative = [](const R& f) {
    const Polynomial n = f.numerator();
    const Polynomial d = f.denominator();
    return R(2) * R::fraction(n.derivative("x") * d - n * d.derivative("x"), d * d);
  };
  for (size_t row = 0; row < 2; ++row)
    for (size_t j = 0; j < 6; ++j) EXPECT_EQ(c[row + 1][j], derivative(c[row][j])) << row << j;
}

/// f, f', f'' in t of one function, at x: columns of a segment.
struct Jet {
  R f, p, r;
};

Jet jet(const R& f) {
  const auto derivative = [](const R& g) {
    const Polynomial n = g.numerator();
    const Polynomial d = g.denominator();
    return R(2) * R::fraction(n.derivative("x") * d - n * d.derivative("x"), d * d);
  };
  return {f, derivative(f), derivative(derivative(f))};
}

/// 1, cos(sigma/2), sin(sigma/2), cos(sigma), sin(sigma), tan(sigma/4) with x = tan(sigma/4).
const char* const space[] = {
    "1", "(1-x^2)/(1+x^2)", "2*x/(1+x^2)", "((1-x^2)^2-4*x^2)/(1+x^2)^2", "4*x*(1-x^2)/(1+x^2)^2", "x"};

TEST(HermiteCircle, TheRuleReproducesItsSpace) {
  const R u = R::variable("u");
  const R v = R::variable("v");
  const auto doubled = [](const R& s) { return R(2) * s / (R(1) - s * s); };
  const HermiteRule rule = hermite_circle_rule(v, u);
  for (const char* text : space) {
    const Jet g = jet(read(text));
    const auto at = [&](const R& x) {
      return std::array<R, 3>{g.f.substitute("x", x), g.p.substitute("x", x), g.r.substitute("x", x)};
    };
    const auto left = at(doubled(v));
    const auto right = at(doubled(u));
    const auto middle = at((u + v) / (R(1) - u * v));
    for (size_t row = 0; row < 3; ++row) {
      R value;
      for (size_t order = 0; order < 3; ++order)
        value += rule[row][2 * order] * left[order] + rule[row][2 * order + 1] * right[order];
      EXPECT_EQ(value, middle[row]) << text << " row " << row;
    }
  }
}

/// Proposition 5: the printed data are the derivatives in t of (cos(sigma), sin(sigma)).
TEST(HermiteCircle, Proposition5PrintsTheDataOfTheCircle) {
  const Jet c = jet(read(space[3]));
  const Jet s = jet(read(space[4]));
  EXPECT_EQ(c.f, read("(x^2+2*x-1)*(x^2-2*x-1)/(x^2+1)^2"));
  EXPECT_EQ(s.f, read("-4*x*(x+1)*(x-1)/(x^2+1)^2"));
  EXPECT_EQ(c.p, read("32*x*(x+1)*(x-1)/(x^2+1)^3"));
  EXPECT_EQ(s.p, read("8*(x^2+2*x-1)*(x^2-2*x-1)/(x^2+1)^3"));
  EXPECT_EQ(c.r, read("-64*(3*x^4-8*x^2+1)/(x^2+1)^4"));
  EXPECT_EQ(s.r, read("-32*x*(x^4-14*x^2+9)/(x^2+1)^4"));
}

/// The data of §3.1, in s = tan(sigma/8).
TEST(HermiteCircle, Section31PrintsTheSameDataInS) {
  const R x = read("2*s/(1-s^2)");
  const auto in_s = [&](const R& f) { return f.substitute("x", x); };
  const Jet c = jet(read(space[3]));
  const Jet s = jet(read(space[4]));
  EXPECT_EQ(in_s(c.f), read("(s^8-28*s^6+70*s^4-28*s^2+1)/(s^2+1)^4"));
  EXPECT_EQ(in_s(s.f), read("-8*s*(s^6-7*s^4+7*s^2-1)/(s^2+1)^4"));
  EXPECT_EQ(in_s(c.p), read("64*s*(s^2-1)^3*(s^2+2*s-1)*(s^2-2*s-1)/(s^2+1)^6"));
  EXPECT_EQ(in_s(s.p), read("8*(s^2-1)^2*(s^4-4*s^3-6*s^2+4*s+1)*(s^4+4*s^3-6*s^2-4*s+1)/(s^2+1)^6"));
  EXPECT_EQ(in_s(c.r), read("-64*(s^2-1)^4*(s^8-36*s^6+118*s^4-36*s^2+1)/(s^2+1)^8"));
  EXPECT_EQ(in_s(s.r), read("64*s*(s^2-1)^3*(9*s^8-92*s^6+182*s^4-92*s^2+9)/(s^2+1)^8"));
}

/// Lemma 3 on [-1,1]^2: 20 mu_k - 4 (k = 1..4) is a sum of products that are not negative there.
TEST(HermiteCircle, Lemma3WeightsHaveTheMinimaOfThePaper) {
  const R a = R::variable("a");
  const R b = R::variable("b");
  const auto mu = hermite_circle_weights(a, b);
  // 20 mu_1 - 4 = ((a-1)^4) + 4 a (a^2+1)(b+1) for a >= 0; the mirror image (a, b) -> (-a, -b) for a <= 0.
  EXPECT_EQ(R(20) * mu[1] - R(4), read("(a-1)^4 + 4*a*(a^2+1)*(b+1)"));
  EXPECT_EQ(R(20) * mu[1] - R(4), read("(a+1)^4 - 4*a*(a^2+1)*(1-b)"));
  // 20 mu_2 - 4 = ((3a^2+1) b + a(a^2+3))^2/(3a^2+1) + (1-a^2)^3/(3a^2+1).
  EXPECT_EQ(R(20) * mu[2] - R(4), read("(((3*a^2+1)*b + a*(a^2+3))^2 + (1-a^2)^3)/(3*a^2+1)"));
  // The minima are attained at (1, -1) and the ends' 1/4 at 0.
  const auto at = [&](size_t k, long x, long y) { return *mu[k].evaluate({{"a", Rational(x)}, {"b", Rational(y)}}); };
  for (size_t k = 1; k <= 4; ++k) EXPECT_EQ(at(k, 1, -1), Rational(1, 5)) << k;
  EXPECT_EQ(at(0, 0, 1), Rational(1, 4));
  EXPECT_EQ(at(5, 1, 0), Rational(1, 4));
  // Beyond sigma in [-pi, pi] the lemma does not speak, and there are weights that are negative.
  EXPECT_EQ(at(1, 2, -2), Rational(-7, 4));
}

/// Remark 6: on a symmetric interval the matrix has the pattern (10).
TEST(HermiteCircle, Remark6SymmetricIntervals) {
  const R u = R::variable("u");
  const HermiteRule l = hermite_circle_rule(-u, u);
  EXPECT_EQ(l[0][0], R(Rational(1, 2)));
  EXPECT_EQ(l[0][1], R(Rational(1, 2)));
  EXPECT_EQ(l[0][3], -l[0][2]);
  EXPECT_EQ(l[0][5], l[0][4]);
  EXPECT_EQ(l[1][1], -l[1][0]);
  EXPECT_EQ(l[1][3], l[1][2]);
  EXPECT_EQ(l[1][5], -l[1][4]);
  EXPECT_EQ(l[2][0], R());
  EXPECT_EQ(l[2][1], R());
  EXPECT_EQ(l[2][3], -l[2][2]);
  EXPECT_EQ(l[2][5], l[2][4]);
}

/// Reversal (t -> 1-t, s_i <-> -s_{i+1}, p -> -p): kept by the variant c2, broken by the printed tension.
bool reversible(HermiteTension tension) {
  const R w(Rational(3, 2));
  const R v(Rational(-1, 5));
  const R u(Rational(1, 3));
  const HermiteRule rule = hermite_circle_rule(v, u, w, tension);
  const HermiteRule mirror = hermite_circle_rule(-u, -v, w, tension);
  for (size_t row = 0; row < 3; ++row)
    for (size_t order = 0; order < 3; ++order)
      for (size_t end = 0; end < 2; ++end)
        if (mirror[row][2 * order + end] != R((row + order) % 2 == 0 ? 1 : -1) * rule[row][2 * order + 1 - end])
          return false;
  return true;
}

TEST(HermiteCircle, OnlyTheVariantIsSymmetricUnderReversal) {
  EXPECT_TRUE(reversible(HermiteTension::c2));
  EXPECT_FALSE(reversible(HermiteTension::printed));
}

/// The quintic Hermite rule at the middle of an interval of length h: what every rule tends to for small steps.
TEST(HermiteCircle, SmallStepsAreTheQuinticHermiteRuleOnAnIntervalWTimesAsLong) {
  const R h = R::variable("h");
  const R v(Rational(1, 7));
  const R w(Rational(5, 3));
  const R dx = read("2*(1+s^2)/(1-s^2)^2").substitute("s", v);  // dx/ds; t = (1+x)/2
  const char* const quintic[3][6] = {{"1/2", "1/2", "5/32", "-5/32", "1/64", "1/64"},
                                     {"-15/8", "15/8", "-7/16", "-7/16", "-1/32", "1/32"},
                                     {"0", "0", "-3/2", "3/2", "-1/4", "-1/4"}};
  for (const auto tension : {HermiteTension::printed, HermiteTension::c2}) {
    const HermiteRule rule = hermite_circle_rule(v, v + h, w, tension);
    const R step = w * dx * h / R(2);  // in t
    for (size_t row = 0; row < 3; ++row)
      for (size_t j = 0; j < 6; ++j) {
        // The rule has a factor step^{order - row}; with tension c2 p and r are derivatives in t, scaled by w, w^2.
        const long power = static_cast<long>(j / 2) - static_cast<long>(row);
        const auto limit = (rule[row][j] / step.pow(power)).evaluate({{"h", Rational(0)}});
        ASSERT_TRUE(limit.has_value());
        EXPECT_EQ(*limit, Rational::parse(quintic[row][j])) << row << j;
      }
  }
}

TEST(HermiteCircle, CatalogueKeepsTheTensionAsAParameter) {
  const Scheme s = make_scheme("hermite-circle:w=0.5,variant=c2");
  EXPECT_EQ(s.id, "hermite-circle:variant=c2,w=1/2");
  EXPECT_EQ(s.block, 3);
  EXPECT_FALSE(is_uniform(s));
  EXPECT_EQ(s.parameters[1].default_value, "1/2");
  EXPECT_EQ(hermite_tension(s), HermiteTension::c2);
  EXPECT_EQ(hermite_tension(make_scheme("hermite-circle")), HermiteTension::printed);
  EXPECT_EQ(hermite_tension(make_scheme("dd:l=2")), std::nullopt);
  for (const char* bad : {"hermite-circle:w=0", "hermite-circle:w=-1", "hermite-circle:w=x", "hermite-circle:w=1/0",
                          "hermite-circle:variant=nice"})
    EXPECT_THROW(make_scheme(bad), Error) << bad;
  // The stencils of the scheme are the rule: rows f, p, r of the block of each end.
  const HermiteRule rule =
      hermite_circle_rule(R(Rational(-1, 5)), R(Rational(1, 7)), R(Rational(2)), HermiteTension::printed);
  const Scheme printed = make_scheme("hermite-circle");
  for (size_t end = 0; end < 2; ++end)
    for (size_t row = 0; row < 3; ++row)
      for (size_t order = 0; order < 3; ++order)
        EXPECT_EQ(printed.phases[1].blocks[end][3 * row + order].evaluate(
                      {{"s_0", Rational(-1, 5)}, {"s_1", Rational(1, 7)}, {"w", Rational(2)}}),
                  rule[row][2 * order + end].constant());
}

}  // namespace
}  // namespace twoscale::tests
