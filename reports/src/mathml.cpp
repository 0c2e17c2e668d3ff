// SPDX-License-Identifier: GPL-3.0-or-later
// Expressions as MathML, by recursive descent:
//   sum = [-] product {(+|-) product};  product = power {(*|/) power};  power = atom [^ integer];
//   atom = integer | name | name(sum) | (sum)
// A quotient a*b/(c*d) becomes one fraction with the parentheses of numerator and denominator dropped.
#include <cctype>
#include <map>

#include "twoscale/reports/html.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::reports {

namespace {

// Typeset text, and whether it needs parentheses as a factor.
struct Piece {
  std::string text;
  bool is_sum = false;
  bool is_number = false;
};

std::string row(const std::string& s) { return "<mrow>" + s + "</mrow>"; }
std::string op(const char* symbol) { return std::string("<mo>") + symbol + "</mo>"; }
std::string bracket(const char* symbol) { return std::string("<mo stretchy=\"false\">") + symbol + "</mo>"; }
std::string fenced(const std::string& s) { return row(bracket("(") + s + bracket(")")); }
std::string factor(const Piece& p) { return p.is_sum ? fenced(p.text) : p.text; }

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  std::string all() {
    const Piece p = sum();
    if (position_ != text_.size()) stop();
    return row(p.text);
  }

 private:
  [[noreturn]] void stop() { bad_input("formula cannot be typeset at", std::string(text_.substr(position_))); }

  char next() {
    while (position_ < text_.size() && text_[position_] == ' ') ++position_;
    return position_ < text_.size() ? text_[position_] : '\0';
  }

  bool take(char c) {
    if (next() != c) return false;
    ++position_;
    return true;
  }

  Piece sum() {
    if (++depth_ > 200) stop();
    const bool negative = take('-');
    Piece p = product();
    if (negative) p = {op("−") + factor(p), true, false};
    while (next() == '+' || next() == '-') {
      const bool minus = text_[position_++] == '-';
      p = {p.text + op(minus ? "−" : "+") + factor(product()), true, false};
    }
    --depth_;
    return p;
  }

  Piece product() {
    Piece p = power();
    while (next() == '*' || next() == '/') {
      if (text_[position_++] == '/') {
        const Piece below = power();
        p = {"<mfrac>" + row(p.text) + row(below.text) + "</mfrac>", false, false};
      } else {
        const Piece right = power();
        // Two numbers side by side would read as one.
        p = {factor(p) + op(right.is_number ? "·" : "&#x2062;") + factor(right), false, false};
      }
    }
    return p;
  }

  Piece power() {
    const Piece base = atom();
    if (!take('^')) return base;
    std::string exponent = take('-') ? op("−") : "";
    exponent += take('(') ? closed_sum() : atom().text;
    return {"<msup>" + (base.is_sum ? fenced(base.text) : row(base.text)) + row(exponent) + "</msup>", false, false};
  }

  std::string closed_sum() {
    std::string s = sum().text;
    if (!take(')')) stop();
    return s;
  }

  Piece atom() {
    const auto letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
    const auto digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.'; };
    if (take('(')) {
      Piece p = sum();
      if (!take(')')) stop();
      return p;
    }
    const std::size_t begin = position_;
    if (digit(next())) {
      const std::size_t from = position_;
      while (position_ < text_.size() && digit(text_[position_])) ++position_;
      return {"<mn>" + std::string(text_.substr(from, position_ - from)) + "</mn>", false, true};
    }
    if (!letter(next())) stop();
    const std::size_t from = position_;
    while (position_ < text_.size() && (letter(text_[position_]) || digit(text_[position_]) || text_[position_] == '_'))
      ++position_;
    const std::string name(text_.substr(from, position_ - from));
    if (name.empty() || begin == text_.size()) stop();
    if (take('(')) {
      const std::string argument = closed_sum();
      if (name == "exp") return {"<msup><mi>e</mi>" + row(argument) + "</msup>", false, false};
      if (name == "sqrt") return {"<msqrt>" + argument + "</msqrt>", false, false};
      return {"<mi>" + name + "</mi>" + op("&#x2061;") + fenced(argument), false, false};
    }
    return {symbol(name), false, false};
  }

  // "λ" for "lambda".
  static std::string known_letter(const std::string& name) {
    static const std::map<std::string, std::string> letters = {{"pi", "π"},     {"theta", "θ"}, {"omega", "ω"},
                                                               {"lambda", "λ"}, {"mu", "μ"},    {"alpha", "α"}};
    const auto known = letters.find(name);
    return known != letters.end() ? known->second : name;
  }

  static std::string symbol(const std::string& name) {
    const auto below = name.find('_');
    if (below == std::string::npos || below == 0 || below + 1 == name.size())
      return "<mi>" + known_letter(name) + "</mi>";
    // d_m1 is how the value of a local parameter at the offset -1 is spelled.
    const std::string letter = known_letter(name.substr(0, below)), index = name.substr(below + 1);
    if (index.size() > 1 && index[0] == 'm' && index.find_first_not_of("0123456789", 1) == std::string::npos)
      return "<msub><mi>" + letter + "</mi><mrow><mo>−</mo><mn>" + index.substr(1) + "</mn></mrow></msub>";
    return "<msub><mi>" + letter + "</mi><mi>" + index + "</mi></msub>";
  }

  std::string_view text_;
  std::size_t position_ = 0;
  int depth_ = 0;
};

}  // namespace

std::string mathml(std::string_view expression) { return Reader(expression).all(); }

std::string formula(const std::string& left, std::string_view expression) {
  return "<math displaystyle=\"true\"><mrow>" + left + (left.empty() ? "" : op("=")) + mathml(expression) +
         "</mrow></math>";
}

}  // namespace twoscale::reports
