// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/symbolic/lifting.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>

#include "twoscale/symbolic/bspline_function.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale {

namespace {

// A 2x2 matrix of Laurent polynomials in y, rows even and odd.
using Matrix = std::array<std::array<Laurent, 2>, 2>;

Matrix polyphase(const Laurent& a, const Laurent& b) {
  return {{{a.subsymbol(2, 0), b.subsymbol(2, 0)}, {a.subsymbol(2, 1), b.subsymbol(2, 1)}}};
}

Laurent interleaved(const Laurent& even, const Laurent& odd) { return even.dilated(2) + odd.dilated(2).shifted(1); }

Laurent negated(const Laurent& a) { return RationalFunction(-1) * a; }

// ---- Euclid with a choice of where the remainder stays

// What a division leaves: the dividend's coefficients at first..last (empty: last < first). The quotient's terms are
// found from the left end up to `first` and from the right end down to `last`.
struct Division {
  bool predict;  // the dividend is a_o (a predict step), else a_e
  long first;
  long last;
};

// Over any field: Coefficient is Rational (search) or RationalFunction (the exact run).
template <class Coefficient>
struct Sparse {
  std::map<long, Coefficient> terms;  // no zeros
  bool is_zero() const { return terms.empty(); }
  long lowest() const { return terms.begin()->first; }
  long highest() const { return terms.rbegin()->first; }
  long length() const { return is_zero() ? 0 : highest() - lowest() + 1; }
  void add(long i, const Coefficient& c) {
    const auto at = terms.find(i);
    if (at == terms.end()) {
      if (!c.is_zero()) terms.emplace(i, c);
    } else {
      at->second = at->second + c;
      if (at->second.is_zero()) terms.erase(at);
    }
  }
};

// dividend -= quotient divisor until nothing is left outside first..last; the quotient.
template <class Coefficient>
Sparse<Coefficient> divide(Sparse<Coefficient>& dividend, const Sparse<Coefficient>& divisor, long first, long last) {
  Sparse<Coefficient> quotient;
  const auto eliminate = [&](long at, long pivot) {
    const Coefficient q = dividend.terms.at(at) / divisor.terms.at(pivot);
    for (const auto& [i, c] : divisor.terms) dividend.add(i + at - pivot, -(q * c));
    quotient.add(at - pivot, q);
  };
  while (!dividend.is_zero() && dividend.lowest() < first) eliminate(dividend.lowest(), divisor.lowest());
  while (!dividend.is_zero() && dividend.highest() > last) eliminate(dividend.highest(), divisor.highest());
  return quotient;
}

template <class Coefficient>
bool is_symmetric(const Sparse<Coefficient>& q) {
  for (const auto& [i, c] : q.terms) {
    const auto mirror = q.terms.find(q.lowest() + q.highest() - i);
    if (mirror == q.terms.end() || !(mirror->second == c)) return false;
  }
  return true;
}

// The divisions that may follow, most promising first: remainders as short as possible, in the middle before the ends.
template <class Coefficient>
std::vector<Division> candidates(const Sparse<Coefficient>& even, const Sparse<Coefficient>& odd) {
  std::vector<Division> list;
  const auto add = [&](bool predict, long window) {
    const auto& dividend = predict ? odd : even;
    if (window == 0) {  // a monomial divides: nothing is left
      list.push_back({predict, dividend.lowest(), dividend.lowest() - 1});
      return;
    }
    std::vector<long> starts;
    for (long s = dividend.lowest(); s + window - 1 <= dividend.highest(); ++s) starts.push_back(s);
    const long twice_middle = dividend.lowest() + dividend.highest() - window + 1;
    std::stable_sort(starts.begin(), starts.end(),
                     [&](long x, long y) { return std::abs(2 * x - twice_middle) < std::abs(2 * y - twice_middle); });
    for (const long s : starts) list.push_back({predict, s, s + window - 1});
  };
  if (!even.is_zero() && odd.length() >= even.length()) add(true, even.length() - 1);
  if (!odd.is_zero() && even.length() >= odd.length()) {
    add(false, odd.length() - 1);
    if (odd.length() == 1 && even.length() > 1) add(false, 1);  // leaves a monomial, so that a_o can vanish next
  }
  return list;
}

class Search {
 public:
  using Pair = std::pair<Sparse<Rational>, Sparse<Rational>>;

