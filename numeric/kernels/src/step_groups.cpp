// SPDX-License-Identifier: 0BSD
// The inner loop of a refinement step for every instruction set that Highway knows here, chosen at run time.
//
// Every product and every sum is rounded, in the order of Phase: so the bits are those of the plain loop, whatever the
// width of the registers (the file must be compiled with -ffp-contract=off).
//
// Rows of several segments side by side are whole registers: a phase is a sum of registers that cross no line. The last
// level turns them: as many registers as there are segments become a register of every segment. Other rows go through
// strips, one phase at a time.
#include "step_groups.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "step_groups.cpp"
// Registers of unknown length cannot be turned at compile time; NEON serves there. SSSE3 machines without SSE4 are rare
// enough for the scalar loop.
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

// Groups from..to-1, number by number.
template <class Real>
HWY_NOINLINE void scalar_groups(const Groups<Real>& g, std::size_t from, std::size_t to) {
  const auto stride = static_cast<std::ptrdiff_t>(g.in_stride);
  for (std::size_t q = from; q < to; ++q)
    for (std::size_t r = 0; r < g.arity; ++r)
      for (std::size_t c = 0; c < g.width; ++c) {
        const Real* const in = g.in + q * g.in_stride + c;
        g.out[(q * g.arity + r) * g.out_stride + c] =
            sum_of_phase(g.phase[r], g.weight, [&](std::size_t s) { return in[g.offset[s] * stride]; });
      }
}

#if HWY_TARGET == HWY_SCALAR

std::size_t segments(std::size_t, std::size_t) { return 0; }
void doubles_side_by_side(const SideBySide<double>&) {}
void floats_side_by_side(const SideBySide<float>&) {}
void three_steps_of_doubles(const ThreeSteps<double>&) {}
void three_steps_of_floats(const ThreeSteps<float>&) {}
void three_wide_steps_of_doubles(const ThreeWideSteps<double>&) {}
void three_wide_steps_of_floats(const ThreeWideSteps<float>&) {}
void move_doubles(const double*, std::size_t, double*) {}
void move_floats(const float*, std::size_t, float*) {}

template <class Real>
void any_groups(const Groups<Real>& g) {
  scalar_groups(g, 0, g.groups);
}

#else

#if HWY_TARGET == HWY_AVX3
constexpr std::size_t register_bytes = 64;
#else
constexpr std::size_t register_bytes = 32;  // at most
#endif

// N registers of phase r from in[t] on; `stride` numbers from one point to the next.
template <std::size_t N, class D, class G, class Real = hn::TFromD<D>, class V = hn::Vec<D>>
HWY_INLINE void sums(D d, const G& g, std::size_t stride, std::size_t r, std::size_t t, V* HWY_RESTRICT sum) {
  constexpr std::size_t lanes = hn::MaxLanes(D());
  const Phase phase = g.phase[r];
  const auto row = [&](std::size_t s) { return g.in + t + g.offset[s] * static_cast<std::ptrdiff_t>(stride); };
  const std::size_t middle = phase.begin + phase.pairs;
#pragma GCC unroll 16
  for (std::size_t i = 0; i < N; ++i) sum[i] = hn::Zero(d);
  if (phase.begin == phase.end) return;
  std::size_t s = phase.begin;
  const V first = hn::Set(d, g.weight[s]);
  if (s < middle) {
    const Real *const a = row(s), *const b = row(phase.end - 1);
#pragma GCC unroll 16
    for (std::size_t i = 0; i < N; ++i)
      sum[i] = hn::Mul(first, hn::Add(hn::LoadU(d, a + i * lanes), hn::LoadU(d, b + i * lanes)));
  } else {
    const Real* const from = row(s);
#pragma GCC unroll 16
    for (std::size_t i = 0; i < N; ++i) sum[i] = hn::Mul(first, hn::LoadU(d, from + i * lanes));
  }
  for (++s; s < middle; ++s) {
    const V w = hn::Set(d, g.weight[s]);
    const Real *const a = row(s), *const b = row(phase.end - 1 - (s - phase.begin));
#pragma GCC unroll 16
    for (std::size_t i = 0; i < N; ++i)
      sum[i] = hn::Add(sum[i], hn::Mul(w, hn::Add(hn::LoadU(d, a + i * lanes), hn::LoadU(d, b + i * lanes))));
  }
  for (const std::size_t end = phase.end - phase.pairs; s < end; ++s) {
    const V w = hn::Set(d, g.weight[s]);
    const Real* const from = row(s);
#pragma GCC unroll 16
    for (std::size_t i = 0; i < N; ++i) sum[i] = hn::Add(sum[i], hn::Mul(w, hn::LoadU(d, from + i * lanes)));
  }
}

