// SPDX-License-Identifier: 0BSD
// Interpolatory refinement of polygons on arbitrary knots, with edge parameters (Beccari, Casciola and Romani, "NULI").
//
// Points p_j belong to knots x_j, d_j = x_{j+1} - x_j >= 0. A step keeps the points and puts one into the middle of
// every knot interval; both halves of an interval have d_j/2. Edge parameters lambda_j in [0, 1] are inherited by the
// child edge at a tagged vertex, all others become 1/2; new vertices are not tagged.
//
// Everything is computed from divided differences, so that nothing grows like 1/d and cancels:
//   V_j = (p_{j+1} - p_j)/d_j,   D_j = (V_j - V_{j-1})/(d_{j-1} + d_j),   T_j = (D_{j+1} - D_j)/(d_{j-1} + d_j +
//   d_{j+1}), quadratics   (p_j + p_{j+1})/2 - d_j^2/4 (w D_j + (1 - w) D_{j+1}) cubics       C_j = that with w =
//   (d_j/2 + d_{j+1})/(d_{j-1} + d_j + d_{j+1}), the cubic at j-1..j+2 lagrange4    C_j (Daubechies, Guskov and
//   Sweldens 1999) nuli4        quadratics, w = lambda/(2(1 - lambda)) for lambda <= 1/2, 1 - (1 - lambda)/(2 lambda)
//   above nuli6        C_j + d_j^2/4 (W_R (T_{j+1} - T_j) - W_L (T_{j-1} - T_j)),
//                W_L = W(d_{j-1}, d_j, 1 - lambda_{j-1}, lambda_j), W_R = W(d_{j+1}, d_j, lambda_{j+1}, 1 - lambda_j),
//                W(a, b, k, m) = a (a k + b) phi(m)/(6 (k m (a + b) + k a + m b)),
//                phi(m) = m^2/(1 - m) for m <= 1/2, (7 m^2 - 5 m + 1)/m above; W = 0 for m = 0
// (these are the rules of the paper, simplified; proved equal in tests/symbolic/nulifs_test.cpp). No weight has a pole
// for lambda in [0, 1].
//
// Where the intervals that a rule reads are equal and the edge parameters 1/2 -- everywhere but beside the vertices of
// the data, after a few steps -- it is that of the uniform knots, and needs no quotient. With a = p_j + p_{j+1},
// b = p_{j-1} + p_{j+2}, c = p_{j-2} + p_{j+3} the new point is a/2 + (a - b)/16 for the rules of 4 points and
// a/2 + (20 (a - b) - (b - c))/288 for nuli6.
//
// Intervals of length 0 are allowed between coinciding points: V_j = 0, the limit of the centripetal parametrisation,
// and a divided difference over an interval of length 0 is 0. D_j over three
// coinciding points depends on how they part, but its weight tends to 0: the rule is the limit all the same.
//
// Ends of open polygons
//   given    2 (nuli4, lagrange4) or 4 (nuli6) points of the input lie beyond each end; the curve runs between the
//   others. linear   p_{-h} = 2 p_0 - p_h with mirrored knots and edge parameters, at every level: keeps straight lines
//   only, the
//            second derivative is 0 at the end.
//   space    beside an end the polynomial through its first 3 (nuli4) or 4 points: keeps what the scheme keeps
//            inside, polynomials of degree 2 or 3.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "twoscale/kernels/error.hpp"
#include "twoscale/kernels/points_io.hpp"
#include "twoscale/kernels/refine.hpp"

namespace twoscale::kernels {

enum class KnotRule { lagrange4, nuli4, nuli6 };

/// "lagrange4", "nuli4", "nuli6"; anything else throws Error (bad_input), or is nothing.
KnotRule parse_knot_rule(std::string_view text);
std::optional<KnotRule> find_knot_rule(std::string_view text);
/// Points on each side of the edge that the rule reads: 2 or 3.
constexpr long half_width(KnotRule rule) { return rule == KnotRule::nuli6 ? 3 : 2; }
/// The degree of the polynomials that the rule reproduces on arbitrary knots.
constexpr int precision(KnotRule rule) { return rule == KnotRule::nuli4 ? 2 : 3; }

enum class Parametrization { uniform, chordal, centripetal, given };

/// "uniform", "chordal", "centripetal", "given"; anything else throws Error (bad_input).
Parametrization parse_parametrization(std::string_view text);

/// A polygon with knots. Entry j of d and lambda belongs to the edge from point j to the next one; a closed polygon has
/// as many edges as points, an open one has one less (and vectors that are one shorter).
template <class T>
struct KnotPolygon {
  std::size_t dim = 0;
  bool closed = true;
  std::vector<T> points;  ///< row-major
  std::vector<T> d;
  std::vector<T> lambda;
  std::vector<unsigned char> tagged;  ///< one for each point

