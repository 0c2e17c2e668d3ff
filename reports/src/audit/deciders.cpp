// SPDX-License-Identifier: GPL-3.0-or-later
// The deciders: each turns the arguments of an item into a question to one prover of the library.
#include <algorithm>
#include <set>

#include "audit/arguments.hpp"
#include "audit/formula.hpp"
#include "twoscale/analysis/parameter_range.hpp"
#include "twoscale/analysis/positivity.hpp"
#include "twoscale/analysis/prove.hpp"
#include "twoscale/reports/audit.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::reports::audit {

namespace {

using analysis::Box;
using analysis::Decision;
using Answer = analysis::Verdict;

std::string short_text(const RationalFunction& f) {
  std::string text = f.to_string();
  return text.size() <= 160 ? text : text.substr(0, 150) + "... (" + std::to_string(text.size()) + " characters)";
}

// A small rational point where f is defined and not 0. Required: f is not the zero function.
std::vector<std::pair<std::string, Rational>> point_off(const RationalFunction& f) {
  const std::vector<std::string> names = f.variables();
  std::vector<std::pair<std::string, Rational>> point;
  for (const auto& name : names) point.emplace_back(name, Rational(static_cast<long>(2 + point.size())));
  const auto good = [&] {
    const auto at = f.evaluate(point);
    return at && !at->is_zero();
  };
  if (good()) return point;
  // All points of the grids {2..n}^k, n = 3, 4, ..: on a large one no polynomial but 0 vanishes.
  for (long n = 3;; ++n) {
    std::vector<long> digits(names.size(), 2);
    for (;;) {
      for (size_t i = 0; i < names.size(); ++i) point[i].second = Rational(digits[i]);
      if (good()) return point;
      size_t i = 0;
      while (i < digits.size() && digits[i] == n) digits[i++] = 2;
      if (i == digits.size()) break;
      ++digits[i];
    }
  }
}

std::string point_text(const std::vector<std::pair<std::string, Rational>>& point) {
  std::string text;
  for (const auto& [name, value] : point) text += (text.empty() ? "at " : ", ") + name + " = " + value.to_string();
  return text;
}

// ---- identity, differs

Outcome compare(const Formulas& formulas, const std::string& left, const std::string& right) {
  const RationalFunction l = formulas(left), r = formulas(right), d = l - r;
  if (d.is_zero()) {
    const std::string variables = joined(l.variables(), ", ");
    return {Answer::proved,
            "both sides are " + short_text(l) + (variables.empty() ? "" : ", identically in " + variables)};
  }
  std::string evidence = "left - right = " + short_text(d);
  if (!d.constant()) {
    const auto point = point_off(d);
    evidence += "; " + point_text(point) + " it is " + d.evaluate(point)->to_string();
  }
  return {Answer::refuted, evidence};
}

Outcome identity(const Arguments& a) {
  return over_cases(a, [&](const Counters& c) {
    const Formulas formulas(list_at(a, "let"), c);
    const auto &left = list_at(a, "left"), &right = list_at(a, "right");
    if (left.empty() || left.size() != right.size()) bad_input("left and right must be of one length, not", "left");
    Outcome last;
    for (size_t i = 0; i < left.size(); ++i) {
      last = compare(formulas, left[i], right[i]);
      if (last.verdict != Answer::proved) break;
    }
    return last;
  });
}

Outcome differs(const Arguments& a) {
  return over_cases(a, [&](const Counters& c) {
    const Formulas formulas(list_at(a, "let"), c);
    Outcome o = compare(formulas, text_at(a, "left"), text_at(a, "right"));
    o.verdict = o.verdict == Answer::proved ? Answer::refuted : Answer::proved;
    return o;
  });
}

// ---- positive, square-root, decreasing

// "v>=0", "v in [1/2,3]".
Box box_of(const std::vector<std::string>& domain) {
  Box box;
  for (const std::string& text : domain) {
    if (const size_t at = text.find(">="); at != std::string::npos) {
      box.push_back({trimmed(text.substr(0, at)), Rational::parse(trimmed(text.substr(at + 2))), std::nullopt});
    } else if (const size_t in = text.find(" in ["); in != std::string::npos && text.back() == ']') {
      const auto ends = split_list(text.substr(in + 5, text.size() - in - 6));
      if (ends.size() != 2) bad_input("an interval [a,b] is expected in", text);
      box.push_back({trimmed(text.substr(0, in)), Rational::parse(ends[0]), Rational::parse(ends[1])});
    } else {
      bad_input("a range 'x>=a' or 'x in [a,b]' is expected, not", text);
    }
  }
  return box;
}

Outcome sign(const RationalFunction& f, const Arguments& a, bool strict) {
  analysis::SignOptions options;
  options.strict = strict;
  options.zeros = strict ? list_at(a, "zeros") : std::vector<std::string>{};
  const auto s = decide_sign(f, box_of(list_at(a, "domain")), options);
  if (s.verdict == Answer::proved)
    return {s.verdict, short_text(f) + (strict ? " > 0" : " >= 0") + " for " + joined(list_at(a, "domain"), ", ")};
  if (s.verdict == Answer::undecided) return {s.verdict, s.reason};
  std::string evidence = short_text(f) + " is ";
  if (s.point) return {s.verdict, evidence + s.value.to_string() + " " + point_text(*s.point)};
  return {s.verdict, evidence + "not positive throughout " + joined(list_at(a, "domain"), ", ")};
}

Outcome positive(const Arguments& a) {
  return over_cases(a, [&](const Counters& c) {
    const Formulas formulas(list_at(a, "let"), c);
    return sign(formulas(text_at(a, "expression")), a, list_at(a, "or_zero").empty());
  });
}

// root = sqrt(radicand) on the domain: root^2 is the radicand, and root is not negative.
Outcome square_root(const Arguments& a) {
  return over_cases(a, [&](const Counters& c) {
    const Formulas formulas(list_at(a, "let"), c);
    const RationalFunction root = formulas(text_at(a, "root")), radicand = formulas(text_at(a, "radicand"));
    const RationalFunction d = root * root - radicand;
    if (!d.is_zero()) {
      std::string evidence = "(root)^2 - radicand = " + short_text(d);
      if (!d.constant()) {
        const auto point = point_off(d);
        evidence += "; " + point_text(point) + " it is " + d.evaluate(point)->to_string();
      }
      return Outcome{Answer::refuted, evidence};
    }
    Outcome o = sign(root, a, false);
    if (o.verdict == Answer::proved) o.evidence = "(root)^2 is the radicand, and " + o.evidence;
    return o;
  });
}

RationalFunction derivative(const RationalFunction& f, const std::string& name) {
  const RationalFunction n = f.numerator(), d = f.denominator();
  return (RationalFunction(f.numerator().derivative(name)) * d -
          n * RationalFunction(f.denominator().derivative(name))) /
         (d * d);
}

// |expression| decreases along the one variable of the domain. A pole inside refutes: |expression| grows without bound.
Outcome decreasing(const Arguments& a) {
  return over_cases(a, [&](const Counters& c) {
    const Formulas formulas(list_at(a, "let"), c);
    const RationalFunction f = formulas(text_at(a, "expression"));
    const Box box = box_of(list_at(a, "domain"));
    if (box.size() != 1) bad_input("one variable is expected in", joined(list_at(a, "domain"), ", "));
    for (const auto& [factor, exponent] : f.denominator_factors()) {
      const auto zeros = analysis::isolate_zeros(factor, box[0].low, box[0].high);
      if (zeros.empty()) continue;
      const auto zero = analysis::refine_zero(factor, zeros[0], Rational(1, 64));
      return Outcome{Answer::refuted,
                     "|" + short_text(f) + "| grows without bound where " + factor.pretty() + " = 0, at " +
                         box[0].name + " " +
                         (zero.low == zero.high ? "= " + zero.low.to_string()
                                                : "in (" + zero.low.to_string() + ", " + zero.high.to_string() + ")") +
                         ", and is finite to the left of it"};
    }
    // d/dv f^2 = 2 f f' <= 0.
    Outcome o = sign(-(f * derivative(f, box[0].name)), a, false);
    if (o.verdict == Answer::proved)
      o.evidence = "|" + short_text(f) + "| decreases: -f f' >= 0 for " + joined(list_at(a, "domain"), ", ");
    else if (o.verdict == Answer::refuted)
      o.evidence = "f = " + short_text(f) + ", and -f f' = " + o.evidence;
    return o;
  });
}

// ---- claims

Claim claim_of(const std::string& text) {
  const size_t equals = text.find('=');
  Claim c;
  c.name = trimmed(text.substr(0, equals));
  if (equals != std::string::npos) c.subject = trimmed(text.substr(equals + 1));
  return c;
}

Scheme scheme_of(const Arguments& a, const Counters& c) {
  const Scheme s = make_scheme(expanded(text_at(a, "scheme"), c));
  std::vector<std::pair<std::string, RationalFunction>> values;
  for (const std::string& text : list_at(a, "at")) {
    const Claim value = claim_of(expanded(text, c));
    values.emplace_back(value.name, parse_rational_function(value.subject));
  }
  return values.empty() ? s : with_values(s, values);
}

Outcome claims(const Arguments& a) {
  return over_cases(a, [&](const Counters& c) {
    const Scheme s = scheme_of(a, c);
    std::string proved;
    std::optional<Outcome> open;
    for (const std::string& text : list_at(a, "claims")) {
      std::string wanted = expanded(text, c);
      const bool negated = wanted.rfind("not ", 0) == 0;
      if (negated) wanted = wanted.substr(4);
      const Decision d = analysis::prove(s, {claim_of(wanted)}).decisions.at(0);
      const std::string subject = d.claim + (d.subject.empty() ? "" : " {" + d.subject + "}");
      if (d.verdict == Answer::undecided) {
        if (!open) open = Outcome{d.verdict, subject + ": " + d.witness};
      } else if ((d.verdict == Answer::proved) == negated) {
        return Outcome{Answer::refuted,
                       s.id + ": " + subject + (negated ? " is proved for " + d.domain : " is refuted: " + d.witness)};
      } else {
        proved += (proved.empty() ? "" : "; ") +
                  (negated ? "not " + subject + ": " + d.witness
                           : subject + " for " + d.domain +
                                 (d.exceptions.empty() ? "" : " except " + joined(d.exceptions, ", ")));
      }
    }
    return open ? *open : Outcome{Answer::proved, s.id + ": " + proved};
  });
}

// The start values for which some step fails are exactly those listed.
Outcome well_defined(const Arguments& a) {
  return over_cases(a, [&](const Counters& c) {
    const Scheme s = scheme_of(a, c);
    const Decision d = analysis::prove(s, {{"well-defined", "", ""}}).decisions.at(0);
    if (d.verdict == Answer::undecided) return Outcome{d.verdict, d.witness};
    std::set<std::string> expected, found;
    for (const std::string& e : list_at(a, "except")) expected.insert(expanded(e, c));
    for (const std::string& e : d.exceptions) found.insert(e);
    const std::string list =
        d.exceptions.empty() ? "every step is defined" : "a step fails for " + joined(d.exceptions, ", ");
    return Outcome{expected == found ? Answer::proved : Answer::refuted, s.id + ": " + list};
  });
}

// ---- numbers

Outcome numbers(const Arguments& a) {
  return over_cases(a, [&](const Counters& c) {
    std::string shown;
    for (const std::string& raw : list_at(a, "relations")) {
      const std::string text = expanded(raw, c);
      const size_t at = text.find_first_of("=<");
      if (at == std::string::npos) bad_input("a relation A = B or A < B is expected, not", text);
      const ExactReal left = parse_real(text.substr(0, at)), right = parse_real(text.substr(at + 1));
      // Symbolically first: balls never show that 4*(pi/2) - 2*pi is 0.
      Symbols symbols;
      const GiNaC::ex d =
          parse_expression(text.substr(at + 1), symbols) - parse_expression(text.substr(0, at), symbols);
      const Sign s = d.expand().is_zero() ? Sign::zero : (right - left).sign();
      if (s == Sign::unknown) return Outcome{Answer::undecided, "no sign found for " + text};
      if ((text[at] == '=') != (s == Sign::zero) || (text[at] == '<' && s != Sign::positive))
        return Outcome{Answer::refuted, trimmed(text.substr(0, at)) + " = " + left.decimal(12) + ", " +
                                            trimmed(text.substr(at + 1)) + " = " + right.decimal(12)};
      shown += (shown.empty() ? "" : ", ") + text;
    }
    return Outcome{Answer::proved, shown};
  });
}

// ---- radius

// rho = centre + sqrt(square) on a range, from the polynomial in the parameter and x that it is the larger zero of.
struct Branch {
  RationalFunction centre, square;
};
std::optional<Branch> branch(const Polynomial& p, const std::string& x) {
  std::vector<RationalFunction> c;
  RationalFunction rest = p;
  for (long i = 0; i <= p.degree(x); ++i) {
    c.push_back(rest.substitute(x, 0));
    rest = (rest - c.back()) / RationalFunction::variable(x);
  }
  if (c.size() == 2) return Branch{-c[0] / c[1], 0};
  if (c.size() != 3) return std::nullopt;
  const RationalFunction centre = -c[1] / (RationalFunction(2) * c[2]);
  return Branch{centre, centre * centre - c[0] / c[2]};
}

// lower <= rho <= upper, or rho = equal, on [from, to], for the joint spectral radius rho along the parameter.
Outcome radius(const Arguments& a) {
  return over_cases(a, [&](const Counters& c) {
    const Scheme s = scheme_of(a, c);
    const Formulas formulas({}, c);
    const std::string name = text_at(a, "parameter");
    const Rational from = Rational::parse(expanded(text_at(a, "from"), c)),
                   to = Rational::parse(expanded(text_at(a, "to"), c));
    analysis::ParameterOptions options;
    options.samples = 2;
    options.resolution = Rational(1, 4);  // of the smoothness ranges, which are not looked at
    const auto range = parameter_range(s, name, from, to, options);
    Rational covered = from;
    std::string shown;
    for (const auto& r : range.radius) {
      const auto low = r.interval.from.rational(), high = r.interval.to.rational();
      const auto b = r.expression.empty() ? std::nullopt : branch(r.polynomial, "x");
      if (!low || !high || !b || *low != covered)
        return Outcome{Answer::undecided, "no closed form from " + name + " = " + covered.to_string() + " on"};
      covered = *high;
      shown += (shown.empty() ? "rho = " : "; rho = ") + r.expression + " on [" + low->to_string() + ", " +
               high->to_string() + "]";
      if (!list_at(a, "equal").empty()) {
        const RationalFunction d = formulas(text_at(a, "equal")) - b->centre;
        if (!(d * d == b->square)) return Outcome{Answer::refuted, shown};
      }
      Arguments domain;
      domain["domain"] = {name + " in [" + low->to_string() + "," + high->to_string() + "]"};
      // bound - centre >= sqrt(square) for the upper bound; for the lower one it is negative or its square is smaller.
      for (const char* side : {"upper", "lower"}) {
        if (list_at(a, side).empty()) continue;
        const RationalFunction d = formulas(text_at(a, side)) - b->centre;
        const bool upper = std::string(side) == "upper";
        const Outcome first = sign(upper ? d : -d, domain, false);
        const Outcome squares = sign(upper ? d * d - b->square : b->square - d * d, domain, false);
        const bool ok = upper ? first.verdict == Answer::proved && squares.verdict == Answer::proved
                              : first.verdict == Answer::proved || squares.verdict == Answer::proved;
        if (!ok) return Outcome{Answer::refuted, shown + "; " + side + " bound: " + squares.evidence};
      }
    }
    if (covered != to)
      return Outcome{Answer::undecided, "no closed form from " + name + " = " + covered.to_string() + " on"};
    return Outcome{Answer::proved, shown};
  });
}

// C^l for all values of the parameter strictly between `from` and `to` but those of `except`.
Outcome smooth_between(const Arguments& a) {
  return over_cases(a, [&](const Counters& c) {
    const Scheme s = scheme_of(a, c);
    const std::string name = text_at(a, "parameter");
    const Rational from = Rational::parse(expanded(text_at(a, "from"), c)),
                   to = Rational::parse(expanded(text_at(a, "to"), c));
    const long l = integer(text_at(a, "order"), c);
    analysis::ParameterOptions options;
    options.samples = 2;
    const auto range = parameter_range(s, name, from, to, options);
    for (const auto& r : range.continuity) {
      if (r.l != l) continue;
      for (const auto& i : r.refuted)
        if (analysis::RealAlgebraic::compare(i.from, i.to) < 0 || !list_at(a, "closed").empty())
          return Outcome{Answer::refuted, "rho >= 2^" + std::to_string(range.order - l) + " from " + name + " = " +
                                              i.from.expression().value_or("?") + " to " +
                                              i.to.expression().value_or("?")};
      for (const auto& i : r.proved) {
        const auto low = i.from.rational(), high = i.to.rational();
        if (low && high && *low == from && *high == to)
          return Outcome{Answer::proved, "C^" + std::to_string(l) + " for " + name + " between " + from.to_string() +
                                             " and " + to.to_string()};
      }
    }
    return Outcome{Answer::undecided, "C^" + std::to_string(l) + " is not decided on the whole range"};
  });
}

// ---- exponent

Outcome exponent(const Arguments& a) {
  return over_cases(a, [&](const Counters& c) {
    const Scheme s = scheme_of(a, c);
    const auto r = analysis::regularity(s, {});
    const ExactReal printed = parse_real(expanded(text_at(a, "exponent"), c));
    if (!r.hoelder.rational && !r.hoelder.expression)
      return Outcome{Answer::undecided, "the exponent is enclosed only"};
    if (r.hoelder.rho) return Outcome{Answer::undecided, "the exponent has no closed form: " + *r.hoelder.expression};
    const ExactReal exact = r.hoelder.rational ? ExactReal(*r.hoelder.rational) : parse_real(*r.hoelder.expression);
    const std::string text =
        s.id + ": Hölder exponent " + (r.hoelder.rational ? r.hoelder.rational->to_string() : *r.hoelder.expression);
    const Sign d = (exact - printed).sign(4096);
    // Logarithms: a zero is not proved by balls; the same expression is the same number.
    const bool same =
        d == Sign::zero || (r.hoelder.expression && *r.hoelder.expression == expanded(text_at(a, "exponent"), c));
    if (same && !list_at(a, "attained").empty()) {
      const std::string& wanted = text_at(a, "attained");
      if (wanted != "yes" && wanted != "no") bad_input("attained: yes or no is expected, not", wanted);
      if (!r.attained) return Outcome{Answer::undecided, text + "; whether it is attained is not known"};
      return Outcome{*r.attained == (wanted == "yes") ? Answer::proved : Answer::refuted,
                     text + (*r.attained ? ", attained" : ", not attained")};
    }
    if (same) return Outcome{Answer::proved, text};
    if (d == Sign::unknown) return Outcome{Answer::undecided, text + "; equality with the printed one is not decided"};
    return Outcome{Answer::refuted, text};
  });
}

Outcome not_decided(const Arguments& a) { return {Answer::undecided, text_at(a, "reason")}; }

}  // namespace

