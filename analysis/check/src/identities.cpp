// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Coset sums of the mask as Laurent polynomials.
#include "twoscale/check/identities.hpp"

#include <algorithm>
#include <cstdlib>

namespace twoscale::check {
namespace {

long remainder(long i, long m) { return ((i % m) + m) % m; }

/// v^d -> 2^{top-d} (Y^q + Y^{-q})^d, in every term; that is 2^top times the substitution v = (Y^q + Y^{-q})/2.
Polynomial substitute(const Polynomial& p, std::size_t variable, int top, int q, Meter& meter) {
  Polynomial result;
  for (const auto& [monomial, coefficient] : p) {
    const int d = monomial[variable];
    meter.spend(words(coefficient) + static_cast<std::uint64_t>(top));
    Integer amount = coefficient << static_cast<unsigned>(top - d);
    for (int k = 0; k <= d; ++k) {  // amount = 2^{top-d} binomial(d, k) coefficient
      Monomial key = monomial;
      key[variable] = q * (d - 2 * k);
      add_term(result, key, amount, meter);
      meter.spend(8 * words(amount) + 50);
      amount = amount * (d - k) / (k + 1);
    }
  }
  return result;
}

void hold(const Polynomial& p, Meter& meter) {
  for (const auto& [monomial, coefficient] : p) meter.hold(128 + 8 * words(coefficient));
}

}  // namespace

Polynomial coset_sum(const std::vector<Polynomial>& numerators, long lowest, int arity, long residue, long power,
                     long scale, long offset, const std::function<Monomial(long)>& shift, Meter& meter) {
  Polynomial sum;
  const long length = static_cast<long>(numerators.size());
  for (long at = remainder(residue - lowest, arity); at < length; at += arity) {
    const long i = lowest + at;
    const Integer weight = meter.power(Integer(scale) * i - offset, static_cast<std::uint64_t>(power));
    add_scaled(sum, numerators[static_cast<std::size_t>(at)], weight, shift(i), meter);
  }
  return sum;
}

bool sum_rule_holds(const std::vector<Polynomial>& numerators, long lowest, int arity, long power, Meter& meter) {
  const auto no_shift = [](long) { return Monomial{}; };
  const auto sum = [&](long s) { return coset_sum(numerators, lowest, arity, s, power, 1, 0, no_shift, meter); };
  const Polynomial first = sum(0);
  for (long s = 1; s < arity; ++s) {
    if (sum(s) != first) return false;
  }
  return true;
}

void Identities::expand() {
  if (expanded_) return;
  const Mask& mask = certificate_.mask;
  const int q = static_cast<int>(certificate_.e.denominator);
  const auto expanded = [&](Polynomial p) {
    for (const std::size_t j : certificate_.level) p = substitute(p, j, mask.top[j], q, meter_);
    hold(p, meter_);
    return p;
  };
  Mask result;
  result.lowest = mask.lowest;
  for (const Polynomial& n : mask.numerators) result.numerators.push_back(expanded(n));
  result.denominator = expanded(mask.denominator);
  expanded_ = std::move(result);
}

Polynomial Identities::exponential_sum(const std::vector<long>& frequency, long power, long residue, bool centred) {
  expand();
  const long q = certificate_.e.denominator;
  const long a = centred ? certificate_.e.numerator : 0;
  const auto shift = [&](long i) {  // z^{i - a/q} = product of Y_j^{-n_j (q i - a)}
    Monomial monomial{};
    for (std::size_t j = 0; j < frequency.size(); ++j) {
      const long exponent = -frequency[j] * (q * i - a);  // |.| <= 10^6 (10^9 + 63*10^6)
      if (std::labs(exponent) > 100'000'000) throw Malformed("frequencies or indices too large for the checker");
      monomial[certificate_.level[j]] = static_cast<int>(exponent);
    }
    return monomial;
  };
  // For power 0 the scale of i - a/q does not matter; for power > 0 the right-hand side is 0 (or the other residue).
  return coset_sum(expanded_->numerators, expanded_->lowest, certificate_.arity, residue, power, centred ? q : 1, a,
                   shift, meter_);
}

bool Identities::generated(const std::vector<long>& frequency, long power) {
  const Polynomial first = exponential_sum(frequency, power, 0, false);
  for (long s = 1; s < certificate_.arity; ++s) {
    if (exponential_sum(frequency, power, s, false) != first) return false;
  }
  return true;
}

bool Identities::reproduced(const std::vector<long>& frequency, long power) {
  expand();
  for (long s = 0; s < certificate_.arity; ++s) {
    const Polynomial sum = exponential_sum(frequency, power, s, true);
    if (power == 0 ? sum != expanded_->denominator : !sum.empty()) return false;
  }
  return true;
}

bool Identities::symbol_vanishes(const std::vector<long>& frequency) {
  Polynomial total;
  for (long s = 0; s < certificate_.arity; ++s) {
    add_scaled(total, exponential_sum(frequency, 0, s, false), 1, {}, meter_);
  }
  return total.empty();
}

const Mask& Identities::limit_mask() {
  if (!limit_) {
    const Mask& mask = certificate_.mask;
    Mask limit;
    limit.lowest = mask.lowest;
    for (const Polynomial& n : mask.numerators) limit.numerators.push_back(at_one(n, certificate_.limits, meter_));
    limit.denominator = at_one(mask.denominator, certificate_.limits, meter_);
    limit_ = std::move(limit);
  }
  return *limit_;
}

bool Identities::limit_reproduced(long power) {
  const Mask& mask = limit_mask();
  const auto no_shift = [](long) { return Monomial{}; };
  for (long s = 0; s < certificate_.arity; ++s) {
    const Polynomial sum = coset_sum(mask.numerators, mask.lowest, certificate_.arity, s, power,
                                     certificate_.e.denominator, certificate_.e.numerator, no_shift, meter_);
    if (power == 0 ? sum != mask.denominator : !sum.empty()) return false;
  }
  return true;
}

}  // namespace twoscale::check
