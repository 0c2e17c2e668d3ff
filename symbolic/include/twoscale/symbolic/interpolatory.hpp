// SPDX-License-Identifier: GPL-3.0-or-later
// From an approximating exponential spline scheme to the 2l-point interpolating one: omega and zeta = sigma omega.
//
// Notation (V has even dimension 2l; pairs +-theta_i, i = 0..l-1):
//   w_i = cosh(theta_i/2^{k+1})                         the nodes (space.hpp)
//   gamma_i = 2 w_i                                     sigma = const prod (z^2 + gamma_i z + 1)
//   x = z + 1/z, w = x/2, u = w^2
//   S(x) = z^{-l} sigma(z), W(x) = z^{-(l-1)} omega(z)  S(2) = 2
//
// zeta is interpolatory iff S(x) W(x) + S(-x) W(-x) = 2, that is iff W is the Hermite interpolant of 2/S at the gamma_i
// (when no gamma_i + gamma_j vanishes). Three independent routes to the same answer:
//   1. hessenberg_system: Newton basis at the gamma_i; lower Hessenberg for every l; forward substitution.
//      (The matrix (17)/(20) of romani2009 is right for l = 2, 3 only.)
//   2. folded_system: the l x l system for omega_0..omega_{l-1} that symmetry leaves of the odd coefficients.
//   3. interpolating_symbol: z^{-(2l-1)} zeta = 1 + w Q(w^2), Q the Hermite interpolant of u^{-1/2} at the w_i^2.
#pragma once

#include "twoscale/symbolic/laurent.hpp"
#include "twoscale/symbolic/space.hpp"
#include "twoscale/symbolic/symbol.hpp"

namespace twoscale {

// zeta, centred on 0, of the 2l-point interpolating binary scheme of the space (dimension 2l >= 2).
// Throws Error(bad_input) if the dimension is odd. Cost: O(l^2) polynomial products (route 3); for the harmonic spaces
// {1, x, e^{+-jtx} : j < l} an exponent count of cyclotomic factors; for two different nodes, one simple, O(l)
// products.
Laurent interpolating_symbol(const Space& space);

// The engines behind it, for tests and benchmarks. The first takes any space: divided differences of u^{-1/2} at the
// w_i^2 with numerators in Z[v] over the denominators prod w_i prod (w_i + w_j), confluent blocks in closed form.
Laurent interpolating_symbol_by_divided_differences(const Space& space);
// {1, x, e^{+-jtx} : 0 < j < l}: since T_m(T_i(v)) = T_i(T_m(v)), the conditions sum_m 2 a_m T_i(x_m) = T_i(1), i < l,
// x_m = T_m(v), m = 1, 3, .., 2l-1, say that 2 a_m are the Lagrange polynomials of the x_m at 1:
//   a_m = 1/2 prod_{i != m} (1 - T_i(v))/(T_m(v) - T_i(v)).   nullopt for any other space.
std::optional<Laurent> interpolating_symbol_harmonic(const Space& space);
// Two different nodes, p n = l-1 times and q once: families (3) (p = 1, q = v) and (13) (p = v, q = 1), {1, x,
// exp(+-tx)}, ...
//   z^{-(2l-1)} zeta = 1 + F(w/p) + kappa w (w^2 - p^2)^n,   kappa = (1 - F(q/p))/(q (q^2 - p^2)^n),
//   F(x) = c int_0^x (1-y^2)^{n-1} dy,                         F(1) = 1.
// Proof. 1 - F vanishes n times at 1 and F is odd, so F(w/p)/w has the values and derivatives of u^{-1/2} at u = p^2;
// kappa adds the value at q. 1 - F(y) = 2 ((1-y)/2)^n sum_{k<n} C(n-1+k,k) ((1+y)/2)^k (both sides are the one
// polynomial N of degree < 2n with N(y) + N(-y) = 2 that vanishes n times at 1; Daubechies 1988), hence
//   kappa = (-1)^n 2^{2-2n} G/(q p^{2n-1} (p+q)^n),   G = sum_{k<n} C(n-1+k,k) (2p)^{n-1-k} (p+q)^k.
// nullopt for any other space.
std::optional<Laurent> interpolating_symbol_two_nodes(const Space& space);

// Route 1. matrix * solution = rhs; omega(z) = sum_m solution[m] z^{l-1-m} prod_{i<m} (z^2 - gamma_i z + 1).
struct HessenbergSystem {
  std::vector<Polynomial> nodes;  // gamma_0..gamma_{l-1}
  std::vector<std::vector<RationalFunction>>
      matrix;                              // row r < l-1: [gamma_m..gamma_{r+1}] S, m = 0..r+1; last (1,0,..)
  std::vector<RationalFunction> rhs;       // (0,..,0, w_0), w_0 = 2/S(gamma_0)
  std::vector<RationalFunction> solution;  // w_0..w_{l-1}
  RationalFunction determinant;            // (-1)^{l-1} prod_{r>=1} S(gamma_r)
  Laurent omega;                           // centred on 0
};
HessenbergSystem hessenberg_system(const Space& space);

// Route 2. Unknowns omega_0..omega_{l-1} (papers' indices); row j = 1..l-1: sigma_{2j-1-i} + sigma_{2j+1-2l+i} for
// i < l-1 and sigma_{2j-l} for i = l-1, right side 0; last row: the same formula with j = l, right side 1, and
// (2,..,2,1) when 1 is in V, which is the sum of all rows.
struct FoldedSystem {
  std::vector<std::vector<RationalFunction>> matrix;
  std::vector<RationalFunction> rhs;
  bool hessenberg;  // no entry above the first superdiagonal
};
FoldedSystem folded_system(const Space& space);
// Determinant: a constant times prod_{i<=j} (gamma_i + gamma_j) over the normalisation (Orlando); the constant is read
// off at one rational point.
RationalFunction folded_determinant(const Space& space, const FoldedSystem& system);
// Solves the system by fraction-free elimination and unfolds: omega centred on 0.
Laurent omega_from_folded(const FoldedSystem& system);

// Where a step of the interpolating scheme (even dimension) or the normalisation sigma(1) = 2 (odd) fails.
struct SingularSet {
  // v^0 = cos(angle*pi), 0 < angle < 1, at level k; sorted by v^0 ascending, then level. One trigonometric variable.
  struct Value {
    Rational angle;
    unsigned level;
    std::string exact() const;  // "-1/2", "cos(4*pi/5)"
    friend bool operator==(const Value&, const Value&) = default;
  };
  std::vector<Value> values;
  // With several frequencies: the factors that vanish somewhere on the domain (all level variables > 0).
  std::vector<Polynomial> conditions;
};
SingularSet singular_set(const Space& space);
// Where on the domain one of the sums w_a + w_b (a = b: 2 w_a) vanishes.
SingularSet zeros_of_sums(const Space& space, const std::vector<std::pair<Node, Node>>& sums);
// cos(angle*pi) as an expression: "0", "1/2", "-1/2" or "cos(4*pi/5)".
std::string cosine_text(const Rational& angle);

// Extension of coarse points from the space: p_{-1} = sum_{j=0}^{N-1} e_j p_j for samples of functions of V at spacing
// 1/m^k (the annihilator prod (y - e^{theta/m^k}), symmetric under y -> 1/y), N = dim V, as polynomials in the level
// variables of step k -> k+1. Reversed it extends the other end.
std::vector<Polynomial> extension_weights(const Space& space, int arity = 2);

}  // namespace twoscale
