// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Where a polynomial in the level variables can vanish on their domain.
// Level variable v = v^{[k+1]} of the step k -> k+1: v in (cos(pi/m^{k+1}), infinity), v^0 = T_{m^{k+1}}(v) > -1.
#pragma once

#include "twoscale/check/certificate.hpp"
#include "twoscale/check/univariate.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace twoscale::check {

/// v^0 = cos(angle*pi), 0 < angle < 1, at the step level -> level+1.
struct Angle {
  long level = 0;
  SmallFraction angle;
};

/// Order n of the root of unity exp(i*angle*pi/m^{level+1}); nothing if n > 10^6 (then phi(n)/2 exceeds every degree
/// that can occur within the limits).
std::optional<std::uint64_t> root_order(const Angle& angle, int arity);

Angle read_angle(Fields& fields, Meter& meter);
std::string text_of(const Angle& angle);

class Exceptions {
 public:
  Exceptions(const Value& value, const Certificate& certificate, const std::string& where, Meter& meter);

  /// Shows that p, a polynomial in the variables, has no zero on the domain apart from the listed exceptions; throws
  /// Refused(`what` ...) otherwise. Remembers which exceptions were zeros of p.
  void require_no_other_zero(const Polynomial& p, const std::string& what);
  /// Marks the exceptions that are zeros of p, and asks nothing.
  void mark_zeros(const Polynomial& p);
  /// Every exception has been a zero of one of the polynomials so far.
  void require_all_used(const std::string& of_what) const;
  /// At each exception some numerator of the mask does not vanish (angle), is not divisible by it (condition).
  void require_poles() const;

  /// `for every v^0 > -1`, `for every v^0 > -1 except v^0 = cos(2*pi/3) at level 0, ...`.
  std::string text() const;

 private:
  struct Condition {
    std::string text;
    Polynomial polynomial;
    bool used = false;  // has been a divisor
  };

  void single(Dense p, const std::string& what);
  void several(Polynomial p, const std::string& what);

  const Certificate& certificate_;
  Meter& meter_;
  std::vector<Angle> angles_;
  std::map<std::uint64_t, bool> orders_;  // order of the root of unity -> has been a zero
  std::vector<Condition> conditions_;
};

}  // namespace twoscale::check
