// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/analysis/matrix.hpp"

#include <algorithm>
#include <stdexcept>

#include "twoscale/analysis/rational_matrix.hpp"

namespace twoscale::analysis {

namespace {

// ---- over Q: by RationalMatrix

RationalMatrix flint(const Matrix<Rational>& a) {
  RationalMatrix r(static_cast<long>(a.rows()), static_cast<long>(a.columns()));
  for (std::size_t i = 0; i < a.rows(); ++i)
    for (std::size_t j = 0; j < a.columns(); ++j) r.set(static_cast<long>(i), static_cast<long>(j), a(i, j));
  return r;
}

Matrix<Rational> generic(const RationalMatrix& a) {
  Matrix<Rational> r(static_cast<std::size_t>(a.rows()), static_cast<std::size_t>(a.columns()));
  for (std::size_t i = 0; i < r.rows(); ++i)
    for (std::size_t j = 0; j < r.columns(); ++j) r(i, j) = a(static_cast<long>(i), static_cast<long>(j));
  return r;
}

void require_square(std::size_t rows, std::size_t columns) {
  if (rows != columns) throw std::logic_error("a square matrix is needed");
}

// ---- over Q(parameters): elimination over Z[parameters]

using PolynomialMatrix = Matrix<Polynomial>;

// Each row times its common denominator.
struct Cleared {
  PolynomialMatrix matrix;
  std::vector<CommonDenominator> rows;
};

Cleared clear_rows(const SymbolicMatrix& a) {
  Cleared r{PolynomialMatrix(a.rows(), a.columns()), {}};
  for (std::size_t i = 0; i < a.rows(); ++i) {
    std::vector<RationalFunction> row;
    for (std::size_t j = 0; j < a.columns(); ++j) row.push_back(a(i, j));
    r.rows.push_back(common_denominator(row));
    for (std::size_t j = 0; j < a.columns(); ++j) r.matrix(i, j) = numerator_over(row[j], r.rows.back());
  }
  return r;
}

// The matrix at integers in the place of the parameters: its rank is at most the generic one.
std::size_t rank_at_a_point(const PolynomialMatrix& a) {
  std::vector<std::pair<std::string, Rational>> at;
  Matrix<Rational> r(a.rows(), a.columns());
  for (std::size_t i = 0; i < a.rows(); ++i)
    for (std::size_t j = 0; j < a.columns(); ++j) {
      for (const auto& name : a(i, j).variables())
        if (std::none_of(at.begin(), at.end(), [&](const auto& v) { return v.first == name; }))
          at.emplace_back(name, Rational(1009 + 1013 * static_cast<long>(at.size())));
      r(i, j) = a(i, j).evaluate(at);
    }
  return rank(r);
}

// The same rows without common factors: the same kernel.
PolynomialMatrix primitive_rows(const SymbolicMatrix& a) {
  PolynomialMatrix r(a.rows(), a.columns());
  for (std::size_t i = 0; i < a.rows(); ++i) {
    std::vector<RationalFunction> row;
    for (std::size_t j = 0; j < a.columns(); ++j) row.push_back(a(i, j));
    row = primitive(row);
    for (std::size_t j = 0; j < a.columns(); ++j) r(i, j) = row[j].numerator();
  }
  return r;
}

// Fraction-free Gauss-Jordan elimination: afterwards the pivot columns hold `pivot` times unit vectors and row r < rank
// belongs to the pivot column columns[r]. For a square matrix of full rank pivot = +-det.
struct Echelon {
  PolynomialMatrix matrix;
  std::vector<std::size_t> columns;
  Polynomial pivot = 1;
  bool negative = false;  // parity of the row exchanges
};

Echelon eliminate(PolynomialMatrix a, std::size_t pivot_columns) {
  Echelon e;
  for (std::size_t c = 0; c < pivot_columns && e.columns.size() < a.rows(); ++c) {
    const std::size_t r = e.columns.size();
    std::size_t best = a.rows();  // the pivot with the fewest terms
    for (std::size_t i = r; i < a.rows(); ++i)
      if (!a(i, c).is_zero() && (best == a.rows() || a(i, c).terms() < a(best, c).terms())) best = i;
    if (best == a.rows()) continue;
    if (best != r) {
      for (std::size_t j = 0; j < a.columns(); ++j) std::swap(a(best, j), a(r, j));
      e.negative = !e.negative;
    }
    const Polynomial pivot = a(r, c);
    for (std::size_t i = 0; i < a.rows(); ++i) {
      if (i == r) continue;
      const Polynomial factor = a(i, c);
      for (std::size_t j = 0; j < a.columns(); ++j) {
        if (a(i, j).is_zero() && (factor.is_zero() || a(r, j).is_zero())) continue;
        Polynomial x = pivot * a(i, j);
        if (!factor.is_zero()) x -= factor * a(r, j);
        a(i, j) = Polynomial::exact_quotient(x, e.pivot);
      }
    }
    e.pivot = pivot;
    e.columns.push_back(c);
  }
  e.matrix = std::move(a);
  return e;
}

// ---- the characteristic polynomial over Q(parameters)

// Strongly connected components of the graph i -> j for a(i, j) != 0 (Tarjan 1972), each with its indices ascending.
class Components {
 public:
  explicit Components(const SymbolicMatrix& a) : a_(a), number_(a.rows(), 0), low_(a.rows(), 0), on_(a.rows(), false) {
    for (std::size_t i = 0; i < a.rows(); ++i)
      if (number_[i] == 0) visit(i);
  }
  std::vector<std::vector<std::size_t>> list;

