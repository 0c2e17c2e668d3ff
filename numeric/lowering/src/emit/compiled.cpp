// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluators in C99, C++20 and GLSL.
#include <algorithm>

#include "twoscale/kernels/number_text.hpp"
#include "twoscale/symbolic/error.hpp"
#include "unit.hpp"

namespace twoscale::lowering::emit {

namespace {

// low <= x <= high holds throughout; a cycle of two numbers at the last place is the end.
constexpr std::string_view newton = R"(
// $name$^{k+1} from $name$^k: the solution x of R(x) = v on the branch through 1.
$head$
{
    $real$ low = v < $one$ ? v : $one$;
    $real$ high = v < $one$ ? $one$ : v;
    $real$ x = $one$;
    $real$ last = x;
$ends$    for (int i = 0; i < 100; ++i) {
$statements$        $fixed$$real$ r = $residual$;
        $fixed$$real$ slope = $slope$;
        if (r == $zero$) break;
        if (r > $zero$) high = x;
        else low = x;
        $real$ y = x - r / slope;
        if (!(y >= low && y <= high)) y = low + (high - low) / $two$;
        if (y == x || y == last) break;
        last = x;
        x = y;
    }
    return x;
}
)";

// What C, C++ and GLSL have in common.
class Braces : public Dialect {
 protected:
  using Dialect::Dialect;
  virtual std::string fixed() const { return "const "; }  // before a name that is not changed
  virtual std::string real() const = 0;
  virtual std::string pair_type() const = 0;
  // Head of the function that solves for a level variable.
  virtual std::string finer_head(const std::string& function) const = 0;
  // What is done with the coefficients.
  virtual std::string result(const std::vector<std::string>& values, const std::string& indent) const = 0;

  std::string let(const std::string& name, bool is_pair, const std::string& value) const override {
    return fixed() + (is_pair ? pair_type() : real()) + " " + name + " = " + value + ";";
  }
  std::string rounded(const std::string& pair) const override { return pair + ".hi"; }

  std::string solvers(const Unit& u) const {
    std::string out;
    for (const Level& level : u.levels) {
      if (!level.relation) continue;
      const Body b = body(*level.relation);
      std::string ends;
      if (level.low) ends += "    if (low < " + floating(*level.low) + ") low = " + floating(*level.low) + ";\n";
      if (level.high) ends += "    if (high > " + floating(*level.high) + ") high = " + floating(*level.high) + ";\n";
      out += filled(newton, {{"name", level.name},
                             {"head", finer_head(helper("finer_" + level.name))},
                             {"real", real()},
                             {"fixed", fixed()},
                             {"zero", integer(0)},
                             {"one", integer(1)},
                             {"two", integer(2)},
                             {"ends", ends},
                             {"statements", lines(b.statements, "        ")},
                             {"residual", b.values[0]},
                             {"slope", b.values[1]}});
    }
    return out;
  }

  static std::vector<std::string> each(const std::vector<std::string>& names, const std::string& before) {
    std::vector<std::string> list;
    for (const auto& n : names) list.push_back(before + n);
    return list;
  }

  std::string formulas(const Unit& u) const {
    std::string out;
    for (const Branch& branch : u.branches) {
      std::string indent = "    ";
      if (branch.where) {
        out += "    if (" + body(*branch.where).values[0] + " >= " + integer(0) + ") {\n";
        indent += indent;
      }
      const Body b = body(branch.mask);
      out += lines(b.statements, indent) + result(b.values, indent);
      if (branch.where) out += "    }\n";
    }
    return out;
  }

  std::string ratio(const Rational& q) const {
    const Rational top(q.numerator()), bottom(q.denominator());
    return integer(top) + (bottom == Rational(1) ? "" : " / " + integer(bottom));
  }
};

std::string number_of(const Unit& u) { return std::to_string(u.size); }

// ---- C99

constexpr std::string_view c_pairs = R"(
// Numbers of twice the precision, hi + lo. The product is right because fma rounds once.
typedef struct { double hi, lo; } @_pair;

// s*x + c
static inline @_pair @_step(@_pair s, double x, @_pair c)
{
    const double p = s.hi * x;
    const double e = fma(s.hi, x, -p) + s.lo * x;
    const double t = p + c.hi;
    const double z = t - p;
    const double low = ((p - (t - z)) + (c.hi - z)) + (c.lo + e);
    const double sum = t + low;
    const double w = sum - t;
    @_pair r;
    r.hi = sum;
    r.lo = (t - (sum - w)) + (low - w);
    return r;
}
)";

