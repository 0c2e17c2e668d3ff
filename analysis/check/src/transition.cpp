// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. The transition matrix of a symmetric symbol.
#include "twoscale/check/transition.hpp"

#include <algorithm>

namespace twoscale::check {

std::vector<Integer> centred(const std::vector<Integer>& c) {
  if (c.size() % 2 == 0 || !std::equal(c.begin(), c.end(), c.rbegin())) {
    throw Refused("the remainder is not symmetric of even degree");
  }
  return {c.begin() + static_cast<std::ptrdiff_t>(c.size() / 2), c.end()};
}

Matrix transition(const std::vector<Integer>& g, const Integer& scale, long arity, Meter& meter) {
  const long h = static_cast<long>(g.size()) - 1;
  const long size = std::max(0L, h - 1) / (arity - 1) + 1;
  if (size > static_cast<long>(limits::matrix)) {
    throw Malformed("the mask leads to a matrix of more than " + std::to_string(limits::matrix) + " rows");
  }
  const auto at = [&](long k) { return std::abs(k) <= h ? g[static_cast<std::size_t>(std::abs(k))] : Integer(0); };
  Matrix m{static_cast<std::size_t>(size), {}, scale};
  for (long i = 0; i < size; ++i) {
    for (long j = 0; j < size; ++j) {
      m.entries.push_back(at(i - arity * j));
      if (j > 0) m.entries.back() += at(i + arity * j);
      meter.hold(sizeof(Integer) + 8 * words(m.entries.back()));
      meter.spend(20);
    }
  }
  reduce(m.entries, m.scale, meter);
  return m;
}

}  // namespace twoscale::check
