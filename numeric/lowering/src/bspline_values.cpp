// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/lowering/bspline_values.hpp"

#include <algorithm>
#include <cmath>

#include "twoscale/symbolic/error.hpp"

namespace twoscale::lowering {

namespace {

// The frequency alpha >= 0 of one pair +-alpha (or +-I alpha).
struct Frequency {
  Ball alpha;
  bool circular = false;
};

// alpha^2, or -alpha^2 for a circular pair.
Ball signed_square(const Frequency& f, long bits) {
  Ball square;
  arb_sqr(square.raw(), f.alpha.raw(), bits);
  if (f.circular) arb_neg(square.raw(), square.raw());
  return square;
}

// (alpha/2)/sinh(alpha/2) squared; with sin for a circular pair.
Ball integral_factor(const Frequency& f, long bits) {
  Ball half, r;
  if (f.alpha.is_exact_zero()) return Ball(Rational(1), bits);
  arb_mul_2exp_si(half.raw(), f.alpha.raw(), -1);
  if (f.circular)
    arb_sin(r.raw(), half.raw(), bits);
  else
    arb_sinh(r.raw(), half.raw(), bits);
  arb_div(r.raw(), half.raw(), r.raw(), bits);
  arb_sqr(r.raw(), r.raw(), bits);
  return r;
}

// Coefficients d_i of prod (1 - 2 cosh(alpha) z + z^2) (1 - z)^zeros.
std::vector<Ball> knot_coefficients(const std::vector<Frequency>& pairs, unsigned zeros, long bits) {
  std::vector<Ball> d{Ball(Rational(1), bits)};
  for (const Frequency& f : pairs) {
    Ball c;
    if (f.circular)
      arb_cos(c.raw(), f.alpha.raw(), bits);
    else
      arb_cosh(c.raw(), f.alpha.raw(), bits);
    arb_mul_si(c.raw(), c.raw(), -2, bits);
    std::vector<Ball> r(d.size() + 2);
    for (size_t i = 0; i < d.size(); ++i) {
      arb_add(r[i].raw(), r[i].raw(), d[i].raw(), bits);
      arb_addmul(r[i + 1].raw(), d[i].raw(), c.raw(), bits);
      arb_add(r[i + 2].raw(), r[i + 2].raw(), d[i].raw(), bits);
    }
    d = std::move(r);
  }
  for (unsigned n = 0; n < zeros; ++n) {
    d.emplace_back();
    for (size_t i = d.size() - 1; i > 0; --i) arb_sub(d[i].raw(), d[i].raw(), d[i - 1].raw(), bits);
  }
  return d;
}

class Green {
 public:
  // For 0 <= x <= reach.
  Green(const std::vector<Frequency>& pairs, unsigned order, double reach, long bits) : order_(order), bits_(bits) {
    for (const Frequency& f : pairs) arb_max(largest_.raw(), largest_.raw(), f.alpha.raw(), bits);
    // The number of terms is only a choice; the bound is proved in remainder().
    const double a = arf_get_d(arb_midref(largest_.raw()), ARF_RND_UP) * reach;
    double size = 0;  // log2 of (A x)^{2R}/(2R)!
    long terms = 0;
    while (a > 0 && (size > -static_cast<double>(bits) || 2.0 * static_cast<double>(terms) < 2 * a)) {
      ++terms;
      const double n = 2.0 * static_cast<double>(terms);
      size += 2 * std::log2(a) - std::log2(n - 1) - std::log2(n);
    }
    h_.resize(static_cast<size_t>(std::max(1L, terms)));
    arb_one(h_[0].raw());
    for (const Frequency& f : pairs) {
      const Ball square = signed_square(f, bits);
      for (size_t r = 1; r < h_.size(); ++r) arb_addmul(h_[r].raw(), h_[r - 1].raw(), square.raw(), bits);
    }
  }

  Ball value(const Rational& x) const {
    const Ball t(x, bits_);
    Ball power, square, sum;  // power = x^{2r+N-1}/(2r+N-1)!
    arb_pow_ui(power.raw(), t.raw(), order_ - 1, bits_);
    Ball factorial;
    arb_fac_ui(factorial.raw(), order_ - 1, bits_);
    arb_div(power.raw(), power.raw(), factorial.raw(), bits_);
    const Ball first = power;
    arb_sqr(square.raw(), t.raw(), bits_);
    for (size_t r = 0; r < h_.size(); ++r) {
      arb_addmul(sum.raw(), h_[r].raw(), power.raw(), bits_);
      arb_mul(power.raw(), power.raw(), square.raw(), bits_);
      const ulong n = 2 * r + order_;
      arb_div_ui(power.raw(), power.raw(), n, bits_);
      arb_div_ui(power.raw(), power.raw(), n + 1, bits_);
    }
    if (!largest_.is_exact_zero()) arb_add_error(sum.raw(), remainder(t, first).raw());
    return sum;
  }

