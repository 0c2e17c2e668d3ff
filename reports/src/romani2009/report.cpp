// SPDX-License-Identifier: GPL-3.0-or-later
// The page: head, findings, sections, and all files written.
#include <fmt/format.h>

#include <filesystem>

#include "page.hpp"
#include "twoscale/kernels/write_file.hpp"

namespace twoscale::reports::romani2009 {

namespace {

std::string head(const Summary& s, const std::vector<std::string>& findings) {
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\"/>\n"
      "<title>romani2009, computed again</title>\n<style>" +
      page_style() +
      "</style>\n</head>\n<body>\n<header>\n<h1>romani2009, computed again</h1>\n"
      "<p>L. Romani, <cite>From approximating subdivision schemes for exponential splines to high-performance "
      "interpolating algorithms</cite>: the three "
      "6-point schemes derived from their spaces, proved, and run on the paper’s twelve figures. Each picture comes "
      "with what was measured on it.</p>\n</header>\n";
  html += fmt::format(
      "<div class=\"findings\"><ul>\n<li><strong>{} runs that should return a known curve do</strong>: after {} levels "
      "no point is farther from it than {} of the "
      "curve’s size (double precision).</li>\n",
      s.exact_runs, measured_levels, number_text(s.largest_exact_deviation));
  if (s.largest_exact_deviation >= 1e-12) html = html.replace(html.find("do</strong>"), 11, "do not all</strong>");
  for (const auto& f : findings) html += "<li>" + f + "</li>\n";
  html +=
      "</ul></div>\n<nav><ul>\n<li><a href=\"#schemes\">Schemes</a></li><li><a href=\"#counts\">Numbers of "
      "points</a></li>";
  for (const Figure& f : figures()) html += fmt::format("<li><a href=\"#figure-{0}\">Figure {0}</a></li>", f.number);
  return html + "<li><a href=\"#method\">How it was measured</a></li>\n</ul></nav>\n";
}

std::string method() {
  return fmt::format(
      "<section id=\"method\">\n<h2>How it was measured</h2>\n<ul>\n"
      "<li>Formulas and verdicts are exact, for all levels at once. A verdict comes with a certificate; the checker "
      "that re-verifies it shares no code and no "
      "computer algebra with the prover.</li>\n"
      "<li>Masks are lowered to correctly rounded doubles; curves are refined in double precision: {} levels for the "
      "numbers, {} for the pictures.</li>\n"
      "<li><em>Largest deviation</em>: every refined point is compared with the true curve at the same parameter (not "
      "with its nearest point); the largest distance, over the "
      "diagonal of the curve’s bounding box.</li>\n"
      "<li><em>Distance to polygon</em>: the largest distance of a refined point to the nearest edge, over the "
      "diagonal of the polygon’s bounding box. "
      "<em>Turning</em>: the sum of the absolute turning angles in full turns; what a curve turns more than its "
      "polygon is oscillation.</li>\n"
      "<li>Open curves: 2l − 2 = 4 samples of the same formula beyond each end, so that no end rule is involved.</li>\n"
      "<li>Numbers as data: <a href=\"measurements.json\">measurements.json</a>; starting points in data/, pictures in "
      "figures/, certificates in certificates/. "
      "The commands on this page are meant to be run in the directory of this page.</li>\n</ul>\n</section>\n"
      "<footer>twoscale {}. The page is self-contained; the same version writes the same "
      "bytes.</footer>\n</body>\n</html>\n",
      measured_levels, drawn_levels, TWOSCALE_VERSION);
}

}  // namespace

Summary write_report(const std::string& directory, const Options& options) {
  const std::filesystem::path root(directory);
  for (const char* part : {"certificates", "figures", "data"}) make_directory(root / part);
  Summary summary;
  const Part schemes = scheme_part(options, summary);
  const Part counts = count_part();
  const Part pictures = figure_part(options, summary);
  nlohmann::ordered_json j;
  j["format"] = "twoscale/report";
  j["version"] = 1;
  j["scheme"] = nullptr;
  j["paper"] = "romani2009";
  j["levels"] = measured_levels;
  j["schemes"] = schemes.numbers;
  j["numbers_of_points"] = counts.numbers;
  j["panels"] = pictures.numbers;
  for (const Part* part : {&schemes, &counts, &pictures})
    for (const auto& [name, bytes] : part->files) kernels::write_file((root / name).string(), bytes);
  kernels::write_file((root / "measurements.json").string(), j.dump(1) + "\n");
  // The page last: when it is there, everything it refers to is there too.
  summary.index = (root / "index.html").string();
  kernels::write_file(summary.index, head(summary, pictures.findings) + "<main>\n" + schemes.html + counts.html +
                                         pictures.html + "</main>\n" + method());
  return summary;
}

}  // namespace twoscale::reports::romani2009