  std::size_t size() const { return dim == 0 ? 0 : points.size() / dim; }
  std::size_t edges() const { return closed || size() == 0 ? size() : size() - 1; }
};

/// Knot intervals |p_{j+1} - p_j|^e in the Euclidean norm, e = 0, 1, 1/2; the closing edge of a closed polygon too.
/// `Parametrization::given` throws. Uniform intervals are 1, also between coinciding points.
std::vector<double> knot_intervals(std::span<const double> points, std::size_t dim, bool closed, Parametrization kind);

/// Both ends of every edge with lambda != 1/2.
template <class T>
std::vector<unsigned char> default_tags(const KnotPolygon<T>& p) {
  std::vector<unsigned char> tags(p.size(), 0);
  for (std::size_t e = 0; e < p.edges(); ++e)
    if (!(p.lambda[e] + p.lambda[e] == T(1))) tags[e] = tags[(e + 1) % p.size()] = 1;
  return tags;
}

/// Throws Error (bad_input) naming the row (from 1) unless sizes fit, intervals are >= 0, edge parameters in [0, 1],
/// and points at the ends of an interval of length 0 coincide; or naming how many points are needed.
template <class T>
void validate(const KnotPolygon<T>& p, KnotRule rule, Boundary boundary);

namespace detail {

[[noreturn]] void fail_knots(const std::string& message);
std::string number(double value);

template <class T>
T quotient_or_zero(const T& a, const T& b) {
  return b == T(0) ? T(0) : a / b;
}

// Types that enclose numbers, and compare only what they can tell apart, have a surely_equal of their own.
template <class T>
bool surely_equal(const T& a, const T& b) {
  return a == b;
}

template <class T>
T quadratic_weight(const T& lambda) {
  const T one(1);
  if (lambda + lambda <= one) return lambda / (T(2) * (one - lambda));
  return one - (one - lambda) / (T(2) * lambda);
}

// W(a, b, k, m) of the header comment.
template <class T>
T cubic_weight(const T& a, const T& b, const T& k, const T& m) {
  const T one(1);
  if (m == T(0) || a == T(0) || b == T(0)) return T(0);  // b = 0: the new point lies on both ends, whatever W
  const T phi = m + m <= one ? m * m / (one - m) : (T(7) * m * m - T(5) * m + one) / m;
  return a * (a * k + b) * phi / (T(6) * (k * m * (a + b) + k * a + m * b));
}

}  // namespace detail

namespace detail {

// Room for a strip; number i of an array belongs to edge or point first + i.
template <class T>
struct KnotScratch {
  std::vector<T> d, lambda, x, first, second, third;
};

// The formulas for a strip of edges, over arrays that stay in the first cache. Two strips never depend on each other,
// and every quotient is formed once in each.
template <class T>
class KnotStrip {
 public:
  static constexpr long edges_at_once = 256;

  KnotStrip(const KnotPolygon<T>& p, KnotRule rule, Boundary boundary, KnotScratch<T>& scratch)
      : p_(p),
        scratch_(scratch),
        rule_(rule),
        n_(static_cast<long>(p.size())),
        edges_(static_cast<long>(p.edges())),
        dim_(static_cast<long>(p.dim)),
        given_(!p.closed && boundary == Boundary::given),
        half_(T(1) / T(2)),
        twenty_(T(20)),
        uniform_(T(1) / T(rule == KnotRule::nuli6 ? 288 : 16)) {
    const std::size_t room = static_cast<std::size_t>(edges_at_once + 2 * reach + 2);
    scratch.d.resize(room, T(0));
    scratch.lambda.resize(room, half_);
    for (auto* rows : {&scratch.x, &scratch.first, &scratch.second, &scratch.third}) rows->resize(room * p.dim, T(0));
    if (!p.closed && !given_) extend_ends(boundary);
  }

  // New points of the edges from..to-1 (at most edges_at_once), and the old ones before them, into `out` from its row
  // `row` on.
  void run(long from, long to, KnotPolygon<T>& out, std::size_t row) {
    switch (dim_) {
      case 1: return run(std::integral_constant<long, 1>(), from, to, out, row);
      case 2: return run(std::integral_constant<long, 2>(), from, to, out, row);
      case 3: return run(std::integral_constant<long, 3>(), from, to, out, row);
      default: return run(dim_, from, to, out, row);
    }
  }

 private:
  static constexpr long reach = 3;  // edges before and after a strip

  // Knot interval and edge parameter of any edge: beyond the ends those of the other end, or mirrored ones.
  std::pair<T, T> edge(long e) const {
    if (p_.closed || (e >= 0 && e < edges_)) {
      const auto from = static_cast<std::size_t>(p_.closed ? e - n_ * floor_div(e, n_) : e);
      return {p_.d[from], p_.lambda[from]};
    }
    // A polygon with less than three edges has no more to mirror.
    const long mirrored = e < 0 ? -1 - e : 2 * edges_ - 1 - e;
    const auto from = static_cast<std::size_t>(std::min(std::max(mirrored, 0L), edges_ - 1));
    return {p_.d[from], T(1) - p_.lambda[from]};
  }

