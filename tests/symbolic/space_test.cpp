// SPDX-License-Identifier: GPL-3.0-or-later
/// Spaces of exponential polynomials: what can be written, what is refused and how, names and bases of level variables.
#include "twoscale/symbolic/space.hpp"

#include <algorithm>
#include <random>

#include "support/laws.hpp"
#include "support/mutate.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::tests {
namespace {

using Exponentials = std::vector<Space::Exponential>;

bool same(const Space& a, const Space& b) {
  if (a.polynomial_order() != b.polynomial_order() || a.exponentials() != b.exponentials()) return false;
  if (a.variables().size() != b.variables().size()) return false;
  for (size_t i = 0; i < a.variables().size(); ++i) {
    const auto& x = a.variables()[i];
    const auto& y = b.variables()[i];
    if (x.name != y.name || x.factor != y.factor || !x.same_group(y)) return false;
  }
  return true;
}

std::string refusal(const std::string& text) {
  try {
    return "read as " + Space::parse(text).to_string();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind, Error::Kind::bad_input);
    return e.offending;
  }
}

TEST(Space, ReadsTheFamilies) {
  const Space mixed = Space::parse("1, x, x^2, x^3, exp(t*x), exp(-t*x)");
  EXPECT_EQ(mixed.dimension(), 6U);
  EXPECT_EQ(mixed.polynomial_order(), 4U);
  EXPECT_EQ(mixed.exponentials(), (Exponentials{{0, 1, 1}}));
  EXPECT_EQ(mixed.variables()[0].name, "v");
  EXPECT_EQ(mixed.variables()[0].meaning(2), "cosh(t/2^(k+1))");
  EXPECT_EQ(mixed.variables()[0].meaning(3), "cosh(t/3^(k+1))");
  const Space resonant = Space::parse("1,x,exp(t*x),exp(-t*x),x*exp(t*x),x*exp(-t*x)");
  EXPECT_EQ(resonant.exponentials(), (Exponentials{{0, 1, 2}}));
  const Space harmonic = Space::parse("1,x,exp(t*x),exp(-t*x),exp(2*t*x),exp(-2*t*x)");
  EXPECT_EQ(harmonic.exponentials(), (Exponentials{{0, 1, 1}, {0, 2, 1}}));
  EXPECT_EQ(Space::parse("1,x,x^2").dimension(), 3U);
  EXPECT_TRUE(Space::parse("1").variables().empty());
}

TEST(Space, FormsOfTheSameSpace) {
  const Space exp = Space::parse("exp(t*x), exp(-t*x)");
  for (const char* text : {"cosh(t*x), sinh(t*x)", "sinh(t*x), cosh(t*x)", "exp(-x*t), exp(x*t)",
                           "3*exp(t*x), -exp(-t*x)/2", "exp(t*x), cosh(t*x)", "cosh(-t*x), sinh(-t*x)",
                           "x^0*exp(t*x), exp(-t*x)", "exp(1.0*t*x), exp(-t*x)", "cos(I*t*x), sin(I*t*x)"})
    EXPECT_TRUE(same(Space::parse(text), exp)) << text << ": " << Space::parse(text).to_string();
  const Space cos = Space::parse("cos(t*x), sin(t*x)");
  for (const char* text :
       {"exp(I*t*x), exp(-I*t*x)", "sin(t*x), cos(-t*x)", "cosh(I*t*x), sinh(I*t*x)", "exp(I*t*x), cos(t*x)"})
    EXPECT_TRUE(same(Space::parse(text), cos)) << text;
  EXPECT_FALSE(same(exp, cos));
  EXPECT_TRUE(cos.variables()[0].trigonometric);
  EXPECT_EQ(cos.variables()[0].meaning(2), "cos(t/2^(k+1))");
}

