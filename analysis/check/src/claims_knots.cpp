// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Claims about a rule on arbitrary knots: `knots-reproduces`, `knots-support`,
// `junction`, `knots-continuity`.
#include "twoscale/check/claims.hpp"
#include "twoscale/check/covering.hpp"
#include "twoscale/check/knot_rule.hpp"
#include "twoscale/check/positivity.hpp"
#include "twoscale/check/remainder.hpp"
#include "twoscale/check/root_bound.hpp"

#include <algorithm>
#include <set>

namespace twoscale::check {
namespace {

const KnotRule& rule_of(const Context& context, const Fields& fields) {
  if (!context.certificate.knots) throw Malformed(fields.path("claim") + ": the document has no member \"knots\"");
  return *context.certificate.knots;
}

/// The box of the variables that occur in p, and p in these variables.
std::pair<Polynomial, Box> restricted(const Polynomial& p, const Box& box, const Polynomial& by) {
  const Monomial top = degrees(by);
  Box small;
  std::vector<std::size_t> kept;
  for (std::size_t j = 0; j < box.names.size(); ++j) {
    if (top[j] == 0) continue;
    kept.push_back(j);
    small.names.push_back(box.names[j]);
    small.sides.push_back(box.sides[j]);
  }
  Polynomial q;
  for (const auto& [monomial, coefficient] : p) {
    Monomial rest{};
    for (std::size_t i = 0; i < kept.size(); ++i) rest[i] = monomial[kept[i]];
    q.emplace(rest, coefficient);
  }
  return {std::move(q), std::move(small)};
}

/// Verifies a {"method", "tree"} for p on the box of the variables that occur in `by`.
void require(const Polynomial& p, const Box& box, const Polynomial& by, bool strict, Fields& fields, Meter& meter,
             std::set<std::string_view>& trusted) {
  const std::string& method = fields.take_string("method");
  const std::string& tree = fields.take_string("tree");
  const auto [q, small] = restricted(p, box, by);
  require_positive(q, small, strict, method, tree, fields.path("tree"), meter);
  trusted.insert(method == "sturm" ? "sturm" : "bernstein");
}

Polynomial negative(const Polynomial& p, Meter& meter) {
  Polynomial q;
  add_scaled(q, p, -1, Monomial{}, meter);
  return q;
}

/// Are the weights of two pieces the same wherever the polynomial `where` is 0? The numerators of the differences are
/// divisible by it.
bool agree_where_zero(const LocalRow& a, const LocalRow& b, const Polynomial& where, Meter& meter) {
  const Polynomial by = primitive_part(where, meter);
  for (std::size_t i = 0; i < a.entries.size(); ++i) {
    Polynomial difference = product(a.entries[i], b.denominator, meter);
    add_scaled(difference, product(b.entries[i], a.denominator, meter), -1, Monomial{}, meter);
    if (!difference.empty() && !quotient(difference, by, meter)) return false;
  }
  return true;
}

/// The piece that a claim names for an edge: its own condition is >= 0 on the box; those of the pieces before it are <
/// 0 (off the excluded faces), or <= 0, and where they are 0 the weights are the same.
std::size_t named_piece(const KnotRule& rule, const std::vector<Scaled>& values, const Box& box, Fields& fields,
                        Meter& meter, std::set<std::string_view>& trusted) {
  const auto index =
      static_cast<std::size_t>(fields.take_integer("piece", 0, static_cast<long>(rule.pieces.size()) - 1));
  const bool last = index + 1 == rule.pieces.size();
  const std::vector<Value>& conditions = fields.take_array("conditions");
  if (conditions.size() != index + (last ? 0 : 1))
    throw Malformed(fields.path("conditions") + ": " + std::to_string(index + (last ? 0 : 1)) + " are expected");
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    Fields condition(conditions[i], fields.path("conditions") + "[" + std::to_string(i) + "]");
    const std::string& strictness = condition.take_string("strict");
    if (strictness != "yes" && strictness != "no")
      throw Malformed(condition.path("strict") + ": \"yes\" or \"no\" is expected");
    const bool strict = strictness == "yes";
    const Polynomial where = substituted(rule.pieces[i].where, values, meter).value;
    if (i == index && strict) throw Malformed(condition.path("strict") + ": \"no\" for the piece itself");
    require(i == index ? where : negative(where, meter), box, where, strict, condition, meter, trusted);
    if (i < index && !strict &&
        (where.empty() || !agree_where_zero(local_row(rule.pieces[i], values, meter),
                                            local_row(rule.pieces[index], values, meter), where, meter)))
      throw Refused(condition.path("strict") + ": the pieces do not agree where the condition is 0");
    condition.done();
  }
  return index;
}

long edge_of(const KnotRule& rule, std::size_t row) { return (-rule.reach() + 2 * static_cast<long>(row) - 1) / 2; }

/// p over the variables of the box, read in the list `names` that has z beside them.
struct Names {
  std::vector<std::string> all;
  std::size_t z = 0;
};
Names with_root(const Box& box) {
  Names n{box.names, 0};
  const auto place = std::lower_bound(n.all.begin(), n.all.end(), "z");
  if (place != n.all.end() && *place == "z") throw Malformed("variables: z is the unknown of the eigenvalues");
  n.z = static_cast<std::size_t>(place - n.all.begin());
  n.all.insert(place, "z");
  return n;
}
Polynomial make_room(const Polynomial& p, std::size_t z) {
  Polynomial q;
  for (const auto& [monomial, coefficient] : p) {
    Monomial m{};
    for (std::size_t j = 0; j + 1 < m.size(); ++j) m[j < z ? j : j + 1] = monomial[j];
    q.emplace(m, coefficient);
  }
  return q;
}
LocalRow make_room(const LocalRow& row, std::size_t z) {
  LocalRow r;
  for (const auto& e : row.entries) r.entries.push_back(make_room(e, z));
  r.denominator = make_room(row.denominator, z);
  return r;
}

/// The coefficient of the highest power of the variable z, as a polynomial in the others.
Polynomial leading(const Polynomial& p, std::size_t z) {
  const int top = degrees(p)[z];
  Polynomial q;
  for (const auto& [monomial, coefficient] : p) {
    if (monomial[z] != top) continue;
    Monomial m = monomial;
    m[z] = 0;
    q.emplace(m, coefficient);
  }
  return q;
}

/// (2 z - 1)(4 z - 1) ... (2^{kept-1} z - 1).
Polynomial known_factor(long kept, std::size_t z, Meter& meter) {
  Polynomial result;
  result.emplace(Monomial{}, 1);
  for (long n = 1; n < kept; ++n) {
    Monomial m{};
    m[z] = 1;
    Polynomial factor;
    factor.emplace(m, meter.power(2, static_cast<std::uint64_t>(n)));
    factor.emplace(Monomial{}, -1);
    result = product(result, factor, meter);
  }
  return result;
}

Fraction radius_of(long order, Meter& meter) { return {1, meter.power(2, static_cast<std::uint64_t>(order))}; }

std::string claim_text(const KnotRule& rule, long order, const std::string& where) {
  std::string text = "all eigenvalues of the local matrix on -" + std::to_string(rule.reach()) + ".." +
                     std::to_string(rule.reach()) + " but 1";
  for (long n = 1; n <= order; ++n) text += ", 2^-" + std::to_string(n);
  return text + " in |z| < 2^-" + std::to_string(order) + where;
}

/// Refuted at a point: numbers for the ratio and the edge parameters.
Finding refuted_junction(const KnotRule& rule, Fields& fields, Meter& meter) {
  const auto number = [&](const char* key) { return parse_fraction(fields.take_string(key), fields.path(key), meter); };
  const Fraction ratio = number("ratio");
  if (ratio.numerator <= 0) throw Malformed(fields.path("ratio") + ": a positive number is expected");
  Place place{constant(ratio), {}, {}};
  std::string text = "at ratio " + text_of(ratio);
  if (rule.has_edges) {
    const Fraction left = number("left"), right = number("right");
    for (const Fraction& l : {left, right})
      if (l.numerator < 0 || l.numerator > l.denominator) throw Malformed(fields.path("left") + ": not in [0, 1]");
    place.left = constant(left);
    place.right = constant(right);
    text += ", edge parameters " + text_of(left) + ", " + text_of(right);
  }
  const long kept = fields.take_integer("kept", 1, 64), order = fields.take_integer("order", 0, kept - 1);
  std::vector<LocalRow> rows;
  for (long i = 0; i <= rule.reach(); ++i) {
    const auto values = values_at(rule, place, edge_of(rule, static_cast<std::size_t>(i)));
    const auto piece = constant_piece(rule, values, meter);
    rows.push_back(local_row(rule.pieces[*piece], values, meter));
  }
  const auto rest = quotient(local_determinant(rule, rows, 0, meter), known_factor(kept, 0, meter), meter);
  if (!rest) throw Refused(fields.path("kept") + ": 2^-n, n < " + std::to_string(kept) + ", are not all eigenvalues");
  std::vector<Polynomial> a = root_coefficients(*rest, 0, 1, radius_of(order, meter), meter);
  Dense values;
  for (const Polynomial& c : a) values.push_back(c.empty() ? Integer(0) : c.begin()->second);
  if (schur_cohn(values, meter)) throw Refused("all other eigenvalues are inside");
  return {claim_text(rule, order, " " + text), "a further one is not inside", {"schur-cohn"}};
}

}  // namespace

