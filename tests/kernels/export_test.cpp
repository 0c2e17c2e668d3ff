// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tables.hpp"
#include "twoscale/kernels/error.hpp"
#include "twoscale/kernels/export/refinement_matrix.hpp"
#include "twoscale/kernels/export/table_writer.hpp"
#include "twoscale/kernels/refine.hpp"
#include "twoscale/kernels/write_file.hpp"

namespace twoscale::kernels {
namespace {

namespace fs = std::filesystem;
using testing::chaikin;
using testing::tension;
using Json = nlohmann::ordered_json;

// 50 digits of the limit rows of a dual ternary-like table; the doubles are their roundings.
MaskTable many_digits() {
  MaskTable table;
  table.scheme =
      "exponential-bspline:space=\"1, x */ /* ?"
      "?/ \\\"";
  table.arity = 3;
  table.shift = "1/2";
  table.digits = 30;
  table.precision_error = "5e-31";
  MaskRow row;
  row.lowest = -1;
  row.text = {"0.333333333333333333333333333333", "-1", "1e-7", "0.100000000000000000000000000001"};
  row.value = {1.0 / 3, -1, 1e-7, 0.1};
  table.levels = {row, row};
  row.lowest = -2;  // another support, to see it padded
  table.limit = row;
  table.tail_from = 2;
  table.tail_bound = "1/10";
  return table;
}

class Directory {
 public:
  Directory() {
    std::string pattern = (fs::temp_directory_path() / "twoscale-test-XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  ~Directory() { fs::remove_all(path_); }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

TEST(Writers, AreFoundByName) {
  EXPECT_EQ(find_table_writer("json")->name(), "json");
  EXPECT_EQ(find_table_writer("cpp")->suffix(), "hpp");
  EXPECT_EQ(find_table_writer("xml"), nullptr);
  try {
    write_table(chaikin(), "xml");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(
        error.what(),
        "no mask table format is called 'xml' (json, csv, c, cpp, python, npy, julia, matlab, glsl, typescript, latex, "
        "pywavelets, stencil, matrixmarket)");
  }
}

// A bank that reconstructs, the same at all levels: Haar's, padded.
MaskTable with_filters(MaskTable table) {
  const double h = 0.7071067811865476;
  FilterRow row;
  row.value = {{{h, h}, {-h, h}, {h, h}, {h, -h}}};
  for (std::size_t f = 0; f < 4; ++f)
    for (const double x : row.value[f]) row.text[f].push_back(shortest(x));
  table.filters.assign(table.levels.size() + 1, row);
  return table;
}

TEST(Writers, EveryOneIsDeterministicAndSaysWhatItIs) {
  for (const TableWriter* writer : table_writers()) {
    const std::string text = writer->write(with_filters(tension(0.5, 3)));
    if (writer->name() != "json") {
      for (const char* fact :
           {"Scheme: tension4", "Parameters: v0 = 0.5", "Rule: f^{k+1}_i", "Levels: row k is the step", "p = 0",
            "Index origin", "Normalisation: coefficients sum to 2", "Tail: for k >= 3"})
        EXPECT_NE(text.find(fact), std::string::npos) << writer->name() << ": " << fact;
    }
    for (const MaskTable& table : {with_filters(tension(0.5, 3)), with_filters(many_digits())}) {
      const std::string bytes = writer->write(table);
      EXPECT_EQ(bytes, writer->write(table)) << writer->name();
      EXPECT_NE(bytes.find("twoscale"), std::string::npos) << writer->name();
      EXPECT_NE(bytes.find("0BSD"), std::string::npos) << writer->name();
      EXPECT_NE(bytes.find("free for any use"), std::string::npos) << writer->name();
    }
    MaskTable broken = chaikin();
    broken.limit.text[0] = "1}; evil";
    EXPECT_THROW(writer->write(broken), Error) << writer->name();
  }
}

TEST(Json, HasTheKeysOfTheContract) {
  const Json doubles = Json::parse(write_table(tension(0.5, 3), "json"));
  EXPECT_EQ(doubles["format"], "twoscale/mask-table");
  EXPECT_EQ(doubles["version"], 1);
  EXPECT_EQ(doubles["scheme"], "tension4");
  EXPECT_EQ(doubles["arity"], 2);
  EXPECT_EQ(doubles["p"], "0");
  EXPECT_EQ(doubles["parameters"]["v0"], "0.5");
  EXPECT_EQ(doubles["level_variables"]["v"], "cosh(t/2^(k+1))");
  EXPECT_EQ(doubles["levels"].size(), 3u);
  EXPECT_EQ(doubles["tail"]["from"], 3);
  EXPECT_EQ(doubles["tail"]["bound"], "1");
  const MaskTable table = tension(0.5, 3);
  for (std::size_t k = 0; k < 3; ++k) {
    const Json& level = doubles["levels"][k];
    EXPECT_EQ(level["k"], k);
    EXPECT_EQ(level["lowest"], -3);
    for (std::size_t s = 0; s < 7; ++s) {
      EXPECT_EQ(parse_double(level["coefficients"][s].get<std::string>()), table.levels[k].value[s]);
      EXPECT_EQ(std::strtod(level["hex"][s].get<std::string>().c_str(), nullptr), table.levels[k].value[s]);
    }
  }
  const Json digits = Json::parse(write_table(many_digits(), "json"));
  EXPECT_EQ(digits["precision"]["digits"], 30);
  EXPECT_EQ(digits["precision"]["error"], "5e-31");
  EXPECT_FALSE(digits["limit"].contains("hex"));
  EXPECT_EQ(digits["limit"]["lowest"], -2);
  EXPECT_EQ(digits["limit"]["coefficients"][0], "0.333333333333333333333333333333");
  MaskTable odd = chaikin();
  odd.scheme = "\xff\xfe";
  EXPECT_NO_THROW(Json::parse(write_table(odd, "json")));
}

TEST(Csv, RowsAfterTheComments) {
  MaskTable table = chaikin();
  table.levels.push_back(table.limit);
  std::string body;
  const std::string csv = write_table(table, "csv");
  for (std::size_t at = 0; at < csv.size();) {
    const std::size_t end = csv.find('\n', at) + 1;
    if (csv[at] != '#') body += csv.substr(at, end - at);
    at = end;
  }
  EXPECT_EQ(
      body,
      "k,index,value\n0,-1,0.25\n0,0,0.75\n0,1,0.75\n0,2,0.25\nlimit,-1,0.25\nlimit,0,0.75\nlimit,1,0.75\nlimit,2,"
      "0.25\n");
}

TEST(Npy, RecordsHaveTheFixedLayout) {
  const std::string bytes = write_table(many_digits(), "npy");
  EXPECT_NE(bytes.find("[('level', '<i4'), ('lowest', '<i4'), ('coefficients', '<f8', (5,))]"), std::string::npos);
  EXPECT_NE(bytes.find("'shape': (3,)"), std::string::npos);
  const std::size_t header = 10 + static_cast<unsigned char>(bytes[8]) + 256u * static_cast<unsigned char>(bytes[9]);
  EXPECT_EQ(header % 64, 0u);
  EXPECT_EQ(bytes[header - 1], '\n');
  ASSERT_EQ(bytes.size(), header + 3 * 48);
  std::int32_t head[2];
  double first;
  std::memcpy(head, bytes.data() + header + 2 * 48, sizeof head);
  std::memcpy(&first, bytes.data() + header + 2 * 48 + 8, sizeof first);
  EXPECT_EQ(head[0], -1);
  EXPECT_EQ(head[1], -2);
  EXPECT_EQ(first, 1.0 / 3);
}

TEST(Identifier, ComesFromTheScheme) {
  EXPECT_EQ(identifier_of_scheme("interpolating:family=mixed,l=2"), "twoscale_interpolating_family_mixed_l_2");
  EXPECT_EQ(identifier_of_scheme("\"\""), "twoscale");
  const std::string a = identifier_of_scheme(std::string(200, 'a') + "b");
  const std::string b = identifier_of_scheme(std::string(200, 'a') + "c");
  EXPECT_NE(a, b);
  EXPECT_LT(a.size(), 80u);
}

// Generated sources are compiled with strict warnings and refine a polygon as the kernels do.

// Doubles whose sums run upwards whatever the weights, as those of the written functions do.
struct Upwards {
  double x = 0;
  friend Upwards operator+(Upwards a, Upwards b) { return {a.x + b.x}; }
  friend Upwards operator*(Upwards a, Upwards b) {
    volatile double product = a.x * b.x;
    return {product};
  }
};

std::vector<Upwards> upwards(const std::vector<double>& x) {
  std::vector<Upwards> out;
  for (const double number : x) out.push_back({number});
  return out;
}

std::string print_points(const std::vector<Upwards>& points) {
  std::string out;
  for (const Upwards x : points) out += hex_float(x.x) + "\n";
  return out;
}

const std::vector<double> polygon = {0, 0, 1, 0.1, 2, 1, 1, 3, 0, 2};

// Two closed steps (level 0, then one beyond the table: the limit), then the open step of level 0.
std::string expected_output(const MaskTable& table) {
  const auto mask = [&](const MaskRow& row) { return Mask<Upwards>{table.arity, row.lowest, upwards(row.value)}; };
  std::vector<Upwards> one(polygon.size() * static_cast<std::size_t>(table.arity));
  step_closed<Upwards>(mask(table.levels[0]), upwards(polygon), 2, one);
  std::vector<Upwards> two(one.size() * static_cast<std::size_t>(table.arity));
  step_closed<Upwards>(mask(table.limit), one, 2, two);
  const TableGrid grid = common_grid(table);
  const IndexRange range = computable(table.arity, grid.lowest, grid.highest, {0, 5});
  std::vector<Upwards> open(range.count * 2);
  step_open<Upwards>(mask(table.levels[0]), upwards(polygon), 0, 2, range.first, open);
  return print_points(two) + print_points(open);
}

void expect_output(const Directory& directory, const std::string& compile, const MaskTable& table) {
  ASSERT_EQ(std::system((compile + " > '" + (directory / "log") + "' 2>&1").c_str()), 0)
      << compile << "\n"
      << read_file(directory / "log");
  ASSERT_EQ(std::system(("'" + (directory / "run") + "' > '" + (directory / "out") + "'").c_str()), 0);
  std::vector<double> got, want;
  const auto numbers = [](const std::string& text, std::vector<double>& out) {
    for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1) {
      out.push_back(std::strtod(text.c_str() + at, nullptr));
    }
  };
  numbers(read_file(directory / "out"), got);
  numbers(expected_output(table), want);
  EXPECT_EQ(got, want);
}

std::vector<std::pair<MaskTable, TableOptions>> compiled_cases() {
  TableOptions hex;
  hex.hex_float = true;
  hex.prefix = "my_table";
  return {{tension(0.5, 3), {}}, {tension(-0.25, 2), hex}, {many_digits(), {}}};
}

TEST(C, CompilesWithoutWarningsAndRefines) {
  for (const auto& [table, options] : compiled_cases()) {
    const Directory directory;
    const std::string prefix = options.prefix.empty() ? identifier_of_scheme(table.scheme) : options.prefix;
    write_file(directory / "table.c", write_table(table, "c", options));
    std::string source = R"(#include "table.c"
#include "table.c"
#include <stdio.h>
int main(void)
{
    static const double in[] = {0, 0, 1, 0.1, 2, 1, 1, 3, 0, 2};
    double one[200], two[2000], open[400];
    size_t m = (size_t)@_coefficient_arity, i, count;
    @_apply(0, in, 5, 2, one);
    @_apply(1000, one, 5 * m, 2, two);
    for (i = 0; i < 5 * m * m * 2; ++i) printf("%a\n", two[i]);
    count = @_apply_open(0, in, 5, 2, NULL);
    if (@_apply_open(0, in, 5, 2, open) != count) return 1;
    for (i = 0; i < 2 * count; ++i) printf("%a\n", open[i]);
    return @_coefficient(0, 1000000) == 0.0 ? 0 : 2;
}
)";
    std::string upper = prefix;
    for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    source.replace(source.find("@_coefficient_arity"), 19, upper + "_ARITY");
    for (std::size_t at; (at = source.find('@')) != std::string::npos;) source.replace(at, 1, prefix);
    write_file(directory / "main.c", source);
    const std::string flags = " -std=c99 -O1 -ffp-contract=off -Wall -Wextra -Werror -pedantic -Wshadow -Wconversion ";
    EXPECT_EQ(std::system(("gcc -c" + flags + "'" + (directory / "table.c") + "' -o /dev/null").c_str()), 0);
    expect_output(directory, "gcc" + flags + "'" + (directory / "main.c") + "' -o '" + (directory / "run") + "'",
                  table);
  }
}

TEST(Cpp, CompilesWithoutWarningsAndRefines) {
  for (const auto& [table, options] : compiled_cases()) {
    const Directory directory;
    const std::string space = options.prefix.empty() ? identifier_of_scheme(table.scheme) : options.prefix;
    write_file(directory / "table.hpp", write_table(table, "cpp", options));
    std::string source = R"(#include "table.hpp"
#include <cstdio>
#include <vector>
static_assert(@::coefficient<double>(0, @::lowest - 1) == 0);
static_assert(@::mask.size() == @::levels + 1);
int main() {
  const std::vector<double> in = {0, 0, 1, 0.1, 2, 1, 1, 3, 0, 2};
  std::vector<double> one(in.size() * @::arity), two(one.size() * @::arity), open(2 * @::open_count(5));
  @::apply(0, in.data(), 5, 2, one.data());
  @::apply(1000, one.data(), 5 * @::arity, 2, two.data());
  @::apply_open(0, in.data(), 5, 2, open.data());
  for (double x : two) std::printf("%a\n", x);
  for (double x : open) std::printf("%a\n", x);
  const std::vector<float> narrow(in.begin(), in.end());
  const std::vector<long double> wide(in.begin(), in.end());
  std::vector<float> f(one.size());
  std::vector<long double> d(one.size());
  @::apply(0, narrow.data(), 5, 2, f.data());
  @::apply(0, wide.data(), 5, 2, d.data());
}
)";
    for (std::size_t at; (at = source.find('@')) != std::string::npos;) source.replace(at, 1, space);
    write_file(directory / "main.cpp", source);
    expect_output(directory,
                  "g++ -std=c++20 -O1 -ffp-contract=off -Wall -Wextra -Werror -pedantic -Wshadow -Wconversion '" +
                      (directory / "main.cpp") + "' -o '" + (directory / "run") + "'",
                  table);
  }
}

TEST(Filters, AreWrittenWhereTheyAre) {
  EXPECT_THROW(write_table(tension(0.5, 3), "pywavelets"), Error);
  const std::string text = write_table(with_filters(tension(0.5, 1)), "pywavelets");
  EXPECT_NE(text.find("[[0.7071067811865476, 0.7071067811865476],\n"), std::string::npos) << text;
  MaskTable broken = with_filters(tension(0.5, 3));
  broken.filters.pop_back();
  EXPECT_THROW(validate(broken), Error);
  broken = with_filters(tension(0.5, 3));
  broken.filters[1].value[2].push_back(0);
  EXPECT_THROW(validate(broken), Error);
}

// ---- The refinement matrix

std::vector<double> times(const RefinementMatrix& matrix, const std::vector<double>& in, std::size_t dim) {
  std::vector<double> out(matrix.sizes.size() * dim);
  for (std::size_t i = 0; i < matrix.sizes.size(); ++i)
    for (int e = matrix.offsets[i]; e < matrix.offsets[i] + matrix.sizes[i]; ++e)
      for (std::size_t c = 0; c < dim; ++c)
        out[i * dim + c] += matrix.weights[static_cast<std::size_t>(e)] *
                            in[static_cast<std::size_t>(matrix.indices[static_cast<std::size_t>(e)]) * dim + c];
  return out;
}

TEST(RefinementMatrix, RefinesAsTheKernelsDo) {
  for (const MaskTable& table : {tension(0.5, 1), tension(-0.25, 4), many_digits()}) {
    const RefinementMatrix matrix = refinement_matrix(table, 5);
    std::vector<double> want = polygon;
    double largest = 0;
    for (const MaskRow& row : table.levels) {
      std::vector<double> next(want.size() * static_cast<std::size_t>(table.arity));
      step_closed<double>(Mask<double>{table.arity, row.lowest, row.value}, want, 2, next);
      want = std::move(next);
    }
    for (const double x : polygon) largest = std::max(largest, std::abs(x));
    const std::vector<double> got = times(matrix, polygon, 2);
    ASSERT_EQ(got.size(), want.size());
    for (std::size_t i = 0; i < got.size(); ++i)
      EXPECT_NEAR(got[i], want[i], 2 * largest * std::strtod(matrix.error.c_str(), nullptr) + 1e-300);
  }
}

TEST(RefinementMatrix, HasTheWeightsOfTheTableAndRefusesWhatIsNone) {
  const RefinementMatrix matrix = refinement_matrix(tension(0.5, 1), 7);
  const MaskRow row = tension(0.5, 1).levels[0];
  EXPECT_EQ(matrix.sizes.size(), 14u);
  EXPECT_EQ((std::vector<int>(matrix.indices.begin() + 1, matrix.indices.begin() + 5)), (std::vector<int>{0, 1, 2, 6}));
  EXPECT_EQ(matrix.weights[1], row.value[4]);
  EXPECT_EQ(matrix.weights[4], row.value[6]);
  EXPECT_THROW(refinement_matrix(chaikin(), 7), Error);  // no level
  EXPECT_THROW(refinement_matrix(tension(0.5, 1), 2), Error);
  EXPECT_THROW(refinement_matrix(tension(0.5, 24), 100), Error);
}

TEST(Stencil, CompilesInCAndCppAndRefines) {
  const Directory directory;
  const MaskTable table = tension(0.5, 3);
  TableOptions options;
  options.points = 5;
  options.prefix = "s";
  write_file(directory / "stencil.h", write_table(table, "stencil", options));
  write_file(directory / "main.c", R"(#include "stencil.h"
#include "stencil.h"
#include <stdio.h>
int main(void)
{
    static const double in[] = {0, 0, 1, 0.1, 2, 1, 1, 3, 0, 2};
    static double out[2 * S_ROWS];
    size_t i;
    s_apply(in, 2, out);
    for (i = 0; i < 2 * S_ROWS; ++i) printf("%a\n", out[i]);
    return 0;
}
)");
  const std::string flags = " -O1 -ffp-contract=off -Wall -Wextra -Werror -pedantic -Wshadow '";
  for (const char* compiler : {"gcc -std=c99", "g++ -x c++ -std=c++20"}) {
    ASSERT_EQ(std::system((compiler + flags + (directory / "main.c") + "' -o '" + (directory / "run") + "' && '" +
                           (directory / "run") + "' > '" + (directory / "out") + "'")
                              .c_str()),
              0);
    EXPECT_EQ(read_file(directory / "out"), print_points(upwards(times(refinement_matrix(table, 5), polygon, 2))))
        << compiler;
  }
  options.prefix = "1x";
  EXPECT_THROW(write_table(table, "stencil", options), Error);
}

TEST(MatrixMarket, CountsFromOne) {
  TableOptions options;
  options.points = 3;
  std::string body;
  const std::string text = write_table(with_filters(tension(1, 1)), "matrixmarket", options);
  EXPECT_EQ(text.substr(0, text.find('\n')), "%%MatrixMarket matrix coordinate real general");
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at) + 1;
    if (text[at] != '%') body += text.substr(at, end - at);
    at = end;
  }
  // Three points: the outer two weights of the 4-point rule meet.
  EXPECT_EQ(body.substr(0, body.find("\n3 ")), "6 3 12\n1 1 1\n2 1 0.5625\n2 2 0.5625\n2 3 -0.125");
}

