// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/symbolic/exponential_sum.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>

#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale {

namespace {

using GiNaC::ex;
using Term = ExponentialSum::Term;

constexpr int greatest_power = 32;
constexpr std::size_t most_terms = 1000;
constexpr std::size_t most_products = 20000;  // in one multiplication
constexpr int most_turns = 10000;

// Exponents to coefficients, in an order that holds within one run of the program.
struct Before {
  bool operator()(const ExponentialMonomial& a, const ExponentialMonomial& b) const {
    return a.degree != b.degree ? a.degree < b.degree : a.lambda.compare(b.lambda) < 0;
  }
  using Pair = std::pair<ExponentialMonomial, ExponentialMonomial>;
  bool operator()(const Pair& a, const Pair& b) const {
    if ((*this)(a.first, b.first)) return true;
    return !(*this)(b.first, a.first) && (*this)(a.second, b.second);
  }
};
using Sum = std::map<Before::Pair, ex, Before>;

void add(Sum& sum, const ExponentialMonomial& u, const ExponentialMonomial& v, const ex& coefficient) {
  const auto [at, fresh] = sum.try_emplace({u, v}, coefficient);
  if (!fresh) at->second = (at->second + coefficient).expand();
  if (at->second.is_zero()) sum.erase(at);
  if (sum.size() > most_terms) bad_input("a formula with more than " + std::to_string(most_terms) + " terms");
}

Sum product(const Sum& a, const Sum& b) {
  if (a.size() * b.size() > most_products)
    bad_input("a formula that needs more than " + std::to_string(most_products) + " products");
  Sum r;
  for (const auto& [s, c] : a)
    for (const auto& [t, d] : b)
      add(r, {s.first.degree + t.first.degree, (s.first.lambda + t.first.lambda).expand()},
          {s.second.degree + t.second.degree, (s.second.lambda + t.second.lambda).expand()}, (c * d).expand());
  return r;
}

// The terms of a formula.
class Reader {
 public:
  Reader(GiNaC::symbol u, GiNaC::symbol v) : u_(std::move(u)), v_(std::move(v)) {}

  Sum terms(const ex& e) const {
    Sum sum;
    if (!e.has(u_) && !e.has(v_)) {
      if (!names_in(e).empty()) bad_input("a formula of u and v knows no other name", names_in(e).front());
      add(sum, {}, {}, e.expand());
      return sum;
    }
    if (e.is_equal(u_)) return {{{{1, 0}, {}}, 1}};
    if (e.is_equal(v_)) return {{{{}, {1, 0}}, 1}};
    if (GiNaC::is_a<GiNaC::add>(e)) {
      for (const ex& part : e)
        for (const auto& [at, c] : terms(part)) add(sum, at.first, at.second, c);
      return sum;
    }
    if (GiNaC::is_a<GiNaC::mul>(e)) {
      add(sum, {}, {}, 1);
      for (const ex& factor : e) sum = product(sum, terms(factor));
      return sum;
    }
    if (GiNaC::is_a<GiNaC::power>(e)) return power(e);
    using GiNaC::I;
    const ex half = ex(1) / 2;
    const std::string name = GiNaC::is_a<GiNaC::function>(e) ? GiNaC::ex_to<GiNaC::function>(e).get_name() : "";
    if (name == "exp") return exponentials(e, 1, 1, 0);
    if (name == "cosh") return exponentials(e, 1, half, half);
    if (name == "sinh") return exponentials(e, 1, half, -half);
    if (name == "cos") return exponentials(e, I, half, half);
    if (name == "sin") return exponentials(e, I, -I * half, I * half);
    refuse(e);
  }

 private:
  [[noreturn]] static void refuse(const ex& e) {
    std::ostringstream text;
    text << e;
    bad_input("not a sum of products of polynomials and exponentials in u and v", text.str().substr(0, 80));
  }

