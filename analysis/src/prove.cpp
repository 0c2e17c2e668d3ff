// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/analysis/prove.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>

#include "domain_sign.hpp"
#include "twoscale/analysis/certificate.hpp"
#include "twoscale/analysis/exponential_sums.hpp"
#include "twoscale/analysis/hermite_claims.hpp"
#include "twoscale/analysis/knots.hpp"
#include "twoscale/analysis/regularity.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/interpolatory.hpp"

namespace twoscale::analysis {

using Json = nlohmann::ordered_json;

std::string to_string(Verdict v) {
  return v == Verdict::proved ? "proved" : v == Verdict::refuted ? "refuted" : "undecided";
}

namespace {

Polynomial integer_polynomial(const Rational& n) { return Polynomial::constant(n.numerator()); }

// exp(theta/m^{k+1}) = E_variable^multiple; multiple 0: theta = 0, whatever the variable.
struct Frequency {
  size_t variable = 0;
  long multiple = 0;
  unsigned order = 1;
};

// A rational point: one value Y per variable in certificate order (level: E = Y^q; constant: its value).
struct Point {
  std::vector<Rational> y;
  std::vector<std::pair<std::string, Rational>> values;  // of the variables of the mask, v = (E + 1/E)/2
  Json json() const {
    Json a = Json::array();
    for (const auto& r : y) a.push_back(r.to_string());
    return a;
  }
  std::string text() const {
    std::string s;
    for (const auto& [name, value] : values) s += (s.empty() ? "" : ", ") + name + " = " + value.to_string();
    return s;
  }
};

// The mask with everything the claims ask of it.
class Mask {
 public:
  Mask(const Scheme& scheme, std::vector<LevelVariable> levels, const std::vector<unsigned>& scale)
      : scheme_(scheme), m_(scheme.arity), exponent_(Rational(scheme.arity - 1) * scheme.shift) {
    q_ = Rational(exponent_.denominator()).to_long();
    data_ = mask_data(scheme);
    data_.levels = std::move(levels);
    data_.denominator = rescaled(data_.denominator, scale);
    for (auto& n : data_.numerators) n = rescaled(n, scale);
    denominator_factors_ = data_.denominator.factor().factors;
    std::sort(data_.levels.begin(), data_.levels.end(), [](const auto& x, const auto& y) { return x.name < y.name; });
    for (const auto& v : data_.levels) second_kind_.emplace_back(v.name);
    if (second_kind_.empty()) second_kind_.emplace_back("v");
  }

  const Scheme& scheme() const { return scheme_; }
  const MaskData& data() const { return data_; }
  long arity() const { return m_; }
  long lowest() const { return data_.lowest; }
  long highest() const { return data_.lowest + static_cast<long>(data_.numerators.size()) - 1; }
  const Polynomial& denominator() const { return data_.denominator; }
  const RationalFunction::Factors& denominator_factors() const { return denominator_factors_; }
  Polynomial numerator(long i) const {
    return i < lowest() || i > highest() ? Polynomial(0) : data_.numerators[static_cast<size_t>(i - lowest())];
  }
  size_t variable_index(const std::string& name) const {
    for (size_t i = 0; i < data_.levels.size(); ++i)
      if (data_.levels[i].name == name) return i;
    throw std::logic_error("variable_index: " + name);
  }
  const Rational& exponent() const { return exponent_; }  // e = (m-1) p
  long root() const { return q_; }                        // E = Y^q makes z^e a power of Y

  // sum_{i = s mod m} i^r N_i z^i.
  QuadraticElement generation_sum(const Frequency& f, unsigned r, long s) {
    std::vector<Term> terms;
    for (long i = lowest(); i <= highest(); ++i)
      if (mod(i - s) == 0) terms.push_back({numerator(i) * integer_polynomial(Rational(i).pow(r)), -f.multiple * i});
    return exponential_sum(terms, second_kind_[f.variable]);
  }

  // D (sum_{i = s mod m} (i-e)^r a_i z^{i-e} - [r=0]) z^e up to an integer factor.
  QuadraticElement reproduction_residual(const Frequency& f, unsigned r, long s) {
    const bool fractional = r == 0 && f.multiple != 0 && q_ > 1;
    const long stretch = fractional ? q_ : 1;
    const std::string name = data_.levels.empty() ? "" : data_.levels[f.variable].name;
    const auto adapt = [&](const Polynomial& p) {
      return fractional ? p.substitute(name, Polynomial::chebyshev(name, static_cast<unsigned>(q_))) : p;
    };
    std::vector<Term> terms;
    for (long i = lowest(); i <= highest(); ++i) {
      if (mod(i - s) != 0) continue;
      const Rational weight = ((Rational(i) - exponent_) * Rational(q_)).pow(r);
      terms.push_back({adapt(numerator(i)) * integer_polynomial(weight), -f.multiple * i * stretch});
    }
    if (r == 0)
      terms.push_back(
          {-adapt(denominator()), f.multiple == 0 ? 0 : -f.multiple * (exponent_ * Rational(stretch)).to_long()});
    return exponential_sum(terms, second_kind_[f.variable]);
  }

