// SPDX-License-Identifier: GPL-3.0-or-later
//   text (positivity.hpp)                     here
//   x = lo (1-t) + hi t, or lo + t/(1-t)      x = (lo u + hi t)/(u + t), or lo + t/u, with u = 1 - t
//   Bernstein coefficients, times binomials   coefficients of t^i u^(d-i) ("form"): the same signs, integers
//   the halves of [0, 1]                      (u, t) = (2u' + t', t') and (u', u' + 2t')
#include "twoscale/analysis/positivity.hpp"

#include <algorithm>
#include <cmath>

#include "twoscale/symbolic/error.hpp"

namespace twoscale::analysis {

using Json = nlohmann::ordered_json;

namespace {

constexpr size_t largest_form = size_t{1} << 18;  // what the checker accepts
constexpr unsigned deepest_tree = 256;

Rational midpoint(const Rational& a, const Rational& b) { return (a + b) / Rational(2); }

std::string only_name(const Polynomial& p) {
  if (p.is_zero() || p.variables().size() > 1) bad_input("not a polynomial in one variable", p.to_string());
  return p.variables().empty() ? "x" : p.variables()[0];
}

Rational value_at(const Polynomial& p, const Rational& x) { return p.evaluate({{only_name(p), x}}); }

std::vector<Rational> coefficients(const Polynomial& p) {
  std::vector<Rational> c(static_cast<size_t>(p.variables().empty() ? 0 : p.degree(p.variables()[0])) + 1);
  p.for_each_term([&](const Rational& a, std::span<const unsigned long> e) { c[e.empty() ? 0 : e[0]] = a; });
  return c;
}

void shift(std::vector<Rational>& c, const Rational& a) {  // c(x + a)
  if (a.is_zero()) return;
  const bool one = a == Rational(1);
  for (size_t done = 0; done + 1 < c.size(); ++done)
    for (size_t i = c.size() - 1; i-- > done;) c[i] += one ? c[i + 1] : a * c[i + 1];
}

// Integer coefficients in one variable.
struct Dense {
  fmpz_poly_t v;
  explicit Dense(const Polynomial& p) {
    fmpz_poly_init(v);
    fmpz_poly_set(v, p.univariate_view());
  }
  Dense(const Dense&) = delete;
  Dense& operator=(const Dense&) = delete;
  ~Dense() { fmpz_poly_clear(v); }

