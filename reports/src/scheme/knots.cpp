// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of a scheme on knots: a curve and its curvature, the choices of the knots, edge parameters.
#include <fmt/format.h>

#include "interactive.hpp"
#include "sections.hpp"
#include "twoscale/kernels/nonuniform.hpp"
#include "twoscale/reports/curves.hpp"
#include "twoscale/reports/html.hpp"

namespace twoscale::reports::scheme_page {

namespace {

using kernels::Parametrization;

constexpr int drawn_levels = 6;

// The sample polygon with an edge parameter of each edge, where they are not all 1/2.
kernels::PointSet sample_points(const std::vector<double>& lambda) {
  kernels::PointSet p;
  p.columns = kernels::default_columns(2);
  p.dim = 2;
  p.values = sample_polygon();
  if (lambda.empty()) return p;
  kernels::PointSet with;
  with.columns = p.columns;
  with.columns.emplace_back("lambda");
  with.dim = 3;
  for (std::size_t j = 0; j < p.size(); ++j)
    with.values.insert(with.values.end(), {p.values[2 * j], p.values[2 * j + 1], lambda[j]});
  return with;
}

std::vector<double> limit(const kernels::PointSet& points, kernels::KnotRule rule, Parametrization kind) {
  kernels::KnotOptions options;
  options.levels = drawn_levels;
  options.parametrization = kind;
  const kernels::PointSet fine = kernels::refine_on_knots(points, rule, options);
  std::vector<double> plane;
  for (std::size_t j = 0; j < fine.size(); ++j)
    plane.insert(plane.end(), {fine.values[j * fine.dim], fine.values[j * fine.dim + 1]});
  return plane;
}

}  // namespace

Part pictures_on_knots(const Subject& s) {
  Part part;
  const auto rule = kernels::find_knot_rule(s.scheme.kernel);
  if (!rule) return part;
  const kernels::PointSet points = sample_points({});
  const Line polygon = polygon_line(points.values, true);
  part.files.emplace_back("data/polygon.csv", kernels::to_csv(points));
  part.html = "<div class=\"panels\">\n";
  const auto add = [&](const char* name, const char* title, std::vector<Line> lines,
                       std::vector<std::string> commands) {
    Picture picture;
    picture.lines = std::move(lines);
    part.html += figure(part, {name, title, "", std::move(commands), false}, picture);
  };
  const auto command = [&](const char* kind, const std::string& more, const char* file, const char* image) {
    return fmt::format("twoscale plot {} {}{} data/{}.csv -o {}.svg", kind, s.name, more, file, image);
  };

  const std::vector<double> curve = limit(points, *rule, Parametrization::centripetal);
  add("curve", "A closed curve, centripetal knots", {polygon, curve_line(curve, true, "limit curve", 0)},
      {command("curve", "", "polygon", "curve")});
  std::vector<Line> comb = curvature_comb(curve, true);
  comb.push_back(curve_line(curve, true, "limit curve", 0));
  add("comb", "Its curvature", std::move(comb), {command("comb", "", "polygon", "comb")});

  std::vector<Line> choices = {polygon};
  std::vector<std::string> commands;
  for (const auto& [kind, name] :
       {std::pair(Parametrization::uniform, "uniform"), std::pair(Parametrization::centripetal, "centripetal"),
        std::pair(Parametrization::chordal, "chordal")}) {
    choices.push_back(curve_line(limit(points, *rule, kind), true, name, static_cast<int>(commands.size())));
    commands.push_back(command("curve", std::string(" --parametrization ") + name, "polygon", name));
  }
  add("knots", "Knots from the points", std::move(choices), std::move(commands));

  if (*rule != kernels::KnotRule::lagrange4) {
    // The edges on both sides of vertex 4: one that carries 1 and one that carries 0 make a crease there.
    std::vector<double> lambda(points.size(), 0.5);
    lambda[3] = 1;
    lambda[4] = 0;
    const kernels::PointSet creased = sample_points(lambda);
    lambda[4] = 0.5;
    const kernels::PointSet pulled = sample_points(lambda);
    part.files.emplace_back("data/crease.csv", kernels::to_csv(creased));
    part.files.emplace_back("data/one-edge.csv", kernels::to_csv(pulled));
    add("lambda", "Edge parameters before and after the fifth vertex",
        {polygon, curve_line(curve, true, "1/2, 1/2", 0),
         curve_line(limit(pulled, *rule, Parametrization::centripetal), true, "1, 1/2", 1),
         curve_line(limit(creased, *rule, Parametrization::centripetal), true, "1, 0: a crease", 2)},
        {command("curve", "", "one-edge", "one-edge"), command("curve", "", "crease", "crease")});
  }
  part.html += "</div>\n";
  part.numbers = {{"levels_drawn", drawn_levels}};
  return part;
}

}  // namespace twoscale::reports::scheme_page
