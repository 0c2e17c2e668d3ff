// SPDX-License-Identifier: GPL-3.0-or-later
/// Level parameters: which relations are frequencies in disguise, which have a limit, and which are refused.
#include "twoscale/symbolic/level_relation.hpp"

#include <gtest/gtest.h>

#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::tests {
namespace {

LevelRelation relation(const std::string& p, int arity, const std::string& domain = "") {
  std::optional<Domain> d;
  if (!domain.empty()) d = Domain::parse(domain);
  return level_relation("g", parse_rational_function(p), arity, d);
}

std::string refusal(const std::string& p, int arity, const std::string& domain = "") {
  try {
    relation(p, arity, domain);
    return "accepted";
  } catch (const Error& e) {
    EXPECT_EQ(e.kind, Error::Kind::bad_input);
    return e.what();
  }
}

/// P(scale v + offset) = scale R(v) + offset, and R(1) = 1.
void expect_conjugate(const std::string& p, const LevelRelation& r) {
  const RationalFunction x = RationalFunction::variable("x");
  const RationalFunction g = RationalFunction(r.spelling.scale) * x + RationalFunction(r.spelling.offset);
  EXPECT_EQ(parse_rational_function(p).substitute("g", g),
            RationalFunction(r.spelling.scale) * r.polynomial + RationalFunction(r.spelling.offset))
      << p;
  EXPECT_EQ(r.polynomial.evaluate({{"x", 1}}), Rational(1)) << p;
}

TEST(LevelRelation, FrequenciesInDisguise) {
  struct Case {
    const char* p;
    int arity;
    Rational scale, offset;
  };
  for (const auto& c : {Case{"2*g^2-1", 2, 1, 0}, Case{"g^2-2", 2, 2, 0}, Case{"2*g*(2+g)", 2, 1, -1},
                        Case{"-2*g^2+1", 2, -1, 0}, Case{"4*g^3-3*g", 3, 1, 0}, Case{"g^3-3*g", 3, 2, 0},
                        Case{"8*g^4-8*g^2+1", 4, 1, 0}, Case{"g*(g^2+6*g+9)", 3, 2, -2}}) {
    const LevelRelation r = relation(c.p, c.arity);
    EXPECT_TRUE(r.frequency) << c.p;
    EXPECT_EQ(r.spelling.scale, c.scale) << c.p;
    EXPECT_EQ(r.spelling.offset, c.offset) << c.p;
    EXPECT_EQ(r.polynomial, RationalFunction(Polynomial::chebyshev("x", static_cast<unsigned>(c.arity)))) << c.p;
    expect_conjugate(c.p, r);
  }
  // The same polynomial is no frequency for another arity.
  EXPECT_FALSE(relation("g^2-2", 3, "(-2, inf)").frequency);
  EXPECT_EQ(relation("2*g^2-1", 2).domain.to_string(), "(-1, inf)");
  EXPECT_EQ(relation("g^2-2", 2).domain.to_string(), "(-2, inf)");
  EXPECT_EQ(relation("-2*g^2+1", 2).domain.to_string(), "(-inf, 1)");
}

TEST(LevelRelation, LimitsAtOne) {
  struct Case {
    const char* p;
    const char* domain;
    Rational offset;  // g = v + offset
  };
  for (const auto& c : {Case{"g^2", "(0, inf)", 0}, Case{"g^2", "[1/4, 9]", 0}, Case{"2*g", "(-inf, inf)", -1},
                        Case{"g*(1+g)/2", "(0, 5]", 0}, Case{"g^3", "(0, 8)", 0}, Case{"4*g", "[-1, 1]", -1},
                        Case{"g^2+2*g", "(-1, inf)", -1}, Case{"g^2+2*g", "(-1, 0)", -1}}) {
    const LevelRelation r = relation(c.p, 2, c.domain);
    EXPECT_FALSE(r.frequency) << c.p;
    EXPECT_EQ(r.spelling.scale, Rational(1)) << c.p;
    EXPECT_EQ(r.spelling.offset, c.offset) << c.p;
    expect_conjugate(c.p, r);
  }
  // T_2 with the arity 3: the branch of cosh, whose image touches the open end of the domain.
  const LevelRelation t = relation("2*g^2-1", 3, "(-1, inf)");
  EXPECT_FALSE(t.frequency);
  EXPECT_TRUE(t.spelling.is_identity());
}

TEST(LevelRelation, Refused) {
  const auto names = [](const std::string& text, const char* piece) {
    EXPECT_NE(text.find(piece), std::string::npos) << text;
  };
  names(refusal("g^2", 2), "domain");
  names(refusal("g^2+h", 2, "(0, 1)"), "h");
  names(refusal("1/g", 2, "(0, 1)"), "not a polynomial");
  names(refusal("3", 2, "(0, 1)"), "degree");
  names(refusal("g^70", 2, "(0, 1)"), "degree");
  names(refusal("g", 2, "(0, 1)"), "identity");
  names(refusal("g+1", 2, "(0, 1)"), "fixed point");
  names(refusal("g/2", 2, "(-1, 1)"), "derivative greater than 1");
  names(refusal("-2*g", 2, "(-1, 1)"), "alternate");
  names(refusal("g^2-3", 2, "(-3, 10)"), "irrational");
  names(refusal("2*g^2-1", 3, "[-1, 2]"), "monotone");  // the closed end is the image of a critical point
  names(refusal("2*g^2-1", 3, "(-2, 2)"), "monotone");  // no preimage below -1
  names(refusal("g^2", 2, "[0, 2]"), "monotone");       // and 0 is a fixed point
  names(refusal("g^2", 2, "(-1, 2)"), "monotone");
  names(refusal("g^3", 2, "(-8, 8)"), "monotone");  // the branches of 1 and -1 end at 0
  names(refusal("2*g^2-1", 2, "[-1, 2]"), "must lie in");
  names(refusal("2*g^2-1", 2, "(-2, 2)"), "must lie in");
}

TEST(LevelRelation, ZerosBetween) {
  const Polynomial p = parse_rational_function("(x-1)*(x-2)^2*(x+3)*(x^2+1)").numerator();
  EXPECT_EQ(zeros_between(p, std::nullopt, std::nullopt), 3);
  EXPECT_EQ(zeros_between(p, Rational(1), Rational(2)), 0);  // open
  EXPECT_EQ(zeros_between(p, Rational(0), Rational(2)), 1);
  EXPECT_EQ(zeros_between(p, Rational(0), Rational(5, 2)), 2);
  EXPECT_EQ(zeros_between(p, std::nullopt, Rational(0)), 1);
  EXPECT_EQ(zeros_between(p, Rational(1), std::nullopt), 1);
  EXPECT_EQ(zeros_between(Polynomial(3), std::nullopt, std::nullopt), 0);
}

TEST(Domain, TextAndMembership) {
  for (const char* text : {"[0, 1/8]", "(-1, inf)", "(-inf, inf)", "(-1/9, 0)", "(-inf, 3]"})
    EXPECT_EQ(Domain::parse(text).to_string(), text);
  EXPECT_EQ(Domain::parse(" [ 0.5 , 1+1 ) ").to_string(), "[1/2, 2)");
  const Domain d = Domain::parse("[0, 1)");
  EXPECT_TRUE(d.contains(Rational(0)));
  EXPECT_FALSE(d.contains(Rational(1)));
  EXPECT_TRUE(d.contains(parse_real("sqrt(2)/2")));
  EXPECT_FALSE(d.contains(parse_real("sqrt(2)")));
  EXPECT_FALSE(Domain::parse("(0, inf)").contains(parse_real("-pi")));
  EXPECT_EQ(d.image(-2, 1).to_string(), "(-1, 1]");
  for (const char* text : {"", "[]", "0, 1", "[0, 1", "[1, 0]", "[1, 1]", "[0, inf]", "[-inf, 0]", "[0, 1, 2]",
                           "[a, 1]", "[0, pi]", "{0, 1}", "[1/0, 2]", "(inf, -inf)"})
    EXPECT_THROW(Domain::parse(text), Error) << text;
}

}  // namespace
}  // namespace twoscale::tests
