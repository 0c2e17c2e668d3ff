// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Claims about 2-point Hermite rules: which function a step evaluates, whether the two
// halves of an edge continue it, and what follows for the limit.
#include "twoscale/check/claims.hpp"

#include <algorithm>
#include <limits>

namespace twoscale::check {
namespace {

constexpr std::size_t most_derivatives = 4;
constexpr long most_degree = 64;
constexpr std::uint64_t most_points = 200'000;
constexpr int no_limit = std::numeric_limits<int>::max();  // of the exponents that are kept

enum RuleVariable : std::size_t { s_0, s_1, w, z };
enum RateVariable : std::size_t { d, s, tension };

Monomial unit(std::size_t variable, int exponent = 1) {
  Monomial m{};
  m[variable] = exponent;
  return m;
}

Polynomial constant(const Integer& value) {
  Polynomial p;
  if (value != 0) p.emplace(Monomial{}, value);
  return p;
}

Polynomial variable(std::size_t index) { return {{unit(index), Integer(1)}}; }

Polynomial sum(const Polynomial& a, const Polynomial& b, const Integer& factor, Meter& meter) {
  Polynomial result = a;
  add_scaled(result, b, factor, Monomial{}, meter);
  return result;
}

/// a*b without the terms whose exponent of the first variable is `below` or more.
Polynomial product(const Polynomial& a, const Polynomial& b, Meter& meter, int below) {
  Polynomial result;
  meter.spend(a.size() * b.size());
  for (const auto& [m, c] : a) {
    for (const auto& [n, e] : b) {
      if (m[0] + n[0] >= below) continue;
      Monomial key = m;
      for (std::size_t i = 0; i < key.size(); ++i) key[i] += n[i];
      add_term(result, key, meter.multiply(c, e), meter);
    }
  }
  return result;
}

Polynomial power(const Polynomial& a, int exponent, Meter& meter, int below = no_limit) {
  Polynomial result = constant(1);
  for (int i = 0; i < exponent; ++i) result = product(result, a, meter, below);
  return result;
}

bool depends_on(const Polynomial& p, std::size_t index) { return degrees(p)[index] > 0; }

Ratio read_ratio(const Value& value, std::span<const std::string> names, const std::string& where, Meter& meter) {
  Fields fields(value, where);
  Ratio r;
  r.numerator = parse_polynomial(fields.take_string("numerator"), names, fields.path("numerator"), meter);
  r.denominator = parse_polynomial(fields.take_string("denominator"), names, fields.path("denominator"), meter);
  fields.done();
  if (r.denominator.empty()) throw Malformed(where + ".denominator: 0");
  return r;
}

// ---- Univariate polynomials in x

Dense read_dense(Fields& fields, std::string_view key, Meter& meter) {
  static const std::array<std::string, 1> names{"x"};
  const Polynomial p = parse_polynomial(fields.take_string(key), names, fields.path(key), meter);
  if (p.empty()) throw Malformed(fields.path(key) + ": 0");
  Dense result = dense(p);
  if (result.size() > static_cast<std::size_t>(most_degree) + 1) {
    throw Malformed(fields.path(key) + ": a degree of more than 64");
  }
  return result;
}

Dense derivative(const Dense& p) {
  Dense r;
  for (std::size_t i = 1; i < p.size(); ++i) r.push_back(p[i] * static_cast<long>(i));
  return r;
}

Dense times(const Dense& p, const Dense& q, Meter& meter) {
  if (p.empty() || q.empty()) return {};
  return multiply(p, q, meter);
}

Dense minus(Dense p, const Dense& q, long factor) {
  if (p.size() < q.size()) p.resize(q.size());
  for (std::size_t i = 0; i < q.size(); ++i) p[i] -= q[i] * factor;
  while (!p.empty() && p.back() == 0) p.pop_back();
  return p;
}

/// Numerators over base^{power + order} of the derivatives of order 0, 1, .. of top/base^power.
std::vector<Dense> jet(Dense top, const Dense& base, int power, std::size_t order, Meter& meter) {
  const Dense slope = derivative(base);
  std::vector<Dense> list;
  for (std::size_t i = 0; i <= order; ++i) {
    Dense over = top;
    for (std::size_t k = i; k < order; ++k) over = times(over, base, meter);
    list.push_back(over);
    top = minus(times(derivative(top), base, meter), times(top, slope, meter), power + static_cast<long>(i));
  }
  return list;
}

/// q^n p(numerator/q) at numbers.
Integer homogeneous(const Dense& p, std::size_t n, const Integer& numerator, const Integer& q, Meter& meter) {
  Integer result = 0, scale = 1;
  for (std::size_t i = n + 1; i-- > 0;) {
    result = meter.multiply(result, numerator);
    if (i < p.size()) result += meter.multiply(p[i], scale);
    scale = meter.multiply(scale, q);
  }
  return result;
}

// ---- Values at integer points

Integer value_at(const Polynomial& p, const std::vector<std::vector<Integer>>& powers, Meter& meter) {
  Integer result = 0;
  for (const auto& [m, c] : p) {
    Integer term = c;
    for (std::size_t i = 0; i < powers.size(); ++i) {
      if (m[i] != 0) term = meter.multiply(term, powers[i][static_cast<std::size_t>(m[i])]);
    }
    result += term;
  }
  meter.spend(20 * p.size());
  return result;
}

/// Runs over all points of a grid with bound[i] + 1 values of the variable i; `at` gets the powers of its coordinates.
template <typename At>
void over_grid(const std::vector<long>& bound, const std::vector<long>& top, Meter& meter, const At& at) {
  std::uint64_t points = 1;
  for (const long b : bound) {
    points *= static_cast<std::uint64_t>(b) + 1;
    if (points > most_points) throw Malformed("hermite: the degrees of the rules are too large");
  }
  std::vector<long> place(bound.size());
  std::vector<std::vector<Integer>> powers(bound.size());
  const auto set = [&](std::size_t i) {
    // 0, 1, -1, 2, -2, ...
    const Integer x = place[i] % 2 == 1 ? (place[i] + 1) / 2 : -place[i] / 2;
    powers[i].assign(1, Integer(1));
    for (long e = 0; e < top[i]; ++e) powers[i].push_back(meter.multiply(powers[i].back(), x));
  };
  for (std::size_t i = 0; i < bound.size(); ++i) set(i);
  while (true) {
    at(powers);
    std::size_t i = 0;
    while (i < bound.size() && place[i] == bound[i]) {
      place[i] = 0;
      set(i++);
    }
    if (i == bound.size()) return;
    ++place[i];
    set(i);
  }
}

long top_degree(std::initializer_list<const Polynomial*> list, std::size_t variable) {
  long top = 0;
  for (const Polynomial* p : list) top = std::max<long>(top, degrees(*p)[variable]);
  return top;
}

long top_degree(const Ratio& r, std::size_t v) { return top_degree({&r.numerator, &r.denominator}, v); }

// ---- Compositions

/// p with ratios in place of its variables, without cancelling; terms with d^below are left out.
Ratio composed(const Ratio& f, const std::array<const Ratio*, 4>& by, Meter& meter, int below = no_limit) {
  Monomial top = degrees(f.numerator);
  const Monomial other = degrees(f.denominator);
  for (std::size_t i = 0; i < 4; ++i) top[i] = std::max(top[i], other[i]);
  const auto one = [&](const Polynomial& p) {
    Polynomial result;
    for (const auto& [m, c] : p) {
      Polynomial term = constant(c);
      for (std::size_t i = 0; i < 4; ++i) {
        if (top[i] == 0) continue;
        term = product(term, power(by[i]->numerator, m[i], meter, below), meter, below);
        term = product(term, power(by[i]->denominator, top[i] - m[i], meter, below), meter, below);
      }
      result = sum(result, term, 1, meter);
    }
    return result;
  };
  return {one(f.numerator), one(f.denominator)};
}

Ratio difference(const Ratio& a, const Ratio& b, Meter& meter, int below = no_limit) {
  return {sum(product(a.numerator, b.denominator, meter, below), product(b.numerator, a.denominator, meter, below), -1,
              meter),
          product(a.denominator, b.denominator, meter, below)};
}

Ratio ratio(Polynomial p) { return {std::move(p), constant(1)}; }

/// The smallest exponent of d; p is not 0.
int lowest_in_d(const Polynomial& p) {
  int least = no_limit;
  for (const auto& [m, c] : p) least = std::min(least, m[d]);
  return least;
}

bool same(const Ratio& a, const Ratio& b, Meter& meter) { return difference(a, b, meter).numerator.empty(); }

/// factor*(a + sign*b)*scale, over the variables of the rates.
Ratio combination(const Fraction& factor, const Ratio& a, int sign, const Ratio& b, const Ratio& scale, Meter& meter) {
  Ratio r{sum(product(a.numerator, b.denominator, meter), product(b.numerator, a.denominator, meter), sign, meter),
          product(a.denominator, b.denominator, meter)};
  r.numerator = product(product(r.numerator, scale.numerator, meter), constant(factor.numerator), meter);
  r.denominator = product(product(r.denominator, scale.denominator, meter), constant(factor.denominator), meter);
  return r;
}

/// Later levels repeat a step only if old vertices stay.
void require_kept(const HermiteContext& context) {
  if (!context.rules.kept) throw Refused("old vertices do not stay");
}

const HermiteFacts::Interpolant& require_interpolant(const HermiteContext& context) {
  if (!context.facts.interpolant) throw Refused("a claim interpolant, verified, must come before");
  return *context.facts.interpolant;
}

/// The scale in the variables of the rates. Required: it depends on w only.
Ratio scale_in_rates(const HermiteFacts::Interpolant& f, Meter& meter) {
  const Ratio zero = ratio({}), t = ratio(variable(tension));
  return composed(f.scale, {&zero, &zero, &t, &zero}, meter);
}

/// The second derivative of B = 10 y^3 - 15 y^4 + 6 y^5, which is 0 with two derivatives at y = 0, and 1, 0, 0 at y
/// = 1.
const Dense& bump() {
  static const Dense second = [] {
    const Dense b{0, 0, 0, 10, -15, 6};
    return derivative(derivative(b));
  }();
  return second;
}

/// The sum of B''(2^{-n}), n >= 0: geometric series, term by term.
Fraction series_of_bump(Meter& meter) {
  Fraction total;
  for (std::size_t k = 1; k < bump().size(); ++k) {
    const Integer power = Integer(1) << k;
    // c/(1 - 2^{-k}) = c 2^k/(2^k - 1)
    total = reduced(total.numerator * (power - 1) + bump()[k] * power * total.denominator,
                    total.denominator * (power - 1), meter);
  }
  return total;
}

// ---- Values at rational points

Fraction plus(const Fraction& a, const Fraction& b, Meter& meter) {
  return reduced(meter.multiply(a.numerator, b.denominator) + meter.multiply(b.numerator, a.denominator),
                 meter.multiply(a.denominator, b.denominator), meter);
}

Fraction times(const Fraction& a, const Fraction& b, Meter& meter) {
  return reduced(meter.multiply(a.numerator, b.numerator), meter.multiply(a.denominator, b.denominator), meter);
}

Fraction over(const Fraction& a, const Fraction& b, Meter& meter) {
  if (b.numerator == 0) throw Refused("a denominator vanishes at the point");
  Integer top = meter.multiply(a.numerator, b.denominator), bottom = meter.multiply(a.denominator, b.numerator);
  if (bottom < 0) top = -top, bottom = -bottom;
  return reduced(std::move(top), std::move(bottom), meter);
}

using RulePoint = std::array<Fraction, 4>;  // s_0, s_1, w, z

Fraction value_at(const Polynomial& p, const RulePoint& at, Meter& meter) {
  Fraction total;
  for (const auto& [m, c] : p) {
    Fraction term{c, 1};
    for (std::size_t i = 0; i < at.size(); ++i) {
      const auto e = static_cast<std::uint64_t>(m[i]);
      if (e > 0) term = times(term, {meter.power(at[i].numerator, e), meter.power(at[i].denominator, e)}, meter);
    }
    total = plus(total, term, meter);
  }
  return total;
}

Fraction value_at(const Ratio& r, const RulePoint& at, Meter& meter) {
  return over(value_at(r.numerator, at, meter), value_at(r.denominator, at, meter), meter);
}

Fraction value_at(const Dense& p, const Fraction& x, Meter& meter) {
  Fraction total;
  for (std::size_t i = p.size(); i-- > 0;) total = plus(times(total, x, meter), {p[i], 1}, meter);
  return total;
}

/// `at`: s_0, s_1, w; z follows.
RulePoint read_point(Fields& witness, const HermiteRules& rules, Meter& meter) {
  const std::vector<Value>& list = witness.take_array("at");
  if (list.size() != 3) throw Malformed(witness.path("at") + ": values of s_0, s_1 and w are expected");
  RulePoint at;
  for (std::size_t i = 0; i < 3; ++i)
    at[i] = parse_fraction(as_string(list[i], witness.path("at")), witness.path("at"), meter);
  at[z] = value_at(rules.end, at, meter);
  return at;
}

Fraction negative(Fraction x) {
  x.numerator = -x.numerator;
  return x;
}

std::string text_of(const RulePoint& at) {
  std::string text;
  for (const std::size_t i : {std::size_t{s_0}, std::size_t{s_1}, std::size_t{w}}) {
    text += (text.empty() ? "at " : ", ") + rule_names[i] + " = " + at[i].numerator.str();
    if (at[i].denominator != 1) text += "/" + at[i].denominator.str();
  }
  return shortened(text);
}

/// The same step on the reversed polygon: s -> -s, the ends exchanged.
RulePoint reversed(const RulePoint& at, const HermiteRules& rules, Meter& meter) {
  RulePoint r{negative(at[s_1]), negative(at[s_0]), at[w], Fraction{}};
  r[z] = value_at(rules.end, r, meter);
  return r;
}

/// Row h and column (i, e) of the rule and of its mirror image have the same sign if h + i is even.
bool is_odd(std::size_t row, std::size_t column) { return (row + column / 2) % 2 == 1; }

std::size_t mirror_column(std::size_t column) { return column ^ 1U; }

bool equal(const Fraction& a, const Fraction& b, Meter& meter) { return compare(a, b, meter) == 0; }

/// The coefficient of d^exponent, in s and w; lower exponents must not occur.
Polynomial coefficient_in_d(const Polynomial& p, int exponent) {
  Polynomial result;
  for (const auto& [m, c] : p) {
    if (m[d] < exponent) throw Refused("the rule has no limit for small steps");
    if (m[d] > exponent) continue;
    Monomial rest = m;
    rest[d] = 0;
    result.emplace(rest, c);
  }
  return result;
}

/// B''(p/q).
Fraction bump_at(long p, long q, Meter& meter) {
  return reduced(homogeneous(bump(), bump().size() - 1, p, q, meter), meter.power(q, bump().size() - 1), meter);
}

}  // namespace

HermiteRules read_hermite(const Value& value, Meter& meter) {
  Fields fields(value, "hermite");
  HermiteRules rules;
  rules.order = static_cast<std::size_t>(fields.take_integer("order", 1, most_derivatives));
  rules.end = read_ratio(fields.take("end"), rule_names, "hermite.end", meter);
  if (depends_on(rules.end.numerator, z) || depends_on(rules.end.denominator, z)) {
    throw Malformed("hermite.end: s_0, s_1 and w are expected");
  }
  const std::vector<Value>& rows = fields.take_array("rule");
  if (rows.size() != rules.order + 1) throw Malformed("hermite.rule: a row for each derivative is expected");
  for (std::size_t h = 0; h < rows.size(); ++h) {
    const std::string where = "hermite.rule[" + std::to_string(h) + "]";
    Fields row(rows[h], where);
    HermiteRules::Row r;
    const std::vector<Value>& numerators = row.take_array("numerators");
    if (numerators.size() != 2 * rows.size()) throw Malformed(where + ".numerators: two for each derivative");
    for (const Value& n : numerators) {
      r.numerators.push_back(
          parse_polynomial(as_string(n, where + ".numerators"), rule_names, where + ".numerators", meter));
    }
    r.denominator = parse_polynomial(row.take_string("denominator"), rule_names, where + ".denominator", meter);
    row.done();
    if (r.denominator.empty()) throw Malformed(where + ".denominator: 0");
    for (const Polynomial& p : r.numerators) {
      if (depends_on(p, s_1)) throw Malformed(where + ": s_0, w and z are expected");
    }
    if (depends_on(r.denominator, s_1)) throw Malformed(where + ": s_0, w and z are expected");
    rules.rows.push_back(std::move(r));
  }
  const std::vector<Value>& old = fields.take_array("old");
  if (old.size() != rows.size()) throw Malformed("hermite.old: a row for each derivative is expected");
  rules.kept = true;
  for (std::size_t h = 0; h < old.size(); ++h) {
    const std::string where = "hermite.old[" + std::to_string(h) + "]";
    const std::vector<Value>& row = as_array(old[h], where);
    if (row.size() != old.size()) throw Malformed(where + ": a number for each derivative is expected");
    for (std::size_t i = 0; i < row.size(); ++i) {
      const Fraction x = parse_fraction(as_string(row[i], where), where, meter);
      rules.kept = rules.kept && x.denominator == 1 && x.numerator == (h == i ? 1 : 0);
    }
  }
  fields.done();
  return rules;
}

Finding check_interpolant(const HermiteContext& context, Fields& fields, bool proved) {
  require_proved(fields, proved);
  Meter& meter = context.meter;
  HermiteFacts::Interpolant f;
  Fields nodes(fields.take("nodes"), fields.path("nodes"));
  f.left = read_ratio(nodes.take("left"), rule_names, nodes.path("left"), meter);
  f.right = read_ratio(nodes.take("right"), rule_names, nodes.path("right"), meter);
  f.middle = read_ratio(nodes.take("middle"), rule_names, nodes.path("middle"), meter);
  nodes.done();
  f.base = read_dense(fields, "base", meter);
  f.power = static_cast<int>(fields.take_integer("power", 0, 16));
  f.degree = fields.take_integer("degree", 1, most_degree);
  f.scale = read_ratio(fields.take("scale"), rule_names, fields.path("scale"), meter);
  const HermiteRules& rules = context.rules;
  const std::size_t order = rules.order;
  if (f.degree != 2 * static_cast<long>(order) + 1) {
    throw Refused("the degree of the interpolant is not " + std::to_string(2 * order + 1));
  }
  for (const Ratio* r : {&f.left, &f.right, &f.middle, &f.scale}) {
    if (depends_on(r->numerator, s_1) || depends_on(r->denominator, s_1)) {
      throw Malformed(fields.path("nodes") + ": s_0, w and z are expected");
    }
  }
  if (same(f.left, f.right, meter)) throw Refused("the two nodes are equal");
  if (f.scale.numerator.empty()) throw Refused("the scale is 0");
  for (const std::size_t v : {std::size_t{s_0}, std::size_t{z}}) {
    if (top_degree(f.scale, v) > 0) throw Refused("the scale depends on the parameters of the vertices");
  }
  // For g = x^j/base^power: sum over the columns of the rule times scale^i g^(i)(node) = scale^h g^(h)(middle). The
  // derivatives are numerators of degree n over base^{power+order}; cleared of all denominators this is an identity of
  // polynomials in s_0, w, z, true if it holds at more points in each direction than its degree.
  std::vector<std::vector<Dense>> jets;
  Dense bottom{Integer(1)};
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.power) + order; ++i) bottom = times(bottom, f.base, meter);
  std::size_t n = bottom.size() - 1;
  for (long j = 0; j <= f.degree; ++j) {
    Dense x(static_cast<std::size_t>(j) + 1);
    x.back() = 1;
    jets.push_back(jet(std::move(x), f.base, f.power, order, meter));
    for (const Dense& p : jets.back()) n = std::max(n, p.empty() ? 0 : p.size() - 1);
  }
  std::vector<long> bound(4), top(4);
  for (std::size_t v = 0; v < 4; ++v) {
    long row = 0;
    for (const auto& r : rules.rows) {
      row = std::max(row, top_degree({&r.denominator}, v));
      for (const Polynomial& p : r.numerators) row = std::max(row, top_degree({&p}, v));
    }
    long nodes_top = 0;
    for (const Ratio* r : {&f.left, &f.right, &f.middle}) {
      nodes_top += top_degree(*r, v);
      top[v] = std::max(top[v], top_degree(*r, v));
    }
    bound[v] = static_cast<long>(n) * nodes_top + row + static_cast<long>(order) * top_degree(f.scale, v);
    top[v] = std::max({top[v], row, top_degree(f.scale, v)});
  }
  bool defined = false;  // the nodes are no zeros of base, identically
  over_grid(bound, top, meter, [&](const std::vector<std::vector<Integer>>& at) {
    const auto of = [&](const Polynomial& p) { return value_at(p, at, meter); };
    struct Node {
      Integer x, q, bottom;
    };
    std::array<Node, 3> node;
    const std::array<const Ratio*, 3> places{&f.left, &f.right, &f.middle};
    for (std::size_t e = 0; e < 3; ++e) {
      node[e].x = of(places[e]->numerator);
      node[e].q = of(places[e]->denominator);
      node[e].bottom = homogeneous(bottom, n, node[e].x, node[e].q, meter);
    }
    defined = defined || std::all_of(node.begin(), node.end(), [](const Node& e) { return e.q != 0 && e.bottom != 0; });
    const Integer k = of(f.scale.numerator), l = of(f.scale.denominator);
    std::vector<Integer> scale;
    for (std::size_t i = 0; i <= order; ++i) {
      scale.push_back(meter.multiply(meter.power(k, i), meter.power(l, order - i)));
    }
    std::vector<std::vector<Integer>> rule;
    std::vector<Integer> under;
    for (const auto& row : rules.rows) {
      rule.emplace_back();
      for (const Polynomial& p : row.numerators) rule.back().push_back(of(p));
      under.push_back(of(row.denominator));
    }
    for (const auto& derivatives : jets) {
      // Data of the two ends and of the middle, without their denominators.
      std::array<std::vector<Integer>, 3> data;
      for (std::size_t e = 0; e < 3; ++e) {
        for (std::size_t i = 0; i <= order; ++i) {
          data[e].push_back(meter.multiply(scale[i], homogeneous(derivatives[i], n, node[e].x, node[e].q, meter)));
        }
      }
      for (std::size_t h = 0; h <= order; ++h) {
        std::array<Integer, 2> half;
        for (std::size_t e = 0; e < 2; ++e) {
          for (std::size_t i = 0; i <= order; ++i) half[e] += meter.multiply(rule[h][2 * i + e], data[e][i]);
        }
        const Integer both = meter.multiply(half[0], node[1].bottom) + meter.multiply(half[1], node[0].bottom);
        const Integer right =
            meter.multiply(meter.multiply(under[h], data[2][h]), meter.multiply(node[0].bottom, node[1].bottom));
        if (meter.multiply(both, node[2].bottom) != right) {
          throw Refused("row " + std::to_string(h) + " of the rule does not reproduce the functions x^j/base^power");
        }
      }
    }
  });
  if (!defined) throw Refused("base vanishes at a node");
  context.facts.interpolant = std::move(f);
  return {"(a step is the value with derivatives, at the middle node, of the function x^j/base^power, j <= " +
              std::to_string(2 * order + 1) + ", through the data of its ends)",
          "the rule reproduces these functions, identically in s_0, w, z",
          {"hermite-interpolation"}};
}

