// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the checker: joint spectral radii, non-negative symbols, stability, level-dependent regularity.
#include "expectations.hpp"
#include "smoothness_samples.hpp"

#include "twoscale/check/matrix.hpp"
#include "twoscale/check/radius.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <functional>

namespace {

using namespace samples;
using twoscale::check::check_text;
using twoscale::check::Dense;
using twoscale::check::Fraction;
using twoscale::check::Integer;
using twoscale::check::Matrix;
using twoscale::check::Meter;
using twoscale::check::Report;

// ---- algebra

Matrix of(std::size_t size, std::vector<long> entries, long scale = 1) {
  return {size, std::vector<Integer>(entries.begin(), entries.end()), scale};
}

TEST(Matrix, InverseAndCharacteristicPolynomial) {
  Meter meter;
  const Matrix a = of(3, {2, -1, 0, 1, 3, 5, 0, 4, 1}, 6);
  const auto b = inverse(a, meter);
  ASSERT_TRUE(b);
  const Matrix one = multiply(a, *b, meter);
  EXPECT_EQ(one.entries, of(3, {1, 0, 0, 0, 1, 0, 0, 0, 1}).entries);
  EXPECT_EQ(one.scale, 1);
  EXPECT_FALSE(inverse(of(3, {1, 2, 3, 4, 5, 6, 7, 8, 9}), meter));
  EXPECT_EQ(inverse(of(2, {0, 1, 1, 0}), meter)->entries, of(2, {0, 1, 1, 0}).entries);
  // det(x - A) for A = (2 -1 0; 1 3 5; 0 4 1): x^3 - 6x^2 - 8x + 33
  EXPECT_EQ(characteristic_polynomial(a, meter), (Dense{33, -8, -6, 1}));
  EXPECT_EQ(minimal_polynomial(of(3, {1, 1, 0, 0, 1, 0, 0, 0, 7}), {0, 1, 0}, meter), (Dense{1, -2, 1}));
  EXPECT_EQ(minimal_polynomial(of(1, {1}, 2), {1}, meter), (Dense{-1, 2}));
}

TEST(Univariate, SchurCohnIsSharp) {
  Meter meter;
  const auto stable = [&](Dense p) { return is_schur_stable(std::move(p), meter); };
  EXPECT_TRUE(stable({5}));
  EXPECT_TRUE(stable({1, 2}));
  EXPECT_FALSE(stable({2, 2}));
  EXPECT_FALSE(stable({3, 2}));
  EXPECT_TRUE(stable({0, 0, 1}));
  EXPECT_FALSE(stable({1, 0, 1}));  // +-i
  EXPECT_TRUE(stable({99, 0, 100}));
  EXPECT_FALSE(stable({2, -3, 0, 1}));  // 1, 1, -2
  EXPECT_TRUE(stable({-1, 0, 0, 8}));
  EXPECT_FALSE(stable({1, 1, 1}));
}

TEST(ResidueRing, SignsCount) {
  Meter meter;
  const Dense p{-1, -1, 1};
  const twoscale::check::ResidueRing ring(p, meter);
  const auto vector = [&](Dense q) { return ring.reduced({{std::move(q)}, 1}); };
  EXPECT_TRUE(ring.equal(vector({0, 0, 1}), vector({1, 1}), 1));
  EXPECT_FALSE(ring.equal(vector({0, 0, 1}), vector({1, 1}), -1));
  EXPECT_TRUE(ring.equal(vector({0, 0, 1}), vector({-1, -1}), -1));
  EXPECT_TRUE(ring.equal(ring.times_x(vector({1}), 5), vector({3, 5}), 1));
  const Dense q{-3, 0, 2};  // not monic: x^2 = 3/2
  const twoscale::check::ResidueRing half(q, meter);
  const auto square = half.reduced({{{0, 0, 2}}, 3});
  EXPECT_EQ(square.list[0], (Dense{1}));
  EXPECT_EQ(square.scale, 1);
}

TEST(Univariate, CountsOfZeros) {
  Meter meter;
  const Dense p{0, 0, 12, -8, -3, 2};  // x^2 (x-2)(x+2)... checked by its values below
  const auto within = [&](long a, long b) { return zeros_within(p, {a, 1}, {b, 1}, meter); };
  // 2x^3 - 3x^2 - 8x + 12 = (x-2)(x+2)(2x-3)
  EXPECT_EQ(within(-3, 3), 4);
  EXPECT_EQ(within(-2, 2), 4);
  EXPECT_EQ(within(0, 0), 1);
  EXPECT_EQ(within(1, 1), 0);
  EXPECT_EQ(within(0, 1), 1);
  EXPECT_EQ(zeros_from(p, {2, 1}, meter), 1);
  EXPECT_EQ(zeros_from(p, {3, 2}, meter), 2);
  EXPECT_EQ(zeros_from(p, {5, 2}, meter), 0);
  EXPECT_EQ(zeros_between(p, {-2, 1}, {2, 1}, meter), 2);
  EXPECT_EQ(zeros_between(p, {0, 1}, {3, 2}, meter), 0);
  EXPECT_EQ(squarefree(p, meter), (Dense{0, 12, -8, -3, 2}));
  EXPECT_EQ(odd_part(p, meter), (Dense{12, -8, -3, 2}));
  EXPECT_EQ(odd_part({-1, 3, -3, 1}, meter), (Dense{-1, 1}));
  EXPECT_EQ(odd_part({4}, meter), (Dense{1}));
  EXPECT_EQ(twoscale::check::gcd(p, {-6, 4}, meter), (Dense{-3, 2}));
  EXPECT_EQ(twoscale::check::cosine_sum({5, 3, 2}, meter), (Dense{1, 6, 8}));  // 5 + 6x + 4(2x^2-1)
  EXPECT_EQ(twoscale::check::cosine_sum({7}, meter), (Dense{7}));
  EXPECT_EQ(twoscale::check::cosine_sum({0, 0, 0, 1}, meter), (Dense{0, -6, 0, 8}));
}

TEST(Enclosure, ContainsTheTrueVectors) {
  Meter meter;
  const twoscale::check::Radius golden_ratio{{-1, -1, 1}, {1, 1}, {2, 1}, ""};
  const double phi = (1 + std::sqrt(5.0)) / 2;
  const Matrix a = of(2, {3, -2, -7, 1}, 5);
  for (unsigned bits = 1; bits <= 40; bits += 3) {
    const twoscale::check::Enclosure rho(golden_ratio, bits, meter);
    for (const long sign : {1L, -1L}) {  // no rounding before the division: the end points of rho decide
      const std::vector<Dense> constants{{Integer(sign * 1000)}, {Integer(0)}};
      const auto image = rho.image(of(2, {1, 0, 0, 1}), rho.value(constants, {1, 1}));
      const double scale = static_cast<double>(image.scale), value = static_cast<double>(sign) * 1000 / phi;
      EXPECT_LE(static_cast<double>(image.low[0]) / scale, value);
      EXPECT_GE(static_cast<double>(image.high[0]) / scale, value);
      EXPECT_GT(image.high[0] - image.low[0], 100) << bits;
    }
    for (long i = -3; i <= 3; ++i) {
      for (long j = -3; j <= 3; ++j) {
        const std::vector<Dense> vector{{Integer(i), Integer(1)}, {Integer(1), Integer(j), Integer(-1)}};
        const auto box = rho.value(vector, {2, 3});
        const auto image = rho.image(a, box);
        const double x = (static_cast<double>(i) + phi) * 2 / 3,
                     y = (1 + static_cast<double>(j) * phi - phi * phi) * 2 / 3;
        const double u = (3 * x - 2 * y) / 5 / phi, v = (-7 * x + y) / 5 / phi;
        const auto expect = [&](const twoscale::check::VectorEnclosure& b, std::size_t k, double value) {
          const double scale = static_cast<double>(b.scale);
          EXPECT_EQ(b.scale, Integer(1) << bits);
          EXPECT_LE(static_cast<double>(b.low[k]) / scale, value + 1e-13);
          EXPECT_GE(static_cast<double>(b.high[k]) / scale, value - 1e-13);
          EXPECT_LE(static_cast<double>(b.high[k] - b.low[k]), 60) << bits;
        };
        expect(box, 0, x);
        expect(box, 1, y);
        expect(image, 0, u);
        expect(image, 1, v);
      }
    }
  }
}

// ---- claims

TEST(Smoothness, SamplesAreValid) {
  for (const Document& d : {bspline_radius(), dd4_radius(), dd6_radius(), parameter_radius(), tension4_limit(),
                            ternary_radius(), lopsided(), three_apart(), doubled()}) {
    SCOPED_TRACE(d.scheme);
    expect_valid(d);
  }
  for (const Matrices& d : {golden(), golden_and_one(), reducible(), turn()}) {
    SCOPED_TRACE(d.scheme);
    expect_valid(d);
  }
}

TEST(Smoothness, ReportSaysWhatItMeans) {
  std::string lines;
  for (const std::string& line : dd4_radius().check().lines) lines += line + "\n";
  for (const char* part :
       {"proved   jsr-exact of the remainder of order 4: rho = the zero of x-4 in [4, 4]: ",
        "Hoelder exponent of the limits >= 4 - log_2(rho) if this is positive, = if the integer shifts are stable",
        "products of n matrices are bounded by a constant times rho^n", "\n[invariant-polytope] ", "\n[jia-wang] ",
        "\n[spectral-radius] ", "\n[nonnegative-symbol] ", "proved   stability of the integer shifts"}) {
    EXPECT_NE(lines.find(part), std::string::npos) << part << "\n" << lines;
  }
  lines.clear();
  for (const std::string& line : golden().check().lines) lines += line + "\n";
  EXPECT_NE(lines.find("the claims are about the matrices in this file"), std::string::npos) << lines;
  EXPECT_NE(lines.find("2 matrices B_0, B_1, ... of size 2x2"), std::string::npos) << lines;
  EXPECT_EQ(lines.find("Hoelder exponent of the limits >= 4"), std::string::npos) << lines;
}

TEST(Smoothness, OrderOfTheRemainder) {
  const Document d = dd4();
  expect_invalid(d.with(jsr_lower(3, {}, {0}, "1")), "more than 3");
  expect_invalid(d.with(jsr_lower(5, {}, {0}, "1")), "4 only");
  expect_invalid(d.with(jsr_lower(0, {}, {0}, "1")), "positive");
  expect_malformed(d.with(jsr_lower(-1, {}, {0}, "1")), "order");
  Document half = dd4();
  half.denominator = "8";
  expect_invalid(half.with(stable()), "is not 2");
  expect_invalid(refuted_mask().with(stable()), "is not 2");
  Document none = refuted_mask();
  none.denominator = "3";
  none.numerators = {"2", "4"};
  expect_invalid(none.with(stable()), "0 only");
}

TEST(Smoothness, LowerBounds) {
  expect_invalid(dd4().with(jsr_lower(4, {}, {0, 0}, "4000001/1000000")), "less than the bound");
  expect_valid(dd4().with(jsr_lower(4, {}, {1, 1, 1}, "3999999/1000000")));
  expect_invalid(turn().with(jsr_lower(0, {}, {0}, "2001/1000")), "less than the bound");
  expect_valid(turn().with(jsr_lower(0, {}, {0, 0, 0}, "2")));
  expect_malformed(turn().with(jsr_lower(0, {}, {}, "2")), "at least one");
  expect_malformed(turn().with(jsr_lower(0, {}, {1}, "2")), "word");
  expect_malformed(turn().with(jsr_lower(0, {}, {0}, "0")), "positive");
  expect_malformed(turn().with(jsr_lower(0, {}, {0}, "-2")), "positive");
  expect_malformed(turn().with(jsr_lower(1, {}, {0}, "2")), "order");
  expect_malformed(turn().with(jsr_lower(0, {"1", "1"}, {0}, "2")), "parameter");
  // B_1 B_0 and not B_0 B_0: 4-point, word (0, 1)
  expect_invalid(dd4().with(jsr_lower(4, {}, {0, 1}, "4")), "less than the bound");
}

TEST(Smoothness, ProductsActInTheOrderOfTheWord) {
  // (0 1; 0 0) then (0 0; 0 1): B_1 B_0 = 0, B_0 B_1 has no eigenvalue but 0; a triple decides the order.
  Meter meter;
  const std::vector<Matrix> list{of(2, {1, 1, 0, 1}), of(2, {1, 0, 1, 1})};
  const std::vector<std::size_t> word{0, 1};
  EXPECT_EQ(twoscale::check::product(list, word, meter).entries, of(2, {1, 1, 1, 2}).entries);
}

TEST(Smoothness, PolytopesMustBeInvariant) {
  const auto family = [](std::vector<Value> images, const std::string& bound) {
    return dd4().with(jsr_upper(4, {}, bound, array({}),
                                {block(2, bound, {root({}, 1, "1", {"5", "-1"}), root({}, 1, "1", {"1", "-5"})}, {},
                                       {0, 1}, std::move(images))}));
  };
  expect_valid(family({sum({{0, "1"}}), sum({}), sum({}), sum({{1, "1"}})}, "4"));
  expect_valid(family({sum({}), sum({}), sum({}), sum({})}, "4"));
  expect_valid(family({sum({}), sum({}), sum({}), sum({})}, "401/100"));
  expect_invalid(family({sum({}), sum({}), sum({}), sum({})}, "399/100"), "not seen to lie in the hull");
  expect_invalid(family({sum({{0, "2"}}), sum({}), sum({}), sum({})}, "4"), "not seen to lie in the hull");
  // the sum and the rest are less than 1 each, but not together
  expect_invalid(family({sum({}), sum({}), sum({{0, "-3/8"}}), sum({})}, "4"), "not seen to lie in the hull");
  expect_valid(family({sum({}), sum({}), sum({{0, "-1/4"}}), sum({})}, "4"));
  expect_invalid(family({equals(0, -1), sum({}), sum({}), sum({})}, "4"), "is not the vertex 0");
  expect_invalid(family({equals(1, 1), sum({}), sum({}), sum({})}, "4"), "is not the vertex 1");
  expect_malformed(family({equals(2, 1), sum({}), sum({}), sum({})}, "4"), "equals");
  expect_malformed(family({equals(0, 0), sum({}), sum({}), sum({})}, "4"), "sign");
  expect_malformed(family({sum({}), sum({}), sum({})}, "4"), "4 are expected");
  expect_malformed(family({sum({}), sum({}), sum({}), sum({}), sum({})}, "4"), "4 are expected");
  expect_malformed(family({sum({{0, "0"}}), sum({}), sum({}), sum({})}, "4"), "coefficient 0");
  expect_malformed(family({sum({{1, "1/4"}, {0, "1/4"}}), sum({}), sum({}), sum({})}, "4"), "ascend");
  expect_malformed(family({sum({{2, "1"}}), sum({}), sum({}), sum({})}, "4"), "sum");
}

TEST(Smoothness, VerticesMustSpan) {
  const auto with_inner = [](const std::vector<long>& inner, const std::vector<std::string>& second) {
    return turn().with(jsr_upper(
        0, {}, "4", array({}),
        {block(2, "4", {root({}, 1, "1", {"1", "0"}), root({}, 1, "1", second)}, {}, inner, {sum({}), sum({})})}));
  };
  expect_valid(with_inner({0, 1}, {"0", "1"}));
  expect_valid(with_inner({1, 0}, {"0", "1"}));
  expect_malformed(with_inner({0, 0}, {"0", "1"}), "twice");
  expect_malformed(with_inner({0}, {"0", "1"}), "2 indices");
  expect_malformed(with_inner({0, 2}, {"0", "1"}), "inner");
  expect_invalid(with_inner({0, 1}, {"3", "0"}), "linearly independent");
  expect_invalid(with_inner({0, 1}, {"0", "0"}), "linearly independent");
}

TEST(Smoothness, IndependenceNeedsEnoughBits) {
  Matrices d;
  d.matrices = array({matrix({{"0", "1"}, {"1", "1"}})});
  const auto with_bits = [&](long bits) {
    return d.with(
        jsr_exact(0, {}, "x^2-x-1", {"1", "2"}, bits, array({}),
                  {block(2, "", {root({0}, 1, "1", {"1", "x"}), root({}, 1, "1/131072", {"32768", "32768*x+1"})}, {},
                         {0, 1}, {equals(0, 1), sum({})})}));
  };
  expect_valid(with_bits(64));
  expect_invalid(with_bits(16), "linearly independent");
}

TEST(Smoothness, BlocksAndBases) {
  const Matrices d = reducible();
  const Value basis = matrix({{"1", "0"}, {"1", "1"}});
  const auto one = [](const std::string& bound, std::vector<Value> images) {
    return block(1, bound, {root({}, 1, "1", {"1"})}, {}, {0}, std::move(images));
  };
  const Value top = one("2", {sum({}), sum({})}), low = one("1", {sum({}), sum({})});
  expect_valid(d.with(jsr_upper(0, {}, "2", basis, {top, low})));
  expect_invalid(d.with(jsr_upper(0, {}, "2", array({}), {top, low})), "block triangular");
  expect_invalid(d.with(jsr_upper(0, {}, "2", matrix({{"1", "1"}, {"1", "1"}}), {top, low})), "independent");
  expect_invalid(d.with(jsr_upper(0, {}, "19/10", basis, {top, low})), "too large");
  expect_invalid(d.with(jsr_upper(0, {}, "2", basis, {top, one("9/10", {sum({}), sum({})})})), "hull");
  expect_malformed(d.with(jsr_upper(0, {}, "2", basis, {top})), "add up");
  expect_malformed(d.with(jsr_upper(0, {}, "2", basis, {})), "add up");
  expect_malformed(d.with(jsr_upper(0, {}, "2", basis, {top, low, low})), "exceed");
  expect_malformed(d.with(jsr_upper(0, {}, "2", matrix({{"1"}}), {top, low})), "basis");
  expect_malformed(d.with(jsr_upper(0, {}, "2", basis, {one("", {sum({}), sum({})}), low})), "a bound is expected");
  // no eigenvector: rho may be less
  expect_invalid(d.with(jsr_exact(0, {}, "x-2", {"1", "5/2"}, 0, basis, {one("", {sum({}), sum({})}), low})),
                 "no eigenvector");
  expect_invalid(d.with(jsr_exact(0, {}, "x-2", {"2", "2"}, 0, basis, {top, low})), "no eigenvector");
  expect_invalid(d.with(jsr_exact(0, {}, "x-2", {"19/10", "2"}, 0, basis, {top, low})), "too large");
}

TEST(Smoothness, ExactRadii) {
  const auto line = [](const std::string& p, const std::vector<std::string>& interval, long bits) {
    return cubic_bspline().with(jsr_exact(4, {}, p, interval, bits, array({}), {line_block("")}));
  };
  expect_valid(line("x-2", {"2", "2"}, 0));
  expect_valid(line("3*x-6", {"1", "2"}, 0));
  expect_malformed(line("x-2", {"2", "2"}, 16), "bits");
  expect_malformed(line("x^2-3*x+2", {"2", "2"}, 0), "bits");
  expect_malformed(line("x^2-3*x+2", {"2", "2"}, 4097), "bits");
  expect_malformed(line("x-2", {"0", "2"}, 0), "0 < low <= high");
  expect_malformed(line("x-2", {"3", "2"}, 0), "0 < low <= high");
  expect_malformed(line("x-2", {"2"}, 0), "two numbers");
  expect_malformed(line("7", {"2", "2"}, 0), "a polynomial in x");
  expect_malformed(line("0", {"2", "2"}, 0), "a polynomial in x");
  expect_malformed(line("y-2", {"2", "2"}, 0), "polynomial");
  expect_invalid(line("x-2", {"3", "4"}, 0), "exactly one zero");
  expect_invalid(line("x^2-3*x+2", {"1", "2"}, 16), "exactly one zero");
  expect_invalid(line("x-3", {"3", "3"}, 0), "no eigenvector of the product");
  // 2 is a zero of x^2-3x+2, but the vector is no eigenvector modulo the polynomial.
  expect_invalid(line("x^2-3*x+2", {"3/2", "3"}, 16), "no eigenvector of the product");
  // (x-1) is one there, and zero at the other zero of the polynomial; zeros at the ends of the interval.
  const Value projected = block(1, "", {root({1}, 1, "1", {"x-1"})}, {}, {0}, {sum({}), equals(0, 1)});
  for (const auto& interval :
       std::vector<std::vector<std::string>>{{"2", "3"}, {"3/2", "2"}, {"2", "2"}, {"7/4", "3"}}) {
    expect_valid(cubic_bspline().with(jsr_exact(4, {}, "x^2-3*x+2", interval, 16, array({}), {projected})));
  }
  expect_invalid(cubic_bspline().with(jsr_exact(4, {}, "x^2-3*x+2", {"1/2", "1"}, 16, array({}), {projected})),
                 "cannot be told from 0");
  // Golden ratio: enough bits, and too few for a boundary that is too close.
  const std::string text = golden().with(golden_claim()).sealed();
  const auto with_bits = [&](const std::string& bits) {
    std::string copy = text;
    const std::string from = "\"bits\": 64";
    copy.replace(copy.find(from), from.size(), "\"bits\": " + bits);
    return check_text(reseal(copy)).status;
  };
  EXPECT_EQ(with_bits("16"), Report::valid);
  EXPECT_EQ(with_bits("15"), Report::malformed);
  EXPECT_EQ(with_bits("1000"), Report::valid);
  EXPECT_EQ(with_bits("4096"), Report::valid);
}

TEST(Smoothness, Parameter) {
  const Document d = parameter_radius();
  expect_malformed(d.with(jsr_lower(2, {"0", "1/16"}, {0}, "1")), "must be equal");
  expect_malformed(d.with(jsr_lower(2, {"1/16", "0"}, {0}, "1")), "descend");
  expect_malformed(d.with(jsr_lower(2, {"0"}, {0}, "1")), "two numbers");
  expect_malformed(d.with(jsr_lower(2, {"0", "0"}, {2}, "1")), "word");
  expect_invalid(d.with(jsr_lower(2, {}, {0}, "1")), "constants");
  expect_invalid(d.with(jsr_lower(4, {"1/16", "1/16"}, {0}, "1")), "2 only");
  expect_valid(d.with(jsr_lower(1, {"1/16", "1/16"}, {1}, "1")));
  expect_malformed(dd4().with(jsr_lower(4, {"0", "0"}, {0}, "1")), "exactly one variable");
  expect_malformed(tension4().with(jsr_lower(4, {"1", "1"}, {0}, "1")), "exactly one variable");
  Document squared = constant_tension();
  squared.numerators = {"-2*w^2", "0", "2*w^2+1", "2", "2*w^2+1", "0", "-2*w^2"};
  expect_invalid(squared.with(jsr_lower(2, {"0", "0"}, {0}, "1")), "affine");
  Document fraction = constant_tension();
  fraction.denominator = "2*w+2";
  expect_invalid(fraction.with(jsr_lower(2, {"0", "0"}, {0}, "1")), "contains the parameter");
  Document unnormalised = constant_tension();
  unnormalised.numerators[3] = "2*w+2";
  expect_invalid(unnormalised.with(jsr_lower(2, {"0", "0"}, {0}, "1")), "is not 2");
  // A larger interval, the same bound.
  std::string text = d.with(d.claims[0]).sealed();
  text.replace(text.find("1/16"), 4, "1/15");
  EXPECT_EQ(check_text(reseal(text)).status, Report::invalid);
}

TEST(Smoothness, NonnegativeSymbols) {
  const Document d = dd4();
  expect_valid(d.with(nonnegative(4, "remainder", "x-4", {"7/2", "9/2"})));
  expect_malformed(d.with(nonnegative(4, "mask", "x-4", {"4", "4"})), "of");
  expect_invalid(d.with(nonnegative(4, "remainder", "x-5", {"5", "5"})), "does not divide");
  expect_invalid(d.with(nonnegative(4, "remainder", "x-4", {"3", "7/2"})), "exactly one zero");
  expect_invalid(dd6_radius().with(nonnegative(6, "remainder", "x^2-5*x-36", {"5", "6"})), "exactly one zero");
  expect_invalid(lopsided().with(nonnegative(1, "remainder", "9*x-20", {"2", "3"})), "not symmetric");
  expect_invalid(lopsided().with(nonnegative(1, "autocorrelation", "9*x-19", {"2", "3"})), "does not divide");
  // c = (1 + z^2) changes no sign only after a shift: g = z + 1/z is negative at z = -1.
  Document sign;
  sign.scheme = "mask";
  sign.numerators = {"1", "1", "1", "1"};
  sign.denominator = "2";
  expect_invalid(sign.with(nonnegative(1, "remainder", "x-1", {"1", "1"})), "changes its sign");
  // c = (1, 1, 4, 1, 1)/4: two positive zeros, 0.109... and 1.140...
  Document two;
  two.scheme = "mask";
  two.numerators = {"1", "2", "5", "5", "2", "1"};
  two.denominator = "8";
  expect_valid(two.with(nonnegative(1, "remainder", "8*x^2-10*x+1", {"1", "2"})));
  expect_invalid(two.with(nonnegative(1, "remainder", "8*x^2-10*x+1", {"1/10", "1/5"})), "not the largest");
  expect_invalid(dd6_radius().with(nonnegative(6, "remainder", "x^2-5*x-36", {"1", "8"})), "exactly one zero");
}

TEST(Smoothness, Stability) {
  expect_valid(dd4().with(stable()));
  expect_valid(cubic_bspline().with(stable()));
  expect_valid(ternary().with(stable()));
  expect_invalid(three_apart().with(stable()), "cycle of roots of unity of order 3");
  expect_invalid(doubled().with(stable()), "common zero");
  expect_invalid(dd4().with(unstable()), "no common zero");
  expect_invalid(three_apart().with(unstable()), "no common zero");
  expect_invalid(dd4().with(unstable(3)), "is not a common divisor");
  expect_invalid(three_apart().with(unstable(5)), "is not a common divisor");
  expect_invalid(three_apart().with(unstable(4)), "common divisor");
  expect_malformed(three_apart().with(unstable(1)), "order");
  expect_invalid(three_apart().with(unstable(1000000)), "common divisor");
  expect_invalid(constant_tension().with(stable()), "constants");
  Document five = three_apart();  // (1 + z^5)
  five.numerators = {"1", "0", "0", "0", "0", "1"};
  expect_valid(five.with(unstable(5)));
  expect_invalid(five.with(stable()), "order 5");
  Document ternary_two = three_apart();  // arity 3, 1 + z^2 + z^4: all A_s equal at z = -1
  ternary_two.arity = 3;
  ternary_two.numerators = {"1", "0", "1", "0", "1"};
  expect_valid(ternary_two.with(unstable(2)));
  expect_invalid(ternary_two.with(stable()), "order 2");
}

TEST(Smoothness, LevelDependentSchemes) {
  const Document d = tension4();
  const Value bound = nonnegative(4, "remainder", "x-4", {"4", "4"});
  const auto both = [&](Value first, Value second) {
    Document copy = d;
    copy.claims = {std::move(first), std::move(second)};
    return copy;
  };
  expect_valid(both(bound, nonstationary(space4(), 1)));
  expect_valid(both(bound, nonstationary(space4(), 0)));
  expect_invalid(both(bound, nonstationary(space4(), 2)), "no claim before this one");
  expect_invalid(both(bound, nonstationary(space4(), 4)), "less than the order");
  expect_invalid(both(nonstationary(space4(), 1), bound), "no claim before this one");
  expect_invalid(d.with(nonstationary(space4(), 0)), "no claim before this one");
  expect_invalid(both(nonnegative(4, "autocorrelation", "x-4", {"4", "4"}), nonstationary(space4(), 1)), "");
  expect_invalid(both(nonnegative(4, "remainder", "x-4", {"4", "8"}), nonstationary(space4(), 1)),
                 "no claim before this one");
  expect_valid(both(nonnegative(4, "remainder", "x-4", {"1", "5"}), nonstationary(space4(), 1)));
  expect_valid(both(jsr_upper(4, {}, "4", array({}), {dd4_block("4")}), nonstationary(space4(), 1)));
  expect_valid(both(jsr_exact(4, {}, "x-4", {"1", "5"}, 0, array({}), {dd4_block("")}), nonstationary(space4(), 1)));
  expect_invalid(both(jsr_lower(4, {}, {0}, "1"), nonstationary(space4(), 1)), "no claim before this one");
  // A refused bound does not count.
  expect_invalid(both(jsr_upper(4, {}, "3", array({}), {dd4_block("3")}), nonstationary(space4(), 1)), "claim 1");
  expect_invalid(both(bound, nonstationary(space({{{0}, 2}}), 0)), "more than 2");
  expect_invalid(both(bound, nonstationary(space({{{0}, 4}}), 0)), "is not generated");
  expect_malformed(both(bound, nonstationary(space4(), -1)), "continuity");
  expect_invalid(constant_tension().with(nonstationary(space({{{}, 2}}), 0)), "constants");
}

TEST(Smoothness, DocumentsWithMatrices) {
  Matrices d = golden();
  expect_malformed(d.with(stable()), "not about matrices");
  expect_malformed(d.with(interpolatory()), "not about matrices");
  d.matrices = array({});
  expect_malformed(d, "matrices");
  d.matrices = array({matrix({{"1", "0"}})});
  expect_malformed(d, "entries are expected");
  d.matrices = array({matrix({{"1"}}), matrix({{"1", "0"}, {"0", "1"}})});
  expect_malformed(d, "rows are expected");
  d.matrices = array({matrix({{"2/4"}})});
  expect_malformed(d, "lowest terms");
  expect_malformed(
      turn().with(claim("jsr-lower", "refuted",
                        {{"order", number(0)}, {"parameter", array({})}, {"word", numbers({0})}, {"bound", text("2")}},
                        "spectral-radius")),
      "no refutation");
}

// ---- cost

TEST(Smoothness, MuchWorkEnds) {
  const auto ends = [](const std::string& text) {
    const Report report = check_text(text, 200'000'000);
    EXPECT_NE(report.status, Report::valid);
    EXPECT_NE(report.message, "");
  };
  const auto wide = [](std::size_t n, const std::function<std::string(std::size_t, std::size_t)>& entry) {
    std::vector<std::vector<std::string>> rows(n);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) rows[i].push_back(entry(i, j));
    }
    return matrix(rows);
  };
  Matrices d;
  d.matrices =
      array({wide(256, [](std::size_t i, std::size_t j) { return std::to_string((i * 37 + j * j) % 97 + 1); })});
  ends(d.with(jsr_lower(0, {}, std::vector<long>(4096, 0), "100000")).sealed());
  ends(d.with(jsr_lower(0, {}, {0}, "100000")).sealed());
  ends(d.with(jsr_upper(0, {}, "100000", d.matrices.items[0], {})).sealed());
  d.matrices =
      array({wide(64, [](std::size_t i, std::size_t j) { return "1/" + std::to_string(1000003 + 2 * (64 * i + j)); })});
  ends(d.with(jsr_lower(0, {}, {0, 0, 0}, "2")).sealed());
  const std::string digits(199'999, '7');
  d.matrices = array({matrix({{digits, "1"}, {"1", digits}})});
  ends(d.with(jsr_lower(0, {}, std::vector<long>(100, 0), digits + "7")).sealed());
  d.matrices = array({matrix({{"1", "1"}, {"1", "0"}})});
  ends(d.with(jsr_exact(0, {}, "x^4096-x-1", {"1", "2"}, 4096, array({}),
                        {block(2, "", {root({0}, 1, "1", {"x^4095", "x^4094"})}, {}, {0, 0}, {})}))
           .sealed());
  ends(d.with(jsr_exact(0, {}, "x^2-x-1", {"1", digits}, 4096, array({}),
                        {block(2, "", {root({0}, 1, "1", {"x", "1"})}, {}, {0, 0}, {})}))
           .sealed());
  ends(d.with(jsr_exact(0, {}, digits + "*x^2-x-1", {"1/" + std::string(1000, '7'), "1"}, 4096, array({}),
                        {block(2, "", {root(std::vector<long>(4096, 0), 1, "1", {"x^4096", "1"})}, {}, {0, 0}, {})}))
           .sealed());
  Document mask;
  mask.numerators.assign(4096, "1");
  mask.denominator = "2048";
  ends(mask.with(jsr_lower(1, {}, {0}, "1")).sealed());
  ends(mask.with(stable()).sealed());
  ends(mask.with(nonnegative(1, "autocorrelation", "x-1", {"1", "1"})).sealed());
  mask.numerators[1000] = mask.numerators[2001] = "2";
  mask.denominator = "2049";
  ends(mask.with(stable()).sealed());
  ends(mask.with(nonnegative(1, "remainder", "x-1", {"1", "1"})).sealed());
}

