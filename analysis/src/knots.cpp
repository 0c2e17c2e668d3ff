// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/analysis/knots.hpp"

#include <algorithm>

#include "knot_certificate.hpp"
#include "twoscale/analysis/certificate.hpp"
#include "twoscale/analysis/regularity.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::analysis {

namespace {

const Rational half(1, 2);

Polynomial variable(const std::string& name) { return Polynomial::variable(name); }

bool has_edge_parameters(const Scheme& scheme) {
  return std::any_of(scheme.parameters.begin(), scheme.parameters.end(),
                     [](const auto& p) { return p.rest.has_value(); });
}

// Cleared of denominators.
Polynomial cleared(const SpectralPolynomial& p) {
  const CommonDenominator d = common_denominator(p);
  Polynomial r;
  for (std::size_t i = 0; i < p.size(); ++i) r += numerator_over(p[i], d) * variable("z").pow(static_cast<unsigned>(i));
  return r;
}

// The characteristic polynomial of the divided differences.
struct Factors {
  std::vector<Polynomial> list;
  std::vector<unsigned> multiplicities;
  long kept = 0;
};

Factors factors_at(const Scheme& scheme, const RationalFunction& left, const RationalFunction& right,
                   const std::map<std::string, Rational>& sample) {
  const Junction j = junction(scheme, RationalFunction::variable("alpha"), left, right, sample);
  Factors r;
  r.kept = j.order;
  for (const auto& block : characteristic_blocks(divided_difference_matrix(j))) {
    Polynomial p = cleared(block);
    if (p.degree("z") < 1) continue;
    p = p.scaled(p.content().inverse());
    const auto known = std::find(r.list.begin(), r.list.end(), p);
    if (known != r.list.end()) {
      ++r.multiplicities[static_cast<std::size_t>(known - r.list.begin())];
      continue;
    }
    r.list.push_back(p);
    r.multiplicities.push_back(1);
  }
  return r;
}

Polynomial primitive(const Polynomial& p) { return p.is_zero() ? p : p.scaled(p.content().inverse()); }

// Without the powers of the variable that divide all of it.
Polynomial without(const Polynomial& p, const std::string& name) { return p.remove(variable(name)).first; }

// Coefficients of p(radius y), cleared of the radius' denominator.
std::vector<Polynomial> scaled_coefficients(const Polynomial& p, const Rational& radius) {
  std::vector<Polynomial> c = coefficients_in(p, "z");
  const Polynomial numerator = Polynomial::constant(radius.numerator());
  const Polynomial denominator = Polynomial::constant(radius.denominator());
  for (std::size_t i = 0; i < c.size(); ++i)
    c[i] = c[i] * numerator.pow(static_cast<unsigned>(i)) * denominator.pow(static_cast<unsigned>(c.size() - 1 - i));
  return c;
}

Polynomial sum(const std::vector<Polynomial>& list) {
  Polynomial r;
  for (const auto& p : list) r += p;
  return r;
}

JunctionCase decide_case(JunctionCase c, const Rational& radius) {
  SignOptions options;
  for (const auto& f : c.factors) {
    Box box;
    for (const auto& r : c.box)
      if (f.degree(r.name) > 0) box.push_back(r);
    options.zeros.clear();
    for (const auto& z : c.zeros)
      if (std::any_of(box.begin(), box.end(), [&](const auto& r) { return z.substr(0, z.find('=')) == r.name; }))
        options.zeros.push_back(z);
    RootBound b = all_roots_inside(f, "z", radius, box, options);
    if (b.verdict != Verdict::proved) {
      const std::vector<Polynomial> scaled = scaled_coefficients(b.polynomial, radius);
      const Polynomial at_radius = primitive(sum(scaled));
      bool others = !box.empty();
      for (const auto& condition : scaled.size() <= 4 ? jury_conditions(scaled) : lienard_chipart_conditions(scaled)) {
        const bool value = primitive(condition) == at_radius;
        Positivity sign = value ? Positivity{} : decide_sign(primitive(condition), box, options);
        others = others && (value || sign.verdict == Verdict::proved);
        c.conditions.emplace_back(primitive(condition), std::move(sign));
      }
      if (others) {
        const Polynomial plain = primitive(sum(scaled_coefficients(c.plain[c.bounds.size()], radius)));
        c.boundary = b.polynomial == f ? plain : -plain;
      }
    }
    c.bounds.push_back(std::move(b));
  }
  return c;
}

JunctionCase make_case(std::string domain, std::optional<std::string> chart, Box box, const Polynomial& left,
                       const Polynomial& right, const Factors& plain, const std::vector<Polynomial>& in_chart = {}) {
  JunctionCase c;
  c.domain = std::move(domain);
  c.chart = std::move(chart);
  c.box = std::move(box);
  c.zeros = {"alpha=lo"};
  if (c.chart) c.zeros.push_back(*c.chart == "q = k*s" ? "k=lo" : "q=lo");
  c.left = left;
  c.right = right;
  c.kept = plain.kept;
  c.plain = plain.list;
  c.multiplicities = plain.multiplicities;
  c.factors = c.chart ? in_chart : plain.list;
  return c;
}

std::vector<JunctionCase> cases_of(const Scheme& scheme) {
  std::vector<JunctionCase> list;
  const Range alpha{"alpha", 0};
  if (!has_edge_parameters(scheme)) {
    list.push_back(make_case("alpha > 0", std::nullopt, {alpha}, 0, 0, factors_at(scheme, half, half, {{"alpha", 1}})));
    return list;
  }
  const Polynomial k = variable("k"), q = variable("q"), s = variable("s"), one(1);
  for (const bool small_k : {false, true})
    for (const bool small_q : {true, false}) {
      const std::map<std::string, Rational> sample = {{"alpha", 1},
                                                      {"k", small_k ? Rational(1, 4) : Rational(3, 4)},
                                                      {"q", small_q ? Rational(1, 4) : Rational(3, 4)}};
      const Factors factors = factors_at(scheme, one - k, q, sample);
      const auto side = [](const char* name, bool small) {
        return small ? Range{name, 0, half} : Range{name, half, Rational(1)};
      };
      if (!(small_k && small_q)) {
        list.push_back(make_case(std::string(small_k ? "0 <= k <= 1/2" : "1/2 <= k <= 1") +
                                     (small_q ? ", 0 <= q <= 1/2" : ", 1/2 <= q <= 1"),
                                 std::nullopt, {alpha, side("k", small_k), side("q", small_q)}, one - k, q, factors));
        continue;
      }
      // Beside the crease k = q = 0, where everything may vanish: two charts, and the crease itself.
      const Range ratio{"s", 0, Rational(1)};
      std::vector<Polynomial> first, second;
      for (const auto& f : factors.list) {
        first.push_back(without(f.substitute("q", k * s), "k"));
        second.push_back(without(f.substitute("k", q * s), "q"));
      }
      list.push_back(make_case("0 < k <= 1/2, 0 <= q <= k", "q = k*s", {alpha, side("k", true), ratio}, one - k, k * s,
                               factors, first));
      list.push_back(make_case("0 < q <= 1/2, 0 <= k <= q", "k = q*s", {alpha, side("q", true), ratio}, one - q * s, q,
                               factors, second));
      list.push_back(make_case("k = q = 0", std::nullopt, {alpha}, one, 0, factors_at(scheme, 1, 0, {{"alpha", 1}})));
    }
  return list;
}

// A point of a case.
struct PlaceOfCase {
  Rational alpha, left, right;
};
PlaceOfCase place_of(const JunctionCase& c, const BoxPoint& at) {
  BoxPoint all = at;  // variables on which nothing depends: anywhere inside
  for (const auto& r : c.box)
    if (std::none_of(at.begin(), at.end(), [&](const auto& x) { return x.first == r.name; }))
      all.emplace_back(r.name, r.high ? (r.low + *r.high) * half : r.low + Rational(1));
  PlaceOfCase p{1, c.left.evaluate(all), c.right.evaluate(all)};
  for (const auto& [name, value] : all)
    if (name == "alpha") p.alpha = value;
  return p;
}

bool is_identity(const Stencil& s) {
  for (std::size_t i = 0; i < s.blocks.size(); ++i)
    if (!(s.blocks[i][0] == RationalFunction(s.lowest + static_cast<long>(i) == 0 ? 1 : 0))) return false;
  return true;
}

// x^e at the knots of the edge 0, x_0 = 0, blended by the rule, minus its value in the middle: 0 as a rational
// function.
bool reproduces_power(const Scheme& scheme, const Stencil& odd, unsigned e) {
  std::string interval;
  for (const auto& p : scheme.parameters)
    if (p.scope == Parameter::Scope::local && !p.rest) interval = p.name;
  const auto d = [&](long offset) { return RationalFunction::variable(local_name(interval, offset)); };
  RationalFunction sum;
  for (std::size_t i = 0; i < odd.blocks.size(); ++i) {
    const long j = odd.lowest + static_cast<long>(i);
    RationalFunction x;
    for (long k = 0; k < j; ++k) x += d(k);
    for (long k = j; k < 0; ++k) x -= d(k);
    sum += odd.blocks[i][0] * x.pow(e);
  }
  return sum == (d(0) * RationalFunction(half)).pow(e);
}

// All polynomials of the space; -1 if it is not {1, .., x^n}.
long polynomial_degree(const std::string& subject) {
  const Space space = Space::parse(subject);
  for (long n = 0; n <= 64; ++n)
    if (Space::one_frequency(static_cast<unsigned>(n + 1), {}).to_string() == space.to_string()) return n;
  return -1;
}

// Is every power up to x^degree reproduced by all pieces? Otherwise the first that is not.
std::optional<long> first_power_lost(const Scheme& scheme, long degree) {
  std::vector<const std::vector<Stencil>*> all{&scheme.phases};
  for (const auto& piece : scheme.pieces) all.push_back(&piece.phases);
  for (long e = 0; e <= degree; ++e)
    for (const auto* phases : all)
      if (!reproduces_power(scheme, (*phases)[1], static_cast<unsigned>(e))) return e;
  return std::nullopt;
}

nlohmann::ordered_json reproduction_entry(long degree) {
  nlohmann::ordered_json e;
  e["claim"] = "knots-reproduces";
  e["verdict"] = "proved";
  e["degree"] = degree;
  e["theorem"] = "definition";
  return e;
}

Decision decide_reproduction(const Scheme& scheme, const std::string& subject) {
  Decision d;
  d.claim = "reproduces";
  d.subject = subject;
  d.domain = "all knots and edge parameters";
  const long degree = polynomial_degree(subject);
  if (degree < 0) bad_input("on arbitrary knots only polynomials 1, x, .., x^n can be asked for", subject);
  const auto lost = first_power_lost(scheme, degree);
  d.verdict = lost ? Verdict::refuted : Verdict::proved;
  if (lost)
    d.witness = "x^" + std::to_string(*lost) + " on arbitrary knots";
  else
    d.supporting.push_back(reproduction_entry(degree));
  return d;
}

// The smallest interval of vertices of the data, for all knots and edge parameters, outside of which the limit of the
// data 1 at x_0 and 0 elsewhere vanishes: points -l..h that are not 0 make points -(2l + 2 highest - 1)..2h + 1 - 2
// lowest of the next level, so that after k steps they end at (2^k - 1)(1 - 2 highest) and (2^k - 1)(1 - 2 lowest). On
// equal knots the ends are attained where the mask has this support: its first and last coefficients are not 0.
Decision decide_support(const Scheme& scheme, const Scheme& uniform, const std::string& subject) {
  Decision d;
  d.claim = "support";
  d.subject = subject;
  d.domain = "all knots and edge parameters, in vertices of the data, attained on equal knots";
  const std::size_t dots = subject.find("..");
  if (dots == std::string::npos) bad_input("a support a..b is expected, not", subject);
  const long from = Rational::parse(subject.substr(0, dots)).to_long();
  const long to = Rational::parse(subject.substr(dots + 2)).to_long();
  long lowest = 0, highest = 0;
  const auto read = [&](const std::vector<Stencil>& phases) {
    const Stencil& odd = phases[1];
    lowest = std::min(lowest, odd.lowest);
    highest = std::max(highest, odd.lowest + static_cast<long>(odd.blocks.size()) - 1);
  };
  read(scheme.phases);
  for (const auto& piece : scheme.pieces) read(piece.phases);
  const Laurent mask = symbol(uniform);
  if (mask.lowest() != 1 - 2 * highest || mask.highest() != 1 - 2 * lowest) {
    d.witness = "the mask on equal knots is shorter than the rule";
    return d;
  }
  const bool same = from == mask.lowest() && to == mask.highest();
  d.verdict = same ? Verdict::proved : Verdict::refuted;
  if (!same) {
    d.witness = "it is " + std::to_string(mask.lowest()) + ".." + std::to_string(mask.highest());
    return d;
  }
  nlohmann::ordered_json e;
  e["claim"] = "knots-support";
  e["verdict"] = "proved";
  e["support"] = {from, to};
  e["theorem"] = "compact-support";
  d.supporting.push_back(std::move(e));
  return d;
}

// The order that a claim `continuity` names.
long smoothness_order(const std::string& subject) { return subject.empty() ? 0 : Rational::parse(subject).to_long(); }

}  // namespace

