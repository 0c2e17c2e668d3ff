// SPDX-License-Identifier: GPL-3.0-or-later
// What the HTML pages share: their style, their parts with the files that stand beside them, pieces of HTML.
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "twoscale/analysis/verdict.hpp"
#include "twoscale/reports/checker.hpp"
#include "twoscale/reports/papers.hpp"
#include "twoscale/reports/plot.hpp"
#include "twoscale/reports/surface_plot.hpp"
#include "twoscale/symbolic/interpolatory.hpp"
#include "twoscale/symbolic/space.hpp"

namespace twoscale::reports {

// One section of the page, the files that stand beside it, and the numbers behind it.
struct Part {
  std::string html;
  std::vector<std::pair<std::string, std::string>> files;  // relative path, bytes
  nlohmann::ordered_json numbers;
  std::vector<std::string> findings;  // HTML sentences for the head of the page
  std::vector<PaperFigure> figures;   // in the order of the page
  int exact_runs = 0;                 // runs that should return something known
  double largest_exact_deviation = 0;
  bool certificates_valid = true;
  bool interactive = false;  // it needs the script of curves

  // One of the exact runs, and how far it is from what is known, over its size.
  void exact_run(double deviation);
  // Takes over everything of another part but its numbers, and returns its HTML.
  std::string absorb(Part part);
};

// A file of reports/assets, compiled in: "style", "copy", "curve". Required: it is there.
const std::string& asset(const std::string& name);
// A script of the page. Required: no "</script" in it.
std::string script(const std::string& text);
// Makes the directory, and those above it. Throws Error(io).
void make_directory(const std::filesystem::path& path);

// A figure of the page.
struct Drawing {
  std::string id;                     // "5a": its file figures/5a.svg, its element panel-5a
  std::string title;                  // plain text
  std::string detail;                 // HTML below: formulas, what was measured
  std::vector<std::string> commands;  // lines for a shell; the first draws or computes it
  bool numbered = true;               // the id is a number that readers see
};
// <figure> with the picture inside, and its file in figures/.
std::string figure(Part& part, const Drawing& drawing, const Picture& picture);
std::string figure(Part& part, const Drawing& drawing, const SurfacePicture& picture);

// A certificate: a file in certificates/, a link that holds it, what the checker says of it.
std::string certificate_html(Part& part, const std::string& name, const std::string& text, const Checker& checker);

std::string commands_html(const std::vector<std::string>& lines);    // <pre>, with prompts
std::string hidden_commands(const std::vector<std::string>& lines);  // behind a summary to be opened
std::string command(const std::string& line);                        // a line of a <pre>, "$ " before it
std::string shell_quoted(const std::string& word);                   // only when it needs quotes
std::string number_text(double value);                               // HTML: "3.1·10<sup>−15</sup>", "0.027"
std::string space_html(const Space& space);                          // "{1, x, ...}" as MathML
std::string prose(std::string text);                 // the prover's plain text with proper signs, escaped
std::string singular_table(const SingularSet& set);  // required: it has values
std::string verdict_table(const std::vector<analysis::Decision>& decisions);

}  // namespace twoscale::reports
