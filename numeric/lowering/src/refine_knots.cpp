// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/lowering/refine_knots.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "digits.hpp"
#include "exact_knots.hpp"
#include "rounding.hpp"
#include "twoscale/kernels/number_text.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::lowering {

namespace {

using kernels::KnotPolygon;
using kernels::Parametrization;

// More precision is needed.
struct Undecided {};

// A ball with its precision as the kernels want a number: comparisons are decided, or Undecided is thrown.
class KnotReal {
 public:
  KnotReal(int n = 0) { arb_set_si(ball_.raw(), n); }  // NOLINT: numbers convert
  KnotReal(Ball ball, long bits) : ball_(std::move(ball)), bits_(bits) {}

  const Ball& ball() const { return ball_; }
  bool is_exact_zero() const { return ball_.is_exact_zero(); }

  friend KnotReal operator+(const KnotReal& a, const KnotReal& b) { return with(arb_add, a, b); }
  friend KnotReal operator-(const KnotReal& a, const KnotReal& b) { return with(arb_sub, a, b); }
  friend KnotReal operator*(const KnotReal& a, const KnotReal& b) { return with(arb_mul, a, b); }
  friend KnotReal operator/(const KnotReal& a, const KnotReal& b) { return with(arb_div, a, b); }
  friend bool operator==(const KnotReal& a, const KnotReal& b) { return sign(a, b) == 0; }
  friend bool operator<=(const KnotReal& a, const KnotReal& b) { return sign(a, b) <= 0; }
  friend bool surely_equal(const KnotReal& a, const KnotReal& b) { return (a - b).is_exact_zero(); }

 private:
  template <class F>
  static KnotReal with(F f, const KnotReal& a, const KnotReal& b) {
    KnotReal r;
    r.bits_ = std::max(a.bits_, b.bits_);
    f(r.ball_.raw(), a.ball_.raw(), b.ball_.raw(), r.bits_);
    return r;
  }
  static int sign(const KnotReal& a, const KnotReal& b) {
    const KnotReal d = a - b;
    if (d.ball_.is_positive()) return 1;
    if (d.ball_.is_negative()) return -1;
    if (d.is_exact_zero()) return 0;
    throw Undecided();
  }

