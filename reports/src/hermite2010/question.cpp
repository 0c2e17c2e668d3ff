// SPDX-License-Identifier: GPL-3.0-or-later
// Section: the open question of §4, its answer in closed forms, and what refinement shows.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "hermite2010/sections.hpp"
#include "twoscale/analysis/hermite_claims.hpp"
#include "twoscale/kernels/hermite.hpp"
#include "twoscale/reports/html.hpp"
#include "twoscale/symbolic/exact_real.hpp"

namespace twoscale::reports::hermite2010 {

namespace {

// One edge in one component; f, p, r at its two ends.
struct Edge {
  double sigma[2];
  double data[2][3];
};

constexpr double weight = 1.4;
constexpr const char* weight_text = "7/5";

// Goes into the left (or right) half.
void halve(Edge& e, bool left, double w) {
  const double v = std::tan(e.sigma[0] / 8), u = std::tan(e.sigma[1] / 8);
  const auto rule = kernels::hermite_step(v, u, w, kernels::HermiteRuleTension::printed);
  double middle[3];
  for (std::size_t h = 0; h < 3; ++h)
    middle[h] = rule[h][0] * (e.data[1][0] - e.data[0][0]) + rule[h][1] * e.data[0][1] + rule[h][2] * e.data[1][1] +
                rule[h][3] * e.data[0][2] + rule[h][4] * e.data[1][2];
  middle[0] += e.data[0][0];
  const std::size_t end = left ? 1 : 0;
  e.sigma[end] = (e.sigma[0] + e.sigma[1]) / 2;
  for (std::size_t h = 0; h < 3; ++h) e.data[end][h] = middle[h];
}

double at(const RationalFunction& f, double sigma, double w) {
  const auto rational = [](double x) { return Rational(static_cast<long>(std::llround(std::ldexp(x, 48))), 1L << 48); };
  const auto value = f.evaluate({{"s", rational(std::tan(sigma / 8))}, {"w", rational(w)}});
  return value ? std::strtod(ExactReal(*value).decimal(17).c_str(), nullptr) : NAN;
}

std::string closed_forms(const analysis::TensionRates& r) {
  const auto line = [](const char* left, const RationalFunction& f, const char* what) {
    return fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", what, formula(left, f.to_string()));
  };
  const std::string e = "<msub><mi>e</mi><mi>L</mi></msub>", g = "<msub><mi>e</mi><mi>R</mi></msub>";
  return "<table><thead><tr><th>s = tan(σ/8)</th><th>exactly</th></tr></thead><tbody>\n" +
         line(e.c_str(), r.left,
              "interval of the left half, against the half of the interval: ℓ(1 + e<sub>L</sub>ℓ + …)") +
         line(g.c_str(), r.right, "the same on the right") +
         line("", r.jump, "jump of r at a vertex from left to right, in units of p") +
         line("", r.drift, "change of r in two steps along (LR)<sup>∞</sup>, in units of p") + "</tbody></table>\n";
}

std::string experiment(const analysis::TensionRates& rates, nlohmann::ordered_json& numbers) {
  const Edge start{{0.8, 2.0}, {{1, 3, 1.0 / 3}, {2, -0.5, 5.0 / 7}}};
  const auto side = [](const RationalFunction& e) {
    return RationalFunction(Rational(-240, 7)) * e;  // of r, from the value at the vertex to the limit beside it
  };
  const double right_of = at(side(rates.left), start.sigma[0], weight);
  const double left_of = -at(side(rates.right), start.sigma[1], weight);
  std::string rows;
  Edge l = start, r = start, lr = start;
  double before = 0;
  for (int k = 1; k <= 16; ++k) {
    halve(l, true, weight);
    halve(r, false, weight);
    halve(lr, k % 2 == 1, weight);
    if (k % 2 == 1) continue;
    const double a = (l.data[1][2] - l.data[0][2]) / l.data[0][1], b = (r.data[0][2] - r.data[1][2]) / r.data[1][1];
    const double change = (lr.data[0][2] - before) / lr.data[0][1];
    rows += fmt::format("<tr><td>{}</td><td>{:.6f}</td><td>{:.6f}</td><td>{:.6f}</td><td>{:.4f}</td></tr>\n", k, a, b,
                        k > 2 ? change : NAN, lr.data[0][2]);
    numbers.push_back(nlohmann::ordered_json{{"level", k}, {"right", a}, {"left", b}, {"r", lr.data[0][2]}});
    before = lr.data[0][2];
  }
  for (std::size_t nan = rows.find("nan"); nan != std::string::npos; nan = rows.find("nan")) rows.replace(nan, 3, "–");
  return fmt::format(
      "<p>One edge, σ from 4/5 to 2, w = {}: (r of the neighbour − r)/p right of its first vertex and left of its last "
      "one, and r along (LR)<sup>∞</sup>, from refinement alone.</p>\n<table "
      "class=\"narrow\"><thead><tr><th>level</th><th>right "
      "of the first vertex</th><th>left of the last vertex</th><th>change of r/p in two steps</th><th>r along "
      "(LR)<sup>∞</sup></th></tr></thead><tbody>\n{}<tr><td>exactly, in the "
      "limit</td><td>{:.6f}</td><td>{:.6f}</td><td>{:.6f}</td>"
      "<td>unbounded</td></tr>\n</tbody></table>\n",
      weight_text, rows, right_of, left_of, at(rates.drift, lr.sigma[0], weight));
}

const Polygon five{"five", true, {0, 0, 4, -1, 5, 2, 2, 5, -1, 3}};

// r (its component along the y-axis) and the curvature p x r/|p|^3 of the data along the curve.
std::string pictures(Part& part) {
  std::string html;
  const std::tuple<const char*, const char*, const char*> runs[] = {
      {"1", "hermite-circle:w=7/5", "tension as printed, w = 7/5"},
      {"2", "hermite-circle:variant=c2,w=7/5", "variant c2, w = 7/5"}};
  for (const auto& [id, scheme, what] : runs) {
    const kernels::PointSet jets = refined_jets(scheme, five, 8);
    Picture r, k;
    Line second, bend;
    const std::size_t n = jets.size();
    // One edge, without charts: the second one (vertices 1 and 2).
    for (std::size_t j = n / 5; j <= 2 * n / 5; ++j) {
      const double* x = &jets.values[j * jets.dim];
      const double place = static_cast<double>(j) * 5 / static_cast<double>(n);
      second.values.insert(second.values.end(), {place, x[5]});
      bend.values.insert(bend.values.end(), {place, (x[2] * x[5] - x[3] * x[4]) / std::pow(std::hypot(x[2], x[3]), 3)});
    }
    for (auto* p : {&r, &k}) {
      p->equal_axes = false;
      p->x_label = "vertex";
      p->height = 300;
    }
    r.y_label = "second component of r";
    k.y_label = "curvature of the data";
    r.lines = {second};
    bend.colour = 1;
    k.lines = {bend};
    html +=
        figure(part, {std::string("question-r-") + id, std::string("r between two vertices, ") + what, "", {}, false},
               r) +
        figure(part,
               {std::string("question-curvature-") + id,
                std::string("curvature |p × r|/|p|³ there, ") + what,
                "",
                {},
                false},
               k);
  }
  return "<div class=\"panels\">\n" + html + "</div>\n";
}

}  // namespace

Section question_section() {
  Section s{"question", "Open question", "The open question of §4", {}};
  Part& part = s.part;
  part.numbers = nlohmann::ordered_json::array();
  const analysis::TensionRates& rates = analysis::tension_rates();
  part.html =
      "<p>Is the limit C² for every w &gt; 0? Below the "
      "first "
      "pole w* of the data:</p>\n<ul>\n<li>It is C¹ in t, with c′ = w p.</li>\n<li>For w ≠ 1 it is <strong>not "
      "C²</strong>, in t or in any "
      "regular C² parameter: r jumps at the vertices, and along alternating halves grows without bound.</li>\n<li>It "
      "<strong>is G²</strong> where p ≠ 0: |p × r|/|p|³ converges uniformly to the curvature. The paper’s conjecture "
      "about "
      "curvature is true, the one about C² false.</li>\n<li><code>variant=c2</code> has limits that are C² in t (c′ = "
      "w p, c″ "
      "= w² r), the same curvature at the vertices and no poles.</li>\n</ul>\n<p>A step is the rule without tension on "
      "a <em>fake</em> interval; the fake intervals of the two halves do not fit, and each misfit adds a multiple of "
      "the "
      "tangent p to r, which curvature does not see. The argument line by line: reports/hermite2010/tension.md.</p>\n" +
      closed_forms(rates) + experiment(rates, part.numbers) + pictures(part);
  part.findings = {
      "<strong>The open question:</strong> for w ≠ 1 the limit of the printed tension is G², but not C². "
      "<a href=\"#question\">Jumps and drifts in closed form</a>; a tension control that is C² stands beside it."};
  part.files.emplace_back("data/five.csv", kernels::to_csv(five.points()));
  return s;
}

}  // namespace twoscale::reports::hermite2010
