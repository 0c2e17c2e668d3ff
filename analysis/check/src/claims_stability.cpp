// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Claim `stability`: the integer shifts of the basic limit function.
//   a_s(z) = sum a_{mj+s} z^j, A_s(z) = sum over i = s mod m of a_i z^i, s = 0..m-1
#include "twoscale/check/claims.hpp"
#include "twoscale/check/cyclotomic.hpp"
#include "twoscale/check/remainder.hpp"

#include <numeric>

namespace twoscale::check {
namespace {

Dense trimmed(Dense p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
  return p;
}

/// Is there z with |z| = 1 where all a_s vanish?
bool have_common_zero(const std::vector<Integer>& a, std::size_t arity, Meter& meter) {
  Dense common;
  for (std::size_t s = 0; s < arity; ++s) {
    Dense sub;
    for (std::size_t i = s; i < a.size(); i += arity) sub.push_back(a[i]);
    sub = trimmed(std::move(sub));
    if (!sub.empty()) common = gcd(common, sub, meter);
  }
  std::vector<Integer> square(common.size());  // the coefficients of common(z) common(1/z)
  for (std::size_t k = 0; k < square.size(); ++k) {
    for (std::size_t i = 0; i + k < square.size(); ++i) square[k] += meter.multiply(common[i], common[i + k]);
  }
  return zeros_within(cosine_sum(square, meter), {-1, 1}, {1, 1}, meter) != 0;
}

/// The common divisor of all A_s - A_0, its zeros at 0 removed.
Dense common_difference(const std::vector<Integer>& a, std::size_t arity, Meter& meter) {
  Dense common;
  for (std::size_t s = 1; s < arity; ++s) {
    Dense difference(a.size());
    for (std::size_t i = 0; i < a.size(); i += arity) difference[i] = -a[i];
    for (std::size_t i = s; i < a.size(); i += arity) difference[i] = a[i];
    difference = trimmed(std::move(difference));
    if (!difference.empty()) common = gcd(common, difference, meter);
  }
  std::size_t zeros = 0;
  while (zeros < common.size() && common[zeros] == 0) ++zeros;
  common.erase(common.begin(), common.begin() + static_cast<std::ptrdiff_t>(zeros));
  return common;
}

bool cyclotomic_divides(const Dense& p, std::uint64_t n, Meter& meter) {
  meter.spend(static_cast<std::uint64_t>(1) << 12);  // euler_phi for n <= 2*4096^2
  const std::size_t degree = euler_phi(n);
  if (degree >= p.size()) return false;
  return quotient(p, cyclotomic_head(n, degree + 1, meter), meter).has_value();
}

}  // namespace

Finding check_stability(const Context& context, Fields& fields, bool proved) {
  Meter& meter = context.meter;
  const auto arity = static_cast<std::size_t>(context.certificate.arity);
  long claimed = 0;
  if (!proved) {
    Fields witness(fields.take("witness"), fields.path("witness"));
    const std::string& kind = witness.take_string("kind");
    if (kind != "common-zero" && kind != "cycle") {
      throw Malformed(witness.path("kind") + ": \"common-zero\" or \"cycle\" is expected");
    }
    if (kind == "cycle") claimed = witness.take_integer("order", 2, limits::index);
    witness.done();
  }
  const Coefficients a = limit_coefficients(context);
  require_sum_rule(a, context.certificate.arity, meter);
  const std::string subject = "of the integer shifts of the basic limit function";
  const auto coprime = [&](std::uint64_t n) { return std::gcd(n, static_cast<std::uint64_t>(arity)) == 1; };
  if (claimed == 0) {
    const bool common = have_common_zero(a.list, arity, meter);
    if (!proved) {
      if (!common) throw Refused("the sub-symbols have no common zero on the unit circle");
      return {subject, "the sub-symbols have a common zero on the unit circle", {"jia-wang", "sturm"}};
    }
    if (common) throw Refused("the sub-symbols have a common zero on the unit circle");
  }
  const Dense difference = common_difference(a.list, arity, meter);
  if (!proved) {
    const auto n = static_cast<std::uint64_t>(claimed);
    if (!coprime(n)) throw Refused("the order of the cycle and the arity have a common divisor");
    if (!cyclotomic_divides(difference, n, meter)) {
      throw Refused("the cyclotomic polynomial of the order " + std::to_string(n) + " is not a common divisor");
    }
    return {subject, "cycle of roots of unity of order " + std::to_string(n), {"jia-wang"}};
  }
  const std::uint64_t degree = difference.size() - 1;
  for (std::uint64_t n = 2; n <= 2 * degree * degree; ++n) {  // phi(n) >= sqrt(n/2)
    if (coprime(n) && cyclotomic_divides(difference, n, meter)) {
      throw Refused("a cycle of roots of unity of order " + std::to_string(n));
    }
  }
  return {subject,
          "no common zero of the sub-symbols on the unit circle, no cycle of roots of unity",
          {"jia-wang", "sturm"}};
}

}  // namespace twoscale::check
