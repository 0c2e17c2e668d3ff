// SPDX-License-Identifier: GPL-3.0-or-later
// Closed forms of rho(w): the polytope found at one parameter value is followed as a function of the parameter.
//
// All numbers of an invariant polytope whose radius is rational are rational functions of the parameter once its words,
// tree and supports are fixed. Each inclusion sum |c_j(u)| <= 1 is a set of inequalities between rational functions;
// the polytope serves on the whole interval around the sample on which none of them changes sign, the ends included
// because the joint spectral radius is continuous. Where rho(w) is quadratic over Q(w) and the curve is a conic with a
// rational point, w = phi(u) makes rho rational.
#include <arb_fmpz_poly.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "affine_family.hpp"
#include "twoscale/analysis/deadline.hpp"
#include "twoscale/analysis/matrix.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::analysis {

using Json = nlohmann::ordered_json;

namespace {

// w = phi(u), rho = psi(u).
struct Parametrization {
  RationalFunction w;
  RationalFunction rho;
  double sample = 0;  // u there
};

constexpr const char* parameter = "u";

double estimate(const Rational& r) { return fmpq_get_d(r.raw()); }

std::vector<Polynomial> coefficients_of(const Polynomial& f, long degree) {
  std::vector<Polynomial> list;
  Polynomial rest = f;
  for (long i = 0; i <= degree; ++i) {
    list.push_back(rest.substitute("x", 0));
    rest = Polynomial::exact_quotient(rest - list.back(), Polynomial::variable("x"));
  }
  return list;
}

std::optional<Rational> square_root(const Rational& r) {
  if (r.sign() < 0 || fmpz_is_square(r.numerator()) == 0 || fmpz_is_square(r.denominator()) == 0) return std::nullopt;
  Rational root;
  fmpz_sqrt(fmpq_numref(root.raw()), r.numerator());
  fmpz_sqrt(fmpq_denref(root.raw()), r.denominator());
  return root;
}

// d = s^2 inside, inside of degree at most 2 without square factors; nullopt for others.
struct Conic {
  RationalFunction square;
  Polynomial inside;
};
std::optional<Conic> conic(const Polynomial& d, const std::string& name) {
  const auto [content, factors] = d.factor();
  Conic c{1, Polynomial::constant(content.numerator())};
  for (const auto& [factor, exponent] : factors) {
    c.square *= RationalFunction(factor.pow(exponent / 2));
    if (exponent % 2 == 1) c.inside *= factor;
  }
  if (!content.is_integer() || c.inside.degree(name) > 2) return std::nullopt;
  return c;
}

// The curve F(w, x) = 0 near (w0, rho0) by rational functions.
std::optional<Parametrization> parametrized(const Polynomial& f, const std::string& name, const Rational& w0,
                                            double rho0) {
  const RationalFunction u = RationalFunction::variable(parameter);
  const long degree = f.degree("x");
  if (degree == 1) {
    const auto c = coefficients_of(f, 1);
    const RationalFunction rho = -RationalFunction(c[0]) / RationalFunction(c[1]);
    return Parametrization{u, rho.substitute(name, u), estimate(w0)};
  }
  if (degree != 2) return std::nullopt;
  const auto c = coefficients_of(f, 2);
  const auto curve = conic(c[1] * c[1] - Polynomial(4) * c[2] * c[0], name);
  if (!curve) return std::nullopt;
  const auto value = [&](const Polynomial& p, const Rational& at) { return p.evaluate({{name, at}}); };
  // A rational point (w, y), y^2 = inside(w).
  std::vector<Rational> tries;
  if (!curve->inside.is_constant())
    for (const auto& zero : RealAlgebraic::zeros(curve->inside))
      if (zero.rational()) tries.push_back(*zero.rational());
  for (long q = 1; q <= 8; ++q)
    for (long p = -16; p <= 16; ++p) tries.emplace_back(p, q);
  for (const auto& at : tries) {
    const auto y = square_root(value(curve->inside, at));
    if (!y) continue;
    const Rational slope = value(curve->inside.derivative(name), at);
    const Rational lead = value(curve->inside.derivative(name).derivative(name), at) / Rational(2);
    const RationalFunction t =
        (RationalFunction(slope) - RationalFunction(Rational(2) * *y) * u) / (u * u - RationalFunction(lead));
    const RationalFunction w = RationalFunction(at) + t;
    const RationalFunction root = RationalFunction(*y) + u * t;
    const auto in_u = [&](const Polynomial& p) { return RationalFunction(p).substitute(name, w); };
    const RationalFunction rho =
        (curve->square.substitute(name, w) * root - in_u(c[1])) / (RationalFunction(2) * in_u(c[2]));
    // u of the sample: (y0 - y)/(w0 - at), y0 from rho0.
    const double s = estimate(*curve->square.evaluate({{name, w0}}));
    const double y0 = (2 * estimate(value(c[2], w0)) * rho0 + estimate(value(c[1], w0))) / s;
    const double dw = estimate(w0 - at);
    if (std::abs(dw) < 1e-9 || s == 0) continue;
    return Parametrization{w, rho, (y0 - estimate(*y)) / dw};
  }
  return std::nullopt;
}

// The factor of the characteristic equation of sign x^n = an eigenvalue of B_word(w) that rho(w0) satisfies.
std::optional<Polynomial> radius_equation(const AffineFamily& family, const Word& word, int sign, const Rational& w0,
                                          const RealAlgebraic& rho) {
  PolynomialMatrix p = product_of(family.matrices(), word);
  const size_t size = p.size();
  const Rational scale = family.denominator().pow(static_cast<long>(word.size()));
  const Polynomial x = Polynomial::variable("x").pow(static_cast<unsigned>(word.size())).scaled(scale * Rational(sign));
  for (size_t i = 0; i < size; ++i)
    for (size_t j = 0; j < size; ++j) p[i][j] = i == j ? x - p[i][j] : -p[i][j];
  const Polynomial chi = determinant_of(p);
  if (chi.is_zero()) return std::nullopt;
  for (const auto& [factor, exponent] : chi.factor().factors) {
    if (factor.degree("x") < 1) continue;
    const Polynomial at = RationalFunction(factor).substitute(family.name(), w0).numerator();
    if (Polynomial::quotient(at, rho.polynomial())) return factor;
  }
  return std::nullopt;
}

// The interval around the sample on which nothing collected so far changes sign.
class Window {
 public:
  Window(const Rational& sample, std::optional<RealAlgebraic> low, std::optional<RealAlgebraic> high)
      : sample_(sample), low_(std::move(low)), high_(std::move(high)) {}

