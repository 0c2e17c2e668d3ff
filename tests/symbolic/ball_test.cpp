// SPDX-License-Identifier: GPL-3.0-or-later
/// Decimals and doubles out of enclosures: every digit right, against long division done by hand.
#include "twoscale/symbolic/ball.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>

#include "support/laws.hpp"

namespace twoscale::tests {
namespace {

struct Digits {
  std::string text;  // without point; as many as asked for
  long exponent;     // of the first digit
};

/// School long division with rounding half away from zero; x > 0.
Digits long_division(Rational x, long digits) {
  Digits r{"", 0};
  while (x >= Rational(10)) x /= Rational(10), ++r.exponent;
  while (x < Rational(1)) x *= Rational(10), --r.exponent;
  for (long i = 0; i < digits; ++i) {
    char d = '0';
    while (x >= Rational(1)) x -= Rational(1), ++d;
    r.text += d;
    x *= Rational(10);
  }
  if (x >= Rational(5)) {
    long i = digits - 1;
    while (i >= 0 && r.text[static_cast<size_t>(i)] == '9') r.text[static_cast<size_t>(i--)] = '0';
    if (i >= 0)
      ++r.text[static_cast<size_t>(i)];
    else
      r.text.insert(0, "1"), r.text.pop_back(), ++r.exponent;
  }
  return r;
}

/// Digits and exponent of a printed number, filled up with zeros.
Digits read(std::string s, long digits) {
  Digits r{"", 0};
  const auto e = s.find('e');
  if (e != std::string::npos) {
    r.exponent = std::stol(s.substr(e + 1));
    s.resize(e);
  }
  if (s[0] == '-') s.erase(0, 1);
  const auto point = s.find('.');
  const std::string whole = s.substr(0, point);
  std::string all = whole + (point == std::string::npos ? "" : s.substr(point + 1));
  r.exponent += static_cast<long>(whole.size()) - 1;
  while (all.size() > 1 && all[0] == '0') all.erase(0, 1), --r.exponent;
  r.text = all.substr(0, static_cast<size_t>(digits));
  // What stands beyond the digits asked for fills up an integer.
  EXPECT_EQ(all.find_first_not_of('0', static_cast<size_t>(digits)), std::string::npos) << s;
  r.text.resize(static_cast<size_t>(digits), '0');
  return r;
}

void expect_correct(const Rational& x, long digits, const std::string& text) {
  ASSERT_FALSE(text.empty()) << x.to_string() << " to " << digits;
  if (x.is_zero()) {
    EXPECT_EQ(text, "0");
    return;
  }
  const Digits expected = long_division(abs(x), digits);
  const Digits got = read(text, digits);
  EXPECT_EQ(text[0] == '-', x.sign() < 0);
  EXPECT_EQ(got.text, expected.text) << x.to_string() << " printed as " << text;
  EXPECT_EQ(got.exponent, expected.exponent) << x.to_string() << " printed as " << text;
}

TEST(RoundedDecimal, CornersAgainstLongDivision) {
  std::vector<Rational> corners;
  for (long k = 1; k < 30; ++k) {
    const Rational ten = Rational(10).pow(k);
    corners.push_back(Rational(10) - ten.inverse());            // 9.99..9
    corners.push_back(Rational(10) - Rational(49, 100) / ten);  // 9.99..951
    corners.push_back(Rational(10) - Rational(1, 2) / ten);     // 9.99..95: a tie
    corners.push_back(Rational(1) - ten.inverse());
    corners.push_back(ten);
    corners.push_back(ten.inverse());
    corners.push_back(ten + Rational(1, 3));
    corners.push_back(Rational(1) + ten.inverse() / Rational(2));
  }
  for (const char* q :
       {"1/3", "2/3", "1/7", "22/7", "355/113", "999999/1000000", "1000001/1000000", "1/1024", "3/20", "5/2", "7/2",
        "25", "35", "45", "149/10", "15/100", "123456789123456789123456789", "1/987654321987654321987654321"})
    corners.push_back(Rational::parse(q));
  for (const Rational& c : corners)
    for (const Rational& x : {c, -c})
      for (const long digits : {1L, 2L, 5L, 17L, 30L, 50L}) {
        expect_correct(x, digits, rounded_decimal(x, digits));
        const std::string enclosed = rounded_decimal(Ball(x, 4 * digits + 400), digits);
        // A ball may leave a tie open, nothing else.
        if (!enclosed.empty()) {
          expect_correct(x, digits, enclosed);
        } else {
          const Digits more = long_division(abs(x), digits + 40);
          EXPECT_EQ(more.text.substr(static_cast<size_t>(digits)), "5" + std::string(39, '0')) << x.to_string();
        }
      }
}

LAW(RoundedDecimal, RandomAgainstLongDivision, (const Rational& mantissa)) {
  const Rational x = mantissa * Rational(10).pow(uniform(-40L, 41L));
  const long digits = uniform(1L, 60L);
  expect_correct(x, digits, rounded_decimal(x, digits));
  const std::string enclosed = rounded_decimal(Ball(x, 1000), digits);
  if (!enclosed.empty()) expect_correct(x, digits, enclosed);
}

TEST(RoundedDecimal, HugeAndTiny) {
  for (const long k : {100L, 1000L, 5000L})
    for (const Rational& x : {Rational(2, 3) * Rational(10).pow(k), Rational(-2, 3) * Rational(10).pow(-k)}) {
      const std::string text = rounded_decimal(Ball(x, 4 * k + 200), 20);
      expect_correct(x, 20, text);
      EXPECT_NE(text.find('e'), std::string::npos);
    }
}

TEST(RoundedDecimal, ExactDyadicsAreShort) {
  EXPECT_EQ(rounded_decimal(Ball(Rational(1, 2), 64), 50), "0.5");
  EXPECT_EQ(rounded_decimal(Ball(Rational(-3, 256), 64), 50), "-0.01171875");
  EXPECT_EQ(rounded_decimal(Ball(Rational(1), 64), 50), "1");
  EXPECT_EQ(rounded_decimal(Ball(Rational(-1024), 64), 50), "-1024");
  EXPECT_EQ(rounded_decimal(Ball(Rational(0), 64), 50), "0");
  EXPECT_EQ(rounded_decimal(Rational(2, 5), 30), "0.4");
  EXPECT_EQ(rounded_decimal(Rational(999999, 1000000), 3), "1.00");  // rounded, so not short
}

TEST(RoundedDecimal, SaysWhenABallIsTooWide) {
  EXPECT_EQ(rounded_decimal(Ball(Rational(1, 3), 30), 50), "");
  EXPECT_NE(rounded_decimal(Ball(Rational(1, 3), 30), 5), "");
  Ball wide(Rational(1, 3), 64);
  arb_add_error_2exp_si(wide.raw(), 0);
  EXPECT_EQ(rounded_decimal(wide, 1), "");
  EXPECT_TRUE(wide.contains_zero());
  Ball infinite;
  arb_zero_pm_inf(infinite.raw());
  EXPECT_EQ(rounded_decimal(infinite, 1), "");
}

TEST(RoundedDouble, AgreesWithTheCLibrary) {
  // strtod rounds correctly; decimals with few digits are the input of both.
  for (const char* text :
       {"0.1", "1e23", "9007199254740993", "2.2250738585072011e-308", "4.9e-324", "2.4703282292062327e-324",
        "2.4703282292062329e-324", "1.7976931348623157e308", "-0.3", "0.5", "123456789.123456789", "1e-5"}) {
    std::string s(text);
    long exponent = 0;
    if (const auto e = s.find('e'); e != std::string::npos) {
      exponent = std::stol(s.substr(e + 1));
      s.resize(e);
    }
    if (const auto p = s.find('.'); p != std::string::npos) {
      exponent -= static_cast<long>(s.size() - p - 1);
      s.erase(p, 1);
    }
    const Rational x = Rational::parse(s) * Rational(10).pow(exponent);
    double got = 0;
    ASSERT_TRUE(rounded_double(Ball(x, 2000), got)) << text;
    EXPECT_EQ(got, std::strtod(text, nullptr)) << text;
  }
}

TEST(RoundedDouble, TiesGoToEvenAndDoubtIsSaid) {
  double got = 0;
  const Rational tie = Rational(1) + Rational(2).pow(-53);
  ASSERT_TRUE(rounded_double(Ball(tie, 100), got));
  EXPECT_EQ(got, 1.0);
  ASSERT_TRUE(rounded_double(Ball(tie + Rational(2).pow(-80), 100), got));
  EXPECT_EQ(got, 1.0 + std::numeric_limits<double>::epsilon());
  Ball doubtful(tie, 100);
  arb_add_error_2exp_si(doubtful.raw(), -200);
  EXPECT_FALSE(rounded_double(doubtful, got));
}

LAW(Ball, ContainsWhatItWasMadeFrom, (const Rational& x)) {
  for (const long bits : {2L, 10L, 53L, 200L}) {
    const Ball b(x, bits);
    LAW_ASSERT(arb_contains_fmpq(b.raw(), x.raw()) != 0);
    LAW_ASSERT(b.is_exact_zero() == x.is_zero());
    if (b.is_positive()) LAW_ASSERT(x.sign() > 0);
    if (b.is_negative()) LAW_ASSERT(x.sign() < 0);
  }
}

}  // namespace
}  // namespace twoscale::tests
