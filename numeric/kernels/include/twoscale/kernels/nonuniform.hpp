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

// The formulas for a strip of edges, over arrays that stay in the first cache; number i of an array belongs to edge or
// point first + i. Two strips never depend on each other, and every quotient is formed once in each.
template <class T>
class KnotStrip {
 public:
  static constexpr long edges_at_once = 256;

  KnotStrip(const KnotPolygon<T>& p, KnotRule rule, Boundary boundary)
      : p_(p),
        rule_(rule),
        n_(static_cast<long>(p.size())),
        edges_(static_cast<long>(p.edges())),
        dim_(static_cast<long>(p.dim)),
        half_(T(1) / T(2)) {
    const std::size_t room = static_cast<std::size_t>(edges_at_once + 2 * reach + 2);
    d_.resize(room, T(0));
    lambda_.resize(room, half_);
    for (auto* rows : {&x_, &first_, &second_, &third_}) rows->resize(room * p.dim, T(0));
    if (!p.closed) extend_ends(boundary);
  }

  // New points of the edges from..to-1 (at most edges_at_once), and the old ones before them, into `out` from its row
  // `row` on.
  void run(long from, long to, KnotPolygon<T>& out, std::size_t row) {
    switch (dim_) {
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

  template <class Dim>
  void run(Dim dim, long from, long to, KnotPolygon<T>& out, std::size_t row) {
    const long a = from - reach, b = to + reach;  // edges a..b-1
    const bool inside = a >= 0 && b < (p_.closed ? n_ : edges_);
    if (!inside) {
      for (long e = a; e < b; ++e) {
        const auto [interval, parameter] = edge(e);
        d_[static_cast<std::size_t>(e - a)] = interval;
        lambda_[static_cast<std::size_t>(e - a)] = parameter;
      }
      for (long j = a; j <= b; ++j)
        if (p_.closed || (j >= 0 && j < n_)) std::copy_n(point(j), dim_, &x_[static_cast<std::size_t>((j - a) * dim)]);
    }
    const T* const d = inside ? &p_.d[static_cast<std::size_t>(a)] : d_.data();
    const T* const lambda = inside ? &p_.lambda[static_cast<std::size_t>(a)] : lambda_.data();
    const T* const x = inside ? &p_.points[static_cast<std::size_t>(a * dim)] : x_.data();
    T* const first = first_.data();
    T* const second = second_.data();
    T* const third = third_.data();
    // All quotients of a row by one number.
    const auto divide = [dim](T* to_row, const T* minuend, const T* subtrahend, const T& by) {
      if (by == T(0)) {
        for (long c = 0; c < dim; ++c) to_row[c] = T(0);
      } else {
        for (long c = 0; c < dim; ++c) to_row[c] = (minuend[c] - subtrahend[c]) / by;
      }
    };
    const long edge_low = p_.closed ? a : std::max(a, 0L), edge_high = p_.closed ? b : std::min(b, edges_);
    for (long i = edge_low - a; i < edge_high - a; ++i) divide(first + i * dim, x + (i + 1) * dim, x + i * dim, d[i]);
    const long point_low = p_.closed ? a + 1 : std::max(a + 1, 1L);
    const long point_high = p_.closed ? b : std::min(b, edges_);
    for (long i = point_low - a; i < point_high - a; ++i)
      divide(second + i * dim, first + i * dim, first + (i - 1) * dim, d[i - 1] + d[i]);
    for (long j = a + 1; j < point_low; ++j)
      if (j >= -2) std::copy_n(left_[static_cast<std::size_t>(-j)].data(), dim_, second + (j - a) * dim);
    for (long j = point_high; j < b; ++j)
      if (j <= edges_ + 2)
        std::copy_n(right_[static_cast<std::size_t>(j - edges_)].data(), dim_, second + (j - a) * dim);
    const auto span = [&](long i) { return d[i - 1] + d[i] + d[i + 1]; };
    const bool six = rule_ == KnotRule::nuli6;
    if (six) {
      for (long i = reach - 1; i < b - a - reach + 1; ++i)
        divide(third + i * dim, second + (i + 1) * dim, second + i * dim, span(i));
    }
    T* fine = &out.points[row * p_.dim];
    for (long i = reach; i < b - a - reach; ++i, fine += 2 * dim) {
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
    for (long j = from; j < to; ++j, row += 2) {
      const auto at = static_cast<std::size_t>(j);
      const std::size_t next = j + 1 == n_ ? 0 : at + 1;
      out.tagged[row] = p_.tagged[at];
      out.tagged[row + 1] = 0;
      out.d[row] = out.d[row + 1] = p_.d[at] / T(2);
      out.lambda[row] = p_.tagged[at] != 0 ? p_.lambda[at] : half_;
      out.lambda[row + 1] = p_.tagged[next] != 0 ? p_.lambda[at] : half_;
    }
  }

  const KnotPolygon<T>& p_;
  KnotRule rule_;
  long n_, edges_, dim_;
  T half_;
  std::vector<T> d_, lambda_, x_, first_, second_, third_;
  std::vector<std::vector<T>> left_, right_;  // D_{-h}, D_{edges+h}
};

// One step into `out`, whose vectors keep their room.
template <class T>
void refine_knots_into(const KnotPolygon<T>& p, KnotRule rule, Boundary boundary, KnotPolygon<T>& out) {
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
  KnotStrip<T> strip(p, rule, boundary);
  for (long e = skipped; e < edges - skipped; e += KnotStrip<T>::edges_at_once)
    strip.run(e, std::min(edges - skipped, e + KnotStrip<T>::edges_at_once), out,
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
  detail::refine_knots_into(p, rule, boundary, out);
  return out;
}

/// Several steps, over polygons that are kept from call to call.
template <class T>
class KnotRefiner {
 public:
  /// `levels` steps; the result is valid until the next call. With Boundary::given, points_beyond_ends() remain beyond
  /// each end. Throws as validate.
  const KnotPolygon<T>& refine(const KnotPolygon<T>& p, KnotRule rule, int levels, Boundary boundary) {
    validate(p, rule, boundary);
    const std::size_t steps = static_cast<std::size_t>(std::max(0, levels));
    if (kept_.size() < std::max<std::size_t>(1, steps)) kept_.resize(std::max<std::size_t>(1, steps));
    if (steps == 0) return kept_[0] = p;
    for (std::size_t k = 0; k < steps; ++k)
      detail::refine_knots_into(k == 0 ? p : kept_[k - 1], rule, boundary, kept_[k]);
    return kept_[steps - 1];
  }

 private:
  std::vector<KnotPolygon<T>> kept_;
};

/// `levels` steps. With Boundary::given, points_beyond_ends() remain beyond each end.
template <class T>
KnotPolygon<T> refine_knots(KnotPolygon<T> p, KnotRule rule, int levels, Boundary boundary) {
  validate(p, rule, boundary);
  for (int k = 0; k < levels; ++k) p = refine_knots(p, rule, boundary);
  return p;
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

/// Points that Boundary::given takes beyond each end.
constexpr long points_beyond_ends(KnotRule rule) { return 2 * half_width(rule) - 2; }

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
