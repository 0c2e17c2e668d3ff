// SPDX-License-Identifier: GPL-3.0-or-later
// The joint spectral radius of finitely many rational matrices, exactly or in a proved enclosure.
//
//   JSR(B_1..B_k) = lim_n max_{|w| = n} ||B_w||^{1/n}.
//
//   literature (Guglielmi, Protasov 2013, 2016; Gripenberg 1996)     here
//   spectrum maximising product (s.m.p.)                             cycle: a word w with rho(B_w)^{1/|w|} = JSR
//   invariant polytope, its tree of vertices                         Block, roots, tree, images
//   candidate search                                                 estimate_cycles (floating point)
// Products: B_w = B_{w_n} ... B_{w_1}, the first letter acts first. Certificates: docs/certificates.md, jsr-*.
#pragma once

#include <nlohmann/json.hpp>

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "twoscale/analysis/rational_matrix.hpp"
#include "twoscale/analysis/real_algebraic.hpp"

namespace twoscale::analysis {

using Family = std::vector<RationalMatrix>;  // not empty, all square of one size
using Word = std::vector<int>;

struct JsrOptions {
  // Stop refining when upper/lower - 1 is at most this.
  Rational width = Rational(1, 10000);
  size_t vertices = 1500;       // of one polytope
  double seconds = 60;          // after that the best bounds proved so far are returned
  bool enclosure_only = false;  // do not look for the exact value
  Rational extra = 0;           // > 0: unit vectors of this length are vertices of an exact polytope as well
  int threads = 1;
  std::function<void(const std::string&)> progress;  // called from the calling thread only
};

// How a closed polytope hangs together, without its numbers: enough to look for the same one at other parameters.
struct PolytopeShape {
  struct Image {
    size_t vertex;
    size_t matrix;
    std::optional<std::pair<size_t, int>> equals;  // (vertex, sign)
    std::vector<size_t> support;                   // otherwise: the vertices it is a combination of
  };
  std::vector<Word> words;                   // of the roots
  std::vector<int> signs;                    // of their leading eigenvalues
  std::vector<std::vector<Rational>> roots;  // their vectors, if the radius is rational
  std::vector<std::pair<size_t, size_t>> tree;
  std::vector<size_t> inner;
  std::vector<Image> images;
};

struct JsrResult {
  Rational lower;  // proved: lower <= JSR <= upper
  Rational upper;
  std::optional<RealAlgebraic> exact;  // the JSR, proved
  std::vector<Word> cycles;            // words that attain it (exact), or the one that gives `lower`
  bool bounded = false;                // products of B/JSR are bounded, proved
  std::string method;                  // "invariant polytope", "enclosure", ...
  std::optional<PolytopeShape> shape;  // exact and irreducible: of the polytope
  // Entries of a certificate: jsr-exact, or jsr-lower and jsr-upper.
  std::vector<nlohmann::ordered_json> claims;
};

// What the certificate says about where the matrices come from: the order N (0 for given matrices) and the parameter
// interval ([] or [lo, hi]).
struct JsrSubject {
  long order = 0;
  std::vector<Rational> parameter;
};

JsrResult joint_spectral_radius(const Family& family, const JsrSubject& subject, const JsrOptions& options);

// Proves JSR <= r for some r < limit by a polytope with rational vertices, the claim jsr-upper; nullopt if that did not
// succeed within the limits.
std::optional<nlohmann::ordered_json> prove_jsr_below(const Family& family, const Rational& limit,
                                                      const JsrSubject& subject, const JsrOptions& options);

// Are all products of the family (of radius 1) bounded? true only if an exact polytope closes.
bool prove_bounded(const Family& family, const JsrOptions& options);

// Exact common invariant subspaces: T with T^{-1} B T block upper triangular for all B, and the sizes of the blocks.
struct BlockForm {
  RationalMatrix basis;
  std::vector<long> sizes;
  std::vector<Family> blocks;  // the diagonal blocks
};
BlockForm block_triangular_form(const Family& family);

// B_{w_n} ... B_{w_1}.
RationalMatrix product(const Family& family, const Word& word);
// The real eigenvalues of largest modulus, the positive one first; empty if a complex pair is (in floating point)
// beyond them.
std::vector<RealAlgebraic> leading_eigenvalues(const RationalMatrix& a);

}  // namespace twoscale::analysis
