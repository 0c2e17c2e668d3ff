// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluators in Python, Julia, JavaScript and TypeScript.
#include "twoscale/kernels/number_text.hpp"
#include "unit.hpp"

namespace twoscale::lowering::emit {

namespace {

// An integer that a literal keeps only as a floating one.
bool is_long(const Rational& n, unsigned bits) { return fmpz_bits(n.numerator()) > bits; }

// ---- Python

constexpr std::string_view python_pairs = R"(

# Numbers of twice the precision, (hi, lo); a*b - p, p = a*b rounded, by Dekker's splitting.
def _@_product_error(a, b, p):
    s = 134217729 * a
    t = 134217729 * b
    a1 = s - (s - a)
    b1 = t - (t - b)
    a2 = a - a1
    b2 = b - b1
    return ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2

# s*x + c
def _@_step(s, x, c):
    p = s[0] * x
    e = _@_product_error(s[0], x, p) + s[1] * x
    t = p + c[0]
    z = t - p
    low = ((p - (t - z)) + (c[0] - z)) + (c[1] + e)
    hi = t + low
    w = hi - t
    return hi, (t - (hi - w)) + (low - w)
)";

constexpr std::string_view python_times = R"(

def _@_times(s, x):
    p = s[0] * x
    e = _@_product_error(s[0], x, p) + s[1] * x
    hi = p + e
    return hi, e - (hi - p)
)";

constexpr std::string_view python_newton = R"(

# $name$^{k+1} from $name$^k: the solution x of R(x) = v on the branch through 1.
def $function$(v):
    low = min(v, 1)
    high = max(v, 1)
    x = last = 1.0
$ends$    for _ in range(100):
$statements$        r = $residual$
        slope = $slope$
        if r == 0:
            break
        if r > 0:
            high = x
        else:
            low = x
        y = x - r / slope if slope != 0 else low - 1
        if not low <= y <= high:
            y = low + (high - low) / 2
        if y in (x, last):
            break
        last = x
        x = y
    return x
)";

class Python final : public Dialect {
 public:
  using Dialect::Dialect;

  std::string file(const Unit& u) const override {
    std::string out = comment(u, "#");
    out += "# Arguments are floats; NumPy arrays of one shape and numbers of mpmath do as well" +
           std::string(u.branches.size() > 1 ? ", arrays excepted here" : "") +
           ". The accuracy is\n# stated for floats.\n\n";
    out += u.prefix + "_arity = " + std::to_string(u.arity) + "\n";
    out += u.prefix + "_lowest = " + std::to_string(u.lowest) + "\n";
    out += u.prefix + "_size = " + std::to_string(u.size) + "\n";
    out += u.prefix + "_p = " + (u.shift.is_integer() ? u.shift.to_string() + ".0" : u.shift.to_string()) + "\n";
    if (u.has_pairs()) out += with_prefix(python_pairs, u.prefix);
    if (u.has_times()) out += with_prefix(python_times, u.prefix);
    for (const Level& level : u.levels) {
      if (!level.relation) continue;
      const Body b = body(*level.relation);
      std::string ends;
      if (level.low) ends += "    low = max(low, " + kernels::shortest(*level.low) + ")\n";
      if (level.high) ends += "    high = min(high, " + kernels::shortest(*level.high) + ")\n";
      out += filled(python_newton, {{"name", level.name},
                                    {"function", helper("finer_" + level.name)},
                                    {"ends", ends},
                                    {"statements", lines(b.statements, "        ")},
                                    {"residual", b.values[0]},
                                    {"slope", b.values[1]}});
    }
    out += "\n\ndef " + u.prefix + "_next(" + joined(u.level_names(), ", ") +
           "):\n    \"\"\"Level variables of the step after the one that has these.\"\"\"\n    return [" +
           joined(next_values(u), ", ") + "]\n";
    out += "\n\ndef " + u.prefix + "_start(" + joined(u.start_names(), ", ") +
           "):\n    \"\"\"Level variables of the step 0.\"\"\"\n    return [" + joined(start_values(u), ", ") + "]\n";
    out += "\n\ndef " + u.prefix + "_mask(" + joined(u.arguments, ", ") +
           "):\n    \"\"\"The coefficients of one step, lowest first.\"\"\"\n";
    for (const Branch& branch : u.branches) {
      std::string indent = "    ";
      if (branch.where) {
        out += "    if " + body(*branch.where).values[0] + " >= 0:\n";
        indent += indent;
      }
      const Body b = body(branch.mask);
      out += lines(b.statements, indent) + indent + "return [\n" + list(b.values, indent + "    ") + indent + "]\n";
    }
    return out;
  }

