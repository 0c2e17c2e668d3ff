// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/analysis/hermite_claims.hpp"

#include <algorithm>
#include <functional>
#include <map>

#include "twoscale/analysis/certificate.hpp"
#include "twoscale/analysis/hermite.hpp"
#include "twoscale/analysis/positivity.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"
#include "twoscale/symbolic/hermite_circle.hpp"

namespace twoscale::analysis {

namespace {

using Json = nlohmann::ordered_json;
using R = RationalFunction;

R variable(const char* name) { return R::variable(name); }

Json ratio_json(const R& f) {
  return Json::object({{"numerator", f.numerator().to_string()}, {"denominator", f.denominator().to_string()}});
}

// x = tan(sigma/4) from s = tan(sigma/8), and at the mean of two sigma.
R doubled(const R& s) { return R(2) * s / (R(1) - s * s); }
R middle(const R& v, const R& u) { return (u + v) / (R(1) - u * v); }

R at_zero(const R& f, const char* name) { return f.substitute(name, R(0)); }

// B''(y), B = 10 y^3 - 15 y^4 + 6 y^5 (coefficients of y, y^2, y^3).
const std::vector<Rational> bump = {60, -180, 120};

Rational bump_at(const Rational& y) { return y * (bump[0] + y * (bump[1] + y * bump[2])); }

// sum_{n >= 0} B''(2^-n)
Rational bump_series() {
  Rational sum;
  for (std::size_t k = 0; k < bump.size(); ++k)
    sum += bump[k] / (Rational(1) - Rational(1, 2).pow(static_cast<long>(k) + 1));
  return sum;
}

TensionRates derive_rates() {
  const R s = variable("s"), d = variable("d"), w = variable("w");
  const R m = s + d;
  // s_0 = s and its middle m determine s_1: tan(2 M - S).
  const R last = (doubled(m) - s) / (R(1) + doubled(m) * s);
  const auto end = [&](const R& from, const R& to) { return from + w * (to - from); };
  const R left = doubled(s), right = doubled(end(s, last)), centre = middle(s, end(s, last));
  const auto rate = [&](const R& own, const R& half) { return at_zero((own - half) / (half * half), "d"); };
  TensionRates r;
  r.left = rate(doubled(end(s, m)) - left, centre - left);
  r.right = rate(doubled(end(m, last)) - doubled(m), right - centre);
  // p and r are derivatives in t = (1+x)/2: a factor 2.
  r.jump = R(Rational(-2) * bump_series()) * (r.left + r.right);
  r.drift = R(Rational(2) * bump_at(Rational(1, 3))) * (r.left - r.right);
  return r;
}

// The rules of hermite2010 as a certificate speaks of them.
struct Rules {
  HermiteTension tension;
  R w;                 // the scheme's own value
  bool plain;          // w = 1, or tension c2: the end of the interval is s_1
  std::vector<R> old;  // the matrix of an old vertex
};

std::optional<Rules> known_rules(const Scheme& scheme) {
  const auto tension = hermite_tension(scheme);
  if (!tension) return std::nullopt;
  Rational w(1);
  for (const auto& p : scheme.parameters)
    if (p.scope == Parameter::Scope::constant && !p.default_value.empty())
      w = *parse_rational_function(p.default_value).constant();
  return Rules{*tension, R(w), *tension == HermiteTension::c2 || w == Rational(1), scheme.phases[0].blocks.at(0)};
}

Json rules_json(const Rules& rules) {
  const R v = variable("s_0"), u = variable("s_1"), z = variable("z"), w = variable("w");
  const bool c2 = rules.tension == HermiteTension::c2;
  const HermiteRule rule = c2 ? hermite_circle_rule(v, z, w, HermiteTension::c2) : hermite_circle_rule(v, z);
  Json rows = Json::array();
  for (const HermiteForm& row : rule) {
    const CommonDenominator d = common_denominator(row);
    std::vector<std::string> numerators;
    for (const R& x : row) numerators.push_back(numerator_over(x, d).to_string());
    rows.push_back(Json::object({{"numerators", numerators}, {"denominator", d.expanded().to_string()}}));
  }
  Json old = Json::array();
  const std::size_t block = rule.size();
  for (std::size_t h = 0; h < block; ++h) {
    std::vector<std::string> row;
    for (std::size_t i = 0; i < block; ++i) row.push_back(rules.old.at(h * block + i).to_string());
    old.push_back(row);
  }
  return Json::object(
      {{"order", 2}, {"end", ratio_json(rules.plain ? u : v + w * (u - v))}, {"rule", rows}, {"old", old}});
}

Json interpolant_json(const Rules& rules) {
  const R v = variable("s_0"), z = variable("z");
  return Json::object({{"claim", "interpolant"},
                       {"verdict", "proved"},
                       {"nodes", Json::object({{"left", ratio_json(doubled(v))},
                                               {"right", ratio_json(doubled(z))},
                                               {"middle", ratio_json(middle(v, z))}})},
                       {"base", "x^2+1"},
                       {"power", 2},
                       {"degree", 5},
                       {"scale", ratio_json(rules.tension == HermiteTension::c2 ? R(2) / variable("w") : R(2))},
                       {"theorem", "hermite-interpolation"}});
}

Json bezier_json() {
  const R a = variable("a"), b = variable("b");
  const auto weights = hermite_circle_weights(a, b);
  const auto points = hermite_circle_weighted_points(a, b);
  std::vector<R> all(weights.begin(), weights.end());
  for (const auto& p : points) all.insert(all.end(), p.begin(), p.end());
  const CommonDenominator d = common_denominator(all);
  std::vector<std::string> mu;
  for (const R& x : weights) mu.push_back(numerator_over(x, d).to_string());
  Json list = Json::array();
  for (const auto& p : points) {
    std::vector<std::string> row;
    for (const R& x : p) row.push_back(numerator_over(x, d).to_string());
    list.push_back(row);
  }
  // The weights are the Bernstein coefficients of (1+x^2)^2/4.
  return Json::object({{"claim", "bezier-form"},
                       {"verdict", "proved"},
                       {"weights", mu},
                       {"points", list},
                       {"base", "x^2+1"},
                       {"power", 2},
                       {"multiple", (R(d.expanded()) / R(4)).constant()->to_string()},
                       {"scale", "2"},
                       {"theorem", "hermite-interpolation"}});
}

Json halves_json(const Rules& rules) {
  const TensionRates none{};
  const TensionRates& r = rules.plain ? none : tension_rates();
  return Json::object({{"claim", "halves"},
                       {"verdict", "proved"},
                       {"fit", rules.plain ? "yes" : "no"},
                       {"left_rate", ratio_json(r.left)},
                       {"right_rate", ratio_json(r.right)},
                       {"theorem", "definition"}});
}

class Prover {
 public:
  explicit Prover(const Scheme& scheme) : scheme_(scheme), rules_(known_rules(scheme)) {}

