// SPDX-License-Identifier: GPL-3.0-or-later
// A closed polygon of 10^4 points, 8 levels of a 6-point scheme, D = 1..3 components, into a buffer that is kept;
// and how fast this machine writes that much memory, the bound of any program that stores its result.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstring>

#include "twoscale/kernels/refine.hpp"
#include "twoscale/lowering/lower.hpp"
#include "twoscale/symbolic/catalog.hpp"

namespace twoscale::bench {
namespace {

constexpr std::size_t points = 10000;
constexpr int levels = 8;
constexpr std::size_t fine_points = points << levels;

void refine(benchmark::State& state, const char* family) {
  const auto dim = static_cast<std::size_t>(state.range(0));
  const Scheme scheme = make_scheme(std::string("interpolating:family=") + family + ",l=3");
  lowering::LowerOptions options;
  options.levels = levels;
  options.digits = 0;
  const kernels::MaskTable table = lowering::lower(scheme, lowering::bind(scheme, "1/2", std::nullopt, {}), options);
  kernels::Refiner<double> refiner(table);
  std::vector<double> in(points * dim), out(fine_points * dim);
  for (std::size_t i = 0; i < in.size(); ++i) in[i] = std::sin(static_cast<double>(i));
  for (auto _ : state) {
    refiner.refine(in, dim, levels, kernels::Boundary::closed, out);
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * out.size() * sizeof(double)));
}

void write(benchmark::State& state) {
  std::vector<double> out(fine_points * static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) {
    std::memset(out.data(), 0, out.size() * sizeof(double));
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * out.size() * sizeof(double)));
}

BENCHMARK_CAPTURE(refine, harmonic, "harmonic")->ArgName("D")->DenseRange(1, 3);
BENCHMARK(write)->ArgName("D")->DenseRange(1, 3);

}  // namespace
}  // namespace twoscale::bench
