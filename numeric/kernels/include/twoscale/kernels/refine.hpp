// SPDX-License-Identifier: 0BSD
// Level-dependent refinement of polygons, closed and open, over any number type.
//
// Index conventions (they hold for every function of this header)
//
//   rule        f^{k+1}_i = sum_j a_{i-m*j} f^k_j;  m the arity, a = a^{[k]} the mask of the step k -> k+1,
//               a.a[s] = a_{lowest+s}, support [L, H] = [lowest, highest].
//   points      n points of `dim` components, row-major: component c of point j is points[j*dim + c].
//   parameter   f^k_j belongs to t^k_j = (j+p)/m^k. Point 0 of the input has index 0, except with Boundary::given,
//   where
//               the first E_left points have the indices -E_left..-1.
//   phases      with i = m*q + r, 0 <= r < m: f^{k+1}_{mq+r} = sum_s a_{ms+r} f^k_{q-s}.
//   order       every sum runs over j upwards. For floating-point types over the nonzero coefficients only, and when
//               those of a phase are the same from both ends, the points of equal coefficients are added first:
//               c_0 (f_first + f_last) + c_1 (f_{first+1} + f_{last-1}) + ... So results do not depend on the path
//               taken, and points kept by an interpolating rule keep their bits.
//
// Boundaries
//
//   closed      indices wrap modulo n*m^k (several times when the polygon is smaller than the stencil). At least 3
//               points. Out come n*m^K points; point 0 has index 0.
//   given       open; E_left + E_right of the points given lie beyond the ends (see points_beyond_ends; 2l-2 at each
//   end
//               for a 2l-point rule), the other N span the parameter interval [p, N-1+p]. At every level just the
//               points are computed that the result depends on.
//   linear      open; at every level p_{-h} = 2 p_0 - p_h before the first point of that level, mirrored after the last
//               one (beccari2007, (10), when the mask is that paper's).
//   space       open; at every level p_{-1} = sum_j extension[j] p_j with the weights of that level, repeated as often
//               as points are needed, mirrored after the last one. Exact on the space the weights annihilate.
//
//   Out of an open polygon come, at every level, the points whose parameter lies in [t_first, t_last], the interval of
//   the N points themselves: indices ceil(p(m^K-1)) .. floor(m^K (N-1) + p(m^K-1)), that is m^K (N-1) + 1 points from
//   index 0 on for a primal rule (p = 0). At least N = 2.
//
// Number types. T needs `+` and `*` with T as the result, copies, and a conversion of coefficients by a functor
// convert(const std::string& text, double value) -> T (a ball or multiprecision type reads the text, double the value).
//
// Execution. Any piece of the output is computed by itself: the windows of the coarser levels that it depends on, then
// level after level inside a scratch of its own (class Tile). Numbers of other types run as one piece; double and float
// run in pieces, on vector instructions and several threads. A finished piece is written once, past the caches when the
// output is large. Every number is computed by the same operations in the same order whatever the piece, so the bits
// depend neither on tiles, threads nor instruction set.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "twoscale/kernels/buffer_pool.hpp"
#include "twoscale/kernels/error.hpp"
#include "twoscale/kernels/mask_table.hpp"

namespace twoscale::kernels {

enum class Boundary { closed, given, linear, space };

/// "closed", "given", "linear" or "space"; anything else throws Error (bad_input).
Boundary parse_boundary(std::string_view text);

/// The shift p = num/den, den > 0, exact. |num|, den <= 10^6.
struct Shift {
  long num = 0;
  long den = 1;
};

/// Reads "0", "1/2", "-3/4", "0.5". Throws Error (bad_input) naming the text.
Shift parse_shift(std::string_view text);

/// Quotients rounded down and up, for any sign of a; b > 0.
constexpr long floor_div(long a, long b) { return a / b - (a % b != 0 && a < 0 ? 1 : 0); }
constexpr long ceil_div(long a, long b) { return a / b + (a % b != 0 && a > 0 ? 1 : 0); }

/// How many given points lie beyond each end of an open polygon (Boundary::given).
struct EndPoints {
  long left = 0;
  long right = 0;
};

/// The least numbers that suffice for every number of levels when the masks have support [lowest, highest]: n runs from
/// 0 through n -> floor((n + highest)/m) to the left (-lowest to the right), for p = 0 to its fixpoint; with a shift it
/// starts from the last parameter kept at level K, and the largest over all K counts. Support [-h, h], m = 2: h-1,
/// which is 2l-2 for a 2l-point rule (h = 2l-1).
EndPoints points_beyond_ends(int arity, long lowest, long highest, Shift p);

/// Consecutive indices first .. first+count-1.
struct IndexRange {
  long first = 0;
  std::size_t count = 0;
};

/// The fine indices that can be computed from the coarse ones: all i with j in `coarse` whenever i-m*j in the support.
IndexRange computable(int arity, long lowest, long highest, IndexRange coarse);

/// A mask over T. At least `arity` coefficients (pad with zeros), so that every phase has one.
template <class T>
struct Mask {
  int arity = 2;
  long lowest = 0;
  std::vector<T> a;

  long highest() const { return lowest + static_cast<long>(a.size()) - 1; }
};

/// Weights of points of one level: f_j becomes sum_s weight[s] f_{j+lowest+s}. Limits and derivatives at the points are
/// such sums (docs/kernels.md).
template <class T>
struct PointStencil {
  long lowest = 0;
  std::vector<T> weight;
};

/// The step of one level: mask, and the weights that extend the polygon before it (empty: none).
template <class T>
struct LevelRule {
  Mask<T> mask;
  std::vector<T> extension;
};

namespace detail {

struct LevelShape {
  int arity = 2;
  long lowest = 0;
  long highest = 0;
  std::size_t extension = 0;  // number of weights
};

// Indices of one level: computed (or given) points, and those stored, the rest being filled in by the boundary.
struct Window {
  long first = 0, last = -1;
  long stored_first = 0, stored_last = -1;
  std::size_t stored() const { return static_cast<std::size_t>(stored_last - stored_first + 1); }
  std::size_t computed() const { return static_cast<std::size_t>(last - first + 1); }
};

// Steps 0..K-1 and windows of the levels 0..K.
struct Plan {
  std::vector<LevelShape> shapes;
  std::vector<Window> windows;
};

// Throws Error (bad_input) naming how many points are needed.
Plan plan_windows(std::vector<LevelShape> shapes, EndPoints ends, Shift p, std::size_t n, Boundary boundary);

// What the points first..last of level K depend on: windows[k] for k = 0..K. Where the level has more points, a window
// begins and ends with whole groups of the points that come from one.
void tile_windows(const Plan& plan, Boundary boundary, long first, long last, std::vector<Window>& windows);

[[noreturn]] void fail(const std::string& message);
void check_mask(int arity, std::size_t coefficients);
void check_sizes(std::size_t values, std::size_t dim);
void check_output(std::size_t have, std::size_t need);

// Consecutive rows of one step: `count` rows of `width` numbers from index out_first on. Every row that they need is in
// `in`, whose first row has index in_first. Strides in numbers.
template <class T>
struct Rows {
  const T* in = nullptr;
  long in_first = 0;
  std::size_t in_stride = 0;
  long out_first = 0;
  std::size_t count = 0;
  std::size_t width = 0;
  T* out = nullptr;
  std::size_t out_stride = 0;
};

// Numbers that are rounded: the order of their sums matters (see above). Other types take every coefficient.
template <class T>
inline constexpr bool is_rounded = std::is_floating_point_v<T>;

// The weights begin..end-1 of a phase, of which `pairs` are the same from both ends: all of them, or (the middle one
// apart) none.
struct Phase {
  std::size_t begin = 0, end = 0;
  std::size_t pairs = 0;
  bool copies = false;  // one weight, 1
};

// A mask by phases: the nonzero weights of phase r, j upwards, and where their points are, seen from point q.
template <class T>
struct Phases {
  std::vector<T> weight;
  std::vector<std::ptrdiff_t> offset;
  std::vector<Phase> phase;