  std::vector<Point> points() const {
    // Corner-free rationals: away from v = 1 (E = 1) and from each other.
    static const std::vector<Rational> y = {Rational(2),    Rational(3), Rational(3, 2),
                                            Rational(5, 2), Rational(5), Rational(7, 3)};
    static const std::vector<Rational> c = {Rational(1, 3), Rational(2), Rational(-1, 5),
                                            Rational(3, 7), Rational(0), Rational(1)};
    std::vector<Point> list;
    for (size_t k = 0; k < y.size(); ++k) {
      Point p;
      struct Named {
        std::string name;
        bool level;
      };
      std::vector<Named> names;
      for (const auto& v : data_.levels) names.push_back({v.name, true});
      for (const auto& n : data_.constants) names.push_back({n, false});
      std::sort(names.begin(), names.end(), [](const Named& a, const Named& b) { return a.name < b.name; });
      for (size_t i = 0; i < names.size(); ++i) {
        if (names[i].level) {
          const Rational root = y[(k + i) % y.size()];
          const Rational e = root.pow(q_);
          p.y.push_back(root);
          p.values.emplace_back(names[i].name, (e + e.inverse()) / Rational(2));
        } else {
          p.y.push_back(c[(k + i) % c.size()]);
          p.values.emplace_back(names[i].name, p.y.back());
        }
      }
      if (!denominator().evaluate(p.values).is_zero()) list.push_back(std::move(p));
    }
    return list;
  }

  Rational coefficient(long i, const Point& at) const {
    return numerator(i).evaluate(at.values) / denominator().evaluate(at.values);
  }
  // Y of the frequency's variable.
  Rational root_of(const Frequency& f, const Point& at) const {
    if (f.multiple == 0) return 1;
    const std::string& name = data_.levels[f.variable].name;
    for (size_t i = 0; i < at.values.size(); ++i)
      if (at.values[i].first == name) return at.y[i];
    return 1;
  }
  Rational generation_value(const Frequency& f, unsigned r, long s, const Point& at) const {
    const Rational y = root_of(f, at);
    Rational sum;
    for (long i = lowest(); i <= highest(); ++i)
      if (mod(i - s) == 0) sum += Rational(i).pow(r) * coefficient(i, at) * y.pow(-f.multiple * i * q_);
    return sum;
  }
  Rational reproduction_value(const Frequency& f, unsigned r, long s, const Point& at) const {
    const Rational y = root_of(f, at);
    Rational sum;
    for (long i = lowest(); i <= highest(); ++i) {
      if (mod(i - s) != 0) continue;
      const Rational distance = Rational(i) - exponent_;
      sum += distance.pow(r) * coefficient(i, at) * y.pow(-f.multiple * (distance * Rational(q_)).to_long());
    }
    return sum;
  }

  long mod(long i) const { return ((i % m_) + m_) % m_; }

  // All level variables set to 1.
  Polynomial at_limit(Polynomial p) const {
    for (const auto& v : scheme_.parameters)
      if (v.scope == Parameter::Scope::level) p = p.substitute(v.name, 1);
    return p;
  }

 private:
  Polynomial rescaled(Polynomial p, const std::vector<unsigned>& scale) const {
    for (size_t i = 0; i < scale.size(); ++i)
      if (scale[i] > 1) p = p.substitute(data_.levels[i].name, Polynomial::chebyshev(data_.levels[i].name, scale[i]));
    return p;
  }