namespace {

/// x^2 + y^2 of the new point, from data of the circle (cosine, sine)/base^power at the two ends.
Fraction square_of_new_point(const HermiteContext& context, const std::array<const Dense*, 2>& circle,
                             const RulePoint& at) {
  Meter& meter = context.meter;
  const HermiteRules& rules = context.rules;
  const auto& f = *context.facts.interpolant;
  for (const Polynomial* p : {&f.left.numerator, &f.left.denominator}) {
    if (depends_on(*p, z)) throw Refused("the node of a vertex depends on its neighbour");
  }
  const Fraction scale = value_at(f.scale, at, meter);
  std::array<Fraction, 2> node;
  for (std::size_t e = 0; e < 2; ++e) {
    RulePoint own = at;
    own[s_0] = at[e == 0 ? s_0 : s_1];
    node[e] = value_at(f.left, own, meter);
  }
  const Fraction bottom = value_at(rules.rows[0].denominator, at, meter);
  Fraction square;
  for (const Dense* component : circle) {
    const std::vector<Dense> derivatives = jet(*component, f.base, f.power, rules.order, meter);
    Fraction sum;
    for (std::size_t e = 0; e < 2; ++e) {
      const Fraction base = value_at(f.base, node[e], meter);
      Fraction factor{1, 1};
      for (std::size_t i = 0; i < static_cast<std::size_t>(f.power) + rules.order; ++i)
        factor = over(factor, base, meter);
      for (std::size_t i = 0; i <= rules.order; ++i) {
        const Fraction datum = times(factor, value_at(derivatives[i], node[e], meter), meter);
        sum = plus(sum, times(value_at(rules.rows[0].numerators[2 * i + e], at, meter), datum, meter), meter);
        factor = times(factor, scale, meter);
      }
    }
    sum = over(sum, bottom, meter);
    square = plus(square, times(sum, sum, meter), meter);
  }
  return square;
}

}  // namespace

