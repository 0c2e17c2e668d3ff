// SPDX-License-Identifier: GPL-3.0-or-later
// The two-scale relation of exponential B-splines: an identity, and values.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "twoscale/lowering/bspline_values.hpp"
#include "twoscale/lowering/normalised.hpp"
#include "twoscale/symbolic/bspline_function.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"
#include "twoscale/symbolic/symbol.hpp"

namespace twoscale {
namespace {

using lowering::Binding;
using lowering::BsplineFunction;

const char* const circle = "1,cos(s*x),sin(s*x)";

const std::vector<std::string>& spaces() {
  static const std::vector<std::string> list = {"1",
                                                "1,x,x^2,x^3",
                                                circle,
                                                "cos(s*x),sin(s*x)",
                                                "1,x,exp(t*x),exp(-t*x)",
                                                "1,exp(t*x),exp(-t*x),exp(2*t*x),exp(-2*t*x)",
                                                "1,x,cos(s*x),sin(s*x),x*cos(s*x),x*sin(s*x)",
                                                "1,x,x^2,exp(s*x),exp(-s*x),cos(t*x),sin(t*x)"};
  return list;
}

std::vector<std::pair<std::string, std::string>> values_for(const Scheme& s) {
  std::vector<std::pair<std::string, std::string>> at;
  for (const LevelVariable& v : level_variables(s)) at.emplace_back(v.symbol, v.symbol == "s" ? "6/5" : "4/3");
  return at;
}

Binding binding_of(const Scheme& s) { return lowering::bind(s, std::nullopt, std::nullopt, values_for(s)); }

std::string scheme_of(const std::string& space, int arity = 2) {
  return "exponential-bspline:arity=" + std::to_string(arity) + ",space=\"" + space + "\"";
}

Ball minus(const Ball& a, const Ball& b) {
  Ball r;
  arb_sub(r.raw(), a.raw(), b.raw(), 512);
  return r;
}

double middle(const Ball& x) { return arf_get_d(arb_midref(x.raw()), ARF_RND_NEAR); }

TEST(TwoScale, SigmaSatisfiesTheIdentity) {
  for (const auto& text : spaces())
    for (const int m : {2, 3, 4}) {
      const Space space = Space::parse(text);
      EXPECT_TRUE(two_scale_residual(space, m, bspline_symbol(space, m)).is_zero()) << text << " arity " << m;
    }
}

TEST(TwoScale, AChangedMaskDoesNot) {
  const Space space = Space::parse(circle);
  const Laurent sigma = bspline_symbol(space);
  EXPECT_FALSE(
      two_scale_residual(space, 2, sigma + Laurent::monomial(0, RationalFunction(Rational(1, 1000000)))).is_zero());
  // Normalised by 4 in place of 2 + 2 v, and with the coarse level's cosine.
  const RationalFunction v = RationalFunction::variable("v");
  const RationalFunction middle = (RationalFunction(2) * v + 1) / RationalFunction(4);
  const RationalFunction quarter = Rational(1, 4);
  EXPECT_FALSE(two_scale_residual(space, 2, Laurent(-1, {quarter, middle, middle, quarter})).is_zero());
  EXPECT_FALSE(two_scale_residual(space, 2, sigma.substitute("v", RationalFunction(2) * v * v - 1)).is_zero());
  // The mask of the convolutions is sigma times this factor.
  EXPECT_EQ(convolution_factor(space, 2) * sigma, Laurent(-1, {quarter, middle, middle, quarter}));
}

TEST(TwoScale, PolynomialBSplinesHaveTheirValues) {
  const Scheme s = make_scheme("bspline:n=3");
  const BsplineFunction phi(*s.space, 2, binding_of(s));
  EXPECT_EQ(phi.rounded(0, 0), 2.0 / 3);
  EXPECT_EQ(phi.rounded(5, 1), 1.0 / 6);
  EXPECT_EQ(phi.rounded(0, 2), 0);
  EXPECT_EQ(phi.rounded(0, Rational(-5, 2)), 0);
  const Scheme box = make_scheme("bspline:n=0");
  const BsplineFunction one(*box.space, 2, binding_of(box));
  EXPECT_EQ(one.rounded(0, one.first()), 1);
  EXPECT_EQ(one.rounded(0, one.last()), 0);
}

TEST(TwoScale, ClosedFormOfTheCircleSplines) {
  const Scheme s = make_scheme(scheme_of(circle));
  for (int m = 4; m <= 16; ++m) {
    const Binding b = lowering::bind(s, std::nullopt, std::nullopt, {{"s", "2*pi/" + std::to_string(m)}});
    const BsplineFunction phi(*s.space, 2, b);
    EXPECT_EQ(phi.shift(), Rational(1, 2));
    for (unsigned k = 0; k < 3; ++k)
      for (int i = 0; i <= 24; ++i) {
        // First piece of the convolution 1 * cos * ..: (1 - cos(w x))/w^2, of phi: sin^2(w x/2)/(2 sin^2(w/2)).
        const double w = 2 * std::numbers::pi / m / std::ldexp(1.0, static_cast<int>(k)), x = i / 24.0;
        const auto square = [&](double y) { return std::pow(std::sin(w * y / 2) / std::sin(w / 2), 2) / 2; };
        EXPECT_NEAR(middle(phi.value(k, phi.first() + Rational(i, 24), 80)), square(x), 1e-14);
        EXPECT_NEAR(middle(phi.value(k, phi.last() - Rational(i, 24), 80)), square(x), 1e-14);
        EXPECT_NEAR(middle(phi.value(k, phi.first() + 1 + Rational(i, 24), 80)), 1 - square(x) - square(1 - x), 1e-14);
      }
  }
}

TEST(TwoScale, TranslatesSumToOneWhereConstantsAreInTheSpace) {
  for (const auto& text : spaces()) {
    const Scheme s = make_scheme(scheme_of(text));
    if (s.space->polynomial_order() == 0) continue;
    const BsplineFunction phi(*s.space, 2, binding_of(s));
    Ball sum;
    for (long j = -20; j <= 20; ++j)
      arb_add(sum.raw(), sum.raw(), phi.value(1, Rational(1, 7) + Rational(j), 300).raw(), 512);
    EXPECT_TRUE(arb_contains_si(sum.raw(), 1)) << text;
    EXPECT_LT(mag_get_d(arb_radref(sum.raw())), 1e-60) << text;
  }
}

TEST(TwoScale, RelationHoldsInBalls) {
  for (const auto& text : spaces())
    for (const int m : {2, 3}) {
      const Scheme s = make_scheme(scheme_of(text, m));
      const Binding b = binding_of(s);
      const BsplineFunction phi(*s.space, m, b);
      const kernels::MaskTable t = lowering::lower(s, b, {3, 60, false, false});
      for (unsigned k = 0; k < 3; ++k)
        for (int i = 0; i <= 10; ++i) {
          const Rational x = phi.first() + (phi.last() - phi.first()) * Rational(2 * i + 1, 23);
          Ball sum, coefficient;
          for (size_t j = 0; j < t.levels[k].text.size(); ++j) {
            arb_set_str(coefficient.raw(), t.levels[k].text[j].c_str(), 300);
            arb_addmul(
                sum.raw(), coefficient.raw(),
                phi.value(k + 1, Rational(m) * x - Rational(t.levels[k].lowest + static_cast<long>(j)), 300).raw(),
                300);
          }
          EXPECT_LT(std::fabs(middle(minus(phi.value(k, x, 300), sum))), 1e-57) << text << " arity " << m << " k " << k;
        }
    }
}

// phi_M(x) = sum_k h_M[k] phi_2M(2 x - k) in double arithmetic.
TEST(TwoScale, ResidualInDoubleIsAtRoundingLevel) {
  const Scheme s = make_scheme(scheme_of(circle));
  for (int m = 4; m <= 16; ++m) {
    const auto bound = [&](int samples) {
      return lowering::bind(s, std::nullopt, std::nullopt, {{"s", "2*pi/" + std::to_string(samples)}});
    };
    const BsplineFunction coarse(*s.space, 2, bound(m)), fine(*s.space, 2, bound(2 * m));
    const kernels::MaskRow h = lowering::lower(s, bound(m), {1, 0, false, false}).levels[0];
    for (int i = 0; i <= 96; ++i) {
      const Rational x = coarse.first() + Rational(i, 32);
      double sum = 0;
      for (size_t j = 0; j < h.value.size(); ++j)
        sum += h.value[j] * fine.rounded(0, Rational(2) * x - Rational(h.lowest + static_cast<long>(j)));
      EXPECT_LT(std::fabs(coarse.rounded(0, x) - sum), 1e-15) << m;
    }
  }
}

TEST(TwoScale, RowKIsTheTableOfTwoToTheKTimesTheSamples) {
  const Scheme s = make_scheme(scheme_of(circle));
  const auto table = [&](const std::string& value) {
    return lowering::lower(s, lowering::bind(s, std::nullopt, std::nullopt, {{"s", value}}), {3, 40, false, false});
  };
  EXPECT_EQ(table("2*pi/5").levels[2].text, table("2*pi/20").levels[0].text);
}

TEST(Normalised, SumsAreWhatTheyShouldBe) {
  const Scheme s = make_scheme(scheme_of(circle));
  const Binding b = lowering::bind(s, std::nullopt, std::nullopt, {{"s", "2*pi/6"}});
  const auto sum_of = [&](const char* name) {
    const auto t = lowering::lower_normalised(s, lowering::parse_normalisation(name), b, {2, 30, false, true});
    Ball sum, x;
    for (const auto& text : t.levels[0].text) {
      arb_set_str(x.raw(), text.c_str(), 200);
      arb_add(sum.raw(), sum.raw(), x.raw(), 200);
    }
    return middle(sum);
  };
  EXPECT_DOUBLE_EQ(sum_of("arity"), 2);
  EXPECT_DOUBLE_EQ(sum_of("sum1"), 1);
  EXPECT_DOUBLE_EQ(sum_of("sqrt2"), std::numbers::sqrt2);
  EXPECT_DOUBLE_EQ(sum_of("convolution"), 1 + std::cos(std::numbers::pi / 6));
  EXPECT_THROW(lowering::parse_normalisation("four"), Error);
  const Scheme interpolating = make_scheme("tension4");
  EXPECT_THROW(lowering::lower_normalised(interpolating, lowering::Normalisation::convolution,
                                          lowering::bind(interpolating, "2", std::nullopt, {}), {1, 17, false, false}),
               Error);
}

}  // namespace
}  // namespace twoscale
