// SPDX-License-Identifier: GPL-3.0-or-later
// Signs on boxes and roots in discs: known answers, laws over random polynomials, and PARI. Whatever is decided goes
// through the independent checker; what is refuted is recomputed from its witness.
#include "twoscale/analysis/positivity.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>
#include <random>

#include "support/laws.hpp"
#include "twoscale/analysis/certificate.hpp"
#include "twoscale/analysis/root_bound.hpp"
#include "twoscale/check/check.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::analysis {

void PrintTo(Verdict v, std::ostream* out) { *out << to_string(v); }

namespace {

using Q = Rational;

const Polynomial x = Polynomial::variable("x"), y = Polynomial::variable("y"), z = Polynomial::variable("z");

void expect_valid(const nlohmann::ordered_json& evidence) {
  ASSERT_FALSE(evidence.is_null());
  const auto report = check::check_text(certificate_text("test", {evidence}));
  ASSERT_EQ(report.status, check::Report::valid) << report.message << "\n" << evidence.dump(1);
}

Positivity decide(const Polynomial& p, const Box& box, const SignOptions& options = {}) {
  Positivity r = decide_sign(p, box, options);
  if (r.verdict != Verdict::undecided) expect_valid(r.evidence);
  if (r.point) {
    EXPECT_EQ(p.evaluate(*r.point), r.value);
    EXPECT_LE(r.value.sign(), options.strict ? 0 : -1);
  }
  return r;
}

Verdict verdict(const Polynomial& p, const Box& box, const SignOptions& options = {}) {
  return decide(p, box, options).verdict;
}

SignOptions weak() {
  SignOptions o;
  o.strict = false;
  return o;
}
SignOptions except(std::vector<std::string> zeros) {
  SignOptions o;
  o.zeros = std::move(zeros);
  return o;
}

const Box unit{{"x", 0, 1}}, half_line{{"x", 0}}, square{{"x", 0, 1}, {"y", 0, 1}}, quadrant{{"y", 0}, {"x", 0}};

// ---- One variable

TEST(Univariate, ZerosAreCounted) {
  const Polynomial p = (x - 1) * (x - 1) * (x - 2) * (x * x - 2) * (x * x + 1);
  EXPECT_EQ(count_real_zeros(p), 4);
  EXPECT_EQ(count_zeros(p, 1, 2, Ends::open), 1);
  EXPECT_EQ(count_zeros(p, 1, 2, Ends::closed), 3);
  EXPECT_EQ(count_zeros(p, 0, std::nullopt, Ends::open), 3);
  EXPECT_EQ(count_zeros(p, 2, std::nullopt, Ends::closed), 1);
  EXPECT_EQ(count_zeros(Polynomial(3), 0, 1, Ends::closed), 0);
  EXPECT_EQ(count_real_zeros(Polynomial(-3)), 0);
  EXPECT_TRUE(isolate_real_zeros(Polynomial(-3)).empty());
  EXPECT_EQ(count_real_zeros(x.pow(7)), 1);
  EXPECT_EQ(sign_between(p, 1, Q(7, 5)), 1);
  EXPECT_EQ(sign_between(p, Q(3, 2), 2), -1);
  EXPECT_EQ(sign_between(p, 1, 2), 0);
  EXPECT_EQ(sign_between(p, 2, std::nullopt), 1);
  EXPECT_THROW(count_zeros(x * y, 0, 1, Ends::open), Error);
  EXPECT_THROW(count_zeros(p, 1, 1, Ends::open), Error);
}

TEST(Univariate, SquarefreeFactors) {
  const auto f = squarefree_factors((x - 1).pow(3) * (x + 2).pow(3) * (x * x + 1) * (Polynomial(2) * x - 1).pow(5));
  ASSERT_EQ(f.size(), 3U);
  EXPECT_EQ(f[0], std::pair(x * x + 1, 1U));
  EXPECT_EQ(f[1], std::pair((x - 1) * (x + 2), 3U));
  EXPECT_EQ(f[2], std::pair(Polynomial(2) * x - 1, 5U));
}

TEST(Univariate, ZerosAreIsolatedAndRefined) {
  const auto zeros = isolate_real_zeros(x * (x * x - 2) * (Polynomial(3) * x - 1));
  ASSERT_EQ(zeros.size(), 4U);
  const RootInterval r = refine_zero(x * x - 2, isolate_zeros(x * x - 2, 0, std::nullopt).at(0), Q(1, 1000000));
  EXPECT_LE(r.high - r.low, Q(1, 1000000));
  EXPECT_LT(r.low * r.low, Q(2));
  EXPECT_GT(r.high * r.high, Q(2));
}

TEST(Univariate, HighDegree) {
  Polynomial p = x * x - 2;
  for (long i = 1; i <= 30; ++i) p *= Polynomial(i) * x * x - Polynomial(2 * i - 1) * x + Polynomial(i);
  EXPECT_EQ(count_real_zeros(p), 2);
  EXPECT_EQ(isolate_real_zeros(p).size(), 2U);
  EXPECT_EQ(verdict(p, {{"x", Q(3, 2)}}), Verdict::proved);
  EXPECT_EQ(verdict(p, {{"x", Q(-7, 5)}}), Verdict::refuted);
}

LAW(Univariate, IsolationFindsTheFactors, ()) {
  std::vector<Q> roots = several(uniform<size_t>(0, 7), [] {
    const long n = uniform(-9L, 10L);
    return Q(n, uniform(1L, 6L));
  });
  Polynomial p = x * x + x + 1;
  for (const Q& r : roots) {
    p *= (Polynomial::constant(r.denominator()) * x - Polynomial::constant(r.numerator())).pow(uniform(1U, 3U));
  }
  std::sort(roots.begin(), roots.end());
  roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
  const auto found = isolate_real_zeros(p);
  LAW_ASSERT(found.size() == roots.size());
  LAW_ASSERT(count_real_zeros(p) == static_cast<long>(roots.size()));
  for (size_t i = 0; i < found.size(); ++i) {
    LAW_ASSERT(found[i].low <= roots[i] && roots[i] <= found[i].high);
    if (i > 0) LAW_ASSERT(found[i - 1].high <= found[i].low);
    if (found[i].low == found[i].high) continue;
    LAW_ASSERT(!p.evaluate({{"x", found[i].low}}).is_zero() && !p.evaluate({{"x", found[i].high}}).is_zero());
  }
}

TEST(Sign, OneVariable) {
  EXPECT_EQ(verdict(x * x - x + 1, half_line), Verdict::proved);
  EXPECT_EQ(decide(x * x - x + 1, half_line).proof.method, "sturm");
  EXPECT_EQ(verdict((x - 1).pow(2), half_line), Verdict::refuted);
  EXPECT_EQ(verdict((x - 1).pow(2), half_line, weak()), Verdict::proved);
  EXPECT_EQ(verdict((x - 1).pow(3), half_line, weak()), Verdict::refuted);
  EXPECT_EQ(verdict(x.pow(3) * (Polynomial(1) - x).pow(3), unit, weak()), Verdict::proved);
  EXPECT_EQ(verdict(x.pow(3) * (Polynomial(1) - x).pow(3), unit), Verdict::refuted);
  EXPECT_EQ(verdict(x.pow(3) * (Polynomial(1) - x).pow(3), unit, except({"x=lo", "x=hi"})), Verdict::proved);
  EXPECT_EQ(verdict(x.pow(3) * (x - 1).pow(3), unit, except({"x=lo", "x=hi"})), Verdict::refuted);
  const Positivity irrational = decide((x * x - 2).pow(2), half_line);
  EXPECT_EQ(irrational.verdict, Verdict::refuted);
  EXPECT_FALSE(irrational.point);
  ASSERT_TRUE(irrational.between);
  const Positivity third = decide((Polynomial(3) * x - 1).pow(2), unit);
  ASSERT_TRUE(third.point);
  EXPECT_EQ(third.point->at(0).second, Q(1, 3));
  EXPECT_EQ(verdict(-(x * x) + Polynomial(1000000), half_line), Verdict::refuted);
}

TEST(Sign, ConstantsAndZero) {
  EXPECT_EQ(verdict(3, {}), Verdict::proved);
  EXPECT_EQ(verdict(-3, square, weak()), Verdict::refuted);
  EXPECT_EQ(verdict(0, square), Verdict::refuted);
  EXPECT_EQ(verdict(0, square, weak()), Verdict::proved);
}

// ---- Several variables

TEST(Sign, MultiAffineByVertices) {
  const Positivity r = decide(Polynomial(2) * x * y - x - y + 2, square);
  EXPECT_EQ(r.verdict, Verdict::proved);
  EXPECT_EQ(r.proof.method, "vertices");
  EXPECT_EQ(verdict(Polynomial(2) * x * y - x - y, square, weak()), Verdict::refuted);
  EXPECT_EQ(verdict(x * y - x - y + 1, square), Verdict::refuted);
  EXPECT_EQ(verdict(x * y - x - y + 1, square, except({"x=hi", "y=hi"})), Verdict::proved);
  EXPECT_EQ(verdict(x * y - x - y + 1, square, except({"x=hi"})), Verdict::refuted);
  EXPECT_EQ(verdict(x + y, quadrant), Verdict::refuted);
  EXPECT_EQ(verdict(x + y, quadrant, except({"x=lo"})), Verdict::proved);  // the zero is on that face
  EXPECT_EQ(verdict(x * y + 1, quadrant), Verdict::proved);
  EXPECT_EQ(verdict(Polynomial(1000) + x - y, quadrant), Verdict::refuted);
  EXPECT_EQ(verdict(Polynomial(1000) + x * y - y * z, {{"x", 5}, {"y", 0}, {"z", 0, 5}}), Verdict::proved);
  EXPECT_EQ(verdict(Polynomial(1000) + x * y - y * z, {{"x", 5}, {"y", 0}, {"z", 0, Q(51, 10)}}), Verdict::refuted);
}

TEST(Sign, BernsteinWithBisection) {
  const Polynomial p = (Polynomial(3) * x * x - Polynomial(3) * x + 1) * (y * y + 1);
  const Positivity r = decide(p, square);
  EXPECT_EQ(r.verdict, Verdict::proved);
  EXPECT_EQ(r.proof.method, "bernstein");
  EXPECT_EQ(r.proof.tree, "0..");
  const Polynomial form = x * x - Polynomial(2) * x * y + Polynomial(2) * y * y;
  EXPECT_EQ(verdict(form + 1, {{"x", 0, 1000}, {"y", 0, 1000}}), Verdict::proved);
  EXPECT_EQ(verdict(form - y + 1, {{"x", 0, 1000}, {"y", 0, 1000}}), Verdict::proved);
  EXPECT_EQ(verdict(form + 1, quadrant),
            Verdict::undecided);  // a zero where both are infinite, with terms of both signs
  EXPECT_EQ(verdict(x * x - Polynomial(3) * x * y + Polynomial(2) * y * y + 1, quadrant), Verdict::refuted);
  // a faraway region of negative values
  EXPECT_EQ(verdict((x - 100).pow(2) + (y - 70).pow(2) - 1, quadrant, weak()), Verdict::refuted);
  // Motzkin's polynomial plus a little, not a sum of squares
  const Polynomial motzkin = x.pow(4) * y.pow(2) + x.pow(2) * y.pow(4) - Polynomial(3) * x.pow(2) * y.pow(2) + 1;
  EXPECT_EQ(verdict(Polynomial(100) * motzkin + 1, {{"x", -2, 2}, {"y", -2, 2}}), Verdict::proved);
  EXPECT_EQ(verdict(Polynomial(100) * motzkin - 1, {{"x", -2, Q(15, 7)}, {"y", -2, 2}}, weak()), Verdict::refuted);
}

TEST(Sign, ZerosOnFacesAreNamed) {
  const Polynomial p = x * (x * x - x + 1) * (y * y + 1);
  EXPECT_EQ(verdict(p, quadrant), Verdict::refuted);
  EXPECT_EQ(verdict(p, quadrant, except({"x=lo"})), Verdict::proved);
  EXPECT_EQ(verdict(p, quadrant, except({"y=lo"})), Verdict::refuted);
  EXPECT_EQ(verdict(p, quadrant, weak()), Verdict::proved);
  EXPECT_EQ(verdict(x * x + y * y, quadrant, except({"x=lo"})), Verdict::proved);
  EXPECT_EQ(verdict(x * x + y * y, quadrant), Verdict::refuted);
}

TEST(Sign, InteriorZerosEndUndecided) {
  SignOptions o;
  o.depth = 30;
  const Positivity r = decide((Polynomial(3) * x - Polynomial(2) * y).pow(2), {{"x", 1, 2}, {"y", 1, 2}}, o);
  EXPECT_NE(r.verdict, Verdict::proved);
  o.strict = false;
  const Positivity s = decide((Polynomial(3) * x - 1).pow(2) + (Polynomial(7) * y - 2).pow(2), square, o);
  EXPECT_EQ(s.verdict, Verdict::undecided);
  EXPECT_NE(s.reason.find("depth limit"), std::string::npos) << s.reason;
  o.work = 3;
  EXPECT_NE(decide(x * x * y - x * y + y + 1, square, o).reason.find("work"), std::string::npos);
}

TEST(Sign, BadBoxesAreRefused) {
  EXPECT_THROW(decide_sign(x, {{"y", 0, 1}}), Error);
  EXPECT_THROW(decide_sign(x, {{"x", 1, 1}}), Error);
  EXPECT_THROW(decide_sign(x, {{"x", 0, 1}, {"x", 0, 1}}), Error);
  EXPECT_THROW(decide_sign(x, half_line, except({"x=hi"})), Error);
  EXPECT_THROW(decide_sign(x, half_line, except({"y=lo"})), Error);
}

TEST(Sign, RationalFunctions) {
  const auto f = [](const Polynomial& n, const Polynomial& d) { return RationalFunction::fraction(n, d); };
  EXPECT_EQ(decide_sign(f(x * x - x + 1, x + 1), half_line).verdict, Verdict::proved);
  EXPECT_EQ(decide_sign(f(-x - 1, x - 2), unit).verdict, Verdict::proved);
  EXPECT_EQ(decide_sign(f(1, x), half_line).verdict, Verdict::undecided);
  EXPECT_EQ(decide_sign(f(1, x), half_line, except({"x=lo"})).verdict, Verdict::proved);
  EXPECT_EQ(decide_sign(f(x * x * (y + 1), x * (x + y + 1)), quadrant, except({"x=lo"})).verdict, Verdict::proved);
  const RationalPositivity r = decide_sign(f(x - 1, x + 1), half_line);
  EXPECT_EQ(r.verdict, Verdict::refuted);
  ASSERT_TRUE(r.point);
  EXPECT_LE(r.value.sign(), 0);
  EXPECT_EQ(decide_sign(f(1, (x - 1).pow(2)), half_line).verdict, Verdict::undecided);
  EXPECT_EQ(decide_sign(f(1, x - 3), half_line).verdict, Verdict::refuted);
  for (const auto& [part, sign] : decide_sign(f(-x - 1, x - 2), unit).parts) expect_valid(sign.evidence);
}

// ---- Laws

Q random_rational(long reach, long scale) {
  const long d = uniform(1L, scale + 1);
  return Q(uniform(-reach * d, reach * d + 1), d);
}

Range random_range(const std::string& name) {
  Range r{name, random_rational(3, 4)};
  if (uniform(0, 3) != 0) r.high = r.low + Q(uniform(1L, 9L), uniform(1L, 5L));
  return r;
}

Polynomial random_polynomial(const std::vector<Polynomial>& variables, unsigned degree, long size) {
  Polynomial p = uniform(-size, size + 1);
  for (unsigned terms = uniform(1U, 7U); terms > 0; --terms) {
    Polynomial t = uniform(-size, size + 1);
    for (const auto& v : variables) t *= v.pow(uniform(0U, degree + 1));
    p += t;
  }
  return p;
}

LAW(Sign, ProductsOfPositiveThingsAreProved, ()) {
  Polynomial p = 1;
  for (int factors = uniform(1, 3); factors > 0; --factors) {
    p *= random_polynomial({x, y}, 1, 3).pow(2) + Polynomial(uniform(1L, 4L));
  }
  LAW_ASSERT(verdict(p, {{"x", -1, 1}, {"y", Q(-1, 2), 2}}) == Verdict::proved);
  LAW_ASSERT(!testing::Test::HasFailure());
}

LAW(Sign, WhatIsDecidedIsTrue, ()) {
  const Polynomial p = random_polynomial({x, y}, 3, 4) + Polynomial(uniform(0L, 12L));
  const Box box{random_range("x"), random_range("y")};
  SignOptions o;
  o.strict = uniform(0, 2) == 0;
  o.depth = 24;
  if (o.strict && uniform(0, 3) == 0) o.zeros = {"x=lo"};
  const Positivity r = decide(p, box, o);
  laws::tag(to_string(r.verdict));
  LAW_ASSERT(!testing::Test::HasFailure());
  if (r.verdict != Verdict::proved) return;
  for (int i = 0; i < 30; ++i) {
    std::vector<std::pair<std::string, Q>> at;
    bool excluded = false;
    for (const auto& range : box) {
      const Q t(uniform(0L, 8L), 7);
      if (range.high)
        at.emplace_back(range.name, range.low + (*range.high - range.low) * t);
      else
        at.emplace_back(range.name, range.low + t * t * t);
      excluded = excluded || (!o.zeros.empty() && range.name == "x" && t.is_zero());
    }
    const int sign = p.evaluate(at).sign();
    LAW_ASSERT(sign > 0 || (sign == 0 && (!o.strict || excluded)));
  }
}

// The evidence of one polynomial does not serve for another that is not positive.
LAW(Sign, EvidenceServesNoOther, ()) {
  const Polynomial p = random_polynomial({x, y}, 2, 3).pow(2) + Polynomial(uniform(1L, 4L));
  const Box box{random_range("x"), random_range("y")};
  SignOptions o;
  o.depth = 20;
  const Positivity r = decide(p, box, o);
  LAW_GIVEN(r.verdict == Verdict::proved);
  const Q value = p.evaluate({{"x", box[0].low}, {"y", box[1].low}});
  const Polynomial zero = Polynomial::constant(value.denominator()) * p - Polynomial::constant(value.numerator());
  const auto accepted = [&](const nlohmann::ordered_json& evidence) {
    return check::check_text(certificate_text("test", {evidence})).status == check::Report::valid;
  };
  auto evidence = r.evidence;
  evidence["polynomial"] = zero.to_string();  // at the lowest vertex
  LAW_ASSERT(!accepted(evidence));
  evidence["polynomial"] = (zero - Polynomial(1)).to_string();
  evidence["strict"] = "no";
  LAW_ASSERT(!accepted(evidence));
  evidence = r.evidence;
  evidence["verdict"] = "refuted";
  LAW_ASSERT(!accepted(evidence));
  evidence = r.evidence;
  evidence["tree"] = r.proof.tree + ".";
  LAW_ASSERT(!accepted(evidence));
}

LAW(Sign, OneVariableIsAlwaysDecided, ()) {
  const Polynomial p = random_polynomial({x}, 5, 6) * random_polynomial({x}, 2, 3).pow(uniform(0U, 3U));
  const Box box{random_range("x")};
  SignOptions o;
  o.strict = uniform(0, 2) == 0;
  LAW_ASSERT(decide(p, box, o).verdict != Verdict::undecided);
  LAW_ASSERT(!testing::Test::HasFailure());
}

// ---- Roots in discs

TEST(RootBound, WithoutParameters) {
  const Polynomial p = (Polynomial(2) * x - 1) * (Polynomial(2) * x + 1).pow(2);
  EXPECT_TRUE(roots_inside(p, Q(51, 100)));
  EXPECT_FALSE(roots_inside(p, Q(1, 2)));
  EXPECT_TRUE(roots_inside(Polynomial(5), 1));
  EXPECT_TRUE(roots_inside(x.pow(5), Q(1, 1000)));
  EXPECT_FALSE(roots_inside(x * x + 1, 1));
  for (const Q& r : {Q(1, 2), Q(51, 100)}) expect_valid(all_roots_inside(p, "x", r).evidence);
  EXPECT_THROW(roots_inside(Polynomial(0), 1), Error);
  EXPECT_THROW(roots_inside(x, 0), Error);
}

TEST(RootBound, WithParameters) {
  const Polynomial w = Polynomial::variable("w"), u = Polynomial::variable("u");
  const auto decide_roots = [](const Polynomial& p, const Q& r, const Box& box, const SignOptions& o = {}) {
    const RootBound result = all_roots_inside(p, "x", r, box, o);
    EXPECT_NE(result.verdict, Verdict::undecided) << result.reason;
    expect_valid(result.evidence);
    return result.verdict;
  };
  EXPECT_EQ(decide_roots(w - Polynomial(2) * x, 1, {{"w", -1, 1}}), Verdict::proved);
  EXPECT_EQ(decide_roots(w - Polynomial(2) * x, 1, {{"w", -1, 2}}), Verdict::refuted);
  EXPECT_EQ(decide_roots(w - Polynomial(2) * x, 1, {{"w", -1, 2}}, except({"w=hi"})), Verdict::proved);
  EXPECT_EQ(decide_roots(w * x - 1, 1, {{"w", 0}}), Verdict::refuted);
  EXPECT_EQ(decide_roots(w * x - 1, 1, {{"w", Q(11, 10)}}), Verdict::proved);
  EXPECT_EQ(decide_roots(x * x + w * x + u, 1, {{"u", Q(-1, 3), Q(1, 3)}, {"w", Q(-1, 2), Q(1, 2)}}), Verdict::proved);
  EXPECT_EQ(decide_roots(x * x + w * x + u, 1, {{"u", Q(-1, 3), Q(1, 3)}, {"w", Q(-2, 3), Q(3, 4)}}), Verdict::refuted);
  EXPECT_EQ(decide_roots(Polynomial(4) * x.pow(3) + w * x * x + u, 1, {{"u", -1, 1}, {"w", -2, 2}}), Verdict::proved);
  EXPECT_EQ(decide_roots(Polynomial(4) * x.pow(3) + w * x * x + u, 1, {{"u", -1, 1}, {"w", -2, 4}}), Verdict::refuted);
  for (unsigned n = 4; n <= 6; ++n) {
    EXPECT_EQ(decide_roots(Polynomial(4) * x.pow(n) + w * x + u, 1, {{"u", -1, 1}, {"w", -2, 2}}), Verdict::proved)
        << n;
    EXPECT_EQ(decide_roots(Polynomial(4) * x.pow(n) + w * x + u, 1, {{"u", -1, 1}, {"w", -2, 4}}), Verdict::refuted)
        << n;
  }
  // (a+1) x = a: a/(a+1) < 1 for all a >= 0, without a uniform bound
  EXPECT_EQ(decide_roots((w + 1) * x - w, 1, {{"w", 0}}), Verdict::proved);
  EXPECT_EQ(decide_roots((w + 1) * x - w, Q(99, 100), {{"w", 0}}), Verdict::refuted);
  EXPECT_THROW(all_roots_inside(x * w, "x", 1, {}), Error);
  EXPECT_THROW(all_roots_inside(x * w, "x", 1, {{"x", 0, 1}, {"w", 0, 1}}), Error);
}

std::vector<Polynomial> random_coefficients(size_t n) {
  std::vector<Polynomial> a;
  for (size_t k = 0; k < n; ++k) a.emplace_back(uniform(-6L, 7L));
  a.emplace_back(uniform(1L, 20L));
  return a;
}
Polynomial polynomial_of(const std::vector<Polynomial>& a) {
  Polynomial p;
  for (size_t k = 0; k < a.size(); ++k) p += a[k] * x.pow(static_cast<unsigned>(k));
  return p;
}
bool all_positive(const std::vector<Polynomial>& list) {
  return std::all_of(list.begin(), list.end(), [](const Polynomial& c) { return c.leading_sign() > 0; });
}

LAW(RootBound, SchurCohnJuryAndLienardChipartAgree, ()) {
  const auto a = random_coefficients(uniform<size_t>(0, 9));
  const bool inside = roots_inside(polynomial_of(a), 1);
  laws::tag(inside ? "inside" : "not inside");
  LAW_ASSERT(all_positive(lienard_chipart_conditions(a)) == inside);
  if (a.size() <= 4) LAW_ASSERT(all_positive(jury_conditions(a)) == inside);
  expect_valid(all_roots_inside(polynomial_of(a), "x", 1).evidence);
  LAW_ASSERT(!testing::Test::HasFailure());
}

// The conditions with parameters, at a point: what they say of the numbers there.
LAW(RootBound, ConditionsCommuteWithEvaluation, ()) {
  std::vector<Polynomial> a;
  const size_t n = uniform<size_t>(1, 7);
  for (size_t k = 0; k <= n; ++k) a.push_back(random_polynomial({y, z}, 1, 3) + Polynomial(k == n ? 7 : 0));
  const std::vector<std::pair<std::string, Q>> at{{"y", random_rational(2, 3)}, {"z", random_rational(2, 3)}};
  std::vector<Q> values;
  for (const auto& c : a) values.push_back(c.evaluate(at));
  LAW_GIVEN(values.back().sign() > 0);
  std::vector<Polynomial> numbers;
  Q scale = 1;
  for (const Q& v : values) scale *= Q((v * scale).denominator());
  for (const Q& v : values) numbers.push_back(Polynomial::constant((v * scale).numerator()));
  const bool inside = roots_inside(polynomial_of(numbers), 1);
  std::vector<std::vector<Polynomial>> lists{lienard_chipart_conditions(a)};
  if (n <= 3) lists.push_back(jury_conditions(a));
  for (const auto& list : lists) {
    const bool all =
        std::all_of(list.begin(), list.end(), [&](const Polynomial& c) { return c.evaluate(at).sign() > 0; });
    LAW_ASSERT(all == inside);
  }
}

// Evidence with parameters, and the same for a smaller disc.
LAW(RootBound, EvidenceServesNoSmallerDisc, ()) {
  const unsigned n = uniform(1U, 7U);
  Polynomial p = Polynomial(uniform(3L, 9L)) * x.pow(n);
  for (unsigned k = 0; k < n; ++k) p += random_polynomial({y, z}, 1, 2) * x.pow(k);
  const Box box{{"y", 0, 1}, {"z", -1, Q(1, 2)}};
  const Q radius = random_rational(2, 3) + Q(3);
  const RootBound r = all_roots_inside(p, "x", radius, box);
  laws::tag(to_string(r.verdict));
  if (r.verdict != Verdict::undecided) expect_valid(r.evidence);
  LAW_ASSERT(!testing::Test::HasFailure());
  if (r.verdict != Verdict::proved) return;
  Q smaller = radius;
  for (int i = 0; i < 12; ++i) {
    smaller *= Q(3, 4);
    if (all_roots_inside(p, "x", smaller, box).verdict != Verdict::refuted) continue;
    auto evidence = r.evidence;
    evidence["bound"] = smaller.to_string();
    LAW_ASSERT(check::check_text(certificate_text("test", {evidence})).status != check::Report::valid);
  }
}

// Output of PARI/GP, or nothing if it is not installed.
std::string pari(const std::string& code) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(("echo '" + code + "' | gp -q -f 2>/dev/null").c_str(), "r"),
                                                   pclose);
  std::string out;
  std::array<char, 4096> buffer{};
  while (pipe && fgets(buffer.data(), buffer.size(), pipe.get()) != nullptr) out += buffer.data();
  return out;
}

