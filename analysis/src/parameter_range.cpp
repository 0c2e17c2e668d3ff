// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/analysis/parameter_range.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <numeric>

#include "affine_family.hpp"
#include "parallel.hpp"
#include "twoscale/analysis/certificate.hpp"
#include "twoscale/analysis/deadline.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::analysis {

using Json = nlohmann::ordered_json;

namespace {

Rational middle(const Rational& a, const Rational& b) { return (a + b) / Rational(2); }

bool less(const RealAlgebraic& a, const RealAlgebraic& b) { return RealAlgebraic::compare(a, b) < 0; }

// Zeros of p inside (a, b), appended.
void zeros_inside(const Polynomial& p, const RealAlgebraic& a, const RealAlgebraic& b,
                  std::vector<RealAlgebraic>& list) {
  if (p.is_zero() || p.is_constant()) return;
  for (auto& zero : RealAlgebraic::zeros(p))
    if (less(a, zero) && less(zero, b)) list.push_back(zero);
}

void sort_distinct(std::vector<RealAlgebraic>& list) {
  std::sort(list.begin(), list.end(), less);
  list.erase(std::unique(list.begin(), list.end(), [](const auto& a, const auto& b) { return a == b; }), list.end());
}

// p with the variable set to a rational, up to a positive factor.
Polynomial at_value(const Polynomial& p, const std::string& variable, const Rational& value) {
  const RationalFunction r = RationalFunction(p).substitute(variable, value);
  return r.numerator();
}

// ---- Sub-intervals, put together

// Adds an interval that begins not before the last one; joined to it if they meet.
void append(std::vector<ParameterInterval>& list, ParameterInterval next) {
  if (!list.empty()) {
    ParameterInterval& last = list.back();
    const int order = RealAlgebraic::compare(last.to, next.from);
    if (order > 0 || (order == 0 && (last.to_included || next.from_included))) {
      const int ends = RealAlgebraic::compare(next.to, last.to);
      if (ends == 0) last.to_included = last.to_included || next.to_included;
      if (ends > 0) {
        last.to = next.to;
        last.to_included = next.to_included;
      }
      return;
    }
  }
  list.push_back(std::move(next));
}

void tidy(std::vector<ParameterInterval>& list) {
  std::sort(list.begin(), list.end(), [](const auto& a, const auto& b) {
    const int order = RealAlgebraic::compare(a.from, b.from);
    return order != 0 ? order < 0 : RealAlgebraic::compare(a.to, b.to) < 0;
  });
  std::vector<ParameterInterval> merged;
  for (auto& i : list) append(merged, std::move(i));
  list = std::move(merged);
}

// ---- The non-negative range

// The closed sub-interval of [a, b] where the symbol is non-negative on the circle; nullopt if it is empty or a point.
std::optional<std::pair<RealAlgebraic, RealAlgebraic>> nonnegative_range(const AffineFamily& family, const Rational& a,
                                                                         const Rational& b) {
  if (!family.symmetric()) return std::nullopt;
  const Polynomial p = family.cosine_polynomial();  // in x and w
  std::vector<RealAlgebraic> cuts;
  const RealAlgebraic from(a);
  const RealAlgebraic to(b);
  zeros_inside(at_value(p, "x", 1), from, to, cuts);
  zeros_inside(at_value(p, "x", -1), from, to, cuts);
  // Squarefree, or the discriminant could vanish identically and hide a change. Factors without x change the sign of
  // all.
  Polynomial squarefree = 1;
  for (const auto& [factor, exponent] : p.factor().factors) {
    if (factor.degree("x") > 0)
      squarefree *= factor;
    else
      zeros_inside(factor, from, to, cuts);
  }
  if (squarefree.degree("x") > 1)
    zeros_inside(Polynomial::resultant(squarefree, squarefree.derivative("x"), "x"), from, to, cuts);
  cuts.push_back(from);
  cuts.push_back(to);
  sort_distinct(cuts);
  std::optional<std::pair<RealAlgebraic, RealAlgebraic>> range;
  for (size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Polynomial at = at_value(p, family.name(), rational_between(cuts[i], cuts[i + 1]));
    if (at.is_zero() || !nonnegative_on_circle(at)) continue;
    if (!range) range.emplace(cuts[i], cuts[i + 1]);
    range->second = cuts[i + 1];
  }
  return range;
}

RealAlgebraic central_at(const AffineFamily& family, const Rational& w) {
  return central_radius(*symmetric_half(family.remainder_at(w).c), family.arity()).radius;
}

// rho(w) on the non-negative range: which factor of the central matrix' characteristic polynomial, and where it
// changes.
std::vector<RadiusRange> central_ranges(const AffineFamily& family, const RealAlgebraic& from,
                                        const RealAlgebraic& to) {
  const Polynomial chi = family.central_characteristic_polynomial();  // in x and w
  std::vector<Polynomial> factors;
  for (const auto& [factor, exponent] : chi.factor().factors)
    if (factor.degree("x") > 0) factors.push_back(factor);
  std::vector<RealAlgebraic> cuts{from, to};
  for (size_t i = 0; i < factors.size(); ++i)
    for (size_t j = i + 1; j < factors.size(); ++j)
      zeros_inside(Polynomial::resultant(factors[i], factors[j], "x"), from, to, cuts);
  sort_distinct(cuts);
  std::vector<RadiusRange> list;
  for (size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Rational w = rational_between(cuts[i], cuts[i + 1]);
    const RealAlgebraic rho = central_at(family, w);
    for (const auto& factor : factors) {
      const Polynomial at = at_value(factor, family.name(), w);
      if (!Polynomial::quotient(at, rho.polynomial())) continue;
      if (!list.empty() && list.back().polynomial == factor) {
        list.back().interval.to = cuts[i + 1];
      } else {
        RadiusRange r;
        r.interval = {cuts[i], cuts[i + 1], true, true};
        r.polynomial = factor;
        r.expression = branch_expression(factor, family.name(), w, rho);
        r.method = "nonnegative symbol";
        list.push_back(std::move(r));
      }
      break;
    }
  }
  return list;
}

// C^l or not where rho(w) is known to be a zero of F(w, x), exactly: rho(w) - tau keeps its sign between the zeros of
// F(w, tau). At such a zero next to rho < tau it is rho = tau, because rho is continuous and no real zero of F is
// larger.
void exact_continuity(const AffineFamily& family, const RadiusRange& range, long l, ContinuityRange& result,
                      std::vector<Json>& claims) {
  const Rational tau = Rational(family.arity()).pow(family.order() - l);
  const Polynomial level = at_value(range.polynomial, "x", tau);
  std::vector<RealAlgebraic> cuts{range.interval.from, range.interval.to};
  zeros_inside(level, range.interval.from, range.interval.to, cuts);
  sort_distinct(cuts);
  const auto reaches = [&](const RealAlgebraic& w) {
    return level.is_zero() ||
           Polynomial::quotient(level, w.polynomial().substitute("x", Polynomial::variable(family.name())));
  };
  const bool central = range.method == "nonnegative symbol";
  for (size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Rational w = rational_between(cuts[i], cuts[i + 1]);
    bool below = false;
    if (central) {
      below = RealAlgebraic::compare(central_at(family, w), tau) < 0;
    } else {
      const JsrResult at = joint_spectral_radius(family.matrices_at(w), {}, {});
      below = at.exact ? RealAlgebraic::compare(*at.exact, tau) < 0 : at.upper < tau;
      if (!at.exact && !below && at.lower < tau) continue;  // not told: neither proved nor refuted here
    }
    ParameterInterval interval{cuts[i], cuts[i + 1], true, true};
    if (below) {
      interval.from_included = !reaches(cuts[i]);
      interval.to_included = !reaches(cuts[i + 1]);
    }
    // Rational ends inside, for the certificate. The polytopes have claims of their own.
    const Rational low = interval.from.rational().value_or(interval.from.upper());
    const Rational high = interval.to.rational().value_or(interval.to.lower());
    if (central && low < high) {
      Json claim;
      claim["claim"] = "nonnegative-family";
      claim["verdict"] = "proved";
      claim["order"] = family.order();
      claim["parameter"] = Json::array({low.to_string(), high.to_string()});
      claim["relation"] = below ? "below" : "above";
      claim["bound"] = tau.to_string();
      claim["theorem"] = "nonnegative-symbol";
      claims.push_back(std::move(claim));
    }
    append(below ? result.proved : result.refuted, std::move(interval));
  }
}

// The parts of [from, to] outside the ranges (ascending), with rational ends, none very short.
std::vector<std::pair<Rational, Rational>> gaps_between(const std::vector<RadiusRange>& ranges, const Rational& from,
                                                        const Rational& to) {
  std::vector<std::pair<Rational, Rational>> gaps;
  Rational low = from;
  for (const auto& r : ranges) {
    const Rational high = r.interval.from.rational().value_or(r.interval.from.upper());
    if (low < high) gaps.emplace_back(low, high);
    low = r.interval.to.rational().value_or(r.interval.to.lower());
  }
  if (low < to) gaps.emplace_back(low, to);
  return gaps;
}

// ---- Cells

struct Cell {
  std::vector<ParameterInterval> proved;
  std::vector<ParameterInterval> refuted;
  std::vector<Json> claims;
};

class CellProver {
 public:
  CellProver(const AffineFamily& family, const ParameterOptions& options, Rational resolution)
      : family_(family), options_(options), resolution_(std::move(resolution)), deadline_(0) {
    options_.regularity.jsr.progress = nullptr;
    options_.regularity.jsr.threads = 1;
    // Many small problems: each is given up early, a shorter interval is easier.
    options_.regularity.jsr.seconds = std::min(options_.regularity.jsr.seconds / 40, 1.0);
    options_.regularity.jsr.vertices = std::min<size_t>(options_.regularity.jsr.vertices, 250);
    options_.regularity.jsr.width = std::max(options_.regularity.jsr.width, Rational(1, 1000));
  }

