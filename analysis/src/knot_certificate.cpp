// SPDX-License-Identifier: GPL-3.0-or-later
#include "knot_certificate.hpp"

#include <algorithm>
#include <map>

#include "twoscale/analysis/certificate.hpp"

namespace twoscale::analysis {

using Json = nlohmann::ordered_json;

namespace {

constexpr std::size_t most_variables = 8;
constexpr std::size_t most_weights = 11;

std::vector<const std::vector<Stencil>*> pieces_of(const Scheme& scheme) {
  std::vector<const std::vector<Stencil>*> all;
  for (const auto& p : scheme.pieces) all.push_back(&p.phases);
  all.push_back(&scheme.phases);
  return all;
}

const Parameter* parameter(const Scheme& scheme, bool edge) {
  for (const auto& p : scheme.parameters)
    if (p.scope == Parameter::Scope::local && p.rest.has_value() == edge) return &p;
  return nullptr;
}

using Values = std::vector<std::pair<std::string, RationalFunction>>;

// The values of the rule's variables for an edge, in the variables of the case.
Values values_at(const Scheme& scheme, const JunctionCase& c, long edge) {
  Values values;
  for (const auto& p : scheme.parameters)
    for (const long offset : p.offsets) {
      const long e = edge + offset;
      RationalFunction value(1);
      if (!p.rest) {
        if (e >= 0) value = RationalFunction::variable("alpha");
      } else {
        value = e == -1 ? RationalFunction(c.left) : e == 0 ? RationalFunction(c.right) : RationalFunction(*p.rest);
      }
      values.emplace_back(local_name(p.name, offset), value);
    }
  return values;
}

// p with the values put in, times a positive number.
Polynomial substituted(const Polynomial& p, const Values& values) {
  RationalFunction f(p);
  for (const auto& [name, value] : values) f = f.substitute(name, value);
  return f.numerator();
}

Box box_of(const Polynomial& p, const Box& box) {
  Box small;
  for (const auto& r : box)
    if (p.degree(r.name) > 0) small.push_back(r);
  return small;
}

std::vector<std::string> zeros_of(const std::vector<std::string>& zeros, const Box& box) {
  std::vector<std::string> result;
  for (const auto& z : zeros)
    if (std::any_of(box.begin(), box.end(), [&](const Range& r) { return z.substr(0, z.find('=')) == r.name; }))
      result.push_back(z);
  return result;
}

std::optional<PositivityProof> positive(const Polynomial& p, const Box& box, const std::vector<std::string>& zeros,
                                        bool strict) {
  SignOptions options;
  options.strict = strict;
  const Box small = box_of(p, box);
  if (strict) options.zeros = zeros_of(zeros, small);
  const Positivity s = decide_sign(p, small, options);
  if (s.verdict != Verdict::proved) return std::nullopt;
  return s.proof;
}

Json proof_json(const PositivityProof& p) { return Json::object({{"method", p.method}, {"tree", p.tree}}); }

Polynomial primitive(const Polynomial& p) {
  return p.scaled((p.leading_sign() < 0 ? -p.content() : p.content()).inverse());
}

// The middle of the box, one beyond the end of a half-line.
std::vector<std::pair<std::string, Rational>> inside(const Box& box) {
  std::vector<std::pair<std::string, Rational>> at;
  for (const auto& r : box) at.emplace_back(r.name, r.high ? (r.low + *r.high) * Rational(1, 2) : r.low + Rational(1));
  return at;
}

// The piece of an edge, and why it holds on the box; null where that cannot be shown.
Json piece_json(const Scheme& scheme, const JunctionCase& c, const Values& values, long edge, std::size_t& piece) {
  std::vector<Polynomial> where;
  bool varies = false;
  for (const auto& p : scheme.pieces) {
    where.push_back(substituted(p.where, values));
    varies = varies || !where.back().is_constant();
  }
  piece = scheme.pieces.size();
  const auto middle = inside(c.box);
  for (std::size_t i = where.size(); i-- > 0;)
    if (where[i].evaluate(middle).sign() >= 0) piece = i;
  if (!varies) return Json::array();  // nothing to show
  Json j;
  j["edge"] = edge;
  j["piece"] = piece;
  j["conditions"] = Json::array();
  for (std::size_t i = 0; i <= piece && i < where.size(); ++i) {
    // Where the condition of an earlier piece is 0 on the box, the pieces must agree; the checker looks.
    bool strict = i < piece;
    const Polynomial sign = i < piece ? -where[i] : where[i];
    auto proof = positive(sign, c.box, c.zeros, strict);
    if (!proof && strict) proof = positive(sign, c.box, c.zeros, strict = false);
    if (!proof) return nullptr;
    Json condition;
    condition["strict"] = strict ? "yes" : "no";
    condition["method"] = proof->method;
    condition["tree"] = proof->tree;
    j["conditions"].push_back(std::move(condition));
  }
  return j;
}

}  // namespace

Json knot_rule_json(const Scheme& scheme) {
  const Parameter *interval = parameter(scheme, false), *edge = parameter(scheme, true);
  std::vector<std::string> names;
  for (const auto& p : scheme.parameters)
    for (const long offset : p.offsets) names.push_back(local_name(p.name, offset));
  std::sort(names.begin(), names.end());
  const Stencil& odd = scheme.phases[1];
  if (interval == nullptr || names.size() > most_variables || odd.blocks.size() > most_weights) return nullptr;
  Json j;
  j["interval"] = interval->name;
  j["edge"] = edge == nullptr ? "" : edge->name;
  j["rest"] = edge == nullptr ? "" : edge->rest->to_string();
  j["variables"] = names;
  j["lowest"] = odd.lowest;
  j["pieces"] = Json::array();
  const auto pieces = pieces_of(scheme);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Json piece;
    piece["where"] = i < scheme.pieces.size() ? scheme.pieces[i].where.to_string() : "";
    piece["weights"] = Json::array();
    for (const auto& block : (*pieces[i])[1].blocks) {
      const RationalFunction& c = block[0];
      std::vector<std::string> denominator;
      if (!(c.denominator_content() == Rational(1))) denominator.push_back(c.denominator_content().to_string());
      for (const auto& [factor, exponent] : c.denominator_factors())
        for (unsigned e = 0; e < exponent; ++e) denominator.push_back(factor.to_string());
      piece["weights"].push_back(
          Json::object({{"numerator", c.numerator().to_string()}, {"denominator", denominator}}));
    }
    j["pieces"].push_back(std::move(piece));
  }
  return j;
}

