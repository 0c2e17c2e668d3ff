// SPDX-License-Identifier: GPL-3.0-or-later
/// Exact constants: signs decided, zeros proved, enclosures that enclose, decimals that are right.
#include "twoscale/symbolic/exact_real.hpp"

#include "support/laws.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale {

inline void PrintTo(Sign s, std::ostream* out) {
  *out << (s == Sign::zero ? "zero" : s == Sign::positive ? "positive" : s == Sign::negative ? "negative" : "unknown");
}

namespace tests {
namespace {

using F = ExactReal::Function;

ExactReal root(long n) { return ExactReal(n).pow(Rational(1, 2)); }
ExactReal cosine(long p, long q) { return ExactReal::apply(F::cos, ExactReal(Rational(p, q)) * ExactReal::pi()); }
ExactReal sine(long p, long q) { return ExactReal::apply(F::sin, ExactReal(Rational(p, q)) * ExactReal::pi()); }

TEST(ExactRealSign, ProvesZeros) {
  EXPECT_EQ(((root(5) - 1) / 4 - cosine(2, 5)).sign(), Sign::zero);
  EXPECT_EQ((root(2) + root(3) - (ExactReal(5) + ExactReal(2) * root(6)).pow(Rational(1, 2))).sign(), Sign::zero);
  EXPECT_EQ((cosine(1, 7) - cosine(2, 7) + cosine(3, 7) - Rational(1, 2)).sign(), Sign::zero);
  EXPECT_EQ((sine(1, 6) - Rational(1, 2)).sign(), Sign::zero);
  EXPECT_EQ((cosine(1, 8).pow(2) + sine(1, 8).pow(2) - 1).sign(), Sign::zero);
  EXPECT_EQ((cosine(1, 9) * cosine(2, 9) * cosine(4, 9) - Rational(1, 8)).sign(), Sign::zero);
  EXPECT_EQ((ExactReal(2).pow(Rational(1, 3)) * ExactReal(4).pow(Rational(1, 3)) - 2).sign(), Sign::zero);
  EXPECT_EQ((root(2) * root(8) / 4 - 1).sign(), Sign::zero);
  EXPECT_EQ((cosine(1, 2)).sign(), Sign::zero);
  EXPECT_EQ((ExactReal(1) / root(2) - root(2) / 2).sign(), Sign::zero);
}

TEST(ExactRealSign, ZerosWrittenAsText) {
  for (const char* text :
       {"(sqrt(5)-1)/4-cos(2*pi/5)", "sqrt(2)+sqrt(3)-sqrt(5+2*sqrt(6))", "cos(pi/7)-cos(2*pi/7)+cos(3*pi/7)-1/2",
        "2^(1/3)*2^(2/3)-2", "8*cos(pi/9)^3-6*cos(pi/9)-1"}) {
    EXPECT_EQ(parse_real(text).sign(), Sign::zero) << text;
    EXPECT_EQ(parse_real(text).decimal(30), "0") << text;
  }
}

TEST(ExactRealSign, SeesThroughNearZeros) {
  // (a - sqrt(a^2 - 1)) is about 1/(2a).
  const ExactReal a = Rational(10).pow(60);
  const ExactReal x = a - (a * a - 1).pow(Rational(1, 2));
  EXPECT_EQ(x.sign(), Sign::positive);
  EXPECT_EQ((x - ExactReal(1) / (ExactReal(2) * a)).sign(), Sign::positive);
  EXPECT_EQ((ExactReal(1) / (ExactReal(2) * a) - x).sign(), Sign::negative);
  // A convergent of pi; a Pisot number's power is nearly an integer: ((1+sqrt5)/2)^200 - L_200 = ((sqrt5-1)/2)^200.
  EXPECT_EQ((ExactReal::pi() - Rational(355, 113)).sign(), Sign::negative);
  const ExactReal golden = (root(5) + 1) / 2;
  Rational lucas = 3, before = 1;  // L_2, L_1
  for (int n = 3; n <= 200; ++n) std::tie(lucas, before) = std::pair(lucas + before, lucas);
  EXPECT_EQ((ExactReal(lucas) - golden.pow(200)).sign(), Sign::positive);
  EXPECT_EQ((golden.pow(200) - ExactReal(lucas) + ((root(5) - 1) / 2).pow(200)).sign(), Sign::zero);
}

TEST(ExactRealSign, Transcendental) {
  EXPECT_EQ((ExactReal::apply(F::exp, ExactReal::pi()) - ExactReal::pi() - 20).sign(),
            Sign::negative);  // 19.9990999...
  // Ramanujan: exp(pi sqrt(163)) is 7.5e-13 below an integer.
  const ExactReal r = ExactReal::apply(F::exp, ExactReal::pi() * root(163)) - Rational::parse("262537412640768744");
  EXPECT_EQ(r.sign(), Sign::negative);
  EXPECT_EQ((r + Rational(1, 1000000000000)).sign(), Sign::positive);
  // cosh^2 - sinh^2 - 1 is 0 but no separation bound is known: undecided, and quickly, never a wrong sign.
  const ExactReal x = Rational(3, 5);
  const ExactReal zero = ExactReal::apply(F::cosh, x).pow(2) - ExactReal::apply(F::sinh, x).pow(2) - 1;
  EXPECT_EQ(zero.sign(4096), Sign::unknown);
  EXPECT_EQ((zero + Rational(2).pow(-3000)).sign(), Sign::positive);
}

TEST(ExactRealSign, NoValueIsNoSign) {
  EXPECT_EQ((ExactReal(1) / (root(2).pow(2) - 2)).sign(256), Sign::unknown);
  EXPECT_EQ(ExactReal::apply(F::log, ExactReal(-1)).sign(256), Sign::unknown);
  EXPECT_EQ(ExactReal::apply(F::acosh, ExactReal(Rational(1, 2))).sign(256), Sign::unknown);
}

LAW(ExactRealSign, RationalArithmetic, (const Rational& a, const Rational& b)) {
  const auto expected = [](const Rational& q) {
    return q.is_zero() ? Sign::zero : q.sign() > 0 ? Sign::positive : Sign::negative;
  };
  // Through square roots, so that nothing folds: sqrt(a^2 + 1)^2 = a^2 + 1.
  const ExactReal x = (ExactReal(a) * a + 1).pow(Rational(1, 2)).pow(2);
  LAW_ASSERT((x - (ExactReal(b) * b + 1)).sign() == expected(a * a - b * b));
  LAW_ASSERT((ExactReal(a) - b).sign() == expected(a - b));
}

LAW(ExactRealSign, RandomIdentitiesOfCosines, ()) {
  const long q = uniform(1L, 30L);
  const long a = uniform(-60L, 60L);
  const long b = uniform(-60L, 60L);
  // 2 cos A cos B = cos(A+B) + cos(A-B)
  const ExactReal identity = ExactReal(2) * cosine(a, q) * cosine(b, q) - cosine(a + b, q) - cosine(a - b, q);
  LAW_ASSERT(identity.sign() == Sign::zero);
  LAW_ASSERT((identity + Rational(2).pow(-200)).sign() == Sign::positive);
}

TEST(ExactReal, EnclosuresContainTheValue) {
  struct Case {
    const char* expression;
    const char* low;  // truncated decimals, one unit in the last place apart
    const char* high;
  };
  for (const Case& c : {Case{"pi", "314159265358979323846", "314159265358979323847"},
                        Case{"exp(1)", "271828182845904523536", "271828182845904523537"},
                        Case{"sqrt(2)", "141421356237309504880", "141421356237309504881"},
                        Case{"cosh(1)", "154308063481524377847", "154308063481524377848"},
                        Case{"4*atan(1)", "314159265358979323846", "314159265358979323847"},
                        Case{"acosh(2)", "131695789692481670862", "131695789692481670863"},
                        Case{"2^(3/2)", "282842712474619009760", "282842712474619009761"},
                        Case{"log(10)", "230258509299404568401", "230258509299404568402"}})
    for (const long bits : {20L, 64L, 200L}) {
      const Rational unit = Rational(10).pow(-20);
      const Ball b = parse_real(c.expression).enclose(bits);
      Ball low(Rational::parse(c.low) * unit, 300);
      Ball high(Rational::parse(c.high) * unit, 300);
      Ball hull;
      arb_union(hull.raw(), low.raw(), high.raw(), 300);
      EXPECT_TRUE(arb_overlaps(hull.raw(), b.raw())) << c.expression << " at " << bits;
    }
}

TEST(ExactReal, Decimals) {
  EXPECT_EQ(parse_real("pi").decimal(50), "3.1415926535897932384626433832795028841971693993751");
  EXPECT_EQ(parse_real("-pi").decimal(5), "-3.1416");
  EXPECT_EQ(parse_real("cos(2*pi/5)").decimal(20), "0.30901699437494742410");
  EXPECT_EQ(parse_real("1/3").decimal(5), "0.33333");
  EXPECT_EQ(parse_real("2/3").decimal(5), "0.66667");
  EXPECT_EQ(parse_real("0.15").decimal(1), "0.2");  // a tie, away from zero
  EXPECT_EQ(parse_real("-0.25").decimal(1), "-0.3");
  EXPECT_EQ(parse_real("exp(100)").decimal(6), "2.68812e43");
  EXPECT_EQ(parse_real("exp(-100)").decimal(6), "3.72008e-44");
  EXPECT_EQ(parse_real("sqrt(2)*10^20").decimal(3), "141000000000000000000");
  EXPECT_EQ(parse_real("sqrt(4)").decimal(30), "2");
}

TEST(ExactReal, UndecidedDecimalIsAnErrorNotAGuess) {
  // A zero that cannot be proved has no leading digit.
  const ExactReal x = Rational(3, 5);
  const ExactReal zero = ExactReal::apply(F::cosh, x).pow(2) - ExactReal::apply(F::sinh, x).pow(2) - 1;
  try {
    zero.decimal(10);
    FAIL() << "printed " << zero.decimal(10);
  } catch (const Error& e) {
    EXPECT_EQ(e.kind, Error::Kind::undecided);
  }
}

TEST(ExactReal, RecognisesItsForm) {
  EXPECT_EQ(parse_real("2*pi/7").multiple_of_pi(), Rational(2, 7));
  EXPECT_EQ((ExactReal::pi() * Rational(3) / ExactReal(4) - ExactReal::pi()).multiple_of_pi(), Rational(-1, 4));
  EXPECT_FALSE(parse_real("pi^2").multiple_of_pi().has_value());
  EXPECT_FALSE(parse_real("pi+1").multiple_of_pi().has_value());
  EXPECT_EQ(parse_real("cosh(3/5)").argument_of(F::cosh).value().rational(), Rational(3, 5));
  EXPECT_FALSE(parse_real("cosh(3/5)").argument_of(F::cos).has_value());
  EXPECT_EQ(parse_real("0.4").rational(), Rational(2, 5));
  EXPECT_EQ(ExactReal(Rational(9, 4)).pow(Rational(1, 2)).rational(), Rational(3, 2));
}

}  // namespace
}  // namespace tests
}  // namespace twoscale
