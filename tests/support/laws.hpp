// SPDX-License-Identifier: GPL-3.0-or-later
/// Laws over random values, tried and shrunk by RapidCheck. Its templates take a second for every law that instantiates
/// them, so they are compiled once, in laws.cpp, and a test sees draws of numbers and of the exact types only.
///
///   LAW(Suite, Name, (const Rational& a, const Rational& b)) { LAW_ASSERT(a + b == b + a); }
///
/// Arguments are drawn anew for each round; uniform() and draw() draw more inside. A failure prints every draw in
/// order. RC_PARAMS="max_success=1000" scales the rounds, RC_PARAMS="reproduce=..." repeats.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <ostream>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "twoscale/symbolic/laurent.hpp"
#include "twoscale/symbolic/space.hpp"

namespace twoscale {

inline void PrintTo(const Rational& q, std::ostream* out) { *out << q.to_string(); }
inline void PrintTo(const Polynomial& p, std::ostream* out) { *out << p.to_string(); }
inline void PrintTo(const RationalFunction& f, std::ostream* out) { *out << f.to_string(); }
void PrintTo(const Laurent& a, std::ostream* out);
inline void PrintTo(const Space& s, std::ostream* out) { *out << "{" << s.to_string() << "}"; }

namespace laws {

/// An integer of [low, high), with equal chances.
long uniform(long low, long high);
void run(const std::function<void()>& law);
/// Throw what RapidCheck takes for a failure, and for a round that does not count.
void require(bool holds, const char* text, const char* file, int line);
void given(bool holds, const char* text, const char* file, int line);
/// Counts the rounds by tag; the distribution is printed at the end.
void tag(const std::string& text);

}  // namespace laws

/// Rational, Polynomial (up to five terms in none to three of u, v, w), RationalFunction, Laurent (up to six
/// coefficients in v) or Space (dimension 1..10, up to two named frequencies).
template <class T>
T draw();
template <>
Rational draw<Rational>();
template <>
Polynomial draw<Polynomial>();
template <>
RationalFunction draw<RationalFunction>();
template <>
Laurent draw<Laurent>();
template <>
Space draw<Space>();

template <class T>
T uniform(T low, T high) {
  return static_cast<T>(laws::uniform(static_cast<long>(low), static_cast<long>(high)));
}
/// `count` times what `element()` draws.
template <class Element>
auto several(size_t count, Element element) {
  std::vector<std::decay_t<decltype(element())>> list;
  for (size_t i = 0; i < count; ++i) list.push_back(element());
  return list;
}

template <class... A>
void run_law(void (*law)(A...)) {
  laws::run([law] {
    [[maybe_unused]] const std::tuple<std::decay_t<A>...> values{draw<std::decay_t<A>>()...};
    std::apply(law, values);
  });
}

}  // namespace twoscale

#define LAW(Suite, Name, Arguments)                                 \
  void law_##Suite##_##Name Arguments;                              \
  TEST(Suite, Name) { ::twoscale::run_law(&law_##Suite##_##Name); } \
  void law_##Suite##_##Name Arguments
#define LAW_ASSERT(...) ::twoscale::laws::require(static_cast<bool>(__VA_ARGS__), #__VA_ARGS__, __FILE__, __LINE__)
#define LAW_GIVEN(...) ::twoscale::laws::given(static_cast<bool>(__VA_ARGS__), #__VA_ARGS__, __FILE__, __LINE__)