TEST(Space, RationalMultiplesShareTheirGreatestCommonFrequency) {
  const Space s = Space::parse("exp(t*x/2), exp(-t*x/2), exp(t*x/3), exp(-t*x/3)");
  ASSERT_EQ(s.variables().size(), 1U);
  EXPECT_EQ(s.variables()[0].factor, Rational(1, 6));
  EXPECT_EQ(s.variables()[0].frequency(), "t/6");
  EXPECT_EQ(s.exponentials(), (Exponentials{{0, 2, 1}, {0, 3, 1}}));
  const Space lacunary = Space::parse("1, x, cos(t*x), sin(t*x), cos(3*t*x), sin(3*t*x)");
  EXPECT_EQ(lacunary.exponentials(), (Exponentials{{0, 1, 1}, {0, 3, 1}}));
  const Space scaled = Space::parse("cosh(4*t*x), sinh(4*t*x), cosh(6*t*x), sinh(6*t*x)");
  EXPECT_EQ(scaled.variables()[0].frequency(), "2*t");
  EXPECT_EQ(scaled.exponentials(), (Exponentials{{0, 2, 1}, {0, 3, 1}}));
  const Space decimal = Space::parse("exp(0.5*t*x), exp(-t*x/2)");
  EXPECT_EQ(decimal.variables()[0].factor, Rational(1, 2));
}

TEST(Space, SeveralFrequencies) {
  const Space s = Space::parse("1, x, exp(t*x), exp(-t*x), cos(s*x), sin(s*x), exp(2*t*x), exp(-2*t*x)");
  ASSERT_EQ(s.variables().size(), 2U);
  EXPECT_EQ(s.variables()[0].name, "v_s");
  EXPECT_EQ(s.variables()[1].name, "v_t");
  EXPECT_TRUE(s.variables()[0].trigonometric);
  EXPECT_EQ(s.exponentials(), (Exponentials{{0, 1, 1}, {1, 1, 1}, {1, 2, 1}}));
  EXPECT_EQ(s.dimension(), 8U);
  // The same name as exponential and as cosine: two level variables with two names.
  const Space both = Space::parse("exp(t*x), exp(-t*x), cos(t*x), sin(t*x)");
  ASSERT_EQ(both.variables().size(), 2U);
  EXPECT_NE(both.variables()[0].name, both.variables()[1].name);
}

TEST(Space, NumericFrequencies) {
  const Space s = Space::parse("cos(2*pi/7*x), sin(2*pi/7*x)");
  EXPECT_EQ(s.variables()[0].frequency(), "2*pi/7");
  EXPECT_EQ(s.variables()[0].value().value().multiple_of_pi(), Rational(2, 7));
  EXPECT_EQ(Space::parse("exp(x), exp(-x)").variables()[0].value().value().rational(), Rational(1));
  EXPECT_EQ(Space::parse("exp(3*x/5), exp(-0.6*x)").variables()[0].value().value().rational(), Rational(3, 5));
  EXPECT_EQ(Space::parse("cosh(sqrt(2)*x/3), sinh(sqrt(2)*x/3)").variables()[0].frequency(), "sqrt(2)/3");
  EXPECT_EQ(Space::parse("exp(pi*x),exp(-pi*x),exp(2*pi*x/3),exp(-2*pi*x/3)").variables()[0].frequency(), "pi/3");
  EXPECT_FALSE(Space::parse("exp(t*x), exp(-t*x)").variables()[0].value().has_value());
  // pi and 1 are independent, 1 and 1/2 are not.
  EXPECT_EQ(Space::parse("exp(x),exp(-x),exp(pi*x),exp(-pi*x)").variables().size(), 2U);
  EXPECT_EQ(Space::parse("exp(x),exp(-x),exp(x/2),exp(-x/2)").variables().size(), 1U);
}

