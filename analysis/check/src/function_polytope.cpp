// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Invariant polytopes over Q(u): identities, and signs of polynomials on an interval.
#include "twoscale/check/function_polytope.hpp"

#include <array>
#include <set>
#include <utility>

namespace twoscale::check {
namespace {

constexpr std::size_t largest_support = 8;

class FunctionPolytope {
 public:
  FunctionPolytope(const FunctionFamily& family, Meter& meter)
      : family_(family), size_(family.matrices.front().rows), meter_(meter) {}

  PolytopeReport check(Fields& fields) {
    const std::vector<Value>& roots = fields.take_array("roots");
    if (roots.size() > limits::list_items) throw Malformed(fields.path("roots") + ": more than 4096");
    for (std::size_t i = 0; i < roots.size(); ++i) {
      Fields root(roots[i], fields.path("roots") + "[" + std::to_string(i) + "]");
      add_root(root);
    }
    read_tree(fields.take_array("tree"), fields.path("tree"));
    read_inner(fields.take_array("inner"), fields.path("inner"));
    read_images(fields.take_array("images"), fields.path("images"));
    if (eigenvectors_ == 0) throw Refused("no eigenvector of a product is given: rho may be less");
    return {vertices_.size(), eigenvectors_};
  }

 private:
  void keep(FunctionVector vertex) {
    hold(vertex.denominator, meter_);
    for (const Dense& p : vertex.list) hold(p, meter_);
    vertices_.push_back(std::move(vertex));
  }

  /// B_s x/psi
  FunctionVector image_of(std::size_t s, const FunctionVector& x) {
    return image(family_.matrices[s], x, family_.numerator, family_.denominator, meter_);
  }

  /// x = sign*y, both in lowest terms.
  static bool equal(const FunctionVector& x, const FunctionVector& y, int sign) {
    if (x.denominator != y.denominator) return false;
    for (std::size_t i = 0; i < x.list.size(); ++i) {
      if (x.list[i] != (sign > 0 ? y.list[i] : negated(y.list[i]))) return false;
    }
    return true;
  }

  void add_root(Fields& root) {
    const std::string where = root.path("word");
    const std::vector<std::size_t> word = read_indices(root.take_array("word"), family_.matrices.size(), where);
    const int sign = read_sign(root);
    if (word.empty() && sign != 1) throw Malformed(where + ": the sign of a vertex without a word is 1");
    const Fraction scale = parse_fraction(root.take_string("scale"), root.path("scale"), meter_);
    if (scale.numerator <= 0) throw Malformed(root.path("scale") + ": a positive number is expected");
    const std::vector<Value>& items = root.take_array("vector");
    if (items.size() != size_) throw Malformed(root.path("vector") + ": " + std::to_string(size_) + " are expected");
    FunctionVector vertex;
    for (const Value& item : items) {
      const Dense p = read_in_u(item, root.path("vector"), meter_);
      vertex.list.push_back(multiply(p, {scale.numerator}, meter_));
    }
    vertex.denominator = {scale.denominator};
    root.done();
    vertex = reduced(std::move(vertex), meter_);
    if (vertex.is_zero()) throw Refused("the vector of " + where + " is 0");
    if (!word.empty()) ++eigenvectors_;
    FunctionVector last = vertex;
    for (const std::size_t s : word) last = image_of(s, last);
    if (!equal(last, vertex, sign)) throw Refused("the vector is no eigenvector of the product of " + where);
    keep(std::move(vertex));
  }

  void read_tree(const std::vector<Value>& items, const std::string& where) {
    if (items.size() > limits::list_items) throw Malformed(where + ": more than 4096");
    for (const Value& item : items) {
      const std::vector<Value>& pair = as_array(item, where);
      if (pair.size() != 2) throw Malformed(where + ": pairs of a vertex and a matrix are expected");
      if (vertices_.empty()) throw Malformed(where + ": there is no root");
      const std::size_t parent = index(pair[0], vertices_.size(), where);
      const std::size_t matrix = index(pair[1], family_.matrices.size(), where);
      if (!edges_.insert({parent, matrix}).second) throw Malformed(where + ": a pair occurs twice");
      keep(image_of(matrix, vertices_[parent]));
    }
  }

  void read_inner(const std::vector<Value>& items, const std::string& where) {
    if (items.size() != size_) throw Malformed(where + ": " + std::to_string(size_) + " indices are expected");
    PolynomialMatrix inner = columns(read_indices(items, vertices_.size(), where), nullptr);
    const Dense determinant = eliminate(inner, size_, meter_);
    if (determinant.empty() || zeros_between(determinant, family_.low, family_.high, meter_) != 0) {
      throw Refused("the vertices of " + where + " are not linearly independent in the whole interval");
    }
  }

