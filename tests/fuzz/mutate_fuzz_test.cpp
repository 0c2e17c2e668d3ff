// SPDX-License-Identifier: GPL-3.0-or-later
/// The mutations themselves: reproducible from the seed, and they do change texts.
#include "support/mutate.hpp"

#include <gtest/gtest.h>

#include <set>

namespace twoscale::tests {
namespace {

TEST(Mutate, TheSeedDecides) {
  std::mt19937_64 one(7);
  std::mt19937_64 two(7);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(mutate("{\"a\": [1/2, -3]}", one), mutate("{\"a\": [1/2, -3]}", two));
}

TEST(Mutate, GivesManyDifferentTexts) {
  std::mt19937_64 random(1);
  std::set<std::string> seen;
  for (int i = 0; i < 1000; ++i) seen.insert(mutate("(1+v)/(8*v^2)", random));
  EXPECT_GT(seen.size(), 500U);
}

}  // namespace
}  // namespace twoscale::tests
