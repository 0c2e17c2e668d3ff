// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/lowering/limit_stencil.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "digits.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::lowering {

namespace {

using kernels::ceil_div;
using kernels::floor_div;

constexpr long digits = 150;
constexpr long bits = 512;
constexpr unsigned first_extra = 24;  // further levels
constexpr unsigned last_extra = 96;
constexpr unsigned between = 8;

Ball number(long n) {
  Ball r;
  arb_set_si(r.raw(), n);
  return r;
}

void add_product(Ball& sum, const Ball& a, const Ball& b) { arb_addmul(sum.raw(), a.raw(), b.raw(), bits); }

double size(const Ball& x) { return std::abs(arf_get_d(arb_midref(x.raw()), ARF_RND_NEAR)); }

// x in [0, 1) as num/den.
struct Place {
  long num;
  long den;
  friend auto operator<=>(const Place&, const Place&) = default;
};

class Stencils {
 public:
  Stencils(const Scheme& scheme, const Binding& binding, unsigned level, unsigned extra)
      : m_(scheme.arity), level_(level), id_(scheme.id) {
    const kernels::MaskTable table =
        lower(scheme, binding, {is_stationary(scheme) ? 0 : level + extra, digits, false, false});
    for (const kernels::MaskRow& row : table.levels) rows_.push_back(balls(row));
    limit_ = balls(table.limit);
    lowest_ = table.limit.lowest;
    highest_ = table.limit.highest();
    const kernels::Shift p = kernels::parse_shift(table.shift);
    const long whole = floor_div(p.num, p.den);
    offset_ = whole;
    Place x{p.num - whole * p.den, p.den};
    std::map<Place, std::size_t> seen;
    for (;; x = step(x).first) {
      const auto [at, fresh] = seen.emplace(x, orbit_.size());
      if (!fresh) {
        cycle_ = at->second;
        break;
      }
      orbit_.push_back(x);
    }
    for (long r = 0; r < m_; ++r) check_coset(r);
  }

  // w_u at u = first(0).., largest index last; derivative d.
  kernels::PointStencil<double> stencil(unsigned d) const {
    std::size_t at = cycle_;
    std::vector<Ball> values = cycle_values(d);
    // From the last level back to `level_`; the orbit is entered where that many steps end.
    std::size_t steps = rows_.empty() ? cycle_ : rows_.size() - level_;
    if (!rows_.empty() && steps < cycle_) steps = cycle_;
    const std::size_t length = orbit_.size() - cycle_;
    std::size_t end = steps < orbit_.size() ? steps : cycle_ + (steps - cycle_) % length;
    for (; at != end; at = back(at)) values = times(place(back(at)), limit_, values, d);
    for (std::size_t i = steps; i-- > 0;) {
      const std::size_t k = level_ + i;
      const std::size_t from = i < orbit_.size() ? i : cycle_ + (i - cycle_) % length;
      values = times(orbit_[from], k < rows_.size() ? rows_[k] : limit_, values, d);
    }
    // phi(p - u), p = offset + x: the values belong to x + n, so u = offset - n.
    const auto [low, high] = range(orbit_[0]);
    kernels::PointStencil<double> r;
    r.lowest = offset_ - high;
    const Ball scale = power(static_cast<long>(d) * static_cast<long>(level_));
    for (long n = high; n >= low; --n) {
      Ball x;
      arb_mul(x.raw(), values[static_cast<std::size_t>(n - low)].raw(), scale.raw(), bits);
      if (mag_get_d(arb_radref(x.raw())) > 1e-30 * size(scale))
        throw Error(Error::Kind::undecided, "the weights of the limit stencil are not decided", id_);
      r.weight.push_back(x.contains_zero() ? 0.0 : arf_get_d(arb_midref(x.raw()), ARF_RND_NEAR));
    }
    return r;
  }

 private:
  std::vector<Ball> balls(const kernels::MaskRow& row) const {
    std::vector<Ball> list;
    for (const std::string& text : row.text) list.push_back(coefficient(text, digits, bits).value);
    return list;
  }

  Ball power(long e) const {  // m^e
    Ball r;
    arb_ui_pow_ui(r.raw(), static_cast<unsigned long>(m_), static_cast<unsigned long>(std::abs(e)), bits);
    if (e < 0) arb_inv(r.raw(), r.raw(), bits);
    return r;
  }

  void check_coset(long r) const {
    Ball sum = number(-1);
    for (long i = lowest_; i <= highest_; ++i)
      if (i - m_ * floor_div(i, m_) == r)
        arb_add(sum.raw(), sum.raw(), limit_[static_cast<std::size_t>(i - lowest_)].raw(), bits);
    if (!sum.contains_zero()) bad_input("constants are not reproduced in the limit, there are no limit stencils", id_);
  }

  // m x = x' + c.
  std::pair<Place, long> step(const Place& x) const {
    const long c = floor_div(m_ * x.num, x.den);
    return {{m_ * x.num - c * x.den, x.den}, c};
  }

  const Place& place(std::size_t i) const { return orbit_[i]; }
  // The place before number i of the cycle, inside the cycle.
  std::size_t back(std::size_t i) const { return i == cycle_ ? orbit_.size() - 1 : i - 1; }

  // phi(x + n) is not 0 only for n in this range: lowest/(m-1) < x + n < highest/(m-1).
  std::pair<long, long> range(const Place& x) const {
    const long den = (m_ - 1) * x.den;
    return {floor_div(lowest_ * x.den - (m_ - 1) * x.num, den) + 1,
            ceil_div(highest_ * x.den - (m_ - 1) * x.num, den) - 1};
  }

