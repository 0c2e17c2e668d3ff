// SPDX-License-Identifier: GPL-3.0-or-later
/// Laurent polynomials over rational functions: ring laws, sub-symbols, division, centre of symmetry.
#include "twoscale/symbolic/laurent.hpp"

#include "symbolic/generators.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::tests {
namespace {

RationalFunction rf(const char* text) { return parse_rational_function(text); }

RC_GTEST_PROP(LaurentLaws, Ring, (const Laurent& a, const Laurent& b, const Laurent& c)) {
  RC_ASSERT((a + b) + c == a + (b + c));
  RC_ASSERT((a * b) * c == a * (b * c));
  RC_ASSERT(a * (b + c) == a * b + a * c);
  RC_ASSERT(a + b == b + a);
  RC_ASSERT(a * b == b * a);
  RC_ASSERT((a - a).is_zero());
  RC_ASSERT(a * Laurent::monomial(0) == a);
  RC_ASSERT(rf("v/(v+3)") * a == Laurent::monomial(0, rf("v/(v+3)")) * a);
  for (const Laurent& x : {a, a + b, a - b, a * b, a - a, (a + b) - b}) RC_ASSERT(x.is_canonical());
  RC_ASSERT((a + b) - b == a);
}

RC_GTEST_PROP(LaurentLaws, CoefficientsOfAProductAreConvolutions, (const Laurent& a, const Laurent& b)) {
  const Laurent p = a * b;
  for (long i = a.lowest() + b.lowest(); i <= a.highest() + b.highest(); ++i) {
    RationalFunction sum;
    for (long j = a.lowest(); j <= a.highest(); ++j) sum += a.coefficient(j) * b.coefficient(i - j);
    RC_ASSERT(p.coefficient(i) == sum);
  }
}

RC_GTEST_PROP(LaurentLaws, EvaluationIsAHomomorphism, (const Laurent& a, const Laurent& b)) {
  for (const RationalFunction& z : {rf("1"), rf("-1"), rf("2/3"), rf("w")}) {
    RC_ASSERT((a + b).evaluate(z) == a.evaluate(z) + b.evaluate(z));
    RC_ASSERT((a * b).evaluate(z) == a.evaluate(z) * b.evaluate(z));
  }
  RC_ASSERT(a.at_one() == a.evaluate(1));
}

RC_GTEST_PROP(LaurentLaws, SubsymbolsReassemble, (const Laurent& a)) {
  for (const long m : {1L, 2L, 3L, 5L}) {
    Laurent sum;
    for (long r = 0; r < m; ++r) {
      const Laurent s = a.subsymbol(m, r);
      RC_ASSERT(s.is_canonical());
      for (long j = -6; j <= 6; ++j) RC_ASSERT(s.coefficient(j) == a.coefficient(m * j + r));
      sum = sum + s.dilated(m).shifted(r);
    }
    RC_ASSERT(sum == a);
  }
}

RC_GTEST_PROP(LaurentLaws, ShiftAndDilation, (const Laurent& a, const Laurent& b)) {
  RC_ASSERT(a.shifted(3) == Laurent::monomial(3) * a);
  RC_ASSERT(a.shifted(-4).shifted(4) == a);
  RC_ASSERT((a * b).dilated(3) == a.dilated(3) * b.dilated(3));
  RC_ASSERT(a.dilated(1) == a);
  RC_ASSERT(a.dilated(2).dilated(3) == a.dilated(6));
  RC_ASSERT(a.dilated(3).subsymbol(3, 0) == a);
  RC_ASSERT(a.dilated(3).subsymbol(3, 1).is_zero());
}

RC_GTEST_PROP(LaurentLaws, QuotientUndoesMultiplication, (const Laurent& a, const Laurent& b)) {
  RC_PRE(!b.is_zero());
  const auto q = Laurent::quotient(a * b, b);
  RC_ASSERT(q.has_value());
  RC_ASSERT(*q == a);
  if (b.coefficients().size() > 1) {
    RC_ASSERT(!Laurent::quotient(a * b + Laurent::monomial(7), b).has_value());
  }
}

RC_GTEST_PROP(LaurentLaws, Symmetry, (const Laurent& a)) {
  RC_PRE(!a.is_zero());
  std::vector<RationalFunction> c(a.coefficients().rbegin(), a.coefficients().rend());
  const Laurent mirror(-a.highest(), c);  // a(1/z)
  const auto centre = (a * mirror).centre_of_symmetry();
  RC_ASSERT(centre.has_value());
  RC_ASSERT(*centre == Rational(0));
  RC_ASSERT((a * mirror).shifted(5).centre_of_symmetry() == Rational(5));
  RC_ASSERT(a.centre_of_symmetry().has_value() == (mirror.shifted(a.lowest() + a.highest()) == a));
}

RC_GTEST_PROP(LaurentLaws, SubstitutionIsAHomomorphism, (const Laurent& a, const Laurent& b)) {
  const RationalFunction by = rf("1/(w^2+2)");
  RC_ASSERT((a * b).substitute("v", by) == a.substitute("v", by) * b.substitute("v", by));
  RC_ASSERT(a.substitute("w", by) == a);
}

TEST(Laurent, TrimsItsEnds) {
  const Laurent a(-3, {0, 0, 1, 0, 2, 0});
  EXPECT_EQ(a.lowest(), -1);
  EXPECT_EQ(a.highest(), 1);
  EXPECT_EQ(a.coefficients().size(), 3U);
  EXPECT_TRUE(a.coefficient(0).is_zero());
  EXPECT_TRUE(a.coefficient(100).is_zero());
  const Laurent zero(17, {0, 0});
  EXPECT_TRUE(zero.is_zero());
  EXPECT_EQ(zero.lowest(), 0);
  EXPECT_EQ(zero, Laurent());
  EXPECT_TRUE(zero.is_canonical());
}

TEST(Laurent, CentreMayBeAHalf) {
  EXPECT_EQ(Laurent(-1, {1, 3, 3, 1}).centre_of_symmetry(), Rational(1, 2));
  EXPECT_EQ(Laurent(2, {1, 4, 1}).centre_of_symmetry(), Rational(3));
  EXPECT_FALSE(Laurent(0, {1, 2}).centre_of_symmetry().has_value());
  EXPECT_FALSE(Laurent(0, {1, 2, -1}).centre_of_symmetry().has_value());
  EXPECT_EQ(Laurent(0, {rf("v"), 1, rf("v^2/v")}).centre_of_symmetry(), Rational(1));
}

TEST(Laurent, DivisionByZeroIsALogicError) {
  EXPECT_THROW(Laurent::quotient(Laurent::monomial(1), Laurent()), std::logic_error);
}

TEST(Laurent, VariablesOfAllCoefficients) {
  EXPECT_EQ(Laurent(0, {rf("v_t"), rf("1/v_s"), rf("w-w+1")}).variables(), (std::vector<std::string>{"v_s", "v_t"}));
}

}  // namespace
}  // namespace twoscale::tests
