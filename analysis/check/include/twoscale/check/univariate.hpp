// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Dense polynomials in one variable: division, real zeros beyond a point.
#pragma once

#include "twoscale/check/meter.hpp"
#include "twoscale/check/number.hpp"
#include "twoscale/check/polynomial.hpp"

#include <optional>
#include <vector>

namespace twoscale::check {

/// Coefficients from the constant term up; the last one is not zero; the zero polynomial is empty.
using Dense = std::vector<Integer>;

/// Accounts for the memory that p keeps.
void hold(const Dense& p, Meter& meter);

/// p as a polynomial in the variable with index 0, the only one that occurs.
Dense dense(const Polynomial& p);

/// p/g over Z if g (not zero) divides p.
std::optional<Dense> quotient(const Dense& p, const Dense& g, Meter& meter);

/// target += p*q.
void add_product(Dense& target, const Dense& p, const Dense& q, Meter& meter);
Dense multiply(const Dense& p, const Dense& q, Meter& meter);
Dense negated(Dense p);

/// p divided by its positive content.
Dense primitive(Dense p, Meter& meter);

/// Number of sign changes in the coefficients of p(x + a/b), b > 0. By Descartes' rule p has at most so many zeros >
/// a/b, so none if it is 0.
int variations_beyond(const Dense& p, const Integer& a, const Integer& b, Meter& meter);

/// Sturm's chain p, p', -rem(...), ... up to positive factors; p not zero, repeated zeros allowed.
class SturmChain {
 public:
  SturmChain(const Dense& p, Meter& meter);
  /// Number of distinct zeros of p in (a/b, infinity); b > 0; p(a/b) is not 0.
  int zeros_beyond(const Integer& a, const Integer& b, Meter& meter) const;
  /// gcd(p, p') up to a constant.
  const Dense& last() const { return chain_.back(); }

 private:
  std::vector<Dense> chain_;
};

/// Greatest common divisor, primitive with positive leading coefficient; not both zero.
Dense gcd(const Dense& p, const Dense& q, Meter& meter);

/// The primitive polynomial with the zeros of p (not zero), each of them simple.
Dense squarefree(const Dense& p, Meter& meter);

/// The same with the zeros of odd multiplicity only.
Dense odd_part(const Dense& p, Meter& meter);

/// Number of distinct zeros of p (not zero) in [low, high], low <= high; in [low, infinity); in (low, high).
int zeros_within(const Dense& p, const Fraction& low, const Fraction& high, Meter& meter);
int zeros_from(const Dense& p, const Fraction& low, Meter& meter);
int zeros_between(const Dense& p, const Fraction& low, const Fraction& high, Meter& meter);

/// Is p > 0, is p >= 0 in the whole open interval (low, high), low < high?
bool is_positive_between(const Dense& p, const Fraction& low, const Fraction& high, Meter& meter);
bool is_nonnegative_between(const Dense& p, const Fraction& low, const Fraction& high, Meter& meter);

/// (low + high)/2.
Fraction middle_of(const Fraction& low, const Fraction& high, Meter& meter);

/// Do all complex zeros of p (not zero) lie in |x| < 1? Schur and Cohn: a polynomial p of degree d >= 1 has this
/// property if and only if |p_0| < |p_d| and (p_d p(x) - p_0 x^d p(1/x))/x has it.
bool is_schur_stable(Dense p, Meter& meter);

/// sum_{k=-h}^{h} g_{|k|} z^k for z = exp(i t), as a polynomial in cos(t): g_0 + 2 sum_{k>0} g_k T_k.
Dense cosine_sum(const std::vector<Integer>& g, Meter& meter);

/// Sign of p(a/b), b > 0.
int sign_at(const Dense& p, const Integer& a, const Integer& b, Meter& meter);

/// Sign of p(cos(pi/m)), m >= 2.
int sign_at_cos(const Dense& p, int m, Meter& meter);

/// Decides whether p (not zero) has a real zero in the open interval (cos(pi/m), infinity), m >= 2.
bool has_zero_beyond_cos(const Dense& p, int m, Meter& meter);

}  // namespace twoscale::check
