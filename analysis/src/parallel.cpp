// SPDX-License-Identifier: GPL-3.0-or-later
#include "parallel.hpp"

#include <flint/flint.h>
#include <glpk.h>

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace twoscale::analysis {

void in_parallel(std::size_t jobs, int threads, const std::function<void(std::size_t)>& job) {
  if (threads <= 1 || jobs <= 1) {
    for (std::size_t i = 0; i < jobs; ++i) job(i);
    return;
  }
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex mutex;
  std::vector<std::thread> workers;
  for (int t = 0; t < threads; ++t)
    workers.emplace_back([&] {
      try {
        for (std::size_t i = next++; i < jobs; i = next++) job(i);
      } catch (...) {
        const std::lock_guard lock(mutex);
        failure = std::current_exception();
        next = jobs;
      }
      glp_free_env();
      flint_cleanup();
    });
  for (auto& w : workers) w.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace twoscale::analysis
