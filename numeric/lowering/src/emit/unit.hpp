// SPDX-License-Identifier: GPL-3.0-or-later
// What an emitted evaluator consists of, before it is spelled in a language. Not installed.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "program.hpp"
#include "twoscale/lowering/emit.hpp"

namespace twoscale::lowering::emit {

// Values computed together.
struct Formula {
  Program program;
  std::vector<int> values;
};

// v^{[k+1]} from v^{[k]}.
struct Level {
  std::string name;  // of the argument
  // Nothing: v -> sqrt((1+v)/2). Else for Newton's method, in "x" and "v": L (R(x) - v) and L R'(x), L > 0.
  std::optional<Formula> relation;
  std::optional<double> low, high;  // ends of the branch, where R' vanishes
  std::optional<double> first;      // v^{[1]}, if v^{[0]} has a value
};

// One formula of the mask, where the only value of `where` is >= 0 (the last one: always).
struct Branch {
  std::optional<Formula> where;
  Formula mask;
};

struct Unit {
  std::string prefix;
  std::vector<std::string> header;  // lines without comment marks
  int arity = 2;
  long lowest = 0;
  size_t size = 0;
  Rational shift;
  std::vector<Level> levels;
  std::vector<std::string> arguments;  // of mask: levels, constants, local parameters
  std::vector<Branch> branches;

  bool has_pairs() const { return counts(Operation::Kind::pair_step) || has_times(); }
  bool has_times() const { return counts(Operation::Kind::pair_times); }
  bool uses(const std::string& argument) const;
  std::vector<std::string> level_names() const;  // arguments of next
  std::vector<std::string> start_names() const;  // arguments of start: those without a value, as v_0

 private:
  bool counts(Operation::Kind kind) const;  // true if some formula has such an operation
};

// bits: of the significand of the language's real type.
Unit make_unit(const Scheme& scheme, const Binding& values, const std::string& prefix, unsigned bits);

// A language: how its pieces are spelled.
class Dialect {
 public:
  explicit Dialect(std::string prefix) : prefix_(std::move(prefix)) {}
  virtual ~Dialect() = default;
  virtual unsigned bits() const { return 53; }
  virtual std::string file(const Unit& unit) const = 0;

 protected:
  // An integer as a real, as a pair.
  virtual std::string integer(const Rational& n) const = 0;
  virtual std::string pair(const Rational& n) const = 0;
  virtual std::string helper(const std::string& name) const = 0;  // "step" as it is called
  virtual std::string rounded(const std::string& pair) const = 0;
  virtual std::string floating(double x) const = 0;
  virtual std::string square_root(const std::string& v) const = 0;  // of (1+v)/2
  virtual std::string let(const std::string& name, bool is_pair, const std::string& value) const = 0;

  struct Body {
    std::vector<std::string> statements;
    std::vector<std::string> values;
  };
  Body body(const Formula& formula) const;

  // What next returns, and start.
  std::vector<std::string> next_values(const Unit& unit) const;
  std::vector<std::string> start_values(const Unit& unit) const;

  // n = high + low with `bits` bits each, the first one rounded to nearest.
  std::pair<Rational, Rational> split(const Rational& n) const;
  // Lines of a list, `indent` before each, no longer than the header's.
  static std::string list(const std::vector<std::string>& items, const std::string& indent);
  static std::string comment(const Unit& unit, const std::string& mark);

  const std::string prefix_;

 private:
  std::string finer(const Level& level, const std::string& argument) const;
};

std::unique_ptr<Dialect> make_c(const std::string& prefix);
std::unique_ptr<Dialect> make_cpp(const std::string& prefix);
std::unique_ptr<Dialect> make_glsl(const std::string& prefix);
std::unique_ptr<Dialect> make_python(const std::string& prefix);
std::unique_ptr<Dialect> make_julia(const std::string& prefix);
std::unique_ptr<Dialect> make_javascript(const std::string& prefix, bool typed);

// `pattern` with every $name$ replaced by its value; unknown names by nothing.
std::string filled(std::string_view pattern, const std::vector<std::pair<std::string, std::string>>& values);
// `text` with every @ replaced by the prefix.
std::string with_prefix(std::string_view text, const std::string& prefix);
// Each line with `indent` before it and its end.
std::string lines(const std::vector<std::string>& list, const std::string& indent);
std::string joined(const std::vector<std::string>& items, const std::string& between);

}  // namespace twoscale::lowering::emit
