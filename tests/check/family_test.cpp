// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the checker: joint spectral radii along a parameter of the mask.
#include "expectations.hpp"
#include "smoothness_samples.hpp"

#include "twoscale/check/function_polytope.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

namespace {

using namespace samples;
using twoscale::check::check_text;
using twoscale::check::Dense;
using twoscale::check::FunctionVector;
using twoscale::check::Meter;
using twoscale::check::PolynomialMatrix;
using twoscale::check::Report;

// ---- algebra

TEST(PolynomialMatrix, DeterminantsHaveTheirSign) {
  Meter meter;
  const auto det = [&](std::size_t n, std::vector<Dense> entries) {
    PolynomialMatrix m{n, n, std::move(entries)};
    return eliminate(m, n, meter);
  };
  EXPECT_EQ(det(1, {{-3, 2}}), (Dense{-3, 2}));
  EXPECT_EQ(det(2, {{}, {1}, {1}, {}}), (Dense{-1}));
  EXPECT_EQ(det(2, {{0, 1}, {1}, {1}, {0, 1}}), (Dense{-1, 0, 1}));
  EXPECT_EQ(det(2, {{0, 1}, {0, 2}, {3}, {6}}), (Dense{}));
  EXPECT_EQ(det(3, {{}, {}, {1}, {1}, {}, {}, {}, {1}, {}}), (Dense{1}));  // an even permutation
  EXPECT_EQ(det(3, {{0, 1}, {1}, {2}, {}, {}, {1, 1}, {}, {0, 0, 1}, {5}}), (Dense{0, 0, 0, -1, -1}));
}

TEST(PolynomialMatrix, Solutions) {
  Meter meter;
  // (u, 1, 0) and (1, 0, u): 2u (u, 1, 0) - 3 (1, 0, u)
  PolynomialMatrix m{3, 3, {{0, 1}, {1}, {-3, 0, 2}, {1}, {}, {0, 2}, {}, {0, 1}, {0, -3}}};
  const Dense p = eliminate(m, 2, meter);
  EXPECT_EQ(m.at(0, 2), multiply(p, {0, 2}, meter));
  EXPECT_EQ(m.at(1, 2), multiply(p, {-3}, meter));
  EXPECT_TRUE(m.at(2, 2).empty());
  PolynomialMatrix outside{3, 3, {{0, 1}, {1}, {-3, 0, 2}, {1}, {}, {0, 2}, {}, {0, 1}, {0, 3}}};
  EXPECT_FALSE(eliminate(outside, 2, meter).empty());
  EXPECT_FALSE(outside.at(2, 2).empty());
  PolynomialMatrix wide{1, 3, {{1}, {0, 1}, {1}}};
  EXPECT_TRUE(eliminate(wide, 2, meter).empty());
}

TEST(FunctionVector, LowestTerms) {
  Meter meter;
  const auto expect = [&](FunctionVector v, const std::vector<Dense>& list, const Dense& denominator) {
    v = reduced(std::move(v), meter);
    EXPECT_EQ(v.list, list);
    EXPECT_EQ(v.denominator, denominator);
  };
  expect({{{-2, 0, 2}, {2, 2}}, {-4, -4}}, {{1, -1}, {-1}}, {2});
  expect({{{}, {}}, {0, -6}}, {{}, {}}, {1});
  expect({{}, {0, -6}}, {}, {1});
  expect({{{}, {6}}, {-4, 2}}, {{}, {3}}, {-2, 1});
  expect({{{0, 3}, {0, 0, 6}}, {0, 0, 9}}, {{1}, {0, 2}}, {0, 3});
}

TEST(Univariate, SignsInAnInterval) {
  Meter meter;
  const auto positive = [&](const Dense& p) { return is_positive_between(p, {-1, 1}, {1, 1}, meter); };
  const auto nonnegative = [&](const Dense& p) { return is_nonnegative_between(p, {-1, 1}, {1, 1}, meter); };
  EXPECT_TRUE(positive({1}));
  EXPECT_FALSE(positive({-1}));
  EXPECT_FALSE(positive({}));
  EXPECT_TRUE(nonnegative({}));
  EXPECT_FALSE(nonnegative({-2}));
  EXPECT_TRUE(positive({1, 0, -1}));  // zeros at the ends
  EXPECT_FALSE(positive({0, 0, 1}));
  EXPECT_TRUE(nonnegative({0, 0, 1}));
  EXPECT_FALSE(nonnegative({0, 0, -1}));
  EXPECT_FALSE(nonnegative({0, 1}));
  EXPECT_FALSE(nonnegative({0, 0, 0, 1}));
  EXPECT_FALSE(nonnegative({-1, 0, 2}));
  EXPECT_TRUE(nonnegative({0, 0, 1, 0, -1}));  // x^2 (1 - x^2)
  EXPECT_TRUE(nonnegative({1, 2, 1}));
}

// ---- certificates

using Strings = std::vector<std::string>;

Value nonnegative_family(const Strings& parameter, const std::string& relation, const std::string& bound,
                         long order = 2) {
  return claim(
      "nonnegative-family", "proved",
      {{"order", number(order)}, {"parameter", texts(parameter)}, {"relation", text(relation)}, {"bound", text(bound)}},
      "nonnegative-symbol");
}
Value jsr_lower_family(long order, const Strings& parameter, const std::vector<long>& word, long sign,
                       const std::string& bound) {
  return claim("jsr-lower-family", "proved",
               {{"order", number(order)},
                {"parameter", texts(parameter)},
                {"word", numbers(word)},
                {"sign", number(sign)},
                {"bound", text(bound)}},
               "spectral-radius");
}

Value support(const std::vector<long>& vertices) { return object({{"support", numbers(vertices)}}); }

/// A claim `jsr-family` that can be changed before it is built.
struct Closed {
  Strings parameter, phi, psi;
  std::vector<Value> roots;
  std::vector<std::vector<long>> tree;
  std::vector<long> inner;
  std::vector<Value> images;
  long order = 4;

