// SPDX-License-Identifier: GPL-3.0-or-later
/// Interpolating schemes of any arity: the definition, two routes, the stationary limit and the binary engines must
/// give one answer.
#include "twoscale/symbolic/mary_interpolatory.hpp"

#include <cmath>
#include <numeric>
#include <set>

#include "support/laws.hpp"
#include "symbolic/exact_points.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::tests {
namespace {

Space polynomials(unsigned order) { return Space::one_frequency(order, {}); }

/// The definition: the weights c_h, h = lowest.., with sum_h c_h f(h) = f(s/m) for every f in the space, f sampled in
/// units of the fine spacing. No symbol, no symmetry. nullopt if they are not unique.
std::optional<std::vector<Rational>> phase_weights(const Space& space, const std::vector<Rational>& e, long m,
                                                   long lowest, long s) {
  Matrix a;
  const std::vector<Function> functions = basis(space, e);
  for (const Function& f : functions) {
    a.emplace_back();
    for (long j = 0; j < static_cast<long>(functions.size()); ++j) a.back().push_back(f(m * (lowest + j)));
    a.back().push_back(f(s));
  }
  if (eliminate(a).is_zero()) return std::nullopt;
  std::vector<Rational> c;
  for (const auto& row : a) c.push_back(row.back());
  return c;
}

/// prod_{j != h} (s/m - j)/(h - j), h = lowest..lowest+n-1.
Rational lagrange(long n, long lowest, long h, const Rational& at) {
  Rational c = 1;
  for (long j = lowest; j < lowest + n; ++j)
    if (j != h) c *= (at - Rational(j)) / Rational(h - j);
  return c;
}

/// Everything that is asked of zeta and omega; empty if all is well.
std::string fault(const Space& space, int arity) {
  const long m = arity;
  const long n = space.dimension();
  const bool odd = n % 2 == 1;
  const long l = n / 2;
  const Laurent zeta = mary_interpolating_symbol(space, arity);
  const HessenbergSystem h = hessenberg_system(space, arity);
  if (!zeta.is_canonical() || !h.omega.is_canonical()) return "not canonical";
  if (!(bspline_symbol(space, arity) * h.omega == zeta)) return "zeta is not sigma omega";
  if (!(zeta.subsymbol(m, 0) == Laurent::monomial(0))) return "zeta is not interpolatory";
  if (zeta.centre_of_symmetry() != Rational(0) || h.omega.centre_of_symmetry() != Rational(0)) return "centre";
  const long reach = odd ? m * l + (m - 1) / 2 : m * l - 1;
  if (zeta.highest() > reach || zeta.lowest() < -reach) return "support";
  if (space.polynomial_order() > 0 && !(zeta.at_one() == RationalFunction(m))) return "zeta(1)";
  if (!(omega_from_folded(folded_system(space, arity)) == h.omega)) return "the folded system has another solution";
  const long lowest = odd ? -l : 1 - l;
  const long s_first = odd ? -(m - 1) / 2 : 0;
  for (const size_t variant : {size_t{0}, size_t{2}}) {
    const auto e = exponential_points(space, variant);
    const auto mask = mask_at(zeta, level_values(space, e));
    if (!mask) return "pole at a real frequency";
    for (long s = s_first; s < s_first + m; ++s) {
      const auto weights = phase_weights(space, e, m, lowest, s);
      if (!weights) return "not unique at a real frequency";
      for (long j = 0; j < n; ++j) {
        const auto at = mask->find(s - m * (lowest + j));
        if ((at == mask->end() ? Rational(0) : at->second) != (*weights)[static_cast<size_t>(j)])
          return "not the interpolating weights of the space";
      }
    }
    for (const Function& f : basis(space, e))
      for (const long i : {0L, 1L, 2L, 5L, -4L})
        if (refined(*mask, m, f, i) != f(i)) return "does not reproduce the space";
    const Values at = level_values(space, e);
    Matrix folded = values(folded_system(space, arity).matrix, at);
    if (eliminate(folded) != folded_determinant(space, folded_system(space, arity), arity).evaluate(at))
      return "determinant of the folded system";
  }
  Laurent limit = zeta;
  for (const auto& v : space.variables()) limit = limit.substitute(v.name, 1);
  for (long s = s_first; s < s_first + m; ++s)
    for (long j = lowest; j < lowest + n; ++j)
      if (!(limit.coefficient(s - m * j) == RationalFunction(lagrange(n, lowest, j, Rational(s, m)))))
        return "the limit is not the Deslauriers-Dubuc scheme of that arity";
  if (arity == 2 && !(zeta == interpolating_symbol(space))) return "differs from the binary engines";
  return "";
}

LAW(MaryInterpolatory, EveryRouteOnAnySpace, (const Space& space)) {
  const int arity = uniform(2, 6);
  LAW_GIVEN(has_interpolating_scheme(space, arity));
  LAW_GIVEN(static_cast<unsigned>(arity) * space.dimension() <= 24U);
  LAW_ASSERT(fault(space, arity) == "");
}

TEST(MaryInterpolatory, FamiliesOfEveryArity) {
  for (const int arity : {2, 3, 4, 5, 6, 7})
    for (const char* family : {"mixed", "harmonic", "resonant"})
      for (unsigned l = 2; l <= (arity <= 3 ? 4U : 3U); ++l)
        EXPECT_EQ(fault(family_space(family, family_member(family, l)), arity), "") << family << l << " " << arity;
  for (const char* text : {"x,1,x^2,cos(t*x),sin(t*x)", "1,cos(t*x),sin(t*x),cos(2*t*x),sin(2*t*x)",
                           "1,exp(t*x),exp(-t*x),x*exp(t*x),x*exp(-t*x)", "1,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)"})
    for (const int arity : {3, 5}) EXPECT_EQ(fault(Space::parse(text), arity), "") << text << " " << arity;
}

/// Four equal nodes: the confluent recurrence beyond its start.
TEST(MaryInterpolatory, RepeatedNodes) {
  EXPECT_EQ(fault(Space::parse("exp(t*x),exp(-t*x),x*exp(t*x),x*exp(-t*x),exp(2*t*x),exp(-2*t*x),x*exp(2*t*x),"
                               "x*exp(-2*t*x)"),
                  3),
            "");
  EXPECT_EQ(fault(family_space("resonant", 4), 3), "");
  EXPECT_EQ(fault(Space::parse("exp(2*t*x),exp(-2*t*x),x*exp(2*t*x),x*exp(-2*t*x),x^2*exp(2*t*x),x^2*exp(-2*t*x),"
                               "x^3*exp(2*t*x),x^3*exp(-2*t*x)"),
                  3),
            "");
  EXPECT_EQ(fault(Space::parse("1,exp(t*x),exp(-t*x),x*exp(t*x),x*exp(-t*x),x^2*exp(t*x),x^2*exp(-t*x)"), 3), "");
}

TEST(MaryInterpolatory, PolynomialsOfManyPoints) {
  for (const auto& [n, m] : {std::pair{1U, 3}, {3U, 3}, {12U, 3}, {13U, 5}, {4U, 64}, {5U, 63}, {32U, 4}}) {
    const Laurent a = mary_interpolating_symbol(polynomials(n), m);
    const long lowest = n % 2 == 1 ? -static_cast<long>(n / 2) : 1 - static_cast<long>(n / 2);
    for (long s = n % 2 == 1 ? (1 - m) / 2 : 0; 2 * s <= m; ++s)
      for (long j = 0; j < static_cast<long>(n); ++j)
        EXPECT_EQ(a.coefficient(s - m * (lowest + j)).constant(), lagrange(n, lowest, lowest + j, Rational(s, m)))
            << n << " " << m;
  }
}

/// The 4-point scheme of {1, x, e^{+-tx}}, the two halves solved by hand (docs/arity.md); its limit by cubic Lagrange
/// interpolation at 1/3.
TEST(MaryInterpolatory, TernaryFourPoint) {
  const Laurent a = interpolating_symbol(family_space("mixed", 1), 3);
  const RationalFunction v = RationalFunction::variable("v");
  const RationalFunction low = RationalFunction(2) * v - 1, high = RationalFunction(2) * v + 1;
  EXPECT_EQ(a.coefficient(4), -(RationalFunction(4) * v + 1) / (RationalFunction(3) * low * high.pow(3)));
  EXPECT_EQ(a.coefficient(-5), RationalFunction(-2) * (v + 1) / (RationalFunction(3) * low * high.pow(3)));
  EXPECT_EQ(a.coefficient(-5) - a.coefficient(4), (RationalFunction(3) * high.pow(3)).inverse());
  const Laurent limit = a.substitute("v", 1);
  const auto weight = [&](long h) { return limit.coefficient(1 - 3 * h).constant().value(); };
  EXPECT_EQ(weight(-1), Rational(-5, 81));
  EXPECT_EQ(weight(0), Rational(60, 81));
  EXPECT_EQ(weight(1), Rational(30, 81));
  EXPECT_EQ(weight(2), Rational(-4, 81));
}

TEST(MaryInterpolatory, OddPointsAreTernaryThreePoint) {
  const Laurent a = interpolating_symbol(polynomials(3), 3);
  EXPECT_EQ(a.lowest(), -4);
  EXPECT_EQ(a.coefficient(4).constant(), Rational(-1, 9));  // f(1/3) = -1/9 f(-1) + 8/9 f(0) + 2/9 f(1)
  EXPECT_EQ(a.coefficient(1).constant(), Rational(8, 9));
  EXPECT_EQ(a.coefficient(-2).constant(), Rational(2, 9));
}

TEST(MaryInterpolatory, WhatHasNoSchemeIsRefused) {
  for (const char* text : {"1", "1,x,x^2", "1,exp(t*x),exp(-t*x)"})
    for (const int arity : {2, 4, 6}) {
      EXPECT_FALSE(has_interpolating_scheme(Space::parse(text), arity));
      EXPECT_THROW(interpolating_symbol(Space::parse(text), arity), Error) << text;
      EXPECT_THROW(hessenberg_system(Space::parse(text), arity), Error) << text;
      EXPECT_THROW(folded_system(Space::parse(text), arity), Error) << text;
    }
  EXPECT_THROW(interpolating_symbol(polynomials(2), 1), Error);
  EXPECT_THROW(interpolating_symbol(polynomials(2), 65), Error);
  EXPECT_THROW(interpolating_symbol(Space(), 3), Error);
}

// ---- The singular set

using Found = std::set<std::pair<Rational, unsigned>>;

Found listed(const Space& space, int arity) {
  Found f;
  for (const auto& v : singular_set(space, arity).values) f.emplace(v.angle, v.level);
  return f;
}

/// The poles of a symbol in one variable (see singular_set_test.cpp): factors are minimal polynomials of cos(2 pi/d),
/// at level k the domain is v > cos(pi/m^{k+1}), and v^0 = cos(m^{k+1} 2 pi j/d).
Found poles(const Laurent& a, long m) {
  Found found;
  for (const auto& c : a.coefficients())
    for (const auto& [f, e] : c.denominator_factors()) {
      unsigned d = 0;
      for (unsigned candidate = 1; candidate <= 400 && d == 0; ++candidate)
        if (Polynomial::cosine_minimal(f.variables()[0], candidate) == f) d = candidate;
      EXPECT_GT(d, 0U) << f.to_string();
      for (unsigned j = 1; d > 0 && 2 * j <= d; ++j) {
        if (std::gcd(j, d) != 1) continue;
        Rational angle = Rational(2L * j, d) * Rational(m);
        for (unsigned k = 0; angle < Rational(1); ++k, angle *= Rational(m)) found.emplace(angle, k);
      }
    }
  return found;
}

LAW(MarySingularSet, EqualsThePolesForAnySpaceOfOneFrequency, (const Space& space)) {
  LAW_GIVEN(space.variables().size() <= 1U);
  const int arity = uniform(2, 6);
  LAW_GIVEN(static_cast<unsigned>(arity) * space.dimension() <= 32U);
  const Laurent a =
      has_interpolating_scheme(space, arity) ? interpolating_symbol(space, arity) : bspline_symbol(space, arity);
  LAW_ASSERT(listed(space, arity) == poles(a, arity));
}

/// Two frequencies: every listed condition is a denominator; every denominator that is not listed has one sign at
/// many points of the domain (and a listed one has two).
LAW(MarySingularSet, ConditionsAreTheDenominatorsThatChangeSign, (const Space& space)) {
  LAW_GIVEN(space.variables().size() == 2U);
  const int arity = uniform(2, 5);
  LAW_GIVEN(has_interpolating_scheme(space, arity));
  LAW_GIVEN(static_cast<unsigned>(arity) * space.dimension() <= 24U);
  std::set<std::string> conditions;
  for (const auto& f : singular_set(space, arity).conditions) conditions.insert(f.to_string());
  std::set<std::string> changing;
  const Laurent zeta = interpolating_symbol(space, arity);
  for (const auto& c : zeta.coefficients())
    for (const auto& [f, e] : c.denominator_factors()) {
      bool negative = false, positive = false;
      // cos x at rationals near a grid of angles below pi/m, and beyond 1.
      const auto value = [&](int i) {
        return i == 16 ? Rational(3)
                       : Rational(static_cast<long>(1e6 * std::cos(M_PI * (i + 0.5) / 16 / arity)), 1000000);
      };
      for (int i = 0; i <= 16 && !(negative && positive); ++i)
        for (int j = 0; j <= 16; ++j) {
          const int sign =
              f.evaluate({{space.variables()[0].name, value(i)}, {space.variables()[1].name, value(j)}}).sign();
          negative = negative || sign < 0;
          positive = positive || sign > 0;
        }
      if (negative && positive) changing.insert(f.to_string());
    }
  LAW_ASSERT(conditions == changing);
}

TEST(MarySingularSet, KnownSets) {
  const auto texts = [](const Space& space, int arity) {
    std::vector<std::string> list;
    for (const auto& v : singular_set(space, arity).values) list.push_back(v.exact() + "@" + std::to_string(v.level));
    return list;
  };
  using Texts = std::vector<std::string>;
  // {1, x, e^{+-tx}}: every v^0 > -1, whatever the arity; so a circle comes from any regular N-gon, N >= 3.
  for (int arity = 2; arity <= 64; ++arity) EXPECT_EQ(texts(family_space("mixed", 1), arity), Texts{});
  EXPECT_EQ(texts(Space::parse("1,exp(t*x),exp(-t*x)"), 3), Texts{});
  // {1, x, e^{+-tx}, e^{+-2tx}}: five functions on a circle need N >= 5 points: v^0 = cos(2 pi/3), cos(2 pi/4) fail.
  EXPECT_EQ(texts(family_space("harmonic", 2), 3), (Texts{"-1/2@0", "0@0"}));
  EXPECT_EQ(texts(Space::parse("1,cos(t*x),sin(t*x),cos(2*t*x),sin(2*t*x)"), 3), (Texts{"-1/2@0", "0@0"}));
  EXPECT_EQ(texts(polynomials(4), 3), Texts{});
  // e^{+-4tx} at level 1: phi = 2 pi/(3 * 8), v^0 = cos(6 * 2 pi/8 / 2) = cos(3 pi/4).
  EXPECT_EQ(listed(Space::parse("exp(t*x),exp(-t*x),exp(4*t*x),exp(-4*t*x)"), 3).count({Rational(3, 4), 1}), 1U);
}

}  // namespace
}  // namespace twoscale::tests
