// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/symbolic/polynomial.hpp"

#include <flint/arith.h>
#include <flint/fmpz_mpoly_factor.h>
#include <flint/fmpz_poly_factor.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

#include "polynomial_coefficients.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/integer.hpp"

namespace twoscale {

// The variables of a polynomial: none or one in `dense`, two or more in `sparse` with its context.
struct Polynomial::Rep {
  using Names = std::shared_ptr<const std::vector<std::string>>;
  Names table;  // shared: most polynomials of a computation have the same variables
  fmpz_poly_t dense;
  fmpz_mpoly_ctx_t context;
  fmpz_mpoly_t sparse;
  bool multivariate;

  const std::vector<std::string>& names() const { return *table; }

  explicit Rep(Names n) : table(std::move(n)), multivariate(names().size() > 1) {
    if (multivariate) {
      fmpz_mpoly_ctx_init(context, static_cast<slong>(names().size()), ORD_LEX);
      fmpz_mpoly_init(sparse, context);
    } else {
      fmpz_poly_init(dense);
    }
  }
  Rep(const Rep&) = delete;
  Rep& operator=(const Rep&) = delete;
  ~Rep() {
    if (multivariate) {
      fmpz_mpoly_clear(sparse, context);
      fmpz_mpoly_ctx_clear(context);
    } else {
      fmpz_poly_clear(dense);
    }
  }
};

namespace {

using Rep = Polynomial::Rep;
using RepPtr = std::shared_ptr<Rep>;

const Rep::Names no_names = std::make_shared<const std::vector<std::string>>();

RepPtr make(const Rep::Names& names) { return std::make_shared<Rep>(names); }
RepPtr make(std::vector<std::string> names) {
  return make(std::make_shared<const std::vector<std::string>>(std::move(names)));
}

// Copies p into a representation over `names`, a sorted superset of p's variables with at least two members.
RepPtr widen(const Rep& p, const Rep::Names& table) {
  RepPtr r = make(table);
  const std::vector<std::string>& names = *table;
  if (!p.multivariate) {
    std::vector<ulong> exponent(names.size(), 0);
    const auto at = p.names().empty() ? names.end() : std::find(names.begin(), names.end(), p.names()[0]);
    for (slong i = fmpz_poly_degree(p.dense); i >= 0; --i) {
      const fmpz* c = p.dense->coeffs + i;
      if (fmpz_is_zero(c)) continue;
      if (at != names.end()) exponent[static_cast<size_t>(at - names.begin())] = static_cast<ulong>(i);
      fmpz_mpoly_push_term_fmpz_ui(r->sparse, c, exponent.data(), r->context);
    }
  } else {
    std::vector<slong> place(p.names().size());
    for (size_t i = 0; i < place.size(); ++i)
      place[i] = std::find(names.begin(), names.end(), p.names()[i]) - names.begin();
    fmpz_mpoly_compose_fmpz_mpoly_gen(r->sparse, p.sparse, place.data(), p.context, r->context);
  }
  return r;
}

// Restores the canonical form: drops the variables that no longer occur.
std::shared_ptr<const Rep> canonical(RepPtr r) {
  if (!r->multivariate) {
    if (!r->names().empty() && fmpz_poly_degree(r->dense) <= 0) r->table = no_names;
    return r;
  }
  std::vector<int> used(r->names().size(), 0);
  fmpz_mpoly_used_vars(used.data(), r->sparse, r->context);
  if (std::find(used.begin(), used.end(), 0) == used.end()) return r;
  std::vector<std::string> names;
  std::vector<slong> place(used.size(), -1);
  for (size_t i = 0; i < used.size(); ++i)
    if (used[i] != 0) {
      place[i] = static_cast<slong>(names.size());
      names.push_back(r->names()[i]);
    }
  RepPtr s = make(names);
  if (s->multivariate) {
    fmpz_mpoly_compose_fmpz_mpoly_gen(s->sparse, r->sparse, place.data(), r->context, s->context);
    return s;
  }
  std::vector<ulong> exponent(used.size());
  const auto kept = std::find(used.begin(), used.end(), 1);
  Integer c;
  for (slong i = 0; i < fmpz_mpoly_length(r->sparse, r->context); ++i) {
    fmpz_mpoly_get_term_coeff_fmpz(c.v, r->sparse, i, r->context);
    fmpz_mpoly_get_term_exp_ui(exponent.data(), r->sparse, i, r->context);
    const ulong e = kept == used.end() ? 0 : exponent[static_cast<size_t>(kept - used.begin())];
    fmpz_poly_set_coeff_fmpz(s->dense, static_cast<slong>(e), c.v);
  }
  return s;
}

std::vector<std::string> unite(const Rep& a, const Rep& b) {
  std::vector<std::string> names;
  std::set_union(a.names().begin(), a.names().end(), b.names().begin(), b.names().end(), std::back_inserter(names));
  return names;
}

// Calls dense(r, a, b) or sparse(r, a, b) on representations over common variables.
template <class Dense, class Sparse>
std::shared_ptr<const Rep> combine(const Rep& a, const Rep& b, Dense dense, Sparse sparse) {
  if (!a.multivariate && !b.multivariate &&
      (a.names().empty() || b.names().empty() || (a.table == b.table || a.names() == b.names()))) {
    RepPtr r = make(a.names().empty() ? b.table : a.table);
    dense(r->dense, a.dense, b.dense);
    return canonical(std::move(r));
  }
  if (a.multivariate && (a.table == b.table || a.names() == b.names())) {
    RepPtr r = make(a.table);
    sparse(r->sparse, a.sparse, b.sparse, r->context);
    return canonical(std::move(r));
  }
  const auto names = std::make_shared<const std::vector<std::string>>(unite(a, b));
  const RepPtr x = widen(a, names);
  const RepPtr y = widen(b, names);
  RepPtr r = make(names);
  sparse(r->sparse, x->sparse, y->sparse, r->context);
  return canonical(std::move(r));
}

}  // namespace

struct PolynomialAccess {
  static Polynomial wrap(std::shared_ptr<const Rep> r) { return Polynomial(std::move(r)); }
  static const Rep& rep(const Polynomial& p) { return *p.rep_; }
};

namespace {

Polynomial wrap(std::shared_ptr<const Rep> r) { return PolynomialAccess::wrap(std::move(r)); }
const Rep& rep(const Polynomial& p) { return PolynomialAccess::rep(p); }

// The shared representations of 0 and 1: most coefficients of a mask.
std::shared_ptr<const Rep> small_constant(long value) {
  const auto build = [](long v) {
    RepPtr r = make(no_names);
    fmpz_poly_set_si(r->dense, v);
    return std::shared_ptr<const Rep>(r);
  };
  static const std::shared_ptr<const Rep> zero = build(0);
  static const std::shared_ptr<const Rep> one = build(1);
  if (value == 0) return zero;
  if (value == 1) return one;
  return build(value);
}

}  // namespace

Polynomial::Polynomial(long constant) : rep_(small_constant(constant)) {}

Polynomial Polynomial::constant(const fmpz_t value) {
  if (fmpz_is_zero(value) || fmpz_is_one(value)) return Polynomial(fmpz_get_si(value));
  RepPtr r = make(no_names);
  fmpz_poly_set_fmpz(r->dense, value);
  return wrap(r);
}

Polynomial Polynomial::variable(const std::string& name) {
  RepPtr r = make(std::vector<std::string>{name});
  fmpz_poly_set_coeff_si(r->dense, 1, 1);
  return wrap(r);
}

Polynomial Polynomial::univariate(const std::string& name, std::span<const Rational> coefficients) {
  RepPtr r = make(std::vector<std::string>{name});
  for (size_t i = 0; i < coefficients.size(); ++i) {
    if (!coefficients[i].is_integer()) throw std::logic_error("univariate: coefficient is not an integer");
    fmpz_poly_set_coeff_fmpz(r->dense, static_cast<slong>(i), coefficients[i].numerator());
  }
  return wrap(canonical(std::move(r)));
}

Polynomial Polynomial::univariate(const std::string& name, const fmpz_poly_t coefficients) {
  RepPtr r = make(std::vector<std::string>{name});
  fmpz_poly_set(r->dense, coefficients);
  return wrap(canonical(std::move(r)));
}

Polynomial Polynomial::chebyshev(const std::string& name, unsigned n) {
  RepPtr r = make(std::vector<std::string>{name});
  arith_chebyshev_t_polynomial(r->dense, n);
  return wrap(canonical(std::move(r)));
}

Polynomial Polynomial::cosine_minimal(const std::string& name, unsigned d) {
  RepPtr r = make(std::vector<std::string>{name});
  arith_cos_minpoly(r->dense, d);
  fmpz_poly_primitive_part(r->dense, r->dense);
  return wrap(canonical(std::move(r)));
}

const std::vector<std::string>& Polynomial::variables() const { return rep_->names(); }

bool Polynomial::is_zero() const { return !rep_->multivariate && fmpz_poly_is_zero(rep_->dense) != 0; }

bool Polynomial::is_one() const { return !rep_->multivariate && fmpz_poly_is_one(rep_->dense) != 0; }

Rational Polynomial::constant_value() const {
  if (!is_constant()) throw std::logic_error("constant_value of a polynomial that is not constant");
  Rational r;
  fmpz_poly_get_coeff_fmpz(fmpq_numref(r.raw()), rep_->dense, 0);
  return r;
}

long Polynomial::degree(const std::string& variable) const {
  if (is_zero()) return -1;
  const auto at = std::find(rep_->names().begin(), rep_->names().end(), variable);
  if (at == rep_->names().end()) return 0;
  if (!rep_->multivariate) return fmpz_poly_degree(rep_->dense);
  return fmpz_mpoly_degree_si(rep_->sparse, at - rep_->names().begin(), rep_->context);
}

long Polynomial::total_degree() const {
  return rep_->multivariate ? fmpz_mpoly_total_degree_si(rep_->sparse, rep_->context) : fmpz_poly_degree(rep_->dense);
}

long Polynomial::terms() const {
  if (rep_->multivariate) return fmpz_mpoly_length(rep_->sparse, rep_->context);
  long n = 0;
  for (slong i = 0; i < fmpz_poly_length(rep_->dense); ++i) n += fmpz_is_zero(rep_->dense->coeffs + i) ? 0 : 1;
  return n;
}

int Polynomial::leading_sign() const {
  if (is_zero()) return 0;
  if (!rep_->multivariate) return fmpz_sgn(fmpz_poly_lead(rep_->dense));
  Integer c;
  fmpz_mpoly_get_term_coeff_fmpz(c.v, rep_->sparse, 0, rep_->context);
  return fmpz_sgn(c.v);
}

Rational Polynomial::content() const {
  Rational r;
  if (rep_->multivariate) {
    Integer k;
    for (slong i = 0; i < fmpz_mpoly_length(rep_->sparse, rep_->context); ++i) {
      fmpz_mpoly_get_term_coeff_fmpz(k.v, rep_->sparse, i, rep_->context);
      fmpz_gcd(fmpq_numref(r.raw()), fmpq_numref(r.raw()), k.v);
      if (fmpz_is_one(fmpq_numref(r.raw()))) break;
    }
  } else {
    fmpz_poly_content(fmpq_numref(r.raw()), rep_->dense);
  }
  return r;
}

bool Polynomial::all_coefficients_nonnegative() const {
  bool good = true;
  for_each_term([&](const Rational& c, std::span<const unsigned long>) { good = good && c.sign() > 0; });
  return good;
}

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
  return wrap(combine(rep(a), rep(b), fmpz_poly_add, fmpz_mpoly_add));
}