  void shift(const fmpz* a) { fmpz_poly_taylor_shift(v, v, a); }  // x -> x + a
  void shift_by_one() {
    const Rational one(1);
    shift(one.numerator());
  }
  void scale(const fmpz* a) {  // x -> a x
    const Rational one(1);
    Rational power(one);
    for (slong i = 0; i < fmpz_poly_length(v); ++i) {
      fmpz_mul(v->coeffs + i, v->coeffs + i, power.numerator());
      fmpz_mul(fmpq_numref(power.raw()), power.numerator(), a);
    }
  }
  void reverse(slong degree) { fmpz_poly_reverse(v, v, degree + 1); }
};

// (1+y)^d p((low + high y)/(1 + y)), or p(low + y/b), up to a positive factor: zeros between low and high become
// positive ones.
Polynomial moved(const Polynomial& p, const Rational& low, const std::optional<Rational>& high) {
  Dense c(p);
  const slong d = fmpz_poly_degree(c.v);
  const Rational b(low.denominator());
  const Rational scale = high ? b * Rational(high->denominator()) : b;
  c.reverse(d);
  c.scale(scale.numerator());  // scale^d p(x/scale)
  c.reverse(d);
  c.shift((low * scale).numerator());
  if (high) {  // x = low + (high-low) y/(1+y)
    c.scale(((*high - low) * scale).numerator());
    c.reverse(d);
    c.shift_by_one();
    c.reverse(d);
  }
  return Polynomial::univariate(only_name(p), c.v);
}

long sign_changes(const Polynomial& p) {
  const fmpz_poly_struct* c = p.univariate_view();
  long count = 0;
  int last = 0;
  for (slong i = 0; i < fmpz_poly_length(c); ++i) {
    const int sign = fmpz_sgn(c->coeffs + i);
    if (sign == 0) continue;
    count += last != 0 && sign != last ? 1 : 0;
    last = sign;
  }
  return count;
}

Polynomial squarefree_part(const Polynomial& p) {
  Polynomial r = 1;
  for (const auto& [q, k] : squarefree_factors(p)) r *= q;
  return r;
}

// Vincent, Collins and Akritas on a squarefree polynomial.
void isolate(const Polynomial& p, const Rational& low, const Rational& high, std::vector<RootInterval>& out) {
  const long changes = sign_changes(moved(p, low, high));
  if (changes == 0) return;
  if (changes == 1) {
    RootInterval root{low, high};
    while (value_at(p, root.low).is_zero() || value_at(p, root.high).is_zero()) {  // an end is another zero
      const Rational middle = midpoint(root.low, root.high);
      if (value_at(p, middle).is_zero()) return out.push_back({middle, middle});
      (sign_changes(moved(p, root.low, middle)) == 1 ? root.high : root.low) = middle;
    }
    return out.push_back(root);
  }
  const Rational middle = midpoint(low, high);
  isolate(p, low, middle, out);
  if (value_at(p, middle).is_zero()) out.push_back({middle, middle});
  isolate(p, middle, high, out);
}

}  // namespace

std::vector<std::pair<Polynomial, unsigned>> squarefree_factors(const Polynomial& p) {
  const std::string x = only_name(p);
  std::vector<std::pair<Polynomial, unsigned>> result;
  if (p.is_constant()) return result;
  // Yun's chain without its refinements: g_k has the zeros of multiplicity > k, with multiplicity reduced by k.
  const auto primitive = [](const Polynomial& q) { return q.scaled(q.content().inverse()); };
  Polynomial g = primitive(p);
  Polynomial next = primitive(Polynomial::gcd(g, g.derivative(x)));
  Polynomial zeros = Polynomial::exact_quotient(g, next);  // those of multiplicity >= k, once each
  for (unsigned k = 1; !zeros.is_constant(); ++k) {
    g = next;
    next = g.is_constant() ? Polynomial(1) : primitive(Polynomial::gcd(g, g.derivative(x)));
    const Polynomial more = g.is_constant() ? Polynomial(1) : Polynomial::exact_quotient(g, next);
    Polynomial here = Polynomial::exact_quotient(zeros, more);
    if (!here.is_constant()) result.emplace_back(here.leading_sign() < 0 ? -here : here, k);
    zeros = more;
  }
  return result;
}

long count_zeros(const Polynomial& p, const Rational& low, const std::optional<Rational>& high, Ends ends) {
  const std::string x = only_name(p);
  if (high && !(low < *high)) bad_input("an interval is empty", low.to_string() + ".." + high->to_string());
  const Polynomial q = moved(p, low, high);
  long count = sign_changes(q);
  if (count > 1) {  // more than one: Descartes' rule gives a bound only
    const Polynomial r = squarefree_part(q.remove(Polynomial::variable(x)).first);
    slong negative = 0, positive = 0;
    _fmpz_poly_num_real_roots_sturm(&negative, &positive, r.univariate_view()->coeffs, r.univariate_view()->length);
    count = positive;
  }
  if (ends == Ends::closed)
    count += (value_at(p, low).is_zero() ? 1 : 0) + (high && value_at(p, *high).is_zero() ? 1 : 0);
  return count;
}

Rational zero_bound(const Polynomial& p) {
  only_name(p);
  Rational bound;
  fmpz_poly_bound_roots(fmpq_numref(bound.raw()), p.univariate_view());
  return bound + Rational(1);
}

long count_real_zeros(const Polynomial& p) { return count_zeros(p, -zero_bound(p), zero_bound(p), Ends::open); }

std::vector<RootInterval> isolate_zeros(const Polynomial& p, const Rational& low, const std::optional<Rational>& high) {
  only_name(p);
  if (high && !(low < *high)) bad_input("an interval is empty", low.to_string() + ".." + high->to_string());
  const Polynomial r = squarefree_part(p);
  std::vector<RootInterval> result;
  if (!r.is_constant()) isolate(r, low, high ? *high : std::max(zero_bound(r), low + Rational(1)), result);
  return result;
}

std::vector<RootInterval> isolate_real_zeros(const Polynomial& p) {
  return isolate_zeros(p, -zero_bound(p), zero_bound(p));
}

RootInterval refine_zero(const Polynomial& p, RootInterval root, const Rational& width) {
  const Polynomial r = squarefree_part(p);
  if (root.low == root.high) return root;
  const int below = value_at(r, root.low).sign();
  while (root.high - root.low > width) {
    const Rational middle = midpoint(root.low, root.high);
    const int sign = value_at(r, middle).sign();
    if (sign == 0) return {middle, middle};
    (sign == below ? root.low : root.high) = middle;
  }
  return root;
}

int sign_between(const Polynomial& p, const Rational& low, const std::optional<Rational>& high) {
  if (count_zeros(p, low, high, Ends::open) > 0) return 0;
  return value_at(p, high ? midpoint(low, *high) : low + Rational(1)).sign();
}

namespace {

// ---- The box, sorted and marked

struct Sides {
  std::vector<Range> range;
  std::vector<bool> zero_low, zero_high;  // faces where nothing strict is claimed

