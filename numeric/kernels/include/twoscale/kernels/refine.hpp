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
//   order       every sum runs over j upwards, and for floating-point types over the nonzero coefficients only, so that
//               results do not depend on the path taken, and points kept by an interpolating rule keep their bits.
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
// double and float run in vectorised, cache-sized pieces that give the same bits as the plain loop.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

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

/// The step of one level: mask, and the weights that extend the polygon before it (empty: none).
template <class T>
struct LevelRule {
  Mask<T> mask;
  std::vector<T> extension;
};

namespace detail {

struct LevelShape {
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
Plan plan_windows(int arity, std::vector<LevelShape> shapes, EndPoints ends, Shift p, std::size_t n, Boundary boundary);

// What the points first..last of level K depend on, from level `base` (< K) on: windows[k] for k = base..K.
void tile_windows(int arity, const Plan& plan, Boundary boundary, std::size_t base, long first, long last,
                  std::vector<Window>& windows);

[[noreturn]] void fail(const std::string& message);
void check_mask(int arity, std::size_t coefficients);
void check_sizes(std::size_t values, std::size_t dim);
void check_output(std::size_t have, std::size_t need);

// One step of double or float rows by vector instructions; the bits are those of apply_plain.
template <class Real>
class VectorStep {
 public:
  VectorStep(int arity, long lowest, std::span<const Real> a);

  // Rows out_first .. of the next level; every j that is needed lies in the input, whose first row is in_first.
  void operator()(const Real* in, long in_first, long out_first, std::size_t out_count, std::size_t dim,
                  Real* out) const;

  struct Tap {
    Real weight;
    std::ptrdiff_t offset;  // in points, from point q
  };

 private:
  long arity_;
  std::vector<std::vector<Tap>> phases_;  // nonzero weights only, j upwards
};

extern template class VectorStep<double>;
extern template class VectorStep<float>;

template <class T>
inline constexpr bool is_vectorised = std::is_same_v<T, double> || std::is_same_v<T, float>;

// Copies past the caches.
void stream(const void* from, std::size_t bytes, void* to);

// How the last levels are computed in one go: tiles of the output small enough for the first cache.
inline constexpr std::size_t tile_values = 4096;                           // numbers of the last level in a tile
inline constexpr long tile_growth = 256;                                   // at most m^levels within a tile
inline constexpr std::size_t least_fused = 2 * tile_values;                // smaller outputs go level by level
inline constexpr std::size_t least_streamed_bytes = std::size_t{1} << 23;  // smaller outputs stay in the caches

template <class T>
void apply_plain(const Mask<T>& mask, const T* in, long in_first, long out_first, std::size_t out_count,
                 std::size_t dim, T* out) {
  const long m = mask.arity;
  const long lowest = mask.lowest;
  const long highest = mask.highest();
  for (std::size_t row = 0; row < out_count; ++row) {
    const long i = out_first + static_cast<long>(row);
    const long j_first = ceil_div(i - highest, m);
    const long j_last = floor_div(i - lowest, m);
    for (std::size_t c = 0; c < dim; ++c) {
      const auto coefficient = [&](long j) -> const T& { return mask.a[static_cast<std::size_t>(i - m * j - lowest)]; };
      const auto point = [&](long j) -> const T& { return in[static_cast<std::size_t>(j - in_first) * dim + c]; };
      if constexpr (std::is_floating_point_v<T>) {
        bool begun = false;
        T sum = 0;
        for (long j = j_first; j <= j_last; ++j) {
          if (coefficient(j) == T(0)) continue;
          const T term = coefficient(j) * point(j);
          sum = begun ? sum + term : term;
          begun = true;
        }
        out[row * dim + c] = sum;
      } else {
        T sum = coefficient(j_first) * point(j_first);
        for (long j = j_first + 1; j <= j_last; ++j) sum = sum + coefficient(j) * point(j);
        out[row * dim + c] = sum;
      }
    }
  }
}

template <class T>
void apply(const Mask<T>& mask, const T* in, long in_first, long out_first, std::size_t out_count, std::size_t dim,
           T* out) {
  if constexpr (is_vectorised<T>) {
    VectorStep<T>(mask.arity, mask.lowest, std::span<const T>(mask.a))(in, in_first, out_first, out_count, dim, out);
  } else {
    apply_plain(mask, in, in_first, out_first, out_count, dim, out);
  }
}

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

/// All levels of a scheme over T, with the two buffers that refinement needs; they are kept from call to call. Not for
/// use by several threads at once (copy it).
template <class T>
class Refiner {
 public:
  /// Coefficients of `table` through convert(text, value). Throws Error (bad_input) as validate does.
  template <class Convert>
  Refiner(const MaskTable& table, Convert convert)
      : arity_(table.arity),
        zero_(convert(std::string("0"), 0.0)),
        two_(convert(std::string("2"), 2.0)),
        minus_one_(convert(std::string("-1"), -1.0)) {
    validate(table);
    shift_ = parse_shift(table.shift);
    stationary_ = table.levels.empty() || table.tail_bound == "0";
    for (const MaskRow& row : table.levels) levels_.push_back(level_rule<T>(arity_, row, convert));
    limit_ = level_rule<T>(arity_, table.limit, convert);
    long lowest = limit_.mask.lowest;
    long highest = limit_.mask.highest();
    for (const LevelRule<T>& level : levels_) {
      lowest = std::min(lowest, level.mask.lowest);
      highest = std::max(highest, level.mask.highest());
    }
    ends_ = points_beyond_ends(arity_, lowest, highest, shift_);
  }

