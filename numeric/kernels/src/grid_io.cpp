// SPDX-License-Identifier: 0BSD
#include "twoscale/kernels/grid_io.hpp"

#include <algorithm>
#include <charconv>

#include "npy.hpp"
#include "obj.hpp"
#include "points_text.hpp"
#include "twoscale/kernels/write_file.hpp"

namespace twoscale::kernels {
namespace {

std::string size_text(GridSize size) { return std::to_string(size.rows) + "x" + std::to_string(size.columns); }

// ---- CSV

// "8x5", blanks around the x allowed.
std::optional<GridSize> parse_size(std::string_view text) {
  const std::size_t cross = text.find('x');
  if (cross == std::string_view::npos) return std::nullopt;
  const auto number = [](std::string_view digits) -> std::size_t {
    std::size_t n = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), n);
    return error == std::errc() && end == digits.data() + digits.size() ? n : 0;
  };
  const GridSize size{number(text::trimmed(text.substr(0, cross))), number(text::trimmed(text.substr(cross + 1)))};
  if (size.rows == 0 || size.columns == 0) return std::nullopt;
  return size;
}

// The size that a comment before the points states: `# grid 8x5`. Other comments are free text.
std::optional<GridSize> csv_grid_size(std::string_view bytes, const std::string& name) {
  text::Lines lines(bytes);
  std::string_view line;
  while (lines.next(line)) {
    line = text::trimmed(line);
    if (line.empty()) continue;
    if (line.front() != '#') break;
    line = text::trimmed(line.substr(1));
    if (!line.starts_with("grid ") && !line.starts_with("grid\t")) continue;
    const std::string_view rest = text::trimmed(line.substr(4));
    if (const auto size = parse_size(rest)) return size;
    if (rest.front() >= '0' && rest.front() <= '9') {
      text::fail_at(name, lines.number(), "a grid is announced as '# grid ROWSxCOLUMNS', not as " + quoted(rest));
    }
  }
  return std::nullopt;
}

PointFile parse_csv_file(std::string_view bytes, const std::string& name) {
  const auto size = csv_grid_size(bytes, name);
  PointSet points = parse_csv(bytes, name);
  if (!size) return points;
  if (points.size() / size->columns != size->rows || points.size() % size->columns != 0) {
    throw Error(Error::Kind::bad_input, name + ": a grid of " + size_text(*size) + " points is announced, but " +
                                            std::to_string(points.size()) + " points follow");
  }
  return PointGrid{std::move(points), *size, std::nullopt};
}

// ---- OBJ

// Whether the quad is cell (i, j) of the grid, and which one: number i*columns + j of its first corner.
std::optional<std::size_t> cell_of(const obj::Quad& quad, GridSize size, Closings closings) {
  const auto ahead = [](std::size_t from, std::size_t to, std::size_t n, bool closed) {
    return to == from + 1 || (closed && from + 1 == n && to == 0);
  };
  for (std::size_t first = 0; first < 4; ++first) {
    for (const std::size_t turn : {1U, 3U}) {  // either orientation
      const auto corner = [&](std::size_t c) { return quad.corners[(first + turn * c) % 4]; };
      const auto row = [&](std::size_t c) { return corner(c) / size.columns; };
      const auto column = [&](std::size_t c) { return corner(c) % size.columns; };
      const bool is_cell = row(0) == row(3) && row(1) == row(2) && column(0) == column(1) && column(2) == column(3) &&
                           ahead(row(0), row(1), size.rows, closings.u) &&
                           ahead(column(0), column(3), size.columns, closings.v);
      if (is_cell) return corner(0);
    }
  }
  return std::nullopt;
}

// The first quad that is no cell of the grid, or one that stands twice.
const obj::Quad* misfit(const std::vector<obj::Quad>& quads, GridSize size, Closings closings) {
  std::vector<bool> seen(size.rows * size.columns, false);
  for (const obj::Quad& quad : quads) {
    const auto cell = cell_of(quad, size, closings);
    if (!cell || seen[*cell]) return &quad;
    seen[*cell] = true;
  }
  return nullptr;
}

PointFile parse_obj_file(std::string_view bytes, const std::string& name) {
  obj::File file = obj::parse(bytes, name, true);
  if (file.quads.empty()) return parse_obj(bytes, name);
  if (file.polyline_line != 0) text::fail_at(name, file.polyline_line, "a polyline beside the faces of a grid");
  const std::size_t n = file.vertices.size();
  const obj::Quad* furthest = &file.quads.front();
  // As many cells as quads: (rows or rows-1) * (columns or columns-1); closed directions have at least 3 points.
  for (std::size_t columns = 2; columns <= n / 2; ++columns) {
    if (n % columns != 0) continue;
    const GridSize size{n / columns, columns};
    for (const Closings closings : {Closings{false, false}, {false, true}, {true, false}, {true, true}}) {
      if ((closings.u && size.rows < 3) || (closings.v && size.columns < 3)) continue;
      const std::size_t cells = (size.rows - (closings.u ? 0 : 1)) * (size.columns - (closings.v ? 0 : 1));
      if (cells != file.quads.size()) continue;
      const obj::Quad* quad = misfit(file.quads, size, closings);
      if (quad == nullptr) return PointGrid{std::move(file.vertices), size, closings};
      if (quad->line > furthest->line) furthest = quad;
    }
  }
  text::fail_at(name, furthest->line,
                "the " + std::to_string(file.quads.size()) + " faces between " + std::to_string(n) +
                    " points are not the quads of a grid with its points in row-major order");
}

