// SPDX-License-Identifier: GPL-3.0-or-later
// Mask tables of the 6-point schemes: 60 levels, the limit row and the tail bound, every digit proved, as decimals.
#include <benchmark/benchmark.h>

#include "twoscale/lowering/lower.hpp"
#include "twoscale/symbolic/catalog.hpp"

namespace twoscale::bench {
namespace {

void table(benchmark::State& state, const char* family, const char* v0, unsigned levels) {
  const Scheme scheme = make_scheme(std::string("interpolating:family=") + family + ",l=3");
  lowering::LowerOptions options;
  options.levels = levels;
  options.digits = state.range(0);
  // Binding is part of the job: what it has enclosed before must not help.
  for (auto _ : state)
    benchmark::DoNotOptimize(lowering::lower(scheme, lowering::bind(scheme, v0, std::nullopt, {}), options));
  state.SetLabel(scheme.id + " " + v0);
}

#define TWOSCALE_TABLE_AT(family, v0)               \
  BENCHMARK_CAPTURE(table, family, #family, v0, 60) \
      ->Name("table/" #family "/" v0)               \
      ->ArgName("digits")                           \
      ->Arg(50)                                     \
      ->Arg(200)                                    \
      ->Arg(1000)                                   \
      ->Arg(10000)
#define TWOSCALE_TABLE(family)       \
  TWOSCALE_TABLE_AT(family, "-2/5"); \
  TWOSCALE_TABLE_AT(family, "cos(2*pi/7)")

TWOSCALE_TABLE(mixed);
TWOSCALE_TABLE(harmonic);
TWOSCALE_TABLE(resonant);

// Growth with the number K of levels, 50 digits.
void levels(benchmark::State& state) { table(state, "mixed", "-2/5", static_cast<unsigned>(state.range(1))); }
BENCHMARK(levels)->Name("levels/mixed")->ArgNames({"digits", "K"})->ArgsProduct({{50}, {60, 120, 240, 480, 960}});

}  // namespace
}  // namespace twoscale::bench
