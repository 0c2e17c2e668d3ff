// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Rules on knots: reading, values at a vertex, the determinant of the local matrix.
#include "twoscale/check/knot_rule.hpp"

#include "twoscale/check/positivity.hpp"

#include <algorithm>

namespace twoscale::check {
namespace {

constexpr std::size_t most_weights = 16;
constexpr std::size_t most_rows = 12;

/// "d_0", "d_m1" -> its offset, if the name begins with `base`_.
std::optional<long> offset_in(const std::string& name, const std::string& base) {
  if (base.empty() || name.size() < base.size() + 2 || name.compare(0, base.size() + 1, base + "_") != 0)
    return std::nullopt;
  std::string digits = name.substr(base.size() + 1);
  const bool negative = digits.front() == 'm';
  if (negative) digits.erase(0, 1);
  if (digits.empty() || digits.size() > 2 || (digits.size() > 1 && digits.front() == '0') ||
      (negative && digits == "0"))
    return std::nullopt;
  if (!std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; })) return std::nullopt;
  const long value = std::stol(digits);
  return negative ? -value : value;
}

Polynomial constant_polynomial(const Integer& value) {
  Polynomial p;
  if (value != 0) p.emplace(Monomial{}, value);
  return p;
}

bool is_constant(const Polynomial& p) { return p.empty() || (p.size() == 1 && p.begin()->first == Monomial{}); }

Integer lcm(const Integer& a, const Integer& b, Meter& meter) { return meter.multiply(a, b / meter.gcd(a, b)); }

Fraction value_at(const Polynomial& p, const std::vector<Fraction>& point, Meter& meter) {
  const Monomial top = degrees(p);
  Integer scale = 1;
  for (std::size_t j = 0; j < point.size(); ++j)
    scale = meter.multiply(scale, meter.power(point[j].denominator, static_cast<std::uint64_t>(top[j])));
  return reduced(scaled_value(p, point, meter), scale, meter);
}

}  // namespace

Scaled constant(const Fraction& value) { return {constant_polynomial(value.numerator), value.denominator}; }

Scaled substituted(const Polynomial& p, const std::vector<Scaled>& values, Meter& meter) {
  const Monomial top = degrees(p);
  std::vector<std::vector<Polynomial>> powers(values.size());
  std::vector<std::vector<Integer>> scales(values.size());
  Scaled result;
  for (std::size_t j = 0; j < values.size(); ++j) {
    powers[j].push_back(constant_polynomial(1));
    scales[j].emplace_back(1);
    for (int e = 1; e <= top[j]; ++e) {
      powers[j].push_back(product(powers[j].back(), values[j].value, meter));
      scales[j].push_back(meter.multiply(scales[j].back(), values[j].scale));
    }
    result.scale = meter.multiply(result.scale, scales[j].back());
  }
  for (const auto& [monomial, coefficient] : p) {
    Integer factor = coefficient;
    Polynomial term = constant_polynomial(1);
    for (std::size_t j = 0; j < values.size(); ++j) {
      const auto e = static_cast<std::size_t>(monomial[j]);
      factor = meter.multiply(factor, scales[j][static_cast<std::size_t>(top[j]) - e]);
      if (e > 0) term = product(term, powers[j][e], meter);
    }
    add_scaled(result.value, term, factor, Monomial{}, meter);
  }
  return result;
}

