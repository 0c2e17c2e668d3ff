// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. The remainder of the limit mask and its matrices.
#include "twoscale/check/remainder.hpp"

#include <algorithm>

namespace twoscale::check {
namespace {

/// p/S_m if S_m divides p: S_m(z) = (1 - z^m)/(1 - z).
std::optional<std::vector<Integer>> divided(const std::vector<Integer>& p, std::size_t m, Meter& meter) {
  std::vector<Integer> q(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    meter.spend(2 * words(p[i]) + 10);
    q[i] = p[i];
    if (i > 0) q[i] -= p[i - 1];
    if (i >= m) q[i] += q[i - m];
  }
  const std::size_t length = p.size() < m ? 0 : p.size() - m + 1;
  if (std::any_of(q.begin() + static_cast<std::ptrdiff_t>(length), q.end(), [](const Integer& x) { return x != 0; })) {
    return std::nullopt;
  }
  q.resize(length);
  return q;
}

/// m^order p/S_m^order; Refused if S_m^order does not divide p.
std::vector<Integer> quotient_of(std::vector<Integer> p, long order, long arity, Meter& meter) {
  for (long i = 0; i < order; ++i) {
    auto next = divided(p, static_cast<std::size_t>(arity), meter);
    if (!next) {
      throw Refused("the order of the sum rules is " + std::to_string(i) + " only, not " + std::to_string(order));
    }
    p = std::move(*next);
  }
  const Integer power = meter.power(arity, static_cast<std::uint64_t>(order));
  for (Integer& x : p) x = meter.multiply(x, power);
  return p;
}

std::vector<Matrix> matrices_of(const Coefficients& c, long arity, Meter& meter) {
  const long n0 = static_cast<long>(c.list.size()) - 1;
  const long size = std::max(1L, (n0 + arity - 2) / (arity - 1));
  if (size > static_cast<long>(limits::matrix)) {
    throw Malformed("the mask leads to matrices of more than " + std::to_string(limits::matrix) + " rows");
  }
  std::vector<Matrix> list;
  for (long s = 0; s < arity; ++s) {
    Matrix matrix{static_cast<std::size_t>(size), {}, c.scale};
    for (long p = 0; p < size; ++p) {
      for (long q = 0; q < size; ++q) {
        const long i = n0 + 1 - arity + s + p - arity * q;
        matrix.entries.push_back(i >= 0 && i <= n0 ? c.list[static_cast<std::size_t>(i)] : Integer(0));
        meter.hold(sizeof(Integer) + 8 * words(matrix.entries.back()));
      }
    }
    meter.spend(10 * matrix.entries.size());
    reduce(matrix.entries, matrix.scale, meter);
    list.push_back(std::move(matrix));
  }
  return list;
}

void require_positive_order(long order) {
  if (order < 1) throw Refused("the order of the sum rules must be positive");
}

}  // namespace

Coefficients limit_coefficients(const Context& context) {
  const Certificate& certificate = context.certificate;
  Meter& meter = context.meter;
  if (!certificate.constants.empty()) throw Refused("the mask contains constants");
  const Mask& limit = context.identities.limit_mask();
  if (limit.denominator.empty()) throw Refused("the denominator vanishes where all level variables are 1");
  const auto value = [](const Polynomial& p) { return p.empty() ? Integer(0) : p.begin()->second; };
  const auto zero = [](const Polynomial& p) { return p.empty(); };
  const auto& numerators = limit.numerators;
  const auto first = std::find_if_not(numerators.begin(), numerators.end(), zero);
  const auto last = std::find_if_not(numerators.rbegin(), numerators.rend(), zero).base();
  Coefficients a;
  a.scale = value(limit.denominator);
  Integer sum = 0;
  for (auto at = first; at < last; ++at) {
    a.list.push_back(value(*at));
    sum += a.list.back();
    meter.spend(words(sum) + 10);
  }
  if (sum != a.scale * certificate.arity) {
    throw Refused("the sum of the coefficients of the limit mask is not " + std::to_string(certificate.arity));
  }
  if (a.scale < 0) {
    a.scale = -a.scale;
    for (Integer& x : a.list) x = -x;
  }
  return a;
}

void require_sum_rule(const Coefficients& a, long arity, Meter& meter) { quotient_of(a.list, 1, arity, meter); }

Coefficients exact_remainder(const Context& context, long order) {
  require_positive_order(order);
  const long arity = context.certificate.arity;
  Coefficients c = limit_coefficients(context);
  c.list = quotient_of(std::move(c.list), order, arity, context.meter);
  if (divided(c.list, static_cast<std::size_t>(arity), context.meter)) {
    throw Refused("the order of the sum rules is more than " + std::to_string(order));
  }
  return c;
}

std::vector<Matrix> remainder_matrices(const Context& context, long order) {
  return matrices_of(exact_remainder(context, order), context.certificate.arity, context.meter);
}

std::vector<Matrix> remainder_matrices(const Context& context, long order, const Fraction& low, const Fraction& high) {
  require_positive_order(order);
  const Certificate& certificate = context.certificate;
  const Mask& mask = certificate.mask;
  Meter& meter = context.meter;
  if (mask.denominator.size() != 1 || mask.denominator.begin()->first[0] != 0) {
    throw Refused("the denominator of the mask contains the parameter");
  }
  const Integer scale = mask.denominator.begin()->second;  // positive
  std::vector<Integer> parts[2];                           // a(z) = (parts[0] + w parts[1])/scale
  Integer sums[2] = {0, 0};
  for (const Polynomial& numerator : mask.numerators) {
    parts[0].emplace_back(0);
    parts[1].emplace_back(0);
    for (const auto& [monomial, coefficient] : numerator) {
      if (monomial[0] > 1) throw Refused("the mask is not affine in the parameter");
      const auto k = static_cast<std::size_t>(monomial[0]);
      parts[k].back() = coefficient;
      sums[k] += coefficient;
      meter.spend(words(sums[k]) + 10);
    }
  }
  if (sums[0] != scale * certificate.arity || sums[1] != 0) {
    throw Refused("the sum of the coefficients of the mask is not " + std::to_string(certificate.arity));
  }
  for (auto& part : parts) part = quotient_of(std::move(part), order, certificate.arity, meter);

  std::vector<Matrix> list;
  const auto add = [&](const Fraction& w) {
    Coefficients c;
    c.scale = meter.multiply(scale, w.denominator);
    for (std::size_t i = 0; i < parts[0].size(); ++i) {
      c.list.push_back(meter.multiply(parts[0][i], w.denominator) + meter.multiply(parts[1][i], w.numerator));
    }
    for (Matrix& matrix : matrices_of(c, certificate.arity, meter)) list.push_back(std::move(matrix));
  };
  add(low);
  if (compare(low, high, meter) != 0) add(high);
  return list;
}

}  // namespace twoscale::check
