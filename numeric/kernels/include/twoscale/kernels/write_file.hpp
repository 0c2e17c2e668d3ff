// SPDX-License-Identifier: 0BSD
// Whole files in and out. A file that is written appears whole or not at all.
#pragma once

#include <string>
#include <string_view>

namespace twoscale::kernels {

struct WriteOptions {
  bool sync = false;  ///< fsync before the file takes its name
};

/// Writes `bytes` to `path`; "-" is the standard output. A regular file is written under a temporary name in the same
/// directory and then renamed, so that readers see the old bytes or all of the new ones; on failure the temporary file
/// is removed and the old file is untouched. Symbolic links are followed, the permissions of an existing file are kept,
/// and devices and pipes (/dev/null) are written in place. Throws Error (io) naming the path.
void write_file(const std::string& path, std::string_view bytes, WriteOptions options = {});

/// All bytes of `path`; "-" is the standard input. Throws Error (io) naming the path.
std::string read_file(const std::string& path);

}  // namespace twoscale::kernels