Finding check_circle(const HermiteContext& context, Fields& fields, bool proved) {
  Meter& meter = context.meter;
  const auto& f = require_interpolant(context);
  const Dense c = read_dense(fields, "cosine", meter), t = read_dense(fields, "sine", meter);
  Dense square = times(c, c, meter);
  square = minus(std::move(square), times(t, t, meter), -1);
  Dense radius{Integer(1)};
  for (int i = 0; i < 2 * f.power; ++i) radius = times(radius, f.base, meter);
  if (minus(square, radius, 1) != Dense{}) throw Refused("cosine^2 + sine^2 is not base^(2 power)");
  if (times(derivative(t), c, meter) == times(derivative(c), t, meter)) throw Refused("no arc: the angle is constant");
  const std::string subject =
      "(data of the circle (cosine, sine)/base^power, multiplied by the scale, are refined to points of this circle)";
  if (!proved) {
    Fields witness(fields.take("witness"), fields.path("witness"));
    const RulePoint at = read_point(witness, context.rules, meter);
    const Fraction claimed = parse_fraction(witness.take_string("square"), witness.path("square"), meter);
    witness.done();
    if (at[w].numerator <= 0) throw Refused("w is not positive");
    if (equal(at[s_0], at[s_1], meter)) throw Refused("the two vertices are equal");
    if (!equal(square_of_new_point(context, {&c, &t}, at), claimed, meter)) {
      throw Refused("x^2 + y^2 of the new point is another number");
    }
    if (equal(claimed, {1, 1}, meter)) throw Refused("the new point lies on the circle");
    return {subject, "one step leaves the circle " + text_of(at), {"hermite-interpolation"}};
  }
  if (static_cast<long>(std::max(c.size(), t.size())) - 1 > f.degree) throw Refused("the degrees are too large");
  // The node of a vertex is the same for its two edges: else its data would be others for each.
  if (!context.facts.rates || !context.facts.fit) throw Refused("a claim halves, verified, that fit, must come before");
  return {subject, "cosine^2 + sine^2 = base^(2 power), within the degree", {"hermite-interpolation"}};
}

