// SPDX-License-Identifier: 0BSD
// Threads for tiles, and where outputs begin to be too large for the caches.
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

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

// The last cache of one core in bytes. Linux says it in a file; sysconf adds up those of a whole package on some
// machines.
static std::size_t last_cache() {
  std::ifstream file("/sys/devices/system/cpu/cpu0/cache/index3/size");
  std::size_t size = 0;
  char unit = ' ';
  if (file >> size >> unit && size > 0) return size << (unit == 'K' ? 10 : unit == 'M' ? 20 : 0);
#ifdef _SC_LEVEL3_CACHE_SIZE
  if (const long bytes = sysconf(_SC_LEVEL3_CACHE_SIZE); bytes > 0) {
    return std::min<std::size_t>(static_cast<std::size_t>(bytes), std::size_t{64} << 20);
  }
#endif
  return std::size_t{16} << 20;
}

// A part of the last cache that belongs to many cores is not one core's to fill.
std::size_t streamed_from() {
  static const std::size_t bytes = std::min(last_cache() / 2, std::size_t{16} << 20);
  return bytes;
}

}  // namespace twoscale::kernels::detail
