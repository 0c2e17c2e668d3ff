// SPDX-License-Identifier: 0BSD
// Index windows of the boundary rules, and the vectorised loop of one step.
#include "twoscale/kernels/refine.hpp"

#include <array>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <optional>

#if defined(__x86_64__) && defined(__GNUC__)
#define TWOSCALE_KERNELS_X86 1
#endif

namespace twoscale::kernels {
namespace {

// Bounds m^K * n and p * m^K well inside a long (parse_shift keeps the numerator of p below 2^20).
constexpr long max_points = 1L << 40;

std::optional<long> digits_to_long(std::string_view text) {
  long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || text.front() == '-' || error != std::errc() || end != text.data() + text.size()) return {};
  return value;
}

}  // namespace

Boundary parse_boundary(std::string_view text) {
  if (text == "closed") return Boundary::closed;
  if (text == "given") return Boundary::given;
  if (text == "linear") return Boundary::linear;
  if (text == "space") return Boundary::space;
  detail::fail("unknown boundary " + quoted(text) + " (closed, given, linear, space)");
}

Shift parse_shift(std::string_view text) {
  constexpr long limit = 1'000'000;
  const auto refuse = [&]() { detail::fail("not a shift (a fraction or decimal up to 10^6): " + quoted(text)); };
  std::string_view rest = text;
  const bool negative = !rest.empty() && rest.front() == '-';
  if (negative) rest.remove_prefix(1);
  Shift shift;
  if (const std::size_t slash = rest.find('/'); slash != std::string_view::npos) {
    const auto num = digits_to_long(rest.substr(0, slash));
    const auto den = digits_to_long(rest.substr(slash + 1));
    if (!num || !den || *den < 1 || *num > limit || *den > limit) refuse();
    shift = {*num, *den};
  } else if (const std::size_t point = rest.find('.'); point != std::string_view::npos) {
    const std::string_view decimals = rest.substr(point + 1);
    const auto num = digits_to_long(std::string(rest.substr(0, point)) + std::string(decimals));
    if (!num || point == 0 || decimals.empty() || decimals.size() > 6 || *num > limit) refuse();
    shift.num = *num;
    for (std::size_t i = 0; i < decimals.size(); ++i) shift.den *= 10;
  } else {
    const auto num = digits_to_long(rest);
    if (!num || *num > limit) refuse();
    shift.num = *num;
  }
  if (negative) shift.num = -shift.num;
  return shift;
}

EndPoints points_beyond_ends(int arity, long lowest, long highest, Shift p) {
  EndPoints ends;
  const long m = arity;
  long power = 1;
  for (int levels = 1; power <= max_points / m; ++levels) {
    power *= m;
    long first = ceil_div(p.num * (power - 1), p.den);  // of one point, whose parameter is p
    long last = floor_div(p.num * (power - 1), p.den);
    for (int k = 0; k < levels; ++k) {
      first = ceil_div(first - highest, m);
      last = floor_div(last - lowest, m);
    }
    ends.left = std::max(ends.left, -first);
    ends.right = std::max(ends.right, last);
  }
  return ends;
}

IndexRange computable(int arity, long lowest, long highest, IndexRange coarse) {
  const long m = arity;
  const long first = m * (coarse.first - 1) + highest + 1;
  const long last = m * (coarse.first + static_cast<long>(coarse.count)) + lowest - 1;
  return {first, last < first ? 0 : static_cast<std::size_t>(last - first + 1)};
}

std::vector<double> refine(std::span<const double> points, std::size_t dim, const MaskTable& table, int levels,
                           Boundary boundary) {
  return Refiner<double>(table).refine(points, dim, levels, boundary);
}