  // The divisions of a shortest way from (even, odd) to (monomial, 0); nullopt if there is none within the budget.
  std::optional<std::vector<Division>> run(const Pair& start) {
    for (long depth = 0; depth <= start.first.length() + start.second.length() + 2; ++depth) {
      best_.reset();
      path_.clear();
      descend(start, depth, 0, 0);
      if (best_) return best_->second;
      if (budget_ <= 0) break;
    }
    return std::nullopt;
  }

 private:
  static constexpr long divisions = 60000;

  void descend(const Pair& p, long depth, long asymmetric, long taps) {
    const auto& [even, odd] = p;
    if (odd.is_zero() && even.length() == 1 && depth == 0) {
      const Score score{asymmetric, std::abs(even.lowest()), taps};
      if (!best_ || score < best_->first) best_ = {score, path_};
      return;
    }
    if (depth == 0 || budget_ <= 0) return;
    if (even.is_zero() || odd.is_zero()) return;  // a common factor, or the monomial stands in the wrong place
    for (const Division& d : candidates(even, odd)) {
      if (!path_.empty() && path_.back().predict == d.predict) continue;
      if (--budget_ <= 0) return;
      Pair next = p;
      const auto q = d.predict ? divide(next.second, next.first, d.first, d.last)
                               : divide(next.first, next.second, d.first, d.last);
      path_.push_back(d);
      descend(next, depth - 1, asymmetric + (is_symmetric(q) ? 0 : 1), taps + static_cast<long>(q.terms.size()));
      path_.pop_back();
    }
  }