  const T* point(long j) const {
    return &p_.points[static_cast<std::size_t>((p_.closed ? j - n_ * floor_div(j, n_) : j) * dim_)];
  }

  // D_j of an inner point.
  std::vector<T> inner_second(long j) const {
    const T before = edge(j - 1).first, after = edge(j).first;
    std::vector<T> out;
    for (long c = 0; c < dim_; ++c) {
      const T v0 = quotient_or_zero<T>(point(j)[c] - point(j - 1)[c], before);
      const T v1 = quotient_or_zero<T>(point(j + 1)[c] - point(j)[c], after);
      out.push_back(quotient_or_zero<T>(v1 - v0, before + after));
    }
    return out;
  }

  // D_j for j = -2..0 and edges..edges+2.
  void extend_ends(Boundary boundary) {
    const auto span = [&](long j) { return edge(j - 1).first + edge(j).first + edge(j + 1).first; };
    const auto inner = [&](long j) {
      return j >= 1 && j < edges_ ? inner_second(j) : std::vector<T>(static_cast<std::size_t>(dim_), T(0));
    };
    left_.assign(3, std::vector<T>(static_cast<std::size_t>(dim_), T(0)));
    right_ = left_;
    if (boundary == Boundary::linear) {
      for (long h = 1; h <= 2; ++h) {
        const std::vector<T> l = inner(h), r = inner(edges_ - h);
        for (std::size_t c = 0; c < l.size(); ++c) {
          left_[static_cast<std::size_t>(h)][c] = h >= edges_ ? T(0) : T(0) - l[c];
          right_[static_cast<std::size_t>(h)][c] = h >= edges_ ? T(0) : T(0) - r[c];
        }
      }
      return;
    }
    // The polynomial of the first points goes on: D constant, or T constant.
    const bool cubic = precision(rule_) == 3;
    const std::vector<T> l1 = inner(1), l2 = inner(2), r1 = inner(edges_ - 1), r2 = inner(edges_ - 2);
    for (std::size_t c = 0; c < l1.size(); ++c) {
      const T left = cubic ? quotient_or_zero<T>(l2[c] - l1[c], span(1)) : T(0);
      const T right = cubic ? quotient_or_zero<T>(r1[c] - r2[c], span(edges_ - 2)) : T(0);
      T value = l1[c];
      for (long h = 0; h <= 2; ++h) {
        value = value - (h <= 1 ? left * span(-h) : T(0));
        left_[static_cast<std::size_t>(h)][c] = value;
      }
      value = r1[c];
      for (long h = 0; h <= 2; ++h) {
        value = value + (h <= 1 ? right * span(edges_ + h - 1) : T(0));
        right_[static_cast<std::size_t>(h)][c] = value;
      }
    }
  }

  // Edges first.. of the polygon and their points; those numbered low..high-1 are edges of the polygon itself. The new
  // point of number `begin` comes into row row + 1.
  struct Strip {
    long first = 0, begin = 0;
    const T *d = nullptr, *lambda = nullptr, *x = nullptr;
    long low = 0, high = 0;
    KnotPolygon<T>* out = nullptr;
    std::size_t row = 0;

    std::size_t row_of(long i) const { return row + 2 * static_cast<std::size_t>(i - begin); }
  };

  template <class Dim>
  void run(Dim dim, long from, long to, KnotPolygon<T>& out, std::size_t row) {
    long a = from - reach, b = to + reach;  // edges a..b-1
    if (given_) {
      a = std::max(a, 0L);
      b = std::min(b, edges_);
    }
    const bool inside = given_ || (a >= 0 && b < (p_.closed ? n_ : edges_));
    if (!inside) {
      for (long e = a; e < b; ++e) {
        const auto [interval, parameter] = edge(e);
        scratch_.d[static_cast<std::size_t>(e - a)] = interval;
        scratch_.lambda[static_cast<std::size_t>(e - a)] = parameter;
      }
      for (long j = a; j <= b; ++j)
        if (p_.closed || (j >= 0 && j < n_))
          std::copy_n(point(j), dim_, &scratch_.x[static_cast<std::size_t>((j - a) * dim)]);
    }
    Strip s;
    s.first = a;
    s.begin = from - a;
    s.d = inside ? &p_.d[static_cast<std::size_t>(a)] : scratch_.d.data();
    s.lambda = inside ? &p_.lambda[static_cast<std::size_t>(a)] : scratch_.lambda.data();
    s.x = inside ? &p_.points[static_cast<std::size_t>(a * dim)] : scratch_.x.data();
    s.low = p_.closed ? 0 : std::max(-a, 0L);
    s.high = (p_.closed ? b : std::min(b, edges_)) - a;
    s.out = &out;
    s.row = row;
    // Stretches of equal edges at rest; all that the rules of their inner edges read is the same.
    const long inner = half_width(rule_) - 1;
    const long end = to - a;
    long done = s.begin;
    for (long i = s.low; i < s.high && done < end;) {
      const long stretch = i;
      i = end_of_stretch(s, stretch);
      const long low = std::max(done, stretch + inner), high = std::min(end, i - inner);
      if (low >= high) continue;
      if (done < low) any_edges(dim, s, done, low);
      equal_edges(dim, s, low, high);
      done = high;
    }
    if (done < end) any_edges(dim, s, done, end);
  }

