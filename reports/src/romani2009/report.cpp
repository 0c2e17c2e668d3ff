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
<<<<<<< HEAD
}

}  // namespace

std::string page_style() {
  static const char* const style = R"(
:root { color-scheme: light; }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1.5rem 1.25rem 4rem; max-width: 74rem; background: #fff; color: #1f2937;
  font: 16px/1.55 system-ui, "Segoe UI", "Liberation Sans", "DejaVu Sans", sans-serif; }
h1 { font-size: 1.8rem; line-height: 1.2; margin: .5rem 0 .25rem; }
h2 { font-size: 1.35rem; margin: 2.75rem 0 .75rem; padding-bottom: .3rem; border-bottom: 2px solid #0b5394; }
h3 { font-size: 1.1rem; margin: 2rem 0 .5rem; }
p, ul { max-width: 60rem; margin: .6rem 0; }
a { color: #0b5394; }
nav ul { display: flex; flex-wrap: wrap; gap: .25rem 1.25rem; padding: 0; list-style: none; }
code, pre { font: .85rem/1.5 ui-monospace, "Liberation Mono", "DejaVu Sans Mono", monospace; }
pre { background: #f3f4f6; border-radius: 4px; padding: .6rem .8rem; overflow-x: auto; margin: .5rem 0; }
.prompt { color: #6b7280; user-select: none; }
math { font-size: 1.05em; }
article { border: 1px solid #e5e7eb; border-radius: 6px; padding: 0 1.25rem 1rem; margin: 1.25rem 0; }
article h3 { margin-top: 1rem; }
.split { display: grid; grid-template-columns: minmax(0, 1.15fr) minmax(0, 1fr); gap: 1.5rem; align-items: center; }
.findings { background: #f0f6fc; border-left: 4px solid #0b5394; padding: .4rem 1.2rem; margin: 1rem 0; }
.findings li { margin: .4rem 0; }
table { border-collapse: collapse; font-size: .88rem; width: 100%; margin: .6rem 0; }
table.narrow { width: auto; }
th, td { text-align: left; padding: .25rem .6rem; border-bottom: 1px solid #e5e7eb; vertical-align: middle; }
th { font-weight: 600; color: #4b5563; }
.grid td, .grid th { text-align: center; white-space: nowrap; }
.grid td:first-child, .grid th:first-child { text-align: left; white-space: normal; }
.proved { color: #166534; font-weight: 600; }
.refuted { color: #b91c1c; font-weight: 600; }
.undecided { color: #92400e; font-weight: 600; }
.subject, .small { color: #6b7280; font-size: .85rem; }
.wide { overflow-x: auto; }
figure { margin: 0; }
figure img { display: block; max-width: 100%; height: auto; margin: 0 auto; }
figcaption { font-size: .9rem; margin-top: .3rem; }
.panels { display: grid; grid-template-columns: repeat(auto-fit, minmax(20rem, 1fr)); gap: 1.75rem 1.5rem; }
.panels > figure { max-width: 36rem; width: 100%; }
.panels > figure:only-child { max-width: none; display: grid; gap: 1.5rem;
  grid-template-columns: minmax(0, 1fr) minmax(0, 1.2fr); align-items: center; }
details { font-size: .9rem; margin: .4rem 0; }
summary { cursor: pointer; color: #0b5394; }
footer { margin-top: 3rem; border-top: 1px solid #e5e7eb; padding-top: .75rem; color: #6b7280; font-size: .85rem; }
@media (max-width: 48rem) { .split, .panels > figure:only-child { grid-template-columns: minmax(0, 1fr); } }
@media print {
  body { max-width: none; font-size: 10pt; padding: 0; }
  nav, details:not([open]) { display: none; }
  figure, article table, tr { break-inside: avoid; }
  h2, h3 { break-after: avoid; }
  .panels { grid-template-columns: 1fr 1fr; }
  a { color: inherit; text-decoration: none; }
}
)";
  return style;
}

void make_directory(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error || !std::filesystem::is_directory(path))
    throw Error(Error::Kind::io, "directory cannot be made", path.string());
}
=======
}

}  // namespace
>>>>>>> toml

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
