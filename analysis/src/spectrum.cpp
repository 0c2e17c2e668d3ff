// SPDX-License-Identifier: GPL-3.0-or-later
//   mathematics                                    here
//   S_ij = a_{i-mj}                                local_matrix
//   p irreducible, p(theta) = 0, w in ker p(S)     eigenvectors: u = q(theta, S) w, q(x, y) = (p(x) - p(y))/(x - y),
//                                                  since (S - theta) u = p(S) w - p(theta) w = 0
//   l_n S = m^{-n} l_n, S u_n = m^{-n} u_n         limit_stencils: u_n(j) = j^n/n! + ..., l_n u_n = 1
#include "twoscale/analysis/spectrum.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <set>

#include "twoscale/analysis/roots.hpp"
#include "twoscale/symbolic/ball.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/integer.hpp"

namespace twoscale::analysis {

namespace {

constexpr long decimal_digits = 17;

long floor_division(long a, long b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

// ---- factors of the characteristic polynomial

// c_k in p = sum_k c_k x^k.
std::vector<Polynomial> coefficients_in(const Polynomial& p, const std::string& x) {
  std::vector<Polynomial> c(static_cast<std::size_t>(std::max(0L, p.degree(x))) + 1);
  p.for_each_term([&](const Rational& k, std::span<const unsigned long> e) {
    Polynomial term = Polynomial::constant(k.numerator());
    std::size_t power = 0;
    for (std::size_t i = 0; i < e.size(); ++i) {
      if (p.variables()[i] == x)
        power = e[i];
      else if (e[i] != 0)
        term *= Polynomial::variable(p.variables()[i]).pow(static_cast<unsigned>(e[i]));
    }
    c[power] += term;
  });
  return c;
}

// Multiplies a polynomial by its common denominator; x is a new variable.
Polynomial cleared(const SpectralPolynomial& p, const std::string& x) {
  const CommonDenominator d = common_denominator(p);
  Polynomial r;
  for (std::size_t k = 0; k < p.size(); ++k)
    r += numerator_over(p[k], d) * Polynomial::variable(x).pow(static_cast<unsigned>(k));
  return r;
}

struct PolynomialOrder {
  bool operator()(const Polynomial& a, const Polynomial& b) const { return Polynomial::compare(a, b) < 0; }
};

std::vector<SpectralFactor> factors_of(const std::vector<SpectralPolynomial>& blocks, const std::string& x) {
  std::map<Polynomial, unsigned, PolynomialOrder> found;
  for (const auto& block : blocks)
    for (const auto& [f, e] : cleared(block, x).factor().factors)
      if (f.degree(x) > 0) found[f] += e;
  std::vector<SpectralFactor> factors;
  for (const auto& [f, e] : found) {
    SpectralFactor s;
    const auto c = coefficients_in(f, x);
    for (const auto& k : c) s.polynomial.push_back(RationalFunction::fraction(k, c.back()));
    s.multiplicity = e;
    factors.push_back(std::move(s));
  }
  std::stable_sort(factors.begin(), factors.end(),
                   [](const auto& a, const auto& b) { return a.degree() < b.degree(); });
  return factors;
}

std::optional<std::vector<Rational>> rational_polynomial(const SpectralPolynomial& p) {
  std::vector<Rational> r;
  for (const auto& c : p) {
    const auto value = c.constant();
    if (!value) return std::nullopt;
    r.push_back(*value);
  }
  return r;
}

// ---- eigenvectors

template <class T>
std::size_t rank_of_columns(const std::vector<std::vector<T>>& columns) {
  Matrix<T> m(columns.size(), columns[0].size());
  for (std::size_t i = 0; i < columns.size(); ++i)
    for (std::size_t j = 0; j < columns[i].size(); ++j) m(i, j) = columns[i][j];
  return rank(m);
}

// The kernel of a matrix; of one that commutes with the reversal, first the even vectors, then the odd ones.
template <class T>
std::vector<std::vector<T>> split_kernel(const Matrix<T>& a) {
  if (!commutes_with_reversal(a)) return kernel(a);
  const std::size_t n = a.rows();
  std::vector<std::vector<T>> basis;
  for (const bool odd : {false, true})
    for (auto x : kernel(symmetric_part(a, odd))) {
      for (std::size_t j = x.size(); j < n; ++j) {
        const T mirror = n - 1 - j < x.size() ? x[n - 1 - j] : T(0);
        x.push_back(odd ? -mirror : mirror);
      }
      basis.push_back(std::move(x));
    }
  return basis;
}

template <class T>
std::vector<Eigenvector> eigenvectors(const Matrix<T>& a, const std::vector<T>& p) {
  const std::size_t n = a.rows();
  const std::size_t d = p.size() - 1;
  const auto null_space = split_kernel(polynomial_of(a, p));
  std::vector<Eigenvector> result;
  std::vector<std::vector<T>> spanned;
  for (const auto& start : null_space) {
    if (result.size() * d == null_space.size()) break;
    std::vector<std::vector<T>> powers{start};  // w, a w, .., a^{d-1} w
    while (powers.size() < d) powers.push_back(product(a, powers.back()));
    if (d > 1) {
      auto wider = spanned;
      wider.push_back(start);
      if (!spanned.empty() && rank_of_columns(wider) == spanned.size()) continue;
      spanned.insert(spanned.end(), powers.begin(), powers.end());
    }
    std::vector<T> flat(n * d);  // entry j, power i of x at j d + i: sum_{k>i} p_k (a^{k-1-i} w)_j
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < d; ++i)
        for (std::size_t k = i + 1; k <= d; ++k) flat[j * d + i] += p[k] * powers[k - 1 - i][j];
    flat = primitive(flat);
    Eigenvector u(n);
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < d; ++i) u[j].emplace_back(flat[j * d + i]);
    for (auto& entry : u)
      while (entry.size() > 1 && entry.back().is_zero()) entry.pop_back();
    result.push_back(std::move(u));
  }
  return result;
}

// Of +-u the one that grows to the right: (-1, 0, 1) and not (1, 0, -1).
void turn(Eigenvector& u) {
  const auto last = std::find_if(u.rbegin(), u.rend(), [](const auto& entry) { return !entry.back().is_zero(); });
  if (last == u.rend() || last->back().numerator().leading_sign() > 0) return;
  for (auto& entry : u)
    for (auto& c : entry) c = -c;
}

template <class T>
void find_eigenvectors(SpectralFactor& f, const Matrix<T>& a, const Matrix<T>& transpose, const std::vector<T>& p) {
  f.right = eigenvectors(a, p);
  for (auto& u : f.right) turn(u);
  f.left = eigenvectors(transpose, p);
  f.geometric = static_cast<unsigned>(f.right.size());
}

// ---- expressions of quadratic eigenvalues

// n = s^2 t, t without the squares of small primes and not a square itself.
std::pair<Rational, Rational> split_square(const Rational& n) {
  Integer rest, s, q;
  fmpz_set(rest.v, n.numerator());
  fmpz_one(s.v);
  for (ulong p = 2; p < 4096; ++p)
    while (fmpz_divisible_si(rest.v, static_cast<slong>(p * p))) {
      fmpz_divexact_ui(rest.v, rest.v, p * p);
      fmpz_mul_ui(s.v, s.v, p);
    }
  fmpz_abs(q.v, rest.v);
  if (fmpz_is_square(q.v)) {
    fmpz_sqrt(q.v, q.v);
    fmpz_mul(s.v, s.v, q.v);
    fmpz_set_si(rest.v, fmpz_sgn(rest.v));
  }
  return {Rational(s.v), Rational(rest.v)};
}

// In parentheses if it is a sum.
std::string parenthesised(const std::string& text) {
  long depth = 0;
  for (const char c : text) {
    if (c == '(') ++depth;
    if (c == ')') --depth;
    if (c == ' ' && depth == 0) return "(" + text + ")";  // blanks stand around + and - only
  }
  return text;
}

// The two roots -b/2 -+ sqrt(b^2/4 - c), the one with the minus sign first.
std::array<std::string, 2> quadratic_roots(const SpectralPolynomial& p) {
  const RationalFunction middle = p[1] * RationalFunction(Rational(-1, 2));
  const RationalFunction under = middle * middle - p[0];
  // under = numerator/denominator = outside^2 * inside, inside a polynomial.
  const auto top = under.numerator().factor();
  const auto [s, t] = split_square(top.content * under.denominator_content());
  RationalFunction outside = s / under.denominator_content();
  Polynomial inside = 1;
  for (const auto& [f, e] : top.factors) {
    outside *= RationalFunction(f.pow(e / 2));
    if (e % 2 == 1) inside *= f;
  }
  for (const auto& [f, e] : under.denominator_factors()) {
    outside *= RationalFunction::over_factors(1, 1, {{f, (e + 1) / 2}});
    if (e % 2 == 1) inside *= f;
  }
  const bool imaginary = inside.is_one() && t.sign() < 0;
  inside = inside.scaled(imaginary ? -t : t);
  std::string root = imaginary ? "I" : "";
  if (!inside.is_one()) root += (root.empty() ? "" : "*") + ("sqrt(" + RationalFunction(inside).to_string() + ")");
  const Polynomial over = outside.numerator();
  const Polynomial below = outside.denominator();
  if (!over.is_one()) root = parenthesised(RationalFunction(over).to_string()) + "*" + root;
  if (!below.is_one())
    root += below.is_constant() ? "/" + below.to_string() : "/(" + RationalFunction(below).to_string() + ")";
  if (middle.is_zero()) return {"-" + root, root};
  return {middle.to_string() + " - " + root, middle.to_string() + " + " + root};
}

// ---- order of the eigenvalues

struct Numeric {
  Eigenvalue value;
  RootOf root;
};

int kind(const RootOf& r) {
  if (!r.roots->is_real(r.index)) return 2;
  return arb_is_negative(acb_realref(r.roots->enclose(64)[r.index])) != 0 ? 1 : 0;
}

// By decreasing modulus; ties as the header says. What cannot be told apart counts as equal.
bool comes_before(const RootOf& a, const RootOf& b) {
  const auto order = compare_moduli(a, b);
  if (order && *order != std::strong_ordering::equal) return *order == std::strong_ordering::greater;
  if (kind(a) != kind(b)) return kind(a) < kind(b);
  acb_srcptr x = a.roots->enclose(256)[a.index];
  acb_srcptr y = b.roots->enclose(256)[b.index];
  if (!arb_overlaps(acb_realref(x), acb_realref(y))) return arb_gt(acb_realref(x), acb_realref(y)) != 0;
  return arb_gt(acb_imagref(x), acb_imagref(y)) != 0;
}

// ---- what is read off

// The largest N <= most such that the mask has sum rules of order N with a(1) = m: S maps polynomials of degree < N to
// such, with the eigenvalues m^{-r}.
long sum_rules(const Laurent& mask, int arity, long most) {
  if (!(mask.at_one() == RationalFunction(arity))) return 0;
  for (long r = 0; r < most; ++r) {
    std::vector<RationalFunction> moments(static_cast<std::size_t>(arity));
    for (long i = mask.lowest(); i <= mask.highest(); ++i)
      moments[static_cast<std::size_t>(((i % arity) + arity) % arity)] +=
          mask.coefficient(i) * RationalFunction(Rational(i).pow(r));
    for (const auto& c : moments)
      if (!(c == moments[0])) return r;
  }
  return most;
}

std::vector<RationalFunction> plain(const Eigenvector& u) {
  std::vector<RationalFunction> r;
  for (const auto& entry : u) r.push_back(entry[0]);
  return r;
}

// n! times the n-th divided difference on the knots if it is a constant other than 0: n! times the leading coefficient
// of a polynomial of degree n.
std::optional<RationalFunction> leading_coefficient(std::vector<RationalFunction> u,
                                                    const std::vector<RationalFunction>& knots, long n) {
  for (std::size_t k = 1; k <= static_cast<std::size_t>(n) && !u.empty(); ++k) {
    for (std::size_t j = 0; j + 1 < u.size(); ++j)
      u[j] = RationalFunction(static_cast<long>(k)) * (u[j + 1] - u[j]) / (knots[j + k] - knots[j]);
    u.pop_back();
  }
  if (u.empty() || u[0].is_zero()) return std::nullopt;
  for (const auto& c : u)
    if (!(c == u[0])) return std::nullopt;
  return u[0];
}

std::optional<LimitStencil> limit_stencil(const SpectralFactor& f, long lowest,
                                          const std::vector<RationalFunction>& knots, long n) {
  const auto u = plain(f.right[0]);
  const auto left = plain(f.left[0]);
  const auto lead = leading_coefficient(u, knots, n);
  RationalFunction pairing;
  for (std::size_t j = 0; j < u.size(); ++j) pairing += left[j] * u[j];
  if (!lead || pairing.is_zero()) return std::nullopt;
  const RationalFunction scale = *lead / pairing;
  std::vector<RationalFunction> c;
  for (const auto& x : left) c.push_back(scale * x);
  const Laurent trimmed(lowest, std::move(c));
  return LimitStencil{static_cast<unsigned>(n), trimmed.lowest(), trimmed.coefficients()};
}

// The factor x - m^{-n}.
const SpectralFactor* factor_of_power(const Spectrum& s, long n) {
  const RationalFunction constant = -Rational(s.arity).pow(-n);
  for (const auto& f : s.factors)
    if (f.degree() == 1 && f.polynomial[0] == constant) return &f;
  return nullptr;
}

std::string name_of(const Eigenvalue& e) { return e.exact.empty() ? e.decimal : e.exact; }

NecessaryConditions necessary_conditions(const Spectrum& s, const std::vector<Numeric>& numeric, long sum_rule_order) {
  NecessaryConditions r;
  const auto stop = [&](std::string why) { r.obstruction = std::move(why); };
  for (long n = 0; r.obstruction.empty(); ++n) {
    const Rational power = Rational(s.arity).pow(-n);
    const std::string bound = power.to_string();
    const SpectralFactor* f = factor_of_power(s, n);
    if (f == nullptr) {
      stop(bound + " is not an eigenvalue");
    } else if (f->multiplicity > 1) {
      stop("the eigenvalue " + bound + " has multiplicity " + std::to_string(f->multiplicity));
    } else {
      for (const auto& [value, root] : numeric) {
        const SpectralFactor& own = s.factors[value.factor];
        bool smaller_power = false;
        for (long k = 0; k <= n; ++k) smaller_power = smaller_power || &own == factor_of_power(s, k);
        if (smaller_power) continue;
        const auto order = compare_modulus(root, power);
        if (!order) {
          r.kind = NecessaryConditions::Kind::undecided;
          stop("not decided whether the eigenvalue " + name_of(value) + " is smaller in modulus than " + bound);
        } else if (*order != std::strong_ordering::less) {
          stop("the eigenvalue " + name_of(value) + " is not smaller in modulus than " + bound);
        }
        if (!r.obstruction.empty()) break;
      }
    }
    if (!r.obstruction.empty()) break;
    if (sum_rule_order <= n) {
      stop(n == 0 ? "constants are not reproduced" : "x^" + std::to_string(n) + " is not generated");
    } else {
      r.order = n;
    }
  }
  if (numeric.size() < s.eigenvalues.size() && r.order >= 0) {
    if (r.kind == NecessaryConditions::Kind::decided) r.kind = NecessaryConditions::Kind::conditional;
    const std::string bound = Rational(s.arity).pow(-r.order).to_string();
    for (std::size_t i = numeric.size(); i < s.eigenvalues.size(); ++i) {
      const Eigenvalue& e = s.eigenvalues[i];
      const std::string name =
          e.exact.empty() ? "roots of " + polynomial_text(s.factors[e.factor].polynomial, s.variable) : e.exact;
      r.conditions.push_back("|" + name + "| < " + bound);
    }
  }
  return r;
}

// Factors, eigenvectors and eigenvalues of the matrix; `numeric` points into `roots`.
Spectrum decomposed(LocalMatrix matrix, int arity, std::vector<std::unique_ptr<Roots>>& roots,
                    std::vector<Numeric>& numeric) {
  Spectrum s;
  s.arity = arity;
  s.matrix = std::move(matrix);
  const auto occurs = [&](const std::string& name) {
    for (std::size_t i = 0; i < s.matrix.entries.rows(); ++i)
      for (std::size_t j = 0; j < s.matrix.entries.columns(); ++j) {
        const auto names = s.matrix.entries(i, j).variables();
        if (std::find(names.begin(), names.end(), name) != names.end()) return true;
      }
    return false;
  };
  for (s.variable = "x"; occurs(s.variable);) s.variable += "x";
  const auto rational = constant(s.matrix.entries);
  if (rational) {
    SpectralPolynomial p;
    for (const auto& c : characteristic_polynomial(*rational)) p.emplace_back(c);
    s.factors = factors_of({p}, s.variable);
    const Matrix<Rational> transpose = transposed(*rational);
    for (auto& f : s.factors) find_eigenvectors(f, *rational, transpose, *rational_polynomial(f.polynomial));
  } else {
    s.factors = factors_of(characteristic_blocks(s.matrix.entries), s.variable);
    const SymbolicMatrix transpose = transposed(s.matrix.entries);
    for (auto& f : s.factors) find_eigenvectors(f, s.matrix.entries, transpose, f.polynomial);
  }

  std::vector<Eigenvalue> symbolic;
  for (std::size_t i = 0; i < s.factors.size(); ++i) {
    const SpectralFactor& f = s.factors[i];
    const auto quadratic = f.degree() == 2 ? quadratic_roots(f.polynomial) : std::array<std::string, 2>{};
    const auto polynomial = rational_polynomial(f.polynomial);
    if (!polynomial) {
      Eigenvalue e;
      e.factor = i;
      if (f.degree() == 1) e.exact = (-f.polynomial[0]).to_string();
      if (f.degree() == 2) {
        e.exact = quadratic[1];
        symbolic.push_back(e);
        e.exact = quadratic[0];
      }
      if (f.degree() > 2) e.roots = f.degree();
      symbolic.push_back(std::move(e));
      continue;
    }
    roots.push_back(std::make_unique<Roots>(*polynomial));
    const Roots& r = *roots.back();
    for (std::size_t j = 0; j < r.size(); ++j) {
      Eigenvalue e;
      e.factor = i;
      e.decimal = r.decimal(j, decimal_digits);
      if (f.degree() == 1) {
        e.exact = (-(*polynomial)[0]).to_string();
        e.real = {-(*polynomial)[0], -(*polynomial)[0]};
        e.imaginary = {Rational(0), Rational(0)};
      } else {
        const auto box = r.isolate(j);
        e.real = box.real;
        e.imaginary = box.imaginary;
        acb_srcptr ball = r.enclose(64)[j];
        const bool second = r.is_real(j) ? j == 1 : arb_is_positive(acb_imagref(ball)) != 0;
        if (f.degree() == 2) e.exact = quadratic[second ? 1 : 0];
      }
      const auto approximation = [](const std::array<Rational, 2>& x) {
        return fmpq_get_d(x[0].raw()) / 2 + fmpq_get_d(x[1].raw()) / 2;
      };
      e.approximate = {approximation(*e.real), approximation(*e.imaginary)};
      // Insertion: an order that cannot be decided everywhere may fail to be one.
      std::size_t at = numeric.size();
      const RootOf own{&r, j};
      while (at > 0 && comes_before(own, numeric[at - 1].root)) --at;
      numeric.insert(numeric.begin() + static_cast<std::ptrdiff_t>(at), Numeric{std::move(e), own});
    }
  }
  for (const auto& n : numeric) s.eigenvalues.push_back(n.value);
  s.eigenvalues.insert(s.eigenvalues.end(), symbolic.begin(), symbolic.end());
  return s;
}

}  // namespace

