// SPDX-License-Identifier: GPL-3.0-or-later
// Interpolatory schemes on arbitrary knots: NULI 4- and 6-point (nuli), and the non-uniform Lagrange 4-point rule.
//
// Local parameters: d, the knot intervals; lambda, the place of the auxiliary knot in an edge, in [0, 1]. A rule is a
// blend of polynomial interpolants at the middle of the edge (nulifs.hpp).
#include "recipes.hpp"
#include "twoscale/symbolic/nulifs.hpp"

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
  list.push_back({"lagrange4",
                  "4-point Lagrange rule on arbitrary knots; knots come with the data",
                  "Daubechies, Guskov and Sweldens 1999",
                  {},
                  {"lagrange4"},
                  lagrange4});
}

}  // namespace twoscale::families
