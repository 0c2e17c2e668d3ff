// SPDX-License-Identifier: GPL-3.0-or-later
// The frequency that data are sampled from: v^0 of a space with one frequency, from its annihilator.
//
// Samples p_j at unit spacing of a function of the space satisfy r_j(v^0) = 0,
//   r_j(v) = sum_i f_i(v) p_{j+i},   sum_i f_i(v) y^i = (y - 1)^q prod (y^2 - 2 T_n(v) y + 1),
// over the frequencies n t with their multiplicities and the q powers of x. The numbers of the file are taken exactly;
// v^0 minimises sum_j |r_j(v)|^2, an exact polynomial. For {1, x, e^{+-tx}}, with q_j = p_{j-1} - 2 p_j + p_{j+1},
//   v^0 = sum_j <q_j, q_{j-1} + q_{j+1}> / (2 sum_j <q_j, q_j>).
// Subspaces (lower multiplicities first, then fewer frequencies) are tried before the whole space: data that lie in one
// of them would make r_j vanish to second order, and the fundamental of a single harmonic is the natural answer.
#pragma once

#include <string>

#include "twoscale/kernels/points_io.hpp"
#include "twoscale/symbolic/space.hpp"

namespace twoscale::lowering {

struct Fit {
  enum class Outcome {
    found,  // spread <= tolerance
    any,    // polynomial data of the space: every v^0 > -1 does
    none,   // nothing that fits; v0, t and spread belong to the best try, if there is one
  };
  Outcome outcome = Outcome::none;
  std::string v0;      // shortest decimal of the nearest double; empty if there is none
  std::string t;       // "0.4", "1.2566370614359172*I"; for cosines "1.2566370614359172", "0.4*I"
  std::string spread;  // max_j |r_j(v0)| / max_j |r_j'(v0)|, rounded up: how far the estimates of single j differ
};

// closed: indices wrap. tolerance: an absolute one on v^0, a rational number > 0 as text. Throws Error(bad_input) if
// the space has no frequency, several, or a fixed one; if there are fewer than dim + 1 points (closed: fewer than 3).
Fit fit(const Space& space, const kernels::PointSet& points, bool closed, const std::string& tolerance = "1e-9");

}  // namespace twoscale::lowering
