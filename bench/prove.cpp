// SPDX-License-Identifier: GPL-3.0-or-later
// Deciding all default claims of the 2l-point schemes, certificate included. The scheme is given.
#include <benchmark/benchmark.h>

#include "twoscale/analysis/prove.hpp"
#include "twoscale/symbolic/catalog.hpp"

namespace twoscale::bench {
namespace {

void prove(benchmark::State& state, const char* family) {
  const Scheme scheme =
      make_scheme(std::string("interpolating:family=") + family + ",l=" + std::to_string(state.range(0)));
  const std::vector<Claim> claims = analysis::default_claims(scheme);
  for (auto _ : state) benchmark::DoNotOptimize(analysis::prove(scheme, claims));
  state.SetLabel(scheme.id);
}

BENCHMARK_CAPTURE(prove, mixed, "mixed")->ArgName("l")->DenseRange(2, 8);
BENCHMARK_CAPTURE(prove, harmonic, "harmonic")->ArgName("l")->DenseRange(2, 8);
BENCHMARK_CAPTURE(prove, resonant, "resonant")->ArgName("l")->DenseRange(2, 8);

}  // namespace
}  // namespace twoscale::bench
