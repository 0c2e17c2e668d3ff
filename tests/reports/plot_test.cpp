// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures: what is refused, what is written, and that nothing is left behind.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "twoscale/kernels/error.hpp"
#include "twoscale/reports/plot.hpp"
#include "twoscale/symbolic/error.hpp"

namespace {

using namespace twoscale;
using namespace twoscale::reports;

Picture triangle(std::size_t dim) {
  Line l;
  l.dim = dim;
  l.values = dim == 2 ? std::vector<double>{0, 0, 1, 2, 3, 1} : std::vector<double>{0, 0, 0, 1, 2, 1, 3, 1, 2};
  l.style = Line::Style::polygon;
  l.closed = true;
  l.title = "it's a 'polygon'; system \"false\" `date` $x ^2_3 \n v⁰";
  Picture p;
  p.lines = {l};
  p.lines.push_back(l);
  p.lines[1].style = Line::Style::curve;
  return p;
}

std::string bytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream out;
  out << file.rdbuf();
  return out.str();
}

class Directory {
 public:
  Directory() : path_(std::filesystem::temp_directory_path() / ("twoscale reports test " + std::to_string(getpid()))) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~Directory() { std::filesystem::remove_all(path_); }
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  long files() const {
    return std::distance(std::filesystem::directory_iterator(path_), std::filesystem::directory_iterator());
  }

 private:
  std::filesystem::path path_;
};

Error::Kind kind_of(const std::function<void()>& f, const std::string& naming) {
  try {
    f();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find(naming), std::string::npos) << e.what();
    return e.kind;
  }
  ADD_FAILURE() << "not refused: " << naming;
  return Error::Kind::undecided;
}

TEST(Plot, FormatBySuffix) {
  EXPECT_EQ(image_format("a/b.svg"), ImageFormat::svg);
  EXPECT_EQ(image_format("x.PDF"), ImageFormat::pdf);
  EXPECT_EQ(image_format("x.y.png"), ImageFormat::png);
  EXPECT_EQ(image_format("-"), ImageFormat::svg);
  for (const char* name : {"x", "x.", "svg", ".svg", "x.jpg", "", "x.svg/"})
    EXPECT_EQ(kind_of([&] { image_format(name); }, name), Error::Kind::bad_input) << name;
}

TEST(Plot, WritesEveryFormat) {
  const Directory directory;
  for (std::size_t dim : {2U, 3U}) {
    draw(triangle(dim), directory.file("it's $x;`y` \"z\".svg"));
    draw(triangle(dim), directory.file("b.pdf"));
    draw(triangle(dim), directory.file("c.png"));
  }
  EXPECT_EQ(directory.files(), 3);
  EXPECT_NE(bytes(directory.file("it's $x;`y` \"z\".svg")).find("<svg"), std::string::npos);
  EXPECT_EQ(bytes(directory.file("b.pdf")).substr(0, 5), "%PDF-");
  EXPECT_EQ(bytes(directory.file("c.png")).substr(1, 3), "PNG");
}

TEST(Plot, SvgIsDeterministic) {
  EXPECT_EQ(render(triangle(2), ImageFormat::svg), render(triangle(2), ImageFormat::svg));
  EXPECT_EQ(render(triangle(3), ImageFormat::svg), render(triangle(3), ImageFormat::svg));
}

TEST(Plot, RefusesBadOutput) {
  const Directory directory;
  EXPECT_EQ(kind_of([&] { draw(triangle(2), directory.file("x.jpeg")); }, "x.jpeg"), Error::Kind::bad_input);
  EXPECT_THROW(draw(triangle(2), directory.file("none/x.svg")), kernels::Error);
  EXPECT_THROW(draw(triangle(2), "/proc/x.svg"), kernels::Error);
  EXPECT_EQ(directory.files(), 0);
}

TEST(Plot, RefusesUnusablePictures) {
  const auto refused = [](const Picture& p) { EXPECT_THROW(gnuplot_script(p, ImageFormat::svg), Error); };
  refused({});
  Picture p = triangle(2);
  p.lines[0].values[3] = NAN;
  refused(p);
  p.lines[0].values[3] = 1e200;
  refused(p);
  p.lines[0].values[3] = INFINITY;
  refused(p);
  p = triangle(2);
  p.lines[1].dim = 3;
  refused(p);
  p = triangle(2);
  p.lines[0].values.clear();
  refused(p);
  p = triangle(2);
  p.equal_axes = false;
  p.logarithmic_x = true;
  refused(p);
}

TEST(Plot, DegenerateDataAreDrawn) {
  Picture p;
  p.lines.resize(1);
  p.lines[0].values = {1, 1, 1, 1};
  EXPECT_NE(render(p, ImageFormat::svg).find("</svg>"), std::string::npos);
  p.equal_axes = false;
  p.lines[0].values = {0, 0, 1, 0};
  EXPECT_NE(render(p, ImageFormat::svg).find("</svg>"), std::string::npos);
}

// Text is quoted: no title ends its string or line.
TEST(Plot, TitlesStayText) {
  const std::string script = gnuplot_script(triangle(2), ImageFormat::svg);
  EXPECT_NE(script.find("title 'it''s a ''polygon''; system \"false\" `date` $x ^2_3   v⁰'"), std::string::npos)
      << script;
}

TEST(Plot, MissingProgramIsReported) {
  const char* path = getenv("PATH");
  const std::string saved = path == nullptr ? "" : path;
  setenv("PATH", "/nonexistent", 1);
  const Error::Kind kind = kind_of([] { render(triangle(2), ImageFormat::svg); }, "gnuplot");
  setenv("PATH", saved.c_str(), 1);
  EXPECT_EQ(kind, Error::Kind::io);
}

}  // namespace
