// SPDX-License-Identifier: GPL-3.0-or-later
#include "audit/formula.hpp"

#include <algorithm>
#include <cctype>
#include <functional>
#include <optional>
#include <span>

#include "audit/calculus.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::reports::audit {

namespace {

constexpr long largest_count = 4096;

bool is_name_character(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// The position of the bracket that closes the one at `open`.
size_t closing(const std::string& text, size_t open, char left, char right) {
  int depth = 0;
  for (size_t i = open; i < text.size(); ++i) {
    if (text[i] == left) ++depth;
    if (text[i] == right && --depth == 0) return i;
  }
  bad_input("a bracket is not closed in", text);
}

std::pair<long, long> range(const std::string& text, const Counters& counters) {
  const size_t dots = text.find("..");
  if (dots == std::string::npos) bad_input("a range a..b is expected, not", text);
  const long from = integer(text.substr(0, dots), counters), to = integer(text.substr(dots + 2), counters);
  if (to - from > largest_count) bad_input("the range is too long:", text);
  return {from, to};
}

// "i=a..b" -> i, "a..b".
std::pair<std::string, std::string> counter(const std::string& text) {
  const size_t equals = text.find('=');
  if (equals == std::string::npos) bad_input("a counter name=a..b is expected, not", text);
  return {trimmed(text.substr(0, equals)), trimmed(text.substr(equals + 1))};
}

// "i=a..b: TEXT" -> the expansions of TEXT.
std::string repetition(const std::string& text, const std::string& separator, const std::string& none,
                       const Counters& counters) {
  const size_t colon = text.find(':');
  if (colon == std::string::npos) bad_input("a colon is missing in", text);
  const auto [name, bounds] = counter(text.substr(0, colon));
  const auto [from, to] = range(bounds, counters);
  std::string result;
  for (long i = from; i <= to; ++i) {
    Counters inner = counters;
    inner[name] = i;
    const std::string piece = expanded(trimmed(text.substr(colon + 1)), inner);
    result += (result.empty() ? "" : separator) + (separator == "," ? piece : "(" + piece + ")");
  }
  return result.empty() ? none : separator == "," ? result : "(" + result + ")";
}

std::string index_name(long index) { return index < 0 ? "m" + std::to_string(-index) : std::to_string(index); }

// One condition "c-r<=1".
bool condition(const std::string& text, const Counters& counters) {
  for (const char* op : {"<=", ">=", "=", "<", ">"}) {
    const size_t at = text.find(op);
    if (at == std::string::npos) continue;
    const std::string o = op;
    const long a = integer(text.substr(0, at), counters), b = integer(text.substr(at + o.size()), counters);
    return o == "<=" ? a <= b : o == ">=" ? a >= b : o == "=" ? a == b : o == "<" ? a < b : a > b;
  }
  bad_input("a condition is expected, not", text);
}

std::vector<std::string> pieces(const std::string& text, char separator) {
  std::vector<std::string> result;
  size_t from = 0;
  for (;;) {
    const size_t to = text.find(separator, from);
    result.push_back(trimmed(text.substr(from, to == std::string::npos ? to : to - from)));
    if (to == std::string::npos) return result;
    from = to + 1;
  }
}

// Expansion along the rows, zero entries left out: the matrices of the papers are small and sparse.
RationalFunction determinant_of(const std::vector<std::vector<RationalFunction>>& m) {
  std::vector<size_t> columns(m.size());
  for (size_t i = 0; i < columns.size(); ++i) columns[i] = i;
  const std::function<RationalFunction(size_t, const std::vector<size_t>&)> minor =
      [&](size_t row, const std::vector<size_t>& free) -> RationalFunction {
    if (row == m.size()) return 1;
    RationalFunction sum;
    for (size_t i = 0; i < free.size(); ++i) {
      const RationalFunction& entry = m[row][free[i]];
      if (entry.is_zero()) continue;
      std::vector<size_t> rest = free;
      rest.erase(rest.begin() + static_cast<long>(i));
      const RationalFunction term = entry * minor(row + 1, rest);
      sum += i % 2 == 0 ? term : -term;
    }
    return sum;
  };
  return minor(0, columns);
}

}  // namespace

long integer(const std::string& text, const Counters& counters) {
  // Counters become numbers first, so that they may stand in exponents.
  std::string numbers;
  for (size_t i = 0; i < text.size();) {
    size_t end = i;
    while (end < text.size() && is_name_character(text[end])) ++end;
    const auto known = counters.find(text.substr(i, end - i));
    if (known != counters.end())
      numbers += "(" + std::to_string(known->second) + ")";
    else
      numbers += text.substr(i, std::max<size_t>(end - i, 1));
    i = std::max(end, i + 1);
  }
  const auto value = parse_rational_function(numbers).constant();
  if (!value || !value->is_integer()) bad_input("an integer is expected, not", text);
  return value->to_long();
}

std::string expanded(const std::string& text, const Counters& counters) {
  std::string result;
  for (size_t i = 0; i < text.size();) {
    if (text.compare(i, 2, "[[") == 0) {
      const size_t end = closing(text, i, '[', ']');
      const std::string body = text.substr(i + 2, end - 1 - (i + 2));
      const size_t blank = body.find(' ');
      const std::string kind = body.substr(0, blank);
      const std::string rest = blank == std::string::npos ? "" : body.substr(blank + 1);
      if (kind == "list")
        result += repetition(rest, ",", "", counters);
      else if (kind == "sum")
        result += repetition(rest, " + ", "0", counters);
      else if (kind == "product")
        result += repetition(rest, "*", "1", counters);
      else
        bad_input("list, sum or product is expected, not", kind);
      i = end + 1;
    } else if (text[i] == '[' && i > 0 && is_name_character(text[i - 1])) {
      const size_t end = closing(text, i, '[', ']');
      result += "_" + index_name(integer(text.substr(i + 1, end - i - 1), counters));
      i = end + 1;
    } else if (text[i] == '{') {
      const size_t end = closing(text, i, '{', '}');
      const long value = integer(text.substr(i + 1, end - i - 1), counters);
      result += std::to_string(value);
      i = end + 1;
    } else {
      result += text[i++];
    }
  }
  return result;
}

std::vector<Counters> all_cases(const std::vector<std::string>& cases) {
  std::vector<Counters> result = {{}};
  for (const std::string& text : cases) {
    const auto [name, bounds] = counter(text);
    std::vector<Counters> longer;
    for (const Counters& c : result) {
      const auto [from, to] = range(bounds, c);
      for (long i = from; i <= to; ++i) {
        longer.push_back(c);
        longer.back()[name] = i;
      }
    }
    result = std::move(longer);
  }
  return result;
}

std::string case_text(const Counters& counters) {
  std::string text;
  for (const auto& [name, value] : counters) text += (text.empty() ? "" : ", ") + name + " = " + std::to_string(value);
  return text;
}

RationalFunction in_z(const Laurent& a) {
  RationalFunction sum;
  const RationalFunction z = RationalFunction::variable("z");
  for (long i = a.lowest(); i <= a.highest(); ++i) sum += a.coefficient(i) * z.pow(i);
  return sum;
}

Formulas::Formulas(const std::vector<std::string>& definitions, const Counters& counters) : counters_(counters) {
  for (const std::string& d : definitions) define(d);
}

RationalFunction Formulas::operator()(const std::string& text) const { return value(text, counters_); }

RationalFunction Formulas::value(const std::string& text, const Counters& counters) const {
  RationalFunction f = parse_rational_function(expanded(text, counters));
  for (const std::string& name : f.variables()) {
    const auto known = values_.find(name);
    if (known != values_.end()) {
      f = f.substitute(name, known->second);
      continue;
    }
    // A coefficient outside the support.
    for (const std::string& family : families_)
      if (name.size() > family.size() + 1 && name.compare(0, family.size() + 1, family + "_") == 0) {
        f = f.substitute(name, 0);
        break;
      }
  }
  return f;
}

RationalFunction Formulas::determinant(const std::string& text) const {
  const size_t colon = text.find(':');
  if (colon == std::string::npos) bad_input("a colon is missing in", text);
  std::vector<std::string> words;
  for (const std::string& w : pieces(expanded(text.substr(0, colon), counters_), ' '))
    if (!w.empty()) words.push_back(w);
  if (words.size() < 4 || words[0] != "rows" || words[2] != "columns")
    bad_input("rows a..b columns c..d is expected, not", text);
  const auto [first_row, last_row] = range(words[1], {});
  const auto [first_column, last_column] = range(words[3], {});
  std::optional<long> without;
  if (words.size() == 6 && words[4] == "without") without = integer(words[5], {});
  struct Rule {
    std::vector<std::string> conditions;
    std::string entry;
  };
  std::vector<Rule> rules;
  for (const std::string& rule : pieces(text.substr(colon + 1), ';')) {
    const size_t arrow = rule.find("->");
    if (arrow == std::string::npos) bad_input("-> is missing in", rule);
    rules.push_back({pieces(rule.substr(0, arrow), ','), rule.substr(arrow + 2)});
  }
  std::vector<std::vector<RationalFunction>> m;
  for (long r = first_row; r <= last_row; ++r) {
    m.emplace_back();
    for (long c = first_column; c <= last_column; ++c) {
      if (without == c) continue;
      Counters here = counters_;
      here["r"] = r;
      here["c"] = c;
      RationalFunction entry;
      for (const Rule& rule : rules)
        if (std::all_of(rule.conditions.begin(), rule.conditions.end(),
                        [&](const std::string& t) { return condition(expanded(t, here), here); })) {
          entry = value(rule.entry, here);
          break;
        }
      m.back().push_back(entry);
    }
    if (m.back().size() != static_cast<size_t>(last_row - first_row + 1)) bad_input("the matrix is not square:", text);
  }
  return determinant_of(m);
}

void Formulas::define(const std::string& text) {
  const size_t equals = text.find('=');
  if (equals == std::string::npos) bad_input("a definition name = formula is expected, not", text);
  const std::string name = expanded(trimmed(text.substr(0, equals)), counters_);
  const std::string body = trimmed(text.substr(equals + 1));
  const auto after = [&](const std::string& keyword) { return trimmed(body.substr(keyword.size())); };
  if (const auto made = defined_by_operation(name, body, [&](const std::string& t) { return (*this)(trimmed(t)); })) {
    for (const auto& [n, f] : *made) values_[n] = f;
  } else if (body.rfind("symbol ", 0) == 0) {
    RationalFunction f = in_z(symbol(make_scheme(expanded(after("symbol "), counters_))));
    for (const std::string& known : f.variables())
      if (const auto at = values_.find(known); at != values_.end()) f = f.substitute(known, at->second);
    values_[name] = f;
  } else if (body.rfind("determinant ", 0) == 0) {
    values_[name] = determinant(after("determinant "));
  } else if (body.rfind("coefficients of ", 0) == 0) {
    const RationalFunction f = (*this)(after("coefficients of "));
    long power = 0;
    RationalFunction::Factors rest;
    const Polynomial z = Polynomial::variable("z");
    for (const auto& [factor, exponent] : f.denominator_factors()) {
      if (factor == z)
        power = static_cast<long>(exponent);
      else if (factor.degree("z") > 0)
        bad_input("no Laurent polynomial in z:", body);
      else
        rest.emplace_back(factor, exponent);
    }
    const auto& names = f.numerator().variables();
    std::map<long, Polynomial> parts;
    f.numerator().for_each_term([&](const Rational& c, std::span<const unsigned long> exponents) {
      Polynomial term = Polynomial(1).scaled(c);
      long at = 0;
      for (size_t i = 0; i < names.size(); ++i) {
        if (names[i] == "z")
          at = static_cast<long>(exponents[i]);
        else
          term = term * Polynomial::variable(names[i]).pow(static_cast<unsigned>(exponents[i]));
      }
      parts[at] += term;
    });
    families_.push_back(name);
    for (const auto& [i, p] : parts)
      values_[name + "_" + index_name(i - power)] = RationalFunction::over_factors(p, f.denominator_content(), rest);
  } else if (const auto local =
                 local_definition(expanded(body, counters_), [this](const std::string& t) { return (*this)(t); })) {
    families_.push_back(name);
    for (const auto& [i, v] : *local) values_[name + "_" + index_name(i)] = v;
  } else {
    values_[name] = (*this)(body);
  }
}

}  // namespace twoscale::reports::audit