namespace {

// C^l at the vertices and between them: the decision, with the entries that together establish it.
Decision decide_smoothness(const Scheme& scheme, const Scheme& uniform, long l, bool bound_to_rule) {
  JunctionVerdict v = decide_junction(scheme, l);
  Decision d = std::move(v.decision);
  const Decision between = decide_continuity(uniform, l, {});
  d.supporting.insert(d.supporting.end(), between.supporting.begin(), between.supporting.end());
  if (!between.evidence.is_null()) d.supporting.push_back(between.evidence);
  if (between.verdict != Verdict::proved && d.verdict != Verdict::refuted) {
    d.verdict = between.verdict;
    d.witness = "equal knots, " + uniform.id + (between.witness.empty() ? "" : ": " + between.witness);
  }
  if (!bound_to_rule || between.verdict != Verdict::proved) return d;
  // What the theorem needs: precision before, the conclusion after the rest.
  const auto lost = first_power_lost(scheme, v.cases.front().kept - 1);
  const long degree = lost ? *lost - 1 : v.cases.front().kept - 1;
  if (degree < l) {
    if (d.verdict == Verdict::proved) d.verdict = Verdict::undecided;
    d.witness = "x^" + std::to_string(*lost) + " is not reproduced on all knots";
    return d;
  }
  d.supporting.insert(d.supporting.begin(), reproduction_entry(degree));
  const auto names = [&](const char* claim, const char* verdict) {
    return [=](const nlohmann::ordered_json& e) { return e["claim"] == claim && e["verdict"] == verdict; };
  };
  const auto& list = d.supporting;
  const auto radius = std::find_if(list.begin(), list.end(), [](const auto& e) {
    return e["claim"] == "jsr-upper" || e["claim"] == "jsr-exact" || e["claim"] == "nonnegative-symbol";
  });
  if (radius == list.end() || std::none_of(list.begin(), list.end(), names("junction", "proved"))) return d;
  nlohmann::ordered_json e;
  e["claim"] = "knots-continuity";
  e["verdict"] = "proved";
  e["order"] = l;
  e["sum_rules"] = (*radius)["order"];
  // The only exception that a proof leaves is the crease.
  e["parameters"] = d.verdict != Verdict::proved ? "claims" : d.exceptions.empty() ? "all" : "all-but-crease";
  e["theorem"] = "piecewise-uniform";
  d.supporting.push_back(std::move(e));
  return d;
}

}  // namespace

