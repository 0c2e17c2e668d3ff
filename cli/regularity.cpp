// SPDX-License-Identifier: GPL-3.0-or-later
// twoscale regularity: exact or enclosed exponents of a scheme, or the joint spectral radius of given matrices.
#include "regularity.hpp"

#include <unistd.h>
#include <nlohmann/json.hpp>

#include <iostream>
#include <sstream>
#include <thread>

#include "hermite.hpp"
#include "session.hpp"
#include "twoscale/analysis/certificate.hpp"
#include "twoscale/analysis/parameter_range.hpp"
#include "twoscale/analysis/regularity.hpp"
#include "twoscale/kernels/points_io.hpp"
#include "twoscale/kernels/write_file.hpp"
#include "twoscale/reports/derivation.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::cli {

namespace {

using Json = nlohmann::ordered_json;
using analysis::Exponent;
using analysis::JsrResult;
using analysis::RealAlgebraic;
using analysis::Regularity;

struct Options {
  std::string scheme;
  std::vector<std::string> at;
  std::string over;
  std::string matrices;
  std::string certificate;
  std::string width = "1/10000";
  size_t vertices = 1500;
  bool limited = false;  // a width or a limit was asked for
};

// ---- Values out

std::string decimal(const Rational& r) { return rounded_decimal(r, 10); }

Json algebraic_json(const RealAlgebraic& r) {
  if (const auto text = r.expression()) return *text;
  RealAlgebraic fine = r;
  fine.refine(Rational(1, 1L << 50));
  return Json::object({{"polynomial", fine.polynomial().to_string()},
                       {"interval", {fine.lower().to_string(), fine.upper().to_string()}}});
}

std::string algebraic_text(const RealAlgebraic& r) {
  const auto text = r.expression();
  if (text) return *text;
  const std::string polynomial = r.polynomial().pretty();
  return (polynomial.size() <= 200 ? "the zero of " + polynomial
                                   : "the zero of a polynomial of degree " + std::to_string(r.degree())) +
         " near " + decimal(r.lower());
}

Json optional_rational(const std::optional<Rational>& r) { return r ? Json(r->to_string()) : Json(nullptr); }

Json exponent_json(const Exponent& e) {
  Json j;
  if (!e.expression)
    j["exact"] = nullptr;
  else if (e.rho)
    j["exact"] = Json::object({{"expression", *e.expression}, {"rho", algebraic_json(*e.rho)}});
  else
    j["exact"] = *e.expression;
  j["lower"] = optional_rational(e.lower);
  j["upper"] = optional_rational(e.upper);
  return j;
}

std::string exponent_text(const Exponent& e) {
  if (e.rational) return e.rational->to_string() + " exactly";
  if (e.expression) return *e.expression + " = " + decimal(*e.lower) + " exactly";
  if (e.lower && e.upper) return "between " + decimal(*e.lower) + " and " + decimal(*e.upper);
  if (e.lower) return "at least " + decimal(*e.lower);
  return "not bounded";
}

std::string word_text(const analysis::Word& w) {
  std::string text;
  for (const int s : w) text += (text.empty() ? "" : " ") + std::to_string(s);
  return "(" + text + ")";
}

Json jsr_json(const JsrResult& r) {
  Json j;
  j["exact"] = r.exact ? algebraic_json(*r.exact) : Json(nullptr);
  j["lower"] = r.lower.to_string();
  j["upper"] = r.upper.to_string();
  j["cycles"] = r.cycles;
  j["bounded_products"] = r.bounded ? Json(true) : Json(nullptr);
  return j;
}

std::string jsr_text(const JsrResult& r) {
  std::string text;
  if (r.exact)
    text = algebraic_text(*r.exact) + (r.exact->degree() > 1 ? " = " + decimal(r.lower) : "") + " exactly";
  else
    text = "between " + decimal(r.lower) + " and " + decimal(r.upper);
  text += ", by " + r.method;
  if (!r.cycles.empty()) {
    text += r.exact ? ", attained by" : ", lower bound by";
    for (const auto& w : r.cycles) text += " " + word_text(w);
  }
  return text;
}

Json document(const std::string& label) {
  Json j;
  j["format"] = "twoscale/regularity";
  j["version"] = 1;
  j["scheme"] = label;
  return j;
}

std::string hyphenated(std::string text) {
  std::replace(text.begin(), text.end(), ' ', '-');
  return text;
}

std::string regularity_json(const Scheme& s, const Regularity& r, const std::string& certificate) {
  Json j = document(s.id);
  j["arity"] = s.arity;
  j["continuity"] = r.continuity;
  j["hoelder"] = exponent_json(r.hoelder);
  j["sobolev"] = exponent_json(r.sobolev);
  j["attained"] = r.attained ? Json(*r.attained) : Json(nullptr);
  j["sum_rules"] = r.order;
  Json c = Json::array();
  for (const auto& x : r.c) c.push_back(x.to_string());
  j["remainder"] = c;
  if (!r.obstacle.empty()) {
    j["jsr"] = nullptr;
    j["stable"] = nullptr;
    j["method"] = "none";
    j["obstacle"] = r.obstacle;
  } else {
    j["jsr"] = jsr_json(r.jsr);
    Json matrices = Json::array();
    for (const auto& b : r.matrices) {
      Json rows = Json::array();
      for (long i = 0; i < b.rows(); ++i) {
        Json row = Json::array();
        for (long k = 0; k < b.columns(); ++k) row.push_back(b(i, k).to_string());
        rows.push_back(row);
      }
      matrices.push_back(rows);
    }
    j["transition_matrices"] = matrices;
    j["blocks"] = r.blocks;
    j["stable"] = r.stability.stable;
    j["method"] = hyphenated(r.method);
  }
  if (r.level_dependent) {
    const Laurent a = *limit_symbol(s);
    j["limit_scheme"] = reports::laurent_json(a);
    j["applies_to_all_levels"] = r.transferred;
    j["generated_space"] = r.generated.empty() ? Json(nullptr) : Json(r.generated);
    j["excluded_v0"] = r.excluded;
  } else {
    j["limit_scheme"] = nullptr;
  }
  j["certificate"] = certificate.empty() ? Json(nullptr) : Json(certificate);
  return j.dump(1);
}

std::string stability_text(const analysis::Stability& s) {
  if (s.stable) return "the integer shifts are stable";
  if (s.common_zero) return "the integer shifts are not stable: the sub-symbols share a zero on the unit circle";
  return "the integer shifts are not stable: a cycle of roots of unity of order " + std::to_string(s.cycle);
}

std::string regularity_text(const Scheme& s, const Regularity& r, const std::string& certificate) {
  std::ostringstream out;
  out << s.id << (r.level_dependent ? ": the limit of its masks" : "") << "\n";
  out << "sum rules   order " << r.order << "\n";
  if (!r.obstacle.empty()) {
    out << "diverges    " << r.obstacle << "\n";
    return out.str();
  }
  std::string remainder;
  for (const auto& c : r.c) remainder += " " + c.to_string();
  out << "remainder   c =" << (remainder.size() <= 300 ? remainder : " " + std::to_string(r.c.size()) + " coefficients")
      << "\n";
  out << "matrices    " << r.matrices.size() << " of size " << r.matrices[0].rows();
  if (r.blocks.size() == 1) out << ", no common invariant subspace found";
  if (r.blocks.size() > 1) out << ", block triangular with blocks of sizes";
  for (const long b : r.blocks)
    if (r.blocks.size() > 1) out << " " << b;
  out << "\n";
  out << "radius      rho = " << jsr_text(r.jsr) << "\n";
  out << "stability   " << stability_text(r.stability) << "\n";
  out << "Hölder      " << exponent_text(r.hoelder);
  if (r.attained) {
    const bool integer = r.hoelder.rational && r.hoelder.rational->is_integer();
    if (integer) {
      const std::string k = std::to_string(r.hoelder.rational->to_long() - 1);
      out << (*r.attained ? "; attained: derivative " + k + " is Lipschitz"
                          : "; not attained: derivative " + k + " is not Lipschitz");
    } else {
      out << (*r.attained ? "; attained" : "; not attained");
    }
  }
  out << "\n";
  out << "Sobolev     " << exponent_text(r.sobolev) << "\n";
  out << "continuity  " << (r.continuity < 0 ? "not proved to be C^0" : "C^" + std::to_string(r.continuity)) << "\n";
  if (r.level_dependent) {
    if (r.transferred)
      out << "all levels  the scheme generates {" << r.generated
          << "}, as many functions as the limit has sum rules: the\n"
          << "            exponent and C^l above hold for the scheme itself, for "
          << (level_variables(s).empty() ? analysis::start_values(s) : "every v^0") << " without a singular step"
          << (r.stability.stable ? ";\n            no larger exponent holds from every starting level" : "") << "\n";
    else
      out << "all levels  not transferred: the scheme is not known to generate " << r.order
          << " exponential polynomials\n";
    if (!r.excluded.empty()) {
      out << "excluded   ";
      for (const auto& e : r.excluded) out << " " << e << ";";
      out << "\n";
    }
  }
  if (!certificate.empty()) out << "certificate " << certificate << "\n";
  return out.str();
}

// ---- Matrices in

// Reads nested arrays whose leaves keep their spelling, so that 0.1 stays 1/10.
class SpelledJson : public nlohmann::json_sax<nlohmann::json> {
 public:
  struct Node {
    bool leaf = false;
    std::string text;
    std::vector<Node> items;
  };
  Node root;