  size_t count() const { return range.size(); }
  bool excluded(const BoxPoint& at) const {
    for (size_t j = 0; j < count(); ++j)
      if ((zero_low[j] && at[j].second == range[j].low) || (zero_high[j] && at[j].second == range[j].high)) return true;
    return false;
  }
};

Sides prepare(const Box& box, const SignOptions& options) {
  Sides s;
  s.range = box;
  if (box.size() > 8) bad_input("a box of more than 8 variables", std::to_string(box.size()));
  std::sort(s.range.begin(), s.range.end(), [](const Range& a, const Range& b) { return a.name < b.name; });
  for (size_t j = 0; j < s.count(); ++j) {
    if (j > 0 && s.range[j - 1].name == s.range[j].name) bad_input("a variable twice in a box", s.range[j].name);
    if (s.range[j].high && !(s.range[j].low < *s.range[j].high)) bad_input("an empty side of a box", s.range[j].name);
  }
  s.zero_low.assign(s.count(), false);
  s.zero_high.assign(s.count(), false);
  if (!options.strict && !options.zeros.empty()) bad_input("faces make sense for > 0 only", options.zeros[0]);
  for (const auto& face : options.zeros) {
    bool found = false;
    for (size_t j = 0; j < s.count(); ++j) {
      if (face == s.range[j].name + "=lo") s.zero_low[j] = found = true;
      if (face == s.range[j].name + "=hi" && s.range[j].high) s.zero_high[j] = found = true;
    }
    if (!found) bad_input("not a face of the box", face);
  }
  return s;
}

// x for (u, t); u = 0 on a half-line is infinity, not allowed.
Rational coordinate(const Range& r, const Rational& u, const Rational& t) {
  return r.high ? (r.low * u + *r.high * t) / (u + t) : r.low + t / u;
}

BoxPoint some_point(const Sides& s) {
  BoxPoint at;
  for (const auto& r : s.range) at.emplace_back(r.name, coordinate(r, 1, 1));
  return at;
}

// ---- Forms

class Form {
 public:
  Form(const Polynomial& p, const Sides& s) {
    size_t size = 1;
    for (const auto& r : s.range) {
      length_.push_back(static_cast<size_t>(std::max(0L, p.degree(r.name))) + 1);
      size *= length_.back();
      if (size > largest_form) throw Error(Error::Kind::undecided, "more than 2^18 Bernstein coefficients");
    }
    items_.resize(size);
    std::vector<size_t> place;  // of the variables of p in the box
    for (const auto& name : p.variables())
      for (size_t j = 0; j < s.count(); ++j)
        if (s.range[j].name == name) place.push_back(j);
    p.for_each_term([&](const Rational& c, std::span<const unsigned long> e) {
      size_t at = 0;
      for (size_t k = 0; k < place.size(); ++k) at += e[k] * stride(place[k]);
      items_[at] = c;
    });
    for (size_t j = 0; j < s.count(); ++j) {
      each_line(j, [&](std::vector<Rational>& c) {
        shift(c, s.range[j].low);
        if (!s.range[j].high) return;
        Rational power = 1;
        for (auto& a : c) {
          a *= power;
          power *= *s.range[j].high - s.range[j].low;
        }
        std::reverse(c.begin(), c.end());
        shift(c, 1);
        std::reverse(c.begin(), c.end());
      });
    }
    reduce();
  }