KnotRule read_knot_rule(Fields& parent, Meter& meter) {
  Fields fields(parent.take("knots"), "knots");
  KnotRule rule;
  const std::string& interval = fields.take_string("interval");
  const std::string& edge = fields.take_string("edge");
  if (!is_variable_name(interval)) throw Malformed("knots.interval: a name is expected");
  rule.has_edges = !edge.empty();
  if (rule.has_edges && (!is_variable_name(edge) || edge == interval))
    throw Malformed("knots.edge: another name, or the empty string, is expected");
  const std::string& rest = fields.take_string("rest");
  if (rule.has_edges)
    rule.rest = parse_fraction(rest, "knots.rest", meter);
  else if (!rest.empty())
    throw Malformed("knots.rest: without edge parameters the empty string is expected");
  const std::vector<Value>& names = fields.take_array("variables");
  if (names.empty() || names.size() > limits::variables) throw Malformed("knots.variables: from 1 to 8 are expected");
  for (const Value& name : names) {
    const std::string& text = as_string(name, "knots.variables");
    if (!rule.names.empty() && !(rule.names.back() < text))
      throw Malformed("knots.variables: names must be distinct and sorted");
    const auto as_interval = offset_in(text, interval), as_edge = offset_in(text, edge);
    if (!as_interval && !as_edge) throw Malformed("knots.variables: \"" + shortened(text) + "\" has no offset");
    rule.names.push_back(text);
    rule.variables.push_back({!as_interval, as_interval ? *as_interval : *as_edge});
  }
  rule.lowest = fields.take_integer("lowest", -8, 0);
  const std::vector<Value>& pieces = fields.take_array("pieces");
  if (pieces.empty() || pieces.size() > 16) throw Malformed("knots.pieces: from 1 to 16 are expected");
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Fields piece(pieces[i], "knots.pieces[" + std::to_string(i) + "]");
    RulePiece read;
    const std::string& where = piece.take_string("where");
    if (where.empty() != (i + 1 == pieces.size()))
      throw Malformed(piece.path("where") + ": empty for the last piece, and for no other");
    if (!where.empty()) read.where = parse_polynomial(where, rule.names, piece.path("where"), meter);
    const std::vector<Value>& weights = piece.take_array("weights");
    if (weights.size() < 2 || weights.size() > most_weights ||
        (i > 0 && weights.size() != rule.pieces.front().weights.size()))
      throw Malformed(piece.path("weights") + ": from 2 to 16, in each piece as many, are expected");
    for (std::size_t j = 0; j < weights.size(); ++j) {
      Fields weight(weights[j], piece.path("weights") + "[" + std::to_string(j) + "]");
      Weight w;
      w.numerator = parse_polynomial(weight.take_string("numerator"), rule.names, weight.path("numerator"), meter);
      for (const Value& factor : weight.take_array("denominator")) {
        w.denominator.push_back(parse_polynomial(as_string(factor, weight.path("denominator")), rule.names,
                                                 weight.path("denominator"), meter));
        if (w.denominator.back().empty()) throw Malformed(weight.path("denominator") + ": a factor is 0");
        if (w.denominator.size() > 64) throw Malformed(weight.path("denominator") + ": more than 64 factors");
      }
      weight.done();
      read.weights.push_back(std::move(w));
    }
    piece.done();
    rule.pieces.push_back(std::move(read));
  }
  fields.done();
  if (rule.highest() < 1) throw Malformed("knots.lowest: the points of both ends of the edge are expected");
  if (rule.reach() % 2 == 0 || static_cast<std::size_t>(rule.reach()) + 1 > most_rows)
    throw Malformed("knots.pieces: too many weights");
  return rule;
}

std::vector<Fraction> uniform_weights(const KnotRule& rule, Meter& meter) {
  std::vector<Fraction> point;
  for (const auto& v : rule.variables) point.push_back(v.edge ? rule.rest : Fraction{1, 1});
  for (std::size_t i = 0; i < rule.pieces.size(); ++i) {
    const RulePiece& piece = rule.pieces[i];
    if (i + 1 < rule.pieces.size() && scaled_value(piece.where, point, meter) < 0) continue;
    std::vector<Fraction> result;
    for (const Weight& w : piece.weights) {
      Fraction value = value_at(w.numerator, point, meter);
      for (const Polynomial& factor : w.denominator) {
        const Fraction d = value_at(factor, point, meter);
        if (d.numerator == 0) throw Malformed("knots: a pole on equal intervals");
        value = reduced(meter.multiply(value.numerator, d.denominator), meter.multiply(value.denominator, d.numerator),
                        meter);
      }
      result.push_back(value);
    }
    return result;
  }
  return {};
}

std::vector<Scaled> values_at(const KnotRule& rule, const Place& place, long edge) {
  std::vector<Scaled> values;
  for (const auto& v : rule.variables) {
    const long e = edge + v.offset;
    values.push_back(!v.edge   ? (e >= 0 ? place.ratio : constant({1, 1}))
                     : e == -1 ? place.left
                     : e == 0  ? place.right
                               : constant(rule.rest));
  }
  return values;
}

std::optional<std::size_t> constant_piece(const KnotRule& rule, const std::vector<Scaled>& values, Meter& meter) {
  for (std::size_t i = 0; i + 1 < rule.pieces.size(); ++i) {
    const Scaled where = substituted(rule.pieces[i].where, values, meter);
    if (!is_constant(where.value)) return std::nullopt;
    if (where.value.empty() || where.value.begin()->second > 0) return i;
  }
  return rule.pieces.size() - 1;
}

Polynomial primitive_part(const Polynomial& p, Meter& meter) {
  Integer by = content(p, meter);
  if (p.begin()->second < 0) by = -by;
  Polynomial result;
  for (const auto& [monomial, coefficient] : p) {
    meter.spend(words(coefficient) + 20);
    result.emplace_hint(result.end(), monomial, Integer(coefficient / by));
  }
  return result;
}

