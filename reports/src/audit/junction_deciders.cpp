// SPDX-License-Identifier: GPL-3.0-or-later
// Deciders about the local matrices of schemes on knots at the vertices of the data.
#include <algorithm>
#include <set>

#include "audit/arguments.hpp"
#include "twoscale/analysis/knots.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::reports::audit {

namespace {

using Answer = analysis::Verdict;

struct Place {
  RationalFunction alpha, left, right;
};

// "alpha=1,left=3/4,right=1/8".
Place place_of(const std::string& text) {
  Place p{1, Rational(1, 2), Rational(1, 2)};
  for (const auto& piece : split_list(text)) {
    const size_t equals = piece.find('=');
    const std::string name = trimmed(piece.substr(0, equals));
    RationalFunction* value = name == "alpha"   ? &p.alpha
                              : name == "left"  ? &p.left
                              : name == "right" ? &p.right
                                                : nullptr;
    if (equals == std::string::npos || value == nullptr) bad_input("alpha=, left= or right= is expected, not", piece);
    *value = parse_rational_function(piece.substr(equals + 1));
  }
  return p;
}

// At one point: the exact Schur-Cohn test of the eigenvalues that are not 2^-n, n < the order of the junction.
Outcome at_point(const Scheme& s, const std::string& text, const Rational& radius) {
  const Place p = place_of(text);
  const auto j = analysis::junction(s, p.alpha, p.left, p.right);
  const auto m = analysis::constant(analysis::divided_difference_matrix(j));
  if (!m) bad_input("numbers are expected in", text);
  std::vector<Rational> c = analysis::characteristic_polynomial(*m);
  Rational g;
  for (const auto& x : c) g = gcd(g, x);
  for (auto& x : c) x /= g;
  std::string shown = text + ": the eigenvalues are ";
  bool first = true;
  for (const auto& e : analysis::spectrum(j).eigenvalues) {
    shown += (first ? "" : ", ") + (e.exact.empty() || e.exact.size() > 24 ? e.decimal : e.exact);
    first = false;
  }
  return {analysis::roots_inside(Polynomial::univariate("z", c), radius) ? Answer::proved : Answer::refuted, shown};
}

}  // namespace

Outcome decide_at_junctions(const Arguments& a) {
  return over_cases(a, [&](const Counters& c) {
    const Scheme s = make_scheme(expanded(text_at(a, "scheme"), c));
    const long order = integer(text_at(a, "order"), c);
    const Rational radius = Rational(2).pow(-order);
    std::string shown;
    for (const auto& text : list_at(a, "at")) {
      const Outcome o = at_point(s, expanded(text, c), radius);
      if (o.verdict != Answer::proved) return o;
      shown += (shown.empty() ? "at " : "; at ") + o.evidence;
    }
    if (!shown.empty()) return Outcome{Answer::proved, shown};
    const analysis::Decision d = analysis::decide_junction(s, order).decision;
    if (d.verdict == Answer::undecided) return Outcome{d.verdict, d.witness};
    const std::set<std::string> expected(list_at(a, "except").begin(), list_at(a, "except").end());
    const std::set<std::string> found(d.exceptions.begin(), d.exceptions.end());
    shown = s.id + ": all eigenvalues but 1, .., 2^-" + std::to_string(order) + " are smaller than " +
            radius.to_string() + " for " + d.domain;
    if (!d.exceptions.empty()) shown += ", except " + joined(d.exceptions, "; ");
    if (expected == found) return Outcome{Answer::proved, shown};
    return Outcome{Answer::refuted, d.witness.empty() ? shown : d.witness + "; " + shown};
  });
}

Outcome decide_eigenvalues(const Arguments& a) {
  return over_cases(a, [&](const Counters& c) {
    const auto value = [&](const char* key) { return parse_rational_function(expanded(text_at(a, key), c)); };
    const auto j = analysis::junction(make_scheme(expanded(text_at(a, "scheme"), c)), value("alpha"), value("left"),
                                      value("right"), {{"alpha", 1}});
    std::set<std::string> expected, found;
    for (const auto& text : list_at(a, "eigenvalues")) expected.insert(trimmed(text));
    for (const auto& f : analysis::spectrum(j).factors)
      found.insert((f.degree() == 1 ? (-f.polynomial[0]).to_string() : analysis::polynomial_text(f.polynomial, "x")) +
                   " " + std::to_string(f.multiplicity) + " " + std::to_string(f.geometric));
    std::string shown = "eigenvalue, multiplicity, number of eigenvectors: ";
    shown += joined({found.begin(), found.end()}, "; ");
    return Outcome{expected == found ? Answer::proved : Answer::refuted, shown};
  });
}

}  // namespace twoscale::reports::audit
