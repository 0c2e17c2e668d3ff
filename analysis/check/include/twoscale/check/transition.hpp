// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. The transition matrix of a symmetric symbol.
#pragma once

#include "twoscale/check/matrix.hpp"

namespace twoscale::check {

/// g_0, ..., g_h for g(z) = z^{-h} c(z), c symmetric of degree 2h; Refused otherwise.
std::vector<Integer> centred(const std::vector<Integer>& c);

/// M_{ij} = g_{i-mj} + (j > 0 ? g_{i+mj} : 0), 0 <= i, j <= max(0, h-1)/(m-1), for g_k = g[|k|]/scale.
Matrix transition(const std::vector<Integer>& g, const Integer& scale, long arity, Meter& meter);

}  // namespace twoscale::check
