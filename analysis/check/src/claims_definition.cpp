// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Claims that are identities of the mask itself: interpolatory, symmetric, sum rules.
#include "twoscale/check/claims.hpp"
#include "twoscale/check/point.hpp"

namespace twoscale::check {
namespace {

const Polynomial& numerator(const Mask& mask, long index) {
  return mask.numerators[static_cast<std::size_t>(index - mask.lowest)];
}

Fraction read_fraction(const Value& value, const std::string& where, Meter& meter) {
  return parse_fraction(as_string(value, where), where, meter);
}

bool equal(const Fraction& a, const Fraction& b) {
  return a.numerator == b.numerator && a.denominator == b.denominator;
}

}  // namespace

Finding check_interpolatory(const Context& context, Fields& fields, bool proved) {
  const Certificate& certificate = context.certificate;
  const Mask& mask = certificate.mask;
  const long m = certificate.arity;
  const std::string subject = "(a_{" + std::to_string(m) + "j} = 1 for j = 0, else 0)";
  if (proved) {
    if (mask.lowest > 0 || mask.highest() < 0) throw Refused("a_0 = 0: the index 0 is outside the support");
    for (long i = mask.lowest; i <= mask.highest(); ++i) {
      if (i % m != 0) continue;
      const Polynomial& n = numerator(mask, i);
      if (i == 0 ? n != mask.denominator : !n.empty()) {
        throw Refused("a_{" + std::to_string(i) + "} is not " + (i == 0 ? "1" : "0"));
      }
    }
    return {subject, "identity verified", {"definition"}};
  }
  Fields witness(fields.take("witness"), fields.path("witness"));
  Point point(witness.take("at"), certificate, witness.path("at"), context.meter);
  const long index = witness.take_integer("index", -limits::index, limits::index);
  const Fraction value = read_fraction(witness.take("value"), witness.path("value"), context.meter);
  witness.done();
  if (index % m != 0) throw Refused("the witness index is not a multiple of the arity");
  if (!point.coefficient_is(index, value)) throw Refused("the witness value is not a_{" + std::to_string(index) + "}");
  if (equal(value, {index == 0 ? 1 : 0, 1})) throw Refused("the witness value is the one of an interpolatory mask");
  return {subject, "a_{" + std::to_string(index) + "} differs at " + point.text(), {"definition"}};
}

Finding check_symmetric(const Context& context, Fields& fields, bool proved) {
  const Certificate& certificate = context.certificate;
  const long twice = certificate.mask.lowest + certificate.mask.highest();
  const SmallFraction middle = twice % 2 == 0 ? SmallFraction{twice / 2, 1} : SmallFraction{twice, 2};
  if (proved) {
    const SmallFraction center =
        parse_small_fraction(fields.take_string("center"), fields.path("center"), context.meter);
    if (center.numerator != middle.numerator || center.denominator != middle.denominator) {
      throw Refused("the centre is not the middle of the support, " + text_of(middle));
    }
    if (!certificate.symmetric) throw Refused("the coefficients are not symmetric about " + text_of(middle));
    return {"about " + text_of(center), "identity verified", {"definition"}};
  }
  Fields witness(fields.take("witness"), fields.path("witness"));
  Point point(witness.take("at"), certificate, witness.path("at"), context.meter);
  const long index = witness.take_integer("index", -limits::index, limits::index);
  const Fraction value = read_fraction(witness.take("value"), witness.path("value"), context.meter);
  const Fraction mirror = read_fraction(witness.take("mirror"), witness.path("mirror"), context.meter);
  witness.done();
  if (!point.coefficient_is(index, value) || !point.coefficient_is(twice - index, mirror)) {
    throw Refused("the witness values are not a_{" + std::to_string(index) + "} and its mirror image");
  }
  if (equal(value, mirror)) throw Refused("the two witness values are equal");
  return {"about any centre",
          "a_{" + std::to_string(index) + "} and a_{" + std::to_string(twice - index) + "} differ at " + point.text(),
          {"definition"}};
}

Finding check_sum_rules(const Context& context, Fields& fields, bool proved) {
  const Certificate& certificate = context.certificate;
  const Mask& mask = certificate.mask;
  const long order = fields.take_integer("order", proved ? 0 : 1, limits::order);
  if (proved) {
    const std::string& exact = fields.take_string("exact");
    if (exact != "yes" && exact != "no") throw Malformed(fields.path("exact") + ": \"yes\" or \"no\" is expected");
    for (long r = 0; r < order; ++r) {
      if (!sum_rule_holds(mask.numerators, mask.lowest, certificate.arity, r, context.meter)) {
        throw Refused("the sums of i^" + std::to_string(r) + " a_i over the residue classes differ");
      }
    }
    if (exact == "yes" && sum_rule_holds(mask.numerators, mask.lowest, certificate.arity, order, context.meter)) {
      throw Refused("the order is not exact: the sums of i^" + std::to_string(order) + " a_i agree as well");
    }
    return {"of order " + std::to_string(order) + (exact == "yes" ? " exactly" : " at least"),
            "identities verified",
            {"definition"}};
  }
  Fields witness(fields.take("witness"), fields.path("witness"));
  Point point(witness.take("at"), certificate, witness.path("at"), context.meter);
  const long power = witness.take_integer("power", 0, order - 1);
  const std::vector<Value>& residues = witness.take_array("residues");
  const std::vector<Value>& values = witness.take_array("values");
  witness.done();
  check_two_sums(context, point, std::vector<long>(certificate.level.size()), power, residues, values,
                 fields.path("witness"));
  return {"of order " + std::to_string(order),
          "the sums for the power " + std::to_string(power) + " differ at " + point.text(),
          {"definition"}};
}

void check_two_sums(const Context& context, Point& point, const std::vector<long>& frequency, long power,
                    const std::vector<Value>& residues, const std::vector<Value>& values, const std::string& where) {
  if (residues.size() != 2 || values.size() != 2) throw Malformed(where + ": two residues and two values are expected");
  std::vector<Fraction> sums;
  std::vector<long> classes;
  for (std::size_t i = 0; i < 2; ++i) {
    classes.push_back(as_integer(residues[i], 0, context.certificate.arity - 1, where + ".residues"));
    sums.push_back(read_fraction(values[i], where + ".values", context.meter));
  }
  for (std::size_t i = 0; i < 2; ++i) {
    if (!point.sum_is(frequency, power, classes[i], false, sums[i])) {
      throw Refused("the witness value is not the sum over the residue class " + std::to_string(classes[i]));
    }
  }
  if (equal(sums[0], sums[1])) throw Refused("the two witness sums are equal");
}

}  // namespace twoscale::check