  /// Coefficients are the doubles of `table`, converted to T by static_cast.
  explicit Refiner(const MaskTable& table)
      : Refiner(table, [](const std::string&, double value) { return static_cast<T>(value); }) {}

  /// Points that Boundary::given takes beyond the ends; the same for every number of levels.
  EndPoints ends() const { return ends_; }

  /// Indices of the points that refining n points gives (point 0 of the output has index `first` at level `levels`, its
  /// parameter is (first + p)/m^levels). Throws Error (bad_input) when n is too small, naming how many are needed, or
  /// when the table has fewer levels and is not stationary.
  IndexRange output(std::size_t n, int levels, Boundary boundary) const {
    const detail::Window last = plan(n, levels, boundary).windows.back();
    return {last.first, last.computed()};
  }

  /// Refines `levels` times into `out`, which has output(n, levels, boundary).count * dim elements and does not overlap
  /// the input. Errors as output(); also sizes that do not fit.
  void refine(std::span<const T> points, std::size_t dim, int levels, Boundary boundary, std::span<T> out) {
    detail::check_sizes(points.size(), dim);
    detail::Plan work = plan(points.size() / dim, levels, boundary);
    detail::check_output(out.size(), work.windows.back().computed() * dim);
    run(points, dim, work, boundary, out);
  }

  /// The same into a new vector.
  std::vector<T> refine(std::span<const T> points, std::size_t dim, int levels, Boundary boundary) {
    detail::check_sizes(points.size(), dim);
    detail::Plan work = plan(points.size() / dim, levels, boundary);
    std::vector<T> out(work.windows.back().computed() * dim, zero_);
    run(points, dim, work, boundary, out);
    return out;
  }

 private:
  const LevelRule<T>& rule(std::size_t k) const { return k < levels_.size() ? levels_[k] : limit_; }

  detail::Plan plan(std::size_t n, int levels, Boundary boundary) const {
    if (levels < 0) detail::fail("levels: " + std::to_string(levels) + " is negative");
    if (static_cast<std::size_t>(levels) > levels_.size() && !stationary_) {
      detail::fail(std::to_string(levels) + " levels asked for, but the mask table has " +
                   std::to_string(levels_.size()));
    }
    std::vector<detail::LevelShape> shapes;
    for (std::size_t k = 0; k < static_cast<std::size_t>(levels); ++k) {
      shapes.push_back({rule(k).mask.lowest, rule(k).mask.highest(), rule(k).extension.size()});
    }
    return detail::plan_windows(arity_, std::move(shapes), ends_, shift_, n, boundary);
  }

