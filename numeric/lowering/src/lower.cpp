// SPDX-License-Identifier: GPL-3.0-or-later
// Mask tables. Notation: coefficients a_i = N_i/(content * D), D = prod f^e over the irreducible factors, all
// polynomials in u = v - 1 (evaluator.hpp). Rounding follows Ziv: a ball that does not decide a digit is computed again
// with more bits; a ball around zero is settled by an exact zero test, and so is a ball around a tie.
#include "twoscale/lowering/lower.hpp"

#include <algorithm>
#include <cmath>

#include "algebraic.hpp"
#include "evaluator.hpp"
#include "fixed_point.hpp"
#include "rounding.hpp"
#include "twoscale/kernels/number_text.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/interpolatory.hpp"

namespace twoscale::lowering {

namespace {

constexpr unsigned most_levels = 4096;
constexpr long least_digits = 17;
constexpr long most_digits = 10000;
constexpr long most_output = 1L << 31;  // characters
constexpr int most_retries = 8;
constexpr long largest_expanded = 48;    // degree up to which the denominator is evaluated as one polynomial
constexpr long most_fixed_digits = 600;  // beyond, balls are as fast as fixed point: powers of u get fewer bits

// One printed number.
struct Cell {
  std::string text;
  double value = 0;
  bool exact = true;
  long last = 0;  // inexact: the last digit has weight 10^last (decimal) or 2^last (double)
};

struct Entry {
  RationalFunction function;
  std::optional<Cell> constant;
  Polynomial numerator;
  std::optional<Form> form;
  bool over_denominator = true;
};

struct Factor {
  Polynomial polynomial;
  Form form;
  unsigned exponent;
};

class Lowering {
 public:
  Lowering(const Scheme& scheme, const Laurent& mask, const Binding& binding, const LowerOptions& options)
      : scheme_(scheme),
        binding_(binding),
        options_(options),
        zero_(variables_of(scheme, binding)),
        rounder_(std::max(1L, options.digits)) {
    if (options.levels > most_levels)
      bad_input("levels: at most " + std::to_string(most_levels) + " can be tabulated, not",
                std::to_string(options.levels));
    if (options.digits != 0 && (options.digits < least_digits || options.digits > most_digits))
      bad_input("digits must lie between " + std::to_string(least_digits) + " and " + std::to_string(most_digits),
                std::to_string(options.digits));
    read_mask(mask);
  }

  kernels::MaskTable run() {
    kernels::MaskTable t;
    t.scheme = scheme_.id;
    t.arity = scheme_.arity;
    t.shift = scheme_.shift.to_string();
    t.parameters = binding_.description;
    for (const Parameter& p : scheme_.parameters) {
      if (p.scope != Parameter::Scope::level) continue;
      t.level_variables.emplace_back(p.name, meaning(p, scheme_.arity));
      t.recurrence += (t.recurrence.empty() ? "" : "; ") + recurrence(p, scheme_.arity);
    }
    t.digits = static_cast<int>(options_.digits);
    t.normalisation = normalisation();
    fill_limit(t);
    fill_levels(t);
    t.precision_error = error_text();
    t.tail_from = static_cast<int>(options_.levels);
    if (options_.tail) t.tail_bound = tail();
    return t;
  }

 private:
  static std::vector<Variable> variables_of(const Scheme& scheme, const Binding& binding) {
    std::vector<Variable> list;
    for (const Parameter& p : scheme.parameters) {
      Variable v{p.name, nullptr, nullptr};
      if (p.scope == Parameter::Scope::level) {
        const auto at = binding.levels.find(p.name);
        if (at == binding.levels.end()) bad_input("a value is missing for the level variable", p.name);
        v.level = &at->second;
      } else if (p.scope == Parameter::Scope::constant) {
        const auto at = binding.constants.find(p.name);
        if (at == binding.constants.end()) bad_input("a value is missing for the parameter", p.name);
        v.constant = &at->second;
      } else {
        bad_input("a scheme with local parameters has no mask table", scheme.id);
      }
      list.push_back(std::move(v));
    }
    return list;
  }

