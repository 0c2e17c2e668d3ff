// SPDX-License-Identifier: GPL-3.0-or-later
// Room: the independent checker. From bytes to a report.
#include "twoscale/check/check.hpp"

#include "twoscale/check/claims.hpp"
#include "twoscale/check/theorems.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <exception>
#include <optional>
#include <variant>

namespace twoscale::check {
namespace {

struct Kind {
  std::string_view name;
  std::string_view theorem;  ///< the key that a claim of this kind must name; empty: it depends on the claim
  Finding (*of_mask)(const Context&, Fields&, bool);
  Finding (*of_family)(const FamilyContext&, Fields&, bool) = nullptr;
  Finding (*of_itself)(Meter&, Fields&, bool) = nullptr;  ///< states itself what it is about: in every document
  Finding (*of_rules)(const HermiteContext&, Fields&, bool) = nullptr;
};

constexpr std::array<Kind, 29> kinds{{
    {"interpolatory", "definition", check_interpolatory, nullptr, nullptr, check_hermite_interpolatory},
    {"symmetric", "definition", check_symmetric, nullptr, nullptr, check_reversal},
    {"sum-rules", "definition", check_sum_rules},
    {"generates", "generation-stepwise", check_generates},
    {"reproduces", "reproduction-stepwise", check_reproduces},
    {"maximal", "hurwitz-count", check_maximal},
    {"well-defined", "", check_well_defined},
    {"jsr-lower", "spectral-radius", check_jsr_lower, check_family_jsr_lower},
    {"jsr-upper", "invariant-polytope", check_jsr_upper, check_family_jsr_upper},
    {"jsr-exact", "invariant-polytope", check_jsr_exact, check_family_jsr_exact},
    {"nonnegative-symbol", "nonnegative-symbol", check_nonnegative_symbol},
    {"nonnegative-family", "nonnegative-symbol", check_nonnegative_family},
    {"jsr-lower-family", "spectral-radius", check_jsr_lower_family},
    {"jsr-family", "invariant-polytope", check_jsr_family},
    {"stability", "jia-wang", check_stability},
    {"nonstationary", "nonstationary", check_nonstationary},
    {"knots-reproduces", "definition", check_knots_reproduces},
    {"knots-support", "compact-support", check_knots_support},
    {"junction", "schur-cohn", check_junction},
    {"knots-continuity", "piecewise-uniform", check_knots_continuity},
    {"positivity", "", nullptr, nullptr, check_positivity},
    {"root-bound", "schur-cohn", nullptr, nullptr, check_root_bound},
    {"bezier-form", "hermite-interpolation", nullptr, nullptr, check_bezier_form},
    {"interpolant", "hermite-interpolation", nullptr, nullptr, nullptr, check_interpolant},
    {"circle", "hermite-interpolation", nullptr, nullptr, nullptr, check_circle},
    {"spectral", "definition", nullptr, nullptr, nullptr, check_spectral},
    {"halves", "definition", nullptr, nullptr, nullptr, check_halves},
    {"continuity", "hermite-halves", nullptr, nullptr, nullptr, check_hermite_continuity},
    {"curvature", "hermite-halves", nullptr, nullptr, nullptr, check_curvature},
}};

/// What the claims of this document are about.
using Subject = std::variant<Context, FamilyContext, HermiteContext, Standalone>;

std::string_view required_theorem(const Kind& kind, const Value& claim, const Subject& subject) {
  if (!kind.theorem.empty()) return kind.theorem;
  if (kind.of_itself != nullptr) return positivity_theorem(claim);
  const Context* context = std::get_if<Context>(&subject);
  const bool univariate =
      context == nullptr || context->certificate.names.empty() || context->certificate.single_level();
  return univariate ? "sturm" : "positive-coefficients";
}

bool is_about(const Kind& kind, const Subject& subject) {
  return kind.of_itself != nullptr || (std::holds_alternative<Context>(subject) && kind.of_mask != nullptr) ||
         (std::holds_alternative<FamilyContext>(subject) && kind.of_family != nullptr) ||
         (std::holds_alternative<HermiteContext>(subject) && kind.of_rules != nullptr);
}

Finding find(const Kind& kind, const Subject& subject, Meter& meter, Fields& fields, bool proved) {
  if (kind.of_itself != nullptr) return kind.of_itself(meter, fields, proved);
  if (const auto* context = std::get_if<Context>(&subject)) return kind.of_mask(*context, fields, proved);
  if (const auto* rules = std::get_if<HermiteContext>(&subject)) return kind.of_rules(*rules, fields, proved);
  return kind.of_family(std::get<FamilyContext>(subject), fields, proved);
}

static_assert(default_work == limits::work);

constexpr std::string_view tail_empty = "\n \"digest\": \"\"\n}\n";

/// Checks the spelling and the digest; returns the parsed document.
Value read_document(std::string_view text, Meter& meter) {
  if (text.size() > limits::file_bytes) throw Malformed("the file is larger than 64 MiB");
  meter.spend(20 * text.size());
  Value document = parse_json(text);
  if (canonical_json(document) != text) throw Malformed("the JSON text is not in its canonical form");
  return document;
}

void check_digest(std::string_view text, const std::string& claimed) {
  // The text is canonical and the digest its last member, so it ends with the digest, a quote and "\n}\n".
  const std::string_view end = "\"\n}\n";
  if (text.size() < end.size() + claimed.size() || !text.ends_with(std::string(claimed) + std::string(end))) {
    throw Malformed("digest: must be the last member");
  }
  std::string empty(text.substr(0, text.size() - end.size() - claimed.size()));
  empty += end;
  if (claimed != digest(empty)) throw Malformed("digest: does not belong to this text");
}

struct Trusted {
  std::vector<std::string_view> keys;
  void add(std::string_view key) {
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
  }
};

std::string head_line(const Certificate& certificate) {
  std::string text = "mask a_{" + std::to_string(certificate.mask.lowest) + ".." +
                     std::to_string(certificate.mask.highest()) + "}, arity " + std::to_string(certificate.arity) +
                     ", shift p = " + text_of(certificate.shift);
  for (std::size_t j = 0; j < certificate.level.size(); ++j) {
    text += ", " + certificate.names[certificate.level[j]] + " = cosh(" + frequency_name(certificate, j) + "/" +
            std::to_string(certificate.arity) + "^(k+1)) at the step k -> k+1";
  }
  for (const std::size_t c : certificate.constants) {
    const bool sequence =
        std::find(certificate.limits.begin(), certificate.limits.end(), c) != certificate.limits.end();
    text += ", " + certificate.names[c] + (sequence ? " a value for each level" : " constant");
  }
  return text;
}

std::string head_line(const HermiteRules& rules) {
  return "rules for vertices with " + std::to_string(rules.order) +
         " derivatives and a parameter s, new ones in the middle: s = tan(sigma/8) at the mean sigma";
}

std::string head_line(const Family& family) {
  const std::string size = std::to_string(family.matrices.front().size);
  return std::to_string(family.matrices.size()) + " matrices B_0, B_1, ... of size " + size + "x" + size;
}

void check_claim(const Value& value, std::size_t number, const Subject& subject, Meter& meter, Report& report,
                 Trusted& trusted) {
  const std::string where = "claims[" + std::to_string(number) + "]";
  Fields fields(value, where);
  const std::string& name = fields.take_string("claim");
  const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return k.name == name; });
  if (kind == kinds.end()) throw Malformed(fields.path("claim") + ": unknown claim \"" + name.substr(0, 40) + "\"");
  if (!is_about(*kind, subject)) {
    const std::string own = std::holds_alternative<Context>(subject)          ? "a mask"
                            : std::holds_alternative<FamilyContext>(subject)  ? "matrices"
                            : std::holds_alternative<HermiteContext>(subject) ? "rules of vertices with derivatives"
                                                                              : "what it states";
    throw Malformed(fields.path("claim") + ": \"" + name + "\" is a claim about " +
                    (kind->of_mask != nullptr ? "a mask" : "rules of vertices with derivatives") + ", not about " +
                    own);
  }
  const std::string& verdict = fields.take_string("verdict");
  if (verdict != "proved" && verdict != "refuted") {
    throw Malformed(fields.path("verdict") + ": \"proved\" or \"refuted\" is expected");
  }
  if (value.keys.back() != "theorem") throw Malformed(where + ".theorem: expected as the last member");
  const std::string& key = as_string(value.items.back(), where + ".theorem");
  const std::string_view required = required_theorem(*kind, value, subject);
  if (key != required) throw Malformed(where + ".theorem: \"" + std::string(required) + "\" is expected");
  try {
    const Finding finding = find(*kind, subject, meter, fields, verdict == "proved");
    fields.take("theorem");
    fields.done();
    std::string line = (verdict == "proved" ? "proved   " : "refuted  ") + name + " " + finding.subject + ": " +
                       finding.evidence + "; trusting";
    for (const std::string_view used : finding.trusted) {
      line += " [" + std::string(used) + "]";
      trusted.add(used);
    }
    if (finding.trusted.front() != "definition") {
      line += " (" + std::string(theorem(finding.trusted.front()).source) + ")";
    }
    report.lines.push_back(line);
  } catch (const Refused& refusal) {
    const std::string message =
        "claim " + std::to_string(number + 1) + " (" + name + ", " + verdict + "): " + refusal.what();
    report.lines.push_back("REFUSED  " + message);
    if (report.status == Report::valid) report.message = message;
    report.status = Report::invalid;
  }
}

