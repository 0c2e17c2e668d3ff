// SPDX-License-Identifier: GPL-3.0-or-later
// twoscale prove SCHEME [--claim NAME[=SUBJECT]]... [--certificate FILE], and twoscale check FILE.
#include "twoscale/analysis/prove.hpp"

#include <iostream>
#include <sstream>

#include "session.hpp"
#include "twoscale/check/check.hpp"
#include "twoscale/kernels/write_file.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::cli {

using analysis::Decision;
using analysis::Verdict;

namespace {

Claim parse_claim(const std::string& text) {
  const auto equals = text.find('=');
  Claim c;
  c.name = trimmed(text.substr(0, equals));
  if (equals != std::string::npos) c.subject = trimmed(text.substr(equals + 1));
  if (c.subject.size() >= 2 && c.subject.front() == '"' && c.subject.back() == '"')
    c.subject = c.subject.substr(1, c.subject.size() - 2);
  return c;
}

std::string prove_text(const Scheme& s, const analysis::Proof& proof, const std::string& certificate) {
  std::ostringstream out;
  out << s.id << "\n";
  for (const Decision& d : proof.decisions) {
    out << "  " << to_string(d.verdict) << std::string(11 - to_string(d.verdict).size(), ' ') << d.claim;
    if (!d.subject.empty()) out << " {" << d.subject << "}";
    out << "\n";
    if (d.verdict == Verdict::proved) out << "             for " << d.domain << "\n";
    for (const auto& e : d.exceptions) out << "             except " << e << "\n";
    if (!d.witness.empty())
      out << "             " << (d.verdict == Verdict::refuted ? "counterexample: " : "reason: ") << d.witness << "\n";
  }
  if (!certificate.empty()) out << "certificate " << certificate << " (verify with twoscale-check)\n";
  return out.str();
}

std::string prove_json(const Scheme& s, const analysis::Proof& proof, const std::string& certificate) {
  using Json = nlohmann::ordered_json;
  Json j;
  j["format"] = "twoscale/proof";
  j["version"] = 1;
  j["scheme"] = s.id;
  Json claims = Json::array();
  for (const Decision& d : proof.decisions) {
    Json c;
    c["claim"] = d.claim;
    c["subject"] = d.subject;
    c["verdict"] = to_string(d.verdict);
    c["domain"] = d.domain;
    c["exceptions"] = d.exceptions;
    c["witness"] = d.witness.empty() ? Json(nullptr) : Json(d.witness);
    claims.push_back(c);
  }
  j["claims"] = claims;
  j["certificate"] = certificate.empty() ? Json(nullptr) : Json(certificate);
  return j.dump(1);
}

// With several claims the first of refuted, undecided, proved that occurs counts.
int status(const analysis::Proof& proof) {
  bool undecided = false;
  for (const auto& d : proof.decisions) {
    if (d.verdict == Verdict::refuted) return 1;
    undecided = undecided || d.verdict == Verdict::undecided;
  }
  return undecided ? 3 : 0;
}

}  // namespace

void add_prove_command(CLI::App& app, Session& session) {
  struct Options {
    std::string scheme;
    std::vector<std::string> claims;
    std::string certificate;
  };
  auto o = std::make_shared<Options>();
  CLI::App* c = add_command(app, session, "prove", "decide claims about a scheme exactly and write the certificate");
  c->add_option("scheme", o->scheme, "scheme name")->required()->type_name("SCHEME");
  c->add_option("--claim", o->claims,
                "NAME or NAME=SUBJECT, e.g. reproduces=\"1,x,exp(t*x),exp(-t*x)\"; may be repeated")
      ->type_name("CLAIM")
      ->take_all()
      ->allow_extra_args(false);
  c->add_option("--certificate", o->certificate, "write the certificate here")->type_name("FILE");
  c->callback([&session, o] {
    session.action = [&session, o] {
      const Scheme s = make_scheme(o->scheme);
      std::vector<Claim> claims;
      for (const auto& text : o->claims) claims.push_back(parse_claim(text));
      if (claims.empty()) claims = analysis::default_claims(s);
      const analysis::Proof proof = analysis::prove(s, claims);
      const std::string file = proof.certificate.empty() ? "" : o->certificate;
      deliver(session.common, session.common.format == "json" ? prove_json(s, proof, file) : prove_text(s, proof, file),
              file, proof.certificate);
      return status(proof);
    };
  });
}

void add_check_command(CLI::App& app, Session& session) {
  auto file = std::make_shared<std::string>();
  CLI::App* c = add_command(app, session, "check", "re-verify a certificate (the same checker as twoscale-check)");
  c->add_option("file", *file, "certificate")->required()->type_name("FILE");
  c->callback([&session, file] {
    session.action = [&session, file] {
      const check::Report report = check::check_text(kernels::read_file(*file));
      if (report.status == check::Report::malformed) bad_input(*file + ": " + report.message);
      std::string text;
      if (session.common.format == "json") {
        nlohmann::ordered_json j;
        j["format"] = "twoscale/check";
        j["version"] = 1;
        j["scheme"] = nullptr;
        j["status"] = report.status == check::Report::valid ? "valid" : "invalid";
        j["lines"] = report.lines;
        j["message"] = report.message;
        text = j.dump(1);
      } else {
        for (const auto& line : report.lines) text += line + "\n";
        if (!report.message.empty()) text += report.message + "\n";
      }
      deliver(session.common, text);
      return report.status == check::Report::valid ? 0 : 1;
    };
  });
}

}  // namespace twoscale::cli
