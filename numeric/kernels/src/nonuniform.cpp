// SPDX-License-Identifier: 0BSD
#include "twoscale/kernels/nonuniform.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "twoscale/kernels/number_text.hpp"

namespace twoscale::kernels {

namespace detail {

void fail_knots(const std::string& message) { throw Error(Error::Kind::bad_input, message); }

std::string number(double value) { return shortest(value); }

}  // namespace detail

std::optional<KnotRule> find_knot_rule(std::string_view text) {
  if (text == "lagrange4") return KnotRule::lagrange4;
  if (text == "nuli4") return KnotRule::nuli4;
  if (text == "nuli6") return KnotRule::nuli6;
  return std::nullopt;
}

KnotRule parse_knot_rule(std::string_view text) {
  if (const auto rule = find_knot_rule(text)) return *rule;
  detail::fail_knots("no kernel refines by this rule: " + quoted(text));
}

Parametrization parse_parametrization(std::string_view text) {
  if (text == "uniform") return Parametrization::uniform;
  if (text == "chordal") return Parametrization::chordal;
  if (text == "centripetal") return Parametrization::centripetal;
  if (text == "given") return Parametrization::given;
  detail::fail_knots("the parametrization must be centripetal, chordal, uniform or given, not " + quoted(text));
}

std::vector<double> knot_intervals(std::span<const double> points, std::size_t dim, bool closed, Parametrization kind) {
  if (kind == Parametrization::given) detail::fail_knots("given knot intervals cannot be computed from the points");
  const std::size_t n = dim == 0 ? 0 : points.size() / dim;
  const std::size_t edges = closed || n == 0 ? n : n - 1;
  std::vector<double> d(edges, 1.0);
  if (kind == Parametrization::uniform) return d;
  for (std::size_t e = 0; e < edges; ++e) {
    const double* from = points.data() + e * dim;
    const double* to = points.data() + (e + 1) % n * dim;
    double length = 0;
    for (std::size_t c = 0; c < dim; ++c) length = std::hypot(length, to[c] - from[c]);
    d[e] = kind == Parametrization::chordal ? length : std::sqrt(length);
  }
  return d;
}

namespace {

constexpr double most_points = 2147483648.0;  // 2^31

std::optional<std::size_t> column(const PointSet& points, std::string_view name) {
  const auto found = std::find(points.columns.begin(), points.columns.end(), name);
  if (found == points.columns.end()) return std::nullopt;
  return static_cast<std::size_t>(found - points.columns.begin());
}

}  // namespace

KnotColumns knot_columns(const PointSet& points, const KnotOptions& options) {
  KnotColumns c{{}, column(points, "lambda"), column(points, "d"), column(points, "tag")};
  for (std::size_t i = 0; i < points.dim; ++i)
    if (i != c.lambda && i != c.d && i != c.tag) c.coordinates.push_back(i);
  if (c.coordinates.empty()) detail::fail_knots("the points have no coordinates");
  if (std::ldexp(static_cast<double>(points.size()), options.levels) > most_points)
    detail::fail_knots("too many points would come out: " + std::to_string(points.size()) + " points, " +
                       std::to_string(options.levels) + " levels");
  const bool given = options.parametrization == Parametrization::given;
  if (given && !c.d) detail::fail_knots("the points have no column d of knot intervals");
  if (given && options.reparametrize)
    detail::fail_knots("given knot intervals cannot be taken from the points at every level");
  return c;
}

PointSet refine_on_knots(const PointSet& points, KnotRule rule, const KnotOptions& options) {
  const KnotColumns columns = knot_columns(points, options);
  const auto& [coordinates, lambda, d, tag] = columns;
  const bool given = options.parametrization == Parametrization::given;
  KnotPolygon<double> p;
  p.dim = coordinates.size();
  p.closed = options.boundary == Boundary::closed;
  const std::size_t n = points.size();
  const auto value = [&](std::size_t j, std::size_t c) { return points.values[j * points.dim + c]; };
  for (std::size_t j = 0; j < n; ++j)
    for (const std::size_t c : coordinates) p.points.push_back(value(j, c));
  for (std::size_t e = 0; e < p.edges(); ++e) {
    p.lambda.push_back(lambda ? value(e, *lambda) : 0.5);
    if (given) p.d.push_back(value(e, *d));
  }
  if (!given) p.d = knot_intervals(p.points, p.dim, p.closed, options.parametrization);
  p.tagged = tags_of(points, columns, p);
  if (options.reparametrize) {
    validate(p, rule, options.boundary);
    for (int k = 0; k < options.levels; ++k) {
      if (k > 0) p.d = knot_intervals(p.points, p.dim, p.closed, options.parametrization);
      p = refine_knots(p, rule, options.boundary);
    }
  } else {
    p = refine_knots(p, rule, options.levels, options.boundary);
  }
  if (options.boundary == Boundary::given) {
    const long beyond = points_beyond_ends(rule);
    p = cropped(std::move(p), beyond, beyond);
  }

  PointSet out;
  out.columns = points.columns;
  out.dim = points.dim;
  out.values.reserve(p.size() * out.dim);
  for (std::size_t j = 0; j < p.size(); ++j) {
    const std::size_t e = std::min(j, p.edges() - 1);
    std::size_t next = 0;
    for (std::size_t c = 0; c < points.dim; ++c) {
      double x = 0;
      if (c == lambda)
        x = p.lambda[e];
      else if (c == d)
        x = p.d[e];
      else if (c == tag)
        x = p.tagged[j];
      else
        x = p.points[j * p.dim + next++];
      if (!std::isfinite(x)) detail::fail_knots("a refined number does not fit a double");
      out.values.push_back(x);
    }
  }
  return out;
}

}  // namespace twoscale::kernels
