// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Claim `nonstationary`: regularity of a level-dependent scheme from its limit mask.
#include "twoscale/check/claims.hpp"
#include "twoscale/check/remainder.hpp"

#include <algorithm>

namespace twoscale::check {

Finding check_nonstationary(const Context& context, Fields& fields, bool proved) {
  require_proved(fields, proved);
  const Certificate& certificate = context.certificate;
  Meter& meter = context.meter;
  const Space space = read_space(fields.take("space"), certificate, fields.path("space"), false);
  const long continuity = fields.take_integer("continuity", 0, limits::order);
  const long order = dimension(space);
  if (order > limits::order) throw Malformed(fields.path("space") + ": a space of dimension beyond 512");
  exact_remainder(context, order);
  for (const Exponential& part : space) {
    for (long r = 0; r < part.order; ++r) {
      if (!context.identities.generated(part.frequency, r)) {
        throw Refused(text_of(Space{part}, certificate) + " is not generated");
      }
    }
  }
  if (continuity >= order) throw Refused("the continuity must be less than the order " + std::to_string(order));
  const Fraction limit{meter.power(certificate.arity, static_cast<std::uint64_t>(order - continuity)), 1};
  const auto& list = context.radius.list;
  if (std::none_of(list.begin(), list.end(), [&](const Fraction& u) { return compare(u, limit, meter) < 0; })) {
    throw Refused("no claim before this one shows that the radius is less than " + std::to_string(certificate.arity) +
                  "^" + std::to_string(order - continuity));
  }
  const std::string n = std::to_string(order), m = std::to_string(certificate.arity);
  std::string values = certificate.level.empty() && !certificate.constants.empty() ? "" : "every v^0 > -1";
  for (const std::size_t c : certificate.constants)
    values += (values.empty() ? "all values of " : " and all values of ") + certificate.names[c] +
              " whose distances to 1 have a finite sum";
  return {"C^" + std::to_string(continuity) + " for " + values + " for which no step has a pole",
          text_of(space, certificate) + " is generated, the limit mask has sum rules of order exactly " + n +
              ", and rho < " + m + "^" + std::to_string(order - continuity) +
              " by a claim above; Hoelder exponent of "
              "the limits >= " +
              n + " - log_" + m + "(rho)",
          {"nonstationary"}};
}

}  // namespace twoscale::check
