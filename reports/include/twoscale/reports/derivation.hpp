// SPDX-License-Identifier: GPL-3.0-or-later
// The derivation of a scheme from its space as one value, and its renderings: text, JSON, LaTeX, Markdown, HTML.
#pragma once

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

#include "twoscale/symbolic/mary_interpolatory.hpp"
#include "twoscale/symbolic/quasi_spline.hpp"
#include "twoscale/symbolic/scheme.hpp"

namespace twoscale::reports {

struct Derivation {
  std::string scheme;  // name of what was derived
  Space space;
  int arity = 2;
  Laurent sigma;
  SingularSet singular;
  // The way to the interpolating scheme, where there is one: even dimension, or odd arity.
  struct Interpolating {
    HessenbergSystem system;
    FoldedSystem folded;
    RationalFunction folded_determinant;
    Laurent zeta;
  };
  std::optional<Interpolating> interpolating;
  // For schemes that were asked to reproduce a part of the space: the way to the quasi-spline.
  std::optional<QuasiSpline> quasi;
  std::optional<Laurent> factor;  // mask/beta, if it is not the q of `quasi`
  std::optional<Laurent> mask;    // of the scheme itself, if it is neither sigma nor zeta
};

Derivation derive(const Space& space, int arity, std::string scheme);
// Required: the scheme is made from a space.
Derivation derive(const Scheme& scheme);

nlohmann::ordered_json to_json(const Derivation& d);
std::string to_text(const Derivation& d);
std::string to_latex(const Derivation& d);
std::string to_markdown(const Derivation& d);
// A piece of a page, step by step: sigma; nodes, H w = w_0 e_l, omega; zeta; singular values. Well-formed XML.
std::string to_html(const Derivation& d);

// Numbers N of points from which a closed polygon sampled at 2 pi/N cannot start: v^0 = cos(2 pi/N) is singular.
std::vector<long> impossible_polygons(const SingularSet& singular);

// {"lowest": .., "coefficients": [..]}
nlohmann::ordered_json laurent_json(const Laurent& a);

}  // namespace twoscale::reports
