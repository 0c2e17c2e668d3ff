// SPDX-License-Identifier: GPL-3.0-or-later
// From masks to matrices: division by S_m, transition matrices and their products, the central matrix, positivity on
// the circle, stability of the integer shifts.
#include "twoscale/analysis/remainder.hpp"

#include <cmath>

#include "masks.hpp"
#include "support/laws.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::analysis {
namespace {

using masks::convolved;
using masks::dilated;
using masks::laurent;
using masks::mean;
using masks::power;
using masks::Rationals;
using masks::times;

Remainder remainder_of(const std::string& name) {
  const Scheme s = make_scheme(name);
  return *remainder(*limit_symbol(s), s.arity);
}

// One to eight coefficients, both ends not zero.
Rationals coefficients() {
  for (;;) {
    Rationals c = several(uniform<size_t>(1, 9), [] {
      const long n = uniform(-5L, 6L);
      return Rational(n, uniform(1L, 5L));
    });
    if (!c.front().is_zero() && !c.back().is_zero()) return c;
  }
}

// ---- division

TEST(Remainder, KnownMasks) {
  EXPECT_EQ(remainder_of("dd:l=2").order, 4);
  EXPECT_EQ(remainder_of("dd:l=2").c, (Rationals{-1, 4, -1}));
  EXPECT_EQ(remainder_of("dd:l=5").order, 10);
  for (int m = 2; m <= 5; ++m)
    for (int n = 0; n <= 5; ++n) {
      const Remainder r = remainder_of("bspline:n=" + std::to_string(n) + ",arity=" + std::to_string(m));
      EXPECT_EQ(r.order, n + 1);
      EXPECT_EQ(r.c, Rationals{m});
    }
  const Laurent none = laurent({1, 0, 0, Rational(1)});  // sums of cosets 1 and 1: order 1
  EXPECT_EQ(remainder(none, 2)->order, 1);
  EXPECT_EQ(remainder(laurent({2}), 2)->order, 0);
  EXPECT_THROW(remainder(Laurent(), 2), Error);
  EXPECT_THROW(remainder(Laurent(0, {RationalFunction::variable("w"), 1}), 2), Error);
}

TEST(Remainder, AGivenOrder) {
  const Laurent a = *limit_symbol(make_scheme("dd:l=3"));
  for (long order = 0; order <= 6; ++order) {
    const auto r = remainder(a, 2, order);
    ASSERT_TRUE(r);
    EXPECT_EQ(r->order, order);
    EXPECT_EQ(r->c.size(), static_cast<size_t>(11 - order));
  }
  EXPECT_FALSE(remainder(a, 2, 7));
}

LAW(RemainderLaws, TheProductIsTheMask, ()) {
  const long m = uniform(2L, 6L);
  const Rationals c = coefficients();
  const long factors = uniform(0L, 5L);
  const long lowest = uniform(-5L, 6L);
  const Rationals a = convolved(c, power(mean(m), factors));
  const Remainder r = *remainder(laurent(a, lowest), m);
  LAW_ASSERT(r.arity == m);
  LAW_ASSERT(r.order >= factors);
  LAW_ASSERT(convolved(r.c, power(mean(m), r.order)) == a);
  // N is the largest: c has not the same sum over every coset.
  Rationals sums(static_cast<size_t>(m));
  for (size_t i = 0; i < r.c.size(); ++i) sums[i % static_cast<size_t>(m)] += r.c[i];
  LAW_ASSERT(std::any_of(sums.begin(), sums.end(), [&](const Rational& s) { return !(s == sums[0]); }));
  LAW_ASSERT(r.c == remainder(laurent(a, 0), m, r.order)->c);
}

// ---- matrices

TEST(TransitionMatrices, FourPoints) {
  const Family f = transition_matrices(remainder_of("dd:l=2"));
  ASSERT_EQ(f.size(), 2U);
  ASSERT_EQ(f[0].rows(), 2);
  const auto at = [&](size_t s) { return Rationals{f[s](0, 0), f[s](0, 1), f[s](1, 0), f[s](1, 1)}; };
  EXPECT_EQ(at(0), (Rationals{4, 0, -1, -1}));
  EXPECT_EQ(at(1), (Rationals{-1, -1, 0, 4}));
}

TEST(TransitionMatrices, Splines) {
  for (int m = 2; m <= 5; ++m) {
    const Family f = transition_matrices(remainder_of("bspline:n=3,arity=" + std::to_string(m)));
    ASSERT_EQ(f.size(), static_cast<size_t>(m));
    for (int s = 0; s < m; ++s) {
      EXPECT_EQ(f[static_cast<size_t>(s)].rows(), 1);
      EXPECT_EQ(f[static_cast<size_t>(s)](0, 0), Rational(s == m - 1 ? m : 0));
    }
  }
}

// The entries of all products of n matrices are the coefficients of c(z) c(z^m) ... c(z^{m^{n-1}}), and zeros.
LAW(TransitionMatricesLaws, ProductsHoldTheIteratedCoefficients, ()) {
  Remainder r;
  r.arity = uniform(2L, 5L);
  r.c = coefficients();
  const Family family = transition_matrices(r);
  const int n = uniform(1, r.arity == 2 ? 5 : 4);
  std::vector<RationalMatrix> products{RationalMatrix::identity(family[0].rows())};
  Rationals iterated{1};
  long stride = 1;
  for (int k = 0; k < n; ++k, stride *= r.arity) {
    std::vector<RationalMatrix> next;
    for (const auto& p : products)
      for (const auto& b : family) next.push_back(b * p);
    products = std::move(next);
    iterated = convolved(iterated, dilated(r.c, stride));
  }
  std::vector<Rational> entries, expected{0};
  for (const auto& p : products)
    for (long i = 0; i < p.rows(); ++i)
      for (long j = 0; j < p.columns(); ++j) entries.push_back(p(i, j));
  entries.emplace_back(0);
  expected.insert(expected.end(), iterated.begin(), iterated.end());
  for (auto* list : {&entries, &expected}) {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  LAW_ASSERT(entries == expected);
}

// ---- symmetric symbols

TEST(SymmetricHalf, KnownOnes) {
  EXPECT_EQ(symmetric_half({-1, 4, -1}), (Rationals{4, -1}));
  EXPECT_EQ(symmetric_half({5}), Rationals{5});
  EXPECT_FALSE(symmetric_half({1, 1}));
  EXPECT_FALSE(symmetric_half({1, 2, 3}));
}

double on_circle(const Rationals& g, double t) {
  double sum = fmpq_get_d(g[0].raw());
  for (size_t k = 1; k < g.size(); ++k) sum += 2 * fmpq_get_d(g[k].raw()) * std::cos(static_cast<double>(k) * t);
  return sum;
}

LAW(SymbolLaws, AutocorrelationIsTheSquareOfTheModulus, ()) {
  const Rationals c = coefficients();
  const Rationals g = autocorrelation(c);
  LAW_ASSERT(g.size() == c.size());
  Rationals reversed(c.rbegin(), c.rend());
  LAW_ASSERT(symmetric_half(convolved(c, reversed)) == g);
  const Polynomial p = cosine_polynomial(g);
  LAW_ASSERT(nonnegative_on_circle(p));
}

LAW(SymbolLaws, CosinePolynomial, ()) {
  const Rationals g = coefficients();
  const Polynomial p = cosine_polynomial(g);
  const std::string x = p.is_constant() ? "x" : p.variables()[0];
  // Proportional by a positive factor to g_0 + 2 sum g_k T_k.
  Rational common = 1;
  for (const auto& q : g) common = common * Rational(q.denominator()) / gcd(common, Rational(q.denominator()));
  Polynomial expected = 0;
  for (size_t k = 0; k < g.size(); ++k)
    expected += Polynomial::chebyshev(x, static_cast<unsigned>(k)).scaled(common * g[k] * Rational(k == 0 ? 1 : 2));
  LAW_ASSERT(!p.is_zero() && !expected.is_zero());
  const Rational ratio = expected.content() / p.content();
  LAW_ASSERT(expected.scaled(ratio.inverse()) == p);
}

LAW(SymbolLaws, NonNegativeAsSampled, ()) {
  Rationals g = coefficients();
  if (uniform(0, 2) == 0) g[0] = g[0] + Rational(uniform(0L, 12L));
  LAW_GIVEN(!g[0].is_zero() || g.size() > 1);
  const bool nonnegative = nonnegative_on_circle(cosine_polynomial(g));
  double least = 1e300;
  for (int i = 0; i <= 2000; ++i) least = std::min(least, on_circle(g, 3.14159265358979 * i / 2000));
  if (least < -1e-9) LAW_ASSERT(!nonnegative);
  if (least > 1e-3) LAW_ASSERT(nonnegative);
}

TEST(NonNegative, DoubleZerosAreAllowed) {
  EXPECT_TRUE(nonnegative_on_circle(cosine_polynomial({2, 1})));  // 2 + 2 cos t
  EXPECT_FALSE(nonnegative_on_circle(cosine_polynomial({Rational(199, 100), 1})));
  EXPECT_TRUE(nonnegative_on_circle(cosine_polynomial({6, 4, 1})));  // (2 + 2 cos t)^2
  EXPECT_TRUE(nonnegative_on_circle(cosine_polynomial({3, 2, 1})));  // |1 + z + z^2|^2
  EXPECT_FALSE(nonnegative_on_circle(cosine_polynomial({Rational(2999, 1000), 2, 1})));
  EXPECT_FALSE(nonnegative_on_circle(cosine_polynomial({0, 1})));
  EXPECT_TRUE(nonnegative_on_circle(cosine_polynomial({4, -1})));
}

TEST(CentralRadius, KnownOnes) {
  EXPECT_EQ(central_radius({4, -1}, 2).radius.rational(), Rational(4));
  EXPECT_EQ(central_radius({2}, 2).radius.rational(), Rational(2));
  EXPECT_EQ(central_radius(*symmetric_half(remainder_of("dd:l=3").c), 2).radius.rational(), Rational(9));
  EXPECT_TRUE(central_radius(*symmetric_half(remainder_of("dd:l=3").c), 2).simple);
}

// Where both apply, the joint spectral radius is the central one.
LAW(CentralRadiusLaws, IsTheJointSpectralRadius, ()) {
  const Rationals half = coefficients();
  Remainder r;
  r.arity = uniform(2L, 4L);
  r.c = convolved(half, Rationals(half.rbegin(), half.rend()));  // |half|^2 >= 0
  LAW_GIVEN(r.c.size() <= 9U);
  const RealAlgebraic central = central_radius(*symmetric_half(r.c), r.arity).radius;
  JsrOptions options;
  options.vertices = 200;
  options.seconds = 1.5;
  try {
    const JsrResult found = joint_spectral_radius(transition_matrices(r), {}, options);
    LAW_ASSERT(RealAlgebraic::compare(found.lower, central) <= 0);
    LAW_ASSERT(RealAlgebraic::compare(central, found.upper) <= 0);
    if (found.exact) LAW_ASSERT(*found.exact == central);
  } catch (const Error& e) {
    LAW_ASSERT(e.kind == Error::Kind::undecided);
  }
}

// ---- stability

TEST(ShiftStability, KnownOnes) {
  for (const char* name : {"dd:l=1", "dd:l=4", "bspline:n=0", "bspline:n=3", "bspline:n=2,arity=3", "tension4"}) {
    const Scheme s = make_scheme(name);
    EXPECT_TRUE(shift_stability(*limit_symbol(s), s.arity).stable) << name;
  }
  // A box of length 3: 1, z^3.
  const Stability three = shift_stability(laurent({1, 0, 0, 1}), 2);
  EXPECT_FALSE(three.stable);
  EXPECT_FALSE(three.common_zero);
  EXPECT_EQ(three.cycle, 3);
  EXPECT_EQ(shift_stability(laurent({1, 0, 0, 0, 0, 1}), 2).cycle, 5);
  // Ternary: a box of length 2 is 1 + z^2 + z^4.
  EXPECT_EQ(shift_stability(laurent({1, 0, 1, 0, 1}), 3).cycle, 2);
  // A box of length 2: both sub-symbols are (1 + z)/... at z = -1 zero.
  const Stability two =
      shift_stability(laurent(Rationals{Rational(1, 2), Rational(1, 2), Rational(1, 2), Rational(1, 2)}), 2);
  EXPECT_FALSE(two.stable);
  EXPECT_TRUE(two.common_zero);
}

// Zeros at roots of unity of even order 6 form no cycle under doubling; those of order 3 do.
TEST(ShiftStability, OnlyCyclesCount) {
  const Rationals hat = power(mean(2), 2);
  EXPECT_TRUE(shift_stability(laurent(times(Rational(2, 3), convolved(hat, {1, 1, 1}))), 2).stable);
  const Stability s = shift_stability(laurent(times(Rational(2), convolved(hat, {1, -1, 1}))), 2);
  EXPECT_FALSE(s.stable);
  EXPECT_EQ(s.cycle, 3);
}

// B-splines are stable; a factor q(z^m)/q(1) with a zero of q on the circle makes the sub-symbols share it.
LAW(ShiftStabilityLaws, CommonFactors, ()) {
  const long m = uniform(2L, 5L);
  const Rationals base = power(mean(m), uniform(1L, 4L));
  Rationals a = base;
  for (auto& x : a) x *= Rational(m);
  LAW_ASSERT(shift_stability(laurent(a), m).stable);
  const std::vector<Rationals> all{{1, 1}, {1, 0, 1}, {1, 1, 1}, {5, -6, 5}};  // the last: zeros (3 +- 4i)/5
  const Rationals q = all[uniform<size_t>(0, all.size())];
  Rational sum;
  for (const auto& x : q) sum += x;
  const Stability with = shift_stability(laurent(convolved(a, dilated(times(sum.inverse(), q), m))), m);
  LAW_ASSERT(!with.stable);
  LAW_ASSERT(with.common_zero);
  // Zeros off the circle do no harm.
  LAW_ASSERT(shift_stability(laurent(convolved(a, dilated({Rational(3, 4), Rational(1, 4)}, m))), m).stable);
}

TEST(ShiftStability, LongBoxes) {
  for (long m = 2; m <= 5; ++m)
    for (long n = 2; n <= 7; ++n) {
      // (1 - z^{mn})/(1 - z^n): the box of length n.
      Rationals a(static_cast<size_t>((m - 1) * n + 1));
      for (long i = 0; i < m; ++i) a[static_cast<size_t>(i * n)] = 1;
      if (remainder(laurent(a), m)->order == 0) continue;  // constants are not generated: gcd(m, n) > 1
      const Stability s = shift_stability(laurent(a), m);
      EXPECT_FALSE(s.stable) << m << " " << n;
      if (!s.common_zero) {
        EXPECT_EQ(n % s.cycle, 0) << m << " " << n;
      }
    }
}

}  // namespace
}  // namespace twoscale::analysis
