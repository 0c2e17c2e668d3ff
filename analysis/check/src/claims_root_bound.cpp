// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Claim `root-bound`: for all parameters of a box all roots of a polynomial are smaller
// than r in absolute value.
#include "twoscale/check/claims.hpp"
#include "twoscale/check/positivity.hpp"
#include "twoscale/check/root_bound.hpp"

#include <algorithm>

namespace twoscale::check {
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
  // with x = bound * y, y in |y| < 1, times denominator^n
  const std::vector<Polynomial> a = root_coefficients(p, index, names.size(), bound, meter);
  const std::size_t n = a.size() - 1;
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
  const std::vector<Polynomial> derived = root_conditions(a, meter);
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
