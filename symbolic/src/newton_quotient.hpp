// SPDX-License-Identifier: GPL-3.0-or-later
// Hermite interpolation of F/P in the Newton basis, with denominators known in advance: the engine of omega
// (interpolatory.hpp) and of the quasi-splines (quasi_spline.hpp).
//
//   P(x) = prod_j f_j(x)                 the symbol of an exponential B-spline in x = z + 1/z, without its constant;
//   binary:
//                                        f_j = x + gamma_j
//   g_0..g_{M-1}                         nodes; the interpolation conditions at equal ones are on derivatives
//   q(x) = sum_m w_m prod_{i<m} (x - g_i)  with  P q = F  modulo  prod_i (x - g_i)
// Taking divided differences of both sides (Leibniz) gives a lower triangular system:
//   sum_{m<=r} [g_m..g_r]P w_m = [g_0..g_r]F,   r = 0..M-1,   determinant prod_r P(g_r).
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "twoscale/symbolic/polynomial.hpp"
#include "twoscale/symbolic/space.hpp"
#include "twoscale/symbolic/symbol.hpp"

namespace twoscale {

// [g_0..g_m]F = numerator[m] / (scale E_m), E_m = prod_{i<=m} ratio[i].
struct NewtonData {
  std::vector<Polynomial> numerator;
  std::vector<Polynomial> ratio;
  Rational scale = 1;
};
// F = 1.
NewtonData constant_data(size_t count);
// F = u^{-1/2}, x = 4u - 2, at x_i = 4 h_i^2 - 2 with value 1/h_i: ratio[m] = h_m prod_{i<m} (h_i + h_m). Equal nodes
// must be adjacent. With x = z + 1/z this is F = 2/(z^{1/2} + z^{-1/2}), h = cosh of the half argument.
NewtonData inverse_root_data(const std::vector<Node>& nodes, const std::vector<Polynomial>& h);

// P by its coefficients, from the constant term, and the values of its factors at the nodes: at[i][j] = f_j(g_i).
struct Product {
  std::vector<Polynomial> coefficients;
  std::vector<std::vector<Polynomial>> at;
};
// prod_j (x + gamma_j).
Product linear_product(const std::vector<Polynomial>& nodes, const std::vector<Polynomial>& gamma);

struct NewtonQuotient {
  std::vector<std::vector<Polynomial>> difference;  // [m][r], m <= r: [g_m..g_r]P
  // w_m = numerator[m] / (scale D_m E_m), D_m = prod_{i<=m} tail[i]; scale and E_m those of F.
  std::vector<Polynomial> numerator;
  // tail[i] = prod f_j(g_i) over the j that are no partner of an earlier node.
  std::vector<Polynomial> tail;
};
// partner[i]: the factor j that stands for node i (gamma_j = g_i), each at most once; nullopt where there is none.
// Required: f_j(g_i) is the same with both exchanged for two nodes with partners. It then divides D only once, which is
// all that [..](1/P) has. Binary: it is a sum over chains 0 = i_0 <= i_1 <= .. of prod_j 1/prod_{i_{j-1} <= i <= i_j}
// (g_i + gamma_j), and the factors j taken in the order of their partners never meet both (i, j) and (j, i). Any arity,
// all nodes with partners: [g_0..g_m](1/P) = sum_i 1/(prod_j f_j(g_i) prod_{j != i} (g_i - g_j)), where every pair
// occurs at most once in a term, and the differences g_i - g_j cancel because the sum is a polynomial in them.
NewtonQuotient newton_quotient(const std::vector<Polynomial>& nodes, const Product& p,
                               const std::vector<std::optional<size_t>>& partner, const NewtonData& data);

// The coefficients of z^{-d}..z^d, d = M-1, of sum_m numerator[m] (prod_{i>m} ratio[i]) prod_{i<m} (z - g_i + 1/z).
std::vector<Polynomial> newton_expansion(const std::vector<Polynomial>& nodes, const std::vector<Polynomial>& numerator,
                                         const std::vector<Polynomial>& ratio);

// Sums w_i + w_j of nodes, factored and expanded once.
class NodeSums {
 public:
  explicit NodeSums(const Space& space) : space_(space) {}
  const FactoredPolynomial& operator()(Node a, Node b);

 private:
  using Label = std::pair<size_t, unsigned>;
  const Space& space_;
  std::map<std::pair<Label, Label>, FactoredPolynomial> factored_;
};

}  // namespace twoscale
