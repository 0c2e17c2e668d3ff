// SPDX-License-Identifier: GPL-3.0-or-later
// twoscale surface FILE.toml --levels K [--method space|sum] [--digits D] -o OUT: a surface given by formulas, or put
// together from summands, refined; --explain says which spaces and samples it needs and how well it is returned.
// docs/surfaces.md describes the file.
#include <fmt/format.h>
#include <toml++/toml.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "session.hpp"
#include "tensor.hpp"
#include "twoscale/kernels/error.hpp"
#include "twoscale/kernels/write_file.hpp"
#include "twoscale/lowering/parametric_surface.hpp"
#include "twoscale/reports/surface_plot.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::cli {

namespace {

using kernels::Boundary;
using lowering::ParametricSurface;
using lowering::Summand;
using lowering::SurfaceMethod;

constexpr std::size_t most_bytes = 1 << 20;
constexpr std::size_t most_summands = 256;
constexpr double most_drawn = 1e6;
const std::vector<std::string> coordinate_names = {"x", "y", "z"};

struct Options {
  std::string file;
  std::string method;
  int levels = 4;
  std::optional<int> u_levels, v_levels;
  long digits = 0;
  bool explain = false;
};

// A scheme and the values of its parameters, as the file has them.
struct Chosen {
  std::string scheme;
  Values values;
};

struct SummandText {
  std::string grid;  // a path, or empty: formulas
  std::vector<ExponentialSum> coordinates;
  std::optional<Chosen> u, v;
};

struct Description {
  std::vector<std::string> formulas;  // x, y, z as written; empty: none
  std::optional<ParametricSurface> surface;
  std::optional<Chosen> u, v;
  Boundary u_ends = Boundary::closed, v_ends = Boundary::closed;
  SurfaceMethod method = SurfaceMethod::space;
  std::vector<SummandText> summands;
};

// ---- The file. Every refusal names file, line and text.

class Reader {
 public:
  explicit Reader(std::string path) : path_(std::move(path)) {}

  Description read() {
    const std::string bytes = kernels::read_file(path_);
    if (bytes.size() > most_bytes) bad_input("a description of more than 1 MiB", path_);
    toml::table root;
    try {
      root = toml::parse(bytes, path_);
    } catch (const toml::parse_error& e) {
      fail(e.source(), std::string(e.description()));
    }
    known(root, {"x", "y", "z", "method", "u", "v", "summand"});
    Description d;
    if (const auto* node = root.get("method")) d.method = at(*node, [&] { return method_of(text(*node, "method")); });
    d.u_ends = ends(root, "u");
    d.v_ends = ends(root, "v");
    d.u = direction(root, "u");
    d.v = direction(root, "v");
    std::vector<std::string> columns;
    std::vector<ExponentialSum> coordinates = formulas(root, columns, &d.formulas);
    const auto* list = root.get("summand");
    if (list != nullptr) d.summands = summands(*list, columns);
    const bool sampled = !coordinates.empty() || std::any_of(d.summands.begin(), d.summands.end(),
                                                             [](const auto& s) { return s.grid.empty(); });
    if (!sampled && d.summands.empty()) bad_input(path_ + ": neither formulas x, y, z nor a [[summand]]");
    if (sampled) {
      d.surface =
          ParametricSurface{columns, std::move(coordinates), axis(root, "u", d.u_ends), axis(root, "v", d.v_ends)};
    }
    return d;
  }

 private:
  [[noreturn]] void fail(const toml::source_region& where, const std::string& message) const {
    bad_input(path_ + ":" + std::to_string(where.begin.line) + ": " + message);
  }

  // What f does, with the line of the node before its complaint.
  template <class F>
  auto at(const toml::node& node, F f) const -> decltype(f()) {
    try {
      return f();
    } catch (const Error& e) {
      if (e.kind == Error::Kind::bad_input) fail(node.source(), e.what());
      throw;
    } catch (const kernels::Error& e) {
      fail(node.source(), e.what());
    }
  }

  void known(const toml::table& table, const std::set<std::string>& keys) const {
    for (const auto& [key, node] : table)
      if (keys.count(std::string(key.str())) == 0) {
        std::string list;
        for (const auto& k : keys) list += (list.empty() ? "" : ", ") + k;
        fail(node.source(), "unknown key '" + std::string(key.str()) + "' (" + list + ")");
      }
  }

