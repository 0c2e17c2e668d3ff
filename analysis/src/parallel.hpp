// SPDX-License-Identifier: GPL-3.0-or-later
// Independent jobs on several threads. A linear program lives and dies on the thread that made it.
#pragma once

#include <cstddef>
#include <functional>

namespace twoscale::analysis {

// job(0), ..., job(jobs - 1), on at most `threads` threads; on the calling one if threads <= 1. The first exception is
// passed on, after all have ended.
void in_parallel(std::size_t jobs, int threads, const std::function<void(std::size_t)>& job);

}  // namespace twoscale::analysis
