// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/analysis/hermite.hpp"

#include <algorithm>

#include "twoscale/symbolic/error.hpp"

namespace twoscale::analysis {

namespace {

long floor_division(long a, long b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

const std::string step = "h";

// The value at h = 0; nullopt at a pole.
std::optional<RationalFunction> at_zero(const RationalFunction& f) {
  for (const auto& [factor, exponent] : f.denominator_factors())
    if (factor.substitute(step, Polynomial(0)).is_zero()) return std::nullopt;
  return f.substitute(step, RationalFunction(0));
}

// d^k/dx^k of x^n/n!... at j: c_n = 1/n! is carried by the caller.
Rational falling_power(long n, long k, long j) {
  if (k > n) return 0;
  Rational r = Rational(j).pow(n - k);
  for (long i = 0; i < k; ++i) r *= Rational(n - i);
  return r;
}

Rational factorial(long n) {
  Rational r = 1;
  for (long i = 2; i <= n; ++i) r *= Rational(i);
  return r;
}

}  // namespace

HermiteMask hermite_mask(const Scheme& scheme) {
  if (scheme.block < 2) bad_input("the scheme carries no derivatives", scheme.id);
  HermiteMask mask;
  mask.arity = scheme.arity;
  mask.block = static_cast<std::size_t>(scheme.block);
  mask.phases = scheme.phases;
  const Parameter* local = nullptr;
  for (const auto& p : scheme.parameters) {
    if (p.scope == Parameter::Scope::level) bad_input("the scheme depends on the level", p.name);
    if (p.scope != Parameter::Scope::local) continue;
    if (local != nullptr || p.offsets != std::vector<long>{0, 1})
      bad_input("small steps are known for one local parameter, read at the two ends of an edge", p.name);
    local = &p;
  }
  if (local != nullptr) {
    mask.parameter = local->name;
    const RationalFunction s = RationalFunction::variable(local->name);
    const RationalFunction h = RationalFunction::variable(step);
    for (auto& phase : mask.phases)
      for (auto& block : phase.blocks)
        for (std::size_t a = 0; a < mask.block; ++a)
          for (std::size_t b = 0; b < mask.block; ++b) {
            auto& entry = block[a * mask.block + b];
            const auto limit =
                at_zero(entry.substitute(local_name(local->name, 1), s + h).substitute(local_name(local->name, 0), s) *
                        h.pow(static_cast<long>(a) - static_cast<long>(b)));
            if (!limit) bad_input("the rules have no limit for small steps", scheme.id);
            entry = *limit;
          }
  }
  for (auto& phase : mask.phases)
    for (auto& block : phase.blocks)
      for (std::size_t i = 0; i < block.size(); ++i)
        block[i] = block[i] * RationalFunction(Rational(mask.arity).pow(-static_cast<long>(i / mask.block)));
  return mask;
}

SpectralCondition spectral_condition(const HermiteMask& mask, long most) {
  SpectralCondition r;
  r.searched = most;
  const long d = static_cast<long>(mask.block) - 1;
  const long m = mask.arity;
  r.reproduces = true;
  for (long n = 0; n <= most; ++n) {
    // Unknowns: the coefficients a_0 .. a_{n-1} of p_n, c_n if n <= d, and -1 for the right side.
    const bool scale = n <= d && n > 0;
    const std::size_t unknowns = static_cast<std::size_t>(n) + (scale ? 1U : 0U);
    const Rational lead = factorial(n).inverse();
    // Column of V_n(j)_k by unknowns: c_k j^(e) for a_e; the last column is what does not depend on unknowns.
    const auto row_of = [&](long j, long k) {
      std::vector<RationalFunction> row(unknowns + 1);
      if (k == n && scale) {
        row[static_cast<std::size_t>(n)] = RationalFunction(1);  // c_n p_n^(n) = c_n
        return row;
      }
      if (k > n) return row;
      const RationalFunction& c = r.scales[static_cast<std::size_t>(k)];
      for (long e = 0; e < n; ++e) row[static_cast<std::size_t>(e)] = c * RationalFunction(falling_power(e, k, j));
      row[unknowns] = c * RationalFunction(lead * falling_power(n, k, j));
      return row;
    };
    if (n == 0) r.scales.assign(1, RationalFunction(1));
    std::vector<std::vector<RationalFunction>> equations;
    for (long q = 0; q <= n; ++q)
      for (long phase = 0; phase < m; ++phase) {
        const Stencil& stencil = mask.phases[static_cast<std::size_t>(phase)];
        for (long a = 0; a <= d; ++a) {
          std::vector<RationalFunction> sum(unknowns + 1);
          for (std::size_t t = 0; t < stencil.blocks.size(); ++t)
            for (long b = 0; b <= d; ++b) {
              const auto& entry = stencil.blocks[t][static_cast<std::size_t>(a * (d + 1) + b)];
              if (entry.is_zero()) continue;
              const auto row = row_of(q + stencil.lowest + static_cast<long>(t), b);
              for (std::size_t i = 0; i <= unknowns; ++i)
                if (!row[i].is_zero()) sum[i] += entry * row[i];
            }
          const auto image = row_of(m * q + phase, a);
          const RationalFunction factor(Rational(m).pow(-n));
          for (std::size_t i = 0; i <= unknowns; ++i) sum[i] = sum[i] - factor * image[i];
          equations.push_back(std::move(sum));
        }
      }
    SymbolicMatrix system(equations.size(), unknowns + 1);
    for (std::size_t i = 0; i < equations.size(); ++i)
      for (std::size_t j = 0; j <= unknowns; ++j) system(i, j) = equations[i][j];
    std::vector<RationalFunction> solution;
    bool plain = false;
    {
      // x^n/n! itself, if it is one of the solutions.
      SymbolicMatrix own(equations.size(), scale ? 2 : 1);
      for (std::size_t i = 0; i < equations.size(); ++i) {
        if (scale) own(i, 0) = equations[i][static_cast<std::size_t>(n)];
        own(i, scale ? 1 : 0) = equations[i][unknowns];
      }
      for (const auto& x : kernel(own))
        if (!x.back().is_zero()) {
          plain = true;
          solution.assign(unknowns, RationalFunction());
          if (scale) solution.back() = x[0] / x.back();
        }
    }
    if (!plain)
      for (const auto& x : kernel(system))
        if (!x.back().is_zero()) {
          solution.clear();
          for (std::size_t i = 0; i < unknowns; ++i) solution.push_back(x[i] / x.back());
          plain = false;
          r.reproduces = false;
          break;
        }
    if (solution.size() != unknowns) break;
    if (unknowns == 0 && !plain) break;
    r.order = n;
    if (scale) {
      r.scales.push_back(solution.back());
      solution.pop_back();
    }
    solution.emplace_back(lead);
    r.polynomials.push_back(std::move(solution));
  }
  if (r.order < 0) r.scales.clear();
  r.reproduces = r.reproduces && r.order >= 0;
  r.consistent = r.order >= d;
  for (std::size_t k = 2; k < r.scales.size(); ++k)
    r.consistent = r.consistent && r.scales[k] == r.scales[1].pow(static_cast<long>(k));
  return r;
}

HermiteMask rescaled(const HermiteMask& mask, const std::vector<RationalFunction>& scales) {
  HermiteMask r = mask;
  if (scales.size() != mask.block) bad_input("one scale for each derivative is needed", std::to_string(scales.size()));
  for (auto& phase : r.phases)
    for (auto& block : phase.blocks)
      for (std::size_t i = 0; i < block.size(); ++i)
        block[i] = block[i] * scales[i % mask.block] / scales[i / mask.block];
  return r;
}

LocalMatrix local_matrix(const HermiteMask& mask) {
  // Support of A: i = r - m h.
  const long m = mask.arity;
  long low = 0;
  long high = 0;
  for (long r = 0; r < m; ++r) {
    const Stencil& s = mask.phases[static_cast<std::size_t>(r)];
    const long last = s.lowest + static_cast<long>(s.blocks.size()) - 1;
    low = std::min(low, r - m * last);
    high = std::max(high, r - m * s.lowest);
  }
  LocalMatrix result;
  result.lowest = -floor_division(high, m - 1);
  const long top = floor_division(-low, m - 1);
  const auto vertices = static_cast<std::size_t>(top - result.lowest + 1);
  result.entries = SymbolicMatrix(vertices * mask.block, vertices * mask.block);
  for (long i = result.lowest; i <= top; ++i) {
    const long q = floor_division(i, m);
    const Stencil& s = mask.phases[static_cast<std::size_t>(i - m * q)];
    for (std::size_t t = 0; t < s.blocks.size(); ++t) {
      const long j = q + s.lowest + static_cast<long>(t);
      if (j < result.lowest || j > top) continue;
      for (std::size_t e = 0; e < s.blocks[t].size(); ++e)
        result.entries(static_cast<std::size_t>(i - result.lowest) * mask.block + e / mask.block,
                       static_cast<std::size_t>(j - result.lowest) * mask.block + e % mask.block) = s.blocks[t][e];
    }
  }
  return result;
}

}  // namespace twoscale::analysis
