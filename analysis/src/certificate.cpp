// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/analysis/certificate.hpp"

#include <algorithm>
#include <cstdint>

namespace twoscale::analysis {

namespace {

std::string fnv1a64(const std::string& text) {
  std::uint64_t h = 14695981039346656037ULL;
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  static const char* const hex = "0123456789abcdef";
  std::string s(16, '0');
  for (size_t i = 16; i-- > 0; h >>= 4) s[i] = hex[h & 15U];
  return s;
}

// The document with its claims, sealed.
std::string sealed(nlohmann::ordered_json doc, const std::vector<nlohmann::ordered_json>& claims) {
  doc["claims"] = claims;
  doc["digest"] = "";
  const std::string digest = fnv1a64(doc.dump(1) + "\n");
  doc["digest"] = "fnv1a64:" + digest;
  return doc.dump(1) + "\n";
}

nlohmann::ordered_json opening(const std::string& label) {
  nlohmann::ordered_json doc;
  doc["format"] = "twoscale/certificate";
  doc["version"] = 1;
  doc["scheme"] = label;
  return doc;
}

}  // namespace

MaskData mask_data(const Scheme& scheme) {
  MaskData data;
  const Laurent a = symbol(scheme);
  const CommonDenominator d = common_denominator(a.coefficients());
  data.levels = level_variables(scheme);
  data.constants = free_parameters(scheme);
  data.lowest = a.lowest();
  data.denominator = d.expanded();
  for (const auto& c : a.coefficients()) data.numerators.push_back(numerator_over(c, d));
  return data;
}

std::string certificate_text(const std::string& label, const std::vector<RationalMatrix>& matrices,
                             const std::vector<nlohmann::ordered_json>& claims) {
  nlohmann::ordered_json doc = opening(label);
  doc["matrices"] = nlohmann::ordered_json::array();
  for (const auto& b : matrices) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (long i = 0; i < b.rows(); ++i) {
      nlohmann::ordered_json row = nlohmann::ordered_json::array();
      for (long j = 0; j < b.columns(); ++j) row.push_back(b(i, j).to_string());
      rows.push_back(row);
    }
    doc["matrices"].push_back(rows);
  }
  return sealed(std::move(doc), claims);
}

std::string certificate_text(const Scheme& scheme, const MaskData& mask,
                             const std::vector<nlohmann::ordered_json>& claims, const nlohmann::ordered_json& knots) {
  using Json = nlohmann::ordered_json;
  Json doc = opening(scheme.id);
  doc["arity"] = scheme.arity;
  std::vector<Json> variables;
  for (const auto& v : mask.levels)
    variables.push_back(Json::object({{"name", v.name}, {"scope", "level"}, {"meaning", v.meaning(scheme.arity)}}));
  for (const auto& p : scheme.parameters)
    if (p.scope == Parameter::Scope::constant)
      variables.push_back(Json::object({{"name", p.name}, {"scope", "constant"}, {"meaning", "constant"}}));
    else if (p.relation)
      variables.push_back(
          Json::object({{"name", p.name}, {"scope", "sequence"}, {"meaning", recurrence(p, scheme.arity)}}));
  std::sort(variables.begin(), variables.end(), [](const Json& a, const Json& b) { return a["name"] < b["name"]; });
  doc["variables"] = variables;
  doc["shift"] = scheme.shift.to_string();
  std::vector<std::string> numerators;
  for (const auto& n : mask.numerators) numerators.push_back(n.to_string());
  doc["mask"] = Json::object(
      {{"lowest", mask.lowest}, {"numerators", numerators}, {"denominator", mask.denominator.to_string()}});
  if (!knots.is_null()) doc["knots"] = knots;
  return sealed(std::move(doc), claims);
}

std::string certificate_text(const std::string& label, const std::vector<nlohmann::ordered_json>& claims) {
  return sealed(opening(label), claims);
}

std::string certificate_text(const std::string& label, const nlohmann::ordered_json& hermite,
                             const std::vector<nlohmann::ordered_json>& claims) {
  nlohmann::ordered_json doc = opening(label);
  doc["hermite"] = hermite;
  return sealed(std::move(doc), claims);
}

}  // namespace twoscale::analysis
