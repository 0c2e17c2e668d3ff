// SPDX-License-Identifier: GPL-3.0-or-later
// The NULIFS interpolant of a closed polygon, evaluated exactly; the polygons of the figures.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "twoscale/reports/nuli.hpp"
#include "twoscale/symbolic/ball.hpp"

namespace twoscale::reports::nuli {

namespace {

using Polygon = kernels::KnotPolygon<double>;

Rational exact(double x) {
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);  // |mantissa| < 1, 53 bits
  return Rational(static_cast<long>(std::ldexp(mantissa, 53))) * Rational(2).pow(exponent - 53);
}

double nearest(const Rational& x) { return arf_get_d(arb_midref(Ball(x, 80).raw()), ARF_RND_NEAR); }

}  // namespace

std::vector<double> interpolant(const Polygon& p, const FundamentalFamily& family, int samples) {
  if (!p.closed) throw std::logic_error("interpolant: a closed polygon is required");
  family.validate();
  const long n = static_cast<long>(p.size());
  const long reach = static_cast<long>(family.order) + std::max(static_cast<long>(family.mu), family.right()) + 4;
  const auto at = [n](long j) { return static_cast<std::size_t>(((j % n) + n) % n); };
  std::vector<double> curve;
  for (long e = 0; e < n; ++e) {
    std::vector<Rational> d, lambda;
    for (long k = e - reach; k <= e + reach; ++k) {
      d.push_back(exact(p.d[at(k)]));
      lambda.push_back(exact(p.lambda[at(k)]));
    }
    const Knots<Rational> t(-reach, d, lambda);
    for (long piece = 0; piece <= 1; ++piece) {
      const Rational from = t(piece), length = t(piece + 1) - from;
      if (length.is_zero()) continue;
      for (int s = 0; s < samples; ++s) {
        const std::vector<Rational> v = fundamental_values(t, family, from + length * Rational(s, samples), piece);
        for (std::size_t c = 0; c < p.dim; ++c) {
          Rational sum;
          for (std::size_t i = 0; i < v.size(); ++i)
            if (!v[i].is_zero())
              sum += v[i] * exact(p.points[at(e + t.first_vertex() + static_cast<long>(i)) * p.dim + c]);
          curve.push_back(nearest(sum));
        }
      }
    }
  }
  return curve;
}

Polygon hand() {
  Polygon p;
  p.dim = 2;
  p.points = {0, 0, 6, -0.4, 6.35, 0, 6.5, 3, 4.3, 3.3, 4.1, 3.5, 4.2, 6.2, 3.9, 6.5, 0.3, 6.1, -0.1, 5.6, 0.6, 3.2};
  p.lambda.assign(p.size(), 0.5);
  p.tagged.assign(p.size(), 0);
  return with_knots(std::move(p), kernels::Parametrization::centripetal);
}

Polygon with_edge_parameters(Polygon p, const std::vector<std::pair<std::size_t, double>>& lambda) {
  for (const auto& [edge, value] : lambda) p.lambda.at(edge) = value;
  p.tagged = kernels::default_tags(p);
  return p;
}

Polygon with_knots(Polygon p, kernels::Parametrization kind) {
  p.d = kernels::knot_intervals(p.points, p.dim, p.closed, kind);
  return p;
}

}  // namespace twoscale::reports::nuli