  const std::vector<Variable>& variables() const { return zero_.variables(); }

  // ---- The mask as distinct entries over one denominator

  void read_mask(const Laurent& mask) {
    lowest_ = mask.lowest();
    const CommonDenominator d = common_denominator(mask.coefficients());
    content_ = d.content;
    for (const auto& [f, e] : d.factors) factors_.push_back({f, Form(f, variables()), e});
    denominator_ = d.expanded();
    for (const RationalFunction& c : mask.coefficients()) {
      const auto same = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.function == c; });
      place_.push_back(static_cast<size_t>(same - entries_.begin()));
      if (same == entries_.end()) add_entry(c, numerator_over(c, d), true);
    }
    std::vector<size_t> last(entries_.size());
    for (size_t s = 0; s < place_.size(); ++s) last[place_[s]] = s;
    last_place_.assign(place_.size(), false);
    for (size_t i = 0; i < entries_.size(); ++i)
      if (entries_[i].form) last_place_[last[i]] = true;
    if (options_.extension) {
      if (!scheme_.space) bad_input("the scheme has no function space that could extend an open polygon", scheme_.id);
      for (const Polynomial& w : extension_weights(*scheme_.space, scheme_.arity)) {
        extension_.push_back(entries_.size());
        add_entry(RationalFunction(w), w, false);
      }
    }
    degrees_.assign(variables().size(), 0);
    const auto widen = [&](const Form& f) {
      for (size_t i = 0; i < degrees_.size(); ++i) degrees_[i] = std::max(degrees_[i], f.degree(i));
      valuation_ = std::max(valuation_, f.valuation());
    };
    for (const Entry& e : entries_)
      if (e.form) widen(*e.form);
    for (const Factor& f : factors_) widen(f.form);
    if (denominator_.total_degree() <= largest_expanded) {
      whole_ = Form(denominator_, variables());
      widen(*whole_);
    }
    several_ = std::count_if(degrees_.begin(), degrees_.end(), [](long degree) { return degree > 0; }) > 1;
    const size_t numbers = (place_.size() + extension_.size()) * (options_.levels + 1);
    if (static_cast<double>(numbers) * static_cast<double>(options_.digits + 32) > static_cast<double>(most_output))
      bad_input("the table would be too large", std::to_string(numbers) + " numbers");
  }

  void add_entry(const RationalFunction& c, Polynomial numerator, bool over_denominator) {
    Entry e;
    e.function = c;
    e.over_denominator = over_denominator;
    if (const auto constant = c.constant()) {
      e.constant = cell(*constant);
    } else {
      e.form = Form(numerator, variables());
      e.numerator = std::move(numerator);
    }
    entries_.push_back(std::move(e));
  }

  std::string normalisation() const {
    const long m = scheme_.arity;
    std::vector<Polynomial> coset(static_cast<size_t>(m));
    Polynomial total;
    for (size_t s = 0; s < place_.size(); ++s) {
      const Entry& e = entries_[place_[s]];
      const Polynomial n = e.form ? e.numerator : over_common(e);
      const long i = lowest_ + static_cast<long>(s);
      coset[static_cast<size_t>(((i % m) + m) % m)] += n;
      total += n;
    }
    std::string text = "coefficients sum to ";
    if (total == denominator_ * Polynomial(m)) {
      text += std::to_string(m);
    } else {
      RationalFunction::Factors factors;
      for (const Factor& f : factors_) factors.emplace_back(f.polynomial, f.exponent);
      text += RationalFunction::over_factors(total, content_, factors).to_string();
    }
    const bool constants =
        std::all_of(coset.begin(), coset.end(), [&](const Polynomial& p) { return p == denominator_; });
    return text + (constants ? "; every coset sums to 1 (constants are reproduced)"
                             : "; not every coset sums to 1 (constants are not reproduced)");
  }