Polynomial operator-(const Polynomial& a, const Polynomial& b) {
  return wrap(combine(rep(a), rep(b), fmpz_poly_sub, fmpz_mpoly_sub));
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  if (a.is_one()) return b;
  if (b.is_one()) return a;
  if (a.is_constant()) return b.scaled(a.constant_value());
  if (b.is_constant()) return a.scaled(b.constant_value());
  return wrap(combine(rep(a), rep(b), fmpz_poly_mul, fmpz_mpoly_mul));
}

Polynomial Polynomial::operator-() const { return scaled(-1); }

bool operator==(const Polynomial& a, const Polynomial& b) {
  const Rep& x = rep(a);
  const Rep& y = rep(b);
  if (&x == &y) return true;
  if (x.table != y.table && x.names() != y.names()) return false;
  if (x.multivariate) return fmpz_mpoly_equal(x.sparse, y.sparse, x.context) != 0;
  return fmpz_poly_equal(x.dense, y.dense) != 0;
}

int Polynomial::compare(const Polynomial& a, const Polynomial& b) {
  if (a == b) return 0;
  if (a.total_degree() != b.total_degree()) return a.total_degree() < b.total_degree() ? -1 : 1;
  if (a.variables() != b.variables()) return a.variables() < b.variables() ? -1 : 1;
  if (!rep(a).multivariate) {  // the same order as below, read off the coefficients
    for (slong i = fmpz_poly_degree(rep(a).dense);; --i) {
      const fmpz* p = rep(a).dense->coeffs + i;
      const fmpz* q = rep(b).dense->coeffs + i;
      if (fmpz_equal(p, q)) continue;
      if (fmpz_is_zero(p) || fmpz_is_zero(q)) return fmpz_is_zero(p) ? -1 : 1;
      return fmpz_cmp(p, q) < 0 ? -1 : 1;
    }
  }
  std::vector<std::pair<std::vector<unsigned long>, Rational>> x, y;
  const auto collect = [](auto& into) {
    return [&into](const Rational& c, std::span<const unsigned long> e) {
      into.emplace_back(std::vector<unsigned long>(e.begin(), e.end()), c);
    };
  };
  a.for_each_term(collect(x));
  b.for_each_term(collect(y));
  for (size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    if (x[i].first != y[i].first) return x[i].first < y[i].first ? -1 : 1;
    if (x[i].second != y[i].second) return x[i].second < y[i].second ? -1 : 1;
  }
  return x.size() < y.size() ? -1 : 1;
}

