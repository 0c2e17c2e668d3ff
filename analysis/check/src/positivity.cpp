// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Signs on boxes: Sturm in one variable, Bernstein coefficients on a bisection tree.
//   on a side [low, high]     x = (low u + high t)/(u + t)      u, t >= 0, not both 0
//   on a half-line from low   x = low + t/u                     u > 0; t/u = infinity is u = 0
// With (u + t)^deg or u^deg cleared, p is a form in the (u, t) of each variable; its coefficients have the signs of the
// Bernstein coefficients. A coefficient stands on the face "low" of a variable if it belongs to t^0, on "high" if to
// u^0. If none is negative, p >= 0; and p > 0 inside each face (of any dimension) on which some coefficient is
// positive.
#include "twoscale/check/positivity.hpp"

#include <algorithm>
#include <cstdint>

namespace twoscale::check {
namespace {

constexpr std::size_t tensor_items = std::size_t{1} << 18;
constexpr std::uint64_t tensor_bytes = std::uint64_t{1} << 28;  // all that are alive at a time
constexpr std::size_t tree_depth = 256;

void add(Integer& target, const Integer& amount, Meter& meter) {
  meter.spend(words(amount) + words(target) + 10);
  target += amount;
}

/// c(x) -> c(x + a).
void shift(std::vector<Integer>& c, const Integer& a, Meter& meter) {
  if (a == 0) return;
  for (std::size_t done = 0; done + 1 < c.size(); ++done) {
    for (std::size_t i = c.size() - 1; i-- > done;) {
      if (a == 1)
        add(c[i], c[i + 1], meter);
      else
        add(c[i], meter.multiply(a, c[i + 1]), meter);
    }
  }
}

/// c(x) -> c(2x + 1).
void shift_and_double(std::vector<Integer>& c, Meter& meter) {
  shift(c, 1, meter);
  for (std::size_t j = 0; j < c.size(); ++j) {
    meter.spend(words(c[j]) + j / 32 + 10);
    c[j] <<= static_cast<unsigned>(j);
  }
}

/// Coefficients of a form of degrees d_0, d_1, ...; the last variable runs fastest.
struct Tensor {
  std::vector<std::size_t> length;  // d_j + 1
  std::vector<Integer> items;