  // The values at x from those at x': m^d sum_n a_{m s + c - n} value'_n.
  std::vector<Ball> times(const Place& x, const std::vector<Ball>& mask, const std::vector<Ball>& values,
                          unsigned d) const {
    const auto [next, c] = step(x);
    const auto [low, high] = range(x);
    const auto [low_next, high_next] = range(next);
    std::vector<Ball> r(static_cast<std::size_t>(std::max(0L, high - low + 1)));
    const Ball scale = power(d);
    for (long s = low; s <= high; ++s) {
      Ball& sum = r[static_cast<std::size_t>(s - low)];
      for (long n = low_next; n <= high_next; ++n) {
        const long i = m_ * s + c - n;
        if (i < lowest_ || i > highest_) continue;
        add_product(sum, mask[static_cast<std::size_t>(i - lowest_)], values[static_cast<std::size_t>(n - low_next)]);
      }
      arb_mul(sum.raw(), sum.raw(), scale.raw(), bits);
    }
    return r;
  }

  // The eigenvector of the cycle, values at its first place.
  std::vector<Ball> cycle_values(unsigned d) const {
    const auto [low, high] = range(orbit_[cycle_]);
    const std::size_t n = static_cast<std::size_t>(std::max(0L, high - low + 1));
    if (n == 0) bad_input("the limit is not continuous, there are no limit stencils", id_);
    // Rows of (product - 1) x = 0 and the moment d.
    std::vector<std::vector<Ball>> a(n + 1, std::vector<Ball>(n + 1));
    for (std::size_t j = 0; j < n; ++j) {
      std::vector<Ball> column(n);
      column[j] = number(1);
      for (std::size_t i = orbit_.size(); i-- > cycle_;) column = times(orbit_[i], limit_, column, d);
      for (std::size_t i = 0; i < n; ++i) a[i][j] = column[i];
      arb_sub_ui(a[j][j].raw(), a[j][j].raw(), 1, bits);
      a[n][j] = number(1);
      for (unsigned e = 0; e < d; ++e) arb_mul_si(a[n][j].raw(), a[n][j].raw(), -(low + static_cast<long>(j)), bits);
    }
    a[n][n] = number(1);
    for (unsigned e = 2; e <= d; ++e) arb_mul_ui(a[n][n].raw(), a[n][n].raw(), e, bits);
    const auto refuse = [&] {
      bad_input(d == 0 ? "the limit values at the points are not determined by the masks"
                       : "the limit has no derivative of order " + std::to_string(d) + " at the points",
                id_);
    };
    for (std::size_t j = 0; j < n; ++j) {
      std::size_t pivot = j;
      for (std::size_t i = j; i <= n; ++i)
        if (size(a[i][j]) > size(a[pivot][j])) pivot = i;
      if (a[pivot][j].contains_zero() || size(a[pivot][j]) < 1e-60) refuse();
      std::swap(a[j], a[pivot]);
      for (std::size_t i = 0; i <= n; ++i) {
        if (i == j || a[i][j].is_exact_zero()) continue;
        Ball factor;
        arb_div(factor.raw(), a[i][j].raw(), a[j][j].raw(), bits);
        for (std::size_t k = j; k <= n; ++k) arb_submul(a[i][k].raw(), factor.raw(), a[j][k].raw(), bits);
      }
    }
    if (!a[n][n].contains_zero()) refuse();  // one equation too many
    std::vector<Ball> x(n);
    for (std::size_t j = 0; j < n; ++j) arb_div(x[j].raw(), a[j][n].raw(), a[j][j].raw(), bits);
    return x;
  }

  long m_;
  unsigned level_;
  std::string id_;
  std::vector<std::vector<Ball>> rows_;
  std::vector<Ball> limit_;
  long lowest_ = 0, highest_ = 0;
  long offset_ = 0;           // floor(p)
  std::vector<Place> orbit_;  // of p - floor(p)
  std::size_t cycle_ = 0;     // where its cycle begins
};

bool agree(const kernels::PointStencil<double>& a, const kernels::PointStencil<double>& b) {
  double largest = 0, difference = 0;
  for (std::size_t i = 0; i < a.weight.size(); ++i) {
    largest = std::max(largest, std::abs(a.weight[i]));
    difference = std::max(difference, std::abs(a.weight[i] - b.weight[i]));
  }
  return difference <= largest * 0x1p-52;
}

}  // namespace

std::vector<kernels::PointStencil<double>> limit_stencils(const Scheme& scheme, const Binding& binding, unsigned level,
                                                          unsigned orders) {
  const auto with = [&](unsigned extra) {
    const Stencils s(scheme, binding, level, extra);
    std::vector<kernels::PointStencil<double>> list;
    for (unsigned d = 0; d < orders; ++d) list.push_back(s.stencil(d));
    return list;
  };
  auto list = with(first_extra);
  if (is_stationary(scheme)) return list;
  for (unsigned extra = first_extra + between; extra <= last_extra; extra += between) {
    auto next = with(extra);
    bool settled = true;
    for (unsigned d = 0; d < orders; ++d) settled = settled && agree(list[d], next[d]);
    list = std::move(next);
    if (settled) return list;
  }
  throw Error(Error::Kind::undecided, "the limit stencils of further and further levels do not settle", scheme.id);
}

}  // namespace twoscale::lowering
