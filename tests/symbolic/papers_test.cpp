// SPDX-License-Identifier: GPL-3.0-or-later
/// The formulas of the papers as printed, against the derivation; where print is wrong, both values and the reason.
///
/// romani2009: L. Romani, From approximating subdivision schemes for exponential splines to high-performance
/// interpolating algorithms. beccari2007: Beccari, Casciola, Romani, A non-stationary uniform tension controlled
/// interpolating 4-point scheme. v stands for v^{k+1}; the papers' index i is our i - l (sigma), i - (l-1) (omega), i -
/// (2l-1) (zeta).
#include "support/laws.hpp"
#include "symbolic/exact_points.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/expression.hpp"
#include "twoscale/symbolic/interpolatory.hpp"

namespace twoscale::tests {
namespace {

RationalFunction rf(const std::string& text) { return parse_rational_function(text); }

struct Printed {
  const char* equation;
  const char* family;
  char symbol;  // s, o, z
  long index;
  const char* text;
};
void PrintTo(const Printed& p, std::ostream* out) { *out << p.equation << " " << p.symbol << "_" << p.index; }

constexpr long l = 3;

RationalFunction derived(const std::string& family, char symbol, long index) {
  const Space space = family_space(family, family_member(family, l));
  if (symbol == 's') return bspline_symbol(space).coefficient(index - l);
  if (symbol == 'o') return hessenberg_system(space).omega.coefficient(index - (l - 1));
  return interpolating_symbol(space).coefficient(index - (2 * l - 1));
}

class Romani2009 : public ::testing::TestWithParam<Printed> {};

TEST_P(Romani2009, CoefficientAsPrinted) {
  const Printed& p = GetParam();
  EXPECT_EQ(rf(p.text), derived(p.family, p.symbol, p.index));
}

const Printed printed[] = {
    {"(27)", "mixed", 's', 0, "1/(16*(v+1))"},
    {"(27)", "mixed", 's', 1, "(v+2)/(8*(v+1))"},
    {"(27)", "mixed", 's', 2, "(8*v+7)/(16*(v+1))"},
    {"(27)", "mixed", 's', 3, "(3*v+2)/(4*(v+1))"},
    {"(28)", "mixed", 'o', 0, "(v+2)/(4*v*(v+1))"},
    {"(28)", "mixed", 'o', 1, "-(v+2)^2/(2*v*(v+1))"},
    {"(28)", "mixed", 'o', 2, "(4*v^2+9*v+6)/(2*v*(v+1))"},
    {"(30)", "mixed", 'z', 0, "(v+2)/(64*v*(v+1)^2)"},
    {"(30)", "mixed", 'z', 2, "-(4*v^3+8*v^2+7*v+6)/(64*v*(v+1)^2)"},
    {"(30)", "mixed", 'z', 4, "(36*v^3+72*v^2+38*v+4)/(64*v*(v+1)^2)"},
    {"(32)", "harmonic", 's', 0, "1/(16*v^2*(v+1))"},
    {"(32)", "harmonic", 's', 1, "(2*v+1)/(8*v*(v+1))"},
    {"(32)", "harmonic", 's', 2, "(8*v^3+8*v^2-1)/(16*v^2*(v+1))"},
    {"(32)", "harmonic", 's', 3, "(4*v^2+2*v-1)/(4*v*(v+1))"},
    {"(33)", "harmonic", 'o', 0, "(2*v+1)/(4*(v+1)*(2*v-1)*(2*v^2-1))"},
    {"(33)", "harmonic", 'o', 1, "-v*(2*v+1)^2/(2*(v+1)*(2*v-1)*(2*v^2-1))"},
    {"(33)", "harmonic", 'o', 2, "(8*v^4+12*v^3-2*v+1)/(2*(v+1)*(2*v-1)*(2*v^2-1))"},
    {"(34)", "harmonic", 'z', 0, "(2*v+1)/(64*v^2*(v+1)^2*(2*v-1)*(2*v^2-1))"},
    {"(34)", "harmonic", 'z', 2, "-(4*v^2+2*v-1)^2/(64*v^2*(v+1)^2*(2*v^2-1))"},
    {"(34)", "harmonic", 'z', 4, "(2*v+1)*(4*v^2+2*v-1)^2/(32*v^2*(v+1)^2*(2*v-1))"},
    {"(35)", "resonant", 's', 0, "1/(8*(v+1)^2)"},
    {"(35)", "resonant", 's', 1, "(2*v+1)/(4*(v+1)^2)"},
    {"(35)", "resonant", 's', 2, "(4*v^2+8*v+3)/(8*(v+1)^2)"},
    {"(35)", "resonant", 's', 3, "(2*v^2+2*v+1)/(2*(v+1)^2)"},
    {"(36)", "resonant", 'o', 0, "(2*v+1)/(8*v^3)"},
    {"(36)", "resonant", 'o', 1, "-(2*v+1)^2/(4*v^3)"},
    {"(36)", "resonant", 'o', 2, "(4*v^3+8*v^2+6*v+1)/(4*v^3)"},
    {"(37)", "resonant", 'z', 0, "(2*v+1)/(64*v^3*(v+1)^2)"},
    {"(37)", "resonant", 'z', 2, "-(4*v+1)*(4*v^2+2*v-1)/(64*v^3*(v+1)^2)"},
    {"(37)", "resonant", 'z', 4, "(2*v+1)*(2*v^2+2*v+1)*(4*v^2+2*v-1)/(32*v^3*(v+1)^2)"},
};
INSTANTIATE_TEST_SUITE_P(Section4, Romani2009, ::testing::ValuesIn(printed));

// (31): lim zeta_0, zeta_2, zeta_4 for all three schemes.
TEST(Romani2009Equations, Limits31) {
  for (const char* family : {"mixed", "harmonic", "resonant"}) {
    EXPECT_EQ(derived(family, 'z', 0).substitute("v", 1).constant(), Rational(3, 256)) << family;
    EXPECT_EQ(derived(family, 'z', 2).substitute("v", 1).constant(), Rational(-25, 256)) << family;
    EXPECT_EQ(derived(family, 'z', 4).substitute("v", 1).constant(), Rational(75, 128)) << family;
  }
}

// Section 4, first paragraph: l = 2, omega_0 = -1/(2v), omega_1 = (v+1)/v.
TEST(Romani2009Equations, FourPointOmega) {
  const Laurent omega = hessenberg_system(family_space("mixed", 1)).omega;
  EXPECT_EQ(omega.coefficient(-1), rf("-1/(2*v)"));
  EXPECT_EQ(omega.coefficient(0), rf("(v+1)/v"));
}

// (8): the determinant of the tridiagonal matrix L is 2 T_j(v).
TEST(Romani2009Equations, Lambda8) {
  for (size_t j = 1; j <= 8; ++j)
    for (const Rational& v : {Rational(3), Rational(-2, 7), Rational(1)}) {
      Matrix m(j, std::vector<Rational>(j));
      for (size_t i = 0; i < j; ++i) {
        m[i][i] = Rational(2) * v;
        if (i + 1 < j) {
          m[i][i + 1] = 1;
          m[i + 1][i] = i == 0 ? 2 : 1;
        }
      }
      EXPECT_EQ(eliminate(m), Rational(2) * Polynomial::chebyshev("v", static_cast<unsigned>(j)).evaluate({{"v", v}}))
          << j;
    }
}

// (3), (9), (13): the families as products.
TEST(Romani2009Equations, Families3And9And13) {
  const Laurent half_square(0, {Rational(1, 2), 1, Rational(1, 2)});
  for (unsigned n = 1; n <= 5; ++n) {
    Laurent mixed(0, {rf("1/(2*(v+1))"), rf("2*v/(2*(v+1))"), rf("1/(2*(v+1))")});
    for (unsigned i = 0; i <= n; ++i) mixed = mixed * Laurent(0, {1, 1});
    mixed = RationalFunction(Rational(2).pow(-static_cast<long>(n))) * mixed;
    EXPECT_EQ(centred(mixed), bspline_symbol(family_space("mixed", n))) << n;
    Laurent harmonic = half_square;
    Laurent resonant = half_square;
    for (unsigned j = 1; j <= n; ++j) {
      const RationalFunction lambda = Polynomial(2) * Polynomial::chebyshev("v", j);
      const RationalFunction scale = (lambda + RationalFunction(2)).inverse();
      harmonic = harmonic * Laurent(0, {scale, lambda * scale, scale});
      resonant = resonant * Laurent(0, {rf("1/(2*(v+1))"), rf("v/(v+1)"), rf("1/(2*(v+1))")});
    }
    EXPECT_EQ(centred(harmonic), bspline_symbol(family_space("harmonic", n))) << n;
    EXPECT_EQ(centred(resonant), bspline_symbol(family_space("resonant", n))) << n;
  }
}

/// The matrix of the system (17) as printed: row j = 1..l-1 has sigma_{2j-1-i} + sigma_{i-1} for 0 < i < j,
/// sigma_{2j-1} for i = 0, sigma_{j-1} for i = j and nothing further right; last row (2, .., 2, 1).
Matrix printed_matrix(long order, const Laurent& sigma, const Values& at) {
  const auto s = [&](long i) { return sigma.coefficient(i - order).evaluate(at).value(); };
  Matrix m;
  for (long j = 1; j < order; ++j) {
    m.emplace_back();
    for (long i = 0; i < order; ++i)
      m.back().push_back(i > j ? Rational(0) : i == 0 || i == j ? s(2 * j - 1 - i) : s(2 * j - 1 - i) + s(i - 1));
  }
  m.emplace_back(static_cast<size_t>(order), Rational(2));
  m.back().back() = 1;
  return m;
}

/// zeta = sigma omega with omega from Lemma 9: (19) by Cramer's rule over the printed matrix.
std::map<long, Rational> zeta_of_lemma_9(long order, const Laurent& sigma, const Values& at) {
  const Matrix m = printed_matrix(order, sigma, at);
  Matrix whole = m;
  const Rational determinant = eliminate(whole);
  std::map<long, Rational> omega;
  for (long j = 0; j < order; ++j) {
    Matrix minor(m.begin(), m.end() - 1);
    for (auto& row : minor) row.erase(row.begin() + j);
    const Rational d = minor.empty() ? Rational(1) : eliminate(minor);
    omega[j - (order - 1)] = omega[order - 1 - j] = Rational((order - j - 1) % 2 == 0 ? 1 : -1) * d / determinant;
  }
  std::map<long, Rational> zeta;
  for (const auto& [i, w] : omega)
    for (long k = sigma.lowest(); k <= sigma.highest(); ++k)
      zeta[i + k] += w * sigma.coefficient(k).evaluate(at).value();
  return zeta;
}

bool interpolatory(const std::map<long, Rational>& zeta) {
  for (const auto& [i, value] : zeta)
    if (i % 2 == 0 && value != Rational(i == 0 ? 1 : 0)) return false;
  return true;
}

// (17), (19), (20): right for l = 2, 3. For l >= 4 the printed rows forget the entries sigma_{2j+1-2l+i} of the
// reflected half (row 2 of l = 4 must be sigma_3, sigma_2, sigma_1, sigma_0, print has sigma_3, sigma_2 + sigma_0,
// sigma_1, 0), and what comes out is not interpolatory.
TEST(Romani2009Equations, Lemma9HoldsForTwoAndThreeAndFailsFromFour) {
  for (const char* family : {"mixed", "harmonic", "resonant"})
    for (unsigned order = 2; order <= 6; ++order) {
      const Space space = family_space(family, family_member(family, order));
      const Laurent sigma = bspline_symbol(space);
      for (const char* v : {"1", "3/2", "4"}) {
        const Values at = {{"v", Rational::parse(v)}};
        EXPECT_EQ(interpolatory(zeta_of_lemma_9(order, sigma, at)), order <= 3)
            << family << " l=" << order << " v=" << v;
        EXPECT_TRUE(interpolatory(mask_at(interpolating_symbol(space), at).value()));
      }
    }
}

TEST(Romani2009Equations, RowTwoOfTheSystemForFourIsWrong) {
  const Space space = family_space("harmonic", 3);
  const Laurent sigma = bspline_symbol(space);
  const Values at = {{"v", Rational(3, 2)}};
  const Matrix print = printed_matrix(4, sigma, at);
  const Matrix right = values(folded_system(space).matrix, at);
  EXPECT_EQ(print[0], right[0]);
  EXPECT_NE(print[1], right[1]);
  EXPECT_EQ(print[2], right[2]);
  EXPECT_EQ(print[3], right[3]);
  for (long i = 0; i < 4; ++i) EXPECT_EQ(right[1][static_cast<size_t>(i)], sigma.coefficient(3 - i - 4).evaluate(at));
  // A row j of the system is the coefficient 2j-1 of sigma omega for symmetric omega: by the unit vectors.
  for (long i = 0; i < 4; ++i) {
    std::vector<RationalFunction> unit(7, 0);
    unit[static_cast<size_t>(i)] = unit[static_cast<size_t>(6 - i)] = 1;
    const Laurent product = sigma * Laurent(-3, unit);
    EXPECT_EQ(product.coefficient(3 - 7).evaluate(at), right[1][static_cast<size_t>(i)]) << i;
  }
}

// After (30), (34), (37): the v^0 in (-1, infinity) for which the coefficients are defined.
TEST(Romani2009Equations, ParametersWithoutValue) {
  EXPECT_TRUE(singular_set(family_space("mixed", 3)).values.empty());
  EXPECT_TRUE(singular_set(family_space("resonant", 2)).values.empty());
  std::vector<std::string> harmonic;
  for (const auto& v : singular_set(family_space("harmonic", 2)).values) harmonic.push_back(v.exact());
  EXPECT_EQ(harmonic, (std::vector<std::string>{"-1/2", "0"}));
}

// ---- beccari2007

Laurent four_point() { return interpolating_symbol(family_space("mixed", 1)); }

// (3), (7): p_{2j+1} = (1/2 + w)(p_j + p_{j+1}) - w (p_{j-1} + p_{j+2}), w = 1/(8 v (1 + v)).
TEST(Beccari2007, Weights3And7) {
  const RationalFunction w = rf("1/(8*v*(1+v))");
  EXPECT_EQ(four_point(), Laurent(-3, {-w, 0, rf("1/2") + w, 1, rf("1/2") + w, 0, -w}));
  EXPECT_EQ(w.substitute("v", 1).constant(), Rational(1, 16));  // Remark 1
}

// (4): w in exponentials; (5), (6): v^{k+1} and v^k; the table in 3.1: w^k = 1/(16 v^k (v^{k+1})^2).
TEST(Beccari2007, Weights4And5And6) {
  for (const Rational& e : {Rational(2), Rational(3, 7), Rational(11, 5)}) {
    const Rational sum = e + e.inverse();
    const Rational v = sum / Rational(2);
    EXPECT_EQ((Rational(2) * sum * (sum + Rational(2))).inverse(), rf("1/(8*v*(1+v))").evaluate({{"v", v}}));
    const Rational coarse = (e.pow(2) + e.pow(-2)) / Rational(2);  // v^k
    EXPECT_EQ(v * v, (Rational(1) + coarse) / Rational(2));
    EXPECT_EQ((Rational(16) * coarse * v * v).inverse(), rf("1/(8*v*(1+v))").evaluate({{"v", coarse}}));
  }
}

// The solution a_0..a_3 of (2), and the value at the middle printed after it, for arbitrary data.
TEST(Beccari2007, InterpolationByTheSpace) {
  for (const Rational& g : {Rational(2), Rational(5, 3)}) {  // e^{t/2^{k+1}}
    const Rational e = g * g;
    const Rational sum = e + e.inverse();
    const std::vector<Rational> p = {Rational(7), Rational(-2, 3), Rational(5), Rational(11, 4)};  // p_{j-1}..p_{j+2}
    const Rational two = 2;
    const Rational d = sum - two;
    const Rational a0 = (sum * p[1] - p[0] - p[2]) / d;
    const Rational a1 = ((sum + Rational(1)) * (p[2] - p[1]) + p[0] - p[3]) / d;  // in units of 2^{-k}
    const Rational bottom = (e.inverse() - e) * d * d;
    const Rational a2 =
        (d * (-p[1] + two * p[2] - p[3]) + (e.inverse() - Rational(1)).pow(2) * (p[0] - two * p[1] + p[2])) / bottom;
    const Rational a3 =
        (d * (p[1] - two * p[2] + p[3]) - (e - Rational(1)).pow(2) * (p[0] - two * p[1] + p[2])) / bottom;
    for (long j = -1; j <= 2; ++j)
      EXPECT_EQ(a0 + a1 * Rational(j) + a2 * e.pow(j) + a3 * e.pow(-j), p[static_cast<size_t>(j + 1)]) << j;
    const Rational fine = g + g.inverse();
    const Rational w = (two * fine * (fine + two)).inverse();
    EXPECT_EQ(a0 + a1 / two + a2 * g + a3 / g, (Rational(1, 2) + w) * (p[1] + p[2]) - w * (p[0] + p[3]));
  }
}

// Algorithm of 3.2. (8) compares p_{2j+1} with data of spacing 2u, so that its w_j is 2 w^{k+1} = 1/(4 v (1 + v)), v =
// cosh(tu) = v^0. Step 3.1 as printed, v^0 = sqrt(2w(2w+1))/(4w) - 1/2, inverts w = 1/(8 v (1 + v)): with the w of (8)
// it is wrong. Right for (8): the root v^0 = (sqrt(1 + 1/w) - 1)/2 of 4 w v (1 + v) = 1.
TEST(Beccari2007, TensionOfStep3BelongsToTheOtherWeight) {
  const auto step_3 = [](const RationalFunction& w, const RationalFunction& v) {
    // v + 1/2 >= 0 and (v + 1/2)^2 (4w)^2 = 2w (2w+1)
    return (v + rf("1/2")).pow(2) * w.pow(2) * RationalFunction(16) ==
           RationalFunction(2) * w * (RationalFunction(2) * w + RationalFunction(1));
  };
  const RationalFunction v = RationalFunction::variable("v");
  // What (8) gives for samples of a function of the space, from the definition: e = e^{tu}.
  for (const Rational& e : {Rational(2), Rational(7, 4)}) {
    const auto f = [&](long i) { return e.pow(i); };
    const Rational middle = f(1) - (f(0) + f(2)) / Rational(2);
    const Rational w = middle / ((f(0) + f(2) - f(-2) - f(4)) / Rational(2));
    const Rational v0 = (e + e.inverse()) / Rational(2);
    EXPECT_EQ(w, rf("1/(4*v*(1+v))").evaluate({{"v", v0}}));
    EXPECT_NE(w, rf("1/(8*v*(1+v))").evaluate({{"v", v0}}));
    EXPECT_EQ((Rational(2) * v0 + Rational(1)).pow(2), Rational(1) + w.inverse());  // the right step 3.1
  }
  EXPECT_TRUE(step_3(rf("1/(8*v*(1+v))"), v));
  EXPECT_FALSE(step_3(rf("1/(4*v*(1+v))"), v));
}

// (9), (10): the end rule is (3) after p_{-1} = 2 p_0 - p_1.
TEST(Beccari2007, EndRule9And10) {
  const RationalFunction w = rf("1/(8*v*(1+v))");
  // Coefficients of p_{-1}, p_0, p_1, p_2 in p_1^{k+1}: a_3, a_1, a_{-1}, a_{-3}.
  const Laurent a = four_point();
  const RationalFunction before = a.coefficient(3);
  EXPECT_EQ(a.coefficient(1) + RationalFunction(2) * before, rf("1/2") - w);
  EXPECT_EQ(a.coefficient(-1) - before, rf("1/2") + RationalFunction(2) * w);
  EXPECT_EQ(a.coefficient(-3), -w);
}

}  // namespace
}  // namespace twoscale::tests
