// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Claim `positivity`: a polynomial is nonnegative, or positive, on a box.
#include "twoscale/check/claims.hpp"
#include "twoscale/check/positivity.hpp"

namespace twoscale::check {

std::string_view positivity_theorem(const Value& claim) {
  for (std::size_t i = 0; i < claim.keys.size(); ++i) {
    const Value& member = claim.items[i];
    if (claim.keys[i] == "method") return member.text == "sturm" ? "sturm" : "bernstein";
    if (claim.keys[i] == "witness") return !member.keys.empty() && member.keys[0] == "between" ? "sturm" : "definition";
  }
  return "bernstein";
}

Finding check_positivity(Meter& meter, Fields& fields, bool proved) {
  const std::string& text = fields.take_string("polynomial");
  const std::string where = fields.path("polynomial");
  Box box = read_box(fields, meter);
  const Polynomial p = parse_polynomial(text, box.names, where, meter);
  const std::string& strictness = fields.take_string("strict");
  if (strictness != "yes" && strictness != "no") throw Malformed(fields.path("strict") + ": \"yes\" or \"no\"");
  const bool strict = strictness == "yes";
  read_zeros(fields, box);
  for (const Side& side : box.sides) {
    if (!strict && (side.zero_low || side.zero_high)) {
      throw Malformed(fields.path("zeros") + ": without a strict inequality there are no faces to except");
    }
  }
  const std::string domain = text_of(box);
  const std::string subject = (text.size() <= 200 ? text : "(a polynomial)") + (strict ? " > 0" : " >= 0") +
                              (domain.empty() ? "" : " for " + domain);
  if (proved) {
    const std::string& method = fields.take_string("method");
    const std::string& tree = fields.take_string("tree");
    require_positive(p, box, strict, method, tree, fields.path("tree"), meter);
    if (method == "sturm") return {subject, "zeros counted", {"sturm"}};
    return {subject, method == "vertices" ? "values at the vertices" : "Bernstein coefficients", {"bernstein"}};
  }
  const Value& value = fields.take("witness");
  Fields witness(value, fields.path("witness"));
  if (!value.keys.empty() && value.keys[0] == "between") {
    const std::string at = witness.path("between");
    const std::vector<Value>& ends = witness.take_array("between");
    witness.done();
    if (!strict) throw Refused(at + ": a zero refutes only a strict inequality");
    if (ends.size() != 2) throw Malformed(at + ": two ends are expected");
    const auto variable = only_variable(p);
    if (!variable) throw Refused(at + ": Sturm's theorem needs exactly one variable");
    const Fraction low = parse_fraction(as_string(ends[0], at), at, meter);
    const Fraction high = parse_fraction(as_string(ends[1], at), at, meter);
    if (!less(low, high, meter)) throw Malformed(at + ": the ends must ascend");
    const Side& side = box.sides[*variable];
    if (less(low, side.low, meter) || (side.high && less(*side.high, high, meter))) {
      throw Refused(at + ": the interval does not lie in the box");
    }
    if (zeros_between(dense_in(p, *variable), low, high, meter) == 0) throw Refused(at + ": no zero in the interval");
    return {subject, "a zero between " + text_of(low) + " and " + text_of(high), {"sturm"}};
  }
  const std::vector<Fraction> point = read_point(witness.take("at"), box, witness.path("at"), meter);
  const std::string at = witness.path("value");
  const Fraction expected = parse_fraction(witness.take_string("value"), at, meter);
  witness.done();
  if (!value_is(p, point, expected, meter)) throw Refused(at + ": the polynomial has another value at the point");
  if (expected.numerator > 0 || (expected.numerator == 0 && !strict)) throw Refused(at + ": no counterexample");
  if (expected.numerator == 0 && on_excluded_face(point, box)) {
    throw Refused(at + ": a zero on a face where zeros are allowed");
  }
  return {subject, "it is " + text_of(expected) + " at a point of the box", {"definition"}};
}

}  // namespace twoscale::check
