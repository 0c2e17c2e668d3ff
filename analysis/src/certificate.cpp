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

std::string sealed(nlohmann::ordered_json doc) {
  doc["digest"] = "";
  const std::string digest = fnv1a64(doc.dump(1) + "\n");
  doc["digest"] = "fnv1a64:" + digest;
  return doc.dump(1) + "\n";
}

}  // namespace

std::string certificate_text(const Scheme& scheme, const MaskData& mask,
                             const std::vector<nlohmann::ordered_json>& claims) {
  using Json = nlohmann::ordered_json;
  Json doc;
  doc["format"] = "twoscale/certificate";
  doc["version"] = 1;
  doc["scheme"] = scheme.id;
  doc["arity"] = scheme.arity;
  std::vector<Json> variables;
  for (const auto& v : mask.levels)
    variables.push_back(Json::object({{"name", v.name}, {"scope", "level"}, {"meaning", v.meaning(scheme.arity)}}));
  for (const auto& c : mask.constants)
    variables.push_back(Json::object({{"name", c}, {"scope", "constant"}, {"meaning", "constant"}}));
  std::sort(variables.begin(), variables.end(), [](const Json& a, const Json& b) { return a["name"] < b["name"]; });
  doc["variables"] = variables;
  doc["shift"] = scheme.shift.to_string();
  std::vector<std::string> numerators;
  for (const auto& n : mask.numerators) numerators.push_back(n.to_string());
  doc["mask"] = Json::object(
      {{"lowest", mask.lowest}, {"numerators", numerators}, {"denominator", mask.denominator.to_string()}});
  doc["claims"] = claims;
  return sealed(std::move(doc));
}

std::string certificate_text(const std::string& label, const std::vector<nlohmann::ordered_json>& claims) {
  nlohmann::ordered_json doc;
  doc["format"] = "twoscale/certificate";
  doc["version"] = 1;
  doc["scheme"] = label;
  doc["claims"] = claims;
  return sealed(std::move(doc));
}

}  // namespace twoscale::analysis
