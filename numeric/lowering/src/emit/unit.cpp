// SPDX-License-Identifier: GPL-3.0-or-later
// A scheme as the parts of an evaluator.
#include "unit.hpp"

#include <algorithm>
#include <set>

#include "rounding.hpp"
#include "twoscale/kernels/export/table_writer.hpp"
#include "twoscale/symbolic/ball.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::lowering::emit {

namespace {

using R = RationalFunction;

// Words that some language keeps for itself, and names that the emitted functions use.
const std::set<std::string>& reserved() {
  static const std::set<std::string> words = {
      "abs",        "abstract",  "active",        "and",        "any",       "arguments",  "arity",     "array",
      "as",         "asm",       "assert",        "async",      "atan",      "attribute",  "auto",      "await",
      "baremodule", "begin",     "bool",          "boolean",    "break",     "buffer",     "byte",      "case",
      "cast",       "catch",     "centroid",      "char",       "class",     "coherent",   "common",    "complex",
      "concept",    "const",     "continue",      "debugger",   "declare",   "def",        "default",   "del",
      "delete",     "detail",    "discard",       "do",         "double",    "elif",       "else",      "elseif",
      "end",        "enum",      "eval",          "exact",      "except",    "explicit",   "export",    "exports",
      "extends",    "extern",    "external",      "False",      "false",     "filter",     "finally",   "finer",
      "fixed",      "flat",      "float",         "fma",        "for",       "friend",     "from",      "function",
      "get",        "global",    "goto",          "half",       "high",      "highp",      "I",         "i",
      "if",         "im",        "image",         "implements", "import",    "in",         "Inf",       "inline",
      "inout",      "input",     "instanceof",    "int",        "interface", "invariant",  "is",        "lambda",
      "last",       "layout",    "let",           "local",      "long",      "low",        "lowest",    "lowp",
      "macro",      "main",      "mask",          "Math",       "max",       "mediump",    "min",       "module",
      "mutable",    "namespace", "NaN",           "nan",        "never",     "new",        "next",      "noinline",
      "None",       "nonlocal",  "noperspective", "not",        "null",      "number",     "object",    "operator",
      "or",         "out",       "output",        "p",          "package",   "pair",       "partition", "pass",
      "patch",      "pi",        "precise",       "precision",  "private",   "protected",  "public",    "quote",
      "r",          "raise",     "readonly",      "Real",       "register",  "require",    "requires",  "resource",
      "restrict",   "return",    "root",          "s",          "sample",    "sampler",    "set",       "shared",
      "short",      "signed",    "size",          "sizeof",     "slope",     "smooth",     "sqrt",      "start",
      "static",     "std",       "step",          "string",     "struct",    "subroutine", "super",     "superp",
      "switch",     "symbol",    "template",      "this",       "throw",     "times",      "True",      "true",
      "try",        "type",      "typedef",       "typename",   "typeof",    "undefined",  "uniform",   "union",
      "unknown",    "unsigned",  "using",         "var",        "varying",   "vec",        "virtual",   "void",
      "volatile",   "while",     "with",          "writeonly",  "x",         "yield"};
  return words;
}

// An identifier in every language, different from the others.
std::string argument_name(const std::string& name, const std::vector<std::string>& taken) {
  std::string result;
  for (const char c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    result += plain ? c : '_';
  }
  if (result.empty() || (result[0] >= '0' && result[0] <= '9')) result = "p_" + result;
  // "t" and digits are the temporary values.
  const bool temporary =
      result.size() > 1 && result[0] == 't' && result.find_first_not_of("0123456789", 1) == std::string::npos;
  if (temporary || reserved().contains(result)) result += "_";
  while (std::find(taken.begin(), taken.end(), result) != taken.end()) result += "_";
  return result;
}

Range range_of(const Parameter& p, const Scheme& scheme) {
  const auto from = [](const std::optional<Domain>& d) {
    return d && d->low && d->low->sign() >= 0 ? Range::nonnegative : Range::any;
  };
  switch (p.scope) {
    case Parameter::Scope::constant: return from(p.domain);
    case Parameter::Scope::local:
      // Edge parameters lie in [0, 1]; intervals between knots are positive.
      if (p.rest || !scheme.kernel.empty()) return Range::nonnegative;
      return from(p.domain);
    case Parameter::Scope::level: break;
  }
  // cosh, and cos of less than pi/arity.
  if (p.frequency) return Range::nonnegative;
  // All values lie between v^{[0]} and 1.
  if (p.spelling && p.domain) {
    const Rational scale = p.spelling->scale.inverse();
    return from(p.domain->image(scale, -scale * p.spelling->offset));
  }
  return Range::any;
}

// ---- The relation of a level variable

// The distance from 1 to the next zero of `slope` on one side, or nothing: bisection by Sturm's count.
std::optional<double> branch_end(const Polynomial& slope, int side) {
  const auto free_up_to = [&](const Rational& distance) {
    const Rational at = Rational(1) + Rational(side) * distance;
    const Rational low = side > 0 ? Rational(1) : at, high = side > 0 ? at : Rational(1);
    return zeros_between(slope, low, high) == 0 && R(slope).evaluate({{"x", at}}) != Rational(0);
  };
  constexpr int most_doublings = 1024;
  Rational low, high = 1;
  int i = 0;
  for (; i < most_doublings && free_up_to(high); ++i) {
    low = high;
    high = Rational(2) * high;
  }
  if (i == most_doublings) return std::nullopt;
  for (int j = 0; j < 80; ++j) {
    const Rational middle = (low + high) / Rational(2);
    (free_up_to(middle) ? low : high) = middle;
  }
  const Rational end = Rational(1) + Rational(side) * high;
  return fmpq_get_d(end.raw());
}

Formula formula(const std::map<std::string, Range>& ranges, unsigned bits, const std::vector<R>& functions) {
  Formula f{Program(ranges, bits), {}};
  f.values = f.program.add(functions);
  return f;
}

Level make_level(const Parameter& p, const std::string& name, int arity, unsigned bits) {
  Level level;
  level.name = name;
  if (p.frequency && arity == 2) return level;
  const R relation = p.relation ? *p.relation : R(Polynomial::chebyshev("x", static_cast<unsigned>(arity)));
  if (!relation.is_polynomial()) bad_input("no evaluator can be written for this relation between levels", p.name);
  const Polynomial top = relation.numerator();
  const Polynomial slope = top.derivative("x");
  const Polynomial scale = Polynomial::constant(relation.denominator_content().numerator());
  level.relation = formula({}, bits, {R(top - scale * Polynomial::variable("v")), R(slope)});
  if (slope.degree("x") > 0) {
    level.low = branch_end(slope, -1);
    level.high = branch_end(slope, 1);
  }
  return level;
}

// v^{[1]}, correctly rounded.
double first_value(const LevelValue& level) {
  if (level.is_one()) return 1;
  constexpr long most = 1L << 14;
  for (long bits = 128; bits <= most; bits *= 2) {
    Ball v = level.offset(1, bits);
    arb_add_ui(v.raw(), v.raw(), 1, bits);
    double result = 0;
    if (rounded_double(v, result)) return result;
  }
  // Half-way between two doubles.
  return arf_get_d(arb_midref(level.offset(1, most).raw()), ARF_RND_NEAR) + 1;
}

// ---- Words

std::string bound_text(const Unit& unit, unsigned bits) {
  unsigned worst = 0;
  for (const Branch& b : unit.branches)
    for (const int v : b.mask.values) worst = std::max(worst, b.mask.program[v].error);
  if (worst == 0) return "every coefficient is exact";
  std::string text = "the relative error of every coefficient is at most " + std::to_string(worst) + "*u, u = 2^-" +
                     std::to_string(bits) + ", for exact arguments";
  if (std::any_of(unit.branches.begin(), unit.branches.end(),
                  [](const Branch& b) { return b.mask.program.has_pairs(); }))
    text +=
        "; polynomials that may cancel are evaluated in twice the precision, so that this holds until a value of "
        "theirs is 2^" +
        std::to_string(bits - 8) + " times smaller than their terms";
  return text;
}

std::string operations_text(const Unit& unit) {
  using Kind = Operation::Kind;
  const auto most = [&](std::initializer_list<Kind> kinds) {
    unsigned r = 0;
    for (const Branch& b : unit.branches) {
      unsigned n = 0;
      for (const Kind k : kinds) n += b.mask.program.count(k);
      r = std::max(r, n);
    }
    return r;
  };
  std::string text = std::to_string(most({Kind::multiply})) + " multiplications, " +
                     std::to_string(most({Kind::add, Kind::subtract})) + " additions, " +
                     std::to_string(most({Kind::divide})) + " divisions";
  if (const unsigned pairs = most({Kind::pair_step, Kind::pair_times}); pairs > 0)
    text += ", " + std::to_string(pairs) +
            " steps in twice the precision (at most 18 operations each with fma, 34 without)";
  return text + (unit.branches.size() > 1 ? "; the most of " + std::to_string(unit.branches.size()) + " formulas" : "");
}

std::string normalisation_text(const Scheme& scheme) {
  const Laurent a = symbol(scheme);
  bool constants = true;
  for (long s = 0; s < scheme.arity; ++s) constants = constants && a.subsymbol(scheme.arity, s).at_one().is_one();
  return "coefficients sum to " + a.at_one().to_string() +
         (constants ? "; every coset sums to 1 (constants are reproduced)"
                    : "; not every coset sums to 1 (constants are not reproduced)");
}

std::string described(const Parameter& p, const std::string& names) {
  std::string text = names;
  if (p.domain) text += " in " + p.domain->to_string();
  if (!p.default_value.empty()) text += ", " + p.default_value + " by default";
  if (!p.help.empty()) text += ": " + p.help;
  return text;
}

// Entries of `stencil` as the command of that name prints them.
std::vector<R> matrix_of(const Stencil& stencil, size_t block) {
  std::vector<R> list;
  for (size_t row = 0; row < block; ++row)
    for (size_t order = 0; order < block; ++order)
      for (const auto& b : stencil.blocks) list.push_back(b[row * block + order]);
  return list;
}

bool keeps_old(const Stencil& s, size_t block) {
  for (size_t i = 0; i < s.blocks.size(); ++i)
    for (size_t e = 0; e < block * block; ++e) {
      const bool one = s.lowest + static_cast<long>(i) == 0 && e / block == e % block;
      if (!(one ? s.blocks[i][e].is_one() : s.blocks[i][e].is_zero())) return false;
    }
  return s.lowest <= 0 && s.lowest + static_cast<long>(s.blocks.size()) > 0;
}

}  // namespace