  Value build() const {
    std::vector<Value> edges;
    for (const auto& edge : tree) edges.push_back(numbers(edge));
    const auto fraction = [](const Strings& f) {
      return object({{"numerator", text(f[0])}, {"denominator", text(f[1])}});
    };
    return claim("jsr-family", "proved",
                 {{"order", number(order)},
                  {"parameter", texts(parameter)},
                  {"substitution", fraction(phi)},
                  {"radius", fraction(psi)},
                  {"roots", array(roots)},
                  {"tree", array(edges)},
                  {"inner", numbers(inner)},
                  {"images", array(images)}},
                 "invariant-polytope");
  }
};

/// A quasi-spline of degree 3, of order 4 for every w:
/// rho = w + sqrt(w(4-7w)), then 2w for w in [1/2, 1], then 4w - 2.
Document quasi_spline() {
  Document d;
  d.scheme = "quasi-spline";
  d.variables = {{"w", "constant", "weight"}};
  d.lowest = -3;
  d.numerators = {"w", "2*w+1", "-w+4", "-4*w+6", "-w+4", "2*w+1", "w"};
  d.denominator = "8";
  return d;
}
Closed large() {
  return {{"1", "2"},
          {"u", "1"},
          {"4*u-2", "1"},
          {root({0}, -1, "2/7", {"-3*u+1", "u"}), root({1}, -1, "2/7", {"-u", "3*u-1"})},
          {{0, 1}},
          {0, 1},
          {equals(0, -1), equals(2, -1), equals(1, -1), support({0, 1}), support({0, 1})}};
}
Closed middle() {
  return {{"7/10", "1"},
          {"u", "1"},
          {"2*u", "1"},
          {root({0}, 1, "1", {"0", "1"}), root({1}, 1, "1", {"1", "0"})},
          {{0, 1}, {1, 0}},
          {0, 2},
          {equals(0, 1), equals(1, 1), support({1, 2}), support({0, 1}), support({0, 1}), support({0, 3})}};
}
Closed quadratic() {
  return {{"2", "4"},
          {"16", "u^2+28"},
          {"8*u+16", "u^2+28"},
          {root({0, 1}, 1, "1/4", {"4", "u-2"})},
          {{0, 0}, {0, 1}, {1, 0}},
          {0, 3},
          {equals(0, 1), support({0, 1}), support({2, 3}), support({2, 3}), support({0, 1})}};
}

Closed inverse() {
  Closed c = large();
  c.parameter = {"0", "1"};
  c.phi = {"1", "u"};
  c.psi = {"-2*u+4", "u"};
  c.roots = {root({0}, -1, "2/7", {"u-3", "1"}), root({1}, -1, "2/7", {"-1", "-u+3"})};
  return c;
}

/// c = (w, 2-w): rho = max(|w|, |2-w|), matrices of one row. One of the vectors vanishes inside.
Document straight() {
  Document d;
  d.scheme = "straight";
  d.variables = {{"w", "constant", "weight"}};
  d.numerators = {"w", "2", "-w+2"};
  d.denominator = "2";
  return d;
}
Closed line() {
  return {{"1", "3"},
          {"u", "1"},
          {"u", "1"},
          {root({0}, 1, "1", {"1"}), root({0}, 1, "1", {"u-2"})},
          {},
          {0},
          {equals(0, 1), support({1}), equals(1, 1), support({0})},
          1};
}

// ---- independent floating point

using Rows = std::vector<std::vector<double>>;

Rows times(const Rows& a, const Rows& b) {
  Rows c(a.size(), std::vector<double>(a.size()));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < a.size(); ++j) {
      for (std::size_t k = 0; k < a.size(); ++k) c[i][j] += a[i][k] * b[k][j];
    }
  }
  return c;
}
double norm(const Rows& a) {
  double largest = 0;
  for (const auto& row : a) {
    double total = 0;
    for (const double x : row) total += std::abs(x);
    largest = std::max(largest, total);
  }
  return largest;
}
/// By 25 squarings.
double spectral_radius(Rows a) {
  double logarithm = 0, weight = 1;
  for (int i = 0; i < 25; ++i) {
    const double size = norm(a);
    if (size == 0) return 0;
    logarithm += weight * std::log(size);
    weight /= 2;
    for (auto& row : a) {
      for (double& x : row) x /= size;
    }
    a = times(a, a);
  }
  return std::exp(logarithm);
}

