// SPDX-License-Identifier: GPL-3.0-or-later
// Scheme: the one value that every recipe fills and every analysis, table, kernel and report reads.
//
// f^{k+1}_{m j + s} = sum_h phases[s](h) f^k_{j+h}, s = 0..m-1; in symbol form a_{s - m h} = phases[s](h), so that
// f^{k+1}_i = sum_j a_{i-mj} f^k_j. Stationary, level-dependent, non-uniform and Hermite are derived
// properties: they differ in the scope of the parameters and in the block size only.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "twoscale/symbolic/laurent.hpp"
#include "twoscale/symbolic/level_relation.hpp"
#include "twoscale/symbolic/space.hpp"

namespace twoscale {

// A symbol in the coefficients of a scheme.
struct Parameter {
  enum class Scope {
    constant,  // one value for the whole run
    level,     // v = v^{[k+1]}, tied to the coarser value; v^{[k]} -> 1
    local,     // one value for each place: knot intervals, edge parameters
  };
  std::string name;
  Scope scope = Scope::constant;
  std::optional<LevelVariable> frequency = {};  // of a level parameter with v^k = T_m(v^{k+1})
  // Of a local parameter: the stencils of the edge [x_i, x_{i+1}] read its values at the edges i + offset, under the
  // names local_name(name, offset).
  std::vector<long> offsets = {};
  std::optional<RationalFunction> relation = {};  // of any other level parameter: v^k = R(v^{k+1}), R in "x", R(1) = 1
  std::optional<Spelling> spelling = {};          // how its user spells a level parameter
  std::optional<Domain> domain = {};  // of the values, of v^{[0]} in the user's spelling for a level parameter
  std::string default_value = {};     // an expression; empty: a value must be given
  std::string help = {};
  // Of a local parameter that belongs to the data: its value at every edge that touches no vertex of the data (edge
  // parameters; they are inherited by the two edges at a vertex). Without it the parameter is a knot interval, halved
  // at every step.
  std::optional<Rational> rest = {};
};

// How a stencil spells the value of a local parameter: d_0, d_1, and d_m1 for offset -1.
std::string local_name(const std::string& name, long offset);

// One refinement rule. blocks[i] acts on f^k_{j + lowest + i}: block x block rational functions, row-major.
struct Stencil {
  long lowest = 0;
  std::vector<std::vector<RationalFunction>> blocks;
};

// A rule that is rational in pieces: where `where` >= 0 at the local parameters, `phases` hold instead.
struct Piece {
  Polynomial where;
  std::vector<Stencil> phases;
};

// What the source of a scheme says about it; `prove` decides it.
struct Claim {
  std::string name;     // interpolatory, symmetric, generates, reproduces, maximal, sum-rules, well-defined, ...
  std::string subject;  // a space, an order; may be empty
  std::string source;   // paper and place; may be empty
};

struct Scheme {
  std::string id;  // as the catalog spells it, e.g. "interpolating:family=mixed,l=3"
  std::string title;
  std::string source;  // paper and place
  int arity = 2;
  int block = 1;
  std::vector<Parameter> parameters;
  std::vector<Stencil> phases;      // arity of them
  std::vector<Piece> pieces;        // the first that applies holds; `phases` where none does
  Rational shift;                   // p: parameters t^k_j = (j + p)/m^k
  std::optional<Space> space;       // the space it was built from, in the level variables of `parameters`
  std::optional<Space> reproduced;  // the part of it that the recipe asked to be reproduced, if it did
  std::vector<Claim> claims;
  // With local parameters: the numerical kernel that refines points by this rule (kernels/nonuniform.hpp); empty: none.
  std::string kernel = {};

  // A scalar uniform scheme from its symbol; p is (a'(1)/a(1))/(m-1), which is c/(m-1) for a mask symmetric about c.
  // Throws Error(bad_input) if p would depend on a parameter or a(1) = 0. A `shift` that is given is taken.
  static Scheme from_symbol(std::string id, const Laurent& symbol, int arity, std::vector<Parameter> parameters,
                            const std::optional<Rational>& shift = {});
};

// The symbol a(z) of a scalar scheme without local parameters.
Laurent symbol(const Scheme& scheme);

bool is_stationary(const Scheme& scheme);                          // no level and no local parameter
bool is_uniform(const Scheme& scheme);                             // no local parameter
bool is_interpolatory(const Scheme& scheme);                       // a_{m j} = delta_{j0}
std::vector<LevelVariable> level_variables(const Scheme& scheme);  // those with a frequency
// Names of the parameters that identities are proved for as free ones: constants, and level parameters without a
// frequency.
std::vector<std::string> free_parameters(const Scheme& scheme);
// The symbol at level variables 1: what the masks tend to. nullopt if there is a pole.
std::optional<Laurent> limit_symbol(const Scheme& scheme);
// The scheme with some of its parameters replaced by values; they are no parameters any more, and the id says so.
// Throws Error(bad_input) for a name that is no parameter of the scheme and for a value at which a coefficient has a
// pole, or which lies outside the parameter's domain. A claim `maximal`, which is about almost all values, is dropped.
Scheme with_values(const Scheme& scheme, const std::vector<std::pair<std::string, RationalFunction>>& values);
// The scheme with its constant parameters that have a rational default value replaced by it.
Scheme with_default_values(const Scheme& scheme);
// The phases that hold at these values of all parameters, with the values put in. Names as in the stencils. Throws
// Error(bad_input) for a name that is missing, a condition `where` whose sign depends on a variable, a pole.
std::vector<Stencil> phases_at(const Scheme& scheme,
                               const std::vector<std::pair<std::string, RationalFunction>>& values);
// Parameters for the level variables of a space.
std::vector<Parameter> level_parameters(const Space& space);
// "v^{k+1} = sqrt((1 + v^k)/2)" for m = 2, "v^k = T_3(v^{k+1}) = 4*v^3 - 3*v" in general.
std::string recurrence(const std::string& variable, int arity);
// The same of any level parameter, and what the user's spelling of it is: "v^k = (v^{k+1})^2; g = 2*v".
std::string recurrence(const Parameter& parameter, int arity);
// "cosh(t/2^(k+1))", or "the value of level k+1" without a frequency.
std::string meaning(const Parameter& parameter, int arity);

}  // namespace twoscale