 private:
  void visit(std::size_t i) {  // depth at most the size of the matrix
    number_[i] = low_[i] = ++count_;
    stack_.push_back(i);
    on_[i] = true;
    for (std::size_t j = 0; j < a_.columns(); ++j) {
      if (a_(i, j).is_zero()) continue;
      if (number_[j] == 0) {
        visit(j);
        low_[i] = std::min(low_[i], low_[j]);
      } else if (on_[j]) {
        low_[i] = std::min(low_[i], number_[j]);
      }
    }
    if (low_[i] != number_[i]) return;
    std::vector<std::size_t> component;
    for (bool more = true; more;) {
      const std::size_t j = stack_.back();
      stack_.pop_back();
      on_[j] = false;
      component.push_back(j);
      more = j != i;
    }
    std::sort(component.begin(), component.end());
    list.push_back(std::move(component));
  }

  const SymbolicMatrix& a_;
  std::size_t count_ = 0;
  std::vector<std::size_t> number_, low_;
  std::vector<bool> on_;
  std::vector<std::size_t> stack_;
};

SymbolicMatrix submatrix(const SymbolicMatrix& a, const std::vector<std::size_t>& indices) {
  SymbolicMatrix r(indices.size(), indices.size());
  for (std::size_t i = 0; i < indices.size(); ++i)
    for (std::size_t j = 0; j < indices.size(); ++j) r(i, j) = a(indices[i], indices[j]);
  return r;
}

// Faddeev and LeVerrier over Z[parameters]: M_1 = I, c_k = -tr(B M_k)/k, M_{k+1} = B M_k + c_k I for B = D a.
std::vector<RationalFunction> by_traces(const SymbolicMatrix& a) {
  const std::size_t n = a.rows();
  std::vector<RationalFunction> all;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) all.push_back(a(i, j));
  const CommonDenominator d = common_denominator(all);
  PolynomialMatrix b(n, n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) b(i, j) = numerator_over(a(i, j), d);
  PolynomialMatrix m = PolynomialMatrix::identity(n);
  std::vector<RationalFunction> p(n + 1);
  p[n] = 1;
  for (std::size_t k = 1; k <= n; ++k) {
    PolynomialMatrix bm(n, n);
    Polynomial trace;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t l = 0; l < n; ++l)
        if (!b(i, l).is_zero())
          for (std::size_t j = 0; j < n; ++j)
            if (!m(l, j).is_zero()) bm(i, j) += b(i, l) * m(l, j);
      trace += bm(i, i);
    }
    const Polynomial c = trace.scaled(Rational(-1, static_cast<long>(k)));
    for (std::size_t i = 0; i < n; ++i) bm(i, i) += c;
    m = std::move(bm);
    RationalFunction::Factors factors = d.factors;
    for (auto& [f, e] : factors) e *= static_cast<unsigned>(k);
    p[n - k] = RationalFunction::over_factors(c, d.content.pow(static_cast<long>(k)), std::move(factors));
  }
  return p;
}