std::string polynomial_text(const SpectralPolynomial& p, const std::string& variable) {
  if (p.size() == 1) return p[0].to_string();
  std::string s;
  for (std::size_t k = p.size(); k-- > 0;) {
    if (p[k].is_zero()) continue;
    std::string term = p[k].to_string();
    const bool negative = term[0] == '-';  // in front of the whole coefficient
    if (negative) term = p[k].constant() ? term.substr(1) : (-p[k]).to_string();
    term = parenthesised(term);
    const std::string power = k == 0 ? "" : k == 1 ? variable : variable + "^" + std::to_string(k);
    if (k > 0) term = term == "1" ? power : term + "*" + power;
    s += s.empty() ? (negative ? "-" : "") : negative ? " - " : " + ";
    s += term;
  }
  return s.empty() ? "0" : s;
}

LocalMatrix local_matrix(const Laurent& mask, int arity) {
  if (mask.is_zero()) bad_input("the mask is zero");
  const long lowest = -floor_division(mask.highest(), arity - 1);
  const long top = floor_division(-mask.lowest(), arity - 1);
  if (top < lowest)
    bad_input("no range of points is refined from itself, the mask is shorter than the arity",
              std::to_string(mask.coefficients().size()) + " coefficients");
  const auto n = static_cast<std::size_t>(top - lowest + 1);
  LocalMatrix r{lowest, SymbolicMatrix(n, n)};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      r.entries(i, j) = mask.coefficient(lowest + static_cast<long>(i) - arity * (lowest + static_cast<long>(j)));
  return r;
}

