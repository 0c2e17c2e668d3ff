// SPDX-License-Identifier: GPL-3.0-or-later
// What `prove` says is true: every claim of every catalog entry, refutations by hand, agreement with a brute-force
// step, and every certificate is accepted by the independent checker.
#include "twoscale/analysis/prove.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "twoscale/check/check.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::analysis {
namespace {

Decision decide(const std::string& scheme, const std::string& claim, const std::string& subject = "") {
  const Proof proof = prove(make_scheme(scheme), {{claim, subject, ""}});
  if (!proof.certificate.empty()) {
    const check::Report report = check::check_text(proof.certificate);
    EXPECT_EQ(report.status, check::Report::valid) << scheme << ": " << claim << "\n" << report.message;
  }
  return proof.decisions.at(0);
}

void expect(Verdict v, const std::string& scheme, const std::string& claim, const std::string& subject = "") {
  const Decision d = decide(scheme, claim, subject);
  EXPECT_EQ(to_string(d.verdict), to_string(v)) << scheme << ": " << claim << " {" << subject << "}\n" << d.witness;
  EXPECT_EQ(d.verdict == Verdict::proved, d.witness.empty());
}

std::vector<std::string> all_examples() {
  std::vector<std::string> names;
  for (const auto& e : catalog()) names.insert(names.end(), e.examples.begin(), e.examples.end());
  return names;
}

// What a source says and what is not so: scheme, claim, subject. The reason is the refutation's own.
const std::vector<std::array<std::string, 3>> wrong_at_the_source = {
    {"nuli6", "continuity", "2"},                 // nuli section 4; docs/nonuniform.md
    {"hermite-circle:w=1/2", "continuity", "2"},  // hermite2010 section 4; reports/hermite2010/tension.md
};

class Catalog : public testing::TestWithParam<std::string> {};

TEST_P(Catalog, ClaimsOfTheSourceAreProvedAndRecheck) {
  const Scheme s = make_scheme(GetParam());
  const Proof proof = prove(s, default_claims(s));
  for (const auto& d : proof.decisions) {
    const bool wrong = std::find(wrong_at_the_source.begin(), wrong_at_the_source.end(),
                                 std::array{s.id, d.claim, d.subject}) != wrong_at_the_source.end();
    EXPECT_EQ(to_string(d.verdict), wrong ? "refuted" : "proved") << d.claim << " {" << d.subject << "}: " << d.witness;
  }
  const check::Report report = check::check_text(proof.certificate);
  EXPECT_EQ(report.status, check::Report::valid) << report.message;
  EXPECT_EQ(prove(s, default_claims(s)).certificate, proof.certificate) << "not deterministic";
}

INSTANTIATE_TEST_SUITE_P(Examples, Catalog, testing::ValuesIn(all_examples()), [](const auto& instance) {
  std::string name = std::to_string(instance.index) + "_" + instance.param;
  for (auto& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
});

TEST(Refutation, ApproximatingSchemesDoNotReproduceTheirSpace) {
  expect(Verdict::refuted, "bspline:n=3", "reproduces", "1, x, x^2");
  expect(Verdict::proved, "bspline:n=3", "reproduces", "1, x");
  expect(Verdict::refuted, "mixed:n=1", "reproduces", "1, x, exp(t*x), exp(-t*x)");
  expect(Verdict::refuted, "harmonic:n=2", "reproduces", "exp(t*x), exp(-t*x)");
  expect(Verdict::refuted, "bspline:n=3", "interpolatory");
}

TEST(Refutation, OneDegreeTooMany) {
  for (const int l : {1, 2, 3, 4}) {
    std::string space = "1";
    for (int r = 1; r <= 2 * l; ++r) {
      const std::string x = r == 1 ? ", x" : ", x^" + std::to_string(r);
      if (r < 2 * l) space += x;
      if (r == 2 * l) {
        expect(Verdict::proved, "dd:l=" + std::to_string(l), "reproduces", space);
        expect(Verdict::refuted, "dd:l=" + std::to_string(l), "reproduces", space + x);
        expect(Verdict::refuted, "dd:l=" + std::to_string(l), "sum-rules", std::to_string(2 * l + 1));
      }
    }
  }
}

TEST(Refutation, TheWrongFrequency) {
  expect(Verdict::refuted, "tension4", "reproduces", "exp(2*t*x), exp(-2*t*x)");
  expect(Verdict::refuted, "tension4", "reproduces", "exp(t*x/2), exp(-t*x/2)");
  expect(Verdict::refuted, "tension4", "reproduces", "exp(s*x), exp(-s*x)");
  expect(Verdict::refuted, "tension4", "reproduces", "1, x, x^2");
  expect(Verdict::refuted, "tension4", "generates", "x*exp(t*x), exp(t*x), exp(-t*x), x*exp(-t*x)");
  // Cosines of the same frequency are the imaginary t of the same identity, under a name of their own.
  expect(Verdict::refuted, "tension4", "reproduces", "cos(t*x), sin(t*x)");
}

TEST(Refutation, OneWrongCoefficient) {
  expect(Verdict::proved, "mask:coefficients=\"-1/16,0,9/16,1,9/16,0,-1/16\",lowest=-3", "reproduces", "1,x,x^2,x^3");
  expect(Verdict::refuted, "mask:coefficients=\"-1/16,0,9/16,1,9/16,0,-1/15\",lowest=-3", "reproduces", "1");
  expect(Verdict::refuted, "mask:coefficients=\"-1/16,0,9/16,1,9/16,0,-1/15\",lowest=-3", "symmetric");
  expect(Verdict::refuted, "mask:coefficients=\"-1/16,0,9/16,1,9/16,1/9,-1/16\",lowest=-3", "interpolatory");
}

TEST(Maximal, WhatIsLeftOutIsNamed) {
  const Decision d = decide("mixed:n=1", "maximal", "1, x");
  EXPECT_EQ(d.verdict, Verdict::refuted);
  EXPECT_NE(d.witness.find("exp(t*x)"), std::string::npos) << d.witness;
  EXPECT_NE(decide("dd:l=2", "maximal", "1, x").witness.find("x^2, x^3"), std::string::npos);
  expect(Verdict::refuted, "dd:l=2", "maximal", "1, x, exp(t*x), exp(-t*x)");
}

TEST(Maximal, ExceptionalParameterOfTheFourPointScheme) {
  const Decision d = decide("mask:coefficients=\"-w,0,1/2+w,1,1/2+w,0,-w\",lowest=-3", "maximal", "1, x");
  EXPECT_EQ(d.verdict, Verdict::proved);
  EXPECT_EQ(d.exceptions, std::vector<std::string>{"16*w - 1 = 0"});
}

TEST(WellDefined, ExceptionsWithTheirLevels) {
  EXPECT_EQ(decide("interpolating:family=harmonic,l=3", "well-defined").exceptions,
            (std::vector<std::string>{"v0 = -1/2 (level 0)", "v0 = 0 (level 0)"}));
  EXPECT_TRUE(decide("interpolating:family=mixed,l=5", "well-defined").exceptions.empty());
  // {1, x, e^{+-it}, e^{+-3it}}: v^0 = -1/2 fails at level 0 and, from another factor, at level 1.
  EXPECT_EQ(decide("interpolating:space=\"1,x,cos(t*x),sin(t*x),cos(3*t*x),sin(3*t*x)\"", "well-defined").exceptions,
            (std::vector<std::string>{"v0 = -1/2 (level 0)", "v0 = -1/2 (level 1)", "v0 = 0 (level 0)",
                                      "v0 = 1/2 (level 0)"}));
}

TEST(Claims, UnknownOnesAreBadInput) {
  const Scheme s = make_scheme("dd:l=2");
  EXPECT_THROW(prove(s, {{"smooth", "", ""}}), Error);
  EXPECT_THROW(prove(s, {{"reproduces", "1, exp(t*x)", ""}}), Error);
  EXPECT_THROW(prove(s, {{"sum-rules", "x", ""}}), Error);
  EXPECT_THROW(prove(s, {{"symmetric", "1", ""}}), Error);
}

// Applies one step of a stationary mask to samples of x^r and compares with x^r on the finer grid.
bool reproduces_by_brute_force(const Scheme& s, unsigned degree) {
  const Laurent a = symbol(s);
  const Rational m(s.arity);
  for (unsigned r = 0; r <= degree; ++r)
    for (long i = 0; i < s.arity * 3; ++i) {
      Rational value;
      for (long j = -40; j <= 40; ++j) {
        const auto c = a.coefficient(i - s.arity * j).constant();
        value += *c * (Rational(j) + s.shift).pow(r);
      }
      if (value != ((Rational(i) + s.shift) / m).pow(r)) return false;
    }
  return true;
}

TEST(BruteForce, PolynomialReproductionAgrees) {
  for (const std::string scheme :
       {"dd:l=2", "dd:l=3", "bspline:n=1", "bspline:n=2", "bspline:n=3", "bspline:n=4", "bspline:n=2,arity=3",
        "bspline:n=3,arity=3", "bspline:n=3,arity=4", "mask:coefficients=\"1/4,3/4,3/4,1/4\"",
        "mask:coefficients=\"-1/32,-1/32,9/32,25/32,25/32,9/32,-1/32,-1/32\"",
        "mask:coefficients=\"1/4,1/2,1/3,1/2,5/12\"", "mask:arity=3,coefficients=\"1/3,2/3,1,2/3,1/3\""}) {
    const Scheme s = make_scheme(scheme);
    std::string space;
    for (unsigned r = 0; r <= 5; ++r) {
      space += (r == 0 ? "1" : ", x^" + std::to_string(r));
      const Decision d = decide(scheme, "reproduces", space);
      EXPECT_EQ(d.verdict == Verdict::proved, reproduces_by_brute_force(s, r))
          << scheme << " degree " << r << " " << d.witness;
    }
  }
}

}  // namespace
}  // namespace twoscale::analysis
