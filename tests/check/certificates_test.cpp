// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the checker: hand-built certificates, what must be accepted and what must be refused, claim by claim.
#include "samples.hpp"
#include "twoscale/check/theorems.hpp"

#include <gtest/gtest.h>
#include <set>

namespace {

using namespace samples;
using twoscale::check::check_text;
using twoscale::check::Report;

void expect_valid(const Document& d) {
  const Report report = d.check();
  EXPECT_EQ(report.status, Report::valid) << report.message << "\n" << d.sealed();
}
void expect_invalid(const Document& d, const std::string& reason) {
  const Report report = d.check();
  EXPECT_EQ(report.status, Report::invalid) << report.message << "\n" << d.sealed();
  EXPECT_NE(report.message.find(reason), std::string::npos) << report.message;
}
void expect_malformed(const Document& d, const std::string& reason) {
  const Report report = d.check();
  EXPECT_EQ(report.status, Report::malformed) << report.message << "\n" << d.sealed();
  EXPECT_NE(report.message.find(reason), std::string::npos) << report.message;
  EXPECT_TRUE(report.lines.empty());
}

TEST(Certificates, SamplesAreValid) {
  for (const auto& [name, document] : all()) {
    SCOPED_TRACE(name);
    expect_valid(document);
  }
}

TEST(Certificates, TextFixedByteForByte) {
  // Written with another JSON library; the digest comes from another implementation of FNV-1a.
  const std::string text = R"({
 "format": "twoscale/certificate",
 "version": 1,
 "scheme": "dd:l=2",
 "arity": 2,
 "variables": [],
 "shift": "0",
 "mask": {
  "lowest": -3,
  "numerators": [
   "-1",
   "0",
   "9",
   "16",
   "9",
   "0",
   "-1"
  ],
  "denominator": "16"
 },
 "claims": [
  {
   "claim": "interpolatory",
   "verdict": "proved",
   "theorem": "definition"
  },
  {
   "claim": "reproduces",
   "verdict": "proved",
   "space": [
    {
     "frequency": [],
     "order": 4
    }
   ],
   "confluent": 0,
   "theorem": "reproduction-stepwise"
  },
  {
   "claim": "well-defined",
   "verdict": "proved",
   "exceptions": [],
   "theorem": "sturm"
  }
 ],
 "digest": "fnv1a64:190be64f174dec62"
}
)";
  const Report report = check_text(text);
  EXPECT_EQ(report.status, Report::valid) << report.message;
  EXPECT_EQ(report.message, "");
}

TEST(Certificates, DigestIsFnv1a) {
  EXPECT_EQ(twoscale::check::digest(""), "fnv1a64:cbf29ce484222325");
  EXPECT_EQ(twoscale::check::digest("a"), "fnv1a64:af63dc4c8601ec8c");
  EXPECT_EQ(twoscale::check::digest("foobar"), "fnv1a64:85944171f73967e8");
  EXPECT_EQ(twoscale::check::sealed("nothing to seal"), "nothing to seal");
}

TEST(Report, NamesTheUncheckedLabelTheSubjectAndTheTheorem) {
  const Report report = tension4().check();
  ASSERT_EQ(report.status, Report::valid);
  EXPECT_NE(report.lines.front().find("\"tension4\" is not checked"), std::string::npos) << report.lines.front();
  std::string all_lines;
  for (const auto& line : report.lines) all_lines += line + "\n";
  EXPECT_NE(
      all_lines.find("proved   reproduces {1, x, exp(t*x), exp(-t*x)}: identity verified; the limit mask reproduces "
                     "polynomials of degree < 4; trusting [reproduction-stepwise] (Conti-Romani 2011; "
                     "Dyn-Levin-Luzzatto 2003)\n"),
      std::string::npos)
      << all_lines;
  EXPECT_EQ(report.lines.back(), "valid: 7 claim(s)");
  for (const char* key : {"definition", "generation-stepwise", "reproduction-stepwise", "hurwitz-count", "sturm"}) {
    EXPECT_NE(all_lines.find("\n[" + std::string(key) + "] "), std::string::npos) << key;
  }
}

