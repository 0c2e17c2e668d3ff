// SPDX-License-Identifier: GPL-3.0-or-later
/// Symbols of exponential B-splines: zeros, normalisation, binomials, generation, for several arities.
#include "twoscale/symbolic/symbol.hpp"

#include "support/laws.hpp"
#include "symbolic/exact_points.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/interpolatory.hpp"

namespace twoscale::tests {
namespace {

Space polynomials(unsigned order) { return Space::one_frequency(order, {}); }

LAW(BsplineSymbol, HasThePairFactorOfEveryNode, (const Space& space)) {
  Laurent rest = bspline_symbol(space);
  for (const Polynomial& w : cosh_nodes(space)) {
    const auto q = Laurent::quotient(rest, Laurent(0, {1, RationalFunction(Polynomial(2) * w), 1}));
    LAW_ASSERT(q.has_value());
    rest = *q;
  }
  if (space.polynomial_order() % 2 == 1) {
    const auto q = Laurent::quotient(rest, Laurent(0, {1, 1}));
    LAW_ASSERT(q.has_value());
    rest = *q;
  }
  LAW_ASSERT(rest.coefficients().size() == 1U);  // nothing else
}

LAW(BsplineSymbol, NormalisedSymmetricCentred, (const Space& space)) {
  const long m = uniform(2L, 5L);
  LAW_GIVEN(m == 2L || space.dimension() <= 6U);
  const Laurent a = bspline_symbol(space, static_cast<int>(m));
  LAW_ASSERT(a.is_canonical());
  LAW_ASSERT(a.at_one() == RationalFunction(m));
  const long length = static_cast<long>(space.dimension()) * (m - 1);
  LAW_ASSERT(a.highest() - a.lowest() == length);
  LAW_ASSERT(a.centre_of_symmetry().has_value());
  LAW_ASSERT(*a.centre_of_symmetry() == Rational(length % 2, 2));
}

/// Generation, by its definition at exact points: in every residue class the same combination of a sample.
LAW(BsplineSymbol, GeneratesItsSpace, (const Space& space)) {
  const long m = uniform(2L, 5L);
  LAW_GIVEN(m == 2L || space.dimension() <= 6U);
  const auto e = exponential_points(space, uniform<size_t>(0, 5));
  const auto mask = mask_at(bspline_symbol(space, static_cast<int>(m)), level_values(space, e));
  LAW_ASSERT(mask.has_value());  // no pole for real frequencies
  for (const Function& f : basis(space, e)) {
    // sum_{i = s mod m} i^r a_i z^i does not depend on s; z = e^{-theta}, and the space holds both signs.
    std::vector<Rational> sums(static_cast<size_t>(m));
    for (const auto& [i, value] : *mask) sums[static_cast<size_t>(((i % m) + m) % m)] += value * f(i);
    for (const Rational& s : sums) LAW_ASSERT(s == sums[0]);
  }
}

TEST(BsplineSymbol, PolynomialsAreBinomials) {
  for (unsigned n = 0; n <= 9; ++n) {
    const Laurent a = bspline_symbol(polynomials(n + 1));
    for (long i = 0; i <= static_cast<long>(n) + 1; ++i)
      EXPECT_EQ(a.coefficient(a.lowest() + i).constant(),
                Rational::binomial(Rational(static_cast<long>(n) + 1), static_cast<unsigned>(i)) *
                    Rational(2).pow(-static_cast<long>(n)));
  }
}

TEST(BsplineSymbol, PolynomialsOfAnyArity) {
  // m ((1 + z + ... + z^{m-1})/m)^{n+1}
  for (long m = 2; m <= 6; ++m)
    for (unsigned n = 0; n <= 4; ++n) {
      const Laurent s(0, std::vector<RationalFunction>(static_cast<size_t>(m), RationalFunction(Rational(1, m))));
      Laurent product = Laurent::monomial(0, RationalFunction(m));
      for (unsigned i = 0; i <= n; ++i) product = product * s;
      EXPECT_EQ(bspline_symbol(polynomials(n + 1), static_cast<int>(m)), centred(product)) << m << " " << n;
    }
}

/// The two-scale relation itself: m^2 refinement in two steps of m is refinement by the product symbol a(z) a(z^m).
TEST(BsplineSymbol, TwoStepsOfTwoAreOneOfFour) {
  for (unsigned n = 0; n <= 5; ++n) {
    const Laurent two = bspline_symbol(polynomials(n + 1), 2);
    EXPECT_EQ(centred(two * two.dilated(2)), bspline_symbol(polynomials(n + 1), 4)) << n;
    const Laurent three = bspline_symbol(polynomials(n + 1), 3);
    EXPECT_EQ(centred(three * three.dilated(3)), bspline_symbol(polynomials(n + 1), 9)) << n;
  }
}

LAW(BsplineSymbol, TwoStepsOfTwoAreOneOfFourWithLevels, (const Space& space)) {
  // The coarser step has v^k = T_2(v^{k+1}); arity 4 is written in the same finest variable.
  LAW_GIVEN(space.dimension() <= 6U);
  const Laurent fine = bspline_symbol(space, 2);
  Laurent coarse = fine;
  for (const auto& v : space.variables()) coarse = coarse.substitute(v.name, Polynomial::chebyshev(v.name, 2));
  LAW_ASSERT(centred(fine * coarse.dilated(2)) == bspline_symbol(space, 4));
}

TEST(BsplineSymbol, AtOneIsThePolynomialBspline) {
  for (const char* text : {"1,x,exp(t*x),exp(-t*x)", "exp(t*x),exp(-t*x),exp(3*t*x),exp(-3*t*x)",
                           "1,cos(s*x),sin(s*x),exp(t*x),exp(-t*x)"}) {
    const Space space = Space::parse(text);
    for (int m = 2; m <= 4; ++m) {
      Laurent a = bspline_symbol(space, m);
      for (const auto& v : space.variables()) a = a.substitute(v.name, 1);
      EXPECT_EQ(a, bspline_symbol(polynomials(space.dimension()), m)) << text << " " << m;
    }
  }
}

TEST(BsplineSymbol, RefusesOtherArities) {
  EXPECT_THROW(bspline_symbol(polynomials(2), 1), Error);
  EXPECT_THROW(bspline_symbol(polynomials(2), 0), Error);
  EXPECT_THROW(bspline_symbol(polynomials(2), 65), Error);
}

TEST(SumOfNodes, ExpandsToTheSumIntoIrreducibles) {
  const Space space = Space::parse("1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)");
  const auto value = [&](const Node& n) {
    return n.multiple == 0 ? Polynomial(1) : Polynomial::chebyshev(space.variables()[n.variable].name, n.multiple);
  };
  for (unsigned a = 0; a <= 12; ++a)
    for (unsigned b = 0; b <= 12; ++b)
      for (const size_t other : {size_t{0}, size_t{1}}) {
        if (other == 1 && (a > 4 || b > 4)) continue;
        const Node x{0, a};
        const Node y{b == 0 ? 0 : other, b};
        const FactoredPolynomial f = sum_of_nodes(space, x, y);
        EXPECT_EQ(f.expanded(), value(x) + value(y)) << a << " " << b;
        for (size_t i = 0; i < f.factors.size(); ++i) {
          const auto g = f.factors[i].first.factor();
          EXPECT_EQ(g.factors.size(), 1U);
          EXPECT_EQ(g.content, Rational(1));
          EXPECT_EQ(g.factors[0].second, 1U);
          if (i > 0) {
            EXPECT_LT(Polynomial::compare(f.factors[i - 1].first, f.factors[i].first), 0);
          }
        }
      }
}

// ---- Extension of data by the space

/// p_{-1} = sum e_j p_j for samples at spacing 1/m^k, that is at multiples of m of the fine spacing.
LAW(ExtensionWeights, ContinueEveryFunctionOfTheSpace, (const Space& space)) {
  const int m = uniform(2, 5);
  const auto e = exponential_points(space, uniform<size_t>(0, 5));
  const Values at = level_values(space, e);
  const auto weights = extension_weights(space, m);
  LAW_ASSERT(weights.size() == static_cast<size_t>(space.dimension()));
  for (const Function& f : basis(space, e))
    for (const long start : {0L, 3L, -2L}) {
      Rational before, after;
      for (size_t j = 0; j < weights.size(); ++j) {
        const Rational w = weights[j].evaluate(at);
        before += w * f(m * (start + static_cast<long>(j)));
        after += w * f(m * (start - static_cast<long>(j)));
      }
      LAW_ASSERT(before == f(m * (start - 1)));
      LAW_ASSERT(after == f(m * (start + 1)));  // reversed it extends the other end
    }
}

TEST(ExtensionWeights, LinearIsTheRuleOfBeccari) {
  // beccari2007 (9): p_{-1} = 2 p_0 - p_1
  EXPECT_EQ(extension_weights(polynomials(2)), (std::vector<Polynomial>{2, -1}));
  EXPECT_EQ(extension_weights(polynomials(1)), (std::vector<Polynomial>{1}));
  EXPECT_EQ(extension_weights(polynomials(3)), (std::vector<Polynomial>{3, -3, 1}));
}

}  // namespace
}  // namespace twoscale::tests
