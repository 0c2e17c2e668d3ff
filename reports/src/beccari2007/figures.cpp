// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 1-6 of beccari2007 as data. Values of v^0 and the curves of figures 2, 5 and 6 are the paper’s; polygons and
// the spacings of figure 1 are ours, because it prints none.
#include <cmath>

#include "twoscale/reports/beccari2007.hpp"

namespace twoscale::reports::beccari2007 {

namespace {

const NamedScheme four = {"tension4", "4-point, tension"};

const Curve cosh_graph = {"y = cosh x", 2, [](double s, double* p) {
                            p[0] = s;
                            p[1] = std::cosh(s);
                          }};
const Curve sinh_graph = {"y = sinh x", 2, [](double s, double* p) {
                            p[0] = s;
                            p[1] = std::sinh(s);
                          }};
const Curve cos_graph = {"y = cos x", 2, [](double s, double* p) {
                           p[0] = s;
                           p[1] = std::cos(s);
                         }};
const Curve sin_graph = {"y = sin x", 2, [](double s, double* p) {
                           p[0] = s;
                           p[1] = std::sin(s);
                         }};
const Curve hyperbola = {"x = cosh s, y = sinh s", 2, [](double s, double* p) {
                           p[0] = std::cosh(s);
                           p[1] = std::sinh(s);
                         }};
const Curve ellipse = {"x = 4 cos s, y = 2 sin s", 2, [](double s, double* p) {
                         p[0] = 4 * std::cos(s);
                         p[1] = 2 * std::sin(s);
                       }};
const Curve parabola = {"x = s, y = s²", 2, [](double s, double* p) {
                          p[0] = s;
                          p[1] = s * s;
                        }};
const Curve circle = {"x = cos s, y = sin s", 2, [](double s, double* p) {
                        p[0] = std::cos(s);
                        p[1] = std::sin(s);
                      }};

const Polygon open_polygon = {{0, 0, 1, 2, 2.6, 2.4, 3.4, 0.6, 4.6, 0.2, 5.4, 2, 7, 2.2}, false};
const Polygon closed_polygon = {{0, 0, 2, -1, 4.5, 0, 4, 2.5, 2.2, 1.6, 0.6, 3.2, -0.8, 2}};

Panel graph(const char* id, const char* title, const Curve& curve, const char* first, const char* spacing,
            const char* v0) {
  return {
      id, title, Samples{curve, first, spacing, 5, false}, {{four, v0, Expect::exact}}, "Start and spacing are ours."};
}

Panel shapes(const char* id, const char* title, const Polygon& polygon, const std::vector<const char*>& values,
             const char* note) {
  Panel p{id, title, polygon, {}, note};
  for (const char* v : values) p.trials.push_back({four, v, Expect::shape});
  return p;
}

// The value that gives the circle first.
Panel regular(const char* id, const char* title, const char* spacing, int count, const char* right,
              const std::vector<const char*>& others) {
  Panel p{id, title, Samples{circle, "pi/2", spacing, count, true}, {{four, right, Expect::exact}}, ""};
  for (const char* v : others) p.trials.push_back({four, v, Expect::different});
  return p;
}

std::vector<Figure> build() {
  return {{1,
           "Hyperbolic and trigonometric functions",
           "Graphs returned from five samples and two more beyond each end (Remark 8).",
           {graph("1a", "Hyperbolic cosine", cosh_graph, "-2", "1", "cosh(1)"),
            graph("1b", "Hyperbolic sine", sinh_graph, "-2", "1", "cosh(1)"),
            graph("1c", "Cosine", cos_graph, "-2*pi/3", "pi/3", "1/2"),
            graph("1d", "Sine", sin_graph, "-2*pi/3", "pi/3", "1/2")}},
          {2,
           "Conic sections",
           "Hyperbola with u = 1 and a = b = 1, ellipse with a = 4, b = 2 and u = π/2, parabola.",
           {{"2a", "Hyperbola", Samples{hyperbola, "-2", "1", 5, false}, {{four, "cosh(1)", Expect::exact}}, ""},
            {"2b", "Ellipse", Samples{ellipse, "0", "pi/2", 4, true}, {{four, "0", Expect::exact}}, ""},
            {"2c", "Parabola", Samples{parabola, "-2", "1", 5, false}, {{four, "1", Expect::exact}}, ""}}},
          {3,
           "Tension on an open curve",
           "The rule (10) at both ends, v⁰ = −0.4, 1, 1000.",
           {shapes("3", "Open curve", open_polygon, {"-2/5", "1", "1000"}, "The polygon is ours.")}},
          {4,
           "Tension on a closed curve",
           "v⁰ = −0.5, 0, 1, 5, 50, 500.",
           {shapes("4", "Closed curve", closed_polygon, {"-1/2", "0", "1", "5", "50", "500"}, "The polygon is ours.")}},
          {5,
           "The square",
           "v⁰ = 0 = cos(2π/4) returns the circle.",
           {regular("5", "Square", "pi/2", 4, "0", {"-19/20", "-3/4", "-1/2", "1", "5", "25", "500"})}},
          {6,
           "The pentagon",
           "v⁰ = cos(2π/5) returns the circle.",
           {regular("6", "Pentagon", "2*pi/5", 5, "cos(2*pi/5)", {"-1/2", "-1/4", "0", "1", "5", "25", "500"})}}};
}

}  // namespace

const std::vector<Figure>& figures() {
  static const std::vector<Figure> list = build();
  return list;
}

}  // namespace twoscale::reports::beccari2007
