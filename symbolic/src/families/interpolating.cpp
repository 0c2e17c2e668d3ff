// SPDX-License-Identifier: GPL-3.0-or-later
// Interpolating schemes of a space: 2l points, Deslauriers-Dubuc, the 4-point scheme with tension.
#include "twoscale/symbolic/mary_interpolatory.hpp"

#include "recipes.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::families {

namespace {

std::string of_arity(int arity) { return arity == 2 ? "" : ", arity " + std::to_string(arity); }

Scheme interpolating(const SchemeName& name, const Space& space, const std::string& binary_source) {
  const int arity = arity_key(name);
  const std::string source = (arity == 2 ? "" : "after ") + binary_source;
  // Points of the rule times arity, about the length of the mask: beyond it nothing can be done with exact masks.
  const unsigned largest = space.variables().empty() ? 4096 : 512;
  if (arity > 2 && space.dimension() * static_cast<unsigned>(arity) > largest)
    bad_input(name.id + ": points times arity must be at most " + std::to_string(largest), name.to_string());
  Scheme s = Scheme::from_symbol(canonical_id(name, space), interpolating_symbol(space, arity), arity,
                                 level_parameters(space));
  s.title = std::to_string(space.dimension()) + "-point interpolating scheme of {" + space.to_string() + "}" +
            of_arity(arity);
  s.source = source;
  s.space = space;
  s.claims.push_back({"interpolatory", "", source});
  s.claims.push_back({"symmetric", "", source});
  if (space.polynomial_order() > 0) s.claims.push_back({"sum-rules", std::to_string(space.polynomial_order()), source});
  s.claims.push_back({"generates", space.to_string(), source});
  s.claims.push_back({"reproduces", space.to_string(), source});
  s.claims.push_back({"maximal", space.to_string(), source});
  s.claims.push_back({"well-defined", "", source});
  return s;
}

}  // namespace

void add_interpolating(std::vector<CatalogEntry>& list) {
  list.push_back(
      {"interpolating",
       "the interpolating scheme of a space of dimension 2l, any arity; 2l+1 for odd arity",
       "romani2009 (16)-(19), corrected",
       {{"space", "comma list of functions", false},
        {"family", "mixed, harmonic or resonant; with l", false},
        {"l", "2l points", false},
        {"arity", "arity m, 2 if absent", false}},
       {"interpolating:family=mixed,l=2", "interpolating:family=mixed,l=3", "interpolating:family=harmonic,l=3",
        "interpolating:family=resonant,l=3", "interpolating:family=mixed,l=4", "interpolating:family=harmonic,l=4",
        "interpolating:family=resonant,l=4", "interpolating:space=\"1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)\"",
        "interpolating:space=\"1,x,cos(t*x),sin(t*x),cos(3*t*x),sin(3*t*x)\"",
        "interpolating:space=\"1,x,x^2,x^3,cos(t*x),sin(t*x),x*cos(t*x),x*sin(t*x)\"",
        "interpolating:space=\"exp(t*x),exp(-t*x)\"", "interpolating:space=\"cosh(x),sinh(x),1,x\"",
        "interpolating:family=mixed,l=2,arity=3", "interpolating:family=harmonic,l=3,arity=3",
        "interpolating:family=resonant,l=3,arity=4", "interpolating:space=\"1,cos(s*x),sin(s*x)\",arity=3",
        "interpolating:space=\"1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)\",arity=3"},
       [](const SchemeName& name) {
         const bool family = name.keys.contains("family");
         if (family == name.keys.contains("space"))
           bad_input("interpolating: give either space=... or family=... with l=...", name.to_string());
         if (!family) {
           if (name.keys.contains("l"))
             bad_input("interpolating: l goes with family, not with space", name.to_string());
           return interpolating(name, Space::parse(name.keys.at("space")), "romani2009 (16)-(19), corrected");
         }
         if (!name.keys.contains("l")) bad_input("interpolating: l is missing", name.to_string());
         const std::string& f = name.keys.at("family");
         const auto l = static_cast<unsigned>(integer_key(name, "l", 2, largest_l));
         return interpolating(name, family_space(f, family_member(f, l)), "romani2009 Corollary 11");
       }});
  list.push_back(
      {"dd",
       "Deslauriers-Dubuc 2l-point",
       "Deslauriers and Dubuc 1989",
       {{"l", "2l points", true}, {"arity", "arity m, 2 if absent", false}},
       {"dd:l=1", "dd:l=2", "dd:l=3", "dd:l=8", "dd:l=2,arity=3", "dd:l=3,arity=4"},
       [](const SchemeName& name) {
         Scheme s = interpolating(name, polynomials(2 * static_cast<unsigned>(integer_key(name, "l", 1, largest_l))),
                                  "Deslauriers and Dubuc 1989");
         s.title = "Deslauriers-Dubuc " + std::to_string(s.space->dimension()) + "-point scheme" + of_arity(s.arity);
         return s;
       }});
  list.push_back(
      {"tension4",
       "4-point scheme with tension v^0",
       "beccari2007 (3), (7)",
       {{"arity", "arity m, 2 if absent", false}},
       {"tension4", "tension4:arity=3"},
       [](const SchemeName& name) { return interpolating(name, family_space("mixed", 1), "beccari2007 (3), (7)"); }});
}

}  // namespace twoscale::families
