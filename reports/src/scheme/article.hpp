// SPDX-License-Identifier: GPL-3.0-or-later
// A scheme within a page about a paper: its derivation, proofs and smoothness, as on a page of its own.
#pragma once

#include <string>
#include <vector>

#include "document.hpp"

namespace twoscale::reports {

struct Article {
  std::string id;                     // anchor, and the beginning of the names of its files
  std::string heading;                // plain text
  std::string formulas;               // HTML: the formulas as the paper writes them
  std::string scheme;                 // made from a space with one frequency
  std::vector<std::string> basic_v0;  // for its basic limit functions; the first is used in commands too
};
// Adds the numbers to `part`, an array, and returns the HTML.
std::string scheme_article(Part& part, const Article& article, const PaperOptions& options);

}  // namespace twoscale::reports
