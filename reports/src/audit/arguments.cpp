// SPDX-License-Identifier: GPL-3.0-or-later
#include "audit/arguments.hpp"

#include <optional>

#include "twoscale/symbolic/error.hpp"

namespace twoscale::reports::audit {

using Answer = analysis::Verdict;

const std::vector<std::string>& list_at(const Arguments& a, const std::string& key) {
  static const std::vector<std::string> none;
  const auto at = a.find(key);
  return at == a.end() ? none : at->second;
}

const std::string& text_at(const Arguments& a, const std::string& key) {
  const auto& list = list_at(a, key);
  if (list.size() != 1) bad_input("one value is expected for the key", key);
  return list[0];
}

std::string joined(const std::vector<std::string>& list, const std::string& separator) {
  std::string text;
  for (const auto& s : list) text += (text.empty() ? "" : separator) + s;
  return text;
}

Outcome over_cases(const Arguments& a, const std::function<Outcome(const Counters&)>& one) {
  Outcome last{Answer::proved, ""};
  std::optional<Outcome> open;
  const std::vector<std::string>& cases = list_at(a, "cases");
  for (const Counters& c : all_cases(cases)) {
    Outcome o = one(c);
    if (!cases.empty() && o.verdict != Answer::proved) o.evidence = case_text(c) + ": " + o.evidence;
    if (o.verdict == Answer::refuted) return o;
    if (o.verdict == Answer::undecided && !open) open = o;
    last = o;
  }
  if (open) return *open;
  if (!cases.empty()) last.evidence = "in each case " + joined(cases, ", ") + ": " + last.evidence;
  return last;
}

}  // namespace twoscale::reports::audit