// The phases of a step as code: sum<N>(r, t, to) gives N registers of phase r.
template <class D>
struct AnyPhases {
  using Real = hn::TFromD<D>;
  const SideBySide<Real>& g;
  std::size_t stride;

  template <std::size_t N, class V>
  HWY_INLINE void sum(std::size_t r, std::size_t t, V* HWY_RESTRICT to) const {
    sums<N>(D(), g, stride, r, t, to);
  }
};

// Phase 0 copies, phase 1 has kPairs pairs of weights of consecutive rows and no other. Rows of kRegisters.
template <class D, std::size_t kPairs, std::size_t kRegisters>
struct Interpolating {
  using Real = hn::TFromD<D>;
  std::array<hn::Vec<D>, kPairs> weight;
  const Real *even, *odd;

  HWY_INLINE explicit Interpolating(const SideBySide<Real>& g) {
    const auto row = [&](std::size_t s) {
      return g.in + g.offset[s] * static_cast<std::ptrdiff_t>(kRegisters * hn::MaxLanes(D()));
    };
    even = row(g.phase[0].begin);
    odd = row(g.phase[1].begin);
#pragma GCC unroll 16
    for (std::size_t s = 0; s < kPairs; ++s) weight[s] = hn::Set(D(), g.weight[g.phase[1].begin + s]);
  }

  template <std::size_t N, class V>
  HWY_INLINE void sum(std::size_t r, std::size_t t, V* HWY_RESTRICT to) const {
    const D d;
    constexpr std::size_t lanes = hn::MaxLanes(D());
    const Real* const from = (r == 0 ? even : odd) + t;
    if (r == 0) {
#pragma GCC unroll 16
      for (std::size_t i = 0; i < N; ++i) to[i] = hn::LoadU(d, from + i * lanes);
      return;
    }
    // All N at once: a little faster, with 8 pairs, than a new_point after the other.
#pragma GCC unroll 16
    for (std::size_t s = 0; s < kPairs; ++s) {
#pragma GCC unroll 16
      for (std::size_t i = 0; i < N; ++i) {
        const V pair = hn::Add(hn::LoadU(d, from + (i + s * kRegisters) * lanes),
                               hn::LoadU(d, from + (i + (2 * kPairs - 1 - s) * kRegisters) * lanes));
        to[i] = s == 0 ? hn::Mul(weight[s], pair) : hn::Add(to[i], hn::Mul(weight[s], pair));
      }
    }
  }
};

#if HWY_TARGET == HWY_AVX3

// The parts of a and b, blocks of kRun numbers: those with bit kBit of their index 0 (kUpper: 1), those of b in the
// places where it is 1.
template <std::size_t kRun, std::size_t kBit, bool kUpper, class Real>
struct Choice {
  static constexpr std::size_t lanes = 64 / sizeof(Real);
  using Index = std::conditional_t<sizeof(Real) == 8, std::uint64_t, std::uint32_t>;
  alignas(64) std::array<Index, lanes> index{};
  constexpr Choice() {
    for (std::size_t i = 0; i < lanes; ++i) {
      const std::size_t block = i / kRun, bit = std::size_t{1} << kBit;
      const std::size_t from = ((block & ~bit) | (kUpper ? bit : 0)) * kRun + i % kRun;
      index[i] = static_cast<Index>(from + ((block & bit) != 0 ? lanes : 0));
    }
  }
};

template <std::size_t kRun, std::size_t kBit, bool kUpper>
HWY_INLINE hn::Vec512<double> choose(hn::Vec512<double> a, hn::Vec512<double> b) {
  static constexpr Choice<kRun, kBit, kUpper, double> choice;
  return hn::Vec512<double>{_mm512_permutex2var_pd(a.raw, _mm512_load_si512(choice.index.data()), b.raw)};
}
template <std::size_t kRun, std::size_t kBit, bool kUpper>
HWY_INLINE hn::Vec512<float> choose(hn::Vec512<float> a, hn::Vec512<float> b) {
  static constexpr Choice<kRun, kBit, kUpper, float> choice;
  return hn::Vec512<float>{_mm512_permutex2var_ps(a.raw, _mm512_load_si512(choice.index.data()), b.raw)};
}

// kSegments registers as a matrix of blocks, turned: bit by bit of the indices.
template <std::size_t kSegments, std::size_t kBit = 0, class D, class V>
HWY_INLINE void turn(D d, V* HWY_RESTRICT x) {
  constexpr std::size_t bit = std::size_t{1} << kBit, run = hn::MaxLanes(D()) / kSegments;
  if constexpr (bit < kSegments) {
#pragma GCC unroll 16
    for (std::size_t i = 0; i < kSegments; ++i) {
      if ((i & bit) != 0) continue;
      const V a = x[i], b = x[i + bit];
      x[i] = choose<run, kBit, false>(a, b);
      x[i + bit] = choose<run, kBit, true>(a, b);
    }
    turn<kSegments, kBit + 1>(d, x);
  }
}

