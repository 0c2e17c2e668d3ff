// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 6 and 7: surfaces returned from their samples, and wine glasses.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sections.hpp"
#include "twoscale/reports/html.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::reports::jeong2013 {

namespace {

using kernels::Boundary;
using kernels::PointGrid;
using lowering::Direction;
using lowering::ParametricSurface;
using lowering::RefinedGrid;
using lowering::Summand;
using lowering::SurfaceMethod;

constexpr unsigned measured_levels = 4;
constexpr double drawn_quads = 1300;

const std::vector<std::string> coordinates = {"x", "y", "z"};

// The description that `twoscale surface` reads.
std::string description(const Surface& s) {
  std::string text = "# jeong2013, Example 6.2: " + s.title + "\n";
  for (std::size_t c = 0; c < 3; ++c) text += fmt::format("{} = \"{}\"\n", coordinates[c], s.formulas[c]);
  const auto axis = [&](const char* name, const std::string& first, const std::string& step, long count, bool closed) {
    text += fmt::format("[{}]\nfirst = \"{}\"\nstep = \"{}\"\ncount = {}\n", name, first, step, count);
    if (!closed) text += "ends = \"given\"\n";
  };
  axis("u", "0", s.u_step, s.u_count, true);
  axis("v", s.v_first, s.v_step, s.v_count, s.v_closed);
  return text;
}

struct Way {
  std::string name;
  std::vector<Summand> summands;
  RefinedGrid refined;
  double deviation = 0;
};

Way follow(std::string name, const ParametricSurface& surface, std::vector<Summand> summands) {
  Way w{std::move(name), std::move(summands), {}, 0};
  w.refined = lowering::refine_sum(w.summands, 0);
  w.deviation = lowering::estimate_largest_deviation(w.refined, surface);
  return w;
}

// One pair of schemes of the least frequencies alone: what a single tensor product of 4-point schemes gives.
std::vector<Summand> one_pair(const ParametricSurface& surface) {
  std::vector<Summand> pair = lowering::summands(surface, SurfaceMethod::space, measured_levels, measured_levels, 0);
  const auto least = [](Direction& d) {
    const Space& space = *d.scheme.space;
    std::string items = "1, x";
    if (const auto list = space.items(); list.size() > 2) items += ", " + list[2] + ", " + list[3];
    d.scheme = make_scheme("interpolating:space=\"" + items + "\"");
    d.binding = lowering::bind(d.scheme, std::nullopt, std::nullopt, {});
  };
  least(pair[0].u);
  least(pair[0].v);
  pair[0].grid = lowering::sampled(surface, pair[0].u.scheme, pair[0].v.scheme, pair[0].rounded_digits);
  return pair;
}

// The same surface from as few samples as determine it.
ParametricSurface sparse(const Surface& s) {
  Surface few = s;
  few.u_count = std::lround(static_cast<double>(s.u_count) * parametric(s).u.line.estimate(1) /
                            SampleLine::parse("0", s.u_least_step).estimate(1));
  few.u_step = s.u_least_step;
  if (s.v_closed) {
    few.v_count = std::lround(static_cast<double>(s.v_count) * parametric(s).v.line.estimate(1) /
                              SampleLine::parse("0", s.v_least_step).estimate(1));
    few.v_step = s.v_least_step;
  }
  return parametric(few);
}

std::string points_of(const Scheme& s) { return std::to_string(s.space->dimension()) + "-point"; }

std::string pairs_text(const Way& w) {
  std::vector<std::string> seen;
  std::string text;
  for (const Summand& m : w.summands) {
    const std::string pair = points_of(m.u.scheme) + " × " + points_of(m.v.scheme);
    if (std::find(seen.begin(), seen.end(), pair) != seen.end()) continue;
    seen.push_back(pair);
    text += (text.empty() ? "" : ", ") + pair;
  }
  return text;
}

// Fewer rows and columns: about `drawn_quads` quads, as nearly square on average as the grid allows.
Sheet thinned(const PointGrid& grid, kernels::Closings closings) {
  const auto [rows, columns] = grid.size;
  const auto point = [&](std::size_t i, std::size_t j) { return &grid.points.values[3 * (i * columns + j)]; };
  const auto distance = [](const double* a, const double* b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  };
  double along_u = 0, along_v = 0;
  for (std::size_t i = 0; i + 1 < rows; ++i)
    for (std::size_t j = 0; j + 1 < columns; ++j) {
      along_u += distance(point(i, j), point(i + 1, j));
      along_v += distance(point(i, j), point(i, j + 1));
    }
  const double length_u = along_u / static_cast<double>(columns), length_v = along_v / static_cast<double>(rows);
  // Every step-th index. A closed direction is cut evenly, so that a surface that closes with a twist fits itself.
  const auto kept = [](std::size_t n, bool closed, double most) {
    auto step = static_cast<std::size_t>(std::max(1.0, std::round(static_cast<double>(n) / most)));
    while (closed && n % step != 0) --step;
    std::vector<std::size_t> list;
    for (std::size_t i = 0; i < n; i += step) list.push_back(i);
    if (!closed && list.back() != n - 1) list.push_back(n - 1);
    return list;
  };
  const auto some_rows = kept(rows, closings.u, std::max(8.0, std::sqrt(drawn_quads * length_u / length_v)));
  const auto some_columns = kept(columns, closings.v, std::max(8.0, std::sqrt(drawn_quads * length_v / length_u)));
  Sheet s{{}, {some_rows.size(), some_columns.size()}, closings};
  for (const std::size_t i : some_rows)
    for (const std::size_t j : some_columns) s.values.insert(s.values.end(), point(i, j), point(i, j) + 3);
  return s;
}

// The part that is drawn: all rows, or the first ones of a surface that is covered twice.
SurfacePicture picture(const Surface& s, const RefinedGrid& refined) {
  PointGrid grid = refined.grid;
  kernels::Closings closings = *refined.grid.closings;
  if (s.drawn_rows > 0) {
    grid.size.rows = (static_cast<std::size_t>(s.drawn_rows) << measured_levels) + 1;
    grid.points.values.resize(grid.size.rows * grid.size.columns * 3);
    closings.u = false;
  }
  SurfacePicture p;
  p.sheet = thinned(grid, closings);
  return p;
}

std::string surface_html(const Surface& s, Part& part) {
  const ParametricSurface surface = parametric(s);
  std::vector<Way> ways;
  ways.push_back(follow("one pair for all frequencies", surface,
                        lowering::summands(surface, SurfaceMethod::space, measured_levels, measured_levels, 0)));
  ways.push_back(follow("sum of pairs", surface,
                        lowering::summands(surface, SurfaceMethod::sum, measured_levels, measured_levels, 0)));
  const ParametricSurface few = sparse(s);
  ways.push_back(follow("one pair, fewest samples", few,
                        lowering::summands(few, SurfaceMethod::space, measured_levels, measured_levels, 0)));
  ways.push_back(follow("one pair of the least frequencies", surface, one_pair(surface)));
  std::string rows;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const Way& w = ways[i];
    const bool exact = w.deviation < 1e-12;
    if (i < 3) part.exact_run(w.deviation);
    const auto& samples = w.summands[0].grid.size;
    rows += fmt::format("<tr><td>{}</td><td>{} × {}</td><td>{}</td><td>{}</td><td class=\"{}\">{}</td></tr>\n", w.name,
                        samples.rows, samples.columns, w.summands.size(), pairs_text(w), exact ? "proved" : "refuted",
                        number_text(w.deviation));
    nlohmann::ordered_json j{{"surface", s.id},
                             {"way", w.name},
                             {"rows", samples.rows},
                             {"columns", samples.columns},
                             {"tensor_products", w.summands.size()},
                             {"refined_points", w.refined.grid.points.size()},
                             {"deviation", w.deviation}};
    part.numbers.push_back(j);
  }
  part.files.emplace_back("data/" + s.id + ".toml", description(s));
  std::string html = "<br/>";
  for (std::size_t c = 0; c < 3; ++c)
    html += formula("<mi>" + coordinates[c] + "</mi><mo>=</mo>", s.formulas[c]) + (c < 2 ? "<br/>" : "");
  const auto list = [](const std::vector<long>& n) {
    std::string text;
    for (const long k : n) text += (text.empty() ? "" : ", ") + std::to_string(k);
    return text;
  };
  const std::vector<long> u = turns(surface.coordinates, Axis::u, surface.u.line, s.u_count);
  html += fmt::format("<br/>Turns along u over {} samples: {}; {} samples determine them.", s.u_count, list(u),
                      least_closed_samples(u));
  if (s.v_closed) {
    const std::vector<long> v = turns(surface.coordinates, Axis::v, surface.v.line, s.v_count);
    html += fmt::format(" Along v over {}: {}; {} determine them.", s.v_count, list(v), least_closed_samples(v));
  } else {
    html += " Along v the surface is open; samples beyond the ends come from the same formula.";
  }
  if (!s.note.empty()) html += "<br/><em>" + escaped(s.note) + "</em>";
  html +=
      "\n<table><thead><tr><th>way</th><th>samples</th><th>tensor products</th><th>schemes, u × v</th><th>largest "
      "deviation</th></tr></thead><tbody>\n" +
      rows + "</tbody></table>\n";
  return figure(part,
                {s.id,
                 s.title,
                 html,
                 {fmt::format("twoscale surface data/{0}.toml --levels {1} -o {0}.svg", s.id, measured_levels),
                  fmt::format("twoscale surface data/{}.toml --explain", s.id)}},
                picture(s, ways[0].refined));
}