constexpr std::string_view c_times = R"(
static inline @_pair @_times(@_pair s, double x)
{
    const double p = s.hi * x;
    const double e = fma(s.hi, x, -p) + s.lo * x;
    @_pair r;
    r.hi = p + e;
    r.lo = e - (r.hi - p);
    return r;
}
)";

class C final : public Braces {
 public:
  using Braces::Braces;

  std::string file(const Unit& u) const override {
    std::string out = comment(u, "//");
    out += with_prefix("#ifndef @_evaluator\n#define @_evaluator\n", u.prefix);
    if (u.has_pairs() || !u.levels.empty()) out += "\n#include <math.h>\n";
    out += with_prefix("\nenum { @_arity = ", u.prefix) + std::to_string(u.arity) +
           with_prefix(", @_lowest = ", u.prefix) + std::to_string(u.lowest) + with_prefix(", @_size = ", u.prefix) +
           number_of(u) + " };\n";
    out += with_prefix("#define @_p (", u.prefix) + ratio(u.shift) + ")\n";
    if (u.has_pairs()) out += with_prefix(c_pairs, u.prefix);
    if (u.has_times()) out += with_prefix(c_times, u.prefix);
    out += solvers(u);
    if (!u.levels.empty()) {
      const auto function = [&](const std::string& name, const std::vector<std::string>& arguments,
                                const std::vector<std::string>& values) {
        out += "static inline void " + u.prefix + "_" + name + "(" + joined(each(arguments, "double "), ", ") +
               (arguments.empty() ? "" : ", ") + "double out[" + std::to_string(u.levels.size()) + "])\n{\n" +
               result(values, "    ") + "}\n";
      };
      out += "\n// Level variables of the step after the one that has these.\n";
      function("next", u.level_names(), next_values(u));
      out += "\n// Level variables of the step 0.\n";
      function("start", u.start_names(), start_values(u));
    }
    out += "\n// The coefficients of one step, lowest first.\nstatic inline void " + u.prefix + "_mask(" +
           joined(each(u.arguments, "double "), ", ") + (u.arguments.empty() ? "" : ", ") + "double out[" + u.prefix +
           "_size])\n{\n";
    for (const auto& a : u.arguments)
      if (!u.uses(a)) out += "    (void)" + a + ";\n";
    return out + formulas(u) + "}\n\n#endif\n";
  }

 protected:
  std::string real() const override { return "double"; }
  std::string pair_type() const override { return prefix_ + "_pair"; }
  std::string floating(double x) const override { return decimal(kernels::shortest(x)); }
  std::string integer(const Rational& n) const override { return n.to_string() + ".0"; }
  std::string pair(const Rational& n) const override {
    const auto [high, low] = split(n);
    return "(" + pair_type() + "){" + integer(high) + ", " + integer(low) + "}";
  }
  std::string helper(const std::string& name) const override { return prefix_ + "_" + name; }
  std::string square_root(const std::string& v) const override { return "sqrt((1.0 + " + v + ") / 2.0)"; }
  std::string finer_head(const std::string& function) const override {
    return "static inline double " + function + "(double v)";
  }
  std::string result(const std::vector<std::string>& values, const std::string& indent) const override {
    std::string out;
    for (size_t i = 0; i < values.size(); ++i) out += indent + "out[" + std::to_string(i) + "] = " + values[i] + ";\n";
    return out + (indent.size() > 4 ? indent + "return;\n" : "");
  }

  static std::string decimal(const std::string& text) {
    return text.find_first_of(".eE") == std::string::npos ? text + ".0" : text;
  }
};

// ---- C++20

constexpr std::string_view cpp_pairs = R"(
// Numbers of twice the precision, hi + lo.
template <class Real>
struct pair {
    Real hi, lo;
};

