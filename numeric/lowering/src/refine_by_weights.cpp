// SPDX-License-Identifier: GPL-3.0-or-later
// Refinement on knots by the weights of a scheme as they stand in it.
#include <algorithm>
#include <cmath>
#include <map>

#include "rounding.hpp"
#include "twoscale/lowering/refine_knots.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::lowering {

namespace {

using kernels::Boundary;

// The weights of the new point of an edge, by the ratios of the intervals around it to its own.
class Weights {
 public:
  explicit Weights(const Scheme& scheme) : odd_(scheme.phases[1]) {
    for (const auto& p : scheme.parameters) {
      if (p.rest || p.scope != Parameter::Scope::local || !scheme.pieces.empty())
        bad_input("points are refined by weights for schemes on knots without other parameters only", scheme.id);
      for (const long offset : p.offsets) {
        names_.push_back(local_name(p.name, offset));
        offsets_.push_back(offset);
      }
    }
  }

  long lowest() const { return odd_.lowest; }
  long highest() const { return odd_.lowest + static_cast<long>(odd_.blocks.size()) - 1; }
  const std::vector<long>& offsets() const { return offsets_; }

  const std::vector<double>& operator()(const std::vector<double>& ratios) {
    const auto [place, fresh] = known_.try_emplace(ratios);
    if (fresh) {
      std::vector<std::pair<std::string, Rational>> at;
      for (std::size_t i = 0; i < names_.size(); ++i) {
        Ball exact;
        arf_set_d(arb_midref(exact.raw()), ratios[i]);
        at.emplace_back(names_[i], to_rational(arb_midref(exact.raw())));
      }
      for (const auto& block : odd_.blocks) {
        const auto value = block[0].evaluate(at);
        if (!value) bad_input("the rule has a pole at these knot intervals", names_.front());
        place->second.push_back(rounded_double(*value));
      }
    }
    return place->second;
  }

 private:
  Stencil odd_;
  std::vector<std::string> names_;
  std::vector<long> offsets_;
  std::map<std::vector<double>, std::vector<double>> known_;
};

struct Polygon {
  std::size_t dim;
  bool closed;
  std::vector<double> points, d;
  long size() const { return static_cast<long>(points.size() / dim); }
  long edges() const { return closed ? size() : size() - 1; }
};

Polygon step(const Polygon& p, Weights& weights, Boundary boundary) {
  const long n = p.size(), edges = p.edges();
  const auto wrap = [](long j, long m) { return ((j % m) + m) % m; };
  // Beyond the ends of an open polygon: mirrored, as Boundary::linear says.
  const auto interval = [&](long e) {
    if (p.closed) return p.d[static_cast<std::size_t>(wrap(e, edges))];
    const long m = e < 0 ? -1 - e : e >= edges ? 2 * edges - 1 - e : e;
    return p.d[static_cast<std::size_t>(std::clamp(m, 0L, edges - 1))];
  };
  const auto point = [&](long j, std::size_t c) {
    const auto at = [&](long i) { return p.points[static_cast<std::size_t>(i) * p.dim + c]; };
    if (p.closed) return at(wrap(j, n));
    if (j < 0) return 2 * at(0) - at(std::min(-j, n - 1));
    if (j >= n) return 2 * at(n - 1) - at(std::max(2 * (n - 1) - j, 0L));
    return at(j);
  };
  const long skipped = boundary == Boundary::given ? std::max(-weights.lowest(), weights.highest() - 1) : 0;
  Polygon out{p.dim, p.closed, {}, {}};
  for (long j = skipped; j < n - skipped; ++j) {
    for (std::size_t c = 0; c < p.dim; ++c) out.points.push_back(point(j, c));
    if (j >= edges - skipped) break;
    const double own = interval(j);
    std::vector<double> ratios;
    for (const long offset : weights.offsets()) ratios.push_back(interval(j + offset) / own);
    const std::vector<double>& w = weights(ratios);
    for (std::size_t c = 0; c < p.dim; ++c) {
      double sum = 0;
      for (std::size_t h = 0; h < w.size(); ++h) sum += w[h] * point(j + weights.lowest() + static_cast<long>(h), c);
      out.points.push_back(sum);
    }
    out.d.insert(out.d.end(), 2, own / 2);
  }
  return out;
}

}  // namespace

kernels::PointSet refine_by_weights(const Scheme& scheme, const kernels::PointSet& points,
                                    const kernels::KnotOptions& options) {
  const kernels::KnotColumns columns = kernels::knot_columns(points, options);
  if (columns.lambda || columns.tag)
    bad_input("this scheme has no edge parameters, so no columns lambda, tag", scheme.id);
  if (options.boundary == Boundary::space)
    bad_input("the end rule space is there for lagrange4, nuli4 and nuli6", scheme.id);
  Weights weights(scheme);
  Polygon p{columns.coordinates.size(), options.boundary == Boundary::closed, {}, {}};
  for (std::size_t j = 0; j < points.size(); ++j)
    for (const std::size_t c : columns.coordinates) p.points.push_back(points.values[j * points.dim + c]);
  const long beyond = std::max(-weights.lowest(), weights.highest() - 1) * 2;
  const long least = p.closed ? 3 : options.boundary == Boundary::given ? 2 * beyond + 2 : 2;
  if (p.size() < least)
    bad_input("at least " + std::to_string(least) + " points are needed, not " + std::to_string(p.size()), scheme.id);
  const auto take = [&] { p.d = kernels::knot_intervals(p.points, p.dim, p.closed, options.parametrization); };
  if (options.parametrization == kernels::Parametrization::given)
    for (long e = 0; e < p.edges(); ++e)
      p.d.push_back(points.values[static_cast<std::size_t>(e) * points.dim + *columns.d]);
  else
    take();
  for (std::size_t e = 0; e < p.d.size(); ++e)
    if (!(p.d[e] > 0)) bad_input("a knot interval is not positive, in row " + std::to_string(e + 1), scheme.id);
  for (int k = 0; k < options.levels; ++k) {
    if (options.reparametrize && k > 0) take();
    p = step(p, weights, options.boundary);
  }
  kernels::PointSet out;
  out.columns = points.columns;
  out.dim = points.dim;
  const long cut = options.boundary == Boundary::given ? beyond : 0;
  for (long j = cut; j < p.size() - cut; ++j) {
    std::size_t next = 0;
    for (std::size_t c = 0; c < points.dim; ++c) {
      const double x = c == columns.d ? p.d[static_cast<std::size_t>(std::min(j, p.edges() - 1))]
                                      : p.points[static_cast<std::size_t>(j) * p.dim + next++];
      if (!std::isfinite(x)) bad_input("a refined number does not fit a double", scheme.id);
      out.values.push_back(x);
    }
  }
  return out;
}

}  // namespace twoscale::lowering
