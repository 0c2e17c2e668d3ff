// SPDX-License-Identifier: GPL-3.0-or-later
// Common invariant subspaces of rational matrices: the MeatAxe over Q. A random element of the algebra, an irreducible
// factor of its characteristic polynomial, a vector of the factor's kernel: the subspace it spans under all matrices is
// invariant; if that is everything, for the transposed family too, and the kernel is as small as the factor's degree,
// there is no invariant subspace (Norton's criterion).
#include <algorithm>
#include <random>

#include "twoscale/analysis/jsr.hpp"

namespace twoscale::analysis {

namespace {

using Vector = std::vector<Rational>;

// Row echelon form, grown one vector at a time.
class Echelon {
 public:
  // The vector reduced by the rows; false if nothing is left.
  bool add(Vector x) {
    for (const auto& [pivot, row] : rows_)
      if (!x[pivot].is_zero()) {
        const Rational factor = x[pivot];
        for (size_t i = 0; i < x.size(); ++i)
          if (!row[i].is_zero()) x[i] -= factor * row[i];
      }
    const auto found = std::find_if(x.begin(), x.end(), [](const Rational& c) { return !c.is_zero(); });
    if (found == x.end()) return false;
    const Rational scale = found->inverse();
    const auto pivot = static_cast<size_t>(found - x.begin());
    for (auto& c : x) c *= scale;
    rows_.emplace_back(pivot, std::move(x));
    return true;
  }
  size_t dimension() const { return rows_.size(); }
  const std::vector<std::pair<size_t, Vector>>& rows() const { return rows_; }

 private:
  std::vector<std::pair<size_t, Vector>> rows_;
};

// The smallest subspace that contains x and is invariant under the family, as a basis.
std::vector<Vector> spin(const Family& family, const Vector& x) {
  Echelon space;
  space.add(x);
  for (size_t i = 0; i < space.dimension(); ++i)
    for (const auto& b : family) {
      const Vector row = space.rows()[i].second;
      space.add(b * row);
      if (space.dimension() == x.size()) break;
    }
  std::vector<Vector> basis;
  for (const auto& [pivot, row] : space.rows()) basis.push_back(row);
  return basis;
}

Vector column(const RationalMatrix& a, long j) {
  Vector v;
  for (long i = 0; i < a.rows(); ++i) v.push_back(a(i, j));
  return v;
}

Family transposed(const Family& family) {
  Family t;
  for (const auto& b : family) t.push_back(b.transposed());
  return t;
}

// A proper invariant subspace, or empty if none was found (there is none, or the tries were unlucky).
std::vector<Vector> invariant_subspace(const Family& family) {
  const long n = family[0].rows();
  if (n == 1) return {};
  const Family dual = transposed(family);
  std::mt19937 random(12345);  // the same choices at every run
  for (int attempt = 0; attempt < 4; ++attempt) {
    RationalMatrix element(n, n);
    if (attempt == 0) {
      for (const auto& b : family) element = element + b;
    } else {
      for (const auto& b : family) {
        element = element + Rational(static_cast<long>(random() % 7) + 1) * b;
        if (attempt > 1) element = element + Rational(static_cast<long>(random() % 5) - 2) * (b * family[0]);
      }
    }
    for (const auto& [factor, exponent] : element.characteristic_polynomial().factor().factors) {
      const RationalMatrix value = evaluate(factor, element);
      const RationalMatrix kernel = value.kernel();
      if (kernel.columns() == 0) continue;
      std::vector<Vector> space = spin(family, column(kernel, 0));
      if (static_cast<long>(space.size()) < n) return space;
      const RationalMatrix cokernel = value.transposed().kernel();
      const std::vector<Vector> covectors = spin(dual, column(cokernel, 0));
      if (static_cast<long>(covectors.size()) < n) {
        const RationalMatrix annihilated = RationalMatrix::from_columns(n, covectors).transposed().kernel();
        std::vector<Vector> basis;
        for (long j = 0; j < annihilated.columns(); ++j) basis.push_back(column(annihilated, j));
        return basis;
      }
      if (kernel.columns() == factor.degree("x")) return {};  // Norton: irreducible over Q
    }
  }
  return {};
}

// The columns completed to a basis of Q^n by unit vectors.
RationalMatrix completed(long n, const std::vector<Vector>& columns) {
  Echelon space;
  std::vector<Vector> all;
  for (const auto& c : columns) {
    space.add(c);
    all.push_back(c);
  }
  for (long i = 0; i < n; ++i) {
    Vector unit(static_cast<size_t>(n));
    unit[static_cast<size_t>(i)] = 1;
    if (space.add(unit)) all.push_back(unit);
  }
  return RationalMatrix::from_columns(n, all);
}

// diag(A, B).
RationalMatrix direct_sum(const RationalMatrix& a, const RationalMatrix& b) {
  RationalMatrix r(a.rows() + b.rows(), a.rows() + b.rows());
  for (long i = 0; i < a.rows(); ++i)
    for (long j = 0; j < a.rows(); ++j) r.set(i, j, a(i, j));
  for (long i = 0; i < b.rows(); ++i)
    for (long j = 0; j < b.rows(); ++j) r.set(a.rows() + i, a.rows() + j, b(i, j));
  return r;
}

}  // namespace

BlockForm block_triangular_form(const Family& family) {
  const long n = family[0].rows();
  const std::vector<Vector> space = invariant_subspace(family);
  if (space.empty()) return {RationalMatrix::identity(n), {n}, {family}};
  const RationalMatrix basis = completed(n, space);
  const RationalMatrix inverse = *basis.inverse();
  const auto k = static_cast<long>(space.size());
  Family upper;
  Family lower;
  for (const auto& b : family) {
    const RationalMatrix c = inverse * b * basis;
    upper.push_back(c.block(0, 0, k, k));
    lower.push_back(c.block(k, k, n - k, n - k));
  }
  BlockForm first = block_triangular_form(upper);
  const BlockForm second = block_triangular_form(lower);
  BlockForm form{basis * direct_sum(first.basis, second.basis), std::move(first.sizes), std::move(first.blocks)};
  form.sizes.insert(form.sizes.end(), second.sizes.begin(), second.sizes.end());
  form.blocks.insert(form.blocks.end(), second.blocks.begin(), second.blocks.end());
  return form;
}

}  // namespace twoscale::analysis
