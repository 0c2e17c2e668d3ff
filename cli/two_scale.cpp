// SPDX-License-Identifier: GPL-3.0-or-later
// twoscale two-scale SCHEME [--space SPACE] [--v0 E|--t E|--at ...]: is the mask that of the two-scale relation of the
// exponential B-spline of the space? Decided by an identity; with values also measured in double arithmetic.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "session.hpp"
#include "twoscale/kernels/number_text.hpp"
#include "twoscale/lowering/bspline_values.hpp"
#include "twoscale/reports/derivation.hpp"
#include "twoscale/symbolic/bspline_function.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::cli {

namespace {

struct Options {
  std::string scheme;
  std::string space;
  Values values;
  unsigned levels = 4;
  long samples = 64;
};

struct Measured {
  unsigned k;
  double residual;  // largest over the samples, everything in double arithmetic
  Rational at;
};

// The scheme with the mask's names read as the level variables of the space.
Scheme over_space(const Scheme& s, const Space& space) {
  const Laurent a = symbol(s);
  std::vector<Parameter> parameters = level_parameters(space);
  for (const std::string& name : a.variables())
    if (std::none_of(parameters.begin(), parameters.end(), [&](const Parameter& p) { return p.name == name; }))
      parameters.push_back({name, Parameter::Scope::constant, std::nullopt});
  Scheme r = Scheme::from_symbol(s.id, a, s.arity, std::move(parameters));
  r.space = space;
  return r;
}

std::vector<Measured> measure(const Scheme& s, const lowering::Binding& b, const Options& o) {
  lowering::LowerOptions options;
  options.levels = o.levels;
  options.digits = 0;
  options.tail = false;
  const kernels::MaskTable t = lowering::lower(s, b, options);
  const lowering::BsplineFunction phi(*s.space, s.arity, b);
  // The mask may stand at another index than sigma: then it belongs to a translated phi.
  const Rational offset = Rational(symbol(s).lowest()) +
                          (phi.last() - phi.first()) / Rational(2) * Rational(s.arity - 1) -
                          Rational(s.arity - 1) * phi.shift();
  std::vector<Measured> list;
  for (unsigned k = 0; k < o.levels; ++k) {
    Measured worst{k, 0, phi.first()};
    for (long j = 0; j <= o.samples; ++j) {
      const Rational x = phi.first() + (phi.last() - phi.first()) * Rational(j, o.samples);
      double sum = 0;
      for (size_t i = 0; i < t.levels[k].value.size(); ++i) {
        const Rational y = Rational(s.arity) * x + offset - Rational(t.levels[k].lowest + static_cast<long>(i));
        sum += t.levels[k].value[i] * phi.rounded(k + 1, y);
      }
      const double residual = std::fabs(phi.rounded(k, x) - sum);
      if (residual > worst.residual) worst = {k, residual, x};
    }
    list.push_back(worst);
  }
  return list;
}

int run(const Options& o, const Common& common) {
  Scheme s = make_scheme(o.scheme);
  if (!o.space.empty() && s.space) bad_input("--space: the scheme has its own space", s.id);
  if (o.space.empty() && !s.space) bad_input("the scheme is not made from a space, give one with --space", s.id);
  s = over_space(s, s.space ? *s.space : Space::parse(o.space));
  const Space& space = *s.space;
  const Laurent residual = two_scale_residual(space, s.arity, symbol(s));
  // A mask that is right but for its normalisation.
  std::optional<RationalFunction> factor;
  if (!residual.is_zero())
    if (const auto q = Laurent::quotient(symbol(s), bspline_symbol(space, s.arity)); q && q->coefficients().size() == 1)
      factor = q->coefficients()[0];
  std::vector<Measured> measured;
  if (o.values.v0 || o.values.t || !o.values.at.empty() || s.parameters.empty())
    measured = measure(s, lowering::bind(s, o.values.v0, o.values.t, o.values.named()), o);

  const std::string m = std::to_string(s.arity);
  const std::string relation = "phi^{[k]}(x) = sum_i a^{[k]}_i phi^{[k+1]}(" + m + "*x - i)";
  if (common.format == "json") {
    nlohmann::ordered_json j;
    j["format"] = "twoscale/two-scale";
    j["version"] = 1;
    j["scheme"] = s.id;
    j["arity"] = s.arity;
    j["space"] = space.items();
    j["relation"] = relation;
    j["verdict"] = residual.is_zero() ? "proved" : "refuted";
    j["residual"] = reports::laurent_json(residual);
    if (factor) j["factor"] = factor->to_string();
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Measured& x : measured)
      list.push_back({{"k", x.k}, {"residual", kernels::shortest(x.residual)}, {"x", x.at.to_string()}});
    j["double"] = list;
    deliver(common, j.dump(1));
  } else {
    std::ostringstream out;
    out << "scheme     " << s.id << "\n";
    out << "space      " << space.to_string() << "; order " << space.dimension() << "\n";
    for (const auto& v : space.variables()) out << "level      " << v.name << " = " << v.meaning(s.arity) << "\n";
    out << "relation   " << relation << ", phi^{[k]} the exponential B-spline of integral 1\n";
    if (residual.is_zero()) {
      out << "residual   0 exactly, for all values of the level variables\n";
    } else {
      out << "residual   not zero\n";
      if (factor) out << "factor     the mask is the right one times " << factor->to_string() << "\n";
    }
    for (const Measured& x : measured)
      out << "level " << x.k << "    largest residual in double arithmetic " << kernels::shortest(x.residual)
          << " (x = " << x.at.to_string() << ")\n";
    deliver(common, out.str());
  }
  return residual.is_zero() ? 0 : 1;
}

}  // namespace

void add_two_scale_command(CLI::App& app, Session& session) {
  auto o = std::make_shared<Options>();
  CLI::App* c = add_command(app, session, "two-scale",
                            "decide whether a mask is that of the two-scale relation of an exponential B-spline");
  c->add_option("scheme", o->scheme, "scheme name")->required()->type_name("SCHEME");
  c->add_option("--space", o->space, "the space, for a mask that is not made from one")->type_name("SPACE");
  add_values(c, o->values);
  c->add_option("--levels", o->levels, "levels that are measured when values are given")
      ->check(CLI::Range(1, 64))
      ->type_name("K");
  c->add_option("--samples", o->samples, "intervals between the abscissas, over the support")
      ->check(CLI::Range(1, 100000))
      ->type_name("N");
  c->callback([&session, o] { session.action = [&session, o] { return run(*o, session.common); }; });
}

}  // namespace twoscale::cli
