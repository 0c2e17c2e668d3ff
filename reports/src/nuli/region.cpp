// SPDX-License-Identifier: GPL-3.0-or-later
// Where the 6-point scheme is C^2: the polynomial F(alpha, k, q), its zero set for some alpha, exact points beside it.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "nuli/sections.hpp"
#include "twoscale/analysis/knots.hpp"
#include "twoscale/reports/html.hpp"
#include "twoscale/symbolic/catalog.hpp"

namespace twoscale::reports::nuli {

namespace {

// The terms of F in doubles: for pictures only.
struct Terms {
  std::vector<std::array<double, 4>> list;  // coefficient, exponents of alpha, k, q
  double operator()(double alpha, double k, double q) const {
    double sum = 0;
    for (const auto& t : list) sum += t[0] * std::pow(alpha, t[1]) * std::pow(k, t[2]) * std::pow(q, t[3]);
    return sum;
  }
};

Terms estimate_terms(const Polynomial& f) {
  Terms t;
  const auto& names = f.variables();
  f.for_each_term([&](const Rational& c, std::span<const unsigned long> e) {
    std::array<double, 4> term{static_cast<double>(c.to_long()), 0, 0, 0};
    for (std::size_t i = 0; i < names.size(); ++i)
      term[names[i] == "alpha" ? 1 : names[i] == "k" ? 2 : 3] = static_cast<double>(e[i]);
    t.list.push_back(term);
  });
  return t;
}

// The zero set of F(alpha, 1 - x, y) for 1/2 <= x <= 1, 0 <= y <= 1/2, by linear interpolation on the edges of a grid.
std::vector<double> zero_set(const Terms& f, double alpha) {
  constexpr int n = 200;
  std::vector<double> segments;
  const auto x = [](int i) { return 0.5 + 0.5 * i / n; };
  const auto y = [](int j) { return 0.5 * j / n; };
  std::vector<double> value;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) value.push_back(f(alpha, 1 - x(i), y(j)));
  const auto at = [&](int i, int j) { return value[static_cast<std::size_t>(j * (n + 1) + i)]; };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      // Two triangles a cell: a segment for each that is crossed.
      const std::array<std::array<int, 6>, 2> triangles = {
          {{i, j, i + 1, j, i + 1, j + 1}, {i, j, i, j + 1, i + 1, j + 1}}};
      for (const auto& t : triangles) {
        std::vector<double> ends;
        for (int e = 0; e < 3; ++e) {
          const auto a = static_cast<std::size_t>(2 * e), b = static_cast<std::size_t>(2 * ((e + 1) % 3));
          const double p = at(t[a], t[a + 1]), q = at(t[b], t[b + 1]);
          if ((p > 0) == (q > 0)) continue;
          const double s = p / (p - q);
          ends.push_back(x(t[a]) + s * (x(t[b]) - x(t[a])));
          ends.push_back(y(t[a + 1]) + s * (y(t[b + 1]) - y(t[a + 1])));
        }
        if (ends.size() == 4) segments.insert(segments.end(), ends.begin(), ends.end());
      }
    }
  return segments;
}

