// SPDX-License-Identifier: GPL-3.0-or-later
// twoscale derive SCHEME | --space SPACE [--arity M]: sigma, the linear system, omega, zeta, singular v^0.
#include "session.hpp"
#include "twoscale/reports/derivation.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::cli {

void add_derive_command(CLI::App& app, Session& session) {
  struct Options {
    std::string scheme;
    std::string space;
    int arity = 2;
  };
  auto o = std::make_shared<Options>();
  CLI::App* c = add_command(app, session, "derive", "derive sigma, omega and zeta of a function space exactly",
                            {"text", "json", "latex", "md"});
  c->add_option("scheme", o->scheme, "scheme name, e.g. interpolating:family=mixed,l=3")->type_name("SCHEME");
  c->add_option("--space", o->space, "comma list of functions, e.g. \"1,x,exp(t*x),exp(-t*x)\"")->type_name("SPACE");
  c->add_option("--arity", o->arity, "arity m, 2 by default")->check(CLI::Range(2, 64));
  c->callback([&session, o] {
    session.action = [&session, o] {
      if (o->scheme.empty() == o->space.empty()) bad_input("derive: give either a scheme or --space");
      reports::Derivation d;
      if (o->space.empty()) {
        const Scheme scheme = make_scheme(o->scheme);
        if (!scheme.space) bad_input("derive: the scheme is not made from a space", scheme.id);
        d = reports::derive(scheme);
      } else {
        const Space space = Space::parse(o->space);
        SchemeName name{has_interpolating_scheme(space, o->arity) ? "interpolating" : "exponential-bspline",
                        {{"space", space.to_string()}}};
        if (o->arity != 2) name.keys["arity"] = std::to_string(o->arity);
        d = reports::derive(space, o->arity, name.to_string());
      }
      const std::string& f = session.common.format;
      deliver(session.common, f == "json"    ? reports::to_json(d).dump(1)
                              : f == "latex" ? reports::to_latex(d)
                              : f == "md"    ? reports::to_markdown(d)
                                             : reports::to_text(d));
      return 0;
    };
  });
}

}  // namespace twoscale::cli