  Decision decide(const Claim& claim) {
    Decision d;
    if (claim.name == "interpolatory")
      d = interpolatory();
    else if (claim.name == "spectral")
      d = spectral(claim.subject);
    else if (claim.name == "symmetric")
      d = symmetric();
    else if (!rules_)
      d.witness = "known for the rules of hermite2010 only";
    else if (claim.name == "interpolant")
      d = interpolant();
    else if (claim.name == "positive-weights")
      d = positive_weights();
    else if (claim.name == "circle")
      d = circle();
    else if (claim.name == "curvature")
      d = curvature();
    else
      d = continuity(claim.subject);
    d.claim = claim.name;
    if (d.subject.empty()) d.subject = claim.subject;
    return d;
  }
  const std::optional<Rules>& rules() const { return rules_; }

 private:
  Decision interpolatory() const {
    Decision d;
    d.verdict = Verdict::proved;
    const Stencil& keep = scheme_.phases[0];
    const auto block = static_cast<std::size_t>(scheme_.block);
    std::string factors;  // of the derivatives, if one is not 1: they are carried in a scale that shrinks
    bool scaled = false;
    for (std::size_t i = 0; i < keep.blocks.size(); ++i)
      for (std::size_t e = 0; e < keep.blocks[i].size(); ++e) {
        const R& entry = keep.blocks[i][e];
        const bool own = keep.lowest + static_cast<long>(i) == 0, diagonal = own && e / block == e % block;
        if (diagonal && e > 0) {
          factors += (factors.empty() ? "" : ", ") + entry.to_string();
          scaled = scaled || !entry.is_one();
        }
        if (diagonal ? (e > 0 ? !entry.is_zero() : entry.is_one()) : entry.is_zero()) continue;
        d.verdict = Verdict::refuted;
        d.witness = "an old vertex: row " + std::to_string(e / block) + ", column " + std::to_string(e % block) +
                    " of the vertex at " + std::to_string(keep.lowest + static_cast<long>(i)) + " is " +
                    entry.to_string();
      }
    d.domain = "all data" + (scaled ? "; the derivatives of old vertices are multiplied by " + factors : "");
    if (rules_ && d.verdict == Verdict::proved)
      d.evidence = Json::object({{"claim", "interpolatory"}, {"verdict", "proved"}, {"theorem", "definition"}});
    return d;
  }