  // a exp(w x) + b exp(-w x) for the argument x = alpha u + beta v + gamma of e.
  Sum exponentials(const ex& e, const ex& w, const ex& a, const ex& b) const {
    const ex x = e.op(0).expand();
    const ex alpha = x.diff(u_), beta = x.diff(v_);
    if (alpha.has(u_) || alpha.has(v_) || beta.has(u_) || beta.has(v_)) refuse(e);
    const ex gamma = x.subs(GiNaC::lst{u_ == 0, v_ == 0});
    if (!names_in(alpha + beta + gamma).empty())
      bad_input("a formula of u and v knows no other name", names_in(alpha + beta + gamma).front());
    // exp(w gamma), by cosine and sine on the circle so that special angles come out exactly.
    const auto phase = [&](int sign) -> ex {
      if (gamma.is_zero()) return 1;
      if (w.is_equal(GiNaC::I)) return GiNaC::cos(gamma) + sign * GiNaC::I * GiNaC::sin(gamma);
      return GiNaC::exp(sign * gamma);
    };
    Sum r;
    add(r, {0, (w * alpha).expand()}, {0, (w * beta).expand()}, (a * phase(1)).expand());
    add(r, {0, (-w * alpha).expand()}, {0, (-w * beta).expand()}, (b * phase(-1)).expand());
    return r;
  }

  Sum power(const ex& e) const {
    if (!e.op(1).info(GiNaC::info_flags::integer)) refuse(e);
    const GiNaC::numeric n = GiNaC::ex_to<GiNaC::numeric>(e.op(1));
    if (n > greatest_power || n < -greatest_power) refuse(e);
    const int exponent = n.to_int();
    Sum base = terms(e.op(0));
    if (exponent < 0) {  // only c exp(...) has an inverse here
      if (base.size() != 1) refuse(e);
      const auto [at, c] = *base.begin();
      if (at.first.degree != 0 || at.second.degree != 0) refuse(e);
      base = {{{{0, -at.first.lambda}, {0, -at.second.lambda}}, 1 / c}};
    }
    Sum r;
    add(r, {}, {}, 1);
    for (int i = 0; i < std::abs(exponent); ++i) r = product(r, base);
    return r;
  }

  GiNaC::symbol u_, v_;
};

std::complex<double> to_complex(const ex& e) {
  const GiNaC::numeric n = GiNaC::ex_to<GiNaC::numeric>(e.evalf());
  return {n.real().to_double(), n.imag().to_double()};
}

// A key that depends on the exponents only: their texts.
std::string key(const Term& t) {
  std::ostringstream s;
  s << t.u.degree << ' ' << number_expression(t.u.lambda) << ' ' << t.v.degree << ' ' << number_expression(t.v.lambda);
  return s.str();
}

}  // namespace

std::string number_expression(const ex& number) {
  std::ostringstream s;
  s << number;
  std::string text = s.str();
  for (std::size_t at = 0; (at = text.find("Pi", at)) != std::string::npos;) text.replace(at, 2, "pi");
  return text;
}

RealFrequency real_frequency(const ex& lambda) {
  const ex re = lambda.real_part().expand(), im = lambda.imag_part().expand();
  if (re.is_zero() && im.is_zero()) return {};
  if (!re.is_zero() && !im.is_zero()) bad_input("a frequency must be real or imaginary", number_expression(lambda));
  RealFrequency f{re.is_zero() ? im : re, re.is_zero()};
  const Sign sign = to_exact_real(f.theta).sign();
  if (sign == Sign::unknown) throw Error(Error::Kind::undecided, "the sign of a frequency", number_expression(f.theta));
  if (sign == Sign::zero) return {};
  if (sign == Sign::negative) f.theta = (-f.theta).expand();
  return f;
}