  size_t size() const { return items_.size(); }
  size_t axes() const { return length_.size(); }
  size_t length(size_t axis) const { return length_[axis]; }
  const Rational& operator[](size_t at) const { return items_[at]; }
  size_t index(size_t at, size_t axis) const { return at / stride(axis) % length_[axis]; }

  Form half(size_t axis, bool high) const {
    Form h = *this;
    h.each_line(axis, [&](std::vector<Rational>& c) {
      if (!high) std::reverse(c.begin(), c.end());
      shift(c, 1);
      Rational power = 1;
      for (auto& a : c) {
        a *= power;
        power *= 2;
      }
      if (!high) std::reverse(c.begin(), c.end());
    });
    h.reduce();
    return h;
  }

  // The variable of degree > 1 along which the coefficients bend most, compared with their size (a guess is enough: it
  // decides how large the tree becomes, not what it proves).
  std::optional<size_t> estimate_axis() const {
    std::optional<size_t> best;
    double most = -1;
    for (size_t axis = 0; axis < axes(); ++axis) {
      const size_t n = length_[axis], step = stride(axis);
      if (n < 3) continue;
      std::vector<double> weight{1};  // 1/binomial(n-1, i)
      for (size_t i = 1; i < n; ++i)
        weight.push_back(weight[i - 1] * static_cast<double>(i) / static_cast<double>(n - i));
      const auto value = [&](size_t at, size_t i) { return estimate(items_[at]) * weight[i]; };
      double bend = 0;
      for (size_t at = 0; at < items_.size(); ++at) {
        const size_t i = index(at, axis);
        if (i == 0 || i + 1 == n) continue;
        bend += std::fabs(value(at - step, i - 1) - 2 * value(at, i) + value(at + step, i + 1));
      }
      if (bend > most || !best) {
        most = bend;
        best = axis;
      }
    }
    return best;
  }

 private:
  size_t stride(size_t axis) const {
    size_t s = 1;
    for (size_t j = axis + 1; j < length_.size(); ++j) s *= length_[j];
    return s;
  }
  template <class F>
  void each_line(size_t axis, const F& f) {
    const size_t step = stride(axis), n = length_[axis];
    if (n == 1) return;
    std::vector<Rational> line(n);
    for (size_t start = 0; start < items_.size(); ++start) {
      if (start / step % n != 0) continue;
      for (size_t i = 0; i < n; ++i) line[i] = std::move(items_[start + i * step]);
      f(line);
      for (size_t i = 0; i < n; ++i) items_[start + i * step] = std::move(line[i]);
    }
  }
  // Divides by the content; what is left are integers.
  void reduce() {
    Rational g = 0;
    for (const auto& a : items_) {
      if (!a.is_zero()) g = gcd(g, a);
    }
    if (g.is_zero()) return;
    const Rational factor = g.inverse();
    if (!(g == Rational(1)))
      for (auto& a : items_) a *= factor;
    size_ = 0;
    for (const auto& a : items_) size_ = std::max(size_, static_cast<long>(fmpz_bits(a.numerator())));
  }
  double estimate(const Rational& a) const {  // a/2^size, whatever its size
    slong exponent = 0;
    const double m = fmpz_get_d_2exp(&exponent, a.numerator());
    return std::ldexp(m, static_cast<int>(exponent - size_));
  }

