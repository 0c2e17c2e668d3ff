// SPDX-License-Identifier: GPL-3.0-or-later
// What the scheme is: its mask, rules, parameters, space and mask table.
#include <fmt/format.h>

#include "sections.hpp"
#include "twoscale/kernels/export/table_writer.hpp"
#include "twoscale/reports/derivation.hpp"
#include "twoscale/reports/html.hpp"

namespace twoscale::reports::scheme_page {

namespace {

constexpr unsigned table_levels = 6;

std::string identifier(const std::string& name) { return mathml(name); }

// f^{k+1}_{m j + s}
std::string fine_point(int arity, size_t phase) {
  std::string index = fmt::format("<mn>{}</mn><mi>j</mi>", arity);
  if (phase > 0) index += fmt::format("<mo>+</mo><mn>{}</mn>", phase);
  return "<msubsup><mi>f</mi><mrow>" + index + "</mrow><mrow><mi>k</mi><mo>+</mo><mn>1</mn></mrow></msubsup>";
}

std::string coarse_point(long offset) {
  std::string index = "<mi>j</mi>";
  if (offset != 0) index += fmt::format("<mo>{}</mo><mn>{}</mn>", offset > 0 ? "+" : "−", std::abs(offset));
  return "<msubsup><mi>f</mi><mrow>" + index + "</mrow><mi>k</mi></msubsup>";
}

std::string rule(const Scheme& s, const std::vector<Stencil>& phases, size_t phase) {
  std::string sum;
  const Stencil& stencil = phases[phase];
  for (size_t i = 0; i < stencil.blocks.size(); ++i) {
    const RationalFunction& c = stencil.blocks[i][0];
    if (c.is_zero()) continue;
    const std::string weight = c.is_one() ? ""
                                          : "<mrow><mo stretchy=\"false\">(</mo>" + mathml(c.to_string()) +
                                                "<mo stretchy=\"false\">)</mo></mrow>";
    sum += (sum.empty() ? "" : "<mo>+</mo>") + weight + coarse_point(stencil.lowest + static_cast<long>(i));
  }
  return "<p><math><mrow>" + fine_point(s.arity, phase) + "<mo>=</mo>" + (sum.empty() ? "<mn>0</mn>" : sum) +
         "</mrow></math></p>\n";
}

// Of a scheme on knots: a rule for each piece of its domain.
Part definition_on_knots(const Subject& s) {
  Part part;
  const auto rules = [&](const std::vector<Stencil>& phases) {
    std::string html;
    for (size_t r = 0; r < phases.size(); ++r) html += "<div class=\"wide\">" + rule(s.scheme, phases, r) + "</div>\n";
    return html;
  };
  part.html =
      "<p>Arity 2; the rule of the new vertex in the middle of the edge j depends on what belongs to the edges "
      "around it.</p>\n";
  for (const Piece& piece : s.scheme.pieces)
    part.html += "<details><summary>Where <math><mrow>" + mathml(piece.where.pretty()) +
                 "<mo>≥</mo><mn>0</mn></mrow></math></summary>\n" + rules(piece.phases) + "</details>\n";
  part.html += s.scheme.pieces.empty()
                   ? rules(s.scheme.phases)
                   : "<details><summary>Elsewhere</summary>\n" + rules(s.scheme.phases) + "</details>\n";
  part.html += commands_html({"twoscale show " + s.name});
  part.numbers = {{"arity", s.scheme.arity}, {"p", s.scheme.shift.to_string()}};
  return part;
}

// "knot intervals of the edges j−1 to j+1"
std::string local_text(const Parameter& p) {
  const auto edge = [](long offset) {
    return offset == 0 ? std::string("j") : fmt::format("j{}{}", offset < 0 ? "−" : "+", std::abs(offset));
  };
  const std::string edges = p.offsets.size() == 1
                                ? "the edge " + edge(p.offsets[0])
                                : "the edges " + edge(p.offsets.front()) + " to " + edge(p.offsets.back());
  return p.rest
             ? "edge parameter of " + edges + ", " + p.rest->to_string() + " at edges that touch no vertex of the data"
             : "knot interval of " + edges;
}

}  // namespace

Part definition(const Subject& s) {
  if (s.scheme.block > 1) return definition_on_vertices(s);
  if (!is_uniform(s.scheme)) return definition_on_knots(s);
  Part part;
  const Laurent a = symbol(s.scheme);
  part.html = fmt::format(
      "<p>Arity {}, support [{}, {}], the point j of level k belongs to (j + p)/{}<sup>k</sup> with p = {}; "
      "{}.</p>\n",
      s.scheme.arity, a.lowest(), a.highest(), s.scheme.arity, escaped(s.scheme.shift.to_string()),
      is_interpolatory(s.scheme) ? "interpolatory" : "approximating");
  for (size_t r = 0; r < s.scheme.phases.size(); ++r) part.html += rule(s.scheme, s.scheme.phases, r);
  std::string plain;
  part.html +=
      "<div class=\"wide\"><table class=\"narrow\"><thead><tr><th>i</th><th>a<sub>i</sub></th></tr></thead><tbody>\n";
  for (long i = a.lowest(); i <= a.highest(); ++i) {
    const std::string text = a.coefficient(i).to_string();
    part.html += fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", i, formula("", text));
    plain += fmt::format("a_{} = {}\n", i, text);
  }
  part.html += "</tbody></table></div>\n<details><summary>The same as text</summary><pre>" + escaped(plain) +
               "</pre></details>\n";
  if (const auto limit = limit_symbol(s.scheme); limit && !is_stationary(s.scheme)) {
    std::string list;
    for (const auto& c : limit->coefficients()) list += (list.empty() ? "" : "<mo>,</mo>") + mathml(c.to_string());
    part.html += "<p>Limit of the masks: <math><mrow>" + list + "</mrow></math></p>\n";
  }
  part.html += commands_html({"twoscale show " + s.name});
  part.numbers = {{"arity", s.scheme.arity}, {"p", s.scheme.shift.to_string()}, {"support", {a.lowest(), a.highest()}}};
  return part;
}

Part parameters(const Subject& s) {
  Part part;
  part.numbers = nlohmann::ordered_json::array();
  if (s.scheme.parameters.empty() && !s.scheme.space) return part;
  if (!s.scheme.parameters.empty()) {
    part.html +=
        "<table><thead><tr><th>name</th><th>what</th><th>domain</th><th>default</th><th></th></tr></thead><tbody>\n";
    for (const auto& p : s.scheme.parameters) {
      const bool level = p.scope == Parameter::Scope::level;
      const std::string what =
          level ? (p.frequency ? prose(meaning(p, s.scheme.arity)) + "; " : "") + escaped(recurrence(p, s.scheme.arity))
          : p.scope == Parameter::Scope::local ? (s.scheme.block > 1 ? "of the vertices" : local_text(p))
                                               : "constant";
      const std::string domain = p.domain ? p.domain->to_string() : level ? "v^0 > -1" : "";
      part.html += fmt::format("<tr><td><math>{}</math></td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                               identifier(p.name), what, prose(domain), escaped(p.default_value), escaped(p.help));
      part.numbers.push_back({{"name", p.name},
                              {"scope", level                                ? "level"
                                        : p.scope == Parameter::Scope::local ? "local"
                                                                             : "constant"}});
    }
    part.html += "</tbody></table>\n";
  }
  if (s.scheme.space) part.html += "<p>Made for the space " + space_html(*s.scheme.space) + ".</p>\n";
  return part;
}

Part derivation(const Subject& s) {
  Part part;
  if (!s.scheme.space) return part;
  part.html = to_html(derive(s.scheme)) +
              commands_html({"twoscale derive " + s.name, "twoscale derive " + s.name + " --format latex"});
  return part;
}

Part masks(const Subject& s) {
  Part part;
  lowering::LowerOptions options;
  options.levels = is_stationary(s.scheme) ? 1 : table_levels;
  const kernels::MaskTable t = lowering::lower(s.scheme, s.binding, options);
  std::string values;
  for (const auto& [name, value] : t.parameters) values += (values.empty() ? "" : ", ") + name + " = " + value;
  part.html = "<p>" + (values.empty() ? "" : "For " + prose(values) + ": ") +
              fmt::format("{} significant digits, all of them proved; error at most {}. {}.</p>\n", t.digits,
                          escaped(t.precision_error), prose(t.normalisation));
  part.html += "<div class=\"wide\"><table class=\"grid\"><thead><tr><th>i</th>";
  const bool rows = !is_stationary(s.scheme);
  if (rows)
    for (size_t k = 0; k < t.levels.size(); ++k) part.html += fmt::format("<th>k = {}</th>", k);
  part.html += std::string("<th>") + (rows ? "limit" : "a<sub>i</sub>") + "</th></tr></thead><tbody>\n";
  for (long i = t.limit.lowest; i <= t.limit.highest(); ++i) {
    const auto cell = [&](const kernels::MaskRow& r) {
      part.html += "<td>" + escaped(r.text[static_cast<size_t>(i - r.lowest)]) + "</td>";
    };
    part.html += fmt::format("<tr><td>{}</td>", i);
    if (rows)
      for (const auto& r : t.levels) cell(r);
    cell(t.limit);
    part.html += "</tr>\n";
  }
  part.html += "</tbody></table></div>\n";
  for (const auto& [format, title] : {std::pair("csv", "CSV"), std::pair("json", "JSON")})
    part.html += std::string("<details><summary>The same as ") + title + "</summary><pre>" +
                 escaped(kernels::write_table(t, format)) + "</pre></details>\n";
  if (rows)
    part.html += fmt::format("<p>From level {} on no coefficient is farther than {} from the limit.</p>\n", t.tail_from,
                             escaped(t.tail_bound));
  part.html += commands_html({"twoscale table " + s.name + s.values + fmt::format(" --levels {}", options.levels)});
  part.numbers = {{"levels", t.levels.size()}, {"tail", t.tail_bound}};
  return part;
}

}  // namespace twoscale::reports::scheme_page