  void read_images(const std::vector<Value>& items, const std::string& where) {
    const std::size_t count = vertices_.size() * family_.matrices.size() - edges_.size();
    if (items.size() != count) throw Malformed(where + ": " + std::to_string(count) + " are expected");
    std::size_t next = 0;
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      for (std::size_t s = 0; s < family_.matrices.size(); ++s) {
        meter_.spend(100);
        if (edges_.contains({v, s})) continue;
        Fields fields(items[next], where + "[" + std::to_string(next) + "]");
        ++next;
        const std::string what =
            "the image of the vertex " + std::to_string(v) + " under the matrix " + std::to_string(s);
        const FunctionVector y = image_of(s, vertices_[v]);
        if (fields.next_is("equals")) {
          const std::size_t j = index(fields.take("equals"), vertices_.size(), fields.path("equals"));
          const int sign = read_sign(fields);
          fields.done();
          if (!equal(y, vertices_[j], sign)) {
            throw Refused(what + " is not the vertex " + std::to_string(j) + " with this sign");
          }
        } else {
          require_inside(fields, y, what);
        }
      }
    }
  }

  /// y is a combination of the vertices of the support, with coefficients whose absolute values add up to at most 1.
  void require_inside(Fields& fields, const FunctionVector& y, const std::string& what) {
    const std::string where = fields.path("support");
    const std::vector<std::size_t> support = read_indices(fields.take_array("support"), vertices_.size(), where);
    fields.done();
    const std::size_t n = support.size();
    if (n > largest_support) throw Malformed(where + ": at most " + std::to_string(largest_support) + " are allowed");
    for (std::size_t j = 1; j < n; ++j) {
      if (support[j - 1] >= support[j]) throw Malformed(where + ": the vertices must ascend");
    }
    PolynomialMatrix system = columns(support, &y);
    const Dense pivot = eliminate(system, n, meter_);
    if (pivot.empty()) throw Refused("the vertices of " + where + " are linearly dependent");
    for (std::size_t i = n; i < size_; ++i) {
      if (!system.at(i, n).empty()) throw Refused(what + " is no combination of the vertices of its support");
    }
    FunctionVector c;  // the coefficients
    for (std::size_t j = 0; j < n; ++j) {
      c.list.push_back(multiply(system.at(j, n), vertices_[support[j]].denominator, meter_));
    }
    c.denominator = multiply(pivot, y.denominator, meter_);
    c = reduced(std::move(c), meter_);
    Dense whole = c.denominator;
    if (!is_positive_between(whole, family_.low, family_.high, meter_)) {
      whole = negated(std::move(whole));
      if (!is_positive_between(whole, family_.low, family_.high, meter_)) {
        throw Refused(what + ": its coefficients have a pole in the interval");
      }
    }
    for (std::size_t pattern = 0; pattern < std::size_t{1} << n; ++pattern) {
      Dense slack = whole;
      for (std::size_t j = 0; j < n; ++j) add_product(slack, c.list[j], {(pattern >> j & 1U) != 0 ? 1 : -1}, meter_);
      if (!is_nonnegative_between(slack, family_.low, family_.high, meter_)) {
        throw Refused(what + " leaves the hull in the interval");
      }
    }
  }

  /// The numerators of the vertices, and of one more vector, as columns.
  PolynomialMatrix columns(const std::vector<std::size_t>& vertices, const FunctionVector* last) {
    PolynomialMatrix result{size_, vertices.size() + (last != nullptr ? 1 : 0), {}};
    for (std::size_t i = 0; i < size_; ++i) {
      for (const std::size_t j : vertices) result.entries.push_back(vertices_[j].list[i]);
      if (last != nullptr) result.entries.push_back(last->list[i]);
      meter_.spend(20 * result.columns);
    }
    return result;
  }

  static std::size_t index(const Value& value, std::size_t count, const std::string& where) {
    return static_cast<std::size_t>(as_integer(value, 0, static_cast<long>(count) - 1, where));
  }

  const FunctionFamily& family_;
  std::size_t size_;
  Meter& meter_;
  std::vector<FunctionVector> vertices_;                 // in lowest terms
  std::size_t eigenvectors_ = 0;                         // roots with a word
  std::set<std::pair<std::size_t, std::size_t>> edges_;  // of the tree
};

}  // namespace

Dense read_in_u(const Value& value, const std::string& where, Meter& meter) {
  static const std::array<std::string, 1> names{"u"};
  return dense(parse_polynomial(as_string(value, where), names, where, meter));
}

PolytopeReport check_function_polytope(const FunctionFamily& family, Fields& fields, Meter& meter) {
  return FunctionPolytope(family, meter).check(fields);
}

}  // namespace twoscale::check
