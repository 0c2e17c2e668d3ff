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
#include <utility>

#include "twoscale/kernels/error.hpp"

namespace twoscale::kernels {
namespace {

[[noreturn]] void fail(const char* what, const std::string& path, int code) {
  throw Error(Error::Kind::io, std::string(what) + " " + quoted(path, PATH_MAX) + ": " + std::strerror(code));
}

struct Closer {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

// The standard output, or an open descriptor with a temporary file that is removed unless it was renamed.
class FileOutput::Target {
 public:
  Target(const std::string& path, WriteOptions options) : path_(path), options_(options) {
    if (path == "-") return;
    if (path.empty()) fail("cannot write", path, ENOENT);
    if (path.find('\0') != std::string::npos) fail("cannot write", path, EINVAL);
    struct stat status {};
    const bool exists = ::stat(path.c_str(), &status) == 0;
    if (!exists && errno != ENOENT) fail("cannot write", path, errno);
    if (exists && S_ISDIR(status.st_mode)) fail("cannot write", path, EISDIR);
    if (exists && !S_ISREG(status.st_mode)) {
      descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
      if (descriptor_ < 0) fail("cannot write", path_, errno);
      return;
    }
    if (exists) {
      if (::access(path.c_str(), W_OK) != 0) fail("cannot write", path, errno);
      const std::unique_ptr<char, decltype(&std::free)> resolved(::realpath(path.c_str(), nullptr), &std::free);
      if (!resolved) fail("cannot write", path, errno);
      path_ = resolved.get();
    }
    open_beside();
    if (exists && ::fchmod(descriptor_, status.st_mode & 07777) != 0) {
      const int code = errno;
      discard();
      fail("cannot write", path_, code);
    }
  }
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;
  ~Target() { discard(); }

  bool whole() const { return !temporary_.empty(); }

  void write(std::string_view bytes) {
    if (descriptor_ < 0) {
      errno = 0;
      if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size()) fail_standard();
      return;
    }
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0) {
        if (errno == EINTR) continue;
        fail("cannot write", path_, errno);
      }
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  void finish() {
    if (descriptor_ < 0) {
      errno = 0;
      if (std::fflush(stdout) != 0) fail_standard();
      return;
    }
    if (options_.sync && whole() && ::fsync(descriptor_) != 0) fail("cannot write", path_, errno);
    const int descriptor = std::exchange(descriptor_, -1);
    if (::close(descriptor) != 0) fail("cannot write", path_, errno);
    if (!whole()) return;
    if (::rename(temporary_.c_str(), path_.c_str()) != 0) fail("cannot write", path_, errno);
    temporary_.clear();
  }

 private:
  [[noreturn]] static void fail_standard() {
    throw Error(Error::Kind::io, std::string("cannot write the standard output: ") + std::strerror(errno));
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

  void discard() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
    descriptor_ = -1;
    temporary_.clear();
  }

  std::string path_;
  WriteOptions options_;
  std::string temporary_;
  int descriptor_ = -1;  // -1: the standard output
};

FileOutput::FileOutput(const std::string& path, WriteOptions options)
    : target_(std::make_unique<Target>(path, options)) {}
FileOutput::~FileOutput() = default;
bool FileOutput::whole() const { return target_->whole(); }
void FileOutput::write(std::string_view bytes) { target_->write(bytes); }
void FileOutput::finish() { target_->finish(); }

void write_file(const std::string& path, std::string_view bytes, WriteOptions options) {
  FileOutput file(path, options);
  file.write(bytes);
  file.finish();
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
