// SPDX-License-Identifier: GPL-3.0-or-later
/// Texts from outside: expressions, spaces and scheme names, mutated or random. The only way out is a value or an
/// Error, soon.
#include <gtest/gtest.h>

#include <chrono>

#include "support/mutate.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::tests {
namespace {

/// Runs f; what it may throw is an Error, and it has ten seconds (a hang would show as a timeout of the whole test).
template <class F>
void survives(const std::string& text, F f) {
  const auto start = std::chrono::steady_clock::now();
  try {
    f();
  } catch (const Error& e) {
    EXPECT_FALSE(std::string(e.what()).empty());
  } catch (const std::exception& e) {
    ADD_FAILURE() << "'" << text << "' threw " << e.what();
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  EXPECT_LT(seconds.count(), 10) << "'" << text << "'";
}

void read_everything(const std::string& text) {
  survives(text, [&] { parse_rational_function(text); });
  survives(text, [&] { (void)parse_real(text).sign(1024); });
  survives(text, [&] { Space::parse(text); });
  survives(text, [&] { parse_scheme_name(text); });
}

const std::vector<std::string> expressions = {"-(4*v + 1)*(4*v^2 + 2*v - 1)/(64*v^3*(v + 1)^2)",
                                              "cos(2*pi/5) - (sqrt(5)-1)/4",
                                              "exp(-t*x/3)*x^2",
                                              "acosh(cosh(3/5))^2",
                                              "1.5e-3 + 2^-1 - .25",
                                              "((v_s+1)*(v_t-1))^3/(v_s+v_t)"};
const std::vector<std::string> spaces = {
    "1, x, x^2, exp(t*x), exp(-t*x)", "1, x, cos(s*x), sin(s*x), x*cos(s*x), x*sin(s*x)",
    "exp(t*x/2), exp(-t*x/2), exp(t*x/3), exp(-t*x/3)", "1, cos(2*pi/7*x), sin(2*pi/7*x)",
    "exp((1+sqrt(2))*x), exp(-(1+sqrt(2))*x), cosh(x), sinh(x)"};
const std::vector<std::string> schemes = {"interpolating:family=mixed,l=3",
                                          "interpolating:space=\"1,x,exp(t*x),exp(-t*x)\"",
                                          "bspline:n=3,arity=3",
                                          "mask:coefficients=\"-w,0,1/2+w,1,1/2+w,0,-w\",lowest=-3",
                                          "tension4",
                                          "harmonic:n=2",
                                          "dd:l=4"};

TEST(ExpressionFuzz, RandomBytes) {
  std::mt19937_64 random(20240601);
  for (size_t i = 0; i < rounds(3000); ++i) {
    std::string text(below(random, 40), ' ');
    for (char& c : text) c = static_cast<char>(below(random, 256));
    read_everything(text);
  }
}

TEST(ExpressionFuzz, RandomTokens) {
  static const std::vector<std::string> tokens = {
      "1", "2", "9",    "0",    "x",     "t",    "v",  "+",    "-",    "*",   "/",     "^",     "(",
      ")", ",", "exp(", "cos(", "sqrt(", "log(", "pi", "I",    ".",    "e3",  "cosh(", "acos(", "atan(",
      "=", ":", "\"",   "[",    "]",     " ",    "**", "sin(", "tan(", "0.5", "x^2",   "t*x"};
  std::mt19937_64 random(7);
  for (size_t i = 0; i < rounds(6000); ++i) {
    std::string text;
    for (size_t n = 1 + below(random, 14); n > 0; --n) text += tokens[below(random, tokens.size())];
    read_everything(text);
  }
}

TEST(ExpressionFuzz, Mutations) {
  std::mt19937_64 random(11);
  for (size_t i = 0; i < rounds(600); ++i)
    for (const auto* list : {&expressions, &spaces, &schemes})
      for (const auto& text : *list)
        read_everything(mutate(text, random, "0123456789-+*/^()[]{}\",:. vtxsepiI_=\n\xff"));
}

/// What a mutated text was read as reads back: text and value never part.
TEST(ExpressionFuzz, WhatIsReadReadsBack) {
  std::mt19937_64 random(13);
  size_t read = 0;
  for (size_t i = 0; i < rounds(1500); ++i) {
    const std::string expression = mutate(expressions[below(random, expressions.size())], random);
    const std::string space = mutate(spaces[below(random, spaces.size())], random);
    const std::string name = mutate(schemes[below(random, schemes.size())], random);
    survives(expression, [&] {
      const RationalFunction f = parse_rational_function(expression);
      EXPECT_EQ(parse_rational_function(f.to_string()), f) << expression;
      ++read;
    });
    survives(space, [&] {
      const Space s = Space::parse(space);
      std::string again;
      ASSERT_NO_THROW(again = Space::parse(s.to_string()).to_string()) << space << " -> " << s.to_string();
      EXPECT_EQ(again, s.to_string()) << space;
      ++read;
    });
    survives(name, [&] {
      const SchemeName n = parse_scheme_name(name);
      EXPECT_EQ(parse_scheme_name(n.to_string()).keys, n.keys) << name << " -> " << n.to_string();
      ++read;
    });
  }
  EXPECT_GT(read, 100U);  // or the mutations test nothing
}

/// Schemes are made only where the size asked for is small: n = 200 is no error, it takes its time.
bool small(const SchemeName& name) {
  for (const char* key : {"n", "l", "arity"})
    if (const auto at = name.keys.find(key); at != name.keys.end() && at->second.size() > 1) return false;
  if (const auto at = name.keys.find("space"); at != name.keys.end()) {
    const Space space = Space::parse(at->second);
    if (space.dimension() > 10) return false;
    for (const auto& e : space.exponentials())
      if (e.multiple > 12) return false;
  }
  return true;
}

TEST(ExpressionFuzz, SchemesAreMadeOrRefused) {
  std::mt19937_64 random(17);
  size_t made = 0;
  for (size_t i = 0; i < rounds(1200); ++i)
    for (const auto& text : schemes) {
      const std::string mutation = mutate(text, random);
      survives(mutation, [&] {
        if (!small(parse_scheme_name(mutation))) return;
        const Scheme s = make_scheme(mutation);
        EXPECT_EQ(make_scheme(s.id).id, s.id) << mutation;
        ++made;
      });
    }
  EXPECT_GT(made, 50U);
}

}  // namespace
}  // namespace twoscale::tests
