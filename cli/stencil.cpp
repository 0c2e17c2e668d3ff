// SPDX-License-Identifier: GPL-3.0-or-later
// twoscale stencil SCHEME --at NAME=VALUE,...: the exact stencil of one new point at given local parameters.
#include <nlohmann/json.hpp>

#include <algorithm>

#include "local_values.hpp"
#include "session.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::cli {

namespace {

using Json = nlohmann::ordered_json;

std::string to_json(const Scheme& s, const LocalValues& at, const Stencil& stencil) {
  Json j;
  j["format"] = "twoscale/stencil";
  j["version"] = 1;
  j["scheme"] = s.id;
  Json given = Json::object();
  for (const auto& [name, list] : at.given) {
    Json values = Json::array();
    for (const auto& v : list) values.push_back(v.to_string());
    given[name] = list.size() == 1 ? values[0] : values;
  }
  j["at"] = given;
  j["lowest"] = stencil.lowest;
  Json c = Json::array();
  for (const auto& b : stencil.blocks) c.push_back(b[0].to_string());
  j["coefficients"] = c;
  return j.dump(1);
}

std::string to_text(const Scheme& s, const LocalValues& at, const Stencil& stencil) {
  std::string out = s.id + ": new point in the middle of the edge [x_i, x_{i+1}]\n";
  for (const auto& [name, list] : at.given) {
    out += "  " + name + " =";
    for (const auto& v : list) out += " " + v.to_string();
    out += "\n";
  }
  for (size_t i = 0; i < stencil.blocks.size(); ++i) {
    const long h = stencil.lowest + static_cast<long>(i);
    out += "  c_" + std::to_string(h) + " = " + stencil.blocks[i][0].to_string() + "  (p_{i" +
           (h == 0 ? "" : (h > 0 ? "+" : "") + std::to_string(h)) + "})\n";
  }
  return out;
}

}  // namespace

void add_stencil_command(CLI::App& app, Session& session) {
  auto name = std::make_shared<std::string>();
  auto values = std::make_shared<Values>();
  CLI::App* c = add_command(app, session, "stencil",
                            "the exact stencil of one new point at given knot intervals and edge parameters");
  c->add_option("scheme", *name, "scheme name")->required()->type_name("SCHEME");
  c->add_option("--at", values->at,
                "values of the local parameters: one, or a list [..] for the edges around i; edge parameters that are "
                "not given are 1/2")
      ->required()
      ->type_name("NAME=VALUE")
      ->take_all();
  c->callback([&session, name, values] {
    session.action = [&session, name, values] {
      const Scheme scheme = make_scheme(*name);
      if (is_uniform(scheme)) bad_input("this scheme has no local parameters (show prints its rules)", scheme.id);
      if (scheme.block != 1 || scheme.arity != 2)
        bad_input("this scheme has no scalar stencil of one new point", scheme.id);
      const LocalValues at = local_values(scheme, values->named());
      const Stencil stencil = phases_at(scheme, at.values)[1];
      deliver(session.common,
              session.common.format == "json" ? to_json(scheme, at, stencil) : to_text(scheme, at, stencil));
      return 0;
    };
  });
}

}  // namespace twoscale::cli
