// SPDX-License-Identifier: GPL-3.0-or-later
/// Junctions of schemes on knots: what is true of nuli4, nuli6 and the Lagrange rule for all knots and edge parameters.
#include "twoscale/analysis/knots.hpp"

#include <gtest/gtest.h>

#include <cctype>

#include "twoscale/analysis/regularity.hpp"
#include "twoscale/analysis/spectrum.hpp"
#include "twoscale/check/check.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::analysis {
namespace {

RationalFunction f(const char* text) { return parse_rational_function(text); }

std::vector<Rational> cleared(std::vector<Rational> c) {
  Rational g;
  for (const auto& x : c) g = gcd(g, x);
  for (auto& x : c) x /= g;
  return c;
}

std::vector<Claim> continuity(const char* l) { return {{"continuity", l, ""}}; }

/// nuli (3.8) for all alpha and both edge parameters: 1, 1/2, 1/4, -1/16 twice, and the roots of
///   8(1+a) z^2 - (2a(p + 2r) + 2(2p + r)) z + (1+a) p r,  p = w(lambda_{-1}), r = 1 - w(lambda_0),
/// where w is the blend of nulifs.hpp; on every piece.
TEST(Junction, CharacteristicPolynomialOfTheFourPointScheme) {
  const Scheme s = make_scheme("nuli4");
  const RationalFunction a = f("a"), l = f("l"), m = f("m");
  for (const bool upper_l : {false, true})
    for (const bool upper_m : {false, true}) {
      const auto blend = [](const RationalFunction& x, bool upper) {
        return upper ? RationalFunction(1) - (RationalFunction(1) - x) / (RationalFunction(2) * x)
                     : x / (RationalFunction(2) * (RationalFunction(1) - x));
      };
      const RationalFunction p = blend(l, upper_l), r = RationalFunction(1) - blend(m, upper_m);
      const Junction j =
          junction(s, a, l, m, {{"a", 1}, {"l", Rational(upper_l ? 3 : 1, 4)}, {"m", Rational(upper_m ? 3 : 1, 4)}});
      EXPECT_EQ(j.order, 3);
      ASSERT_EQ(j.matrix.entries.rows(), 7U);
      const RationalFunction one(1), two(2), eight(8);
      const std::vector<RationalFunction> quadratic = {
          p * r / eight, -(two * a * (p + two * r) + two * (two * p + r)) / (eight * (one + a)), one};
      std::vector<RationalFunction> expected{1};
      const auto times = [&](const std::vector<RationalFunction>& factor) {
        std::vector<RationalFunction> product(expected.size() + factor.size() - 1);
        for (size_t i = 0; i < expected.size(); ++i)
          for (size_t k = 0; k < factor.size(); ++k) product[i + k] += expected[i] * factor[k];
        expected = product;
      };
      times({-1, 1});
      times({Rational(-1, 2), 1});
      times({Rational(-1, 4), 1});
      times({Rational(1, 16), 1});
      times({Rational(1, 16), 1});
      times(quadratic);
      EXPECT_EQ(characteristic_polynomial(j.matrix.entries), expected);
    }
}

/// The eigenvalues of the divided differences are those that are not 2^{-n}.
TEST(Junction, DividedDifferencesCarryTheOtherEigenvalues) {
  for (const char* name : {"nuli4", "nuli6", "lagrange4"}) {
    const Junction j = junction(make_scheme(name), Rational(3, 7), Rational(2, 5), Rational(4, 5));
    std::vector<RationalFunction> p = characteristic_polynomial(divided_difference_matrix(j));
    for (long n = 0; n < j.order; ++n) {
      std::vector<RationalFunction> product(p.size() + 1);
      for (size_t i = 0; i < p.size(); ++i) {
        product[i + 1] += p[i];
        product[i] -= RationalFunction(Rational(2).pow(-n)) * p[i];
      }
      p = product;
    }
    EXPECT_EQ(p, characteristic_polynomial(j.matrix.entries)) << name;
  }
}

/// Proposition 3.3: at the crease 1/2 is double with two eigenvectors.
TEST(Junction, CreaseOfTheFourPointScheme) {
  const Spectrum s = spectrum(junction(make_scheme("nuli4"), Rational(5, 2), 1, 0));
  for (const auto& factor : s.factors)
    if (factor.degree() == 1 && factor.polynomial[0] == RationalFunction(Rational(-1, 2))) {
      EXPECT_EQ(factor.multiplicity, 2U);
      EXPECT_EQ(factor.geometric, 2U);
    }
  EXPECT_EQ(s.necessary.order, 0);
}

TEST(Knots, FourPointSchemesAreC1) {
  for (const char* name : {"nuli4", "lagrange4"}) {
    const Proof proof = prove_on_knots(make_scheme(name), continuity("1"));
    const Decision& d = proof.decisions[0];
    EXPECT_EQ(d.verdict, Verdict::proved) << d.witness;
    EXPECT_EQ(check::check_text(proof.certificate).status, check::Report::valid);
    // The crease is the only exception.
    EXPECT_EQ(d.exceptions.size(), std::string(name) == "nuli4" ? 1U : 0U);
    EXPECT_EQ(prove_on_knots(make_scheme(name), continuity("2")).decisions[0].verdict, Verdict::refuted);
  }
}

TEST(Knots, Support) {
  const auto verdict = [](const char* name, const char* support) {
    const Proof p = prove_on_knots(make_scheme(name), {{"support", support, ""}});
    if (p.decisions[0].verdict == Verdict::proved) {
      EXPECT_EQ(check::check_text(p.certificate).status, check::Report::valid);
    }
    return p.decisions[0].verdict;
  };
  EXPECT_EQ(verdict("nuli4", "-3..3"), Verdict::proved);
  EXPECT_EQ(verdict("nuli4", "-2..3"), Verdict::refuted);
  EXPECT_EQ(verdict("nuli6", "-5..5"), Verdict::proved);
  EXPECT_EQ(verdict("lagrange4", "-3..3"), Verdict::proved);
}

TEST(Knots, Precision) {
  const auto verdict = [](const char* name, const char* space) {
    return prove_on_knots(make_scheme(name), {{"reproduces", space, ""}}).decisions[0].verdict;
  };
  EXPECT_EQ(verdict("nuli4", "1, x, x^2"), Verdict::proved);
  EXPECT_EQ(verdict("nuli4", "1, x, x^2, x^3"), Verdict::refuted);
  EXPECT_EQ(verdict("nuli6", "1, x, x^2, x^3"), Verdict::proved);
  EXPECT_EQ(verdict("nuli6", "1, x, x^2, x^3, x^4"), Verdict::refuted);
  EXPECT_EQ(verdict("lagrange4", "1, x, x^2, x^3"), Verdict::proved);
}

/// A wrong rule is found out: the certificate of another scheme's junction is no certificate, and a changed weight
/// changes the verdict.
TEST(Knots, AChangedRuleIsRefused) {
  Scheme s = make_scheme("lagrange4");
  auto& odd = s.phases[1].blocks;
  odd[0][0] += Rational(1, 1000);
  odd[1][0] -= Rational(1, 1000);
  EXPECT_EQ(prove_on_knots(s, {{"reproduces", "1, x", ""}}).decisions[0].verdict, Verdict::refuted);
  EXPECT_NE(prove_on_knots(s, continuity("1")).decisions[0].verdict, Verdict::proved);
}

std::string sealed_again(const std::string& text) {
  return check::sealed(text.substr(0, text.rfind("\"digest\": \"")) + "\"digest\": \"\"\n}\n");
}

/// The places of the digits between two pieces of a text.
std::vector<size_t> digits_between(const std::string& text, const std::string& from, const std::string& to) {
  std::vector<size_t> places;
  for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + 1)) {
    const size_t end = text.find(to, at);
    for (size_t i = at + from.size(); i < end; ++i)
      if (std::isdigit(static_cast<unsigned char>(text[i])) != 0) places.push_back(i);
  }
  return places;
}