Polynomial Polynomial::scaled(const Rational& factor) const {
  if (factor == Rational(1)) return *this;
  if (factor.is_zero()) return 0;
  RepPtr r = make(rep_->table);
  if (rep_->multivariate) {
    fmpz_mpoly_scalar_mul_fmpz(r->sparse, rep_->sparse, factor.numerator(), r->context);
    fmpz_mpoly_scalar_divexact_fmpz(r->sparse, r->sparse, factor.denominator(), r->context);
  } else if (fmpz_is_one(factor.numerator())) {
    fmpz_poly_scalar_divexact_fmpz(r->dense, rep_->dense, factor.denominator());
  } else {
    fmpz_poly_scalar_mul_fmpz(r->dense, rep_->dense, factor.numerator());
    if (!factor.is_integer()) fmpz_poly_scalar_divexact_fmpz(r->dense, r->dense, factor.denominator());
  }
  return wrap(std::move(r));
}

Polynomial Polynomial::combination(const Rational& x, const Polynomial& a, const Rational& y, const Polynomial& b) {
  if (rep(a).multivariate || rep(b).multivariate || a.variables() != b.variables()) return a.scaled(x) + b.scaled(y);
  RepPtr r = make(rep(a).table);
  fmpz_poly_scalar_mul_fmpz(r->dense, rep(a).dense, x.numerator());
  fmpz_poly_scalar_addmul_fmpz(r->dense, rep(b).dense, y.numerator());
  return wrap(canonical(std::move(r)));
}

