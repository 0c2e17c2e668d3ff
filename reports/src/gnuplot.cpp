// SPDX-License-Identifier: GPL-3.0-or-later
// gnuplot as a child process: script in a temporary file, image from its standard output, complaints from its standard
// error.
#include <fcntl.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "gnuplot.hpp"
#include "twoscale/kernels/write_file.hpp"
#include "twoscale/reports/plot.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::reports {

namespace {

[[noreturn]] void fail(const std::string& message, const std::string& piece = {}) {
  throw Error(Error::Kind::io, message, piece);
}

// A directory of one's own, gone with its contents at the end.
class TemporaryDirectory {
 public:
  TemporaryDirectory() {
    std::error_code none;
    std::string name = (std::filesystem::temp_directory_path(none) / "twoscale-XXXXXX").string();
    if (none || mkdtemp(name.data()) == nullptr) fail("no temporary directory could be made", name);
    path_ = name;
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  ~TemporaryDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::string file(const char* name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

// The environment without what would change gnuplot's numbers or make it look for a display.
std::vector<std::string> environment() {
  std::vector<std::string> list;
  for (char** e = environ; e != nullptr && *e != nullptr; ++e) {
    const std::string_view entry(*e);
    const bool dropped = entry.starts_with("LC_") || entry.starts_with("LANG") || entry.starts_with("GNUTERM=") ||
                         entry.starts_with("GNUPLOT") || entry.starts_with("DISPLAY=");
    if (!dropped) list.emplace_back(entry);
  }
  list.emplace_back("LC_ALL=C.UTF-8");
  return list;
}

std::vector<char*> pointers(std::vector<std::string>& list) {
  std::vector<char*> p;
  for (auto& s : list) p.push_back(s.data());
  p.push_back(nullptr);
  return p;
}

// Exit status, or -1 after a signal.
int run_gnuplot(const std::string& script, const std::string& out, const std::string& complaints) {
  std::vector<std::string> words = {"gnuplot", "--default-settings", script};
  std::vector<std::string> variables = environment();
  const std::vector<char*> argv = pointers(words);
  const std::vector<char*> envp = pointers(variables);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, complaints.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  pid_t child = 0;
  const int error = posix_spawnp(&child, "gnuplot", &actions, nullptr, argv.data(), envp.data());
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0)
    fail(std::string("gnuplot could not be started (") + std::strerror(error) + "); it draws the pictures");
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) fail("waiting for gnuplot failed", std::strerror(errno));
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

// The first line that says something: gnuplot shows the place with a ^ and blank lines before.
std::string first_complaint(const std::string& text) {
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    if (line.find("line ") != std::string::npos) return line;
    begin = end + 1;
  }
  return text.substr(0, text.find('\n'));
}

}  // namespace

ImageFormat image_format(const std::string& path) {
  if (path == "-") return ImageFormat::svg;
  std::string suffix = std::filesystem::path(path).extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (suffix == ".svg") return ImageFormat::svg;
  if (suffix == ".pdf") return ImageFormat::pdf;
  if (suffix == ".png") return ImageFormat::png;
  bad_input("pictures are written as .svg, .pdf or .png, not as", path);
}

std::string image_of(const std::string& script) {
  const TemporaryDirectory directory;
  kernels::write_file(directory.file("picture.gp"), script);
  const int status = run_gnuplot(directory.file("picture.gp"), directory.file("image"), directory.file("complaints"));
  const std::string complaints = kernels::read_file(directory.file("complaints"));
  if (status != 0) fail("gnuplot failed", first_complaint(complaints));
  std::string image = kernels::read_file(directory.file("image"));
  if (image.empty()) fail("gnuplot drew nothing", first_complaint(complaints));
  return image;
}

std::string render(const Picture& picture, ImageFormat format) { return image_of(gnuplot_script(picture, format)); }

void draw(const Picture& picture, const std::string& path) {
  kernels::write_file(path, render(picture, image_format(path)));
}

}  // namespace twoscale::reports
