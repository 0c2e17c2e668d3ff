// SPDX-License-Identifier: GPL-3.0-or-later
// twoscale plot basic|curve|sweep|comb|curvature|spectrum|regularity|surface SCHEME [IN] -o FILE.{svg,pdf,png}
#include "twoscale/reports/plot.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "hermite.hpp"
#include "knots.hpp"
#include "regularity.hpp"
#include "session.hpp"
#include "spectrum.hpp"
#include "tensor.hpp"
#include "twoscale/analysis/regularity.hpp"
#include "twoscale/analysis/spectrum.hpp"
#include "twoscale/kernels/points_io.hpp"
#include "twoscale/kernels/write_file.hpp"
#include "twoscale/lowering/refine_points.hpp"
#include "twoscale/reports/curves.hpp"
#include "twoscale/reports/surface_plot.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::cli {

namespace {

using kernels::Boundary;
using kernels::PointSet;
using reports::Line;
using reports::Picture;
using reports::Refined;

constexpr int most_levels = 16;
constexpr double most_points = 1e6;

struct Options {
  std::string kind;
  std::string scheme;
  std::string input;
  std::string values;
  std::string over;
  std::string open;
  bool closed = false;
  int levels = 6;
  Values at;
  TensorOptions tensor;
  KnotChoice knots;
};

// Points on knots without the columns lambda, d, tag.
PointSet coordinates_alone(const PointSet& points) {
  kernels::KnotOptions options;
  options.levels = 0;
  const kernels::KnotColumns columns = kernels::knot_columns(points, options);
  PointSet out;
  out.dim = columns.coordinates.size();
  for (const std::size_t c : columns.coordinates) out.columns.push_back(points.columns[c]);
  for (std::size_t j = 0; j < points.size(); ++j)
    for (const std::size_t c : columns.coordinates) out.values.push_back(points.values[j * points.dim + c]);
  return out;
}

struct Data {
  PointSet points;                    // coordinates
  std::optional<PointSet> tensioned;  // the same with the column v0, if there is one
  PointSet vertices;                  // with their derivatives, if the scheme carries such
  std::optional<PointSet> on_knots;   // the same with the columns lambda, d, tag, if the scheme is one on knots
  Boundary boundary = Boundary::closed;
  bool closed() const { return boundary == Boundary::closed; }
};

Data read_data(const Scheme& s, const Options& o) {
  if (o.input.empty()) bad_input("plot " + o.kind + ": a file of points is missing", o.kind + " " + o.scheme);
  Data d;
  d.points = kernels::read_points(o.input);
  if (!s.kernel.empty()) {
    if (o.at.v0 || o.at.t || !o.at.at.empty())
      bad_input("the parameters of this scheme come with the points (columns lambda, d, tag), not from options", s.id);
    d.on_knots = d.points;
    d.points = coordinates_alone(d.points);
  }
  if (lowering::has_edge_tension(d.points)) {
    d.tensioned = d.points;
    d.points = lowering::without_edge_tension(d.points);
  }
  if (!o.open.empty()) d.boundary = kernels::parse_boundary(o.open);
  if (!o.open.empty() && d.closed()) bad_input("--open takes given, linear or space", o.open);
  if (s.block > 1) {
    d.vertices = d.points;
    d.points = lowering::points_alone(d.vertices);
    if (!d.closed()) d.boundary = Boundary::linear;  // no points beyond the ends
  }
  return d;
}

// The coordinates drawn: the first two columns, or three when there are.
std::size_t coordinates(const PointSet& points, bool plane_only, const Options& o) {
  if (points.dim < 2 || (plane_only && points.dim != 2) || points.dim > 3)
    bad_input("plot " + o.kind + ": points need " + (plane_only ? "two" : "two or three") + " columns, not " +
                  std::to_string(points.dim),
              o.input);
  return points.dim;
}

void check_size(const Scheme& s, const Data& d, const Options& o) {
  const double size = static_cast<double>(d.points.size()) * std::pow(s.arity, o.levels);
  if (size > most_points) bad_input("--levels: too many points for a picture", std::to_string(o.levels));
}

Refined refine(const Scheme& s, const lowering::Binding& binding, const Data& d, const Options& o) {
  check_size(s, d, o);
  return reports::refine_points(s, binding, d.points.values, d.points.dim, o.levels, d.boundary);
}

// Schemes whose vertices carry derivatives.
Refined refine_hermite(const Scheme& s, const std::optional<ExactReal>& w, const Data& d, const Options& o) {
  check_size(s, d, o);
  const lowering::HermiteOptions options{static_cast<unsigned>(o.levels), d.closed(), 0, false};
  const PointSet fine = lowering::points_alone(lowering::refine_hermite(s, w, d.vertices, options).points);
  return {fine.values, fine.dim, 0, std::ldexp(1.0, -o.levels)};
}

// Schemes on knots; the parameter counts edges.
Refined refine_knots(const Scheme& s, const Data& d, const Options& o) {
  check_size(s, d, o);
  const kernels::KnotOptions options = knot_options(*d.on_knots, static_cast<unsigned>(o.levels), d.boundary, o.knots);
  const PointSet fine = coordinates_alone(refine_on_knots(named_scheme(o.scheme), *d.on_knots, options, 0));
  return {fine.values, fine.dim, 0, std::ldexp(1.0, -o.levels)};
}

// With the values of the command line, or those of the edges.
Refined refine(const Scheme& s, const Data& d, const Options& o) {
  if (d.on_knots) return refine_knots(s, d, o);
  if (s.block > 1) return refine_hermite(s, tension(o.at), d, o);
  if (!d.tensioned) return refine(s, lowering::bind(s, o.at.v0, o.at.t, o.at.named()), d, o);
  if (o.at.v0 || o.at.t || !o.at.at.empty())
    bad_input("the points have a column v0 of their own, beside --v0, --t or --at", o.input);
  check_size(s, d, o);
  const PointSet fine = lowering::without_edge_tension(
      lowering::refine_edges(s, *d.tensioned, {static_cast<unsigned>(o.levels), d.boundary, 0}));
  Refined r;
  r.values = fine.values;
  r.dim = fine.dim;
  r.step = std::pow(s.arity, -o.levels);
  return r;
}

Line polygon(const Scheme& s, const Data& d) {
  Line l;
  l.dim = d.points.dim;
  l.style = Line::Style::polygon;
  l.closed = d.closed();
  l.title = "polygon";
  // On knots the points beyond the ends are drawn too.
  const bool cropped = d.boundary == Boundary::given && !d.on_knots;
  const kernels::EndPoints ends = cropped ? reports::points_beyond_ends(s) : kernels::EndPoints{};
  const auto dim = static_cast<std::ptrdiff_t>(d.points.dim);
  l.values.assign(d.points.values.begin() + ends.left * dim, d.points.values.end() - ends.right * dim);
  return l;
}

Line curve_line(const Refined& r, const Data& d, std::string title, int colour) {
  Line l;
  l.values = r.values;
  l.dim = r.dim;
  l.closed = d.closed();
  l.title = std::move(title);
  l.colour = colour;
  return l;
}

Picture basic(const Scheme& s, const Options& o) {
  if (!o.input.empty()) bad_input("plot basic takes no points", o.input);
  if (std::pow(s.arity, o.levels) > most_points / 100)
    bad_input("--levels: too many points for a picture", std::to_string(o.levels));
  Picture p;
  p.equal_axes = false;
  p.title = s.id;
  p.x_label = "parameter";
  Line l;
  l.values = reports::basic_limit_function(s, lowering::bind(s, o.at.v0, o.at.t, o.at.named()), o.levels).values;
  p.lines.push_back(std::move(l));
  return p;
}

Picture curve(const Scheme& s, const Options& o) {
  const Data d = read_data(s, o);
  coordinates(d.points, false, o);
  const Refined r = refine(s, d, o);
  Picture p;
  p.lines = {polygon(s, d), curve_line(r, d, "limit curve", 0)};
  p.title = s.id;
  return p;
}

Picture sweep(const Scheme& s, const Options& o) {
  if (o.values.empty()) bad_input("plot sweep: give the values of v0 (Hermite: w) by --values", s.id);
  if (o.at.v0 || o.at.t)
    bad_input("plot sweep: values of v0 come from --values, not from --v0 or --t", o.at.v0 ? *o.at.v0 : *o.at.t);
  std::string list = trimmed(o.values);
  if (list.size() >= 2 && list.front() == '[' && list.back() == ']') list = list.substr(1, list.size() - 2);
  const auto values = split_list(list);
  if (values.empty() || values.size() > 24) bad_input("--values: from 1 to 24 values", o.values);
  const Data d = read_data(s, o);
  coordinates(d.points, false, o);
  if (d.tensioned) bad_input("plot sweep: the points have a column v0 of their own, beside --values", o.input);
  Picture p;
  p.title = s.id;
  p.lines.push_back(polygon(s, d));
  int colour = 0;
  for (const auto& v : values) {
    const Refined r = s.block > 1 ? refine_hermite(s, parse_real(v), d, o)
                                  : refine(s, lowering::bind(s, v, std::nullopt, o.at.named()), d, o);
    p.lines.push_back(curve_line(r, d, (s.block > 1 ? "w = " : "v⁰ = ") + v, colour++));
  }
  return p;
}

Picture comb(const Scheme& s, const Options& o) {
  const Data d = read_data(s, o);
  coordinates(d.points, true, o);
  const Refined r = refine(s, d, o);
  Picture p;
  p.title = s.id;
  p.lines = reports::curvature_comb(r.values, d.closed());
  p.lines.push_back(polygon(s, d));
  p.lines.push_back(curve_line(r, d, "limit curve", 0));
  return p;
}

Picture curvature_graph(const Scheme& s, const Options& o) {
  const Data d = read_data(s, o);
  coordinates(d.points, true, o);
  const Refined r = refine(s, d, o);
  const std::vector<double> k = reports::curvature(r.values, d.closed());
  Line l;
  for (std::size_t j = 0; j < k.size(); ++j)
    if (std::isfinite(k[j])) l.values.insert(l.values.end(), {r.parameter(j), k[j]});
  if (l.values.empty()) bad_input("plot curvature: all points coincide", o.input);
  Picture p;
  p.equal_axes = false;
  p.title = s.id;
  p.x_label = "parameter";
  p.y_label = "curvature";
  p.lines.push_back(std::move(l));
  return p;
}

// The eigenvalues of the local matrix in the complex plane, and the circles of radius m^{-k} that they are compared
// with.
Picture spectrum(const Scheme& s, const Options& o) {
  if (!o.input.empty()) bad_input("plot spectrum takes no points", o.input);
  if (o.at.v0 || o.at.t) bad_input("plot spectrum: values are given with --at", o.at.v0 ? "--v0" : "--t");
  const analysis::Spectrum spectrum = analysis::spectrum(chosen_mask(s, o.at).mask, s.arity);
  Line values;
  values.style = Line::Style::points;
  values.colour = 1;
  values.title = "eigenvalues";
  for (const auto& e : spectrum.eigenvalues) {
    if (!e.real) bad_input("plot spectrum: eigenvalues depend on parameters, give their values with --at", s.id);
    values.values.insert(values.values.end(), {e.approximate[0], e.approximate[1]});
  }
  constexpr double least_radius = 0.02;  // of a circle that can be seen
  constexpr int steps = 240;
  Line circles;
  circles.style = Line::Style::segments;
  int last = 0;
  for (double radius = 1; radius >= least_radius; radius /= s.arity, ++last)
    for (int i = 0; i < 2 * steps; ++i) {
      const double angle = 2 * std::numbers::pi * ((i + 1) / 2) / steps;
      circles.values.insert(circles.values.end(), {radius * std::cos(angle), radius * std::sin(angle)});
    }
  circles.title = "circles " + std::to_string(s.arity) + "^-k, k = 0.." + std::to_string(last - 1);
  Picture p;
  p.title = s.id;
  p.x_label = "real part";
  p.y_label = "imaginary part";
  p.width = 440;
  p.height = 470;
  p.lines = {circles, values};
  return p;
}

// Hölder and Sobolev exponents along a constant, sampled; the lower bounds where a value is not exact.
Picture regularity(const Scheme& scheme, const Options& o) {
  if (!o.input.empty()) bad_input("plot regularity takes no points", o.input);
  if (o.at.v0 || o.at.t) bad_input("plot regularity: values are given with --at", o.at.v0 ? "--v0" : "--t");
  if (o.over.empty()) bad_input("plot regularity needs --over NAME=[A,B]", o.scheme);
  const Over over = parse_over(o.over);
  const Scheme s = along(with_constants(scheme, o.at.at), over);
  constexpr int steps = 160;
  analysis::RegularityOptions options;
  options.jsr.seconds = 2;
  options.jsr.width = Rational(1, 1000);
  std::vector<std::pair<double, analysis::Regularity>> samples;
  std::map<long, int> orders;
  for (int i = 0; i <= steps; ++i) {
    const Rational w = over.from + (over.to - over.from) * Rational(i, steps);
    samples.emplace_back(fmpq_get_d(w.raw()), analysis::regularity(with_values(s, {{over.name, w}}), options));
    ++orders[samples.back().second.order];
  }
  // Single values with more sum rules are points of their own.
  const long usual = std::max_element(orders.begin(), orders.end(), [](const auto& a, const auto& b) {
                       return a.second < b.second;
                     })->first;
  Line hoelder, sobolev, exceptional;
  hoelder.title = "Hölder exponent";
  sobolev.title = "Sobolev exponent";
  sobolev.colour = 2;
  exceptional.title = "Hölder, more sum rules";
  exceptional.style = Line::Style::points;
  exceptional.colour = 1;
  for (const auto& [x, r] : samples) {
    const auto add = [x = x](Line& line, const analysis::Exponent& e) {
      if (e.lower) line.values.insert(line.values.end(), {x, fmpq_get_d(e.lower->raw())});
    };
    if (r.order == usual) {
      add(hoelder, r.hoelder);
      add(sobolev, r.sobolev);
    } else {
      add(exceptional, r.hoelder);
    }
  }
  if (hoelder.values.empty()) bad_input("plot regularity: no exponent anywhere on the interval", o.over);
  Picture p;
  p.equal_axes = false;
  p.title = s.id.size() <= 48 ? s.id : s.id.substr(0, 45) + "...";
  p.x_label = over.name;
  p.y_label = "exponent";
  p.lines = {hoelder, sobolev};
  if (!exceptional.values.empty()) p.lines.push_back(exceptional);
  return p;
}

Picture picture(const Options& o) {
  const Scheme s = named_scheme(o.scheme).scheme;
  if (s.kernel.empty() && o.knots.any())
    bad_input("--parametrization and --reparametrize are for schemes on knots (nuli4, nuli6, lagrange4)", s.id);
  if (!s.kernel.empty() && o.kind != "curve" && o.kind != "comb" && o.kind != "curvature")
    bad_input("plot " + o.kind + " is not there for schemes on knots", s.id);
  if (o.kind != "regularity" && !o.over.empty()) bad_input("--over belongs to plot regularity", o.over);
  if (o.kind == "regularity") return regularity(s, o);
  if (o.kind == "spectrum") return spectrum(s, o);
  if (o.kind == "basic") return basic(s, o);
  if (o.kind == "curve") return curve(s, o);
  if (o.kind == "sweep") return sweep(s, o);
  if (o.kind == "comb") return comb(s, o);
  return curvature_graph(s, o);
}

reports::SurfacePicture surface(const Options& o) {
  if (o.input.empty()) bad_input("plot surface: a file with a grid of points is missing", o.scheme);
  const kernels::PointFile in = kernels::read_point_file(o.input);
  const auto* grid = std::get_if<kernels::PointGrid>(&in);
  if (grid == nullptr) bad_input("plot surface draws grids, and these are the points of a polygon", o.input);
  const Directions d = directions({o.scheme, o.at, static_cast<unsigned>(o.levels), o.open, o.closed}, o.tensor, *grid);
  const double rows = static_cast<double>(grid->size.rows) * std::pow(d.u.scheme.arity, d.u.levels);
  const double columns = static_cast<double>(grid->size.columns) * std::pow(d.v.scheme.arity, d.v.levels);
  if (rows * columns > most_points) bad_input("--levels: too many points for a picture", std::to_string(o.levels));
  reports::SurfacePicture p;
  p.sheet = reports::sheet(lowering::refine_grid(*grid, d.u, d.v, 0).grid, d.closings());
  p.title = d.u.scheme.id == d.v.scheme.id ? d.u.scheme.id : d.u.scheme.id + " x " + d.v.scheme.id;
  if (p.title.size() > 60) p.title = p.title.substr(0, 57) + "...";
  p.width = 640;
  p.height = 520;
  return p;
}

reports::ImageFormat format_of(const Common& common) {
  const std::string given = common.format == "text" ? "" : common.format;
  if (common.output == "-") return reports::image_format(given.empty() ? "-" : "x." + given);
  const auto format = reports::image_format(common.output);
  if (!given.empty() && reports::image_format("x." + given) != format)
    bad_input("--format " + given + " does not fit the file", common.output);
  return format;
}

}  // namespace