/// B_0, B_1 of the binary mask a(w) for the order N; empty if there is no such remainder.
std::vector<Rows> matrices(std::vector<double> a, long order) {
  for (long n = 0; n < order; ++n) {
    std::vector<double> q;
    double last = 0;
    for (const double x : a) q.push_back(last = 2 * x - last);
    if (order > 10 || q.size() < 2 || std::abs(last) > 1e-9) return {};
    q.pop_back();
    a = q;
  }
  const auto n0 = static_cast<long>(a.size()) - 1;
  const auto size = static_cast<std::size_t>(std::max(1L, n0));
  std::vector<Rows> list;
  for (long s = 0; s < 2; ++s) {
    Rows b(size, std::vector<double>(size));
    for (std::size_t p = 0; p < size; ++p) {
      for (std::size_t q = 0; q < size; ++q) {
        const long i = n0 - 1 + s + static_cast<long>(p) - 2 * static_cast<long>(q);
        if (i >= 0 && i <= n0) b[p][q] = a[static_cast<std::size_t>(i)];
      }
    }
    list.push_back(std::move(b));
  }
  return list;
}

/// The largest n-th root of a spectral radius of a product of n <= 4 matrices. It is rho where these tests need it.
double radius(const std::vector<Rows>& list) {
  std::vector<Rows> products = list;
  double largest = 0;
  for (int n = 1; n <= 4; ++n) {
    for (const Rows& p : products) largest = std::max(largest, std::pow(spectral_radius(p), 1.0 / n));
    std::vector<Rows> next;
    for (const Rows& a : list) {
      for (const Rows& p : products) next.push_back(times(a, p));
    }
    products = std::move(next);
  }
  return largest;
}

