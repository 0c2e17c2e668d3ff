// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Claims about the joint spectral radius: jsr-lower, jsr-upper, jsr-exact.
#include "twoscale/check/claims.hpp"
#include "twoscale/check/polytope.hpp"
#include "twoscale/check/remainder.hpp"

#include <utility>

namespace twoscale::check {
namespace {

/// The matrices that a claim is about.
struct Subject {
  std::vector<Matrix> matrices;
  std::string text;      ///< what rho is
  std::string exponent;  ///< `N - log_m`; empty for matrices
  bool limit = false;    ///< the remainder of the limit mask, no parameter
};

constexpr long largest_order = limits::order;

/// Reads "order" and "parameter".
Subject read_subject(const Context& context, Fields& fields, bool range_allowed) {
  const Certificate& certificate = context.certificate;
  const long order = fields.take_integer("order", 0, largest_order);
  const std::vector<Value>& parameter = fields.take_array("parameter");
  const std::string where = fields.path("parameter");
  const std::string n = std::to_string(order);
  Subject subject;
  subject.exponent = n + " - log_" + std::to_string(certificate.arity);
  if (parameter.empty()) {
    subject.matrices = remainder_matrices(context, order);
    subject.text = "of the remainder of order " + n;
    subject.limit = true;
    return subject;
  }
  if (certificate.names.size() != 1 || certificate.constants.size() != 1) {
    throw Malformed(where + ": it needs a mask with exactly one variable, a constant");
  }
  if (parameter.size() != 2) throw Malformed(where + ": two numbers are expected");
  const Fraction low = parse_fraction(as_string(parameter[0], where), where, context.meter);
  const Fraction high = parse_fraction(as_string(parameter[1], where), where, context.meter);
  const int order_of_ends = compare(low, high, context.meter);
  if (order_of_ends > 0) throw Malformed(where + ": the numbers must not descend");
  if (order_of_ends < 0 && !range_allowed) throw Malformed(where + ": the two numbers must be equal");
  subject.matrices = remainder_matrices(context, order, low, high);
  subject.text = "of the remainders of order " + n + ", " + certificate.names.front() +
                 (order_of_ends < 0 ? " in [" + shortened(parameter[0].text) + ", " + shortened(parameter[1].text) + "]"
                                    : " = " + shortened(parameter[0].text));
  return subject;
}

Subject read_subject(const FamilyContext& context, Fields& fields, bool) {
  fields.take_integer("order", 0, 0);
  if (!fields.take_array("parameter").empty()) {
    throw Malformed(fields.path("parameter") + ": [] is expected in a document with matrices");
  }
  Subject subject;
  subject.matrices = context.family.matrices;
  subject.text = "of the matrices";
  return subject;
}

Fraction read_positive(const Value& value, const std::string& where, Meter& meter) {
  Fraction bound = parse_fraction(as_string(value, where), where, meter);
  if (bound.numerator <= 0) throw Malformed(where + ": a positive number is expected");
  return bound;
}

/// base^exponent of a fraction.
Fraction power(const Fraction& base, std::size_t exponent, Meter& meter) {
  return {meter.power(base.numerator, exponent), meter.power(base.denominator, exponent)};
}

/// The matrices in the basis of the columns of T: T^{-1} B_s T.
std::vector<Matrix> transformed(std::vector<Matrix> matrices, const Value& basis, const std::string& where,
                                Meter& meter) {
  if (as_array(basis, where).empty()) return matrices;
  const Matrix t = read_matrix(basis, matrices.front().size, where, meter);
  const std::optional<Matrix> inverted = inverse(t, meter);
  if (!inverted) throw Refused("the basis is not linearly independent");
  for (Matrix& matrix : matrices) {
    matrix = multiply(*inverted, multiply(matrix, t, meter), meter);
    for (const Integer& x : matrix.entries) meter.hold(sizeof(Integer) + 8 * words(x));
  }
  return matrices;
}

struct BlocksReport {
  std::size_t vertices = 0;
  std::size_t eigenvectors = 0;
  std::size_t blocks = 0;
  std::size_t full = 0;  ///< blocks of radius rho, or of a bound that is not less than the required one
};

/// Reads "basis" and "blocks". Each block has the radius `radius` (jsr-exact, radius given) or a bound of its own, not
/// beyond `limit`.
BlocksReport check_blocks(const Subject& subject, const Radius* radius, unsigned bits, const Fraction& limit,
                          Fields& fields, Meter& meter) {
  const Value& basis = fields.take("basis");
  const std::vector<Matrix> matrices = transformed(subject.matrices, basis, fields.path("basis"), meter);
  const std::size_t n = matrices.front().size;
  const std::vector<Value>& items = fields.take_array("blocks");
  BlocksReport report;
  report.blocks = items.size();
  std::size_t first = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string where = fields.path("blocks") + "[" + std::to_string(i) + "]";
    Fields block(items[i], where);
    if (first == n) throw Malformed(where + ": the sizes of the blocks exceed the size of the matrices");
    const auto size = static_cast<std::size_t>(block.take_integer("size", 1, static_cast<long>(n - first)));
    const std::string& text = block.take_string("bound");
    if (text.empty() && radius == nullptr) throw Malformed(block.path("bound") + ": a bound is expected");
    Radius own;
    if (!text.empty()) {
      const Fraction bound = parse_fraction(text, block.path("bound"), meter);
      if (bound.numerator <= 0) throw Malformed(block.path("bound") + ": a positive number is expected");
      const int order = compare(bound, limit, meter);
      if (order > 0) throw Refused("the bound of the block " + std::to_string(i) + " is too large");
      if (order == 0) ++report.full;
      own = rational_radius(bound);
    } else {
      ++report.full;
    }
    std::vector<Matrix> parts;
    for (const Matrix& matrix : matrices) {
      for (std::size_t row = first + size; row < n; ++row) {
        for (std::size_t column = first; column < first + size; ++column) {
          if (matrix.at(row, column) != 0) throw Refused("the matrices are not block triangular in this basis");
        }
      }
      meter.spend(n * size);
      parts.push_back(diagonal_block(matrix, first, size, meter));
    }
    const bool plain = !text.empty();
    const PolytopeReport polytope = check_polytope(parts, plain ? own : *radius, plain ? 0 : bits, plain, block, meter);
    block.done();
    report.vertices += polytope.vertices;
    report.eigenvectors += polytope.eigenvectors;
    first += size;
  }
  if (first != n) throw Malformed(fields.path("blocks") + ": the sizes must add up to " + std::to_string(n));
  return report;
}

std::string polytope_text(const BlocksReport& report) {
  return "invariant polytope" +
         std::string(report.blocks > 1 ? "s of " + std::to_string(report.blocks) + " blocks" : "") + " with " +
         std::to_string(report.vertices) + " vertices up to sign verified";
}

/// What an upper bound means for the limits of the scheme.
std::string regularity(const Subject& subject, const std::string& bound, bool exact) {
  if (subject.exponent.empty()) return "";
  return "; Hoelder exponent of the limits >= " + subject.exponent + "(" + bound + ") if this is positive" +
         (exact && subject.limit ? ", = if the integer shifts are stable" : "");
}

/// rho = 0: every diagonal block is zero, so the matrices are nilpotent in common.
void check_zero_blocks(const Subject& subject, Fields& fields, Meter& meter) {
  const Value& basis = fields.take("basis");
  const std::vector<Matrix> matrices = transformed(subject.matrices, basis, fields.path("basis"), meter);
  const std::size_t n = matrices.front().size;
  const std::vector<Value>& items = fields.take_array("blocks");
  std::size_t first = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    Fields block(items[i], fields.path("blocks") + "[" + std::to_string(i) + "]");
    if (first == n) throw Malformed(block.path("size") + ": the sizes of the blocks exceed the size of the matrices");
    const auto size = static_cast<std::size_t>(block.take_integer("size", 1, static_cast<long>(n - first)));
    if (block.take_string("bound") != "0") throw Malformed(block.path("bound") + ": \"0\" is expected");
    for (const char* list : {"roots", "tree", "inner", "images"}) {
      if (!block.take_array(list).empty()) throw Malformed(block.path(list) + ": an empty list is expected");
    }
    block.done();
    for (const Matrix& matrix : matrices) {
      for (std::size_t row = first; row < n; ++row) {
        for (std::size_t column = first; column < first + size; ++column) {
          if (matrix.at(row, column) != 0)
            throw Refused("the matrices are not strictly block triangular in this basis");
        }
      }
    }
    meter.spend(matrices.size() * n * size);
    first += size;
  }
  if (first != n) throw Malformed(fields.path("blocks") + ": the sizes must add up to " + std::to_string(n));
}

