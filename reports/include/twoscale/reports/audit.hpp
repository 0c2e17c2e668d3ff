// SPDX-License-Identifier: GPL-3.0-or-later
// The audit of a paper: a list of items as data (where, what is printed, how it is decided), each decided by the
// provers of the library.
//
//   printed statement   correction      verdict
//   proved              -               holds
//   refuted             proved          corrected
//   refuted             none, or not    fails
//   undecided           -               undecided
// A verdict is computed from the item and from nothing else: another coefficient in the item is another verdict.
// Items are TOML (docs/audit.md describes the format and the deciders); those of the papers are compiled in.
#pragma once

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "twoscale/analysis/verdict.hpp"

namespace twoscale::reports::audit {

// What a decider reads: a list of texts for each key.
using Arguments = std::map<std::string, std::vector<std::string>>;

struct Item {
  std::string paper;
  std::string equation;      // place, as the paper numbers it: "(30)", "Lemma 9", "step [3.1]"
  std::string statement;     // as printed
  std::string decider;       // a name of deciders()
  Arguments arguments;       // the statement in the decider's language
  std::string correction;    // what should stand there; empty if nothing is proposed
  std::string corrected_by;  // the decider of the correction, if it is another one: then no argument is inherited
  Arguments corrected;       // replaces arguments of the same name; an empty list removes one
  std::string why;           // a remark for readers: the reason, a hypothesis, what is not decided
  Arguments mutation;  // for tests: arguments whose replacement must change the verdict; empty: digits are changed
};

enum class Verdict { holds, fails, corrected, undecided };
std::string to_string(Verdict v);

struct Result {
  Verdict verdict = Verdict::undecided;
  std::string evidence;    // of the printed statement: identity and its variables, counterexample, or reason
  std::string correction;  // corrected: the right statement; else empty
  std::string proof;       // corrected: the evidence of the correction
};

// One decision, before printed and corrected statement are compared.
struct Outcome {
  analysis::Verdict verdict = analysis::Verdict::undecided;
  std::string evidence;
};

struct Decider {
  std::string name;
  std::string help;
  std::vector<std::string> keys;
  std::vector<std::string> printed;  // the keys that carry the printed formula
  std::function<Outcome(const Arguments&)> decide;
};
const std::vector<Decider>& deciders();
const Decider& decider(const std::string& name);  // throws Error(bad_input) naming it

// The papers that come with the program, in alphabetical order.
std::vector<std::string> papers();
// The items of such a paper, in the order of the paper. Throws Error(bad_input) naming an unknown paper.
std::vector<Item> items_of(const std::string& paper);
// Reads items. Throws Error(bad_input) naming the item and the key that cannot be used.
std::vector<Item> parse_items(std::string_view toml, const std::string& name);

// Required: the arguments can be read; else Error(bad_input) naming the item and the piece.
Outcome decide(const std::string& decider_name, const Arguments& arguments);
Result audit(const Item& item);
// The arguments and the decider of the correction. Required: item.corrected is not empty.
Arguments corrected_arguments(const Item& item);
const std::string& corrected_decider(const Item& item);

// audit() of every item, by that many processes at once (1: in this one). `decided` hears of each as soon as it is done,
// in no certain order. Throws what audit() throws for the first item for which it does; several processes decide all
// others before.
void run(const std::vector<Item>& items, int processes, const std::function<void(std::size_t, const Result&)>& decided);

// A result as an object of texts: verdict, evidence, correction, proof. nullopt for anything else.
nlohmann::ordered_json result_json(const Result& result);
std::optional<Result> result_from(const nlohmann::ordered_json& json);

// Everything that a result depends on as one line of JSON: the key under which results are kept.
std::string item_key(const Item& item);

// Results side by side with their items.
struct Audited {
  Item item;
  Result result;
};
std::string to_text(const std::vector<Audited>& list);
std::string to_json(const std::vector<Audited>& list);
// The errata page: what fails or is corrected, with a demonstration, then what is undecided, then a count of the rest.
std::string to_markdown(const std::vector<Audited>& list);

}  // namespace twoscale::reports::audit