// ---- mutations

/// low <= rho <= high, and |p(rho)| small.
bool isolates(const Value& radius, double rho) {
  const auto& interval = member(radius, "interval").items;
  Meter meter;
  const Dense p = twoscale::check::read_in_x(member(radius, "polynomial"), "p", meter);
  double value = 0, size = 0;
  for (std::size_t i = p.size(); i-- > 0;) {
    value = value * rho + static_cast<double>(p[i]);
    size = size * rho + std::abs(static_cast<double>(p[i]));
  }
  return real(interval[0]) <= rho + 1e-9 && rho - 1e-9 <= real(interval[1]) && std::abs(value) <= 1e-9 * size;
}

/// Numbers between which the joint spectral radius of 2x2 matrices lies, from all products of at most 8.
std::pair<double, double> radius_bounds(const Value& matrices) {
  using Two = std::array<double, 4>;
  std::vector<Two> list, products{{1, 0, 0, 1}};
  for (const Value& m : matrices.items) {
    list.push_back(
        {real(m.items[0].items[0]), real(m.items[0].items[1]), real(m.items[1].items[0]), real(m.items[1].items[1])});
  }
  double low = 0, high = 1e300;
  for (int n = 1; n <= 8; ++n) {
    std::vector<Two> next;
    double norm = 0;
    for (const Two& a : list) {
      for (const Two& b : products) {
        const Two c{a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3], a[2] * b[0] + a[3] * b[2],
                    a[2] * b[1] + a[3] * b[3]};
        next.push_back(c);
        norm = std::max(norm, std::max(std::abs(c[0]) + std::abs(c[1]), std::abs(c[2]) + std::abs(c[3])));
        const double half = (c[0] + c[3]) / 2, det = c[0] * c[3] - c[1] * c[2], d = half * half - det;
        low = std::max(low, std::pow(d < 0 ? std::sqrt(det) : std::abs(half) + std::sqrt(d), 1.0 / n));
      }
    }
    high = std::min(high, std::pow(norm, 1.0 / n));
    products = std::move(next);
  }
  return {low, high};
}