Json junction_entry(const Scheme& scheme, const JunctionCase& c, long l) {
  Json e;
  e["claim"] = "junction";
  e["verdict"] = "proved";
  Box sorted = c.box;
  std::sort(sorted.begin(), sorted.end(), [](const Range& x, const Range& y) { return x.name < y.name; });
  e["variables"] = Json::array();
  e["box"] = Json::array();
  for (const auto& r : sorted) {
    e["variables"].push_back(r.name);
    e["box"].push_back(Json::array({r.low.to_string(), r.high ? r.high->to_string() : ""}));
  }
  std::vector<std::string> zeros = c.zeros;
  std::sort(zeros.begin(), zeros.end());
  e["zeros"] = zeros;
  e["ratio"] = "alpha";
  if (parameter(scheme, true) != nullptr) {
    e["left"] = c.left.to_string();
    e["right"] = c.right.to_string();
  }
  // Pieces and denominators, row by row.
  e["pieces"] = Json::array();
  std::map<std::string, Polynomial> denominators;
  const auto pieces = pieces_of(scheme);
  const Stencil& odd = scheme.phases[1];
  const long highest = odd.lowest + static_cast<long>(odd.blocks.size()) - 1;
  const long reach = std::max(1 - 2 * odd.lowest, 2 * highest - 1);
  for (long row = -reach; row <= reach; row += 2) {
    const long edge = (row - 1) / 2;
    const Values values = values_at(scheme, c, edge);
    std::size_t piece = 0;
    Json shown = piece_json(scheme, c, values, edge, piece);
    if (shown.is_null()) return nullptr;
    if (!shown.empty()) e["pieces"].push_back(std::move(shown));
    for (const auto& block : (*pieces[piece])[1].blocks)
      for (const auto& [factor, exponent] : block[0].denominator_factors()) {
        const Polynomial p = substituted(factor, values);
        if (p.is_zero()) return nullptr;
        if (p.is_constant()) continue;
        const Polynomial q = primitive(p);
        const Polynomial turned = q.evaluate(inside(c.box)).sign() < 0 ? -q : q;
        denominators.emplace(turned.to_string(), turned);
      }
  }
  e["denominators"] = Json::array();
  for (const auto& [text, p] : denominators) {
    const auto proof = positive(p, c.box, c.zeros, true);
    if (!proof) return nullptr;
    Json d;
    d["polynomial"] = text;
    d.update(proof_json(*proof));
    e["denominators"].push_back(std::move(d));
  }
  e["kept"] = c.kept;
  e["order"] = l;
  e["factors"] = Json::array();
  const auto open =
      std::count_if(c.bounds.begin(), c.bounds.end(), [](const RootBound& b) { return b.verdict != Verdict::proved; });
  // Where the boundary is nowhere positive there is nothing to claim.
  if (open > 1 || (open == 1 && (!c.boundary || (-*c.boundary).all_coefficients_nonnegative()))) return nullptr;
  for (std::size_t i = 0; i < c.bounds.size(); ++i) {
    const RootBound& b = c.bounds[i];
    Json f;
    f["polynomial"] = b.polynomial.to_string();
    f["multiplicity"] = c.multiplicities[i];
    f["conditions"] = Json::array();
    if (b.verdict == Verdict::proved) {
      for (const auto& p : b.proofs) f["conditions"].push_back(proof_json(p));
    } else {
      for (const auto& [p, sign] : c.conditions)
        f["conditions"].push_back(sign.verdict == Verdict::proved
                                      ? proof_json(sign.proof)
                                      : Json::object({{"method", "restriction"}, {"tree", p.to_string()}}));
    }
    e["factors"].push_back(std::move(f));
  }
  e["theorem"] = "schur-cohn";
  return e;
}

Json junction_counterexample(const Scheme& scheme, const Rational& alpha, const Rational& left, const Rational& right,
                             long kept, long l) {
  Json e;
  e["claim"] = "junction";
  e["verdict"] = "refuted";
  e["ratio"] = alpha.to_string();
  if (parameter(scheme, true) != nullptr) {
    e["left"] = left.to_string();
    e["right"] = right.to_string();
  }
  e["kept"] = kept;
  e["order"] = l;
  e["theorem"] = "schur-cohn";
  return e;
}

}  // namespace twoscale::analysis