TEST(Report, SubjectsComeFromTheData) {
  Document d = two_frequencies();
  const Report report = d.with(reproduces(space_two(1), 0)).check();
  ASSERT_EQ(report.status, Report::valid);
  EXPECT_NE(report.lines.at(2).find("{1, x, exp(s*x), exp(-s*x), exp(t*x), exp(-t*x)}"), std::string::npos);
  EXPECT_NE(harmonic6().check().lines.at(7).find("except v^0 = -1/2 at level 0, v^0 = 0 at level 0"),
            std::string::npos);
  d = refuted();
  EXPECT_NE(d.check().lines.at(2).find("refuted  sum-rules of order 3"), std::string::npos);
}

TEST(Report, EveryClaimIsReportedWhenOneFails) {
  Document d = dd4();
  d.claims[2] = sum_rules(5, "no");
  const Report report = d.check();
  EXPECT_EQ(report.status, Report::invalid);
  EXPECT_EQ(report.message.substr(0, 27), "claim 3 (sum-rules, proved)");
  EXPECT_NE(report.lines.at(4).find("REFUSED  claim 3"), std::string::npos);
  EXPECT_NE(report.lines.at(5).find("proved   generates"), std::string::npos);
  EXPECT_EQ(report.lines.back(), "invalid: " + report.message);
}

