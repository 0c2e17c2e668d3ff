// SPDX-License-Identifier: GPL-3.0-or-later
// Signs of polynomials and rational functions on boxes, whose sides may be half-lines, with evidence.
//
// A side [lo, hi] is x = lo (1-t) + hi t, a half-line is x = lo + t/(1-t), 0 <= t <= 1 (t = 1 is not in it); after
// multiplication by (1-t)^deg everything is a polynomial on the unit cube. One variable: Sturm's theorem decides.
// Degree at most 1 in each variable: the values at the vertices decide. Otherwise Bernstein coefficients on a tree of
// bisections: none negative proves, a negative value at a vertex of a leaf refutes. Factors that vanish on faces only
// need no care: products of forms without negative coefficients are such forms. Not decided, but given up at the depth
// limit: zeros inside the box that are no vertex of the tree, and, with several half-lines, some zeros where all of
// them are infinite, as of x^2 - 2 x y + 2 y^2 + 1. The tree is the evidence; the checker computes the coefficients
// anew (docs/certificates.md, claim `positivity`).
//
// Source: Garloff, Convergent bounds for the range of multivariate polynomials (1986); Sturm; Descartes, Vincent.
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "twoscale/analysis/verdict.hpp"
#include "twoscale/symbolic/rational_function.hpp"

namespace twoscale::analysis {

// low <= name <= high, low < high; without `high` the half-line name >= low.
struct Range {
  std::string name;
  Rational low;
  std::optional<Rational> high = std::nullopt;
};
// A product of ranges with distinct names, in any order; at most 8 of them.
using Box = std::vector<Range>;
// One value for each variable of a box, sorted by name.
using BoxPoint = std::vector<std::pair<std::string, Rational>>;

struct SignOptions {
  bool strict = true;              // > 0, else >= 0
  std::vector<std::string> zeros;  // strict: faces "x=lo", "x=hi" where nothing but >= 0 is claimed
  unsigned depth = 60;             // bisections on the way to a leaf, at most
  std::size_t work = 20'000'000;   // Bernstein coefficients computed, at most
};

// How the sign of one polynomial was established: the fields `method`, `tree` of a certificate.
struct PositivityProof {
  std::string method;  // "sturm", "vertices", "bernstein"
  std::string tree;    // bernstein: prefix order, "." a leaf, a digit the variable (sorted by name) that is bisected
};

// Is the polynomial >= 0 (> 0 off the listed faces) on the box?
struct Positivity {
  Verdict verdict = Verdict::undecided;
  PositivityProof proof;                                 // proved
  std::optional<BoxPoint> point;                         // refuted: here the value is negative, or 0 (strict)
  Rational value;                                        //   that value
  std::optional<std::pair<Rational, Rational>> between;  // refuted without a point: a zero, one variable, strict
  std::string reason;                                    // undecided
  nlohmann::ordered_json evidence;                       // the entry of a certificate; null when undecided
};

// Required: the variables of p are among those of the box; bad_input otherwise, for an empty side or an unknown face.
Positivity decide_sign(const Polynomial& p, const Box& box, const SignOptions& options = {});

// The same for f = N/(c prod q_i^e_i): each q_i has one strict sign on the box (off the listed faces), and N has the
// sign that makes f positive. The parts are the evidence: +-q_i > 0 for each i, then +-N.
struct RationalPositivity {
  Verdict verdict = Verdict::undecided;
  std::vector<std::pair<Polynomial, Positivity>> parts;  // what was decided, in order
  std::optional<BoxPoint> point;                         // refuted: f is negative here, or 0 (strict)
  Rational value;
  std::string reason;  // undecided: a limit, or a pole in the box
};
RationalPositivity decide_sign(const RationalFunction& f, const Box& box, const SignOptions& options = {});

// ---- One variable. Required everywhere: p != 0, at most one variable.

// A real zero: low = high, the zero itself; or the only zero in the open interval, none at its ends.
struct RootInterval {
  Rational low;
  Rational high;
};

enum class Ends { open, closed };

// Number of distinct zeros between low and high (absent: infinity). Required: low < high.
long count_zeros(const Polynomial& p, const Rational& low, const std::optional<Rational>& high, Ends ends);
// Number of distinct real zeros.
long count_real_zeros(const Polynomial& p);
// The distinct zeros in the open interval, ascending, isolated; intervals do not overlap.
std::vector<RootInterval> isolate_zeros(const Polynomial& p, const Rational& low, const std::optional<Rational>& high);
// All distinct real zeros, ascending.
std::vector<RootInterval> isolate_real_zeros(const Polynomial& p);
// A narrower interval for the same zero: high - low <= width, or the zero itself. Required: root isolates for p.
RootInterval refine_zero(const Polynomial& p, RootInterval root, const Rational& width);
// The one sign of p on the open interval: +1 or -1 if p has no zero in it, 0 if it has one.
int sign_between(const Polynomial& p, const Rational& low, const std::optional<Rational>& high);
// A bound B > 0 such that all complex zeros are smaller in absolute value.
Rational zero_bound(const Polynomial& p);
// p = c prod q_k^k with squarefree, pairwise prime q_k; those that are not constant, with k ascending.
std::vector<std::pair<Polynomial, unsigned>> squarefree_factors(const Polynomial& p);

}  // namespace twoscale::analysis
