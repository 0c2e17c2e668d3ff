// SPDX-License-Identifier: GPL-3.0-or-later
// Joint spectral radii: known ones, the laws of the joint spectral radius over random rational families, and the
// checker's opinion of every certificate on the way.
#include "twoscale/analysis/jsr.hpp"

#include <algorithm>
#include <cmath>

#include "support/laws.hpp"
#include "twoscale/analysis/certificate.hpp"
#include "twoscale/check/check.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::analysis {

// Found by argument-dependent lookup when a property fails.
inline void showValue(const RationalMatrix& a, std::ostream& out) {
  for (long i = 0; i < a.rows(); ++i) {
    out << (i == 0 ? "(" : "; ");
    for (long j = 0; j < a.columns(); ++j) out << (j == 0 ? "" : " ") << a(i, j).to_string();
  }
  out << ")";
}

namespace {

using Rows = std::vector<std::vector<Rational>>;

RationalMatrix matrix(const Rows& rows) {
  const auto n = static_cast<long>(rows.size());
  RationalMatrix m(n, n);
  for (long i = 0; i < n; ++i)
    for (long j = 0; j < n; ++j) m.set(i, j, rows[static_cast<size_t>(i)][static_cast<size_t>(j)]);
  return m;
}

RealAlgebraic largest_zero(const std::string& polynomial) {
  return RealAlgebraic::zeros(parse_rational_function(polynomial).numerator()).back();
}

bool accepted(const Family& family, const JsrResult& r) {
  const auto report = check::check_text(certificate_text("matrices", family, r.claims));
  return report.status == check::Report::valid;
}

JsrResult radius(const Family& family, JsrOptions options = {}) {
  const JsrResult r = joint_spectral_radius(family, {}, options);
  EXPECT_TRUE(accepted(family, r)) << check::check_text(certificate_text("matrices", family, r.claims)).message;
  EXPECT_LE(r.lower, r.upper);
  if (r.exact) {
    EXPECT_LE(RealAlgebraic::compare(r.lower, *r.exact), 0);
    EXPECT_LE(RealAlgebraic::compare(*r.exact, r.upper), 0);
  }
  return r;
}

void expect_exact(const Family& family, const RealAlgebraic& expected) {
  const JsrResult r = radius(family);
  ASSERT_TRUE(r.exact) << "between " << r.lower.to_string() << " and " << r.upper.to_string();
  EXPECT_EQ(*r.exact, expected) << r.exact->polynomial().to_string() << " near " << r.exact->estimate();
  // Each cycle attains it.
  for (const auto& w : r.cycles) {
    const auto leading = leading_eigenvalues(product(family, w));
    ASSERT_FALSE(leading.empty());
    EXPECT_EQ(leading[0].root_of_modulus(static_cast<unsigned>(w.size())), expected);
  }
}

// ---- known radii

TEST(JsrKnown, GoldenRatio) {
  const Family pair{matrix({{1, 1}, {0, 1}}), matrix({{1, 0}, {1, 1}})};
  expect_exact(pair, largest_zero("x^2-x-1"));
  const JsrResult r = radius(pair);
  ASSERT_FALSE(r.cycles.empty());
  EXPECT_EQ(r.cycles[0].size(), 2U);
  EXPECT_TRUE(r.bounded);
}

TEST(JsrKnown, OneMatrix) {
  // Irreducible over Q, not over R: the orbit of one vector spans no hull, short unit vectors complete it.
  expect_exact({matrix({{2, 1}, {1, 1}})}, largest_zero("x^2-3*x+1"));
  expect_exact({matrix({{0, 1, 0}, {0, 0, 1}, {1, 1, 0}})}, largest_zero("x^3-x-1"));
  expect_exact({matrix({{-3}})}, Rational(3));
  expect_exact({matrix({{Rational(1, 2), 5}, {0, Rational(-2, 3)}})}, Rational(2, 3));
  expect_exact({matrix({{1, 1}, {0, 1}})}, Rational(1));  // products not bounded
  EXPECT_FALSE(radius({matrix({{1, 1}, {0, 1}})}).bounded);
  expect_exact({matrix({{2, 0, 0}, {0, -2, 0}, {0, 0, 1}})}, Rational(2));
  expect_exact({RationalMatrix::identity(4)}, Rational(1));
}

TEST(JsrKnown, SizeOne) {
  expect_exact({matrix({{Rational(1, 3)}}), matrix({{Rational(-7, 5)}}), matrix({{0}})}, Rational(7, 5));
  expect_exact({matrix({{0}}), matrix({{0}})}, Rational(0));
}

TEST(JsrKnown, Nilpotent) {
  expect_exact({matrix({{0, 1}, {0, 0}})}, Rational(0));
  expect_exact({RationalMatrix(3, 3)}, Rational(0));
  // Nilpotent together, though not triangular as they stand: N and N^2 in another basis.
  const RationalMatrix t = matrix({{1, 2, 0}, {0, 1, -1}, {1, 0, 1}});
  const RationalMatrix n = matrix({{0, 1, 4}, {0, 0, -2}, {0, 0, 0}});
  expect_exact({t * n * *t.inverse(), t * (n * n) * *t.inverse()}, Rational(0));
  EXPECT_EQ(radius({t * n * *t.inverse()}).method, "nilpotent");
  // Each nilpotent, not together.
  expect_exact({matrix({{0, 1}, {0, 0}}), matrix({{0, 0}, {1, 0}})}, Rational(1));
  expect_exact({matrix({{0, 4}, {0, 0}}), matrix({{0, 0}, {Rational(1, 3), 0}})}, largest_zero("3*x^2-4"));
}

TEST(JsrKnown, Reducible) {
  // Triangular: the largest modulus on the diagonals.
  expect_exact({matrix({{1, 7, 3}, {0, 2, -5}, {0, 0, Rational(1, 2)}}), matrix({{-3, 1, 1}, {0, 1, 9}, {0, 0, 1}})},
               Rational(3));
  // The golden pair beside a smaller block, both hidden by a change of basis.
  const RationalMatrix a = matrix({{1, 1, 2}, {0, 1, 5}, {0, 0, 1}});
  const RationalMatrix b = matrix({{1, 0, -3}, {1, 1, 1}, {0, 0, -1}});
  const RationalMatrix t = matrix({{1, 1, 0}, {2, 1, 1}, {0, 3, 1}});
  ASSERT_EQ(t.rank(), 3);
  const Family hidden{t * a * *t.inverse(), t * b * *t.inverse()};
  expect_exact(hidden, largest_zero("x^2-x-1"));
  const BlockForm form = block_triangular_form(hidden);
  EXPECT_EQ(form.sizes.size(), 2U);
  EXPECT_EQ(std::max(form.sizes[0], form.sizes[1]), 2);
}

TEST(JsrKnown, BlocksOfTheForm) {
  const RationalMatrix t = matrix({{1, 1, 0, 2}, {2, 1, 1, 0}, {0, 3, 1, 1}, {1, 0, 0, 1}});
  ASSERT_EQ(t.rank(), 4);
  const RationalMatrix a = matrix({{1, 2, 3, 4}, {0, 5, 6, 7}, {0, 8, 9, 1}, {0, 0, 0, 2}});
  const RationalMatrix b = matrix({{3, 0, 1, 1}, {0, 1, 1, -7}, {0, 2, 9, 0}, {0, 0, 0, -2}});
  const Family family{t * a * *t.inverse(), t * b * *t.inverse()};
  const BlockForm form = block_triangular_form(family);
  ASSERT_EQ(form.blocks.size(), form.sizes.size());
  long total = 0;
  const auto inverse = form.basis.inverse();
  ASSERT_TRUE(inverse);
  for (size_t k = 0; k < form.sizes.size(); ++k) {
    const long n = form.sizes[k];
    for (size_t s = 0; s < family.size(); ++s) {
      const RationalMatrix whole = *inverse * family[s] * form.basis;
      EXPECT_EQ(whole.block(total, total, n, n), form.blocks[k][s]);
      EXPECT_TRUE(whole.block(total + n, total, 4 - total - n, n).is_zero());
    }
    total += n;
  }
  EXPECT_EQ(total, 4);
  EXPECT_EQ(*std::max_element(form.sizes.begin(), form.sizes.end()), 2);
}

TEST(JsrKnown, SymmetricMatrices) {
  // The largest norm.
  expect_exact({matrix({{2, 1}, {1, 0}}), matrix({{0, 1}, {1, 1}}), matrix({{-1, 0}, {0, 1}})},
               largest_zero("x^2-2*x-1"));
  // {A, A^T}: sqrt(rho(A^T A)) = |A|_2.
  for (const Rows& rows : {Rows{{1, 2}, {0, 1}}, Rows{{1, -1}, {3, 2}}, Rows{{0, 1, 0}, {2, 0, 1}, {1, 1, 1}}}) {
    const RationalMatrix a = matrix(rows);
    const RealAlgebraic norm = leading_eigenvalues(a.transposed() * a).at(0).root_of_modulus(2);
    expect_exact({a, a.transposed()}, norm);
  }
  // |(1 2; 0 1)|_2 = 1 + sqrt(2)
  expect_exact({matrix({{1, 2}, {0, 1}}), matrix({{1, 0}, {2, 1}})}, largest_zero("x^2-2*x-1"));
}

TEST(JsrKnown, Rotations) {
  // Powers with real leading eigenvalues.
  for (const Rows& rows : {Rows{{0, -1}, {1, 0}}, Rows{{0, -1}, {1, 1}}}) {
    const JsrResult r = radius({matrix(rows)});
    EXPECT_LE(r.lower, Rational(1));
    EXPECT_GE(r.upper, Rational(1));
  }
  // An angle that is no rational multiple of pi: only an enclosure, as narrow as asked.
  const Family turn{matrix({{Rational(3, 5), Rational(-4, 5)}, {Rational(4, 5), Rational(3, 5)}})};
  EXPECT_TRUE(leading_eigenvalues(turn[0]).empty());
  const JsrResult r = radius(turn);
  EXPECT_LE(r.lower, Rational(1));
  EXPECT_GE(r.upper, Rational(1));
  EXPECT_LE(r.upper, r.lower * Rational(1002, 1000));
}

TEST(JsrKnown, Gripenberg) {
  // Gripenberg 1996: 0.6596789 < rho < 0.6596924.
  const Rational fifth(1, 5);
  const Family family{fifth * matrix({{3, 0}, {1, 3}}), fifth * matrix({{3, -3}, {0, -1}})};
  const JsrResult r = radius(family);
  EXPECT_LT(r.lower, Rational::parse("6596924/10000000"));
  EXPECT_GT(r.upper, Rational::parse("6596789/10000000"));
  ASSERT_TRUE(r.exact);
  EXPECT_NEAR(r.exact->estimate(), 0.65967895, 1e-7);
}

TEST(JsrKnown, FourPointScheme) { expect_exact({matrix({{4, 0}, {-1, -1}}), matrix({{-1, -1}, {0, 4}})}, Rational(4)); }

TEST(JsrKnown, EnclosureOnly) {
  JsrOptions options;
  options.enclosure_only = true;
  for (const Family& family :
       {Family{matrix({{1, 1}, {0, 1}}), matrix({{1, 0}, {1, 1}})},
        Family{matrix({{4, 0}, {-1, -1}}), matrix({{-1, -1}, {0, 4}})},
        Family{matrix({{1, 7, 3}, {0, 2, -5}, {0, 0, 1}}), matrix({{-3, 1, 1}, {0, 1, 9}, {0, 0, 1}})}}) {
    const JsrResult exact = radius(family);
    const JsrResult enclosed = radius(family, options);
    ASSERT_TRUE(exact.exact);
    EXPECT_FALSE(enclosed.exact);
    EXPECT_LE(RealAlgebraic::compare(enclosed.lower, *exact.exact), 0);
    EXPECT_LE(RealAlgebraic::compare(*exact.exact, enclosed.upper), 0);
    EXPECT_LE(enclosed.upper, enclosed.lower * Rational(1002, 1000));
  }
}

TEST(JsrKnown, BelowALimit) {
  const Family pair{matrix({{1, 1}, {0, 1}}), matrix({{1, 0}, {1, 1}})};
  for (const Rational& limit : {Rational(2), Rational(17, 10), Rational(162, 100)}) {
    const auto claim = prove_jsr_below(pair, limit, {}, {});
    ASSERT_TRUE(claim);
    EXPECT_LT(Rational::parse((*claim)["bound"].get<std::string>()), limit);
    EXPECT_EQ(check::check_text(certificate_text("matrices", pair, {*claim})).status, check::Report::valid);
  }
  EXPECT_FALSE(prove_jsr_below(pair, Rational(1618, 1000), {}, {}));
  EXPECT_FALSE(prove_jsr_below(pair, Rational(1), {}, {}));
}

TEST(JsrKnown, BoundedProducts) {
  EXPECT_TRUE(prove_bounded({matrix({{0, 1}, {1, 0}}), matrix({{1, 0}, {0, -1}})}, {}));
  EXPECT_FALSE(prove_bounded({matrix({{1, 1}, {0, 1}})}, {}));
  EXPECT_FALSE(prove_bounded({matrix({{1, 1}, {0, 1}}), matrix({{1, 0}, {1, 1}})}, {}));
}

TEST(JsrKnown, LeadingEigenvalues) {
  const auto both = leading_eigenvalues(matrix({{0, 2}, {2, 0}}));
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[0].rational(), Rational(2));
  EXPECT_EQ(both[1].rational(), Rational(-2));
  EXPECT_TRUE(leading_eigenvalues(matrix({{0, -1}, {1, 0}})).empty());
  ASSERT_EQ(leading_eigenvalues(matrix({{-3, 1}, {0, 2}})).size(), 1U);
  EXPECT_EQ(leading_eigenvalues(matrix({{-3, 1}, {0, 2}}))[0].rational(), Rational(-3));
  EXPECT_EQ(leading_eigenvalues(RationalMatrix(2, 2)).at(0).sign(), 0);
}

