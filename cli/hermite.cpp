// SPDX-License-Identifier: GPL-3.0-or-later
#include "hermite.hpp"

#include <iostream>
#include <sstream>

#include <nlohmann/json.hpp>

#include "twoscale/analysis/hermite_claims.hpp"
#include "twoscale/kernels/number_text.hpp"
#include "twoscale/kernels/points_io.hpp"
#include "twoscale/kernels/write_file.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::cli {

std::optional<ExactReal> tension(const Values& values) {
  if (values.v0 || values.t) bad_input("the scheme has no level variable", values.v0 ? *values.v0 : *values.t);
  std::optional<ExactReal> w;
  for (const auto& [name, value] : values.named()) {
    if (name != "w") bad_input("--at: the scheme takes no value of this name for a whole curve", name);
    if (w) bad_input("--at: given twice", name);
    w = parse_real(value);
  }
  return w;
}

int refine_hermite_file(const Scheme& scheme, const Values& values, const std::string& input,
                        const lowering::HermiteOptions& options, kernels::PointFormat format, const Common& common) {
  const auto w = tension(values);
  const lowering::HermiteResult result = lowering::refine_hermite(scheme, w, kernels::read_points(input), options);
  const bool all = format == kernels::PointFormat::csv || format == kernels::PointFormat::npy;
  kernels::write_file(
      common.output,
      kernels::points_to_bytes(all ? result.points : lowering::points_alone(result.points), format, options.closed));
  if (!common.quiet && result.first_pole)
    std::cerr << "twoscale: the first pole of these data is at w* = " << kernels::shortest(*result.first_pole) << "\n";
  return 0;
}

// The smoothness of the limits is decided as claims; this puts the answers together.
int regularity_of_vertices(Scheme scheme, const std::vector<std::string>& at, const std::string& certificate,
                           const Session& session) {
  Values values;
  values.at = at;
  if (const auto w = tension(values)) {
    if (!w->rational()) bad_input("--at: a rational number is expected for the tension w", w->decimal(17));
    if (w->rational()->sign() <= 0) bad_input("the tension w must be positive", w->rational()->to_string());
    for (auto& p : scheme.parameters)
      if (p.name == "w") p.default_value = w->rational()->to_string();
  }
  const analysis::Proof proof =
      analysis::prove(scheme, {{"continuity", "2", ""}, {"continuity", "1", ""}, {"curvature", "", ""}});
  const auto proved = [&](std::size_t i) { return proof.decisions[i].verdict == analysis::Verdict::proved; };
  const int continuity = proved(0) ? 2 : proved(1) ? 1 : -1;  // -1: not decided
  const std::string file = proof.certificate.empty() ? "" : certificate;
  std::string text;
  if (session.common.format == "json") {
    nlohmann::ordered_json j;
    j["format"] = "twoscale/regularity";
    j["version"] = 1;
    j["scheme"] = scheme.id;
    for (const auto& p : scheme.parameters)
      if (!p.default_value.empty()) j["parameters"][p.name] = p.default_value;
    j["continuity"] = continuity < 0 ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(continuity);
    j["geometric"] = proved(2) ? nlohmann::ordered_json(2) : nlohmann::ordered_json(nullptr);
    j["hoelder"] = nullptr;
    j["method"] = "claims continuity and curvature";
    j["domain"] = proof.decisions[proved(0) ? 0 : 1].domain;
    j["reason"] = proof.decisions[0].witness;
    j["certificate"] = file.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(file);
    text = j.dump(1);
  } else {
    std::ostringstream out;
    out << scheme.id << "\n";
    for (const auto& p : scheme.parameters)
      if (!p.default_value.empty()) out << p.name << " = " << p.default_value << "\n";
    if (continuity) out << "continuity  C^" << continuity << " " << proof.decisions[proved(0) ? 0 : 1].domain << "\n";
    if (!proved(0)) out << (continuity >= 0 ? "not C^2     " : "undecided   ") << proof.decisions[0].witness << "\n";
    if (proved(2)) out << "geometric   G^2 " << proof.decisions[2].domain << "\n";
    if (!file.empty()) out << "certificate " << file << " (verify with twoscale-check)\n";
    text = out.str();
  }
  deliver(session.common, text, file, proof.certificate);
  return continuity >= 0 ? 0 : 3;
}

}  // namespace twoscale::cli
