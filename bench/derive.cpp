// SPDX-License-Identifier: GPL-3.0-or-later
// From a space of dimension 2l to the exact symbol zeta, in process and without printing, by every route that there is;
// and what GiNaC's own solver takes for the linear system alone. The label of a run is its space.
#include <benchmark/benchmark.h>
#include <ginac/ginac.h>

#include <string_view>

#include "spaces.hpp"
#include "twoscale/symbolic/expression.hpp"
#include "twoscale/symbolic/mary_interpolatory.hpp"
#include "twoscale/symbolic/symbol.hpp"

namespace twoscale::bench {
namespace {

// job(space) again and again.
template <class Job>
void over_space(benchmark::State& state, const char* name, Job job) {
  const Space s = space(name, static_cast<unsigned>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(job(s));
  state.SetLabel(s.to_string());
}

// What `twoscale derive` and every recipe call.
void derive(benchmark::State& state, const char* name) {
  over_space(state, name, [](const Space& s) { return interpolating_symbol(s); });
}

// The closed forms, nothing multiplied out: exponent counts, or the 2n numbers of two nodes.
void factored(benchmark::State& state, const char* name) {
  if (std::string_view(name) == "harmonic")
    over_space(state, name, interpolating_coefficients_harmonic);
  else
    over_space(state, name, interpolating_two_nodes_factored);
}

// The same for arity 3: an even and an odd Hermite problem for the one phase that symmetry leaves.
void ternary(benchmark::State& state, const char* name) {
  over_space(state, name, [](const Space& s) { return interpolating_symbol(s, 3); });
}

// The engine for any space, where `derive` has a closed form.
void generic(benchmark::State& state, const char* name) {
  over_space(state, name, interpolating_symbol_by_divided_differences);
}

// The Newton-basis system, its solution, and zeta = sigma omega.
void hessenberg(benchmark::State& state, const char* name) {
  over_space(state, name, [](const Space& s) { return bspline_symbol(s) * hessenberg_system(s).omega; });
}

// The folded l x l system by fraction-free elimination, and zeta = sigma omega.
void folded(benchmark::State& state, const char* name) {
  over_space(state, name, [](const Space& s) { return bspline_symbol(s) * omega_from_folded(folded_system(s)); });
}

// GiNaC's lsolve by Gauss, its fastest algorithm here (what it chooses by itself is 15 times slower at l = 4), and
// normal() on the folded system; setting it up is not counted.
void ginac(benchmark::State& state, const char* name) {
  const Space s = space(name, static_cast<unsigned>(state.range(0)));
  const FoldedSystem system = folded_system(s);
  Symbols symbols;
  GiNaC::lst equations, unknowns;
  for (size_t i = 0; i < system.rhs.size(); ++i) unknowns.append(GiNaC::symbol("w" + std::to_string(i)));
  for (size_t r = 0; r < system.rhs.size(); ++r) {
    GiNaC::ex sum;
    for (size_t i = 0; i < system.rhs.size(); ++i) sum += to_ginac(system.matrix[r][i], symbols) * unknowns.op(i);
    equations.append(sum == to_ginac(system.rhs[r], symbols));
  }
  for (auto _ : state) {
    const GiNaC::ex solved = GiNaC::lsolve(equations, unknowns, GiNaC::solve_algo::gauss);
    for (size_t i = 0; i < solved.nops(); ++i) benchmark::DoNotOptimize(solved.op(i).rhs().normal());
  }
  state.SetLabel(s.to_string());
}

#define TWOSCALE_FAMILIES(job, last)                                               \
  BENCHMARK_CAPTURE(job, mixed, "mixed")->ArgName("l")->DenseRange(2, last);       \
  BENCHMARK_CAPTURE(job, harmonic, "harmonic")->ArgName("l")->DenseRange(2, last); \
  BENCHMARK_CAPTURE(job, resonant, "resonant")->ArgName("l")->DenseRange(2, last)
#define TWOSCALE_OTHERS(job, one, several)                                                    \
  BENCHMARK_CAPTURE(job, lacunary, "lacunary")->ArgName("l")->DenseRange(2, one);             \
  BENCHMARK_CAPTURE(job, multiplicities, "multiplicities")->ArgName("l")->DenseRange(2, one); \
  BENCHMARK_CAPTURE(job, two_frequencies, "two-frequencies")                                  \
      ->Name(#job "/two-frequencies")                                                         \
      ->ArgName("l")                                                                          \
      ->DenseRange(2, several)

TWOSCALE_FAMILIES(derive, 16);
TWOSCALE_OTHERS(derive, 12, 8);
BENCHMARK_CAPTURE(factored, mixed, "mixed")->ArgName("l")->DenseRange(2, 10)->Arg(16)->Arg(32)->Arg(64);
BENCHMARK_CAPTURE(factored, harmonic, "harmonic")->ArgName("l")->DenseRange(2, 10)->Arg(16)->Arg(32)->Arg(64);
BENCHMARK_CAPTURE(factored, resonant, "resonant")->ArgName("l")->DenseRange(2, 10)->Arg(16)->Arg(32)->Arg(64);
TWOSCALE_FAMILIES(ternary, 12);
TWOSCALE_OTHERS(ternary, 8, 5);
TWOSCALE_FAMILIES(generic, 12);
TWOSCALE_FAMILIES(hessenberg, 8);
TWOSCALE_OTHERS(hessenberg, 8, 5);
TWOSCALE_FAMILIES(folded, 8);
TWOSCALE_OTHERS(folded, 8, 5);
TWOSCALE_FAMILIES(ginac, 8);
TWOSCALE_OTHERS(ginac, 5, 4);

}  // namespace
}  // namespace twoscale::bench
