// SPDX-License-Identifier: GPL-3.0-or-later
// A page written from its sections: head, navigation, sections, footer, the files beside it.
#pragma once

#include <string>
#include <vector>

#include "document.hpp"
#include "twoscale/reports/papers.hpp"

namespace twoscale::reports {

struct Section {
  std::string id;       // its anchor, and the member of report.json that holds its numbers (none: no member)
  std::string label;    // in the navigation; empty: not there
  std::string heading;  // plain text; empty: the label
  Part part;            // without HTML and files: left out
};

struct Page {
  std::string title;               // plain text
  std::string lead;                // HTML below the title
  nlohmann::ordered_json numbers;  // the first members of report.json after format and version
  std::vector<Section> sections;
  std::string footer;  // HTML
};

// Writes the page, the files of its sections and report.json; makes the directory. The page itself is written last:
// when it is there, everything it refers to is there too. Returns the path of the page. Throws Error(io).
std::string write_page(const std::string& directory, const Page& page);

// What a page about a paper is made from.
struct PaperPage {
  std::string paper;                // its name in papers()
  std::string about;                // HTML: what of it is computed
  std::vector<std::string> method;  // HTML items: how it was measured
};

// The page about a paper: what was found, the sections, how it was measured.
PaperSummary write_paper_page(const std::string& directory, const PaperPage& paper, std::vector<Section> sections);

}  // namespace twoscale::reports
