// SPDX-License-Identifier: GPL-3.0-or-later
// Local subdivision matrices: what is known of B-splines and Deslauriers-Dubuc schemes, the defining identities over
// the catalogue and over random masks, comparison of moduli.
#include "twoscale/analysis/spectrum.hpp"

#include <cmath>

#include "support/laws.hpp"
#include "twoscale/analysis/roots.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::analysis {
namespace {

Spectrum limit_spectrum(const std::string& name) {
  const Scheme s = make_scheme(name);
  return spectrum(limit_symbol(s).value(), s.arity);
}

Laurent mask_of(long lowest, const std::string& text) {
  std::vector<RationalFunction> c;
  for (const auto& piece : split_list(text)) c.push_back(parse_rational_function(piece));
  return {lowest, std::move(c)};
}

std::vector<std::string> names(const Spectrum& s) {
  std::vector<std::string> list;
  for (const auto& e : s.eigenvalues)
    for (unsigned k = 0; k < s.factors[e.factor].multiplicity; ++k) list.push_back(e.exact);
  return list;
}

// c modulo the monic polynomial p.
SpectralPolynomial reduced(SpectralPolynomial c, const SpectralPolynomial& p) {
  const std::size_t d = p.size() - 1;
  while (c.size() > d) {
    const RationalFunction lead = c.back();
    c.pop_back();
    for (std::size_t i = 0; i < d; ++i) c[c.size() - d + i] -= lead * p[i];
  }
  c.resize(d);
  return c;
}

// a u = x u over Q(parameters)[x]/(p), u not zero.
bool is_eigenvector(const SymbolicMatrix& a, const Eigenvector& u, const SpectralPolynomial& p) {
  bool zero = true;
  for (std::size_t i = 0; i < a.rows(); ++i) {
    SpectralPolynomial left(p.size() - 1);
    for (std::size_t j = 0; j < a.rows(); ++j) {
      if (u[j].size() >= p.size()) return false;
      for (std::size_t k = 0; k < u[j].size(); ++k) left[k] += a(i, j) * u[j][k];
    }
    SpectralPolynomial right{0};
    right.insert(right.end(), u[i].begin(), u[i].end());
    right = reduced(std::move(right), p);
    if (!(left == right)) return false;
    for (const auto& c : u[i]) zero = zero && c.is_zero();
  }
  return !zero;
}

RationalFunction value_at(const SpectralPolynomial& p, const RationalFunction& x) {
  RationalFunction r;
  for (std::size_t k = p.size(); k-- > 0;) r = r * x + p[k];
  return r;
}

// Everything that must hold for any mask.
void expect_consistent(const Spectrum& s) {
  const SymbolicMatrix& a = s.matrix.entries;
  const std::size_t n = a.rows();
  const SymbolicMatrix transpose = transposed(a);
  std::size_t total = 0;
  SpectralPolynomial product{1};
  for (const auto& f : s.factors) {
    total += f.degree() * f.multiplicity;
    EXPECT_TRUE(f.polynomial.back().is_one());
    EXPECT_EQ(f.right.size(), f.geometric);
    EXPECT_EQ(f.left.size(), f.geometric);
    EXPECT_GE(f.geometric, 1U);
    EXPECT_LE(f.geometric, f.multiplicity);
    EXPECT_EQ(rank(polynomial_of(a, f.polynomial)), n - f.geometric * f.degree());
    for (const auto& u : f.right) EXPECT_TRUE(is_eigenvector(a, u, f.polynomial));
    for (const auto& u : f.left) EXPECT_TRUE(is_eigenvector(transpose, u, f.polynomial));
  }
  EXPECT_EQ(total, n);
  // Both sides are monic of degree n: equal at n values, equal. With parameters three of them are costly enough.
  for (std::size_t x = 0; x < (constant(a) ? n : std::min<std::size_t>(n, 3)); ++x) {
    SymbolicMatrix shifted(n, n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        shifted(i, j) = (i == j ? RationalFunction(static_cast<long>(x)) : RationalFunction()) - a(i, j);
    RationalFunction value = 1;
    for (const auto& f : s.factors) value *= value_at(f.polynomial, static_cast<long>(x)).pow(f.multiplicity);
    const auto over_q = constant(shifted);
    EXPECT_EQ(over_q ? RationalFunction(determinant(*over_q)) : determinant(shifted), value);
  }
  std::size_t roots = 0;
  bool numeric = true;
  double last = 0;
  for (const auto& e : s.eigenvalues) {
    roots += e.roots * s.factors[e.factor].multiplicity;
    EXPECT_LE(numeric ? 0 : 1, e.real ? 0 : 1) << "eigenvalues with parameters come last";
    const double size = std::hypot(e.approximate[0], e.approximate[1]);
    const bool first = roots == e.roots * s.factors[e.factor].multiplicity;
    if (e.real && !first) {
      EXPECT_LE(size, last * (1 + 1e-12));  // the doubles are correct but for their last bits
    }
    last = size;
    numeric = e.real.has_value();
  }
  EXPECT_EQ(roots, n);
}

TEST(LocalMatrix, Indices) {
  const auto range = [](const std::string& name) {
    const Scheme s = make_scheme(name);
    const LocalMatrix m = local_matrix(*limit_symbol(s), s.arity);
    return std::pair{m.lowest, m.lowest + static_cast<long>(m.entries.rows()) - 1};
  };
  EXPECT_EQ(range("dd:l=2"), (std::pair{-3L, 3L}));
  EXPECT_EQ(range("bspline:n=2"), (std::pair{-2L, 1L}));  // dual Chaikin: -1..2
  EXPECT_EQ(range("bspline:n=3"), (std::pair{-2L, 2L}));
  EXPECT_EQ(range("bspline:n=3,arity=3"), (std::pair{-2L, 2L}));
  EXPECT_EQ(range("bspline:n=3,arity=4"), (std::pair{-2L, 2L}));
  EXPECT_THROW(local_matrix(Laurent::monomial(1), 3), Error);
  EXPECT_THROW(local_matrix(Laurent(), 2), Error);
  const LocalMatrix m = local_matrix(mask_of(-1, "1/4,3/4,3/4,1/4"), 2);
  for (long i = -2; i <= 1; ++i)
    for (long j = -2; j <= 1; ++j) {
      const long k = i - 2 * j;
      const RationalFunction expected = k < -1 || k > 2     ? Rational(0)
                                        : k == -1 || k == 2 ? Rational(1, 4)
                                                            : Rational(3, 4);
      EXPECT_EQ(m.entries(static_cast<std::size_t>(i + 2), static_cast<std::size_t>(j + 2)), expected);
    }
}

TEST(Spectrum, SplinesHaveThePowersOfTheArity) {
  for (const int m : {2, 3, 4, 5})
    for (int n = 1; n <= 6; ++n) {
      const Spectrum s = limit_spectrum("bspline:n=" + std::to_string(n) + ",arity=" + std::to_string(m));
      const auto found = names(s);
      for (std::size_t k = 0; k < found.size(); ++k) {
        const long power = std::min<long>(static_cast<long>(k), n);
        EXPECT_EQ(found[k], Rational(m).pow(-power).to_string());
      }
      // Where 0 is no knot the limits are polynomials around it.
      const bool knot = found.size() == static_cast<std::size_t>(n) + 2;
      EXPECT_EQ(s.necessary.order, knot ? n - 1 : n) << s.necessary.obstruction;
      EXPECT_EQ(s.necessary.kind, NecessaryConditions::Kind::decided);
    }
  EXPECT_EQ(limit_spectrum("bspline:n=0").necessary.order, -1);
}

TEST(Spectrum, DeslauriersDubuc) {
  const Spectrum four = limit_spectrum("dd:l=2");
  EXPECT_EQ(names(four), (std::vector<std::string>{"1", "1/2", "1/4", "1/4", "1/8", "-1/16", "-1/16"}));
  for (const auto& f : four.factors) {
    const bool jordan_block = f.polynomial[0] == RationalFunction(Rational(-1, 4));
    EXPECT_EQ(f.geometric, jordan_block ? 1U : f.multiplicity);
  }
  EXPECT_EQ(four.necessary.order, 1);
  const Spectrum six = limit_spectrum("dd:l=3");
  EXPECT_EQ(six.eigenvalues[3].exact, "9/64");
  EXPECT_EQ(six.necessary.order, 2);
  EXPECT_NE(six.necessary.obstruction.find("9/64"), std::string::npos);
}

TEST(Spectrum, SixteenPoints) {
  const Spectrum s = limit_spectrum("dd:l=8");
  ASSERT_EQ(s.matrix.entries.rows(), 31U);
  const auto found = names(s);
  for (int k = 0; k < 16; ++k)
    EXPECT_NE(std::find(found.begin(), found.end(), Rational(2).pow(-k).to_string()), found.end());
  expect_consistent(s);
}

TEST(Spectrum, FourPointsWithATension) {
  const Spectrum s = spectrum(mask_of(-3, "-w,0,1/2+w,1,1/2+w,0,-w"), 2);
  expect_consistent(s);
  EXPECT_EQ(names(s), (std::vector<std::string>{"1", "1/2", "-w", "-w", "2*w", "1/4 + sqrt(-(16*w - 1))/4",
                                                "1/4 - sqrt(-(16*w - 1))/4"}));
  EXPECT_EQ(s.necessary.kind, NecessaryConditions::Kind::conditional);
  EXPECT_EQ(s.necessary.order, 1);
  EXPECT_EQ(s.necessary.conditions.size(), 4U);
  // w = 1/4: 1/2 twice, and two complex ones of the same modulus after them.
  EXPECT_EQ(names(spectrum(mask_of(-3, "-1/4,0,3/4,1,3/4,0,-1/4"), 2)),
            (std::vector<std::string>{"1", "1/2", "1/2", "1/4 + I*sqrt(3)/4", "1/4 - I*sqrt(3)/4", "-1/4", "-1/4"}));
  // A parameter called x: the polynomials are in another variable.
  EXPECT_EQ(spectrum(mask_of(-3, "-x,0,1/2+x,1,1/2+x,0,-x"), 2).variable, "xx");
}

TEST(Spectrum, WithoutConvergence) {
  EXPECT_EQ(spectrum(mask_of(-1, "1/2,1/2,1/2"), 2).necessary.order, -1);
  const Spectrum constants = spectrum(mask_of(-1, "1/4,1,3/4,1/2"), 2);
  EXPECT_EQ(constants.necessary.order, -1) << constants.necessary.obstruction;
}

// The 4-point ternary interpolation by cubics: a_{3j+s} from the Lagrange polynomials.
TEST(Spectrum, Ternary) {
  const Spectrum s = spectrum(mask_of(-5, "-4/81,-5/81,0,30/81,60/81,1,60/81,30/81,0,-5/81,-4/81"), 3);
  expect_consistent(s);
  ASSERT_GE(s.stencils.size(), 2U);
  EXPECT_EQ(s.stencils[0].lowest, 0);
  EXPECT_EQ(s.stencils[0].coefficients, std::vector<RationalFunction>{1});
  EXPECT_EQ(names(s)[1], "1/3");
}

TEST(LimitStencils, Splines) {
  const auto texts = [](const LimitStencil& l) {
    std::vector<std::string> t;
    for (const auto& c : l.coefficients) t.push_back(c.to_string());
    return t;
  };
  using Texts = std::vector<std::string>;
  for (const int m : {2, 3, 4}) {
    const Spectrum s = limit_spectrum("bspline:n=3,arity=" + std::to_string(m));
    ASSERT_EQ(s.stencils.size(), 3U);
    EXPECT_EQ(texts(s.stencils[0]), (Texts{"1/6", "2/3", "1/6"}));
    EXPECT_EQ(texts(s.stencils[1]), (Texts{"-1/2", "0", "1/2"}));
    EXPECT_EQ(texts(s.stencils[2]), (Texts{"1", "-2", "1"}));
    for (const auto& l : s.stencils) EXPECT_EQ(l.lowest, -1);
  }
  const Spectrum chaikin = limit_spectrum("bspline:n=2");
  ASSERT_EQ(chaikin.stencils.size(), 2U);
  EXPECT_EQ(texts(chaikin.stencils[0]), (Texts{"1/2", "1/2"}));
  EXPECT_EQ(texts(chaikin.stencils[1]), (Texts{"-1", "1"}));
  EXPECT_EQ(chaikin.stencils[1].lowest, -1);
}

// What reproduces polynomials of degree < 2l has the derivatives of t^r at 0: r! if r is the order, else 0.
TEST(LimitStencils, DerivativesOfPolynomials) {
  for (int l = 1; l <= 6; ++l) {
    const Spectrum s = limit_spectrum("dd:l=" + std::to_string(l));
    for (const auto& stencil : s.stencils) {
      Rational factorial = 1;
      for (long r = 0; r < 2 * l; ++r) {
        if (r > 0) factorial *= Rational(r);
        RationalFunction sum;
        for (std::size_t i = 0; i < stencil.coefficients.size(); ++i)
          sum += stencil.coefficients[i] * RationalFunction(Rational(stencil.lowest + static_cast<long>(i)).pow(r));
        EXPECT_EQ(sum, RationalFunction(r == static_cast<long>(stencil.derivative) ? factorial : Rational(0)));
      }
    }
    EXPECT_GE(s.stencils.size(), static_cast<std::size_t>(l));
  }
}

TEST(SpectrumOfCatalog, Consistent) {
  for (const auto& entry : catalog())
    for (const auto& name : entry.examples) {
      const Scheme scheme = make_scheme(name);
      if (scheme.block != 1 || !is_uniform(scheme)) continue;
      const auto limit = limit_symbol(scheme);
      if (!limit || limit->coefficients().size() > 24) continue;
      SCOPED_TRACE(name);
      expect_consistent(spectrum(*limit, scheme.arity));
    }
}

TEST(SpectrumOfCatalog, LevelVariablesStaySymbols) {
  for (const char* name : {"tension4", "interpolating:family=harmonic,l=3", "mixed:n=1", "harmonic:n=2", "mixed:n=2",
                           "exponential-bspline:space=\"exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)\""}) {
    SCOPED_TRACE(name);
    const Scheme scheme = make_scheme(name);
    expect_consistent(spectrum(symbol(scheme), scheme.arity));
  }
}

TEST(SpectrumOfCatalog, TwoLevelVariablesSlow) {
  const Scheme scheme = make_scheme("interpolating:space=\"1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)\"");
  expect_consistent(spectrum(symbol(scheme), scheme.arity));
}

// ---- moduli

TEST(Moduli, EqualOnes) {
  const auto equal = [](const Roots& p, std::size_t i, const Roots& q, std::size_t j) {
    const auto order = compare_moduli({&p, i}, {&q, j});
    return order && *order == std::strong_ordering::equal;
  };
  const Roots cube({-2, 0, 0, 1}), minus({2, 0, 0, 1}), fourth({-2, 0, 0, 0, 1}), sixth({-4, 0, 0, 0, 0, 0, 1});
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      EXPECT_TRUE(equal(cube, i, cube, j));
      EXPECT_TRUE(equal(cube, i, minus, j));
    }
  for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(equal(fourth, 0, fourth, i));
  for (std::size_t i = 0; i < 4; ++i) EXPECT_FALSE(equal(fourth, i, cube, 0));
  EXPECT_EQ(fourth.decimal(2, 5).substr(fourth.decimal(2, 5).size() - 2), "*I");
  EXPECT_EQ(fourth.decimal(2, 5).find(' '), std::string::npos) << "the real part is 0: " << fourth.decimal(2, 5);
  // x^4 + x^3 + x^2 + x + 1 scaled by 1/2: all of modulus 1/2.
  const Roots unit({Rational(1, 16), Rational(1, 8), Rational(1, 4), Rational(1, 2), 1});
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_TRUE(compare_modulus({&unit, i}, Rational(1, 2)) == std::strong_ordering::equal);
    EXPECT_TRUE(compare_modulus({&unit, i}, Rational(1, 2) + Rational(10).pow(-60)) == std::strong_ordering::less);
    EXPECT_TRUE(compare_modulus({&unit, i}, Rational(1, 2) - Rational(10).pow(-60)) == std::strong_ordering::greater);
  }
}

