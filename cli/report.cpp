// SPDX-License-Identifier: GPL-3.0-or-later
// twoscale report SCHEME|PAPER -o DIR: a self-contained HTML page.
#include <unistd.h>

#include <nlohmann/json.hpp>

#include <iostream>
#include <map>
#include <sstream>
#include <thread>

#include "report_hermite2010.hpp"
#include "report_jeong2013.hpp"
#include "session.hpp"
#include "twoscale/check/check.hpp"
#include "twoscale/reports/romani2009.hpp"
#include "twoscale/reports/scheme_report.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::cli {

namespace {

namespace romani2009 = reports::romani2009;

reports::CheckerVerdict check_certificate(std::string_view text) {
  const check::Report report = check::check_text(text);
  reports::CheckerVerdict v{report.status == check::Report::valid, report.lines};
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

std::function<void(const std::string&)> progress_of(const Common& common) {
  if (common.quiet || isatty(STDERR_FILENO) == 0) return {};
  return [](const std::string& step) { std::cerr << "\r\033[K" << step << std::flush; };
}

int report_romani2009(const Common& common) {
  romani2009::Options options;
  options.checker = check_certificate;
  options.progress = progress_of(common);
  const romani2009::Summary s = romani2009::write_report(common.output, options);
  if (options.progress) std::cerr << "\r\033[K" << std::flush;
  if (!common.quiet || common.format == "json")
    std::cout << (common.format == "json" ? summary_json("romani2009", s) : summary_text(s));
  return s.all_certificates_valid ? 0 : 1;
}

// The papers that have a page, and what writes it.
const std::map<std::string, int (*)(const Common&)>& papers() {
  static const std::map<std::string, int (*)(const Common&)> map = {
      {"hermite2010", [](const Common& c) { return report_hermite2010(c, check_certificate); }},
      {"jeong2013", report_jeong2013},
      {"romani2009", report_romani2009}};
  return map;
}

std::string summary_json(const std::string& scheme, const reports::SchemeReportSummary& s) {
  nlohmann::ordered_json j;
  j["format"] = "twoscale/report-summary";
  j["version"] = 1;
  j["scheme"] = scheme;
  j["index"] = s.index;
  j["pictures"] = s.pictures;
  j["verdicts"] = {{"proved", s.proved}, {"refuted", s.refuted}, {"undecided", s.undecided}};
  j["certificates_valid"] = s.all_certificates_valid;
  return j.dump(1) + "\n";
}

// 0 whatever is refuted: the report is done. 1 only if a certificate is not accepted.
int report_scheme(const std::string& subject, const Values& values, const Common& common) {
  const Scheme scheme = make_scheme(subject);
  reports::SchemeReportOptions options;
  options.name = subject;
  options.v0 = values.v0;
  options.t = values.t;
  options.at = values.named();
  if (common.time_limit > 0) options.seconds = 0.5 * common.time_limit;
  options.threads =
      common.threads > 0 ? common.threads : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  options.progress = progress_of(common);
  options.checker = check_certificate;
  const reports::SchemeReportSummary s = reports::write_scheme_report(scheme, common.output, options);
  if (options.progress) std::cerr << "\r\033[K" << std::flush;
  if (common.format == "json")
    std::cout << summary_json(scheme.id, s);
  else if (!common.quiet)
    std::cout << s.index << ": " << s.proved << " claims proved, " << s.refuted << " refuted, " << s.undecided
              << " undecided; " << s.pictures << " pictures, certificates "
              << (s.all_certificates_valid ? "valid" : "NOT valid") << "\n";
  return s.all_certificates_valid ? 0 : 1;
}

}  // namespace

void add_report_command(CLI::App& app, Session& session) {
  auto subject = std::make_shared<std::string>();
  auto values = std::make_shared<Values>();
  CLI::App* c = add_command(app, session, "report",
                            "write an HTML report with formulas, proofs and figures into the directory -o DIR");
  c->add_option("subject", *subject, "a scheme, or the paper hermite2010, jeong2013 or romani2009")
      ->required()
      ->type_name("SCHEME|PAPER");
  add_values(c, *values);
  c->callback([&session, subject, values] {
    session.keeps_time = true;
    session.action = [&session, subject, values] {
      const Common& common = session.common;
      if (common.output == "-") bad_input("report: name a directory, -o DIR");
      const auto paper = papers().find(*subject);
      if (paper == papers().end()) return report_scheme(*subject, *values, common);
      if (values->v0 || values->t || !values->at.empty())
        bad_input("report of a paper takes no values of parameters", *subject);
      return paper->second(common);
    };
  });
}

}  // namespace twoscale::cli
