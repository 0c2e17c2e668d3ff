// SPDX-License-Identifier: GPL-3.0-or-later
// Refinement against the rate at which this process can write: every repetition writes the output with streaming stores
// alone, then refines into it; `of_write` is the ratio of the medians. A buffer that is kept, huge pages where there
// are.
//
// One thread: CPU time of the thread. More: wall clock. Peers in the same process: a product with a sparse matrix of
// all levels (Eigen), the stencils of all levels by OpenSubdiv's CPU evaluator in float.
#include <benchmark/benchmark.h>
#include <emmintrin.h>

#include <Eigen/Sparse>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <thread>

#include "twoscale/kernels/hermite.hpp"
#include "twoscale/kernels/nonuniform.hpp"
#include "twoscale/kernels/refine.hpp"
#include "twoscale/kernels/surface.hpp"
#include "twoscale/lowering/lower.hpp"
#include "twoscale/symbolic/catalog.hpp"
#ifdef TWOSCALE_OPENSUBDIV
#include <opensubdiv/osd/cpuEvaluator.h>
#endif

namespace twoscale::bench {
namespace {

using kernels::Boundary;
using kernels::Buffer;

// Zeros in huge pages.
template <class Real>
kernels::Buffer<Real> zeros(std::size_t count) {
  kernels::Buffer<Real> out = kernels::BufferPool().take<Real>(count);
  std::ranges::fill(out.span(), Real(0));
  return out;
}

void write(char* to, std::size_t bytes) {
  const __m128i value = _mm_set1_epi8(1);
  for (std::size_t i = 0; i + 64 <= bytes; i += 64)
    for (std::size_t j = 0; j < 64; j += 16) _mm_stream_si128(reinterpret_cast<__m128i*>(to + i + j), value);
  _mm_sfence();
}

void write(char* to, std::size_t bytes, int threads) {
  if (threads == 1) return write(to, bytes);
  std::vector<std::thread> pool;
  const std::size_t part = bytes / static_cast<std::size_t>(threads) / 64 * 64;
  for (int i = 0; i < threads; ++i) pool.emplace_back([=] { write(to + part * static_cast<std::size_t>(i), part); });
  for (std::thread& t : pool) t.join();
}

double now(int threads) {
  if (threads != 1) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double median(std::vector<double> x) {
  std::nth_element(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2), x.end());
  return x[x.size() / 2];
}

template <class Real, class Job>
void beside_write(benchmark::State& state, Buffer<Real>& out, int threads, Job&& job) {
  std::vector<double> writing, working;
  job();
  for (auto _ : state) {
    const double start = now(threads);
    write(reinterpret_cast<char*>(out.span().data()), out.span().size_bytes(), threads);
    const double between = now(threads);
    job();
    const double end = now(threads);
    writing.push_back(between - start);
    working.push_back(end - between);
    state.SetIterationTime(std::max(1e-9, end - between));
  }
  state.SetBytesProcessed(
      static_cast<std::int64_t>(state.iterations() * static_cast<std::int64_t>(out.span().size_bytes())));
  state.counters["of_write"] = median(writing) / median(working);
}

kernels::MaskTable table(const std::string& id, const std::optional<std::string>& v0, int levels) {
  const Scheme scheme = make_scheme(id);
  lowering::LowerOptions options;
  options.levels = static_cast<unsigned>(levels);
  options.digits = 0;
  options.extension = scheme.space.has_value();
  return lowering::lower(scheme, lowering::bind(scheme, v0, std::nullopt, {}), options);
}

template <class Real>
std::vector<Real> polygon(std::size_t n, std::size_t dim) {
  std::vector<Real> in(n * dim);
  for (std::size_t i = 0; i < in.size(); ++i) in[i] = static_cast<Real>(std::sin(static_cast<double>(i)));
  return in;
}

constexpr const char* six_point = "interpolating:family=harmonic,l=3";

// D, threads.
template <class Real>
void curve(benchmark::State& state, std::size_t n, int levels, Boundary boundary, const char* id, const char* v0) {
  const auto dim = static_cast<std::size_t>(state.range(0));
  const int threads = static_cast<int>(state.range(1));
  kernels::Refiner<Real> refiner(table(id, v0 == nullptr ? std::nullopt : std::optional<std::string>(v0), levels));
  refiner.set_threads(threads);
  const std::vector<Real> in = polygon<Real>(n, dim);
  Buffer<Real> out = zeros<Real>(refiner.output(n, levels, boundary).count * dim);
  beside_write(state, out, threads, [&] { refiner.refine(in, dim, levels, boundary, out.span()); });
}

void shapes(benchmark::internal::Benchmark* b) {
  b->ArgNames({"D", "threads"})->ArgsProduct({{1, 2, 3, 4}, {1, 2}})->UseManualTime();
}
void plane(benchmark::internal::Benchmark* b) {
  b->ArgNames({"D", "threads"})->ArgsProduct({{2}, {1, 2}})->UseManualTime();
}

const bool curves_registered = [] {
  const auto add = [](const char* name, auto number, std::size_t n, int levels, Boundary boundary, const char* id,
                      const char* v0 = nullptr) {
    return benchmark::RegisterBenchmark(
        name, [=](benchmark::State& state) { curve<decltype(number)>(state, n, levels, boundary, id, v0); });
  };
  add("refine/closed,10^4x10", 0.0, 10'000, 10, Boundary::closed, six_point, "1/2")->Apply(shapes);
  add("refine/closed,10^6x6", 0.0, 1'000'000, 6, Boundary::closed, six_point, "1/2")->Apply(shapes);
  add("refine/stationary", 0.0, 10'000, 10, Boundary::closed, "dd:l=3")->Apply(plane);
  add("refine/given", 0.0, 10'000, 10, Boundary::given, six_point, "1/2")->Apply(plane);
  add("refine/linear", 0.0, 10'000, 10, Boundary::linear, six_point, "1/2")->Apply(plane);
  add("refine/space", 0.0, 10'000, 10, Boundary::space, six_point, "1/2")->Apply(plane);
  add("refine/l=8", 0.0, 10'000, 10, Boundary::closed, "interpolating:family=harmonic,l=8", "2")->Apply(plane);
  add("refine/spline", 0.0, 10'000, 10, Boundary::closed, "bspline:n=3")->Apply(plane);
  add("refine/ternary,10^4x6", 0.0, 10'000, 6, Boundary::closed, "bspline:n=3,arity=3")->Apply(plane);
  add("refine/float", 0.0F, 10'000, 10, Boundary::closed, six_point, "1/2")->Apply(plane);
  return true;
}();

void tensor(benchmark::State& state) {
  const auto dim = static_cast<std::size_t>(state.range(0));
  const kernels::MaskTable t = table(six_point, "1/2", 4);
  kernels::SurfaceRefiner<double> refiner{kernels::Refiner<double>(t), kernels::Refiner<double>(t)};
  refiner.set_threads(1);
  const kernels::GridSize size{100, 100};
  const kernels::DirectionRun run{4, Boundary::closed};
  const std::vector<double> in = polygon<double>(size.rows * size.columns, dim);
  Buffer<double> out = zeros<double>(1600 * 1600 * dim);
  beside_write(state, out, 1, [&] { refiner.refine(in, size, dim, run, run, out.span()); });
}
BENCHMARK(tensor)->ArgName("D")->Arg(1)->Arg(3)->UseManualTime();

// The rules without masks are bound by arithmetic: the bound is the time of the operations of their formulas, each
// quotient once, over arrays that stay in the first cache; `of_bound` is the part of that rate that is reached. More
// than all of it where many quotients are known beforehand. Returns the time of the job.
template <class Bound, class Job>
double beside_bound(benchmark::State& state, Bound&& bound, Job&& job) {
  std::vector<double> least, working;
  job();
  for (auto _ : state) {
    const double start = now(1);
    bound();
    const double between = now(1);
    job();
    const double end = now(1);
    least.push_back(between - start);
    working.push_back(end - between);
    state.SetIterationTime(std::max(1e-9, end - between));
  }
  state.counters["of_bound"] = median(least) / median(working);
  return median(working);
}

kernels::KnotPolygon<double> knots(std::size_t n) {
  kernels::KnotPolygon<double> p;
  p.dim = 2;
  for (std::size_t j = 0; j < n; ++j) {
    const double angle = 2 * 3.14159265358979 * static_cast<double>(j) / static_cast<double>(n);
    const double r = j % 3 == 0 ? 2 : 1;
    p.points.push_back(r * std::cos(angle));
    p.points.push_back(r * std::sin(angle));
    p.lambda.push_back(j % 5 == 0 ? 0.25 : 0.5);
  }
  p.d = kernels::knot_intervals(p.points, 2, true, kernels::Parametrization::centripetal);
  p.tagged = kernels::default_tags(p);
  return p;
}

// The formulas of nonuniform.hpp for `edges` edges of a plane polygon, without any case.
struct KnotFormulas {
  static constexpr std::size_t edges = 128;
  std::vector<double> d, lambda, x, first, second, third, out;
  KnotFormulas()
      : d(edges + 8, 0.7),
        lambda(edges + 8, 0.4),
        x(2 * edges + 16, 1.0),
        first(x.size()),
        second(x.size()),
        third(x.size()),
        out(2 * x.size()) {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = std::sin(static_cast<double>(i * i));
  }

  static double weight(double a, double b, double k, double m) {
    return a * (a * k + b) * (m * m / (1 - m)) / (6 * (k * m * (a + b) + k * a + m * b));
  }

  void run(bool six) {
    for (std::size_t e = 0; e < edges + 6; ++e)
      for (std::size_t c = 0; c < 2; ++c) first[2 * e + c] = (x[2 * e + 2 + c] - x[2 * e + c]) / d[e];
    for (std::size_t e = 1; e < edges + 6; ++e)
      for (std::size_t c = 0; c < 2; ++c)
        second[2 * e + c] = (first[2 * e + c] - first[2 * e - 2 + c]) / (d[e - 1] + d[e]);
    if (six)
      for (std::size_t e = 1; e < edges + 5; ++e)
        for (std::size_t c = 0; c < 2; ++c)
          third[2 * e + c] = (second[2 * e + 2 + c] - second[2 * e + c]) / (d[e - 1] + d[e] + d[e + 1]);
    for (std::size_t e = 3; e < edges + 3; ++e) {
      const double quarter = d[e] * d[e] / 4;
      const double w = six ? (d[e] / 2 + d[e + 1]) / (d[e - 1] + d[e] + d[e + 1]) : lambda[e] / (2 * (1 - lambda[e]));
      const double left = six ? weight(d[e - 1], d[e], 1 - lambda[e - 1], lambda[e]) : 0;
      const double right = six ? weight(d[e + 1], d[e], lambda[e + 1], 1 - lambda[e]) : 0;
      for (std::size_t c = 0; c < 2; ++c) {
        double bend = w * second[2 * e + c] + (1 - w) * second[2 * e + 2 + c];
        if (six) {
          bend = bend + left * (third[2 * e - 2 + c] - third[2 * e + c]) -
                 right * (third[2 * e + 2 + c] - third[2 * e + c]);
        }
        out[4 * e + c] = x[2 * e + c];
        out[4 * e + 2 + c] = (x[2 * e + c] + x[2 * e + 2 + c]) * 0.5 - quarter * bend;
      }
    }
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
};

void nuli(benchmark::State& state, kernels::KnotRule rule) {
  constexpr int levels = 8;
  const kernels::KnotPolygon<double> large = knots(10'000);
  const std::size_t new_points = large.size() * ((std::size_t{1} << levels) - 1);
  KnotFormulas formulas;
  kernels::KnotRefiner<double> refiner;
  refiner.set_threads(1);
  const auto job = [&] { benchmark::DoNotOptimize(refiner.refine(large, rule, levels, Boundary::closed).size()); };
  const auto bound = [&] {
    for (std::size_t made = 0; made < new_points; made += KnotFormulas::edges)
      formulas.run(rule == kernels::KnotRule::nuli6);
  };
  const double working = beside_bound(state, bound, job);
  // What comes out, points, intervals, edge parameters and tags, by streaming stores alone.
  const kernels::KnotPolygon<double>& fine = refiner.refine(large, rule, levels, Boundary::closed);
  Buffer<double> out =
      zeros<double>(fine.points.size() + fine.d.size() + fine.lambda.size() + fine.tagged.size() / sizeof(double));
  std::vector<double> writing;
  for (int i = 0; i < 9; ++i) {
    const double start = now(1);
    write(reinterpret_cast<char*>(out.span().data()), out.span().size_bytes());
    writing.push_back(now(1) - start);
  }
  state.counters["of_write"] = median(writing) / working;
  state.counters["ns_per_point"] =
      benchmark::Counter(static_cast<double>(new_points) * 1e-9,
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK_CAPTURE(nuli, nuli4, kernels::KnotRule::nuli4)->UseManualTime();
BENCHMARK_CAPTURE(nuli, nuli6, kernels::KnotRule::nuli6)->UseManualTime();

void hermite(benchmark::State& state) {
  constexpr unsigned levels = 8;
  constexpr std::size_t vertices = 2000;
  kernels::HermiteData<double> d;
  d.dim = 2;
  d.closed = true;
  for (std::size_t j = 0; j < vertices; ++j) {
    const double angle = 2 * 3.14159265358979 * static_cast<double>(j) / static_cast<double>(vertices);
    const double r = 2 + std::sin(3 * angle);
    d.f.push_back(r * std::cos(angle));
    d.f.push_back(r * std::sin(angle));
  }
  constexpr auto tension = kernels::HermiteRuleTension::printed;
  const kernels::HermiteCurve<double> curve(std::move(d), 1.0, tension);
  constexpr std::size_t new_points = vertices * ((std::size_t{1} << levels) - 1);
  const auto job = [&] { benchmark::DoNotOptimize(curve.refined(levels)); };
  // The rule of a step, its tangent, and 15 products for each coordinate.
  const auto bound = [&] {
    double sigma = 0.1, sum = 0;
    for (std::size_t i = 0; i < new_points; ++i) {
      benchmark::DoNotOptimize(sigma);
      const double s = std::tan(sigma / 8);
      const auto rule = kernels::hermite_step(s, s + 0.01, 1.0, tension);
      for (std::size_t c = 0; c < 2; ++c)
        for (std::size_t k = 0; k < 3; ++k)
          sum = rule[k][0] * 0.1 + rule[k][1] * s + rule[k][2] * 0.2 + rule[k][3] * 0.3 + rule[k][4] * sigma;
      benchmark::DoNotOptimize(sum);
    }
  };
  beside_bound(state, bound, job);
  state.counters["ns_per_point"] =
      benchmark::Counter(static_cast<double>(new_points) * 1e-9,
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(hermite)->UseManualTime();

// ---- Peers: 10^4 points, 8 levels, one thread, buffers kept

constexpr std::size_t peer_points = 10'000;
constexpr int peer_levels = 8;

template <class Real>
void ours(benchmark::State& state) {
  const auto dim = static_cast<std::size_t>(state.range(0));
  kernels::Refiner<Real> refiner(table(six_point, "1/2", peer_levels));
  refiner.set_threads(1);
  const std::vector<Real> in = polygon<Real>(peer_points, dim);
  Buffer<Real> out = zeros<Real>((peer_points << peer_levels) * dim);
  for (auto _ : state) {
    refiner.refine(in, dim, peer_levels, Boundary::closed, out.span());
    benchmark::ClobberMemory();
  }
}
BENCHMARK(ours<double>)->Name("ours")->ArgName("D")->DenseRange(1, 4);
BENCHMARK(ours<float>)->Name("ours_float")->ArgName("D")->DenseRange(1, 4);

void ours_allocating(benchmark::State& state) {
  const auto dim = static_cast<std::size_t>(state.range(0));
  const kernels::MaskTable t = table(six_point, "1/2", peer_levels);
  const std::vector<double> in = polygon<double>(peer_points, dim);
  for (auto _ : state) {
    kernels::Refiner<double> refiner(t);
    refiner.set_threads(1);
    benchmark::DoNotOptimize(refiner.refine(in, dim, peer_levels, Boundary::closed).data());
  }
}
BENCHMARK(ours_allocating)->ArgName("D")->DenseRange(1, 4);

// What no refinement can pass: the same output by streaming stores alone.
template <class Real>
void writing(benchmark::State& state) {
  Buffer<Real> out = zeros<Real>((peer_points << peer_levels) * static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) write(reinterpret_cast<char*>(out.data()), out.span().size_bytes());
}
BENCHMARK(writing<double>)->Name("writing")->ArgName("D")->DenseRange(1, 4);
BENCHMARK(writing<float>)->Name("writing_float")->ArgName("D")->DenseRange(1, 4);

// The result in memory of a pool, which it goes back to.
void ours_pooled(benchmark::State& state) {
  const auto dim = static_cast<std::size_t>(state.range(0));
  const kernels::MaskTable t = table(six_point, "1/2", peer_levels);
  const std::vector<double> in = polygon<double>(peer_points, dim);
  kernels::BufferPool pool;
  for (auto _ : state) {
    kernels::Refiner<double> refiner(t);
    refiner.set_threads(1);
    benchmark::DoNotOptimize(refiner.refine(in, dim, peer_levels, Boundary::closed, pool).data());
  }
}
BENCHMARK(ours_pooled)->ArgName("D")->DenseRange(1, 4);

// Growth with the number of points: D = 2, 8 levels, one thread, output kept.
void growth(benchmark::State& state) {
  kernels::Refiner<double> refiner(table(six_point, "1/2", peer_levels));
  refiner.set_threads(1);
  const auto n = static_cast<std::size_t>(state.range(0));
  const std::vector<double> in = polygon<double>(n, 2);
  Buffer<double> out = zeros<double>(refiner.output(n, peer_levels, Boundary::closed).count * 2);
  for (auto _ : state) refiner.refine(in, 2, peer_levels, Boundary::closed, out.span());
}
BENCHMARK(growth)->Name("refine/6-point")->ArgName("points")->RangeMultiplier(10)->Range(10, 100'000);

// All levels as one sparse matrix.
Eigen::SparseMatrix<double, Eigen::RowMajor> all_levels() {
  const kernels::MaskTable t = table(six_point, "1/2", peer_levels);
  Eigen::SparseMatrix<double, Eigen::RowMajor> product;
  long n = static_cast<long>(peer_points);
  for (const kernels::MaskRow& row : t.levels) {
    std::vector<Eigen::Triplet<double>> entries;
    for (long i = 0; i < 2 * n; ++i)
      for (std::size_t s = 0; s < row.value.size(); ++s) {
        const long j = i - row.lowest - static_cast<long>(s);
        if (j % 2 == 0 && row.value[s] != 0)
          entries.emplace_back(static_cast<int>(i), static_cast<int>((j / 2 + n) % n), row.value[s]);
      }
    Eigen::SparseMatrix<double, Eigen::RowMajor> step(2 * n, n);
    step.setFromTriplets(entries.begin(), entries.end());
    product = product.size() == 0 ? step : Eigen::SparseMatrix<double, Eigen::RowMajor>(step * product);
    n *= 2;
  }
  return product;
}

using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

void eigen_sparse(benchmark::State& state) {
  const auto dim = state.range(0);
  const auto matrix = all_levels();
  const std::vector<double> in = polygon<double>(peer_points, static_cast<std::size_t>(dim));
  const Rows x = Eigen::Map<const Rows>(in.data(), static_cast<long>(peer_points), dim);
  Rows y(matrix.rows(), dim);
  for (auto _ : state) {
    y.noalias() = matrix * x;
    benchmark::ClobberMemory();
  }
}
BENCHMARK(eigen_sparse)->ArgName("D")->DenseRange(1, 4);

#ifdef TWOSCALE_OPENSUBDIV
void opensubdiv(benchmark::State& state) {
  const int dim = static_cast<int>(state.range(0));
  const auto matrix = all_levels();
  std::vector<int> sizes, offsets, indices;
  std::vector<float> weights;
  for (long i = 0; i < matrix.rows(); ++i) {
    offsets.push_back(static_cast<int>(indices.size()));
    for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator it(matrix, i); it; ++it) {
      indices.push_back(static_cast<int>(it.col()));
      weights.push_back(static_cast<float>(it.value()));
    }
    sizes.push_back(static_cast<int>(indices.size()) - offsets.back());
  }
  const std::vector<float> in = polygon<float>(peer_points, static_cast<std::size_t>(dim));
  std::vector<float> out(static_cast<std::size_t>(matrix.rows() * dim));
  const OpenSubdiv::Osd::BufferDescriptor layout(0, dim, dim);
  for (auto _ : state) {
    OpenSubdiv::Osd::CpuEvaluator::EvalStencils(in.data(), layout, out.data(), layout, sizes.data(), offsets.data(),
                                                indices.data(), weights.data(), 0, static_cast<int>(sizes.size()));
    benchmark::ClobberMemory();
  }
}
BENCHMARK(opensubdiv)->ArgName("D")->DenseRange(1, 4);
#endif

}  // namespace
}  // namespace twoscale::bench
