// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Invariant polytopes: exact vectors for equalities, intervals for membership.
#include "twoscale/check/polytope.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace twoscale::check {
namespace {

class Polytope {
 public:
  Polytope(std::span<const Matrix> matrices, const Radius& radius, unsigned bits, bool plain, Meter& meter)
      : matrices_(matrices),
        size_(matrices.front().size),
        plain_(plain),
        meter_(meter),
        ring_(radius.polynomial, meter),
        rho_(radius, bits, meter) {}

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
    return {vertices_.size(), eigenvectors_};
  }

 private:
  struct Vertex {
    VectorEnclosure box;
    std::size_t parent = 0, matrix = 0;  // not for roots
    std::size_t depth = 0;               // box = exact/rho^depth
    std::optional<Residues> exact;
  };

  void keep(Vertex vertex) {
    for (const auto* list : {&vertex.box.low, &vertex.box.high}) {
      for (const Integer& x : *list) meter_.hold(sizeof(Integer) + 8 * words(x));
    }
    vertices_.push_back(std::move(vertex));
  }

  void add_root(Fields& root) {
    const std::string where = root.path("word");
    const std::vector<std::size_t> word = read_indices(root.take_array("word"), matrices_.size(), where);
    const int sign = read_sign(root);
    const Fraction scale = parse_fraction(root.take_string("scale"), root.path("scale"), meter_);
    if (scale.numerator <= 0) throw Malformed(root.path("scale") + ": a positive number is expected");
    const std::vector<Value>& items = root.take_array("vector");
    if (items.size() != size_) throw Malformed(root.path("vector") + ": " + std::to_string(size_) + " are expected");
    std::vector<Dense> vector;
    for (const Value& item : items) {
      vector.push_back(read_in_x(item, root.path("vector"), meter_));
      if (plain_ && vector.back().size() > 1) throw Malformed(root.path("vector") + ": integers are expected");
    }
    root.done();
    if (plain_ && !word.empty()) throw Malformed(where + ": [] is expected in a block with a bound");
    if (word.empty() && sign != 1) throw Malformed(root.path("sign") + ": 1 is expected for an empty word");

    Vertex vertex;
    vertex.box = rho_.value(vector, scale);
    Residues exact = ring_.reduced({std::move(vector), 1});
    if (!word.empty()) {
      Residues image = exact;
      for (const std::size_t s : word) image = ring_.times(matrices_[s], image);
      if (!ring_.equal(image, ring_.times_x(exact, word.size()), sign)) {
        throw Refused("the vector is no eigenvector of the product of " + where);
      }
      bool nonzero = false;
      for (std::size_t i = 0; i < size_; ++i) nonzero = nonzero || vertex.box.low[i] > 0 || vertex.box.high[i] < 0;
      if (!nonzero) throw Refused("the eigenvector of " + where + " cannot be told from 0");
      ++eigenvectors_;
    }
    for (Dense& q : exact.list) {
      for (Integer& c : q) {
        c = meter_.multiply(c, scale.numerator);
        meter_.hold(sizeof(Integer) + 8 * words(c));
      }
    }
    exact.scale = meter_.multiply(exact.scale, scale.denominator);
    vertex.exact = std::move(exact);
    keep(std::move(vertex));
  }

  void read_tree(const std::vector<Value>& items, const std::string& where) {
    if (items.size() > limits::list_items) throw Malformed(where + ": more than 4096");
    for (const Value& item : items) {
      const std::vector<Value>& pair = as_array(item, where);
      if (pair.size() != 2) throw Malformed(where + ": pairs of a vertex and a matrix are expected");
      if (vertices_.empty()) throw Malformed(where + ": there is no root");
      Vertex vertex;
      vertex.parent = index(pair[0], vertices_.size(), where);
      vertex.matrix = index(pair[1], matrices_.size(), where);
      if (!edges_.insert({vertex.parent, vertex.matrix}).second) throw Malformed(where + ": a pair occurs twice");
      const Vertex& parent = vertices_[vertex.parent];
      vertex.depth = parent.depth + 1;
      vertex.box = rho_.image(matrices_[vertex.matrix], parent.box);
      keep(std::move(vertex));
    }
  }

