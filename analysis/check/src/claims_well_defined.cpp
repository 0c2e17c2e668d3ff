// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Claim `well-defined`: the mask is finite exactly outside the listed exceptions.
#include "twoscale/check/claims.hpp"
#include "twoscale/check/cyclotomic.hpp"
#include "twoscale/check/exceptions.hpp"

#include <algorithm>

namespace twoscale::check {

Finding check_well_defined(const Context& context, Fields& fields, bool proved) {
  const Certificate& certificate = context.certificate;
  const Mask& mask = certificate.mask;
  const bool univariate = certificate.names.empty() || certificate.single_level();
  if (proved) {
    Exceptions exceptions(fields.take("exceptions"), certificate, fields.path("exceptions"), context.meter);
    exceptions.require_no_other_zero(mask.denominator, "the denominator");
    exceptions.require_all_used("the denominator");
    exceptions.require_poles();
    return {exceptions.text(), "zeros of the denominator verified", {univariate ? "sturm" : "positive-coefficients"}};
  }
  if (!certificate.single_level()) {
    throw Malformed(fields.path("verdict") + ": a refutation needs exactly one variable, a level variable");
  }
  Fields witness(fields.take("witness"), fields.path("witness"));
  const Angle angle = read_angle(witness, context.meter);
  witness.done();
  const auto order = root_order(angle, certificate.arity);
  const auto vanishes = [&](const Polynomial& p) { return cosine_divides(dense(p), *order, context.meter); };
  if (!order || !vanishes(mask.denominator)) throw Refused("the denominator does not vanish at the witness");
  if (std::all_of(mask.numerators.begin(), mask.numerators.end(), vanishes)) {
    throw Refused("all numerators vanish at the witness");
  }
  return {"for every v^0 > -1 and every level", "pole at " + text_of(angle), {"sturm"}};
}

}  // namespace twoscale::check
