// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton_quotient.hpp"

namespace twoscale {

namespace {

Polynomial integer_polynomial(const Rational& n) { return Polynomial::constant(n.numerator()); }

}  // namespace

NewtonData constant_data(size_t count) {
  NewtonData d{std::vector<Polynomial>(count), std::vector<Polynomial>(count, Polynomial(1)), 1};
  if (count > 0) d.numerator[0] = 1;
  return d;
}

NewtonData inverse_root_data(const std::vector<Node>& node, const std::vector<Polynomial>& h) {
  const size_t l = h.size();
  // Divided differences of u^{-1/2} at h_i^2, .., h_j^2 are N_{ij} / (prod h prod_{a<b} (h_a + h_b)), all over i..j:
  //   equal nodes (n+1 of them): N = C(-1/2, n) 2^{n(n+1)/2} h^{n(n-1)/2};
  //   else N_{ij} (h_j - h_i) = N_{i+1,j} h_i prod_{i<b<j} (h_i + h_b) - N_{i,j-1} h_j prod_{i<a<j} (h_a + h_j).
  // The first is a fraction with denominator 2^n n! / ..: scale it out by keeping N as a polynomial over an integer.
  std::vector<RationalFunction> row(l, RationalFunction(1)), next;  // row[i] = N_{i,i+n}
  std::vector<RationalFunction> newton(l);                          // N_{0,n}
  if (l > 0) newton[0] = 1;
  // left[i] = prod_{i<b<j} (h_i + h_b), right[i] = prod_{i<a<j} (h_a + h_j) for j = i + n, grown with n.
  std::vector<Polynomial> left(l, Polynomial(1)), right(l, Polynomial(1));
  for (size_t n = 1; n < l; ++n) {
    next.assign(l - n, 0);
    for (size_t i = 0; i + n < l; ++i) {
      const size_t j = i + n;
      if (n >= 2) left[i] *= h[i] + h[j - 1];
      right[i] = 1;
      for (size_t a = i + 1; a < j; ++a) right[i] *= h[a] + h[j];
      if (node[i] == node[j]) {
        const long d = static_cast<long>(n);
        const Rational c =
            Rational::binomial(Rational(-1, 2), static_cast<unsigned>(n)) * Rational(2).pow(d * (d + 1) / 2);
        next[i] = RationalFunction(c) * RationalFunction(h[i].pow(static_cast<unsigned>(d * (d - 1) / 2)));
        continue;
      }
      const Rational scale = row[i + 1].denominator_content() * row[i].denominator_content() /
                             gcd(row[i + 1].denominator_content(), row[i].denominator_content());
      const Polynomial top =
          row[i + 1].numerator() * integer_polynomial(scale / row[i + 1].denominator_content()) * h[i] * left[i] -
          row[i].numerator() * integer_polynomial(scale / row[i].denominator_content()) * h[j] * right[i];
      next[i] = RationalFunction::over_factors(Polynomial::exact_quotient(top, h[j] - h[i]), scale, {});
    }
    row = next;
    newton[n] = row[0];
  }
  NewtonData d;
  for (const auto& c : newton) d.scale = d.scale * c.denominator_content() / gcd(d.scale, c.denominator_content());
  const long steps = static_cast<long>(l) - 1;
  for (size_t n = 0; n < l; ++n) {  // [g_0..g_n] in x is 4^{-n} times the one in u
    const Rational factor = d.scale / newton[n].denominator_content() * Rational(4).pow(steps - static_cast<long>(n));
    d.numerator.push_back(newton[n].numerator() * integer_polynomial(factor));
    d.ratio.push_back(h[n]);
    for (size_t i = 0; i < n; ++i) d.ratio[n] *= h[i] + h[n];
  }
  d.scale *= Rational(4).pow(std::max(steps, 0L));
  return d;
}

Product linear_product(const std::vector<Polynomial>& g, const std::vector<Polynomial>& gamma) {
  Product r{{Polynomial(1)}, std::vector<std::vector<Polynomial>>(g.size())};
  auto& p = r.coefficients;
  for (const auto& c : gamma) {
    p.push_back(1);
    for (size_t j = p.size() - 2; j > 0; --j) p[j] = p[j - 1] + p[j] * c;
    p[0] = p[0] * c;
    for (size_t i = 0; i < g.size(); ++i) r.at[i].push_back(g[i] + c);
  }
  return r;
}

NewtonQuotient newton_quotient(const std::vector<Polynomial>& g, const Product& p,
                               const std::vector<std::optional<size_t>>& partner, const NewtonData& data) {
  const size_t count = g.size();
  NewtonQuotient r;
  // Repeated synthetic division: no quotient of differences, so equal nodes are no special case.
  r.difference.assign(count, std::vector<Polynomial>(count));
  for (size_t m = 0; m < count; ++m) {
    std::vector<Polynomial> q = p.coefficients;
    for (size_t n = m; n < count && !q.empty(); ++n) {
      for (size_t j = q.size() - 1; j-- > 0;) q[j] += q[j + 1] * g[n];
      r.difference[m][n] = q[0];
      q.erase(q.begin());
    }
  }
  r.tail.assign(count, Polynomial(1));
  std::vector<Polynomial> paired(count, Polynomial(1));  // prod f_j(g_i) over the partners of earlier nodes
  std::vector<bool> taken(count == 0 ? 0 : p.at[0].size());
  for (size_t i = 0; i < count; ++i) {
    for (size_t j = 0; j < taken.size(); ++j) (taken[j] ? paired : r.tail)[i] *= p.at[i][j];
    if (partner[i]) taken[*partner[i]] = true;
  }
  // w_n P(g_n) = [..]F - sum_{m<n} [g_m..g_n]P w_m, times D_{n-1} E_n; paired[n] = P(g_n) / tail[n].
  size_t last = 0;  // beyond it [..]F = 0
  for (size_t n = 0; n < count; ++n)
    if (!data.numerator[n].is_zero()) last = n;
  Polynomial before = 1;  // D_{n-1}, while it is needed
  for (size_t n = 0; n < count; ++n) {
    Polynomial s = data.numerator[n].is_zero() ? Polynomial(0) : data.numerator[n] * before;
    Polynomial between = data.ratio[n];  // (D_{n-1}/D_m)(E_n/E_m)
    for (size_t m = n; m-- > 0;) {
      s -= r.difference[m][n] * r.numerator[m] * between;
      between *= r.tail[m];
      if (!data.ratio[m].is_one()) between *= data.ratio[m];
    }
    r.numerator.push_back(Polynomial::exact_quotient(s, paired[n]));
    if (n < last) before *= r.tail[n];
  }
  return r;
}

std::vector<Polynomial> newton_expansion(const std::vector<Polynomial>& g, const std::vector<Polynomial>& numerator,
                                         const std::vector<Polynomial>& ratio) {
  std::vector<Polynomial> q{Polynomial(0)};
  Polynomial rest = 1;
  for (size_t m = g.size(); m-- > 0;) {
    if (m + 1 < g.size()) {  // q <- q * (z - g_m + 1/z)
      std::vector<Polynomial> next(q.size() + 2);
      for (size_t i = 0; i < q.size(); ++i) {
        next[i] += q[i];
        next[i + 1] -= g[m] * q[i];
        next[i + 2] += q[i];
      }
      q = std::move(next);
    }
    q[q.size() / 2] += numerator[m] * rest;
    rest *= ratio[m];
  }
  return q;
}

const FactoredPolynomial& NodeSums::operator()(Node a, Node b) {
  Label x{a.variable, a.multiple};
  Label y{b.variable, b.multiple};
  if (y < x) std::swap(x, y);
  const auto key = std::pair(x, y);
  auto at = factored_.find(key);
  if (at == factored_.end()) at = factored_.emplace(key, sum_of_nodes(space_, a, b)).first;
  return at->second;
}

}  // namespace twoscale