  const Scheme& scheme_;
  long m_;
  Rational exponent_;
  long q_ = 1;
  MaskData data_;
  RationalFunction::Factors denominator_factors_;
  std::vector<SecondKind> second_kind_;
};

// --- spaces
// -------------------------------------------------------------------------------------------------------------

// One representative of each pair +-theta: the condition for -theta is that for theta under E -> 1/E, which fixes v.
std::vector<Frequency> half_frequencies(const Space& space, const Mask& mask) {
  std::vector<Frequency> list;
  if (space.polynomial_order() > 0) list.push_back({0, 0, space.polynomial_order()});
  for (const auto& e : space.exponentials())
    list.push_back({mask.variable_index(space.variables()[e.variable].name), static_cast<long>(e.multiple), e.order});
  return list;
}

Json frequency_vector(const Mask& mask, const Frequency& f, long sign) {
  Json v = Json::array();
  for (size_t i = 0; i < mask.data().levels.size(); ++i) v.push_back(i == f.variable ? sign * f.multiple : 0);
  return v;
}

Json space_json(const Mask& mask, const std::vector<Frequency>& half) {
  std::vector<std::pair<std::vector<long>, unsigned>> entries;
  for (const auto& f : half)
    for (const long sign : {-1L, 1L}) {
      if (f.multiple == 0 && sign < 0) continue;
      entries.emplace_back(frequency_vector(mask, f, sign).get<std::vector<long>>(), f.order);
    }
  std::sort(entries.begin(), entries.end());
  Json a = Json::array();
  for (const auto& [n, order] : entries) a.push_back(Json::object({{"frequency", n}, {"order", order}}));
  return a;
}

unsigned dimension(const std::vector<Frequency>& half) {
  unsigned n = 0;
  for (const auto& f : half) n += f.order * (f.multiple == 0 ? 1 : 2);
  return n;
}

bool same_frequency(const Frequency& a, const Frequency& b) {
  return a.multiple == b.multiple && (a.multiple == 0 || a.variable == b.variable);
}

std::string function_text(const Mask& mask, const Frequency& f, unsigned r) {
  const std::string x = r == 0 ? "" : r == 1 ? "x" : "x^" + std::to_string(r);
  if (f.multiple == 0) return r == 0 ? "1" : x;
  LevelVariable v = mask.data().levels[f.variable];
  v.factor *= Rational(f.multiple);
  return (r == 0 ? "" : x + "*") + "exp(" + (v.trigonometric ? "I*" : "") +
         (v.frequency() == "1" ? "x" : v.frequency() + "*x") + ")";
}

// --- zeros on the domain
// --------------------------------------------------------------------------------------------------

unsigned totient(unsigned n) {
  unsigned r = n;
  for (unsigned p = 2; p * p <= n; ++p)
    if (n % p == 0) {
      while (n % p == 0) n /= p;
      r -= r / p;
    }
  if (n > 1) r -= r / n;
  return r;
}

struct Zeros {
  std::set<std::pair<Rational, unsigned>> values;  // (angle, level): v^0 = cos(angle pi)
  std::set<std::string> others;                    // factors with a zero that is no cosine of a rational angle
  bool complete = true;                            // false: whether a factor vanishes on the domain was not decided
};

// Zeros of the irreducible f(v) on the domain: v > cos(pi/m^{k+1}) at level k.
void add_zeros(const Polynomial& f, long m, Zeros& zeros) {
  if (f.positive_zeros() == 0) return;
  const auto degree = static_cast<unsigned>(f.total_degree());
  const std::string& x = f.variables()[0];
  for (unsigned d = 3; d <= 8 * degree * degree + 8; ++d) {
    if (totient(d) != 2 * degree || !(Polynomial::cosine_minimal(x, d) == f)) continue;
    for (long step = m; 2 * step < static_cast<long>(d); step *= m) {
      unsigned level = 0;
      for (long s = step; s > m; s /= m) ++level;
      for (long j = 1; 2 * step * j < static_cast<long>(d); ++j)
        if (std::gcd(j, static_cast<long>(d)) == 1)
          zeros.values.emplace(Rational(2 * step * j, static_cast<long>(d)), level);
    }
    return;
  }
  // The domain of level 0, which contains all others: v > cos(pi/m), 0 for m = 2, 1/2 for m = 3.
  if (m > 3) {
    zeros.complete = false;
    return;
  }
  const RationalFunction shifted = RationalFunction(f).substitute(
      x, RationalFunction::variable(x) + RationalFunction(m == 2 ? Rational(0) : Rational(1, 2)));
  if (shifted.numerator().positive_zeros() > 0) zeros.others.insert(f.to_string());
}

// What the set of exceptions is: v^0 and level, or conditions when several variables or constants are involved.
struct Exceptions {
  Zeros zeros;
  std::set<std::string> conditions;
  bool by_condition = false;
  void add(const RationalFunction::Factors& factors, const Mask& mask) {
    by_condition = mask.data().levels.size() != 1 || !mask.data().constants.empty();
    std::vector<std::pair<Polynomial, unsigned>> of_levels;
    for (const auto& [f, e] : factors) {
      if (!by_condition) {
        add_zeros(f, mask.arity(), zeros);
        continue;
      }
      const bool level_only = std::none_of(f.variables().begin(), f.variables().end(), [&](const auto& n) {
        return std::find(mask.data().constants.begin(), mask.data().constants.end(), n) != mask.data().constants.end();
      });
      if (level_only)
        of_levels.emplace_back(f, e);
      else
        conditions.insert(f.to_string());
    }
    for (const Polynomial& f : factors_to_list(of_levels, static_cast<int>(mask.arity())))
      conditions.insert(f.to_string());
  }
  Json json() const {
    Json a = Json::array();
    if (by_condition) {
      for (const auto& c : conditions) a.push_back(Json::object({{"condition", c}}));
      return a;
    }
    for (auto it = zeros.values.rbegin(); it != zeros.values.rend();) {
      // descending angle, ascending level within one angle
      auto first = it;
      while (it != zeros.values.rend() && it->first == first->first) ++it;
      std::vector<unsigned> levels;
      for (auto j = first; j != it; ++j) levels.push_back(j->second);
      std::sort(levels.begin(), levels.end());
      for (const unsigned level : levels)
        a.push_back(Json::object({{"level", level}, {"angle", first->first.to_string()}}));
    }
    for (const auto& c : zeros.others) a.push_back(Json::object({{"condition", c}}));
    return a;
  }
  std::vector<std::string> text() const {
    std::vector<std::string> list;
    for (const auto& item : json()) {
      if (item.contains("condition"))
        list.push_back(item["condition"].get<std::string>() + " = 0");
      else
        list.push_back("v0 = " + cosine_text(Rational::parse(item["angle"].get<std::string>())) + " (level " +
                       std::to_string(item["level"].get<int>()) + ")");
    }
    return list;
  }
};

// --- claims
// -------------------------------------------------------------------------------------------------------------

struct Failure {
  Frequency frequency;
  unsigned power = 0;
  long residue = 0;
  long other = 0;
};

std::optional<Failure> generation_failure(Mask& mask, const std::vector<Frequency>& half) {
  for (const auto& f : half)
    for (unsigned r = 0; r < f.order; ++r) {
      const QuadraticElement first = mask.generation_sum(f, r, 0);
      for (long s = 1; s < mask.arity(); ++s) {
        const QuadraticElement other = mask.generation_sum(f, r, s);
        if (!(other.a == first.a && other.b == first.b)) return Failure{f, r, 0, s};
      }
    }
  return std::nullopt;
}

std::optional<Failure> reproduction_failure(Mask& mask, const std::vector<Frequency>& half) {
  for (const auto& f : half)
    for (unsigned r = 0; r < f.order; ++r)
      for (long s = 0; s < mask.arity(); ++s)
        if (!mask.reproduction_residual(f, r, s).is_zero()) return Failure{f, r, s, s};
  return std::nullopt;
}

// Orders up to which each frequency is reproduced (generated): its part of the space.
std::vector<Frequency> largest_part(
    Mask& mask, const std::vector<Frequency>& half,
    const std::function<std::optional<Failure>(Mask&, const std::vector<Frequency>&)>& failure) {
  std::vector<Frequency> part;
  for (Frequency f : half) {
    const auto bad = failure(mask, {f});
    if (bad) f.order = bad->power;
    if (f.order > 0) part.push_back(f);
  }
  return part;
}

struct SumRules {
  unsigned order = 0;   // largest N with sum_{i = s} i^r N_i independent of s for r < N
  Polynomial obstacle;  // what must vanish for order N + 1: the gcd of the differences at r = N
};

SumRules sum_rules_of(const Mask& mask, const std::function<Polynomial(const Polynomial&)>& view) {
  std::vector<Polynomial> n;
  bool zero = true;
  for (long i = mask.lowest(); i <= mask.highest(); ++i) {
    n.push_back(view(mask.numerator(i)));
    zero = zero && n.back().is_zero();
  }
  if (zero) return {};
  for (unsigned r = 0;; ++r) {
    std::vector<Polynomial> sums(static_cast<size_t>(mask.arity()));
    for (long i = mask.lowest(); i <= mask.highest(); ++i)
      sums[static_cast<size_t>(mask.mod(i))] +=
          n[static_cast<size_t>(i - mask.lowest())] * integer_polynomial(Rational(i).pow(r));
    Polynomial obstacle;
    for (const auto& x : sums) obstacle = Polynomial::gcd(obstacle, x - sums[0]);
    if (!obstacle.is_zero()) return {r, obstacle};
  }
}

std::string every_level(const Mask& mask) {
  if (mask.data().levels.empty()) {
    std::string sequences;
    for (const auto& p : mask.scheme().parameters)
      if (p.relation) sequences += (sequences.empty() ? "" : ", ") + p.name;
    if (!sequences.empty()) return "all levels, whatever the values of " + sequences + " at the levels";
    return mask.data().constants.empty() ? "stationary: all levels" : "all levels, identically in the parameters";
  }
  std::string names;
  if (mask.data().levels.size() == 1) return "all levels k >= 0, all v0 > -1 for which the mask is defined";
  for (const auto& v : mask.data().levels) names += (names.empty() ? "" : ", ") + std::string("v0 of ") + v.name;
  return "all levels k >= 0, all values > -1 of " + names + " for which the mask is defined";
}

Json entry(const std::string& claim, Verdict v) { return Json::object({{"claim", claim}, {"verdict", to_string(v)}}); }

class Prover {
 public:
  // own_space: the space the scheme was made from, in the mask's level variables, if it was.
  Prover(Mask& mask, std::optional<Space> own_space) : mask_(mask), own_space_(std::move(own_space)) {}

