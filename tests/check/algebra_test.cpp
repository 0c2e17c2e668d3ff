// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the checker: polynomials, Descartes, Sturm, cyclotomic polynomials, numbers.
#include "twoscale/check/cyclotomic.hpp"
#include "twoscale/check/exceptions.hpp"
#include "twoscale/check/number.hpp"
#include "twoscale/check/polynomial.hpp"
#include "twoscale/check/univariate.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <random>

namespace {

using namespace twoscale::check;

const std::vector<std::string> names{"u", "v_s", "v_t"};

Polynomial read(std::string_view text) {
  Meter meter;
  return parse_polynomial(text, names, "p", meter);
}

/// The canonical spelling, written once more.
std::string text_of(const Polynomial& p) {
  std::string out;
  for (const auto& [monomial, coefficient] : p) {
    std::string factors;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (monomial[i] != 0) factors += "*" + names[i] + (monomial[i] == 1 ? "" : "^" + std::to_string(monomial[i]));
    }
    std::string size = Integer(abs(coefficient)).str() + factors;
    if (!factors.empty() && abs(coefficient) == 1) size = factors.substr(1);
    out += (coefficient < 0 ? "-" : out.empty() ? "" : "+") + size;
  }
  return out.empty() ? "0" : out;
}

Polynomial multiply(const Polynomial& p, const Polynomial& q, Meter& meter) {
  Polynomial result;
  for (const auto& [monomial, coefficient] : q) add_scaled(result, p, coefficient, monomial, meter);
  return result;
}

Dense times(const Dense& p, const Dense& q) {
  Dense result(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) result[i + j] += p[i] * q[j];
  }
  return result;
}

TEST(Polynomial, CanonicalTextIsReadAndWritten) {
  for (const char* text :
       {"0", "1", "-1", "u", "-u", "u^2-u+1", "3*u^4096", "-u*v_s^2*v_t^3+17*v_s*v_t-v_t^2-12345678901234567890",
        "u*v_t+v_s^5", "2*u^2*v_s-2*u^2*v_t-7"}) {
    EXPECT_EQ(text_of(read(text)), text);
  }
}

TEST(Polynomial, AnyOtherSpellingIsRefused) {
  for (const char* text : {"",
                           " ",
                           "+1",
                           "-0",
                           "00",
                           "01",
                           "0+u",
                           "u+0",
                           "1*u",
                           "u*1",
                           "2u",
                           "u*2",
                           "u^1",
                           "u^0",
                           "u^01",
                           "u^4097",
                           "u^99999999",
                           "u^-1",
                           "u^",
                           "u*",
                           "*u",
                           "u+",
                           "u--1",
                           "u+-1",
                           "1+u",
                           "u+u",
                           "u+u^2",
                           "v_t*u",
                           "u*u",
                           "u v_s",
                           "w",
                           "uu",
                           "u+1 ",
                           "(u)",
                           "u/2",
                           "1/2",
                           "2*-u",
                           "-1*u",
                           "1e5",
                           "0x10",
                           "u^2+u^2",
                           "--u",
                           "u^1234567890123456789012",
                           "1.5"}) {
    EXPECT_THROW(read(text), Malformed) << text;
  }
}

TEST(Polynomial, DivisionUndoesMultiplicationAndNothingElse) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> small(-3, 3), exponent(0, 3);
  Meter meter;
  for (int round = 0; round < 300; ++round) {
    const auto make = [&] {
      Polynomial p;
      for (int i = 0; i < 4; ++i) {
        add_scaled(p, {{Monomial{exponent(random), exponent(random), exponent(random)}, Integer(1)}}, small(random), {},
                   meter);
      }
      return p;
    };
    const Polynomial p = make();
    Polynomial g = make();
    if (g.empty()) continue;
    const Polynomial product = multiply(p, g, meter);
    ASSERT_EQ(quotient(product, g, meter), p) << text_of(p) << " / " << text_of(g);
    if (g.size() == 1) continue;  // two terms at least never divide a monomial
    Polynomial disturbed = product;
    add_term(disturbed, Monomial{1, 1, 1}, 1, meter);
    EXPECT_FALSE(quotient(disturbed, g, meter)) << text_of(disturbed) << " / " << text_of(g);
  }
}

TEST(Polynomial, LevelVariablesCanBeSetToOne) {
  Meter meter;
  const std::vector<std::size_t> level{1, 2};
  EXPECT_EQ(text_of(at_one(read("u^2*v_s-u^2*v_t+3*u*v_t+v_s+4"), level, meter)), "3*u+5");
}