Finding check_hermite_interpolatory(const HermiteContext& context, Fields& fields, bool proved) {
  require_proved(fields, proved);
  require_kept(context);
  return {"(old vertices stay, with their derivatives)", "their matrix is the identity", {"definition"}};
}

Finding check_reversal(const HermiteContext& context, Fields& fields, bool proved) {
  Meter& meter = context.meter;
  const HermiteRules& rules = context.rules;
  const std::string subject =
      "(the reversed polygon has the reversed refinement: s -> -s, ends exchanged, odd derivatives negated)";
  require_kept(context);
  const std::size_t columns = 2 * rules.rows.size();
  if (!proved) {
    Fields witness(fields.take("witness"), fields.path("witness"));
    const RulePoint at = read_point(witness, rules, meter);
    const auto row = static_cast<std::size_t>(witness.take_integer("row", 0, static_cast<long>(rules.order)));
    const auto column = static_cast<std::size_t>(witness.take_integer("column", 0, static_cast<long>(columns) - 1));
    const Fraction value = parse_fraction(witness.take_string("value"), witness.path("value"), meter);
    const Fraction mirror = parse_fraction(witness.take_string("mirror"), witness.path("mirror"), meter);
    witness.done();
    if (at[w].numerator <= 0) throw Refused("w is not positive");
    const auto entry = [&](const RulePoint& point, std::size_t of) {
      return over(value_at(rules.rows[row].numerators[of], point, meter),
                  value_at(rules.rows[row].denominator, point, meter), meter);
    };
    Fraction other = entry(reversed(at, rules, meter), mirror_column(column));
    if (is_odd(row, column)) other = negative(other);
    if (!equal(entry(at, column), value, meter)) throw Refused("the entry has another value");
    if (!equal(other, mirror, meter)) throw Refused("the entry of the mirror image has another value");
    if (equal(value, mirror, meter)) throw Refused("the two values are equal");
    return {subject, "one entry differs from that of the mirror image " + text_of(at), {"definition"}};
  }
  // numerator*denominator of the mirror image = +- the converse, with z = n/q put in and q^top cleared: an identity of
  // polynomials in s_0, s_1, w.
  long in_s = 0, in_w = 0, in_z = 0;
  for (const auto& r : rules.rows) {
    std::vector<const Polynomial*> all{&r.denominator};
    for (const Polynomial& p : r.numerators) all.push_back(&p);
    for (const Polynomial* p : all) {
      in_s = std::max(in_s, top_degree({p}, s_0));
      in_w = std::max(in_w, top_degree({p}, w));
      in_z = std::max(in_z, top_degree({p}, z));
    }
  }
  const long end_0 = top_degree(rules.end, s_0), end_1 = top_degree(rules.end, s_1), end_w = top_degree(rules.end, w);
  const long both = in_s + in_z * (end_0 + end_1);
  const std::vector<long> bound{both, both, 2 * (in_w + in_z * end_w)};
  const std::vector<long> top{std::max({in_s, end_0, end_1}), std::max({in_s, end_0, end_1}), std::max(in_w, end_w)};
  std::vector<bool> defined(rules.rows.size());
  over_grid(bound, top, meter, [&](const std::vector<std::vector<Integer>>& at) {
    using Powers = std::vector<std::vector<Integer>>;
    const auto negated = [](std::vector<Integer> powers) {
      for (std::size_t i = 1; i < powers.size(); i += 2) powers[i] = -powers[i];
      return powers;
    };
    // Powers of s_0, s_1, w, and n^k q^(top - k).
    const auto completed = [&](Powers powers) {
      const Integer n = value_at(rules.end.numerator, powers, meter);
      const Integer q = value_at(rules.end.denominator, powers, meter);
      powers.emplace_back();
      for (long k = 0; k <= in_z; ++k) {
        powers.back().push_back(meter.multiply(meter.power(n, static_cast<std::uint64_t>(k)),
                                               meter.power(q, static_cast<std::uint64_t>(in_z - k))));
      }
      return powers;
    };
    const Powers here = completed(at), there = completed({negated(at[1]), negated(at[0]), at[2]});
    const auto of = [&](const Polynomial& p, const Powers& powers) {
      Integer result = 0;
      for (const auto& [m, c] : p) {
        Integer term = meter.multiply(c, powers[z][static_cast<std::size_t>(m[z])]);
        for (const std::size_t i : {std::size_t{s_0}, std::size_t{w}}) {
          if (m[i] != 0) term = meter.multiply(term, powers[i][static_cast<std::size_t>(m[i])]);
        }
        result += term;
      }
      meter.spend(20 * p.size());
      return result;
    };
    for (std::size_t h = 0; h < rules.rows.size(); ++h) {
      const auto& r = rules.rows[h];
      const Integer under = of(r.denominator, here), under_mirror = of(r.denominator, there);
      defined[h] = defined[h] || (under != 0 && under_mirror != 0);
      std::vector<Integer> tops, mirrors;
      for (const Polynomial& p : r.numerators) {
        tops.push_back(of(p, here));
        mirrors.push_back(of(p, there));
      }
      for (std::size_t column = 0; column < columns; ++column) {
        Integer other = meter.multiply(mirrors[mirror_column(column)], under);
        if (is_odd(h, column)) other = -other;
        if (meter.multiply(tops[column], under_mirror) != other) {
          throw Refused("row " + std::to_string(h) + ", column " + std::to_string(column) +
                        " of the rule is not that of its mirror image");
        }
      }
    }
  });
  if (std::find(defined.begin(), defined.end(), false) != defined.end()) throw Refused("a row of the rule is a pole");
  return {subject, "the rule equals its mirror image, identically in s_0, s_1, w", {"definition"}};
}

