// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Arithmetic with one positive algebraic number.
#include "twoscale/check/radius.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace twoscale::check {
namespace {

constexpr std::uint64_t vector_words = std::uint64_t{1} << 25;  // of a vector that is being computed

void require_moderate(std::uint64_t total) {
  if (total > vector_words) throw Malformed("the certificate leads to vectors beyond the memory limit of the checker");
}

/// The least end point of a [low, high] is a*low or a*high.
void add_multiple(Integer& low, Integer& high, const Integer& a, const Integer& x_low, const Integer& x_high,
                  Meter& meter) {
  low += meter.multiply(a, a > 0 ? x_low : x_high);
  high += meter.multiply(a, a > 0 ? x_high : x_low);
}

}  // namespace

Dense read_in_x(const Value& value, const std::string& where, Meter& meter) {
  static const std::array<std::string, 1> names{"x"};
  return dense(parse_polynomial(as_string(value, where), names, where, meter));
}

Radius read_radius(Fields& fields, Meter& meter) {
  Radius radius;
  const Value& text = fields.take("polynomial");
  radius.polynomial = primitive(read_in_x(text, fields.path("polynomial"), meter), meter);
  if (radius.polynomial.size() < 2) throw Malformed(fields.path("polynomial") + ": a polynomial in x is expected");
  if (radius.polynomial.back() < 0) {
    for (Integer& c : radius.polynomial) c = -c;
  }
  const std::vector<Value>& interval = fields.take_array("interval");
  const std::string where = fields.path("interval");
  if (interval.size() != 2) throw Malformed(where + ": two numbers are expected");
  radius.low = parse_fraction(as_string(interval[0], where), where, meter);
  radius.high = parse_fraction(as_string(interval[1], where), where, meter);
  if (radius.low.numerator <= 0 || compare(radius.low, radius.high, meter) > 0) {
    throw Malformed(where + ": 0 < low <= high is expected");
  }
  if (zeros_within(radius.polynomial, radius.low, radius.high, meter) != 1) {
    throw Refused("the polynomial of the radius has not exactly one zero in the interval");
  }
  radius.text = "the zero of " + shortened(text.text) + " in [" + shortened(interval[0].text) + ", " +
                shortened(interval[1].text) + "]";
  return radius;
}

Radius rational_radius(const Fraction& value) { return {{-value.numerator, value.denominator}, value, value, ""}; }

Residues ResidueRing::reduced(Residues v) const {
  const Integer& lead = p_.back();
  std::size_t length = 0;
  for (const Dense& q : v.list) length = std::max(length, q.size());
  for (; length >= p_.size(); --length) {  // lead q - q_top x^shift p
    const std::size_t shift = length - p_.size();
    bool any = false;
    for (const Dense& q : v.list) any = any || q.size() == length;
    std::uint64_t total = 0;
    for (Dense& q : v.list) {
      const Integer top = q.size() == length ? q.back() : Integer(0);
      if (any && lead != 1) {
        for (Integer& c : q) c = meter_.multiply(c, lead);
      }
      if (top != 0) {
        for (std::size_t i = 0; i < p_.size(); ++i) q[shift + i] -= meter_.multiply(top, p_[i]);
      }
      while (!q.empty() && q.back() == 0) q.pop_back();
      for (const Integer& c : q) total += words(c);
      meter_.spend(q.size() + 5);
    }
    if (any && lead != 1) v.scale = meter_.multiply(v.scale, lead);
    require_moderate(total);
  }
  Integer divisor = v.scale;
  for (const Dense& q : v.list) {
    for (const Integer& c : q) {
      if (divisor == 1) return v;
      divisor = meter_.gcd(divisor, c);
    }
  }
  if (divisor == 1) return v;
  meter_.spend(3 * words(v.scale) * words(divisor));
  v.scale /= divisor;
  for (Dense& q : v.list) {
    for (Integer& c : q) {
      meter_.spend(3 * words(c) * words(divisor) + 10);
      c /= divisor;
    }
  }
  return v;
}

