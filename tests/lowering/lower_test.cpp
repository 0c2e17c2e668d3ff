// SPDX-License-Identifier: GPL-3.0-or-later
// Mask tables: every digit against an independent evaluation with twice the digits, exact zeros, singular steps, tails.
#include "support.hpp"

#include <algorithm>
#include <cmath>

#include "twoscale/symbolic/interpolatory.hpp"

namespace twoscale::lowering {
namespace {

using test::Named;
using test::refusal;
using test::table;

// |text - value| <= half a unit of the last of `digits` significant digits, for every number of the table.
void expect_correct(const Scheme& s, const std::vector<std::pair<std::string, Ball>>& start,
                    const kernels::MaskTable& t, long digits) {
  const Laurent a = symbol(s);
  const long bits = 8 * digits + 400 + 8 * static_cast<long>(t.levels.size());
  for (size_t k = 0; k < t.levels.size(); ++k) {
    std::vector<std::pair<std::string, Ball>> at;
    for (const auto& [name, v0] : start)
      at.emplace_back(name, test::forward(v0, static_cast<unsigned>(k) + 1, s.arity, bits));
    ASSERT_EQ(t.levels[k].lowest, a.lowest());
    ASSERT_EQ(t.levels[k].text.size(), a.coefficients().size());
    for (size_t i = 0; i < a.coefficients().size(); ++i) {
      const Ball x = test::evaluate(a.coefficients()[i], at, bits);
      const std::string& text = t.levels[k].text[i];
      const std::string where = t.scheme + " k=" + std::to_string(k) + " i=" + std::to_string(i) + " " + text;
      double nearest = 0;
      if (x.is_exact_zero() || text == "0") {
        EXPECT_TRUE(x.contains_zero()) << where;
        continue;
      }
      EXPECT_EQ(text, [&] {
        const std::string r = rounded_decimal(x, digits);
        // An exact short text may replace a padded one.
        return !r.empty() && test::exact_text(r) == test::exact_text(text) ? text : r;
      }()) << where;
      ASSERT_TRUE(rounded_double(x, nearest)) << where;
      EXPECT_EQ(t.levels[k].value[i], nearest) << where;
    }
  }
}

struct Start {
  const char* scheme;
  const char* v0;
};

class Digits : public testing::TestWithParam<Start> {};

TEST_P(Digits, AgreeWithAnIndependentEvaluation) {
  const Scheme s = make_scheme(GetParam().scheme);
  for (const long digits : {17L, 50L, 213L}) {
    const kernels::MaskTable t = table(GetParam().scheme, GetParam().v0, 24, digits);
    const ExactReal v0 = parse_real(GetParam().v0);
    expect_correct(s, {{"v", v0.enclose(8 * digits + 1000)}}, t, digits);
    EXPECT_EQ(t.digits, digits);
    EXPECT_EQ(t.parameters, (Named{{"v0", GetParam().v0}}));
  }
}

INSTANTIATE_TEST_SUITE_P(Lower, Digits,
                         testing::Values(Start{"tension4", "-2/5"}, Start{"tension4", "7"},
                                         Start{"tension4", "0.9999999999999999999"},
                                         Start{"interpolating:family=mixed,l=3", "cos(2*pi/7)"},
                                         Start{"interpolating:family=mixed,l=3", "cosh(3/5)"},
                                         Start{"interpolating:family=harmonic,l=3", "(sqrt(5)-1)/4"},
                                         Start{"interpolating:family=harmonic,l=4", "-19/20"},
                                         Start{"interpolating:family=resonant,l=4", "-999/1000"},
                                         Start{"interpolating:family=resonant,l=3", "10^30"},
                                         Start{"interpolating:family=mixed,l=5", "sqrt(2)+sqrt(3)"},
                                         Start{"mixed:n=2,arity=3", "-1/3"}, Start{"mixed:n=2,arity=3", "5/2"},
                                         Start{"harmonic:n=2", "exp(1)"},
                                         Start{"exponential-bspline:arity=5,space=\"exp(t*x),exp(-t*x)\"", "2"}),
                         [](const auto& i) { return "case" + std::to_string(i.index); });

// Around whole numbers of limbs, levels at which u is large, small and smaller than a digit.
TEST(Lower, AnyNumberOfDigits) {
  for (const char* v0 : {"-2/5", "-99/100", "cosh(2)"})
    for (const long digits : {18L, 19L, 31L, 38L, 39L, 57L, 58L, 76L, 95L, 96L, 600L, 601L}) {
      const char* name = "interpolating:family=mixed,l=3";
      expect_correct(make_scheme(name), {{"v", parse_real(v0).enclose(8 * digits + 1000)}},
                     table(name, v0, digits < 100 ? 40 : 6, digits), digits);
    }
}

TEST(Lower, ManyDigits) {
  const Scheme s = make_scheme("interpolating:family=harmonic,l=3");
  const kernels::MaskTable t = table("interpolating:family=harmonic,l=3", "-2/5", 3, 10000);
  expect_correct(s, {{"v", Ball(Rational(-2, 5), 100000)}}, t, 10000);
  EXPECT_EQ(refusal([] { table("tension4", "2", 3, 16); }), "digits must lie between 17 and 10000: 16");
  EXPECT_EQ(refusal([] { table("tension4", "2", 3, 10001); }), "digits must lie between 17 and 10000: 10001");
  EXPECT_NE(refusal([] { table("tension4", "2", 5000, 17); }), "");
}

TEST(Lower, SeveralFrequencies) {
  const char* name = "interpolating:space=\"1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)\"";
  const kernels::MaskTable t = table(name, std::nullopt, 12, 40, {{"s", "3/5"}, {"t", "I*pi/2"}});
  expect_correct(make_scheme(name), {{"v_s", parse_real("cosh(3/5)").enclose(2000)}, {"v_t", Ball()}}, t, 40);
  const kernels::MaskTable u = table(name, std::nullopt, 12, 40, {{"v0_s", "cosh(3/5)"}, {"v0_t", "0"}});
  for (size_t k = 0; k < 12; ++k) EXPECT_EQ(t.levels[k].text, u.levels[k].text);
  // Equal frequencies, the confluent case: both squares of one pair.
  const kernels::MaskTable both = table(name, std::nullopt, 4, 30, {{"v0_s", "-1/4"}, {"v0_t", "-1/4"}});
  const kernels::MaskTable resonant = table("interpolating:family=resonant,l=3", "-1/4", 4, 30);
  for (size_t k = 0; k < 4; ++k) EXPECT_EQ(both.levels[k].text, resonant.levels[k].text);
}

TEST(Lower, RationalLevelsAreExact) {
  // v^0 = 7, v^1 = 2: a_3 = -1/(8 v (v + 1)) = -1/48; then v^2 = sqrt(3/2).
  const kernels::MaskTable t = table("tension4", "7", 2, 20);
  EXPECT_EQ(t.levels[0].text[0], "-0.020833333333333333333");
  EXPECT_EQ(t.levels[0].text[2], "0.52083333333333333333");
  // v^0 = T_8(3/2): four rational levels.
  const Rational v0 = Polynomial::chebyshev("x", 8).evaluate({{"x", Rational(3, 2)}});
  const kernels::MaskTable u = table("tension4", v0.to_string(), 3, 20);
  EXPECT_EQ(u.levels[2].text[0], "-0.033333333333333333333");
  // Stationary at v^0 = 1: the Dubuc-Deslauriers mask, exactly, at every level.
  const kernels::MaskTable one = table("tension4", "1", 3, 50);
  const kernels::MaskTable dd = table("dd:l=2", std::nullopt, 3, 50);
  for (const auto* x : {&one, &dd}) {
    EXPECT_EQ(x->tail_bound, "0");
    EXPECT_EQ(x->precision_error, "0");
    EXPECT_EQ(x->levels.size(), 3U);
    EXPECT_EQ(x->levels[2].text, (std::vector<std::string>{"-0.0625", "0", "0.5625", "1", "0.5625", "0", "-0.0625"}));
    EXPECT_EQ(x->limit.text, x->levels[0].text);
  }
}

TEST(Lower, TiesGoAwayFromZero) {
  const kernels::MaskTable t =
      table("mask:coefficients=\"0.1234567890123456785,-0.1234567890123456785,1\"", std::nullopt, 1, 18);
  EXPECT_EQ(t.limit.text[0], "0.123456789012345679");
  EXPECT_EQ(t.limit.text[1], "-0.123456789012345679");
  // The same number as w^2 c with w = sqrt(2), which balls cannot tell from a tie.
  const kernels::MaskTable u =
      table("mask:coefficients=\"w^2*0.1234567890123456785/2,w-w^3/2,1,w-w^3/2,w^2*0.1234567890123456785/2\"",
            std::nullopt, 1, 18, {{"w", "sqrt(2)"}});
  EXPECT_EQ(u.limit.text[0], "0.123456789012345679");
  EXPECT_EQ(u.limit.text[1], "0");
  // Doubles: 1 + 2^-53 is a tie to even.
  const kernels::MaskTable d = table("mask:coefficients=\"1+w^2/2^54,1-w^2/2^55,1,1-w^2/2^55,1+w^2/2^54\"",
                                     std::nullopt, 1, 0, {{"w", "sqrt(2)"}});
  EXPECT_EQ(d.limit.value[0], 1.0);
  EXPECT_EQ(d.limit.value[1], 1.0);
}

TEST(Lower, CarriesAndShortTexts) {
  const kernels::MaskTable t = table(
      "mask:coefficients=\"0.99999999999999999999999,9.9999999999999999999,1/3,10^25,10^-30/3\"", std::nullopt, 1, 17);
  const kernels::MaskTable u = table("mask:coefficients=\"-w,1,-w\"", std::nullopt, 1, 17, {{"w", "1-sqrt(2)*10^-25"}});
  EXPECT_EQ(t.limit.text[0], "1.0000000000000000");
  EXPECT_EQ(t.limit.text[1], "10.000000000000000");
  EXPECT_EQ(t.limit.text[2], "0.33333333333333333");
  EXPECT_EQ(t.limit.text[3], "1e25");
  EXPECT_EQ(t.limit.text[4], "3.3333333333333333e-31");
  EXPECT_EQ(u.limit.text[0], "-1.0000000000000000");
}

TEST(Lower, ExactZerosAreFound) {
  // Numerators of {1, x, e^{+-tx}, x e^{+-tx}} and others vanish at cosines: look for them over the families.
  int zeros = 0;
  for (const char* family : {"mixed", "harmonic", "resonant"})
    for (const char* l : {"3", "4"}) {
      const std::string name = std::string("interpolating:family=") + family + ",l=" + l;
      const Laurent a = symbol(make_scheme(name));
      for (size_t i = 0; i < a.coefficients().size(); ++i) {
        const Polynomial& n = a.coefficients()[i].numerator();
        if (n.is_constant()) continue;
        for (const auto& [f, e] : n.factor().factors)
          for (unsigned d = 5; d <= 24; ++d)
            for (long c = 1; 4 * c < static_cast<long>(d); ++c) {
              if (f != Polynomial::cosine_minimal("v", d) || Rational(c, d).denominator()[0] != static_cast<long>(d))
                continue;
              // v^1 = cos(2 pi c/d), v^0 = cos(4 pi c/d) if that is above -1.
              const std::string v0 = "cos(" + std::to_string(4 * c) + "*pi/" + std::to_string(d) + ")";
              const std::string message = refusal([&] {
                EXPECT_EQ(table(name, v0, 1, 30).levels[0].text[i], "0") << name << " " << v0;
                ++zeros;
              });
              EXPECT_TRUE(message.empty() || message.find("singular") != std::string::npos) << message;
            }
      }
    }
  EXPECT_GT(zeros, 0);
  // The rational v^{[1]} = 1/2.
  const Scheme s = make_scheme("interpolating:family=resonant,l=4");
  const kernels::MaskTable t = table("interpolating:family=resonant,l=4", "-1/2", 2, 17);
  const Laurent a = symbol(s);
  for (size_t i = 0; i < a.coefficients().size(); ++i)
    EXPECT_EQ(t.levels[0].text[i] == "0", a.coefficients()[i].evaluate({{"v", Rational(1, 2)}})->is_zero());
}

TEST(Lower, SingularStepsAreRefusedWithTheirLevel) {
  for (const char* family : {"mixed", "harmonic", "resonant"})
    for (unsigned l = 2; l <= 5; ++l) {
      const std::string name = std::string("interpolating:family=") + family + ",l=" + std::to_string(l);
      const SingularSet set = singular_set(*make_scheme(name).space);
      for (size_t n = 0; n < set.values.size(); ++n) {
        const auto& value = set.values[n];
        unsigned first = value.level;
        for (const auto& other : set.values)
          if (other.angle == value.angle) first = std::min(first, other.level);
        EXPECT_EQ(refusal([&] { table(name, value.exact(), value.level + 1, 20); }),
                  "the step at level k = " + std::to_string(first) + " is singular for v^0 = " + value.exact())
            << name;
        const std::string near = "cos(" + (value.angle + Rational(1, 100003)).to_string() + "*pi)";
        EXPECT_EQ(refusal([&] { table(name, near, value.level + 2, 20); }), "") << name << " " << near;
      }
    }
  // cos(2 pi/5) in other words.
  const std::string l4 = "interpolating:family=harmonic,l=4";
  EXPECT_EQ(refusal([&] { table(l4, "(sqrt(5)-1)/4", 1, 20); }),
            "the step at level k = 0 is singular for v^0 = (sqrt(5)-1)/4");
  const Scheme s = make_scheme(l4);
  EXPECT_EQ(refusal([&] {
              lower(s, lowering::bind(s, std::nullopt, "I*2*pi/5", {}), {2, 17, false, true});
            }),
            "the step at level k = 0 is singular for t = I*2*pi/5 (v^0 = 0.30901699437494742)");
  // A step after the last row has no tail; without one the rows are given.
  const std::string l5 = "interpolating:family=harmonic,l=5";
  const Scheme s5 = make_scheme(l5);
  int later = 0;
  for (const auto& value : singular_set(*s5.space).values) {
    const auto same = [&](const auto& o) { return o.angle == value.angle && o.level < value.level; };
    const auto& all = singular_set(*s5.space).values;
    if (value.level == 0 || std::any_of(all.begin(), all.end(), same)) continue;
    ++later;
    const Binding b = lowering::bind(s5, value.exact(), std::nullopt, {});
    EXPECT_NE(refusal([&] { lower(s5, b, {value.level, 17, false, true}); }), "");
    EXPECT_EQ(refusal([&] { lower(s5, b, {value.level, 17, false, false}); }), "");
  }
  EXPECT_GT(later, 0);
}

TEST(Lower, TailBoundsHoldAndAreTight) {
  for (const Start& c :
       {Start{"tension4", "-2/5"}, Start{"tension4", "1000"}, Start{"interpolating:family=harmonic,l=4", "-9/10"},
        Start{"interpolating:family=mixed,l=4", "cosh(3/5)"}, Start{"interpolating:family=resonant,l=3", "0"},
        Start{"mixed:n=2,arity=3", "4"}, Start{"harmonic:n=2", "-1/2"}})
    for (const unsigned levels : {1U, 2U, 5U, 30U}) {
      const Rational bound = test::exact_text(table(c.scheme, c.v0, levels, 40).tail_bound);
      const kernels::MaskTable t = table(c.scheme, c.v0, levels + 12, 60);
      Rational greatest;
      for (unsigned k = levels; k < levels + 12; ++k)
        for (size_t i = 0; i < t.limit.text.size(); ++i)
          greatest = std::max(greatest, abs(test::exact_text(t.levels[k].text[i]) - test::exact_text(t.limit.text[i])));
      EXPECT_LE(greatest, bound) << c.scheme << " " << c.v0 << " " << levels;
      EXPECT_LE(bound, greatest * Rational(3, 2)) << c.scheme << " " << c.v0 << " " << levels;
    }
  const char* two = "interpolating:space=\"1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)\"";
  const Named at{{"s", "3/5"}, {"t", "I*pi/2"}};
  const kernels::MaskTable t = table(two, std::nullopt, 6, 40, at);
  const Rational bound = test::exact_text(table(two, std::nullopt, 3, 40, at).tail_bound);
  Rational greatest;
  for (unsigned k = 3; k < 6; ++k)
    for (size_t i = 0; i < t.limit.text.size(); ++i)
      greatest = std::max(greatest, abs(test::exact_text(t.levels[k].text[i]) - test::exact_text(t.limit.text[i])));
  EXPECT_LE(greatest, bound);
  EXPECT_LE(bound, greatest * Rational(10));
}

TEST(Lower, PrecisionErrorIsABound) {
  EXPECT_EQ(table("tension4", "-2/5", 8, 50).precision_error, "5e-51");
  EXPECT_EQ(table("interpolating:family=mixed,l=3", "cosh(3/5)", 8, 17).precision_error, "5e-18");
  const kernels::MaskTable d = table("tension4", "-2/5", 8, 0);
  const kernels::MaskTable exact = table("tension4", "-2/5", 8, 60);
  Rational worst;
  for (size_t k = 0; k < 8; ++k)
    for (size_t i = 0; i < 7; ++i)
      worst = std::max(worst, abs(test::exact_text(d.levels[k].text[i]) - test::exact_text(exact.levels[k].text[i])));
  EXPECT_GT(worst, Rational(0));
  EXPECT_LE(worst, test::exact_text(d.precision_error));
  EXPECT_LE(test::exact_text(d.precision_error), Rational(2).pow(-52));
}

TEST(Lower, DoublesAreCorrectlyRounded) {
  const kernels::MaskTable d = table("interpolating:family=resonant,l=4", "cos(2*pi/7)", 30, 0);
  const kernels::MaskTable exact = table("interpolating:family=resonant,l=4", "cos(2*pi/7)", 30, 60);
  for (size_t k = 0; k < 30; ++k)
    for (size_t i = 0; i < d.levels[k].text.size(); ++i) {
      EXPECT_EQ(d.levels[k].value[i], std::strtod(exact.levels[k].text[i].c_str(), nullptr));
      EXPECT_EQ(d.levels[k].value[i], std::strtod(d.levels[k].text[i].c_str(), nullptr));
    }
  EXPECT_EQ(d.digits, 0);
  EXPECT_NO_THROW(kernels::validate(d));
}

TEST(Lower, Words) {
  const kernels::MaskTable t = table("interpolating:family=mixed,l=3", "-2/5", 2, 17);
  EXPECT_EQ(t.shift, "0");
  EXPECT_EQ(t.arity, 2);
  EXPECT_EQ(t.tail_from, 2);
  EXPECT_EQ(t.level_variables, (Named{{"v", "cosh(t/2^(k+1))"}}));
  EXPECT_EQ(t.recurrence, "v^{k+1} = sqrt((1 + v^k)/2)");
  EXPECT_EQ(t.normalisation, "coefficients sum to 2; every coset sums to 1 (constants are reproduced)");
  EXPECT_EQ(table("exponential-bspline:space=\"exp(t*x),exp(-t*x)\"", "2", 1, 17).normalisation,
            "coefficients sum to 2; not every coset sums to 1 (constants are not reproduced)");
  EXPECT_EQ(table("mask:coefficients=\"w,1,w\"", std::nullopt, 1, 17, {{"w", "1/3"}}).normalisation.substr(0, 30),
            "coefficients sum to 2*w + 1; n");
  EXPECT_EQ(table("bspline:n=2", std::nullopt, 1, 17).shift, "1/2");
}

TEST(Bind, FormsOfOneValue) {
  const Scheme s = make_scheme("tension4");
  const auto first = [&](const std::optional<std::string>& v0, const std::optional<std::string>& t,
                         const Named& at = {}) {
    return lower(s, lowering::bind(s, v0, t, at), {2, 25, false, true}).levels[1].text[0];
  };
  EXPECT_EQ(first(std::nullopt, "I*pi/3"), first("1/2", std::nullopt));
  EXPECT_EQ(first(std::nullopt, "-I*pi/3"), first("0.5", std::nullopt));
  EXPECT_EQ(first(std::nullopt, "pi/3*I"), first("cos(pi/3)", std::nullopt));
  EXPECT_EQ(first(std::nullopt, "3/5"), first("cosh(3/5)", std::nullopt));
  EXPECT_EQ(first(std::nullopt, "log(2)"), first("5/4", std::nullopt));
  EXPECT_EQ(first(std::nullopt, "acosh(7)"), first("7", std::nullopt));
  EXPECT_EQ(first(std::nullopt, "0"), first("1", std::nullopt));
  EXPECT_EQ(first(std::nullopt, std::nullopt, {{"t", "2/5"}}), first("cosh(2/5)", std::nullopt));
  EXPECT_EQ(first(std::nullopt, std::nullopt, {{"v0", "3"}}), first("3", std::nullopt));
  EXPECT_EQ(first("cos(12*pi/7)", std::nullopt), first("cos(2*pi/7)", std::nullopt));
  EXPECT_EQ(first("sqrt(2)*sqrt(2)+5", std::nullopt), first("7", std::nullopt));
  const Scheme c = make_scheme("interpolating:space=\"1,x,cos(s*x),sin(s*x)\"");
  EXPECT_EQ(lower(c, lowering::bind(c, std::nullopt, "pi/3", {}), {1, 25, false, true}).levels[0].text[0],
            lower(s, lowering::bind(s, "1/2", std::nullopt, {}), {1, 25, false, true}).levels[0].text[0]);
  const Scheme fixed = make_scheme("interpolating:space=\"1,x,cosh(x),sinh(x)\"");
  EXPECT_EQ(lower(fixed, lowering::bind(fixed, std::nullopt, std::nullopt, {}), {1, 25, false, true}).levels[0].text[0],
            lower(s, lowering::bind(s, "cosh(1)", std::nullopt, {}), {1, 25, false, true}).levels[0].text[0]);
}

TEST(Bind, Refusals) {
  const Scheme s = make_scheme("tension4");
  const auto why = [](const Scheme& scheme, const std::optional<std::string>& v0, const std::optional<std::string>& t,
                      const Named& at = {}) { return refusal([&] { lowering::bind(scheme, v0, t, at); }); };
  for (const char* bad : {"-1", "-3/2", "cos(pi)", "-cosh(0)", "-sqrt(2)"})
    EXPECT_EQ(why(s, bad, std::nullopt), std::string("v^0 must be greater than -1: ") + bad) << bad;
  for (const char* bad : {"I*pi", "-4*I", "I*22/7"})
    EXPECT_NE(why(s, std::nullopt, bad).find(bad), std::string::npos) << bad;
  for (const char* bad :
       {"x", "2+", "I", "1/0", "", "1+I", "acos(2)", "acosh(1/2)", "log(-1)", "1/(cos(pi/5)-(1+sqrt(5))/4)"})
    EXPECT_NE(why(s, bad, std::nullopt), "") << bad;
  EXPECT_NE(why(s, std::nullopt, "1+I").find("1+I"), std::string::npos);
  EXPECT_NE(why(s, "2", "1"), "");
  EXPECT_NE(why(s, std::nullopt, std::nullopt), "");
  EXPECT_NE(why(s, "2", std::nullopt, {{"t", "1"}}).find("twice"), std::string::npos);
  EXPECT_NE(why(s, "2", std::nullopt, {{"w", "1"}}).find("w"), std::string::npos);
  EXPECT_NE(why(make_scheme("dd:l=2"), "2", std::nullopt), "");
  const Scheme two = make_scheme("interpolating:space=\"1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)\"");
  EXPECT_NE(why(two, "2", std::nullopt), "");
  EXPECT_NE(why(two, std::nullopt, std::nullopt, {{"s", "1"}}).find("t"), std::string::npos);
  const Scheme fixed = make_scheme("interpolating:space=\"1,x,cosh(x),sinh(x)\"");
  EXPECT_NE(why(fixed, "2", std::nullopt).find("fixed"), std::string::npos);
  const Scheme mask = make_scheme("mask:coefficients=\"w,1,w\"");
  EXPECT_NE(why(mask, std::nullopt, std::nullopt).find("w"), std::string::npos);
}

}  // namespace
}  // namespace twoscale::lowering
