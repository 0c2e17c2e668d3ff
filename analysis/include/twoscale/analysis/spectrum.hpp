// SPDX-License-Identifier: GPL-3.0-or-later
// The local subdivision matrix at the vertex 0 (or the junction, for dual schemes), its exact spectrum, and what is
// read off it: limit stencils and necessary conditions for smoothness. Warren 1995; Dyn and Levin 2002.
//
// For a mask with support [lo, hi] and arity m the points f_j with lowest <= j <= top,
//   lowest = -floor(hi/(m-1)),   top = floor(-lo/(m-1)),
// are refined from themselves, f^{k+1} = S f^k with S_ij = a_{i-mj}. S f = lambda f means that the limit function F of
// f satisfies F(t/m) = lambda F(t) near t = 0, t the parameter t^k_j = (j + p)/m^k.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "twoscale/analysis/matrix.hpp"
#include "twoscale/symbolic/laurent.hpp"

namespace twoscale::analysis {

struct LocalMatrix {
  long lowest = 0;  // index of the first row and column
  SymbolicMatrix entries;
};
// Throws Error(bad_input) if there is no index from lowest to top: then the mask has fewer than m coefficients.
LocalMatrix local_matrix(const Laurent& mask, int arity);

// Coefficients ascending, over Q(parameters).
using SpectralPolynomial = std::vector<RationalFunction>;

// An eigenvector over Q(parameters)[x]/(polynomial): each entry is a polynomial in x of smaller degree, and for every
// root in the place of x it is an eigenvector. Primitive: no common factor of all coefficients.
using Eigenvector = std::vector<SpectralPolynomial>;

// An irreducible factor of the characteristic polynomial over Q(parameters).
struct SpectralFactor {
  SpectralPolynomial polynomial;  // monic
  unsigned multiplicity = 1;
  unsigned geometric = 1;          // dimension of the eigenspace of each root
  std::vector<Eigenvector> left;   // bases: row vectors y with y S = x y,
  std::vector<Eigenvector> right;  // column vectors with S u = x u
  std::size_t degree() const { return polynomial.size() - 1; }
};

struct Eigenvalue {
  std::size_t factor = 0;  // index into Spectrum::factors
  // Degree 1 and 2: an expression. Otherwise empty: all that can be said is the polynomial and which root.
  std::string exact;
  // Without parameters: 17 significant digits, correctly rounded, "a + b*I" if it is not real. Otherwise empty.
  std::string decimal;
  // Without parameters: real and imaginary part lie between these decimals, and no other root of the polynomial does.
  // The imaginary ones are 0 exactly for real eigenvalues.
  std::optional<std::array<Rational, 2>> real, imaginary;
  std::array<double, 2> approximate{0, 0};  // for pictures
  // Roots of the factor that this entry stands for: its degree if that is more than 2 and parameters occur, else 1.
  std::size_t roots = 1;
};

// sum_i coefficients[i] f_{lowest+i} is the derivative (0: the value) of the limit function at t = 0 with respect to t,
// for data f on the integers (level 0), wherever the limit has this derivative: always for polynomial data of degree up
// to the sum rules, and only for these if the derivative is of higher order than NecessaryConditions::order.
struct LimitStencil {
  unsigned derivative = 0;
  long lowest = 0;
  std::vector<RationalFunction> coefficients;
};

// Necessary for limits in C^n, if the integer translates of the basic limit function are locally linearly independent:
// the eigenvalues 1, 1/m, .., m^{-n} are simple, all others smaller in modulus than m^{-n}, and the scheme generates
// 1, x, .., x^n (sum rules of order n+1). Only the point t = 0 is looked at; nothing here is sufficient.
struct NecessaryConditions {
  enum class Kind {
    decided,
    conditional,  // eigenvalues depend on parameters: `order` can at most be reached, under `conditions`
    undecided,    // two moduli could not be compared: `order` holds, more is not known
  };
  Kind kind = Kind::decided;
  long order = -1;                      // the largest n; -1: not even for continuity
  std::string obstruction;              // why not n + 1
  std::vector<std::string> conditions;  // conditional: "|w| < 1/4"
};

struct Spectrum {
  int arity = 2;
  LocalMatrix matrix;
  std::string variable;                 // of the polynomials: "x", or another name if a parameter has this one
  std::vector<SpectralFactor> factors;  // product of polynomial^multiplicity = characteristic polynomial; by degree
  // By decreasing modulus, compared exactly; of equal modulus: positive, negative, then by decreasing real part. Those
  // that depend on parameters come last, in the order of their factors.
  std::vector<Eigenvalue> eigenvalues;
  // For the m^{-n} that are simple and have a polynomial of degree n as right eigenvector.
  std::vector<LimitStencil> stencils;
  NecessaryConditions necessary;
};
// Cost: for 31 x 31 over Q, or 15 x 15 with one parameter, a second or less.
Spectrum spectrum(const Laurent& mask, int arity);
// Of a given matrix: factors, eigenvectors and eigenvalues; no stencils, nothing about smoothness.
Spectrum spectrum(LocalMatrix matrix, int arity);
// The same for any local matrix: row j belongs to the parameter knots[j], and the scheme maps polynomials of degree <
// order to such (sum rules for a mask).
Spectrum spectrum(LocalMatrix matrix, int arity, const std::vector<RationalFunction>& knots, long order);

// "x^2 - 1/4*x + (w + 1)/8", highest power first.
std::string polynomial_text(const SpectralPolynomial& p, const std::string& variable);

}  // namespace twoscale::analysis
