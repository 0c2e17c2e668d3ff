// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the checker: what is expected of a certificate and of its mutants.
#pragma once

#include "mutants.hpp"
#include "samples.hpp"

#include <gtest/gtest.h>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>

namespace samples {

template <typename AnyDocument>
void expect_valid(const AnyDocument& d) {
  const twoscale::check::Report report = d.check();
  EXPECT_EQ(report.status, twoscale::check::Report::valid) << report.message << "\n" << d.sealed();
}
template <typename AnyDocument>
void expect_invalid(const AnyDocument& d, const std::string& reason) {
  const twoscale::check::Report report = d.check();
  EXPECT_EQ(report.status, twoscale::check::Report::invalid) << report.message << "\n" << d.sealed();
  EXPECT_NE(report.message.find(reason), std::string::npos) << report.message;
}
template <typename AnyDocument>
void expect_malformed(const AnyDocument& d, const std::string& reason) {
  const twoscale::check::Report report = d.check();
  EXPECT_EQ(report.status, twoscale::check::Report::malformed) << report.message << "\n" << d.sealed();
  EXPECT_NE(report.message.find(reason), std::string::npos) << report.message;
}

inline double real(const Value& v) {
  const std::size_t slash = v.text.find('/');
  const double top = std::strtod(v.text.c_str(), nullptr);
  return slash == std::string::npos ? top : top / std::strtod(v.text.c_str() + slash + 1, nullptr);
}
inline const Value& member(const Value& object, const std::string& key) {
  for (std::size_t i = 0; i < object.keys.size(); ++i) {
    if (object.keys[i] == key) return object.items[i];
  }
  throw std::runtime_error("no member " + key);
}

using Oracle = std::function<bool(const Value& document, const Value& claim)>;

/// Every claim of each accepted mutant must be true.
inline void expect_only_true_mutants(const std::string& text, std::size_t from, const Oracle& is_true) {
  ASSERT_EQ(twoscale::check::check_text(text).status, twoscale::check::Report::valid);
  int accepted = 0, refused = 0;
  for (const std::string& unsealed : mutants(text)) {
    if (unsealed.compare(0, from, text, 0, from) != 0) continue;  // the head has changed
    const std::string mutant = reseal(unsealed);
    if (mutant == text) continue;
    if (twoscale::check::check_text(mutant).status != twoscale::check::Report::valid) {
      ++refused;
      continue;
    }
    ++accepted;
    const Value document = twoscale::check::parse_json(mutant);
    for (const Value& one : member(document, "claims").items) {
      ASSERT_TRUE(member(one, "verdict").text == "proved" || member(one, "claim").text == "stability") << mutant;
      ASSERT_TRUE(is_true(document, one)) << mutant;
    }
  }
  EXPECT_GT(refused, 100);
  std::cout << accepted << " still true, " << refused << " refused\n";
}

}  // namespace samples
