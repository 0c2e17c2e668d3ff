// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Zeros on the domain of the level variables, and the exceptions that list them.
#include "twoscale/check/exceptions.hpp"

#include "twoscale/check/cyclotomic.hpp"

#include <algorithm>
#include <numeric>

namespace twoscale::check {
namespace {

constexpr long far = 1'000'000'000'000'000;

/// +1 or -1 if no constant occurs and all coefficients have that sign (then there is no zero on the domain), else 0.
int common_sign(const Polynomial& p, const std::vector<std::size_t>& constants) {
  if (p.empty()) return 0;
  const int sign = p.begin()->second.sign();
  for (const auto& [monomial, coefficient] : p) {
    if (coefficient.sign() != sign) return 0;
    for (const std::size_t c : constants) {
      if (monomial[c] != 0) return 0;
    }
  }
  return sign;
}

/// +1 or -1 if p shows one sign wherever v > cos(pi/m) for all level variables v: its coefficients, or for m > 2 those
/// of p(cos(pi/m) + u), are of one sign. 0 if they are not, or a constant occurs.
int domain_sign(const Polynomial& p, const Certificate& certificate, Meter& meter) {
  if (const int sign = common_sign(p, certificate.constants); sign != 0 || certificate.arity == 2) return sign;
  std::map<Monomial, Dense> shifted;  // coefficient of u^monomial as a polynomial in cos(pi/m)
  for (const auto& [monomial, coefficient] : p) {
    for (const std::size_t c : certificate.constants) {
      if (monomial[c] != 0) return 0;
    }
    if (std::any_of(monomial.begin(), monomial.end(), [](int e) { return e < 0; })) return 0;
    std::vector<std::pair<Monomial, Integer>> terms{{Monomial{}, coefficient}};
    for (std::size_t i = 0; i < monomial.size(); ++i) {
      std::vector<std::pair<Monomial, Integer>> next;
      Integer binomial = 1;
      for (int e = 0; e <= monomial[i]; ++e) {
        for (const auto& [m, c] : terms) {
          next.emplace_back(m, meter.multiply(c, binomial));
          next.back().first[i] = e;
          meter.spend(100);
        }
        binomial = meter.multiply(binomial, monomial[i] - e) / (e + 1);
      }
      terms = std::move(next);
    }
    int degree = 0;
    for (const int e : monomial) degree += e;
    for (const auto& [m, c] : terms) {
      int power = degree;
      for (const int e : m) power -= e;
      Dense& target = shifted[m];
      if (target.size() <= static_cast<std::size_t>(power)) target.resize(static_cast<std::size_t>(power) + 1);
      target[static_cast<std::size_t>(power)] += c;
    }
  }
  int common = 0;
  for (auto& [monomial, coefficient] : shifted) {
    while (!coefficient.empty() && coefficient.back() == 0) coefficient.pop_back();
    const int sign = sign_at_cos(coefficient, certificate.arity, meter);
    if (sign != 0 && common != 0 && sign != common) return 0;
    if (sign != 0) common = sign;
  }
  return common;
}

}  // namespace

std::optional<std::uint64_t> root_order(const Angle& angle, int arity) {
  // exp(2 pi i p/n'), n' = 2 q m^{level+1}; gcd(p, n') <= 10^6, so n > 10^6 once n' > 10^15.
  long n = 2 * angle.angle.denominator;
  for (long k = 0; k <= angle.level; ++k) {
    n *= arity;
    if (n > far) return std::nullopt;
  }
  n /= std::gcd(n, angle.angle.numerator);
  if (n > limits::index) return std::nullopt;
  return static_cast<std::uint64_t>(n);
}

Angle read_angle(Fields& fields, Meter& meter) {
  Angle angle;
  angle.level = fields.take_integer("level", 0, limits::index);
  angle.angle = parse_small_fraction(fields.take_string("angle"), fields.path("angle"), meter);
  if (angle.angle.numerator <= 0 || angle.angle.numerator >= angle.angle.denominator) {
    throw Malformed(fields.path("angle") + ": a fraction between 0 and 1 is expected");
  }
  return angle;
}

std::string text_of(const Angle& angle) {
  const SmallFraction& a = angle.angle;
  std::string text = "v^0 = ";
  if (a.denominator == 2)
    text += "0";
  else if (a.denominator == 3)
    text += a.numerator == 1 ? "1/2" : "-1/2";
  else
    text += "cos(" + (a.numerator == 1 ? "" : std::to_string(a.numerator) + "*") + "pi/" +
            std::to_string(a.denominator) + ")";
  return text + " at level " + std::to_string(angle.level);
}

Exceptions::Exceptions(const Value& value, const Certificate& certificate, const std::string& where, Meter& meter)
    : certificate_(certificate), meter_(meter) {
  const std::vector<Value>& items = as_array(value, where);
  if (items.size() > limits::list_items) throw Malformed(where + ": more than 4096 exceptions");
  for (std::size_t i = 0; i < items.size(); ++i) {
    Fields item(items[i], where + "[" + std::to_string(i) + "]");
    if (certificate.single_level() && item.next_is("level")) {
      if (!conditions_.empty()) throw Malformed(item.path("level") + ": values come before conditions");
      const Angle next = read_angle(item, meter);
      if (i > 0) {  // angle descending, then level ascending
        const Angle& last = angles_.back();
        const long order =
            next.angle.numerator * last.angle.denominator - last.angle.numerator * next.angle.denominator;
        if (order > 0 || (order == 0 && next.level <= last.level)) {
          throw Malformed(item.path("angle") + ": exceptions must be distinct and sorted");
        }
      }
      const auto order = root_order(next, certificate.arity);
      if (!order) throw Refused(item.path("angle") + ": not a zero of a polynomial of the degrees that occur");
      angles_.push_back(next);
      orders_[*order] = false;
    } else {
      const std::string& text = item.take_string("condition");
      const std::string path = item.path("condition");
      Polynomial condition = parse_polynomial(text, certificate.names, path, meter);
      if (condition.empty() || condition.begin()->second < 0 || condition.begin()->first == Monomial{} ||
          content(condition, meter) != 1) {
        throw Malformed(path + ": a primitive polynomial with positive leading coefficient is expected");
      }
      if (!conditions_.empty() && !(conditions_.back().text < text))
        throw Malformed(path + ": conditions must be distinct and sorted");
      const bool can_vanish = certificate.single_level()
                                  ? has_zero_beyond_cos(dense(condition), certificate.arity, meter)
                                  : domain_sign(condition, certificate, meter) == 0;
      if (!can_vanish) throw Refused(path + ": cannot vanish on the domain");
      conditions_.push_back({text, std::move(condition)});
    }
    item.done();
  }
}

void Exceptions::require_no_other_zero(const Polynomial& p, const std::string& what) {
  if (p.empty()) throw Refused(what + " is identically zero");
  if (certificate_.single_level())
    single(dense(p), what);
  else
    several(p, what);
}

void Exceptions::single(Dense p, const std::string& what) {
  const long m = certificate_.arity;
  for (auto& [n, used] : orders_) {
    if (divide_out_cosine(p, n, meter_) == 0) continue;
    used = true;
    // All zeros cos(alpha*pi), alpha = 2j/n, of the irreducible factor: v = cos(alpha*pi) is on the domain of level k
    // for alpha*m^{k+1} < 1, and belongs to v^0 = cos(alpha*m^{k+1}*pi).
    const long order = static_cast<long>(n);
    for (long j = 1; 2 * j * m < order; ++j) {
      meter_.spend(50);
      if (std::gcd(j, order) != 1) continue;
      long angle = 2 * j * m;
      for (long level = 0; angle < order; ++level, angle *= m) {
        meter_.spend(50 + 10 * angles_.size());
        const long divisor = std::gcd(angle, order);
        const Angle zero{level, {angle / divisor, order / divisor}};
        const bool listed = std::any_of(angles_.begin(), angles_.end(), [&](const Angle& a) {
          return a.level == zero.level && a.angle.numerator == zero.angle.numerator &&
                 a.angle.denominator == zero.angle.denominator;
        });
        if (!listed) throw Refused(what + " also vanishes for " + text_of(zero) + ", which is not listed");
      }
    }
  }
  for (Condition& condition : conditions_) {
    while (auto rest = quotient(p, dense(condition.polynomial), meter_)) {
      p = std::move(*rest);
      condition.used = true;
    }
  }
  if (has_zero_beyond_cos(p, certificate_.arity, meter_)) {
    throw Refused(what + " has a zero on the domain that is not listed");
  }
}

void Exceptions::several(Polynomial p, const std::string& what) {
  for (Condition& condition : conditions_) {
    while (auto rest = quotient(p, condition.polynomial, meter_)) {
      p = std::move(*rest);
      condition.used = true;
    }
  }
  if (domain_sign(p, certificate_, meter_) == 0) {
    throw Refused(
        what + ": after division by the listed conditions the coefficients are not of one sign, or constants remain");
  }
}

void Exceptions::mark_zeros(const Polynomial& p) {
  if (certificate_.single_level()) {
    const Dense d = dense(p);
    for (auto& [n, used] : orders_) used = used || cosine_divides(d, n, meter_);
  }
  for (Condition& c : conditions_) c.used = c.used || quotient(p, c.polynomial, meter_).has_value();
}

void Exceptions::require_all_used(const std::string& of_what) const {
  for (const Angle& angle : angles_) {
    if (!orders_.at(*root_order(angle, certificate_.arity))) {
      throw Refused("the listed exception " + text_of(angle) + " is not a zero of " + of_what);
    }
  }
  for (const Condition& condition : conditions_) {
    if (!condition.used)
      throw Refused("the listed condition " + shortened(condition.text) + " does not divide " + of_what);
  }
}

void Exceptions::require_poles() const {
  const auto& numerators = certificate_.mask.numerators;
  for (const auto& [n, used] : orders_) {
    const bool pole = std::any_of(numerators.begin(), numerators.end(), [&, order = n](const Polynomial& numerator) {
      return !cosine_divides(dense(numerator), order, meter_);
    });
    if (!pole) throw Refused("at a listed exception all numerators vanish with the denominator");
  }
  for (const Condition& condition : conditions_) {
    const bool pole = std::any_of(numerators.begin(), numerators.end(), [&](const Polynomial& numerator) {
      return !quotient(numerator, condition.polynomial, meter_);
    });
    if (!pole) throw Refused("the listed condition " + shortened(condition.text) + " divides all numerators");
  }
}

std::string Exceptions::text() const {
  std::string text;
  for (const Angle& angle : angles_) text += (text.empty() ? " except " : ", ") + text_of(angle);
  for (const Condition& condition : conditions_) {
    text += (text.empty() ? " except where " : ", ") + shortened(condition.text) + " = 0 at some level";
  }
  const std::string domain = certificate_.names.empty()    ? "at every level"
                             : certificate_.single_level() ? "for every v^0 > -1 and every level"
                                                           : "for all parameters of the domain and every level";
  return domain + text;
}

}  // namespace twoscale::check
