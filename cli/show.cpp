// SPDX-License-Identifier: GPL-3.0-or-later
// twoscale show SCHEME: symbol, mask, rules, level variables, support, p, factorisation.
#include <algorithm>
#include <sstream>

#include "session.hpp"
#include "twoscale/reports/derivation.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/sampled_scheme.hpp"

namespace twoscale::cli {

namespace {

using Json = nlohmann::ordered_json;

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

// The weights of a block as "c", or "[c, d; e, f]".
std::string block_text(const std::vector<RationalFunction>& block, int size) {
  std::string text;
  for (size_t i = 0; i < block.size(); ++i)
    text += (i == 0 ? "" : i % static_cast<size_t>(size) == 0 ? "; " : ", ") + block[i].to_string();
  return "[" + text + "]";
}

std::string rule(const Scheme& s, size_t phase) {
  const Stencil& stencil = s.phases[phase];
  std::string text = "f_{" + std::to_string(s.arity) + "j" + (phase == 0 ? "" : "+" + std::to_string(phase)) + "} =";
  bool first = true;
  for (size_t i = 0; i < stencil.blocks.size(); ++i) {
    const auto& block = stencil.blocks[i];
    if (std::all_of(block.begin(), block.end(), [](const auto& c) { return c.is_zero(); })) continue;
    const long h = stencil.lowest + static_cast<long>(i);
    const std::string point = "f_{j" + (h == 0 ? std::string() : (h > 0 ? "+" : "") + std::to_string(h)) + "}";
    const std::string factor = s.block == 1 && block[0].is_one() ? "" : block_text(block, s.block) + " ";
    text += (first ? " " : " + ") + factor + point;
    first = false;
  }
  return first ? text + " 0" : text;
}

std::string parameter_text(const Parameter& p, int arity) {
  std::string text;
  if (p.scope == Parameter::Scope::level) {
    text = "level      " + p.name + (p.frequency ? " = " + meaning(p, arity) : "") + ", " + recurrence(p, arity);
  } else {
    text = "parameter  " + p.name;
    if (p.scope == Parameter::Scope::local) {
      text += ", local:";
      for (const long h : p.offsets)
        text += " " + local_name(p.name, h) + " at edge j" + (h < 0 ? "" : "+") + std::to_string(h);
    }
  }
  if (p.domain && p.scope == Parameter::Scope::level)
    text += "; " + p.spelling->name + "^0 in " + p.domain->to_string();
  else if (p.domain)
    text += " in " + p.domain->to_string();
  if (!p.default_value.empty()) text += "; " + p.default_value + " by default";
  if (!p.help.empty()) text += "; " + p.help;
  return text + "\n";
}

bool has_symbol(const Scheme& s) { return s.block == 1 && is_uniform(s); }

// A scheme with local parameters: its rules, piece by piece.
struct PieceText {
  std::string where;  // empty: where no other piece applies
  const std::vector<Stencil>* phases;
};
std::vector<PieceText> pieces_of(const Scheme& s) {
  std::vector<PieceText> list;
  for (const auto& p : s.pieces) list.push_back({p.where.pretty() + " >= 0", &p.phases});
  list.push_back({s.pieces.empty() ? "" : "else", &s.phases});
  return list;
}

std::string names_of(const Parameter& p) {
  std::string names;
  for (const long offset : p.offsets) names += (names.empty() ? "" : ", ") + local_name(p.name, offset);
  return names;
}

std::string local_head_text(const Scheme& s) {
  std::ostringstream out;
  out << s.id << ": " << s.title << "\n";
  if (!s.source.empty()) out << "source     " << s.source << "\n";
  out << "arity      " << s.arity << ", p = " << s.shift.to_string() << "\n";
  for (const auto& p : s.parameters)
    if (p.scope == Parameter::Scope::local)
      out << "local      " << names_of(p) << ": "
          << (p.rest ? "edge parameters in [0, 1], at rest " + p.rest->to_string() : "knot intervals")
          << " of the edges j" << (p.offsets.front() < 0 ? "" : "+") << p.offsets.front() << " .. j+"
          << p.offsets.back() << "\n";
    else
      out << "parameter  " << p.name << "\n";
  return out.str();
}

std::string show_local_text(const Scheme& s) {
  std::string out = local_head_text(s);
  for (const auto& piece : pieces_of(s)) {
    if (!piece.where.empty()) out += "piece      " + piece.where + "\n";
    Scheme one = s;
    one.phases = *piece.phases;
    for (size_t r = 0; r < one.phases.size(); ++r) out += "rule       " + rule(one, r) + "\n";
  }
  return out;
}

// What of a sampled rule is there as a function, and what at numbers only.
std::string at_rest(const SampledScheme& s) { return "all lambda = " + s.rest.to_string(); }

std::string show_sampled_text(const SampledScheme& s) {
  const Scheme outline = s.outline();
  std::string out = local_head_text(outline);
  out +=
      "points     p_{j" + std::to_string(s.lowest()) + "} .. p_{j+" + std::to_string(s.highest()) + "} for p_{2j+1}\n";
  for (const auto& c : outline.claims)
    if (c.name == "reproduces") out += "reproduces " + c.subject + "\n";
  out += "numbers    exact weights at any intervals and edge parameters (stencil --at, spectrum --at, refine)\n";
  if (!s.symbolic()) return out + "symbols    not written out for this order\n";
  const Scheme rules = make_scheme(s.id);
  out += "symbols    where " + at_rest(s) + "\n";
  for (size_t r = 0; r < rules.phases.size(); ++r) out += "rule       " + rule(rules, r) + "\n";
  return out;
}

Json head_json(const Scheme& s) {
  Json j;
  j["format"] = "twoscale/scheme";
  j["version"] = 1;
  j["scheme"] = s.id;
  j["title"] = s.title;
  j["source"] = s.source;
  j["arity"] = s.arity;
  j["p"] = s.shift.to_string();
  return j;
}

Json show_local_json(const Scheme& s) {
  Json j = head_json(s);
  Json local = Json::object();
  for (const auto& p : s.parameters)
    if (p.scope == Parameter::Scope::local)
      local[p.name] =
          Json::object({{"offsets", p.offsets}, {"rest", p.rest ? Json(p.rest->to_string()) : Json(nullptr)}});
  j["local_parameters"] = local;
  Json pieces = Json::array();
  for (const auto& piece : pieces_of(s)) {
    Json phases = Json::array();
    for (const auto& p : *piece.phases) {
      Json c = Json::array();
      for (const auto& b : p.blocks) c.push_back(b[0].to_string());
      phases.push_back(Json::object({{"lowest", p.lowest}, {"coefficients", c}}));
    }
    pieces.push_back(Json::object({{"where", piece.where}, {"phases", phases}}));
  }
  j["pieces"] = pieces;
  return j;
}

std::string show_sampled_json(const SampledScheme& s) {
  Json j = show_local_json(s.outline());
  j["points"] = {s.lowest(), s.highest()};
  j["pieces"] = Json::array();  // at numbers only
  if (s.symbolic()) {
    j["pieces"] = show_local_json(make_scheme(s.id))["pieces"];
    j["pieces"][0]["where"] = at_rest(s);
  }
  return j.dump(1);
}

std::string show_text(const Scheme& s) {
  std::ostringstream out;
  out << s.id << ": " << s.title << "\n";
  if (!s.source.empty()) out << "source     " << s.source << "\n";
  out << "arity      " << s.arity << "\n";
  if (s.block > 1) out << "block      " << s.block << "\n";
  for (const auto& p : s.parameters) out << parameter_text(p, s.arity);
  if (!has_symbol(s)) {
    out << "p          " << s.shift.to_string() << "\n";
    for (size_t r = 0; r < s.phases.size(); ++r) out << "rule       " << rule(s, r) << "\n";
    return out.str();
  }
  const Laurent a = symbol(s);
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
  Json j = head_json(s);
  Json variables = Json::object();
  Json constants = Json::array();
  Json local = Json::object();
  Json details = Json::object();
  for (const auto& p : s.parameters) {
    if (p.scope == Parameter::Scope::level)
      variables[p.name] = meaning(p, s.arity);
    else if (p.scope == Parameter::Scope::local)
      local[p.name] = p.offsets;
    else
      constants.push_back(p.name);
    Json d = Json::object();
    if (p.scope == Parameter::Scope::level) d["recurrence"] = recurrence(p, s.arity);
    if (p.spelling) d["spelling"] = p.spelling->name;
    if (p.domain) d["domain"] = p.domain->to_string();
    if (!p.default_value.empty()) d["default"] = p.default_value;
    if (!p.help.empty()) d["help"] = p.help;
    if (!d.empty()) details[p.name] = d;
  }
  j["level_variables"] = variables;
  j["parameters"] = constants;
  if (!local.empty()) j["local_parameters"] = local;
  if (!details.empty()) j["parameter_details"] = details;
  if (s.block > 1) j["block"] = s.block;
  if (has_symbol(s)) {
    const Laurent a = symbol(s);
    j["support"] = {a.lowest(), a.highest()};
    j["symbol"] = reports::laurent_json(a);
  }
  Json phases = Json::array();
  for (const auto& p : s.phases) {
    Json c = Json::array();
    for (const auto& b : p.blocks) {
      if (s.block == 1) {
        c.push_back(b[0].to_string());
        continue;
      }
      Json rows = Json::array();
      for (size_t i = 0; i < b.size(); ++i) {
        if (i % static_cast<size_t>(s.block) == 0) rows.push_back(Json::array());
        rows.back().push_back(b[i].to_string());
      }
      c.push_back(rows);
    }
    phases.push_back(Json::object({{"lowest", p.lowest}, {"coefficients", c}}));
  }
  j["phases"] = phases;
  if (!has_symbol(s)) return j.dump(1);
  const auto [n, rest] = smoothing_factors(symbol(s), s.arity);
  j["factorisation"] = Json::object({{"smoothing_factors", n}, {"remainder", reports::laurent_json(rest)}});
  if (const auto limit = limit_symbol(s)) j["limit"] = reports::laurent_json(*limit);
  return j.dump(1);
}

}  // namespace

void add_show_command(CLI::App& app, Session& session) {
  auto name = std::make_shared<std::string>();
  CLI::App* c = add_command(app, session, "show", "print symbol, mask, rules and factorisation of a scheme");
  c->add_option("scheme", *name, "scheme name")->required()->type_name("SCHEME");
  c->callback([&session, name] {
    session.action = [&session, name] {
      const bool json = session.common.format == "json";
      if (const auto sampled = sampled_scheme(*name)) {
        deliver(session.common, json ? show_sampled_json(*sampled) : show_sampled_text(*sampled));
        return 0;
      }
      const Scheme s = make_scheme(*name);
      if (!s.pieces.empty() || !s.kernel.empty()) {
        deliver(session.common, json ? show_local_json(s).dump(1) : show_local_text(s));
        return 0;
      }
      deliver(session.common, json ? show_json(s) : show_text(s));
      return 0;
    };
  });
}

}  // namespace twoscale::cli
