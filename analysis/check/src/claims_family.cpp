// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Claims about the joint spectral radius rho(w) along a parameter w of the mask:
// nonnegative-family, jsr-lower-family, jsr-family.
#include "twoscale/check/claims.hpp"
#include "twoscale/check/function_polytope.hpp"
#include "twoscale/check/remainder.hpp"
#include "twoscale/check/transition.hpp"

#include <utility>

namespace twoscale::check {
namespace {

/// "order" and "parameter", the first two members of these claims.
struct Range {
  long order = 1;
  AffineCoefficients remainder;
  Fraction low, high;                                   ///< low < high
  std::string name, interval, of_remainders, exponent;  ///< texts
};

Range read_range(const Context& context, Fields& fields) {
  const Certificate& certificate = context.certificate;
  Range range;
  range.order = fields.take_integer("order", 0, limits::order);
  const std::vector<Value>& ends = fields.take_array("parameter");
  const std::string where = fields.path("parameter");
  if (certificate.names.size() != 1 || certificate.constants.size() != 1) {
    throw Malformed(where + ": it needs a mask with exactly one variable, a constant");
  }
  if (ends.size() != 2) throw Malformed(where + ": two numbers are expected");
  range.low = parse_fraction(as_string(ends[0], where), where, context.meter);
  range.high = parse_fraction(as_string(ends[1], where), where, context.meter);
  if (compare(range.low, range.high, context.meter) >= 0) throw Malformed(where + ": the numbers must ascend");
  range.remainder = affine_remainder(context, range.order);
  range.name = certificate.names.front();
  range.interval = "[" + shortened(ends[0].text) + ", " + shortened(ends[1].text) + "]";
  range.of_remainders = "of the remainders of order " + std::to_string(range.order);
  range.exponent = std::to_string(range.order) + " - log_" + std::to_string(certificate.arity);
  return range;
}

struct Bound {
  Fraction value;  ///< positive
  std::string text;
};

Bound read_bound(Fields& fields, Meter& meter) {
  const std::string& text = fields.take_string("bound");
  Bound bound{parse_fraction(text, fields.path("bound"), meter), shortened(text)};
  if (bound.value.numerator <= 0) throw Malformed(fields.path("bound") + ": a positive number is expected");
  return bound;
}

bool nonnegative_at(const std::vector<Integer>& g, Meter& meter) {  // at z = 1 it is m > 0
  return zeros_between(odd_part(cosine_sum(g, meter), meter), {-1, 1}, {1, 1}, meter) == 0;
}

/// det(bound - M(w)) for the transition matrices M(w), times a positive number.
Dense transition_determinant(const AffineCoefficients& c, const Fraction& bound, long arity, Meter& meter) {
  const Matrix fixed = transition(centred(c.constant), c.scale, arity, meter);
  const Matrix linear = transition(centred(c.linear), c.scale, arity, meter);
  const std::size_t n = fixed.size;
  const Integer factor = meter.multiply(-bound.denominator, linear.scale);  // of fixed.entries
  const Integer other = meter.multiply(-bound.denominator, fixed.scale);    // of linear.entries
  const Integer unit = meter.multiply(bound.numerator, meter.multiply(fixed.scale, linear.scale));
  PolynomialMatrix m{n, n, std::vector<Dense>(n * n)};
  for (std::size_t i = 0; i < n * n; ++i) {
    add_product(m.entries[i], {1}, {meter.multiply(factor, fixed.entries[i]), meter.multiply(other, linear.entries[i])},
                meter);
    if (i % (n + 1) == 0) add_product(m.entries[i], {1}, {unit}, meter);
  }
  return eliminate(m, n, meter);
}

/// det(bound^n - sign*B_word(w)), n the length of the word, times a positive number.
Dense word_determinant(const AffineCoefficients& c, const std::vector<std::size_t>& word, int sign,
                       const Fraction& bound, long arity, Meter& meter) {
  const std::vector<PolynomialMatrix> matrices = remainder_matrices(c, arity, {0, 1}, {1}, meter);
  PolynomialMatrix m = product(matrices, word, meter);  // scale^n B_word
  const Integer factor = -sign * meter.power(bound.denominator, word.size());
  const Integer unit = meter.power(meter.multiply(bound.numerator, c.scale), word.size());
  for (std::size_t i = 0; i < m.entries.size(); ++i) {
    m.entries[i] = multiply(m.entries[i], {factor}, meter);
    if (i % (m.columns + 1) == 0) add_product(m.entries[i], {1}, {unit}, meter);
  }
  return eliminate(m, m.columns, meter);
}

/// numerator/denominator, a rational function of u in lowest terms.
struct Function {
  Dense numerator, denominator;
  std::string text;
};

Function read_function(const Value& value, const std::string& where, Meter& meter) {
  Fields fields(value, where);
  Function f;
  const Value& top = fields.take("numerator");
  f.numerator = read_in_u(top, fields.path("numerator"), meter);
  const Value& bottom = fields.take("denominator");
  f.denominator = read_in_u(bottom, fields.path("denominator"), meter);
  fields.done();
  if (f.denominator.empty()) throw Malformed(fields.path("denominator") + ": it is 0");
  const FunctionVector lowest = reduced({{f.numerator}, f.denominator}, meter);
  if (lowest.list[0] != f.numerator || lowest.denominator != f.denominator) {
    throw Malformed(where + ": lowest terms are expected, and a denominator with positive leading coefficient");
  }
  f.text = bottom.text == "1" ? shortened(top.text) : "(" + shortened(top.text) + ")/(" + shortened(bottom.text) + ")";
  return f;
}

}  // namespace

Finding check_nonnegative_family(const Context& context, Fields& fields, bool proved) {
  require_proved(fields, proved);
  Meter& meter = context.meter;
  const long arity = context.certificate.arity;
  const Range range = read_range(context, fields);
  const std::string& relation = fields.take_string("relation");
  const bool below = relation == "below";
  if (!below && relation != "above") throw Malformed(fields.path("relation") + ": \"below\" or \"above\" is expected");
  const Bound bound = read_bound(fields, meter);

  // The linear part must be symmetric as well; its ends may be 0.
  const Dense chi = transition_determinant(range.remainder, bound.value, arity, meter);
  for (const Fraction* end : {&range.low, &range.high}) {
    if (!nonnegative_at(centred(at(range.remainder, *end, meter).list), meter)) {
      throw Refused("the symbol of the remainder changes its sign at an end of the interval");
    }
  }
  if (chi.empty() || zeros_between(chi, range.low, range.high, meter) != 0) {
    throw Refused("the bound is an eigenvalue of the transition matrix in the interval");
  }
  const Coefficients c = at(range.remainder, middle_of(range.low, range.high, meter), meter);
  const Matrix matrix = transition(centred(c.list), c.scale, arity, meter);
  std::vector<Integer> unit(matrix.size);
  unit[0] = 1;
  const bool larger = zeros_from(minimal_polynomial(matrix, std::move(unit), meter), bound.value, meter) > 0;
  if (larger == below) throw Refused("the radius in the middle of the interval is on the other side of the bound");

  return {range.of_remainders + ": rho " + (below ? "<" : ">") + " " + bound.text + " for " + range.name + " in " +
              range.interval + " without the ends",
          "the symbol is non-negative, the bound no eigenvalue of its transition matrix; Hoelder exponent of " +
              std::string(below ? "the limits > " : "the basic limit function < ") + range.exponent + "(" + bound.text +
              ")" + (below ? " if this is not negative" : " if its integer shifts are stable and this order is exact"),
          {"nonnegative-symbol", "sturm"}};
}

Finding check_jsr_lower_family(const Context& context, Fields& fields, bool proved) {
  require_proved(fields, proved);
  Meter& meter = context.meter;
  const long arity = context.certificate.arity;
  const Range range = read_range(context, fields);
  const std::string where = fields.path("word");
  const auto word = read_indices(fields.take_array("word"), static_cast<std::size_t>(arity), where);
  if (word.empty()) throw Malformed(where + ": a product of at least one matrix is expected");
  const int sign = read_sign(fields);
  const Bound bound = read_bound(fields, meter);

  const Dense beyond = word_determinant(range.remainder, word, sign, bound.value, arity, meter);
  if (beyond.empty() || !is_nonnegative_between(negated(beyond), range.low, range.high, meter)) {
    throw Refused("the product is not seen to have a real eigenvalue beyond the bound in the whole interval");
  }
  return {range.of_remainders + ": rho >= " + bound.text + " for " + range.name + " in " + range.interval,
          "a product of " + std::to_string(word.size()) + " matrices has " + (sign > 0 ? "an" : "a negative") +
              " eigenvalue of absolute value >= bound^" + std::to_string(word.size()) +
              "; Hoelder exponent of the basic limit function <= " + range.exponent + "(" + bound.text +
              ") if its integer shifts are stable and this order is exact",
          {"spectral-radius", "sturm"}};
}

Finding check_jsr_family(const Context& context, Fields& fields, bool proved) {
  require_proved(fields, proved);
  Meter& meter = context.meter;
  const Range range = read_range(context, fields);
  const Function phi = read_function(fields.take("substitution"), fields.path("substitution"), meter);
  const Function psi = read_function(fields.take("radius"), fields.path("radius"), meter);
  if (zeros_between(phi.denominator, range.low, range.high, meter) != 0 ||
      zeros_between(psi.denominator, range.low, range.high, meter) != 0) {
    throw Refused("the substitution or the radius has a pole in the interval");
  }
  if (!is_positive_between(multiply(psi.numerator, psi.denominator, meter), range.low, range.high, meter)) {
    throw Refused("the radius is not positive in the interval");
  }
  FunctionFamily family;
  family.low = range.low;
  family.high = range.high;
  family.matrices =
      remainder_matrices(range.remainder, context.certificate.arity, phi.numerator, phi.denominator, meter);
  family.numerator = psi.denominator;
  family.denominator = multiply(multiply(phi.denominator, {range.remainder.scale}, meter), psi.numerator, meter);
  const PolytopeReport report = check_function_polytope(family, fields, meter);
  return {range.of_remainders + ": rho = " + psi.text + " for " + range.name + " = " + phi.text + ", u in " +
              range.interval + " (poles excluded)",
          "invariant polytope with " + std::to_string(report.vertices) +
              " vertices up to sign verified for each u, with the eigenvector of a product; Hoelder exponent of the "
              "limits >= " +
              range.exponent + "(rho) if this is positive, = if the integer shifts are stable and this order is exact",
          {"invariant-polytope", "spectral-radius", "sturm"}};
}

}  // namespace twoscale::check