  using Score = std::tuple<long, long, long>;
  long budget_ = divisions;
  std::vector<Division> path_;
  std::optional<std::pair<Score, std::vector<Division>>> best_;
};

Sparse<RationalFunction> sparse(const Laurent& a) {
  Sparse<RationalFunction> s;
  for (long i = a.lowest(); i <= a.highest(); ++i) s.add(i, a.coefficient(i));
  return s;
}

Laurent dense(const Sparse<RationalFunction>& s) {
  if (s.is_zero()) return {};
  std::vector<RationalFunction> c(static_cast<size_t>(s.length()));
  for (const auto& [i, x] : s.terms) c[static_cast<size_t>(i - s.lowest())] = x;
  return {s.lowest(), std::move(c)};
}

std::vector<std::string> names_of(const Laurent& a, const Laurent& b) {
  std::set<std::string> names;
  for (const Laurent* x : {&a, &b})
    for (const std::string& n : x->variables()) names.insert(n);
  return {names.begin(), names.end()};
}

using At = std::vector<std::pair<std::string, Rational>>;

// A point where no coefficient has a pole: large different fractions first.
At generic_point(const std::vector<std::string>& names, long attempt) {
  At at;
  for (size_t i = 0; i < names.size(); ++i)
    at.emplace_back(names[i],
                    Rational(1013 + 37 * static_cast<long>(i) + 101 * attempt, 701 + 2 * static_cast<long>(i)));
  return at;
}

std::optional<Sparse<Rational>> at_point(const Laurent& a, const At& at) {
  Sparse<Rational> s;
  for (long i = a.lowest(); i <= a.highest(); ++i) {
    const auto value = a.coefficient(i).evaluate(at);
    if (!value) return std::nullopt;
    s.add(i, *value);
  }
  return s;
}

// The greatest common divisor of the two, lowest index 0, monic.
Laurent common_factor(const Laurent& a, const Laurent& b) {
  auto x = sparse(a), y = sparse(b);
  while (!y.is_zero()) {
    if (x.length() >= y.length()) divide(x, y, x.highest() + 1, x.highest());
    std::swap(x, y);
  }
  const Laurent g = dense(x);
  return g.coefficients().back().inverse() * g.shifted(-g.lowest());
}

std::string in_y(const Laurent& g) {
  std::string text;
  for (long i = g.highest(); i >= g.lowest(); --i) {
    const RationalFunction c = g.coefficient(i);
    if (c.is_zero()) continue;
    text += (text.empty() ? "" : " + ") +
            (c.is_one() && i > 0 ? std::string() : "(" + c.to_string() + ")" + (i > 0 ? "*" : ""));
    if (i > 0) text += i == 1 ? "y" : "y^" + std::to_string(i);
  }
  return text;
}

[[noreturn]] void not_coprime(const Laurent& a) {
  const Laurent g = common_factor(a.subsymbol(2, 0), a.subsymbol(2, 1));
  bad_input(
      "no dual filter exists: the even and the odd part of the mask have a common zero in y = z^2 where this vanishes",
      in_y(g));
}

struct Euclid {
  std::vector<LiftingStep> steps;
  RationalFunction norm = 1;
  long delay = 0;
};

Euclid euclid(const Laurent& a) {
  const Laurent even = a.subsymbol(2, 0), odd = a.subsymbol(2, 1);
  if (a.is_zero()) bad_input("the mask is zero");
  std::vector<LiftingStep> first;  // a_e = 0: only a monomial a_o has a dual
  Laurent e = even;
  if (even.is_zero()) {
    if (odd.coefficients().size() != 1) not_coprime(a);
    e = odd;
    first.push_back({false, Laurent::monomial(0)});
  }
  for (long attempt = 0; attempt < 8; ++attempt) {
    const At at = generic_point(names_of(e, odd), attempt);
    const auto x = at_point(e, at), y = at_point(odd, at);
    if (!x || !y || x->length() != static_cast<long>(e.coefficients().size()) ||
        y->length() != static_cast<long>(odd.coefficients().size()))
      continue;
    const auto way = Search().run({*x, *y});
    if (!way) {
      if (common_factor(e, odd).coefficients().size() > 1) not_coprime(a);
      bad_input("the lifting factorisation is too long for the search, coefficients",
                std::to_string(a.coefficients().size()));
    }
    Euclid result{first, 1, 0};
    auto p = sparse(e), q = sparse(odd);
    for (const Division& d : *way) {
      const auto quotient = d.predict ? divide(q, p, d.first, d.last) : divide(p, q, d.first, d.last);
      result.steps.push_back({d.predict, negated(dense(quotient))});
    }
    if (!q.is_zero() || p.length() != 1) continue;  // the point was not generic
    result.norm = p.terms.begin()->second;
    result.delay = p.lowest();
    return result;
  }
  throw std::logic_error("no generic point for the lifting factorisation");
}

// The inverse steps applied to a column: what the analysis makes of it before scaling.
std::array<Laurent, 2> analysed(const std::vector<LiftingStep>& steps, Laurent even, Laurent odd) {
  for (const LiftingStep& s : steps) {
    if (s.predict)
      odd = odd + s.filter * even;
    else
      even = even + s.filter * odd;
  }
  return {even, odd};
}

std::array<Laurent, 2> synthesised(const std::vector<LiftingStep>& steps, Laurent even, Laurent odd) {
  for (size_t i = steps.size(); i-- > 0;) {
    if (steps[i].predict)
      odd = odd - steps[i].filter * even;
    else
      even = even - steps[i].filter * odd;
  }
  return {even, odd};
}

void append(std::vector<LiftingStep>& steps, LiftingStep step) {
  if (step.filter.is_zero()) return;
  if (!steps.empty() && steps.back().predict == step.predict) {
    steps.back().filter = steps.back().filter + step.filter;
    if (steps.back().filter.is_zero()) steps.pop_back();
    return;
  }
  steps.push_back(std::move(step));
}

// ---- Where the steps exist

void collect(std::vector<Polynomial>& list, const Polynomial& f) {
  if (!f.is_constant() && std::find(list.begin(), list.end(), f) == list.end()) list.push_back(f);
}

void sort(std::vector<Polynomial>& list) {
  std::sort(list.begin(), list.end(), [](const auto& x, const auto& y) { return Polynomial::compare(x, y) < 0; });
}

// The numerators of a over a common denominator as one polynomial, lowest index 0, in the parameters and `name`.
Polynomial as_polynomial(const Laurent& a, const std::string& name) {
  const CommonDenominator d = common_denominator(a.coefficients());
  Polynomial p;
  for (size_t i = 0; i < a.coefficients().size(); ++i)
    p += numerator_over(a.coefficients()[i], d) * Polynomial::variable(name).pow(static_cast<unsigned>(i));
  return p;
}

LiftingDomain domain_of(const Laurent& a, const LiftingFactorization& f) {
  LiftingDomain domain;
  const auto denominators = [&](const RationalFunction& c) {
    for (const auto& [factor, e] : c.denominator_factors()) collect(domain.poles, factor);
  };
  for (const LiftingStep& s : f.steps)
    for (const RationalFunction& c : s.filter.coefficients()) denominators(c);
  denominators(f.norm);
  denominators(f.norm.inverse());
  const Laurent even = a.subsymbol(2, 0), odd = a.subsymbol(2, 1);
  if (even.coefficients().size() > 1 && odd.coefficients().size() > 1) {
    // The parameters may have any names but this one.
    const std::string y = "y of the resultant";
    const Polynomial r = Polynomial::resultant(as_polynomial(even, y), as_polynomial(odd, y), y);
    if (!r.is_zero() && !r.is_constant())
      for (const auto& [factor, e] : r.factor().factors) collect(domain.common_zero, factor);
  } else {
    // A monomial part has no zero; where its coefficient vanishes the other part must be a monomial.
    const Laurent& monomial = even.coefficients().size() == 1 ? even : odd;
    const Laurent& other = even.coefficients().size() == 1 ? odd : even;
    if (monomial.coefficients().size() == 1 && other.coefficients().size() > 1) {
      const Polynomial& n = monomial.coefficients()[0].numerator();
      if (!n.is_constant())
        for (const auto& [factor, e] : n.factor().factors) collect(domain.common_zero, factor);
    }
  }
  sort(domain.poles);
  sort(domain.common_zero);
  return domain;
}

Lifting checked(LiftingFactorization f, const Laurent& a, const Laurent& b) {
  Lifting r{std::move(f), filter_bank(a, b), {}};
  const FilterBank again = expand(r.factorization);
  if (!(again.synthesis_low == a) || !(again.synthesis_high == b) || !reconstructs(r.bank))
    throw std::logic_error("the lifting steps do not multiply to the filter bank");
  r.domain = domain_of(a, r.factorization);
  return r;
}

// a + b u: all rows of M x = r by Gaussian elimination; nullopt if M is singular.
std::optional<std::vector<RationalFunction>> solve(std::vector<std::vector<RationalFunction>> m,
                                                   std::vector<RationalFunction> r) {
  const size_t n = r.size();
  for (size_t c = 0; c < n; ++c) {
    size_t pivot = n;
    for (size_t i = c; i < n; ++i)
      if (!m[i][c].is_zero() && (pivot == n || m[i][c].numerator().terms() < m[pivot][c].numerator().terms()))
        pivot = i;
    if (pivot == n) return std::nullopt;
    std::swap(m[c], m[pivot]);
    std::swap(r[c], r[pivot]);
    const RationalFunction inverse = m[c][c].inverse();
    for (size_t i = 0; i < n; ++i) {
      if (i == c || m[i][c].is_zero()) continue;
      const RationalFunction q = m[i][c] * inverse;
      for (size_t j = c; j < n; ++j) m[i][j] -= q * m[c][j];
      r[i] -= q * r[c];
    }
  }
  for (size_t c = 0; c < n; ++c) r[c] = r[c] / m[c][c];
  return r;
}

// a mod e for a monic e with lowest index 0 and e(0) != 0; z is invertible there. Coefficients of z^0..z^{deg e - 1}.
std::vector<RationalFunction> reduced(const Laurent& a, const Laurent& e) {
  auto x = sparse(a);
  divide(x, sparse(e), 0, e.highest() - 1);
  std::vector<RationalFunction> c(static_cast<size_t>(e.highest()));
  for (const auto& [i, value] : x.terms) c[static_cast<size_t>(i)] = value;
  return c;
}

}  // namespace

