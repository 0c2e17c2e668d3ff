// SPDX-License-Identifier: GPL-3.0-or-later
/// Claims about vertices with derivatives: what is decided, and certificates of which every number matters.
#include "twoscale/analysis/hermite_claims.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "twoscale/check/check.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::analysis {
namespace {

using Json = nlohmann::ordered_json;

Proof proof_of(const std::string& name, const std::vector<Claim>& claims = {}) {
  const Scheme s = make_scheme(name);
  return prove(s, claims.empty() ? default_claims(s) : claims);
}

Verdict verdict_of(const std::string& name, const Claim& claim) { return proof_of(name, {claim}).decisions[0].verdict; }

check::Report checked(Json doc) {
  doc["digest"] = "";
  return check::check_text(check::sealed(doc.dump(1) + "\n"));
}

bool accepted(const Json& doc) { return checked(doc).status == check::Report::valid; }

TEST(HermiteClaims, OnlyThePrintedTensionFallsShortOfC2) {
  for (const char* name : {"hermite-circle", "hermite-circle:variant=c2,w=7/5", "hermite-circle:variant=c2"}) {
    EXPECT_EQ(verdict_of(name, {"continuity", "2", ""}), Verdict::proved) << name;
    EXPECT_EQ(verdict_of(name, {"circle", "", ""}), Verdict::proved) << name;
    EXPECT_EQ(verdict_of(name, {"continuity", "3", ""}), Verdict::refuted) << name;
  }
  for (const char* name : {"hermite-circle:w=7/5", "hermite-circle:w=1/100"}) {
    EXPECT_EQ(verdict_of(name, {"continuity", "1", ""}), Verdict::proved) << name;
    EXPECT_EQ(verdict_of(name, {"continuity", "2", ""}), Verdict::refuted) << name;
    EXPECT_EQ(verdict_of(name, {"curvature", "", ""}), Verdict::proved) << name;
    EXPECT_EQ(verdict_of(name, {"circle", "", ""}), Verdict::refuted) << name;
  }
  EXPECT_EQ(verdict_of("hermite-circle", {"spectral", "5", ""}), Verdict::proved);
  EXPECT_EQ(verdict_of("hermite-circle", {"spectral", "6", ""}), Verdict::refuted);
  EXPECT_THROW(verdict_of("hermite-circle", {"sum-rules", "2", ""}), Error);
  EXPECT_THROW(verdict_of("hermite-circle", {"circle", "2", ""}), Error);
}

TEST(HermiteClaims, OnlyThePrintedTensionHasADirection) {
  for (const char* name : {"hermite-circle", "hermite-circle:variant=c2", "hermite-circle:variant=c2,w=7/5"})
    EXPECT_EQ(verdict_of(name, {"symmetric", "", ""}), Verdict::proved) << name;
  for (const char* name : {"hermite-circle:w=1/100", "hermite-circle:w=7/5", "hermite-circle:w=5"}) {
    EXPECT_EQ(verdict_of(name, {"symmetric", "", ""}), Verdict::refuted) << name;
    EXPECT_EQ(verdict_of(name, {"circle", "", ""}), Verdict::refuted) << name;
  }
}

/// Reversal of any rules of blocks: cubic Hermite interpolation, and what breaks it.
TEST(HermiteClaims, ReversalOfOtherRules) {
  const auto numbers = [](std::initializer_list<Rational> list) {
    return std::vector<RationalFunction>(list.begin(), list.end());
  };
  Scheme s;
  s.id = "cubic";
  s.block = 2;
  s.phases = {{0, {numbers({1, 0, 0, 1})}},
              {0, {numbers({{1, 2}, {1, 8}, {-3, 2}, {-1, 4}}), numbers({{1, 2}, {-1, 8}, {3, 2}, {-1, 4}})}}};
  const auto verdict = [](const Scheme& of) { return prove(of, {{"symmetric", "", ""}}).decisions[0].verdict; };
  EXPECT_EQ(verdict(s), Verdict::proved);
  for (std::size_t e = 0; e < 4; ++e) {
    Scheme other = s;
    other.phases[1].blocks[1][e] = -other.phases[1].blocks[1][e];
    EXPECT_EQ(verdict(other), Verdict::refuted) << e;
  }
  Scheme moved = s;  // derivatives of old vertices mixed in: odd
  moved.phases[0].blocks[0][1] = RationalFunction(1);
  EXPECT_EQ(verdict(moved), Verdict::refuted);
  Scheme local = s;
  local.parameters.push_back({.name = "d", .scope = Parameter::Scope::local, .offsets = {-1, 0, 1}});
  EXPECT_EQ(verdict(local), Verdict::undecided);
}

/// The closed forms of reports/hermite2010/tension.md.
TEST(HermiteClaims, RatesAreThoseOfTheArgument) {
  const TensionRates& r = tension_rates();
  EXPECT_EQ(r.left, parse_rational_function("(w-1)/w*s*(1-s^2)^2/(2*(1+s^2)^2)"));
  EXPECT_EQ(r.right, parse_rational_function("-(w-1)/w*s*(1-s^2)*(7+s^2)/(2*(1+s^2)^2)"));
  EXPECT_EQ(r.jump, parse_rational_function("240/7*(w-1)/w*s*(1-s^2)*(3+s^2)/(1+s^2)^2"));
  EXPECT_EQ(r.drift, parse_rational_function("320/9*(w-1)/w*s*(1-s^2)/(1+s^2)^2"));
}

/// Other schemes of blocks: what does not need the rules of the paper.
TEST(HermiteClaims, OtherRulesAreUndecidedByName) {
  Scheme s = make_scheme("hermite-circle");
  s.phases[1].blocks[0][0] = s.phases[1].blocks[0][0] + RationalFunction(1);
  const Proof p = prove(s, {{"interpolatory", "", ""}, {"interpolant", "", ""}, {"continuity", "2", ""}});
  EXPECT_EQ(p.decisions[0].verdict, Verdict::proved);
  EXPECT_EQ(p.decisions[1].verdict, Verdict::undecided);
  EXPECT_EQ(p.decisions[2].verdict, Verdict::undecided);
  EXPECT_TRUE(p.certificate.empty());
  s.phases[0].blocks[0][4] = RationalFunction(2);
  EXPECT_EQ(prove(s, {{"interpolatory", "", ""}}).decisions[0].verdict, Verdict::proved);
  s.phases[0].blocks[0][3] = RationalFunction(2);
  EXPECT_EQ(prove(s, {{"interpolatory", "", ""}}).decisions[0].verdict, Verdict::refuted);
}

TEST(HermiteCertificate, IsAccepted) {
  for (const char* name : {"hermite-circle", "hermite-circle:w=7/5", "hermite-circle:variant=c2,w=7/5"}) {
    const check::Report report = check::check_text(proof_of(name).certificate);
    EXPECT_EQ(report.status, check::Report::valid) << name << ": " << report.message;
  }
  // A single claim brings along what it needs.
  for (const char* claim : {"positive-weights", "circle", "continuity"})
    EXPECT_EQ(check::check_text(proof_of("hermite-circle", {{claim, "", ""}}).certificate).status, check::Report::valid)
        << claim;
}

/// Calls f with every text of a document, as a pointer into it.
void over_texts(const Json& value, const std::string& at, const std::function<void(const std::string&)>& f) {
  if (value.is_string()) f(at);
  if (value.is_object())
    for (const auto& [key, inner] : value.items()) over_texts(inner, at + "/" + key, f);
  if (value.is_array())
    for (std::size_t i = 0; i < value.size(); ++i) over_texts(value[i], at + "/" + std::to_string(i), f);
}

/// Every polynomial of the rule and of the claims is changed; sealed anew, it is the mathematics that refuses.
void expect_every_text_matters(const std::string& name, const std::vector<Claim>& claims,
                               const std::vector<std::string>& but = {}) {
  const Json doc = Json::parse(proof_of(name, claims).certificate);
  ASSERT_TRUE(accepted(doc));
  std::size_t refused = 0;
  over_texts(doc, "", [&](const std::string& at) {
    if (at.ends_with("/claim") || at.ends_with("/verdict") || at.ends_with("/theorem")) return;
    if (at == "/digest" || at == "/scheme" || at == "/format") return;
    if (std::find(but.begin(), but.end(), at) != but.end()) return;
    const Json::json_pointer place(at);
    const std::string old = doc[place];
    const bool late = at.starts_with("/claims/1") || at.starts_with("/claims/2");  // after the whole rule is checked
    for (const std::string& by : {old == "0" ? std::string("1") : old + "+1", std::string("7")}) {
      if (by == old || (late && by == "7")) continue;
      Json changed = doc;
      changed[place] = by;
      EXPECT_FALSE(accepted(changed)) << at << ": " << old.substr(0, 60) << " -> " << by.substr(0, 60);
      ++refused;
    }
  });
  EXPECT_GT(refused, 50U);
}

TEST(HermiteCertificate, EveryTextOfTheRuleMatters) {
  expect_every_text_matters("hermite-circle:w=7/5", {{"continuity", "2", ""}});
}

TEST(HermiteCertificate, EveryTextOfTheSpectralConditionMatters) {
  // The coefficients of f in r are O(1/d): their part in 1/d^2, which is what counts, is 0 whatever is added to them.
  expect_every_text_matters("hermite-circle:w=7/5", {{"spectral", "5", ""}},
                            {"/hermite/rule/2/numerators/0", "/hermite/rule/2/numerators/1"});
  Json doc = Json::parse(proof_of("hermite-circle", {{"spectral", "5", ""}}).certificate);
  doc["claims"][0]["order"] = 6;
  EXPECT_FALSE(accepted(doc));
}

TEST(HermiteCertificate, ReversalIsThatOfEveryEntry) {
  for (const char* name : {"hermite-circle", "hermite-circle:variant=c2,w=7/5"}) {
    const Json doc = Json::parse(proof_of(name, {{"symmetric", "", ""}}).certificate);
    ASSERT_TRUE(accepted(doc)) << name;
    for (std::size_t h = 0; h < 3; ++h)
      for (std::size_t column = 0; column < 6; ++column) {
        Json changed = doc;
        Json& place = changed["hermite"]["rule"][h]["numerators"][column];
        place = place.get<std::string>() + "+1";
        EXPECT_FALSE(accepted(changed)) << name << " " << h << " " << column;
      }
    Json moved = doc;
    moved["hermite"]["old"][0][1] = "1";
    EXPECT_FALSE(accepted(moved));
    Json end = doc;
    end["hermite"]["end"]["numerator"] = "s_1*w-s_0*w+s_0";
    EXPECT_FALSE(accepted(end));
  }
}

/// Counterexamples: numbers that are not those of the rule are refused, and so is a point where nothing is wrong.
TEST(HermiteCertificate, CounterexamplesAreComputedAgain) {
  for (const char* name : {"symmetric", "circle"}) {
    const Json doc = Json::parse(proof_of("hermite-circle:w=7/5", {{name, "", ""}}).certificate);
    ASSERT_TRUE(accepted(doc));
    const std::string last = "/claims/" + std::to_string(doc["claims"].size() - 1);
    const auto refused = [&](const std::string& at, const Json& by) {
      const Json::json_pointer place(last + at);
      if (!doc.contains(place)) return;
      ASSERT_NE(doc[place], by);
      Json changed = doc;
      changed[place] = by;
      EXPECT_FALSE(accepted(changed)) << name << at;
    };
    refused("/witness/at/0", "1/9");
    refused("/witness/at/1", "0");
    refused("/witness/at/2", "1");
    for (const char* number : {"/witness/value", "/witness/mirror", "/witness/square"}) refused(number, "1");
    refused("/witness/row", 1);
    refused("/witness/column", 0);
    refused("/sine", "x");
    Json proved = doc;
    proved[Json::json_pointer(last)]["verdict"] = "proved";
    proved[Json::json_pointer(last)].erase("witness");
    EXPECT_EQ(checked(proved).status, check::Report::invalid) << name;
  }
}

TEST(HermiteCertificate, EveryTextOfTheBezierFormMatters) {
  Json doc = Json::parse(proof_of("hermite-circle", {{"interpolant", "", ""}}).certificate);
  doc.erase("hermite");
  doc["claims"].erase(1);
  ASSERT_TRUE(accepted(doc));
  over_texts(doc["claims"][0], "/claims/0", [&](const std::string& at) {
    const Json::json_pointer place(at);
    const std::string old = doc[place];
    for (const std::string& by :
         {old == "0" ? std::string("a") : old + "+1", old == "0" ? std::string("1") : "-" + old}) {
      Json changed = doc;
      changed[place] = by;
      EXPECT_FALSE(accepted(changed)) << at << ": " << old << " -> " << by;
    }
  });
}

TEST(HermiteCertificate, ClaimsNeedWhatTheyRestOn) {
  const Json doc = Json::parse(proof_of("hermite-circle:w=7/5").certificate);
  for (std::size_t i = 0; i < doc["claims"].size(); ++i) {
    const std::string name = doc["claims"][i]["claim"];
    if (name != "interpolant" && name != "halves") continue;
    Json fewer = doc;
    fewer["claims"].erase(i);
    EXPECT_EQ(checked(fewer).status, check::Report::invalid) << name;
    Json last = fewer;
    last["claims"].push_back(doc["claims"][i]);
    EXPECT_EQ(checked(last).status, check::Report::invalid) << name;
  }
  // Verdicts and orders.
  for (std::size_t i = 0; i < doc["claims"].size(); ++i) {
    const Json& claim = doc["claims"][i];
    if (claim["claim"] != "continuity") continue;
    Json other = doc;
    other["claims"][i]["order"] = claim["verdict"] == "proved" ? 2 : 1;
    EXPECT_FALSE(accepted(other));
  }
  // C^2 is not claimed of rules whose halves do not fit, nor "fit" of them.
  Json fit = doc;
  for (auto& claim : fit["claims"])
    if (claim["claim"] == "halves") claim["fit"] = "yes";
  EXPECT_FALSE(accepted(fit));
  const Json plain = Json::parse(proof_of("hermite-circle").certificate);
  Json three = plain;
  for (auto& claim : three["claims"])
    if (claim["claim"] == "continuity") claim["order"] = 3;
  EXPECT_FALSE(accepted(three));
  Json another_end = plain;
  another_end["hermite"]["end"]["numerator"] = "s_0*w-s_0-s_1*w";
  EXPECT_FALSE(accepted(another_end));
  Json ellipse = plain;
  for (auto& claim : ellipse["claims"])
    if (claim["claim"] == "circle") claim["sine"] = "-8*x^3+8*x";
  EXPECT_FALSE(accepted(ellipse));
  // The expansion speaks of interpolants that contain 1 and x.
  Json narrow = doc;
  for (auto& claim : narrow["claims"])
    if (claim["claim"] == "interpolant") claim["power"] = 3;
  EXPECT_FALSE(accepted(narrow));
  // A base that vanishes at a node does not make everything true.
  Json zero = plain;
  for (auto& claim : zero["claims"])
    if (claim["claim"] == "interpolant") claim["nodes"]["left"]["numerator"] = "0", claim["base"] = "x";
  EXPECT_FALSE(accepted(zero));
}

}  // namespace
}  // namespace twoscale::analysis
