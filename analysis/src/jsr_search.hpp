// SPDX-License-Identifier: GPL-3.0-or-later
// Floating-point searches for the joint spectral radius: what is found here is a proposal, never a proof.
#pragma once

#include <Eigen/Dense>

#include <optional>
#include <vector>

#include "twoscale/analysis/jsr.hpp"

namespace twoscale::analysis {

using Real = Eigen::MatrixXd;
using RealVector = Eigen::VectorXd;

Real estimate_matrix(const RationalMatrix& a);
double estimate_spectral_radius(const Real& a);

// Words with the largest rho(B_w)^{1/|w|} met, best first; primitive, one of each class of rotations; all within a
// relative 1e-9 of the best. A breadth-first search whose nodes are pruned by norms (Gripenberg), at most `nodes` kept
// a length ("modified Gripenberg", Mejstrik 2020: the larger and some of the smaller norms).
struct CycleSearch {
  double radius = 0;
  std::vector<Word> words;
};
CycleSearch estimate_cycles(const std::vector<Real>& family, int longest, size_t nodes);

// The absolutely convex hull of vectors, for the question whether it contains another one: min sum |c_j|, V c = x.
// One linear program, warm-started.
class Hull {
 public:
  explicit Hull(long dimension);
  ~Hull();
  Hull(const Hull&) = delete;
  Hull& operator=(const Hull&) = delete;
  void add(const RealVector& vertex);
  struct Coordinates {
    double norm = 0;  // infinity if x is not in the span
    std::vector<std::pair<size_t, double>> coefficients;
  };
  Coordinates estimate_coordinates(const RealVector& x);
  size_t size() const { return count_; }

 private:
  struct Problem;
  Problem* problem_;
  long dimension_;
  size_t count_ = 0;
};

// Positive factors for the leading vectors v_i of several cycles such that no product maps one beyond another one's
// face: a_i q_ij < a_j, q_ij = sup |<dual_j, B v_i>| (Guglielmi, Protasov 2016). Empty if none were found.
std::vector<double> estimate_balance(const std::vector<Real>& normalised, const std::vector<RealVector>& leading,
                                     const std::vector<RealVector>& dual, int depth);

}  // namespace twoscale::analysis