/// The value of a polynomial in one variable, in the canonical spelling.
double value(const std::string& p, const std::string& name, double x) {
  Meter meter;
  const Strings names{name};
  const Dense q = twoscale::check::dense(twoscale::check::parse_polynomial(p, names, "p", meter));
  double result = 0;
  for (std::size_t i = q.size(); i-- > 0;) result = result * x + static_cast<double>(q[i]);
  return result;
}

/// Is the claim true of the mask, as far as interior points of the interval tell?
bool is_true(const Document& mask, const Value& one) {
  const auto& ends = member(one, "parameter").items;
  const double low = real(ends[0]), high = real(ends[1]);
  if (!(low < high)) return false;
  const std::string& name = member(one, "claim").text;
  const auto fraction = [&](const std::string& key, double u) {
    const Value& f = member(one, key);
    return value(member(f, "numerator").text, "u", u) / value(member(f, "denominator").text, "u", u);
  };
  for (const double part : {0.001, 0.25, 0.5, 0.7, 0.999}) {
    const double u = low + part * (high - low);
    const double w = name == "jsr-family" ? fraction("substitution", u) : u;
    std::vector<double> a;
    for (const std::string& p : mask.numerators) a.push_back(value(p, "w", w) / std::stod(mask.denominator));
    const std::vector<Rows> list = matrices(a, member(one, "order").number);
    if (list.empty()) return false;
    const double rho = radius(list), slack = 1e-6 * (1 + rho);
    if (name == "jsr-family") {
      if (std::abs(rho - fraction("radius", u)) > slack) return false;
      continue;
    }
    const double bound = real(member(one, "bound"));
    const bool below = name == "nonnegative-family" && member(one, "relation").text == "below";
    if (below ? rho > bound + slack : rho < bound - slack) return false;
  }
  return true;
}

TEST(Family, OracleKnowsTheClosedForms) {
  const Document d = quasi_spline();
  for (const double w : {0.3, 0.45, 0.6, 0.9, 1.3, 1.9}) {
    std::vector<double> a;
    for (const std::string& p : d.numerators) a.push_back(value(p, "w", w) / 8);
    const double rho = w < 0.5 ? w + std::sqrt(w * (4 - 7 * w)) : w < 1 ? 2 * w : 4 * w - 2;
    EXPECT_NEAR(radius(matrices(a, 4)), rho, 1e-6) << w;
  }
}

