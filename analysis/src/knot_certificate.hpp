// SPDX-License-Identifier: GPL-3.0-or-later
// Entries of certificates about rules on knots (docs/certificates.md, "Rules on knots").
#pragma once

#include <nlohmann/json.hpp>

#include <optional>

#include "twoscale/analysis/knots.hpp"

namespace twoscale::analysis {

// The member `knots`: the rule of the scheme. Null if it has more variables or weights than the format holds.
nlohmann::ordered_json knot_rule_json(const Scheme& scheme);

// The entry `junction` of one case, for the radius 2^-l: proved, or proved exactly where the boundary polynomial is
// positive. Null if a part of it is not proved: a denominator, a piece, a bound.
nlohmann::ordered_json junction_entry(const Scheme& scheme, const JunctionCase& c, long l);

// The entry `junction`, refuted at numbers.
nlohmann::ordered_json junction_counterexample(const Scheme& scheme, const Rational& alpha, const Rational& left,
                                               const Rational& right, long kept, long l);

}  // namespace twoscale::analysis
