// SPDX-License-Identifier: 0BSD
// The frame of NumPy files, shared by points and tables; not installed.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "twoscale/kernels/points_io.hpp"

namespace twoscale::kernels::npy {

/// Magic, version 1.0 (2.0 for long headers) and the header dictionary, padded to a multiple of 64 bytes.
/// `descr` is a Python literal: "'<f8'" or a list of fields; `shape` a tuple: "(3, 2)". A comment follows the
/// dictionary after "# " (NumPy reads the header as a Python literal, so this is allowed); one line of ASCII.
std::string preamble(const std::string& descr, const std::string& shape, const std::string& comment = {});

/// The preamble of `count` points of `dim` doubles.
std::string head(std::size_t count, std::size_t dim);

/// Appends the bytes of `value`, least significant first.
template <class T>
void append(std::string& out, T value) {
  static_assert(sizeof(T) == 4 || sizeof(T) == 8);
  using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  const Bits bits = std::bit_cast<Bits>(value);
  for (std::size_t i = 0; i < sizeof(T); ++i) out += static_cast<char>((bits >> (8 * i)) & 0xff);
}

/// An array of numbers: 1 or 2 axes are points (shape (n)), 3 are a grid of them (shape (rows, columns)).
struct Array {
  PointSet points;
  std::vector<std::uint64_t> shape;
};

/// Throws Error (bad_input) as parse_npy does, for more than 3 axes.
Array read_array(std::string_view bytes, const std::string& name);

}  // namespace twoscale::kernels::npy
