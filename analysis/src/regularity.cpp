// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/analysis/regularity.hpp"

#include <arb.h>

#include <algorithm>
#include <numeric>

#include "twoscale/analysis/certificate.hpp"
#include "twoscale/analysis/prove.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::analysis {

using Json = nlohmann::ordered_json;

namespace {

// floor or ceil of a ball's end at 10^-12.
Rational decimal_end(const Ball& b, bool upper) {
  arf_t x;
  arf_init(x);
  if (upper)
    arb_get_ubound_arf(x, b.raw(), 128);
  else
    arb_get_lbound_arf(x, b.raw(), 128);
  Rational r;
  arf_get_fmpq(r.raw(), x);
  arf_clear(x);
  const Rational unit = Rational(10).pow(12);
  r *= unit;
  Rational whole;
  if (upper)
    fmpz_cdiv_q(fmpq_numref(whole.raw()), r.numerator(), r.denominator());
  else
    fmpz_fdiv_q(fmpq_numref(whole.raw()), r.numerator(), r.denominator());
  return whole / unit;
}

// log_m of a positive rational, in a ball.
Ball log_ball(const Rational& x, long m) {
  constexpr long bits = 128;
  Ball r(x, bits);
  Ball base(Rational(m), bits);
  arb_log(r.raw(), r.raw(), bits);
  arb_log(base.raw(), base.raw(), bits);
  arb_div(r.raw(), r.raw(), base.raw(), bits);
  return r;
}

// log_m(value) if it is rational, value > 0.
std::optional<Rational> rational_logarithm(const Rational& value, long m) {
  // m = g^e with the largest e; log_m(value) is rational exactly if value is a power of g.
  long g = m;
  long e = 1;
  for (long base = 2; base * base <= m; ++base) {
    long power = base;
    long exponent = 1;
    while (power < m) {
      power *= base;
      ++exponent;
    }
    if (power == m) {
      g = base;
      e = exponent;
      break;
    }
  }
  Rational rest = value;
  long t = 0;
  while (rest > Rational(1)) {
    rest /= Rational(g);
    ++t;
  }
  while (rest < Rational(1)) {
    rest *= Rational(g);
    --t;
  }
  if (!(rest == Rational(1))) return std::nullopt;
  return Rational(t, e);
}

// log_m(radius) if it is rational: only if the n-th power of the radius is rational, p = a x^n - b.
std::optional<Rational> rational_logarithm(const RealAlgebraic& radius, long m) {
  const fmpz_poly_struct* p = radius.polynomial().univariate_view();
  const long n = fmpz_poly_degree(p);
  for (long i = 1; i < n; ++i)
    if (!fmpz_is_zero(fmpz_poly_get_coeff_ptr(p, i))) return std::nullopt;
  const Rational value = -Rational(fmpz_poly_get_coeff_ptr(p, 0)) / Rational(fmpz_poly_get_coeff_ptr(p, n));
  if (value.sign() <= 0) return std::nullopt;
  const auto log = rational_logarithm(value, m);
  if (!log) return std::nullopt;
  return *log / Rational(n);
}

// shift - factor log_m(radius), radius known exactly.
Exponent logarithmic(const Rational& shift, const Rational& factor, long m, const RealAlgebraic& radius) {
  Exponent e;
  if (const auto log = rational_logarithm(radius, m)) {
    e.rational = shift - factor * *log;
    e.expression = e.rational->to_string();
    e.lower = e.upper = e.rational;
    return e;
  }
  const auto text = radius.expression();
  if (!text) e.rho = radius;
  std::string scale;
  if (!(factor == Rational(1))) scale = factor.to_string() + "*";
  e.expression = shift.to_string() + " - " + scale + "log(" + text.value_or("rho") + ")/log(" + std::to_string(m) + ")";
  RealAlgebraic fine = radius;
  fine.refine(Rational(2).pow(-100));
  Ball low = log_ball(fine.upper(), m);
  Ball high = log_ball(fine.lower(), m);
  const Ball s(shift, 128);
  const Ball f(factor, 128);
  for (Ball* b : {&low, &high}) {
    arb_mul(b->raw(), b->raw(), f.raw(), 128);
    arb_sub(b->raw(), s.raw(), b->raw(), 128);
  }
  e.lower = decimal_end(low, false);
  e.upper = decimal_end(high, true);
  return e;
}

// Spaces of N functions that a scheme may generate at all levels: its own, those it is said to generate, polynomials.
std::vector<Space> spaces_of_dimension(const Scheme& scheme, unsigned n) {
  std::vector<Space> list;
  const auto add = [&](const Space& space) {
    const std::vector<LevelVariable> own = level_variables(scheme);
    const auto rebased = Space::rebase(space, own);
    const bool same = rebased.space.variables().size() == own.size() &&
                      std::all_of(rebased.scale.begin(), rebased.scale.end(), [](unsigned s) { return s == 1; });
    if (same && space.dimension() == n) list.push_back(space);
  };
  if (scheme.space) add(*scheme.space);
  for (const auto& c : scheme.claims)
    if ((c.name == "generates" || c.name == "reproduces") && !c.subject.empty()) add(Space::parse(c.subject));
  add(Space::one_frequency(n, {}));
  return list;
}

Json interval_json(const RealAlgebraic& r) {
  RealAlgebraic fine = r;
  fine.refine(Rational(1, 1L << 40));
  Json j;
  j["polynomial"] = fine.polynomial().to_string();
  j["interval"] = Json::array({fine.lower().to_string(), fine.upper().to_string()});
  return j;
}

Json nonnegative_claim(long order, const char* of, const RealAlgebraic& radius) {
  Json j;
  j["claim"] = "nonnegative-symbol";
  j["verdict"] = "proved";
  j["order"] = order;
  j["of"] = of;
  j["radius"] = interval_json(radius);
  j["theorem"] = "nonnegative-symbol";
  return j;
}

Json stability_claim(const Stability& s) {
  Json j;
  j["claim"] = "stability";
  j["verdict"] = s.stable ? "proved" : "refuted";
  if (s.common_zero)
    j["witness"] = Json::object({{"kind", "common-zero"}});
  else if (s.cycle > 0)
    j["witness"] = Json::object({{"kind", "cycle"}, {"order", s.cycle}});
  j["theorem"] = "jia-wang";
  return j;
}

// Is the integer exponent k attained: are the divided differences of order k bounded, that is, the products of the
// transition matrices of m^k a/S_m^k (radius 1)? A Jordan block of an eigenvalue of modulus 1 refutes, a closed
// polytope proves.
std::optional<bool> bounded_differences(const Laurent& a, long arity, long k, const std::vector<Word>& cycles,
                                        const JsrOptions& options) {
  const auto r = remainder(a, arity, k);
  if (!r) return std::nullopt;
  const Family family = transition_matrices(*r);
  const long n = family[0].rows();
  std::vector<Word> words = cycles;
  for (long s = 0; s < arity; ++s) words.push_back({static_cast<int>(s)});
  for (const auto& w : words) {
    const RationalMatrix p = product(family, w);
    for (const long sign : {1L, -1L}) {
      const RationalMatrix shifted = p + Rational(-sign) * RationalMatrix::identity(n);
      if ((shifted * shifted).rank() < shifted.rank()) return false;
    }
  }
  if (std::all_of(r->c.begin(), r->c.end(), [](const Rational& c) { return c.sign() >= 0; })) {
    // Non-negative, and every coset sums to at most 1: a stochastic-like family.
    std::vector<Rational> sums(static_cast<size_t>(arity));
    for (size_t i = 0; i < r->c.size(); ++i) sums[i % static_cast<size_t>(arity)] += r->c[i];
    if (std::all_of(sums.begin(), sums.end(), [](const Rational& s) { return s <= Rational(1); })) return true;
  }
  return prove_bounded(family, options) ? std::optional(true) : std::nullopt;
}

// The largest l >= 0 with rho < m^{N-l}, -1 if there is none.
long continuity_of(long order, long arity, const JsrResult& jsr) {
  const auto below = [&](long l) {
    const Rational limit = Rational(arity).pow(order - l);
    return jsr.exact ? RealAlgebraic::compare(*jsr.exact, limit) < 0 : jsr.upper < limit;
  };
  long l = -1;
  while (l + 1 <= order + 64 && below(l + 1)) ++l;
  return l;
}

void add_sobolev(Regularity& r, long arity, std::vector<Json>& claims) {
  const CentralRadius central = central_radius(autocorrelation(r.c), arity);
  Exponent s = logarithmic(Rational(r.order) + Rational(1, 2), Rational(1, 2), arity, central.radius);
  if (!r.stability.stable) {
    s.upper.reset();
    s.rational.reset();
    s.expression.reset();
  }
  r.sobolev = std::move(s);
  claims.push_back(nonnegative_claim(r.order, "autocorrelation", central.radius));
}

}  // namespace