// Segments that meet, joined to lines.
std::vector<std::vector<double>> chained(std::vector<double> segments) {
  constexpr double near = 1e-9;
  std::vector<std::vector<double>> lines;
  while (!segments.empty()) {
    std::vector<double> line(segments.end() - 4, segments.end());
    segments.resize(segments.size() - 4);
    for (int end = 0; end < 2; ++end) {
      for (bool grown = true; grown;) {
        grown = false;
        for (std::size_t s = 0; s < segments.size() && !grown; s += 4)
          for (const std::size_t e : {std::size_t{0}, std::size_t{2}}) {
            const double x = line[line.size() - 2], y = line.back();
            if (std::abs(segments[s + e] - x) > near || std::abs(segments[s + e + 1] - y) > near) continue;
            line.push_back(segments[s + 2 - e]);
            line.push_back(segments[s + 3 - e]);
            segments.erase(segments.begin() + static_cast<long>(s), segments.begin() + static_cast<long>(s + 4));
            grown = true;
            break;
          }
      }
      // The other end.
      std::vector<double> reversed;
      for (std::size_t i = line.size(); i >= 2; i -= 2) reversed.insert(reversed.end(), {line[i - 2], line[i - 1]});
      line = std::move(reversed);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace

Polynomial smoothness_boundary() {
  const analysis::JunctionVerdict v = analysis::decide_junction(make_scheme("nuli6"), 2);
  for (const auto& c : v.cases)
    if (c.chart && c.boundary) return *c.boundary;
  throw std::logic_error("nuli6: no boundary polynomial");
}

Section region_section() {
  Section s{"region", "C² region", "Where the 6-point scheme is C²", {}};
  Part& part = s.part;
  const Polynomial f = smoothness_boundary();
  const Terms terms = estimate_terms(f);
  Picture p;
  p.x_label = "λ of the edge before the vertex";
  p.y_label = "λ of the edge after it";
  p.width = 560;
  p.height = 520;
  p.equal_axes = false;
  Line corner;
  corner.style = Line::Style::reference;
  corner.values = {0.5, 0, 0.5, 0.5, 1, 0.5};
  corner.title = "corner";
  p.lines.push_back(corner);
  int colour = 0;
  for (const auto& [name, alpha] : {std::pair("1/9", 1.0 / 9), {"1/3", 1.0 / 3}, {"1", 1.0}, {"3", 3.0}, {"9", 9.0}}) {
    std::string title = std::string("α = ") + name;
    for (auto& values : chained(zero_set(terms, alpha))) {
      Line l;
      l.values = std::move(values);
      l.colour = colour;
      l.title = title;
      title.clear();
      p.lines.push_back(std::move(l));
    }
    ++colour;
  }
  // Exact values on the diagonal lambda = (1 - s, s): the interval of s where F changes sign.
  std::string rows;
  part.numbers = nlohmann::ordered_json::array();
  for (const char* alpha : {"1/9", "1/3", "1", "3", "9"}) {
    const Rational a = Rational::parse(alpha);
    Rational low = 0, high(1, 2);
    for (int step = 0; step < 9; ++step) {
      const Rational middle = (low + high) * Rational(1, 2);
      const bool inside = f.evaluate({{"alpha", a}, {"k", middle}, {"q", middle}}).sign() > 0;
      (inside ? high : low) = middle;
    }
    rows += "<tr><td>" + std::string(alpha) + "</td><td>" + low.to_string() + "</td><td>" + high.to_string() +
            "</td></tr>\n";
    part.numbers.push_back({{"alpha", alpha}, {"not_at", low.to_string()}, {"smooth_at", high.to_string()}});
  }
  part.html =
      "<p>Outside of the corner λ<sub>i−1</sub> &gt; 1/2, λ<sub>i</sub> &lt; 1/2 the limits are C² for all α. Inside, "
      "they are exactly where F(α, k, q) &gt; 0, k = 1 − λ<sub>i−1</sub>, q = λ<sub>i</sub>. The curves below are F = "
      "0 "
      "for some α: C² above and to the left of them, C¹ with a Hölder exponent below 2 beside the vertex below and to "
      "the right, at (1, 0) for every α.</p>\n<div class=\"panels\">\n" +
      figure(part,
             {"region",
              "Where the limits of nuli6 are C²",
              "<p>On the diagonal λ = (1 − s, s), k = q = s, exactly:</p><table class=\"narrow\"><thead><tr><th>α</th>"
              "<th>not C² at s =</th><th>C² at s =</th></tr></thead><tbody>\n" +
                  rows + "</tbody></table>",
              {"twoscale prove nuli6 --claim continuity=2"},
              false},
             p) +
      "</div>\n<details><summary>F</summary><pre>" + escaped(f.pretty()) + "</pre></details>\n";
  return s;
}

}  // namespace twoscale::reports::nuli
