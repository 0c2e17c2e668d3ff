// SPDX-License-Identifier: GPL-3.0-or-later
// The sequences v^{[k]}: their angles, enclosures and algebraic nature.
#include <algorithm>
#include <stdexcept>

#include "algebraic.hpp"
#include "inverse_branch.hpp"
#include "twoscale/lowering/lower.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::lowering {

namespace {

constexpr long guard = 24;

int decided(const ExactReal& x, const char* what, const std::string& text) {
  if (!x.enclose(256).is_finite()) bad_input("the value is not a real number", text);
  switch (x.sign()) {
    case Sign::negative: return -1;
    case Sign::zero: return 0;
    case Sign::positive: return 1;
    case Sign::unknown: break;
  }
  throw Error(Error::Kind::undecided, what, text);
}

// r mod 2 moved into [0, 1] by cos(r pi) = cos(-r pi).
Rational reduced_angle(const Rational& r) {
  Rational whole;
  fmpz_fdiv_q(fmpq_numref(whole.raw()), r.numerator(), r.denominator());
  if (fmpz_is_odd(whole.numerator())) whole -= Rational(1);
  const Rational rest = r - whole;  // [0, 2)
  return rest > Rational(1) ? Rational(2) - rest : rest;
}

// T_m(1 + x) - 1 = sum_{j >= 1} c_j x^j.
std::vector<Rational> offset_recurrence(int arity) {
  const Polynomial t =
      Polynomial::chebyshev("x", static_cast<unsigned>(arity)).substitute("x", Polynomial::variable("x") + 1) - 1;
  std::vector<Rational> c(static_cast<size_t>(arity) + 1);
  t.for_each_term([&](const Rational& k, std::span<const unsigned long> e) { c[e[0]] = k; });
  return c;
}

}  // namespace

LevelValue LevelValue::from_v0(const ExactReal& v0, std::string text, int arity) {
  using F = ExactReal::Function;
  if (const auto t = v0.argument_of(F::cosh)) return hyperbolic(*t, std::move(text), arity);
  if (const auto s = v0.argument_of(F::cos)) {
    if (const auto r = s->multiple_of_pi())
      return trigonometric(ExactReal(reduced_angle(*r)) * ExactReal::pi(), std::move(text), arity);
    if (s->rational() && abs(*s->rational()) < Rational(3)) return trigonometric(*s, std::move(text), arity);
  }
  LevelValue v;
  v.arity_ = arity;
  v.v0_ = v0;
  if (decided(v0 + ExactReal(1), "cannot decide whether v^0 is greater than -1", text) <= 0)
    bad_input("v^0 must be greater than -1", text);
  v.side_ = decided(v0 - ExactReal(1), "cannot decide whether v^0 is 1", text);
  v.text_ = std::move(text);
  return v;
}

LevelValue LevelValue::hyperbolic(const ExactReal& t, std::string text, int arity) {
  using F = ExactReal::Function;
  if (const auto x = t.argument_of(F::acosh)) return from_v0(*x, std::move(text), arity);
  if (const auto x = t.argument_of(F::log);
      x && decided(*x, "cannot decide the sign of a logarithm's argument", text) > 0)
    return from_v0((*x + ExactReal(1) / *x) / ExactReal(2), std::move(text), arity);
  LevelValue v;
  v.arity_ = arity;
  v.angle_ = t;
  v.side_ = decided(t, "cannot decide whether the frequency is 0", text) == 0 ? 0 : 1;
  v.v0_ = v.side_ == 0 ? ExactReal(1) : ExactReal::apply(F::cosh, t);
  v.text_ = std::move(text);
  return v;
}

LevelValue LevelValue::trigonometric(const ExactReal& s, std::string text, int arity) {
  using F = ExactReal::Function;
  if (const auto x = s.argument_of(F::acos)) return from_v0(*x, std::move(text), arity);
  if (const auto r = s.multiple_of_pi()) {
    if (abs(*r) >= Rational(1)) bad_input("the frequency s of cos(s*x) must be below pi in size (v^0 > -1)", text);
  } else if (decided(ExactReal::pi() - s, "cannot decide whether the frequency is below pi", text) <= 0 ||
             decided(ExactReal::pi() + s, "cannot decide whether the frequency is above -pi", text) <= 0) {
    bad_input("the frequency s of cos(s*x) must be below pi in size (v^0 > -1)", text);
  }
  LevelValue v;
  v.arity_ = arity;
  v.angle_ = s;
  v.circular_ = true;
  v.side_ = decided(s, "cannot decide whether the frequency is 0", text) == 0 ? 0 : -1;
  v.v0_ = v.side_ == 0 ? ExactReal(1) : ExactReal::apply(F::cos, s);
  if (const auto r = s.multiple_of_pi()) {
    // The rational cosines.
    if (*r == Rational(1, 2) || *r == Rational(-1, 2)) v.v0_ = 0;
    if (*r == Rational(1, 3) || *r == Rational(-1, 3)) v.v0_ = Rational(1, 2);
    if (*r == Rational(2, 3) || *r == Rational(-2, 3)) v.v0_ = Rational(-1, 2);
  }
  v.text_ = std::move(text);
  return v;
}

LevelValue LevelValue::related(const ExactReal& v0, std::string text, const RationalFunction& relation) {
  LevelValue v;
  v.v0_ = v0;
  v.side_ = decided(v0 - ExactReal(1), "cannot decide whether the start value is the limit", text);
  v.branch_ = std::make_shared<const InverseBranch>(relation, v.side_, v0);
  v.text_ = std::move(text);
  return v;
}

RationalFunction LevelValue::relation() const {
  return branch_ ? branch_->relation() : Polynomial::chebyshev("x", static_cast<unsigned>(arity_));
}

