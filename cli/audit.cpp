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
#include <thread>

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
    Json j{{"version", TWOSCALE_VERSION}, {"item", key}};
    j.update(audit::result_json(r));
    out_ << j.dump() << "\n" << std::flush;
    if (!out_) throw Error(Error::Kind::io, "cannot write", path_);
  }

 private:
  void read(const std::string& line) {
    const Json j = Json::parse(line, nullptr, false);
    if (!j.is_object() || !j.contains("item") || !j["item"].is_string() ||
        j.value("version", Json()) != TWOSCALE_VERSION)
      return;
    if (const auto result = audit::result_from(j)) results_[j["item"]] = *result;
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
      std::vector<audit::Audited> done(list.size());
      std::vector<audit::Item> open;
      std::vector<std::size_t> places;  // of the open items in the list
      for (std::size_t i = 0; i < list.size(); ++i) {
        done[i].item = list[i];
        if (const audit::Result* known = journal.find(audit::item_key(list[i])); known != nullptr) {
          done[i].result = *known;
        } else {
          open.push_back(list[i]);
          places.push_back(i);
        }
      }
      std::size_t decided = list.size() - open.size();
      const int processes =
          common.threads > 0 ? common.threads : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
      audit::run(open, processes, [&](std::size_t i, const audit::Result& result) {
        journal.add(audit::item_key(open[i]), result);
        done[places[i]].result = result;
        if (progress)
          std::cerr << "\r\033[K" << ++decided << "/" << list.size() << " " << open[i].paper << " " << open[i].equation
                    << std::flush;
      });
      if (progress) std::cerr << "\r\033[K" << std::flush;
      deliver(common, common.format == "json" ? audit::to_json(done)
                      : common.format == "md" ? audit::to_markdown(done)
                                              : audit::to_text(done));
      return 0;
    };
  });
}

}  // namespace twoscale::cli
