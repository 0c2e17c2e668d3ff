// SPDX-License-Identifier: GPL-3.0-or-later
#include "hermite.hpp"

#include <iostream>

#include "twoscale/kernels/number_text.hpp"
#include "twoscale/kernels/points_io.hpp"
#include "twoscale/kernels/write_file.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::cli {

std::optional<ExactReal> tension(const Values& values) {
  if (values.v0 || values.t) bad_input("the scheme has no level variable", values.v0 ? *values.v0 : *values.t);
  std::optional<ExactReal> w;
  for (const auto& [name, value] : values.named()) {
    if (name != "w") bad_input("--at: the scheme takes no value of this name for a whole curve", name);
    if (w) bad_input("--at: given twice", name);
    w = parse_real(value);
  }
  return w;
}

int refine_hermite_file(const Scheme& scheme, const Values& values, const std::string& input,
                        const lowering::HermiteOptions& options, kernels::PointFormat format, const Common& common) {
  const auto w = tension(values);
  const lowering::HermiteResult result = lowering::refine_hermite(scheme, w, kernels::read_points(input), options);
  const bool all = format == kernels::PointFormat::csv || format == kernels::PointFormat::npy;
  kernels::write_file(
      common.output,
      kernels::points_to_bytes(all ? result.points : lowering::points_alone(result.points), format, options.closed));
  if (!common.quiet && result.first_pole)
    std::cerr << "twoscale: the first pole of these data is at w* = " << kernels::shortest(*result.first_pole) << "\n";
  return 0;
}

}  // namespace twoscale::cli
