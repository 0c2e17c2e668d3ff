// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/symbolic/exact_real.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "twoscale/symbolic/error.hpp"

namespace twoscale {

// Separation data of an algebraic constant U/L: bits of bounds for the conjugates of U and L, and the degree. The
// bounds are integers rounded up at each step, so that they stay upper bounds.
//
// All cosines lie in one field, Q(cos(pi/n)) for the common denominator n of their angles, of degree at most n; so they
// count once however often they occur. Radicals multiply the degree.
struct Separation {
  long u = 0;        // |conjugates of U| <= 2^u
  long l = 0;        // |conjugates of L| <= 2^l
  long radical = 1;  // capped at degree_cap
  long cosine = 1;   // n; capped at degree_cap
};

struct ExactReal::Node {
  enum class Kind { rational, pi, sum, product, quotient, power, function } kind;
  Rational value;  // rational: itself; power: the exponent
  std::vector<ExactReal> arguments;
  Function function = Function::exp;
  std::optional<Separation> separation;  // none if not known to be algebraic
};

namespace {

constexpr long degree_cap = 1L << 22;

using Node = ExactReal::Node;

}  // namespace

struct ExactRealAccess {
  static const Node& node(const ExactReal& x) { return *x.node_; }
  static ExactReal wrap(Node n) { return ExactReal(std::make_shared<const Node>(std::move(n))); }
};

namespace {

const Node& node(const ExactReal& x) { return ExactRealAccess::node(x); }

long multiply_degrees(long a, long b) { return a > degree_cap / b ? degree_cap : a * b; }

long bits_of(const fmpz* n) { return static_cast<long>(fmpz_bits(n)); }

long degree(const Separation& s) { return multiply_degrees(s.radical, s.cosine); }

Separation separation_of_rational(const Rational& q) {
  return {bits_of(q.numerator()), bits_of(q.denominator()), 1, 1};
}

std::optional<Separation> separation(Node::Kind kind, const std::vector<ExactReal>& args) {
  const auto& a = node(args[0]).separation;
  const auto& b = node(args[1]).separation;
  if (!a || !b) return std::nullopt;
  Separation s;
  s.radical = multiply_degrees(a->radical, b->radical);
  s.cosine = multiply_degrees(a->cosine, b->cosine / std::gcd(a->cosine, b->cosine));
  if (kind == Node::Kind::sum) {
    s.u = std::max(a->u + b->l, a->l + b->u) + 1;
    s.l = a->l + b->l;
  } else if (kind == Node::Kind::product) {
    s.u = a->u + b->u;
    s.l = a->l + b->l;
  } else {
    s.u = a->u + b->l;
    s.l = a->l + b->u;
  }
  return s;
}

ExactReal binary(Node::Kind kind, const ExactReal& a, const ExactReal& b) {
  Node n{kind, {}, {a, b}, {}, {}};
  n.separation = separation(kind, n.arguments);
  return ExactRealAccess::wrap(std::move(n));
}

}  // namespace

ExactReal::ExactReal(const Rational& q)
    : node_(std::make_shared<const Node>(Node{Node::Kind::rational, q, {}, {}, separation_of_rational(q)})) {}

ExactReal ExactReal::pi() { return ExactReal(std::make_shared<const Node>(Node{Node::Kind::pi, {}, {}, {}, {}})); }

ExactReal operator+(const ExactReal& a, const ExactReal& b) {
  if (a.rational() && b.rational()) return *a.rational() + *b.rational();
  return binary(Node::Kind::sum, a, b);
}

ExactReal operator*(const ExactReal& a, const ExactReal& b) {
  if (a.rational() && b.rational()) return *a.rational() * *b.rational();
  if (a.rational() && *a.rational() == Rational(1)) return b;
  if (b.rational() && *b.rational() == Rational(1)) return a;
  return binary(Node::Kind::product, a, b);
}

ExactReal operator-(const ExactReal& a, const ExactReal& b) { return a + ExactReal(-1) * b; }

ExactReal operator/(const ExactReal& a, const ExactReal& b) {
  if (a.rational() && b.rational() && !b.rational()->is_zero()) return *a.rational() / *b.rational();
  return binary(Node::Kind::quotient, a, b);
}

ExactReal ExactReal::pow(const Rational& exponent) const {
  if (exponent == Rational(1)) return *this;
  if (exponent == Rational(1, 2) && rational() && rational()->sign() >= 0 && fmpz_is_square(rational()->numerator()) &&
      fmpz_is_square(rational()->denominator())) {
    Rational root;
    fmpz_sqrt(fmpq_numref(root.raw()), rational()->numerator());
    fmpz_sqrt(fmpq_denref(root.raw()), rational()->denominator());
    return root;
  }
  if (exponent.is_integer() && rational() && fmpz_bits(exponent.numerator()) < 20 &&
      !(rational()->is_zero() && exponent.sign() < 0))
    return rational()->pow(exponent.to_long());
  Node n{Node::Kind::power, exponent, {*this}, {}, {}};
  if (node_->separation && fmpz_fits_si(exponent.numerator()) && bits_of(exponent.numerator()) < 20 &&
      bits_of(exponent.denominator()) < 20) {
    Separation s = *node_->separation;
    if (exponent.sign() < 0) std::swap(s.u, s.l);
    const long p = std::labs(fmpz_get_si(exponent.numerator()));
    const long q = fmpz_get_si(exponent.denominator());
    // (U/L)^{p/q} = (U^p L^{p(q-1)})^{1/q} / L^p.
    n.separation = Separation{(p * s.u + p * (q - 1) * s.l) / q + 1, p * s.l, multiply_degrees(s.radical, q), s.cosine};
  }
  return ExactReal(std::make_shared<const Node>(std::move(n)));
}

ExactReal ExactReal::apply(Function f, const ExactReal& x) {
  if (x.rational() && x.rational()->is_zero()) {
    if (f == Function::exp || f == Function::cos || f == Function::cosh) return 1;
    if (f == Function::sin || f == Function::tan || f == Function::sinh || f == Function::tanh || f == Function::atan ||
        f == Function::asin)
      return 0;
  }
  Node n{Node::Kind::function, {}, {x}, f, {}};
  if (f == Function::cos || f == Function::sin)
    if (const auto r = x.multiple_of_pi(); r && bits_of(r->denominator()) < 20) {
      // 2 cos(p/q pi) is an algebraic integer of size at most 2 in Q(cos(pi/q)); likewise 2 sin, in Q(cos(pi/(2q))).
      const long q = fmpz_get_si(r->denominator());
      n.separation = Separation{1, 1, 1, f == Function::cos ? q : 2 * q};
    }
  return ExactReal(std::make_shared<const Node>(std::move(n)));
}

std::optional<Rational> ExactReal::rational() const {
  if (node_->kind == Node::Kind::rational) return node_->value;
  return std::nullopt;
}

std::optional<Rational> ExactReal::multiple_of_pi() const {
  const Node& n = *node_;
  if (n.kind == Node::Kind::pi) return Rational(1);
  if (n.kind == Node::Kind::rational && n.value.is_zero()) return Rational(0);
  if (n.kind == Node::Kind::product || n.kind == Node::Kind::quotient) {
    const auto& a = n.arguments[0];
    const auto& b = n.arguments[1];
    if (a.multiple_of_pi() && b.rational() && !b.rational()->is_zero())
      return n.kind == Node::Kind::product ? *a.multiple_of_pi() * *b.rational() : *a.multiple_of_pi() / *b.rational();
    if (n.kind == Node::Kind::product && a.rational() && b.multiple_of_pi()) return *a.rational() * *b.multiple_of_pi();
  }
  if (n.kind == Node::Kind::sum) {
    const auto a = n.arguments[0].multiple_of_pi();
    const auto b = n.arguments[1].multiple_of_pi();
    if (a && b) return *a + *b;
  }
  return std::nullopt;
}

std::optional<ExactReal> ExactReal::argument_of(Function f) const {
  if (node_->kind == Node::Kind::function && node_->function == f) return node_->arguments[0];
  return std::nullopt;
}

Ball ExactReal::enclose(long bits) const {
  const Node& n = *node_;
  Ball r;
  switch (n.kind) {
    case Node::Kind::rational: arb_set_fmpq(r.raw(), n.value.raw(), bits); return r;
    case Node::Kind::pi: arb_const_pi(r.raw(), bits); return r;
    case Node::Kind::sum:
      arb_add(r.raw(), n.arguments[0].enclose(bits).raw(), n.arguments[1].enclose(bits).raw(), bits);
      return r;
    case Node::Kind::product:
      arb_mul(r.raw(), n.arguments[0].enclose(bits).raw(), n.arguments[1].enclose(bits).raw(), bits);
      return r;
    case Node::Kind::quotient:
      arb_div(r.raw(), n.arguments[0].enclose(bits).raw(), n.arguments[1].enclose(bits).raw(), bits);
      return r;
    case Node::Kind::power: arb_pow_fmpq(r.raw(), n.arguments[0].enclose(bits).raw(), n.value.raw(), bits); return r;
    case Node::Kind::function: break;
  }
  const ExactReal& x = n.arguments[0];
  if (const auto angle = x.multiple_of_pi(); angle && n.function == Function::cos) {
    arb_cos_pi_fmpq(r.raw(), angle->raw(), bits);
    return r;
  }
  if (const auto angle = x.multiple_of_pi(); angle && n.function == Function::sin) {
    arb_sin_pi_fmpq(r.raw(), angle->raw(), bits);
    return r;
  }
  const Ball a = x.enclose(bits);
  switch (n.function) {
    case Function::exp: arb_exp(r.raw(), a.raw(), bits); break;
    case Function::log: arb_log(r.raw(), a.raw(), bits); break;
    case Function::cos: arb_cos(r.raw(), a.raw(), bits); break;
    case Function::sin: arb_sin(r.raw(), a.raw(), bits); break;
    case Function::tan: arb_tan(r.raw(), a.raw(), bits); break;
    case Function::cosh: arb_cosh(r.raw(), a.raw(), bits); break;
    case Function::sinh: arb_sinh(r.raw(), a.raw(), bits); break;
    case Function::tanh: arb_tanh(r.raw(), a.raw(), bits); break;
    case Function::acos: arb_acos(r.raw(), a.raw(), bits); break;
    case Function::asin: arb_asin(r.raw(), a.raw(), bits); break;
    case Function::atan: arb_atan(r.raw(), a.raw(), bits); break;
    case Function::acosh: arb_acosh(r.raw(), a.raw(), bits); break;
  }
  return r;
}

Sign ExactReal::sign(long max_bits) const {
  if (rational()) return rational()->is_zero() ? Sign::zero : rational()->sign() < 0 ? Sign::negative : Sign::positive;
  const auto& s = node_->separation;
  // Below 2^-bound only zero is left.
  const long bound =
      s && degree(*s) < degree_cap && s->u < max_bits ? s->l + (degree(*s) - 1) * std::max(1L, s->u) : max_bits + 1;
  for (long bits = 64; bits <= 2 * max_bits; bits *= 2) {
    const Ball x = enclose(bits);
    if (x.is_positive()) return Sign::positive;
    if (x.is_negative()) return Sign::negative;
    if (x.is_finite() && bound <= max_bits) {
      arf_t size;
      arf_init(size);
      arb_get_abs_ubound_arf(size, x.raw(), 64);
      const bool below = arf_cmpabs_2exp_si(size, -bound) < 0;
      arf_clear(size);
      if (below) return Sign::zero;
    }
  }
  return Sign::unknown;
}

std::string ExactReal::decimal(long digits) const {
  if (rational()) return rounded_decimal(*rational(), digits);
  const Sign s = sign();
  if (s == Sign::zero) return "0";
  for (long bits = digits * 4 + 64; bits < (1 << 24); bits *= 2) {
    const Ball x = enclose(bits);
    std::string text = rounded_decimal(x, digits);
    if (!text.empty()) return text;
    if (s == Sign::unknown) break;
  }
  throw Error(Error::Kind::undecided, "a constant could not be evaluated to the precision asked for");
}

}  // namespace twoscale
