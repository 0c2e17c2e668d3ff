// SPDX-License-Identifier: GPL-3.0-or-later
// What the commands share: options declared once, and where the result goes.
#pragma once

#include "arguments.hpp"

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace twoscale::cli {

// The options of contract §4 that every command has.
struct Common {
  std::string format = "text";
  std::string output = "-";
  bool quiet = false;
  int threads = 0;          // 0: all cores
  double time_limit = 0.0;  // seconds; 0: none
};

// Values of parameters: --v0, --t, --at NAME=VALUE,...
struct Values {
  std::optional<std::string> v0;
  std::optional<std::string> t;
  std::vector<std::string> at;
  // The --at options split into NAME, VALUE at commas outside brackets. Throws Error(bad_input).
  std::vector<std::pair<std::string, std::string>> named() const;
};

// Set by the command that was chosen; main runs it and turns errors into exit statuses.
struct Session {
  std::function<int()> action;
  Common common;
  // The command keeps to the time limit itself and ends with what it has proved; main only waits a little longer.
  bool keeps_time = false;
};

// Declares a sub-command with the common options; `formats` are the values --format takes, the first is the default.
CLI::App* add_command(CLI::App& app, Session& session, const std::string& name, const std::string& help,
                      const std::vector<std::string>& formats = {"text", "json"});
void add_values(CLI::App* command, Values& values);

// Writes the whole result to --output ("-": stdout), atomically. Ends it with a newline if it has none.
void deliver(const Common& common, std::string text);

// The same with a certificate beside it (none if `file` is empty): both are written, or neither.
void deliver(const Common& common, const std::string& text, const std::string& file, const std::string& certificate);

// One function a command; each declares its options on `app`.
void add_new_command(CLI::App& app, Session& session);
void add_list_command(CLI::App& app, Session& session);
void add_show_command(CLI::App& app, Session& session);
void add_derive_command(CLI::App& app, Session& session);
void add_prove_command(CLI::App& app, Session& session);
void add_spectrum_command(CLI::App& app, Session& session);
void add_stencil_command(CLI::App& app, Session& session);
void add_check_command(CLI::App& app, Session& session);
void add_table_command(CLI::App& app, Session& session);
void add_refine_command(CLI::App& app, Session& session);
void add_surface_command(CLI::App& app, Session& session);
void add_fit_command(CLI::App& app, Session& session);
void add_plot_command(CLI::App& app, Session& session);
void add_report_command(CLI::App& app, Session& session);
void add_audit_command(CLI::App& app, Session& session);
void add_regularity_command(CLI::App& app, Session& session);
void add_two_scale_command(CLI::App& app, Session& session);
void add_lifting_command(CLI::App& app, Session& session);

}  // namespace twoscale::cli
