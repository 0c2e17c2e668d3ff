// SPDX-License-Identifier: GPL-3.0-or-later
// Emitted evaluators: the table of a scheme with symbolic parameters as a small program in another language.
//
// The program, called PREFIX here, has the same shape in every language (C++: the namespace PREFIX):
//
//   PREFIX_arity, PREFIX_lowest, PREFIX_size, PREFIX_p     constants
//   PREFIX_start(v0, ...)    the level variables of the step 0, v^{[1]}, from v^{[0]}
//   PREFIX_next(v, ...)      those of the step k+1, v^{[k+2]}, from those of the step k, v^{[k+1]}
//   PREFIX_mask(level variables, constants, local parameters)    PREFIX_size numbers
//
// The level variables, and the constants, come in the order of Scheme::parameters, local parameters offset by offset.
// mask() of a uniform scheme: a_i, i = lowest, lowest+1, ...; of one with blocks, each block row by row. With local
// parameters: the rule of the new vertex in the middle of the edge [x_j, x_{j+1}] that acts on f_{j+lowest}, ...; the
// matrix of the command `stencil` row by row (columns derivative by derivative, vertex by vertex).
//
// How it computes. A coefficient is a product of powers of irreducible polynomials over another such product: nothing
// cancels between the two, and no value is special. A polynomial whose terms have one sign where the parameters may
// lie, or which is a difference of two exact terms, is evaluated as it stands; any other one in twice the precision
// (error-free products and sums), so that its value is right to the last bit next to its zeros too. From there on only
// products and one quotient follow. Hence a bound for the relative error of every coefficient, counted in units of
// u = 2^-53 (GLSL: 2^-24), which the header states; it holds for exact arguments, next to singular values as well.
// Equal parts are computed once.
//
// Level variables: v -> sqrt((1 + v)/2) for a frequency at arity 2; any other relation v^{[k]} = R(v^{[k+1]}) is solved
// by Newton's method, safeguarded by bisection on the branch of level_relation.hpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "twoscale/lowering/lower.hpp"

namespace twoscale::lowering {

enum class Language { c, cpp, python, julia, glsl, typescript, javascript };

const std::vector<Language>& evaluator_languages();
std::string_view name(Language language);    // "c", "cpp", ...: the format name of the command line
std::string_view suffix(Language language);  // of files, without the dot
// Throws Error(bad_input) naming a text that is none of them.
Language parse_language(std::string_view text);

struct EmitOptions {
  std::string prefix = {};  // an identifier; empty: made from the scheme id
  // Constants are substituted exactly. A level variable with a value stays an argument of next and mask, since it
  // changes from level to level, and is none of start, which knows v^{[1]} as a correctly rounded double.
  Binding values = {};
  // Values of local parameters, by their names in the stencils (local_name); substituted exactly.
  std::vector<std::pair<std::string, Rational>> local_values = {};
};

// The whole file. Deterministic. Throws Error(bad_input) for a prefix that is no identifier, for a constant that is
// given and not rational, for a value at which a rule has a pole, and for a scheme with local parameters that has
// another arity than 2 or does not keep its old vertices.
std::string emit_evaluator(const Scheme& scheme, Language language, const EmitOptions& options = {});

}  // namespace twoscale::lowering