  void run(std::span<const T> points, std::size_t dim, detail::Plan& plan, Boundary boundary, std::span<T> out) {
    const std::size_t levels = plan.shapes.size();
    if (levels == 0) {
      const std::size_t skip = boundary == Boundary::given ? static_cast<std::size_t>(ends_.left) * dim : 0;
      std::copy_n(points.begin() + static_cast<std::ptrdiff_t>(skip), out.size(), out.begin());
      return;
    }
    // Levels 1..base one after the other into the buffers; the rest level by level too, or together in tiles.
    std::size_t base = levels - 1;
    const bool tiled = detail::is_vectorised<T> && out.size() >= detail::least_fused;
    if (tiled) {
      for (long growth = long{arity_} * arity_; base > 0 && growth <= detail::tile_growth; growth *= arity_) --base;
      if (boundary == Boundary::closed) {  // inside a tile nothing wraps: store all that the tiles depend on
        std::vector<detail::Window> all;
        const detail::Window& last = plan.windows[levels];
        detail::tile_windows(arity_, plan, boundary, base, last.first, last.last, all);
        detail::Window& w = plan.windows[base];
        w.stored_first = std::min(w.stored_first, all[base].first);
        w.stored_last = std::max(w.stored_last, all[base].last);
      }
    }
    const T* in = points.data();
    if (plan.windows[0].stored() != plan.windows[0].computed()) {
      const detail::Window& w = plan.windows[0];
      reserve(buffers_[0], w.stored() * dim);
      std::copy(points.begin(), points.end(), buffers_[0].data() + offset(w, dim));
      fill(buffers_[0].data(), w, 0, dim, boundary);
      in = buffers_[0].data();
    }
    for (std::size_t k = 0; k < base; ++k) {
      const detail::Window& next = plan.windows[k + 1];
      std::vector<T>& buffer = buffers_[(k + 1) % 2];
      reserve(buffer, next.stored() * dim);
      detail::apply(rule(k).mask, in, plan.windows[k].stored_first, next.first, next.computed(), dim,
                    buffer.data() + offset(next, dim));
      fill(buffer.data(), next, k + 1, dim, boundary);
      in = buffer.data();
    }
    if constexpr (detail::is_vectorised<T>) {
      if (tiled) return run_tiles(in, base, dim, plan, boundary, out);
    }
    const detail::Window& last = plan.windows[levels];
    detail::apply(rule(base).mask, in, plan.windows[base].stored_first, last.first, last.computed(), dim, out.data());
  }

  // Levels base+1..K for one piece of the output after the other.
  void run_tiles(const T* base_points, std::size_t base, std::size_t dim, const detail::Plan& plan, Boundary boundary,
                 std::span<T> out) {
    const std::size_t levels = plan.shapes.size();
    const detail::Window& all = plan.windows[levels];
    const long length = static_cast<long>(std::max<std::size_t>(64, detail::tile_values / dim));
    const bool streamed = out.size_bytes() >= detail::least_streamed_bytes;
    std::vector<detail::VectorStep<T>> steps;
    for (std::size_t k = base; k < levels; ++k) {
      const Mask<T>& mask = rule(k).mask;
      steps.emplace_back(mask.arity, mask.lowest, std::span<const T>(mask.a));
    }
    std::vector<detail::Window> w;
    for (long first = all.first; first <= all.last; first += length) {
      detail::tile_windows(arity_, plan, boundary, base, first, std::min(all.last, first + length - 1), w);
      const T* in = base_points;
      long in_first = plan.windows[base].stored_first;
      T* const target = out.data() + static_cast<std::size_t>(first - all.first) * dim;
      for (std::size_t k = base; k < levels; ++k) {
        const detail::Window& next = w[k + 1];
        const bool direct = k + 1 == levels && !streamed;
        std::vector<T>& tile = tiles_[k % 2];
        if (!direct) reserve(tile, next.stored() * dim);
        T* const to = direct ? target : tile.data();
        steps[k - base](in, in_first, next.first, next.computed(), dim, to + offset(next, dim));
        if (k + 1 < levels) fill(to, next, k + 1, dim, boundary);
        in = to;
        in_first = next.stored_first;
      }
      if (streamed) detail::stream(in, w[levels].computed() * dim * sizeof(T), target);
    }
  }

  void fill(T* stored, const detail::Window& w, std::size_t k, std::size_t dim, Boundary boundary) const {
    detail::fill_boundary(stored, w, dim, boundary, rule(k).extension, rule(k).extension, two_, minus_one_);
  }

  static std::size_t offset(const detail::Window& w, std::size_t dim) {
    return static_cast<std::size_t>(w.first - w.stored_first) * dim;
  }

  void reserve(std::vector<T>& buffer, std::size_t size) const {
    if (buffer.size() < size) buffer.resize(size, zero_);
  }

  int arity_;
  Shift shift_;
  bool stationary_ = false;
  EndPoints ends_;
  std::vector<LevelRule<T>> levels_;
  LevelRule<T> limit_;
  T zero_, two_, minus_one_;
  std::vector<T> buffers_[2];  // levels, alternately
  std::vector<T> tiles_[2];    // the same inside a tile
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