TEST(Space, FrequenciesThatAreSums) {
  const Space s = Space::parse("exp((1+sqrt(2))*x), exp(-(1+sqrt(2))*x)");
  EXPECT_TRUE(same(Space::parse(s.to_string()), s)) << s.to_string();
  EXPECT_EQ((s.variables()[0].value().value() - ExactReal(1) - parse_real("sqrt(2)")).sign(), Sign::zero);
  const Space negative = Space::parse("exp((1-sqrt(2))*x), exp((sqrt(2)-1)*x)");
  EXPECT_EQ((negative.variables()[0].value().value() + ExactReal(1) - parse_real("sqrt(2)")).sign(), Sign::zero);
  // Twice the number is twice the frequency.
  const Space multiples =
      Space::parse("cosh((1+sqrt(2))*x), sinh((1+sqrt(2))*x), cosh(2*(1+sqrt(2))*x), sinh((2+2*sqrt(2))*x)");
  ASSERT_EQ(multiples.variables().size(), 1U);
  EXPECT_EQ(multiples.exponentials(), (Exponentials{{0, 1, 1}, {0, 2, 1}}));
}

TEST(Space, HiddenMultiplesAreRefused) {
  // One frequency written in two ways would get two level variables that are not independent.
  for (const char* pair :
       {"sqrt(6)|sqrt(2)*sqrt(3)", "log(4)|log(2)", "2*cos(pi/7)*cos(2*pi/7)|cos(pi/7)+cos(3*pi/7)"}) {
    const std::string text(pair);
    const std::string a = text.substr(0, text.find('|'));
    const std::string b = text.substr(text.find('|') + 1);
    const std::string space = "exp((" + a + ")*x),exp(-(" + a + ")*x),exp((" + b + ")*x),exp(-(" + b + ")*x)";
    EXPECT_THROW(Space::parse(space), Error) << space << " read as " << Space::parse(space).to_string();
  }
  // What is seen to be a multiple is one: cos(pi/5) = (1 + sqrt(5))/4.
  EXPECT_EQ(
      Space::parse("exp(cos(pi/5)*x),exp(-cos(pi/5)*x),exp((1+sqrt(5))*x),exp(-(1+sqrt(5))*x)").variables().size(), 1U);
  EXPECT_EQ(Space::parse("exp(sqrt(2)*x),exp(-sqrt(2)*x),exp(sqrt(3)*x),exp(-sqrt(3)*x)").variables().size(), 2U);
}

TEST(SpaceErrors, NameWhatIsMissing) {
  EXPECT_EQ(refusal("1, x, exp(t*x)"), "exp(-t*x)");
  EXPECT_EQ(refusal("1, x, exp(-t*x)"), "exp(t*x)");
  EXPECT_EQ(refusal("1, x, cos(t*x)"), "sin(t*x)");
  EXPECT_EQ(refusal("1, x, sin(2*t*x)"), "cos(2*t*x)");
  EXPECT_EQ(refusal("cosh(t*x)"), "sinh(t*x)");
  EXPECT_EQ(refusal("1, x^2"), "x");
  EXPECT_EQ(refusal("x"), "1");
  EXPECT_EQ(refusal("x^3"), "1, x, x^2");
  EXPECT_EQ(refusal("x*exp(t*x), x*exp(-t*x)"), "exp(t*x), exp(-t*x)");
  EXPECT_EQ(refusal("exp(t*x), exp(-t*x), x*exp(t*x)"), "x*exp(-t*x)");
  EXPECT_EQ(refusal("x*cos(t*x), x*sin(t*x), cos(t*x)"), "sin(t*x)");
  EXPECT_EQ(refusal("exp(2*pi/3*x)"), "exp(-2*pi/3*x)");
}

