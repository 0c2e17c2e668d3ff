// SPDX-License-Identifier: GPL-3.0-or-later
// How often this program has allocated; operator new is counted in allocations.cpp.
#pragma once

#include <cstddef>

namespace twoscale::kernels::testing {

std::size_t allocations();

}  // namespace twoscale::kernels::testing