// a*b - p, p = a*b rounded: by fma where there is one, else by Dekker's splitting.
template <class Real>
constexpr Real product_error(const Real& a, const Real& b, const Real& p)
{
    if constexpr (std::is_floating_point_v<Real>) {
        if (!std::is_constant_evaluated()) return std::fma(a, b, -p);
    }
    constexpr int digits = std::numeric_limits<Real>::digits;
    constexpr long long two_power = digits > 0 && digits < 122 ? 1LL << ((digits + 1) / 2) : 1LL;
    const Real c = Real(two_power + 1);
    const Real s = c * a, t = c * b;
    const Real a1 = s - (s - a), b1 = t - (t - b);
    const Real a2 = a - a1, b2 = b - b1;
    return ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2;
}

// s*x + c
template <class Real>
constexpr pair<Real> step(const pair<Real>& s, const Real& x, const pair<Real>& c)
{
    const Real p = s.hi * x;
    const Real e = product_error<Real>(s.hi, x, p) + s.lo * x;
    const Real t = p + c.hi;
    const Real z = t - p;
    const Real low = ((p - (t - z)) + (c.hi - z)) + (c.lo + e);
    const Real sum = t + low;
    const Real w = sum - t;
    return {sum, (t - (sum - w)) + (low - w)};
}

// |n| < 2^62, also where Real has fewer bits.
template <class Real>
constexpr pair<Real> exact(long long n)
{
    const Real hi = Real(n);
    if constexpr (std::is_floating_point_v<Real>) return {hi, Real(n - static_cast<long long>(hi))};
    else return {hi, Real(0)};
}
)";

constexpr std::string_view cpp_times = R"(
template <class Real>
constexpr pair<Real> times(const pair<Real>& s, const Real& x)
{
    const Real p = s.hi * x;
    const Real e = product_error<Real>(s.hi, x, p) + s.lo * x;
    const Real hi = p + e;
    return {hi, e - (hi - p)};
}
)";

constexpr std::string_view cpp_root = R"(
template <class Real>
constexpr Real root(const Real& v)
{
    if (!std::is_constant_evaluated()) {
        using std::sqrt;
        return sqrt(v);
    }
    Real x = v > Real(1) ? v : Real(1);
    for (;;) {  // from above, as long as it goes down
        const Real y = (x + v / x) / Real(2);
        if (!(y < x)) return x;
        x = y;
    }
}
)";

class Cpp final : public Braces {
 public:
  using Braces::Braces;

  std::string file(const Unit& u) const override {
    std::string out = comment(u, "//");
    const std::string guard = u.prefix + "_EVALUATOR_HPP";
    const std::string count = std::to_string(u.levels.size());
    const bool roots =
        std::any_of(u.levels.begin(), u.levels.end(), [](const Level& level) { return !level.relation; });
    out += "#ifndef " + guard + "\n#define " + guard + "\n\n#include <array>\n";
    if (u.has_pairs() || roots) out += "#include <cmath>\n";
    out += "#include <cstddef>\n";
    if (u.has_pairs()) out += "#include <limits>\n";
    if (u.has_pairs() || roots) out += "#include <type_traits>\n";
    out +=
        "\n// Real: float, double, long double, or any type with + - * / and comparisons (start and next: also sqrt, "
        "found by\n// its arguments); the accuracy is stated for double. All functions are constexpr.\n";
    out += "namespace " + u.prefix + " {\n\n";
    out += "inline constexpr long arity = " + std::to_string(u.arity) + ";\n";
    out += "inline constexpr long lowest = " + std::to_string(u.lowest) + ";\n";
    out += "inline constexpr std::size_t size = " + number_of(u) + ";\n";
    out += "inline constexpr double p = " + plain_ratio(u.shift) + ";\n";
    if (u.has_pairs() || !u.levels.empty()) {
      out += "\nnamespace detail {\n";
      if (u.has_pairs()) out += cpp_pairs;
      if (u.has_times()) out += cpp_times;
      if (roots) out += cpp_root;
      out += solvers(u) + "\n}  // namespace detail\n";
    }
    const std::string head = "template <class Real>\n[[nodiscard]] constexpr std::array<Real, ";
    if (!u.levels.empty()) {
      out += "\n// Level variables of the step after the one that has these.\n" + head + count + "> next(" +
             joined(each(u.level_names(), "const Real& "), ", ") + ")\n{\n    return {{" +
             joined(next_values(u), ", ") + "}};\n}\n";
      out += "\n// Level variables of the step 0.\n" + head + count + "> start(" +
             joined(each(u.start_names(), "const Real& "), ", ") + ")\n{\n    return {{" +
             joined(start_values(u), ", ") + "}};\n}\n";
    }
    std::vector<std::string> arguments;
    for (const auto& a : u.arguments)
      arguments.push_back((u.uses(a) ? "const Real& " : "[[maybe_unused]] const Real& ") + a);
    out += "\n// The coefficients of one step, lowest first.\n" + head + "size> mask(" + joined(arguments, ", ") +
           ")\n{\n" + formulas(u) + "}\n";
    return out + "\n}  // namespace " + u.prefix + "\n\n#endif\n";
  }