bool Unit::counts(Operation::Kind kind) const {
  const auto in = [&](const std::optional<Formula>& f) { return f && f->program.count(kind) > 0; };
  return std::any_of(branches.begin(), branches.end(), [&](const Branch& b) { return in(b.mask) || in(b.where); }) ||
         std::any_of(levels.begin(), levels.end(), [&](const Level& l) { return in(l.relation); });
}

bool Unit::uses(const std::string& argument) const {
  return std::any_of(branches.begin(), branches.end(), [&](const Branch& b) {
    return b.mask.program.uses(argument) || (b.where && b.where->program.uses(argument));
  });
}

std::vector<std::string> Unit::level_names() const {
  std::vector<std::string> list;
  for (const Level& level : levels) list.push_back(level.name);
  return list;
}

std::vector<std::string> Unit::start_names() const {
  std::vector<std::string> list;
  for (const Level& level : levels)
    if (!level.first) list.push_back(level.name + "_0");
  return list;
}

Unit make_unit(const Scheme& scheme, const Binding& values, const std::string& prefix, unsigned bits) {
  Unit u;
  u.prefix = prefix;
  u.arity = scheme.arity;
  u.shift = scheme.shift;
  const size_t block = static_cast<size_t>(scheme.block);
  const bool uniform = is_uniform(scheme);
  const std::string m = std::to_string(scheme.arity);

  // Arguments: levels, constants, local parameters.
  std::map<std::string, Range> ranges;
  std::vector<std::pair<std::string, std::string>> renamed;
  std::vector<std::string> level_lines, constant_lines, local_lines;
  const auto argument = [&](const std::string& name, const Parameter& p) {
    const std::string own = argument_name(name, u.arguments);
    u.arguments.push_back(own);
    ranges[own] = range_of(p, scheme);
    if (own != name) renamed.emplace_back(name, own);
    return own;
  };
  for (const Parameter& p : scheme.parameters)
    if (p.scope == Parameter::Scope::level) {
      const std::string own = argument(p.name, p);
      u.levels.push_back(make_level(p, own, scheme.arity, bits));
      std::string line = own + " = " + meaning(p, scheme.arity) + ", " + recurrence(p, scheme.arity);
      if (const auto given = values.levels.find(p.name); given != values.levels.end()) {
        u.levels.back().first = first_value(given->second);
        line += "; start has the value" + (given->second.text().empty() ? "" : " of " + given->second.text());
      }
      level_lines.push_back(line);
    }
  for (const Parameter& p : scheme.parameters)
    if (p.scope == Parameter::Scope::constant) constant_lines.push_back(described(p, argument(p.name, p)));
  for (const Parameter& p : scheme.parameters)
    if (p.scope == Parameter::Scope::local) {
      std::string names;
      for (const long offset : p.offsets)
        names += (names.empty() ? "" : ", ") + argument(local_name(p.name, offset), p);
      std::string line = described(p, names);
      if (p.rest)
        line += ": edge parameters in [0, 1], " + p.rest->to_string() + " at rest";
      else if (!scheme.kernel.empty())
        line += ": knot intervals, positive";
      local_lines.push_back(line);
    }
  const auto rename = [&](R f) {
    for (const auto& [from, to] : renamed) f = f.substitute(from, R::variable(to));
    return f;
  };

  // Formulas.
  std::vector<std::pair<std::optional<R>, const std::vector<Stencil>*>> formulas;
  for (const Piece& piece : scheme.pieces) formulas.emplace_back(R(piece.where), &piece.phases);
  formulas.emplace_back(std::nullopt, &scheme.phases);
  if (!uniform) {
    if (scheme.arity != 2) bad_input("an evaluator of a rule with local parameters needs arity 2", scheme.id);
    for (const auto& f : formulas)
      if (!keeps_old((*f.second)[0], block))
        bad_input("an evaluator of a rule with local parameters needs a scheme that keeps its old vertices", scheme.id);
  }
  long lowest = 0, highest = -1;
  bool started = false;
  const auto widen = [&](long low, long high) {
    lowest = started ? std::min(lowest, low) : low;
    highest = started ? std::max(highest, high) : high;
    started = true;
  };
  for (const auto& [where, phases] : formulas)
    for (size_t s = uniform ? 0 : 1; s < phases->size(); ++s) {
      const Stencil& stencil = (*phases)[s];
      const long first = stencil.lowest, last = first + static_cast<long>(stencil.blocks.size()) - 1;
      if (uniform)
        widen(static_cast<long>(s) - scheme.arity * last, static_cast<long>(s) - scheme.arity * first);
      else
        widen(first, last);
    }
  u.lowest = lowest;
  const size_t width = static_cast<size_t>(highest - lowest + 1);
  u.size = width * block * block;
  for (const auto& [where, phases] : formulas) {
    std::vector<R> entries(u.size);
    if (uniform) {
      for (size_t s = 0; s < phases->size(); ++s)
        for (size_t h = 0; h < (*phases)[s].blocks.size(); ++h) {
          const long i = static_cast<long>(s) - scheme.arity * ((*phases)[s].lowest + static_cast<long>(h));
          std::copy((*phases)[s].blocks[h].begin(), (*phases)[s].blocks[h].end(),
                    entries.begin() + (i - lowest) * static_cast<long>(block * block));
        }
    } else {
      Stencil wide{lowest, std::vector<std::vector<R>>(width, std::vector<R>(block * block))};
      for (size_t h = 0; h < (*phases)[1].blocks.size(); ++h)
        wide.blocks[static_cast<size_t>((*phases)[1].lowest - lowest) + h] = (*phases)[1].blocks[h];
      entries = matrix_of(wide, block);
    }
    for (R& e : entries) e = rename(e);
    Branch b{std::nullopt, formula(ranges, bits, entries)};
    if (where) b.where = formula(ranges, bits, {rename(*where)});
    u.branches.push_back(std::move(b));
  }

  // What the header says.
  auto& h = u.header;
  h.push_back("Generated by twoscale: evaluator of the masks of a subdivision scheme.");
  h.push_back("Licence: this output is 0BSD, free for any use.");
  std::string source = scheme.source;
  const std::string section = "\u00a7";
  for (size_t at; (at = source.find(section)) != std::string::npos;) source.replace(at, section.size(), "section ");
  h.push_back("Scheme: " + scheme.id + (source.empty() ? "" : " [" + source + "]"));
  if (uniform)
    h.push_back("Rule: f^{k+1}_i = sum_j a^{[k]}_{i-" + m + "*j} f^k_j; arity " + m);
  else
    h.push_back("Rule: f^{k+1}_{2j} = f^k_j, f^{k+1}_{2j+1} = sum_h c_h f^k_{j+h}; arity 2");
  if (block > 1)
    h.push_back("Blocks: vertices are columns of " + std::to_string(block) + " (value, derivatives); " +
                (uniform ? "each a_i is a matrix, row by row"
                         : "the matrix is written row by row, its columns derivative by derivative, vertex by vertex"));
  h.push_back(uniform ? "Index origin: mask begins with a_{lowest}; support [" + std::to_string(lowest) + ", " +
                            std::to_string(highest) + "]"
                      : "Index origin: mask begins with c_{lowest}; h = " + std::to_string(lowest) + " .. " +
                            std::to_string(highest) + ", the new vertex lies between f_j and f_{j+1}");
  h.push_back(
      "p = " + scheme.shift.to_string() + ": " +
      (uniform ? "f^k_j belongs to the parameter (j + p)/" + m + "^k" : "the vertices of level k keep their places"));
  if (uniform && block == 1) h.push_back("Normalisation: " + normalisation_text(scheme));
  for (const auto& line : level_lines) h.push_back("Level variable: " + line);
  if (!u.levels.empty())
    h.push_back(
        "Levels: the step k -> k+1 takes the level variables of level k+1; start gives those of the step 0 from the "
        "ones of level 0, next those of a step from those of the step before");
  for (const auto& line : constant_lines) h.push_back("Constant: " + line);
  for (const auto& line : local_lines) h.push_back("Local: " + line);
  h.push_back("Arguments of mask: " + (u.arguments.empty() ? std::string("none") : joined(u.arguments, ", ")));
  h.push_back("Operations of mask: " + operations_text(u));
  h.push_back("Accuracy: " + bound_text(u, bits) + (u.levels.empty() ? "" : "; start and next: within one last place"));
  for (std::string& line : h) line = kernels::comment_text(line);
  return u;
}