void check_document(std::string_view text, Report& report, Meter& meter) {
  const Value document = read_document(text, meter);
  Fields fields(document, "");
  const Head head = read_head(fields, meter);
  const std::vector<Value>& claims = fields.take_array("claims");
  check_digest(text, fields.take_string("digest"));
  fields.done();
  if (claims.empty()) throw Malformed("claims: at least one is expected");
  if (claims.size() > limits::list_items) throw Malformed("claims: more than 4096");

  report.status = Report::valid;
  const Certificate* certificate = std::get_if<Certificate>(&head.subject);
  const Family* family = std::get_if<Family>(&head.subject);
  const HermiteRules* rules = std::get_if<HermiteRules>(&head.subject);
  report.lines.push_back("the label \"" + head.scheme + "\" is not checked: the claims are about " +
                         (certificate != nullptr ? "the mask in this file, whatever its name"
                          : family != nullptr    ? "the matrices in this file, whatever their name"
                          : rules != nullptr     ? "the rules in this file, whatever their name"
                                                 : "what they state"));
  std::optional<Identities> identities;
  RadiusBounds radius;
  HermiteFacts facts;
  KnotFacts knots;
  std::optional<Subject> subject;
  if (certificate != nullptr) {
    report.lines.push_back(head_line(*certificate));
    subject.emplace(Context{*certificate, identities.emplace(*certificate, meter), meter, radius, knots});
  } else if (family != nullptr) {
    report.lines.push_back(head_line(*family));
    subject.emplace(FamilyContext{*family, meter});
  } else if (rules != nullptr) {
    report.lines.push_back(head_line(*rules));
    subject.emplace(HermiteContext{*rules, meter, facts});
  } else {
    subject.emplace(Standalone{});
  }
  Trusted trusted;
  for (std::size_t i = 0; i < claims.size(); ++i) check_claim(claims[i], i, *subject, meter, report, trusted);
  for (const std::string_view key : trusted.keys) {
    const Theorem& t = theorem(key);
    report.lines.push_back("[" + std::string(t.key) + "] " + std::string(t.statement) + " (" + std::string(t.source) +
                           ")");
  }
  report.lines.push_back(report.status == Report::valid ? "valid: " + std::to_string(claims.size()) + " claim(s)"
                                                        : "invalid: " + report.message);
}

}  // namespace

Report check_text(std::string_view text, std::uint64_t work) {
  Report report;
  Meter meter(work);
  const auto malformed = [&](const std::string& message) {
    report.status = Report::malformed;
    report.lines.clear();
    report.message = message;
  };
  try {
    check_document(text, report, meter);
  } catch (const Malformed& error) {
    malformed(error.what());
  } catch (const std::exception& error) {  // memory, or an arithmetic limit of the integers
    malformed(std::string("the checker ran out of resources: ") + error.what());
  }
  report.work = work - meter.left();
  return report;
}

std::string digest(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3U;
  }
  std::string result = "fnv1a64:";
  for (int shift = 60; shift >= 0; shift -= 4) result += "0123456789abcdef"[(hash >> shift) & 15U];
  return result;
}

std::string sealed(std::string_view canonical_text_with_empty_digest) {
  std::string result(canonical_text_with_empty_digest);
  if (result.ends_with(tail_empty)) result.insert(result.size() - 4, digest(result));
  return result;
}

}  // namespace twoscale::check