  std::vector<size_t> length_;
  std::vector<Rational> items_;
  long size_ = 0;
};

// ---- Bisection

class Bisection {
 public:
  Bisection(const Polynomial& p, const Sides& s, const SignOptions& options) : p_(p), s_(s), options_(options) {}

  Positivity run() {
    const Form form(p_, s_);
    std::vector<Cell> cells(s_.count());
    bool affine = true;
    for (size_t j = 0; j < s_.count(); ++j) affine = affine && form.length(j) <= 2;
    result_.verdict = Verdict::proved;
    node(form, cells, 0);
    if (result_.verdict == Verdict::proved)
      result_.proof = affine ? PositivityProof{"vertices", ""} : PositivityProof{"bernstein", tree_};
    return result_;
  }

 private:
  // t/(u + t) from `low` to `high` of [0, 1].
  struct Cell {
    Rational low = 0;
    Rational high = 1;
  };
  using Cells = std::vector<Cell>;

  bool undecided(const std::string& reason) {
    result_.verdict = Verdict::undecided;
    result_.reason = reason;
    return false;
  }
  // The point with these t, if it is a counterexample.
  bool refuted(std::vector<Rational> t) {
    for (unsigned step = 1; step <= 1U << 14; step *= 2) {
      BoxPoint at;
      bool infinite = false;
      for (size_t j = 0; j < s_.count(); ++j) {
        Rational x = t[j];
        if (!s_.range[j].high && x == Rational(1)) {  // infinity: go there
          infinite = true;
          x = Rational(1) - Rational(1, 2).pow(step);
        }
        at.emplace_back(s_.range[j].name, coordinate(s_.range[j], Rational(1) - x, x));
      }
      const Rational value = p_.evaluate(at);
      if (value.sign() < 0 || (value.is_zero() && options_.strict && !s_.excluded(at))) {
        result_.verdict = Verdict::refuted;
        result_.point = std::move(at);
        result_.value = value;
        return true;
      }
      if (!infinite) break;
    }
    return false;
  }

  // False: stop.
  bool node(const Form& form, Cells& cells, unsigned depth) {
    work_ += form.size();
    if (work_ > options_.work) return undecided("the limit on the work was reached");
    bool negative = false;
    for (size_t at = 0; at < form.size(); ++at) {
      if (form[at].sign() >= 0) continue;
      negative = true;
      std::vector<Rational> t;  // a vertex?
      for (size_t j = 0; j < form.axes(); ++j) {
        const size_t i = form.index(at, j);
        if (i != 0 && i + 1 != form.length(j)) break;
        t.push_back(i == 0 ? cells[j].low : cells[j].high);
      }
      if (t.size() == form.axes() && refuted(t)) return false;
    }
    if (!negative) {
      tree_ += '.';
      return !options_.strict || faces(form, cells);
    }
    const auto axis = form.estimate_axis();
    if (!axis) return undecided("negative at infinity only");  // vertices decide where no degree is beyond 1
    if (depth >= std::min(options_.depth, deepest_tree))
      return undecided("the depth limit was reached near " + text(cells) + ": perhaps a zero inside the box");
    tree_ += static_cast<char>('0' + *axis);
    const Cell whole = cells[*axis];
    const Rational middle = midpoint(whole.low, whole.high);
    cells[*axis].high = middle;
    if (!node(form.half(*axis, false), cells, depth + 1)) return false;
    cells[*axis] = {middle, whole.high};
    if (!node(form.half(*axis, true), cells, depth + 1)) return false;
    cells[*axis] = whole;
    return true;
  }

