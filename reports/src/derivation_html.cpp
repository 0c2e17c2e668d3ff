// SPDX-License-Identifier: GPL-3.0-or-later
// A derivation as a piece of a page. Formulas are MathML; what is a matrix in the mathematics is one on the page.
#include <fmt/format.h>

#include "document.hpp"
#include "twoscale/reports/derivation.hpp"
#include "twoscale/reports/html.hpp"

namespace twoscale::reports {

namespace {

using Matrix = std::vector<std::vector<RationalFunction>>;

std::string number(long n) {
  return n < 0 ? fmt::format("<mrow><mo>−</mo><mn>{}</mn></mrow>", -n) : fmt::format("<mn>{}</mn>", n);
}

std::string subscripted(const std::string& name, long index) {
  return "<msub><mi>" + name + "</mi>" + number(index) + "</msub>";
}

std::string block(const std::string& inside) {
  return "<div class=\"wide\"><math displaystyle=\"true\"><mrow>" + inside + "</mrow></math></div>\n";
}

std::string table(const std::vector<std::vector<std::string>>& rows) {
  std::string s;
  for (const auto& row : rows) {
    s += "<mtr>";
    for (const auto& cell : row) s += "<mtd>" + cell + "</mtd>";
    s += "</mtr>";
  }
  return "<mrow><mo>(</mo><mtable>" + s + "</mtable><mo>)</mo></mrow>";
}

std::string matrix(const Matrix& m, std::size_t columns) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& row : m) {
    rows.emplace_back();
    for (std::size_t i = 0; i < columns; ++i)
      rows.back().push_back(i < row.size() ? mathml(row[i].to_string()) : "<mn>0</mn>");
  }
  return table(rows);
}

std::string column(const std::vector<RationalFunction>& list) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& x : list) rows.push_back({mathml(x.to_string())});
  return table(rows);
}

// A symmetric mask names each value once.
std::string mask_html(const std::string& letter, const std::string& plain, const Laurent& a) {
  const auto centre = a.centre_of_symmetry();
  std::string rows, text;
  for (long i = a.lowest(); i <= a.highest(); ++i) {
    const long mirror = a.lowest() + a.highest() - i;
    if (centre && mirror < i) break;
    const bool pair = centre && mirror != i;
    const std::string value = a.coefficient(i).to_string();
    const std::string equals = "<mo>=</mo>";
    rows += "<mtr><mtd>" + subscripted(letter, i) + (pair ? equals + subscripted(letter, mirror) : "") + "</mtd><mtd>" +
            equals + mathml(value) + "</mtd></mtr>";
    text += fmt::format("{0}_{1}{2} = {3}\n", plain, i, pair ? fmt::format(" = {}_{}", plain, mirror) : "", value);
  }
  return "<div class=\"wide\"><math displaystyle=\"true\"><mtable displaystyle=\"true\" columnalign=\"right left\" "
         "class=\"equations\">" +
         rows + "</mtable></math></div>\n<details><summary>The same as text</summary><pre>" + escaped(text) +
         "</pre></details>\n";
}

std::string nodes_html(const std::vector<Polynomial>& nodes) {
  std::string list;
  for (const auto& g : nodes) list += (list.empty() ? "" : "<mo>,</mo>") + mathml(g.pretty());
  return "<math><mrow><mi>γ</mi><mo>=</mo><mo stretchy=\"false\">(</mo>" + list +
         "<mo stretchy=\"false\">)</mo></mrow></math>";
}

std::string step(const std::string& heading, const std::string& body) {
  return "<li><h3>" + heading + "</h3>\n" + body + "</li>\n";
}

std::string space_step(const Derivation& d) {
  std::string s =
      fmt::format("<p>{}, dimension {}; arity {}.</p>\n", space_html(d.space), d.space.dimension(), d.arity);
  for (const auto& v : d.space.variables())
    s += "<p><math><mrow>" + mathml(v.name) + "<mo>=</mo></mrow></math> <code>" + escaped(v.meaning(d.arity)) +
         "</code>, <code>" + escaped(recurrence(v.name, d.arity)) + "</code></p>\n";
  return step("The space", s);
}