ExactReal LevelValue::exact(unsigned k) const {
  using F = ExactReal::Function;
  if (k == 0 || side_ == 0) return v0_;
  if (branch_) throw std::logic_error("LevelValue::exact: only the start value has an expression");
  if (angle_ && v0_.rational() == std::nullopt)
    return ExactReal::apply(circular_ ? F::cos : F::cosh,
                            *angle_ / ExactReal(Rational(static_cast<long>(arity_)).pow(k)));
  if (arity_ == 2) {
    ExactReal v = v0_;
    for (unsigned j = 0; j < k; ++j) v = ((ExactReal(1) + v) / ExactReal(2)).pow(Rational(1, 2));
    return v;
  }
  const ExactReal scale(Rational(static_cast<long>(arity_)).pow(k));
  if (side_ < 0) return ExactReal::apply(F::cos, ExactReal::apply(F::acos, v0_) / scale);
  return ExactReal::apply(F::cosh, ExactReal::apply(F::acosh, v0_) / scale);
}

Ball LevelValue::angle(long bits) const {
  Ball r;
  if (side_ == 0) return r;
  if (angle_) {
    r = angle_->enclose(bits);
    arb_abs(r.raw(), r.raw());
    return r;
  }
  Ball u, w;  // v0 - 1, v0 + 1
  if (const auto q = v0_.rational()) {
    u = Ball(*q - Rational(1), bits);
    w = Ball(*q + Rational(1), bits);
  } else {
    const Ball v = v0_.enclose(bits);
    arb_sub_ui(u.raw(), v.raw(), 1, bits);
    arb_add_ui(w.raw(), v.raw(), 1, bits);
  }
  if (side_ > 0) {  // sinh^2(t/2) = u/2
    arb_mul_2exp_si(u.raw(), u.raw(), -1);
    arb_sqrtpos(u.raw(), u.raw(), bits);
    arb_asinh(r.raw(), u.raw(), bits);
  } else {  // tan^2(s/2) = -u/w
    arb_neg(u.raw(), u.raw());
    arb_sqrtpos(u.raw(), u.raw(), bits);
    arb_sqrtpos(w.raw(), w.raw(), bits);
    arb_atan2(r.raw(), u.raw(), w.raw(), bits);
  }
  arb_mul_2exp_si(r.raw(), r.raw(), 1);
  return r;
}

Ball LevelValue::offset(unsigned k, long bits) const {
  Ball u;
  if (side_ == 0) return u;
  if (k == 0 && v0_.rational()) return Ball(*v0_.rational() - Rational(1), bits);
  bits += guard;
  if (branch_) return branch_->offsets(v0_, k, bits).back();
  Ball x = angle(bits);
  arb_mul_2exp_si(x.raw(), x.raw(), -1);
  if (arity_ == 2) {
    arb_mul_2exp_si(x.raw(), x.raw(), -static_cast<slong>(k));
  } else {
    const Rational scale = Rational(static_cast<long>(arity_)).pow(static_cast<long>(k));
    arb_div_fmpz(x.raw(), x.raw(), scale.numerator(), bits);
  }
  if (side_ > 0)
    arb_sinh(u.raw(), x.raw(), bits);
  else
    arb_sin(u.raw(), x.raw(), bits);
  arb_sqr(u.raw(), u.raw(), bits);
  arb_mul_2exp_si(u.raw(), u.raw(), 1);
  if (side_ < 0) arb_neg(u.raw(), u.raw());
  return u;
}

std::vector<Ball> LevelValue::offsets(unsigned count, long bits) const {
  std::vector<Ball> u(count);
  if (count == 0 || side_ == 0) return u;
  bits += guard;
  if (branch_) {
    std::vector<Ball> all = branch_->offsets(v0_, count, bits);
    all.erase(all.begin());
    return all;
  }
  u[count - 1] = offset(count, bits);
  const std::vector<Rational> c = arity_ == 2 ? std::vector<Rational>{} : offset_recurrence(arity_);
  Ball sum;
  for (unsigned k = count - 1; k-- > 0;) {
    arb_struct* to = u[k].raw();
    const arb_struct* x = u[k + 1].raw();
    if (arity_ == 2) {
      arb_add_ui(sum.raw(), x, 2, bits);
      arb_mul(to, sum.raw(), x, bits);
      arb_mul_2exp_si(to, to, 1);
      continue;
    }
    arb_set_fmpz(sum.raw(), c.back().numerator());
    for (size_t j = c.size() - 1; j-- > 1;) {
      arb_mul(sum.raw(), sum.raw(), x, bits);
      arb_add_fmpz(sum.raw(), sum.raw(), c[j].numerator(), bits);
    }
    arb_mul(to, sum.raw(), x, bits);
  }
  return u;
}

bool LevelValue::transcendental() const {
  if (side_ == 0) return false;
  // Lindemann: cosh and cos of an algebraic number other than 0.
  if (angle_) return angle_->rational().has_value();
  return known_transcendental(v0_);
}

std::optional<Polynomial> LevelValue::minimal_polynomial() const {
  if (side_ == 0) return Polynomial::variable("x") - 1;
  if (v0_.rational()) return minimal_polynomial_of(v0_);
  if (angle_ && circular_)
    if (const auto r = angle_->multiple_of_pi()) {
      // cos(r pi) = cos(2 pi a/d) with a/d = r/2 in lowest terms.
      const Rational half = *r / Rational(2);
      if (half.denominator()[0] > 4096 || COEFF_IS_MPZ(*half.denominator())) return std::nullopt;
      return Polynomial::cosine_minimal("x", static_cast<unsigned>(fmpz_get_ui(half.denominator())));
    }
  if (transcendental()) return std::nullopt;
  return minimal_polynomial_of(v0_);
}

}  // namespace twoscale::lowering