  // Reversal of the data: vertex j goes to -j, s to -s, derivatives of odd order change sign. The mask A_i, i = r - m
  // h, has to be that of its mirror image, about the middle of its support; a rule that reads s at the ends of an edge
  // has the vertex 0 there.
  Decision symmetric() const {
    Decision d;
    const Scheme s = with_default_values(scheme_);
    const Parameter* local = nullptr;
    for (const auto& p : s.parameters) {
      if (p.scope != Parameter::Scope::local) continue;
      if (local != nullptr || p.offsets != std::vector<long>{0, 1}) {
        d.witness = "reversal is known for one local parameter, read at the two ends of an edge, not for " + p.name;
        return d;
      }
      local = &p;
    }
    const long m = s.arity;
    std::map<long, const std::vector<R>*> mask;
    for (long r = 0; r < m; ++r) {
      const Stencil& stencil = s.phases[static_cast<std::size_t>(r)];
      for (std::size_t i = 0; i < stencil.blocks.size(); ++i)
        if (const auto& b = stencil.blocks[i]; std::any_of(b.begin(), b.end(), [](const R& x) { return !x.is_zero(); }))
          mask[r - m * (stencil.lowest + static_cast<long>(i))] = &b;
    }
    if (mask.empty()) return d;
    const long twice = mask.begin()->first + mask.rbegin()->first;
    if (local != nullptr && twice != 0) {
      d.witness = "the rules are not centred on the vertex 0 that their local parameters are read from";
      return d;
    }
    const std::string left = local == nullptr ? "" : local_name(local->name, 0);
    const std::string right = local == nullptr ? "" : local_name(local->name, 1);
    const auto reversed = [&](const R& x, bool vertex) {
      if (local == nullptr) return x;
      const R far = -variable((vertex ? local_name(local->name, -1) : right).c_str());
      if (vertex) return x.substitute(right, far).substitute(left, -variable(left.c_str()));
      const char* const aside = "reversed";
      return x.substitute(left, variable(aside)).substitute(right, -variable(left.c_str())).substitute(aside, far);
    };
    const auto block = static_cast<std::size_t>(s.block);
    const std::vector<R> none(block * block);
    for (const auto& [index, entries] : mask) {
      const auto found = mask.find(twice - index);
      const std::vector<R>& others = found == mask.end() ? none : *found->second;
      for (std::size_t e = 0; e < block * block; ++e) {
        const long sign = (e / block + e % block) % 2 == 0 ? 1 : -1;
        const R other = R(sign) * reversed(others[e], index % m == 0);
        if (other == (*entries)[e]) continue;
        d.verdict = Verdict::refuted;
        d.witness = not_mirrored(index, e, (*entries)[e], other, left, right, d.evidence);
        return d;
      }
    }
    d.verdict = Verdict::proved;
    d.domain = "all data" + (local == nullptr ? "" : ", with " + local->name + " -> -" + local->name);
    if (rules_) d.evidence = Json::object({{"claim", "symmetric"}, {"verdict", "proved"}, {"theorem", "definition"}});
    return d;
  }

  // The end of an edge from `from`, so that the tension carries it to `to` at most: below the poles.
  Rational tensed(const Rational& from, const Rational& to) const {
    const Rational w = rules_ ? *rules_->w.constant() : Rational(1);
    return w > Rational(1) ? from + (to - from) / w : to;
  }