  Decision interpolatory() {
    Decision d = start("interpolatory", "");
    for (long i = mask_.lowest(); i <= mask_.highest(); ++i) {
      if (mask_.mod(i) != 0) continue;
      const Polynomial expected = i == 0 ? mask_.denominator() : Polynomial(0);
      if (mask_.numerator(i) == expected) continue;
      return refute_index(std::move(d), i, expected);
    }
    if (mask_.numerator(0).is_zero()) {
      d.verdict = Verdict::undecided;
      d.witness = "index 0 lies outside the support";
      return d;
    }
    return proved(std::move(d), "definition");
  }

  Decision symmetric() {
    const Rational c(mask_.lowest() + mask_.highest(), 2);
    Decision d = start("symmetric", "");
    for (long i = mask_.lowest(); i <= mask_.highest(); ++i) {
      const long j = mask_.lowest() + mask_.highest() - i;
      if (mask_.numerator(i) == mask_.numerator(j)) continue;
      for (const Point& at : mask_.points()) {
        const Rational x = mask_.coefficient(i, at);
        const Rational y = mask_.coefficient(j, at);
        if (x == y) continue;
        d.verdict = Verdict::refuted;
        d.witness = place(at) + "a_" + std::to_string(i) + " = " + x.to_string() + " but a_" + std::to_string(j) +
                    " = " + y.to_string();
        d.evidence = entry(d.claim, d.verdict);
        d.evidence["witness"] =
            Json::object({{"at", at.json()}, {"index", i}, {"value", x.to_string()}, {"mirror", y.to_string()}});
        d.evidence["theorem"] = "definition";
        return d;
      }
    }
    d.subject = "about " + c.to_string();
    d.evidence = entry(d.claim, Verdict::proved);
    d.evidence["center"] = c.to_string();
    return proved(std::move(d), "definition");
  }

