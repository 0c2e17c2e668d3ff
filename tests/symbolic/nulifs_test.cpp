// SPDX-License-Identifier: GPL-3.0-or-later
/// NULIFS and the rules sampled from them: what the paper says of them, what it prints wrong, and the simplest forms.
#include "twoscale/symbolic/nulifs.hpp"

#include "support/laws.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"
#include "twoscale/symbolic/sampled_scheme.hpp"

namespace twoscale::tests {
namespace {

using Function = RationalFunction;

Function f(const char* text) { return parse_rational_function(text); }

// Edges -16..16 with intervals from 1/4 to 9 and edge parameters k/10; `ends`: 0 and 1 too.
struct RandomKnots {
  std::vector<Rational> d, lambda;
};
RandomKnots random_knots(bool ends) {
  RandomKnots k;
  for (int e = 0; e < 33; ++e) {
    k.d.emplace_back(uniform(1L, 10L), uniform(1L, 5L));
    const long low = ends ? 0 : 1;
    k.lambda.emplace_back(uniform(low, 11L - low), 10L);
  }
  return k;
}

Rational power_sum(const Knots<Rational>& t, const std::vector<Rational>& weights, long first, unsigned e) {
  Rational sum;
  for (size_t i = 0; i < weights.size(); ++i) sum += weights[i] * t.x(first + static_cast<long>(i)).pow(e);
  return sum;
}

LAW(Nulifs, InterpolateReproduceAndHaveTheSupportOfThePaper, ()) {
  const RandomKnots k = random_knots(false);
  const Knots<Rational> t(-16, k.d, k.lambda);
  FundamentalFamily family;
  family.order = uniform(3U, 7U);
  family.reproduction = uniform(1U, family.order + 1);
  const unsigned n = family.order;
  family.mu = uniform(1U, std::max(n + family.reproduction - 3, 3 * n / 2 + family.reproduction - 5) + 1);
  // delta_ij at the vertices, (2.1).
  const long q = uniform(-1L, 2L);
  const std::vector<Rational> at_vertex = fundamental_values(t, family, t.x(q), 2 * q);
  for (long i = -16; i <= 17; ++i) LAW_ASSERT(at_vertex[static_cast<size_t>(i + 16)] == Rational(i == q ? 1 : 0));
  // Polynomials of degree < rho, (2.3), and not one more unless rho = n; support, (2.2).
  const Rational x = (t(1) * Rational(2) + t(2)) * Rational(1, 3);
  const std::vector<Rational> v = fundamental_values(t, family, x, 1);
  for (unsigned e = 0; e < family.reproduction; ++e) LAW_ASSERT(power_sum(t, v, -16, e) == x.pow(e));
  const long width = n == 3 ? family.reproduction + 1 : 3 * n / 2 + family.reproduction - 4;
  const auto left = static_cast<long>(family.mu);
  for (long i = -16; i <= 17; ++i)
    if (i - left > 0 || i - left + width < 1) LAW_ASSERT(v[static_cast<size_t>(i + 16)].is_zero());
}

/// The splines by their coefficients are the splines by their definition.
LAW(Nulifs, CoefficientsInBsplines, ()) {
  const RandomKnots k = random_knots(false);
  const Knots<Rational> t(-16, k.d, k.lambda);
  FundamentalFamily family;
  family.order = uniform(3U, 7U);
  family.reproduction = uniform(1U, family.order + 1);
  family.mu = uniform(1U, family.order + family.reproduction - 2);
  const auto n = static_cast<long>(family.order);
  const long piece = uniform(-4L, 4L);
  const Rational x = (t(piece) * Rational(2) + t(piece + 1)) * Rational(1, 3);
  const std::vector<Rational> values = bspline_values(t, family.order, x, piece);
  const SplineCoefficients<Rational> c = spline_coefficients(t, family, 0);
  Rational sum;
  for (long r = 0; r < n; ++r) {
    const long at = piece - n + 1 + r - c.lowest;
    if (at >= 0 && at < static_cast<long>(c.values.size()))
      sum += c.values[static_cast<size_t>(at)] * values[static_cast<size_t>(r)];
  }
  LAW_ASSERT(sum == fundamental_values(t, family, x, piece)[16]);
}

TEST(Nulifs, SymmetricMembers) {
  const auto member = [](unsigned n) {
    const FundamentalFamily m = FundamentalFamily::symmetric(n);
    EXPECT_NO_THROW(m.validate());
    EXPECT_EQ(m.right(), static_cast<long>(m.mu));
    return std::pair(m.reproduction, m.mu);
  };
  EXPECT_EQ(member(3), std::pair(3U, 2U));
  EXPECT_EQ(member(4), std::pair(4U, 3U));
  EXPECT_EQ(member(5), std::pair(5U, 4U));
  // (2.11) with the printed floor would give rho = n here, and no symmetric support.
  EXPECT_EQ(member(6), std::pair(5U, 5U));
  EXPECT_EQ(member(7), std::pair(6U, 6U));
  EXPECT_EQ(member(8), std::pair(8U, 8U));
  EXPECT_THROW((FundamentalFamily{2, 2, 1}.validate()), Error);
  EXPECT_THROW((FundamentalFamily{4, 5, 1}.validate()), Error);
  EXPECT_THROW((FundamentalFamily{4, 4, 6}.validate()), Error);
}

const std::vector<Function> three_intervals = {f("a"), f("b"), f("c")};

// nuli (3.5), (3.6) as printed, with d_{i-1} = a, d_i = b, d_{i+1} = c, lambda_i = l: both are right.
TEST(Nulifs, FourPointRuleIsTheOnePrinted) {
  const std::vector<Function> lambda = {Rational(1, 2), f("l"), Rational(1, 2)};
  const auto family = FundamentalFamily::symmetric(3);
  EXPECT_EQ(
      sampled_rule(family, -1, three_intervals, lambda, false),
      (std::vector<Function>{f("l*b^2/(8*(l-1)*a*(a+b))"), f("(l*(-b*c+b*a+4*c*a-b^2)-2*a*(b+2*c))/(8*(l-1)*a*(b+c))"),
                             f("(l*(3*b^2+5*b*c+3*b*a+4*c*a)-2*(a+b)*(b+2*c))/(8*(l-1)*c*(a+b))"),
                             f("(2-3*l)*b^2/(8*(l-1)*c*(b+c))")}));
  EXPECT_EQ(sampled_rule(family, -1, three_intervals, lambda, true),
            (std::vector<Function>{
                f("(1-3*l)*b^2/(8*l*a*(b+a))"), f("((l-1)*(3*b^2+5*b*a+3*b*c+4*a*c)+2*(c+b)*(b+2*a))/(8*l*a*(c+b))"),
                f("((l-1)*(-b*a+b*c+4*a*c-b^2)+2*c*(b+2*a))/(8*l*c*(b+a))"), f("(l-1)*b^2/(8*l*c*(c+b))")}));
}

TEST(Nulifs, FourPointRuleDoesNotSeeTheNeighboursEdgeParameters) {
  const auto family = FundamentalFamily::symmetric(3);
  for (const bool upper : {false, true})
    EXPECT_EQ(sampled_rule(family, -1, three_intervals, {f("k"), f("l"), f("m")}, upper),
              sampled_rule(family, -1, three_intervals, {Rational(1, 2), f("l"), Rational(1, 2)}, upper));
}

std::vector<Function> catalogue_rule(const char* scheme, bool upper) {
  const Scheme s = make_scheme(scheme);
  const auto& phases = upper ? s.pieces.back().phases : s.phases;
  std::vector<Function> c;
  for (const auto& b : phases[1].blocks) c.push_back(b[0]);
  return c;
}

std::vector<Function> local(const char* name, long first, long last) {
  std::vector<Function> list;
  for (long o = first; o <= last; ++o) list.push_back(Function::variable(local_name(name, o)));
  return list;
}

/// For all knot intervals and edge parameters: the blends are the sampled rules.
TEST(Nulifs, CatalogueRulesAreTheSampledOnes) {
  for (const bool upper : {false, true}) {
    EXPECT_EQ(catalogue_rule("nuli4", upper),
              sampled_rule(FundamentalFamily::symmetric(3), -1, local("d", -1, 1), local("lambda", -1, 1), upper));
    EXPECT_EQ(catalogue_rule("nuli6", upper),
              sampled_rule(FundamentalFamily::symmetric(4), -2, local("d", -2, 2), local("lambda", -2, 2), upper));
  }
}

std::vector<Rational> at(const char* scheme, const std::vector<Rational>& d, const std::vector<Rational>& lambda) {
  const Scheme s = make_scheme(scheme);
  std::vector<std::pair<std::string, Function>> values;
  for (const auto& p : s.parameters) {
    const auto& from = p.rest ? lambda : d;
    for (size_t i = 0; i < p.offsets.size(); ++i) values.emplace_back(local_name(p.name, p.offsets[i]), from.at(i));
  }
  const Stencil stencil = phases_at(s, values)[1];
  std::vector<Rational> c;
  for (const auto& b : stencil.blocks) c.push_back(*b[0].constant());
  return c;
}

/// At rational points, edge parameters 0, 1/2 and 1 included, where the limits are values of splines on double and
/// triple knots; and what the rules reproduce.
LAW(Nulifs, StencilsAtPoints, ()) {
  for (const auto& [scheme, order, mu] : {std::tuple("nuli4", 3U, 2L), std::tuple("nuli6", 4U, 3L)}) {
    std::vector<Rational> d, lambda;
    for (long e = 0; e < 2 * mu - 1; ++e) {
      d.emplace_back(uniform(1L, 10L), uniform(1L, 5L));
      lambda.emplace_back(uniform(0L, 9L), 8L);
    }
    const Rational own = lambda[static_cast<size_t>(mu - 1)];
    const bool upper = own >= Rational(1, 2);
    const std::vector<Rational> near = mu == 2 ? std::vector{own} : std::vector{lambda[1], own, lambda[3]};
    const std::vector<Rational> c = at(scheme, d, near);
    LAW_ASSERT(c == sampled_rule(FundamentalFamily::symmetric(order), 1 - mu, d, lambda, upper));
    const Knots<Rational> t(1 - mu, d, lambda);
    for (unsigned e = 0; e < order; ++e) LAW_ASSERT(power_sum(t, c, 1 - mu, e) == t.middle(0).pow(e));
    // Mirrored data, mirrored rule: (3.4).
    std::vector<Rational> mirrored;
    for (auto l = near.rbegin(); l != near.rend(); ++l) mirrored.push_back(Rational(1) - *l);
    const std::vector<Rational> back(d.rbegin(), d.rend());
    LAW_ASSERT(at(scheme, back, mirrored) == std::vector<Rational>(c.rbegin(), c.rend()));
  }
}

// Values of an independent evaluation of (2.4)-(2.7) in PARI/GP.
/// A sampled rule reads the intervals and edge parameters that SampledScheme names, each of them and no others; n = 10
/// reads an interval beyond its points. (2.17) holds for n <= 5.
TEST(Nulifs, WhatTheSampledRuleReads) {
  for (const unsigned n : {3U, 4U, 5U, 6U, 7U, 10U}) {
    const SampledScheme s = *sampled_scheme("nuli:n=" + std::to_string(n));
    const long mu = s.highest();
    EXPECT_EQ(s.last_parameter() == mu - 2 && s.first_parameter() == 2 - mu, n <= 5) << n;
    EXPECT_EQ(s.last_interval() == mu, n == 10) << n;
    std::vector<Rational> d, lambda;
    const long beyond = mu + 3;
    for (long e = -beyond; e <= beyond; ++e) {
      d.emplace_back(e % 3 == 0 ? 2L : 1L, e % 2 == 0 ? 3L : 2L);
      lambda.emplace_back(1 + (e + beyond) * 5 % 7, 9L);
    }
    lambda[static_cast<size_t>(beyond)] = Rational(1, 3);
    const auto rule = [&] { return sampled_rule(s.family, -beyond, d, lambda, false); };
    const std::vector<Rational> first = rule();
    const auto part = [&](const std::vector<Rational>& list, long from, long to) {
      return std::vector<Rational>(list.begin() + from + beyond, list.begin() + to + beyond + 1);
    };
    EXPECT_EQ(s.weights(part(d, s.lowest(), s.last_interval()), part(lambda, s.first_parameter(), s.last_parameter())),
              first);
    const auto reads = [&](std::vector<Rational>& list, long e) {
      Rational& x = list[static_cast<size_t>(e + beyond)];
      x += Rational(1, 50);
      const bool changed = rule() != first;
      x -= Rational(1, 50);
      return changed;
    };
    for (const long e : {s.lowest() - 1, s.last_interval() + 1}) EXPECT_FALSE(reads(d, e)) << n << " d " << e;
    for (const long e : {s.lowest(), s.last_interval()}) EXPECT_TRUE(reads(d, e)) << n << " d " << e;
    for (const long e : {s.first_parameter() - 1, s.last_parameter() + 1})
      EXPECT_FALSE(reads(lambda, e)) << n << " " << e;
    for (const long e : {s.first_parameter(), s.last_parameter()}) EXPECT_TRUE(reads(lambda, e)) << n << " " << e;
  }
  EXPECT_THROW(sampled_scheme("nuli:n=4,m=2"), Error);
  const SampledScheme s = *sampled_scheme("nuli:n=4");
  EXPECT_THROW((void)s.weights({1, 1, 1, 1}, {Rational(1, 2), Rational(1, 2), Rational(1, 2)}), Error);
  EXPECT_THROW((void)s.weights({1, 1, 0, 1, 1}, {Rational(1, 2), Rational(1, 2), Rational(1, 2)}), Error);
}

/// Double and triple knots: the weights are the limits.
TEST(Nulifs, SampledRuleAtTheEndsOfEdgeParameters) {
  const Rational small(1, 1000000000000L), tolerance(1, 1000000);
  for (const unsigned n : {5U, 6U}) {
    const SampledScheme s = *sampled_scheme("nuli:n=" + std::to_string(n));
    const std::vector<Rational> d(static_cast<size_t>(s.last_interval() - s.lowest() + 1), Rational(2, 3));
    const auto edges = static_cast<size_t>(s.last_parameter() - s.first_parameter() + 1);
    for (unsigned mask = 0; mask < (1U << edges); mask += 3) {
      std::vector<Rational> at, near;
      for (size_t e = 0; e < edges; ++e) {
        const bool one = (mask >> e & 1U) != 0;
        at.emplace_back(one ? 1 : 0);
        near.push_back(one ? Rational(1) - small : small);
      }
      const std::vector<Rational> a = s.weights(d, at), b = s.weights(d, near);
      for (size_t i = 0; i < a.size(); ++i) EXPECT_LT(abs(a[i] - b[i]), tolerance) << n << " " << mask;
    }
  }
}

TEST(Nulifs, ValuesHeldElsewhere) {
  const auto q = [](const char* text) { return Rational::parse(text); };
  const std::vector<Rational> five = {1, q("1/2"), 3, 2, 1};
  EXPECT_EQ(at("nuli4", {1, q("1/2"), 3}, {q("1/3")}),
            (std::vector<Rational>{q("-1/96"), q("113/224"), q("49/96"), q("-1/224")}));
  EXPECT_EQ(at("nuli6", five, {q("1/5"), q("1/7"), q("2/3")}),
            (std::vector<Rational>{q("17/9288"), q("-1350927/1880648"), q("5524933/4396320"), q("1400059/2308068"),
                                   q("-549861/2686640"), q("1183/20448")}));
  EXPECT_EQ(at("nuli6", five, {q("1/5"), q("6/7"), q("2/3")}),
            (std::vector<Rational>{q("1547/40608"), q("-114447/115808"), q("208939/135360"), q("552457/1137024"),
                                   q("-26877/330880"), q("13/6768")}));
  EXPECT_EQ(sampled_rule<Rational>(FundamentalFamily::symmetric(5), -3, {1, q("1/2"), 3, 2, 1, 4, q("1/3")},
                                   {q("1/2"), q("1/5"), q("1/7"), q("2/3"), q("1/2"), q("1/3"), q("1/4")}, true),
            (std::vector<Rational>{q("-28705/52129779"), q("208777149741/2565914605345"),
                                   q("-1576933214791633/12079536449778000"), q("37076171775829061/74409944530632480"),
                                   q("215736498269555677/279171509061536000"), q("-1404530304021031/6281358953884560"),
                                   q("9213783/3514427000"), q("-7209/21781760")}));
  // Uniform: the 4-point scheme of Dubuc (Remark 3.2), and for n = 4 the mask 1/288, -7/96, 41/72, ...
  EXPECT_EQ(at("nuli4", {1, 1, 1}, {q("1/2")}), (std::vector<Rational>{q("-1/16"), q("9/16"), q("9/16"), q("-1/16")}));
  EXPECT_EQ(at("nuli6", {1, 1, 1, 1, 1}, {q("1/2"), q("1/2"), q("1/2")}),
            (std::vector<Rational>{q("1/288"), q("-7/96"), q("41/72"), q("41/72"), q("-7/96"), q("1/288")}));
}

TEST(Nulifs, APieceThatCannotBeChosenIsRefused) {
  const Scheme s = make_scheme("nuli4");
  EXPECT_THROW(phases_at(s, {{"d_m1", 1}, {"d_0", 1}, {"d_1", 1}, {"lambda_0", f("l")}}), Error);
  EXPECT_THROW(phases_at(s, {{"d_m1", 1}, {"d_0", 1}, {"lambda_0", Rational(1, 2)}}), Error);
  EXPECT_THROW(phases_at(s, {{"d_m1", 0}, {"d_0", 1}, {"d_1", 1}, {"lambda_0", Rational(1, 2)}}), Error);
}

}  // namespace
}  // namespace twoscale::tests