  bool null() override { return put("null"); }
  bool boolean(bool value) override { return put(value ? "true" : "false"); }
  bool number_integer(number_integer_t value) override { return put(std::to_string(value)); }
  bool number_unsigned(number_unsigned_t value) override { return put(std::to_string(value)); }
  bool number_float(number_float_t, const string_t& spelling) override { return put(spelling); }
  bool string(string_t& value) override { return put(value); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { bad_input("an array of matrices is expected, not an object"); }
  bool key(string_t&) override { return false; }
  bool end_object() override { return false; }
  bool start_array(std::size_t) override {
    if (open_.size() > 3) bad_input("the arrays are nested more than three deep");
    Node* parent = open_.empty() ? nullptr : open_.back();
    if (parent == nullptr) {
      open_.push_back(&root);
    } else {
      parent->items.emplace_back();
      open_.push_back(&parent->items.back());
    }
    return true;
  }
  bool end_array() override {
    open_.pop_back();
    return true;
  }
  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception&) override {
    bad_input("not JSON, near byte " + std::to_string(position));
  }

 private:
  bool put(const std::string& text) {
    if (open_.empty()) bad_input("an array of matrices is expected", text.substr(0, 40));
    open_.back()->items.push_back({true, text, {}});
    return true;
  }
  std::vector<Node*> open_;
};

analysis::Family read_matrices(const std::string& file) {
  SpelledJson reader;
  const std::string text = kernels::read_file(file);
  try {
    nlohmann::json::sax_parse(text, &reader);
  } catch (const Error& e) {
    throw Error(e.kind, file + ": " + e.what());
  }
  const auto& list = reader.root.items;
  if (list.empty()) bad_input(file + ": no matrices");
  if (list.size() > 256) bad_input(file + ": more than 256 matrices");
  analysis::Family family;
  for (size_t k = 0; k < list.size(); ++k) {
    const std::string where = file + ": matrix " + std::to_string(k + 1);
    const auto n = static_cast<long>(list[k].items.size());
    if (list[k].leaf || n == 0) bad_input(where + " is not an array of rows");
    if (n > 64) bad_input(where + " is larger than 64 x 64");
    if (k > 0 && n != family[0].rows()) bad_input(where + " has another size than the first");
    analysis::RationalMatrix m(n, n);
    for (long i = 0; i < n; ++i) {
      const auto& row = list[k].items[static_cast<size_t>(i)];
      if (row.leaf || static_cast<long>(row.items.size()) != n)
        bad_input(where + ", row " + std::to_string(i + 1) + ": " + std::to_string(n) + " numbers are expected");
      for (long j = 0; j < n; ++j) {
        const auto& entry = row.items[static_cast<size_t>(j)];
        const std::string place = where + ", row " + std::to_string(i + 1) + ", column " + std::to_string(j + 1);
        if (!entry.leaf) bad_input(place + ": a number is expected");
        if (entry.text.size() > 10000) bad_input(place + ": a number of more than 10000 characters");
        try {
          const auto value = parse_rational_function(entry.text).constant();
          if (!value) bad_input("not a rational number", entry.text);
          m.set(i, j, *value);
        } catch (const Error& e) {
          bad_input(place + ": " + e.what());
        }
      }
    }
    family.push_back(std::move(m));
  }
  return family;
}

// ---- The command

analysis::JsrOptions search_options(const Session& session, const Options& o) {
  analysis::JsrOptions options;
  const auto width = parse_rational_function(o.width).constant();
  if (!width || width->sign() <= 0) bad_input("--width: a positive rational number is expected", o.width);
  options.width = *width;
  options.vertices = o.vertices;
  options.threads = session.common.threads > 0 ? session.common.threads
                                               : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  if (session.common.time_limit > 0) options.seconds = 0.85 * session.common.time_limit;
  if (!session.common.quiet && isatty(STDERR_FILENO) != 0)
    options.progress = [](const std::string& line) { std::cerr << "twoscale: " << line << "\n"; };
  return options;
}

// 3 if the limits that were asked for ended the search before the width that was to be reached.
int status(const JsrResult& r, const analysis::JsrOptions& options, const Options& o) {
  if (r.exact || !o.limited) return 0;
  return r.upper <= r.lower * (Rational(1) + Rational(2) * options.width) ? 0 : 3;
}

int run_matrices(const Session& session, const Options& o) {
  const analysis::Family family = read_matrices(o.matrices);
  const analysis::JsrOptions options = search_options(session, o);
  const JsrResult r = analysis::joint_spectral_radius(family, {}, options);
  const std::string certificate = analysis::certificate_text(o.matrices, family, r.claims);
  if (session.common.format == "json") {
    Json j = document(o.matrices);
    j["jsr"] = jsr_json(r);
    j["method"] = hyphenated(r.method);
    j["certificate"] = o.certificate.empty() ? Json(nullptr) : Json(o.certificate);
    deliver(session.common, j.dump(1), o.certificate, certificate);
  } else {
    deliver(session.common,
            std::to_string(family.size()) + " matrices of size " + std::to_string(family[0].rows()) + "\nradius      " +
                jsr_text(r) + "\n",
            o.certificate, certificate);
  }
  return status(r, options, o);
}

int run_scheme(const Session& session, const Options& o) {
  if (Scheme given = make_scheme(o.scheme); given.block > 1)
    return regularity_of_vertices(std::move(given), o.at, o.certificate, session);
  const Scheme scheme = with_default_values(with_constants(make_scheme(o.scheme), o.at));
  analysis::RegularityOptions options;
  options.jsr = search_options(session, o);
  const Regularity r = analysis::regularity(scheme, options);
  const std::string certificate = r.certificate.empty() ? "" : o.certificate;
  deliver(session.common,
          session.common.format == "json" ? regularity_json(scheme, r, certificate)
                                          : regularity_text(scheme, r, certificate),
          certificate, r.certificate);
  return r.obstacle.empty() ? status(r.jsr, options.jsr, o) : 0;
}

// ---- Along a parameter

Json interval_json(const analysis::ParameterInterval& i) {
  return Json::object({{"from", algebraic_json(i.from)},
                       {"to", algebraic_json(i.to)},
                       {"from_included", i.from_included},
                       {"to_included", i.to_included}});
}

std::string interval_text(const analysis::ParameterInterval& i) {
  const auto end = [](const RealAlgebraic& r) {
    return r.rational() && r.rational()->to_string().size() < 12 ? r.rational()->to_string()
           : r.expression() && !r.rational()                     ? *r.expression() + " = " + decimal(r.lower())
                                                                 : decimal(r.lower());
  };
  return (i.from_included ? "[" : "(") + end(i.from) + ", " + end(i.to) + (i.to_included ? "]" : ")");
}

Json intervals_json(const std::vector<analysis::ParameterInterval>& list) {
  Json a = Json::array();
  for (const auto& i : list) a.push_back(interval_json(i));
  return a;
}

std::string over_json(const Scheme& s, const analysis::ParameterRange& r, const std::string& certificate) {
  Json j = document(s.id);
  j["arity"] = s.arity;
  j["over"] = Json::object({{"name", r.name}, {"interval", {r.from.to_string(), r.to.to_string()}}});
  j["sum_rules"] = r.order;
  Json radius = Json::array();
  for (const auto& x : r.radius) {
    Json e = interval_json(x.interval);
    e["exact"] = x.expression.empty() ? Json(nullptr) : Json(x.expression);
    e["polynomial"] = x.polynomial.to_string();
    e["method"] = hyphenated(x.method);
    e["cycles"] = x.cycles;
    radius.push_back(e);
  }
  j["radius"] = radius;
  Json continuity = Json::array();
  for (const auto& c : r.continuity)
    continuity.push_back(Json::object({{"l", c.l},
                                       {"proved", intervals_json(c.proved)},
                                       {"refuted", intervals_json(c.refuted)},
                                       {"level_dependent", c.joint ? interval_json(*c.joint) : Json(nullptr)}}));
  j["continuity"] = continuity;
  const auto sample = [&](const std::pair<Rational, Regularity>& x) {
    return Json::object({{"value", x.first.to_string()},
                         {"sum_rules", x.second.order},
                         {"continuity", x.second.continuity},
                         {"hoelder", exponent_json(x.second.hoelder)}});
  };
  j["exceptional"] = r.exceptional ? sample(*r.exceptional) : Json(nullptr);
  Json samples = Json::array();
  for (const auto& x : r.samples) samples.push_back(sample(x));
  j["samples"] = samples;
  j["certificate"] = certificate.empty() ? Json(nullptr) : Json(certificate);
  return j.dump(1);
}

std::string over_text(const Scheme& s, const analysis::ParameterRange& r, const std::string& certificate) {
  std::ostringstream out;
  out << s.id << ", " << r.name << " in [" << r.from.to_string() << ", " << r.to.to_string() << "]\n";
  out << "sum rules   order " << r.order << " for every " << r.name << "\n";
  for (const auto& x : r.radius) {
    out << "radius      " << interval_text(x.interval) << ": rho = ";
    if (x.expression.empty())
      out << "the largest zero x of " << x.polynomial.pretty();
    else
      out << x.expression;
    out << ", by " << x.method << "\n";
  }
  for (const auto& c : r.continuity) {
    const std::string name = "C^" + std::to_string(c.l);
    const auto list = [&](const std::vector<analysis::ParameterInterval>& intervals) {
      std::string text;
      for (const auto& i : intervals) text += (text.empty() ? "" : " and ") + interval_text(i);
      return text;
    };
    out << name << "         "
        << (c.proved.empty() ? "nowhere proved" : "proved for " + r.name + " in " + list(c.proved)) << "\n";
    if (!c.refuted.empty())
      out << "            rho >= " << s.arity << "^" << r.order - c.l << ", so not " << name
          << " where the integer shifts are stable: " << list(c.refuted) << "\n";
    if (c.joint)
      out << "            any " << r.name << " at each level from " << interval_text(*c.joint) << ": " << name << "\n";
  }
  if (r.exceptional)
    out << "exception   " << r.name << " = " << r.exceptional->first.to_string() << ": sum rules of order "
        << r.exceptional->second.order << ", C^" << r.exceptional->second.continuity << ", Hölder "
        << exponent_text(r.exceptional->second.hoelder) << "\n";
  for (const auto& [w, x] : r.samples)
    out << "sample      " << r.name << " = " << w.to_string() << ": C^" << x.continuity << ", Hölder "
        << exponent_text(x.hoelder) << "\n";
  if (!certificate.empty()) out << "certificate " << certificate << "\n";
  return out.str();
}

int run_over(const Session& session, const Options& o) {
  const Over over = parse_over(o.over);
  if (make_scheme(o.scheme).block > 1)
    bad_input("--over is for masks; the claims continuity and curvature of prove hold for all values of w", o.scheme);
  const Scheme scheme = along(with_constants(make_scheme(o.scheme), o.at), over);
  analysis::ParameterOptions options;
  options.regularity.jsr = search_options(session, o);
  options.threads = options.regularity.jsr.threads;
  const analysis::ParameterRange r = analysis::parameter_range(scheme, over.name, over.from, over.to, options);
  const std::string certificate = r.certificate.empty() ? "" : o.certificate;
  deliver(session.common,
          session.common.format == "json" ? over_json(scheme, r, certificate) : over_text(scheme, r, certificate),
          certificate, r.certificate);
  return 0;
}

}  // namespace