  // All coefficients are >= 0: is there a face in the claim on which all are 0? Then so is p.
  bool faces(const Form& form, const Cells& cells) {
    const size_t n = form.axes(), masks = size_t{1} << (2 * n);
    std::vector<bool> covered(masks);
    for (size_t at = 0; at < form.size(); ++at) {
      if (form[at].is_zero()) continue;
      size_t mask = 0;
      for (size_t j = 0; j < n; ++j) {
        if (form.index(at, j) == 0) mask |= size_t{1} << (2 * j);
        if (form.index(at, j) + 1 == form.length(j)) mask |= size_t{2} << (2 * j);
      }
      covered[mask] = true;
    }
    for (size_t bit = 1; bit < masks; bit *= 2)
      for (size_t mask = 0; mask < masks; ++mask)
        if ((mask & bit) != 0 && covered[mask]) covered[mask ^ bit] = true;
    for (size_t face = 0; face < masks; ++face) {
      if (covered[face]) continue;
      bool claimed = true;
      std::vector<Rational> t;
      for (size_t j = 0; j < n && claimed; ++j) {
        const size_t bits = face >> (2 * j) & 3U;
        if (bits == 3) claimed = false;
        if (bits == 1 && cells[j].low.is_zero() && s_.zero_low[j]) claimed = false;
        if (bits == 2 && cells[j].high == Rational(1) && (s_.zero_high[j] || !s_.range[j].high)) claimed = false;
        t.push_back(bits == 1 ? cells[j].low : bits == 2 ? cells[j].high : midpoint(cells[j].low, cells[j].high));
      }
      if (!claimed) continue;
      if (!refuted(t)) throw std::logic_error("a face without positive coefficients where the polynomial is not 0");
      return false;
    }
    return true;
  }

  std::string text(const Cells& cells) const {
    std::string list;
    for (size_t j = 0; j < s_.count(); ++j)
      list += (list.empty() ? "" : ", ") + s_.range[j].name + " = " +
              coordinate(s_.range[j], Rational(1) - cells[j].low, cells[j].low).to_string();
    return list;
  }