  std::string text(const toml::node& node, const std::string& key) const {
    if (const auto* s = node.as_string()) return s->get();
    if (const auto* n = node.as_integer()) return std::to_string(n->get());
    fail(node.source(), key + " must be text in quotes or an integer");
  }

  static SurfaceMethod method_of(const std::string& name) {
    if (name == "space") return SurfaceMethod::space;
    if (name == "sum") return SurfaceMethod::sum;
    bad_input("method is space or sum, not", name);
  }

  const toml::table* table(const toml::table& parent, const std::string& key) const {
    const auto* node = parent.get(key);
    if (node == nullptr) return nullptr;
    if (node->as_table() == nullptr) fail(node->source(), key + " must be a table");
    return node->as_table();
  }

  std::vector<ExponentialSum> formulas(const toml::table& from, std::vector<std::string>& columns,
                                       std::vector<std::string>* texts) const {
    std::vector<ExponentialSum> sums;
    for (const std::string& name : coordinate_names) {
      const auto* node = from.get(name);
      if (node == nullptr) continue;
      columns.push_back(name);
      const std::string formula = text(*node, name);
      sums.push_back(at(*node, [&] { return ExponentialSum::parse(formula); }));
      if (texts != nullptr) texts->push_back(formula);
    }
    return sums;
  }

  Boundary ends(const toml::table& root, const char* name) const {
    const toml::table* t = table(root, name);
    const auto* node = t == nullptr ? nullptr : t->get("ends");
    if (node == nullptr) return Boundary::closed;
    return at(*node, [&] {
      const std::string rule = text(*node, "ends");
      return rule == "closed" ? Boundary::closed : open_rule("ends: closed, or an open rule;", rule);
    });
  }

  std::optional<Chosen> direction(const toml::table& parent, const std::string& name) const {
    const toml::table* t = table(parent, name);
    if (t == nullptr) return std::nullopt;
    known(*t, {"first", "step", "count", "ends", "scheme", "v0", "t", "at"});
    Chosen c;
    const auto optional = [&](const char* key) {
      const auto* node = t->get(key);
      return node == nullptr ? std::optional<std::string>() : text(*node, key);
    };
    c.scheme = optional("scheme").value_or("");
    c.values.v0 = optional("v0");
    c.values.t = optional("t");
    if (const auto list = optional("at")) c.values.at.push_back(*list);
    if (!c.scheme.empty()) return c;
    if (c.values.v0 || c.values.t || !c.values.at.empty()) fail(t->source(), name + ": values without a scheme");
    return std::nullopt;
  }

  lowering::SampledAxis axis(const toml::table& root, const std::string& name, Boundary ends) const {
    const toml::table* t = table(root, name);
    if (t == nullptr) bad_input(path_ + ": formulas need the samples of [" + name + "]: first, step, count");
    lowering::SampledAxis a;
    a.boundary = ends;
    const auto number = [&](const char* key, const char* otherwise) {
      const auto* node = t->get(key);
      return node == nullptr ? std::string(otherwise) : text(*node, key);
    };
    at(*t, [&] {
      a.line = SampleLine::parse(number("first", "0"), number("step", "1"));
      return 0;
    });
    const auto* count = t->get("count");
    if (count == nullptr || count->as_integer() == nullptr || count->as_integer()->get() < 1 ||
        count->as_integer()->get() > 1000000)
      fail(count == nullptr ? t->source() : count->source(),
           "[" + name + "] needs a count of samples, an integer from 1 to 1000000");
    a.count = count->as_integer()->get();
    return a;
  }

  std::vector<SummandText> summands(const toml::node& node, std::vector<std::string>& columns) const {
    const auto* array = node.as_array();
    if (array == nullptr || array->size() > most_summands)
      fail(node.source(), "[[summand]] must be at most 256 tables");
    std::vector<SummandText> list;
    for (const auto& element : *array) {
      const auto* t = element.as_table();
      if (t == nullptr) fail(element.source(), "a summand must be a table");
      known(*t, {"grid", "x", "y", "z", "u", "v"});
      SummandText s;
      s.u = direction(*t, "u");
      s.v = direction(*t, "v");
      std::vector<std::string> own;
      s.coordinates = formulas(*t, own, nullptr);
      if (const auto* grid = t->get("grid")) {
        if (!own.empty()) fail(grid->source(), "a summand has a grid or formulas, not both");
        if (!s.u || !s.v) fail(t->source(), "a summand with a grid needs u = {scheme = ...} and v = {scheme = ...}");
        const std::string path = text(*grid, "grid");
        s.grid = path == "-" || std::filesystem::path(path).is_absolute()
                     ? path
                     : (std::filesystem::path(path_).parent_path() / path).string();
      } else if (own.empty()) {
        fail(t->source(), "a summand needs a grid or formulas x, y, z");
      } else {
        if (columns.empty()) columns = own;
        s.coordinates = spread(std::move(s.coordinates), own, columns, t->source());
      }
      list.push_back(std::move(s));
    }
    return list;
  }