 private:
  Ball remainder(const Ball& x, const Ball& first) const {
    const ulong n = 2 * h_.size();
    Ball ax, r, q, factorial;
    arb_mul(ax.raw(), largest_.raw(), x.raw(), bits_);
    arb_pow_ui(r.raw(), ax.raw(), n, bits_);
    arb_fac_ui(factorial.raw(), n, bits_);
    arb_div(r.raw(), r.raw(), factorial.raw(), bits_);
    arb_mul(r.raw(), r.raw(), first.raw(), bits_);
    arb_div_ui(q.raw(), ax.raw(), n + 1, bits_);
    arb_sub_ui(q.raw(), q.raw(), 1, bits_);
    arb_neg(q.raw(), q.raw());
    if (!q.is_positive()) throw Error(Error::Kind::undecided, "the series of an exponential B-spline is too short");
    arb_div(r.raw(), r.raw(), q.raw(), bits_);
    return r;
  }

  unsigned order_;
  long bits_;
  Ball largest_;  // A
  std::vector<Ball> h_;
};

}  // namespace

BsplineFunction::BsplineFunction(const Space& space, int arity, const Binding& binding)
    : order_(space.dimension()), zeros_(space.polynomial_order()), arity_(arity) {
  if (order_ == 0) bad_input("a space of dimension 0 has no B-spline");
  const long length = static_cast<long>(arity - 1) * static_cast<long>(order_);
  shift_ = length % 2 == 0 ? Rational(0) : Rational(1, 2L * (arity - 1));
  for (const Space::Exponential& e : space.exponentials()) {
    const std::string& name = space.variables()[e.variable].name;
    const auto at = binding.levels.find(name);
    if (at == binding.levels.end()) bad_input("a value is missing for the level variable", name);
    pairs_.push_back({at->second, e.multiple, e.order});
  }
}

Ball BsplineFunction::value(unsigned k, const Rational& x, long bits) const {
  const Rational length(static_cast<long>(order_));
  Rational t = x - first();
  if (t < Rational(0) || t >= length || (order_ > 1 && t.is_zero())) return {};
  if (order_ > 1 && t > length / Rational(2)) t = length - t;  // phi is symmetric: fewer knots, less cancellation
  double a = 0;                                                // an estimate, for the working precision only
  for (const Pair& p : pairs_)
    a = std::max(a, arf_get_d(arb_midref(p.value.angle(64).raw()), ARF_RND_UP) * p.multiple / std::pow(arity_, k));
  const double reach = arf_get_d(arb_midref(Ball(t, 64).raw()), ARF_RND_UP);
  const long work = bits + 64 + static_cast<long>(3 * a * static_cast<double>(order_)) + 2L * static_cast<long>(order_);
  std::vector<Frequency> pairs;
  for (const Pair& p : pairs_) {
    Frequency f{p.value.angle(work), p.value.trigonometric()};
    arb_mul_ui(f.alpha.raw(), f.alpha.raw(), p.multiple, work);
    arb_div_fmpz(f.alpha.raw(), f.alpha.raw(), Rational(static_cast<long>(arity_)).pow(k).numerator(), work);
    for (unsigned n = 0; n < p.order; ++n) pairs.push_back(f);
  }
  const Green green(pairs, order_, reach, work);
  const std::vector<Ball> d = knot_coefficients(pairs, zeros_, work);
  Ball sum;
  for (size_t i = 0; i < d.size() && Rational(static_cast<long>(i)) <= t; ++i)
    arb_addmul(sum.raw(), d[i].raw(), green.value(t - Rational(static_cast<long>(i))).raw(), work);
  for (const Frequency& f : pairs) arb_mul(sum.raw(), sum.raw(), integral_factor(f, work).raw(), work);
  return sum;
}

double BsplineFunction::rounded(unsigned k, const Rational& x) const {
  for (long bits = 128; bits <= 4096; bits *= 2) {
    const Ball y = value(k, x, bits);
    if (y.is_exact_zero()) return 0;
    double r = 0;
    if (!y.contains_zero() && rounded_double(y, r)) return r;
  }
  throw Error(Error::Kind::undecided, "cannot decide the rounding of a B-spline value at", x.to_string());
}

}  // namespace twoscale::lowering
