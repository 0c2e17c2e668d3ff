// SPDX-License-Identifier: GPL-3.0-or-later
// A moment after which a search returns what it has.
#pragma once

#include <algorithm>
#include <chrono>

namespace twoscale::analysis {

class Deadline {
 public:
  explicit Deadline(double seconds)
      : end_(std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                                    std::chrono::duration<double>(std::min(seconds, 1e8)))) {}
  bool passed() const { return std::chrono::steady_clock::now() > end_; }
  double left() const {
    return std::max(0.0, std::chrono::duration<double>(end_ - std::chrono::steady_clock::now()).count());
  }

 private:
  std::chrono::steady_clock::time_point end_;
};

}  // namespace twoscale::analysis