Finding check_spectral(const HermiteContext& context, Fields& fields, bool proved) {
  require_proved(fields, proved);
  Meter& meter = context.meter;
  const HermiteRules& rules = context.rules;
  const long order = fields.take_integer("order", 0, most_degree);
  std::vector<Ratio> scales{ratio(constant(1))};
  const std::vector<Value>& list = fields.take_array("scales");
  if (list.size() != rules.order) throw Malformed(fields.path("scales") + ": one for each derivative is expected");
  for (const Value& value : list) {
    scales.push_back(read_ratio(value, rate_names, fields.path("scales"), meter));
    for (const Polynomial* p : {&scales.back().numerator, &scales.back().denominator}) {
      if (depends_on(*p, d)) throw Malformed(fields.path("scales") + ": s and w are expected");
    }
    if (scales.back().numerator.empty()) throw Refused("a scale is 0");
  }
  require_kept(context);
  // s_0 = s, s_1 = s + d; row h, column (i, e) behaves like d^(i-h) times the rule on intervals of length 1.
  const Ratio first = ratio(variable(s)), last = ratio(sum(variable(s), variable(d), 1, meter));
  const Ratio factor = ratio(variable(tension));
  const Ratio end = composed(rules.end, {&first, &last, &factor, &first}, meter);
  if (end.denominator.empty()) throw Refused("the rule has no limit for small steps");
  for (std::size_t h = 0; h <= rules.order; ++h) {
    const auto& row = rules.rows[h];
    std::vector<Ratio> limit;
    for (std::size_t column = 0; column < row.numerators.size(); ++column) {
      const Ratio entry = composed({row.numerators[column], row.denominator}, {&first, &last, &factor, &end}, meter);
      if (entry.denominator.empty()) throw Refused("the rule has no limit for small steps");
      const int least = lowest_in_d(entry.denominator);
      limit.push_back({coefficient_in_d(entry.numerator, least + static_cast<int>(column / 2) - static_cast<int>(h)),
                       coefficient_in_d(entry.denominator, least)});
    }
    for (long n = 0; n <= order; ++n) {
      // n! 2^n times: the value and derivatives c_i x^(n-i)/(n-i)! at 0 and 1 give those at 1/2.
      const auto falling = [&](std::size_t k) {
        Integer r = 1;
        for (std::size_t i = 0; i < k; ++i) r *= n - static_cast<long>(i);
        return r;
      };
      Ratio error = ratio({});
      const auto add = [&](const Ratio& x, const Integer& by) {
        error = {sum(product(error.numerator, x.denominator, meter, no_limit),
                     product(x.numerator, error.denominator, meter, no_limit), by, meter),
                 product(error.denominator, x.denominator, meter, no_limit)};
      };
      if (static_cast<long>(h) <= n) add(scales[h], -(falling(h) << h));
      for (std::size_t column = 0; column < row.numerators.size(); ++column) {
        const std::size_t i = column / 2;
        if (static_cast<long>(i) > n || (column % 2 == 0 && static_cast<long>(i) < n)) continue;
        const Ratio& entry = limit[column];
        add({product(entry.numerator, scales[i].numerator, meter, no_limit),
             product(entry.denominator, scales[i].denominator, meter, no_limit)},
            falling(i) << static_cast<unsigned>(n));
      }
      if (!error.numerator.empty()) {
        throw Refused("x^" + std::to_string(n) + " is not reproduced by row " + std::to_string(h));
      }
    }
  }
  return {"(for small steps polynomials of degree <= " + std::to_string(order) +
              " are reproduced, with derivatives in the scales: the spectral condition)",
          "identities verified in the limit d -> 0",
          {"definition"}};
}