Finding check_knots_reproduces(const Context& context, Fields& fields, bool proved) {
  const KnotRule& rule = rule_of(context, fields);
  require_proved(fields, proved);
  Meter& meter = context.meter;
  const long degree = fields.take_integer("degree", 0, 32);
  // x_h, and twice the middle of the edge 0.
  const auto interval = [&](long offset) {
    for (std::size_t j = 0; j < rule.names.size(); ++j)
      if (!rule.variables[j].edge && rule.variables[j].offset == offset) {
        Monomial m{};
        m[j] = 1;
        return Polynomial{{m, Integer(1)}};
      }
    throw Refused("the rule does not know the interval of the edge " + std::to_string(offset));
  };
  const auto knot = [&](long h) {
    Polynomial x;
    for (long e = 0; e < h; ++e) add_scaled(x, interval(e), 1, Monomial{}, meter);
    for (long e = h; e < 0; ++e) add_scaled(x, interval(e), -1, Monomial{}, meter);
    return x;
  };
  std::vector<Polynomial> knots;
  for (long h = rule.lowest; h <= rule.highest(); ++h) knots.push_back(knot(h));
  std::vector<Scaled> itself;
  for (std::size_t j = 0; j < rule.names.size(); ++j) {
    Monomial m{};
    m[j] = 1;
    itself.push_back({Polynomial{{m, Integer(1)}}, 1});
  }
  for (std::size_t i = 0; i < rule.pieces.size(); ++i) {
    LocalRow row = local_row(rule.pieces[i], itself, meter);
    Polynomial middle = row.denominator;
    for (long e = 0; e <= degree; ++e) {
      Polynomial sum;
      for (const Polynomial& entry : row.entries) add_scaled(sum, entry, 1, Monomial{}, meter);
      if (sum != middle)
        throw Refused("piece " + std::to_string(i + 1) + ": x^" + std::to_string(e) + " is not reproduced");
      if (e == degree) break;
      for (std::size_t h = 0; h < knots.size(); ++h) {  // times 2 x_h, and d_0
        Polynomial twice;
        add_scaled(twice, product(row.entries[h], knots[h], meter), 2, Monomial{}, meter);
        row.entries[h] = std::move(twice);
      }
      middle = product(middle, interval(0), meter);
    }
  }
  context.knots.degree = std::max(context.knots.degree, degree);
  return {"polynomials of degree <= " + std::to_string(degree) + " for all intervals and edge parameters",
          "identities in " + std::to_string(rule.names.size()) + " variables, " + std::to_string(rule.pieces.size()) +
              " piece(s)",
          {"definition"}};
}

