// SPDX-License-Identifier: GPL-3.0-or-later
#include "audit/section.hpp"

#include <fmt/format.h>

#include <map>

#include "twoscale/reports/audit.hpp"
#include "twoscale/reports/html.hpp"

namespace twoscale::reports {

namespace {

std::string small(const std::string& text) {
  return text.empty() ? "" : "<br/><span class=\"small\">" + escaped(text) + "</span>";
}

}  // namespace

Section audit_section(const std::string& paper) {
  using audit::Verdict;
  Section section{"audit", "Errata", "Its formulas and claims, decided one by one", {}};
  Part& part = section.part;
  part.numbers = nlohmann::ordered_json::array();
  std::string rows;
  std::map<Verdict, int> count;
  for (const audit::Item& item : audit::items_of(paper)) {
    const audit::Result r = audit::audit(item);
    ++count[r.verdict];
    part.numbers.push_back({{"equation", item.equation}, {"verdict", to_string(r.verdict)}});
    if (r.verdict == Verdict::holds || r.verdict == Verdict::undecided) continue;
    rows += "<tr><td>" + escaped(item.equation) + "</td><td>" + escaped(item.statement) + small(r.evidence) +
            "</td><td>" + (r.correction.empty() ? "–" : escaped(r.correction)) + small(r.proof) + "</td></tr>\n";
  }
  const int wrong = count[Verdict::fails] + count[Verdict::corrected];
  const int all = wrong + count[Verdict::holds] + count[Verdict::undecided];
  part.html = fmt::format(
      "<p>{} statements hold, {} are wrong as printed, {} are out of reach (judgements, what is not in the "
      "paper).</p>\n",
      count[Verdict::holds], wrong, count[Verdict::undecided]);
  if (wrong > 0)
    part.html +=
        "<table><thead><tr><th>place</th><th>as printed, and what shows that it is wrong</th><th>right is, and why"
        "</th></tr></thead><tbody>\n" +
        rows + "</tbody></table>\n";
  part.html += commands_html({"twoscale audit " + paper});
  if (wrong > 0)
    part.findings.push_back(fmt::format(
        "{} of {} statements are wrong as printed; {} have a proved correction (<a href=\"#audit\">table</a>).", wrong,
        all, count[Verdict::corrected] == wrong ? std::string("all") : std::to_string(count[Verdict::corrected])));
  return section;
}

}  // namespace twoscale::reports
