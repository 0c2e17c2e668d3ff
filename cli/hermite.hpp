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

}  // namespace twoscale::cli
