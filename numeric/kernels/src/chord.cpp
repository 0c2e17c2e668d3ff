// SPDX-License-Identifier: 0BSD
#include "twoscale/kernels/chord.hpp"

#include <cmath>
#include <map>

#include "twoscale/kernels/number_text.hpp"

namespace twoscale::kernels {
namespace {

// A combination of points of one level: index -> weight.
using Combination = std::map<long, double>;

void add(Combination& to, const Combination& c, double factor) {
  for (const auto& [j, w] : c) to[j] += factor * w;
}

// The sum of absolute weights when the combination is written by second differences; nothing if it does not vanish on
// 1 and x.
std::optional<double> by_second_differences(const Combination& c) {
  if (c.empty()) return 0.0;
  double scale = 0, sum = 0, carry = 0, total = 0;
  for (const auto& [j, w] : c) scale = std::max(scale, std::abs(w));
  // Twice the running sum: division by (1 - z)^2.
  for (long j = c.begin()->first; j <= c.rbegin()->first; ++j) {
    const auto at = c.find(j);
    sum += at == c.end() ? 0.0 : at->second;
    carry += sum;
    if (j + 2 <= c.rbegin()->first) total += std::abs(carry);
  }
  const double length = static_cast<double>(c.rbegin()->first - c.begin()->first + 1);
  const double tolerance = 1e-12 * scale * length * length;
  if (std::abs(sum) > tolerance || std::abs(carry) > tolerance) return std::nullopt;
  return total;
}

// One step of a mask over doubles.
class Level {
 public:
  Level(int arity, Shift p, const MaskRow& row) : m_(arity), p_(p), row_(row) {}

  struct Factors {
    double c;
    double mu;
  };

  // Throws unless 1 and x are reproduced.
  Factors factors() const {
    Factors f{0, 0};
    const auto widen = [](double& most, const Combination& c) {
      const auto sum = by_second_differences(c);
      if (!sum) detail::fail("a chord error needs a scheme that reproduces 1 and x at every level");
      most = std::max(most, *sum);
    };
    for (long i = 0; i < m_; ++i) {  // a period of the fine points
      Combination c = fine(i);
      add(c, polygon(i), -1);
      widen(f.c, c);
      Combination second = fine(i - 1);
      add(second, fine(i), -2);
      add(second, fine(i + 1), 1);
      widen(f.mu, second);
    }
    // P_{k+1} at the parameter of f_0: index p(m - 1) of the fine level, between two points in general.
    const long num = p_.num * (m_ - 1);
    const long i = floor_div(num, p_.den);
    const double part = static_cast<double>(num - i * p_.den) / static_cast<double>(p_.den);
    Combination c{{0, -1.0}};
    add(c, fine(i), 1 - part);
    if (part != 0) add(c, fine(i + 1), part);
    widen(f.c, c);
    return f;
  }

 private:
  // f^{k+1}_i.
  Combination fine(long i) const {
    Combination c;
    for (long j = ceil_div(i - row_.highest(), m_); j <= floor_div(i - row_.lowest, m_); ++j)
      c[j] = row_.value[static_cast<std::size_t>(i - m_ * j - row_.lowest)];
    return c;
  }

  // P_k at the parameter of f^{k+1}_i: index (i + p)/m - p of the coarse level.
  Combination polygon(long i) const {
    const long num = i * p_.den + p_.num - m_ * p_.num;
    const long den = m_ * p_.den;
    const long j = floor_div(num, den);
    const double part = static_cast<double>(num - j * den) / static_cast<double>(den);
    Combination c{{j, 1 - part}};
    if (part != 0) c[j + 1] = part;
    return c;
  }

  long m_;
  Shift p_;
  const MaskRow& row_;
};

}  // namespace

double chord_factor(const MaskTable& table, int level) {
  validate(table);
  const Shift p = parse_shift(table.shift);
  const Level::Factors limit = Level(table.arity, p, table.limit).factors();
  if (!(limit.mu < 1)) {
    detail::fail("no bound of the chord error: second differences do not contract in one step, their factor is " +
                 shortest(limit.mu));
  }
  double factor = limit.c / (1 - limit.mu);
  for (std::size_t k = table.levels.size(); k-- > static_cast<std::size_t>(std::max(0, level));) {
    const Level::Factors f = Level(table.arity, p, table.levels[k]).factors();
    factor = f.c + f.mu * factor;
  }
  return factor * (1 + 1e-9);
}

double largest_second_difference(std::span<const double> points, std::size_t dim, bool closed) {
  detail::check_sizes(points.size(), dim);
  const std::size_t n = points.size() / dim;
  double most = 0;
  for (std::size_t j = closed ? 0 : 1; j + (closed ? 0 : 1) < n; ++j) {
    double square = 0;
    for (std::size_t c = 0; c < dim; ++c) {
      const double d = points[(j + n - 1) % n * dim + c] - 2 * points[j * dim + c] + points[(j + 1) % n * dim + c];
      square += d * d;
    }
    most = std::max(most, square);
  }
  return std::sqrt(most);
}

int levels_for_chord(Refiner<double>& refiner, const MaskTable& table, std::span<const double> points, std::size_t dim,
                     int most_levels, Boundary boundary, double tolerance) {
  if (!(tolerance > 0)) detail::fail("a chord error must be positive, not " + shortest(tolerance));
  if (boundary == Boundary::given || boundary == Boundary::space)
    detail::fail("a chord error is bounded for closed polygons and linear ends only");
  const bool closed = boundary == Boundary::closed;
  for (int k = 0; k < most_levels; ++k) {
    const double factor = chord_factor(table, k);
    const std::size_t count = refiner.output(points.size() / dim, k, boundary).count;
    // Pieces with the two points before them.
    constexpr std::size_t rows = 1 << 16;
    double most = 0;
    if (count <= rows) {
      most = largest_second_difference(refiner.refine(points, dim, k, boundary), dim, closed);
    } else {
      std::vector<double> joined, first;
      refiner.for_each_piece(points, dim, k, boundary, rows, [&](std::size_t row, std::span<const double> values) {
        if (row == 0) first.assign(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(2 * dim));
        joined.insert(joined.end(), values.begin(), values.end());
        if (row + values.size() / dim == count && closed) joined.insert(joined.end(), first.begin(), first.end());
        most = std::max(most, largest_second_difference(joined, dim, false));
        joined.erase(joined.begin(), joined.end() - static_cast<std::ptrdiff_t>(std::min(joined.size(), 2 * dim)));
      });
    }
    if (factor * most < tolerance) return k;
  }
  return most_levels;
}

}  // namespace twoscale::kernels