Polynomial Polynomial::pow(unsigned exponent) const {
  if (exponent == 0) return 1;
  if (exponent == 1) return *this;
  RepPtr r = make(rep_->table);
  if (rep_->multivariate) {
    if (!fmpz_mpoly_pow_ui(r->sparse, rep_->sparse, exponent, r->context)) bad_input("power is too large");
  } else {
    fmpz_poly_pow(r->dense, rep_->dense, exponent);
  }
  return wrap(canonical(std::move(r)));
}

namespace {

// Sums of the coefficients of even and of odd powers.
void halves(fmpz_t even, fmpz_t odd, const fmpz_poly_t p) {
  for (slong i = 0; i < fmpz_poly_length(p); ++i) {
    fmpz* sum = i % 2 == 0 ? even : odd;
    fmpz_add(sum, sum, p->coeffs + i);
  }
}

// What is cheap to see: b does not divide a because b(0) does not divide a(0), or because of the values at 1 or -1.
bool cannot_divide(const fmpz_poly_t a, const fmpz_poly_t b) {
  if (!fmpz_poly_is_zero(a) && !fmpz_poly_is_zero(b)) {
    const fmpz* constant = b->coeffs;
    if (fmpz_is_zero(constant) ? !fmpz_is_zero(a->coeffs) : fmpz_divisible(a->coeffs, constant) == 0) return true;
  }
  Integer a_even, a_odd, b_even, b_odd;
  halves(a_even.v, a_odd.v, a);
  halves(b_even.v, b_odd.v, b);
  Integer x, y;
  const auto divides = [&] { return fmpz_is_zero(y.v) ? fmpz_is_zero(x.v) : fmpz_divisible(x.v, y.v); };
  fmpz_add(x.v, a_even.v, a_odd.v);
  fmpz_add(y.v, b_even.v, b_odd.v);
  if (divides() == 0) return true;
  fmpz_sub(x.v, a_even.v, a_odd.v);
  fmpz_sub(y.v, b_even.v, b_odd.v);
  return divides() == 0;
}

}  // namespace

