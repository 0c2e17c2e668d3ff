// SPDX-License-Identifier: GPL-3.0-or-later
// The mask table of a scheme together with its two-channel filter banks, level by level.
#pragma once

#include "twoscale/lowering/lower.hpp"
#include "twoscale/symbolic/lifting.hpp"

namespace twoscale::lowering {

// lower() of the mask, and MaskTable::filters in the layout of orthonormal_layout(bank), the square roots of 2
// included; every digit is proved as there. precision_error covers masks and filters. `bank` is written in the
// parameters of `scheme`. Throws as lower(), and if the arity is not 2.
kernels::MaskTable lower_filters(const Scheme& scheme, const FilterBank& bank, const Binding& binding,
                                 const LowerOptions& options);

}  // namespace twoscale::lowering