std::string start_values(const Scheme& scheme) {
  std::string text = level_variables(scheme).empty() ? "" : "every v^0 > -1";
  for (const auto& p : scheme.parameters)
    if (p.relation && p.spelling && p.domain)
      text += (text.empty() ? "every " : " and ") + p.spelling->name + "^0 in " + p.domain->to_string();
  return text;
}

Exponent exponent_of(long order, long arity, const JsrResult& jsr) {
  Exponent e;
  if (jsr.exact && jsr.exact->sign() > 0) return logarithmic(Rational(order), 1, arity, *jsr.exact);
  if (jsr.upper.sign() > 0) {
    Ball low(Rational(order), 128);
    arb_sub(low.raw(), low.raw(), log_ball(jsr.upper, arity).raw(), 128);
    e.lower = decimal_end(low, false);
  }
  if (jsr.lower.sign() > 0) {
    Ball high(Rational(order), 128);
    arb_sub(high.raw(), high.raw(), log_ball(jsr.lower, arity).raw(), 128);
    e.upper = decimal_end(high, true);
  }
  return e;
}

Regularity regularity(const Scheme& scheme, const RegularityOptions& options) {
  const auto limit = limit_symbol(scheme);  // refuses blocks and local parameters
  for (const auto& p : scheme.parameters)
    if (p.scope != Parameter::Scope::level)
      bad_input("the exponent needs a value for the parameter (--at " + p.name + "=...), or a range (--over)", p.name);
  if (!limit) bad_input("the masks have no limit: a pole at level variables 1", scheme.id);
  const long m = scheme.arity;
  Regularity r;
  r.level_dependent = !is_stationary(scheme);
  const auto sum = limit->at_one().constant();
  const Remainder rest = *remainder(*limit, m);
  r.order = rest.order;
  r.c = rest.c;
  if (!(sum == Rational(m))) {
    r.obstacle = "the coefficients sum to " + sum->to_string() + ", not to the arity " + std::to_string(m);
    return r;
  }
  if (rest.order == 0) {
    r.obstacle = "the sum rule of order 1 fails: constants are not generated";
    return r;
  }
  std::vector<Json> claims;

  const auto half = symmetric_half(rest.c);
  r.matrices = transition_matrices(rest);
  constexpr long examined = 16;  // a size up to which invariant subspaces are looked for when nothing depends on them
  if (!options.polytope_only && half && nonnegative_on_circle(cosine_polynomial(*half))) {
    const CentralRadius central = central_radius(*half, m);
    r.jsr.exact = central.radius;
    r.jsr.exact->refine(Rational(1, 1L << 40));
    r.jsr.lower = r.jsr.exact->lower();
    r.jsr.upper = r.jsr.exact->upper();
    r.jsr.bounded = central.simple;
    r.jsr.method = "nonnegative symbol";
    claims.push_back(nonnegative_claim(rest.order, "remainder", central.radius));
  } else {
    r.jsr = joint_spectral_radius(r.matrices, {rest.order, {}}, options.jsr);
    claims = r.jsr.claims;
  }
  if (r.jsr.method != "nonnegative symbol" || r.matrices[0].rows() <= examined)
    r.blocks = block_triangular_form(r.matrices).sizes;
  r.method = r.jsr.method;
  r.stability = shift_stability(*limit, m);
  claims.push_back(stability_claim(r.stability));
  r.hoelder = exponent_of(rest.order, m, r.jsr);
  r.continuity = continuity_of(rest.order, m, r.jsr);
  if (!r.stability.stable) {
    r.hoelder.upper.reset();
    r.hoelder.rational.reset();
    r.hoelder.expression.reset();
  } else if (r.jsr.exact && r.hoelder.lower->sign() > 0) {
    if (r.hoelder.rational && r.hoelder.rational->is_integer())
      r.attained = bounded_differences(*limit, m, r.hoelder.rational->to_long(), r.jsr.cycles, options.jsr);
    else if (r.jsr.bounded || r.jsr.method == "nonnegative symbol")
      r.attained = r.jsr.bounded;
  }
  add_sobolev(r, m, claims);

  if (r.level_dependent) {
    r.attained.reset();
    const Proof domain = prove(scheme, {{"well-defined", "", ""}});
    r.excluded = domain.decisions[0].exceptions;
    for (const Space& space : spaces_of_dimension(scheme, static_cast<unsigned>(rest.order))) {
      const Proof generated = prove(scheme, {{"generates", space.to_string(), ""}});
      const Decision& d = generated.decisions[0];
      if (d.verdict == Verdict::proved) {
        r.transferred = true;
        r.generated = space.to_string();
        if (r.continuity >= 0) {
          Json j;
          j["claim"] = "nonstationary";
          j["verdict"] = "proved";
          j["space"] = d.evidence["space"];
          j["continuity"] = r.continuity;
          j["theorem"] = "nonstationary";
          claims.push_back(std::move(j));
        }
        break;
      }
    }
  }
  r.certificate = certificate_text(scheme, mask_data(scheme), claims);
  r.claims = std::move(claims);
  return r;
}

