// SPDX-License-Identifier: GPL-3.0-or-later
// From an approximating exponential spline scheme to the 2l-point interpolating one: omega and zeta = sigma omega.
//
// Binary notation (any arity, and odd dimensions: mary_interpolatory.hpp); V has even dimension 2l; pairs +-theta_i, i
// = 0..l-1:
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

// zeta, centred on 0, of the interpolating scheme of the space: 2l points, dimension 2l >= 2; for odd arity also 2l+1.
// Throws Error(bad_input) if there is none. Cost for arity 2: O(l^2) polynomial products (route 3); for the harmonic
// spaces {1, x, e^{+-jtx} : j < l} an exponent count of cyclotomic factors; for two different nodes, one simple, O(l)
// products. Arity m > 2: O(m l^2) products.
Laurent interpolating_symbol(const Space& space, int arity = 2);

// The engines behind it, for tests and benchmarks. The first takes any space: divided differences of u^{-1/2} at the
// w_i^2 with numerators in Z[v] over the denominators prod w_i prod (w_i + w_j), confluent blocks in closed form.
Laurent interpolating_symbol_by_divided_differences(const Space& space);
// {1, x, e^{+-jtx} : 0 < j < l}: since T_m(T_i(v)) = T_i(T_m(v)), the conditions sum_m 2 a_m T_i(x_m) = T_i(1), i < l,
// x_m = T_m(v), m = 1, 3, .., 2l-1, say that 2 a_m are the Lagrange polynomials of the x_m at 1:
//   a_m = 1/2 prod_{i != m} (1 - T_i(v))/(T_m(v) - T_i(v)).   nullopt for any other space.
std::optional<Laurent> interpolating_symbol_harmonic(const Space& space);
// The same a_1, a_3, .., a_{2l-1} with nothing multiplied out. Every factor is one of minimal polynomials, so a_m is an
// exponent count: O(l) integers for each m, no polynomial arithmetic.
struct CosineProduct {
  Rational content;
  // d -> exponent, not 0, d ascending: content prod Psi_d(v)^exponent, Psi_d = Polynomial::cosine_minimal(v, d).
  std::vector<std::pair<unsigned, long>> factors;
};
std::optional<std::vector<CosineProduct>> interpolating_coefficients_harmonic(const Space& space);
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
// The same with nothing multiplied out: 2n numbers, no polynomial arithmetic.
//   z^{-(2l-1)} zeta = 1 + sum_{j<n} f_j (w/p)^{2j+1} + kappa w (w^2 - p^2)^n,
//   kappa = 1/q sum_{k<n} g_k p^{-n-k} (p+q)^{k-n}.
struct TwoNodeSymbol {
  Polynomial p, q;
  std::vector<Rational> f, g;  // f_j = c (-1)^j C(n-1,j)/(2j+1), g_k = (-1)^n 2^{1-n-k} C(n-1+k,k)
};
std::optional<TwoNodeSymbol> interpolating_two_nodes_factored(const Space& space);

// Route 1. matrix * solution = rhs; omega(z) = sum_i solution[i] z^{n-1-i} prod_{j<i} (z^2 - gamma_j z + 1), n nodes:
// l, and l + 1 for an odd dimension.
struct HessenbergSystem {
  std::vector<Polynomial> nodes;  // gamma_0..gamma_{n-1}
  std::vector<std::vector<RationalFunction>>
      matrix;                              // row r < n-1: [gamma_i..gamma_{r+1}] S, i = 0..r+1; last (1,0,..)
  std::vector<RationalFunction> rhs;       // (0,..,0, w_0), w_0 = m/S(gamma_0)
  std::vector<RationalFunction> solution;  // w_0..w_{n-1}
  RationalFunction determinant;            // (-1)^{n-1} prod_{r>=1} S(gamma_r)
  Laurent omega;                           // centred on 0
};
HessenbergSystem hessenberg_system(const Space& space, int arity = 2);

// Route 2. Unknowns omega_0..omega_{n-1} (papers' indices; the last is the middle one). Row j = 1..n is the coefficient
// of z^{m(n-j)} in sigma omega, 0 and in the last row 1: with d = n-1-i the coefficient of omega_i is sigma_{m(n-j)-d}
// + sigma_{m(n-j)+d}, and sigma_{m(n-j)} for d = 0 (centred indices). When 1 is in V the last row is (2,..,2,1), the
// sum over all shifts of the rule.
struct FoldedSystem {
  std::vector<std::vector<RationalFunction>> matrix;
  std::vector<RationalFunction> rhs;
  bool hessenberg;  // no entry above the first superdiagonal
};
FoldedSystem folded_system(const Space& space, int arity = 2);
// A constant times prod_{i<=j} T_m[w_i, w_j] (binary: gamma_i + gamma_j; Orlando) over a power of the normalisation,
// and times prod_i D(w_i) for an odd dimension: the matrix maps W to a polynomial in T_m(w) whose values at the nodes
// are S(w_i) W(w_i)/m. The constant is read off at one rational point.
RationalFunction folded_determinant(const Space& space, const FoldedSystem& system, int arity = 2);
// Solves the system by fraction-free elimination and unfolds: omega centred on 0.
Laurent omega_from_folded(const FoldedSystem& system);

// Where a step of the interpolating scheme fails, T_m[w_i, w_j] = 0 for some pair of nodes, i = j included (binary: w_i
// + w_j = 0); where there is no such scheme, the normalisation sigma(1) = m. With one trigonometric variable, w_i =
// cos(a phi), w_j = cos(b phi): phi = 2 pi r/(m n), n = a + b or |a - b|, m not dividing r, so v^0 = cos(2 m^k r/n pi)
// at level k.
struct SingularSet {
  // v^0 = cos(angle*pi), 0 < angle < 1, at level k; sorted by v^0 ascending, then level. One trigonometric variable.
  struct Value {
    Rational angle;
    unsigned level;
    std::string exact() const;  // "-1/2", "cos(4*pi/5)"
    friend bool operator==(const Value&, const Value&) = default;
  };
  std::vector<Value> values;
  // With several frequencies: the factors that vanish somewhere on the domain (all level variables > cos(pi/m)).
  std::vector<Polynomial> conditions;
};
SingularSet singular_set(const Space& space, int arity = 2);
// Where on the domain T_m[w_a, w_b] vanishes for one of the pairs; binary: one of the sums w_a + w_b (a = b: 2 w_a).
SingularSet zeros_of_pairs(const Space& space, const std::vector<std::pair<Node, Node>>& pairs, int arity = 2);
// cos(angle*pi) as an expression: "0", "1/2", "-1/2" or "cos(4*pi/5)".
std::string cosine_text(const Rational& angle);

// Extension of coarse points from the space: p_{-1} = sum_{j=0}^{N-1} e_j p_j for samples of functions of V at spacing
// 1/m^k (the annihilator prod (y - e^{theta/m^k}), symmetric under y -> 1/y), N = dim V, as polynomials in the level
// variables of step k -> k+1. Reversed it extends the other end.
std::vector<Polynomial> extension_weights(const Space& space, int arity = 2);

}  // namespace twoscale
