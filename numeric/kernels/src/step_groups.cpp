// SPDX-License-Identifier: 0BSD
// The inner loop of a refinement step for every instruction set that Highway knows here, chosen at run time.
//
// A product is rounded before it is added, and a sum runs over the weights in their order: so the bits are those of the
// plain loop, whatever the width of the registers (the file must be compiled with -ffp-contract=off).
//
// Binary rows of 1 to 4 numbers: with t = q*width + c both phases are sums of rows of `in`, unit stride in t. A block
// of a few registers of each is summed, interleaved in registers, and stored once. Wider rows need no interleaving.
// What is left (arity 3 and more, short rows) goes through a strip of one phase at a time.
#include "step_groups.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "step_groups.cpp"
// Registers of unknown length cannot be interleaved at compile time; NEON serves there. SSSE3 machines without SSE4 are
// rare enough for the scalar loop.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | HWY_SSSE3)
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace twoscale::kernels::detail {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class Real>
HWY_INLINE Real one_sum(const Groups<Real>& g, std::size_t r, const Real* in) {
  if (g.begin[r] == g.begin[r + 1]) return Real(0);
  const auto at = [&](std::size_t s) { return in[g.offset[s] * static_cast<std::ptrdiff_t>(g.in_stride)]; };
  Real sum = g.weight[g.begin[r]] * at(g.begin[r]);
  for (std::size_t s = g.begin[r] + 1; s < g.begin[r + 1]; ++s) sum = sum + g.weight[s] * at(s);
  return sum;
}

// Groups from..to-1, number by number.
template <class Real>
HWY_NOINLINE void scalar_groups(const Groups<Real>& g, std::size_t from, std::size_t to) {
  for (std::size_t q = from; q < to; ++q)
    for (std::size_t r = 0; r < g.arity; ++r)
      for (std::size_t c = 0; c < g.width; ++c)
        g.out[(q * g.arity + r) * g.out_stride + c] = one_sum(g, r, g.in + q * g.in_stride + c);
}

#if HWY_TARGET == HWY_SCALAR

template <class Real>
void any_groups(const Groups<Real>& g) {
  scalar_groups(g, 0, g.groups);
}

std::size_t segments_of_doubles(std::size_t) { return 0; }
void doubles_apart(const Groups<double>&, double* const*) {}

#else

// N registers of phase r from in[t] on. kTaps > 0: that many weights, in `w`, with their rows in `row`.
template <std::size_t kTaps, std::size_t N, class D, class Real = hn::TFromD<D>, class V = hn::Vec<D>>
HWY_INLINE void sums(D d, const Groups<Real>& g, std::size_t r, const std::type_identity_t<V>* HWY_RESTRICT w,
                     const std::type_identity_t<Real>* const* row, std::size_t t, V* HWY_RESTRICT sum) {
  constexpr std::size_t lanes = hn::MaxLanes(D());
  if constexpr (kTaps > 0) {
#pragma GCC unroll 16
    for (std::size_t i = 0; i < N; ++i) sum[i] = hn::Mul(w[0], hn::LoadU(d, row[0] + t + i * lanes));
#pragma GCC unroll 16
    for (std::size_t s = 1; s < kTaps; ++s) {
#pragma GCC unroll 16
      for (std::size_t i = 0; i < N; ++i) sum[i] = hn::Add(sum[i], hn::Mul(w[s], hn::LoadU(d, row[s] + t + i * lanes)));
    }
  } else {
    const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(g.in_stride);
    const std::size_t end = g.begin[r + 1];
    std::size_t s = g.begin[r];
    if (s == end) {
#pragma GCC unroll 16
      for (std::size_t i = 0; i < N; ++i) sum[i] = hn::Zero(d);
      return;
    }
    const Real* from = g.in + t + g.offset[s] * stride;
    if (end - s == 1 && g.weight[s] == Real(1)) {
#pragma GCC unroll 16
      for (std::size_t i = 0; i < N; ++i) sum[i] = hn::LoadU(d, from + i * lanes);
      return;
    }
    V x = hn::Set(d, g.weight[s]);
#pragma GCC unroll 16
    for (std::size_t i = 0; i < N; ++i) sum[i] = hn::Mul(x, hn::LoadU(d, from + i * lanes));
    for (++s; s < end; ++s) {
      x = hn::Set(d, g.weight[s]);
      from = g.in + t + g.offset[s] * stride;
#pragma GCC unroll 16
      for (std::size_t i = 0; i < N; ++i) sum[i] = hn::Add(sum[i], hn::Mul(x, hn::LoadU(d, from + i * lanes)));
    }
  }
}

// Rows of kDim numbers of e and of o by turns.
template <std::size_t kDim, std::size_t N, class D, class V>
HWY_INLINE void interleave(D d, const V* HWY_RESTRICT e, const V* HWY_RESTRICT o, V* HWY_RESTRICT to) {
  constexpr std::size_t lanes = hn::MaxLanes(D());
  using Real = hn::TFromD<D>;
  if constexpr (kDim == 3 && lanes == 4) {
    static_assert(N == 3);
    using Index = hn::TFromD<hn::RebindToUnsigned<D>>;
    alignas(32) static constexpr Index one_two[4] = {1, 2, 1, 2};
    const auto pick = hn::SetTableIndices(d, one_two);
    const auto first = hn::FirstN(d, 1), three = hn::FirstN(d, 3);
    const V e01 = hn::ConcatLowerUpper(d, e[1], e[0]), e12 = hn::ConcatLowerUpper(d, e[2], e[1]);
    const V o01 = hn::ConcatLowerUpper(d, o[1], o[0]), o12 = hn::ConcatLowerUpper(d, o[2], o[1]);
    to[0] = hn::IfThenElse(three, e[0], hn::Reverse(d, o[0]));
    to[1] = hn::ConcatUpperLower(d, hn::TableLookupLanes(e01, pick), hn::TableLookupLanes(o[0], pick));
    to[2] = hn::IfThenElse(first, hn::Reverse(d, e01), o01);
    to[3] = hn::IfThenElse(three, e12, hn::Reverse(d, o12));
    to[4] = hn::ConcatUpperLower(d, hn::TableLookupLanes(e[2], pick), hn::TableLookupLanes(o12, pick));
    to[5] = hn::IfThenElse(first, hn::Reverse(d, e[2]), o[2]);
  } else if constexpr (kDim == 3) {
    static_assert(lanes == 2 && N == 3);
    to[0] = e[0];
    to[1] = hn::ConcatLowerLower(d, o[0], e[1]);
    to[2] = hn::ConcatLowerUpper(d, o[1], o[0]);
    to[3] = hn::ConcatLowerUpper(d, e[2], e[1]);
    to[4] = hn::ConcatUpperUpper(d, o[1], e[2]);
    to[5] = o[2];
  } else if constexpr (kDim >= lanes) {
    constexpr std::size_t run = kDim / lanes;
#pragma GCC unroll 16
    for (std::size_t i = 0; i < N; ++i) {
      to[(i / run) * 2 * run + i % run] = e[i];
      to[(i / run) * 2 * run + i % run + run] = o[i];
    }
  } else if constexpr (kDim * sizeof(Real) == 16) {
#pragma GCC unroll 16
    for (std::size_t i = 0; i < N; ++i) {
      to[2 * i] = hn::ConcatLowerLower(d, o[i], e[i]);
      to[2 * i + 1] = hn::ConcatUpperUpper(d, o[i], e[i]);
    }
  } else {
    // Single numbers, or pairs of floats moved as if they were doubles.
    const hn::Repartition<std::conditional_t<kDim == 2, double, Real>, D> u;
#pragma GCC unroll 16
    for (std::size_t i = 0; i < N; ++i) {
      const auto a = hn::BitCast(u, e[i]), b = hn::BitCast(u, o[i]);
      const auto low = hn::InterleaveLower(u, a, b), high = hn::InterleaveUpper(u, a, b);
      if constexpr (lanes * sizeof(Real) == 32) {  // they interleave within halves
        to[2 * i] = hn::BitCast(d, hn::ConcatLowerLower(u, high, low));
        to[2 * i + 1] = hn::BitCast(d, hn::ConcatUpperUpper(u, high, low));
      } else {
        to[2 * i] = hn::BitCast(d, low);
        to[2 * i + 1] = hn::BitCast(d, high);
      }
    }
  }
}

// kTaps > 0: the even phase copies one row, the odd one has kTaps weights.
template <std::size_t kDim, std::size_t kTaps, class Real>
void binary_groups(const Groups<Real>& g) {
  const hn::CappedTag<Real, kDim == 3 ? 4 : 32 / sizeof(Real)> d;
  using V = hn::Vec<decltype(d)>;
  constexpr std::size_t lanes = hn::MaxLanes(decltype(d)());
  constexpr std::size_t block = kDim % 3 == 0 ? 3 : 4;                                   // registers of each phase
  constexpr std::size_t least = kDim == 3 ? 3 : std::max<std::size_t>(1, kDim / lanes);  // so many are whole rows
  std::array<V, kTaps + 1> w;
  std::array<const Real*, kTaps + 1> row;
#pragma GCC unroll 16
  for (std::size_t s = 0; s < kTaps; ++s) {
    w[s] = hn::Set(d, g.weight[g.begin[1] + s]);
    row[s] = g.in + g.offset[g.begin[1] + s] * static_cast<std::ptrdiff_t>(kDim);
  }
  const Real* const even = kTaps > 0 ? g.in + g.offset[g.begin[0]] * static_cast<std::ptrdiff_t>(kDim) : nullptr;
  const bool stream = g.stream;
  const std::size_t count = g.groups * kDim;
  std::size_t t = 0;
  for (; t + block * lanes <= count; t += block * lanes) {
    V e[block], o[block], to[2 * block];
    if constexpr (kTaps > 0) {
#pragma GCC unroll 16
      for (std::size_t i = 0; i < block; ++i) e[i] = hn::LoadU(d, even + t + i * lanes);
    } else {
      sums<0, block>(d, g, 0, nullptr, nullptr, t, e);
    }
    sums<kTaps, block>(d, g, 1, w.data(), row.data(), t, o);
    interleave<kDim, block>(d, e, o, to);
    Real* const out = g.out + 2 * t;
    if (stream) {
#pragma GCC unroll 16
      for (std::size_t i = 0; i < 2 * block; ++i) hn::Stream(to[i], d, out + i * lanes);
    } else {
#pragma GCC unroll 16
      for (std::size_t i = 0; i < 2 * block; ++i) hn::StoreU(to[i], d, out + i * lanes);
    }
  }
  while (t < count) {
    if (t + least * lanes > count) {
      if (count < least * lanes) break;
      t = count - least * lanes;  // some again, the same bits
    }
    V e[least], o[least], to[2 * least];
    sums<0, least>(d, g, 0, nullptr, nullptr, t, e);
    sums<kTaps, least>(d, g, 1, w.data(), row.data(), t, o);
    interleave<kDim, least>(d, e, o, to);
#pragma GCC unroll 16
    for (std::size_t i = 0; i < 2 * least; ++i) hn::StoreU(to[i], d, g.out + 2 * t + i * lanes);
    t += least * lanes;
  }
  if (t < count) scalar_groups(g, t / kDim, g.groups);
}

// Calls with the number of weights of the odd phase, 0 in general; not 0: the even phase copies.
template <class Real, class F>
HWY_INLINE void by_taps(const Groups<Real>& g, F call) {
  if constexpr (sizeof(Real) == 8) {
    if (g.begin[1] - g.begin[0] == 1 && g.weight[g.begin[0]] == Real(1)) {
      switch (g.begin[2] - g.begin[1]) {
        case 2: return call(std::integral_constant<std::size_t, 2>());
        case 4: return call(std::integral_constant<std::size_t, 4>());
        case 6: return call(std::integral_constant<std::size_t, 6>());
        case 8: return call(std::integral_constant<std::size_t, 8>());
        case 16: return call(std::integral_constant<std::size_t, 16>());
        default: break;
      }
    }
  }
  call(std::integral_constant<std::size_t, 0>());
}

template <std::size_t kDim, class Real>
void binary_groups(const Groups<Real>& g) {
  by_taps(g, [&](auto taps) { binary_groups<kDim, decltype(taps)::value>(g); });
}

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3

// Four vectors as rows of a matrix, turned.
template <class D, class V>
HWY_INLINE void turn(D d, const V* HWY_RESTRICT from, V* HWY_RESTRICT to) {
  const V a = hn::InterleaveLower(d, from[0], from[1]), b = hn::InterleaveUpper(d, from[0], from[1]);
  const V c = hn::InterleaveLower(d, from[2], from[3]), e = hn::InterleaveUpper(d, from[2], from[3]);
  to[0] = hn::ConcatLowerLower(d, c, a);
  to[1] = hn::ConcatLowerLower(d, e, b);
  to[2] = hn::ConcatUpperUpper(d, c, a);
  to[3] = hn::ConcatUpperUpper(d, e, b);
}

// Rows of kWidth numbers in kSegments segments.
template <std::size_t kWidth, std::size_t kSegments, std::size_t kTaps>
void groups_apart(const Groups<double>& g, double* const* out) {
  const hn::CappedTag<double, 4> d;
  using V = hn::Vec<decltype(d)>;
  constexpr std::size_t row_values = kWidth * kSegments;
  constexpr std::size_t run = row_values / 4;            // registers of a row
  constexpr std::size_t block = run == 3 ? 6 : 4;        // registers of each phase at once
  constexpr std::size_t pieces = 2 * block / kSegments;  // registers of each segment
  std::array<V, kTaps + 1> w;
  std::array<const double*, kTaps + 1> row;
#pragma GCC unroll 16
  for (std::size_t s = 0; s < kTaps; ++s) {
    w[s] = hn::Set(d, g.weight[g.begin[1] + s]);
    row[s] = g.in + g.offset[g.begin[1] + s] * static_cast<std::ptrdiff_t>(row_values);
  }
  const double* const even =
      kTaps > 0 ? g.in + g.offset[g.begin[0]] * static_cast<std::ptrdiff_t>(row_values) : nullptr;
  std::array<double*, kSegments> to;
  for (std::size_t l = 0; l < kSegments; ++l) to[l] = out[l];
  const std::size_t count = g.groups * row_values;
  std::size_t t = 0;
  for (; t + block * 4 <= count; t += block * 4) {
    V e[block], o[block], both[2 * block], apart[2 * block];
    if constexpr (kTaps > 0) {
#pragma GCC unroll 16
      for (std::size_t i = 0; i < block; ++i) e[i] = hn::LoadU(d, even + t + i * 4);
    } else {
      sums<0, block>(d, g, 0, nullptr, nullptr, t, e);
    }
    sums<kTaps, block>(d, g, 1, w.data(), row.data(), t, o);
#pragma GCC unroll 16
    for (std::size_t i = 0; i < block; ++i) {
      both[(i / run) * 2 * run + i % run] = e[i];
      both[(i / run) * 2 * run + i % run + run] = o[i];
    }
    // apart[l*pieces + i]: register i of segment l.
    if constexpr (kSegments == 2) {
#pragma GCC unroll 16
      for (std::size_t i = 0; i < block; ++i) {
        apart[i] = hn::ConcatLowerLower(d, both[2 * i + 1], both[2 * i]);
        apart[pieces + i] = hn::ConcatUpperUpper(d, both[2 * i + 1], both[2 * i]);
      }
    } else {
#pragma GCC unroll 16
      for (std::size_t i = 0; i < 2 * block; i += 4) {
        V turned[4];
        turn(d, both + i, turned);
#pragma GCC unroll 16
        for (std::size_t l = 0; l < 4; ++l) apart[l * pieces + i / 4] = turned[l];
      }
    }
    const std::size_t at = 2 * t / kSegments;
#pragma GCC unroll 16
    for (std::size_t l = 0; l < kSegments; ++l) {
#pragma GCC unroll 16
      for (std::size_t i = 0; i < pieces; ++i) hn::StoreU(apart[l * pieces + i], d, to[l] + at + i * 4);
    }
  }
  for (std::size_t q = t / row_values; q < g.groups; ++q)
    for (std::size_t r = 0; r < 2; ++r)
      for (std::size_t l = 0; l < kSegments; ++l)
        for (std::size_t c = 0; c < kWidth; ++c)
          to[l][(2 * q + r) * kWidth + c] =
              one_sum(g, r, g.in + q * row_values + (kSegments == 2 ? l * kWidth + c : c * kSegments + l));
}

std::size_t segments_of_doubles(std::size_t width) {
  constexpr std::size_t best[] = {0, 4, 2, 4, 1};
  return width <= 4 ? best[width] : 0;
}

void doubles_apart(const Groups<double>& g, double* const* out) {
  by_taps(g, [&](auto taps) {
    constexpr std::size_t n = decltype(taps)::value;
    switch (g.width) {
      case 1: return groups_apart<1, 4, n>(g, out);
      case 2: return groups_apart<2, 2, n>(g, out);
      case 3: return groups_apart<3, 4, n>(g, out);
      default: break;
    }
    Groups<double> whole = g;
    whole.out = out[0];
    whole.out_stride = 4;
    binary_groups<4, n>(whole);
  });
}

#else

std::size_t segments_of_doubles(std::size_t) { return 0; }
void doubles_apart(const Groups<double>&, double* const*) {}

#endif

// Numbers t..t+count-1 of phase r, unit stride, to `to`.
template <class D, class Real>
HWY_INLINE void strip(D d, const Groups<Real>& g, std::size_t r, std::size_t t, std::size_t count, Real* to) {
  constexpr std::size_t lanes = hn::MaxLanes(D());
  hn::Vec<D> sum[4];
  std::size_t i = 0;
  for (; i + 4 * lanes <= count; i += 4 * lanes) {
    sums<0, 4>(d, g, r, nullptr, nullptr, t + i, sum);
#pragma GCC unroll 16
    for (std::size_t k = 0; k < 4; ++k) hn::StoreU(sum[k], d, to + i + k * lanes);
  }
  for (; i < count; i += lanes) {
    if (i + lanes > count) {
      if (count < lanes) break;
      i = count - lanes;  // some again, the same bits
    }
    sums<0, 1>(d, g, r, nullptr, nullptr, t + i, sum);
    hn::StoreU(sum[0], d, to + i);
  }
  for (; i < count; ++i) to[i] = one_sum(g, r, g.in + t + i);
}

template <class Real>
void any_groups(const Groups<Real>& g) {
  if (direct_stream(g.arity, g.width, g.in_stride, g.out_stride)) {
    switch (g.width) {
      case 1: return binary_groups<1>(g);
      case 2: return binary_groups<2>(g);
      case 3: return binary_groups<3>(g);
      default: return binary_groups<4>(g);
    }
  }
  if constexpr (sizeof(Real) == 8 && hn::MaxLanes(hn::CappedTag<Real, 4>()) == 4) {
    if (g.arity == 2 && g.width == 12 && g.in_stride == 12 && g.out_stride == 12) return binary_groups<12>(g);
  }
  const hn::CappedTag<Real, 32 / sizeof(Real)> d;
  if (g.width >= hn::MaxLanes(d)) {
    for (std::size_t q = 0; q < g.groups; ++q)
      for (std::size_t r = 0; r < g.arity; ++r)
        strip(d, g, r, q * g.in_stride, g.width, g.out + (q * g.arity + r) * g.out_stride);
    return;
  }
  if (g.in_stride != g.width) return scalar_groups(g, 0, g.groups);
  constexpr std::size_t room = 512;
  HWY_ALIGN std::array<Real, room> phase;
  const std::size_t rows = room / g.width;
  for (std::size_t q = 0; q < g.groups; q += rows) {
    const std::size_t now = std::min(rows, g.groups - q);
    for (std::size_t r = 0; r < g.arity; ++r) {
      strip(d, g, r, q * g.width, now * g.width, phase.data());
      Real* out = g.out + (q * g.arity + r) * g.out_stride;
      const auto scatter = [&](auto width) {
        for (std::size_t j = 0; j < now; ++j, out += g.arity * g.out_stride)
          std::memcpy(out, phase.data() + j * width, width * sizeof(Real));
      };
      switch (g.width) {
        case 1: scatter(std::integral_constant<std::size_t, 1>()); break;
        case 2: scatter(std::integral_constant<std::size_t, 2>()); break;
        case 3: scatter(std::integral_constant<std::size_t, 3>()); break;
        default: scatter(g.width); break;
      }
    }
  }
}

#endif

void groups_of_doubles(const Groups<double>& g) { any_groups(g); }
void groups_of_floats(const Groups<float>& g) { any_groups(g); }

// `bytes` a multiple of 64, `to` of 64.
void copy_lines(const void* from, std::size_t bytes, void* to) {
  const hn::CappedTag<std::uint64_t, 4> d;
  const auto* source = static_cast<const unsigned char*>(from);
  auto* target = static_cast<std::uint64_t*>(to);
  for (std::size_t i = 0; i < bytes; i += hn::Lanes(d) * 8) {
    HWY_ALIGN std::uint64_t line[4];
    std::memcpy(line, source + i, hn::Lanes(d) * 8);
    hn::Stream(hn::Load(d, line), d, target + i / 8);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace twoscale::kernels::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "twoscale/kernels/refine.hpp"

namespace twoscale::kernels::detail {

HWY_EXPORT(groups_of_doubles);
HWY_EXPORT(groups_of_floats);
HWY_EXPORT(copy_lines);
HWY_EXPORT(segments_of_doubles);
HWY_EXPORT(doubles_apart);

void run_groups(const Groups<double>& g) { HWY_DYNAMIC_DISPATCH(groups_of_doubles)(g); }
void run_groups(const Groups<float>& g) { HWY_DYNAMIC_DISPATCH(groups_of_floats)(g); }

std::size_t best_segments(std::size_t width) { return HWY_DYNAMIC_DISPATCH(segments_of_doubles)(width); }

void run_groups_apart(const Groups<double>& g, double* const* out) { HWY_DYNAMIC_DISPATCH(doubles_apart)(g, out); }

void stream_copy(const void* from, std::size_t bytes, void* to) {
  const auto* source = static_cast<const unsigned char*>(from);
  auto* target = static_cast<unsigned char*>(to);
  const std::size_t head = std::min(bytes, (64 - reinterpret_cast<std::uintptr_t>(target) % 64) % 64);
  const std::size_t lines = (bytes - head) / 64 * 64;
  std::memcpy(target, source, head);
  if (lines != 0) HWY_DYNAMIC_DISPATCH(copy_lines)(source + head, lines, target + head);
  std::memcpy(target + head + lines, source + head + lines, bytes - head - lines);
}

void drain() { hwy::FlushStream(); }

}  // namespace twoscale::kernels::detail
#endif
