// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the checker: a second, slow decision whether a certificate states the truth. It shares no mathematics with
// the checker: it evaluates the polynomial texts at a few rational points, refines sampled sequences by the definition
// of the scheme, and scans for poles in floating point. It may call false statements true (unlucky points), hardly the
// reverse.
#pragma once

#include "twoscale/check/json.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <complex>
#include <map>
#include <numeric>
#include <string>
#include <vector>

namespace oracle {

using twoscale::check::Value;
using Rational = boost::multiprecision::cpp_rational;
using Real = long double;
using Complex = std::complex<Real>;

inline const Value& member(const Value& object, const std::string& key) {
  for (std::size_t i = 0; i < object.keys.size(); ++i) {
    if (object.keys[i] == key) return object.items[i];
  }
  throw std::runtime_error("no member " + key);
}

inline Rational rational(const std::string& text) {
  const auto slash = text.find('/');
  const Rational numerator{boost::multiprecision::cpp_int(text.substr(0, slash))};
  return slash == std::string::npos ? numerator
                                    : numerator / Rational(boost::multiprecision::cpp_int(text.substr(slash + 1)));
}

template <class T>
T power(const T& base, long n) {
  T result = 1;
  for (long i = 0; i < std::labs(n); ++i) result *= base;
  return n < 0 ? T(1) / result : result;
}

template <class T>
T convert(const std::string& digits) {
  if constexpr (std::is_same_v<T, Real>)
    return std::stold(digits);
  else
    return T(boost::multiprecision::cpp_int(digits));
}

/// Value of a polynomial text at the point.
template <class T>
T evaluate(const std::string& text, const std::map<std::string, T>& point) {
  T sum = 0;
  for (std::size_t at = 0; at < text.size();) {
    T term = 1;
    if (text[at] == '-') term = -1;
    if (text[at] == '-' || text[at] == '+') ++at;
    std::size_t end = text.find_first_of("+-", at);
    if (end == std::string::npos) end = text.size();
    while (at < end) {
      const std::size_t stop = std::min(end, text.find('*', at));
      const std::string factor = text.substr(at, stop - at);
      const auto caret = factor.find('^');
      if (factor[0] >= '0' && factor[0] <= '9')
        term *= convert<T>(factor);
      else
        term *= power(point.at(factor.substr(0, caret)),
                      caret == std::string::npos ? 1 : std::stol(factor.substr(caret + 1)));
      at = stop + (stop < end ? 1 : 0);
    }
    sum += term;
  }
  return sum;
}

struct Part {
  std::vector<long> frequency;
  long order;
};

class Oracle {
 public:
  explicit Oracle(const std::string& text) : document_(twoscale::check::parse_json(text)) {
    arity_ = member(document_, "arity").number;
    for (const Value& v : member(document_, "variables").items) {
      names_.push_back(member(v, "name").text);
      level_.push_back(member(v, "scope").text == "level");
    }
    shift_ = rational(member(document_, "shift").text);
    const Rational e = shift_ * (arity_ - 1);
    e_numerator_ = static_cast<long>(numerator(e));
    q_ = static_cast<long>(denominator(e));
    const Value& mask = member(document_, "mask");
    lowest_ = member(mask, "lowest").number;
    for (const Value& n : member(mask, "numerators").items) numerators_.push_back(n.text);
    denominator_ = member(mask, "denominator").text;
  }

  bool all_true() {
    for (const Value& claim : member(document_, "claims").items) {
      if (!claim_true(claim)) return false;
    }
    return true;
  }

 private:
  using Masks = std::map<long, Rational>;

  std::vector<Part> read_space(const Value& value) const {
    std::vector<Part> space;
    for (const Value& item : value.items) {
      Part part;
      for (const Value& n : member(item, "frequency").items) part.frequency.push_back(n.number);
      part.order = member(item, "order").number;
      space.push_back(part);
    }
    return space;
  }

  /// Points: one rational for each variable (Y for level variables).
  std::vector<std::vector<Rational>> points() const {
    const std::vector<Rational> pool{Rational(3, 2), Rational(-5, 3), Rational(7, 4), Rational(2), Rational(-4, 5)};
    std::vector<std::vector<Rational>> list;
    for (std::size_t k = 0; k < 3; ++k) {
      std::vector<Rational> point;
      for (std::size_t i = 0; i < names_.size(); ++i) point.push_back(pool[(k + 2 * i) % pool.size()]);
      list.push_back(point);
    }
    return list;
  }

