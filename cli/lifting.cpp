// SPDX-License-Identifier: GPL-3.0-or-later
// twoscale lifting SCHEME [--vanishing N|SPACE] [--dual SCHEME2] [--v0 E|--t E|--at ... --levels K]: the biorthogonal
// filter bank of a mask and its lifting steps, exactly; with values also level by level in proved digits.
#include <algorithm>
#include <sstream>

#include "session.hpp"
#include "twoscale/analysis/real_algebraic.hpp"
#include "twoscale/kernels/number_text.hpp"
#include "twoscale/lowering/filter_table.hpp"
#include "twoscale/reports/derivation.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"
#include "twoscale/symbolic/lifting.hpp"

namespace twoscale::cli {

namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string scheme;
  std::string dual;
  std::string vanishing;
  Values values;
  unsigned levels = 0;
  long digits = 17;
  bool doubles = false;
};

// What is asked for, exactly.
struct Task {
  Scheme scheme;  // with the parameters of the dual and of the moments
  std::string dual;
  Space moments;
  Lifting lifting;
};

Space moments_of(const std::string& text, const Scheme& s) {
  if (text.empty()) return {};
  if (text.find_first_not_of("0123456789") == std::string::npos) {
    if (text.size() > 2 || std::stol(text) > 32)
      bad_input("--vanishing: at most 32 moments can be asked for, not", text);
    return Space::one_frequency(static_cast<unsigned>(std::stol(text)), {});
  }
  const Space::Rebased r = Space::rebase(Space::parse(text), level_variables(s));
  for (size_t i = 0; i < r.scale.size(); ++i)
    if (r.scale[i] != 1)
      bad_input("--vanishing: the frequencies must be multiples of the scheme's, " + level_variables(s)[i].frequency(),
                text);
  return r.space;
}

Task make_task(const Options& o) {
  Task t;
  t.scheme = make_scheme(o.scheme);
  if (t.scheme.arity != 2) bad_input("lifting needs arity 2", t.scheme.id);
  if (!o.dual.empty() && !o.vanishing.empty()) bad_input("--dual and --vanishing exclude each other", o.vanishing);
  const auto adopt = [&](const std::vector<Parameter>& list) {
    for (const Parameter& p : list)
      if (std::none_of(t.scheme.parameters.begin(), t.scheme.parameters.end(),
                       [&](const auto& q) { return q.name == p.name; }))
        t.scheme.parameters.push_back(p);
  };
  const Laurent a = symbol(t.scheme);
  if (!o.dual.empty()) {
    const Scheme dual = make_scheme(o.dual);
    if (dual.arity != 2) bad_input("lifting needs arity 2", dual.id);
    t.dual = dual.id;
    adopt(dual.parameters);
    t.lifting = factor_pair(a, symbol(dual));
  } else {
    t.moments = moments_of(o.vanishing, t.scheme);
    adopt(level_parameters(t.moments));
    t.lifting = complete(a, t.moments);
  }
  return t;
}

// ---- Values of v at which something fails, and the levels and v^0 that they belong to

struct Failure {
  std::string v;
  std::string level;  // a number, or "every"
  std::string v0;     // empty for every level
};

