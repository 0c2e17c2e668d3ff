// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. The one identity engine: coset sums of the mask, expanded in exponentials.
//   paper                                             here
//   z_n = exp(-theta_n/m^{k+1})                       product of E_i^{-n_i}
//   v_i = cosh(theta_i/m^{k+1})                       (E_i + 1/E_i)/2
//   E_i = Y_i^q, q the denominator of e = (m-1)p      so that z^{i-e} is a monomial in the Y_i
// After this substitution every statement is an identity of Laurent polynomials in the Y_i and the constants.
#pragma once

#include "twoscale/check/certificate.hpp"

#include <functional>
#include <optional>

namespace twoscale::check {

/// Sum over i = residue (mod m) of (scale*i - offset)^power * numerators_i * x^{shift(i)}.
Polynomial coset_sum(const std::vector<Polynomial>& numerators, long lowest, int arity, long residue, long power,
                     long scale, long offset, const std::function<Monomial(long)>& shift, Meter& meter);

/// Do the sums of i^power * numerators_i over i = s (mod m) agree for all s?
bool sum_rule_holds(const std::vector<Polynomial>& numerators, long lowest, int arity, long power, Meter& meter);

class Identities {
 public:
  Identities(const Certificate& certificate, Meter& meter) : certificate_(certificate), meter_(meter) {}

  /// Sum over i = s of i^power a_i z^i does not depend on s.
  bool generated(const std::vector<long>& frequency, long power);
  /// Sum over i = s of (i-e)^power a_i z^{i-e} = [power = 0] for every s.
  bool reproduced(const std::vector<long>& frequency, long power);
  /// a(z) vanishes identically.
  bool symbol_vanishes(const std::vector<long>& frequency);

  /// Mask and denominator with every level variable set to 1 (all E_i = 1).
  const Mask& limit_mask();
  /// The limit mask reproduces x^power: sum over i = s of (i-e)^power a_i = [power = 0].
  bool limit_reproduced(long power);

 private:
  void expand();
  Polynomial exponential_sum(const std::vector<long>& frequency, long power, long residue, bool centred);

  const Certificate& certificate_;
  Meter& meter_;
  std::optional<Mask> expanded_;
  std::optional<Mask> limit_;
};

}  // namespace twoscale::check