Laurent reversed(const Laurent& a) {
  if (a.is_zero()) return {};
  std::vector<RationalFunction> c(a.coefficients().rbegin(), a.coefficients().rend());
  return {-a.highest(), std::move(c)};
}

FilterBank filter_bank(const Laurent& a, const Laurent& b) {
  const Matrix p = polyphase(a, b);
  return {a, b, interleaved(reversed(p[1][1]), negated(reversed(p[0][1]))),
          interleaved(negated(reversed(p[1][0])), reversed(p[0][0]))};
}

bool reconstructs(const FilterBank& bank) {
  const Matrix p = polyphase(bank.synthesis_low, bank.synthesis_high);
  // Rows of the analysis matrix: s = L_e(1/y) x_e + L_o(1/y) x_o.
  const Matrix q = {{{reversed(bank.analysis_low.subsymbol(2, 0)), reversed(bank.analysis_low.subsymbol(2, 1))},
                     {reversed(bank.analysis_high.subsymbol(2, 0)), reversed(bank.analysis_high.subsymbol(2, 1))}}};
  for (size_t i = 0; i < 2; ++i)
    for (size_t j = 0; j < 2; ++j)
      if (!(p[i][0] * q[0][j] + p[i][1] * q[1][j] == (i == j ? Laurent::monomial(0) : Laurent()))) return false;
  return true;
}