namespace detail {

void fail(const std::string& message) { throw Error(Error::Kind::bad_input, message); }

void check_mask(int arity, std::size_t coefficients) {
  if (arity < 2) fail("arity " + std::to_string(arity) + " is below 2");
  if (coefficients < static_cast<std::size_t>(arity)) {
    fail("a mask of arity " + std::to_string(arity) + " needs at least as many coefficients, not " +
         std::to_string(coefficients));
  }
}

void check_sizes(std::size_t values, std::size_t dim) {
  if (dim == 0 || values % dim != 0) {
    fail(std::to_string(values) + " numbers are not rows of " + std::to_string(dim) + " components");
  }
}

void check_output(std::size_t have, std::size_t need) {
  if (have != need) {
    fail("the output has room for " + std::to_string(have) + " numbers instead of " + std::to_string(need));
  }
}

namespace {

std::string boundary_name(Boundary boundary) {
  switch (boundary) {
    case Boundary::closed: return "a closed polygon";
    case Boundary::given: return "an open polygon with given points beyond its ends";
    case Boundary::linear: return "an open polygon with linear ends";
    case Boundary::space: return "an open polygon with ends from the space";
  }
  return "a polygon";
}

// The windows for n points, or nothing when n is too small at some level.
std::optional<std::vector<Window>> try_windows(int arity, const std::vector<LevelShape>& shapes, EndPoints ends,
                                               Shift p, long n, Boundary boundary) {
  const long m = arity;
  const std::size_t levels = shapes.size();
  std::vector<Window> w(levels + 1);
  if (boundary == Boundary::closed) {
    if (n < 3) return std::nullopt;
    long count = n;
    for (std::size_t k = 0; k <= levels; ++k, count *= m) {
      w[k] = {0, count - 1, 0, count - 1};
      if (k == levels) break;
      w[k].stored_first = std::min(0L, ceil_div(-shapes[k].highest, m));
      w[k].stored_last = std::max(count - 1, floor_div(m * count - 1 - shapes[k].lowest, m));
    }
    return w;
  }
  const long inner = boundary == Boundary::given ? n - ends.left - ends.right : n;  // N
  if (inner < 2) return std::nullopt;
  std::vector<long> first(levels + 1), last(levels + 1);  // inside [t_first, t_last]
  long power = 1;
  for (std::size_t k = 0; k <= levels; ++k, power *= m) {
    first[k] = ceil_div(p.num * (power - 1), p.den);
    last[k] = power * (inner - 1) + floor_div(p.num * (power - 1), p.den);
  }
  w[levels] = {first[levels], last[levels], first[levels], last[levels]};
  for (std::size_t k = levels; k-- > 0;) {
    const LevelShape& s = shapes[k];
    const long need_first = ceil_div(w[k + 1].first - s.highest, m);
    const long need_last = floor_div(w[k + 1].last - s.lowest, m);
    if (boundary == Boundary::given) {
      w[k] = {need_first, need_last, need_first, need_last};
      continue;
    }
    w[k] = {first[k], last[k], std::min(first[k], need_first), std::max(last[k], need_last)};
    const long beyond = std::max(w[k].first - w[k].stored_first, w[k].stored_last - w[k].last);
    const long have = last[k] - first[k] + 1;
    if (boundary == Boundary::linear && have < beyond + 1) return std::nullopt;
    if (boundary == Boundary::space && beyond > 0) {
      if (s.extension == 0) {
        fail("the mask table has no extension weights for level " + std::to_string(k) + " (open polygon, space)");
      }
      if (have < static_cast<long>(s.extension)) return std::nullopt;
    }
  }
  if (boundary == Boundary::given && levels > 0) {
    w[0] = {-ends.left, inner - 1 + ends.right, -ends.left, inner - 1 + ends.right};
  }
  return w;
}

}  // namespace

Plan plan_windows(int arity, std::vector<LevelShape> shapes, EndPoints ends, Shift p, std::size_t n,
                  Boundary boundary) {
  long power = 1;
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    if (power > max_points / arity)
      power = max_points;
    else
      power *= arity;
  }
  if (n > static_cast<std::size_t>(max_points) || power > max_points / std::max(1L, static_cast<long>(n))) {
    fail(std::to_string(n) + " points refined " + std::to_string(shapes.size()) + " times are too many");
  }
  const long points = static_cast<long>(n);
  if (auto windows = try_windows(arity, shapes, ends, p, points, boundary)) {
    return {std::move(shapes), std::move(*windows)};
  }
  long needed = points + 1;
  // A number that suffices exists: each condition compares a constant with a count that grows with n.
  while (!try_windows(arity, shapes, ends, p, needed, boundary)) ++needed;
  fail(boundary_name(boundary) + " needs at least " + std::to_string(needed) + " points here, not " +
       std::to_string(n) +
       (boundary == Boundary::given
            ? " (" + std::to_string(ends.left) + " before and " + std::to_string(ends.right) + " after the curve)"
            : std::string()));
}

