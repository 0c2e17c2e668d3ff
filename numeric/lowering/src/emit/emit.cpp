// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/lowering/emit.hpp"

#include "twoscale/kernels/error.hpp"
#include "twoscale/kernels/export/table_writer.hpp"
#include "twoscale/symbolic/error.hpp"
#include "unit.hpp"

namespace twoscale::lowering {

namespace {

struct Known {
  Language language;
  std::string_view name, suffix;
};

constexpr Known known[] = {
    {Language::c, "c", "c"},
    {Language::cpp, "cpp", "hpp"},
    {Language::python, "python", "py"},
    {Language::julia, "julia", "jl"},
    {Language::glsl, "glsl", "glsl"},
    {Language::typescript, "typescript", "ts"},
    {Language::javascript, "javascript", "js"},
};

const Known& entry(Language language) {
  for (const Known& k : known)
    if (k.language == language) return k;
  throw std::logic_error("emit: unknown language");
}

std::unique_ptr<emit::Dialect> dialect(Language language, const std::string& prefix) {
  switch (language) {
    case Language::c: return emit::make_c(prefix);
    case Language::cpp: return emit::make_cpp(prefix);
    case Language::python: return emit::make_python(prefix);
    case Language::julia: return emit::make_julia(prefix);
    case Language::glsl: return emit::make_glsl(prefix);
    case Language::typescript: return emit::make_javascript(prefix, true);
    case Language::javascript: return emit::make_javascript(prefix, false);
  }
  throw std::logic_error("emit: unknown language");
}

}  // namespace

const std::vector<Language>& evaluator_languages() {
  static const std::vector<Language> list = [] {
    std::vector<Language> all;
    for (const Known& k : known) all.push_back(k.language);
    return all;
  }();
  return list;
}

std::string_view name(Language language) { return entry(language).name; }
std::string_view suffix(Language language) { return entry(language).suffix; }

Language parse_language(std::string_view text) {
  std::string names;
  for (const Known& k : known) {
    if (k.name == text) return k.language;
    names += (names.empty() ? "" : ", ") + std::string(k.name);
  }
  bad_input("an evaluator is written in one of " + names + ", not", std::string(text));
}

std::string emit_evaluator(const Scheme& given, Language language, const EmitOptions& options) {
  std::vector<std::pair<std::string, RationalFunction>> constants;
  for (const auto& [name, value] : options.values.constants) {
    const auto rational = value.rational();
    if (!rational) bad_input("an evaluator takes rational values of constants only", name);
    constants.emplace_back(name, *rational);
  }
  const Scheme scheme = with_values(given, constants);
  std::string prefix;
  try {
    prefix = kernels::identifier(options.prefix, scheme.id);
  } catch (const kernels::Error& error) {
    bad_input(error.what());
  }
  const auto spelling = dialect(language, prefix);
  return spelling->file(emit::make_unit(scheme, options.values, prefix, spelling->bits()));
}

}  // namespace twoscale::lowering