// ---- Figure 7

// Radius and height along the profile, from foot to rim.
const std::vector<std::pair<double, double>> profile = {{1.5, 0},   {1.2, 0.1},  {0.35, 0.35}, {0.18, 1.0},
                                                        {0.2, 1.8}, {1.15, 2.3}, {1.45, 3.3},  {1.0, 4.6}};

PointGrid control_polyhedron() {
  PointGrid grid;
  grid.size = {profile.size(), 4};
  grid.points.columns = coordinates;
  grid.points.dim = 3;
  for (const auto& [r, z] : profile)
    for (const auto& [c, s] : {std::pair(1, 0), std::pair(0, 1), std::pair(-1, 0), std::pair(0, -1)})
      grid.points.values.insert(grid.points.values.end(), {r * c, r * s, z});
  return grid;
}

// How far the rings are from circles about the axis: the largest spread of the radii of a row, over its mean.
double roundness(const PointGrid& grid) {
  double worst = 0;
  for (std::size_t i = 0; i < grid.size.rows; ++i) {
    double low = INFINITY, high = 0;
    for (std::size_t j = 0; j < grid.size.columns; ++j) {
      const double* p = &grid.points.values[(i * grid.size.columns + j) * 3];
      low = std::min(low, std::hypot(p[0], p[1]));
      high = std::max(high, std::hypot(p[0], p[1]));
    }
    worst = std::max(worst, (high - low) / high);
  }
  return worst;
}

