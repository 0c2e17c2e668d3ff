// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Invariant polytopes of families of matrices that depend rationally on a variable u.
#pragma once

#include "twoscale/check/polynomial_matrix.hpp"
#include "twoscale/check/polytope.hpp"

namespace twoscale::check {

/// B_s(u)/psi(u) = matrices[s]*numerator/denominator; none of these has a pole in the open interval (low, high).
struct FunctionFamily {
  std::vector<PolynomialMatrix> matrices;
  Dense numerator, denominator;
  Fraction low, high;
};

/// A polynomial in u with integer coefficients, in the canonical spelling.
Dense read_in_u(const Value& value, const std::string& where, Meter& meter);

/// Reads "roots", "tree", "inner", "images", the next members of the object, and verifies that for each u in the open
/// interval the B_s/psi map the absolutely convex hull of the vertices, which span, into itself, and that for all but
/// finitely many of them some product of n matrices B_s has the eigenvalue +-psi^n.
PolytopeReport check_function_polytope(const FunctionFamily& family, Fields& fields, Meter& meter);

}  // namespace twoscale::check