std::optional<Polynomial> Polynomial::quotient(const Polynomial& a, const Polynomial& b) {
  if (b.is_zero()) throw std::logic_error("quotient by the zero polynomial");
  if (!rep(a).multivariate && !rep(b).multivariate &&
      (a.is_constant() || b.is_constant() || a.variables() == b.variables()) &&
      cannot_divide(rep(a).dense, rep(b).dense))
    return std::nullopt;
  bool divides = false;
  auto r = combine(
      rep(a), rep(b), [&](auto* q, const auto* x, const auto* y) { divides = fmpz_poly_divides(q, x, y) != 0; },
      [&](auto* q, const auto* x, const auto* y, const auto* ctx) { divides = fmpz_mpoly_divides(q, x, y, ctx) != 0; });
  if (!divides) return std::nullopt;
  return wrap(std::move(r));
}

Polynomial Polynomial::exact_quotient(const Polynomial& a, const Polynomial& b) {
  if (b.is_one()) return a;
  auto q = quotient(a, b);
  if (!q) throw std::logic_error("exact_quotient: does not divide");
  return *std::move(q);
}

std::pair<Polynomial, unsigned> Polynomial::remove(const Polynomial& factor) const {
  if (is_zero() || factor.is_constant()) throw std::logic_error("remove: needs a non-zero polynomial and a non-unit");
  Polynomial p = *this;
  unsigned e = 0;
  while (auto q = quotient(p, factor)) {
    p = *std::move(q);
    ++e;
  }
  return {p, e};
}

Polynomial Polynomial::gcd(const Polynomial& a, const Polynomial& b) {
  bool done = true;
  auto r = combine(rep(a), rep(b), fmpz_poly_gcd, [&](auto* g, const auto* x, const auto* y, const auto* ctx) {
    done = fmpz_mpoly_gcd(g, x, y, ctx) != 0;
  });
  if (!done) throw Error(Error::Kind::undecided, "greatest common divisor could not be found");
  return wrap(std::move(r));
}

Polynomial Polynomial::resultant(const Polynomial& a, const Polynomial& b, const std::string& variable) {
  if (a.is_zero() || b.is_zero()) return 0;
  if (a.degree(variable) == 0) return a.pow(static_cast<unsigned>(b.degree(variable)));
  if (b.degree(variable) == 0) return b.pow(static_cast<unsigned>(a.degree(variable)));
  std::vector<std::string> names = a.variables();
  names.insert(names.end(), b.variables().begin(), b.variables().end());
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  const auto place = static_cast<slong>(std::find(names.begin(), names.end(), variable) - names.begin());
  bool done = true;
  const auto dense = [](fmpz_poly_struct* r, const fmpz_poly_struct* x, const fmpz_poly_struct* y) {
    Integer value;
    fmpz_poly_resultant(value.v, x, y);
    fmpz_poly_set_fmpz(r, value.v);
  };
  auto r = combine(rep(a), rep(b), dense, [&](auto* out, const auto* x, const auto* y, const auto* ctx) {
    done = fmpz_mpoly_resultant(out, x, y, place, ctx) != 0;
  });
  if (!done) throw Error(Error::Kind::undecided, "a resultant could not be found");
  return wrap(std::move(r));
}

Polynomial Polynomial::derivative(const std::string& variable) const {
  const auto at = std::find(rep_->names().begin(), rep_->names().end(), variable);
  if (at == rep_->names().end()) return 0;
  RepPtr r = make(rep_->table);
  if (rep_->multivariate)
    fmpz_mpoly_derivative(r->sparse, rep_->sparse, at - rep_->names().begin(), r->context);
  else
    fmpz_poly_derivative(r->dense, rep_->dense);
  return wrap(canonical(std::move(r)));
}