// v^{[k+1]} = v > 0 belongs to v^0 = T_{2^{k+1}}(v) if all v^{[j]}, 1 <= j <= k, are positive.
std::vector<Failure> failures(const Polynomial& factor, const Scheme& s) {
  std::vector<Failure> list;
  const auto variables = level_variables(s);
  if (factor.variables().size() != 1 ||
      std::none_of(variables.begin(), variables.end(), [&](const auto& v) { return v.name == factor.variables()[0]; }))
    return list;
  for (const auto& zero : analysis::RealAlgebraic::zeros(factor)) {
    if (zero.sign() <= 0) continue;
    const std::string text = zero.expression().value_or(rounded_decimal(zero.enclose(256), 17));
    if (analysis::RealAlgebraic::compare(zero, analysis::RealAlgebraic(Rational(1))) >= 0) {
      list.push_back({text, "every", ""});
      continue;
    }
    for (unsigned k = 0; k < 64; ++k) {
      // x = T_{2^k}(v) = v^{[1]} must be positive; it may be exactly 0.
      const Ball v = zero.enclose(512);
      Ball x = v, y;
      for (unsigned j = 0; j < k; ++j) {
        arb_sqr(y.raw(), x.raw(), 512);
        arb_mul_2exp_si(y.raw(), y.raw(), 1);
        arb_sub_ui(x.raw(), y.raw(), 1, 512);
      }
      if (x.is_negative()) break;
      if (x.contains_zero() && k < 12 &&
          Polynomial::quotient(Polynomial::chebyshev(factor.variables()[0], 1U << k), factor))
        break;
      if (x.contains_zero()) throw Error(Error::Kind::undecided, "cannot decide the levels of a singular value", text);
      arb_sqr(y.raw(), x.raw(), 512);
      arb_mul_2exp_si(y.raw(), y.raw(), 1);
      arb_sub_ui(y.raw(), y.raw(), 1, 512);
      std::string v0 = rounded_decimal(y, 17);
      if (const auto q = zero.rational()) {
        Rational w = *q;
        for (unsigned j = 0; j <= k; ++j) w = Rational(2) * w * w - Rational(1);
        v0 = w.to_string();
      } else if (k < 12) {  // the rational cosines
        const Polynomial twice = Polynomial(2) * Polynomial::chebyshev(factor.variables()[0], 2U << k);
        for (const long n : {-1L, 0L, 1L})
          if (Polynomial::quotient(twice - Polynomial(n), factor)) v0 = Rational(n, 2).to_string();
      }
      list.push_back({text, std::to_string(k), v0});
    }
  }
  return list;
}

// Level variables are positive: no zero of a polynomial without negative coefficients.
bool cannot_vanish(const Polynomial& f, const Scheme& s) {
  const auto levels = level_variables(s);
  return f.all_coefficients_nonnegative() &&
         std::all_of(f.variables().begin(), f.variables().end(), [&](const std::string& name) {
           return std::any_of(levels.begin(), levels.end(), [&](const LevelVariable& v) { return v.name == name; });
         });
}

std::string failures_text(const std::vector<Polynomial>& factors, const Scheme& s) {
  std::string text;
  for (const Polynomial& f : factors) {
    if (cannot_vanish(f, s)) continue;
    text += (text.empty() ? "" : "; ") + f.pretty() + " = 0";
    for (const Failure& x : failures(f, s))
      text += ", v = " + x.v + (x.v0.empty() ? " (every level)" : " (level " + x.level + ", v0 = " + x.v0 + ")");
  }
  return text.empty() ? "none" : text;
}

Json failures_json(const std::vector<Polynomial>& factors, const Scheme& s) {
  Json list = Json::array();
  for (const Polynomial& f : factors) {
    if (cannot_vanish(f, s)) continue;
    Json at = Json::array();
    for (const Failure& x : failures(f, s)) at.push_back({{"v", x.v}, {"level", x.level}, {"v0", x.v0}});
    list.push_back({{"condition", f.pretty()}, {"at", at}});
  }
  return list;
}

// ---- Text and JSON of the exact bank

std::string step_text(const LiftingStep& s) {
  const std::string target = s.predict ? "odd" : "even", source = s.predict ? "even" : "odd";
  std::string text = target + "_j +=";
  bool first = true;
  for (long i = s.filter.highest(); i >= s.filter.lowest(); --i) {
    const RationalFunction c = s.filter.coefficient(i);
    if (c.is_zero()) continue;
    const std::string at = -i == 0 ? "" : (-i > 0 ? "+" : "") + std::to_string(-i);
    text += (first ? " [" : " + [") + c.to_string() + "] " + source + "_{j" + at + "}";
    first = false;
  }
  return text;
}

void print_filter(std::ostringstream& out, const std::string& name, const Laurent& a) {
  out << "  " << name;
  for (long i = a.lowest(); i <= a.highest(); ++i)
    out << (i == a.lowest() ? "" : ",") << " " << a.coefficient(i).to_string();
  out << "   from index " << a.lowest() << "\n";
}

