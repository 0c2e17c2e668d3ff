// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Accounting of work and memory.
#include "twoscale/check/meter.hpp"

#include <algorithm>

namespace twoscale::check {

void Meter::spend(std::uint64_t units) {
  if (units > work_) throw Malformed("the certificate asks for more work than the limit of the checker");
  work_ -= units;
}

void Meter::hold(std::uint64_t bytes) {
  if (bytes > memory_) throw Malformed("the certificate asks for more memory than the limit of the checker");
  memory_ -= bytes;
}

Integer Meter::multiply(const Integer& a, const Integer& b) {
  spend(words(a) * words(b) / 2 + 10);
  return a * b;
}

Integer Meter::power(const Integer& base, std::uint64_t exponent) {
  Integer result = 1;
  Integer square = base;
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 == 1) result = multiply(result, square);
    if (exponent > 1) square = multiply(square, square);
  }
  return result;
}

Integer Meter::gcd(const Integer& a, const Integer& b) {
  if (words(a) < words(b)) return gcd(b, a);
  if (b == 0) return abs(a);
  spend(3 * words(a) * words(b) + 30);
  const Integer rest = a % b;
  if (rest == 0) return abs(b);
  spend(50 * words(b) * words(rest) + 100);
  return boost::multiprecision::gcd(b, rest);
}

}  // namespace twoscale::check