  // Coordinates of the names `own` among those of `columns`; the others are 0.
  std::vector<ExponentialSum> spread(std::vector<ExponentialSum> sums, const std::vector<std::string>& own,
                                     const std::vector<std::string>& columns, const toml::source_region& where) const {
    std::vector<ExponentialSum> all(columns.size());
    for (std::size_t i = 0; i < own.size(); ++i) {
      const auto found = std::find(columns.begin(), columns.end(), own[i]);
      if (found == columns.end()) fail(where, "the surface has no coordinate " + own[i]);
      all[static_cast<std::size_t>(found - columns.begin())] = std::move(sums[i]);
    }
    return all;
  }

  std::string path_;
};

// ---- What is refined

lowering::Direction chosen(const Chosen& c, unsigned levels, Boundary ends) {
  Scheme s = make_scheme(c.scheme);
  lowering::Binding b = lowering::bind(s, c.values.v0, c.values.t, c.values.named());
  return {std::move(s), std::move(b), levels, ends};
}

// Replaces what the least spaces chose, and samples again: other schemes need other points beyond the ends.
void choose(Summand& s, const std::optional<Chosen>& u, const std::optional<Chosen>& v, const ParametricSurface& part) {
  if (u) s.u = chosen(*u, s.u.levels, s.u.boundary);
  if (v) s.v = chosen(*v, s.v.levels, s.v.boundary);
  if (u || v) s.grid = lowering::sampled(part, s.u.scheme, s.v.scheme, s.rounded_digits);
}

std::vector<Summand> plan(const Description& d, SurfaceMethod method, unsigned u_levels, unsigned v_levels,
                          long digits) {
  if (d.summands.empty()) {
    if ((d.u || d.v) && method == SurfaceMethod::sum)
      bad_input("a scheme for all of u or v goes with the method space");
    std::vector<Summand> list = lowering::summands(*d.surface, method, u_levels, v_levels, digits);
    if (method == SurfaceMethod::space) choose(list[0], d.u, d.v, *d.surface);
    return list;
  }
  std::vector<Summand> list;
  for (const SummandText& t : d.summands) {
    if (t.grid.empty()) {
      const ParametricSurface part{d.surface->columns, t.coordinates, d.surface->u, d.surface->v};
      Summand s = lowering::summands(part, SurfaceMethod::space, u_levels, v_levels, digits)[0];
      choose(s, t.u ? t.u : d.u, t.v ? t.v : d.v, part);
      list.push_back(std::move(s));
      continue;
    }
    kernels::PointFile file = kernels::read_point_file(t.grid);
    auto* grid = std::get_if<kernels::PointGrid>(&file);
    if (grid == nullptr) bad_input("a summand is a grid, and these are the points of a polygon", t.grid);
    list.push_back({std::move(*grid), chosen(*t.u, u_levels, d.u_ends), chosen(*t.v, v_levels, d.v_ends), 0});
  }
  return list;
}

// ---- What is said about it

struct Way {
  std::string name;
  std::vector<Summand> summands;
  lowering::RefinedGrid refined;
  std::optional<double> deviation;
  std::string refusal;  // why it cannot be followed
};

Way follow(const Description& d, const std::string& name, SurfaceMethod method, unsigned u_levels, unsigned v_levels) {
  Way w{name, {}, {}, {}, {}};
  try {
    w.summands = plan(d, method, u_levels, v_levels, 0);
    w.refined = lowering::refine_sum(w.summands, 0);
  } catch (const Error& e) {
    if (e.kind != Error::Kind::bad_input) throw;
    w.refusal = e.what();
    w.summands.clear();
    return w;
  }
  if (!d.formulas.empty()) w.deviation = lowering::estimate_largest_deviation(w.refined, *d.surface);
  return w;
}

struct Closing {
  std::vector<long> turns;
  long least;
};

std::optional<Closing> closing(const Description& d, Axis axis) {
  const auto& a = axis == Axis::u ? d.surface->u : d.surface->v;
  if (a.boundary != Boundary::closed) return std::nullopt;
  const std::vector<long> n = turns(d.surface->coordinates, axis, a.line, a.count);
  return Closing{n, least_closed_samples(n)};
}

std::string ends_name(Boundary b) {
  switch (b) {
    case Boundary::closed: return "closed";
    case Boundary::given: return "given";
    case Boundary::linear: return "linear";
    case Boundary::space: return "space";
  }
  return {};
}

std::string values_text(const lowering::Direction& d) {
  std::string s = d.scheme.id;
  for (const auto& [name, value] : d.binding.description) s += fmt::format(" {}={}", name, value);
  return s;
}

std::string explained_text(const Description& d, const std::vector<Way>& ways) {
  std::string s;
  for (std::size_t c = 0; c < d.formulas.size(); ++c)
    s += fmt::format("{}(u,v) = {}\n", d.surface->columns[c], d.formulas[c]);
  for (const Axis axis : {Axis::u, Axis::v}) {
    if (d.formulas.empty()) break;
    const auto& a = axis == Axis::u ? d.surface->u : d.surface->v;
    s += fmt::format("{}: {} samples from {}, step {}, {}", axis == Axis::u ? "u" : "v", a.count,
                     number_expression(a.line.first), number_expression(a.line.step), ends_name(a.boundary));
    if (const auto c = closing(d, axis)) {
      s += "; turns";
      for (std::size_t i = 0; i < c->turns.size(); ++i) s += fmt::format("{} {}", i == 0 ? "" : ",", c->turns[i]);
      s += fmt::format("; {} samples determine them", c->least);
    }
    s += "\n";
  }
  for (const Way& w : ways) {
    if (!w.refusal.empty()) {
      s += fmt::format("\n{}: not possible, {}\n", w.name, w.refusal);
      continue;
    }
    s += fmt::format("\n{}: {} tensor product{}\n", w.name, w.summands.size(), w.summands.size() == 1 ? "" : "s");
    for (const Summand& m : w.summands)
      s += fmt::format("  {} x {} points\n    u {}\n    v {}\n", m.grid.size.rows, m.grid.size.columns,
                       values_text(m.u), values_text(m.v));
    s += fmt::format("  refined: {} x {} points", w.refined.grid.size.rows, w.refined.grid.size.columns);
    if (w.deviation) s += fmt::format(", largest deviation {:.2g} of the size (double arithmetic)", *w.deviation);
    s += "\n";
  }
  return s;
}

std::string explained_json(const Description& d, const std::vector<Way>& ways) {
  nlohmann::ordered_json j;
  j["format"] = "twoscale/surface";
  j["version"] = 1;
  j["scheme"] = nullptr;
  for (std::size_t c = 0; c < d.formulas.size(); ++c) j["formulas"][d.surface->columns[c]] = d.formulas[c];
  for (const Axis axis : {Axis::u, Axis::v}) {
    if (d.formulas.empty()) break;
    const auto& a = axis == Axis::u ? d.surface->u : d.surface->v;
    auto& o = j[axis == Axis::u ? "u" : "v"];
    o["count"] = a.count;
    o["first"] = number_expression(a.line.first);
    o["step"] = number_expression(a.line.step);
    o["ends"] = ends_name(a.boundary);
    if (const auto c = closing(d, axis)) {
      o["turns"] = c->turns;
      o["least_samples"] = c->least;
    }
  }
  j["ways"] = nlohmann::ordered_json::array();
  for (const Way& w : ways) {
    nlohmann::ordered_json o;
    o["method"] = w.name;
    if (!w.refusal.empty()) {
      o["refused"] = w.refusal;
      j["ways"].push_back(o);
      continue;
    }
    for (const Summand& m : w.summands)
      o["summands"].push_back(nlohmann::ordered_json{{"rows", m.grid.size.rows},
                                                     {"columns", m.grid.size.columns},
                                                     {"u", values_text(m.u)},
                                                     {"v", values_text(m.v)}});
    o["rows"] = w.refined.grid.size.rows;
    o["columns"] = w.refined.grid.size.columns;
    o["largest_deviation"] = w.deviation ? nlohmann::ordered_json(*w.deviation) : nlohmann::ordered_json(nullptr);
    o["precision"] = "double";
    j["ways"].push_back(o);
  }
  return j.dump(1) + "\n";
}

int explain(const Options& o, const Description& d, unsigned u_levels, unsigned v_levels, const Common& common) {
  if (common.format != "text" && common.format != "json")
    bad_input("--explain prints text or json, not", common.format);
  std::vector<Way> ways;
  const bool automatic = d.summands.empty() && !d.u && !d.v;
  if (!d.summands.empty())
    ways.push_back(follow(d, "summands", d.method, u_levels, v_levels));
  else if (!o.method.empty() || !automatic)
    ways.push_back(follow(d, d.method == SurfaceMethod::sum ? "sum" : "space", d.method, u_levels, v_levels));
  else
    for (const auto& [name, method] : {std::pair("space", SurfaceMethod::space), std::pair("sum", SurfaceMethod::sum)})
      ways.push_back(follow(d, name, method, u_levels, v_levels));
  if (std::all_of(ways.begin(), ways.end(), [](const Way& w) { return !w.refusal.empty(); }))
    bad_input(ways.front().refusal);
  deliver(common, common.format == "json" ? explained_json(d, ways) : explained_text(d, ways));
  return 0;
}

int run(const Options& o, const Common& common) {
  if (common.format == "json" && !o.explain) bad_input("--format json goes with --explain");
  // Everything that can be refused without the description comes first.
  const std::string target = common.format == "text" ? common.output : "." + common.format;
  const bool picture = !o.explain && (target.ends_with(".svg") || target.ends_with(".pdf") || target.ends_with(".png"));
  const kernels::PointFormat format = o.explain || picture ? kernels::PointFormat::csv : kernels::point_format(target);
  if (o.digits > 0 && (picture || o.explain)) bad_input("--digits goes with points, not with pictures or --explain");
  Description d = Reader(o.file).read();
  if (!o.method.empty()) d.method = o.method == "sum" ? SurfaceMethod::sum : SurfaceMethod::space;
  if (!o.method.empty() && !d.summands.empty()) bad_input("--method: the description states its summands", o.method);
  const auto u_levels = static_cast<unsigned>(o.u_levels.value_or(o.levels));
  const auto v_levels = static_cast<unsigned>(o.v_levels.value_or(o.levels));
  if (o.explain) return explain(o, d, u_levels, v_levels, common);
  const lowering::RefinedGrid out =
      lowering::refine_sum(plan(d, d.method, u_levels, v_levels, o.digits), o.digits, common.threads);
  const kernels::Closings closings = *out.grid.closings;
  if (!picture) {
    kernels::write_file(common.output, kernels::grid_to_bytes(out.grid, format, closings));
    return 0;
  }
  if (static_cast<double>(out.grid.points.size()) > most_drawn)
    bad_input("--levels: too many points for a picture", std::to_string(o.levels));
  reports::SurfacePicture p;
  p.sheet = reports::sheet(out.grid, closings);
  p.width = 640;
  p.height = 520;
  kernels::write_file(common.output, reports::render(p, reports::image_format("x" + target.substr(target.rfind('.')))));
  return 0;
}

}  // namespace