std::string exact_text(const Task& t) {
  std::ostringstream out;
  const Lifting& l = t.lifting;
  out << "scheme     " << t.scheme.id << "\n";
  if (!t.dual.empty()) out << "dual       " << t.dual << "\n";
  if (t.moments.dimension() > 0)
    out << "moments    the synthesis wavelet annihilates " << t.moments.to_string() << "\n";
  for (const auto& v : level_variables(t.scheme))
    out << "level      " << v.name << " = " << v.meaning(2) << ", " << recurrence(v.name, 2) << "\n";
  out << "signal     even_j = x_{2j}, odd_j = x_{2j+1}; analysis from level k+1 to level k\n";
  out << "\nsteps      of the analysis, in place\n";
  for (size_t i = 0; i < l.factorization.steps.size(); ++i)
    out << "  " << i + 1 << " " << (l.factorization.steps[i].predict ? "predict  " : "update   ")
        << step_text(l.factorization.steps[i]) << "\n";
  const std::string delay = l.factorization.delay == 0 ? "" : std::to_string(l.factorization.delay);
  out << "  low      s_j = even_{j" << (l.factorization.delay > 0 ? "+" : "") << delay
      << "}/K, K = " << l.factorization.norm.to_string() << "\n";
  out << "  high     d_j = K*odd_{j"
      << (l.factorization.delay == 0 ? ""
                                     : (l.factorization.delay < 0 ? "+" : "") + std::to_string(-l.factorization.delay))
      << "}\n";
  out << "\nfilters    x_i = sum_j a_{i-2j} s_j + b_{i-2j} d_j, s_j = sum_i L_{i-2j} x_i, d_j = sum_i H_{i-2j} x_i\n";
  print_filter(out, "a =", l.bank.synthesis_low);
  print_filter(out, "b =", l.bank.synthesis_high);
  print_filter(out, "L =", l.bank.analysis_low);
  print_filter(out, "H =", l.bank.analysis_high);
  out << "vanishing moments: " << vanishing_moments(l.bank.synthesis_high) << " of b, "
      << vanishing_moments(l.bank.analysis_high) << " of H\n";
  out << "perfect reconstruction: proved, and the steps multiply to the filters exactly\n";
  out << "\nsteps fail at   " << failures_text(l.domain.poles, t.scheme) << "\n";
  out << "no dual at      " << failures_text(l.domain.common_zero, t.scheme) << "\n";
  return out.str();
}

Json step_json(const LiftingStep& s) {
  Json c = Json::array();
  for (long i = s.filter.highest(); i >= s.filter.lowest(); --i) c.push_back(s.filter.coefficient(i).to_string());
  return {{"type", s.predict ? "predict" : "update"}, {"lowest", -s.filter.highest()}, {"coefficients", c}};
}

Json exact_json(const Task& t) {
  const Lifting& l = t.lifting;
  Json j;
  j["format"] = "twoscale/lifting";
  j["version"] = 1;
  j["scheme"] = t.scheme.id;
  if (!t.dual.empty()) j["dual"] = t.dual;
  j["moments"] = t.moments.items();
  Json variables = Json::object();
  for (const auto& v : level_variables(t.scheme)) variables[v.name] = v.meaning(2);
  j["level_variables"] = variables;
  j["rule"] =
      "even_j = x_{2j}, odd_j = x_{2j+1}; predict: odd_j += sum_h c_h even_{j+h}; update: even_j += sum_h c_h "
      "odd_{j+h}; "
      "s_j = even_{j+delay}/norm, d_j = norm*odd_{j-delay}";
  Json steps = Json::array();
  for (const LiftingStep& s : l.factorization.steps) steps.push_back(step_json(s));
  j["steps"] = steps;
  j["norm"] = l.factorization.norm.to_string();
  j["delay"] = l.factorization.delay;
  j["filters"] = {
      {"rule", "x_i = sum_j a_{i-2j} s_j + b_{i-2j} d_j, s_j = sum_i L_{i-2j} x_i, d_j = sum_i H_{i-2j} x_i"},
      {"a", reports::laurent_json(l.bank.synthesis_low)},
      {"b", reports::laurent_json(l.bank.synthesis_high)},
      {"L", reports::laurent_json(l.bank.analysis_low)},
      {"H", reports::laurent_json(l.bank.analysis_high)}};
  j["vanishing_moments"] = {{"b", vanishing_moments(l.bank.synthesis_high)},
                            {"H", vanishing_moments(l.bank.analysis_high)}};
  j["reconstruction"] = "proved";
  j["steps_fail"] = failures_json(l.domain.poles, t.scheme);
  j["no_dual"] = failures_json(l.domain.common_zero, t.scheme);
  return j;
}