// ---- Shared by the languages

std::pair<Rational, Rational> Dialect::split(const Rational& n) const {
  const auto rounded = [&](const Rational& x) {
    if (x.is_zero()) return x;
    Ball b(x, static_cast<long>(fmpz_bits(x.numerator())) + 2);
    Rational r;
    arf_t y;
    arf_init(y);
    arf_set_round(y, arb_midref(b.raw()), static_cast<long>(bits()), ARF_RND_NEAR);
    arf_get_fmpq(r.raw(), y);
    arf_clear(y);
    return r;
  };
  const Rational high = rounded(n);
  return {high, rounded(n - high)};
}

Dialect::Body Dialect::body(const Formula& formula) const {
  using Kind = Operation::Kind;
  constexpr size_t longest = 64;
  enum Strength { sum, product, unary, leaf };
  struct Text {
    std::string text;
    Strength strength = leaf;
  };
  std::vector<Text> texts;
  Body r;
  const auto put = [&](int value, Strength least) {
    const Text& t = texts[static_cast<size_t>(value)];
    return t.strength < least ? "(" + t.text + ")" : t.text;
  };
  const auto signed_leaf = [](std::string text) {
    const bool negative = text[0] == '-';
    return Text{std::move(text), negative ? unary : leaf};
  };
  unsigned names = 0;
  for (const Operation& o : formula.program.operations()) {
    Text t;
    switch (o.kind) {
      case Kind::variable: t.text = o.name; break;
      case Kind::number: t = signed_leaf(integer(o.number)); break;
      case Kind::add: t = {put(o.a, sum) + " + " + put(o.b, product), sum}; break;
      case Kind::subtract: t = {put(o.a, sum) + " - " + put(o.b, product), sum}; break;
      case Kind::multiply: t = {put(o.a, product) + " * " + put(o.b, unary), product}; break;
      case Kind::divide: t = {put(o.a, product) + " / " + put(o.b, unary), product}; break;
      case Kind::negate: t = {"-" + put(o.a, leaf), unary}; break;
      case Kind::pair_number: t.text = pair(o.number); break;
      case Kind::pair_times: t.text = helper("times") + "(" + put(o.a, sum) + ", " + put(o.b, sum) + ")"; break;
      case Kind::pair_step:
        t.text = helper("step") + "(" + put(o.a, sum) + ", " + put(o.b, sum) + ", " + put(o.c, sum) + ")";
        break;
      case Kind::round: t.text = rounded(put(o.a, sum)); break;
    }
    const bool atom = o.kind == Kind::variable || o.kind == Kind::number || o.kind == Kind::pair_number;
    if (!atom && o.uses > 0 && (o.uses > 1 || t.text.size() > longest)) {
      const std::string name = "t" + std::to_string(names++);
      r.statements.push_back(let(name, o.is_pair(), t.text));
      t = {name, leaf};
    }
    texts.push_back(std::move(t));
  }
  for (const int v : formula.values) r.values.push_back(put(v, sum));
  return r;
}

