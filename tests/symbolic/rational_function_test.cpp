// SPDX-License-Identifier: GPL-3.0-or-later
/// RationalFunction: field laws, one form for one function, text that reads back, evaluation.
#include "twoscale/symbolic/rational_function.hpp"

#include "symbolic/generators.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::tests {
namespace {

using Point = std::vector<std::pair<std::string, Rational>>;

RC_GTEST_PROP(RationalFunctionLaws, Field,
              (const RationalFunction& a, const RationalFunction& b, const RationalFunction& c)) {
  RC_ASSERT((a + b) + c == a + (b + c));
  RC_ASSERT((a * b) * c == a * (b * c));
  RC_ASSERT(a * (b + c) == a * b + a * c);
  RC_ASSERT(a + b == b + a);
  RC_ASSERT(a * b == b * a);
  RC_ASSERT((a - b) + b == a);
  RC_ASSERT((a - a).is_zero());
  if (!b.is_zero()) {
    RC_ASSERT((a / b) * b == a);
    RC_ASSERT((b * b.inverse()).is_one());
    RC_ASSERT(b.inverse().inverse() == b);
    RC_ASSERT(b.pow(-2) * b.pow(3) == b);
  }
}

RC_GTEST_PROP(RationalFunctionLaws, CanonicalAfterEveryOperation,
              (const RationalFunction& a, const RationalFunction& b)) {
  RC_ASSERT(a.is_canonical());
  RC_ASSERT((a + b).is_canonical());
  RC_ASSERT((a - b).is_canonical());
  RC_ASSERT((a * b).is_canonical());
  RC_ASSERT((-a).is_canonical());
  RC_ASSERT((a - a).is_canonical());
  RC_ASSERT(a.pow(3).is_canonical());
  RC_ASSERT(a.pow(0).is_canonical());
  if (!b.is_zero()) {
    RC_ASSERT((a / b).is_canonical());
    RC_ASSERT(b.inverse().is_canonical());
    RC_ASSERT(b.pow(-2).is_canonical());
  }
}

/// The same function by another way: both forms are then the same.
RC_GTEST_PROP(RationalFunctionLaws, EqualFunctionsHaveOneForm,
              (const Polynomial& a, const Polynomial& b, const Polynomial& c)) {
  RC_PRE(!b.is_zero() && !c.is_zero());
  const RationalFunction x = RationalFunction::fraction(a, b);
  const RationalFunction y = RationalFunction::fraction(a * c, b * c);
  const RationalFunction z = RationalFunction(a) / RationalFunction(b);
  const RationalFunction w = RationalFunction::fraction(-a, -b);
  for (const auto& other : {y, z, w}) {
    RC_ASSERT(x == other);
    RC_ASSERT(x.numerator() == other.numerator());
    RC_ASSERT(x.denominator() == other.denominator());
    RC_ASSERT(x.to_string() == other.to_string());
  }
  RC_ASSERT(x.denominator() * a == x.numerator() * b);  // cross-multiplied
}

RC_GTEST_PROP(RationalFunctionLaws, DifferentFunctionsDiffer, (const RationalFunction& a, const RationalFunction& b)) {
  const bool same = a.numerator() * b.denominator() == b.numerator() * a.denominator();
  RC_ASSERT((a == b) == same);
  RC_ASSERT((a - b).is_zero() == same);
}

RC_GTEST_PROP(RationalFunctionLaws, FactorsMayBeGivenInAnyOrder, (const Polynomial& a, const Polynomial& b)) {
  RC_PRE(!b.is_zero());
  auto f = b.factor();
  std::reverse(f.factors.begin(), f.factors.end());
  const RationalFunction x = RationalFunction::over_factors(a, f.content / Rational(3), f.factors);
  RC_ASSERT(x.is_canonical());
  RC_ASSERT(x == RationalFunction(3) * RationalFunction::fraction(a, b));
}

RC_GTEST_PROP(RationalFunctionText, ReadsBackUnchanged, (const RationalFunction& a, const RationalFunction& b)) {
  for (const RationalFunction& f : {a, a * b, a - b}) {
    const std::string text = f.to_string();
    RC_ASSERT(parse_rational_function(text) == f);
    RC_ASSERT(parse_rational_function(text).to_string() == text);
  }
}

RC_GTEST_PROP(RationalFunctionLaws, EvaluationAgrees,
              (const RationalFunction& a, const RationalFunction& b, const Rational& u, const Rational& v,
               const Rational& w)) {
  const Point at = {{"u", u}, {"v", v}, {"w", w}};
  const auto x = a.evaluate(at);
  const auto y = b.evaluate(at);
  RC_ASSERT(x.has_value() == !a.denominator().evaluate(at).is_zero());
  RC_PRE(x.has_value() && y.has_value());
  RC_ASSERT(*x == a.numerator().evaluate(at) / a.denominator().evaluate(at));
  RC_ASSERT((a + b).evaluate(at) == *x + *y);
  RC_ASSERT((a * b).evaluate(at) == *x * *y);
  if (!y->is_zero()) RC_ASSERT((a / b).evaluate(at) == *x / *y);
}

RC_GTEST_PROP(RationalFunctionLaws, SubstitutionAgreesWithEvaluation,
              (const RationalFunction& a, const RationalFunction& by, const Rational& u, const Rational& v,
               const Rational& w)) {
  const Point at = {{"u", u}, {"v", v}, {"w", w}};
  const auto inner = by.evaluate(at);
  RC_PRE(inner.has_value());
  const auto expected = a.evaluate({{"u", u}, {"v", *inner}, {"w", w}});
  RC_PRE(expected.has_value());
  const RationalFunction composed = a.substitute("v", by);
  RC_ASSERT(composed.is_canonical());
  RC_ASSERT(composed.evaluate(at) == *expected);
}

RC_GTEST_PROP(RationalFunctionLaws, CommonDenominator,
              (const RationalFunction& a, const RationalFunction& b, const RationalFunction& c)) {
  const std::vector<RationalFunction> values = {a, b, c};
  const auto d = common_denominator(values);
  for (const auto& x : values) RC_ASSERT(RationalFunction::fraction(numerator_over(x, d), d.expanded()) == x);
  // The least one: it divides the product, and each denominator divides it.
  RC_ASSERT(Polynomial::quotient(a.denominator() * b.denominator() * c.denominator(), d.expanded()).has_value());
}

TEST(RationalFunctionText, Examples) {
  const auto text = [](const char* t) { return parse_rational_function(t).to_string(); };
  EXPECT_EQ(text("-1/(8*v*(v+1))"), "-1/(8*v*(v + 1))");
  EXPECT_EQ(text("(v^2-1)/(2*v-2)"), "(v + 1)/2");
  EXPECT_EQ(text("1/v^2"), "1/v^2");
  EXPECT_EQ(text("-v"), "-v");
  EXPECT_EQ(text("1-v"), "-(v - 1)");
  EXPECT_EQ(text("0.4"), "2/5");
  EXPECT_EQ(text("-(4*v+1)*(4*v^2+2*v-1)/(64*v^3*(v+1)^2)"), "-(4*v + 1)*(4*v^2 + 2*v - 1)/(64*v^3*(v + 1)^2)");
  EXPECT_EQ(text("v/v"), "1");
  EXPECT_EQ(text("v_s/v_t-v_s/v_t"), "0");
}

TEST(RationalFunctionText, LargeNumeratorsReadBack) {
  // Beyond the degree up to which numerators are factored, with either sign and with one term.
  for (const char* t : {"v^30", "-v^30", "-v^30/(v+1)", "(1-v^31)/(v+2)", "-(v^40-3)", "(3-v^40)/7", "-5*v^29/3"}) {
    const RationalFunction f = parse_rational_function(t);
    EXPECT_EQ(parse_rational_function(f.to_string()), f) << t;
  }
}

TEST(RationalFunction, Errors) {
  const RationalFunction v = RationalFunction::variable("v");
  EXPECT_THROW(v / RationalFunction(0), Error);
  EXPECT_THROW(RationalFunction(0).inverse(), Error);
  EXPECT_THROW(RationalFunction::fraction(Polynomial(1), Polynomial(0)), Error);
  EXPECT_THROW(RationalFunction::over_factors(Polynomial(1), Rational(0), {}), Error);
  EXPECT_THROW(v.inverse().substitute("v", 0), Error);
  EXPECT_FALSE(v.inverse().evaluate({{"v", 0}}).has_value());
  EXPECT_EQ((v / v).evaluate({}), Rational(1));
}

TEST(RationalFunction, Constants) {
  EXPECT_EQ(parse_rational_function("(v+1)/(2*v+2)").constant(), Rational(1, 2));
  EXPECT_EQ(RationalFunction(Rational(-3, 4)).constant(), Rational(-3, 4));
  EXPECT_FALSE(RationalFunction::variable("v").constant().has_value());
  EXPECT_EQ(RationalFunction(0).constant(), Rational(0));
  EXPECT_EQ(parse_rational_function("a/b").variables(), (std::vector<std::string>{"a", "b"}));
}

}  // namespace
}  // namespace twoscale::tests
