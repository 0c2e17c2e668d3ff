// SPDX-License-Identifier: GPL-3.0-or-later
/// Quasi-splines against the definitions of generation and reproduction, for any space and any part of it.
#include "twoscale/symbolic/quasi_spline.hpp"

#include "support/laws.hpp"
#include "symbolic/exact_points.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::tests {
namespace {

Space polynomials(unsigned order) { return Space::one_frequency(order, {}); }

/// x^r E^{n x} at x = half/2, in units of the fine spacing; required: n even if half is odd.
Rational at_half(const Rational& e, long n, unsigned r, long half) {
  return Rational(half, 2).pow(static_cast<long>(r)) * e.pow(n * half / 2);
}

struct Part {
  long multiple;
  unsigned order;
  Rational e;
};

std::vector<Part> parts(const Space& space, const std::vector<Rational>& e) {
  std::vector<Part> list;
  if (space.polynomial_order() > 0) list.push_back({0, space.polynomial_order(), 1});
  for (const auto& x : space.exponentials())
    for (const long sign : {1L, -1L}) list.push_back({sign * static_cast<long>(x.multiple), x.order, e[x.variable]});
  return list;
}

/// Data at 2 (j + p) become data at i + p, p = 0 or 1/2.
bool reproduces(const std::map<long, Rational>& mask, const Space& space, const std::vector<Rational>& e, bool dual) {
  for (const Part& f : parts(space, e))
    for (unsigned r = 0; r < f.order; ++r)
      for (const long i : {0L, 1L, 6L, -3L}) {
        Rational sum;
        for (const auto& [index, value] : mask)
          if ((i - index) % 2 == 0) sum += value * at_half(f.e, f.multiple, r, 2 * (i - index) + (dual ? 2 : 0));
        if (sum != at_half(f.e, f.multiple, r, 2 * i + (dual ? 1 : 0))) return false;
      }
  return true;
}

/// Both rules agree on every function: sum over even and over odd i of i^r a_i z^i.
bool generates(const std::map<long, Rational>& mask, const Space& space, const std::vector<Rational>& e) {
  for (const Part& f : parts(space, e))
    for (unsigned r = 0; r < f.order; ++r) {
      Rational even, odd;
      for (const auto& [i, value] : mask)
        (i % 2 == 0 ? even : odd) += Rational(i).pow(static_cast<long>(r)) * value * f.e.pow(-f.multiple * i);
      if (even != odd) return false;
    }
  return true;
}

/// Everything that is asked of a quasi-spline; empty if all is well.
std::string fault(const Space& space, const Space& part) {
  const QuasiSpline s = quasi_spline(space, part);
  const bool dual = space.dimension() % 2 == 1;
  const long n = static_cast<long>(s.order());
  const long m = static_cast<long>(s.terms());
  if (!s.mask.is_canonical() || !(s.beta * s.q == s.mask)) return "the mask is not beta q";
  if (s.mask.centre_of_symmetry() != (dual ? Rational(1, 2) : Rational(0))) return "centre";
  if (s.q.highest() > m - 1 || s.mask.coefficients().size() > static_cast<size_t>(n + 2 * m - 1)) return "support";
  // 2 M is the dimension of what is reproduced, but for a zero without partner.
  const unsigned dimension = s.reproduced.dimension();
  if (2 * m != static_cast<long>(dimension + dimension % 2)) return "M";
  for (size_t r = 0; r < s.matrix.size(); ++r) {
    RationalFunction sum;
    for (size_t c = 0; c <= r; ++c) sum += s.matrix[r][c] * s.solution[c];
    for (size_t c = r + 1; c < s.matrix.size(); ++c)
      if (!s.matrix[r][c].is_zero()) return "not lower triangular";
    if (!(sum == s.rhs[r])) return "the system is not solved";
  }
  RationalFunction diagonal = 1;
  for (size_t r = 0; r < s.matrix.size(); ++r) diagonal *= s.matrix[r][r];
  if (!(diagonal == s.determinant)) return "determinant";
  for (const size_t variant : {size_t{0}, size_t{2}}) {
    const auto e = exponential_points(s.space, variant);
    const auto mask = mask_at(s.mask, level_values(s.space, e));
    if (!mask) return "pole at real frequencies";
    if (!generates(*mask, s.space, e)) return "does not generate the space";
    if (!reproduces(*mask, s.reproduced, e, dual)) return "does not reproduce its part";
  }
  if (n == 2 * m && !(s.mask == interpolating_symbol(s.space))) return "not the interpolating scheme for N = 2M";
  return "";
}

/// A part of a space: how many powers of x, and how many of each exponential, counted in items.
Space part_of(const Space& space, const std::vector<unsigned>& choice) {
  const auto items = space.items();
  std::string text;
  const auto add = [&](const std::string& item) { text += (text.empty() ? "" : ", ") + item; };
  size_t at = 0, next = 0;
  const auto take = [&](unsigned order, size_t each) {
    const unsigned kept = choice[next++ % choice.size()] % (order + 1);
    for (unsigned r = 0; r < order; ++r)
      for (size_t k = 0; k < each; ++k, ++at)
        if (r < kept) add(items[at]);
  };
  if (space.polynomial_order() > 0) take(space.polynomial_order(), 1);
  for (const auto& e : space.exponentials()) take(e.order, 2);
  return text.empty() ? Space() : Space::parse(text);
}

LAW(QuasiSpline, ReproducesAnyPartOfAnySpace, (const Space& space)) {
  const Space part = part_of(space, several(6, [] { return uniform(0U, 12U); }));
  LAW_GIVEN(part.dimension() > 0U);
  LAW_ASSERT(fault(space, part) == std::string());
}

LAW(QuasiSpline, ReproducesAllOfAnySpace, (const Space& space)) { LAW_ASSERT(fault(space, space) == std::string()); }

/// omega moves along what the part leaves free; tension along the line between two members.
LAW(QuasiSpline, WhatIsReproducedStaysAlongTheLine, (const Space& space)) {
  const Space part = part_of(space, several(6, [] { return uniform(0U, 12U); }));
  LAW_GIVEN(part.dimension() > 0U);
  const QuasiSpline s = quasi_spline(space, part);
  const QuasiSpline all = quasi_spline(s.space, space);
  // The two may differ in how far the frequencies are halved.
  const Space common = all.space;
  const Space fine = Space::rebase(s.reproduced, common.variables()).space;
  const QuasiSpline own = quasi_spline(common, fine);
  const auto e = exponential_points(common);
  const bool dual = space.dimension() % 2 == 1;
  for (const Laurent& direction : {own.beta * free_factor(own), all.mask - own.mask}) {
    const auto mask = mask_at(own.mask + RationalFunction(Rational(2, 7)) * direction, level_values(common, e));
    LAW_ASSERT(mask.has_value());
    LAW_ASSERT(generates(*mask, common, e));
    LAW_ASSERT(reproduces(*mask, own.reproduced, e, dual));
  }
}

/// The de Rham transform keeps what its primal scheme generates and reproduces.
LAW(QuasiSpline, DeRhamKeepsSpaces, (const Space& space)) {
  LAW_GIVEN(space.dimension() % 2 == 0U && space.dimension() <= 6U);
  const Space part = part_of(space, several(6, [] { return uniform(0U, 12U); }));
  LAW_GIVEN(part.dimension() > 0U);
  const QuasiSpline s = quasi_spline(space, part);
  const DeRham d = de_rham_transform(s.space, s.mask);
  const auto e = exponential_points(d.space);
  const auto mask = mask_at(d.mask, level_values(d.space, e));
  LAW_ASSERT(mask.has_value());
  LAW_ASSERT(d.mask.centre_of_symmetry() == Rational(1, 2));
  LAW_ASSERT(generates(*mask, d.space, e));
  LAW_ASSERT(reproduces(*mask, Space::rebase(s.reproduced, d.space.variables()).space, e, true));
}

TEST(QuasiSpline, ChosenSpaces) {
  const std::vector<std::pair<const char*, const char*>> cases = {
      {"1", "1"},
      {"1,x,x^2", "1,x,x^2"},
      {"1,exp(t*x),exp(-t*x)", "exp(t*x),exp(-t*x)"},
      {"1,exp(t*x),exp(-t*x)", "1,exp(t*x),exp(-t*x)"},
      {"1,exp(t*x/2),exp(-t*x/2),exp(t*x/3),exp(-t*x/3)", "exp(t*x/3),exp(-t*x/3)"},
      {"1,x,x^2,cos(s*x),sin(s*x),x*cos(s*x),x*sin(s*x),exp(t*x),exp(-t*x)", "cos(s*x),sin(s*x),x*cos(s*x),x*sin(s*x)"},
      {"1,x,x^2,cos(s*x),sin(s*x),exp(2*t*x),exp(-2*t*x),exp(4*t*x),exp(-4*t*x)",
       "1,exp(2*t*x),exp(-2*t*x),exp(4*t*x),exp(-4*t*x)"},
      {"1,exp(t*x),exp(-t*x),x*exp(t*x),x*exp(-t*x),x^2*exp(t*x),x^2*exp(-t*x),x^3*exp(t*x),x^3*exp(-t*x)",
       "exp(t*x),exp(-t*x),x*exp(t*x),x*exp(-t*x),x^2*exp(t*x),x^2*exp(-t*x),x^3*exp(t*x),x^3*exp(-t*x)"},
      {"cosh(x),sinh(x),1,x", "cosh(x),sinh(x)"}};
  for (const auto& [space, part] : cases) EXPECT_EQ(fault(Space::parse(space), Space::parse(part)), "") << space;
}

/// An odd power needs no condition of its own: x^{2r+1} comes with x^{2r} where it is generated.
TEST(QuasiSpline, OddPowersAreCompleted) {
  const auto completed = [](const char* space, const char* part) {
    return quasi_spline(Space::parse(space), Space::parse(part)).reproduced.to_string();
  };
  EXPECT_EQ(completed("1,x,x^2,x^3", "1"), "1, x");
  EXPECT_EQ(completed("1,x,x^2,x^3", "1,x,x^2"), "1, x, x^2, x^3");
  EXPECT_EQ(completed("1,x,x^2", "1"), "1, x");
  EXPECT_EQ(completed("1,x,x^2", "1,x,x^2"), "1, x, x^2");  // x^3 is not generated
  EXPECT_EQ(completed("1,exp(t*x),exp(-t*x)", "1"), "1");
}

/// v belongs to half the frequency where the values at a frequency need it, and only there.
TEST(QuasiSpline, LevelVariableOfHalfTheFrequency) {
  const auto frequency = [](const char* space, const char* part) {
    return quasi_spline(Space::parse(space), Space::parse(part)).space.variables()[0].frequency();
  };
  EXPECT_EQ(frequency("1,exp(t*x),exp(-t*x)", "exp(t*x),exp(-t*x)"), "t/2");
  EXPECT_EQ(frequency("1,exp(t*x),exp(-t*x)", "1"), "t");
  EXPECT_EQ(frequency("1,x,exp(t*x),exp(-t*x)", "exp(t*x),exp(-t*x)"), "t");
  EXPECT_EQ(frequency("1,exp(t*x),exp(-t*x),exp(2*t*x),exp(-2*t*x)", "exp(2*t*x),exp(-2*t*x)"), "t");
  EXPECT_EQ(frequency("1,exp(t*x),exp(-t*x),exp(2*t*x),exp(-2*t*x)", "exp(t*x),exp(-t*x)"), "t/2");
}

TEST(QuasiSpline, RefusesWhatCannotBeReproduced) {
  const auto refusal = [](const char* name) -> std::string {
    try {
      make_scheme(name);
    } catch (const Error& e) {
      return e.what();
    }
    return "made";
  };
  const auto names = [&](const char* name, const char* piece) {
    EXPECT_NE(refusal(name).find(piece), std::string::npos) << name << ": " << refusal(name);
  };
  names("quasi-spline:space=\"1,x\",reproduce=\"1,x,x^2\"", "x^2");
  names("quasi-spline:space=\"1,x\",reproduce=\"exp(t*x),exp(-t*x)\"", "exp(t*x)");
  names("quasi-spline:space=\"1,exp(t*x)\"", "exp(-t*x)");
  names("quasi-spline:space=\"1,x\",reproduce=\"\"", "empty");
  names("quasi-spline:space=\"1,x\",omega=w,tension=w", "not both");
  names("quasi-spline:space=\"1,x,exp(t*x),exp(-t*x)\",omega=t", "t");
  names("quasi-spline:space=\"1,x,exp(t*x),exp(-t*x)\",tension=v", "v");
  names("quasi-spline:space=\"1,x,exp(t*x),exp(-t*x)\",omega=v0", "v0");
  names("quasi-spline:space=\"1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)\",omega=v_s+1", "v_s");
  names("quasi-spline:space=\"1,x,x^2,x^3\",omega=1/0", "1/0");
  names("quasi-spline:space=\"1,x,x^2,x^3\",keep=\"1,x\"", "tension");
  names("quasi-spline:space=\"1,x,x^2,x^3\",tension=w,keep_space=\"1,x,x^2\"", "even");
  names("quasi-spline:space=\"1,x,x^2,x^3\",tension=w,keep_space=\"1,x,exp(t*x),exp(-t*x)\"", "exp(t*x)");
  names("quasi-spline:space=\"1,x,x^2,x^3\",reproduce=\"1,x\",tension=w,keep=\"1,x,x^2,x^3\"", "x^2");
  names("pseudo-spline:order=4,l=2", "l must be");
  names("dual:space=\"1,x,x^2\"", "even");
  names("de-rham:space=\"1,x,x^2\"", "even");
}

/// Dong and Shen 2007: cos^{2m} sum_{j<=l} C(m+l, j) sin^{2j} cos^{2(l-j)}, m = N/2; Dyn, Hormann, Sabin and Shen 2008:
/// cos^N sum_{j<=l} C(N/2-1+j, j) sin^{2j} for any N. x = 2 - 4 y, y = sin^2.
TEST(QuasiSpline, PseudoSplinesAreTheStationaryMembers) {
  const Laurent y(
      -1, {RationalFunction(Rational(-1, 4)), RationalFunction(Rational(1, 2)), RationalFunction(Rational(-1, 4))});
  const Laurent one = Laurent::monomial(0);
  for (unsigned n = 1; n <= 9; ++n)
    for (unsigned l = 0; 2 * l + 1 <= n; ++l) {
      const std::string name = "pseudo-spline:order=" + std::to_string(n) + ",l=" + std::to_string(l);
      Laurent taylor, shen;
      Laurent power = one;
      for (unsigned j = 0; j <= l; ++j) {
        taylor = taylor + RationalFunction(
                              Rational::binomial(Rational(static_cast<long>(n) + 2 * static_cast<long>(j) - 2, 2), j)) *
                              power;
        Laurent rest = one;
        for (unsigned i = j; i < l; ++i) rest = rest * (one - y);
        shen = shen +
               RationalFunction(Rational::binomial(Rational(static_cast<long>(n) + 2 * static_cast<long>(l), 2), j)) *
                   power * rest;
        power = power * y;
      }
      const Laurent beta = bspline_symbol(polynomials(n));
      const Laurent mask = symbol(make_scheme(name));
      EXPECT_EQ(mask, beta * taylor) << name;
      if (n % 2 == 0) {
        EXPECT_EQ(mask, beta * shen) << name;
      }
    }
}

/// The level-dependent members tend to the pseudo-spline of their N and M.
TEST(QuasiSpline, ConfluenceIsThePseudoSpline) {
  for (const char* name :
       {"quasi-spline:space=\"1,x,x^2,exp(t*x),exp(-t*x)\",reproduce=\"1,x,exp(t*x),exp(-t*x)\"",
        "quasi-spline:space=\"1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)\",reproduce=\"1,x,exp(t*x),exp(-t*x)\""}) {
    const Scheme s = make_scheme(name);
    const std::string order = std::to_string(s.space->dimension());
    EXPECT_EQ(limit_symbol(s), symbol(make_scheme("pseudo-spline:order=" + order + ",l=1"))) << name;
  }
}

/// The interpolant of 2l points at 1/4 and 3/4, from Lagrange polynomials.
TEST(QuasiSpline, DualPointSchemesReadTheInterpolantAtTheQuarters) {
  for (long l = 1; l <= 5; ++l) {
    const Laurent a =
        symbol(make_scheme("dual:space=\"" + polynomials(static_cast<unsigned>(2 * l)).to_string() + "\""));
    EXPECT_EQ(a.lowest(), 1 - 2 * l);
    EXPECT_EQ(a.highest(), 2 * l);
    for (long j = 1 - l; j <= l; ++j) {  // coarse points at j; the fine point i = 1 + p lies at 1/4 from point 0
      Rational weight = 1;
      for (long i = 1 - l; i <= l; ++i)
        if (i != j) weight *= (Rational(1, 4) - Rational(i)) / Rational(j - i);
      EXPECT_EQ(a.coefficient(1 - 2 * j).constant(), weight) << l << " " << j;
    }
  }
}

/// De Rham: Chaikin from the polygon; the transform keeps what its primal scheme reproduces.
TEST(QuasiSpline, DeRhamTransforms) {
  EXPECT_EQ(symbol(make_scheme("de-rham:space=\"1,x\"")), symbol(make_scheme("bspline:n=2")));
  for (const char* name :
       {"de-rham:space=\"1,x,x^2,x^3\"", "de-rham:space=\"1,x,exp(t*x),exp(-t*x)\"",
        "de-rham:space=\"1,x,exp(t*x),exp(-t*x)\",reproduce=\"1,x\"",
        "de-rham:space=\"1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)\",reproduce=\"exp(s*x),exp(-s*x)\""}) {
    const Scheme s = make_scheme(name);
    EXPECT_EQ(s.shift, Rational(1, 2));
    for (const size_t variant : {size_t{0}, size_t{1}}) {
      const auto e = exponential_points(*s.space, variant);
      const auto mask = mask_at(symbol(s), level_values(*s.space, e));
      ASSERT_TRUE(mask.has_value());
      EXPECT_TRUE(generates(*mask, *s.space, e)) << name;
      for (const Claim& c : s.claims)
        if (c.name == "reproduces") {
          EXPECT_TRUE(reproduces(*mask, Space::rebase(Space::parse(c.subject), s.space->variables()).space, e, true))
              << name;
        }
    }
  }
}

/// Excluded v^0: exactly the poles of the mask.
TEST(QuasiSpline, SingularSet) {
  const QuasiSpline s = quasi_spline(Space::parse("1,x,exp(t*x),exp(-t*x),exp(3*t*x),exp(-3*t*x)"),
                                     Space::parse("exp(3*t*x),exp(-3*t*x)"));
  // T_3(v) + 1, T_3(v) + v and T_3(v) vanish: 3 phi, 4 phi, 6 phi = pi mod 2 pi for phi < pi/2.
  std::vector<std::string> values;
  for (const auto& v : s.singular.values) values.push_back(v.exact() + "@" + std::to_string(v.level));
  EXPECT_EQ(values, (std::vector<std::string>{"-1/2@0", "-1/2@1", "0@0", "1/2@0"}));
  for (const auto& v : {"1/2", "3/5"})  // cos(pi/3) belongs to v^0 = -1/2 at level 0; the other is not excluded
    EXPECT_EQ(s.mask.coefficient(0).evaluate({{"v", Rational::parse(v)}}).has_value(), std::string(v) != "1/2");
  // With what stays away from 3 t nothing is excluded.
  EXPECT_TRUE(quasi_spline(Space::parse("1,x,exp(t*x),exp(-t*x),x*exp(t*x),x*exp(-t*x)"), Space::parse("1,x"))
                  .singular.values.empty());
  // A dual scheme in half the frequency: t = I pi, v^0 = cos(pi/2), is the first excluded one.
  const QuasiSpline d = quasi_spline(Space::parse("1,exp(t*x),exp(-t*x)"), Space::parse("exp(t*x),exp(-t*x)"));
  ASSERT_EQ(d.singular.values.size(), 1U);
  EXPECT_EQ(d.singular.values[0].exact(), "0");
}

}  // namespace
}  // namespace twoscale::tests
