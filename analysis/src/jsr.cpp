// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/analysis/jsr.hpp"

#include <acb.h>
#include <arb_fmpz_poly.h>
#include <arb_mat.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "jsr_search.hpp"
#include "number_field.hpp"
#include "parallel.hpp"
#include "twoscale/analysis/deadline.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::analysis {

using Json = nlohmann::ordered_json;

RationalMatrix product(const Family& family, const Word& word) {
  RationalMatrix p = RationalMatrix::identity(family[0].rows());
  for (const int s : word) p = family[static_cast<size_t>(s)] * p;
  return p;
}

namespace {

constexpr long working_bits = 192;    // of the balls that certify, beyond the size of the numbers
constexpr double interior = 1e-7;     // an image this far inside is proved to be inside; others become vertices
constexpr size_t most_cycles = 8;     // roots of one tree
constexpr long largest_degree = 230;  // of the equation of a radius; beyond it exact arithmetic is too slow
constexpr double coincidence = 1e-9;  // images this near to a vertex are tried as equal to it

void report(const JsrOptions& options, const std::string& line) {
  if (options.progress) options.progress(line);
}

// The nearest multiple of 2^-bits.
Rational dyadic(double x, int bits = 40) {
  Rational r;
  fmpz_set_d(fmpq_numref(r.raw()), std::round(std::ldexp(x, bits)));
  fmpz_one_2exp(fmpq_denref(r.raw()), static_cast<ulong>(bits));
  fmpq_canonicalise(r.raw());
  return r;
}

// A rational just below (direction -1) or above a double that is an enclosure's end.
Rational outward(double x, int direction) { return dyadic(x * (1 + direction * 1e-13), 60); }

Rational ball_lower(const Ball& b) {
  arf_t x;
  arf_init(x);
  arb_get_lbound_arf(x, b.raw(), 64);
  Rational r;
  arf_get_fmpq(r.raw(), x);
  arf_clear(x);
  return r;
}

double midpoint(const Ball& b) { return arf_get_d(arb_midref(b.raw()), ARF_RND_NEAR); }

Json word_json(const Word& w) {
  Json a = Json::array();
  for (const int s : w) a.push_back(s);
  return a;
}

Json rationals_json(const std::vector<Rational>& list) {
  Json a = Json::array();
  for (const auto& r : list) a.push_back(r.to_string());
  return a;
}

// ---- The combinatorial polytope, found in floating point

struct Image {
  size_t vertex;
  size_t matrix;
  std::optional<std::pair<size_t, int>> equals;         // (vertex, sign)
  std::vector<std::pair<size_t, double>> coefficients;  // otherwise
};

struct Polytope {
  size_t roots = 0;
  std::vector<RealVector> vertices;
  std::vector<std::pair<size_t, size_t>> tree;  // (parent, matrix) of vertices[roots + i]
  std::vector<Image> images;
  bool closed = false;
  std::optional<Word> better;  // a product that contradicts the normalisation
};

// Follows the images of the roots under `normalised` until all are inside. With inflation > 0 every new vertex is
// pushed outward by that factor and rounded to multiples of 2^-40. `faces`: images on the boundary count as inside, to
// be proved exactly.
Polytope estimate_polytope(const std::vector<Real>& normalised, std::vector<RealVector> roots, double inflation,
                           bool faces, size_t most, const Deadline& deadline) {
  const long d = normalised[0].rows();
  Polytope p;
  p.roots = roots.size();
  Hull hull(d);
  std::vector<Word> words;
  for (auto& r : roots) {
    hull.add(r);
    p.vertices.push_back(std::move(r));
    words.emplace_back();
  }
  for (size_t v = 0; v < p.vertices.size(); ++v) {
    for (size_t s = 0; s < normalised.size(); ++s) {
      if (p.vertices.size() > most || deadline.passed()) return p;
      RealVector x = normalised[s] * p.vertices[v];
      if (!x.allFinite()) return p;
      Image image{v, s, std::nullopt, {}};
      const Hull::Coordinates at = hull.estimate_coordinates(x);
      if (at.norm < 1 - interior) {
        image.coefficients = at.coefficients;
        p.images.push_back(std::move(image));
        continue;
      }
      if (inflation == 0 && at.norm < 1 + 1e-6) {
        for (size_t j = 0; j < p.vertices.size() && !image.equals; ++j)
          for (const int sign : {1, -1})
            if ((x - sign * p.vertices[j]).cwiseAbs().maxCoeff() < coincidence) image.equals.emplace(j, sign);
        if (image.equals) {
          p.images.push_back(std::move(image));
          continue;
        }
        if (faces && at.norm < 1 + coincidence) {
          image.coefficients = at.coefficients;
          p.images.push_back(std::move(image));
          continue;
        }
      }
      Word word = words[v];
      word.push_back(static_cast<int>(s));
      if (inflation == 0 && at.norm > 1 + 1e-4 && word.size() < 128) {
        Real b = Real::Identity(d, d);
        for (size_t i = word.size(); i-- > 0;) {
          b = b * normalised[static_cast<size_t>(word[i])];
          const size_t length = word.size() - i;
          if (estimate_spectral_radius(b) > 1 + 1e-8 * static_cast<double>(length)) {
            p.better = Word(word.begin() + static_cast<long>(i), word.end());
            return p;
          }
        }
      }
      if (inflation > 0) {
        x *= 1 + inflation;
        for (long i = 0; i < d; ++i) x(i) = std::round(std::ldexp(x(i), 40)) / std::ldexp(1.0, 40);
        image.coefficients.emplace_back(p.vertices.size(), 1 / (1 + inflation));
        p.images.push_back(std::move(image));
      } else {
        p.tree.emplace_back(v, s);
      }
      if (x.cwiseAbs().maxCoeff() > 1e6) return p;
      hull.add(x);
      p.vertices.push_back(std::move(x));
      words.push_back(std::move(word));
    }
  }
  p.closed = true;
  return p;
}

// d vertices that span, well conditioned if possible; empty if the vertices do not span.
std::vector<size_t> estimate_spanning(const std::vector<RealVector>& vertices, long d) {
  Real all(d, static_cast<long>(vertices.size()));
  for (size_t j = 0; j < vertices.size(); ++j) all.col(static_cast<long>(j)) = vertices[j];
  const Eigen::ColPivHouseholderQR<Real> qr(all);
  if (all.cols() < d || std::abs(qr.matrixR()(d - 1, d - 1)) < 1e-9 * std::abs(qr.matrixR()(0, 0))) return {};
  std::vector<size_t> chosen;
  for (long j = 0; j < d; ++j) chosen.push_back(static_cast<size_t>(qr.colsPermutation().indices()(j)));
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

Json inner_json(const std::vector<size_t>& inner) {
  Json a = Json::array();
  for (const size_t i : inner) a.push_back(i);
  return a;
}

Json sum_json(const std::vector<std::pair<size_t, Rational>>& sum) {
  Json a = Json::array();
  for (const auto& [j, c] : sum) a.push_back(Json::array({j, c.to_string()}));
  return Json::object({{"sum", a}});
}

std::vector<std::pair<size_t, Rational>> rounded(const std::vector<std::pair<size_t, double>>& coefficients) {
  std::vector<std::pair<size_t, Rational>> sum;
  for (const auto& [j, c] : coefficients)
    if (Rational r = dyadic(c); !r.is_zero()) sum.emplace_back(j, std::move(r));
  return sum;
}

// ---- Exact verification

// Rational points: y = sum c_j x_j + X_inner d, sum |c| + sum |d| <= 1.
bool inside(const std::vector<std::vector<Rational>>& x, const RationalMatrix& inverse, const std::vector<Rational>& y,
            const std::vector<std::pair<size_t, Rational>>& sum) {
  std::vector<Rational> e = y;
  Rational total;
  for (const auto& [j, c] : sum) {
    total += abs(c);
    for (size_t i = 0; i < e.size(); ++i) e[i] -= c * x[j][i];
  }
  for (const auto& r : inverse* e) total += abs(r);
  return total <= Rational(1);
}

// The exact coordinates of y in the vertices named by `sum`, if these are linearly independent and suffice.
std::optional<std::vector<std::pair<size_t, Rational>>> exact_coordinates(
    const std::vector<std::vector<Rational>>& x, const std::vector<Rational>& y,
    const std::vector<std::pair<size_t, double>>& support) {
  std::vector<std::vector<Rational>> columns;
  for (const auto& [j, c] : support) columns.push_back(x[j]);
  columns.push_back(y);
  const RationalMatrix kernel = RationalMatrix::from_columns(static_cast<long>(y.size()), columns).kernel();
  const long n = static_cast<long>(support.size());
  if (kernel.columns() != 1 || kernel(n, 0).is_zero()) return std::nullopt;
  std::vector<std::pair<size_t, Rational>> sum;
  for (long i = 0; i < n; ++i)
    if (Rational c = -kernel(i, 0) / kernel(n, 0); !c.is_zero())
      sum.emplace_back(support[static_cast<size_t>(i)].first, c);
  return sum;
}

Json block_json(long size, const std::string& bound, Json roots, const std::vector<std::pair<size_t, size_t>>& tree,
                const std::vector<size_t>& inner, Json images) {
  Json t = Json::array();
  for (const auto& [parent, matrix] : tree) t.push_back(Json::array({parent, matrix}));
  Json b;
  b["size"] = size;
  b["bound"] = bound;
  b["roots"] = std::move(roots);
  b["tree"] = std::move(t);
  b["inner"] = inner_json(inner);
  b["images"] = std::move(images);
  return b;
}

Json root_json(const Word& word, int sign, const Rational& scale, const std::vector<std::string>& vector) {
  Json r;
  r["word"] = word_json(word);
  r["sign"] = sign;
  r["scale"] = scale.to_string();
  r["vector"] = vector;
  return r;
}

// ---- JSR(block) <= R by rational vertices

bool all_zero(const Family& family) {
  return std::all_of(family.begin(), family.end(), [](const RationalMatrix& b) { return b.is_zero(); });
}

std::vector<Real> normalised_by(const Family& family, double radius) {
  std::vector<Real> list;
  for (const auto& b : family) list.push_back(estimate_matrix(b) / radius);
  return list;
}

RealVector unit_length(RealVector x) { return x / x.cwiseAbs().maxCoeff(); }

// Real and imaginary part of the leading eigenvectors of a matrix.
std::vector<RealVector> estimate_leading_vectors(const Real& b) {
  const Eigen::EigenSolver<Real> solver(b);
  long best = 0;
  for (long i = 1; i < b.rows(); ++i)
    if (std::abs(solver.eigenvalues()(i)) > std::abs(solver.eigenvalues()(best)) * (1 + 1e-12)) best = i;
  std::vector<RealVector> list{unit_length(solver.eigenvectors().col(best).real())};
  const RealVector imaginary = solver.eigenvectors().col(best).imag();
  if (imaginary.cwiseAbs().maxCoeff() > 1e-9) list.push_back(unit_length(imaginary));
  return list;
}

std::optional<Json> prove_block_upper(const Family& block, const Rational& bound, const CycleSearch& cycles,
                                      double inflation, const JsrOptions& options, const Deadline& deadline) {
  const long d = block[0].rows();
  if (bound.sign() <= 0) return std::nullopt;
  const std::vector<Real> normalised = normalised_by(block, fmpq_get_d(bound.raw()));
  std::vector<RealVector> roots;
  for (size_t i = 0; i < cycles.words.size() && i < 4; ++i) {
    Real b = Real::Identity(d, d);
    for (const int s : cycles.words[i]) b = normalised[static_cast<size_t>(s)] * b;
    for (auto& r : estimate_leading_vectors(b)) roots.push_back(std::move(r));
  }
  if (roots.empty()) roots.push_back(RealVector::Ones(d));
  for (auto& r : roots)
    for (long i = 0; i < d; ++i) r(i) = std::round(std::ldexp(r(i), 40)) / std::ldexp(1.0, 40);
  for (int attempt = 0; attempt < 2; ++attempt) {
    // The second time with short unit vectors, which make the hull full-dimensional from the start.
    if (attempt == 1)
      for (long i = 0; i < d; ++i) roots.push_back(RealVector::Unit(d, i) / 1024);
    const Polytope p = estimate_polytope(normalised, roots, inflation, false, options.vertices, deadline);
    if (!p.closed) continue;
    const std::vector<size_t> inner = estimate_spanning(p.vertices, d);
    if (inner.empty()) continue;
    std::vector<std::vector<Rational>> x;
    Json root_list = Json::array();
    for (const auto& v : p.vertices) {
      std::vector<Rational> exact;
      std::vector<std::string> integers;
      for (long i = 0; i < d; ++i) {
        exact.push_back(dyadic(v(i)));
        integers.push_back((exact.back() * Rational(1L << 40)).to_string());
      }
      x.push_back(std::move(exact));
      root_list.push_back(root_json({}, 1, Rational(1, 1L << 40), integers));
    }
    std::vector<std::vector<Rational>> columns;
    for (const size_t i : inner) columns.push_back(x[i]);
    const auto inverse = RationalMatrix::from_columns(d, columns).inverse();
    if (!inverse) continue;
    std::vector<RationalMatrix> scaled;
    for (const auto& b : block) scaled.push_back(bound.inverse() * b);
    Json images = Json::array();
    bool good = true;
    for (const auto& image : p.images) {
      const auto sum = rounded(image.coefficients);
      if (!inside(x, *inverse, scaled[image.matrix] * x[image.vertex], sum)) {
        good = false;
        break;
      }
      images.push_back(sum_json(sum));
    }
    if (good) return block_json(d, bound.to_string(), root_list, {}, inner, images);
  }
  return std::nullopt;
}

// For a family of zero matrices: any bound, by the unit vectors; the bound 0 needs nothing.
Json zero_block(const Family& block, const Rational& bound) {
  const long d = block[0].rows();
  Json roots = Json::array();
  Json images = Json::array();
  std::vector<size_t> inner;
  if (bound.sign() > 0)
    for (long i = 0; i < d; ++i) {
      std::vector<std::string> unit(static_cast<size_t>(d), "0");
      unit[static_cast<size_t>(i)] = "1";
      roots.push_back(root_json({}, 1, 1, unit));
      inner.push_back(static_cast<size_t>(i));
      for (size_t s = 0; s < block.size(); ++s) images.push_back(sum_json({}));
    }
  return block_json(d, bound.to_string(), std::move(roots), {}, inner, std::move(images));
}

// JSR <= the largest column sum of absolute values: the unit vectors are mapped into their hull. Always there.
Rational column_norm(const Family& block) {
  Rational largest;
  for (const auto& b : block)
    for (long j = 0; j < b.columns(); ++j) {
      Rational sum;
      for (long i = 0; i < b.rows(); ++i) sum += abs(b(i, j));
      largest = std::max(largest, sum);
    }
  return largest;
}

Json norm_block(const Family& block) {
  const Rational bound = column_norm(block);
  const long d = block[0].rows();
  Json roots = Json::array();
  Json images = Json::array();
  std::vector<size_t> inner;
  for (long j = 0; j < d; ++j) {
    std::vector<std::string> unit(static_cast<size_t>(d), "0");
    unit[static_cast<size_t>(j)] = "1";
    roots.push_back(root_json({}, 1, 1, unit));
    inner.push_back(static_cast<size_t>(j));
    for (const auto& b : block) {
      std::vector<std::pair<size_t, Rational>> sum;
      for (long i = 0; i < d; ++i)
        if (!b(i, j).is_zero()) sum.emplace_back(static_cast<size_t>(i), b(i, j) / bound);
      images.push_back(sum_json(sum));
    }
  }
  return block_json(d, bound.to_string(), std::move(roots), {}, inner, std::move(images));
}

// ---- JSR(block) = rho exactly

struct ExactCycle {
  Word word;
  RealAlgebraic radius;  // rho(B_w)^{1/|w|}
  int sign;              // of the leading eigenvalue
  RationalMatrix kernel_vector;
  Polynomial factor;  // the minimal polynomial of the eigenvalue
};

// (p(x)/(x - lambda))(P) w for w in the kernel of p(P): an eigenvector, entries in Q[lambda].
FieldVector eigenvector(const RationalMatrix& p, const Polynomial& factor, const RationalMatrix& w,
                        const NumberField& field, unsigned length, int sign) {
  const fmpz_poly_struct* view = factor.univariate_view();
  const long degree = fmpz_poly_degree(view);
  const auto n = static_cast<size_t>(p.rows());
  std::vector<std::vector<Rational>> powers;  // P^i w
  std::vector<Rational> x;
  for (long i = 0; i < p.rows(); ++i) x.push_back(w(i, 0));
  for (long i = 0; i < degree; ++i) {
    powers.push_back(x);
    x = p * x;
  }
  FieldVector v(n);
  FieldElement one;
  fmpq_poly_one(one.raw());
  FieldElement lambda_power = one;  // lambda^j, lambda = sign x^length
  for (long j = 0; j < degree; ++j) {
    std::vector<Rational> u(n);
    for (long i = j + 1; i <= degree; ++i) {
      const Rational c(fmpz_poly_get_coeff_ptr(view, i));
      for (size_t r = 0; r < n; ++r) u[r] += c * powers[static_cast<size_t>(i - j - 1)][r];
    }
    for (size_t r = 0; r < n; ++r)
      if (!u[r].is_zero()) v[r].add_multiple(u[r], lambda_power);
    lambda_power = field.times_power(lambda_power, length, sign);
  }
  return v;
}

// Without denominators and without a common integer factor.
void make_primitive(FieldVector& v) {
  Rational content;
  for (const auto& c : v)
    for (slong i = 0; i <= fmpq_poly_degree(c.raw()); ++i) {
      Rational r;
      fmpq_poly_get_coeff_fmpq(r.raw(), c.raw(), i);
      content = gcd(content, r);
    }
  if (content.is_zero()) return;
  for (auto& c : v) fmpq_poly_scalar_div_fmpq(c.raw(), c.raw(), content.raw());
}

std::string integer_text(const FieldElement& a) {
  std::vector<Rational> coefficients;
  for (slong i = 0; i <= fmpq_poly_degree(a.raw()); ++i) {
    Rational r;
    fmpq_poly_get_coeff_fmpq(r.raw(), a.raw(), i);
    coefficients.push_back(r);
  }
  return Polynomial::univariate("x", coefficients).to_string();
}

// The vertices of a polytope, exact up to the powers of the radius: x = u / rho^depth.
struct ExactVertices {
  std::vector<FieldVector> u;
  std::vector<unsigned> depth;
};

struct ExactOutcome {
  std::optional<Json> block;
  std::optional<Word> better;
  PolytopeShape shape;
  long cancelled = 0;   // bits that the evaluation of the vectors loses: the checker needs as many more
  bool closed = false;  // the orbit ended; short unit vectors may still be needed to span
};

PolytopeShape shape_of(const std::vector<ExactCycle>& cycles, const Polytope& p, const std::vector<size_t>& inner) {
  PolytopeShape shape;
  for (const auto& c : cycles) {
    shape.words.push_back(c.word);
    shape.signs.push_back(c.sign);
  }
  shape.tree = p.tree;
  shape.inner = inner;
  for (const auto& image : p.images) {
    shape.images.push_back({image.vertex, image.matrix, image.equals, {}});
    for (const auto& [j, c] : image.coefficients) shape.images.back().support.push_back(j);
  }
  return shape;
}

ExactOutcome prove_block_exact(const Family& block, const std::vector<ExactCycle>& cycles, const RealAlgebraic& rho,
                               const JsrOptions& options, const Deadline& deadline) {
  const long d = block[0].rows();
  const NumberField field(rho);
  const bool rational = rho.rational().has_value();
  const std::vector<Real> normalised = normalised_by(block, rho.estimate());

  ExactVertices exact;
  std::vector<RealVector> leading;
  std::vector<RealVector> dual;
  std::vector<FieldVector> primitive;
  long size_bits = 0;  // of the integers in the eigenvectors
  for (const auto& c : cycles) {
    FieldVector v = eigenvector(product(block, c.word), c.factor, c.kernel_vector, field,
                                static_cast<unsigned>(c.word.size()), c.sign);
    make_primitive(v);
    for (const auto& e : v)
      size_bits = std::max(size_bits, std::abs(_fmpz_vec_max_bits(e.raw()->coeffs, e.raw()->length)));
    primitive.push_back(std::move(v));
  }
  // Evaluation at rho cancels as many bits as the integers (times powers of rho) are larger than the value.
  std::vector<slong> exponents;
  long cancelled = 0;
  {
    const long first = working_bits + size_bits;
    const Ball at = rho.enclose(first);
    const auto powers_of_rho =
        static_cast<long>(static_cast<double>(rho.degree()) * std::log2(std::max(1.0, rho.estimate()))) + 1;
    for (const auto& v : primitive) {
      slong exponent = -ARF_PREC_EXACT;
      for (const auto& e : v)
        exponent = std::max(exponent, arf_abs_bound_lt_2exp_si(arb_midref(field.enclose(e, at, first).raw())));
      if (std::abs(exponent) > 100000) return {};
      exponents.push_back(exponent);
      if (!rational) cancelled = std::max(cancelled, size_bits + powers_of_rho - exponent);
    }
  }
  const long bits = working_bits + cancelled;
  const Ball radius = rho.enclose(bits);
  const auto estimate_vector = [&](const FieldVector& v) {
    RealVector x(d);
    for (long i = 0; i < d; ++i) x(i) = midpoint(field.enclose(v[static_cast<size_t>(i)], radius, bits));
    return x;
  };
  std::vector<Rational> powers;  // of two, that bring the vectors to the order of 1
  for (size_t i = 0; i < cycles.size(); ++i) {
    const auto& c = cycles[i];
    powers.push_back(Rational(2).pow(-exponents[i]));
    FieldVector v = primitive[i];
    for (auto& e : v) fmpq_poly_scalar_mul_fmpq(e.raw(), e.raw(), powers.back().raw());
    leading.push_back(estimate_vector(v));
    Real b = Real::Identity(d, d);
    for (const int s : c.word) b = normalised[static_cast<size_t>(s)] * b;
    dual.push_back(estimate_leading_vectors(b.transpose()).front());
    const double paired = dual.back().dot(unit_length(leading.back()));
    dual.back() = std::abs(paired) > 1e-12 ? RealVector(dual.back() / paired) : RealVector(RealVector::Zero(d));
    if (!leading.back().allFinite() || !dual.back().allFinite()) return {};
  }
  std::vector<double> factors(leading.size(), 1.0);
  if (leading.size() > 1) {
    std::vector<RealVector> unit;
    for (const auto& v : leading) unit.push_back(unit_length(v));
    factors = estimate_balance(normalised, unit, dual, 10);
    if (factors.empty()) factors.assign(leading.size(), 1.0);
    // Equal factors where that is possible: mirror images stay mirror images.
    const double top = *std::max_element(factors.begin(), factors.end());
    for (auto& f : factors) f /= top;
  }
  std::vector<Rational> scales;
  std::vector<RealVector> roots;
  for (size_t i = 0; i < leading.size(); ++i) {
    const Rational scale = powers[i] * dyadic(factors[i] / leading[i].cwiseAbs().maxCoeff(), 20);
    FieldVector u = primitive[i];
    for (auto& c : u) fmpq_poly_scalar_mul_fmpq(c.raw(), c.raw(), scale.raw());
    scales.push_back(scale);
    roots.push_back(estimate_vector(u));
    exact.u.push_back(std::move(u));
    exact.depth.push_back(0);
  }

  for (long i = 0; i < d && options.extra.sign() > 0; ++i) {
    FieldVector u(static_cast<size_t>(d));
    fmpq_poly_set_fmpq(u[static_cast<size_t>(i)].raw(), options.extra.raw());
    roots.push_back(estimate_vector(u));
    exact.u.push_back(std::move(u));
    exact.depth.push_back(0);
  }

  const Polytope p = estimate_polytope(normalised, roots, 0, rational, options.vertices, deadline);
  if (p.better) return {std::nullopt, p.better, {}, 0, false};
  if (!p.closed) {
    report(options, "the polytope did not close with " + std::to_string(p.vertices.size()) + " vertices");
    return {};
  }
  const ExactOutcome closed_only{std::nullopt, std::nullopt, {}, 0, true};
  const std::vector<size_t> inner = estimate_spanning(p.vertices, d);
  if (inner.empty()) {
    report(options, "the polytope is not full-dimensional");
    return closed_only;
  }

  for (const auto& [parent, matrix] : p.tree) {
    exact.u.push_back(block[matrix] * exact.u[parent]);
    exact.depth.push_back(exact.depth[parent] + 1);
  }
  const auto equal = [&](const FieldVector& y, unsigned depth, size_t j, int sign) {
    for (size_t i = 0; i < y.size(); ++i)
      if (!(field.times_power(exact.u[j][i], depth, sign) == field.times_power(y[i], exact.depth[j]))) return false;
    return true;
  };

  Json images = Json::array();
  PolytopeShape shape = shape_of(cycles, p, inner);
  if (rational) {
    std::vector<std::vector<Rational>> x;
    const Rational inverse_radius = rho.rational()->inverse();
    for (size_t j = 0; j < exact.u.size(); ++j) {
      std::vector<Rational> v;
      for (const auto& c : exact.u[j]) {
        Rational r;
        fmpq_poly_get_coeff_fmpq(r.raw(), c.raw(), 0);
        v.push_back(r * inverse_radius.pow(exact.depth[j]));
      }
      x.push_back(std::move(v));
    }
    shape.roots.assign(x.begin(), x.begin() + static_cast<long>(p.roots));
    std::vector<std::vector<Rational>> columns;
    for (const size_t i : inner) columns.push_back(x[i]);
    const auto inverse = RationalMatrix::from_columns(d, columns).inverse();
    if (!inverse) return closed_only;
    for (const auto& image : p.images) {
      if (image.equals) {
        if (!equal(block[image.matrix] * exact.u[image.vertex], exact.depth[image.vertex] + 1, image.equals->first,
                   image.equals->second)) {
          report(options, "an image is near a vertex and not equal to it");
          return closed_only;
        }
        images.push_back(Json::object({{"equals", image.equals->first}, {"sign", image.equals->second}}));
        continue;
      }
      std::vector<Rational> y = block[image.matrix] * x[image.vertex];
      for (auto& c : y) c *= inverse_radius;
      auto sum = rounded(image.coefficients);
      if (!inside(x, *inverse, y, sum)) {
        const auto on_face = exact_coordinates(x, y, image.coefficients);
        if (!on_face || !inside(x, *inverse, y, *on_face)) {
          report(options, "an inclusion could not be certified");
          return closed_only;
        }
        sum = *on_face;
      }
      images.push_back(sum_json(sum));
    }
  } else {
    std::vector<std::vector<Ball>> x;
    Ball inverse_radius;
    arb_inv(inverse_radius.raw(), radius.raw(), bits);
    const auto enclose = [&](const FieldVector& u, unsigned depth) {
      Ball factor;
      arb_pow_ui(factor.raw(), inverse_radius.raw(), depth, bits);
      std::vector<Ball> v;
      for (const auto& c : u) {
        v.push_back(field.enclose(c, radius, bits));
        arb_mul(v.back().raw(), v.back().raw(), factor.raw(), bits);
      }
      return v;
    };
    for (size_t j = 0; j < exact.u.size(); ++j) x.push_back(enclose(exact.u[j], exact.depth[j]));
    arb_mat_t inverse;
    arb_mat_init(inverse, d, d);
    for (long i = 0; i < d; ++i)
      for (long j = 0; j < d; ++j)
        arb_set(arb_mat_entry(inverse, i, j), x[inner[static_cast<size_t>(j)]][static_cast<size_t>(i)].raw());
    bool good = arb_mat_inv(inverse, inverse, bits) != 0;
    for (const auto& image : p.images) {
      if (!good) break;
      const FieldVector u = block[image.matrix] * exact.u[image.vertex];
      const unsigned depth = exact.depth[image.vertex] + 1;
      if (image.equals) {
        good = equal(u, depth, image.equals->first, image.equals->second);
        images.push_back(Json::object({{"equals", image.equals->first}, {"sign", image.equals->second}}));
        continue;
      }
      std::vector<Ball> e = enclose(u, depth);
      const auto sum = rounded(image.coefficients);
      Ball total;
      for (const auto& [j, c] : sum) {
        const Ball cb(c, bits);
        for (size_t i = 0; i < e.size(); ++i) arb_submul(e[i].raw(), cb.raw(), x[j][i].raw(), bits);
        const Ball size(abs(c), bits);
        arb_add(total.raw(), total.raw(), size.raw(), bits);
      }
      for (long i = 0; i < d; ++i) {
        Ball r;
        for (long j = 0; j < d; ++j)
          arb_addmul(r.raw(), arb_mat_entry(inverse, i, j), e[static_cast<size_t>(j)].raw(), bits);
        arb_abs(r.raw(), r.raw());
        arb_add(total.raw(), total.raw(), r.raw(), bits);
      }
      Ball slack(Rational(1), bits);
      arb_sub(slack.raw(), slack.raw(), total.raw(), bits);
      good = slack.is_positive();
      images.push_back(sum_json(sum));
    }
    arb_mat_clear(inverse);
    if (!good) {
      report(options, "an inclusion could not be certified");
      return closed_only;
    }
  }
  Json root_list = Json::array();
  for (size_t i = 0; i < cycles.size(); ++i) {
    std::vector<std::string> entries;
    for (const auto& c : primitive[i]) entries.push_back(integer_text(c));
    const int sign = cycles[i].sign;
    root_list.push_back(root_json(cycles[i].word, sign, scales[i], entries));
  }
  for (size_t i = cycles.size(); i < p.roots; ++i) {
    std::vector<std::string> unit(static_cast<size_t>(d), "0");
    unit[i - cycles.size()] = "1";
    root_list.push_back(root_json({}, 1, options.extra, unit));
    shape.words.emplace_back();
    shape.signs.push_back(1);
  }
  return {block_json(d, "", root_list, p.tree, inner, images), std::nullopt, std::move(shape), cancelled, true};
}

// The real leading eigenvalues of the product with independent eigenvectors; empty if a complex pair leads.
std::vector<ExactCycle> exact_cycles(const Family& block, const Word& word) {
  const RationalMatrix p = product(block, word);
  std::vector<ExactCycle> list;
  for (const auto& lambda : leading_eigenvalues(p)) {
    if (lambda.sign() == 0 || lambda.degree() * static_cast<long>(word.size()) > largest_degree) continue;
    const RationalMatrix kernel = evaluate(lambda.polynomial(), p).kernel();
    const RealAlgebraic radius = lambda.root_of_modulus(static_cast<unsigned>(word.size()));
    // Columns whose cyclic spaces are independent of those taken before.
    std::vector<std::vector<Rational>> taken;
    for (long k = 0; k < kernel.columns(); ++k) {
      std::vector<Rational> x;
      for (long i = 0; i < kernel.rows(); ++i) x.push_back(kernel(i, k));
      std::vector<std::vector<Rational>> with = taken;
      for (long i = 0; i < lambda.degree(); ++i) {
        with.push_back(x);
        x = p * x;
      }
      if (RationalMatrix::from_columns(kernel.rows(), with).rank() < static_cast<long>(with.size())) continue;
      taken = std::move(with);
      list.push_back({word, radius, lambda.sign(), kernel.block(0, k, kernel.rows(), 1), lambda.polynomial()});
    }
  }
  return list;
}

// ---- Putting blocks together

Json head(const char* claim, const JsrSubject& subject) {
  Json j;
  j["claim"] = claim;
  j["verdict"] = "proved";
  j["order"] = subject.order;
  j["parameter"] = rationals_json(subject.parameter);
  return j;
}

Json basis_json(const BlockForm& form) {
  Json rows = Json::array();
  if (form.sizes.size() == 1) return rows;
  for (long i = 0; i < form.basis.rows(); ++i) {
    Json row = Json::array();
    for (long j = 0; j < form.basis.columns(); ++j) row.push_back(form.basis(i, j).to_string());
    rows.push_back(row);
  }
  return rows;
}

Json radius_json(const RealAlgebraic& rho, long cancelled) {
  RealAlgebraic fine = rho;
  fine.refine(Rational(1, 1L << 40));
  Json j;
  j["polynomial"] = fine.polynomial().to_string();
  j["interval"] = rationals_json({fine.lower(), fine.upper()});
  j["bits"] = fine.degree() == 1 ? 0 : std::min(4096L, 160 + cancelled);
  return j;
}

struct Searched {
  std::vector<CycleSearch> cycles;  // one a block
  size_t top = 0;                   // the block with the largest estimate
  double radius = 0;
};

Searched estimate_blocks(const BlockForm& form) {
  Searched found;
  for (size_t b = 0; b < form.blocks.size(); ++b) {
    std::vector<Real> family;
    for (const auto& m : form.blocks[b]) family.push_back(estimate_matrix(m));
    const double size =
        std::max(1e-300, std::accumulate(family.begin(), family.end(), 0.0,
                                         [](double s, const Real& m) { return std::max(s, m.norm()); }));
    for (auto& m : family) m /= size;
    CycleSearch c = estimate_cycles(family, form.sizes[b] == 1 ? 1 : 12, 400);
    c.radius *= size;
    if (c.radius > found.radius) {
      found.radius = c.radius;
      found.top = b;
    }
    found.cycles.push_back(std::move(c));
  }
  return found;
}

// The product that was found to lead becomes the candidate.
void adopt(const Family& block, const Word& word, CycleSearch& cycles, const JsrOptions& options) {
  report(options, "a longer product leads: length " + std::to_string(word.size()));
  const std::vector<Real> family = normalised_by(block, 1);
  Real p = Real::Identity(block[0].rows(), block[0].rows());
  for (const int s : word) p = family[static_cast<size_t>(s)] * p;
  cycles.words = {word};
  cycles.radius = std::pow(estimate_spectral_radius(p), 1.0 / static_cast<double>(word.size()));
}

std::optional<JsrResult> prove_exact(const BlockForm& form, Searched& found, const JsrSubject& subject,
                                     const JsrOptions& options, const Deadline& deadline) {
  JsrResult result;
  std::optional<RealAlgebraic> rho;
  std::vector<Json> blocks(form.blocks.size());
  std::vector<size_t> order{found.top};
  for (size_t b = 0; b < form.blocks.size(); ++b)
    if (b != found.top) order.push_back(b);
  size_t attained = 0;
  long cancelled = 0;
  for (const size_t b : order) {
    const Family& block = form.blocks[b];
    const auto d = form.sizes[b];
    if (all_zero(block)) {
      blocks[b] = zero_block(block, outward(found.radius / 2, 1));
      continue;
    }
    CycleSearch& cycles = found.cycles[b];
    if (rho && cycles.radius < found.radius * (1 - 1e-9)) {
      // Strictly below: a rational bound between.
      const Rational bound = outward((cycles.radius + 3 * found.radius) / 4, 1);
      const double inflation = std::min(0.01, (fmpq_get_d(bound.raw()) / std::max(cycles.radius, 1e-9) - 1) / 8);
      auto proved = prove_block_upper(block, bound, cycles, inflation, options, deadline);
      if (!proved) return std::nullopt;
      blocks[b] = *proved;
      continue;
    }
    bool done = false;
    for (int round = 0; round < 64 && !done && !deadline.passed(); ++round) {
      std::vector<ExactCycle> exact;
      for (const auto& word : cycles.words) {
        if (exact.size() >= most_cycles || deadline.passed()) break;
        for (auto& c : exact_cycles(block, word)) {
          const int order_of = exact.empty() ? 0 : RealAlgebraic::compare(c.radius, exact.front().radius);
          if (order_of > 0) exact.clear();
          if (order_of >= 0) exact.push_back(std::move(c));
        }
      }
      if (exact.empty()) {
        report(options, "no product with a real leading eigenvalue");
        return std::nullopt;
      }
      if (rho && !(exact.front().radius == *rho)) return std::nullopt;
      // Where the leading vectors and their images do not span, or not well, short unit vectors help.
      std::vector<Rational> extras{options.extra};
      if (options.extra.is_zero()) extras.insert(extras.end(), {Rational(1, 4), Rational(1, 64)});
      ExactOutcome outcome;
      for (const auto& extra : extras) {
        JsrOptions with = options;
        with.extra = extra;
        outcome = prove_block_exact(block, exact, exact.front().radius, with, Deadline(0.4 * deadline.left()));
        if (outcome.block || outcome.better || !outcome.closed) break;
      }
      if (outcome.block) {
        rho = exact.front().radius;
        for (const auto& c : exact)
          if (std::find(result.cycles.begin(), result.cycles.end(), c.word) == result.cycles.end())
            result.cycles.push_back(c.word);
        blocks[b] = *outcome.block;
        cancelled = std::max(cancelled, outcome.cancelled);
        if (form.blocks.size() == 1) result.shape = std::move(outcome.shape);
        done = true;
        ++attained;
      } else if (outcome.better) {
        if (rho) return std::nullopt;
        adopt(block, *outcome.better, cycles, options);
        // Further ones are looked for without exact arithmetic, which is slow for long words.
        for (int step = 0; step < 256 && !deadline.passed(); ++step) {
          const std::vector<Real> normalised = normalised_by(block, cycles.radius);
          Real p = Real::Identity(d, d);
          for (const int s : cycles.words[0]) p = normalised[static_cast<size_t>(s)] * p;
          const Polytope next = estimate_polytope(normalised, {estimate_leading_vectors(p).front()}, 0, false,
                                                  options.vertices, Deadline(0.1 * deadline.left()));
          if (!next.better) break;
          adopt(block, *next.better, cycles, options);
        }
        found.radius = std::max(found.radius, cycles.radius);
      } else {
        return std::nullopt;
      }
    }
    if (!done) return std::nullopt;
  }
  if (!rho) return std::nullopt;
  rho->refine(Rational(1, 1L << 40));
  for (const auto& b : blocks)
    if (!b["bound"].get<std::string>().empty() && Rational::parse(b["bound"].get<std::string>()) >= rho->lower())
      return std::nullopt;
  result.lower = rho->lower();
  result.upper = rho->upper();
  result.exact = rho;
  result.bounded = attained == 1;
  result.method = "invariant polytope";
  Json claim = head("jsr-exact", subject);
  claim["radius"] = radius_json(*rho, cancelled);
  claim["basis"] = basis_json(form);
  claim["blocks"] = blocks;
  claim["theorem"] = "invariant-polytope";
  result.claims.push_back(std::move(claim));
  return result;
}

std::optional<Json> prove_upper(const BlockForm& form, const Searched& found, const Rational& bound,
                                const JsrSubject& subject, const JsrOptions& options, const Deadline& deadline) {
  std::vector<Json> blocks;
  for (size_t b = 0; b < form.blocks.size(); ++b) {
    if (all_zero(form.blocks[b])) {
      blocks.push_back(zero_block(form.blocks[b], bound));
      continue;
    }
    const double slack = fmpq_get_d(bound.raw()) / std::max(found.cycles[b].radius, 1e-300) - 1;
    if (slack <= 0) return std::nullopt;
    auto block =
        prove_block_upper(form.blocks[b], bound, found.cycles[b], std::min(0.05, slack / 8), options, deadline);
    if (!block) return std::nullopt;
    blocks.push_back(std::move(*block));
  }
  Json claim = head("jsr-upper", subject);
  claim["bound"] = bound.to_string();
  claim["basis"] = basis_json(form);
  claim["blocks"] = blocks;
  claim["theorem"] = "invariant-polytope";
  return claim;
}

// A proved rational lower bound of rho(B_w)^{1/|w|}, as near as balls tell.
Rational spectral_lower_bound(const RationalMatrix& p, size_t length) {
  const Polynomial chi = p.characteristic_polynomial();
  Ball best;
  for (const auto& [factor, exponent] : chi.factor().factors) {
    const fmpz_poly_struct* view = factor.univariate_view();
    const long degree = fmpz_poly_degree(view);
    acb_ptr roots = _acb_vec_init(degree);
    arb_fmpz_poly_complex_roots(roots, view, 0, 128);
    for (long i = 0; i < degree; ++i) {
      Ball modulus;
      acb_abs(modulus.raw(), roots + i, 128);
      if (arb_gt(modulus.raw(), best.raw()) != 0) best = modulus;
    }
    _acb_vec_clear(roots, degree);
  }
  if (!best.is_positive()) return 0;
  arb_root_ui(best.raw(), best.raw(), length, 128);
  Rational low = ball_lower(best);
  // A short number just below.
  const double rough = fmpq_get_d(low.raw());
  return std::min(low, outward(rough, -1));
}

JsrResult enclosed(const Family& family, const BlockForm& form, const Searched& found, const JsrSubject& subject,
                   const JsrOptions& options, const Deadline& deadline) {
  JsrResult result;
  result.method = "enclosure";
  if (!found.cycles[found.top].words.empty()) {
    const Word& word = found.cycles[found.top].words.front();
    result.lower = spectral_lower_bound(product(family, word), word.size());
    if (result.lower.sign() > 0) {
      result.cycles = {word};
      Json claim = head("jsr-lower", subject);
      claim["word"] = word_json(word);
      claim["bound"] = result.lower.to_string();
      claim["theorem"] = "spectral-radius";
      result.claims.push_back(std::move(claim));
    }
  }
  // From a coarse margin to the target; as many at once as there are threads. Coarser ones if none succeeds.
  struct Attempt {
    Rational bound;
    std::optional<Json> claim;
  };
  const double target = fmpq_get_d(options.width.raw());
  std::vector<double> margins;
  for (double margin = std::max(target, 0.02); margin > target; margin /= 4) margins.push_back(margin);
  margins.push_back(target);
  // The norm is the bound to improve upon.
  for (const auto& block : form.blocks) result.upper = std::max(result.upper, column_norm(block));
  Json norm = head("jsr-upper", subject);
  norm["bound"] = result.upper.to_string();
  norm["basis"] = basis_json(form);
  norm["blocks"] = Json::array();
  for (const auto& block : form.blocks)
    norm["blocks"].push_back(all_zero(block) ? zero_block(block, result.upper) : norm_block(block));
  norm["theorem"] = "invariant-polytope";
  std::optional<Json> best;
  const auto run = [&](const std::vector<double>& batch, double seconds) {
    std::vector<Attempt> done(batch.size());
    in_parallel(batch.size(), options.threads, [&](size_t i) {
      done[i].bound = outward(found.radius * (1 + batch[i]), 1);
      done[i].claim = prove_upper(form, found, done[i].bound, subject, options, Deadline(seconds));
    });
    bool all = true;
    for (auto& d : done) {
      all = all && d.claim.has_value();
      if (!d.claim || !(d.bound < result.upper)) continue;
      best = std::move(d.claim);
      result.upper = d.bound;
      report(options, "proved: radius <= " + rounded_decimal(result.upper, 8));
    }
    return all;
  };
  const auto batch_size = static_cast<size_t>(std::max(1, options.threads));
  for (size_t i = 0; i < margins.size() && !deadline.passed(); i += batch_size) {
    const auto last = std::min(margins.size(), i + batch_size);
    if (!run({margins.begin() + static_cast<long>(i), margins.begin() + static_cast<long>(last)},
             0.6 * deadline.left()))
      break;
  }
  for (double margin = 0.1; !best && margin < 100 && !deadline.passed(); margin *= 3)
    run({margin}, deadline.left() / 2);
  result.bounded = false;
  result.claims.push_back(best ? std::move(*best) : std::move(norm));
  return result;
}

}  // namespace

std::vector<RealAlgebraic> leading_eigenvalues(const RationalMatrix& a) {
  const Polynomial chi = a.characteristic_polynomial();
  std::vector<RealAlgebraic> best;  // of equal modulus
  const auto modulus = [](const RealAlgebraic& r) { return r.sign() == 0 ? r : r.root_of_modulus(1); };
  for (const auto& root : RealAlgebraic::zeros(chi)) {
    const int order = best.empty() ? 1 : RealAlgebraic::compare(modulus(root), modulus(best.front()));
    if (order > 0) best.clear();
    if (order >= 0) best.push_back(root);
  }
  if (best.empty()) return best;
  std::reverse(best.begin(), best.end());  // of l and -l the positive one first
  const double size = std::abs(best.front().estimate());
  for (const auto& [factor, exponent] : chi.factor().factors) {
    const fmpz_poly_struct* view = factor.univariate_view();
    const long degree = fmpz_poly_degree(view);
    acb_ptr roots = _acb_vec_init(degree);
    arb_fmpz_poly_complex_roots(roots, view, 0, 64);
    bool beyond = false;
    for (long i = 0; i < degree; ++i) {
      Ball value;
      acb_abs(value.raw(), roots + i, 64);
      beyond = beyond || midpoint(value) > size * (1 + 1e-12);
    }
    _acb_vec_clear(roots, degree);
    if (beyond) return {};
  }
  return best;
}

JsrResult joint_spectral_radius(const Family& family, const JsrSubject& subject, const JsrOptions& options) {
  const Deadline deadline(options.seconds);
  const BlockForm form = block_triangular_form(family);
  if (std::all_of(form.blocks.begin(), form.blocks.end(), all_zero)) {
    JsrResult zero;
    zero.exact = RealAlgebraic(Rational(0));
    zero.method = "nilpotent";
    Json claim = head("jsr-exact", subject);
    claim["radius"] = radius_json(*zero.exact, 0);
    claim["basis"] = basis_json(form);
    claim["blocks"] = Json::array();
    for (const auto& block : form.blocks) claim["blocks"].push_back(zero_block(block, 0));
    claim["theorem"] = "invariant-polytope";
    zero.claims.push_back(std::move(claim));
    return zero;
  }
  Searched found = estimate_blocks(form);
  report(options, std::to_string(form.sizes.size()) + " block(s), candidate radius " + std::to_string(found.radius));
  if (!options.enclosure_only) {
    const Deadline part(deadline.left() * 0.6);
    if (auto exact = prove_exact(form, found, subject, options, part)) return *exact;
  }
  return enclosed(family, form, found, subject, options, deadline);
}

std::optional<Json> prove_jsr_below(const Family& family, const Rational& limit, const JsrSubject& subject,
                                    const JsrOptions& options) {
  const Deadline deadline(options.seconds);
  const BlockForm form = block_triangular_form(family);
  const Searched found = estimate_blocks(form);
  const double gap = 1 - found.radius / fmpq_get_d(limit.raw());
  if (gap < 1e-6) return std::nullopt;
  // Most of the gap is used: the wider, the fewer vertices.
  const Rational bound = limit * dyadic(1 - gap / 16, 60);
  return prove_upper(form, found, bound, subject, options, deadline);
}

bool prove_bounded(const Family& family, const JsrOptions& options) {
  const Deadline deadline(options.seconds / 4);
  std::vector<Real> approximate;
  for (const auto& b : family) approximate.push_back(estimate_matrix(b));
  const CycleSearch cycles = estimate_cycles(approximate, 8, 200);
  std::vector<ExactCycle> exact;
  for (const auto& word : cycles.words)
    for (auto& c : exact_cycles(family, word))
      if (exact.size() < most_cycles && c.radius == RealAlgebraic(Rational(1))) exact.push_back(std::move(c));
  return !exact.empty() && prove_block_exact(family, exact, Rational(1), options, deadline).block.has_value();
}

}  // namespace twoscale::analysis
