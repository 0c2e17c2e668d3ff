// SPDX-License-Identifier: GPL-3.0-or-later
// twoscale refine SCHEME [--v0 E] --levels K [--closed|--open=given|linear|space] [--digits D] IN -o OUT: refines
// points, and grids by tensor products (--tensor SCHEME2 ...).
#include <algorithm>

#include "hermite.hpp"
#include "knots.hpp"
#include "session.hpp"
#include "tensor.hpp"
#include "twoscale/kernels/grid_io.hpp"
#include "twoscale/kernels/write_file.hpp"
#include "twoscale/lowering/refine_points.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::cli {

namespace {

struct Options {
  std::string scheme;
  std::string input;
  Values values;
  unsigned levels = 0;
  long digits = 0;
  bool closed = false;
  std::string open;
  TensorOptions tensor;
  bool jets = false;
  KnotChoice knots;
  bool limit = false;
  std::vector<std::string> with;
  std::optional<double> chord;

  bool extras() const { return limit || !with.empty() || chord.has_value(); }
};

// Schemes with local parameters: knots and edge parameters come with the points.
int run_on_knots(const Options& o, const Common& common, const NamedScheme& named, kernels::PointFormat format) {
  if (o.values.v0 || o.values.t || !o.values.at.empty())
    bad_input("the parameters of this scheme come with the points (columns lambda, d, tag), not from options",
              named.scheme.id);
  if (o.tensor.any()) bad_input("--tensor is not there for schemes on knots", named.scheme.id);
  const auto boundary = o.open.empty() ? kernels::Boundary::closed : kernels::parse_boundary(o.open);
  const kernels::PointSet in = kernels::read_points(o.input);
  const kernels::PointSet out = refine_on_knots(named, in, knot_options(in, o.levels, boundary, o.knots), o.digits);
  kernels::write_file(common.output, kernels::points_to_bytes(out, format, boundary == kernels::Boundary::closed));
  return 0;
}

// CSV and NPY in doubles go out piece by piece, so that the memory needed does not grow with the number of levels.
void write_rows(const lowering::RefinedRows& rows, kernels::PointFormat format, const std::string& path) {
  const std::size_t dim = rows.columns.size();
  kernels::FileOutput file(path);
  if (!file.whole()) rows.for_each([](std::span<const double>) {});  // what cannot be taken back is checked first
  file.write(kernels::points_head(format, rows.columns, dim, rows.count));
  std::string text;
  rows.for_each([&](std::span<const double> values) {
    text.clear();
    kernels::append_points(text, format, values, dim);
    file.write(text);
  });
  file.finish();
}

int run(const Options& o, const Common& common) {
  // Everything that can be refused without the points comes first.
  const std::string target = common.format == "text" ? common.output : "." + common.format;
  const kernels::PointFormat format = kernels::point_format(target);
  if (!o.open.empty()) open_rule("--open", o.open);
  const NamedScheme named = named_scheme(o.scheme);
  const Scheme& s = named.scheme;
  if (s.kernel.empty() && o.knots.any())
    bad_input("--parametrization and --reparametrize are for schemes on knots (nuli4, nuli6, lagrange4)", s.id);
  if (s.block == 1 && o.jets) bad_input("--jets is for schemes of vertices with derivatives", s.id);
  if (o.extras() && (!s.kernel.empty() || s.block > 1))
    bad_input("--limit, --with and --chord are for schemes with one mask a level", s.id);
  if (!o.with.empty() && !o.limit) bad_input("--with belongs to --limit", o.with.front());
  if (!s.kernel.empty()) return run_on_knots(o, common, named, format);
  if (s.block > 1)
    return refine_hermite_file(s, o.values, o.input, {o.levels, o.open.empty(), o.digits, o.jets}, format, common);
  const bool values = o.values.v0 || o.values.t || !o.values.at.empty();
  if (values) lowering::bind(s, o.values.v0, o.values.t, o.values.named());
  const kernels::PointFile in = kernels::read_point_file(o.input);
  if (const auto* grid = std::get_if<kernels::PointGrid>(&in)) {
    if (o.extras()) bad_input("--limit, --with and --chord are for polygons, and this is a grid", o.input);
    const Directions d = directions({o.scheme, o.values, o.levels, o.open, o.closed}, o.tensor, *grid);
    const lowering::RefinedGrid out = lowering::refine_grid(*grid, d.u, d.v, o.digits, common.threads);
    kernels::write_file(common.output, kernels::grid_to_bytes(out.grid, format, d.closings()));
    return 0;
  }
  if (o.tensor.any()) bad_input("--tensor belongs to grids, and these are the points of a polygon", o.input);
  lowering::RefineOptions options;
  options.levels = o.levels;
  options.digits = o.digits;
  options.threads = common.threads;
  if (!o.open.empty()) options.boundary = kernels::parse_boundary(o.open);
  const auto& points = std::get<kernels::PointSet>(in);
  kernels::PointSet out;
  if (lowering::has_edge_tension(points)) {
    if (o.extras()) bad_input("--limit, --with and --chord are not there for a column v0", o.input);
    if (values) bad_input("the points have a column v0 of their own, beside --v0, --t or --at", o.input);
    out = lowering::refine_edges(s, points, options);
    // Formats of plain geometry have no place for it.
    if (format == kernels::PointFormat::obj || format == kernels::PointFormat::svg)
      out = lowering::without_edge_tension(out);
  } else {
    const lowering::Binding binding = lowering::bind(s, o.values.v0, o.values.t, o.values.named());
    if (o.digits != 0) {
      if (o.extras()) bad_input("--limit, --with and --chord are there for doubles, without --digits", s.id);
      out = lowering::refine_points(s, binding, points, options);
    } else {
      options.limit = o.limit;
      options.chord = o.chord;
      for (const std::string& what : o.with) (what == "curvature" ? options.curvature : options.derivative) = true;
      const lowering::RefinedRows rows = lowering::refined_rows(s, binding, points, options);
      if (kernels::in_pieces(format)) {
        write_rows(rows, format, common.output);
        return 0;
      }
      out.columns = rows.columns;
      out.dim = rows.columns.size();
      rows.for_each(
          [&](std::span<const double> piece) { out.values.insert(out.values.end(), piece.begin(), piece.end()); });
    }
  }
  const bool closed = options.boundary == kernels::Boundary::closed;
  kernels::write_file(common.output, kernels::points_to_bytes(out, format, closed));
  return 0;
}

}  // namespace

