// SPDX-License-Identifier: GPL-3.0-or-later
// What the deciders share: reading their arguments, running over cases.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "audit/formula.hpp"
#include "twoscale/reports/audit.hpp"

namespace twoscale::reports::audit {

// The list of a key, empty if it is not there; its only entry, or Error(bad_input) naming the key.
const std::vector<std::string>& list_at(const Arguments& a, const std::string& key);
const std::string& text_at(const Arguments& a, const std::string& key);

std::string joined(const std::vector<std::string>& list, const std::string& separator);

// Runs one case after the other: the first that is refuted, else the first undecided, else proved.
Outcome over_cases(const Arguments& a, const std::function<Outcome(const Counters&)>& one);

// Deciders about schemes on knots at the vertices of the data (junction_deciders.cpp).
Outcome decide_at_junctions(const Arguments& a);
Outcome decide_eigenvalues(const Arguments& a);

}  // namespace twoscale::reports::audit