 protected:
  std::string real() const override { return "Real"; }
  std::string pair_type() const override { return "detail::pair<Real>"; }
  std::string floating(double x) const override { return "Real(" + kernels::shortest(x) + ")"; }
  std::string integer(const Rational& n) const override {
    if (fmpz_bits(n.numerator()) <= 31) return "Real(" + n.to_string() + ")";
    if (fmpz_bits(n.numerator()) <= 62) return "Real(" + n.to_string() + "LL)";
    const auto [high, low] = halves(n);
    return "(" + integer(high) + " * " + integer(chunk()) + " + " + integer(low) + ")";
  }
  std::string pair(const Rational& n) const override {
    if (fmpz_bits(n.numerator()) <= 31) return "detail::exact<Real>(" + n.to_string() + ")";
    if (fmpz_bits(n.numerator()) <= 62) return "detail::exact<Real>(" + n.to_string() + "LL)";
    const auto [high, low] = halves(n);
    return "detail::step<Real>(" + pair(high) + ", " + integer(chunk()) + ", " + pair(low) + ")";
  }
  std::string helper(const std::string& name) const override { return "detail::" + name + "<Real>"; }
  std::string square_root(const std::string& v) const override {
    return "detail::root<Real>((Real(1) + " + v + ") / Real(2))";
  }
  std::string finer_head(const std::string& function) const override {
    const std::string name = function.substr(8, function.size() - 14);  // without detail:: and <Real>
    return "template <class Real>\nconstexpr Real " + name + "(const Real& v)";
  }
  std::string result(const std::vector<std::string>& values, const std::string& indent) const override {
    return indent + "return {{\n" + list(values, indent + "    ") + indent + "}};\n";
  }

 private:
  static Rational chunk() { return Rational(2).pow(53); }
  static std::pair<Rational, Rational> halves(const Rational& n) {
    Rational high, low;
    fmpz_tdiv_q_2exp(fmpq_numref(high.raw()), n.numerator(), 53);
    low = n - high * chunk();
    return {high, low};
  }
  static std::string plain_ratio(const Rational& q) {
    const std::string top = Rational(q.numerator()).to_string() + ".0";
    return q.is_integer() ? top : top + " / " + Rational(q.denominator()).to_string() + ".0";
  }
};

// ---- GLSL

constexpr std::string_view glsl_pairs = R"(
// Numbers of twice the precision, x + y. Where the language has `precise` no compiler may reorder these sums; where it
// has not, one that does takes away the additional digits, no more.
#if (defined(GL_ES) && __VERSION__ >= 320) || (!defined(GL_ES) && __VERSION__ >= 400)
#define @_PRECISE precise
#else
#define @_PRECISE
#endif

// a*b - p, p = a*b rounded, by Dekker's splitting.
float @_product_error(float a, float b, float p)
{
    @_PRECISE float s = 4097.0 * a;
    @_PRECISE float t = 4097.0 * b;
    @_PRECISE float a1 = s - (s - a);
    @_PRECISE float b1 = t - (t - b);
    @_PRECISE float a2 = a - a1;
    @_PRECISE float b2 = b - b1;
    @_PRECISE float e = ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2;
    return e;
}

// s*x + c
vec2 @_step(vec2 s, float x, vec2 c)
{
    @_PRECISE float p = s.x * x;
    @_PRECISE float e = @_product_error(s.x, x, p) + s.y * x;
    @_PRECISE float t = p + c.x;
    @_PRECISE float z = t - p;
    @_PRECISE float low = ((p - (t - z)) + (c.x - z)) + (c.y + e);
    @_PRECISE float sum = t + low;
    @_PRECISE float w = sum - t;
    @_PRECISE float lo = (t - (sum - w)) + (low - w);
    return vec2(sum, lo);
}
)";

