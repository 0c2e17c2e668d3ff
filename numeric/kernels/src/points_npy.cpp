// SPDX-License-Identifier: 0BSD
// Points as NumPy arrays (numpy.lib.format, versions 1.0 to 3.0).
#include <charconv>
#include <cmath>
#include <optional>

#include "npy.hpp"
#include "points_text.hpp"
#include "twoscale/kernels/number_text.hpp"

namespace twoscale::kernels {
namespace npy {

std::string preamble(const std::string& descr, const std::string& shape, const std::string& comment) {
  std::string dictionary = "{'descr': " + descr + ", 'fortran_order': False, 'shape': " + shape + ", }";
  if (!comment.empty()) dictionary += " # " + comment;
  const bool wide = dictionary.size() > 65000;
  const std::size_t fixed = wide ? 12 : 10;  // magic, version, length
  while ((fixed + dictionary.size() + 1) % 64 != 0) dictionary += ' ';
  dictionary += '\n';
  std::string out = "\x93NUMPY";
  out += wide ? '\x02' : '\x01';
  out += '\0';
  for (std::size_t i = 0; i < fixed - 8; ++i) out += static_cast<char>((dictionary.size() >> (8 * i)) & 0xff);
  return out + dictionary;
}

}  // namespace npy

namespace {

struct Header {
  std::string descr;
  bool fortran_order = false;
  std::vector<std::uint64_t> shape;
};

// The Python literal {'descr': '<f8', 'fortran_order': False, 'shape': (3, 2), }.
class HeaderParser {
 public:
  explicit HeaderParser(std::string_view text) : rest_(text) {}

  std::optional<Header> parse() {
    Header header;
    bool seen[3] = {false, false, false};
    if (!take('{')) return std::nullopt;
    while (!take('}')) {
      const auto key = string();
      if (!key || !take(':')) return std::nullopt;
      if (*key == "descr" && !seen[0]) {
        const auto value = string();
        if (!value) return std::nullopt;
        header.descr = *value;
        seen[0] = true;
      } else if (*key == "fortran_order" && !seen[1]) {
        if (word("True"))
          header.fortran_order = true;
        else if (!word("False"))
          return std::nullopt;
        seen[1] = true;
      } else if (*key == "shape" && !seen[2]) {
        if (!tuple(header.shape)) return std::nullopt;
        seen[2] = true;
      } else {
        return std::nullopt;
      }
      if (!take(',')) {
        if (!take('}')) return std::nullopt;
        break;
      }
    }
    skip();
    if (!rest_.empty() && rest_.front() == '#') rest_ = {};
    if (!rest_.empty() || !seen[0] || !seen[1] || !seen[2]) return std::nullopt;
    return header;
  }

 private:
  void skip() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\n\r"), rest_.size())); }

  bool take(char c) {
    skip();
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }

  bool word(std::string_view w) {
    skip();
    if (rest_.substr(0, w.size()) != w) return false;
    rest_.remove_prefix(w.size());
    return true;
  }

  std::optional<std::string> string() {
    skip();
    if (rest_.empty() || (rest_.front() != '\'' && rest_.front() != '"')) return std::nullopt;
    const std::size_t end = rest_.find(rest_.front(), 1);
    if (end == std::string_view::npos) return std::nullopt;
    std::string out(rest_.substr(1, end - 1));
    rest_.remove_prefix(end + 1);
    return out;
  }

  bool tuple(std::vector<std::uint64_t>& shape) {
    if (!take('(')) return false;
    while (!take(')')) {
      skip();
      std::uint64_t value = 0;
      const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
      if (error != std::errc() || shape.size() == 8) return false;
      rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
      shape.push_back(value);
      if (!take(',')) return take(')');
    }
    return true;
  }