  void read_inner(const std::vector<Value>& items, const std::string& where) {
    if (items.size() != size_) throw Malformed(where + ": " + std::to_string(size_) + " indices are expected");
    const std::vector<std::size_t> inner = read_indices(items, vertices_.size(), where);
    if (std::set<std::size_t>(inner.begin(), inner.end()).size() != size_) {
      throw Malformed(where + ": an index occurs twice");
    }
    Integer scale = 1;  // of all columns
    for (const std::size_t j : inner) {
      const Integer& other = vertices_[j].box.scale;
      if (scale == other) continue;
      const Integer common = meter_.gcd(scale, other);
      meter_.spend(3 * words(other) * words(common));
      scale = meter_.multiply(scale, other / common);
    }
    Matrix low{size_, std::vector<Integer>(size_ * size_), scale};
    Matrix high = low, middle = low;
    middle.scale = scale * 2;
    for (std::size_t j = 0; j < size_; ++j) {
      const VectorEnclosure& x = vertices_[inner[j]].box;
      meter_.spend(3 * words(scale) * words(x.scale) + 10);
      const Integer factor = scale / x.scale;
      for (std::size_t i = 0; i < size_; ++i) {
        const std::size_t at = i * size_ + j;
        low.entries[at] = meter_.multiply(x.low[i], factor);
        high.entries[at] = meter_.multiply(x.high[i], factor);
        middle.entries[at] = low.entries[at] + high.entries[at];
        meter_.hold(2 * sizeof(Integer) + 16 * words(low.entries[at]));
      }
    }
    auto inverted = inverse(middle, meter_);
    if (!inverted) throw Refused("the vertices of " + where + " are not seen to be linearly independent");
    inverse_ = std::move(*inverted);
    if (!rho_.is_exact()) {
      for (Integer& w : inverse_.entries) w = floor_quotient(w << rho_.bits(), inverse_.scale, meter_);
      inverse_.scale = Integer(1) << rho_.bits();
    }
    for (const Integer& w : inverse_.entries) meter_.hold(sizeof(Integer) + 8 * words(w));
    unit_ = meter_.multiply(inverse_.scale, scale);
    error_ = rho_.is_exact() ? Integer(0) : largest_error(low, high);
    if (error_ >= unit_) throw Refused("the vertices of " + where + " are not seen to be linearly independent");
  }

  /// unit_ times the 1-norm of I - inverse_*X, low <= X <= high.
  Integer largest_error(const Matrix& low, const Matrix& high) {
    Integer largest = 0;
    for (std::size_t j = 0; j < size_; ++j) {
      Integer sum = 0;
      for (std::size_t i = 0; i < size_; ++i) {
        Integer least = i == j ? Integer(-unit_) : Integer(0);
        Integer most = least;
        for (std::size_t k = 0; k < size_; ++k) {
          const Integer& w = inverse_.at(i, k);
          least += meter_.multiply(w, w > 0 ? low.at(k, j) : high.at(k, j));
          most += meter_.multiply(w, w > 0 ? high.at(k, j) : low.at(k, j));
        }
        sum += std::max<Integer>(abs(least), abs(most));
      }
      largest = std::max(largest, sum);
    }
    return largest;
  }

