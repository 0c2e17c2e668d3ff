// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Dense polynomials in one variable: division, Descartes' rule, Sturm's theorem.
#include "twoscale/check/univariate.hpp"

#include "twoscale/check/cyclotomic.hpp"

#include <utility>

namespace twoscale::check {
namespace {

constexpr std::size_t product_length = std::size_t{1} << 20;  // coefficients of a product
constexpr std::uint64_t product_words = std::uint64_t{1} << 23;

void trim(Dense& p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
}

Dense derivative(const Dense& p) {
  Dense result;
  for (std::size_t i = 1; i < p.size(); ++i) result.push_back(p[i] * i);
  return result;
}

/// -(remainder of p by g) times a positive number, primitive.
Dense negated_remainder(Dense p, const Dense& g, Meter& meter) {
  const Integer lead = g.back();
  const Integer size = abs(lead);
  while (p.size() >= g.size()) {
    const Integer factor = lead > 0 ? p.back() : Integer(-p.back());
    const std::size_t shift = p.size() - g.size();
    p.pop_back();
    for (std::size_t i = 0; i < p.size(); ++i) {
      p[i] = meter.multiply(p[i], size);
      if (i >= shift) p[i] -= meter.multiply(factor, g[i - shift]);
    }
    trim(p);
  }
  for (Integer& c : p) c = -c;
  return primitive(std::move(p), meter);
}

/// Divides p by (x - a) as often as possible; has it been possible?
bool divide_out(Dense& p, const Fraction& a, Meter& meter) {
  bool divided = false;
  while (p.size() > 1 && sign_at(p, a.numerator, a.denominator, meter) == 0) {
    p = *quotient(p, {-a.numerator, a.denominator}, meter);
    divided = true;
  }
  return divided;
}

int count_variations(const std::vector<int>& signs) {
  int count = 0, last = 0;
  for (const int s : signs) {
    if (s == 0) continue;
    if (last != 0 && s != last) ++count;
    last = s;
  }
  return count;
}

/// Is a/b > cos(pi/m)? With U_j the Chebyshev polynomials of the second kind: exactly if U_1, ..., U_{m-1} are all
/// positive there (x = cos(phi): sin((j+1)phi) first fails to be positive at the least j+1 >= pi/phi).
bool beyond_cos(const Integer& a, const Integer& b, int m, Meter& meter) {
  Integer before = 1, now = 2 * a;  // b^j U_j(a/b)
  for (int j = 1; j < m; ++j) {
    if (now <= 0) return false;
    Integer next = meter.multiply(2 * a, now) - meter.multiply(meter.multiply(b, b), before);
    before = std::exchange(now, std::move(next));
  }
  return true;
}

}  // namespace

void hold(const Dense& p, Meter& meter) {
  for (const Integer& c : p) meter.hold(sizeof(Integer) + 8 * words(c));
}

Dense dense(const Polynomial& p) {
  Dense result(p.empty() ? 0 : static_cast<std::size_t>(p.begin()->first[0]) + 1);
  for (const auto& [monomial, coefficient] : p) result[static_cast<std::size_t>(monomial[0])] = coefficient;
  return result;
}

std::optional<Dense> quotient(const Dense& p, const Dense& g, Meter& meter) {
  if (p.empty()) return Dense{};
  if (p.size() < g.size()) return std::nullopt;
  for (const Integer& c : p) meter.spend(words(c) + 10);
  Dense rest = p;
  Dense result(p.size() - g.size() + 1);
  for (std::size_t shift = result.size(); shift-- > 0;) {
    Integer& lead = rest[shift + g.size() - 1];
    if (lead == 0) continue;
    Integer factor, remainder;
    meter.spend(3 * words(lead) * words(g.back()) + 20);
    divide_qr(lead, g.back(), factor, remainder);
    if (remainder != 0) return std::nullopt;
    for (std::size_t i = 0; i < g.size(); ++i) rest[shift + i] -= meter.multiply(factor, g[i]);
    result[shift] = std::move(factor);
  }
  trim(rest);
  if (!rest.empty()) return std::nullopt;
  return result;
}

void add_product(Dense& target, const Dense& p, const Dense& q, Meter& meter) {
  if (p.empty() || q.empty()) return;
  if (p.size() + q.size() > product_length) {
    throw Malformed("the certificate leads to polynomials beyond the memory limit of the checker");
  }
  meter.spend(p.size() + q.size());
  if (target.size() < p.size() + q.size() - 1) target.resize(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p[i] == 0) continue;
    for (std::size_t j = 0; j < q.size(); ++j) target[i + j] += meter.multiply(p[i], q[j]);
  }
  trim(target);
  std::uint64_t total = 0;
  for (const Integer& c : target) total += words(c);
  if (total > product_words) {
    throw Malformed("the certificate leads to polynomials beyond the memory limit of the checker");
  }
}

