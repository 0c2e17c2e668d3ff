// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/reports/curves.hpp"

#include <algorithm>
#include <cmath>

#include "twoscale/lowering/refine_grid.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::reports {

namespace {

kernels::MaskTable table_of(const Scheme& scheme, const lowering::Binding& binding, int levels,
                            kernels::Boundary boundary) {
  lowering::LowerOptions options;
  options.levels = static_cast<unsigned>(std::max(levels, 1));
  options.digits = 0;
  options.extension = boundary == kernels::Boundary::space;
  return lowering::lower(scheme, binding, options);
}

}  // namespace

Refined refine_points(const Scheme& scheme, const lowering::Binding& binding, std::span<const double> points,
                      std::size_t dim, int levels, kernels::Boundary boundary) {
  if (levels < 0 || levels > 24) bad_input("levels must be from 0 to 24", std::to_string(levels));
  const kernels::MaskTable table = table_of(scheme, binding, levels, boundary);
  kernels::Refiner<double> refiner(table);
  const kernels::IndexRange range = refiner.output(points.size() / dim, levels, boundary);
  Refined r;
  r.dim = dim;
  r.values = refiner.refine(points, dim, levels, boundary);
  const kernels::Shift p = kernels::parse_shift(table.shift);
  const double shift = static_cast<double>(p.num) / static_cast<double>(p.den);
  r.step = std::pow(static_cast<double>(table.arity), -levels);
  r.first = (static_cast<double>(range.first) + shift) * r.step;
  return r;
}

kernels::EndPoints points_beyond_ends(const Scheme& scheme) { return lowering::points_beyond_ends(scheme); }

Refined basic_limit_function(const Scheme& scheme, const lowering::Binding& binding, int levels) {
  const Laurent a = symbol(scheme);
  const kernels::EndPoints ends = points_beyond_ends(scheme);
  // Support of the limit in indices of level 0: [lowest, highest]/(m-1).
  const long m1 = scheme.arity - 1;
  const long left = kernels::floor_div(a.lowest(), m1) - 1;
  const long right = kernels::ceil_div(a.highest(), m1) + 1;
  const auto count = static_cast<std::size_t>(ends.left + ends.right + right - left + 1);
  std::vector<double> data(count, 0.0);
  data[static_cast<std::size_t>(ends.left - left)] = 1.0;
  const Refined values = refine_points(scheme, binding, data, 1, levels, kernels::Boundary::given);
  Refined r{{}, 2, values.first + static_cast<double>(left), values.step};
  for (std::size_t j = 0; j < values.size(); ++j) {
    r.values.push_back(r.parameter(j));
    r.values.push_back(values.values[j]);
  }
  return r;
}

double largest_deviation(const Refined& points, const std::function<void(double, double*)>& curve) {
  std::vector<double> low(points.dim), high(points.dim), at(points.dim);
  double largest = 0;
  for (std::size_t j = 0; j < points.size(); ++j) {
    curve(points.parameter(j), at.data());
    double square = 0;
    for (std::size_t c = 0; c < points.dim; ++c) {
      low[c] = j == 0 ? at[c] : std::min(low[c], at[c]);
      high[c] = j == 0 ? at[c] : std::max(high[c], at[c]);
      const double d = points.values[j * points.dim + c] - at[c];
      square += d * d;
    }
    largest = std::max(largest, square);
  }
  double diagonal = 0;
  for (std::size_t c = 0; c < points.dim; ++c) diagonal += (high[c] - low[c]) * (high[c] - low[c]);
  return std::sqrt(largest / diagonal);
}

double distance_to_polygon(const Refined& points, std::span<const double> polygon, bool closed) {
  const std::size_t dim = points.dim;
  const std::size_t n = polygon.size() / dim;
  const std::size_t edges = closed ? n : n - 1;
  std::vector<double> low(dim), high(dim);
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t c = 0; c < dim; ++c) {
      low[c] = j == 0 ? polygon[c] : std::min(low[c], polygon[j * dim + c]);
      high[c] = j == 0 ? polygon[c] : std::max(high[c], polygon[j * dim + c]);
    }
  double diagonal = 0;
  for (std::size_t c = 0; c < dim; ++c) diagonal += (high[c] - low[c]) * (high[c] - low[c]);
  double largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double* p = &points.values[i * dim];
    double nearest = INFINITY;
    for (std::size_t e = 0; e < edges; ++e) {
      const double* a = &polygon[e * dim];
      const double* b = &polygon[((e + 1) % n) * dim];
      double along = 0, length = 0;
      for (std::size_t c = 0; c < dim; ++c) {
        along += (p[c] - a[c]) * (b[c] - a[c]);
        length += (b[c] - a[c]) * (b[c] - a[c]);
      }
      const double s = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0.0;
      double square = 0;
      for (std::size_t c = 0; c < dim; ++c) {
        const double d = p[c] - (a[c] + s * (b[c] - a[c]));
        square += d * d;
      }
      nearest = std::min(nearest, square);
    }
    largest = std::max(largest, nearest);
  }
  return std::sqrt(largest / diagonal);
}

