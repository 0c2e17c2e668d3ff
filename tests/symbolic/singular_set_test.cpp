// SPDX-License-Identifier: GPL-3.0-or-later
/// The v^0 for which a step fails, against the poles of the reduced symbols.
#include <algorithm>
#include <numeric>
#include <optional>
#include <set>

#include "support/laws.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/interpolatory.hpp"

namespace twoscale::tests {
namespace {

using Found = std::set<std::pair<Rational, unsigned>>;  // v^0 = cos(angle pi), level

Found listed(const Space& space) {
  Found f;
  for (const auto& v : singular_set(space).values) f.emplace(v.angle, v.level);
  return f;
}

std::vector<std::string> texts(const Space& space) {
  std::vector<std::string> list;
  for (const auto& v : singular_set(space).values) list.push_back(v.exact() + "@" + std::to_string(v.level));
  return list;
}

/// The poles of a symbol in one variable, exactly: each irreducible factor of a denominator has to be the minimal
/// polynomial of cos(2 pi/d) for some d, whose zeros are cos(2 pi j/d), j prime to d. At level k the domain is v >
/// cos(pi/2^{k+1}), and there v^0 = cos(2^{k+1} 2 pi j/d). nullopt if a factor is of another kind and has a positive
/// zero.
std::optional<Found> poles(const Laurent& a) {
  Found found;
  for (const auto& c : a.coefficients())
    for (const auto& [f, e] : c.denominator_factors()) {
      if (f.variables().size() != 1) return std::nullopt;
      unsigned d = 0;
      for (unsigned candidate = 1; candidate <= 400 && d == 0; ++candidate)
        if (Polynomial::cosine_minimal(f.variables()[0], candidate) == f) d = candidate;
      if (d == 0) return std::nullopt;
      for (unsigned j = 1; 2 * j <= d; ++j) {
        if (std::gcd(j, d) != 1) continue;
        const Rational angle(2L * j, d);  // of v
        for (unsigned k = 0; angle * Rational(2).pow(k + 1) < Rational(1); ++k)
          found.emplace(angle * Rational(2).pow(k + 1), k);
      }
    }
  return found;
}

TEST(SingularSet, KnownSets) {
  using Texts = std::vector<std::string>;
  EXPECT_EQ(texts(family_space("harmonic", 2)), (Texts{"-1/2@0", "0@0"}));
  EXPECT_EQ(texts(Space::parse("1,x,cos(t*x),sin(t*x),cos(3*t*x),sin(3*t*x)")),
            (Texts{"-1/2@0", "-1/2@1", "0@0", "1/2@0"}));
  EXPECT_EQ(texts(family_space("mixed", 1)), Texts{});
  EXPECT_EQ(texts(family_space("mixed", 13)), Texts{});
  EXPECT_EQ(texts(family_space("resonant", 7)), Texts{});
  EXPECT_EQ(texts(Space::parse("1,x,x^2,x^3")), Texts{});
  // cos(2 phi) = 0 alone: v^0 = cos(2 phi) = 0.
  EXPECT_EQ(texts(Space::parse("exp(2*t*x),exp(-2*t*x),exp(t*x),exp(-t*x)")), (Texts{"-1/2@0", "0@0"}));
}

TEST(SingularSet, IsSorted) {
  const auto values = singular_set(family_space("harmonic", 9)).values;
  ASSERT_GT(values.size(), 20U);
  for (size_t i = 1; i < values.size(); ++i) {
    const auto& a = values[i - 1];
    const auto& b = values[i];
    EXPECT_TRUE(a.angle > b.angle || (a.angle == b.angle && a.level < b.level));  // v^0 ascending
    EXPECT_TRUE(b.angle > Rational(0) && b.angle < Rational(1));
  }
}

TEST(SingularSet, Texts) {
  EXPECT_EQ(cosine_text(Rational(1, 2)), "0");
  EXPECT_EQ(cosine_text(Rational(1, 3)), "1/2");
  EXPECT_EQ(cosine_text(Rational(2, 3)), "-1/2");
  EXPECT_EQ(cosine_text(Rational(4, 5)), "cos(4*pi/5)");
  EXPECT_EQ(cosine_text(Rational(1, 7)), "cos(pi/7)");
}

TEST(SingularSet, EqualsThePolesOfZetaForTheFamilies) {
  for (const char* family : {"mixed", "harmonic", "resonant"})
    for (unsigned l = 2; l <= 8; ++l) {
      const Space space = family_space(family, family_member(family, l));
      const auto p = poles(interpolating_symbol(space));
      ASSERT_TRUE(p.has_value()) << family << l;
      EXPECT_EQ(listed(space), *p) << family << l;
    }
}

/// sigma of odd dimension: where the normalisation fails.
TEST(SingularSet, EqualsThePolesOfSigmaInOddDimension) {
  for (const char* text : {"1,exp(t*x),exp(-t*x)", "1,exp(2*t*x),exp(-2*t*x),exp(t*x),exp(-t*x)",
                           "1,exp(t*x),exp(-t*x),exp(3*t*x),exp(-3*t*x)",
                           "1,exp(t*x),exp(-t*x),exp(5*t*x),exp(-5*t*x),exp(8*t*x),exp(-8*t*x)",
                           "1,x,x^2,exp(t*x),exp(-t*x),exp(4*t*x),exp(-4*t*x)"}) {
    const Space space = Space::parse(text);
    const auto p = poles(bspline_symbol(space));
    ASSERT_TRUE(p.has_value()) << text;
    EXPECT_EQ(listed(space), *p) << text;
  }
}

LAW(SingularSet, EqualsThePolesForAnySpaceOfOneFrequency, (const Space& space)) {
  LAW_GIVEN(space.variables().size() <= 1U);
  const auto p = poles(space.dimension() % 2 == 0 ? interpolating_symbol(space) : bspline_symbol(space));
  LAW_ASSERT(p.has_value());
  LAW_ASSERT(listed(space) == *p);
}

/// The determinant of the Hessenberg system vanishes (or has no value) at a listed v and the folded one too; elsewhere
/// neither.
TEST(SingularSet, DeterminantVanishesThere) {
  for (const char* family : {"harmonic", "mixed", "resonant"})
    for (unsigned l = 2; l <= 6; ++l) {
      const Space space = family_space(family, family_member(family, l));
      Found zeros;
      const RationalFunction determinant = folded_determinant(space, folded_system(space));
      const auto of = [&](const Polynomial& f) {
        const auto p = poles(Laurent::monomial(0, RationalFunction::fraction(1, f)));
        ASSERT_TRUE(p.has_value());
        zeros.insert(p->begin(), p->end());
      };
      for (const auto& [f, e] : determinant.numerator().factor().factors) of(f);
      for (const auto& [f, e] : determinant.denominator_factors()) of(f);
      EXPECT_EQ(zeros, listed(space)) << family << l;
    }
}

// ---- Several frequencies: conditions

std::set<std::string> denominators(const Laurent& a) {
  std::set<std::string> s;
  for (const auto& c : a.coefficients())
    for (const auto& [f, e] : c.denominator_factors())
      if (!f.all_coefficients_nonnegative()) s.insert(f.to_string());
  return s;
}

TEST(SingularConditions, Examples) {
  const auto conditions = [](const char* text) {
    std::vector<std::string> list;
    for (const auto& f : singular_set(Space::parse(text)).conditions) list.push_back(f.to_string());
    return list;
  };
  using Texts = std::vector<std::string>;
  EXPECT_EQ(conditions("1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)"), Texts{});
  EXPECT_EQ(conditions("1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x),exp(2*t*x),exp(-2*t*x)"),
            (Texts{"2*v_t-1", "2*v_t^2-1", "v_s+2*v_t^2-1"}));
}

LAW(SingularConditions, AreTheDenominatorsThatCanVanish, (const Space& space)) {
  LAW_GIVEN(space.variables().size() == 2U && space.dimension() % 2 == 0U);
  const auto s = singular_set(space);
  LAW_ASSERT(s.values.empty());
  std::set<std::string> listed_conditions;
  for (const auto& f : s.conditions) {
    LAW_ASSERT(f.factor().factors.size() == 1U);
    LAW_ASSERT(f.content() == Rational(1));
    LAW_ASSERT(f.leading_sign() > 0);
    listed_conditions.insert(f.to_string());
  }
  LAW_ASSERT(listed_conditions == denominators(interpolating_symbol(space)));
}

}  // namespace
}  // namespace twoscale::tests
