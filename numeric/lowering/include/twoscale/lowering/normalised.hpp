// SPDX-License-Identifier: GPL-3.0-or-later
// Mask tables in the normalisation that their reader expects.
#pragma once

#include <string_view>

#include "twoscale/lowering/lower.hpp"

namespace twoscale::lowering {

// What is printed for the coefficient a_i of the scheme.
enum class Normalisation {
  arity,  // a_i as it is: subdivision. For sigma: sum m, the two-scale relation of phi (symbolic/bspline_function.hpp)
  sum1,   // a_i/m: low-pass filters of sum 1
  sqrt2,  // a_i/sqrt(m): filters of sum sqrt(2)
  convolution,  // a_i m^{-N} prod_j S_m(E_j), exponential B-splines only: the convolutions B^{[k]} without
                // normalisation
};
// "arity", "sum1", "sqrt2", "convolution"; anything else throws Error(bad_input).
Normalisation parse_normalisation(std::string_view text);

// lower() of the rescaled mask; every digit is proved as there, and MaskTable::printed says what the numbers are.
// Throws Error(bad_input) also for `convolution` if the mask is not sigma of the scheme's space.
kernels::MaskTable lower_normalised(const Scheme& scheme, Normalisation normalisation, const Binding& binding,
                                    const LowerOptions& options);

}  // namespace twoscale::lowering