  Ball ball_;
  long bits_ = 64;
};

// x^(1/n) if it is rational, n = 2 or 4; x >= 0.
std::optional<Rational> exact_root(const Rational& x, int n) {
  fmpz_t p, q;
  fmpz_init(p);
  fmpz_init(q);
  const bool exact = fmpz_root(p, x.numerator(), n) != 0 && fmpz_root(q, x.denominator(), n) != 0;
  const Rational root = exact ? Rational(p) / Rational(q) : Rational();
  fmpz_clear(p);
  fmpz_clear(q);
  if (!exact) return std::nullopt;
  return root;
}

template <class T>
KnotPolygon<T> like(const KnotPolygon<Rational>& p) {
  KnotPolygon<T> r;
  r.dim = p.dim;
  r.closed = p.closed;
  r.tagged = p.tagged;
  return r;
}

std::vector<Rational> squared_lengths(const KnotPolygon<Rational>& p) {
  std::vector<Rational> q;
  for (std::size_t e = 0; e < p.edges(); ++e) {
    Rational sum;
    for (std::size_t c = 0; c < p.dim; ++c) {
      const Rational x = p.points[(e + 1) % p.size() * p.dim + c] - p.points[e * p.dim + c];
      sum += x * x;
    }
    q.push_back(sum);
  }
  return q;
}

// Which root of the squared length an interval is.
int root_of(Parametrization kind) { return kind == Parametrization::chordal ? 2 : 4; }

KnotReal root(const Ball& square, Parametrization kind, long bits) {
  Ball r;
  arb_sqrt(r.raw(), square.raw(), bits);
  if (kind == Parametrization::centripetal) arb_sqrt(r.raw(), r.raw(), bits);
  if (!r.is_positive()) throw Undecided();
  return {std::move(r), bits};
}

// Intervals from the points; those that are exactly 0 stay so.
void take_intervals(KnotPolygon<KnotReal>& p, Parametrization kind, long bits) {
  if (kind == Parametrization::uniform) {
    p.d.assign(p.edges(), KnotReal(1));
    return;
  }
  for (std::size_t e = 0; e < p.edges(); ++e) {
    if (p.d[e].is_exact_zero()) continue;
    KnotReal sum;
    for (std::size_t c = 0; c < p.dim; ++c) {
      const KnotReal x = p.points[(e + 1) % p.size() * p.dim + c] - p.points[e * p.dim + c];
      sum = sum + x * x;
    }
    p.d[e] = root(sum.ball(), kind, bits);
  }
}

template <class T>
KnotPolygon<T> cropped_to(KnotPolygon<T> p, kernels::KnotRule rule, const kernels::KnotOptions& options) {
  if (options.boundary != kernels::Boundary::given) return p;
  const long beyond = kernels::points_beyond_ends(rule);
  return kernels::cropped(std::move(p), beyond, beyond);
}

// The numbers of the output, row by row: number(x) for coordinates and intervals, other(x) for edge parameters and
// tags.
template <class T, class F, class G>
void for_each_number(const kernels::PointSet& points, const kernels::KnotColumns& columns, const KnotPolygon<T>& p,
                     F number, G other) {
  for (std::size_t j = 0; j < p.size(); ++j) {
    const std::size_t e = std::min(j, p.edges() - 1);
    std::size_t next = 0;
    for (std::size_t c = 0; c < points.dim; ++c) {
      if (c == columns.lambda)
        other(p.lambda[e]);
      else if (c == columns.d)
        number(p.d[e]);
      else if (c == columns.tag)
        other(T(static_cast<int>(p.tagged[j])));
      else
        number(p.points[j * p.dim + next++]);
    }
  }
}

kernels::PointSet empty_like(const kernels::PointSet& points) {
  kernels::PointSet out;
  out.columns = points.columns;
  out.dim = points.dim;
  return out;
}

}  // namespace

KnotPolygon<Rational> exact_polygon(const kernels::PointSet& points, const kernels::KnotColumns& columns,
                                    const kernels::KnotOptions& options, const Rational& rest) {
  KnotPolygon<Rational> p;
  p.dim = columns.coordinates.size();
  p.closed = options.boundary == kernels::Boundary::closed;
  const auto number = [&](std::size_t j, std::size_t c) {
    const std::size_t at = j * points.dim + c;
    return exact_decimal(at < points.tokens.size() ? points.tokens[at] : kernels::shortest(points.values[at]));
  };
  for (std::size_t j = 0; j < points.size(); ++j)
    for (const std::size_t c : columns.coordinates) p.points.push_back(number(j, c));
  for (std::size_t e = 0; e < p.edges(); ++e) {
    p.lambda.push_back(columns.lambda ? number(e, *columns.lambda) : rest);
    if (options.parametrization == Parametrization::given)
      p.d.push_back(number(e, *columns.d));
    else if (options.parametrization == Parametrization::uniform)
      p.d.emplace_back(1);
  }
  if (p.d.empty()) p.d = squared_lengths(p);
  p.tagged = kernels::tags_of(points, columns, p);
  return p;
}

std::optional<std::vector<Rational>> rational_intervals(const KnotPolygon<Rational>& p, Parametrization kind) {
  if (kind != Parametrization::chordal && kind != Parametrization::centripetal) return p.d;
  std::vector<Rational> d;
  Rational first;
  for (const Rational& q : p.d) {
    if (first.is_zero()) first = q;
    const auto root = q.is_zero() ? Rational() : exact_root(q / first, root_of(kind));
    if (!root) return std::nullopt;
    d.push_back(*root);
  }
  return d;
}

kernels::PointSet rounded_points(const kernels::PointSet& points, const kernels::KnotColumns& columns,
                                 const KnotPolygon<Rational>& p, long digits) {
  kernels::PointSet out = empty_like(points);
  const auto put = [&](const Rational& x) {
    out.tokens.push_back(rounded(x, digits).text);
    out.values.push_back(rounded_double(x));
  };
  for_each_number(points, columns, p, put, put);
  return out;
}