  /// The mask at a point; empty if the denominator vanishes.
  Masks mask_at(const std::vector<Rational>& y) const {
    std::map<std::string, Rational> values;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      const Rational e = power(y[i], q_);
      values[names_[i]] = level_[i] ? Rational((e + 1 / e) / 2) : y[i];
    }
    const Rational d = evaluate(denominator_, values);
    Masks mask;
    if (d == 0) return mask;
    for (std::size_t i = 0; i < numerators_.size(); ++i) {
      mask[lowest_ + static_cast<long>(i)] = evaluate(numerators_[i], values) / d;
    }
    return mask;
  }
  static Rational coefficient(const Masks& mask, long i) {
    const auto found = mask.find(i);
    return found == mask.end() ? Rational(0) : found->second;
  }

  /// w with E^{n} = w^q.
  Rational root(const std::vector<Rational>& y, const std::vector<long>& frequency) const {
    Rational w = 1;
    std::size_t j = 0;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (level_[i]) w *= power(y[i], frequency.at(j++));
    }
    return w;
  }

  template <class F>
  Rational refine(const Masks& mask, long i, const F& data) const {
    Rational sum = 0;
    for (const auto& [index, a] : mask) {
      if ((i - index) % arity_ == 0) sum += a * data((i - index) / arity_);
    }
    return sum;
  }

  /// Samples of x^r exp(theta x) at the level-k parameters go to the samples at level k+1 (both over exp(theta p/m^k)).
  bool reproduced_at(const Masks& mask, const Rational& w, long r) const {
    const auto data = [&](long j) { return Rational(power(Rational(j + shift_), r) * power(w, q_ * arity_ * j)); };
    for (long i = -2 * arity_; i < 2 * arity_; ++i) {
      const Rational expected = power(Rational((i + shift_) / arity_), r) * power(w, q_ * i - e_numerator_);
      if (refine(mask, i, data) != expected) return false;
    }
    return true;
  }
  /// j^r w^{mj} goes into the span of i^s w^i, s <= r: differences of order r+1 vanish; and for r = 0 not to zero.
  bool generated_at(const Masks& mask, const Rational& w, long r) const {
    const Rational e = power(w, q_);
    const auto data = [&](long j) { return Rational(power(Rational(j), r) * power(e, arity_ * j)); };
    std::vector<Rational> g;
    for (long i = 0; i < 3 * arity_ + r + 2; ++i) g.push_back(refine(mask, i, data) * power(e, -i));
    for (long d = 0; d <= r; ++d) {
      for (std::size_t i = 0; i + 1 < g.size(); ++i) g[i] = g[i + 1] - g[i];
      g.pop_back();
    }
    for (const Rational& x : g) {
      if (x != 0) return false;
    }
    return true;
  }

  template <class F>
  bool at_all_points(const F& holds) const {
    for (const auto& y : points()) {
      const Masks mask = mask_at(y);
      if (!mask.empty() && !holds(mask, y)) return false;
    }
    return true;
  }
  bool reproduced(const Part& part, long r) const {
    return at_all_points(
        [&](const Masks& mask, const auto& y) { return reproduced_at(mask, root(y, part.frequency), r); });
  }
  bool generated(const std::vector<Part>& space) const {
    return at_all_points([&](const Masks& mask, const auto& y) {
      for (const Part& part : space) {
        for (long r = 0; r < part.order; ++r) {
          if (!generated_at(mask, root(y, part.frequency), r)) return false;
        }
      }
      return true;
    });
  }
  bool sum_rules_at(const Masks& mask, long order) const {
    for (long r = 0; r < order; ++r) {
      if (!generated_at(mask, 1, r)) return false;
    }
    return true;
  }
  /// All level variables 1, constants arbitrary.
  Masks limit() const {
    auto y = points().front();
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (level_[i]) y[i] = 1;
    }
    return mask_at(y);
  }

  // ---- zeros on the domain, one level variable, floating point
  bool single() const { return names_.size() == 1 && level_[0]; }
  Real domain_end(long k) const {
    return std::cos(std::acos(-1.0L) / std::pow(static_cast<Real>(arity_), static_cast<Real>(k + 1)));
  }

  template <class F>
  bool zeros_are_listed(const F& f, const Value& exceptions, bool need_zero) const {
    std::vector<std::pair<long, Real>> listed;
    for (const Value& item : exceptions.items) {
      const Rational a = rational(member(item, "angle").text);
      const long k = member(item, "level").number;
      const Real angle =
          static_cast<Real>(a) * std::acos(-1.0L) / std::pow(static_cast<Real>(arity_), static_cast<Real>(k + 1));
      listed.emplace_back(k, std::cos(angle));
      if (need_zero && std::fabs(f(std::cos(angle))) > 1e-9L * (std::fabs(f(std::cos(angle) + 0.01L)) + 1e-3L))
        return false;
    }
    const int steps = 4000;
    const Real begin = domain_end(0) + 1e-7L;
    Real last = f(begin), last_v = begin;
    for (int i = 1; i <= steps; ++i) {
      const Real v = begin + (1.0L - begin) * static_cast<Real>(i) / 2000 +
                     (i > 2000 ? static_cast<Real>(i - 2000) * 0.01L : 0.0L);
      const Real now = f(v);
      if ((now > 0) != (last > 0)) {
        for (long k = 0; k == 0 || domain_end(k) < last_v; ++k) {
          bool found = false;
          for (const auto& [level, zero] : listed)
            found = found || (level == k && zero > last_v - 1e-4L && zero < v + 1e-4L);
          if (!found) return false;
          if (k > 20) return false;
        }
      }
      last = now;
      last_v = v;
    }
    return true;
  }

  bool symbol_nonzero(const Part& part, const Value& exceptions) const {
    if (!single()) return true;
    const Real centre = static_cast<Real>(2 * lowest_ + static_cast<long>(numerators_.size()) - 1) / 2;
    const auto f = [&](Real v) {
      const Complex log_e = std::acosh(Complex(v, 0));
      Complex sum = 0;
      for (std::size_t i = 0; i < numerators_.size(); ++i) {
        const Real exponent =
            -static_cast<Real>(part.frequency[0]) * (static_cast<Real>(lowest_) + static_cast<Real>(i) - centre);
        sum += evaluate<Real>(numerators_[i], {{names_[0], v}}) * std::exp(log_e * exponent);
      }
      return sum.real();
    };
    return zeros_are_listed(f, exceptions, false);
  }

  bool well_defined(const Value& exceptions) const {
    if (!single()) return true;
    return zeros_are_listed([&](Real v) { return evaluate<Real>(denominator_, {{names_[0], v}}); }, exceptions, true);
  }

  std::vector<Rational> read_point(const Value& at) const {
    std::vector<Rational> y;
    for (const Value& v : at.items) y.push_back(rational(v.text));
    return y;
  }
  /// Sum over the class of (i-e)^r a_i z^{i-e} or of i^r a_i z^i.
  Rational sum_at(const Masks& mask, const Rational& w, long r, long s, bool centred) const {
    Rational sum = 0;
    const Rational e(e_numerator_, q_);
    for (const auto& [i, a] : mask) {
      if ((i - s) % arity_ != 0) continue;
      const Rational base = centred ? Rational(i) - e : Rational(i);
      sum += power(base, r) * a * power(w, centred ? e_numerator_ - q_ * i : -q_ * i);
    }
    return sum;
  }

  bool claim_true(const Value& claim) {
    const std::string name = member(claim, "claim").text;
    const bool proved = member(claim, "verdict").text == "proved";
    const std::vector<long> zero(static_cast<std::size_t>(std::count(level_.begin(), level_.end(), true)));
    if (!proved) return refutation_true(name, claim, zero);
    if (name == "interpolatory") {
      return at_all_points([&](const Masks& mask, const auto&) {
        for (long j = -50; j <= 50; ++j) {
          if (coefficient(mask, arity_ * j) != (j == 0 ? 1 : 0)) return false;
        }
        return true;
      });
    }
    if (name == "symmetric") {
      const Rational twice = 2 * rational(member(claim, "center").text);
      return denominator(twice) == 1 && at_all_points([&](const Masks& mask, const auto&) {
               for (const auto& [i, a] : mask) {
                 if (coefficient(mask, static_cast<long>(numerator(twice)) - i) != a) return false;
               }
               return true;
             });
    }
    if (name == "sum-rules") {
      const long order = member(claim, "order").number;
      const bool exact = member(claim, "exact").text == "yes";
      return at_all_points([&](const Masks& mask, const auto&) {
        return sum_rules_at(mask, order) && (!exact || !generated_at(mask, 1, order));
      });
    }
    if (name == "well-defined") return well_defined(member(claim, "exceptions"));
    const auto space = read_space(member(claim, "space"));
    if (name == "generates") {
      bool result = generated(space);
      for (const Part& part : space) result = result && symbol_nonzero(part, member(claim, "exceptions"));
      return result;
    }
    if (name == "reproduces") {
      for (const Part& part : space) {
        for (long r = 0; r < part.order; ++r) {
          if (!reproduced(part, r)) return false;
        }
      }
      for (long r = 0; r < member(claim, "confluent").number; ++r) {
        if (!reproduced_at(limit(), 1, r)) return false;
      }
      return true;
    }
    if (name == "maximal") {
      long size = 0;
      for (const Part& part : space) size += part.order;
      if (!generated(space) || !sum_rules_at(limit(), size) || generated_at(limit(), 1, size)) return false;
      std::map<std::vector<long>, long> inside;
      for (const Part& part : read_space(member(claim, "reproduced"))) {
        inside[part.frequency] = part.order;
        for (long r = 0; r < part.order; ++r) {
          if (!reproduced(part, r)) return false;
        }
      }
      for (const Part& part : space) {
        const long reached = inside[part.frequency];
        inside.erase(part.frequency);
        if (reached > part.order || (reached < part.order && reproduced(part, reached))) return false;
      }
      return inside.empty();
    }
    return false;
  }

  bool refutation_true(const std::string& name, const Value& claim, const std::vector<long>& zero) {
    const Value& witness = member(claim, "witness");
    if (name == "maximal") {
      const auto larger = read_space(member(witness, "larger"));
      std::map<std::vector<long>, long> inside;
      for (const Part& part : read_space(member(claim, "space"))) inside[part.frequency] = part.order;
      bool more = false;
      for (const Part& part : larger) more = more || part.order > inside[part.frequency];
      return more && generated(larger);
    }
    if (name == "well-defined") {
      const Real a = static_cast<Real>(rational(member(witness, "angle").text));
      const long k = member(witness, "level").number;
      const Real v = std::cos(a * std::acos(-1.0L) / std::pow(static_cast<Real>(arity_), static_cast<Real>(k + 1)));
      return std::fabs(evaluate<Real>(denominator_, {{names_[0], v}})) < 1e-12L;
    }
    const auto y = read_point(member(witness, "at"));
    const Masks mask = mask_at(y);
    if (mask.empty()) return false;
    if (name == "interpolatory") {
      const long i = member(witness, "index").number;
      const Rational a = rational(member(witness, "value").text);
      return i % arity_ == 0 && coefficient(mask, i) == a && a != (i == 0 ? 1 : 0);
    }
    if (name == "symmetric") {
      const long i = member(witness, "index").number;
      const long mirror = 2 * lowest_ + static_cast<long>(numerators_.size()) - 1 - i;
      const Rational a = rational(member(witness, "value").text), b = rational(member(witness, "mirror").text);
      return coefficient(mask, i) == a && coefficient(mask, mirror) == b && a != b;
    }
    const long r = member(witness, "power").number;
    std::vector<long> frequency = zero;
    if (name == "sum-rules") {
      if (r >= member(claim, "order").number) return false;
    } else {
      frequency.clear();
      for (const Value& n : member(witness, "frequency").items) frequency.push_back(n.number);
      bool inside = false;
      for (const Part& part : read_space(member(claim, "space"))) {
        inside = inside || (part.frequency == frequency && r < part.order);
      }
      if (!inside) return false;
    }
    const Rational w = root(y, frequency);
    if (name == "reproduces") {
      const Rational value = rational(member(witness, "value").text);
      return sum_at(mask, w, r, member(witness, "residue").number, true) == value && value != (r == 0 ? 1 : 0);
    }
    const Rational a = rational(member(witness, "values").items.at(0).text),
                   b = rational(member(witness, "values").items.at(1).text);
    return a != b && sum_at(mask, w, r, member(witness, "residues").items.at(0).number, false) == a &&
           sum_at(mask, w, r, member(witness, "residues").items.at(1).number, false) == b;
  }

  Value document_;
  long arity_ = 2;
  std::vector<std::string> names_;
  std::vector<bool> level_;
  Rational shift_;
  long e_numerator_ = 0;
  long q_ = 1;
  long lowest_ = 0;
  std::vector<std::string> numerators_;
  std::string denominator_;
};

/// Are all claims of the certificate true, as far as this can tell?
inline bool all_true(const std::string& text) { return Oracle(text).all_true(); }

}  // namespace oracle