Dense multiply(const Dense& p, const Dense& q, Meter& meter) {
  Dense result;
  add_product(result, p, q, meter);
  return result;
}

Dense negated(Dense p) {
  for (Integer& c : p) c = -c;
  return p;
}

Dense primitive(Dense p, Meter& meter) {
  Integer divisor = 0;
  for (const Integer& c : p) {
    if (divisor == 1) return p;
    divisor = meter.gcd(divisor, c);
  }
  if (divisor <= 1) return p;
  for (Integer& c : p) {
    meter.spend(words(c) * words(divisor) + 10);
    c /= divisor;
  }
  return p;
}

int variations_beyond(const Dense& p, const Integer& a, const Integer& b, Meter& meter) {
  Dense shifted = p;  // b^deg p((x + a)/b): coefficients p_i b^(deg-i), then repeated synthetic division at a
  Integer power = 1;
  for (std::size_t i = shifted.size(); i-- > 0;) {
    shifted[i] = meter.multiply(shifted[i], power);
    power = meter.multiply(power, b);
  }
  for (std::size_t done = 0; a != 0 && done + 1 < shifted.size(); ++done) {
    for (std::size_t i = shifted.size() - 1; i-- > done;) shifted[i] += meter.multiply(a, shifted[i + 1]);
  }
  std::vector<int> signs;
  for (const Integer& c : shifted) signs.push_back(c.sign());
  return count_variations(signs);
}

int sign_at(const Dense& p, const Integer& a, const Integer& b, Meter& meter) {
  Integer value = 0, power = 1;  // b^deg p(a/b)
  for (std::size_t i = p.size(); i-- > 0;) {
    value = meter.multiply(value, a) + meter.multiply(p[i], power);
    power = meter.multiply(power, b);
  }
  return value.sign();
}

SturmChain::SturmChain(const Dense& p, Meter& meter) {
  chain_.push_back(primitive(p, meter));
  Dense next = primitive(derivative(p), meter);
  while (!next.empty()) {
    Dense after = negated_remainder(chain_.back(), next, meter);
    chain_.push_back(std::exchange(next, std::move(after)));
    hold(chain_.back(), meter);
  }
}

int SturmChain::zeros_beyond(const Integer& a, const Integer& b, Meter& meter) const {
  std::vector<int> here, infinity;
  for (const Dense& p : chain_) {
    here.push_back(sign_at(p, a, b, meter));
    infinity.push_back(p.back().sign());
  }
  return count_variations(here) - count_variations(infinity);
}

Dense gcd(const Dense& p, const Dense& q, Meter& meter) {
  Dense a = primitive(p, meter), b = primitive(q, meter);
  if (a.size() < b.size()) a.swap(b);
  while (!b.empty()) {
    Dense rest = negated_remainder(std::move(a), b, meter);
    a = std::exchange(b, std::move(rest));
  }
  if (a.back() < 0) {
    for (Integer& c : a) c = -c;
  }
  return a;
}

Dense squarefree(const Dense& p, Meter& meter) {
  const Dense whole = primitive(p, meter);
  return *quotient(whole, gcd(whole, derivative(whole), meter), meter);
}

Dense odd_part(const Dense& p, Meter& meter) {
  Dense rest = primitive(p, meter);  // product of p_j^{j-i} over j > i; simple = product of p_j over j >= i
  rest = gcd(rest, derivative(rest), meter);
  Dense simple = squarefree(p, meter);
  Dense result{Integer(1)};
  for (int i = 1; simple.size() > 1; ++i) {
    const Dense next = gcd(simple, rest, meter);
    const Dense factor = *quotient(simple, next, meter);  // p_i
    if (i % 2 == 1) result = multiply(result, factor, meter);
    rest = *quotient(rest, next, meter);
    simple = next;
  }
  return result;
}

int zeros_within(const Dense& p, const Fraction& low, const Fraction& high, Meter& meter) {
  Dense rest = primitive(p, meter);
  const bool at_low = divide_out(rest, low, meter);
  const bool at_high = divide_out(rest, high, meter);
  const SturmChain chain(rest, meter);
  return (at_low ? 1 : 0) + (at_high ? 1 : 0) + chain.zeros_beyond(low.numerator, low.denominator, meter) -
         chain.zeros_beyond(high.numerator, high.denominator, meter);
}

int zeros_from(const Dense& p, const Fraction& low, Meter& meter) {
  Dense rest = primitive(p, meter);
  const bool at_low = divide_out(rest, low, meter);
  return (at_low ? 1 : 0) + SturmChain(rest, meter).zeros_beyond(low.numerator, low.denominator, meter);
}