  // Numerator of a constant entry over content * D.
  Polynomial over_common(const Entry& e) const {
    const Rational c = *e.function.constant();
    return Polynomial::exact_quotient(denominator_ * Polynomial::constant(c.numerator()),
                                      Polynomial::constant(c.denominator()));
  }

  // ---- Cells

  Cell cell(const Rational& x) const {
    Cell c;
    c.value = rounded_double(x);
    if (options_.digits == 0) {
      c.text = kernels::shortest(c.value);
      c.exact = is_double(x);
      c.last = c.exact ? 0 : ulp_exponent(c.value);
      return c;
    }
    Decimal d = rounded(x, options_.digits);
    c.text = std::move(d.text);
    c.exact = d.exact;
    c.last = d.last;
    return c;
  }

  static long ulp_exponent(double x) {
    int e = 0;
    std::frexp(x, &e);
    return std::max(e - 53, -1074);
  }

  bool cell(const Ball& x, Cell& c) { return rounded_double_of(x, c.value) && cell_of_double(x, c); }
  bool cell(const Fixed& x, Cell& c) { return rounded_double(x, c.value) && cell_of_double(x, c); }

  // The rest of a cell that holds the double of x already.
  template <class Number>
  bool cell_of_double(const Number& x, Cell& c) {
    c.exact = false;
    if (options_.digits == 0) {
      c.text = kernels::shortest(c.value);
      c.last = ulp_exponent(c.value);
      return true;
    }
    if (!rounder_.round(x, decimal_)) return false;
    std::swap(c.text, decimal_.text);
    c.last = decimal_.last;
    return true;
  }

  bool rounded_double_of(const Ball& x, double& d) {
    if (x.contains_zero()) return false;
    arb_set_round(short_.raw(), x.raw(), 128);
    return rounded_double(short_, d) || rounded_double(x, d);
  }

  long digit_bits() const {
    return options_.digits == 0 ? 53 : static_cast<long>(std::ceil(static_cast<double>(options_.digits) * 3.3219281));
  }
  // The guard covers the growth of errors in a mask of moderate size; what it does not cover is done again.
  long working_bits() const { return digit_bits() + 64; }

  // ---- Evaluation at one level: k is the fine level, nullopt the limit

  // 1/(content D) at the point; false if a factor's ball contains zero (it is then the one returned).
  bool inverse_denominator(const Point& point, long bits, Ball& inverse, const Factor** culprit) {
    if (whole_) {
      point.evaluate(inverse.raw(), *whole_);
      if (!inverse.contains_zero()) {
        arb_inv(inverse.raw(), inverse.raw(), bits);
        return true;
      }
    }
    arb_set_fmpz(inverse.raw(), content_.numerator());
    for (const Factor& f : factors_) {
      point.evaluate(scratch_.raw(), f.form);
      if (scratch_.contains_zero()) {
        *culprit = &f;
        return false;
      }
      for (unsigned e = 0; e < f.exponent; ++e) arb_mul(inverse.raw(), inverse.raw(), scratch_.raw(), bits);
    }
    arb_inv(inverse.raw(), inverse.raw(), bits);
    return true;
  }

  std::vector<const arb_struct*> gather(const std::vector<Ball>& values) const {
    std::vector<const arb_struct*> list;
    for (const Ball& b : values) list.push_back(b.raw());
    return list;
  }

  std::vector<Ball> values_at(std::optional<unsigned> k, long bits) const {
    std::vector<Ball> values;
    for (const Variable& v : variables())
      values.push_back(v.level == nullptr ? v.constant->enclose(bits) : k ? v.level->offset(*k, bits) : Ball());
    return values;
  }

  Zero is_zero(const Polynomial& p, std::optional<unsigned> k) { return k ? zero_.at_level(p, *k) : zero_.at_limit(p); }

