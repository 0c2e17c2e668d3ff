// SPDX-License-Identifier: GPL-3.0-or-later
// Memory for results that goes round.
#include "twoscale/kernels/buffer_pool.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <thread>
#include <vector>

#include "tables.hpp"
#include "twoscale/kernels/refine.hpp"

namespace twoscale::kernels {
namespace {

using testing::four_point;

TEST(BufferPool, WhatGoesBackIsTakenAgain) {
  BufferPool pool;
  const double* first = nullptr;
  {
    const Buffer<double> a = pool.take<double>(1'000'000);
    ASSERT_EQ(a.size(), 1'000'000U);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(a.data()) % 4096, 0U);
    EXPECT_EQ(pool.idle_bytes(), 0U);
    a[999'999] = 1;
    first = a.data();
  }
  EXPECT_GE(pool.idle_bytes(), 8'000'000U);
  const Buffer<float> b = pool.take<float>(1'900'000);  // another type, a little less
  EXPECT_EQ(static_cast<const void*>(b.data()), first);
  EXPECT_EQ(pool.idle_bytes(), 0U);
}

TEST(BufferPool, ALargeBlockIsNoAnswerToASmallWish) {
  BufferPool pool;
  const void* large = pool.take<char>(std::size_t{64} << 20).data();
  const Buffer<char> small = pool.take<char>(100);
  EXPECT_NE(small.data(), large);
  pool.release();
  EXPECT_EQ(pool.idle_bytes(), 0U);
}

TEST(BufferPool, BuffersInUseAreApartAndOutliveThePool) {
  std::vector<Buffer<int>> kept;
  {
    BufferPool pool;
    for (int i = 0; i < 10; ++i) {
      kept.push_back(pool.take<int>(1000));
      for (int& x : kept.back().span()) x = i;
    }
  }
  for (int i = 0; i < 10; ++i)
    for (const int x : kept[static_cast<std::size_t>(i)].span()) ASSERT_EQ(x, i);
  Buffer<int> moved = std::move(kept[3]);
  EXPECT_TRUE(kept[3].empty());  // NOLINT: a buffer moved from is empty
  kept[4] = std::move(moved);
  EXPECT_EQ(kept[4][0], 3);
}

TEST(BufferPool, NothingAndTooMuch) {
  BufferPool pool;
  EXPECT_TRUE(pool.take<double>(0).empty());
  EXPECT_THROW(pool.take<double>(SIZE_MAX / 4), std::bad_alloc);
}

TEST(BufferPool, SeveralThreads) {
  BufferPool pool;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&pool, t] {
      for (int i = 0; i < 200; ++i) {
        const Buffer<int> b = pool.take<int>(static_cast<std::size_t>(1 + 37 * i));
        for (int& x : b.span()) x = t;
        for (const int x : b.span()) ASSERT_EQ(x, t);
      }
    });
  for (std::thread& t : threads) t.join();
}

TEST(BufferPool, RefinedPointsAreThoseOfAVector) {
  BufferPool pool;
  Refiner<double> refiner(four_point());
  const std::vector<double> points = {0, 0, 4, 0, 4, 3, 0, 3};
  const void* place = nullptr;
  for (int round = 0; round < 3; ++round) {
    const Buffer<double> out = refiner.refine(points, 2, 6, Boundary::closed, pool);
    const std::vector<double> expected = refiner.refine(points, 2, 6, Boundary::closed);
    EXPECT_EQ(std::vector<double>(out.span().begin(), out.span().end()), expected);
    if (round > 0) {
      EXPECT_EQ(out.data(), place);
    }
    place = out.data();
  }
}

}  // namespace
}  // namespace twoscale::kernels
