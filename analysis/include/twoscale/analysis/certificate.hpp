// SPDX-License-Identifier: GPL-3.0-or-later
// Canonical writer of certificates (format: docs/certificates.md). The checker in analysis/check shares no code with
// it.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

#include "twoscale/analysis/rational_matrix.hpp"
#include "twoscale/symbolic/scheme.hpp"

namespace twoscale::analysis {

struct MaskData {
  std::vector<LevelVariable> levels;   // sorted by name
  std::vector<std::string> constants;  // and level parameters without a frequency: identities hold for all values
  long lowest = 0;
  std::vector<Polynomial> numerators;  // a_{lowest+i} = numerators[i] / denominator
  Polynomial denominator;
};

// The mask of a scheme over a common denominator.
MaskData mask_data(const Scheme& scheme);

// The certificate's text, sealed with its digest. knots: the rule on arbitrary knots whose mask on equal ones this is.
std::string certificate_text(const Scheme& scheme, const MaskData& mask,
                             const std::vector<nlohmann::ordered_json>& claims,
                             const nlohmann::ordered_json& knots = nullptr);

// The same for claims about given matrices instead of a mask.
std::string certificate_text(const std::string& label, const std::vector<RationalMatrix>& matrices,
                             const std::vector<nlohmann::ordered_json>& claims);
// The same without a mask: claims that state themselves what they are about (positivity, root-bound); `label` is free
// text.
std::string certificate_text(const std::string& label, const std::vector<nlohmann::ordered_json>& claims);

// The same about the rules of a Hermite scheme (the member `hermite`).
std::string certificate_text(const std::string& label, const nlohmann::ordered_json& hermite,
                             const std::vector<nlohmann::ordered_json>& claims);

}  // namespace twoscale::analysis