Finding check_halves(const HermiteContext& context, Fields& fields, bool proved) {
  require_proved(fields, proved);
  Meter& meter = context.meter;
  const auto& f = require_interpolant(context);
  require_kept(context);
  const std::string& fit = fields.take_string("fit");
  if (fit != "yes" && fit != "no") throw Malformed(fields.path("fit") + ": \"yes\" or \"no\" is expected");
  const Ratio left_rate = read_ratio(fields.take("left_rate"), rate_names, fields.path("left_rate"), meter);
  const Ratio right_rate = read_ratio(fields.take("right_rate"), rate_names, fields.path("right_rate"), meter);
  for (const Ratio* r : {&left_rate, &right_rate}) {
    if (depends_on(r->numerator, d) || depends_on(r->denominator, d)) {
      throw Malformed(fields.path("left_rate") + ": s and w are expected");
    }
  }
  const int below = fit == "yes" ? no_limit : 3;
  // s_0 = s, the middle m = s + d, and s_1 by (s_0 + s_1)(1 - m^2) = 2 m (1 - s_0 s_1).
  const Polynomial start = variable(s), m = sum(variable(s), variable(d), 1, meter);
  const Polynomial rest = sum(constant(1), product(m, m, meter), -1, meter);  // 1 - m^2
  const Polynomial twice = product(constant(2), m, meter);
  const Ratio first = ratio(start), middle = ratio(m), factor = ratio(variable(tension));
  const Ratio last{sum(twice, product(start, rest, meter), -1, meter),
                   sum(rest, product(twice, start, meter), 1, meter)};
  const auto node = [&](const Ratio& of, const Ratio& from, const Ratio& to) {
    const Ratio end = composed(context.rules.end, {&from, &to, &factor, &from}, meter, below);
    return composed(of, {&from, &from, &factor, &end}, meter, below);
  };
  const Ratio x = node(f.left, first, last), y = node(f.right, first, last), h = node(f.middle, first, last);
  const Ratio left_end = node(f.right, first, middle), right_start = node(f.left, middle, last);
  const Ratio left_start = node(f.left, first, middle), right_end = node(f.right, middle, last);
  const auto zero = [&](const Ratio& a, const Ratio& b) {
    const Ratio gap = difference(a, b, meter, below);
    if (gap.denominator.empty()) throw Refused("a node is not defined");
    return gap.numerator.empty();
  };
  if (fit == "yes") {
    if (!zero(left_start, x) || !zero(left_end, h) || !zero(right_start, h) || !zero(right_end, y)) {
      throw Refused("the intervals of the two halves are not the halves of the interval");
    }
    if (!left_rate.numerator.empty() || !right_rate.numerator.empty()) throw Refused("the rates are not 0");
    context.facts.fit = true;
    context.facts.rates = {left_rate, right_rate};
    return {"(the intervals of the two halves of an edge are the halves of its interval)",
            "identities verified",
            {"definition"}};
  }
  if (static_cast<long>(f.base.size() - 1) * f.power + 1 > f.degree) {
    throw Refused("1 and x are not among the functions of the interpolant");
  }
  const auto check = [&](const Ratio& from, const Ratio& to, const Ratio& low, const Ratio& high, const Ratio& rate,
                         const char* side) {
    const Ratio own = difference(to, from, meter, below), half = difference(high, low, meter, below);
    const Ratio error = difference(own, half, meter, below);
    for (const Ratio* r : {&own, &half, &error}) {
      if (r->denominator.empty() || lowest_in_d(r->denominator) != 0) throw Refused("a pole for small steps");
    }
    if (half.numerator.empty() || lowest_in_d(half.numerator) != 1) throw Refused("no interval for small steps");
    // error = rate half^2 up to d^3.
    const Polynomial a =
        product(product(product(error.numerator, half.denominator, meter, below), half.denominator, meter, below),
                rate.denominator, meter, below);
    const Polynomial b =
        product(product(product(half.numerator, half.numerator, meter, below), error.denominator, meter, below),
                rate.numerator, meter, below);
    if (!sum(a, b, -1, meter).empty()) throw Refused(std::string("the rate of the ") + side + " half is another one");
  };
  check(left_start, left_end, x, h, left_rate, "left");
  check(right_start, right_end, h, y, right_rate, "right");
  if (left_rate.numerator.empty() && right_rate.numerator.empty()) throw Refused("both rates are 0");
  context.facts.fit = false;
  context.facts.rates = {left_rate, right_rate};
  return {
      "(the interval of a half has the length l (1 + e l + ..), l that of the half of the interval, with the rates e)",
      "expansion to the second order verified",
      {"definition"}};
}