// ---- Level by level

// One Laurent polynomial as rows of decimals; `turned`: from the highest power down, as stencils are written.
struct Rows {
  long lowest = 0;
  std::vector<std::vector<std::string>> levels;
  std::vector<std::string> limit;
  std::string tail;
  std::string error;
};

struct Tables {
  std::vector<std::pair<std::string, std::string>> parameters;
  std::vector<Rows> steps;
  Rows norm;
  std::vector<kernels::FilterRow> filters;  // levels, then the limit
};

constexpr std::array<const char*, 4> layout_names = {"dec_lo", "dec_hi", "rec_lo", "rec_hi"};

Tables tables(const Task& t, const Options& o) {
  const Scheme& s = t.scheme;
  const lowering::Binding b = lowering::bind(s, o.values.v0, o.values.t, o.values.named());
  Tables r;
  r.parameters = b.description;
  lowering::LowerOptions options;
  options.levels = o.levels;
  options.digits = o.doubles ? 0 : o.digits;
  const auto rows = [&](const Laurent& a, bool turned) {
    kernels::MaskTable table = lowering::lower(s, a, b, options);
    Rows x;
    x.lowest = turned ? -table.limit.highest() : table.limit.lowest;
    for (kernels::MaskRow& row : table.levels) {
      if (turned) std::reverse(row.text.begin(), row.text.end());
      x.levels.push_back(std::move(row.text));
    }
    if (turned) std::reverse(table.limit.text.begin(), table.limit.text.end());
    x.limit = std::move(table.limit.text);
    x.tail = table.tail_bound;
    x.error = table.precision_error;
    return x;
  };
  for (const LiftingStep& step : t.lifting.factorization.steps) r.steps.push_back(rows(step.filter, true));
  r.norm = rows(Laurent(0, {t.lifting.factorization.norm}), false);
  r.filters = lowering::lower_filters(s, t.lifting.bank, b, options).filters;
  return r;
}

std::string joined(const std::vector<std::string>& list) {
  std::string s;
  for (const std::string& x : list) s += (s.empty() ? "" : ", ") + x;
  return s;
}

// Calls f(name of the level, row of x, the filters) for the levels and the limit.
template <class F>
void each_level(const Tables& t, F f) {
  for (size_t k = 0; k < t.norm.levels.size(); ++k)
    f(
        std::to_string(k), [k](const Rows& r) -> const std::vector<std::string>& { return r.levels[k]; },
        t.filters[k].text);
  f(
      "limit", [](const Rows& r) -> const std::vector<std::string>& { return r.limit; }, t.filters.back().text);
}

std::string tables_text(const Task& task, const Tables& t) {
  std::ostringstream out;
  out << "\nlevel by level, every digit proved\n";
  each_level(t, [&](const std::string& k, const auto& row, const auto& filters) {
    out << "k = " << k << "\n";
    for (size_t i = 0; i < t.steps.size(); ++i)
      out << "  " << i + 1 << " " << (task.lifting.factorization.steps[i].predict ? "predict  " : "update   ")
          << "h from " << t.steps[i].lowest << ": " << joined(row(t.steps[i])) << "\n";
    out << "  K          " << joined(row(t.norm)) << "\n";
    for (size_t i = 0; i < 4; ++i) out << "  " << layout_names[i] << "     " << joined(filters[i]) << "\n";
  });
  return out.str();
}