  // Past the edges from `stretch` on that are equal and at rest; it is one of them, if there are any.
  long end_of_stretch(const Strip& s, long stretch) const {
    const bool any_lambda = rule_ == KnotRule::lagrange4;
    const T& d = s.d[stretch];
    if (!any_lambda && !surely_equal(s.lambda[stretch], half_)) return stretch + 1;
    long i = stretch + 1;
    if constexpr (is_rounded<T>) {  // many at once
      constexpr long block = 8;
      const T* const lambda = any_lambda ? s.d : s.lambda;
      const T& rest = any_lambda ? d : half_;
      for (; i + block <= s.high; i += block) {
        long others = 0;
        for (long k = 0; k < block; ++k) others += (s.d[i + k] == d ? 0 : 1) + (lambda[i + k] == rest ? 0 : 1);
        if (others != 0) break;
      }
    }
    while (i < s.high && surely_equal(s.d[i], d) && (any_lambda || surely_equal(s.lambda[i], half_))) ++i;
    return i;
  }

  // New points of the edges numbered from..to-1, whose rule is that of equal intervals and lambda = 1/2.
  template <class Dim>
  void equal_edges(Dim dim, const Strip& s, long from, long to) {
    const std::size_t row = s.row_of(from);
    const long numbers = (to - from) * dim;
    const T* const old = s.x + from * dim;
    T* const made = scratch_.third.data();
    if (rule_ == KnotRule::nuli6) {
      for (long i = 0; i < numbers; ++i) {
        const T a = old[i] + old[i + dim];
        const T b = old[i - dim] + old[i + 2 * dim];
        const T c = old[i - 2 * dim] + old[i + 3 * dim];
        made[i] = a * half_ + (twenty_ * (a - b) - (b - c)) * uniform_;
      }
    } else {
      for (long i = 0; i < numbers; ++i) {
        const T a = old[i] + old[i + dim];
        const T b = old[i - dim] + old[i + 2 * dim];
        made[i] = a * half_ + (a - b) * uniform_;
      }
    }
    T* fine = &s.out->points[row * p_.dim];
    for (long i = 0; i < numbers; i += dim, fine += 2 * dim)
      for (long c = 0; c < dim; ++c) {
        fine[c] = old[i + c];
        fine[dim + c] = made[i + c];
      }
    if (rule_ == KnotRule::lagrange4) return inherit(s, from, to);
    const auto edges = static_cast<std::size_t>(to - from);
    std::fill_n(&s.out->d[row], 2 * edges, T(s.d[from] * half_));
    std::fill_n(&s.out->lambda[row], 2 * edges, half_);
    unsigned char* const tags = &s.out->tagged[row];
    const unsigned char* const tag = &p_.tagged[static_cast<std::size_t>(s.first + from)];
    for (std::size_t i = 0; i < edges; ++i) {
      tags[2 * i] = tag[i];
      tags[2 * i + 1] = 0;
    }
  }

  // Knot intervals, edge parameters and tags after the step.
  void inherit(const Strip& s, long from, long to) const {
    std::size_t row = s.row_of(from);
    for (long j = s.first + from; j < s.first + to; ++j, row += 2) {
      const auto at = static_cast<std::size_t>(j);
      const std::size_t next = j + 1 == n_ ? 0 : at + 1;
      s.out->tagged[row] = p_.tagged[at];
      s.out->tagged[row + 1] = 0;
      s.out->d[row] = s.out->d[row + 1] = p_.d[at] * half_;
      s.out->lambda[row] = p_.tagged[at] != 0 ? p_.lambda[at] : half_;
      s.out->lambda[row + 1] = p_.tagged[next] != 0 ? p_.lambda[at] : half_;
    }
  }