Finding check_hermite_continuity(const HermiteContext& context, Fields& fields, bool proved) {
  Meter& meter = context.meter;
  const auto& f = require_interpolant(context);
  if (!context.facts.rates) throw Refused("a claim halves, verified, must come before");
  const long order = fields.take_integer("order", 0, limits::order);
  const std::string subject = "(the limits are C^" + std::to_string(order) + " in x)";
  if (proved) {
    const long reached = context.facts.fit ? static_cast<long>(context.rules.order) : 1;
    if (order > reached) throw Refused("C^" + std::to_string(reached) + " is what follows");
    if (!context.facts.fit && context.rules.order != 2) throw Refused("known for two derivatives only");
    return {subject,
            context.facts.fit ? "every edge has one interpolant at all levels" : "finite rates",
            {"hermite-halves"}};
  }
  Fields witness(fields.take("witness"), fields.path("witness"));
  const Ratio jump = read_ratio(witness.take("jump"), rate_names, witness.path("jump"), meter);
  const Ratio drift = read_ratio(witness.take("drift"), rate_names, witness.path("drift"), meter);
  witness.done();
  if (order < 2 || context.rules.order != 2 || context.facts.fit) throw Refused("no jump is known");
  const auto& [left, right] = *context.facts.rates;
  const Ratio scale = scale_in_rates(f, meter);
  Fraction series = series_of_bump(meter);
  series.numerator = -series.numerator;
  if (!same(jump, combination(series, left, 1, right, scale, meter), meter)) throw Refused("the jump is another one");
  if (!same(drift, combination(bump_at(1, 3, meter), left, -1, right, scale, meter), meter)) {
    throw Refused("the drift is another one");
  }
  if (jump.numerator.empty()) throw Refused("there is no jump");
  return {subject, "p_2 jumps by a multiple of p_1 at the vertices, which is not identically 0", {"hermite-halves"}};
}

