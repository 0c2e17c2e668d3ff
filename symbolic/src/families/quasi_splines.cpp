// SPDX-License-Identifier: GPL-3.0-or-later
// Exponential quasi-splines and what falls out of the same algebra: pseudo-splines, dual 2l-point schemes, de Rham
// transforms.
//
// One line through two masks serves all parameters: a + s (direction), s constant over all levels.
//   omega=s     from the member, along beta prod (x - gamma_i): every mask of one term more that reproduces the same.
//               Stationary this is jeong2013 (6)-(7); with frequencies it is (20).
//   tension=s   from a second member ("keep"), s = 0, to the member, s = 1. jeong2013 (26): keep="1,x" in the same
//               space. (27)-(28): keep="1,x", keep_space="1,x", the chord of the polygon against the 4-point scheme.
// What both ends generate and reproduce with the same shift p stays so for every s.
#include "twoscale/symbolic/quasi_spline.hpp"

#include <algorithm>

#include "recipes.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::families {

namespace {

// {1, x}, else {1}, else the first pair of exponentials.
Space first_pair(const Space& space) {
  if (space.polynomial_order() > 0) return polynomials(std::min(2U, space.polynomial_order()));
  const auto items = space.items();
  return Space::parse(items[0] + ", " + items[1]);
}

void refuse_taken_names(const RationalFunction& value, const Space& space, const std::string& key) {
  for (const auto& name : value.variables()) {
    bool taken = name == "x" || name == "z" || name.starts_with("v0");
    for (const auto& v : space.variables()) taken = taken || name == v.name || name == v.symbol;
    if (taken) bad_input(key + ": this name is taken by a frequency, its level variable or the argument", name);
  }
}

// Orders and multiplicities are what limits the space of a mask that both ends generate.
Scheme with_claims(Scheme s, const Space& generated, const Space& reproduced, const std::string& source) {
  s.source = source;
  s.space = generated;
  s.reproduced = reproduced;
  if (is_interpolatory(s)) s.claims.push_back({"interpolatory", "", source});
  s.claims.push_back({"symmetric", "", source});
  if (generated.polynomial_order() > 0)
    s.claims.push_back({"sum-rules", std::to_string(generated.polynomial_order()), source});
  s.claims.push_back({"generates", generated.to_string(), source});
  s.claims.push_back({"reproduces", reproduced.to_string(), source});
  s.claims.push_back({"maximal", generated.to_string(), ""});
  s.claims.push_back({"well-defined", "", source});
  return s;
}

std::string title(const QuasiSpline& s) {
  const std::string order = std::to_string(s.order());
  if (s.order() == 2 * s.terms())
    return order + "-point interpolating scheme of {" + s.space.to_string() + "} (quasi-spline of order " + order +
           ", M = " + std::to_string(s.terms()) + ")";
  return (s.order() % 2 == 0 ? "primal" : "dual") + std::string(" quasi-spline of order ") + order +
         ", M = " + std::to_string(s.terms()) + ": reproduces {" + s.reproduced.to_string() + "} of {" +
         s.space.to_string() + "}";
}

Scheme member(const SchemeName& name, const QuasiSpline& s, const std::string& source) {
  Scheme scheme = Scheme::from_symbol(name.to_string(), s.mask, 2, level_parameters(s.space));
  scheme.title = title(s);
  return with_claims(std::move(scheme), s.space, s.reproduced, source);
}

Scheme quasi_spline_recipe(const SchemeName& given) {
  const auto& keys = given.keys;
  const auto has = [&](const char* key) { return keys.contains(key); };
  if (has("omega") && has("tension")) bad_input("quasi-spline: give omega or tension, not both", given.to_string());
  for (const char* key : {"keep", "keep_space"})
    if (has(key) && !has("tension")) bad_input("quasi-spline: this key goes with tension", key);
  const Space space = Space::parse(keys.at("space"));
  const Space part = has("reproduce") ? Space::parse(keys.at("reproduce")) : has("omega") ? first_pair(space) : space;
  const QuasiSpline s = quasi_spline(space, part);

  SchemeName name = given;
  name.keys["space"] = space.to_string();
  name.keys["reproduce"] = s.reproduced.to_string();
  if (!has("omega") && !has("tension")) return member(name, s, "jeong2013 (23)-(25)");

  const char* key = has("omega") ? "omega" : "tension";
  const RationalFunction value = parse_rational_function(keys.at(key));
  refuse_taken_names(value, s.space, std::string("quasi-spline: ") + key);
  name.keys[key] = value.to_string();
  Laurent mask;
  std::string text;
  Space generated = s.space;
  Space reproduced = s.reproduced;
  if (has("omega")) {
    mask = s.mask + value * (s.beta * free_factor(s));
    text = title(s) + " for every omega";
  } else {
    const Space keep_space = has("keep_space") ? Space::parse(keys.at("keep_space")) : space;
    const Space keep = has("keep") ? Space::parse(keys.at("keep")) : first_pair(keep_space);
    if (keep_space.dimension() % 2 != space.dimension() % 2)
      bad_input("quasi-spline: keep_space must have even dimension where the space has, and odd where it has",
                keep_space.to_string());
    const auto require_part = [](const Space& part_of, const Space& whole, const std::string& what) {
      const auto have = whole.items();
      for (const auto& item : part_of.items())
        if (std::find(have.begin(), have.end(), item) == have.end())
          bad_input("quasi-spline: " + what + " contains what is not in {" + whole.to_string() + "}", item);
    };
    require_part(keep_space, space, "keep_space");
    require_part(keep, s.reproduced, "keep");
    const QuasiSpline k = quasi_spline(Space::rebase(keep_space, s.space.variables()).space, keep);
    name.keys["keep"] = k.reproduced.to_string();
    if (has("keep_space")) name.keys["keep_space"] = keep_space.to_string();
    mask = k.mask + value * (s.mask - k.mask);
    // At the ends it is the member itself.
    generated = value.is_one() ? s.space : k.space;
    reproduced = value.is_one() ? s.reproduced : k.reproduced;
    text = "quasi-spline with tension " + value.to_string() + ": 0 reproduces {" + k.reproduced.to_string() +
           "}, 1 reproduces {" + s.reproduced.to_string() + "}";
  }
  std::vector<Parameter> parameters = level_parameters(s.space);
  for (const auto& v : value.variables()) parameters.push_back({v, Parameter::Scope::constant});
  Scheme scheme = Scheme::from_symbol(name.to_string(), mask, 2, std::move(parameters));
  scheme.title = text;
  return with_claims(std::move(scheme), generated, reproduced,
                     has("omega") ? "jeong2013 (6)-(7), (20)" : "jeong2013 (26)-(28)");
}

Scheme pseudo_spline(const SchemeName& name) {
  const auto order = static_cast<unsigned>(integer_key(name, "order", 1, 2 * largest_l));
  const auto l = static_cast<unsigned>(integer_key(name, "l", 0, static_cast<long>(order + 1) / 2 - 1));
  const QuasiSpline s = quasi_spline(polynomials(order), polynomials(std::min(2 * (l + 1), order)));
  Scheme scheme = member(name, s, "Dong and Shen 2007; Dyn, Hormann, Sabin and Shen 2008");
  scheme.title = (order % 2 == 0 ? "primal" : "dual") + std::string(" pseudo-spline, (1 + z)^") +
                 std::to_string(order) + " times degree " + std::to_string(l) + " in z + 1/z";
  return scheme;
}

// A symmetric dual mask vanishes at z = -1 to an odd order: where a space asks for an even one, x^r comes with x^{r-1}.
Space with_next_power(const Space& space) {
  const unsigned r = space.polynomial_order();
  return Space::parse(space.to_string() + (r == 0 ? ", 1" : r == 1 ? ", x" : ", x^" + std::to_string(r)));
}

// The interpolant of 2l points at one and three quarters of the middle interval: its mask has 4l coefficients, 2l
// conditions on each rule.
Scheme dual_point(const SchemeName& given) {
  const Space part = Space::parse(given.keys.at("space"));
  if (part.dimension() % 2 == 1) bad_input("dual: a 2l-point rule needs a space of even dimension", part.to_string());
  SchemeName name = given;
  name.keys["space"] = part.to_string();
  Scheme s = member(name, quasi_spline(with_next_power(part), part), "Dyn, Floater and Hormann 2005; jeong2013 (23)");
  s.title = "dual " + std::to_string(part.dimension()) + "-point scheme of {" + part.to_string() + "}";
  return s;
}

Scheme de_rham(const SchemeName& given) {
  const Space space = Space::parse(given.keys.at("space"));
  if (space.dimension() % 2 == 1)
    bad_input("de-rham: a primal scheme needs a space of even dimension", space.to_string());
  const QuasiSpline s =
      quasi_spline(space, given.keys.contains("reproduce") ? Space::parse(given.keys.at("reproduce")) : space);
  const DeRham d = de_rham_transform(s.space, s.mask);
  SchemeName name = given;
  name.keys["space"] = space.to_string();
  name.keys["reproduce"] = s.reproduced.to_string();
  Scheme scheme = Scheme::from_symbol(name.to_string(), d.mask, 2, level_parameters(d.space));
  scheme.title = "de Rham transform of the " + title(s);
  const auto rebased = [&](const Space& x) { return Space::rebase(x, d.space.variables()).space; };
  return with_claims(std::move(scheme), rebased(with_next_power(s.space)), rebased(s.reproduced),
                     "Conti and Romani 2013");
}

}  // namespace