void add_plot_command(CLI::App& app, Session& session) {
  auto o = std::make_shared<Options>();
  CLI::App* c =
      add_command(app, session, "plot",
                  "draw basic limit functions, curves, tension sweeps, curvature, spectra, exponents, surfaces",
                  {"svg", "pdf", "png"});
  c->add_option("kind", o->kind, "basic, curve, sweep, comb, curvature, spectrum, regularity or surface")
      ->required()
      ->type_name("KIND")
      ->check(CLI::IsMember({"basic", "curve", "sweep", "comb", "curvature", "spectrum", "regularity", "surface"}));
  c->add_option("scheme", o->scheme, "scheme name")->required()->type_name("SCHEME");
  c->add_option("in", o->input,
                "points (csv, npy, obj), - for csv from standard input; not for basic, spectrum, regularity")
      ->type_name("IN");
  add_values(c, o->at);
  c->add_option("--values", o->values, "sweep: values of v0 (Hermite: w), \"v1,v2,...\"")->type_name("LIST");
  c->add_option("--over", o->over, "regularity: the constant and its range")->type_name("NAME=[A,B]");
  c->add_option("--levels", o->levels, "refinement steps, 6 by default, 4 for surfaces")
      ->check(CLI::Range(0, most_levels))
      ->type_name("K");
  CLI::Option* closed = c->add_flag("--closed", o->closed, "closed polygon (default)");
  c->add_option("--open", o->open, "open polygon: given, linear or space")->type_name("RULE")->excludes(closed);
  add_tensor(c, o->tensor);
  add_knot_choice(c, o->knots);
  c->callback([&session, o, c] {
    session.action = [&session, o, c] {
      const auto format = format_of(session.common);
      const bool grids = o->kind == "surface";
      if (o->tensor.any() && !grids) bad_input("--tensor belongs to plot surface", o->kind);
      if (grids && c->count("--levels") == 0) o->levels = 4;
      kernels::write_file(session.common.output,
                          grids ? reports::render(surface(*o), format) : reports::render(picture(*o), format));
      return 0;
    };
  });
}

}  // namespace twoscale::cli
