// SPDX-License-Identifier: GPL-3.0-or-later
// Fitting: the robust formula of one pair, harmonics, double frequencies, closed and noisy data, straight lines.
#include "twoscale/lowering/fit.hpp"

#include <cmath>
#include <random>

#include "support.hpp"

namespace twoscale::lowering {
namespace {

using kernels::PointSet;
using Outcome = Fit::Outcome;

constexpr double pi = 3.14159265358979323846;

template <class F>
PointSet samples(int first, int count, F f) {
  PointSet p;
  for (int j = first; j < first + count; ++j)
    for (const double x : f(j)) p.values.push_back(x);
  p.dim = p.values.size() / static_cast<size_t>(count);
  return p;
}

using Row = std::vector<double>;

Fit fit_scheme(const std::string& scheme, const PointSet& p, bool closed = false,
               const std::string& tolerance = "1e-9") {
  return fit(*make_scheme(scheme).space, p, closed, tolerance);
}

TEST(Fit, CatenaryCircleHelix) {
  const Fit catenary = fit_scheme("tension4", samples(-3, 8, [](int j) {
                                    return Row{1.0 * j, std::cosh(0.4 * j + 0.1) + 2};
                                  }));
  EXPECT_EQ(catenary.outcome, Outcome::found);
  EXPECT_NEAR(std::stod(catenary.v0), std::cosh(0.4), 1e-12);
  EXPECT_NEAR(std::stod(catenary.t), 0.4, 1e-12);
  EXPECT_LT(std::stod(catenary.spread), 1e-12);
  for (const int n : {5, 6, 7}) {
    const auto data = samples(0, n, [n](int j) { return Row{std::cos(2 * pi * j / n), std::sin(2 * pi * j / n)}; });
    for (const bool closed : {false, true}) {
      const Fit f = fit_scheme("tension4", data, closed);
      EXPECT_EQ(f.outcome, Outcome::found);
      EXPECT_NEAR(std::stod(f.v0), std::cos(2 * pi / n), 1e-13);
      EXPECT_EQ(f.t.substr(f.t.size() - 2), "*I");
      EXPECT_NEAR(std::stod(f.t), 2 * pi / n, 1e-13);
    }
  }
  const auto helix = samples(0, 12, [](int j) { return Row{std::cos(0.9 * j), std::sin(0.9 * j), 0.2 * j}; });
  EXPECT_NEAR(std::stod(fit_scheme("tension4", helix).t), 0.9, 1e-13);
  const Fit cosines = fit_scheme("interpolating:space=\"1,x,cos(s*x),sin(s*x)\"", helix);
  EXPECT_NEAR(std::stod(cosines.t), 0.9, 1e-13);
  EXPECT_EQ(cosines.t.find('I'), std::string::npos);
}

TEST(Fit, RationalDataGiveTheExactValue) {
  // y_j = 2^j + 2^-j: v^0 = 5/4; cubic data: v^0 = 1.
  const Fit f =
      fit_scheme("tension4", samples(-3, 7, [](int j) { return Row{std::ldexp(1.0, j) + std::ldexp(1.0, -j)}; }));
  EXPECT_EQ(f.v0, "1.25");
  EXPECT_EQ(f.spread, "0");
  const Fit cubic = fit_scheme("tension4", samples(0, 7, [](int j) { return Row{1.0 * j * j * j, 2.0 * j}; }));
  EXPECT_EQ(cubic.outcome, Outcome::found);
  EXPECT_EQ(cubic.v0, "1");
  EXPECT_EQ(cubic.t, "0");
}

TEST(Fit, PolynomialDataFitAnyValue) {
  EXPECT_EQ(fit_scheme("tension4", samples(0, 9,
                                           [](int j) {
                                             return Row{0.1 * j, 1 + 0.3 * j};
                                           }))
                .outcome,
            Outcome::any);
  EXPECT_EQ(fit_scheme("tension4", samples(0, 9, [](int j) { return Row{5.0, 1.0 + j}; })).outcome, Outcome::any);
  EXPECT_EQ(fit_scheme("interpolating:family=mixed,l=3", samples(0, 9, [](int j) { return Row{1.0 * j * j}; })).outcome,
            Outcome::any);
}

TEST(Fit, SeveralHarmonicsAndDoubleFrequencies) {
  const auto two = samples(0, 16, [](int j) {
    return Row{std::cos(0.3 * j) - 2 * std::sin(0.6 * j), 1 + std::sin(0.3 * j + 1)};
  });
  const Fit harmonic = fit_scheme("interpolating:family=harmonic,l=3", two);
  EXPECT_EQ(harmonic.outcome, Outcome::found) << harmonic.spread;
  EXPECT_NEAR(std::stod(harmonic.t), 0.3, 1e-10);
  // Too few functions for these data.
  EXPECT_EQ(fit_scheme("tension4", two).outcome, Outcome::none);
  const auto resonance = samples(0, 16, [](int j) { return Row{j * std::cosh(0.2 * j), std::sinh(0.2 * j)}; });
  const Fit resonant = fit_scheme("interpolating:family=resonant,l=3", resonance, false, "1e-6");
  EXPECT_EQ(resonant.outcome, Outcome::found) << resonant.spread;
  EXPECT_NEAR(std::stod(resonant.t), 0.2, 1e-6);
  // Data of a subspace: no loss by the double zero.
  const auto circle = samples(0, 16, [](int j) { return Row{std::cos(0.3 * j), std::sin(0.3 * j)}; });
  for (const char* s :
       {"interpolating:family=resonant,l=3", "interpolating:family=harmonic,l=4", "interpolating:family=mixed,l=4"}) {
    const Fit f = fit_scheme(s, circle);
    EXPECT_EQ(f.outcome, Outcome::found) << s;
    EXPECT_NEAR(std::stod(f.t), 0.3, 1e-10) << s;
  }
}

TEST(Fit, NoisyDataDoNotFit) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(-1e-6, 1e-6);
  const auto data = samples(0, 20, [&](int j) { return Row{1.0 * j, std::cosh(0.4 * j) + noise(random)}; });
  const Fit f = fit_scheme("tension4", data);
  EXPECT_EQ(f.outcome, Outcome::none);
  EXPECT_NEAR(std::stod(f.v0), std::cosh(0.4), 1e-6);
  EXPECT_EQ(fit_scheme("tension4", data, false, "1/1000").outcome, Outcome::found);
  // Alternating data would need v^0 <= -1.
  EXPECT_EQ(fit_scheme("tension4", samples(0, 9, [](int j) { return Row{j % 2 == 0 ? 1.0 : -1.0}; })).outcome,
            Outcome::none);
}

TEST(Fit, Refusals) {
  const auto data = samples(0, 4, [](int j) { return Row{std::cosh(0.4 * j)}; });
  EXPECT_EQ(test::refusal([&] { fit_scheme("tension4", data); }), "a fit needs at least 5 points here, not 4");
  EXPECT_NE(test::refusal([&] { fit_scheme("dd:l=2", data); }), "");
  EXPECT_NE(test::refusal([&] { fit_scheme("interpolating:space=\"1,x,cosh(x),sinh(x)\"", data); }), "");
  EXPECT_NE(
      test::refusal([&] { fit_scheme("exponential-bspline:space=\"exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)\"", data); }),
      "");
  for (const char* bad : {"0", "-1e-9", "x", "pi"})
    EXPECT_NE(test::refusal([&] { fit_scheme("tension4", data, true, bad); }), "") << bad;
}

}  // namespace
}  // namespace twoscale::lowering