void collect_blocks(const SymbolicMatrix& a, std::vector<std::vector<RationalFunction>>& into) {
  const Components components(a);
  for (const auto& indices : components.list) {
    if (indices.size() == 1) {
      into.push_back({-a(indices[0], indices[0]), 1});
      continue;
    }
    const SymbolicMatrix block = submatrix(a, indices);
    if (commutes_with_reversal(block)) {
      collect_blocks(symmetric_part(block, false), into);
      collect_blocks(symmetric_part(block, true), into);
    } else {
      into.push_back(by_traces(block));
    }
  }
}

}  // namespace

Matrix<Rational> product(const Matrix<Rational>& a, const Matrix<Rational>& b) {
  if (a.columns() != b.rows()) throw std::logic_error("product: sizes do not fit");
  return generic(flint(a) * flint(b));
}

SymbolicMatrix product(const SymbolicMatrix& a, const SymbolicMatrix& b) {
  if (a.columns() != b.rows()) throw std::logic_error("product: sizes do not fit");
  SymbolicMatrix r(a.rows(), b.columns());
  for (std::size_t i = 0; i < a.rows(); ++i)
    for (std::size_t l = 0; l < a.columns(); ++l)
      if (!a(i, l).is_zero())
        for (std::size_t j = 0; j < b.columns(); ++j)
          if (!b(l, j).is_zero()) r(i, j) += a(i, l) * b(l, j);
  return r;
}

Rational determinant(const Matrix<Rational>& a) {
  require_square(a.rows(), a.columns());
  return flint(a).determinant();
}

RationalFunction determinant(const SymbolicMatrix& a) {
  require_square(a.rows(), a.columns());
  Cleared cleared = clear_rows(a);
  const Echelon e = eliminate(std::move(cleared.matrix), a.columns());
  if (e.columns.size() < a.rows()) return 0;
  RationalFunction r = e.negative ? -e.pivot : e.pivot;
  for (const auto& d : cleared.rows) r *= RationalFunction::over_factors(1, d.content, d.factors);
  return r;
}

std::size_t rank(const Matrix<Rational>& a) { return static_cast<std::size_t>(flint(a).rank()); }

std::size_t rank(const SymbolicMatrix& a) {
  PolynomialMatrix m = primitive_rows(a);
  const std::size_t most = std::min(a.rows(), a.columns());
  return rank_at_a_point(m) == most ? most : eliminate(std::move(m), a.columns()).columns.size();
}

std::vector<std::vector<Rational>> kernel(const Matrix<Rational>& a) {
  const Matrix<Rational> columns = generic(flint(a).kernel());
  std::vector<std::vector<Rational>> basis;
  for (std::size_t j = 0; j < columns.columns(); ++j) {
    std::vector<Rational> x(a.columns());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = columns(i, j);
    basis.push_back(primitive(x));
  }
  return basis;
}

std::vector<std::vector<RationalFunction>> kernel(const SymbolicMatrix& a) {
  PolynomialMatrix m = primitive_rows(a);
  if (rank_at_a_point(m) == a.columns()) return {};
  const Echelon e = eliminate(std::move(m), a.columns());
  std::vector<std::vector<RationalFunction>> basis;
  for (std::size_t c = 0; c < a.columns(); ++c) {
    if (std::binary_search(e.columns.begin(), e.columns.end(), c)) continue;
    std::vector<RationalFunction> x(a.columns());
    x[c] = e.pivot;
    for (std::size_t i = 0; i < e.columns.size(); ++i) x[e.columns[i]] = -e.matrix(i, c);
    basis.push_back(primitive(x));
  }
  return basis;
}