ExponentialSum::ExponentialSum(std::vector<Term> terms) : terms_(std::move(terms)) {
  std::sort(terms_.begin(), terms_.end(), [](const Term& a, const Term& b) { return key(a) < key(b); });
  for (const Term& t : terms_)
    doubles_.push_back(
        {to_complex(t.coefficient), to_complex(t.u.lambda), to_complex(t.v.lambda), t.u.degree, t.v.degree});
}

ExponentialSum ExponentialSum::parse(std::string_view formula) {
  Symbols symbols;
  const ex e = parse_expression(formula, symbols);
  std::vector<Term> terms;
  for (const auto& [at, c] : Reader(symbols["u"], symbols["v"]).terms(e)) terms.push_back({c, at.first, at.second});
  return ExponentialSum(std::move(terms));
}

ExactReal ExponentialSum::at(const ex& u, const ex& v) const {
  // F is real, so that only real parts count: c exp(r + I w) -> exp(r) (Re c cos w - Im c sin w).
  ex sum = 0;
  for (const Term& t : terms_) {
    const ex exponent = (t.u.lambda * u + t.v.lambda * v).expand();
    const ex r = exponent.real_part().expand(), w = exponent.imag_part().expand();
    const ex wave = t.coefficient.real_part() * GiNaC::cos(w) - t.coefficient.imag_part() * GiNaC::sin(w);
    ex powers = 1;  // GiNaC has no 0^0
    for (unsigned i = 0; i < t.u.degree; ++i) powers *= u;
    for (unsigned i = 0; i < t.v.degree; ++i) powers *= v;
    sum += powers * GiNaC::exp(r) * wave;
  }
  return to_exact_real(sum.expand());
}

double ExponentialSum::estimate(double u, double v) const {
  std::complex<double> sum = 0;
  for (const Doubles& t : doubles_)
    sum += t.coefficient * std::pow(u, t.u_degree) * std::pow(v, t.v_degree) * std::exp(t.lambda * u + t.mu * v);
  return sum.real();
}

SampleLine SampleLine::parse(std::string_view first_text, std::string_view step_text) {
  SampleLine line;
  Symbols symbols;
  for (const auto& [text, number] : {std::pair(first_text, &line.first), std::pair(step_text, &line.step)}) {
    *number = parse_expression(text, symbols);
    to_exact_real(*number);  // refuses names
  }
  if (to_exact_real(line.step).sign() != Sign::positive) bad_input("a step must be positive", std::string(step_text));
  return line;
}

double SampleLine::estimate(double index) const { return to_complex(first).real() + index * to_complex(step).real(); }