  explicit Phases(const Mask<T>& mask) {
    const long m = mask.arity;
    for (long r = 0; r < m; ++r) {
      Phase now{weight.size(), 0, 0, false};
      for (long s = floor_div(mask.highest() - r, m); m * s + r >= mask.lowest; --s) {
        const T& w = mask.a[static_cast<std::size_t>(m * s + r - mask.lowest)];
        if (w == T(0)) continue;
        weight.push_back(w);
        offset.push_back(-s);
      }
      now.end = weight.size();
      const auto first = weight.begin() + static_cast<std::ptrdiff_t>(now.begin);
      const std::size_t half = (now.end - now.begin) / 2;
      if (std::equal(first, first + static_cast<std::ptrdiff_t>(half), weight.rbegin())) now.pairs = half;
      now.copies = now.end - now.begin == 1 && weight.back() == T(1);
      phase.push_back(now);
    }
  }
};

// The sum over a phase; at(s) is the number that weight s belongs to.
template <class T, class At>
T sum_of_phase(const Phase& phase, const T* weight, At at) {
  if (phase.begin == phase.end) return T(0);
  const std::size_t middle = phase.begin + phase.pairs;
  std::size_t s = phase.begin;
  T sum = s < middle ? weight[s] * (at(s) + at(phase.end - 1)) : weight[s] * at(s);
  for (++s; s < middle; ++s) sum = sum + weight[s] * (at(s) + at(phase.end - 1 - (s - phase.begin)));
  for (; s < phase.end - phase.pairs; ++s) sum = sum + weight[s] * at(s);
  return sum;
}

// One step, one number at a time.
template <class T>
class PlainStep {
 public:
  explicit PlainStep(const Mask<T>& mask) : mask_(mask) {
    if constexpr (is_rounded<T>) phases_.emplace(mask);
  }

  void operator()(const Rows<T>& rows) const {
    const long m = mask_.arity;
    for (std::size_t row = 0; row < rows.count; ++row) {
      const long i = rows.out_first + static_cast<long>(row);
      for (std::size_t c = 0; c < rows.width; ++c) {
        const auto point = [&](long j) -> const T& {
          return rows.in[static_cast<std::size_t>(j - rows.in_first) * rows.in_stride + c];
        };
        T& out = rows.out[row * rows.out_stride + c];
        if constexpr (is_rounded<T>) {
          const long q = floor_div(i, m);
          out = sum_of_phase(phases_->phase[static_cast<std::size_t>(i - m * q)], phases_->weight.data(),
                             [&](std::size_t s) { return point(q + phases_->offset[s]); });
        } else {
          const auto term = [&](long j) {
            return mask_.a[static_cast<std::size_t>(i - m * j - mask_.lowest)] * point(j);
          };
          const long j_last = floor_div(i - mask_.lowest, m);
          long j = ceil_div(i - mask_.highest(), m);
          T sum = term(j);
          while (++j <= j_last) sum = sum + term(j);
          out = std::move(sum);
        }
      }
    }
  }

 private:
  Mask<T> mask_;
  std::optional<Phases<T>> phases_;
};

// The same for double and float by vector instructions; the bits are those of PlainStep.
template <class Real>
class VectorStep {
 public:
  explicit VectorStep(const Mask<Real>& mask) : arity_(mask.arity), phases_(mask) {}

  void operator()(const Rows<Real>& rows) const;

  // The same of several segments side by side: rows of `in` hold a row of each; `in` is the row of the first point
  // whose group is wanted. Out come such rows, or the rows of every segment apart.
  void side_by_side(const Real* in, std::size_t groups, std::size_t width, Real* out) const;
  void apart(const Real* in, std::size_t groups, std::size_t width, Real* const* out, bool stream) const;

  // The same of this step and two more, the rows between them written nowhere, if all three put new points between the
  // old ones by the same number of pairs of weights (0: these do not). An even number of groups, of eight rows.
  std::size_t pairs_between() const;
  void three_apart(const VectorStep& second, const VectorStep& third, const Real* in, std::size_t groups,
                   std::size_t width, Real* const* out, bool stream) const;

  // The same of wide rows, a multiple of `wide_columns` numbers, with strides in numbers.
  void three_wide(const VectorStep& second, const VectorStep& third, const Real* in, std::size_t in_stride,
                  std::size_t groups, std::size_t width, Real* out, std::size_t out_stride, bool stream) const;

