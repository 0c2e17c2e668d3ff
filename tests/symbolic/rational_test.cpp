// SPDX-License-Identifier: GPL-3.0-or-later
/// Rational: a field with an order; its text; gcd and binomials.
#include "twoscale/symbolic/rational.hpp"

#include "support/laws.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::tests {
namespace {

LAW(RationalLaws, Field, (const Rational& a, const Rational& b, const Rational& c)) {
  LAW_ASSERT((a + b) + c == a + (b + c));
  LAW_ASSERT((a * b) * c == a * (b * c));
  LAW_ASSERT(a * (b + c) == a * b + a * c);
  LAW_ASSERT(a + b == b + a);
  LAW_ASSERT(a * b == b * a);
  LAW_ASSERT((a - b) + b == a);
  LAW_ASSERT((a + (-a)).is_zero());
  if (!b.is_zero()) {
    LAW_ASSERT((a / b) * b == a);
    LAW_ASSERT(b * b.inverse() == Rational(1));
    LAW_ASSERT(b.pow(-3) * b.pow(5) == b * b);
  }
}

LAW(RationalLaws, Order, (const Rational& a, const Rational& b, const Rational& c)) {
  LAW_ASSERT((a < b) == ((b - a).sign() > 0));
  LAW_ASSERT((a == b) == (a - b).is_zero());
  if (a < b) LAW_ASSERT(a + c < b + c);
  LAW_ASSERT(abs(a) >= Rational(0));
  LAW_ASSERT((abs(a) == a || abs(a) == -a));
}

LAW(RationalLaws, TextReadsBack, (const Rational& a)) { LAW_ASSERT(Rational::parse(a.to_string()) == a); }

LAW(RationalLaws, GcdMakesIntegers, (const Rational& a, const Rational& b)) {
  const Rational g = gcd(a, b);
  if (a.is_zero() && b.is_zero()) {
    LAW_ASSERT(g.is_zero());
    return;
  }
  LAW_ASSERT(g.sign() > 0);
  LAW_ASSERT((a / g).is_integer());
  LAW_ASSERT((b / g).is_integer());
  LAW_ASSERT(gcd(a / g, b / g) == Rational(1));  // no larger one
}

TEST(Rational, IsInLowestTerms) {
  EXPECT_EQ(Rational(6, -4).to_string(), "-3/2");
  EXPECT_EQ(Rational(0, -7).to_string(), "0");
  EXPECT_EQ(Rational::parse("-00012/8").to_string(), "-3/2");
  EXPECT_EQ(Rational(-8, 4).to_string(), "-2");
}

TEST(Rational, ReadsNothingElse) {
  for (const char* text :
       {"", "-", "+1", "1.5", "1/", "/2", "1/-2", "1 /2", " 1", "1e3", "0x10", "1/2/3", "--1", "1/0", "0/0"})
    EXPECT_THROW(Rational::parse(text), Error) << "'" << text << "'";
}

TEST(Rational, DivisionByZeroIsAnError) {
  EXPECT_THROW(Rational(1) / Rational(0), Error);
  EXPECT_THROW(Rational(0).inverse(), Error);
  EXPECT_THROW(Rational(0).pow(-1), Error);
  EXPECT_THROW(Rational(1, 0), Error);
  EXPECT_EQ(Rational(0).pow(0), Rational(1));
}

TEST(Rational, ToLongRefusesWhatDoesNotFit) {
  EXPECT_EQ(Rational(-7).to_long(), -7);
  EXPECT_THROW(Rational(1, 2).to_long(), Error);
  EXPECT_THROW(Rational(2).pow(64).to_long(), Error);
}

TEST(Rational, GeneralisedBinomials) {
  // Pascal's rule for any upper argument; (1 + x)^{-1/2} squared is 1/(1 + x).
  for (const Rational& n : {Rational(5), Rational(-1, 2), Rational(7, 3), Rational(0)})
    for (unsigned k = 1; k < 8; ++k)
      EXPECT_EQ(Rational::binomial(n + Rational(1), k), Rational::binomial(n, k) + Rational::binomial(n, k - 1));
  for (unsigned n = 0; n < 10; ++n) {
    Rational sum;
    for (unsigned k = 0; k <= n; ++k)
      sum += Rational::binomial(Rational(-1, 2), k) * Rational::binomial(Rational(-1, 2), n - k);
    EXPECT_EQ(sum, Rational(n % 2 == 0 ? 1 : -1));
  }
  EXPECT_EQ(Rational::binomial(Rational(30), 15), Rational(155117520));
}

}  // namespace
}  // namespace twoscale::tests
