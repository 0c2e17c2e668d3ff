// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Minimal polynomials of cosines of rational multiples of pi.
#pragma once

#include "twoscale/check/meter.hpp"
#include "twoscale/check/univariate.hpp"

#include <cstdint>

namespace twoscale::check {

/// Euler's function, n >= 1, by trial division (n up to about 10^12).
std::uint64_t euler_phi(std::uint64_t n);

/// First `count` coefficients, from the constant term, of the cyclotomic polynomial Phi_n, n >= 2.
std::vector<Integer> cyclotomic_head(std::uint64_t n, std::size_t count, Meter& meter);

/// The primitive integer polynomial in v, irreducible over Q, whose zeros are cos(2 pi j/n), gcd(j, n) = 1; n >= 3. It
/// has degree phi(n)/2 and divides P(v) exactly when Phi_n(E) divides E^deg P((E + 1/E)/2).
Dense cosine_polynomial(std::uint64_t n, Meter& meter);

/// Divides P by cosine_polynomial(n) as often as possible and says how often. P not zero.
int divide_out_cosine(Dense& p, std::uint64_t n, Meter& meter);

/// Does cosine_polynomial(n) divide p?
bool cosine_divides(const Dense& p, std::uint64_t n, Meter& meter);

}  // namespace twoscale::check