void add_quasi_splines(std::vector<CatalogEntry>& list) {
  list.push_back(
      {"quasi-spline",
       "exponential quasi-spline: an exponential B-spline times the factor that makes it reproduce more",
       "jeong2013 (23)-(25)",
       {{"space", "comma list of functions: what is generated", true},
        {"reproduce",
         "comma list, a part of the space; if absent all of it, with omega {1,x} or the first pair of exponentials",
         false},
        {"omega", "parameter of the masks of one term more that reproduce the same: a name or a value", false},
        {"tension", "parameter, a name or a value: 0 reproduces `keep` only, 1 is the scheme without tension", false},
        {"keep", "with tension: what is reproduced for every tension; {1,x} or the first pair if absent", false},
        {"keep_space", "with tension: what is generated for every tension; the space if absent", false}},
       {"quasi-spline:space=\"1,x,x^2,exp(t*x),exp(-t*x)\",reproduce=\"1,x,exp(t*x),exp(-t*x)\"",
        "quasi-spline:space=\"1,x,exp(t*x),exp(-t*x)\"", "quasi-spline:space=\"1,x,exp(t*x),exp(-t*x)\",reproduce=1",
        "quasi-spline:space=\"1,x,x^2,x^3\",omega=omega", "quasi-spline:space=\"1,x,x^2,x^3,x^4\",omega=-5/8",
        "quasi-spline:space=\"1,x,exp(t*x),exp(-t*x)\",omega=w", "quasi-spline:space=\"1,exp(t*x),exp(-t*x)\",omega=w",
        "quasi-spline:space=\"1,exp(t*x),exp(-t*x)\"", "quasi-spline:space=\"cos(s*x),sin(s*x)\"",
        "quasi-spline:space=\"1,x,exp(t*x),exp(-t*x)\",tension=w",
        "quasi-spline:space=\"1,x,exp(t*x),exp(-t*x)\",tension=1/2",
        "quasi-spline:space=\"1,x,exp(t*x),exp(-t*x)\",tension=w,keep=\"1,x\",keep_space=\"1,x\"",
        "quasi-spline:space=\"1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)\",reproduce=\"1,x,exp(t*x),exp(-t*x)\"",
        "quasi-spline:space=\"1,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)\",reproduce=\"exp(s*x),exp(-s*x),exp(t*x),exp(-t*"
        "x)"
        "\"",
        "quasi-spline:space=\"1,x,cos(s*x),sin(s*x),x*cos(s*x),x*sin(s*x)\",reproduce=\"cos(s*x),sin(s*x),x*cos(s*x),x*"
        "sin(s*x)\"",
        "quasi-spline:space=\"1,x,x^2,exp(t*x),exp(-t*x),exp(2*t*x),exp(-2*t*x)\",reproduce=\"1,x,exp(2*t*x),exp(-2*t*"
        "x)\""},
       quasi_spline_recipe});
  list.push_back({"pseudo-spline",
                  "stationary pseudo-spline: the quasi-spline of polynomials",
                  "Dong and Shen 2007; Dyn, Hormann, Sabin and Shen 2008",
                  {{"order", "N, the number of factors 1 + z; even: primal, odd: dual", true},
                   {"l", "degree of the other factor in z + 1/z, 0 <= l <= (N-1)/2", true}},
                  {"pseudo-spline:order=4,l=0", "pseudo-spline:order=6,l=1", "pseudo-spline:order=5,l=1",
                   "pseudo-spline:order=6,l=2", "pseudo-spline:order=5,l=2"},
                  pseudo_spline});
  list.push_back({"dual",
                  "dual 2l-point scheme: the interpolant of 2l points at 1/4 and 3/4",
                  "Dyn, Floater and Hormann 2005; jeong2013 (23)",
                  {{"space", "comma list of functions: what is reproduced", true}},
                  {"dual:space=\"1,x,x^2,x^3\"", "dual:space=\"1,x\"", "dual:space=\"1,x,exp(t*x),exp(-t*x)\"",
                   "dual:space=\"cos(s*x),sin(s*x)\""},
                  dual_point});
  list.push_back({"de-rham",
                  "dual scheme of de Rham type: two steps of a primal quasi-spline, read off half way",
                  "Conti and Romani 2013",
                  {{"space", "comma list of functions", true},
                   {"reproduce", "comma list, a part of the space; all of it if absent", false}},
                  {"de-rham:space=\"1,x\"", "de-rham:space=\"1,x,x^2,x^3\"", "de-rham:space=\"1,x,exp(t*x),exp(-t*x)\"",
                   "de-rham:space=\"1,x,exp(t*x),exp(-t*x)\",reproduce=\"1,x\""},
                  de_rham});
}

}  // namespace twoscale::families