 private:
  long arity_;
  Phases<Real> phases_;
};

extern template class VectorStep<double>;
extern template class VectorStep<float>;

template <class T>
inline constexpr bool is_vectorised = std::is_same_v<T, double> || std::is_same_v<T, float>;

// How many segments of a polygon are refined side by side: number c of row j of segment l is number c + l*width of row
// j of all, or l + c*segments if the width is no power of 2. 0: it is not cut.
template <class T>
std::size_t segments_of(int arity, std::size_t width);
template <>
std::size_t segments_of<double>(int arity, std::size_t width);
template <>
std::size_t segments_of<float>(int arity, std::size_t width);
constexpr std::size_t most_segments = 16;
constexpr std::size_t most_width_side_by_side = 4;
constexpr std::size_t place_in_segments(std::size_t segments, std::size_t width, std::size_t l, std::size_t c) {
  return (width & (width - 1)) == 0 ? l * width + c : c * segments + l;
}

// Columns of wide rows that three steps take at once: a register, or more, on every machine.
constexpr std::size_t wide_columns = 32;

template <class T>
using Step = std::conditional_t<is_vectorised<T>, VectorStep<T>, PlainStep<T>>;

template <class T>
void apply(const Mask<T>& mask, const T* in, long in_first, long out_first, std::size_t count, std::size_t dim,
           T* out) {
  Step<T>{mask}({in, in_first, dim, out_first, count, dim, out, dim});
}

// Copies past the caches, and waits until that is done.
void stream_copy(const void* from, std::size_t bytes, void* to);

// Numbers that are whole registers, to a place before them: by registers, so that what is read next is found among the
// stores under way.
void move_registers(const double* from, std::size_t count, double* to);
void move_registers(const float* from, std::size_t count, float* to);
void drain();

// Fills what is stored around a window. Boundary::space extends the left end with the weights `left`, the right end
// with `right`, mirrored.
template <class T>
void fill_boundary(T* stored, const Window& w, std::size_t dim, Boundary boundary, const std::vector<T>& left,
                   const std::vector<T>& right, const T& two, const T& minus_one) {
  const auto at = [&](long j) { return stored + static_cast<std::size_t>(j - w.stored_first) * dim; };
  const auto copy = [&](long to, long from) { std::copy_n(at(from), dim, at(to)); };
  const long n = w.last - w.first + 1;
  if (boundary == Boundary::closed) {
    for (long j = w.first - 1; j >= w.stored_first; --j) copy(j, j - n * floor_div(j, n));
    for (long j = w.last + 1; j <= w.stored_last; ++j) copy(j, j - n * floor_div(j, n));
  } else if (boundary == Boundary::linear) {
    const auto reflect = [&](long to, long about, long from) {
      for (std::size_t c = 0; c < dim; ++c) at(to)[c] = two * at(about)[c] + minus_one * at(from)[c];
    };
    for (long h = 1; w.first - h >= w.stored_first; ++h) reflect(w.first - h, w.first, w.first + h);
    for (long h = 1; w.last + h <= w.stored_last; ++h) reflect(w.last + h, w.last, w.last - h);
  } else if (boundary == Boundary::space) {
    const auto extend = [&](long to, long inward, const std::vector<T>& weights) {
      for (std::size_t c = 0; c < dim; ++c) {
        T sum = weights[0] * at(to + inward)[c];
        for (std::size_t s = 1; s < weights.size(); ++s) {
          sum = sum + weights[s] * at(to + inward * static_cast<long>(s + 1))[c];
        }
        at(to)[c] = sum;
      }
    };
    for (long j = w.first - 1; j >= w.stored_first; --j) extend(j, 1, left);
    for (long j = w.last + 1; j <= w.stored_last; ++j) extend(j, -1, right);
  }
}

}  // namespace detail

/// One step of a closed polygon of n >= 1 points: out has m*n rows, row 0 is index 0. `in` and `out` do not overlap.
template <class T>
void step_closed(const Mask<T>& mask, std::span<const std::type_identity_t<T>> in, std::size_t dim,
                 std::span<std::type_identity_t<T>> out) {
  detail::check_mask(mask.arity, mask.a.size());
  detail::check_sizes(in.size(), dim);
  const long m = mask.arity;
  const long n = static_cast<long>(in.size() / dim);
  if (n < 1) detail::fail("a closed polygon without points cannot be refined");
  detail::check_output(out.size(), in.size() * static_cast<std::size_t>(m));
  const long first = std::min(0L, ceil_div(-mask.highest(), m));
  const long last = std::max(n - 1, floor_div(m * n - 1 - mask.lowest, m));
  std::vector<T> padded;
  padded.reserve(static_cast<std::size_t>(last - first + 1) * dim);
  for (long j = first; j <= last; ++j) {
    const std::size_t from = static_cast<std::size_t>(j - n * floor_div(j, n)) * dim;
    for (std::size_t c = 0; c < dim; ++c) padded.push_back(in[from + c]);
  }
  detail::apply(mask, padded.data(), first, 0, static_cast<std::size_t>(m * n), dim, out.data());
}

/// One step without any boundary rule: `in` holds the indices in_first.., `out` is filled with the indices out_first..;
/// throws Error (bad_input) unless all of them are computable from `in`. `in` and `out` do not overlap.
template <class T>
void step_open(const Mask<T>& mask, std::span<const std::type_identity_t<T>> in, long in_first, std::size_t dim,
               long out_first, std::span<std::type_identity_t<T>> out) {
  detail::check_mask(mask.arity, mask.a.size());
  detail::check_sizes(in.size(), dim);
  detail::check_sizes(out.size(), dim);
  const IndexRange range = computable(mask.arity, mask.lowest, mask.highest(), {in_first, in.size() / dim});
  const std::size_t count = out.size() / dim;
  if (count == 0) return;
  if (out_first < range.first || out_first + static_cast<long>(count) > range.first + static_cast<long>(range.count)) {
    detail::fail("an open step asks for the points " + std::to_string(out_first) + ".." +
                 std::to_string(out_first + static_cast<long>(count) - 1) + " but its input determines " +
                 std::to_string(range.count) + " points from " + std::to_string(range.first) + " on");
  }
  detail::apply(mask, in.data(), in_first, out_first, count, dim, out.data());
}

/// The mask of a table row over T, padded with zeros to `arity` coefficients.
template <class T, class Convert>
LevelRule<T> level_rule(int arity, const MaskRow& row, Convert&& convert) {
  LevelRule<T> rule;
  rule.mask.arity = arity;
  rule.mask.lowest = row.lowest;
  for (std::size_t s = 0; s < row.value.size(); ++s) rule.mask.a.push_back(convert(row.text[s], row.value[s]));
  const std::string zero = "0";
  while (rule.mask.a.size() < static_cast<std::size_t>(arity)) rule.mask.a.push_back(convert(zero, 0.0));
  for (std::size_t s = 0; s < row.extension.size(); ++s) {
    rule.extension.push_back(
        convert(s < row.extension_text.size() ? row.extension_text[s] : std::string(), row.extension[s]));
  }
  return rule;
}

namespace detail {

// A scheme over T, ready to run.
template <class T>
struct Levels {
  T zero, two, minus_one;
  std::vector<Step<T>> steps;             // of the levels of the table, then of the limit
  std::vector<std::vector<T>> extension;  // likewise
  std::vector<LevelShape> shapes;         // likewise
  std::optional<Step<T>> finish;          // after the last level
  LevelShape finish_shape;

