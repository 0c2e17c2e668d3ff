// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/lowering/refine_points.hpp"

#include <algorithm>
#include <cmath>

#include "rounding.hpp"
#include "twoscale/kernels/number_text.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::lowering {

namespace {

constexpr double most_points = 2147483648.0;  // 2^31
constexpr double most_output = 4294967296.0;  // characters or bytes of balls
constexpr long most_decimals = 20000;
constexpr int most_attempts = 6;

// A ball that carries its working precision.
struct Real {
  Ball value;
  long bits = 64;
};

Real operator+(const Real& a, const Real& b) {
  Real r{{}, std::max(a.bits, b.bits)};
  arb_add(r.value.raw(), a.value.raw(), b.value.raw(), r.bits);
  return r;
}

Real operator*(const Real& a, const Real& b) {
  Real r{{}, std::max(a.bits, b.bits)};
  arb_mul(r.value.raw(), a.value.raw(), b.value.raw(), r.bits);
  return r;
}

long significant_digits(const std::string& text) {
  long count = 0;
  for (const char c : text) {
    if (c == 'e') break;
    if (c >= '0' && c <= '9' && (c != '0' || count > 0)) ++count;
  }
  return count;
}

// Weight 10^w of the last digit.
long last_weight(const std::string& text) {
  const auto mark = text.find('e');
  const long exponent = mark == std::string::npos ? 0 : std::stol(text.substr(mark + 1));
  const auto point = text.find('.');
  if (point == std::string::npos) return exponent;
  return exponent - static_cast<long>(std::min(mark, text.size()) - point - 1);
}

// A table text as a ball: texts with all their digits are rounded, shorter ones exact.
Real coefficient(const std::string& text, long digits, long bits) {
  Real r{Ball(exact_decimal(text), bits), bits};
  if (significant_digits(text) >= digits) {
    Ball error(Rational(10).pow(last_weight(text)), 64);
    arb_mul_2exp_si(error.raw(), error.raw(), -1);
    arb_add_error(r.value.raw(), error.raw());
  }
  return r;
}

void check_size(const Scheme& scheme, const kernels::PointSet& points, const RefineOptions& options) {
  const double out = static_cast<double>(points.size()) * std::pow(scheme.arity, options.levels);
  const double size = out * static_cast<double>(points.dim) * (static_cast<double>(options.digits) + 64);
  if (out > most_points || (options.digits > 0 && size > most_output))
    bad_input("too many points would come out", std::to_string(points.size()) + " points, " +
                                                    std::to_string(options.levels) + " levels of arity " +
                                                    std::to_string(scheme.arity));
}

kernels::PointSet refine_digits(const Scheme& scheme, const Binding& binding, const kernels::PointSet& points,
                                const RefineOptions& options) {
  if (options.digits < 17 || options.digits > 10000)
    bad_input("digits must lie between 17 and 10000", std::to_string(options.digits));
  // All numbers times 10^decimals are integers: dyadic masks then stay exact.
  std::vector<Rational> exact;
  for (size_t i = 0; i < points.values.size(); ++i)
    exact.push_back(exact_decimal(i < points.tokens.size() ? points.tokens[i] : kernels::shortest(points.values[i])));
  Rational scale(1);
  for (const Rational& x : exact)
    if (!(x * scale).is_integer()) {
      long decimals = 0;
      while (!(x * scale * Rational(10).pow(decimals)).is_integer()) {
        decimals = decimals == 0 ? 1 : decimals * 2;
        if (decimals > most_decimals)
          bad_input("a number is too small for refinement with digits", x.to_string().substr(0, 40));
      }
      scale *= Rational(10).pow(decimals);
    }

  kernels::PointSet out;
  out.columns = points.columns;
  out.dim = points.dim;
  long guard = 12;
  for (int attempt = 1;; ++attempt, guard = std::max(3 * guard, options.digits + guard)) {
    const long digits = std::min(10000L, options.digits + guard);
    const long bits = static_cast<long>(std::ceil(static_cast<double>(options.digits + guard) * 3.3219281)) + 32;
    LowerOptions lowering{options.levels, digits, options.boundary == kernels::Boundary::space, false};
    const kernels::MaskTable table = lower(scheme, binding, lowering);
    std::vector<Real> in;
    for (const Rational& x : exact) {
      Real r{{}, bits};
      arb_set_fmpz(r.value.raw(), (x * scale).numerator());
      in.push_back(std::move(r));
    }
    const std::vector<Real> fine =
        kernels::refine<Real>(in, points.dim, table, static_cast<int>(options.levels), options.boundary,
                              [&](const std::string& text, double) { return coefficient(text, digits, bits); });
    // Below this size a number that cannot be told from 0 is taken for it.
    Ball least;
    for (const Real& x : fine) {
      arf_t size;
      arf_init(size);
      arb_get_abs_ubound_arf(size, x.value.raw(), 30);
      if (arf_cmp(size, arb_midref(least.raw())) > 0) arf_set(arb_midref(least.raw()), size);
      arf_clear(size);
    }
    arb_div(least.raw(), least.raw(), Ball(Rational(10).pow(2 * options.digits), 64).raw(), 64);

    out.tokens.clear();
    out.values.clear();
    DecimalRounder rounder(options.digits);
    Decimal decimal;
    bool done = true;
    for (const Real& x : fine) {
      if (arb_is_exact(x.value.raw())) {
        decimal = rounded(to_rational(arb_midref(x.value.raw())) / scale, options.digits);
      } else if (x.value.contains_zero()) {
        arf_t size;
        arf_init(size);
        arb_get_abs_ubound_arf(size, x.value.raw(), 30);
        const bool tiny = arf_cmp(size, arb_midref(least.raw())) < 0;
        arf_clear(size);
        if (!tiny) {
          done = false;
          break;
        }
        decimal.text = "0";
      } else {
        Ball y;
        arb_div_fmpz(y.raw(), x.value.raw(), scale.numerator(), bits);
        if (!rounder.round(y, decimal)) {
          done = false;
          break;
        }
      }
      const auto value = kernels::parse_double(decimal.text);
      if (!value) bad_input("a refined number does not fit a double", decimal.text.substr(0, 40));
      out.tokens.push_back(decimal.text);
      out.values.push_back(*value);
    }
    if (done) return out;
    if (attempt >= most_attempts || options.digits + guard > 10000)
      throw Error(Error::Kind::undecided, "cannot decide the last digit of a refined number");
  }
}

}  // namespace

kernels::PointSet refine_points(const Scheme& scheme, const Binding& binding, const kernels::PointSet& points,
                                const RefineOptions& options) {
  check_size(scheme, points, options);
  if (options.boundary == kernels::Boundary::closed && points.size() < 3)
    bad_input("a closed polygon needs at least 3 points, not " + std::to_string(points.size()));
  if (options.boundary == kernels::Boundary::space && !scheme.space)
    bad_input("the scheme has no function space that could extend an open polygon", scheme.id);
  if (options.digits != 0) return refine_digits(scheme, binding, points, options);
  const LowerOptions lowering{options.levels, 0, options.boundary == kernels::Boundary::space, false};
  kernels::PointSet out;
  out.columns = points.columns;
  out.dim = points.dim;
  out.values = kernels::refine(points.values, points.dim, lower(scheme, binding, lowering),
                               static_cast<int>(options.levels), options.boundary);
  for (const double x : out.values)
    if (!std::isfinite(x)) bad_input("a refined number does not fit a double", kernels::shortest(x));
  return out;
}

}  // namespace twoscale::lowering
