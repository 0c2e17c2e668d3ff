// SPDX-License-Identifier: GPL-3.0-or-later
// Results for people (text, Markdown) and for programs (JSON).
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "twoscale/reports/audit.hpp"

namespace twoscale::reports::audit {

namespace {

constexpr std::array verdicts = {Verdict::holds, Verdict::corrected, Verdict::fails, Verdict::undecided};

std::map<Verdict, size_t> counts(const std::vector<Audited>& list) {
  std::map<Verdict, size_t> result;
  for (const Audited& a : list) ++result[a.result.verdict];
  return result;
}

std::string count_text(const std::vector<Audited>& list) {
  auto count = counts(list);
  std::string text = std::to_string(list.size()) + " items:";
  const char* separator = " ";
  for (const Verdict v : verdicts) {
    text += separator + std::to_string(count[v]) + " " +
            (v == Verdict::holds   ? "hold"
             : v == Verdict::fails ? "fail"
                                   : to_string(v));
    separator = ", ";
  }
  return text;
}

std::vector<std::string> papers_in(const std::vector<Audited>& list) {
  std::vector<std::string> names;
  for (const Audited& a : list)
    if (names.empty() || names.back() != a.item.paper) names.push_back(a.item.paper);
  return names;
}

std::string escaped(std::string text) {
  std::string result;
  for (const char c : text) {
    if (c == '*' || c == '_' || c == '<' || c == '|' || c == '[' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

}  // namespace

std::string to_text(const std::vector<Audited>& list) {
  std::ostringstream out;
  for (const std::string& paper : papers_in(list)) {
    out << paper << "\n";
    for (const auto& [item, result] : list) {
      if (item.paper != paper) continue;
      const std::string verdict = to_string(result.verdict);
      out << "  " << verdict << std::string(11 - verdict.size(), ' ') << item.equation << "  " << item.statement
          << "\n";
      if (result.verdict == Verdict::holds) continue;
      const char* indent = "               ";
      out << indent << (result.verdict == Verdict::undecided ? "reason: " : "shown by: ") << result.evidence << "\n";
      if (result.verdict == Verdict::corrected)
        out << indent << "right is: " << result.correction << "\n" << indent << "proof: " << result.proof << "\n";
      if (!item.why.empty()) out << indent << "(" << item.why << ")\n";
    }
  }
  out << count_text(list) << "\n";
  return out.str();
}

std::string to_json(const std::vector<Audited>& list) {
  using Json = nlohmann::ordered_json;
  Json j;
  j["format"] = "twoscale/audit";
  j["version"] = 1;
  j["scheme"] = nullptr;
  Json items = Json::array();
  for (const auto& [item, result] : list) {
    Json i;
    i["paper"] = item.paper;
    i["equation"] = item.equation;
    i["statement"] = item.statement;
    i["verdict"] = to_string(result.verdict);
    i["correction"] = result.verdict == Verdict::corrected ? Json(result.correction) : Json(nullptr);
    i["evidence"] = result.evidence;
    i["proof"] = result.verdict == Verdict::corrected ? Json(result.proof) : Json(nullptr);
    i["decider"] = item.decider;
    i["remark"] = item.why.empty() ? Json(nullptr) : Json(item.why);
    items.push_back(std::move(i));
  }
  j["items"] = std::move(items);
  auto count = counts(list);
  for (const Verdict v : verdicts) j["counts"][to_string(v)] = count[v];
  return j.dump(1) + "\n";
}

std::string to_markdown(const std::vector<Audited>& list) {
  std::ostringstream out;
  out << "# Errata\n\n" << count_text(list) << ".\n";
  for (const std::string& paper : papers_in(list)) {
    out << "\n## " << paper << "\n";
    size_t holding = 0;
    for (const auto& [item, result] : list) {
      if (item.paper != paper) continue;
      if (result.verdict == Verdict::holds) ++holding;
      if (result.verdict != Verdict::fails && result.verdict != Verdict::corrected) continue;
      out << "\n**" << escaped(item.equation) << "** (" << to_string(result.verdict) << "). " << escaped(item.statement)
          << "\n\n";
      if (result.verdict == Verdict::corrected) out << "- Right is: " << escaped(result.correction) << "\n";
      out << "- As printed: " << escaped(result.evidence) << "\n";
      if (result.verdict == Verdict::corrected) out << "- Corrected: " << escaped(result.proof) << "\n";
      if (!item.why.empty()) out << "- " << escaped(item.why) << "\n";
    }
    bool heading = false;
    for (const auto& [item, result] : list) {
      if (item.paper != paper || result.verdict != Verdict::undecided) continue;
      if (!heading) out << "\nUndecided:\n\n";
      heading = true;
      out << "- " << escaped(item.equation) << ": " << escaped(item.statement) << " " << escaped(result.evidence)
          << "\n";
    }
    out << "\n" << holding << " items hold.\n";
  }
  return out.str();
}

}  // namespace twoscale::reports::audit
