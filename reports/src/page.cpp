// SPDX-License-Identifier: GPL-3.0-or-later
#include "page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "twoscale/kernels/write_file.hpp"
#include "twoscale/reports/html.hpp"

namespace twoscale::reports {

namespace {

// Below this a point is where it should be: rounding in double precision.
constexpr double exact_limit = 1e-12;

bool empty(const Part& p) { return p.html.empty() && p.files.empty(); }

std::string section_html(const Section& s) {
  return "<section id=\"" + s.id + "\">\n<h2>" + escaped(s.heading.empty() ? s.label : s.heading) + "</h2>\n" +
         s.part.html + "</section>\n";
}

std::string list(const std::vector<std::string>& items) {
  std::string html;
  for (const auto& item : items) html += "<li>" + item + "</li>\n";
  return "<ul>\n" + html + "</ul>\n";
}

}  // namespace

std::string write_page(const std::string& directory, const Page& page) {
  std::string navigation, body;
  bool interactive = false;
  nlohmann::ordered_json j{{"format", "twoscale/report"}, {"version", 1}};
  j.update(page.numbers);
  for (const Section& s : page.sections) {
    if (empty(s.part)) continue;
    if (!s.label.empty()) navigation += "<li><a href=\"#" + s.id + "\">" + escaped(s.label) + "</a></li>\n";
    body += section_html(s);
    interactive = interactive || s.part.interactive;
    if (!s.part.numbers.is_null()) j[s.id] = s.part.numbers;
  }
  const std::filesystem::path root(directory);
  make_directory(root);
  for (const Section& s : page.sections)
    for (const auto& [name, bytes] : s.part.files) {
      make_directory((root / name).parent_path());
      kernels::write_file((root / name).string(), bytes);
    }
  kernels::write_file((root / "report.json").string(), j.dump(1) + "\n");
  const std::string index = (root / "index.html").string();
  kernels::write_file(index,
                      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" "
                      "content=\"width=device-width, initial-scale=1\"/>\n<title>" +
                          escaped(page.title) + "</title>\n<style>" + asset("style") +
                          "</style>\n</head>\n<body>\n<header>\n<h1>" + escaped(page.title) + "</h1>\n" + page.lead +
                          "</header>\n<nav><ul>\n" + navigation + "</ul></nav>\n<main>\n" + body + "</main>\n<footer>" +
                          page.footer + "</footer>\n" + script(asset("copy")) +
                          (interactive ? script(asset("curve")) : "") + "</body>\n</html>\n");
  return index;
}

PaperSummary write_paper_page(const std::string& directory, const PaperPage& text, std::vector<Section> sections) {
  const Paper* paper = find_paper(text.paper);
  if (paper == nullptr) throw std::logic_error("no such paper: " + text.paper);
  Part all;
  for (const Section& s : sections) {
    Part part = s.part;
    part.files.clear();
    all.absorb(std::move(part));
  }
  PaperSummary summary{"", all.figures, all.exact_runs, all.largest_exact_deviation, all.certificates_valid};
  std::vector<std::string> findings = all.findings;
  if (summary.exact_runs > 0)
    findings.insert(findings.begin(),
                    fmt::format("<strong>{} runs that should return a known {} {}</strong>: no refined point is "
                                "farther from it than {} of its size (double precision).",
                                summary.exact_runs, paper->exact,
                                summary.largest_exact_deviation < exact_limit ? "do" : "do not all",
                                number_text(summary.largest_exact_deviation)));
  Section method{"method", "How it was measured", "", {}};
  std::vector<std::string> items = text.method;
  items.push_back(
      "Numbers as data: <a href=\"report.json\">report.json</a>; what the commands read in data/, pictures in "
      "figures/. The commands on this page are meant to be run in the directory of this page.");
  method.part.html = list(items);
  sections.push_back(std::move(method));
  Page page;
  page.title = text.paper + ", computed again";
  page.lead = "<p><cite>" + escaped(paper->reference) + "</cite>: " + text.about + "</p>\n" +
              (findings.empty() ? "" : "<div class=\"findings\">" + list(findings) + "</div>\n");
  page.numbers = {{"scheme", nullptr}, {"paper", text.paper}};
  page.sections = std::move(sections);
  page.footer = std::string("twoscale ") + TWOSCALE_VERSION +
                ". The page is self-contained; the same version writes the same bytes.";
  summary.index = write_page(directory, page);
  return summary;
}

}  // namespace twoscale::reports