void tile_windows(int arity, const Plan& plan, Boundary boundary, std::size_t base, long first, long last,
                  std::vector<Window>& windows) {
  const std::size_t levels = plan.shapes.size();
  windows.resize(levels + 1);
  windows[levels] = {first, last, first, last};
  for (std::size_t k = levels; k-- > base;) {
    const LevelShape& shape = plan.shapes[k];
    const long low = ceil_div(windows[k + 1].first - shape.highest, arity);
    const long high = floor_div(windows[k + 1].last - shape.lowest, arity);
    Window w{low, high, low, high};
    if (boundary == Boundary::linear || boundary == Boundary::space) {
      // Points beyond the polygon of this level are extended from its first or last points, which must be there.
      const Window& level = plan.windows[k];
      const auto sources = [&](long beyond) { return std::max(beyond, static_cast<long>(shape.extension) - 1); };
      w.first = std::clamp(low, level.first, level.last);
      w.last = std::clamp(high, level.first, level.last);
      if (low < level.first) w.last = std::max(w.last, std::min(level.last, level.first + sources(level.first - low)));
      if (high > level.last)
        w.first = std::min(w.first, std::max(level.first, level.last - sources(high - level.last)));
      w.stored_first = std::min(low, w.first);
      w.stored_last = std::max(high, w.last);
    }
    windows[k] = w;
  }
}

void stream(const void* from, std::size_t bytes, void* to) {
#ifdef TWOSCALE_KERNELS_X86
  typedef double Two __attribute__((vector_size(16)));
  const auto* source = static_cast<const char*>(from);
  auto* target = static_cast<char*>(to);
  const std::size_t head = std::min(bytes, (16 - reinterpret_cast<std::uintptr_t>(target) % 16) % 16);
  std::memcpy(target, source, head);
  std::size_t at = head;
  for (; at + 16 <= bytes; at += 16) {
    Two two;
    std::memcpy(&two, source + at, sizeof two);
#ifdef __clang__
    __builtin_nontemporal_store(two, reinterpret_cast<Two*>(target + at));
#else
    __builtin_ia32_movntpd(reinterpret_cast<double*>(target + at), two);
#endif
  }
  std::memcpy(target + at, source + at, bytes - at);
  __builtin_ia32_sfence();
#else
  std::memcpy(to, from, bytes);
#endif
}