/// The certificate is about the rule that it holds: every number of the rule, of the precision, of the edge parameters
/// and of the characteristic polynomials matters.
TEST(Knots, CertificatesAreBoundToTheRule) {
  const Scheme s = make_scheme("nuli4");
  const std::string text = prove_on_knots(s, s.claims).certificate;
  ASSERT_EQ(check::check_text(text).status, check::Report::valid);
  std::vector<size_t> places = digits_between(text, "\"knots\": {", "\"claims\"");
  ASSERT_GT(places.size(), 100U);
  for (const auto& [from, to] :
       {std::pair("\"degree\": ", ","), std::pair("\"support\": [", "]"), std::pair("\"left\": ", ","),
        std::pair("\"right\": ", ","), std::pair("\"kept\": ", ","), std::pair("\"multiplicity\": ", ","),
        std::pair("\"sum_rules\": ", ","), std::pair("*z^2", ",")}) {
    const auto more = digits_between(text, from, to);
    EXPECT_FALSE(more.empty()) << from;
    places.insert(places.end(), more.begin(), more.end());
  }
  for (const size_t at : places) {
    std::string changed = text;
    changed[at] = changed[at] == '9' ? '1' : static_cast<char>(changed[at] + 1);
    EXPECT_NE(check::check_text(sealed_again(changed)).status, check::Report::valid)
        << text.substr(at < 60 ? 0 : at - 60, 80) << " -> " << changed[at];
  }
  // The boxes cover all edge parameters but the crease: not without one of them, not with a smaller one, nor the
  // crease.
  ASSERT_NE(text.find("\"parameters\": \"all-but-crease\""), std::string::npos);
  const auto replaced = [&](size_t at, size_t length, const std::string& by) {
    std::string changed = text;
    return check::check_text(sealed_again(changed.replace(at, length, by)));
  };
  const auto holes = [](const check::Report& r) {
    return r.status == check::Report::invalid && r.message.find("do not cover") != std::string::npos;
  };
  EXPECT_TRUE(holes(replaced(text.find("all-but-crease"), 14, "all")));
  EXPECT_EQ(replaced(text.find("all-but-crease"), 14, "claims").status, check::Report::valid);
  EXPECT_NE(replaced(text.find("all-but-crease"), 14, "most").status, check::Report::valid);
  size_t boxes = 0, uncovered = 0;
  for (size_t at = text.find("\"box\""); at != std::string::npos; at = text.find("\"box\"", at + 1)) {
    ++boxes;
    const size_t from = text.rfind("\n  {\n", at), half = text.find("\"1/2\"", at);
    EXPECT_TRUE(holes(replaced(from, text.find("\n  },", at) + 5 - from, ""))) << boxes;
    const bool upper = text.find(']', half) < text.find(',', half);
    const check::Report smaller = replaced(half, 5, upper ? "\"2/5\"" : "\"3/5\"");
    EXPECT_NE(smaller.status, check::Report::valid) << boxes;
    uncovered += holes(smaller) ? 1 : 0;
  }
  EXPECT_EQ(boxes, 5U);
  EXPECT_GT(uncovered, 0U);
  // A claim that is left out takes the conclusion with it.
  for (const std::string claim : {"knots-reproduces", "nonnegative-symbol"}) {
    std::string without = text;
    for (size_t at = without.find("\"claim\": \"" + claim + "\""); at != std::string::npos;
         at = without.find("\"claim\": \"" + claim + "\"")) {
      const size_t from = without.rfind("\n  {\n", at);
      without.erase(from, without.find("\n  },", at) + 5 - from);
    }
    EXPECT_EQ(check::check_text(sealed_again(without)).status, check::Report::invalid) << claim;
  }
}

