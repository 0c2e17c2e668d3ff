// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. The theorems it trusts, stated in full.
#include "twoscale/check/theorems.hpp"

#include <algorithm>
#include <array>

namespace twoscale::check {
namespace {

constexpr std::array<Theorem, 8> list{{
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
     " are positive. The level variables are positive: v > cos(pi/m^{k+1}) >= 0 at the step k -> k+1."},
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
}};

}  // namespace

std::span<const Theorem> theorems() { return list; }

const Theorem& theorem(std::string_view key) {
  return *std::find_if(list.begin(), list.end(), [&](const Theorem& t) { return t.key == key; });
}

}  // namespace twoscale::check
