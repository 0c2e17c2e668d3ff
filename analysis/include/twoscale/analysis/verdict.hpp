// SPDX-License-Identifier: GPL-3.0-or-later
// Three-valued answers with their evidence.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace twoscale::analysis {

enum class Verdict { proved, refuted, undecided };

std::string to_string(Verdict v);

// The decision on one claim about a scheme.
struct Decision {
  std::string claim;    // its name
  std::string subject;  // what it is about: a space, an order, ...; may be empty
  Verdict verdict = Verdict::undecided;
  std::string domain;                   // for which levels and parameter values
  std::vector<std::string> exceptions;  // values at which nothing is claimed, or the scheme does not exist
  std::string witness;                  // refuted: a counterexample a person can check; undecided: the reason
  nlohmann::ordered_json evidence;      // the entry of the certificate; null when undecided
  std::vector<nlohmann::ordered_json> supporting;  // continuity: the entries that together establish it
};

}  // namespace twoscale::analysis
