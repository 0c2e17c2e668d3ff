// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/lowering/refine_grid.hpp"

#include <cmath>

#include "digits.hpp"
#include "twoscale/kernels/number_text.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::lowering {

namespace {

using kernels::Boundary;
using kernels::GridRange;
using kernels::SurfaceRefiner;

kernels::DirectionRun run_of(const Direction& d) { return {static_cast<int>(d.levels), d.boundary}; }

kernels::MaskTable table_of(const Direction& d, long digits) {
  return lower(d.scheme, d.binding, {d.levels, digits, d.boundary == Boundary::space, false});
}

SurfaceRefiner<double> double_refiner(const Summand& s) {
  return {kernels::Refiner<double>(table_of(s.u, 0)), kernels::Refiner<double>(table_of(s.v, 0))};
}

SurfaceRefiner<Real> digit_refiner(const Summand& s, Precision precision) {
  const auto convert = [&](const std::string& text, double) {
    return coefficient(text, precision.digits, precision.bits);
  };
  return {kernels::Refiner<Real>(table_of(s.u, precision.digits), convert),
          kernels::Refiner<Real>(table_of(s.v, precision.digits), convert)};
}

void check_direction(const Direction& d, const char* name, std::size_t points) {
  if (d.boundary == Boundary::closed && points < 3)
    bad_input(std::string("a closed direction ") + name + " needs at least 3 points, not " + std::to_string(points));
  if (d.boundary == Boundary::space && !d.scheme.space)
    bad_input("the scheme has no function space that could extend an open direction", d.scheme.id);
}

Rational step_of(const Direction& d) { return Rational(1) / Rational(d.scheme.arity).pow(static_cast<long>(d.levels)); }

GridParameters parameters_of(const Summand& s, const GridRange& range) {
  const Rational u_step = step_of(s.u), v_step = step_of(s.v);
  return {(Rational(range.rows.first) + s.u.scheme.shift) * u_step,
          (Rational(range.columns.first) + s.v.scheme.shift) * v_step, u_step, v_step};
}

template <class T>
std::vector<T> added(std::vector<T> sum, const std::vector<T>& term) {
  for (size_t i = 0; i < sum.size(); ++i) sum[i] = sum[i] + term[i];
  return sum;
}

}  // namespace

RefinedGrid refine_sum(const std::vector<Summand>& summands, long digits, int threads) {
  if (summands.empty()) bad_input("a sum of surfaces needs at least one summand");
  RefinedGrid result;
  std::vector<SurfaceRefiner<double>> refiners;
  for (size_t l = 0; l < summands.size(); ++l) {
    const Summand& s = summands[l];
    check_direction(s.u, "u", s.grid.size.rows);
    check_direction(s.v, "v", s.grid.size.columns);
    const double rows = static_cast<double>(s.grid.size.rows) * std::pow(s.u.scheme.arity, s.u.levels);
    const double columns = static_cast<double>(s.grid.size.columns) * std::pow(s.v.scheme.arity, s.v.levels);
    check_output_size(rows * columns, s.grid.points.dim, digits,
                      std::to_string(s.grid.size.rows) + " x " + std::to_string(s.grid.size.columns) + " points, " +
                          std::to_string(s.u.levels) + " and " + std::to_string(s.v.levels) + " levels");
    refiners.push_back(double_refiner(s));
    refiners.back().set_threads(threads);
    const GridRange range = refiners.back().output(s.grid.size, run_of(s.u), run_of(s.v));
    const GridParameters parameters = parameters_of(s, range);
    const kernels::Closings closings{s.u.boundary == Boundary::closed, s.v.boundary == Boundary::closed};
    const std::string which = "summand " + std::to_string(l + 1);
    if (l == 0) {
      result.grid.size = range.size();
      result.grid.closings = closings;
      result.parameters = parameters;
    } else if (!(range.size() == result.grid.size && parameters == result.parameters &&
                 closings == *result.grid.closings)) {
      bad_input("its refined points do not belong to the parameters of those of summand 1", which);
    } else if (s.grid.points.dim != summands[0].grid.points.dim) {
      bad_input("it has " + std::to_string(s.grid.points.dim) + " columns, summand 1 has " +
                    std::to_string(summands[0].grid.points.dim),
                which);
    }
  }
  kernels::PointSet& out = result.grid.points;
  if (digits != 0) {
    std::vector<DecimalSet> sets;
    for (const Summand& s : summands) sets.push_back({&s.grid.points, s.rounded_digits});
    out = with_digits(sets, digits, [&](const auto& in, Precision precision) {
      std::vector<Real> sum;
      for (size_t l = 0; l < summands.size(); ++l) {
        const Summand& s = summands[l];
        auto term = digit_refiner(s, precision).refine(in[l], s.grid.size, s.grid.points.dim, run_of(s.u), run_of(s.v));
        sum = l == 0 ? std::move(term) : added(std::move(sum), term);
      }
      return sum;
    });
    return result;
  }
  out.columns = summands[0].grid.points.columns;
  out.dim = summands[0].grid.points.dim;
  for (size_t l = 0; l < summands.size(); ++l) {
    const Summand& s = summands[l];
    auto term = refiners[l].refine(s.grid.points.values, s.grid.size, s.grid.points.dim, run_of(s.u), run_of(s.v));
    out.values = l == 0 ? std::move(term) : added(std::move(out.values), term);
  }
  for (const double x : out.values)
    if (!std::isfinite(x)) bad_input("a refined number does not fit a double", kernels::shortest(x));
  return result;
}

kernels::EndPoints points_beyond_ends(const Scheme& scheme) {
  const Laurent a = symbol(scheme);
  return kernels::points_beyond_ends(scheme.arity, a.lowest(), a.highest(),
                                     kernels::parse_shift(scheme.shift.to_string()));
}

RefinedGrid refine_grid(const kernels::PointGrid& grid, const Direction& u, const Direction& v, long digits,
                        int threads) {
  return refine_sum({Summand{grid, u, v, 0}}, digits, threads);
}

}  // namespace twoscale::lowering