std::vector<Polynomial> coefficients_of(const Polynomial& p, const std::string& variable) {
  const Rep& r = rep(p);
  const auto at = std::find(r.names().begin(), r.names().end(), variable);
  if (at == r.names().end()) return {p};
  std::vector<Polynomial> result;
  if (!r.multivariate) {
    for (slong i = 0; i <= fmpz_poly_degree(r.dense); ++i) result.push_back(Polynomial::constant(r.dense->coeffs + i));
    return result;
  }
  // Terms come in descending order, and so do those of each coefficient.
  const auto place = static_cast<size_t>(at - r.names().begin());
  std::vector<RepPtr> parts;
  for (long e = 0; e <= p.degree(variable); ++e) parts.push_back(make(r.table));
  std::vector<ulong> exponents(r.names().size());
  Integer c;
  for (slong i = 0; i < fmpz_mpoly_length(r.sparse, r.context); ++i) {
    fmpz_mpoly_get_term_coeff_fmpz(c.v, r.sparse, i, r.context);
    fmpz_mpoly_get_term_exp_ui(exponents.data(), r.sparse, i, r.context);
    Rep& part = *parts[exponents[place]];
    exponents[place] = 0;
    fmpz_mpoly_push_term_fmpz_ui(part.sparse, c.v, exponents.data(), part.context);
  }
  for (RepPtr& part : parts) result.push_back(wrap(canonical(std::move(part))));
  return result;
}

Polynomial Polynomial::substitute(const std::string& variable, const Polynomial& by) const {
  if (std::find(rep_->names().begin(), rep_->names().end(), variable) == rep_->names().end()) return *this;
  Polynomial r;
  const std::vector<Polynomial> c = coefficients_of(*this, variable);
  for (size_t e = c.size(); e-- > 0;) r = r * by + c[e];
  return r;
}

Rational Polynomial::evaluate(const std::vector<std::pair<std::string, Rational>>& at) const {
  std::vector<Rational> values;
  for (const auto& name : rep_->names()) {
    const auto it = std::find_if(at.begin(), at.end(), [&](const auto& p) { return p.first == name; });
    if (it == at.end()) throw std::logic_error("evaluate: no value for " + name);
    values.push_back(it->second);
  }
  Rational r;
  if (!rep_->multivariate) {
    if (values.empty()) return constant_value();
    fmpz_poly_evaluate_fmpq(r.raw(), rep_->dense, values[0].raw());
    return r;
  }
  for_each_term([&](const Rational& c, std::span<const unsigned long> e) {
    Rational term = c;
    for (size_t i = 0; i < e.size(); ++i) term *= values[i].pow(static_cast<long>(e[i]));
    r += term;
  });
  return r;
}

Polynomial::Factorization Polynomial::factor() const {
  if (is_zero()) throw std::logic_error("factor of the zero polynomial");
  Factorization result;
  const auto add = [&](Polynomial f, unsigned e) {
    if (f.is_constant()) {
      result.content *= f.constant_value().pow(static_cast<long>(e));
      return;
    }
    if (f.leading_sign() < 0) {
      f = -f;
      if (e % 2 == 1) result.content = -result.content;
    }
    result.factors.emplace_back(std::move(f), e);
  };
  if (rep_->multivariate) {
    fmpz_mpoly_factor_t f;
    fmpz_mpoly_factor_init(f, rep_->context);
    const bool done = fmpz_mpoly_factor(f, rep_->sparse, rep_->context) != 0;
    if (done) {
      Integer c;
      fmpz_mpoly_factor_get_constant_fmpz(c.v, f, rep_->context);
      result.content = Rational(c.v);
      for (slong i = 0; i < fmpz_mpoly_factor_length(f, rep_->context); ++i) {
        RepPtr r = make(rep_->table);
        fmpz_mpoly_factor_get_base(r->sparse, f, i, rep_->context);
        add(wrap(canonical(std::move(r))), static_cast<unsigned>(fmpz_mpoly_factor_get_exp_si(f, i, rep_->context)));
      }
    }
    fmpz_mpoly_factor_clear(f, rep_->context);
    if (!done) throw Error(Error::Kind::undecided, "polynomial could not be factored");
  } else {
    fmpz_poly_factor_t f;
    fmpz_poly_factor_init(f);
    fmpz_poly_factor(f, rep_->dense);
    result.content = Rational(&f->c);
    for (slong i = 0; i < f->num; ++i) {
      RepPtr r = make(rep_->table);
      fmpz_poly_set(r->dense, f->p + i);
      add(wrap(canonical(std::move(r))), static_cast<unsigned>(f->exp[i]));
    }
    fmpz_poly_factor_clear(f);
  }
  std::sort(result.factors.begin(), result.factors.end(),
            [](const auto& a, const auto& b) { return compare(a.first, b.first) < 0; });
  return result;
}

