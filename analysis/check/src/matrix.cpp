// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Square matrices of rational numbers: a common denominator, integer arithmetic.
#include "twoscale/check/matrix.hpp"

#include <algorithm>
#include <utility>

namespace twoscale::check {
namespace {

constexpr std::uint64_t matrix_words = std::uint64_t{1} << 26;  // of a matrix that is being computed

/// A list of numbers that is being computed must fit into memory.
void require_moderate(const std::vector<Integer>& list, Meter& meter) {
  std::uint64_t total = 0;
  for (const Integer& x : list) total += words(x);
  meter.spend(2 * list.size());
  if (total > matrix_words) throw Malformed("the certificate leads to matrices beyond the memory limit of the checker");
}

Integer exact_quotient(const Integer& a, const Integer& b, Meter& meter) {
  if (b == 1 || a == 0) return a;
  meter.spend(3 * words(a) * words(b) + 20);
  return a / b;
}

/// entries of a times the vector v, without the scale.
std::vector<Integer> apply(const Matrix& a, const std::vector<Integer>& v, Meter& meter) {
  std::vector<Integer> result(a.size);
  for (std::size_t i = 0; i < a.size; ++i) {
    for (std::size_t j = 0; j < a.size; ++j) {
      if (a.at(i, j) != 0 && v[j] != 0) result[i] += meter.multiply(a.at(i, j), v[j]);
    }
    meter.spend(a.size);
  }
  return result;
}

}  // namespace

Matrix read_matrix(const Value& value, std::size_t size, const std::string& where, Meter& meter) {
  const std::vector<Value>& rows = as_array(value, where);
  if (rows.empty() || rows.size() > limits::matrix || (size != 0 && rows.size() != size)) {
    throw Malformed(where + ": " + (size != 0 ? std::to_string(size) : "from 1 to " + std::to_string(limits::matrix)) +
                    " rows are expected");
  }
  Matrix result;
  result.size = rows.size();
  std::vector<Fraction> fractions;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string row = where + "[" + std::to_string(i) + "]";
    const std::vector<Value>& items = as_array(rows[i], row);
    if (items.size() != rows.size()) {
      throw Malformed(row + ": " + std::to_string(rows.size()) + " entries are expected");
    }
    for (const Value& item : items) {
      fractions.push_back(parse_fraction(as_string(item, row), row, meter));
      const Integer& d = fractions.back().denominator;
      if (d != 1) result.scale = meter.multiply(result.scale, exact_quotient(d, meter.gcd(result.scale, d), meter));
    }
  }
  for (Fraction& f : fractions) {
    f.numerator = meter.multiply(f.numerator, exact_quotient(result.scale, f.denominator, meter));
    meter.hold(sizeof(Integer) + 8 * words(f.numerator));
    result.entries.push_back(std::move(f.numerator));
  }
  return result;
}

void reduce(std::vector<Integer>& entries, Integer& scale, Meter& meter) {
  Integer divisor = scale;
  for (const Integer& x : entries) {
    if (divisor == 1) return;
    if (x != 0) divisor = meter.gcd(divisor, x);
  }
  if (divisor == 1) return;
  for (Integer& x : entries) x = exact_quotient(x, divisor, meter);
  scale = exact_quotient(scale, divisor, meter);
}

Matrix multiply(const Matrix& a, const Matrix& b, Meter& meter) {
  const std::size_t n = a.size;
  Matrix result{n, std::vector<Integer>(n * n), meter.multiply(a.scale, b.scale)};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      if (a.at(i, k) == 0) continue;
      meter.spend(10 * n);
      for (std::size_t j = 0; j < n; ++j) {
        if (b.at(k, j) != 0) result.entries[i * n + j] += meter.multiply(a.at(i, k), b.at(k, j));
      }
    }
  }
  reduce(result.entries, result.scale, meter);
  require_moderate(result.entries, meter);
  return result;
}

Matrix product(std::span<const Matrix> matrices, std::span<const std::size_t> word, Meter& meter) {
  Matrix result = matrices[word.front()];
  for (const std::size_t s : word.subspan(1)) result = multiply(matrices[s], result, meter);
  return result;
}

