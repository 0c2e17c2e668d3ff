// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebraic.hpp"

#include <flint/fmpz_lll.h>
#include <flint/fmpz_mat.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "twoscale/symbolic/error.hpp"

namespace twoscale::lowering {

namespace {

constexpr long largest_relation = 6;          // degree looked for by lattice reduction
constexpr long largest_degree = 256;          // of a minimal polynomial in the tower
constexpr long largest_liouville = 1L << 18;  // bits

Polynomial renamed(const Polynomial& p, const std::string& name) {
  return Polynomial::univariate(name, p.univariate_view());
}

Ball horner(const Polynomial& univariate, const Ball& x, long bits) {
  const fmpz_poly_struct* p = univariate.univariate_view();
  Ball r;
  for (slong i = p->length; i-- > 0;) {
    arb_mul(r.raw(), r.raw(), x.raw(), bits);
    arb_add_fmpz(r.raw(), r.raw(), p->coeffs + i, bits);
  }
  return r;
}

// The irreducible factor of p that vanishes at x; enclose(bits) encloses x. nullopt if precision ran out.
template <class Enclose>
std::optional<Polynomial> vanishing_factor(const Polynomial& p, Enclose enclose) {
  std::vector<Polynomial> left;
  for (auto& [f, e] : p.factor().factors) left.push_back(f);
  for (long bits = 128; left.size() > 1 && bits <= (1 << 16); bits *= 2) {
    const Ball x = enclose(bits);
    if (!x.is_finite()) continue;
    std::erase_if(left, [&](const Polynomial& f) { return !horner(f, x, bits).contains_zero(); });
  }
  if (left.size() != 1) return std::nullopt;
  return left[0];
}

std::optional<Polynomial> relation(const ExactReal& x) {
  for (long d = 1; d <= largest_relation; ++d) {
    const long bits = 96 * (d + 1);
    const Ball ball = x.enclose(2 * bits);
    if (!ball.is_finite()) return std::nullopt;
    fmpz_mat_t m;
    fmpz_mat_init(m, d + 1, d + 2);
    Ball power;
    arb_one(power.raw());
    for (long i = 0; i <= d; ++i) {
      fmpz_one(fmpz_mat_entry(m, i, i));
      arf_t scaled;
      arf_init(scaled);
      arf_mul_2exp_si(scaled, arb_midref(power.raw()), bits);
      arf_get_fmpz(fmpz_mat_entry(m, i, d + 1), scaled, ARF_RND_NEAR);
      arf_clear(scaled);
      arb_mul(power.raw(), power.raw(), ball.raw(), 4 * bits);
    }
    fmpz_lll_t context;
    fmpz_lll_context_init_default(context);
    fmpz_lll(m, nullptr, context);
    fmpz_poly_t p;
    fmpz_poly_init(p);
    for (long i = 0; i <= d; ++i) fmpz_poly_set_coeff_fmpz(p, i, fmpz_mat_entry(m, 0, i));
    const Polynomial candidate = Polynomial::univariate("x", p);
    fmpz_poly_clear(p);
    fmpz_mat_clear(m);
    if (candidate.is_constant() || !horner(candidate, ball, 2 * bits).contains_zero()) continue;
    ExactReal sum;
    candidate.for_each_term([&](const Rational& c, std::span<const unsigned long> e) {
      sum = sum + ExactReal(c) * x.pow(Rational(static_cast<long>(e[0])));
    });
    if (sum.sign() != Sign::zero) continue;
    return vanishing_factor(candidate, [&](long b) { return x.enclose(b); });
  }
  return std::nullopt;
}

}  // namespace

std::optional<Polynomial> minimal_polynomial_of(const ExactReal& x) {
  if (const auto q = x.rational()) {
    const std::array<Rational, 2> c{-Rational(q->numerator()), Rational(q->denominator())};
    return Polynomial::univariate("x", c);
  }
  return relation(x);
}

bool known_transcendental(const ExactReal& x) {
  using F = ExactReal::Function;
  for (const F f : {F::exp, F::cos, F::sin, F::tan, F::cosh, F::sinh, F::tanh})
    if (const auto a = x.argument_of(f); a && a->rational() && !a->rational()->is_zero()) return true;
  const auto pi = x.multiple_of_pi();
  return pi && !pi->is_zero();
}

ZeroTest::ZeroTest(std::vector<Variable> variables) : variables_(std::move(variables)), towers_(variables_.size()) {}

size_t ZeroTest::index_of(const std::string& name) const {
  for (size_t i = 0; i < variables_.size(); ++i)
    if (variables_[i].name == name) return i;
  throw std::logic_error("no value for the variable " + name);
}

ZeroTest::Found ZeroTest::minimal(size_t variable, unsigned k, long cap, Polynomial& result) {
  const Variable& v = variables_[variable];
  Tower& tower = towers_[variable];
  if (!tower.started) {
    tower.started = true;
    tower.transcendental = v.level != nullptr ? v.level->transcendental() : known_transcendental(*v.constant);
    if (!tower.transcendental) {
      auto m = v.level != nullptr ? v.level->minimal_polynomial() : minimal_polynomial_of(*v.constant);
      tower.known = m.has_value();
      if (m) tower.minimal.push_back(*std::move(m));
    }
  }
  if (tower.transcendental) return Found::transcendental;
  if (!tower.known) return Found::unknown;
  if (v.level == nullptr || v.level->is_one()) k = 0;
  for (;;) {
    const Polynomial& last = tower.minimal.back();
    if (tower.minimal.size() > k) {
      result = tower.minimal[k];
      return result.degree("x") > cap ? Found::degree_exceeded : Found::polynomial;
    }
    if (last.degree("x") > cap) return Found::degree_exceeded;
    const RationalFunction relation = v.level->relation();
    if (last.degree("x") * relation.numerator().degree("x") > largest_degree) return Found::unknown;
    const unsigned next = static_cast<unsigned>(tower.minimal.size());
    const Polynomial composed = RationalFunction(last).substitute("x", relation).numerator();
    auto m = vanishing_factor(composed, [&](long bits) {
      Ball x = v.level->offset(next, bits);
      arb_add_ui(x.raw(), x.raw(), 1, bits);
      return x;
    });
    if (!m) return Found::unknown;
    tower.minimal.push_back(*std::move(m));
  }
}

std::optional<Rational> ZeroTest::rational(size_t variable, unsigned k) {
  const Variable& v = variables_[variable];
  if (v.level == nullptr) return v.constant->rational();
  if (v.level->is_one()) return Rational(1);
  // Cheap cases only: a start value that is not written as a rational number is not looked at.
  if (!v.level->exact(0).rational()) return std::nullopt;
  Polynomial m;
  if (minimal(variable, k, 1, m) != Found::polynomial) return std::nullopt;
  const fmpz_poly_struct* p = m.univariate_view();
  if (p->length == 1) return std::nullopt;
  return -Rational(p->coeffs) / Rational(p->coeffs + 1);
}

Ball ZeroTest::value(const Polynomial& p, std::optional<unsigned> k, long bits) const {
  const auto& names = p.variables();
  std::vector<Ball> at;
  for (const auto& name : names) {
    const Variable& v = variables_[index_of(name)];
    Ball x;
    if (v.level == nullptr) {
      x = v.constant->enclose(bits);
    } else {
      if (k) x = v.level->offset(*k, bits);
      arb_add_ui(x.raw(), x.raw(), 1, bits);
    }
    at.push_back(std::move(x));
  }
  Ball sum, term, power;
  p.for_each_term([&](const Rational& c, std::span<const unsigned long> e) {
    arb_set_fmpz(term.raw(), c.numerator());
    for (size_t i = 0; i < e.size(); ++i) {
      if (e[i] == 0) continue;
      arb_pow_ui(power.raw(), at[i].raw(), e[i], bits);
      arb_mul(term.raw(), term.raw(), power.raw(), bits);
    }
    arb_add(sum.raw(), sum.raw(), term.raw(), bits);
  });
  return sum;
}

Zero ZeroTest::at_level(const Polynomial& p, unsigned k) { return decide(p, k); }

Zero ZeroTest::at_limit(const Polynomial& p) {
  Polynomial q = p;
  for (const Variable& v : variables_)
    if (v.level != nullptr) q = q.substitute(v.name, 1);
  return decide(q, std::nullopt);
}

Zero ZeroTest::decide(const Polynomial& p, std::optional<unsigned> k) {
  if (p.is_zero()) return Zero::yes;
  if (p.is_constant()) return Zero::no;
  const std::vector<std::string> names = p.variables();
  if (names.size() == 1) {
    Polynomial m;
    switch (minimal(index_of(names[0]), k.value_or(0), p.degree(names[0]), m)) {
      case Found::degree_exceeded:
      case Found::transcendental: return Zero::no;
      case Found::unknown: break;
      case Found::polynomial: return Polynomial::quotient(p, renamed(m, names[0])) ? Zero::yes : Zero::no;
    }
    return value(p, k, 4096).contains_zero() ? Zero::unknown : Zero::no;
  }
  for (long bits = 128; bits <= 4096; bits *= 4)
    if (!value(p, k, bits).contains_zero()) return Zero::no;
  long degree = 1;
  Rational leading = 1;                       // A
  std::vector<Rational> bound(names.size());  // of all conjugates
  for (size_t i = 0; i < names.size(); ++i) {
    Polynomial m;
    const Found found = minimal(index_of(names[i]), k.value_or(0), 64, m);
    if (found == Found::transcendental) {
      // Zero iff all coefficients vanish, if the other variables are algebraic (each of them is asked in turn).
      std::vector<Polynomial> coefficients(static_cast<size_t>(p.degree(names[i])) + 1);
      p.for_each_term([&](const Rational& c, std::span<const unsigned long> e) {
        Polynomial term = Polynomial::constant(c.numerator());
        for (size_t j = 0; j < e.size(); ++j)
          if (j != i) term *= Polynomial::variable(names[j]).pow(static_cast<unsigned>(e[j]));
        coefficients[e[i]] += term;
      });
      for (size_t j = 0; j < names.size(); ++j) {
        Polynomial ignored;
        if (j == i) continue;
        const Found other = minimal(index_of(names[j]), k.value_or(0), 64, ignored);
        if (other != Found::polynomial) return Zero::unknown;
      }
      bool all = true;
      for (const auto& c : coefficients) {
        const Zero z = decide(c, k);
        if (z == Zero::no) return Zero::no;
        all = all && z == Zero::yes;
      }
      return all ? Zero::yes : Zero::unknown;
    }
    if (found != Found::polynomial) return Zero::unknown;
    degree *= m.degree("x");
    if (degree > 4096) return Zero::unknown;
    const fmpz_poly_struct* f = m.univariate_view();
    const Rational lead = abs(Rational(f->coeffs + f->length - 1));
    leading *= lead.pow(p.degree(names[i]));
    for (slong j = 0; j + 1 < f->length; ++j) bound[i] = std::max(bound[i], abs(Rational(f->coeffs + j)) / lead);
    bound[i] += Rational(1);
  }
  Rational size;  // B
  p.for_each_term([&](const Rational& c, std::span<const unsigned long> e) {
    Rational term = abs(c);
    for (size_t i = 0; i < e.size(); ++i) term *= bound[i].pow(static_cast<long>(e[i]));
    size += term;
  });
  const auto bits_of = [](const Rational& q) { return static_cast<long>(fmpz_bits(q.numerator())) + 1; };
  const long needed = bits_of(leading) + (degree - 1) * (bits_of(leading) + bits_of(size));
  if (needed > largest_liouville) return Zero::unknown;
  for (long bits = 2 * needed + 128; bits <= 16 * needed + 1024; bits *= 2) {
    const Ball x = value(p, k, bits);
    if (!x.contains_zero()) return Zero::no;
    arf_t bound_of_x;
    arf_init(bound_of_x);
    arb_get_abs_ubound_arf(bound_of_x, x.raw(), 64);
    const bool below = arf_cmpabs_2exp_si(bound_of_x, -needed) < 0;
    arf_clear(bound_of_x);
    if (below) return Zero::yes;
  }
  return Zero::unknown;
}

}  // namespace twoscale::lowering