 protected:
  std::string integer(const Rational& n) const override { return n.to_string() + (is_long(n, 53) ? ".0" : ""); }
  // A product of small integers is exact; a long one must be a float for Dekker's splitting.
  std::string pair(const Rational& n) const override {
    const auto [high, low] = split(n);
    return "(" + high.to_string() + (is_long(n, 26) ? ".0" : "") + ", " + low.to_string() +
           (is_long(n, 26) ? ".0" : "") + ")";
  }
  std::string floating(double x) const override { return kernels::shortest(x); }
  std::string square_root(const std::string& v) const override { return "((1 + " + v + ") / 2) ** 0.5"; }
  std::string helper(const std::string& name) const override { return "_" + prefix_ + "_" + name; }
  std::string rounded(const std::string& pair) const override { return pair + "[0]"; }
  std::string let(const std::string& name, bool, const std::string& value) const override {
    return name + " = " + value;
  }
};

// ---- Julia

constexpr std::string_view julia_pairs = R"(
# Numbers of twice the precision, (hi, lo); fma rounds once.
# s*x + c
function @_step(s, x, c)
    p = s[1] * x
    e = fma(s[1], x, -p) + s[2] * x
    t = p + c[1]
    z = t - p
    low = ((p - (t - z)) + (c[1] - z)) + (c[2] + e)
    hi = t + low
    w = hi - t
    return (hi, (t - (hi - w)) + (low - w))
end
)";

constexpr std::string_view julia_times = R"(
function @_times(s, x)
    p = s[1] * x
    e = fma(s[1], x, -p) + s[2] * x
    hi = p + e
    return (hi, e - (hi - p))
end
)";

constexpr std::string_view julia_newton = R"(
# $name$^{k+1} from $name$^k: the solution x of R(x) = v on the branch through 1.
function $function$(v)
    low = min(v, one(v))
    high = max(v, one(v))
    x = last = one(v)
$ends$    for _ in 1:100
$statements$        r = $residual$
        slope = $slope$
        r == 0 && break
        if r > 0
            high = x
        else
            low = x
        end
        y = x - r / slope
        if !(low <= y <= high)
            y = low + (high - low) / 2
        end
        (y == x || y == last) && break
        last = x
        x = y
    end
    return x
end
)";

class Julia final : public Dialect {
 public:
  using Dialect::Dialect;

  std::string file(const Unit& u) const override {
    std::string out = comment(u, "#");
    out += "# Arguments are floating-point numbers of one type; the accuracy is stated for Float64.\n\n";
    out += "const " + u.prefix + "_arity = " + std::to_string(u.arity) + "\n";
    out += "const " + u.prefix + "_lowest = " + std::to_string(u.lowest) + "\n";
    out += "const " + u.prefix + "_size = " + std::to_string(u.size) + "\n";
    out += "const " + u.prefix + "_p = " + (u.shift.is_integer() ? u.shift.to_string() + ".0" : u.shift.to_string()) +
           "\n";
    if (u.has_pairs()) out += with_prefix(julia_pairs, u.prefix);
    if (u.has_times()) out += with_prefix(julia_times, u.prefix);
    for (const Level& level : u.levels) {
      if (!level.relation) continue;
      const Body b = body(*level.relation);
      std::string ends;
      if (level.low) ends += "    low = max(low, oftype(v, " + kernels::shortest(*level.low) + "))\n";
      if (level.high) ends += "    high = min(high, oftype(v, " + kernels::shortest(*level.high) + "))\n";
      out += filled(julia_newton, {{"name", level.name},
                                   {"function", helper("finer_" + level.name)},
                                   {"ends", ends},
                                   {"statements", lines(b.statements, "        ")},
                                   {"residual", b.values[0]},
                                   {"slope", b.values[1]}});
    }
    out += "\n\"Level variables of the step after the one that has these.\"\nfunction " + u.prefix + "_next(" +
           joined(u.level_names(), ", ") + ")\n    return [" + joined(next_values(u), ", ") + "]\nend\n";
    out += "\n\"Level variables of the step 0.\"\n" + u.prefix + "_start(" + joined(u.start_names(), ", ") + ") = [" +
           joined(start_values(u), ", ") + "]\n";
    out += "\n\"The coefficients of one step, lowest first.\"\nfunction " + u.prefix + "_mask(" +
           joined(u.arguments, ", ") + ")\n";
    for (const Branch& branch : u.branches) {
      std::string indent = "    ";
      if (branch.where) {
        out += "    if " + body(*branch.where).values[0] + " >= 0\n";
        indent += indent;
      }
      const Body b = body(branch.mask);
      out += lines(b.statements, indent) + indent + "return [\n" + list(b.values, indent + "    ") + indent + "]\n";
      if (branch.where) out += "    end\n";
    }
    return out + "end\n";
  }

