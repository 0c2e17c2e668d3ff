// SPDX-License-Identifier: GPL-3.0-or-later
// twoscale report SCHEME|PAPER|index -o DIR: a self-contained HTML page; --format md, latex: a text instead.
#include <fmt/format.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include <iostream>
#include <thread>

#include "session.hpp"
#include "twoscale/check/check.hpp"
#include "twoscale/reports/index.hpp"
#include "twoscale/reports/papers.hpp"
#include "twoscale/reports/scheme_report.hpp"
#include "twoscale/reports/status.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::cli {

namespace {

reports::CheckerVerdict check_certificate(std::string_view text) {
  const check::Report report = check::check_text(text);
  reports::CheckerVerdict v{report.status == check::Report::valid, report.lines};
  if (!report.message.empty()) v.lines.push_back(report.message);
  return v;
}

std::function<void(const std::string&)> progress_of(const Common& common) {
  if (common.quiet || isatty(STDERR_FILENO) == 0) return {};
  return [](const std::string& step) { std::cerr << "\r\033[K" << step << std::flush; };
}

void clear_progress(const std::function<void(const std::string&)>& progress) {
  if (progress) std::cerr << "\r\033[K" << std::flush;
}

nlohmann::ordered_json summary_head() { return {{"format", "twoscale/report-summary"}, {"version", 1}}; }

std::string summary_json(const reports::Paper& paper, const reports::PaperSummary& s) {
  nlohmann::ordered_json j = summary_head();
  j["scheme"] = nullptr;
  j["paper"] = paper.name;
  j["index"] = s.index;
  j["pictures"] = s.figures.size();
  j["exact_runs"] = s.exact_runs;
  j["largest_exact_deviation"] = s.largest_exact_deviation;
  j["certificates_valid"] = s.all_certificates_valid;
  return j.dump(1) + "\n";
}

int report_paper(const reports::Paper& paper, const Common& common) {
  const reports::PaperOptions options{check_certificate, progress_of(common)};
  const reports::PaperSummary s = paper.write(common.output, options);
  clear_progress(options.progress);
  if (common.format == "json")
    std::cout << summary_json(paper, s);
  else if (!common.quiet)
    std::cout << fmt::format("{}: {} pictures, {} exact {}s with a largest deviation of {:.3g}, certificates {}\n",
                             s.index, s.figures.size(), s.exact_runs, paper.exact, s.largest_exact_deviation,
                             s.all_certificates_valid ? "valid" : "NOT valid");
  return s.all_certificates_valid ? 0 : 1;
}

std::string summary_json(const std::string& scheme, const reports::SchemeReportSummary& s) {
  nlohmann::ordered_json j = summary_head();
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
  clear_progress(options.progress);
  if (common.format == "json")
    std::cout << summary_json(scheme.id, s);
  else if (!common.quiet)
    std::cout << s.index << ": " << s.proved << " claims proved, " << s.refuted << " refuted, " << s.undecided
              << " undecided; " << s.pictures << " pictures, certificates "
              << (s.all_certificates_valid ? "valid" : "NOT valid") << "\n";
  return s.all_certificates_valid ? 0 : 1;
}

int report_index(const Common& common) {
  const reports::PaperOptions options{check_certificate, progress_of(common)};
  const reports::IndexSummary s = reports::write_index(common.output, options);
  clear_progress(options.progress);
  if (common.format == "json") {
    nlohmann::ordered_json j = summary_head();
    j["scheme"] = nullptr;
    j["index"] = s.index;
    j["schemes"] = s.schemes;
    j["papers"] = s.papers;
    j["figures"] = s.figures;
    j["certificates_valid"] = s.all_certificates_valid;
    std::cout << j.dump(1) + "\n";
  } else if (!common.quiet) {
    std::cout << fmt::format("{}: {} schemes, {} figures of {} papers, certificates {}\n", s.index, s.schemes,
                             s.figures, s.papers, s.all_certificates_valid ? "valid" : "NOT valid");
  }
  return s.all_certificates_valid ? 0 : 1;
}

// --format md, latex: to the file -o, or printed.
int report_text(const std::string& subject, const Common& common) {
  const bool markdown = common.format == "md";
  if (reports::find_paper(subject) != nullptr || (subject == "index" && !markdown))
    bad_input("report " + subject + ": there is a page only, no", common.format);
  if (subject == "index") {
    const auto progress = progress_of(common);
    const std::string text = reports::to_markdown(reports::status_matrix(false, progress));
    clear_progress(progress);
    deliver(common, text);
    return 0;
  }
  const Scheme scheme = make_scheme(subject);
  deliver(common, markdown ? reports::scheme_markdown(scheme) : reports::scheme_latex(scheme));
  return 0;
}

}  // namespace

void add_report_command(CLI::App& app, Session& session) {
  auto subject = std::make_shared<std::string>();
  auto values = std::make_shared<Values>();
  CLI::App* c = add_command(app, session, "report",
                            "write an HTML report with formulas, proofs and figures into the directory -o DIR",
                            {"text", "json", "md", "latex"});
  std::string papers;
  for (const reports::Paper& p : reports::papers()) papers += (papers.empty() ? "" : ", ") + p.name;
  c->add_option("subject", *subject,
                "a scheme, a paper (" + papers + "), or index: the status of all schemes and the figures of all papers")
      ->required()
      ->type_name("SCHEME|PAPER|index");
  add_values(c, *values);
  c->callback([&session, subject, values] {
    session.keeps_time = true;
    session.action = [&session, subject, values] {
      const Common& common = session.common;
      const reports::Paper* paper = reports::find_paper(*subject);
      const bool with_values = values->v0 || values->t || !values->at.empty();
      if (common.format == "md" || common.format == "latex") {
        if (with_values) bad_input("report --format " + common.format + " takes no values of parameters", *subject);
        return report_text(*subject, common);
      }
      if (common.output == "-") bad_input("report: name a directory, -o DIR");
      if (paper == nullptr && *subject != "index") return report_scheme(*subject, *values, common);
      if (with_values) bad_input("report of a paper takes no values of parameters", *subject);
      return paper != nullptr ? report_paper(*paper, common) : report_index(common);
    };
  });
}

}  // namespace twoscale::cli
