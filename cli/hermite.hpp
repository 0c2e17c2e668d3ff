// SPDX-License-Identifier: GPL-3.0-or-later
// What refine and plot share for schemes whose vertices carry derivatives.
#pragma once

#include <optional>
#include <string>

#include "session.hpp"
#include "twoscale/lowering/refine_hermite.hpp"

namespace twoscale::cli {

// The tension w of --at, if it is there. Throws Error(bad_input) for any other value: nothing else holds for a whole
// curve.
std::optional<ExactReal> tension(const Values& values);

// `refine` for these schemes. The 2-point rules need no points beyond the ends: every --open is the same.
int refine_hermite_file(const Scheme& scheme, const Values& values, const std::string& input,
                        const lowering::HermiteOptions& options, kernels::PointFormat format, const Common& common);

// `regularity` for these schemes: C^l in the parameter and G^2, as far as the claims of analysis/hermite_claims.hpp
// decide it. `at`: w=VALUE or nothing. Exit status 3 if nothing is known.
int regularity_of_vertices(Scheme scheme, const std::vector<std::string>& at, const std::string& certificate,
                           const Session& session);

}  // namespace twoscale::cli
