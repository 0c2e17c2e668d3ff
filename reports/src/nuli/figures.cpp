// SPDX-License-Identifier: GPL-3.0-or-later
// The figures: interpolants from the splines, basis functions, limit curves and the schemes they are compared with.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include "nuli/sections.hpp"
#include "twoscale/kernels/points_io.hpp"
#include "twoscale/reports/curves.hpp"
#include "twoscale/reports/html.hpp"
#include "twoscale/symbolic/ball.hpp"

namespace twoscale::reports::nuli {

namespace {

using kernels::Boundary;
using kernels::KnotRule;
using kernels::Parametrization;
using Polygon = kernels::KnotPolygon<double>;
using EdgeParameters = std::vector<std::pair<std::size_t, double>>;

constexpr int levels = 7;
constexpr int samples = 24;  // of a spline on half an edge

const FundamentalFamily quadratic = {3, 3, 2};
const FundamentalFamily cubic = {4, 4, 3};

std::vector<double> limit(const Polygon& p, KnotRule rule) {
  return kernels::refine_knots(p, rule, levels, Boundary::closed).points;
}

// Knots taken from the points before every step.
std::vector<double> iterated(Polygon p, KnotRule rule, Parametrization kind) {
  for (int k = 0; k < levels; ++k) p = kernels::refine_knots(with_knots(std::move(p), kind), rule, 1, Boundary::closed);
  return p.points;
}

struct Curve {
  std::string title;
  std::vector<double> points;
  int colour;
};

// Part of the plane that a picture shows.
struct Window {
  double left, bottom, right, top;
};

// The pieces of a closed curve within a window.
std::vector<std::vector<double>> pieces_in(const std::vector<double>& curve, const Window& w) {
  std::vector<std::vector<double>> pieces(1);
  const std::size_t n = curve.size() / 2;
  for (std::size_t j = 0; j <= n; ++j) {
    const double x = curve[2 * (j % n)], y = curve[2 * (j % n) + 1];
    if (x >= w.left && x <= w.right && y >= w.bottom && y <= w.top)
      pieces.back().insert(pieces.back().end(), {x, y});
    else if (!pieces.back().empty())
      pieces.emplace_back();
  }
  std::erase_if(pieces, [](const auto& p) { return p.size() < 4; });
  return pieces;
}

Picture picture_of(const Polygon& polygon, const std::vector<Curve>& curves, const Window* window) {
  Picture p;
  p.height = 400;
  const auto add = [&](const std::vector<double>& points, Line::Style style, const std::string& title, int colour) {
    Line l;
    l.style = style;
    l.colour = colour;
    l.title = title;
    if (window == nullptr) {
      l.values = points;
      l.closed = true;
      p.lines.push_back(std::move(l));
      return;
    }
    for (auto& piece : pieces_in(points, *window)) {
      l.values = std::move(piece);
      p.lines.push_back(l);
      l.title.clear();
    }
  };
  if (window == nullptr) add(polygon.points, Line::Style::polygon, "", 0);
  for (const Curve& c : curves) add(c.points, Line::Style::curve, c.title, c.colour);
  if (window != nullptr) {
    Line vertices;
    vertices.style = Line::Style::points;
    vertices.colour = 4;
    for (std::size_t j = 0; j < polygon.size(); ++j) {
      const double x = polygon.points[2 * j], y = polygon.points[2 * j + 1];
      if (x >= window->left && x <= window->right && y >= window->bottom && y <= window->top)
        vertices.values.insert(vertices.values.end(), {x, y});
    }
    if (!vertices.values.empty()) p.lines.push_back(std::move(vertices));
  }
  return p;
}

std::string data_file(Part& part, const std::string& name, const Polygon& p) {
  kernels::PointSet set;
  set.columns = {"x", "y", "lambda", "tag"};
  set.dim = 4;
  for (std::size_t j = 0; j < p.size(); ++j)
    set.values.insert(set.values.end(),
                      {p.points[2 * j], p.points[2 * j + 1], p.lambda[j], static_cast<double>(p.tagged[j])});
  const std::string file = "data/" + name + ".csv";
  if (std::none_of(part.files.begin(), part.files.end(), [&](const auto& f) { return f.first == file; }))
    part.files.emplace_back(file, kernels::to_csv(set));
  return file;
}

// A panel: curves of one polygon, and what was measured on them.
std::string panel(Part& part, const std::string& id, const std::string& title, const Polygon& polygon,
                  const std::vector<Curve>& curves, const std::vector<std::string>& commands = {},
                  const Window* window = nullptr) {
  std::string rows;
  if (window == nullptr) {
    rows = "<table><thead><tr><th>curve</th><th>distance to polygon</th><th>turning</th></tr></thead><tbody>\n";
    for (const Curve& c : curves) {
      const double distance = distance_to_polygon({c.points, 2, 0, 1}, polygon.points, true);
      const double turning = total_turning(c.points, true);
      rows += fmt::format("<tr><td>{}</td><td>{}</td><td>{:.3f}</td></tr>\n", escaped(c.title), number_text(distance),
                          turning);
      part.numbers.push_back({{"panel", id}, {"curve", c.title}, {"polygon_distance", distance}, {"turning", turning}});
    }
    rows += "</tbody></table>";
  }
  return figure(part, {id, title, rows, commands}, picture_of(polygon, curves, window));
}

std::string draw_command(const std::string& rule, const std::string& file, const std::string& more = "") {
  return "twoscale plot curve " + rule + " --levels " + std::to_string(levels) + " " + more + file + " -o curve.svg";
}

Section section(const std::string& number, const std::string& title) {
  Section s{"figure-" + number, "Figure " + number, "Figure " + number + ": " + title, {}};
  s.part.numbers = nlohmann::ordered_json::array();
  return s;
}

void close(Section& s, const std::string& text, const std::string& panels) {
  s.part.html = "<p>" + text + "</p>\n<div class=\"panels\">\n" + panels + "</div>\n";
}

Curve spline(const std::string& title, const Polygon& p, const FundamentalFamily& f, int colour) {
  return {title, interpolant(p, f, samples), colour};
}

std::string family_text(const FundamentalFamily& f) { return fmt::format("ρ = {}, μ = {}", f.reproduction, f.mu); }

// ---- Figures 2.1-2.4: interpolants

Section figure_2_1() {
  Section s = section("2.1", "the parametrization");
  const Polygon p = hand();
  const Polygon u = with_knots(p, Parametrization::uniform);
  close(s,
        "The quadratic interpolant (order 3, ρ = 3, μ = 2) on equal and on centripetal knots: the first swings out "
        "beside the short edges.",
        panel(s.part, "2.1a", "Uniform knots", u, {spline("interpolant", u, quadratic, 0)}) +
            panel(s.part, "2.1b", "Centripetal knots", p, {spline("interpolant", p, quadratic, 0)}));
  return s;
}

Section figure_2_2() {
  Section s = section("2.2", "unsymmetric supports");
  const Polygon p = hand();
  std::string panels;
  for (const auto& [id, f] :
       {std::pair("2.2a", FundamentalFamily{4, 1, 2}), std::pair("2.2b", FundamentalFamily{4, 3, 2}),
        std::pair("2.2c", FundamentalFamily{4, 3, 3})})
    panels += panel(s.part, id, family_text(f), p, {spline("interpolant", p, f, 0)});
  close(
      s,
      "Cubic interpolants (order 4) on centripetal knots. Only ρ = 2, μ = 2 and ρ = 4, μ = 3 have symmetric supports.",
      panels);
  return s;
}

Section figure_2_3() {
  Section s = section("2.3", "the order of the polynomials reproduced");
  const Polygon p = hand();
  std::string panels;
  for (const auto& [id, f] : {std::pair("2.3a", FundamentalFamily{4, 2, 2}), std::pair("2.3b", cubic)})
    panels += panel(s.part, id, family_text(f), p, {spline("interpolant", p, f, 0)});
  close(s, "The two symmetric cubic interpolants on centripetal knots.", panels);
  return s;
}

// A closed quadrilateral whose centripetal knots are those of the caption, edges proportional to their squares.
Polygon quadrilateral(const std::array<double, 4>& d, const std::array<double, 4>& lambda) {
  Polygon p;
  p.dim = 2;
  // A kite: edges a, b, b, a.
  const double a = d[0] * d[0] * 16, b = d[1] * d[1] * 16, height = 0.8 * std::min(a, b);
  p.points = {std::sqrt(a * a - height * height), 0, 0, height, -std::sqrt(b * b - height * height), 0, 0, -height};
  p.d.assign(d.begin(), d.end());
  p.lambda.assign(lambda.begin(), lambda.end());
  p.tagged.assign(4, 1);
  return p;
}

Section figure_2_4() {
  Section s = section("2.4", "the place of the auxiliary knots");
  const auto lambda = [](double t0, double t, double t1) { return (t - t0) / (t1 - t0); };
  const Polygon left =
      quadrilateral({0.25, 0.25, 0.25, 0.25}, {0.5, lambda(0.25, 0.475, 0.5), lambda(0.5, 0.525, 0.75), 0.5});
  const Polygon right = quadrilateral({0.24, 0.26, 0.26, 0.24}, {lambda(0, 0.125, 0.24), lambda(0.24, 0.25, 0.5),
                                                                 lambda(0.5, 0.75, 0.76), lambda(0.76, 0.875, 1)});
  close(s,
        "Quadratic interpolants of quadrilaterals whose centripetal knots are those of the two captions, with their "
        "auxiliary knots: close together at the third vertex, close to the second and fourth.",
        panel(s.part, "2.4a", "Auxiliary knots 0.125, 0.475, 0.525, 0.875", left,
              {spline("interpolant", left, quadratic, 0)}) +
            panel(s.part, "2.4b", "Auxiliary knots 0.125, 0.25, 0.75, 0.875", right,
                  {spline("interpolant", right, quadratic, 0)}));
  return s;
}

// ---- Figures 3.1, 3.3, 3.4: functions

// v_{3,2,0} on the knots x, auxiliary knots in the middle: a line for each piece.
std::string pieces_panel(Part& part, const std::string& id, const std::string& title, const std::vector<Rational>& d,
                         bool moved) {
  const long half = static_cast<long>(d.size()) / 2;
  std::vector<Rational> wide(16, Rational(1)), lambda(16, Rational(1, 2));
  for (long e = 0; e < static_cast<long>(d.size()); ++e)
    wide[static_cast<std::size_t>(8 - half + e)] = d[static_cast<std::size_t>(e)];
  const Knots<Rational> t(-8, wide, lambda);
  Picture p;
  p.equal_axes = false;
  p.height = 340;
  const auto number = [](const Rational& x) { return arf_get_d(arb_midref(Ball(x, 80).raw()), ARF_RND_NEAR); };
  for (long piece = -4; piece < 4; ++piece) {
    Line l;
    l.colour = static_cast<int>(piece + 4);
    l.title = fmt::format("v{}", piece + 5);
    const Rational length = t(piece + 1) - t(piece);
    for (int k = 0; k <= 32; ++k) {
      const Rational x = t(piece) + length * Rational(k, 32);
      const auto v = fundamental_values(t, quadratic, x, piece);
      Rational place = x;
      if (moved) {  // every edge becomes [0, 1/2]
        const long edge = piece >= 0 ? piece / 2 : -((1 - piece) / 2);
        place = (x - t.x(edge)) / (t.x(edge + 1) - t.x(edge)) * Rational(1, 2);
      }
      l.values.insert(l.values.end(), {number(place), number(v[8])});
    }
    p.lines.push_back(std::move(l));
  }
  return figure(part, {id, title, "", {}}, p);
}

Section figure_3_1() {
  Section s = section("3.1", "the eight pieces of a fundamental spline of order 3");
  const std::vector<Rational> equal(4, Rational(1)), uneven = {Rational(6, 5), 1, Rational(1, 2), Rational(4, 5)};
  close(s, "Knots −2, −1, 0, 1, 2 and −2.2, −1, 0, 0.5, 1.3; the pieces counted from the left.",
        pieces_panel(s.part, "3.1a", "Uniform knots", equal, false) +
            pieces_panel(s.part, "3.1b", "Non-uniform knots", uneven, false) +
            pieces_panel(s.part, "3.1c", "Non-uniform knots, each edge moved to [0, 0.5]", uneven, true));
  return s;
}

// The limit of the data 1 at one vertex, over the knots.
Line basis(KnotRule rule, const std::vector<double>& d, const std::vector<double>& lambda, bool tagged) {
  Polygon p;
  p.dim = 1;
  p.closed = false;
  p.d = d;
  p.lambda = lambda;
  const std::size_t centre = d.size() / 2;
  p.points.assign(d.size() + 1, 0);
  p.points[centre] = 1;
  p.tagged.assign(p.points.size(), 0);
  if (tagged) p.tagged[centre] = 1;
  double x = 0;
  for (std::size_t e = 0; e < centre; ++e) x -= d[e];
  const Polygon fine = kernels::refine_knots(p, rule, 8, Boundary::space);
  Line l;
  for (std::size_t j = 0; j < fine.size(); ++j) {
    l.values.insert(l.values.end(), {x, fine.points[j]});
    if (j < fine.d.size()) x += fine.d[j];
  }
  return l;
}

std::string basis_panel(Part& part, const std::string& id, const std::string& title, const std::vector<double>& d,
                        double left, double right) {
  std::vector<double> lambda(d.size(), 0.5);
  lambda[d.size() / 2 - 1] = left;
  lambda[d.size() / 2] = right;
  Picture p;
  p.equal_axes = false;
  p.height = 340;
  for (const auto& [rule, name] : {std::pair(KnotRule::nuli4, "nuli4"), std::pair(KnotRule::nuli6, "nuli6")}) {
    Line l = basis(rule, d, lambda, true);
    l.title = name;
    l.colour = rule == KnotRule::nuli4 ? 0 : 4;
    p.lines.push_back(std::move(l));
  }
  return figure(part, {id, title, "", {}}, p);
}

const std::vector<double> equal_knots(14, 1.0);

Section figure_3_3() {
  Section s = section("3.3", "basis functions");
  close(s,
        "All edge parameters 1/2. The support is [−3, 3] in vertices for the 4-point scheme, [−5, 5] for the 6-point "
        "one.",
        basis_panel(s.part, "3.3a", "Uniform knots", equal_knots, 0.5, 0.5) +
            basis_panel(s.part, "3.3b", "Non-uniform knots", {1, 1, 1, 2, 0.5, 2, 1, 0.25, 1.5, 0.5, 2, 1, 1, 1}, 0.5,
                        0.5));
  return s;
}

Section figure_3_4() {
  Section s = section("3.4", "basis functions with edge parameters");
  close(s,
        "Uniform knots; the vertex in the middle is tagged. At (1, 0) the 4-point scheme has a crease, the 6-point one "
        "has not.",
        basis_panel(s.part, "3.4a", "λ = 0.1 and 0.9", equal_knots, 0.1, 0.9) +
            basis_panel(s.part, "3.4b", "λ = 1 and 0", equal_knots, 1, 0));
  return s;
}

// ---- Figures 5.1-5.7: curves

const Window upper_right = {3.3, 2.6, 4.9, 4.2}, lower_right = {5.6, -0.8, 6.9, 0.5};

Section figure_5_1() {
  Section s = section("5.1", "the 4-point scheme and the quadratic interpolant");
  const Polygon p = hand();
  const std::string file = data_file(s.part, "hand", p);
  close(s, "Centripetal knots, edge parameters 1/2.",
        panel(s.part, "5.1a", "nuli4", p, {{"nuli4", limit(p, KnotRule::nuli4), 0}}, {draw_command("nuli4", file)}) +
            panel(s.part, "5.1b", "Quadratic NULIFS interpolant", p, {spline("interpolant", p, quadratic, 6)}));
  return s;
}

Section figure_5_2() {
  Section s = section("5.2", "both together, with two details");
  const Polygon p = hand();
  const std::vector<Curve> both = {{"nuli4", limit(p, KnotRule::nuli4), 0}, spline("interpolant", p, quadratic, 6)};
  const double scheme = distance_to_polygon({both[0].points, 2, 0, 1}, p.points, true);
  const double spline_distance = distance_to_polygon({both[1].points, 2, 0, 1}, p.points, true);
  close(
      s,
      fmt::format("Remark 2.2 says that the subdivision curve is the tighter one. On this polygon its largest distance "
                  "to the polygon is {} of the size, that of the interpolant {}.",
                  number_text(scheme), number_text(spline_distance)),
      panel(s.part, "5.2a", "nuli4 and the quadratic interpolant", p, both) +
          panel(s.part, "5.2b", "Detail", p, both, {}, &upper_right) +
          panel(s.part, "5.2c", "Detail", p, both, {}, &lower_right));
  return s;
}

Section figure_5_3() {
  Section s = section("5.3", "creases");
  const Polygon p = with_edge_parameters(hand(), {{1, 1}, {2, 0}, {4, 1}, {5, 0}});
  const std::string file = data_file(s.part, "creases", p);
  const Curve c{"nuli4", limit(p, KnotRule::nuli4), 0};
  close(s,
        "λ<sub>1</sub> = 1, λ<sub>2</sub> = 0 and λ<sub>4</sub> = 1, λ<sub>5</sub> = 0: creases at the points 2 and 5.",
        panel(s.part, "5.3a", "nuli4 with two creases", p, {c}, {draw_command("nuli4", file)}) +
            panel(s.part, "5.3b", "Detail", p, {c}, {}, &upper_right));
  return s;
}

Section figure_5_4() {
  Section s = section("5.4", "edge parameters");
  std::string panels;
  const std::tuple<const char*, const char*, EdgeParameters> rows[] = {
      {"5.4a", "λ₁ = 0.9, λ₂ = 0.1, λ₄ = 0.9, λ₅ = 0.1", {{1, 0.9}, {2, 0.1}, {4, 0.9}, {5, 0.1}}},
      {"5.4b", "λ₁ = 1, λ₅ = 1", {{1, 1}, {5, 1}}}};
  for (const auto& [id, title, parameters] : rows) {
    const Polygon p = with_edge_parameters(hand(), parameters);
    const std::string file = data_file(s.part, std::string("edges-") + id, p);
    panels +=
        panel(s.part, id, title, p, {{"nuli4", limit(p, KnotRule::nuli4), 0}, spline("interpolant", p, quadratic, 6)},
              {draw_command("nuli4", file)});
  }
  close(s, "The 4-point scheme beside the quadratic interpolant with the same edge parameters.", panels);
  return s;
}

Section figure_5_5() {
  Section s = section("5.5", "the 6-point scheme and the cubic interpolant");
  const Polygon p = hand();
  const std::string file = data_file(s.part, "hand", p);
  close(s, "Centripetal knots, edge parameters 1/2.",
        panel(s.part, "5.5a", "nuli6", p, {{"nuli6", limit(p, KnotRule::nuli6), 4}}, {draw_command("nuli6", file)}) +
            panel(s.part, "5.5b", "Cubic NULIFS interpolant", p, {spline("interpolant", p, cubic, 6)}));
  return s;
}

Section figure_5_6() {
  Section s = section("5.6", "the 6-point scheme beside the cubic interpolant and the 4-point scheme");
  const Polygon p = hand();
  const Curve six{"nuli6", limit(p, KnotRule::nuli6), 4};
  const std::vector<Curve> left = {six, spline("interpolant", p, cubic, 6)},
                           right = {six, {"nuli4", limit(p, KnotRule::nuli4), 0}};
  close(s, "Centripetal knots, edge parameters 1/2.",
        panel(s.part, "5.6a", "nuli6 and the cubic interpolant", p, left) +
            panel(s.part, "5.6b", "nuli6 and nuli4", p, right) +
            panel(s.part, "5.6c", "Detail of the first", p, left, {}, &upper_right) +
            panel(s.part, "5.6d", "Detail of the second", p, right, {}, &upper_right));
  return s;
}

Section figure_5_7() {
  Section s = section("5.7", "other schemes");
  const Polygon p = hand();
  const std::string file = data_file(s.part, "hand", p);
  struct Row {
    const char *id, *title, *rule, *options;
    KnotRule knot_rule;
    std::optional<Parametrization> again;
    int colour;
  };
  const Row rows[] = {
      {"5.7a", "nuli4", "nuli4", "", KnotRule::nuli4, {}, 0},
      {"5.7b", "Dyn, Floater and Hormann, iterated centripetal", "lagrange4", "--reparametrize ", KnotRule::lagrange4,
       Parametrization::centripetal, 1},
      {"5.7c", "Dyn, Floater and Hormann, iterated chordal", "lagrange4", "--parametrization chordal --reparametrize ",
       KnotRule::lagrange4, Parametrization::chordal, 6},
      {"5.7d", "Daubechies, Guskov and Sweldens, centripetal", "lagrange4", "", KnotRule::lagrange4, {}, 2},
      {"5.7e", "nuli4, iterated centripetal", "nuli4", "--reparametrize ", KnotRule::nuli4,
       Parametrization::centripetal, 3}};
  std::string panels;
  for (const Row& r : rows)
    panels += panel(s.part, r.id, r.title, p,
                    {{r.title, r.again ? iterated(p, r.knot_rule, *r.again) : limit(p, r.knot_rule), r.colour}},
                    {draw_command(r.rule, file, r.options)});
  close(s,
        "The same points. With edge parameters 1/2 the curves differ little, as the paper says; iterated chordal knots "
        "are "
        "added.",
        panels);
  return s;
}

}  // namespace

Section precision_section() {
  Section s{"precision", "Precision", "Polynomials on arbitrary knots", {}};
  Part& part = s.part;
  part.numbers = nlohmann::ordered_json::array();
  const std::vector<double> d = {1, 0.125, 3, 0.5, 0.25, 2, 4, 0.0625, 1};
  std::string rows;
  for (const auto& [name, rule, degree] :
       {std::tuple("nuli4", KnotRule::nuli4, 2), std::tuple("nuli6", KnotRule::nuli6, 3),
        std::tuple("lagrange4", KnotRule::lagrange4, 3)}) {
    Polygon p;
    p.dim = 2;
    p.closed = false;
    p.d = d;
    double x = -5;
    const auto at = [&, power = degree](double u) { return std::pow(u / 5, power); };
    for (std::size_t j = 0; j <= d.size(); ++j) {
      p.points.insert(p.points.end(), {x, at(x)});
      if (j < d.size()) x += d[j];
    }
    for (std::size_t e = 0; e < d.size(); ++e) p.lambda.push_back(static_cast<double>(e % 5) / 4);
    p.tagged.assign(p.size(), 1);
    const Polygon fine = kernels::refine_knots(p, rule, 6, Boundary::space);
    double largest = 0;
    for (std::size_t j = 0; j < fine.size(); ++j)
      largest = std::max(largest, std::abs(fine.points[2 * j + 1] - at(fine.points[2 * j])));
    const double size = std::hypot(fine.points[fine.points.size() - 2] - fine.points[0], 2);
    part.exact_run(largest / size);
    rows += fmt::format("<tr><td>{}</td><td>x<sup>{}</sup></td><td>{}</td></tr>\n", name, degree,
                        number_text(largest / size));
    part.numbers.push_back({{"scheme", name}, {"degree", degree}, {"deviation", largest / size}});
  }
  part.html =
      "<p>Samples of a power on knots with intervals from 1/16 to 4, edge parameters 0, 1/4, 1/2, 3/4, 1 in turn, end "
      "rule "
      "<code>space</code>, six steps: how far the points are from the graph, over its size. That it is kept exactly is "
      "proved above and tested in rational arithmetic.</p>\n<table class=\"narrow\"><thead><tr><th>scheme</th><th>power"
      "</th><th>deviation</th></tr></thead><tbody>\n" +
      rows + "</tbody></table>\n";
  return s;
}

std::vector<Section> figure_sections(const PaperOptions& options) {
  std::vector<Section> list;
  for (Section (*make)() : {figure_2_1, figure_2_2, figure_2_3, figure_2_4, figure_3_1, figure_3_3, figure_3_4,
                            figure_5_1, figure_5_2, figure_5_3, figure_5_4, figure_5_5, figure_5_6, figure_5_7}) {
    if (options.progress) options.progress("figures");
    list.push_back(make());
  }
  return list;
}

}  // namespace twoscale::reports::nuli
