// SPDX-License-Identifier: 0BSD
// A lowered scheme as plain data: one mask a level, the limit mask, and the words that go with them.
//
// Conventions. A step k -> k+1 is f^{k+1}_i = sum_j a^{[k]}_{i-m*j} f^k_j, k = 0, 1, ...; m is the arity. A mask is
// stored from its lowest index on: `value[s]` is a_{lowest+s}; zeros inside the support are kept and the support is the
// same at all levels and in the limit. The point f^k_j belongs to the parameter (j+p)/m^k; p is the shift.
// This header holds no algorithm: numeric/lowering fills a MaskTable, `refine` and the writers of export/ read it.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace twoscale::kernels {

/// The mask of one step, and optionally the rule that extends an open polygon before that step.
struct MaskRow {
  long lowest = 0;                ///< index of the first coefficient
  std::vector<std::string> text;  ///< decimals: the digits asked for, or the shortest round trip in double mode
  std::vector<double> value;      ///< the correctly rounded doubles; as many as `text`

  /// Extension weights for the points of *this* level (spacing m^{-k}), empty when there are none:
  /// p_{-1} = sum_j extension[j] p_j, j = 0, 1, ..., exact on the scheme's own space (its annihilator, solved for
  /// p_{-1}). At the right end the same weights apply mirrored (the space is closed under x -> -x).
  std::vector<double> extension;
  std::vector<std::string> extension_text;  ///< the same as decimals; empty or as many as `extension`

  /// Index of the last coefficient (lowest - 1 when the row is empty).
  long highest() const { return lowest + static_cast<long>(value.size()) - 1; }
};

/// A two-channel filter bank: dec_lo, dec_hi, rec_lo, rec_hi of one length, index origin 0.
struct FilterRow {
  std::array<std::vector<std::string>, 4> text;  ///< as MaskRow::text
  std::array<std::vector<double>, 4> value;
};

/// Masks of the steps 0..K-1, the limit mask, a bound on what lies between, and the provenance.
struct MaskTable {
  std::string scheme;       ///< id with its keys, as the user may type it
  int arity = 2;            ///< m >= 2
  std::string shift = "0";  ///< p, an exact number: "0", "1/2", "-3/4", "0.5"

  std::vector<std::pair<std::string, std::string>> parameters;       ///< name -> value, e.g. {"v0", "-2/5"}
  std::vector<std::pair<std::string, std::string>> level_variables;  ///< name -> meaning, {"v", "cosh(t/2^(k+1))"}

  int digits = 0;               ///< significant digits of the texts, all correct; 0: correctly rounded doubles
  std::string precision_error;  ///< bound on the error of any printed coefficient, e.g. "5e-51"

  std::vector<MaskRow> levels;  ///< levels[k] is the step k -> k+1, k = 0..K-1
  MaskRow limit;                ///< the mask as k -> infinity
  int tail_from = 0;            ///< K
  std::string tail_bound;       ///< proved: max over k >= K and i of |a^{[k]}_i - a_i|; "0" when stationary

  std::vector<FilterRow> filters;  ///< empty, or the banks of the steps 0..K-1 and of the limit

  std::string recurrence;  ///< how the next level follows, e.g. "v^{k+1} = sqrt((1+v^k)/2)"; empty if none
  std::string printed;  ///< what the numbers are, when not a^{[k]}_i itself: "a^{[k]}_i/2"; not fit for refinement then
  std::string normalisation;  ///< of the numbers, e.g. "coefficients sum to 2; every coset sums to 1 (constants are
                              ///< reproduced)"
};

/// Throws Error (bad_input) unless `table` can be used: arity >= 2, a readable shift, every row (and the limit) not
/// empty, `text` and `value` of the same length, finite values, decimals in the texts.
void validate(const MaskTable& table);

}  // namespace twoscale::kernels
