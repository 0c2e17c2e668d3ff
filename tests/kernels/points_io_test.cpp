// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/kernels/points_io.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>

#include "twoscale/kernels/error.hpp"
#include "twoscale/kernels/number_text.hpp"
#include "twoscale/kernels/write_file.hpp"

namespace twoscale::kernels {
namespace {

namespace fs = std::filesystem;

class Directory {
 public:
  Directory() {
    std::string pattern = (fs::temp_directory_path() / "twoscale-test-XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  ~Directory() { fs::remove_all(path_); }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::string message_of(const auto& action, Error::Kind kind = Error::Kind::bad_input) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind, kind);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "no error";
}

std::string csv_error(std::string_view bytes) {
  return message_of([&] { parse_csv(bytes, "in.csv"); });
}

using Values = std::vector<double>;
using Texts = std::vector<std::string>;

TEST(Numbers, DecimalGrammar) {
  for (const char* good : {"0", "-0", "+1", "1.", ".5", "1e5", "1E-5", "-1.25e+03", "00012", "1e9999"}) {
    EXPECT_TRUE(is_decimal(good)) << good;
  }
  for (const char* bad : {"", "+", "-", ".", "e5", "1e", "1e+", "1 ", " 1", "0x1", "nan", "inf", "1,5", "1/2", "--1",
                          "1e10000", "1.2.3", "1e5.", "\xC2\xBD"}) {
    EXPECT_FALSE(is_decimal(bad)) << bad;
  }
  EXPECT_TRUE(is_decimal(std::string(max_number_length, '7')));
  EXPECT_FALSE(is_decimal(std::string(max_number_length + 1, '7')));
}

TEST(Numbers, ValuesAtTheEdges) {
  const std::string zeros(400, '0');
  EXPECT_EQ(parse_double("1e308"), 1e308);
  EXPECT_EQ(parse_double("1e309"), std::nullopt);
  EXPECT_EQ(parse_double("-1e309"), std::nullopt);
  EXPECT_EQ(parse_double("1e-400"), 0.0);
  EXPECT_TRUE(std::signbit(*parse_double("-1e-400")));
  EXPECT_EQ(parse_double("0e9999"), 0.0);
  EXPECT_EQ(parse_double("0." + zeros + "1"), 0.0);
  EXPECT_EQ(parse_double("0." + zeros + "1e401"), 1.0);
  EXPECT_EQ(parse_double("1" + zeros + "e-400"), 1.0);
  EXPECT_EQ(parse_double("1" + zeros), std::nullopt);
  EXPECT_EQ(parse_double("4.9e-324"), 4.9e-324);
  EXPECT_EQ(hex_float(1.5), "0x1.8p+0");
  EXPECT_EQ(hex_float(-0.0625), "-0x1p-4");
  EXPECT_EQ(hex_float(-0.0), "-0x0p+0");
  std::mt19937_64 random(5);
  for (int i = 0; i < 2000; ++i) {
    const double x = std::bit_cast<double>(random());
    if (!std::isfinite(x)) continue;
    EXPECT_EQ(parse_double(shortest(x)), x);
    EXPECT_EQ(std::strtod(hex_float(x).c_str(), nullptr), x);
  }
}

TEST(Csv, HeaderCommentsBlankLinesAndCrlf) {
  const PointSet points =
      parse_csv("\xEF\xBB\xBF# data\r\n\r\nx, y ,lambda\r\n 1,+2.50 ,3e-2\r\n#c\r\n\t4,5,6", "in.csv");
  EXPECT_EQ(points.columns, (Texts{"x", "y", "lambda"}));
  EXPECT_EQ(points.dim, 3u);
  EXPECT_EQ(points.values, (Values{1, 2.5, 0.03, 4, 5, 6}));
  EXPECT_EQ(points.tokens, (Texts{"1", "2.50", "3e-2", "4", "5", "6"}));
}

TEST(Csv, WithoutAHeader) {
  const PointSet points = parse_csv("1,2\n3,4\n", "in.csv");
  EXPECT_EQ(points.columns, (Texts{"x", "y"}));
  EXPECT_EQ(points.size(), 2u);
}

TEST(Csv, ErrorsNameFileLineAndText) {
  EXPECT_EQ(csv_error("x,y\n1,2\n\n1,abc\n"), "in.csv:4: not a number: 'abc'");
  EXPECT_EQ(csv_error("1,2\n1,2,3\n"), "in.csv:2: 3 numbers instead of 2 in '1,2,3'");
  EXPECT_EQ(csv_error("1,2\n1,nan\n"), "in.csv:2: not a number: 'nan'");
  EXPECT_EQ(csv_error("nan,inf\n"), "in.csv:1: not a number: 'nan'");
  EXPECT_EQ(csv_error("1,-Infinity\n"), "in.csv:1: not a number: '-Infinity'");
  EXPECT_EQ(csv_error("1,1e999\n"), "in.csv:1: number too large for a double: '1e999'");
  EXPECT_EQ(csv_error("1,\n"), "in.csv:1: not a number: ''");
  EXPECT_EQ(csv_error(""), "in.csv:1: the file has no points");
  EXPECT_EQ(csv_error("x,y\n"), "in.csv:1: the file has no points");
  EXPECT_EQ(csv_error("x,x\n1,2\n"), "in.csv:1: two columns have the name 'x'");
  EXPECT_EQ(csv_error("1 2\n"), "in.csv:1: not a number: '1 2'");
  EXPECT_EQ(csv_error("x,y\n1,2\nx,y\n"), "in.csv:3: not a number: 'x'");
  EXPECT_EQ(csv_error(std::string_view("1,2\n1,\0\x1b[m\n", 11)), "in.csv:2: not a number: '\\x00\\x1b[m'");
  std::string long_number = "1,2\n3,";
  long_number.append(max_number_length + 1, '9');
  EXPECT_NE(csv_error(long_number).find("in.csv:2: not a number: '999"), std::string::npos);
}

TEST(Csv, RoundTrip) {
  const std::string bytes = "x,y,tag\n0.10,1e-5,0\n-0,12345678901234567890123,1\n";
  EXPECT_EQ(to_csv(parse_csv(bytes, "a")), bytes);
  PointSet points;
  points.dim = 2;
  points.values = {0.1, 1.0 / 3, -0.0, 1e300};
  const PointSet again = parse_csv(to_csv(points), "a");
  EXPECT_EQ(again.values, points.values);
  EXPECT_EQ(again.columns, (Texts{"x", "y"}));
  EXPECT_EQ(to_csv(points, false), "0.1,0.3333333333333333\n-0,1e+300\n");
}

TEST(Npy, RoundTripAndTokens) {
  PointSet points;
  points.dim = 2;
  points.values = {0.1, -2, 1.0 / 3, 5e-324};
  const std::string bytes = to_npy(points);
  EXPECT_EQ(bytes.size(), 128u + 32u);
  EXPECT_EQ(bytes.substr(0, 10), std::string("\x93NUMPY\x01\x00\x76\x00", 10));
  EXPECT_NE(bytes.find("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2), }"), std::string::npos);
  const PointSet again = parse_npy(bytes, "a.npy");
  EXPECT_EQ(again.values, points.values);
  EXPECT_EQ(again.tokens, (Texts{"0.1", "-2", "0.3333333333333333", "5e-324"}));
}

std::string npy(const std::string& dictionary, const std::string& data, int major = 1) {
  std::string out = "\x93NUMPY";
  out += static_cast<char>(major);
  out += '\0';
  out += static_cast<char>(dictionary.size() & 0xff);
  out += static_cast<char>(dictionary.size() >> 8);
  if (major > 1) out += std::string(2, '\0');
  return out + dictionary + data;
}

TEST(Npy, OtherTypesAndOrders) {
  using namespace std::string_literals;
  EXPECT_EQ(parse_npy(npy("{'descr': '<f4', 'fortran_order': False, 'shape': (1, 2)}", "\0\0\x80\x3f\0\0\0\xc0"s), "a")
                .values,
            (Values{1, -2}));
  const PointSet bytes =
      parse_npy(npy("{\"shape\":(3,),'fortran_order':False,'descr':'|i1',}\n", "\xff\x02\x80"s, 2), "a");
  EXPECT_EQ(bytes.values, (Values{-1, 2, -128}));
  EXPECT_EQ(bytes.dim, 1u);
  EXPECT_EQ(
      parse_npy(npy("{'descr': '>u2', 'fortran_order': True, 'shape': (2, 2), }", "\0\1\0\2\0\3\xff\xff"s), "a").values,
      (Values{1, 3, 2, 65535}));
  EXPECT_EQ(
      parse_npy(npy("{'descr': '<i8', 'fortran_order': False, 'shape': (1, 1), }", "\1\0\0\0\0\0\0\x80"s), "a").tokens,
      (Texts{"-9223372036854775807"}));
}

TEST(Npy, MalformedFilesAreErrors) {
  using namespace std::string_literals;
  const std::string one(8, '\0');
  const std::string nan = "\0\0\0\0\0\0\xf8\x7f"s;
  const auto fails = [&](const std::string& bytes, const char* what) {
    const std::string message = message_of([&] { parse_npy(bytes, "a.npy"); });
    EXPECT_EQ(message.find("a.npy: "), 0u) << message;
    EXPECT_NE(message.find(what), std::string::npos) << message;
  };
  const auto head = [](const char* descr, const char* shape) {
    return "{'descr': "s + descr + ", 'fortran_order': False, 'shape': " + shape + ", }";
  };
  fails("", "not a NumPy file");
  fails("x,y\n", "not a NumPy file");
  fails("\x93NUMPY\1", "cut off");
  fails(npy(head("'<f8'", "(1, 1)"), one, 9), "9.0");
  fails(npy("{}", one), "not understood");
  fails(npy(head("'<f8'", "(1, 1"), one), "not understood");
  fails(npy(head("[('a', '<f8')]", "(1, 1)"), one), "not understood");
  fails(npy(head("'<c16'", "(1, 1)"), one), "'<c16'");
  fails(npy(head("'<f8'", "(1, 1, 1)"), one), "axes");
  fails(npy(head("'<f8'", "()"), one), "axes");
  fails(npy(head("'<f8'", "(0, 2)"), ""), "no points");
  fails(npy(head("'<f8'", "(2, 1)"), one), "bytes follow");
  fails(npy(head("'<f8'", "(1, 1)"), one + "x"), "bytes follow");
  fails(npy(head("'<f8'", "(4611686018427387905, 4)"), one), "bytes follow");
  fails(npy(head("'<f8'", "(99999999999999999999, 4)"), one), "not understood");
  fails(npy(head("'<f8'", "(1, 1)"), nan), "row 0");
  std::string cut = npy(head("'<f8'", "(1, 1)"), one);
  cut[8] = '\xff';
  fails(cut, "cut off");
}

TEST(Obj, PolylinesAndPlainPoints) {
  const PointSet plain = parse_obj("# c\no name\nv 1 2 3\nv 4 5e0 6 # end\n", "a.obj");
  EXPECT_EQ(plain.values, (Values{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(plain.tokens[4], "5e0");
  EXPECT_FALSE(plain.closed);
  const PointSet line = parse_obj("v 0 0\nv 1 0\nv 1 1\nl 3 1 -2 3\n", "a.obj");
  EXPECT_EQ(line.values, (Values{1, 1, 0, 0, 1, 0}));
  EXPECT_TRUE(line.closed);
  const PointSet back = parse_obj(to_obj(line, true), "b.obj");
  EXPECT_TRUE(back.closed);
  EXPECT_EQ(back.values, (Values{1, 1, 0, 0, 0, 0, 1, 0, 0}));
  const auto error = [](const char* bytes) { return message_of([&] { parse_obj(bytes, "a.obj"); }); };
  EXPECT_EQ(error("v 1 2 nan\n"), "a.obj:1: not a number: 'nan'");
  EXPECT_EQ(error("v 1\n"), "a.obj:1: a point needs 2 or 3 coordinates: 'v 1'");
  EXPECT_EQ(error("v 1 2\nv 1 2 3\n"), "a.obj:2: 3 coordinates instead of 2 in 'v 1 2 3'");
  EXPECT_EQ(error("v 1 2\nl 1 2\n"), "a.obj:2: not a point of the file: '2'");
  EXPECT_EQ(error("v 1 2\nl 0\n"), "a.obj:2: not a point of the file: '0'");
  EXPECT_EQ(error("v 1 2\nl 1\nl 1\n"), "a.obj:3: a second polyline: 'l 1'");
  EXPECT_EQ(error("v 1 2\nl\n"), "a.obj:2: a polyline without points");
  EXPECT_EQ(error("v 1 2\nf 1 1 1\n"), "a.obj:2: faces are not a polygon to refine: 'f 1 1 1'");
  EXPECT_EQ(error("w 1 2\n"), "a.obj:1: not understood: 'w 1 2'");
  EXPECT_EQ(error("\n"), "a.obj:1: the file has no points");
}

PointSet triangle() { return parse_csv("x,y\n0,0\n2.0,0\n1,1e0\n", "t"); }

TEST(Obj, WritesTokens) {
  EXPECT_EQ(to_obj(triangle(), true), "# polyline of twoscale\nv 0 0 0\nv 2.0 0 0\nv 1 1e0 0\nl 1 2 3 1\n");
  PointSet wide;
  wide.dim = 4;
  wide.values = Values(8);
  EXPECT_NE(message_of([&] { to_obj(wide, false); }).find("not 4"), std::string::npos);
}

TEST(Ply, VerticesAndEdges) {
  EXPECT_EQ(to_ply(triangle(), true),
            "ply\nformat ascii 1.0\ncomment polyline of twoscale\nelement vertex 3\nproperty double x\nproperty double "
            "y\nproperty double z\nelement edge 3\nproperty int vertex1\nproperty int vertex2\nend_header\n"
            "0 0 0\n2.0 0 0\n1 1e0 0\n0 1\n1 2\n2 0\n");
  EXPECT_NE(to_ply(triangle(), false).find("element edge 2"), std::string::npos);
}

TEST(Svg, FitsTheViewBoxWithYUp) {
  const std::string svg = to_svg(triangle(), true);
  EXPECT_NE(svg.find("viewBox=\"0 0 1040 540\""), std::string::npos) << svg;
  EXPECT_NE(svg.find("<polygon "), std::string::npos);
  EXPECT_NE(svg.find("points=\"20,520 1020,520 520,20\""), std::string::npos) << svg;
  EXPECT_NE(to_svg(triangle(), false).find("<polyline "), std::string::npos);
  PointSet extreme;
  extreme.dim = 2;
  extreme.values = {-1.7e308, -1.7e308, 1.7e308, 1.7e308};
  EXPECT_NE(to_svg(extreme, false).find("points=\"20,1020 1020,20\""), std::string::npos);
  extreme.values = {3, 3};
  EXPECT_NE(to_svg(extreme, false).find("points=\"20,20\""), std::string::npos);
  extreme.dim = 1;
  EXPECT_NE(message_of([&] { to_svg(extreme, false); }).find("two columns"), std::string::npos);
}

TEST(Points, NotFiniteOrEmptySetsAreNotWritten) {
  PointSet points;
  points.dim = 2;
  for (const PointFormat format :
       {PointFormat::csv, PointFormat::npy, PointFormat::obj, PointFormat::ply, PointFormat::svg}) {
    points.values.clear();
    EXPECT_NE(message_of([&] { points_to_bytes(points, format, false); }).find("there are none"), std::string::npos);
    points.values = {1, std::numeric_limits<double>::infinity()};
    EXPECT_NE(message_of([&] { points_to_bytes(points, format, false); }).find("not finite"), std::string::npos);
  }
}

TEST(Points, FormatBySuffix) {
  EXPECT_EQ(point_format("a.b/c.CSV"), PointFormat::csv);
  EXPECT_EQ(point_format("-"), PointFormat::csv);
  EXPECT_EQ(point_format("x.ply"), PointFormat::ply);
  EXPECT_NE(message_of([] { point_format("a.csv/c"); }).find("'a.csv/c'"), std::string::npos);
  EXPECT_NE(message_of([] { read_points("c.svg"); }).find("'c.svg'"), std::string::npos);
}

TEST(Points, AnyBytesAreReadOrRefused) {
  std::mt19937 random(11);
  const std::vector<std::string> seeds = {
      "x,y\n1,2\n3,4\n", "v 1 2 3\nv 4 5 6\nl 1 2 1\n",
      npy("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 1), }", std::string(16, '\1'))};
  for (int round = 0; round < 6000; ++round) {
    std::string bytes = seeds[static_cast<std::size_t>(round) % seeds.size()];
    for (int change = 0; change < 1 + round % 5; ++change) {
      const std::size_t at = random() % (bytes.size() + 1);
      switch (random() % 3) {
        case 0: bytes.insert(at, 1, static_cast<char>(random())); break;
        case 1: bytes.erase(at, 1 + random() % 3); break;
        default:
          if (at < bytes.size()) bytes[at] = static_cast<char>(random());
      }
    }
    for (auto* parse : {parse_csv, parse_npy, parse_obj}) {
      try {
        const PointSet points = parse(bytes, "fuzz");
        ASSERT_GT(points.size(), 0u);
        ASSERT_EQ(points.tokens.size(), points.values.size());
        ASSERT_EQ(points.columns.size(), points.dim);
        for (std::size_t i = 0; i < points.values.size(); ++i) {
          ASSERT_TRUE(std::isfinite(points.values[i]));
          ASSERT_EQ(parse_double(points.tokens[i]), points.values[i]);
        }
      } catch (const Error& error) {
        ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      }
    }
  }
}

TEST(WriteFile, WholeOrNotAtAll) {
  const Directory directory;
  const std::string path = directory / "out.csv";
  write_file(path, "one");
  EXPECT_EQ(read_file(path), "one");
  ::chmod(path.c_str(), 0640);
  fs::create_symlink(path, directory / "link.csv");
  write_file(directory / "link.csv", std::string("two\0", 4), {.sync = true});
  EXPECT_EQ(read_file(path), std::string("two\0", 4));
  EXPECT_TRUE(fs::is_symlink(directory / "link.csv"));
  EXPECT_EQ(fs::status(path).permissions(), static_cast<fs::perms>(0640));
  EXPECT_EQ(std::distance(fs::directory_iterator(directory.path()), {}), 2);
  write_file("/dev/null", "gone");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(WriteFile, PiecesAppearTogether) {
  const Directory directory;
  const std::string path = directory / "out.csv";
  write_file(path, "old");
  {
    FileOutput file(path);
    EXPECT_TRUE(file.whole());
    file.write("new");
    EXPECT_EQ(read_file(path), "old");
  }  // not finished
  EXPECT_EQ(read_file(path), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(directory.path()), {}), 1);
  FileOutput file(path);
  file.write("new");
  file.write("er");
  file.finish();
  EXPECT_EQ(read_file(path), "newer");
  EXPECT_FALSE(FileOutput("/dev/null").whole());
}

TEST(Points, PiecesAreTheWhole) {
  PointSet points;
  points.dim = 2;
  points.columns = {"a", "b"};
  for (int i = 0; i < 14; ++i) points.values.push_back(i / 7.0);
  for (const PointFormat format : {PointFormat::csv, PointFormat::npy}) {
    std::string joined = points_head(format, points.columns, 2, points.size());
    const std::span<const double> values(points.values);
    append_points(joined, format, values.first(6), 2);
    append_points(joined, format, values.subspan(6), 2);
    EXPECT_EQ(joined, points_to_bytes(points, format, true));
    const double infinite[] = {0.0, HUGE_VAL};
    EXPECT_THROW(append_points(joined, format, infinite, 2), Error);
  }
  EXPECT_THROW(points_head(PointFormat::obj, points.columns, 2, 7), Error);
}

TEST(WriteFile, ErrorsNameThePath) {
  const Directory directory;
  const auto io = Error::Kind::io;
  const std::string missing = directory / "no/such/file.csv";
  EXPECT_NE(message_of([&] { write_file(missing, "x"); }, io).find(missing), std::string::npos);
  EXPECT_NE(message_of([&] { read_file(missing); }, io).find(missing), std::string::npos);
  EXPECT_NE(message_of([&] { write_file(directory.path().string(), "x"); }, io).find("directory"), std::string::npos);
  EXPECT_NE(message_of([&] { read_file(directory.path().string()); }, io).find("directory"), std::string::npos);
  EXPECT_NE(message_of([&] { write_file("", "x"); }, io).find("''"), std::string::npos);
  EXPECT_NE(message_of([&] { write_file(std::string("a\0b", 3), "x"); }, io).find("\\x00"), std::string::npos);
  EXPECT_TRUE(fs::is_empty(directory.path()));
  if (fs::exists("/dev/full")) {
    EXPECT_NE(message_of([&] { write_file("/dev/full", "x"); }, io).find("/dev/full"), std::string::npos);
  }
}

TEST(WriteFile, PointsBySuffix) {
  const Directory directory;
  write_points(directory / "t.npy", triangle(), true);
  EXPECT_EQ(read_points(directory / "t.npy").values, triangle().values);
  write_points(directory / "t.csv", triangle(), true);
  EXPECT_EQ(read_points(directory / "t.csv").tokens, triangle().tokens);
}

}  // namespace
}  // namespace twoscale::kernels