Residues ResidueRing::times_x(Residues v, std::size_t count) const {
  for (std::size_t i = 0; i < count; ++i) {
    for (Dense& q : v.list) {
      meter_.spend(10 * q.size() + 10);
      if (!q.empty()) q.insert(q.begin(), Integer(0));
    }
    v = reduced(std::move(v));
  }
  return v;
}

Residues ResidueRing::times(const Matrix& a, const Residues& v) const {
  Residues result{std::vector<Dense>(a.size), meter_.multiply(v.scale, a.scale)};
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < a.size; ++i) {
    Dense& sum = result.list[i];
    meter_.spend(a.size);
    for (std::size_t j = 0; j < a.size; ++j) {
      if (a.at(i, j) == 0) continue;
      const Dense& q = v.list[j];
      if (sum.size() < q.size()) sum.resize(q.size());
      for (std::size_t k = 0; k < q.size(); ++k) sum[k] += meter_.multiply(a.at(i, j), q[k]);
    }
    while (!sum.empty() && sum.back() == 0) sum.pop_back();
    for (const Integer& c : sum) total += words(c);
    require_moderate(total);
  }
  return reduced(std::move(result));
}

bool ResidueRing::equal(const Residues& v, const Residues& w, int sign) const {
  for (std::size_t i = 0; i < v.list.size(); ++i) {
    if (v.list[i].size() != w.list[i].size()) return false;
    for (std::size_t k = 0; k < v.list[i].size(); ++k) {
      const Integer left = meter_.multiply(v.list[i][k], w.scale);
      const Integer right = meter_.multiply(w.list[i][k], v.scale);
      if (sign > 0 ? left != right : left != -right) return false;
    }
  }
  return true;
}

VectorEnclosure combined(const VectorEnclosure& target, const VectorEnclosure& x, const Fraction& factor,
                         Meter& meter) {
  const Integer scale = meter.multiply(x.scale, factor.denominator);
  const Integer common = meter.gcd(target.scale, scale);
  meter.spend(3 * (words(target.scale) + words(scale)) * words(common) + 20);
  const Integer stretch = scale / common;
  const Integer multiple = meter.multiply(factor.numerator, target.scale / common);
  VectorEnclosure result;
  result.scale = meter.multiply(target.scale, stretch);
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < x.low.size(); ++i) {
    result.low.push_back(meter.multiply(target.low[i], stretch));
    result.high.push_back(meter.multiply(target.high[i], stretch));
    add_multiple(result.low.back(), result.high.back(), multiple, x.low[i], x.high[i], meter);
    total += words(result.low.back()) + words(result.high.back());
    require_moderate(total);
  }
  return result;
}

Enclosure::Enclosure(const Radius& radius, unsigned bits, Meter& meter)
    : radius_(radius), meter_(meter), exact_(radius.is_rational()), bits_(bits) {
  if (exact_) {
    below_ = above_ = -radius.polynomial[0];
    scale_ = radius.polynomial[1];
    return;
  }
  scale_ = Integer(1) << bits;
  const Dense p = squarefree(radius.polynomial, meter);
  const auto sign_of = [&](const Fraction& x) { return sign_at(p, x.numerator, x.denominator, meter); };
  const auto low_on_grid = [&](const Fraction& x) {
    return floor_quotient(meter.multiply(x.numerator, scale_), x.denominator, meter);
  };
  const auto high_on_grid = [&](const Fraction& x) {
    return ceil_quotient(meter.multiply(x.numerator, scale_), x.denominator, meter);
  };
  const int start = sign_of(radius.low);
  const bool at_high = sign_of(radius.high) == 0;
  below_ = low_on_grid(start != 0 && at_high ? radius.high : radius.low);
  above_ = high_on_grid(start == 0 ? radius.low : radius.high);
  while (start != 0 && !at_high && above_ - below_ > 1) {  // the middle lies in [low, high]: one change of sign there
    const Integer middle = (below_ + above_) / 2;
    const int sign = sign_at(p, middle, scale_, meter);
    if (sign == 0) {
      below_ = above_ = middle;
    } else {
      (sign == start ? below_ : above_) = middle;
    }
  }
  if (below_ <= 0) throw Refused("too few bits: the radius cannot be told from 0");
}

