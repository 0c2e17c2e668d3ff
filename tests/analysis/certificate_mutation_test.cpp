// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates as `prove` writes them, changed token by token: every mutant is refused as it stands, and, sealed anew,
// every change of the mask is refused too: then it is the mathematics that refuses, not the seal.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cctype>

#include "twoscale/analysis/prove.hpp"
#include "twoscale/check/check.hpp"
#include "twoscale/symbolic/catalog.hpp"

namespace twoscale::analysis {
namespace {

using Json = nlohmann::ordered_json;

std::string certificate(const std::string& name) {
  const Scheme s = make_scheme(name);
  return prove(s, default_claims(s)).certificate;
}

std::string resealed(Json doc) {
  doc["digest"] = "";
  return check::sealed(doc.dump(1) + "\n");
}

bool accepted(const std::string& text) { return check::check_text(text).status == check::Report::valid; }

// Every maximal run of letters, of digits, and every other printing character, replaced by something else.
std::vector<std::string> token_mutants(const std::string& text) {
  std::vector<std::string> list;
  const auto kind = [](char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0   ? 1
           : std::isdigit(static_cast<unsigned char>(c)) != 0 ? 2
                                                              : 0;
  };
  for (size_t i = 0; i < text.size();) {
    if (std::isspace(static_cast<unsigned char>(text[i])) != 0) {
      ++i;
      continue;
    }
    size_t end = i + 1;
    while (kind(text[i]) != 0 && end < text.size() && kind(text[end]) == kind(text[i])) ++end;
    const std::string token = text.substr(i, end - i);
    std::vector<std::string> replacements;
    if (kind(text[i]) == 2) {
      replacements = {
          token + "0", token == "1" ? "2" : "1",
          token.back() == '7' ? token.substr(0, token.size() - 1) + "8" : token.substr(0, token.size() - 1) + "7", ""};
    } else if (kind(text[i]) == 1) {
      replacements = {token + "x", token.substr(1), "proved", "w"};
    } else {
      replacements = {"", token + token, token == "+" ? "-" : "+", ","};
    }
    for (const auto& r : replacements)
      if (r != token) list.push_back(text.substr(0, i) + r + text.substr(end));
    i = end;
  }
  return list;
}

class Mutation : public testing::TestWithParam<const char*> {};

TEST_P(Mutation, NoMutantStands) {
  const std::string text = certificate(GetParam());
  ASSERT_TRUE(accepted(text));
  const auto mutants = token_mutants(text);
  EXPECT_GT(mutants.size(), 500U);
  for (const auto& m : mutants) ASSERT_FALSE(accepted(m)) << m;
}

TEST_P(Mutation, AChangedMaskIsRefusedEvenSealedAnew) {
  const Json doc = Json::parse(certificate(GetParam()));
  const auto& numerators = doc["mask"]["numerators"];
  for (size_t i = 0; i < numerators.size(); ++i) {
    Json changed = doc;
    const std::string old = numerators[i];
    changed["mask"]["numerators"][i] = old == "0" ? "1" : old + "+1";
    EXPECT_FALSE(accepted(resealed(changed))) << i;
    changed["mask"]["numerators"][i] = old == "0" ? "7" : old.starts_with("-") ? old.substr(1) : "-" + old;
    EXPECT_FALSE(accepted(resealed(changed))) << i;
  }
  Json moved = doc;
  moved["mask"]["lowest"] = doc["mask"]["lowest"].get<int>() + 1;
  EXPECT_FALSE(accepted(resealed(moved)));
  Json shifted = doc;
  shifted["shift"] = doc["shift"] == "0" ? "1/2" : "0";
  EXPECT_FALSE(accepted(resealed(shifted)));
  Json ternary = doc;
  ternary["arity"] = 3;
  EXPECT_FALSE(accepted(resealed(ternary)));
}

TEST_P(Mutation, AChangedClaimIsRefusedEvenSealedAnew) {
  const Json doc = Json::parse(certificate(GetParam()));
  for (size_t i = 0; i < doc["claims"].size(); ++i) {
    const Json& claim = doc["claims"][i];
    Json refuted = doc;
    refuted["claims"][i]["verdict"] = "refuted";
    EXPECT_FALSE(accepted(resealed(refuted))) << claim;
    if (claim.contains("order")) {
      Json more = doc;
      more["claims"][i]["order"] = claim["order"].get<int>() + 1;
      EXPECT_FALSE(accepted(resealed(more))) << claim;
    }
    if (claim.contains("space") && (claim["claim"] == "reproduces" || claim["claim"] == "maximal"))
      for (size_t j = 0; j < claim["space"].size(); ++j) {
        Json more = doc;
        more["claims"][i]["space"][j]["order"] = claim["space"][j]["order"].get<int>() + 1;
        EXPECT_FALSE(accepted(resealed(more))) << claim;
      }
    if (claim.contains("exceptions"))
      for (const char* condition : {"v+1", "v-5"}) {  // cannot vanish on the domain; is no zero of what is claimed
        Json more = doc;
        more["claims"][i]["exceptions"].push_back(Json::object({{"condition", condition}}));
        EXPECT_FALSE(accepted(resealed(more))) << claim;
      }
    if (claim.contains("exceptions"))
      for (size_t j = 0; j < claim["exceptions"].size(); ++j) {
        Json fewer = doc;
        fewer["claims"][i]["exceptions"].erase(j);
        EXPECT_FALSE(accepted(resealed(fewer))) << claim;
        if (!claim["exceptions"][j].contains("level")) continue;
        Json other = doc;
        other["claims"][i]["exceptions"][j]["level"] = claim["exceptions"][j]["level"].get<int>() + 5;
        EXPECT_FALSE(accepted(resealed(other))) << claim;
      }
  }
}

INSTANTIATE_TEST_SUITE_P(Certificates, Mutation,
                         testing::Values("interpolating:family=mixed,l=3", "interpolating:family=harmonic,l=3",
                                         "dd:l=2", "mixed:n=2",
                                         "interpolating:space=\"1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)\"",
                                         // dual, in half the frequency; an exception that is a zero of a polynomial
                                         "dual:space=\"1,x,exp(t*x),exp(-t*x)\"",
                                         "quasi-spline:space=\"1,x,cos(s*x),sin(s*x),x*cos(s*x),x*sin(s*x)\",reproduce="
                                         "\"cos(s*x),sin(s*x),x*cos(s*x),x*sin(s*x)\""));

}  // namespace
}  // namespace twoscale::analysis
