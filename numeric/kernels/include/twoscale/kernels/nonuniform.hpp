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

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "twoscale/kernels/error.hpp"
#include "twoscale/kernels/points_io.hpp"
#include "twoscale/kernels/refine.hpp"

namespace twoscale::kernels {

enum class KnotRule { lagrange4, nuli4, nuli6 };

/// "lagrange4", "nuli4", "nuli6"; anything else throws Error (bad_input).
KnotRule parse_knot_rule(std::string_view text);
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

// A vector with an index that may start below 0.
template <class T>
class Shifted {
 public:
  Shifted(long first, std::size_t count, const T& value) : first_(first), v_(count, value) {}
  T& operator[](long i) { return v_[static_cast<std::size_t>(i - first_)]; }
  const T& operator[](long i) const { return v_[static_cast<std::size_t>(i - first_)]; }

 private:
  long first_;
  std::vector<T> v_;
};

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

/// One step. The result is valid when the argument is. Cost: linear in the number of points.
template <class T>
KnotPolygon<T> refine_knots(const KnotPolygon<T>& p, KnotRule rule, Boundary boundary) {
  using detail::quotient_or_zero;
  using detail::Shifted;
  const long n = static_cast<long>(p.size());
  const long edges = static_cast<long>(p.edges());
  const long dim = static_cast<long>(p.dim);
  const T half = T(1) / T(2);
  const auto wrap = [n](long j) { return j - n * floor_div(j, n); };
  const auto index = [dim](long j, long c) { return static_cast<std::size_t>(j * dim + c); };

  // Knot intervals and edge parameters beyond the ends: those of the other end, or mirrored ones.
  const std::size_t margin = static_cast<std::size_t>(edges) + 6;
  Shifted<T> d(-3, margin, T(0));
  Shifted<T> lambda(-3, margin, half);
  for (long e = -3; e < edges + 3; ++e) {
    if (p.closed || (e >= 0 && e < edges)) {
      const auto from = static_cast<std::size_t>(p.closed ? wrap(e) : e);
      d[e] = p.d[from];
      lambda[e] = p.lambda[from];
    } else {
      // Mirrored at an end; a polygon with less than three edges has no more to mirror.
      const long mirrored = e < 0 ? -1 - e : 2 * edges - 1 - e;
      const auto from = static_cast<std::size_t>(std::min(std::max(mirrored, 0L), edges - 1));
      d[e] = p.d[from];
      lambda[e] = T(1) - p.lambda[from];
    }
  }

  // Divided differences; component c of D_j at j*dim + c.
  Shifted<T> first(-3 * dim, margin * p.dim, T(0));
  for (long e = -3; e < edges + 3; ++e) {
    if (!p.closed && (e < 0 || e >= edges)) continue;
    const long from = p.closed ? wrap(e) : e;
    const long to = p.closed ? wrap(e + 1) : e + 1;
    for (long c = 0; c < dim; ++c)
      first[e * dim + c] = quotient_or_zero<T>(p.points[index(to, c)] - p.points[index(from, c)], d[e]);
  }
  Shifted<T> second(-2 * dim, (static_cast<std::size_t>(edges) + 5) * p.dim, T(0));
  for (long j = p.closed ? -2 : 1; j <= (p.closed ? edges + 2 : edges - 1); ++j)
    for (long c = 0; c < dim; ++c)
      second[j * dim + c] = quotient_or_zero<T>(first[j * dim + c] - first[(j - 1) * dim + c], d[j - 1] + d[j]);
  const auto third_span = [&](long j) { return d[j - 1] + d[j] + d[j + 1]; };
  if (!p.closed && boundary == Boundary::linear) {
    for (long h = 0; h <= 2; ++h)
      for (long c = 0; c < dim; ++c) {
        second[-h * dim + c] = h == 0 || h >= edges ? T(0) : T(0) - second[h * dim + c];
        second[(edges + h) * dim + c] = h == 0 || h >= edges ? T(0) : T(0) - second[(edges - h) * dim + c];
      }
  } else if (!p.closed) {
    // The polynomial of the first points goes on: D constant, or T constant.
    for (long c = 0; c < dim; ++c) {
      const bool cubic = precision(rule) == 3;
      const T left = cubic ? quotient_or_zero<T>(second[2 * dim + c] - second[dim + c], third_span(1)) : T(0);
      const T right = cubic ? quotient_or_zero<T>(second[(edges - 1) * dim + c] - second[(edges - 2) * dim + c],
                                                  third_span(edges - 2))
                            : T(0);
      for (long j = 0; j >= -2; --j)
        second[j * dim + c] = second[(j + 1) * dim + c] - (j >= -1 ? left * third_span(j) : T(0));
      for (long j = edges; j <= edges + 2; ++j)
        second[j * dim + c] = second[(j - 1) * dim + c] + (j <= edges + 1 ? right * third_span(j - 1) : T(0));
    }
  }

  // With given points the edges whose stencil is not whole have no new point.
  const long skipped = !p.closed && boundary == Boundary::given ? half_width(rule) - 1 : 0;
  KnotPolygon<T> out;
  out.dim = p.dim;
  out.closed = p.closed;
  const long kept = n - 2 * skipped;
  const long made = edges - 2 * skipped;
  out.points.reserve(static_cast<std::size_t>(kept + made) * p.dim);
  for (long j = skipped; j < n - skipped; ++j) {
    for (long c = 0; c < dim; ++c) out.points.push_back(p.points[index(j, c)]);
    out.tagged.push_back(p.tagged[static_cast<std::size_t>(j)]);
    if (j >= edges - skipped) break;
    const T& dj = d[j];
    const T quarter = dj * dj / T(4);
    T w;
    if (rule == KnotRule::nuli4) {
      w = detail::quadratic_weight(lambda[j]);
    } else {
      const T span = third_span(j);
      w = span == T(0) ? half : (dj / T(2) + d[j + 1]) / span;
    }
    T left(0), right(0);
    if (rule == KnotRule::nuli6) {
      left = detail::cubic_weight<T>(d[j - 1], dj, T(1) - lambda[j - 1], lambda[j]);
      right = detail::cubic_weight<T>(d[j + 1], dj, lambda[j + 1], T(1) - lambda[j]);
    }
    const long next = p.closed ? wrap(j + 1) : j + 1;
    for (long c = 0; c < dim; ++c) {
      const T& before = second[j * dim + c];
      const T& after = second[(j + 1) * dim + c];
      T bend = w * before + (T(1) - w) * after;
      if (rule == KnotRule::nuli6) {
        const T middle = quotient_or_zero<T>(after - before, third_span(j));
        const T t_left = quotient_or_zero<T>(before - second[(j - 1) * dim + c], third_span(j - 1));
        const T t_right = quotient_or_zero<T>(second[(j + 2) * dim + c] - after, third_span(j + 1));
        bend = bend + left * (t_left - middle) - right * (t_right - middle);
      }
      out.points.push_back((p.points[index(j, c)] + p.points[index(next, c)]) * half - quarter * bend);
    }
    out.tagged.push_back(0);
    const T d_half = dj / T(2);
    out.d.push_back(d_half);
    out.d.push_back(d_half);
    out.lambda.push_back(p.tagged[static_cast<std::size_t>(j)] != 0 ? p.lambda[static_cast<std::size_t>(j)] : half);
    out.lambda.push_back(p.tagged[static_cast<std::size_t>(next)] != 0 ? p.lambda[static_cast<std::size_t>(j)] : half);
  }
  return out;
}

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