  Rational threshold(long l) const { return Rational(family_.arity()).pow(family_.order() - l); }

  JsrResult radius(const Rational& w) {
    {
      const std::lock_guard lock(mutex_);
      if (const auto found = cache_.find(w); found != cache_.end()) return found->second;
    }
    JsrOptions search = options_.regularity.jsr;
    search.seconds *= 3;
    JsrResult r = joint_spectral_radius(family_.matrices_at(w), {}, search);
    const std::lock_guard lock(mutex_);
    return cache_.emplace(w, std::move(r)).first->second;
  }

  // 1: rho(w) < tau is proved, -1: rho(w) >= tau is proved.
  int side(const Rational& w, const Rational& tau) {
    const JsrResult r = radius(w);
    if (r.exact) return RealAlgebraic::compare(*r.exact, tau) < 0 ? 1 : -1;
    return r.upper < tau ? 1 : r.lower >= tau ? -1 : 0;
  }

  std::optional<Json> joint(const Rational& low, const Rational& high, const Rational& tau) const {
    Family both = family_.matrices_at(low);
    JsrSubject subject{family_.order(), {low, high}};
    if (!(low == high))
      for (auto& b : family_.matrices_at(high)) both.push_back(std::move(b));
    return prove_jsr_below(both, tau, subject, options_.regularity.jsr);
  }

