// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluator.hpp"

#include <algorithm>

namespace twoscale::lowering {

static_assert(sizeof(Ball) == sizeof(arb_struct), "tables of balls are read as arrays of arb_struct");

Polynomial shifted_by_one(const Polynomial& p, const std::vector<Variable>& variables) {
  const auto& names = p.variables();
  if (names.size() == 1) {
    const auto v =
        std::find_if(variables.begin(), variables.end(), [&](const Variable& x) { return x.name == names[0]; });
    if (v == variables.end() || v->level == nullptr) return p;
    fmpz_poly_t shifted;
    fmpz_poly_init(shifted);
    fmpz_t one;
    fmpz_init_set_ui(one, 1);
    fmpz_poly_taylor_shift(shifted, p.univariate_view(), one);
    Polynomial r = Polynomial::univariate(names[0], shifted);
    fmpz_clear(one);
    fmpz_poly_clear(shifted);
    return r;
  }
  Polynomial r = p;
  for (const Variable& v : variables)
    if (v.level != nullptr) r = r.substitute(v.name, Polynomial::variable(v.name) + 1);
  return r;
}

Form::Form(const Polynomial& p, const std::vector<Variable>& variables) : shifted_(shifted_by_one(p, variables)) {
  prepare(variables);
}

Form Form::of_shifted(const Polynomial& shifted, const std::vector<Variable>& variables) {
  Form f;
  f.shifted_ = shifted;
  f.prepare(variables);
  return f;
}

Form::Form(const Form& o) = default;
Form::Form(Form&& o) noexcept = default;
Form& Form::operator=(Form o) noexcept {
  std::swap(shifted_, o.shifted_);
  std::swap(variable_, o.variable_);
  std::swap(valuation_, o.valuation_);
  std::swap(degrees_, o.degrees_);
  std::swap(terms_, o.terms_);
  return *this;
}
Form::~Form() = default;

long Form::degree(size_t variable) const { return degrees_[variable]; }

void Form::prepare(const std::vector<Variable>& variables) {
  degrees_.assign(variables.size(), 0);
  const auto& names = shifted_.variables();
  std::vector<size_t> place;
  for (const auto& n : names) {
    const auto v = std::find_if(variables.begin(), variables.end(), [&](const Variable& x) { return x.name == n; });
    place.push_back(static_cast<size_t>(v - variables.begin()));
    degrees_[place.back()] = shifted_.degree(n);
  }
  if (names.size() == 1) {
    variable_ = static_cast<int>(place[0]);
    const fmpz_poly_struct* p = shifted_.univariate_view();
    while (fmpz_is_zero(p->coeffs + valuation_)) ++valuation_;
    return;
  }
  if (names.empty()) return;
  shifted_.for_each_term([&](const Rational& c, std::span<const unsigned long> e) {
    Term t{c, std::vector<unsigned>(variables.size())};
    for (size_t i = 0; i < e.size(); ++i) t.exponents[place[i]] = static_cast<unsigned>(e[i]);
    terms_.push_back(std::move(t));
  });
}

Point::Point(std::vector<long> degrees, long valuation, bool several)
    : degrees_(std::move(degrees)), valuation_(valuation), several_(several), powers_(degrees_.size()) {
  for (size_t i = 0; i < degrees_.size(); ++i) powers_[i].resize(static_cast<size_t>(degrees_[i]) + 1);
}

void Point::set(const std::vector<const arb_struct*>& values, long bits) {
  bits_ = bits;
  for (size_t i = 0; i < degrees_.size(); ++i) {
    std::vector<Ball>& p = powers_[i];
    arb_one(p[0].raw());
    if (p.size() == 1) continue;
    arb_set(p[1].raw(), values[i]);
    // |u| < 2^-shrink
    long shrink = 0;
    if (!several_ && !arb_is_zero(values[i]) && !COEFF_IS_MPZ(ARF_EXP(arb_midref(values[i]))))
      shrink = std::max(0L, -static_cast<long>(ARF_EXP(arb_midref(values[i]))) - 1);
    for (size_t j = 2; j < p.size(); ++j) {
      const long past = std::max(0L, static_cast<long>(j) - valuation_);
      const long b = std::max(32L, bits - past * shrink + 8);
      if (j % 2 == 0)
        arb_sqr(p[j].raw(), p[j / 2].raw(), b);
      else
        arb_mul(p[j].raw(), p[j / 2].raw(), p[j - j / 2].raw(), b);
    }
  }
}

void Point::evaluate(arb_t result, const Form& form) const {
  if (form.variable_ >= 0) {
    const fmpz_poly_struct* p = form.shifted_.univariate_view();
    const auto& powers = powers_[static_cast<size_t>(form.variable_)];
    arb_dot_fmpz(result, nullptr, 0, powers[0].raw(), 1, p->coeffs, 1, p->length, bits_);
    return;
  }
  if (form.terms_.empty()) {
    arb_set_fmpz(result, form.shifted_.constant_value().numerator());
    return;
  }
  Ball sum, term;
  for (const Form::Term& t : form.terms_) {
    arb_set_fmpz(term.raw(), t.coefficient.numerator());
    for (size_t i = 0; i < t.exponents.size(); ++i)
      if (t.exponents[i] != 0) arb_mul(term.raw(), term.raw(), powers_[i][t.exponents[i]].raw(), bits_);
    arb_add(sum.raw(), sum.raw(), term.raw(), bits_);
  }
  arb_swap(result, sum.raw());
}

}  // namespace twoscale::lowering