TEST(JsrKnown, TheFirstLetterActsFirst) {
  const Family f{matrix({{1, 1}, {0, 1}}), matrix({{1, 0}, {1, 1}})};
  EXPECT_EQ(product(f, {0, 1}), f[1] * f[0]);
  EXPECT_EQ(product(f, {}), RationalMatrix::identity(2));
}

// ---- laws

// One to three matrices of size 1 to 4 with small entries, some of them zero.
Family random_family(long most_size = 4, size_t most = 3) {
  const long n = uniform<long>(1, most_size + 1);
  return several(uniform<size_t>(1, most + 1), [n] {
    RationalMatrix a(n, n);
    for (long i = 0; i < n * n; ++i)
      if (uniform(0, 4) != 0) {
        const long numerator = uniform(-3L, 4L);
        a.set(i / n, i % n, Rational(numerator, uniform(1L, 3L)));
      }
    return a;
  });
}

// Quick limits: an enclosure where the polytope does not close soon, nothing where even that fails.
std::optional<JsrResult> quick(const Family& family) {
  JsrOptions options;
  options.width = Rational(1, 20);
  options.vertices = 120;
  options.seconds = 1.5;
  try {
    JsrResult r = joint_spectral_radius(family, {}, options);
    LAW_ASSERT(accepted(family, r));
    LAW_ASSERT(r.lower <= r.upper);
    return r;
  } catch (const Error& e) {
    LAW_ASSERT(e.kind == Error::Kind::undecided);
    return std::nullopt;
  }
}

