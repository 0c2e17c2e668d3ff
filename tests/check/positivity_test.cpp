// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the checker: claims `positivity` and `root-bound`, with and without a mask. Every token of good certificates
// is changed; a mutant that is accepted is compared with values at many points and with roots found in floating point.
#include "samples.hpp"

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <complex>
#include <iostream>
#include <map>
#include <set>

namespace {

using samples::array;
using samples::claim;
using samples::object;
using samples::text;
using samples::texts;
using twoscale::check::check_text;
using twoscale::check::Report;
using twoscale::check::Value;
using Number = boost::multiprecision::cpp_rational;
using Sides = std::vector<std::pair<std::string, std::string>>;

std::string document(std::vector<Value> claims) {
  return twoscale::check::sealed(twoscale::check::canonical_json(object({{"format", text("twoscale/certificate")},
                                                                         {"version", samples::number(1)},
                                                                         {"scheme", text("test")},
                                                                         {"claims", array(std::move(claims))},
                                                                         {"digest", text("")}})));
}

Value box(const Sides& sides) {
  std::vector<Value> list;
  for (const auto& [low, high] : sides) list.push_back(texts({low, high}));
  return array(std::move(list));
}

using Members = std::vector<std::pair<std::string, Value>>;

Value positive(const std::string& p, const std::vector<std::string>& names, const Sides& sides,
               const std::string& strict, const std::vector<std::string>& zeros, const std::string& method,
               const std::string& tree = "") {
  return claim("positivity", "proved",
               {{"polynomial", text(p)},
                {"variables", texts(names)},
                {"box", box(sides)},
                {"strict", text(strict)},
                {"zeros", texts(zeros)},
                {"method", text(method)},
                {"tree", text(tree)}},
               method == "sturm" ? "sturm" : "bernstein");
}

Value not_positive(const std::string& p, const std::vector<std::string>& names, const Sides& sides,
                   const std::string& strict, const std::vector<std::string>& zeros, Value witness,
                   const std::string& theorem = "definition") {
  return claim("positivity", "refuted",
               {{"polynomial", text(p)},
                {"variables", texts(names)},
                {"box", box(sides)},
                {"strict", text(strict)},
                {"zeros", texts(zeros)},
                {"witness", std::move(witness)}},
               theorem);
}
Value at(const std::vector<std::string>& point, const std::string& value) {
  return object({{"at", texts(point)}, {"value", text(value)}});
}
Value between(const std::string& low, const std::string& high) { return object({{"between", texts({low, high})}}); }

/// Conditions: method and tree, as "sturm" or "bernstein:0..".
Value inside(const std::string& p, const std::string& bound, const std::vector<std::string>& names, const Sides& sides,
             const std::vector<std::string>& zeros, const std::vector<std::string>& conditions) {
  std::vector<Value> list;
  for (const std::string& c : conditions) {
    const std::size_t colon = c.find(':');
    list.push_back(object(
        {{"method", text(c.substr(0, colon))}, {"tree", text(colon == std::string::npos ? "" : c.substr(colon + 1))}}));
  }
  return claim("root-bound", "proved",
               {{"polynomial", text(p)},
                {"root", text("x")},
                {"bound", text(bound)},
                {"variables", texts(names)},
                {"box", box(sides)},
                {"zeros", texts(zeros)},
                {"conditions", array(std::move(list))}},
               "schur-cohn");
}
Value not_inside(const std::string& p, const std::string& bound, const std::vector<std::string>& names,
                 const Sides& sides, const std::vector<std::string>& point,
                 const std::vector<std::string>& zeros = {}) {
  return claim("root-bound", "refuted",
               {{"polynomial", text(p)},
                {"root", text("x")},
                {"bound", text(bound)},
                {"variables", texts(names)},
                {"box", box(sides)},
                {"zeros", texts(zeros)},
                {"witness", object({{"at", texts(point)}})}},
               "schur-cohn");
}

Report::Status status(Value c) { return check_text(document({std::move(c)})).status; }

const Sides unit{{"0", "1"}}, square{{"0", "1"}, {"0", "1"}}, quadrant{{"0", ""}, {"0", ""}};
const std::vector<std::string> x{"x"}, xy{"x", "y"}, none;
const std::string waved = "3*x^2*y^2+3*x^2-3*x*y^2-3*x+y^2+1";  // (3x^2-3x+1)(y^2+1), at least 1/4
const std::vector<std::string> quartic{"vertices", "vertices", "vertices", "vertices", "vertices", "sturm"};

std::vector<std::pair<std::string, Value>> good() {
  return {
      {"sturm", positive("x^2-x+1", x, {{"0", ""}}, "yes", {}, "sturm")},
      {"even_zero", positive("x^4-4*x^2+4", x, {{"-2", "2"}}, "no", {}, "sturm")},
      {"even_zero_refuted", not_positive("x^4-4*x^2+4", x, {{"-2", "2"}}, "yes", {}, between("1", "3/2"), "sturm")},
      {"ends", positive("-x^3+x^2", x, unit, "yes", {"x=hi", "x=lo"}, "sturm")},
      {"vertices", positive("2*x*y-x-y+2", xy, square, "yes", {}, "vertices")},
      {"vertices_quadrant", positive("x*y", xy, quadrant, "yes", {"x=lo", "y=lo"}, "vertices")},
      {"bernstein", positive(waved, xy, square, "yes", {}, "bernstein", "0..")},
      {"bernstein_quadrant", positive("x^2*y^2-x*y^2+y^2", xy, quadrant, "yes", {"y=lo"}, "bernstein", "0..")},
      {"refuted_zero", not_positive("x*y", xy, quadrant, "yes", {"x=lo"}, at({"2", "0"}, "0"))},
      {"refuted_value", not_positive("x*y-x-y+1", xy, quadrant, "no", {}, at({"2", "0"}, "-1"))},
      {"roots", inside("8*x^3+4*x^2-2*x-1", "2/3", none, {}, {}, {})},
      {"roots_refuted", not_inside("8*x^3+4*x^2-2*x-1", "1/2", none, {}, {})},
      {"jury", inside("2*w*x+w+4*x^2", "1", {"w"}, {{"-1", "1"}}, {}, {"vertices", "vertices", "sturm"})},
      {"cubic", inside("-w+4*x^3", "1", {"w"}, {{"0", "4"}}, {"w=hi"},
                       {"vertices", "vertices", "vertices", "vertices", "sturm", "bernstein:."})},
      {"quartic", inside("-w+4*x^4", "1", {"w"}, {{"-1", "1"}}, {}, quartic)},
      {"quartic_refuted", not_inside("-w+4*x^4", "1", {"w"}, {{"0", ""}}, {"4"})},
  };
}

// ---- The oracle: its own reader and arithmetic, many points

using Terms = std::vector<std::pair<Number, std::map<std::string, int>>>;

Terms read(const std::string& p) {
  Terms terms;
  for (std::size_t i = 0; i < p.size();) {
    Number c = 1;
    if (p[i] == '-') c = -1;
    if (p[i] == '-' || p[i] == '+') ++i;
    std::map<std::string, int> powers;
    while (i < p.size() && p[i] != '+' && p[i] != '-') {
      std::size_t end = p.find_first_of("*+-", i);
      if (end == std::string::npos) end = p.size();
      const std::string factor = p.substr(i, end - i);
      if (std::isdigit(static_cast<unsigned char>(factor[0])) != 0) {
        c *= Number(factor);
      } else {
        const std::size_t hat = factor.find('^');
        powers[factor.substr(0, hat)] += hat == std::string::npos ? 1 : std::stoi(factor.substr(hat + 1));
      }
      i = end;
      if (i < p.size() && p[i] == '*') ++i;
    }
    terms.emplace_back(c, powers);
  }
  return terms;
}

Number value(const Terms& p, const std::map<std::string, Number>& point) {
  Number sum = 0;
  for (const auto& [c, powers] : p) {
    Number term = c;
    for (const auto& [name, e] : powers) {
      for (int k = 0; k < e; ++k) term *= point.at(name);
    }
    sum += term;
  }
  return sum;
}

const Value& member(const Value& v, const std::string& key) {
  for (std::size_t i = 0; i < v.keys.size(); ++i) {
    if (v.keys[i] == key) return v.items[i];
  }
  throw std::out_of_range(key);
}
bool has(const Value& v, const std::string& key) {
  return std::find(v.keys.begin(), v.keys.end(), key) != v.keys.end();
}
bool lists(const Value& v, const std::string& item) {
  return std::any_of(v.items.begin(), v.items.end(), [&](const Value& i) { return i.text == item; });
}

/// Points of the box, its faces and vertices among them; `excluded`: on a face of `zeros`.
struct Probe {
  std::map<std::string, Number> point;
  bool excluded = false;
};
std::vector<Probe> probes(const Value& c) {
  std::vector<Probe> list{{}};
  const auto& names = member(c, "variables").items;
  for (std::size_t j = 0; j < names.size(); ++j) {
    const std::string& name = names[j].text;
    const auto& ends = member(c, "box").items[j].items;
    const Number low(ends[0].text);
    std::vector<std::pair<Number, bool>> values{{low, lists(member(c, "zeros"), name + "=lo")}};
    for (const char* t : {"1/1000", "1/7", "1/4", "1/3", "2/5", "1/2", "5/9", "2/3", "3/4", "6/7", "999/1000"}) {
      const Number s(t);
      values.emplace_back(
          ends[1].text.empty() ? Number(low + s / (1 - s)) : Number(low + (Number(ends[1].text) - low) * s), false);
    }
    if (!ends[1].text.empty()) {
      values.emplace_back(Number(ends[1].text), lists(member(c, "zeros"), name + "=hi"));
    }
    std::vector<Probe> next;
    for (const Probe& p : list) {
      for (const auto& [v, excluded] : values) {
        Probe q = p;
        q.point[name] = v;
        q.excluded = q.excluded || excluded;
        next.push_back(std::move(q));
      }
    }
    list = std::move(next);
  }
  return list;
}

/// Largest |root| of the polynomial in `root` at the point (Durand and Kerner); infinity if its degree is less than n.
double largest_root(const Terms& p, const std::string& root, const std::map<std::string, Number>& point) {
  std::size_t n = 0;
  for (const auto& [c, powers] : p) {
    const auto found = powers.find(root);
    if (found != powers.end()) n = std::max(n, static_cast<std::size_t>(found->second));
  }
  std::vector<Number> exact(n + 1);
  for (const auto& [c, powers] : p) {
    auto rest = powers;
    const auto k = static_cast<std::size_t>(rest.count(root) != 0 ? rest[root] : 0);
    rest.erase(root);
    exact[k] += value({{c, rest}}, point);
  }
  if (exact[n] == 0) return INFINITY;
  std::vector<std::complex<double>> z(n), a;
  for (const Number& c : exact) a.emplace_back((c / exact[n]).convert_to<double>());
  for (std::size_t i = 0; i < n; ++i)
    z[i] = std::polar(0.9, 0.4 + 6.28318 * static_cast<double>(i) / static_cast<double>(n));
  for (int round = 0; round < 500; ++round) {
    for (std::size_t i = 0; i < n; ++i) {
      std::complex<double> numerator = 1, denominator = 1;
      for (std::size_t k = n; k-- > 0;) numerator = numerator * z[i] + a[k];
      for (std::size_t k = 0; k < n; ++k) {
        if (k != i) denominator *= z[i] - z[k];
      }
      if (denominator != 0.0) z[i] -= numerator / denominator;
    }
  }
  double most = 0;
  for (const auto& r : z) most = std::max(most, std::abs(r));
  return most;
}

/// No probe contradicts the claim.
bool plausible(const Value& c) {
  const Terms p = read(member(c, "polynomial").text);
  const bool proved = member(c, "verdict").text == "proved";
  const auto& names = member(c, "variables").items;
  if (member(c, "claim").text == "positivity") {
    const bool strict = member(c, "strict").text == "yes";
    if (!proved && has(member(c, "witness"), "between")) {
      std::map<std::string, Number> low, high;
      for (const Value& name : names) {
        low[name.text] = Number(member(member(c, "witness"), "between").items[0].text);
        high[name.text] = Number(member(member(c, "witness"), "between").items[1].text);
      }
      return strict && low != high;  // zeros of even order leave no trace at the ends
    }
    if (!proved) {
      std::map<std::string, Number> point;
      for (std::size_t j = 0; j < names.size(); ++j) {
        point[names[j].text] = Number(member(member(c, "witness"), "at").items[j].text);
      }
      const Number v = value(p, point);
      return v == Number(member(member(c, "witness"), "value").text) && (v < 0 || (strict && v == 0));
    }
    for (const Probe& probe : probes(c)) {
      const Number v = value(p, probe.point);
      if (v < 0 || (strict && v == 0 && !probe.excluded)) return false;
    }
    return true;
  }
  const Number bound(member(c, "bound").text);
  if (!proved) {
    std::map<std::string, Number> point;
    for (std::size_t j = 0; j < names.size(); ++j) {
      point[names[j].text] = Number(member(member(c, "witness"), "at").items[j].text);
    }
    return largest_root(p, member(c, "root").text, point) > bound.convert_to<double>() * (1 - 1e-3);
  }
  const auto all = probes(c);
  return std::all_of(all.begin(), all.end(), [&](const Probe& probe) {
    return probe.excluded ||
           largest_root(p, member(c, "root").text, probe.point) < bound.convert_to<double>() * (1 + 1e-3);
  });
}

/// Each character of the claims replaced, removed, doubled; each string replaced by each other and by some more.
std::set<std::string> mutants(const std::string& body) {
  std::set<std::string> result;
  const auto put = [&](std::size_t i, std::size_t length, const std::string& with) {
    std::string copy = body;
    copy.replace(i, length, with);
    result.insert(std::move(copy));
  };
  const std::size_t start = body.find("\"claims\""), stop = body.rfind("\"digest\"");
  for (std::size_t i = start; i < stop; ++i) {
    if (body[i] == ' ' || body[i] == '\n') continue;
    put(i, 1, "");
    put(i, 1, std::string(2, body[i]));
    for (const char c : std::string("0123456789+-*^/.,\"xyw")) put(i, 1, std::string(1, c));
    for (const char c : std::string("019-.")) put(i, 0, std::string(1, c));
  }
  std::vector<std::pair<std::size_t, std::size_t>> strings;
  std::set<std::string> pool{
      "0",   "1",     "-1",  "1/2",  "",     "yes",  "no",   "sturm",  "vertices", "bernstein",  ".",
      "0..", "00...", "1..", "x=lo", "x=hi", "y=lo", "w=hi", "proved", "refuted",  "definition", "9999999999999999"};
  for (std::size_t i = body.find('"', start); i < stop; i = body.find('"', i)) {
    const std::size_t end = body.find('"', i + 1);
    strings.emplace_back(i + 1, end - i - 1);
    pool.insert(body.substr(i + 1, end - i - 1));
    i = end + 1;
  }
  for (const auto& [i, length] : strings) {
    for (const std::string& other : pool) put(i, length, other);
  }
  result.erase(body);
  return result;
}

TEST(Positivity, GoodCertificatesAreValid) {
  for (auto& [name, c] : good()) {
    const Report report = check_text(document({c}));
    EXPECT_EQ(report.status, Report::valid) << name << ": " << report.message;
    EXPECT_TRUE(plausible(c)) << name;
  }
}

TEST(Positivity, Reports) {
  const Report report = check_text(document({positive("x^2-x+1", x, {{"0", ""}}, "yes", {}, "sturm")}));
  ASSERT_EQ(report.lines.size(), 4U);
  EXPECT_NE(report.lines[0].find("about what they state"), std::string::npos);
  EXPECT_NE(report.lines[1].find("positivity x^2-x+1 > 0 for x >= 0: zeros counted; trusting [sturm]"),
            std::string::npos)
      << report.lines[1];
}

TEST(Positivity, WithAMaskToo) {
  auto d = samples::dd4();
  d.claims.push_back(positive("2*x*y-x-y+2", xy, square, "yes", {}, "vertices"));
  EXPECT_EQ(d.check().status, Report::valid);
  // and claims about a mask do not go without one
  EXPECT_EQ(status(samples::interpolatory()), Report::malformed);
}

TEST(Positivity, FalseClaimsAreRefused) {
  EXPECT_EQ(status(positive("x^2-3*x+2", x, {{"0", ""}}, "no", {}, "sturm")), Report::invalid);
  EXPECT_EQ(status(positive("x^2-2*x+1", x, {{"0", ""}}, "yes", {}, "sturm")), Report::invalid);
  EXPECT_EQ(status(positive("x^2-2*x+1", x, {{"0", ""}}, "no", {}, "sturm")), Report::valid);
  EXPECT_EQ(status(positive("x^3-3*x^2+3*x-1", x, {{"0", ""}}, "no", {}, "sturm")), Report::invalid);
  EXPECT_EQ(status(positive("-x", x, {{"0", ""}}, "no", {}, "sturm")), Report::invalid);
  EXPECT_EQ(status(positive("-x+1", x, unit, "yes", {}, "sturm")), Report::invalid);
  EXPECT_EQ(status(positive("-x+1", x, unit, "yes", {"x=hi"}, "sturm")), Report::valid);
  EXPECT_EQ(status(positive("-x+1", x, unit, "yes", {"x=lo"}, "sturm")), Report::invalid);
  EXPECT_EQ(status(positive("0", x, unit, "yes", {}, "vertices")), Report::invalid);
  EXPECT_EQ(status(positive("0", x, unit, "no", {}, "vertices")), Report::valid);
  EXPECT_EQ(status(positive("0", x, unit, "no", {}, "sturm")), Report::invalid);
  EXPECT_EQ(status(positive("-x*y+1", xy, quadrant, "no", {}, "vertices")), Report::invalid);
  EXPECT_EQ(status(positive("x^2*y", xy, square, "yes", {"x=lo", "y=lo"}, "vertices")), Report::invalid);
  EXPECT_EQ(status(positive("x*y", xy, square, "yes", {"x=lo"}, "vertices")), Report::invalid);
  EXPECT_EQ(status(positive("x*y-x-y+1", xy, square, "yes", {"x=hi"}, "vertices")), Report::invalid);
  EXPECT_EQ(status(positive("x*y-x-y+1", xy, square, "yes", {"x=hi", "y=hi"}, "vertices")), Report::valid);
  EXPECT_EQ(status(positive("x+y", xy, square, "yes", {"x=lo"}, "vertices")), Report::valid);
  EXPECT_EQ(status(positive("x+y", xy, square, "yes", {}, "vertices")), Report::invalid);
  // zero at x = 1/2, where two leaves meet
  const std::string halved = "4*x^2*y^2+4*x^2-4*x*y^2-4*x+y^2+1";
  EXPECT_EQ(status(positive(halved, xy, square, "no", {}, "bernstein", "0..")), Report::valid);
  EXPECT_EQ(status(positive(halved, xy, square, "yes", {"x=hi", "x=lo"}, "bernstein", "0..")), Report::invalid);
  // zero at x = 1 of [0, infinity), where two leaves meet, too
  EXPECT_EQ(status(positive("x^2*y-2*x*y+y", xy, quadrant, "no", {}, "bernstein", "0..")), Report::valid);
  EXPECT_EQ(status(positive("x^2*y-2*x*y+y", xy, quadrant, "yes", {"x=lo", "y=lo"}, "bernstein", "0..")),
            Report::invalid);
  // negative beside the lower end, and without any zero
  EXPECT_EQ(status(positive("-x-1", x, {{"0", ""}}, "yes", {}, "sturm")), Report::invalid);
  EXPECT_EQ(status(positive("-x^2", x, unit, "no", {}, "sturm")), Report::invalid);
  EXPECT_EQ(status(positive("x^2", x, unit, "yes", {}, "sturm")), Report::invalid);
  EXPECT_EQ(status(positive("x^2", x, unit, "yes", {"x=hi"}, "sturm")), Report::invalid);
  EXPECT_EQ(status(positive(waved, xy, square, "yes", {}, "bernstein", ".")), Report::invalid);
  EXPECT_EQ(status(positive(waved, xy, square, "yes", {}, "bernstein", "1..")), Report::invalid);
  EXPECT_EQ(status(not_positive("x^2-2", x, unit, "no", {}, at({"2"}, "2"))), Report::invalid);
  EXPECT_EQ(status(not_positive("x-1", x, unit, "no", {}, at({"1/2"}, "-1/2"))), Report::valid);
  EXPECT_EQ(status(not_positive("x-1", x, unit, "no", {}, at({"1"}, "0"))), Report::invalid);
  EXPECT_EQ(status(not_positive("x-1", x, unit, "no", {}, at({"-1"}, "-2"))), Report::invalid);
  EXPECT_EQ(status(not_positive("x", x, unit, "yes", {"x=lo"}, at({"0"}, "0"))), Report::invalid);
  EXPECT_EQ(status(not_positive("x", x, unit, "yes", {}, at({"0"}, "0"))), Report::valid);
  EXPECT_EQ(status(not_positive("x^2-2", x, {{"0", "2"}}, "yes", {}, between("1", "7/5"), "sturm")), Report::invalid);
  EXPECT_EQ(status(not_positive("x^2-2", x, {{"0", "2"}}, "yes", {}, between("1", "3"), "sturm")), Report::invalid);
  EXPECT_EQ(status(not_positive("x^2-2", x, {{"0", "2"}}, "no", {}, between("1", "2"), "sturm")), Report::invalid);
  EXPECT_EQ(status(not_positive("x", x, unit, "yes", {"x=lo"}, between("0", "1"), "sturm")), Report::invalid);
}

TEST(Positivity, IllFormedClaimsAreMalformed) {
  EXPECT_EQ(status(positive(waved, xy, square, "yes", {}, "bernstein", "0.")), Report::malformed);
  EXPECT_EQ(status(positive(waved, xy, square, "yes", {}, "bernstein", "0...")), Report::malformed);
  EXPECT_EQ(status(positive(waved, xy, square, "yes", {}, "bernstein", "2..")), Report::malformed);
  EXPECT_EQ(status(positive(waved, xy, square, "yes", {}, "bernstein", "-1..")), Report::malformed);
  EXPECT_EQ(status(positive(waved, xy, square, "yes", {}, "bernstein", "")), Report::malformed);
  EXPECT_EQ(status(positive(waved, xy, square, "yes", {}, "bernstein", std::string(100'000, '0'))), Report::malformed);
  EXPECT_EQ(status(positive("x", x, {{"1", "1"}}, "yes", {}, "sturm")), Report::malformed);
  EXPECT_EQ(status(positive("x", x, {{"2", "1"}}, "yes", {}, "sturm")), Report::malformed);
  EXPECT_EQ(status(positive("x", x, {{"", "1"}}, "yes", {}, "sturm")), Report::malformed);
  EXPECT_EQ(status(positive("x", x, square, "yes", {}, "sturm")), Report::malformed);
  EXPECT_EQ(status(positive("x", {"y", "x"}, square, "yes", {}, "sturm")), Report::malformed);
  EXPECT_EQ(status(positive("x", x, {{"0", ""}}, "yes", {"x=hi"}, "sturm")), Report::malformed);
  EXPECT_EQ(status(positive("x", x, unit, "yes", {"x=lo", "x=hi"}, "sturm")), Report::malformed);
  EXPECT_EQ(status(positive("x", x, unit, "no", {"x=lo"}, "sturm")), Report::malformed);
  EXPECT_EQ(status(positive("x", x, unit, "maybe", {}, "sturm")), Report::malformed);
  EXPECT_EQ(status(positive("x", x, unit, "yes", {}, "guess")), Report::malformed);
  EXPECT_EQ(status(positive("x^4096*y^4096", xy, square, "no", {}, "bernstein", ".")), Report::malformed);
  EXPECT_EQ(status(inside("x", "0", none, {}, {}, {})), Report::malformed);
  EXPECT_EQ(status(inside("0", "1", none, {}, {}, {})), Report::malformed);
  EXPECT_EQ(status(inside("2*x", "1", none, {}, {}, {"sturm"})), Report::malformed);
  EXPECT_EQ(status(inside("-w+2*x", "1", {"w"}, unit, {}, {"sturm"})), Report::malformed);
  EXPECT_EQ(status(inside("x", "1", {"x"}, unit, {}, {})), Report::malformed);
  EXPECT_EQ(status(inside("w*x^17", "1", {"w"}, unit, {}, {})), Report::malformed);
}

TEST(RootBound, FalseClaimsAreRefused) {
  EXPECT_EQ(status(inside("8*x^3+4*x^2-2*x-1", "1/2", none, {}, {}, {})), Report::invalid);
  EXPECT_EQ(status(inside("8*x^3+4*x^2-2*x-1", "501/1000", none, {}, {}, {})), Report::valid);
  EXPECT_EQ(status(inside("-8*x^3-4*x^2+2*x+1", "501/1000", none, {}, {}, {})), Report::valid);
  EXPECT_EQ(status(inside("x^2+1", "1", none, {}, {}, {})), Report::invalid);
  EXPECT_EQ(status(inside("x^2+1", "2", none, {}, {}, {})), Report::valid);
  EXPECT_EQ(status(inside("-w+4*x^4", "1", {"w"}, {{"-1", "4"}}, {}, quartic)), Report::invalid);
  EXPECT_EQ(status(inside("-w+4*x^4", "1", {"w"}, {{"-1", "4"}}, {"w=hi"}, quartic)), Report::valid);
  EXPECT_EQ(status(inside("-w+4*x^4", "1", {"w"}, {{"-5", "1"}}, {}, quartic)), Report::invalid);
  EXPECT_EQ(status(inside("-w+4*x^4", "3/2", {"w"}, {{"-5", "1"}}, {}, quartic)), Report::valid);
  EXPECT_EQ(status(inside("w*x-1", "1", {"w"}, {{"2", ""}}, {}, {"vertices", "sturm"})), Report::valid);
  EXPECT_EQ(status(inside("w*x-1", "1", {"w"}, {{"1", ""}}, {}, {"vertices", "sturm"})), Report::invalid);
  const std::vector<std::string> six(6, "vertices");  // x (x^2 + w)
  EXPECT_EQ(status(inside("w*x+x^3", "1", {"w"}, {{"-1/2", "1/2"}}, {}, six)), Report::valid);
  EXPECT_EQ(status(inside("w*x+x^3", "1", {"w"}, {{"-1/2", "2"}}, {}, six)), Report::invalid);
  EXPECT_EQ(status(inside("w*x+x^3", "1", {"w"}, {{"-2", "1/2"}}, {}, six)), Report::invalid);
  EXPECT_EQ(status(not_inside("w*x-1", "1", {"w"}, {{"0", ""}}, {"0"})), Report::valid);
  EXPECT_EQ(status(not_inside("w*x-1", "1", {"w"}, {{"0", ""}}, {"0"}, {"w=lo"})), Report::invalid);
  EXPECT_EQ(status(not_inside("w*x-1", "1", {"w"}, {{"0", ""}}, {"1/2"}, {"w=lo"})), Report::valid);
  EXPECT_EQ(status(not_inside("w*x-1", "1", {"w"}, {{"0", ""}}, {"2"})), Report::invalid);
  EXPECT_EQ(status(not_inside("w*x-1", "1", {"w"}, {{"1", ""}}, {"1/2"})), Report::invalid);
}

TEST(Positivity, MutantsAreAcceptedOnlyIfTrue) {
  int accepted = 0, invalid = 0, malformed = 0;
  std::map<std::string, bool> known;
  for (const auto& [name, c] : good()) {
    const std::string whole = document({c});
    const std::string body = whole.substr(0, whole.rfind("\"digest\"")) + "\"digest\": \"\"\n}\n";
    for (const std::string& mutant : mutants(body)) {
      switch (check_text(twoscale::check::sealed(mutant)).status) {
        case Report::malformed: ++malformed; break;
        case Report::invalid: ++invalid; break;
        case Report::valid: {
          ++accepted;
          const Value document = twoscale::check::parse_json(mutant);
          for (const Value& item : member(document, "claims").items) {
            const auto [place, fresh] = known.try_emplace(twoscale::check::canonical_json(item));
            if (fresh) place->second = plausible(item);
            ASSERT_TRUE(place->second) << name << "\n" << mutant;
          }
          break;
        }
      }
    }
  }
  std::cout << accepted << " still true, " << invalid << " invalid, " << malformed << " malformed\n";
  EXPECT_GT(invalid, 500);
  EXPECT_GT(accepted, 100);
}

TEST(Positivity, HeavyOnesEnd) {
  std::string dense = "x^500*y^500";
  for (int d = 499; d > 1; --d) dense += "-" + std::to_string(d) + "*x^" + std::to_string(d) + "*y^2";
  const Sides odd{{"-1234567/7654321", "7654321/1234567"}, {"-1/3", ""}};
  const Value heavy = positive(dense, xy, odd, "yes", {}, "bernstein", std::string(250, '0') + std::string(251, '.'));
  EXPECT_NE(check_text(document({heavy}), 300'000'000).status, Report::valid);
  const Value power = not_inside("-w^4096+x^4096", "9999999999/7", {"w"}, unit, {"99999999/100000001"});
  EXPECT_NE(check_text(document({power}), 300'000'000).status, Report::valid);
  EXPECT_NE(check_text(document({inside("x^4095-2*x^2+1", "3/2", none, {}, {}, {})}), 300'000'000).status,
            Report::valid);
}

}  // namespace
