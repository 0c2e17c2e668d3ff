// SPDX-License-Identifier: GPL-3.0-or-later
/// The expressions of the contract: everything it names is read, exactly; errors name the piece; nothing runs away.
#include "twoscale/symbolic/expression.hpp"

#include <ctime>

#include "support/laws.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale {

inline void PrintTo(Sign s, std::ostream* out) { *out << static_cast<int>(s); }

namespace tests {
namespace {

Rational number(const std::string& text) {
  const auto c = parse_rational_function(text).constant();
  if (!c) throw Error(Error::Kind::bad_input, "not constant", text);
  return *c;
}

TEST(Expression, ArithmeticAndPrecedence) {
  EXPECT_EQ(number("1+2*3"), Rational(7));
  EXPECT_EQ(number("(1+2)*3"), Rational(9));
  EXPECT_EQ(number("2-3-4"), Rational(-5));
  EXPECT_EQ(number("2/3/4"), Rational(1, 6));
  EXPECT_EQ(number("-2^2"), Rational(-4));
  EXPECT_EQ(number("2^3^2"), Rational(512));
  EXPECT_EQ(number("2^-3"), Rational(1, 8));
  EXPECT_EQ(number("2*-3"), Rational(-6));
  EXPECT_EQ(number("--3"), Rational(3));
  EXPECT_EQ(number("+-+3"), Rational(-3));
  EXPECT_EQ(number("2*3^2"), Rational(18));
  EXPECT_EQ(number("6/2*3"), Rational(9));
  EXPECT_EQ(number(" 1 /\t2 "), Rational(1, 2));
  EXPECT_EQ(number("(1+I)*(1-I)"), Rational(2));
  EXPECT_EQ(number("I^2"), Rational(-1));
  EXPECT_EQ(number("2**3"), Rational(8));  // as SymPy writes it
}

TEST(Expression, DecimalsAreExact) {
  EXPECT_EQ(number("0.4"), Rational(2, 5));
  EXPECT_EQ(number("-0.125"), Rational(-1, 8));
  EXPECT_EQ(number(".5"), Rational(1, 2));
  EXPECT_EQ(number("5."), Rational(5));
  EXPECT_EQ(number("1.5e-3"), Rational(3, 2000));
  EXPECT_EQ(number("2E2"), Rational(200));
  EXPECT_EQ(number("1e+2"), Rational(100));
  EXPECT_EQ(number("0.1+0.2"), Rational(3, 10));
  EXPECT_EQ(number("0.333333333333333333333333333333"),
            Rational::parse("333333333333333333333333333333/1000000000000000000000000000000"));
  EXPECT_EQ(number("1e-400") * number("1e400"), Rational(1));
}

LAW(Expression, DecimalsOfAnyLength, ()) {
  const std::string digits =
      Rational(uniform(1L, 1000000000000L)).to_string() + Rational(uniform(1L, 1000000000000L)).to_string();
  const size_t point = uniform<size_t>(0, digits.size());
  const std::string text = digits.substr(0, point) + "." + digits.substr(point);
  LAW_ASSERT(number(text) == Rational::parse(digits) / Rational(10).pow(static_cast<long>(digits.size() - point)));
}

TEST(Expression, EveryFunctionOfTheContract) {
  struct Case {
    const char* text;
    const char* decimal;
  };
  for (const Case& c : {Case{"pi", "3.1415926535897932385"}, Case{"sqrt(2)", "1.4142135623730950488"},
                        Case{"exp(1/2)", "1.6487212707001281468"}, Case{"log(3)", "1.0986122886681096914"},
                        Case{"cos(1)", "0.54030230586813971740"}, Case{"sin(1)", "0.84147098480789650665"},
                        Case{"tan(1)", "1.5574077246549022305"}, Case{"cosh(3/5)", "1.1854652182422677038"},
                        Case{"sinh(3/5)", "0.63665358214824127112"}, Case{"acos(1/3)", "1.2309594173407746821"},
                        Case{"acosh(2)", "1.3169578969248167086"}, Case{"atan(2)", "1.1071487177940905030"},
                        Case{"cos(2*pi/7)", "0.62348980185873353053"}, Case{"2^(1/3)", "1.2599210498948731648"},
                        Case{"pi^2", "9.8696044010893586188"}, Case{"sqrt(5)/4-1/4", "0.30901699437494742410"},
                        Case{"exp(log(2)*3)", "8.0000000000000000000"}})
    EXPECT_EQ(parse_real(c.text).decimal(20), c.decimal) << c.text;
}

TEST(Expression, ExactValuesAreSeen) {
  EXPECT_EQ(parse_real("cos(pi/3)").rational(), Rational(1, 2));
  EXPECT_EQ(parse_real("sqrt(9/16)").rational(), Rational(3, 4));
  EXPECT_EQ(parse_real("exp(0)").rational(), Rational(1));
  EXPECT_EQ(parse_real("cos(2*pi/5)-(sqrt(5)-1)/4").sign(), Sign::zero);
  EXPECT_EQ(parse_real("acosh(1)").sign(), Sign::zero);
}

TEST(Expression, NamesAreKept) {
  Symbols symbols;
  EXPECT_EQ(names_in(parse_expression("v_s^2*alpha1+t*x-x", symbols)),
            (std::vector<std::string>{"alpha1", "t", "v_s", "x"}));
  EXPECT_TRUE(names_in(parse_expression("pi+I+sqrt(2)", symbols)).empty());
  // One table: the same name is the same thing.
  EXPECT_TRUE((parse_expression("v+1", symbols) - parse_expression("1+v", symbols)).is_zero());
}

TEST(Expression, RationalFunctions) {
  EXPECT_EQ(parse_rational_function("(v^2-1)/(v-1)").to_string(), "v + 1");
  EXPECT_EQ(parse_rational_function("v^-2"), parse_rational_function("1/v^2"));
  EXPECT_EQ(parse_rational_function("1/2+w").to_string(), "(2*w + 1)/2");
  EXPECT_EQ(parse_rational_function("-w^2*-3").to_string(), "3*w^2");
  for (const char* text : {"sqrt(v)", "cos(v)", "v^v", "2^v", "pi*v", "I*v", "v^(1/2)"})
    EXPECT_THROW(parse_rational_function(text), Error) << text;
}

LAW(Expression, GinacAndBack, (const RationalFunction& f)) {
  Symbols symbols;
  LAW_ASSERT(to_rational_function(to_ginac(f, symbols)) == f);
}

/// The text with ** for ^ is SymPy's; both ways of writing are read as the same.
LAW(Expression, SympySpelling, (const RationalFunction& f)) {
  std::string text;
  for (const char c : f.to_string()) text += c == '^' ? "**" : std::string(1, c);
  LAW_ASSERT(parse_rational_function(text) == f);
}

TEST(ExpressionErrors, NameThePiece) {
  struct Case {
    const char* text;
    const char* piece;
  };
  for (const Case& c : {Case{"1+foo(3)", "foo(3)"}, Case{"2*(v+#)", "#"}, Case{"2v", "'v'"}, Case{"1..2", ".2"},
                        Case{"v w", "'w'"}, Case{"3!", "!"}, Case{"1,2", ",2"}, Case{"x=1", "=1"},
                        Case{"sin 3", "sin 3"}, Case{"1e+", "1e+"}, Case{"a.b", ".b"}, Case{"\xff", "\xff"},
                        Case{"_a", "_a"}, Case{"abs(1)", "abs"}, Case{"v^(1+)", ")"}, Case{"1_000", "_000"}})
    try {
      parse_rational_function(c.text);
      ADD_FAILURE() << c.text << " was read";
    } catch (const Error& e) {
      EXPECT_EQ(e.kind, Error::Kind::bad_input) << c.text;
      EXPECT_NE(e.offending.find(c.piece), std::string::npos) << c.text << ": " << e.what();
    }
  for (const char* text :
       {"", "  ", "(", ")", "()", "+", "1+", "2^", "(1", "1)", "sin(", "sin()", "*2", "/2", "1//2", "^2"})
    EXPECT_THROW(parse_rational_function(text), Error) << "'" << text << "'";
}

TEST(ExpressionErrors, WhatHasNoValue) {
  for (const char* text :
       {"1/0", "0^-1", "0^0", "log(0)", "tan(pi/2)", "v/(v-v)", "1/(sqrt(2)^2-2)", "1/(1+I^2)", "atan(I)", "acosh(1/2)",
        "acos(2)", "log(-1)", "sqrt(-1)", "exp(exp(exp(100)))", "1/cos(pi/2)", "0^(-1/2)", "I", "v"})
    EXPECT_THROW(parse_real(text), Error) << text;
}

/// Small texts that mean large things end at once.
TEST(ExpressionBombs, EndQuickly) {
  std::vector<std::string> bombs = {"9^9^9^9",
                                    "10^10^10",
                                    "2^(2^30)",
                                    "v^(2^30)",
                                    "1e999999",
                                    "((((v*9)^4096)^4096)^4096)^4096",
                                    "(a+b+c+d+e+f)^4096",
                                    "(a+b+c)^4096",
                                    "(9^100000*v+1)^4096",
                                    "((v+1)^4096)^4096",
                                    "1/((v+1)^4096+1)^4096",
                                    "9^99999^9",
                                    "(1/9^99999)^99999",
                                    "exp(10^100000)",
                                    "cos(10^100000)^2",
                                    "2^0.0000001",
                                    "(2^100000)^(1/3)",
                                    "1/(v^4000+v+1)",
                                    "v^99999",
                                    "(-1)^(1/99999999)"};
  bombs.push_back(std::string(100000, '(') + "1" + std::string(100000, ')'));
  bombs.push_back(std::string(1000000, '-') + "1");
  bombs.push_back(std::string(1000000, '7'));
  bombs.push_back(std::string(2000000, '1'));
  std::string product = "3^300000", names = "a", fractions = "1/a", powers = "2", functions, factors = "1";
  for (int i = 0; i < 3000; ++i) {
    product += "*3^300000";
    names += "+a" + std::to_string(i);
    fractions += "+1/(1+a" + std::to_string(i) + ")";
    factors += "*(1+a" + std::to_string(i % 60) + ")";
    powers += "^2";
    functions += "exp(";
  }
  std::string division = "(v*3^300000)";
  for (int i = 0; i < 3000; ++i) division += "/(v*3^300000)";
  for (const auto& text : {product, names, fractions, powers, functions, factors, division}) bombs.push_back(text);
  for (const auto& text : bombs) {
    const std::clock_t start = std::clock();  // CPU time: other processes do not count
    try {
      parse_rational_function(text);
    } catch (const Error&) {
    }
    try {
      const ExactReal x = parse_real(text);
      (void)x.sign(4096);
    } catch (const Error&) {
    }
    EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 5) << text.substr(0, 60);
  }
}

TEST(ExpressionBombs, ErrorsStayShort) {
  for (const std::string& text : {std::string(1000000, '7'), std::string(1000000, '('), std::string(2000000, 'v'),
                                  "1/" + std::string(300000, 'v') + "+sin(q)"})
    try {
      parse_real(text);
    } catch (const Error& e) {
      EXPECT_LT(std::string(e.what()).size(), 1000U);
    }
}

TEST(ExpressionBombs, LongSumsAreLinear) {
  std::string text = "0";
  for (int i = 0; i < 100000; ++i) text += "+v";
  EXPECT_EQ(parse_rational_function(text), RationalFunction(100000) * RationalFunction::variable("v"));
}

TEST(SplitList, CommasInsideBracketsDoNotSplit) {
  using Pieces = std::vector<std::string>;
  EXPECT_EQ(split_list("a, f(b,c) ,[1,2]"), (Pieces{"a", "f(b,c)", "[1,2]"}));
  EXPECT_EQ(split_list("\"1,x\",y"), (Pieces{"\"1,x\"", "y"}));
  EXPECT_EQ(split_list("  "), Pieces{});
  EXPECT_EQ(split_list("a,,b,"), (Pieces{"a", "", "b", ""}));
  EXPECT_EQ(trimmed(" \t a b\n"), "a b");
}

}  // namespace
}  // namespace tests
}  // namespace twoscale