// c*a, c > 0.
RealAlgebraic scaled(const RealAlgebraic& a, const Rational& c) {
  if (a.sign() == 0) return a;
  // p(x/c), cleared of denominators: each zero times c; the zero nearest to c*a among them by order.
  const fmpz_poly_struct* p = a.polynomial().univariate_view();
  std::vector<Rational> list;
  for (long i = 0; i <= fmpz_poly_degree(p); ++i) list.push_back(Rational(fmpz_poly_get_coeff_ptr(p, i)) * c.pow(-i));
  Rational common = 1;
  for (const auto& q : list) common *= Rational(q.denominator());
  for (auto& q : list) q *= common;
  const auto mine = RealAlgebraic::zeros(a.polynomial());
  const auto theirs = RealAlgebraic::zeros(Polynomial::univariate("x", list));
  for (size_t i = 0; i < mine.size(); ++i)
    if (mine[i] == a) return theirs.at(i);
  throw std::logic_error("not a zero of its own polynomial");
}

// a = b exactly, or the enclosures share a point.
void expect_same(const JsrResult& a, const JsrResult& b) {
  if (a.exact && b.exact) {
    LAW_ASSERT(*a.exact == *b.exact);
  } else if (a.exact || b.exact) {
    const RealAlgebraic& exact = a.exact ? *a.exact : *b.exact;
    const JsrResult& other = a.exact ? b : a;
    LAW_ASSERT(RealAlgebraic::compare(other.lower, exact) <= 0);
    LAW_ASSERT(RealAlgebraic::compare(exact, other.upper) <= 0);
  } else {
    LAW_ASSERT(std::max(a.lower, b.lower) <= std::min(a.upper, b.upper));
  }
}

