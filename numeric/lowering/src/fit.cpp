// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/lowering/fit.hpp"

#include <acb.h>
#include <arb_fmpz_poly.h>
#include <flint/fmpz_poly.h>
#include <flint/fmpz_poly_factor.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "rounding.hpp"
#include "twoscale/kernels/number_text.hpp"
#include "twoscale/symbolic/ball.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"
#include "twoscale/symbolic/interpolatory.hpp"

namespace twoscale::lowering {

namespace {

constexpr long root_bits = 192;
constexpr long most_digits = 4000;  // between the largest and the smallest decimal of the data

struct IntegerPolynomial {
  fmpz_poly_t p;
  IntegerPolynomial() { fmpz_poly_init(p); }
  IntegerPolynomial(const IntegerPolynomial& o) : IntegerPolynomial() { fmpz_poly_set(p, o.p); }
  IntegerPolynomial(IntegerPolynomial&& o) noexcept : IntegerPolynomial() { fmpz_poly_swap(p, o.p); }
  IntegerPolynomial& operator=(IntegerPolynomial o) noexcept {
    fmpz_poly_swap(p, o.p);
    return *this;
  }
  ~IntegerPolynomial() { fmpz_poly_clear(p); }
};

// The data times a power of ten, row-major.
std::vector<Rational> integers(const kernels::PointSet& points) {
  std::vector<Rational> x;
  for (size_t i = 0; i < points.values.size(); ++i)
    x.push_back(exact_decimal(i < points.tokens.size() ? points.tokens[i] : kernels::shortest(points.values[i])));
  Rational common(1);
  for (const Rational& v : x) {
    Rational l;
    fmpz_lcm(fmpq_numref(l.raw()), common.numerator(), v.denominator());
    common = l;
    if (fmpz_sizeinbase(common.numerator(), 10) > most_digits)
      bad_input("the numbers have too many decimals", v.to_string().substr(0, 40));
  }
  for (Rational& v : x) {
    v *= common;
    if (fmpz_sizeinbase(v.numerator(), 10) > 2 * most_digits)
      bad_input("the numbers span too many orders of magnitude");
  }
  return x;
}

// r_j(v) for all j and components: residual j*dim + c.
std::vector<IntegerPolynomial> residuals(const Space& space, const std::vector<Rational>& x, size_t dim, bool closed) {
  // f_0 = 1, f_i = -e_{i-1} up to a common sign.
  std::vector<Polynomial> f{Polynomial(1)};
  for (const Polynomial& e : extension_weights(space, 1)) f.push_back(-e);
  const size_t n = x.size() / dim;
  const size_t count = closed ? n : n + 1 > f.size() ? n + 1 - f.size() : 0;
  std::vector<IntegerPolynomial> r(count * dim);
  for (size_t j = 0; j < count; ++j)
    for (size_t i = 0; i < f.size(); ++i)
      for (size_t c = 0; c < dim; ++c)
        fmpz_poly_scalar_addmul_fmpz(r[j * dim + c].p, f[i].univariate_view(), x[((j + i) % n) * dim + c].numerator());
  return r;
}

// max_j of the Euclidean lengths of the vectors j at v: residuals, or their derivatives.
Ball longest(const std::vector<IntegerPolynomial>& r, size_t dim, const Ball& v, long bits, bool derivative) {
  Ball best, sum, value;
  IntegerPolynomial d;
  for (size_t j = 0; j < r.size(); j += dim) {
    arb_zero(sum.raw());
    for (size_t c = 0; c < dim; ++c) {
      if (derivative) fmpz_poly_derivative(d.p, r[j + c].p);
      arb_fmpz_poly_evaluate_arb(value.raw(), derivative ? d.p : r[j + c].p, v.raw(), bits);
      arb_addmul(sum.raw(), value.raw(), value.raw(), bits);
    }
    arb_max(best.raw(), best.raw(), sum.raw(), bits);
  }
  arb_sqrtpos(best.raw(), best.raw(), bits);
  return best;
}

struct Candidate {
  Ball v0;
  arf_t spread;
  Candidate() { arf_init(spread); }
  Candidate(const Candidate& o) : v0(o.v0) {
    arf_init(spread);
    arf_set(spread, o.spread);
  }
  Candidate(Candidate&& o) noexcept : v0(std::move(o.v0)) {
    arf_init(spread);
    arf_swap(spread, o.spread);
  }
  Candidate& operator=(Candidate o) noexcept {
    std::swap(v0, o.v0);
    arf_swap(spread, o.spread);
    return *this;
  }
  ~Candidate() { arf_clear(spread); }
};

// The stationary point v > -1 of sum |r_j(v)|^2 with the smallest spread, if there is one.
std::optional<Candidate> best_candidate(const std::vector<IntegerPolynomial>& r, size_t dim) {
  IntegerPolynomial sum, square;
  for (const IntegerPolynomial& p : r) {
    fmpz_poly_sqr(square.p, p.p);
    fmpz_poly_add(sum.p, sum.p, square.p);
  }
  long data_bits = 0;
  for (const IntegerPolynomial& p : r) data_bits = std::max(data_bits, std::labs(fmpz_poly_max_bits(p.p)));
  fmpz_poly_derivative(sum.p, sum.p);
  if (fmpz_poly_degree(sum.p) < 1) return std::nullopt;
  std::vector<Ball> roots;
  fmpz_poly_factor_t f;
  fmpz_poly_factor_init(f);
  fmpz_poly_factor_squarefree(f, sum.p);
  for (slong i = 0; i < f->num; ++i) {
    const slong d = fmpz_poly_degree(f->p + i);
    acb_ptr z = _acb_vec_init(d);
    arb_fmpz_poly_complex_roots(z, f->p + i, 0, root_bits);
    for (slong k = 0; k < d; ++k) {
      if (!arb_is_zero(acb_imagref(z + k))) continue;
      Ball root;
      arb_set(root.raw(), acb_realref(z + k));
      roots.push_back(std::move(root));
    }
    _acb_vec_clear(z, d);
  }
  fmpz_poly_factor_clear(f);
  std::optional<Candidate> best;
  for (const Ball& v : roots) {
    Ball above;
    arb_add_ui(above.raw(), v.raw(), 1, root_bits);
    if (!above.is_positive()) continue;
    const long bits = root_bits + 2 * data_bits;
    Ball middle;  // the spread is asked for at the number that is printed, near enough
    arb_get_mid_arb(middle.raw(), v.raw());
    const Ball top = longest(r, dim, middle, bits, false);
    const Ball bottom = longest(r, dim, middle, bits, true);
    Ball ratio;
    arb_div(ratio.raw(), top.raw(), bottom.raw(), bits);
    if (!ratio.is_finite()) continue;
    Candidate c;
    c.v0 = v;
    arb_get_ubound_arf(c.spread, ratio.raw(), 60);
    // The root is known to 2^-192 only.
    if (arf_cmpabs_2exp_si(c.spread, -150) < 0) arf_zero(c.spread);
    if (!best || arf_cmp(c.spread, best->spread) < 0) best = std::move(c);
  }
  return best;
}

// The subspaces to try, the whole space last.
std::vector<Space> subspaces(const Space& space) {
  unsigned orders = 0;
  std::set<unsigned> multiples;
  for (const auto& e : space.exponentials()) {
    orders = std::max(orders, e.order);
    multiples.insert(e.multiple);
  }
  std::vector<Space> list;
  for (unsigned order = 1; order <= orders; ++order)
    for (const unsigned highest : multiples) {
      std::vector<std::pair<unsigned, unsigned>> kept;
      for (const auto& e : space.exponentials())
        if (e.multiple <= highest) kept.emplace_back(e.multiple, std::min(order, e.order));
      list.push_back(Space::one_frequency(space.polynomial_order(), kept));
      if (list.size() > 64) return {space};
    }
  return list;
}

// A decimal (1e-9) or an expression with a rational value.
Rational positive_rational(const std::string& text) {
  const auto value = kernels::is_decimal(text) ? std::optional(exact_decimal(text)) : parse_real(text).rational();
  if (!value || value->sign() <= 0) bad_input("the tolerance must be a positive rational number", text);
  return *value;
}

std::string frequency(const Ball& v0, bool cosines) {
  Ball offset, angle;
  arb_sub_ui(offset.raw(), v0.raw(), 1, root_bits);
  const bool hyperbolic = offset.is_positive();
  if (!hyperbolic && !offset.is_negative()) return "0";
  if (hyperbolic)
    arb_acosh(angle.raw(), v0.raw(), root_bits);
  else
    arb_acos(angle.raw(), v0.raw(), root_bits);
  return kernels::shortest(arf_get_d(arb_midref(angle.raw()), ARF_RND_NEAR)) + (hyperbolic == cosines ? "*I" : "");
}

// The largest v > -1 with T_g(v) = w, that is the lowest frequency: cosh(acosh(w)/g).
Ball lowest_frequency(const Ball& w, unsigned g) {
  if (g == 1) return w;
  Ball offset, v;
  arb_sub_ui(offset.raw(), w.raw(), 1, root_bits);
  if (offset.is_positive()) {
    arb_acosh(v.raw(), w.raw(), root_bits);
    arb_div_ui(v.raw(), v.raw(), g, root_bits);
    arb_cosh(v.raw(), v.raw(), root_bits);
  } else if (offset.is_negative()) {
    arb_acos(v.raw(), w.raw(), root_bits);
    arb_div_ui(v.raw(), v.raw(), g, root_bits);
    arb_cos(v.raw(), v.raw(), root_bits);
  } else {
    arb_one(v.raw());
  }
  return v;
}

}  // namespace

Fit fit(const Space& given, const kernels::PointSet& points, bool closed, const std::string& tolerance) {
  if (given.exponentials().empty()) bad_input("the space has no frequency to fit", given.to_string());
  if (given.variables().size() > 1) bad_input("the space has several frequencies, a fit needs one", given.to_string());
  if (given.variables()[0].value()) bad_input("the frequency of the space is fixed", given.variables()[0].frequency());
  // Several v^0 belong to the same samples if all multiples have a common factor g (dual schemes in half a frequency):
  // the fit is for T_g(v^0), and the lowest frequency is named.
  unsigned g = 0;
  for (const auto& e : given.exponentials()) g = std::gcd(g, e.multiple);
  std::vector<std::pair<unsigned, unsigned>> multiples;
  for (const auto& e : given.exponentials()) multiples.emplace_back(e.multiple / g, e.order);
  const Space space = Space::one_frequency(given.polynomial_order(), multiples);
  const Rational limit = positive_rational(tolerance);
  const size_t needed = closed ? 3 : space.dimension() + 1;
  if (points.dim == 0 || points.size() < needed)
    bad_input("a fit needs at least " + std::to_string(needed) + " points here, not " + std::to_string(points.size()));
  const std::vector<Rational> x = integers(points);
  Rational largest;
  for (const Rational& v : x) largest = std::max(largest, abs(v));

  Fit result;
  const std::vector<Space> list = subspaces(space);
  for (size_t i = 0; i < list.size(); ++i) {
    const auto r = residuals(list[i], x, points.dim, closed);
    // Nothing left but rounding errors: the data do not depend on the frequency.
    Rational size;
    for (const IntegerPolynomial& p : r)
      for (slong q = 0; q < fmpz_poly_length(p.p); ++q) size = std::max(size, abs(Rational(p.p->coeffs + q)));
    if (size <= largest * std::max(limit / Rational(1000), Rational(10).pow(-13))) {
      result = {Fit::Outcome::any, "", "", "0"};
      return result;
    }
    const auto best = best_candidate(r, points.dim);
    if (!best) continue;
    const Ball v0 = lowest_frequency(best->v0, g);
    const bool fits = to_rational(best->spread) <= limit;
    if (!fits && i + 1 < list.size()) continue;
    result.outcome = fits ? Fit::Outcome::found : Fit::Outcome::none;
    result.v0 = kernels::shortest(arf_get_d(arb_midref(v0.raw()), ARF_RND_NEAR));
    result.t = frequency(v0, given.variables()[0].trigonometric);
    result.spread = rounded_up(best->spread);
    if (fits) return result;
  }
  return result;
}

}  // namespace twoscale::lowering