#else

// Two neighbours of every 16 bytes of a and b in turn, as numbers of D: (a0, b0, ..), (a1, b1, ..).
template <class D, class V>
HWY_INLINE void interleave(D d, V a, V b, V& lower, V& upper) {
  lower = hn::InterleaveLower(d, a, b);
  upper = hn::InterleaveUpper(d, a, b);
}

// The halves of registers of 4 blocks, two by two.
template <class D, class V>
HWY_INLINE void join_halves(D d, V a, V b, V& lower, V& upper) {
  lower = hn::ConcatLowerLower(d, b, a);
  upper = hn::ConcatUpperUpper(d, b, a);
}

// kSegments registers as a matrix of blocks, turned. The interleaving is within 16 bytes.
template <std::size_t kSegments, class D, class V>
HWY_INLINE void turn(D d, V* HWY_RESTRICT x) {
  constexpr std::size_t bytes = hn::MaxLanes(D()) * sizeof(hn::TFromD<D>), block = bytes / kSegments;
  static_assert(kSegments == 1 || kSegments == 2 || block == 8 || block == sizeof(hn::TFromD<D>));
  if constexpr (kSegments == 2) {
    join_halves(d, x[0], x[1], x[0], x[1]);
  } else if constexpr (kSegments == 4 && block == 8) {
    const hn::Repartition<double, D> wide;
    using W = hn::Vec<decltype(wide)>;
    W a, b, c, e;
    interleave(wide, hn::BitCast(wide, x[0]), hn::BitCast(wide, x[1]), a, b);
    interleave(wide, hn::BitCast(wide, x[2]), hn::BitCast(wide, x[3]), c, e);
    join_halves(d, hn::BitCast(d, a), hn::BitCast(d, c), x[0], x[2]);
    join_halves(d, hn::BitCast(d, b), hn::BitCast(d, e), x[1], x[3]);
  } else if constexpr (kSegments == 4) {
    V a, b, c, e;
    interleave(d, x[0], x[1], a, b);
    interleave(d, x[2], x[3], c, e);
    join_halves(d, a, c, x[0], x[1]);
    join_halves(d, b, e, x[2], x[3]);
  } else if constexpr (kSegments == 8) {
    // Pairs of numbers are blocks of 8 bytes: of the segments 0, 1, 4, 5, and 2, 3, 6, 7.
    const hn::Repartition<double, D> wide;
    hn::Vec<decltype(wide)> pairs[2][4];
#pragma GCC unroll 4
    for (std::size_t i = 0; i < 4; ++i) {
      V lower, upper;
      interleave(d, x[2 * i], x[2 * i + 1], lower, upper);
      pairs[0][i] = hn::BitCast(wide, lower);
      pairs[1][i] = hn::BitCast(wide, upper);
    }
#pragma GCC unroll 2
    for (std::size_t half = 0; half < 2; ++half) {
      turn<4>(wide, pairs[half]);
#pragma GCC unroll 4
      for (std::size_t i = 0; i < 4; ++i) x[i + i / 2 * 2 + 2 * half] = hn::BitCast(d, pairs[half][i]);
    }
  }
}

#endif

template <class Real>
using Whole = hn::CappedTag<Real, register_bytes / sizeof(Real)>;

template <class Real, std::size_t kWidth>
inline constexpr std::size_t segments_for = kWidth == 3 ? hn::MaxLanes(Whole<Real>())
                                            : kWidth > hn::MaxLanes(Whole<Real>())
                                                ? 1
                                                : hn::MaxLanes(Whole<Real>()) / kWidth;

std::size_t segments(std::size_t bytes, std::size_t width) {
  constexpr std::size_t of_doubles[] = {0, segments_for<double, 1>, segments_for<double, 2>, segments_for<double, 3>,
                                        segments_for<double, 4>};
  constexpr std::size_t of_floats[] = {0, segments_for<float, 1>, segments_for<float, 2>, segments_for<float, 3>,
                                       segments_for<float, 4>};
  return width > 4 ? 0 : bytes == 8 ? of_doubles[width] : of_floats[width];
}

// Where rows of all segments go apart, in rounds of kRound registers. Past the caches registers smaller than a line go
// by a stage: lines of several places, begun and not yet filled, leave the processor in parts.
template <std::size_t kSegments, std::size_t kRound, bool kStream, class D>
class Apart {
  using Real = hn::TFromD<D>;
  static constexpr std::size_t lanes = hn::MaxLanes(D());
  static constexpr bool staged = kStream && kSegments > 1 && register_bytes < 64;
  // Of the stage, for every segment: whole lines, in all about 64 registers or a round.
  static constexpr std::size_t room = kRound / kSegments * lanes * (((64 + kRound - 1) / kRound + 3) / 4 * 4);