 protected:
  std::string integer(const Rational& n) const override { return n.to_string() + (is_long(n, 53) ? ".0" : ""); }
  std::string pair(const Rational& n) const override {
    const auto [high, low] = split(n);
    return "(" + high.to_string() + (is_long(n, 53) ? ".0" : "") + ", " + low.to_string() +
           (is_long(n, 53) ? ".0" : "") + ")";
  }
  std::string floating(double x) const override { return kernels::shortest(x); }
  std::string square_root(const std::string& v) const override { return "sqrt((1 + " + v + ") / 2)"; }
  std::string helper(const std::string& name) const override { return prefix_ + "_" + name; }
  std::string rounded(const std::string& pair) const override { return pair + "[1]"; }
  std::string let(const std::string& name, bool, const std::string& value) const override {
    return name + " = " + value;
  }
};

// ---- JavaScript and TypeScript

constexpr std::string_view javascript_pairs = R"(
// Numbers of twice the precision, [hi, lo]; a*b - p, p = a*b rounded, by Dekker's splitting.
function @_product_error(a$n$, b$n$, p$n$)$rn$ {
  const s = 134217729 * a, t = 134217729 * b;
  const a1 = s - (s - a), b1 = t - (t - b);
  const a2 = a - a1, b2 = b - b1;
  return ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2;
}

// s*x + c
function @_step(s$p$, x$n$, c$p$)$rp$ {
  const p = s[0] * x;
  const e = @_product_error(s[0], x, p) + s[1] * x;
  const t = p + c[0];
  const z = t - p;
  const low = ((p - (t - z)) + (c[0] - z)) + (c[1] + e);
  const hi = t + low;
  const w = hi - t;
  return [hi, (t - (hi - w)) + (low - w)];
}
)";

constexpr std::string_view javascript_times = R"(
function @_times(s$p$, x$n$)$rp$ {
  const p = s[0] * x;
  const e = @_product_error(s[0], x, p) + s[1] * x;
  const hi = p + e;
  return [hi, e - (hi - p)];
}
)";

constexpr std::string_view javascript_newton = R"(
// $name$^{k+1} from $name$^k: the solution x of R(x) = v on the branch through 1.
function $function$(v$n$)$rn$ {
  let low = Math.min(v, 1), high = Math.max(v, 1);
  let x = 1, last = 1;
$ends$  for (let i = 0; i < 100; ++i) {
$statements$    const r = $residual$;
    const slope = $slope$;
    if (r === 0) break;
    if (r > 0) high = x;
    else low = x;
    let y = x - r / slope;
    if (!(y >= low && y <= high)) y = low + (high - low) / 2;
    if (y === x || y === last) break;
    last = x;
    x = y;
  }
  return x;
}
)";

class JavaScript final : public Dialect {
 public:
  JavaScript(std::string prefix, bool typed) : Dialect(std::move(prefix)), typed_(typed) {}

