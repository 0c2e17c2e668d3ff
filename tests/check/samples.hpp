// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the checker: certificates built by hand, as documents that can be changed before they are sealed.
#pragma once

#include "twoscale/check/check.hpp"
#include "twoscale/check/json.hpp"

#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace samples {

using twoscale::check::Value;

inline Value text(std::string s) {
  Value v;
  v.kind = Value::Kind::string;
  v.text = std::move(s);
  return v;
}
inline Value number(long n) {
  Value v;
  v.kind = Value::Kind::integer;
  v.number = n;
  return v;
}
inline Value array(std::vector<Value> items) {
  Value v;
  v.items = std::move(items);
  return v;
}
inline Value texts(const std::vector<std::string>& list) {
  std::vector<Value> items;
  for (const auto& s : list) items.push_back(text(s));
  return array(std::move(items));
}
inline Value numbers(const std::vector<long>& list) {
  std::vector<Value> items;
  for (const long n : list) items.push_back(number(n));
  return array(std::move(items));
}
inline Value object(std::vector<std::pair<std::string, Value>> members) {
  Value v;
  v.kind = Value::Kind::object;
  for (auto& [key, value] : members) {
    v.keys.push_back(key);
    v.items.push_back(std::move(value));
  }
  return v;
}

/// {{n_1, ..., n_r}, order} for each frequency.
inline Value space(const std::vector<std::pair<std::vector<long>, long>>& parts) {
  std::vector<Value> items;
  for (const auto& [frequency, order] : parts) {
    items.push_back(object({{"frequency", numbers(frequency)}, {"order", number(order)}}));
  }
  return array(std::move(items));
}
/// {level, angle} each.
inline Value angles(const std::vector<std::pair<long, std::string>>& list) {
  std::vector<Value> items;
  for (const auto& [level, angle] : list) items.push_back(object({{"level", number(level)}, {"angle", text(angle)}}));
  return array(std::move(items));
}
inline Value conditions(const std::vector<std::string>& list) {
  std::vector<Value> items;
  for (const auto& c : list) items.push_back(object({{"condition", text(c)}}));
  return array(std::move(items));
}

/// A claim: members between "verdict" and "theorem" in order.
inline Value claim(const std::string& name, const std::string& verdict,
                   std::vector<std::pair<std::string, Value>> members, const std::string& theorem) {
  std::vector<std::pair<std::string, Value>> all{{"claim", text(name)}, {"verdict", text(verdict)}};
  for (auto& m : members) all.push_back(std::move(m));
  all.emplace_back("theorem", text(theorem));
  return object(std::move(all));
}
inline Value interpolatory() { return claim("interpolatory", "proved", {}, "definition"); }
inline Value symmetric(const std::string& c) {
  return claim("symmetric", "proved", {{"center", text(c)}}, "definition");
}
inline Value sum_rules(long order, const std::string& exact) {
  return claim("sum-rules", "proved", {{"order", number(order)}, {"exact", text(exact)}}, "definition");
}
inline Value generates(Value v, Value exceptions) {
  return claim("generates", "proved", {{"space", std::move(v)}, {"exceptions", std::move(exceptions)}},
               "generation-stepwise");
}
inline Value reproduces(Value v, long confluent) {
  return claim("reproduces", "proved", {{"space", std::move(v)}, {"confluent", number(confluent)}},
               "reproduction-stepwise");
}
inline Value maximal(Value v, Value w) {
  return claim("maximal", "proved", {{"space", std::move(v)}, {"reproduced", std::move(w)}}, "hurwitz-count");
}
inline Value well_defined(Value exceptions, const std::string& theorem = "sturm") {
  return claim("well-defined", "proved", {{"exceptions", std::move(exceptions)}}, theorem);
}

struct Variable {
  std::string name, scope, meaning;
};

struct Document {
  std::string scheme;
  long arity = 2;
  std::vector<Variable> variables;
  std::string shift = "0";
  long lowest = 0;
  std::vector<std::string> numerators;
  std::string denominator = "1";
  std::vector<Value> claims;

  /// Canonical text with an empty digest.
  std::string unsealed() const {
    std::vector<Value> list;
    for (const auto& v : variables) {
      list.push_back(object({{"name", text(v.name)}, {"scope", text(v.scope)}, {"meaning", text(v.meaning)}}));
    }
    return twoscale::check::canonical_json(object({
        {"format", text("twoscale/certificate")},
        {"version", number(1)},
        {"scheme", text(scheme)},
        {"arity", number(arity)},
        {"variables", array(std::move(list))},
        {"shift", text(shift)},
        {"mask",
         object({{"lowest", number(lowest)}, {"numerators", texts(numerators)}, {"denominator", text(denominator)}})},
        {"claims", array(claims)},
        {"digest", text("")},
    }));
  }
  std::string sealed() const { return twoscale::check::sealed(unsealed()); }
  twoscale::check::Report check() const { return twoscale::check::check_text(sealed()); }
  /// The same mask with one claim only.
  Document with(Value one) const {
    Document d = *this;
    d.claims = {std::move(one)};
    return d;
  }
};

