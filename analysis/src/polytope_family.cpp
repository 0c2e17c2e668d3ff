// SPDX-License-Identifier: GPL-3.0-or-later
#include "affine_family.hpp"

namespace twoscale::analysis {

std::vector<RadiusRange> polytope_ranges(const AffineFamily&, const Rational&, const Rational&,
                                         const std::optional<std::pair<RealAlgebraic, RealAlgebraic>>&,
                                         const JsrOptions&, std::vector<nlohmann::ordered_json>&) {
  return {};
}

}  // namespace twoscale::analysis
