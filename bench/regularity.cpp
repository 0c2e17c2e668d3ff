// SPDX-License-Identifier: GPL-3.0-or-later
// Exponents proved, certificate included, and how long their certificates take to check. The scheme is given.
//
//   regularity/SET/MEMBER     the whole of regularity(), by whatever route it takes
//   polytope/SET/MEMBER       the invariant polytope also where the symbol is non-negative
//   jsr/SET/MEMBER            joint_spectral_radius() of given matrices
//   enclosure/SET/width:W     a complex leading eigenvalue, the radius enclosed to this relative width
//   check/...                 the checker on the certificate of any of these
// Labels: "open" where the radius did not become exact; else, of polytope and jsr, the matrices a peer may start from:
// a JSON list of diagonal blocks, each a list of matrices.
#include <benchmark/benchmark.h>

#include <nlohmann/json.hpp>

#include "masks.hpp"
#include "twoscale/analysis/certificate.hpp"
#include "twoscale/analysis/regularity.hpp"
#include "twoscale/check/check.hpp"
#include "twoscale/symbolic/catalog.hpp"

namespace twoscale::bench {
namespace {

using analysis::JsrResult;
using analysis::Regularity;
using analysis::RegularityOptions;

constexpr double seconds = 5;  // of one search; what is open then stays open

// For a peer to compare with: the bounds of an exact radius are close.
double radius_of(const JsrResult& r) { return fmpq_get_d(r.lower.raw()); }

std::string blocks_json(const Family& family) {
  auto blocks = nlohmann::json::array();
  for (const Family& block : analysis::block_triangular_form(family).blocks) {
    auto matrices = nlohmann::json::array();
    for (const RationalMatrix& b : block) {
      auto rows = nlohmann::json::array();
      for (long i = 0; i < b.rows(); ++i) {
        auto row = nlohmann::json::array();
        for (long j = 0; j < b.columns(); ++j) row.push_back(b(i, j).to_string());
        rows.push_back(row);
      }
      matrices.push_back(rows);
    }
    blocks.push_back(matrices);
  }
  return blocks.dump();
}

void regularity(benchmark::State& state, const std::string& name, const RegularityOptions& options) {
  const Scheme scheme = make_scheme(name);
  Regularity r;
  for (auto _ : state) r = analysis::regularity(scheme, options);
  state.counters["bytes"] = static_cast<double>(r.certificate.size());
  state.counters["radius"] = radius_of(r.jsr);
  if (!r.jsr.exact)
    state.SetLabel("open");
  else if (options.polytope_only)
    state.SetLabel(blocks_json(analysis::transition_matrices(*analysis::remainder(symbol(scheme), scheme.arity))));
  else
    state.SetLabel(r.method);
}

void check_text(benchmark::State& state, const std::string& text) {
  check::Report report;
  for (auto _ : state) report = check::check_text(text);
  if (report.status != check::Report::valid) state.SetLabel("refused: " + report.message);
}

void radius(benchmark::State& state, const Family& family, const analysis::JsrOptions& options) {
  JsrResult r;
  for (auto _ : state) {
    r = analysis::joint_spectral_radius(family, {}, options);
    benchmark::DoNotOptimize(analysis::certificate_text("", family, r.claims));
  }
  state.counters["radius"] = radius_of(r);
  state.SetLabel(r.exact ? blocks_json(family) : "open");
}

// The certificate is made once, by the first repetition.
template <class Job, class Certificate>
void both(const std::string& name, Job job, Certificate certificate) {
  benchmark::RegisterBenchmark(name.c_str(), job);
  benchmark::RegisterBenchmark(("check/" + name).c_str(),
                               [certificate, text = std::string()](benchmark::State& state) mutable {
                                 if (text.empty()) text = certificate();
                                 check_text(state, text);
                               });
}

void both(const std::string& name, const std::string& scheme, const RegularityOptions& options) {
  both(
      name, [=](benchmark::State& state) { regularity(state, scheme, options); },
      [=] { return analysis::regularity(make_scheme(scheme), options).certificate; });
}

int register_all() {
  RegularityOptions any;
  any.jsr.seconds = seconds;
  RegularityOptions polytope = any;
  polytope.polytope_only = true;

  std::vector<Mask> masks = classical_masks();
  for (long l = 1; l <= 8; ++l) masks.push_back({"dd/l:" + std::to_string(l), 2, pseudo_spline(l, l - 1)});
  for (const unsigned seed : {1U, 3U, 4U, 5U})
    for (long n = 2; n <= 10; n += 2) masks.push_back(random_mask(n, seed));
  for (const Mask& mask : masks) {
    both("regularity/" + mask.name, mask.scheme(), any);
    both("polytope/" + mask.name, mask.scheme(), polytope);
  }

  for (const std::string family : {"mixed", "harmonic", "resonant"})
    for (long l = 2; l <= 8; ++l) {
      const std::string at = std::to_string(l);
      both("regularity/" + family + "/l:" + at, "interpolating:family=" + family + ",l=" + at, any);
    }

  const Coefficients complex = times(Rational(1, 64), {1, 0, -7, 0, 38, 64, 38, 0, -7, 0, 1});  // 6-point, t = 1/64
  for (const long width : {100, 1000, 10000}) {
    RegularityOptions enclosing = any;
    enclosing.jsr.width = Rational(1, width);
    both("enclosure/6-point/width:1/" + std::to_string(width), Mask{"", 2, complex}.scheme(), enclosing);
  }

  for (const Matrices& m : classical_matrices())
    both(
        "jsr/" + m.name, [=](benchmark::State& state) { radius(state, m.family, any.jsr); },
        [=] {
          return analysis::certificate_text(m.name, m.family,
                                            analysis::joint_spectral_radius(m.family, {}, any.jsr).claims);
        });
  return 0;
}

const int registered = register_all();

}  // namespace
}  // namespace twoscale::bench