FilterBank expand(const LiftingFactorization& lifting) {
  const auto low = synthesised(lifting.steps, Laurent::monomial(lifting.delay, lifting.norm), {});
  const auto high = synthesised(lifting.steps, {}, Laurent::monomial(-lifting.delay, lifting.norm.inverse()));
  return filter_bank(interleaved(low[0], low[1]), interleaved(high[0], high[1]));
}

Lifting complete(const Laurent& a, const Space& moments) {
  const Euclid steps = euclid(a);
  LiftingFactorization f{steps.steps, steps.norm, steps.delay};
  const auto last = synthesised(f.steps, {}, Laurent::monomial(-f.delay, f.norm.inverse()));
  Laurent b = interleaved(last[0], last[1]);
  const long n = static_cast<long>(moments.dimension());
  if (n > 0) {
    // b(z) + u(z^2) a(z) = 0 mod prod (z - z_i), u with the taps first..first+n-1.
    const Laurent e = knot_polynomial(moments, 1);
    const long sign = moments.polynomial_order() % 2 == 1 ? -1 : 1;  // monic
    const Laurent monic = RationalFunction(sign) * e;
    // Centres of symmetry (of the supports otherwise): 2 c(u) + c(a) = c(b).
    const Rational centre =
        (Rational(b.lowest() + b.highest(), 2) - Rational(a.lowest() + a.highest(), 2)) / Rational(2);
    const Rational start = centre - Rational(n - 1, 2);
    Rational up;
    fmpz_cdiv_q(fmpq_numref(up.raw()), start.numerator(), start.denominator());
    const long first = up.to_long();
    std::vector<std::vector<RationalFunction>> m(static_cast<size_t>(n),
                                                 std::vector<RationalFunction>(static_cast<size_t>(n)));
    for (long j = 0; j < n; ++j) {
      const auto column = reduced(a.shifted(2 * (first + j)), monic);
      for (size_t i = 0; i < column.size(); ++i) m[i][static_cast<size_t>(j)] = column[i];
    }
    std::vector<RationalFunction> rhs = reduced(b, monic);
    for (auto& c : rhs) c = -c;
    const auto u = solve(std::move(m), std::move(rhs));
    if (!u) bad_input("no update gives the dual these moments", moments.to_string());
    const Laurent update(first, *u);
    b = b + update.dilated(2) * a;
    // In the steps the update comes before the scaling: x_e -= u K^2 y^{2 delay} x_o.
    append(f.steps, {false, negated(f.norm * f.norm * update.shifted(2 * f.delay))});
    if (!Laurent::quotient(b, monic)) throw std::logic_error("the wavelet misses its moments");
  }
  return checked(std::move(f), a, b);
}

