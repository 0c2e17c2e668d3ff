// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/reports/index.hpp"

#include <fmt/format.h>

#include "page.hpp"
#include "twoscale/reports/html.hpp"
#include "twoscale/reports/status.hpp"

namespace twoscale::reports {

namespace {

std::string css_class(StatusCell::Kind kind) {
  return kind == StatusCell::Kind::not_applicable ? "subject" : to_string(kind);
}

Section status_section(const std::vector<StatusRow>& rows) {
  Section section{"status", "Schemes", "What is proved of which scheme", {}};
  Part& part = section.part;
  part.numbers = nlohmann::ordered_json::array();
  std::string head;
  for (const auto& p : status_properties()) head += "<th>" + p + "</th>";
  part.html =
      "<p>Every cell is decided by the provers when this page is made: <span class=\"proved\">proved</span>, <span "
      "class=\"refuted\">refuted</span> (with a counterexample), <span class=\"undecided\">undecided</span>, or – "
      "where "
      "the question does not arise. <code>twoscale report SCHEME -o DIR</code> makes the page of a scheme, with the "
      "certificates.</p>\n<div class=\"wide\"><table class=\"grid status\"><thead><tr><th>scheme</th>" +
      head + "</tr></thead><tbody>\n";
  for (const StatusRow& row : rows) {
    part.html += "<tr><td><code>" + escaped(row.scheme) + "</code></td>";
    nlohmann::ordered_json j{{"scheme", row.scheme}};
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const StatusCell& c = row.cells[i];
      const std::string text = to_string(c.kind);
      const bool brief = c.detail.starts_with("C^") || c.detail.starts_with("order ");
      part.html += fmt::format("<td class=\"{}\" title=\"{}\">{}{}</td>", css_class(c.kind), escaped(c.detail), text,
                               brief ? " " + escaped(c.detail) : "");
      j[status_properties()[i]] = {{"status", text}, {"detail", c.detail}};
    }
    part.html += "</tr>\n";
    part.numbers.push_back(std::move(j));
  }
  part.html += "</tbody></table></div>\n";
  return section;
}

Section paper_section(const Paper& paper, const PaperSummary& summary) {
  Section section{paper.name, paper.name, paper.name, {}};
  Part& part = section.part;
  part.numbers = nlohmann::ordered_json::array();
  const std::string made_by = "twoscale report " + paper.name + " -o " + paper.name;
  part.html = "<p><cite>" + escaped(paper.reference) + "</cite>. <a href=\"" + paper.name +
              "/index.html\">The page</a> is made by</p>\n" + commands_html({made_by}) + "<div class=\"thumbnails\">\n";
  for (const PaperFigure& f : summary.figures) {
    part.html += fmt::format(
        "<figure><a href=\"{0}/index.html#panel-{1}\"><img src=\"{0}/{2}\" alt=\"{3}\"/></a><figcaption>{4}{3}{5}"
        "</figcaption></figure>\n",
        paper.name, f.id, f.file, escaped(f.title), f.numbered ? "<strong>" + f.id + "</strong> " : "",
        hidden_commands({f.command.empty() ? made_by : f.command}));
    part.numbers.push_back({{"figure", f.id}, {"title", f.title}, {"command", f.command}});
  }
  part.html += "</div>\n";
  return section;
}

}  // namespace

IndexSummary write_index(const std::string& directory, const PaperOptions& options) {
  make_directory(directory);  // refused before anything is computed
  IndexSummary summary;
  const std::vector<StatusRow> rows = status_matrix(true, options.progress);
  summary.schemes = static_cast<int>(rows.size());
  Page page;
  page.title = "twoscale: schemes and papers";
  page.lead = "<p>Subdivision schemes derived, proved and drawn; the figures of papers computed again.</p>\n";
  page.numbers = {{"scheme", nullptr}};
  page.sections.push_back(status_section(rows));
  for (const Paper& paper : papers()) {
    const PaperSummary s = paper.write((std::filesystem::path(directory) / paper.name).string(), options);
    summary.papers += 1;
    summary.figures += static_cast<int>(s.figures.size());
    summary.all_certificates_valid = summary.all_certificates_valid && s.all_certificates_valid;
    page.sections.push_back(paper_section(paper, s));
  }
  page.footer =
      fmt::format("twoscale {}. The commands below pictures are meant to be run in the directory of the paper’s page.",
                  TWOSCALE_VERSION);
  summary.index = write_page(directory, page);
  return summary;
}

}  // namespace twoscale::reports
