// SPDX-License-Identifier: GPL-3.0-or-later
// Refinement with proved digits: numbers read exactly from their texts, enclosed in balls, rounded at the end; more
// precision until every digit is decided. Not installed.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "twoscale/kernels/points_io.hpp"
#include "twoscale/symbolic/ball.hpp"

namespace twoscale::lowering {

// A ball that carries its working precision.
struct Real {
  Ball value;
  long bits = 64;
};
Real operator+(const Real& a, const Real& b);
Real operator*(const Real& a, const Real& b);

// A table text as a ball, when tables are lowered with `digits`: texts with all their digits are rounded, shorter ones
// exact.
Real coefficient(const std::string& text, long digits, long bits);

// What is refined at one precision: tables with `digits` digits, arithmetic with `bits`.
struct Precision {
  long digits;
  long bits;
};

// Numbers of a set as written: exact, or, when `rounded` > 0, correctly rounded where they have that many significant
// digits.
struct DecimalSet {
  const kernels::PointSet* points;
  long rounded = 0;
};

// `refine` gets the numbers of the sets (scaled by one power of ten, so it must be linear in all of them together) and
// returns numbers, which become `values` and `tokens` of the result, with `digits` correct significant digits each. A
// number that cannot be told from 0 with twice the digits (smaller than 10^(-2 digits) times the largest one) becomes
// 0. Columns are those of the first set. Throws Error(bad_input) for digits outside 17..10000 and for numbers beyond
// the doubles, Error(undecided) if a digit could not be decided.
kernels::PointSet with_digits(
    const std::vector<DecimalSet>& sets, long digits,
    const std::function<std::vector<Real>(const std::vector<std::vector<Real>>&, Precision)>& refine);

// Throws Error(bad_input) if points of `dim` numbers with that many digits are too many to come out.
void check_output_size(double points, std::size_t dim, long digits, const std::string& what);

}  // namespace twoscale::lowering