std::vector<long> turns(const std::vector<ExponentialSum>& sums, Axis axis, const SampleLine& line, long count) {
  std::vector<long> list;
  for (const ExponentialSum& sum : sums)
    for (const Term& t : sum.terms()) {
      const ExponentialMonomial& m = axis == Axis::u ? t.u : t.v;
      const RealFrequency f = real_frequency(m.lambda);
      const std::string direction = axis == Axis::u ? "u" : "v";
      if (m.degree > 0) bad_input("a power of " + direction + " does not close", direction);
      const ex n = (f.theta * line.step * count / (2 * GiNaC::Pi)).expand();
      if (!f.is_zero() && (!f.trigonometric || !n.info(GiNaC::info_flags::posint)))
        bad_input("the direction " + direction + " does not close after " + std::to_string(count) + " steps of " +
                      number_expression(line.step) + ", because of the frequency",
                  number_expression(f.trigonometric ? f.theta : m.lambda));
      if (n > most_turns) bad_input("too many turns", number_expression(n));
      list.push_back(GiNaC::ex_to<GiNaC::numeric>(n).to_long());
    }
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

long least_closed_samples(std::vector<long> turns) {
  turns.push_back(0);
  std::vector<bool> taken(2 * static_cast<std::size_t>(*std::max_element(turns.begin(), turns.end())) + 1, false);
  for (const long a : turns)
    for (const long b : turns)
      for (const long sum : {a + b, a - b})
        if (sum > 0) taken[static_cast<std::size_t>(sum)] = true;
  for (std::size_t n = 3;; ++n) {
    bool determined = true;
    for (std::size_t multiple = n; multiple < taken.size(); multiple += n) determined = determined && !taken[multiple];
    if (determined) return static_cast<long>(n);
  }
}

Space least_space(const std::vector<ExponentialSum>& sums, Axis axis, const SampleLine& line) {
  unsigned powers = 2;
  std::vector<std::pair<RealFrequency, unsigned>> frequencies;  // and the number of powers
  for (const ExponentialSum& sum : sums)
    for (const Term& t : sum.terms()) {
      const ExponentialMonomial& m = axis == Axis::u ? t.u : t.v;
      const RealFrequency f = real_frequency(m.lambda);
      const unsigned n = m.degree + 1;
      if (f.is_zero()) {
        powers = std::max(powers, n + n % 2);
        continue;
      }
      const auto found =
          std::find_if(frequencies.begin(), frequencies.end(), [&](const auto& p) { return p.first == f; });
      if (found == frequencies.end())
        frequencies.emplace_back(f, n);
      else
        found->second = std::max(found->second, n);
    }
  std::string items;
  const auto add_item = [&](unsigned power, const std::string& factor) {
    std::string item = power == 0 ? "" : power == 1 ? "x" : "x^" + std::to_string(power);
    if (!factor.empty()) item += (item.empty() ? "" : "*") + factor;
    items += (items.empty() ? "" : ", ") + (item.empty() ? "1" : item);
  };
  for (unsigned r = 0; r < powers; ++r) add_item(r, "");
  for (const auto& [f, n] : frequencies) {
    const std::string theta = number_expression((f.theta * line.step).expand());
    for (unsigned r = 0; r < n; ++r)
      for (const bool second : {false, true}) {
        const std::string argument = "((" + theta + ")*x)";
        add_item(r, f.trigonometric ? (second ? "sin" : "cos") + argument
                    : second        ? "exp(-(" + theta + ")*x)"
                                    : "exp" + argument);
      }
  }
  return Space::parse(items);
}

std::vector<std::vector<ExponentialSum>> products(const std::vector<ExponentialSum>& coordinates) {
  struct Group {
    RealFrequency u, v;
    std::vector<std::vector<Term>> terms;  // by coordinate
  };
  std::vector<Group> groups;
  for (std::size_t c = 0; c < coordinates.size(); ++c)
    for (const Term& t : coordinates[c].terms()) {
      const RealFrequency u = real_frequency(t.u.lambda), v = real_frequency(t.v.lambda);
      auto g = std::find_if(groups.begin(), groups.end(), [&](const Group& o) { return o.u == u && o.v == v; });
      if (g == groups.end()) {
        groups.push_back({u, v, std::vector<std::vector<Term>>(coordinates.size())});
        g = groups.end() - 1;
      }
      g->terms[c].push_back(t);
    }
  // The frequency 0 is in every space: such a group joins one that is like it in the other direction.
  for (std::size_t i = 0; i < groups.size();) {
    std::size_t host = groups.size();
    for (std::size_t j = 0; j < groups.size() && host == groups.size(); ++j) {
      const bool u = groups[i].u == groups[j].u || groups[i].u.is_zero();
      const bool v = groups[i].v == groups[j].v || groups[i].v.is_zero();
      if (j != i && u && v) host = j;
    }
    if (host == groups.size()) {
      ++i;
      continue;
    }
    for (std::size_t c = 0; c < coordinates.size(); ++c)
      groups[host].terms[c].insert(groups[host].terms[c].end(), groups[i].terms[c].begin(), groups[i].terms[c].end());
    groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(i));
  }
  std::vector<std::vector<ExponentialSum>> parts;
  for (Group& g : groups) {
    auto& part = parts.emplace_back();
    for (auto& terms : g.terms) part.emplace_back(std::move(terms));
  }
  return parts;
}

}  // namespace twoscale
