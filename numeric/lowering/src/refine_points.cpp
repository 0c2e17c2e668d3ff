// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/lowering/refine_points.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "digits.hpp"
#include "rounding.hpp"
#include "twoscale/kernels/chord.hpp"
#include "twoscale/kernels/edge_refine.hpp"
#include "twoscale/kernels/number_text.hpp"
#include "twoscale/lowering/limit_stencil.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::lowering {

namespace {

void check_request(const Scheme& scheme, const kernels::PointSet& points, const RefineOptions& options) {
  check_output_size(static_cast<double>(points.size()) * std::pow(scheme.arity, options.levels), points.dim,
                    options.digits,
                    std::to_string(points.size()) + " points, " + std::to_string(options.levels) + " levels of arity " +
                        std::to_string(scheme.arity));
  if (options.boundary == kernels::Boundary::closed && points.size() < 3)
    bad_input("a closed polygon needs at least 3 points, not " + std::to_string(points.size()));
  if (options.boundary == kernels::Boundary::space && !scheme.space)
    bad_input("the scheme has no function space that could extend an open polygon", scheme.id);
}

constexpr std::size_t piece_values = std::size_t{1} << 20;  // of refined_rows

LowerOptions lowering_options(const RefineOptions& options, long digits) {
  return {options.levels, digits, options.boundary == kernels::Boundary::space, false};
}

void check_finite(std::span<const double> values) {
  for (const double x : values)
    if (!std::isfinite(x)) bad_input("a refined number does not fit a double", kernels::shortest(x));
}

// ---- A v^0 for each edge

constexpr const char* tension_column = "v0";
constexpr size_t most_tensions = 65536;

size_t column_of_tension(const kernels::PointSet& points) {
  return static_cast<size_t>(std::find(points.columns.begin(), points.columns.end(), tension_column) -
                             points.columns.begin());
}

// The coordinates, the distinct values of v0 and which of them each edge has.
struct EdgeTensions {
  kernels::PointSet points;
  std::vector<Rational> values;
  std::vector<std::string> texts;
  std::vector<size_t> edges;
};

EdgeTensions edge_tensions(const kernels::PointSet& in) {
  if (!has_edge_tension(in)) bad_input("the points have no column", tension_column);
  if (in.dim < 2) bad_input("the points have no coordinates beside the column", tension_column);
  EdgeTensions e;
  e.points = without_edge_tension(in);
  std::map<Rational, size_t> known;
  for (size_t i = column_of_tension(in); i < in.values.size(); i += in.dim) {
    const std::string token = i < in.tokens.size() ? in.tokens[i] : kernels::shortest(in.values[i]);
    const auto [at, added] = known.emplace(exact_decimal(token), e.values.size());
    if (added) {
      e.values.push_back(at->first);
      e.texts.push_back(token);
      if (e.values.size() > most_tensions)
        bad_input("too many different values of v0, at most " + std::to_string(most_tensions), token);
    }
    e.edges.push_back(at->second);
  }
  return e;
}

// v^{[K]} as it is printed and as a double.
std::pair<std::string, double> refined_tension(const LevelValue& v, const std::string& text, unsigned levels,
                                               long digits) {
  if (v.is_one()) return {"1", 1.0};
  if (levels == 0) return {text, *kernels::parse_double(text)};
  for (long bits = 128 + 4 * digits; bits <= 1L << 18; bits *= 2) {
    Ball x = v.offset(levels, bits);
    arb_add_ui(x.raw(), x.raw(), 1, bits);
    double value = 0;
    if (x.contains_zero() || !rounded_double(x, value)) continue;
    if (digits == 0) return {kernels::shortest(value), value};
    if (std::string decimal = rounded_decimal(x, digits); !decimal.empty()) return {std::move(decimal), value};
  }
  throw Error(Error::Kind::undecided, "cannot decide the last digit of the refined v0", text);
}

}  // namespace

kernels::PointSet refine_points(const Scheme& scheme, const Binding& binding, const kernels::PointSet& points,
                                const RefineOptions& options) {
  check_request(scheme, points, options);
  const int levels = static_cast<int>(options.levels);
  if (options.digits != 0)
    return with_digits({{&points}}, options.digits, [&](const auto& in, Precision precision) {
      return kernels::refine<Real>(
          in[0], points.dim, lower(scheme, binding, lowering_options(options, precision.digits)), levels,
          options.boundary,
          [&](const std::string& text, double) { return coefficient(text, precision.digits, precision.bits); });
    });
  kernels::PointSet out;
  out.columns = points.columns;
  out.dim = points.dim;
  kernels::Refiner<double> refiner(lower(scheme, binding, lowering_options(options, 0)));
  refiner.set_threads(options.threads);
  out.values = refiner.refine(points.values, points.dim, levels, options.boundary);
  check_finite(out.values);
  return out;
}