/// For messages of GoogleTest.
inline void PrintTo(const Document& document, std::ostream* out) { *out << document.scheme; }

inline Document cubic_bspline() {
  Document d;
  d.scheme = "bspline:n=3";
  d.lowest = -2;
  d.numerators = {"1", "4", "6", "4", "1"};
  d.denominator = "8";
  d.claims = {symmetric("0"),
              sum_rules(4, "yes"),
              generates(space({{{}, 4}}), array({})),
              reproduces(space({{{}, 2}}), 2),
              maximal(space({{{}, 4}}), space({{{}, 2}})),
              well_defined(array({}))};
  return d;
}

inline Document dd4() {
  Document d;
  d.scheme = "dd:l=2";
  d.lowest = -3;
  d.numerators = {"-1", "0", "9", "16", "9", "0", "-1"};
  d.denominator = "16";
  d.claims = {interpolatory(),
              symmetric("0"),
              sum_rules(4, "yes"),
              generates(space({{{}, 4}}), array({})),
              reproduces(space({{{}, 4}}), 4),
              maximal(space({{{}, 4}}), space({{{}, 4}})),
              well_defined(array({}))};
  return d;
}

inline Value space4() { return space({{{-1}, 1}, {{0}, 2}, {{1}, 1}}); }

/// a_{+-1} = 1/2 + w, a_{+-3} = -w, w = 1/(8v(1+v)).
inline Document tension4() {
  Document d;
  d.scheme = "tension4";
  d.variables = {{"v", "level", "cosh(t/2^(k+1))"}};
  d.lowest = -3;
  d.numerators = {"-1", "0", "4*v^2+4*v+1", "8*v^2+8*v", "4*v^2+4*v+1", "0", "-1"};
  d.denominator = "8*v^2+8*v";
  d.claims = {interpolatory(),         symmetric("0"),
              sum_rules(2, "yes"),     generates(space4(), array({})),
              reproduces(space4(), 4), maximal(space4(), space4()),
              well_defined(array({}))};
  return d;
}

/// Arity 3: (1+z+z^2)(1+Ez+E^2z^2)(1+z/E+z^2/E^2)/(2v+1)^2. a(z) vanishes at v = 1/2, the open end of the domain.
inline Document ternary() {
  Document d;
  d.scheme = "exponential-bspline:space=\"1, exp(t*x), exp(-t*x)\",arity=3";
  d.arity = 3;
  d.variables = {{"v", "level", "cosh(t/3^(k+1))"}};
  d.lowest = -3;
  d.numerators = {"1", "2*v+1", "4*v^2+2*v", "4*v^2+4*v-1", "4*v^2+2*v", "2*v+1", "1"};
  d.denominator = "4*v^2+4*v+1";
  const Value v = space({{{-1}, 1}, {{0}, 1}, {{1}, 1}});
  d.claims = {symmetric("0"), generates(v, array({})), reproduces(space({{{0}, 1}}), 2), maximal(v, space({{{0}, 1}})),
              well_defined(array({}))};
  return d;
}

/// [1, 3, 3, 1]/4 about 1/2.
inline Document dual() {
  Document d;
  d.scheme = "bspline:n=2";
  d.shift = "1/2";
  d.lowest = -1;
  d.numerators = {"1", "3", "3", "1"};
  d.denominator = "4";
  d.claims = {symmetric("1/2"),
              sum_rules(3, "yes"),
              generates(space({{{}, 3}}), array({})),
              reproduces(space({{{}, 2}}), 2),
              maximal(space({{{}, 3}}), space({{{}, 2}})),
              well_defined(array({}))};
  return d;
}

/// Dual, generates {1, exp(+-2tx)} and reproduces exp(+-2tx) (half-integer powers of E); pole where 2v^2 = 1.
inline Document dual_exponential() {
  Document d;
  d.scheme = "exponential-bspline";
  d.variables = {{"v", "level", "cosh(t/2^(k+1))"}};
  d.shift = "1/2";
  d.lowest = -1;
  d.numerators = {"1", "4*v^2-1", "4*v^2-1", "1"};
  d.denominator = "8*v^3-4*v";
  const Value v = space({{{-2}, 1}, {{0}, 1}, {{2}, 1}});
  const Value w = space({{{-2}, 1}, {{2}, 1}});
  d.claims = {symmetric("1/2"), generates(v, angles({{0, "1/2"}})), reproduces(w, 2), maximal(v, w),
              well_defined(angles({{0, "1/2"}}))};
  return d;
}

