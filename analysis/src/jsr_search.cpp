// SPDX-License-Identifier: GPL-3.0-or-later
#include "jsr_search.hpp"

#include <glpk.h>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace twoscale::analysis {

Real estimate_matrix(const RationalMatrix& a) {
  Real r(a.rows(), a.columns());
  for (long i = 0; i < a.rows(); ++i)
    for (long j = 0; j < a.columns(); ++j) r(i, j) = fmpq_get_d(a.entry(i, j));
  return r;
}

double estimate_spectral_radius(const Real& a) {
  if (a.rows() == 1) return std::abs(a(0, 0));
  return Eigen::EigenSolver<Real>(a, false).eigenvalues().cwiseAbs().maxCoeff();
}

namespace {

// The lexicographically least rotation, or nothing for a proper power.
std::optional<Word> primitive_necklace(const Word& word) {
  const size_t n = word.size();
  Word best = word;
  for (size_t r = 1; r < n; ++r) {
    Word turned(word.begin() + static_cast<long>(r), word.end());
    turned.insert(turned.end(), word.begin(), word.begin() + static_cast<long>(r));
    if (turned == word) return std::nullopt;
    best = std::min(best, turned);
  }
  return best;
}

}  // namespace

CycleSearch estimate_cycles(const std::vector<Real>& family, int longest, size_t nodes) {
  struct Node {
    Word word;
    Real product;
    double bound;  // min over prefixes of ||B||^{1/n}
  };
  CycleSearch found;
  std::set<Word> met;
  std::vector<std::pair<double, Word>> candidates;
  const auto meet = [&](const Word& word, const Real& p) {
    const double radius = std::pow(estimate_spectral_radius(p), 1.0 / static_cast<double>(word.size()));
    if (radius < found.radius * (1 - 1e-9) || radius <= 0) return;
    const auto necklace = primitive_necklace(word);
    if (!necklace || !met.insert(*necklace).second) return;
    candidates.emplace_back(radius, *necklace);
    found.radius = std::max(found.radius, radius);
  };
  std::vector<Node> level;
  level.push_back({{}, Real::Identity(family[0].rows(), family[0].rows()), std::numeric_limits<double>::infinity()});
  for (int length = 1; length <= longest && !level.empty(); ++length) {
    std::vector<Node> next;
    for (const Node& node : level)
      for (size_t s = 0; s < family.size(); ++s) {
        Node child{node.word, family[s] * node.product, node.bound};
        child.word.push_back(static_cast<int>(s));
        child.bound = std::min(child.bound, std::pow(child.product.norm(), 1.0 / length));
        next.push_back(std::move(child));
      }
    for (const Node& node : next) meet(node.word, node.product);
    std::erase_if(next, [&](const Node& node) { return node.bound <= found.radius * (1 + 1e-7); });
    if (next.size() > nodes) {
      std::sort(next.begin(), next.end(), [](const Node& a, const Node& b) { return a.bound > b.bound; });
      const size_t kept = nodes * 3 / 4;
      const size_t step = (next.size() - kept) / (nodes - kept) + 1;
      for (size_t i = kept, to = kept; i < next.size(); i += step) std::swap(next[to++], next[i]);
      next.resize(nodes);
    }
    level = std::move(next);
  }
  std::stable_sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
    return a.second.size() != b.second.size() ? a.second.size() < b.second.size() : a.second < b.second;
  });
  for (auto& [radius, word] : candidates)
    if (radius >= found.radius * (1 - 1e-9) && found.words.size() < 32) found.words.push_back(std::move(word));
  return found;
}

struct Hull::Problem {
  glp_prob* lp = nullptr;
  glp_smcp options{};
  std::vector<bool> in_use;
};

Hull::Hull(long dimension) : problem_(new Problem), dimension_(dimension) {
  problem_->lp = glp_create_prob();
  glp_set_obj_dir(problem_->lp, GLP_MIN);
  glp_add_rows(problem_->lp, static_cast<int>(dimension));
  for (int i = 1; i <= dimension; ++i) glp_set_row_bnds(problem_->lp, i, GLP_FX, 0, 0);
  glp_init_smcp(&problem_->options);
  problem_->options.msg_lev = GLP_MSG_OFF;
  problem_->options.meth = GLP_DUALP;
  problem_->options.it_lim = 20000;
}

Hull::~Hull() {
  glp_delete_prob(problem_->lp);
  delete problem_;
}