  // The same for any edges, by their divided differences.
  template <class Dim>
  void any_edges(Dim dim, const Strip& s, long from, long to) {
    const T* const d = s.d;
    const T* const lambda = s.lambda;
    const T* const x = s.x;
    const long a = s.first;
    T* const first = scratch_.first.data();
    T* const second = scratch_.second.data();
    T* const third = scratch_.third.data();
    // All quotients of a row by one number.
    const auto divide = [dim](T* to_row, const T* minuend, const T* subtrahend, const T& by) {
      if (by == T(0)) {
        for (long c = 0; c < dim; ++c) to_row[c] = T(0);
      } else {
        for (long c = 0; c < dim; ++c) to_row[c] = (minuend[c] - subtrahend[c]) / by;
      }
    };
    const bool six = rule_ == KnotRule::nuli6;
    // The points whose D is read, those that lie inside, and the edges beside them.
    const long low = from - (six ? 1 : 0), high = to + (six ? 2 : 1);
    const long inner_low = p_.closed ? low : std::max(low, 1 - a),
               inner_high = p_.closed ? high : std::min(high, edges_ - a);
    for (long i = inner_low - 1; i < inner_high; ++i) divide(first + i * dim, x + (i + 1) * dim, x + i * dim, d[i]);
    for (long i = inner_low; i < inner_high; ++i)
      divide(second + i * dim, first + i * dim, first + (i - 1) * dim, d[i - 1] + d[i]);
    for (long i = low; i < inner_low; ++i)
      std::copy_n(left_[static_cast<std::size_t>(-(a + i))].data(), dim_, second + i * dim);
    for (long i = std::max(low, inner_high); i < high; ++i)
      std::copy_n(right_[static_cast<std::size_t>(a + i - edges_)].data(), dim_, second + i * dim);
    const auto span = [&](long i) { return d[i - 1] + d[i] + d[i + 1]; };
    if (six) {
      for (long i = low; i < high - 1; ++i) divide(third + i * dim, second + (i + 1) * dim, second + i * dim, span(i));
    }
    T* fine = &s.out->points[s.row_of(from) * p_.dim];
    for (long i = from; i < to; ++i, fine += 2 * dim) {
      const T& di = d[i];
      const T quarter = di * di / T(4);
      T w, left(0), right(0);
      if (rule_ == KnotRule::nuli4) {
        w = quadratic_weight(lambda[i]);
      } else {
        const T all = span(i);
        w = all == T(0) ? half_ : (di / T(2) + d[i + 1]) / all;
      }
      if (six) {
        left = cubic_weight<T>(d[i - 1], di, T(1) - lambda[i - 1], lambda[i]);
        right = cubic_weight<T>(d[i + 1], di, lambda[i + 1], T(1) - lambda[i]);
      }
      const T other = T(1) - w;
      const T* const old = x + i * dim;
      for (long c = 0; c < dim; ++c) {
        const T* const D = second + i * dim + c;
        T bend = w * D[0] + other * D[dim];
        if (six) {
          const T* const t = third + i * dim + c;
          bend = bend + left * (t[-dim] - t[0]) - right * (t[dim] - t[0]);
        }
        fine[c] = old[c];
        fine[dim + c] = (old[c] + old[dim + c]) * half_ - quarter * bend;
      }
    }
    inherit(s, from, to);
  }

  const KnotPolygon<T>& p_;
  KnotScratch<T>& scratch_;
  KnotRule rule_;
  long n_, edges_, dim_;
  bool given_;
  T half_, twenty_, uniform_;                 // the last one: 1/16 or 1/288
  std::vector<std::vector<T>> left_, right_;  // D_{-h}, D_{edges+h}
};

// strip.run, for double and float compiled in the library.
void run_strip(KnotStrip<double>& strip, long from, long to, KnotPolygon<double>& out, std::size_t row);
void run_strip(KnotStrip<float>& strip, long from, long to, KnotPolygon<float>& out, std::size_t row);
template <class T>
void run_strip(KnotStrip<T>& strip, long from, long to, KnotPolygon<T>& out, std::size_t row) {
  strip.run(from, to, out, row);
}

// One step into `out`, whose vectors keep their room.
template <class T>
void refine_knots_into(const KnotPolygon<T>& p, KnotRule rule, Boundary boundary, KnotScratch<T>& scratch,
                       KnotPolygon<T>& out) {
  const long n = static_cast<long>(p.size());
  const long edges = static_cast<long>(p.edges());
  // With given points the edges whose stencil is not whole have no new point.
  const long skipped = !p.closed && boundary == Boundary::given ? half_width(rule) - 1 : 0;
  const auto made = static_cast<std::size_t>(edges - 2 * skipped);
  const auto count = static_cast<std::size_t>(n - 2 * skipped) + made;
  out.dim = p.dim;
  out.closed = p.closed;
  out.points.resize(count * p.dim, T(0));
  out.d.resize(2 * made, T(0));
  out.lambda.resize(2 * made, T(0));
  out.tagged.resize(count);
  KnotStrip<T> strip(p, rule, boundary, scratch);
  for (long e = skipped; e < edges - skipped; e += KnotStrip<T>::edges_at_once)
    run_strip(strip, e, std::min(edges - skipped, e + KnotStrip<T>::edges_at_once), out,
              2 * static_cast<std::size_t>(e - skipped));
  if (!p.closed) {
    const auto last = static_cast<std::size_t>(n - skipped - 1);
    std::copy_n(&p.points[last * p.dim], p.dim, &out.points[(count - 1) * p.dim]);
    out.tagged[count - 1] = p.tagged[last];
  }
}

}  // namespace detail

/// One step. The result is valid when the argument is. Cost: linear in the number of points.
template <class T>
KnotPolygon<T> refine_knots(const KnotPolygon<T>& p, KnotRule rule, Boundary boundary) {
  KnotPolygon<T> out;
  detail::KnotScratch<T> scratch;
  detail::refine_knots_into(p, rule, boundary, scratch, out);
  return out;
}

/// Points that Boundary::given takes beyond each end.
constexpr long points_beyond_ends(KnotRule rule) { return 2 * half_width(rule) - 2; }

/// Several steps, over polygons that are kept from call to call: a call like the one before allocates nothing. A large
/// result is made piece by piece, each through its last levels in the caches, by several threads for double and float.
/// Its bits depend neither on the pieces nor on the threads. Not for use by several threads at once.
template <class T>
class KnotRefiner {
 public:
  /// At most so many threads, and no more than there are cores; 0 (the default): that many.
  void set_threads(int threads) {
    if (threads < 0) detail::fail_knots("threads: " + std::to_string(threads) + " is negative");
    threads_ = threads;
    workers_.reset();
  }

