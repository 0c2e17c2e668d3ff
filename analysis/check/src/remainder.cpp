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

/// Calls add(s, i) for the entries c_i (0 without i) of each B_s, row by row; returns the size of the matrices.
template <typename Add>
std::size_t arrange(std::size_t length, long arity, Meter& meter, Add add) {
  const long n0 = static_cast<long>(length) - 1;
  const long size = std::max(1L, (n0 + arity - 2) / (arity - 1));
  if (size > static_cast<long>(limits::matrix)) {
    throw Malformed("the mask leads to matrices of more than " + std::to_string(limits::matrix) + " rows");
  }
  for (long s = 0; s < arity; ++s) {
    meter.spend(10 * static_cast<std::uint64_t>(size * size));
    for (long p = 0; p < size; ++p) {
      for (long q = 0; q < size; ++q) {
        const long i = n0 + 1 - arity + s + p - arity * q;
        add(static_cast<std::size_t>(s), i >= 0 && i <= n0 ? std::optional(static_cast<std::size_t>(i)) : std::nullopt);
      }
    }
  }
  return static_cast<std::size_t>(size);
}

std::vector<Matrix> matrices_of(const Coefficients& c, long arity, Meter& meter) {
  std::vector<Matrix> list(static_cast<std::size_t>(arity));
  const std::size_t size = arrange(c.list.size(), arity, meter, [&](std::size_t s, std::optional<std::size_t> i) {
    list[s].entries.push_back(i ? c.list[*i] : Integer(0));
    meter.hold(sizeof(Integer) + 8 * words(list[s].entries.back()));
  });
  for (Matrix& matrix : list) {
    matrix.size = size;
    matrix.scale = c.scale;
    reduce(matrix.entries, matrix.scale, meter);
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
  if (certificate.limits.size() != certificate.names.size()) throw Refused("the mask contains constants");
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

AffineCoefficients affine_remainder(const Context& context, long order) {
  require_positive_order(order);
  const Certificate& certificate = context.certificate;
  const Mask& mask = certificate.mask;
  Meter& meter = context.meter;
  if (mask.denominator.size() != 1 || mask.denominator.begin()->first[0] != 0) {
    throw Refused("the denominator of the mask contains the parameter");
  }
  AffineCoefficients c;
  c.scale = mask.denominator.begin()->second;  // positive
  std::vector<Integer>* const parts[2] = {&c.constant, &c.linear};
  Integer sums[2] = {0, 0};
  for (const Polynomial& numerator : mask.numerators) {
    for (auto* part : parts) part->emplace_back(0);
    for (const auto& [monomial, coefficient] : numerator) {
      if (monomial[0] > 1) throw Refused("the mask is not affine in the parameter");
      const auto k = static_cast<std::size_t>(monomial[0]);
      parts[k]->back() = coefficient;
      sums[k] += coefficient;
      meter.spend(words(sums[k]) + 10);
    }
  }
  if (sums[0] != c.scale * certificate.arity || sums[1] != 0) {
    throw Refused("the sum of the coefficients of the mask is not " + std::to_string(certificate.arity));
  }
  for (auto* part : parts) *part = quotient_of(std::move(*part), order, certificate.arity, meter);
  return c;
}

Coefficients at(const AffineCoefficients& c, const Fraction& w, Meter& meter) {
  Coefficients result;
  result.scale = meter.multiply(c.scale, w.denominator);
  for (std::size_t i = 0; i < c.constant.size(); ++i) {
    result.list.push_back(meter.multiply(c.constant[i], w.denominator) + meter.multiply(c.linear[i], w.numerator));
  }
  return result;
}

std::vector<Matrix> remainder_matrices(const Context& context, long order, const Fraction& low, const Fraction& high) {
  const AffineCoefficients c = affine_remainder(context, order);
  const long arity = context.certificate.arity;
  Meter& meter = context.meter;
  std::vector<Matrix> list = matrices_of(at(c, low, meter), arity, meter);
  if (compare(low, high, meter) != 0) {
    for (Matrix& matrix : matrices_of(at(c, high, meter), arity, meter)) list.push_back(std::move(matrix));
  }
  return list;
}

std::vector<PolynomialMatrix> remainder_matrices(const AffineCoefficients& c, long arity, const Dense& p,
                                                 const Dense& q, Meter& meter) {
  std::vector<Dense> values(c.constant.size());  // scale*q*c_i
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (c.constant[i] != 0) add_product(values[i], q, {c.constant[i]}, meter);
    if (c.linear[i] != 0) add_product(values[i], p, {c.linear[i]}, meter);
    hold(values[i], meter);
  }
  std::vector<PolynomialMatrix> list(static_cast<std::size_t>(arity));
  const std::size_t size = arrange(values.size(), arity, meter, [&](std::size_t s, std::optional<std::size_t> i) {
    list[s].entries.push_back(i ? values[*i] : Dense{});
    hold(list[s].entries.back(), meter);
  });
  for (PolynomialMatrix& matrix : list) matrix.rows = matrix.columns = size;
  return list;
}

}  // namespace twoscale::check