void Hull::add(const RealVector& vertex) {
  const int first = glp_add_cols(problem_->lp, 2);
  std::vector<int> rows(static_cast<size_t>(dimension_) + 1);
  std::vector<double> values(rows.size());
  for (int sign = 0; sign < 2; ++sign) {
    int n = 0;
    for (int i = 0; i < dimension_; ++i)
      if (vertex(i) != 0) {
        ++n;
        rows[static_cast<size_t>(n)] = i + 1;
        values[static_cast<size_t>(n)] = sign == 0 ? vertex(i) : -vertex(i);
      }
    glp_set_mat_col(problem_->lp, first + sign, n, rows.data(), values.data());
    glp_set_obj_coef(problem_->lp, first + sign, 1);
    glp_set_col_bnds(problem_->lp, first + sign, GLP_LO, 0, 0);
    glp_set_col_stat(problem_->lp, first + sign, GLP_NL);
  }
  ++count_;
}

Hull::Coordinates Hull::estimate_coordinates(const RealVector& x) {
  Coordinates result;
  result.norm = std::numeric_limits<double>::infinity();
  if (count_ == 0) return result;
  for (int i = 0; i < dimension_; ++i) glp_set_row_bnds(problem_->lp, i + 1, GLP_FX, x(i), x(i));
  int status = glp_simplex(problem_->lp, &problem_->options);
  if (status != 0) {  // a basis that has become singular: start afresh
    glp_std_basis(problem_->lp);
    status = glp_simplex(problem_->lp, &problem_->options);
  }
  if (status != 0 || glp_get_status(problem_->lp) != GLP_OPT) {
    glp_std_basis(problem_->lp);
    return result;
  }
  result.norm = glp_get_obj_val(problem_->lp);
  for (size_t j = 0; j < count_; ++j) {
    const double c = glp_get_col_prim(problem_->lp, static_cast<int>(2 * j + 1)) -
                     glp_get_col_prim(problem_->lp, static_cast<int>(2 * j + 2));
    if (c != 0) result.coefficients.emplace_back(j, c);
  }
  return result;
}

std::vector<double> estimate_balance(const std::vector<Real>& normalised, const std::vector<RealVector>& leading,
                                     const std::vector<RealVector>& dual, int depth) {
  const size_t n = leading.size();
  std::vector<std::vector<double>> q(n, std::vector<double>(n, 1e-12));
  for (size_t i = 0; i < n; ++i) {
    std::vector<RealVector> layer{leading[i]};
    for (int d = 0; d <= depth; ++d) {
      std::vector<RealVector> next;
      for (const auto& x : layer) {
        for (size_t j = 0; j < n; ++j)
          if (i != j) q[i][j] = std::max(q[i][j], std::abs(dual[j].dot(x)));
        if (next.size() < 256)
          for (const auto& b : normalised) next.push_back(b * x);
      }
      layer = std::move(next);
    }
  }
  // maximise t: log a_j - log a_i >= log q_ij + t.
  glp_prob* lp = glp_create_prob();
  glp_set_obj_dir(lp, GLP_MAX);
  glp_add_cols(lp, static_cast<int>(n) + 1);
  for (int i = 1; i <= static_cast<int>(n); ++i) glp_set_col_bnds(lp, i, GLP_DB, -30, 30);
  glp_set_col_bnds(lp, static_cast<int>(n) + 1, GLP_DB, -30, 0.5);
  glp_set_obj_coef(lp, static_cast<int>(n) + 1, 1);
  for (size_t i = 0; i < n; ++i)
    for (size_t j = 0; j < n; ++j) {
      if (i == j) continue;
      const int row = glp_add_rows(lp, 1);
      const int columns[] = {0, static_cast<int>(j) + 1, static_cast<int>(i) + 1, static_cast<int>(n) + 1};
      const double values[] = {0, 1, -1, -1};
      glp_set_mat_row(lp, row, 3, columns, values);
      glp_set_row_bnds(lp, row, GLP_LO, std::log(q[i][j]), 0);
    }
  glp_smcp options;
  glp_init_smcp(&options);
  options.msg_lev = GLP_MSG_OFF;
  std::vector<double> factors;
  if (glp_simplex(lp, &options) == 0 && glp_get_status(lp) == GLP_OPT &&
      glp_get_col_prim(lp, static_cast<int>(n) + 1) > 1e-9)
    for (size_t i = 0; i < n; ++i) factors.push_back(std::exp(glp_get_col_prim(lp, static_cast<int>(i) + 1)));
  glp_delete_prob(lp);
  return factors;
}

}  // namespace twoscale::analysis
