// SPDX-License-Identifier: GPL-3.0-or-later
// twoscale show SCHEME: symbol, mask, rules, level variables, support, p, factorisation.
#include <sstream>

#include "derivation.hpp"
#include "session.hpp"
#include "twoscale/symbolic/catalog.hpp"

namespace twoscale::cli {

namespace {

// S_m(z) = 1 + .. + z^{m-1}: how often it divides the symbol, and the cofactor.
std::pair<unsigned, Laurent> smoothing_factors(Laurent a, int arity) {
  const Laurent s(0, std::vector<RationalFunction>(static_cast<size_t>(arity), RationalFunction(1)));
  unsigned n = 0;
  while (auto q = Laurent::quotient(a, s)) {
    a = *std::move(q);
    ++n;
  }
  return {n, a};
}

std::string rule(const Scheme& s, size_t phase) {
  const Stencil& stencil = s.phases[phase];
  std::string text = "f_{" + std::to_string(s.arity) + "j" + (phase == 0 ? "" : "+" + std::to_string(phase)) + "} =";
  bool first = true;
  for (size_t i = 0; i < stencil.blocks.size(); ++i) {
    const RationalFunction& c = stencil.blocks[i][0];
    if (c.is_zero()) continue;
    const long h = stencil.lowest + static_cast<long>(i);
    const std::string point = "f_{j" + (h == 0 ? std::string() : (h > 0 ? "+" : "") + std::to_string(h)) + "}";
    const std::string factor = c.is_one() ? "" : "[" + c.to_string() + "] ";
    text += (first ? " " : " + ") + factor + point;
    first = false;
  }
  return first ? text + " 0" : text;
}

std::string show_text(const Scheme& s) {
  const Laurent a = symbol(s);
  std::ostringstream out;
  out << s.id << ": " << s.title << "\n";
  if (!s.source.empty()) out << "source     " << s.source << "\n";
  out << "arity      " << s.arity << "\n";
  for (const auto& p : s.parameters)
    if (p.frequency)
      out << "level      " << p.name << " = " << p.frequency->meaning(s.arity) << ", " << recurrence(p.name, s.arity)
          << "\n";
    else
      out << "parameter  " << p.name << "\n";
  out << "support    [" << a.lowest() << ", " << a.highest() << "], p = " << s.shift.to_string() << "\n";
  out << "sum        " << a.at_one().to_string() << "\n";
  for (long i = a.lowest(); i <= a.highest(); ++i) out << "  a_" << i << " = " << a.coefficient(i).to_string() << "\n";
  for (size_t r = 0; r < s.phases.size(); ++r) out << "rule       " << rule(s, r) << "\n";
  const auto [n, rest] = smoothing_factors(a, s.arity);
  out << "factors    a(z) = z^" << rest.lowest() << " (1 + ... + z^" << s.arity - 1 << ")^" << n << " b(z), b =";
  for (const auto& c : rest.coefficients()) out << " [" << c.to_string() << "]";
  out << "\n";
  if (const auto limit = limit_symbol(s); limit && !is_stationary(s)) {
    out << "limit     ";
    for (const auto& c : limit->coefficients()) out << " " << c.to_string();
    out << "\n";
  }
  return out.str();
}

std::string show_json(const Scheme& s) {
  using Json = nlohmann::ordered_json;
  const Laurent a = symbol(s);
  Json j;
  j["format"] = "twoscale/scheme";
  j["version"] = 1;
  j["scheme"] = s.id;
  j["title"] = s.title;
  j["source"] = s.source;
  j["arity"] = s.arity;
  j["p"] = s.shift.to_string();
  Json variables = Json::object();
  Json constants = Json::array();
  for (const auto& p : s.parameters) {
    if (p.frequency)
      variables[p.name] = p.frequency->meaning(s.arity);
    else
      constants.push_back(p.name);
  }
  j["level_variables"] = variables;
  j["parameters"] = constants;
  j["support"] = {a.lowest(), a.highest()};
  j["symbol"] = laurent_json(a);
  Json phases = Json::array();
  for (const auto& p : s.phases) {
    Json c = Json::array();
    for (const auto& b : p.blocks) c.push_back(b[0].to_string());
    phases.push_back(Json::object({{"lowest", p.lowest}, {"coefficients", c}}));
  }
  j["phases"] = phases;
  const auto [n, rest] = smoothing_factors(a, s.arity);
  j["factorisation"] = Json::object({{"smoothing_factors", n}, {"remainder", laurent_json(rest)}});
  if (const auto limit = limit_symbol(s)) j["limit"] = laurent_json(*limit);
  return j.dump(1);
}

}  // namespace

void add_show_command(CLI::App& app, Session& session) {
  auto name = std::make_shared<std::string>();
  CLI::App* c = add_command(app, session, "show", "print symbol, mask, rules and factorisation of a scheme");
  c->add_option("scheme", *name, "scheme name")->required()->type_name("SCHEME");
  c->callback([&session, name] {
    session.action = [&session, name] {
      const Scheme s = make_scheme(*name);
      deliver(session.common, session.common.format == "json" ? show_json(s) : show_text(s));
      return 0;
    };
  });
}

}  // namespace twoscale::cli
