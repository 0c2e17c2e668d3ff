// SPDX-License-Identifier: GPL-3.0-or-later
// The figures and the algorithm of beccari2007.
#include "twoscale/reports/beccari2007.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>

#include "twoscale/kernels/write_file.hpp"

namespace twoscale::reports::beccari2007 {
namespace {

TEST(Beccari2007, EveryRunMeetsItsExpectation) {
  for (const Figure& f : figures())
    for (const Panel& p : f.panels)
      for (const Trial& t : p.trials) {
        SCOPED_TRACE(p.id + " " + t.v0);
        const Measured m = measure(p, t);
        EXPECT_TRUE(m.ran) << m.refusal;
        EXPECT_EQ(t.expect == Expect::exact, std::holds_alternative<Samples>(p.start) && m.deviation < 1e-12);
        if (t.expect == Expect::shape) {
          EXPECT_GT(m.polygon_distance, 1e-4);
        }
      }
}

std::vector<double> nine(double step, double (*x)(double), double (*y)(double)) {
  std::vector<double> points;
  for (int j = 0; j < 9; ++j) points.insert(points.end(), {x(j * step), y(j * step)});
  return points;
}

// The right inverse returns v^0 >= -1/2, the printed one the inverse of another function; v and -1-v have one weight.
TEST(Beccari2007, TheAlgorithmAsPrintedAndCorrected) {
  const double pi = std::acos(-1.0);
  for (const double step : {0.3, pi / 5, 1.9}) {
    const PrintedTension t = printed_tension(nine(step, std::cos, std::sin));
    const double v = std::cos(step);
    EXPECT_EQ(t.obstacle, "");
    EXPECT_NEAR(t.w, 1 / (4 * v * (1 + v)), 1e-9);
    EXPECT_NEAR(t.corrected, v, 1e-9);
    EXPECT_GT(std::abs(t.as_printed - v), 0.1);
  }
  EXPECT_NEAR(printed_tension(nine(0.75 * pi, std::cos, std::sin)).corrected, -1 - std::cos(0.75 * pi), 1e-9);
  EXPECT_NEAR(printed_tension(nine(0.5, std::cosh, std::sinh)).corrected, std::cosh(0.5), 1e-9);
  EXPECT_EQ(printed_tension(nine(pi / 2, std::cos, std::sin)).obstacle, "(8) has no solution");
  // A point moved: another w, or none.
  auto moved = nine(0.3, std::cos, std::sin);
  moved[6] += 0.01;
  EXPECT_NE(printed_tension(moved).obstacle, "");
}

TEST(Beccari2007, ThePageIsWhole) {
  const std::filesystem::path directory =
      std::filesystem::temp_directory_path() / ("twoscale-beccari2007-" + std::to_string(std::random_device{}()));
  const PaperSummary s = write_report(directory.string(), {});
  EXPECT_LT(s.largest_exact_deviation, 1e-12);
  EXPECT_EQ(s.exact_runs, 9);
  const std::string page = kernels::read_file(s.index);
  EXPECT_NE(page.find("</html>"), std::string::npos);
  for (const PaperFigure& f : s.figures) EXPECT_TRUE(std::filesystem::is_regular_file(directory / f.file)) << f.file;
  const auto numbers = nlohmann::json::parse(kernels::read_file((directory / "report.json").string()));
  EXPECT_EQ(numbers["scheme"][0]["smoothness"]["continuity"], 1);
  EXPECT_EQ(numbers["algorithm"].size(), 6U);
  std::filesystem::remove_all(directory);
}

}  // namespace
}  // namespace twoscale::reports::beccari2007