// One step of floating-point rows. With t = q*dim + c the phase r of the rule is
//   phase_r[t] = sum_s a_{ms+r} in[t - s*dim],
// unit stride for any dim. A strip of each phase is computed in turn, then the phases are interleaved into the output.
namespace {

constexpr std::size_t strip_values = 512;  // numbers of one phase in a strip

template <class Real>
using Tap = typename VectorStep<Real>::Tap;

template <class Real>
using Phases = std::vector<std::vector<Tap<Real>>>;

// A few numbers side by side; the compiler splits them when the machine's registers are shorter.
template <class Real>
struct Pack {
  static constexpr std::size_t size = 32 / sizeof(Real);
  typedef Real Type __attribute__((vector_size(32)));
};

// out[t] (+)= w_0 x_0[t] + ... + w_{N-1} x_{N-1}[t], summed from the left.
template <int N, bool first, class Real>
[[gnu::always_inline]] inline void sum_taps(const typename VectorStep<Real>::Tap* taps, const Real* in,
                                            std::ptrdiff_t base, std::ptrdiff_t dim, std::size_t count,
                                            Real* __restrict out) {
  using Vector = typename Pack<Real>::Type;
  constexpr std::size_t width = Pack<Real>::size;
  std::array<const Real*, N> from;
  std::array<Real, N> w;
  for (std::size_t s = 0; s < N; ++s) {
    from[s] = in + (base + taps[s].offset * dim);
    w[s] = taps[s].weight;
  }
  std::size_t t = 0;
  for (; t + width <= count; t += width) {
    Vector x, sum;
    std::memcpy(&x, from[0] + t, sizeof x);
    if constexpr (first) {
      sum = w[0] * x;
    } else {
      std::memcpy(&sum, out + t, sizeof sum);
      sum = sum + w[0] * x;
    }
#pragma GCC unroll 8
    for (std::size_t s = 1; s < N; ++s) {
      std::memcpy(&x, from[s] + t, sizeof x);
      sum = sum + w[s] * x;
    }
    std::memcpy(out + t, &sum, sizeof sum);
  }
  for (; t < count; ++t) {
    Real sum = first ? w[0] * from[0][t] : out[t] + w[0] * from[0][t];
    for (std::size_t s = 1; s < N; ++s) sum = sum + w[s] * from[s][t];
    out[t] = sum;
  }
}

template <bool first, class Real>
[[gnu::always_inline]] inline void sum_up_to_8(const typename VectorStep<Real>::Tap* taps, std::size_t n,
                                               const Real* in, std::ptrdiff_t base, std::ptrdiff_t dim,
                                               std::size_t count, Real* __restrict out) {
  switch (n) {
    case 1: sum_taps<1, first>(taps, in, base, dim, count, out); break;
    case 2: sum_taps<2, first>(taps, in, base, dim, count, out); break;
    case 3: sum_taps<3, first>(taps, in, base, dim, count, out); break;
    case 4: sum_taps<4, first>(taps, in, base, dim, count, out); break;
    case 5: sum_taps<5, first>(taps, in, base, dim, count, out); break;
    case 6: sum_taps<6, first>(taps, in, base, dim, count, out); break;
    case 7: sum_taps<7, first>(taps, in, base, dim, count, out); break;
    default: sum_taps<8, first>(taps, in, base, dim, count, out); break;
  }
}

// out[(q*M + r)*D + c] = phase[r][q*D + c]
template <std::size_t M, std::size_t D, class Real>
[[gnu::always_inline]] inline void interleave_fixed(const Real* const* phase, std::size_t groups,
                                                    Real* __restrict out) {
  std::array<const Real*, M> from;
  for (std::size_t r = 0; r < M; ++r) from[r] = phase[r];
  std::size_t q = 0;
  if constexpr (M == 2 && D == 1) {
    constexpr std::size_t width = Pack<Real>::size;
    for (; q + width <= groups; q += width) {
      typename Pack<Real>::Type a, b, low, high;
      std::memcpy(&a, from[0] + q, sizeof a);
      std::memcpy(&b, from[1] + q, sizeof b);
      if constexpr (width == 4) {
        low = __builtin_shufflevector(a, b, 0, 4, 1, 5);
        high = __builtin_shufflevector(a, b, 2, 6, 3, 7);
      } else {
        low = __builtin_shufflevector(a, b, 0, 8, 1, 9, 2, 10, 3, 11);
        high = __builtin_shufflevector(a, b, 4, 12, 5, 13, 6, 14, 7, 15);
      }
      std::memcpy(out + 2 * q, &low, sizeof low);
      std::memcpy(out + 2 * q + width, &high, sizeof high);
    }
  }
  for (; q < groups; ++q) {
#pragma GCC unroll 4
    for (std::size_t r = 0; r < M; ++r) std::memcpy(out + (q * M + r) * D, from[r] + q * D, D * sizeof(Real));
  }
}

template <class Real>
void interleave_any(const Real* const* phase, std::size_t m, std::size_t dim, std::size_t groups, Real* out) {
  for (std::size_t q = 0; q < groups; ++q) {
    for (std::size_t r = 0; r < m; ++r, out += dim) std::copy_n(phase[r] + q * dim, dim, out);
  }
}

template <class Real>
[[gnu::always_inline]] inline void interleave(const Real* const* phase, std::size_t m, std::size_t dim,
                                              std::size_t groups, Real* __restrict out) {
  switch (m * 8 + (dim < 8 ? dim : 0)) {
    case 2 * 8 + 1: return interleave_fixed<2, 1>(phase, groups, out);
    case 2 * 8 + 2: return interleave_fixed<2, 2>(phase, groups, out);
    case 2 * 8 + 3: return interleave_fixed<2, 3>(phase, groups, out);
    case 2 * 8 + 4: return interleave_fixed<2, 4>(phase, groups, out);
    case 3 * 8 + 1: return interleave_fixed<3, 1>(phase, groups, out);
    case 3 * 8 + 2: return interleave_fixed<3, 2>(phase, groups, out);
    case 3 * 8 + 3: return interleave_fixed<3, 3>(phase, groups, out);
    case 3 * 8 + 4: return interleave_fixed<3, 4>(phase, groups, out);
    case 4 * 8 + 1: return interleave_fixed<4, 1>(phase, groups, out);
    case 4 * 8 + 2: return interleave_fixed<4, 2>(phase, groups, out);
    case 4 * 8 + 3: return interleave_fixed<4, 3>(phase, groups, out);
    case 4 * 8 + 4: return interleave_fixed<4, 4>(phase, groups, out);
    default: return interleave_any(phase, m, dim, groups, out);
  }
}

// `groups` groups of m rows each; the row of the first q begins at in[base] (taps may reach before and after it).
template <class Real>
[[gnu::always_inline]] inline void whole_groups(const Phases<Real>& phases, const Real* in, std::ptrdiff_t base,
                                                std::size_t groups, std::size_t dim, Real* out) {
  constexpr std::size_t small = 4;  // phases that need no memory
  const std::size_t m = phases.size();
  const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(dim);
  const std::size_t strip = std::max<std::size_t>(1, strip_values / dim);
  alignas(32) std::array<Real, small * strip_values> small_scratch;
  std::array<const Real*, small> small_phase;
  std::vector<Real> large_scratch;
  std::vector<const Real*> large_phase;
  Real* scratch = small_scratch.data();
  const Real** phase = small_phase.data();
  if (m > small || dim > strip_values) {
    large_scratch.resize(m * strip * dim);
    large_phase.resize(m);
    scratch = large_scratch.data();
    phase = large_phase.data();
  }
  for (std::size_t q = 0; q < groups; q += strip) {
    const std::size_t now = std::min(strip, groups - q);
    const std::size_t count = now * dim;
    const std::ptrdiff_t at = base + static_cast<std::ptrdiff_t>(q * dim);
    for (std::size_t r = 0; r < m; ++r) {
      const auto& taps = phases[r];
      if (taps.size() == 1 && taps[0].weight == Real(1)) {
        phase[r] = in + (at + taps[0].offset * row);
        continue;
      }
      Real* to = scratch + r * strip * dim;
      phase[r] = to;
      if (taps.empty()) {
        std::fill_n(to, count, Real(0));
        continue;
      }
      sum_up_to_8<true>(taps.data(), std::min<std::size_t>(8, taps.size()), in, at, row, count, to);
      for (std::size_t s = 8; s < taps.size(); s += 8) {
        sum_up_to_8<false>(taps.data() + s, std::min<std::size_t>(8, taps.size() - s), in, at, row, count, to);
      }
    }
    interleave(phase, m, dim, now, out + q * m * dim);
  }
}

// The same code for two instruction sets; AVX2 without FMA, so that the bits are the same.
template <class Real>
void whole_groups_base(const Phases<Real>& phases, const Real* in, std::ptrdiff_t base, std::size_t groups,
                       std::size_t dim, Real* out) {
  whole_groups(phases, in, base, groups, dim, out);
}

#ifdef TWOSCALE_KERNELS_X86
[[gnu::target("avx2")]] void whole_groups_avx2(const Phases<double>& phases, const double* in, std::ptrdiff_t base,
                                               std::size_t groups, std::size_t dim, double* out) {
  whole_groups(phases, in, base, groups, dim, out);
}

[[gnu::target("avx2")]] void whole_groups_avx2(const Phases<float>& phases, const float* in, std::ptrdiff_t base,
                                               std::size_t groups, std::size_t dim, float* out) {
  whole_groups(phases, in, base, groups, dim, out);
}
#endif

template <class Real>
void dispatch(const Phases<Real>& phases, const Real* in, std::ptrdiff_t base, std::size_t groups, std::size_t dim,
              Real* out) {
#ifdef TWOSCALE_KERNELS_X86
  if (__builtin_cpu_supports("avx2")) return whole_groups_avx2(phases, in, base, groups, dim, out);
#endif
  whole_groups_base(phases, in, base, groups, dim, out);
}

}  // namespace

