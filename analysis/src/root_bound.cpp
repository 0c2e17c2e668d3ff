// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/analysis/root_bound.hpp"

#include <algorithm>

#include "twoscale/symbolic/error.hpp"

namespace twoscale::analysis {

using Json = nlohmann::ordered_json;

namespace {

// Fraction-free elimination (Bareiss).
Polynomial determinant(std::vector<std::vector<Polynomial>> m) {
  Polynomial before = 1;
  int sign = 1;
  for (size_t k = 0; k + 1 < m.size(); ++k) {
    size_t pivot = k;
    while (pivot < m.size() && m[pivot][k].is_zero()) ++pivot;
    if (pivot == m.size()) return 0;
    if (pivot != k) {
      std::swap(m[pivot], m[k]);
      sign = -sign;
    }
    for (size_t i = k + 1; i < m.size(); ++i)
      for (size_t j = k + 1; j < m.size(); ++j)
        m[i][j] = Polynomial::exact_quotient(m[i][j] * m[k][k] - m[i][k] * m[k][j], before);
    before = m[k][k];
  }
  const Polynomial d = m.empty() ? Polynomial(1) : m.back().back();
  return sign < 0 ? -d : d;
}

bool schur_cohn(std::vector<Rational> a) {
  if (a.back().is_zero()) return false;
  while (a.size() > 1) {
    const Rational low = a.front(), lead = a.back();
    if (abs(low) >= abs(lead)) return false;
    std::vector<Rational> next;
    Rational content = 0;
    for (size_t i = 0; i + 1 < a.size(); ++i) {
      next.push_back(lead * a[i + 1] - low * a[a.size() - 2 - i]);
      if (!next.back().is_zero()) content = gcd(content, next.back());
    }
    for (auto& c : next) c /= content;  // not 0: the last one is lead^2 - low^2
    a = std::move(next);
  }
  return true;
}

// a_k radius^k, times a positive integer.
std::vector<Polynomial> scaled(const std::vector<Polynomial>& a, const Rational& radius) {
  std::vector<Polynomial> result;
  const Rational p(radius.numerator()), q(radius.denominator());
  for (size_t k = 0; k < a.size(); ++k)
    result.push_back(a[k].scaled(p.pow(static_cast<long>(k)) * q.pow(static_cast<long>(a.size() - 1 - k))));
  return result;
}

std::vector<Rational> values(const std::vector<Polynomial>& a, const BoxPoint& at) {
  std::vector<Rational> v;
  for (const auto& c : a) v.push_back(c.evaluate(at));
  return v;
}

bool excluded(const BoxPoint& at, const Box& box, const std::vector<std::string>& zeros) {
  for (const auto& r : box)
    for (const auto& [name, x] : at) {
      if (name != r.name) continue;
      const auto listed = [&](const std::string& end) {
        return std::find(zeros.begin(), zeros.end(), name + end) != zeros.end();
      };
      if ((x == r.low && listed("=lo")) || (r.high && x == *r.high && listed("=hi"))) return true;
    }
  return false;
}

Json entry(const RootBound& r, const std::string& root, const Rational& radius, const Box& sorted,
           const SignOptions& options) {
  if (r.verdict == Verdict::undecided) return nullptr;
  Json e;
  e["claim"] = "root-bound";
  e["verdict"] = to_string(r.verdict);
  e["polynomial"] = r.polynomial.to_string();
  e["root"] = root;
  e["bound"] = radius.to_string();
  e["variables"] = Json::array();
  e["box"] = Json::array();
  for (const auto& range : sorted) {
    e["variables"].push_back(range.name);
    e["box"].push_back(Json::array({range.low.to_string(), range.high ? range.high->to_string() : ""}));
  }
  std::vector<std::string> zeros = options.zeros;
  std::sort(zeros.begin(), zeros.end());
  zeros.erase(std::unique(zeros.begin(), zeros.end()), zeros.end());
  e["zeros"] = zeros;
  if (r.verdict == Verdict::proved) {
    e["conditions"] = Json::array();
    for (const auto& p : r.proofs) e["conditions"].push_back(Json::object({{"method", p.method}, {"tree", p.tree}}));
  } else {
    Json at = Json::array();
    for (const auto& [name, x] : *r.point) at.push_back(x.to_string());
    e["witness"] = Json::object({{"at", at}});
  }
  e["theorem"] = "schur-cohn";
  return e;
}

}  // namespace

std::vector<Polynomial> coefficients_in(const Polynomial& p, const std::string& root) {
  if (p.is_zero()) bad_input("0 has no roots to bound", "0");
  std::vector<Polynomial> a(static_cast<size_t>(p.degree(root)) + 1);
  const auto& names = p.variables();
  p.for_each_term([&](const Rational& c, std::span<const unsigned long> e) {
    Polynomial term = Polynomial::constant(c.numerator());
    size_t k = 0;
    for (size_t j = 0; j < names.size(); ++j) {
      if (names[j] == root)
        k = e[j];
      else
        term *= Polynomial::variable(names[j]).pow(static_cast<unsigned>(e[j]));
    }
    a[k] += term;
  });
  return a;
}

bool roots_inside(const Polynomial& p, const Rational& radius) {
  if (p.variables().size() > 1) bad_input("not a polynomial in one variable", p.to_string());
  if (radius.sign() <= 0) bad_input("a radius must be positive", radius.to_string());
  return schur_cohn(values(scaled(coefficients_in(p, p.is_constant() ? "x" : p.variables()[0]), radius), {}));
}

std::vector<Polynomial> jury_conditions(const std::vector<Polynomial>& a) {
  switch (a.size()) {
    case 1: return {a[0]};
    case 2: return {a[1] - a[0], a[1] + a[0]};
    case 3: return {a[2] - a[0], a[2] + a[0] + a[1], a[2] + a[0] - a[1]};
    case 4: {
      const Polynomial first = a[3] * a[3] - a[0] * a[0], second = a[3] * a[1] - a[2] * a[0];
      return {a[3] + a[2] + a[1] + a[0],
              a[3] - a[2] + a[1] - a[0],
              a[3] - a[0],
              a[3] + a[0],
              first + second,
              first - second};
    }
    default: bad_input("conditions of Jury are explicit up to degree 3", std::to_string(a.size()));
  }
}

std::vector<Polynomial> lienard_chipart_conditions(const std::vector<Polynomial>& a) {
  const size_t n = a.size() - 1;
  const Polynomial u = Polynomial::variable("u");
  std::vector<Polynomial> h(n + 1);
  for (size_t k = 0; k <= n; ++k) {
    const Polynomial weight =
        (u + Polynomial(1)).pow(static_cast<unsigned>(k)) * (u - Polynomial(1)).pow(static_cast<unsigned>(n - k));
    const std::vector<Polynomial> w = coefficients_in(weight, "u");
    for (size_t j = 0; j < w.size(); ++j) h[j] += a[k] * w[j];
  }
  std::vector<Polynomial> result = h;
  for (long k = static_cast<long>(n) - 1; k > 1; k -= 2) {
    std::vector<std::vector<Polynomial>> m(static_cast<size_t>(k), std::vector<Polynomial>(static_cast<size_t>(k)));
    for (long i = 0; i < k; ++i)
      for (long j = 0; j < k; ++j) {
        const long index = static_cast<long>(n) - 1 - 2 * j + i;
        if (index >= 0 && index <= static_cast<long>(n))
          m[static_cast<size_t>(i)][static_cast<size_t>(j)] = h[static_cast<size_t>(index)];
      }
    result.push_back(determinant(std::move(m)));
  }
  return result;
}

RootBound all_roots_inside(const Polynomial& p, const std::string& root, const Rational& radius, const Box& box,
                           const SignOptions& options) {
  if (radius.sign() <= 0) bad_input("a radius must be positive", radius.to_string());
  SignOptions strict = options;
  strict.strict = true;
  Box sorted = box;
  std::sort(sorted.begin(), sorted.end(), [](const Range& x, const Range& y) { return x.name < y.name; });
  BoxPoint inside;
  for (const auto& r : sorted) {
    if (r.name == root) bad_input("the root is among the parameters", root);
    inside.emplace_back(r.name, r.high ? (r.low + *r.high) / Rational(2) : r.low + Rational(1));
  }
  for (const auto& name : p.variables())
    if (name != root && std::none_of(box.begin(), box.end(), [&](const Range& r) { return r.name == name; }))
      bad_input("a variable that is not in the box", name);
  decide_sign(Polynomial(1), box, strict);  // a box that cannot be understood

  RootBound result;
  std::vector<Polynomial> a = scaled(coefficients_in(p, root), radius);
  const bool turned = a.back().evaluate(inside).sign() < 0;
  result.polynomial = turned ? -p : p;
  if (turned)
    for (auto& c : a) c = -c;
  const auto finish = [&]() {
    result.evidence = entry(result, root, radius, sorted, strict);
    return result;
  };
  const auto refute = [&](const BoxPoint& at) {
    if (excluded(at, sorted, options.zeros) || schur_cohn(values(a, at))) return false;
    result.verdict = Verdict::refuted;
    result.point = at;
    return true;
  };
  if (refute(inside)) return finish();
  if (box.empty()) {
    result.verdict = Verdict::proved;
    return finish();
  }
  if (a.size() > 17) {
    result.reason = "with parameters, a degree beyond 16";
    return finish();
  }
  result.conditions = a.size() <= 4 ? jury_conditions(a) : lienard_chipart_conditions(a);
  for (const auto& c : result.conditions) {
    const Positivity sign = decide_sign(c, box, strict);
    if (sign.verdict == Verdict::proved) {
      result.proofs.push_back(sign.proof);
      continue;
    }
    result.proofs.clear();
    result.reason =
        sign.verdict == Verdict::undecided ? sign.reason : "a condition vanishes at an irrational parameter";
    Rational towards = 0;  // from an excepted face into the box
    for (unsigned step = 1; sign.point && step <= 64; ++step) {
      BoxPoint at = *sign.point;
      for (size_t j = 0; j < at.size(); ++j) at[j].second += towards * (inside[j].second - at[j].second);
      if (refute(at)) {
        result.reason.clear();
        break;
      }
      towards = Rational(1, 2).pow(step);
    }
    return finish();
  }
  result.verdict = Verdict::proved;
  return finish();
}

}  // namespace twoscale::analysis