Finding check_knots_support(const Context& context, Fields& fields, bool proved) {
  const KnotRule& rule = rule_of(context, fields);
  require_proved(fields, proved);
  const std::vector<Value>& ends = fields.take_array("support");
  if (ends.size() != 2) throw Malformed(fields.path("support") + ": two integers are expected");
  const long low = as_integer(ends[0], -1000, 1000, fields.path("support")),
             high = as_integer(ends[1], -1000, 1000, fields.path("support"));
  if (low != 1 - 2 * rule.highest() || high != 1 - 2 * rule.lowest)
    throw Refused(fields.path("support") + ": the points that the rule reads lead to other ends");
  if (context.certificate.mask.lowest != low || context.certificate.mask.highest() != high)
    throw Refused(fields.path("support") + ": the mask on equal knots is shorter");
  return {"the limit of the data 1 at x_0 vanishes outside of [x_" + std::to_string(low) + ", x_" +
              std::to_string(high) + "] for all intervals and edge parameters",
          "by the points that the rule reads; on equal knots both ends are attained, the mask being so long",
          {"compact-support"}};
}

Finding check_junction(const Context& context, Fields& fields, bool proved) {
  const KnotRule& rule = rule_of(context, fields);
  Meter& meter = context.meter;
  if (!proved) return refuted_junction(rule, fields, meter);
  Box box = read_box(fields, meter);
  read_zeros(fields, box);
  const Names names = with_root(box);
  if (names.all.size() > limits::variables) throw Malformed(fields.path("variables") + ": too many");
  const std::string& ratio = fields.take_string("ratio");
  const auto side = std::find(box.names.begin(), box.names.end(), ratio);
  if (side == box.names.end()) throw Malformed(fields.path("ratio") + ": one of the variables is expected");
  const Side& positive = box.sides[static_cast<std::size_t>(side - box.names.begin())];
  if (positive.low.numerator < 0 || (positive.low.numerator == 0 && !positive.zero_low))
    throw Refused(fields.path("ratio") + ": it is not positive on the box");
  Place place{{parse_polynomial(ratio, box.names, fields.path("ratio"), meter), 1}, {}, {}};
  std::set<std::string_view> trusted;
  std::string parameters;
  if (rule.has_edges) {
    for (const char* key : {"left", "right"}) {
      const std::string& text = fields.take_string(key);
      (key == std::string_view("left") ? place.left : place.right).value =
          parse_polynomial(text, box.names, fields.path(key), meter);
      parameters += (parameters.empty() ? ", edge parameters " : " and ") + shortened(text);
    }
  }
  // Which pieces hold at the edges of the window.
  const std::vector<Value>& pieces = fields.take_array("pieces");
  std::vector<LocalRow> rows;
  std::vector<Polynomial> factors;
  std::size_t next = 0;
  for (long i = 0; i <= rule.reach(); ++i) {
    const long edge = edge_of(rule, static_cast<std::size_t>(i));
    const std::vector<Scaled> values = values_at(rule, place, edge);
    std::optional<std::size_t> piece = constant_piece(rule, values, meter);
    if (!piece) {
      if (next >= pieces.size()) throw Malformed(fields.path("pieces") + ": one is missing");
      Fields named(pieces[next], fields.path("pieces") + "[" + std::to_string(next) + "]");
      ++next;
      if (named.take_integer("edge", -64, 64) != edge)
        throw Malformed(named.path("edge") + ": " + std::to_string(edge) + " is expected");
      piece = named_piece(rule, values, box, named, meter, trusted);
      named.done();
    }
    rows.push_back(local_row(rule.pieces[*piece], values, meter));
    for (const Polynomial& f : rows.back().factors)
      if (std::find(factors.begin(), factors.end(), f) == factors.end()) factors.push_back(f);
  }
  if (next != pieces.size()) throw Malformed(fields.path("pieces") + ": too many");
  // The weights have no pole on the box.
  std::string before;
  std::size_t used = 0;
  for (const Value& item : fields.take_array("denominators")) {
    Fields denominator(item, fields.path("denominators") + "[" + std::to_string(used) + "]");
    const std::string& text = denominator.take_string("polynomial");
    if (used > 0 && !(before < text)) throw Malformed(denominator.path("polynomial") + ": they must be sorted");
    before = text;
    const Polynomial p = parse_polynomial(text, box.names, denominator.path("polynomial"), meter);
    const auto known = p.empty() ? factors.end() : std::find(factors.begin(), factors.end(), primitive_part(p, meter));
    if (known == factors.end()) throw Refused(denominator.path("polynomial") + ": no denominator of the rule here");
    require(p, box, p, true, denominator, meter, trusted);
    denominator.done();
    ++used;
  }
  if (used != factors.size()) throw Refused(fields.path("denominators") + ": not all denominators are shown positive");
  // The characteristic polynomial.
  const long kept = fields.take_integer("kept", 1, 64), order = fields.take_integer("order", 0, kept - 1);
  for (LocalRow& row : rows) row = make_room(row, names.z);
  const Polynomial determinant = local_determinant(rule, rows, names.z, meter);
  Polynomial expected = known_factor(kept, names.z, meter), top;
  top.emplace(Monomial{}, 1);
  const Fraction radius = radius_of(order, meter);
  std::string restriction;
  std::size_t number = 0;
  for (const Value& item : fields.take_array("factors")) {
    Fields factor(item, fields.path("factors") + "[" + std::to_string(number++) + "]");
    const std::string& text = factor.take_string("polynomial");
    const Polynomial p = parse_polynomial(text, names.all, factor.path("polynomial"), meter);
    if (p.empty() || degrees(p)[names.z] == 0) throw Malformed(factor.path("polynomial") + ": it has no roots");
    const long multiplicity = factor.take_integer("multiplicity", 1, 64);
    for (long m = 0; m < multiplicity; ++m) expected = product(expected, p, meter);
    const std::vector<Polynomial> a = root_coefficients(p, names.z, names.all.size(), radius, meter);
    Polynomial occurring;  // the variables of the factor
    for (const Polynomial& c : a)
      for (const auto& [monomial, coefficient] : c) occurring.emplace(monomial, 1);
    const std::vector<Value>& conditions = factor.take_array("conditions");
    if (degrees(occurring) == Monomial{}) {
      Dense values;
      for (const Polynomial& c : a) values.push_back(c.empty() ? Integer(0) : c.begin()->second);
      if (!conditions.empty()) throw Malformed(factor.path("conditions") + ": none without parameters");
      if (!schur_cohn(values, meter)) throw Refused(factor.path("polynomial") + ": not all roots are inside");
    } else {
      const std::vector<Polynomial> derived = root_conditions(a, meter);
      if (conditions.size() != derived.size())
        throw Malformed(factor.path("conditions") + ": " + std::to_string(derived.size()) + " are expected");
      for (std::size_t i = 0; i < derived.size(); ++i) {
        Fields condition(conditions[i], factor.path("conditions") + "[" + std::to_string(i) + "]");
        if (condition.next_is_text("method", "restriction")) {
          condition.take_string("method");
          if (!restriction.empty()) throw Malformed(condition.path("method") + ": more than one restriction");
          restriction = condition.take_string("tree");
          const Polynomial stated = parse_polynomial(restriction, box.names, condition.path("tree"), meter);
          if (stated.empty() || content(stated, meter) != 1)
            throw Malformed(condition.path("tree") + ": a primitive polynomial is expected");
          const Integer c = content(derived[i], meter);
          Polynomial times;
          add_scaled(times, stated, c, Monomial{}, meter);
          if (times != derived[i]) throw Refused(condition.path("tree") + ": the condition is another one");
        } else {
          require(derived[i], box, occurring, true, condition, meter, trusted);
        }
        condition.done();
      }
    }
    factor.done();
  }
  if (determinant.empty() || degrees(determinant)[names.z] != degrees(expected)[names.z] ||
      product(determinant, leading(expected, names.z), meter) !=
          product(expected, leading(determinant, names.z), meter))
    throw Refused(fields.path("factors") + ": not the characteristic polynomial of the local matrix");
  KnotFacts::Junction fact{order, std::nullopt};
  if (restriction.empty() && all_ratios(positive)) {
    const auto index = static_cast<std::size_t>(side - box.names.begin());
    fact.region = rule.has_edges ? region_of(place.left.value, place.right.value, index, box.sides, meter)
                                 : Region{Region::Shape::rectangle, {0, 1}, {1, 1}, {0, 1}, {1, 1}};
  }
  context.knots.junctions.push_back(std::move(fact));
  std::string where = " for " + text_of(box) + parameters;
  if (!restriction.empty())
    where += ", exactly where " + (restriction.size() <= 200 ? restriction : "the polynomial of the claim") + " > 0";
  std::vector<std::string_view> keys{"schur-cohn"};
  keys.insert(keys.end(), trusted.begin(), trusted.end());
  return {claim_text(rule, order, where), "characteristic polynomial computed from the rule, roots bounded", keys};
}

