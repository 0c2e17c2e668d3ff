// SPDX-License-Identifier: GPL-3.0-or-later
// twoscale table SCHEME [--v0 E|--t E|--at ...] --levels K [--digits D|--double] [--format F]: mask tables;
// --evaluator: the table of all parameter values as a program.
#include <algorithm>
#include <sstream>

#include "local_values.hpp"
#include "session.hpp"
#include "twoscale/kernels/export/table_writer.hpp"
#include "twoscale/kernels/write_file.hpp"
#include "twoscale/lowering/emit.hpp"
#include "twoscale/lowering/filter_table.hpp"
#include "twoscale/lowering/normalised.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::cli {

namespace {

struct Options {
  std::string scheme;
  Values values;
  unsigned levels = 0;
  long digits = 17;
  bool doubles = false;
  bool hex = false;
  std::string prefix;
  std::string normalisation = "arity";
  bool evaluator = false;
  long points = 8;
};

// For people: the facts, then one line a coefficient with the decimal points in one column.
std::string table_text(const kernels::MaskTable& t) {
  std::ostringstream out;
  const auto facts = [&](const char* name, const std::vector<std::pair<std::string, std::string>>& list) {
    for (const auto& [key, value] : list) out << name << key << " = " << value << "\n";
  };
  out << "scheme         " << t.scheme << "\n";
  facts("parameter      ", t.parameters);
  facts("level          ", t.level_variables);
  if (!t.recurrence.empty()) out << "recurrence     " << t.recurrence << "\n";
  const std::string m = std::to_string(t.arity);
  out << "rule           f^{k+1}_i = sum_j a^{[k]}_{i-" << m << "*j} f^k_j, arity " << m << "\n";
  out << "support        [" << t.limit.lowest << ", " << t.limit.highest() << "]\n";
  out << "p              " << t.shift << "; f^k_j belongs to (j + p)/" << m << "^k\n";
  if (!t.printed.empty()) out << "printed        " << t.printed << "\n";
  out << "normalisation  " << t.normalisation << "\n";
  out << "precision      "
      << (t.digits > 0 ? std::to_string(t.digits) + " significant digits" : "correctly rounded doubles")
      << ", error at most " << t.precision_error << "\n";
  out << "tail           |a^{[k]}_i - a_i| <= " << t.tail_bound << " for all k >= " << t.tail_from << "\n";

  std::size_t before = 1;  // characters before the point
  const auto head = [](const std::string& s) { return std::min(s.find_first_of(".e"), s.size()); };
  const auto widen = [&](const kernels::MaskRow& row) {
    for (const auto& s : row.text) before = std::max(before, head(s));
  };
  for (const auto& row : t.levels) widen(row);
  widen(t.limit);
  const auto right = [](const std::string& s, std::size_t width) {
    return std::string(width - std::min(width, s.size()), ' ') + s;
  };
  const auto print = [&](const std::string& k, const kernels::MaskRow& row) {
    out << "\n";
    for (std::size_t s = 0; s < row.text.size(); ++s)
      out << right(k, 7) << right(std::to_string(row.lowest + static_cast<long>(s)), 6) << "  "
          << std::string(before - head(row.text[s]), ' ') << row.text[s] << "\n";
  };
  out << "\n" << right("k", 7) << right("i", 6) << "  a_i\n";
  for (std::size_t k = 0; k < t.levels.size(); ++k) print(std::to_string(k), t.levels[k]);
  print("limit", t.limit);
  return out.str();
}

int run_evaluator(const Options& o, const Common& common) {
  const lowering::Language language = lowering::parse_language(common.format);
  const Scheme s = make_scheme(o.scheme);
  lowering::EmitOptions options;
  options.prefix = o.prefix;
  std::vector<std::pair<std::string, std::string>> others;
  for (const auto& [name, text] : o.values.named()) {
    const auto parameter = std::find_if(s.parameters.begin(), s.parameters.end(), [&](const Parameter& p) {
      return p.scope == Parameter::Scope::local && p.name == name;
    });
    if (parameter == s.parameters.end()) {
      others.emplace_back(name, text);
      continue;
    }
    const auto list = expression_list(name, text);
    if (list.size() != parameter->offsets.size())
      bad_input("--at: " + name + " takes " + std::to_string(parameter->offsets.size()) + " values, not " +
                    std::to_string(list.size()),
                text);
    for (size_t i = 0; i < list.size(); ++i) {
      check_local_value(s, *parameter, list[i]);
      const auto value = list[i].constant();
      if (!value) bad_input("--at: an evaluator takes numbers", list[i].to_string());
      options.local_values.emplace_back(local_name(name, parameter->offsets[i]), *value);
    }
  }
  options.values = lowering::bind_some(s, o.values.v0, o.values.t, others);
  deliver(common, lowering::emit_evaluator(s, language, options));
  return 0;
}

int run(const Options& o, const Common& common) {
  if (o.evaluator) return run_evaluator(o, common);
  if (o.levels == 0) bad_input("--levels is required");
  if (common.format != "text" && kernels::find_table_writer(common.format) == nullptr)
    bad_input("this format goes with --evaluator only", common.format);
  const lowering::Normalisation normalisation = lowering::parse_normalisation(o.normalisation);
  const bool data =
      common.format == "text" || common.format == "json" || common.format == "csv" || common.format == "npy";
  if (normalisation != lowering::Normalisation::arity && !data)
    bad_input(
        "--normalisation goes with text, json, csv and npy; format " + common.format + " applies the mask as it is",
        o.normalisation);
  const Scheme s = make_scheme(o.scheme);
  const lowering::Binding b = lowering::bind(s, o.values.v0, o.values.t, o.values.named());
  lowering::LowerOptions options;
  options.levels = o.levels;
  options.digits = o.doubles ? 0 : o.digits;
  const kernels::MaskTable t = common.format == "pywavelets"
                                   ? lowering::lower_filters(s, complete(symbol(s), Space()).bank, b, options)
                                   : lowering::lower_normalised(s, normalisation, b, options);
  if (common.format == "text") {
    deliver(common, table_text(t));
  } else {
    kernels::TableOptions writer;
    writer.hex_float = o.hex;
    writer.prefix = o.prefix;
    writer.points = o.points;
    kernels::write_file(common.output, kernels::write_table(t, common.format, writer));
  }
  return 0;
}

}  // namespace

