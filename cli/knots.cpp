// SPDX-License-Identifier: GPL-3.0-or-later
#include "knots.hpp"

#include <algorithm>

#include "twoscale/lowering/refine_knots.hpp"
#include "twoscale/symbolic/catalog.hpp"

namespace twoscale::cli {

NamedScheme named_scheme(const std::string& name) {
  auto sampled = sampled_scheme(name);
  Scheme scheme = sampled ? sampled->outline() : make_scheme(name);
  return {std::move(sampled), std::move(scheme)};
}

void add_knot_choice(CLI::App* command, KnotChoice& choice) {
  command
      ->add_option_function<std::string>(
          "--parametrization", [&choice](const std::string& text) { choice.parametrization = text; },
          "schemes on knots: centripetal, chordal, uniform, or given (column d); default: given if there is a column "
          "d, else centripetal")
      ->type_name("KIND");
  command->add_flag("--reparametrize", choice.reparametrize,
                    "schemes on knots: take the knots from the points at every level");
}

kernels::KnotOptions knot_options(const kernels::PointSet& points, unsigned levels, kernels::Boundary boundary,
                                  const KnotChoice& choice) {
  kernels::KnotOptions knots;
  knots.levels = static_cast<int>(levels);
  knots.boundary = boundary;
  knots.parametrization = kernels::parse_parametrization(choice.parametrization.value_or("centripetal"));
  knots.reparametrize = choice.reparametrize;
  if (!choice.any() && std::find(points.columns.begin(), points.columns.end(), "d") != points.columns.end())
    knots.parametrization = kernels::Parametrization::given;
  return knots;
}

kernels::PointSet refine_on_knots(const NamedScheme& s, const kernels::PointSet& points,
                                  const kernels::KnotOptions& options, long digits) {
  if (s.sampled)
    return digits == 0 ? lowering::refine_by_weights(*s.sampled, points, options)
                       : lowering::refine_by_weights(*s.sampled, points, options, digits);
  const kernels::KnotRule rule = kernels::parse_knot_rule(s.scheme.kernel);
  return digits == 0 ? kernels::refine_on_knots(points, rule, options)
                     : lowering::refine_on_knots(points, rule, options, digits);
}

}  // namespace twoscale::cli
