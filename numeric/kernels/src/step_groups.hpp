// SPDX-License-Identifier: 0BSD
// The vectorised inner loop of one refinement step, and non-temporal copies; not installed.
#pragma once

#include <cstddef>

namespace twoscale::kernels::detail {

// Whole groups of rows: for q = 0..groups-1 and r = 0..arity-1
//   out[(q*arity + r)*out_stride + c] = sum_{s = begin[r]}^{begin[r+1]-1} weight[s] in[(q + offset[s])*in_stride + c],
// c = 0..width-1, every product rounded and every sum taken from the left; 0 for a phase without weights.
template <class Real>
struct Groups {
  const Real* weight;
  const std::ptrdiff_t* offset;
  const std::size_t* begin;
  std::size_t arity;
  std::size_t groups;
  std::size_t width;
  const Real* in;
  std::size_t in_stride;
  Real* out;
  std::size_t out_stride;
  // Past the caches: out is a multiple of 64 bytes, direct_stream(arity, width, ...) holds. A run of groups whose
  // output is no multiple of 64 bytes ends with ordinary stores.
  bool stream;
};

// Can rows of this kind be streamed by the loop itself?
constexpr bool direct_stream(std::size_t arity, std::size_t width, std::size_t in_stride, std::size_t out_stride) {
  return arity == 2 && width <= 4 && in_stride == width && out_stride == width;
}

void run_groups(const Groups<double>& g);
void run_groups(const Groups<float>& g);

// Several segments of a polygon side by side: a row of `in` is a row of every segment, number c of segment l at
// [c*segments + l] (two segments of two numbers: [l*2 + c]). They go through a step as one wider row, without any
// interleaving; run_groups_apart is a step that takes them apart again: rows of segment l to out[l], dense. Binary
// rules; g.width is that of a segment, g.in_stride of all; g.out and g.stream are not used.
//
// How many segments a polygon of doubles is best cut into on this machine; 1 leaves it as it is, 0: do not.
std::size_t best_segments(std::size_t width);
void run_groups_apart(const Groups<double>& g, double* const* out);

}  // namespace twoscale::kernels::detail