TEST(SmoothnessMutation, Matrices) {
  for (const Matrices& d : {golden(), reducible(), turn()}) {
    SCOPED_TRACE(d.scheme);
    expect_only_true_mutants(d.sealed(), 0, [](const Value& document, const Value& one) {
      const auto [low, high] = radius_bounds(member(document, "matrices"));
      const std::string& name = member(one, "claim").text;
      if (name == "jsr-lower") return real(member(one, "bound")) <= high + 1e-9;
      if (name == "jsr-upper") return real(member(one, "bound")) >= low - 1e-9;
      const auto& interval = member(member(one, "radius"), "interval").items;
      if (real(interval[0]) > high + 1e-9 || real(interval[1]) < low - 1e-9) return false;
      // The lower bound is attained in these families.
      return isolates(member(one, "radius"), low);
    });
  }
}

TEST(SmoothnessMutation, Masks) {
  struct Case {
    Document document;
    long order;
    double rho, squared;  // of the remainder, of its autocorrelation
    bool stable;
  };
  for (const Case& c :
       {Case{bspline_radius(), 4, 2, 4, true}, Case{dd4_radius(), 4, 4, 0, true}, Case{dd6_radius(), 6, 9, 0, true},
        Case{tension4_limit(), 4, 4, 0, true}, Case{ternary_radius(), 4, 11, 0, true},
        Case{lopsided(), 1, 0, 20.0 / 9, true}, Case{three_apart(), 1, 0, 0, false}, Case{doubled(), 1, 0, 0, false},
        Case{parameter_radius(), 2, 1, 0, true}}) {
    SCOPED_TRACE(c.document.scheme);
    const std::string text = c.document.sealed();
    expect_only_true_mutants(text, text.find("\"claims\""), [&](const Value&, const Value& one) {
      const std::string& name = member(one, "claim").text;
      if (name == "stability") {
        if ((member(one, "verdict").text == "proved") != c.stable) return false;
        if (c.stable) return true;
        const Value& witness = member(one, "witness");
        if (member(witness, "kind").text == "common-zero") return c.document.numerators[1] == "1";
        return member(witness, "order").number == 3;
      }
      if (name == "nonstationary") {
        return member(one, "continuity").number <= 1 &&
               twoscale::check::canonical_json(member(one, "space")) == twoscale::check::canonical_json(space4());
      }
      if (!c.document.variables.empty() && c.document.variables[0].scope == "constant") {
        // order <= 2; w in [0, 1/16] has rho <= 2, and rho >= 1 always
        const auto& parameter = member(one, "parameter").items;
        if (member(one, "order").number > 2) return false;
        if (name == "jsr-lower")
          return real(member(one, "bound")) <= 2 * std::max(1.0, 20 * std::abs(real(parameter[0])));
        const double w = std::max(std::abs(real(parameter[0])), std::abs(real(parameter[1])));
        return real(member(one, "bound")) >= std::max(1.0, 16 * w) || real(member(one, "bound")) >= 2;
      }
      if (member(one, "order").number != c.order) return false;
      if (name == "jsr-lower") return real(member(one, "bound")) <= c.rho + 1e-9;
      if (name == "jsr-upper") return real(member(one, "bound")) >= c.rho - 1e-9;
      if (name == "jsr-exact") return isolates(member(one, "radius"), c.rho);
      return isolates(member(one, "radius"), member(one, "of").text == "remainder" ? c.rho : c.squared);
    });
  }
}

}  // namespace