TEST(Latex, EscapesAndBalances) {
  const std::string text = write_table(many_digits(), "latex");
  EXPECT_NE(text.find("exponential-bspline:space={\\char34}1, x * / "), std::string::npos) << text;
  EXPECT_NE(text.find("$1 \\cdot 10^{-7}$"), std::string::npos) << text;
  EXPECT_EQ(std::count(text.begin(), text.end(), '{'), std::count(text.begin(), text.end(), '}'));
  MaskTable long_digits = many_digits();
  long_digits.limit.text[0] = "0." + std::string(60, '3');
  EXPECT_NE(write_table(long_digits, "latex").find("$0.33333333\\allowbreak 3333333333\\allowbreak"),
            std::string::npos);
}

TEST(Glsl, RoundsToFloats) {
  MaskTable table = tension(0.5, 2);
  const std::string text = write_table(table, "glsl");
  EXPECT_NE(text.find(shortest(table.levels[0].value[0]).substr(0, 5)), std::string::npos);
  EXPECT_EQ(text.find(shortest(table.levels[0].value[0])), std::string::npos);
  table.limit.value[0] = 1e300;
  table.limit.text[0] = "1e300";
  EXPECT_THROW(write_table(table, "glsl"), Error);
}

TEST(C, LiteralsRoundToTheDoublesAndKeepAllDigits) {
  const std::string c = write_table(many_digits(), "c");
  EXPECT_NE(c.find("0.3333333333333333, -1.0, 1e-07, 0.1"), std::string::npos) << c;
  EXPECT_NE(c.find("0.333333333333333333333333333333L, -1.0L, 1e-7L, 0.100000000000000000000000000001L"),
            std::string::npos);
  TableOptions bad;
  bad.prefix = "1x";
  EXPECT_THROW(write_table(chaikin(), "c", bad), Error);
}

}  // namespace
}  // namespace twoscale::kernels