  const Polynomial& p_;
  const Sides& s_;
  const SignOptions& options_;
  Positivity result_;
  std::string tree_;
  size_t work_ = 0;
};

// ---- One variable

Positivity decide_by_sturm(const Polynomial& p, const Sides& s, const SignOptions& options) {
  Positivity result;
  size_t axis = 0;
  while (s.range[axis].name != p.variables()[0]) ++axis;
  const Range& range = s.range[axis];
  const auto refute = [&](const Rational& x) {
    result.verdict = Verdict::refuted;
    result.point = some_point(s);
    (*result.point)[axis].second = x;
    result.value = value_at(p, x);
    return result;
  };
  const Rational end = range.high ? *range.high : std::max(zero_bound(p), range.low + Rational(1));
  const bool none = count_zeros(p, range.low, range.high, Ends::open) == 0;
  const std::vector<RootInterval> zeros = none ? std::vector<RootInterval>{} : isolate_zeros(p, range.low, end);
  Rational before = range.low;
  for (size_t i = 0; i <= zeros.size(); ++i) {  // between two zeros
    const Rational x = midpoint(before, i < zeros.size() ? zeros[i].low : end);
    if (value_at(p, x).sign() < 0) return refute(x);
    if (i < zeros.size()) before = zeros[i].high;
  }
  if (options.strict) {
    if (value_at(p, range.low).is_zero() && !s.zero_low[axis]) return refute(range.low);
    if (range.high && value_at(p, *range.high).is_zero() && !s.zero_high[axis]) return refute(*range.high);
    for (const auto& z : zeros)
      if (z.low == z.high) return refute(z.low);
    if (!zeros.empty()) {
      for (const auto& [q, k] : p.factor().factors) {  // a rational zero that bisection does not meet
        if (q.degree(range.name) != 1) continue;
        const std::vector<Rational> c = coefficients(q);
        const Rational zero = -c[0] / c[1];
        if (range.low < zero && zero < end) return refute(zero);
      }
      result.verdict = Verdict::refuted;
      result.between = {zeros[0].low, zeros[0].high};
      return result;
    }
  }
  result.verdict = Verdict::proved;
  result.proof = {"sturm", ""};
  return result;
}

Json entry(const Polynomial& p, const Sides& s, const SignOptions& options, const Positivity& r) {
  if (r.verdict == Verdict::undecided) return nullptr;
  Json e;
  e["claim"] = "positivity";
  e["verdict"] = to_string(r.verdict);
  e["polynomial"] = p.to_string();
  e["variables"] = Json::array();
  e["box"] = Json::array();
  for (const auto& range : s.range) {
    e["variables"].push_back(range.name);
    e["box"].push_back(Json::array({range.low.to_string(), range.high ? range.high->to_string() : ""}));
  }
  e["strict"] = options.strict ? "yes" : "no";
  std::vector<std::string> zeros = options.zeros;
  std::sort(zeros.begin(), zeros.end());
  zeros.erase(std::unique(zeros.begin(), zeros.end()), zeros.end());
  e["zeros"] = zeros;
  if (r.verdict == Verdict::proved) {
    e["method"] = r.proof.method;
    e["tree"] = r.proof.tree;
    e["theorem"] = r.proof.method == "sturm" ? "sturm" : "bernstein";
  } else if (r.point) {
    Json at = Json::array();
    for (const auto& [name, x] : *r.point) at.push_back(x.to_string());
    e["witness"] = Json::object({{"at", at}, {"value", r.value.to_string()}});
    e["theorem"] = "definition";
  } else {
    e["witness"] =
        Json::object({{"between", Json::array({r.between->first.to_string(), r.between->second.to_string()})}});
    e["theorem"] = "sturm";
  }
  return e;
}

}  // namespace

Positivity decide_sign(const Polynomial& p, const Box& box, const SignOptions& options) {
  const Sides s = prepare(box, options);
  for (const auto& name : p.variables())
    if (std::none_of(box.begin(), box.end(), [&](const Range& r) { return r.name == name; }))
      bad_input("a variable that is not in the box", name);
  Positivity result;
  try {
    result = p.variables().size() == 1 ? decide_by_sturm(p, s, options) : Bisection(p, s, options).run();
  } catch (const Error& e) {
    if (e.kind != Error::Kind::undecided) throw;
    result.reason = e.what();
  }
  result.evidence = entry(p, s, options, result);
  return result;
}

RationalPositivity decide_sign(const RationalFunction& f, const Box& box, const SignOptions& options) {
  const Sides s = prepare(box, options);
  RationalPositivity result;
  const BoxPoint inside = some_point(s);
  const auto refute = [&](const BoxPoint& at) {  // is this a counterexample?
    const auto value = f.evaluate(at);
    if (!value || value->sign() > 0) return false;
    if (value->is_zero() && (!options.strict || s.excluded(at))) return false;
    result.verdict = Verdict::refuted;
    result.point = at;
    result.value = *value;
    return true;
  };
  SignOptions poles = options;
  poles.strict = true;
  int sign = 1;
  for (const auto& [q, exponent] : f.denominator_factors()) {
    const int here = q.evaluate(inside).sign() < 0 ? -1 : 1;
    if (exponent % 2 == 1) sign *= here;
    const Polynomial part = here < 0 ? -q : q;
    result.parts.emplace_back(part, decide_sign(part, box, poles));
    const Positivity& r = result.parts.back().second;
    if (r.verdict == Verdict::proved) continue;
    if (r.verdict == Verdict::refuted && ((r.point && refute(*r.point)) || refute(inside))) return result;
    result.reason = r.verdict == Verdict::undecided ? r.reason : "a pole in the box, a zero of " + q.to_string();
    return result;
  }
  const Polynomial part = sign < 0 ? -f.numerator() : f.numerator();
  result.parts.emplace_back(part, decide_sign(part, box, options));
  const Positivity& r = result.parts.back().second;
  result.verdict = r.verdict;
  result.reason = r.reason;
  // A negative value on an excluded face, where the denominator may vanish, is not a value of f.
  if (r.verdict == Verdict::refuted && (!r.point || !refute(*r.point))) {
    result.verdict = r.point ? Verdict::undecided : Verdict::refuted;
    if (r.point) result.reason = "the numerator is negative at a pole on an excepted face";
  }
  return result;
}

}  // namespace twoscale::analysis
