// SPDX-License-Identifier: GPL-3.0-or-later
// twoscale: the command line over the library. Exit status: 0 done, 1 refuted, 2 unusable input, 3 undecided, 4 file.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <thread>

#include "session.hpp"
#include "twoscale/kernels/error.hpp"
#include "twoscale/symbolic/error.hpp"

namespace {

int fail(int status, std::string message) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::cerr << "twoscale: " << message << "\n";
  return status;
}

// --time-limit: nothing is written before it is whole, so a command can be stopped at any moment.
void stop_after(double seconds) {
  std::thread([seconds] {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    std::cerr << "twoscale: undecided within the time limit of " << seconds << " s\n";
    std::_Exit(3);
  }).detach();
}

}  // namespace

int main(int argc, char** argv) {
  using namespace twoscale;
  cli::CLI::App app("twoscale: exact subdivision schemes, from a function space to proofs, tables and curves");
  app.set_version_flag("--version", std::string("twoscale ") + TWOSCALE_VERSION);
  app.require_subcommand(1);
  cli::Session session;
  cli::add_list_command(app, session);
  cli::add_show_command(app, session);
  cli::add_derive_command(app, session);
  cli::add_prove_command(app, session);
  cli::add_check_command(app, session);
  cli::add_spectrum_command(app, session);
  cli::add_stencil_command(app, session);
  cli::add_table_command(app, session);
  cli::add_refine_command(app, session);
  cli::add_surface_command(app, session);
  cli::add_fit_command(app, session);
  cli::add_plot_command(app, session);
  cli::add_report_command(app, session);
  cli::add_audit_command(app, session);
  cli::add_regularity_command(app, session);
  cli::add_new_command(app, session);
  cli::add_two_scale_command(app, session);
  cli::add_lifting_command(app, session);
  if (const auto wrong = app.parse(argc, argv)) return wrong->empty() ? 0 : fail(2, *wrong);
  try {
    if (const double limit = std::min(session.common.time_limit, 1e9); limit > 0)
      stop_after(session.keeps_time ? 1.5 * limit + 2 : limit);
    return session.action();
  } catch (const Error& e) {
    return fail(e.kind == Error::Kind::bad_input ? 2 : e.kind == Error::Kind::undecided ? 3 : 4, e.what());
  } catch (const kernels::Error& e) {
    return fail(e.kind == kernels::Error::Kind::bad_input ? 2 : 4, e.what());
  } catch (const std::bad_alloc&) {
    return fail(2, "not enough memory for this request");
  } catch (const std::exception& e) {
    return fail(2, e.what());
  }
}