  std::uint64_t bytes() const {
    std::uint64_t sum = 0;
    for (const Integer& c : items) sum += sizeof(Integer) + 8 * words(c);
    return sum;
  }
  /// Applies f to each line in direction `axis`.
  template <class F>
  void each_line(std::size_t axis, const F& f) {
    std::size_t stride = 1;
    for (std::size_t j = axis + 1; j < length.size(); ++j) stride *= length[j];
    std::vector<Integer> line(length[axis]);
    for (std::size_t start = 0; start < items.size(); ++start) {
      if (start / stride % length[axis] != 0) continue;
      for (std::size_t i = 0; i < line.size(); ++i) line[i] = std::move(items[start + i * stride]);
      f(line);
      for (std::size_t i = 0; i < line.size(); ++i) items[start + i * stride] = std::move(line[i]);
    }
  }
};

/// Powers of x on a line -> coefficients of t^i u^{d-i} on the side.
void to_form(std::vector<Integer>& line, const Side& side, Meter& meter) {
  const Integer high = side.high ? side.high->numerator : Integer(1);
  const Integer high_scale = side.high ? side.high->denominator : Integer(1);
  const Integer scale = meter.multiply(side.low.denominator, high_scale);  // low = l/scale
  const Integer l = meter.multiply(side.low.numerator, high_scale);
  const Integer width = side.high ? Integer(meter.multiply(high, side.low.denominator) - l) : scale;
  Integer power = 1;  // scale^d p((l + s)/scale)
  for (std::size_t i = line.size(); i-- > 0;) {
    line[i] = meter.multiply(line[i], power);
    power = meter.multiply(power, scale);
  }
  shift(line, l, meter);
  power = 1;  // s = width t/(u + t), or scale t/u
  for (Integer& c : line) {
    c = meter.multiply(c, power);
    power = meter.multiply(power, width);
  }
  if (!side.high) return;
  std::reverse(line.begin(), line.end());  // a polynomial in (u + t)/t = u/t + 1
  shift(line, 1, meter);
  std::reverse(line.begin(), line.end());
}

Tensor form_of(const Polynomial& p, const Box& box, Meter& meter) {
  const Monomial top = degrees(p);
  Tensor tensor;
  std::size_t size = 1;
  for (std::size_t j = 0; j < box.sides.size(); ++j) {
    tensor.length.push_back(static_cast<std::size_t>(top[j]) + 1);
    size *= tensor.length.back();
    if (size > tensor_items) throw Malformed("a polynomial with more than 2^18 Bernstein coefficients");
  }
  tensor.items.resize(size);
  meter.spend(10 * size);
  for (const auto& [monomial, coefficient] : p) {
    std::size_t at = 0;
    for (std::size_t j = 0; j < tensor.length.size(); ++j) {
      at = at * tensor.length[j] + static_cast<std::size_t>(monomial[j]);
    }
    tensor.items[at] = coefficient;
  }
  for (std::size_t j = 0; j < tensor.length.size(); ++j) {
    tensor.each_line(j, [&](std::vector<Integer>& line) { to_form(line, box.sides[j], meter); });
  }
  return tensor;
}

/// Reads a tree in prefix order: "." a leaf, a digit j a bisection (at u = t) of variable j, the low half first.
class Walk {
 public:
  Walk(const Box& box, bool strict, const std::string& tree, const std::string& where, Meter& meter)
      : box_(box), strict_(strict), tree_(tree), where_(where), meter_(meter) {}

  void run(Tensor tensor) {
    const std::vector<bool> all(box_.sides.size(), true);
    node(std::move(tensor), all, all, 0);
    if (at_ != tree_.size()) throw Malformed(where_ + ": text after the end of the tree");
  }

 private:
  void node(Tensor tensor, const std::vector<bool>& low, const std::vector<bool>& high, std::size_t depth) {
    if (depth > tree_depth) throw Malformed(where_ + ": a tree of more than 256 levels");
    if (at_ >= tree_.size()) throw Malformed(where_ + ": the tree ends too early");
    meter_.spend(20 * tensor.items.size() + 20);
    const char c = tree_[at_++];
    if (c == '.') return leaf(tensor, low, high);
    if (c < '0' || c > '9' || static_cast<std::size_t>(c - '0') >= box_.sides.size()) {
      throw Malformed(where_ + ": '.' or the index of a variable is expected in the tree");
    }
    const auto axis = static_cast<std::size_t>(c - '0');
    const std::uint64_t bytes = tensor.bytes();
    alive_ += bytes;
    if (alive_ > tensor_bytes) throw Malformed(where_ + ": the tree needs more memory than the limit of the checker");
    std::vector<bool> inner_low = low, inner_high = high;
    inner_low[axis] = inner_high[axis] = false;
    {
      Tensor half = tensor;
      half.each_line(axis, [&](std::vector<Integer>& line) {  // u = 2u' + t', t = t'
        std::reverse(line.begin(), line.end());
        shift_and_double(line, meter_);
        std::reverse(line.begin(), line.end());
      });
      node(std::move(half), low, inner_high, depth + 1);
    }
    tensor.each_line(axis,
                     [&](std::vector<Integer>& line) { shift_and_double(line, meter_); });  // t = 2t' + u', u = u'
    node(std::move(tensor), inner_low, high, depth + 1);
    alive_ -= bytes;
  }

