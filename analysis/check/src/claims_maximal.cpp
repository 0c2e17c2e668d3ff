// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Claim `maximal`: nothing outside V is generated, nothing outside W reproduced.
#include "twoscale/check/claims.hpp"

namespace twoscale::check {
namespace {

void require_generated(const Context& context, const Space& space) {
  for (const Exponential& part : space) {
    const std::string name = text_of(Space{part}, context.certificate);
    for (long r = 0; r < part.order; ++r) {
      if (!context.identities.generated(part.frequency, r)) throw Refused(name + " is not generated");
    }
    if (context.identities.symbol_vanishes(part.frequency)) throw Refused(name + ": a(z) is identically zero");
  }
}

}  // namespace

Finding check_maximal(const Context& context, Fields& fields, bool proved) {
  const Certificate& certificate = context.certificate;
  const Space space = read_space(fields.take("space"), certificate, fields.path("space"), false);
  if (!proved) {
    Fields witness(fields.take("witness"), fields.path("witness"));
    const Space larger = read_space(witness.take("larger"), certificate, witness.path("larger"), false);
    witness.done();
    require_generated(context, larger);
    for (const Exponential& part : larger) {
      if (part.order > order_in(space, part.frequency)) {
        return {text_of(space, certificate),
                "also generated: " + text_of(larger, certificate) + ", identity verified",
                {"generation-stepwise"}};
      }
    }
    throw Refused("the witness space is contained in the space");
  }
  const Space reproduced = read_space(fields.take("reproduced"), certificate, fields.path("reproduced"), true);
  require_generated(context, space);

  const Mask& limit = context.identities.limit_mask();
  const long order = dimension(space);
  if (limit.denominator.empty()) throw Refused("the denominator vanishes where all level variables are 1");
  for (long r = 0; r < order; ++r) {
    if (!sum_rule_holds(limit.numerators, limit.lowest, certificate.arity, r, context.meter)) {
      throw Refused("the limit mask has sum rules of order " + std::to_string(r) + " only");
    }
  }
  if (sum_rule_holds(limit.numerators, limit.lowest, certificate.arity, order, context.meter)) {
    throw Refused("the limit mask has sum rules of order " + std::to_string(order + 1) +
                  " at least, more than the dimension");
  }

  for (const Exponential& part : reproduced) {
    const std::string name = text_of(Space{part}, certificate);
    if (part.order > order_in(space, part.frequency)) throw Refused(name + " is not in the generated space");
    for (long r = 0; r < part.order; ++r) {
      if (!context.identities.reproduced(part.frequency, r)) throw Refused(name + " is not reproduced");
    }
  }
  for (const Exponential& part : space) {
    const long reached = order_in(reproduced, part.frequency);
    if (reached < part.order && context.identities.reproduced(part.frequency, reached)) {
      throw Refused("more is reproduced: " + text_of(Space{{part.frequency, reached + 1}}, certificate));
    }
  }
  return {text_of(space, certificate) + ", reproduced " + text_of(reproduced, certificate),
          "the limit mask has sum rules of order exactly " + std::to_string(order) +
              ", nothing more is generated stepwise, or reproduced generically in the parameters",
          {"hurwitz-count"}};
}

}  // namespace twoscale::check