void add_table_command(CLI::App& app, Session& session) {
  auto o = std::make_shared<Options>();
  std::vector<std::string> formats{"text"};
  for (const kernels::TableWriter* w : kernels::table_writers()) formats.emplace_back(w->name());
  for (const lowering::Language language : lowering::evaluator_languages())
    if (std::find(formats.begin(), formats.end(), lowering::name(language)) == formats.end())
      formats.emplace_back(lowering::name(language));
  CLI::App* c = add_command(app, session, "table", "tabulate the masks of the first levels and the limit", formats);
  c->add_option("scheme", o->scheme, "scheme name")->required()->type_name("SCHEME");
  add_values(c, o->values);
  CLI::Option* levels =
      c->add_option("--levels", o->levels, "number K of levels: rows k = 0..K-1 (required for a table)")
          ->check(CLI::Range(1, 4096))
          ->type_name("K");
  CLI::Option* digits = c->add_option("--digits", o->digits, "significant digits, all correct; 17 by default")
                            ->check(CLI::Range(17, 10000))
                            ->type_name("D");
  CLI::Option* normalisation =
      c->add_option(
           "--normalisation", o->normalisation,
           "what is printed: arity (a_i as it is), sum1 (a_i/m), sqrt2 (a_i/sqrt(m)), convolution (exponential "
           "B-splines as plain convolutions)")
          ->check(CLI::IsMember({"arity", "sum1", "sqrt2", "convolution"}))
          ->type_name("N");
  CLI::Option* doubles =
      c->add_flag("--double", o->doubles, "correctly rounded doubles, shortest texts")->excludes(digits);
  CLI::Option* hex = c->add_flag("--hex", o->hex, "C, C++, stencil: hexadecimal floating-point literals");
  c->add_option("--prefix", o->prefix, "prefix (C++: namespace) of all names in program text")->type_name("NAME");
  CLI::Option* points =
      c->add_option("--points", o->points, "stencil, matrixmarket: points of the closed polygon, 8 by default")
          ->check(CLI::Range(3, 1 << 24))
          ->type_name("N");
  c->add_flag(
       "--evaluator", o->evaluator,
       "not a table but a program that computes the masks for any values of the parameters, which may be left open "
       "(c, cpp, python, julia, glsl, typescript, javascript)")
      ->excludes(levels)
      ->excludes(digits)
      ->excludes(normalisation)
      ->excludes(doubles)
      ->excludes(hex)
      ->excludes(points);
  c->callback([&session, o] { session.action = [&session, o] { return run(*o, session.common); }; });
}

}  // namespace twoscale::cli
