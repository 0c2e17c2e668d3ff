// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/lowering/parametric_surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "twoscale/kernels/number_text.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::lowering {

namespace {

using kernels::Boundary;
using kernels::EndPoints;

constexpr long most_samples = 1000000;
constexpr long double_digits = 20;  // of a sample that becomes a double

EndPoints beyond(const SampledAxis& axis, const Scheme& scheme) {
  return axis.boundary == Boundary::given ? points_beyond_ends(scheme) : EndPoints{};
}

Direction direction(const Space& space, const SampledAxis& axis, unsigned levels) {
  Scheme scheme = make_scheme("interpolating:space=\"" + space.to_string() + "\"");
  Binding binding = bind(scheme, std::nullopt, std::nullopt, {});
  return {std::move(scheme), std::move(binding), levels, axis.boundary};
}

void check_axis(const ParametricSurface& surface, Axis which) {
  const SampledAxis& axis = which == Axis::u ? surface.u : surface.v;
  const char* name = which == Axis::u ? "u" : "v";
  if (axis.boundary == Boundary::linear)
    bad_input("the rule linear does not keep the functions of a formula; use given or space", name);
  if (axis.boundary == Boundary::closed) turns(surface.coordinates, which, axis.line, axis.count);
}

}  // namespace

kernels::PointGrid sampled(const ParametricSurface& surface, const Scheme& u, const Scheme& v, long digits) {
  const EndPoints above = beyond(surface.u, u), beside = beyond(surface.v, v);
  const long rows = surface.u.count + above.left + above.right;
  const long columns = surface.v.count + beside.left + beside.right;
  if (rows < 1 || columns < 1 || rows > most_samples || columns > most_samples || rows * columns > most_samples)
    bad_input("a grid of this size is not sampled", std::to_string(rows) + " x " + std::to_string(columns));
  kernels::PointGrid grid;
  grid.size = {static_cast<std::size_t>(rows), static_cast<std::size_t>(columns)};
  grid.points.columns = surface.columns;
  grid.points.dim = surface.coordinates.size();
  for (long i = -above.left; i < surface.u.count + above.right; ++i)
    for (long j = -beside.left; j < surface.v.count + beside.right; ++j)
      for (const ExponentialSum& coordinate : surface.coordinates) {
        const std::string text = coordinate.at(surface.u.line.at(i), surface.v.line.at(j)).decimal(digits);
        const auto value = kernels::parse_double(text);
        if (!value) bad_input("a sample does not fit a double", text.substr(0, 40));
        grid.points.tokens.push_back(text);
        grid.points.values.push_back(*value);
      }
  return grid;
}

std::vector<Summand> summands(const ParametricSurface& surface, SurfaceMethod method, unsigned u_levels,
                              unsigned v_levels, long digits) {
  check_axis(surface, Axis::u);
  check_axis(surface, Axis::v);
  const auto parts = method == SurfaceMethod::sum ? products(surface.coordinates)
                                                  : std::vector<std::vector<ExponentialSum>>{surface.coordinates};
  // Twice the digits: numbers that cannot be told from 0 are then smaller than what is printed as 0.
  const long sample_digits = digits == 0 ? double_digits : 2 * digits + double_digits;
  std::vector<Summand> list;
  for (const auto& part : parts) {
    const ParametricSurface share{surface.columns, part, surface.u, surface.v};
    Direction u = direction(least_space(part, Axis::u, surface.u.line), surface.u, u_levels);
    Direction v = direction(least_space(part, Axis::v, surface.v.line), surface.v, v_levels);
    kernels::PointGrid grid = sampled(share, u.scheme, v.scheme, sample_digits);
    list.push_back({std::move(grid), std::move(u), std::move(v), sample_digits});
  }
  return list;
}

double estimate_largest_deviation(const RefinedGrid& refined, const ParametricSurface& surface) {
  const kernels::PointSet& points = refined.grid.points;
  const auto number = [](const Rational& q) { return fmpq_get_d(q.raw()); };
  const GridParameters& at = refined.parameters;
  std::vector<double> low(points.dim), high(points.dim);
  double largest = 0;
  for (std::size_t j = 0; j < points.size(); ++j) {
    const auto row = static_cast<double>(j / refined.grid.size.columns);
    const auto column = static_cast<double>(j % refined.grid.size.columns);
    const double u = surface.u.line.estimate(number(at.u) + row * number(at.u_step));
    const double v = surface.v.line.estimate(number(at.v) + column * number(at.v_step));
    double square = 0;
    for (std::size_t c = 0; c < points.dim; ++c) {
      const double exact = surface.coordinates[c].estimate(u, v);
      low[c] = j == 0 ? exact : std::min(low[c], exact);
      high[c] = j == 0 ? exact : std::max(high[c], exact);
      const double d = points.values[j * points.dim + c] - exact;
      square += d * d;
    }
    largest = std::max(largest, square);
  }
  double diagonal = 0;
  for (std::size_t c = 0; c < points.dim; ++c) diagonal += (high[c] - low[c]) * (high[c] - low[c]);
  return std::sqrt(largest / diagonal);
}

}  // namespace twoscale::lowering
