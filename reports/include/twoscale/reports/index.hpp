// SPDX-License-Identifier: GPL-3.0-or-later
// The front page of all reports: the status of every scheme, and the figures of every paper.
#pragma once

#include <string>

#include "twoscale/reports/papers.hpp"

namespace twoscale::reports {

struct IndexSummary {
  std::string index;  // path of the page
  int schemes = 0;
  int papers = 0;
  int figures = 0;
  bool all_certificates_valid = true;
};

// Writes directory/index.html and report.json, and the page of each paper in directory/PAPER/. The thumbnails are the
// papers' pictures there. Throws Error(io).
IndexSummary write_index(const std::string& directory, const PaperOptions& options);

}  // namespace twoscale::reports