 public:
  HWY_INLINE explicit Apart(Real* const* apart) {
#pragma GCC unroll 16
    for (std::size_t l = 0; l < kSegments; ++l) to_[l] = apart[l];
  }

  // kCount registers, of a round; `at`: the numbers of every segment that were put before since `rest` was 0.
  template <std::size_t kCount, class V>
  HWY_INLINE void put(V* HWY_RESTRICT row, std::size_t at) {
    const D d;
#pragma GCC unroll 64
    for (std::size_t i = 0; i < kCount / kSegments; ++i) {
      turn<kSegments>(d, row + i * kSegments);
#pragma GCC unroll 16
      for (std::size_t l = 0; l < kSegments; ++l) {
        const V& v = row[i * kSegments + l];
        if constexpr (staged) {
          hn::Store(v, d, stage_ + l * room + at + i * lanes);
        } else if constexpr (kStream) {
          hn::Stream(v, d, to_[l] + at + i * lanes);
        } else {
          hn::StoreU(v, d, to_[l] + at + i * lanes);
        }
      }
    }
  }

  // After every round; what is left of `at`.
  HWY_INLINE std::size_t rest(std::size_t at) {
    if (!staged || at < room) return at;
    flush(at);
    return 0;
  }

  HWY_INLINE void flush(std::size_t at) {
    if constexpr (staged) {
      const D d;
#pragma GCC unroll 16
      for (std::size_t l = 0; l < kSegments; ++l) {
        Real* const to = to_[l];
        for (std::size_t line = 0; line < at; line += 64 / sizeof(Real)) {
#pragma GCC unroll 4
          for (std::size_t i = line; i < line + 64 / sizeof(Real); i += lanes)
            hn::Stream(hn::Load(d, stage_ + l * room + i), d, to + i);
        }
        to_[l] = to + at;
      }
    }
  }

 private:
  HWY_ALIGN Real stage_[staged ? kSegments * room : 1];
  Real* to_[kSegments];
};

// Where wide rows go, kRegisters of each: to places of their own.
template <std::size_t kRegisters, bool kStream, class D>
class RowsApart {
  using Real = hn::TFromD<D>;

 public:
  HWY_INLINE RowsApart(Real* to, std::size_t stride) : to_(to), stride_(stride) {}

  template <std::size_t kCount, class V>
  HWY_INLINE void put(const V* HWY_RESTRICT row, std::size_t at) {
    const D d;
    constexpr std::size_t lanes = hn::MaxLanes(D());
    Real* to = to_ + at / (kRegisters * lanes) * stride_;
#pragma GCC unroll 64
    for (std::size_t i = 0; i < kCount / kRegisters; ++i, to += stride_)
#pragma GCC unroll 8
      for (std::size_t c = 0; c < kRegisters; ++c) {
        if constexpr (kStream) {
          hn::Stream(row[i * kRegisters + c], d, to + c * lanes);
        } else {
          hn::StoreU(row[i * kRegisters + c], d, to + c * lanes);
        }
      }
  }
  HWY_INLINE std::size_t rest(std::size_t at) { return at; }
  HWY_INLINE void flush(std::size_t) {}

 private:
  Real* to_;
  std::size_t stride_;
};

// N rows of every phase, from number `at` of the input on.
template <std::size_t kArity, std::size_t kRegisters, std::size_t N, class V, class PhasesOf>
HWY_INLINE void block_of_rows(const PhasesOf& phases, std::size_t at, V* HWY_RESTRICT row) {
  V part[N * kRegisters];
#pragma GCC unroll 4
  for (std::size_t r = 0; r < kArity; ++r) {
    phases.template sum<N * kRegisters>(r, at, part);
#pragma GCC unroll 32
    for (std::size_t i = 0; i < N * kRegisters; ++i)
      row[(i / kRegisters * kArity + r) * kRegisters + i % kRegisters] = part[i];
  }
}

// N rows of every phase after another, apart.
template <std::size_t kArity, std::size_t kRegisters, std::size_t kSegments, std::size_t N, bool kStream, class D,
          class Real, class PhasesOf>
void rows_apart(D, const SideBySide<Real>& g, const PhasesOf phases) {
  constexpr std::size_t lanes = hn::MaxLanes(D()), count = kArity * N * kRegisters;
  Apart<kSegments, count, kStream, D> to(g.apart);
  std::size_t at = 0;
  for (std::size_t q = 0; q < g.groups; q += N) {
    hn::Vec<D> row[count];
    block_of_rows<kArity, kRegisters, N>(phases, q * kRegisters * lanes, row);
    to.template put<count>(row, at);
    at = to.rest(at + count / kSegments * lanes);
  }
  to.flush(at);
}

