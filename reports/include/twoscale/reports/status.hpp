// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of the schemes of the catalogue: a matrix of schemes and properties, every cell decided anew by the
// provers. Nothing of it is written down anywhere.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace twoscale::reports {

struct StatusCell {
  enum class Kind { proved, refuted, undecided, not_applicable };
  Kind kind = Kind::not_applicable;
  std::string detail;  // what is proved or refuted ("C^2", "order 4", a space), or why it is undecided
};
// "proved", "refuted", "undecided", "-".
std::string to_string(StatusCell::Kind kind);

struct StatusRow {
  std::string scheme;             // as the catalogue spells it
  std::string source;             // paper and place
  std::vector<StatusCell> cells;  // in the order of status_properties()
};

const std::vector<std::string>& status_properties();

// All properties of one scheme. Of its source's claims and of the same questions where the source is silent.
StatusRow status_of(const std::string& scheme);

// One row for each entry of the catalogue, its first example; or one for every example.
std::vector<StatusRow> status_matrix(bool every_example, const std::function<void(const std::string&)>& progress);

std::string to_markdown(const std::vector<StatusRow>& rows);

}  // namespace twoscale::reports
