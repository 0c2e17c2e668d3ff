// SPDX-License-Identifier: GPL-3.0-or-later
// twoscale list: the catalog, every id with its keys.
#include <nlohmann/json.hpp>

#include <sstream>

#include "session.hpp"
#include "twoscale/symbolic/catalog.hpp"

namespace twoscale::cli {

namespace {

std::string catalog_text() {
  std::ostringstream out;
  for (const auto& e : catalog()) {
    out << e.id << "  " << e.summary;
    if (!e.source.empty()) out << " [" << e.source << "]";
    out << "\n";
    for (const auto& k : e.keys)
      out << "    " << k.name << "=  " << k.help << (k.required ? " (required)" : "") << "\n";
    out << "    e.g. " << e.examples.front() << "\n";
  }
  return out.str();
}

std::string catalog_json() {
  using Json = nlohmann::ordered_json;
  Json j;
  j["format"] = "twoscale/catalog";
  j["version"] = 1;
  j["scheme"] = nullptr;
  Json entries = Json::array();
  for (const auto& e : catalog()) {
    Json keys = Json::array();
    for (const auto& k : e.keys)
      keys.push_back(Json::object({{"name", k.name}, {"help", k.help}, {"required", k.required}}));
    entries.push_back(Json::object(
        {{"id", e.id}, {"summary", e.summary}, {"source", e.source}, {"keys", keys}, {"examples", e.examples}}));
  }
  j["entries"] = entries;
  return j.dump(1);
}

}  // namespace

void add_list_command(CLI::App& app, Session& session) {
  CLI::App* c = add_command(app, session, "list", "print the catalog of schemes");
  c->callback([&session] {
    session.action = [&session] {
      deliver(session.common, session.common.format == "json" ? catalog_json() : catalog_text());
      return 0;
    };
  });
}

}  // namespace twoscale::cli