/// nuli6 is C^2 exactly where a polynomial is positive: the certificate says so, and shows a counterexample.
TEST(KnotsSlow, CertificateOfTheSixPointScheme) {
  const Scheme s = make_scheme("nuli6");
  const std::string text = prove_on_knots(s, s.claims).certificate;
  const check::Report report = check::check_text(text);
  ASSERT_EQ(report.status, check::Report::valid) << report.message;
  EXPECT_NE(text.find("\"restriction\""), std::string::npos);
  // The restriction is derived, not believed; nor is the counterexample.
  std::string changed = text;
  const size_t at = text.find("\"tree\": \"", text.find("\"restriction\"")) + 9;
  changed[at] = changed[at] == '1' ? '2' : '1';
  EXPECT_NE(check::check_text(sealed_again(changed)).status, check::Report::valid);
  changed = text;
  changed.replace(changed.find("\"left\": \"3/4\""), 13, "\"left\": \"2/4\"");
  EXPECT_NE(check::check_text(sealed_again(changed)).status, check::Report::valid);
  changed = text;
  changed.replace(changed.find("\"left\": \"3/4\""), 13, "\"left\": \"1/2\"");
  EXPECT_EQ(check::check_text(sealed_again(changed)).status, check::Report::invalid);
}

/// All eigenvalues that are not 2^{-n}, n < 4, at rational parameters.
bool eigenvalues_inside(const Scheme& s, const Rational& alpha, const Rational& left, const Rational& right,
                        const Rational& radius) {
  const auto m = constant(divided_difference_matrix(junction(s, alpha, left, right)));
  return roots_inside(Polynomial::univariate("z", cleared(characteristic_polynomial(*m))), radius);
}

