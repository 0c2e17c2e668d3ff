// SPDX-License-Identifier: GPL-3.0-or-later
// Refinement on knots by exact weights, one pattern of intervals and edge parameters at a time.
#include <algorithm>
#include <cmath>
#include <map>
#include <type_traits>

#include "digits.hpp"
#include "exact_knots.hpp"
#include "rounding.hpp"
#include "twoscale/lowering/refine_knots.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::lowering {

namespace {

using kernels::Boundary;

using kernels::KnotPolygon;

// Numbers of polygons: doubles, or rational throughout.
Rational exact(double x) {
  Ball ball;
  arf_set_d(arb_midref(ball.raw()), x);
  return to_rational(arb_midref(ball.raw()));
}
Rational exact(const Rational& x) { return x; }
template <class T>
T as(const Rational& x) {
  if constexpr (std::is_same_v<T, double>)
    return rounded_double(x);
  else
    return x;
}

// The weights of the new point of an edge, by the ratios of the intervals around it to its own and the edge parameters.
template <class T>
class Weights {
 public:
  explicit Weights(const SampledScheme& scheme) : scheme_(scheme), rest_(as<T>(scheme.rest)) {}

  const SampledScheme& scheme() const { return scheme_; }
  const T& rest() const { return rest_; }
  // Edges on either side whose values are read.
  long reach() const { return std::max(-scheme_.lowest(), scheme_.last_interval()); }

  const std::vector<T>& operator()(const std::vector<T>& ratios, const std::vector<T>& lambda) {
    const auto [place, fresh] = known_.try_emplace({ratios, lambda});
    if (fresh) {
      std::vector<Rational> d, l;
      for (const T& x : ratios) d.push_back(exact(x));
      // What is at rest is so exactly.
      for (const T& x : lambda) l.push_back(x == rest_ ? scheme_.rest : exact(x));
      for (const Rational& w : scheme_.weights(d, l)) place->second.push_back(as<T>(w));
    }
    return place->second;
  }

 private:
  const SampledScheme& scheme_;
  T rest_;
  std::map<std::pair<std::vector<T>, std::vector<T>>, std::vector<T>> known_;
};

template <class T>
KnotPolygon<T> step(const KnotPolygon<T>& p, Weights<T>& weights, Boundary boundary) {
  const long n = static_cast<long>(p.size()), edges = static_cast<long>(p.edges());
  const auto wrap = [](long j, long m) { return ((j % m) + m) % m; };
  // Beyond the ends of an open polygon: mirrored, as Boundary::linear says.
  const auto at_edge = [&](const std::vector<T>& values, long e, bool reversed) -> T {
    if (p.closed) return values[static_cast<std::size_t>(wrap(e, edges))];
    const long m = e < 0 ? -1 - e : e >= edges ? 2 * edges - 1 - e : e;
    const T& x = values[static_cast<std::size_t>(std::clamp(m, 0L, edges - 1))];
    return reversed && m != e ? T(1) - x : x;
  };
  const auto point = [&](long j, std::size_t c) -> T {
    const auto at = [&](long i) -> const T& { return p.points[static_cast<std::size_t>(i) * p.dim + c]; };
    if (p.closed) return at(wrap(j, n));
    if (j < 0) return T(2) * at(0) - at(std::min(-j, n - 1));
    if (j >= n) return T(2) * at(n - 1) - at(std::max(2 * (n - 1) - j, 0L));
    return at(j);
  };
  const SampledScheme& scheme = weights.scheme();
  const T& rest = weights.rest();
  const long skipped = boundary == Boundary::given ? weights.reach() : 0;
  KnotPolygon<T> out;
  out.dim = p.dim;
  out.closed = p.closed;
  for (long j = skipped; j < n - skipped; ++j) {
    for (std::size_t c = 0; c < p.dim; ++c) out.points.push_back(point(j, c));
    out.tagged.push_back(p.tagged[static_cast<std::size_t>(j)]);
    if (j >= edges - skipped) break;
    const T own = at_edge(p.d, j, false), parameter = at_edge(p.lambda, j, false);
    std::vector<T> ratios, lambda;
    for (long e = scheme.lowest(); e <= scheme.last_interval(); ++e) ratios.push_back(at_edge(p.d, j + e, false) / own);
    for (long e = scheme.first_parameter(); e <= scheme.last_parameter(); ++e)
      lambda.push_back(at_edge(p.lambda, j + e, true));
    const std::vector<T>& w = weights(ratios, lambda);
    for (std::size_t c = 0; c < p.dim; ++c) {
      T sum(0);
      for (std::size_t h = 0; h < w.size(); ++h) sum += w[h] * point(j + scheme.lowest() + static_cast<long>(h), c);
      out.points.push_back(sum);
    }
    out.tagged.push_back(0);
    out.d.insert(out.d.end(), 2, own / T(2));
    out.lambda.push_back(p.tagged[static_cast<std::size_t>(j)] != 0 ? parameter : rest);
    out.lambda.push_back(p.tagged[static_cast<std::size_t>(wrap(j + 1, n))] != 0 ? parameter : rest);
  }
  return out;
}

// All steps. take(p): the intervals from the points. p.tagged empty: both ends of every edge that is not at rest.
template <class T, class F>
KnotPolygon<T> refined(const SampledScheme& scheme, KnotPolygon<T> p, const kernels::KnotOptions& options,
                       const F& take) {
  Weights<T> weights(scheme);
  if (options.boundary == Boundary::space)
    bad_input("the end rule space is there for lagrange4, nuli4 and nuli6", scheme.id);
  const long beyond = 2 * weights.reach();
  const long least = p.closed ? 3 : options.boundary == Boundary::given ? 2 * beyond + 2 : 2;
  if (static_cast<long>(p.size()) < least)
    bad_input("at least " + std::to_string(least) + " points are needed, not " + std::to_string(p.size()), scheme.id);
  for (std::size_t e = 0; e < p.edges(); ++e) {
    if (!(p.d[e] > T(0))) bad_input("a knot interval is not positive, in row " + std::to_string(e + 1), scheme.id);
    if (!(p.lambda[e] >= T(0) && p.lambda[e] <= T(1)))
      bad_input("an edge parameter is not in [0, 1], in row " + std::to_string(e + 1), scheme.id);
  }
  if (p.tagged.empty()) {
    p.tagged.assign(p.size(), 0);
    for (std::size_t e = 0; e < p.edges(); ++e)
      if (p.lambda[e] != weights.rest()) p.tagged[e] = p.tagged[(e + 1) % p.size()] = 1;
  }
  for (int k = 0; k < options.levels; ++k) {
    if (options.reparametrize && k > 0) take(p);
    p = step(p, weights, options.boundary);
  }
  return options.boundary == Boundary::given ? kernels::cropped(std::move(p), beyond, beyond) : p;
}

}  // namespace