TEST(Moduli, BoxesIsolate) {
  const Roots p({Rational(-647, 2352), Rational(107, 336), Rational(6, 7), Rational(-23, 12), 1});
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto box = p.isolate(i);
    EXPECT_LE(box.real[0], box.real[1]);
    EXPECT_EQ(p.is_real(i), box.imaginary[0].is_zero() && box.imaginary[1].is_zero());
    if (!p.is_real(i)) continue;
    const auto value = [&](const Rational& x) {
      Rational r;
      for (std::size_t k = p.polynomial().size(); k-- > 0;) r = r * x + p.polynomial()[k];
      return r.sign();
    };
    EXPECT_EQ(value(box.real[0]) * value(box.real[1]), -1);
  }
}

// ---- laws

struct Random {
  Laurent mask;
  int arity;
};

Random random_mask(bool parameters) {
  const long lowest = uniform(-6L, 1L);
  auto c = several(uniform<size_t>(0, parameters ? 7 : 11), [parameters] {
    const long n = uniform(-4L, 5L);
    RationalFunction x = Rational(n, uniform(1L, 5L));
    if (parameters && uniform(0, 4) == 0) x *= RationalFunction::variable("w");
    return x;
  });
  c.insert(c.begin(), RationalFunction(1));
  c.push_back(RationalFunction(Rational(1, 2)));
  return {Laurent(lowest, std::move(c)), uniform(2, 5)};
}