Finding check_curvature(const HermiteContext& context, Fields& fields, bool proved) {
  require_proved(fields, proved);
  require_interpolant(context);
  if (!context.facts.rates) throw Refused("a claim halves, verified, must come before");
  if (context.rules.order != 2) throw Refused("known for two derivatives only");
  return {"(the limits have continuous curvature where p_1 != 0, that of the data at the vertices)",
          context.facts.fit ? "every edge has one interpolant at all levels" : "finite rates",
          {"hermite-halves"}};
}

// sum mu_k Q_k B_k/sum mu_k B_k on a <= x <= b: the polynomials are the mu_k and the mu_k Q_k, times one positive
// integer, the Q_k linear forms in the data f_a, f_b, p_a, p_b, ...
Finding check_bezier_form(Meter& meter, Fields& fields, bool proved) {
  require_proved(fields, proved);
  static const std::array<std::string, 2> ends{"a", "b"};
  const auto polynomials = [&](const Value& list, const std::string& where) {
    std::vector<Polynomial> result;
    for (const Value& p : as_array(list, where)) {
      result.push_back(parse_polynomial(as_string(p, where), ends, where, meter));
    }
    return result;
  };
  const std::vector<Polynomial> weights = polynomials(fields.take("weights"), fields.path("weights"));
  const std::vector<Value>& list = fields.take_array("points");
  const Dense base = read_dense(fields, "base", meter);
  const int power_of_base = static_cast<int>(fields.take_integer("power", 0, 16));
  const Fraction multiple = parse_fraction(fields.take_string("multiple"), fields.path("multiple"), meter);
  const Fraction scale = parse_fraction(fields.take_string("scale"), fields.path("scale"), meter);
  const std::size_t n = weights.empty() ? 0 : weights.size() - 1;
  if (n % 2 == 0 || n > static_cast<std::size_t>(most_degree) || list.size() != weights.size()) {
    throw Malformed(fields.path("weights") + ": an even number of weights and as many points are expected");
  }
  if (multiple.numerator <= 0 || scale.numerator <= 0) throw Malformed(fields.path("scale") + ": not positive");
  std::vector<std::vector<Polynomial>> points;
  for (std::size_t k = 0; k < list.size(); ++k) {
    points.push_back(polynomials(list[k], fields.path("points")));
    if (points.back().size() != n + 1) throw Malformed(fields.path("points") + ": a coefficient for each datum");
  }
  Dense denominator{Integer(1)};
  for (int i = 0; i < power_of_base; ++i) denominator = times(denominator, base, meter);
  const Polynomial a = variable(0), b = variable(1), x = variable(2);
  const auto at = [&](const Dense& p, const Polynomial& place) {
    Polynomial result;
    for (std::size_t i = p.size(); i-- > 0;) result = sum(product(result, place, meter), constant(p[i]), 1, meter);
    return result;
  };
  const Polynomial length = sum(b, a, -1, meter), from = sum(x, a, -1, meter), to = sum(b, x, -1, meter);
  // The denominator: sum of the weights times Bernstein polynomials.
  Polynomial total;
  Integer binomial = 1;
  for (std::size_t k = 0; k <= n; ++k) {
    const Polynomial basis =
        product(power(from, static_cast<int>(k), meter), power(to, static_cast<int>(n - k), meter), meter);
    total = sum(total, product(weights[k], basis, meter), binomial, meter);
    binomial = binomial * static_cast<long>(n - k) / static_cast<long>(k + 1);
  }
  const Polynomial expected = product(power(length, static_cast<int>(n), meter), at(denominator, x), meter);
  Polynomial error;
  add_scaled(error, total, multiple.denominator, Monomial{}, meter);
  add_scaled(error, expected, -multiple.numerator, Monomial{}, meter);
  if (!error.empty()) throw Refused("the weights are not those of base^power");
  // Derivatives of the numerator at the ends: n!/(n-i)! differences/length^i = multiple (base^power c)^(i), where
  // c^(i) = p_i/scale^i.
  const std::size_t order = (n - 1) / 2;
  std::vector<Dense> slopes{denominator};
  for (std::size_t i = 0; i < order; ++i) slopes.push_back(derivative(slopes.back()));
  for (std::size_t end = 0; end < 2; ++end) {
    Integer falling = 1;
    for (std::size_t i = 0; i <= order; ++i) {
      if (i > 0) falling *= static_cast<long>(n - i + 1);
      for (std::size_t column = 0; column <= n; ++column) {
        Polynomial differences;
        Integer choose = 1;
        for (std::size_t j = 0; j <= i; ++j) {
          // At the left end sum (-1)^{i-j} C(i,j) N_j, at the right end sum (-1)^j C(i,j) N_{n-j}.
          const bool negative = end == 0 ? (i - j) % 2 == 1 : j % 2 == 1;
          const Polynomial& p = points[end == 0 ? j : n - j][column];
          differences = sum(differences, p, negative ? Integer(-choose) : choose, meter);
          choose = choose * static_cast<long>(i - j) / static_cast<long>(j + 1);
        }
        Polynomial right;
        const std::size_t datum = column / 2;
        if (column % 2 == end && datum <= i) {
          Integer c = 1;  // C(i, datum)
          for (std::size_t j = 0; j < datum; ++j) c = c * static_cast<long>(i - j) / static_cast<long>(j + 1);
          right = at(slopes[i - datum], end == 0 ? a : b);
          right = product(right, constant(c * meter.power(scale.denominator, datum)), meter);
        }
        right = product(right, power(length, static_cast<int>(i), meter), meter);
        // falling differences * scale^datum = multiple right length^i.
        Polynomial gap;
        add_scaled(gap, differences,
                   falling * multiple.denominator *
                       (column % 2 == end && datum <= i ? meter.power(scale.numerator, datum) : Integer(1)),
                   Monomial{}, meter);
        add_scaled(gap, right, -multiple.numerator, Monomial{}, meter);
        if (!gap.empty()) {
          throw Refused("the derivative of order " + std::to_string(i) + " at the " + (end == 0 ? "left" : "right") +
                        " end is not the datum");
        }
      }
    }
  }
  return {"(the curve in Bezier form has the denominator base^power and the data at its ends)",
          "identities in a, b, x verified",
          {"hermite-interpolation"}};
}

}  // namespace twoscale::check