void add_tables(Json& j, const Task& task, const Tables& t) {
  Json parameters = Json::object();
  for (const auto& [name, value] : t.parameters) parameters[name] = value;
  j["parameters"] = parameters;
  Json levels = Json::array();
  each_level(t, [&](const std::string& k, const auto& row, const auto& filters) {
    Json level;
    if (k == "limit")
      level["k"] = k;
    else
      level["k"] = std::stol(k);
    Json steps = Json::array();
    for (size_t i = 0; i < t.steps.size(); ++i)
      steps.push_back({{"type", task.lifting.factorization.steps[i].predict ? "predict" : "update"},
                       {"lowest", t.steps[i].lowest},
                       {"coefficients", row(t.steps[i])}});
    level["steps"] = steps;
    level["norm"] = row(t.norm)[0];
    for (size_t i = 0; i < 4; ++i) level[layout_names[i]] = filters[i];
    levels.push_back(level);
  });
  j["limit"] = levels.back();
  levels.erase(levels.size() - 1);
  j["levels"] = levels;
  Json tails = Json::array();
  for (const Rows& r : t.steps) tails.push_back(r.tail);
  j["tail"] = {{"from", t.norm.levels.size()}, {"steps", tails}, {"norm", t.norm.tail}};
}

// A module without dependencies.
std::string python_text(const Task& task, const Tables& t) {
  std::ostringstream out;
  const auto comment = [](const std::string& s) {
    std::string r;
    for (const char c : s) r += c >= 0x20 && c < 0x7f ? c : '?';
    return r;
  };
  out << "# Generated by twoscale: lifting steps of a biorthogonal filter bank.\n";
  out << "# Licence: this output is 0BSD, free for any use.\n";
  out << "# Scheme: " << comment(task.scheme.id) << "\n";
  if (!task.dual.empty()) out << "# Dual: " << comment(task.dual) << "\n";
  if (task.moments.dimension() > 0)
    out << "# The synthesis wavelet annihilates: " << comment(task.moments.to_string()) << "\n";
  std::string parameters;
  for (const auto& [name, value] : t.parameters) parameters += (parameters.empty() ? "" : ", ") + name + " = " + value;
  out << "# Parameters: " << (parameters.empty() ? "none" : comment(parameters)) << "\n";
  out << "# Row k belongs to the step between level k and level k+1; the last row is the limit, for all later "
         "levels.\n";
  out << "\"\"\"Lifting: analysis(x, k) and synthesis(s, d, k) of periodic signals; pywavelets(k) is the filter "
         "bank.\"\"\"\n\n";
  out << "# (kind, h, [c_h, c_{h+1}, ...]): predict odd[j] += sum c_h even[j+h], update even[j] += sum c_h odd[j+h].\n";
  out << "STEPS = [\n";
  each_level(t, [&](const std::string&, const auto& row, const auto&) {
    out << "    [";
    for (size_t i = 0; i < t.steps.size(); ++i)
      out << (i == 0 ? "" : ",\n     ") << "(\"" << (task.lifting.factorization.steps[i].predict ? "predict" : "update")
          << "\", " << t.steps[i].lowest << ", [" << joined(row(t.steps[i])) << "])";
    out << "],\n";
  });
  out << "]\n# s[j] = even[j+DELAY]/NORM, d[j] = NORM*odd[j-DELAY].\nNORM = [";
  bool first = true;
  each_level(t, [&](const std::string&, const auto& row, const auto&) {
    out << (first ? "" : ", ") << row(t.norm)[0];
    first = false;
  });
  out << "]\nDELAY = " << task.lifting.factorization.delay << "\n";
  out << "# dec_lo, dec_hi, rec_lo, rec_hi: low-pass filters of sum sqrt(2) where constants are reproduced.\nFILTERS = "
         "[\n";
  each_level(t, [&](const std::string&, const auto&, const auto& filters) {
    out << "    [";
    for (size_t i = 0; i < 4; ++i) out << (i == 0 ? "" : ",\n     ") << "[" << joined(filters[i]) << "]";
    out << "],\n";
  });
  out << "]\n\n\n"
         "def _row(rows, k):\n"
         "    return rows[min(k, len(rows) - 1)]\n\n\n"
         "def _lift(even, odd, steps, sign):\n"
         "    n = len(even)\n"
         "    for kind, low, c in steps:\n"
         "        target, source = (odd, even) if kind == \"predict\" else (even, odd)\n"
         "        target[:] = [target[j] + sign * sum(w * source[(j + low + i) % n] for i, w in enumerate(c))\n"
         "                     for j in range(n)]\n\n\n"
         "def analysis(x, k):\n"
         "    \"\"\"x: an even number of samples of level k+1, periodic. Returns s (level k) and d.\"\"\"\n"
         "    if len(x) % 2:\n"
         "        raise ValueError(\"an even number of samples is needed\")\n"
         "    even, odd = list(x[0::2]), list(x[1::2])\n"
         "    n, norm = len(even), _row(NORM, k)\n"
         "    _lift(even, odd, _row(STEPS, k), 1)\n"
         "    return ([even[(j + DELAY) % n] / norm for j in range(n)], [odd[(j - DELAY) % n] * norm for j in "
         "range(n)])\n\n\n"
         "def synthesis(s, d, k):\n"
         "    \"\"\"The inverse of analysis.\"\"\"\n"
         "    n, norm = len(s), _row(NORM, k)\n"
         "    even = [s[(j - DELAY) % n] * norm for j in range(n)]\n"
         "    odd = [d[(j + DELAY) % n] / norm for j in range(n)]\n"
         "    _lift(even, odd, _row(STEPS, k)[::-1], -1)\n"
         "    x = [0] * (2 * n)\n"
         "    x[0::2], x[1::2] = even, odd\n"
         "    return x\n\n\n"
         "def pywavelets(k):\n"
         "    \"\"\"pywt.Wavelet(\"name\", filter_bank=pywavelets(k))\"\"\"\n"
         "    return _row(FILTERS, k)\n";
  return out.str();
}

