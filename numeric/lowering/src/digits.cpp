// SPDX-License-Identifier: GPL-3.0-or-later
#include "digits.hpp"

#include <algorithm>
#include <cmath>

#include "rounding.hpp"
#include "twoscale/kernels/number_text.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::lowering {

namespace {

constexpr double most_points = 2147483648.0;  // 2^31
constexpr double most_output = 4294967296.0;  // characters or bytes of balls
constexpr long most_decimals = 20000;
constexpr int most_attempts = 6;

long significant_digits(const std::string& text) {
  long count = 0;
  for (const char c : text) {
    if (c == 'e') break;
    if (c >= '0' && c <= '9' && (c != '0' || count > 0)) ++count;
  }
  return count;
}

// Weight 10^w of the last digit.
long last_weight(const std::string& text) {
  const auto mark = text.find('e');
  const long exponent = mark == std::string::npos ? 0 : std::stol(text.substr(mark + 1));
  const auto point = text.find('.');
  if (point == std::string::npos) return exponent;
  return exponent - static_cast<long>(std::min(mark, text.size()) - point - 1);
}

}  // namespace

Real operator+(const Real& a, const Real& b) {
  Real r{{}, std::max(a.bits, b.bits)};
  arb_add(r.value.raw(), a.value.raw(), b.value.raw(), r.bits);
  return r;
}

Real operator*(const Real& a, const Real& b) {
  Real r{{}, std::max(a.bits, b.bits)};
  arb_mul(r.value.raw(), a.value.raw(), b.value.raw(), r.bits);
  return r;
}

Real coefficient(const std::string& text, long digits, long bits) {
  Real r{Ball(exact_decimal(text), bits), bits};
  if (significant_digits(text) >= digits) {
    Ball error(Rational(10).pow(last_weight(text)), 64);
    arb_mul_2exp_si(error.raw(), error.raw(), -1);
    arb_add_error(r.value.raw(), error.raw());
  }
  return r;
}

void check_output_size(double points, std::size_t dim, long digits, const std::string& what) {
  const double size = points * static_cast<double>(dim) * (static_cast<double>(digits) + 64);
  if (points > most_points || (digits > 0 && size > most_output)) bad_input("too many points would come out", what);
}

kernels::PointSet with_digits(
    const std::vector<DecimalSet>& sets, long wanted,
    const std::function<std::vector<Real>(const std::vector<std::vector<Real>>&, Precision)>& refine) {
  if (wanted < 17 || wanted > 10000) bad_input("digits must lie between 17 and 10000", std::to_string(wanted));
  // All numbers times 10^decimals are integers: dyadic masks then stay exact.
  std::vector<std::vector<Rational>> exact;
  std::vector<std::vector<Rational>> errors;  // bounds, empty where the numbers are exact
  for (const auto& [points, rounded_digits] : sets) {
    auto& numbers = exact.emplace_back();
    auto& bounds = errors.emplace_back();
    for (size_t i = 0; i < points->values.size(); ++i) {
      const std::string text = i < points->tokens.size() ? points->tokens[i] : kernels::shortest(points->values[i]);
      numbers.push_back(exact_decimal(text));
      if (rounded_digits > 0)
        bounds.push_back(significant_digits(text) < rounded_digits ? Rational(0)
                                                                   : Rational(10).pow(last_weight(text)) / Rational(2));
    }
  }
  Rational scale(1);
  for (const auto& numbers : exact)
    for (const Rational& x : numbers)
      if (!(x * scale).is_integer()) {
        long decimals = 0;
        while (!(x * scale * Rational(10).pow(decimals)).is_integer()) {
          decimals = decimals == 0 ? 1 : decimals * 2;
          if (decimals > most_decimals)
            bad_input("a number is too small for refinement with digits", x.to_string().substr(0, 40));
        }
        scale *= Rational(10).pow(decimals);
      }

  kernels::PointSet out;
  out.columns = sets.front().points->columns;
  out.dim = sets.front().points->dim;
  long guard = 12;
  for (int attempt = 1;; ++attempt, guard = std::max(3 * guard, wanted + guard)) {
    const long digits = std::min(10000L, wanted + guard);
    const long bits = static_cast<long>(std::ceil(static_cast<double>(wanted + guard) * 3.3219281)) + 32;
    std::vector<std::vector<Real>> in;
    for (size_t l = 0; l < exact.size(); ++l) {
      auto& reals = in.emplace_back();
      for (size_t i = 0; i < exact[l].size(); ++i) {
        Real r{{}, bits};
        arb_set_fmpz(r.value.raw(), (exact[l][i] * scale).numerator());
        if (!errors[l].empty()) arb_add_error(r.value.raw(), Ball(errors[l][i] * scale, 64).raw());
        reals.push_back(std::move(r));
      }
    }
    const std::vector<Real> fine = refine(in, {digits, bits});
    std::vector<const Ball*> numbers;
    for (const Real& x : fine) numbers.push_back(&x.value);
    if (round_all(numbers, scale, bits, wanted, out)) return out;
    if (attempt >= most_attempts || wanted + guard > 10000)
      throw Error(Error::Kind::undecided, "cannot decide the last digit of a refined number");
  }
}

}  // namespace twoscale::lowering
