// SPDX-License-Identifier: GPL-3.0-or-later
// Values of symbols at exponentials, exactly: sum_i c_i E^{k_i} with c_i in Z[v, ...] and E + 1/E = 2v.
//
// E is quadratic over Q(v): every such sum is A + B E with polynomials A, B (E^k = U_{k-1}(v) E - U_{k-2}(v), Chebyshev
// polynomials of the second kind), and it vanishes identically iff A = B = 0. No power series, no rational functions of
// E.
#pragma once

#include <map>
#include <vector>

#include "twoscale/symbolic/polynomial.hpp"

namespace twoscale::analysis {

// U_n(name) for any integer n: U_{-1} = 0, U_{-n} = -U_{n-2}.
class SecondKind {
 public:
  explicit SecondKind(std::string name) : name_(std::move(name)) {}
  const Polynomial& operator()(long n);

 private:
  std::string name_;
  std::map<long, Polynomial> table_;
};

// A + B E.
struct QuadraticElement {
  Polynomial a;
  Polynomial b;
  bool is_zero() const { return a.is_zero() && b.is_zero(); }
};

struct Term {
  Polynomial coefficient;
  long exponent;  // of E
};
QuadraticElement exponential_sum(const std::vector<Term>& terms, SecondKind& u);

}  // namespace twoscale::analysis