  // Narrows to the zeros of odd order of p nearest to the sample (all zeros if `all`).
  void keep_sign(const Polynomial& p, bool all = false) {
    if (p.is_constant()) return;
    for (const auto& [factor, exponent] : p.factor().factors) {
      if (exponent % 2 == 0 && !all) continue;
      for (const auto& zero : RealAlgebraic::zeros(factor)) {
        const int side = RealAlgebraic::compare(zero, RealAlgebraic(sample_));
        if (side == 0) broken_ = true;
        if (side < 0 && (!low_ || RealAlgebraic::compare(zero, *low_) > 0)) low_ = zero;
        if (side > 0 && (!high_ || RealAlgebraic::compare(zero, *high_) < 0)) high_ = zero;
      }
    }
  }
  // f >= 0: the sample must satisfy it.
  bool require(const RationalFunction& f) {
    const auto value = f.evaluate({{parameter, sample_}});
    if (!value || value->sign() < 0) return false;
    if (f.is_zero()) return true;
    for (const auto& [factor, exponent] : f.denominator_factors()) keep_sign(factor, true);
    keep_sign(f.numerator());
    return !broken_;
  }
  const std::optional<RealAlgebraic>& low() const { return low_; }
  const std::optional<RealAlgebraic>& high() const { return high_; }

