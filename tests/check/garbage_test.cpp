// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the checker: bytes that are no certificate, and certificates made to cost time or memory.
#include "samples.hpp"

#include <gtest/gtest.h>
#include <chrono>
#include <cstdlib>
#include <ctime>

namespace {

using namespace samples;
using twoscale::check::check_text;
using twoscale::check::Report;

/// The status, and a generous bound on the time: the work limit of these tests corresponds to half a second.
Report::Status quickly(const std::string& text) {
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t cpu = std::clock();
  const Report report = check_text(text, 500'000'000);
  if (std::getenv("TWOSCALE_TEST_VERBOSE") != nullptr) {
    std::cout << report.work / 1000000 << "e6 units, " << static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC
              << " s: " << report.message.substr(0, 90) << "\n";
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(120)) << text.substr(0, 200);
  EXPECT_EQ(report.message.empty(), report.status == Report::valid);
  EXPECT_EQ(report.message.find('\n'), std::string::npos);
  return report.status;
}

TEST(Garbage, NoCertificateAtAll) {
  for (const std::string& text : std::vector<std::string>{
           "", " ", "\n", "{}", "[]", "0", "\"\"", "null", "{\n}\n", "\xef\xbb\xbf{}", std::string(1, '\0'),
           std::string(100, '\0'), std::string(1000, '['), std::string(1'000'000, '{'), std::string(1'000'000, '"'),
           std::string(5'000'000, '9'), "{\"a\":" + std::string(1'000'000, '1') + "}",
           std::string((std::size_t{64} << 20) + 1, ' ')}) {
    EXPECT_EQ(quickly(text), Report::malformed);
  }
}

TEST(Garbage, Truncations) {
  const std::string text = harmonic6().sealed();
  for (std::size_t length = 0; length < text.size(); ++length) {
    ASSERT_EQ(check_text(text.substr(0, length)).status, Report::malformed) << length;
    ASSERT_EQ(check_text(text.substr(length + 1)).status, Report::malformed) << length;
  }
  EXPECT_EQ(check_text(text + "\n").status, Report::malformed);
  EXPECT_EQ(check_text(text + text).status, Report::malformed);
}

TEST(Garbage, OtherSpellingsOfTheSameDocument) {
  const std::string text = tension4().sealed();
  std::string windows, compact;
  for (const char c : text) {
    if (c == '\n') windows += '\r';
    windows += c;
    if (c != '\n') compact += c;
  }
  EXPECT_EQ(check_text(windows).status, Report::malformed);
  EXPECT_EQ(check_text(compact).status, Report::malformed);
  EXPECT_EQ(check_text(text.substr(0, text.size() - 1)).status, Report::malformed);
}

TEST(Garbage, HugeNumbers) {
  const auto shift = [](const std::string& s) {
    Document d = cubic_bspline();
    d.shift = s;
    return quickly(d.sealed());
  };
  EXPECT_EQ(shift("1e999999999"), Report::malformed);
  EXPECT_EQ(shift(std::string(300'000, '9')), Report::malformed);
  EXPECT_EQ(shift(std::string(200'000, '9')), Report::malformed);
  EXPECT_EQ(shift("1/" + std::string(100'000, '9')), Report::malformed);
  EXPECT_EQ(shift("1000000/999999"), Report::malformed);
  const auto numerator = [](const std::string& s) {
    Document d = tension4();
    d.numerators[2] = s;
    return quickly(d.sealed());
  };
  for (const char* s : {"v^99999999", "v^4097", "1e999999999", "v^1e9", "9^99999999", "v^-1", "v^(9)"}) {
    EXPECT_EQ(numerator(s), Report::malformed) << s;
  }
  EXPECT_EQ(numerator(std::string(300'000, '9')), Report::malformed);
  EXPECT_EQ(numerator("v^4096+1"), Report::invalid);
  EXPECT_EQ(numerator(std::string(200'000, '9')), Report::invalid);
  const auto values = [](const std::string& y, long frequency, long power) {
    return quickly(tension4()
                       .with(claim("generates", "refuted",
                                   {{"space", space({{{frequency}, power + 1}})},
                                    {"witness", object({{"at", texts({y})},
                                                        {"frequency", numbers({frequency})},
                                                        {"power", number(power)},
                                                        {"residues", numbers({0, 1})},
                                                        {"values", texts({"1", "2"})}})}},
                                   "generation-stepwise"))
                       .sealed());
  };
  EXPECT_EQ(values("2", 3, 511), Report::invalid);
  EXPECT_NE(values("2", 1000000, 3), Report::valid);
  EXPECT_NE(values(std::string(200'000, '7'), 1, 1), Report::valid);
  EXPECT_NE(values(std::string(100'000, '7') + "/" + "1" + std::string(99'000, '0'), 1, 1), Report::valid);
}

TEST(Garbage, HugeIndicesAndFrequencies) {
  Document d = tension4();
  d.lowest = 1'000'000;
  EXPECT_EQ(quickly(d.sealed()), Report::invalid);
  d.lowest = 999'999;
  d.shift = "999999/1000";
  EXPECT_EQ(quickly(d.with(reproduces(space({{{-1000000}, 512}}), 512)).sealed()), Report::malformed);
  EXPECT_EQ(quickly(tension4().with(generates(space({{{1000000}, 512}}), array({}))).sealed()), Report::invalid);
  EXPECT_EQ(quickly(tension4().with(reproduces(space4(), 512)).sealed()), Report::invalid);
  EXPECT_EQ(quickly(tension4().with(well_defined(angles({{1000000, "1/2"}}))).sealed()), Report::invalid);
  EXPECT_EQ(quickly(tension4().with(well_defined(angles({{0, "999999/1000000"}}))).sealed()), Report::invalid);
}

TEST(Garbage, MuchWork) {
  // Long masks of high degree, many variables, a Sturm chain of high degree: all end, by an answer or by the work
  // limit.
  std::string dense;
  for (int d = 4096; d > 1; --d)
    dense += std::string(d % 3 == 0      ? "-"
                         : dense.empty() ? ""
                                         : "+") +
             std::to_string(d * 7 % 1000 + 2) + "*v^" + std::to_string(d);
  dense += "+3*v-5";
  Document d = tension4();
  d.numerators.assign(400, dense);
  d.denominator = dense;
  EXPECT_NE(quickly(d.with(generates(space({{{-9}, 512}, {{9}, 512}}), array({}))).sealed()), Report::valid);
  EXPECT_NE(quickly(d.with(well_defined(array({}))).sealed()), Report::valid);
  EXPECT_NE(quickly(d.with(well_defined(angles({{0, "4001/8009"}, {0, "1/8009"}}))).sealed()), Report::valid);
  EXPECT_NE(quickly(d.with(maximal(space({{{-9}, 512}, {{9}, 512}}), array({}))).sealed()), Report::valid);

  Document many;
  std::string product;
  for (const char c : std::string("abcdefgh")) {
    many.variables.push_back({std::string(1, c), "level", ""});
    product += (product.empty() ? "" : "*") + std::string(1, c) + "^4096";
  }
  many.numerators.assign(9, product);
  many.denominator = product;
  EXPECT_EQ(quickly(many.with(generates(space({{{1, 1, 1, 1, 1, 1, 1, 1}, 1}}), array({}))).sealed()),
            Report::malformed);
  EXPECT_NE(quickly(many.with(well_defined(conditions({"a*b-c", "a-b", "b^7-c"}), "positive-coefficients")).sealed()),
            Report::valid);

  Document wide = dd4();
  wide.arity = 64;
  wide.numerators.assign(4000, std::string(15'000, '7'));
  wide.claims.assign(100, generates(space({{{}, 512}}), array({})));
  EXPECT_NE(quickly(wide.sealed()), Report::valid);
}

}  // namespace