std::optional<Matrix<Rational>> inverse(const Matrix<Rational>& a) {
  require_square(a.rows(), a.columns());
  const auto r = flint(a).inverse();
  if (!r) return std::nullopt;
  return generic(*r);
}

std::optional<SymbolicMatrix> inverse(const SymbolicMatrix& a) {
  require_square(a.rows(), a.columns());
  const std::size_t n = a.rows();
  const Cleared cleared = clear_rows(a);  // D a with D diagonal: a^{-1} = (D a)^{-1} D
  PolynomialMatrix both(n, 2 * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) both(i, j) = cleared.matrix(i, j);
    both(i, n + i) = cleared.rows[i].expanded();
  }
  const Echelon e = eliminate(std::move(both), n);
  if (e.columns.size() < n) return std::nullopt;
  SymbolicMatrix r(n, n);
  if (n == 0) return r;
  const RationalFunction scale = RationalFunction(e.pivot).inverse();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) r(i, j) = scale * RationalFunction(e.matrix(i, n + j));
  return r;
}

std::vector<Rational> characteristic_polynomial(const Matrix<Rational>& a) {
  require_square(a.rows(), a.columns());
  const Polynomial p = flint(a).characteristic_polynomial();
  const fmpz_poly_struct* view = p.univariate_view();
  std::vector<Rational> r(a.rows() + 1);
  for (std::size_t k = 0; k < r.size(); ++k)
    fmpq_set_fmpz_frac(r[k].raw(), fmpz_poly_get_coeff_ptr(view, static_cast<slong>(k)), fmpz_poly_lead(view));
  return r;
}

std::vector<std::vector<RationalFunction>> characteristic_blocks(const SymbolicMatrix& a) {
  require_square(a.rows(), a.columns());
  std::vector<std::vector<RationalFunction>> blocks;
  collect_blocks(a, blocks);
  return blocks;
}

std::vector<RationalFunction> characteristic_polynomial(const SymbolicMatrix& a) {
  std::vector<RationalFunction> p{1};
  for (const auto& block : characteristic_blocks(a)) {
    std::vector<RationalFunction> r(p.size() + block.size() - 1);
    for (std::size_t i = 0; i < p.size(); ++i)
      for (std::size_t j = 0; j < block.size(); ++j) r[i + j] += p[i] * block[j];
    p = std::move(r);
  }
  return p;
}

std::optional<Matrix<Rational>> constant(const SymbolicMatrix& a) {
  Matrix<Rational> r(a.rows(), a.columns());
  for (std::size_t i = 0; i < a.rows(); ++i)
    for (std::size_t j = 0; j < a.columns(); ++j) {
      const auto value = a(i, j).constant();
      if (!value) return std::nullopt;
      r(i, j) = *value;
    }
  return r;
}

SymbolicMatrix symbolic(const Matrix<Rational>& a) {
  SymbolicMatrix r(a.rows(), a.columns());
  for (std::size_t i = 0; i < a.rows(); ++i)
    for (std::size_t j = 0; j < a.columns(); ++j) r(i, j) = a(i, j);
  return r;
}

std::vector<Rational> primitive(const std::vector<Rational>& x) {
  Rational g;
  int sign = 0;
  for (const auto& c : x) {
    g = gcd(g, c);
    if (sign == 0) sign = c.sign();
  }
  if (sign == 0) return x;
  if (sign < 0) g = -g;
  std::vector<Rational> r;
  for (const auto& c : x) r.push_back(c / g);
  return r;
}

std::vector<RationalFunction> primitive(const std::vector<RationalFunction>& x) {
  const CommonDenominator d = common_denominator(x);
  std::vector<Polynomial> numerators;
  Polynomial g;
  int sign = 0;
  for (const auto& c : x) {
    numerators.push_back(numerator_over(c, d));
    if (!g.is_one()) g = Polynomial::gcd(g, numerators.back());
    if (sign == 0) sign = numerators.back().leading_sign();
  }
  if (sign == 0) return x;
  if (sign < 0) g = -g;
  std::vector<RationalFunction> r;
  for (const auto& n : numerators) r.push_back(Polynomial::exact_quotient(n, g));
  return r;
}

}  // namespace twoscale::analysis