  std::size_t row(std::size_t k) const { return std::min(k, steps.size() - 1); }
};

// A polygon, and where its refined points go. Columns: `width` of the numbers of each row.
template <class T>
struct Job {
  const Levels<T>* levels = nullptr;
  const Plan* plan = nullptr;
  Boundary boundary = Boundary::closed;
  const T* points = nullptr;
  long points_first = 0;  // index of the first one
  std::size_t stride = 0;
  T* out = nullptr;  // row out_first of the last level
  long out_first = 0;
  std::size_t out_stride = 0;
  bool stream = false;
  std::size_t chunk_values = 0;  // of a level, computed at once
  std::size_t segments = 0;      // of a tile
  std::size_t together = 0;      // levels that they go through side by side
};

// Segments of a tile have a multiple of this many rows: whole points of the level where they are cut, whole lines.
long segment_unit(const Plan& plan, std::size_t together);

// The scratch in which a piece of the output goes through all levels; nothing is allocated for a piece that needs no
// more room than the ones before.
template <class T>
class Tile {
 public:
  // Rows first..last of the last level, columns column..column+width-1.
  void run(const Job<T>& job, long first, long last, std::size_t column, std::size_t width) {
    const Plan& plan = *job.plan;
    const std::size_t levels = plan.shapes.size();
    T* const out = job.out + static_cast<std::size_t>(first - job.out_first) * job.out_stride + column;
    const T* const points = job.points + column;
    if (levels == 0) {
      for (long i = first; i <= last; ++i)
        std::copy_n(points + static_cast<std::size_t>(i - job.points_first) * job.stride, width,
                    out + static_cast<std::size_t>(i - first) * job.out_stride);
      return;
    }
    tile_windows(plan, job.boundary, first, last, windows_);
    cut(job, first, last, width, out);
    layout(job, width);
    // Level 0: where it lies, or gathered.
    const Window& base = windows_[0];
    if (gathered_) {
      T* const to = scratch_;
      const long n = plan.windows[0].last + 1;  // of a closed polygon
      for (long j = base.first; j <= base.last; ++j) {
        const long from = job.boundary == Boundary::closed ? j - n * floor_div(j, n) : j;
        std::copy_n(points + static_cast<std::size_t>(from - job.points_first) * job.stride, width,
                    to + static_cast<std::size_t>(j - base.stored_first) * width);
      }
      fill(job, 0, width);
      rows_[0] = {to, base.stored_first, width};
    } else {
      rows_[0] = {points + (base.stored_first - job.points_first) * static_cast<long>(job.stride), base.stored_first,
                  job.stride};
    }
    for (std::size_t k = 1; k < levels && k <= cut_at_; ++k) {
      const Window& w = windows_[k];
      T* const to = scratch_ + at_[k] + static_cast<std::size_t>(w.first - w.stored_first) * width;
      one_step(job, k, w.first, w.computed(), width, to, width);
      fill(job, k, width);
    }
    if constexpr (is_vectorised<T>) {
      if (segments_ > 0) {
        run_segments(job, width, out);
      } else if (wide_) {
        run_wide(job, first, last, width, out);
      } else if (job.stream) {
        write_past(job, first, last, width, out);
      }
      if (job.stream) return drain();
      if (segments_ > 0 || wide_) return;
    }
    one_step(job, levels, first, static_cast<std::size_t>(last - first + 1), width, out, job.out_stride);
  }

 private:
  struct Source {
    const T* data = nullptr;
    long first = 0;
    std::size_t stride = 0;
  };

  static const Step<T>& step(const Job<T>& job, std::size_t k) {
    const bool last = k + 1 == job.plan->shapes.size();
    return last && job.levels->finish ? *job.levels->finish : job.levels->steps[job.levels->row(k)];
  }

  // Two steps as one.
  static LevelShape together(const LevelShape& first, const LevelShape& second) {
    return {first.arity * second.arity, second.lowest + second.arity * first.lowest,
            second.highest + second.arity * first.highest, 0};
  }

  // The last three steps put new points between the old ones by the same number of pairs of weights.
  static bool three_as_one(const Job<T>& job) {
    const std::size_t levels = job.plan->shapes.size();
    const auto pairs = [&](std::size_t k) { return step(job, k).pairs_between(); };
    return levels >= 3 && pairs(levels - 1) > 0 && pairs(levels - 1) == pairs(levels - 2) &&
           pairs(levels - 1) == pairs(levels - 3);
  }

  // Wide rows, away from the ends that a boundary fills: the last three steps as one, if they can be.
  void cut_wide(const Job<T>& job, long first, long last, std::size_t width) {
    const std::size_t levels = job.plan->shapes.size();
    if (segments_of<T>(2, 1) == 0 || !three_as_one(job) || width % wide_columns != 0 || first % 8 != 0 ||
        (last - first + 1) % 16 != 0)
      return;
    for (std::size_t k = levels - 3; k < levels; ++k)
      if (windows_[k].stored() != windows_[k].computed()) return;
    cut_at_ = levels - 3;
    wide_ = true;
  }

  void run_wide(const Job<T>& job, long first, long last, std::size_t width, T* out) {
    const std::size_t levels = job.plan->shapes.size();
    const Source& in = rows_[levels - 3];
    const bool past =
        job.stream && reinterpret_cast<std::uintptr_t>(out) % 64 == 0 && job.out_stride * sizeof(T) % 64 == 0;
    step(job, levels - 3)
        .three_wide(step(job, levels - 2), step(job, levels - 1),
                    in.data + (first / 8 - in.first) * static_cast<long>(in.stride), in.stride,
                    static_cast<std::size_t>(last - first + 1) / 8, width, out, job.out_stride, past);
  }

  // The last levels of a tile as equal segments side by side: then no register crosses a line, and rows need no
  // merging until the last level. Segments are cut at multiples of the rows of one point of the level cut_at_, so their
  // windows differ by a shift only.
  void cut(const Job<T>& job, long first, long last, std::size_t width, const T* out) {
    const std::size_t levels = job.plan->shapes.size();
    segments_ = 0;
    cut_at_ = levels;
    wide_ = false;
    if constexpr (is_vectorised<T>) {
      if (width > most_width_side_by_side) return cut_wide(job, first, last, width);
      const auto segments = static_cast<long>(job.segments);
      if (segments == 0 || job.together == 0 || job.out_stride != width) return;
      rows_of_segment_ = (last - first + 1) / segments;
      if ((last - first + 1) % segments != 0 || rows_of_segment_ % segment_unit(*job.plan, job.together) != 0) return;
      if (first % job.plan->shapes.back().arity != 0) return;
      for (std::size_t k = levels - job.together; k < levels; ++k)
        if (windows_[k].stored() != windows_[k].computed()) return;
      tile_windows(*job.plan, job.boundary, first, first + rows_of_segment_ - 1, segment_windows_);
      for (std::size_t k = levels - job.together + 1; k < levels; ++k)
        if (segment_windows_[k].first % job.plan->shapes[k - 1].arity != 0 ||
            static_cast<long>(segment_windows_[k].computed()) % job.plan->shapes[k - 1].arity != 0)
          return;
      segments_ = job.segments;
      cut_at_ = levels - job.together;
      // The last step, or three as one.
      ends_at_ = levels - 1;
      end_ = job.plan->shapes[ends_at_];
      if (job.together >= 3 && first % 8 == 0 && three_as_one(job))
        while (ends_at_ > levels - 3) end_ = together(job.plan->shapes[--ends_at_], end_);
      // Rows that begin no line anywhere (an output of malloc, two numbers a row) are written as usual.
      past_ = job.stream && reinterpret_cast<std::uintptr_t>(out) % 64 == 0;
    }
  }