kernels::PointSet refine_on_knots(const kernels::PointSet& points, kernels::KnotRule rule,
                                  const kernels::KnotOptions& options, long digits) {
  if (digits < 17 || digits > 10000) bad_input("digits must lie between 17 and 10000", std::to_string(digits));
  const kernels::KnotColumns columns = kernels::knot_columns(points, options);
  check_output_size(std::ldexp(static_cast<double>(points.size()), options.levels), points.dim, digits,
                    std::to_string(points.size()) + " points, " + std::to_string(options.levels) + " levels");
  const KnotPolygon<Rational> read = exact_polygon(points, columns, options, Rational(1, 2));
  kernels::validate(read, rule, options.boundary);
  const Parametrization kind = options.parametrization;
  const bool from_points = kind == Parametrization::chordal || kind == Parametrization::centripetal;
  const bool again = options.reparametrize && from_points;

  // Rational throughout; only a column d of roots would not be.
  const auto d = rational_intervals(read, kind);
  if (d && !again && !(from_points && columns.d)) {
    KnotPolygon<Rational> p = read;
    p.d = *d;
    for (int k = 0; k < options.levels; ++k) {
      p = kernels::refine_knots(p, rule, options.boundary);
      if (options.reparametrize) p.d.assign(p.edges(), Rational(1));  // uniform
    }
    if (options.reparametrize && options.levels > 0) p.d.assign(p.edges(), Rational(1, 2));
    p = cropped_to(std::move(p), rule, options);
    return rounded_points(points, columns, p, digits);
  }

  constexpr int most_attempts = 6;
  long guard = 12;
  for (int attempt = 0; attempt < most_attempts; ++attempt, guard = std::max(3 * guard, digits + guard)) {
    const long bits = static_cast<long>(std::ceil(static_cast<double>(digits + guard) * 3.3219281)) + 32;
    try {
      auto p = like<KnotReal>(read);
      for (const Rational& x : read.points) p.points.emplace_back(Ball(x, bits), bits);
      for (const Rational& l : read.lambda) p.lambda.emplace_back(Ball(l, bits), bits);
      for (const Rational& q : read.d)
        p.d.push_back(q.is_zero()   ? KnotReal(0)
                      : from_points ? root(Ball(q, bits), kind, bits)
                                    : KnotReal(Ball(q, bits), bits));
      for (int k = 0; k < options.levels; ++k) {
        if (options.reparametrize && k > 0) take_intervals(p, kind, bits);
        p = kernels::refine_knots(p, rule, options.boundary);
      }
      p = cropped_to(std::move(p), rule, options);
      // Edge parameters are those that were read, or 1/2; tags are 0 or 1: exactly.
      std::vector<Rational> known = read.lambda;
      known.insert(known.begin(), {Rational(1, 2), Rational(0), Rational(1)});
      std::sort(known.begin(), known.end());
      known.erase(std::unique(known.begin(), known.end()), known.end());
      std::vector<const Ball*> numbers;
      std::vector<std::optional<Rational>> exact;  // nothing: the next number
      for_each_number(
          points, columns, p,
          [&](const KnotReal& x) {
            numbers.push_back(&x.ball());
            exact.emplace_back();
          },
          [&](const KnotReal& x) {
            exact.emplace_back(*std::find_if(known.begin(), known.end(), [&](const Rational& q) {
              return arb_equal(Ball(q, bits).raw(), x.ball().raw()) != 0;
            }));
          });
      kernels::PointSet decided;
      if (!round_all(numbers, Rational(1), bits, digits, decided)) continue;
      kernels::PointSet out = empty_like(points);
      std::size_t next = 0;
      for (const auto& x : exact) {
        out.tokens.push_back(x ? rounded(*x, digits).text : decided.tokens[next]);
        out.values.push_back(x ? rounded_double(*x) : decided.values[next++]);
      }
      return out;
    } catch (const Undecided&) {
    }
  }
  throw Error(Error::Kind::undecided, "cannot decide the last digit of a refined number");
}

}  // namespace twoscale::lowering
