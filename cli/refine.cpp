// SPDX-License-Identifier: GPL-3.0-or-later
// twoscale refine SCHEME [--v0 E] --levels K [--closed|--open=given|linear|space] [--digits D] IN -o OUT: refines
// points, and grids by tensor products (--tensor SCHEME2 ...).
#include "hermite.hpp"
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
};

int run(const Options& o, const Common& common) {
  // Everything that can be refused without the points comes first.
  const std::string target = common.format == "text" ? common.output : "." + common.format;
  const kernels::PointFormat format = kernels::point_format(target);
  if (!o.open.empty()) open_rule("--open", o.open);
  const Scheme s = make_scheme(o.scheme);
  if (s.block > 1)
    return refine_hermite_file(s, o.values, o.input, {o.levels, o.open.empty(), o.digits, o.jets}, format, common);
  if (o.jets) bad_input("--jets is for schemes of vertices with derivatives", s.id);
  const bool values = o.values.v0 || o.values.t || !o.values.at.empty();
  if (values) lowering::bind(s, o.values.v0, o.values.t, o.values.named());
  const kernels::PointFile in = kernels::read_point_file(o.input);
  if (const auto* grid = std::get_if<kernels::PointGrid>(&in)) {
    const Directions d = directions({o.scheme, o.values, o.levels, o.open, o.closed}, o.tensor, *grid);
    const lowering::RefinedGrid out = lowering::refine_grid(*grid, d.u, d.v, o.digits);
    kernels::write_file(common.output, kernels::grid_to_bytes(out.grid, format, d.closings()));
    return 0;
  }
  if (o.tensor.any()) bad_input("--tensor belongs to grids, and these are the points of a polygon", o.input);
  lowering::RefineOptions options;
  options.levels = o.levels;
  options.digits = o.digits;
  if (!o.open.empty()) options.boundary = kernels::parse_boundary(o.open);
  const auto& points = std::get<kernels::PointSet>(in);
  kernels::PointSet out;
  if (lowering::has_edge_tension(points)) {
    if (values) bad_input("the points have a column v0 of their own, beside --v0, --t or --at", o.input);
    out = lowering::refine_edges(s, points, options);
    // Formats of plain geometry have no place for it.
    if (format == kernels::PointFormat::obj || format == kernels::PointFormat::svg)
      out = lowering::without_edge_tension(out);
  } else {
    out = lowering::refine_points(s, lowering::bind(s, o.values.v0, o.values.t, o.values.named()), points, options);
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
  add_tensor(c, o->tensor);
  c->add_flag("--jets", o->jets, "Hermite schemes: print p, r and sigma of every vertex, and the first pole w*");
  c->callback([&session, o] { session.action = [&session, o] { return run(*o, session.common); }; });
}

}  // namespace twoscale::cli
