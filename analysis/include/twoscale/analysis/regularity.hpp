// SPDX-License-Identifier: GPL-3.0-or-later
// Hölder and Sobolev exponents of subdivision schemes, exact or enclosed, with a certificate.
//
//   route                     when                                         theorem
//   nonnegative symbol        c symmetric and >= 0 on the unit circle      Rioul 1992; Floater, Muntingh 2013
//   invariant polytope        else                                         Guglielmi, Protasov 2013
//   enclosure                 the polytope does not close in the limits    the same, with a larger radius
// A level-dependent scheme inherits the exponent of its limit when it generates as many exponential polynomials as the
// limit has sum rules (Charina, Conti, Guglielmi, Protasov 2017).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "twoscale/analysis/jsr.hpp"
#include "twoscale/analysis/remainder.hpp"
#include "twoscale/analysis/verdict.hpp"
#include "twoscale/symbolic/scheme.hpp"

namespace twoscale::analysis {

// A number that is known exactly or lies between proved rational bounds; `exact` is an expression in N, rho and m when
// it is not rational.
struct Exponent {
  std::optional<Rational> rational;
  std::optional<std::string> expression;  // "2 - log(1 + sqrt(5)/5)/log(2)", or "6 - log(rho)/log(2)" with `rho`
  std::optional<RealAlgebraic> rho;       // what the expression calls rho, if it does
  std::optional<Rational> lower;          // absent: nothing is proved on this side
  std::optional<Rational> upper;
};

struct Regularity {
  long order = 0;            // N
  std::vector<Rational> c;   // the remainder
  Family matrices;           // the transition matrices B_0..B_{m-1}
  std::vector<long> blocks;  // sizes of the diagonal blocks of their common block triangular form
  std::string obstacle;      // why the scheme cannot converge; empty if that is not seen from the sum rules
  long continuity = -1;      // C^continuity is proved; -1: not even C^0
  Exponent hoelder;
  Exponent sobolev;
  JsrResult jsr;
  std::string method;
  Stability stability;
  std::optional<bool> attained;  // is the limit of the exponent's class itself (integer k: Lipschitz f^{(k-1)})?
  // Level-dependent schemes only.
  bool level_dependent = false;
  bool transferred = false;                    // the limit's exponent holds for the scheme itself
  std::string generated;                       // the space whose generation proves that
  std::vector<std::string> excluded;           // values of v^0 for which some step has a pole
  std::vector<nlohmann::ordered_json> claims;  // of the certificate
  std::string certificate;
};

struct RegularityOptions {
  JsrOptions jsr;
  bool polytope_only = false;  // do not use the non-negative symbol; for tests
};

// Required: no free constant parameter (Error bad_input names it).
Regularity regularity(const Scheme& scheme, const RegularityOptions& options);

// Is the scheme C^l? Proved from an upper bound of the radius (and, level-dependent, by transfer from the limit);
// refuted for a stationary scheme with stable integer shifts and rho >= m^{N-l}.
Decision decide_continuity(const Scheme& scheme, long l, const RegularityOptions& options);

// "every v^0 > -1": the start values of a level-dependent scheme that its proofs speak of.
std::string start_values(const Scheme& scheme);

// N - log_m(radius), as an exponent, from the radius or its bounds.
Exponent exponent_of(long order, long arity, const JsrResult& jsr);

}  // namespace twoscale::analysis