TEST(Family, NonnegativeSymbols) {
  const Document d = constant_tension();
  // The symbol is non-negative for w in [-1/2, 1/16], with a double zero for w = -1/2; rho is 2 for w = 0.
  expect_valid(d.with(nonnegative_family({"-1/2", "1/16"}, "below", "8")));
  expect_valid(d.with(nonnegative_family({"-1/2", "1/16"}, "below", "4")));
  expect_valid(d.with(nonnegative_family({"-1/2", "0"}, "above", "2")));
  expect_valid(d.with(nonnegative_family({"0", "1/16"}, "below", "2")));
  expect_invalid(d.with(nonnegative_family({"-51/100", "0"}, "above", "2")), "changes its sign");
  expect_invalid(d.with(nonnegative_family({"0", "1/8"}, "below", "2")), "changes its sign");
  expect_invalid(d.with(nonnegative_family({"-1/2", "1/32"}, "below", "2")), "is an eigenvalue");
  expect_invalid(d.with(nonnegative_family({"-1/2", "0"}, "below", "2")), "other side");
  expect_invalid(d.with(nonnegative_family({"0", "1/16"}, "above", "2")), "other side");
  expect_invalid(d.with(nonnegative_family({"0", "1/16"}, "below", "2", 3)), "sum rules");
  expect_invalid(d.with(nonnegative_family({"0", "1/16"}, "below", "2", 1)), "symmetric of even degree");
  expect_invalid(d.with(nonnegative_family({"0", "1/16"}, "below", "2", 0)), "positive");
  expect_malformed(d.with(nonnegative_family({"0", "0"}, "below", "2")), "ascend");
  expect_malformed(d.with(nonnegative_family({"1/16", "0"}, "below", "2")), "ascend");
  expect_malformed(d.with(nonnegative_family({}, "below", "2")), "two numbers");
  expect_malformed(d.with(nonnegative_family({"0", "1/16"}, "beside", "2")), "\"above\" is expected");
  expect_malformed(d.with(nonnegative_family({"0", "1/16"}, "below", "0")), "positive");
  expect_malformed(d.with(nonnegative_family({"0", "1/16"}, "below", "-2")), "positive");
  expect_malformed(dd4().with(nonnegative_family({"0", "1/16"}, "below", "2")), "exactly one variable");
  expect_malformed(tension4().with(nonnegative_family({"0", "1/16"}, "below", "2")), "exactly one variable");
  expect_malformed(golden().with(nonnegative_family({"0", "1/16"}, "below", "2")), "not about matrices");
  // Symmetric for one w only.
  Document skew = d;
  skew.numerators = {"-w+1", "1", "w+1", "1"};
  skew.denominator = "2";
  expect_invalid(skew.with(nonnegative_family({"-1/8", "1/8"}, "below", "4", 1)), "symmetric");
}

TEST(Family, LowerBounds) {
  const Document d = quasi_spline();  // B_0 = (0 ...): the eigenvalues 2w and 2 - 4w
  expect_valid(d.with(jsr_lower_family(4, {"3/2", "2"}, {0}, -1, "4")));
  expect_valid(d.with(jsr_lower_family(4, {"3/2", "2"}, {0, 0}, 1, "4")));
  expect_valid(d.with(jsr_lower_family(4, {"1/2", "1"}, {0}, 1, "1")));
  expect_invalid(d.with(jsr_lower_family(4, {"3/2", "2"}, {0}, 1, "4")), "eigenvalue");
  expect_invalid(d.with(jsr_lower_family(4, {"3/2", "2"}, {0, 0}, -1, "4")), "eigenvalue");
  expect_invalid(d.with(jsr_lower_family(4, {"149/100", "2"}, {0}, -1, "4")), "eigenvalue");
  expect_invalid(d.with(jsr_lower_family(4, {"3/2", "2"}, {0}, -1, "401/100")), "eigenvalue");
  expect_invalid(d.with(jsr_lower_family(5, {"3/2", "2"}, {0}, -1, "4")), "sum rules");
  expect_malformed(d.with(jsr_lower_family(4, {"3/2", "2"}, {}, -1, "4")), "at least one");
  expect_malformed(d.with(jsr_lower_family(4, {"3/2", "2"}, {2}, -1, "4")), "word");
  expect_malformed(d.with(jsr_lower_family(4, {"3/2", "2"}, {0}, 0, "4")), "sign");
  expect_malformed(d.with(jsr_lower_family(4, {"3/2", "2"}, {0}, -1, "0")), "positive");
}

