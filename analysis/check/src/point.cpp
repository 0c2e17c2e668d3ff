// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Exact values at a witness point, over a common denominator, without gcds.
#include "twoscale/check/point.hpp"

#include <algorithm>
#include <cstdlib>

namespace twoscale::check {
namespace {

std::string short_text(const Integer& numerator, const Integer& denominator) {
  if (words(numerator) + words(denominator) > 8) return "...";
  return denominator == 1 ? numerator.str() : numerator.str() + "/" + denominator.str();
}

}  // namespace

Point::Point(const Value& at, const Certificate& certificate, const std::string& where, Meter& meter)
    : certificate_(certificate), meter_(meter), value_(certificate.mask.numerators.size()) {
  const std::vector<Value>& items = as_array(at, where);
  const std::size_t count = certificate.names.size();
  if (items.size() != count) throw Malformed(where + ": one number for each variable is expected");
  for (const Value& item : items) at_.push_back(parse_fraction(as_string(item, where), where, meter));

  const auto powers = [&](const Integer& base, int degree) {
    std::vector<Integer> list{1};
    for (int d = 0; d < degree; ++d) {
      list.push_back(meter_.multiply(list.back(), base));
      meter_.hold(sizeof(Integer) + 8 * words(list.back()));
    }
    return list;
  };
  for (std::size_t i = 0; i < count; ++i) {
    Fraction v = at_[i];
    if (std::find(certificate.level.begin(), certificate.level.end(), i) != certificate.level.end()) {
      if (v.numerator == 0) throw Malformed(where + ": 0 for a level variable");
      const auto q = static_cast<std::uint64_t>(certificate.e.denominator);
      const Integer p = meter.power(v.numerator, q), w = meter.power(v.denominator, q);
      v.numerator = meter.multiply(p, p) + meter.multiply(w, w);  // v = (E + 1/E)/2, E = p/w
      v.denominator = 2 * meter.multiply(p, w);
    }
    numerator_.push_back(powers(v.numerator, certificate.mask.top[i]));
    denominator_.push_back(powers(v.denominator, certificate.mask.top[i]));
  }
  mask_denominator_ = evaluate(certificate.mask.denominator);
  if (mask_denominator_ == 0) throw Refused(where + ": the denominator of the mask vanishes at the point");
}

Integer Point::evaluate(const Polynomial& p) {
  Integer sum = 0;
  for (const auto& [monomial, coefficient] : p) {
    Integer term = coefficient;
    for (std::size_t i = 0; i < numerator_.size(); ++i) {
      const auto d = static_cast<std::size_t>(monomial[i]);
      term = meter_.multiply(term, numerator_[i][d]);
      term = meter_.multiply(term, denominator_[i][denominator_[i].size() - 1 - d]);
    }
    sum += term;
  }
  return sum;
}

bool Point::coefficient_is(long index, const Fraction& value) {
  if (index < certificate_.mask.lowest || index > certificate_.mask.highest()) return value.numerator == 0;
  const Integer n = evaluate(certificate_.mask.numerators[static_cast<std::size_t>(index - certificate_.mask.lowest)]);
  return meter_.multiply(n, value.denominator) == meter_.multiply(value.numerator, mask_denominator_);
}

bool Point::sum_is(const std::vector<long>& frequency, long power, long residue, bool centred, const Fraction& value) {
  const Mask& mask = certificate_.mask;
  const long m = certificate_.arity;
  const long q = certificate_.e.denominator;
  const long a = centred ? certificate_.e.numerator : 0;

  // z^{i - a/q} = product of Y_j^{k_j}, k_j = -n_j (q i - a), |k_j| <= bound_j; with Y = p/w it is p^{b+k}
  // w^{b-k}/(pw)^b.
  const long reach = std::max(std::labs(q * mask.lowest - a), std::labs(q * mask.highest() - a));
  Integer denominator =
      meter_.multiply(mask_denominator_, meter_.power(q, centred ? static_cast<std::uint64_t>(power) : 0));
  for (std::size_t j = 0; j < frequency.size(); ++j) {
    const Fraction& y = at_[certificate_.level[j]];
    denominator =
        meter_.multiply(denominator, meter_.power(meter_.multiply(y.numerator, y.denominator),
                                                  static_cast<std::uint64_t>(std::labs(frequency[j]) * reach)));
  }
  Integer sum = 0;
  for (long at = (((residue - mask.lowest) % m) + m) % m; at < static_cast<long>(mask.numerators.size()); at += m) {
    const long i = mask.lowest + at;
    std::optional<Integer>& cached = value_[static_cast<std::size_t>(at)];
    if (!cached) cached = evaluate(mask.numerators[static_cast<std::size_t>(at)]);
    if (*cached == 0) continue;
    const Integer weight = meter_.power(centred ? q * i - a : i, static_cast<std::uint64_t>(power));
    Integer term = meter_.multiply(*cached, weight);
    for (std::size_t j = 0; j < frequency.size(); ++j) {
      const Fraction& y = at_[certificate_.level[j]];
      const long bound = std::labs(frequency[j]) * reach;
      const long k = -frequency[j] * (q * i - a);
      term = meter_.multiply(term, meter_.power(y.numerator, static_cast<std::uint64_t>(bound + k)));
      term = meter_.multiply(term, meter_.power(y.denominator, static_cast<std::uint64_t>(bound - k)));
    }
    sum += term;
  }
  return meter_.multiply(sum, value.denominator) == meter_.multiply(value.numerator, denominator);
}

std::string Point::text() const {
  std::string text;
  for (std::size_t i = 0; i < at_.size(); ++i) {
    if (!text.empty()) text += ", ";
    const bool level = std::find(certificate_.level.begin(), certificate_.level.end(), i) != certificate_.level.end();
    const long q = certificate_.e.denominator;
    const std::string& name = certificate_.names[i];
    if (level)
      text += "e^{" + name + "}" + (q == 1 ? "" : "^(1/" + std::to_string(q) + ")");
    else
      text += name;
    text += " = " + short_text(at_[i].numerator, at_[i].denominator);
  }
  return text.empty() ? "the mask" : text;
}

}  // namespace twoscale::check