  // A level of all segments. Groups of rows: those from one point of the level before.
  struct Side {
    const Step<T>* step = nullptr;  // from the level before
    long arity = 1;                 // of that step
    long behind = 0, ahead = 0;     // group q of the next level comes from the rows q+behind .. q+ahead
    long done = 0, end = 0;         // the first group that is still to be computed, and past the last one
    long chunk = 0, more = 0;       // groups computed at once, and some more the first time
    T* rows = nullptr;
    long first = 0;  // the row there
  };

  // The sides of the levels cut_at_..ends_at_, and the room they need.
  template <class Take>
  void lay_sides(const Job<T>& job, std::size_t width, Take take) {
    const std::size_t wide = width * segments_;
    sides_.assign(ends_at_ + 1, {});
    side_.assign(ends_at_ + 1, 0);
    for (std::size_t k = ends_at_ + 1; k-- > cut_at_;) {
      Side& side = sides_[k];
      const LevelShape& next = k == ends_at_ ? end_ : job.plan->shapes[k];
      const Window& w = segment_windows_[k];
      side.behind = ceil_div(-next.highest, next.arity);
      side.ahead = floor_div(next.arity - 1 - next.lowest, next.arity);
      side.first = w.first;
      std::size_t rows = w.computed();
      if (k > cut_at_) {
        side.step = &step(job, k - 1);
        side.arity = job.plan->shapes[k - 1].arity;
        side.done = floor_div(w.first, side.arity);
        side.end = floor_div(w.last + 1, side.arity);
        // Half as much for every level before the last of these but one, down to a few groups: so that all of them
        // stay in the first cache together.
        const std::size_t halvings = std::min<std::size_t>(ends_at_ - k, 11);
        side.chunk = std::max(8L, (chunk_rows(job, k, wide) / side.arity) >> (halvings > 0 ? halvings - 1 : 0));
        side.more = ((side.ahead - side.behind + 1) / side.arity + 4) / 4 * 4;
        const long asked = k < ends_at_ ? sides_[k + 1].chunk + sides_[k + 1].more : end_groups(job, wide);
        rows = std::min(rows, static_cast<std::size_t>((side.chunk + 2 * side.more) * side.arity + asked));
      }
      side_[k] = take(rows * wide);
    }
  }

  // All levels of the segments. Each in chunks, as far as the next one needs it: so that they stay in the first cache
  // and rows are written all the time.
  void run_segments(const Job<T>& job, std::size_t width, T* out) {
    const std::size_t levels = job.plan->shapes.size();
    const std::size_t wide = width * segments_;
    long shift = rows_of_segment_;
    for (std::size_t k = levels; k-- > cut_at_;) shift /= job.plan->shapes[k].arity;
    for (std::size_t k = cut_at_; k <= ends_at_; ++k) sides_[k].rows = scratch_ + side_[k];
    // The level of the cut, gathered. Rows past the tile's window are there to make whole groups at the end of an open
    // polygon: nothing that is kept depends on them.
    const Window& w = segment_windows_[cut_at_];
    const Source& in = rows_[cut_at_];
    T* const to = sides_[cut_at_].rows;
    const auto gather = [&](auto numbers) {
      for (std::size_t l = 0; l < segments_; ++l) {
        const long j_first = w.first + static_cast<long>(l) * shift;
        const long rows = std::min(w.last - w.first, windows_[cut_at_].last - j_first) + 1;
        const T* from = in.data + static_cast<std::size_t>(j_first - in.first) * in.stride;
        for (std::size_t j = 0; j < static_cast<std::size_t>(rows); ++j, from += in.stride)
          for (std::size_t c = 0; c < numbers; ++c)
            to[j * wide + place_in_segments(segments_, numbers, l, c)] = from[c];
      }
    };
    switch (width) {
      case 1: gather(std::integral_constant<std::size_t, 1>()); break;
      case 2: gather(std::integral_constant<std::size_t, 2>()); break;
      case 3: gather(std::integral_constant<std::size_t, 3>()); break;
      default: gather(std::integral_constant<std::size_t, 4>()); break;
    }
    // The last level, taken apart.
    const long arity = end_.arity;
    const long chunk = end_groups(job, wide);
    const long first = segment_windows_[levels].first / arity;
    const long end = first + rows_of_segment_ / arity;
    T* place[most_segments] = {};
    for (std::size_t l = 0; l < segments_; ++l) place[l] = out + l * static_cast<std::size_t>(rows_of_segment_) * width;
    for (long q = first; q < end; q += chunk) {
      const long next = std::min(end, q + chunk);
      reach(ends_at_, q, next, width, wide);
      const auto groups = static_cast<std::size_t>(next - q);
      const T* const rows = side_row(ends_at_, q, wide);
      if (ends_at_ + 1 < levels) {
        step(job, ends_at_)
            .three_apart(step(job, ends_at_ + 1), step(job, ends_at_ + 2), rows, groups, width, place, past_);
      } else {
        step(job, ends_at_).apart(rows, groups, width, place, past_);
      }
      for (std::size_t l = 0; l < segments_; ++l) place[l] += groups * static_cast<std::size_t>(arity) * width;
    }
  }

  T* side_row(std::size_t k, long j, std::size_t wide) {
    return sides_[k].rows + (j - sides_[k].first) * static_cast<long>(wide);
  }

  // Level k as far as the groups from..end-1 of level k+1 need it, and some more; what they do not need is forgotten.
  // The first chunk has a few groups more: so every later one is asked for when just these are left.
  void reach(std::size_t k, long from, long end, std::size_t width, std::size_t wide) {
    if (k == cut_at_) return;
    Side& side = sides_[k];
    while (side.done < side.end && side.done * side.arity <= end - 1 + side.ahead) {
      const long to = std::min(side.end, side.done + side.chunk + std::exchange(side.more, 0));
      reach(k - 1, side.done, to, width, wide);
      const long done = side.done * side.arity;
      const long first = std::clamp(from + side.behind, side.first, done);
      if (first > side.first) {
        move_registers(side_row(k, first, wide), static_cast<std::size_t>(done - first) * wide, side.rows);
        side.first = first;
      }
      side.step->side_by_side(side_row(k - 1, side.done, wide), static_cast<std::size_t>(to - side.done), width,
                              side_row(k, done, wide));
      side.done = to;
    }
  }