Proof prove_on_knots(const Scheme& scheme, const std::vector<Claim>& claims) {
  Proof proof;
  std::vector<nlohmann::ordered_json> entries;
  const Scheme uniform = uniform_member(scheme);
  const nlohmann::ordered_json rule = knot_rule_json(scheme);
  for (const auto& c : claims) {
    Decision d;
    if (c.name == "interpolatory") {
      d.verdict = is_identity(scheme.phases[0]) ? Verdict::proved : Verdict::refuted;
      for (const auto& piece : scheme.pieces)
        if (!is_identity(piece.phases[0])) d.verdict = Verdict::refuted;
      d.claim = c.name;
      d.domain = "all knots and edge parameters";
      if (d.verdict == Verdict::proved)
        d.supporting.push_back({{"claim", "interpolatory"}, {"verdict", "proved"}, {"theorem", "definition"}});
    } else if (c.name == "reproduces") {
      d = decide_reproduction(scheme, c.subject);
    } else if (c.name == "support") {
      d = decide_support(scheme, uniform, c.subject);
    } else if (c.name == "continuity") {
      d = decide_smoothness(scheme, uniform, smoothness_order(c.subject), !rule.is_null());
    } else {
      bad_input("on arbitrary knots interpolatory, reproduces, support and continuity can be decided, not", c.name);
    }
    for (const auto& e : d.supporting) {
      const bool about_rule = e["claim"] == "knots-reproduces" || e["claim"] == "knots-support";
      if (about_rule && rule.is_null()) continue;  // the format does not hold the rule
      if (std::find(entries.begin(), entries.end(), e) == entries.end()) entries.push_back(e);
    }
    proof.decisions.push_back(std::move(d));
  }
  if (!entries.empty()) {
    Scheme subject = uniform;
    subject.id = scheme.id;
    proof.certificate = certificate_text(subject, mask_data(uniform), entries, rule);
  }
  return proof;
}

