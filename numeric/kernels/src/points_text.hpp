// SPDX-License-Identifier: 0BSD
// Shared by the readers and writers of points files; not installed.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "twoscale/kernels/error.hpp"
#include "twoscale/kernels/points_io.hpp"

namespace twoscale::kernels::text {

/// The lines of a text, numbered from 1, without LF or CRLF.
class Lines {
 public:
  explicit Lines(std::string_view bytes) : rest_(bytes) {
    if (rest_.substr(0, 3) == "\xEF\xBB\xBF") rest_.remove_prefix(3);
  }
  bool next(std::string_view& line);
  std::size_t number() const { return number_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

/// Without blanks and tabs at either end.
std::string_view trimmed(std::string_view text);

/// The pieces between commas, trimmed; between runs of blanks and tabs.
std::vector<std::string_view> split_commas(std::string_view text);
std::vector<std::string_view> split_blanks(std::string_view text);

[[noreturn]] void fail_at(const std::string& name, std::size_t line, const std::string& message);

/// Appends one number to `points` (value and token); throws at name:line when `text` is no decimal that fits a double.
void append_number(PointSet& points, std::string_view text, const std::string& name, std::size_t line);

/// Number `index` of a set as it is printed: its token, else the shortest round trip.
std::string printed(const PointSet& points, std::size_t index);

/// Throws Error unless the sizes agree, the values are finite, the tokens decimals and there is a point.
void check_points(const PointSet& points, const char* format);

/// The `v` lines of an OBJ file, z = 0 (y = 0) where a set has fewer columns.
void append_vertices(std::string& out, const PointSet& points);

/// The rest of the header of a PLY file and its vertices: the columns and, where they miss, x, y, z = 0 as doubles.
/// `other_elements`: header lines of the elements that follow.
void append_ply_vertices(std::string& out, const PointSet& points, const std::string& other_elements);

/// The columns that x, y, z are drawn from: those of these names, else the first ones (at most `most`).
std::vector<std::size_t> position_columns(const PointSet& points, std::size_t most);

}  // namespace twoscale::kernels::text