void same_radius(const Family& a, const Family& b) {
  const auto x = quick(a), y = quick(b);
  if (x && y) expect_same(*x, *y);
}

Family mapped(const Family& family, const std::function<RationalMatrix(const RationalMatrix&)>& f) {
  Family list;
  for (const auto& a : family) list.push_back(f(a));
  return list;
}

LAW(JsrLaws, BetweenSpectralRadiiAndNorms, ()) {
  const Family family = random_family();
  const auto r = quick(family);
  LAW_GIVEN(r.has_value());
  laws::tag(r->exact.has_value() ? "exact" : "enclosed");
  // Row sums of the products of three bound from above.
  Rational most;
  const int k = static_cast<int>(family.size());
  for (int i = 0; i < k * k * k; ++i) {
    const RationalMatrix p = product(family, {i % k, i / k % k, i / k / k});
    for (long row = 0; row < p.rows(); ++row) {
      Rational sum;
      for (long column = 0; column < p.columns(); ++column) sum += abs(p(row, column));
      most = std::max(most, sum);
    }
  }
  LAW_ASSERT(r->lower.pow(3) <= most);
  for (const auto& a : family) {
    const auto leading = leading_eigenvalues(a);
    if (leading.empty() || leading[0].sign() == 0) continue;
    const RealAlgebraic size = leading[0].root_of_modulus(1);
    LAW_ASSERT(RealAlgebraic::compare(size, r->upper) <= 0);
    if (r->exact) LAW_ASSERT(RealAlgebraic::compare(size, *r->exact) <= 0);
  }
}