  std::string file(const Unit& u) const override {
    std::string out = comment(u, "//") + "\n";
    const std::string type = typed_ ? ": number" : "";
    const std::string open = typed_ ? "export " : "";
    const std::string pair_type = typed_ ? ": " + prefix_ + "_pair" : "";
    const std::vector<std::pair<std::string, std::string>> types = {
        {"n", type}, {"rn", type}, {"p", pair_type}, {"rp", pair_type}};
    const auto constant = [&](const std::string& name, const std::string& value) {
      out += open + "const " + u.prefix + "_" + name + type + " = " + value + ";\n";
    };
    constant("arity", std::to_string(u.arity));
    constant("lowest", std::to_string(u.lowest));
    constant("size", std::to_string(u.size));
    constant("p", u.shift.to_string());
    if (u.has_pairs()) {
      if (typed_) out += "\ntype " + prefix_ + "_pair = readonly [number, number];\n";
      out += with_prefix(filled(javascript_pairs, types), u.prefix);
      if (u.has_times()) out += with_prefix(filled(javascript_times, types), u.prefix);
    }
    for (const Level& level : u.levels) {
      if (!level.relation) continue;
      const Body b = body(*level.relation);
      std::string ends;
      if (level.low) ends += "  low = Math.max(low, " + kernels::shortest(*level.low) + ");\n";
      if (level.high) ends += "  high = Math.min(high, " + kernels::shortest(*level.high) + ");\n";
      auto values = types;
      values.insert(values.end(), {{"name", level.name},
                                   {"function", helper("finer_" + level.name)},
                                   {"ends", ends},
                                   {"statements", lines(b.statements, "    ")},
                                   {"residual", b.values[0]},
                                   {"slope", b.values[1]}});
      out += filled(javascript_newton, values);
    }
    const auto arguments = [&](const std::vector<std::string>& names) {
      std::vector<std::string> list;
      for (const auto& n : names) list.push_back(n + type);
      return "(" + joined(list, ", ") + ")" + (typed_ ? ": number[]" : "");
    };
    out += "\n// Level variables of the step after the one that has these.\n" + open + "function " + u.prefix +
           "_next" + arguments(u.level_names()) + " {\n  return [" + joined(next_values(u), ", ") + "];\n}\n";
    out += "\n// Level variables of the step 0.\n" + open + "function " + u.prefix + "_start" +
           arguments(u.start_names()) + " {\n  return [" + joined(start_values(u), ", ") + "];\n}\n";
    out += "\n// The coefficients of one step, lowest first.\n" + open + "function " + u.prefix + "_mask" +
           arguments(u.arguments) + " {\n";
    for (const Branch& branch : u.branches) {
      std::string indent = "  ";
      if (branch.where) {
        out += "  if (" + body(*branch.where).values[0] + " >= 0) {\n";
        indent += indent;
      }
      const Body b = body(branch.mask);
      out += lines(b.statements, indent) + indent + "return [\n" + list(b.values, indent + "  ") + indent + "];\n";
      if (branch.where) out += "  }\n";
    }
    return out + "}\n";
  }

 protected:
  std::string integer(const Rational& n) const override { return n.to_string() + (is_long(n, 53) ? ".0" : ""); }
  std::string pair(const Rational& n) const override {
    const auto [high, low] = split(n);
    return "[" + integer(high) + ", " + integer(low) + "]";
  }
  std::string floating(double x) const override { return kernels::shortest(x); }
  std::string square_root(const std::string& v) const override { return "Math.sqrt((1 + " + v + ") / 2)"; }
  std::string helper(const std::string& name) const override { return prefix_ + "_" + name; }
  std::string rounded(const std::string& pair) const override { return pair + "[0]"; }
  std::string let(const std::string& name, bool is_pair, const std::string& value) const override {
    return "const " + name + (typed_ && is_pair ? ": " + prefix_ + "_pair" : "") + " = " + value + ";";
  }

 private:
  bool typed_;
};

}  // namespace

std::unique_ptr<Dialect> make_python(const std::string& prefix) { return std::make_unique<Python>(prefix); }
std::unique_ptr<Dialect> make_julia(const std::string& prefix) { return std::make_unique<Julia>(prefix); }
std::unique_ptr<Dialect> make_javascript(const std::string& prefix, bool typed) {
  return std::make_unique<JavaScript>(prefix, typed);
}

}  // namespace twoscale::lowering::emit
