// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/lowering/refine_hermite.hpp"

#include <algorithm>
#include <cmath>

#include "rounding.hpp"
#include "twoscale/kernels/hermite.hpp"
#include "twoscale/kernels/number_text.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"
#include "twoscale/symbolic/hermite_circle.hpp"

namespace twoscale::lowering {

namespace {

constexpr double most_vertices = 1e8;
constexpr double most_output = 4294967296.0;
constexpr int most_attempts = 6;

// A ball that carries its working precision; integers have the least, and the wider operand decides.
struct Real {
  Ball value;
  long bits = 64;

  Real() = default;
  explicit Real(int n) { arb_set_si(value.raw(), n); }
  Real(const Rational& q, long precision) : value(q, precision), bits(precision) {}
  Real(Ball ball, long precision) : value(std::move(ball)), bits(precision) {}
};

template <class Operation>
Real combine(const Real& a, const Real& b, Operation operation) {
  Real r;
  r.bits = std::max(a.bits, b.bits);
  operation(r.value.raw(), a.value.raw(), b.value.raw(), r.bits);
  return r;
}

template <class Operation>
Real apply(const Real& a, Operation operation) {
  Real r;
  r.bits = a.bits;
  operation(r.value.raw(), a.value.raw(), r.bits);
  return r;
}

Real operator+(const Real& a, const Real& b) { return combine(a, b, arb_add); }
Real operator-(const Real& a, const Real& b) { return combine(a, b, arb_sub); }
Real operator*(const Real& a, const Real& b) { return combine(a, b, arb_mul); }
Real operator/(const Real& a, const Real& b) { return combine(a, b, arb_div); }
Real operator-(const Real& a) {
  return apply(a, [](arb_struct* r, const arb_struct* x, long) { arb_neg(r, x); });
}
Real sqrt(const Real& a) { return apply(a, arb_sqrtpos); }
Real sin(const Real& a) { return apply(a, arb_sin); }
Real tan(const Real& a) { return apply(a, arb_tan); }
Real atan2(const Real& y, const Real& x) { return combine(y, x, arb_atan2); }
double estimate(const Real& a) { return arf_get_d(arb_midref(a.value.raw()), ARF_RND_NEAR); }
bool negligible(const Real& x, const Real& scale) {
  Ball bound;
  arb_mul_2exp_si(bound.raw(), scale.value.raw(), -(x.bits - 16));
  return arf_cmpabs(arb_midref(x.value.raw()), arb_midref(bound.raw())) <= 0;
}

bool is_less(const Real& a, const Real& b, const char* what) {
  if (arb_lt(a.value.raw(), b.value.raw()) != 0) return true;
  if (arb_ge(a.value.raw(), b.value.raw()) != 0) return false;
  throw kernels::HermiteUndecided(what);
}
Real widened(Real x, const Real& error) {
  arb_add_error(x.value.raw(), error.value.raw());
  return x;
}

kernels::HermiteRuleTension kernel_tension(const Scheme& scheme) {
  const auto tension = hermite_tension(scheme);
  if (!tension)
    bad_input("refinement of vertices with derivatives is known for the rules of hermite2010 only", scheme.id);
  return *tension == HermiteTension::c2 ? kernels::HermiteRuleTension::c2 : kernels::HermiteRuleTension::printed;
}

// Where the columns of the data stand in a file.
struct Layout {
  std::size_t dim = 2;
  std::vector<std::size_t> f, p, r;
  std::optional<std::size_t> sigma;
  std::vector<std::string> names;  // of all columns
};

Layout layout(const kernels::PointSet& points) {
  Layout at;
  std::vector<std::string> names = points.columns;
  const std::size_t count = points.dim;
  if (names == kernels::default_columns(count) && count > 3) {  // no header
    if (count != 6 && count != 7 && count != 9 && count != 10)
      bad_input("Hermite data have 2, 3, 6, 7, 9 or 10 columns when none is named, not", std::to_string(count));
    names.clear();
    for (const char* letter : {"f", "p", "r"})
      for (std::size_t c = 0; c < count / 3; ++c) names.push_back(letter + std::string(1, "xyz"[c]));
    if (count % 3 == 1) names.push_back("sigma");
  }
  std::vector<bool> used(count);
  const auto find = [&](const std::string& name) -> std::optional<std::size_t> {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    const auto index = static_cast<std::size_t>(found - names.begin());
    used[index] = true;
    return index;
  };
  const auto vector = [&](const std::string& letter) {
    std::vector<std::size_t> list;
    for (const char c : {'x', 'y', 'z'})
      if (const auto index = find(letter + c)) list.push_back(*index);
    return list;
  };
  at.f = vector("f");
  if (at.f.empty()) at.f = vector("");
  at.dim = at.f.size();
  if (at.dim != 2 && at.dim != 3) bad_input("Hermite data need the columns fx,fy or fx,fy,fz", points.columns[0]);
  at.p = vector("p");
  at.r = vector("r");
  at.sigma = find("sigma");
  if (at.p.size() != at.r.size() || (!at.p.empty() && at.p.size() != at.dim))
    bad_input("Hermite data have all components of p and r, or none", at.p.size() < at.dim ? "p" : "r");
  at.names = names;
  for (std::size_t i = 0; i < count; ++i)
    if (!used[i]) bad_input("this column is none of fx,fy,fz,px,py,pz,rx,ry,rz,sigma", points.columns[i]);
  return at;
}

// The last vertex repeats the first one: as nearly as two points count as equal, its derivatives to 1e-9. `values`: all
// numbers of the file, N exact or double.
template <class N>
bool returns(const std::vector<N>& values, std::size_t columns, const Layout& at, const N& equal, const N& nearly) {
  const std::size_t last = values.size() / columns - 1;
  if (last == 0) return false;
  const auto square_of_gap = [&](const std::vector<std::size_t>& list, std::size_t row) {
    N square(0);
    for (const std::size_t c : list) {
      const N d = values[c] - values[row * columns + c];
      square = square + d * d;
    }
    return square;
  };
  for (const auto* list : {&at.f, &at.p, &at.r}) {
    N size(0);
    for (std::size_t i = 1; i < last; ++i)
      if (const N own = square_of_gap(*list, i); size < own) size = own;
    const N& tolerance = list == &at.f ? equal : nearly;
    if (tolerance * tolerance * size < square_of_gap(*list, last)) return false;
  }
  return true;
}

template <class T, class Read>
kernels::HermiteData<T> read_data(const kernels::PointSet& points, const Layout& at, std::size_t n, bool closed,
                                  Read read) {
  kernels::HermiteData<T> data;
  data.dim = at.dim;
  data.closed = closed;
  for (std::size_t i = 0; i < n; ++i) {
    const auto append = [&](std::vector<T>& to, const std::vector<std::size_t>& columns) {
      for (const std::size_t c : columns) to.push_back(read(i * points.dim + c));
    };
    append(data.f, at.f);
    append(data.p, at.p);
    append(data.r, at.r);
    if (at.sigma) data.sigma.push_back(read(i * points.dim + *at.sigma));
  }
  return data;
}

// The numbers of the output in the order of its columns.
template <class T>
std::vector<T> in_columns(const kernels::HermiteData<T>& data, const Layout& at, std::size_t columns) {
  std::vector<T> values(data.size() * columns);
  for (std::size_t i = 0; i < data.size(); ++i) {
    T* const to = values.data() + i * columns;
    for (std::size_t c = 0; c < data.dim; ++c) {
      to[at.f[c]] = data.f[i * data.dim + c];
      if (at.p.empty()) continue;
      to[at.p[c]] = data.p[i * data.dim + c];
      to[at.r[c]] = data.r[i * data.dim + c];
    }
    if (at.sigma) to[*at.sigma] = data.sigma[i];
  }
  return values;
}

}  // namespace

HermiteResult refine_hermite(const Scheme& scheme, const std::optional<ExactReal>& w_given,
                             const kernels::PointSet& points, const HermiteOptions& options) {
  const auto tension = kernel_tension(scheme);
  const Layout in = layout(points);
  std::size_t n = points.size();
  std::vector<Rational> exact;  // with digits: the numbers of the file
  if (options.digits > 0)
    for (std::size_t i = 0; i < points.values.size(); ++i)
      exact.push_back(exact_decimal(i < points.tokens.size() ? points.tokens[i] : kernels::shortest(points.values[i])));
  if (options.closed &&
      (options.digits > 0 ? returns<Rational>(exact, points.dim, in, Rational(10).pow(-14), Rational(10).pow(-9))
                          : returns<double>(points.values, points.dim, in, 1e-14, 1e-9)))
    --n;
  if (static_cast<double>(n) * std::pow(2.0, options.levels) > most_vertices ||
      (options.digits > 0 && static_cast<double>(n) * std::pow(2.0, options.levels) *
                                     static_cast<double>(3 * in.dim + 1) * (static_cast<double>(options.digits) + 64) >
                                 most_output))
    bad_input("too many points would come out",
              std::to_string(n) + " points, " + std::to_string(options.levels) + " levels");
  std::optional<ExactReal> w = w_given;
  for (const auto& p : scheme.parameters)
    if (!w && p.scope == Parameter::Scope::constant && !p.default_value.empty()) w = parse_real(p.default_value);
  if (!w) bad_input("the tension has no value", "w");
  if (w->sign() != Sign::positive) bad_input("the tension w must be positive", w->decimal(17));

  const bool has_pole =
      tension == kernels::HermiteRuleTension::printed && (options.all_columns || w->rational() != Rational(1));
  Layout out = in;
  HermiteResult result;
  result.points.columns = in.names;
  if (options.all_columns) {
    result.points.columns.clear();
    std::size_t next = 0;
    const auto add = [&](const char* letter, std::vector<std::size_t>& list) {
      list.clear();
      for (std::size_t c = 0; c < in.dim; ++c) {
        list.push_back(next++);
        result.points.columns.push_back(letter + std::string(1, "xyz"[c]));
      }
    };
    add("f", out.f);
    add("p", out.p);
    add("r", out.r);
    out.sigma = next++;
    result.points.columns.emplace_back("sigma");
  }
  const std::size_t columns = result.points.columns.size();
  result.points.dim = columns;

  if (options.digits == 0) {
    double w_double = 0;
    if (!rounded_double(w->enclose(256), w_double)) w_double = std::stod(w->decimal(17));
    const kernels::HermiteCurve<double> curve(
        read_data<double>(points, in, n, options.closed, [&](std::size_t i) { return points.values[i]; }), w_double,
        tension);
    if (has_pole) result.first_pole = curve.first_pole();
    result.points.values = in_columns(curve.refined(options.levels), out, columns);
    for (const double x : result.points.values)
      if (!std::isfinite(x)) bad_input("a refined number does not fit a double", kernels::shortest(x));
    return result;
  }
  if (options.digits < 17 || options.digits > 10000)
    bad_input("digits must lie between 17 and 10000", std::to_string(options.digits));
  const auto measure = kernels::hermite_measure<Rational>(
      read_data<Rational>(points, in, n, options.closed, [&](std::size_t i) { return exact[i]; }).f, in.dim);
  // Errors of r grow like 4^levels.
  long guard = 20 + static_cast<long>(options.levels);
  std::string open;  // what the last attempt could not decide
  for (int attempt = 1; attempt <= most_attempts; ++attempt, guard = std::max(3 * guard, options.digits + guard)) {
    const long bits = static_cast<long>(std::ceil(static_cast<double>(options.digits + guard) * 3.3219281)) + 32;
    const auto read = [&](std::size_t i) { return Real(exact[i], bits); };
    try {
      kernels::HermiteData<Real> data = read_data<Real>(points, in, n, options.closed, read);
      data.measure = measure;
      const kernels::HermiteCurve<Real> curve(std::move(data), Real(w->enclose(bits), bits), tension);
      if (has_pole) result.first_pole = curve.first_pole();
      const std::vector<Real> fine = in_columns(curve.refined(options.levels), out, columns);
      std::vector<const Ball*> numbers;
      for (const Real& x : fine) numbers.push_back(&x.value);
      if (round_all(numbers, 1, bits, options.digits, result.points)) return result;
      open = "how the last digit of a refined number is rounded";
    } catch (const kernels::HermiteUndecided& e) {
      open = std::string("whether ") + e.what();
    }
  }
  throw Error(Error::Kind::undecided, "cannot decide with the precision tried " + open);
}

kernels::PointSet points_alone(const kernels::PointSet& points) {
  const Layout at = layout(points);
  kernels::PointSet out;
  out.dim = at.dim;
  out.columns = kernels::default_columns(at.dim);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (const std::size_t c : at.f) {
      out.values.push_back(points.values[i * points.dim + c]);
      if (!points.tokens.empty()) out.tokens.push_back(points.tokens[i * points.dim + c]);
    }
  out.closed = points.closed;
  return out;
}

}  // namespace twoscale::lowering