/// Dual, generates {1, exp(+-tx)}: a(z) is cosh(theta/2) times a polynomial in v, zero at v = 0 only.
inline Document dual_odd() {
  Document d;
  d.scheme = "exponential-bspline";
  d.variables = {{"v", "level", "cosh(t/2^(k+1))"}};
  d.shift = "1/2";
  d.lowest = -1;
  d.numerators = {"1", "2*v+1", "2*v+1", "1"};
  d.denominator = "2*v+2";
  const Value v = space({{{-1}, 1}, {{0}, 1}, {{1}, 1}});
  d.claims = {symmetric("1/2"), generates(v, array({})), reproduces(space({{{0}, 1}}), 2),
              maximal(v, space({{{0}, 1}})), well_defined(array({}))};
  return d;
}

inline Value space6() { return space({{{-2}, 1}, {{-1}, 1}, {{0}, 2}, {{1}, 1}, {{2}, 1}}); }

/// Six points, {1, x, exp(+-tx), exp(+-2tx)}: poles at v = 1/2 and 2v^2 = 1, that is v^0 = -1/2 and 0.
inline Document harmonic6() {
  Document d;
  d.scheme = "interpolating:family=harmonic,l=3";
  d.variables = {{"v", "level", "cosh(t/2^(k+1))"}};
  d.lowest = -5;
  const std::string a3 = "-32*v^5-16*v^4+24*v^3+4*v^2-6*v+1";
  const std::string a1 = "128*v^7+192*v^6-32*v^5-144*v^4-24*v^3+28*v^2+4*v-2";
  d.denominator = "256*v^7+384*v^6-128*v^5-320*v^4+64*v^2";
  d.numerators = {"2*v+1", "0", a3, "0", a1, d.denominator, a1, "0", a3, "0", "2*v+1"};
  const Value poles = angles({{0, "2/3"}, {0, "1/2"}});
  d.claims = {interpolatory(),
              symmetric("0"),
              generates(space6(), poles),
              reproduces(space6(), 6),
              maximal(space6(), space6()),
              well_defined(poles)};
  return d;
}

inline Value space_two(long n) { return space({{{-1, 0}, 1}, {{0, -n}, 1}, {{0, 0}, 2}, {{0, n}, 1}, {{1, 0}, 1}}); }

/// Six points, {1, x, exp(+-sx), exp(+-tx)}; denominator 32 v_s v_t (v_s+1)(v_t+1)(v_s+v_t).
inline Document two_frequencies() {
  Document d;
  d.scheme = "interpolating:space=\"1, x, exp(s*x), exp(-s*x), exp(t*x), exp(-t*x)\"";
  d.variables = {{"v_s", "level", "cosh(s/2^(k+1))"}, {"v_t", "level", "cosh(t/2^(k+1))"}};
  d.lowest = -5;
  const std::string a3 = "-4*v_s^3-4*v_s^2*v_t-4*v_s^2-4*v_s*v_t^2-4*v_s*v_t+v_s-4*v_t^3-4*v_t^2+v_t+1";
  const std::string a1 =
      "16*v_s^3*v_t^2+16*v_s^3*v_t+4*v_s^3+16*v_s^2*v_t^3+32*v_s^2*v_t^2+20*v_s^2*v_t+4*v_s^2+16*v_s*v_t^3"
      "+20*v_s*v_t^2+4*v_s*v_t-2*v_s+4*v_t^3+4*v_t^2-2*v_t-2";
  d.denominator = "32*v_s^3*v_t^2+32*v_s^3*v_t+32*v_s^2*v_t^3+64*v_s^2*v_t^2+32*v_s^2*v_t+32*v_s*v_t^3+32*v_s*v_t^2";
  d.numerators = {"v_s+v_t+1", "0", a3, "0", a1, d.denominator, a1, "0", a3, "0", "v_s+v_t+1"};
  const Value v = space_two(1);
  d.claims = {interpolatory(), generates(v, array({})), reproduces(v, 6), maximal(v, v),
              well_defined(array({}), "positive-coefficients")};
  return d;
}

