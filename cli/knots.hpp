// SPDX-License-Identifier: GPL-3.0-or-later
// What refine and plot share for schemes on knots.
#pragma once

#include <optional>
#include <string>

#include "session.hpp"
#include "twoscale/kernels/nonuniform.hpp"
#include "twoscale/symbolic/sampled_scheme.hpp"
#include "twoscale/symbolic/scheme.hpp"

namespace twoscale::cli {

// A scheme by name; `sampled` if it is one whose rules are known at numbers only (nuli:n=N).
struct NamedScheme {
  std::optional<SampledScheme> sampled;
  Scheme scheme;
};
NamedScheme named_scheme(const std::string& name);

// --parametrization and --reparametrize.
struct KnotChoice {
  std::optional<std::string> parametrization;
  bool reparametrize = false;
  bool any() const { return parametrization || reparametrize; }
};
void add_knot_choice(CLI::App* command, KnotChoice& choice);

// Unless the choice says otherwise the knots are centripetal, or those of a column d.
kernels::KnotOptions knot_options(const kernels::PointSet& points, unsigned levels, kernels::Boundary boundary,
                                  const KnotChoice& choice);

// With `digits`, that many; else doubles.
kernels::PointSet refine_on_knots(const NamedScheme& s, const kernels::PointSet& points,
                                  const kernels::KnotOptions& options, long digits);

}  // namespace twoscale::cli