TEST(Univariate, SturmCountsDistinctZeros) {
  std::mt19937 random(11);
  std::uniform_int_distribution<int> root(-6, 6), power(1, 3), extra(0, 2);
  Meter meter;
  for (int round = 0; round < 200; ++round) {
    Dense p{Integer(round % 2 ? 5 : -3)};
    std::vector<int> twice_roots;
    for (int i = 0; i < 4; ++i) {
      const int r = root(random);
      twice_roots.push_back(r);
      for (int k = power(random); k > 0; --k) p = times(p, {Integer(-r), Integer(2)});
    }
    for (int i = extra(random); i > 0; --i) p = times(p, {Integer(2), Integer(1), Integer(1)});  // no real zero
    std::sort(twice_roots.begin(), twice_roots.end());
    twice_roots.erase(std::unique(twice_roots.begin(), twice_roots.end()), twice_roots.end());
    const SturmChain chain(p, meter);
    for (int a = -27; a <= 27; a += 2) {  // a/4 with a odd is never a zero
      const auto expected = std::count_if(twice_roots.begin(), twice_roots.end(), [&](int r) { return 2 * r > a; });
      ASSERT_EQ(chain.zeros_beyond(a, 4, meter), expected) << round << " at " << a << "/4";
      ASSERT_GE(variations_beyond(p, a, 4, meter), expected);
    }
  }
}

TEST(Univariate, DescartesShiftsExactly) {
  Meter meter;
  const Dense p{Integer(-6), Integer(11), Integer(-6), Integer(1)};  // zeros 1, 2, 3
  EXPECT_EQ(variations_beyond(p, 0, 1, meter), 3);
  EXPECT_EQ(variations_beyond(p, 1, 1, meter), 2);
  EXPECT_EQ(variations_beyond(p, 3, 2, meter), 2);
  EXPECT_EQ(variations_beyond(p, 5, 2, meter), 1);
  EXPECT_EQ(variations_beyond(p, 3, 1, meter), 0);
  EXPECT_EQ(variations_beyond(p, -1, 3, meter), 3);
}

TEST(Univariate, ZerosBeyondCosineOfPiOverM) {
  Meter meter;
  for (int m = 2; m <= 12; ++m) {
    // The end point itself does not count, nor do its conjugates to the left.
    const Dense end = cosine_polynomial(2 * static_cast<std::uint64_t>(m), meter);
    EXPECT_FALSE(has_zero_beyond_cos(end, m, meter)) << m;
    EXPECT_FALSE(has_zero_beyond_cos(times(end, end), m, meter)) << m;
    const double c = std::cos(std::acos(-1.0) / m);
    for (const int denominator : {7, 1000, 1 << 30}) {  // linear factors close to the end point, on both sides
      const auto below = static_cast<long>(std::floor(c * denominator - 1e-6));
      EXPECT_FALSE(has_zero_beyond_cos({Integer(-below), Integer(denominator)}, m, meter)) << m;
      EXPECT_TRUE(has_zero_beyond_cos({Integer(-(below + 1 + (m == 2 || m == 3))), Integer(denominator)}, m, meter))
          << m;
      EXPECT_TRUE(has_zero_beyond_cos(times(end, {Integer(-(below + 2)), Integer(denominator)}), m, meter)) << m;
      // A zero on each side, twice each, and a pair of complex zeros that spoils Descartes' rule.
      Dense p = times({Integer(-below), Integer(denominator)}, {Integer(41), Integer(-40), Integer(10)});
      EXPECT_FALSE(has_zero_beyond_cos(times(p, p), m, meter)) << m;
      p = times(p, {Integer(-(below + 2)), Integer(denominator)});
      EXPECT_TRUE(has_zero_beyond_cos(times(p, p), m, meter)) << m;
    }
    EXPECT_TRUE(has_zero_beyond_cos({Integer(-1), Integer(1)}, m, meter));
    EXPECT_TRUE(has_zero_beyond_cos({Integer(-1000000), Integer(1)}, m, meter));
    EXPECT_FALSE(has_zero_beyond_cos({Integer(3)}, m, meter));
  }
}