 private:
  Rational sample_;
  std::optional<RealAlgebraic> low_;
  std::optional<RealAlgebraic> high_;
  bool broken_ = false;
};

using FunctionVector = std::vector<RationalFunction>;

struct Followed {
  Window window;
  Json claim;
};

// The polytope of that shape over Q(u): its window around u, and the claim without its interval.
std::optional<Followed> follow(const AffineFamily& family, const Parametrization& p, const Rational& u,
                               const PolytopeShape& shape, Window window) {
  using M = Matrix<RationalFunction>;
  const std::vector<PolynomialMatrix> polynomial = family.matrices();
  const size_t d = polynomial[0].size();
  std::vector<M> b;
  for (const auto& m : polynomial) {
    M r(d, d);
    for (size_t i = 0; i < d; ++i)
      for (size_t j = 0; j < d; ++j)
        r(i, j) = RationalFunction(m[i][j]).substitute(family.name(), p.w) / RationalFunction(family.denominator());
    b.push_back(std::move(r));
  }
  if (!window.require(p.rho)) return std::nullopt;
  window.keep_sign(p.rho.numerator(), true);
  const RationalFunction inverse = p.rho.inverse();

  std::vector<FunctionVector> x;
  Json roots = Json::array();
  for (size_t i = 0; i < shape.words.size(); ++i) {
    if (shape.words[i].empty()) {  // an arbitrary vertex: a multiple of a unit vector
      FunctionVector constant;
      std::vector<std::string> text;
      Rational scale;
      for (const auto& c : shape.roots[i]) {
        constant.emplace_back(c);
        text.push_back(c.is_zero() ? "0" : "1");
        if (!c.is_zero()) scale = c;
      }
      x.push_back(std::move(constant));
      Json root;
      root["word"] = Json::array();
      root["sign"] = 1;
      root["scale"] = scale.to_string();
      root["vector"] = text;
      roots.push_back(std::move(root));
      continue;
    }
    M power = M::identity(d);
    for (const int s : shape.words[i]) power = product(b[static_cast<size_t>(s)], power);
    const RationalFunction lambda =
        RationalFunction(shape.signs[i]) * p.rho.pow(static_cast<long>(shape.words[i].size()));
    for (size_t k = 0; k < d; ++k) power(k, k) -= lambda;
    const auto vectors = kernel(power);
    if (vectors.size() != 1) return std::nullopt;
    const FunctionVector vector = primitive(vectors[0]);
    // The scale of the sample.
    std::optional<Rational> scale;
    for (size_t k = 0; k < d && !scale; ++k) {
      const auto value = vector[k].evaluate({{parameter, u}});
      if (value && !value->is_zero()) scale = shape.roots[i][k] / *value;
    }
    if (!scale || scale->is_zero()) return std::nullopt;
    FunctionVector scaled;
    std::vector<std::string> text;
    for (const auto& c : vector) {
      scaled.push_back(RationalFunction(*scale) * c);
      text.push_back((scale->sign() < 0 ? -c : c).numerator().to_string());
    }
    x.push_back(std::move(scaled));
    Json root;
    root["word"] = shape.words[i];
    root["sign"] = shape.signs[i];
    root["scale"] = abs(*scale).to_string();
    root["vector"] = text;
    roots.push_back(std::move(root));
  }
  const auto image_of = [&](size_t matrix, size_t vertex) {
    FunctionVector y = product(b[matrix], x[vertex]);
    for (auto& c : y) c *= inverse;
    return y;
  };
  for (const auto& [parent, matrix] : shape.tree) x.push_back(image_of(matrix, parent));
  for (const auto& v : x)
    for (const auto& c : v)
      for (const auto& [factor, exponent] : c.denominator_factors()) window.keep_sign(factor, true);
  M inner(d, d);
  for (size_t j = 0; j < d; ++j)
    for (size_t i = 0; i < d; ++i) inner(i, j) = x[shape.inner[j]][i];
  const RationalFunction spanned = determinant(inner);
  if (spanned.is_zero()) return std::nullopt;
  window.keep_sign(spanned.numerator(), true);

  Json images = Json::array();
  for (const auto& image : shape.images) {
    const FunctionVector y = image_of(image.matrix, image.vertex);
    if (image.equals) {
      for (size_t i = 0; i < d; ++i)
        if (!(y[i] == RationalFunction(image.equals->second) * x[image.equals->first][i])) return std::nullopt;
      images.push_back(Json::object({{"equals", image.equals->first}, {"sign", image.equals->second}}));
      continue;
    }
    const size_t n = image.support.size();
    if (n > 8) return std::nullopt;
    M system(d, n + 1);
    for (size_t i = 0; i < d; ++i) {
      for (size_t j = 0; j < n; ++j) system(i, j) = x[image.support[j]][i];
      system(i, n) = y[i];
    }
    const auto relation = kernel(system);
    if (relation.size() != 1 || relation[0][n].is_zero()) return std::nullopt;
    FunctionVector c;
    for (size_t j = 0; j < n; ++j) c.push_back(-relation[0][j] / relation[0][n]);
    for (size_t pattern = 0; pattern < (size_t{1} << n); ++pattern) {
      RationalFunction slack = 1;
      for (size_t j = 0; j < n; ++j) slack -= (pattern >> j & 1U) != 0 ? c[j] : -c[j];
      if (!window.require(slack)) return std::nullopt;
    }
    images.push_back(Json::object({{"support", image.support}}));
  }
  Json claim;
  claim["claim"] = "jsr-family";
  claim["verdict"] = "proved";
  claim["order"] = family.order();
  claim["parameter"] = Json::array();
  const auto fraction = [](const RationalFunction& f) {
    return Json::object({{"numerator", f.numerator().to_string()}, {"denominator", f.denominator().to_string()}});
  };
  claim["substitution"] = fraction(p.w);
  claim["radius"] = fraction(p.rho);
  claim["roots"] = std::move(roots);
  claim["tree"] = Json::array();
  for (const auto& [parent, matrix] : shape.tree) claim["tree"].push_back(Json::array({parent, matrix}));
  claim["inner"] = shape.inner;
  claim["images"] = std::move(images);
  claim["theorem"] = "invariant-polytope";
  return Followed{std::move(window), std::move(claim)};
}

// phi(u) for an algebraic u.
RealAlgebraic image_under(const RationalFunction& phi, const RealAlgebraic& u) {
  if (const auto q = u.rational()) return *phi.evaluate({{parameter, *q}});
  const RationalFunction difference = RationalFunction::variable("w'") - phi;
  const Polynomial equation = Polynomial::resultant(u.polynomial().substitute("x", Polynomial::variable(parameter)),
                                                    difference.numerator(), parameter);
  // The zero that phi(u) is: the only one whose ball meets that of phi(u).
  const std::vector<RealAlgebraic> zeros = RealAlgebraic::zeros(equation);
  const Polynomial numerator = phi.numerator();
  const Polynomial denominator = phi.denominator();
  for (long bits = 128; bits <= (1L << 14); bits *= 2) {
    const Ball at = u.enclose(bits);
    Ball value;
    Ball divisor;
    arb_fmpz_poly_evaluate_arb(value.raw(), numerator.univariate_view(), at.raw(), bits);
    arb_fmpz_poly_evaluate_arb(divisor.raw(), denominator.univariate_view(), at.raw(), bits);
    arb_div(value.raw(), value.raw(), divisor.raw(), bits);
    const RealAlgebraic* found = nullptr;
    int meetings = 0;
    for (const auto& zero : zeros)
      if (arb_overlaps(zero.enclose(bits).raw(), value.raw()) != 0) {
        found = &zero;
        ++meetings;
      }
    if (meetings == 1) return *found;
  }
  throw Error(Error::Kind::undecided, "the end of a range could not be told from its conjugates");
}

bool less(const RealAlgebraic& a, const RealAlgebraic& b) { return RealAlgebraic::compare(a, b) < 0; }

// A polytope found near w0 and followed as far as it serves inside (low, high).
struct Served {
  RadiusRange range;
  Json claim;
};

class Follower {
 public:
  Follower(const AffineFamily& family, const JsrOptions& options) : family_(family), search_(options) {
    search_.progress = nullptr;
    search_.threads = 1;
    search_.seconds = std::min(options.seconds / 30, 2.0);
    search_.vertices = 60;
  }

