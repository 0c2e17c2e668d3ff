// SPDX-License-Identifier: GPL-3.0-or-later
#include "document.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>

#include "twoscale/reports/html.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::reports {

namespace {

const char* const style = R"(
:root { color-scheme: light; }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1.5rem 1.25rem 4rem; max-width: 74rem; background: #fff; color: #1f2937;
  font: 16px/1.55 system-ui, "Segoe UI", "Liberation Sans", "DejaVu Sans", sans-serif; }
h1 { font-size: 1.8rem; line-height: 1.2; margin: .5rem 0 .25rem; }
h2 { font-size: 1.35rem; margin: 2.75rem 0 .75rem; padding-bottom: .3rem; border-bottom: 2px solid #0b5394; }
h3 { font-size: 1.1rem; margin: 2rem 0 .5rem; }
p, ul { max-width: 60rem; margin: .6rem 0; }
a { color: #0b5394; }
nav ul { display: flex; flex-wrap: wrap; gap: .25rem 1.25rem; padding: 0; list-style: none; }
code, pre { font: .85rem/1.5 ui-monospace, "Liberation Mono", "DejaVu Sans Mono", monospace; }
pre { background: #f3f4f6; border-radius: 4px; padding: .6rem .8rem; overflow-x: auto; margin: .5rem 0; }
.prompt { color: #6b7280; user-select: none; }
math { font-size: 1.05em; }
article { border: 1px solid #e5e7eb; border-radius: 6px; padding: 0 1.25rem 1rem; margin: 1.25rem 0; }
article h3 { margin-top: 1rem; }
.split { display: grid; grid-template-columns: minmax(0, 1.15fr) minmax(0, 1fr); gap: 1.5rem; align-items: center; }
.findings { background: #f0f6fc; border-left: 4px solid #0b5394; padding: .4rem 1.2rem; margin: 1rem 0; }
.findings li { margin: .4rem 0; }
table { border-collapse: collapse; font-size: .88rem; width: 100%; margin: .6rem 0; }
table.narrow { width: auto; }
th, td { text-align: left; padding: .25rem .6rem; border-bottom: 1px solid #e5e7eb; vertical-align: middle; }
th { font-weight: 600; color: #4b5563; }
.grid td, .grid th { text-align: center; white-space: nowrap; }
.grid td:first-child, .grid th:first-child { text-align: left; white-space: normal; }
.proved { color: #166534; font-weight: 600; }
.refuted { color: #b91c1c; font-weight: 600; }
.undecided { color: #92400e; font-weight: 600; }
.subject, .small { color: #6b7280; font-size: .85rem; }
.wide { overflow-x: auto; }
figure { margin: 0; }
figure img { display: block; max-width: 100%; height: auto; margin: 0 auto; }
figcaption { font-size: .9rem; margin-top: .3rem; }
.panels { display: grid; grid-template-columns: repeat(auto-fit, minmax(20rem, 1fr)); gap: 1.75rem 1.5rem; }
.panels > figure { max-width: 36rem; width: 100%; }
.panels > figure:only-child { max-width: none; display: grid; gap: 1.5rem;
  grid-template-columns: minmax(0, 1fr) minmax(0, 1.2fr); align-items: center; }
details { font-size: .9rem; margin: .4rem 0; }
summary { cursor: pointer; color: #0b5394; }
footer { margin-top: 3rem; border-top: 1px solid #e5e7eb; padding-top: .75rem; color: #6b7280; font-size: .85rem; }
@media (max-width: 48rem) { .split, .panels > figure:only-child { grid-template-columns: minmax(0, 1fr); } }
@media print {
  body { max-width: none; font-size: 10pt; padding: 0; }
  nav, details:not([open]) { display: none; }
  figure, article table, tr { break-inside: avoid; }
  h2, h3 { break-after: avoid; }
  .panels { grid-template-columns: 1fr 1fr; }
  a { color: inherit; text-decoration: none; }
}
)";

}  // namespace

std::string page_style() { return style; }

void make_directory(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error || !std::filesystem::is_directory(path))
    throw Error(Error::Kind::io, "directory cannot be made", path.string());
}

std::string embedded(Part& part, const std::string& name, const std::string& alternative, const Picture& picture) {
  const std::string svg = render(picture, ImageFormat::svg);
  part.files.emplace_back("figures/" + name + ".svg", svg);
  return fmt::format("<img src=\"{}\" width=\"{}\" height=\"{}\" alt=\"{}\"/>", data_uri(svg), picture.width,
                     picture.height, escaped(alternative));
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
  replace("v0", "v⁰");
  replace("> -1", "> −1");
  replace("= -", "= −");
  return escaped(text);
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
