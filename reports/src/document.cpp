// SPDX-License-Identifier: GPL-3.0-or-later
#include "document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>

#include "assets.hpp"
#include "twoscale/reports/html.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::reports {

namespace {

template <class P>
std::string figure_of(Part& part, const Drawing& d, const P& picture) {
  const std::string svg = render(picture, ImageFormat::svg);
  const std::string file = "figures/" + d.id + ".svg";
  part.files.emplace_back(file, svg);
  part.figures.push_back({d.id, d.title, file, d.commands.empty() ? "" : d.commands[0], d.numbered});
  const std::string title = escaped(d.title);
  return fmt::format(
      "<figure id=\"panel-{}\">\n<img src=\"{}\" width=\"{}\" height=\"{}\" alt=\"{}\"/>\n<figcaption>"
      "{}{}{}</figcaption>\n</figure>\n",
      d.id, data_uri(svg), picture.width, picture.height, title,
      d.numbered ? "<strong>" + d.id + "</strong> " + title : "<strong>" + title + "</strong>", d.detail,
      hidden_commands(d.commands));
}

}  // namespace

const std::string& asset(const std::string& name) {
  for (const auto& [known, text] : embedded_assets())
    if (known == name) return text;
  throw std::logic_error("no such asset: " + name);
}

std::string script(const std::string& text) { return "<script>\n//<![CDATA[\n" + text + "//]]>\n</script>\n"; }

void make_directory(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error || !std::filesystem::is_directory(path))
    throw Error(Error::Kind::io, "directory cannot be made", path.string());
}

void Part::exact_run(double deviation) {
  ++exact_runs;
  largest_exact_deviation = std::max(largest_exact_deviation, deviation);
}

std::string Part::absorb(Part part) {
  const auto append = [](auto& to, auto& from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  };
  append(files, part.files);
  append(findings, part.findings);
  append(figures, part.figures);
  exact_runs += part.exact_runs;
  largest_exact_deviation = std::max(largest_exact_deviation, part.largest_exact_deviation);
  certificates_valid = certificates_valid && part.certificates_valid;
  interactive = interactive || part.interactive;
  return std::move(part.html);
}

std::string figure(Part& part, const Drawing& drawing, const Picture& picture) {
  return figure_of(part, drawing, picture);
}
std::string figure(Part& part, const Drawing& drawing, const SurfacePicture& picture) {
  return figure_of(part, drawing, picture);
}

std::string certificate_html(Part& part, const std::string& name, const std::string& text, const Checker& checker) {
  const std::string file = "certificates/" + name + ".json";
  part.files.emplace_back(file, text);
  std::string html = fmt::format("<p><a download=\"{0}.json\" href=\"{1}\">Certificate</a> (also <code>{2}</code>)",
                                 name, data_uri(text, "application/json"), file);
  if (!checker) return html + ".</p>\n";
  const CheckerVerdict v = checker(text);
  part.certificates_valid = part.certificates_valid && v.valid;
  std::string lines;
  for (const auto& line : v.lines) lines += escaped(line) + "\n";
  return html +
         fmt::format(
             ": the independent checker says <strong class=\"{0}\">{1}</strong>.</p>\n<details><summary>What the "
             "checker verified, and the theorems it trusts</summary><pre>{2}</pre></details>\n",
             v.valid ? "proved" : "refuted", v.valid ? "valid" : "refused", lines);
}

std::string commands_html(const std::vector<std::string>& lines) {
  std::string s;
  for (const auto& line : lines) s += command(line);
  return "<pre class=\"shell\">" + s + "</pre>\n";
}

std::string hidden_commands(const std::vector<std::string>& lines) {
  if (lines.empty()) return {};
  return std::string("<details><summary>Command") + (lines.size() == 1 ? "" : "s") + "</summary>" +
         commands_html(lines) + "</details>";
}

std::string shell_quoted(const std::string& word) {
  bool plain = !word.empty();
  for (char c : word)
    plain = plain && (std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                      std::string_view("-_./:=,+").find(c) != std::string_view::npos);
  return plain ? word : "'" + word + "'";
}

std::string command(const std::string& line) { return "<span class=\"prompt\">$ </span>" + escaped(line) + "\n"; }

std::string number_text(double value) {
  if (value == 0) return "0";
  if (std::abs(value) >= 1e-3) return fmt::format("{:.3g}", value);
  const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value))));
  return fmt::format("{:.1f}·10<sup>−{}</sup>", value / std::pow(10.0, exponent), -exponent);
}

std::string space_html(const Space& space) {
  std::string s;
  for (const std::string& item : space.items()) s += (s.empty() ? "" : "<mo>,</mo>") + mathml(item);
  return "<math><mrow><mo stretchy=\"false\">{</mo>" + s + "<mo stretchy=\"false\">}</mo></mrow></math>";
}

// The prover's plain text with proper signs.
std::string prose(std::string text) {
  const auto replace = [&](const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
  };
  replace(">= ", "≥ ");
  replace("v^0", "v⁰");
  replace("v0", "v⁰");
  replace("> -1", "> −1");
  replace("= -", "= −");
  return escaped(text);
}

std::string singular_table(const SingularSet& set) {
  std::string s =
      "<table class=\"narrow\"><thead><tr><th>singular v⁰</th><th>decimal</th><th>the step that fails</th></tr></thead>"
      "<tbody>\n";
  for (const auto& v : set.values)
    s += fmt::format("<tr><td>{}</td><td>{}</td><td>k = {}</td></tr>\n", formula("", v.exact()),
                     parse_real(v.exact()).decimal(6), v.level);
  return s + "</tbody></table>\n";
}

std::string verdict_table(const std::vector<analysis::Decision>& decisions) {
  std::string s = "<table><thead><tr><th>claim</th><th>verdict</th><th>for</th><th>except</th></tr></thead><tbody>\n";
  for (const auto& d : decisions) {
    const std::string word = to_string(d.verdict);
    std::string exceptions;
    for (const auto& e : d.exceptions) exceptions += (exceptions.empty() ? "" : "; ") + prose(e);
    s += fmt::format("<tr><td>{}{}</td><td class=\"{}\">{}</td><td>{}</td><td>{}</td></tr>\n", escaped(d.claim),
                     d.subject.empty() ? "" : " <span class=\"subject\">" + escaped(d.subject) + "</span>", word, word,
                     prose(d.verdict == analysis::Verdict::proved ? d.domain : d.witness),
                     exceptions.empty() ? "–" : exceptions);
  }
  return s + "</tbody></table>\n";
}

}  // namespace twoscale::reports
