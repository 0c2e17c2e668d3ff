// SPDX-License-Identifier: 0BSD
// The vectorised inner loop of one refinement step, and non-temporal copies; not installed.
#pragma once

#include <cstddef>

#include "twoscale/kernels/refine.hpp"

namespace twoscale::kernels::detail {

// Whole groups of rows: for q = 0..groups-1 and r = 0..arity-1
//   out[(q*arity + r)*out_stride + c] = sum_s weight[s] in[(q + offset[s])*in_stride + c],  s in phase r,
// c = 0..width-1, in the order of Phase, every product and every sum rounded.
template <class Real>
struct Groups {
  const Real* weight;
  const std::ptrdiff_t* offset;
  const Phase* phase;
  std::size_t arity;
  std::size_t groups;
  std::size_t width;
  const Real* in;
  std::size_t in_stride;
  Real* out;
  std::size_t out_stride;
};

void run_groups(const Groups<double>& g);
void run_groups(const Groups<float>& g);

// Segments of a polygon side by side: a row of `in` is a row of every segment (place_in_segments), a multiple of a
// register. They go through a step as one wider row, to `out`; or their rows are taken apart again, those of segment l
// to apart[l], dense; with `stream` past the caches, apart[l] then being multiples of 64 bytes, and `groups` of 16.
template <class Real>
struct SideBySide {
  const Real* weight;
  const std::ptrdiff_t* offset;
  const Phase* phase;
  std::size_t arity;  // 2 or 3
  std::size_t groups;
  std::size_t width;  // of one segment, at most 4
  const Real* in;
  Real* out;
  Real* const* apart;  // nullptr: to out
  bool stream;
};

void run_side_by_side(const SideBySide<double>& g);
void run_side_by_side(const SideBySide<float>& g);

// The last three steps at once, all binary, all copying their points and putting a new one, of `pairs` equal weights
// from both ends, in the middle of its stencil. Out comes what SideBySide would write apart; `in` is the row of the
// first point, `groups`, of eight rows each, even.
template <class Real>
struct ThreeSteps {
  const Real *first, *second, *third;  // the weights of the pairs, from the ends to the middle
  std::size_t pairs;                   // has_three_steps
  std::size_t groups;
  std::size_t width;
  const Real* in;
  Real* const* apart;
  bool stream;
};

// The same of wide rows, `width` a multiple of wide_columns: row j of the input begins at in + j*in_stride, row i of
// the output at out + i*out_stride; with `stream` a multiple of 64 bytes.
template <class Real>
struct ThreeWideSteps {
  const Real *first, *second, *third;
  std::size_t pairs;
  std::size_t groups;
  std::size_t width;
  const Real* in;
  std::size_t in_stride;
  Real* out;
  std::size_t out_stride;
  bool stream;
};
constexpr bool has_three_steps(std::size_t pairs) { return pairs >= 1 && pairs <= 4; }

void run_three_steps(const ThreeSteps<double>& g);
void run_three_steps(const ThreeSteps<float>& g);
void run_three_wide_steps(const ThreeWideSteps<double>& g);
void run_three_wide_steps(const ThreeWideSteps<float>& g);

// How many segments a polygon of such rows, of numbers of 8 or 4 bytes, is best cut into on this machine; 0: do not.
std::size_t best_segments(std::size_t bytes, std::size_t width);

}  // namespace twoscale::kernels::detail
