// SPDX-License-Identifier: GPL-3.0-or-later
// Formulas in two parameters: taken apart into exponentials, put together again, and what they ask of schemes.
#include "twoscale/symbolic/exponential_sum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"
#include "twoscale/symbolic/interpolatory.hpp"

namespace twoscale {
namespace {

double value(const ExactReal& x) { return std::strtod(x.decimal(20).c_str(), nullptr); }

TEST(ExponentialSum, KeepsTheFunction) {
  const std::pair<const char*, double (*)(double, double)> cases[] = {
      {"(3+v*cos(pi*u/4))*sin(pi*u/2)",
       [](double u, double v) { return (3 + v * std::cos(M_PI * u / 4)) * std::sin(M_PI * u / 2); }},
      {"u^2*exp(-v/3)*cosh(2*u)-sinh(u+v)^2/4",
       [](double u, double v) {
         return u * u * std::exp(-v / 3) * std::cosh(2 * u) - std::pow(std::sinh(u + v), 2) / 4;
       }},
      {"cos(u-v+1/3)^3+sqrt(2)*v/exp(u)",
       [](double u, double v) { return std::pow(std::cos(u - v + 1. / 3), 3) + std::sqrt(2.) * v / std::exp(u); }},
      {"sin(pi*u/6+pi/4)", [](double u, double) { return std::sin(M_PI * u / 6 + M_PI / 4); }},
  };
  for (const auto& [formula, f] : cases) {
    const ExponentialSum sum = ExponentialSum::parse(formula);
    for (const long i : {-3L, 0L, 1L, 7L}) {
      for (const long j : {-2L, 0L, 5L}) {
        const GiNaC::ex u = GiNaC::numeric(i, 4), v = GiNaC::numeric(j, 3);
        const double expected = f(double(i) / 4, double(j) / 3);
        EXPECT_NEAR(value(sum.at(u, v)), expected, 1e-13 * (1 + std::abs(expected))) << formula;
        EXPECT_NEAR(sum.estimate(double(i) / 4, double(j) / 3), expected, 1e-13 * (1 + std::abs(expected))) << formula;
      }
    }
  }
  // Zeros are exact: cos^2 + sin^2 - 1, and a value at which only the whole vanishes.
  EXPECT_TRUE(ExponentialSum::parse("cos(u*v-u*v+u)^2+sin(u)^2-1").terms().empty());
  EXPECT_EQ(ExponentialSum::parse("sin(pi*u/7)").at(7, 0).sign(), Sign::zero);
}

TEST(ExponentialSum, RefusesOtherFunctions) {
  const auto refusal = [](const char* formula) -> std::string {
    try {
      ExponentialSum::parse(formula);
    } catch (const Error& e) {
      EXPECT_EQ(e.kind, Error::Kind::bad_input);
      return e.what();
    }
    return "";
  };
  EXPECT_NE(refusal("cos(u*v)").find("cos"), std::string::npos);
  EXPECT_NE(refusal("1/(1+cos(u))"), "");
  EXPECT_NE(refusal("sqrt(u)"), "");
  EXPECT_NE(refusal("u*w").find("w"), std::string::npos);
  EXPECT_NE(refusal("cos(t*u)").find("t"), std::string::npos);
  EXPECT_NE(refusal("(u+v)^1000"), "");
  EXPECT_NE(refusal("(1+cos(u)+cos(v)+cos(3*u)+u+v)^32"), "");
  EXPECT_NE(refusal("exp(u"), "");
  EXPECT_THROW(real_frequency(1 + GiNaC::I), Error);
  EXPECT_THROW(least_space({ExponentialSum::parse("exp(u)*cos(u)")}, Axis::u, SampleLine{}), Error);
}

TEST(ExponentialSum, LeastSpaces) {
  const std::vector<ExponentialSum> klein = {
      ExponentialSum::parse("(3+cos(pi*u/4)*sin(pi*v/2)-sin(pi*u/4)*sin(pi*v))*cos(pi*u/2)"),
      ExponentialSum::parse("sin(pi*u/4)*sin(pi*v/2)+cos(pi*u/4)*sin(pi*v)")};
  const SampleLine half = SampleLine::parse("0", "1/2");
  EXPECT_EQ(least_space(klein, Axis::u, half).to_string(),
            "1, x, cos(pi/8*x), sin(pi/8*x), cos(pi/4*x), sin(pi/4*x), cos(3*pi/8*x), sin(3*pi/8*x)");
  EXPECT_EQ(least_space(klein, Axis::v, half).to_string(), "1, x, cos(pi/4*x), sin(pi/4*x), cos(pi/2*x), sin(pi/2*x)");
  EXPECT_EQ(turns(klein, Axis::u, half, 16), (std::vector<long>{1, 2, 3}));
  EXPECT_EQ(turns(klein, Axis::v, half, 8), (std::vector<long>{0, 1, 2}));
  EXPECT_THROW(turns(klein, Axis::u, half, 8), Error);  // half a period
  EXPECT_EQ(products(klein).size(), 5U);
  const std::vector<ExponentialSum> other = {ExponentialSum::parse("u^3*exp(2*u)+v^2*u^2*cosh(v)")};
  EXPECT_EQ(least_space(other, Axis::u, half).dimension(), 4U + 8U);
  EXPECT_EQ(least_space(other, Axis::v, half).dimension(), 2U + 6U);
  EXPECT_THROW(turns(other, Axis::v, half, 8), Error);
}

TEST(ExponentialSum, PartsAddUp) {
  const std::vector<ExponentialSum> knot = {ExponentialSum::parse("(4-cos(pi*u/2)+sin(3*pi*v/2))*cos(pi*v)"),
                                            ExponentialSum::parse("(4-cos(pi*u/2)+sin(3*pi*v/2))*sin(pi*v)"),
                                            ExponentialSum::parse("sin(pi*u/2)-cos(3*pi*v/2)")};
  const auto parts = products(knot);
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0;
    for (const auto& part : parts) {
      sum += part[c].estimate(.3, .7);
      EXPECT_NEAR(value(part[c].at(GiNaC::numeric(3, 10), GiNaC::numeric(7, 10))), part[c].estimate(.3, .7), 1e-14);
    }
    EXPECT_NEAR(sum, knot[c].estimate(.3, .7), 1e-14);
  }
  for (const auto& part : parts) {
    EXPECT_LE(least_space(part, Axis::u, SampleLine{}).dimension(), 4U);
    EXPECT_LE(least_space(part, Axis::v, SampleLine::parse("0", "1/4")).dimension(), 4U);
  }
}

// The rule for the number of samples against the singular set of the interpolating scheme: a singular v^0 = cos(a pi)
// at any level is 2/n for n samples.
TEST(ExponentialSum, LeastSamplesAreTheFirstThatAreNotSingular) {
  const std::pair<const char*, std::vector<long>> cases[] = {
      {"1,x,cos(s*x),sin(s*x)", {1}},
      {"1,x,cos(s*x),sin(s*x),cos(2*s*x),sin(2*s*x)", {1, 2}},
      {"1,x,cos(s*x),sin(s*x),cos(2*s*x),sin(2*s*x),cos(3*s*x),sin(3*s*x)", {1, 2, 3}},
      {"1,x,cos(s*x),sin(s*x),cos(3*s*x),sin(3*s*x)", {1, 3}},
      {"1,x,cos(s*x),sin(s*x),cos(2*s*x),sin(2*s*x),cos(3*s*x),sin(3*s*x),cos(5*s*x),sin(5*s*x)", {1, 2, 3, 5}},
  };
  for (const auto& [space, multiples] : cases) {
    const SingularSet singular = singular_set(Space::parse(space));
    const auto is_singular = [&](long n) {
      for (const auto& v : singular.values)
        if (v.angle == Rational(2, n)) return true;
      return false;
    };
    long n = 3;
    while (is_singular(n)) ++n;
    EXPECT_EQ(least_closed_samples(multiples), n) << space;
  }
  EXPECT_EQ(least_closed_samples({1, 2, 3, 5}), 9);
  EXPECT_EQ(least_closed_samples({0, 1, 3}), 5);
}

// Möbius strips: S(u + 4, v) = S(u, -v), as printed in jeong2013 and with the usual formula.
TEST(ExponentialSum, MoebiusStripsCloseWithAHalfTwist) {
  const std::vector<std::vector<const char*>> strips = {
      {"3*cos(pi*u/2)+v*cos(pi*u/4)", "3*sin(pi*u/2)+v*cos(pi*u/4)", "v*sin(pi*u/4)"},
      {"(3+v*cos(pi*u/4))*cos(pi*u/2)", "(3+v*cos(pi*u/4))*sin(pi*u/2)", "v*sin(pi*u/4)"}};
  for (const auto& strip : strips) {
    for (const char* formula : strip) {
      const ExponentialSum s = ExponentialSum::parse(formula);
      for (long i = 0; i < 8; ++i) {
        for (const long v : {-1L, 0L, 1L}) {
          const GiNaC::ex u = GiNaC::numeric(i, 3);
          EXPECT_EQ((s.at(u + 4, v) - s.at(u, -v)).sign(), Sign::zero) << formula;
        }
      }
    }
  }
}

}  // namespace
}  // namespace twoscale
