// SPDX-License-Identifier: GPL-3.0-or-later
// Interpolatory schemes on arbitrary knots: NULI 4- and 6-point (nuli), and the non-uniform Lagrange 4-point rule.
//
// Local parameters: d, the knot intervals; lambda, the place of the auxiliary knot in an edge, in [0, 1]. A rule is a
// blend of polynomial interpolants at the middle of the edge (nulifs.hpp).
#include <algorithm>

#include "recipes.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/nulifs.hpp"
#include "twoscale/symbolic/sampled_scheme.hpp"

namespace twoscale::families {

namespace {

RationalFunction variable(const std::string& name, long offset) {
  return RationalFunction::variable(local_name(name, offset));
}

// x_j with x_0 = 0.
RationalFunction knot(long j) {
  RationalFunction x;
  for (long e = 0; e < j; ++e) x += variable("d", e);
  for (long e = j; e < 0; ++e) x -= variable("d", e);
  return x;
}

// Adds weight * (the interpolant at x_first .. x_{first+degree}, taken in the middle of the edge 0) to a stencil.
void add_interpolant(Stencil& stencil, const RationalFunction& weight, long first, long degree) {
  const RationalFunction middle = variable("d", 0) * RationalFunction(Rational(1, 2));
  for (long j = first; j <= first + degree; ++j) {
    RationalFunction value = weight;
    for (long q = first; q <= first + degree; ++q)
      if (q != j) value = value * (middle - knot(q)) / (knot(j) - knot(q));
    stencil.blocks[static_cast<size_t>(j - stencil.lowest)][0] += value;
  }
}

Stencil empty_stencil(long lowest, long highest) {
  return {lowest, std::vector<std::vector<RationalFunction>>(static_cast<size_t>(highest - lowest + 1), {0})};
}

std::vector<Stencil> with_old_point(Stencil odd) { return {Stencil{0, {{1}}}, std::move(odd)}; }

std::vector<Stencil> four_point(const RationalFunction& w) {
  Stencil s = empty_stencil(-1, 2);
  add_interpolant(s, w, -1, 2);
  add_interpolant(s, RationalFunction(1) - w, 0, 2);
  return with_old_point(std::move(s));
}

std::vector<Stencil> six_point(const RationalFunction& left, const RationalFunction& right) {
  Stencil s = empty_stencil(-2, 3);
  add_interpolant(s, left, -2, 3);
  add_interpolant(s, RationalFunction(1) - left - right, -1, 3);
  add_interpolant(s, right, 0, 3);
  return with_old_point(std::move(s));
}

Scheme local_scheme(const SchemeName& name, std::vector<long> interval_offsets, std::vector<long> edge_offsets) {
  Scheme s;
  s.id = name.to_string();
  s.kernel = name.id;
  const auto add = [&](const char* local, std::vector<long> offsets) -> Parameter& {
    Parameter p;
    p.name = local;
    p.scope = Parameter::Scope::local;
    p.offsets = std::move(offsets);
    s.parameters.push_back(std::move(p));
    return s.parameters.back();
  };
  add("d", std::move(interval_offsets));
  if (!edge_offsets.empty()) add("lambda", std::move(edge_offsets)).rest = Rational(1, 2);
  return s;
}

Scheme nuli4(const SchemeName& name) {
  Scheme s = local_scheme(name, {-1, 0, 1}, {0});
  s.title = "NULI 4-point scheme";
  s.source = "nuli (3.5)-(3.7)";
  s.claims = {{"interpolatory", "", "nuli (3.7)"},
              {"reproduces", "1, x, x^2", "nuli Proposition 3.1"},
              {"continuity", "1", "nuli Propositions 3.2, 3.3"},
              {"support", "-3..3", "nuli Proposition 3.4"}};
  const RationalFunction lambda = variable("lambda", 0);
  const Polynomial upper_half = Polynomial(2) * lambda.numerator() - Polynomial(1);
  s.phases = four_point(quadratic_blend(lambda, false));
  s.pieces = {{upper_half, four_point(quadratic_blend(lambda, true))}};
  return s;
}

Scheme nuli6(const SchemeName& name) {
  Scheme s = local_scheme(name, {-2, -1, 0, 1, 2}, {-1, 0, 1});
  s.title = "NULI 6-point scheme";
  s.source = "nuli section 4, Appendix";
  // The paper says C^2 for all edge parameters. It fails near lambda_{i-1} = 1, lambda_i = 0, where an eigenvalue at
  // the vertex is 1/4 or more; C^1 holds everywhere (docs/nonuniform.md).
  s.claims = {{"interpolatory", "", "nuli (2.14)"},
              {"reproduces", "1, x, x^2, x^3", "nuli section 4"},
              {"continuity", "2", "nuli section 4"}};
  const RationalFunction one(1);
  const RationalFunction lambda = variable("lambda", 0);
  const auto left = [&](bool upper) {
    return cubic_blend(variable("d", -1), variable("d", 0), one - variable("lambda", -1), lambda, upper);
  };
  const auto right = [&](bool upper) {  // upper: of lambda, so that 1 - lambda is in the lower half
    return cubic_blend(variable("d", 1), variable("d", 0), variable("lambda", 1), one - lambda, !upper);
  };
  const Polynomial l = lambda.numerator();
  s.phases = six_point(left(false), right(false));
  s.pieces = {{-l, six_point(0, right(false))},               // lambda = 0: the limit, also beside lambda_{i-1} = 1
              {l - Polynomial(1), six_point(left(true), 0)},  // lambda = 1
              {Polynomial(2) * l - Polynomial(1), six_point(left(true), right(true))}};
  return s;
}

Scheme lagrange4(const SchemeName& name) {
  Scheme s = local_scheme(name, {-1, 0, 1}, {});
  s.title = "non-uniform Lagrange 4-point scheme";
  s.source = "Daubechies, Guskov and Sweldens 1999";
  s.claims = {{"interpolatory", "", ""}, {"reproduces", "1, x, x^2, x^3", ""}, {"continuity", "1", ""}};
  Stencil odd = empty_stencil(-1, 2);
  add_interpolant(odd, 1, -1, 3);
  s.phases = with_old_point(std::move(odd));
  return s;
}

constexpr unsigned highest_symbolic_order = 5;

SampledScheme sampled_of(const SchemeName& name) {
  const auto at = name.keys.find("lambda");
  const Rational lambda = at == name.keys.end() ? Rational(1, 2) : Rational::parse(at->second);
  if (lambda.sign() <= 0 || lambda >= Rational(1)) bad_input("lambda must lie between 0 and 1", lambda.to_string());
  return {name.to_string(), FundamentalFamily::symmetric(static_cast<unsigned>(integer_key(name, "n", 3, 64))), lambda};
}

// The rule as a function of the intervals, every auxiliary knot at the same place.
Scheme sampled(const SchemeName& name) {
  const SampledScheme sampled = sampled_of(name);
  if (!sampled.symbolic())
    bad_input("the weights of order above " + std::to_string(highest_symbolic_order) +
                  " are not written out; show, stencil --at, spectrum --at and refine compute them at numbers",
              sampled.id);
  const FundamentalFamily& family = sampled.family;
  const long mu = static_cast<long>(family.mu);
  Scheme s = sampled.outline();
  s.parameters.pop_back();
  // Edges beyond those of d are not read.
  const long reach = 3 * static_cast<long>(family.order) + 2 * mu;
  std::vector<RationalFunction> d;
  for (long e = -reach; e <= reach; ++e) d.push_back(e > -mu && e < mu ? variable("d", e) : RationalFunction(1));
  const std::vector<RationalFunction> c = sampled_rule(
      family, -reach, d, std::vector<RationalFunction>(d.size(), sampled.rest), sampled.rest >= Rational(1, 2));
  Stencil odd = empty_stencil(1 - mu, mu);
  for (size_t i = 0; i < c.size(); ++i) odd.blocks[i][0] = c[i];
  s.phases = with_old_point(std::move(odd));
  return s;
}

}  // namespace

void add_nuli(std::vector<CatalogEntry>& list) {
  list.push_back({"nuli4",
                  "4-point on arbitrary knots with edge parameters; knots and edge parameters come with the data",
                  "nuli (3.5)-(3.7)",
                  {},
                  {"nuli4"},
                  nuli4});
  list.push_back({"nuli6",
                  "6-point on arbitrary knots with edge parameters; knots and edge parameters come with the data",
                  "nuli section 4",
                  {},
                  {"nuli6"},
                  nuli6});
  list.push_back({"nuli",
                  "2mu-point on arbitrary knots, sampled from splines of order n; knots come with the data",
                  "nuli (2.14), (2.17)",
                  {{"n", "order of the splines, from 3: 3, 4, 5 for 4, 6, 8 points; above 5 at numbers only", true},
                   {"lambda", "place of the auxiliary knots, between 0 and 1; 1/2 if absent", false}},
                  {"nuli:n=5", "nuli:lambda=1/3,n=3"},
                  sampled});
  list.push_back({"lagrange4",
                  "4-point Lagrange rule on arbitrary knots; knots come with the data",
                  "Daubechies, Guskov and Sweldens 1999",
                  {},
                  {"lagrange4"},
                  lagrange4});
}

}  // namespace twoscale::families

