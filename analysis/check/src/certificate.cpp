// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. Reading of the head of a certificate and of spaces; spaces as text.
#include "twoscale/check/certificate.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <tuple>

namespace twoscale::check {
namespace {

constexpr std::size_t label_chars = 4096;

std::string label(Fields& fields, std::string_view key) {
  const std::string& text = fields.take_string(key);
  if (text.size() > label_chars) throw Malformed(fields.path(key) + ": a label of more than 4096 characters");
  return text;
}

bool is_name(const std::string& name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return !name.empty() && name.size() <= 64 && letter(name.front()) &&
         std::all_of(name.begin(), name.end(), [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; });
}

void read_variables(Fields& fields, Certificate& certificate) {
  const std::vector<Value>& variables = fields.take_array("variables");
  if (variables.size() > limits::variables) {
    throw Malformed("variables: more than " + std::to_string(limits::variables));
  }
  for (std::size_t i = 0; i < variables.size(); ++i) {
    Fields variable(variables[i], "variables[" + std::to_string(i) + "]");
    const std::string& name = variable.take_string("name");
    if (!is_name(name)) throw Malformed(variable.path("name") + ": a name [A-Za-z][A-Za-z0-9_]* is expected");
    if (i > 0 && !(certificate.names.back() < name)) {
      throw Malformed(variable.path("name") + ": names must be distinct and sorted");
    }
    const std::string& scope = variable.take_string("scope");
    if (scope != "level" && scope != "constant" && scope != "sequence") {
      throw Malformed(variable.path("scope") + ": \"level\", \"constant\" or \"sequence\" is expected");
    }
    label(variable, "meaning");
    variable.done();
    certificate.names.push_back(name);
    (scope == "level" ? certificate.level : certificate.constants).push_back(i);
    if (scope != "constant") certificate.limits.push_back(i);
  }
}

void read_mask(Fields& fields, Certificate& certificate, Meter& meter) {
  Fields mask(fields.take("mask"), "mask");
  certificate.mask.lowest = mask.take_integer("lowest", -limits::index, limits::index);
  const std::vector<Value>& numerators = mask.take_array("numerators");
  if (numerators.empty() || numerators.size() > limits::mask_length) {
    throw Malformed("mask.numerators: from 1 to " + std::to_string(limits::mask_length) + " are expected");
  }
  for (std::size_t i = 0; i < numerators.size(); ++i) {
    const std::string where = "mask.numerators[" + std::to_string(i) + "]";
    certificate.mask.numerators.push_back(
        parse_polynomial(as_string(numerators[i], where), certificate.names, where, meter));
  }
  if (certificate.mask.numerators.front().empty() || certificate.mask.numerators.back().empty()) {
    throw Malformed("mask.numerators: the first and the last must not be 0");
  }
  certificate.mask.denominator =
      parse_polynomial(mask.take_string("denominator"), certificate.names, "mask.denominator", meter);
  if (certificate.mask.denominator.empty() || certificate.mask.denominator.begin()->second < 0) {
    throw Malformed("mask.denominator: a polynomial with positive leading coefficient is expected");
  }
  mask.done();
  certificate.mask.top = degrees(certificate.mask.denominator);
  for (const Polynomial& numerator : certificate.mask.numerators) {
    const Monomial d = degrees(numerator);
    for (std::size_t i = 0; i < d.size(); ++i) certificate.mask.top[i] = std::max(certificate.mask.top[i], d[i]);
  }
  const auto& n = certificate.mask.numerators;
  certificate.symmetric = std::equal(n.begin(), n.end(), n.rbegin());
}

/// The mask is that of the rule on equal knots.
void require_uniform_member(const Certificate& certificate, Meter& meter) {
  const KnotRule& rule = *certificate.knots;
  if (certificate.arity != 2 || !certificate.names.empty() || certificate.shift.numerator != 0)
    throw Malformed("knots: a binary mask without variables and shift is expected");
  const std::vector<Fraction> weights = uniform_weights(rule, meter);
  const Mask& mask = certificate.mask;
  const auto is = [&](long i, const Fraction& value) {  // a_i = value
    const bool within = i >= mask.lowest && i <= mask.highest();
    const Polynomial none;
    const Polynomial& n = within ? mask.numerators[static_cast<std::size_t>(i - mask.lowest)] : none;
    return meter.multiply(n.empty() ? Integer(0) : n.begin()->second, value.denominator) ==
           meter.multiply(value.numerator, mask.denominator.begin()->second);
  };
  const long far = std::max({std::labs(mask.lowest), std::labs(mask.highest()), rule.reach()});
  for (long i = -far; i <= far; ++i) {
    const long h = (1 - i) / 2 - rule.lowest;  // odd i: the weight of p_{j+h} in f_{2j+1}
    const bool weight = i % 2 != 0 && h >= 0 && h < static_cast<long>(weights.size());
    if (!is(i, weight ? weights[static_cast<std::size_t>(h)] : Fraction{i == 0 ? 1 : 0, 1}))
      throw Malformed("knots: on equal knots the rule is not that of the mask, at a_" + std::to_string(i));
  }
}

Certificate read_certificate(Fields& fields, Meter& meter) {
  Certificate certificate;
  certificate.arity = static_cast<int>(fields.take_integer("arity", 2, 64));
  read_variables(fields, certificate);
  certificate.shift = parse_small_fraction(fields.take_string("shift"), "shift", meter);
  const long numerator = certificate.shift.numerator * (certificate.arity - 1);
  const long divisor = std::gcd(numerator, certificate.shift.denominator);
  certificate.e = {numerator / divisor, certificate.shift.denominator / divisor};
  if (certificate.e.denominator > 1000) throw Malformed("shift: the denominator of (arity-1)*shift is beyond 1000");
  read_mask(fields, certificate, meter);
  if (fields.next_is("knots")) {
    certificate.knots = read_knot_rule(fields, meter);
    require_uniform_member(certificate, meter);
  }
  return certificate;
}

Family read_family(Fields& fields, Meter& meter) {
  const std::vector<Value>& matrices = fields.take_array("matrices");
  if (matrices.empty() || matrices.size() > limits::list_items)
    throw Malformed("matrices: from 1 to 4096 are expected");
  Family family;
  for (std::size_t i = 0; i < matrices.size(); ++i) {
    const std::size_t size = i == 0 ? 0 : family.matrices.front().size;
    family.matrices.push_back(read_matrix(matrices[i], size, "matrices[" + std::to_string(i) + "]", meter));
  }
  return family;
}

std::string exponent_text(const std::vector<long>& frequency, const Certificate& certificate) {
  std::string sum;
  int parts = 0;
  for (std::size_t i = 0; i < frequency.size(); ++i) {
    const long n = frequency[i];
    if (n == 0) continue;
    if (n < 0)
      sum += "-";
    else if (parts > 0)
      sum += "+";
    if (std::labs(n) != 1) sum += std::to_string(std::labs(n)) + "*";
    sum += frequency_name(certificate, i);
    ++parts;
  }
  if (parts == 0) return "";
  return parts == 1 ? "exp(" + sum + "*x)" : "exp((" + sum + ")*x)";
}

std::string power_text(long power, const std::string& exponential) {
  if (power == 0) return exponential.empty() ? "1" : exponential;
  const std::string x = power == 1 ? "x" : "x^" + std::to_string(power);
  return exponential.empty() ? x : x + "*" + exponential;
}

}  // namespace

Head read_head(Fields& fields, Meter& meter) {
  if (fields.take_string("format") != "twoscale/certificate") {
    throw Malformed("format: \"twoscale/certificate\" is expected");
  }
  fields.take_integer("version", 1, 1);
  Head head;
  head.scheme = label(fields, "scheme");
  if (fields.next_is("matrices")) {
    head.subject = read_family(fields, meter);
  } else if (fields.next_is("hermite")) {
    head.subject = read_hermite(fields.take("hermite"), meter);
  } else if (fields.next_is("claims")) {
    head.subject = Standalone{};
  } else {
    head.subject = read_certificate(fields, meter);
  }
  return head;
}

std::vector<long> read_frequency(const Value& value, const Certificate& certificate, const std::string& where) {
  const std::vector<Value>& items = as_array(value, where);
  if (items.size() != certificate.level.size()) {
    throw Malformed(where + ": " + std::to_string(certificate.level.size()) + " integers are expected");
  }
  std::vector<long> frequency;
  for (const Value& item : items) frequency.push_back(as_integer(item, -limits::index, limits::index, where));
  return frequency;
}

Space read_space(const Value& value, const Certificate& certificate, const std::string& where, bool may_be_empty) {
  const std::vector<Value>& items = as_array(value, where);
  if (items.empty() && !may_be_empty) throw Malformed(where + ": an empty space");
  if (items.size() > limits::list_items) throw Malformed(where + ": more than 4096 frequencies");
  Space space;
  for (std::size_t i = 0; i < items.size(); ++i) {
    Fields item(items[i], where + "[" + std::to_string(i) + "]");
    Exponential part;
    part.frequency = read_frequency(item.take("frequency"), certificate, item.path("frequency"));
    part.order = item.take_integer("order", 1, limits::order);
    item.done();
    if (i > 0 && !(space.back().frequency < part.frequency)) {
      throw Malformed(item.path("frequency") + ": frequencies must be distinct and ascending");
    }
    space.push_back(std::move(part));
  }
  return space;
}

long dimension(const Space& space) {
  return std::accumulate(space.begin(), space.end(), 0L, [](long sum, const Exponential& p) { return sum + p.order; });
}

long order_in(const Space& space, const std::vector<long>& frequency) {
  const auto found = std::find_if(space.begin(), space.end(), [&](const auto& p) { return p.frequency == frequency; });
  return found == space.end() ? 0 : found->order;
}

std::string frequency_name(const Certificate& certificate, std::size_t level_index) {
  const auto short_name = [&](std::size_t i) {
    const std::string& name = certificate.names[certificate.level[i]];
    if (name == "v") return std::string("t");
    if (name.size() > 2 && name.compare(0, 2, "v_") == 0) return name.substr(2);
    return "theta_" + name;
  };
  const std::string name = short_name(level_index);
  for (std::size_t i = 0; i < certificate.level.size(); ++i) {
    const bool clash = i != level_index && short_name(i) == name;
    if (clash || name == "x" || name == "exp") return "theta_" + certificate.names[certificate.level[level_index]];
  }
  return name;
}

std::string text_of(const Space& space, const Certificate& certificate) {
  std::vector<const Exponential*> parts;
  for (const Exponential& part : space) parts.push_back(&part);
  const auto key = [](const Exponential* part) {  // 1 first, then each frequency before its opposite
    std::vector<long> size, sign;
    long total = 0;
    for (const long n : part->frequency) total += std::labs(n), size.push_back(-std::labs(n)), sign.push_back(-n);
    return std::tuple(total, size, sign);
  };
  std::sort(parts.begin(), parts.end(), [&](const auto* a, const auto* b) { return key(a) < key(b); });
  std::string text;
  for (const Exponential* part : parts) {
    const std::string exponential = exponent_text(part->frequency, certificate);
    for (long power = 0; power < part->order; ++power) {
      if (!text.empty()) text += ", ";
      if (part->order > 8 && power == 2) {
        text += "..., ";
        power = part->order - 1;
      }
      text += power_text(power, exponential);
    }
  }
  return "{" + text + "}";
}

}  // namespace twoscale::check
