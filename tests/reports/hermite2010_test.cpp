// SPDX-License-Identifier: GPL-3.0-or-later
/// The page of hermite2010 is whole, and says what was measured.
#include "twoscale/reports/hermite2010.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "twoscale/kernels/write_file.hpp"
#include "twoscale/reports/curves.hpp"

namespace twoscale::reports::hermite2010 {
namespace {

std::size_t count(const std::string& text, const std::string& piece) {
  std::size_t n = 0;
  for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) ++n;
  return n;
}

TEST(Hermite2010, ThePageIsWhole) {
  const std::filesystem::path directory =
      std::filesystem::temp_directory_path() / ("twoscale-hermite2010-" + std::to_string(std::random_device{}()));
  PaperOptions options;
  // A checker that refuses one of the three.
  options.checker = [](std::string_view text) {
    return CheckerVerdict{text.find("\"scheme\": \"hermite-circle:w=7/5\"") == std::string_view::npos, {"a line"}};
  };
  const PaperSummary s = write_report(directory.string(), options);
  EXPECT_FALSE(s.all_certificates_valid);
  EXPECT_LT(s.largest_exact_deviation, 1e-12);
  EXPECT_EQ(s.exact_runs, 7);
  const std::string page = kernels::read_file(s.index);
  for (const PaperFigure& f : s.figures) EXPECT_TRUE(std::filesystem::is_regular_file(directory / f.file)) << f.file;
  EXPECT_GT(s.figures.size(), 35U);
  for (int figure = 1; figure <= 10; ++figure)
    EXPECT_EQ(count(page, "id=\"figure-" + std::to_string(figure) + "\""), 1U) << figure;
  EXPECT_EQ(count(page, "<section"), count(page, "</section>"));
  EXPECT_EQ(page.find("nan"), std::string::npos);
  EXPECT_EQ(count(page, "says <strong class=\"refuted\">refused"), 1U);
  // The commands of the page find their data.
  for (const char* name : {"circle", "half-circle", "pentagram", "bean", "nearly-collinear"})
    EXPECT_TRUE(std::filesystem::exists(directory / "data" / (std::string(name) + ".csv"))) << name;
  std::filesystem::remove_all(directory);
}

TEST(CurvatureComb, TeethAreAsLongAsTheCurvature) {
  std::vector<double> circle;
  for (int j = 0; j < 40; ++j) circle.insert(circle.end(), {2 * std::cos(j * 0.157), 2 * std::sin(j * 0.157)});
  const auto lines = curvature_comb(circle, false);
  ASSERT_EQ(lines.size(), 2U);
  for (std::size_t i = 0; i + 3 < lines[0].values.size(); i += 4) {
    const double* t = &lines[0].values[i];
    EXPECT_NEAR(std::hypot(t[2], t[3]), 2 + std::hypot(t[2] - t[0], t[3] - t[1]), 1e-9);  // outwards
  }
  EXPECT_TRUE(curvature_comb(std::vector<double>{1, 1, 1, 1, 1, 1}, true).empty());
}

}  // namespace
}  // namespace twoscale::reports::hermite2010
