// SPDX-License-Identifier: GPL-3.0-or-later
// twoscale fit SCHEME IN [--tolerance E] [--closed]: the v^0 (and t) that the data are sampled from.
#include "twoscale/lowering/fit.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

#include "session.hpp"
#include "twoscale/kernels/points_io.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::cli {

namespace {

using lowering::Fit;

struct Options {
  std::string scheme;
  std::string input;
  std::string tolerance = "1e-9";
  bool closed = false;
};

std::string fit_json(const std::string& scheme, const Fit& f, const std::string& tolerance) {
  nlohmann::ordered_json j;
  j["format"] = "twoscale/fit";
  j["version"] = 1;
  j["scheme"] = scheme;
  const auto text = [](const std::string& s) {
    return s.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(s);
  };
  const bool found = f.outcome == Fit::Outcome::found;
  j["v0"] = found ? text(f.v0) : text("");
  j["t"] = found ? text(f.t) : text("");
  if (f.outcome == Fit::Outcome::any) j["text"] = "any";
  if (f.outcome == Fit::Outcome::none) {
    j["text"] = "none";
    j["closest"] = {{"v0", text(f.v0)}, {"t", text(f.t)}};
  }
  j["spread"] = text(f.spread);
  j["tolerance"] = tolerance;
  return j.dump(1);
}

std::string fit_text(const Fit& f, const std::string& tolerance) {
  switch (f.outcome) {
    case Fit::Outcome::found:
      return "v0 = " + f.v0 + "\nt = " + f.t + "\nspread = " + f.spread + " (tolerance " + tolerance + ")\n";
    case Fit::Outcome::any: return "v0: any (the data do not depend on the frequency)\n";
    case Fit::Outcome::none: break;
  }
  if (f.v0.empty()) return "no fit: no v0 > -1 comes near the data\n";
  return "no fit: v0 = " + f.v0 + " comes nearest, its spread " + f.spread + " is above the tolerance " + tolerance +
         "\n";
}

int run(const Options& o, const Common& common) {
  const Scheme s = make_scheme(o.scheme);
  if (!s.space) bad_input("the scheme has no function space to fit", s.id);
  const Fit f = lowering::fit(*s.space, kernels::read_points(o.input), o.closed, o.tolerance);
  deliver(common, common.format == "json" ? fit_json(s.id, f, o.tolerance) : fit_text(f, o.tolerance));
  return f.outcome == Fit::Outcome::none ? 1 : 0;
}

}  // namespace

void add_fit_command(CLI::App& app, Session& session) {
  auto o = std::make_shared<Options>();
  CLI::App* c = add_command(app, session, "fit", "find the frequency that points are sampled from");
  c->add_option("scheme", o->scheme, "scheme name")->required()->type_name("SCHEME");
  c->add_option("in", o->input, "points (csv, npy, obj), - for csv from standard input")->required()->type_name("IN");
  c->add_option("--tolerance", o->tolerance, "largest spread of v0 that still fits, 1e-9 by default")->type_name("E");
  c->add_flag("--closed", o->closed, "closed polygon: indices wrap");
  c->callback([&session, o] { session.action = [&session, o] { return run(*o, session.common); }; });
}

}  // namespace twoscale::cli
