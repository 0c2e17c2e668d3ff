// SPDX-License-Identifier: GPL-3.0-or-later
/// RationalFunction: field laws, one form for one function, text that reads back, evaluation.
#include "twoscale/symbolic/rational_function.hpp"

#include "support/laws.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::tests {
namespace {

using Point = std::vector<std::pair<std::string, Rational>>;

LAW(RationalFunctionLaws, Field, (const RationalFunction& a, const RationalFunction& b, const RationalFunction& c)) {
  LAW_ASSERT((a + b) + c == a + (b + c));
  LAW_ASSERT((a * b) * c == a * (b * c));
  LAW_ASSERT(a * (b + c) == a * b + a * c);
  LAW_ASSERT(a + b == b + a);
  LAW_ASSERT(a * b == b * a);
  LAW_ASSERT((a - b) + b == a);
  LAW_ASSERT((a - a).is_zero());
  if (!b.is_zero()) {
    LAW_ASSERT((a / b) * b == a);
    LAW_ASSERT((b * b.inverse()).is_one());
    LAW_ASSERT(b.inverse().inverse() == b);
    LAW_ASSERT(b.pow(-2) * b.pow(3) == b);
  }
}

LAW(RationalFunctionLaws, CanonicalAfterEveryOperation, (const RationalFunction& a, const RationalFunction& b)) {
  LAW_ASSERT(a.is_canonical());
  LAW_ASSERT((a + b).is_canonical());
  LAW_ASSERT((a - b).is_canonical());
  LAW_ASSERT((a * b).is_canonical());
  LAW_ASSERT((-a).is_canonical());
  LAW_ASSERT((a - a).is_canonical());
  LAW_ASSERT(a.pow(3).is_canonical());
  LAW_ASSERT(a.pow(0).is_canonical());
  if (!b.is_zero()) {
    LAW_ASSERT((a / b).is_canonical());
    LAW_ASSERT(b.inverse().is_canonical());
    LAW_ASSERT(b.pow(-2).is_canonical());
  }
}

/// The same function by another way: both forms are then the same.
LAW(RationalFunctionLaws, EqualFunctionsHaveOneForm, (const Polynomial& a, const Polynomial& b, const Polynomial& c)) {
  LAW_GIVEN(!b.is_zero() && !c.is_zero());
  const RationalFunction x = RationalFunction::fraction(a, b);
  const RationalFunction y = RationalFunction::fraction(a * c, b * c);
  const RationalFunction z = RationalFunction(a) / RationalFunction(b);
  const RationalFunction w = RationalFunction::fraction(-a, -b);
  for (const auto& other : {y, z, w}) {
    LAW_ASSERT(x == other);
    LAW_ASSERT(x.numerator() == other.numerator());
    LAW_ASSERT(x.denominator() == other.denominator());
    LAW_ASSERT(x.to_string() == other.to_string());
  }
  LAW_ASSERT(x.denominator() * a == x.numerator() * b);  // cross-multiplied
}

LAW(RationalFunctionLaws, DifferentFunctionsDiffer, (const RationalFunction& a, const RationalFunction& b)) {
  const bool same = a.numerator() * b.denominator() == b.numerator() * a.denominator();
  LAW_ASSERT((a == b) == same);
  LAW_ASSERT((a - b).is_zero() == same);
}

LAW(RationalFunctionLaws, FactorsMayBeGivenInAnyOrder, (const Polynomial& a, const Polynomial& b)) {
  LAW_GIVEN(!b.is_zero());
  auto f = b.factor();
  std::reverse(f.factors.begin(), f.factors.end());
  const RationalFunction x = RationalFunction::over_factors(a, f.content / Rational(3), f.factors);
  LAW_ASSERT(x.is_canonical());
  LAW_ASSERT(x == RationalFunction(3) * RationalFunction::fraction(a, b));
}

LAW(RationalFunctionText, ReadsBackUnchanged, (const RationalFunction& a, const RationalFunction& b)) {
  for (const RationalFunction& f : {a, a * b, a - b}) {
    const std::string text = f.to_string();
    LAW_ASSERT(parse_rational_function(text) == f);
    LAW_ASSERT(parse_rational_function(text).to_string() == text);
  }
}

LAW(RationalFunctionLaws, EvaluationAgrees,
    (const RationalFunction& a, const RationalFunction& b, const Rational& u, const Rational& v, const Rational& w)) {
  const Point at = {{"u", u}, {"v", v}, {"w", w}};
  const auto x = a.evaluate(at);
  const auto y = b.evaluate(at);
  LAW_ASSERT(x.has_value() == !a.denominator().evaluate(at).is_zero());
  LAW_GIVEN(x.has_value() && y.has_value());
  LAW_ASSERT(*x == a.numerator().evaluate(at) / a.denominator().evaluate(at));
  LAW_ASSERT((a + b).evaluate(at) == *x + *y);
  LAW_ASSERT((a * b).evaluate(at) == *x * *y);
  if (!y->is_zero()) LAW_ASSERT((a / b).evaluate(at) == *x / *y);
}

LAW(RationalFunctionLaws, SubstitutionAgreesWithEvaluation,
    (const RationalFunction& a, const RationalFunction& by, const Rational& u, const Rational& v, const Rational& w)) {
  const Point at = {{"u", u}, {"v", v}, {"w", w}};
  const auto inner = by.evaluate(at);
  LAW_GIVEN(inner.has_value());
  const auto expected = a.evaluate({{"u", u}, {"v", *inner}, {"w", w}});
  LAW_GIVEN(expected.has_value());
  const RationalFunction composed = a.substitute("v", by);
  LAW_ASSERT(composed.is_canonical());
  LAW_ASSERT(composed.evaluate(at) == *expected);
}

LAW(RationalFunctionLaws, CommonDenominator,
    (const RationalFunction& a, const RationalFunction& b, const RationalFunction& c)) {
  const std::vector<RationalFunction> values = {a, b, c};
  const auto d = common_denominator(values);
  for (const auto& x : values) LAW_ASSERT(RationalFunction::fraction(numerator_over(x, d), d.expanded()) == x);
  // The least one: it divides the product, and each denominator divides it.
  LAW_ASSERT(Polynomial::quotient(a.denominator() * b.denominator() * c.denominator(), d.expanded()).has_value());
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
