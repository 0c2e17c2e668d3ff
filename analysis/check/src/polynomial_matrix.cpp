// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Matrices of polynomials in one variable, vectors of rational functions.
#include "twoscale/check/polynomial_matrix.hpp"

#include <algorithm>
#include <utility>

namespace twoscale::check {
namespace {

/// The entries of a matrix that is being computed must fit into memory.
class Room {
 public:
  explicit Room(Meter& meter) : meter_(meter) {}
  void take(const Dense& p) {
    for (const Integer& c : p) total_ += words(c);
    meter_.spend(2 * p.size() + 10);
    if (total_ > matrix_words) {
      throw Malformed("the certificate leads to polynomials beyond the memory limit of the checker");
    }
  }

 private:
  static constexpr std::uint64_t matrix_words = std::uint64_t{1} << 23;
  Meter& meter_;
  std::uint64_t total_ = 0;
};

}  // namespace

PolynomialMatrix multiply(const PolynomialMatrix& a, const PolynomialMatrix& b, Meter& meter) {
  PolynomialMatrix result{a.rows, b.columns, {}};
  Room room(meter);
  for (std::size_t i = 0; i < a.rows; ++i) {
    for (std::size_t j = 0; j < b.columns; ++j) {
      Dense sum;
      for (std::size_t k = 0; k < a.columns; ++k) add_product(sum, a.at(i, k), b.at(k, j), meter);
      meter.spend(10 * a.columns);
      room.take(sum);
      result.entries.push_back(std::move(sum));
    }
  }
  return result;
}

PolynomialMatrix product(std::span<const PolynomialMatrix> matrices, std::span<const std::size_t> word, Meter& meter) {
  PolynomialMatrix result = matrices[word.front()];
  for (const std::size_t s : word.subspan(1)) result = multiply(matrices[s], result, meter);
  return result;
}

Dense eliminate(PolynomialMatrix& a, std::size_t count, Meter& meter) {
  // Gauss, Jordan, Bareiss: after step k the entries right of column k are minors of order k+1 (up to the order of the
  // rows, of which one changes its sign with each exchange), or stand for a row that is a pivot times a solution.
  Dense before{Integer(1)};
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t p = k;
    while (p < a.rows && a.at(p, k).empty()) ++p;
    if (p >= a.rows) return {};
    for (std::size_t j = 0; p != k && j < a.columns; ++j) {
      a.at(k, j).swap(a.at(p, j));
      a.at(k, j) = negated(std::move(a.at(k, j)));
    }
    const Dense pivot = a.at(k, k);
    Room room(meter);
    for (std::size_t i = 0; i < a.rows; ++i) {
      if (i == k) continue;
      const Dense factor = negated(std::move(a.at(i, k)));
      a.at(i, k).clear();
      for (std::size_t j = k + 1; j < a.columns; ++j) {
        Dense next = multiply(a.at(i, j), pivot, meter);
        add_product(next, factor, a.at(k, j), meter);
        a.at(i, j) = *quotient(next, before, meter);
        room.take(a.at(i, j));
      }
    }
    before = pivot;
  }
  return before;
}

bool FunctionVector::is_zero() const {
  return std::all_of(list.begin(), list.end(), [](const Dense& p) { return p.empty(); });
}

FunctionVector reduced(FunctionVector v, Meter& meter) {
  Dense common = primitive(v.denominator, meter);
  for (const Dense& p : v.list) {
    if (common.size() > 1 && !p.empty()) common = gcd(common, p, meter);
  }
  Integer divisor = 0;
  const auto divide = [&](Dense& p) {
    if (common.size() > 1) p = *quotient(p, common, meter);
    for (const Integer& c : p) {
      if (divisor != 1) divisor = meter.gcd(divisor, c);
    }
  };
  divide(v.denominator);
  for (Dense& p : v.list) divide(p);
  if (v.denominator.back() < 0) divisor = -divisor;
  const auto divide_content = [&](Dense& p) {
    for (Integer& c : p) {
      meter.spend(3 * words(c) * words(divisor) + 10);
      c /= divisor;
    }
  };
  if (divisor != 1) {
    divide_content(v.denominator);
    for (Dense& p : v.list) divide_content(p);
  }
  return v;
}

FunctionVector image(const PolynomialMatrix& a, const FunctionVector& v, const Dense& numerator,
                     const Dense& denominator, Meter& meter) {
  FunctionVector result{std::vector<Dense>(a.rows), multiply(v.denominator, denominator, meter)};
  Room room(meter);
  for (std::size_t i = 0; i < a.rows; ++i) {
    Dense sum;
    for (std::size_t j = 0; j < a.columns; ++j) add_product(sum, a.at(i, j), v.list[j], meter);
    result.list[i] = multiply(sum, numerator, meter);
    meter.spend(10 * a.columns);
    room.take(result.list[i]);
  }
  return reduced(std::move(result), meter);
}

}  // namespace twoscale::check
