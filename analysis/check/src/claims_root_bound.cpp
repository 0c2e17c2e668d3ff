// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Claim `root-bound`: for all parameters of a box all roots of a polynomial are smaller
// than r in absolute value. Without parameters by Schur-Cohn reduction, else by conditions of Jury (degree up to 3) or
// of Lienard and Chipart after s = (u+1)/(u-1).
#include "twoscale/check/claims.hpp"
#include "twoscale/check/positivity.hpp"

#include <algorithm>

namespace twoscale::check {
namespace {

constexpr std::size_t most_parametric_degree = 16;

Polynomial sum(const Polynomial& a, const Polynomial& b, int factor, Meter& meter) {
  Polynomial result = a;
  add_scaled(result, b, factor, Monomial{}, meter);
  return result;
}

Polynomial product(const Polynomial& a, const Polynomial& b, Meter& meter) {
  Polynomial result;
  for (const auto& [monomial, coefficient] : a) add_scaled(result, b, coefficient, monomial, meter);
  return result;
}

/// (sum a_k x^k at x = (u+1)/(u-1)) * (u-1)^n, from the constant term up.
std::vector<Polynomial> half_plane_form(const std::vector<Polynomial>& a, Meter& meter) {
  const std::size_t n = a.size() - 1;
  std::vector<Polynomial> result(n + 1);
  for (std::size_t k = 0; k <= n; ++k) {
    std::vector<Integer> weight{1};  // (u+1)^k (u-1)^{n-k}
    for (std::size_t i = 0; i < n; ++i) {
      std::vector<Integer> next(weight.size() + 1);
      for (std::size_t j = 0; j < weight.size(); ++j) {
        next[j + 1] += weight[j];
        next[j] += i < k ? weight[j] : Integer(-weight[j]);
      }
      weight = std::move(next);
    }
    meter.spend(20 * n * n);
    for (std::size_t j = 0; j <= n; ++j) add_scaled(result[j], a[k], weight[j], Monomial{}, meter);
  }
  return result;
}

/// The k-th Hurwitz determinant of sum h_j u^j: rows i, columns j = 0..k-1, entry h_{n-1-2j+i}. By minors of the first
/// rows: one for each set of columns.
Polynomial hurwitz(const std::vector<Polynomial>& h, std::size_t k, Meter& meter) {
  const long n = static_cast<long>(h.size()) - 1;
  std::vector<Polynomial> minors(std::size_t{1} << k);
  minors[0] = {{Monomial{}, Integer(1)}};
  for (std::size_t set = 1; set < minors.size(); ++set) {
    long row = -1;
    for (std::size_t j = 0; j < k; ++j) row += (set >> j & 1U) != 0 ? 1 : 0;
    int sign = 1;
    for (std::size_t j = k; j-- > 0;) {  // expansion along the last row, from its last column
      if ((set >> j & 1U) == 0) continue;
      const long index = n - 1 - 2 * static_cast<long>(j) + row;
      meter.spend(20);
      if (index >= 0 && index <= n) {
        const Polynomial part = product(h[static_cast<std::size_t>(index)], minors[set ^ (std::size_t{1} << j)], meter);
        add_scaled(minors[set], part, sign, Monomial{}, meter);
      }
      sign = -sign;
    }
    for (const auto& [monomial, coefficient] : minors[set]) meter.hold(128 + 8 * words(coefficient));
  }
  return minors.back();
}

/// All positive exactly if the roots of sum a_k x^k, a_n > 0, n = a.size() - 1, lie in |x| < 1.
std::vector<Polynomial> conditions_of(const std::vector<Polynomial>& a, Meter& meter) {
  const auto plus = [&](const Polynomial& p, const Polynomial& q) { return sum(p, q, 1, meter); };
  const auto minus = [&](const Polynomial& p, const Polynomial& q) { return sum(p, q, -1, meter); };
  const auto times = [&](const Polynomial& p, const Polynomial& q) { return product(p, q, meter); };
  switch (a.size()) {
    case 1: return {a[0]};
    case 2: return {minus(a[1], a[0]), plus(a[1], a[0])};
    case 3: return {minus(a[2], a[0]), plus(plus(a[2], a[0]), a[1]), minus(plus(a[2], a[0]), a[1])};
    case 4: {
      const Polynomial even = plus(a[2], a[0]), odd = plus(a[3], a[1]);
      const Polynomial first = minus(times(a[3], a[3]), times(a[0], a[0]));
      const Polynomial second = minus(times(a[3], a[1]), times(a[2], a[0]));
      return {plus(odd, even),  minus(odd, even),    minus(a[3], a[0]),
              plus(a[3], a[0]), plus(first, second), minus(first, second)};
    }
    default: break;
  }
  const std::size_t n = a.size() - 1;
  if (n > most_parametric_degree) throw Malformed("root-bound: degrees with parameters are at most 16");
  const std::vector<Polynomial> h = half_plane_form(a, meter);
  std::vector<Polynomial> result = h;
  for (std::size_t k = n - 1; k > 1; k -= 2) result.push_back(hurwitz(h, k, meter));
  return result;
}

/// Do all roots lie in |x| < 1, and is a_n not 0? `a` from the constant term up, not trimmed.
bool schur_cohn(Dense a, Meter& meter) {
  if (a.empty() || a.back() == 0) return false;
  while (a.size() > 1) {
    const Integer low = a.front(), lead = a.back();
    if (abs(low) >= abs(lead)) return false;
    Dense next(a.size() - 1);  // (lead a(x) - low x^n a(1/x))/x
    for (std::size_t i = 0; i < next.size(); ++i) {
      next[i] = meter.multiply(lead, a[i + 1]) - meter.multiply(low, a[a.size() - 2 - i]);
    }
    a = primitive(std::move(next), meter);
  }
  return true;
}

}  // namespace

Finding check_root_bound(Meter& meter, Fields& fields, bool proved) {
  const std::string& text = fields.take_string("polynomial");
  const std::string where = fields.path("polynomial");
  const std::string& root = fields.take_string("root");
  const std::string& bound_text = fields.take_string("bound");
  const Fraction bound = parse_fraction(bound_text, fields.path("bound"), meter);
  if (bound.numerator <= 0) throw Malformed(fields.path("bound") + ": a positive number is expected");
  Box box = read_box(fields, meter);
  read_zeros(fields, box);

  std::vector<std::string> names = box.names;
  const auto place = std::lower_bound(names.begin(), names.end(), root);
  const auto index = static_cast<std::size_t>(place - names.begin());
  if (!is_variable_name(root) || (place != names.end() && *place == root)) {
    throw Malformed(fields.path("root") + ": a name that is no parameter is expected");
  }
  names.insert(place, root);
  if (names.size() > limits::variables) throw Malformed(where + ": more than 8 variables");
  const Polynomial p = parse_polynomial(text, names, where, meter);
  if (p.empty()) throw Malformed(where + ": 0 has no roots to bound");
  const auto n = static_cast<std::size_t>(degrees(p)[index]);
  std::vector<Polynomial> a(n + 1);  // with x = bound * y, y in |y| < 1, times denominator^n
  for (const auto& [monomial, coefficient] : p) {
    const auto k = static_cast<std::size_t>(monomial[index]);
    Monomial rest{};
    for (std::size_t j = 0, to = 0; j < names.size(); ++j) {
      if (j != index) rest[to++] = monomial[j];
    }
    const Integer scale = meter.multiply(meter.power(bound.numerator, k), meter.power(bound.denominator, n - k));
    add_term(a[k], rest, meter.multiply(coefficient, scale), meter);
  }
  const std::string domain = text_of(box);
  const std::string subject = "all " + std::to_string(n) + " roots " + root.substr(0, 64) + " of " +
                              (text.size() <= 200 ? text : "(a polynomial)") + " in |" + root.substr(0, 64) + "| < " +
                              text_of(bound) + (domain.empty() ? "" : " for " + domain);
  const auto values_at = [&](const std::vector<Fraction>& point) {  // over a common denominator
    Monomial top{};
    for (const Polynomial& c : a) {
      const Monomial d = degrees(c);
      for (std::size_t j = 0; j < d.size(); ++j) top[j] = std::max(top[j], d[j]);
    }
    Dense values;
    for (const Polynomial& c : a) {
      const Monomial d = degrees(c);
      Integer value = scaled_value(c, point, meter);
      for (std::size_t j = 0; j < point.size(); ++j) {
        value = meter.multiply(value, meter.power(point[j].denominator, static_cast<std::uint64_t>(top[j] - d[j])));
      }
      values.push_back(std::move(value));
    }
    return values;
  };
  if (!proved) {
    Fields witness(fields.take("witness"), fields.path("witness"));
    const std::vector<Fraction> point = read_point(witness.take("at"), box, witness.path("at"), meter);
    witness.done();
    if (on_excluded_face(point, box)) throw Refused(witness.path("at") + ": a face where nothing is claimed");
    if (schur_cohn(values_at(point), meter)) throw Refused(witness.path("at") + ": all roots are inside");
    return {subject, "a root is not inside, or the degree is less, at a point", {"schur-cohn"}};
  }
  const std::vector<Value>& conditions = fields.take_array("conditions");
  if (box.names.empty()) {
    if (!conditions.empty()) throw Malformed(fields.path("conditions") + ": none without parameters");
    if (!schur_cohn(values_at({}), meter)) throw Refused(where + ": not all roots are inside");
    return {subject, "Schur-Cohn reduction", {"schur-cohn"}};
  }
  const std::vector<Polynomial> derived = conditions_of(a, meter);
  if (conditions.size() != derived.size()) {
    throw Malformed(fields.path("conditions") + ": " + std::to_string(derived.size()) + " are expected");
  }
  Finding finding{subject, std::to_string(derived.size()) + " conditions verified", {"schur-cohn"}};
  for (std::size_t i = 0; i < derived.size(); ++i) {
    Fields condition(conditions[i], fields.path("conditions") + "[" + std::to_string(i) + "]");
    const std::string& method = condition.take_string("method");
    const std::string& tree = condition.take_string("tree");
    condition.done();
    require_positive(derived[i], box, true, method, tree, condition.path("tree"), meter);
    const std::string_view key = method == "sturm" ? "sturm" : "bernstein";
    if (std::find(finding.trusted.begin(), finding.trusted.end(), key) == finding.trusted.end()) {
      finding.trusted.push_back(key);
    }
  }
  return finding;
}

}  // namespace twoscale::check
