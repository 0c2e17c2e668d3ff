// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_hermite2010.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <iostream>

#include <nlohmann/json.hpp>

#include "twoscale/reports/hermite2010.hpp"

namespace twoscale::cli {

int report_hermite2010(const Common& common, const reports::Checker& checker) {
  reports::hermite2010::Options options;
  options.checker = checker;
  if (!common.quiet && isatty(STDERR_FILENO) != 0)
    options.progress = [](const std::string& step) { std::cerr << "\r\033[K" << step << std::flush; };
  const reports::hermite2010::Summary s = reports::hermite2010::write_report(common.output, options);
  if (options.progress) std::cerr << "\r\033[K" << std::flush;
  if (common.format == "json") {
    nlohmann::ordered_json j;
    j["format"] = "twoscale/report-summary";
    j["version"] = 1;
    j["scheme"] = nullptr;
    j["paper"] = "hermite2010";
    j["index"] = s.index;
    j["pictures"] = s.pictures;
    j["circles"] = s.circles;
    j["largest_deviation"] = s.largest_deviation;
    j["certificates_valid"] = s.all_certificates_valid;
    std::cout << j.dump(1) << "\n";
  } else if (!common.quiet) {
    std::cout << fmt::format("{}: {} pictures, {} circles with a largest deviation of {:.3g}, certificates {}\n",
                             s.index, s.pictures, s.circles, s.largest_deviation,
                             s.all_certificates_valid ? "valid" : "NOT valid");
  }
  return s.all_certificates_valid ? 0 : 1;
}

}  // namespace twoscale::cli
