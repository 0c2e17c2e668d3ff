// SPDX-License-Identifier: GPL-3.0-or-later
/// The step from sigma to omega and zeta: three routes and the definition must give the same answer.
#include "twoscale/symbolic/interpolatory.hpp"

#include <map>

#include "support/laws.hpp"
#include "symbolic/exact_points.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::tests {
namespace {

Space polynomials(unsigned order) { return Space::one_frequency(order, {}); }

/// Everything that is asked of zeta and omega of a space; empty if all is well.
std::string fault(const Space& space, bool folded = true) {
  const Laurent zeta = interpolating_symbol(space);
  const HessenbergSystem h = hessenberg_system(space);
  const Laurent sigma = bspline_symbol(space);
  const long l = static_cast<long>(space.dimension()) / 2;
  if (!zeta.is_canonical() || !h.omega.is_canonical()) return "not canonical";
  if (!(interpolating_symbol_by_divided_differences(space) == zeta)) return "route 3 differs";
  if (const auto harmonic = interpolating_symbol_harmonic(space); harmonic && !(*harmonic == zeta))
    return "harmonic route differs";
  if (const auto two = interpolating_symbol_two_nodes(space); two && !(*two == zeta))
    return "closed form for two nodes differs";
  if (!(sigma * h.omega == zeta)) return "zeta is not sigma omega";
  if (!(zeta.subsymbol(2, 0) == Laurent::monomial(0))) return "zeta is not interpolatory";
  if (zeta.lowest() != 1 - 2 * l || zeta.highest() != 2 * l - 1) return "support";
  if (zeta.centre_of_symmetry() != Rational(0) || h.omega.centre_of_symmetry() != Rational(0)) return "centre";
  if (h.omega.lowest() != 1 - l || h.omega.highest() != l - 1) return "support of omega";
  if (folded && !(omega_from_folded(folded_system(space)) == h.omega)) return "route 2 differs";
  if (space.polynomial_order() > 0 && !(zeta.at_one() == RationalFunction(2))) return "zeta(1)";
  // The definition, at two exact points.
  for (const size_t variant : {size_t{0}, size_t{2}}) {
    const auto e = exponential_points(space, variant);
    const auto mask = mask_at(zeta, level_values(space, e));
    const auto weights = interpolation_weights(space, e);
    if (!mask || !weights) return "pole at a real frequency";
    for (long j = 1 - l; j <= l; ++j)
      if (mask->at(1 - 2 * j) != weights->at(static_cast<size_t>(j + l - 1)))
        return "not the interpolating weights of the space";
    for (const Function& f : basis(space, e))
      for (const long i : {0L, 1L, 2L, 5L, -3L})
        if (refined(*mask, 2, f, i) != f(i)) return "does not reproduce the space";
  }
  return "";
}

struct Member {
  std::string family;
  unsigned l;
};
void PrintTo(const Member& m, std::ostream* out) { *out << m.family << " l=" << m.l; }

class Families : public ::testing::TestWithParam<Member> {
 protected:
  Space space() const { return family_space(GetParam().family, family_member(GetParam().family, GetParam().l)); }
};

TEST_P(Families, AllRoutesAgree) {
  ASSERT_EQ(space().dimension(), 2 * GetParam().l);
  EXPECT_EQ(fault(space()), "");
}

/// At v = 1 all frequencies meet in 0: Deslauriers and Dubuc's weights, the Lagrange polynomials at 1/2.
TEST_P(Families, ConfluenceIsDeslauriersDubuc) {
  const long l = GetParam().l;
  const Laurent limit = interpolating_symbol(space()).substitute("v", 1);
  for (long j = 1 - l; j <= l; ++j) {
    Rational weight = 1;
    for (long i = 1 - l; i <= l; ++i)
      if (i != j) weight *= (Rational(1, 2) - Rational(i)) / Rational(j - i);
    EXPECT_EQ(limit.coefficient(1 - 2 * j).constant(), weight) << j;
  }
  EXPECT_EQ(limit, interpolating_symbol(polynomials(2 * GetParam().l)));
}

TEST_P(Families, HessenbergSystem) {
  const HessenbergSystem h = hessenberg_system(space());
  const size_t l = GetParam().l;
  ASSERT_EQ(h.matrix.size(), l);
  ASSERT_EQ(h.nodes.size(), l);
  for (size_t r = 0; r < l; ++r)
    for (size_t c = r + 2; c < l; ++c) EXPECT_TRUE(h.matrix[r][c].is_zero()) << "not Hessenberg at " << r << "," << c;
  // H w = rhs as rational functions.
  for (size_t r = 0; r < l; ++r) {
    RationalFunction sum;
    for (size_t c = 0; c < l; ++c) sum += h.matrix[r][c] * h.solution[c];
    EXPECT_EQ(sum, h.rhs[r]) << r;
    EXPECT_TRUE(h.rhs[r].is_zero() || r + 1 == l);
  }
  EXPECT_TRUE(h.rhs.back().is_one());  // 1 is in V
  // omega in the Newton basis: sum_m w_m z^{l-1-m} prod_{i<m} (z^2 - gamma_i z + 1).
  Laurent omega;
  Laurent product = Laurent::monomial(0);
  for (size_t m = 0; m < l; ++m) {
    omega = omega + h.solution[m] * product.shifted(static_cast<long>(l - 1 - m));
    product = product * Laurent(0, {1, RationalFunction(-h.nodes[m]), 1});
  }
  EXPECT_EQ(centred(omega), h.omega);
}

TEST_P(Families, DeterminantsByElimination) {
  const HessenbergSystem h = hessenberg_system(space());
  const FoldedSystem f = folded_system(space());
  const RationalFunction folded = folded_determinant(space(), f);
  for (const char* v : {"3", "7/5", "1/3", "-2/7", "1"}) {
    const Values at = {{"v", Rational::parse(v)}};
    Matrix a = values(h.matrix, at);
    EXPECT_EQ(h.determinant.evaluate(at), eliminate(a)) << "v = " << v;
    Matrix b = values(f.matrix, at);
    EXPECT_EQ(folded.evaluate(at), eliminate(b)) << "v = " << v;
    // The folded system's own solution.
    Matrix c = values(f.matrix, at);
    for (size_t r = 0; r < c.size(); ++r) c[r].push_back(f.rhs[r].evaluate(at).value());
    if (eliminate(c).is_zero()) continue;
    for (size_t i = 0; i < c.size(); ++i)
      EXPECT_EQ(c[i].back(), h.omega.coefficient(static_cast<long>(i) - static_cast<long>(c.size()) + 1).evaluate(at))
          << "v = " << v;
  }
}

TEST_P(Families, FoldedSystemIsHessenbergUpToThreeOnly) {
  const FoldedSystem f = folded_system(space());
  bool hessenberg = true;
  for (size_t r = 0; r < f.matrix.size(); ++r)
    for (size_t c = r + 2; c < f.matrix.size(); ++c) hessenberg = hessenberg && f.matrix[r][c].is_zero();
  EXPECT_EQ(f.hessenberg, hessenberg);
  EXPECT_EQ(f.hessenberg, GetParam().l <= 3);
  for (size_t c = 0; c < f.matrix.size(); ++c)
    EXPECT_EQ(f.matrix.back()[c], RationalFunction(c + 1 < f.matrix.size() ? 2 : 1));
}

std::vector<Member> members() {
  std::vector<Member> list;
  for (const char* family : {"mixed", "harmonic", "resonant"})
    for (unsigned l = 2; l <= 8; ++l) list.push_back({family, l});
  return list;
}
INSTANTIATE_TEST_SUITE_P(romani2009, Families, ::testing::ValuesIn(members()),
                         [](const auto& member) { return member.param.family + std::to_string(member.param.l); });

LAW(InterpolatingSymbol, AllRoutesAgreeOnAnySpace, (const Space& space)) {
  LAW_GIVEN(space.dimension() % 2 == 0U);
  LAW_ASSERT(fault(space) == std::string());
}

TEST(InterpolatingSymbol, PolynomialsOfEveryOrder) {
  for (unsigned l = 1; l <= 16; ++l) EXPECT_EQ(fault(polynomials(2 * l)), "") << l;
}

/// Lacunary, without 1, several frequencies, high multiplicities.
TEST(InterpolatingSymbol, ChosenSpaces) {
  for (const char* text :
       {"exp(t*x),exp(-t*x)", "exp(t*x),exp(-t*x),exp(2*t*x),exp(-2*t*x)",
        "1,x,cos(t*x),sin(t*x),cos(3*t*x),sin(3*t*x)", "1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)",
        "exp(s*x),exp(-s*x),exp(t*x),exp(-t*x),x*exp(t*x),x*exp(-t*x)",
        "1,x,x^2,x^3,cos(t*x),sin(t*x),x*cos(t*x),x*sin(t*x)",
        "exp(t*x),exp(-t*x),x*exp(t*x),x*exp(-t*x),x^2*exp(t*x),x^2*exp(-t*x)", "cosh(x),sinh(x),1,x",
        "1,x,exp(t*x/2),exp(-t*x/2),exp(t*x/3),exp(-t*x/3)", "1,x,exp(4*t*x),exp(-4*t*x),exp(6*t*x),exp(-6*t*x)",
        "exp(r*x),exp(-r*x),exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)",
        "1,x,exp(s*x),exp(-s*x),exp(2*s*x),exp(-2*s*x),exp(t*x),exp(-t*x),exp(2*t*x),exp(-2*t*x)"})
    EXPECT_EQ(fault(Space::parse(text)), "") << text;
}

TEST(InterpolatingSymbol, OddDimensionsAreRefused) {
  for (const char* text : {"1", "1,x,x^2", "1,exp(t*x),exp(-t*x)"}) {
    EXPECT_THROW(interpolating_symbol(Space::parse(text)), Error) << text;
    EXPECT_THROW(hessenberg_system(Space::parse(text)), Error) << text;
    EXPECT_THROW(folded_system(Space::parse(text)), Error) << text;
  }
}

TEST(InterpolatingSymbol, ClosedFormForTwoNodesKnowsItsSpaces) {
  for (unsigned l = 2; l <= 8; ++l)
    for (const char* family : {"mixed", "resonant"})
      EXPECT_TRUE(interpolating_symbol_two_nodes(family_space(family, family_member(family, l)))) << family << l;
  for (const char* text : {"exp(s*x),exp(-s*x),exp(t*x),exp(-t*x),x*exp(s*x),x*exp(-s*x)", "1,x,cos(t*x),sin(t*x)",
                           "exp(t*x),exp(-t*x),exp(2*t*x),exp(-2*t*x),x*exp(2*t*x),x*exp(-2*t*x)",
                           "exp(t*x),exp(-t*x),x*exp(t*x),x*exp(-t*x),exp(3*t*x),exp(-3*t*x)"}) {
    const Space space = Space::parse(text);
    EXPECT_TRUE(interpolating_symbol_two_nodes(space).has_value()) << text;
    EXPECT_EQ(fault(space), "") << text;
  }
  for (const char* text : {"1,x", "1,x,x^2,x^3", "1,x,exp(t*x),exp(-t*x),exp(2*t*x),exp(-2*t*x)",
                           "1,x,x^2,x^3,exp(t*x),exp(-t*x),x*exp(t*x),x*exp(-t*x)"})
    EXPECT_FALSE(interpolating_symbol_two_nodes(Space::parse(text)).has_value()) << text;
}

// Both sides at z = 3, v = 5/4 and v_s = 5/4, v_t = 13/5.
TEST(InterpolatingSymbol, TwoNodesWithNothingMultipliedOut) {
  std::vector<Space> spaces;
  for (unsigned l = 2; l <= 9; ++l)
    for (const char* family : {"mixed", "resonant"}) spaces.push_back(family_space(family, family_member(family, l)));
  for (const char* text : {"1,x,exp(t*x),exp(-t*x)", "exp(s*x),exp(-s*x),exp(t*x),exp(-t*x),x*exp(s*x),x*exp(-s*x)",
                           "exp(t*x),exp(-t*x),exp(2*t*x),exp(-2*t*x),x*exp(2*t*x),x*exp(-2*t*x)"})
    spaces.push_back(Space::parse(text));
  for (const Space& space : spaces) {
    const TwoNodeSymbol s = interpolating_two_nodes_factored(space).value();
    std::vector<std::pair<std::string, Rational>> at;
    for (const auto& v : space.variables()) at.emplace_back(v.name, at.empty() ? Rational(5, 4) : Rational(13, 5));
    const Rational p = s.p.evaluate(at), q = s.q.evaluate(at), w = (Rational(3) + Rational(1, 3)) / Rational(2);
    const auto n = static_cast<long>(s.f.size());
    ASSERT_EQ(2 * n + 2, static_cast<long>(space.dimension()));
    Rational value = 1, kappa;
    for (long k = 0; k < n; ++k) {
      value += s.f[static_cast<size_t>(k)] * (w / p).pow(2 * k + 1);
      kappa += s.g[static_cast<size_t>(k)] * p.pow(-n - k) * (p + q).pow(k - n) / q;
    }
    value += kappa * w * (w * w - p * p).pow(n);
    Rational expected;
    const Laurent zeta = interpolating_symbol_by_divided_differences(space);
    for (long i = zeta.lowest(); i <= zeta.highest(); ++i) {
      const RationalFunction a = zeta.coefficient(i);
      expected += a.numerator().evaluate(at) / a.denominator().evaluate(at) * Rational(3).pow(i);
    }
    EXPECT_EQ(value, expected) << space.to_string();
  }
  EXPECT_FALSE(interpolating_two_nodes_factored(Space::parse("1,x,x^2,x^3")).has_value());
  EXPECT_FALSE(interpolating_two_nodes_factored(family_space("harmonic", 3)).has_value());
}

// a_m = 1/2 prod_{i != m} (1 - T_i)/(T_m - T_i) at v = 5/4, T_n = (2^n + 2^-n)/2, where nothing can be multiplied out.
TEST(Interpolatory, HarmonicCoefficientsAsExponentCounts) {
  for (const unsigned l : {2U, 3U, 7U, 30U, 64U}) {
    const auto products = interpolating_coefficients_harmonic(family_space("harmonic", l - 1)).value();
    ASSERT_EQ(products.size(), l);
    const auto t = [](long n) { return (Rational(2).pow(n) + Rational(2).pow(-n)) / Rational(2); };
    std::map<unsigned, Rational> minimal;
    for (const unsigned m : {1U, 3U, l | 1U, 2 * l - 1}) {
      if (m >= 2 * l) continue;
      Rational expected(1, 2);
      for (unsigned i = 1; i < 2 * l; i += 2)
        if (i != m) expected *= (Rational(1) - t(i)) / (t(m) - t(i));
      const CosineProduct& a = products[(m - 1) / 2];
      Rational value = a.content;
      for (const auto& [d, exponent] : a.factors) {
        if (!minimal.contains(d)) minimal[d] = Polynomial::cosine_minimal("v", d).evaluate({{"v", Rational(5, 4)}});
        value *= minimal[d].pow(exponent);
      }
      EXPECT_EQ(value, expected) << l << " " << m;
    }
  }
}

TEST(InterpolatingSymbol, HarmonicEngineKnowsItsSpaces) {
  EXPECT_TRUE(interpolating_symbol_harmonic(family_space("harmonic", 3)).has_value());
  for (const char* text : {"1,x,x^2,x^3", "1,x,exp(t*x),exp(-t*x),exp(3*t*x),exp(-3*t*x)", "exp(t*x),exp(-t*x)",
                           "1,x,exp(t*x),exp(-t*x),x*exp(t*x),x*exp(-t*x)", "1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)",
                           "1,x,x^2,x^3,exp(t*x),exp(-t*x)"})
    EXPECT_FALSE(interpolating_symbol_harmonic(Space::parse(text)).has_value()) << text;
}

}  // namespace
}  // namespace twoscale::tests
