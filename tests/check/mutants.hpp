// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the checker: systematic changes of the text of a certificate.
#pragma once

#include "twoscale/check/check.hpp"

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace samples {

/// Replaces the digest of a changed text, if it still ends like a certificate.
inline std::string reseal(const std::string& text) {
  const std::size_t at = text.rfind("\"digest\": \"");
  if (at == std::string::npos) return text;
  return twoscale::check::sealed(text.substr(0, at) + "\"digest\": \"\"\n}\n");
}

/// Changes of the text: each character replaced, removed, doubled; each line removed, doubled, exchanged with the next;
/// each string replaced by each other string of the document; each integer by neighbours and some others.
inline std::set<std::string> mutants(const std::string& text) {
  std::set<std::string> result;
  const std::string body = text.substr(0, text.rfind("\"digest\""));
  const auto put = [&](std::size_t at, std::size_t length, const std::string& with) {
    std::string copy = text;
    copy.replace(at, length, with);
    result.insert(std::move(copy));
  };
  for (std::size_t i = 0; i < body.size(); ++i) {
    const char c = body[i];
    put(i, 1, "");
    put(i, 1, std::string(2, c));
    if (c >= '0' && c <= '9') {
      for (char d = '0'; d <= '9'; ++d) put(i, 1, std::string(1, d));
      put(i, 0, "-");
    } else if (c == '+' || c == '-' || c == '*' || c == '^' || c == '/') {
      for (const char d : {'+', '-', '*', '^', '/'}) put(i, 1, std::string(1, d));
    } else {
      for (const char d : {'a', 's', 't', 'v', '"', ',', ' ', '1', '_'}) put(i, 1, std::string(1, d));
    }
  }
  // lines
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at) + 1;
    lines.push_back(text.substr(at, end - at));
    at = end;
  }
  const auto join = [&](const std::vector<std::string>& list) {
    std::string all;
    for (const auto& line : list) all += line;
    result.insert(std::move(all));
  };
  for (std::size_t i = 0; i + 2 < lines.size(); ++i) {
    auto copy = lines;
    copy.erase(copy.begin() + static_cast<long>(i));
    join(copy);
    copy = lines;
    copy.insert(copy.begin() + static_cast<long>(i), lines[i]);
    join(copy);
    copy = lines;
    std::swap(copy[i], copy[i + 1]);
    join(copy);
  }
  // strings
  std::vector<std::pair<std::size_t, std::size_t>> strings;
  std::set<std::string> pool{"0", "1", "-1", "1/2", "2/3", "proved", "refuted", "yes", "no", ""};
  for (std::size_t at = body.find('"'); at != std::string::npos; at = body.find('"', at)) {
    std::size_t end = at + 1;
    while (body[end] != '"' || body[end - 1] == '\\') ++end;
    strings.emplace_back(at + 1, end - at - 1);
    if (end - at < 40) pool.insert(body.substr(at + 1, end - at - 1));
    at = end + 1;
  }
  for (const auto& [at, length] : strings) {
    for (const std::string& other : pool) put(at, length, other);
  }
  result.erase(text);
  return result;
}

}  // namespace samples