  [[noreturn]] void singular(std::optional<unsigned> k) const {
    std::string at;
    for (const auto& [name, text] : binding_.description)
      at += (at.empty() ? "" : ", ") + (name == "v0" ? "v^0" : name) + " = " + text;
    if (binding_.levels.size() == 1 && (binding_.description.size() != 1 || binding_.description[0].first != "v0")) {
      const ExactReal v0 = binding_.levels.begin()->second.exact(0);
      at += (at.empty() ? "v^0 = " : " (v^0 = ") + (v0.rational() ? v0.rational()->to_string() : v0.decimal(17)) +
            (at.empty() ? "" : ")");
    }
    Error error(Error::Kind::bad_input, (k ? "the step at level k = " + std::to_string(*k - 1) + " is singular"
                                           : std::string("the limit mask has a pole")) +
                                            (at.empty() ? "" : " for " + at));
    error.offending = at;
    throw error;
  }

  [[noreturn]] void undecided(const std::string& what, std::optional<unsigned> k) const {
    throw Error(Error::Kind::undecided,
                "cannot decide " + what + (k ? " at level k = " + std::to_string(*k - 1) : " in the limit"));
  }

  // A factor whose ball contains zero: throws if it is zero, returns if it is not (or if that is still open).
  void examine(const Factor& f, std::optional<unsigned> k, int attempt) {
    switch (is_zero(f.polynomial, k)) {
      case Zero::yes: singular(k);
      case Zero::no: return;
      case Zero::unknown:
        if (attempt >= most_retries) undecided("whether " + f.polynomial.pretty() + " vanishes", k);
    }
  }

  // N - content * D * candidate is the polynomial whose vanishing makes the entry equal to the candidate.
  bool equals(const Entry& e, const Rational& candidate, std::optional<unsigned> k) {
    const Polynomial n = Polynomial::constant(candidate.numerator());
    const Polynomial d = Polynomial::constant(candidate.denominator());
    const Polynomial bottom = e.over_denominator ? denominator_ : Polynomial(1);
    return is_zero(e.numerator * d - bottom * n, k) == Zero::yes;
  }

  Cell hard_cell(const Entry& e, std::optional<unsigned> k) {
    long bits = 2 * working_bits() + 128;
    bool zero_known = false;
    for (int attempt = 1;; ++attempt, bits *= 2) {
      const std::vector<Ball> values = values_at(k, bits);
      Point point(degrees_, valuation_, several_);
      point.set(gather(values), bits);
      Ball x, inverse;
      if (e.over_denominator) {
        const Factor* culprit = nullptr;
        if (!inverse_denominator(point, bits, inverse, &culprit)) {
          examine(*culprit, k, attempt);
          continue;
        }
      }
      point.evaluate(x.raw(), *e.form);
      if (e.over_denominator) arb_mul(x.raw(), x.raw(), inverse.raw(), bits);
      if (x.contains_zero()) {
        if (!zero_known) {
          const Zero z = is_zero(e.numerator, k);
          if (z == Zero::yes) return cell(Rational(0));
          zero_known = z == Zero::no;
          if (z == Zero::unknown && attempt >= most_retries) undecided("whether a coefficient is zero", k);
        }
        if (attempt >= 2 * most_retries) undecided("the sign of a coefficient", k);
        continue;
      }
      Cell c;
      if (cell(x, c)) return c;
      // A tie, or a number that only looks like one.
      if (attempt >= 2 && x.is_finite()) {
        const Rational middle = to_rational(arb_midref(x.raw()));
        if (options_.digits > 0) {
          const Rational candidate = exact_decimal(rounded(middle, options_.digits + 1).text);
          if (equals(e, candidate, k)) return cell(candidate);
        }
        arf_t near;
        arf_init(near);
        arf_set_round(near, arb_midref(x.raw()), 54, ARF_RND_NEAR);
        const Rational candidate = to_rational(near);
        arf_clear(near);
        if (equals(e, candidate, k)) return cell(candidate);
      }
      if (attempt >= most_retries) undecided("the last digit of a coefficient", k);
    }
  }