Scheme with_constants(Scheme scheme, const std::vector<std::string>& at) {
  Values values;
  values.at = at;
  std::vector<std::pair<std::string, RationalFunction>> list;
  for (const auto& [name, text] : values.named()) {
    if (text.empty()) bad_input("--at: a value is missing for", name);
    for (const auto& [other, value] : list)
      if (other == name) bad_input("--at: given twice", name);
    for (const auto& p : scheme.parameters)
      if (p.name == name && p.scope == Parameter::Scope::level)
        bad_input("the answer holds for all levels and every v^0: no value is taken for", name);
    const RationalFunction value = parse_rational_function(text);
    if (!value.constant()) bad_input("--at " + name + ": a rational number is expected", text);
    list.emplace_back(name, value);
  }
  return with_values(scheme, list);
}

Scheme along(Scheme scheme, const Over& over) {
  for (auto& p : scheme.parameters)
    if (p.name == over.name) p.domain.reset();
  return scheme;
}

Over parse_over(const std::string& text) {
  const auto equals = text.find('=');
  const std::string name = trimmed(text.substr(0, equals));
  const std::string range = equals == std::string::npos ? "" : trimmed(text.substr(equals + 1));
  if (name.empty() || range.size() < 2 || range.front() != '[' || range.back() != ']')
    bad_input("--over: NAME=[A,B] is expected", text);
  const auto ends = split_list(std::string_view(range).substr(1, range.size() - 2));
  if (ends.size() != 2) bad_input("--over: NAME=[A,B] is expected", text);
  std::vector<Rational> values;
  for (const auto& end : ends) {
    const auto value = parse_rational_function(end).constant();
    if (!value) bad_input("--over: a rational number is expected", end);
    values.push_back(*value);
  }
  if (!(values[0] < values[1])) bad_input("--over: the lower end is not below the upper end", text);
  return {name, values[0], values[1]};
}