  /// `levels` steps; the result is valid until the next call. With Boundary::given, points_beyond_ends() remain beyond
  /// each end. Throws as validate.
  const KnotPolygon<T>& refine(const KnotPolygon<T>& p, KnotRule rule, int levels, Boundary boundary) {
    validate(p, rule, boundary);
    const auto steps = static_cast<std::size_t>(std::max(0, levels));
    if (steps == 0) return result_ = p;
    // Levels one after the other; the others piece by piece.
    const bool large = p.edges() > piece_points >> std::min<std::size_t>(steps, 24);
    const std::size_t single = large ? steps - std::min(steps, most_together) : steps;
    if (kept_.size() < single) kept_.resize(single);
    const KnotPolygon<T>* now = &p;
    for (std::size_t k = 0; k < single; ++k) {
      KnotPolygon<T>& next = k + 1 == steps ? result_ : kept_[k];
      detail::refine_knots_into(*now, rule, boundary, pieces_[0].scratch, next);
      now = &next;
    }
    if (single < steps) by_pieces(*now, rule, steps - single, boundary);
    return result_;
  }

  /// The last result, taken out.
  KnotPolygon<T> take() && { return std::move(result_); }

 private:
  static constexpr std::size_t piece_points = 4096;
  static constexpr std::size_t most_together = 8;

  // A part of a polygon on its way through the levels: open polygons, with more points at their ends than they should
  // have. One for each level: pieces are of the same sizes, and nothing is filled twice.
  struct Piece {
    std::vector<KnotPolygon<T>> level;
    KnotPolygon<T> rows;  // of the last step, on their way past the caches
    detail::KnotScratch<T> scratch;
  };

  // What all pieces share. Piece i: the edges first + i*edges .. of `p`, `edges` or what is left before `last`.
  struct Cut {
    const KnotPolygon<T>* p = nullptr;
    KnotRule rule{};
    std::size_t levels = 0;  // at least 1
    Boundary boundary{};
    long first = 0, last = 0, edges = 0;
    bool stream = false;  // numbers that are bytes only
    KnotPolygon<T>* out = nullptr;
    std::vector<Piece>* scratch = nullptr;

    static void call(void* context, std::size_t worker, std::size_t i) {
      const Cut& cut = *static_cast<const Cut*>(context);
      cut.run((*cut.scratch)[worker], static_cast<long>(i));
    }

    void run(Piece& piece, long i) const {
      const long beyond = points_beyond_ends(rule);
      const long a = first + i * edges, b = std::min(last, a + edges);
      // Cut ends are `given` ends in a polygon that is closed or has them; else the boundary is at work at both ends of
      // the piece, and changes points only that are dropped.
      const Boundary ends = boundary == Boundary::closed ? Boundary::given : boundary;
      const bool given = ends == Boundary::given;
      const long low = given ? a - beyond : std::max(first, a - beyond);
      const long high = given ? b + beyond : std::min(last, b + beyond);
      if (piece.level.size() < levels) piece.level.resize(levels);
      take_edges(low, high, piece.level[0]);
      for (std::size_t k = 0; k + 1 < levels; ++k)
        detail::refine_knots_into(piece.level[k], rule, ends, piece.scratch, piece.level[k + 1]);
      // Of the rows of the last step: those from the point a on, to the one before the point b.
      const long scale = long{1} << levels;
      const bool opens = !p->closed && a == first, closes = !p->closed && b == last;
      long skip = given ? beyond : (a - low) * scale;
      long count = (b - a) * scale, row = (a - first) * scale;
      if (given && !p->closed) {  // points beyond the ends are part of the result
        row += opens ? 0 : beyond;
        count += (opens ? beyond : 0) + (closes ? beyond : 0);
        skip -= opens ? beyond : 0;
      }
      const KnotPolygon<T>& q = piece.level[levels - 1];
      const long edge = (given ? half_width(rule) - 1 : 0) + skip / 2;
      last_step(q, ends, edge, edge + count / 2, piece, static_cast<std::size_t>(row));
      if (closes) {
        const auto from = static_cast<std::size_t>(edge + count / 2), to = static_cast<std::size_t>(row + count);
        std::copy_n(&q.points[from * p->dim], p->dim, &out->points[to * p->dim]);
        out->tagged[to] = q.tagged[from];
      }
    }