  // All distinct entries at one level, from the point (already set with `bits`).
  void cells_at(const Point& point, long bits, std::optional<unsigned> k, std::vector<Cell>& cells) {
    const Factor* culprit = nullptr;
    const bool regular = inverse_denominator(point, bits, inverse_, &culprit);
    if (!regular) examine(*culprit, k, 0);
    for (size_t i = 0; i < entries_.size(); ++i) {
      const Entry& e = entries_[i];
      if (!e.form) continue;
      if (regular || !e.over_denominator) {
        point.evaluate(scratch_.raw(), *e.form);
        if (e.over_denominator) arb_mul(scratch_.raw(), scratch_.raw(), inverse_.raw(), bits);
        if (cell(scratch_, cells[i])) continue;
      }
      cells[i] = hard_cell(e, k);
    }
  }

  // One level variable and polynomials with coefficients of one limb: the same in fixed point.
  void prepare_fixed() {
    const auto varying = std::count_if(degrees_.begin(), degrees_.end(), [](long degree) { return degree > 0; });
    if (varying != 1 || !whole_ || options_.digits > most_fixed_digits) return;
    const auto at = std::find_if(degrees_.begin(), degrees_.end(), [](long degree) { return degree > 0; });
    const auto variable = static_cast<size_t>(at - degrees_.begin());
    if (variables()[variable].level == nullptr) return;
    FixedTable t{
        variable, FixedPoint(static_cast<size_t>(digit_bits() + 24 + 63) / 64, static_cast<size_t>(*at)), {}, {}};
    auto denominator = FixedForm::of(whole_->shifted().univariate_view());
    if (!denominator) return;
    t.denominator = *std::move(denominator);
    for (const Entry& e : entries_) {
      std::optional<FixedForm> f = e.form ? FixedForm::of(e.form->shifted().univariate_view()) : FixedForm();
      if (!f) return;
      t.numerators.push_back(*std::move(f));
    }
    fixed_ = std::move(t);
  }

  // False if u is too large or too close to a pole; what fixed point leaves undecided goes through balls.
  bool fixed_cells_at(const Ball& u, unsigned k, std::vector<Cell>& cells) {
    FixedPoint& point = fixed_->point;
    if (!point.set(u)) return false;
    point.evaluate(top_, fixed_->denominator);
    if (!point.invert(top_)) return false;
    for (size_t i = 0; i < entries_.size(); ++i) {
      const Entry& e = entries_[i];
      if (!e.form) continue;
      point.evaluate(top_, fixed_->numerators[i]);
      const bool good = !e.over_denominator || point.quotient(quotient_, top_);
      if (!good || !cell(e.over_denominator ? quotient_ : top_, cells[i])) cells[i] = hard_cell(e, k);
    }
    return true;
  }

  // The same where all variables are rational numbers.
  void cells_at(const std::vector<std::pair<std::string, Rational>>& at, std::optional<unsigned> k,
                std::vector<Cell>& cells) {
    Rational bottom = content_;
    for (const Factor& f : factors_) {
      const Rational value = f.polynomial.evaluate(at);
      if (value.is_zero()) singular(k);
      bottom *= value.pow(f.exponent);
    }
    for (size_t i = 0; i < entries_.size(); ++i) {
      const Entry& e = entries_[i];
      if (!e.form) continue;
      const Rational top = e.numerator.evaluate(at);
      cells[i] = cell(e.over_denominator ? top / bottom : top);
    }
  }

