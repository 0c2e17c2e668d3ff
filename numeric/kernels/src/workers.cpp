// SPDX-License-Identifier: 0BSD
// Threads for tiles, and where outputs begin to be too large for the caches.
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include <algorithm>

#include "twoscale/kernels/refine.hpp"

namespace twoscale::kernels::detail {

struct Workers::Arena {
  explicit Arena(int threads) : arena(threads) {}
  tbb::task_arena arena;
};

Workers::Workers(int threads) {
  const int cores = tbb::info::default_concurrency();
  arena_ = std::make_unique<Arena>(threads == 0 ? cores : std::min(threads, cores));
  arena_->arena.initialize();
  count_ = static_cast<std::size_t>(arena_->arena.max_concurrency());
}

Workers::~Workers() = default;

void Workers::run(std::size_t n, std::size_t grain, void* context, void (*call)(void*, std::size_t, std::size_t)) {
  arena_->arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, n, grain),
        [&](const tbb::blocked_range<std::size_t>& range) {
          const auto worker = static_cast<std::size_t>(tbb::this_task_arena::current_thread_index());
          for (std::size_t i = range.begin(); i != range.end(); ++i) call(context, worker, i);
        },
        tbb::simple_partitioner());
  });
}

std::size_t streamed_from() {
  static const std::size_t bytes = [] {
    long cache = 0;
#ifdef _SC_LEVEL3_CACHE_SIZE
    cache = sysconf(_SC_LEVEL3_CACHE_SIZE);
#endif
    return static_cast<std::size_t>(cache > 0 ? cache : 16L << 20) / 2;
  }();
  return bytes;
}

}  // namespace twoscale::kernels::detail
