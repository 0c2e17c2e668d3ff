// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cctype>
#include <cmath>

#include "page.hpp"
#include "twoscale/reports/html.hpp"

namespace twoscale::reports::romani2009 {

const std::vector<SixPoint>& six_point_schemes() {
  static const std::vector<SixPoint> list = {
      {"mixed", "4.1", "conics and cubics", "interpolating:family=mixed,l=3", {"-1/2", "1/2", "1", "10"}},
      {"harmonic", "4.2", "second-order curves", "interpolating:family=harmonic,l=3", {"-1/4", "1/2", "1", "10"}},
      {"resonant", "4.3", "spirals", "interpolating:family=resonant,l=3", {"-1/2", "1/2", "1", "10"}}};
  return list;
}

std::string embedded(Part& part, const std::string& name, const std::string& alternative, const Picture& picture) {
  const std::string svg = render(picture, ImageFormat::svg);
  part.files.emplace_back("figures/" + name + ".svg", svg);
  return fmt::format("<img src=\"{}\" width=\"{}\" height=\"{}\" alt=\"{}\"/>", data_uri(svg), picture.width,
                     picture.height, escaped(alternative));
}

std::string shell_quoted(const std::string& word) {
  bool plain = !word.empty();
  for (char c : word)
    plain = plain && (std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                      std::string_view("-_./:=,+").find(c) != std::string_view::npos);
  return plain ? word : "'" + word + "'";
}

std::string command(const std::string& line) { return "<span class=\"prompt\">$ </span>" + escaped(line) + "\n"; }

std::string scheme_label(const std::string& scheme) {
  if (scheme == "tension4") return "4-point, tension";
  if (scheme == "dd:l=2") return "Dubuc–Deslauriers 4-point";
  if (scheme == "dd:l=3") return "Weissmann 6-point";
  for (const SixPoint& s : six_point_schemes())
    if (scheme == s.scheme) return std::string("6-point ") + s.name;
  if (scheme == "interpolating:family=harmonic,l=4") return "8-point harmonic";
  return "6-point lacunary";
}

std::string v0_html(const std::string& v0) { return v0.empty() ? "–" : "<math>" + mathml(v0) + "</math>"; }

std::string number_text(double value) {
  if (value == 0) return "0";
  if (std::abs(value) >= 1e-3) return fmt::format("{:.3g}", value);
  const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value))));
  return fmt::format("{:.1f}·10<sup>−{}</sup>", value / std::pow(10.0, exponent), -exponent);
}

}  // namespace twoscale::reports::romani2009
