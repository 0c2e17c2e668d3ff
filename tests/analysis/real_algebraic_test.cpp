// SPDX-License-Identifier: GPL-3.0-or-later
// Real algebraic numbers: zeros, order, roots, enclosures and expressions, on known numbers and as laws.
#include "twoscale/analysis/real_algebraic.hpp"

#include <cmath>

#include "support/laws.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::analysis {
namespace {

Polynomial in_x(const std::string& text) { return parse_rational_function(text).numerator(); }

std::vector<RealAlgebraic> zeros(const std::string& text) { return RealAlgebraic::zeros(in_x(text)); }

double value(const RealAlgebraic& a, double slack = 1e-12) {
  RealAlgebraic fine = a;
  fine.refine(Rational(1, 1L << 50));
  const double low = fmpq_get_d(fine.lower().raw()), high = fmpq_get_d(fine.upper().raw());
  EXPECT_LE(low - slack, a.estimate());
  EXPECT_GE(high + slack, a.estimate());
  return (low + high) / 2;
}

// A polynomial in x of degree 1 to 5.
Polynomial random_polynomial() {
  std::vector<Rational> c = several(uniform<size_t>(1, 6), [] { return Rational(uniform(-6L, 7L)); });
  c.emplace_back(1);
  return Polynomial::univariate("x", c);
}

RealAlgebraic random_number() {
  const auto list = RealAlgebraic::zeros(random_polynomial());
  const auto which = uniform<size_t>(0, 5);
  return which < list.size() ? list[which] : RealAlgebraic(Rational(7, 3));
}

TEST(RealAlgebraic, KnownZeros) {
  const auto golden = zeros("x^2-x-1");
  ASSERT_EQ(golden.size(), 2U);
  EXPECT_NEAR(value(golden[0]), (1 - std::sqrt(5)) / 2, 1e-14);
  EXPECT_NEAR(value(golden[1]), (1 + std::sqrt(5)) / 2, 1e-14);
  EXPECT_EQ(golden[1].polynomial(), in_x("x^2-x-1"));
  EXPECT_EQ(golden[1].degree(), 2);
  EXPECT_FALSE(golden[1].rational());
  EXPECT_EQ(zeros("x^2+1").size(), 0U);
  EXPECT_EQ(zeros("(x-1)^3*(x+2)^2*(2*x-1)").size(), 3U);
  EXPECT_EQ(zeros("(x-1)^3*(x+2)^2*(2*x-1)")[1].rational(), Rational(1, 2));
  EXPECT_EQ(zeros("x^5"), std::vector<RealAlgebraic>{Rational(0)});
  EXPECT_TRUE(zeros("7").empty());
  // Wilkinson: twenty zeros a distance 1 apart, large coefficients.
  Polynomial wilkinson = 1;
  for (int i = 1; i <= 20; ++i) wilkinson *= Polynomial::variable("x") - Polynomial(i);
  const auto twenty = RealAlgebraic::zeros(wilkinson);
  ASSERT_EQ(twenty.size(), 20U);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(twenty[static_cast<size_t>(i)].rational(), Rational(i + 1));
  // Mignotte: two zeros about 10^-17 apart.
  const auto near = zeros("x^9-2*(1000*x-1)^2");
  ASSERT_EQ(near.size(), 3U);
  EXPECT_LT(RealAlgebraic::compare(near[0], near[1]), 0);
  EXPECT_LT(RealAlgebraic::compare(near[0], Rational(1, 1000)), 0);
  EXPECT_GT(RealAlgebraic::compare(near[1], Rational(1, 1000)), 0);
}

TEST(RealAlgebraic, EqualOnlyIfTheSameNumber) {
  EXPECT_EQ(zeros("x^2-2")[1], zeros("(x^2-2)*(x^2-3)")[2]);
  EXPECT_FALSE(zeros("x^2-2")[1] == zeros("x^2-2")[0]);
  // 1.41421356237 is close to sqrt(2) and another number.
  const RealAlgebraic near = Rational(141421356237, 100000000000);
  EXPECT_EQ(RealAlgebraic::compare(zeros("x^2-2")[1], near), 1);
  EXPECT_EQ(RealAlgebraic::compare(near, zeros("x^2-2")[1]), -1);
  EXPECT_EQ(RealAlgebraic(Rational(3, 6)), RealAlgebraic(Rational(1, 2)));
}

TEST(RealAlgebraic, RootsOfModuli) {
  EXPECT_EQ(RealAlgebraic(Rational(-8)).root_of_modulus(3).rational(), Rational(2));
  EXPECT_EQ(RealAlgebraic(Rational(2)).root_of_modulus(2), zeros("x^2-2")[1]);
  EXPECT_EQ(zeros("x^2-x-1")[0].root_of_modulus(1), zeros("x^2+x-1")[1]);
  // (3 + sqrt(5))/2 = golden^2
  EXPECT_EQ(zeros("x^2-3*x+1")[1].root_of_modulus(2), zeros("x^2-x-1")[1]);
  EXPECT_EQ(RealAlgebraic(Rational(1024)).root_of_modulus(10).rational(), Rational(2));
}

TEST(RealAlgebraic, Expressions) {
  EXPECT_EQ(RealAlgebraic(Rational(-3, 7)).expression(), "-3/7");
  EXPECT_EQ(RealAlgebraic(Rational(2)).root_of_modulus(5).expression(), "(2)^(1/5)");
  EXPECT_FALSE(zeros("x^3-x-1")[0].expression());
  for (const char* p : {"x^2-x-1", "3*x^2-7*x+1", "x^2-8", "4*x^2-5"})
    for (const auto& z : zeros(p)) {
      const auto text = z.expression();
      ASSERT_TRUE(text);
      EXPECT_NE(text->find("sqrt("), std::string::npos) << *text;
    }
  EXPECT_EQ(zeros("x^2-8")[1].expression(), "2*sqrt(2)");
  EXPECT_EQ(zeros("x^2-x-1")[1].expression(), "1/2 + sqrt(5)/2");
  EXPECT_EQ(zeros("x^2-x-1")[0].expression(), "1/2 - sqrt(5)/2");
}

TEST(RealAlgebraic, BetweenTwo) {
  const auto two = zeros("x^2-2")[1];
  for (const auto& [a, b] : {std::pair<RealAlgebraic, RealAlgebraic>{Rational(0), Rational(1)},
                             {two, Rational(3, 2)},
                             {Rational(141421356237, 100000000000), two},
                             {Rational(-5), Rational(5)},
                             {Rational(1, 3), Rational(1, 2)}}) {
    const Rational m = rational_between(a, b);
    EXPECT_LT(RealAlgebraic::compare(a, m), 0);
    EXPECT_LT(RealAlgebraic::compare(m, b), 0);
    EXPECT_TRUE(fmpz_popcnt(m.denominator()) == 1) << m.to_string();
  }
  EXPECT_EQ(rational_between(Rational(1, 3), Rational(2, 3)), Rational(1, 2));
}

LAW(RealAlgebraicLaws, ZerosAreZerosAndAscend, ()) {
  const Polynomial p = random_polynomial();
  const auto list = RealAlgebraic::zeros(p);
  for (size_t i = 0; i < list.size(); ++i) {
    LAW_ASSERT(Polynomial::quotient(p, list[i].polynomial()).has_value());
    if (i > 0) LAW_ASSERT(RealAlgebraic::compare(list[i - 1], list[i]) < 0);
    if (const auto q = list[i].rational()) {
      LAW_ASSERT(sign_at(p, *q) == 0);
    } else {
      LAW_ASSERT(sign_at(list[i].polynomial(), list[i].lower()) * sign_at(list[i].polynomial(), list[i].upper()) < 0);
    }
  }
  // As many positive ones as Sturm counts.
  const auto positive = std::count_if(list.begin(), list.end(), [](const RealAlgebraic& z) { return z.sign() > 0; });
  LAW_ASSERT(positive == p.positive_zeros());
}

LAW(RealAlgebraicLaws, ARefinedNumberIsTheSame, ()) {
  const RealAlgebraic a = random_number();
  RealAlgebraic b = a;
  b.refine(Rational(1, 1L << 60));
  LAW_ASSERT(a == b);
  LAW_ASSERT(b.upper() - b.lower() <= Rational(1, 1L << 60));
  LAW_ASSERT(a.lower() <= b.lower() && b.upper() <= a.upper());
  LAW_ASSERT(std::abs(a.estimate() - b.estimate()) <= 1e-12 * (1 + std::abs(a.estimate())));
  const Ball ball = a.enclose(80);
  arf_t end;
  arf_init(end);
  Rational low, high;
  arb_get_lbound_arf(end, ball.raw(), 200);
  arf_get_fmpq(low.raw(), end);
  arb_get_ubound_arf(end, ball.raw(), 200);
  arf_get_fmpq(high.raw(), end);
  arf_clear(end);
  LAW_ASSERT(RealAlgebraic::compare(low, a) <= 0);
  LAW_ASSERT(RealAlgebraic::compare(a, high) <= 0);
  LAW_ASSERT(high - low <= Rational(1, 1L << 60) * (Rational(1) + abs(high)));
}

LAW(RealAlgebraicLaws, TheOrderIsTotal, ()) {
  const RealAlgebraic a = random_number(), b = random_number(), c = random_number();
  const int ab = RealAlgebraic::compare(a, b);
  LAW_ASSERT(ab == -RealAlgebraic::compare(b, a));
  LAW_ASSERT((ab == 0) == (a == b));
  LAW_ASSERT(RealAlgebraic::compare(a, a) == 0);
  if (ab <= 0 && RealAlgebraic::compare(b, c) <= 0) LAW_ASSERT(RealAlgebraic::compare(a, c) <= 0);
  LAW_ASSERT(a.sign() == RealAlgebraic::compare(a, Rational(0)));
  if (std::abs(a.estimate() - b.estimate()) > 1e-9) LAW_ASSERT(ab == (a.estimate() > b.estimate() ? 1 : -1));
}

LAW(RealAlgebraicLaws, ARootToItsPowerIsTheModulus, ()) {
  const RealAlgebraic a = random_number();
  LAW_GIVEN(a.sign() != 0);
  const unsigned n = uniform(1U, 5U);
  const RealAlgebraic r = a.root_of_modulus(n);
  LAW_ASSERT(r.sign() > 0);
  LAW_ASSERT(std::abs(std::pow(r.estimate(), n) - std::abs(a.estimate())) <= 1e-10 * (1 + std::abs(a.estimate())));
  // r^n = |a|: the polynomial of |a| at x^n is a multiple of that of r.
  Polynomial at_power = a.sign() > 0 ? a.polynomial() : a.polynomial().substitute("x", -Polynomial::variable("x"));
  at_power = at_power.substitute("x", Polynomial::variable("x").pow(n));
  LAW_ASSERT(Polynomial::quotient(at_power, r.polynomial()).has_value());
  // Roots keep the order of positive numbers.
  const RealAlgebraic b = random_number();
  if (a.sign() > 0 && b.sign() > 0)
    LAW_ASSERT(RealAlgebraic::compare(a, b) == RealAlgebraic::compare(r, b.root_of_modulus(n)));
}

LAW(RealAlgebraicLaws, SignsAtRationals, ()) {
  const Polynomial p = random_polynomial();
  const Rational q(uniform(-20L, 21L), uniform(1L, 9L));
  LAW_ASSERT(sign_at(p, q) == p.evaluate({{"x", q}}).sign());
  // The sign changes at zeros of odd multiplicity only: count those to the right.
  long changes = 0;
  for (const auto& z : RealAlgebraic::zeros(p))
    if (RealAlgebraic::compare(z, q) > 0) changes += p.remove(z.polynomial()).second;
  if (sign_at(p, q) != 0) LAW_ASSERT(sign_at(p, q) == p.leading_sign() * (changes % 2 == 0 ? 1 : -1));
}

LAW(RealAlgebraicLaws, SomethingIsBetween, ()) {
  const RealAlgebraic a = random_number(), b = random_number();
  const int order = RealAlgebraic::compare(a, b);
  LAW_GIVEN(order != 0);
  const RealAlgebraic& low = order < 0 ? a : b;
  const RealAlgebraic& high = order < 0 ? b : a;
  const Rational m = rational_between(low, high);
  LAW_ASSERT(RealAlgebraic::compare(low, m) < 0);
  LAW_ASSERT(RealAlgebraic::compare(m, high) < 0);
}

}  // namespace
}  // namespace twoscale::analysis
