// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_jeong2013.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <iostream>

#include <nlohmann/json.hpp>

#include "twoscale/reports/jeong2013.hpp"

namespace twoscale::cli {

int report_jeong2013(const Common& common) {
  reports::jeong2013::Options options;
  if (!common.quiet && isatty(STDERR_FILENO) != 0)
    options.progress = [](const std::string& step) { std::cerr << "\r\033[K" << step << std::flush; };
  const reports::jeong2013::Summary s = reports::jeong2013::write_report(common.output, options);
  if (options.progress) std::cerr << "\r\033[K" << std::flush;
  if (common.format == "json") {
    nlohmann::ordered_json j;
    j["format"] = "twoscale/report-summary";
    j["version"] = 1;
    j["scheme"] = nullptr;
    j["paper"] = "jeong2013";
    j["index"] = s.index;
    j["pictures"] = s.pictures;
    j["exact_runs"] = s.exact_runs;
    j["largest_exact_deviation"] = s.largest_exact_deviation;
    std::cout << j.dump(1) << "\n";
  } else if (!common.quiet) {
    std::cout << fmt::format("{}: {} pictures, {} exact surfaces with a largest deviation of {:.3g}\n", s.index,
                             s.pictures, s.exact_runs, s.largest_exact_deviation);
  }
  return 0;
}

}  // namespace twoscale::cli
