// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. The theorems it trusts, stated in full.
#include "twoscale/check/theorems.hpp"

#include <algorithm>
#include <array>

namespace twoscale::check {
namespace {

constexpr std::array<Theorem, 17> list{{
    {"definition", "nothing beyond the definition",
     "The property is, by definition, the identity that was verified (interpolatory: a_{mj} = 1 for j = 0, else 0; "
     "symmetric about c: a_{2c-i} = a_i; sum rules of order N: for r < N the sums of i^r a_i over i = s mod m do not "
     "depend on s). An identity between rational functions is refuted by one point where it fails, an inequality "
     "by one value."},
    {"generation-stepwise", "Conti-Romani 2011 (binary); Conti-Hormann 2011 (any arity, polynomials)",
     "Let z = exp(-theta/m^{k+1}). The sums of i^r a_i z^i over i = s mod m do not depend on s for every r < mu if "
     "and only if a(x) = sum a_i x^i vanishes to order mu at x = eps*z for every eps with eps^m = 1, eps != 1. Then "
     "the step k -> k+1 maps the span of j^r exp(theta*j/m^k), r < mu, into the span of i^r exp(theta*i/m^{k+1}), r <"
     " mu, and onto it exactly if a(z) != 0. If the scheme converges, its masks are bounded and the product over k of"
     " a(z)/m converges to a number != 0, then all functions x^r exp(theta*x), r < mu, are limits of the scheme."},
    {"reproduction-stepwise", "Conti-Romani 2011; Dyn-Levin-Luzzatto 2003",
     "Let z = exp(-theta/m^{k+1}), e = (m-1)p. The sums of (i-e)^r a_i z^{i-e} over i = s mod m are 1 for r = 0 and 0"
     " for 0 < r < mu, for every s, if and only if the step k -> k+1 maps the values of x^r exp(theta*x), r < mu, at "
     "(j+p)/m^k to their values at (i+p)/m^{k+1}. If this holds at every level, the scheme maps the samples at level "
     "0 to the samples at every level, and the function itself is the limit of these data."},
    {"hurwitz-count", "Hurwitz's theorem on zeros of convergent analytic functions",
     "The level variables tend to 1 as k grows, so the masks tend to the limit mask (all level variables 1, "
     "denominator not 0 there). If a space of exponential polynomials of dimension D is generated stepwise at all "
     "levels from some level on, then for every eps with eps^m = 1, eps != 1, D zeros of the symbol of level k, with "
     "multiplicity, tend to eps; by Hurwitz the limit symbol, if it is not 0, vanishes there to order D at least: the"
     " limit mask has sum rules of order D. So if it has sum rules of order exactly N, and V of dimension N is "
     "generated, then nothing outside V is generated stepwise, whenever the frequencies of V are distinct numbers. "
     "What is reproduced stepwise is generated; inside V an identity that fails as an identity fails at each level "
     "for all but finitely many v. With several variables or constants: outside the zeros of some polynomial that is "
     "not 0."},
    {"sturm", "Descartes' rule of signs; Sturm's theorem; irreducibility of cyclotomic polynomials (Gauss)",
     "A real polynomial P has no zero > a if the coefficients of P(x+a) have no change of sign; it has exactly V(a) -"
     " V(infinity) distinct zeros > a if P(a) != 0, V counting the changes of sign in Sturm's chain of P. A rational "
     "polynomial in v = cos(alpha*pi), alpha rational, vanishes there exactly if the minimal polynomial of that "
     "number divides it, which comes from the cyclotomic polynomial of the order of exp(i*alpha*pi)."},
    {"positive-coefficients", "elementary",
     "A polynomial that is not 0 and has no negative (or no positive) coefficient has no zero where all its variables"
     " are positive. The level variables are positive, v > cos(pi/m^{k+1}) >= cos(pi/m) >= 0 at the step k -> k+1, and "
     "so are v - cos(pi/m), in which the polynomial is written for arities m > 2."},
    {"bernstein", "elementary; Bernstein's basis is nonnegative",
     "Put x = (low*u + high*t)/(u + t), on a half-line x = low + t/u, for each variable, with u, t >= 0, and clear "
     "u + t or u. If the form in the pairs (u, t) has no negative coefficient, the polynomial is not negative on the "
     "box. It is positive inside a face of the box, of any dimension, if some coefficient is positive among those that "
     "belong to t^0 in the variables that are low there, and to u^0 in those that are high. A box is the union of the "
     "leaves of a tree of bisections. The coefficients of a multi-affine polynomial are its values at the vertices."},
    {"schur-cohn",
     "Schur 1917; Cohn 1922; Jury 1964; Lienard-Chipart 1914 (Gantmacher, The Theory of Matrices, ch. XV)",
     "The n roots of a(x) = a_0 + ... + a_n x^n, real, a_n != 0, n > 0, lie in |x| < 1 if and only if |a_0| < |a_n| and"
     " those of (a_n a(x) - a_0 x^n a(1/x))/x, of degree n-1, do. For a_n > 0 this means: n = 1: a_1 > |a_0|; n = 2: "
     "a_2 > a_0, a_2 + a_0 > |a_1|; n = 3: a(1) > 0, a(-1) < 0, a_3 > |a_0|, a_3^2 - a_0^2 > |a_3 a_1 - a_2 a_0|. With "
     "x = (u+1)/(u-1) they lie in Re u < 0; for a(1) > 0 this holds if and only if all coefficients of (u-1)^n a(x) as "
     "a polynomial in u and its Hurwitz determinants of orders n-1, n-3, ... are positive."},
    {"spectral-radius", "Rota-Strang 1960; Heil-Strang 1995 (continuity); Schur 1917, Cohn 1922",
     "The joint spectral radius JSR of finitely many square matrices B_s is the limit of max |B_w|^{1/n} over the "
     "products B_w of n of them; it does not depend on the norm. The spectral radius of each product of n of them is "
     "at most JSR^n. A real polynomial p of degree d >= 1 has all its complex zeros in |x| < 1 if and only if |p_0| < "
     "|p_d| and (p_d p(x) - p_0 x^d p(1/x))/x has. If det(t - P) <= 0 for a real matrix P and t > 0, then P has a real "
     "eigenvalue >= t. The JSR is a continuous function of the matrices. If JSR belongs to the remainder c of a(z) = "
     "m^{-N} (1+...+z^{m-1})^N c(z), a(1) = m, then the largest N-th divided "
     "difference of the data at level k grows like JSR^k; so the Hoelder exponent of the basic limit function, if its "
     "integer shifts are stable, is at most N - log_m(JSR), where N is the exact order of the sum rules."},
    {"invariant-polytope",
     "Rota-Strang 1960; Guglielmi-Protasov 2013; Charina-Conti-Guglielmi-Protasov 2017; Heil-Strang 1995 (continuity)",
     "If finitely many points span R^d and the matrices B_s/R map each of them into the absolutely convex hull of all "
     "of them, then this hull is the unit ball of a norm in which all B_s/R have norm at most 1: JSR <= R, and "
     "products of the B_s/R are bounded. The JSR of block triangular matrices is the largest JSR of a diagonal block; "
     "if only one block attains it, and products of that block, divided by powers of it, are bounded, then so are the "
     "products of the matrices. The JSR of a set of matrices is that of its convex hull. It is a "
     "continuous function of the matrices: what is known for all but finitely many values of a parameter on which they "
     "depend continuously holds for all. If the B_s belong to the "
     "remainder c of a(z) = m^{-N} (1+...+z^{m-1})^N c(z), a(1) = m, then a subdivision scheme with the mask a and "
     "JSR < m^N converges uniformly, and the Hoelder exponent of all its limits is at least N - log_m(JSR), the "
     "exponent being the supremum of k + h such that the k-th derivative is Hoelder continuous of the order h; if the "
     "integer shifts of the basic limit function are stable, that of this function is N - log_m(JSR), where N is the "
     "exact order of the sum rules."},
    {"nonnegative-symbol", "Dubuc 1986; Deslauriers-Dubuc 1989; Rioul 1992; Villemoes 1994 (autocorrelation)",
     "Let g(z) = sum over |k| <= h of g_k z^k, g_{-k} = g_k, be non-negative on |z| = 1, and g^{(k)}(z) the product of"
     " g(z^{m^i}), i < k. Then g^{(k)} has no coefficient larger in absolute value than its coefficient at z^0, which "
     "is (M^k)_{00} for the matrix M_{ij} = g_{i-mj} + (j > 0 ? g_{i+mj} : 0), 0 <= i, j <= max(0, h-1)/(m-1) rounded "
     "down. So the k-th root of the largest coefficient tends to the spectral radius of M on the span of e_0, M e_0, "
     "..., and this is the largest real zero rho of the minimal polynomial of e_0 (Pringsheim). If g(z) = z^{-h} c(z),"
     " c the remainder of a(z) = m^{-N} (1+...+z^{m-1})^N c(z), a(1) = m, then rho is the joint spectral radius that "
     "belongs to c: if rho < m^N, the scheme converges and the Hoelder exponent of its limits is at least N - "
     "log_m(rho), with equality for the basic limit function if its integer shifts are stable and N is the exact "
     "order of the sum rules. So rho is a continuous function of c, and an eigenvalue of M: where no eigenvalue of M "
     "reaches a number, rho stays on one side of it. If g(z) = c(z) c(1/z), then the basic limit function lies in the "
     "Sobolev spaces of all "
     "orders less than N - log_m(rho/m)/2, and in none of larger order if its integer shifts are stable."},
    {"jia-wang", "Jia-Wang 1993 (m = 2; the argument is the same for any m); Jia-Micchelli 1991",
     "Let a(1) = m and phi be the basic limit function, whose Fourier transform at t is the product over k >= 1 of "
     "a(exp(-i t/m^k))/m. Its integer shifts are stable, that is, for no real t the transform vanishes at t + 2 pi k "
     "for all integers k (for phi in L_p, this is stability in L_p), if and only if (i) the sub-symbols sum over j of "
     "a_{mj+s} z^j, s = 0..m-1, have no common zero with |z| = 1, and (ii) there is no n > 1 prime to m such that for "
     "the primitive n-th roots of unity w all sums over i = s mod m of a_i w^i, s = 0..m-1, are equal; equivalently, "
     "the n-th cyclotomic polynomial, irreducible over Q, divides their differences. Its degree is at least "
     "sqrt(n/2)."},
    {"nonstationary", "Dyn-Levin 1995; Charina-Conti-Guglielmi-Protasov 2017",
     "Let masks of bounded support depend on the level through v^k only, with no constants, v^k - 1 = O(m^{-2k}) by "
     "T_m(v^{k+1}) = v^k, and through variables of scope sequence, whose distances to 1 have a finite sum over the "
     "levels. If the mask is continuous at the limit (all these are 1), the masks of the levels tend to the "
     "limit mask a so fast that |a^{[k]}(1) - m| is summable, where a(1) = m. Exact generation of N exponential "
     "polynomials makes the derivatives of order r < N of the symbol of level k at eps (eps^m = 1, eps != 1) "
     "O(m^{-k(N-r)}): the approximate sum rules of order N. If a has sum rules of order N and its remainder the joint "
     "spectral radius JSR < m^{N-l}, l >= 0, then the level-dependent scheme converges, from every level on and for "
     "every v^0 > -1 for which no step has a pole, and its limits are C^l with a Hoelder exponent of at least N - "
     "log_m(JSR)."},
    {"hermite-interpolation", "Hermite; a polynomial of degree < 2n is given by n data at each of two points",
     "Where B is not 0, the functions x^j/B^q, j < 2n, are determined by their values and first n-1 derivatives at two "
     "points, and these can be prescribed: they are those of N/B^q, N a polynomial of degree < 2n. So a linear rule "
     "that maps the data of these 2n functions at two points to their data at a third one is the evaluation of this "
     "interpolant there, and a curve N/B^q in Bezier form is known from its data at the ends. If C^2 + S^2 = B^{2q} "
     "and the degrees allow it, (C, S)/B^q is an arc of a circle that is its own interpolant."},
    {"hermite-halves", "elementary; reports/hermite2010/tension.md (Lemmas 1 to 3 and what follows from them)",
     "Let every step evaluate the interpolant of the data of the ends, p_i being k^i times the i-th derivative in x, k "
     "> 0, on an interval in x, at its middle, sigma = 4 atan(x). If the intervals of the two halves of an edge are "
     "the halves of its interval, the interpolants of the halves are that of the edge: it is the limit, so all edges "
     "together are a curve in C^d, d the number of derivatives, with c^{(i)} = p_i/k^i at the vertices. If not, let "
     "d = 2, 1 and x be among the functions, and H = l (1 + e l + O(l^2)) the length of the interval of a half, l that "
     "of the half of the interval, in "
     "x, e = e_L for the left and e_R for the right half, continuous functions of the parameter; the steps tend to 0 "
     "like 2^{-n}, and the intervals stay where B and the denominators are not 0. The interpolant read on an interval "
     "of length l (1 + e l) in place of l has its second derivative changed by -e c' B''(y) + O(l), B(y) = 10 y^3 - "
     "15 y^4 + 6 y^5, y from 0 to 1. Then the limit is C^1 in x; p_2 has one-sided limits along the neighbours of a "
     "vertex, and the right one minus the left one is -k (120/7)(e_L + e_R) p_1; along alternating halves p_2 changes "
     "in two steps by k (40/9)(e_L - e_R) p_1 up to a summable error. Where the jump is not 0 the limit is not C^2, in "
     "x or in "
     "any regular C^2 parameter; but (p_1 x p_2)/|p_1|^3 converges uniformly to the curvature of the limit, which is "
     "continuous where p_1 != 0, and at the vertices is that of their data."},
    {"compact-support", "Cavaretta-Dahmen-Micchelli 1991",
     "If the points -l..h are the only ones that are not 0, a step leaves at most the points -(2 l + 2 b - 1)..2 h + 1 "
     "- "
     "2 a, where the rule reads p_{i+a}, ..., p_{i+b} in the edge i. So after k steps the data 1 at x_0 end at (2^k - "
     "1)(1 - 2 b) and (2^k - 1)(1 - 2 a), within the knots x_{1-2b} and x_{1-2a}. The basic limit function of a mask "
     "a_l, ..., a_h, a_l and a_h not 0, that converges vanishes identically neither beside l nor beside h."},
    {"piecewise-uniform", "Warren 1995; Dyn-Gregory-Levin 1995; the argument in full in docs/nonuniform.md",
     "A scheme keeps the points and reads finitely many neighbours; intervals are halved at every step, and edge "
     "parameters at rest are those of all edges but the two at a vertex of the data. Between the vertices it is "
     "the scheme on equal knots from some level on, at a vertex one matrix M acts at all levels. Let the mask on equal "
     "knots have sum rules of order N and a remainder of joint spectral radius less than 2^{N-l}, the scheme reproduce "
     "polynomials of degree at most l on all knots, and all eigenvalues of M but the simple 1, 1/2, ..., 2^-l be "
     "smaller than 2^-l in modulus. Then it converges uniformly and its limits are C^l there."},
}};

}  // namespace

std::span<const Theorem> theorems() { return list; }

const Theorem& theorem(std::string_view key) {
  return *std::find_if(list.begin(), list.end(), [&](const Theorem& t) { return t.key == key; });
}

}  // namespace twoscale::check