TEST(Family, ClosedForms) {
  const Document d = quasi_spline();
  for (const Closed& c : {large(), middle(), quadratic()}) expect_valid(d.with(c.build()));
  const auto invalid = [&](Closed c, const std::string& reason, const auto& change) {
    change(c);
    expect_invalid(d.with(c.build()), reason);
  };
  const auto malformed = [&](Closed c, const std::string& reason, const auto& change) {
    change(c);
    expect_malformed(d.with(c.build()), reason);
  };
  invalid(large(), "leaves the hull", [](Closed& c) { c.parameter = {"9/10", "2"}; });
  invalid(middle(), "leaves the hull", [](Closed& c) { c.parameter = {"69/100", "1"}; });
  invalid(middle(), "leaves the hull", [](Closed& c) { c.parameter = {"7/10", "101/100"}; });
  invalid(quadratic(), "leaves the hull", [](Closed& c) { c.parameter = {"19/10", "4"}; });
  invalid(quadratic(), "leaves the hull", [](Closed& c) { c.parameter = {"2", "5"}; });
  invalid(large(), "no eigenvector", [](Closed& c) { c.psi = {"4*u-1", "1"}; });
  invalid(large(), "not positive", [](Closed& c) { c.psi = {"-4*u+2", "1"}; });
  invalid(large(), "not positive", [](Closed& c) { c.parameter = {"0", "2"}; });
  invalid(large(), "pole", [](Closed& c) { c.psi = {"1", "2*u-3"}; });
  invalid(large(), "pole", [](Closed& c) { c.phi = {"1", "2*u-3"}; });
  invalid(large(), "is 0", [](Closed& c) { c.roots[0] = root({0}, -1, "1", {"0", "0"}); });
  invalid(large(), "no eigenvector", [](Closed& c) { c.roots[0] = root({1}, -1, "1", {"-3*u+1", "u"}); });
  invalid(large(), "no eigenvector", [](Closed& c) { c.roots[0] = root({0}, 1, "1", {"-3*u+1", "u"}); });
  invalid(large(), "linearly independent", [](Closed& c) { c.inner = {0, 0}; });
  invalid(large(), "not the vertex", [](Closed& c) { c.images[0] = equals(0, 1); });
  invalid(large(), "linearly dependent", [](Closed& c) { c.images[3] = support({0, 1, 2}); });
  invalid(large(), "no combination", [](Closed& c) { c.images[3] = support({0}); });
  invalid(large(), "no combination", [](Closed& c) { c.images[3] = support({}); });
  invalid(large(), "sum rules", [](Closed& c) { c.order = 5; });
  malformed(large(), "lowest terms", [](Closed& c) { c.psi = {"8*u-4", "2"}; });
  malformed(large(), "lowest terms", [](Closed& c) { c.psi = {"-4*u+2", "-1"}; });
  malformed(large(), "lowest terms", [](Closed& c) { c.phi = {"u^2", "u"}; });
  malformed(large(), "is 0", [](Closed& c) { c.phi = {"u", "0"}; });
  malformed(large(), "", [](Closed& c) { c.phi = {"w", "1"}; });
  malformed(large(), "without a word", [](Closed& c) { c.roots[0] = root({}, -1, "1", {"-3*u+1", "u"}); });
  invalid(large(), "no eigenvector of a product", [](Closed& c) {
    c.roots = {root({}, 1, "1", {"-3*u+1", "u"}), root({}, 1, "1", {"-u", "3*u-1"})};
  });
  malformed(large(), "positive", [](Closed& c) { c.roots[0] = root({0}, -1, "-1", {"-3*u+1", "u"}); });
  malformed(large(), "2 are expected", [](Closed& c) { c.roots[0] = root({0}, -1, "1", {"1"}); });
  malformed(large(), "twice", [](Closed& c) { c.tree = {{0, 1}, {0, 1}}; });
  malformed(large(), "tree", [](Closed& c) { c.tree = {{2, 1}}; });
  malformed(large(), "indices are expected", [](Closed& c) { c.inner = {0}; });
  malformed(large(), "ascend", [](Closed& c) { c.images[3] = support({1, 0}); });
  malformed(large(), "are expected", [](Closed& c) { c.images.pop_back(); });
  malformed(large(), "no root", [](Closed& c) { c.roots.clear(); });
  // In u = 2w - 1 the same claim; in u = 1/w up to the pole.
  Closed shifted = large();
  shifted.parameter = {"1", "3"};
  shifted.phi = {"u+1", "2"};
  shifted.psi = {"2*u", "1"};
  shifted.roots = {root({0}, -1, "2/7", {"-3*u-1", "u+1"}), root({1}, -1, "2/7", {"-u-1", "3*u+1"})};
  expect_valid(d.with(shifted.build()));
  expect_valid(d.with(inverse().build()));
  invalid(inverse(), "pole", [](Closed& c) { c.parameter = {"-1/10", "1"}; });
  invalid(inverse(), "leaves the hull", [](Closed& c) { c.parameter = {"0", "11/10"}; });
}

