// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/analysis/exponential_sums.hpp"

namespace twoscale::analysis {

const Polynomial& SecondKind::operator()(long n) {
  const auto at = table_.find(n);
  if (at != table_.end()) return at->second;
  Polynomial p;
  if (n < -1) {
    p = -(*this)(-n - 2);
  } else if (n == 0) {
    p = 1;
  } else if (n > 0) {
    // U_n = (T_{n+1})' / (n+1).
    const Polynomial d = Polynomial::chebyshev(name_, static_cast<unsigned>(n + 1)).derivative(name_);
    p = Polynomial::exact_quotient(d, Polynomial(n + 1));
  }
  return table_.emplace(n, std::move(p)).first->second;
}

QuadraticElement exponential_sum(const std::vector<Term>& terms, SecondKind& u) {
  QuadraticElement r;
  for (const auto& [c, k] : terms) {
    if (c.is_zero()) continue;
    r.b += c * u(k - 1);
    r.a -= c * u(k - 2);
  }
  return r;
}

}  // namespace twoscale::analysis