  // Rows of level k > 0 computed at once: about chunk_values numbers, whole groups, whole lines of the output.
  static long chunk_rows(const Job<T>& job, std::size_t k, std::size_t width) {
    const std::size_t unit = 16 * static_cast<std::size_t>(job.plan->shapes[k - 1].arity);
    return static_cast<long>(unit * std::max<std::size_t>(1, job.chunk_values / (unit * width)));
  }

  // Groups of the last step, or of the last three, computed at once: of rows of many registers too so many that what
  // three steps begin with is little beside them.
  long end_groups(const Job<T>& job, std::size_t wide) const {
    return std::max(128L, chunk_rows(job, job.plan->shapes.size(), wide)) / end_.arity / 16 * 16;
  }

  // Rows of the last level on their way past the caches.
  void write_past(const Job<T>& job, long first, long last, std::size_t width, T* out) {
    const std::size_t levels = job.plan->shapes.size();
    const long chunk = chunk_rows(job, levels, width);
    T* const stage = scratch_ + stage_;
    for (long i = first; i <= last; i += chunk, out += static_cast<std::size_t>(chunk) * job.out_stride) {
      const auto count = static_cast<std::size_t>(std::min(chunk, last + 1 - i));
      one_step(job, levels, i, count, width, stage, width);
      if (job.out_stride == width) {
        stream_copy(stage, count * width * sizeof(T), out);
      } else {
        for (std::size_t row = 0; row < count; ++row)
          stream_copy(stage + row * width, width * sizeof(T), out + row * job.out_stride);
      }
    }
  }

  // Rows of level k from level k-1.
  void one_step(const Job<T>& job, std::size_t k, long first, std::size_t count, std::size_t width, T* out,
                std::size_t out_stride) {
    const Source& in = rows_[k - 1];
    step(job, k - 1)({in.data, in.first, in.stride, first, count, width, out, out_stride});
  }

  void layout(const Job<T>& job, std::size_t width) {
    const std::size_t levels = job.plan->shapes.size();
    const Window& base = windows_[0];
    const Window& given = job.plan->windows[0];
    gathered_ = job.boundary == Boundary::closed && (base.first < given.first || base.last > given.last);
    gathered_ = gathered_ || base.stored() != base.computed();
    rows_.resize(levels);
    at_.assign(levels, 0);
    constexpr std::size_t line = is_vectorised<T> ? 64 / sizeof(T) : 1;
    std::size_t need = 0;
    const auto take = [&](std::size_t count) { return std::exchange(need, need + (count + line - 1) / line * line); };
    if (gathered_) at_[0] = take(base.stored() * width);
    for (std::size_t k = 1; k < levels && k <= cut_at_; ++k) at_[k] = take(windows_[k].stored() * width);
    if (segments_ > 0) {
      lay_sides(job, width, take);
    } else if (job.stream) {
      stage_ = take(static_cast<std::size_t>(chunk_rows(job, levels, width)) * width);
    }
    if (values_.size() < need + line) values_.resize(need + line, job.levels->zero);
    scratch_ = values_.data();
    if constexpr (is_vectorised<T>) {
      const std::uintptr_t past = reinterpret_cast<std::uintptr_t>(scratch_) % 64;
      scratch_ += (64 - past) % 64 / sizeof(T);
    }
    for (std::size_t k = 1; k < levels && k <= cut_at_; ++k)
      rows_[k] = {scratch_ + at_[k], windows_[k].stored_first, width};
  }

  void fill(const Job<T>& job, std::size_t k, std::size_t width) {
    if (windows_[k].stored() == windows_[k].computed()) return;
    T* const stored = scratch_ + at_[k];
    const std::vector<T>& weights = job.levels->extension[job.levels->row(k)];
    fill_boundary(stored, windows_[k], width, job.boundary, weights, weights, job.levels->two, job.levels->minus_one);
  }

  std::vector<Window> windows_;
  std::vector<Source> rows_;  // where level k is
  std::vector<T> values_;
  T* scratch_ = nullptr;         // the first line of values_
  std::vector<std::size_t> at_;  // from there, where level k begins
  std::size_t stage_ = 0;        // and a chunk of the last level
  bool gathered_ = false;
  std::size_t segments_ = 0;  // of this tile; 0: it is not cut
  std::size_t cut_at_ = 0;    // the level from which on they lie side by side
  bool wide_ = false;         // rows that take their last three steps as one
  std::size_t ends_at_ = 0;   // and the last one of which they do
  LevelShape end_;            // the step, or the three as one, after it
  bool past_ = false;         // and are written past the caches
  long rows_of_segment_ = 0;
  std::vector<Window> segment_windows_;  // of the first one
  std::vector<Side> sides_;              // from cut_at_ on
  std::vector<std::size_t> side_;        // from scratch_, where they begin
};

extern template class Tile<double>;
extern template class Tile<float>;

// How the output is cut; for tests and measurements too. The bits do not depend on it.
struct Cutting {
  std::size_t tile_values = 262144;  // numbers of the last level in a tile
  std::size_t chunk_values = 1024;   // numbers of a level computed at once
  std::size_t together = 10;         // levels of several segments side by side, at most
  std::size_t columns = 64;          // at most that wide
  std::size_t grain_rows = 100'000;  // rows for a thread, at least
  std::optional<bool> stream;        // past the caches; by default when the output is larger than half the last one
};

// Threads that share the tiles of one output.
class Workers {
 public:
  explicit Workers(int threads);  // 0: one for each core; never more than that
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  std::size_t count() const { return count_; }
  // call(context, worker, i) for i = 0..n-1; never at once for the same worker < count().
  void run(std::size_t n, std::size_t grain, void* context, void (*call)(void*, std::size_t, std::size_t));

 private:
  struct Arena;
  std::unique_ptr<Arena> arena_;
  std::size_t count_ = 1;
};

// Half of the last cache, in bytes.
std::size_t streamed_from();

}  // namespace detail

/// All levels of a scheme over T, with the scratch that refinement needs; it is kept from call to call, and a call like
/// the one before allocates nothing. Not for use by several threads at once (copy it).
template <class T>
class Refiner {
 public:
  /// Coefficients of `table` through convert(text, value). Throws Error (bad_input) as validate does.
  template <class Convert>
  Refiner(const MaskTable& table, Convert convert)
      : levels_{convert(std::string("0"), 0.0),
                convert(std::string("2"), 2.0),
                convert(std::string("-1"), -1.0),
                {},
                {},
                {},
                {},
                {}} {
    validate(table);
    shift_ = parse_shift(table.shift);
    stationary_ = table.levels.empty() || table.tail_bound == "0";
    for (const MaskRow& row : table.levels) add(level_rule<T>(table.arity, row, convert));
    add(level_rule<T>(table.arity, table.limit, convert));
    long lowest = levels_.shapes[0].lowest;
    long highest = levels_.shapes[0].highest;
    for (const detail::LevelShape& s : levels_.shapes) {
      lowest = std::min(lowest, s.lowest);
      highest = std::max(highest, s.highest);
    }
    ends_ = points_beyond_ends(table.arity, lowest, highest, shift_);
  }