  // Two entries that differ, at numbers where they do if they depend on local parameters.
  std::string not_mirrored(long index, std::size_t entry, R own, R other, const std::string& left,
                           const std::string& right, Json& evidence) const {
    const auto block = static_cast<std::size_t>(scheme_.block);
    const std::size_t row = entry / block, derivative = entry % block;
    std::string place;
    const std::pair<Rational, Rational> ends[] = {
        {0, {1, 5}}, {{1, 10}, {1, 3}}, {{-1, 7}, {2, 5}}, {{1, 11}, {3, 13}}};
    if (!left.empty())
      for (const auto& [from, most] : ends) {
        const Rational to = tensed(from, most);
        const R a = own.substitute(left, R(from)).substitute(right, R(to));
        const R b = other.substitute(left, R(from)).substitute(right, R(to));
        if (a == b) continue;
        own = a, other = b;
        place = " at " + left + " = " + from.to_string() + ", " + right + " = " + to.to_string();
        if (rules_ && a.constant() && b.constant())
          evidence =
              Json::object({{"claim", "symmetric"},
                            {"verdict", "refuted"},
                            {"witness", Json::object({{"at", {from.to_string(), to.to_string(), rules_->w.to_string()}},
                                                      {"row", row},
                                                      {"column", 2 * derivative + (index > 0 ? 0U : 1U)},
                                                      {"value", a.to_string()},
                                                      {"mirror", b.to_string()}})},
                            {"theorem", "definition"}});
        break;
      }
    return "the entry of row " + std::to_string(row) + ", column " + std::to_string(derivative) + " of A_" +
           std::to_string(index) + place + " is " + own.to_string() + ", that of the mirror image " + other.to_string();
  }

  Decision spectral(const std::string& subject) const {
    Decision d;
    const SpectralCondition s = spectral_condition(hermite_mask(scheme_));
    const long wanted = subject.empty() ? s.order : Rational::parse(subject).to_long();
    d.subject = std::to_string(wanted);
    d.verdict = s.order >= wanted ? Verdict::proved : s.order == s.searched ? Verdict::undecided : Verdict::refuted;
    d.domain = "the mask for small steps; the derivatives " +
               std::string(s.consistent ? "are those of the limit in one scale" : "are not those of the limit") +
               (s.reproduces ? ", polynomials of degree <= " + std::to_string(s.order) + " are reproduced" : "");
    d.witness = d.verdict == Verdict::proved ? "" : "the largest order is " + std::to_string(s.order);
    if (rules_ && d.verdict == Verdict::proved && s.reproduces && s.scales.size() == 3 && wanted >= 0) {
      Json scales = Json::array();
      for (std::size_t k = 1; k < s.scales.size(); ++k)
        scales.push_back(ratio_json(rules_->tension == HermiteTension::printed && rules_->plain
                                        ? s.scales[k].substitute("w", R(1))
                                        : s.scales[k]));
      d.evidence = Json::object({{"claim", "spectral"},
                                 {"verdict", "proved"},
                                 {"order", wanted},
                                 {"scales", scales},
                                 {"theorem", "definition"}});
    }
    return d;
  }

  Decision interpolant() const {
    Decision d;
    d.verdict = Verdict::proved;
    d.domain = "all data, identically in s_0 and s_1" +
               std::string(rules_->plain ? "" : ", on the interval up to s_0 + w (s_1 - s_0)") +
               "; its denominator is (1 + (2t-1)^2)^2/4 on every edge";
    d.supporting.push_back(bezier_json());
    d.evidence = interpolant_json(*rules_);
    return d;
  }