// ---- out

void check_grid(const PointGrid& grid, const char* format, Closings closings) {
  text::check_points(grid.points, format);
  const auto fail = [&](const std::string& what) {
    throw Error(Error::Kind::bad_input, std::string("the grid cannot be written as ") + format + ": " + what);
  };
  const GridSize size = grid.size;
  if (size.columns == 0 || grid.points.size() / size.columns != size.rows || grid.points.size() % size.columns != 0) {
    fail(std::to_string(grid.points.size()) + " points are not " + size_text(size));
  }
  if ((closings.u && size.rows < 3) || (closings.v && size.columns < 3)) {
    fail("a closed direction has at least 3 points, the size is " + size_text(size));
  }
}

// Calls quad(a, b, c, d) for the cells in row-major order, corners (i, j), (i+1, j), (i+1, j+1), (i, j+1).
template <class F>
void for_each_quad(GridSize size, Closings closings, F quad) {
  const std::size_t rows = size.rows - (closings.u ? 0 : 1);
  const std::size_t columns = size.columns - (closings.v ? 0 : 1);
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      const std::size_t below = (i + 1) % size.rows * size.columns;
      const std::size_t right = (j + 1) % size.columns;
      quad(i * size.columns + j, below + j, below + right, i * size.columns + right);
    }
  }
}

std::string grid_to_obj(const PointGrid& grid, Closings closings) {
  check_grid(grid, "obj", closings);
  if (grid.points.dim > 3) {
    throw Error(Error::Kind::bad_input,
                "the grid cannot be written as obj: it has 3 columns, not " + std::to_string(grid.points.dim));
  }
  std::string out = "# grid of twoscale, " + size_text(grid.size) + " points row by row\n";
  text::append_vertices(out, grid.points);
  for_each_quad(grid.size, closings, [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    out += 'f';
    for (const std::size_t corner : {a, b, c, d}) out += ' ' + std::to_string(corner + 1);
    out += '\n';
  });
  return out;
}

std::string grid_to_ply(const PointGrid& grid, Closings closings) {
  check_grid(grid, "ply", closings);
  std::string faces;
  std::size_t count = 0;
  for_each_quad(grid.size, closings, [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    ++count;
    faces += '4';
    for (const std::size_t corner : {a, b, c, d}) faces += ' ' + std::to_string(corner);
    faces += '\n';
  });
  std::string out = "ply\nformat ascii 1.0\ncomment grid of twoscale, " + size_text(grid.size) + " points row by row\n";
  text::append_ply_vertices(out, grid.points,
                            "element face " + std::to_string(count) + "\nproperty list uchar int vertex_indices\n");
  return out + faces;
}

}  // namespace

PointFile parse_point_file(std::string_view bytes, PointFormat format, const std::string& name) {
  switch (format) {
    case PointFormat::csv: return parse_csv_file(bytes, name);
    case PointFormat::obj: return parse_obj_file(bytes, name);
    case PointFormat::npy: {
      npy::Array array = npy::read_array(bytes, name);
      if (array.shape.size() == 1) return std::move(array.points);
      return PointGrid{std::move(array.points), {array.shape[0], array.shape[1]}, std::nullopt};
    }
    default: throw Error(Error::Kind::bad_input, name + ": points are read from .csv, .npy and .obj");
  }
}

PointFile read_point_file(const std::string& path) {
  const PointFormat format = point_format(path);
  if (format == PointFormat::ply || format == PointFormat::svg) {
    throw Error(Error::Kind::bad_input, "points are read from .csv, .npy and .obj, not from " + quoted(path, 200));
  }
  return parse_point_file(read_file(path), format, path == "-" ? "standard input" : path);
}

std::string grid_to_bytes(const PointGrid& grid, PointFormat format, Closings closings) {
  switch (format) {
    case PointFormat::csv:
      check_grid(grid, "csv", closings);
      return "# grid " + size_text(grid.size) + "\n" + to_csv(grid.points);
    case PointFormat::npy: {
      check_grid(grid, "npy", closings);
      std::string out =
          npy::preamble("'<f8'", "(" + std::to_string(grid.size.rows) + ", " + std::to_string(grid.size.columns) +
                                     ", " + std::to_string(grid.points.dim) + ")");
      out.reserve(out.size() + 8 * grid.points.values.size());
      for (const double value : grid.points.values) npy::append(out, value);
      return out;
    }
    case PointFormat::obj: return grid_to_obj(grid, closings);
    case PointFormat::ply: return grid_to_ply(grid, closings);
    case PointFormat::svg: break;
  }
  throw Error(Error::Kind::bad_input,
              "a grid is not written as svg (csv, npy, obj and ply are; plot surface draws it)");
}

}  // namespace twoscale::kernels
