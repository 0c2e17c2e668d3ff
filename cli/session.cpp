// SPDX-License-Identifier: GPL-3.0-or-later
#include "session.hpp"

#include <filesystem>

#include "twoscale/kernels/write_file.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::cli {

std::vector<std::pair<std::string, std::string>> Values::named() const {
  std::vector<std::pair<std::string, std::string>> list;
  for (const auto& option : at)
    for (const auto& piece : split_list(option)) {
      const auto equals = piece.find('=');
      if (equals == std::string::npos || equals == 0) bad_input("--at: expected NAME=VALUE", piece);
      list.emplace_back(trimmed(piece.substr(0, equals)), trimmed(piece.substr(equals + 1)));
    }
  return list;
}

CLI::App* add_command(CLI::App& app, Session& session, const std::string& name, const std::string& help,
                      const std::vector<std::string>& formats) {
  CLI::App* c = app.add_subcommand(name, help);
  Common& common = session.common;
  c->add_option("--format", common.format, "output format, " + formats.front() + " by default")
      ->check(CLI::IsMember(formats))
      ->type_name("FORMAT");
  c->add_option("-o,--output", common.output, "output file, - for standard output")->type_name("FILE");
  c->add_flag("--quiet", common.quiet, "print nothing but the result");
  c->add_option("--threads", common.threads, "number of threads, 0 for all cores")->check(CLI::Range(0, 1024));
  c->add_option("--time-limit", common.time_limit, "seconds after which to stop with what is known")
      ->check(CLI::NonNegativeNumber);
  return c;
}

void add_values(CLI::App* command, Values& values) {
  const auto assign = [](std::optional<std::string>& to) { return [&to](const std::string& text) { to = text; }; };
  command
      ->add_option_function<std::string>("--v0", assign(values.v0),
                                         "start value v^0 of the level variable, an expression > -1")
      ->type_name("E");
  command
      ->add_option_function<std::string>("--t", assign(values.t),
                                         "frequency t instead: v^0 = cosh(t), or cos for cosines")
      ->type_name("E");
  command->add_option("--at", values.at, "values of named parameters, NAME=VALUE,...")
      ->type_name("NAME=VALUE")
      ->take_all()
      ->allow_extra_args(false);
}

void deliver(const Common& common, std::string text) {
  if (text.empty() || text.back() != '\n') text += '\n';
  kernels::write_file(common.output, text);
}

void deliver(const Common& common, const std::string& text, const std::string& file, const std::string& certificate) {
  if (file.empty()) {
    deliver(common, text);
    return;
  }
  // What stood there before comes back if the result cannot be written.
  std::optional<std::string> before;
  if (std::filesystem::is_regular_file(file)) before = kernels::read_file(file);
  kernels::write_file(file, certificate);
  try {
    deliver(common, text);
  } catch (...) {
    if (before)
      kernels::write_file(file, *before);
    else if (file != "-")
      std::filesystem::remove(file);
    throw;
  }
}

}  // namespace twoscale::cli