TEST(SpaceErrors, NameWhatCannotBeUsed) {
  EXPECT_EQ(refusal("1, 1"), "1");
  EXPECT_EQ(refusal("1, x, 2*x"), "2*x");
  EXPECT_EQ(refusal("exp(t*x), exp(-t*x), exp(x*t)"), "exp(x*t)");
  EXPECT_EQ(refusal("exp(t*x), exp(-t*x), cosh(t*x)"), "cosh(t*x)");
  EXPECT_EQ(refusal("1, exp((s+t)*x), exp(-(s+t)*x)"), "exp((s+t)*x)");
  EXPECT_EQ(refusal("1, exp(s*t*x)"), "exp(s*t*x)");
  EXPECT_EQ(refusal("1, exp(t^2*x)"), "exp(t^2*x)");
  EXPECT_EQ(refusal("1, tan(t*x)"), "tan(t*x)");
  EXPECT_EQ(refusal("1, exp(x^2)"), "exp(x^2)");
  EXPECT_EQ(refusal("1, exp(t*x+1)"), "exp(t*x+1)");
  EXPECT_EQ(refusal("1, exp(t*x)*exp(s*x)"), "exp(t*x)*exp(s*x)");
  EXPECT_EQ(refusal("1, exp((1+I)*x)"), "exp((1+I)*x)");
  EXPECT_EQ(refusal("1, y"), "y");
  EXPECT_EQ(refusal("1, x^-1"), "x^-1");
  EXPECT_EQ(refusal("1, sqrt(x)"), "sqrt(x)");
  EXPECT_EQ(refusal("1, 0"), "0");
  EXPECT_EQ(refusal("1, x+x^2"), "x+x^2");
  EXPECT_THROW(Space::parse(""), Error);
  EXPECT_THROW(Space::parse("1,,x"), Error);
  EXPECT_THROW(Space::parse("1,x,"), Error);
  EXPECT_THROW(Space::parse("x^99999999999999999999"), Error);
}

LAW(Space, TheOrderOfItemsDoesNotMatter, (const Space& s)) {
  auto items = s.items();
  std::mt19937_64 random(uniform(0U, 1U << 31U));
  for (size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[below(random, i)]);
  std::string text;
  for (const auto& i : items) text += (text.empty() ? "" : ",") + i;
  LAW_ASSERT(same(Space::parse(text), s));
}

LAW(Space, TextReadsBack, (const Space& s)) {
  LAW_ASSERT(same(Space::parse(s.to_string()), s));
  LAW_ASSERT(s.items().size() == static_cast<size_t>(s.dimension()));
}

LAW(Space, LeavingOutAnyItemThatOthersNeedIsRefused, (const Space& s)) {
  // A space without one of its exponentials is never closed.
  const auto items = s.items();
  for (size_t out = s.polynomial_order(); out < items.size(); ++out) {
    std::string text;
    for (size_t i = 0; i < items.size(); ++i)
      if (i != out) text += (text.empty() ? "" : ",") + items[i];
    try {
      Space::parse(text);
      FAIL() << "read " << text;
    } catch (const Error& e) {
      LAW_ASSERT(e.offending.find(items[out]) != std::string::npos);
    }
  }
}

TEST(Space, TextReadsBackForEveryKindOfFrequency) {
  for (const char* text :
       {"cos(2*pi/7*x), sin(2*pi/7*x)", "exp(x), exp(-x)", "exp(x/2), exp(-x/2)", "1, x, exp(pi*x/6), exp(-pi*x/6)",
        "cosh(sqrt(2)*x/3), sinh(sqrt(2)*x/3)", "exp(sqrt(2)*sqrt(3)*x), exp(-sqrt(3)*sqrt(2)*x)",
        "exp(pi^2*x), exp(-pi^2*x)", "exp(2^(1/3)*x), exp(-2^(1/3)*x)", "exp(log(2)*x), exp(-log(2)*x)",
        "cos(t*x/5),sin(t*x/5),x*cos(t*x/5),x*sin(t*x/5)", "exp(x),exp(-x),cos(x),sin(x)",
        "exp(s*x),exp(-s*x),cos(2*s*x/3),sin(2*s*x/3)", "exp((sqrt(2)+sqrt(3)/2)*x), exp(-(sqrt(2)+sqrt(3)/2)*x)",
        "exp(cos(pi/7)*x),exp(-cos(pi/7)*x)"}) {
    const Space s = Space::parse(text);
    EXPECT_TRUE(same(Space::parse(s.to_string()), s))
        << text << " -> " << s.to_string() << " -> " << Space::parse(s.to_string()).to_string();
  }
}