LAW(Laws, RandomMasks, ()) {
  const Random r = random_mask(false);
  LAW_GIVEN(static_cast<long>(r.mask.coefficients().size()) > r.arity);
  const Spectrum s = spectrum(r.mask, r.arity);
  expect_consistent(s);
  LAW_ASSERT(!testing::Test::HasFailure());
  const Matrix<Rational> a = *constant(s.matrix.entries);
  const auto p = characteristic_polynomial(a);
  LAW_ASSERT(polynomial_of(a, p) == Matrix<Rational>(a.rows(), a.rows()));  // Cayley and Hamilton
  LAW_ASSERT((a.rows() % 2 == 0 ? p[0] : -p[0]) == determinant(a));
  const SymbolicMatrix b = symbolic(a);
  const auto q = characteristic_polynomial(b);
  for (std::size_t k = 0; k < p.size(); ++k) LAW_ASSERT(q[k] == RationalFunction(p[k]));
  LAW_ASSERT(determinant(b) == RationalFunction(determinant(a)));
  LAW_ASSERT(rank(b) == rank(a));
  LAW_ASSERT(kernel(b).size() == kernel(a).size());
  for (const auto& x : kernel(a))
    for (const auto& c : product(a, x)) LAW_ASSERT(c.is_zero());
  const auto inverted = inverse(a);
  LAW_ASSERT(inverted.has_value() == !determinant(a).is_zero());
  if (inverted) {
    LAW_ASSERT(product(a, *inverted) == Matrix<Rational>::identity(a.rows()));
    LAW_ASSERT(symbolic(*inverted) == inverse(b).value());
  }
}

LAW(Laws, RandomMasksWithAParameter, ()) {
  const Random r = random_mask(true);
  LAW_GIVEN(static_cast<long>(r.mask.coefficients().size()) > r.arity);
  const Spectrum s = spectrum(r.mask, r.arity);
  expect_consistent(s);
  LAW_ASSERT(!testing::Test::HasFailure());
  const SymbolicMatrix& a = s.matrix.entries;
  const auto p = characteristic_polynomial(a);
  LAW_ASSERT(polynomial_of(a, p) == SymbolicMatrix(a.rows(), a.rows()));
  LAW_ASSERT((a.rows() % 2 == 0 ? p[0] : -p[0]) == determinant(a));
  const auto inverted = inverse(a);
  LAW_ASSERT(inverted.has_value() == !determinant(a).is_zero());
  if (inverted) {
    LAW_ASSERT(product(a, *inverted) == SymbolicMatrix::identity(a.rows()));
  }
}

}  // namespace
}  // namespace twoscale::analysis