  Decision sum_rules(const std::string& subject) {
    const unsigned largest = sum_rules_of(mask_, [](const Polynomial& p) { return p; }).order;
    unsigned order = largest;
    if (!subject.empty()) {
      const Rational n = Rational::parse(subject);
      if (!n.is_integer() || n.sign() < 0 || n > Rational(512))
        bad_input("sum-rules: the order must be an integer from 0 to 512", subject);
      order = static_cast<unsigned>(n.to_long());
    }
    Decision d = start("sum-rules", std::to_string(order));
    d.evidence = entry(d.claim, order <= largest ? Verdict::proved : Verdict::refuted);
    d.evidence["order"] = order;
    if (order <= largest) {
      d.evidence["exact"] = order == largest ? "yes" : "no";
      return proved(std::move(d), "definition");
    }
    return refute_generation(std::move(d), {{0, 0, order}, largest, 0, 0}, "definition", false);
  }

  Decision generates(const Space& space) {
    Decision d = start("generates", space.to_string());
    const auto half = half_frequencies(space, mask_);
    if (const auto bad = generation_failure(mask_, half)) {
      d.evidence = entry(d.claim, Verdict::refuted);
      d.evidence["space"] = space_json(mask_, half);
      return refute_generation(std::move(d), *bad, "generation-stepwise", true);
    }
    // a(z_n) must not vanish. z^{-c} a(z) = sum N_i cosh(n (i - c) phi) for v = cosh(phi), a polynomial in v; when 2cn
    // is odd, after division by cosh(phi/2), which is positive on the domain.
    Exceptions exceptions;
    exceptions.by_condition = mask_.data().levels.size() != 1 || !mask_.data().constants.empty();
    bool decided = true;
    const long twice_centre = mask_.lowest() + mask_.highest();
    bool is_symmetric = true;
    for (long i = mask_.lowest(); i <= mask_.highest(); ++i)
      is_symmetric = is_symmetric && mask_.numerator(i) == mask_.numerator(twice_centre - i);
    for (const auto& f : half) {
      Polynomial p;
      if (f.multiple == 0) {
        for (const auto& n : mask_.data().numerators) p += n;
      } else if (is_symmetric) {
        const Polynomial v = Polynomial::variable(mask_.data().levels[f.variable].name);
        const bool odd = (f.multiple * twice_centre) % 2 != 0;
        std::vector<Polynomial> cosines{1, odd ? v + v - Polynomial(1) : v};  // of h phi; of (2h+1) phi/2, divided
        for (long i = mask_.lowest(); i <= mask_.highest(); ++i) {
          const auto h = static_cast<size_t>(std::labs(f.multiple * (2 * i - twice_centre)) / 2);
          while (cosines.size() <= h)
            cosines.push_back(Polynomial(2) * v * cosines.back() - cosines[cosines.size() - 2]);
          p += mask_.numerator(i) * cosines[h];
        }
      } else {
        decided = false;
        break;
      }
      if (p.is_zero()) {
        decided = false;
        d.witness = "a(z) vanishes identically at " + function_text(mask_, f, 0);
        break;
      }
      exceptions.add(p.factor().factors, mask_);
    }
    if (!decided || !exceptions.zeros.complete) {
      d.verdict = Verdict::undecided;
      if (d.witness.empty()) d.witness = "the zeros are there, but where a(z) may vanish could not be listed";
      return d;
    }
    d.exceptions = exceptions.text();
    d.evidence = entry(d.claim, Verdict::proved);
    d.evidence["space"] = space_json(mask_, half);
    d.evidence["exceptions"] = exceptions.json();
    return proved(std::move(d), "generation-stepwise");
  }

  Decision reproduces(const Space& space) {
    Decision d = start("reproduces", space.to_string());
    const auto half = half_frequencies(space, mask_);
    const auto bad = reproduction_failure(mask_, half);
    d.evidence = entry(d.claim, bad ? Verdict::refuted : Verdict::proved);
    d.evidence["space"] = space_json(mask_, half);
    if (bad) return refute_reproduction(std::move(d), *bad);
    unsigned confluent = 0;
    if (!mask_.at_limit(mask_.denominator()).is_zero() && !mask_.data().levels.empty()) {
      const auto fails_at_limit = [&](unsigned r) {
        for (long s = 0; s < mask_.arity(); ++s) {
          Polynomial sum;
          for (long i = mask_.lowest(); i <= mask_.highest(); ++i)
            if (mask_.mod(i - s) == 0)
              sum += mask_.at_limit(mask_.numerator(i)) *
                     integer_polynomial(((Rational(i) - mask_.exponent()) * Rational(mask_.root())).pow(r));
          if (!(sum == (r == 0 ? mask_.at_limit(mask_.denominator()) : Polynomial(0)))) return true;
        }
        return false;
      };
      while (confluent < dimension(half) && !fails_at_limit(confluent)) ++confluent;
    }
    d.evidence["confluent"] = confluent;
    if (confluent > 0) d.domain += "; at v = 1 all polynomials of degree < " + std::to_string(confluent);
    return proved(std::move(d), "reproduction-stepwise");
  }