void add_refine_command(CLI::App& app, Session& session) {
  auto o = std::make_shared<Options>();
  CLI::App* c = add_command(
      app, session, "refine",
      "refine points of a polygon or a grid; formats by the suffixes of IN (csv, npy, obj) and of the output",
      {"text", "csv", "npy", "obj", "ply", "svg"});
  c->add_option("scheme", o->scheme, "scheme name")->required()->type_name("SCHEME");
  c->add_option("in", o->input,
                "points (csv, npy, obj), - for csv from standard input; a grid: csv with a line '# grid ROWSxCOLUMNS', "
                "npy with 3 axes, obj with quads")
      ->required()
      ->type_name("IN");
  add_values(c, o->values);
  c->add_option("--levels", o->levels, "number K of refinement steps")
      ->required()
      ->check(CLI::Range(0, 64))
      ->type_name("K");
  CLI::Option* closed = c->add_flag("--closed", o->closed, "closed polygon (default)");
  c->add_option("--open", o->open, "open polygon: given, linear or space")->type_name("RULE")->excludes(closed);
  c->add_option("--digits", o->digits, "significant digits, all correct; without it, doubles")
      ->check(CLI::Range(17, 10000))
      ->type_name("D");
  c->add_flag("--limit", o->limit, "points of the limit curve, at the parameters of the refined points");
  c->add_option("--with", o->with, "with --limit, more columns: derivative, curvature")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"derivative", "curvature"}))
      ->type_name("WHAT");
  c->add_option_function<double>(
       "--chord", [o](double e) { o->chord = e; },
       "stop before K levels when the limit curve is nearer to the polygon than E")
      ->check(CLI::PositiveNumber)
      ->type_name("E");
  add_tensor(c, o->tensor);
  c->add_flag("--jets", o->jets, "Hermite schemes: print p, r and sigma of every vertex, and the first pole w*");
  add_knot_choice(c, o->knots);
  c->callback([&session, o] { session.action = [&session, o] { return run(*o, session.common); }; });
}

}  // namespace twoscale::cli