std::string system_html(const Matrix& m, const std::vector<RationalFunction>& rhs,
                        const std::vector<RationalFunction>& solution, const RationalFunction& determinant,
                        const std::string& name) {
  return block("<mi>" + name + "</mi><mo>=</mo>" + matrix(m, rhs.size())) +
         block("<mi>" + name + "</mi><mo>&#x2062;</mo><mi>w</mi><mo>=</mo>" + column(rhs) +
               "<mo>,</mo><mspace width=\"1em\"/><mi>det</mi><mspace width=\"0.25em\"/><mi>" + name +
               "</mi><mo>=</mo>" + mathml(determinant.to_string()) +
               "<mo>,</mo><mspace width=\"1em\"/><mi>w</mi><mo>=</mo>" + column(solution));
}

std::string singular_step(const Derivation& d) {
  if (d.space.variables().empty()) return {};
  std::string s;
  if (d.singular.values.empty() && d.singular.conditions.empty()) {
    s = "<p>None: every step exists for every value of the domain.</p>\n";
  } else if (!d.singular.conditions.empty()) {
    s = "<p>A step fails where one of these vanishes:</p>\n<ul>\n";
    for (const auto& c : d.singular.conditions) s += "<li>" + formula("", c.pretty()) + "</li>\n";
    s += "</ul>\n";
  } else {
    s = singular_table(d.singular);
    // Of a dual scheme v^0 may belong to half the frequency: no polygon is named then.
    const auto n = d.quasi && d.quasi->order() % 2 == 1 ? std::vector<long>() : impossible_polygons(d.singular);
    std::string list;
    for (const long k : n) list += (list.empty() ? "" : ", ") + std::to_string(k);
    if (!list.empty())
      s += "<p>A closed trigonometric curve sampled at 2π/N cannot start from N = " + list + " points.</p>\n";
  }
  return step("Where a step fails", s);
}

std::string quasi_steps(const Derivation& d) {
  const QuasiSpline& q = *d.quasi;
  std::string html = step("β, the exponential B-spline of order " + std::to_string(q.order()),
                          "<p>It generates the space.</p>\n" + mask_html("β", "beta", q.beta));
  html += step("q, so that " + space_html(q.reproduced) + " is reproduced",
               std::string("<p>q is the Hermite interpolant of <code>") +
                   (q.order() % 2 == 0 ? "2/beta(z)" : "2 z^(1/2)/beta(z)") +
                   "</code>, as a function of <code>z + 1/z</code>, at the nodes " + nodes_html(q.nodes) +
                   ". In the Newton basis of the nodes its coefficients w solve</p>\n" +
                   system_html(q.matrix, q.rhs, q.solution, q.determinant, "H") + mask_html("q", "q", q.q));
  if (d.factor)
    html += step("The factor of this scheme",
                 "<p>Another one that solves the same equations.</p>\n" + mask_html("f", "f", *d.factor));
  return html + step(std::string("The mask a = β ") + (d.factor ? "f" : "q"), mask_html("a", "a", *d.mask));
}

std::string interpolating_steps(const Derivation::Interpolating& i, int arity, long dimension) {
  const long n = static_cast<long>(i.system.nodes.size());
  std::string html =
      step("The linear system H w = w₀ e<sub>" + std::to_string(n) + "</sub>",
           "<p>ζ = σω is interpolatory exactly when ω, as a function of <code>x = z + 1/z</code>, is the Hermite "
           "interpolant "
           "of <code>" +
               std::to_string(arity) + "/S(x)</code>, <code>S(x) = σ(z)</code> centred, at the nodes " +
               nodes_html(i.system.nodes) +
               ". In their Newton basis the matrix of divided differences [γ<sub>i</sub>, …, γ<sub>r</sub>]S is lower "
               "Hessenberg.</p>\n" +
               system_html(i.system.matrix, i.system.rhs, i.system.solution, i.system.determinant, "H"));
  html += step("ω", mask_html("ω", "omega", i.system.omega));
  return html + step("ζ = σω, the " + std::to_string(dimension) + "-point interpolating scheme",
                     "<p>It reproduces the space.</p>\n" + mask_html("ζ", "zeta", i.zeta));
}

}  // namespace

std::string to_html(const Derivation& d) {
  std::string html = "<ol class=\"steps\">\n" + space_step(d);
  if (d.quasi) {
    html += quasi_steps(d);
  } else {
    html += step("σ, the approximating scheme", "<p>It generates the space.</p>\n" + mask_html("σ", "sigma", d.sigma));
    if (d.interpolating) html += interpolating_steps(*d.interpolating, d.arity, static_cast<long>(d.space.dimension()));
    if (d.mask) html += step("The mask of the scheme", mask_html("a", "a", *d.mask));
  }
  return html + singular_step(d) + "</ol>\n";
}

}  // namespace twoscale::reports
