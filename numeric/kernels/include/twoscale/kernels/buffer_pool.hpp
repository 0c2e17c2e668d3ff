// SPDX-License-Identifier: 0BSD
// Memory for results that goes round: in huge pages where the system has them, and taken again instead of asked for
// anew. Fresh memory, page by page, costs more than refining into it.
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

namespace twoscale::kernels {

namespace detail {

// Blocks of whole pages; safe for several threads.
class Blocks {
 public:
  struct Block {
    void* data = nullptr;
    std::size_t bytes = 0;
  };

  Blocks();
  ~Blocks();
  Blocks(const Blocks&) = delete;
  Blocks& operator=(const Blocks&) = delete;

  // The smallest idle block with room for so many bytes, if it is not more than twice as large as a new one would be.
  Block take(std::size_t bytes);
  void give_back(Block block) noexcept;
  std::size_t idle_bytes() const;
  void release() noexcept;

 private:
  struct Idle;
  std::unique_ptr<Idle> idle_;
};

}  // namespace detail

/// Numbers in memory of a BufferPool, to which it goes back at the end. The values are whatever was there before.
/// Begins at a page: with a line of every cache.
template <class Real>
class Buffer {
  static_assert(std::is_trivially_copyable_v<Real> && std::is_trivially_destructible_v<Real>);

 public:
  Buffer() = default;
  Buffer(Buffer&& other) noexcept { swap(other); }
  Buffer& operator=(Buffer&& other) noexcept {
    Buffer(std::move(other)).swap(*this);
    return *this;
  }
  ~Buffer() {
    if (blocks_) blocks_->give_back(block_);
  }

  std::size_t size() const { return count_; }
  bool empty() const { return count_ == 0; }
  Real* data() const { return static_cast<Real*>(block_.data); }
  Real& operator[](std::size_t i) const { return data()[i]; }
  std::span<Real> span() const { return {data(), count_}; }

 private:
  friend class BufferPool;
  Buffer(std::shared_ptr<detail::Blocks> blocks, std::size_t count)
      : blocks_(std::move(blocks)), block_(blocks_->take(count * sizeof(Real))), count_(count) {}
  void swap(Buffer& other) noexcept {
    std::swap(blocks_, other.blocks_);
    std::swap(block_, other.block_);
    std::swap(count_, other.count_);
  }

  std::shared_ptr<detail::Blocks> blocks_;
  detail::Blocks::Block block_;
  std::size_t count_ = 0;
};

/// Where buffers come from and go back to. Copies share their memory; buffers may outlive the pool. For use by several
/// threads at once.
class BufferPool {
 public:
  BufferPool() : blocks_(std::make_shared<detail::Blocks>()) {}

  /// Room for `count` numbers. Throws std::bad_alloc.
  template <class Real>
  Buffer<Real> take(std::size_t count) {
    if (count == 0) return {};
    if (count > std::numeric_limits<std::size_t>::max() / 2 / sizeof(Real)) throw std::bad_alloc();
    return {blocks_, count};
  }

  /// Memory that is held and not in use.
  std::size_t idle_bytes() const { return blocks_->idle_bytes(); }

  /// Gives that memory back to the system.
  void release() { blocks_->release(); }

 private:
  std::shared_ptr<detail::Blocks> blocks_;
};

}  // namespace twoscale::kernels