void add_surface_command(CLI::App& app, Session& session) {
  auto o = std::make_shared<Options>();
  CLI::App* c =
      add_command(app, session, "surface",
                  "refine a surface given by formulas in u and v, or a sum of tensor products, described in a "
                  "file; the output by its suffix: csv, npy, obj, ply, svg, pdf, png",
                  {"text", "json", "csv", "npy", "obj", "ply", "svg", "pdf", "png"});
  c->add_option("description", o->file, "description (docs/surfaces.md)")->required()->type_name("FILE.toml");
  c->add_option("--levels", o->levels, "number K of refinement steps, 4 by default")
      ->check(CLI::Range(0, 64))
      ->type_name("K");
  const auto levels = [](std::optional<int>& to) { return [&to](const int& k) { to = k; }; };
  c->add_option_function<int>("--u-levels", levels(o->u_levels), "steps along u")
      ->check(CLI::Range(0, 64))
      ->type_name("K");
  c->add_option_function<int>("--v-levels", levels(o->v_levels), "steps along v")
      ->check(CLI::Range(0, 64))
      ->type_name("K");
  c->add_option("--method", o->method,
                "space: one pair of schemes for all frequencies; sum: one for every two that occur together")
      ->check(CLI::IsMember({"space", "sum"}))
      ->type_name("METHOD");
  c->add_option("--digits", o->digits, "significant digits, all correct; without it, doubles")
      ->check(CLI::Range(17, 10000))
      ->type_name("D");
  c->add_flag("--explain", o->explain, "print frequencies, spaces, samples needed and deviations instead (text, json)");
  c->callback([&session, o] { session.action = [&session, o] { return run(*o, session.common); }; });
}

}  // namespace twoscale::cli
