// SPDX-License-Identifier: GPL-3.0-or-later
// Functions of two parameters that schemes can reproduce: finite sums
//   F(u, v) = sum c u^a v^b exp(lambda u + mu v),   lambda, mu real or imaginary, c complex, F real,
// written with products of polynomials, exp, cos, sin, cosh, sinh of linear functions. As sum_l f_l(u) g_l(v) such an F
// lies in U x V when all u^a exp(lambda u) lie in U and all v^b exp(mu v) in V.
#pragma once

#include <ginac/ginac.h>

#include <complex>
#include <string>
#include <string_view>
#include <vector>

#include "twoscale/symbolic/exact_real.hpp"
#include "twoscale/symbolic/space.hpp"

namespace twoscale {

// x^degree exp(lambda x).
struct ExponentialMonomial {
  unsigned degree = 0;
  GiNaC::ex lambda = 0;
};

// theta > 0 with lambda = +-theta, or +-I theta when trigonometric; zero is not trigonometric.
struct RealFrequency {
  GiNaC::ex theta = 0;
  bool trigonometric = false;
  bool is_zero() const { return theta.is_zero(); }
  friend bool operator==(const RealFrequency& a, const RealFrequency& b) {
    return a.trigonometric == b.trigonometric && a.theta.is_equal(b.theta);
  }
};

// Throws Error(bad_input) if lambda is neither real nor imaginary (naming it).
RealFrequency real_frequency(const GiNaC::ex& lambda);

class ExponentialSum {
 public:
  struct Term {
    GiNaC::ex coefficient;
    ExponentialMonomial u, v;
  };

  ExponentialSum() = default;  // 0
  // A formula in the names u and v. Throws Error(bad_input) naming the piece that is not of this form.
  static ExponentialSum parse(std::string_view formula);
  // A part of a sum, with as many terms; the caller keeps conjugate terms together.
  explicit ExponentialSum(std::vector<Term> terms);

  // No two with the same exponents, no coefficient 0, in an order that depends on the function only.
  const std::vector<Term>& terms() const { return terms_; }
  // The value at exact numbers u, v (expressions without names).
  ExactReal at(const GiNaC::ex& u, const GiNaC::ex& v) const;
  // The value in double arithmetic.
  double estimate(double u, double v) const;

 private:
  struct Doubles {
    std::complex<double> coefficient, lambda, mu;
    unsigned u_degree, v_degree;
  };
  std::vector<Term> terms_;
  std::vector<Doubles> doubles_;  // of the terms, for estimate
};

enum class Axis { u, v };

// The parameters first + j*step, j = 0, 1, ...
struct SampleLine {
  GiNaC::ex first = 0;
  GiNaC::ex step = 1;
  // Two exact numbers, step > 0. Throws Error(bad_input).
  static SampleLine parse(std::string_view first, std::string_view step);
  GiNaC::ex at(long j) const { return first + j * step; }
  double estimate(double index) const;
};

// The least space {1, x} + ... of even dimension that holds what the sums contain along an axis, per step of `line`:
// a scheme that reproduces it returns them from their samples.
Space least_space(const std::vector<ExponentialSum>& sums, Axis axis, const SampleLine& line);

// How often the frequencies along an axis turn within `count` steps, ascending, each once. Throws Error(bad_input)
// naming a frequency that makes no whole number of turns, or a power: the direction does not close.
std::vector<long> turns(const std::vector<ExponentialSum>& sums, Axis axis, const SampleLine& line, long count);

// The least number n >= 3 of samples of a closed direction for which the interpolating scheme of {1, x} and the given
// turns exists. With theta_i = 2 pi n_i/n it exists iff no w_i + w_j = cos(pi n_i/(n 2^k)) + cos(pi n_j/(n 2^k))
// vanishes (i = j included, n_0 = 0), that is iff no n_i + n_j and n_i - n_j is a multiple of n except 0: iff the n
// samples determine the functions.
long least_closed_samples(std::vector<long> turns);

// The coordinates as a sum of parts, each with one frequency (and 0) along u and one along v: what a tensor product of
// two schemes of least dimension reproduces. part[c] is the share of coordinate c.
std::vector<std::vector<ExponentialSum>> products(const std::vector<ExponentialSum>& coordinates);

// An exact number as the expressions of the contract spell it ("3*pi/8").
std::string number_expression(const GiNaC::ex& number);

}  // namespace twoscale
