// SPDX-License-Identifier: GPL-3.0-or-later
// Mask tables of the 6-point schemes: 60 levels, the limit row and the tail bound, every digit proved, as decimals.
#include <benchmark/benchmark.h>

#include "twoscale/lowering/lower.hpp"
#include "twoscale/symbolic/catalog.hpp"

namespace twoscale::bench {
namespace {

constexpr unsigned levels = 60;

void table(benchmark::State& state, const char* family, const char* v0) {
  const Scheme scheme = make_scheme(std::string("interpolating:family=") + family + ",l=3");
  lowering::LowerOptions options;
  options.levels = levels;
  options.digits = state.range(0);
  // Binding is part of the job: what it has enclosed before must not help.
  for (auto _ : state)
    benchmark::DoNotOptimize(lowering::lower(scheme, lowering::bind(scheme, v0, std::nullopt, {}), options));
  state.SetLabel(scheme.id + " " + v0);
}

#define TWOSCALE_TABLE(family)                                                                            \
  BENCHMARK_CAPTURE(table, family/-2/5, #family, "-2/5")->ArgName("digits")->Arg(50)->Arg(200)->Arg(1000); \
  BENCHMARK_CAPTURE(table, family/cos(2*pi/7), #family, "cos(2*pi/7)")->ArgName("digits")->Arg(50)->Arg(200)->Arg(1000)

TWOSCALE_TABLE(mixed);
TWOSCALE_TABLE(harmonic);
TWOSCALE_TABLE(resonant);

}  // namespace
}  // namespace twoscale::bench