TEST(Family, ZerosAndPolesInside) {
  const Document d = straight();
  expect_valid(d.with(line().build()));
  Closed c = line();
  c.inner = {1};
  expect_invalid(d.with(c.build()), "linearly independent in the whole interval");
  c.parameter = {"2", "3"};
  expect_valid(d.with(c.build()));
  c = line();
  c.images[0] = support({1});
  expect_invalid(d.with(c.build()), "pole");
  c = line();
  c.parameter = {"99/100", "3"};
  expect_invalid(d.with(c.build()), "leaves the hull");
  c = line();
  c.parameter = {"1", "4"};
  expect_valid(d.with(c.build()));  // (u-2)^2 <= u
  c.parameter = {"1", "401/100"};
  expect_invalid(d.with(c.build()), "leaves the hull");
  c = line();
  c.psi = {"-u", "1"};
  expect_invalid(d.with(c.build()), "not positive");
}

TEST(Family, MuchWorkEnds) {
  const auto ends = [](const Document& d) {
    const Report report = check_text(d.sealed(), 200'000'000);
    EXPECT_NE(report.status, Report::valid);
    EXPECT_NE(report.message, "");
  };
  const Document d = quasi_spline();
  ends(d.with(jsr_lower_family(4, {"3/2", "2"}, std::vector<long>(4096, 0), 1, "5")));
  Closed c = large();
  c.phi = {"7*u^4096+u^3-1", "3*u^4095+1"};
  ends(d.with(c.build()));
  c.psi = {"5*u^4096+u^2+1", "1"};
  c.phi = {"u^4096+u", "1"};
  c.roots[0] = root(std::vector<long>(4096, 1), 1, "1", {"u^4096+1", "1"});
  ends(d.with(c.build()));
  Document wide;
  wide.variables = {{"w", "constant", "weight"}};
  wide.numerators.assign(256, "2*w+1");
  wide.denominator = "128";
  for (std::size_t i = 128; i < 256; ++i) wide.numerators[i] = "-2*w+1";
  ends(wide.with(jsr_lower_family(1, {"0", "1"}, {0, 1}, 1, "1000000")));
  ends(wide.with(nonnegative_family({"0", "1"}, "below", "1000000", 1)));
}

// ---- mutations

void expect_only_true_families(const Document& d) {
  const std::string text = d.sealed();
  expect_only_true_mutants(text, text.find("\"claims\""),
                           [&](const Value&, const Value& one) { return is_true(d, one); });
}

TEST(FamilyMutation, NonnegativeSymbols) {
  Document d = constant_tension();
  d.claims = {nonnegative_family({"-1/2", "1/16"}, "below", "4"), nonnegative_family({"-1/2", "0"}, "above", "2")};
  expect_only_true_families(d);
}

TEST(FamilyMutation, LowerBounds) {
  Document d = quasi_spline();
  d.claims = {jsr_lower_family(4, {"3/2", "2"}, {0}, -1, "4"), jsr_lower_family(4, {"3/2", "2"}, {1, 1}, 1, "4")};
  expect_only_true_families(d);
  expect_only_true_families(constant_tension().with(jsr_lower_family(2, {"1/5", "1/4"}, {0, 1}, 1, "2")));
}

TEST(FamilyMutation, ClosedForms) {
  for (const Closed& c : {large(), middle(), quadratic(), inverse()}) {
    expect_only_true_families(quasi_spline().with(c.build()));
  }
  expect_only_true_families(straight().with(line().build()));
}

}  // namespace
