// SPDX-License-Identifier: GPL-3.0-or-later
// Items from TOML, and the comparison of what is printed with what is proposed instead.
#include <toml++/toml.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "audit/embedded.hpp"
#include "twoscale/reports/audit.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::reports::audit {

namespace {

std::vector<std::string> texts(const toml::node& node, const std::string& where) {
  if (const auto s = node.value_exact<std::string>()) return {*s};
  if (const auto i = node.value_exact<int64_t>()) return {std::to_string(*i)};
  if (const auto b = node.value_exact<bool>())
    return *b ? std::vector<std::string>{"true"} : std::vector<std::string>{};
  if (const toml::array* list = node.as_array()) {
    std::vector<std::string> result;
    for (const toml::node& entry : *list) {
      if (!entry.is_string() && !entry.is_integer()) bad_input("a text or a list of texts is expected", where);
      result.push_back(texts(entry, where)[0]);
    }
    return result;
  }
  bad_input("a text or a list of texts is expected", where);
}

Arguments arguments_of(const toml::node& node, const std::string& where) {
  const toml::table* table = node.as_table();
  if (table == nullptr) bad_input("a table is expected", where);
  Arguments result;
  for (const auto& [key, value] : *table) {
    const std::string name(key.str());
    result[name] = texts(value, where + ", " + name);
  }
  return result;
}

Item item_of(const toml::table& table, const std::string& paper, size_t number) {
  Item item;
  item.paper = paper;
  const std::string where = paper + ", item " + std::to_string(number);
  static const std::vector<std::string> own = {"equation",  "statement", "decider", "correction",
                                               "corrected", "why",       "mutation"};
  for (const auto& [key, value] : table) {
    const std::string name(key.str());
    const std::string place = where + ", " + name;
    if (name == "corrected" || name == "mutation") {
      (name == "corrected" ? item.corrected : item.mutation) = arguments_of(value, place);
      continue;
    }
    std::vector<std::string> list = texts(value, place);
    if (std::find(own.begin(), own.end(), name) == own.end()) {
      item.arguments[name] = std::move(list);
      continue;
    }
    if (list.size() != 1) bad_input("one text is expected", place);
    (name == "equation"    ? item.equation
     : name == "statement" ? item.statement
     : name == "decider"   ? item.decider
     : name == "why"       ? item.why
                           : item.correction) = list[0];
  }
  for (const auto& [value, name] : {std::pair(&item.equation, "equation"), std::pair(&item.statement, "statement"),
                                    std::pair(&item.decider, "decider")})
    if (value->empty()) bad_input(where + " lacks the key", name);
  if (item.correction.empty() != item.corrected.empty())
    bad_input("correction (text) and corrected (arguments) belong together", where);
  if (const auto by = item.corrected.find("decider"); by != item.corrected.end()) {
    if (by->second.size() != 1) bad_input("one text is expected", where + ", corrected, decider");
    item.corrected_by = by->second[0];
    item.corrected.erase(by);
  }
  const auto check = [&](const Arguments& arguments, const std::string& name) {
    const Decider& d = decider(name);
    for (const auto& [key, value] : arguments)
      if (std::find(d.keys.begin(), d.keys.end(), key) == d.keys.end())
        bad_input("the decider " + d.name + " has no key", where + ", " + key);
  };
  check(item.arguments, item.decider);
  check(item.corrected, corrected_decider(item));
  check(item.mutation, item.correction.empty() ? item.decider : corrected_decider(item));
  return item;
}

}  // namespace

std::string to_string(Verdict v) {
  switch (v) {
    case Verdict::holds: return "holds";
    case Verdict::fails: return "fails";
    case Verdict::corrected: return "corrected";
    case Verdict::undecided: break;
  }
  return "undecided";
}

std::vector<Item> parse_items(std::string_view text, const std::string& name) {
  toml::table document;
  try {
    document = toml::parse(text);
  } catch (const toml::parse_error& e) {
    bad_input(name + ", line " + std::to_string(e.source().begin.line) + " cannot be read",
              std::string(e.description()));
  }
  std::string paper = name;
  if (const auto p = document["paper"].value<std::string>()) paper = *p;
  const toml::array* list = document["item"].as_array();
  if (list == nullptr) bad_input("no [[item]] in", name);
  std::vector<Item> items;
  for (const toml::node& node : *list) {
    const toml::table* table = node.as_table();
    if (table == nullptr) bad_input("no [[item]] in", name);
    items.push_back(item_of(*table, paper, items.size() + 1));
  }
  return items;
}

std::vector<std::string> papers() {
  std::vector<std::string> names;
  for (const auto& [name, text] : embedded_items()) names.push_back(name);
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<Item> items_of(const std::string& paper) {
  for (const auto& [name, text] : embedded_items())
    if (name == paper) return parse_items(text, paper);
  bad_input("no items for the paper", paper);
}

const std::string& corrected_decider(const Item& item) {
  return item.corrected_by.empty() ? item.decider : item.corrected_by;
}

Arguments corrected_arguments(const Item& item) {
  Arguments arguments = item.corrected_by.empty() ? item.arguments : Arguments{};
  for (const auto& [key, value] : item.corrected) {
    if (value.empty())
      arguments.erase(key);
    else
      arguments[key] = value;
  }
  return arguments;
}

Result audit(const Item& item) {
  const std::string where = item.paper + " " + item.equation;
  try {
    Result r;
    const Outcome printed = decide(item.decider, item.arguments);
    r.evidence = printed.evidence;
    if (printed.verdict == analysis::Verdict::proved) {
      r.verdict = Verdict::holds;
    } else if (printed.verdict == analysis::Verdict::undecided) {
      r.verdict = Verdict::undecided;
    } else {
      r.verdict = Verdict::fails;
      if (!item.corrected.empty()) {
        const Outcome right = decide(corrected_decider(item), corrected_arguments(item));
        if (right.verdict == analysis::Verdict::proved) {
          r.verdict = Verdict::corrected;
          r.correction = item.correction;
          r.proof = right.evidence;
        }
      }
    }
    return r;
  } catch (const Error& e) {
    throw Error(e.kind, where + ": " + e.what());
  }
}

std::string item_key(const Item& item) {
  nlohmann::ordered_json j;
  j["paper"] = item.paper;
  j["equation"] = item.equation;
  j["statement"] = item.statement;
  j["decider"] = item.decider;
  j["arguments"] = item.arguments;
  j["correction"] = item.correction;
  j["corrected_by"] = item.corrected_by;
  j["corrected"] = item.corrected;
  return j.dump();
}

}  // namespace twoscale::reports::audit
