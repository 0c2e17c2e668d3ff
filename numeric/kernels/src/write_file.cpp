// SPDX-License-Identifier: 0BSD
// Whole files over POSIX calls: write beside, then rename.
#include "twoscale/kernels/write_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "twoscale/kernels/error.hpp"

namespace twoscale::kernels {
namespace {

[[noreturn]] void fail(const char* what, const std::string& path, int code) {
  throw Error(Error::Kind::io, std::string(what) + " " + quoted(path, PATH_MAX) + ": " + std::strerror(code));
}

// An open descriptor, and a temporary file that is removed unless it was renamed.
class Output {
 public:
  explicit Output(std::string path) : path_(std::move(path)) {}
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  ~Output() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
  }

  void open_in_place() {
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail("cannot write", path_, errno);
  }

  void open_beside() {
    const std::size_t slash = path_.rfind('/');
    const std::string directory = slash == std::string::npos ? std::string() : path_.substr(0, slash + 1);
    for (int attempt = 0; attempt < 1000; ++attempt) {
      const std::string name =
          directory + ".twoscale-" + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".tmp";
      descriptor_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor_ >= 0) {
        temporary_ = name;
        return;
      }
      if (errno != EEXIST) break;
    }
    fail("cannot write", path_, errno);
  }

  void keep_mode(mode_t mode) {
    if (::fchmod(descriptor_, mode & 07777) != 0) fail("cannot write", path_, errno);
  }

  void write(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0) {
        if (errno == EINTR) continue;
        fail("cannot write", path_, errno);
      }
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  void sync() {
    if (::fsync(descriptor_) != 0) fail("cannot write", path_, errno);
  }

  void close() {
    const int descriptor = descriptor_;
    descriptor_ = -1;
    if (::close(descriptor) != 0) fail("cannot write", path_, errno);
  }

  void rename() {
    if (::rename(temporary_.c_str(), path_.c_str()) != 0) fail("cannot write", path_, errno);
    temporary_.clear();
  }

 private:
  std::string path_;
  std::string temporary_;
  int descriptor_ = -1;
};

struct Closer {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

void write_file(const std::string& path, std::string_view bytes, WriteOptions options) {
  if (path == "-") {
    errno = 0;
    const bool whole = std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size();
    if (std::fflush(stdout) != 0 || !whole) {
      throw Error(Error::Kind::io, std::string("cannot write the standard output: ") + std::strerror(errno));
    }
    return;
  }
  if (path.empty()) fail("cannot write", path, ENOENT);
  if (path.find('\0') != std::string::npos) fail("cannot write", path, EINVAL);
  struct stat status {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (!exists && errno != ENOENT) fail("cannot write", path, errno);
  if (exists && S_ISDIR(status.st_mode)) fail("cannot write", path, EISDIR);
  if (exists && !S_ISREG(status.st_mode)) {
    Output device(path);
    device.open_in_place();
    device.write(bytes);
    device.close();
    return;
  }
  std::string target = path;
  if (exists) {
    if (::access(path.c_str(), W_OK) != 0) fail("cannot write", path, errno);
    const std::unique_ptr<char, decltype(&std::free)> resolved(::realpath(path.c_str(), nullptr), &std::free);
    if (!resolved) fail("cannot write", path, errno);
    target = resolved.get();
  }
  Output file(target);
  file.open_beside();
  if (exists) file.keep_mode(status.st_mode);
  file.write(bytes);
  if (options.sync) file.sync();
  file.close();
  file.rename();
}

std::string read_file(const std::string& path) {
  const bool standard = path == "-";
  if (path.find('\0') != std::string::npos) fail("cannot read", path, EINVAL);
  std::unique_ptr<std::FILE, Closer> owned;
  if (!standard) {
    owned.reset(std::fopen(path.c_str(), "rb"));
    if (!owned) fail("cannot read", path, errno);
  }
  std::FILE* file = standard ? stdin : owned.get();
  std::string bytes;
  std::string block(1 << 16, '\0');
  errno = 0;
  while (const std::size_t got = std::fread(block.data(), 1, block.size(), file)) bytes.append(block, 0, got);
  if (std::ferror(file)) fail("cannot read", path, errno);
  return bytes;
}

}  // namespace twoscale::kernels