long Polynomial::positive_zeros() const {
  if (is_constant()) return 0;
  if (all_coefficients_nonnegative() || (-*this).all_coefficients_nonnegative()) return 0;
  const Polynomial x = variable(rep_->names().at(0));
  Polynomial squarefree = 1;
  for (const auto& [f, e] : remove(x).first.factor().factors) squarefree *= f;
  return fmpz_poly_num_real_roots(squarefree.substitute(rep_->names()[0], x * x).univariate_view()) / 2;
}

void Polynomial::for_each_term(const std::function<void(const Rational&, std::span<const unsigned long>)>& f) const {
  if (!rep_->multivariate) {
    for (slong i = fmpz_poly_degree(rep_->dense); i >= 0; --i) {
      if (fmpz_is_zero(rep_->dense->coeffs + i)) continue;
      const std::array<unsigned long, 1> e{static_cast<unsigned long>(i)};
      f(Rational(rep_->dense->coeffs + i), std::span<const unsigned long>(e.data(), rep_->names().size()));
    }
    return;
  }
  std::vector<unsigned long> e(rep_->names().size());
  Integer c;
  for (slong i = 0; i < fmpz_mpoly_length(rep_->sparse, rep_->context); ++i) {
    fmpz_mpoly_get_term_coeff_fmpz(c.v, rep_->sparse, i, rep_->context);
    fmpz_mpoly_get_term_exp_ui(e.data(), rep_->sparse, i, rep_->context);
    f(Rational(c.v), e);
  }
}

namespace {

std::string print(const Polynomial& p, bool spaced, bool latex) {
  if (p.is_zero()) return "0";
  std::string s;
  const std::string times = latex ? " " : "*";
  p.for_each_term([&](const Rational& c, std::span<const unsigned long> e) {
    const Rational size = abs(c);
    const bool negative = c.sign() < 0;
    if (s.empty())
      s += negative ? "-" : "";
    else
      s += spaced ? (negative ? " - " : " + ") : (negative ? "-" : "+");
    std::string monomial;
    for (size_t i = 0; i < e.size(); ++i) {
      if (e[i] == 0) continue;
      if (!monomial.empty()) monomial += times;
      monomial += latex ? latex_name(p.variables()[i]) : p.variables()[i];
      if (e[i] > 1) monomial += latex ? "^{" + std::to_string(e[i]) + "}" : "^" + std::to_string(e[i]);
    }
    if (monomial.empty())
      s += size.to_string();
    else
      s += (size == Rational(1) ? "" : size.to_string() + times) + monomial;
  });
  return s;
}

}  // namespace

std::string Polynomial::to_string() const { return print(*this, false, false); }

std::string Polynomial::pretty(Style style) const { return print(*this, true, style == Style::latex); }

const fmpz_poly_struct* Polynomial::univariate_view() const {
  if (rep_->multivariate) throw std::logic_error("univariate_view of a polynomial in several variables");
  return rep_->dense;
}

std::string latex_name(const std::string& variable) {
  static const std::vector<std::string> greek = {"alpha", "beta",  "gamma", "delta", "theta", "lambda",
                                                 "mu",    "omega", "rho",   "sigma", "tau"};
  const auto word = [](const std::string& w) {
    return std::find(greek.begin(), greek.end(), w) != greek.end() ? "\\" + w : w;
  };
  const auto bar = variable.find('_');
  if (bar == std::string::npos) {
    const std::string w = word(variable);
    return w.size() > 1 && w[0] != '\\' ? "\\mathit{" + w + "}" : w;
  }
  return word(variable.substr(0, bar)) + "_{" + word(variable.substr(bar + 1)) + "}";
}

}  // namespace twoscale