  Decision positive_weights() const {
    Decision d;
    d.verdict = Verdict::proved;
    d.domain = "alpha in [-1, 1]^2 (sigma in [-pi, pi]); the minima are 1/4, 1/5, 1/5, 1/5, 1/5, 1/4";
    const auto mu = hermite_circle_weights(variable("a"), variable("b"));
    const Box square = {{"a", Rational(-1), Rational(1)}, {"b", Rational(-1), Rational(1)}};
    SignOptions options;
    options.strict = false;
    for (std::size_t k = 0; k < mu.size(); ++k) {
      const bool end = k == 0 || k + 1 == mu.size();
      const R least = mu[k] - R(end ? Rational(1, 4) : Rational(1, 5));
      Box box;
      for (const auto& side : square)
        if (least.numerator().degree(side.name) > 0) box.push_back(side);
      const Positivity sign = decide_sign(least.numerator(), box, options);
      if (sign.verdict != Verdict::proved) {
        d.verdict = sign.verdict;
        d.witness = "mu_" + std::to_string(k) + ": " + sign.reason;
        return d;
      }
      d.supporting.push_back(sign.evidence);
    }
    return d;
  }

  Decision circle() const {
    Decision d;
    const R x = variable("x");
    const R cosine = (R(1) - x * x).pow(2) - R(4) * x * x, sine = R(4) * x * (R(1) - x * x);
    if (rules_->plain) {
      d.verdict = Verdict::proved;
      d.domain = std::string("f, p, r = the derivatives in t of rho (cos sigma, sin sigma), any spacing") +
                 (rules_->tension == HermiteTension::c2 ? ", p and r divided by w and w^2" : "");
      d.supporting = {interpolant_json(*rules_), halves_json(*rules_)};
      d.evidence = Json::object({{"claim", "circle"},
                                 {"verdict", "proved"},
                                 {"cosine", cosine.numerator().to_string()},
                                 {"sine", sine.numerator().to_string()},
                                 {"theorem", "hermite-interpolation"}});
      return d;
    }
    // One step on the data of a circle.
    const R v(Rational(0)), u(tensed(0, Rational(1, 5)));
    const HermiteRule rule = hermite_circle_rule(v, u, rules_->w, HermiteTension::printed);
    const auto derivative = [](const R& f) {
      const Polynomial n = f.numerator(), b = f.denominator();
      return R(2) * R::fraction(n.derivative("x") * b - n * b.derivative("x"), b * b);
    };
    R square;
    for (const R& top : {cosine, sine}) {
      std::vector<R> jet = {top / (R(1) + x * x).pow(2)};
      while (jet.size() < 3) jet.push_back(derivative(jet.back()));
      R value;
      for (std::size_t i = 0; i < 6; ++i) value += rule[0][i] * jet[i / 2].substitute("x", doubled(i % 2 == 0 ? v : u));
      square += value * value;
    }
    d.verdict = square == R(1) ? Verdict::undecided : Verdict::refuted;
    d.witness = "from data of the unit circle at s = 0 and s = " + u.to_string() +
                " comes a point with x^2 + y^2 = " + square.to_string();
    if (d.verdict != Verdict::refuted) return d;
    d.supporting.push_back(interpolant_json(*rules_));
    d.evidence = Json::object({{"claim", "circle"},
                               {"verdict", "refuted"},
                               {"cosine", cosine.numerator().to_string()},
                               {"sine", sine.numerator().to_string()},
                               {"witness", Json::object({{"at", {v.to_string(), u.to_string(), rules_->w.to_string()}},
                                                         {"square", square.to_string()}})},
                               {"theorem", "hermite-interpolation"}});
    return d;
  }

  Decision curvature() const {
    Decision d;
    d.verdict = Verdict::proved;
    d.domain = "where p != 0; at the vertices it is |p x r|/|p|^3 of the data" + below_the_pole();
    d.supporting = {interpolant_json(*rules_), halves_json(*rules_)};
    d.evidence = Json::object({{"claim", "curvature"}, {"verdict", "proved"}, {"theorem", "hermite-halves"}});
    return d;
  }

