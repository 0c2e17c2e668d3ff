// SPDX-License-Identifier: GPL-3.0-or-later
// The language of audit items: formulas as rational functions in named variables, written as the paper writes them.
//
//   {EXPR}                       an integer, EXPR in the counters of `cases`
//   NAME[EXPR]                   the variable NAME_k, k the value of EXPR (NAME_mk for -k)
//   [[list i=a..b: TEXT]]        TEXT for i = a..b, joined by commas; `sum` and `product` join by + and *
// and definitions, each over the ones before it:
//   name = FORMULA
//   name = symbol SCHEME                         a(z), indexed as the library does (centred)
//   name = coefficients of FORMULA               name_i: the coefficient of z^i; 0 outside the support
//   name = determinant rows a..b columns c..d [without k] : CONDITIONS -> ENTRY; ...   in r, c; first match, else 0
// On knots (local_formula.cpp): x_0 = 0, x_{e+1} - x_e = d_e, auxiliary knots x_e + lambda_e d_e; the variables d_e,
// lambda_e (d_m1 for e = -1), or what they are defined as; edges outside of `edges` have d = 1, lambda = 1/2.
//   name = knots edges=a..b                       name_m: t_m, so name_{2i} = x_i
//   name = spline order=n rho=r mu=m edges=a..b at=EXPR piece=P   name_i: v_{rho,mu,i}(EXPR), EXPR in [t_P, t_{P+1}]
//   name = spline-coefficients order=n rho=r mu=m edges=a..b      name_j: the coefficient of N_{n,j} in v_{rho,mu,0}
//   name = rule SCHEME [where NAME=VALUE,...]     name_h: the weight of p_{i+h} in the new point of the edge i, as a
//                                                 function; VALUEs choose the piece of a rule that has several
//   name = junction SCHEME row=R alpha=A left=L right=M where NAME=VALUE,...   name_j: row R of the local matrix
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "twoscale/symbolic/laurent.hpp"

namespace twoscale::reports::audit {

using Counters = std::map<std::string, long>;

// The integer that a text stands for. Throws Error(bad_input) naming a text that is none.
long integer(const std::string& text, const Counters& counters);
// Expands the three forms above.
std::string expanded(const std::string& text, const Counters& counters);

// All values of the counters of "l=2..8", "i=0..l"; the last counter runs fastest. No cases: one empty entry.
std::vector<Counters> all_cases(const std::vector<std::string>& cases);
std::string case_text(const Counters& counters);

class Formulas {
 public:
  Formulas(const std::vector<std::string>& definitions, const Counters& counters);
  RationalFunction operator()(const std::string& text) const;

 private:
  void define(const std::string& text);
  RationalFunction value(const std::string& text, const Counters& counters) const;
  RationalFunction determinant(const std::string& text) const;

  Counters counters_;
  std::map<std::string, RationalFunction> values_;
  std::vector<std::string> families_;  // names defined by `coefficients of`
};

// The definitions on knots: name and index -> value, for the text after "name = "; nothing if it is none of them.
// `value` evaluates a formula.
std::optional<std::map<long, RationalFunction>> local_definition(
    const std::string& text, const std::function<RationalFunction(const std::string&)>& value);

// sum_i a_i z^i.
RationalFunction in_z(const Laurent& a);

}  // namespace twoscale::reports::audit