    // The edges from..to-1 of a piece, into the rows row.. of the result.
    void last_step(const KnotPolygon<T>& q, Boundary ends, long from, long to, Piece& piece, std::size_t row) const {
      detail::KnotStrip<T> strip(q, rule, ends, piece.scratch);
      constexpr long most = detail::KnotStrip<T>::edges_at_once;
      for (long e = from; e < to; e += most) {
        const long end = std::min(to, e + most);
        const auto rows = 2 * static_cast<std::size_t>(end - e);
        if (!stream) {
          detail::run_strip(strip, e, end, *out, row);
        } else {
          KnotPolygon<T>& r = piece.rows;
          r.points.resize(2 * most * p->dim, T(0));
          r.d.resize(2 * most, T(0));
          r.lambda.resize(2 * most, T(0));
          r.tagged.resize(2 * most);
          detail::run_strip(strip, e, end, r, 0);
          const auto past = [&](const auto& numbers, std::size_t width, auto& target) {
            detail::stream_copy(numbers.data(), rows * width * sizeof(numbers[0]), target.data() + row * width);
          };
          past(r.points, p->dim, out->points);
          past(r.d, 1, out->d);
          past(r.lambda, 1, out->lambda);
          past(r.tagged, 1, out->tagged);
        }
        row += rows;
      }
      if (stream) detail::drain();
    }

    // The edges low..high-1 as an open polygon.
    void take_edges(long low, long high, KnotPolygon<T>& to) const {
      const long n = static_cast<long>(p->size());
      const auto rows = static_cast<std::size_t>(high - low);
      to.dim = p->dim;
      to.closed = false;
      to.points.resize((rows + 1) * p->dim, T(0));
      to.d.resize(rows, T(0));
      to.lambda.resize(rows, T(0));
      to.tagged.resize(rows + 1);
      for (std::size_t i = 0; i <= rows; ++i) {
        const long j = low + static_cast<long>(i);
        const auto from = static_cast<std::size_t>(p->closed ? j - n * floor_div(j, n) : j);
        std::copy_n(&p->points[from * p->dim], p->dim, &to.points[i * p->dim]);
        to.tagged[i] = p->tagged[from];
        if (i == rows) break;
        to.d[i] = p->d[from];
        to.lambda[i] = p->lambda[from];
      }
    }
  };

  void by_pieces(const KnotPolygon<T>& p, KnotRule rule, std::size_t levels, Boundary boundary) {
    KnotPolygon<T>& out = result_;
    const long beyond = boundary == Boundary::given ? points_beyond_ends(rule) : 0;
    Cut cut{&p, rule, levels, boundary, beyond, static_cast<long>(p.edges()) - beyond, 0, false, &out, &pieces_};
    cut.edges = std::max(1L, static_cast<long>(piece_points) >> levels);
    const auto made = static_cast<std::size_t>(((cut.last - cut.first) << levels) + 2 * beyond);
    const std::size_t points = made + (p.closed ? 0 : 1);
    out.dim = p.dim;
    out.closed = p.closed;
    out.points.resize(points * p.dim, T(0));
    out.d.resize(made, T(0));
    out.lambda.resize(made, T(0));
    out.tagged.resize(points);
    const auto count = static_cast<std::size_t>(ceil_div(cut.last - cut.first, cut.edges));
    if constexpr (detail::is_vectorised<T>) {
      cut.stream = points * (p.dim * sizeof(T) + 2 * sizeof(T) + 1) > detail::streamed_from();
      constexpr std::size_t grain = 8;
      if (threads_ != 1 && count >= 2 * grain) {
        if (!workers_) workers_ = std::make_shared<detail::Workers>(threads_);
        if (pieces_.size() < workers_->count()) pieces_.resize(workers_->count());
        workers_->run(count, grain, &cut, &Cut::call);
        return;
      }
    }
    for (std::size_t i = 0; i < count; ++i) Cut::call(&cut, 0, i);
  }

