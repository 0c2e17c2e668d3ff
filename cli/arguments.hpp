// SPDX-License-Identifier: GPL-3.0-or-later
// The part of CLI11 that the commands use, under its names. Its headers take seconds to compile and are read by
// arguments.cpp alone.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace twoscale::cli::CLI {

// What an option accepts.
struct Range {
  int low, high;
};
struct IsMember {
  std::vector<std::string> values;
};
struct NonNegative {};
inline constexpr NonNegative NonNegativeNumber;
struct Positive {};
inline constexpr Positive PositiveNumber;

class App;

// An option or a flag; every member returns `this`. Owned by its App.
class Option {
 public:
  explicit Option(::CLI::Option* option) : option_(option) {}

  Option* required();
  Option* type_name(const std::string& name);
  Option* group(const std::string& name);
  Option* excludes(Option* other);
  Option* take_all();
  Option* allow_extra_args(bool allow);
  Option* delimiter(char between);  // of the values of a list
  Option* check(Range range);
  Option* check(IsMember members);
  Option* check(NonNegative);
  Option* check(Positive);

 private:
  ::CLI::Option* option_;
};

// The program, or one of its commands.
class App {
 public:
  explicit App(const std::string& description);
  App(const App&) = delete;
  App& operator=(const App&) = delete;
  ~App();

  App* add_subcommand(const std::string& name, const std::string& help);
  // T: std::string, int, unsigned, long, unsigned long, double, std::vector<std::string>. `value` keeps what it holds
  // when the option is absent.
  template <class T>
  Option* add_option(const std::string& names, T& value, const std::string& help);
  // T: std::string, int, double.
  template <class T>
  Option* add_option_function(const std::string& names, const std::function<void(const T&)>& set,
                              const std::string& help);
  Option* add_flag(const std::string& names, bool& value, const std::string& help);
  // Called when the command line names this command, after all its options are set.
  void callback(std::function<void()> function);
  // How often the option was given.
  std::size_t count(const std::string& name) const;

  void set_version_flag(const std::string& names, const std::string& text);
  void require_subcommand(int count);
  // nullopt: done, and the callback of the command was called. A text: what is wrong with the command line; empty if
  // help or version were asked for and have been printed.
  std::optional<std::string> parse(int argc, const char* const* argv);

 private:
  struct State;
  explicit App(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace twoscale::cli::CLI