namespace {

// |c' x c''|/|c'|^3, signed in the plane.
double curvature_of(const double* first, const double* second, std::size_t dim) {
  const double x = dim == 3 ? first[1] * second[2] - first[2] * second[1] : 0;
  const double y = dim == 3 ? first[2] * second[0] - first[0] * second[2] : 0;
  const double z = first[0] * second[1] - first[1] * second[0];
  const double speed = dim == 3 ? std::hypot(first[0], first[1], first[2]) : std::hypot(first[0], first[1]);
  if (speed == 0) bad_input("the curvature is not defined where the derivative is", "0");
  return (dim == 3 ? std::hypot(x, y, z) : z) / speed / speed / speed;
}

// The refiners of one polygon whose results stand side by side.
struct Rows {
  std::vector<kernels::Refiner<double>> refiners;  // points, first and second derivatives
  std::vector<std::vector<double>> pieces;
  std::vector<double> joined;
  int levels = 0;
  bool derivative = false;
  bool curvature = false;

  void for_each(const kernels::PointSet& points, kernels::Boundary boundary, std::size_t count,
                const std::function<void(std::span<const double>)>& take) {
    const std::size_t dim = points.dim;
    const std::size_t at_once = std::min(count, std::max<std::size_t>(1, piece_values / dim));
    pieces.resize(refiners.size());
    for (std::size_t row = 0; row < count; row += at_once) {
      const std::size_t rows = std::min(at_once, count - row);
      for (std::size_t i = 0; i < refiners.size(); ++i) {
        pieces[i].resize(rows * dim);
        refiners[i].refine_rows(points.values, dim, levels, boundary, row, pieces[i]);
      }
      const std::vector<double>& all = refiners.size() == 1 ? pieces[0] : side_by_side(rows, dim);
      check_finite(all);
      take(all);
    }
  }

  const std::vector<double>& side_by_side(std::size_t rows, std::size_t dim) {
    joined.clear();
    for (std::size_t j = 0; j < rows; ++j) {
      const auto append = [&](const std::vector<double>& from) {
        joined.insert(joined.end(), from.begin() + static_cast<std::ptrdiff_t>(j * dim),
                      from.begin() + static_cast<std::ptrdiff_t>((j + 1) * dim));
      };
      append(pieces[0]);
      if (derivative) append(pieces[1]);
      if (curvature) joined.push_back(curvature_of(&pieces[1][j * dim], &pieces[2][j * dim], dim));
    }
    return joined;
  }
};

}  // namespace

RefinedRows refined_rows(const Scheme& scheme, const Binding& binding, const kernels::PointSet& points,
                         const RefineOptions& options) {
  if (options.digits != 0) bad_input("rows are refined in doubles", std::to_string(options.digits) + " digits");
  if ((options.derivative || options.curvature) && !options.limit)
    bad_input("derivatives and curvature are those of the", "limit");
  if (options.curvature && points.dim != 2 && points.dim != 3)
    bad_input("a curvature needs 2 or 3 columns, not " + std::to_string(points.dim), "curvature");
  check_request(scheme, points, options);
  LowerOptions lowering = lowering_options(options, 0);
  if (options.chord) lowering.levels += 24;  // the bound goes on beyond the last level
  const kernels::MaskTable table = lower(scheme, binding, lowering);
  const kernels::Refiner<double> plain(table);
  const auto rows = std::make_shared<Rows>();
  RefinedRows result;
  result.levels = options.levels;
  if (options.chord) {
    kernels::Refiner<double> refiner = plain;
    refiner.set_threads(options.threads);
    result.levels = static_cast<unsigned>(kernels::levels_for_chord(
        refiner, table, points.values, points.dim, static_cast<int>(options.levels), options.boundary, *options.chord));
  }
  rows->levels = static_cast<int>(result.levels);
  rows->derivative = options.derivative;
  rows->curvature = options.curvature;
  const unsigned orders = options.curvature ? 3 : options.derivative ? 2 : 1;
  rows->refiners.assign(orders, plain);
  for (auto& refiner : rows->refiners) refiner.set_threads(options.threads);
  if (options.limit) {
    const auto stencils = limit_stencils(scheme, binding, result.levels, orders);
    for (unsigned d = 0; d < orders; ++d) rows->refiners[d].set_finish(stencils[d]);
  }
  result.columns = points.columns;
  if (options.derivative)
    for (const std::string& name : points.columns) result.columns.push_back("d" + name);
  if (options.curvature) result.columns.emplace_back("curvature");
  for (std::size_t i = 0; i < result.columns.size(); ++i)
    if (std::find(result.columns.begin() + static_cast<std::ptrdiff_t>(i) + 1, result.columns.end(),
                  result.columns[i]) != result.columns.end())
      bad_input("two columns would have the name", result.columns[i]);
  result.count = rows->refiners[0].output(points.size(), rows->levels, options.boundary).count;
  result.for_each = [rows, &points, boundary = options.boundary, count = result.count](const auto& take) {
    rows->for_each(points, boundary, count, take);
  };
  return result;
}

