// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the analysis: masks as lists of rationals.
#pragma once

#include <string>
#include <vector>

#include "twoscale/symbolic/scheme.hpp"

namespace twoscale::masks {

using Rationals = std::vector<Rational>;

inline Rationals convolved(const Rationals& a, const Rationals& b) {
  Rationals r(a.size() + b.size() - 1);
  for (size_t i = 0; i < a.size(); ++i)
    for (size_t j = 0; j < b.size(); ++j) r[i + j] += a[i] * b[j];
  return r;
}

inline Rationals power(const Rationals& a, long n) {
  Rationals r{1};
  for (long i = 0; i < n; ++i) r = convolved(r, a);
  return r;
}

inline Rationals times(const Rational& c, Rationals a) {
  for (auto& x : a) x *= c;
  return a;
}

/// S_m(z)/m.
inline Rationals mean(long m) { return Rationals(static_cast<size_t>(m), Rational(1, m)); }

/// a(z^m).
inline Rationals dilated(const Rationals& a, long m) {
  Rationals r((a.size() - 1) * static_cast<size_t>(m) + 1);
  for (size_t i = 0; i < a.size(); ++i) r[i * static_cast<size_t>(m)] = a[i];
  return r;
}

inline Laurent laurent(const Rationals& a, long lowest = 0) {
  return {lowest, std::vector<RationalFunction>(a.begin(), a.end())};
}

inline Scheme scheme(const Rationals& a, long m, const std::string& id = "mask") {
  return Scheme::from_symbol(id, laurent(a), static_cast<int>(m), {});
}

}  // namespace twoscale::masks
