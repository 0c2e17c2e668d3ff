// SPDX-License-Identifier: GPL-3.0-or-later
// Masks whose exponent is in the literature, sets of matrices whose joint spectral radius is, and random masks.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "twoscale/analysis/remainder.hpp"
#include "twoscale/symbolic/laurent.hpp"

namespace twoscale::bench {

using analysis::Family;
using analysis::RationalMatrix;
using Coefficients = std::vector<Rational>;

struct Mask {
  std::string name;  // set/member
  long arity;
  Coefficients coefficients;

  std::string scheme() const {
    std::string text;
    for (const Rational& a : coefficients) text += (text.empty() ? "" : ",") + a.to_string();
    return "mask:coefficients=\"" + text + "\",lowest=0,arity=" + std::to_string(arity);
  }
};

struct Matrices {
  std::string name;
  Family family;
};

inline Coefficients times(const Coefficients& a, const Coefficients& b) {
  Coefficients r(a.size() + b.size() - 1);
  for (size_t i = 0; i < a.size(); ++i)
    for (size_t j = 0; j < b.size(); ++j) r[i + j] += a[i] * b[j];
  return r;
}

inline Coefficients times(const Rational& c, Coefficients a) {
  for (Rational& x : a) x *= c;
  return a;
}

inline Coefficients power(const Coefficients& a, long n) {
  Coefficients r{Rational(1)};
  for (long k = 0; k < n; ++k) r = times(r, a);
  return r;
}

inline Rational binomial(long n, long k) {
  Rational r = 1;
  for (long i = 0; i < k; ++i) r *= Rational(n - i, i + 1);
  return r;
}

inline Coefficients smoothing(long m) { return Coefficients(static_cast<size_t>(m), Rational(1, m)); }  // S_m/m

// Pseudo-splines (Daubechies, Han, Ron, Shen 2003), type II: 2 c^{2m} sum_{j<=l} binomial(m+l, j) s^{2j} c^{2(l-j)},
// c = cos(t/2), s = sin(t/2). l = m - 1: Deslauriers-Dubuc.
inline Coefficients pseudo_spline(long m, long l) {
  const Coefficients c{Rational(1, 4), Rational(1, 2), Rational(1, 4)};
  const Coefficients s{Rational(-1, 4), Rational(1, 2), Rational(-1, 4)};
  Coefficients sum(static_cast<size_t>(2 * l + 1));
  for (long j = 0; j <= l; ++j) {
    const Coefficients term = times(binomial(m + l, j), times(power(s, j), power(c, l - j)));
    for (size_t i = 0; i < sum.size(); ++i) sum[i] += term[i];
  }
  return times(Rational(2), times(power(c, m), sum));
}

// a_{s - m h} = weights_s[h - first], s = from..from+m-1.
inline Coefficients from_stencils(long m, long from, long first, const std::vector<Coefficients>& weights) {
  std::map<long, Rational> a;
  for (size_t s = 0; s < weights.size(); ++s)
    for (size_t h = 0; h < weights[s].size(); ++h)
      if (weights[s][h].sign() != 0)
        a[from + static_cast<long>(s) - m * (first + static_cast<long>(h))] = weights[s][h];
  Coefficients r;
  for (long i = a.begin()->first; i <= a.rbegin()->first; ++i) r.push_back(a.count(i) != 0 ? a[i] : Rational(0));
  return r;
}

// Of the interpolant at first..first+n-1, its value at x.
inline Coefficients lagrange(long first, long n, const Rational& x) {
  Coefficients r;
  for (long i = 0; i < n; ++i) {
    Rational p = 1;
    for (long j = 0; j < n; ++j)
      if (j != i) p *= (x - Rational(first + j)) / Rational(i - j);
    r.push_back(p);
  }
  return r;
}

inline Coefficients reversed(Coefficients a) {
  std::reverse(a.begin(), a.end());
  return a;
}

inline std::vector<Mask> classical_masks() {
  using Q = Rational;
  std::vector<Mask> list;
  const auto add = [&](const std::string& set, const std::string& member, long m, const Coefficients& a) {
    list.push_back({set + "/" + member, m, a});
  };
  const auto number = [](long n) { return std::to_string(n); };

  for (long m = 2; m <= 5; ++m)
    for (long n = 0; n <= 5; ++n)
      add("B-spline", number(m) + "-ary," + number(n), m, times(Q(m), power(smoothing(m), n + 1)));
  for (long m = 2; m <= 6; ++m)
    for (long l = 0; l < m; ++l) add("pseudo-spline", number(m) + "," + number(l), 2, pseudo_spline(m, l));
  for (long k = 2; k <= 8; ++k)  // Hormann, Sabin 2008
    add("Hormann-Sabin", number(k), 2,
        times(Q(2), times(power(smoothing(2), k), {Q(-k, 8), Q(1) + Q(k, 4), Q(-k, 8)})));
  for (const long n : {2, 3, 4, 5, 6, 8}) {  // Dyn, Floater, Hormann 2005: n = 4
    const long first = n % 2 == 0 ? -(n / 2) + 1 : -(n / 2);
    const Q x = n % 2 == 0 ? Q(1, 4) : Q(-1, 4);
    const Q y = n % 2 == 0 ? Q(3, 4) : Q(1, 4);
    add("dual", number(n) + "-point", 2, from_stencils(2, 0, first, {lagrange(first, n, x), lagrange(first, n, y)}));
  }
  for (long m = 3; m <= 5; ++m)
    for (const long n : {2, 4, 6}) {
      std::vector<Coefficients> weights;
      for (long s = 0; s < m; ++s) weights.push_back(lagrange(-(n / 2) + 1, n, Q(s, m)));
      add("m-ary", number(m) + "-ary," + number(n) + "-point", m, from_stencils(m, 0, -(n / 2) + 1, weights));
    }
  for (const Q& mu : {Q(1, 15), Q(2, 27), Q(1, 12), Q(1, 11), Q(1, 10), Q(1, 9), Q(0)}) {  // Hassan et al. 2002
    const Coefficients a{Q(-1, 18) - mu / Q(6), Q(13, 18) + mu / Q(2), Q(7, 18) - mu / Q(2), Q(-1, 18) + mu / Q(6)};
    add("ternary-4-point", mu.to_string(), 3, from_stencils(3, 0, -1, {{Q(0), Q(1), Q(0), Q(0)}, a, reversed(a)}));
  }
  for (const Q& b : {Q(2, 9), Q(1, 4), Q(3, 11), Q(1, 3)}) {  // Hassan, Dodgson 2003
    const Coefficients a{b - Q(1, 3), Q(4, 3) - Q(2) * b, b};
    add("ternary-3-point", b.to_string(), 3, from_stencils(3, -1, -1, {reversed(a), {Q(0), Q(1), Q(0)}, a}));
  }
  for (const Q& w : {Q(-1, 10), Q(1, 32), Q(1, 20), Q(1, 16), Q(1, 10), Q(1, 8), Q(3, 16), Q(19, 100), Q(1, 5)})
    add("4-point", w.to_string(), 2, {-w, Q(0), Q(1, 2) + w, Q(1), Q(1, 2) + w, Q(0), -w});  // Dyn, Levin, Gregory 1987
  for (const Q& t : {Q(-1, 100), Q(0), Q(1, 200), Q(1, 100), Q(3, 256), Q(1, 64), Q(1, 50)}) {  // Weissman 1990
    const Q u = -(Q(1, 16) + Q(3) * t);
    const Q v = Q(9, 16) + Q(2) * t;
    Coefficients a{t, Q(0), u, Q(0), v, Q(1), v, Q(0), u, Q(0), t};
    if (t.sign() == 0) a = {u, Q(0), v, Q(1), v, Q(0), u};
    add("6-point", t.to_string(), 2, a);
  }
  for (const Q& w : {Q(-1, 2), Q(-1, 4), Q(1, 8), Q(1, 4), Q(3, 10), Q(2, 5), Q(3, 4), Q(2)})
    add("quasi-spline", w.to_string(), 2,
        times(Q(1, 8), {w, Q(1) + Q(2) * w, Q(4) - w, Q(6) - Q(4) * w, Q(4) - w, Q(1) + Q(2) * w, w}));
  return list;
}

inline RationalMatrix matrix(long n, const std::vector<long>& rows) {
  RationalMatrix a(n, n);
  for (long i = 0; i < n * n; ++i) a.set(i / n, i % n, Rational(rows[static_cast<size_t>(i)]));
  return a;
}

//   shears    {[1 1; 0 1], alpha [1 0; 1 1]}: the family on which the finiteness conjecture fails for some alpha
//             (Blondel, Theys, Vladimirov 2003; Hare, Morris, Sidorov, Theys 2011)
//   euler     Euler's binary partition function with d digits: c = (1, ..., 1) (Protasov 2000)
//   rhombus   Pascal's rhombus (Finch, Sebah, Bai 2008; Guglielmi, Protasov 2013)
inline std::vector<Matrices> classical_matrices() {
  std::vector<Matrices> list;
  for (const Rational& alpha : {Rational(1), Rational(9, 10), Rational(4, 5), Rational(7, 10)})
    list.push_back({"shears/" + alpha.to_string(), {matrix(2, {1, 1, 0, 1}), alpha * matrix(2, {1, 0, 1, 1})}});
  for (long d = 3; d <= 13; d += 2)
    list.push_back({"euler/n:" + std::to_string(d),
                    analysis::transition_matrices({2, 0, Coefficients(static_cast<size_t>(d), Rational(1))})});
  list.push_back({"rhombus",
                  {matrix(5, {0, 1, 0, 0, 0, 1, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 2, 1}),
                   matrix(5, {1, 0, 2, 0, 0, 0, 0, 0, 2, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0})}});
  return list;
}

// ((1+z)/2)^2 c(z), c of degree n with coefficients k/16, |k| <= 16, drawn from a generator of this seed; the middle
// one makes c(1) = 2.
inline Mask random_mask(long n, unsigned seed) {
  std::mt19937 generator(seed);
  Coefficients c;
  for (long i = 0; i <= n; ++i) c.emplace_back(static_cast<long>(generator() % 33) - 16, 16);
  for (Rational* end : {&c.front(), &c.back()})
    if (end->sign() == 0) *end = Rational(1, 16);
  Rational sum;
  for (const Rational& x : c) sum += x;
  c[static_cast<size_t>(n / 2)] += Rational(2) - sum;
  return {"random-" + std::to_string(seed) + "/n:" + std::to_string(n), 2, times(power(smoothing(2), 2), c)};
}

}  // namespace twoscale::bench
