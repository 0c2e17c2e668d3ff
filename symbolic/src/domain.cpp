// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/symbolic/domain.hpp"

#include <utility>

#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale {

namespace {

std::optional<Rational> end_of(const std::string& text, const char* infinity, std::string_view whole) {
  if (text == infinity || (text == "+inf" && infinity[0] != '-')) return std::nullopt;
  std::optional<Rational> value;
  try {
    value = parse_rational_function(text).constant();
  } catch (const Error& e) {
    if (e.kind != Error::Kind::bad_input) throw;
  }
  if (!value)
    bad_input("not an interval: the ends are rational numbers, -inf or inf", std::string(whole.substr(0, 80)));
  return value;
}

// Sign of x - end.
int side(const ExactReal& x, const Rational& end) {
  switch ((x - ExactReal(end)).sign()) {
    case Sign::negative: return -1;
    case Sign::zero: return 0;
    case Sign::positive: return 1;
    case Sign::unknown: break;
  }
  throw Error(Error::Kind::undecided, "cannot tell a value from the end of its domain", end.to_string());
}

}  // namespace

Domain Domain::parse(std::string_view text) {
  const std::string s = trimmed(text);
  const auto refuse = [&] { bad_input("not an interval, such as [0, 1/8] or (-1, inf)", s.substr(0, 80)); };
  if (s.size() < 5 || (s.front() != '[' && s.front() != '(') || (s.back() != ']' && s.back() != ')')) refuse();
  const auto ends = split_list(std::string_view(s).substr(1, s.size() - 2));
  if (ends.size() != 2) refuse();
  Domain d;
  d.low = end_of(ends[0], "-inf", s);
  d.high = end_of(ends[1], "inf", s);
  d.low_included = s.front() == '[';
  d.high_included = s.back() == ']';
  if ((!d.low && d.low_included) || (!d.high && d.high_included))
    bad_input("not an interval: an infinite end takes a round bracket", s);
  if (d.low && d.high && *d.low >= *d.high) bad_input("not an interval: the first end must be the smaller one", s);
  return d;
}

std::string Domain::to_string() const {
  return (low_included ? "[" : "(") + (low ? low->to_string() : "-inf") + ", " + (high ? high->to_string() : "inf") +
         (high_included ? "]" : ")");
}

bool Domain::contains(const Rational& x) const {
  if (low && (x < *low || (x == *low && !low_included))) return false;
  return !high || x < *high || (x == *high && high_included);
}

bool Domain::contains(const ExactReal& x) const {
  if (const auto q = x.rational()) return contains(*q);
  if (low) {
    const int s = side(x, *low);
    if (s < 0 || (s == 0 && !low_included)) return false;
  }
  if (high) {
    const int s = side(x, *high);
    if (s > 0 || (s == 0 && !high_included)) return false;
  }
  return true;
}

Domain Domain::image(const Rational& scale, const Rational& offset) const {
  Domain d = *this;
  if (d.low) d.low = scale * *d.low + offset;
  if (d.high) d.high = scale * *d.high + offset;
  if (scale.sign() < 0) {
    std::swap(d.low, d.high);
    std::swap(d.low_included, d.high_included);
  }
  return d;
}

}  // namespace twoscale