  // The best over several sets of additional vertices: these may serve a longer interval, down to where the leading
  // vectors alone would not span. `enough` ends the search.
  std::optional<Served> serve(const RealAlgebraic& low, const RealAlgebraic& high, const Rational& w0,
                              const std::function<bool(const ParameterInterval&)>& enough) {
    JsrResult at = joint_spectral_radius(family_.matrices_at(w0), {}, search_);
    if (!at.exact || !at.shape) return std::nullopt;
    const auto equation = radius_equation(family_, at.shape->words[0], at.shape->signs[0], w0, *at.exact);
    const auto curve = equation ? parametrized(*equation, family_.name(), w0, at.exact->estimate()) : std::nullopt;
    if (!curve) return std::nullopt;
    // A rational u near the sample whose w lies inside; there the radius is rational.
    const double room = high.estimate() - low.estimate();
    Rational u;
    bool found = false;
    for (int bits = 2; bits <= 30 && !found; ++bits) {
      u = Rational(static_cast<long>(std::lround(std::ldexp(curve->sample, bits)))) / Rational(1L << bits);
      const auto w = curve->w.evaluate({{parameter, u}});
      found = w && less(low, *w) && less(*w, high) && std::abs(estimate(*w - w0)) < 0.25 * room;
    }
    if (!found) return std::nullopt;
    const Rational w1 = *curve->w.evaluate({{parameter, u}});
    const auto rho = curve->rho.evaluate({{parameter, u}});
    if (!rho) return std::nullopt;
    const Window whole = window_of_curve(*curve, u, low, high);
    std::optional<Served> best;
    for (const Rational& extra : {Rational(0), Rational(1, 2), Rational(1, 4), Rational(3, 4), Rational(1, 16)}) {
      search_.extra = extra;
      at = joint_spectral_radius(family_.matrices_at(w1), {}, search_);
      if (!at.exact || !at.shape || at.shape->roots.empty() || !(*at.exact == RealAlgebraic(*rho))) continue;
      auto followed = follow(family_, *curve, u, *at.shape, whole);
      if (!followed || !followed->window.low() || !followed->window.high()) continue;
      RealAlgebraic u_low = *followed->window.low();
      RealAlgebraic u_high = *followed->window.high();
      ParameterInterval interval{image_under(curve->w, u_low), image_under(curve->w, u_high), true, true};
      if (less(interval.to, interval.from)) std::swap(interval.from, interval.to);
      if (less(interval.from, low)) interval.from = low;
      if (less(high, interval.to)) interval.to = high;
      u_low.refine(Rational(1, 1L << 40));
      u_high.refine(Rational(1, 1L << 40));
      followed->claim["parameter"] = Json::array({u_low.upper().to_string(), u_high.lower().to_string()});
      const bool done = enough(interval);
      if (done || !best ||
          best->range.interval.to.estimate() - best->range.interval.from.estimate() <
              interval.to.estimate() - interval.from.estimate())
        best = Served{{std::move(interval), *equation, branch_expression(*equation, family_.name(), w1, *rho),
                       "invariant polytope", at.cycles},
                      std::move(followed->claim)};
      if (done) break;
    }
    search_.extra = 0;
    return best;
  }