namespace twoscale {

bool SampledScheme::symbolic() const { return family.order <= families::highest_symbolic_order; }

Scheme SampledScheme::outline() const {
  std::vector<long> interval_offsets, edge_offsets;
  for (long e = lowest(); e <= last_interval(); ++e) interval_offsets.push_back(e);
  for (long e = first_parameter(); e <= last_parameter(); ++e) edge_offsets.push_back(e);
  Scheme s = families::local_scheme({id, {}}, interval_offsets, edge_offsets);
  s.parameters.back().rest = rest;
  s.kernel = "nuli";
  s.title = "NULI " + std::to_string(2 * highest()) + "-point scheme of order " + std::to_string(family.order) +
            ", auxiliary knots at " + rest.to_string();
  s.source = "nuli (2.14), (2.17)";
  std::string powers = "1";
  for (unsigned e = 1; e < family.reproduction; ++e) powers += e == 1 ? ", x" : ", x^" + std::to_string(e);
  s.claims = {{"interpolatory", "", "nuli (2.14)"}, {"reproduces", powers, "nuli section 2.3"}};
  return s;
}

std::vector<Rational> SampledScheme::weights(const std::vector<Rational>& d,
                                             const std::vector<Rational>& lambda) const {
  const auto intervals = static_cast<std::size_t>(last_interval() - lowest() + 1);
  const auto parameters = static_cast<std::size_t>(last_parameter() - first_parameter() + 1);
  if (d.size() != intervals || lambda.size() != parameters)
    bad_input(id + " reads " + std::to_string(intervals) + " intervals and " + std::to_string(parameters) +
                  " edge parameters, not",
              std::to_string(d.size()) + " and " + std::to_string(lambda.size()));
  for (const auto& x : d)
    if (x.sign() <= 0) bad_input("a knot interval must be positive", x.to_string());
  for (const auto& x : lambda)
    if (x.sign() < 0 || x > Rational(1)) bad_input("an edge parameter must be in [0, 1]", x.to_string());
  std::vector<Rational> all(intervals, rest);
  std::copy(lambda.begin(), lambda.end(), all.begin() + (first_parameter() - lowest()));
  return sampled_rule(family, lowest(), d, all, all[static_cast<std::size_t>(-lowest())] >= Rational(1, 2));
}

std::optional<SampledScheme> sampled_scheme(std::string_view text) {
  if (!text.starts_with("nuli:")) return std::nullopt;
  const SchemeName name = parse_scheme_name(text);
  families::entry_of(name);
  return families::sampled_of(name);
}

}  // namespace twoscale
