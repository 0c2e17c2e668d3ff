// SPDX-License-Identifier: GPL-3.0-or-later
// Non-uniform local interpolatory fundamental splines (NULIFS) and the subdivision rules sampled from them.
//
// Knots t_{2i} = x_i, t_{2i+1} = x_i + lambda_i d_i, d_i = x_{i+1} - x_i (nuli (2.12), (2.15)). N_{n,m} is the B-spline
// of order n with support [t_m, t_{m+n}]. v_{rho,mu,i} is a spline of order n with v_{rho,mu,i}(x_j) = delta_ij, and
// sum_i f(x_i) v_{rho,mu,i} = f for polynomials f of degree < rho (Chui and De Villiers 1996; nuli (2.1)-(2.7)).
//
// Corrections to the paper, each shown by tests/symbolic/nulifs_test.cpp:
//   (2.5)   the polynomial phi is the one of the points that the B-spline sees: phi_{i+floor(j/2), floor(j/2)}, not
//           phi_{i+j,j}; in (2.6), n >= 4, it is built with sigma in the place of mu, as its u_{rho,2sigma,i} is.
//   (2.10)  mu = (floor(3n/2) + rho - 4)/2, and (2.11) asks this for an integer: the printed outer floor is always one.
//   (2.17)  the rule acts on p_{i-mu+1+h}, not on p_i; it reads lambda_{i-mu+2} .. lambda_{i+mu-2} for n <= 5 only,
//           lambda_{i+3-n} .. lambda_{i+floor((3n-10)/2)} in general (sampled_scheme.hpp).
//
// Knots may coincide (lambda = 0 or 1): 0/0 in the recursions counts as 0, and the values are the limits wherever the
// interpolant has one. Intervals d are positive.
#pragma once

#include <vector>

#include "twoscale/symbolic/rational_function.hpp"

namespace twoscale {

// Which fundamental splines: order n, order rho of the polynomials reproduced, mu: the support begins at x_{i-mu}.
struct FundamentalFamily {
  unsigned order = 3;
  unsigned reproduction = 3;
  unsigned mu = 2;

  // The symmetric member with the largest rho <= n: (2.10), (2.11) as corrected above; support [x_{i-mu}, x_{i+mu}].
  // Required: 3 <= order <= 64.
  static FundamentalFamily symmetric(unsigned order);
  // Throws Error(bad_input) unless 3 <= n, 1 <= rho <= n and 1 <= mu <= max(n + rho - 3, floor(3n/2) + rho - 5).
  void validate() const;
  // The support is [x_{i-mu}, x_{i+right()}].
  long right() const;
};

// The knots x_0 = 0, x_i and auxiliary knots of the edges first_edge, first_edge + 1, ...; T is Rational or
// RationalFunction.
template <class T>
class Knots {
 public:
  // Required: d and lambda of the same size, first_edge <= 0 <= first_edge + size.
  Knots(long first_edge, std::vector<T> d, std::vector<T> lambda);
  const T& operator()(long m) const;  // t_m
  const T& x(long i) const { return (*this)(2 * i); }
  T middle(long edge) const;  // (x_i + x_{i+1})/2
  long first_vertex() const { return first_; }
  long last_vertex() const { return first_ + static_cast<long>(t_.size() - 1) / 2; }

 private:
  long first_;
  std::vector<T> t_;
};

// The values N_{n,m}(x), m = piece-n+1 .. piece, for t_piece <= x <= t_{piece+1}, t_piece < t_{piece+1}.
template <class T>
std::vector<T> bspline_values(const Knots<T>& t, unsigned order, const T& x, long piece);

// Values v_i(x), i = first_vertex .. last_vertex; x in [t_piece, t_{piece+1}] as above. Vertices beyond the knots given
// count as infinitely far: required is that the knots cover the mu + n vertices to the left and right of x.
template <class T>
std::vector<T> fundamental_values(const Knots<T>& t, const FundamentalFamily& family, const T& x, long piece);

// v_{rho,mu,i} = sum_m values[m - lowest] N_{n,m}; the m run over all B-splines that (2.4), (2.6), (2.7) name, so the
// values at both ends may vanish.
template <class T>
struct SplineCoefficients {
  long lowest = 0;
  std::vector<T> values;
};
// Required: the knots cover the mu + n vertices to the left and right of x_i.
template <class T>
SplineCoefficients<T> spline_coefficients(const Knots<T>& t, const FundamentalFamily& family, long i);

// The rule at the middle of the edge 0: p_{2i+1} = sum_h c_h p_{i-mu+1+h}, h = 0 .. mu + right - 1 (nuli (2.17)).
// Index 0 of d and lambda belongs to the edge `first_edge`; edges that are missing are filled up with d = 1, lambda =
// 1/2, on which the result does not depend. upper: the middle is taken as lying left of the auxiliary knot, i.e.
// lambda_0 >= 1/2 (nuli (3.6)), else lambda_0 <= 1/2 ((3.5)).
template <class T>
std::vector<T> sampled_rule(const FundamentalFamily& family, long first_edge, const std::vector<T>& d,
                            const std::vector<T>& lambda, bool upper);

// ---- The two rules in their simplest form, equal to the sampled ones (proved in the tests).
//
// 4-point, n = 3: with Q_L, Q_R the quadratic interpolants at x_{i-1}..x_{i+1} and x_i..x_{i+2},
//   p = w Q_L + (1 - w) Q_R,   w = lambda/(2 (1 - lambda)) for lambda <= 1/2, 1 - (1 - lambda)/(2 lambda) above.
// 6-point, n = 4: with C_L, C_M, C_R the cubic interpolants at x_{i-2}.., x_{i-1}.., x_i..,
//   p = w_L C_L + (1 - w_L - w_R) C_M + w_R C_R,   all at (x_i + x_{i+1})/2,
//   w_L = W(d_{i-1}, d_i, 1 - lambda_{i-1}, lambda_i),   w_R = W(d_{i+1}, d_i, lambda_{i+1}, 1 - lambda_i),
//   W(a, b, k, m) = a (a k + b) phi(m) / (3 (2a + b) (k m (a + b) + k a + m b)),
//   phi(m) = m^2/(1 - m) for m <= 1/2, (7 m^2 - 5 m + 1)/m above;   phi(0) = 0 also where k = 0.
// k d_{i-1}, m d_i: the distances of the auxiliary knots from x_i.
RationalFunction quadratic_blend(const RationalFunction& lambda, bool upper);  // w
RationalFunction auxiliary_factor(const RationalFunction& m, bool upper);      // phi
RationalFunction cubic_blend(const RationalFunction& a, const RationalFunction& b, const RationalFunction& k,
                             const RationalFunction& m, bool upper);  // W

}  // namespace twoscale
