// SPDX-License-Identifier: GPL-3.0-or-later
// What the HTML pages share: their style, their parts with the files that stand beside them, pieces of HTML.
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "twoscale/analysis/verdict.hpp"
#include "twoscale/reports/plot.hpp"
#include "twoscale/symbolic/space.hpp"

namespace twoscale::reports {

// One section of the page, the files that stand beside it, and the numbers behind it.
struct Part {
  std::string html;
  std::vector<std::pair<std::string, std::string>> files;  // relative path, bytes
  nlohmann::ordered_json numbers;
  std::vector<std::string> findings;  // HTML sentences for the head of the page
};

// The style sheet of every page.
std::string page_style();
// Makes the directory, and those above it. Throws Error(io).
void make_directory(const std::filesystem::path& path);

// <img> with the picture inside, and its file in figures/.
std::string embedded(Part& part, const std::string& name, const std::string& alternative, const Picture& picture);
std::string command(const std::string& line);       // a line of a <pre>, "$ " before it
std::string shell_quoted(const std::string& word);  // only when it needs quotes
std::string number_text(double value);              // HTML: "3.1·10<sup>−15</sup>", "0.027"
std::string space_html(const Space& space);         // "{1, x, ...}" as MathML
std::string prose(std::string text);                // the prover's plain text with proper signs, escaped
std::string verdict_table(const std::vector<analysis::Decision>& decisions);

}  // namespace twoscale::reports