template <typename AnyContext>
Finding lower(const AnyContext& context, Fields& fields, bool proved) {
  require_proved(fields, proved);
  Meter& meter = context.meter;
  const Subject subject = read_subject(context, fields, false);
  const std::string where = fields.path("word");
  const std::vector<std::size_t> word = read_indices(fields.take_array("word"), subject.matrices.size(), where);
  if (word.empty()) throw Malformed(where + ": a product of at least one matrix is expected");
  const Value& text = fields.take("bound");
  const Fraction bound = read_positive(text, fields.path("bound"), meter);
  const std::string n = std::to_string(word.size());
  if (spectral_radius_below(product(subject.matrices, word, meter), power(bound, word.size(), meter), meter)) {
    throw Refused("all eigenvalues of the product are less than the bound to the power " + n);
  }
  return {subject.text + ": rho >= " + shortened(text.text),
          "a product of " + n + " matrices has an eigenvalue of absolute value >= bound^" + n +
              (subject.exponent.empty() ? ""
                                        : "; Hoelder exponent of the basic limit function <= " + subject.exponent +
                                              "(bound) if its integer shifts are stable" +
                                              (subject.limit ? "" : " and this order is exact")),
          {"spectral-radius"}};
}

template <typename AnyContext>
Finding upper(const AnyContext& context, Fields& fields, bool proved, RadiusBounds* bounds) {
  require_proved(fields, proved);
  Meter& meter = context.meter;
  const Subject subject = read_subject(context, fields, true);
  const Value& text = fields.take("bound");
  const Fraction bound = read_positive(text, fields.path("bound"), meter);
  const BlocksReport report = check_blocks(subject, nullptr, 0, bound, fields, meter);
  if (bounds != nullptr && subject.limit) bounds->list.push_back(bound);
  const std::string shown = shortened(text.text);
  return {subject.text + ": rho <= " + shown,
          polytope_text(report) + regularity(subject, shown, false),
          {"invariant-polytope"}};
}