template <std::size_t kArity, std::size_t kRegisters, class D, class Real, class PhasesOf>
void rows_together(D d, const SideBySide<Real>& g, const PhasesOf phases) {
  constexpr std::size_t lanes = hn::MaxLanes(D()), N = kRegisters < 3 ? 4 / kRegisters : 1;
  const auto block = [&](auto rows, std::size_t q) HWY_ATTR {
    constexpr std::size_t n = decltype(rows)::value, count = kArity * n * kRegisters;
    hn::Vec<D> row[count];
    block_of_rows<kArity, kRegisters, n>(phases, q * kRegisters * lanes, row);
#pragma GCC unroll 64
    for (std::size_t i = 0; i < count; ++i) hn::StoreU(row[i], d, g.out + (q * kArity * kRegisters + i) * lanes);
  };
  std::size_t q = 0;
  for (; q + N <= g.groups; q += N) block(std::integral_constant<std::size_t, N>(), q);
  for (; q < g.groups; ++q) block(std::integral_constant<std::size_t, 1>(), q);
}

template <std::size_t kArity, std::size_t kRegisters, std::size_t kSegments, class D, class Real, class PhasesOf>
void rows_side_by_side(D d, const SideBySide<Real>& g, const PhasesOf& phases) {
  // Rows of a phase whose registers, all phases together, can be turned: a power of 2 up to 16.
  constexpr std::size_t N = [] {
    std::size_t n = kRegisters < 3 ? 4 / kRegisters : 1;
    while (kArity * n * kRegisters % kSegments != 0) n *= 2;
    return n;
  }();
  if (g.apart == nullptr) return rows_together<kArity, kRegisters>(d, g, phases);
  return g.stream ? rows_apart<kArity, kRegisters, kSegments, N, true>(d, g, phases)
                  : rows_apart<kArity, kRegisters, kSegments, N, false>(d, g, phases);
}

template <std::size_t kWidth, class Real>
void side_by_side(const SideBySide<Real>& g) {
  using D = Whole<Real>;
  constexpr std::size_t kSegments = segments_for<Real, kWidth>;
  if constexpr (kSegments > 0) {
    constexpr std::size_t stride = kWidth * kSegments;
    constexpr std::size_t kRegisters = stride / hn::MaxLanes(D());
    const auto run = [&](auto arity, auto phases) {
      rows_side_by_side<decltype(arity)::value, kRegisters, kSegments>(D(), g, phases);
    };
    constexpr std::integral_constant<std::size_t, 2> two;
    constexpr std::integral_constant<std::size_t, 3> three;
    if (g.arity == 3) return run(three, AnyPhases<D>{g, stride});
    const Phase& odd = g.phase[1];
    const std::size_t weights = odd.end - odd.begin;
    if (g.phase[0].copies && odd.pairs > 0 && weights == 2 * odd.pairs &&
        g.offset[odd.end - 1] - g.offset[odd.begin] + 1 == static_cast<std::ptrdiff_t>(weights)) {
      switch (odd.pairs) {
        case 1: return run(two, Interpolating<D, 1, kRegisters>(g));
        case 2: return run(two, Interpolating<D, 2, kRegisters>(g));
        case 3: return run(two, Interpolating<D, 3, kRegisters>(g));
        case 4: return run(two, Interpolating<D, 4, kRegisters>(g));
        case 8: return run(two, Interpolating<D, 8, kRegisters>(g));
        default: break;
      }
    }
    run(two, AnyPhases<D>{g, stride});
  }
}

// job(width as a constant), 1 to 4.
template <class Job>
void with_width(std::size_t width, const Job& job) {
  switch (width) {
    case 1: return job(std::integral_constant<std::size_t, 1>());
    case 2: return job(std::integral_constant<std::size_t, 2>());
    case 3: return job(std::integral_constant<std::size_t, 3>());
    default: return job(std::integral_constant<std::size_t, 4>());
  }
}

template <class Real>
void any_side_by_side(const SideBySide<Real>& g) {
  with_width(g.width, [&](auto width) { side_by_side<decltype(width)::value>(g); });
}

// The new point of kPairs pairs of rows, from.row(0) to from.row(2 kPairs - 1).
template <std::size_t kPairs, class V, class From>
HWY_INLINE V new_point(const V* HWY_RESTRICT weight, const From& from) {
  V sum = hn::Mul(weight[0], hn::Add(from.row(0), from.row(2 * kPairs - 1)));
#pragma GCC unroll 16
  for (std::size_t s = 1; s < kPairs; ++s)
    sum = hn::Add(sum, hn::Mul(weight[s], hn::Add(from.row(s), from.row(2 * kPairs - 1 - s))));
  return sum;
}