  void leaf(const Tensor& tensor, const std::vector<bool>& low, const std::vector<bool>& high) {
    const std::size_t n = tensor.length.size();
    const std::size_t masks = std::size_t{1}
                              << (2 * n);  // bits 2j: on the low face of variable j, 2j+1: on the high one
    std::vector<bool> covered(strict_ ? masks : 0);
    for (std::size_t at = 0; at < tensor.items.size(); ++at) {
      const int sign = tensor.items[at].sign();
      if (sign < 0) throw Refused(where_ + ": a negative Bernstein coefficient on a leaf of the tree");
      if (sign == 0 || !strict_) continue;
      std::size_t mask = 0;
      for (std::size_t j = n, rest = at; j-- > 0; rest /= tensor.length[j]) {
        const std::size_t i = rest % tensor.length[j];
        if (i == 0) mask |= std::size_t{1} << (2 * j);
        if (i + 1 == tensor.length[j]) mask |= std::size_t{2} << (2 * j);
      }
      covered[mask] = true;
    }
    if (!strict_) return;
    meter_.spend(4 * masks * (n + 1) + tensor.items.size() * (n + 1) * 10);
    for (std::size_t bit = 1; bit < masks; bit *= 2) {  // what stands on a face stands on the larger ones
      for (std::size_t mask = 0; mask < masks; ++mask) {
        if ((mask & bit) != 0 && covered[mask]) covered[mask ^ bit] = true;
      }
    }
    for (std::size_t face = 0; face < masks; ++face) {
      if (!covered[face] && in_claim(face, low, high)) {
        throw Refused(where_ + ": zero on a face of a leaf of the tree where no zero is allowed");
      }
    }
  }

  /// A face (of any dimension) of a leaf: is strict positivity claimed inside it?
  bool in_claim(std::size_t face, const std::vector<bool>& low, const std::vector<bool>& high) const {
    for (std::size_t j = 0; j < box_.sides.size(); ++j) {
      const std::size_t bits = face >> (2 * j) & 3U;
      const Side& side = box_.sides[j];
      if (bits == 3) return false;  // not a face
      if (bits == 1 && low[j] && side.zero_low) return false;
      if (bits == 2 && high[j] && (side.zero_high || !side.high)) return false;  // infinity is not in the box
    }
    return true;
  }