  /// Coefficients are the doubles of `table`, converted to T by static_cast.
  explicit Refiner(const MaskTable& table)
      : Refiner(table, [](const std::string&, double value) { return static_cast<T>(value); }) {}

  /// At most so many threads, and no more than there are cores; 0 (the default): that many. double and float only;
  /// other types run on one.
  void set_threads(int threads) {
    if (threads < 0) detail::fail("threads: " + std::to_string(threads) + " is negative");
    threads_ = threads;
    workers_.reset();
  }

  /// A stencil for the points of the last level: limits or derivatives come out in their place. Closed polygons and
  /// Boundary::given only: beyond other ends the limit is not that of the scheme. Nothing: no stencil.
  void set_finish(const std::optional<PointStencil<T>>& stencil) {
    key_.reset();
    levels_.finish.reset();
    if (!stencil) return;
    if (stencil->weight.empty()) detail::fail("a stencil without weights");
    Mask<T> mask{1, 1 - stencil->lowest - static_cast<long>(stencil->weight.size()), stencil->weight};
    std::reverse(mask.a.begin(), mask.a.end());
    levels_.finish_shape = {1, mask.lowest, mask.highest(), 0};
    levels_.finish.emplace(mask);
  }

  /// Points that Boundary::given takes beyond the ends; the same for every number of levels.
  EndPoints ends() const { return ends_; }

  /// Indices of the points that refining n points gives (point 0 of the output has index `first` at level `levels`, its
  /// parameter is (first + p)/m^levels). Throws Error (bad_input) when n is too small, naming how many are needed, or
  /// when the table has fewer levels and is not stationary.
  IndexRange output(std::size_t n, int levels, Boundary boundary) const {
    const detail::Window last = make_plan(n, levels, boundary).windows.back();
    return {last.first, last.computed()};
  }

  /// Refines `levels` times into `out`, which has output(n, levels, boundary).count * dim elements and does not overlap
  /// the input. Errors as output(); also sizes that do not fit.
  void refine(std::span<const T> points, std::size_t dim, int levels, Boundary boundary, std::span<T> out) {
    const detail::Window all = prepare(points, dim, levels, boundary);
    detail::check_output(out.size(), all.computed() * dim);
    run(points, dim, boundary, all.first, out);
  }

  /// The same into a new vector.
  std::vector<T> refine(std::span<const T> points, std::size_t dim, int levels, Boundary boundary) {
    const detail::Window all = prepare(points, dim, levels, boundary);
    std::vector<T> out(all.computed() * dim, levels_.zero);
    run(points, dim, boundary, all.first, out);
    return out;
  }

  /// The same into memory of a pool (double, float and other plain numbers).
  Buffer<T> refine(std::span<const T> points, std::size_t dim, int levels, Boundary boundary,
                   BufferPool& pool) requires std::is_trivially_copyable_v<T> {
    const detail::Window all = prepare(points, dim, levels, boundary);
    Buffer<T> out = pool.take<T>(all.computed() * dim);
    run(points, dim, boundary, all.first, out.span());
    return out;
  }

  /// Rows first_row, first_row+1, ... of the same result, as many as `out` holds, and nothing else is computed: for
  /// outputs that do not fit into memory. Errors as refine(); also rows that are not there.
  void refine_rows(std::span<const T> points, std::size_t dim, int levels, Boundary boundary, std::size_t first_row,
                   std::span<T> out) {
    const detail::Window all = prepare(points, dim, levels, boundary);
    detail::check_sizes(out.size(), dim);
    if (first_row > all.computed() || out.size() / dim > all.computed() - first_row) {
      detail::fail("rows " + std::to_string(first_row) + " to " + std::to_string(first_row + out.size() / dim) +
                   " of a refined polygon of " + std::to_string(all.computed()) + " points");
    }
    run(points, dim, boundary, all.first + static_cast<long>(first_row), out);
  }

  /// write(first_row, values) for consecutive pieces of the same result, about `rows` rows each; `values` is valid
  /// during the call. Memory: the piece.
  template <class Write>
  void for_each_piece(std::span<const T> points, std::size_t dim, int levels, Boundary boundary, std::size_t rows,
                      Write&& write) {
    const std::size_t count = prepare(points, dim, levels, boundary).computed();
    rows = std::max<std::size_t>(1, std::min(rows, count));
    std::vector<T> piece(rows * dim, levels_.zero);
    for (std::size_t row = 0; row < count; row += rows) {
      const std::span<T> now = std::span<T>(piece).first(std::min(rows, count - row) * dim);
      refine_rows(points, dim, levels, boundary, row, now);
      write(row, std::span<const T>(now));
    }
  }

  /// For tests and measurements: how the output is cut.
  void set_cutting(const detail::Cutting& cutting) { cutting_ = cutting; }

 private:
  struct Key {
    std::size_t n;
    int levels;
    Boundary boundary;
    friend bool operator==(const Key&, const Key&) = default;
  };

  void add(const LevelRule<T>& rule) {
    levels_.steps.emplace_back(rule.mask);
    levels_.extension.push_back(rule.extension);
    levels_.shapes.push_back({rule.mask.arity, rule.mask.lowest, rule.mask.highest(), rule.extension.size()});
  }

  detail::Plan make_plan(std::size_t n, int levels, Boundary boundary) const {
    if (levels < 0) detail::fail("levels: " + std::to_string(levels) + " is negative");
    const std::size_t rows = levels_.steps.size() - 1;  // without the limit
    if (static_cast<std::size_t>(levels) > rows && !stationary_) {
      detail::fail(std::to_string(levels) + " levels asked for, but the mask table has " + std::to_string(rows));
    }
    std::vector<detail::LevelShape> shapes;
    for (std::size_t k = 0; k < static_cast<std::size_t>(levels); ++k) shapes.push_back(levels_.shapes[levels_.row(k)]);
    if (levels_.finish) {
      if (boundary == Boundary::linear || boundary == Boundary::space)
        detail::fail("limits and derivatives need a closed polygon or given points beyond the ends");
      shapes.push_back(levels_.finish_shape);
    }
    return detail::plan_windows(std::move(shapes), ends_, shift_, n, boundary);
  }