TEST(Cyclotomic, KnownPolynomials) {
  Meter meter;
  EXPECT_EQ(cosine_polynomial(3, meter), (Dense{Integer(1), Integer(2)}));
  EXPECT_EQ(cosine_polynomial(4, meter), (Dense{Integer(0), Integer(1)}));
  EXPECT_EQ(cosine_polynomial(5, meter), (Dense{Integer(-1), Integer(2), Integer(4)}));
  EXPECT_EQ(cosine_polynomial(6, meter), (Dense{Integer(-1), Integer(2)}));
  EXPECT_EQ(cosine_polynomial(8, meter), (Dense{Integer(-1), Integer(0), Integer(2)}));
  EXPECT_EQ(cosine_polynomial(12, meter), (Dense{Integer(-3), Integer(0), Integer(4)}));
  const auto head = cyclotomic_head(105, 25, meter);  // the first cyclotomic polynomial with a coefficient -2
  EXPECT_EQ(head[7], -2);
  EXPECT_EQ(head[8], -1);
  EXPECT_EQ(head[24], -1);  // the middle of degree 48
}

TEST(Cyclotomic, FactorsOfChebyshevPolynomials) {
  // T_n(v) - 1 vanishes at cos(2 pi j/n): a constant times the product over d | n of the squares of the cosine
  // polynomials, where d = 1 and 2 (v - 1 and v + 1) count once.
  Meter meter;
  Dense before{Integer(1)}, now{Integer(0), Integer(1)};
  for (std::uint64_t n = 2; n <= 120; ++n) {
    Dense next(now.size() + 1);
    for (std::size_t i = 0; i < now.size(); ++i) next[i + 1] = 2 * now[i];
    for (std::size_t i = 0; i < before.size(); ++i) next[i] -= before[i];
    before = std::move(now);
    now = std::move(next);
    Dense p = now;
    p[0] -= 1;
    for (std::uint64_t d = 3; d <= n; ++d) {
      ASSERT_EQ(cosine_polynomial(d, meter).size(), euler_phi(d) / 2 + 1);
      ASSERT_EQ(divide_out_cosine(p, d, meter), n % d == 0 ? 2 : 0) << n << " " << d;
    }
    ASSERT_EQ(p.size(), n % 2 == 0 ? 3U : 2U) << n;
  }
}

TEST(Cyclotomic, MultiplicitiesAreDividedOut) {
  Meter meter;
  Dense product = times(times(cosine_polynomial(7, meter), cosine_polynomial(9, meter)), cosine_polynomial(9, meter));
  EXPECT_EQ(divide_out_cosine(product, 9, meter), 2);
  EXPECT_EQ(divide_out_cosine(product, 9, meter), 0);
  EXPECT_EQ(divide_out_cosine(product, 7, meter), 1);
  EXPECT_EQ(product.size(), 1U);
}

TEST(Cyclotomic, OrderOfAnAngle) {
  EXPECT_EQ(root_order({0, {1, 2}}, 2), 8U);   // v = cos(pi/4)
  EXPECT_EQ(root_order({0, {2, 3}}, 2), 6U);   // v = cos(pi/3)
  EXPECT_EQ(root_order({1, {4, 5}}, 2), 10U);  // v = cos(pi/5)
  EXPECT_EQ(root_order({0, {1, 2}}, 3), 12U);  // v = cos(pi/6)
  EXPECT_EQ(root_order({1000000, {1, 2}}, 64), std::nullopt);
  EXPECT_EQ(root_order({60, {1, 2}}, 2), std::nullopt);
  EXPECT_EQ(root_order({0, {1, 999983}}, 2), std::nullopt);
}

TEST(Number, Grammar) {
  Meter meter;
  for (const char* text : {"0", "1", "-1", "12/35", "-7/2", "123456789012345678901234567890/17"}) {
    const Fraction f = parse_fraction(text, "n", meter);
    const std::string back = f.numerator.str() + (f.denominator == 1 ? "" : "/" + f.denominator.str());
    EXPECT_EQ(back, text);
  }
  for (const char* text : {"",   "-",  "-0",  "00",          "01",   "1/0",  "1/1", "2/4", "0/2", "1/-2", "+1",
                           " 1", "1 ", "1.0", "1e999999999", "1/02", "1//2", "/2",  "1/",  "nan", "0x1",  "--1"}) {
    EXPECT_THROW(parse_fraction(text, "n", meter), Malformed) << text;
  }
  EXPECT_THROW(parse_fraction(std::string(200001, '7'), "n", meter), Malformed);
  EXPECT_NO_THROW(parse_fraction(std::string(200000, '7'), "n", meter));
  EXPECT_THROW(parse_small_fraction("1000001", "n", meter), Malformed);
}

}  // namespace
