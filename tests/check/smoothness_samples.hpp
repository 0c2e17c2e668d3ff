// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the checker: certificates about joint spectral radii, stability and level-dependent regularity, built by
// hand.
#pragma once

#include "samples.hpp"

namespace samples {

/// A document with matrices: each a list of rows.
struct Matrices {
  std::string scheme = "matrices";
  Value matrices;
  std::vector<Value> claims;

  std::string sealed() const {
    return twoscale::check::sealed(twoscale::check::canonical_json(object({{"format", text("twoscale/certificate")},
                                                                           {"version", number(1)},
                                                                           {"scheme", text(scheme)},
                                                                           {"matrices", matrices},
                                                                           {"claims", array(claims)},
                                                                           {"digest", text("")}})));
  }
  twoscale::check::Report check() const { return twoscale::check::check_text(sealed()); }
  Matrices with(Value one) const {
    Matrices d = *this;
    d.claims = {std::move(one)};
    return d;
  }
};

inline Value matrix(const std::vector<std::vector<std::string>>& rows) {
  std::vector<Value> items;
  for (const auto& row : rows) items.push_back(texts(row));
  return array(std::move(items));
}

inline Value root(const std::vector<long>& word, long sign, const std::string& scale,
                  const std::vector<std::string>& vector) {
  return object({{"word", numbers(word)}, {"sign", number(sign)}, {"scale", text(scale)}, {"vector", texts(vector)}});
}
inline Value equals(long vertex, long sign) { return object({{"equals", number(vertex)}, {"sign", number(sign)}}); }
inline Value sum(const std::vector<std::pair<long, std::string>>& parts) {
  std::vector<Value> items;
  for (const auto& [vertex, c] : parts) items.push_back(array({number(vertex), text(c)}));
  return object({{"sum", array(std::move(items))}});
}
inline Value block(long size, const std::string& bound, std::vector<Value> roots,
                   const std::vector<std::vector<long>>& tree, const std::vector<long>& inner,
                   std::vector<Value> images) {
  std::vector<Value> edges;
  for (const auto& edge : tree) edges.push_back(numbers(edge));
  return object({{"size", number(size)},
                 {"bound", text(bound)},
                 {"roots", array(std::move(roots))},
                 {"tree", array(std::move(edges))},
                 {"inner", numbers(inner)},
                 {"images", array(std::move(images))}});
}
inline Value jsr_lower(long order, const std::vector<std::string>& parameter, const std::vector<long>& word,
                       const std::string& bound) {
  return claim(
      "jsr-lower", "proved",
      {{"order", number(order)}, {"parameter", texts(parameter)}, {"word", numbers(word)}, {"bound", text(bound)}},
      "spectral-radius");
}
inline Value jsr_upper(long order, const std::vector<std::string>& parameter, const std::string& bound, Value basis,
                       std::vector<Value> blocks) {
  return claim("jsr-upper", "proved",
               {{"order", number(order)},
                {"parameter", texts(parameter)},
                {"bound", text(bound)},
                {"basis", std::move(basis)},
                {"blocks", array(std::move(blocks))}},
               "invariant-polytope");
}
inline Value jsr_exact(long order, const std::vector<std::string>& parameter, const std::string& polynomial,
                       const std::vector<std::string>& interval, long bits, Value basis, std::vector<Value> blocks) {
  return claim(
      "jsr-exact", "proved",
      {{"order", number(order)},
       {"parameter", texts(parameter)},
       {"radius", object({{"polynomial", text(polynomial)}, {"interval", texts(interval)}, {"bits", number(bits)}})},
       {"basis", std::move(basis)},
       {"blocks", array(std::move(blocks))}},
      "invariant-polytope");
}
inline Value nonnegative(long order, const std::string& of, const std::string& polynomial,
                         const std::vector<std::string>& interval) {
  return claim("nonnegative-symbol", "proved",
               {{"order", number(order)},
                {"of", text(of)},
                {"radius", object({{"polynomial", text(polynomial)}, {"interval", texts(interval)}})}},
               "nonnegative-symbol");
}
inline Value stable() { return claim("stability", "proved", {}, "jia-wang"); }
inline Value unstable() {
  return claim("stability", "refuted", {{"witness", object({{"kind", text("common-zero")}})}}, "jia-wang");
}
inline Value unstable(long order) {
  return claim("stability", "refuted", {{"witness", object({{"kind", text("cycle")}, {"order", number(order)}})}},
               "jia-wang");
}
inline Value nonstationary(Value v, long continuity) {
  return claim("nonstationary", "proved", {{"space", std::move(v)}, {"continuity", number(continuity)}},
               "nonstationary");
}

/// The block of a matrix family of one row whose entries are b_0, b_1 with b_0 = 0, b_1 = rho.
inline Value line_block(const std::string& bound) {
  return block(1, bound, {bound.empty() ? root({1}, 1, "1", {"1"}) : root({}, 1, "1", {"1"})}, {}, {0},
               {sum({}), equals(0, 1)});
}

/// rho = m for n0 = 0: B_0 = (0), B_1 = (2).
inline Document bspline_radius() {
  Document d = cubic_bspline();
  d.claims = {jsr_lower(4, {}, {1}, "2"),
              jsr_upper(4, {}, "2", array({}), {line_block("2")}),
              jsr_exact(4, {}, "x-2", {"1", "3"}, 0, array({}), {line_block("")}),
              nonnegative(4, "remainder", "x-2", {"2", "2"}),
              nonnegative(4, "autocorrelation", "x-4", {"7/2", "5"}),
              stable()};
  return d;
}

/// B_0 = (4 0; -1 -1), B_1 = (-1 -1; 0 4), rho = 4.
inline Value dd4_block(const std::string& bound) {
  const std::vector<long> first = bound.empty() ? std::vector<long>{0} : std::vector<long>{};
  const std::vector<long> second = bound.empty() ? std::vector<long>{1} : std::vector<long>{};
  return block(2, bound, {root(first, 1, "1", {"5", "-1"}), root(second, 1, "1", {"1", "-5"})}, {}, {0, 1},
               {equals(0, 1), sum({}), sum({{0, "1/4"}, {1, "-1/4"}}), equals(1, 1)});
}
inline Document dd4_radius() {
  Document d = dd4();
  d.claims = {jsr_lower(4, {}, {0, 0}, "4"), jsr_upper(4, {}, "4", array({}), {dd4_block("4")}),
              jsr_exact(4, {}, "x-4", {"4", "4"}, 0, array({}), {dd4_block("")}),
              nonnegative(4, "remainder", "x-4", {"4", "4"}), stable()};
  return d;
}

/// Six points: (M_ij) = (19/2 3/2; -9/2 -9/2), x^2-5x-36 = (x-9)(x+4).
inline Document dd6_radius() {
  Document d;
  d.scheme = "dd:l=3";
  d.lowest = -5;
  d.numerators = {"3", "0", "-25", "0", "150", "256", "150", "0", "-25", "0", "3"};
  d.denominator = "256";
  d.claims = {nonnegative(6, "remainder", "x^2-5*x-36", {"8", "10"}), nonnegative(6, "remainder", "x-9", {"9", "9"}),
              stable()};
  return d;
}

/// (1 1; 0 1), (1 0; 1 1): the golden ratio, by the products of both in either order.
inline Value golden_block() {
  return block(
      2, "",
      {root({0, 1}, 1, "1", {"1", "x"}), root({1, 0}, 1, "1", {"x", "1"}), root({}, 1, "11/10", {"0", "1"}),
       root({}, 1, "11/10", {"1", "0"})},
      {{0, 1}, {1, 0}}, {2, 3},
      {equals(1, 1), equals(0, 1), sum({{0, "33/128"}, {1, "33/128"}}), sum({{2, "79/128"}}), sum({{3, "79/128"}}),
       sum({{0, "33/128"}, {1, "33/128"}}), sum({{0, "37/256"}, {1, "49/64"}}), sum({{2, "89/256"}, {4, "79/128"}}),
       sum({{3, "89/256"}, {5, "79/128"}}), sum({{0, "49/64"}, {1, "37/256"}})});
}
inline Value golden_claim() { return jsr_exact(0, {}, "x^2-x-1", {"3/2", "2"}, 64, array({}), {golden_block()}); }
inline Matrices golden() {
  Matrices d;
  d.scheme = "golden";
  d.matrices = array({matrix({{"1", "1"}, {"0", "1"}}), matrix({{"1", "0"}, {"1", "1"}})});
  d.claims = {golden_claim(), jsr_lower(0, {}, {0, 1}, "809/500")};
  return d;
}

/// The same with a second block, 1 and -1.
inline Matrices golden_and_one() {
  Matrices d;
  d.scheme = "golden and one";
  d.matrices = array({matrix({{"1", "1", "5"}, {"0", "1", "7"}, {"0", "0", "1"}}),
                      matrix({{"1", "0", "-2"}, {"1", "1", "0"}, {"0", "0", "-1"}})});
  d.claims = {
      jsr_exact(0, {}, "x^2-x-1", {"3/2", "2"}, 64, array({}),
                {golden_block(), block(1, "1", {root({}, 1, "1", {"1"})}, {}, {0}, {equals(0, 1), equals(0, -1)})})};
  return d;
}

/// (2 1; 0 1) and (-2 3; 0 1/2) in the basis (1, 1), (0, 1).
inline Matrices reducible() {
  Matrices d;
  d.scheme = "reducible";
  d.matrices = array({matrix({{"1", "1"}, {"0", "2"}}), matrix({{"-5", "3"}, {"-11/2", "7/2"}})});
  const Value basis = matrix({{"1", "0"}, {"1", "1"}});
  const auto top = [](const std::string& bound) {
    return block(1, bound, {bound.empty() ? root({0}, 1, "1", {"1"}) : root({}, 1, "1", {"1"})}, {}, {0},
                 {equals(0, 1), equals(0, -1)});
  };
  const Value low = block(1, "1", {root({}, 1, "1", {"1"})}, {}, {0}, {sum({{0, "1"}}), sum({})});
  d.claims = {jsr_exact(0, {}, "x-2", {"1", "5/2"}, 0, basis, {top(""), low}),
              jsr_upper(0, {}, "2", basis, {top("2"), low}), jsr_lower(0, {}, {1, 0, 0}, "2")};
  return d;
}

/// A quarter turn, doubled: eigenvalues +-2i.
inline Matrices turn() {
  Matrices d;
  d.scheme = "turn";
  d.matrices = array({matrix({{"0", "-2"}, {"2", "0"}})});
  d.claims = {jsr_lower(0, {}, {0}, "2"),
              jsr_upper(0, {}, "2", array({}),
                        {block(2, "2", {root({}, 1, "1", {"1", "0"})}, {{0, 0}}, {0, 1}, {equals(0, -1)})})};
  return d;
}

/// Arity 3: c = (-4, 11, -4), B_s = (c_s).
inline Document ternary_radius() {
  Document d;
  d.scheme = "dd:l=2,arity=3";
  d.arity = 3;
  d.lowest = -5;
  d.numerators = {"-4", "-5", "0", "30", "60", "81", "60", "30", "0", "-5", "-4"};
  d.denominator = "81";
  d.claims = {jsr_exact(4, {}, "x-11", {"11", "11"}, 0, array({}),
                        {block(1, "", {root({1}, 1, "1", {"1"})}, {}, {0}, {sum({}), equals(0, 1), sum({})})}),
              nonnegative(4, "remainder", "x-11", {"11", "11"}), jsr_lower(4, {}, {1}, "11"), stable()};
  return d;
}

/// w in [0, 1/16], order 2: c = (-4w, 8w, 2-8w, 8w, -4w), column sums of absolute values at most 11/4.
inline Document parameter_radius() {
  Document d = constant_tension();
  std::vector<Value> roots, images(16, sum({}));
  for (std::size_t i = 0; i < 4; ++i) {
    std::vector<std::string> unit(4, "0");
    unit[i] = "1";
    roots.push_back(root({}, 1, "1", unit));
  }
  d.claims = {jsr_upper(2, {"0", "1/16"}, "11/4", array({}), {block(4, "11/4", roots, {}, {0, 1, 2, 3}, images)}),
              jsr_lower(2, {"1/16", "1/16"}, {0}, "1")};
  return d;
}

/// The 4-point scheme of tension, with the limit of Deslauriers and Dubuc.
inline Document tension4_limit() {
  Document d = tension4();
  d.claims = {nonnegative(4, "remainder", "x-4", {"4", "4"}), nonstationary(space4(), 1), stable()};
  return d;
}

/// (1+z)(2+z)/3: order 1, autocorrelation (8, 20, 8)/9.
inline Document lopsided() {
  Document d;
  d.scheme = "mask";
  d.numerators = {"2", "3", "1"};
  d.denominator = "3";
  d.claims = {nonnegative(1, "autocorrelation", "9*x-20", {"2", "3"}), stable()};
  return d;
}

inline Document three_apart() {
  Document d;
  d.scheme = "mask";
  d.numerators = {"1", "0", "0", "1"};
  d.claims = {unstable(3)};
  return d;
}

inline Document doubled() {
  Document d;
  d.scheme = "mask";
  d.numerators = {"1", "1", "1", "1"};
  d.denominator = "2";
  d.claims = {unstable()};
  return d;
}

}  // namespace samples
