// SPDX-License-Identifier: GPL-3.0-or-later
// twoscale stencil SCHEME --at NAME=VALUE,...: the exact stencil of one new point (block 1) or vertex (larger blocks)
// at given parameters. A local parameter takes one value for each of its offsets, in a list: d=[1,1/2,3].
#include <algorithm>
#include <sstream>

#include <nlohmann/json.hpp>

#include "session.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::cli {

namespace {

struct Options {
  std::string scheme;
  Values values;
};

// A parameter with what it is given: one value, or one for each offset of a local one.
struct Given {
  const Parameter* parameter;
  std::vector<Rational> values;
};

Rational number(const std::string& name, const std::string& text, const Parameter& p) {
  const auto value = parse_rational_function(text).constant();
  if (!value) bad_input("--at: " + name + " must be a rational number", text);
  if (p.domain && !p.domain->contains(*value))
    bad_input("--at: " + name + " must lie in " + p.domain->to_string(), text);
  return *value;
}

std::vector<Given> given_values(const Scheme& s, const std::vector<std::pair<std::string, std::string>>& named) {
  std::vector<Given> list;
  for (const auto& p : s.parameters) {
    const bool local = p.scope == Parameter::Scope::local;
    const auto has_name = [&](const auto& n) { return n.first == p.name; };
    if (std::count_if(named.begin(), named.end(), has_name) > 1) bad_input("--at: given twice", p.name);
    const auto found = std::find_if(named.begin(), named.end(), has_name);
    if (found == named.end()) {
      if (p.default_value.empty()) bad_input("--at: a value is missing", p.name);
      list.push_back({&p, {number(p.name, p.default_value, p)}});
      continue;
    }
    std::string text = found->second;
    std::vector<std::string> pieces = {text};
    if (local && text.size() >= 2 && text.front() == '[' && text.back() == ']')
      pieces = split_list(text.substr(1, text.size() - 2));
    const size_t wanted = local ? p.offsets.size() : 1;
    if (pieces.size() != wanted)
      bad_input("--at: " + p.name + " takes " + std::to_string(wanted) + " value" + (wanted == 1 ? "" : "s"), text);
    Given g{&p, {}};
    for (const auto& piece : pieces) g.values.push_back(number(p.name, piece, p));
    list.push_back(std::move(g));
  }
  for (const auto& [name, value] : named)
    if (std::none_of(list.begin(), list.end(), [&, &n = name](const auto& g) { return g.parameter->name == n; }))
      bad_input("--at: the scheme has no parameter of this name", name);
  return list;
}

// The coefficient (row, column) of the block on vertex i, at the values.
std::string coefficient(const RationalFunction& c, const std::vector<std::pair<std::string, Rational>>& at,
                        const std::string& all) {
  const auto value = c.evaluate(at);
  if (!value) bad_input("the stencil has a pole at these values", all);
  return value->to_string();
}

int run(const Options& o, const Common& common) {
  using Json = nlohmann::ordered_json;
  const Scheme s = make_scheme(o.scheme);
  const auto given = given_values(s, o.values.named());
  std::vector<std::pair<std::string, Rational>> at;
  Json at_json = Json::object();
  std::string at_text;
  for (const auto& g : given) {
    const bool local = g.parameter->scope == Parameter::Scope::local;
    Json list = Json::array();
    std::string text;
    for (size_t i = 0; i < g.values.size(); ++i) {
      at.emplace_back(local ? local_name(g.parameter->name, g.parameter->offsets[i]) : g.parameter->name, g.values[i]);
      list.push_back(g.values[i].to_string());
      text += (i == 0 ? "" : ",") + g.values[i].to_string();
    }
    const bool one = list.size() == 1;
    at_json[g.parameter->name] = one ? list[0] : list;
    at_text += (at_text.empty() ? "" : ", ") + g.parameter->name + "=" + (one ? text : "[" + text + "]");
  }
  // The new vertex of an edge is the last phase: index 2j+1 of a binary scheme.
  const Stencil& stencil = s.phases.back();
  const auto block = static_cast<size_t>(s.block);
  std::vector<std::vector<std::string>> matrix(block);
  for (size_t row = 0; row < block; ++row)
    for (size_t order = 0; order < block; ++order)
      for (const auto& b : stencil.blocks) matrix[row].push_back(coefficient(b[row * block + order], at, at_text));

  if (common.format == "json") {
    Json j;
    j["format"] = "twoscale/stencil";
    j["version"] = 1;
    j["scheme"] = s.id;
    j["at"] = at_json;
    j["lowest"] = stencil.lowest;
    if (block == 1)
      j["coefficients"] = matrix[0];
    else
      j["matrix"] = matrix;
    deliver(common, j.dump(1));
    return 0;
  }
  std::ostringstream out;
  out << s.id << (at_text.empty() ? "" : " at " + at_text) << "\n";
  const std::string names = block == 1 ? "f" : "fprq";  // value and derivatives
  for (size_t row = 0; row < block; ++row) {
    if (block > 1) out << "new " << (row < names.size() ? std::string(1, names[row]) : std::to_string(row)) << "\n";
    for (size_t column = 0; column < matrix[row].size(); ++column) {
      const size_t order = column / stencil.blocks.size();
      const long h = stencil.lowest + static_cast<long>(column % stencil.blocks.size());
      out << "  " << (order < names.size() ? std::string(1, names[order]) : std::to_string(order)) << "_{i"
          << (h == 0 ? "" : (h > 0 ? "+" : "") + std::to_string(h)) << "}  " << matrix[row][column] << "\n";
    }
  }
  deliver(common, out.str());
  return 0;
}

}  // namespace

void add_stencil_command(CLI::App& app, Session& session) {
  auto o = std::make_shared<Options>();
  CLI::App* c =
      add_command(app, session, "stencil",
                  "print the exact stencil of one new point at given local parameters (non-uniform, Hermite)");
  c->add_option("scheme", o->scheme, "scheme name")->required()->type_name("SCHEME");
  c->add_option("--at", o->values.at, "values of the parameters, NAME=VALUE,...; a list [..] for a local one")
      ->type_name("NAME=VALUE")
      ->take_all()
      ->allow_extra_args(false);
  c->callback([&session, o] { session.action = [&session, o] { return run(*o, session.common); }; });
}

}  // namespace twoscale::cli
