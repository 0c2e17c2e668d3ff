// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/lowering/refine_points.hpp"

#include <cmath>

#include "digits.hpp"
#include "twoscale/kernels/number_text.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::lowering {

kernels::PointSet refine_points(const Scheme& scheme, const Binding& binding, const kernels::PointSet& points,
                                const RefineOptions& options) {
  check_output_size(static_cast<double>(points.size()) * std::pow(scheme.arity, options.levels), points.dim,
                    options.digits,
                    std::to_string(points.size()) + " points, " + std::to_string(options.levels) + " levels of arity " +
                        std::to_string(scheme.arity));
  if (options.boundary == kernels::Boundary::closed && points.size() < 3)
    bad_input("a closed polygon needs at least 3 points, not " + std::to_string(points.size()));
  if (options.boundary == kernels::Boundary::space && !scheme.space)
    bad_input("the scheme has no function space that could extend an open polygon", scheme.id);
  LowerOptions lowering{options.levels, 0, options.boundary == kernels::Boundary::space, false};
  const int levels = static_cast<int>(options.levels);
  if (options.digits != 0)
    return with_digits({{&points}}, options.digits, [&](const auto& in, Precision precision) {
      lowering.digits = precision.digits;
      return kernels::refine<Real>(
          in[0], points.dim, lower(scheme, binding, lowering), levels, options.boundary,
          [&](const std::string& text, double) { return coefficient(text, precision.digits, precision.bits); });
    });
  kernels::PointSet out;
  out.columns = points.columns;
  out.dim = points.dim;
  out.values = kernels::refine(points.values, points.dim, lower(scheme, binding, lowering), levels, options.boundary);
  for (const double x : out.values)
    if (!std::isfinite(x)) bad_input("a refined number does not fit a double", kernels::shortest(x));
  return out;
}

}  // namespace twoscale::lowering