  Decision maximal(const Space& space) {
    Decision d = start("maximal", space.to_string());
    auto half = half_frequencies(space, mask_);
    if (const auto bad = generation_failure(mask_, half)) {
      d.evidence = entry("generates", Verdict::refuted);
      d.evidence["space"] = space_json(mask_, half);
      return refute_generation(std::move(d), *bad, "generation-stepwise", true);
    }
    if (mask_.at_limit(mask_.denominator()).is_zero()) {
      d.verdict = Verdict::undecided;
      d.witness = "the limit mask has a pole";
      return d;
    }
    const auto [limit_order, obstacle] = sum_rules_of(mask_, [&](const Polynomial& p) { return mask_.at_limit(p); });
    const unsigned n = dimension(half);
    if (limit_order > n) {
      auto larger = half;
      for (auto& f : larger) f.order += limit_order;
      std::vector<Frequency> others{{0, 0, limit_order}};
      if (own_space_) {
        const auto own = half_frequencies(*own_space_, mask_);
        others.insert(others.end(), own.begin(), own.end());
      }
      for (const auto& o : others)
        if (std::none_of(larger.begin(), larger.end(), [&](const auto& f) { return same_frequency(f, o); }))
          larger.push_back(o);
      larger = largest_part(mask_, larger, generation_failure);
      if (dimension(larger) > n) {
        std::string more;
        for (const auto& f : larger) {
          unsigned have = 0;
          for (const auto& g : half)
            if (same_frequency(f, g)) have = g.order;
          for (unsigned r = have; r < f.order; ++r) more += (more.empty() ? "" : ", ") + function_text(mask_, f, r);
        }
        d.verdict = Verdict::refuted;
        d.witness = "also generated: " + more;
        d.evidence = entry(d.claim, d.verdict);
        d.evidence["space"] = space_json(mask_, half);
        d.evidence["witness"] = Json::object({{"larger", space_json(mask_, larger)}});
        d.evidence["theorem"] = "hurwitz-count";
        return d;
      }
      d.verdict = Verdict::undecided;
      d.witness = "the limit mask leaves room for " + std::to_string(limit_order - n) + " more functions";
      return d;
    }
    // Values of constants at which the limit mask has more sum rules: there more may be generated.
    if (!obstacle.is_constant())
      for (const auto& [f, e] : obstacle.factor().factors) d.exceptions.push_back(f.pretty() + " = 0");
    const auto reproduced = largest_part(mask_, half, reproduction_failure);
    std::string w;
    for (const auto& f : reproduced)
      for (unsigned r = 0; r < f.order; ++r)
        w += (w.empty() ? "" : ", ") + function_text(mask_, f, r) + (f.multiple == 0 ? "" : " (+-)");
    d.domain += "; of it are reproduced: " + (w.empty()                    ? std::string("none")
                                              : dimension(reproduced) == n ? std::string("all")
                                                                           : w);
    d.evidence = entry(d.claim, Verdict::proved);
    d.evidence["space"] = space_json(mask_, half);
    d.evidence["reproduced"] = space_json(mask_, reproduced);
    return proved(std::move(d), "hurwitz-count");
  }

  Decision well_defined() {
    Decision d = start("well-defined", "");
    Exceptions exceptions;
    exceptions.by_condition = mask_.data().levels.size() != 1 || !mask_.data().constants.empty();
    exceptions.add(mask_.denominator_factors(), mask_);
    if (!exceptions.zeros.complete) {
      d.verdict = Verdict::undecided;
      d.witness = "a denominator may have a zero on the domain that is no cosine of a rational angle: " +
                  mask_.denominator().to_string();
      return d;
    }
    d.domain = mask_.data().levels.empty() ? "all parameter values"
                                           : "all levels k >= 0, all start values > -1 of the level variables";
    d.exceptions = exceptions.text();
    d.evidence = entry(d.claim, Verdict::proved);
    d.evidence["exceptions"] = exceptions.json();
    const bool few = mask_.data().levels.size() + mask_.data().constants.size() <= 1 && mask_.data().constants.empty();
    return proved(std::move(d), few ? "sturm" : "positive-coefficients");
  }

 private:
  Decision start(std::string claim, std::string subject) const {
    Decision d;
    d.claim = std::move(claim);
    d.subject = std::move(subject);
    d.domain = every_level(mask_);
    return d;
  }

  static Decision proved(Decision d, const char* theorem) {
    d.verdict = Verdict::proved;
    if (d.evidence.is_null()) d.evidence = entry(d.claim, d.verdict);
    d.evidence["theorem"] = theorem;
    return d;
  }

  static std::string place(const Point& at) { return at.values.empty() ? "" : "at " + at.text() + ": "; }

  Decision refute_index(Decision d, long i, const Polynomial&) {
    for (const Point& at : mask_.points()) {
      const Rational x = mask_.coefficient(i, at);
      if (x == Rational(i == 0 ? 1 : 0)) continue;
      d.verdict = Verdict::refuted;
      d.witness = place(at) + "a_" + std::to_string(i) + " = " + x.to_string() + ", not " + (i == 0 ? "1" : "0");
      d.evidence = entry(d.claim, d.verdict);
      d.evidence["witness"] = Json::object({{"at", at.json()}, {"index", i}, {"value", x.to_string()}});
      d.evidence["theorem"] = "definition";
      return d;
    }
    d.verdict = Verdict::undecided;
    d.witness = "the identity fails, but no rational point of the list shows it";
    return d;
  }