Lifting factor_pair(const Laurent& a, const Laurent& dual) {
  // sum_i a_i dual_{i-2j}, j = ..: coefficients of the even part of a(z) dual(1/z).
  const Laurent product = (a * reversed(dual)).subsymbol(2, 0);
  if (product.is_zero()) bad_input("the masks are no biorthogonal pair: sum_i a_i dual_{i-2j} is 0 for every j");
  long at = std::clamp(0L, product.lowest(), product.highest());
  for (long j = product.lowest(); j <= product.highest(); ++j)
    if (product.coefficient(j) == RationalFunction(2)) at = j;
  for (long j = product.lowest(); j <= product.highest(); ++j)
    if (!(product.coefficient(j) == RationalFunction(j == at ? 2 : 0)))
      bad_input(
          "the masks are no biorthogonal pair: sum_i a_i dual_{i-2j} must be 2 for one j and 0 for the others, but for "
          "j = " +
              std::to_string(j) + " it is",
          product.coefficient(j).to_string());
  // b(z) = z L(-1/z), L = dual/2 translated so that j = 0.
  const Laurent low = RationalFunction(Rational(1, 2)) * dual.shifted(2 * at);
  const Laurent turned = reversed(low);
  std::vector<RationalFunction> c = turned.coefficients();
  for (size_t i = 0; i < c.size(); ++i)
    if ((turned.lowest() + static_cast<long>(i)) % 2 != 0) c[i] = -c[i];
  const Laurent b = Laurent(turned.lowest(), std::move(c)).shifted(1);

  const Euclid steps = euclid(a);
  LiftingFactorization f{steps.steps, steps.norm, steps.delay};
  const auto rest = analysed(f.steps, b.subsymbol(2, 0), b.subsymbol(2, 1));
  // rest = (q K^{-1} y^{-delay}, K^{-1} y^{-delay}): the last update.
  append(f.steps, {false, negated(f.norm * rest[0].shifted(f.delay))});
  return checked(std::move(f), a, b);
}

unsigned vanishing_moments(const Laurent& a) {
  unsigned n = 0;
  Laurent rest = a;
  while (!rest.is_zero()) {
    auto q = Laurent::quotient(rest, Laurent(0, {-1, 1}));
    if (!q) break;
    rest = *std::move(q);
    ++n;
  }
  return n;
}

OrthonormalLayout orthonormal_layout(const FilterBank& bank) {
  const Laurent l = reversed(bank.analysis_low), h = reversed(bank.analysis_high);
  // z^c L(1/z), z^{n-1-c} a(z), z^d H(1/z), z^{n-1-d} b(z), all within the indices 0..n-1; c - d even, so that aliases
  // cancel.
  for (long n = 2;; n += 4) {
    const auto range = [&](const Laurent& dec, const Laurent& rec) {
      // dec.lowest + c >= 0, dec.highest + c <= n-1, rec.lowest + n-1-c >= 0, rec.highest + n-1-c <= n-1.
      return std::pair<long, long>{std::max(-dec.lowest(), rec.highest()),
                                   std::min(n - 1 - dec.highest(), n - 1 + rec.lowest())};
    };
    const auto [c0, c1] = range(l, bank.synthesis_low);
    const auto [d0, d1] = range(h, bank.synthesis_high);
    // Odd c and d: PyWavelets keeps the samples of odd index (with mode periodization those of the parity of n/2, hence
    // n = 2 mod 4), and these are then s and d themselves.
    const auto middle = [](long least, long greatest) -> std::optional<long> {
      std::optional<long> best;
      for (long c = least; c <= greatest; ++c)
        if (c % 2 != 0 && (!best || std::abs(2 * c - least - greatest) < std::abs(2 * *best - least - greatest)))
          best = c;
      return best;
    };
    const auto c = middle(c0, c1), d = middle(d0, d1);
    if (!c || !d) continue;
    return {n, l.shifted(*c), h.shifted(*d), bank.synthesis_low.shifted(n - 1 - *c),
            bank.synthesis_high.shifted(n - 1 - *d)};
  }
}

}  // namespace twoscale
