// SPDX-License-Identifier: GPL-3.0-or-later
// The circle-preserving 2-point Hermite scheme with tension (hermite2010).
#include "recipes.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"
#include "twoscale/symbolic/hermite_circle.hpp"

namespace twoscale::families {

namespace {

Scheme circle(const SchemeName& given) {
  SchemeName name = given;
  HermiteTension tension = HermiteTension::printed;
  if (const auto key = name.keys.find("variant"); key != name.keys.end()) {
    if (key->second == "c2")
      tension = HermiteTension::c2;
    else if (key->second != "printed")
      bad_input("hermite-circle: unknown variant (printed, c2)", key->second);
    if (tension == HermiteTension::printed) name.keys.erase(key);
  }
  Rational w(1);
  if (const auto key = name.keys.find("w"); key != name.keys.end()) {
    const auto value = parse_rational_function(key->second).constant();
    if (!value) bad_input("hermite-circle: the tension w must be a rational number", key->second);
    w = *value;
    if (w == Rational(1))
      name.keys.erase(key);
    else
      key->second = w.to_string();
  }
  Scheme s = hermite_circle(w, tension);
  s.id = name.to_string();
  s.title = tension == HermiteTension::printed ? "circle-preserving 2-point Hermite scheme, tension as printed"
                                               : "circle-preserving 2-point Hermite scheme, tension that keeps C^2";
  return s;
}

}  // namespace

void add_hermite(std::vector<CatalogEntry>& list) {
  list.push_back(
      {"hermite-circle",
       "2-point Hermite scheme (value, first and second derivative) that preserves circles, with tension w",
       "hermite2010 (9)-(14), §4",
       {{"w", "tension w > 0, 1 if absent", false},
        {"variant",
         "printed (as in the paper, G^2) or c2 (C^2 in t with the same curvature at the vertices); printed if "
         "absent",
         false}},
       {"hermite-circle", "hermite-circle:w=1/2", "hermite-circle:variant=c2,w=7/5"},
       circle});
}

}  // namespace twoscale::families