  // What follows has so long.
  void allow(double seconds) { deadline_ = Deadline(seconds); }
  bool late() const { return deadline_.passed(); }

  void run(const Rational& low, const Rational& high, const Rational& tau, Cell& cell) {
    if (late()) return;
    const int a = side(low, tau);
    const int b = side(high, tau);
    if (a == 1 && b == 1) {
      if (auto claim = joint(low, high, tau)) {
        cell.claims.push_back(std::move(*claim));
        append(cell.proved, {low, high, true, true});
        return;
      }
    } else if (a == -1 && b == -1) {
      if (refute(low, high, low, high, tau, cell)) return;
    }
    // A boundary is approached much closer: few cells are there.
    const bool mixed = a * b < 0;
    if (high - low <= (mixed ? resolution_ / Rational(256) : resolution_)) {
      if (a != b && (a == -1 || b == -1)) boundary(low, high, a == -1, tau, cell);
      return;
    }
    const Rational mid = middle(low, high);
    run(low, mid, tau, cell);
    run(mid, high, tau, cell);
  }

 private:
  // Products that attain the radius at w; both signs of the eigenvalue are tried.
  bool refute(const Rational& w1, const Rational& w2, const Rational& low, const Rational& high, const Rational& tau,
              Cell& cell) {
    for (const Rational& w : {w1, w2})
      for (const auto& word : radius(w).cycles)
        for (const long sign : {1L, -1L}) {
          const Polynomial d = family_.determinant_beyond(word, sign, tau);
          if (d.is_zero() || sign_inside(d, low, high) >= 0) continue;
          cell.claims.push_back(lower_claim(low, high, word, sign, tau));
          append(cell.refuted, {low, high, true, true});
          return true;
        }
    return false;
  }