  // The plan, made anew when it is not that of the call before. Returns the whole output.
  detail::Window prepare(std::span<const T> points, std::size_t dim, int levels, Boundary boundary) {
    detail::check_sizes(points.size(), dim);
    const Key key{points.size() / dim, levels, boundary};
    if (!key_ || *key_ != key) {
      key_.reset();
      plan_ = make_plan(key.n, levels, boundary);
      key_ = key;
    }
    return plan_.windows.back();
  }

  // Rows first.. of the last level.
  void run(std::span<const T> points, std::size_t dim, Boundary boundary, long first, std::span<T> out) {
    if (out.empty()) return;
    const long last = first + static_cast<long>(out.size() / dim) - 1;
    detail::Job<T> job;
    job.levels = &levels_;
    job.plan = &plan_;
    job.boundary = boundary;
    job.points = points.data();
    job.points_first = boundary == Boundary::given ? -ends_.left : 0;
    job.stride = dim;
    job.out = out.data();
    job.out_first = first;
    job.out_stride = dim;
    if (tiles_.empty()) tiles_.resize(1);
    if constexpr (detail::is_vectorised<T>) {
      run_tiles(job, first, last, dim, out);
    } else {
      tiles_[0].run(job, first, last, 0, dim);
    }
  }

  // Tile i: rows by columns; a head tile of few rows first, so that all others begin with a line of the output.
  struct Grid {
    detail::Job<T>* job;
    std::vector<detail::Tile<T>>* tiles;
    long first, last, head, unit, rows, low, high;
    std::size_t dim, columns, across;

    static void call(void* context, std::size_t worker, std::size_t i) {
      const Grid& g = *static_cast<const Grid*>(context);
      const long down = static_cast<long>(i / g.across);
      const std::size_t column = i % g.across * g.columns;
      const long from =
          g.head > 0 ? (down == 0 ? g.first : g.first + g.head + (down - 1) * g.rows) : g.first + down * g.rows;
      const long to = std::min(g.last, g.head > 0 && down == 0 ? g.first + g.head - 1 : from + g.rows - 1);
      const std::size_t width = std::min(g.columns, g.dim - column);
      const auto run = [&](long begin, long end) {
        if (begin < end) (*g.tiles)[worker].run(*g.job, begin, end - 1, column, width);
      };
      // Rows that can be cut into segments: a multiple of the unit, away from the ends that a boundary fills.
      const auto units = [&](long rows) { return std::max(0L, rows) / g.unit * g.unit; };
      const long begin = std::min(to + 1, from + units(g.low - from + g.unit - 1));
      const long end = begin + units(std::min(to, g.high) + 1 - begin);
      run(from, begin);
      run(begin, end);
      run(end, to + 1);
    }
  };

  void run_tiles(detail::Job<T>& job, long first, long last, std::size_t dim, std::span<T> out) {
    const long count = last - first + 1;
    const long m = plan_.shapes.empty() ? 1 : plan_.shapes.back().arity;
    job.chunk_values = cutting_.chunk_values;
    job.stream = cutting_.stream.value_or(out.size_bytes() > detail::streamed_from());
    Grid g{&job, &tiles_, first, last, 0, 0, 0, first, last, dim, std::min(dim, cutting_.columns), 1};
    g.across = (dim + g.columns - 1) / g.columns;
    long unit = 64 * m;  // whole groups, whole lines
    const std::size_t levels = plan_.shapes.size();
    if (levels > 0 && !levels_.finish) {
      if (dim <= g.columns) {
        job.segments = detail::segments_of<T>(static_cast<int>(m), dim);
        for (long rows = 1; job.together < std::min(levels, cutting_.together); ++job.together) {
          rows *= plan_.shapes[levels - 1 - job.together].arity;
          if (rows > 1024) break;
        }
        if (job.segments > 0 && job.together > 0)
          unit = detail::segment_unit(plan_, job.together) * static_cast<long>(job.segments);
      }
      if (job.boundary == Boundary::linear || job.boundary == Boundary::space) {
        // In points of the level of the cut, of which a unit has at least as many as segments.
        const detail::LevelShape& shape = plan_.shapes.back();
        const long reach = (shape.highest - shape.lowest) / (m - 1) + 2 + static_cast<long>(shape.extension);
        const long beside = unit * ceil_div(reach, static_cast<long>(std::max<std::size_t>(1, job.segments)));
        g.low = plan_.windows.back().first + beside;
        g.high = plan_.windows.back().last - beside;
      }
    }
    g.unit = unit;
    g.rows = unit * std::max(1L, static_cast<long>(cutting_.tile_values / g.columns) / unit);
    if (job.stream) {
      const auto begins_line = [&](long h) {
        return (first + h) % m == 0 &&
               reinterpret_cast<std::uintptr_t>(out.data() + static_cast<std::size_t>(h) * dim) % 64 == 0;
      };
      for (long h = 0; h < std::min(unit, count); ++h) {
        if (!begins_line(h)) continue;
        g.head = h;
        break;
      }
    }
    const long down = (g.head > 0 ? 1 : 0) + ceil_div(count - g.head, g.rows);
    const std::size_t n = static_cast<std::size_t>(down) * g.across;
    const std::size_t rows_of_tile = std::max<std::size_t>(1, static_cast<std::size_t>(g.rows) / g.across);
    const std::size_t grain = std::max<std::size_t>(1, cutting_.grain_rows / rows_of_tile);
    if (threads_ != 1 && n >= 2 * grain) {
      if (!workers_) workers_ = std::make_shared<detail::Workers>(threads_);
      if (tiles_.size() < workers_->count()) tiles_.resize(workers_->count());
      workers_->run(n, grain, &g, &Grid::call);
    } else {
      for (std::size_t i = 0; i < n; ++i) Grid::call(&g, 0, i);
    }
  }

  detail::Levels<T> levels_;
  Shift shift_;
  bool stationary_ = false;
  EndPoints ends_;
  int threads_ = 0;
  detail::Cutting cutting_;
  std::optional<Key> key_;
  detail::Plan plan_;
  std::vector<detail::Tile<T>> tiles_;  // one for each worker
  std::shared_ptr<detail::Workers> workers_;
};

/// One-line doors over Refiner.
std::vector<double> refine(std::span<const double> points, std::size_t dim, const MaskTable& table, int levels,
                           Boundary boundary);

template <class T, class Convert>
std::vector<T> refine(std::span<const std::type_identity_t<T>> points, std::size_t dim, const MaskTable& table,
                      int levels, Boundary boundary, Convert convert) {
  return Refiner<T>(table, std::move(convert)).refine(points, dim, levels, boundary);
}

}  // namespace twoscale::kernels