int run(const Options& o, const Common& common) {
  const bool values = o.values.v0 || o.values.t || !o.values.at.empty() || o.levels > 0 || common.format == "python";
  if (values && o.levels == 0) bad_input("--levels is missing: how many levels to tabulate");
  const Task task = make_task(o);
  std::optional<Tables> t;
  if (values) t = tables(task, o);
  if (common.format == "json") {
    Json j = exact_json(task);
    if (t) add_tables(j, task, *t);
    deliver(common, j.dump(1));
  } else if (common.format == "python") {
    deliver(common, python_text(task, *t));
  } else {
    deliver(common, exact_text(task) + (t ? tables_text(task, *t) : ""));
  }
  return 0;
}

}  // namespace

void add_lifting_command(CLI::App& app, Session& session) {
  auto o = std::make_shared<Options>();
  CLI::App* c = add_command(app, session, "lifting", "filter bank of a mask and a dual, and its lifting steps",
                            {"text", "json", "python"});
  c->add_option("scheme", o->scheme, "scheme name of the synthesis low-pass filter")->required()->type_name("SCHEME");
  c->add_option("--dual", o->dual, "scheme of the dual mask (sum 2)")->type_name("SCHEME");
  c->add_option("--vanishing", o->vanishing,
                "what the synthesis wavelet annihilates: a number N of moments, or a space \"1,x,exp(t*x),exp(-t*x)\"")
      ->type_name("N|SPACE");
  add_values(c, o->values);
  c->add_option("--levels", o->levels, "number K of levels to tabulate: rows k = 0..K-1")
      ->check(CLI::Range(1, 4096))
      ->type_name("K");
  CLI::Option* digits = c->add_option("--digits", o->digits, "significant digits, all correct; 17 by default")
                            ->check(CLI::Range(17, 10000))
                            ->type_name("D");
  c->add_flag("--double", o->doubles, "correctly rounded doubles, shortest texts")->excludes(digits);
  c->callback([&session, o] { session.action = [&session, o] { return run(*o, session.common); }; });
}

}  // namespace twoscale::cli