/// Six points, {1, x, exp(+-sx), exp(+-2tx)}; denominator 64 v_s v_t^2 (v_s+1)(2v_t^2-1)(v_s+2v_t^2-1).
inline Document two_frequencies_conditions() {
  Document d;
  d.scheme = "interpolating";
  d.variables = {{"v_s", "level", "cosh(s/2^(k+1))"}, {"v_t", "level", "cosh(t/2^(k+1))"}};
  d.lowest = -5;
  const std::string a3 = "-4*v_s^3-8*v_s^2*v_t^2-16*v_s*v_t^4+8*v_s*v_t^2+v_s-32*v_t^6+32*v_t^4-6*v_t^2";
  const std::string a1 =
      "64*v_s^3*v_t^4-32*v_s^3*v_t^2+4*v_s^3+128*v_s^2*v_t^6-64*v_s^2*v_t^4+8*v_s^2*v_t^2+128*v_s*v_t^6"
      "-112*v_s*v_t^4+24*v_s*v_t^2-2*v_s+32*v_t^6-32*v_t^4+4*v_t^2";
  d.denominator =
      "128*v_s^3*v_t^4-64*v_s^3*v_t^2+256*v_s^2*v_t^6-128*v_s^2*v_t^4+256*v_s*v_t^6-256*v_s*v_t^4+64*v_s*v_t^2";
  d.numerators = {"v_s+2*v_t^2", "0", a3, "0", a1, d.denominator, a1, "0", a3, "0", "v_s+2*v_t^2"};
  const Value v = space_two(2);
  const Value except = conditions({"2*v_t^2-1", "v_s+2*v_t^2-1"});
  d.claims = {interpolatory(), generates(v, except), reproduces(v, 6), maximal(v, v),
              well_defined(except, "positive-coefficients")};
  return d;
}

/// The 4-point scheme with a constant tension parameter.
inline Document constant_tension() {
  Document d;
  d.scheme = "mask";
  d.variables = {{"w", "constant", "tension"}};
  d.lowest = -3;
  d.numerators = {"-2*w", "0", "2*w+1", "2", "2*w+1", "0", "-2*w"};
  d.denominator = "2";
  d.claims = {interpolatory(),
              symmetric("0"),
              sum_rules(2, "yes"),
              generates(space({{{}, 2}}), array({})),
              reproduces(space({{{}, 2}}), 2),
              maximal(space({{{}, 2}}), space({{{}, 2}})),
              well_defined(array({}), "positive-coefficients")};
  return d;
}

/// Refutations, each with its witness, about the tension scheme, a lopsided mask and the harmonic poles.
inline Document refuted() {
  Document d = tension4();  // E = 2: v = 5/4, w = 2/45
  const Value at = texts({"2"});
  const Value zero_pair = numbers({0, 1});
  d.claims = {
      // sums of i^2 a_i: even class 0, odd class 2(1/2 + w) - 18w = 1 - 16w = 13/45
      claim("sum-rules", "refuted",
            {{"order", number(3)},
             {"witness",
              object({{"at", at}, {"power", number(2)}, {"residues", zero_pair}, {"values", texts({"0", "13/45"})}})}},
            "definition"),
      claim("generates", "refuted",
            {{"space", space({{{0}, 3}})},
             {"witness", object({{"at", at},
                                 {"frequency", numbers({0})},
                                 {"power", number(2)},
                                 {"residues", zero_pair},
                                 {"values", texts({"0", "13/45"})}})}},
            "generation-stepwise"),
      claim("reproduces", "refuted",
            {{"space", space({{{0}, 3}})},
             {"witness", object({{"at", at},
                                 {"frequency", numbers({0})},
                                 {"power", number(2)},
                                 {"residue", number(1)},
                                 {"value", text("13/45")}})}},
            "reproduction-stepwise"),
      claim("maximal", "refuted", {{"space", space({{{0}, 2}})}, {"witness", object({{"larger", space4()}})}},
            "hurwitz-count"),
  };
  return d;
}

inline Document refuted_mask() {
  Document d;  // [1, 2]/2, indices 0, 1
  d.scheme = "mask";
  d.numerators = {"1", "2"};
  d.denominator = "2";
  d.claims = {
      claim("interpolatory", "refuted",
            {{"witness", object({{"at", array({})}, {"index", number(0)}, {"value", text("1/2")}})}}, "definition"),
      claim("symmetric", "refuted",
            {{"witness",
              object({{"at", array({})}, {"index", number(0)}, {"value", text("1/2")}, {"mirror", text("1")}})}},
            "definition"),
  };
  return d;
}

inline Document refuted_poles() {
  Document d = harmonic6();
  d.claims = {
      claim("well-defined", "refuted", {{"witness", object({{"level", number(0)}, {"angle", text("2/3")}})}}, "sturm")};
  return d;
}

inline std::vector<std::pair<std::string, Document>> all() {
  return {{"cubic_bspline", cubic_bspline()},
          {"dd4", dd4()},
          {"tension4", tension4()},
          {"ternary", ternary()},
          {"dual", dual()},
          {"dual_exponential", dual_exponential()},
          {"dual_odd", dual_odd()},
          {"harmonic6", harmonic6()},
          {"two_frequencies", two_frequencies()},
          {"two_frequencies_conditions", two_frequencies_conditions()},
          {"constant_tension", constant_tension()},
          {"refuted", refuted()},
          {"refuted_mask", refuted_mask()},
          {"refuted_poles", refuted_poles()}};
}

}  // namespace samples