double total_turning(std::span<const double> q, bool closed) {
  const std::size_t n = q.size() / 2;
  double sum = 0;
  for (std::size_t j = 0; j < n; ++j) {
    if (!closed && (j == 0 || j + 1 == n)) continue;
    const std::size_t a = (j + n - 1) % n, b = (j + 1) % n;
    const double ux = q[2 * j] - q[2 * a], uy = q[2 * j + 1] - q[2 * a + 1];
    const double wx = q[2 * b] - q[2 * j], wy = q[2 * b + 1] - q[2 * j + 1];
    sum += std::abs(std::atan2(ux * wy - uy * wx, ux * wx + uy * wy));
  }
  return sum / (2 * std::acos(-1.0));
}

std::vector<double> curvature(std::span<const double> q, bool closed) {
  const std::size_t n = q.size() / 2;
  std::vector<double> k(n, NAN);
  for (std::size_t j = 0; j < n; ++j) {
    if (!closed && (j == 0 || j + 1 == n)) continue;
    const std::size_t a = (j + n - 1) % n, b = (j + 1) % n;
    const double ux = q[2 * j] - q[2 * a], uy = q[2 * j + 1] - q[2 * a + 1];
    const double wx = q[2 * b] - q[2 * j], wy = q[2 * b + 1] - q[2 * j + 1];
    const double product = std::hypot(ux, uy) * std::hypot(wx, wy) * std::hypot(ux + wx, uy + wy);
    if (product > 0) k[j] = 2 * (ux * wy - uy * wx) / product;
  }
  return k;
}

std::vector<Line> curvature_comb(std::span<const double> q, bool closed) {
  const std::vector<double> k = curvature(q, closed);
  double greatest = 0, low[2] = {q[0], q[1]}, high[2] = {q[0], q[1]};
  for (double x : k)
    if (std::isfinite(x)) greatest = std::max(greatest, std::abs(x));
  for (std::size_t i = 0; i < q.size(); ++i) {
    low[i % 2] = std::min(low[i % 2], q[i]);
    high[i % 2] = std::max(high[i % 2], q[i]);
  }
  const double scale = greatest > 0 ? 0.25 * std::hypot(high[0] - low[0], high[1] - low[1]) / greatest : 0;
  Line teeth, tips;
  teeth.style = Line::Style::segments;
  teeth.colour = tips.colour = 1;
  teeth.title = "curvature";
  const std::size_t n = k.size();
  const std::size_t stride = std::max<std::size_t>(1, n / 160);
  for (std::size_t j = 0; j < n; j += stride) {
    if (!std::isfinite(k[j])) continue;
    const std::size_t a = (j + n - 1) % n, b = (j + 1) % n;
    const double tx = q[2 * b] - q[2 * a], ty = q[2 * b + 1] - q[2 * a + 1];
    const double length = std::hypot(tx, ty);
    if (!(length > 0)) continue;
    const double x = q[2 * j], y = q[2 * j + 1];
    const double tip[2] = {x + scale * k[j] * ty / length, y - scale * k[j] * tx / length};
    teeth.values.insert(teeth.values.end(), {x, y, tip[0], tip[1]});
    tips.values.insert(tips.values.end(), {tip[0], tip[1]});
  }
  tips.closed = closed;
  if (teeth.values.empty()) return {};
  return {teeth, tips};
}

Line curve_line(std::vector<double> plane_points, bool closed, std::string title, int colour) {
  Line l;
  l.values = std::move(plane_points);
  l.closed = closed;
  l.title = std::move(title);
  l.colour = colour;
  return l;
}

Line polygon_line(std::vector<double> plane_points, bool closed, std::string title) {
  Line l = curve_line(std::move(plane_points), closed, std::move(title), 0);
  l.style = Line::Style::polygon;
  return l;
}

}  // namespace twoscale::reports