VectorEnclosure Enclosure::rounded(VectorEnclosure v) const {
  if (exact_) {
    Integer divisor = v.scale;
    for (const Integer& x : v.low) {
      if (divisor == 1) break;
      divisor = meter_.gcd(divisor, x);
    }
    std::uint64_t total = 0;
    for (Integer& x : v.low) {
      meter_.spend(3 * words(x) * words(divisor) + 10);
      if (divisor != 1) x /= divisor;
      total += words(x);
    }
    require_moderate(total);
    meter_.spend(3 * words(v.scale) * words(divisor));
    v.scale /= divisor;
    v.high = v.low;
    return v;
  }
  for (Integer& x : v.low) x = floor_quotient(meter_.multiply(x, scale_), v.scale, meter_);
  for (Integer& x : v.high) x = ceil_quotient(meter_.multiply(x, scale_), v.scale, meter_);
  v.scale = scale_;
  return v;
}

VectorEnclosure Enclosure::value(std::span<const Dense> vector, const Fraction& scale) const {
  if (exact_) {
    const Residues v = ResidueRing(radius_.polynomial, meter_).reduced({{vector.begin(), vector.end()}, 1});
    VectorEnclosure result;
    for (const Dense& q : v.list) {
      result.low.push_back(q.empty() ? Integer(0) : meter_.multiply(q[0], scale.numerator));
    }
    result.scale = meter_.multiply(v.scale, scale.denominator);
    result.high = result.low;
    return rounded(std::move(result));
  }
  VectorEnclosure result;
  result.scale = meter_.multiply(scale_, scale.denominator);
  for (const Dense& q : vector) {
    Integer low = 0, high = 0;  // over 2^bits
    for (std::size_t i = q.size(); i-- > 0;) {
      low = floor_quotient(meter_.multiply(low, low < 0 ? above_ : below_), scale_, meter_);
      high = ceil_quotient(meter_.multiply(high, high < 0 ? below_ : above_), scale_, meter_);
      const Integer constant = meter_.multiply(q[i], scale_);
      low += constant;
      high += constant;
    }
    result.low.push_back(meter_.multiply(low, scale.numerator));
    result.high.push_back(meter_.multiply(high, scale.numerator));
  }
  return rounded(std::move(result));
}

VectorEnclosure Enclosure::image(const Matrix& a, const VectorEnclosure& v) const {
  VectorEnclosure result;
  result.scale = meter_.multiply(a.scale, v.scale);
  for (std::size_t i = 0; i < a.size; ++i) {
    Integer low = 0, high = 0;
    meter_.spend(a.size);
    for (std::size_t j = 0; j < a.size; ++j) {
      if (a.at(i, j) != 0) add_multiple(low, high, a.at(i, j), v.low[j], v.high[j], meter_);
    }
    result.low.push_back(std::move(low));
    result.high.push_back(std::move(high));
  }
  // Over rho: times scale_/above_ or scale_/below_; both are brought over the denominator above_*below_.
  const Integer over_above = exact_ ? scale_ : meter_.multiply(scale_, below_);
  const Integer over_below = exact_ ? scale_ : meter_.multiply(scale_, above_);
  for (Integer& x : result.low) x = meter_.multiply(x, x < 0 ? over_below : over_above);
  for (Integer& x : result.high) x = meter_.multiply(x, x < 0 ? over_above : over_below);
  result.scale = meter_.multiply(result.scale, exact_ ? above_ : meter_.multiply(above_, below_));
  return rounded(std::move(result));
}

}  // namespace twoscale::check