const std::vector<Decider>& deciders() {
  static const std::vector<Decider> all = {
      {"identity",
       "left = right as rational functions (lists: entry by entry)",
       {"let", "left", "right", "cases"},
       {"left", "right"},
       identity},
      {"differs",
       "left and right are different functions",
       {"let", "left", "right", "cases"},
       {"left", "right"},
       differs},
      {"positive",
       "expression > 0 on a box (or_zero: >= 0; zeros: faces where only >= 0 is claimed)",
       {"let", "expression", "domain", "zeros", "or_zero", "cases"},
       {"expression"},
       positive},
      {"square-root",
       "root = sqrt(radicand) on a box",
       {"let", "root", "radicand", "domain", "cases"},
       {"root", "radicand"},
       square_root},
      {"decreasing",
       "|expression| decreases on an interval",
       {"let", "expression", "domain", "cases"},
       {"expression"},
       decreasing},
      {"claims",
       "what `twoscale prove` decides of a scheme ('not CLAIM': is refuted)",
       {"scheme", "at", "claims", "cases"},
       {"claims"},
       claims},
      {"well-defined",
       "the start values for which some step fails are exactly `except`",
       {"scheme", "at", "except", "cases"},
       {"except"},
       well_defined},
      {"numbers", "relations A = B, A < B of constants", {"relations", "cases"}, {"relations"}, numbers},
      {"radius",
       "lower <= rho <= upper or rho = equal for the joint spectral radius along a parameter",
       {"scheme", "at", "parameter", "from", "to", "lower", "upper", "equal", "cases"},
       {"lower", "upper", "equal"},
       radius},
      {"smooth-between",
       "C^order for every parameter between from and to (closed: ends too)",
       {"scheme", "at", "parameter", "from", "to", "order", "closed", "cases"},
       {"order"},
       smooth_between},
      {"exponent",
       "the exact Hölder exponent (attained: yes, the limits are in its class; no, in those below only)",
       {"scheme", "at", "exponent", "attained", "cases"},
       {"exponent"},
       exponent},
      {"junction",
       "eigenvalues of schemes on knots: all but 1, .., 2^-order are smaller than 2^-order, for all parameters but "
       "`except`, or at the points `at`",
       {"scheme", "order", "except", "at", "cases"},
       {"order", "except", "at"},
       decide_at_junctions},
      {"eigenvalues",
       "the local matrix of a scheme on knots has these eigenvalues, with algebraic and geometric multiplicity",
       {"scheme", "alpha", "left", "right", "eigenvalues", "cases"},
       {"eigenvalues"},
       decide_eigenvalues},
      {"not-decided", "outside of what the provers decide, and why", {"reason"}, {}, not_decided},
  };
  return all;
}

const Decider& decider(const std::string& name) {
  for (const Decider& d : deciders())
    if (d.name == name) return d;
  bad_input("there is no decider", name);
}

Outcome decide(const std::string& decider_name, const Arguments& arguments) {
  const Decider& d = decider(decider_name);
  for (const auto& [key, value] : arguments)
    if (std::find(d.keys.begin(), d.keys.end(), key) == d.keys.end())
      bad_input("the decider " + d.name + " has no key", key);
  return d.decide(arguments);
}

}  // namespace twoscale::reports::audit