Spectrum spectrum(const Laurent& mask, int arity) {
  LocalMatrix matrix = local_matrix(mask, arity);
  std::vector<RationalFunction> knots;
  for (std::size_t j = 0; j < matrix.entries.rows(); ++j) knots.emplace_back(matrix.lowest + static_cast<long>(j));
  const long order = sum_rules(mask, arity, static_cast<long>(matrix.entries.rows()));
  return spectrum(std::move(matrix), arity, knots, order);
}

Spectrum spectrum(LocalMatrix matrix, int arity) {
  std::vector<std::unique_ptr<Roots>> roots;
  std::vector<Numeric> numeric;
  return decomposed(std::move(matrix), arity, roots, numeric);
}

Spectrum spectrum(LocalMatrix matrix, int arity, const std::vector<RationalFunction>& knots, long order) {
  std::vector<std::unique_ptr<Roots>> roots;
  std::vector<Numeric> numeric;
  Spectrum s = decomposed(std::move(matrix), arity, roots, numeric);
  for (long n = 0; n < order; ++n) {
    const SpectralFactor* f = factor_of_power(s, n);
    if (f == nullptr || f->multiplicity != 1) continue;
    if (auto stencil = limit_stencil(*f, s.matrix.lowest, knots, n)) s.stencils.push_back(*std::move(stencil));
  }
  s.necessary = necessary_conditions(s, numeric, order);
  return s;
}

}  // namespace twoscale::analysis