/// The 6-point scheme is not C^2 for all edge parameters, as its source says.
TEST(Knots, SixPointSchemeHasCounterexamples) {
  const Scheme s = make_scheme("nuli6");
  const Rational quarter(1, 4);
  EXPECT_TRUE(eigenvalues_inside(s, 1, Rational(1, 2), Rational(1, 2), quarter));
  EXPECT_FALSE(eigenvalues_inside(s, 1, Rational(3, 4), Rational(1, 8), quarter));
  EXPECT_FALSE(eigenvalues_inside(s, 5, 1, 0, quarter));
  EXPECT_TRUE(eigenvalues_inside(s, 5, 1, 0, Rational(1, 2)));
}

TEST(Knots, UniformMembers) {
  EXPECT_EQ(symbol(uniform_member(make_scheme("nuli4"))), symbol(make_scheme("dd:l=2")));
  EXPECT_EQ(symbol(uniform_member(make_scheme("lagrange4"))), symbol(make_scheme("dd:l=2")));
  const Regularity r = regularity(uniform_member(make_scheme("nuli6")), {});
  EXPECT_EQ(r.continuity, 2);
}

/// All knots and edge parameters of the 6-point scheme: C^1 everywhere; C^2 exactly where one polynomial is positive.
TEST(KnotsSlow, SixPointScheme) {
  const Scheme s = make_scheme("nuli6");
  const JunctionVerdict c1 = decide_junction(s, 1);
  EXPECT_EQ(c1.decision.verdict, Verdict::proved) << c1.decision.witness;
  EXPECT_TRUE(c1.decision.exceptions.empty());
  const JunctionVerdict c2 = decide_junction(s, 2);
  EXPECT_EQ(c2.decision.verdict, Verdict::refuted);
  size_t outside = 0;
  for (const JunctionCase& c : c2.cases) {
    bool proved = true;
    for (const auto& b : c.bounds) proved = proved && b.verdict == Verdict::proved;
    if (proved) {
      ++outside;
      continue;
    }
    ASSERT_TRUE(c.boundary.has_value()) << c.domain;  // all other conditions hold: the boundary is exact
    if (!c.chart) continue;
    // The sign of the boundary polynomial decides, at points of the corner k, q <= 1/2.
    for (const long k : {1L, 3L, 5L})
      for (const long q : {1L, 4L})
        for (const Rational& alpha : {Rational(1, 9), Rational(1), Rational(4)}) {
          const bool inside =
              c.boundary->evaluate({{"alpha", alpha}, {"k", Rational(k, 10)}, {"q", Rational(q, 10)}}).sign() > 0;
          EXPECT_EQ(eigenvalues_inside(s, alpha, Rational(1) - Rational(k, 10), Rational(q, 10), Rational(1, 4)),
                    inside)
              << k << " " << q << " " << alpha.to_string();
        }
  }
  EXPECT_EQ(outside, 3U);
}

}  // namespace
}  // namespace twoscale::analysis