bool has_edge_tension(const kernels::PointSet& points) { return column_of_tension(points) < points.columns.size(); }

kernels::PointSet without_edge_tension(const kernels::PointSet& points) {
  kernels::PointSet r = points;
  const size_t column = column_of_tension(points);
  if (column == points.columns.size()) return r;
  r.columns.erase(r.columns.begin() + static_cast<std::ptrdiff_t>(column));
  r.dim = points.dim - 1;
  r.values.clear();
  r.tokens.clear();
  for (size_t i = 0; i < points.values.size(); ++i) {
    if (i % points.dim == column) continue;
    r.values.push_back(points.values[i]);
    if (!points.tokens.empty()) r.tokens.push_back(points.tokens[i]);
  }
  return r;
}

kernels::PointSet refine_edges(const Scheme& scheme, const kernels::PointSet& points, const RefineOptions& options) {
  const std::vector<LevelVariable> variables = level_variables(scheme);
  if (variables.size() != 1 || scheme.parameters.size() != 1 || variables[0].value())
    bad_input("a column v0 needs a scheme with one free frequency and no other parameter", scheme.id);
  if (!is_interpolatory(scheme)) bad_input("a column v0 needs an interpolating scheme", scheme.id);
  const EdgeTensions e = edge_tensions(points);
  check_request(scheme, e.points, options);
  std::vector<Binding> bindings;
  for (size_t i = 0; i < e.values.size(); ++i) {
    Binding b;
    b.levels.emplace(variables[0].name, LevelValue::from_v0(ExactReal(e.values[i]), e.texts[i], scheme.arity));
    b.description.emplace_back(tension_column, e.texts[i]);
    bindings.push_back(std::move(b));
  }
  const int levels = static_cast<int>(options.levels);
  const auto tables = [&](long digits) {
    std::vector<kernels::MaskTable> list;
    for (const Binding& b : bindings) list.push_back(lower(scheme, b, lowering_options(options, digits)));
    return list;
  };
  kernels::PointSet fine;
  if (options.digits != 0) {
    fine = with_digits({{&e.points}}, options.digits, [&](const auto& in, Precision precision) {
      return kernels::EdgeRefiner<Real>(
                 tables(precision.digits),
                 [&](const std::string& text, double) { return coefficient(text, precision.digits, precision.bits); })
          .refine(in[0], e.points.dim, e.edges, levels, options.boundary);
    });
  } else {
    fine.values = kernels::EdgeRefiner<double>(tables(0)).refine(e.points.values, e.points.dim, e.edges, levels,
                                                                 options.boundary);
    check_finite(fine.values);
  }

  // The column v0 again: the edge from fine point i on comes from the edge floor(i/m^K).
  std::vector<std::pair<std::string, double>> refined;
  for (size_t i = 0; i < bindings.size(); ++i)
    refined.push_back(refined_tension(bindings[i].levels.begin()->second, e.texts[i], options.levels, options.digits));
  size_t children = 1;
  for (int k = 0; k < levels; ++k) children *= static_cast<size_t>(scheme.arity);
  const size_t beyond =
      options.boundary == kernels::Boundary::given
          ? static_cast<size_t>(
                kernels::points_beyond_ends(scheme.arity, symbol(scheme).lowest(), symbol(scheme).highest(), {}).left)
          : 0;
  kernels::PointSet out;
  out.columns = points.columns;
  out.dim = points.dim;
  const size_t count = fine.values.size() / e.points.dim;
  for (size_t i = 0; i < count; ++i) {
    const auto& [text, value] = refined[e.edges[i / children + beyond]];
    for (size_t c = 0, from = i * e.points.dim; c < out.dim; ++c) {
      const bool tension = c == column_of_tension(points);
      out.values.push_back(tension ? value : fine.values[from]);
      if (!fine.tokens.empty()) out.tokens.push_back(tension ? text : fine.tokens[from]);
      if (!tension) ++from;
    }
  }
  return out;
}

}  // namespace twoscale::lowering
