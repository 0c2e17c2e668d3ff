// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the checker: every token of good certificates is changed; stale digests are refused, re-sealed mutants
// accepted only if the oracle of oracle.hpp agrees that they are still true.
#include "oracle.hpp"
#include "samples.hpp"

#include <gtest/gtest.h>
#include <cstdlib>
#include <random>
#include <set>

namespace {

using twoscale::check::check_text;
using twoscale::check::Report;

/// Replaces the digest of a changed text, if it still ends like a certificate.
std::string reseal(const std::string& text) {
  const std::size_t at = text.rfind("\"digest\": \"");
  if (at == std::string::npos) return text;
  return twoscale::check::sealed(text.substr(0, at) + "\"digest\": \"\"\n}\n");
}

/// Changes of the text: each character replaced, removed, doubled; each line removed, doubled, exchanged with the next;
/// each string replaced by each other string of the document; each integer by neighbours and some others.
std::set<std::string> mutants(const std::string& text) {
  std::set<std::string> result;
  const std::string body = text.substr(0, text.rfind("\"digest\""));
  const auto put = [&](std::size_t at, std::size_t length, const std::string& with) {
    std::string copy = text;
    copy.replace(at, length, with);
    result.insert(std::move(copy));
  };
  for (std::size_t i = 0; i < body.size(); ++i) {
    const char c = body[i];
    put(i, 1, "");
    put(i, 1, std::string(2, c));
    if (c >= '0' && c <= '9') {
      for (char d = '0'; d <= '9'; ++d) put(i, 1, std::string(1, d));
      put(i, 0, "-");
    } else if (c == '+' || c == '-' || c == '*' || c == '^' || c == '/') {
      for (const char d : {'+', '-', '*', '^', '/'}) put(i, 1, std::string(1, d));
    } else {
      for (const char d : {'a', 's', 't', 'v', '"', ',', ' ', '1', '_'}) put(i, 1, std::string(1, d));
    }
  }
  // lines
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at) + 1;
    lines.push_back(text.substr(at, end - at));
    at = end;
  }
  const auto join = [&](const std::vector<std::string>& list) {
    std::string all;
    for (const auto& line : list) all += line;
    result.insert(std::move(all));
  };
  for (std::size_t i = 0; i + 2 < lines.size(); ++i) {
    auto copy = lines;
    copy.erase(copy.begin() + static_cast<long>(i));
    join(copy);
    copy = lines;
    copy.insert(copy.begin() + static_cast<long>(i), lines[i]);
    join(copy);
    copy = lines;
    std::swap(copy[i], copy[i + 1]);
    join(copy);
  }
  // strings
  std::vector<std::pair<std::size_t, std::size_t>> strings;
  std::set<std::string> pool{"0", "1", "-1", "1/2", "2/3", "proved", "refuted", "yes", "no", ""};
  for (std::size_t at = body.find('"'); at != std::string::npos; at = body.find('"', at)) {
    std::size_t end = at + 1;
    while (body[end] != '"' || body[end - 1] == '\\') ++end;
    strings.emplace_back(at + 1, end - at - 1);
    if (end - at < 40) pool.insert(body.substr(at + 1, end - at - 1));
    at = end + 1;
  }
  for (const auto& [at, length] : strings) {
    for (const std::string& other : pool) put(at, length, other);
  }
  result.erase(text);
  return result;
}

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
