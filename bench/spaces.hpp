// SPDX-License-Identifier: GPL-3.0-or-later
// The spaces of dimension 2l that the benchmarks derive and prove, by name and l.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/space.hpp"

namespace twoscale::bench {

//   mixed, harmonic, resonant   the families of romani2009: (3), (9), (13)
//   lacunary        {1, x, e^{+-(2j-1)tx} : 0 < j < l}: odd harmonics only; l = 3 is the space of the astroid
//   multiplicities  {x^r : r < 2 ceil(l/2)} + {x^r e^{+-tx} : r < floor(l/2)}
//   two-frequencies pairs dealt out in turn to 1, e^{+-sx}, e^{+-tx}; l = 3: {1, x, e^{+-sx}, e^{+-tx}}
inline Space space(const std::string& name, unsigned l) {
  if (name == "lacunary") {
    std::vector<std::pair<unsigned, unsigned>> multiples;
    for (unsigned j = 1; j < l; ++j) multiples.emplace_back(2 * j - 1, 1);
    return Space::one_frequency(2, multiples);
  }
  if (name == "multiplicities") return Space::one_frequency(2 * (l - l / 2), {{1, l / 2}});
  if (name == "two-frequencies") {
    const auto power = [](unsigned r) { return r == 0 ? std::string() : "x^" + std::to_string(r) + "*"; };
    std::string items = "1,x";
    for (unsigned r = 0; 3 * r < l; ++r) {
      if (r > 0) items += ",x^" + std::to_string(2 * r) + ",x^" + std::to_string(2 * r + 1);
      if (3 * r + 1 < l) items += "," + power(r) + "exp(s*x)," + power(r) + "exp(-s*x)";
      if (3 * r + 2 < l) items += "," + power(r) + "exp(t*x)," + power(r) + "exp(-t*x)";
    }
    return Space::parse(items);
  }
  return family_space(name, family_member(name, l));
}

}  // namespace twoscale::bench