Decision decide_continuity(const Scheme& scheme, long l, const RegularityOptions& options) {
  Decision d;
  d.claim = "continuity";
  d.subject = std::to_string(l);
  d.domain = is_stationary(scheme) ? "all data" : start_values(scheme) + " without a singular step, all levels";
  const Regularity r = regularity(scheme, options);
  if (!r.obstacle.empty()) {
    d.witness = r.obstacle;  // no certificate of this document refutes; prove --claim sum-rules=1 does
    return d;
  }
  d.exceptions = r.excluded;
  const Rational threshold = Rational(scheme.arity).pow(r.order - l);
  const bool beyond = r.jsr.exact ? RealAlgebraic::compare(*r.jsr.exact, threshold) >= 0 : r.jsr.lower >= threshold;
  if (r.continuity >= l && (!r.level_dependent || r.transferred)) {
    d.verdict = Verdict::proved;
  } else if (beyond && !r.level_dependent && r.stability.stable) {
    d.verdict = Verdict::refuted;
    d.witness = "the radius of the remainder of order " + std::to_string(r.order) + " is not below " +
                threshold.to_string() + ", and the integer shifts are stable";
  } else {
    d.witness = beyond ? "the radius of the limit is not small enough, which does not refute it for this scheme"
                       : "the bounds of the radius do not decide it";
    return d;
  }
  d.supporting = r.claims;
  return d;
}

}  // namespace twoscale::analysis