  // The variables at level k (limit: nullopt) as rationals, if all that occur are.
  std::optional<std::vector<std::pair<std::string, Rational>>> rational_values(std::optional<unsigned> k) {
    std::vector<std::pair<std::string, Rational>> at;
    for (size_t i = 0; i < variables().size(); ++i) {
      if (degrees_[i] == 0) continue;
      const Variable& v = variables()[i];
      const auto q = v.level != nullptr && !k ? std::optional<Rational>(1) : zero_.rational(i, k.value_or(0));
      if (!q) return std::nullopt;
      at.emplace_back(v.name, *q);
    }
    return at;
  }

  std::vector<Cell> constant_cells() const {
    std::vector<Cell> cells(entries_.size());
    for (size_t i = 0; i < entries_.size(); ++i)
      if (entries_[i].constant) cells[i] = *entries_[i].constant;
    return cells;
  }

  // The row of one level. Texts that the next level makes anew are taken out of their cells at their last place.
  kernels::MaskRow row(std::vector<Cell>& cells) {
    kernels::MaskRow r;
    r.lowest = lowest_;
    r.text.reserve(place_.size());
    r.value.reserve(place_.size());
    for (size_t s = 0; s < place_.size(); ++s) {
      Cell& c = cells[place_[s]];
      if (last_place_[s])
        r.text.push_back(std::move(c.text));
      else
        r.text.push_back(c.text);
      r.value.push_back(c.value);
      if (!c.exact) worst_ = std::max(worst_, c.last);
    }
    for (const size_t i : extension_) {
      r.extension_text.push_back(cells[i].text);
      r.extension.push_back(cells[i].value);
    }
    return r;
  }

  void fill_limit(kernels::MaskTable& t) {
    std::vector<Cell> cells = constant_cells();
    if (const auto at = rational_values(std::nullopt)) {
      cells_at(*at, std::nullopt, cells);
    } else {
      const long bits = working_bits();
      const std::vector<Ball> values = values_at(std::nullopt, bits);
      Point point(degrees_, valuation_, several_);
      point.set(gather(values), bits);
      cells_at(point, bits, std::nullopt, cells);
    }
    t.limit = row(cells);
  }

  // True if no variable that occurs changes from level to level.
  bool level_independent() const {
    for (size_t i = 0; i < variables().size(); ++i)
      if (degrees_[i] > 0 && variables()[i].level != nullptr && !variables()[i].level->is_one()) return false;
    return true;
  }

  void fill_levels(kernels::MaskTable& t) {
    if (level_independent()) {
      t.levels.assign(options_.levels, t.limit);
      return;
    }
    const unsigned count = options_.levels;
    t.levels.reserve(count);
    std::vector<Cell> cells = constant_cells();
    unsigned k = 0;
    for (; k < count; ++k) {
      const auto at = rational_values(k + 1);
      if (!at) break;
      cells_at(*at, k + 1, cells);
      t.levels.push_back(row(cells));
    }
    if (k == count) return;
    const long bits = working_bits();
    std::vector<std::vector<Ball>> offsets(variables().size());
    std::vector<Ball> constants(variables().size());
    for (size_t i = 0; i < variables().size(); ++i) {
      const Variable& v = variables()[i];
      if (v.level != nullptr)
        offsets[i] = v.level->offsets(count, bits);
      else
        constants[i] = v.constant->enclose(bits);
    }
    Point point(degrees_, valuation_, several_);
    std::vector<const arb_struct*> values(variables().size());
    prepare_fixed();
    for (; k < count; ++k) {
      if (fixed_ && fixed_cells_at(offsets[fixed_->variable][k], k + 1, cells)) {
        t.levels.push_back(row(cells));
        continue;
      }
      for (size_t i = 0; i < values.size(); ++i)
        values[i] = variables()[i].level != nullptr ? offsets[i][k].raw() : constants[i].raw();
      point.set(values, bits);
      cells_at(point, bits, k + 1, cells);
      t.levels.push_back(row(cells));
    }
  }

  std::string error_text() const {
    if (worst_ == none) return "0";
    if (options_.digits > 0) return "5e" + std::to_string(worst_ - 1);
    // Half an ulp from the value to the double, half an ulp from there to its shortest text.
    return rounded_up(Rational(2).pow(worst_));
  }

