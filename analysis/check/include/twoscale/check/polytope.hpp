// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Invariant polytopes of families of matrices.
#pragma once

#include "twoscale/check/radius.hpp"

#include <span>

namespace twoscale::check {

struct PolytopeReport {
  std::size_t vertices = 0;      ///< of the absolutely convex hull (up to sign)
  std::size_t eigenvectors = 0;  ///< roots with a word: some product of n matrices has the eigenvalue +-rho^n
};

/// Reads "roots", "tree", "inner", "images", the next members of the object, and verifies that the matrices divided by
/// rho map the absolutely convex hull of the vertices, which span, into itself. `plain`: no words, constant vectors.
PolytopeReport check_polytope(std::span<const Matrix> matrices, const Radius& radius, unsigned bits, bool plain,
                              Fields& fields, Meter& meter);

/// Reads "sign", the next member: 1 or -1.
int read_sign(Fields& fields);

/// An array of indices less than `count`, at most 4096 of them.
std::vector<std::size_t> read_indices(const std::vector<Value>& items, std::size_t count, const std::string& where);

}  // namespace twoscale::check