template <typename AnyContext>
Finding exact(const AnyContext& context, Fields& fields, bool proved, RadiusBounds* bounds) {
  require_proved(fields, proved);
  Meter& meter = context.meter;
  const Subject subject = read_subject(context, fields, true);
  Fields object(fields.take("radius"), fields.path("radius"));
  if (object.next_is_text("polynomial", "x")) {
    object.take("polynomial");
    for (const Value& end : object.take_array("interval")) {
      if (as_string(end, object.path("interval")) != "0")
        throw Malformed(object.path("interval") + ": [\"0\", \"0\"] is expected");
    }
    object.take_integer("bits", 0, 0);
    object.done();
    check_zero_blocks(subject, fields, meter);
    return {subject.text + ": rho = 0", "strictly block triangular in the basis given", {"invariant-polytope"}};
  }
  const Radius radius = read_radius(object, meter);
  const long bits = object.take_integer("bits", 0, 4096);
  object.done();
  if (radius.is_rational() ? bits != 0 : bits < 16) {
    throw Malformed(object.path("bits") + ": " + (radius.is_rational() ? "0" : "16 to 4096") + " is expected");
  }
  const BlocksReport report = check_blocks(subject, &radius, static_cast<unsigned>(bits), radius.low, fields, meter);
  if (report.eigenvectors == 0) throw Refused("no eigenvector of a product is given: rho may be less");
  if (bounds != nullptr && subject.limit) bounds->list.push_back(radius.high);
  return {subject.text + ": rho = " + radius.text,
          polytope_text(report) + ", with the eigenvector of a product" +
              (report.full == 1 ? "; products of n matrices are bounded by a constant times rho^n" : "") +
              regularity(subject, "rho", true),
          {"invariant-polytope", "spectral-radius"}};
}

}  // namespace

void require_proved(const Fields& fields, bool proved) {
  if (!proved) throw Malformed(fields.path("verdict") + ": \"proved\" is expected, this claim has no refutation");
}

Finding check_jsr_lower(const Context& context, Fields& fields, bool proved) { return lower(context, fields, proved); }
Finding check_jsr_upper(const Context& context, Fields& fields, bool proved) {
  return upper(context, fields, proved, &context.radius);
}
Finding check_jsr_exact(const Context& context, Fields& fields, bool proved) {
  return exact(context, fields, proved, &context.radius);
}
Finding check_family_jsr_lower(const FamilyContext& context, Fields& fields, bool proved) {
  return lower(context, fields, proved);
}
Finding check_family_jsr_upper(const FamilyContext& context, Fields& fields, bool proved) {
  return upper(context, fields, proved, nullptr);
}
Finding check_family_jsr_exact(const FamilyContext& context, Fields& fields, bool proved) {
  return exact(context, fields, proved, nullptr);
}

}  // namespace twoscale::check
