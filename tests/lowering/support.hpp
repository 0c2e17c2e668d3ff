// SPDX-License-Identifier: GPL-3.0-or-later
// Independent evaluation of masks: forward recurrences and plain term-by-term sums, nothing shared with the lowering
// room.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "twoscale/lowering/lower.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::lowering::test {

inline Rational exact_text(const std::string& text) {
  const auto mark = text.find('e');
  std::string digits = text.substr(0, mark);
  long exponent = mark == std::string::npos ? 0 : std::stol(text.substr(mark + 1));
  if (const auto point = digits.find('.'); point != std::string::npos) {
    exponent -= static_cast<long>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  return Rational::parse(digits) * Rational(10).pow(exponent);
}

inline Ball evaluate(const Polynomial& p, const std::vector<std::pair<std::string, Ball>>& at, long bits) {
  Ball sum;
  p.for_each_term([&](const Rational& c, std::span<const unsigned long> e) {
    Ball term(c, bits);
    for (size_t i = 0; i < e.size(); ++i)
      for (const auto& [name, x] : at)
        if (name == p.variables()[i])
          for (unsigned long n = 0; n < e[i]; ++n) arb_mul(term.raw(), term.raw(), x.raw(), bits);
    arb_add(sum.raw(), sum.raw(), term.raw(), bits);
  });
  return sum;
}

inline Ball evaluate(const RationalFunction& f, const std::vector<std::pair<std::string, Ball>>& at, long bits) {
  Ball r;
  arb_div(r.raw(), evaluate(f.numerator(), at, bits).raw(), evaluate(f.denominator(), at, bits).raw(), bits);
  return r;
}

// v^{[k]} from v^{[0]}: by square roots for m = 2, through acos and acosh otherwise.
inline Ball forward(const Ball& v0, unsigned k, int arity, long bits) {
  Ball v = v0;
  if (arity == 2) {
    for (unsigned j = 0; j < k; ++j) {
      arb_add_ui(v.raw(), v.raw(), 1, bits);
      arb_mul_2exp_si(v.raw(), v.raw(), -1);
      arb_sqrt(v.raw(), v.raw(), bits);
    }
    return v;
  }
  Ball one(Rational(1), bits), difference, angle;
  arb_sub(difference.raw(), v.raw(), one.raw(), bits);
  const bool hyperbolic = difference.is_positive();
  hyperbolic ? arb_acosh(angle.raw(), v.raw(), bits) : arb_acos(angle.raw(), v.raw(), bits);
  for (unsigned j = 0; j < k; ++j) arb_div_ui(angle.raw(), angle.raw(), static_cast<ulong>(arity), bits);
  hyperbolic ? arb_cosh(v.raw(), angle.raw(), bits) : arb_cos(v.raw(), angle.raw(), bits);
  return v;
}

// The message of the Error that f throws; "" if it throws none.
template <class F>
std::string refusal(F f) {
  try {
    f();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind, Error::Kind::bad_input) << e.what();
    return e.what();
  }
  return "";
}

using Named = std::vector<std::pair<std::string, std::string>>;

inline kernels::MaskTable table(const std::string& scheme, const std::optional<std::string>& v0, unsigned levels,
                                long digits, const Named& at = {}) {
  const Scheme s = make_scheme(scheme);
  return lower(s, lowering::bind(s, v0, std::nullopt, at), {levels, digits, false, true});
}

}  // namespace twoscale::lowering::test