SymbolicMatrix divided_difference_matrix(const Junction& j) {
  const auto size = static_cast<long>(j.matrix.entries.rows());
  const long order = j.order;
  const auto x = [&](long i) { return j.knots[static_cast<std::size_t>(i)]; };
  const auto columns = static_cast<std::size_t>(size - order);
  SymbolicMatrix r(columns, columns);
  for (long c = 0; c < size - order; ++c) {
    // The data with divided difference 1 at c, 0 elsewhere, and 0 at the first `order` points.
    std::vector<RationalFunction> u(columns);
    u[static_cast<std::size_t>(c)] = 1;
    for (long k = order; k >= 1; --k) {
      std::vector<RationalFunction> integral(u.size() + 1);
      for (std::size_t i = 0; i < u.size(); ++i)
        integral[i + 1] =
            u[i].is_zero() ? integral[i] : integral[i] + u[i] * (x(static_cast<long>(i) + k) - x(static_cast<long>(i)));
      u = std::move(integral);
    }
    u = product(j.matrix.entries, u);
    for (long k = 1; k <= order; ++k) {
      for (std::size_t i = 0; i + 1 < u.size(); ++i)
        u[i] = (u[i + 1] - u[i]) / (x(static_cast<long>(i) + k) - x(static_cast<long>(i)));
      u.pop_back();
    }
    for (std::size_t i = 0; i < columns; ++i) r(i, static_cast<std::size_t>(c)) = u[i];
  }
  return r;
}

