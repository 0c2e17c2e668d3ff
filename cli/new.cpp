// SPDX-License-Identifier: GPL-3.0-or-later
// twoscale new NAME [-o FILE]: a commented scheme file to start from.
#include <filesystem>

#include "session.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/scheme_file.hpp"

namespace twoscale::cli {

void add_new_command(CLI::App& app, Session& session) {
  auto name = std::make_shared<std::string>();
  CLI::App* c = add_command(app, session, "new", "a commented scheme file to start from", {"text"});
  c->add_option("name", *name, "name of the scheme: letters, digits, - and _")->required()->type_name("NAME");
  c->callback([&session, name] {
    session.action = [&session, name] {
      const std::string text = scheme_file_template(*name);
      const std::string& file = session.common.output;
      std::error_code ignored;
      if (file != "-" && std::filesystem::exists(std::filesystem::symlink_status(file, ignored)))
        bad_input("new: the file exists and is left as it is", file);
      deliver(session.common, text);
      return 0;
    };
  });
}

}  // namespace twoscale::cli
