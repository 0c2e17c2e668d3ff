// SPDX-License-Identifier: GPL-3.0-or-later
// What the parts of the page share.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "twoscale/reports/plot.hpp"
#include "twoscale/reports/romani2009.hpp"
#include "twoscale/symbolic/scheme.hpp"

#include <nlohmann/json.hpp>

namespace twoscale::reports::romani2009 {

// One section of the page, the files that stand beside it, and the numbers behind it.
struct Part {
  std::string html;
  std::vector<std::pair<std::string, std::string>> files;  // relative path, bytes
  nlohmann::ordered_json numbers;
  std::vector<std::string> findings;  // HTML sentences for the head of the page
};

struct SixPoint {
  const char* name;     // "mixed"
  const char* section;  // "4.1"
  const char* what;
  const char* scheme;
  std::vector<const char*> basic_v0;  // for its basic limit functions
};
const std::vector<SixPoint>& six_point_schemes();

Part scheme_part(const Options& options, Summary& summary);
Part count_part();
Part figure_part(const Options& options, Summary& summary);
// Distance of the limit curve to the polygon of figure 8 over a fine grid of v^0.
Part tension_part();

// ---- Pieces

std::string page_style();
// Makes the directory, and those above it. Throws Error(io).
void make_directory(const std::filesystem::path& path);

// <img> with the picture inside, and its file in figures/.
std::string embedded(Part& part, const std::string& name, const std::string& alternative, const Picture& picture);
std::string command(const std::string& line);         // a line of a <pre>, "$ " before it
std::string shell_quoted(const std::string& word);    // only when it needs quotes
std::string scheme_label(const std::string& scheme);  // "6-point harmonic"
std::string v0_html(const std::string& v0);           // inline MathML, "-" for none
std::string number_text(double value);                // HTML: "3.1·10<sup>−15</sup>", "0.027"

}  // namespace twoscale::reports::romani2009
