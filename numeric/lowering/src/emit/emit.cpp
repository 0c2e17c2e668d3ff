// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/lowering/emit.hpp"

#include <algorithm>

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

// A local parameter keeps those offsets that have no value. Pieces that hold nowhere any more are left out.
void put_local_values(Scheme& scheme, const std::vector<std::pair<std::string, Rational>>& values) {
  if (values.empty()) return;
  for (Parameter& p : scheme.parameters)
    std::erase_if(p.offsets, [&](long offset) {
      return p.scope == Parameter::Scope::local && std::any_of(values.begin(), values.end(), [&](const auto& v) {
               return v.first == local_name(p.name, offset);
             });
    });
  const auto put = [&](RationalFunction f) {
    for (const auto& [name, value] : values) {
      for (const auto& [factor, exponent] : f.denominator_factors())
        if (RationalFunction(factor).substitute(name, value).is_zero())
          bad_input("the rule has a pole at this value", name + "=" + value.to_string());
      f = f.substitute(name, value);
    }
    return f;
  };
  const auto put_all = [&](std::vector<Stencil>& phases) {
    for (Stencil& stencil : phases)
      for (auto& block : stencil.blocks)
        for (RationalFunction& c : block) c = put(c);
  };
  std::vector<Piece> pieces;
  bool everywhere = false;
  for (Piece& piece : scheme.pieces) {
    const RationalFunction where = put(piece.where);
    const auto sign = where.constant();
    if (sign && sign->sign() < 0) continue;
    put_all(piece.phases);
    if (sign) {
      scheme.phases = std::move(piece.phases);
      everywhere = true;
      break;
    }
    pieces.push_back({where.numerator(), std::move(piece.phases)});
  }
  if (!everywhere) put_all(scheme.phases);
  scheme.pieces = std::move(pieces);
  for (const auto& [name, value] : values) scheme.id += " at " + name + "=" + value.to_string();
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
  Scheme scheme = with_values(given, constants);
  put_local_values(scheme, options.local_values);
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
