// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 1-12 of romani2009 as data. Parametrisations, spacings, counts and v^0 are the paper’s where it prints them;
// where it prints none (polygons, several curves of figures 3-7, the values of v^0 of figures 8-10) they are ours, and
// the note says so.
#include <cmath>

#include "sections.hpp"

namespace twoscale::reports::romani2009 {

namespace {

using std::cos;
using std::cosh;
using std::sin;
using std::sinh;

const NamedScheme four = {"tension4", "4-point, tension"};
const NamedScheme dubuc = {"dd:l=2", "Dubuc–Deslauriers 4-point"};
const NamedScheme weissmann = {"dd:l=3", "Weissmann 6-point"};
const NamedScheme mixed = {"interpolating:family=mixed,l=3", "6-point mixed"};
const NamedScheme harmonic = {"interpolating:family=harmonic,l=3", "6-point harmonic"};
const NamedScheme resonant = {"interpolating:family=resonant,l=3", "6-point resonant"};
const NamedScheme harmonic8 = {"interpolating:family=harmonic,l=4", "8-point harmonic"};
const NamedScheme lacunary = {"interpolating:space=\"1,x,cos(t*x),sin(t*x),cos(3*t*x),sin(3*t*x)\"",
                              "6-point lacunary"};

// ---- Curves

const Curve cardioid = {"x = ½ (1 + 2 cos s + cos 2s), y = ½ (2 sin s + sin 2s)", 2, [](double s, double* p) {
                          p[0] = (1 + 2 * cos(s) + cos(2 * s)) / 2;
                          p[1] = (2 * sin(s) + sin(2 * s)) / 2;
                        }};
const Curve astroid = {"x = 3 cos s + cos 3s, y = 3 sin s − sin 3s", 2, [](double s, double* p) {
                         p[0] = 3 * cos(s) + cos(3 * s);
                         p[1] = 3 * sin(s) - sin(3 * s);
                       }};
const Curve circle = {"x = cos s, y = sin s", 2, [](double s, double* p) {
                        p[0] = cos(s);
                        p[1] = sin(s);
                      }};
const Curve parabola = {"x = s, y = s²", 2, [](double s, double* p) {
                          p[0] = s;
                          p[1] = s * s;
                        }};
const Curve ellipse = {"x = 2 cos s, y = sin s", 2, [](double s, double* p) {
                         p[0] = 2 * cos(s);
                         p[1] = sin(s);
                       }};
const Curve hyperbola = {"x = cosh s, y = sinh s", 2, [](double s, double* p) {
                           p[0] = cosh(s);
                           p[1] = sinh(s);
                         }};
const Curve catenary = {"x = s, y = cosh s", 2, [](double s, double* p) {
                          p[0] = s;
                          p[1] = cosh(s);
                        }};
const Curve limacon = {"x = (1 + 2 cos s) cos s, y = (1 + 2 cos s) sin s", 2, [](double s, double* p) {
                         p[0] = (1 + 2 * cos(s)) * cos(s);
                         p[1] = (1 + 2 * cos(s)) * sin(s);
                       }};
const Curve deltoid = {"x = 2 cos s + cos 2s, y = 2 sin s − sin 2s", 2, [](double s, double* p) {
                         p[0] = 2 * cos(s) + cos(2 * s);
                         p[1] = 2 * sin(s) - sin(2 * s);
                       }};
const Curve piriform = {"x = 1 + sin s, y = cos s (1 + sin s)", 2, [](double s, double* p) {
                          p[0] = 1 + sin(s);
                          p[1] = cos(s) * (1 + sin(s));
                        }};
const Curve gerono = {"x = cos s, y = sin s cos s", 2, [](double s, double* p) {
                        p[0] = cos(s);
                        p[1] = sin(s) * cos(s);
                      }};
const Curve eight = {"x = sin 2s, y = 2 sin s", 2, [](double s, double* p) {
                       p[0] = sin(2 * s);
                       p[1] = 2 * sin(s);
                     }};
const Curve archimedes = {"x = s cos s, y = s sin s", 2, [](double s, double* p) {
                            p[0] = s * cos(s);
                            p[1] = s * sin(s);
                          }};
const Curve involute = {"x = cos s + s sin s, y = sin s − s cos s", 2, [](double s, double* p) {
                          p[0] = cos(s) + s * sin(s);
                          p[1] = sin(s) - s * cos(s);
                        }};
const Curve helix = {"x = cos s, y = sin s, z = s/6", 3, [](double s, double* p) {
                       p[0] = cos(s);
                       p[1] = sin(s);
                       p[2] = s / 6;
                     }};
const Curve viviani = {"x = 1 + cos s, y = sin s, z = 2 sin(s/2)", 3, [](double s, double* p) {
                         p[0] = 1 + cos(s);
                         p[1] = sin(s);
                         p[2] = 2 * sin(s / 2);
                       }};
const Curve conical = {"x = s cos s, y = s sin s, z = s", 3, [](double s, double* p) {
                         p[0] = s * cos(s);
                         p[1] = s * sin(s);
                         p[2] = s;
                       }};

// ---- Polygons

const Polygon star = {{0, 0, 3, -1, 5, 1, 4, 4, 2, 2.2, 1, 5, -1, 3}};
const Polygon uneven = {{0, 0, 4, 0, 4.6, 0.5, 5, 3, 3.9, 3.7, 3.4, 2.2, 0.7, 3.2, 0, 2.6}};
const Polygon very_uneven = {{0, 0, 8, 0, 8.6, 0.6, 8, 5, 7.4, 5.4, 3.5, 1.8, 3, 2.2, 0.5, 5.4, 0, 5}};

std::vector<Trial> all_three(const std::string& v0) {
  return {{mixed, v0, Expect::exact}, {harmonic, v0, Expect::exact}, {resonant, v0, Expect::exact}};
}

Figure figure1() {
  return {1,
          "What the 4-point scheme cannot do, and what can",
          "The paper draws a cardioid from 12 points and an astroid from 6 points by the 4-point scheme, which "
          "reproduces cos s and "
          "sin s only. Beside these pictures stand the schemes that do contain the curves. Six samples do not "
          "determine an astroid "
          "(sin 3s vanishes at all of them), so no scheme can give it back from that polygon, and the tool refuses v⁰ "
          "= 1/2 for both; "
          "seven points, or five in the lacunary space {1, x, cos s, sin s, cos 3s, sin 3s}, are enough.",
          {{"1a",
            "Cardioid, 12 points, 4-point scheme",
            Samples{cardioid, "0", "pi/6", 12, true},
            {{four, "cos(pi/6)", Expect::different}},
            "",
            true},
           {"1b",
            "Cardioid, 12 points, 6-point harmonic",
            Samples{cardioid, "0", "pi/6", 12, true},
            {{harmonic, "cos(pi/6)", Expect::exact}},
            "",
            true},
           {"1c",
            "Astroid, 6 points, 4-point scheme",
            Samples{astroid, "0", "pi/3", 6, true},
            {{four, "1/2", Expect::different},
             {harmonic8, "1/2", Expect::impossible},
             {lacunary, "1/2", Expect::impossible}},
            "",
            true},
           {"1d",
            "Astroid, 7 points, 8-point harmonic",
            Samples{astroid, "0", "2*pi/7", 7, true},
            {{harmonic8, "cos(2*pi/7)", Expect::exact}},
            "The paper names this space, (25), and gives no scheme for it.",
            true},
           {"1e",
            "Astroid, 5 points, 6-point lacunary",
            Samples{astroid, "0", "2*pi/5", 5, true},
            {{lacunary, "cos(2*pi/5)", Expect::exact}},
            "A scheme that is not in the paper: same cost as the three of section 4.",
            true}}};
}

Figure figure2() {
  Figure f{
      2,
      "Circles from regular polygons",
      "Regular 5-, 6- and 7-gons with v⁰ = cos(2π/κ), by all three schemes. Each v⁰ is admissible for each scheme.",
      {}};
  f.panels.push_back({"2a", "5-gon", Samples{circle, "pi/2", "2*pi/5", 5, true}, all_three("cos(2*pi/5)"), ""});
  f.panels.push_back({"2b", "6-gon", Samples{circle, "pi/2", "pi/3", 6, true}, all_three("1/2"), ""});
  f.panels.push_back({"2c", "7-gon", Samples{circle, "pi/2", "2*pi/7", 7, true}, all_three("cos(2*pi/7)"), ""});
  return f;
}

Figure figure3() {
  Figure f{3,
           "Conic sections",
           "Parabola, ellipse and hyperbola by all three schemes, with the paper’s v⁰ = 1, 1/2 and cosh(3/5).",
           {}};
  f.panels.push_back(
      {"3a", "Parabola", Samples{parabola, "-2", "1", 5, false}, all_three("1"), "Start and spacing are ours."});
  f.panels.push_back({"3b", "Ellipse", Samples{ellipse, "0", "pi/3", 6, true}, all_three("1/2"), "The axes are ours."});
  f.panels.push_back({"3c", "Hyperbola", Samples{hyperbola, "-6/5", "3/5", 5, false}, all_three("cosh(3/5)"),
                      "Start and number of points are ours."});
  return f;
}

Figure figure4() {
  return {4,
          "The catenary",
          "By all three schemes, with the paper’s v⁰ = cosh(2/5).",
          {{"4", "Catenary", Samples{catenary, "-8/5", "2/5", 9, false}, all_three("cosh(2/5)"),
            "Start and number of points are ours."}}};
}

Figure figure5() {
  Figure f{5,
           "Second-order curves from six points",
           "Six points at spacing π/3, v⁰ = 1/2, by the harmonic scheme of section 4.2.",
           {}};
  const auto add = [&](const char* id, const char* title, const Curve& curve, const char* first, const char* note) {
    f.panels.push_back({id, title, Samples{curve, first, "pi/3", 6, true}, {{harmonic, "1/2", Expect::exact}}, note});
  };
  add("5a", "Cardioid", cardioid, "0", "");
  add("5b", "Limaçon of Pascal", limacon, "0", "Ratio 2 is ours.");
  add("5c", "Deltoid", deltoid, "0", "");
  add("5d", "Piriform", piriform, "-pi/2", "");
  add("5e", "Lemniscate of Gerono", gerono, "0", "");
  add("5f", "Eight curve", eight, "pi/6", "The paper does not print its eight curve; this one is sampled from π/6 on.");
  return f;
}

Figure figure6() {
  const auto trial = std::vector<Trial>{{resonant, "cos(4*pi/5)", Expect::exact}};
  return {6,
          "Plane spirals",
          "Six points at spacing 4π/5, v⁰ = cos(4π/5), by the resonant scheme of section 4.3.",
          {{"6a", "Archimedean spiral", Samples{archimedes, "0", "4*pi/5", 6, false}, trial, ""},
           {"6b", "Involute of the circle", Samples{involute, "0", "4*pi/5", 6, false}, trial, ""}}};
}

Figure figure7() {
  return {7,
          "Space curves",
          "Helix by all three schemes, Viviani’s curve by the harmonic one, a conical spiral by the resonant one, with "
          "the paper’s v⁰ = "
          "cos(4π/5), cos(2π/5) and cos(4π/5).",
          {{"7a", "Helix", Samples{helix, "0", "4*pi/5", 6, false}, all_three("cos(4*pi/5)"),
            "Pitch and number of points are ours."},
           {"7b",
            "Viviani’s curve, 5 points",
            Samples{viviani, "0", "4*pi/5", 5, true},
            {{harmonic, "cos(2*pi/5)", Expect::exact}, {harmonic, "cos(4*pi/5)", Expect::different}},
            "The base frequency is 1/2, because z = 2 sin(s/2): samples at spacing u need v⁰ = cos(u/2), not cos u. "
            "The paper’s v⁰ belongs to "
            "the spacing 4π/5.",
            true},
           {"7b2",
            "Viviani’s curve, 10 points",
            Samples{viviani, "0", "2*pi/5", 10, true},
            {{harmonic, "cos(pi/5)", Expect::exact}, {harmonic, "cos(2*pi/5)", Expect::different}},
            "At spacing 2π/5 the right value is cos(π/5); v⁰ = cos(2π/5), the cosine of the spacing itself, gives "
            "another curve.",
            true},
           {"7c",
            "Conical spiral",
            Samples{conical, "0", "4*pi/5", 6, false},
            {{resonant, "cos(4*pi/5)", Expect::exact}},
            ""}}};
}

Figure tension(int number, const NamedScheme& scheme, const char* section, const std::vector<const char*>& values) {
  Figure f{number, std::string("Tension: section ") + section, "", {}};
  Panel p{std::to_string(number),
          std::string("One polygon, increasing v⁰, scheme of section ") + section,
          star,
          {},
          "Polygon and values of v⁰ are ours."};
  for (const char* v : values) p.trials.push_back({scheme, v, Expect::shape});
  f.panels.push_back(p);
  return f;
}

Figure comparison(int number, const char* title, const Polygon& polygon, const char* v0, const char* text) {
  Figure f{number, title, text, {}};
  const auto add = [&](const char* letter, const char* name, const NamedScheme& scheme, const char* v) {
    f.panels.push_back({std::to_string(number) + letter,
                        std::string(name) + (*v == 0 ? "" : std::string(", v⁰ = ") + v),
                        polygon,
                        {{scheme, v, Expect::shape}},
                        ""});
  };
  add("a", "Dubuc–Deslauriers 4-point", dubuc, "");
  add("b", "Weissmann 6-point", weissmann, "");
  add("c", "4-point with tension", four, v0);
  add("d", "6-point, section 4.1", mixed, v0);
  add("e", "6-point, section 4.2", harmonic, v0);
  add("f", "6-point, section 4.3", resonant, v0);
  return f;
}

std::vector<Figure> build() {
  return {figure1(),
          figure2(),
          figure3(),
          figure4(),
          figure5(),
          figure6(),
          figure7(),
          tension(8, mixed, "4.1", {"-4/5", "0", "1", "10", "1000"}),
          tension(9, harmonic, "4.2", {"1/4", "1/2", "1", "10", "1000"}),
          tension(10, resonant, "4.3", {"-1/2", "0", "1", "10", "1000"}),
          comparison(11, "Unevenly spaced points", uneven, "4",
                     "The same closed polygon, whose edges differ by a factor of about 5, by the two stationary "
                     "schemes and by the four with "
                     "tension, v⁰ = 4. The polygon is ours."),
          comparison(12, "Very unevenly spaced points", very_uneven, "7",
                     "A polygon whose longest edge is about 12 times its shortest, v⁰ = 7. The polygon is ours.")};
}

}  // namespace

const std::vector<NamedScheme>& closed_curve_schemes() {
  static const std::vector<NamedScheme> list = {four, mixed, resonant, harmonic, lacunary, harmonic8};
  return list;
}

const std::vector<Figure>& figures() {
  static const std::vector<Figure> list = build();
  return list;
}

}  // namespace twoscale::reports::romani2009
