// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/analysis/junction.hpp"

#include <algorithm>

#include "twoscale/symbolic/error.hpp"

namespace twoscale::analysis {

namespace {

using Values = std::vector<std::pair<std::string, RationalFunction>>;

RationalFunction at_sample(RationalFunction f, const std::map<std::string, Rational>& sample) {
  for (const auto& [name, value] : sample) f = f.substitute(name, value);
  return f;
}

// The stencil of the new points with the values put in; the piece is the one at the sample.
Stencil stencil_at(const Scheme& scheme, const Values& values, const std::map<std::string, Rational>& sample) {
  std::vector<std::pair<std::string, Rational>> numbers;
  for (const auto& [name, value] : values) {
    const auto c = at_sample(value, sample).constant();
    if (!c) bad_input("a value is needed at which the piece of the rule is chosen", value.to_string());
    numbers.emplace_back(name, *c);
  }
  const auto* phases = &scheme.phases;
  for (const auto& piece : scheme.pieces)
    if (RationalFunction(piece.where).evaluate(numbers)->sign() >= 0) {
      phases = &piece.phases;
      break;
    }
  Stencil s = (*phases)[1];
  // If a value contains a name of the rule, the names are changed first. Knot intervals and constants go first: they
  // make everything smaller.
  bool clash = false;
  for (const auto& [name, value] : values)
    for (const auto& v : value.variables())
      clash = clash || std::any_of(values.begin(), values.end(), [&](const auto& o) { return o.first == v; });
  const std::string prefix = clash ? "at_" : "";
  Values ordered = values;
  std::stable_sort(ordered.begin(), ordered.end(), [](const auto& x, const auto& y) {
    return x.second.constant().has_value() && !y.second.constant().has_value();
  });
  for (auto& block : s.blocks) {
    if (clash)
      for (const auto& [name, value] : values)
        block[0] = block[0].substitute(name, RationalFunction::variable(prefix + name));
    for (const auto& [name, value] : ordered) {
      for (const auto& [factor, exponent] : block[0].denominator_factors())
        if (RationalFunction(factor).substitute(prefix + name, value).is_zero())
          bad_input("the rule has a pole at this value", name + "=" + value.to_string());
      block[0] = block[0].substitute(prefix + name, value);
    }
  }
  return s;
}

// Value of a local parameter at an edge: those of the edges -1 and 0 are inherited, intervals are 1 left of the vertex.
RationalFunction value_at(const Parameter& p, long edge, const RationalFunction& alpha, const RationalFunction& left,
                          const RationalFunction& right) {
  if (!p.rest) return edge >= 0 ? alpha : RationalFunction(1);
  return edge == -1 ? left : edge == 0 ? right : RationalFunction(*p.rest);
}

// rule(edge): the stencil of the new point of the edge, all from lowest to highest.
template <class Rule>
Junction assembled(long lowest, long highest, const RationalFunction& alpha, const Rule& rule) {
  // f_{2j+1} reads j + lowest .. j + highest: the points -h..h suffice for themselves.
  const long h = std::max(1 - 2 * lowest, 2 * highest - 1);
  Junction r;
  r.matrix.lowest = -h;
  const auto size = static_cast<std::size_t>(2 * h + 1);
  r.matrix.entries = SymbolicMatrix(size, size);
  for (long j = -h; j <= h; ++j) r.knots.push_back(RationalFunction(j) * (j > 0 ? alpha : RationalFunction(1)));
  for (long i = -h; i <= h; ++i) {
    const auto row = static_cast<std::size_t>(i + h);
    if (i % 2 == 0) {
      r.matrix.entries(row, static_cast<std::size_t>(i / 2 + h)) = 1;
      continue;
    }
    const long edge = (i - 1) / 2 - (i < 0 && (i - 1) % 2 != 0 ? 1 : 0);
    const Stencil s = rule(edge);
    for (std::size_t c = 0; c < s.blocks.size(); ++c) {
      const long column = edge + s.lowest + static_cast<long>(c);
      if (!s.blocks[c][0].is_zero()) r.matrix.entries(row, static_cast<std::size_t>(column + h)) = s.blocks[c][0];
    }
  }
  for (bool kept = true; kept && r.order < static_cast<long>(size);) {
    std::vector<RationalFunction> power, smaller;
    for (const auto& x : r.knots) {
      power.push_back(x.pow(r.order));
      smaller.push_back(RationalFunction(Rational(2).pow(-r.order)) * power.back());
    }
    kept = product(r.matrix.entries, power) == smaller;
    if (kept) ++r.order;
  }
  return r;
}

}  // namespace

Junction junction(const Scheme& scheme, const RationalFunction& alpha, const RationalFunction& left,
                  const RationalFunction& right, const std::map<std::string, Rational>& sample) {
  if (is_uniform(scheme) || scheme.block != 1 || scheme.arity != 2)
    bad_input("this scheme has no rules on knots, so no junction", scheme.id);
  const auto& odd = scheme.phases[1];
  const long highest = odd.lowest + static_cast<long>(odd.blocks.size()) - 1;
  return assembled(odd.lowest, highest, alpha, [&](long edge) {
    Values values;
    for (const auto& p : scheme.parameters)
      for (const long offset : p.offsets)
        values.emplace_back(local_name(p.name, offset), value_at(p, edge + offset, alpha, left, right));
    return stencil_at(scheme, values, sample);
  });
}

Junction junction(const SampledScheme& scheme, const Rational& alpha, const Rational& left, const Rational& right) {
  if (alpha.sign() <= 0) bad_input("the ratio of the intervals must be positive", alpha.to_string());
  const Scheme outline = scheme.outline();
  return assembled(scheme.lowest(), scheme.highest(), alpha, [&](long edge) {
    std::vector<std::vector<Rational>> numbers;  // d, lambda
    for (const auto& p : outline.parameters) {
      numbers.emplace_back();
      for (const long offset : p.offsets)
        numbers.back().push_back(*value_at(p, edge + offset, alpha, left, right).constant());
    }
    Stencil s{scheme.lowest(), {}};
    for (const auto& w : scheme.weights(numbers[0], numbers[1])) s.blocks.push_back({w});
    return s;
  });
}

Spectrum spectrum(const Junction& j) { return spectrum(j.matrix, 2, j.knots, j.order); }

}  // namespace twoscale::analysis
