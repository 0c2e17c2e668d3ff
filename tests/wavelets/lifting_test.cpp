// SPDX-License-Identifier: GPL-3.0-or-later
// Filter banks and their lifting steps: known pairs, laws on random banks, refusals.
#include "twoscale/symbolic/lifting.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

#include "twoscale/symbolic/bspline_function.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"
#include "twoscale/symbolic/symbol.hpp"

namespace twoscale {
namespace {

Laurent mask(long lowest, const std::string& list) {
  std::vector<RationalFunction> c;
  for (const auto& piece : split_list(list)) c.push_back(parse_rational_function(piece));
  return {lowest, std::move(c)};
}

Laurent symbol_of(const std::string& scheme) { return symbol(make_scheme(scheme)); }

Space polynomials(unsigned order) { return Space::one_frequency(order, {}); }

std::string message(const std::function<void()>& f) {
  try {
    f();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind, Error::Kind::bad_input);
    return e.what();
  }
  return "";
}

void expect_step(const Lifting& l, size_t i, bool predict, const Laurent& filter) {
  ASSERT_LT(i, l.factorization.steps.size());
  EXPECT_EQ(l.factorization.steps[i].predict, predict) << i;
  EXPECT_EQ(l.factorization.steps[i].filter, filter) << i;
}

// Cohen, Daubechies and Feauveau 1992; the steps as in Daubechies and Sweldens 1998.
TEST(Lifting, Cdf22) {
  const Laurent a = mask(-1, "1/2,1,1/2");
  const Lifting l = complete(a, polynomials(2));
  ASSERT_EQ(l.factorization.steps.size(), 2U);
  expect_step(l, 0, true, mask(-1, "-1/2,-1/2"));
  expect_step(l, 1, false, mask(0, "1/4,1/4"));
  EXPECT_EQ(l.factorization.norm, RationalFunction(1));
  EXPECT_EQ(l.bank.analysis_low, mask(-2, "-1/8,1/4,3/4,1/4,-1/8"));
  EXPECT_EQ(l.bank.analysis_high, mask(0, "-1/2,1,-1/2"));
  EXPECT_EQ(vanishing_moments(l.bank.synthesis_high), 2U);
  EXPECT_EQ(vanishing_moments(l.bank.analysis_high), 2U);
  const Lifting pair = factor_pair(a, mask(-2, "-1/4,1/2,3/2,1/2,-1/4"));
  EXPECT_EQ(pair.bank.synthesis_high, l.bank.synthesis_high);
  EXPECT_EQ(pair.factorization.steps.size(), 2U);
  // The dual may stand at any even translation.
  EXPECT_EQ(factor_pair(a, mask(4, "-1/4,1/2,3/2,1/2,-1/4")).bank.analysis_low, l.bank.analysis_low);
}

TEST(Lifting, Cdf24) {
  const Lifting l = complete(mask(-1, "1/2,1,1/2"), polynomials(4));
  ASSERT_EQ(l.factorization.steps.size(), 2U);
  expect_step(l, 1, false, mask(-1, "-3/64,19/64,19/64,-3/64"));
  EXPECT_EQ(l.bank.analysis_low, mask(-4, "3/128,-3/64,-1/8,19/64,45/64,19/64,-1/8,-3/64,3/128"));
  EXPECT_EQ(vanishing_moments(l.bank.synthesis_high), 4U);
}

TEST(Lifting, CubicSplines) {
  const Lifting l = complete(symbol_of("bspline:n=3"), polynomials(2));
  ASSERT_EQ(l.factorization.steps.size(), 3U);
  expect_step(l, 0, false, mask(0, "-1/4,-1/4"));
  expect_step(l, 1, true, mask(-1, "-1,-1"));
  expect_step(l, 2, false, mask(0, "3/16,3/16"));
  EXPECT_EQ(l.factorization.norm, RationalFunction(Rational(1, 2)));
  const Lifting four = complete(symbol_of("bspline:n=3"), polynomials(4));
  EXPECT_EQ(four.factorization.steps.size(), 3U);
  EXPECT_EQ(vanishing_moments(four.bank.synthesis_high), 4U);
  EXPECT_EQ(vanishing_moments(four.bank.analysis_high), 4U);
}

// Sweldens 1996: the update of an interpolatory mask is half its predictor, turned.
TEST(Lifting, InterpolatoryPairs) {
  const Laurent four = symbol_of("dd:l=2");
  for (const unsigned n : {2U, 4U}) {
    const Lifting l = complete(four, polynomials(n));
    ASSERT_EQ(l.factorization.steps.size(), 2U);
    const Laurent predictor = symbol_of(n == 2 ? "dd:l=1" : "dd:l=2").subsymbol(2, 1);
    expect_step(l, 0, true, RationalFunction(-1) * four.subsymbol(2, 1));
    expect_step(l, 1, false, RationalFunction(Rational(1, 2)) * reversed(predictor));
    EXPECT_EQ(vanishing_moments(l.bank.synthesis_high), n);
    EXPECT_EQ(vanishing_moments(l.bank.analysis_high), 4U);
  }
}

TEST(Lifting, ExponentialPairs) {
  // Hat functions of {e^{tx}, e^{-tx}} over those of {1, x}, and the other way round.
  const std::string exponentials = "exp(t*x),exp(-t*x)";
  const Laurent hat = symbol_of("interpolating:space=\"" + exponentials + "\"");
  const Lifting l = complete(hat, Space::parse(exponentials));
  expect_step(l, 0, true, mask(-1, "-1/(2*v),-1/(2*v)"));
  expect_step(l, 1, false, mask(0, "1/(4*v),1/(4*v)"));
  const Laurent annihilated = knot_polynomial(Space::parse(exponentials), 1);
  EXPECT_TRUE(Laurent::quotient(l.bank.synthesis_high, annihilated));
  EXPECT_TRUE(Laurent::quotient(l.bank.analysis_high, annihilated));
  const Lifting mixed = complete(mask(-1, "1/2,1,1/2"), Space::parse(exponentials));
  EXPECT_TRUE(Laurent::quotient(mixed.bank.synthesis_high, annihilated));
  EXPECT_EQ(vanishing_moments(mixed.bank.analysis_high), 2U);
  // v = 1 gives the polynomial pair.
  EXPECT_EQ(mixed.bank.analysis_low.substitute("v", 1),
            complete(mask(-1, "1/2,1,1/2"), polynomials(2)).bank.analysis_low);

  const Laurent tension = symbol_of("tension4");
  const Space space = Space::parse("1,x,exp(t*x),exp(-t*x)");
  const Lifting t = complete(tension, space);
  expect_step(t, 1, false, RationalFunction(Rational(1, 2)) * reversed(tension.subsymbol(2, 1)));
  EXPECT_TRUE(Laurent::quotient(t.bank.synthesis_high, knot_polynomial(space, 1)));

  const Lifting spline = complete(symbol_of("mixed:n=1"), space);
  EXPECT_EQ(spline.factorization.steps.size(), 3U);
  EXPECT_TRUE(Laurent::quotient(spline.bank.synthesis_high, knot_polynomial(space, 1)));
  const Lifting dual_order = complete(symbol_of("exponential-bspline:space=\"1,cos(s*x),sin(s*x)\""), polynomials(1));
  EXPECT_TRUE(reconstructs(dual_order.bank));
  EXPECT_GE(vanishing_moments(dual_order.bank.synthesis_high), 1U);
}

// A bank of random steps is found again, with no more steps than it was made of.
TEST(Lifting, RandomBanksAreFactored) {
  std::mt19937 random(20261125);
  const auto pick = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
  for (int round = 0; round < 60; ++round) {
    LiftingFactorization f;
    const int count = pick(1, 4);
    bool predict = pick(0, 1) == 0;
    for (int i = 0; i < count; ++i, predict = !predict) {
      std::vector<RationalFunction> c;
      for (int n = pick(1, 2); n > 0; --n) {
        RationalFunction x = Rational(pick(1, 5) * (pick(0, 1) == 0 ? 1 : -1), pick(1, 4));
        if (round % 3 == 0) x = x / (RationalFunction::variable("v") + RationalFunction(pick(0, 2)));
        c.push_back(x);
      }
      f.steps.push_back({predict, Laurent(pick(-1, 1), std::move(c))});
    }
    f.norm = Rational(pick(1, 5), pick(1, 5));
    f.delay = pick(-1, 1);
    const FilterBank bank = expand(f);
    ASSERT_TRUE(reconstructs(bank));
    const Lifting l = factor_pair(bank.synthesis_low, RationalFunction(2) * bank.analysis_low);
    EXPECT_EQ(l.bank.synthesis_high, bank.synthesis_high);
    EXPECT_EQ(l.bank.analysis_high, bank.analysis_high);
    const FilterBank again = expand(l.factorization);
    EXPECT_EQ(again.synthesis_low, bank.synthesis_low);
    EXPECT_EQ(again.analysis_low, bank.analysis_low);
    EXPECT_LE(l.factorization.steps.size(), f.steps.size() + 1);
  }
}

TEST(Lifting, ABrokenBankDoesNotReconstruct) {
  FilterBank bank = complete(mask(-1, "1/2,1,1/2"), polynomials(2)).bank;
  ASSERT_TRUE(reconstructs(bank));
  FilterBank broken = bank;
  broken.analysis_low = broken.analysis_low + Laurent::monomial(3, RationalFunction(Rational(1, 1000000)));
  EXPECT_FALSE(reconstructs(broken));
  broken = bank;
  broken.synthesis_high = broken.synthesis_high.shifted(2);
  EXPECT_FALSE(reconstructs(broken));
}

TEST(Lifting, RefusalsNameWhatIsWrong) {
  // (1 + z^2)(1 + z)^2: even and odd part share 1 + y.
  EXPECT_NE(message([] { complete(mask(0, "1/4,1/2,1/2,1/2,1/4"), polynomials(2)); }).find("y + (1)"),
            std::string::npos);
  EXPECT_NE(message([] { complete(mask(0, "1,0,1"), {}); }).find("y + (1)"), std::string::npos);
  EXPECT_NE(message([] { factor_pair(mask(-1, "1/2,1,1/2"), mask(-1, "1/2,1,1/2")); }).find("1/4"), std::string::npos);
  // A common factor that depends on the parameter.
  EXPECT_NE(message([] { complete(mask(0, "1,1,v,v"), {}); }).find("y"), std::string::npos);
}

TEST(Lifting, TheDomainIsReported) {
  // Even part 1 + w y, odd part 2 + y: a common zero where 1 - 2 w = 0.
  const Lifting l = complete(mask(0, "1,2,w,1"), {});
  ASSERT_EQ(l.domain.common_zero.size(), 1U);
  EXPECT_EQ(l.domain.common_zero[0], Polynomial(2) * Polynomial::variable("w") - 1);
  EXPECT_FALSE(l.domain.poles.empty());
  const Lifting none = complete(symbol_of("tension4"), polynomials(2));
  EXPECT_TRUE(none.domain.common_zero.empty());
  for (const Polynomial& p : none.domain.poles) EXPECT_TRUE(p.all_coefficients_nonnegative());
}

// sigma(z) and sigma(-z) have a common zero, that is no dual exists, exactly where two nodes have sum 0: where the
// interpolating scheme of the space is singular.
TEST(Lifting, SplinesHaveNoDualWhereTheInterpolatingSchemeIsSingular) {
  for (const char* name : {"harmonic:n=2", "harmonic:n=3", "mixed:n=3", "resonant:n=2",
                           "exponential-bspline:space=\"1,x,cos(s*x),sin(s*x),cos(3*s*x),sin(3*s*x)\""}) {
    const Scheme s = make_scheme(name);
    const auto node = nodes(*s.space);
    std::vector<std::string> expected, found;
    for (size_t i = 0; i < node.size(); ++i)
      for (size_t j = i; j < node.size(); ++j)
        for (const auto& [f, e] : sum_of_nodes(*s.space, node[i], node[j]).factors) expected.push_back(f.to_string());
    for (const Polynomial& f : complete(symbol(s), {}).domain.common_zero) found.push_back(f.to_string());
    std::sort(expected.begin(), expected.end());
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    std::sort(found.begin(), found.end());
    // 1 + v divides the normalisation as well; it is positive.
    std::erase(expected, "v+1");
    std::erase(found, "v+1");
    EXPECT_EQ(found, expected) << name;
  }
}

// rec_lo dec_lo + rec_hi dec_hi = 2 z^{n-1}, and no alias.
TEST(Lifting, OrthonormalLayoutReconstructs) {
  for (const char* name : {"dd:l=1", "dd:l=2", "tension4", "bspline:n=2", "bspline:n=3", "mixed:n=1"}) {
    const Scheme s = make_scheme(name);
    const FilterBank bank = complete(symbol(s), polynomials(2)).bank;
    const OrthonormalLayout o = orthonormal_layout(bank);
    EXPECT_EQ(o.length % 4, 2);
    for (const Laurent* f : {&o.dec_lo, &o.dec_hi, &o.rec_lo, &o.rec_hi}) {
      EXPECT_GE(f->lowest(), 0) << name;
      EXPECT_LT(f->highest(), o.length) << name;
    }
    const auto turned = [](const Laurent& a) {  // a(-z)
      std::vector<RationalFunction> c = a.coefficients();
      for (size_t i = 0; i < c.size(); ++i)
        if ((a.lowest() + static_cast<long>(i)) % 2 != 0) c[i] = -c[i];
      return Laurent(a.lowest(), std::move(c));
    };
    EXPECT_EQ(o.rec_lo * o.dec_lo + o.rec_hi * o.dec_hi, Laurent::monomial(o.length - 1, 2)) << name;
    EXPECT_TRUE((o.rec_lo * turned(o.dec_lo) + o.rec_hi * turned(o.dec_hi)).is_zero()) << name;
  }
}

}  // namespace
}  // namespace twoscale