  const Box& box_;
  bool strict_;
  const std::string& tree_;
  const std::string& where_;
  Meter& meter_;
  std::size_t at_ = 0;
  std::uint64_t alive_ = 0;
};

/// Divides p (not zero) by (denominator x - numerator) as often as possible; returns how often.
std::size_t remove_zero(Dense& p, const Fraction& at, Meter& meter) {
  const Dense factor{-at.numerator, at.denominator};
  std::size_t count = 0;
  while (sign_at(p, at.numerator, at.denominator, meter) == 0) {
    std::optional<Dense> rest = quotient(p, factor, meter);  // over Z by Gauss: the factor is primitive
    p = std::move(*rest);
    ++count;
  }
  return count;
}

/// Distinct zeros in the open interval; none of its ends is a zero.
int count(const SturmChain& chain, const Fraction& low, const std::optional<Fraction>& high, Meter& meter) {
  return chain.zeros_beyond(low.numerator, low.denominator, meter) -
         (high ? chain.zeros_beyond(high->numerator, high->denominator, meter) : 0);
}

void require_by_sturm(Dense p, const Side& side, bool strict, const std::string& where, Meter& meter) {
  const std::size_t at_low = remove_zero(p, side.low, meter);
  const std::size_t at_high = side.high ? remove_zero(p, *side.high, meter) : 0;
  if (strict && ((at_low > 0 && !side.zero_low) || (at_high > 0 && !side.zero_high))) {
    throw Refused(where + ": zero at an end where no zero is allowed");
  }
  const int beside_low = sign_at(p, side.low.numerator, side.low.denominator, meter) * (at_high % 2 == 0 ? 1 : -1);
  if (beside_low < 0) throw Refused(where + ": negative beside the lower end");
  while (true) {  // the k-th round counts the zeros of multiplicity 2k+1 at least, then those of 2k+2 at least
    const SturmChain chain(p, meter);
    const int zeros = count(chain, side.low, side.high, meter);
    if (zeros == 0) return;
    if (strict) throw Refused(where + ": a zero inside");
    const SturmChain repeated(chain.last(), meter);
    if (count(repeated, side.low, side.high, meter) != zeros) throw Refused(where + ": a change of sign inside");
    p = repeated.last();
  }
}

}  // namespace

bool is_variable_name(const std::string& name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return !name.empty() && name.size() <= 64 && letter(name.front()) &&
         std::all_of(name.begin(), name.end(), [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; });
}

bool less(const Fraction& a, const Fraction& b, Meter& meter) {
  return meter.multiply(a.numerator, b.denominator) < meter.multiply(b.numerator, a.denominator);
}

Box read_box(Fields& fields, Meter& meter) {
  Box box;
  const std::vector<Value>& names = fields.take_array("variables");
  const std::string where = fields.path("variables");
  if (names.size() > limits::variables) throw Malformed(where + ": more than " + std::to_string(limits::variables));
  for (const Value& item : names) {
    const std::string& name = as_string(item, where);
    if (!is_variable_name(name)) throw Malformed(where + ": a name [A-Za-z][A-Za-z0-9_]* is expected");
    if (!box.names.empty() && !(box.names.back() < name)) {
      throw Malformed(where + ": names must be distinct and sorted");
    }
    box.names.push_back(name);
  }
  const std::vector<Value>& sides = fields.take_array("box");
  if (sides.size() != names.size()) throw Malformed(fields.path("box") + ": one side for each variable is expected");
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const std::string at = fields.path("box") + "[" + std::to_string(i) + "]";
    const std::vector<Value>& ends = as_array(sides[i], at);
    if (ends.size() != 2) throw Malformed(at + ": two ends are expected");
    Side side;
    side.low = parse_fraction(as_string(ends[0], at), at, meter);
    if (!as_string(ends[1], at).empty()) {
      side.high = parse_fraction(ends[1].text, at, meter);
      if (!less(side.low, *side.high, meter)) throw Malformed(at + ": the ends must ascend");
    }
    box.sides.push_back(std::move(side));
  }
  return box;
}

void read_zeros(Fields& fields, Box& box) {
  const std::vector<Value>& faces = fields.take_array("zeros");
  const std::string where = fields.path("zeros");
  const std::string* before = nullptr;
  for (const Value& item : faces) {
    const std::string& face = as_string(item, where);
    if (before != nullptr && !(*before < face)) throw Malformed(where + ": faces must be distinct and sorted");
    before = &face;
    bool found = false;
    for (std::size_t j = 0; j < box.names.size(); ++j) {
      if (face == box.names[j] + "=lo") box.sides[j].zero_low = found = true;
      if (face == box.names[j] + "=hi" && box.sides[j].high) box.sides[j].zero_high = found = true;
    }
    if (!found) throw Malformed(where + ": a face of the box is expected, like \"x=lo\"");
  }
}

std::vector<Fraction> read_point(const Value& at, const Box& box, const std::string& where, Meter& meter) {
  const std::vector<Value>& items = as_array(at, where);
  if (items.size() != box.names.size()) throw Malformed(where + ": one number for each variable is expected");
  std::vector<Fraction> point;
  for (std::size_t j = 0; j < items.size(); ++j) {
    point.push_back(parse_fraction(as_string(items[j], where), where, meter));
    const Side& side = box.sides[j];
    if (less(point[j], side.low, meter) || (side.high && less(*side.high, point[j], meter))) {
      throw Refused(where + ": the point does not lie in the box");
    }
  }
  return point;
}

bool on_excluded_face(const std::vector<Fraction>& point, const Box& box) {
  const auto same = [](const Fraction& a, const Fraction& b) {
    return a.numerator == b.numerator && a.denominator == b.denominator;
  };
  for (std::size_t j = 0; j < point.size(); ++j) {
    const Side& side = box.sides[j];
    if (side.zero_low && same(point[j], side.low)) return true;
    if (side.zero_high && same(point[j], *side.high)) return true;
  }
  return false;
}