  // ---- The tail
  //
  // With D including its content, a_i(u) - a_i(0) = (N_i(u) D(0) - N_i(0) D(u)) / (D(u) D(0))
  // = sum_j u_j H_{ij}(u) / (D(u) D(0)), exactly: H_{ij} collects the terms in which u_j is the first level variable.
  // For k >= K the offsets lie between u^{[K+1]} and 0, so |u_j| sup |H_{ij}| / inf |D| over that hull bounds all of
  // them at once. While the hull is too wide (a pole may lie in between, which the sequence steps over), levels are
  // taken one by one.
  struct TailForms {
    std::vector<std::vector<std::pair<size_t, Form>>> parts;  // for each entry: (variable, H)
    std::optional<Form> at_zero;                              // D(0), a polynomial in the constants
  };

  TailForms tail_forms() const {
    TailForms t;
    const auto without_levels = [&](Polynomial p) {
      for (const Variable& v : variables())
        if (v.level != nullptr) p = p.substitute(v.name, 0);
      return p;
    };
    const Polynomial d = shifted_by_one(denominator_, variables());
    const Polynomial d0 = without_levels(d);
    t.at_zero = Form::of_shifted(d0, variables());
    for (const size_t i : used_entries()) {
      const Polynomial& n = entries_[i].form->shifted();
      Polynomial rest = n * d0 - without_levels(n) * d;
      std::vector<std::pair<size_t, Form>> parts;
      for (size_t j = 0; j < variables().size(); ++j) {
        const Variable& v = variables()[j];
        if (v.level == nullptr) continue;
        const Polynomial next = rest.substitute(v.name, 0);
        const Polynomial h = rest - next;
        if (!h.is_zero())
          parts.emplace_back(
              j, Form::of_shifted(Polynomial::exact_quotient(h, Polynomial::variable(v.name)), variables()));
        rest = next;
      }
      t.parts.push_back(std::move(parts));
    }
    return t;
  }

  std::vector<size_t> used_entries() const {
    std::vector<size_t> list;
    for (size_t i = 0; i < entries_.size(); ++i)
      if (entries_[i].form && entries_[i].over_denominator) list.push_back(i);
    return list;
  }

  // Upper bound at the offsets of level k, or over the hull of them and 0; infinite if D may vanish.
  void tail_at(const TailForms& t, Point& point, unsigned k, const std::vector<Ball>& exact, bool hull, long bits,
               arf_t bound) {
    std::vector<Ball> values = exact;
    if (hull)
      for (size_t i = 0; i < values.size(); ++i)
        if (variables()[i].level != nullptr) {
          const Ball zero;
          arb_union(values[i].raw(), values[i].raw(), zero.raw(), bits);
        }
    point.set(gather(values), bits);
    Ball inverse;
    const Factor* culprit = nullptr;
    arf_pos_inf(bound);
    if (!inverse_denominator(point, bits, inverse, &culprit)) {
      if (!hull) examine(*culprit, k, 0);
      return;
    }
    Ball worst, h, sum, at_zero;
    point.evaluate(at_zero.raw(), *t.at_zero);
    arb_div(inverse.raw(), inverse.raw(), at_zero.raw(), bits);
    arf_t size;
    arf_init(size);
    arf_zero(bound);
    for (const auto& parts : t.parts) {
      arb_zero(sum.raw());
      for (const auto& [j, form] : parts) {
        point.evaluate(h.raw(), form);
        arb_mul(h.raw(), h.raw(), exact[j].raw(), bits);
        if (hull) arb_abs(h.raw(), h.raw());
        arb_add(sum.raw(), sum.raw(), h.raw(), bits);
      }
      arb_mul(sum.raw(), sum.raw(), inverse.raw(), bits);
      if (!sum.is_finite()) {
        arf_pos_inf(bound);
        break;
      }
      arb_get_abs_ubound_arf(size, sum.raw(), 53);
      if (arf_cmp(size, bound) > 0) arf_swap(size, bound);
    }
    arf_clear(size);
  }

