// SPDX-License-Identifier: GPL-3.0-or-later
/// Laurent polynomials over rational functions: ring laws, sub-symbols, division, centre of symmetry.
#include "twoscale/symbolic/laurent.hpp"

#include "support/laws.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::tests {
namespace {

RationalFunction rf(const char* text) { return parse_rational_function(text); }

LAW(LaurentLaws, Ring, (const Laurent& a, const Laurent& b, const Laurent& c)) {
  LAW_ASSERT((a + b) + c == a + (b + c));
  LAW_ASSERT((a * b) * c == a * (b * c));
  LAW_ASSERT(a * (b + c) == a * b + a * c);
  LAW_ASSERT(a + b == b + a);
  LAW_ASSERT(a * b == b * a);
  LAW_ASSERT((a - a).is_zero());
  LAW_ASSERT(a * Laurent::monomial(0) == a);
  LAW_ASSERT(rf("v/(v+3)") * a == Laurent::monomial(0, rf("v/(v+3)")) * a);
  for (const Laurent& x : {a, a + b, a - b, a * b, a - a, (a + b) - b}) LAW_ASSERT(x.is_canonical());
  LAW_ASSERT((a + b) - b == a);
}

LAW(LaurentLaws, CoefficientsOfAProductAreConvolutions, (const Laurent& a, const Laurent& b)) {
  const Laurent p = a * b;
  for (long i = a.lowest() + b.lowest(); i <= a.highest() + b.highest(); ++i) {
    RationalFunction sum;
    for (long j = a.lowest(); j <= a.highest(); ++j) sum += a.coefficient(j) * b.coefficient(i - j);
    LAW_ASSERT(p.coefficient(i) == sum);
  }
}

LAW(LaurentLaws, EvaluationIsAHomomorphism, (const Laurent& a, const Laurent& b)) {
  for (const RationalFunction& z : {rf("1"), rf("-1"), rf("2/3"), rf("w")}) {
    LAW_ASSERT((a + b).evaluate(z) == a.evaluate(z) + b.evaluate(z));
    LAW_ASSERT((a * b).evaluate(z) == a.evaluate(z) * b.evaluate(z));
  }
  LAW_ASSERT(a.at_one() == a.evaluate(1));
}

LAW(LaurentLaws, SubsymbolsReassemble, (const Laurent& a)) {
  for (const long m : {1L, 2L, 3L, 5L}) {
    Laurent sum;
    for (long r = 0; r < m; ++r) {
      const Laurent s = a.subsymbol(m, r);
      LAW_ASSERT(s.is_canonical());
      for (long j = -6; j <= 6; ++j) LAW_ASSERT(s.coefficient(j) == a.coefficient(m * j + r));
      sum = sum + s.dilated(m).shifted(r);
    }
    LAW_ASSERT(sum == a);
  }
}

LAW(LaurentLaws, ShiftAndDilation, (const Laurent& a, const Laurent& b)) {
  LAW_ASSERT(a.shifted(3) == Laurent::monomial(3) * a);
  LAW_ASSERT(a.shifted(-4).shifted(4) == a);
  LAW_ASSERT((a * b).dilated(3) == a.dilated(3) * b.dilated(3));
  LAW_ASSERT(a.dilated(1) == a);
  LAW_ASSERT(a.dilated(2).dilated(3) == a.dilated(6));
  LAW_ASSERT(a.dilated(3).subsymbol(3, 0) == a);
  LAW_ASSERT(a.dilated(3).subsymbol(3, 1).is_zero());
}

LAW(LaurentLaws, QuotientUndoesMultiplication, (const Laurent& a, const Laurent& b)) {
  LAW_GIVEN(!b.is_zero());
  const auto q = Laurent::quotient(a * b, b);
  LAW_ASSERT(q.has_value());
  LAW_ASSERT(*q == a);
  if (b.coefficients().size() > 1) {
    LAW_ASSERT(!Laurent::quotient(a * b + Laurent::monomial(7), b).has_value());
  }
}

LAW(LaurentLaws, Symmetry, (const Laurent& a)) {
  LAW_GIVEN(!a.is_zero());
  std::vector<RationalFunction> c(a.coefficients().rbegin(), a.coefficients().rend());
  const Laurent mirror(-a.highest(), c);  // a(1/z)
  const auto centre = (a * mirror).centre_of_symmetry();
  LAW_ASSERT(centre.has_value());
  LAW_ASSERT(*centre == Rational(0));
  LAW_ASSERT((a * mirror).shifted(5).centre_of_symmetry() == Rational(5));
  LAW_ASSERT(a.centre_of_symmetry().has_value() == (mirror.shifted(a.lowest() + a.highest()) == a));
}

LAW(LaurentLaws, SubstitutionIsAHomomorphism, (const Laurent& a, const Laurent& b)) {
  const RationalFunction by = rf("1/(w^2+2)");
  LAW_ASSERT((a * b).substitute("v", by) == a.substitute("v", by) * b.substitute("v", by));
  LAW_ASSERT(a.substitute("w", by) == a);
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