std::string Dialect::finer(const Level& level, const std::string& argument) const {
  return level.relation ? helper("finer_" + level.name) + "(" + argument + ")" : square_root(argument);
}

std::vector<std::string> Dialect::next_values(const Unit& unit) const {
  std::vector<std::string> list;
  for (const Level& level : unit.levels) list.push_back(finer(level, level.name));
  return list;
}

std::vector<std::string> Dialect::start_values(const Unit& unit) const {
  std::vector<std::string> list;
  for (const Level& level : unit.levels)
    list.push_back(level.first ? floating(*level.first) : finer(level, level.name + "_0"));
  return list;
}

std::string Dialect::list(const std::vector<std::string>& items, const std::string& indent) {
  constexpr size_t width = 110;
  std::string out, line = indent;
  for (size_t i = 0; i < items.size(); ++i) {
    const std::string item = items[i] + (i + 1 < items.size() ? "," : "");
    if (line.size() > indent.size() && line.size() + 1 + item.size() > width) {
      out += line + "\n";
      line = indent;
    }
    line += (line.size() > indent.size() ? " " : "") + item;
  }
  return out + line + "\n";
}

std::string Dialect::comment(const Unit& unit, const std::string& mark) {
  constexpr size_t width = 110;
  std::string out;
  for (const std::string& text : unit.header) {
    std::string line = mark;
    for (size_t at = 0; at < text.size();) {
      const size_t end = std::min(text.find(' ', at), text.size());
      if (line.size() > mark.size() + 4 && line.size() + 1 + end - at > width) {
        out += line + "\n";
        line = mark + "   ";
      }
      line += " " + text.substr(at, end - at);
      at = end + 1;
    }
    out += line + "\n";
  }
  return out;
}

std::string filled(std::string_view pattern, const std::vector<std::pair<std::string, std::string>>& values) {
  std::string out;
  for (size_t at = 0; at < pattern.size();) {
    const size_t open = pattern.find('$', at);
    if (open == std::string_view::npos) return out + std::string(pattern.substr(at));
    out += pattern.substr(at, open - at);
    const size_t close = pattern.find('$', open + 1);
    const std::string_view key = pattern.substr(open + 1, close - open - 1);
    for (const auto& [name, value] : values)
      if (name == key) out += value;
    at = close + 1;
  }
  return out;
}

std::string with_prefix(std::string_view text, const std::string& prefix) {
  std::string out;
  for (const char c : text) {
    if (c == '@')
      out += prefix;
    else
      out += c;
  }
  return out;
}

std::string lines(const std::vector<std::string>& list, const std::string& indent) {
  std::string out;
  for (const auto& line : list) out += indent + line + "\n";
  return out;
}

std::string joined(const std::vector<std::string>& items, const std::string& between) {
  std::string out;
  for (size_t i = 0; i < items.size(); ++i) out += (i > 0 ? between : "") + items[i];
  return out;
}

}  // namespace twoscale::lowering::emit
