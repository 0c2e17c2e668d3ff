// SPDX-License-Identifier: 0BSD
// Refinement of polygons whose edges have different rules: one mask table for each kind of edge.
//
// Edge j runs from point j to point j+1 and is of the kind edges[j]; its m children are of the same kind. With the rule
// of the level k -> k+1 and the edge j = floor(i/m) of level k,
//
//   f^{k+1}_i = sum_j' a^{[k], kind of edge floor(i/m)}_{i-m*j'} f^k_j',
//
// so that a new point follows the rule of the edge that it subdivides, and a point that is kept (i = m*j) that of the
// edge which starts there: for interpolating rules all kinds keep it. Indices, parameters, boundaries and number types
// are those of refine.hpp; where all edges are of one kind, so are the bits. Boundary::space extends each end with the
// weights of the first or last edge's kind; with Boundary::given the points beyond the ends have edges too. Time and
// memory are linear in the points that come out.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "twoscale/kernels/refine.hpp"

namespace twoscale::kernels {

template <class T>
class EdgeRefiner {
 public:
  /// Coefficients of tables[kind] through convert(text, value). Throws Error (bad_input) unless there is a table and
  /// all have the same arity, shift, number of levels and of extension weights.
  template <class Convert>
  EdgeRefiner(std::span<const MaskTable> tables, Convert convert)
      : zero_(convert(std::string("0"), 0.0)),
        two_(convert(std::string("2"), 2.0)),
        minus_one_(convert(std::string("-1"), -1.0)) {
    if (tables.empty()) detail::fail("no mask table for the edges");
    arity_ = tables[0].arity;
    levels_ = tables[0].levels.size();
    shift_ = parse_shift(tables[0].shift);
    long lowest = 0, highest = 0;
    for (const MaskTable& t : tables) {
      validate(t);
      if (t.arity != arity_ || t.shift != tables[0].shift || t.levels.size() != levels_)
        detail::fail("the mask tables of the edges differ in arity, shift or number of levels");
      std::vector<LevelRule<T>> rules;
      for (const MaskRow& row : t.levels) {
        rules.push_back(level_rule<T>(arity_, row, convert));
        lowest = std::min(lowest, rules.back().mask.lowest);
        highest = std::max(highest, rules.back().mask.highest());
        if (row.extension.size() != tables[0].levels[0].extension.size())
          detail::fail("the mask tables of the edges differ in their extension weights");
        extension_ = row.extension.size();
      }
      rules_.push_back(std::move(rules));
    }
    lowest_ = lowest;
    highest_ = highest;
    ends_ = points_beyond_ends(arity_, lowest_, highest_, shift_);
  }

  /// Coefficients are the doubles of the tables, converted to T by static_cast.
  explicit EdgeRefiner(std::span<const MaskTable> tables)
      : EdgeRefiner(tables, [](const std::string&, double value) { return static_cast<T>(value); }) {}

  EndPoints ends() const { return ends_; }

  /// Indices of the points that refining n points gives; see Refiner::output.
  IndexRange output(std::size_t n, int levels, Boundary boundary) const {
    const detail::Window last = plan(n, levels, boundary).windows.back();
    return {last.first, last.computed()};
  }

  /// edges[j]: the kind (index of its table) of the edge that starts at point j, as many as points; the last one of an
  /// open polygon is not used. Errors as Refiner::refine; also a kind without a table.
  std::vector<T> refine(std::span<const T> points, std::size_t dim, std::span<const std::size_t> edges, int levels,
                        Boundary boundary) const {
    detail::check_sizes(points.size(), dim);
    const std::size_t n = points.size() / dim;
    if (edges.size() != n) detail::fail(std::to_string(edges.size()) + " edges for " + std::to_string(n) + " points");
    for (const std::size_t kind : edges)
      if (kind >= rules_.size()) detail::fail("no mask table for edges of kind " + std::to_string(kind));
    const detail::Plan plan = this->plan(n, levels, boundary);
    const detail::Window& first = plan.windows[0];
    if (levels == 0) {  // nothing to do but to drop the points beyond the ends
      const std::size_t skip = boundary == Boundary::given ? static_cast<std::size_t>(ends_.left) * dim : 0;
      const std::span<const T> kept = points.subspan(skip, first.computed() * dim);
      return {kept.begin(), kept.end()};
    }
    // Kind of the edge of level 0 with index j.
    const long last_edge = static_cast<long>(n) - (boundary == Boundary::closed ? 1 : 2);
    const auto kind_of = [&](long j) {
      return edges[static_cast<std::size_t>(std::clamp(j - first.first, 0L, std::max(0L, last_edge)))];
    };
    std::vector<T> in(first.stored() * dim, zero_);
    std::copy(points.begin(), points.end(), in.begin() + offset(first, dim));
    fill(in.data(), first, 0, dim, boundary, kind_of(first.first), kind_of(first.last));
    long children = 1;  // edges of level k+1 that come from one of level 0
    for (std::size_t k = 0; k < static_cast<std::size_t>(levels); ++k) {
      const detail::Window& w = plan.windows[k];
      const detail::Window& next = plan.windows[k + 1];
      children *= arity_;
      std::vector<T> out(next.stored() * dim, zero_);
      std::vector<detail::Step<T>> steps;
      for (const auto& rules : rules_) steps.emplace_back(rules[k].mask);
      for (long i = next.first; i <= next.last;) {
        const std::size_t kind = kind_of(floor_div(i, children));
        long end = (floor_div(i, children) + 1) * children;
        while (end <= next.last && kind_of(floor_div(end, children)) == kind) end += children;
        end = std::min(end, next.last + 1);
        steps[kind]({in.data(), w.stored_first, dim, i, static_cast<std::size_t>(end - i), dim,
                     out.data() + static_cast<std::size_t>(i - next.stored_first) * dim, dim});
        i = end;
      }
      if (k + 1 < static_cast<std::size_t>(levels))
        fill(out.data(), next, k + 1, dim, boundary, kind_of(floor_div(next.first, children)),
             kind_of(floor_div(next.last, children)));
      in = std::move(out);
    }
    return in;
  }

 private:
  detail::Plan plan(std::size_t n, int levels, Boundary boundary) const {
    if (levels < 0) detail::fail("levels: " + std::to_string(levels) + " is negative");
    if (static_cast<std::size_t>(levels) > levels_)
      detail::fail(std::to_string(levels) + " levels asked for, but the mask tables have " + std::to_string(levels_));
    std::vector<detail::LevelShape> shapes(static_cast<std::size_t>(levels), {arity_, lowest_, highest_, extension_});
    return detail::plan_windows(std::move(shapes), ends_, shift_, n, boundary);
  }

  void fill(T* stored, const detail::Window& w, std::size_t k, std::size_t dim, Boundary boundary, std::size_t left,
            std::size_t right) const {
    detail::fill_boundary(stored, w, dim, boundary, rules_[left][k].extension, rules_[right][k].extension, two_,
                          minus_one_);
  }

  static std::ptrdiff_t offset(const detail::Window& w, std::size_t dim) {
    return static_cast<std::ptrdiff_t>(static_cast<std::size_t>(w.first - w.stored_first) * dim);
  }

  int arity_ = 2;
  Shift shift_;
  std::size_t levels_ = 0;
  std::size_t extension_ = 0;
  long lowest_ = 0, highest_ = 0;
  EndPoints ends_;
  std::vector<std::vector<LevelRule<T>>> rules_;  // by kind and level
  T zero_, two_, minus_one_;
};

}  // namespace twoscale::kernels