constexpr std::string_view glsl_times = R"(
vec2 @_times(vec2 s, float x)
{
    @_PRECISE float p = s.x * x;
    @_PRECISE float e = @_product_error(s.x, x, p) + s.y * x;
    @_PRECISE float hi = p + e;
    @_PRECISE float lo = e - (hi - p);
    return vec2(hi, lo);
}
)";

class Glsl final : public Braces {
 public:
  using Braces::Braces;

  unsigned bits() const override { return 24; }

  std::string file(const Unit& u) const override {
    const std::string count = std::to_string(u.levels.size());
    std::string out = comment(u, "//");
    out +=
        "// GLSL 1.30, GLSL ES 3.00 or later; to be pasted after #version and precision. Numbers are floats: constants "
        "are\n// rounded to nearest.\n";
    out += "#ifndef " + u.prefix + "_evaluator\n#define " + u.prefix + "_evaluator\n\n";
    out += "const int " + u.prefix + "_arity = " + std::to_string(u.arity) + ";\n";
    out += "const int " + u.prefix + "_lowest = " + std::to_string(u.lowest) + ";\n";
    out += "const int " + u.prefix + "_size = " + number_of(u) + ";\n";
    out += "const float " + u.prefix + "_p = " + ratio(u.shift) + ";\n";
    if (u.has_pairs()) out += with_prefix(glsl_pairs, u.prefix);
    if (u.has_times()) out += with_prefix(glsl_times, u.prefix);
    out += solvers(u);
    if (!u.levels.empty()) {
      const std::string type = "float[" + count + "]";
      out += "\n// Level variables of the step after the one that has these.\n" + type + " " + u.prefix + "_next(" +
             joined(each(u.level_names(), "float "), ", ") + ")\n{\n    return " + type + "(" +
             joined(next_values(u), ", ") + ");\n}\n";
      out += "\n// Level variables of the step 0.\n" + type + " " + u.prefix + "_start(" +
             joined(each(u.start_names(), "float "), ", ") + ")\n{\n    return " + type + "(" +
             joined(start_values(u), ", ") + ");\n}\n";
    }
    out += "\n// The coefficients of one step, lowest first.\nfloat[" + number_of(u) + "] " + u.prefix + "_mask(" +
           joined(each(u.arguments, "float "), ", ") + ")\n{\n" + formulas(u) + "}\n";
    return out + "\n#endif\n";
  }

 protected:
  std::string real() const override { return "float"; }
  std::string pair_type() const override { return "vec2"; }
  std::string rounded(const std::string& pair) const override { return pair + ".x"; }
  std::string floating(double x) const override {
    const std::string text = kernels::shortest(x);
    return text.find_first_of(".eE") == std::string::npos ? text + ".0" : text;
  }
  std::string integer(const Rational& n) const override {
    if (fmpz_bits(n.numerator()) > 127) bad_input("a coefficient is beyond the floats of GLSL", n.to_string());
    return n.to_string() + ".0";
  }
  std::string pair(const Rational& n) const override {
    const auto [high, low] = split(n);
    return "vec2(" + integer(high) + ", " + integer(low) + ")";
  }
  std::string helper(const std::string& name) const override { return prefix_ + "_" + name; }
  std::string square_root(const std::string& v) const override { return "sqrt((1.0 + " + v + ") / 2.0)"; }
  std::string finer_head(const std::string& function) const override { return "float " + function + "(float v)"; }
  std::string fixed() const override { return ""; }  // const means a constant expression before GLSL 4.20
  std::string result(const std::vector<std::string>& values, const std::string& indent) const override {
    return indent + "return float[" + std::to_string(values.size()) + "](\n" + list(values, indent + "    ") + indent +
           ");\n";
  }
};

}  // namespace

std::unique_ptr<Dialect> make_c(const std::string& prefix) { return std::make_unique<C>(prefix); }
std::unique_ptr<Dialect> make_cpp(const std::string& prefix) { return std::make_unique<Cpp>(prefix); }
std::unique_ptr<Dialect> make_glsl(const std::string& prefix) { return std::make_unique<Glsl>(prefix); }

}  // namespace twoscale::lowering::emit
