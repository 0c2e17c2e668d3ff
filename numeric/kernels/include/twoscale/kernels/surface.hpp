// SPDX-License-Identifier: 0BSD
// Tensor-product refinement: a grid of points, one scheme for each of its two directions.
//
// Index conventions
//
//   grid        rows x columns points of `dim` components, row-major: component c of point (i, j) is
//               grid[(i*columns + j)*dim + c].
//   u, v        u runs from row to row (index i), v along a row (index j): f_{ij} belongs to the parameters
//               u_i = (i + p_u)/m_u^k, v_j = (j + p_v)/m_v^k, each with the shift and the arity of its own scheme.
//   rule        with masks a of the u direction and b of the v direction
//               f^{k+1}_{ij} = sum_{h,l} a_{i - m_u h} b_{j - m_v l} f^k_{hl}.
//   result      refine() takes every row through all levels of v, then every column of the result through all levels of
//               u, each exactly as refine.hpp does with a polygon, its boundary rule included. The two directions act
//               on different indices, so the other order and the alternation level by level give the same numbers in
//               exact arithmetic; in floating point they may differ in the last bits (sums are grouped otherwise). The
//               numbers of levels may differ too.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "twoscale/kernels/refine.hpp"

namespace twoscale::kernels {

struct GridSize {
  std::size_t rows = 0;
  std::size_t columns = 0;
  friend bool operator==(const GridSize&, const GridSize&) = default;
};

/// How far one direction is refined, and what happens at its ends.
struct DirectionRun {
  int levels = 0;
  Boundary boundary = Boundary::closed;
};

/// Indices of the refined grid: its point (0, 0) has the indices (rows.first, columns.first).
struct GridRange {
  IndexRange rows;
  IndexRange columns;
  GridSize size() const { return {rows.count, columns.count}; }
};

/// Two schemes over T and the buffers that they need. Not for use by several threads at once (copy it).
template <class T>
class SurfaceRefiner {
 public:
  SurfaceRefiner(Refiner<T> u, Refiner<T> v) : u_(std::move(u)), v_(std::move(v)) {}

  /// As Refiner::set_threads.
  void set_threads(int threads) {
    u_.set_threads(threads);
    v_.set_threads(threads);
  }

  /// What refining a grid of this size gives. Throws Error (bad_input) as Refiner::output does, for either direction.
  GridRange output(GridSize size, DirectionRun u, DirectionRun v) const {
    return {u_.output(size.rows, u.levels, u.boundary), v_.output(size.columns, v.levels, v.boundary)};
  }

  /// Refines into `out`, which has output().size() points of `dim` components and does not overlap the input.
  /// Errors as output(); also sizes that do not fit. Cost: the rows of the input by the columns of the output, plus the
  /// output, times the numbers of weights.
  void refine(std::span<const std::type_identity_t<T>> grid, GridSize size, std::size_t dim, DirectionRun u,
              DirectionRun v, std::span<std::type_identity_t<T>> out) {
    const GridSize fine = checked(grid.size(), size, dim, u, v);
    detail::check_output(out.size(), fine.rows * fine.columns * dim);
    run(grid, size, fine, dim, u, v, out);
  }

  /// The same into a new vector.
  std::vector<T> refine(std::span<const std::type_identity_t<T>> grid, GridSize size, std::size_t dim, DirectionRun u,
                        DirectionRun v) {
    const GridSize fine = checked(grid.size(), size, dim, u, v);
    std::vector<T> out(fine.rows * fine.columns * dim, grid.front());
    run(grid, size, fine, dim, u, v, out);
    return out;
  }

 private:
  GridSize checked(std::size_t values, GridSize size, std::size_t dim, DirectionRun u, DirectionRun v) const {
    if (dim == 0 || size.rows == 0 || size.columns == 0 || values / dim / size.columns != size.rows ||
        values != size.rows * size.columns * dim) {
      detail::fail(std::to_string(values) + " numbers are not a grid of " + std::to_string(size.rows) + " x " +
                   std::to_string(size.columns) + " points of " + std::to_string(dim) + " components");
    }
    return output(size, u, v).size();
  }

  void run(std::span<const T> grid, GridSize size, GridSize fine, std::size_t dim, DirectionRun u, DirectionRun v,
           std::span<T> out) {
    const std::size_t in_row = size.columns * dim;
    const std::size_t out_row = fine.columns * dim;
    const std::size_t between = size.rows * out_row;
    if (between_.size() < between) between_.resize(between, grid.front());
    for (std::size_t i = 0; i < size.rows; ++i) {
      v_.refine(grid.subspan(i * in_row, in_row), dim, v.levels, v.boundary,
                std::span<T>(between_).subspan(i * out_row, out_row));
    }
    // A row is one point of a polygon in many dimensions: all columns at once.
    u_.refine(std::span<const T>(between_).first(between), out_row, u.levels, u.boundary, out);
  }

  Refiner<T> u_, v_;
  std::vector<T> between_;  // the coarse rows, refined along v
};

/// One-line door: doubles, with the doubles of the tables.
std::vector<double> refine_grid(std::span<const double> grid, GridSize size, std::size_t dim, const MaskTable& u_table,
                                DirectionRun u, const MaskTable& v_table, DirectionRun v);

}  // namespace twoscale::kernels
