// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the checker: every token of good certificates is changed; stale digests are refused, re-sealed mutants
// accepted only if the oracle of oracle.hpp agrees that they are still true.
#include "mutants.hpp"
#include "oracle.hpp"
#include "samples.hpp"

#include <gtest/gtest.h>
#include <cstdlib>
#include <random>

namespace {

using samples::mutants;
using samples::reseal;
using twoscale::check::check_text;
using twoscale::check::Report;

/// The document without its labels, which are not statements.
std::string without_labels(const std::string& text) {
  auto document = twoscale::check::parse_json(text);
  for (std::size_t i = 0; i < document.keys.size(); ++i) {
    if (document.keys[i] == "scheme") document.items[i].text.clear();
    if (document.keys[i] != "variables") continue;
    for (auto& variable : document.items[i].items) variable.items.back().text.clear();
  }
  document.items.back().text.clear();
  return twoscale::check::canonical_json(document);
}

/// The oracle, asked once for each statement.
bool is_true(const std::string& text, std::map<std::string, bool>& known) {
  const auto [place, fresh] = known.try_emplace(without_labels(text));
  if (fresh) place->second = oracle::all_true(text);
  return place->second;
}

class Mutation : public testing::TestWithParam<std::pair<std::string, samples::Document>> {};

TEST_P(Mutation, StaleDigestIsRefused) {
  const std::string text = GetParam().second.sealed();
  ASSERT_EQ(check_text(text).status, Report::valid);
  for (const std::string& mutant : mutants(text)) {
    ASSERT_EQ(check_text(mutant).status, Report::malformed) << mutant;
  }
  for (std::size_t i = text.rfind("\"digest\""); i < text.size(); ++i) {  // the digest itself
    for (const char c : {'0', '1', 'a', 'f', 'F', '"', '\n'}) {
      std::string mutant = text;
      mutant[i] = c;
      ASSERT_TRUE(mutant == text || check_text(mutant).status == Report::malformed) << mutant;
    }
  }
}

TEST_P(Mutation, ResealedOnlyIfStillTrue) {
  std::map<std::string, bool> known;
  int accepted = 0, invalid = 0, malformed = 0, trivially = 0;
  const std::string text = GetParam().second.sealed();
  for (const std::string& unsealed : mutants(text)) {
    const std::string mutant = reseal(unsealed);
    const Report report = check_text(mutant);
    switch (report.status) {
      case Report::invalid: ++invalid; break;
      case Report::malformed: ++malformed; break;
      case Report::valid:
        if (mutant == text) {
          ++trivially;  // the change was undone by sealing
          break;
        }
        ++accepted;
        ASSERT_TRUE(is_true(mutant, known)) << mutant;
        break;
    }
  }
  const auto statements = static_cast<int>(known.size());
  RecordProperty("accepted", accepted);
  RecordProperty("invalid", invalid);
  RecordProperty("malformed", malformed);
  std::cout << GetParam().first << ": " << accepted << " still true (" << statements << " statements), " << invalid
            << " invalid, " << malformed << " malformed\n";
  EXPECT_GT(invalid, 0);
}

TEST_P(Mutation, RandomBytes) {
  const std::string text = GetParam().second.sealed();
  const char* scale = std::getenv("TWOSCALE_TEST_ROUNDS");
  const int rounds = 1500 * (scale != nullptr ? std::max(1, std::atoi(scale)) : 1);
  std::mt19937 random(2024);
  std::map<std::string, bool> known;
  const std::string alphabet = "0123456789+-*^/\"{}[],: \nvst_eE.xyz";
  for (int round = 0; round < rounds; ++round) {
    std::string mutant = text;
    const auto pick = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
    for (std::size_t changes = 1 + pick(4); changes > 0; --changes) {
      const std::size_t at = pick(mutant.size()), length = std::min(pick(6), mutant.size() - at);
      switch (pick(4)) {
        case 0: mutant[at] = alphabet[pick(alphabet.size())]; break;
        case 1: mutant.erase(at, length); break;
        case 2: mutant.insert(at, mutant.substr(pick(mutant.size()), pick(30))); break;
        default: mutant[at] = static_cast<char>(pick(256)); break;
      }
    }
    ASSERT_TRUE(mutant == text || check_text(mutant).status != Report::valid) << "round " << round << "\n" << mutant;
    mutant = reseal(mutant);
    ASSERT_TRUE(check_text(mutant).status != Report::valid || is_true(mutant, known)) << "round " << round << "\n"
                                                                                      << mutant;
  }
}

INSTANTIATE_TEST_SUITE_P(Samples, Mutation, testing::ValuesIn(samples::all()),
                         [](const auto& sample) { return sample.param.first; });

TEST(Oracle, AgreesOnTheSamplesAndSeesFalsehood) {
  for (const auto& [name, document] : samples::all()) EXPECT_TRUE(oracle::all_true(document.sealed())) << name;
  samples::Document wrong = samples::tension4();
  wrong.numerators[2] = wrong.numerators[4] = "4*v^2+4*v+2";
  EXPECT_FALSE(oracle::all_true(wrong.sealed()));
  wrong = samples::harmonic6();
  wrong.claims = {samples::well_defined(samples::angles({{0, "1/2"}}))};
  EXPECT_FALSE(oracle::all_true(wrong.sealed()));
  wrong.claims = {samples::well_defined(samples::angles({{0, "2/3"}, {1, "2/3"}, {0, "1/2"}}))};
  EXPECT_FALSE(oracle::all_true(wrong.sealed()));
}

}  // namespace