  void read_images(const std::vector<Value>& items, const std::string& where) {
    const std::size_t count = vertices_.size() * matrices_.size() - edges_.size();
    if (items.size() != count) throw Malformed(where + ": " + std::to_string(count) + " are expected");
    std::size_t next = 0;
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      for (std::size_t s = 0; s < matrices_.size(); ++s) {
        meter_.spend(100);
        if (edges_.contains({v, s})) continue;
        Fields image(items[next], where + "[" + std::to_string(next) + "]");
        ++next;
        if (image.next_is("equals")) {
          require_equal(image, v, s);
        } else {
          require_inside(image, v, s);
        }
      }
    }
  }

  [[noreturn]] void refuse(std::size_t v, std::size_t s, const std::string& what) const {
    throw Refused("the image of the vertex " + std::to_string(v) + " under the matrix " + std::to_string(s) + what);
  }

  void require_equal(Fields& image, std::size_t v, std::size_t s) {
    const std::size_t j = index(image.take("equals"), vertices_.size(), image.path("equals"));
    const int sign = read_sign(image);
    image.done();
    // u_y/rho^(depth_v + 1) = sign u_j/rho^depth_j
    const std::size_t depth = vertices_[v].depth + 1, other = vertices_[j].depth;
    Residues left = ring_.times(matrices_[s], exact(v));
    Residues right = exact(j);
    const std::size_t common = std::min(depth, other);
    left = ring_.times_x(std::move(left), other - common);
    right = ring_.times_x(std::move(right), depth - common);
    if (!ring_.equal(left, right, sign)) refuse(v, s, " is not the vertex " + std::to_string(j) + " with this sign");
  }

  void require_inside(Fields& image, std::size_t v, std::size_t s) {
    const std::vector<Value>& items = image.take_array("sum");
    const std::string where = image.path("sum");
    image.done();
    VectorEnclosure rest = rho_.image(matrices_[s], vertices_[v].box);
    Fraction total;  // sum |c_j|
    std::size_t least = 0;
    for (const Value& item : items) {
      const std::vector<Value>& pair = as_array(item, where);
      if (pair.size() != 2) throw Malformed(where + ": pairs of a vertex and a coefficient are expected");
      const std::size_t j = index(pair[0], vertices_.size(), where);
      if (j < least) throw Malformed(where + ": the vertices must ascend");
      least = j + 1;
      Fraction c = parse_fraction(as_string(pair[1], where), where, meter_);
      if (c.numerator == 0) throw Malformed(where + ": a coefficient 0");
      c.numerator = -c.numerator;
      rest = combined(rest, vertices_[j].box, c, meter_);
      total = reduced(
          meter_.multiply(total.numerator, c.denominator) + meter_.multiply(abs(c.numerator), total.denominator),
          meter_.multiply(total.denominator, c.denominator), meter_);
    }
    Integer norm = 0;  // inverse_.scale*rest.scale times the 1-norm of inverse_*rest
    for (std::size_t i = 0; i < size_; ++i) {
      Integer low = 0, high = 0;
      for (std::size_t k = 0; k < size_; ++k) {
        const Integer& w = inverse_.at(i, k);
        if (w == 0) continue;
        low += meter_.multiply(w, w > 0 ? rest.low[k] : rest.high[k]);
        high += meter_.multiply(w, w > 0 ? rest.high[k] : rest.low[k]);
      }
      norm += std::max<Integer>(abs(low), abs(high));
    }
    // total + norm/(inverse_.scale rest.scale)/(1 - error_/unit_) <= 1, unit_ = inverse_.scale x_scale
    const Integer room = total.denominator - total.numerator;
    meter_.spend(3 * words(unit_) * words(inverse_.scale) + 10);
    const Integer x_scale = unit_ / inverse_.scale;
    const Integer left = meter_.multiply(meter_.multiply(norm, total.denominator), x_scale);
    const Integer right = meter_.multiply(meter_.multiply(room, unit_ - error_), rest.scale);
    if (room < 0 || left > right) refuse(v, s, " is not seen to lie in the hull");
  }

  static std::size_t index(const Value& value, std::size_t count, const std::string& where) {
    return static_cast<std::size_t>(as_integer(value, 0, static_cast<long>(count) - 1, where));
  }

  /// rho^depth times the vertex.
  const Residues& exact(std::size_t v) {
    std::vector<std::size_t> path;
    for (; !vertices_[v].exact; v = vertices_[v].parent) path.push_back(v);
    const Residues* last = &*vertices_[v].exact;
    for (; !path.empty(); path.pop_back()) {
      Vertex& vertex = vertices_[path.back()];
      vertex.exact = ring_.times(matrices_[vertex.matrix], *last);
      last = &*vertex.exact;
      for (const Dense& q : last->list) {
        for (const Integer& c : q) meter_.hold(sizeof(Integer) + 8 * words(c));
      }
    }
    return *last;
  }

  std::span<const Matrix> matrices_;
  std::size_t size_;
  bool plain_;
  Meter& meter_;
  ResidueRing ring_;
  Enclosure rho_;
  std::vector<Vertex> vertices_;
  std::size_t eigenvectors_ = 0;
  std::set<std::pair<std::size_t, std::size_t>> edges_;  // of the tree
  Matrix inverse_;  // of the inner vertices as columns, up to I - inverse_*X, of norm error_/unit_
  Integer error_, unit_;
};

}  // namespace

PolytopeReport check_polytope(std::span<const Matrix> matrices, const Radius& radius, unsigned bits, bool plain,
                              Fields& fields, Meter& meter) {
  return Polytope(matrices, radius, bits, plain, meter).check(fields);
}

int read_sign(Fields& fields) {
  const long sign = fields.take_integer("sign", -1, 1);
  if (sign == 0) throw Malformed(fields.path("sign") + ": 1 or -1 is expected");
  return static_cast<int>(sign);
}

std::vector<std::size_t> read_indices(const std::vector<Value>& items, std::size_t count, const std::string& where) {
  if (items.size() > limits::list_items) throw Malformed(where + ": more than 4096");
  std::vector<std::size_t> result;
  for (const Value& item : items) {
    result.push_back(static_cast<std::size_t>(as_integer(item, 0, static_cast<long>(count) - 1, where)));
  }
  return result;
}

}  // namespace twoscale::check