JunctionVerdict decide_junction(const Scheme& scheme, long l) {
  if (l < 0 || l > 16) bad_input("an order of smoothness from 0 to 16 is expected", std::to_string(l));
  JunctionVerdict v;
  Decision& d = v.decision;
  d.claim = "continuity";
  d.subject = std::to_string(l);
  d.domain = "the vertices of the data, all knot intervals > 0";
  if (has_edge_parameters(scheme)) d.domain += " and edge parameters in [0, 1] (k = 1 - lambda_{i-1}, q = lambda_i)";
  d.verdict = Verdict::proved;
  const Rational radius = Rational(2).pow(-l);
  const bool bound_to_rule = !knot_rule_json(scheme).is_null();
  for (JunctionCase& open : cases_of(scheme)) {
    JunctionCase c = decide_case(std::move(open), radius);
    if (bound_to_rule) {
      const nlohmann::ordered_json entry = junction_entry(scheme, c, l);
      if (!entry.is_null()) d.supporting.push_back(entry);
    }
    for (std::size_t i = 0; i < c.bounds.size(); ++i) {
      const RootBound& b = c.bounds[i];
      if (!bound_to_rule && !b.evidence.is_null()) d.supporting.push_back(b.evidence);
      if (b.verdict == Verdict::proved) continue;
      if (bound_to_rule && b.point) {
        const PlaceOfCase p = place_of(c, *b.point);
        d.supporting.push_back(junction_counterexample(scheme, p.alpha, p.left, p.right, c.kept, l));
      }
      for (const auto& [p, sign] : c.conditions)
        if (!bound_to_rule && !sign.evidence.is_null()) d.supporting.push_back(sign.evidence);
      if (c.domain == "k = q = 0" && b.verdict == Verdict::refuted && d.verdict == Verdict::proved) {
        d.exceptions.push_back("lambda_{i-1} = 1, lambda_i = 0 (crease): an eigenvalue >= " + radius.to_string());
        continue;
      }
      if (b.verdict == Verdict::undecided) {
        if (d.verdict == Verdict::proved) d.verdict = Verdict::undecided;
        if (d.witness.empty()) d.witness = c.domain + ": " + b.reason;
        continue;
      }
      if (d.verdict != Verdict::refuted && b.point) {
        d.verdict = Verdict::refuted;
        const PlaceOfCase p = place_of(c, *b.point);
        d.witness = "alpha = " + p.alpha.to_string();
        if (has_edge_parameters(scheme))
          d.witness += ", lambda = [" + p.left.to_string() + ", " + p.right.to_string() + "]";
        d.witness += ": an eigenvalue >= " + radius.to_string();
      }
      if (c.boundary) {
        const std::string where = !has_edge_parameters(scheme) ? "all intervals"
                                  : c.domain == "k = q = 0"    ? "lambda_{i-1} = 1, lambda_i = 0"
                                                               : "k, q <= 1/2";
        const std::string text = where + " where not " + c.boundary->to_string() + " > 0";
        if (std::find(d.exceptions.begin(), d.exceptions.end(), text) == d.exceptions.end())
          d.exceptions.push_back(text);
      }
    }
    v.cases.push_back(std::move(c));
  }
  return v;
}

Scheme uniform_member(const Scheme& scheme) {
  if (is_uniform(scheme)) bad_input("this scheme is uniform itself", scheme.id);
  std::vector<std::pair<std::string, RationalFunction>> values;
  for (const auto& p : scheme.parameters)
    for (const long offset : p.offsets)
      values.emplace_back(local_name(p.name, offset), p.rest ? RationalFunction(*p.rest) : RationalFunction(1));
  Scheme uniform = scheme;
  uniform.phases = phases_at(scheme, values);
  uniform.pieces.clear();
  uniform.parameters.clear();
  uniform.claims.clear();
  uniform.kernel.clear();
  Scheme s = Scheme::from_symbol("mask", symbol(uniform), scheme.arity, {});
  std::string text;
  const Laurent a = symbol(s);
  for (const auto& c : a.coefficients()) text += (text.empty() ? "" : ",") + c.to_string();
  s.id = "mask:coefficients=\"" + text + "\",lowest=" + std::to_string(a.lowest());
  s.title = "uniform member of " + scheme.id;
  return s;
}

}  // namespace twoscale::analysis