  std::string_view rest_;
};

struct Number {
  double value = 0;
  std::string token;
};

// One element; `kind` is 'f', 'i' or 'u'.
Number element(std::string_view bytes, char kind, bool big_endian) {
  std::uint64_t bits = 0;
  const std::size_t size = bytes.size();
  for (std::size_t i = 0; i < size; ++i) {
    const auto byte = static_cast<unsigned char>(bytes[big_endian ? i : size - 1 - i]);
    bits = (bits << 8) | byte;
  }
  if (kind == 'f') {
    const double value = size == 8 ? std::bit_cast<double>(bits)
                                   : static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    return {value, shortest(value)};
  }
  if (kind == 'u') return {static_cast<double>(bits), std::to_string(bits)};
  const unsigned unused = static_cast<unsigned>(64 - 8 * size);
  const std::int64_t value = std::bit_cast<std::int64_t>(bits << unused) >> unused;
  return {static_cast<double>(value), std::to_string(value)};
}

}  // namespace

namespace npy {

Array read_array(std::string_view bytes, const std::string& name) {
  const auto fail = [&](const std::string& message) { throw Error(Error::Kind::bad_input, name + ": " + message); };
  const auto byte = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(bytes[i])); };
  if (bytes.substr(0, 6) != "\x93NUMPY") fail("not a NumPy file, it begins " + quoted(bytes.substr(0, 6)));
  if (bytes.size() < 10) fail("the NumPy header is cut off");
  const std::size_t major = byte(6);
  if (major < 1 || major > 3 || byte(7) != 0) {
    fail("NumPy format " + std::to_string(major) + "." + std::to_string(byte(7)) + " is not known");
  }
  const std::size_t begin = major == 1 ? 10 : 12;
  if (bytes.size() < begin) fail("the NumPy header is cut off");
  std::size_t length = byte(8) | (byte(9) << 8);
  if (major > 1) length |= (byte(10) << 16) | (byte(11) << 24);
  if (length > bytes.size() - begin) fail("the NumPy header is cut off");
  const std::string_view text = bytes.substr(begin, length);
  const auto header = HeaderParser(text).parse();
  if (!header) {
    fail("NumPy header not understood (one array of numbers is expected): " + quoted(text, 120));
  }
  const std::string& descr = header->descr;
  const bool known =
      descr == "|i1" || descr == "|u1" || descr == "<i1" || descr == "<u1" ||
      (descr.size() == 3 && (descr[0] == '<' || descr[0] == '>') &&
       ((descr[1] == 'f' && (descr[2] == '4' || descr[2] == '8')) ||
        ((descr[1] == 'i' || descr[1] == 'u') && (descr[2] == '2' || descr[2] == '4' || descr[2] == '8'))));
  if (!known) fail("elements of type " + quoted(descr) + " are not read (float32, float64 and integers are)");
  const std::size_t axes = header->shape.size();
  if (axes == 0 || axes > 3) {
    fail("an array with 1 or 2 axes (3 for a grid) is expected, not " + std::to_string(axes));
  }
  Array array;
  std::uint64_t rows = 1;  // points
  const std::uint64_t dim = axes == 1 ? 1 : header->shape.back();
  const std::size_t size = static_cast<std::size_t>(descr[2] - '0');
  const std::string_view data = bytes.substr(begin + length);
  const std::uint64_t most = data.size() / size;  // numbers that are there
  for (std::size_t axis = 0; axis < (axes == 1 ? 1 : axes - 1); ++axis) {
    const std::uint64_t n = header->shape[axis];
    if (n == 0 || dim == 0) fail("the array has no points");
    rows = n > most || rows > most / n ? most + 1 : rows * n;
    array.shape.push_back(n);
  }
  if (dim > most || rows != most / dim || rows * dim * size != data.size()) {
    std::string announced;
    for (const std::uint64_t n : header->shape) announced += (announced.empty() ? "" : " x ") + std::to_string(n);
    fail("an array of " + announced + " numbers of " + std::to_string(size) + " bytes is announced, but " +
         std::to_string(data.size()) + " bytes follow");
  }
  PointSet& points = array.points;
  points.dim = dim;
  points.columns = default_columns(points.dim);
  points.values.reserve(rows * dim);
  points.tokens.reserve(rows * dim);
  const std::uint64_t columns = axes == 3 ? array.shape[1] : 1;
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t c = 0; c < dim; ++c) {
      // Fortran order: the first axis runs fastest.
      const std::size_t fortran = (c * columns + j % columns) * (rows / columns) + j / columns;
      const std::size_t at = header->fortran_order ? fortran : j * dim + c;
      Number number = element(data.substr(at * size, size), descr[1], descr[0] == '>');
      if (!std::isfinite(number.value)) fail("row " + std::to_string(j) + ": not a number: " + quoted(number.token));
      points.values.push_back(number.value);
      points.tokens.push_back(std::move(number.token));
    }
  }
  return array;
}

}  // namespace npy

PointSet parse_npy(std::string_view bytes, const std::string& name) {
  npy::Array array = npy::read_array(bytes, name);
  if (array.shape.size() != 1) {
    throw Error(Error::Kind::bad_input, name + ": an array with 1 or 2 axes is expected, not 3 (a grid)");
  }
  return std::move(array.points);
}

namespace npy {

std::string head(std::size_t count, std::size_t dim) {
  return preamble("'<f8'", std::string("(") + std::to_string(count) + ", " + std::to_string(dim) + ")");
}

}  // namespace npy

std::string to_npy(const PointSet& points) {
  text::check_points(points, "npy");
  std::string out = npy::head(points.size(), points.dim);
  out.reserve(out.size() + 8 * points.values.size());
  for (const double value : points.values) npy::append(out, value);
  return out;
}

}  // namespace twoscale::kernels