std::optional<std::size_t> only_variable(const Polynomial& p) {
  const Monomial top = degrees(p);
  std::optional<std::size_t> found;
  for (std::size_t j = 0; j < top.size(); ++j) {
    if (top[j] == 0) continue;
    if (found) return std::nullopt;
    found = j;
  }
  return found;
}

Dense dense_in(const Polynomial& p, std::size_t variable) {
  Dense result(p.empty() ? 0 : static_cast<std::size_t>(degrees(p)[variable]) + 1);
  for (const auto& [monomial, coefficient] : p) result[static_cast<std::size_t>(monomial[variable])] = coefficient;
  return result;
}

int zeros_between(const Dense& p, const Fraction& low, const std::optional<Fraction>& high, Meter& meter) {
  Dense rest = p;
  remove_zero(rest, low, meter);
  if (high) remove_zero(rest, *high, meter);
  return count(SturmChain(rest, meter), low, high, meter);
}

void require_positive(const Polynomial& p, const Box& box, bool strict, const std::string& method,
                      const std::string& tree, const std::string& where, Meter& meter) {
  if (method != "sturm" && method != "vertices" && method != "bernstein") {
    throw Malformed(where + ": the method must be \"sturm\", \"vertices\" or \"bernstein\"");
  }
  if (method != "bernstein" && !tree.empty()) throw Malformed(where + ": this method has no tree");
  if (method == "sturm") {
    const auto variable = only_variable(p);
    if (!variable) throw Refused(where + ": Sturm's theorem needs exactly one variable");
    return require_by_sturm(dense_in(p, *variable), box.sides[*variable], strict, where, meter);
  }
  const Monomial top = degrees(p);
  if (method == "vertices" && std::any_of(top.begin(), top.end(), [](int d) { return d > 1; })) {
    throw Refused(where + ": the polynomial is not multi-affine");
  }
  static const std::string whole = ".";
  Walk(box, strict, method == "vertices" ? whole : tree, where, meter).run(form_of(p, box, meter));
}

Integer scaled_value(const Polynomial& p, const std::vector<Fraction>& point, Meter& meter) {
  const Monomial top = degrees(p);
  Integer sum = 0;
  for (const auto& [monomial, coefficient] : p) {
    Integer term = coefficient;
    for (std::size_t j = 0; j < point.size(); ++j) {
      term = meter.multiply(term, meter.power(point[j].numerator, static_cast<std::uint64_t>(monomial[j])));
      term = meter.multiply(term, meter.power(point[j].denominator, static_cast<std::uint64_t>(top[j] - monomial[j])));
    }
    add(sum, term, meter);
  }
  return sum;
}

bool value_is(const Polynomial& p, const std::vector<Fraction>& point, const Fraction& value, Meter& meter) {
  const Monomial top = degrees(p);
  Integer scale = value.numerator;
  for (std::size_t j = 0; j < point.size(); ++j) {
    scale = meter.multiply(scale, meter.power(point[j].denominator, static_cast<std::uint64_t>(top[j])));
  }
  return meter.multiply(scaled_value(p, point, meter), value.denominator) == scale;
}

std::string text_of(const Fraction& value) {
  if (words(value.numerator) + words(value.denominator) > 8) return "...";
  return value.denominator == 1 ? value.numerator.str() : value.numerator.str() + "/" + value.denominator.str();
}

std::string text_of(const Box& box) {
  std::string text;
  for (std::size_t j = 0; j < box.names.size(); ++j) {
    const Side& side = box.sides[j];
    if (!text.empty()) text += ", ";
    if (side.high)
      text += text_of(side.low) + (side.zero_low ? " < " : " <= ") + box.names[j] + (side.zero_high ? " < " : " <= ") +
              text_of(*side.high);
    else
      text += box.names[j] + (side.zero_low ? " > " : " >= ") + text_of(side.low);
  }
  return text;
}

}  // namespace twoscale::check
