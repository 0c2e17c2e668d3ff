// SPDX-License-Identifier: GPL-3.0-or-later
// twoscale audit [PAPER|FILE.toml]: decides the items of one paper, or of all.
#include "twoscale/reports/audit.hpp"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "session.hpp"
#include "twoscale/kernels/write_file.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::cli {

namespace {

namespace audit = reports::audit;
using Json = nlohmann::ordered_json;

// --resume FILE: one line of JSON an item, {"version", "item", "verdict", "evidence", "correction", "proof"}, appended
// as soon as the item is decided. A line of another version, of another item or cut short is no result.
class Journal {
 public:
  explicit Journal(const std::string& path) : path_(path) {
    if (path.empty()) return;
    if (std::filesystem::exists(path)) {
      std::istringstream lines(kernels::read_file(path));
      for (std::string line; std::getline(lines, line);) read(line);
    }
    out_.open(path, std::ios::app);
    if (!out_) throw Error(Error::Kind::io, "cannot write", path);
    out_ << "\n";  // ends a line that was cut short
  }
  const audit::Result* find(const std::string& key) const {
    const auto at = results_.find(key);
    return at == results_.end() ? nullptr : &at->second;
  }
  void add(const std::string& key, const audit::Result& r) {
    if (path_.empty()) return;
    Json j;
    j["version"] = TWOSCALE_VERSION;
    j["item"] = key;
    j["verdict"] = to_string(r.verdict);
    j["evidence"] = r.evidence;
    j["correction"] = r.correction;
    j["proof"] = r.proof;
    out_ << j.dump() << "\n" << std::flush;
    if (!out_) throw Error(Error::Kind::io, "cannot write", path_);
  }

 private:
  void read(const std::string& line) {
    const Json j = Json::parse(line, nullptr, false);
    if (!j.is_object()) return;
    for (const char* key : {"version", "item", "verdict", "evidence", "correction", "proof"})
      if (!j.contains(key) || !j[key].is_string()) return;
    if (j["version"] != TWOSCALE_VERSION) return;
    for (const auto v :
         {audit::Verdict::holds, audit::Verdict::fails, audit::Verdict::corrected, audit::Verdict::undecided})
      if (to_string(v) == j["verdict"]) results_[j["item"]] = {v, j["evidence"], j["correction"], j["proof"]};
  }

  std::string path_;
  std::map<std::string, audit::Result> results_;
  std::ofstream out_;
};

std::vector<audit::Item> items(const std::string& subject) {
  const std::string ending = ".toml";
  if (subject.size() > ending.size() && subject.compare(subject.size() - ending.size(), ending.size(), ending) == 0)
    return audit::parse_items(kernels::read_file(subject), std::filesystem::path(subject).stem().string());
  if (!subject.empty()) return audit::items_of(subject);
  std::vector<audit::Item> all;
  for (const std::string& paper : audit::papers()) {
    const auto list = audit::items_of(paper);
    all.insert(all.end(), list.begin(), list.end());
  }
  return all;
}

}  // namespace

void add_audit_command(CLI::App& app, Session& session) {
  auto subject = std::make_shared<std::string>();
  auto resume = std::make_shared<std::string>();
  CLI::App* c = add_command(app, session, "audit", "re-decide the formulas and claims of the source papers",
                            {"text", "json", "md"});
  std::string papers;
  for (const std::string& paper : audit::papers()) papers += (papers.empty() ? "" : ", ") + paper;
  c->add_option("paper", *subject, papers + ", or a file of items FILE.toml; all papers if absent")->type_name("PAPER");
  c->add_option("--resume", *resume, "keep the result of each item in FILE, and take from there what it holds already")
      ->type_name("FILE");
  c->callback([&session, subject, resume] {
    session.action = [&session, subject, resume] {
      const Common& common = session.common;
      const std::vector<audit::Item> list = items(*subject);
      Journal journal(*resume);
      const bool progress = !common.quiet && isatty(STDERR_FILENO) != 0;
      std::vector<audit::Audited> done;
      for (const audit::Item& item : list) {
        if (progress)
          std::cerr << "\r\033[K" << done.size() + 1 << "/" << list.size() << " " << item.paper << " " << item.equation
                    << std::flush;
        const std::string key = audit::item_key(item);
        const audit::Result* known = journal.find(key);
        done.push_back({item, known != nullptr ? *known : audit::audit(item)});
        if (known == nullptr) journal.add(key, done.back().result);
      }
      if (progress) std::cerr << "\r\033[K" << std::flush;
      deliver(common, common.format == "json" ? audit::to_json(done)
                      : common.format == "md" ? audit::to_markdown(done)
                                              : audit::to_text(done));
      return 0;
    };
  });
}

}  // namespace twoscale::cli
