// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/symbolic/hermite_circle.hpp"

#include "twoscale/symbolic/error.hpp"

namespace twoscale {

namespace {

using R = RationalFunction;

R fraction(long numerator, long denominator) { return R(Rational(numerator, denominator)); }

HermiteForm combination(const R& x, const HermiteForm& f, const R& y, const HermiteForm& g) {
  HermiteForm sum;
  for (size_t j = 0; j < sum.size(); ++j) sum[j] = x * f[j] + y * g[j];
  return sum;
}

// sum_k c_k B_{k,n}(tau), n + 1 the number of c_k, by de Casteljau; also for numbers in place of forms.
HermiteForm blend(std::vector<HermiteForm> c, const R& tau) {
  for (size_t n = c.size(); n-- > 1;)
    for (size_t k = 0; k < n; ++k) c[k] = combination(R(1) - tau, c[k], tau, c[k + 1]);
  return c[0];
}

std::vector<HermiteForm> differences(const std::vector<HermiteForm>& c, const R& factor) {
  std::vector<HermiteForm> d;
  for (size_t k = 0; k + 1 < c.size(); ++k) d.push_back(combination(factor, c[k + 1], -factor, c[k]));
  return d;
}

}  // namespace

std::array<RationalFunction, 6> hermite_circle_weights(const RationalFunction& a, const RationalFunction& b) {
  const auto end = [](const R& x) { return fraction(1, 4) * (x * x + R(1)).pow(2); };
  const auto next = [](const R& x, const R& y) {
    return fraction(1, 20) * (x * x + R(1)) * (x * x + R(4) * x * y + R(5));
  };
  const auto inner = [](const R& x, const R& y) {
    return fraction(1, 20) * (y * y * (R(3) * x * x + R(1)) + R(2) * x * y * (x * x + R(3)) + R(3) * x * x + R(5));
  };
  return {end(a), next(a, b), inner(a, b), inner(b, a), next(b, a), end(b)};
}

std::array<HermiteForm, 6> hermite_circle_weighted_points(const RationalFunction& a, const RationalFunction& b) {
  const auto mu = hermite_circle_weights(a, b);
  const R h = b - a;
  const R zero;
  const R first = fraction(1, 20) * h;
  const R second = fraction(1, 80) * h * h;
  std::array<HermiteForm, 6> q;
  q[0] = {mu[0], zero, zero, zero, zero, zero};
  q[1] = {mu[1], zero, R(2) * first * mu[0], zero, zero, zero};
  q[2] = {mu[2], zero, first * (R(5) * mu[1] - mu[0]), zero, second * mu[0], zero};
  q[3] = {zero, mu[3], zero, -first * (R(5) * mu[4] - mu[5]), zero, second * mu[5]};
  q[4] = {zero, mu[4], zero, -R(2) * first * mu[5], zero, zero};
  q[5] = {zero, mu[5], zero, zero, zero, zero};
  return q;
}

HermiteRule hermite_circle_segment(const RationalFunction& a, const RationalFunction& b, const RationalFunction& x) {
  const R h = b - a;
  const R tau = (x - a) / h;
  const R rate = R(2) / h;  // d tau / d t
  const auto q = hermite_circle_weighted_points(a, b);
  const std::vector<HermiteForm> n0(q.begin(), q.end());
  const auto n1 = differences(n0, R(5) * rate);
  const auto n2 = differences(n1, R(4) * rate);
  // The global denominator and its derivatives in t.
  const R d = (R(1) + x * x).pow(2) / R(4);
  const R d1 = R(2) * x * (R(1) + x * x);
  const R d2 = R(4) * (R(1) + R(3) * x * x);
  HermiteRule c;
  c[0] = combination(d.inverse(), blend(n0, tau), R(), c[0]);
  c[1] = combination(d.inverse(), blend(n1, tau), -d1 / d, c[0]);
  c[2] = combination(R(1), combination(d.inverse(), blend(n2, tau), -R(2) * d1 / d, c[1]), -d2 / d, c[0]);
  return c;
}

HermiteRule hermite_circle_rule(const RationalFunction& v, const RationalFunction& u) {
  const auto doubled = [](const R& s) { return R(2) * s / (R(1) - s * s); };
  return hermite_circle_segment(doubled(v), doubled(u), (u + v) / (R(1) - u * v));
}

HermiteRule hermite_circle_rule(const RationalFunction& v, const RationalFunction& u, const RationalFunction& w,
                                HermiteTension tension) {
  if (tension == HermiteTension::printed) return hermite_circle_rule(v, w * u + (R(1) - w) * v);
  HermiteRule c = hermite_circle_rule(v, u);
  for (size_t i = 0; i < c.size(); ++i)
    for (size_t j = 0; j < c[i].size(); ++j) c[i][j] = c[i][j] * w.pow(static_cast<long>(j / 2) - static_cast<long>(i));
  return c;
}

namespace {

const HermiteRule& symbolic_rule(HermiteTension tension) {
  const auto derive = [](HermiteTension t) {
    const R v = R::variable(local_name("s", 0));
    const R u = R::variable(local_name("s", 1));
    const R w = R::variable("w");
    if (t == HermiteTension::c2) return hermite_circle_rule(v, u, w, t);
    // The same as hermite_circle_rule(v, u, w, t), by substitution into the rule without tension.
    HermiteRule c = hermite_circle_rule(v, u);
    for (auto& row : c)
      for (auto& x : row) x = x.substitute(local_name("s", 1), w * u + (R(1) - w) * v);
    return c;
  };
  static const HermiteRule printed = derive(HermiteTension::printed);
  static const HermiteRule c2 = derive(HermiteTension::c2);
  return tension == HermiteTension::printed ? printed : c2;
}

std::vector<Stencil> phases(HermiteTension tension) {
  const HermiteRule& rule = symbolic_rule(tension);
  Stencil keep;
  keep.blocks.push_back({R(1), R(), R(), R(), R(1), R(), R(), R(), R(1)});
  Stencil insert;
  for (size_t end = 0; end < 2; ++end) {
    std::vector<R> block;
    for (const auto& row : rule)
      for (size_t order = 0; order < 3; ++order) block.push_back(row[2 * order + end]);
    insert.blocks.push_back(std::move(block));
  }
  return {std::move(keep), std::move(insert)};
}

}  // namespace

Scheme hermite_circle(const Rational& w, HermiteTension tension) {
  if (w.sign() <= 0) bad_input("hermite-circle: the tension w must be positive", w.to_string());
  Scheme s;
  s.block = 3;
  s.source = "hermite2010, sections 2 to 4";
  Parameter ends;
  ends.name = "s";
  ends.scope = Parameter::Scope::local;
  ends.offsets = {0, 1};
  ends.help = "tan(sigma/8) at the two ends of an edge";
  Parameter tension_parameter;
  tension_parameter.name = "w";
  tension_parameter.domain = Domain{Rational(0), std::nullopt};
  tension_parameter.default_value = w.to_string();
  tension_parameter.help = "tension";
  s.parameters = {std::move(ends), std::move(tension_parameter)};
  s.phases = phases(tension);
  return s;
}

std::optional<HermiteTension> hermite_tension(const Scheme& scheme) {
  if (scheme.block != 3 || scheme.phases.size() != 2) return std::nullopt;
  for (const auto tension : {HermiteTension::printed, HermiteTension::c2}) {
    const auto own = phases(tension);
    bool same = true;
    for (size_t i = 0; i < own.size(); ++i)
      same = same && own[i].lowest == scheme.phases[i].lowest && own[i].blocks == scheme.phases[i].blocks;
    if (same) return tension;
  }
  return std::nullopt;
}

}  // namespace twoscale
