// SPDX-License-Identifier: GPL-3.0-or-later
// twoscale report PAPER -o DIR: a self-contained HTML page.
#include <unistd.h>

#include <nlohmann/json.hpp>

#include <iostream>
#include <sstream>

#include "report_jeong2013.hpp"
#include "session.hpp"
#include "twoscale/check/check.hpp"
#include "twoscale/reports/romani2009.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::cli {

namespace {

namespace romani2009 = reports::romani2009;

romani2009::Verdict check_certificate(std::string_view text) {
  const check::Report report = check::check_text(text);
  romani2009::Verdict v{report.status == check::Report::valid, report.lines};
  if (!report.message.empty()) v.lines.push_back(report.message);
  return v;
}

std::string summary_json(const std::string& subject, const romani2009::Summary& s) {
  nlohmann::ordered_json j;
  j["format"] = "twoscale/report-summary";
  j["version"] = 1;
  j["scheme"] = nullptr;
  j["paper"] = subject;
  j["index"] = s.index;
  j["pictures"] = s.pictures;
  j["exact_runs"] = s.exact_runs;
  j["largest_exact_deviation"] = s.largest_exact_deviation;
  j["certificates_valid"] = s.all_certificates_valid;
  return j.dump(1) + "\n";
}

std::string summary_text(const romani2009::Summary& s) {
  std::ostringstream out;
  out << s.index << ": " << s.pictures << " pictures, " << s.exact_runs << " exact curves with a largest deviation of "
      << s.largest_exact_deviation << ", certificates " << (s.all_certificates_valid ? "valid" : "NOT valid") << "\n";
  return out.str();
}

}  // namespace

void add_report_command(CLI::App& app, Session& session) {
  auto subject = std::make_shared<std::string>();
  CLI::App* c = add_command(app, session, "report",
                            "write an HTML report with formulas, proofs and figures into the directory -o DIR");
  c->add_option("subject", *subject, "romani2009 or jeong2013")->required()->type_name("PAPER");
  c->callback([&session, subject] {
    session.action = [&session, subject] {
      const Common& common = session.common;
      if (*subject != "romani2009" && *subject != "jeong2013")
        bad_input("report: only romani2009 and jeong2013 are available in this version, not", *subject);
      if (common.output == "-") bad_input("report: name a directory, -o DIR");
      if (*subject == "jeong2013") return report_jeong2013(common);
      romani2009::Options options;
      options.checker = check_certificate;
      if (!common.quiet && isatty(STDERR_FILENO) != 0)
        options.progress = [](const std::string& step) { std::cerr << "\r\033[K" << step << std::flush; };
      const romani2009::Summary s = romani2009::write_report(common.output, options);
      if (options.progress) std::cerr << "\r\033[K" << std::flush;
      if (!common.quiet || common.format == "json")
        std::cout << (common.format == "json" ? summary_json(*subject, s) : summary_text(s));
      return s.all_certificates_valid ? 0 : 1;
    };
  });
}

}  // namespace twoscale::cli