  // The sign of d in (low, high) if it does not change there, else 1.
  int sign_inside(const Polynomial& d, const Rational& low, const Rational& high) const {
    const RealAlgebraic a(low);
    const RealAlgebraic b(high);
    if (d.is_constant()) return d.constant_value().sign();
    for (const auto& [factor, exponent] : d.factor().factors) {
      std::vector<RealAlgebraic> zeros;
      if (exponent % 2 == 1) zeros_inside(factor, a, b, zeros);
      if (!zeros.empty()) return 1;
    }
    for (long k = 2;; ++k)
      if (const int s = sign_at(d, low + (high - low) / Rational(k)); s != 0) return s;
  }

  // One end is beyond tau: the refuted part begins at a zero of the determinant.
  void boundary(const Rational& low, const Rational& high, bool beyond_at_low, const Rational& tau, Cell& cell) {
    const Rational& w = beyond_at_low ? low : high;
    for (const auto& word : radius(w).cycles)
      for (const long sign : {1L, -1L}) {
        const Polynomial d = family_.determinant_beyond(word, sign, tau);
        if (d.is_zero()) continue;
        std::vector<RealAlgebraic> cuts;
        zeros_inside(d, low, high, cuts);
        sort_distinct(cuts);
        if (cuts.empty()) continue;
        RealAlgebraic cut = beyond_at_low ? cuts.front() : cuts.back();
        cut.refine(resolution_ / Rational(1L << 20));
        const Rational inner = cut.rational().value_or(beyond_at_low ? cut.lower() : cut.upper());
        const Rational from = beyond_at_low ? low : inner;
        const Rational to = beyond_at_low ? inner : high;
        if (!(from < to) || sign_inside(d, from, to) >= 0) continue;
        cell.claims.push_back(lower_claim(from, to, word, sign, tau));
        if (beyond_at_low)
          append(cell.refuted, {low, cut, true, true});
        else
          append(cell.refuted, {cut, high, true, true});
        return;
      }
  }

  Json lower_claim(const Rational& low, const Rational& high, const Word& word, long sign, const Rational& tau) const {
    Json claim;
    claim["claim"] = "jsr-lower-family";
    claim["verdict"] = "proved";
    claim["order"] = family_.order();
    claim["parameter"] = Json::array({low.to_string(), high.to_string()});
    claim["word"] = word;
    claim["sign"] = sign;
    claim["bound"] = tau.to_string();
    claim["theorem"] = "spectral-radius";
    return claim;
  }

  const AffineFamily& family_;
  ParameterOptions options_;
  Rational resolution_;
  Deadline deadline_;
  std::mutex mutex_;
  std::map<Rational, JsrResult> cache_;
};

// The largest interval found for which one polytope serves any sequence of w.
std::optional<ParameterInterval> largest_joint(CellProver& prover, const std::vector<ParameterInterval>& proved,
                                               const Rational& tau, const Rational& resolution, int threads,
                                               std::vector<Json>& claims) {
  struct Found {
    Rational low;
    Rational high;
    std::optional<Json> claim;
  };
  Found best;
  for (const auto& piece : proved) {
    const Rational low = piece.from.upper();
    const Rational high = piece.to.lower();
    if (!(best.high - best.low < high - low)) continue;
    // First both ends at once towards the ends of the piece, from several centres, then each end alone.
    std::vector<Found> grown(5);
    in_parallel(grown.size(), threads, [&](size_t k) {
      const Rational centre = low + (high - low) * Rational(static_cast<long>(k) + 1, 6);
      Rational inside = 0;
      Rational outside = 1;
      for (int step = 0; step < 7 && !prover.late(); ++step) {
        const Rational t = middle(inside, outside);
        const Rational l = centre - (centre - low) * t;
        const Rational h = centre + (high - centre) * t;
        if (auto claim = prover.joint(l, h, tau)) {
          inside = t;
          grown[k] = {l, h, std::move(claim)};
        } else {
          outside = t;
        }
      }
    });
    for (auto& g : grown)
      if (g.claim && best.high - best.low < g.high - g.low) best = std::move(g);
    if (!best.claim || best.low < low || best.high > high) continue;
    for (const bool right : {true, false}) {
      Rational outside = right ? high : low;
      while (abs(outside - (right ? best.high : best.low)) > resolution && !prover.late()) {
        const Rational next = middle(right ? best.high : best.low, outside);
        const Rational l = right ? best.low : next;
        const Rational h = right ? next : best.high;
        if (auto claim = prover.joint(l, h, tau))
          best = {l, h, std::move(claim)};
        else
          outside = next;
      }
    }
  }
  if (!best.claim) return std::nullopt;
  claims.push_back(std::move(*best.claim));
  return ParameterInterval{best.low, best.high, true, true};
}

}  // namespace