template <class D>
struct RowsInMemory {
  const hn::TFromD<D>* first;
  long stride;
  HWY_INLINE hn::Vec<D> row(std::size_t s) const { return hn::LoadU(D(), first + static_cast<long>(s) * stride); }
};

template <class V>
struct RowsInRegisters {
  const V* first;
  HWY_INLINE const V& row(std::size_t s) const { return first[s]; }
};

// Row i of a step, from the row of the point that is its row 0.
template <std::size_t kPairs, class D, class Real = hn::TFromD<D>>
HWY_INLINE hn::Vec<D> row_of_step(D d, const hn::Vec<D>* HWY_RESTRICT weight, const Real* point, long i, long stride) {
  const long j = i >= 0 ? i / 2 : -((1 - i) / 2);
  if (i == 2 * j) return hn::LoadU(d, point + j * stride);
  return new_point<kPairs>(weight, RowsInMemory<D>{point + (j + 1 - static_cast<long>(kPairs)) * stride, stride});
}

// Every round takes a point, makes two rows of it ahead of those that the second step needs, makes four rows between
// the last two steps and eight of these. The rows between go by in a window of registers, one for every register of a
// row.
template <std::size_t kPairs, std::size_t kRegisters, std::size_t kSegments, std::size_t kPoints, class D, class Steps,
          class Sink, class Real = hn::TFromD<D>>
HWY_INLINE void three_steps(D d, const Steps& g, const Real* begin, std::size_t in_stride, Sink to) {
  using V = hn::Vec<D>;
  constexpr std::size_t lanes = hn::MaxLanes(D()), stride = kRegisters * lanes;
  constexpr long row_stride = static_cast<long>(stride), pairs = static_cast<long>(kPairs);
  constexpr std::size_t kept = 2 * kPairs - 1;
  constexpr std::size_t points = kPoints;
  constexpr std::size_t rounds = points > 4 ? points / 4 : 1;  // of which they take
  // Round q needs the rows 2q - behind .. 2q + ahead of the first step.
  constexpr long behind = pairs + pairs / 2 - 1, ahead = pairs + (pairs + 2) / 2;
  constexpr std::size_t piece = 32;  // rounds
  V first[kPairs], second[kPairs], third[kPairs];
#pragma GCC unroll 16
  for (std::size_t s = 0; s < kPairs; ++s) {
    first[s] = hn::Set(d, g.first[s]);
    second[s] = hn::Set(d, g.second[s]);
    third[s] = hn::Set(d, g.third[s]);
  }
  std::size_t at = 0;
  HWY_ALIGN Real made[(2 * piece + static_cast<std::size_t>(behind + ahead)) * stride];
  const Real* const made_first = made + behind * row_stride;
  for (std::size_t from = 0; from < g.groups; from += piece) {
    const std::size_t groups = std::min(piece, g.groups - from);
    const Real* const in = begin + from * in_stride;
    const auto make = [&](std::size_t q, long i) HWY_ATTR {  // row 2q + i of the first step
#pragma GCC unroll 4
      for (std::size_t c = 0; c < kRegisters; ++c)
        hn::StoreU(row_of_step<kPairs>(d, first, in + q * in_stride + c * lanes, i, static_cast<long>(in_stride)), d,
                   made + (2 * q + static_cast<std::size_t>(i + behind)) * stride + c * lanes);
    };
#pragma GCC unroll 32
    for (long i = -behind; i < ahead - 1; ++i) make(0, i);
    V window[kRegisters][kept + 1];
#pragma GCC unroll 4
    for (std::size_t c = 0; c < kRegisters; ++c)
#pragma GCC unroll 16
      for (std::size_t i = 0; i < kept; ++i)
        window[c][i] =
            row_of_step<kPairs>(d, second, made_first + c * lanes, static_cast<long>(i) + 1 - pairs, row_stride);
    for (std::size_t q = 0; q < groups; q += rounds) {
#pragma GCC unroll 4
      for (long i = 0; i < 2 * static_cast<long>(rounds); ++i) make(q, ahead - 1 + i);
      const Real* const round = made_first + 2 * q * stride;
#pragma GCC unroll 8
      for (std::size_t i = 0; i < 4 * rounds; i += points) {
        V row[2 * points * kRegisters];
#pragma GCC unroll 4
        for (std::size_t c = 0; c < kRegisters; ++c)
#pragma GCC unroll 8
          for (std::size_t n = 0; n < points; ++n) {
            window[c][kept] =
                row_of_step<kPairs>(d, second, round + c * lanes, pairs + static_cast<long>(i + n), row_stride);
            row[2 * n * kRegisters + c] = window[c][kPairs - 1];
            row[(2 * n + 1) * kRegisters + c] = new_point<kPairs>(third, RowsInRegisters<V>{window[c]});
#pragma GCC unroll 16
            for (std::size_t k = 0; k < kept; ++k) window[c][k] = window[c][k + 1];
          }
        to.template put<2 * points * kRegisters>(row, at + 2 * i * stride / kSegments);
      }
      at = to.rest(at + 8 * rounds * stride / kSegments);
    }
  }
  to.flush(at);
}