kernels::PointSet refine_by_weights(const SampledScheme& scheme, const kernels::PointSet& points,
                                    const kernels::KnotOptions& options) {
  const kernels::KnotColumns columns = kernels::knot_columns(points, options);
  KnotPolygon<double> p;
  p.dim = columns.coordinates.size();
  p.closed = options.boundary == Boundary::closed;
  const auto value = [&](std::size_t j, std::size_t c) { return points.values[j * points.dim + c]; };
  for (std::size_t j = 0; j < points.size(); ++j)
    for (const std::size_t c : columns.coordinates) p.points.push_back(value(j, c));
  const bool given = options.parametrization == kernels::Parametrization::given;
  for (std::size_t e = 0; e < p.edges(); ++e) {
    p.lambda.push_back(columns.lambda ? value(e, *columns.lambda) : as<double>(scheme.rest));
    if (given) p.d.push_back(value(e, *columns.d));
  }
  const auto take = [&](KnotPolygon<double>& q) {
    q.d = kernels::knot_intervals(q.points, q.dim, q.closed, options.parametrization);
  };
  if (!given) take(p);
  if (columns.tag) p.tagged = kernels::tags_of(points, columns, p);
  p = refined(scheme, std::move(p), options, take);
  kernels::PointSet out;
  out.columns = points.columns;
  out.dim = points.dim;
  for (std::size_t j = 0; j < p.size(); ++j) {
    const std::size_t e = std::min(j, p.edges() - 1);
    std::size_t next = 0;
    for (std::size_t c = 0; c < points.dim; ++c) {
      const double x = c == columns.d        ? p.d[e]
                       : c == columns.lambda ? p.lambda[e]
                       : c == columns.tag    ? p.tagged[j]
                                             : p.points[j * p.dim + next++];
      if (!std::isfinite(x)) bad_input("a refined number does not fit a double", scheme.id);
      out.values.push_back(x);
    }
  }
  return out;
}

kernels::PointSet refine_by_weights(const SampledScheme& scheme, const kernels::PointSet& points,
                                    const kernels::KnotOptions& options, long digits) {
  if (digits < 17 || digits > 10000) bad_input("digits must lie between 17 and 10000", std::to_string(digits));
  const kernels::KnotColumns columns = kernels::knot_columns(points, options);
  check_output_size(std::ldexp(static_cast<double>(points.size()), options.levels), points.dim, digits,
                    std::to_string(points.size()) + " points, " + std::to_string(options.levels) + " levels");
  KnotPolygon<Rational> p = exact_polygon(points, columns, options, scheme.rest);
  const auto kind = options.parametrization;
  const bool from_points = kind == kernels::Parametrization::chordal || kind == kernels::Parametrization::centripetal;
  const auto d = rational_intervals(p, kind);
  if (!d || (from_points && (columns.d || options.reparametrize)))
    bad_input("--digits needs rational ratios of the knot intervals here (a column d, or --parametrization uniform)",
              scheme.id);
  p.d = *d;
  if (!columns.tag) p.tagged.clear();
  const auto take = [](KnotPolygon<Rational>& q) { q.d.assign(q.edges(), Rational(1)); };  // uniform
  return rounded_points(points, columns, refined(scheme, std::move(p), options, take), digits);
}

}  // namespace twoscale::lowering
