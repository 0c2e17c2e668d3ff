// SPDX-License-Identifier: GPL-3.0-or-later
// The definitions of audit items on knots: fundamental splines, rules of schemes on knots, rows of junctions.
#include <algorithm>

#include "audit/formula.hpp"
#include "twoscale/analysis/junction.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"
#include "twoscale/symbolic/nulifs.hpp"

namespace twoscale::reports::audit {

namespace {

using Value = std::function<RationalFunction(const std::string&)>;
using Indexed = std::map<long, RationalFunction>;

// "spline order=3 at=x" -> its words after the first.
class Words {
 public:
  explicit Words(const std::string& text) : text_(text) {
    for (size_t from = text.find(' '); from != std::string::npos;) {
      const size_t to = text.find(' ', from + 1);
      if (const std::string w = trimmed(text.substr(from, to == std::string::npos ? to : to - from)); !w.empty())
        list_.push_back(w);
      from = to;
    }
  }
  const std::string& first() const {
    if (list_.empty()) bad_input("a scheme is expected in", text_);
    return list_[0];
  }
  // The text after "key=".
  std::string operator()(const std::string& key) const {
    for (const auto& w : list_)
      if (w.rfind(key + "=", 0) == 0) return w.substr(key.size() + 1);
    bad_input(key + "= is missing in", text_);
  }
  long number(const std::string& key) const { return integer((*this)(key), {}); }
  // NAME=VALUE,... after the word "where".
  std::map<std::string, Rational> sample() const {
    std::map<std::string, Rational> r;
    const auto at = std::find(list_.begin(), list_.end(), "where");
    if (at == list_.end()) return r;
    if (at + 1 == list_.end()) bad_input("NAME=VALUE is expected after where in", text_);
    for (const auto& piece : split_list(*(at + 1))) {
      const size_t equals = piece.find('=');
      if (equals == std::string::npos) bad_input("NAME=VALUE is expected, not", piece);
      r[piece.substr(0, equals)] = Rational::parse(piece.substr(equals + 1));
    }
    return r;
  }

 private:
  std::string text_;
  std::vector<std::string> list_;
};

FundamentalFamily family_of(const Words& w) {
  FundamentalFamily f;
  f.order = static_cast<unsigned>(w.number("order"));
  f.reproduction = static_cast<unsigned>(w.number("rho"));
  f.mu = static_cast<unsigned>(w.number("mu"));
  f.validate();
  return f;
}

// All knots that a spline around x_0 or a value near it may look at.
Knots<RationalFunction> knots_of(const Words& w, const FundamentalFamily& f, long beyond, const Value& value) {
  const std::string edges = w("edges");
  const size_t dots = edges.find("..");
  if (dots == std::string::npos) bad_input("a range a..b is expected, not", edges);
  const long from = integer(edges.substr(0, dots), {}), to = integer(edges.substr(dots + 2), {});
  const long reach = 2 * (static_cast<long>(f.order) + static_cast<long>(f.mu) + f.right()) + 4 + beyond;
  std::vector<RationalFunction> d, lambda;
  for (long e = -reach; e < reach; ++e) {
    const bool given = e >= from && e <= to;
    d.push_back(given ? value(local_name("d", e)) : RationalFunction(1));
    lambda.push_back(given ? value(local_name("lambda", e)) : RationalFunction(Rational(1, 2)));
  }
  return {-reach, std::move(d), std::move(lambda)};
}

Indexed knots(const Words& w, const Value& value) {
  const auto t = knots_of(w, {}, 0, value);
  Indexed r;
  for (long m = 2 * t.first_vertex(); m <= 2 * t.last_vertex(); ++m) r[m] = t(m);
  return r;
}

Indexed spline(const Words& w, const Value& value) {
  const FundamentalFamily f = family_of(w);
  const long piece = w.number("piece");
  const auto t = knots_of(w, f, std::labs(piece), value);
  const auto v = fundamental_values(t, f, value(w("at")), piece);
  Indexed r;
  for (size_t i = 0; i < v.size(); ++i) r[t.first_vertex() + static_cast<long>(i)] = v[i];
  return r;
}

Indexed coefficients(const Words& w, const Value& value) {
  const FundamentalFamily f = family_of(w);
  const auto c = spline_coefficients(knots_of(w, f, 0, value), f, 0);
  Indexed r;
  for (size_t i = 0; i < c.values.size(); ++i) r[c.lowest + static_cast<long>(i)] = c.values[i];
  return r;
}

Indexed rule(const Words& w, const Value& value) {
  const Scheme s = make_scheme(w.first());
  if (is_uniform(s) || s.block != 1 || s.arity != 2) bad_input("a scheme on knots is expected, not", s.id);
  std::vector<std::pair<std::string, Rational>> at;
  for (const auto& [name, x] : w.sample()) at.emplace_back(name, x);
  const auto* phases = &s.phases;
  for (const auto& piece : s.pieces) {
    for (const auto& name : piece.where.variables())
      if (std::none_of(at.begin(), at.end(), [&](const auto& x) { return x.first == name; }))
        bad_input("the rule has pieces, and where lacks", name);
    if (piece.where.evaluate(at).sign() < 0) continue;
    phases = &piece.phases;
    break;
  }
  const Stencil& odd = (*phases)[1];
  Indexed r;
  for (size_t i = 0; i < odd.blocks.size(); ++i) {
    // A value may contain the names of other parameters: they are put aside first.
    RationalFunction c = odd.blocks[i][0];
    const auto names = c.variables();
    for (const auto& name : names) c = c.substitute(name, RationalFunction::variable("at_" + name));
    for (const auto& name : names) c = c.substitute("at_" + name, value(name));
    r[odd.lowest + static_cast<long>(i)] = c;
  }
  return r;
}

Indexed junction_row(const Words& w, const Value& value) {
  const auto j =
      analysis::junction(make_scheme(w.first()), value(w("alpha")), value(w("left")), value(w("right")), w.sample());
  const long row = w.number("row") - j.matrix.lowest;
  const auto size = static_cast<long>(j.matrix.entries.rows());
  if (row < 0 || row >= size) bad_input("the local matrix has no row", w("row"));
  Indexed r;
  for (long c = 0; c < size; ++c)
    r[c + j.matrix.lowest] = j.matrix.entries(static_cast<size_t>(row), static_cast<size_t>(c));
  return r;
}

}  // namespace

std::optional<Indexed> local_definition(const std::string& text, const Value& value) {
  const std::string kind = text.substr(0, text.find(' '));
  if (kind == "knots") return knots(Words(text), value);
  if (kind == "spline") return spline(Words(text), value);
  if (kind == "spline-coefficients") return coefficients(Words(text), value);
  if (kind == "rule") return rule(Words(text), value);
  if (kind == "junction") return junction_row(Words(text), value);
  return std::nullopt;
}

}  // namespace twoscale::reports::audit