  std::vector<KnotPolygon<T>> kept_;  // levels before the last one
  KnotPolygon<T> result_;
  std::vector<Piece> pieces_{1};  // one for each worker
  int threads_ = 0;
  std::shared_ptr<detail::Workers> workers_;
};

/// `levels` steps. With Boundary::given, points_beyond_ends() remain beyond each end.
template <class T>
KnotPolygon<T> refine_knots(const KnotPolygon<T>& p, KnotRule rule, int levels, Boundary boundary) {
  KnotRefiner<T> refiner;
  refiner.refine(p, rule, levels, boundary);
  return std::move(refiner).take();
}

/// The part of an open polygon between the points given beyond its ends.
template <class T>
KnotPolygon<T> cropped(KnotPolygon<T> p, long left, long right) {
  const auto cut = [](auto& v, long a, long b) {
    v.erase(v.end() - b, v.end());
    v.erase(v.begin(), v.begin() + a);
  };
  const long dim = static_cast<long>(p.dim);
  cut(p.points, left * dim, right * dim);
  cut(p.d, left, right);
  cut(p.lambda, left, right);
  cut(p.tagged, left, right);
  return p;
}

struct KnotOptions {
  int levels = 1;
  Boundary boundary = Boundary::closed;
  Parametrization parametrization = Parametrization::centripetal;
  /// Knot intervals are taken from the points before every step (Dyn, Floater and Hormann 2009), not halved.
  bool reparametrize = false;
};

/// The columns of points on knots; all that are not named are coordinates.
struct KnotColumns {
  std::vector<std::size_t> coordinates;
  std::optional<std::size_t> lambda, d, tag;
};
/// Throws Error (bad_input): no coordinate, no column d of given intervals, given intervals taken from the points at
/// every step, more than 2^31 points out.
KnotColumns knot_columns(const PointSet& points, const KnotOptions& options);
/// The tags that a column holds, row by row, else default_tags. Throws Error (bad_input) for one that is not 0 or 1.
template <class T>
std::vector<unsigned char> tags_of(const PointSet& points, const KnotColumns& columns, const KnotPolygon<T>& p) {
  if (!columns.tag) return default_tags(p);
  std::vector<unsigned char> tags;
  for (std::size_t j = 0; j < points.size(); ++j) {
    const double tag = points.values[j * points.dim + *columns.tag];
    if (tag != 0 && tag != 1)
      detail::fail_knots("a tag is neither 0 nor 1 in row " + std::to_string(j + 1) + ": " + detail::number(tag));
    tags.push_back(tag != 0 ? 1 : 0);
  }
  return tags;
}

/// Refines points with the columns of a file: `lambda` and `d` of the edge that starts at the point, `tag` (0 or 1),
/// all others are coordinates. Without `lambda` it is 1/2; `d` is read only for Parametrization::given; without `tag`
/// default_tags. The same columns come out, point 0 first, `d` and `lambda` as they are after the last step; the last
/// point of an open polygon has no edge, its `d` and `lambda` are not read and repeat those of the edge before.
/// Throws Error (bad_input): no coordinate, what validate() refuses, a number that is not finite, more than 2^31
/// points.
PointSet refine_on_knots(const PointSet& points, KnotRule rule, const KnotOptions& options);

template <class T>
void validate(const KnotPolygon<T>& p, KnotRule rule, Boundary boundary) {
  const std::size_t n = p.size();
  if (p.dim == 0 || p.points.size() != n * p.dim || p.tagged.size() != n || p.d.size() != p.edges() ||
      p.lambda.size() != p.edges())
    detail::fail_knots("a polygon with knots has vectors of wrong sizes");
  if (p.closed != (boundary == Boundary::closed)) detail::fail_knots("an end rule does not fit a closed polygon");
  std::size_t least = 3;
  if (boundary == Boundary::given) least = 2 * static_cast<std::size_t>(points_beyond_ends(rule)) + 2;
  if (boundary == Boundary::linear) least = 2;
  if (boundary == Boundary::space) least = static_cast<std::size_t>(precision(rule)) + 1;
  if (n < least)
    detail::fail_knots("at least " + std::to_string(least) + " points are needed, not " + std::to_string(n));
  for (std::size_t e = 0; e < p.edges(); ++e) {
    const std::string row = " in row " + std::to_string(e + 1);
    if (!(p.d[e] >= T(0))) detail::fail_knots("a knot interval is not >= 0" + row);
    if (!(p.lambda[e] >= T(0) && p.lambda[e] <= T(1))) detail::fail_knots("an edge parameter is not in [0, 1]" + row);
    if (p.d[e] == T(0))
      for (std::size_t c = 0; c < p.dim; ++c)
        if (!(p.points[e * p.dim + c] == p.points[(e + 1) % n * p.dim + c]))
          detail::fail_knots("a knot interval of length 0 between different points" + row);
  }
}

}  // namespace twoscale::kernels