  // The failure of an identity does not settle a single number t such as pi/3: only for exp(t) transcendental does it.
  bool settled_by_identity(const Frequency& f) const {
    if (f.multiple == 0) return true;
    const LevelVariable& v = mask_.data().levels[f.variable];
    return !v.symbol.empty() || v.unit == "1";
  }

  Decision refute_generation(Decision d, const Failure& bad, const char* theorem, bool with_frequency) {
    const Frequency& f = bad.frequency;
    if (!settled_by_identity(f)) return unsettled(std::move(d));
    // The two residues of the failure that differ at a point; the first power that fails identically.
    for (const Point& at : mask_.points())
      for (long s = 1; s < mask_.arity(); ++s) {
        const Rational x = mask_.generation_value(f, bad.power, 0, at);
        const Rational y = mask_.generation_value(f, bad.power, s, at);
        if (x == y) continue;
        d.verdict = Verdict::refuted;
        d.witness = place(at) + "for " + function_text(mask_, f, bad.power) + " the sums of i^" +
                    std::to_string(bad.power) + " a_i z^i over i = 0 and i = " + std::to_string(s) + " mod " +
                    std::to_string(mask_.arity()) + " are " + x.to_string() + " and " + y.to_string();
        Json w = Json::object({{"at", at.json()}});
        if (with_frequency) w["frequency"] = frequency_vector(mask_, f, 1);
        w["power"] = bad.power;
        w["residues"] = {0, s};
        w["values"] = {x.to_string(), y.to_string()};
        d.evidence["witness"] = w;
        d.evidence["theorem"] = theorem;
        return d;
      }
    return unsettled(std::move(d));
  }

  Decision refute_reproduction(Decision d, const Failure& bad) {
    const Frequency& f = bad.frequency;
    if (!settled_by_identity(f)) return unsettled(std::move(d));
    for (const Point& at : mask_.points())
      for (long s = 0; s < mask_.arity(); ++s) {
        const Rational x = mask_.reproduction_value(f, bad.power, s, at);
        if (x == Rational(bad.power == 0 ? 1 : 0)) continue;
        d.verdict = Verdict::refuted;
        d.witness = place(at) + "for " + function_text(mask_, f, bad.power) + " the sum of (i - e)^" +
                    std::to_string(bad.power) + " a_i z^(i-e) over i = " + std::to_string(s) + " mod " +
                    std::to_string(mask_.arity()) + ", e = " + mask_.exponent().to_string() + ", is " + x.to_string() +
                    ", not " + (bad.power == 0 ? "1" : "0");
        if (f.multiple != 0) d.witness += "; z = " + mask_.root_of(f, at).pow(-f.multiple * mask_.root()).to_string();
        d.evidence["witness"] = Json::object({{"at", at.json()},
                                              {"frequency", frequency_vector(mask_, f, 1)},
                                              {"power", bad.power},
                                              {"residue", s},
                                              {"value", x.to_string()}});
        d.evidence["theorem"] = "reproduction-stepwise";
        return d;
      }
    return unsettled(std::move(d));
  }

  static Decision unsettled(Decision d) {
    d.verdict = Verdict::undecided;
    d.evidence = nullptr;
    d.witness = "the identity fails in the level variable, which does not settle this one frequency";
    return d;
  }

