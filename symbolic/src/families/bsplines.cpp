// SPDX-License-Identifier: GPL-3.0-or-later
// B-splines, polynomial and exponential: sigma of a space, and the three approximating families of romani2009.
#include "recipes.hpp"
#include "twoscale/symbolic/symbol.hpp"

namespace twoscale::families {

namespace {

// sigma of a space, with what is true of every exponential B-spline.
Scheme approximating(const SchemeName& name, const Space& space, const std::string& source) {
  Scheme s = Scheme::from_symbol(canonical_id(name, space), bspline_symbol(space, arity_key(name)), arity_key(name),
                                 level_parameters(space));
  s.title = "exponential B-spline of {" + space.to_string() + "}";
  s.source = source;
  s.space = space;
  s.claims.push_back({"symmetric", "", source});
  if (space.polynomial_order() > 0) s.claims.push_back({"sum-rules", std::to_string(space.polynomial_order()), source});
  s.claims.push_back({"generates", space.to_string(), source});
  if (space.polynomial_order() > 0)
    s.claims.push_back(
        {"reproduces", polynomials(std::min(2U, space.polynomial_order())).to_string(), "Conti and Romani 2011"});
  s.claims.push_back({"maximal", space.to_string(), ""});
  s.claims.push_back({"well-defined", "", source});
  return s;
}

std::vector<CatalogEntry::Key> sigma_keys(const std::string& n_help) {
  return {{"n", n_help, true}, {"arity", "arity m, 2 if absent", false}};
}

CatalogEntry family_entry(const std::string& family, const std::string& space, const std::string& equation) {
  const std::string source = "romani2009 " + equation;
  return {family,
          "approximating scheme of " + space,
          source,
          sigma_keys("n of " + space),
          {family + ":n=1", family + ":n=2", family + ":n=3", family + ":n=2,arity=3"},
          [family, source](const SchemeName& name) {
            return approximating(
                name, family_space(family, static_cast<unsigned>(integer_key(name, "n", 1, 2 * largest_l))), source);
          }};
}

}  // namespace

void add_bsplines(std::vector<CatalogEntry>& list) {
  list.push_back({"bspline",
                  "polynomial B-spline",
                  "Lane and Riesenfeld 1980",
                  sigma_keys("degree"),
                  {"bspline:n=1", "bspline:n=2", "bspline:n=3", "bspline:n=2,arity=3", "bspline:n=3,arity=4"},
                  [](const SchemeName& name) {
                    const auto n = static_cast<unsigned>(integer_key(name, "n", 0, 2 * largest_l));
                    Scheme s = approximating(name, polynomials(n + 1), "Lane and Riesenfeld 1980");
                    s.title = "B-spline of degree " + std::to_string(n);
                    return s;
                  }});
  list.push_back(
      {"exponential-bspline",
       "sigma of any exponential-polynomial space",
       "romani2009 (2)",
       {{"space", "comma list of functions, e.g. \"1,x,exp(t*x),exp(-t*x)\"", true},
        {"arity", "arity m, 2 if absent", false}},
       {"exponential-bspline:space=\"1,exp(t*x),exp(-t*x)\"", "exponential-bspline:space=\"cos(s*x),sin(s*x)\"",
        "exponential-bspline:space=\"1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)\"",
        "exponential-bspline:arity=3,space=\"1,x,cosh(t*x),sinh(t*x)\""},
       [](const SchemeName& name) {
         return approximating(name, Space::parse(name.keys.at("space")), "romani2009 (2)");
       }});
  list.push_back(family_entry("mixed", "{1, ..., x^n, e^{+-tx}}", "(3)"));
  list.push_back(family_entry("harmonic", "{1, x, e^{+-jtx}, j <= n}", "(9)"));
  list.push_back(family_entry("resonant", "{1, x, x^r e^{+-tx}, r < n}", "(13)"));
}

}  // namespace twoscale::families