std::optional<Matrix> inverse(const Matrix& a, Meter& meter) {
  // Fraction-free Gauss-Jordan (Bareiss): after step k all entries are minors of (A | I) of order k+1.
  const std::size_t n = a.size, width = 2 * n;
  std::vector<Integer> rows(n * width);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) rows[i * width + j] = a.at(i, j);
    rows[i * width + n + i] = 1;
  }
  Integer before = 1;
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t p = k;
    while (p < n && rows[p * width + k] == 0) ++p;
    if (p == n) return std::nullopt;
    for (std::size_t j = 0; p != k && j < width; ++j) rows[k * width + j].swap(rows[p * width + j]);
    const Integer pivot = rows[k * width + k];
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const Integer factor = rows[i * width + k];
      for (std::size_t j = 0; j < width; ++j) {
        Integer& x = rows[i * width + j];
        const Integer& y = rows[k * width + j];
        meter.spend(10);
        if (x != 0) x = meter.multiply(x, pivot);
        if (factor != 0 && y != 0) x -= meter.multiply(factor, y);
        x = exact_quotient(x, before, meter);
      }
    }
    before = pivot;
    require_moderate(rows, meter);
  }
  Matrix result{n, std::vector<Integer>(n * n), abs(before)};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      Integer x = meter.multiply(rows[i * width + n + j], a.scale);
      result.entries[i * n + j] = before < 0 ? Integer(-x) : x;
    }
  }
  reduce(result.entries, result.scale, meter);
  require_moderate(result.entries, meter);
  return result;
}

Matrix diagonal_block(const Matrix& a, std::size_t first, std::size_t size, Meter& meter) {
  Matrix result{size, {}, a.scale};
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      result.entries.push_back(a.at(first + i, first + j));
      meter.hold(sizeof(Integer) + 8 * words(result.entries.back()));
    }
  }
  reduce(result.entries, result.scale, meter);
  return result;
}

Dense characteristic_polynomial(const Matrix& a, Meter& meter) {
  // x^n + c_{n-1} x^{n-1} + ... + c_0: M_0 = 0, M_k = A M_{k-1} + c_{n-k+1} I, c_{n-k} = -trace(A M_k)/k.
  const std::size_t n = a.size;
  Dense c(n + 1);
  c[n] = 1;
  std::vector<Integer> m(n * n), am(n * n);  // am = A M_{k-1}
  for (std::size_t k = 1; k <= n; ++k) {
    m.swap(am);
    for (std::size_t i = 0; i < n; ++i) m[i * n + i] += c[n - k + 1];
    am.assign(n * n, 0);
    Integer trace = 0;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t l = 0; l < n; ++l) {
        if (a.at(i, l) == 0) continue;
        meter.spend(10 * n);
        for (std::size_t j = 0; j < n; ++j) am[i * n + j] += meter.multiply(a.at(i, l), m[l * n + j]);
      }
      trace += am[i * n + i];
      meter.spend(n);
    }
    require_moderate(am, meter);
    c[n - k] = -exact_quotient(trace, Integer(k), meter);
  }
  return c;
}

Dense minimal_polynomial(const Matrix& a, std::vector<Integer> v, Meter& meter) {
  // Rows (a^k v | combination of the powers that gives it), in echelon form; the first power that reduces to 0 gives
  // mu. With the integer matrix A = scale*a, the zeros of its polynomial are scale times those of mu.
  const std::size_t n = a.size;
  struct Row {
    std::size_t pivot;
    std::vector<Integer> list;  // n entries of the vector, n + 1 coefficients
  };
  std::vector<Row> rows;
  for (std::size_t k = 0;; ++k) {
    std::vector<Integer> list = v;
    list.resize(2 * n + 1);
    list[n + k] = 1;
    for (const Row& row : rows) {
      const Integer factor = list[row.pivot];
      if (factor == 0) continue;
      const Integer lead = row.list[row.pivot];
      for (std::size_t i = 0; i < list.size(); ++i) {
        list[i] = meter.multiply(list[i], lead) - meter.multiply(factor, row.list[i]);
      }
      Integer none = 0;
      reduce(list, none, meter);
      require_moderate(list, meter);
    }
    const auto end = list.begin() + static_cast<std::ptrdiff_t>(n);
    const auto pivot = std::find_if(list.begin(), end, [](const Integer& x) { return x != 0; });
    if (pivot == end) {
      Dense mu(end, end + static_cast<std::ptrdiff_t>(k) + 1);
      Integer power = 1;
      for (Integer& c : mu) {
        c = meter.multiply(c, power);
        power = meter.multiply(power, a.scale);
      }
      return primitive(std::move(mu), meter);
    }
    for (const Integer& x : list) meter.hold(sizeof(Integer) + 8 * words(x));
    rows.push_back({static_cast<std::size_t>(pivot - list.begin()), std::move(list)});
    v = apply(a, v, meter);
  }
}

bool spectral_radius_below(const Matrix& a, const Fraction& bound, Meter& meter) {
  Dense p = characteristic_polynomial(a, meter);  // its zeros are scale times the eigenvalues
  const Integer top = meter.multiply(a.scale, bound.numerator);
  Integer power = 1;
  for (Integer& c : p) {  // p(x top/denominator) denominator^n
    c = meter.multiply(c, power);
    power = meter.multiply(power, top);
  }
  power = 1;
  for (std::size_t i = p.size(); i-- > 0;) {
    p[i] = meter.multiply(p[i], power);
    power = meter.multiply(power, bound.denominator);
  }
  return is_schur_stable(primitive(std::move(p), meter), meter);
}

}  // namespace twoscale::check
