// SPDX-License-Identifier: 0BSD
// Whole files in and out. A file that is written appears whole or not at all.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace twoscale::kernels {

struct WriteOptions {
  bool sync = false;  ///< fsync before the file takes its name
};

/// A file that is written piece by piece; "-" is the standard output. A regular file is written under a temporary name
/// in the same directory and takes its own in finish(), so that readers see the old bytes or all of the new ones;
/// without finish() the temporary file is removed and the old file is untouched. Symbolic links are followed, the
/// permissions of an existing file are kept. The standard output, devices and pipes (/dev/null) are written in place.
/// Everything throws Error (io) naming the path.
class FileOutput {
 public:
  explicit FileOutput(const std::string& path, WriteOptions options = {});
  ~FileOutput();
  FileOutput(const FileOutput&) = delete;
  FileOutput& operator=(const FileOutput&) = delete;

  /// Do the pieces stay out of sight until finish()?
  bool whole() const;
  void write(std::string_view bytes);
  void finish();

 private:
  class Target;
  std::unique_ptr<Target> target_;
};

/// The whole file in one piece.
void write_file(const std::string& path, std::string_view bytes, WriteOptions options = {});

/// All bytes of `path`; "-" is the standard input. Throws Error (io) naming the path.
std::string read_file(const std::string& path);

}  // namespace twoscale::kernels