Finding check_knots_continuity(const Context& context, Fields& fields, bool proved) {
  const KnotRule& rule = rule_of(context, fields);
  require_proved(fields, proved);
  Meter& meter = context.meter;
  const long order = fields.take_integer("order", 0, 64), sum_rules = fields.take_integer("sum_rules", 1, 512);
  if (order >= sum_rules) throw Refused("the order must be less than that of the sum rules");
  exact_remainder(context, sum_rules);
  const Fraction limit{meter.power(2, static_cast<std::uint64_t>(sum_rules - order)), 1};
  const auto& list = context.radius.list;
  if (std::none_of(list.begin(), list.end(), [&](const Fraction& u) { return compare(u, limit, meter) < 0; }))
    throw Refused("no claim before this one shows that the radius on equal knots is less than 2^" +
                  std::to_string(sum_rules - order));
  if (context.knots.degree < order)
    throw Refused("no claim before this one shows that polynomials of degree " + std::to_string(order) +
                  " are reproduced");
  std::vector<Region> regions;
  long junctions = 0;
  for (const KnotFacts::Junction& j : context.knots.junctions) {
    if (j.order < order) continue;
    ++junctions;
    if (j.region) regions.push_back(*j.region);
  }
  if (junctions == 0) throw Refused("no claim before this one is about the vertices");
  // For which intervals and edge parameters.
  const std::string& parameters = fields.take_string("parameters");
  const bool all = parameters == "all", but_crease = parameters == "all-but-crease";
  if (!all && !but_crease && parameters != "claims")
    throw Malformed(fields.path("parameters") + ": \"all\", \"all-but-crease\" or \"claims\" is expected");
  std::string where = "the parameters of " + std::to_string(junctions) + " claim(s) above";
  std::string evidence = "precision, the radius on equal knots and the eigenvalues by claims above";
  if (all || but_crease) {
    std::string hole;
    const Covering covering = covering_of(regions, hole, meter);
    if (covering == Covering::none)
      throw Refused(fields.path("parameters") + ": the claims above do not cover the edge parameters " + hole);
    if (all && covering != Covering::all)
      throw Refused(fields.path("parameters") +
                    ": the claims above do not cover the edge parameters left = 1, right = 0");
    where = "all ratios of intervals" + std::string(rule.has_edges ? " and all edge parameters in [0, 1]^2" : "");
    if (but_crease) where += " but left = 1, right = 0";
    evidence += ", whose boxes cover these parameters";
  }
  return {"C^" + std::to_string(order) +
              " limits, converging uniformly: between the vertices of the data, and at them " + "for " + where,
          evidence,
          {"piecewise-uniform"}};
}

}  // namespace twoscale::check