template <class Real>
VectorStep<Real>::VectorStep(int arity, long lowest, std::span<const Real> a)
    : arity_(arity), phases_(static_cast<std::size_t>(arity)) {
  const long highest = lowest + static_cast<long>(a.size()) - 1;
  for (long r = 0; r < arity_; ++r) {
    for (long s = floor_div(highest - r, arity_); arity_ * s + r >= lowest; --s) {  // j = q - s upwards
      const Real weight = a[static_cast<std::size_t>(arity_ * s + r - lowest)];
      if (weight != Real(0)) phases_[static_cast<std::size_t>(r)].push_back({weight, -s});
    }
  }
}

template <class Real>
void VectorStep<Real>::operator()(const Real* in, long in_first, long out_first, std::size_t out_count, std::size_t dim,
                                  Real* out) const {
  const long m = arity_;
  const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(dim);
  const auto single = [&](long i) {
    const long q = floor_div(i, m);
    const std::vector<Tap>& taps = phases_[static_cast<std::size_t>(i - m * q)];
    for (std::ptrdiff_t c = 0; c < row; ++c, ++out) {
      Real sum = 0;
      for (std::size_t s = 0; s < taps.size(); ++s) {
        const Real term = taps[s].weight * in[(q - in_first + taps[s].offset) * row + c];
        sum = s == 0 ? term : sum + term;
      }
      *out = sum;
    }
  };
  const long out_end = out_first + static_cast<long>(out_count);
  const long q_first = ceil_div(out_first, m);
  const long q_end = std::max(q_first, floor_div(out_end, m));
  long i = out_first;
  for (; i < std::min(out_end, m * q_first); ++i) single(i);
  if (q_end > q_first) {
    const std::size_t groups = static_cast<std::size_t>(q_end - q_first);
    dispatch(phases_, in, (q_first - in_first) * row, groups, dim, out);
    out += groups * static_cast<std::size_t>(m) * dim;
    i = m * q_end;
  }
  for (; i < out_end; ++i) single(i);
}

template class VectorStep<double>;
template class VectorStep<float>;

}  // namespace detail
}  // namespace twoscale::kernels
