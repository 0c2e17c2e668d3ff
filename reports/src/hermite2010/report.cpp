// SPDX-License-Identifier: GPL-3.0-or-later
// The page: head, findings, sections, and all files written.
#include <fmt/format.h>

#include <filesystem>

#include "page.hpp"
#include "twoscale/kernels/write_file.hpp"

namespace twoscale::reports::hermite2010 {

namespace {

std::string head(const Summary& s, const std::vector<std::string>& findings) {
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\"/>\n<title>hermite2010, computed again</title>\n<style>" +
      page_style() +
      "</style>\n</head>\n<body>\n<header>\n<h1>hermite2010, computed again</h1>\n<p>L. Romani, <cite>A "
      "circle-preserving "
      "C² Hermite interpolatory subdivision scheme with tension control</cite>, 2010: its interpolant and rules, what "
      "is "
      "proved of them, the answer to its open question, and its figures.</p>\n</header>\n";
  html += fmt::format(
      "<div class=\"findings\"><ul>\n<li><strong>{} runs from points of a circle {} it</strong>: no refined point is "
      "farther "
      "from it than {} of its radius (double precision, 10 steps).</li>\n",
      s.circles, s.largest_deviation < 1e-12 ? "reproduce" : "do not all reproduce", number_text(s.largest_deviation));
  for (const auto& f : findings) html += "<li>" + f + "</li>\n";
  html +=
      "</ul></div>\n<nav><ul>\n<li><a href=\"#interpolant\">Interpolant</a></li><li><a href=\"#rules\">Rules</a></li>"
      "<li><a href=\"#verdicts\">Proofs</a></li><li><a href=\"#question\">Open question</a></li>";
  for (int figure = 1; figure <= 10; ++figure)
    html += fmt::format("<li><a href=\"#figure-{0}\">Figure {0}</a></li>", figure);
  return html + "<li><a href=\"#method\">How it was measured</a></li>\n</ul></nav>\n";
}

std::string method() {
  return fmt::format(
      "<section id=\"method\">\n<h2>How it was measured</h2>\n<ul>\n<li>Points alone are given; sigma is found by "
      "Algorithm 1 as docs/hermite.md mends it, p and r are those of the "
      "circle through the points, if there is one, else of the circle through a vertex and its two "
      "neighbours.</li>\n<li><em>Distance to polygon</em>: the "
      "largest distance of a "
      "refined point to the nearest edge, over the diagonal of the polygon’s bounding "
      "box.</li>\n<li><em>Curvature</em>: of the circle "
      "through three neighbouring points.</li>\n<li>Numbers as data: <a "
      "href=\"measurements.json\">measurements.json</a>; points in "
      "data/, pictures in figures/, certificates in certificates/. The commands are meant to be run in the directory "
      "of this "
      "page.</li>\n</ul>\n</section>\n<footer>twoscale {}. The page is self-contained; the same version writes the "
      "same "
      "bytes.</footer>\n</body>\n</html>\n",
      TWOSCALE_VERSION);
}

}  // namespace

Summary write_report(const std::string& directory, const Options& options) {
  const std::filesystem::path root(directory);
  for (const char* part : {"figures", "data", "certificates"}) make_directory(root / part);
  Summary summary;
  if (options.progress) options.progress("proofs");
  const Part formulas = formula_part(options, summary);
  const Part question = question_part(options, summary);
  const Part figures = figure_part(options, summary);
  nlohmann::ordered_json j;
  j["format"] = "twoscale/report";
  j["version"] = 1;
  j["scheme"] = nullptr;
  j["paper"] = "hermite2010";
  j["proofs"] = formulas.numbers;
  j["question"] = question.numbers;
  j["figures"] = figures.numbers;
  for (const Part* part : {&formulas, &question, &figures})
    for (const auto& [name, bytes] : part->files) kernels::write_file((root / name).string(), bytes);
  kernels::write_file((root / "measurements.json").string(), j.dump(1) + "\n");
  // The page last: when it is there, everything it refers to is there too.
  summary.index = (root / "index.html").string();
  std::vector<std::string> findings = question.findings;
  findings.insert(findings.end(), figures.findings.begin(), figures.findings.end());
  kernels::write_file(summary.index, head(summary, findings) + "<main>\n" + formulas.html + question.html +
                                         figures.html + "</main>\n" + method());
  return summary;
}

}  // namespace twoscale::reports::hermite2010
