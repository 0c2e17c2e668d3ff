// SPDX-License-Identifier: 0BSD
// Index windows of the boundary rules.
#include "twoscale/kernels/refine.hpp"

#include <charconv>
#include <optional>

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
std::optional<std::vector<Window>> try_windows(const std::vector<LevelShape>& shapes, EndPoints ends, Shift p, long n,
                                               Boundary boundary) {
  const std::size_t levels = shapes.size();
  std::vector<Window> w(levels + 1);
  if (boundary == Boundary::closed) {
    if (n < 3) return std::nullopt;
    long count = n;
    for (std::size_t k = 0; k <= levels; ++k) {
      w[k] = {0, count - 1, 0, count - 1};
      if (k == levels) break;
      const long m = shapes[k].arity;
      w[k].stored_first = std::min(0L, ceil_div(-shapes[k].highest, m));
      w[k].stored_last = std::max(count - 1, floor_div(m * count - 1 - shapes[k].lowest, m));
      count *= m;
    }
    return w;
  }
  const long inner = boundary == Boundary::given ? n - ends.left - ends.right : n;  // N
  if (inner < 2) return std::nullopt;
  std::vector<long> first(levels + 1), last(levels + 1);  // inside [t_first, t_last]
  long power = 1;
  for (std::size_t k = 0; k <= levels; ++k) {
    first[k] = ceil_div(p.num * (power - 1), p.den);
    last[k] = power * (inner - 1) + floor_div(p.num * (power - 1), p.den);
    if (k < levels) power *= shapes[k].arity;
  }
  w[levels] = {first[levels], last[levels], first[levels], last[levels]};
  for (std::size_t k = levels; k-- > 0;) {
    const LevelShape& s = shapes[k];
    const long m = s.arity;
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
    if (w[0].first < -ends.left || w[0].last > inner - 1 + ends.right)
      fail("the stencil of the last level reaches beyond the points given at the ends");
    w[0] = {-ends.left, inner - 1 + ends.right, -ends.left, inner - 1 + ends.right};
  }
  return w;
}

}  // namespace

Plan plan_windows(std::vector<LevelShape> shapes, EndPoints ends, Shift p, std::size_t n, Boundary boundary) {
  long power = 1;
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    if (power > max_points / shapes[k].arity)
      power = max_points;
    else
      power *= shapes[k].arity;
  }
  if (n > static_cast<std::size_t>(max_points) || power > max_points / std::max(1L, static_cast<long>(n))) {
    fail(std::to_string(n) + " points refined " + std::to_string(shapes.size()) + " times are too many");
  }
  const long points = static_cast<long>(n);
  if (auto windows = try_windows(shapes, ends, p, points, boundary)) {
    return {std::move(shapes), std::move(*windows)};
  }
  long needed = points + 1;
  // A number that suffices exists: each condition compares a constant with a count that grows with n.
  while (!try_windows(shapes, ends, p, needed, boundary)) ++needed;
  fail(boundary_name(boundary) + " needs at least " + std::to_string(needed) + " points here, not " +
       std::to_string(n) +
       (boundary == Boundary::given
            ? " (" + std::to_string(ends.left) + " before and " + std::to_string(ends.right) + " after the curve)"
            : std::string()));
}

void tile_windows(const Plan& plan, Boundary boundary, long first, long last, std::vector<Window>& windows) {
  const std::size_t levels = plan.shapes.size();
  windows.resize(levels + 1);
  windows[levels] = {first, last, first, last};
  for (std::size_t k = levels; k-- > 0;) {
    const LevelShape& shape = plan.shapes[k];
    const Window& level = plan.windows[k];
    const long arity = shape.arity;
    long low = ceil_div(windows[k + 1].first - shape.highest, arity);
    long high = floor_div(windows[k + 1].last - shape.lowest, arity);
    if (k > 0) {
      const long group = plan.shapes[k - 1].arity;
      const long whole_low = floor_div(low, group) * group;
      const long whole_high = floor_div(high, group) * group + group - 1;
      if (boundary == Boundary::closed || whole_low >= level.first) low = whole_low;
      if (boundary == Boundary::closed || whole_high <= level.last) high = whole_high;
    }
    Window w{low, high, low, high};
    if (boundary == Boundary::linear || boundary == Boundary::space) {
      // Points beyond the polygon of this level are extended from its first or last points, which must be there.
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

long segment_unit(const Plan& plan, std::size_t together) {
  const std::size_t levels = plan.shapes.size();
  long rows = 1;
  for (std::size_t k = levels - together; k < levels; ++k) rows *= plan.shapes[k].arity;
  const long lines = 16 * plan.shapes[levels - 1].arity;
  while (rows % lines != 0) rows *= 2;
  return rows;
}

template class Tile<double>;
template class Tile<float>;

}  // namespace detail
}  // namespace twoscale::kernels
