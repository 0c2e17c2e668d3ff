// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates of smoothness as they are produced, every number of their claims changed, sealed anew: the checker
// accepts a mutant only if what it states is still true, judged here from the exponents known beforehand.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <functional>
#include <set>

#include "masks.hpp"
#include "twoscale/analysis/certificate.hpp"
#include "twoscale/analysis/regularity.hpp"
#include "twoscale/check/check.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::analysis {
namespace {

using Json = nlohmann::ordered_json;

std::string resealed(Json doc) {
  doc["digest"] = "";
  return check::sealed(doc.dump(1) + "\n");
}

bool accepted(const std::string& text) { return check::check_text(text).status == check::Report::valid; }

// ---- mutants

// Other spellings of a number or a polynomial: signs, digits, ends, parts.
std::set<std::string> other_texts(const std::string& t) {
  std::set<std::string> list{"0", "1", "-1", "2", "1/2", "x-1", "x", ""};
  list.insert(t.starts_with("-") ? t.substr(1) : "-" + t);
  list.insert(t + "0");
  list.insert(t + "/2");
  for (size_t i = 0; i < t.size(); ++i) {
    std::string copy = t;
    if (t[i] >= '0' && t[i] <= '9') {
      for (const int step : {1, 3, 9}) {
        copy[i] = static_cast<char>('0' + (t[i] - '0' + step) % 10);
        list.insert(copy);
      }
    } else {
      for (const char c : {'+', '-', '/'}) {
        copy[i] = c;
        list.insert(copy);
      }
    }
    list.insert(t.substr(0, i) + t.substr(i + 1));
    if (i > 4 && i + 4 < t.size()) i += 2;  // long numbers: both ends and every third digit
  }
  list.erase(t);
  return list;
}

// Calls f for every change of one leaf or one array below `node`, a part of `whole`.
void each_change(Json& node, const std::function<void()>& f) {
  const Json old = node;
  if (node.is_object()) {
    for (auto& [key, item] : node.items()) each_change(item, f);
    return;
  }
  const auto put = [&](Json with) {
    node = std::move(with);
    f();
    node = old;
  };
  if (node.is_number_integer()) {
    const long n = node.get<long>();
    for (const long other : {n - 1, n + 1, n + 2, -n, 0L, 1L, 2 * n, n / 2})
      if (other != n) put(other);
  } else if (node.is_string()) {
    for (const auto& other : other_texts(node.get<std::string>())) put(other);
  } else if (node.is_array()) {
    for (size_t i = 0; i < old.size(); ++i) {
      Json shorter = old;
      shorter.erase(i);
      put(shorter);
      Json longer = old;
      longer.insert(longer.begin() + static_cast<long>(i), old[i]);
      put(longer);
      if (i + 1 < old.size() && old[i] != old[i + 1]) {
        Json swapped = old;
        std::swap(swapped[i], swapped[i + 1]);
        put(swapped);
      }
    }
    put(Json::array());
    for (auto& item : node) each_change(item, f);
  }
}

// ---- what is true

struct Truth {
  long order = 0;
  std::optional<RealAlgebraic> rho;      // of the remainder
  std::optional<RealAlgebraic> squared;  // of its autocorrelation
  bool stable = false;
  long continuity = -1;
  Json space;  // of the claim about all levels
};

Rational rational(const Json& j) { return Rational::parse(j.get<std::string>()); }

bool is_radius(const Json& radius, const RealAlgebraic& value) {
  const Polynomial p = parse_rational_function(radius["polynomial"].get<std::string>()).numerator();
  if (RealAlgebraic::compare(rational(radius["interval"][0]), value) > 0) return false;
  if (RealAlgebraic::compare(value, rational(radius["interval"][1])) > 0) return false;
  return Polynomial::quotient(p.scaled(p.content().inverse()), value.polynomial()).has_value();
}

bool is_true(const Json& claim, const Truth& t) {
  const auto name = claim["claim"].get<std::string>();
  if (name == "stability") return (claim["verdict"] == "proved") == t.stable;
  if (claim["verdict"] != "proved") return false;
  if (name == "nonstationary") return claim["space"] == t.space && claim["continuity"].get<long>() <= t.continuity;
  if (claim["order"].get<long>() != t.order) return false;
  if (name == "nonnegative-symbol") return is_radius(claim["radius"], claim["of"] == "remainder" ? *t.rho : *t.squared);
  if (!claim["parameter"].empty()) return false;
  if (name == "jsr-exact") return is_radius(claim["radius"], *t.rho);
  const int side = RealAlgebraic::compare(rational(claim["bound"]), *t.rho);
  return name == "jsr-lower" ? side <= 0 : name == "jsr-upper" && side >= 0;
}

void expect_only_true_mutants(const std::string& certificate, const Truth& truth, size_t least) {
  ASSERT_TRUE(accepted(certificate)) << check::check_text(certificate).message;
  Json doc = Json::parse(certificate);
  size_t all = 0, still = 0;
  for (const auto& claim : doc["claims"]) EXPECT_TRUE(is_true(claim, truth)) << claim;
  each_change(doc["claims"], [&] {
    ++all;
    const std::string mutant = resealed(doc);
    if (!accepted(mutant)) return;
    ++still;
    for (const auto& claim : doc["claims"]) ASSERT_TRUE(is_true(claim, truth)) << mutant;
  });
  EXPECT_GE(all, least);
  // Claims taken away, copied or exchanged, other indices of a vertex that comes twice, ends of intervals.
  EXPECT_LT(still, all);
  std::cout << all << " mutants, " << still << " accepted and true\n";
}

// The same polytopes for other bounds, in the claim and in its blocks: never for one below the radius.
void expect_no_bound_below(const std::string& certificate, const RealAlgebraic& rho) {
  const Json whole = Json::parse(certificate);
  size_t good = 0;
  for (size_t i = 0; i < whole["claims"].size(); ++i) {
    if (whole["claims"][i]["claim"] != "jsr-upper") continue;
    Json doc = whole;
    doc["claims"] = Json::array({whole["claims"][i]});
    Json& claim = doc["claims"][0];
    const Rational bound = rational(claim["bound"]);
    for (long t = -20; t <= 400; ++t) {
      const Rational other = bound * Rational(4000 - t, 4000);
      claim["bound"] = other.to_string();
      for (auto& block : claim["blocks"]) block["bound"] = std::min(rational(block["bound"]), other).to_string();
      if (!accepted(resealed(doc))) continue;
      ++good;
      ASSERT_LE(RealAlgebraic::compare(rho, other), 0) << resealed(doc);
    }
  }
  EXPECT_GT(good, 20U);
}

struct Case {
  std::string name;
  Scheme scheme;
  bool polytope_only = false;
  bool enclosure_only = false;
  size_t least = 0;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class SmoothnessMutation : public testing::TestWithParam<Case> {};

TEST_P(SmoothnessMutation, OnlyTrueMutantsStand) {
  const Case& c = GetParam();
  RegularityOptions options;
  const Regularity exact = regularity(c.scheme, options);
  ASSERT_TRUE(exact.jsr.exact);
  options.polytope_only = c.polytope_only;
  options.jsr.enclosure_only = c.enclosure_only;
  options.jsr.width = Rational(1, 20);
  const Regularity r = regularity(c.scheme, options);
  Truth t;
  t.order = exact.order;
  t.rho = exact.jsr.exact;
  t.squared = central_radius(autocorrelation(exact.c), c.scheme.arity).radius;
  t.stable = exact.stability.stable;
  t.continuity = exact.continuity;
  const Json doc = Json::parse(r.certificate);
  for (const auto& claim : doc["claims"])
    if (claim["claim"] == "nonstationary") t.space = claim["space"];
  expect_only_true_mutants(r.certificate, t, c.least);
  if (c.enclosure_only) expect_no_bound_below(r.certificate, *t.rho);
}

std::vector<Case> cases() {
  using masks::scheme;
  const auto four = [](const Rational& w) {
    return scheme({-w, 0, Rational(1, 2) + w, 1, Rational(1, 2) + w, 0, -w}, 2, "4-point");
  };
  const Rational w(3, 10);
  const Scheme quasi = scheme({w / 8, (Rational(1) + 2 * w) / 8, (Rational(4) - w) / 8, (Rational(3) - 2 * w) / 4,
                               (Rational(4) - w) / 8, (Rational(1) + 2 * w) / 8, w / 8},
                              2, "quasi-spline");
  return {{"FourPoint", make_scheme("dd:l=2"), false, false, 100},
          {"FourPointPolytope", make_scheme("dd:l=2"), true, false, 500},
          {"FourPointEnclosure", make_scheme("dd:l=2"), true, true, 1500},
          {"SixPointPolytope", make_scheme("dd:l=3"), true, false, 1000},
          {"EightPointPolytopeSlow", make_scheme("dd:l=4"), true, false, 2000},
          {"TensionAllLevels", make_scheme("tension4"), false, false, 100},
          {"TensionAllLevelsPolytope", make_scheme("tension4"), true, false, 500},
          {"FourPointEighthSlow", four(Rational(1, 8)), false, false, 2000},
          {"FourPointFifth", four(Rational(1, 5)), false, false, 2000},
          {"QuasiSpline", quasi, false, false, 1000},
          {"Spline", make_scheme("bspline:n=3,arity=3"), true, false, 100},
          {"NotStable", scheme({1, 0, 0, 1}, 2), false, false, 100}};
}

INSTANTIATE_TEST_SUITE_P(Certificates, SmoothnessMutation, testing::ValuesIn(cases()),
                         [](const auto& c) { return c.param.name; });

// Matrices with two blocks, in a hidden basis.
TEST(SmoothnessMutationOfMatrices, Reducible) {
  const auto matrix = [](const std::vector<long>& e) {
    RationalMatrix m(3, 3);
    for (long i = 0; i < 9; ++i) m.set(i / 3, i % 3, e[static_cast<size_t>(i)]);
    return m;
  };
  const RationalMatrix t = matrix({1, 1, 0, 2, 1, 1, 0, 3, 1});
  const Family family{t * matrix({1, 1, 2, 0, 1, 5, 0, 0, 1}) * *t.inverse(),
                      t * matrix({1, 0, -3, 1, 1, 1, 0, 0, -1}) * *t.inverse()};
  Truth truth;
  truth.rho = RealAlgebraic::zeros(parse_rational_function("x^2-x-1").numerator()).back();
  JsrOptions options;
  const JsrResult r = joint_spectral_radius(family, {}, options);
  ASSERT_TRUE(r.exact);
  expect_only_true_mutants(certificate_text("matrices", family, r.claims), truth, 500);
  options.enclosure_only = true;
  options.width = Rational(1, 20);
  const std::string enclosed = certificate_text("matrices", family, joint_spectral_radius(family, {}, options).claims);
  expect_only_true_mutants(enclosed, truth, 1000);
  expect_no_bound_below(enclosed, *truth.rho);
}

}  // namespace
}  // namespace twoscale::analysis