  std::string tail() {
    if (level_independent()) return "0";
    const TailForms t = tail_forms();
    if (std::all_of(t.parts.begin(), t.parts.end(), [](const auto& p) { return p.empty(); })) return "0";
    std::vector<long> degrees = degrees_;
    for (const auto& parts : t.parts)
      for (const auto& [j, form] : parts)
        for (size_t i = 0; i < degrees.size(); ++i) degrees[i] = std::max(degrees[i], form.degree(i));
    for (size_t i = 0; i < degrees.size(); ++i) degrees[i] = std::max(degrees[i], t.at_zero->degree(i));
    Point point(degrees, 1L << 30, true);
    arf_t worst, single, hull, slack;
    arf_init(worst);
    arf_init(single);
    arf_init(hull);
    arf_init(slack);
    std::string text;
    constexpr unsigned patience = 200;
    for (unsigned k = options_.levels + 1;; ++k) {
      long bits = 96;
      const std::vector<Ball> values = values_at(k, bits);
      for (int attempt = 1;; ++attempt, bits *= 2) {
        tail_at(t, point, k, attempt == 1 ? values : values_at(k, bits), false, bits, single);
        if (arf_is_finite(single)) break;
        if (attempt >= most_retries) undecided("a bound for the tail", k);
      }
      tail_at(t, point, k, values, true, 96, hull);
      arf_mul_ui(slack, single, 21, 53, ARF_RND_UP);
      arf_mul_2exp_si(slack, slack, -4);
      const bool tight = arf_is_finite(hull) && (arf_cmp(hull, slack) <= 0 || arf_cmp(hull, worst) <= 0);
      if (tight || (k > options_.levels + patience && arf_is_finite(hull))) {
        if (arf_cmp(hull, worst) > 0) arf_swap(hull, worst);
        text = rounded_up(worst);
        break;
      }
      if (arf_cmp(single, worst) > 0) arf_swap(single, worst);
      if (k > options_.levels + 4 * patience) undecided("a bound for the tail", k);
    }
    arf_clear(worst);
    arf_clear(single);
    arf_clear(hull);
    arf_clear(slack);
    return text;
  }

  static constexpr long none = -(1L << 60);

  const Scheme& scheme_;
  const Binding& binding_;
  LowerOptions options_;
  ZeroTest zero_;
  DecimalRounder rounder_;
  Decimal decimal_;
  Ball scratch_, inverse_, short_;
  struct FixedTable {
    size_t variable;
    FixedPoint point;
    FixedForm denominator;
    std::vector<FixedForm> numerators;  // by entry
  };
  std::optional<FixedTable> fixed_;
  Fixed top_, quotient_;

  long lowest_ = 0;
  Rational content_;
  std::vector<Factor> factors_;
  Polynomial denominator_;        // content * D, expanded
  std::optional<Form> whole_;     // the same, where its degree is small
  std::vector<Entry> entries_;    // distinct coefficients, then extension weights
  std::vector<size_t> place_;     // entry of each mask coefficient
  std::vector<bool> last_place_;  // of an entry that changes with the level
  std::vector<size_t> extension_;
  std::vector<long> degrees_;  // by variable, over all forms
  long valuation_ = 0;
  bool several_ = false;
  long worst_ = none;
};

}  // namespace

kernels::MaskTable lower(const Scheme& scheme, const Binding& binding, const LowerOptions& options) {
  return lower(scheme, symbol(scheme), binding, options);
}

kernels::MaskTable lower(const Scheme& scheme, const Laurent& values, const Binding& binding,
                         const LowerOptions& options) {
  return Lowering(scheme, values, binding, options).run();
}

}  // namespace twoscale::lowering
