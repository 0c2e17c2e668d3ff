// SPDX-License-Identifier: 0BSD
// Blocks of whole pages, large ones of huge pages, kept by size while they are idle.
#include "twoscale/kernels/buffer_pool.hpp"

#include <cstdlib>
#include <map>
#include <mutex>
#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif

namespace twoscale::kernels::detail {

namespace {

constexpr std::size_t small_page = 4096;
constexpr std::size_t huge_page = std::size_t{2} << 20;

}  // namespace

struct Blocks::Idle {
  mutable std::mutex mutex;
  std::multimap<std::size_t, void*> by_size;
  std::size_t bytes = 0;
};

Blocks::Blocks() : idle_(std::make_unique<Idle>()) {}

Blocks::~Blocks() { release(); }

Blocks::Block Blocks::take(std::size_t bytes) {
  const std::size_t page = bytes < huge_page ? small_page : huge_page;
  bytes = (bytes + page - 1) / page * page;
  {
    const std::lock_guard lock(idle_->mutex);
    const auto found = idle_->by_size.lower_bound(bytes);
    if (found != idle_->by_size.end() && found->first / 2 <= bytes) {
      const Block block{found->second, found->first};
      idle_->by_size.erase(found);
      idle_->bytes -= block.bytes;
      return block;
    }
  }
  void* const data = std::aligned_alloc(page, bytes);
  if (data == nullptr) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
  if (page == huge_page) madvise(data, bytes, MADV_HUGEPAGE);  // a wish: nothing is lost where it is not granted
#endif
  return {data, bytes};
}

void Blocks::give_back(Block block) noexcept {
  try {
    const std::lock_guard lock(idle_->mutex);
    idle_->by_size.emplace(block.bytes, block.data);
    idle_->bytes += block.bytes;
  } catch (...) {  // no room for one more entry
    std::free(block.data);
  }
}

std::size_t Blocks::idle_bytes() const {
  const std::lock_guard lock(idle_->mutex);
  return idle_->bytes;
}

void Blocks::release() noexcept {
  const std::lock_guard lock(idle_->mutex);
  for (const auto& [bytes, data] : idle_->by_size) std::free(data);
  idle_->by_size.clear();
  idle_->bytes = 0;
}

}  // namespace twoscale::kernels::detail
