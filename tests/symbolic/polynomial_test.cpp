// SPDX-License-Identifier: GPL-3.0-or-later
/// Polynomial: ring laws, canonical form, division, factors, homomorphisms, the canonical text of certificates.
#include "twoscale/symbolic/polynomial.hpp"

#include <numeric>
#include <regex>

#include "support/laws.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::tests {
namespace {

using Point = std::vector<std::pair<std::string, Rational>>;
Point point(const Rational& u, const Rational& v, const Rational& w) { return {{"u", u}, {"v", v}, {"w", w}}; }

/// The variables are exactly those that occur in a term, sorted; terms are not zero and descend lexicographically.
void expect_canonical(const Polynomial& p) {
  LAW_ASSERT(std::is_sorted(p.variables().begin(), p.variables().end()));
  std::vector<bool> occurs(p.variables().size(), false);
  std::vector<unsigned long> previous;
  bool first = true;
  p.for_each_term([&](const Rational& c, std::span<const unsigned long> e) {
    LAW_ASSERT(!c.is_zero());
    LAW_ASSERT(e.size() == p.variables().size());
    const std::vector<unsigned long> exponents(e.begin(), e.end());
    for (size_t i = 0; i < e.size(); ++i) occurs[i] = occurs[i] || e[i] > 0;
    LAW_ASSERT((first || exponents < previous));
    previous = exponents;
    first = false;
  });
  LAW_ASSERT(std::find(occurs.begin(), occurs.end(), false) == occurs.end());
}

LAW(PolynomialLaws, Ring, (const Polynomial& a, const Polynomial& b, const Polynomial& c)) {
  LAW_ASSERT((a + b) + c == a + (b + c));
  LAW_ASSERT((a * b) * c == a * (b * c));
  LAW_ASSERT(a * (b + c) == a * b + a * c);
  LAW_ASSERT(a + b == b + a);
  LAW_ASSERT(a * b == b * a);
  LAW_ASSERT(a - b == a + (-b));
  LAW_ASSERT((a - a).is_zero());
  LAW_ASSERT(a * Polynomial(1) == a);
  LAW_ASSERT((a * Polynomial(0)).is_zero());
  LAW_ASSERT(a.pow(3) == a * a * a);
  LAW_ASSERT(a.pow(0).is_one());
}

LAW(PolynomialLaws, CanonicalAfterEveryOperation, (const Polynomial& a, const Polynomial& b)) {
  for (const Polynomial& p : {a, a + b, a - b, a * b, (a + b) - a, (a + b) * (a - b) - a * a, a.derivative("u"),
                              a.substitute("v", b), a.pow(2), -a})
    expect_canonical(p);
  LAW_ASSERT((a + b) - a == b);  // after cancellation the variables of a are gone
  LAW_ASSERT(((a + b) - a).variables() == b.variables());
}

LAW(PolynomialLaws, EvaluationIsAHomomorphism,
    (const Polynomial& a, const Polynomial& b, const Rational& u, const Rational& v, const Rational& w)) {
  const Point at = point(u, v, w);
  LAW_ASSERT((a + b).evaluate(at) == a.evaluate(at) + b.evaluate(at));
  LAW_ASSERT((a * b).evaluate(at) == a.evaluate(at) * b.evaluate(at));
  LAW_ASSERT((-a).evaluate(at) == -a.evaluate(at));
  // Substitution and evaluation commute.
  LAW_ASSERT(a.substitute("v", b).evaluate(at) == a.evaluate(point(u, b.evaluate(at), w)));
}

LAW(PolynomialLaws, SubstitutionIsAHomomorphism, (const Polynomial& a, const Polynomial& b, const Polynomial& c)) {
  LAW_ASSERT((a + b).substitute("u", c) == a.substitute("u", c) + b.substitute("u", c));
  LAW_ASSERT((a * b).substitute("u", c) == a.substitute("u", c) * b.substitute("u", c));
  LAW_ASSERT(a.substitute("u", Polynomial::variable("u")) == a);
}

LAW(PolynomialLaws, DerivativeIsADerivation, (const Polynomial& a, const Polynomial& b)) {
  LAW_ASSERT((a * b).derivative("v") == a.derivative("v") * b + a * b.derivative("v"));
  LAW_ASSERT((a + b).derivative("v") == a.derivative("v") + b.derivative("v"));
  LAW_ASSERT(a.derivative("u").derivative("w") == a.derivative("w").derivative("u"));
}

LAW(PolynomialLaws, QuotientUndoesMultiplication, (const Polynomial& a, const Polynomial& b)) {
  LAW_GIVEN(!b.is_zero());
  const auto q = Polynomial::quotient(a * b, b);
  LAW_ASSERT(q.has_value());
  LAW_ASSERT(*q == a);
  LAW_ASSERT(Polynomial::exact_quotient(a * b, b) == a);
  // A remainder of smaller degree is never lost: a b + 1 is divisible by b only if b is a unit.
  if (!b.is_constant()) {
    LAW_ASSERT(!Polynomial::quotient(a * b + Polynomial(1), b).has_value());
  }
}

LAW(PolynomialLaws, RemoveCountsTheFactor, (const Polynomial& a, const Polynomial& f)) {
  LAW_GIVEN(!a.is_zero() && !f.is_constant());
  const unsigned e = uniform(0U, 4U);
  const auto [rest, count] = (a * f.pow(e)).remove(f);
  LAW_ASSERT(count >= e);
  LAW_ASSERT(rest * f.pow(count) == a * f.pow(e));
  LAW_ASSERT(!Polynomial::quotient(rest, f).has_value());
}

LAW(PolynomialLaws, Factorisation, (const Polynomial& a, const Polynomial& b)) {
  const Polynomial p = a * b;
  LAW_GIVEN(!p.is_zero());
  const auto f = p.factor();
  LAW_ASSERT(f.content.is_integer());
  Polynomial product = Polynomial::constant(f.content.numerator());
  for (size_t i = 0; i < f.factors.size(); ++i) {
    const auto& [g, e] = f.factors[i];
    LAW_ASSERT(e > 0U);
    LAW_ASSERT(g.content() == Rational(1));
    LAW_ASSERT(g.leading_sign() == 1);
    LAW_ASSERT(g.factor().factors.size() == 1U);  // irreducible
    LAW_ASSERT((i == 0 || Polynomial::compare(f.factors[i - 1].first, g) < 0));
    product *= g.pow(e);
  }
  LAW_ASSERT(product == p);
  LAW_ASSERT(abs(f.content) == p.content());  // Gauss's lemma
  LAW_ASSERT(p.content() == a.content() * b.content());
}

LAW(PolynomialLaws, CompareIsATotalOrder, (const Polynomial& a, const Polynomial& b, const Polynomial& c)) {
  LAW_ASSERT(Polynomial::compare(a, b) == -Polynomial::compare(b, a));
  LAW_ASSERT((Polynomial::compare(a, b) == 0) == (a == b));
  if (Polynomial::compare(a, b) < 0 && Polynomial::compare(b, c) < 0) LAW_ASSERT(Polynomial::compare(a, c) < 0);
}

/// The grammar of certificate texts: monomials in canonical order, no blanks, no 1*, no ^1, integer coefficients.
LAW(PolynomialText, FollowsTheCertificateGrammar, (const Polynomial& a, const Polynomial& b)) {
  const Polynomial p = a - b;
  const std::string text = p.to_string();
  if (p.is_zero()) {
    LAW_ASSERT(text == "0");
    return;
  }
  static const std::string power = "[a-z]+(\\^([2-9]|[1-9][0-9]+))?";
  static const std::string monomial = power + "(\\*" + power + ")*";
  static const std::string term = "(([2-9]|[1-9][0-9]+)\\*" + monomial + "|" + monomial + "|[1-9][0-9]*)";
  static const std::regex grammar("-?" + term + "([+-]" + term + ")*");
  LAW_ASSERT(std::regex_match(text, grammar));
  // Read back by the expression reader, which knows nothing of the order.
  LAW_ASSERT(parse_rational_function(text) == RationalFunction(p));
  LAW_ASSERT(parse_rational_function(p.pretty()) == RationalFunction(p));
  std::string blanks;
  for (const char c : p.pretty())
    if (c != ' ') blanks += c;
  LAW_ASSERT(blanks == text);
}

TEST(PolynomialText, Examples) {
  const Polynomial v = Polynomial::variable("v");
  const Polynomial s = Polynomial::variable("v_s");
  const Polynomial t = Polynomial::variable("v_t");
  EXPECT_EQ((Polynomial(64) * v.pow(3) + Polynomial(128) * v * v + Polynomial(64) * v).to_string(),
            "64*v^3+128*v^2+64*v");
  EXPECT_EQ((Polynomial(3) * s * s * t - Polynomial(1)).to_string(), "3*v_s^2*v_t-1");
  EXPECT_EQ((t.pow(5) + s).to_string(), "v_s+v_t^5");  // lexicographic, not by degree
  EXPECT_EQ((-v).to_string(), "-v");
  EXPECT_EQ((-v * v + Polynomial(1)).to_string(), "-v^2+1");
  EXPECT_EQ(Polynomial(0).to_string(), "0");
  EXPECT_EQ(Polynomial(-7).to_string(), "-7");
  EXPECT_EQ((-v * v + Polynomial(1)).pretty(), "-v^2 + 1");
  EXPECT_EQ((Polynomial(3) * s * s * t).pretty(Polynomial::Style::latex), "3 v_{s}^{2} v_{t}");
}

TEST(Polynomial, Degrees) {
  const Polynomial u = Polynomial::variable("u");
  const Polynomial v = Polynomial::variable("v");
  const Polynomial p = u.pow(2) * v + v.pow(5);
  EXPECT_EQ(p.degree("u"), 2);
  EXPECT_EQ(p.degree("v"), 5);
  EXPECT_EQ(p.degree("w"), 0);
  EXPECT_EQ(p.total_degree(), 5);
  EXPECT_EQ(p.terms(), 2);
  EXPECT_EQ(Polynomial(0).degree("u"), -1);
  EXPECT_EQ(Polynomial(0).leading_sign(), 0);
  EXPECT_TRUE(p.all_coefficients_nonnegative());
  EXPECT_FALSE((p - u).all_coefficients_nonnegative());
  EXPECT_TRUE(Polynomial(0).all_coefficients_nonnegative());
}

TEST(Polynomial, MisuseIsLoud) {
  const Polynomial v = Polynomial::variable("v");
  EXPECT_THROW(Polynomial::quotient(v, 0), std::logic_error);
  EXPECT_THROW(Polynomial::exact_quotient(v + Polynomial(1), v), std::logic_error);
  EXPECT_THROW(v.constant_value(), std::logic_error);
  EXPECT_THROW(v.evaluate({{"u", 1}}), std::logic_error);
  EXPECT_THROW(Polynomial(0).factor(), std::logic_error);
  EXPECT_THROW(Polynomial::univariate("v", std::vector<Rational>{Rational(1, 2)}), std::logic_error);
}

// ---- Chebyshev polynomials and minimal polynomials of cosines

TEST(Chebyshev, RecurrenceAndComposition) {
  const Polynomial v = Polynomial::variable("v");
  std::vector<Polynomial> t;
  for (unsigned n = 0; n <= 24; ++n) t.push_back(Polynomial::chebyshev("v", n));
  EXPECT_TRUE(t[0].is_one());
  EXPECT_EQ(t[1], v);
  for (unsigned n = 2; n <= 24; ++n) EXPECT_EQ(t[n], Polynomial(2) * v * t[n - 1] - t[n - 2]);
  for (unsigned a = 0; a <= 6; ++a)
    for (unsigned b = 0; b <= a; ++b) {
      EXPECT_EQ(Polynomial(2) * t[a] * t[b], t[a + b] + t[a - b]);
      if (a * b <= 24) {
        EXPECT_EQ(t[a].substitute("v", t[b]), t[a * b]);
      }
    }
}

TEST(Chebyshev, IsCoshOfMultiples) {
  for (const Rational& e : {Rational(2), Rational(-3, 7), Rational(11, 5)})
    for (unsigned n = 0; n < 12; ++n)
      EXPECT_EQ(Polynomial::chebyshev("v", n).evaluate({{"v", (e + e.inverse()) / Rational(2)}}),
                (e.pow(static_cast<long>(n)) + e.pow(-static_cast<long>(n))) / Rational(2));
}

unsigned totient(unsigned n) {
  unsigned count = 0;
  for (unsigned i = 1; i <= n; ++i) count += std::gcd(i, n) == 1 ? 1 : 0;
  return count;
}

TEST(CosineMinimal, VanishesAtTheCosineAndIsMinimal) {
  for (unsigned d = 1; d <= 40; ++d) {
    const Polynomial p = Polynomial::cosine_minimal("v", d);
    EXPECT_EQ(p.content(), Rational(1)) << d;
    EXPECT_EQ(p.leading_sign(), 1) << d;
    EXPECT_EQ(p.total_degree(), d <= 2 ? 1 : static_cast<long>(totient(d) / 2)) << d;
    EXPECT_EQ(p.factor().factors.size(), 1U) << d;
    // Exactly: cos(2 pi/d) is a zero iff p divides T_d - 1 and p divides no T_e - 1 with e < d.
    EXPECT_TRUE(Polynomial::quotient(Polynomial::chebyshev("v", d) - Polynomial(1), p).has_value()) << d;
    for (unsigned e = 1; e < d; ++e)
      EXPECT_FALSE(Polynomial::quotient(Polynomial::chebyshev("v", e) - Polynomial(1), p).has_value()) << d << " " << e;
  }
  EXPECT_EQ(Polynomial::cosine_minimal("v", 1).to_string(), "v-1");
  EXPECT_EQ(Polynomial::cosine_minimal("v", 2).to_string(), "v+1");
  EXPECT_EQ(Polynomial::cosine_minimal("v", 3).to_string(), "2*v+1");
  EXPECT_EQ(Polynomial::cosine_minimal("v", 4).to_string(), "v");
  EXPECT_EQ(Polynomial::cosine_minimal("v", 5).to_string(), "4*v^2+2*v-1");
}

TEST(CosineMinimal, EnclosesZeroAtTheCosine) {
  for (unsigned d : {7U, 9U, 15U, 36U}) {
    const std::string text = Polynomial::cosine_minimal("c", d).to_string();
    std::string at;
    for (const char c : text) at += c == 'c' ? "cos(2*pi/" + std::to_string(d) + ")" : std::string(1, c);
    EXPECT_EQ(parse_real(at).sign(), Sign::zero) << at;
  }
}

TEST(CosineMinimal, ProductOverDivisorsIsChebyshev) {
  // T_n - 1 = 2^{n-1} prod_{j<n} (v - cos(2 pi j/n)): every pair of conjugates counts twice, 1 and -1 once.
  for (unsigned n = 1; n <= 36; ++n) {
    Polynomial product = 1;
    for (unsigned d = 1; d <= n; ++d)
      if (n % d == 0) product *= Polynomial::cosine_minimal("v", d).pow(d <= 2 ? 1 : 2);
    const auto ratio = Polynomial::quotient(Polynomial::chebyshev("v", n) - Polynomial(1), product);
    ASSERT_TRUE(ratio.has_value()) << n;
    EXPECT_TRUE(ratio->is_constant()) << n;
  }
}

}  // namespace
}  // namespace twoscale::tests