TEST(Space, NodesAreCoshOfTheFrequencies) {
  const Space s = Space::parse("1,x,x^2,exp(t*x),exp(-t*x),exp(3*t*x),exp(-3*t*x),x*exp(t*x),x*exp(-t*x)");
  const auto w = cosh_nodes(s);
  ASSERT_EQ(w.size(), 4U);  // floor(9/2)
  EXPECT_TRUE(w[0].is_one());
  EXPECT_EQ(w[1].to_string(), "v");
  EXPECT_EQ(w[2].to_string(), "v");
  EXPECT_EQ(w[3].to_string(), "4*v^3-3*v");
  EXPECT_EQ(nodes(s), (std::vector<Node>{{0, 0}, {0, 1}, {0, 1}, {0, 3}}));
}

LAW(Space, NodesCountHalfTheDimension, (const Space& s)) {
  LAW_ASSERT(cosh_nodes(s).size() == static_cast<size_t>(s.dimension() / 2));
  LAW_ASSERT(nodes(s).size() == cosh_nodes(s).size());
}

/// Base changes keep the frequencies: multiple * factor is the same number of the same unit before and after.
TEST(Space, Rebase) {
  const Space reference = Space::parse("1, x, exp(t*x/2), exp(-t*x/2)");
  const Space space = Space::parse("exp(t*x/3), exp(-t*x/3), exp(t*x), exp(-t*x), cos(s*x), sin(s*x)");
  const auto r = Space::rebase(space, reference.variables());
  EXPECT_EQ(r.space.variables()[0].name, reference.variables()[0].name);
  EXPECT_EQ(r.space.variables()[0].factor, Rational(1, 6));
  ASSERT_EQ(r.scale.size(), 1U);
  EXPECT_EQ(r.scale[0], 3U);  // t/2 = 3 (t/6)
  EXPECT_EQ(r.space.exponentials().size(), 3U);
  EXPECT_EQ(r.space.exponentials()[0], (Space::Exponential{0, 2, 1}));
  EXPECT_EQ(r.space.exponentials()[1], (Space::Exponential{0, 6, 1}));
  EXPECT_EQ(r.space.dimension(), space.dimension());
  ASSERT_EQ(r.space.variables().size(), 2U);
  EXPECT_NE(r.space.variables()[0].name, r.space.variables()[1].name);
  EXPECT_EQ(r.space.to_string().find("s") != std::string::npos, true);
}

LAW(Space, RebaseKeepsTheFunctions, (const Space& s, const Space& reference)) {
  const auto r = Space::rebase(s, reference.variables());
  auto a = s.items();
  auto b = r.space.items();
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  LAW_ASSERT(a == b);
  LAW_ASSERT(r.scale.size() == reference.variables().size());
  for (size_t i = 0; i < r.scale.size(); ++i) {
    LAW_ASSERT(r.space.variables()[i].name == reference.variables()[i].name);
    LAW_ASSERT(r.space.variables()[i].factor * Rational(static_cast<long>(r.scale[i])) ==
               reference.variables()[i].factor);
  }
}

TEST(Space, Latex) {
  EXPECT_EQ(Space::parse("1,x,x^2,exp(2*t*x),exp(-2*t*x)").to_latex(), "1, x, x^{2}, e^{2t x}, e^{-2t x}");
  EXPECT_EQ(Space::parse("cos(s*x/2),sin(s*x/2)").to_latex(), "\\cos(\\tfrac{1}{2}s x), \\sin(\\tfrac{1}{2}s x)");
}

}  // namespace
}  // namespace twoscale::tests
