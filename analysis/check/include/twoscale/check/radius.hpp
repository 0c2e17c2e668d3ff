// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. A positive algebraic number rho: exact vectors over Q[x]/(p), p(rho) = 0, and vectors
// of intervals with rational end points.
#pragma once

#include "twoscale/check/matrix.hpp"

#include <span>
#include <string>
#include <vector>

namespace twoscale::check {

/// The only zero of `polynomial` in [low, high], 0 < low.
struct Radius {
  Dense polynomial;  ///< primitive, positive leading coefficient, degree >= 1
  Fraction low, high;
  std::string text;  ///< for messages

  bool is_rational() const { return polynomial.size() == 2; }
};

/// Reads "polynomial" and "interval", the next members of the object; Refused if there is not exactly one zero.
Radius read_radius(Fields& fields, Meter& meter);

/// The rational number as a Radius.
Radius rational_radius(const Fraction& value);

/// A polynomial in x with integer coefficients, in the canonical spelling.
Dense read_in_x(const Value& value, const std::string& where, Meter& meter);

/// The entries are list[i]/scale in Q[x]/(p), of degree less than that of p; scale > 0.
struct Residues {
  std::vector<Dense> list;
  Integer scale = 1;
};

/// Vectors over Q[x]/(p), p of degree >= 1 with positive leading coefficient.
class ResidueRing {
 public:
  ResidueRing(const Dense& p, Meter& meter) : p_(p), meter_(meter) {}

  Residues reduced(Residues v) const;
  Residues times_x(Residues v, std::size_t count) const;
  Residues times(const Matrix& a, const Residues& v) const;
  /// v = sign*w, sign 1 or -1.
  bool equal(const Residues& v, const Residues& w, int sign) const;

 private:
  const Dense& p_;
  Meter& meter_;
};

/// low[i]/scale <= v_i <= high[i]/scale; scale > 0.
struct VectorEnclosure {
  std::vector<Integer> low, high;
  Integer scale = 1;
};

/// target + factor*x, target and x of the same length.
VectorEnclosure combined(const VectorEnclosure& target, const VectorEnclosure& x, const Fraction& factor, Meter& meter);

/// Interval arithmetic with rho. If rho is rational, it is exact (low = high); otherwise every result is rounded
/// outward to multiples of 2^-bits.
class Enclosure {
 public:
  Enclosure(const Radius& radius, unsigned bits, Meter& meter);

  bool is_exact() const { return exact_; }
  unsigned bits() const { return bits_; }
  /// scale times the vector at x = rho.
  VectorEnclosure value(std::span<const Dense> vector, const Fraction& scale) const;
  /// a v/rho.
  VectorEnclosure image(const Matrix& a, const VectorEnclosure& v) const;

 private:
  /// low[i]/scale and high[i]/scale to multiples of 2^-bits (or in lowest terms).
  VectorEnclosure rounded(VectorEnclosure v) const;

  const Radius& radius_;
  Meter& meter_;
  bool exact_;
  unsigned bits_;
  Integer below_, above_, scale_;  // below/scale <= rho <= above/scale, 0 < below
};

}  // namespace twoscale::check