TEST(RootBound, AgreesWithPari) {
  if (pari("print(1+1)") != "2\n") GTEST_SKIP() << "gp is not installed";
  std::mt19937 random(7);
  const auto pick = [&](long low, long high) { return std::uniform_int_distribution<long>(low, high)(random); };
  std::string code, expected;
  for (int round = 0; round < 150; ++round) {
    Polynomial p = Polynomial(pick(1, 12)) * x.pow(static_cast<unsigned>(pick(1, 9)));
    const long n = p.degree("x");
    for (long k = 0; k < n; ++k) p += Polynomial(pick(-5, 5)) * x.pow(static_cast<unsigned>(k));
    const Q radius(pick(1, 30), 10);
    // no root within 10^-9 of the circle: a double root moves by 10^-14 or so at this precision
    code += "m=vecmax(abs(polroots(" + p.to_string() + ")));print(if(abs(m-" + radius.to_string() + ")<1e-9,2,m<" +
            radius.to_string() + "));";
    expected += roots_inside(p, radius) ? '1' : '0';
  }
  std::string found = pari(code);
  found.erase(std::remove(found.begin(), found.end(), '\n'), found.end());
  ASSERT_EQ(found.size(), expected.size());
  for (size_t i = 0; i < found.size(); ++i) EXPECT_TRUE(found[i] == '2' || found[i] == expected[i]) << i;
  EXPECT_GT(std::count(expected.begin(), expected.end(), '1'), 20);
}