Section glasses() {
  Section section{"figure-7", "Figure 7", "Figure 7: surfaces of revolution", {}};
  Part& part = section.part;
  part.numbers = nlohmann::ordered_json::array();
  const PointGrid polyhedron = control_polyhedron();
  part.html =
      "<p>Four control points a ring become circles by the mask (26) with t = 1 and λ₂ = iπ/2, that is v⁰ = 0. (The "
      "paper prints λ₂ = π/2, but with a real λ₂ the mask does not reproduce a circle.) Along the profile the mask "
      "(26) "
      "with t = 0, 1/2, 1; the profile, λ₂ = 1 and the linear rule at foot and rim are ours, because the paper names "
      "none.</p>\n<div class=\"panels\">\n";
  const auto upright = [](Sheet s) {
    SurfacePicture p;
    p.sheet = std::move(s);
    p.tilt = 72;
    p.turn = 30;
    p.height = 440;
    return p;
  };
  SurfacePicture net = upright(sheet(polyhedron, {false, true}));
  net.net = true;
  part.html += figure(part, {"7a", "Control polyhedron", "", {}}, net);
  const Scheme ring = make_scheme(tension_name(TensionForm::spline, "1"));
  const Direction along_v{ring, lowering::bind(ring, "0", std::nullopt, {}), measured_levels, Boundary::closed};
  const std::pair<const char*, const char*> glasses[] = {{"7b", "0"}, {"7c", "1/2"}, {"7d", "1"}};
  for (const auto& [id, t] : glasses) {
    const Scheme vertical = make_scheme(tension_name(TensionForm::spline, t));
    const Direction along_u{vertical, lowering::bind(vertical, "cosh(1)", std::nullopt, {}), measured_levels,
                            Boundary::linear};
    const RefinedGrid glass = lowering::refine_grid(polyhedron, along_u, along_v, 0);
    const double spread = roundness(glass.grid);
    part.exact_run(spread);
    part.numbers.push_back(nlohmann::ordered_json{{"surface", id}, {"t", t}, {"roundness", spread}});
    part.html += figure(
        part,
        {id,
         std::string("Vertical t = ") + t,
         "<br/>All rings are circles: spread of their radii at most " + number_text(spread) + ".",
         {"twoscale plot surface " + shell_quoted(tension_name(TensionForm::spline, t)) +
          " --v0 'cosh(1)' --open linear --tensor tension4 --tensor-v0 0 --tensor-closed --levels 4 data/7.csv -o " +
          id + ".svg"}},
        upright(thinned(glass.grid, *glass.grid.closings)));
  }
  part.files.emplace_back("data/7.csv", kernels::grid_to_bytes(polyhedron, kernels::PointFormat::csv, {}));
  part.html += "</div>\n";
  return section;
}

