// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/symbolic/level_relation.hpp"

#include <flint/fmpz.h>

#include <vector>

#include "twoscale/symbolic/error.hpp"

namespace twoscale {

namespace {

constexpr long largest_degree = 64;
constexpr int most_halvings = 400;

RationalFunction x() { return RationalFunction::variable("x"); }

// c_0, c_1, ... of a polynomial in "x".
std::vector<Rational> coefficients(const RationalFunction& p) {
  std::vector<Rational> c(static_cast<size_t>(p.numerator().degree("x")) + 1);
  p.numerator().for_each_term([&](const Rational& a, std::span<const unsigned long> e) {
    c[e.empty() ? 0 : e[0]] = a / p.denominator_content();
  });
  return c;
}

Rational value(const RationalFunction& p, const Rational& at) { return *p.evaluate({{"x", at}}); }

RationalFunction derivative(const RationalFunction& p) {
  return RationalFunction(p.numerator().derivative("x")) / RationalFunction(p.denominator_content());
}

// The positive n-th root if it is rational; q > 0.
std::optional<Rational> rational_root(const Rational& q, unsigned long n) {
  Rational r;
  if (fmpz_root(fmpq_numref(r.raw()), q.numerator(), static_cast<slong>(n)) == 0) return std::nullopt;
  if (fmpz_root(fmpq_denref(r.raw()), q.denominator(), static_cast<slong>(n)) == 0) return std::nullopt;
  return r;
}

// The relation of v for g = scale*v + offset.
RationalFunction conjugate(const RationalFunction& p, const Rational& scale, const Rational& offset) {
  return (p.substitute("x", RationalFunction(scale) * x() + RationalFunction(offset)) - RationalFunction(offset)) /
         RationalFunction(scale);
}

// g = scale*v + offset with P conjugate to T_m: a T_m(v) + b = P(a v + b) fixes the two from the leading coefficients.
std::optional<Spelling> chebyshev_spelling(const RationalFunction& p, int arity, const std::optional<Domain>& domain) {
  const std::vector<Rational> c = coefficients(p);
  const size_t n = c.size() - 1;
  if (n != static_cast<size_t>(arity)) return std::nullopt;
  if (n % 2 == 1 && c[n].sign() < 0) return std::nullopt;
  const auto half = rational_root(abs(c[n]).inverse(), n - 1);
  if (!half) return std::nullopt;
  Spelling s;
  s.scale = Rational(2) * *half * Rational(c[n].sign());
  s.offset = -c[n - 1] / (Rational(static_cast<long>(n)) * c[n]);
  if (!(conjugate(p, s.scale, s.offset) == RationalFunction(Polynomial::chebyshev("x", static_cast<unsigned>(n)))))
    return std::nullopt;
  // T_m is odd for odd m: v -> -v is as good, and the domain tells which is meant.
  if (n % 2 == 1 && domain && (!domain->low || *domain->low < s.offset - s.scale)) s.scale = -s.scale;
  return s;
}

// Why the left half of the domain, {g < fixed}, is not carried to `fixed` by the branch of the inverse that fixes it;
// empty if it is. Looked for is a point x below `fixed` such that P increases on [x, fixed] and P(x) is below the
// domain.
std::string obstacle_on_the_left(const RationalFunction& p, const Rational& fixed, const Domain& domain) {
  if (domain.low && *domain.low >= fixed) return "";
  const Polynomial critical = derivative(p).numerator();
  const Polynomial others = (p - x()).numerator();
  const std::string short_branch = "the relation is not monotone on a branch that reaches the whole domain";
  const auto alone = [&](const std::optional<Rational>& from) {
    return zeros_between(others, from, fixed) == 0 ? "" : "the relation has another fixed point in the domain";
  };
  if (!domain.low) return zeros_between(critical, std::nullopt, fixed) > 0 ? short_branch : alone(std::nullopt);
  const Rational& end = *domain.low;
  const auto beyond = [&](const Rational& at) {  // a critical point lies in [at, fixed)
    return zeros_between(critical, at, fixed) > 0 || value(derivative(p), at).is_zero();
  };
  Rational left = fixed - Rational(1);
  while (!beyond(left) && value(p, left) >= end) left = fixed - Rational(2) * (fixed - left);
  Rational right = fixed;
  for (int i = 0; i < most_halvings; ++i) {
    if (!beyond(left)) return alone(left > end ? left : end);
    const Rational middle = (left + right) / Rational(2);
    if (beyond(middle) || value(p, middle) < end)
      left = middle;
    else
      right = middle;
  }
  // The value at the critical point is the end itself: the branch just suffices if the end does not belong to the
  // domain.
  const Polynomial common = Polynomial::gcd((p - RationalFunction(end)).numerator(), critical);
  if (domain.low_included || zeros_between(common, left - (right - left), right) == 0) return short_branch;
  return alone(right > end ? right : end);
}

std::string obstacle(const RationalFunction& p, const Rational& fixed, const Domain& domain) {
  if (std::string left = obstacle_on_the_left(p, fixed, domain); !left.empty()) return left;
  return obstacle_on_the_left(conjugate(p, -1, 0), -fixed, domain.image(-1, 0));
}

// The rational fixed point of g -> P(g) to which the inverse branch carries the whole domain.
Rational limit_of(const RationalFunction& p, const Domain& domain) {
  const auto in_closure = [&](const Rational& r) {
    return (!domain.low || r >= *domain.low) && (!domain.high || r <= *domain.high);
  };
  std::optional<Rational> found;
  std::string reason;       // why an attracting fixed point does not do
  std::string alternation;  // that one does not attract monotonically
  bool irrational = false;
  const Polynomial equation = (p - x()).numerator();
  if (equation.is_zero()) bad_input("the relation is the identity: the parameter would be a constant");
  if (equation.is_constant()) bad_input("the relation has no fixed point, the values have no limit");
  for (const auto& [factor, exponent] : equation.factor().factors) {
    if (factor.total_degree() > 1) {
      irrational = irrational || zeros_between(factor, domain.low, domain.high) > 0;
      continue;
    }
    const fmpz_poly_struct* f = factor.univariate_view();
    const Rational r = -Rational(f->coeffs) / Rational(f->coeffs + 1);
    if (!in_closure(r)) continue;
    const Rational slope = value(derivative(p), r);
    if (slope < Rational(-1)) {
      alternation = "the relation decreases at its fixed point " + r.to_string() + ": values would alternate around it";
      continue;
    }
    if (slope <= Rational(1)) continue;
    if (std::string why = obstacle(p, r, domain); !why.empty()) {
      reason = why + " (fixed point " + r.to_string() + ")";
      continue;
    }
    if (found) bad_input("the relation has two limits in the domain", found->to_string() + " and " + r.to_string());
    found = r;
  }
  if (found) return *found;
  if (!reason.empty()) bad_input(reason);
  if (!alternation.empty()) bad_input(alternation);
  if (irrational)
    bad_input("the limit of the values would be irrational; rewrite the parameter so that it is rational");
  bad_input("no fixed point of the relation in the domain attracts the values (it needs a derivative greater than 1)");
}

}  // namespace

long zeros_between(const Polynomial& p, const std::optional<Rational>& low, const std::optional<Rational>& high) {
  if (p.is_constant() || (low && high && *low >= *high)) return 0;
  const std::string& name = p.variables()[0];
  const RationalFunction t = RationalFunction::variable(name);
  const auto positive = [&](const RationalFunction& at) {
    return RationalFunction(p).substitute(name, at).numerator().positive_zeros();
  };
  if (low && high) {
    // low + (high - low) t/(1 + t) is no zero of p at t = infinity unless p(high) = 0, which lowers the degree only.
    const auto length = RationalFunction(*high - *low);
    return positive(RationalFunction(*low) + length * t / (RationalFunction(1) + t));
  }
  if (low) return positive(RationalFunction(*low) + t);
  if (high) return positive(RationalFunction(*high) - t);
  return positive(t) + positive(-t) + (RationalFunction(p).evaluate({{name, 0}})->is_zero() ? 1 : 0);
}

LevelRelation level_relation(const std::string& name, const RationalFunction& coarse, int arity,
                             const std::optional<Domain>& domain) {
  for (const auto& v : coarse.variables())
    if (v != name) bad_input("the relation is a polynomial in " + name + " alone, not in", v);
  if (!coarse.is_polynomial()) bad_input("the relation is not a polynomial in " + name, coarse.to_string());
  const long degree = coarse.numerator().total_degree();
  if (degree < 1 || degree > largest_degree)
    bad_input("the relation must be a polynomial of degree 1 to " + std::to_string(largest_degree), coarse.to_string());
  const RationalFunction p = coarse.substitute(name, x());
  LevelRelation r;
  if (const auto s = chebyshev_spelling(p, arity, domain)) {
    r.frequency = true;
    r.spelling = *s;
    const Domain all = Domain{Rational(-1), std::nullopt, false, false}.image(s->scale, s->offset);
    r.domain = domain.value_or(all);
    const Domain in_v = r.domain.image(s->scale.inverse(), -s->offset / s->scale);
    if (!in_v.low || *in_v.low < Rational(-1) || (*in_v.low == Rational(-1) && in_v.low_included))
      bad_input("the domain must lie in " + all.to_string() + ", where the relation has its inverse",
                r.domain.to_string());
  } else {
    if (!domain) bad_input("this relation needs a domain of the start value", coarse.to_string());
    r.domain = *domain;
    const Rational limit = limit_of(p, *domain);
    // g = v where the limit is 1, else g = v + (limit - 1): no scaling.
    r.spelling.offset = limit - Rational(1);
  }
  r.spelling.name = name;
  r.polynomial = conjugate(p, r.spelling.scale, r.spelling.offset);
  return r;
}

}  // namespace twoscale