LAW(JsrLaws, Homogeneous, ()) {
  const Family family = random_family();
  const Rational c(uniform(1L, 9L) * (uniform(0, 2) == 0 ? 1 : -1), uniform(1L, 9L));
  const auto x = quick(family);
  const auto y = quick(mapped(family, [&](const RationalMatrix& a) { return c * a; }));
  LAW_GIVEN(x && y);
  JsrResult z = *x;
  z.lower = z.lower * abs(c);
  z.upper = z.upper * abs(c);
  if (z.exact) z.exact = scaled(*z.exact, abs(c));
  expect_same(z, *y);
}

LAW(JsrLaws, ChangeOfBasis, ()) {
  const Family family = random_family();
  const Family other = random_family();
  const long n = family[0].rows();
  RationalMatrix t = RationalMatrix::identity(n);
  for (long i = 0; i < n; ++i)
    for (long j = 0; j < n; ++j)
      if (i != j) t.set(i, j, other[0](i % other[0].rows(), j % other[0].rows()));
  const auto inverse = t.inverse();
  LAW_GIVEN(inverse.has_value());
  same_radius(family, mapped(family, [&](const RationalMatrix& a) { return *inverse * a * t; }));
}

LAW(JsrLaws, Transposition, ()) {
  const Family family = random_family();
  same_radius(family, mapped(family, [](const RationalMatrix& a) { return a.transposed(); }));
}

