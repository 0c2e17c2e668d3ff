// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Minimal polynomials of cosines of rational multiples of pi.
#include "twoscale/check/cyclotomic.hpp"

namespace twoscale::check {
namespace {

std::vector<std::uint64_t> prime_divisors(std::uint64_t n) {
  std::vector<std::uint64_t> primes;
  for (std::uint64_t p = 2; p * p <= n; ++p) {
    if (n % p != 0) continue;
    primes.push_back(p);
    while (n % p == 0) n /= p;
  }
  if (n > 1) primes.push_back(n);
  return primes;
}

}  // namespace

std::uint64_t euler_phi(std::uint64_t n) {
  std::uint64_t result = n;
  for (const std::uint64_t p : prime_divisors(n)) result = result / p * (p - 1);
  return result;
}

std::vector<Integer> cyclotomic_head(std::uint64_t n, std::size_t count, Meter& meter) {
  // Phi_n(x) = product over squarefree d | n of (1 - x^{n/d})^{mu(d)} (n >= 2), as a power series.
  std::vector<Integer> series(count);
  if (count > 0) series[0] = 1;
  const std::vector<std::uint64_t> primes = prime_divisors(n);
  for (std::uint64_t subset = 0; subset < (std::uint64_t{1} << primes.size()); ++subset) {
    std::uint64_t step = n;
    bool multiply = true;
    for (std::size_t i = 0; i < primes.size(); ++i) {
      if ((subset >> i) % 2 == 0) continue;
      step /= primes[i];
      multiply = !multiply;
    }
    if (step >= count) continue;
    meter.spend(20 * count);
    if (multiply) {
      for (std::size_t i = count; i-- > step;) series[i] -= series[i - step];
    } else {
      for (std::size_t i = step; i < count; ++i) series[i] += series[i - step];
    }
  }
  return series;
}

Dense cosine_polynomial(std::uint64_t n, Meter& meter) {
  // Phi_n is palindromic of degree 2h: E^{-h} Phi_n(E) = c_h + sum_{j=1}^h c_{h-j} C_j(x), x = E + 1/E = 2v,
  // C_1 = x, C_2 = x^2 - 2, C_{j+1} = x C_j - C_{j-1}; C_0 := 1 here, the middle coefficient.
  const std::size_t h = euler_phi(n) / 2;
  const std::vector<Integer> c = cyclotomic_head(n, h + 1, meter);
  Dense sum(h + 1), before(h + 1), now(h + 1);
  sum[0] = c[h];
  before[0] = 2;
  now[h == 0 ? 0 : 1] = 1;
  for (std::size_t j = 1; j <= h; ++j) {
    meter.spend(60 * (j + 1));
    if (c[h - j] != 0) {
      for (std::size_t i = 0; i <= j; ++i) sum[i] += meter.multiply(c[h - j], now[i]);
    }
    if (j == h) break;
    for (std::size_t i = 0; i <= j; ++i) before[i] = -before[i];
    for (std::size_t i = 0; i <= j; ++i) before[i + 1] += now[i];
    before.swap(now);
  }
  for (std::size_t i = 0; i <= h; ++i) {
    meter.spend(i / 64 + 10);
    sum[i] <<= i;  // x = 2v
  }
  return primitive(std::move(sum), meter);
}

int divide_out_cosine(Dense& p, std::uint64_t n, Meter& meter) {
  meter.spend(1000);  // euler_phi for n <= 10^6
  if (euler_phi(n) / 2 + 1 > p.size()) return 0;
  const Dense g = cosine_polynomial(n, meter);
  int times = 0;
  while (auto next = quotient(p, g, meter)) {
    p = std::move(*next);
    ++times;
  }
  return times;
}

bool cosine_divides(const Dense& p, std::uint64_t n, Meter& meter) {
  meter.spend(1000);
  if (p.empty()) return true;
  return euler_phi(n) / 2 + 1 <= p.size() && quotient(p, cosine_polynomial(n, meter), meter).has_value();
}

}  // namespace twoscale::check
