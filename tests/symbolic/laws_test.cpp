// SPDX-License-Identifier: GPL-3.0-or-later
/// A law that does not hold fails, with the smallest example and the place; a round that does not count is drawn again.
#include "support/laws.hpp"

#include <gtest/gtest-spi.h>

namespace twoscale::tests {
namespace {

TEST(Laws, AFalseLawFailsWithItsSmallestExample) {
  EXPECT_FATAL_FAILURE(laws::run([] { LAW_ASSERT(uniform(0L, 100L) < 60); }), "\nlong:\n60\n");
  EXPECT_FATAL_FAILURE(laws::run([] { LAW_ASSERT(draw<Rational>().sign() <= 0); }), "draw<Rational>().sign() <= 0");
  EXPECT_FATAL_FAILURE(laws::run([] { LAW_ASSERT(several(3, [] { return uniform(0, 5); })[2] < 4); }), "laws_test.cpp");
}

TEST(Laws, RoundsThatDoNotCountAreDrawnAgain) {
  int rounds = 0, counted = 0;
  laws::run([&] {
    ++rounds;
    LAW_GIVEN(uniform(0, 2) == 0);
    ++counted;
  });
  EXPECT_GT(rounds, counted);
  EXPECT_GT(counted, 0);
  EXPECT_FATAL_FAILURE(laws::run([] { LAW_GIVEN(false); }), "Gave up");
}

LAW(Laws, ArgumentsAreDrawn, (const Rational& a, const Polynomial& p)) { LAW_ASSERT(a == a && p == p); }

}  // namespace
}  // namespace twoscale::tests
