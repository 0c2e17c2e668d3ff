// SPDX-License-Identifier: GPL-3.0-or-later
#include "arguments.hpp"

#include <CLI/CLI.hpp>

#include <deque>

namespace twoscale::cli::CLI {

Option* Option::required() {
  option_->required();
  return this;
}

Option* Option::type_name(const std::string& name) {
  option_->type_name(name);
  return this;
}

Option* Option::group(const std::string& name) {
  option_->group(name);
  return this;
}

Option* Option::excludes(Option* other) {
  option_->excludes(other->option_);
  return this;
}

Option* Option::take_all() {
  option_->take_all();
  return this;
}

Option* Option::allow_extra_args(bool allow) {
  option_->allow_extra_args(allow);
  return this;
}

Option* Option::check(Range range) {
  option_->check(::CLI::Range(range.low, range.high));
  return this;
}

Option* Option::check(IsMember members) {
  option_->check(::CLI::IsMember(std::move(members.values)));
  return this;
}

Option* Option::delimiter(char between) {
  option_->delimiter(between);
  return this;
}

Option* Option::check(Positive) {
  option_->check(::CLI::PositiveNumber);
  return this;
}

Option* Option::check(NonNegative) {
  option_->check(::CLI::NonNegativeNumber);
  return this;
}

struct App::State {
  std::unique_ptr<::CLI::App> root;  // of the program only
  ::CLI::App* app;
  std::deque<Option> options;
  std::vector<std::unique_ptr<App>> commands;

  Option* keep(::CLI::Option* option) { return &options.emplace_back(option); }
};

App::App(const std::string& description) : state_(std::make_unique<State>()) {
  state_->root = std::make_unique<::CLI::App>(description);
  state_->app = state_->root.get();
}

App::App(std::unique_ptr<State> state) : state_(std::move(state)) {}

App::~App() = default;

App* App::add_subcommand(const std::string& name, const std::string& help) {
  auto state = std::make_unique<State>();
  state->app = state_->app->add_subcommand(name, help);
  state_->commands.push_back(std::unique_ptr<App>(new App(std::move(state))));
  return state_->commands.back().get();
}

template <class T>
Option* App::add_option(const std::string& names, T& value, const std::string& help) {
  return state_->keep(state_->app->add_option(names, value, help));
}

template Option* App::add_option(const std::string&, std::string&, const std::string&);
template Option* App::add_option(const std::string&, int&, const std::string&);
template Option* App::add_option(const std::string&, unsigned&, const std::string&);
template Option* App::add_option(const std::string&, long&, const std::string&);
template Option* App::add_option(const std::string&, unsigned long&, const std::string&);
template Option* App::add_option(const std::string&, double&, const std::string&);
template Option* App::add_option(const std::string&, std::vector<std::string>&, const std::string&);

template <class T>
Option* App::add_option_function(const std::string& names, const std::function<void(const T&)>& set,
                                 const std::string& help) {
  return state_->keep(state_->app->add_option_function<T>(names, set, help));
}

template Option* App::add_option_function(const std::string&, const std::function<void(const std::string&)>&,
                                          const std::string&);
template Option* App::add_option_function(const std::string&, const std::function<void(const double&)>&,
                                          const std::string&);
template Option* App::add_option_function(const std::string&, const std::function<void(const int&)>&,
                                          const std::string&);

Option* App::add_flag(const std::string& names, bool& value, const std::string& help) {
  return state_->keep(state_->app->add_flag(names, value, help));
}

void App::callback(std::function<void()> function) { state_->app->callback(std::move(function)); }

std::size_t App::count(const std::string& name) const { return state_->app->count(name); }

void App::set_version_flag(const std::string& names, const std::string& text) {
  state_->app->set_version_flag(names, text);
}

void App::require_subcommand(int count) { state_->app->require_subcommand(count); }

std::optional<std::string> App::parse(int argc, const char* const* argv) {
  try {
    state_->app->parse(argc, argv);
  } catch (const ::CLI::Success& e) {
    state_->app->exit(e);
    return "";
  } catch (const ::CLI::ParseError& e) {
    return e.what();
  }
  return std::nullopt;
}

}  // namespace twoscale::cli::CLI