 private:
  // Where phi is monotone and stays in the interval.
  static Window window_of_curve(const Parametrization& curve, const Rational& u, const RealAlgebraic& low,
                                const RealAlgebraic& high) {
    Window whole(u, std::nullopt, std::nullopt);
    const Polynomial n = curve.w.numerator();
    const Polynomial q = curve.w.denominator();
    whole.keep_sign(n.derivative(parameter) * q - n * q.derivative(parameter), true);
    if (!q.is_constant()) whole.keep_sign(q, true);
    for (const RealAlgebraic* end : {&low, &high}) {
      const RationalFunction composed = RationalFunction(end->polynomial()).substitute("x", curve.w);
      if (!composed.is_zero()) whole.keep_sign(composed.numerator(), true);
    }
    return whole;
  }

  const AffineFamily& family_;
  JsrOptions search_;
};

}  // namespace

std::vector<RadiusRange> polytope_ranges(const AffineFamily& family, const Rational& from, const Rational& to,
                                         const std::optional<std::pair<RealAlgebraic, RealAlgebraic>>& without,
                                         const JsrOptions& options, std::vector<Json>& claims) {
  std::vector<RadiusRange> list;
  if (family.matrices()[0].size() > 4) return list;  // rational functions grow too fast
  std::vector<std::pair<RealAlgebraic, RealAlgebraic>> gaps;
  const double size = estimate(to - from);
  const auto add_gap = [&](const RealAlgebraic& low, const RealAlgebraic& high) {
    if (high.estimate() - low.estimate() > 1e-6 * size) gaps.emplace_back(low, high);
  };
  if (without) {
    add_gap(from, without->first);
    add_gap(without->second, to);
  } else {
    add_gap(from, to);
  }
  const Deadline deadline(options.seconds / 6);
  Follower follower(family, options);
  for (int attempts = 0; !gaps.empty() && attempts < 64 && !deadline.passed(); ++attempts) {
    const auto [low, high] = gaps.back();
    gaps.pop_back();
    const Rational w0 = rational_between(low, high);
    auto served =
        follower.serve(low, high, w0, [&](const ParameterInterval& i) { return i.from == low && i.to == high; });
    if (served) {
      claims.push_back(std::move(served->claim));
      add_gap(low, served->range.interval.from);
      add_gap(served->range.interval.to, high);
      list.push_back(std::move(served->range));
    } else if (high.estimate() - low.estimate() > 0.05 * size) {
      add_gap(low, w0);
      add_gap(w0, high);
    }
  }
  std::sort(list.begin(), list.end(),
            [](const auto& a, const auto& b) { return less(a.interval.from, b.interval.from); });
  std::vector<RadiusRange> merged;
  for (auto& r : list) {
    if (merged.empty() || !(merged.back().polynomial == r.polynomial) || merged.back().expression != r.expression ||
        !(merged.back().interval.to == r.interval.from)) {
      merged.push_back(std::move(r));
      continue;
    }
    // Neighbours with the same form are one range. The claims stop short of an irrational end; another one bridges it.
    const RealAlgebraic& cut = r.interval.from;
    if (!cut.rational()) {
      const RealAlgebraic left = rational_between(merged.back().interval.from, cut);
      const RealAlgebraic right = rational_between(cut, r.interval.to);
      const RealAlgebraic near(cut.upper() + (right.lower() - cut.upper()) / Rational(16));
      const auto bridge = follower.serve(left, right, rational_between(cut, near), [&](const ParameterInterval& i) {
        return less(i.from, cut) && less(cut, i.to);
      });
      if (!bridge || !less(bridge->range.interval.from, cut) || !less(cut, bridge->range.interval.to)) {
        merged.push_back(std::move(r));
        continue;
      }
      claims.push_back(bridge->claim);
    }
    merged.back().interval.to = r.interval.to;
  }
  return merged;
}

}  // namespace twoscale::analysis
