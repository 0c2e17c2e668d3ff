// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/reports/status.hpp"

#include <algorithm>

#include "twoscale/analysis/prove.hpp"
#include "twoscale/analysis/regularity.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::reports {

namespace {

using Kind = StatusCell::Kind;
using analysis::Decision;
using analysis::Verdict;

struct Property {
  std::string title;
  std::vector<std::string> claims;  // what prove() calls it
  bool needs_symbol;                // a question about masks: not asked of other schemes, unless they decide it
};

const std::vector<Property>& properties() {
  static const std::vector<Property> list = {{"interpolatory", {"interpolatory"}, false},
                                             {"symmetric", {"symmetric"}, true},
                                             {"sum rules", {"sum-rules"}, true},
                                             {"generates", {"generates"}, true},
                                             {"reproduces", {"reproduces", "circle"}, false},
                                             {"maximal", {"maximal"}, true},
                                             {"well-defined", {"well-defined"}, true},
                                             {"smoothness", {"continuity"}, false}};
  return list;
}

bool has_symbol(const Scheme& s) { return s.block == 1 && is_uniform(s); }

bool claimed(const std::vector<Claim>& claims, const std::string& name) {
  return std::any_of(claims.begin(), claims.end(), [&](const Claim& c) { return c.name == name; });
}

// The claims of the source, and the same questions where it is silent. Smoothness of schemes with a symbol is found,
// not asked.
std::vector<Claim> questions(const Scheme& scheme) {
  if (!has_symbol(scheme)) return analysis::default_claims(scheme);
  std::vector<Claim> claims = scheme.claims;
  Scheme silent = scheme;
  silent.claims.clear();
  for (const Claim& c : analysis::default_claims(silent))
    if (!claimed(claims, c.name)) claims.push_back(c);
  for (const char* name : {"interpolatory", "symmetric"})
    if (!claimed(claims, name)) claims.push_back({name, "", ""});
  claims.erase(std::remove_if(claims.begin(), claims.end(), [](const Claim& c) { return c.name == "continuity"; }),
               claims.end());
  return claims;
}

std::string detail(const Decision& d) {
  if (d.verdict == Verdict::undecided) return d.witness;
  if (d.claim == "continuity") return "C^" + (d.subject.empty() ? "0" : d.subject);
  if (d.claim == "sum-rules" && !d.subject.empty()) return "order " + d.subject;
  return d.subject;
}

Kind kind_of(Verdict v) {
  return v == Verdict::proved ? Kind::proved : v == Verdict::refuted ? Kind::refuted : Kind::undecided;
}

// Several claims: a refuted one counts, then an undecided one.
StatusCell combined(const std::vector<Decision>& decisions, const std::vector<std::string>& claims) {
  StatusCell cell{Kind::undecided, "nothing is claimed, and the prover does not ask"};
  const auto rank = [](Kind k) { return k == Kind::refuted ? 2 : k == Kind::undecided ? 1 : 0; };
  bool first = true;
  for (const Decision& d : decisions) {
    if (std::find(claims.begin(), claims.end(), d.claim) == claims.end()) continue;
    const Kind k = kind_of(d.verdict);
    if (first || rank(k) > rank(cell.kind)) cell = {k, detail(d)};
    first = false;
  }
  return cell;
}

// Of claims "C^l" the largest l proved and the least one refuted; below that it is asked until one is proved.
StatusCell smoothness(const Scheme& scheme, const std::vector<Decision>& decisions) {
  int proved = -1, refuted = -1;
  const auto take = [&](const std::vector<Decision>& list) {
    for (const Decision& d : list) {
      if (d.claim != "continuity") continue;
      const int l = d.subject.empty() ? 0 : std::stoi(d.subject);
      if (d.verdict == Verdict::proved) proved = std::max(proved, l);
      if (d.verdict == Verdict::refuted) refuted = refuted < 0 ? l : std::min(refuted, l);
    }
  };
  take(decisions);
  for (int l = refuted - 1; proved < 0 && l >= 0; --l)
    take(analysis::prove(scheme, {{"continuity", std::to_string(l), ""}}).decisions);
  if (proved < 0) return combined(decisions, {"continuity"});
  return {Kind::proved, "C^" + std::to_string(proved) + (refuted < 0 ? "" : ", not C^" + std::to_string(refuted))};
}

StatusCell smoothness(const Scheme& scheme) {
  try {
    const analysis::Regularity r = analysis::regularity(with_default_values(scheme), {});
    if (!r.obstacle.empty()) return {Kind::undecided, r.obstacle};
    if (r.level_dependent && !r.transferred) return {Kind::undecided, "of the limit mask only"};
    if (r.continuity < 0) return {Kind::undecided, "not proved to be continuous"};
    return {Kind::proved, "C^" + std::to_string(r.continuity)};
  } catch (const Error& e) {
    if (e.kind == Error::Kind::io) throw;
    return {Kind::undecided, e.what()};
  }
}

}  // namespace

std::string to_string(Kind kind) {
  switch (kind) {
    case Kind::proved: return "proved";
    case Kind::refuted: return "refuted";
    case Kind::undecided: return "undecided";
    case Kind::not_applicable: break;
  }
  return "–";
}

const std::vector<std::string>& status_properties() {
  static const std::vector<std::string> titles = [] {
    std::vector<std::string> list;
    for (const Property& p : properties()) list.push_back(p.title);
    return list;
  }();
  return titles;
}

StatusRow status_of(const std::string& name) {
  const Scheme scheme = make_scheme(name);
  StatusRow row{name, scheme.source, {}};
  std::vector<Decision> decisions;
  std::string refusal;
  try {
    decisions = analysis::prove(scheme, questions(scheme)).decisions;
  } catch (const Error& e) {
    if (e.kind == Error::Kind::io) throw;
    refusal = e.what();
  }
  for (const Property& p : properties()) {
    const bool decided = std::any_of(decisions.begin(), decisions.end(), [&](const Decision& d) {
      return std::find(p.claims.begin(), p.claims.end(), d.claim) != p.claims.end();
    });
    if (p.needs_symbol && !has_symbol(scheme) && !decided)
      row.cells.push_back({});
    else if (p.claims[0] == "continuity" && has_symbol(scheme))
      row.cells.push_back(smoothness(scheme));
    else if (!refusal.empty())
      row.cells.push_back({Kind::undecided, refusal});
    else
      row.cells.push_back(p.claims[0] == "continuity" ? smoothness(scheme, decisions) : combined(decisions, p.claims));
  }
  return row;
}

std::vector<StatusRow> status_matrix(bool every_example, const std::function<void(const std::string&)>& progress) {
  std::vector<StatusRow> rows;
  for (const CatalogEntry& entry : catalog())
    for (const std::string& name : entry.examples) {
      if (!every_example && &name != &entry.examples[0]) continue;
      if (progress) progress("status of " + name);
      rows.push_back(status_of(name));
    }
  return rows;
}

std::string to_markdown(const std::vector<StatusRow>& rows) {
  std::string head = "| scheme |", line = "| --- |";
  for (const auto& p : status_properties()) {
    head += " " + p + " |";
    line += " --- |";
  }
  std::string s = head + "\n" + line + "\n";
  for (const StatusRow& row : rows) {
    s += "| `" + row.scheme + "` |";
    for (const StatusCell& c : row.cells) {
      const bool brief = c.detail.starts_with("C^") || c.detail.starts_with("order ");
      s += " " + to_string(c.kind) + (brief ? ": " + c.detail : "") + " |";
    }
    s += "\n";
  }
  return s;
}

}  // namespace twoscale::reports