int zeros_between(const Dense& p, const Fraction& low, const Fraction& high, Meter& meter) {
  Dense rest = primitive(p, meter);
  divide_out(rest, low, meter);
  divide_out(rest, high, meter);
  return zeros_within(rest, low, high, meter);
}

Fraction middle_of(const Fraction& low, const Fraction& high, Meter& meter) {
  return reduced(meter.multiply(low.numerator, high.denominator) + meter.multiply(high.numerator, low.denominator),
                 2 * meter.multiply(low.denominator, high.denominator), meter);
}

bool is_positive_between(const Dense& p, const Fraction& low, const Fraction& high, Meter& meter) {
  if (p.empty() || zeros_between(p, low, high, meter) != 0) return false;
  const Fraction sample = middle_of(low, high, meter);
  return sign_at(p, sample.numerator, sample.denominator, meter) > 0;
}

bool is_nonnegative_between(const Dense& p, const Fraction& low, const Fraction& high, Meter& meter) {
  if (p.empty()) return true;
  if (zeros_between(odd_part(p, meter), low, high, meter) != 0) return false;
  Fraction sample = high;
  int sign = 0;
  while (sign == 0) {  // ends: p has finitely many zeros
    sample = middle_of(low, sample, meter);
    sign = sign_at(p, sample.numerator, sample.denominator, meter);
  }
  return sign > 0;
}

bool is_schur_stable(Dense p, Meter& meter) {
  while (p.size() > 1) {
    const Integer first = p.front();
    const Integer last = p.back();
    if (abs(first) >= abs(last)) return false;
    Dense next(p.size() - 1);
    for (std::size_t i = 1; i < p.size(); ++i) {
      next[i - 1] = meter.multiply(last, p[i]) - meter.multiply(first, p[p.size() - 1 - i]);
    }
    p = primitive(std::move(next), meter);
  }
  return true;
}

Dense cosine_sum(const std::vector<Integer>& g, Meter& meter) {
  // Clenshaw: b_k = 2 g_k + 2 x b_{k+1} - b_{k+2} for k >= 1; g_0 + x b_1 - b_2.
  Dense later(g.size() + 1), last(g.size() + 1), next(g.size() + 1);
  for (std::size_t k = g.size(); k-- > 0;) {
    const bool end = k == 0;
    const std::size_t degree = g.size() - 1 - k;
    meter.spend(20 * (degree + 1));
    for (std::size_t i = 0; i <= degree; ++i) {
      next[i] = -last[i];
      if (i > 0) next[i] += end ? later[i - 1] : Integer(later[i - 1] << 1);
      meter.spend(2 * words(next[i]));
    }
    next[0] += end ? g[k] : Integer(g[k] << 1);
    last.swap(later);
    later.swap(next);
  }
  trim(later);
  return later;
}

namespace {

/// Rationals low/scale <= cos(pi/m) <= high/scale, with equality only for m = 2, 3.
struct CosineBracket {
  CosineBracket(int arity, Meter& of) : m(arity), meter(of) {
    for (int i = 0; m > 3 && i < 24; ++i) refine();
  }
  void refine() {
    low *= 2, high *= 2, scale *= 2;
    const Integer middle = (low + high) / 2;
    (beyond_cos(middle, scale, m, meter) ? high : low) = middle;
  }
  int m;
  Meter& meter;
  Integer low = m == 3 ? 1 : 0;
  Integer high = m == 2 ? 0 : m == 3 ? 1 : 2;
  Integer scale = 2;
};

}  // namespace

int sign_at_cos(const Dense& p, int m, Meter& meter) {
  if (p.empty() || cosine_divides(p, 2 * static_cast<std::uint64_t>(m), meter)) return 0;
  CosineBracket c(m, meter);
  while (zeros_within(p, {c.low, c.scale}, {c.high, c.scale}, meter) > 0) c.refine();  // ends because p(cos) is not 0
  return sign_at(p, c.low, c.scale, meter);
}

bool has_zero_beyond_cos(const Dense& polynomial, int m, Meter& meter) {
  // The end point does not belong to the interval. Its conjugates cos(j pi/m), j odd, lie to the left of it.
  Dense p = polynomial;
  divide_out_cosine(p, 2 * static_cast<std::uint64_t>(m), meter);
  if (p.size() <= 1) return false;
  CosineBracket c(m, meter);
  if (variations_beyond(p, c.low, c.scale, meter) == 0) return false;

  const SturmChain chain(p, meter);
  while (true) {  // ends because p does not vanish at cos(pi/m)
    if (sign_at(p, c.low, c.scale, meter) != 0 && chain.zeros_beyond(c.low, c.scale, meter) == 0) return false;
    if (sign_at(p, c.high, c.scale, meter) == 0 || chain.zeros_beyond(c.high, c.scale, meter) > 0) return true;
    c.refine();
  }
}

}  // namespace twoscale::check
