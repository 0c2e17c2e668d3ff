// SPDX-License-Identifier: GPL-3.0-or-later
// twoscale spectrum SCHEME [--at NAME=VALUE,...]: local subdivision matrix, eigenvalues, eigenvectors, limit stencils.
#include "spectrum.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "local_values.hpp"
#include "twoscale/analysis/hermite.hpp"
#include "twoscale/analysis/junction.hpp"
#include "twoscale/analysis/spectrum.hpp"
#include "twoscale/symbolic/ball.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"
#include "twoscale/symbolic/sampled_scheme.hpp"

namespace twoscale::cli {

namespace {

using analysis::Eigenvalue;
using analysis::NecessaryConditions;
using analysis::SpectralFactor;
using analysis::Spectrum;
using Json = nlohmann::ordered_json;

Rational rational_value(const std::string& name, const std::string& text) {
  try {
    if (const auto value = parse_rational_function(text).constant()) return *value;
  } catch (const Error& e) {
    if (e.kind != Error::Kind::bad_input) throw;
  }
  bad_input("--at: the value of " + name + " must be a rational number", text);
}

// A rational that is a decimal as such, unless it is very large.
std::string exact_decimal(const Rational& x) {
  return abs(x) < Rational(10).pow(20) ? rounded_decimal(x, 1000) : x.to_string();
}

std::string polynomial_of(const Spectrum& s, const Eigenvalue& e) {
  return analysis::polynomial_text(s.factors[e.factor].polynomial, s.variable);
}

Json exact_json(const Spectrum& s, const Eigenvalue& e) {
  if (!e.exact.empty()) return e.exact;
  Json j = Json::object({{"polynomial", polynomial_of(s, e)}});
  if (!e.real) return j;
  const auto interval = [](const std::array<Rational, 2>& x) {
    return Json::array({exact_decimal(x[0]), exact_decimal(x[1])});
  };
  if ((*e.imaginary)[0].is_zero() && (*e.imaginary)[1].is_zero()) {
    j["interval"] = interval(*e.real);
  } else {
    j["real"] = interval(*e.real);
    j["imaginary"] = interval(*e.imaginary);
  }
  return j;
}

Json vectors_json(const Spectrum& s, const std::vector<analysis::Eigenvector>& basis) {
  Json list = Json::array();
  for (const auto& vector : basis) {
    Json entries = Json::array();
    for (const auto& entry : vector) entries.push_back(analysis::polynomial_text(entry, s.variable));
    list.push_back(std::move(entries));
  }
  return list;
}

constexpr const char* hypothesis =
    "stationary scheme, integer translates of the basic limit function locally linearly independent";

const char* verdict_of(const NecessaryConditions& n) {
  switch (n.kind) {
    case NecessaryConditions::Kind::decided: return "decided";
    case NecessaryConditions::Kind::conditional: return "conditional";
    case NecessaryConditions::Kind::undecided: return "undecided";
  }
  return "";
}

// What the matrix belongs to.
struct Place {
  std::string key;   // limit, level, junction
  std::string text;  // "the limit mask"
  std::vector<std::pair<std::string, std::string>> values;
};

Place place_of(const Scheme& scheme, const ChosenMask& chosen) {
  const bool stationary = is_stationary(scheme);
  Place p{chosen.limit || stationary ? "limit" : "level",
          stationary     ? "mask"
          : chosen.limit ? "limit mask"
                         : "mask of a level",
          {}};
  for (const auto& [name, value] : chosen.values) p.values.emplace_back(name, value.to_string());
  return p;
}

Json decomposition_json(const Scheme& scheme, const Place& place, const Spectrum& s) {
  Json j;
  j["format"] = "twoscale/spectrum";
  j["version"] = 1;
  j["scheme"] = scheme.id;
  j["arity"] = scheme.arity;
  j["p"] = scheme.shift.to_string();
  j["mask"] = place.key;
  Json parameters = Json::object();
  for (const auto& [name, value] : place.values) parameters[name] = value;
  j["parameters"] = parameters;
  j["lowest"] = s.matrix.lowest;
  Json matrix = Json::array();
  for (std::size_t r = 0; r < s.matrix.entries.rows(); ++r) {
    Json row = Json::array();
    for (std::size_t c = 0; c < s.matrix.entries.columns(); ++c) row.push_back(s.matrix.entries(r, c).to_string());
    matrix.push_back(std::move(row));
  }
  j["matrix"] = matrix;
  Json factors = Json::array();
  for (const auto& f : s.factors)
    factors.push_back(Json::array({analysis::polynomial_text(f.polynomial, s.variable), f.multiplicity}));
  j["characteristic_polynomial"] = Json::object({{"variable", s.variable}, {"factors", factors}});
  std::vector<Json> left, right;
  for (const auto& f : s.factors) {
    left.push_back(vectors_json(s, f.left));
    right.push_back(vectors_json(s, f.right));
  }
  Json eigenvalues = Json::array();
  for (const auto& e : s.eigenvalues) {
    const SpectralFactor& f = s.factors[e.factor];
    Json k;
    k["exact"] = exact_json(s, e);
    k["multiplicity"] = f.multiplicity;
    k["geometric"] = f.geometric;
    k["decimal"] = e.decimal.empty() ? Json() : Json(e.decimal);
    if (e.roots > 1) k["roots"] = e.roots;
    // Entries of the eigenvectors are polynomials in the variable, which stands for the eigenvalue.
    if (f.degree() > 1) k["modulo"] = polynomial_of(s, e);
    k["left"] = left[e.factor];
    k["right"] = right[e.factor];
    eigenvalues.push_back(std::move(k));
  }
  j["eigenvalues"] = eigenvalues;
  return j;
}

Json to_json(const Scheme& scheme, const Place& place, const Spectrum& s) {
  Json j = decomposition_json(scheme, place, s);
  Json stencils = Json::array();
  for (const auto& l : s.stencils) {
    Json c = Json::array();
    for (const auto& x : l.coefficients) c.push_back(x.to_string());
    stencils.push_back(Json::object({{"derivative", l.derivative},
                                     {"lowest", l.lowest},
                                     {"coefficients", c},
                                     {"polynomials_only", static_cast<long>(l.derivative) > s.necessary.order}}));
  }
  j["limit_stencils"] = stencils;
  const NecessaryConditions& n = s.necessary;
  j["necessary"] = Json::object({{"verdict", verdict_of(n)},
                                 {"continuity", n.order},
                                 {"obstruction", n.obstruction},
                                 {"conditions", n.conditions},
                                 {"hypothesis", hypothesis}});
  return j;
}

// Columns of equal width, the text at their right or left.
std::string aligned(const std::vector<std::vector<std::string>>& rows, const std::string& indent, bool right) {
  std::vector<std::size_t> width(rows.empty() ? 0 : rows[0].size(), 0);
  for (const auto& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) width[c] = std::max(width[c], row[c].size());
  std::string text;
  for (const auto& row : rows) {
    std::string line = indent;
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string blanks(width[c] - row[c].size(), ' ');
      line += (c == 0 ? "" : "  ") + (right ? blanks + row[c] : row[c] + blanks);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string vector_text(const Spectrum& s, const analysis::Eigenvector& v) {
  std::string text;
  for (const auto& entry : v) text += (text.empty() ? "" : ", ") + analysis::polynomial_text(entry, s.variable);
  return "(" + text + ")";
}

std::string necessary_text(const NecessaryConditions& n) {
  std::string text = "necessary  ";
  const bool conditional = n.kind == NecessaryConditions::Kind::conditional;
  if (n.order < 0) return text + "the conditions for continuity fail: " + n.obstruction + "\n";
  text += "the conditions for C^" + std::to_string(n.order) + (conditional ? " hold if" : " hold");
  for (std::size_t i = 0; i < n.conditions.size(); ++i) text += (i == 0 ? " " : " and ") + n.conditions[i];
  return text + "\n           not C^" + std::to_string(n.order + 1) + (conditional ? " in general: " : ": ") +
         n.obstruction + "\n           (" + hypothesis + ")\n";
}

std::string decomposition_text(const Scheme& scheme, const Place& place, const Spectrum& s) {
  const auto size = static_cast<long>(s.matrix.entries.rows()) / scheme.block;  // vertices
  std::string out = scheme.id + ": local subdivision matrix of the " + place.text;
  for (const auto& [name, value] : place.values) out += ", " + name + " = " + value;
  out += "\nindices    " + std::to_string(s.matrix.lowest) + ".." + std::to_string(s.matrix.lowest + size - 1) +
         ", p = " + scheme.shift.to_string() + "\n";
  std::vector<std::vector<std::string>> rows;
  for (std::size_t r = 0; r < s.matrix.entries.rows(); ++r) {
    rows.emplace_back();
    for (std::size_t c = 0; c < s.matrix.entries.columns(); ++c)
      rows.back().push_back(s.matrix.entries(r, c).to_string());
  }
  out += aligned(rows, "  ", true) + "\ncharacteristic polynomial";
  const auto name_of_factor = [](std::size_t i) { return "p" + std::to_string(i + 1); };
  for (std::size_t i = 0; i < s.factors.size(); ++i)
    out += (i == 0 ? " " : "*") + name_of_factor(i) +
           (s.factors[i].multiplicity > 1 ? "^" + std::to_string(s.factors[i].multiplicity) : "");
  out += "\n";
  for (std::size_t i = 0; i < s.factors.size(); ++i)
    out += "  " + name_of_factor(i) + " = " + analysis::polynomial_text(s.factors[i].polynomial, s.variable) + "\n";
  rows = {{"eigenvalue", "decimal", "multiplicity", "geometric"}};
  for (const auto& e : s.eigenvalues) {
    const SpectralFactor& f = s.factors[e.factor];
    const std::string root = (e.roots > 1 ? "roots of " : "root of ") + name_of_factor(e.factor);
    rows.push_back({"  " + (e.exact.empty() ? root : e.exact), e.decimal, std::to_string(f.multiplicity),
                    std::to_string(f.geometric)});
  }
  out += "\n" + aligned(rows, "", false) + "\neigenvectors\n";
  for (std::size_t i = 0; i < s.factors.size(); ++i) {
    const SpectralFactor& f = s.factors[i];
    out += "  " + (f.degree() == 1 ? (-f.polynomial[0]).to_string() : s.variable + ", a root of " + name_of_factor(i)) +
           "\n";
    for (const auto& v : f.left) out += "    left  " + vector_text(s, v) + "\n";
    for (const auto& v : f.right) out += "    right " + vector_text(s, v) + "\n";
  }
  return out;
}

std::string to_text(const Scheme& scheme, const Place& place, const Spectrum& s) {
  std::string out = decomposition_text(scheme, place, s);
  if (!s.stencils.empty()) out += "\nlimit stencils at t = 0\n";
  for (const auto& l : s.stencils) {
    out += l.derivative == 0 ? "  value       " : "  derivative " + std::to_string(l.derivative);
    for (std::size_t i = 0; i < l.coefficients.size(); ++i) {
      if (l.coefficients[i].is_zero()) continue;
      out += "  [" + l.coefficients[i].to_string() + "] f_" + std::to_string(l.lowest + static_cast<long>(i));
    }
    out += static_cast<long>(l.derivative) > s.necessary.order ? "  (for polynomial data)\n" : "\n";
  }
  return out + "\n" + necessary_text(s.necessary);
}

// A scheme whose vertices carry derivatives: the mask of small steps, in the scale of its own spectral condition.
std::string hermite_spectrum(const Scheme& given, const Values& at, bool json) {
  Scheme scheme = given;
  ChosenMask chosen;
  for (const auto& [name, text] : at.named()) {
    chosen.values.emplace_back(name, rational_value(name, text));
    const std::string id = scheme.id;
    scheme = with_values(scheme, {{name, RationalFunction(chosen.values.back().second)}});
    scheme.id = id;
  }
  const analysis::HermiteMask mask = analysis::hermite_mask(scheme);
  const analysis::SpectralCondition condition = analysis::spectral_condition(mask);
  const bool scaled = condition.scales.size() == mask.block;
  const Spectrum s = analysis::spectrum(
      analysis::local_matrix(scaled ? analysis::rescaled(mask, condition.scales) : mask), mask.arity);
  const auto polynomial = [](const std::vector<RationalFunction>& p) { return analysis::polynomial_text(p, "x"); };
  if (json) {
    Json j = decomposition_json(scheme, place_of(scheme, chosen), s);
    Json scales = Json::array();
    for (const auto& c : condition.scales) scales.push_back(c.to_string());
    Json polynomials = Json::array();
    for (const auto& p : condition.polynomials) polynomials.push_back(polynomial(p));
    j["hermite"] = Json::object({{"derivatives", mask.block - 1},
                                 {"spectral_order", condition.order},
                                 {"scales", scales},
                                 {"polynomials", polynomials},
                                 {"consistent", condition.consistent},
                                 {"reproduces_polynomials", condition.reproduces}});
    return j.dump(1);
  }
  std::string out = decomposition_text(scheme, place_of(scheme, chosen), s);
  out += "\nspectral condition  of order " + std::to_string(condition.order);
  if (condition.order == condition.searched) out += " at least";
  out += condition.reproduces ? ", polynomials of this degree are reproduced\n" : "\n";
  const std::string parameter = mask.parameter.empty() ? "the parameter" : mask.parameter;
  for (std::size_t k = 1; k < condition.scales.size(); ++k)
    out += "  derivative " + std::to_string(k) + " carried = " + condition.scales[k].to_string() +
           " times the derivative of the limit in " + parameter + "\n";
  for (const auto& p : condition.polynomials) out += "  eigenpolynomial " + polynomial(p) + "\n";
  return out + (condition.consistent ? "consistent: derivatives of one parameter\n" : "not consistent\n");
}

// What belongs to a junction: alpha (a variable if not given) and the two values of the edge parameter, which are at
// rest if they are not given.
struct JunctionValues {
  RationalFunction alpha = RationalFunction::variable("alpha");
  std::string edge;  // name of the edge parameter; empty: there is none
  std::vector<RationalFunction> lambda = std::vector<RationalFunction>(2, Rational(1, 2));

  Place place() const {
    Place p{"junction", "junction", {{"alpha", alpha.to_string()}}};
    if (!edge.empty()) p.values.emplace_back(edge, "[" + lambda[0].to_string() + ", " + lambda[1].to_string() + "]");
    return p;
  }
};

JunctionValues junction_values(const Scheme& scheme, const Values& at) {
  JunctionValues r;
  for (const auto& p : scheme.parameters) {
    if (!p.rest) continue;
    if (!r.edge.empty()) bad_input("this scheme has more than one edge parameter", scheme.id);
    r.edge = p.name;
    r.lambda = {*p.rest, *p.rest};
  }
  std::vector<std::string> seen;
  for (const auto& [name, text] : at.named()) {
    if (std::find(seen.begin(), seen.end(), name) != seen.end()) bad_input("--at: a value is given twice", name);
    seen.push_back(name);
    std::vector<RationalFunction> list = expression_list(name, text);
    const auto parameter = std::find_if(scheme.parameters.begin(), scheme.parameters.end(),
                                        [&, &given = name](const auto& p) { return p.name == given && p.rest; });
    if (name != "alpha" && parameter == scheme.parameters.end())
      bad_input("--at: a junction of " + scheme.id + " has no parameter of this name (alpha, lambda)", name);
    const std::size_t count = name == "alpha" ? 1 : 2;
    if (list.size() != count)
      bad_input("--at: " + name + " takes " + std::to_string(count) + " value" + (count == 1 ? "" : "s"), text);
    if (name == "alpha") {
      if (const auto c = list[0].constant(); c && c->sign() <= 0) bad_input("--at: alpha must be positive", text);
      r.alpha = list[0];
    } else {
      for (const auto& v : list) check_local_value(scheme, *parameter, v);
      r.lambda = std::move(list);
    }
  }
  return r;
}

// `spectrum` of a scheme on knots. An edge parameter that is a variable, or an expression in one, gives one answer for
// each side of 1/2 of the variable.
std::vector<std::pair<Place, Spectrum>> junction_spectra(const Scheme& scheme, const JunctionValues& given) {
  const auto& [alpha, edge, lambda] = given;
  std::vector<std::string> variables;
  for (const auto& l : lambda)
    for (const auto& v : l.variables())
      if (std::find(variables.begin(), variables.end(), v) == variables.end()) variables.push_back(v);
  if (variables.size() > 2) bad_input("--at: the edge parameters have more than two variables", variables.back());

  std::vector<std::pair<Place, Spectrum>> all;
  for (unsigned branch = 0; branch < (1U << variables.size()); ++branch) {
    Place place = given.place();
    std::map<std::string, Rational> sample;
    for (std::size_t v = 0; v < variables.size(); ++v) {
      const bool upper = (branch >> v & 1U) != 0;
      sample[variables[v]] = upper ? Rational(3, 4) : Rational(1, 4);
      place.values.emplace_back("side of " + variables[v], upper ? ">= 1/2" : "<= 1/2");
    }
    for (const auto& v : alpha.variables())
      if (!sample.contains(v)) sample[v] = 1;
    all.emplace_back(std::move(place),
                     analysis::spectrum(analysis::junction(scheme, alpha, lambda[0], lambda[1], sample)));
  }
  return all;
}

// The same of a sampled rule: at numbers; with alpha a symbol as make_scheme has it, the edge parameters being at rest.
std::vector<std::pair<Place, Spectrum>> sampled_spectra(const SampledScheme& scheme, const Values& at) {
  const JunctionValues given = junction_values(scheme.outline(), at);
  const auto alpha = given.alpha.constant(), left = given.lambda[0].constant(), right = given.lambda[1].constant();
  if (alpha && left && right)
    return {{given.place(), analysis::spectrum(analysis::junction(scheme, *alpha, *left, *right))}};
  const bool rest = left == scheme.rest && right == scheme.rest;
  if (!rest || !scheme.symbolic())
    bad_input("--at: numbers are needed for alpha" + std::string(rest ? "" : " and lambda") + " of " + scheme.id,
              alpha ? given.lambda[left ? 1 : 0].to_string() : given.alpha.to_string());
  return junction_spectra(make_scheme(scheme.id), {given.alpha, {}, given.lambda});
}

}  // namespace

ChosenMask chosen_mask(const Scheme& scheme, const Values& at) {
  ChosenMask r;
  if (at.at.empty()) {
    const auto limit = limit_symbol(scheme);
    if (!limit)
      bad_input("the masks have no limit (a pole where the level variables are 1), give --at NAME=VALUE", scheme.id);
    r.mask = *limit;
    return r;
  }
  r.limit = false;
  r.mask = symbol(scheme);
  std::vector<std::string> names = r.mask.variables();
  for (const auto& p : scheme.parameters) names.push_back(p.name);
  for (const auto& [name, text] : at.named()) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      std::string known;
      std::sort(names.begin(), names.end());
      names.erase(std::unique(names.begin(), names.end()), names.end());
      for (const auto& n : names) known += (known.empty() ? "" : ", ") + n;
      bad_input("--at: the mask of " + scheme.id + " has no variable of this name (it has " +
                    (known.empty() ? "none" : known) + ")",
                name);
    }
    if (std::any_of(r.values.begin(), r.values.end(), [&, &given = name](const auto& v) { return v.first == given; }))
      bad_input("--at: a value is given twice", name);
    const Rational value = rational_value(name, text);
    for (const auto& p : scheme.parameters)
      if (p.name == name && p.scope == Parameter::Scope::constant && p.domain && !p.domain->contains(value))
        bad_input("--at: the value lies outside the domain " + p.domain->to_string() + " of " + name, text);
    for (const auto& c : r.mask.coefficients())
      for (const auto& [f, e] : c.denominator_factors())
        if (RationalFunction(f).substitute(name, value).is_zero())
          bad_input("--at: the mask has a pole there", name + "=" + text);
    r.mask = r.mask.substitute(name, value);
    r.values.emplace_back(name, value);
  }
  return r;
}

void add_spectrum_command(CLI::App& app, Session& session) {
  auto name = std::make_shared<std::string>();
  auto values = std::make_shared<Values>();
  CLI::App* c = add_command(app, session, "spectrum",
                            "exact local subdivision matrix, eigenvalues, eigenvectors, limit stencils");
  c->add_option("scheme", *name, "scheme name")->required()->type_name("SCHEME");
  c->add_option("--at", values->at,
                "rational values of variables of the mask instead of the limit mask, the others stay (\"\": all)")
      ->type_name("NAME=VALUE")
      ->take_all();
  c->callback([&session, name, values] {
    session.action = [&session, name, values] {
      const auto sampled = sampled_scheme(*name);
      const Scheme scheme = sampled ? sampled->outline() : make_scheme(*name);
      if (scheme.block > 1) {
        deliver(session.common, hermite_spectrum(scheme, *values, session.common.format == "json"));
        return 0;
      }
      std::vector<std::pair<Place, Spectrum>> all;
      if (sampled) {
        all = sampled_spectra(*sampled, *values);
      } else if (scheme.kernel.empty()) {
        const ChosenMask chosen = chosen_mask(scheme, *values);
        all.emplace_back(place_of(scheme, chosen), analysis::spectrum(chosen.mask, scheme.arity));
      } else {
        all = junction_spectra(scheme, junction_values(scheme, *values));
      }
      if (session.common.format == "json") {
        Json j = to_json(scheme, all[0].first, all[0].second);
        for (std::size_t i = 1; i < all.size(); ++i)
          j["branches"].push_back(to_json(scheme, all[i].first, all[i].second));
        deliver(session.common, j.dump(1));
      } else {
        std::string text;
        for (const auto& [place, s] : all) text += (text.empty() ? "" : "\n") + to_text(scheme, place, s);
        deliver(session.common, text);
      }
      return 0;
    };
  });
}

}  // namespace twoscale::cli