ParameterRange parameter_range(const Scheme& scheme, const std::string& name, const Rational& from, const Rational& to,
                               const ParameterOptions& options) {
  if (!(from < to)) bad_input("--over: the lower end is not below the upper end", name);
  if (!is_stationary(scheme)) bad_input("--over: the scheme depends on the level", scheme.id);
  const AffineFamily family(scheme, name);
  ParameterRange result;
  result.name = name;
  result.from = from;
  result.to = to;
  result.order = family.order();
  RegularityOptions sample_options = options.regularity;
  sample_options.jsr.progress = nullptr;
  sample_options.jsr.threads = 1;
  sample_options.jsr.seconds = std::min(sample_options.jsr.seconds / 20, 5.0);
  const auto sample = [&](const Rational& w) {
    Regularity r = regularity(with_values(scheme, {{name, w}}), sample_options);
    r.certificate.clear();
    return std::pair(w, std::move(r));
  };
  if (const auto w = family.exceptional(); w && from <= *w && *w <= to) result.exceptional = sample(*w);
  const Rational step = (to - from) / Rational(static_cast<long>(options.samples) - 1);
  result.samples.resize(static_cast<size_t>(options.samples));
  in_parallel(result.samples.size(), options.threads,
              [&](size_t i) { result.samples[i] = sample(from + Rational(static_cast<long>(i)) * step); });
  std::vector<Json> claims;
  const auto central = nonnegative_range(family, from, to);
  if (central) result.radius = central_ranges(family, central->first, central->second);
  for (auto& r : polytope_ranges(family, from, to, central, options.regularity.jsr, claims))
    result.radius.push_back(std::move(r));
  std::sort(result.radius.begin(), result.radius.end(),
            [](const auto& a, const auto& b) { return less(a.interval.from, b.interval.from); });

  // C^l is looked at for the l that occur: at the samples and in each range.
  long most = -1;
  for (const auto& [w, r] : result.samples) most = std::max(most, r.continuity);
  for (const auto& r : result.radius)
    most = std::max(most, sample(rational_between(r.interval.from, r.interval.to)).second.continuity);
  most = std::min(most, family.order() - 1);
  CellProver prover(family, options, (to - from) * options.resolution);
  const double share = 0.3 * options.regularity.jsr.seconds / static_cast<double>(std::max(1L, most + 1));
  for (long l = 0; l <= most; ++l) {
    const Rational tau = prover.threshold(l);
    ContinuityRange range;
    range.l = l;
    prover.allow(share);
    for (const auto& r : result.radius) exact_continuity(family, r, l, range, claims);
    std::vector<std::pair<Rational, Rational>> cells;
    for (const auto& [low, high] : gaps_between(result.radius, from, to)) {
      Rational left = low;
      for (const auto& [w, r] : result.samples)
        if (left < w && w < high) {
          cells.emplace_back(left, w);
          left = w;
        }
      cells.emplace_back(left, high);
    }
    std::vector<Cell> done(cells.size());
    in_parallel(cells.size(), options.threads,
                [&](size_t i) { prover.run(cells[i].first, cells[i].second, tau, done[i]); });
    for (auto& cell : done) {
      for (auto& i : cell.proved) range.proved.push_back(std::move(i));
      for (auto& i : cell.refuted) range.refuted.push_back(std::move(i));
      for (auto& c : cell.claims) claims.push_back(std::move(c));
    }
    tidy(range.proved);
    tidy(range.refuted);
    if (options.regularity.jsr.progress) options.regularity.jsr.progress("C^" + std::to_string(l) + " done");
    result.continuity.push_back(std::move(range));
  }
  for (auto& range : result.continuity) {
    prover.allow(share);
    range.joint = largest_joint(prover, range.proved, prover.threshold(range.l), (to - from) * Rational(1, 4096),
                                options.threads, claims);
  }
  if (!claims.empty()) result.certificate = certificate_text(scheme, mask_data(scheme), claims);
  return result;
}

}  // namespace twoscale::analysis
