// SPDX-License-Identifier: GPL-3.0-or-later
// The page: head, findings, sections, and all files written.
#include <fmt/format.h>

#include <filesystem>

#include "page.hpp"
#include "twoscale/kernels/write_file.hpp"

namespace twoscale::reports::jeong2013 {

namespace {

std::string head(const Summary& s, const std::vector<std::string>& findings) {
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\"/>\n<title>jeong2013, computed again</title>\n<style>" +
      page_style() +
      "</style>\n</head>\n<body>\n<header>\n<h1>jeong2013, computed again</h1>\n"
      "<p>B. Jeong, Y. J. Lee, J. Yoon, <cite>A family of non-stationary subdivision schemes reproducing exponential "
      "polynomials</cite>: the curves and surfaces of its figures, with what was measured on them.</p>\n</header>\n";
  html += fmt::format(
      "<div class=\"findings\"><ul>\n<li><strong>{} runs that should return a known surface {}</strong>: no refined "
      "point is "
      "farther from it than {} of its size (double precision).</li>\n",
      s.exact_runs, s.largest_exact_deviation < 1e-12 ? "do" : "do not all", number_text(s.largest_exact_deviation));
  for (const auto& f : findings) html += "<li>" + f + "</li>\n";
  html += "</ul></div>\n<nav><ul>\n";
  for (const int figure : {1, 2, 4, 5, 6, 7, 8, 9})
    html += fmt::format("<li><a href=\"#figure-{0}\">Figure {0}</a></li>", figure);
  return html + "<li><a href=\"#method\">How it was measured</a></li>\n</ul></nav>\n";
}

std::string method() {
  return fmt::format(
      "<section id=\"method\">\n<h2>How it was measured</h2>\n<ul>\n"
      "<li>Masks are exact expressions, lowered to correctly rounded doubles; points are refined in double "
      "precision.</li>\n"
      "<li><em>Largest deviation</em>: every refined point of a surface is compared with the surface at the same "
      "parameters; "
      "the largest distance, over the diagonal of the surface’s bounding box.</li>\n"
      "<li><em>Samples determine</em>: n samples of a closed direction suffice for the interpolating scheme exactly "
      "when no "
      "sum and no difference of two of its numbers of turns (0 among them) is a multiple of n other than 0.</li>\n"
      "<li><em>Distance to polygon</em>: the largest distance of a refined point to the nearest edge, over the "
      "diagonal of "
      "the polygon’s bounding box. <em>Turning</em>: the sum of the absolute turning angles in full turns.</li>\n"
      "<li>Control points are the paper’s for figure 6 only; it prints no others.</li>\n"
      "<li>Numbers as data: <a href=\"measurements.json\">measurements.json</a>; control points and descriptions in "
      "data/, "
      "pictures in figures/. The commands are meant to be run in the directory of this page.</li>\n</ul>\n</section>\n"
      "<footer>twoscale {}. The page is self-contained; the same version writes the same "
      "bytes.</footer>\n</body>\n</html>\n",
      TWOSCALE_VERSION);
}

}  // namespace

Summary write_report(const std::string& directory, const Options& options) {
  const std::filesystem::path root(directory);
  for (const char* part : {"figures", "data"}) make_directory(root / part);
  Summary summary;
  const Part curves = curve_part(options, summary);
  const Part pictures = surface_part(options, summary);
  nlohmann::ordered_json j;
  j["format"] = "twoscale/report";
  j["version"] = 1;
  j["scheme"] = nullptr;
  j["paper"] = "jeong2013";
  j["curves"] = curves.numbers;
  j["surfaces"] = pictures.numbers;
  for (const Part* part : {&curves, &pictures})
    for (const auto& [name, bytes] : part->files) kernels::write_file((root / name).string(), bytes);
  kernels::write_file((root / "measurements.json").string(), j.dump(1) + "\n");
  // The page last: when it is there, everything it refers to is there too.
  summary.index = (root / "index.html").string();
  std::vector<std::string> findings = pictures.findings;
  findings.insert(findings.end(), curves.findings.begin(), curves.findings.end());
  // Figures 1 to 5 and 8, 9 are curves; the surfaces stand between them.
  const std::size_t eight = curves.html.find("<section class=\"figure\" id=\"figure-8\">");
  kernels::write_file(summary.index, head(summary, findings) + "<main>\n" + curves.html.substr(0, eight) +
                                         pictures.html + curves.html.substr(eight) + "</main>\n" + method());
  return summary;
}

}  // namespace twoscale::reports::jeong2013