  Mask& mask_;
  std::optional<Space> own_space_;
};

// continuity=l, or contractive: some power of the difference scheme has norm < 1, which is C^0 with sum rules.
bool is_smoothness(const std::string& claim) { return claim == "continuity" || claim == "contractive"; }

Decision smoothness(const Scheme& scheme, const Claim& claim, bool own_variables) {
  long l = 0;
  if (!claim.subject.empty()) {
    l = Rational::parse(claim.subject).to_long();
    if (l < 0 || l > 64) bad_input("continuity: an integer from 0 to 64 is expected", claim.subject);
  }
  if (!own_variables) {
    Decision d;
    d.claim = claim.name;
    d.subject = claim.subject;
    d.witness = "another claim of this request changes the level variables; ask for this one by itself";
    return d;
  }
  for (const auto& p : scheme.parameters)
    if (p.scope == Parameter::Scope::constant) {
      Decision d;
      d.claim = claim.name;
      d.subject = claim.subject;
      d.witness = "it depends on " + p.name + ": give its value with the scheme, or a range to regularity --over";
      return d;
    }
  Decision d = decide_continuity(scheme, l, {});
  d.claim = claim.name;
  d.subject = claim.name == "continuity" ? d.subject : "";
  return d;
}

bool takes_space(const std::string& claim) {
  return claim == "generates" || claim == "reproduces" || claim == "maximal";
}

}  // namespace

const std::vector<std::string>& claim_names() {
  static const std::vector<std::string> names = {"interpolatory", "symmetric",  "sum-rules",
                                                 "generates",     "reproduces", "maximal",
                                                 "well-defined",  "continuity", "contractive"};
  return names;
}

namespace {

struct Prepared {
  std::vector<LevelVariable> variables;
  std::vector<unsigned> scale;                 // of the scheme's own variables
  std::vector<std::optional<Space>> subjects;  // one per claim
};

// Brings the scheme and all subjects to common level variables.
Prepared prepare(const Scheme& scheme, const std::vector<Claim>& claims) {
  Prepared p;
  const std::vector<LevelVariable> own = level_variables(scheme);
  p.variables = own;
  std::vector<std::optional<Space>> parsed;
  for (const auto& c : claims) {
    std::optional<Space> space;
    if (takes_space(c.name)) {
      if (!c.subject.empty())
        space = Space::parse(c.subject);
      else if (scheme.space)
        space = scheme.space;
      if (space) p.variables = Space::rebase(*space, p.variables).space.variables();
    }
    parsed.push_back(std::move(space));
  }
  for (auto& s : parsed) {
    if (s) s = Space::rebase(*s, p.variables).space;
    p.subjects.push_back(std::move(s));
  }
  for (size_t i = 0; i < own.size(); ++i)
    p.scale.push_back(static_cast<unsigned>((own[i].factor / p.variables[i].factor).to_long()));
  return p;
}

}  // namespace

std::vector<Claim> default_claims(const Scheme& scheme) {
  if (!scheme.claims.empty()) return scheme.claims;
  if (scheme.block > 1) return default_claims_on_vertices(scheme);
  std::vector<Claim> claims;
  const Laurent a = symbol(scheme);
  if (a.centre_of_symmetry()) claims.push_back({"symmetric", "", ""});
  if (is_interpolatory(scheme)) claims.insert(claims.begin(), {"interpolatory", "", ""});
  Mask mask(scheme, level_variables(scheme), std::vector<unsigned>(level_variables(scheme).size(), 1));
  const unsigned n = sum_rules_of(mask, [](const Polynomial& p) { return p; }).order;
  claims.push_back({"sum-rules", std::to_string(n), ""});
  if (n > 0) {
    const Space polynomials = Space::one_frequency(n, {});
    claims.push_back({"generates", polynomials.to_string(), ""});
    const Space reproduced = reproduced_part(scheme, polynomials);
    if (reproduced.dimension() > 0) claims.push_back({"reproduces", reproduced.to_string(), ""});
    claims.push_back({"maximal", polynomials.to_string(), ""});
  }
  claims.push_back({"well-defined", "", ""});
  return claims;
}

Space reproduced_part(const Scheme& scheme, const Space& within) {
  const Prepared p = prepare(scheme, {{"reproduces", within.to_string(), ""}});
  Mask mask(scheme, p.variables, p.scale);
  const auto part = largest_part(mask, half_frequencies(*p.subjects[0], mask), reproduction_failure);
  std::string text;
  for (const auto& f : part)
    for (unsigned r = 0; r < f.order; ++r)
      for (const long sign : {1L, -1L}) {
        if (f.multiple == 0 && sign < 0) continue;
        Frequency g = f;
        g.multiple *= sign;
        text += (text.empty() ? "" : ", ") + function_text(mask, g, r);
      }
  return text.empty() ? Space() : Space::parse(text);
}

Proof prove(const Scheme& scheme, const std::vector<Claim>& claims) {
  if (!scheme.kernel.empty()) return prove_on_knots(scheme, claims);
  if (scheme.block > 1) return prove_on_vertices(scheme, claims);
  for (const auto& c : claims) {
    const auto& names = claim_names();
    if (std::find(names.begin(), names.end(), c.name) == names.end())
      bad_input("claim is not one that can be decided here", c.name);
    if (!takes_space(c.name) && c.name != "sum-rules" && c.name != "continuity" && !c.subject.empty())
      bad_input(c.name + " takes no subject", c.subject);
  }
  const Prepared p = prepare(scheme, claims);
  Mask mask(scheme, p.variables, p.scale);
  Prover prover(mask, scheme.space ? std::optional(Space::rebase(*scheme.space, p.variables).space) : std::nullopt);
  Proof proof;
  std::vector<Json> entries;
  for (size_t i = 0; i < claims.size(); ++i) {
    const Claim& c = claims[i];
    if (takes_space(c.name) && !p.subjects[i])
      bad_input(c.name + " needs a space: " + c.name + "=\"1,x,...\"", scheme.id);
    const bool own_variables = p.variables.size() == p.scale.size() &&
                               std::all_of(p.scale.begin(), p.scale.end(), [](unsigned n) { return n == 1; });
    Decision d = is_smoothness(c.name)       ? smoothness(scheme, c, own_variables)
                 : c.name == "interpolatory" ? prover.interpolatory()
                 : c.name == "symmetric"     ? prover.symmetric()
                 : c.name == "sum-rules"     ? prover.sum_rules(c.subject)
                 : c.name == "generates"     ? prover.generates(*p.subjects[i])
                 : c.name == "reproduces"    ? prover.reproduces(*p.subjects[i])
                 : c.name == "maximal"       ? prover.maximal(*p.subjects[i])
                                             : prover.well_defined();
    if (!d.evidence.is_null() && d.verdict != Verdict::undecided) entries.push_back(d.evidence);
    for (const auto& e : d.supporting)
      if (std::find(entries.begin(), entries.end(), e) == entries.end()) entries.push_back(e);
    proof.decisions.push_back(std::move(d));
  }
  if (!entries.empty()) proof.certificate = certificate_text(scheme, mask.data(), entries);
  return proof;
}

}  // namespace twoscale::analysis
