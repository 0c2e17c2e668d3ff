// SPDX-License-Identifier: GPL-3.0-or-later
#include "tensor.hpp"

#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::cli {

namespace {

bool any_value(const Values& v) { return v.v0 || v.t || !v.at.empty(); }

// Closed or the rule; `said` by neither option: closed, unless the mesh is open there.
kernels::Boundary boundary(const std::string& option, const std::string& open, bool closed, const char* direction,
                           const std::optional<bool>& mesh_closed) {
  if (!open.empty()) return open_rule(option, open);
  if (!closed && mesh_closed && !*mesh_closed)
    bad_input(std::string("the mesh is open in the direction ") + direction + "; say how it ends", option + " RULE");
  return kernels::Boundary::closed;
}

}  // namespace

bool TensorOptions::any() const {
  return !scheme.empty() || any_value(values) || levels.has_value() || !open.empty() || closed;
}

void add_tensor(CLI::App* command, TensorOptions& options) {
  const std::string group = "Grids: the direction v along a row, where it differs from u";
  const auto assign = [](std::optional<std::string>& to) { return [&to](const std::string& text) { to = text; }; };
  command->add_option("--tensor", options.scheme, "scheme of the direction v")->type_name("SCHEME2")->group(group);
  command->add_option_function<std::string>("--tensor-v0", assign(options.values.v0), "as --v0")
      ->type_name("E")
      ->group(group);
  command->add_option_function<std::string>("--tensor-t", assign(options.values.t), "as --t")
      ->type_name("E")
      ->group(group);
  command->add_option("--tensor-at", options.values.at, "as --at")->type_name("NAME=VALUE")->take_all()->group(group);
  command
      ->add_option_function<int>(
          "--tensor-levels", [&options](const int& levels) { options.levels = levels; }, "as --levels")
      ->check(CLI::Range(0, 64))
      ->type_name("K")
      ->group(group);
  CLI::Option* closed = command->add_flag("--tensor-closed", options.closed, "closed along v")->group(group);
  command->add_option("--tensor-open", options.open, "open along v: given, linear or space")
      ->type_name("RULE")
      ->excludes(closed)
      ->group(group);
}

kernels::Closings Directions::closings() const {
  return {u.boundary == kernels::Boundary::closed, v.boundary == kernels::Boundary::closed};
}

kernels::Boundary open_rule(const std::string& option, const std::string& text) {
  const kernels::Boundary rule = kernels::parse_boundary(text);
  if (rule == kernels::Boundary::closed) bad_input(option + " takes given, linear or space", text);
  return rule;
}

Directions directions(const MainDirection& u, const TensorOptions& v, const kernels::PointGrid& grid) {
  const auto mesh = [&](bool kernels::Closings::*which) {
    return grid.closings ? std::optional<bool>((*grid.closings).*which) : std::nullopt;
  };
  const auto make = [](const std::string& scheme, const Values& values, unsigned levels, kernels::Boundary end) {
    Scheme s = make_scheme(scheme);
    lowering::Binding b = lowering::bind(s, values.v0, values.t, values.named());
    return lowering::Direction{std::move(s), std::move(b), levels, end};
  };
  const bool same_values = v.scheme.empty() && !any_value(v.values);
  const bool same_ends = v.open.empty() && !v.closed;
  const unsigned v_levels = v.levels ? static_cast<unsigned>(*v.levels) : u.levels;
  const kernels::Boundary u_end = boundary("--open", u.open, u.closed, "u", mesh(&kernels::Closings::u));
  const bool u_said = !u.open.empty() || u.closed;
  const kernels::Boundary v_end =
      same_ends && u_said ? u_end : boundary("--tensor-open", v.open, v.closed, "v", mesh(&kernels::Closings::v));
  const auto make_v = [&] {
    try {
      return make(v.scheme.empty() ? u.scheme : v.scheme, same_values ? u.values : v.values, v_levels, v_end);
    } catch (const Error& e) {
      if (e.kind != Error::Kind::bad_input) throw;
      bad_input(std::string("direction v (--tensor, --tensor-v0, ...): ") + e.what());
    }
  };
  return {make(u.scheme, u.values, u.levels, u_end), make_v()};
}

}  // namespace twoscale::cli
