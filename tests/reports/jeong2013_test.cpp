// SPDX-License-Identifier: GPL-3.0-or-later
// The surfaces of jeong2013 come back, and the page holds them.
#include "twoscale/reports/jeong2013.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>

#include "twoscale/kernels/write_file.hpp"
#include "twoscale/reports/surface_plot.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::reports::jeong2013 {
namespace {

TEST(Jeong2013, TensionFormsHaveThePrintedMasks) {
  const auto f = [](const char* text) { return parse_rational_function(text); };
  // gamma_2 = 2v.
  const Laurent spline = symbol(make_scheme(tension_name(TensionForm::spline, "1/3")));
  EXPECT_EQ(spline.coefficient(0), f("(1+2*v+1/3)/(2+2*v)"));
  EXPECT_EQ(spline.coefficient(1), f("(2*v*(2+2*v)+1/3)/(4*v*(2+2*v))"));
  EXPECT_EQ(spline.coefficient(-2), f("(1-1/3)/(2*(2+2*v))"));
  EXPECT_EQ(spline.coefficient(3), f("-1/3/(4*v*(2+2*v))"));
  const Laurent polygon = symbol(make_scheme(tension_name(TensionForm::polygon, "1/4")));
  EXPECT_EQ(polygon.coefficient(0), f("1"));
  EXPECT_EQ(polygon.coefficient(2), f("0"));
  EXPECT_EQ(polygon.coefficient(-1), f("1/2+1/4/(2*v*(2+2*v))/2"));
  EXPECT_EQ(polygon.coefficient(-3), f("-1/4/(2*v*(2+2*v))/2"));
}

TEST(Jeong2013, SurfacesComeBack) {
  for (const Surface& s : surfaces()) {
    const lowering::ParametricSurface p = parametric(s);
    for (const auto method : {lowering::SurfaceMethod::space, lowering::SurfaceMethod::sum}) {
      const auto out = lowering::refine_sum(lowering::summands(p, method, 1, 1, 0), 0);
      EXPECT_LT(lowering::estimate_largest_deviation(out, p), 1e-14) << s.title;
    }
  }
}

// The tube of the toroidal knot touches itself along a circle.
TEST(Jeong2013, TheToroidalKnotTouchesItself) {
  const lowering::ParametricSurface p = parametric(surfaces().back());
  for (const long j : {0L, 1L, 5L}) {
    const GiNaC::ex v = GiNaC::numeric(j, 7);
    for (const ExponentialSum& c : p.coordinates)
      EXPECT_EQ((c.at(1 - 3 * v, v) - c.at(1 - 3 * (v + 2), v + 2)).sign(), Sign::zero);
    EXPECT_EQ(p.coordinates[2].at(1 - 3 * v, v).sign(), Sign::zero);
  }
}

TEST(Jeong2013, ThePageIsWhole) {
  const std::filesystem::path directory =
      std::filesystem::temp_directory_path() / ("twoscale-jeong2013-" + std::to_string(std::random_device{}()));
  const PaperSummary s = write_report(directory.string(), {});
  EXPECT_LT(s.largest_exact_deviation, 1e-13);
  EXPECT_EQ(s.exact_runs, 18);
  const std::string page = kernels::read_file(s.index);
  EXPECT_NE(page.find("</html>"), std::string::npos);
  for (const int figure : {1, 2, 4, 5, 6, 7, 8, 9})
    EXPECT_NE(page.find("id=\"figure-" + std::to_string(figure) + "\""), std::string::npos) << figure;
  EXPECT_EQ(page.find("do not all"), std::string::npos);
  EXPECT_EQ(page.find("=\"http"), std::string::npos);
  const auto numbers = nlohmann::json::parse(kernels::read_file((directory / "report.json").string()));
  for (const auto& run : numbers["figure-6"]) {
    if (!run.contains("way")) continue;
    const bool least = run["way"] == "one pair of the least frequencies";
    EXPECT_EQ(run["deviation"].get<double>() > 1e-3, least) << run;
  }
  std::filesystem::remove_all(directory);
}

TEST(SurfacePicture, DrawsWhatCanBeSeen) {
  kernels::PointGrid grid;
  grid.size = {20, 3};
  grid.points.dim = 2;
  for (int i = 0; i < 120; ++i) grid.points.values.push_back(i % 7);
  SurfacePicture p;
  p.sheet = sheet(grid, {false, true}, 5);
  EXPECT_EQ(p.sheet.size, (kernels::GridSize{6, 3}));  // the last row is kept
  EXPECT_EQ(p.sheet.values[3 * 3 * 5], grid.points.values[2 * 3 * 19]);
  EXPECT_EQ(gnuplot_script(p, ImageFormat::svg), gnuplot_script(p, ImageFormat::svg));
  EXPECT_EQ(render(p, ImageFormat::svg).substr(0, 5), "<?xml");
  p.sheet.values[4] = INFINITY;
  EXPECT_THROW(gnuplot_script(p, ImageFormat::svg), Error);
  grid.points.dim = 1;
  EXPECT_THROW(sheet(grid, {}, 5), Error);
}

}  // namespace
}  // namespace twoscale::reports::jeong2013
