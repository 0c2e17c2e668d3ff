// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. One function a kind of claim.
#pragma once

#include "twoscale/check/certificate.hpp"
#include "twoscale/check/covering.hpp"
#include "twoscale/check/identities.hpp"
#include "twoscale/check/point.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace twoscale::check {

/// Upper bounds, established by the claims so far, of the joint spectral radius that belongs to the limit mask.
struct RadiusBounds {
  std::vector<Fraction> list;
};

/// What the claims so far have established of a rule on knots.
struct KnotFacts {
  /// A claim `junction`. region: of the edge parameters, if it is about all ratios and all parameters of its box.
  struct Junction {
    long order = 0;
    std::optional<Region> region;
  };
  long degree = -1;  ///< of the polynomials reproduced
  std::vector<Junction> junctions;
};

/// For claims about a mask.
struct Context {
  const Certificate& certificate;
  Identities& identities;
  Meter& meter;
  RadiusBounds& radius;
  KnotFacts& knots;
};

/// For claims about matrices.
struct FamilyContext {
  const Family& family;
  Meter& meter;
};

/// For claims about the rules of a Hermite scheme.
struct HermiteContext {
  const HermiteRules& rules;
  Meter& meter;
  HermiteFacts& facts;
};

/// What was established: `subject` completes the name of the claim, `evidence` says what was verified, `trusted` are
/// keys.
struct Finding {
  std::string subject;
  std::string evidence;
  std::vector<std::string_view> trusted;
};

/// Each reads its fields up to (not including) "theorem", checks, and throws Malformed or Refused.
Finding check_interpolatory(const Context& context, Fields& fields, bool proved);
Finding check_symmetric(const Context& context, Fields& fields, bool proved);
Finding check_sum_rules(const Context& context, Fields& fields, bool proved);
Finding check_generates(const Context& context, Fields& fields, bool proved);
Finding check_reproduces(const Context& context, Fields& fields, bool proved);
Finding check_maximal(const Context& context, Fields& fields, bool proved);
Finding check_well_defined(const Context& context, Fields& fields, bool proved);
Finding check_positivity(Meter& meter, Fields& fields, bool proved);
Finding check_root_bound(Meter& meter, Fields& fields, bool proved);

Finding check_bezier_form(Meter& meter, Fields& fields, bool proved);

/// Rules of a Hermite scheme. The later ones need what the earlier ones establish.
Finding check_interpolant(const HermiteContext& context, Fields& fields, bool proved);
Finding check_circle(const HermiteContext& context, Fields& fields, bool proved);
Finding check_hermite_interpolatory(const HermiteContext& context, Fields& fields, bool proved);
Finding check_reversal(const HermiteContext& context, Fields& fields, bool proved);
Finding check_spectral(const HermiteContext& context, Fields& fields, bool proved);
Finding check_halves(const HermiteContext& context, Fields& fields, bool proved);
Finding check_hermite_continuity(const HermiteContext& context, Fields& fields, bool proved);
Finding check_curvature(const HermiteContext& context, Fields& fields, bool proved);

/// The theorem that a claim `positivity` must name: by its method, or by its witness.
std::string_view positivity_theorem(const Value& claim);

/// The claims about the remainder of the limit mask (remainder.hpp), or about the matrices of the document.
Finding check_jsr_lower(const Context& context, Fields& fields, bool proved);
Finding check_jsr_upper(const Context& context, Fields& fields, bool proved);
Finding check_jsr_exact(const Context& context, Fields& fields, bool proved);
Finding check_family_jsr_lower(const FamilyContext& context, Fields& fields, bool proved);
Finding check_family_jsr_upper(const FamilyContext& context, Fields& fields, bool proved);
Finding check_family_jsr_exact(const FamilyContext& context, Fields& fields, bool proved);
Finding check_nonnegative_symbol(const Context& context, Fields& fields, bool proved);
Finding check_stability(const Context& context, Fields& fields, bool proved);
Finding check_nonstationary(const Context& context, Fields& fields, bool proved);

/// The same along a parameter of the mask.
Finding check_nonnegative_family(const Context& context, Fields& fields, bool proved);
Finding check_jsr_lower_family(const Context& context, Fields& fields, bool proved);
Finding check_jsr_family(const Context& context, Fields& fields, bool proved);

/// The claims about a rule on knots, in documents that have one.
Finding check_knots_reproduces(const Context& context, Fields& fields, bool proved);
Finding check_knots_support(const Context& context, Fields& fields, bool proved);
Finding check_junction(const Context& context, Fields& fields, bool proved);
Finding check_knots_continuity(const Context& context, Fields& fields, bool proved);

/// For kinds of claims that cannot be refuted.
void require_proved(const Fields& fields, bool proved);

/// A witness against generation: at the point the sums of i^power a_i z^i over two residue classes have the two values,
/// and these differ. Throws Malformed or Refused.
void check_two_sums(const Context& context, Point& point, const std::vector<long>& frequency, long power,
                    const std::vector<Value>& residues, const std::vector<Value>& values, const std::string& where);

}  // namespace twoscale::check