LAW(JsrLaws, WhatAddsNothing, ()) {
  const Family family = random_family();
  Family more = family;
  const auto pick = [&] { return family[uniform<size_t>(0, family.size())]; };
  switch (uniform(0, 4)) {
    case 0: more.push_back(pick()); break;
    case 1: more.push_back(Rational(-1) * pick()); break;
    case 2: {
      const Rational t(uniform(0L, 8L), 7);
      more.push_back(t * pick() + (Rational(1) - t) * pick());
      break;
    }
    default: more.push_back(RationalMatrix(family[0].rows(), family[0].rows()));
  }
  if (uniform(0, 2) == 0) std::reverse(more.begin(), more.end());
  same_radius(family, more);
}

LAW(JsrLaws, WordsOfTwo, ()) {
  const Family family = random_family(3, 2);
  Family words;
  for (const auto& a : family)
    for (const auto& b : family) words.push_back(a * b);
  const auto x = quick(family), y = quick(words);
  LAW_GIVEN(x && y);
  if (x->exact && y->exact) {
    if (x->exact->sign() == 0)
      LAW_ASSERT(y->exact->sign() == 0);
    else
      LAW_ASSERT(y->exact->root_of_modulus(2) == *x->exact);
  } else {
    LAW_ASSERT(x->lower.pow(2) <= y->upper);
    LAW_ASSERT(y->lower <= x->upper.pow(2));
  }
}

LAW(JsrLaws, DirectSums, ()) {
  const Family a = random_family(2, 2), b = random_family(2, 2);
  const size_t k = std::min(a.size(), b.size());
  const Family first(a.begin(), a.begin() + static_cast<long>(k)), second(b.begin(), b.begin() + static_cast<long>(k));
  const long n = a[0].rows(), m = b[0].rows();
  Family sum;
  for (size_t s = 0; s < k; ++s) {
    RationalMatrix whole(n + m, n + m);
    for (long i = 0; i < n; ++i)
      for (long j = 0; j < n; ++j) whole.set(i, j, first[s](i, j));
    for (long i = 0; i < m; ++i)
      for (long j = 0; j < m; ++j) whole.set(n + i, n + j, second[s](i, j));
    sum.push_back(whole);
  }
  const auto x = quick(first), y = quick(second), z = quick(sum);
  LAW_GIVEN(x && y && z);
  if (x->exact && y->exact) {
    JsrResult larger = RealAlgebraic::compare(*x->exact, *y->exact) < 0 ? *y : *x;
    expect_same(larger, *z);
  } else {
    LAW_ASSERT(std::max(x->lower, y->lower) <= z->upper);
    LAW_ASSERT(z->lower <= std::max(x->upper, y->upper));
  }
}

}  // namespace
}  // namespace twoscale::analysis