TEST(Report, WorkIsCountedAndLimited) {
  const std::string text = harmonic6().sealed();
  const Report report = check_text(text);
  EXPECT_GT(report.work, 100'000U);
  EXPECT_LT(report.work, 3'000'000U);  // some milliseconds
  EXPECT_EQ(check_text(text, report.work).status, Report::valid);
  EXPECT_EQ(check_text(text, report.work - 1).status, Report::malformed);
  EXPECT_EQ(check_text(text, 0).status, Report::malformed);
}

TEST(Report, TheoremsAreStatedOnceEach) {
  std::set<std::string_view> keys;
  for (const auto& t : twoscale::check::theorems()) {
    EXPECT_TRUE(keys.insert(t.key).second);
    EXPECT_GT(t.statement.size(), 100U);
  }
  EXPECT_EQ(keys.size(), 17U);
}

TEST(Interpolatory, Refusals) {
  expect_invalid(cubic_bspline().with(interpolatory()), "a_{-2} is not 0");
  Document d = dd4().with(interpolatory());
  d.numerators[3] = "15";
  expect_invalid(d, "a_{0} is not 1");
  d = dd4().with(interpolatory());
  d.lowest = 1;
  expect_invalid(d, "outside the support");
  d = dd4().with(interpolatory());
  d.arity = 3;
  expect_invalid(d, "a_{-3} is not 0");
}

TEST(Symmetric, Refusals) {
  expect_invalid(dd4().with(symmetric("1/2")), "middle of the support");
  expect_malformed(dd4().with(symmetric("0/1")), "lowest terms");
  expect_invalid(refuted_mask().with(symmetric("1/2")), "not symmetric");
}

TEST(SumRules, Refusals) {
  expect_valid(dd4().with(sum_rules(4, "no")));
  expect_valid(dd4().with(sum_rules(3, "no")));
  expect_valid(dd4().with(sum_rules(0, "no")));
  expect_invalid(dd4().with(sum_rules(3, "yes")), "not exact");
  expect_invalid(dd4().with(sum_rules(5, "no")), "i^4");
  expect_malformed(dd4().with(sum_rules(2, "maybe")), "exact");
  expect_malformed(dd4().with(sum_rules(513, "no")), "order");
}

TEST(Generates, Refusals) {
  expect_invalid(cubic_bspline().with(generates(space({{{}, 5}}), array({}))), "identity fails");
  expect_invalid(tension4().with(generates(space({{{2}, 1}}), array({}))), "identity fails");
  expect_invalid(tension4().with(generates(space({{{0}, 3}}), array({}))), "identity fails");
  expect_invalid(tension4().with(generates(space4(), angles({{0, "1/2"}}))), "is not a zero of a(z)");
  // poles must be listed: a(z) = 2 z^e, so the zeros of the denominator are those of the numerator of a(z)
  expect_invalid(harmonic6().with(generates(space6(), array({}))), "zero on the domain");
  expect_invalid(harmonic6().with(generates(space6(), angles({{0, "2/3"}}))), "zero on the domain");
  expect_invalid(harmonic6().with(generates(space6(), angles({{0, "2/3"}, {0, "1/2"}, {0, "1/3"}}))), "not a zero");
  expect_malformed(harmonic6().with(generates(space6(), angles({{0, "1/2"}, {0, "2/3"}}))), "sorted");
  expect_malformed(harmonic6().with(generates(space6(), angles({{0, "1/2"}, {0, "1/2"}}))), "sorted");
  expect_malformed(tension4().with(generates(space({{{1}, 1}, {{-1}, 1}}), array({}))), "ascending");
  expect_malformed(tension4().with(generates(space({{{1}, 1}, {{1}, 1}}), array({}))), "distinct");
  expect_malformed(tension4().with(generates(space({{{}, 1}}), array({}))), "frequency");
  expect_malformed(tension4().with(generates(array({}), array({}))), "empty");
}

TEST(Generates, SymbolThatVanishes) {
  // The dual mask times 2v - 1 (over 2v + 2): the identities stay, a(z) = 0 for v = 1/2, v^0 = -1/2.
  Document d = dual_odd();
  const Value v = space({{{-1}, 1}, {{0}, 1}, {{1}, 1}});
  d.numerators = {"2*v-1", "4*v^2-1", "4*v^2-1", "2*v-1"};
  expect_invalid(d.with(generates(v, array({}))), "zero on the domain");
  expect_valid(d.with(generates(v, angles({{0, "2/3"}}))));
  expect_valid(d.with(well_defined(array({}))));
  expect_invalid(d.with(well_defined(angles({{0, "2/3"}}))), "not a zero");
  // times v - 1: zero at every level for v^0 = 1; times v - 2: hyperbolic
  d.numerators = {"v-1", "2*v^2-v-1", "2*v^2-v-1", "v-1"};
  expect_invalid(d.with(generates(v, array({}))), "zero on the domain");
  d.numerators = {"v-2", "2*v^2-3*v-2", "2*v^2-3*v-2", "v-2"};
  expect_invalid(d.with(generates(v, array({}))), "zero on the domain");
  // times v + 2: no zero on the domain
  d.numerators = {"v+2", "2*v^2+5*v+2", "2*v^2+5*v+2", "v+2"};
  expect_valid(d.with(generates(v, array({}))));
  // times v^2 - 2v + 2: complex zeros, where Descartes' rule does not decide and Sturm's theorem does
  d.numerators = {"v^2-2*v+2", "2*v^3-3*v^2+2*v+2", "2*v^3-3*v^2+2*v+2", "v^2-2*v+2"};
  expect_valid(d.with(generates(v, array({}))));
  // the zero mask sum: 1 - z generates nothing
  Document z;
  z.numerators = {"1", "1", "-1", "-1"};
  expect_invalid(z.with(generates(space({{{}, 1}}), array({}))), "identically zero");
}

TEST(Generates, AllLevelsOfAnException) {
  // v = cos(pi/5) is on the domain at level 0 (v^0 = cos(2pi/5)) and at level 1 (v^0 = cos(4pi/5)); 4v^2-2v-1 is its
  // polynomial.
  Document d = dual_odd();
  const Value v = space({{{-1}, 1}, {{0}, 1}, {{1}, 1}});
  d.numerators = {"4*v^2-2*v-1", "8*v^3-4*v-1", "8*v^3-4*v-1", "4*v^2-2*v-1"};
  expect_valid(d.with(generates(v, angles({{1, "4/5"}, {0, "2/5"}}))));
  expect_invalid(d.with(generates(v, angles({{0, "2/5"}}))), "also vanishes");
  expect_invalid(d.with(generates(v, angles({{1, "4/5"}}))), "also vanishes");
  expect_invalid(d.with(generates(v, angles({{0, "4/5"}, {0, "2/5"}}))), "also vanishes");
  expect_invalid(d.with(generates(v, array({}))), "not listed");
  d.arity = 3;  // other levels: v = cos(pi/5) < cos(pi/3^2)
  expect_invalid(d.with(generates(v, angles({{1, "4/5"}, {0, "2/5"}}))), "identity fails");
}

TEST(Generates, SeveralFrequenciesNeedAReasonForNonVanishing) {
  // exp((s+t)x): a(z) is not a polynomial in v_s, v_t; refused even where the identities hold.
  Document d;
  d.variables = {{"v_s", "level", ""}, {"v_t", "level", ""}};
  d.lowest = -1;
  d.numerators = {"1", "2", "1"};
  d.denominator = "2";
  expect_valid(d.with(generates(space({{{0, 0}, 2}}), array({}))));
  expect_invalid(d.with(generates(space({{{0, 0}, 2}}), conditions({"v_s-2"}))), "does not divide");
  expect_invalid(d.with(generates(space({{{0, 0}, 2}}), conditions({"v_s+v_t"}))), "cannot vanish");
  expect_invalid(two_frequencies_conditions().with(generates(space_two(2), conditions({"2*v_t^2-1"}))), "of one sign");
  expect_malformed(d.with(generates(space({{{0, 0}, 2}}), conditions({"2*v_s-4"}))), "primitive");
  expect_malformed(d.with(generates(space({{{0, 0}, 2}}), conditions({"-v_s+2"}))), "leading");
  expect_malformed(d.with(generates(space({{{0, 0}, 2}}), conditions({"v_t-1", "v_s-1"}))), "sorted");
}

TEST(Reproduces, Refusals) {
  expect_invalid(cubic_bspline().with(reproduces(space({{{}, 3}}), 0)), "identity fails");
  expect_invalid(cubic_bspline().with(reproduces(space({{{}, 1}}), 3)), "limit mask");
  expect_invalid(tension4().with(reproduces(space4(), 5)), "limit mask");
  expect_valid(tension4().with(reproduces(space4(), 0)));
  Document d = dual().with(reproduces(space({{{}, 2}}), 0));
  d.shift = "0";
  expect_invalid(d, "identity fails");
  d.shift = "1/3";
  expect_invalid(d, "identity fails");
  d = dual_exponential().with(reproduces(space({{{-2}, 1}, {{2}, 1}}), 0));
  d.shift = "-1/2";
  expect_invalid(d, "identity fails");
  d.shift = "1/2000";
  expect_malformed(d, "shift");
  d = tension4().with(reproduces(space4(), 1));
  d.denominator = "8*v^2-8*v";  // 0 for v = 1
  expect_invalid(d, "identity fails");
  Document t = ternary();
  t.shift = "1/2";
  expect_invalid(t.with(reproduces(space({{{0}, 1}}), 2)), "limit mask");
}

TEST(Reproduces, DenominatorOfTheLimit) {
  Document d;  // the same mask over v - 1
  d.variables = {{"v", "level", ""}};
  d.lowest = -1;
  d.numerators = {"v-1", "2*v-2", "v-1"};
  d.denominator = "2*v-2";
  expect_valid(d.with(reproduces(space({{{0}, 2}}), 0)));
  expect_invalid(d.with(reproduces(space({{{0}, 2}}), 2)), "denominator vanishes");
  expect_invalid(d.with(maximal(space({{{0}, 2}}), space({{{0}, 2}}))), "denominator vanishes");
  expect_invalid(d.with(well_defined(array({}))), "zero on the domain");
}

TEST(Maximal, Refusals) {
  expect_invalid(cubic_bspline().with(maximal(space({{{}, 3}}), space({{{}, 2}}))), "sum rules of order 4 at least");
  expect_invalid(cubic_bspline().with(maximal(space({{{}, 4}}), space({{{}, 1}}))), "more is reproduced");
  expect_invalid(cubic_bspline().with(maximal(space({{{}, 4}}), array({}))), "more is reproduced");
  expect_invalid(cubic_bspline().with(maximal(space({{{}, 4}}), space({{{}, 3}}))), "not reproduced");
  expect_invalid(cubic_bspline().with(maximal(space({{{}, 5}}), space({{{}, 2}}))), "not generated");
  expect_invalid(tension4().with(maximal(space({{{0}, 2}}), space({{{0}, 2}}))), "sum rules of order 3 at least");
  expect_invalid(tension4().with(maximal(space4(), space({{{-1}, 1}, {{0}, 2}}))), "more is reproduced");
  expect_invalid(tension4().with(maximal(space4(), space({{{-1}, 1}, {{0}, 2}, {{1}, 1}, {{2}, 1}}))),
                 "not in the generated");
  Document d;  // reproduces nothing: constants come out doubled
  d.lowest = -1;
  d.numerators = {"1", "2", "1"};
  expect_valid(d.with(maximal(space({{{}, 2}}), array({}))));
  d.numerators = {"1", "1", "-1", "-1"};
  expect_invalid(d.with(maximal(space({{{}, 1}}), array({}))), "identically zero");
}

TEST(WellDefined, Refusals) {
  expect_invalid(harmonic6().with(well_defined(array({}))), "not listed");
  expect_invalid(harmonic6().with(well_defined(angles({{0, "1/2"}}))), "not listed");
  expect_invalid(harmonic6().with(well_defined(angles({{0, "2/3"}, {0, "1/2"}, {1, "1/2"}}))), "not a zero");
  expect_invalid(harmonic6().with(well_defined(angles({{0, "2/3"}, {0, "1/2"}, {50, "1/3"}}))), "degrees");
  expect_malformed(harmonic6().with(well_defined(angles({{0, "1"}}))), "between 0 and 1");
  expect_malformed(harmonic6().with(well_defined(angles({{0, "0"}}))), "between 0 and 1");
  expect_malformed(harmonic6().with(well_defined(angles({{-1, "1/2"}}))), "level");
  expect_invalid(harmonic6().with(well_defined(conditions({"v"}))), "cannot vanish");  // v = 0 is the end of the domain
  expect_malformed(harmonic6().with(well_defined(array({}), "positive-coefficients")), "\"sturm\" is expected");
  expect_invalid(two_frequencies_conditions().with(well_defined(array({}), "positive-coefficients")), "of one sign");
  expect_invalid(two_frequencies_conditions().with(well_defined(conditions({"2*v_t^2-1"}), "positive-coefficients")),
                 "of one sign");
  expect_invalid(two_frequencies_conditions().with(
                     well_defined(conditions({"2*v_t^2-1", "v_s+2*v_t^2-1", "v_s-3"}), "positive-coefficients")),
                 "does not divide");
  // v = 1/2 is no pole: numerators vanish as well
  Document d;
  d.variables = {{"v", "level", ""}};
  d.numerators = {"2*v-1", "2*v-1"};
  d.denominator = "2*v-1";
  expect_invalid(d.with(well_defined(angles({{0, "2/3"}}))), "all numerators vanish");
  expect_invalid(d.with(well_defined(array({}))), "not listed");
  d.numerators = {"2*v-1", "2*v"};
  expect_valid(d.with(well_defined(angles({{0, "2/3"}}))));
  d.denominator = "2*v^2-v";  // v = 0 is the open end of the domain
  expect_valid(d.with(well_defined(angles({{0, "2/3"}}))));
  d.arity = 3;  // the domain begins at 1/2
  expect_valid(d.with(well_defined(array({}))));
  expect_invalid(d.with(well_defined(angles({{0, "2/3"}}))), "not a zero");
  d.denominator = "v-1";
  expect_invalid(d.with(well_defined(array({}))), "not listed");
  d.denominator = "v^2-3";  // v^0 hyperbolic, at one level only; cannot be expressed as an angle
  expect_invalid(d.with(well_defined(array({}))), "not listed");
  d.variables = {{"c", "constant", ""}};
  d.numerators = {"1", "c"};
  d.denominator = "c^2+1";  // a constant may be any real number: not decided by the signs of coefficients
  expect_invalid(d.with(well_defined(array({}), "positive-coefficients")), "constants remain");
  expect_valid(d.with(well_defined(conditions({"c^2+1"}), "positive-coefficients")));
}

/// T_3[x, y] is negative for small x, y and positive where x, y > cos(pi/3); x^2 + y^2 - 1 needs the irrational
/// cos(pi/4).
TEST(WellDefined, SeveralVariablesOfHigherArity) {
  Document d;
  d.variables = {{"v_s", "level", ""}, {"v_t", "level", ""}};
  d.numerators = {"v_s", "v_t"};
  const std::string ternary = "4*v_s^2+4*v_s*v_t+4*v_t^2-3";
  const std::string quaternary = "v_s^2+v_t^2-1";
  for (const auto& [denominator, from] : {std::pair{ternary, 3}, {quaternary, 4}}) {
    d.denominator = denominator;
    for (int m = 2; m <= 6; ++m) {
      d.arity = m;
      if (m >= from) {
        expect_valid(d.with(well_defined(array({}), "positive-coefficients")));
        expect_invalid(d.with(well_defined(conditions({denominator}), "positive-coefficients")), "cannot vanish");
      } else {
        expect_invalid(d.with(well_defined(array({}), "positive-coefficients")), "of one sign");
        expect_valid(d.with(well_defined(conditions({denominator}), "positive-coefficients")));
      }
    }
  }
  d.arity = 4;  // a little more than 2 cos(pi/4)^2
  d.denominator = "1000*v_s^2+1000*v_t^2-1001";
  expect_invalid(d.with(well_defined(array({}), "positive-coefficients")), "of one sign");
  d.denominator = "v_s^2-v_s*v_t+v_t^2-1";  // 0 at (1, 1): cannot be shown to be of one sign
  expect_invalid(d.with(well_defined(array({}), "positive-coefficients")), "of one sign");
}

TEST(Refuted, WitnessesThatDoNotServe) {
  const auto at = texts({"2"});
  const auto sums = [&](long order, long power, std::vector<long> residues, std::vector<std::string> values,
                        const std::string& y = "2") {
    return tension4().with(claim("sum-rules", "refuted",
                                 {{"order", number(order)},
                                  {"witness", object({{"at", texts({y})},
                                                      {"power", number(power)},
                                                      {"residues", numbers(residues)},
                                                      {"values", texts(values)}})}},
                                 "definition"));
  };
  expect_valid(sums(3, 2, {0, 1}, {"0", "13/45"}));
  expect_valid(sums(3, 2, {1, 0}, {"13/45", "0"}));
  expect_valid(sums(7, 2, {0, 1}, {"0", "13/45"}));
  expect_valid(sums(3, 2, {0, 1}, {"0", "13/45"}, "1/2"));
  expect_invalid(sums(3, 2, {0, 1}, {"0", "13/45"}, "3"), "residue class 1");
  expect_invalid(sums(3, 2, {0, 1}, {"0", "14/45"}), "residue class 1");
  expect_invalid(sums(3, 2, {1, 0}, {"0", "13/45"}), "residue class 1");
  expect_invalid(sums(3, 0, {0, 1}, {"1", "1"}), "equal");
  expect_invalid(sums(3, 2, {0, 0}, {"0", "0"}), "equal");
  expect_malformed(sums(2, 2, {0, 1}, {"0", "13/45"}), "power");
  expect_malformed(sums(3, 2, {0, 2}, {"0", "0"}), "residues");
  expect_malformed(sums(3, 2, {0}, {"0"}), "two residues");
  expect_malformed(sums(3, 2, {0, 1}, {"0", "26/90"}), "lowest terms");
  expect_malformed(sums(3, 2, {0, 1}, {"0", "13/45"}, "0"), "0 for a level variable");
  expect_invalid(sums(3, 2, {0, 1}, {"0", "13/45"}, "-1"), "denominator of the mask vanishes");  // v = -1

  const auto generated = [&](long frequency, long power, std::vector<std::string> values) {
    return tension4().with(claim("generates", "refuted",
                                 {{"space", space({{{0}, 3}, {{1}, 2}})},
                                  {"witness", object({{"at", at},
                                                      {"frequency", numbers({frequency})},
                                                      {"power", number(power)},
                                                      {"residues", numbers({0, 1})},
                                                      {"values", texts(values)}})}},
                                 "generation-stepwise"));
  };
  expect_valid(generated(0, 2, {"0", "13/45"}));
  expect_valid(generated(1, 1, {"0", "7/30"}));
  expect_invalid(generated(1, 0, {"1", "1"}), "equal");
  expect_invalid(generated(1, 2, {"0", "1"}), "do not occur");
  expect_invalid(generated(2, 0, {"1", "2"}), "do not occur");

  // Half-integer powers of E: at Y = 2, E = 4, v = 17/8; sum of a_i z^{i-1/2} over even i for frequency 1.
  const auto half = [&](const std::string& value, long frequency) {
    return dual_exponential().with(claim("reproduces", "refuted",
                                         {{"space", space({{{frequency}, 1}})},
                                          {"witness", object({{"at", at},
                                                              {"frequency", numbers({frequency})},
                                                              {"power", number(0)},
                                                              {"residue", number(0)},
                                                              {"value", text(value)}})}},
                                         "reproduction-stepwise"));
  };
  // a_0 = (4v^2-1)/D, a_2 = 1/D, D = 8v^3-4v = 4369/64, 4v^2-1 = 273/16; z = 1/4: a_0*2 + a_2/8 = 2192/4369... exactly
  // (273/8 + 1/8)*64/4369 = 274*8/4369.
  expect_valid(half("2192/4369", 1));
  expect_invalid(half("2191/4369", 1), "residue class 0");
  expect_invalid(half("1", 2), "the one of a reproducing mask");

  const auto larger = [&](Value v, Value w) {
    return tension4().with(claim("maximal", "refuted",
                                 {{"space", std::move(v)}, {"witness", object({{"larger", std::move(w)}})}},
                                 "hurwitz-count"));
  };
  expect_valid(larger(space({{{0}, 2}}), space({{{1}, 1}})));
  expect_invalid(larger(space({{{0}, 2}}), space({{{0}, 2}})), "contained");
  expect_invalid(larger(space4(), space({{{0}, 2}, {{1}, 1}})), "contained");
  expect_invalid(larger(space4(), space({{{0}, 3}})), "not generated");
  Document zero;  // all coset sums vanish: the identities hold, but nothing is generated
  zero.numerators = {"1", "1", "-1", "-1"};
  expect_invalid(zero.with(claim("maximal", "refuted",
                                 {{"space", space({{{}, 1}})}, {"witness", object({{"larger", space({{{}, 2}})}})}},
                                 "hurwitz-count")),
                 "identically zero");

  const auto pole = [&](long level, const std::string& angle) {
    return harmonic6().with(claim("well-defined", "refuted",
                                  {{"witness", object({{"level", number(level)}, {"angle", text(angle)}})}}, "sturm"));
  };
  expect_valid(pole(0, "1/2"));
  expect_invalid(pole(1, "1/2"), "does not vanish");
  expect_invalid(pole(1000, "1/2"), "does not vanish");
  expect_malformed(two_frequencies().with(claim("well-defined", "refuted",
                                                {{"witness", object({{"level", number(0)}, {"angle", text("1/2")}})}},
                                                "positive-coefficients")),
                   "exactly one variable");
  const auto interpolation = [&](long index, const std::string& value) {
    return refuted_mask().with(claim(
        "interpolatory", "refuted",
        {{"witness", object({{"at", array({})}, {"index", number(index)}, {"value", text(value)}})}}, "definition"));
  };
  expect_valid(interpolation(0, "1/2"));
  expect_invalid(interpolation(0, "1"), "not a_{0}");
  expect_invalid(interpolation(1, "1"), "multiple");
  expect_invalid(interpolation(2, "0"), "the one of an interpolatory");
}

TEST(Head, Refusals) {
  const auto change = [](const auto& edit, const std::string& reason) {
    Document d = tension4();
    edit(d);
    expect_malformed(d, reason);
  };
  change([](Document& d) { d.arity = 1; }, "arity");
  change([](Document& d) { d.arity = 65; }, "arity");
  change([](Document& d) { d.variables[0].name = "2v"; }, "name");
  change([](Document& d) { d.variables[0].scope = "local"; }, "scope");
  change([](Document& d) { d.variables[0].name = "w"; }, "numerators[2]");
  change([](Document& d) { d.variables.insert(d.variables.begin(), d.variables[0]); }, "sorted");
  change([](Document& d) { d.shift = "0.5"; }, "shift");
  change([](Document& d) { d.numerators.front() = "0"; }, "first and the last");
  change([](Document& d) { d.numerators.back() = "0"; }, "first and the last");
  change([](Document& d) { d.numerators.clear(); }, "numerators");
  change([](Document& d) { d.denominator = "0"; }, "denominator");
  change([](Document& d) { d.denominator = "-8*v^2-8*v"; }, "denominator");
  change([](Document& d) { d.denominator = "8*v+8*v^2"; }, "descend");
  change([](Document& d) { d.claims.clear(); }, "claims");
  change(
      [](Document& d) {
        d.lowest = 1000000;
        d.claims = {claim("holds", "proved", {}, "definition")};
      },
      "unknown claim");
  change([](Document& d) { d.claims = {claim("symmetric", "undecided", {}, "definition")}; }, "verdict");
  change([](Document& d) { d.claims = {claim("interpolatory", "proved", {}, "sturm")}; }, "theorem");
  change(
      [](Document& d) {
        d.claims = {claim("interpolatory", "proved", {{"note", text("")}}, "definition")};
      },
      "theorem");
  change([](Document& d) { d.scheme = std::string(5000, 'x'); }, "scheme");
}

}  // namespace