void add_regularity_command(CLI::App& app, Session& session) {
  auto o = std::make_shared<Options>();
  CLI::App* c = add_command(app, session, "regularity",
                            "exact or enclosed Hölder and Sobolev exponents, C^m, with a certificate");
  c->add_option("scheme", o->scheme, "scheme name")->type_name("SCHEME");
  c->add_option("--at", o->at, "values of the scheme's constants, NAME=VALUE,...")->type_name("NAME=VALUE")->take_all();
  c->add_option("--over", o->over, "along one constant: where the scheme is C^l, closed forms of the radius")
      ->type_name("NAME=[A,B]");
  c->add_option("--matrices", o->matrices, "JSON list of rational matrices: their joint spectral radius alone")
      ->type_name("FILE");
  c->add_option("--certificate", o->certificate, "write the certificate here")->type_name("FILE");
  c->add_option("--width", o->width, "relative width of an enclosure of the radius to reach, 1/10000 by default")
      ->type_name("Q");
  c->add_option("--vertices", o->vertices, "most vertices of a polytope, 1500 by default")
      ->check(CLI::Range(4, 100000));
  c->callback([&session, o, c] {
    session.keeps_time = true;
    o->limited = c->count("--width") + c->count("--vertices") > 0 || session.common.time_limit > 0;
    session.action = [&session, o] {
      if (o->scheme.empty() == o->matrices.empty()) bad_input("regularity needs a scheme or --matrices FILE");
      if (!o->matrices.empty() && (!o->over.empty() || !o->at.empty()))
        bad_input("--matrices takes no parameters", o->over.empty() ? o->at.front() : o->over);
      if (!o->matrices.empty()) return run_matrices(session, *o);
      return o->over.empty() ? run_scheme(session, *o) : run_over(session, *o);
    };
  });
}

}  // namespace twoscale::cli