LocalRow local_row(const RulePiece& piece, const std::vector<Scaled>& values, Meter& meter) {
  struct Part {
    Polynomial numerator;  // times `by` over `under` and the factors
    Integer by = 1, under = 1;
    std::vector<unsigned> exponents;
  };
  std::vector<Part> parts;
  LocalRow row;
  for (const Weight& w : piece.weights) {
    Part part;
    Scaled n = substituted(w.numerator, values, meter);
    part.numerator = std::move(n.value);
    part.under = n.scale;
    part.exponents.assign(row.factors.size(), 0);
    for (const Polynomial& factor : w.denominator) {
      const Scaled d = substituted(factor, values, meter);
      if (d.value.empty()) throw Refused("the rule has a pole here");
      part.by = meter.multiply(part.by, d.scale);
      Integer c = content(d.value, meter);
      if (d.value.begin()->second < 0) c = -c;
      part.under = meter.multiply(part.under, c);
      const Polynomial prime = primitive_part(d.value, meter);
      if (is_constant(prime)) continue;
      const auto known = std::find(row.factors.begin(), row.factors.end(), prime);
      const auto place = static_cast<std::size_t>(known - row.factors.begin());
      if (known == row.factors.end()) row.factors.push_back(prime);
      if (part.exponents.size() <= place) part.exponents.resize(place + 1, 0);
      ++part.exponents[place];
    }
    parts.push_back(std::move(part));
  }
  std::vector<unsigned> most(row.factors.size(), 0);
  Integer common = 1;
  for (Part& part : parts) {
    part.exponents.resize(row.factors.size(), 0);
    for (std::size_t j = 0; j < most.size(); ++j) most[j] = std::max(most[j], part.exponents[j]);
    common = lcm(common, abs(part.under), meter);
  }
  for (const Part& part : parts) {
    Polynomial entry;
    add_scaled(entry, part.numerator, meter.multiply(part.by, common / part.under), Monomial{}, meter);
    for (std::size_t j = 0; j < most.size(); ++j)
      for (unsigned e = part.exponents[j]; e < most[j]; ++e) entry = product(entry, row.factors[j], meter);
    row.entries.push_back(std::move(entry));
  }
  row.denominator = constant_polynomial(common);
  for (std::size_t j = 0; j < most.size(); ++j) {
    for (unsigned e = 0; e < most[j]; ++e) {
      // A factor that divides the whole row is left out.
      std::vector<Polynomial> divided;
      for (const Polynomial& entry : row.entries) {
        auto q = quotient(entry, row.factors[j], meter);
        if (!q) break;
        divided.push_back(*std::move(q));
      }
      if (divided.size() == row.entries.size())
        row.entries = std::move(divided);
      else
        row.denominator = product(row.denominator, row.factors[j], meter);
    }
  }
  // So is a number.
  Integer number = content(row.denominator, meter);
  for (const Polynomial& entry : row.entries)
    if (!entry.empty()) number = meter.gcd(number, content(entry, meter));
  const Polynomial by = constant_polynomial(number);
  row.denominator = *quotient(row.denominator, by, meter);
  for (Polynomial& entry : row.entries) entry = *quotient(entry, by, meter);
  return row;
}

Polynomial local_determinant(const KnotRule& rule, const std::vector<LocalRow>& rows, std::size_t z, Meter& meter) {
  // f_j = z^{-a} f_o for j = 2^a o, o odd, since even rows say z f_{2i} = f_i; the row of 0 splits off z - 1. What is
  // left has one row and column for each odd index; column o is multiplied by z^{a(o)}, a(o) the largest a that occurs.
  const long reach = rule.reach();
  const std::size_t n = rows.size();
  const auto index = [&](std::size_t i) { return -reach + 2 * static_cast<long>(i); };
  std::vector<std::vector<Polynomial>> m(n, std::vector<Polynomial>(n));
  for (std::size_t i = 0; i < n; ++i) {
    const long edge = (index(i) - 1) / 2;  // exactly: the index is odd
    for (std::size_t c = 0; c < n; ++c) {
      const long o = index(c);
      int largest = 0;
      for (long j = 2 * o; std::labs(j) <= reach; j *= 2) ++largest;
      Monomial shift{};
      if (c == i) {
        shift[z] = largest + 1;
        add_scaled(m[i][c], rows[i].denominator, 1, shift, meter);
      }
      int a = 0;
      for (long j = o; std::labs(j) <= reach; j *= 2, ++a) {
        const long at = j - edge - rule.lowest;
        if (at < 0 || at >= static_cast<long>(rows[i].entries.size())) continue;
        shift[z] = largest - a;
        add_scaled(m[i][c], rows[i].entries[static_cast<std::size_t>(at)], -1, shift, meter);
      }
    }
  }
  // Minors of the first rows, one for each set of columns.
  std::vector<Polynomial> minors(std::size_t{1} << n);
  minors[0] = constant_polynomial(1);
  for (std::size_t set = 1; set < minors.size(); ++set) {
    std::size_t row = 0;
    for (std::size_t j = 0; j < n; ++j) row += set >> j & 1U;
    --row;
    int sign = 1;
    for (std::size_t j = n; j-- > 0;) {  // expansion along the last row, from its last column
      if ((set >> j & 1U) == 0) continue;
      meter.spend(20);
      const Polynomial& rest = minors[set ^ (std::size_t{1} << j)];
      if (!m[row][j].empty() && !rest.empty())
        add_scaled(minors[set], product(m[row][j], rest, meter), sign, Monomial{}, meter);
      sign = -sign;
    }
  }
  return minors.back();
}

}  // namespace twoscale::check