// Points between the last two steps whose rows are made at once: until their registers can be turned, and straight past
// the caches all of a round, so that the stores come in bursts.
template <std::size_t kRegisters, std::size_t kSegments, bool kStream>
constexpr std::size_t points_at_once() {
  std::size_t n = kStream && (kSegments == 1 || register_bytes == 64) ? 4 : 1;
  while (2 * n * kRegisters % kSegments != 0) n *= 2;
  return n;
}

template <std::size_t kPairs, std::size_t kRegisters, std::size_t kSegments, bool kStream, class D,
          class Real = hn::TFromD<D>>
void three_steps_apart(D d, const ThreeSteps<Real>& g) {
  constexpr std::size_t points = points_at_once<kRegisters, kSegments, kStream>();
  constexpr std::size_t rounds = points > 4 ? points / 4 : 1;
  three_steps<kPairs, kRegisters, kSegments, points>(d, g, g.in, kRegisters * hn::MaxLanes(d),
                                                     Apart<kSegments, 8 * rounds * kRegisters, kStream, D>(g.apart));
}

template <class Job>
void with_pairs(std::size_t pairs, const Job& job) {
  switch (pairs) {
    case 1: return job(std::integral_constant<std::size_t, 1>());
    case 2: return job(std::integral_constant<std::size_t, 2>());
    case 3: return job(std::integral_constant<std::size_t, 3>());
    default: return job(std::integral_constant<std::size_t, 4>());
  }
}

template <std::size_t kWidth, class Real>
void three_steps_of_width(const ThreeSteps<Real>& g) {
  using D = Whole<Real>;
  constexpr std::size_t kSegments = segments_for<Real, kWidth>;
  if constexpr (kSegments > 0) {
    constexpr std::size_t kRegisters = kWidth * kSegments / hn::MaxLanes(D());
    const auto run = [&](auto pairs) {
      return g.stream ? three_steps_apart<decltype(pairs)::value, kRegisters, kSegments, true>(D(), g)
                      : three_steps_apart<decltype(pairs)::value, kRegisters, kSegments, false>(D(), g);
    };
    with_pairs(g.pairs, run);
  }
}

template <class Real>
void any_three_wide_steps(const ThreeWideSteps<Real>& g) {
  using D = Whole<Real>;
  constexpr std::size_t lanes = hn::MaxLanes(D());
  constexpr std::size_t kRegisters = std::max<std::size_t>(2, 64 / (lanes * sizeof(Real))),
                        columns = kRegisters * lanes;
  static_assert(wide_columns % columns == 0);
  const auto run = [&](auto pairs) {
    constexpr std::size_t kPairs = decltype(pairs)::value;
    const auto strip = [&](const Real* in, auto to) {
      three_steps<kPairs, kRegisters, 1, 1>(D(), g, in, g.in_stride, to);
    };
    for (std::size_t c = 0; c < g.width; c += columns) {
      if (g.stream)
        strip(g.in + c, RowsApart<kRegisters, true, D>(g.out + c, g.out_stride));
      else
        strip(g.in + c, RowsApart<kRegisters, false, D>(g.out + c, g.out_stride));
    }
  };
  with_pairs(g.pairs, run);
}

template <class Real>
void any_three_steps(const ThreeSteps<Real>& g) {
  with_width(g.width, [&](auto width) { three_steps_of_width<decltype(width)::value>(g); });
}

void three_steps_of_doubles(const ThreeSteps<double>& g) { any_three_steps(g); }
void three_steps_of_floats(const ThreeSteps<float>& g) { any_three_steps(g); }
void three_wide_steps_of_doubles(const ThreeWideSteps<double>& g) { any_three_wide_steps(g); }
void three_wide_steps_of_floats(const ThreeWideSteps<float>& g) { any_three_wide_steps(g); }

template <class Real>
void move_whole(const Real* from, std::size_t count, Real* to) {
  const Whole<Real> d;
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) hn::StoreU(hn::LoadU(d, from + i), d, to + i);
}

void move_doubles(const double* from, std::size_t count, double* to) { move_whole(from, count, to); }
void move_floats(const float* from, std::size_t count, float* to) { move_whole(from, count, to); }
void doubles_side_by_side(const SideBySide<double>& g) { any_side_by_side(g); }
void floats_side_by_side(const SideBySide<float>& g) { any_side_by_side(g); }