TEST(Univariate, AgreesWithPari) {
  if (pari("print(1+1)") != "2\n") GTEST_SKIP() << "gp is not installed";
  std::mt19937 random(11);
  const auto pick = [&](long low, long high) { return std::uniform_int_distribution<long>(low, high)(random); };
  std::string code, expected;
  for (int round = 0; round < 100; ++round) {
    Polynomial p = x.pow(static_cast<unsigned>(pick(1, 12)));
    for (long k = p.degree("x") - 1; k >= 0; --k) p += Polynomial(pick(-9, 9)) * x.pow(static_cast<unsigned>(k));
    if (pick(0, 2) == 0) p *= (x - Polynomial(pick(-3, 3))).pow(2);
    const long low = pick(-3, 1), high = low + pick(1, 3);
    code += "p=" + p.to_string() + ";p/=gcd(p,deriv(p));print1(polsturm(p,[" + std::to_string(low) + "," +
            std::to_string(high) + "]),\",\");";
    expected += std::to_string(count_zeros(p, low, high, Ends::closed)) + ",";
    EXPECT_EQ(static_cast<long>(isolate_zeros(p, low, high).size()), count_zeros(p, low, high, Ends::open));
  }
  std::string found = pari(code);
  found.erase(std::remove(found.begin(), found.end(), '\n'), found.end());
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace twoscale::analysis