std::vector<Surface> build() {
  return {
      {"6a",
       "Tear drop",
       {"1/2*cos(pi*u/2)*(1-cos(pi*v/2))*sin(pi*v/2)", "1/2*sin(pi*u/2)*(1-cos(pi*v/2))*sin(pi*v/2)", "cos(pi*v/2)"},
       "1/2",
       "0",
       "1/2",
       8,
       5,
       false,
       "",
       0,
       "4/3",
       ""},
      {"6b",
       "Möbius strip, as printed",
       {"3*cos(pi*u/2)+v*cos(pi*u/4)", "3*sin(pi*u/2)+v*cos(pi*u/4)", "v*sin(pi*u/4)"},
       "1",
       "-1",
       "1",
       8,
       3,
       false,
       "Covered twice by 0 ≤ u ≤ 8, where everything is periodic; one turn, 0 ≤ u ≤ 4, is drawn.",
       4,
       "8/5",
       ""},
      {"6b2",
       "Möbius strip, the usual one",
       {"(3+v*cos(pi*u/4))*cos(pi*u/2)", "(3+v*cos(pi*u/4))*sin(pi*u/2)", "v*sin(pi*u/4)"},
       "1",
       "-1",
       "1",
       8,
       3,
       false,
       "Products instead of sums in x and y: a third frequency appears.",
       4,
       "8/7",
       ""},
      {"6c",
       "Figure-8 Klein bottle",
       {"(3+cos(pi*u/4)*sin(pi*v/2)-sin(pi*u/4)*sin(pi*v))*cos(pi*u/2)",
        "(3+cos(pi*u/4)*sin(pi*v/2)-sin(pi*u/4)*sin(pi*v))*sin(pi*u/2)",
        "sin(pi*u/4)*sin(pi*v/2)+cos(pi*u/4)*sin(pi*v)"},
       "1/2",
       "0",
       "1/2",
       16,
       8,
       true,
       "Covered twice by 0 ≤ u ≤ 8; one turn is drawn.",
       8,
       "8/7",
       "4/5"},
      {"6d",
       "Toroidal knot",
       {"(4-cos(pi*u/2)+sin(3*pi*v/2))*cos(pi*v)", "(4-cos(pi*u/2)+sin(3*pi*v/2))*sin(pi*v)",
        "sin(pi*u/2)-cos(3*pi*v/2)"},
       "1/4",
       "0",
       "1/4",
       16,
       16,
       true,
       "The tube of radius 1 around the trefoil (2, 3) on the torus with radii 4 and 1.",
       0,
       "4/3",
       "4/9"}};
}

}  // namespace

const std::vector<Surface>& surfaces() {
  static const std::vector<Surface> list = build();
  return list;
}

ParametricSurface parametric(const Surface& s) {
  ParametricSurface p;
  p.columns = coordinates;
  for (const std::string& f : s.formulas) p.coordinates.push_back(ExponentialSum::parse(f));
  p.u = {SampleLine::parse("0", s.u_step), s.u_count, Boundary::closed};
  p.v = {SampleLine::parse(s.v_first, s.v_step), s.v_count, s.v_closed ? Boundary::closed : Boundary::given};
  return p;
}

std::vector<Section> surface_sections(const PaperOptions& options) {
  Section section{"figure-6", "Figure 6", "Figure 6: surfaces returned from their samples", {}};
  Part& part = section.part;
  part.numbers = nlohmann::ordered_json::array();
  part.html =
      "<p>Each coordinate is a sum of products f(u) g(v). The paper adds up tensor products of 4-point schemes, one "
      "for "
      "every two frequencies that occur together. One pair of 2l-point interpolating schemes whose spaces hold all "
      "frequencies needs no sum, and as few samples as determine the functions; a single pair of 4-point schemes does "
      "not do it.</p>\n<div class=\"panels\">\n";
  for (const Surface& s : surfaces()) {
    if (options.progress) options.progress(s.title);
    part.html += surface_html(s, part);
  }
  part.html += "</div>\n";
  part.findings = {
      "Möbius strip: with the printed y = 3 sin(πu/2) + v cos(πu/4) the surface does close up after one turn with a "
      "half "
      "twist, S(u + 4, v) = S(u, −v), because both cosines of πu/4 change sign; it is a Möbius strip, though its "
      "rulings are "
      "neither of one length nor perpendicular to the circle. The usual strip, (3 + v cos(πu/4)) times (cos(πu/2), "
      "sin(πu/2)), closes up in the same way. Both are returned.",
      "Toroidal knot: as printed the tube touches itself along the whole circle of radius 4 in the plane z = 0, at u = "
      "1 − "
      "3v: S(1 − 3v, v) = (4 cos πv, 4 sin πv, 0), and v and v + 2 give the same point.",
      "Example 6.3 prints λ₂ = π/2 for the circles of figure 7; it has to be iπ/2. For figure 5 the caption says t = "
      "1/2, the "
      "text t = 1/4.",
      "The 4-point schemes return one frequency each. The trefoil tube of figure 6 needs four tensor products of them, "
      "or one "
      "of a 4-point and a 10-point scheme, which is then content with 3 × 9 samples instead of 16 × 16."};
  std::vector<Section> sections;
  sections.push_back(std::move(section));
  if (options.progress) options.progress("surfaces of revolution");
  sections.push_back(glasses());
  return sections;
}

}  // namespace twoscale::reports::jeong2013
