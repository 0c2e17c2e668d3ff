// SPDX-License-Identifier: GPL-3.0-or-later
// Deciding all default claims of the 2l-point schemes, certificate included; and the zero and value conditions of their
// space alone. The scheme is given.
#include <benchmark/benchmark.h>

#include "twoscale/analysis/prove.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/symbol.hpp"

namespace twoscale::bench {
namespace {

void prove(benchmark::State& state, const char* family) {
  const Scheme scheme =
      make_scheme(std::string("interpolating:family=") + family + ",l=" + std::to_string(state.range(0)));
  const std::vector<Claim> claims = analysis::default_claims(scheme);
  for (auto _ : state) benchmark::DoNotOptimize(analysis::prove(scheme, claims));
  state.SetLabel(scheme.id);
}

// zeta has its zeros at the -z_i of the space, to their orders: prod (z^2 + 2 w_i z + 1) divides it. Its even part is
// 1, so that the values at the z_i follow: zeta(z) + zeta(-z) = 2.
void conditions(benchmark::State& state, const char* family) {
  const Scheme scheme =
      make_scheme(std::string("interpolating:family=") + family + ",l=" + std::to_string(state.range(0)));
  const Laurent zeta = symbol(scheme);
  for (auto _ : state) {
    Laurent zeros = Laurent::monomial(0);
    for (const Polynomial& w : cosh_nodes(*scheme.space)) zeros = zeros * Laurent(0, {1, w + w, 1});
    const bool holds = Laurent::quotient(zeta, zeros).has_value() && zeta.subsymbol(2, 0) == Laurent::monomial(0);
    if (!holds) state.SkipWithError("the conditions do not hold");
  }
  state.SetLabel(scheme.id);
}

#define TWOSCALE_FAMILIES(job)                                                   \
  BENCHMARK_CAPTURE(job, mixed, "mixed")->ArgName("l")->DenseRange(2, 10);       \
  BENCHMARK_CAPTURE(job, harmonic, "harmonic")->ArgName("l")->DenseRange(2, 10); \
  BENCHMARK_CAPTURE(job, resonant, "resonant")->ArgName("l")->DenseRange(2, 10)

TWOSCALE_FAMILIES(prove);
TWOSCALE_FAMILIES(conditions);

}  // namespace
}  // namespace twoscale::bench
