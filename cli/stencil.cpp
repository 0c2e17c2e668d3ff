// SPDX-License-Identifier: GPL-3.0-or-later
// twoscale stencil SCHEME --at NAME=VALUE,...: the exact rule of one new point (block 1) or vertex with derivatives
// (larger blocks) at given parameters.
#include <nlohmann/json.hpp>

#include <algorithm>

#include "local_values.hpp"
#include "session.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/sampled_scheme.hpp"

namespace twoscale::cli {

namespace {

using Json = nlohmann::ordered_json;

// Row: derivative of the new vertex. Columns: derivative by derivative, vertex by vertex (f_i, f_{i+1}, p_i, ...).
std::vector<std::vector<std::string>> matrix_of(const Stencil& stencil, size_t block) {
  std::vector<std::vector<std::string>> matrix(block);
  for (size_t row = 0; row < block; ++row)
    for (size_t order = 0; order < block; ++order)
      for (const auto& b : stencil.blocks) matrix[row].push_back(b[row * block + order].to_string());
  return matrix;
}

// The rule at numbers; with intervals that are symbols as make_scheme has it, the edge parameters being at rest.
Stencil sampled_stencil(const SampledScheme& s, const LocalValues& at) {
  std::vector<std::vector<Rational>> numbers;  // d, lambda
  std::string symbol;
  for (const auto& [name, list] : at.given) {
    numbers.emplace_back();
    for (const auto& v : list)
      if (const auto c = v.constant())
        numbers.back().push_back(*c);
      else
        symbol = v.to_string();
  }
  if (!symbol.empty()) {
    const bool rest = numbers[1] == std::vector<Rational>(at.given[1].second.size(), s.rest);
    if (!rest || !s.symbolic())
      bad_input("--at: numbers are needed for " + s.id + (rest ? "" : " with lambda"), symbol);
    return phases_at(make_scheme(s.id), at.values)[1];
  }
  Stencil stencil{s.lowest(), {}};
  for (const auto& w : s.weights(numbers[0], numbers[1])) stencil.blocks.push_back({w});
  return stencil;
}

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
  const auto matrix = matrix_of(stencil, static_cast<size_t>(s.block));
  if (s.block == 1)
    j["coefficients"] = matrix[0];
  else
    j["matrix"] = matrix;
  return j.dump(1);
}

std::string to_text(const Scheme& s, const LocalValues& at, const Stencil& stencil) {
  std::string out =
      s.id + ": new " + (s.block == 1 ? "point" : "vertex") + " in the middle of the edge [x_i, x_{i+1}]\n";
  for (const auto& [name, list] : at.given) {
    out += "  " + name + " =";
    for (const auto& v : list) out += " " + v.to_string();
    out += "\n";
  }
  const std::string names = "fprq";  // value and derivatives
  const auto name_of = [&](size_t order) {
    return order < names.size() ? std::string(1, names[order]) : "d" + std::to_string(order);
  };
  const auto matrix = matrix_of(stencil, static_cast<size_t>(s.block));
  for (size_t row = 0; row < matrix.size(); ++row) {
    if (s.block > 1) out += "new " + name_of(row) + "\n";
    for (size_t column = 0; column < matrix[row].size(); ++column) {
      const long h = stencil.lowest + static_cast<long>(column % stencil.blocks.size());
      const std::string vertex = "_{i" + (h == 0 ? "" : (h > 0 ? "+" : "") + std::to_string(h)) + "}";
      if (s.block == 1)
        out += "  c_" + std::to_string(h) + " = " + matrix[row][column] + "  (p" + vertex + ")\n";
      else
        out += "  " + name_of(column / stencil.blocks.size()) + vertex + "  " + matrix[row][column] + "\n";
    }
  }
  return out;
}

}  // namespace

void add_stencil_command(CLI::App& app, Session& session) {
  auto name = std::make_shared<std::string>();
  auto values = std::make_shared<Values>();
  CLI::App* c = add_command(app, session, "stencil",
                            "the exact rule of one new point at given local parameters (non-uniform, Hermite)");
  c->add_option("scheme", *name, "scheme name")->required()->type_name("SCHEME");
  c->add_option("--at", values->at,
                "values of the parameters: one, or a list [..] for the edges (vertices) around i; edge parameters that "
                "are not given are 1/2, others take their default value")
      ->type_name("NAME=VALUE")
      ->take_all()
      ->allow_extra_args(false);
  c->callback([&session, name, values] {
    session.action = [&session, name, values] {
      const auto sampled = sampled_scheme(*name);
      const Scheme scheme = sampled ? sampled->outline() : make_scheme(*name);
      if (scheme.arity != 2)
        bad_input("an edge of this scheme has more than one new point (show prints its rules)", scheme.id);
      const LocalValues at = local_values(scheme, values->named());
      const Stencil stencil = sampled ? sampled_stencil(*sampled, at) : phases_at(scheme, at.values)[1];
      deliver(session.common,
              session.common.format == "json" ? to_json(scheme, at, stencil) : to_text(scheme, at, stencil));
      return 0;
    };
  });
}

}  // namespace twoscale::cli
