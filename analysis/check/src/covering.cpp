// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Do the boxes of claims `junction` cover all edge parameters?
#include "twoscale/check/covering.hpp"

#include "twoscale/check/positivity.hpp"

#include <algorithm>
#include <utility>

namespace twoscale::check {
namespace {

const Fraction zero{0, 1}, one{1, 1};

/// c_0 + c_1 u.
struct Affine {
  Integer constant = 0, slope = 0;
  std::size_t variable = 0;  ///< if slope != 0
};

std::optional<Affine> affine(const Polynomial& p) {
  Affine a;
  for (const auto& [monomial, coefficient] : p) {
    const auto degree = std::count_if(monomial.begin(), monomial.end(), [](int e) { return e != 0; });
    if (degree == 0) {
      a.constant = coefficient;
      continue;
    }
    const auto at = std::find_if(monomial.begin(), monomial.end(), [](int e) { return e != 0; });
    if (degree != 1 || *at != 1 || a.slope != 0) return std::nullopt;
    a.slope = coefficient;
    a.variable = static_cast<std::size_t>(at - monomial.begin());
  }
  return a;
}

/// The values of an affine function on its side, ascending; nothing if the side is not bounded or not closed.
std::optional<std::pair<Fraction, Fraction>> range(const Affine& a, const std::vector<Side>& sides, Meter& meter) {
  if (a.slope == 0) return std::pair(Fraction{a.constant, 1}, Fraction{a.constant, 1});
  const Side& side = sides[a.variable];
  if (!side.high || side.zero_low || side.zero_high) return std::nullopt;
  const auto value = [&](const Fraction& x) {
    return reduced(a.constant * x.denominator + a.slope * x.numerator, x.denominator, meter);
  };
  std::pair<Fraction, Fraction> r(value(side.low), value(*side.high));
  if (a.slope < 0) std::swap(r.first, r.second);
  return r;
}

/// Is small = large * s with large a variable from 0 on, and s another one in [0, 1]? The upper end of large.
std::optional<Fraction> triangle(const Polynomial& large, const Polynomial& small, std::size_t ratio,
                                 const std::vector<Side>& sides, Meter& meter) {
  const auto u = affine(large);
  if (!u || u->slope != 1 || u->constant != 0 || u->variable == ratio) return std::nullopt;
  const Side& side = sides[u->variable];
  if (side.low.numerator != 0 || !side.high || side.zero_high) return std::nullopt;
  for (std::size_t s = 0; s < sides.size(); ++s) {
    if (s == u->variable || s == ratio) continue;
    Monomial product{};
    product[u->variable] = product[s] = 1;
    if (small != Polynomial{{product, Integer(1)}}) continue;
    const Side& share = sides[s];
    if (share.low.numerator != 0 || !share.high || compare(*share.high, one, meter) != 0 || share.zero_low ||
        share.zero_high)
      return std::nullopt;
    return side.high;
  }
  return std::nullopt;
}

/// A cell, or the half of it with q <= k (below) or q >= k (above).
bool holds(const Region& r, const Region& cell, Meter& meter) {
  const auto within = [&](const Fraction& a, const Fraction& b) { return compare(a, b, meter) <= 0; };
  const bool inside = within(r.k_low, cell.k_low) && within(cell.k_high, r.k_high) && within(r.q_low, cell.q_low) &&
                      within(cell.q_high, r.q_high);
  if (!inside || r.shape == Region::Shape::rectangle) return inside;
  if (cell.shape != Region::Shape::rectangle) return cell.shape == r.shape;
  return r.shape == Region::Shape::below ? within(cell.q_high, cell.k_low) : within(cell.k_high, cell.q_low);
}

}  // namespace

bool all_ratios(const Side& side) { return side.low.numerator == 0 && !side.high; }

std::optional<Region> region_of(const Polynomial& left, const Polynomial& right, std::size_t ratio,
                                const std::vector<Side>& sides, Meter& meter) {
  Polynomial k;
  k.emplace(Monomial{}, 1);
  add_scaled(k, left, -1, Monomial{}, meter);
  if (const auto size = triangle(k, right, ratio, sides, meter))
    return Region{Region::Shape::below, zero, *size, zero, *size};
  if (const auto size = triangle(right, k, ratio, sides, meter))
    return Region{Region::Shape::above, zero, *size, zero, *size};
  const auto first = affine(k), second = affine(right);
  if (!first || !second) return std::nullopt;
  for (const Affine& a : {*first, *second})
    if (a.slope != 0 && a.variable == ratio) return std::nullopt;
  if (first->slope != 0 && second->slope != 0 && first->variable == second->variable) return std::nullopt;
  const auto ks = range(*first, sides, meter), qs = range(*second, sides, meter);
  if (!ks || !qs) return std::nullopt;
  return Region{Region::Shape::rectangle, ks->first, ks->second, qs->first, qs->second};
}

Covering covering_of(const std::vector<Region>& regions, std::string& hole, Meter& meter) {
  std::vector<Fraction> cuts{zero, one};
  for (const Region& r : regions)
    for (const Fraction& x : {r.k_low, r.k_high, r.q_low, r.q_high})
      if (compare(zero, x, meter) < 0 && compare(x, one, meter) < 0) cuts.push_back(x);
  std::sort(cuts.begin(), cuts.end(), [&](const auto& a, const auto& b) { return compare(a, b, meter) < 0; });
  cuts.erase(
      std::unique(cuts.begin(), cuts.end(), [&](const auto& a, const auto& b) { return compare(a, b, meter) == 0; }),
      cuts.end());
  const auto covered = [&](const Region& cell) {
    return std::any_of(regions.begin(), regions.end(), [&](const Region& r) { return holds(r, cell, meter); });
  };
  // (a + 2b)/3: halves of cells on the diagonal have inner points off it.
  const auto between = [&](const Fraction& a, const Fraction& b, int towards_b) {
    return text_of(reduced(a.numerator * b.denominator * (3 - towards_b) + b.numerator * a.denominator * towards_b,
                           3 * a.denominator * b.denominator, meter));
  };
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
    for (std::size_t j = 0; j + 1 < cuts.size(); ++j) {
      Region cell{Region::Shape::rectangle, cuts[i], cuts[i + 1], cuts[j], cuts[j + 1]};
      if (covered(cell)) continue;
      for (const Region::Shape half : {Region::Shape::below, Region::Shape::above}) {
        cell.shape = half;
        if (i == j && covered(cell)) continue;
        const int k = half == Region::Shape::below ? 2 : 1;
        hole = "1 - left = " + between(cuts[i], cuts[i + 1], k) + ", right = " + between(cuts[j], cuts[j + 1], 3 - k);
        return Covering::none;
      }
    }
  const bool crease = std::any_of(regions.begin(), regions.end(), [&](const Region& r) {
    return r.shape == Region::Shape::rectangle && compare(r.k_low, zero, meter) <= 0 &&
           compare(zero, r.k_high, meter) <= 0 && compare(r.q_low, zero, meter) <= 0 &&
           compare(zero, r.q_high, meter) <= 0;
  });
  return crease ? Covering::all : Covering::all_but_crease;
}

}  // namespace twoscale::check
