// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Do the boxes of claims `junction` cover all edge parameters (left, right) in [0, 1]^2?
//
// With k = 1 - left, q = right. A box counts if k and q run over a rectangle, or over a triangle beside the crease
// k = q = 0:
//   rectangle   k and q are constants or polynomials c_0 + c_1 u, c_0 + c_1 v in two different variables with bounded
//               sides: [k_low, k_high] x [q_low, q_high]
//   below       k = u, q = u s, u in [0, size], s in [0, 1]: 0 < k <= size, 0 <= q <= k
//   above       the same with k and q exchanged
// The ratio must be a third variable, with the side (0, infinity).
#pragma once

#include "twoscale/check/meter.hpp"
#include "twoscale/check/number.hpp"
#include "twoscale/check/polynomial.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace twoscale::check {

struct Side;  // positivity.hpp

struct Region {
  enum class Shape { rectangle, below, above };
  Shape shape = Shape::rectangle;
  Fraction k_low, k_high, q_low, q_high;  ///< of a triangle: 0, size, 0, size
};

/// Nothing if the box is of another kind, or leaves out faces other than ratio = 0 and the tip of a triangle.
std::optional<Region> region_of(const Polynomial& left, const Polynomial& right, std::size_t ratio,
                                const std::vector<Side>& sides, Meter& meter);
/// Is the side of the ratio (0, infinity)?
bool all_ratios(const Side& side);

/// How much of [0, 1]^2 the regions cover, by subdivision at all their ends: every cell, those on the diagonal k = q
/// cut in two along it, must lie in one region. Triangles do not hold their tip.
enum class Covering { none, all_but_crease, all };
/// `hole` is a point in an open cell that is not covered, if there is one.
Covering covering_of(const std::vector<Region>& regions, std::string& hole, Meter& meter);

}  // namespace twoscale::check