// Numbers t..t+count-1 of phase r, unit stride, to `to`.
template <class D, class Real>
HWY_INLINE void strip(D d, const Groups<Real>& g, std::size_t r, std::size_t t, std::size_t count, Real* to) {
  constexpr std::size_t lanes = hn::MaxLanes(D());
  hn::Vec<D> sum[4];
  std::size_t i = 0;
  for (; i + 4 * lanes <= count; i += 4 * lanes) {
    sums<4>(d, g, g.in_stride, r, t + i, sum);
#pragma GCC unroll 16
    for (std::size_t k = 0; k < 4; ++k) hn::StoreU(sum[k], d, to + i + k * lanes);
  }
  for (; i < count; i += lanes) {
    if (i + lanes > count) {
      if (count < lanes) break;
      i = count - lanes;  // some again, the same bits
    }
    sums<1>(d, g, g.in_stride, r, t + i, sum);
    hn::StoreU(sum[0], d, to + i);
  }
  for (; i < count; ++i) {
    const Real* const in = g.in + t + i;
    to[i] = sum_of_phase(g.phase[r], g.weight,
                         [&](std::size_t s) { return in[g.offset[s] * static_cast<std::ptrdiff_t>(g.in_stride)]; });
  }
}

template <class Real>
void any_groups(const Groups<Real>& g) {
  const hn::CappedTag<Real, register_bytes / sizeof(Real)> d;
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
  const hn::CappedTag<std::uint8_t, 64> d;
  constexpr std::size_t lanes = hn::MaxLanes(d);
  const auto* const source = static_cast<const std::uint8_t*>(from);
  auto* const target = static_cast<std::uint8_t*>(to);
  for (std::size_t line = 0; line < bytes; line += 64) {
#pragma GCC unroll 4
    for (std::size_t i = line; i < line + 64; i += lanes) hn::Stream(hn::LoadU(d, source + i), d, target + i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace twoscale::kernels::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace twoscale::kernels::detail {

HWY_EXPORT(groups_of_doubles);
HWY_EXPORT(groups_of_floats);
HWY_EXPORT(copy_lines);
HWY_EXPORT(segments);
HWY_EXPORT(move_doubles);
HWY_EXPORT(move_floats);
HWY_EXPORT(doubles_side_by_side);
HWY_EXPORT(floats_side_by_side);
HWY_EXPORT(three_steps_of_doubles);
HWY_EXPORT(three_steps_of_floats);
HWY_EXPORT(three_wide_steps_of_doubles);
HWY_EXPORT(three_wide_steps_of_floats);

void run_groups(const Groups<double>& g) { HWY_DYNAMIC_DISPATCH(groups_of_doubles)(g); }
void run_groups(const Groups<float>& g) { HWY_DYNAMIC_DISPATCH(groups_of_floats)(g); }

void run_side_by_side(const SideBySide<double>& g) { HWY_DYNAMIC_DISPATCH(doubles_side_by_side)(g); }
void run_side_by_side(const SideBySide<float>& g) { HWY_DYNAMIC_DISPATCH(floats_side_by_side)(g); }

void run_three_steps(const ThreeSteps<double>& g) { HWY_DYNAMIC_DISPATCH(three_steps_of_doubles)(g); }
void run_three_steps(const ThreeSteps<float>& g) { HWY_DYNAMIC_DISPATCH(three_steps_of_floats)(g); }

void run_three_wide_steps(const ThreeWideSteps<double>& g) { HWY_DYNAMIC_DISPATCH(three_wide_steps_of_doubles)(g); }
void run_three_wide_steps(const ThreeWideSteps<float>& g) { HWY_DYNAMIC_DISPATCH(three_wide_steps_of_floats)(g); }

std::size_t best_segments(std::size_t bytes, std::size_t width) { return HWY_DYNAMIC_DISPATCH(segments)(bytes, width); }

void stream_copy(const void* from, std::size_t bytes, void* to) {
  const auto* source = static_cast<const unsigned char*>(from);
  auto* target = static_cast<unsigned char*>(to);
  const std::size_t head = std::min(bytes, (64 - reinterpret_cast<std::uintptr_t>(target) % 64) % 64);
  const std::size_t lines = (bytes - head) / 64 * 64;
  std::memcpy(target, source, head);
  if (lines != 0) HWY_DYNAMIC_DISPATCH(copy_lines)(source + head, lines, target + head);
  std::memcpy(target + head + lines, source + head + lines, bytes - head - lines);
}

void move_registers(const double* from, std::size_t count, double* to) {
  HWY_DYNAMIC_DISPATCH(move_doubles)(from, count, to);
}
void move_registers(const float* from, std::size_t count, float* to) {
  HWY_DYNAMIC_DISPATCH(move_floats)(from, count, to);
}

void drain() { hwy::FlushStream(); }

}  // namespace twoscale::kernels::detail
#endif