  Decision continuity(const std::string& subject) const {
    const long l = subject.empty() ? 0 : Rational::parse(subject).to_long();
    if (l < 0 || l > 64) bad_input("continuity: an integer from 0 to 64 is expected", subject);
    Decision d;
    d.subject = std::to_string(l);
    d.supporting = {interpolant_json(*rules_), halves_json(*rules_)};
    if (l <= (rules_->plain ? 2 : 1)) {
      d.verdict = Verdict::proved;
      d.domain = std::string("in t, all data, with c' = ") + (rules_->w == R(1) ? "p" : "w p") +
                 (l < 2               ? ""
                  : rules_->w == R(1) ? ", c'' = r"
                                      : ", c'' = w^2 r") +
                 below_the_pole();
      d.evidence =
          Json::object({{"claim", "continuity"}, {"verdict", "proved"}, {"order", l}, {"theorem", "hermite-halves"}});
      return d;
    }
    d.verdict = Verdict::refuted;
    if (rules_->plain) {
      // c''' at the right end of an edge depends on f at its left end.
      d.supporting.clear();
      const R a = variable("a"), b = variable("b"), x = variable("x");
      const R second = hermite_circle_segment(a, b, x)[2][0];
      const Polynomial n = second.numerator(), q = second.denominator();
      const R third = (R(2) * R::fraction(n.derivative("x") * q - n * q.derivative("x"), q * q)).substitute("x", b);
      d.witness = "the third derivative in t at the end of an edge, a function of its own data, has the coefficient " +
                  third.to_string() + " of the f at its beginning (a, b: alpha there): it jumps at the vertices";
      if (third.is_zero()) d.verdict = Verdict::undecided;
      return d;
    }
    const TensionRates& r = tension_rates();
    d.witness = "r jumps at a vertex by " + r.jump.substitute("w", rules_->w).to_string() +
                " times p, s = tan(sigma/8), and along alternating halves changes by " +
                r.drift.substitute("w", rules_->w).to_string() + " times p in two steps";
    d.evidence =
        Json::object({{"claim", "continuity"},
                      {"verdict", "refuted"},
                      {"order", l},
                      {"witness", Json::object({{"jump", ratio_json(r.jump)}, {"drift", ratio_json(r.drift)}})},
                      {"theorem", "hermite-halves"}});
    return d;
  }

  std::string below_the_pole() const { return rules_->plain ? "" : "; w below the first pole of the data"; }

  const Scheme& scheme_;
  std::optional<Rules> rules_;
};

}  // namespace

const TensionRates& tension_rates() {
  static const TensionRates rates = derive_rates();
  return rates;
}

std::vector<Claim> default_claims_on_vertices(const Scheme& scheme) {
  // Of the printed tension no symmetry is claimed.
  const auto rules = known_rules(scheme);
  std::vector<Claim> claims = {{"interpolatory", "", ""}};
  if (!rules || rules->plain) claims.push_back({"symmetric", "", ""});
  claims.push_back({"spectral", "", ""});
  if (!rules) return claims;
  claims.push_back({"interpolant", "", ""});
  claims.push_back({"positive-weights", "", ""});
  if (rules->plain) claims.push_back({"circle", "", ""});
  if (!rules->plain) claims.push_back({"continuity", "1", ""});
  claims.push_back({"continuity", "2", ""});
  claims.push_back({"curvature", "", ""});
  return claims;
}

Proof prove_on_vertices(const Scheme& scheme, const std::vector<Claim>& claims) {
  static const std::vector<std::string> names = {"interpolatory",    "symmetric", "spectral",   "interpolant",
                                                 "positive-weights", "circle",    "continuity", "curvature"};
  Prover prover(scheme);
  Proof proof;
  std::vector<Json> entries;
  for (const Claim& c : claims) {
    if (std::find(names.begin(), names.end(), c.name) == names.end())
      bad_input(
          "of a scheme of blocks interpolatory, symmetric, spectral, interpolant, positive-weights, circle, continuity "
          "and curvature can be decided, not",
          c.name);
    if (c.name != "continuity" && c.name != "spectral" && !c.subject.empty())
      bad_input(c.name + " takes no subject", c.subject);
    Decision d = prover.decide(c);
    std::vector<Json> own = d.supporting;
    if (!d.evidence.is_null()) own.push_back(d.evidence);
    for (const auto& e : own)
      if (std::find(entries.begin(), entries.end(), e) == entries.end()) entries.push_back(e);
    proof.decisions.push_back(std::move(d));
  }
  if (!entries.empty() && prover.rules())
    proof.certificate = certificate_text(scheme.id, rules_json(*prover.rules()), entries);
  return proof;
}

}  // namespace twoscale::analysis
