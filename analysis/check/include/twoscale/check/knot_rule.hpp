// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. The rule of an interpolatory scheme on arbitrary knots, and its local matrix at a
// vertex of the data.
//
// Points p_j belong to knots x_j; a step keeps them, and puts sum_h c_h p_{i+h} into the middle of each edge i. The
// weights c_h depend on the intervals of edges i + offset and on edge parameters there. Intervals are halved at every
// step; of the edge parameters only those of the two edges at a vertex of the data are not at rest.
#pragma once

#include "twoscale/check/json.hpp"
#include "twoscale/check/number.hpp"
#include "twoscale/check/polynomial.hpp"

#include <optional>
#include <string>
#include <vector>

namespace twoscale::check {

/// value/scale, scale > 0.
struct Scaled {
  Polynomial value;
  Integer scale = 1;
};
Scaled constant(const Fraction& value);
/// p with its variables replaced, times nothing: exactly p(values).
Scaled substituted(const Polynomial& p, const std::vector<Scaled>& values, Meter& meter);

/// numerator/product of the denominator.
struct Weight {
  Polynomial numerator;
  std::vector<Polynomial> denominator;
};

/// Holds where the polynomial `where` >= 0 and no piece before it holds; the last one everywhere else.
struct RulePiece {
  Polynomial where;
  std::vector<Weight> weights;
};

struct KnotRule {
  struct Variable {
    bool edge = false;  ///< an edge parameter, else an interval
    long offset = 0;
  };
  std::vector<std::string> names;  ///< sorted
  std::vector<Variable> variables;
  bool has_edges = false;
  Fraction rest;
  long lowest = 0;
  std::vector<RulePiece> pieces;

  long highest() const { return lowest + static_cast<long>(pieces.front().weights.size()) - 1; }
  /// The points -reach()..reach() around a vertex are refined from themselves.
  long reach() const { return std::max(1 - 2 * lowest, 2 * highest() - 1); }
};

/// Reads the member `knots`.
KnotRule read_knot_rule(Fields& fields, Meter& meter);

/// The weights on equal intervals 1 with all edge parameters at rest.
std::vector<Fraction> uniform_weights(const KnotRule& rule, Meter& meter);

/// Interval right of the vertex (those left of it are 1), edge parameters left and right of it: polynomials in one list
/// of variables.
struct Place {
  Scaled ratio, left, right;
};
/// The values of the rule's variables for the edge e: intervals 1 for edges below 0, else the ratio; edge parameters of
/// -1 and 0 as given, else at rest.
std::vector<Scaled> values_at(const KnotRule& rule, const Place& place, long edge);

/// The piece that holds, if all conditions up to it are constant.
std::optional<std::size_t> constant_piece(const KnotRule& rule, const std::vector<Scaled>& values, Meter& meter);

/// The weights of one piece as entries/denominator; `factors`, primitive, with positive leading coefficient, not
/// constant, are what must not vanish. Refused at a pole.
struct LocalRow {
  std::vector<Polynomial> entries;
  Polynomial denominator;
  std::vector<Polynomial> factors;
};
LocalRow local_row(const RulePiece& piece, const std::vector<Scaled>& values, Meter& meter);

/// p divided by its content, with positive leading coefficient; p is not 0.
Polynomial primitive_part(const Polynomial& p, Meter& meter);

/// (characteristic polynomial of the local matrix)/(z - 1), times the denominators of all rows. rows[i]: for the odd
/// index -reach() + 2 i, where reach() is odd. z is the variable with this index.
Polynomial local_determinant(const KnotRule& rule, const std::vector<LocalRow>& rows, std::size_t z, Meter& meter);

}  // namespace twoscale::check
